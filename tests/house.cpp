/// The rules of the house: what may include what, what physics must not know, what each chapter has.

#include "tests/catch.hpp"
#include "tests/draws.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;
namespace draws = rigid::draws;

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
    for (const char* part :
         {"common/program/", "/program/", "/benchmark/", "canvas", "common/draw_list", "common/picture"})
        if (path.find(part) != std::string::npos) return false;
    return true;
}

/// A chapter's whole method in one file, which stands alone (./book small N).
bool is_small(const std::string& path) { return path.ends_with("/small.cpp"); }

/// The rules of a small program: Eigen and the standard library, and so short that it can be held in the head.
std::vector<std::string> broken_small_rules(const Source& source)
{
    std::vector<std::string> broken;
    for (const std::string& included : includes(source.text))
        if (!starts_with(included, "Eigen/") && included.find_first_of("./") != std::string::npos)
            broken.push_back(source.path + " stands alone and includes " + included);
    const int own = chapter_of(source.path);
    const int most = own <= 8 ? 150 : own <= 19 ? 200 : 250;
    std::istringstream text(source.text);
    int count = 0;
    for (std::string line; std::getline(text, line);) {
        ++count;
        const auto letters =
            std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
        if (letters > 84)
            broken.push_back(source.path + ":" + std::to_string(count) + " has " + std::to_string(letters) +
                             " columns of 84");
    }
    if (count > most)
        broken.push_back(source.path + " has " + std::to_string(count) + " lines of " + std::to_string(most));
    static const std::regex first(
        R"(^// Chapter (\d+) in one file(?:: |, grown from chapter (\d+): ).+\.\n)");
    std::smatch match;
    if (!std::regex_search(source.text, match, first) || std::stoi(match[1]) != own ||
        (own > 1 && !match[2].matched) || (match[2].matched && std::stoi(match[2]) >= own))
        broken.push_back(source.path + " does not begin as \"// Chapter " + std::to_string(own) +
                         " in one file, grown from chapter …: what it is.\"");
    return broken;
}

/// The sentences that a source breaks the rules by.
std::vector<std::string> broken_rules(const Source& source)
{
    if (is_small(source.path)) return broken_small_rules(source);
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
    // A benchmark may time the C library or hand it to a peer.
    static const std::regex library(
        R"(std::(a?sinh?|a?cosh?|a?tanh?|atan2|exp2?|expm1|log2?|log10|log1p|pow|hypot|cbrt)\()");
    std::smatch call;
    if (source.path.find("/benchmark/") == std::string::npos && std::regex_search(source.text, call, library))
        broken.push_back(source.path + " calls " + call[0].str() +
                         ") whose last bits no standard fixes; common/elementary.hpp has its own");
    // Its own comment stands behind a member or above it. With both, the one above is its neighbour's.
    static const std::regex both(R"(\n *///(?!<)[^\n]*\n *(\w[^\n]*?) *///<)");
    std::smatch member;
    if (std::regex_search(source.text, member, both))
        broken.push_back(source.path + " has a comment above \"" + member[1].str() + "\" and one behind it");
    const auto lines = std::count(source.text.begin(), source.text.end(), '\n');
    const bool narrow = source.path.starts_with("chapters/");  // 84 columns, so a tenth more lines
    if (source.path.ends_with(".hpp") && lines > (narrow ? 245 : 220))
        broken.push_back(source.path + " has " + std::to_string(lines) + " lines: two ideas?");
    return broken;
}

/// The names under which std::to_string(float, double, long double) stands in an object file of libstdc++ and of
/// libc++. std::to_string prints six digits behind the point: a step of 1e-9 s becomes "0.000000".
bool prints_a_real_by_to_string(const std::string& object)
{
    // In halves: this file is among those that are looked through.
    const std::string gnu = "__to_", clang = "9to_string";
    for (const std::string& name : {gnu + "xstring", clang + "Ef", clang + "Ed", clang + "Ee"})
        if (object.find(name) != std::string::npos) return true;
    return false;
}

