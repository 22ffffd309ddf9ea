// The canvas, its SVG painter and the shell of the programs: command line, table, exit codes, what
// the window shows (without opening one).
#include "common/picture.hpp"
#include "common/program/command_line.hpp"
#include "common/program/outputs.hpp"
#include "common/program/panel_rows.hpp"
#include "common/program/panes.hpp"
#include "common/program/part_watch.hpp"
#include "common/program/scripted_pointer.hpp"
#include "common/program/show.hpp"
#include "common/program/table.hpp"
#include "common/svg_canvas.hpp"
#include "common/text.hpp"
#include "tests/catch.hpp"
#include "tests/program_toy.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <locale>
#include <random>
#include <sstream>

using namespace rigid;
namespace fs = std::filesystem;

namespace {

/// What a run of the toy said and returned.
struct Said {
    int code = 0;
    std::string out, err;
};

Said run(const std::vector<std::string>& words, const Program& program = toy::program())
{
    std::vector<std::string> copies = {program.name};
    copies.insert(copies.end(), words.begin(), words.end());
    std::vector<char*> argv;
    for (std::string& word : copies) argv.push_back(word.data());
    argv.push_back(nullptr);
    std::ostringstream out, err;
    std::streambuf* const cout_before = std::cout.rdbuf(out.rdbuf());
    std::streambuf* const cerr_before = std::cerr.rdbuf(err.rdbuf());
    Said said;
    said.code = run_program([&] { return program; }, static_cast<int>(copies.size()), argv.data());
    std::cout.rdbuf(cout_before);
    std::cerr.rdbuf(cerr_before);
    said.out = out.str();
    said.err = err.str();
    return said;
}

/// A folder of its own for each test, where it stands while the test runs.
struct Folder {
    fs::path before = fs::current_path();
    fs::path path;
    Folder()
    {
        static int count = 0;
        path = fs::temp_directory_path() /
               ("rigid_program_" + std::to_string(std::random_device()()) + "_" + std::to_string(++count));
        fs::create_directories(path);
        fs::current_path(path);
    }
    ~Folder()
    {
        fs::current_path(before);
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

std::string content(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

long lines_in(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// Refused by exit code 2, with one line on stderr that holds each of the parts, and nothing on stdout.
void require_refused(const std::vector<std::string>& words, const std::vector<std::string>& parts)
{
    const Said said = run(words);
    CAPTURE(words, said.err);
    CHECK(said.code == 2);
    CHECK(said.out.empty());
    CHECK(lines_in(said.err) == 1);
    for (const std::string& part : parts) {
        CAPTURE(part);
        CHECK(contains(said.err, part));
    }
}

/// Tags in pairs, attributes in quotes, no bare & or <: what every reader of XML insists on.
bool is_well_formed(const std::string& text)
{
    std::vector<std::string> open;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '&') {
            const std::size_t end = text.find(';', i);
            const std::string name = text.substr(i + 1, end - i - 1);
            if (name != "amp" && name != "lt" && name != "gt" && name != "quot") return false;
        }
        if (text[i] != '<') continue;
        const std::size_t end = text.find('>', i);
        if (end == std::string::npos) return false;
        const std::string tag = text.substr(i + 1, end - i - 1);
        if (contains(tag, "<") || std::count(tag.begin(), tag.end(), '"') % 2 != 0) return false;
        const std::string name = tag.substr(0, tag.find(' '));
        if (tag.front() == '/') {
            if (open.empty() || open.back() != tag.substr(1)) return false;
            open.pop_back();
        } else if (tag.back() != '/') open.push_back(name);
        i = end;
    }
    return open.empty();
}

Options parsed(const Program& program, std::vector<const char*> words)
{
    words.insert(words.begin(), "00_toy");
    return parse_command_line(program, static_cast<int>(words.size()), words.data());
}

}  // namespace

// ---- the command line -------------------------------------------------------------------------

TEST_CASE("what is not known is refused with a list of what is")
{
    require_refused({"--scene", "moon"}, {"\"moon\"", "fall, steered"});
    require_refused({"--set", "colour=3"}, {"\"colour\"", "fall", "g, beads"});
    require_refused({"--method", "magic"}, {"\"magic\"", "symplectic, explicit, failing"});
    require_refused({"--method", "symplectic,magic"}, {"\"magic\""});
    require_refused({"--scene", "steered", "--method", "magic"}, {"\"magic\"", "steered"});
    require_refused({"--colour", "red"}, {"--colour", "--help"});
    require_refused({"moon"}, {"moon", "--help"});
}

TEST_CASE("a value out of its range is refused with the range")
{
    require_refused({"--set", "g=17"}, {"g is 17 m/s²", "between 0 and 16 m/s²"});
    require_refused({"--set", "g=-1"}, {"g is -1 m/s²", "between 0 and 16 m/s²"});
    require_refused({"--set", "beads=21"}, {"beads is 21", "whole number between 1 and 20"});
    require_refused({"--h", "2"}, {"2 s", "between 0.001 and 1 s", "fall"});
    require_refused({"--h", "0"}, {"0 s", "between 0.001 and 1 s"});
    require_refused({"--h", "-0.1"}, {"-0.1 s", "between 0.001 and 1 s"});
    require_refused({"--steps", "2000000000"}, {"--steps", "2000000000", "between 0 and 1000000000"});
    require_refused({"--record", "frames", "--every", "0"}, {"--every", "\"0\"", "between 1"});
}

TEST_CASE("what is no number is refused")
{
    require_refused({"--set", "g=heavy"}, {"g is \"heavy\"", "number between 0 and 16"});
    require_refused({"--set", "g=nan"}, {"g is \"nan\"", "number"});
    require_refused({"--set", "g=inf"}, {"g is \"inf\"", "number"});
    require_refused({"--set", "g=3kg"}, {"g is \"3kg\"", "number"});
    require_refused({"--set", "g="}, {"g is \"\"", "number"});
    require_refused({"--set", "g"}, {"\"g\"", "name=value"});
    require_refused({"--set", "beads=1.5"}, {"beads is 1.5", "whole number"});
    require_refused({"--h", "fast"}, {"\"fast\"", "number"});
    require_refused({"--steps", "ten"}, {"--steps", "\"ten\"", "whole number"});
    require_refused({"--steps", "-1"}, {"--steps", "\"-1\"", "whole number"});
    require_refused({"--seed", "0x1"}, {"--seed", "\"0x1\"", "whole number"});
}

TEST_CASE("options that lack something or contradict each other are refused")
{
    require_refused({"--scene"}, {"--scene", "has no value"});
    require_refused({"--steps", "1", "--steps", "2"}, {"--steps", "once"});
    require_refused({"--every", "5"}, {"--every", "--record"});
    require_refused({"--headless", "--dark", "--svg", "a.svg"}, {"--dark", "--png or --record"});
    require_refused({"--problem", "x.mlcp", "--dark"}, {"--dark", "--problem"});
    require_refused({"--method", "explicit,explicit"}, {"\"explicit\" twice"});
    require_refused({"--csv", ""}, {"--csv", "file name"});
    require_refused({"--problem", ""}, {"--problem", "file name"});
    require_refused({"--problem="}, {"--problem", "has no value"});
    require_refused({"--set", "g=4", "--set", "g=5"}, {"g is set twice", "\"g=5\""});
    require_refused({"--set", "g=4", "beads=2", "g=4"}, {"g is set twice"});
    require_refused({"--problem", "x.mlcp", "--scene", "fall"}, {"--scene", "--problem"});
    require_refused({"--problem", "x.mlcp", "--seed", "3"}, {"--seed", "--problem"});
    require_refused({"--problem", "x.mlcp", "--csv", ""}, {"--csv", "--problem"});
    require_refused({"--echo", "a.txt", "--seed", "3"}, {"--seed", "--echo"});
    require_refused({"--problem", "x.mlcp", "--method", "magic"}, {"\"magic\"", "enumerate, schur"});
    require_refused({"--echo"}, {"--echo", "has no value"});
    require_refused({"--echo", ""}, {"--echo", "file name"});
    require_refused({"--echo", "a.txt", "--scene", "fall"}, {"--scene", "--echo"});
    require_refused({"--echo", "a.txt", "--method", "explicit"}, {"--echo", "no other option"});
    require_refused({"--echo", "a.txt", "--problem", "x.mlcp"}, {"--echo", "no other option"});
    require_refused({"--echo", "/no/such/folder/a.txt"}, {"/no/such/folder/a.txt", "can't be written"});
}

TEST_CASE("a file that cannot be written is refused before the first step")
{
    const Folder folder;
    for (const char* option : {"--csv", "--svg"})
        require_refused({"--headless", option, "no/such/folder/file"},
                        {"no/such/folder/file", "can't be written"});
    fs::create_directories("folder");
    require_refused({"--headless", "--svg", "folder"}, {"\"folder\"", "can't be written"});
    std::ofstream("file") << "x";
    require_refused({"--headless", "--record", "file/frames"}, {"file/frames", "--record"});
}

TEST_CASE("two outputs are never one file")
{
    const Folder folder;
    std::ofstream("there") << "kept";
    fs::create_symlink("there", "link");
    fs::create_directories("folder");
    require_refused({"--headless", "--csv", "there", "--svg", "there"}, {"--csv and --svg", "\"there\""});
    require_refused({"--csv", "there", "--svg", "there"}, {"--csv and --svg", "\"there\""});
    require_refused({"--headless", "--csv", "new", "--svg", "folder/../new"}, {"--csv and --svg"});
    require_refused({"--headless", "--svg", "there", "--png", "link"}, {"--svg and --png", "\"link\""});
    CHECK(content("there") == "kept");
    CHECK_FALSE(fs::exists("new"));
    CHECK(run({"--headless", "--steps", "2", "--csv", "-", "--svg", "-"}).code == 0);  // a picture called "-"
#ifdef __linux__
    CHECK(run({"--headless", "--steps", "2", "--csv", "/dev/null", "--svg", "/dev/null"}).code == 0);
#endif
}

TEST_CASE("what a recording finds in its folder is still there afterwards")
{
    const Folder folder;
    fs::create_directories("frames");
    std::ofstream("frames/.writable") << "mine";
    require_folder("frames");
    CHECK(content("frames/.writable") == "mine");
    CHECK(std::distance(fs::directory_iterator("frames"), fs::directory_iterator()) == 1);
    fs::create_symlink("nowhere", "link");  // a link to nothing is not removed either
    require_writable("the picture", "link");
    CHECK(fs::is_symlink("link"));
}

TEST_CASE("the limits that a program prints are taken")
{
    Program program = toy::program();
    program.scenes[0].h = 1.0 / 240;
    program.scenes[0].h_low = 1.0 / 700;  // 0.001428571429 is above it
    program.scenes[0].h_high = 1.0 / 60;  // 0.01666666667 is above it
    program.scenes[0].tunables[0].high = 2.0 / 3 * 24;
    program.scenes[0].tunables[0].low = 2.0 / 3;
    for (const Real limit : {1.0 / 700, 1.0 / 60}) {
        const Options options = parsed(program, {"--h", readable(limit).c_str()});
        CHECK(options.settings.h == limit);
        CHECK(parsed(program, {"--h", shortest(limit).c_str()}).settings.h == limit);
    }
    CHECK(parsed(program, {"--set", ("g=" + readable(2.0 / 3)).c_str()}).settings["g"] == 2.0 / 3);
    CHECK_THROWS_WITH(parsed(program, {"--h", "0.0166666667"}), Catch::Matchers::Contains("0.01666666667"));
    CHECK(parsed(program, {"--h", "0.005"}).settings.h == 0.005);
}

TEST_CASE("a choice is written by its name or its number and each whole number has a name")
{
    Program program = toy::program();
    Tunable& beads = program.scenes[0].tunables[1];
    beads.low = 1, beads.high = 3, beads.names = {"one", "two", "three"};
    CHECK_NOTHROW(require_consistent(program));
    CHECK(parsed(program, {"--set", "beads=three"}).settings["beads"] == 3);
    CHECK(parsed(program, {"--set", "beads=2"}).settings["beads"] == 2);
    CHECK(slider_row(beads).names == beads.names);
    Tunable whether = beads;
    whether.low = 0, whether.high = 1, whether.names.clear();
    CHECK(slider_row(whether).names == std::vector<std::string>{"no", "yes"});
    whether.high = 2;
    CHECK(slider_row(whether).names.empty());
    CHECK_THROWS_WITH(parsed(program, {"--set", "beads=four"}), Catch::Matchers::Contains("four"));
    beads.high = 4;
    CHECK_THROWS_WITH(require_consistent(program), Catch::Matchers::Contains("beads has 3 names"));
}

TEST_CASE("a column beside another is drawn in its plot and the plot holds both")
{
    Program program = toy::program();
    Column& speed = program.scenes[0].columns[1];
    speed.beside = "height";
    CHECK_NOTHROW(require_consistent(program));
    Show show(program, parsed(program, {}));
    for (int i = 0; i < 3; ++i) show.single_step({});
    constexpr bool whole_run = false;
    const auto plot = plot_of(show, 0, plot_span(show, whole_run), whole_run);
    REQUIRE(plot);
    // heights 0, -2, -6, -12 and speeds 0, -4, -8, -12
    CHECK(plot->low == -12);
    REQUIRE(plot->beside.size() == 1);
    REQUIRE(plot->beside[0].back().size() == 4);
    CHECK(plot->beside[0].back()[1].y() == Approx(2.0 / 3));
    CHECK(plot->curves[0].back()[1].y() == Approx(5.0 / 6));
    speed.beside = "nowhere";
    CHECK_THROWS_WITH(require_consistent(program), Catch::Matchers::Contains("stands beside \"nowhere\""));
}

TEST_CASE("more methods than a window has panes are refused with a window and without a display")
{
    Program program = toy::program();
    const char* five = "symplectic,explicit,failing,exploding,interrupting";
    require_refused({"--method", five}, {"names 5 methods", "4 at most", "--headless"});
    CHECK(parsed(program, {"--headless", "--method", five}).methods.size() == 5);
    program.scenes[0].side_by_side = {"symplectic", "explicit", "failing", "exploding", "interrupting"};
    CHECK_THROWS_WITH(require_consistent(program), Catch::Matchers::Contains("side_by_side names 5 methods"));
    program.scenes[0].side_by_side.pop_back();
    CHECK_NOTHROW(require_consistent(program));
}

TEST_CASE("settings that the scene refuses end with its own sentence")
{
    require_refused({"--headless", "--set", "beads=13"}, {"beads is 13; it must be a luckier number"});
}

TEST_CASE("a program that contradicts itself is refused whatever was typed")
{
    Program program = toy::program();
    program.scenes[1].name = "fall";
    CHECK_THROWS_WITH(require_consistent(program), Catch::Matchers::Contains("two of this name"));
    program = toy::program();
    program.scenes[0].tunables[0].value = 99;
    CHECK_THROWS_WITH(require_consistent(program), Catch::Matchers::Contains("g is 99"));
    program = toy::program();
    program.scenes[0].columns[0].name = "the height";
    CHECK_THROWS_WITH(require_consistent(program), Catch::Matchers::Contains("\"the height\""));
    program = toy::program();
    program.scenes[0].side_by_side = {"magic"};
    CHECK_THROWS_WITH(require_consistent(program), Catch::Matchers::Contains("\"magic\""));
    program = toy::program();
    program.scenes[0].view.half_size = {1, 0};
    CHECK_THROWS_WITH(require_consistent(program), Catch::Matchers::Contains("view"));
    CHECK_NOTHROW(require_consistent(toy::program()));
}

TEST_CASE("help and the list of scenes name everything there is")
{
    const Said help = run({"--help"});
    CHECK(help.code == 0);
    CHECK(help.err.empty());
    for (const char* word :
         {"--scene", "--set", "--method", "--headless", "--record", "--dark", "--problem", "--echo FILE",
          "Write a word and end", "fall", "steered", "g=8 m/s²", "Gravity; between 0 and 16 m/s²", "beads=1",
          "symplectic, explicit", "height [m]", "enumerate, schur"}) {
        CAPTURE(word);
        CHECK(contains(help.out, word));
    }
    const Said list = run({"--list-scenes"});
    CHECK(list.code == 0);
    CHECK(list.out == "fall     A bead that falls.\nsteered  A bead under the pointer.\n");
}

TEST_CASE("what was typed arrives in the settings")
{
    const Program program = toy::program();
    const Options options =
        parsed(program, {"--scene", "fall", "--set", "g=4", "beads=3", "--h", "0.25", "--seed",
                         "18446744073709551615", "--steps", "7", "--method", "explicit,symplectic"});
    CHECK(options.scene == &program.scenes[0]);
    CHECK(options.settings["g"] == 4);
    CHECK(options.settings["beads"] == 3);
    CHECK(options.settings.h == 0.25);
    CHECK(options.settings.seed == 18446744073709551615u);
    CHECK(options.steps == 7);
    CHECK(options.methods == std::vector<std::string>{"explicit", "symplectic"});
    const Options repeated =
        parsed(program, {"--set", "g=4", "--set", "beads=3", "--method", "explicit", "--method", "failing"});
    CHECK(repeated.settings["g"] == 4);
    CHECK(repeated.settings["beads"] == 3);
    CHECK(repeated.methods == std::vector<std::string>{"explicit", "failing"});
}

TEST_CASE("a tunable is found by its whole name and a name that no scene listed is refused")
{
    Settings settings;
    settings.tunables = {{"mass", 1}, {"speed", 2}, {"slope", 3}};
    CHECK(settings["speed"] == 2);  // as long as "slope", and the same first letter
    CHECK(settings["slope"] == 3);
    CHECK_FALSE(settings.tunables.contains("mas"));
    CHECK_FALSE(settings.tunables.contains("masses"));
    CHECK_THROWS_WITH(settings["sped"], "there is no tunable \"sped\"");
    settings.tunables["mass"] = 4;
    settings.tunables["sped"] += 5;
    CHECK(settings.tunables == TunableValues({{"mass", 4}, {"speed", 2}, {"slope", 3}, {"sped", 5}}));
}

TEST_CASE("a problem from a file goes to the method that was named")
{
    const Folder folder;
    std::ofstream("good.mlcp") << "good\n";
    std::ofstream("bad.mlcp") << "bad\n";
    CHECK(run({"--headless", "--problem", "good.mlcp"}).out == "status solved by enumerate\n");
    CHECK(run({"--headless", "--problem", "good.mlcp", "--method", "schur"}).out ==
          "status solved by schur\n");
    require_refused({"--problem", "bad.mlcp"}, {"bad.mlcp:1", "\"bad\""});
    require_refused({"--problem", "none.mlcp"}, {"none.mlcp", "can't be read"});
}

TEST_CASE("a file of the program's own is written without a scene")
{
    const Folder folder;
    const Said said = run({"--echo", "word.txt"});
    CHECK(said.code == 0);
    CHECK(said.out.empty());
    CHECK(said.err.empty());
    std::string word;
    std::ifstream("word.txt") >> word;
    CHECK(word == "heard");
}

// ---- the table --------------------------------------------------------------------------------

TEST_CASE("the table has the numbers of the run to the last digit")
{
    const Said said = run({"--headless", "--csv", "-", "--steps", "3"});
    CHECK(said.code == 0);
    CHECK(said.err.empty());
    // h = 0.5 s, g = 8 m/s²: symplectic Euler by hand, without rounding.
    CHECK(said.out == "step,t,height,speed\n0,0,0,0\n1,0.5,-2,-4\n2,1,-6,-8\n3,1.5,-12,-12\n");
}

TEST_CASE("with several methods each step has a row of each that names it")
{
    const Said said = run({"--headless", "--csv", "-", "--steps", "2", "--method", "symplectic,explicit"});
    CHECK(said.code == 0);
    CHECK(said.out == "step,t,method,height,speed\n"
                      "0,0,symplectic,0,0\n0,0,explicit,0,0\n"
                      "1,0.5,symplectic,-2,-4\n1,0.5,explicit,0,-4\n"
                      "2,1,symplectic,-6,-8\n2,1,explicit,-2,-8\n");
}

TEST_CASE("the table has decimal points whatever the locale says")
{
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\1"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const Said said = run({"--headless", "--csv", "-", "--steps", "1200", "--set", "g=0.1", "--h", "0.001"});
    std::locale::global(before);
    CHECK(said.code == 0);
    CHECK(lines_in(said.out) == 1202);
    CHECK(contains(said.out, "\n1000,1,"));
    CHECK(std::count(said.out.begin(), said.out.end(), ',') == 3 * 1202);
}

TEST_CASE("numbers in the table read back as the same bits")
{
    Random random(7);
    for (int i = 0; i < 1000; ++i) {
        const Real size = std::pow(10.0, random.uniform(-300, 300)), value = size * random.normal();
        CHECK(parse_real(shortest(value)) == value);
    }
    CHECK(shortest(-0.0) == "0");
    CHECK(shortest(0.1) == "0.1");
}

TEST_CASE("without the number of steps a run does 300")
{
    CHECK(lines_in(run({"--headless", "--csv", "-"}).out) == 302);
    CHECK(lines_in(run({"--headless", "--csv", "-", "--steps", "0"}).out) == 2);
}

TEST_CASE("without any output a run sums up what it measured")
{
    const Said said = run({"--headless", "--steps", "3"});
    CHECK(said.code == 0);
    CHECK(contains(said.out, "scene fall: 3 steps of 0.5 s"));
    CHECK(contains(said.out, "height         -12  m\n"));
}

// ---- runs that cannot go on -----------------------------------------------------------------

TEST_CASE("a step that fails ends the run with its number and leaves the rows before it")
{
    const Folder folder;
    const Said said = run({"--headless", "--csv", "table.csv", "--svg", "last.svg", "--method", "failing"});
    CHECK(said.code == 3);
    CHECK(said.err == "step 5: the bead 0 has left the wire\n");
    CHECK(lines_in(content("table.csv")) == 6);
    CHECK(is_well_formed(content("last.svg")));
}

TEST_CASE("a measured number that is not finite ends the run")
{
    const Said said = run({"--headless", "--csv", "-", "--method", "exploding"});
    CHECK(said.code == 3);
    CHECK(said.err == "step 5: height is inf m; it must be finite\n");
    CHECK(lines_in(said.out) == 6);
    CHECK_FALSE(contains(said.out, "inf"));
}

/// Takes so many bytes, then its disk is full.
class FullDisk : public std::streambuf {
public:
    explicit FullDisk(std::streamsize room) : room_(room) {}

private:
    int_type overflow(int_type c) override { return room_-- > 0 ? c : traits_type::eof(); }
    std::streamsize room_;
};

TEST_CASE("a standard output that takes no more ends with exit code 3 and a sentence")
{
    const Folder folder;
    std::ofstream("good.mlcp") << "good\n";
    for (const std::vector<std::string>& words : {std::vector<std::string>{"--help"},
                                                  {"--list-scenes"},
                                                  {"--problem", "good.mlcp"},
                                                  {"--headless", "--steps", "2"},
                                                  {"--headless", "--steps", "2", "--csv", "-"}}) {
        FullDisk disk(5);
        std::ostringstream err;
        std::streambuf* const cout_before = std::cout.rdbuf(&disk);
        std::streambuf* const cerr_before = std::cerr.rdbuf(err.rdbuf());
        std::vector<std::string> copies = {"00_toy"};
        copies.insert(copies.end(), words.begin(), words.end());
        std::vector<char*> argv;
        for (std::string& word : copies) argv.push_back(word.data());
        const int code = run_program(toy::program, static_cast<int>(argv.size()), argv.data());
        std::cout.rdbuf(cout_before);
        std::cerr.rdbuf(cerr_before);
        std::cout.clear();
        CAPTURE(words, err.str());
        CHECK(code == 3);
        CHECK(contains(err.str(), "standard output can't be written"));
        CHECK(lines_in(err.str()) == 1);
    }
}

#ifdef __linux__
TEST_CASE("a file on a full disk ends with exit code 3 and a sentence that names it")
{
    const Folder folder;
    fs::create_directories("frames");
    fs::create_symlink("/dev/full", "frames/frame_000001.svg");
    fs::create_symlink("/dev/full", "frames/frame_000001.png");
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"--csv", "/dev/full"}, {"--svg", "/dev/full"}, {"--record", "frames"}}) {
        std::vector<std::string> all = {"--headless", "--steps", "3"};
        all.insert(all.end(), words.begin(), words.end());
        const Said said = run(all);
        CAPTURE(words, said.err);
        CHECK(said.code == 3);
        CHECK(contains(said.err, words[1]));
        CHECK(contains(said.err, "disk full"));
    }
    const Said png = run({"--headless", "--steps", "3", "--png", "/dev/full"});
    CAPTURE(png.err);
    if (!contains(png.err, "needs OpenGL without a window")) CHECK(png.code == 3);
}
#endif

