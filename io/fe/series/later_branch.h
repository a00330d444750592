#pragma once

#include <cstddef>
#include <vector>

#include "core/base/finding.h"

namespace rubble::io {

/// Which states of a series count, in all formats: where an analysis went back in time, the later branch counts from there on and
/// the states that it abandoned are left out; of states written twice at one time the later one counts. Both are counted.
/// @param times  s, in the order in which the states were written
/// @return  places in that order, with growing times; a time that is no number stays where it is
std::vector<std::size_t> laterBranch(const std::vector<double>& times, Findings& findings);

}  // namespace rubble::io
