#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/analysis/debris/debris.h"
#include "core/base/execution.h"
#include "core/base/outline.h"
#include "core/evidence/maps/map_piece.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/scenario/scenario.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

struct CarriedIsland;

/// Least and greatest place in plan, m.
using PlanBox = Eigen::AlignedBox<float, 2>;

/// Live elements that fell or sank: debris as much as the fragments (DESIGN.md 2.7), with a line of its own in the ledger.
struct LiveStructure {
    std::vector<MapPiece> pieces;   ///< one for each element, in their order
    double mass = 0.0;              ///< kg
    double volume = 0.0;            ///< m3
    std::vector<PlanBox> standing;  ///< of each element that is alive, no fragment and no farther from its place at rest
};

/// The elements that are alive at a time, are no fragments, and whose centre (mean of the corners) is farther than a threshold from
/// where it was at rest. Between two FE states places are interpolated for elements alive at both; after the last one, elements of
/// released islands are where their bodies are and all others stay. Elements without finite places or without mass are left out.
/// @param debris     of the same time: what is a fragment there is not live
/// @param threshold  m
LiveStructure displacedStructure(const FeResult& fe, const Components& components, const FragmentSettings& settings,
                                 const FragmentSet& fragments, const Debris& debris, const TrajectoryReader& trajectory,
                                 double threshold, const Execution& execution);
/// The same where only the islands are known as they are at that time.
LiveStructure displacedStructure(const FeResult& fe, const Components& components, const FragmentSettings& settings,
                                 const FragmentSet& fragments, const Debris& debris, std::span<const CarriedIsland> islands,
                                 double threshold, const Execution& execution);

/// Around what stands, seen from above: rings of the cells that its boxes reach into, m. A hole is a ring of its own.
/// @param cell  m, side of these cells
std::vector<OutlineRing> standingOutline(std::span<const PlanBox> standing, double cell, const Execution& execution);

}  // namespace rubble
