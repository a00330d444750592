#pragma once

#include <span>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// Files that people have from their solvers and tools, and that are no results that can be read: known by content, each with the
/// way to one that can be read.
std::span<const ForeignFormat> unreadFormats();

}  // namespace rubble::io
