#pragma once

#include <string>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// Formatted post files of MSC Marc (.t19), revision 9 and later.
bool recognisesMarc(const FileHead& head);
/// Reads a post file: elements that a rewritten mesh leaves out are dead; where no mesh is rewritten, those whose stress falls to
/// exactly zero. See FeFormat::read.
FeResult::Contents readMarc(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
