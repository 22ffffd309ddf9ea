/// \file solid_picture.hpp
/// A picture of solids on the canvas of the plane: a camera with perspective, facets that face it, sorted by depth,
/// each as bright as the light makes it.
#pragma once

#include "chapters/20_turning_in_space/solid_scene.hpp"
#include "common/canvas.hpp"
#include "common/elementary.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// Looks at a point from a distance. In the plane through that point across the view a metre is a metre of the picture.
struct Camera {
    Vec3 target = {0, 0, 0};
    Real distance = 6;  ///< [m]
    Real azimuth = 0.5,
         height = 0.35;  ///< angles of the eye around y and above the ground [rad]

    /// Rows: right, up, towards the eye.
    Mat3 axes() const
    {
        return rotation_matrix(Vec3(height, 0, 0)) *
               rotation_matrix(Vec3(0, -azimuth, 0));
    }
    Vec3 eye() const { return target + distance * axes().row(2).transpose(); }
    Vec2 project(const Vec3& p) const
    {
        const Vec3 seen = axes() * (p - target);
        // what is behind the eye is drawn far outside
        const Real scale =
            distance / std::max(distance - seen.z(), 0.05 * distance);
        return scale * Vec2(seen.head<2>());
    }
};

/// Whether what is behind a facet shines through.
enum class Skin : unsigned char { glass, opaque };

class SolidPicture {
public:
    explicit SolidPicture(const Camera& camera, Skin skin = Skin::glass)
        : camera_(camera), skin_(skin)
    {
    }

    /// \param away    it is sorted as if it were farther by this [m]
    /// \param opacity  of what it would have
    void facet(const std::vector<Vec3>& corners, Colour colour, Real away = 0,
               Real opacity = 1)
    {
        // by its diagonals: an edge of a round body's pole has no length
        const Vec3 normal =
            cross(corners[2] - corners[0], corners.back() - corners[1]);
        const Real length = normal.norm();
        if (!(length > 0)) return;
        Vec3 middle(0, 0, 0);
        for (const Vec3& p : corners)
            middle += p / static_cast<Real>(corners.size());
        const Vec3 to_eye = camera_.eye() - middle;
        if (!(normal.dot(to_eye) > 0)) return;  // it faces away
        const Vec3 light = Vec3(0.4, 0.8, 0.45).normalized();
        const Real bright =
            0.5 + 0.5 * std::max(Real{-0.6}, normal.dot(light) / length);
        Facet f{
            {}, to_eye.norm() + away, {colour, 1, opacity * bright, Paint::filled}};
        for (const Vec3& p : corners) f.corners.push_back(camera_.project(p));
        facets_.push_back(std::move(f));
    }

    /// A hull of a body, all of whose points lie at the centre plus R times their place.
    void hull(const Hull& hull, const Vec3& centre, const Mat3& R, Colour colour)
    {
        if (hull.vertices.size() > 2) {
            for (const std::vector<int>& face : hull.faces) {
                std::vector<Vec3> corners;
                for (const int i : face)
                    corners.push_back(
                        centre + R * hull.vertices[static_cast<std::size_t>(i)]);
                facet(corners, colour);
            }
            return;
        }
        round(hull, centre, R, colour);
    }