TEST_CASE("missing memory is reported by a sentence wherever it is missed")
{
    const Said starting = run({"--headless", "--set", "beads=17"});
    CHECK(starting.code == 3);
    CHECK(starting.err == "there is not enough memory for this\n");
    const Said stepping = run({"--headless", "--csv", "-", "--method", "hungry"});
    CHECK(stepping.code == 3);
    CHECK(stepping.err == "step 5: there is not enough memory for this\n");
    char name[] = "00_toy";
    char* argv[] = {name, nullptr};
    std::ostringstream err;
    std::streambuf* const cerr_before = std::cerr.rdbuf(err.rdbuf());
    const int unmade = run_program([]() -> Program { throw std::bad_alloc(); }, 1, argv);
    const int bad = run_program([]() -> Program { throw std::invalid_argument("n is 0"); }, 1, argv);
    std::cerr.rdbuf(cerr_before);
    CHECK(unmade == 3);
    CHECK(bad == 2);
    CHECK(err.str() == "there is not enough memory for this\nn is 0\n");
}

TEST_CASE("where one method fails the others go on")
{
    const Said said = run({"--headless", "--csv", "-", "--steps", "8", "--method", "failing,symplectic"});
    CHECK(said.code == 3);
    CHECK(said.err == "step 5: method failing: the bead 0 has left the wire\n");
    CHECK(contains(said.out, "\n4,2,failing,-20,-16\n4,2,symplectic,-20,-16\n5,2.5,symplectic,"));
    CHECK(contains(said.out, "\n8,4,symplectic,-72,-32\n"));
}

