#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "bench/engine.h"
#include "bench/results.h"
#include "bench/scale.h"

// rubble-bench [options of the benchmark library]
// rubble-bench results FILE [--only NAME,NAME]: measures and writes the page of results
// rubble-bench engine write|run: what a run asks of its engine, run by engines alone
// rubble-bench scale [FOLDER [STATES]]: the table of sizes; results are kept in FOLDER, of the first STATES states
int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (!words.empty() && words.front() == "results") {
        return rubble::resultsPage({words.begin() + 1, words.end()});
    }
    if (!words.empty() && words.front() == "scale") {
        return rubble::scaleTable({words.begin() + 1, words.end()});
    }
    if (!words.empty() && words.front() == "engine") {
        return rubble::engineTable({words.begin() + 1, words.end()});
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 1;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
