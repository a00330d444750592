#pragma once

#include "core/fragments/fragment_set.h"
#include "core/trajectory/trajectory.h"

namespace rubble::io {

/// When something is to be seen: from <= time < to [s].
struct ShownSpan {
    double from = 0.0;
    double to = 0.0;
};

/// When a fragment is seen on a body that carries it: from its birth on, as long as it is carried.
/// @param leftIsland  it came out of an island: it is there from its hand-over on, for nothing else shows it until it is born
ShownSpan shownSpan(const Carrier& carrier, const Fragment& fragment, const BodyRecord& body, bool leftIsland);

}  // namespace rubble::io
