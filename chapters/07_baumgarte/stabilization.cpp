// The functions of stabilization.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/07_baumgarte/stabilization.hpp"

namespace rigid {

StabilizerSettings in_metres(StabilizerSettings settings, Real length)
{
    settings.slop *= length;
    settings.bilateral_slop *= length;
    settings.max_correction_speed *= length;
    settings.tolerance *= length;
    return settings;
}

void require_valid(const StabilizerSettings& settings)
{
    const auto refuse = [](Real value, const char* name, const char* wanted) {
        throw std::invalid_argument(std::string(name) + " is " + shortest(value) +
                                    "; it must be " + wanted);
    };
    const auto finite = [&](Real value, const char* name) {
        if (!(value >= 0 && std::isfinite(value)))
            refuse(value, name, "zero or positive and finite");
    };
    const auto at_least_zero = [&](Real value, const char* name) {
        if (!(value >= 0)) refuse(value, name, "zero or positive");
    };
    finite(settings.beta, "beta");
    finite(settings.slop, "slop");
    finite(settings.bilateral_slop, "bilateral_slop");
    at_least_zero(settings.max_correction_speed, "max_correction_speed");
    at_least_zero(settings.tolerance, "the tolerance of the repaying sweeps");
    if (settings.correction_sweeps < 0)
        throw std::invalid_argument("correction_sweeps is " +
                                    std::to_string(settings.correction_sweeps) +
                                    "; it must be zero or positive");
}

}  // namespace rigid
