#include "bench/engine.h"

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "bench/engine_run.h"
#include "bench/engine_scene.h"
#include "bench/no_sink.h"
#include "core/base/build.h"
#include "core/pipeline/pipeline.h"
#include "core/simulation/run/collapse_run.h"
#include "io/base/machine.h"
#include "io/case/open_case.h"

namespace rubble {

namespace {

using bench::EngineMeasure;
using bench::EngineScene;

constexpr const char* usage =
    "rubble-bench engine write CASE SCENE [--set KEY=VALUE]...\n"
    "  simulates a scenario of CASE and writes what its engine was asked: bodies with time and motion, pieces, steps\n"
    "rubble-bench engine run SCENE... [--no-pieces] [--rates N,N] [--substeps N,N] [--threads N,N] [--solvers NAME,NAME] "
    "[--repeats N]\n"
    "  runs scenes by an engine alone, a line for each choice: time, contacts, and quality by one code for all engines\n"
    "  --no-pieces     without the moving structure\n"
    "  --rates N,N     equal steps, at least so many a second; without it those of the run that was written\n"
    "  --substeps N,N  without it those of the run\n"
    "  --threads N,N   without it all of the machine\n"
    "  --solvers N,N   soft-step, bullet, plain (Bullet as it comes); without it soft-step\n"
    "  --repeats N     runs each so many times, in turns; the hash of the end tells equal bits\n";

std::vector<std::string> parts(const std::string& text) {
    std::vector<std::string> all;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        all.push_back(text.substr(from, comma - from));
        from = comma + 1;
    }
    return all;
}

std::vector<double> numbers(const std::string& option, const std::string& text, double least) {
    std::vector<double> all;
    for (const std::string& part : parts(text)) {
        double number = 0.0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
        if (error != std::errc{} || end != part.data() + part.size() || !(number >= least)) {
            throw std::invalid_argument(option + " takes numbers from " + std::to_string(static_cast<int>(least)) + " on, not \"" +
                                        part + "\"");
        }
        all.push_back(number);
    }
    return all;
}

/// What is asked of an engine.
struct Wanted {
    std::vector<std::string> scenes;
    bool pieces = true;
    std::vector<std::optional<double>> rates{std::nullopt};
    std::vector<std::optional<int>> substeps{std::nullopt};
    std::vector<int> threads{Execution().threads()};
    std::vector<std::string> solvers{"soft-step"};
    int repeats = 1;
};

bench::EngineFactory factoryOf(const std::string& solver) {
    if (solver == "soft-step") {
        return [](const WorldSettings& settings) { return makeWorld(SolverKind::SoftStep, settings); };
    }
    if (solver == "bullet") {
        return [](const WorldSettings& settings) { return makeWorld(SolverKind::Bullet, settings); };
    }
    if (solver == "plain") {
        return makePlainBulletWorld;
    }
    throw std::invalid_argument("--solvers takes soft-step, bullet and plain, not \"" + solver + "\"");
}

Wanted wantedOf(const std::vector<std::string>& words) {
    Wanted wanted;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word == "--no-pieces") {
            wanted.pieces = false;
            continue;
        }
        if (!word.starts_with("--")) {
            wanted.scenes.push_back(word);
            continue;
        }
        if (++i == words.size()) {
            throw std::invalid_argument(word + " takes a value");
        }
        if (word == "--rates") {
            const std::vector<double> rates = numbers(word, words[i], 1.0);
            wanted.rates.assign(rates.begin(), rates.end());
        } else if (word == "--substeps") {
            wanted.substeps.clear();
            for (const double n : numbers(word, words[i], 1.0)) {
                wanted.substeps.emplace_back(static_cast<int>(n));
            }
        } else if (word == "--threads") {
            wanted.threads.clear();
            for (const double n : numbers(word, words[i], 1.0)) {
                wanted.threads.push_back(static_cast<int>(n));
            }
        } else if (word == "--solvers") {
            wanted.solvers = parts(words[i]);
            for (const std::string& solver : wanted.solvers) {
                factoryOf(solver);
            }
        } else if (word == "--repeats") {
            wanted.repeats = static_cast<int>(numbers(word, words[i], 1.0).front());
        } else {
            throw std::invalid_argument("there is no option " + word);
        }
    }
    if (wanted.scenes.empty()) {
        throw std::invalid_argument("no scene is named");
    }
    return wanted;
}

void printHead() {
    std::printf("%-18s %-9s %7s %5s %3s %8s %7s %8s %8s %9s %8s %6s %6s %6s %8s %7s %7s %7s %7s  %s\n", "scene", "solver", "bodies",
                "steps", "thr", "ms/step", "s/s", "cpu born", "cpu all", "pts mean", "pts peak", "fast", "thrown", ">5 %",
                "deepest", "p99 m", "height", "spread", "asleep", "end");
}

