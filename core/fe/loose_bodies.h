#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/fe/fe_result.h"
#include "core/fe/material.h"

namespace rubble {

/// A box of even density that is let go at a time, with the motion it then has.
struct LooseBody {
    std::string id;
    double mass = 0.0;                 ///< kg, positive
    Vec3 sides = Vec3::Zero();         ///< m, along its own axes; positive
    Pose pose;                         ///< of its centre and its axes
    Vec3 velocity = Vec3::Zero();      ///< m/s of the centre
    Vec3 spin = Vec3::Zero();          ///< rad/s, world axes
    std::optional<Material> material;  ///< unset: guessed from its density
    double time = 0.0;                 ///< s, when it is let go

    double density() const { return mass / sides.prod(); }
};

/// What was measured of a body once it had fallen; places in the axes of the table.
struct MeasuredEnd {
    std::optional<Vec3> place;    ///< m, of its centre
    std::optional<Quat> turn;     ///< of its axes
    std::optional<double> after;  ///< s, since it was let go
    std::string group;            ///< bodies that are told apart: "plate"; empty: none
};

/// The eight corners of a body where it is let go, in the order of a hexahedron.
std::vector<Vec3> cornersOf(const LooseBody& body);

/// Name of the part that bodies of a material stand in: "stone", or "stone, by density" where it was guessed.
std::string partOf(const LooseBody& body);

/// Bodies as an FE result, which goes through the pipeline as any other: one hexahedron each, in the order of the list, active up
/// to its time. The parts are materials. Ids that are whole numbers, each once, become element numbers; else these count from 1.
/// @param until  s, the result lasts at least so long, and 0.1 s beyond the last body
FeResult::Contents contentsOf(const std::vector<LooseBody>& bodies, double until = -std::numeric_limits<double>::infinity());

}  // namespace rubble
