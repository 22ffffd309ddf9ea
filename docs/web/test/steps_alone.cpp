/// \file steps_alone.cpp
/// A chapter's program that is asked for the time of its steps alone (target NN_name_steps, for step_times.mjs):
///
///     NN_name_steps SCENE STEPS STARTS [NAME=VALUE …]
///
/// It is linked with the chapter's own main() and stands in place of run_program(). It prints how many steps a start has
/// made and how long all took: microseconds of the processor, not of a clock, as other programs may run beside it.
#include "common/program/steps_alone.hpp"

#include <cstdlib>
#include <ctime>
#include <iostream>

int rigid::run_program(const std::function<Program()>& make, int argc, char** argv)
{
    const Program program = make();
    const Demo* scene = nullptr;
    for (const Demo& one : program.scenes)
        if (argc > 3 && one.name == argv[1]) scene = &one;
    if (scene == nullptr) {
        std::cerr << "this wants SCENE STEPS STARTS [NAME=VALUE …], SCENE one of the program's\n";
        return 2;
    }
    Settings settings = default_settings(*scene);
    for (int i = 4; i < argc; ++i) {
        const std::string word = argv[i];
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos || !settings.tunables.contains(word.substr(0, equals))) {
            std::cerr << "scene " << scene->name << " has no tunable for \"" << word << "\"\n";
            return 2;
        }
        settings.tunables[word.substr(0, equals)] = std::atof(word.c_str() + equals + 1);
    }
    const std::clock_t before = std::clock();
    const long made = steps_alone(*scene, settings, std::atol(argv[2]), std::atol(argv[3]));
    std::cout << made << ' ' << 1e6 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC << '\n';
    return 0;
}
