/// \file says.hpp
/// What the texts print, held to what is computed: a number in a sentence is looked up there by the test that finds it.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/// True if the file, relative to the root of the book, has this text. Line breaks count as blanks.
inline bool says(const std::string& path, const std::string& text)
{
    std::ifstream file(std::filesystem::path(RIGID_SOURCE_DIR) / path);
    std::string all((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    for (char& c : all)
        if (c == '\n') c = ' ';
    return all.find(text) != std::string::npos;
}

/// A number as a text prints it, with so many digits behind the point.
inline std::string printed(double value, int digits)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}
