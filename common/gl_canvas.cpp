#include "common/gl_canvas.hpp"
#include "common/elementary.hpp"

#include <GL/glew.h>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#if __has_include(<stb/stb_image_write.h>)
#include <stb/stb_image_write.h>
#else
#include <stb_image_write.h>
#endif
#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace rigid {
namespace {

ImU32 rgb(unsigned hex, Real opacity = 1)
{
    return IM_COL32((hex >> 16) & 255u, (hex >> 8) & 255u, hex & 255u,
                    static_cast<unsigned>(std::lround(255 * std::clamp<Real>(opacity, 0, 1))));
}

ImVec2 im(const Vec2& p) { return {static_cast<float>(p.x()), static_cast<float>(p.y())}; }

std::vector<ImVec2> im(const std::vector<Vec2>& points)
{
    std::vector<ImVec2> result;
    result.reserve(points.size());
    for (const Vec2& p : points) result.push_back(im(p));
    return result;
}

/// A line as its dashes.
std::vector<std::vector<Vec2>> dashes(const std::vector<Vec2>& points, bool closed, Real on, Real off)
{
    std::vector<std::vector<Vec2>> result;
    bool drawing = true;
    Real left = on;
    std::vector<Vec2> dash = {points.front()};
    const std::size_t count = points.size() + (closed ? 1 : 0);
    for (std::size_t i = 1; i < count && result.size() < 10000; ++i) {
        Vec2 at = points[i - 1];
        const Vec2 to = points[i % points.size()];
        Real length = (to - at).norm();
        while (length > left) {
            at += (to - at) * (left / length);
            length -= left;
            dash.push_back(at);
            if (drawing) result.push_back(dash);
            dash = {at};
            drawing = !drawing;
            left = drawing ? on : off;
        }
        left -= length;
        dash.push_back(to);
    }
    if (drawing && dash.size() > 1) result.push_back(dash);
    return result;
}

class ListPainter {
public:
    ListPainter(ImDrawList& list, const Projection& projection, const Theme& theme, const Fonts& fonts,
                Real scale)
        : list_(list), projection_(projection), theme_(theme), fonts_(fonts), scale_(scale)
    {
    }

    void paint(const DrawItem& item)
    {
        const Style& style = item.style;
        const std::vector<Vec2> points = pixels_of(item, projection_);
        const ImU32 colour = theme_.colour(style.colour, style.opacity);
        switch (item.kind) {
        case DrawItem::Kind::disc: {
            const Real radius = projection_.scale * item.radius;
            if (style.filled()) list_.AddCircleFilled(im(points[0]), static_cast<float>(radius), colour);
            if (!(style.width > 0)) return;
            if (style.dashed()) outline(circle(points[0], radius), style);
            else list_.AddCircle(im(points[0]), static_cast<float>(radius), edge(style), 0, width(style));
            return;
        }
        case DrawItem::Kind::polygon:
            if (style.filled()) fill(points, colour);
            if (style.width > 0) outline(points, style);
            return;
        case DrawItem::Kind::line:
            if (style.width > 0)
                for (const auto& piece : near_pieces(points)) stroke(piece, false, style, colour);
            return;
        case DrawItem::Kind::arrow: {
            if ((points[1] - points[0]).norm() < 0.5) return;  // no direction to be seen
            const ArrowShape shape = arrow_shape(points[0], points[1], scale_ * style.width);
            if (style.width > 0) stroke({points[0], shape.shaft_end}, false, style, colour);
            list_.AddTriangleFilled(im(shape.left), im(shape.tip), im(shape.right), colour);
            return;
        }
        case DrawItem::Kind::text:
            fonts_.paint(list_, points[0], item.text, scale_ * item.size, colour, item.align);
            return;
        }
    }

private:
    float width(const Style& style) const { return static_cast<float>(scale_ * style.width); }

    ImU32 edge(const Style& style) const
    {
        return theme_.colour(style.colour, style.filled() ? std::sqrt(std::clamp<Real>(style.opacity, 0, 1))
                                                          : style.opacity);
    }

