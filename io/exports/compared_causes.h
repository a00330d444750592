#pragma once

#include <string>

#include "core/evidence/report_facts.h"

namespace rubble::io {

/// Reads what `rubble-cli compare --json` printed. Throws WorldError naming a file that cannot be read, ParseError naming one that
/// is something else or damaged.
ReportCauses readComparedCauses(const std::string& path);

/// Findings of a comparison as one text, from which readComparedCauses() gets them back in any language.
std::string findingsOfCauses(const Findings& findings);

}  // namespace rubble::io
