// What a page gets of a program, without a browser: draw lists, the panel's rows, panes and the hand over them. The pages
// themselves are tested in a browser: docs/web/test.
#include "common/draw_list.hpp"
#include "common/program/steps_alone.hpp"
#include "common/program/web_description.hpp"
#include "common/program/web_show.hpp"
#include "common/text.hpp"
#include "tests/catch.hpp"
#include "tests/program_toy.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace rigid;

namespace {

struct Command {
    DrawList::Kind kind;
    int colour;
    float opacity, edge, width, dash;
    std::vector<float> numbers;
};

/// A list as its painter reads it.
std::vector<Command> commands_of(const DrawList& list)
{
    std::vector<Command> commands;
    const std::vector<float>& all = list.numbers();
    for (std::size_t i = 0; i < all.size();) {
        REQUIRE(i + 7 <= all.size());
        const auto count = static_cast<std::size_t>(all[i + 6]);
        REQUIRE(i + 7 + count <= all.size());
        commands.push_back({static_cast<DrawList::Kind>(static_cast<int>(all[i])),
                            static_cast<int>(all[i + 1]),
                            all[i + 2],
                            all[i + 3],
                            all[i + 4],
                            all[i + 5],
                            {all.begin() + static_cast<std::ptrdiff_t>(i + 7),
                             all.begin() + static_cast<std::ptrdiff_t>(i + 7 + count)}});
        i += 7 + count;
    }
    return commands;
}

long count_of(const std::vector<Command>& commands, DrawList::Kind kind)
{
    return std::count_if(commands.begin(), commands.end(),
                         [kind](const Command& c) { return c.kind == kind; });
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

Options options_for(const Demo& scene, std::vector<std::string> methods = {})
{
    Options options;
    options.scene = &scene;
    options.settings = default_settings(scene);
    options.methods_given = !methods.empty();
    if (methods.empty()) methods = {options.settings.method};
    options.settings.method = methods.front();
    options.methods = std::move(methods);
    return options;
}

/// A bead whose picture follows the hand, and whose steps do not.
class Seen : public toy::Bead {
public:
    using Bead::Bead;
    void look(const Settings&, const Input& input) override
    {
        if (input.pressed) eye_ = input.pointer;
    }
    void draw(Canvas& canvas) const override { canvas.disc(eye_, 0.1); }

private:
    Vec2 eye_ = {0, 0};
};

}  // namespace

TEST_CASE("a draw list has each item of a canvas in pixels and cuts them off at the pane", "[house]")
{
    Canvas canvas;
    canvas.disc({0.5, 0}, 0.25, {Colour::blue, 2, 0.25, Paint::filled});
    canvas.box({0, 0}, {1, 1}, 0, {Colour::faint, 1, 1, Paint::dashed});
    canvas.arrow({0, 0}, {1, 0}, {Colour::red, 2});
    canvas.text({-1, 1}, "λ\n0", 14, {}, Align::right);
    DrawList list;
    // 100 pixels for a metre, the origin at (110, 120)
    list.paint(canvas, Projection({{0, 0}, {1, 1}}, {10, 20, 200, 200}), 2);
    const std::vector<Command> commands = commands_of(list);
    REQUIRE(commands.size() == 7);
    CHECK(commands[0].kind == DrawList::Kind::clip);
    CHECK(commands[0].numbers == std::vector<float>{10, 20, 200, 200});
    CHECK(commands[1].numbers == std::vector<float>{160, 120, 25});
    CHECK(commands[1].colour == static_cast<int>(Colour::blue));
    CHECK(commands[1].opacity == 0.25f);
    CHECK(commands[1].edge == 0.5f);  // √opacity
    CHECK(commands[1].width == 4);
    CHECK(commands[1].dash == 0);
    CHECK(commands[2].kind == DrawList::Kind::polygon);
    CHECK(commands[2].numbers.size() == 8);
    CHECK(commands[2].opacity == 0);
    CHECK(commands[2].edge == 0.4f);  // faint is ink that steps back
    CHECK(commands[2].dash == 2);
    CHECK(commands[3].kind == DrawList::Kind::line);     // the shaft
    CHECK(commands[4].kind == DrawList::Kind::polygon);  // the head, whose tip is where the arrow ends
    CHECK(commands[4].numbers[2] == 210);
    CHECK(commands[4].numbers[3] == 120);
    CHECK(commands[5].kind == DrawList::Kind::text);
    CHECK(commands[5].numbers == std::vector<float>{10, 20, 28, static_cast<float>(Align::right), 0});
    CHECK(list.words() == "λ 0\n");  // a line for each text, whatever it holds
    CHECK(commands[6].kind == DrawList::Kind::unclip);
}

TEST_CASE("the lines of a text do not stand on each other in a small pane", "[house]")
{
    Canvas canvas;
    canvas.text({0, 1}, "first", 14);
    canvas.text({0, 0.9}, "second", 14);
    canvas.text({0, 0.8}, "third", 14);
    canvas.text({0, 0.2}, "far below", 14);
    const View view = {{0, 0}, {1, 1}};
    DrawList list;
    list.paint(canvas, Projection(view, {0, 0, 100, 100}));  // 5 pixels from line to line
    std::vector<float> heights;
    for (const Command& command : commands_of(list))
        if (command.kind == DrawList::Kind::text) heights.push_back(command.numbers[1]);
    CHECK(heights == std::vector<float>{0, 17.5f, 35, 40 + 12.5f});
    // Where there is room, each stands where the scene has it.
    list.clear();
    list.paint(canvas, Projection(view, {0, 0, 720, 720}));
    heights.clear();
    for (const Command& command : commands_of(list))
        if (command.kind == DrawList::Kind::text) heights.push_back(command.numbers[1]);
    CHECK(heights == std::vector<float>{0, 36, 72, 288});
}

TEST_CASE("what has exploded is left out of a draw list and what is far off is cut", "[house]")
{
    Canvas canvas;
    canvas.disc({infinity, 0}, 1);
    canvas.disc({0, 0}, std::nan(""));
    canvas.disc({1e9, 0}, 1);
    canvas.segment({0, 0}, {std::nan(""), 1});
    canvas.segment({0, 0}, {1e12, 0});
    DrawList list;
    list.paint(canvas, Projection({{0, 0}, {1, 1}}, {0, 0, 200, 200}));
    const std::vector<Command> commands = commands_of(list);
    REQUIRE(count_of(commands, DrawList::Kind::disc) == 0);
    REQUIRE(count_of(commands, DrawList::Kind::line) == 1);
    for (const float number : list.numbers()) CHECK(std::abs(number) <= 1e5f);
}

TEST_CASE("the rows of a panel say what a slider is and its unit and its range", "[house]")
{
    const Program program = toy::program();
    const SliderRow gravity = slider_row(program.scenes[0].tunables[0]);
    CHECK(gravity.label == "g");
    CHECK(gravity.unit == "m/s²");
    CHECK(gravity.format == "%.2f");
    CHECK(gravity.help == "Gravity. From 0 to 16 m/s², at first 8 m/s². Up and down keys");
    const SliderRow beads = slider_row(program.scenes[0].tunables[1]);
    CHECK(beads.format == "%.0f");
    CHECK(beads.whole);
    CHECK(contains(beads.help, "Starts the scene again"));
    const SliderRow h = time_step_row(program.scenes[0]);
    CHECK(h.logarithmic);
    CHECK(h.high == 1);
    CHECK(slider_row({"mass_ratio", "", "", 1, 0.01, 1000}).logarithmic);
    CHECK(slider_row({"mass_ratio", "", "", 1, 0.01, 1000}).label == "mass ratio");
    CHECK(plot_title({"link_error", "mm", ""}) == "link error [mm]");
    CHECK(plot_value(33132.4, 1) == "33132");
    CHECK(plot_value(-2.0749, 1) == "-2.075");
    CHECK(plot_value(-2.0749, 3) == "-2.07");
    CHECK(plot_value(1.23456e6, 1) == "1.235e+06");
    Program compared = program;
    Demo& fall = compared.scenes[0];
    CHECK(grey_curves(fall, fall.columns[0]).empty());
    fall.columns.push_back({"as_it_should_be", "m", "", Plot::linear, "height"});
    CHECK(grey_curves(fall, fall.columns[0]) == "grey: as it should be");
    CHECK(key_rows(fall).back().what == "held down: pulls what is under it");
    fall.held = "turns the view";
    CHECK(key_rows(fall).back().what == "held down: turns the view");
}

TEST_CASE("the description of a program is JSON whatever its texts hold", "[house]")
{
    CHECK(json("a \"b\" \\ \n λ") == "\"a \\\"b\\\" \\\\   λ\"");
    Program program = toy::program();
    program.scenes[0].summary = "\"quoted\" \\ and\ta tab";
    const std::string text = description_of(program);
    CHECK(contains(text, "\"summary\":\"\\\"quoted\\\" \\\\ and a tab\""));
    // As many brackets open as close, outside of texts.
    long depth = 0;
    bool inside = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\') ++i;
        else if (text[i] == '"') inside = !inside;
        else if (!inside && (text[i] == '{' || text[i] == '[')) ++depth;
        else if (!inside && (text[i] == '}' || text[i] == ']')) --depth;
    }
    CHECK(depth == 0);
    CHECK(!inside);
    for (const char* part :
         {"\"name\":\"00_toy\"", "\"methods\":[\"symplectic\",", "\"plots\":[{\"column\":0,",
          "[\"Space\",\"pause and run\"]", "\"steered\":true"})
        CHECK(contains(text, part));
}

