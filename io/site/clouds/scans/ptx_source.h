#pragma once

#include <memory>
#include <string>

#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// Opens a PTX: scans of rows and columns with their poses, to which the points are brought. Throws WorldError, ParseError.
std::unique_ptr<CloudSource> openPtx(const std::string& path);

}  // namespace rubble::io
