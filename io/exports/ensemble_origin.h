#pragma once

#include <span>
#include <string>

#include "core/evidence/cautions.h"
#include "core/evidence/ensembles/cause_comparison.h"
#include "core/evidence/ensembles/ensemble.h"
#include "io/case/ensemble_source.h"
#include "io/exports/map_files.h"

namespace rubble::io {

/// What a map of an ensemble was made from: inputs, what was varied, and for each member what was drawn and its trajectory.
/// @param map  of probabilities
MapOrigin ensembleOrigin(const EnsembleReport& report, const DebrisMap& map, const EnsembleBasis& basis);
/// The same of a map that tells causes apart: the members of all of them, each with its cause.
MapOrigin separationOrigin(std::span<const Hypothesis> causes, const DebrisMap& map, const EnsembleBasis& basis);

/// What a comparison of causes was made from: JSON as beside their map.
std::string causesProvenance(std::span<const Hypothesis> causes, const EnsembleBasis& basis);

/// What must be known beside a map of an ensemble.
std::vector<Caution> ensembleCautions(const EnsembleReport& report, const DebrisMap& map, const EnsembleBasis& basis);
/// The same of a map that tells causes apart.
std::vector<Caution> separationCautions(std::span<const Hypothesis> causes, const EnsembleBasis& basis);

}  // namespace rubble::io
