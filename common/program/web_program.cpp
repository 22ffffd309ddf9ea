/// \file web_program.cpp
/// run_program() in a page: main() describes the program, and the page asks for the rest by the functions at the end.
/// Texts go in and out as UTF-8 that ends with a zero, lists of numbers as a place in memory and a count. A function
/// that can fail returns 0, or 1 and a sentence in web_sentence().
#include "common/program/program.hpp"
#include "common/program/steps_alone.hpp"
#include "common/program/web_calls.hpp"
#include "common/program/web_description.hpp"
#include "common/program/web_show.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

int chapter_main(int argc,
                 char** argv);  // the chapter's main(), under the name that cmake/web.cmake gives it

namespace rigid {
namespace {

/// All that a page of one program has.
struct Page {
    Program program;
    Options options;                ///< of the next show
    std::unique_ptr<WebShow> show;  ///< empty until web_open()
    std::string incoming;
    std::vector<Real> rows;
    const DrawList* list = nullptr;
};

Page& page()
{
    static Page one;
    return one;
}

const Demo& scene_called(const std::string& name)
{
    for (const Demo& scene : page().program.scenes)
        if (scene.name == name || name.empty()) return scene;
    throw std::invalid_argument("there is no scene \"" + name + "\"");
}

void choose(const std::string& name)
{
    Options& options = page().options;
    options = {};
    options.scene = &scene_called(name);
    options.settings = default_settings(*options.scene);
    options.methods = {options.settings.method};
}

void set(Options& options, const std::string& name, Real value)
{
    Settings& settings = options.settings;
    if (name == "h") settings.h = value;
    else if (name == "seed") settings.seed = seed_of(value);
    else if (settings.tunables.contains(name)) settings.tunables[name] = value;
    else throw std::invalid_argument("scene " + options.scene->name + " has no tunable \"" + name + '"');
}

}  // namespace

int run_program(const std::function<Program()>& make, int, char**)
{
    page().program = make();
    return 0;
}

}  // namespace rigid

using namespace rigid;

// ---- the program -----------------------------------------------------------------------------------

RIGID_PAGE(web_start) int web_start()
{
    return attempt([] { chapter_main(0, nullptr); });
}
RIGID_PAGE(web_description) const char* web_description() { return said(description_of(page().program)); }
RIGID_PAGE(web_sentence) const char* web_sentence() { return last_said().sentence.c_str(); }
/// Room for a text of so many bytes, which the next function reads.
RIGID_PAGE(web_text) char* web_text(int bytes)
{
    page().incoming.assign(static_cast<std::size_t>(bytes), '\0');
    return page().incoming.data();
}

// ---- a show: the scene in web_text(), then its settings, then open --------------------------------

RIGID_PAGE(web_choose) int web_choose()
{
    return attempt([] { choose(page().incoming); });
}
RIGID_PAGE(web_with_method) int web_with_method()
{
    Options& options = page().options;
    if (!options.methods_given) options.methods.clear();
    options.methods_given = true;
    options.methods.push_back(page().incoming);
    options.settings.method = options.methods.front();
    return 0;
}
RIGID_PAGE(web_with_setting) int web_with_setting(double value)
{
    return attempt([&] { set(page().options, page().incoming, value); });
}
RIGID_PAGE(web_open) int web_open()
{
    return attempt([] { page().show = std::make_unique<WebShow>(page().program, page().options); });
}

// ---- what the reader changes -----------------------------------------------------------------------

RIGID_PAGE(web_scene) int web_scene(int index)
{
    return attempt([&] { page().show->show().choose_scene(static_cast<std::size_t>(index)); });
}
RIGID_PAGE(web_method) int web_method(int index, int on)
{
    return attempt([&] { page().show->show().choose_method(static_cast<std::size_t>(index), on != 0); });
}
/// The slider at this place: the tunables, then the time step.
RIGID_PAGE(web_slide) int web_slide(int index, double value)
{
    return attempt([&] {
        Show& show = page().show->show();
        const std::vector<Tunable>& tunables = show.scene().tunables;
        const auto i = static_cast<std::size_t>(index);
        if (i < tunables.size()) show.set_tunable(tunables[i], value);
        else show.set_h(value);
    });
}
RIGID_PAGE(web_arrow) int web_arrow(int direction)
{
    return attempt([&] { page().show->show().change_by_arrow(direction); });
}
RIGID_PAGE(web_seed) int web_seed(double seed)
{
    return attempt([&] { page().show->show().set_seed(seed_of(seed)); });
}
RIGID_PAGE(web_restart) int web_restart()
{
    return attempt([] { page().show->show().restart(); });
}
RIGID_PAGE(web_pause) void web_pause(int paused) { page().show->show().paused = paused != 0; }
RIGID_PAGE(web_speed) void web_speed(double speed) { page().show->show().speed = speed; }
RIGID_PAGE(web_script) void web_script(int on) { page().show->show().set_script(on != 0); }
RIGID_PAGE(web_point) void web_point(double x, double y, int present, int down)
{
    page().show->point({x, y}, present != 0, down != 0);
}

// ---- what it shows -----------------------------------------------------------------------------------

RIGID_PAGE(web_advance) int web_advance(double seconds)
{
    return attempt([&] { page().show->advance(seconds); });
}
RIGID_PAGE(web_step) int web_step()
{
    return attempt([] { page().show->single_step(); });
}
/// 1 if no step can follow.
RIGID_PAGE(web_over) int web_over() { return page().show->show().is_over() ? 1 : 0; }
RIGID_PAGE(web_state) const char* web_state() { return said(state_of(page().show->show())); }
RIGID_PAGE(web_height) double web_height(double width, double most)
{
    return page().show->height(width, most);
}
RIGID_PAGE(web_picture) int web_picture(double width, double height)
{
    page().list = &page().show->picture(width, height);
    return static_cast<int>(page().list->numbers().size());
}
RIGID_PAGE(web_plot) int web_plot(int column, double width, double height, int whole_run)
{
    page().list = &page().show->plot(static_cast<std::size_t>(column), width, height, whole_run != 0);
    return static_cast<int>(page().list->numbers().size());
}
RIGID_PAGE(web_numbers) const float* web_numbers() { return page().list->numbers().data(); }
RIGID_PAGE(web_words) const char* web_words() { return page().list->words().c_str(); }

// ---- for the tests -----------------------------------------------------------------------------------

/// 1 while the hand pulls.
RIGID_PAGE(web_pressed) int web_pressed() { return page().show->pressed() ? 1 : 0; }
/// The rows of a run without a window, of what was chosen by web_choose() and its companions: how many numbers.
RIGID_PAGE(web_run) int web_run(int steps)
{
    page().rows.clear();
    attempt([&] {
        const Options& options = page().options;
        page().rows = rows_of_run(*options.scene, options.settings, options.methods, steps);
    });
    return static_cast<int>(page().rows.size());
}
RIGID_PAGE(web_rows) const double* web_rows() { return page().rows.data(); }
/// So many starts of what was chosen, with so many steps after each, and nothing else: how many steps the last one made.
RIGID_PAGE(web_steps) int web_steps(int steps, int starts)
{
    long made = 0;
    attempt([&] { made = steps_alone(*page().options.scene, page().options.settings, steps, starts); });
    return static_cast<int>(made);
}
