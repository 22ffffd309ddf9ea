/// \file simbody_world.hpp
/// Joints in the plane in Simbody (libsimbody-dev), by its public interface alone. Its headers are none of C++20, so that this one has
/// plain types and simbody_world.cpp is compiled by an older standard.
#pragma once

#include <array>
#include <memory>
#include <vector>

namespace rigid {

/// A body and the joint that it hangs on. Its frame has its origin at the centroid.
struct SimbodyLink {
    int body = 0, parent = -1;            ///< parents first; -1: the world
    double mass = 1, inertia = 1;         ///< [kg, kg m²]
    bool slides = false;                  ///< else it turns
    std::array<double, 2> at_parent, at;  ///< the joint's point in both [m]
    double angle = 0;                     ///< of the body in its parent where the coordinate is zero [rad]
    double along = 0;                     ///< of what slides: the angle of its axis in the parent [rad]
    double q = 0, dq = 0;                 ///< at the start
};

/// Two points of bodies that stay in one place: a loop.
struct SimbodyLoop {
    int a = 0, b = 0;
    std::array<double, 2> at_a, at_b;
};

class SimbodyWorld {
public:
    SimbodyWorld(const std::vector<SimbodyLink>& links, const std::vector<SimbodyLoop>& loops,
                 std::array<double, 2> gravity);
    ~SimbodyWorld();

    /// By its Runge-Kutta-Merson integrator, of order four, whose other settings are its own. The first h is that of all.
    void step(double h);

    /// x, y, angle and their rates of a body; not a number once a step has failed.
    std::array<double, 6> state(int body) const;

private:
    struct Inside;
    std::unique_ptr<Inside> in_;
};

}  // namespace rigid
