// The functions of step_data.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/step_data.hpp"

namespace rigid {

void require_valid(const StepSettings& settings, const Vec2& gravity, Index bodies)
{
    require_step(settings.h);
    require_forces(gravity, settings.stiffness, settings.damping, settings.hand);
    require_margin(settings.margin);
    if (settings.substeps < 1)
        throw std::invalid_argument("substeps is " +
                                    std::to_string(settings.substeps) +
                                    "; it must be 1 or more");
    if (settings.pulled < world || settings.pulled >= bodies)
        throw std::invalid_argument("the hand pulls disc " +
                                    std::to_string(settings.pulled) + " among " +
                                    std::to_string(bodies));
}

}  // namespace rigid
