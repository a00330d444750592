#include "widgets/figures/live_screen.h"

#include "widgets/figures/offscreen_view.h"

namespace rubble::figures {

namespace {

constexpr int screenWidth = 1280;
constexpr int screenHeight = 800;

/// Both views of one run.
class OffscreenScreen : public LiveScreen {
public:
    OffscreenScreen(const render::SceneData& data, std::string& renderer)
        : m_view(data, screenWidth, screenHeight), m_renderer(renderer) {}
    void draw(double time) override {
        m_view.draw(time);
        if (m_renderer.empty()) {
            m_renderer = m_view.renderer();
        }
    }

private:
    OffscreenView m_view;
    std::string& m_renderer;
};

}  // namespace

std::unique_ptr<LiveScreen> liveScreen(const RunDescription& run, std::shared_ptr<const TrajectoryReader> trajectory,
                                       std::string& renderer) {
    render::SceneData data;
    data.fe = run.fe;
    data.components = run.components;
    data.fragments = run.fragments;
    data.clustering = run.clustering;
    data.trajectory = std::move(trajectory);
    data.setSurroundings(run.scenario, run.terrain, nullptr);
    return std::make_unique<OffscreenScreen>(data, renderer);
}

}  // namespace rubble::figures
