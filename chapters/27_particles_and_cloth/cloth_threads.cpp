// The functions of cloth_threads.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/cloth_threads.hpp"

#include <algorithm>

namespace rigid {

std::vector<ClothThreads::Thread>
ClothThreads::threads_of(const ClothScene& cloth) const
{
    const std::size_t m = cloth.springs.size();
    std::vector<std::vector<int>> at(static_cast<std::size_t>(cloth.count()));
    for (std::size_t i = 0; i < m; ++i)
        for (const int p : {cloth.springs[i].a, cloth.springs[i].b})
            at[static_cast<std::size_t>(p)].push_back(static_cast<int>(i));
    const bool known = cloth.made_at.size() == at.size();
    const auto place = [&cloth, known](int p) -> Vec3 {
        return known ? cloth.made_at[static_cast<std::size_t>(p)]
                     : Vec3(cloth.bodies.position(p));
    };
    const auto way = [&place](int p, int q) -> Vec3 { return place(q) - place(p); };
    std::vector<char> taken(m, 0);
    std::vector<int> has(at.size(), -1);  // the last thread that a particle is on
    std::vector<Thread> threads;
    struct Way {
        int spring = 0, to = 0;
    };
    std::vector<Way> ahead, behind;
    for (std::size_t i = 0; i < m; ++i) {
        if (taken[i]) continue;
        const int thread = static_cast<int>(threads.size());
        const ClothSpring& s = cloth.springs[i];
        taken[i] = 1;
        has[static_cast<std::size_t>(s.a)] = has[static_cast<std::size_t>(s.b)] =
            thread;
        const auto go_on = [&](int p, int q, std::vector<Way>& list) {
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
                list.push_back({best, to});
                p = q, q = to;
            }
        };
        ahead.clear(), behind.clear();
        go_on(s.a, s.b, ahead);
        go_on(s.b, s.a, behind);
        Thread& made = threads.emplace_back();
        for (auto link = behind.rbegin(); link != behind.rend(); ++link) {
            made.particles.push_back(link->to);
            made.springs.push_back(link->spring);
        }
        made.particles.insert(made.particles.end(), {s.a, s.b});
        made.springs.push_back(static_cast<int>(i));
        for (const Way& link : ahead) {
            made.particles.push_back(link.to);
            made.springs.push_back(link.spring);
        }
        for (const int k : made.springs)
            made.stiffness =
                std::max(made.stiffness,
                         cloth.springs[static_cast<std::size_t>(k)].stiffness);
    }
    return threads;
}

//! [bundle]
void ClothThreads::find(const ClothScene& cloth)
{
    std::vector<Thread> threads = threads_of(cloth);
    count_ = threads.size();
    std::stable_sort(
        threads.begin(), threads.end(), [](const Thread& a, const Thread& b) {
            return a.stiffness != b.stiffness ? a.stiffness < b.stiffness
                                              : a.springs.size() > b.springs.size();
        });
    // Each has the first colour of its stiffness that none of its particles has; it
    // depends on what hangs on it alone, and not on other cloths of the scene.
    std::vector<std::vector<const Thread*>> colours;
    std::vector<std::vector<int>> of(static_cast<std::size_t>(cloth.count()));
    std::vector<std::size_t> barred;  // by the last thread that may not have it
    std::size_t open = 0;             // the first colour of this stiffness
    for (std::size_t t = 0; t < threads.size(); ++t) {
        const Thread& thread = threads[t];
        if (t > 0 && thread.stiffness != threads[t - 1].stiffness)
            open = colours.size();
        for (const int p : thread.particles)
            for (const int k : of[static_cast<std::size_t>(p)])
                barred[static_cast<std::size_t>(k)] = t;
        std::size_t k = open;
        while (k < colours.size() && barred[k] == t) ++k;
        if (k == colours.size()) {
            colours.emplace_back();
            barred.push_back(threads.size());
        }
        colours[k].push_back(&thread);
        for (const int p : thread.particles)
            of[static_cast<std::size_t>(p)].push_back(static_cast<int>(k));
    }
    bundles_.clear(), at_.clear(), links_.clear();
    std::size_t longest = 0;
    for (const auto& colour : colours)
        for (std::size_t t = 0; t < colour.size(); t += lanes) {
            const auto from = colour.begin() + static_cast<std::ptrdiff_t>(t);
            add(cloth, {from, from + std::min<std::ptrdiff_t>(lanes, colour.end() -
                                                                         from)});
            longest = std::max(longest, bundles_.back().links);
        }
    places_.resize(longest + 1);
    bars_.resize(longest);
}
//! [bundle]

