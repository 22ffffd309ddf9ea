/// The rules of the house: who may include whom, what physics must not know, what each chapter has.

#include "tests/catch.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct Source {
    std::string path;  ///< relative to the root, with forward slashes
    std::string text;
};

std::string read(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Every header and source file below the folders of the book.
std::vector<Source> all_sources()
{
    const fs::path root = RIGID_SOURCE_DIR;
    std::vector<Source> sources;
    for (const char* folder : {"common", "chapters"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".hpp" || extension == ".cpp")
                sources.push_back({fs::relative(entry.path(), root).generic_string(), read(entry.path())});
        }
    std::sort(sources.begin(), sources.end(),
              [](const Source& a, const Source& b) { return a.path < b.path; });
    return sources;
}

std::vector<std::string> includes(const std::string& text)
{
    static const std::regex line(R"(#\s*include\s*[<"]([^>"]+)[>"])");
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), line), end; match != end; ++match)
        found.push_back((*match)[1]);
    return found;
}

/// The chapter that a path belongs to, 0 for none.
int chapter_of(const std::string& path)
{
    std::smatch match;
    static const std::regex chapter(R"(^(?:chapters/)?(\d\d)_)");
    return std::regex_search(path, match, chapter) ? std::stoi(match[1]) : 0;
}

bool starts_with(const std::string& text, const std::string& head) { return text.rfind(head, 0) == 0; }

/// Physics: every file of common/ and the chapters but programs, benchmarks and canvases.
bool is_physics(const std::string& path)
{
    for (const char* part : {"common/program/", "/program/", "/benchmark/", "canvas", "common/picture"})
        if (path.find(part) != std::string::npos) return false;
    return true;
}

/// The sentences that a source breaks the rules by.
std::vector<std::string> broken_rules(const Source& source)
{
    std::vector<std::string> broken;
    const int own = chapter_of(source.path);
    for (const std::string& included : includes(source.text)) {
        const int other = chapter_of(included);
        if (other > 0 && own == 0) broken.push_back(source.path + " is common and includes " + included);
        if (other > own && own > 0) broken.push_back(source.path + " includes the later chapter " + included);
        if (is_physics(source.path)) {
            for (const char* unwanted : {"iostream", "cstdio", "stdio.h", "chrono", "ctime", "time.h"})
                if (included == unwanted)
                    broken.push_back(source.path + " is physics and includes " + included);
            if (included.find("canvas") != std::string::npos || starts_with(included, "common/program/"))
                broken.push_back(source.path + " is physics and includes " + included);
        }
    }
    const auto lines = std::count(source.text.begin(), source.text.end(), '\n');
    if (source.path.ends_with(".hpp") && lines > 220)
        broken.push_back(source.path + " has " + std::to_string(lines) + " lines: two ideas?");
    return broken;
}

}  // namespace

TEST_CASE("no source breaks a rule of the house")
{
    const std::vector<Source> sources = all_sources();
    REQUIRE(sources.size() > 10);
    for (const Source& source : sources)
        for (const std::string& sentence : broken_rules(source)) FAIL_CHECK(sentence);
}

TEST_CASE("the rules of the house notice what they are for")
{
    const auto count = [](const std::string& path, const std::string& text) {
        return broken_rules({path, text}).size();
    };
    CHECK(count("chapters/02_b/b.hpp", "#include \"chapters/03_c/c.hpp\"\n") == 1);
    CHECK(count("chapters/02_b/b.hpp", "#include \"chapters/01_a/a.hpp\"\n#include \"common/math.hpp\"\n") ==
          0);
    CHECK(count("common/contact.hpp", "#include \"chapters/01_a/a.hpp\"\n") == 1);
    CHECK(count("chapters/04_d/d.hpp", "#include <chrono>\n") == 1);
    CHECK(count("chapters/04_d/d.hpp", "#include \"common/canvas.hpp\"\n") == 1);
    CHECK(count("chapters/04_d/program/main.cpp",
                "#include \"common/program/program.hpp\"\n#include <iostream>\n") == 0);
    CHECK(count("common/measure.cpp", "#include <iostream>\n") == 1);
    CHECK(count("chapters/04_d/d.hpp", std::string(300, '\n')) == 1);
}

TEST_CASE("each chapter has its text and its program and its benchmark and its figures and its tests")
{
    const fs::path root = RIGID_SOURCE_DIR;
    int chapters = 0;
    for (const auto& entry : fs::directory_iterator(root / "chapters")) {
        if (!entry.is_directory()) continue;
        const std::string name = entry.path().filename().string();
        ++chapters;
        INFO(name);
        CHECK(std::regex_match(name, std::regex(R"(\d\d_[a-z0-9_]+)")));
        for (const char* file :
             {"README.md", "program/main.cpp", "benchmark/benchmark.cpp", "figures/draw.sh"})
            CHECK(fs::exists(entry.path() / file));
        CHECK(fs::exists(root / "tests" / (name + ".cpp")));
        const fs::directory_iterator figures(entry.path() / "figures");
        CHECK(std::any_of(begin(figures), end(figures),
                          [](const auto& figure) { return figure.path().extension() == ".svg"; }));
    }
    CHECK(chapters >= 4);
}
