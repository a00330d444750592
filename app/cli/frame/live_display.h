#pragma once

#include <memory>
#include <string>

#include "app/cli/frame/virtual_display.h"
#include "core/analysis/accuracy/live_cost.h"

namespace rubble::cli {

/// The display that live FPS are measured on: 1280 x 800 pixels off screen, both views. Starts a virtual display where none
/// answers, when the first run is drawn, and keeps it. Must outlive the screens it makes.
class LiveDisplay {
public:
    /// What a measurement takes to draw with. Its screens throw WorldError where no display can be made.
    ScreenMaker screenMaker();
    /// What drew last, in words; empty if nothing did.
    const std::string& renderer() const { return m_renderer; }

private:
    std::unique_ptr<VirtualDisplay> m_display;
    std::string m_renderer;
};

}  // namespace rubble::cli
