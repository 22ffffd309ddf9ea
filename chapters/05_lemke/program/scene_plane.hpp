/// \file scene_plane.hpp
/// Two rows: left the complementary cones of the plane of q, right the path of z, and the disc in its corner.
#pragma once

#include "chapters/05_lemke/program/walk_run.hpp"
#include "common/elementary.hpp"

#include <array>

namespace rigid {

class ConesRun : public Run {
public:
    explicit ConesRun(const Settings& settings)
        : walk_(problem(settings), settings.method), A_(walk_.problem.A),
          q_(walk_.problem.q)
    {
        path_.push_back({Vec2(0, 0), walk_.lift()});
        size_ = std::max({Real{1}, q_.cwiseAbs().maxCoeff(), walk_.lift()});
    }

    void step(const Settings&, const Input&) override
    {
        const int before = walk_.walk.pivots;
        walk_.step();
        if (walk_.walk.pivots > before)
            path_.push_back({walk_.walk.z(), walk_.lift()});
    }
    std::vector<Real> measure() const override { return walk_.measure(); }

    void draw(Canvas& canvas) const override
    {
        draw_cones(canvas);
        draw_path(canvas);
        if (A_(0, 1) == A_(1, 0) && std::abs(A_(0, 1)) < 2) draw_corner(canvas);
        canvas.text({0, -1.27}, paint::told(walk_.walk), 14, paint::label,
                    Align::centre);
    }

private:
    struct Vertex {
        Vec2 z;
        Real z0 = 0;
    };
    static constexpr Real R = 1.0;  ///< radius of the cones in the picture

    static Mlcp problem(const Settings& settings)
    {
        MatX A(2, 2);
        A << 2, settings["a12"], settings["a21"], 2;
        VecX q(2);
        q << settings["q1"], settings["q2"];
        return plain_lcp(A, q);
    }

    /// The cone of q = w - A z for each choice of which of z_i and w_i may be positive.
    void draw_cones(Canvas& canvas) const
    {
        const Vec2 middle(-1.3, 0);
        static constexpr std::array colours = {Colour::green, Colour::blue,
                                               Colour::orange, Colour::purple};
        static const std::array<std::string, 4> names = {"w₁ w₂", "z₁ w₂", "w₁ z₂",
                                                         "z₁ z₂"};
        for (std::size_t choice = 0; choice < 4; ++choice) {
            const Vec2 first = choice & 1 ? Vec2(-A_.col(0)) : Vec2(1, 0);
            const Vec2 second = choice & 2 ? Vec2(-A_.col(1)) : Vec2(0, 1);
            const Real from = atan2(first.y(), first.x());
            const Real turn = atan2(cross2(first, second), first.dot(second));
            std::vector<Vec2> sector = {middle};
            for (int k = 0; k <= 40; ++k)
                sector.push_back(middle + R * Vec2(cos(from + turn * k / 40),
                                                   sin(from + turn * k / 40)));
            canvas.polygon(sector, {colours[choice], 1, 0.18, Paint::filled});
            const Real bisector = from + turn / 2;
            if (std::abs(turn) > 0.2)
                canvas.text(middle + 0.78 * R * Vec2(cos(bisector), sin(bisector)) -
                                Vec2(0, 0.03),
                            names[choice], 13, {colours[choice], 1, 1},
                            Align::centre);
        }
        canvas.text(middle + Vec2(0, R + 0.06),
                    "the plane of q: which of z and w are positive", 13,
                    paint::label, Align::centre);
        // q + z0 d comes from far along d = (1, 1) and ends in q.
        const auto shown = [&](Real z0) {
            const Vec2 p =
                middle + 0.9 * R * (q_ + z0 * Vec2(1, 1)) / (1.2 * size_);
            return p;
        };
        std::vector<Vec2> walked = {shown(1.3 * path_.front().z0 + 0.2 * size_)};
        for (const Vertex& vertex : path_) walked.push_back(shown(vertex.z0));
        canvas.segment(walked.front(), shown(0),
                       {Colour::ink, 1, 1, Paint::dashed});
        for (std::size_t k = 1; k < walked.size(); ++k)
            canvas.segment(walked[k - 1], walked[k], {Colour::red, 2.5, 1});
        for (const Vertex& vertex : path_)
            canvas.disc(shown(vertex.z0), 0.02, {Colour::red, 1, 1, Paint::filled});
        canvas.disc(shown(0), 0.035, {Colour::ink, 2, 1});
        canvas.text(shown(0) - Vec2(0.06, 0.03), "q", 15, paint::label,
                    Align::right);
        canvas.text(walked.front() + Vec2(0.04, 0), "q + z₀ d", 13, paint::label);
    }

