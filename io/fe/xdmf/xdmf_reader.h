#pragma once

#include <string>
#include <vector>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// XML files whose root is Xdmf, and files of tables that one beside them names.
bool recognisesXdmf(const FileHead& head);
/// The text and the files of tables that it names, of which any may be given.
std::vector<std::string> xdmfMembers(const std::string& path);
/// Reads an unstructured grid or a temporal collection of them; see FeFormat::read.
FeResult::Contents readXdmf(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
