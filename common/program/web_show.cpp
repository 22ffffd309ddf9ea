#include "common/program/web_show.hpp"

#include "common/text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rigid {
namespace {

constexpr Real label_height = 26, gap = 8, corner = 5;  // [pixels]

}  // namespace

Real WebShow::height(Real width, Real most) const
{
    const std::size_t count = show_.playback() ? show_.playback()->tracks().size() : 1;
    const Vec2& half = show_.scene().view.half_size;
    Real widest = 0, wanted = most;
    for (std::size_t columns = 1; columns <= count; ++columns) {
        const Real c = static_cast<Real>(columns), r = static_cast<Real>((count + columns - 1) / columns);
        const Real pane = (width - (c - 1) * gap) / c;
        const Real all = r * (pane * half.y() / half.x() + label_height) + (r - 1) * gap;
        if (all > most || pane <= widest) continue;
        widest = pane;
        wanted = all;
    }
    return wanted;
}

const DrawList& WebShow::picture(Real width, Real height)
{
    list_.clear();
    projections_.clear();
    const Playback* playback = show_.playback();
    if (!playback) return list_;
    show_.look(hand_.input());
    const std::vector<Pane> panes = playback->draw();
    const std::vector<Rectangle> places =
        pane_grid({0, 0, width, height}, panes.size(), show_.scene().view, label_height, gap);
    for (std::size_t i = 0; i < panes.size(); ++i)
        pane(places[i], panes[i], playback->tracks()[i], i, panes.size() > 1);
    return list_;
}

void WebShow::pane(const Rectangle& place, const Pane& pane, const Track& track, std::size_t i, bool several)
{
    list_.card(place, corner);
    const Rectangle picture = {place.x + 1, place.y + label_height, place.width - 2,
                               place.height - label_height - 1};
    const Projection& projection = projections_.emplace_back(pane.view, picture);
    // Letters keep their place among the shapes, as far as they stay readable.
    list_.paint(pane.canvas, projection, std::clamp(projection.scale / design_scale(pane.view), 0.62, 1.5));

    const Real baseline = place.y + 0.68 * label_height;
    Real x = place.x + 9;
    if (several) {
        list_.square({x, baseline - 9, 10, 10}, pane_colour(i));
        x += 16;
    }
    const int ink = static_cast<int>(Colour::ink);
    const bool narrow_pane = place.width < 180;
    if (!narrow_pane || !several)
        list_.text({place.x + place.width - 9, baseline}, "t = " + fixed(track.time, 2) + " s", 12, ink, 0.7,
                   Align::right, false);
    std::string method = track.method;
    std::replace(method.begin(), method.end(), '_', ' ');
    list_.text({x, baseline}, method, 13, ink, 1, Align::left, several);
    if (const std::optional<Vec2> mark = hand_.mark(show_, i)) list_.ring(projection.to_pixel(*mark), 6, 1.5);
}

const DrawList& WebShow::plot(std::size_t column, Real width, Real height, bool whole_run)
{
    constexpr Real gutter = 46, margin = 5;
    list_.clear();
    list_.card({0, 0, width, height}, 3);
    list_.line({{gutter - 2, 0}, {gutter - 2, height}}, DrawList::rim, 1, 1);
    const TimeSpan span = plot_span(show_, whole_run);
    const std::optional<LivePlot> plot = plot_of(show_, column, span, whole_run);
    if (!plot) return list_;
    const Real tall = height - 2 * margin;
    if (plot->low < 0 && plot->high > 0) {  // where zero is
        const Real y = margin + tall * plot->high / (plot->high - plot->low);
        list_.line({{gutter, y}, {width, y}}, DrawList::rim, 1, 1);
    }
    list_.clip({gutter, 0, width - gutter, height});
    const int ink = static_cast<int>(Colour::ink);
    const auto draw = [&](const LivePlot::Pieces& pieces, int colour, Real opacity) {
        for (const std::vector<Vec2>& piece : pieces) {
            std::vector<Vec2> points;
            for (const Vec2& p : piece)
                points.push_back({gutter + p.x() * (width - gutter - margin), margin + (1 - p.y()) * tall});
            if (points.size() > 1) list_.line(points, colour, opacity, 1.5);
        }
    };
    for (const LivePlot::Pieces& pieces : plot->beside) draw(pieces, ink, 0.4);
    for (std::size_t k = plot->curves.size(); k-- > 0;)
        draw(plot->curves[k], static_cast<int>(pane_colour(k)), 1);
    list_.unclip();
    list_.text({gutter - 6, 12}, plot->high_text, 10.5, ink, 0.75, Align::right, false);
    list_.text({gutter - 6, height - 4}, plot->low_text, 10.5, ink, 0.75, Align::right, false);
    return list_;
}

void WebShow::point(const Vec2& where, bool present, bool down)
{
    if (present && show_.is_scripted()) show_.set_script(false);
    hand_.read(projections_, where, down, !present);
}

void WebShow::advance(Real seconds)
{
    // A page that was hidden has no backlog.
    show_.advance(std::clamp(seconds, 0.0, 0.1), hand_.input(), 0);
}

std::uint64_t seed_of(Real number)
{
    if (!(number >= 0 && number <= 0x1p53) || number != std::floor(number))
        throw std::invalid_argument("the seed is " + shortest(number) +
                                    "; it must be a whole number from 0 to 2^53");
    return static_cast<std::uint64_t>(number);
}

std::vector<Real> rows_of_run(const Demo& scene, const Settings& settings,
                              const std::vector<std::string>& methods, long steps)
{
    Playback playback(scene, settings, methods);
    const ScriptedPointer pointer(settings.seed, scene.view);
    std::vector<Real> rows;
    const auto add = [&] {
        for (const Track& track : playback.tracks()) {
            if (track.measured.empty() || track.steps != playback.steps()) continue;
            rows.push_back(static_cast<Real>(track.steps));
            rows.push_back(track.time);
            rows.insert(rows.end(), track.measured.begin(), track.measured.end());
        }
    };
    add();
    while (playback.steps() < steps && playback.can_go_on()) {
        Input input;
        if (scene.steered) input = {.pointer = pointer.at(playback.time()), .present = true};
        playback.step(input);
        add();
    }
    return rows;
}

}  // namespace rigid
