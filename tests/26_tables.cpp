/// Chapter 26: the tables of the text are what its program makes.

#include "tests/catch.hpp"
#include "tests/says.hpp"

#include "chapters/26_four_ways/program/who_can.hpp"

using namespace rigid;

TEST_CASE("the tables of who can do what are what the program makes", "[house]")
{
    for (const std::string& line : error_table(way_scenes(), 1.0 / 240)) {
        INFO(line);
        CHECK(says("chapters/26_four_ways/README.md", line));
    }
    for (const std::string& line : energy_table(way_scenes(), 1.0 / 240)) {
        INFO(line);
        CHECK(says("chapters/26_four_ways/in_depth.md", line));
    }
}
