/// \file cloth_sleep.hpp
/// Cloths that rest are left out of the step.
///
///     part    what hangs together by rows, pins left out
///     sleeps  if no particle of it has been farther than `still` from where it was, for `time`
///     wakes   if anything that its step depends on changes, or comes near
///
/// The step is that of touching_step.hpp, of a scene that has the awake parts alone, in the same order: no method knows of sleep. What is awake has the same bits as
/// without sleep, unless the cloth has a thickness against itself: its pairs are found for all that is awake together.
#pragma once

#include "chapters/28_cloth_that_touches/touching_step.hpp"

namespace rigid {

/// A copy of it goes on with a copy of the cloth to the same bits.
class SleepingCloth {
public:
    Real still = 0.002;     ///< [m]
    Real time = 0.5;        ///< [s]; infinite: nothing sleeps
    TouchingMemory memory;  ///< of the parts that are awake
    // Counted since it was made.
    std::int64_t skipped = 0;  ///< particles that were left out, step by step
    int wakings = 0, sleeps = 0;

    /// A step. Throws std::invalid_argument as rigid::step() does, for a `still` or `time`
    /// that makes no sense, and for a cloth that may tear or has ties, or whose particles and rows are not the same as before without a
    /// change of `changes`.
    void step(TouchingCloth& cloth, const ClothSettings& settings);
    void wake();

    int parts() const { return static_cast<int>(parts_.size()); }
    int asleep() const;
    bool asleep(int particle) const
    {
        const auto p = static_cast<std::size_t>(particle);
        const int k = p < part_of_.size() ? part_of_[p] : -1;
        return k >= 0 && parts_[static_cast<std::size_t>(k)].asleep;
    }

private:
    struct Part {
        bool asleep = false,
             held = false;  ///< held: it bears a solid that can move
        Real rest = 0;      ///< since it was at its anchors [s]
        SolidBox box;       ///< of its particles
        Real fastest = 0;
    };
    void find_parts(const TouchingCloth& cloth);
    void look(const TouchingCloth& cloth, Real h);
    bool near_a_mover(const TouchingCloth& cloth, const Part& part, Real h) const;
    void gather(const TouchingCloth& cloth);
    void give_back(TouchingCloth& cloth, const ClothSettings& settings);

    std::vector<Part> parts_;
    std::vector<int> part_of_;  ///< of each particle; −1: pinned
    std::vector<std::vector<int>>
        pins_;                    ///< of each part, what its rows are held by
    TouchingCloth awake_;         ///< the parts that are awake
    std::vector<int> particles_;  ///< of `awake_`, in the whole cloth
    bool stale_ = true;
    int changes_ = -1;
    std::size_t rows_ = 0;
    VecX anchor_, x_, f_, solids_;  ///< as they were after the last step
    std::array<Real, 11> air_{};
    std::vector<ClothSolid> shapes_;
    std::vector<char> woken_;
};

}  // namespace rigid
