#include "common/svg_canvas.hpp"

#include "common/text.hpp"

#include <fstream>
#include <stdexcept>

namespace rigid {
namespace {

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        if (c == '&') result += "&amp;";
        else if (c == '<') result += "&lt;";
        else if (c == '>') result += "&gt;";
        else if (c == '"') result += "&quot;";
        else if (static_cast<unsigned char>(c) < 0x20) result += ' ';  // no control characters in XML
        else result += c;
    }
    return result;
}

std::string number(Real pixels) { return fixed(pixels, 2); }

std::string attribute(const char* name, Real value)
{
    return std::string(" ") + name + "=\"" + number(value) + '"';
}

std::string opacity_attribute(const char* name, Real value)
{
    return value >= 1 ? std::string() : attribute(name, value);
}

std::string stroke(const Style& style, Real opacity)
{
    if (!(style.width > 0)) return {};
    std::string text = " stroke=\"" + svg_colour(style.colour) + '"' +
                       attribute("stroke-width", style.width) + opacity_attribute("stroke-opacity", opacity);
    if (style.dashed()) text += " stroke-dasharray=\"" + number(dash_length) + ' ' + number(dash_gap) + '"';
    return text;
}

std::string fill_and_stroke(const Style& style)
{
    const Real opacity = seen_opacity(style);
    if (!style.filled()) return " fill=\"none\"" + stroke(style, opacity);
    return " fill=\"" + svg_colour(style.colour) + '"' + opacity_attribute("fill-opacity", opacity) +
           stroke(style, std::sqrt(opacity));
}

std::string points_attribute(const std::vector<Vec2>& points)
{
    std::string text = " points=\"";
    for (std::size_t i = 0; i < points.size(); ++i)
        text += (i ? " " : "") + number(points[i].x()) + ',' + number(points[i].y());
    return text + '"';
}

std::string text_element(const Vec2& p, const std::string& words, Real size, const std::string& colour,
                         Real opacity, Align align, bool bold)
{
    std::string text = "<text" + attribute("x", p.x()) + attribute("y", p.y()) + attribute("font-size", size);
    if (align == Align::centre) text += " text-anchor=\"middle\"";
    if (align == Align::right) text += " text-anchor=\"end\"";
    if (bold) text += " font-weight=\"bold\"";
    return text + " fill=\"" + colour + '"' + opacity_attribute("fill-opacity", opacity) + '>' +
           escaped(words) + "</text>\n";
}

std::string element(const DrawItem& item, const Projection& projection)
{
    const Style& style = item.style;
    const std::vector<Vec2> points = pixels_of(item, projection);
    const Real opacity = seen_opacity(style);
    switch (item.kind) {
    case DrawItem::Kind::disc:
        return "<circle" + attribute("cx", points[0].x()) + attribute("cy", points[0].y()) +
               attribute("r", projection.scale * item.radius) + fill_and_stroke(style) + "/>\n";
    case DrawItem::Kind::polygon:
        return "<polygon" + points_attribute(points) + fill_and_stroke(style) + "/>\n";
    case DrawItem::Kind::line: {
        std::string text;
        for (const auto& piece : near_pieces(points))
            text +=
                "<polyline" + points_attribute(piece) + " fill=\"none\"" + stroke(style, opacity) + "/>\n";
        return text;
    }
    case DrawItem::Kind::arrow: {
        if ((points[1] - points[0]).norm() < 0.5) return {};  // no direction to be seen
        const ArrowShape shape = arrow_shape(points[0], points[1], style.width);
        return "<polyline" + points_attribute({points[0], shape.shaft_end}) + " fill=\"none\"" +
               stroke(style, opacity) + "/>\n<polygon" +
               points_attribute({shape.left, shape.tip, shape.right}) + " fill=\"" +
               svg_colour(style.colour) + '"' + opacity_attribute("fill-opacity", opacity) + "/>\n";
    }
    case DrawItem::Kind::text:
        return text_element(points[0], item.text, item.size, svg_colour(style.colour), opacity, item.align,
                            false);
    }
    return {};
}

}  // namespace

std::string svg_colour(Colour colour)
{
    switch (colour) {
    case Colour::ink:
    case Colour::faint:
        return "#808080";
    case Colour::blue:
        return "#4477AA";
    case Colour::orange:
        return "#EE7733";
    case Colour::green:
        return "#228833";
    case Colour::red:
        return "#CC3311";
    case Colour::purple:
        return "#AA3377";
    case Colour::yellow:
        return "#CCBB44";
    }
    return "#808080";
}

std::string to_svg(const std::vector<Pane>& panes)
{
    if (panes.empty()) throw std::invalid_argument("the picture has 0 panes; it must have at least one");
    for (const Pane& pane : panes) {
        if (!pane.view.centre.allFinite())
            throw std::invalid_argument("the centre of the view is " + readable(pane.view.centre.x()) + ", " +
                                        readable(pane.view.centre.y()) + "; it must be finite");
        if (!pane.view.half_size.allFinite() || !(pane.view.half_size.minCoeff() > 0))
            throw std::invalid_argument("the view shows " + readable(2 * pane.view.half_size.x()) + " m x " +
                                        readable(2 * pane.view.half_size.y()) +
                                        " m; both must be positive and finite");
    }

    const PictureLayout layout = lay_out(panes);
    const std::string width = number(layout.width), height = number(layout.height);
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" +
                       height + "\" viewBox=\"0 0 " + width + ' ' + height +
                       "\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" "
                       "stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for (std::size_t i = 0; i < panes.size(); ++i) {
        const Rectangle &label = layout.labels[i], &area = layout.areas[i];
        if (label.height > 0) {
            text += "<rect" + attribute("x", label.x) + attribute("y", label.y + 7) +
                    " width=\"12\" height=\"12\" rx=\"2\" fill=\"" + svg_colour(pane_colour(i)) + "\"/>\n";
            text += text_element({label.x + 18, label.y + 18}, panes[i].label, 15, "#808080", 1, Align::left,
                                 true);
        }
        // A picture within the picture cuts off what stands outside its pane.
        const Rectangle inner = {0, 0, area.width, area.height};
        text += "<svg" + attribute("x", area.x) + attribute("y", area.y) + attribute("width", area.width) +
                attribute("height", area.height) + ">\n";
        const Projection projection(panes[i].view, inner);
        for (const DrawItem& item : panes[i].canvas.items())
            if (is_paintable(item, projection)) text += element(item, projection);
        text += "</svg>\n";
    }
    return text + "</svg>\n";
}

void write_svg(const std::string& file, const std::vector<Pane>& panes)
{
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream << to_svg(panes);
    stream.close();
    if (!stream)
        throw std::runtime_error("the picture could not be written to \"" + file + "\"; is the disk full?");
}

}  // namespace rigid
