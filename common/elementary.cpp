/// \file elementary.cpp
/// How the elementary functions are worked out: the argument is reduced to a small one, exactly or to twice the digits
/// of a Real; a polynomial does the rest. Its coefficients are made by docs/tools/elementary_coefficients.py.
///
/// A number with twice the digits is an unevaluated sum of two Reals (double-double, \cite dekker1971). The leading term
/// of a result is such a pair, and what a polynomial adds is small beside it; so its rounding hardly shows.

#include "common/elementary.hpp"

#include <cfloat>
#include <cstdint>

static_assert(
    FLT_EVAL_METHOD == 0,
    "sums and products are not rounded to double one by one here (x87?): the same bits as elsewhere "
    "need a processor's instructions for doubles, for example by -msse2 -mfpmath=sse");
#ifdef __FAST_MATH__
#error "-ffast-math reorders sums and drops infinities: the physics of this book needs both as they are"
#endif

namespace rigid {
namespace {

// ---- numbers with twice the digits ------------------------------------------------------------------

/// The number hi + lo.
struct Pair {
    Real hi, lo;
};

/// a + b without error.
Pair exact_sum(Real a, Real b)
{
    const Real sum = a + b, part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

/// a + b without error, for |a| ≥ |b|.
Pair exact_short_sum(Real a, Real b)
{
    const Real sum = a + b;
    return {sum, b - (sum - a)};
}

/// a b without error, by halves of 26 digits each, since not every machine has a fused product \cite dekker1971.
Pair exact_product(Real a, Real b)
{
    constexpr Real splitter = 134217729;  // 2²⁷ + 1
    const Real of_a = splitter * a, of_b = splitter * b;
    const Real a1 = of_a - (of_a - a), a2 = a - a1, b1 = of_b - (of_b - b), b2 = b - b1;
    const Real product = a * b;
    return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

Pair operator-(const Pair& a) { return {-a.hi, -a.lo}; }

Pair operator+(const Pair& a, const Pair& b)
{
    const Pair sum = exact_sum(a.hi, b.hi);
    return exact_short_sum(sum.hi, sum.lo + (a.lo + b.lo));
}

Pair operator*(const Pair& a, const Pair& b)
{
    const Pair product = exact_product(a.hi, b.hi);
    return exact_short_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

Pair operator/(const Pair& a, const Pair& b)
{
    const Real quotient = a.hi / b.hi;
    const Pair product = exact_product(quotient, b.hi);
    const Real rest = ((a.hi - product.hi) - product.lo) + (a.lo - quotient * b.lo);
    return exact_short_sum(quotient, rest / b.hi);
}

/// Horner's rule; the coefficients begin with that of the highest power.
template <std::size_t N>
Real polynomial(const Real (&coefficients)[N], Real x)
{
    Real sum = coefficients[0];
    for (std::size_t i = 1; i < N; ++i) sum = sum * x + coefficients[i];
    return sum;
}

/// The whole number next to x, for |x| < 2³¹.
int nearest(Real x) { return static_cast<int>(x < 0 ? x - 0.5 : x + 0.5); }

constexpr Pair half_pi = {1.5707963267948966, 6.123233995736766e-17};
constexpr Pair whole_pi = {3.141592653589793, 1.2246467991473532e-16};

// ---- an angle without its quarter turns -------------------------------------------------------------

/// r + quarters π/2, with |r| ≤ π/4 but for the rounding; of the quarters the last two binary digits count.
struct Reduced {
    Pair r;
    int quarters;
};

/// After Cody and Waite \cite cody1980, for |angle| < 2²⁰ π/2: the first parts of π/2 have 33 digits, so their products
/// with up to 2²⁰ are exact.
Reduced reduced_by_parts(Real angle)
{
    constexpr Real part[] = {1.5707963267341256, 6.077100506303966e-11, 2.0222662487111665e-21,
                             8.4784276603689e-32};
    const int n = nearest(angle * (1 / half_pi.hi));
    const Pair second = exact_sum(angle - n * part[0], -n * part[1]);
    const Pair third = exact_sum(second.hi, -n * part[2]);
    return {exact_sum(third.hi, (second.lo + third.lo) - n * part[3]), n};
}

/// After Payne and Hanek \cite payne1983, for 2¹⁹ < |angle| < ∞: angle = m 2^e with a whole number m of 53 digits. Of the
/// digits of 2/π those that m 2^e makes multiples of 4 need not be known, and those 190 and more behind them are too
/// small to matter; what is between is multiplied by m in whole numbers.
Reduced reduced_by_digits(Real angle)
{
    /// 2/π by 32 binary digits each; the first two words are the zeros before them
    constexpr std::uint32_t digits[] = {
        0,          0,          0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041,
        0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e,
        0xe88235f5, 0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b,
        0x1ff897ff, 0xde05980f, 0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d,
        0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab};
    constexpr int words = 6;

    int e = 0;
    const std::uint64_t m = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(angle), &e), 53));
    e -= 53;
    const int first = 64 + e - 2;  // the first digit that counts has weight 2
    std::uint32_t window[words];   // the lowest word first
    for (int i = 0; i < words; ++i) {
        const int at = first / 32 + i, shift = first % 32;
        const std::uint64_t two = (static_cast<std::uint64_t>(digits[at]) << 32) | digits[at + 1];
        window[words - 1 - i] = static_cast<std::uint32_t>(two >> (32 - shift));
    }
    std::uint32_t product[words] = {};
    for (int j = 0; j < 2; ++j) {
        const std::uint64_t factor = (m >> (32 * j)) & 0xffffffffu;
        std::uint64_t carry = 0;
        for (int i = 0; i + j < words; ++i) {
            carry += factor * window[i] + product[i + j];
            product[i + j] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
    }
    // To the nearest quarter turn: what is left is between -1/2 and 1/2.
    int quarters = static_cast<int>(product[words - 1] >> 30);
    const bool above = (product[words - 1] >> 29) & 1u;
    quarters += above;
    product[words - 1] = (product[words - 1] & 0x3fffffffu) | (above ? 0xc0000000u : 0u);
    std::uint64_t carry = 1;
    if (above)  // the two's complement
        for (std::uint32_t& word : product) {
            carry += static_cast<std::uint32_t>(~word);
            word = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
    Pair left{0, 0};
    for (int i = words - 1; i >= 0; --i)
        left = left + Pair{std::ldexp(static_cast<Real>(product[i]), 32 * (i - words) + 2), 0};
    left = (above ? -left : left) * half_pi;
    return angle < 0 ? Reduced{-left, -quarters} : Reduced{left, quarters};
}

Reduced reduced(Real angle)
{
    const Real size = std::abs(angle);
    if (size <= half_pi.hi / 2) return {{angle, 0}, 0};
    if (size < 1e6) return reduced_by_parts(angle);
    if (size < infinity) return reduced_by_digits(angle);
    return {{angle - angle, 0}, 0};  // NaN
}

// ---- sine and cosine of what is left ----------------------------------------------------------------

/// sin r = r + r³ S(r²) for |r| ≤ π/4.
Pair sine_of(const Pair& r)
{
    constexpr Real S[] = {1.591810123027412e-10,  -2.5051131455427946e-08, 2.755731610068303e-06,
                          -0.0001984126983675497, 0.008333333333330946,    -0.16666666666666666};
    const Real z = r.hi * r.hi;
    return exact_short_sum(r.hi, r.hi * z * polynomial(S, z) + r.lo * (1 - z / 2));
}

/// cos r = 1 − r²/2 + r⁴ C(r²) for |r| ≤ π/4.
Pair cosine_of(const Pair& r)
{
    constexpr Real C[] = {-1.1382614868556325e-11, 2.0876146024689747e-09, -2.7557317270560326e-07,
                          2.4801587298763433e-05,  -0.0013888888888887395, 0.041666666666666664};
    const Real z = r.hi * r.hi;
    const Pair begin = exact_short_sum(1, -z / 2);
    return exact_short_sum(begin.hi, begin.lo + (z * z * polynomial(C, z) - r.hi * r.lo));
}

/// sin(r + quarters π/2).
Pair sine_of(const Pair& r, int quarters)
{
    const Pair size = quarters & 1 ? cosine_of(r) : sine_of(r);
    return quarters & 2 ? -size : size;
}

/// The angle from 0 to π/4 of the point (x, y), 0 ≤ y ≤ x: a rough angle, and the small one that is left.
Pair angle_of(Real y, Real x)
{
    constexpr Real rough[] = {-0.013130382075265306, 0.05658998519982956,  -0.12044858521319932,
                              0.19534659002798738,   -0.33295711032247716, 0.9999948346338879};
    const Real q = y / x;
    if (q < 1e-9) return {q, 0};  // the next term is q³/3
    const Real guess = q * polynomial(rough, q * q);
    const Pair s = sine_of({guess, 0}), c = cosine_of({guess, 0});
    int e = 0;
    std::frexp(x, &e);
    x = std::ldexp(x, -e);
    y = std::ldexp(y, -e);
    const Pair sine = exact_short_sum(s.hi, s.lo), yc = exact_product(y, c.hi),
               xs = exact_product(x, sine.hi);
    const Real across = ((yc.hi - xs.hi) + (yc.lo - xs.lo)) + (y * c.lo - x * s.lo);
    const Real left = across / (x * c.hi + y * s.hi);  // its tangent
    return exact_short_sum(guess, left - left * left * left / 3);
}

// ---- powers and logarithms --------------------------------------------------------------------------

constexpr Real ln2[] = {0.6931471805598903, 5.497923018708371e-14};  // the first part has 42 digits

/// 2^k (1 + p).
struct Power {
    int k;
    Pair p;
};

/// e^x for |x| < 1500, with r = x − k ln 2 and e^r − 1 = r + r²/2 + r³ E(r).
Power power_of_e(const Pair& x)
{
    constexpr Real E[] = {2.0911236630261545e-09, 2.510038549551032e-08,  2.755728296954995e-07,
                          2.7557268459997064e-06, 2.4801587317144498e-05, 0.00019841269863053618,
                          0.0013888888888886552,  0.008333333333330062,   0.041666666666666664,
                          0.16666666666666669};
    const int k = nearest(x.hi * (1 / ln2[0]));
    const Pair r = exact_sum(x.hi - k * ln2[0], x.lo - k * ln2[1]);
    const Real z = r.hi * r.hi;
    return {k, exact_short_sum(r.hi, z / 2 + (r.hi * z * polynomial(E, r.hi) + r.lo * (1 + r.hi)))};
}

Real value_of(const Power& power)
{
    const Pair sum = exact_short_sum(1, power.p.hi);
    return std::ldexp(sum.hi + (sum.lo + power.p.lo), power.k);
}

/// log x for 0 < x < ∞: x = 2^k m with m about 1, s = (m − 1)/(m + 1), log m = 2s + 2s³/3 + s⁵ L(s²).
Pair logarithm_of(Real x)
{
    constexpr Real L[] = {0.11723306234080849, 0.11706224135460942, 0.13334805149611875, 0.15384594954137945,
                          0.1818181833547124,  0.2222222222165554,  0.2857142857142937,  0.4};
    constexpr Pair two_thirds = {0.6666666666666666, 3.700743415417188e-17};
    int k = 0;
    Real m = std::frexp(x, &k);
    if (m < 0.70710678118654752) {
        m *= 2;
        --k;
    }
    const Pair s = Pair{m - 1, 0} / exact_sum(m, 1), z = s * s;
    const Pair cubic = two_thirds * s * z;
    const Pair rest{cubic.hi, cubic.lo + s.hi * z.hi * z.hi * polynomial(L, z.hi)};
    return exact_sum(k * ln2[0], k * ln2[1]) + (Pair{2 * s.hi, 2 * s.lo} + rest);
}

/// What a logarithm is where x is no positive finite number.
Real logarithm_at_the_edge(Real x)
{
    if (x == 0) return -infinity;
    return x == infinity ? infinity : x - x + (x < 0 ? std::numeric_limits<Real>::quiet_NaN() : 0);
}

bool has_logarithm(Real x) { return x > 0 && x < infinity; }

}  // namespace

// ---- the functions ----------------------------------------------------------------------------------

Real sin(Real angle)
{
    if (std::abs(angle) < 1e-9) return angle;
    const Reduced x = reduced(angle);
    return sine_of(x.r, x.quarters).hi;
}

Real cos(Real angle)
{
    const Reduced x = reduced(angle);
    return sine_of(x.r, x.quarters + 1).hi;
}

SineAndCosine sine_and_cosine(Real angle)
{
    const Reduced x = reduced(angle);
    return {std::abs(angle) < 1e-9 ? angle : sine_of(x.r, x.quarters).hi, sine_of(x.r, x.quarters + 1).hi};
}

Real tan(Real angle)
{
    if (std::abs(angle) < 1e-9) return angle;
    const Reduced x = reduced(angle);
    // by half the angle, whose sine and cosine are more exact: tan r = 2 s c / ((c - s) (c + s))
    const Pair half{x.r.hi / 2, x.r.lo / 2}, s = sine_of(half), c = cosine_of(half);
    const Pair up = Pair{2 * s.hi, 2 * s.lo} * c, along = (c + -s) * (c + s);
    return (x.quarters & 1 ? -along / up : up / along).hi;
}

Real asin(Real x)
{
    if (std::abs(x) < 1e-9) return x;
    const Real rough = atan2(x, std::sqrt((1 - x) * (1 + x)));
    if (!(std::abs(x) < 1)) return rough;
    const Reduced angle = reduced(rough);
    const Pair s = sine_of(angle.r, angle.quarters), c = sine_of(angle.r, angle.quarters + 1);
    return rough + ((x - s.hi) - s.lo) / c.hi;
}

Real atan(Real x) { return atan2(x, 1); }

Real atan2(Real y, Real x)
{
    if (x != x || y != y) return x + y;
    Real up = std::abs(y), along = std::abs(x);
    if (up == infinity || along == infinity) {
        up = up == infinity;
        along = along == infinity;
    }
    const bool steep = up > along, back = std::signbit(x);
    const Pair from_axis = up == 0 ? Pair{0, 0} : steep ? angle_of(along, up) : angle_of(up, along);
    const Pair angle = steep  ? half_pi + (back ? from_axis : -from_axis)
                       : back ? whole_pi + -from_axis
                              : from_axis;
    return std::copysign(angle.hi, y);
}

Real exp(Real x)
{
    if (x != x) return x;
    if (x > 710) return infinity;
    if (x < -746) return 0;
    return value_of(power_of_e({x, 0}));
}

Real expm1(Real x)
{
    if (x > 50) return exp(x);
    if (x < -50) return -1;
    if (!(std::abs(x) > 1e-18)) return x;
    const Power power = power_of_e({x, 0});
    if (power.k == 0) return power.p.hi + power.p.lo;
    const Pair grown{std::ldexp(power.p.hi, power.k), std::ldexp(power.p.lo, power.k)};
    const Pair sum = exact_sum(std::ldexp(1, power.k), -1) + grown;
    return sum.hi + sum.lo;
}

Real log(Real x) { return has_logarithm(x) ? logarithm_of(x).hi : logarithm_at_the_edge(x); }

Real log1p(Real x)
{
    const Pair sum = exact_sum(1, x);
    if (!has_logarithm(sum.hi)) return logarithm_at_the_edge(1 + x);
    if (!(std::abs(x) > 1e-18)) return x;
    return (logarithm_of(sum.hi) + Pair{sum.lo / sum.hi, 0}).hi;
}

Real log2(Real x)
{
    constexpr Pair per_ln2 = {1.4426950408889634, 2.0355273740931033e-17};
    return has_logarithm(x) ? (logarithm_of(x) * per_ln2).hi : logarithm_at_the_edge(x);
}

Real log10(Real x)
{
    constexpr Pair per_ln10 = {0.4342944819032518, 1.098319650216765e-17};
    return has_logarithm(x) ? (logarithm_of(x) * per_ln10).hi : logarithm_at_the_edge(x);
}

Real pow(Real base, Real exponent)
{
    if (exponent == 0 || base == 1) return 1;
    if (base != base || exponent != exponent) return base + exponent;
    const Real size = std::abs(base);
    const bool whole = std::floor(exponent) == exponent;
    const bool odd = whole && std::fmod(exponent, 2) != 0;
    const Real sign = std::signbit(base) && odd ? -1 : 1;
    if (std::abs(exponent) == infinity) return size == 1 ? 1 : (size > 1) == (exponent > 0) ? infinity : 0;
    if (!has_logarithm(size)) return sign * ((size > 0) == (exponent > 0) ? infinity : 0);
    if (base < 0 && !whole) return std::numeric_limits<Real>::quiet_NaN();
    const Pair log_of_base = logarithm_of(size);
    const Real rough = exponent * log_of_base.hi;
    if (std::abs(rough) > 800) return sign * (rough > 0 ? infinity : 0);
    const Pair product = exact_product(exponent, log_of_base.hi);
    return sign * value_of(power_of_e({product.hi, product.lo + exponent * log_of_base.lo}));
}

Real hypot(Real x, Real y)
{
    x = std::abs(x);
    y = std::abs(y);
    if (x == infinity || y == infinity) return infinity;
    if (x != x || y != y || x == 0 || y == 0) return x + y;
    int e = 0;
    std::frexp(x > y ? x : y, &e);
    x = std::ldexp(x, -e);
    y = std::ldexp(y, -e);
    const Pair squares = exact_product(x, x) + exact_product(y, y);
    const Real root = std::sqrt(squares.hi);
    const Pair back = exact_product(root, root);
    return std::ldexp(root + (((squares.hi - back.hi) - back.lo) + squares.lo) / (2 * root), e);
}

}  // namespace rigid
