// What the styles cost: every arrangement of figures and the page of a run, in both styles by turns in one run. Arguments: an FE
// file and a run of it. Needs an X display (xvfb-run will do); rows of the page need Chromium.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/pipeline/pipeline.h"
#include "io/exports/page/page_export.h"
#include "io/fe/fe_reader.h"
#include "io/run/run_file.h"
#include "tests/support/browser.h"
#include "tests/support/temporary_folder.h"
#include "widgets/figures/draw.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/figure_sheet.h"
#include "widgets/render/scene.h"

namespace {

using namespace rubble;

constexpr int turns = 3;
/// s of the run from its third on, while the page plays; most of a collapse is in the air then.
constexpr double playedFrom = 3.0;
constexpr double playedFor = 6.0;

struct Measured {
    std::shared_ptr<const FeResult> fe;
    std::shared_ptr<io::RunReader> run;
    render::SceneData data;
};
Measured* measured = nullptr;

Measured opened(const std::string& fePath, const std::string& runPath) {
    const Execution execution;
    Inputs inputs;
    inputs.fe = io::openFe(fePath, {}, {}, execution);
    Measured all{inputs.fe, io::openRun(runPath), {}};
    const Results results = run(inputs, all.run->origin().scenario, Stage::Components, {}, nullptr, execution);
    all.data.fe = all.fe;
    all.data.components = results.components;
    all.data.fragments = all.run->fragments();
    all.data.clustering = all.run->clustering();
    all.data.trajectory = all.run;
    return all;
}

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(std::max<std::size_t>(1, values.size()));
}

/// Two means, and the one over the other.
void report(benchmark::State& state, const char* unit, const std::array<std::vector<double>, 2>& values) {
    const double presentation = mean(values[0]);
    const double analysis = mean(values[1]);
    state.counters[std::string("presentation_") + unit] = presentation;
    state.counters[std::string("analysis_") + unit] = analysis;
    state.counters["ratio"] = presentation / analysis;
}

constexpr std::array styles{render::Style::Presentation, render::Style::Analysis};
constexpr std::array styleNames{"presentation", "analysis"};

void drawFigure(benchmark::State& state, figures::FigurePreset preset) {
    figures::FigureStyle style;
    style.pixels = figures::usualSize(preset);
    style.dpi = 200.0;
    figures::PresetRequest request;
    request.preset = preset;
    request.end = measured->run->frameTime(measured->run->frameCount() - 1);
    const render::View view = render::defaultView(measured->data, style.pixels.width(), style.pixels.width());
    std::array<std::vector<double>, 2> took;
    for (auto _ : state) {
        for (int turn = 0; turn < turns; ++turn) {
            for (std::size_t i = 0; i < styles.size(); ++i) {
                request.style = styles[i];
                // A studio of its own, as each figure has.
                figures::Studio studio(measured->data);
                const auto begin = std::chrono::steady_clock::now();
                benchmark::DoNotOptimize(studio.sheet(figures::presetSheet(request, view, measured->data), style).image());
                took[i].push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
            }
        }
    }
    report(state, "ms", took);
}

/// A page of the run in a browser that draws in software.
class OpenPage {
public:
    explicit OpenPage(int width = 1280, int height = 800) : m_browser(m_folder / "profile", width, height) {
        const std::string path = m_folder / "run.html";
        megabytes = 1e-6 * static_cast<double>(io::exportPage(path, *measured->run, *measured->fe, {}, Execution()).bytes);
        startSeconds = std::stod(m_browser.open(path)) / 1000.0;
        // What is unpacked when nothing else is to be done would be measured too.
        m_browser.waitFor("page.player.structure.unpacked >= page.player.structure.times.length");
    }
    Browser& browser() { return m_browser; }

    double megabytes = 0.0;
    double startSeconds = 0.0;

private:
    io::TemporaryFolder m_folder;
    Browser m_browser;
};

bool lacksBrowser(benchmark::State& state) {
    if (Browser::program().empty()) {
        state.SkipWithError("no Chromium here");
        return true;
    }
    return false;
}

/// Pictures at rest, in full.
void drawPage(benchmark::State& state, const std::string& look) {
    if (lacksBrowser(state)) {
        return;
    }
    std::array<std::vector<double>, 2> took;
    for (auto _ : state) {
        OpenPage page;
        page.browser().evaluate("page.jump(page.player.end), page.panels.lookFrom('" + look + "')");
        for (int turn = 0; turn < turns; ++turn) {
            for (std::size_t i = 0; i < styles.size(); ++i) {
                took[i].push_back(page.browser()
                                      .evaluate("(() => { const { player } = page; player.setStyle('" + std::string(styleNames[i]) +
                                                "'); player.renderer.finish(); const began = performance.now(); player.draw();"
                                                " player.renderer.finish(); return performance.now() - began; })()")
                                      .get<double>());
            }
        }
    }
    report(state, "ms", took);
}

void playPage(benchmark::State& state) {
    if (lacksBrowser(state)) {
        return;
    }
    std::array<std::vector<double>, 2> rates;
    for (auto _ : state) {
        OpenPage page;
        state.counters["page_MB"] = page.megabytes;
        state.counters["start_s"] = page.startSeconds;
        const double end = std::min(playedFrom + playedFor, page.browser().evaluate("page.player.end").get<double>());
        const double from = std::min(playedFrom, 0.5 * end);
        for (int turn = 0; turn < turns; ++turn) {
            for (std::size_t i = 0; i < styles.size(); ++i) {
                page.browser().evaluate("page.player.setStyle('" + std::string(styleNames[i]) + "'), page.jump(" +
                                        std::to_string(from) + "), page.player.play()");
                page.browser().waitFor("!page.player.playing || page.player.time >= " + std::to_string(end));
                rates[i].push_back(page.browser().evaluate("page.player.stop(), page.player.rate").get<double>());
            }
        }
    }
    report(state, "fps", rates);
}

void registerAll() {
    const auto once = [](benchmark::internal::Benchmark* row) { row->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1); };
    for (const auto& [name, preset] : figures::figurePresets) {
        once(benchmark::RegisterBenchmark(("figure " + std::string(name)).c_str(),
                                          [which = preset](benchmark::State& state) { drawFigure(state, which); }));
    }
    for (const std::string look : {"side", "top", "corner"}) {
        once(benchmark::RegisterBenchmark(("page at rest, " + look).c_str(),
                                          [look](benchmark::State& state) { drawPage(state, look); }));
    }
    once(benchmark::RegisterBenchmark("page played", playPage));
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (argc != 3) {
        std::fprintf(stderr, "style_bench FE RUN [options of the benchmark library]\n");
        return 2;
    }
    if (!figures::displayAvailable()) {
        std::fprintf(stderr, "style_bench: no X display answers; run it under xvfb-run\n");
        return 1;
    }
    try {
        figures::ensureGuiApplication();
        Measured all = opened(argv[1], argv[2]);
        measured = &all;
        registerAll();
        benchmark::RunSpecifiedBenchmarks();
        measured = nullptr;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "style_bench: %s\n", error.what());
        return 1;
    }
    return 0;
}
