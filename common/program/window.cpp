#include "common/program/window.hpp"

#include "common/elementary.hpp"
#include "common/gl_canvas.hpp"
#include "common/program/interrupt.hpp"
#include "common/program/outputs.hpp"
#include "common/program/panel.hpp"
#include "common/program/panes.hpp"
#include "common/program/show.hpp"
#include "common/program/table.hpp"
#include "common/svg_canvas.hpp"
#include "common/text.hpp"

#include <GL/glew.h>
// After GLEW: the functions of OpenGL come from there.
#include <GLFW/glfw3.h>
#ifdef RIGID_IMGUI_FLAT
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#else
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <thread>

namespace rigid {
namespace {

/// GLFW's last complaint; its callback takes no pointer of ours.
std::string& glfw_complaint()
{
    static std::string text;
    return text;
}

class Window {
public:
    Window(const Program& program, const Options& options)
        : options_(options),
          show_(program, options,
                [this, table = table_of_show(options.csv)](const Playback& playback, bool fresh) {
                    if (fresh) watch_.listen(playback);
                    if (table) table(playback, fresh);
                })
    {
        if (!options.svg.empty()) require_writable("the picture", options.svg);
        if (!options.png.empty()) require_writable("the picture", options.png);
    }
    ~Window() { close(); }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    bool open(std::string& reason)
    {
        glfwSetErrorCallback([](int, const char* words) { glfw_complaint() = words; });
        reason = "The window can't be opened";
        if (!glfwInit()) return complain(reason);
        glfw_started_ = true;
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        int x = 0, y = 0, width = 1280, height = 800;
        if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
            glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
            const GLFWvidmode* mode = glfwGetVideoMode(monitor);
            if (mode && mode->refreshRate > 0) refresh_ = 1.0 / mode->refreshRate;
        }
        // Most of the screen, as far as the eye reaches.
        width = std::min(width, std::clamp(17 * width / 20, 1280, 1800));
        height = std::min(height, std::clamp(17 * height / 20, 800, 1125));
        window_ = glfwCreateWindow(width, height, show_.program().title.c_str(), nullptr, nullptr);
        if (!window_) return complain(reason);
        glfwSetWindowSizeLimits(window_, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(1);
        glewExperimental = GL_TRUE;
        const GLenum loaded = glewInit();
        if ((loaded != GLEW_OK && loaded != 4) ||
            !glGenBuffers) {  // 4: no GLX (Wayland), though all is loaded
            reason += " (the functions of OpenGL could not be loaded)";
            return false;
        }
        // Before Dear ImGui, which calls whatever was there first.
        glfwSetWindowUserPointer(window_, this);
        glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int mods) {
            if (action != GLFW_RELEASE)
                static_cast<Window*>(glfwGetWindowUserPointer(window))->keys_.push_back({key, mods});
        });
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui_ImplGlfw_InitForOpenGL(window_, true);
        ImGui_ImplOpenGL3_Init("#version 330 core");
        imgui_started_ = true;

        // HiDPI: on some systems a window's unit is a pixel and everything must grow, on others a unit
        // is several pixels and only letters must be finer.
        float content = 1;
        glfwGetWindowContentScale(window_, &content, nullptr);
        int units = 0, pixels = 0;
        glfwGetWindowSize(window_, &units, nullptr);
        glfwGetFramebufferSize(window_, &pixels, nullptr);
        density_ = units > 0 ? std::max(1.0, static_cast<Real>(pixels) / units) : 1;
        scale_ = std::clamp(static_cast<Real>(content) / density_, 1.0, 4.0);
        fonts_ = std::make_unique<Fonts>(scale_, density_);
        ImGui::GetIO().FontGlobalScale = static_cast<float>(1 / density_);
        if (!options_.record.empty()) {
            start_recording(options_.record, options_.every);
            frame_due_ = true;  // the first picture is of the start
        }
        return true;
    }

