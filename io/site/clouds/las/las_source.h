#pragma once

#include <memory>
#include <string>

#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// Opens a LAS 1.0 to 1.4 or a LAZ. A file that ends before its points do gives those that are there, with a finding.
/// Throws WorldError, ParseError.
std::unique_ptr<CloudSource> openLas(const std::string& path);

}  // namespace rubble::io
