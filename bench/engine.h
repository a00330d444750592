#pragma once

#include <string>
#include <vector>

namespace rubble {

/// rubble-bench engine: writes what a run asks of its engine, and runs that by engines alone. Returns the exit code.
int engineTable(const std::vector<std::string>& words);

}  // namespace rubble
