/// \file no_allocation.hpp
/// Counts the memory that is asked for while a NoAllocation lives: by operator new, and by Eigen, which asks
/// malloc. Include it first, in one source of a program: it replaces operator new and Eigen's assertion.
#pragma once

#include "tests/counted_eigen.hpp"

#include <cstdlib>
#include <new>

// AddressSanitizer has its own operator new; there only Eigen's allocations are counted.
#if defined(__SANITIZE_ADDRESS__)
#define RIGID_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RIGID_ADDRESS_SANITIZER
#endif
#endif
#ifndef RIGID_ADDRESS_SANITIZER
// Not inlined: else the compiler sees malloc() and delete meet and warns.
[[gnu::noinline]] void* operator new(std::size_t size)
{
    if (rigid::allocation::forbidden) ++rigid::allocation::count;
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

namespace rigid {

/// While it lives, every allocation of this thread is counted.
struct NoAllocation {
    NoAllocation()
    {
        allocation::count = 0;
        allocation::forbidden = true;
        Eigen::internal::set_is_malloc_allowed(false);
    }
    ~NoAllocation()
    {
        Eigen::internal::set_is_malloc_allowed(true);
        allocation::forbidden = false;
    }
    NoAllocation(const NoAllocation&) = delete;
    NoAllocation& operator=(const NoAllocation&) = delete;

    static int violations() { return allocation::count; }
};

}  // namespace rigid
