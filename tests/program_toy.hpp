/// \file program_toy.hpp
/// A program for the tests of the shell: a bead that falls, in numbers that can be checked by hand.
#pragma once

#include "common/program/program.hpp"

#include <cmath>
#include <csignal>
#include <fstream>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace rigid::toy {

/// Falls along y with the gravity `g`; in the scene `steered` it stands where the pointer is.
class Bead : public Run {
public:
    explicit Bead(const Settings& settings) : method_(settings.method), steered_(settings.scene == "steered")
    {
        if (settings["beads"] == 13) throw std::invalid_argument("beads is 13; it must be a luckier number");
        if (settings["beads"] == 17) throw std::bad_alloc();
    }

    void step(const Settings& settings, const Input& input) override
    {
        ++steps_;
        if (method_ == "failing" && steps_ == 5) throw StepFailure("the bead 0 has left the wire");
        if (method_ == "interrupting" && steps_ == 5) std::raise(SIGINT);
        if (method_ == "terminating" && steps_ == 5) std::raise(SIGTERM);
        if (method_ == "hungry" && steps_ == 5) throw std::bad_alloc();
        if (method_ == "exploding") speed_ = steps_ < 5 ? std::pow(10.0, 75 * steps_) : infinity;
        if (steered_) {
            place_ = input.pointer;
            return;
        }
        if (method_ == "explicit") place_.y() += settings.h * speed_;
        speed_ -= settings.h * settings["g"];
        if (method_ != "explicit") place_.y() += settings.h * speed_;
    }

    void draw(Canvas& canvas) const override
    {
        canvas.box({0, 0}, {0.9, 0.9}, 0, {Colour::ink, 2});
        canvas.segment({-0.9, -0.5}, {0.9, -0.5}, {Colour::faint, 1, 1, Paint::dashed});
        canvas.disc(place_, 0.1, {Colour::blue, 1.5, 0.4, Paint::filled});
        canvas.arrow(place_, place_ + Vec2(0.3, speed_), {Colour::orange, 2});
        canvas.polygon({{0.2, 0.2}, {0.6, 0.2}, {0.6, 0.6}, {0.45, 0.35}},
                       {Colour::purple, 1, 0.3, Paint::filled});
        canvas.text({-0.8, 0.7}, "0 ≤ λ & w \"⟂\" <b>", 14);
    }

    std::vector<Real> measure() const override { return {steered_ ? place_.x() : place_.y(), speed_}; }

private:
    std::string method_;
    bool steered_;
    long steps_ = 0;
    Vec2 place_ = {0, 0};
    Real speed_ = 0;
};

inline Program program()
{
    Demo fall;
    fall.name = "fall";
    fall.summary = "A bead that falls.";
    fall.h = 0.5;
    fall.h_low = 0.001;
    fall.h_high = 1;
    fall.methods = {"symplectic",   "explicit",    "failing", "exploding",
                    "interrupting", "terminating", "hungry"};
    fall.tunables = {{"g", "m/s²", "Gravity", 8, 0, 16, Numbers::real, OnChange::goes_on, Keys::up_and_down},
                     {"beads", "", "How many beads", 1, 1, 20, Numbers::whole, OnChange::restarts}};
    fall.columns = {{"height", "m", "Where it is", Plot::linear},
                    {"speed", "m/s", "How fast it is", Plot::linear}};
    fall.start = [](const Settings& settings) { return std::make_unique<Bead>(settings); };
    Demo steered = fall;
    steered.name = "steered";
    steered.summary = "A bead under the pointer.";
    steered.steered = true;
    steered.view = {{1, 2}, {3, 1.5}};
    steered.methods.clear();

    Program result;
    result.name = "00_toy";
    result.title = "Chapter 0. A toy";
    result.scenes = {fall, steered};
    result.solve_problem = [](const std::string& file, const std::string& method) {
        std::ifstream stream(file);
        std::string word;
        stream >> word;
        if (word != "good")
            throw std::invalid_argument(file + ":1: \"" + word + "\" is no section; it must be good");
        std::cout << "status solved by " << method << '\n';
        return 0;
    };
    result.problem_methods = {"enumerate", "schur"};
    result.own_files = {{"--echo", "Write a word and end", [](std::ostream& file) { file << "heard\n"; }}};
    return result;
}

}  // namespace rigid::toy