    int run()
    {
        InterruptGuard guard;
        state_.watch = &watch_;
        state_.dark = options_.dark;
        auto before = std::chrono::steady_clock::now();
        while (true) {
            const bool last = glfwWindowShouldClose(window_) || InterruptGuard::interrupted() ||
                              (options_.steps && show_.is_over());
            frame();
            if (last) break;
            glfwSwapBuffers(window_);
            const bool idle = show_.paused || show_.is_over();
            if (idle) glfwWaitEventsTimeout(0.05);
            else glfwPollEvents();

            // Without a display that waits, wait here.
            auto now = std::chrono::steady_clock::now();
            const auto shortest_frame = std::chrono::duration<Real>(0.9 * refresh_);
            if (now - before < shortest_frame) {
                std::this_thread::sleep_for(shortest_frame - (now - before));
                now = std::chrono::steady_clock::now();
            }
            const Real seconds = std::chrono::duration<Real>(now - before).count();
            before = now;
            frames_per_second_ += 0.05 * (1 / std::max(seconds, 1e-4) - frames_per_second_);
            state_.frames_per_second = frames_per_second_;
            handle_keys();
            // A frame that lasts about a refresh lasted one refresh: no stutter by the clock's jitter.
            const Real lasted =
                std::abs(seconds - refresh_) < 0.3 * refresh_ ? refresh_ : std::min(seconds, 0.1);
            advance(lasted);
        }
        if (!options_.png.empty()) save_window(options_.png);  // before the buffers are swapped
        if (!options_.svg.empty() && show_.playback()) write_svg(options_.svg, show_.playback()->draw());
        if (show_.playback())
            for (const std::string& sentence : show_.playback()->failures()) std::cerr << sentence << '\n';
        if (InterruptGuard::interrupted()) return 128 + InterruptGuard::signal();
        if (!record_failure_.empty()) {
            std::cerr << record_failure_ << '\n';
            return 3;
        }
        return show_.playback() && !show_.playback()->failures().empty() ? 3 : 0;
    }

private:
    bool complain(std::string& reason) const
    {
        if (!glfw_complaint().empty()) reason += " (" + glfw_complaint() + ')';
        return false;
    }

    void close()
    {
        if (imgui_started_) {
            ImGui_ImplOpenGL3_Shutdown();
            ImGui_ImplGlfw_Shutdown();
            ImGui::DestroyContext();
        }
        if (window_) glfwDestroyWindow(window_);
        if (glfw_started_) glfwTerminate();
    }

    // ---- the reader's hand --------------------------------------------------------------------

