#include "bench/scale.h"

#include <sys/wait.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>

#include "bench/refined_result.h"
#include "core/base/build.h"
#include "core/base/memory.h"
#include "core/pipeline/pipeline.h"
#include "core/trajectory/sink_relay.h"
#include "io/base/machine.h"
#include "io/fe/fe_copy/copy_writer.h"
#include "io/fe/fe_reader.h"
#include "io/run/run_file.h"
#include "tests/support/places.h"

namespace rubble {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A line of /proc/self/status, MiB.
double statusMiB(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(name + ":")) {
            return std::stod(line.substr(name.size() + 1)) / 1024.0;
        }
    }
    return 0.0;
}

/// Time of a stage and the most memory that the process had in it.
class StageMeter {
public:
    explicit StageMeter(std::string folder) : m_folder(std::move(folder)) {}

    void measure(const std::string& stage, const std::function<void()>& act) {
        {
            std::ofstream("/proc/self/clear_refs") << "5";
        }
        const auto start = Clock::now();
        act();
        note(stage, secondsSince(start));
    }
    void note(const std::string& stage, double seconds) {
        std::ofstream(m_folder + "/stages", std::ios::app) << stage << '\t' << seconds << '\t' << statusMiB("VmHWM") << '\n';
    }

private:
    std::string m_folder;
};

/// Tells how long what it hands on took.
class TimedSink : public SinkRelay {
public:
    using SinkRelay::SinkRelay;
    void begin(const RunDescription& description) override {
        timed([&] { SinkRelay::begin(description); });
    }
    void addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) override {
        timed([&] { SinkRelay::addBodies(bodies, carriers); });
    }
    void commit(const TrajectoryFrame& frame) override {
        timed([&] { SinkRelay::commit(frame); });
    }
    void finish(const SimulationResult& result) override {
        timed([&] { SinkRelay::finish(result); });
    }
    double seconds = 0.0;

private:
    template <class Act>
    void timed(Act act) {
        const auto start = Clock::now();
        act();
        seconds += secondsSince(start);
    }
};

/// The sample's own settings: failing strips merged into their rings.
Scenario sampleScenario() {
    Scenario scenario;
    for (const std::string ring : {"arch ring 1", "arch ring 4"}) {
        scenario.regrouping.push_back(MergeComponents{{ring, ring + ", failing strip"}, ring});
    }
    scenario.simulation.settleTime = 0.0;
    return scenario;
}

io::RunOrigin originOf(const Inputs& inputs, const Scenario& scenario) {
    io::RunOrigin origin;
    origin.fePath = inputs.fe->contents().path;
    origin.feSha256 = inputs.fe->contents().sha256;
    origin.frame = inputs.frame;
    origin.scenario = scenario;
    origin.scenarioName = "As computed";
    origin.build = std::string(buildText());
    origin.fingerprint = stageKey(inputs, scenario, Stage::Simulation);
    return origin;
}

/// One size, in a process of its own: makes the result and forgets it, then goes through the stages from the file.
void makeResult(const std::string& folder, std::array<int, 3> split, std::size_t states) {
    const Execution execution;
    const auto coarse = io::openFe(sourcePath("resources/samples/stone-arch.exo"), {}, {}, execution);
    io::writeFeCopy(folder + "/arch.h5", *refinedResult(coarse, split, states), Vec3::Zero(), execution);
}

void goThrough(const std::string& folder) {
    const Execution execution;
    StageMeter meter(folder);
    Inputs inputs;
    const auto open = [&] {
        inputs.fe = io::openFe(folder + "/arch.h5", {}, {}, execution);
        inputs.frame = inputs.fe->contents().frame;
    };
    meter.measure("opening", open);
    meter.measure("reading all states", [&] {
        for (std::size_t k = 0; k < inputs.fe->stateCount(); ++k) {
            inputs.fe->state(k);
        }
    });
    const Scenario scenario = sampleScenario();
    Results results;
    const auto stage = [&](const char* name, Stage last) {
        meter.measure(name, [&] { results = run(inputs, scenario, last, results, nullptr, execution); });
    };
    stage("components", Stage::Components);
    // Opened anew where states are read: a small result would find them in memory, a large one would not.
    open();
    stage("fragments", Stage::Fragments);
    stage("sizing", Stage::Sizing);
    stage("clustering", Stage::Clusters);
    const std::string path = folder + "/arch.run.h5";
    double recording = 0.0;
    open();
    meter.measure("clustered run with recording", [&] {
        const auto start = Clock::now();
        {
            const std::unique_ptr<TrajectorySink> writer = io::createRun(path, originOf(inputs, scenario));
            TimedSink sink(writer.get());
            results = run(inputs, scenario, Stage::Simulation, results, &sink, execution);
            recording = sink.seconds - secondsSince(start);
        }
        // What is left when the last frame was handed over is written at the end.
        recording += secondsSince(start);
    });
    meter.note("of it recording", recording);
    meter.measure("playback of all frames", [&] {
        const auto trajectory = io::openRun(path);
        for (std::size_t k = 0; k < trajectory->frameCount(); ++k) {
            trajectory->frame(k);
        }
    });
    std::ofstream(folder + "/counts") << inputs.fe->mesh().elementCount() << ' ' << results.fragments->size() << ' '
                                      << results.clustering->list.size() << ' ' << inputs.fe->stateCount() << ' '
                                      << inputs.fe->times().back() << ' ' << fs::file_size(folder + "/arch.h5") << '\n';
}

