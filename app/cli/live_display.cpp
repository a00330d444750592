#include "app/cli/live_display.h"

#include "widgets/figures/offscreen_view.h"

namespace rubble::cli {

namespace {

constexpr int width = 1280;
constexpr int height = 800;

/// Both views of one run.
class OffscreenScreen : public LiveScreen {
public:
    OffscreenScreen(const render::SceneData& data, std::string& renderer) : m_view(data, width, height), m_renderer(renderer) {}
    void draw(double time) override {
        m_view.draw(time);
        if (m_renderer.empty()) {
            m_renderer = m_view.renderer();
        }
    }

private:
    figures::OffscreenView m_view;
    std::string& m_renderer;
};

}  // namespace

ScreenMaker LiveDisplay::screenMaker() {
    return [this](const RunDescription& run, std::shared_ptr<const TrajectoryReader> trajectory) -> std::unique_ptr<LiveScreen> {
        if (!m_display) {
            m_display = std::make_unique<VirtualDisplay>();
        }
        render::SceneData data;
        data.fe = run.fe;
        data.components = run.components;
        data.fragments = run.fragments;
        data.clustering = run.clustering;
        data.trajectory = std::move(trajectory);
        data.setSurroundings(run.scenario, run.terrain, nullptr);
        return std::make_unique<OffscreenScreen>(data, m_renderer);
    };
}

}  // namespace rubble::cli
