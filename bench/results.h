#pragma once

#include <string>
#include <vector>

namespace rubble {

/// "rubble-bench results FILE": measures, and writes what came out into a page in Markdown. Sections that are not measured stay as
/// they are. Returns the exit code: 1 if a command failed, whose section then stays as well, 2 for words that are not understood.
int resultsPage(const std::vector<std::string>& words);

}  // namespace rubble