/// The first function of the C library that an object file calls and whose last bits no standard fixes; nothing if none. By
/// these names they are in its table of names. A source that forgets common/elementary.hpp calls them by the bare name.
std::string elementary_call(const std::string& object)
{
    for (const char* name : {"sin",  "cos",   "sincos", "tan",  "asin",  "acos", "atan", "atan2", "sinh",
                             "cosh", "tanh",  "exp",    "exp2", "expm1", "log",  "log2", "log10", "log1p",
                             "pow",  "hypot", "cbrt",   "sinf", "cosf",  "powf", "expf", "logf"})
        if (object.find('\0' + std::string(name) + '\0') != std::string::npos) return name;
    return {};
}

/// The text without comments, strings, characters and the preprocessor's lines.
std::string bare(const std::string& text)
{
    std::string kept;
    for (std::size_t at = 0; at < text.size();) {
        if (text.compare(at, 2, "//") == 0) {
            at = std::min(text.find('\n', at), text.size());
        } else if (text.compare(at, 2, "/*") == 0) {
            at = std::min(text.find("*/", at), text.size() - 2) + 2;
        } else if (text[at] == '"' || (text[at] == '\'' && (at == 0 || !std::isalnum(text[at - 1])))) {
            const char quote = text[at++];
            while (at < text.size() && text[at] != quote) at += text[at] == '\\' ? 2 : 1;
            ++at;
        } else if (text[at] == '#') {
            while (at < text.size() && text[at] != '\n') at += text[at] == '\\' ? 2 : 1;
        } else {
            kept += text[at++];
        }
    }
    return kept;
}

/// The types that a header defines outside of functions and other types, with the namespaces around them; not those that
/// are specialised from a template.
std::vector<std::string> defined_types(const std::string& text)
{
    static const std::regex space(R"(\bnamespace\s*([\w:]*)\s*$)");
    static const std::regex type(
        R"(\b(?:struct|class|union|enum(?:\s+class|\s+struct)?)\s+(?:(?:\[\[[^\]]*\]\]|alignas\s*\([^)]*\))\s*)?)"
        R"(([\w:]+)\s*(?:final\s*)?(?::[^;]*)?$)");
    const std::string code = bare(text);
    std::vector<std::string> around, found;  // "-" for what is no namespace
    std::size_t last = 0;
    for (std::size_t at = 0; at < code.size(); ++at) {
        if (code[at] != '{' && code[at] != '}' && code[at] != ';') continue;
        std::string head = code.substr(last, at - last);
        head.erase(head.find_last_not_of(" \n\t") + 1);
        last = at + 1;
        std::smatch match;
        if (code[at] == '}' && !around.empty()) around.pop_back();
        if (code[at] != '{') continue;
        if (std::regex_search(head, match, space)) {
            around.push_back(match[1]);
            continue;
        }
        if (std::find(around.begin(), around.end(), "-") == around.end() &&
            std::regex_search(head, match, type)) {
            std::string& name = found.emplace_back();
            for (const std::string& one : around) name += one + "::";
            name += match[1];
        }
        around.emplace_back("-");
    }
    return found;
}

