#pragma once

#include <string>
#include <vector>

namespace rubble {

/// "rubble-bench scale": time and memory of every stage on the stone arch as it is and with its bricks split in three and ten. Each
/// size has a process of its own. Returns the exit code.
int scaleTable(const std::vector<std::string>& words);

}  // namespace rubble
