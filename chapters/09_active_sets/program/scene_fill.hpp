/// \file scene_fill.hpp
/// Six discs in a triangle, their nine contacts, the pattern of L and its elimination tree (9.9).
#pragma once

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/09_active_sets/elimination.hpp"
#include "common/program/program.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rigid {

class FillRun : public Run {
public:
    FillRun()
    {
        // its pattern alone: 1 where two contacts share a disc
        MatX A = MatX::Zero(count, count);
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < count; ++j) {
                const auto [a, b] = pairs[index(i)];
                const auto [c, d] = pairs[index(j)];
                if (b == d || (a >= 0 && (a == c || a == d)) || b == c) A(i, j) = 1;
            }
        SparseMatrix sparse = A.sparseView();
        sparse.makeCompressed();
        elimination_.analyse_pattern(sparse);
        parent_.fill(-1);
        for (int k = 0; k < count; ++k)
            for (int p = elimination_.row_begin[index(k)];
                 p < elimination_.row_begin[index(k + 1)]; ++p) {
                const int j = elimination_.row_columns[index(p)];
                in_L_[index(k)][index(j)] = true;
                fill_ += A(k, j) == 0;
                if (parent_[index(j)] < 0) parent_[index(j)] = k;
            }
        A_ = A;
    }

    void step(const Settings&, const Input&) override {}
    std::vector<Real> measure() const override
    {
        return {static_cast<Real>(elimination_.entries()),
                static_cast<Real>(fill_)};
    }

    void draw(Canvas& canvas) const override
    {
        const Style ink = {Colour::ink, 1.5, 1}, faint = {Colour::faint, 1, 1};
        // The pile: contacts by their numbers.
        const Real r = 0.17;
        const Vec2 foot(-1.73, -0.45);
        std::array<Vec2, 6> centre;
        for (int k = 0; k < 3; ++k) centre[index(k)] = foot + Vec2(2 * r * k, r);
        for (int k = 0; k < 2; ++k)
            centre[index(3 + k)] =
                foot + Vec2(r + 2 * r * k, r + r * std::sqrt(3.0));
        centre[5] = foot + Vec2(2 * r, r + 2 * r * std::sqrt(3.0));
        canvas.segment(foot - Vec2(1.3 * r, 0), foot + Vec2(5.3 * r, 0), ink);
        for (const Vec2& c : centre)
            canvas.disc(c, r, {Colour::blue, 1.5, 0.15, Paint::filled});
        for (int i = 0; i < count; ++i) {
            const auto [a, b] = pairs[index(i)];
            const Vec2 at = a < 0 ? Vec2(centre[index(b)] - Vec2(0, r))
                                  : Vec2((centre[index(a)] + centre[index(b)]) / 2);
            canvas.text(at + Vec2(0, a < 0 ? -0.1 : -0.035), std::to_string(i + 1),
                        13, {Colour::red, 1, 1}, Align::centre);
        }
        // L.
        const Real cell = 0.16;
        const Vec2 corner(-0.6, 0.72);
        const auto middle = [&](int k, int j) {
            return Vec2(corner + Vec2(cell * j, -cell * k));
        };
        for (int k = 0; k < count; ++k) {
            canvas.text(middle(k, -1) + Vec2(0, -0.035), std::to_string(k + 1), 13,
                        ink, Align::centre);
            canvas.text(middle(k, k) + Vec2(0, 0.5 * cell), std::to_string(k + 1),
                        13, ink, Align::centre);
            canvas.box(middle(k, k), {0.4 * cell, 0.4 * cell}, 0,
                       {Colour::ink, 1, 0.35, Paint::filled});
            for (int j = 0; j < k; ++j) {
                const bool fill = in_L_[index(k)][index(j)] && A_(k, j) == 0;
                if (fill)
                    canvas.disc(middle(k, j), 0.3 * cell, {Colour::orange, 2.5, 1});
                else if (in_L_[index(k)][index(j)])
                    canvas.box(middle(k, j), {0.4 * cell, 0.4 * cell}, 0,
                               {Colour::blue, 1, 0.8, Paint::filled});
                else canvas.disc(middle(k, j), 0.05 * cell, faint);
            }
        }
        // The tree: the last row on top; a first child stands below its parent, others to the left of it.
        std::array<Vec2, count> node;
        std::array<int, count> children = {};
        for (int k = count - 1; k >= 0; --k) {
            const int p = parent_[index(k)];
            if (p < 0) {
                node[index(k)] = {1.75, 0.8};
                continue;
            }
            const int c = children[index(p)]++;
            node[index(k)] = node[index(p)] + Vec2(c == 0 ? -0.04 : -0.36, -0.225);
            canvas.segment(node[index(k)], node[index(p)], ink);
        }
        for (int k = 0; k < count; ++k) {
            canvas.disc(node[index(k)], 0.03,
                        {Colour::green, 1.5, 1, Paint::filled});
            canvas.text(node[index(k)] + Vec2(0.06, -0.03), std::to_string(k + 1),
                        13, ink);
        }
        canvas.text({foot.x() + 2 * r, -1}, "contacts", 14, ink, Align::centre);
        canvas.text({corner.x() + 4 * cell, -1}, "L", 14, ink, Align::centre);
        canvas.text({1.5, -1}, "elimination tree", 14, ink, Align::centre);
    }

private:
    static constexpr int count = 9;
    /// Body a (−1: the floor) and b of each contact.
    static constexpr std::array<std::pair<int, int>, count> pairs = {{{-1, 0},
                                                                      {-1, 1},
                                                                      {-1, 2},
                                                                      {0, 3},
                                                                      {1, 3},
                                                                      {1, 4},
                                                                      {2, 4},
                                                                      {3, 5},
                                                                      {4, 5}}};
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }

    Elimination elimination_;
    MatX A_;
    std::array<std::array<bool, count>, count> in_L_ = {};
    std::array<int, count> parent_ = {};
    int fill_ = 0;
};

inline Demo fill_scene()
{
    Demo scene;
    scene.name = "fill";
    scene.summary = "Nine contacts of six discs: the entries of L, which of them "
                    "are fill, and the elimination tree";
    scene.view = {{-0.03, -0.08}, {2.1, 1.06}};
    scene.h = 1;
    scene.h_low = 0.02;
    scene.h_high = 2;
    scene.methods = {"active_sets"};
    scene.columns = {{"entries", "", "of L below its diagonal"},
                     {"fill", "", "of these, where A has none"}};
    scene.start = [](const Settings&) { return std::make_unique<FillRun>(); };
    return scene;
}

}  // namespace rigid
