#include "chapters/30_elastic_bodies/strain_energy.hpp"

#include "common/text.hpp"

#include <stdexcept>
#include <string>

namespace rigid {

void require_valid(const ElasticMaterial& material)
{
    if (!(material.young > 0 && material.young < infinity))
        throw std::invalid_argument("Young's modulus is " +
                                    shortest(material.young) +
                                    " Pa; it must be positive and finite");
    if (!(material.poisson > -1 && material.poisson < 0.5))
        throw std::invalid_argument("Poisson's ratio is " +
                                    shortest(material.poisson) +
                                    "; it must be above -1 and below 1/2");
    if (!(material.density > 0 && material.density < infinity))
        throw std::invalid_argument("the density is " + shortest(material.density) +
                                    " kg/m³; it must be positive and finite");
}

Lame lame_of(const ElasticMaterial& material, int dim)
{
    const Real E = material.young, nu = material.poisson;
    if (dim == 1) return {E / 2, 0};
    const Real mu = E / (2 * (1 + nu));
    if (dim == 2 && material.plane_stress) return {mu, E * nu / (1 - nu * nu)};
    return {mu, E * nu / ((1 + nu) * (1 - 2 * nu))};
}

}  // namespace rigid