    /// The plane of z with the lines w_i = 0; dashed, lifted by the present z0.
    void draw_path(Canvas& canvas) const
    {
        const Vec2 origin(0.35, -0.85);
        Real reach = 1;
        for (const Vertex& vertex : path_)
            reach = std::max(reach, 1.3 * vertex.z.maxCoeff());
        for (Index i = 0; i < 2; ++i)
            reach = std::max(reach, std::min(Real{8}, 1.3 * -q_[i] / A_(i, i)));
        const Real unit = 1.75 / reach;
        const auto shown = [&](const Vec2& z) { return Vec2(origin + unit * z); };
        canvas.arrow(origin, origin + Vec2(1.95, 0), paint::axis);
        canvas.arrow(origin, origin + Vec2(0, 1.9), paint::axis);
        canvas.text(origin + Vec2(1.95, -0.2), "z₁ [N s]", 13, paint::label,
                    Align::right);
        canvas.text(origin + Vec2(-0.06, 1.87), "z₂ [N s]", 13, paint::label,
                    Align::right);
        const int tick = reach > 6 ? 2 : 1;
        for (int k = tick; k <= reach; k += tick) {
            canvas.segment(shown({Real(k), 0}), shown({Real(k), 0}) - Vec2(0, 0.02),
                           paint::axis);
            canvas.segment(shown({0, Real(k)}), shown({0, Real(k)}) - Vec2(0.02, 0),
                           paint::axis);
            canvas.text(shown({Real(k), 0}) - Vec2(0, 0.1), std::to_string(k), 12,
                        paint::label, Align::centre);
            canvas.text(shown({0, Real(k)}) - Vec2(0.05, 0.02), std::to_string(k),
                        12, paint::label, Align::right);
        }
        for (Index i = 0; i < 2; ++i) {
            const Colour colour = i == 0 ? Colour::purple : Colour::green;
            draw_line(canvas, shown, i, 0, reach, {colour, 1.5, 1});
            if (walk_.lift() > 0)
                draw_line(canvas, shown, i, walk_.lift(), reach,
                          {colour, 1, 0.8, Paint::dashed});
        }
        std::vector<Vec2> walked;
        for (const Vertex& vertex : path_) walked.push_back(shown(vertex.z));
        for (std::size_t k = 1; k < walked.size(); ++k)
            canvas.segment(walked[k - 1], walked[k], {Colour::red, 2.5, 1});
        for (std::size_t k = 0; k < walked.size(); ++k)
            canvas.disc(walked[k], k + 1 == walked.size() ? 0.035 : 0.02,
                        {Colour::red, 1, 1, Paint::filled});
    }

    /// The disc between the two walls whose normals have the product a12 / 2, and the impulses that it gets.
    void draw_corner(Canvas& canvas) const
    {
        constexpr Real radius = 0.2, newton_second = 0.1;  // lengths in the picture
        const Vec2 centre(1.72, 0.78);
        canvas.disc(centre, radius, {Colour::blue, 1.5, 0.9});
        const Real c = std::sqrt((1 + A_(0, 1) / 2) / 2), s = std::sqrt(1 - c * c);
        for (const int i : {0, 1}) {
            const Vec2 n(i == 0 ? s : -s, c), touch = centre - radius * n;
            const Vec2 up = i == 0 ? Vec2(-c, s) : Vec2(c, s);  // along the wall
            canvas.segment(touch - radius * s / c * up, touch + 0.3 * up,
                           {Colour::ink, 2, 1});
            canvas.text(touch - 0.1 * n + 0.05 * up - Vec2(0, 0.04),
                        "z" + paint::subscript(i + 1), 13, paint::label,
                        Align::centre);
            if (const Real z = path_.back().z[i]; z > 0)
                canvas.arrow(touch, touch + newton_second * z * n,
                             {Colour::red, 2.5, 1});
        }
    }

    /// w_i + z0 = 0 within 0 … reach, where it can be seen.
    template <class Shown>
    void draw_line(Canvas& canvas, const Shown& shown, Index i, Real z0, Real reach,
                   const Style& style) const
    {
        const Vec2 a = A_.row(i);
        const Real c = q_[i] + z0;
        std::vector<Vec2> part;
        // along the axis that it crosses least steeply
        for (int k = 0; k <= 400; ++k) {
            const Real t = reach * k / 400;
            const Vec2 z = std::abs(a.y()) > std::abs(a.x())
                               ? Vec2(t, -(c + a.x() * t) / a.y())
                               : Vec2(-(c + a.y() * t) / a.x(), t);
            if (z.minCoeff() >= 0 && z.maxCoeff() <= reach) part.push_back(z);
        }
        if (part.size() < 2) return;
        canvas.segment(shown(part.front()), shown(part.back()), style);
        if (z0 > 0) return;
        const Vec2 end =
            part.front().y() > part.back().y() ? part.front() : part.back();
        canvas.text(shown(end) + Vec2(0.05, 0.02),
                    "w" + paint::subscript(i + 1) + " = 0", 13,
                    {style.colour, 1, 1});
    }

    ProblemWalk walk_;
    Eigen::Matrix2d A_;
    Vec2 q_;
    std::vector<Vertex> path_;
    Real size_ = 1;
};

inline Demo plane_scene()
{
    Demo scene = walk_scene(
        "two_contacts",
        "Two rows: the complementary cones, and the path from vertex to vertex");
    scene.view = {{-0.05, -0.08}, {2.5, 1.3}};
    scene.tunables = {{"a12", "1/kg", "what an impulse of row 2 does to row 1", 1,
                       -3, 3, Numbers::real, OnChange::restarts},
                      {"a21", "1/kg", "what an impulse of row 1 does to row 2", 1,
                       -3, 3, Numbers::real, OnChange::restarts},
                      {"q1", "m/s", "velocity of row 1 before any impulse", -5, -8,
                       8, Numbers::real, OnChange::restarts},
                      {"q2", "m/s", "velocity of row 2 before any impulse", -6, -8,
                       8, Numbers::real, OnChange::restarts}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<ConesRun>(settings);
    };
    return scene;
}

}  // namespace rigid
