// Playback of both views in one window of 1280 x 800 pixels: frames a second at the final state of the stone arch, with what
// leaving out hidden faces brings. Needs an X display (xvfb-run will do). Optional first argument: an FE file.

#include <benchmark/benchmark.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderWindow.h>
#include <vtk_glew.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

#include "core/base/memory.h"
#include "core/pipeline/pipeline.h"
#include "io/fe/fe_reader.h"
#include "io/run/run_file.h"
#include "tests/support/places.h"
#include "widgets/figures/draw.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/palette.h"
#include "widgets/render/basics/camera.h"
#include "widgets/render/basics/drawn_resolution.h"
#include "widgets/render/scene.h"

namespace {

using namespace rubble;

constexpr int width = 1280;
constexpr int height = 800;

/// The clustered run of the sample as its case has it: failing strips merged into their rings.
Scenario sampleScenario(const FeResult& fe) {
    Scenario scenario;
    const auto has = [&](const std::string& name) {
        for (const Part& part : fe.mesh().parts) {
            if (part.name == name) {
                return true;
            }
        }
        return false;
    };
    for (const std::string ring : {"arch ring 1", "arch ring 4"}) {
        if (has(ring) && has(ring + ", failing strip")) {
            scenario.regrouping.push_back(MergeComponents{{ring, ring + ", failing strip"}, ring});
        }
    }
    return scenario;
}

class Playback {
public:
    Playback(const std::string& fePath, const std::string& runPath) {
        const Execution execution;
        Inputs inputs;
        inputs.fe = io::openFe(fePath, {}, {}, execution);
        if (runPath.empty()) {
            auto trajectory = std::make_shared<MemoryTrajectory>();
            const Results results = run(inputs, sampleScenario(*inputs.fe), Stage::Simulation, {}, trajectory.get(), execution);
            show(inputs, results, results.fragments, results.clustering, trajectory);
        } else {
            const auto made = io::openRun(runPath);
            const Results results = run(inputs, made->origin().scenario, Stage::Components, {}, nullptr, execution);
            show(inputs, results, made->fragments(), made->clustering(), made);
        }
        m_window->SetOffScreenRendering(1);
        m_window->SetMultiSamples(0);
        m_window->SetSize(width, height);
        m_scene.attach(*m_window);
        m_scene.setData(m_data);
        m_scene.setColours(figures::sceneColours(render::Theme::Light));
        m_view = render::defaultView(m_data, width, height);
        m_window->Render();
        m_screen->SetContext(m_window);
        m_screen->PopulateFramebuffer(width, height);
    }
    ~Playback() {
        m_screen->ReleaseGraphicsResources(m_window);
        m_scene.detach();
    }

    double end() const { return m_data.trajectory->frameTime(m_data.trajectory->frameCount() - 1); }
    render::View& view() { return m_view; }
    render::Scene& scene() { return m_scene; }

    void setSimplified(bool simplified) {
        m_simplified = simplified;
        m_resolution = {};
    }
    /// Share of the pixels in each direction with which the next picture is drawn.
    double resolution() const { return m_simplified ? m_resolution.share() : 1.0; }

    /// Draws one picture as the window's views do, without their captions.
    void draw() {
        const auto begin = std::chrono::steady_clock::now();
        m_scene.setSimplified(m_simplified, resolution());
        m_scene.update(m_view, width, height);
        m_screen->Bind(GL_DRAW_FRAMEBUFFER);
        m_screen->ActivateDrawBuffer(0);
        render::drawWith(*m_window, width, height, resolution());
        m_window->WaitForCompletion();
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        if (m_simplified) {
            m_resolution.drew(took.count(), 1.0 / 24.0);
        }
    }

private:
    void show(const Inputs& inputs, const Results& results, std::shared_ptr<const FragmentSet> fragments,
              std::shared_ptr<const Clustering> clustering, std::shared_ptr<const TrajectoryReader> trajectory) {
        m_data.fe = inputs.fe;
        m_data.components = results.components;
        m_data.fragments = std::move(fragments);
        m_data.clustering = std::move(clustering);
        m_data.trajectory = std::move(trajectory);
    }

