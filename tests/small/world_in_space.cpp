/// The small program of chapter 25, sweeps side by side.

#include "tests/small/alone.hpp"

#include "tests/catch.hpp"

#define main small_main
namespace small25 {
#include "chapters/25_world_in_space/small.cpp"
}
#undef main

TEST_CASE("the small program of chapter 25 has the levels of the text and the same bits in both orders")
{
    const std::vector<small25::Contact> five = small25::five_rows();
    const int levels[] = {1, 2, 1, 3, 1};  // section 25.1
    for (std::size_t i = 0; i < five.size(); ++i) CHECK(five[i].level == levels[i]);

    small25::Balls one = small25::poured(60), other = one;
    int most = 0;
    for (int n = 0; n < 120; ++n) {
        const int sweeps = small25::step(one, 1.0 / 120, 0.2, 20, false);
        REQUIRE(sweeps == small25::step(other, 1.0 / 120, 0.2, 20, true));
        REQUIRE(one.x == other.x);
        REQUIRE(one.u == other.u);
        for (const small25::Contact& c : other.contacts) most = std::max(most, c.level);
    }
    const int touching = int(other.contacts.size());
    CHECK(touching > 60);  // they lie on each other
    CHECK(most > 2);
    CHECK(most < touching / 2);
}
