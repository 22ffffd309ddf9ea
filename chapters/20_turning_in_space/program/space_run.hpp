/// \file space_run.hpp
/// Free bodies under the four ways to tumble.
#pragma once

#include "chapters/20_turning_in_space/program/solid_run.hpp"

namespace rigid {

inline const std::vector<std::string> ways_to_tumble = {"middle", "explicit",
                                                        "implicit", "momentum"};

class FlightSteps {
public:
    explicit FlightSteps(const SolidSetup<SolidScene>&) {}

    void step(SolidScene& scene, const Settings& settings, const StepSettings& how,
              StepData<6>& now)
    {
        const std::string& by = settings.method;
        if (by == "middle") rigid::step(scene, how, middle_, now);
        else
            tumble_all(by == "explicit"   ? Tumbling::explicit_term
                       : by == "implicit" ? Tumbling::implicit_term
                                          : Tumbling::momentum_kept,
                       how.h, scene.bodies);
    }
    static void draw_ground(SolidPicture&, const SolidScene&) {}
    static void draw_more(SolidPicture&, const SolidScene&) {}

private:
    static void tumble_all(Tumbling way, Real h, Bodies<6>& bodies)
    {
        for (Index k = 0; k < bodies.count(); ++k) {
            const Vec3 inertia =
                bodies.inverse_mass.segment<3>(6 * k + 3).cwiseInverse();
            Vec3 theta = bodies.x.segment<3>(6 * k + 3),
                 omega = bodies.u.segment<3>(6 * k + 3);
            tumble(way, inertia, h, theta, omega);
            bodies.x.segment<3>(6 * k + 3) = theta;
            bodies.u.segment<3>(6 * k + 3) = omega;
        }
    }
    FreeFlight middle_;
};

using FlightState = SolidState<SolidScene>;
using FlightSetup = SolidSetup<SolidScene>;
inline constexpr auto flight_demo = solid_demo<SolidScene, FlightSteps>;

}  // namespace rigid
