// The functions of small_step_rows.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/08_warm_starting/small_step_rows.hpp"

namespace rigid {

void number_groups(const DiscScene& scene, SmallStep& now)
{
    now.groups.of.clear();  // it holds the numbers of the last call
    find_groups<2>(now.bodies, scene.bodies.inverse_mass, now.groups);
    // the lowest body of the group; becomes its number, from 0
    std::vector<Index>& of = now.groups.of;
    now.starts.clear();
    now.runs.clear();
    now.mass.resize(scene.bodies.count());
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Real w = scene.bodies.inverse_mass[2 * k];
        now.mass[k] = w > 0 ? 1 / w : 0;
        Index& group = of[static_cast<std::size_t>(k)];
        if (group == k) {
            group = static_cast<Index>(now.starts.size());
            now.starts.emplace_back();
        } else {
            // a lower body: it has its number
            group = of[static_cast<std::size_t>(group)];
        }
        const auto number = static_cast<std::size_t>(group);
        if (now.runs.empty() || now.runs.back().group != number)
            now.runs.push_back({k, k, number});
        now.runs.back().end = k + 1;
    }
    now.group_of_row.resize(now.bodies.size());
    for (std::size_t i = 0; i < now.bodies.size(); ++i)
        now.group_of_row[static_cast<std::size_t>(now.place[i])] =
            static_cast<std::size_t>(
                of[static_cast<std::size_t>(now.groups.of_row[i])]);
}

void change_rows(const DiscScene& scene, const SmallStepSettings& settings, Real h,
                 SmallStep& now)
{
    const std::size_t m = now.keys.size();
    now.remembered.resize(static_cast<Index>(now.rows.size()));
    for (std::size_t k = 0; k < now.rows.size(); ++k)
        now.remembered[now.order[k]] = now.rows[k].lambda;
    if (now.cache.h > 0)
        store(now.cache, now.keys_before, now.remembered, now.cache.h);
    load(now.cache, now.keys, h, now.remembered);
    now.keys_before = now.keys;

    now.bodies.resize(m);
    for (std::size_t i = 0; i < m; ++i) {
        const auto [a, b] = bodies_of(scene, now, i);
        now.bodies[i].a = a;
        now.bodies[i].b = b;
        if (a != world)
            now.bodies[i].Wa = scene.bodies.inverse_mass.segment<2>(2 * a);
        now.bodies[i].Wb = scene.bodies.inverse_mass.segment<2>(2 * b);
    }
    if (settings.coloured)
        colour_rows(now.bodies, scene.bodies.count(), now.colouring, now.order);
    else {
        now.order.resize(m);
        std::iota(now.order.begin(), now.order.end(), 0);
    }

    now.rows.resize(m);
    now.rest.resize(m);
    now.place.resize(m);
    for (std::size_t k = 0; k < m; ++k) {
        const auto i = static_cast<std::size_t>(now.order[k]);
        const Index a = now.bodies[i].a, b = now.bodies[i].b;
        SolverRow<2>& row = now.rows[k];
        now.place[i] = static_cast<int>(k);
        row.a = static_cast<int>(2 * (a == world ? b : a));
        row.b = static_cast<int>(2 * b);
        const Real A = (a == world ? 0 : scene.bodies.inverse_mass[row.a]) +
                       scene.bodies.inverse_mass[row.b];
        row.mass = A > 0 ? 1 / A : 0;
        row.lo = i < scene.links.size() ? -infinity : 0;
        row.hi = infinity;
        row.lambda = now.remembered[static_cast<Index>(i)];
    }
    number_groups(scene, now);
}

void begin_rows(const DiscScene& scene, const SmallStepSettings& settings,
                SmallStep& now)
{
    require_valid(scene, settings);
    const Real h = settings.h / settings.substeps;
    const std::size_t links = scene.links.size();
    now.contacts.clear();
    now.length = typical_length(scene);
    if (settings.collides)
        find_contacts(scene, settings.margin * now.length, now.contacts);
    now.keys.clear();
    for (std::size_t i = 0; i < links; ++i) now.keys.push_back(link_key(i));
    for (const Contact& contact : now.contacts)
        now.keys.push_back(contact_key(contact));

    now.same_rows = !std::exchange(now.forget_rows, false) && now.cache.h == h &&
                    now.keys == now.keys_before;
    if (!now.same_rows) change_rows(scene, settings, h, now);
    now.cache.h = h;
    now.driven = false;
    for (Index k = 0; k < scene.bodies.count() && !now.driven; ++k)
        now.driven = !(now.mass[k] > 0) && !scene.bodies.velocity(k).isZero(0);

    // At which distance C is zero, and the normals of walls.
    for (std::size_t i = 0; i < now.keys.size(); ++i) {
        const auto k = static_cast<std::size_t>(now.place[i]);
        if (i < links) {
            now.rest[k] = scene.links[i].length;
            continue;
        }
        const Contact& contact = now.contacts[i - links];
        if (contact.a != world) {
            now.rest[k] = scene.radius[contact.a] + scene.radius[contact.b];
            continue;
        }
        SolverRow<2>& row = now.rows[k];
        row.Ja.setZero();
        row.Wa.setZero();
        row.Jb = contact.normal.transpose();
        row.Wb = scene.bodies.inverse_mass[row.b] * contact.normal;
        now.rest[k] =
            contact.normal.dot(scene.bodies.x.segment<2>(row.b)) - contact.gap;
    }
}

}  // namespace rigid