/// Runs an act in a child, whose memory goes with it. Returns true if it came to its end.
bool inChild(const std::function<void()>& act) {
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        int code = 0;
        try {
            keepFreedMemory();
            act();
        } catch (const std::exception& error) {
            std::fprintf(stderr, "scale: %s\n", error.what());
            code = 1;
        }
        std::fflush(nullptr);
        ::_exit(code);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

constexpr const char* scaleUsage =
    "rubble-bench scale [FOLDER [STATES]]\n"
    "Time and memory of every stage with the stone arch at 1, 3 and 10 times its elements.\n"
    "FOLDER  keeps the results between runs (about 2 GB; by itself in the temporary folder)\n"
    "STATES  takes the first so many of the 122 states, at least 2\n";

/// Returns what is wrong with the words; nothing if they are understood.
std::string readWords(const std::vector<std::string>& words, std::string& root, std::size_t& states) {
    for (const std::string& word : words) {
        if (word.starts_with("-")) {
            return "There is no option " + word;
        }
    }
    if (words.size() > 2) {
        return "A folder and a number of states are taken, \"" + words[2] + "\" is one word too many";
    }
    if (!words.empty()) {
        root = words[0];
    }
    if (words.size() > 1) {
        const std::string& text = words[1];
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), states);
        if (error != std::errc() || end != text.data() + text.size() || states < 2) {
            return "STATES is \"" + text + "\"; give a whole number, at least 2";
        }
    }
    return {};
}

struct Measured {
    std::string stage;
    double seconds = 0.0;
    double mebibytes = 0.0;
};

std::vector<Measured> readStages(const std::string& folder) {
    std::vector<Measured> stages;
    std::ifstream in(folder + "/stages");
    for (std::string line; std::getline(in, line);) {
        const std::size_t first = line.find('\t');
        const std::size_t second = line.find('\t', first + 1);
        stages.push_back({line.substr(0, first), std::stod(line.substr(first + 1)), std::stod(line.substr(second + 1))});
    }
    return stages;
}

}  // namespace

int scaleTable(const std::vector<std::string>& words) {
    if (!words.empty() && (words[0] == "--help" || words[0] == "-h")) {
        std::printf("%s", scaleUsage);
        return 0;
    }
    std::string root = (fs::temp_directory_path() / "rubble-scale").string();
    std::size_t states = 1000;
    if (const std::string wrong = readWords(words, root, states); !wrong.empty()) {
        std::fprintf(stderr, "scale: %s\n%s", wrong.c_str(), scaleUsage);
        return 2;
    }
    const std::vector<std::pair<int, std::array<int, 3>>> sizes{{1, {1, 1, 1}}, {3, {3, 1, 1}}, {10, {5, 2, 1}}};
    std::printf("Stone arch, every brick split in 1, 3 and 10; deaths inherited, half of them one or two states earlier; %s\n",
                io::machineText().c_str());
    std::vector<std::vector<Measured>> all;
    for (const auto& [factor, split] : sizes) {
        const std::string folder = root + "/" + std::to_string(factor) + "x";
        fs::create_directories(folder);
        fs::remove(folder + "/stages");
        if (!fs::exists(folder + "/arch.h5") && !inChild([&, split = split] { makeResult(folder, split, states); })) {
            fs::remove(folder + "/arch.h5");
            return 1;
        }
        if (!inChild([&] { goThrough(folder); })) {
            return 1;
        }
        all.push_back(readStages(folder));
        std::string counts;
        std::getline(std::ifstream(folder + "/counts"), counts);
        std::printf("%2dx: elements, fragments, clusters, states, FE end s, bytes: %s\n", factor, counts.c_str());
        std::fflush(stdout);
    }
    std::printf("%-30s %9s %9s %9s %7s %9s %9s %9s\n", "stage", "1x s", "3x s", "10x s", "10x/1x", "1x MiB", "3x MiB", "10x MiB");
    for (std::size_t i = 0; i < all[0].size(); ++i) {
        std::printf("%-30s %9.3f %9.3f %9.3f %7.1f %9.0f %9.0f %9.0f\n", all[0][i].stage.c_str(), all[0][i].seconds,
                    all[1][i].seconds, all[2][i].seconds, all[2][i].seconds / all[0][i].seconds, all[0][i].mebibytes,
                    all[1][i].mebibytes, all[2][i].mebibytes);
    }
    return 0;
}

}  // namespace rubble
