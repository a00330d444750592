#pragma once

#include <memory>
#include <string>

#include "widgets/render/scene.h"

namespace rubble::figures {

/// Both panes of a run, drawn into a window off screen as the workbench draws them, captions left out, and not read back: for
/// measuring how fast a machine draws. The camera turns slowly, as that of somebody looking round. To be used from one thread.
class OffscreenView {
public:
    /// Opens the GL window and fits the cameras. Throws WorldError (remedy: an X display, or Xvfb) when no display answers.
    OffscreenView(const render::SceneData& data, int width, int height);
    ~OffscreenView();
    OffscreenView(const OffscreenView&) = delete;
    OffscreenView& operator=(const OffscreenView&) = delete;

    /// Draws the data as they are at a time [s] and waits until the picture is done.
    void draw(double time);
    /// What the last picture showed.
    const render::PaneStatus& status(render::PaneContent content) const;
    /// What draws, in words of the GL: "llvmpipe (LLVM 15.0.6, 256 bits)".
    std::string renderer() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace rubble::figures
