/// \file picture_check.cpp
/// picture_check FILE.png …: exit code 0 if every picture shows something, 1 if one is blank.
/// A picture is blank when at least 99.9 % of its pixels have one colour.

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#if __has_include(<stb/stb_image.h>)
#include <stb/stb_image.h>
#else
#include <stb_image.h>
#endif

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>

int main(int argc, char** argv)
{
    if (argc < 2) {
        std::fprintf(stderr, "usage: picture_check FILE.png …\n");
        return 2;
    }
    int blank = 0;
    for (int i = 1; i < argc; ++i) {
        int width = 0, height = 0, channels = 0;
        unsigned char* pixels = stbi_load(argv[i], &width, &height, &channels, 3);
        if (!pixels) {
            std::fprintf(stderr, "%s cannot be read: %s\n", argv[i], stbi_failure_reason());
            return 2;
        }
        std::map<std::uint32_t, long> count;
        const long size = static_cast<long>(width) * height;
        for (long p = 0; p < size; ++p)
            ++count[static_cast<std::uint32_t>(pixels[3 * p] << 16 | pixels[3 * p + 1] << 8 |
                                               pixels[3 * p + 2])];
        stbi_image_free(pixels);
        const auto most = std::max_element(count.begin(), count.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        const double share = static_cast<double>(most->second) / static_cast<double>(size);
        std::printf("%s: %d x %d, %zu colours, %.2f %% ground\n", argv[i], width, height, count.size(),
                    100 * share);
        if (share > 0.999) blank = 1;
    }
    return blank;
}
