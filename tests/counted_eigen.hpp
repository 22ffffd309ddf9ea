/// \file counted_eigen.hpp
/// Eigen as the tests compile it: an allocation where none is allowed is counted, and any other failed assertion of
/// Eigen ends the test. Included before Eigen (it is the first line of the tests' precompiled header).
#pragma once

#ifdef EIGEN_CORE_H
#error "tests/counted_eigen.hpp must be included before Eigen"
#endif

#include <cstdlib>

// Whether AddressSanitizer is in: it is known here, since what is counted depends on it.
#if defined(__SANITIZE_ADDRESS__)
#define RIGID_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RIGID_ADDRESS_SANITIZER
#endif
#endif

namespace rigid::allocation {
inline bool forbidden = false;
inline int count = 0;
}  // namespace rigid::allocation

#define EIGEN_RUNTIME_NO_MALLOC
#define eigen_assert(condition)                                                                              \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            if (!rigid::allocation::forbidden) std::abort();                                                 \
            ++rigid::allocation::count;                                                                      \
        }                                                                                                    \
    } while (false)

#include <Eigen/Core>
