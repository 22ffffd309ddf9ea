/// \file separation.hpp
/// How far two convex shapes are apart along the normals of their faces.
///
///     s_i = min_j n_i·(w_j − v_i)        of face i of one shape against the vertices w of the other    (12.1)
///     s   = max s_i                      over the faces of both
///
/// s > 0: the polygons are apart by s at least. s ≤ 0: they overlap, and s is exactly how far one has to be moved until they
/// do not. The face of s is the reference face.
#pragma once

#include "chapters/12_contact_manifolds/placed_shape.hpp"

namespace rigid {

/// A face of one of two shapes, and what it sees of the other.
struct Face {
    bool of_b = false;  ///< it is one of b's
    int edge = -1;      ///< −1: neither shape has a face
    int support = 0;    ///< vertex of the other that is farthest against n_i
    Real separation = -infinity;  ///< s_i [m]
};

//! [separation]
/// (12.1): s_i of face `edge` of p against q, and the vertex of q that gives it.
inline Real separation_of(const Placed& p, int edge, const Placed& q, int& support)
{
    const Vec2 &n = p.normal(edge), &v = p.vertex(edge);
    const Real offset = n.x() * v.x() + n.y() * v.y();
    Real least = infinity;
    for (int j = 0; j < q.size(); ++j) {
        const Vec2& w = q.vertex(j);
        const Real along = n.x() * w.x() + n.y() * w.y();
        if (along < least) least = along, support = j;
    }
    return least - offset;
}

/// The face of largest separation; the first that reaches `enough` will do.
inline Face reference_face(const Placed& a, const Placed& b, Real enough)
{
    Face best;
    const auto look = [&](const Placed& p, const Placed& q, bool of_b) {
        for (int i = 0; i < p.edges() && !(best.separation >= enough); ++i) {
            int support = 0;
            const Real s = separation_of(p, i, q, support);
            if (s > best.separation) best = {of_b, i, support, s};
        }
    };
    look(a, b, false);
    look(b, a, true);
    return best;
}
//! [separation]

}  // namespace rigid