    vtkSmartPointer<vtkOpenGLRenderWindow> m_window =
        vtkSmartPointer<vtkOpenGLRenderWindow>::Take(vtkOpenGLRenderWindow::SafeDownCast(vtkRenderWindow::New()));
    vtkNew<vtkOpenGLFramebufferObject> m_screen;  ///< what the pictures end on, as on a widget
    bool m_simplified = false;
    render::DrawnResolution m_resolution;
    render::Scene m_scene;
    render::SceneData m_data;
    render::View m_view;
};

Playback* playback = nullptr;

/// Frames of five seconds of the collapse, as a player at 24 frames a second shows them.
constexpr int playedFrames = 120;

enum Motion { Still, Moving, Collapse };
enum Look { Plain, Cut, Presentation, Shaded, Simplified };
constexpr std::array lookNames{"", ", cut", ", presentation style", ", shaded edges", ", simplified"};

/// @param state  range 0: hidden faces drawn too; range 1: what moves; range 2: how it looks
void playBothViews(benchmark::State& state) {
    playback->scene().setAllFaces(state.range(0) != 0);
    playback->setSimplified(state.range(2) == Simplified);
    const render::View plain = playback->view();
    render::View& view = playback->view();
    if (state.range(2) == Cut) {
        view.clip = render::ClipPlane{playback->scene().bounds().center(), Vec3::UnitY()};
    }
    view.style = state.range(2) == Presentation ? render::Style::Presentation : render::Style::Analysis;
    view.shading = state.range(2) == Shaded;
    const double end = playback->end();
    const auto timeOf = [&](std::int64_t frame) {
        switch (state.range(1)) {
            case Moving:  // new points, nothing is born
                return end - 1.0 + 0.01 * static_cast<double>(frame % 90);
            case Collapse:  // new points, births and deaths, as a player at 24 frames a second
                return std::fmod(4.0 + static_cast<double>(frame) / 24.0, end);
            default:
                return end;
        }
    };
    const render::Camera home = playback->view().cameras[0];
    playback->view().time = timeOf(0);
    playback->draw();
    std::int64_t frame = 0;
    for (auto _ : state) {
        playback->view().time = timeOf(++frame);
        // A slow turn of the camera, as somebody looking round would make.
        playback->view().cameras[0] = render::orbit(home, 0.002 * static_cast<double>(frame % 50), 0.0);
        playback->draw();
    }
    playback->view() = plain;
    state.counters["resolution"] = playback->resolution();
    state.counters["frames_per_s"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    state.counters["triangles"] = static_cast<double>(playback->scene().status(render::PaneContent::Fe).faces +
                                                      playback->scene().status(render::PaneContent::Fragments).faces);
    state.SetLabel(std::string(state.range(0) ? "every face" : "visible faces") +
                   (state.range(1) == Still    ? ", static points"
                    : state.range(1) == Moving ? ", new points every frame"
                                               : ", playing from mid-collapse") +
                   lookNames[static_cast<std::size_t>(state.range(2))]);
}

BENCHMARK(playBothViews)
    ->Args({0, Still, Plain})
    ->Args({0, Moving, Plain})
    ->Args({1, Still, Plain})
    ->Args({1, Moving, Plain})
    ->Args({0, Still, Simplified})
    ->Args({0, Moving, Simplified})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->MinTime(2.0);

// As often as that, so that no state is met twice.
BENCHMARK(playBothViews)
    ->Args({0, Collapse, Plain})
    ->Args({0, Collapse, Cut})
    ->Args({0, Collapse, Presentation})
    ->Args({0, Collapse, Shaded})
    ->Args({0, Collapse, Simplified})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Iterations(playedFrames);

}  // namespace

int main(int argc, char** argv) {
    keepFreedMemory();
    benchmark::Initialize(&argc, argv);
    if (!figures::displayAvailable()) {
        std::fprintf(stderr, "playback_bench: no X display answers; run it under xvfb-run\n");
        return 1;
    }
    try {
        Playback made(argc > 1 ? argv[1] : sourcePath("resources/samples/stone-arch.exo"), argc > 2 ? argv[2] : "");
        playback = &made;
        benchmark::RunSpecifiedBenchmarks();
        playback = nullptr;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "playback_bench: %s\n", error.what());
        return 1;
    }
    return 0;
}
