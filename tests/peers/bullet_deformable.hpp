/// \file bullet_deformable.hpp
/// A body of tetrahedra in Bullet's world of deformable bodies.
#pragma once

#ifdef RIGID_HAS_BULLET

#include "chapters/30_elastic_bodies/elastic_solver.hpp"
#include "tests/peers/bullet_deformable_world.hpp"

#include <BulletSoftBody/btDeformableLinearElasticityForce.h>
#include <BulletSoftBody/btDeformableNeoHookeanForce.h>

namespace rigid {

class BulletDeformable : public BulletDeformableWorld {
public:
    /// \param newton   iterations a step at most; 1 is Bullet's own number
    /// \param damping  share of K in its damping, β [s]
    explicit BulletDeformable(const ElasticBody<3>& body, int newton = 1, Real damping = 0)
        : BulletDeformableWorld(body.gravity, newton)
    {
        const ElasticMesh<3>& mesh = body.model.mesh();
        std::vector<btVector3> x;
        std::vector<btScalar> m;
        for (int i = 0; i < mesh.nodes(); ++i) {
            x.push_back(bullet_vector(mesh.at(i)));
            m.push_back(body.fixed[static_cast<std::size_t>(3 * i)] ? 0 : body.model.mass_at(i));
        }
        btSoftBody& soft = begin(x, m);
        for (int e = 0; e < mesh.count(); ++e)
            soft.appendTetra(mesh.node(e, 0), mesh.node(e, 1), mesh.node(e, 2), mesh.node(e, 3));
        soft.initializeDmInverse();
        soft.m_tetraScratches.resize(soft.m_tetras.size());
        soft.m_tetraScratchesTn.resize(soft.m_tetras.size());
        const Lame& lame = body.model.lame();
        if (body.model.material().law == StrainLaw::neo_hookean)
            put_in(std::make_unique<btDeformableNeoHookeanForce>(lame.mu, lame.lambda, damping));
        else put_in(std::make_unique<btDeformableLinearElasticityForce>(lame.mu, lame.lambda, 0, damping));
    }

    Vec3 at(int k) const
    {
        const btVector3& p = node(k).m_x;
        return {p.x(), p.y(), p.z()};
    }
};

}  // namespace rigid

#endif
