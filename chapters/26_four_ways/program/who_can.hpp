/// \file who_can.hpp
/// Who can do what: every way on every scene, as the lines of the tables of the text.
#pragma once

#include "chapters/26_four_ways/ways.hpp"

#include <cstdio>
#include <string>
#include <vector>

namespace rigid {

/// A number with one digit, as 20, 0.3, 2e-9.
inline std::string one_digit(Real value)
{
    if (value < 1e-14) return "0";  // rounding
    char text[32];
    std::snprintf(text, sizeof text, value >= 1 ? "%.0f" : "%.1g", value);
    std::string short_text = text;  // 2e-09 → 2e-9
    const std::size_t zero = short_text.find("e-0");
    if (zero != std::string::npos) short_text.erase(zero + 2, 1);
    return short_text;
}

inline std::string signed_digit(Real value)
{
    return (value < 0 ? "−" : "+") + one_digit(std::abs(value));
}

/// |C| and |dC/dt|.
inline std::string drift_cell(const WayDrift& drift)
{
    return one_digit(drift.C) + ", " + one_digit(drift.rate);
}

/// What a run came to, in a word: its error, or why there is none.
inline std::string cell(Way way, const WayScene& scene, const WayResult& result)
{
    if (!can_take(way, scene)) return "–";
    if (result.why_not == "it flies apart") return "gone";
    if (result.why_not == "infeasible" || result.why_not == "ray termination")
        return "no force";
    if (!result.why_not.empty()) return "stops";
    return one_digit(result.error);
}

inline std::string line_of(const std::vector<std::string>& cells)
{
    std::string line = "|";
    for (const std::string& one : cells) line += " " + one + " |";
    return line;
}

/// The error of each way at a step of h: one line a scene.
inline std::vector<std::string> error_table(const std::vector<WayScene>& scenes,
                                            Real h)
{
    std::vector<std::string> lines;
    for (const WayScene& scene : scenes) {
        std::vector<std::string> cells{scene.name};
        for (const Way way : all_ways)
            cells.push_back(
                cell(way, scene, run_way(way, scene, h, settings_of(scene))));
        lines.push_back(line_of(cells));
    }
    return lines;
}

/// 1/h of the longest step, of 1/15, 1/30 … 1/3840 s, from which on every shorter one will do: one line a scene.
/// \param will_do  bool(const WayResult&)
template <class WillDo>
std::vector<std::string> longest_steps(const std::vector<WayScene>& scenes,
                                       const WillDo& will_do)
{
    std::vector<std::string> lines;
    for (const WayScene& scene : scenes) {
        std::vector<std::string> cells{scene.name};
        for (const Way way : all_ways) {
            std::string longest = "–";
            for (int n = 3840; can_take(way, scene) && n >= 15; n /= 2) {
                if (!will_do(run_way(way, scene, 1.0 / n, settings_of(scene))))
                    break;
                longest = std::to_string(n);
            }
            cells.push_back(longest);
        }
        lines.push_back(line_of(cells));
    }
    return lines;
}

/// Which ends within `most` of the truth.
inline std::vector<std::string> step_table(const std::vector<WayScene>& scenes,
                                           Real most)
{
    return longest_steps(scenes, [most](const WayResult& result) {
        return result.why_not.empty() && result.error <= most;
    });
}

/// Which goes through: nothing flies apart, and each step has an answer.
inline std::vector<std::string> stable_table(const std::vector<WayScene>& scenes)
{
    return longest_steps(
        scenes, [](const WayResult& result) { return result.why_not.empty(); });
}

/// The energy that each way has gained at its end [J], of the scenes that keep theirs.
inline std::vector<std::string> energy_table(const std::vector<WayScene>& scenes,
                                             Real h)
{
    std::vector<std::string> lines;
    for (const WayScene& scene : scenes) {
        if (!scene.keeps_energy) continue;
        std::vector<std::string> cells{scene.name};
        for (const Way way : all_ways) {
            const WayResult result = run_way(way, scene, h, settings_of(scene));
            std::string word = cell(way, scene, result);
            if (result.why_not.empty()) word = signed_digit(result.energy_gain);
            cells.push_back(word);
        }
        lines.push_back(line_of(cells));
    }
    return lines;
}

/// How far its constraints are off at its end.
inline std::vector<std::string> drift_table(const std::vector<WayScene>& scenes,
                                            Real h)
{
    std::vector<std::string> lines;
    for (const WayScene& scene : scenes) {
        std::vector<std::string> cells{scene.name};
        for (const Way way : all_ways) {
            const WayResult result = run_way(way, scene, h, settings_of(scene));
            cells.push_back(result.why_not.empty() ? drift_cell(result.drift)
                                                   : cell(way, scene, result));
        }
        lines.push_back(line_of(cells));
    }
    return lines;
}

/// The order in h: log₂ of the ratio of the errors at 960 and 1920 steps a second. None where an error is rounding, is not of the
/// step (the sag of springs), or falls by less than a fifth.
inline std::vector<std::string> order_table(const std::vector<WayScene>& scenes)
{
    std::vector<std::string> lines;
    for (const WayScene& scene : scenes) {
        std::vector<std::string> cells{scene.name};
        for (const Way way : all_ways) {
            const auto error = [&](int n) {
                return run_way(way, scene, 1.0 / n, settings_of(scene)).error;
            };
            std::string word = "–";
            if (can_take(way, scene)) {
                const Real coarse = error(960), fine = error(1920);
                if (fine < 1e-11 || !(coarse < 1)) word = "·";
                else if (!(coarse > 1.2 * fine)) word = "·";
                else {
                    char text[16];
                    std::snprintf(text, sizeof text, "%.1f",
                                  rigid::log2(coarse / fine));
                    word = text;
                }
            }
            cells.push_back(word);
        }
        lines.push_back(line_of(cells));
    }
    return lines;
}

}  // namespace rigid
