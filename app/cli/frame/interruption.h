#pragma once

#include "core/base/execution.h"

namespace rubble::cli {

/// While it lives, the first SIGINT or SIGTERM cancels an execution; a second one ends the program at once. A
/// program that was told to end and then waits for three seconds without work ends too. One at a time.
class Interruption {
public:
    explicit Interruption(const Execution& execution);
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
};

}  // namespace rubble::cli
