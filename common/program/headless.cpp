#include "common/program/headless.hpp"

#include "common/program/interrupt.hpp"
#include "common/program/offscreen.hpp"
#include "common/program/outputs.hpp"
#include "common/program/playback.hpp"
#include "common/program/progress.hpp"
#include "common/program/scripted_pointer.hpp"
#include "common/program/table.hpp"
#include "common/svg_canvas.hpp"

#include <filesystem>
#include <iostream>
#include <optional>

namespace rigid {

int run_headless(const Program& program, const Options& options)
{
    const Demo& scene = *options.scene;
    const long steps = options.steps.value_or(300);
    InterruptGuard guard;

    // Everything that can be refused is refused before the first step.
    require_different_files(options);
    Playback playback(scene, options.settings, options.methods);
    if (!options.svg.empty()) require_writable("the picture", options.svg);
    if (!options.png.empty()) require_writable("the picture", options.png);
    if (!options.record.empty()) require_folder(options.record);
    std::unique_ptr<PicturePainter> painter;
    if (!options.png.empty() || !options.record.empty()) {
        std::string reason;
        painter = make_offscreen_painter(options.dark, reason);
        if (!painter && !options.png.empty())
            throw std::invalid_argument("--png " + options.png + " needs OpenGL without a window, and " +
                                        reason + "; --svg needs nothing");
        if (!painter) std::cerr << "The frames are written as SVG: " << reason << ".\n";
    }
    std::optional<Table> table;
    if (!options.csv.empty()) table.emplace(options.csv, scene, options.methods.size());

    const auto record = [&] {
        if (options.record.empty() || playback.steps() % options.every != 0) return;
        const std::string name = frame_name(playback.steps() / options.every, painter ? ".png" : ".svg");
        const std::string file = (std::filesystem::path(options.record) / name).string();
        if (painter) painter->write_png(file, playback.draw());
        else write_svg(file, playback.draw());
    };

    const ScriptedPointer pointer(options.settings.seed, scene.view);
    {
        Progress progress(steps);
        if (table) table->add(playback.tracks());
        record();
        while (playback.steps() < steps && playback.can_go_on() && !InterruptGuard::interrupted()) {
            Input input;
            if (scene.steered) input = {.pointer = pointer.at(playback.time()), .present = true};
            playback.step(input);
            if (table) table->add(playback.tracks());
            record();
            progress.show(playback.steps());
        }
    }
    if (!options.svg.empty()) write_svg(options.svg, playback.draw());
    if (!options.png.empty()) painter->write_png(options.png, playback.draw());
    if (options.csv.empty() && options.svg.empty() && options.png.empty() && options.record.empty())
        std::cout << summary(program, playback) << std::flush;

    for (const std::string& sentence : playback.failures()) std::cerr << sentence << '\n';
    if (InterruptGuard::interrupted()) {
        std::cerr << "Interrupted after step " << playback.steps()
                  << "; what was written is complete up to there.\n";
        return 128 + InterruptGuard::signal();
    }
    return playback.failures().empty() ? 0 : 3;
}

}  // namespace rigid
