/// \file interrupt.hpp
/// Ctrl-C ends a run, and so does SIGTERM: it finishes its row and closes its files. A second one ends it at
/// once.
#pragma once

#include <csignal>

namespace rigid {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM only set a flag.
class InterruptGuard {
public:
    InterruptGuard()
    {
        flag() = 0;
        interrupt_before_ = std::signal(SIGINT, &InterruptGuard::note);
        terminate_before_ = std::signal(SIGTERM, &InterruptGuard::note);
    }
    ~InterruptGuard()
    {
        std::signal(SIGINT, interrupt_before_ == SIG_ERR ? SIG_DFL : interrupt_before_);
        std::signal(SIGTERM, terminate_before_ == SIG_ERR ? SIG_DFL : terminate_before_);
    }
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    static bool interrupted() { return flag() != 0; }
    /// Which signal it was; a program that ends by it returns 128 more, as shells do. 0 = none.
    static int signal() { return flag(); }

private:
    // A signal handler has no other way to speak than a static flag.
    static volatile std::sig_atomic_t& flag()
    {
        static volatile std::sig_atomic_t value = 0;
        return value;
    }
    static void note(int signal)
    {
        flag() = signal;
        std::signal(signal, SIG_DFL);
    }
    void (*interrupt_before_)(int) = SIG_DFL;
    void (*terminate_before_)(int) = SIG_DFL;
};

}  // namespace rigid
