#pragma once

#include <string>

#include "core/evidence/cautions.h"
#include "core/evidence/ensembles/ensemble.h"
#include "io/case/ensemble_source.h"
#include "io/exports/map_files.h"

namespace rubble::io {

/// What a map of an ensemble was made from: inputs, what was varied, and for each member what was drawn and its trajectory.
/// @param map  of probabilities, or of what tells hypotheses apart
MapOrigin ensembleOrigin(const EnsembleReport& report, const DebrisMap& map, const EnsembleBasis& basis);

/// What must be known beside a map of an ensemble.
std::vector<Caution> ensembleCautions(const EnsembleReport& report, const DebrisMap& map, const EnsembleBasis& basis);

/// "at rest" or "at the end of the FE result", with what counts as debris.
std::string ensembleClass(const EnsembleReport& report);

}  // namespace rubble::io
