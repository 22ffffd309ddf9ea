/// \file interrupt.hpp
/// Ctrl-C asks a run to end: it finishes its row and closes its files. A second Ctrl-C ends it at once.
#pragma once

#include <csignal>

namespace rigid {

/// While it lives, Ctrl-C (SIGINT) only sets a flag.
class InterruptGuard {
public:
    InterruptGuard()
    {
        flag() = 0;
        before_ = std::signal(SIGINT, &InterruptGuard::note);
    }
    ~InterruptGuard() { std::signal(SIGINT, before_ == SIG_ERR ? SIG_DFL : before_); }
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    static bool interrupted() { return flag() != 0; }

private:
    // A signal handler has no other way to speak than a static flag.
    static volatile std::sig_atomic_t& flag()
    {
        static volatile std::sig_atomic_t value = 0;
        return value;
    }
    static void note(int)
    {
        flag() = 1;
        std::signal(SIGINT, SIG_DFL);
    }
    void (*before_)(int) = SIG_DFL;
};

}  // namespace rigid
