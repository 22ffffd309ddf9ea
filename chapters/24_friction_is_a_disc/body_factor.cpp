// The functions of body_factor.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/body_factor.hpp"

namespace rigid {

void BodyFactor::analyse(int bodies, std::span<const std::pair<int, int>> pairs)
{
    n_ = bodies;
    place_.assign(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_), -1);
    neighbours_.resize(std::max(neighbours_.size(), static_cast<std::size_t>(n_)));
    for (int i = 0; i < n_; ++i) near(i).clear();
    blocks_ = 0;
    for (int i = 0; i < n_; ++i) place(i, i) = blocks_++;
    for (const auto& [a, b] : pairs) join(a, b);
    order_.clear();
    done_.assign(static_cast<std::size_t>(n_), 0);
    for (int k = 0; k < n_; ++k) {
        int next = -1;
        for (int i = 0; i < n_; ++i)
            if (!done_[static_cast<std::size_t>(i)] &&
                (next < 0 || near(i).size() < near(next).size()))
                next = i;
        done_[static_cast<std::size_t>(next)] = 1;
        order_.push_back(next);
        // near(next) keeps those that are eliminated later
        for (const int i : near(next)) std::erase(near(i), next);
        for (std::size_t p = 0; p < near(next).size(); ++p)
            for (std::size_t q = p + 1; q < near(next).size(); ++q)
                join(near(next)[p], near(next)[q]);
    }
    block_.resize(std::max(block_.size(), static_cast<std::size_t>(blocks_)));
}

//! [factor]
void BodyFactor::factor(std::span<const ConeEquation> equations)
{
    for (int i = 0; i < blocks_; ++i) block_[static_cast<std::size_t>(i)].setZero();
    for (int i = 0; i < n_; ++i) at(i, i).setIdentity();
    for (const ConeEquation& r : equations) {
        const Real stiff = 1 / r.give;
        if (r.a >= 0) at(r.a, r.a).noalias() += (stiff * r.Wa) * r.Ja;
        if (r.b >= 0) at(r.b, r.b).noalias() += (stiff * r.Wb) * r.Jb;
        if (r.a < 0 || r.b < 0) continue;
        at(r.a, r.b).noalias() += (stiff * r.Wa) * r.Jb;
        at(r.b, r.a).noalias() += (stiff * r.Wb) * r.Ja;
    }
    for (const int k : order_) {
        Block& pivot = at(k, k);
        pivot = pivot.partialPivLu().inverse().eval();
        for (const int i : near(k)) {
            at(i, k) = (at(i, k) * pivot).eval();
            for (const int j : near(k)) at(i, j).noalias() -= at(i, k) * at(k, j);
        }
    }
}
//! [factor]

void BodyFactor::solve(VecX& x)
{
    for (const int k : order_)
        for (const int i : near(k))
            x.segment<6>(6 * i).noalias() -= at(i, k) * x.segment<6>(6 * k);
    for (auto k = order_.rbegin(); k != order_.rend(); ++k) {
        Vec<6> sum = x.segment<6>(6 * *k);
        for (const int j : near(*k))
            sum.noalias() -= at(*k, j) * x.segment<6>(6 * j);
        x.segment<6>(6 * *k).noalias() = at(*k, *k) * sum;
    }
}

}  // namespace rigid
