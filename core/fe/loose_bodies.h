#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/convex_body.h"
#include "core/fe/fe_result.h"
#include "core/fe/material.h"

namespace rubble {

/// A box or a convex body of even density that is let go at a time, with the motion it then has.
struct LooseBody {
    std::string id;
    double mass = 0.0;                       ///< kg, positive
    Vec3 sides = Vec3::Zero();               ///< m, of it or the box around it along its own axes; positive
    std::shared_ptr<const ConvexBody> hull;  ///< its shape; null: it is a box
    Pose pose;                               ///< of its centre of mass and its axes
    Vec3 velocity = Vec3::Zero();            ///< m/s of the centre
    Vec3 spin = Vec3::Zero();                ///< rad/s, world axes
    std::optional<Material> material;        ///< unset: guessed from its density
    double time = 0.0;                       ///< s, when it is let go

    double volume() const { return hull ? hull->volume : sides.prod(); }  ///< m3
    double density() const { return mass / volume(); }
};

/// What was measured of a body once it had fallen; places in the axes of the table.
struct MeasuredEnd {
    std::optional<Vec3> place;    ///< m, of its centre
    std::optional<Quat> turn;     ///< of its axes
    std::optional<double> after;  ///< s, since it was let go
    std::string group;            ///< bodies that are told apart: "plate"; empty: none
};

/// The corners of a body where it is let go; those of a box in the order of a hexahedron.
std::vector<Vec3> cornersOf(const LooseBody& body);

/// Name of the part that bodies of a material stand in: "stone", or "stone, by density" where it was guessed.
std::string partOf(const LooseBody& body);

/// Bodies as an FE result, which goes through the pipeline as any other, in the order of the list, active up to their times: boxes
/// as one hexahedron, others as tetrahedra between their centre and their surface, which share its nodes. The parts are
/// materials. Ids that are whole numbers, each once, become element numbers where all bodies are boxes; else these count from 1.
/// @param until  s, the result lasts at least so long, and 0.1 s beyond the last body
FeResult::Contents contentsOf(const std::vector<LooseBody>& bodies, double until = -std::numeric_limits<double>::infinity());

/// The body of a table that each element is a part of, counted from 0 in the order of the table. Elements of one
/// body follow each other and share nodes, those of two never. @return [elements]; empty: every element is a body of its own
std::vector<std::uint32_t> bodiesOfTable(const FeResult& fe);

}  // namespace rubble
