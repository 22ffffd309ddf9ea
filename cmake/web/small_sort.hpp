// Before every source of the preset web: libc++'s std::sort is 3 to 9 kB for each kind of thing that is sorted, a
// twentieth of chapter 19's page, and its std::stable_sort no less. These are a tenth of that. What is sorted by sort()
// here has one order, and what is sorted by stable_sort() has one by what it is, so it is the same.
#pragma once

#ifdef __EMSCRIPTEN__
#define sort rigid_sort_of_the_library
#define stable_sort rigid_stable_sort_of_the_library
#include <algorithm>
#undef sort
#undef stable_sort
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace std {

// Each value is moved down past those that come after it. What is in order already costs a comparison each.
template <class At, class Less>
void rigid_insert_each(At first, At last, const Less& less)
{
    for (At next = first; next != last; ++next) {
        auto value = std::move(*next);
        At place = next;
        for (; place != first && less(value, *(place - 1)); --place) *place = std::move(*(place - 1));
        *place = std::move(value);
    }
}

template <class At, class Less>
void sort(At first, At last, Less less)
{
    if (last - first <= 16) return rigid_insert_each(first, last, less);
    if (is_sorted(first, last, less)) return;
    make_heap(first, last, less);
    sort_heap(first, last, less);
}

// Two halves in order, of which the first is kept aside; of equal values that of the first half goes first.
template <class At, class Less>
void rigid_sort_halves(At first, At last, const Less& less)
{
    if (last - first <= 16) return rigid_insert_each(first, last, less);
    At right = first + (last - first) / 2;
    rigid_sort_halves(first, right, less);
    rigid_sort_halves(right, last, less);
    vector<typename iterator_traits<At>::value_type> aside(make_move_iterator(first),
                                                           make_move_iterator(right));
    for (auto left = aside.begin(); left != aside.end(); ++first)
        if (right != last && less(*right, *left)) *first = std::move(*right++);
        else *first = std::move(*left++);
}

template <class At, class Less>
void stable_sort(At first, At last, Less less)
{
    rigid_sort_halves(first, last, less);
}
template <class At>
void sort(At first, At last)
{
    std::sort(first, last, less<>{});
}

}  // namespace std
#endif
