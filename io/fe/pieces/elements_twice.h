#pragma once

#include "core/base/finding.h"
#include "core/fe/activity.h"
#include "core/fe/mesh.h"

namespace rubble::io {

/// Counts solids that stand on the same nodes as another one of their shape while both are active: their mass counts twice. Shells
/// and beams on the same nodes are layers and bars, which are meant.
void noteElementsTwice(const Mesh& mesh, const Activity& activity, Findings& findings);

}  // namespace rubble::io