    void handle_keys()
    {
        std::vector<Key> keys;
        keys.swap(keys_);
        if (ImGui::GetIO().WantTextInput) return;
        for (const auto& [key, mods] : keys) {
            if (move_view(key, (mods & GLFW_MOD_SHIFT) != 0)) continue;
            if (key == GLFW_KEY_SPACE) show_.paused = !show_.paused;
            if (key == GLFW_KEY_S || key == GLFW_KEY_RIGHT) show_.single_step(hand_.input());
            if (key == GLFW_KEY_R) show_.restart();
            if (key == GLFW_KEY_UP) show_.change_by_arrow(+1);
            if (key == GLFW_KEY_DOWN) show_.change_by_arrow(-1);
            if (key == GLFW_KEY_P) state_.save_picture = true;
            if (key == GLFW_KEY_D) state_.dark = !state_.dark;
            if (key == GLFW_KEY_TAB) state_.visible = !state_.visible;
            if (key == GLFW_KEY_N) show_.change_scene(+1);
            if (key == GLFW_KEY_B) show_.change_scene(-1);
            if (key != GLFW_KEY_ESCAPE) continue;
            if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) state_.close_list = true;
            else glfwSetWindowShouldClose(window_, GLFW_TRUE);
        }
    }

    /// True if the key belongs to the view.
    bool move_view(int key, bool shift)
    {
        const View& view = show_.scene().view;
        const View shown = zoom_.of(view);
        const auto by = [&](Real factor) { zoom_.by(factor, shown.centre, view); };
        const auto go = [&](Real right, Real up) {
            if (shift) zoom_.drag(-0.2 * Vec2(right, up).cwiseProduct(shown.half_size));
            return shift;
        };
        switch (key) {
        case GLFW_KEY_EQUAL:
        case GLFW_KEY_KP_ADD:
            by(1.25);
            return true;
        case GLFW_KEY_MINUS:
        case GLFW_KEY_KP_SUBTRACT:
            by(1 / 1.25);
            return true;
        case GLFW_KEY_0:
        case GLFW_KEY_KP_0:
            zoom_.reset();
            return true;
        case GLFW_KEY_LEFT:
            return go(-1, 0);
        case GLFW_KEY_RIGHT:
            return go(1, 0);
        case GLFW_KEY_UP:
            return go(0, 1);
        case GLFW_KEY_DOWN:
            return go(0, -1);
        default:
            return false;
        }
    }

    /// The wheel over a pane, and the middle button.
    void read_wheel()
    {
        if (&show_.scene() != zoomed_scene_) zoom_.reset();
        zoomed_scene_ = &show_.scene();
        const ImGuiIO& io = ImGui::GetIO();
        if (io.WantCaptureMouse) return;
        const Vec2 mouse(static_cast<Real>(io.MousePos.x), static_cast<Real>(io.MousePos.y));
        for (const Projection& pane : projections_) {
            if (!pane.area.contains(mouse)) continue;
            if (io.MouseWheel != 0)
                zoom_.by(pow(1.15, static_cast<Real>(io.MouseWheel)), pane.to_world(mouse),
                         show_.scene().view);
            if (io.MouseDown[2])
                zoom_.drag({static_cast<Real>(io.MouseDelta.x) / pane.scale,
                            -static_cast<Real>(io.MouseDelta.y) / pane.scale});
            return;
        }
    }

    void read_hand()
    {
        const ImGuiIO& io = ImGui::GetIO();
        hand_.read(projections_, {static_cast<Real>(io.MousePos.x), static_cast<Real>(io.MousePos.y)},
                   io.MouseDown[0], io.WantCaptureMouse);
    }

    void advance(Real seconds)
    {
        if (state_.single_step) show_.single_step(hand_.input());
        state_.single_step = false;
        const long steps_before = show_.playback() ? show_.playback()->steps() : 0;
        show_.advance(seconds, hand_.input(), state_.recording ? every_ : 0);
        const Playback* playback = show_.playback();
        if (state_.recording && playback && playback->steps() != steps_before &&
            playback->steps() % every_ == 0)
            frame_due_ = true;
    }

    // ---- a frame ------------------------------------------------------------------------------

    void frame()
    {
        if (std::chrono::steady_clock::now() > message_until_) state_.message.clear();
        const Theme theme{state_.dark};
        set_style(theme, scale_);
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        const Real left = state_.visible ? panel_width(scale_) : 0;
        pictures_ = {left, 0, std::max<Real>(static_cast<Real>(size.x) - left, 1), static_cast<Real>(size.y)};
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        list.AddRectFilled({0, 0}, size, theme.ground());
        if (state_.visible) draw_panel(show_, state_, theme, *fonts_, scale_, static_cast<Real>(size.y));
        draw_panes(list, theme);
        read_hand();
        read_wheel();
        ImGui::Render();
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        glViewport(0, 0, width, height);
        glClear(GL_COLOR_BUFFER_BIT);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());

        if (state_.toggle_recording) toggle_recording();
        if (state_.save_picture) save_picture();
        if (frame_due_) record_frame();
        state_.toggle_recording = state_.save_picture = frame_due_ = false;
    }

    void draw_panes(ImDrawList& list, const Theme& theme)
    {
        projections_.clear();
        const Real gap = 10 * scale_, label = 26 * scale_;
        const Rectangle area = {pictures_.x + (state_.visible ? 0 : gap), pictures_.y + gap,
                                pictures_.width - (state_.visible ? 1 : 2) * gap, pictures_.height - 2 * gap};
        if (!show_.playback()) {
            card(list, theme, area);
            sentence(list, theme, area, show_.refusal());
            return;
        }
        show_.look(hand_.input());
        const std::vector<Pane> panes = show_.playback()->draw();
        const std::vector<Track>& tracks = show_.playback()->tracks();
        const std::vector<Rectangle> places = pane_grid(area, panes.size(), show_.scene().view, label, gap);
        for (std::size_t i = 0; i < panes.size(); ++i) {
            const Rectangle& place = places[i];
            card(list, theme, place);
            const Rectangle picture = {place.x + 1, place.y + label, place.width - 2,
                                       place.height - label - 1};
            const View view = zoom_.of(panes[i].view);
            const Projection& projection = projections_.emplace_back(view, picture);
            // Letters keep their place among the shapes, as far as they stay readable.
            const Real grown = projection.scale / scale_ / design_scale(view);
            paint(list, panes[i].canvas, projection, theme, *fonts_, scale_ * std::clamp(grown, 0.72, 1.5),
                  grown > 0.45);
            header(list, theme, place, label, i, panes.size() > 1, tracks[i]);
            if (!tracks[i].can_go_on()) sentence(list, theme, picture, show_failure(tracks[i]));
            draw_pointer(list, theme, projection, i);
        }
    }

    static std::string show_failure(const Track& track)
    {
        return "step " + std::to_string(track.measured.empty() ? 0 : track.steps + 1) + ": " + track.failure;
    }

    static ImVec2 corner(const Rectangle& r) { return {static_cast<float>(r.x), static_cast<float>(r.y)}; }
    static ImVec2 opposite(const Rectangle& r)
    {
        return {static_cast<float>(r.x + r.width), static_cast<float>(r.y + r.height)};
    }

    void card(ImDrawList& list, const Theme& theme, const Rectangle& place) const
    {
        const float rounding = static_cast<float>(5 * scale_);
        list.AddRectFilled(corner(place), opposite(place), theme.card(), rounding);
        list.AddRect(corner(place), opposite(place), theme.edge(), rounding);
    }

    /// The pane's method, and where it is in time.
    void header(ImDrawList& list, const Theme& theme, const Rectangle& place, Real label, std::size_t i,
                bool several, const Track& track) const
    {
        const Real baseline = place.y + 0.66 * label;
        Real x = place.x + 10 * scale_;
        if (several) {
            const float size = static_cast<float>(10 * scale_);
            const ImVec2 at = {static_cast<float>(x), static_cast<float>(baseline) - size};
            list.AddRectFilled(at, {at.x + size, at.y + size}, theme.colour(pane_colour(i)), size / 5);
            x += 16 * scale_;
        }
        const std::string time = "t = " + fixed(track.time, 2) + " s";
        const auto width = [&](const std::string& text, Real size) {
            const float points = static_cast<float>(size * scale_);
            return static_cast<Real>(
                fonts_->nearest(size * scale_)->CalcTextSizeA(points, FLT_MAX, 0, text.c_str()).x);
        };
        // in a narrow pane the name comes first: the panel says the time
        const Real end = place.x + place.width - 10 * scale_;
        if (x + width(track.method, 13) + 8 * scale_ + width(time, 12) <= end)
            fonts_->paint(list, {end, baseline}, time, 12 * scale_, theme.colour(Colour::ink, 0.62),
                          Align::right);
        list.PushClipRect(corner(place), opposite(place), true);
        fonts_->paint(list, {x, baseline}, track.method, 13 * scale_, theme.colour(Colour::ink));
        list.PopClipRect();
    }

    /// A sentence across the lower end of an area.
    void sentence(ImDrawList& list, const Theme& theme, const Rectangle& area, const std::string& words) const
    {
        const std::string text = fonts_->shown(words);
        const ImFont* font = fonts_->nearest(15 * scale_);
        const float size = static_cast<float>(15 * scale_), pad = static_cast<float>(10 * scale_);
        const float wrap = static_cast<float>(area.width) - 2 * pad;
        const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, wrap, text.c_str());
        const ImVec2 end = opposite(area);
        const ImVec2 begin = {corner(area).x, end.y - extent.y - 2 * pad};
        list.AddRectFilled(begin, end, theme.card());
        list.AddRectFilled(begin, end, theme.colour(Colour::red, 0.16));
        list.AddText(font, size, {begin.x + pad, begin.y + pad}, theme.colour(Colour::red), text.c_str(),
                     nullptr, wrap);
    }

    void draw_pointer(ImDrawList& list, const Theme& theme, const Projection& projection, std::size_t i) const
    {
        const std::optional<Vec2> where = hand_.mark(show_, i);
        if (!where) return;
        const Vec2 p = projection.to_pixel(*where);
        list.AddCircle({static_cast<float>(p.x()), static_cast<float>(p.y())}, static_cast<float>(6 * scale_),
                       theme.colour(Colour::ink, 0.5), 0, static_cast<float>(1.5 * scale_));
    }

    void say(const std::string& words)
    {
        state_.message = words;
        message_until_ = std::chrono::steady_clock::now() + std::chrono::seconds(4);
    }

    // ---- pictures -----------------------------------------------------------------------------

    void save_window(const std::string& file) const
    {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        save_framebuffer(file, 0, 0, width, height);
    }

    void save_panes(const std::string& file) const
    {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        const int left =
            std::clamp(static_cast<int>(std::lround(density_ * pictures_.x)), 0, std::max(width - 1, 0));
        save_framebuffer(file, left, 0, width - left, height);
    }

    void save_picture()
    {
        if (!show_.playback()) return;
        const std::string stem = show_.program().name + '_' + show_.scene().name + "_step" +
                                 std::to_string(show_.playback()->steps());
        try {
            write_svg(stem + ".svg", show_.playback()->draw());
            save_panes(stem + ".png");
            say("saved " + stem + ".svg and .png");
        } catch (const std::runtime_error& error) {
            say(error.what());
        }
    }

    void start_recording(const std::string& folder, long every)
    {
        require_folder(folder);
        state_.recording = true;
        state_.record_folder = folder;
        state_.frames_recorded = 0;
        every_ = every;
    }

    void toggle_recording()
    {
        if (state_.recording) {
            state_.recording = false;
            say(std::to_string(state_.frames_recorded) + " pictures in " + state_.record_folder);
            return;
        }
        // A folder that isn't there yet, and about 30 pictures for each second of the scene.
        const std::string stem = show_.program().name + '_' + show_.scene().name + "_recording";
        std::string folder = stem;
        for (int i = 2; std::filesystem::exists(folder); ++i) folder = stem + std::to_string(i);
        const long every = std::max(1L, std::lround(1 / (30 * show_.settings().h)));
        try {
            start_recording(folder, options_.every > 1 ? options_.every : every);
            say("recording into " + folder);
        } catch (const std::invalid_argument& error) {
            say(error.what());
        }
    }

    void record_frame()
    {
        const std::filesystem::path file =
            std::filesystem::path(state_.record_folder) / frame_name(state_.frames_recorded, ".png");
        try {
            save_panes(file.string());
            ++state_.frames_recorded;
        } catch (const std::runtime_error& error) {
            state_.recording = false;
            say(error.what());
            if (!options_.record.empty()) record_failure_ = error.what();  // what was asked for is not there
        }
    }

    Options options_;
    PartWatch watch_;
    Show show_;
    PanelState state_;
    GLFWwindow* window_ = nullptr;
    bool glfw_started_ = false, imgui_started_ = false;
    std::unique_ptr<Fonts> fonts_;
    Real scale_ = 1;    ///< units of the window for one pixel of a design at 96 dpi
    Real density_ = 1;  ///< pixels of the framebuffer for one unit of the window
    Real refresh_ = 1.0 / 60, frames_per_second_ = 60;
    struct Key {
        int key, mods;
    };
    std::vector<Key> keys_;
    Hand hand_;
    Zoom zoom_;
    const Demo* zoomed_scene_ = nullptr;  ///< another one begins with its own view
    Rectangle pictures_;
    std::vector<Projection> projections_;
    long every_ = 1;
    bool frame_due_ = false;
    std::string record_failure_;
    std::chrono::steady_clock::time_point message_until_;
};

}  // namespace

std::optional<int> run_window(const Program& program, const Options& options, std::string& reason)
{
    Window window(program, options);
    if (!window.open(reason)) return std::nullopt;
    return window.run();
}

}  // namespace rigid
