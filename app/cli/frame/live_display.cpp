#include "app/cli/frame/live_display.h"

#include "widgets/figures/live_screen.h"

namespace rubble::cli {

ScreenMaker LiveDisplay::screenMaker() {
    return [this](const RunDescription& run, std::shared_ptr<const TrajectoryReader> trajectory) {
        if (!m_display) {
            m_display = std::make_unique<VirtualDisplay>();
        }
        return figures::liveScreen(run, std::move(trajectory), m_renderer);
    };
}

}  // namespace rubble::cli
