#pragma once

#include <random>
#include <vector>

#include "core/fragments/fragment_set.h"
#include "core/selftest/element_scene.h"

namespace rubble::test {

using selftest::ElementScene;

/// Corners of an element of about the given size, distorted at random but sound; beams along some direction.
std::vector<Vec3> randomElement(ElementShape shape, std::mt19937& random, double size = 1.0, double distortion = 0.2);
Vec3 randomVector(std::mt19937& random, double length);
Mat3 randomRotation(std::mt19937& random);

/// Of a scene whose components are those of its mesh.
FragmentSet fragmentsOf(const ElementScene& scene, const FragmentSettings& settings = {});

inline constexpr ElementShape allShapes[]{ElementShape::Hexahedron,  ElementShape::Wedge,         ElementShape::Pyramid,
                                          ElementShape::Tetrahedron, ElementShape::Quadrilateral, ElementShape::Triangle,
                                          ElementShape::Beam};

}  // namespace rubble::test
