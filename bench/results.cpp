#include "bench/results.h"

#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "bench/measurements.h"
#include "bench/results_page.h"
#include "core/base/build.h"
#include "io/base/machine.h"
#include "tests/support/places.h"

namespace rubble {

namespace {

namespace fs = std::filesystem;
using bench::Measurement;

constexpr const char* resultsUsage =
    "rubble-bench results FILE [--only NAME,NAME]\n"
    "Measures and writes the page FILE (bench/RESULTS.md); nothing else should run meanwhile.\n"
    "--only NAMES  measures these alone; all other sections of FILE stay as they are\n"
    "--list        what there is, with the minutes that it takes on two cores\n";

struct Words {
    std::string file;
    std::vector<std::string> only;
    bool list = false;
};

std::string readFile(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs a command and returns what it prints. Throws std::runtime_error with the end of what it complains about if it fails.
std::string printedBy(const std::string& command, const fs::path& scratch) {
    const fs::path out = scratch / "stdout", complaints = scratch / "stderr";
    const int status = std::system(("( " + command + " ) >" + out.string() + " 2>" + complaints.string()).c_str());
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        const std::string said = readFile(complaints);
        throw std::runtime_error(command + " failed: " + said.substr(said.size() > 400 ? said.size() - 400 : 0));
    }
    return readFile(out);
}

/// The commit of the source tree, and whether anything but the page is changed beside it.
std::string commitText(const fs::path& scratch) {
    try {
        std::string commit = printedBy("git rev-parse --short=10 HEAD", scratch);
        commit.erase(commit.find_last_not_of('\n') + 1);
        const bool changed = !printedBy("git status --porcelain --untracked-files=no -- . ':!bench/RESULTS.md'", scratch).empty();
        return changed ? commit + " with changes" : commit;
    } catch (const std::runtime_error&) {
        return "unknown";
    }
}

std::string buildWords() {
#ifdef NDEBUG
    const std::string asserts = ", without asserts";
#else
    const std::string asserts = ", with asserts";
#endif
    return std::string(shortBuild(buildText())) + asserts;
}

std::string dateText() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &parts);
    return text.data();
}

bench::Section measure(const Measurement& measurement, const fs::path& scratch) {
    bench::Section section;
    section.title = measurement.title;
    section.about = measurement.about;
    section.circumstances.date = dateText();
    section.circumstances.machine = io::machineText();
    section.circumstances.commit = commitText(scratch);
    section.circumstances.build = buildWords();
    ::getloadavg(&section.circumstances.loadBefore, 1);
    const auto start = std::chrono::steady_clock::now();
    for (const bench::TableOrder& order : measurement.tables) {
        std::vector<std::string> outputs;
        for (const std::string& command : order.commands) {
            for (int k = 0; k < order.times; ++k) {
                outputs.push_back(printedBy(command, scratch));
            }
        }
        section.tables.push_back({order.commands, order.read(outputs)});
    }
    section.circumstances.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return section;
}

/// What stands before the sections: how the page is made, and what is measured by name only.
std::string openingText() {
    std::string names;
    for (const Measurement& measurement : bench::measurements()) {
        if (measurement.onlyByName) {
            names += (names.empty() ? "`" : ", `") + measurement.name + "`";
        }
    }
    return "# Measured speed and accuracy\n\n"
           "`rubble-bench results bench/RESULTS.md` writes this page. Each section says when, where and on which commit it was "
           "measured.\n"
           "Commands run at the root of the source tree, with `build/release/bin` on the path and a temporary folder in `TMPDIR`.\n"
           "What takes long is measured only where `--only` names it: " +
           names +
           ".\nWhat was tried, with the measurements behind it, stands in [docs/solver.md](../docs/solver.md#tried) and "
           "[docs/clusters.md](../docs/clusters.md#tried).\n";
}

