#include "tests/peers/simbody_world.hpp"

#include <Simbody.h>

#include <cmath>

namespace rigid {

struct SimbodyWorld::Inside {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    std::vector<SimTK::MobilizedBody> bodies;
    SimTK::State start;
    std::unique_ptr<SimTK::RungeKuttaMersonIntegrator> by;
    long steps = 0;
    bool lost = false;

    SimTK::MobilizedBody& of(int k)
    {
        return k < 0 ? matter.updGround() : bodies[static_cast<std::size_t>(k)];
    }
};

namespace {

SimTK::Vec3 in_space(const std::array<double, 2>& p) { return {p[0], p[1], 0}; }

SimTK::Transform frame(double turn, const std::array<double, 2>& at)
{
    return {SimTK::Rotation(turn, SimTK::ZAxis), in_space(at)};
}

}  // namespace

SimbodyWorld::SimbodyWorld(const std::vector<SimbodyLink>& links, const std::vector<SimbodyLoop>& loops,
                           std::array<double, 2> gravity)
    : in_(std::make_unique<Inside>())
{
    SimTK::Force::Gravity(in_->forces, in_->matter, in_space(gravity));
    in_->bodies.resize(links.size());
    for (const SimbodyLink& link : links) {
        const SimTK::Body::Rigid body(
            SimTK::MassProperties(link.mass, SimTK::Vec3(0), SimTK::Inertia(link.inertia)));
        if (link.slides)  // along the x of its frames
            in_->of(link.body) =
                SimTK::MobilizedBody::Slider(in_->of(link.parent), frame(link.along, link.at_parent), body,
                                             frame(link.along - link.angle, link.at));
        else
            in_->of(link.body) = SimTK::MobilizedBody::Pin(
                in_->of(link.parent), frame(link.angle, link.at_parent), body, frame(0, link.at));
    }
    for (const SimbodyLoop& loop : loops)
        for (const int axis : {0, 1})
            SimTK::Constraint::PointInPlane(in_->of(loop.a), SimTK::UnitVec3(SimTK::CoordinateAxis(axis)),
                                            loop.at_a[static_cast<std::size_t>(axis)], in_->of(loop.b),
                                            in_space(loop.at_b));
    in_->start = in_->system.realizeTopology();
    in_->system.realizeModel(in_->start);
    for (const SimbodyLink& link : links) {
        in_->of(link.body).setOneQ(in_->start, 0, link.q);
        in_->of(link.body).setOneU(in_->start, 0, link.dq);
    }
}
SimbodyWorld::~SimbodyWorld() = default;

void SimbodyWorld::step(double h)
{
    if (!in_->by) {
        in_->by = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(in_->system);
        in_->by->setFixedStepSize(h);
        in_->by->initialize(in_->start);
    }
    const double end = h * static_cast<double>(++in_->steps);
    try {
        while (!in_->lost && in_->by->getTime() < end) in_->by->stepTo(end);
    } catch (const SimTK::Exception::Base&) {  // a number that is none
        in_->lost = true;
    }
}

std::array<double, 6> SimbodyWorld::state(int k) const
{
    if (in_->lost) {
        std::array<double, 6> nothing;
        nothing.fill(std::nan(""));
        return nothing;
    }
    const SimTK::State& now = in_->by->getState();
    in_->system.realize(now, SimTK::Stage::Velocity);
    const SimTK::MobilizedBody& body = in_->of(k);
    const SimTK::Vec3 x = body.getBodyOriginLocation(now), v = body.getBodyOriginVelocity(now),
                      along(body.getBodyRotation(now).x());
    return {x[0], x[1], std::atan2(along[1], along[0]), v[0], v[1], body.getBodyAngularVelocity(now)[2]};
}

}  // namespace rigid
