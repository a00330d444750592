#pragma once

#include <string>

#include "core/evidence/report_facts.h"

namespace rubble::io {

/// Reads what only the author of a report can say: plain text (UTF-8) in which lines "# custody", "# alternatives", "# change",
/// "# summary" and "# qualification" begin its parts, in any order, each at most once. Throws WorldError naming a file that cannot
/// be read, ParseError naming the line for another heading, one that comes twice, an empty part, and text before the first.
OwnWords readOwnWords(const std::string& path);

}  // namespace rubble::io
