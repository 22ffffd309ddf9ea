/// Chapter 8: warm starting: a cache of impulses, steps that start from it, and what it costs.

// Memory that is asked for while a NoAllocation lives is counted: operator new below, Eigen's own by its
// check.
#include <cstdlib>
#include <new>
namespace {
bool allocation_forbidden = false;
int forbidden_allocations = 0;
}  // namespace
#define EIGEN_RUNTIME_NO_MALLOC
#define eigen_assert(condition)                                                                              \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            if (!allocation_forbidden) std::abort();                                                         \
            ++forbidden_allocations;                                                                         \
        }                                                                                                    \
    } while (false)

#include "chapters/08_warm_starting/impulse_cache.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"

#include <functional>
#include <map>
#include <numeric>

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
    if (allocation_forbidden) ++forbidden_allocations;
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

using namespace rigid;

namespace {

/// While it lives, every allocation of this thread is counted.
struct NoAllocation {
    NoAllocation()
    {
        forbidden_allocations = 0;
        allocation_forbidden = true;
        Eigen::internal::set_is_malloc_allowed(false);
    }
    ~NoAllocation()
    {
        Eigen::internal::set_is_malloc_allowed(true);
        allocation_forbidden = false;
    }
    static int violations() { return forbidden_allocations; }
};

std::string sentence_of(const std::function<void()>& act)
{
    try {
        act();
    } catch (const std::invalid_argument& refused) {
        return refused.what();
    }
    return "accepted";
}

VecX numbers(std::initializer_list<Real> values)
{
    VecX v(static_cast<Index>(values.size()));
    Index i = 0;
    for (const Real value : values) v[i++] = value;
    return v;
}

/// The keys of contacts of disc b with wall w, given as pairs.
std::vector<ImpulseKey> keys_of(const std::vector<std::array<Index, 3>>& contacts)
{
    std::vector<ImpulseKey> keys;
    for (const auto& [a, b, feature] : contacts) {
        Contact contact;
        contact.a = a;
        contact.b = b;
        contact.feature = feature;
        keys.push_back(contact_key(contact));
    }
    return keys;
}

void shuffle(std::vector<ImpulseKey>& keys, Random& random)
{
    for (std::size_t i = keys.size(); i > 1; --i)
        std::swap(keys[i - 1], keys[static_cast<std::size_t>(random.index(static_cast<Index>(i)))]);
}

}  // namespace

// ---- the cache --------------------------------------------------------------------------------------------

TEST_CASE("a row finds its impulse whatever its number is today")
{
    ImpulseCache cache;
    store(cache, keys_of({{0, 1, 0}, {1, 2, 0}, {world, 0, 0}, {world, 0, 1}}), numbers({1, 2, 3, 4}), 0.01);
    VecX lambda;
    load(cache, keys_of({{world, 0, 1}, {5, 6, 0}, {0, 1, 0}, {world, 0, 0}}), 0.01, lambda);
    CHECK(lambda == numbers({4, 0, 1, 3}));
    CHECK(cache.found == 3);
}

TEST_CASE("a joint and a contact of the same numbers are two rows")
{
    ImpulseCache cache;
    const std::vector<ImpulseKey> keys{joint_key(0), joint_key(1), joint_key(1, 1),
                                       contact_key({world, 0, {0, 1}, 0, 0}),
                                       contact_key({0, 1, {1, 0}, 0, 0})};
    store(cache, keys, numbers({1, 2, 3, 4, 5}), 0.01);
    VecX lambda;
    load(cache, keys, 0.01, lambda);
    CHECK(lambda == numbers({1, 2, 3, 4, 5}));
}

TEST_CASE("an impulse is a force times h: another step scales it as in (8.4)")
{
    ImpulseCache cache;
    const std::vector<ImpulseKey> keys = keys_of({{0, 1, 0}});
    store(cache, keys, numbers({6}), 0.02);
    VecX lambda;
    load(cache, keys, 0.005, lambda);
    CHECK(lambda[0] == Approx(1.5).epsilon(1e-15));
    load(cache, keys, 0.02, lambda);
    CHECK(lambda[0] == 6);  // the factor is exactly 1
}

