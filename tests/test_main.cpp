// main() of every test executable, and an operator new that counts where a NoAllocation lives.

#include "tests/counted_eigen.hpp"

#include <cstdlib>
#include <new>

#ifndef RIGID_ADDRESS_SANITIZER  // AddressSanitizer has its own operator new; there only Eigen's allocations are counted
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

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
int main(int argc, char** argv) { return Catch::Session().run(argc, argv); }
#else
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#endif
