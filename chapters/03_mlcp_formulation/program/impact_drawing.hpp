/// \file impact_drawing.hpp
/// The pictures beside a disc that hits something: the plane of its velocities, and what each set of cases
/// leads to.
#pragma once

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "common/canvas.hpp"
#include "common/elementary.hpp"
#include "common/text.hpp"

#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// All that one step knew.
struct ImpactMoment {
    VecX u_before, u_star, u;
    std::vector<Row<2>> rows;
    Mlcp mlcp;
    Solution solution;
    Real t = 0;
};

namespace impact_picture {

inline constexpr Style ink = {Colour::ink, 1.5, 1};
inline const Vec2 scene_corner = {-1, -0.1}, scene_size = {2, 1.6};
inline const Vec2 plane_middle = {2.1, 0.7};
inline constexpr Real plane_half = 0.8;

/// A polygon's part in the half-plane normal·p ≥ offset.
inline std::vector<Vec2> clipped_by(const std::vector<Vec2>& corners,
                                    const Vec2& normal, Real offset)
{
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const Real at_a = normal.dot(a) - offset, at_b = normal.dot(b) - offset;
        if (at_a >= 0) result.push_back(a);
        if ((at_a < 0) != (at_b < 0))
            result.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    return result;
}

/// A polygon's part within a box of the picture.
inline std::vector<Vec2> clipped(std::vector<Vec2> corners, const Vec2& low,
                                 const Vec2& size)
{
    const Vec2 high = low + size;
    corners = clipped_by(corners, {1, 0}, low.x());
    corners = clipped_by(corners, {-1, 0}, -high.x());
    corners = clipped_by(corners, {0, 1}, low.y());
    return clipped_by(corners, {0, -1}, -high.y());
}

inline void circle(Canvas& canvas, const Vec2& centre, Real radius, bool strong)
{
    const Style style = {strong ? Colour::red : Colour::faint, 1,
                         strong ? 0.8 : 0.9, Paint::dashed};
    std::vector<Vec2> piece;
    for (int i = 0; i <= 120; ++i) {
        const Real angle = 2 * pi * i / 120;
        const Vec2 p = centre + radius * Vec2(cos(angle), sin(angle));
        if ((p - plane_middle).cwiseAbs().maxCoeff() <= plane_half)
            piece.push_back(p);
        else if (piece.size() > 1) canvas.polyline(std::exchange(piece, {}), style);
        else piece.clear();
    }
    if (piece.size() > 1) canvas.polyline(piece, style);
}

/// The plane of velocities: what the rows allow, u*, the circles of equal change around it, and u.
inline void draw_velocities(Canvas& canvas, const ImpactMoment& shown)
{
    const Vec2 u_star = shown.u_star, u = shown.u;
    Real unit = 0.05;  // m/s from a line of the grid to the next
    while (3.2 * unit < std::max(u_star.norm(), u.norm())) unit *= 2;
    const Real scale = plane_half / (4 * unit);
    const auto at = [&](const Vec2& velocity) -> Vec2 {
        return plane_middle + scale * velocity;
    };
    const Vec2 corner = plane_middle - Vec2::Constant(plane_half);

    std::vector<Vec2> allowed = {corner, corner + Vec2(2 * plane_half, 0),
                                 plane_middle + Vec2::Constant(plane_half),
                                 corner + Vec2(0, 2 * plane_half)};
    for (const Row<2>& row : shown.rows) {  // J u + b ≥ 0
        const Vec2 normal = row.Jb.transpose();
        allowed = clipped_by(allowed, normal,
                             normal.dot(plane_middle) - scale * row.bias);
    }
    if (allowed.size() > 2)
        canvas.polygon(allowed, {Colour::blue, 1.5, 0.13, Paint::filled});
    canvas.box(plane_middle, Vec2::Constant(plane_half), 0, {Colour::faint, 1, 1});
    canvas.segment(plane_middle - Vec2(plane_half, 0),
                   plane_middle + Vec2(plane_half, 0), {Colour::faint, 1});
    canvas.segment(plane_middle - Vec2(0, plane_half),
                   plane_middle + Vec2(0, plane_half), {Colour::faint, 1});
    canvas.text(plane_middle + Vec2(plane_half - 0.03, -0.07), "u_x", 13, ink,
                Align::right);
    canvas.text(plane_middle + Vec2(0.03, plane_half - 0.09), "u_y", 13, ink);

    const Real change = (u - u_star).norm();
    for (const Real part : {0.5, 1.0, 1.5})
        circle(canvas, at(u_star), scale * change * part, part == 1);
    canvas.arrow(plane_middle, at(u_star), {Colour::orange, 2, 1});
    canvas.arrow(plane_middle, at(u), {Colour::blue, 2.5, 1});
    if (change > 0) canvas.arrow(at(u_star), at(u), {Colour::red, 2.5, 1});
    const Vec2 beside(u_star.x() >= 0 ? 0.04 : -0.04, -0.07);
    canvas.text(at(u_star) + beside, "u*", 15, {Colour::orange, 1.5, 1},
                u_star.x() >= 0 ? Align::left : Align::right);
    canvas.text(at(u) + Vec2(u.x() >= 0 ? 0.04 : -0.04, 0.04), "u", 15,
                {Colour::blue, 1.5, 1}, u.x() >= 0 ? Align::left : Align::right);
    canvas.text(corner + Vec2(0, 2 * plane_half + 0.05),
                "velocities at t = " + fixed(shown.t, 3) + " s", 14, ink);
    canvas.text(corner + Vec2(2 * plane_half, 2 * plane_half + 0.05), "allowed", 14,
                {Colour::blue, 1.5, 1}, Align::right);
    canvas.text(corner + Vec2(plane_half, -0.1),
                "from the middle to the edge " + readable(4 * unit) + " m/s", 12,
                ink, Align::centre);
}

/// The λ of one set of at most two contacts, by hand.
inline void solve_set(const Mlcp& mlcp, int set, Index n, VecX& lambda)
{
    const SparseMatrix& A = mlcp.A;
    const VecX& q = mlcp.q;
    if (set == 3 && n == 2) {
        const Real determinant =
            A.coeff(0, 0) * A.coeff(1, 1) - A.coeff(0, 1) * A.coeff(1, 0);
        lambda[0] = (-q[0] * A.coeff(1, 1) + q[1] * A.coeff(0, 1)) / determinant;
        lambda[1] = (-q[1] * A.coeff(0, 0) + q[0] * A.coeff(1, 0)) / determinant;
        return;
    }
    for (Index i = 0; i < n; ++i)
        if (set >> i & 1) lambda[i] = -q[i] / A.coeff(i, i);
}

/// Each set of cases, its result, and why it fails.
inline void draw_sets(Canvas& canvas, const ImpactMoment& shown)
{
    const Index n = std::min<Index>(shown.mlcp.size(), 2);
    Vec2 line = {-1, -0.28};
    canvas.text(line, "either / or", 14, ink);
    canvas.text(line + Vec2(0.75, 0), n == 1 ? "λ [N s]" : "λ₁, λ₂ [N s]", 14, ink);
    canvas.text(line + Vec2(1.55, 0), n == 1 ? "w [m/s]" : "w₁, w₂ [m/s]", 14, ink);
    for (int set = 0; set < (1 << n); ++set) {
        VecX lambda = VecX::Zero(shown.mlcp.size());
        solve_set(shown.mlcp, set, n, lambda);
        const VecX w = shown.mlcp.A * lambda + shown.mlcp.q;
        std::string name, lambdas, ws;
        bool pulls = false, enters = false;
        for (Index i = 0; i < n; ++i) {
            const std::string separator = i ? ", " : "";
            name += separator + ((set >> i & 1) ? "w" : "λ") +
                    (n == 1   ? ""
                     : i == 0 ? "₁"
                              : "₂") +
                    " = 0";
            lambdas += separator + fixed(lambda[i], 3);
            ws += separator + fixed((set >> i & 1) ? 0 : w[i], 3);
            pulls = pulls || lambda[i] < -1e-12;
            enters = enters || (!(set >> i & 1) && w[i] < -1e-12);
        }
        const bool fits = !pulls && !enters;
        const Style style = {fits ? Colour::green : Colour::ink, 1.5, 1};
        line.y() -= 0.11;
        canvas.text(line, name, 14, style);
        canvas.text(line + Vec2(0.75, 0), lambdas, 14, style);
        canvas.text(line + Vec2(1.55, 0), ws, 14, style);
        canvas.text(line + Vec2(2.4, 0),
                    fits              ? "fits"
                    : pulls && enters ? "pulls and enters"
                    : pulls           ? "pulls: λ < 0"
                                      : "enters: w < 0",
                    14, style);
    }
}

}  // namespace impact_picture

}  // namespace rigid