TEST_CASE("a row that goes is forgotten or outlives its absence by as many steps as asked for")
{
    const std::vector<ImpulseKey> both = keys_of({{0, 1, 0}, {1, 2, 0}}), one = keys_of({{1, 2, 0}});
    for (const int keep : {0, 1, 3}) {
        for (int absent = 1; absent <= 5; ++absent) {
            ImpulseCache cache;
            cache.keep = keep;
            store(cache, both, numbers({7, 8}), 0.01);
            for (int k = 0; k < absent; ++k) store(cache, one, numbers({8}), 0.01);
            VecX lambda;
            load(cache, both, 0.01, lambda);
            CHECK(lambda == numbers({absent <= keep ? 7.0 : 0.0, 8}));
        }
    }
}

TEST_CASE("what is remembered of an absent row is scaled with each step's h")
{
    ImpulseCache cache;
    cache.keep = 5;
    store(cache, keys_of({{0, 1, 0}}), numbers({8}), 0.08);
    store(cache, {}, numbers({}), 0.04);
    store(cache, {}, numbers({}), 0.01);
    VecX lambda;
    load(cache, keys_of({{0, 1, 0}}), 0.02, lambda);
    CHECK(lambda[0] == Approx(2).epsilon(1e-14));
}

TEST_CASE("the cache agrees with a dictionary on random rows that come and go and change order")
{
    Random random(8);
    ImpulseCache cache;
    std::map<ImpulseKey, Real> dictionary;
    VecX lambda;
    for (int step = 0; step < 300; ++step) {
        std::vector<ImpulseKey> keys;
        for (std::int32_t a = -2; a < 8; ++a)
            for (std::int32_t b = a + 1; b < 8; ++b)
                if (b >= 0 && random.uniform() < 0.6) keys.push_back({a, b, 0});
        if (step % 3 != 0) shuffle(keys, random);
        load(cache, keys, 1, lambda);
        int found = 0;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const auto known = dictionary.find(keys[i]);
            found += known != dictionary.end();
            REQUIRE(lambda[static_cast<Index>(i)] == (known == dictionary.end() ? 0 : known->second));
        }
        REQUIRE(cache.found == found);
        dictionary.clear();
        for (std::size_t i = 0; i < keys.size(); ++i)
            dictionary[keys[i]] = lambda[static_cast<Index>(i)] = random.normal();
        store(cache, keys, lambda, 1);
    }
}

TEST_CASE("rows in yesterday's order are found without a search")
{
    std::vector<ImpulseKey> keys;
    for (std::int32_t k = 0; k < 100; ++k) keys.push_back({k, k + 1, 0});
    ImpulseCache cache;
    VecX lambda = VecX::Ones(100);
    store(cache, keys, lambda, 1);
    load(cache, keys, 1, lambda);
    CHECK(cache.searched == 0);
    keys.erase(keys.begin() + 50);  // a contact goes: one search, then in step again
    load(cache, keys, 1, lambda);
    CHECK(cache.searched == 1);
    CHECK(cache.found == 99);
}

TEST_CASE("what is not finite is not remembered and a key that occurs twice is refused")
{
    const std::vector<ImpulseKey> keys = keys_of({{0, 1, 0}, {1, 2, 0}, {2, 3, 0}});
    ImpulseCache cache;
    store(cache, keys, numbers({1, std::nan(""), -infinity}), 1);
    VecX lambda;
    load(cache, keys, 1, lambda);
    CHECK(lambda == numbers({1, 0, 0}));
    CHECK(sentence_of([&] {
              store(cache, keys_of({{0, 1, 0}, {2, 3, 4}, {0, 1, 0}}), numbers({1, 2, 3}), 1);
          }) == "two rows have the key 0, 1, 0");
    CHECK(sentence_of([&] { store(cache, keys, numbers({1}), 1); }) == "there are 3 keys for 1 impulses");
}

TEST_CASE("the cache asks for no memory once it has seen so many rows")
{
    Random random(1);
    std::vector<ImpulseKey> keys;
    for (std::int32_t k = 0; k < 1000; ++k) keys.push_back({k, k + 1, 0});
    ImpulseCache cache;
    cache.keep = 1;
    VecX lambda = VecX::Ones(1000);
    store(cache, keys, lambda, 1);
    store(cache, {}, numbers({}), 1);
    store(cache, keys, lambda, 1);
    for (int k = 0; k < 3; ++k) {
        const NoAllocation guard;
        load(cache, keys, 1, lambda);
        store(cache, keys, lambda, 1);
        shuffle(keys, random);
    }
    CHECK(NoAllocation::violations() == 0);
}
