/// The sentences whose numbers can be dragged on the site (docs/tools/sentences.py): the small programs give the numbers of
/// sentences.csv, to which docs/web/test/sentences.mjs holds what the pages compute.

#include "tests/small/sentences.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

namespace {

Numbers numbers(const std::string& text)
{
    Numbers found;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const auto equals = word.find('=');
        found[word.substr(0, equals)] = std::stod(word.substr(equals + 1));
    }
    return found;
}

}  // namespace

TEST_CASE("what can be dragged in a sentence follows as the small programs compute it")
{
    std::ifstream table(std::string(RIGID_SOURCE_DIR) + "/tests/small/sentences.csv");
    REQUIRE(table);
    const std::set<std::string> formulas{"generations", "masses", "pairs", "turned"};  // of the text alone
    std::set<std::string> seen;
    for (std::string line; std::getline(table, line);) {
        const auto one = line.find(';'), two = line.find(';', one + 1);
        const std::string model = line.substr(0, one);
        INFO(line);
        if (formulas.count(model)) continue;
        const auto found = Sentence::known().find(model);
        REQUIRE(found != Sentence::known().end());
        seen.insert(model);
        const Numbers in = numbers(line.substr(one + 1, two - one - 1)), page = numbers(line.substr(two + 1));
        Numbers own = found->second->values(in);
        for (const auto& [name, value] : page) {
            INFO(name << ": " << own[name]);
            REQUIRE(own.count(name) == 1);
            // not "near": what is no number must not pass
            CHECK(std::abs(own[name] - value) <= found->second->tolerance * std::max(1.0, std::abs(value)));
        }
    }
    CHECK(seen.size() == Sentence::known().size());
}
