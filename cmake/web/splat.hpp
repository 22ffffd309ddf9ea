// Before every source of the preset web. Where a number that is read from memory goes into both halves of a pair, Emscripten
// 3.1.6 (LLVM 14) makes one instruction of both, v128.load64_splat, and forgets that it reads: it moves behind a later write
// to the same place. Eigen's p = R * p then took x from the new p, the pieces of a flywheel in chapter 25 had no area, and
// its closed form was no number. A number that has passed through a register is read before. What is left are a few places
// where the compiler itself makes a pair of two numbers that it reads: docs/web/test/same_bits.mjs would see a wrong one.
#pragma once
#include <emmintrin.h>

inline __attribute__((__always_inline__)) __m128d rigid_both_halves(double number)
{
    if (!__builtin_constant_p(number)) asm("" : "+r"(number));
    return _mm_set1_pd(number);
}
#define _mm_set1_pd rigid_both_halves
