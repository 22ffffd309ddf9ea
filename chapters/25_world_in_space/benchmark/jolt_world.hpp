/// \file jolt_world.hpp
/// A world of Jolt in plain numbers: no header of Jolt and none of Eigen, because both are compiled for other processors.
#pragma once

#include <array>
#include <memory>
#include <vector>

namespace rigid {

struct JoltBody {
    enum Kind { ball, capsule, box } kind = box;
    std::array<double, 3>
        size{};         ///< edges of a box; the first: length of a capsule [m]
    double radius = 0;  ///< [m]
    double friction = 0;
    std::array<double, 3> at{};         ///< [m]
    std::array<double, 4> turn{};       ///< a quaternion, its w last
    std::array<double, 3> v{}, spin{};  ///< in the world's axes [m/s, rad/s]
    double mass = 0;                    ///< [kg]; 0: it is fixed
    std::array<double, 3> inertia{};    ///< about its own axes [kg m²]
};

struct JoltJoint {
    int a = -1, b = 0;                     ///< −1: the world
    std::array<double, 3> at_a{}, at_b{};  ///< in the bodies' axes [m]
    std::array<double, 4> frame_a{}, frame_b{};
    bool is_hinge = false;
    bool is_bounded = false;
    double lo = 0, hi = 0, cone = 0;  ///< of a bounded one [rad]
};

/// Jolt's own defaults, in floats, on one thread, without sleep and damping.
class JoltWorld {
public:
    /// \param iterations  of velocities; 0: Jolt's default
    JoltWorld(const std::vector<JoltBody>& bodies,
              const std::vector<JoltJoint>& joints, std::array<double, 3> gravity,
              int substeps, int iterations);
    ~JoltWorld();
    JoltWorld(const JoltWorld&) = delete;
    JoltWorld& operator=(const JoltWorld&) = delete;

    void step(double h);
    /// Where body k is and how fast; kind, masses and shape stay empty.
    JoltBody state(std::size_t k) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rigid
