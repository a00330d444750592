#pragma once

#include <string>

#include "core/base/execution.h"
#include "io/seal/bag.h"

namespace rubble::io {

/// A bundle as it was before a record came into it.
struct EarlierBundle {
    std::string sha256;         ///< of the whole container
    bool stampedLater = false;  ///< a time stamp came in afterwards, maybe in the place of an older one
};

/// Makes it again: files are only ever added behind those that are there, and equal files make equal containers.
/// @param folder  of the record, with its slash
/// Throws WorldError (no room for it among temporary files), ParseError, Cancelled.
EarlierBundle bundleBefore(PackedBag& packed, const std::string& folder, const Execution& execution);

}  // namespace rubble::io
