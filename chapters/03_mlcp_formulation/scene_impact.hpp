/// \file scene_impact.hpp
/// One disc at the moment of contact: beside the scene all velocities that its rows allow, and the one among
/// them that changes the momentum least.
#pragma once

#include "chapters/03_mlcp_formulation/disc_step.hpp"
#include "chapters/03_mlcp_formulation/exact.hpp"
#include "common/measure.hpp"
#include "common/program/program.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace rigid {

class ImpactRun : public Run {
public:
    /// \param walls  what the disc of 0.1 m radius may hit
    ImpactRun(const Settings& settings, std::vector<HalfSpace> walls, const Vec2& x, const Vec2& u)
    {
        scene_.bodies = Bodies<2>(1);
        scene_.bodies.x = x;
        scene_.bodies.u = u;
        scene_.bodies.inverse_mass.setConstant(1 / settings["mass"]);
        scene_.radius = VecX::Constant(1, 0.1);
        scene_.walls = std::move(walls);
        require_valid(scene_);
    }

    //! [step]
    void step(const Settings& settings, const Input& input) override
    {
        Bodies<2>& disc = scene_.bodies;
        const Real h = settings.h;
        disc.f.setZero();
        add_gravity(disc, scene_.gravity);
        if (input.pressed) add_pull(disc, 0, input.pointer);
        now_.u_before = disc.u;
        now_.u_star = disc.u + h * disc.inverse_mass.cwiseProduct(disc.f);

        find_contacts(disc.x, scene_.radius, scene_.walls, scene_.linked, 0.1, contacts_);
        now_.rows.clear();
        for (const Contact& contact : contacts_) {
            Row<2> row = unilateral(contact_constraint(contact), disc.inverse_mass, contact.gap / h);
            const Real before = row.velocity(disc.u) - row.bias;  // J u: the speed at which the gap opens
            const bool hits = row.velocity(now_.u_star) < 0 && before < -10 * h * scene_.gravity.norm();
            if (hits) row.bias = settings["e"] * before;  // (3.31): leave with e times that speed
            now_.rows.push_back(row);
        }
        assemble(now_.rows, now_.u_star, scratch_, now_.mlcp);
        now_.solution = enumerate(now_.mlcp);
        if (now_.solution.status != Status::solved)
            throw StepFailure("the disc finds no velocity that its contacts allow (" +
                              std::string(to_string(now_.solution.status)) + ")");
        disc.u = now_.u_star;
        apply(now_.rows, now_.solution.lambda, disc.u);
        disc.x += h * disc.u;
        //! [step]
        now_.u = disc.u;
        now_.t = (t_ += h);
        const bool hit = (now_.u_before - now_.u).norm() > 20 * h * scene_.gravity.norm();
        if (hit || shown_.rows.empty() || t_ > shown_.t + 0.5 || shown_.mlcp.size() == 0) shown_ = now_;
    }

    std::vector<Real> measure() const override
    {
        Real pushes = 0, opens = 0, both = 0;
        for (Index i = 0; i < now_.mlcp.size(); ++i) {
            const Real lambda = now_.solution.lambda[i],
                       w = now_.rows[static_cast<std::size_t>(i)].velocity(now_.u);
            pushes = std::max(pushes, lambda);
            opens = i == 0 ? w : std::min(opens, w);
            both = std::max(both, std::abs(std::min(lambda, w)));
        }
        return {static_cast<Real>(now_.mlcp.size()),
                pushes,
                opens,
                both,
                now_.mlcp.size() ? now_.solution.residual : 0,
                deepest_penetration(scene_),
                kinetic_energy(scene_.bodies) + potential_energy(scene_.bodies, scene_.gravity)};
    }

    void draw(Canvas& canvas) const override
    {
        for (const HalfSpace& wall : scene_.walls) {
            const Vec2 along = 3 * perpendicular(wall.normal), middle = wall.normal * wall.offset;
            const std::vector<Vec2> line =
                clipped({middle - along, middle + along, middle + along - 3 * wall.normal,
                         middle - along - 3 * wall.normal},
                        scene_corner, scene_size);
            if (line.size() > 2) canvas.polygon(line, {Colour::ink, 1, 0.25, true, false});
        }
        const Vec2 x = scene_.bodies.position(0);
        canvas.disc(x, scene_.radius[0], {Colour::blue, 1.5, 0.35, true, false});
        for (const Contact& contact : contacts_)
            if (contact.gap < 0.02) {
                const Vec2 touch = x - contact.normal * (scene_.radius[0] + contact.gap);
                canvas.arrow(touch, touch + 0.15 * contact.normal, {Colour::green, 2, 1, false, false});
            }
        if (now_.u.size()) canvas.arrow(x, x + 0.15 * now_.u.head<2>(), {Colour::blue, 2, 1, false, false});
        if (!shown_.rows.empty()) {
            draw_velocities(canvas);
            draw_sets(canvas);
        } else {
            canvas.text(plane_middle + Vec2(0, 0), "no contact near: u = u*", 14, ink, Align::centre);
        }
    }

private:
    /// All that one step knew.
    struct Moment {
        VecX u_before, u_star, u;
        std::vector<Row<2>> rows;
        Mlcp mlcp;
        Solution solution;
        Real t = 0;
    };

