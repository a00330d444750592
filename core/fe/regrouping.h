#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/base/finding.h"
#include "core/base/geometry.h"
#include "core/fe/mesh.h"

namespace rubble {

/// Splits a component into its pieces that hang together by shared nodes; pieces are named "NAME 1", "NAME 2", ... from the
/// largest (most elements; ties: lowest element). A component of one piece keeps its name.
struct SplitByConnectivity {
    std::string component;
    friend bool operator==(const SplitByConnectivity&, const SplitByConnectivity&) = default;
};
/// Moves the elements whose initial centre lies inside a box (local frame, m) to a new component.
struct SplitByBox {
    std::string component;
    Vec3 low = Vec3::Zero();
    Vec3 high = Vec3::Zero();
    std::string newName;
    friend bool operator==(const SplitByBox&, const SplitByBox&) = default;
};
/// Moves the elements whose initial centre lies on the positive side of a plane to a new component.
struct SplitByPlane {
    std::string component;
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitX();
    std::string newName;
    friend bool operator==(const SplitByPlane&, const SplitByPlane&) = default;
};
/// Joins components into one; the result takes the place of the first.
struct MergeComponents {
    std::vector<std::string> components;
    std::string newName;
    friend bool operator==(const MergeComponents&, const MergeComponents&) = default;
};
struct RenameComponent {
    std::string component;
    std::string newName;
    friend bool operator==(const RenameComponent&, const RenameComponent&) = default;
};

/// One step of regrouping; a scenario holds them in order and they are applied to the parts of the file.
using RegroupStep = std::variant<SplitByConnectivity, SplitByBox, SplitByPlane, MergeComponents, RenameComponent>;

/// A named set of elements while components are being made.
struct ElementGroup {
    std::string name;
    std::vector<ElementIndex> elements;  ///< ascending
};

/// The parts of the file that hold elements, in file order, after the steps were applied in order. A piece split off stands behind
/// its source; a group left without elements goes. A step that moves nothing is a finding.
/// Throws UsageError if a step names a component that does not exist, or gives a name that another one has.
std::vector<ElementGroup> regroup(const Mesh& mesh, const std::vector<RegroupStep>& steps, Findings& findings);

/// The error for a component name that does not exist: names it and the ones that come nearest.
[[noreturn]] void throwUnknownComponent(const std::string& name, const std::vector<std::string>& existing);

}  // namespace rubble
