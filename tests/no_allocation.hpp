/// \file no_allocation.hpp
/// Counts the memory that is asked for while a NoAllocation lives: by operator new, and by Eigen, which asks
/// malloc. Include it before Eigen, whose assertion it replaces; operator new is that of tests/test_main.cpp.
#pragma once

#include "tests/counted_eigen.hpp"

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