TEST_CASE("a run in a page measures what a run without a window measures", "[house]")
{
    const Program program = toy::program();
    const Demo& fall = program.scenes[0];
    const std::vector<Real> rows = rows_of_run(fall, default_settings(fall), {"symplectic"}, 2);
    CHECK(rows == std::vector<Real>{0, 0, 0, 0, 1, 0.5, -2, -4, 2, 1, -6, -8});
    // One that fails has no further rows: of "failing" the start and four steps.
    CHECK(rows_of_run(fall, default_settings(fall), {"failing"}, 100).size() == 5 * 4);
    // The seeded path steers, as without a window.
    const Demo& steered = program.scenes[1];
    const std::vector<Real> path = rows_of_run(steered, default_settings(steered), {""}, 1);
    REQUIRE(path.size() == 8);
    CHECK(path[6] == ScriptedPointer(1, steered.view).at(0).x());
}

TEST_CASE("steps alone are as many as were asked for or as many as there are", "[house]")
{
    const Program program = toy::program();
    const Demo& fall = program.scenes[0];
    Settings settings = default_settings(fall);
    CHECK(steps_alone(fall, settings, 7, 3) == 7);
    settings.method = "failing";
    CHECK(steps_alone(fall, settings, 100, 2) == 4);
}

TEST_CASE("the panes of a page fit their width and the height that they may have", "[house]")
{
    const Program program = toy::program();
    for (const Real width : {340.0, 820.0})
        for (std::size_t count = 1; count <= 4; ++count) {
            const std::vector<std::string> methods = {"symplectic", "explicit", "failing", "exploding"};
            WebShow show(program, options_for(program.scenes[0],
                                              {methods.begin(),
                                               methods.begin() + static_cast<std::ptrdiff_t>(count)}));
            const Real height = show.height(width, 560);
            CAPTURE(width, count);
            CHECK(height > 100);
            CHECK(height <= 560);
            const std::vector<Command> commands = commands_of(show.picture(width, height));
            long clips = 0;
            for (const Command& command : commands) {
                if (command.kind != DrawList::Kind::clip) continue;
                ++clips;
                CHECK(command.numbers[0] >= 0);
                CHECK(command.numbers[0] + command.numbers[2] <= width + 0.01f);
                CHECK(command.numbers[1] + command.numbers[3] <= height + 0.01f);
                CHECK(command.numbers[2] >= 100);  // to be seen on a phone, too
            }
            CHECK(clips == static_cast<long>(count));
        }
}

