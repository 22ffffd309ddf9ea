// main() of every test executable, and the ear for each allocation: under AddressSanitizer a hook of its own, with glibc a
// malloc that stands before the one of the library (operator new calls it), elsewhere an operator new.

#include "tests/no_allocation.hpp"

#include <cstdlib>
#include <new>

#if defined(RIGID_ADDRESS_SANITIZER)
// of the library that g++ links; not every compiler brings its header
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void*, std::size_t),
                                                         void (*)(const volatile void*));
[[maybe_unused]] static const int heard = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { rigid::allocation::asked(); }, [](const volatile void*) {});
#elif defined(__GLIBC__)
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);

void* malloc(std::size_t size)
{
    rigid::allocation::asked();
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size)
{
    rigid::allocation::asked();
    return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size)
{
    rigid::allocation::asked();
    return __libc_realloc(memory, size);
}
}
#else
// Not inlined: else the compiler sees malloc() and delete meet and warns.
[[gnu::noinline]] void* operator new(std::size_t size)
{
    rigid::allocation::asked();
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