void ClothThreads::add(const ClothScene& cloth,
                       const std::vector<const Thread*>& bundle)
{
    Bundle made;
    made.first = links_.size(), made.particle = at_.size();
    made.threads = static_cast<int>(bundle.size());
    for (const Thread* const t : bundle)
        made.links = std::max(made.links, t->springs.size());
    const auto of = [&bundle](int l) -> const Thread& {
        // a lane that has no thread has the first one's particle, and no links
        return *bundle[static_cast<std::size_t>(l) < bundle.size()
                           ? static_cast<std::size_t>(l)
                           : 0];
    };
    for (std::size_t i = 0; i <= made.links; ++i)
        for (int l = 0; l < lanes; ++l)
            at_.push_back(
                l < made.threads
                    ? of(l).particles[std::min(i, of(l).particles.size() - 1)]
                    : of(l).particles[0]);
    for (std::size_t i = 0; i < made.links; ++i) {
        Link link{Many{}, Many{} + 1, Many{}};
        for (int l = 0; l < made.threads; ++l) {
            if (i >= of(l).springs.size()) continue;
            const ClothSpring& s =
                cloth.springs[static_cast<std::size_t>(of(l).springs[i])];
            set_lane(link.length, l, s.length);
            set_lane(link.compliance, l, 1 / s.stiffness);
        }
        links_.push_back(link);
    }
    bundles_.push_back(made);
}

void ClothThreads::begin()
{
    for (Link& link : links_) link.lambda = Many{};
}

void ClothThreads::sweep(const ClothScene& cloth, Real h, VecX& x)
{
    for (const Bundle& bundle : bundles_)
        solve(bundle, h, cloth.bodies.inverse_mass, x);
}

//! [solve]
void ClothThreads::solve(const Bundle& bundle, Real h, const VecX& w, VecX& x)
{
    const int* const at = at_.data() + bundle.particle;
    Link* const link = links_.data() + bundle.first;
    const std::size_t m = bundle.links;
    for (std::size_t i = 0; i <= m; ++i)
        for (int l = 0; l < lanes; ++l) {
            const Index k = 3 * at[i * lanes + static_cast<std::size_t>(l)];
            set_lane(places_[i].x, l, x[k]);
            set_lane(places_[i].y, l, x[k + 1]);
            set_lane(places_[i].z, l, x[k + 2]);
            set_lane(places_[i].w, l, w[k]);
        }
    for (std::size_t i = 0; i < m; ++i) {  // C, n and elimination from one end
        const Place &a = places_[i], &b = places_[i + 1];
        Bar& bar = bars_[i];
        const Many x_ = b.x - a.x, y_ = b.y - a.y, z_ = b.z - a.z;
        Many length = x_ * x_ + y_ * y_ + z_ * z_;
        for (int l = 0; l < lanes; ++l)
            set_lane(length, l, std::sqrt(lane(length, l)));
        const Many none{}, over = 1 / (length > none ? length : none + 1);
        bar.x = x_ * over, bar.y = y_ * over, bar.z = z_ * over;
        const Many gamma = link[i].compliance / (h * h), whole = a.w + b.w + gamma;
        bar.right = link[i].length - length - gamma * link[i].lambda;
        Many pivot = whole;
        if (i > 0) {
            const Bar& before = bars_[i - 1];
            bar.beside =
                -a.w * (before.x * bar.x + before.y * bar.y + before.z * bar.z);
            const Many share = bar.beside * before.inverse;
            pivot -= share * bar.beside;
            bar.right -= share * before.right;
        }
        // pinned at both ends, or straight between pins without any softness: the row
        // adds no condition
        const Many enough = 1e-12 * whole;
        bar.inverse = pivot > enough ? 1 / pivot : none;
    }
    Many change{}, beside{}, px{}, py{}, pz{};  // of the link behind
    for (std::size_t i = m + 1; i-- > 0;) {     // and back
        // a particle has −P of the link behind it, and +P of the one before it
        Many x_ = -px, y_ = -py, z_ = -pz;
        if (i > 0) {
            const Bar& bar = bars_[i - 1];
            change = (bar.right - beside * change) * bar.inverse;
            beside = bar.beside;
            link[i - 1].lambda += change;
            px = change * bar.x, py = change * bar.y, pz = change * bar.z;
            x_ += px, y_ += py, z_ += pz;
        }
        const Many& mass = places_[i].w;
        x_ *= mass, y_ *= mass, z_ *= mass;
        for (int l = 0; l < lanes; ++l) {
            const Index k = 3 * at[i * lanes + static_cast<std::size_t>(l)];
            x[k] += lane(x_, l), x[k + 1] += lane(y_, l), x[k + 2] += lane(z_, l);
        }
    }
}
//! [solve]

}  // namespace rigid