TEST_CASE("an interrupted run finishes its row and closes its files")
{
    const Folder folder;
    const Said said = run({"--headless", "--csv", "table.csv", "--svg", "last.svg", "--method",
                           "interrupting,explicit", "--steps", "1000"});
    CHECK(said.code == 130);
    CHECK(contains(said.err, "after step 5"));
    CHECK(lines_in(content("table.csv")) == 1 + 2 * 6);
    CHECK(is_well_formed(content("last.svg")));
}

TEST_CASE("SIGTERM loses no row of any method")
{
    const Folder folder;
    const Said said =
        run({"--headless", "--csv", "table.csv", "--method", "explicit,terminating", "--steps", "1000"});
    CHECK(said.code == 143);
    CHECK(contains(said.err, "after step 5"));
    CHECK(lines_in(content("table.csv")) == 1 + 2 * 6);
}

TEST_CASE("a row is in the file before the next step begins")
{
    const Folder folder;
    const Program program = toy::program();
    Playback playback(program.scenes[0], parsed(program, {}).settings, {"symplectic", "explicit"});
    Table table("table.csv", program.scenes[0], 2);
    for (long n = 0; n < 4; ++n) {
        table.add(playback.tracks());
        CHECK(lines_in(content("table.csv")) == 1 + 2 * (n + 1));
        playback.step({});
    }
}