TEST_CASE("a pull in one pane goes on outside of it and ends when the pointer is lifted", "[house]")
{
    const View view = {{0, 0}, {1, 1}};
    const std::vector<Projection> panes = {Projection(view, {0, 0, 100, 100}),
                                           Projection(view, {100, 0, 100, 100})};
    constexpr bool down = true, up = false, elsewhere = true, here = false;
    Hand hand;
    hand.read(panes, {50, 50}, up, here);
    CHECK(hand.input().present);
    CHECK_FALSE(hand.input().pressed);
    hand.read(panes, {75, 50}, down, here);
    CHECK(hand.input().pressed);
    CHECK(hand.input().pointer.x() == Approx(0.5));
    hand.read(panes, {175, 50}, down, elsewhere);  // over the other pane: still the first one's, at its edge
    CHECK(hand.input().pressed);
    CHECK(hand.input().pointer.x() == Approx(1));
    hand.read(panes, {175, 50}, up, elsewhere);
    CHECK_FALSE(hand.input().present);
    // A button that was pressed elsewhere pulls nothing.
    hand.read(panes, {300, 50}, down, elsewhere);
    hand.read(panes, {150, 50}, down, here);
    CHECK(hand.input().present);
    CHECK_FALSE(hand.input().pressed);
}

TEST_CASE("the seeded path of a page steers until the pointer comes", "[house]")
{
    const Program program = toy::program();
    WebShow show(program, options_for(program.scenes[1]));
    show.show().set_script(true);
    show.picture(400, 300);
    show.single_step();
    const auto place = [&] { return show.show().playback()->tracks()[0].measured[0]; };
    CHECK(place() == ScriptedPointer(1, program.scenes[1].view).at(0).x());
    constexpr bool present = true, down = false;
    show.point({200, 160}, present, down);
    show.single_step();
    CHECK(place() == Approx(1).margin(1e-12));  // the middle of the view
    CHECK_FALSE(show.show().is_scripted());
}

