// The functions of cloth_threads.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/cloth_threads.hpp"

#include <algorithm>

namespace rigid {

void ClothThreads::find(const ClothScene& cloth)
{
    const std::size_t m = cloth.springs.size();
    std::vector<std::vector<int>> at(static_cast<std::size_t>(cloth.count()));
    for (std::size_t i = 0; i < m; ++i)
        for (const int p : {cloth.springs[i].a, cloth.springs[i].b})
            at[static_cast<std::size_t>(p)].push_back(static_cast<int>(i));
    const auto way = [&cloth](int p, int q) -> Vec3 {
        return cloth.bodies.position(q) - cloth.bodies.position(p);
    };
    std::vector<char> taken(m, 0);
    std::vector<int> has(at.size(), -1);  // the last thread that a particle is on
    links_.clear(), first_.assign(1, 0);
    std::vector<Link> ahead, behind;
    for (std::size_t i = 0; i < m; ++i) {
        if (taken[i]) continue;
        const int thread = static_cast<int>(first_.size());
        const ClothSpring& s = cloth.springs[i];
        taken[i] = 1;
        has[static_cast<std::size_t>(s.a)] = has[static_cast<std::size_t>(s.b)] =
            thread;
        const auto go_on = [&](int p, int q, std::vector<Link>& list) {
            for (;;) {
                int best = -1, to = -1;
                Real straightest = 0.5;
                const Vec3 along = way(p, q).normalized();
                for (const int k : at[static_cast<std::size_t>(q)]) {
                    const ClothSpring& next =
                        cloth.springs[static_cast<std::size_t>(k)];
                    const int r = next.a == q ? next.b : next.a;
                    if (taken[static_cast<std::size_t>(k)] ||
                        has[static_cast<std::size_t>(r)] == thread)
                        continue;
                    const Real straight = along.dot(way(q, r).normalized());
                    if (straight > straightest)
                        straightest = straight, best = k, to = r;
                }
                if (best < 0) return;
                taken[static_cast<std::size_t>(best)] = 1;
                has[static_cast<std::size_t>(to)] = thread;
                list.push_back({best, q, to});
                p = q, q = to;
            }
        };
        ahead.assign(1, {static_cast<int>(i), s.a, s.b});
        behind.clear();
        go_on(s.a, s.b, ahead);
        go_on(s.b, s.a, behind);
        for (auto link = behind.rbegin(); link != behind.rend(); ++link)
            links_.push_back({link->spring, link->q, link->p});
        links_.insert(links_.end(), ahead.begin(), ahead.end());
        first_.push_back(links_.size());
    }
    std::size_t longest = 0;
    for (std::size_t t = 0; t < count(); ++t)
        longest = std::max(longest, first_[t + 1] - first_[t]);
    n_.resize(longest);
    for (auto* const list : {&pivot_, &inverse_, &right_, &beside_})
        list->resize(longest);
    lambda.setZero(static_cast<Index>(m));
}

//! [sweep]
void ClothThreads::sweep(const ClothScene& cloth, Real h, VecX& x)
{
    const VecX& w = cloth.bodies.inverse_mass;
    for (std::size_t t = 0; t + 1 < first_.size(); ++t) {
        const Link* const link = links_.data() + first_[t];
        const std::size_t m = first_[t + 1] - first_[t];
        for (std::size_t i = 0; i < m; ++i) {
            const Link& l = link[i];
            const ClothSpring& s =
                cloth.springs[static_cast<std::size_t>(l.spring)];
            const Vec3 d = x.segment<3>(3 * l.q) - x.segment<3>(3 * l.p);
            const Real length = d.norm(), gamma = 1 / (h * h * s.stiffness);
            n_[i] = length > 0 ? Vec3(d / length) : Vec3(0, 0, 0);
            pivot_[i] = w[3 * l.p] + w[3 * l.q] + gamma;
            right_[i] = -(length - s.length + gamma * lambda[l.spring]);
        }
        for (std::size_t i = 0; i < m; ++i) {  // eliminate from one end
            const Real whole = pivot_[i];
            if (i > 0) {
                beside_[i] = -w[3 * link[i].p] * n_[i - 1].dot(n_[i]);
                const Real share = beside_[i] * inverse_[i - 1];
                pivot_[i] -= share * beside_[i];
                right_[i] -= share * right_[i - 1];
            }
            // pinned at both ends, or straight between pins without any softness: the
            // row adds no condition
            inverse_[i] = pivot_[i] > 1e-12 * whole ? 1 / pivot_[i] : 0;
        }
        for (std::size_t i = m; i-- > 0;) {  // and back
            Real change = right_[i];
            if (i + 1 < m) change -= beside_[i + 1] * right_[i + 1];
            right_[i] = change *= inverse_[i];
            lambda[link[i].spring] += change;
            const Vec3 P = change * n_[i];
            x.segment<3>(3 * link[i].p) -= w[3 * link[i].p] * P;
            x.segment<3>(3 * link[i].q) += w[3 * link[i].q] * P;
        }
    }
}
//! [sweep]

}  // namespace rigid
