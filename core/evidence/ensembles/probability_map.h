#pragma once

#include "core/evidence/ensembles/ensemble.h"
#include "core/evidence/maps/debris_map.h"

namespace rubble {

/// Cells that any of some surfaces reaches into, ascending.
std::vector<MapCell> cellsOfAny(std::span<const EnsembleMember* const> members);

/// How often debris lies where over an ensemble: probabilities of debris and of debris higher than three heights, quantiles of
/// height and mass, and how far the probability may be off for so few members. A cell that a member leaves empty counts with 0.
/// The ledger is the mean over the members.
/// @param thresholds  m, ascending
/// Throws UsageError without members, and for thresholds that are none.
DebrisMap probabilityMap(const EnsembleReport& report, const HeightThresholds& thresholds);

/// How the maps settle as members are added.
struct ConvergenceRow {
    std::size_t members = 0;
    std::array<FigureSpread, memberMeasureCount> figures;
    double probabilityError = 0.0;  ///< mean over the cells of the standard error of the probability
    double worstError = 0.0;        ///< of any cell
};
/// After 2, 4, 8, ... members in the order of their numbers, and after all.
std::vector<ConvergenceRow> convergenceOf(const EnsembleReport& report);

}  // namespace rubble
