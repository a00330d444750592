#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// Kinds of elements of an animation file, in the order of the mesh that is made of them.
enum class AnimKind : std::uint8_t { Solid, Shell, Beam, Particle };
inline constexpr std::size_t animKinds = 4;

/// One part of one kind as the file has it: "       3:CLADDING". Numbers need not be unique over the kinds.
struct AnimPart {
    std::int64_t id = 0;
    std::string name;
};

/// Elements of one kind. Lists that were not asked for, or that the file does not have, are empty.
struct AnimElements {
    std::size_t count = 0;
    std::vector<std::int64_t> nodes;  ///< places from 0 [count x 8, 4, 2 or 1]
    std::vector<std::uint8_t> off;    ///< 1 active, 0 deleted, 255 rigid or asleep [count]
    std::vector<AnimPart> parts;
    std::vector<std::uint32_t> part;  ///< place in parts [count]
    std::vector<std::int64_t> ids;    ///< user's numbers; 0 for the links of rigid bodies [count]
    std::vector<double> mass;         ///< [count]
    std::vector<double> density;      ///< current; 0 for dead elements [count]
    std::vector<double> thickness;    ///< of shells [count]
    std::vector<double> deletion;     ///< time of deletion, 0: never [count]
};

/// What to take from a file.
enum class AnimWanted : std::uint8_t {
    Everything,  ///< for the mesh
    Status,      ///< off, numbers and times of deletion
    Nodes        ///< places and velocities of nodes
};

/// One state of a run: an OpenRadioss animation file, plain or gzip-packed.
struct AnimState {
    double time = 0.0;
    std::vector<Vec3> positions;   ///< current [nodes]
    std::vector<Vec3> velocities;  ///< [nodes]; empty where the file has none
    std::vector<std::int64_t> nodeIds;
    std::array<AnimElements, animKinds> elements;

    const AnimElements& of(AnimKind kind) const { return elements[static_cast<std::size_t>(kind)]; }
    AnimElements& of(AnimKind kind) { return elements[static_cast<std::size_t>(kind)]; }
};

/// Nodes of an element of a kind: 8, 4, 2, 1.
std::size_t animWidth(AnimKind kind);

/// Reads one file. Everything it asks for is checked against the length of the file before memory is taken.
/// Throws ParseError naming file, byte, what was expected and found; WorldError if it cannot be read.
AnimState readAnimFile(const std::string& path, AnimWanted wanted);

}  // namespace rubble::io