/// Returns what is wrong with the words; nothing if they are understood.
std::string readResultsWords(const std::vector<std::string>& given, Words& words) {
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i] == "--list") {
            words.list = true;
        } else if (given[i] == "--only" && i + 1 < given.size()) {
            std::istringstream names(given[++i]);
            for (std::string name; std::getline(names, name, ',');) {
                words.only.push_back(name);
            }
        } else if (given[i].starts_with("-") || !words.file.empty()) {
            return "\"" + given[i] + "\" is not understood";
        } else {
            words.file = given[i];
        }
    }
    const std::vector<Measurement>& all = bench::measurements();
    for (const std::string& name : words.only) {
        if (std::none_of(all.begin(), all.end(), [&](const Measurement& one) { return one.name == name; })) {
            return "there is no measurement \"" + name + "\"; see --list";
        }
    }
    return words.file.empty() && !words.list ? "FILE is missing" : "";
}

void printList() {
    for (const Measurement& measurement : bench::measurements()) {
        std::printf("%-20s %5.1f min  %s%s\n", measurement.name.c_str(), measurement.minutes, measurement.title.c_str(),
                    measurement.onlyByName ? " (by name only)" : "");
    }
}

bool isAsked(const Measurement& measurement, const Words& words) {
    if (words.only.empty()) {
        return !measurement.onlyByName;
    }
    return std::find(words.only.begin(), words.only.end(), measurement.name) != words.only.end();
}

/// A folder of its own, which goes with everything that the commands leave in it.
class Scratch {
public:
    Scratch() {
        std::string pattern = (fs::temp_directory_path() / "rubble-results-XXXXXX").string();
        if (!::mkdtemp(pattern.data())) {
            throw std::runtime_error("no temporary folder can be made");
        }
        m_path = pattern;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    const fs::path& path() const { return m_path; }

private:
    fs::path m_path;
};

/// Programs of this build first, and nothing kept of earlier runs: neither worlds nor their times.
void setSurroundings(const fs::path& scratch) {
    const fs::path programs = fs::read_symlink("/proc/self/exe").parent_path();
    const char* path = ::getenv("PATH");
    ::setenv("PATH", (programs.string() + (path ? ":" + std::string(path) : "")).c_str(), 1);
    ::setenv("TMPDIR", scratch.c_str(), 1);
    ::setenv("RUBBLE_CACHE", (scratch / "cache").c_str(), 1);
    ::setenv("RUBBLE_STATE", (scratch / "state").c_str(), 1);
    fs::current_path(sourcePath());
}

/// Measures what is asked for and writes the page after each, so that a failure later on loses nothing.
int measureAll(const Words& words) {
    const fs::path file = fs::absolute(words.file);
    const Scratch scratch;
    setSurroundings(scratch.path());
    std::vector<std::string> titles;
    for (const Measurement& measurement : bench::measurements()) {
        titles.push_back(measurement.title);
    }
    int code = 0;
    for (const Measurement& measurement : bench::measurements()) {
        if (!isAsked(measurement, words)) {
            continue;
        }
        std::fprintf(stderr, "%s, about %.1f min\n", measurement.name.c_str(), measurement.minutes);
        try {
            const bench::Section section = measure(measurement, scratch.path());
            const std::string page = bench::pageWith(readFile(file), openingText(), {section}, titles);
            std::ofstream(file, std::ios::binary) << page;
        } catch (const std::exception& error) {
            std::fprintf(stderr, "results: %s: %s\n", measurement.name.c_str(), error.what());
            code = 1;
        }
    }
    return code;
}

}  // namespace

int resultsPage(const std::vector<std::string>& given) {
    if (!given.empty() && (given[0] == "--help" || given[0] == "-h")) {
        std::printf("%s", resultsUsage);
        return 0;
    }
    Words words;
    if (const std::string wrong = readResultsWords(given, words); !wrong.empty()) {
        std::fprintf(stderr, "results: %s\n%s", wrong.c_str(), resultsUsage);
        return 2;
    }
    if (words.list) {
        printList();
        return 0;
    }
    try {
        return measureAll(words);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "results: %s\n", error.what());
        return 1;
    }
}

}  // namespace rubble
