#pragma once

#include <string>
#include <vector>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// Results of Salome and code_aster (.med, .rmed).
bool recognisesMed(const FileHead& head);
/// Reads one through libmed. Throws as openFe().
FeResult::Contents readMed(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
