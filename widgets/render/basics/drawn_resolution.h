#pragma once

#include <array>

class vtkOpenGLRenderWindow;

namespace rubble::render {

/// How many pixels a picture that moves is drawn with, settled from how long the last ones took: a fast machine keeps all of them.
class DrawnResolution {
public:
    /// Share of the pixels in each direction: 1, 0.7 or 0.5.
    double share() const { return steps[m_step]; }
    /// A picture was drawn with that share. It becomes smaller after two pictures in a row that took longer than `limit`, s, and
    /// larger again when the pictures would keep well within it even if every pixel took its part of the time.
    void drew(double seconds, double limit);

    static constexpr std::array steps{1.0, 0.7, 0.5};

private:
    std::size_t m_step = 0;
    double m_before = 0.0;  ///< s, the last picture; 0: none with this share
};

/// Draws a window's renderers with a share of the pixels in each direction and brings the picture in its full size, in device
/// pixels, onto the framebuffer that is bound for drawing. To be called where the window's context is current.
void drawWith(vtkOpenGLRenderWindow& window, int width, int height, double share);

}  // namespace rubble::render
