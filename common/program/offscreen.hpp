/// \file offscreen.hpp
/// Pictures painted by OpenGL without a window and without a display.
#pragma once

#include "common/picture.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rigid {

class PicturePainter {
public:
    virtual ~PicturePainter() = default;
    /// Throws std::runtime_error, naming the file, if it can't be written.
    virtual void write_png(const std::string& file, const std::vector<Pane>& panes) = 0;
};

/// Paints in the colours of a dark room or of a light one. Null, with the reason, where there is no OpenGL
/// to be had. Never touches GLFW.
std::unique_ptr<PicturePainter> make_offscreen_painter(bool dark, std::string& reason);

}  // namespace rigid
