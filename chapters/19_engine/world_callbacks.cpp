/// \file world_callbacks.cpp
/// What a caller is asked in the middle of a step, and where it may help.
#include "common/eigen_instances.hpp"

#include "chapters/19_engine/world.hpp"

#include "chapters/19_engine/contact_lists.hpp"
#include "chapters/19_engine/world_cpp.hpp"

namespace rigid {

namespace {

/// The stages ask by numbers, a caller answers about ids.
void hand_on(EngineState& state)
{
    AskedManifolds& stage = state.awake().touching;
    stage.finder.lets = {};
    stage.counts = {};
    if (state.contact_filter || state.pre_solve)
        stage.finder.lets = [&state, &stage](int a, int b) {
            return !std::binary_search(stage.left_out.begin(), stage.left_out.end(),
                                       pair_key(a, b)) &&
                   (!state.contact_filter ||
                    state.contact_filter(state.id(a), state.id(b)));
        };
    if (state.pre_solve)
        stage.counts = [&state, views = std::vector<ContactView>{}](
                           std::span<const Contact> points) mutable {
            views.clear();
            for (const Contact& c : points)
                views.push_back(view_of(state, c, wall_id(state, c)));
            return state.pre_solve(views[0].touch, views);
        };
}

}  // namespace

void World::set_contact_filter(ContactFilter filter)
{
    state_->contact_filter = std::move(filter);
    hand_on(*state_);
}
void World::set_pre_solve(PreSolve pre_solve)
{
    state_->pre_solve = std::move(pre_solve);
    hand_on(*state_);
}
void World::set_jobs(Jobs jobs)
{
    state_->awake().touching.jobs = jobs;
    state_->method.solver.jobs = std::move(jobs);
}

}  // namespace rigid
