// rubble-bits [--whole] [--solver NAME] [--threads N] [CASE...]: a line for each case of the self-test, with the hash of all that
// moved in it. Programs of other compilers, flags and processors print the same lines (compare.py).

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/selftest/suite.h"

using namespace rubble;

int main(int count, char** words) {
    selftest::SuiteSettings settings;
    settings.small = true;
    settings.hashes = true;
    std::vector<std::string> ids;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--whole") {
            settings.small = false;
        } else if (word == "--bullet") {
            settings.solver = SolverKind::Bullet;
        } else if (word == "--threads" && i + 1 < count) {
            settings.threads = std::max(1, std::atoi(words[++i]));
        } else {
            ids.push_back(word);
        }
    }
    try {
        const auto results = selftest::runSuite(selftest::chosenCases(ids), settings, Execution());
        for (const selftest::CaseResult& result : results) {
            const std::string said = !result.error.empty() ? result.error : result.pass() ? "held" : "not held";
            std::printf("%s %s %s\n", std::string(result.hardCase->id).c_str(), result.trajectories.hex().c_str(), said.c_str());
        }
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rubble-bits: %s\n", error.what());
        return 2;
    }
}
