/// \file progress.hpp
/// One line on the terminal that says how far long work is. Nothing where stderr is no terminal.
#pragma once

#include <chrono>
#include <string>

namespace rigid {

class Progress {
public:
    explicit Progress(long steps);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Says something five times a second at most, and nothing in the first second.
    void show(long step);
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    long steps_;
    bool terminal_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now(), next_ = start_ + std::chrono::seconds(1);
};

}  // namespace rigid