/// The names of test cases and sections in a test's source; pieces of one string are joined.
std::vector<std::string> test_names(const std::string& text)
{
    static const std::regex begin(R"((?:TEST_CASE|SECTION)\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+))");
    static const std::regex piece(R"x("((?:[^"\\]|\\.)*)")x");
    std::vector<std::string> names;
    for (std::sregex_iterator found(text.begin(), text.end(), begin), end; found != end; ++found) {
        const std::string pieces = (*found)[1];
        std::string& name = names.emplace_back();
        for (std::sregex_iterator part(pieces.begin(), pieces.end(), piece); part != end; ++part)
            name += (*part)[1];
    }
    return names;
}

/// What a test's name must not have: Catch 2.13 prints a failing test whose name has ": " so that its further lines
/// begin below what follows the colon; where that is at the end of the line it prints without end. The others mean
/// something where a test is chosen by its name.
bool is_safe_name(const std::string& name)
{
    return name.find(": ") == std::string::npos && name.find_first_of("#[,*\\") == std::string::npos;
}

}  // namespace

TEST_CASE("no source prints a Real by std::to_string")
{
    // Whether `n` in std::to_string(n) is a Real is seen by the compiler alone: so what it made is looked through.
    std::istringstream list(read(RIGID_OBJECTS));
    int looked_through = 0;
    for (std::string path; std::getline(list, path);) {
        if (!fs::exists(path)) continue;  // not built
        const auto is = [&path](const char* end) { return path.ends_with(end); };
        if (path.ends_with(".gch") || path.ends_with(".pch")) continue;  // headers, used or not
        if (is("program/command_line.cpp.o") || is("stress/stress.cpp.o") ||
            is("run_time_against_error.cpp.o"))
            continue;  // CLI11 does so within
        ++looked_through;
        if (prints_a_real_by_to_string(read(path)))
            FAIL_CHECK(path + " prints a Real by std::to_string; shortest() of common/text.hpp is the way");
    }
    CHECK(looked_through >= 3);  // this one, and what it stands on
}

TEST_CASE("an object file that prints a Real by std::to_string is noticed")
{
    const fs::path folder = fs::temp_directory_path() / "rigid_to_string";
    fs::create_directories(folder);
    const auto compiled = [&](const std::string& name, const std::string& type) {
        const fs::path source = folder / (name + ".cpp"), object = folder / (name + ".o");
        std::ofstream(source) << "#include <string>\nstd::string f(" << type
                              << " x) { return std::to_string(x); }\n";
        const std::string command =
            RIGID_COMPILER " -O2 -c \"" + source.string() + "\" -o \"" + object.string() + "\"";
        REQUIRE(std::system(command.c_str()) == 0);
        return read(object);
    };
    CHECK(prints_a_real_by_to_string(compiled("real", "double")));
    CHECK_FALSE(prints_a_real_by_to_string(compiled("whole", "long")));
    fs::remove_all(folder);
}

TEST_CASE("no program and no physics calls an elementary function of the C library")
{
    std::istringstream list(read(RIGID_OBJECTS));
    int looked_through = 0;
    for (std::string path; std::getline(list, path);) {
        const bool book = path.find("/rigid_base.dir/") != std::string::npos ||
                          path.find("/rigid_factors.dir/") != std::string::npos ||
                          path.find("/rigid_chapter_") != std::string::npos ||
                          path.find("/program/main.cpp") != std::string::npos;
        if (!book || path.ends_with(".gch") || path.ends_with(".pch") || !fs::exists(path)) continue;
        const std::string object = read(path);
        if (object.find(".debug_str") != std::string::npos)
            return;  // there all names are, not those of calls alone
        ++looked_through;
        const std::string name = elementary_call(object);
        if (!name.empty()) FAIL_CHECK(path + " calls " + name + "(); is common/elementary.hpp included?");
    }
    CHECK(looked_through >= 20);  // the library's own
    CHECK(elementary_call(std::string("\0_ZN5rigid3sinEd\0ldexp\0", 23)).empty());
    CHECK(elementary_call(std::string("\0ldexp\0sincos\0", 14)) == "sincos");
}

TEST_CASE("no source has two random draws in one argument list")
{
    // g++ draws the last argument first, clang++ the first: they would build different scenes.
    const fs::path root = RIGID_SOURCE_DIR;
    int files = 0, with_draws = 0;
    for (const char* folder : {"common", "chapters", "tests", "docs/results"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".hpp" && extension != ".cpp") continue;
            const std::string text = read(entry.path());
            ++files;
            if (text.find("random.uniform(") != std::string::npos) ++with_draws;
            for (const int line : draws::unordered(text))
                FAIL_CHECK(fs::relative(entry.path(), root).generic_string()
                           << ":" << line
                           << " leaves the order of two draws to the compiler; name them first");
        }
    CHECK(files > 100);
    CHECK(with_draws > 10);
}

TEST_CASE("two random draws whose order is open are noticed and those in order are not")
{
    const auto found = [](const std::string& line) {
        return draws::unordered("void f(Random& r)\n{\n" + line + "\n}\n").size();
    };
    for (const char* line :
         {"Vec2 p(random.uniform(-1, 1), random.uniform());", "v = Vec2(r.normal(), r.normal());",
          "return make(1, {x + random.uniform(), y}, random.uniform());",
          "x = random.normal() * random.uniform();",
          "x = random.normal() * std::pow(10, random.uniform(-3, 3));", "f(g(random), h(random));",
          "f(draw(n, r), r.index(3) < 2 ? 0 : 1);",
          "const auto any = [&] { return random.normal(); };\nh(any(), any());",
          "Vec2 p = s * Vec2(random.uniform(-a, a) * b,\n  random.uniform(-b, b) / a);",
          "g(random->index(2), random->index(2));"}) {
        CAPTURE(line);
        CHECK(found(line) >= 1);
    }
    for (const char* line :
         {"const Real y = random.uniform(), x = random.uniform();",
          "Vec2 p{random.uniform(), random.uniform()};", "x = random.uniform() < 0.5 ? 0 : random.normal();",
          "if (random.uniform() < 0.5 && random.index(2) == 0) g();",
          "B << random.normal(), random.normal();", "f(random, n, 1 + random.index(n));",
          "for (Index n = random.index(3); n < random.index(9); ++n) g(random);",
          "f([&] { return random.normal(); }, [&] { return random.normal(); });",
          "f(random.uniform(low, high), x); g(random.uniform());", "// f(random.normal(), random.normal())",
          "f(\"random.normal(), random.normal()\");",
          "wave = {a, random.uniform(0.85, 1.15) / b, random.uniform(0, 2 * pi)};"}) {
        CAPTURE(line);
        CHECK(found(line) == 0);
    }
}

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
    CHECK(count("chapters/04_d/d.hpp", "x = std::sin(a);\n") == 1);
    CHECK(count("chapters/04_d/benchmark/d.hpp", "x = std::sin(a);\n") == 0);
    CHECK(count("common/d.hpp", "x = sin(a) + std::sqrt(a);\n") == 0);
    const std::string first = "// Chapter 4 in one file, grown from chapter 3: rows.\n";
    CHECK(count("chapters/04_d/small.cpp",
                first + "#include <Eigen/Core>\n#include <cstdio>\nx = std::sin(a);\n") == 0);
    CHECK(count("chapters/04_d/small.cpp", first + "#include \"chapters/04_d/d.hpp\"\n") == 1);
    CHECK(count("chapters/04_d/small.cpp", first + "#include \"d.hpp\"\n") == 1);
    CHECK(count("chapters/04_d/small.cpp", first + std::string(150, '\n')) == 1);
    CHECK(count("chapters/09_d/small.cpp",
                "// Chapter 9 in one file, grown from chapter 8: sets.\n" + std::string(150, '\n')) == 0);
    CHECK(count("chapters/04_d/small.cpp", first + "// " + std::string(82, 'x') + "\n") == 1);
    CHECK(count("chapters/04_d/small.cpp", "// Chapter 4 in one file: rows.\n") == 1);
    CHECK(count("chapters/04_d/small.cpp", "// Chapter 4 in one file, grown from chapter 5: rows.\n") == 1);
    CHECK(count("chapters/01_d/small.cpp", "// Chapter 1 in one file: springs.\n") == 0);
    CHECK(count("common/d.hpp", "{\n    /// of b\n    a,  ///< of a\n    b,\n") == 1);
    CHECK(count("common/d.hpp", "{\n    a,  ///< of a\n    /// of b\n    b,\n    c  ///< of c\n") == 0);
}

TEST_CASE("no two headers define a type of one name")
{
    // Two types of one name in one program are undefined behaviour that no compiler and no linker reports.
    std::map<std::string, std::string> homes;
    for (const Source& source : all_sources()) {
        if (!source.path.ends_with(".hpp")) continue;
        for (const std::string& name : defined_types(source.text)) {
            const auto [home, is_new] = homes.emplace(name, source.path);
            if (!is_new) FAIL_CHECK(source.path << " defines " << name << ", and so does " << home->second);
        }
    }
    CHECK(homes.size() > 500);
    CHECK(homes.count("rigid::World") == 1);
}

TEST_CASE("the types that a header defines are found")
{
    using Names = std::vector<std::string>;
    CHECK(defined_types(
              "namespace rigid {\nstruct A { struct B { int i; }; };\nclass C final : public A {\n};\n"
              "enum class D : int { e };\nnamespace own { template <class T = int> struct E { T t; }; }\n}\n"
              "struct F {};\n") == Names{"rigid::A", "rigid::C", "rigid::D", "rigid::own::E", "F"});
    CHECK(
        defined_types(
            "struct A;\n// struct B {\nclass C* f(struct D d) { struct E { } e; return g(\"struct F {\"); }\n"
            "#define G struct G {\ntemplate <> struct H<int> { };\nstruct I* i = new J{};\n"
            "enum K f(char c = '{') { return {}; }\n")
            .empty());
}

TEST_CASE("no name of a test holds what makes Catch print without end or choose other tests")
{
    std::size_t names = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(RIGID_SOURCE_DIR) / "tests")) {
        if (entry.path().extension() != ".cpp") continue;
        for (const std::string& name : test_names(read(entry.path()))) {
            INFO(entry.path().filename().string());
            if (!is_safe_name(name)) FAIL_CHECK(name);
            ++names;
        }
    }
    CHECK(names > 400);
    // It notices what it is for.
    CHECK(test_names("TEST_CASE(\"one \"\n    \"two\")\n  SECTION(\"three\")\n") ==
          std::vector<std::string>{"one two", "three"});
    for (const char* name : {"a thing\x3a its test", "a, b", "the [first]", "number #3"})
        CHECK(!is_safe_name(name));
    CHECK(is_safe_name("Newton's cradle with e = 1 (6.19) at 10:30"));
}

