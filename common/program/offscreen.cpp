#include "common/program/offscreen.hpp"

#include "common/gl_canvas.hpp"

#include <GL/glew.h>
// After GLEW: the functions of OpenGL come from there.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#ifdef RIGID_IMGUI_FLAT
#include <imgui_impl_opengl3.h>
#else
#include <backends/imgui_impl_opengl3.h>
#endif

#include <stdexcept>

namespace rigid {
namespace {

/// A context that has no window, and the framebuffer that stands for one.
class OffscreenPainter : public PicturePainter {
public:
    explicit OffscreenPainter(bool dark) : theme_{dark} { begin(); }
    ~OffscreenPainter() override { end(); }
    OffscreenPainter(const OffscreenPainter&) = delete;
    OffscreenPainter& operator=(const OffscreenPainter&) = delete;

    const std::string& reason() const { return reason_; }

    void write_png(const std::string& file, const std::vector<Pane>& panes) override
    {
        constexpr int margin = 8;
        PictureLayout layout = lay_out(panes);
        for (Rectangle* part : {layout.labels.data(), layout.areas.data()})
            for (std::size_t i = 0; i < panes.size(); ++i) {
                part[i].x += margin;
                part[i].y += margin;
            }
        const int width = static_cast<int>(layout.width) + 2 * margin;
        const int height = static_cast<int>(layout.height) + 2 * margin;
        resize(width, height);

        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
        io.DeltaTime = 1.0f / 60;
        ImGui_ImplOpenGL3_NewFrame();
        ImGui::NewFrame();
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        list.AddRectFilled({0, 0}, io.DisplaySize, theme_.card());
        paint_picture(list, panes, layout, theme_, *fonts_);
        ImGui::Render();
        glViewport(0, 0, width, height);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        save_framebuffer(file, 0, 0, width, height);
    }

private:
    void begin()
    {
        const auto get_display =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
        if (get_display) display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) {
            reason_ = "EGL offers no display without a surface here";
            display_ = EGL_NO_DISPLAY;
            return;
        }
        const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                 EGL_NONE};
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (eglBindAPI(EGL_OPENGL_API)) {
            eglChooseConfig(display_, wanted, &config, 1, &count);
            context_ =
                eglCreateContext(display_, count > 0 ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
        }
        if (context_ == EGL_NO_CONTEXT ||
            !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
            reason_ = "there is no OpenGL 3.3 here";
            return;
        }
        glewExperimental = GL_TRUE;
        const GLenum loaded = glewInit();
        // Without an X display GLEW says so (4) though it has loaded all functions.
        if ((loaded != GLEW_OK && loaded != 4) || !glGenFramebuffers) {
            reason_ = "the functions of OpenGL could not be loaded";
            return;
        }
        ImGui::CreateContext();
        has_imgui_ = true;
        ImGui::GetIO().IniFilename = nullptr;
        fonts_ = std::make_unique<Fonts>(1, 1);
        if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
            reason_ = "Dear ImGui could not start on OpenGL";
            return;
        }
        has_backend_ = true;
        glGenFramebuffers(1, &framebuffer_);
        glGenRenderbuffers(1, &colours_);
    }

    void end()
    {
        if (has_backend_) {
            glDeleteRenderbuffers(1, &colours_);
            glDeleteFramebuffers(1, &framebuffer_);
            ImGui_ImplOpenGL3_Shutdown();
        }
        if (has_imgui_) ImGui::DestroyContext();
        if (display_ == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
        // The display stays: it is one for the whole process, and another painter may be using it.
    }

    void resize(int width, int height)
    {
        if (width == width_ && height == height_) return;
        width_ = width;
        height_ = height;
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glBindRenderbuffer(GL_RENDERBUFFER, colours_);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("OpenGL can't paint a picture of " + std::to_string(width) + " x " +
                                     std::to_string(height) + " pixels");
    }

    Theme theme_;
    std::string reason_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    std::unique_ptr<Fonts> fonts_;
    bool has_imgui_ = false, has_backend_ = false;
    GLuint framebuffer_ = 0, colours_ = 0;
    int width_ = 0, height_ = 0;
};

}  // namespace

std::unique_ptr<PicturePainter> make_offscreen_painter(bool dark, std::string& reason)
{
    auto painter = std::make_unique<OffscreenPainter>(dark);
    reason = painter->reason();
    if (!reason.empty()) return nullptr;
    return painter;
}

}  // namespace rigid