#ifdef __linux__
TEST_CASE("without a display the program says so and leaves a picture and a table")
{
    const Folder folder;
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) unsetenv(name);
    const Said said = run({"--steps", "4"});
    CHECK(said.code == 0);
    CHECK(contains(said.err, "running without one"));
    CHECK(contains(said.err, (folder.path / "00_toy_fall.svg").string()));
    CHECK(contains(said.err, (folder.path / "00_toy_fall.csv").string()));
    CHECK(is_well_formed(content("00_toy_fall.svg")));
    CHECK(lines_in(content("00_toy_fall.csv")) == 6);
}
#endif

// ---- the same bytes ---------------------------------------------------------------------------

TEST_CASE("two runs with the same settings write the same bytes")
{
    const Folder folder;
    for (const char* name : {"a", "b"})
        CHECK(run({"--headless", "--scene", "steered", "--seed", "5", "--h", "0.01", "--csv",
                   std::string(name) + ".csv", "--svg", std::string(name) + ".svg"})
                  .code == 0);
    CHECK(content("a.csv") == content("b.csv"));
    CHECK(content("a.svg") == content("b.svg"));
    CHECK(lines_in(content("a.csv")) == 302);
    CHECK(run({"--headless", "--scene", "steered", "--seed", "6", "--h", "0.01", "--csv", "c.csv"}).code ==
          0);
    CHECK(content("a.csv") != content("c.csv"));
}

