/// \file rough_solids.hpp
/// A scene in space whose surfaces hold each other; and what is smooth and round without a core.
#pragma once

#include "chapters/23_faces_that_touch/walled_solids.hpp"

namespace rigid {

//! [ellipsoid]
/// A smooth solid that touches walls, and nothing else: all at + S n with ‖n‖ ≤ 1.
struct SolidEllipsoid {
    Index body = 0;
    Vec3 at = {0, 0, 0};              ///< its centre, in the body's axes [m]
    Mat3 stretch = Mat3::Identity();  ///< S, in the body's axes [m]
};
//! [ellipsoid]

//! [scene]
struct RoughSolids : WalledSolids {
    /// μ of each body and wall; empty: nothing there has friction
    std::vector<Real> friction, wall_friction;
    /// arms of rolling and spinning friction of each body [m]; empty: none has any
    std::vector<Real> rolling, spinning;
    std::vector<SolidEllipsoid> ellipsoids;

    using WalledSolids::WalledSolids;
    RoughSolids() = default;
    RoughSolids(WalledSolids scene) : WalledSolids(std::move(scene)) {}
};
//! [scene]

/// Throws std::invalid_argument, with a sentence that names the thing, unless walls, surfaces and ellipsoids make sense.
void require_touching(const RoughSolids& scene);

/// The same of one list of coefficients or arms.
/// \param thing  what it belongs to: "bodies"
/// \param what   "friction coefficient"
void require_list(const std::vector<Real>& list, std::size_t count,
                  const char* thing, const char* what);

}  // namespace rigid
