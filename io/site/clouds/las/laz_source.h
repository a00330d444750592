#pragma once

#include <memory>

#include "io/site/clouds/cloud_source.h"
#include "io/site/clouds/las/las_head.h"

namespace rubble::io {

/// Opens the packed points of a LAZ whose head was read. Throws ParseError for a packing that is not known.
/// @param found  in the head
std::unique_ptr<CloudSource> openLaz(std::unique_ptr<CloudFile> file, LasHead head, Findings found);

}  // namespace rubble::io