TEST_CASE("frames are recorded at the start and every so many steps")
{
    const Folder folder;
    const Said said = run({"--headless", "--steps", "10", "--record", "deep/frames", "--every", "4"});
    CHECK(said.code == 0);
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator("deep/frames"))
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    CHECK(names == std::vector<std::string>{"frame_000000", "frame_000001", "frame_000002"});
}

TEST_CASE("a dark picture is another one than the light one and a drawing of lines is the same")
{
    const Folder folder;
    const auto picture = [](const std::string& name, std::vector<std::string> more) {
        more.insert(more.begin(),
                    {"--headless", "--steps", "2", "--png", name + ".png", "--svg", name + ".svg"});
        return run(more);
    };
    const Said light = picture("light", {});
    if (contains(light.err, "needs OpenGL without a window")) return;
    REQUIRE(light.code == 0);
    REQUIRE(picture("again", {}).code == 0);
    REQUIRE(picture("dark", {"--dark"}).code == 0);
    CHECK(content("again.png") == content("light.png"));
    CHECK(content("dark.png") != content("light.png"));
    CHECK(content("dark.svg") == content("light.svg"));
}

// ---- the pointer ------------------------------------------------------------------------------

TEST_CASE("the scripted pointer depends on the seed and the time alone")
{
    const View view{{1, 2}, {3, 1.5}};
    const ScriptedPointer a(3, view), b(3, view), c(4, view);
    CHECK(a.at(1.25) == b.at(1.25));
    b.at(99);
    CHECK(a.at(7.5) == b.at(7.5));
    CHECK((a.at(1.25) - c.at(1.25)).norm() > 1e-3);
}

