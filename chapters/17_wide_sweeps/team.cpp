#include "chapters/17_wide_sweeps/team.hpp"

#include <omp.h>

namespace rigid {

void run_members(int threads, void (*work)(void*, Member), void* data)
{
#pragma omp parallel num_threads(threads)
    work(data, {omp_get_thread_num(), omp_get_num_threads()});
}

void wait_for_team(Member member)
{
    if (member.members > 1) {
#pragma omp barrier
    }
}

}  // namespace rigid
