#pragma once

#include <cstdint>
#include <vector>

#include "core/base/execution.h"
#include "core/base/geometry.h"

namespace rubble {

/// Dice that are poured into a vessel.
enum class Die : std::uint8_t { Cube, Tetrahedron, Octahedron, Dodecahedron, Icosahedron };

/// Corners of a die about its centre, of a volume of 1 m3.
std::vector<Vec3> dieCorners(Die die);

/// How a vessel is filled.
struct Pour {
    Die die = Die::Cube;
    double size = 0.3;   ///< m, cube root of the volume of a die
    double width = 3.0;  ///< m, of the square vessel, between its walls
    int dice = 700;
    double friction = 0.5;  ///< of every contact
    std::uint64_t seed = 1;
};

/// Pours dice in, a few at a time from half a metre above the pile, and measures the share of the middle of the vessel that they
/// fill: away from walls, floor and top by one and a half, two and three sizes. NaN if the middle is empty. Throws Cancelled.
double pouredSolidFraction(const Pour& pour, const Execution& execution);

}  // namespace rubble