    /// A floor at height zero, in squares; around it sides that rise at 45°. Behind all else.
    void ground(Real half, Real height)
    {
        const int squares = 6;
        const auto at = [&](int i, int j) {
            return Vec3(half * (2.0 * i / squares - 1), 0,
                        half * (2.0 * j / squares - 1));
        };
        const std::size_t first = facets_.size();
        for (int i = 0; i < squares; ++i)
            for (int j = 0; j < squares; ++j)
                facet({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)},
                      (i + j) % 2 == 0 ? Colour::faint : Colour::ink);
        const std::size_t sides = facets_.size();
        const Real far = half + height;
        for (int side = 0; side < 4 && height > 0; ++side) {
            const Mat3 R = rotation_matrix(Vec3(0, side * pi / 2, 0));
            facet({R * Vec3(half, 0, -half), R * Vec3(half, 0, half),
                   R * Vec3(far, height, far), R * Vec3(far, height, -far)},
                  Colour::faint);
        }
        for (std::size_t i = first; i < facets_.size(); ++i) {
            facets_[i].depth += behind;
            facets_[i].style.opacity *= i < sides ? 0.2 : 0.45;
        }
    }

    void line(const std::vector<Vec3>& points, Style style)
    {
        std::vector<Vec2> seen;
        for (const Vec3& p : points) seen.push_back(camera_.project(p));
        lines_.push_back({std::move(seen), style, false});
    }
    void arrow(const Vec3& tail, const Vec3& head, Style style)
    {
        lines_.push_back(
            {{camera_.project(tail), camera_.project(head)}, style, true});
    }
    /// Words that begin at a point.
    void label(const Vec3& where, std::string words, Colour colour = Colour::ink)
    {
        labels_.push_back({camera_.project(where), std::move(words), colour});
    }

    /// The farthest first; lines over all of them, then words.
    void paint(Canvas& canvas)
    {
        std::stable_sort(
            facets_.begin(), facets_.end(),
            [](const Facet& a, const Facet& b) { return a.depth > b.depth; });
        for (Facet& f : facets_) {
            if (skin_ == Skin::opaque && f.depth < behind) {
                // the colour as it is, and a shadow over it
                canvas.polygon(f.corners, {f.style.colour, 0, 1, Paint::filled});
                f.style.colour = Colour::ink;
                f.style.opacity = 0.6 * (1 - f.style.opacity);
                f.style.width = 0;
            }
            canvas.polygon(std::move(f.corners), f.style);
        }
        for (const Line& line : lines_) {
            if (line.arrow)
                canvas.arrow(line.points[0], line.points[1], line.style);
            else canvas.polyline(line.points, line.style);
        }
        for (const Label& label : labels_)
            canvas.text(label.where, label.words, 15, {label.colour});
        facets_.clear(), lines_.clear(), labels_.clear();
    }

private:
    struct Facet {
        std::vector<Vec2> corners;
        Real depth;
        Style style;
    };
    struct Line {
        std::vector<Vec2> points;
        Style style;
        bool arrow;
    };
    struct Label {
        Vec2 where;
        std::string words;
        Colour colour;
    };

    /// A ball or a capsule in 12 slices, every third of another colour, so that its turning is seen.
    void round(const Hull& hull, const Vec3& centre, const Mat3& R, Colour colour)
    {
        const Vec3 first = hull.vertices.front(), last = hull.vertices.back();
        const Vec3 way = last - first;
        const Vec3 along =
            way.squaredNorm() > 0 ? Vec3(way.normalized()) : Vec3(1, 0, 0);
        const Vec3 side = (std::abs(along.y()) < 0.9 ? cross(along, {0, 1, 0})
                                                     : cross(along, {1, 0, 0}))
                              .normalized(),
                   up = cross(along, side);
        // nine rings; the fifth and the sixth are the ends of the cylinder
        const int rings = 9, slices = 12;
        const auto point = [&](int ring, int slice) -> Vec3 {
            const Real polar = pi * (ring < 5 ? ring : ring - 1) / 8,
                       turn = 2 * pi * slice / slices;
            const Vec3 out = -cos(polar) * along +
                             sin(polar) * (cos(turn) * side + sin(turn) * up);
            return centre + R * ((ring < 5 ? first : last) + hull.radius * out);
        };
        for (int ring = 0; ring < rings; ++ring)
            for (int slice = 0; slice < slices; ++slice)
                facet({point(ring, slice), point(ring, slice + 1),
                       point(ring + 1, slice + 1), point(ring + 1, slice)},
                      slice % 6 < 3           ? colour
                      : skin_ == Skin::opaque ? Colour::yellow
                                              : Colour::faint);
    }

    static constexpr Real behind = 1e6;  ///< how far the ground is put away [m]

    Camera camera_;
    Skin skin_;
    std::vector<Facet> facets_;
    std::vector<Line> lines_;
    std::vector<Label> labels_;
};

}  // namespace rigid
