#pragma once

#include <memory>
#include <string>

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "core/scenario/scenario.h"
#include "io/fe/series/mesh_series.h"

namespace rubble::io {

/// Reads a series into the contents of a result: joins its meshes, decides the meaning of the flag (settings, then its name, then
/// what most elements hold at the first state), takes missing elements for dead, and leaves nodal values to a lazy source. A list
/// of deaths beside the path (see deathListBeside) counts where the series itself says nothing.
/// @param path  the first file of the result, named in errors
/// Where nothing says which elements are dead all are active, and a finding says how to name them.
/// Throws ParseError, UsageError, WorldError, Cancelled.
FeResult::Contents readSeries(const std::string& path, std::shared_ptr<MeshSeries> series, const ImportSettings& settings,
                              const Execution& execution);

/// Counts that nothing says which elements of a result are dead. @param choices  variables that could be the active flag
void noteNoDeaths(const std::string& path, std::size_t elements, const std::vector<std::string>& choices, Findings& findings);

/// The file and, where there is one, the list of deaths beside it: members of results whose deaths may stand in a list.
std::vector<std::string> withDeathList(std::vector<std::string> files);

}  // namespace rubble::io