    void outline(const std::vector<Vec2>& points, const Style& style)
    {
        stroke(points, true, style, edge(style));
    }

    void stroke(const std::vector<Vec2>& points, bool closed, const Style& style, ImU32 colour)
    {
        if (style.dashed()) {
            for (const auto& dash : dashes(points, closed, scale_ * dash_length, scale_ * dash_gap)) {
                const std::vector<ImVec2> line = im(dash);
                list_.AddPolyline(line.data(), static_cast<int>(line.size()), colour, 0, width(style));
            }
            return;
        }
        const std::vector<ImVec2> line = im(points);
        list_.AddPolyline(line.data(), static_cast<int>(line.size()), colour, closed ? ImDrawFlags_Closed : 0,
                          width(style));
    }

    static std::vector<Vec2> circle(const Vec2& centre, Real radius)
    {
        const int count = std::clamp(static_cast<int>(radius), 24, 400);
        std::vector<Vec2> points;
        for (int i = 0; i < count; ++i) {
            const Real angle = 2 * pi * i / count;
            points.push_back(centre + radius * Vec2(cos(angle), sin(angle)));
        }
        return points;
    }

    /// Any simple polygon: cuts off one ear after the other.
    void fill(std::vector<Vec2> points, ImU32 colour)
    {
        Real area = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            area += cross2(points[i], points[(i + 1) % points.size()]);
        if (area < 0) std::reverse(points.begin(), points.end());
        const auto is_ear = [&](std::size_t i) {
            const std::size_t n = points.size();
            const Vec2 &a = points[(i + n - 1) % n], &b = points[i], &c = points[(i + 1) % n];
            if (cross2(b - a, c - b) <= 0) return false;
            for (std::size_t k = 0; k < n; ++k) {
                const Vec2& p = points[k];
                if (p == a || p == b || p == c) continue;
                if (cross2(b - a, p - a) >= 0 && cross2(c - b, p - b) >= 0 && cross2(a - c, p - c) >= 0)
                    return false;
            }
            return true;
        };
        // The edge is smoothed by the outline; smoothing each triangle would show seams.
        const ImDrawListFlags flags = list_.Flags;
        list_.Flags &= ~ImDrawListFlags_AntiAliasedFill;
        while (points.size() >= 3) {
            const std::size_t n = points.size();
            std::size_t ear = 0;
            while (ear < n && !is_ear(ear)) ++ear;
            if (ear == n) ear = 0;  // flat or crossing itself: cut anywhere
            list_.AddTriangleFilled(im(points[(ear + n - 1) % n]), im(points[ear]), im(points[(ear + 1) % n]),
                                    colour);
            points.erase(points.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        list_.Flags = flags;
    }

    ImDrawList& list_;
    const Projection& projection_;
    const Theme& theme_;
    const Fonts& fonts_;
    Real scale_;
};

/// A size means the same as in a browser: there it is that of the em, in Dear ImGui that of a line,
/// which is so much more (for DejaVu Sans).
constexpr Real line_per_em = 1.164;

/// Typefaces that systems have, the best for formulas first.
std::string system_typeface()
{
    for (const char* file :
         {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
          "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf",
          "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
          "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
          "/usr/share/fonts/truetype/freefont/FreeSans.ttf",
          "/System/Library/Fonts/Supplemental/Arial Unicode.ttf",
          "/System/Library/Fonts/Supplemental/Arial.ttf", "C:\\Windows\\Fonts\\segoeui.ttf"}) {
        std::error_code ignored;
        if (std::filesystem::exists(file, ignored)) return file;
    }
    return {};
}

/// Letters that formulas need, and their names for a typeface that has none of them.
constexpr std::pair<const char*, const char*> spelled_out[] = {
    {"α", "alpha"}, {"β", "beta"},  {"γ", "gamma"},  {"δ", "delta"}, {"Δ", "Delta"}, {"ε", "eps"},
    {"θ", "theta"}, {"κ", "kappa"}, {"λ", "lambda"}, {"μ", "mu"},    {"ν", "nu"},    {"π", "pi"},
    {"ρ", "rho"},   {"σ", "sigma"}, {"τ", "tau"},    {"φ", "phi"},   {"ω", "omega"}, {"Ω", "Omega"},
    {"≤", "<="},    {"≥", ">="},    {"→", "->"},     {"←", "<-"},    {"−", "-"},     {"–", "-"},
    {"∞", "inf"},   {"⟂", "⊥"},     {"⊥", "_|_"},    {"√", "sqrt "}, {"≈", "~"},     {"Σ", "sum "},
    {"∑", "sum "},  {"…", "..."},   {"⁻", "^-"},     {"ᵀ", "^T"},    {"₀", "0"},     {"₁", "1"},
    {"₂", "2"},     {"₃", "3"},     {"₄", "4"},      {"ₙ", "_n"},    {"ₖ", "_k"},    {"ⁿ", "^n"},
    {"’", "'"},     {"“", "\""},    {"”", "\""}};

}  // namespace

ImU32 Theme::colour(Colour which, Real opacity) const
{
    Style style;
    style.colour = which;
    style.opacity = opacity;
    const Real seen = seen_opacity(style);
    switch (which) {
    case Colour::ink:
    case Colour::faint:
        return rgb(dark ? 0xC9D1D9 : 0x3B424B, seen);
    case Colour::blue:
        return rgb(dark ? 0x6CA6E0 : 0x4477AA, seen);
    case Colour::orange:
        return rgb(dark ? 0xF4924E : 0xEE7733, seen);
    case Colour::green:
        return rgb(dark ? 0x4FBE6A : 0x228833, seen);
    case Colour::red:
        return rgb(dark ? 0xF0604A : 0xCC3311, seen);
    case Colour::purple:
        return rgb(dark ? 0xD27BB4 : 0xAA3377, seen);
    case Colour::yellow:
        return rgb(dark ? 0xDCCB5C : 0xCCBB44, seen);
    }
    return rgb(0x808080, seen);
}

ImU32 Theme::ground() const { return rgb(dark ? 0x14171B : 0xE9ECEF); }
ImU32 Theme::card() const { return rgb(dark ? 0x1B1F25 : 0xFFFFFF); }
ImU32 Theme::edge() const { return rgb(dark ? 0x323942 : 0xCDD3D9); }

Fonts::Fonts(Real scale, Real density) : density_(density)
{
    static const ImWchar ranges[] = {0x0020, 0x00FF, 0x010A, 0x010B, 0x0391, 0x03C9, 0x1D40, 0x1D40, 0x1E8A,
                                     0x1E8F, 0x2010, 0x2033, 0x2070, 0x209C, 0x2190, 0x2195, 0x21D0, 0x21D4,
                                     0x2200, 0x222B, 0x2248, 0x2248, 0x2260, 0x226B, 0x22A5, 0x22A5, 0x22C5,
                                     0x22C5, 0x25A0, 0x25CF, 0x27C2, 0x27C2, 0};
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const std::string file = system_typeface();
    if (!file.empty())
        for (const Real size : {15.0, 12.0, 13.0, 14.0, 16.3, 18.6, 21.0, 28.0, 10.5, 9.5}) {
            ImFontConfig config;
            config.OversampleH = 2;
            config.OversampleV = 1;
            ImFont* font = atlas.AddFontFromFileTTF(file.c_str(), static_cast<float>(size * scale * density),
                                                    &config, ranges);
            if (font) fonts_.push_back(font);
        }
    if (fonts_.empty()) fonts_.push_back(atlas.AddFontDefault());
    atlas.Build();
    for (const auto& [letter, name] : spelled_out)
        if (!knows(letter)) missing_.emplace_back(letter, name);
}

bool Fonts::knows(const std::string& letter) const
{
    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned>(static_cast<unsigned char>(letter[i]));
    };
    const unsigned code = letter.size() == 2
                              ? (byte(0) & 0x1Fu) << 6 | (byte(1) & 0x3Fu)
                              : (byte(0) & 0x0Fu) << 12 | (byte(1) & 0x3Fu) << 6 | (byte(2) & 0x3Fu);
    return fonts_.front()->FindGlyphNoFallback(static_cast<ImWchar>(code)) != nullptr;
}

ImFont* Fonts::nearest(Real size) const
{
    // The smallest that is large enough: scaling down keeps letters crisp.
    ImFont* best = nullptr;
    for (ImFont* font : fonts_)
        if (font->FontSize >= size * density_ - 0.25 && (!best || font->FontSize < best->FontSize))
            best = font;
    if (best) return best;
    return *std::max_element(fonts_.begin(), fonts_.end(),
                             [](const ImFont* a, const ImFont* b) { return a->FontSize < b->FontSize; });
}

std::string Fonts::shown(const std::string& text) const
{
    std::string result = text;
    for (const auto& [letter, name] : missing_)
        for (std::size_t at = 0; (at = result.find(letter, at)) != std::string::npos; at += name.size())
            result.replace(at, letter.size(), name);
    return result;
}

Real Fonts::paint(ImDrawList& list, const Vec2& baseline, const std::string& text, Real size, ImU32 colour,
                  Align align) const
{
    const std::string words = shown(text);
    const ImFont* font = nearest(line_per_em * size);
    const float height = static_cast<float>(line_per_em * size);
    const ImVec2 extent = font->CalcTextSizeA(height, FLT_MAX, 0, words.data(), words.data() + words.size());
    float x = static_cast<float>(baseline.x());
    if (align == Align::centre) x -= extent.x / 2;
    if (align == Align::right) x -= extent.x;
    const float ascent = font->Ascent * height / font->FontSize;
    // Whole pixels: letters stay crisp.
    list.AddText(font, height, {std::round(x), std::round(static_cast<float>(baseline.y()) - ascent)}, colour,
                 words.data(), words.data() + words.size());
    return static_cast<Real>(extent.x);
}

void paint(ImDrawList& list, const Canvas& canvas, const Projection& projection, const Theme& theme,
           const Fonts& fonts, Real line_scale, bool words)
{
    const Rectangle& area = projection.area;
    list.PushClipRect(im(Vec2(area.x, area.y)), im(Vec2(area.x + area.width, area.y + area.height)), true);
    ListPainter painter(list, projection, theme, fonts, line_scale);
    for (const DrawItem& item : canvas.items())
        if ((words || item.kind != DrawItem::Kind::text) && is_paintable(item, projection))
            painter.paint(item);
    list.PopClipRect();
}

void paint_picture(ImDrawList& list, const std::vector<Pane>& panes, const PictureLayout& layout,
                   const Theme& theme, const Fonts& fonts)
{
    for (std::size_t i = 0; i < panes.size(); ++i) {
        const Rectangle &label = layout.labels[i], &area = layout.areas[i];
        if (label.height > 0) {
            list.AddRectFilled(im(Vec2(label.x, label.y + 7)), im(Vec2(label.x + 12, label.y + 19)),
                               theme.colour(pane_colour(i)), 2);
            fonts.paint(list, {label.x + 18, label.y + 18}, panes[i].label, 14, theme.colour(Colour::ink));
        }
        paint(list, panes[i].canvas, Projection(panes[i].view, area), theme, fonts);
    }
}

void save_framebuffer(const std::string& file, int x, int y, int width, int height)
{
    if (width < 1 || height < 1)
        throw std::runtime_error("the picture \"" + file + "\" would have " + std::to_string(width) + " x " +
                                 std::to_string(height) + " pixels; is the window minimised?");
    std::vector<unsigned char> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(x, y, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    stbi_flip_vertically_on_write(1);
    stbi_write_png_compression_level = 5;  // half the time of the default for a tenth more bytes
    // Through a stream: stbi_write_png does not look whether its fwrite succeeds.
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    const auto write = [](void* to, void* data, int size) {
        static_cast<std::ofstream*>(to)->write(static_cast<const char*>(data), size);
    };
    const int made = stbi_write_png_to_func(write, &stream, width, height, 3, pixels.data(), 3 * width);
    stream.close();
    if (made == 0 || !stream)
        throw std::runtime_error("the picture could not be written to \"" + file + "\"; is the disk full?");
}

}  // namespace rigid