void print(const std::string& scene, const std::string& solver, int threads, const EngineMeasure& m) {
    std::printf(
        "%-18s %-9s %7lld %5lld %3d %8.2f %7.3f %8.2f %8.2f %9.0f %8lld %6lld %6lld %6lld %8.3f %7.4f %7.3f %7.2f %7.3f  %s\n",
        scene.c_str(), solver.c_str(), static_cast<long long>(m.bodies), static_cast<long long>(m.steps), threads,
        1e3 * m.birthWallSeconds / static_cast<double>(std::max<std::int64_t>(1, m.birthSteps)),
        m.birthWallSeconds / std::max(1e-9, m.birthSeconds), m.birthProcessorSeconds, m.processorSeconds, m.pointsMean,
        static_cast<long long>(m.pointsPeak), static_cast<long long>(m.tooFast), static_cast<long long>(m.thrown),
        static_cast<long long>(m.overlap.beyondFive), m.overlap.deepest, m.overlap.p99, m.meanHeight, m.spread, m.asleep,
        m.end.hex().substr(0, 12).c_str());
    std::fflush(stdout);
}

void runScenes(const Wanted& wanted) {
    const bench::ContactBytes bytes = bench::contactBytes();
    std::printf("%s; %s\n", io::machineText().c_str(), std::string(buildText()).c_str());
    std::printf(
        "Bytes of a contact of four points: %zu (found %zu, kept twice %zu, record %zu, solving %zu, tally %zu, correction %zu)\n",
        bytes.all(), bytes.found, bytes.kept, bytes.record, bytes.solving, bytes.tally, bytes.correction);
    std::printf(
        "ms/step, s/s (seconds a simulated second) and \"cpu born\" (seconds of the processors) from first to last birth; points "
        "in\n"
        "contact; bodies ever over 3 %% faster than birth and fall allow, and risen faster than 3 m/s; at the end bodies more "
        "than\n"
        "5 %% of a side in others, the deepest and the 99th percentile in m; mean height and spread of 95 %% of the mass, m.\n");
    printHead();
    for (int repeat = 0; repeat < wanted.repeats; ++repeat) {
        for (const std::string& name : wanted.scenes) {
            const EngineScene read = bench::readScene(name);
            const EngineScene written = wanted.pieces ? read : read.withoutPieces();
            for (const auto& rate : wanted.rates) {
                const EngineScene stepped = rate ? written.inSteps(*rate) : written;
                for (const auto& substeps : wanted.substeps) {
                    EngineScene scene = substeps ? stepped.inSubsteps(*substeps) : stepped;
                    for (const int threads : wanted.threads) {
                        scene.settings.threads = threads;
                        for (const std::string& solver : wanted.solvers) {
                            print(std::filesystem::path(name).stem().string(), solver, threads,
                                  bench::measureEngine(scene, factoryOf(solver)));
                        }
                    }
                }
            }
        }
    }
}

void writeSceneOf(const std::vector<std::string>& words) {
    io::CaseRequest request;
    std::vector<std::string> files;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--set") {
            const std::string setting = i + 1 < words.size() ? words[++i] : std::string();
            const std::size_t equals = setting.find('=');
            if (equals == std::string::npos) {
                throw std::invalid_argument("--set takes KEY=VALUE");
            }
            request.settings.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
        } else if (words[i].starts_with("--")) {
            throw std::invalid_argument("there is no option " + words[i]);
        } else {
            files.push_back(words[i]);
        }
    }
    if (files.size() != 2) {
        throw std::invalid_argument("a case and the scene to write are taken");
    }
    request.path = files[0];
    const Execution execution;
    const io::OpenedCase opened = io::openCase(request, execution);
    const Results results = run(opened.inputs, opened.scenario, Stage::Clusters, {}, nullptr, execution);
    EngineScene scene;
    NoSink sink;
    const SolverKind solver = opened.scenario.simulation.solver;
    const SimulationResult result = simulateIn(
        [&](const WorldSettings& settings) {
            return std::make_unique<bench::SceneRecorder>(makeWorld(solver, settings), settings, scene);
        },
        describeRun(opened.inputs, opened.scenario, results), sink, execution);
    bench::writeScene(scene, files[1]);
    std::printf("%s: %zu calls, %.3f s in %lld steps, %lld bodies at most\n", files[1].c_str(), scene.calls.size(), scene.seconds(),
                static_cast<long long>(result.steps), static_cast<long long>(result.bodiesPeak));
}

}  // namespace

int engineTable(const std::vector<std::string>& words) {
    const std::string what = words.empty() ? std::string() : words.front();
    const std::vector<std::string> rest(words.begin() + (words.empty() ? 0 : 1), words.end());
    try {
        if (what == "write") {
            writeSceneOf(rest);
        } else if (what == "run") {
            runScenes(wantedOf(rest));
        } else {
            const bool asked = what == "--help" || what == "-h";
            std::fprintf(asked ? stdout : stderr, "%s", usage);
            return asked ? 0 : 2;
        }
        return 0;
    } catch (const std::invalid_argument& wrong) {
        std::fprintf(stderr, "engine: %s\n%s", wrong.what(), usage);
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "engine: %s\n", error.what());
        return 1;
    }
}

}  // namespace rubble
