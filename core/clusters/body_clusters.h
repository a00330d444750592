#pragma once

#include <cstdint>
#include <span>

#include "core/clusters/clustering.h"

namespace rubble {

/// A cluster for each body of a table, whatever the settings are: fragments of elements of one body belong together.
/// @param bodies  of each element, as bodiesOfTable() gives them; not empty
Clustering makeBodyClusters(const FragmentSet& fragments, std::span<const std::uint32_t> bodies);

}  // namespace rubble
