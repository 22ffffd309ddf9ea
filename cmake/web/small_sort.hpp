// Before every source of the preset web: libc++'s std::sort is 3 to 9 kB for each kind of thing that is sorted, a
// twentieth of chapter 19's page. This one is a tenth of that. What is sorted here has one order, so it is the same.
#pragma once

#ifdef __EMSCRIPTEN__
#define sort rigid_sort_of_the_library
#include <algorithm>
#undef sort
#include <functional>
#include <utility>

namespace std {

template <class At, class Less>
void sort(At first, At last, Less less)
{
    if (last - first > 16) {
        if (is_sorted(first, last, less)) return;
        make_heap(first, last, less);
        sort_heap(first, last, less);
        return;
    }
    for (At next = first; next != last; ++next) {
        auto value = std::move(*next);
        At place = next;
        for (; place != first && less(value, *(place - 1)); --place) *place = std::move(*(place - 1));
        *place = std::move(value);
    }
}
template <class At>
void sort(At first, At last)
{
    std::sort(first, last, less<>{});
}

}  // namespace std
#endif
