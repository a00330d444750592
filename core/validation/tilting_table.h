#pragma once

#include "core/base/execution.h"
#include "core/base/geometry.h"

namespace rubble {

/// A dry wall on a table that is tilted about y; a single block is a wall of one.
struct TiltedWall {
    Vec3 block = Vec3::Ones();  ///< m, sides of a block along the wall's thickness (x), length (y) and height (z)
    int courses = 1;            ///< in running bond: every second begins with half a block
    int blocks = 1;             ///< a course, along y
    double friction = 0.65;     ///< of every contact
    double stepRate = 40.0;     ///< 1/s, what a collapse takes by itself
};

/// The angle at which it gives way, degrees: half-way between the steepest at which it stands for 4 s and the least at which it
/// does not, which are less than 0.1 apart. Stands: no block has moved or turned by a tenth of the block's thickness or its angle.
/// Throws Cancelled.
double tiltingAngle(const TiltedWall& wall, const Execution& execution);

/// The same by limit analysis of rigid blocks, degrees: it slides on its base, or topples as one about its lower edge, whichever is
/// first. Across its thickness no part of a wall of equal blocks is nearer to toppling than the whole.
double limitAngle(const TiltedWall& wall);

}  // namespace rubble
