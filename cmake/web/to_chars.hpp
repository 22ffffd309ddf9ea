// Before every source of the preset web: the standard library of Emscripten 3.1.6 has no std::to_chars for floating
// point. The shortest text of a number is found by trying: 1 to 17 digits.
#pragma once

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <version>

#if defined(__EMSCRIPTEN__) && !defined(__cpp_lib_to_chars)
namespace std {

inline to_chars_result rigid_put(char* first, char* last, const char* text)
{
    const size_t size = strlen(text);
    if (size > static_cast<size_t>(last - first)) return {last, errc::value_too_large};
    memcpy(first, text, size);
    return {first + size, errc()};
}

inline to_chars_result to_chars(char* first, char* last, double value)
{
    char text[40];
    for (int digits = 1; digits <= 17; ++digits) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, nullptr) == value) break;
    }
    return rigid_put(first, last, text);
}

inline to_chars_result to_chars(char* first, char* last, double value, chars_format format, int digits)
{
    char text[400];
    snprintf(text, sizeof text, format == chars_format::fixed ? "%.*f" : "%.*g", digits, value);
    return rigid_put(first, last, text);
}

}  // namespace std
#endif