TEST_CASE("the scripted pointer stays inside the picture and goes all over it without jumps")
{
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const View view{{1, 2}, {3, 1.5}};
        const ScriptedPointer pointer(seed, view);
        Vec2 low = pointer.at(0), high = low, before = low;
        for (int i = 1; i <= 12000; ++i) {  // two minutes
            const Vec2 p = pointer.at(0.01 * i);
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
            // The sum of the waves' greatest speeds: 0.9 · 2π · 1.15 (0.55/9 + 0.30/5 + 0.15/3) = 1.12 half
            // sizes in 1 s.
            REQUIRE((p - before).cwiseAbs().cwiseQuotient(view.half_size).maxCoeff() <= 1.12 * 0.01);
            before = p;
        }
        const Vec2 inside = 0.9 * view.half_size;
        CHECK((low - view.centre + inside).minCoeff() >= -1e-12);
        CHECK((view.centre + inside - high).minCoeff() >= -1e-12);
        // Three waves of different length come near their common crest within two minutes.
        CHECK(((high - low).cwiseQuotient(2 * inside)).minCoeff() > 0.8);
    }
}

// ---- pictures ---------------------------------------------------------------------------------

TEST_CASE("an SVG picture is well formed and its text is escaped")
{
    Canvas canvas;
    toy::Bead(default_settings(toy::program().scenes[0])).draw(canvas);
    const std::string svg = to_svg({{"", {{0, 0}, {1, 0.5}}, canvas}});
    CHECK(is_well_formed(svg));
    CHECK(contains(svg, "viewBox=\"0 0 720.00 360.00\""));
    CHECK(contains(svg, "0 ≤ λ &amp; w &quot;⟂&quot; &lt;b&gt;"));
    CHECK(contains(svg, "#808080"));
    CHECK(contains(svg, "#4477AA"));
    CHECK(contains(svg, "stroke-dasharray"));
    CHECK(svg == to_svg({{"", {{0, 0}, {1, 0.5}}, canvas}}));
}

TEST_CASE("metres become pixels with y up and circles stay circles")
{
    Canvas canvas;
    canvas.disc({0.5, 0.25}, 0.1);
    const std::string svg = to_svg({{"", {{0, 0}, {1, 0.5}}, canvas}});
    // 360 pixels a metre: x = 360 (1 + 0.5), y = 360 (0.5 - 0.25), r = 36.
    CHECK(contains(svg, "<circle cx=\"540.00\" cy=\"90.00\" r=\"36.00\""));
    const Projection projection({{1, 2}, {3, 1.5}}, {10, 20, 300, 300});
    const Vec2 p(0.7, 2.9);
    CHECK((projection.to_world(projection.to_pixel(p)) - p).norm() < 1e-14);
    CHECK(projection.to_pixel({1, 2}) == Vec2(160, 170));
}

TEST_CASE("panes stand side by side with their labels")
{
    Canvas canvas;
    canvas.disc({0, 0}, 0.5);
    const View view{{0, 0}, {1, 0.5}};
    const std::string svg = to_svg({{"left & one", view, canvas}, {"right", view, canvas}});
    CHECK(is_well_formed(svg));
    CHECK(contains(svg, ">left &amp; one</text>"));
    CHECK(contains(svg, ">right</text>"));
    CHECK(contains(svg, "width=\"1456.00\" height=\"388.00\""));
    const PictureLayout four = lay_out({4, Pane{"", view, {}}});
    CHECK(four.areas[3].x == four.areas[1].x);
    CHECK(four.areas[3].y > four.areas[0].y + four.areas[0].height);
}

TEST_CASE("each pane has a place with some picture in it also where a window has no room")
{
    const Real label = 26, gap = 10;
    for (const View& view : {View{}, View{{0, 0}, {1, 1e-3}}, View{{0, 0}, {1e-3, 1}}})
        for (const Rectangle& area :
             {Rectangle{0, 0, 1, -20}, Rectangle{0, 0, -20, 600}, Rectangle{0, 0, 0, 0}})
            for (std::size_t count = 1; count <= most_panes; ++count) {
                const std::vector<Rectangle> places = pane_grid(area, count, view, label, gap);
                REQUIRE(places.size() == count);
                for (const Rectangle& place : places) {
                    CHECK(place.width > 0);
                    CHECK(place.height > label);
                }
            }
}

TEST_CASE("what is not finite or far away does not disturb a picture")
{
    Canvas canvas;
    const Real nan = std::nan("");
    canvas.disc({nan, 0}, 0.1);
    canvas.disc({1e300, 0}, 0.1);
    canvas.disc({0, 0}, infinity);
    canvas.polyline({{0, 0}, {1e200, 1e200}});
    canvas.polyline({{0, 0}, {infinity, 0}});
    canvas.polyline({{0, 0}, {0.5, 0}, {0.5, 1e9}});
    canvas.arrow({0, 0}, {1e300, 0});
    canvas.arrow({0, 0}, {0, 0});
    canvas.polygon({{-1e8, -1e8}, {1e8, -1e8}, {0, 1}});
    canvas.polygon({{0, 0}, {1, 1}});
    canvas.polyline({{0, 0}});
    canvas.text({nan, nan}, "nowhere");
    const std::string svg = to_svg({{"", {}, canvas}});
    CHECK(is_well_formed(svg));
    for (const char* word : {"nan", "inf", "e+", "nowhere"}) {
        CAPTURE(word);
        CHECK_FALSE(contains(svg, word));
    }
    CHECK(contains(svg, "<polyline"));
    CHECK(svg.size() < 4000);
}

