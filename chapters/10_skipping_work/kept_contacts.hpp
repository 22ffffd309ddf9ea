/// \file kept_contacts.hpp
/// Contacts that keep their normal while their two discs have hardly moved to each other.
///
///     d = x_b − x_a,  d0 as it was when the normal n was found:   while ‖d − d0‖ ≤ slack keep n, and
///     C_kept = C0 + nᵀ (d − d0),   0 ≤ C − C_kept ≤ slack² / (2 (‖d0‖ − slack)),   sin ∠ ≤ slack / ‖d0‖
///
/// (10.9). The error does not grow with time, and is on the safe side: a distance is never shorter than its tangent
/// says. Which contacts there are is decided by the exact test; only normal and gap are approximate.
#pragma once

#include "chapters/10_skipping_work/broad_phase.hpp"
#include "common/text.hpp"

#include <cstdint>
#include <vector>

namespace rigid {

/// Throws std::invalid_argument unless contacts can keep their rows while their discs have moved by less than this [m].
inline void require_row_slack(Real row_slack)
{
    if (!(row_slack >= 0) || !std::isfinite(row_slack))
        throw std::invalid_argument("row_slack is " + shortest(row_slack) +
                                    "; it must be zero or positive and finite");
}

struct KeptContacts {
    struct Found {
        std::uint64_t pair = 0;
        Vec2 d = {0, 0};       ///< d0 [m]
        Vec2 normal = {0, 1};  ///< then
        Real gap = 0;          ///< C0 [m]
    };
    std::vector<Found> now, before;  ///< of two discs, in their order
    /// of each contact: normal and bodies are those of the step before
    std::vector<std::uint8_t> kept;
    std::size_t walls = 0;  ///< contacts with walls in the step before
    /// the contacts are those of the step before, one for one
    bool same = false;
    /// normals of two discs that were kept in this step
    std::int64_t reused = 0;
};

/// awake_contacts() with normals that may be kept.
/// \param slack  how far two discs may have moved to each other [m]; positive
void keep_contacts(const DiscScene& scene, const AwakeSet& set, BroadPhase& broad,
                   Real slack, KeptContacts& memory,
                   std::vector<Contact>& contacts);

}  // namespace rigid
