// Before every source of the preset web: its programs have one thread, which nobody can make wait. The library's mutex brings
// its errors with it, their texts and the printf() that writes them: 4 kB of chapter 19's page.
#pragma once

#ifdef __EMSCRIPTEN__
#define mutex rigid_mutex_of_the_library
#include <mutex>
#undef mutex

namespace std {

struct mutex {
    void lock() {}
    void unlock() {}
    bool try_lock() { return true; }
};

}  // namespace std
#endif
