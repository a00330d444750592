#pragma once

#include "io/fe/fe_format.h"

namespace rubble::io {

/// A table of bodies that are let go (io/fe/bodies/body_table.h): text whose first line of its own names masses and sides.
bool recognisesBodies(const FileHead& head);

/// Throws as readBodyTable().
FeResult::Contents readBodies(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
