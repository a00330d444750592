#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// Opens a PCD of the Point Cloud Library: ascii, binary or binary_compressed. Throws WorldError, ParseError.
std::unique_ptr<CloudSource> openPcd(const std::string& path);

/// Unpacks what LZF has packed. @return false: the packed bytes are damaged, or do not fill what they should
bool unpackLzf(const std::vector<unsigned char>& packed, std::vector<unsigned char>& unpacked);

}  // namespace rubble::io
