#include "common/program/progress.hpp"

#include "common/text.hpp"

#include <iostream>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace rigid {
namespace {

bool stderr_is_terminal()
{
#ifdef _WIN32
    return _isatty(2) != 0;
#else
    return isatty(2) != 0;
#endif
}

}  // namespace

Progress::Progress(long steps) : steps_(steps), terminal_(stderr_is_terminal()) {}

void Progress::show(long step)
{
    // The clock is read once in a while only: a step may take less than a microsecond.
    if (!terminal_ || step % 16 != 0) return;
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(200);
    const double passed = std::chrono::duration<double>(now - start_).count();
    const double done = static_cast<double>(step) / static_cast<double>(steps_);
    std::cerr << "\rstep " << step << " of " << steps_ << " (" << fixed(100 * done, 0) << " %), about "
              << fixed(passed / done - passed, 0) << " s left \x1b[K" << std::flush;
    shown_ = true;
}

void Progress::clear()
{
    if (shown_) std::cerr << "\r\x1b[K" << std::flush;
    shown_ = false;
}

}  // namespace rigid
