/// \file team.hpp
/// Threads that share a piece of work and wait for each other.
///
/// OpenMP does it, where the compiler has it: the program links `rigid_team`, which is compiled from team.cpp. Without
/// it there is one member, and the same bits.
#pragma once

#include "common/jobs.hpp"

#include <atomic>
#include <type_traits>
#include <utility>

namespace rigid {

/// One of the threads that run the same work.
struct Member {
    int number = 0;   ///< 0 … members − 1
    int members = 1;  ///< as many as there are, perhaps fewer than asked for

    /// This one's share of the numbers first … end − 1.
    std::pair<int, int> share(int first, int end) const
    {
        const auto at = [&](int k) {
            return first + static_cast<int>(static_cast<long long>(end - first) *
                                            k / members);
        };
        return {at(number), at(number + 1)};
    }
};

/// Most threads of a team.
constexpr int most_threads = 64;

#ifdef RIGID_HAS_TEAM
/// Runs work(data, member) on so many threads at a time; returns when all are done.
void run_members(int threads, void (*work)(void*, Member), void* data);
/// Each member waits here until all of them have come.
void wait_for_team(Member member);
#else
inline void run_members(int, void (*work)(void*, Member), void* data)
{
    work(data, Member{});
}
inline void wait_for_team(Member) {}
#endif

/// The same for anything that can be called with a Member. It must not throw.
template <class Work>
void run_team(int threads, Work&& work)
{
    if (threads <= 1) return work(Member{});
    run_members(
        threads,
        [](void* data, Member member) {
            (*static_cast<std::remove_reference_t<Work>*>(data))(member);
        },
        &work);
}

//! [jobs]
/// Pieces for so many threads, each of which takes the next one.
inline Jobs jobs_of_team(int threads)
{
    return [threads](int count, const std::function<void(int)>& piece) {
        std::atomic<int> next = 0;
        run_team(threads, [&](Member) {
            for (int i = next++; i < count; i = next++) piece(i);
        });
    };
}
//! [jobs]

}  // namespace rigid
