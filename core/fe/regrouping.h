#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// Splits a component into its pieces that hang together by shared nodes; pieces are named "NAME 1", "NAME 2", ... from the
/// largest.
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

}  // namespace rubble
