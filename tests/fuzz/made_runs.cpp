#include <cstdlib>

#include "io/run/run_file.h"
#include "io/seal/run_repeat.h"

namespace rubble::io {

// Stand in for what reads runs and repeats them, which no fuzzer does.
std::shared_ptr<RunReader> openRun(const std::string&, std::size_t) {
    std::abort();
}

void checkRunDigest(const std::string&, const Execution&) {
    std::abort();
}

Inputs openRunInputs(const RunOrigin&, Findings&, Findings&, const Execution&) {
    std::abort();
}

RunRepeat repeatRun(const RunReader&, const Inputs&, const Execution&) {
    std::abort();
}

}  // namespace rubble::io
