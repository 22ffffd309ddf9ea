// The functions of pair_finder.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/12_contact_manifolds/pair_finder.hpp"

namespace rigid {

//! [find]
template <class Keep>
void PairFinder::find_in_tree(const Keep& keep)
{
    tree.tested = 0;
    fresh_.clear();
    for (const int k : renewed_)
        tree.overlapping(tree.leaf_of(k), [&](int b) {
            if (b != k && !(b < k && is(is_renewed_, b)) &&
                (is(asks, k) || is(asks, b)))
                fresh_.push_back(pair_key(k, b));
        });
    std::sort(fresh_.begin(), fresh_.end());
    std::erase_if(near_, [this](std::uint64_t pair) {
        const auto [a, b] = bodies_of(pair);
        return is(is_renewed_, a) || is(is_renewed_, b) ||
               !(is(asks, a) || is(asks, b));
    });
    merged_.resize(near_.size() + fresh_.size());
    std::merge(near_.begin(), near_.end(), fresh_.begin(), fresh_.end(),
               merged_.begin());
    near_.swap(merged_);
    for (const std::uint64_t pair : near_) {
        const auto [a, b] = bodies_of(pair);
        if (overlap(boxes[static_cast<std::size_t>(a)],
                    boxes[static_cast<std::size_t>(b)]))
            keep(a, b);
    }
    tested = tree.tested + static_cast<std::int64_t>(near_.size());
}
//! [find]

//! [find_in_grid]
template <class Keep>
void PairFinder::find_in_grid(const Keep& keep)
{
    grid.tested = grid.cells = 0;
    for (const int k : asked) {
        const auto at = static_cast<std::size_t>(k);
        grid.near(grid.position(k), circles[at], ~std::uint64_t{0}, [&](int b) {
            if ((b > k || !is(asks, b)) &&
                overlap(boxes[at], boxes[static_cast<std::size_t>(b)]))
                keep(std::min(k, b), std::max(k, b));
        });
    }
    tested = grid.tested;
}
//! [find_in_grid]

void PairFinder::find(const RigidScene& scene, const PlacedShapes& placed,
                      Real margin)
{
    movers_.clear();
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if (scene.bodies.can_move(k)) movers_.push_back(static_cast<int>(k));
    boxes.clear();
    find(scene, placed, margin, movers_);
}

void PairFinder::find(const RigidScene& scene, const PlacedShapes& placed,
                      Real margin, std::span<const int> looking)
{
    take_in(scene, placed, margin, looking);
    pairs.clear();
    const auto keep = [&](int a, int b) {
        if (may_touch(a, b)) pairs.push_back(pair_key(a, b));
    };
    if (search == PairSearch::sweep) {
        overlapping_pairs(boxes, sweep, [&](int a, int b) {
            if (is(asks, a) || is(asks, b)) keep(a, b);
        });
        tested = sweep.tested;
    } else if (search == PairSearch::tree) return find_in_tree(keep);  // ascending
    else find_in_grid(keep);
    std::sort(pairs.begin(), pairs.end());
}

void PairFinder::take_in(const RigidScene& scene, const PlacedShapes& placed,
                         Real margin, std::span<const int> looking)
{
    const auto K = static_cast<std::size_t>(scene.bodies.count());
    const bool all = boxes.size() != K || margin != margin_ || search != searched_,
               anew = is_renewed_.size() != K || search != searched_;
    searched_ = search;
    if (tree.count() > static_cast<int>(K)) tree.clear();  // some were taken away
    if (search == PairSearch::grid && circles.size() != K) {
        circles.assign(K, 0);
        grid.reset(scene.bodies.count(), 0);
    }
    tree.skin = skin * margin;
    margin_ = margin;
    const auto take = [&](std::size_t k) {
        boxes[k] = grown(placed.boxes[k], margin / 2 + reach_of(k));
        const Index body = scene.carrier(static_cast<Index>(k));
        moves[k] =
            scene.bodies.can_move(body) && scene.pushes(static_cast<Index>(k));
        if (!whole.empty()) whole[k] = body;
        if (search == PairSearch::grid)
            put_in_grid(scene, static_cast<Index>(k), margin);
        else if (search == PairSearch::tree &&
                 tree.place(static_cast<int>(k), boxes[k]))
            renew(static_cast<int>(k));
    };
    boxes.resize(K);
    moves.resize(K);
    asks.resize(K);
    if (!scene.carried.empty())
        for (auto k = static_cast<Index>(whole.size()); k < static_cast<Index>(K);
             ++k)
            whole.push_back(scene.carrier(k));
    if (anew) near_.clear();
    is_renewed_.resize(K);
    for (const int k : renewed_)
        if (static_cast<std::size_t>(k) < K)
            is_renewed_[static_cast<std::size_t>(k)] = 0;
    renewed_.clear();
    for (const int k : placed_)
        if (static_cast<std::size_t>(k) < K) renew(k);
    placed_.clear();
    for (const int k : looking)
        if (anew || !is(asks, k)) renew(k);
    for (const int k : asked)
        if (static_cast<std::size_t>(k) < K) asks[static_cast<std::size_t>(k)] = 0;
    asked.assign(looking.begin(), looking.end());
    for (const int k : asked) asks[static_cast<std::size_t>(k)] = 1;
    for (std::size_t k = 0; all && k < K; ++k) take(k);
    for (const int k : asked)
        if (!all) take(static_cast<std::size_t>(k));
    list_joints(scene);
}

void PairFinder::renew(int k)
{
    if (!std::exchange(is_renewed_[static_cast<std::size_t>(k)], 1))
        renewed_.push_back(k);
}

void PairFinder::put_in_grid(const RigidScene& scene, Index k, Real margin)
{
    const auto at = static_cast<std::size_t>(k);
    const Polygon& shape = scene.shapes[at];
    const Real circle =
        turning_radius(shape) + (shape.radius + margin / 2 + reach_of(at));
    const int body = static_cast<int>(k);
    const Vec2 x = scene.bodies.position(k).head<2>();
    if (circles[at] == circle) grid.move(body, x);
    else {
        if (circles[at] > 0) grid.remove(body);
        circles[at] = circle;
        grid.insert(body, x, circle, 0);
    }
}

void PairFinder::list_joints(const RigidScene& scene)
{
    std::size_t count = 0;
    bool same = true;
    for (const PointJoint& joint : scene.joints) {
        if (joint.a == world || joint.collides) continue;
        const std::uint64_t key = pair_key(joint.a, joint.b);
        if (count == joints.size()) joints.push_back(~key);
        same = same && joints[count] == key;
        joints[count++] = key;
    }
    same = same && count == joined.size();
    joints.resize(count);
    if (same) return;
    joined = joints;
    std::sort(joined.begin(), joined.end());
}

}  // namespace rigid