    static constexpr Style ink = {Colour::ink, 1.5, 1, false, false};
    inline static const Vec2 scene_corner = {-1, -0.1}, scene_size = {2, 1.6};
    inline static const Vec2 plane_middle = {2.1, 0.7};
    static constexpr Real plane_half = 0.8;

    /// A polygon's part within a box of the picture.
    static std::vector<Vec2> clipped(std::vector<Vec2> corners, const Vec2& low, const Vec2& size)
    {
        const Vec2 high = low + size;
        corners = clipped_by(corners, {1, 0}, low.x());
        corners = clipped_by(corners, {-1, 0}, -high.x());
        corners = clipped_by(corners, {0, 1}, low.y());
        return clipped_by(corners, {0, -1}, -high.y());
    }

    /// A polygon's part in the half-plane normal·p ≥ offset.
    static std::vector<Vec2> clipped_by(const std::vector<Vec2>& corners, const Vec2& normal, Real offset)
    {
        std::vector<Vec2> result;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
            const Real at_a = normal.dot(a) - offset, at_b = normal.dot(b) - offset;
            if (at_a >= 0) result.push_back(a);
            if ((at_a < 0) != (at_b < 0)) result.push_back(a + (b - a) * (at_a / (at_a - at_b)));
        }
        return result;
    }

    /// The plane of velocities: what the rows allow, u*, the circles of equal change around it, and u.
    void draw_velocities(Canvas& canvas) const
    {
        const Vec2 u_star = shown_.u_star, u = shown_.u;
        Real unit = 0.05;  // m/s from a line of the grid to the next
        while (3.2 * unit < std::max(u_star.norm(), u.norm())) unit *= 2;
        const Real scale = plane_half / (4 * unit);
        const auto at = [&](const Vec2& velocity) -> Vec2 { return plane_middle + scale * velocity; };
        const Vec2 corner = plane_middle - Vec2::Constant(plane_half);

        std::vector<Vec2> allowed = {corner, corner + Vec2(2 * plane_half, 0),
                                     plane_middle + Vec2::Constant(plane_half),
                                     corner + Vec2(0, 2 * plane_half)};
        for (const Row<2>& row : shown_.rows) {  // J u + b ≥ 0
            const Vec2 normal = row.Jb.transpose();
            allowed = clipped_by(allowed, normal, normal.dot(plane_middle) - scale * row.bias);
        }
        if (allowed.size() > 2) canvas.polygon(allowed, {Colour::blue, 1.5, 0.13, true, false});
        canvas.box(plane_middle, Vec2::Constant(plane_half), 0, {Colour::faint, 1, 1, false, false});
        canvas.segment(plane_middle - Vec2(plane_half, 0), plane_middle + Vec2(plane_half, 0),
                       {Colour::faint, 1});
        canvas.segment(plane_middle - Vec2(0, plane_half), plane_middle + Vec2(0, plane_half),
                       {Colour::faint, 1});

        const Real change = (u - u_star).norm();
        for (const Real part : {0.5, 1.0, 1.5}) circle(canvas, at(u_star), scale * change * part, part == 1);
        canvas.arrow(plane_middle, at(u_star), {Colour::orange, 2, 1, false, false});
        canvas.arrow(plane_middle, at(u), {Colour::blue, 2.5, 1, false, false});
        if (change > 0) canvas.arrow(at(u_star), at(u), {Colour::red, 2.5, 1, false, false});
        const Vec2 beside(u_star.x() >= 0 ? 0.04 : -0.04, -0.07);
        canvas.text(at(u_star) + beside, "u*", 15, {Colour::orange, 1.5, 1},
                    u_star.x() >= 0 ? Align::left : Align::right);
        canvas.text(at(u) + Vec2(u.x() >= 0 ? 0.04 : -0.04, 0.04), "u", 15, {Colour::blue, 1.5, 1},
                    u.x() >= 0 ? Align::left : Align::right);
        canvas.text(corner + Vec2(0, 2 * plane_half + 0.05), "velocities at t = " + fixed(shown_.t, 3) + " s",
                    14, ink);
        canvas.text(corner + Vec2(2 * plane_half, 2 * plane_half + 0.05), "allowed", 14,
                    {Colour::blue, 1.5, 1}, Align::right);
        canvas.text(corner + Vec2(plane_half, -0.1),
                    "from the middle to the edge " + readable(4 * unit) + " m/s", 12, ink, Align::centre);
    }

    static void circle(Canvas& canvas, const Vec2& centre, Real radius, bool strong)
    {
        const Style style = {strong ? Colour::red : Colour::faint, 1, strong ? 0.8 : 0.9, false, true};
        std::vector<Vec2> piece;
        for (int i = 0; i <= 120; ++i) {
            const Real angle = 2 * pi * i / 120;
            const Vec2 p = centre + radius * Vec2(std::cos(angle), std::sin(angle));
            if ((p - plane_middle).cwiseAbs().maxCoeff() <= plane_half) piece.push_back(p);
            else if (piece.size() > 1) canvas.polyline(std::exchange(piece, {}), style);
            else piece.clear();
        }
        if (piece.size() > 1) canvas.polyline(piece, style);
    }

    /// Each set of cases, what it leads to, and what speaks against it.
    void draw_sets(Canvas& canvas) const
    {
        const Index n = std::min<Index>(shown_.mlcp.size(), 2);
        Vec2 line = {-1, -0.28};
        canvas.text(line, "either / or", 14, ink);
        canvas.text(line + Vec2(0.75, 0), n == 1 ? "λ [N s]" : "λ₁, λ₂ [N s]", 14, ink);
        canvas.text(line + Vec2(1.55, 0), n == 1 ? "w [m/s]" : "w₁, w₂ [m/s]", 14, ink);
        for (int set = 0; set < (1 << n); ++set) {
            VecX lambda = VecX::Zero(shown_.mlcp.size());
            solve_set(set, n, lambda);
            const VecX w = shown_.mlcp.A * lambda + shown_.mlcp.q;
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
            const Style style = {fits ? Colour::green : Colour::ink, 1.5, 1, false, false};
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

    /// The λ of one set of at most two contacts, by hand.
    void solve_set(int set, Index n, VecX& lambda) const
    {
        const SparseMatrix& A = shown_.mlcp.A;
        const VecX& q = shown_.mlcp.q;
        if (set == 3 && n == 2) {
            const Real determinant = A.coeff(0, 0) * A.coeff(1, 1) - A.coeff(0, 1) * A.coeff(1, 0);
            lambda[0] = (-q[0] * A.coeff(1, 1) + q[1] * A.coeff(0, 1)) / determinant;
            lambda[1] = (-q[1] * A.coeff(0, 0) + q[0] * A.coeff(1, 0)) / determinant;
            return;
        }
        for (Index i = 0; i < n; ++i)
            if (set >> i & 1) lambda[i] = -q[i] / A.coeff(i, i);
    }

    DiscScene scene_;
    std::vector<Contact> contacts_;
    AssemblyScratch scratch_;
    Moment now_, shown_;
    Real t_ = 0;
};

/// What both scenes of one disc have in common.
inline Scene impact_scene(const std::string& name, const std::string& summary)
{
    Scene scene;
    scene.name = name;
    scene.summary = summary;
    scene.view = {{0.95, 0.33}, {2.1, 1.3}};
    scene.h = 1.0 / 60;
    scene.h_low = 1e-3;
    scene.h_high = 1.0 / 20;
    scene.tunables = {
        {"e", "", "restitution: leave with e times the speed of approach", 0.6, 0, 1, false, false, true},
        {"mass", "kg", "mass of the disc", 1, 0.1, 100, false, true, false}};
    scene.columns = {{"contacts", "", "rows of the step", false, false},
                     {"lambda", "N s", "largest impulse", true, false},
                     {"w", "m/s", "smallest J u + b", true, false},
                     {"both", "", "largest |min(λ, w)| of a row: zero if it is either/or", false, false},
                     {"residual", "m/s", "natural residual", true, true},
                     {"penetration", "m", "deepest overlap", false, false},
                     {"energy", "J", "kinetic energy and that of the weight", true, false}};
    return scene;
}

/// A disc that bounces on a floor, between far walls.
inline Scene bounce_scene()
{
    Scene scene = impact_scene("bounce", "A disc bounces; beside it all velocities that its contact allows");
    scene.view = {{0.95, 0.48}, {2.1, 1.1}};
    scene.tunables.push_back({"tilt", "degrees", "of the floor", 0, -40, 40, false, true, false});
    scene.start = [](const Settings& settings) {
        const Real tilt = settings["tilt"] * pi / 180;
        return std::make_unique<ImpactRun>(
            settings,
            std::vector<HalfSpace>{{{-std::sin(tilt), std::cos(tilt)}, 0}, {{1, 0}, -1}, {{-1, 0}, -1}},
            Vec2(-0.6, 1.1), Vec2(0.4, 0));
    };
    return scene;
}

/// A disc that falls into a corner of two walls.
inline Scene corner_scene()
{
    Scene scene = impact_scene("corner", "A disc falls into a corner: two contacts, four sets of either/or");
    scene.tunables[0].value = 0;
    scene.tunables.push_back({"left", "degrees", "slope of the left wall", 50, 10, 85, false, true, false});
    scene.tunables.push_back({"right", "degrees", "slope of the right wall", 25, 10, 85, false, true, false});
    scene.start = [](const Settings& settings) {
        const Real left = settings["left"] * pi / 180, right = settings["right"] * pi / 180;
        return std::make_unique<ImpactRun>(settings,
                                           std::vector<HalfSpace>{{{std::sin(left), std::cos(left)}, 0},
                                                                  {{-std::sin(right), std::cos(right)}, 0}},
                                           Vec2(-0.3, 1.2), Vec2(0, 0));
    };
    return scene;
}

}  // namespace rigid
