#include "common/program/offscreen.hpp"

namespace rigid {

std::unique_ptr<PicturePainter> make_offscreen_painter(bool, std::string& reason)
{
    reason = "this program was built without it (EGL, GLEW, Dear ImGui or stb was missing)";
    return nullptr;
}

}  // namespace rigid
