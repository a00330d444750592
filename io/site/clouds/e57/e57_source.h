#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// Opens an E57: its scans one after another, brought to their poses. Throws WorldError, ParseError.
std::unique_ptr<CloudSource> openE57(const std::string& path);

/// The bytes of a picture that lies in an E57, as a file of its kind. Throws WorldError, ParseError.
std::vector<unsigned char> photographOfE57(const std::string& path, const CloudPhotograph& photograph);

}  // namespace rubble::io
