/// \file no_allocation.hpp
/// Counts the memory that is asked for while a NoAllocation lives, by operator new and by malloc, which Eigen
/// calls; tests/test_main.cpp hears of it.
#pragma once

// Whether AddressSanitizer is in.
#if defined(__SANITIZE_ADDRESS__)
#define RIGID_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RIGID_ADDRESS_SANITIZER
#endif
#endif

namespace rigid {

namespace allocation {
inline thread_local bool forbidden = false;
inline thread_local int count = 0;

inline void asked()
{
    if (forbidden) ++count;
}
}  // namespace allocation

/// While it lives, every allocation of this thread is counted.
struct NoAllocation {
    NoAllocation()
    {
        allocation::count = 0;
        allocation::forbidden = true;
    }
    ~NoAllocation() { allocation::forbidden = false; }
    NoAllocation(const NoAllocation&) = delete;
    NoAllocation& operator=(const NoAllocation&) = delete;

    static int violations() { return allocation::count; }
};

}  // namespace rigid
