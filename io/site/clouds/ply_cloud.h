#pragma once

#include <memory>
#include <string>

#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// Opens the points of a PLY, as text or in bytes of either end; faces are left out, which is a finding.
/// Throws WorldError, ParseError.
std::unique_ptr<CloudSource> openPlyCloud(const std::string& path);

}  // namespace rubble::io
