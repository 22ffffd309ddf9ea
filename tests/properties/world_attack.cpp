// A random attack on the engine of chapter 19: small worlds with extreme numbers, 200 steps of each.
//
//     world_attack [--worlds N] [--first K] [--seed S] [--steps N] [--kind K] [--all]
//
// Prints the first world of which something is false and ends with 1; `--all` goes on and counts. World K of seed S is the
// same whatever came before it.
#include "common/text.hpp"
#include "tests/no_allocation.hpp"
#include "tests/properties/random_worlds.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>

#ifdef RIGID_ADDRESS_SANITIZER
#include <sanitizer/common_interface_defs.h>
#endif

namespace {

using namespace rigid;
using namespace rigid::properties;

struct Wanted {
    std::uint64_t worlds = 2000, first = 0, seed = 1, steps = 200;
    std::string kind;
    bool all = false;
};
Wanted wanted;
std::uint64_t now = 0;  // the world that is stepped; what dies says which it was

void say_which()
{
    std::fprintf(stderr, "\n# world %llu, seed %llu\n", static_cast<unsigned long long>(now),
                 static_cast<unsigned long long>(wanted.seed));
}

/// False, and a sentence, for what makes no sense.
bool parse(int argc, char** argv)
{
    const std::map<std::string, std::uint64_t*> numbers = {{"--worlds", &wanted.worlds},
                                                           {"--first", &wanted.first},
                                                           {"--seed", &wanted.seed},
                                                           {"--steps", &wanted.steps}};
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k], value = k + 1 < argc ? argv[k + 1] : "";
        const auto number = parse_whole(value);
        if (word == "--all") wanted.all = true;
        else if (numbers.count(word) && number) *numbers.at(word) = *number, ++k;
        else if (word == "--kind" &&
                 std::find(std::begin(world_kinds), std::end(world_kinds), value) != std::end(world_kinds))
            wanted.kind = value, ++k;
        else {
            std::cerr << "\"" << word << " " << value
                      << "\" is no option; there are --worlds N, --first K, --seed S, --steps N, --all and "
                         "--kind with "
                         "one of:";
            for (const auto kind : world_kinds) std::cerr << " \"" << kind << "\"";
            std::cerr << '\n';
            return false;
        }
    }
    return true;
}

}  // namespace

int main(int argc, char** argv)
{
    if (!parse(argc, argv)) return 2;
#ifdef RIGID_ADDRESS_SANITIZER
    __sanitizer_set_death_callback(say_which);
#endif
    std::signal(SIGABRT, [](int) { say_which(), std::_Exit(1); });
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::time_point since) {
        return std::chrono::duration<double>(Clock::now() - since).count();
    };
    WorldTally tally;
    std::uint64_t wrong = 0, slowest = 0;
    double longest = 0;
    const auto begin = Clock::now();
    const auto report = [&](std::FILE* to) {
        std::fprintf(
            to,
            "%lld worlds and %lld steps in %.0f s: %llu false, %lld calls refused, %lld bodies held, %lld "
            "steps unsolved, %lld worlds loaded; the longest took %.2f s (world %llu)\n",
            static_cast<long long>(tally.worlds), static_cast<long long>(tally.steps), seconds(begin),
            static_cast<unsigned long long>(wrong), static_cast<long long>(tally.refused),
            static_cast<long long>(tally.held), static_cast<long long>(tally.unsolved),
            static_cast<long long>(tally.loaded), longest, static_cast<unsigned long long>(slowest));
        std::fflush(to);
    };
    for (now = wanted.first; now < wanted.first + wanted.worlds; ++now) {
        const auto kind = static_cast<Index>(now % static_cast<std::uint64_t>(world_kind_count));
        if (!wanted.kind.empty() && world_kinds[kind] != wanted.kind) continue;
        Random random(wanted.seed * 1'000'003 + now);
        const auto since = Clock::now();
        std::string sentence;
        try {
            WorldAttack attack(kind, random, tally);
            sentence = attack(static_cast<int>(wanted.steps));
        } catch (const std::exception& thrown) {
            sentence = std::string("something throws: ") + thrown.what();
        }
        if (seconds(since) > longest) longest = seconds(since), slowest = now;
        if (now % 1000 == 999) report(stderr);
        if (sentence.empty()) continue;
        ++wrong;
        std::cout << "world " << now << " of seed " << wanted.seed << ", \"" << world_kinds[kind] << "\", "
                  << sentence << std::endl;
        if (!wanted.all) return 1;
    }
    report(stdout);
    return wrong == 0 ? 0 : 1;
}
