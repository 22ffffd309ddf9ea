/// \file solid_floating.hpp
/// Solids in shallow water of two directions: floating.hpp, with a plane more to cut by.
///
///     V = ∫ over the wet skin of (η − y) dA_y                 column by column: what of a hull is under water, without its lid
///     J = h ρ g V_i (−∂η/∂x, 1, −∂η/∂z)  at the centroid of V_i
///
/// A face of a hull is cut by the sides of a column of water and by its level. By Gauss' theorem the volume below the level is
/// an integral over these pieces alone: the sides of the column are upright, and the lid has no height. So no polyhedron is
/// ever built. Only hulls with flat faces float here; balls and capsules are refused.
#pragma once

#include "chapters/25_world_in_space/space_scene.hpp"
#include "chapters/28_waves/floating.hpp"
#include "chapters/28_waves/shallow_grid.hpp"

#include <vector>

namespace rigid {

/// What of a solid lies below a level surface.
struct SubmergedSolid {
    Real volume = 0;            ///< [m³]
    Vec3 centroid = {0, 0, 0};  ///< the centre of buoyancy B [m]
    Real area = 0;              ///< of the waterline [m²]
    Vec3 middle = {0, 0, 0};    ///< of the waterline [m]
};

/// Sums over pieces of skin below a level, from which a SubmergedSolid is made.
struct WetSkin {
    Real volume = 0, area = 0;
    Vec3 moment = {0, 0, 0}, area_moment = {0, 0, 0};

    /// Adds a convex piece, counterclockwise as seen from outside. \param origin  near it
    void add(const std::vector<Vec3>& piece, Real level, const Vec3& origin);
    SubmergedSolid below(Real level, const Vec3& origin) const;
};

/// Of a hull with flat faces at the centre plus R times its place.
SubmergedSolid submerged(const Hull& hull, const Vec3& centre, const Mat3& R,
                         Real level);

/// What of a body is under water in one column.
struct SolidSlice {
    Index body = 0, cell = 0;
    SubmergedSolid below;
};

/// A piece of a face under water in one column.
struct WetFace {
    Index body = 0, cell = 0;
    Vec3 middle = {0, 0, 0};
    Vec3 normal = {0, 1, 0};  ///< outwards
    Real area = 0;            ///< [m²]
};

class SolidFloating {
public:
    FloatSettings settings;
    std::vector<SolidSlice> slices;  ///< of the last find()
    std::vector<WetFace> faces;
    HullLevels hulls;  ///< of the last push()
    VecX level;        ///< of each column; below hulls what the last step found [m]

    /// Where solids and water meet now.
    /// Throws std::invalid_argument for a hull with a radius.
    void find(const SpaceScene& scene, const ShallowGrid& water);

    /// Takes out the water that solids displace, so that levels are those that it had without them.
    /// Throws std::invalid_argument where a hull leaves no water below it.
    void displace(const SpaceScene& scene, ShallowGrid& water);

    /// Drag brakes one against the other; levels under hulls are found; slopes push the water and the solids.
    void push(SpaceScene& scene, ShallowGrid& water, Real h);

private:
    void cut_body(const SpaceScene& scene, const ShallowGrid& water, Index k);
    void drag(SpaceScene& scene, ShallowGrid& water, Real h) const;
    void find_levels(const SpaceScene& scene, const ShallowGrid& water, Real h);

    /// A face between two cells, across x or across z, one of them below a hull at least.
    struct Between {
        Index low = 0, high = 0, face = 0;
        bool along_x = true;
        Real before = 0;  ///< its velocity before slopes push
        Real rise = 0;    ///< the slope that pushes bodies
    };
    void find_between(const ShallowGrid& water);

    VecX under_, width_;       ///< b and its derivative with η
    VecX wet_area_;            ///< of each body [m²]
    std::vector<int> number_;  ///< of each column among those below hulls
    std::vector<Index> wet_cells_;
    std::vector<Between> between_;
    std::vector<Vec2> rise_;  ///< of each wet column, the mean slope that pushes
    std::vector<WetSkin> sums_;
    std::vector<Vec3> corners_, strip_, half_, piece_, wet_;
};

}  // namespace rigid
