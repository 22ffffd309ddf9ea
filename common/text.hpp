/// \file text.hpp
/// Numbers as text and back, the same under every locale.
#pragma once

#include "common/math.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace rigid {

/// The shortest text that reads back as exactly this number: 0.1, 1e-05, 0.30000000000000004. The one way to
/// print a number in a message: std::to_string makes "-0.000000" of -1e-9.
inline std::string shortest(Real value)
{
    if (std::isnan(value)) return "nan";  // its sign means nothing and differs between compilers
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value + 0.0).ptr;  // + 0.0: never "-0"
    return {text, end};
}

/// With so many digits behind the point; what is too large for that becomes shortest().
inline std::string fixed(Real value, int digits)
{
    if (!std::isfinite(value)) return shortest(value);
    char text[64];
    const auto [end, error] =
        std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits);
    if (error != std::errc()) return shortest(value);
    std::string result(text, end);
    if (result.front() == '-' && result.find_first_of("123456789") == std::string::npos) result.erase(0, 1);
    return result;
}

/// With so many significant digits, for a reader: 9.81, 1.2e-05.
inline std::string significant(Real value, int digits)
{
    if (!std::isfinite(value)) return shortest(value);
    char text[64];
    const auto end =
        std::to_chars(text, text + sizeof text, value + 0.0, std::chars_format::general, digits).ptr;
    return {text, end};
}

/// For sentences and sliders: up to ten significant digits, 0.0001 rather than 1e-04.
inline std::string readable(Real value) { return significant(value, 10); }

/// The finite number that the whole text is, or nothing.
inline std::optional<Real> parse_real(const std::string& text)
{
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    Real value = 0;
    if (text.empty() || std::isspace(static_cast<unsigned char>(text.front())) || !(stream >> value) ||
        stream.peek() != std::char_traits<char>::eof() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

/// The whole number from 0 to 2^64-1 that the whole text is, or nothing.
inline std::optional<std::uint64_t> parse_whole(const std::string& text)
{
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// "a, b, c"
inline std::string joined(const std::vector<std::string>& words)
{
    std::string result;
    for (const std::string& word : words) result += (result.empty() ? "" : ", ") + word;
    return result;
}

/// "9.81 m/s": a number and, where there is one, its unit.
inline std::string with_unit(const std::string& number, const std::string& unit)
{
    return unit.empty() ? number : number + " " + unit;
}

}  // namespace rigid
