/// \file jobs.hpp
/// Work that a caller's threads may share: in pieces of which none waits for another.
#pragma once

#include <algorithm>
#include <functional>

namespace rigid {

//! [jobs]
/// Calls piece(0) … piece(count − 1), each once, in any order and on any threads,
/// and returns when all of them have. Empty: the caller does them itself. No piece
/// throws, nor writes what another one reads; so nobody sees in which order they
/// were done.
using Jobs = std::function<void(int count, const std::function<void(int)>& piece)>;
//! [jobs]

/// Calls work(first, end) for the numbers below count, so many at a time where there is help.
template <class Work>
void in_pieces(const Jobs& jobs, int count, int length, const Work& work)
{
    const int pieces = (count + length - 1) / length;
    if (count == 0) return;
    if (!jobs || pieces < 2) return work(0, count);
    jobs(pieces, [&](int i) { work(i * length, std::min(count, (i + 1) * length)); });
}

}  // namespace rigid
