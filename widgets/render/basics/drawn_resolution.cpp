#include "widgets/render/basics/drawn_resolution.h"

#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cmath>

namespace rubble::render {

void DrawnResolution::drew(double seconds, double limit) {
    // What the picture still has to go through before it is seen.
    constexpr double room = 0.8;
    const double faster = m_before > 0.0 ? std::min(seconds, m_before) : 0.0;
    const double slower = m_before > 0.0 ? std::max(seconds, m_before) : 0.0;
    m_before = seconds;
    if (faster > room * limit && m_step + 1 < steps.size()) {
        ++m_step;
        m_before = 0.0;
    } else if (m_step > 0 && slower > 0.0) {
        const double larger = steps[m_step - 1] / steps[m_step];
        if (slower * larger * larger < 0.9 * room * limit) {
            --m_step;
            m_before = 0.0;
        }
    }
}

void drawWith(vtkOpenGLRenderWindow& window, int width, int height, double share) {
    const auto drawn = [share](int pixels) { return std::max(1, static_cast<int>(std::lround(share * pixels))); };
    const int drawnWidth = drawn(width), drawnHeight = drawn(height);
    window.SetSize(drawnWidth, drawnHeight);
    // Else VTK copies the picture, with its depths, to a buffer of its own first.
    window.SwapBuffersOff();
    window.Render();
    vtkOpenGLState& state = *window.GetState();
    const vtkOpenGLState::ScopedglEnableDisable scissor(&state, GL_SCISSOR_TEST);
    state.vtkglDisable(GL_SCISSOR_TEST);
    state.PushReadFramebufferBinding();
    window.GetRenderFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    window.GetRenderFramebuffer()->ActivateReadBuffer(0);
    const bool scaled = drawnWidth != width || drawnHeight != height;
    state.vtkglBlitFramebuffer(0, 0, drawnWidth, drawnHeight, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                               scaled ? GL_LINEAR : GL_NEAREST);
    state.PopReadFramebufferBinding();
}

}  // namespace rubble::render
