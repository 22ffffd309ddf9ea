#include "common/program/show.hpp"

#include "common/text.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <utility>

namespace rigid {
namespace {

void require_number(const std::string& name, Real value)
{
    if (std::isnan(value)) throw std::invalid_argument(name + " is to be nan; it must be a number");
}

void require_pace(const std::string& what, Real value)
{
    if (!(value >= 0) || !std::isfinite(value))
        throw std::invalid_argument("the " + what + " is " + shortest(value) +
                                    "; it must be zero or positive, and finite");
}

}  // namespace

void History::add(const Sample& sample)
{
    recent_.push_back(sample);
    if (recent_.size() > recent_steps) recent_.pop_front();
    if (added_++ % stride_ != 0) return;
    whole_.push_back(sample);
    if (whole_.size() < most_samples) return;
    for (std::size_t i = 0; 2 * i < whole_.size(); ++i) whole_[i] = whole_[2 * i];
    whole_.resize((whole_.size() + 1) / 2);
    stride_ *= 2;
}

Show::Show(const Program& program, const Options& options, Listener listener)
    : program_(&program), options_(options), scene_(options.scene), settings_(options.settings),
      listener_(std::move(listener)), pointer_(options.settings.seed, options.scene->view),
      scripted_(options.steps.has_value())
{
    require_number("the time step", settings_.h);
    for (const Tunable& tunable : scene_->tunables) require_number(tunable.name, settings_[tunable.name]);
    std::vector<std::string> first = options.methods;
    if (!options.methods_given && !scene_->side_by_side.empty()) first = scene_->side_by_side;
    if (first.size() > most_panes)
        throw std::invalid_argument("--method names " + std::to_string(first.size()) +
                                    " methods; a window shows " + std::to_string(most_panes) +
                                    " at most (--headless takes any number)");
    for (const std::string& method : scene_->methods)
        method_on_.push_back(std::find(first.begin(), first.end(), method) != first.end());
    start();
    if (!playback_) throw std::invalid_argument(refusal_);
}

std::size_t Show::methods_on() const
{
    return static_cast<std::size_t>(std::count(method_on_.begin(), method_on_.end(), true));
}

void Show::start()
{
    std::vector<std::string> methods;
    for (std::size_t i = 0; i < method_on_.size(); ++i)
        if (method_on_[i]) methods.push_back(scene_->methods[i]);
    if (methods.empty()) methods = {""};
    settings_.method = methods.front();
    pointer_ = ScriptedPointer(settings_.seed, scene_->view);
    due_ = 0;
    falls_behind_ = false;
    histories_.clear();
    playback_.reset();
    refusal_.clear();
    try {
        playback_.emplace(*scene_, settings_, methods);
    } catch (const std::invalid_argument& error) {
        refusal_ = error.what();
        return;
    }
    histories_.assign(methods.size(), std::vector<History>(scene_->columns.size()));
    remember(true);
}

void Show::restart() { start(); }

void Show::choose_scene(std::size_t index)
{
    const std::uint64_t seed = settings_.seed;
    scene_ = &program_->scenes.at(index);
    settings_ = default_settings(*scene_);
    settings_.seed = seed;
    const std::vector<std::string>& shown = scene_->side_by_side;
    method_on_.clear();
    for (const std::string& method : scene_->methods)
        method_on_.push_back(shown.empty() ? method_on_.empty()
                                           : std::find(shown.begin(), shown.end(), method) != shown.end());
    start();
}

void Show::change_scene(int direction)
{
    const auto count = static_cast<std::ptrdiff_t>(program_->scenes.size());
    const std::ptrdiff_t now = scene_ - program_->scenes.data();
    choose_scene(static_cast<std::size_t>((now + direction + count) % count));
}

void Show::choose_method(std::size_t index, bool on)
{
    if (method_on_[index] == on) return;
    if (!on && methods_on() == 1) return;
    if (on && methods_on() == most_panes)  // make room: the last one goes
        for (std::size_t i = method_on_.size(); i-- > 0;)
            if (method_on_[i]) {
                method_on_[i] = false;
                break;
            }
    method_on_[index] = on;
    start();
}

void Show::set_tunable(const Tunable& tunable, Real value)
{
    require_number(tunable.name, value);
    value = std::clamp(tunable.whole() ? std::round(value) : value, tunable.low, tunable.high);
    if (settings_.tunables[tunable.name] == value) return;
    settings_.tunables[tunable.name] = value;
    if (tunable.restarts() || !playback_) start();
    else playback_->set_tunable(tunable.name, value);
}

void Show::change_by_arrow(int direction)
{
    for (const Tunable& tunable : scene_->tunables) {
        if (!tunable.arrow_keys()) continue;
        const Real step = tunable.whole() ? 1 : (tunable.high - tunable.low) / 50;
        set_tunable(tunable, settings_[tunable.name] + direction * step);
        return;
    }
}

void Show::set_h(Real h)
{
    require_number("the time step", h);
    settings_.h = std::clamp(h, scene_->h_low, scene_->h_high);
    if (playback_) playback_->set_h(settings_.h);
    else start();
}

void Show::set_seed(std::uint64_t seed)
{
    settings_.seed = seed;
    start();
}

bool Show::is_over() const
{
    return !playback_ || !playback_->can_go_on() || (options_.steps && playback_->steps() >= *options_.steps);
}

void Show::advance(Real seconds, const Input& hand, long stop_every)
{
    require_pace("speed of the show", speed);
    require_pace("time since the last frame", seconds);
    if (paused || is_over()) return;
    // At most so many steps and so long a time of the processor [s] in one frame: a window must stay
    // alive. What is left over then is dropped, and the scene runs slower than set.
    constexpr Real most_steps = 4000, longest = 0.025;
    due_ += speed * seconds / settings_.h;
    falls_behind_ = due_ > most_steps;
    due_ = std::min(due_, most_steps);
    const std::clock_t start_of_frame = std::clock();
    while (due_ >= 1 && !is_over()) {
        due_ -= 1;
        step(hand);
        if (stop_every > 0 && playback_->steps() % stop_every == 0) return;
        const auto spent = static_cast<Real>(std::clock() - start_of_frame) / CLOCKS_PER_SEC;
        if (spent > longest && due_ >= 1) {
            falls_behind_ = true;
            due_ = 0;
        }
    }
}

void Show::single_step(const Input& hand)
{
    paused = true;
    if (!is_over()) step(hand);
}

void Show::step(const Input& hand)
{
    Input input = hand;
    if (scene_->steered && scripted_ && !hand.pressed)
        input = {.pointer = pointer_.at(playback_->time()), .present = true};
    playback_->step(input);
    remember(false);
}

void Show::remember(bool fresh)
{
    for (std::size_t k = 0; k < playback_->tracks().size(); ++k) {
        const Track& track = playback_->tracks()[k];
        if (!track.can_go_on()) continue;
        for (std::size_t c = 0; c < track.measured.size(); ++c)
            if (scene_->columns[c].plotted()) histories_[k][c].add({track.time, track.measured[c]});
    }
    if (listener_) listener_(*playback_, fresh);
}

}  // namespace rigid