TEST_CASE("a picture follows the hand while the run is paused", "[house]")
{
    Program program = toy::program();
    program.scenes[0].start = [](const Settings& settings) { return std::make_unique<Seen>(settings); };
    WebShow show(program, options_for(program.scenes[0]));
    const auto disc = [&] {
        for (const Command& command : commands_of(show.picture(400, 300)))
            if (command.kind == DrawList::Kind::disc) return command.numbers;
        return std::vector<float>{};
    };
    const std::vector<float> before = disc();
    REQUIRE(before.size() == 3);
    constexpr bool present = true, down = true;
    show.point({before[0], before[1]}, present, !down);
    show.point({before[0] + 50, before[1]}, present, down);
    const std::vector<float> after = disc();
    CHECK(after[0] == Approx(before[0] + 50));
    CHECK(show.show().playback()->steps() == 0);
}

TEST_CASE("a page that gives no numbers is refused and its pull goes on with the next", "[house]")
{
    const Program program = toy::program();
    WebShow show(program, options_for(program.scenes[0]));
    show.show().set_h(0.01);
    show.picture(300, 200);
    show.point({150, 100}, true, true);
    CHECK(show.pressed());
    show.point({NAN, 100}, true, true);
    CHECK_FALSE(show.pressed());
    show.point({150, 100}, true, true);
    CHECK(show.pressed());
    CHECK_THROWS_WITH(show.advance(NAN),
                      "the time since the last frame is nan; it must be zero or positive, and finite");
    show.advance(0.1);
    CHECK(show.show().playback()->steps() > 0);

    CHECK(seed_of(7) == 7);
    CHECK(seed_of(0x1p53) == std::uint64_t{1} << 53);
    for (const Real number : {Real(NAN), -1.0, 0.5, 1e17})
        CHECK_THROWS_WITH(seed_of(number),
                          "the seed is " + shortest(number) + "; it must be a whole number from 0 to 2^53");
}

TEST_CASE("a page that was hidden does not catch up", "[house]")
{
    const Program program = toy::program();
    WebShow show(program, options_for(program.scenes[0]));
    show.show().set_h(0.01);
    show.advance(3600);
    CHECK(show.show().playback()->steps() <= 10);  // a tenth of a second at most
}

TEST_CASE("a plot leaves out what its logarithm does not have and shows where a run stands", "[house]")
{
    Program program = toy::program();
    program.scenes[0].columns[1].plot = Plot::logarithmic;  // of speeds that are zero and then negative
    WebShow show(program, options_for(program.scenes[0]));
    for (int i = 0; i < 3; ++i) show.single_step();
    constexpr bool whole_run = false;
    const TimeSpan span = plot_span(show.show(), whole_run);
    CHECK(span.begin == 0);
    CHECK(span.end == 1.5);
    // zero, where it starts, lies on the lower edge
    const std::optional<LivePlot> of_speed = plot_of(show.show(), 1, span, whole_run);
    REQUIRE(of_speed);
    CHECK(of_speed->low_text == "0");
    CHECK(of_speed->high_text.empty());
    CHECK(of_speed->curves[0].front() == std::vector<Vec2>{{0, 0}});
    CHECK(of_speed->curves[0].back().empty());
    const std::optional<LivePlot> plot = plot_of(show.show(), 0, span, whole_run);
    REQUIRE(plot);
    CHECK(plot->high == 0);
    CHECK(plot->low == -12);  // -2 - 4 - 6, by symplectic Euler with h = 0.5 s and g = 8 m/s²
    CHECK(plot->low_text == "-12");
    REQUIRE(plot->curves[0].front().size() == 4);
    CHECK(plot->curves[0].front().back() == Vec2(1, 0));
    CHECK(count_of(commands_of(show.plot(0, 300, 60, whole_run)), DrawList::Kind::line) >= 2);
}
