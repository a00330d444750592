#pragma once

#include "core/clusters/clustering.h"

namespace rubble {

/// The clusters of one set of fragments made of another: who moves with whom stays, mass properties and motion are those of the new
/// fragments. For repeats with shifted births: at a tie a shift of 1e-6 m would change the groups themselves.
/// @param fragments  as many as those of `pattern`, of the same elements in the same order
Clustering rejoinClusters(const Clustering& pattern, const FragmentSet& fragments);

}  // namespace rubble