TEST_CASE("one runner takes the steps of all scenes of discs and no program has state to share by protected "
          "members")
{
    // Three balls at once, each with its own e, a body without discs, bodies that turn or touch, and water: these are no DiscScene.
    const std::vector<std::string> others = {
        "scene_bounce.hpp", "scene_one_row.hpp", "rigid_run.hpp", "manifold_run.hpp", "friction_run.hpp",
        "joint_run.hpp",    "soft_run.hpp",      "wide_run.hpp",  "island_run.hpp",   "space_run.hpp",
        "cloth_run.hpp",    "dam_run.hpp",       "pond_run.hpp",  "tree_run.hpp",     "basin_run.hpp"};
    int runners = 0;
    for (const Source& source : all_sources()) {
        if (source.path.find("chapters/") != 0 || source.path.find("/program/") == std::string::npos)
            continue;
        const std::string name = fs::path(source.path).filename().string();
        const bool steps = source.text.find("rigid::step(") != std::string::npos;
        if (steps && std::find(others.begin(), others.end(), name) == others.end()) {
            ++runners;
            if (name != "scene_run.hpp")
                FAIL_CHECK(source.path + " takes a step of its own; see scene_run.hpp");
        }
        if (chapter_of(source.path) >= 3 && source.text.find("protected:") != std::string::npos)
            FAIL_CHECK(source.path + " has protected members");
    }
    CHECK(runners == 1);
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