TEST_CASE("a picture of nothing is refused")
{
    CHECK_THROWS_AS(to_svg({}), std::invalid_argument);
    CHECK_THROWS_WITH(to_svg({{"", {{0, 0}, {0, 1}}, {}}}), Catch::Matchers::Contains("must be positive"));
    CHECK_THROWS_WITH(to_svg({{"", {{0, -std::nan("")}, {1, 1}}, {}}}),
                      "the centre of the view is 0, nan; it must be finite");
    CHECK_THROWS_WITH(write_svg("no/such/folder/a.svg", {{"", {}, {}}}),
                      Catch::Matchers::Contains("no/such/folder/a.svg"));
}

// ---- what the window shows --------------------------------------------------------------------

TEST_CASE("the window takes the same steps as a run without one")
{
    const Program program = toy::program();
    Show show(program,
              parsed(program, {"--scene", "steered", "--h", "0.01", "--seed", "5", "--steps", "100"}));
    // Uneven frames decide how many steps there are in each, never how long one is.
    Random random(1);
    for (int i = 0; i < 1000 && !show.is_over(); ++i) show.advance(random.uniform(0, 0.05), {}, 0);
    REQUIRE(show.playback()->steps() == 100);
    const Said said = run(
        {"--headless", "--scene", "steered", "--h", "0.01", "--seed", "5", "--steps", "100", "--csv", "-"});
    const auto& measured = show.playback()->tracks()[0].measured;
    CHECK(contains(said.out, "\n100,1," + shortest(measured[0]) + ',' + shortest(measured[1]) + '\n'));
}

TEST_CASE("as many steps are taken as the speed requires and a backlog is dropped")
{
    const Program program = toy::program();
    Show show(program, parsed(program, {"--h", "0.01"}));
    for (int i = 0; i < 60; ++i) show.advance(1.0 / 60, {}, 0);
    CHECK(std::abs(show.playback()->steps() - 100) <= 1);
    show.speed = 0.125;
    const long before = show.playback()->steps();
    for (int i = 0; i < 60; ++i) show.advance(1.0 / 60, {}, 0);
    CHECK(std::abs(show.playback()->steps() - before - 12) <= 1);
    show.speed = 4;
    show.set_h(0.001);
    show.advance(1000, {}, 0);
    CHECK(show.falls_behind());
    CHECK(show.playback()->steps() - before <= 4020);
    show.paused = true;
    const long paused_at = show.playback()->steps();
    show.advance(1, {}, 0);
    CHECK(show.playback()->steps() == paused_at);
    show.single_step({});
    CHECK(show.playback()->steps() == paused_at + 1);
}

TEST_CASE("what is no number is refused while a run goes on and the run goes on")
{
    const Program program = toy::program();
    Show show(program, parsed(program, {"--h", "0.01"}));
    show.advance(0.055, {}, 0);
    CHECK_THROWS_WITH(show.set_tunable(program.scenes[0].tunables[0], NAN),
                      "g is to be nan; it must be a number");
    CHECK_THROWS_WITH(show.set_h(NAN), "the time step is to be nan; it must be a number");
    CHECK(show.settings()["g"] == 8);
    CHECK(show.settings().h == 0.01);
    CHECK_THROWS_WITH(show.advance(NAN, {}, 0),
                      "the time since the last frame is nan; it must be zero or positive, and finite");
    for (const Real speed : {Real(NAN), infinity, -1.0}) {
        show.speed = speed;
        CHECK_THROWS_WITH(show.advance(0.01, {}, 0), "the speed of the show is " + shortest(speed) +
                                                         "; it must be zero or positive, and finite");
    }
    show.speed = 1;
    CHECK(show.playback()->steps() == 5);
    show.advance(0.02, {}, 0);
    CHECK(show.playback()->steps() == 7);

    Options options = parsed(program, {});
    options.settings.h = NAN;
    CHECK_THROWS_WITH(Show(program, options), "the time step is to be nan; it must be a number");
    options = parsed(program, {});
    options.settings.tunables["g"] = NAN;
    CHECK_THROWS_WITH(Show(program, options), "g is to be nan; it must be a number");
}

TEST_CASE("recording stops at each step that is to be a frame")
{
    const Program program = toy::program();
    Show show(program, parsed(program, {"--h", "0.01"}));
    for (int i = 1; i <= 5; ++i) {
        show.advance(1, {}, 7);
        CHECK(show.playback()->steps() == 7 * i);
    }
}

TEST_CASE("a tunable takes effect at once and restarts only where it is flagged")
{
    const Program program = toy::program();
    const auto& tunables = program.scenes[0].tunables;
    Show show(program, parsed(program, {}));
    show.single_step({});
    CHECK(show.playback()->tracks()[0].measured == std::vector<Real>{-2, -4});
    show.set_tunable(tunables[0], 4);
    CHECK(show.playback()->steps() == 1);
    show.single_step({});
    CHECK(show.playback()->tracks()[0].measured == std::vector<Real>{-5, -6});
    show.set_tunable(tunables[0], 99);
    CHECK(show.settings()["g"] == 16);
    show.change_by_arrow(-1);
    CHECK(show.settings()["g"] == Approx(16 - 16.0 / 50));
    show.set_tunable(tunables[1], 2.4);
    CHECK(show.settings()["beads"] == 2);
    CHECK(show.playback()->steps() == 0);
}

TEST_CASE("settings that the scene refuses are named and put right without a new start of the program")
{
    const Program program = toy::program();
    Show show(program, parsed(program, {}));
    show.set_tunable(program.scenes[0].tunables[1], 13);
    CHECK(show.playback() == nullptr);
    CHECK(show.refusal() == "beads is 13; it must be a luckier number");
    show.advance(1, {}, 0);
    show.single_step({});
    show.set_h(0.25);
    show.set_tunable(program.scenes[0].tunables[1], 14);
    REQUIRE(show.playback() != nullptr);
    CHECK(show.settings().h == 0.25);
}

