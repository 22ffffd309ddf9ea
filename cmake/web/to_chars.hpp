// Before every source of the preset web: the standard library of Emscripten 3.1.6 has no std::to_chars for floating point.
// A number is written out exactly first, as every number of a computer can be, and then rounded to the nearest text: no
// estimate is made that would have to be tried. (By snprintf and strtod each page is 5 kB heavier.)
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <version>

namespace rigid::web {

/// A number that is not negative as its decimal digits, all of them: 315 before the point and 1080 behind it.
struct Digits {
    static constexpr int point = 315, count = 1395;
    std::string digits;  ///< '0' to '9', the first is worth 10^314

    /// m·2^exponent
    Digits(std::uint64_t m, int exponent) : digits(count, '0')
    {
        constexpr std::uint64_t billion = 1'000'000'000;
        constexpr int groups = count / 9, last = point / 9 - 1;
        std::uint64_t group[groups] = {};
        for (int g = last; m != 0; m /= billion) group[g--] = m % billion;
        for (int some; exponent > 0; exponent -= some) {
            some = std::min(exponent, 29);
            std::uint64_t carry = 0;
            for (int g = last; g >= 0; --g) {
                carry += group[g] << some;
                group[g] = carry % billion;
                carry /= billion;
            }
        }
        for (int some; exponent < 0; exponent += some) {
            some = std::min(-exponent, 29);
            std::uint64_t rest = 0;
            for (std::uint64_t& it : group) {
                rest = rest * billion + it;
                it = rest >> some;
                rest &= (std::uint64_t{1} << some) - 1;
            }
        }
        for (int g = 0; g < groups; ++g)
            for (int i = 8; i >= 0; --i, group[g] /= 10)
                digits[static_cast<std::size_t>(9 * g + i)] = static_cast<char>('0' + group[g] % 10);
    }

    /// Where the digits begin; that of 0 before the point.
    int first() const
    {
        const auto at = digits.find_first_not_of('0');
        return at == std::string::npos ? point - 1 : static_cast<int>(at);
    }

    /// To the nearest number that has no digit at this place and after it; of two the one whose last digit is even.
    void round(int place)
    {
        if (place >= count) return;
        const auto at = static_cast<std::size_t>(std::max(place, 1));
        const bool odd = (digits[at - 1] - '0') % 2 == 1;
        const int against_half =
            digits.compare(at, std::string::npos, '5' + std::string(count - at - 1, '0'));
        std::fill(digits.begin() + static_cast<std::ptrdiff_t>(at), digits.end(), '0');
        if (against_half > 0 || (against_half == 0 && odd)) go_up(place);
    }

    /// To the next number that has no digit at this place and after it; it has none now.
    void go_up(int place)
    {
        auto at = static_cast<std::size_t>(std::max(place, 1)) - 1;
        for (; digits[at] == '9'; --at) digits[at] = '0';
        ++digits[at];
    }
};

enum class Form { fixed, general, shortest };

/// What std::to_chars writes of a finite number, with so many digits behind the point (fixed) or in all (general).
inline std::string text_of(double value, Form form, int wanted = 0)
{
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    const std::string sign = bits >> 63 != 0 ? "-" : "";
    const int power = static_cast<int>(bits >> 52 & 2047);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    if (power == 2047) return sign + (fraction == 0 ? "inf" : "nan");
    const std::uint64_t m = power == 0 ? fraction : fraction | std::uint64_t{1} << 52;
    const int exponent = std::max(power, 1) - 1075;

    const Digits exact(m, exponent);
    Digits it = exact;
    int behind = wanted;
    if (form == Form::fixed) it.round(Digits::point + wanted);
    if (form == Form::general) it.round(exact.first() + std::max(wanted, 1));
    if (form == Form::shortest && m != 0) {
        // what is between the middles to its two neighbours, or at one of them and even, reads back as this number
        const bool narrow = fraction == 0 && power > 1;
        const Digits below(4 * m - (narrow ? 1 : 2), exponent - 2), above(2 * m + 1, exponent - 1);
        const auto reads_back = [&] {
            return m % 2 == 0 ? below.digits <= it.digits && it.digits <= above.digits
                              : below.digits < it.digits && it.digits < above.digits;
        };
        for (int place = exact.first() + 1;; ++place) {
            it = exact;
            it.round(place);
            if (reads_back()) break;
            if (!narrow || exact.digits < it.digits) continue;
            it.go_up(place);  // the room above is twice that below
            if (reads_back()) break;
        }
    }

    const int first = it.first(), worth = Digits::point - 1 - first;
    const int last = std::max(static_cast<int>(it.digits.find_last_not_of('0') + 1), first + 1);
    const auto part = [&](int from, int to) {
        return it.digits.substr(static_cast<std::size_t>(from),
                                static_cast<std::size_t>(std::max(to - from, 0)));
    };
    const std::string power_of_ten = std::to_string(std::abs(worth));
    std::string scientific = part(first, first + 1);
    if (last > first + 1) scientific += '.' + part(first + 1, last);
    scientific += (worth < 0 ? "e-" : "e+") + std::string(power_of_ten.size() < 2 ? "0" : "") + power_of_ten;
    if (form == Form::general && (worth < -4 || worth >= std::max(wanted, 1))) return sign + scientific;

    if (form != Form::fixed) behind = std::max(last - Digits::point, 0);
    if (form == Form::shortest && behind == 0) it = exact;  // a whole number is written as it is
    std::string fixed = part(std::min(first, Digits::point - 1), Digits::point);
    if (behind > 0) fixed += '.' + part(Digits::point, Digits::point + behind);
    return sign + (form == Form::shortest && scientific.size() < fixed.size() ? scientific : fixed);
}

inline std::to_chars_result put(char* first, char* last, const std::string& text)
{
    if (static_cast<std::ptrdiff_t>(text.size()) > last - first) return {last, std::errc::value_too_large};
    return {std::copy(text.begin(), text.end(), first), std::errc()};
}

}  // namespace rigid::web

#if defined(__EMSCRIPTEN__) && !defined(__cpp_lib_to_chars)
namespace std {

inline to_chars_result to_chars(char* first, char* last, double value)
{
    return rigid::web::put(first, last, rigid::web::text_of(value, rigid::web::Form::shortest));
}

inline to_chars_result to_chars(char* first, char* last, double value, chars_format format, int digits)
{
    const auto form = format == chars_format::fixed ? rigid::web::Form::fixed : rigid::web::Form::general;
    return rigid::web::put(first, last, rigid::web::text_of(value, form, digits));
}

}  // namespace std
#endif