TEST_CASE("one to four methods stand side by side and one that fails stands still alone")
{
    const Program program = toy::program();
    Show show(program, parsed(program, {"--method", "symplectic,failing"}));
    CHECK(show.methods_on() == 2);
    for (int i = 0; i < 8; ++i) show.single_step({});
    CHECK(show.playback()->tracks()[0].steps == 8);
    CHECK(show.playback()->tracks()[1].steps == 4);
    CHECK(show.history(0, 0).recent().size() == 9);
    CHECK(show.history(1, 0).recent().size() == 5);
    CHECK(show.playback()->failures() ==
          std::vector<std::string>{"step 5: method failing: the bead 0 has left the wire"});
    CHECK_FALSE(show.is_over());
    for (std::size_t i = 0; i < 5; ++i) show.choose_method(i, true);
    CHECK(show.methods_on() == 4);
    CHECK(show.shows_method(4));
    for (std::size_t i = 0; i < 5; ++i) show.choose_method(i, false);
    CHECK(show.methods_on() == 1);
    show.choose_scene(1);
    CHECK(show.scene().name == "steered");
    CHECK(show.methods_on() == 0);
    CHECK(show.playback()->tracks().size() == 1);
    CHECK_THROWS_WITH(
        Show(program, parsed(program, {"--method", "symplectic,explicit,failing,exploding,interrupting"})),
        Catch::Matchers::Contains("4 at most"));
}

TEST_CASE("a closer look keeps the point under the pointer and has its ends and goes back to the view")
{
    const View view{{1, 2}, {4, 3}};
    const Rectangle area{0, 0, 800, 600};
    Zoom zoom;
    const Vec2 mouse(700, 100), point = Projection(view, area).to_world(mouse);
    zoom.by(2, point, view);
    const Projection closer(zoom.of(view), area);
    CHECK(closer.scale == Approx(2 * Projection(view, area).scale));
    CHECK((closer.to_world(mouse) - point).norm() <= 1e-12);
    // the hand moves by 50 pixels, and so does what lies under it
    zoom.drag({50 / closer.scale, 0});
    CHECK((Projection(zoom.of(view), area).to_world({750, 100}) - point).norm() <= 1e-12);
    zoom.by(1e9, point, view);
    CHECK(zoom.factor() == Zoom::closest);
    zoom.by(1e-9, point, view);
    CHECK(zoom.factor() == Zoom::farthest);
    CHECK_FALSE(zoom.is_off());
    zoom.reset();
    CHECK(zoom.is_off());
    CHECK(zoom.of(view).centre == view.centre);
    CHECK(zoom.of(view).half_size == view.half_size);
}

TEST_CASE("keys lead through the scenes in a circle and the panel says what the hand can do")
{
    const Program program = toy::program();
    Show show(program, parsed(program, {}));
    const std::string first = show.scene().name;
    for (std::size_t i = 1; i < program.scenes.size(); ++i) {
        show.change_scene(+1);
        CHECK(show.scene().name == program.scenes[i].name);
        CHECK(what_to_do(show.scene()).empty() == !(show.scene().steered || i == 0));
    }
    show.change_scene(+1);
    CHECK(show.scene().name == first);
    CHECK(what_to_do(show.scene()) == "Arrows up and down: g.");
    show.change_scene(-1);
    CHECK(show.scene().name == program.scenes.back().name);
}

TEST_CASE("the table of a window begins again with the scene")
{
    const Folder folder;
    const Program program = toy::program();
    Show show(program, parsed(program, {"--csv", "table.csv"}), table_of_show("table.csv"));
    show.single_step({});
    show.single_step({});
    show.restart();
    show.single_step({});
    CHECK(content("table.csv") == "step,t,height,speed\n0,0,0,0\n1,0.5,-2,-4\n");
}

TEST_CASE("the history of a long run keeps both its ends and stays small")
{
    History history;
    for (int i = 0; i <= 100000; ++i) history.add({0.01 * i, static_cast<Real>(i)});
    CHECK(history.recent().size() == History::recent_steps);
    CHECK(history.recent().back().value == 100000);
    CHECK(history.whole().size() <= History::most_samples);
    CHECK(history.whole().size() > History::most_samples / 4);
    CHECK(history.whole().front().value == 0);
    CHECK(history.whole().back().value > 99000);
    // Evenly spread.
    const Real stride = history.whole()[1].value - history.whole()[0].value;
    for (std::size_t i = 1; i < history.whole().size(); ++i)
        REQUIRE(history.whole()[i].value - history.whole()[i - 1].value == stride);
}

TEST_CASE("time does not gather rounding errors and goes on when h changes")
{
    const Program program = toy::program();
    Playback playback(program.scenes[0], parsed(program, {"--h", "0.1"}).settings, {"symplectic"});
    for (int i = 0; i < 1000; ++i) playback.step({});
    CHECK(playback.time() == 1000 * 0.1);  // a sum of thousand 0.1 would be off by 1e-12
    playback.set_h(0.5);
    playback.step({});
    CHECK(playback.time() == 1000 * 0.1 + 0.5);
}

TEST_CASE("the parts of a step are timed in the order in which they are told and a mean forgets the oldest")
{
    PartTimes times;
    // 1 s of rows, 2 of the solver, 1 of rows again; what is between two steps is no part
    for (const Real start : {0.0, 100.0}) {
        times.begin("rows", start);
        times.begin("solver", start + 1);
        times.begin("rows", start + 3);
        times.begin("", start + 4);
    }
    REQUIRE(times.parts().size() == 2);
    CHECK(times.parts()[0].name == "rows");
    CHECK(times.parts()[0].seconds == 2);
    CHECK(times.parts()[1].seconds == 2);
    CHECK(seconds_of(times.parts()) == 4);
    CHECK(seconds_of(times.parts(), "solver") == 2);
    CHECK(seconds_of(times.parts(), "nothing") == 0);
    for (int i = 0; i < 600; ++i) times.begin("", 200);  // steps in which nothing was done
    CHECK(seconds_of(times.parts()) < 1e-3);
}

TEST_CASE("a run that tells no parts has none")
{
    const Program program = toy::program();
    Playback playback(program.scenes[0], parsed(program, {}).settings, {"symplectic", "explicit"});
    PartWatch watch;
    watch.listen(playback);
    playback.step({});
    REQUIRE(watch.tracks() == 2);
    CHECK(watch.parts(0).empty());
    watch.listen(playback);
    CHECK(watch.tracks() == 2);
}
