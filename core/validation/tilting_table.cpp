#include "core/validation/tilting_table.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "core/validation/standing_world.h"

namespace rubble {

namespace {

constexpr double toRadians = std::numbers::pi / 180.0;
constexpr double blockDensity = 2400.0;  // kg/m3
constexpr double wallStandsSeconds = 4.0;
constexpr double finestAngle = 0.1;  // degrees
constexpr double movedShare = 0.1;   // of the thickness

NewBody blockOf(const Vec3& sides, const Vec3& centre) {
    NewBody body;
    body.volume = sides.prod();
    body.mass = blockDensity * body.volume;
    const Vec3 squares = sides.cwiseProduct(sides);
    body.inertia = body.mass / 12.0 * Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
    ConvexPart part;
    part.box.halfExtents = 0.5 * sides;
    body.shape = {part};
    body.smallestSide = sides.minCoeff();
    body.pose.position = centre;
    return body;
}

/// Blocks of a level wall on z = 0.
std::vector<NewBody> blocksOf(const TiltedWall& wall) {
    std::vector<NewBody> blocks;
    const double length = wall.block.y();
    for (int course = 0; course < wall.courses; ++course) {
        const double z = (course + 0.5) * wall.block.z();
        const bool shifted = course % 2 == 1;
        double y = 0.0;
        const auto lay = [&](double side) {
            blocks.push_back(blockOf({wall.block.x(), side, wall.block.z()}, {0.0, y + 0.5 * side, z}));
            y += side;
        };
        if (shifted) {
            lay(0.5 * length);
        }
        for (int i = 0; i < wall.blocks - (shifted ? 1 : 0); ++i) {
            lay(length);
        }
        if (shifted) {
            lay(0.5 * length);
        }
    }
    return blocks;
}

bool stands(const TiltedWall& wall, double degrees, const Execution& execution) {
    const std::unique_ptr<RigidWorld> world = standingWorld(wall.friction, execution);
    const Quat tilt(Eigen::AngleAxisd(degrees * toRadians, Vec3::UnitY()));
    const double span = 4.0 * (wall.blocks * wall.block.y() + wall.courses * wall.block.z());
    ConvexPart table;
    table.box.halfExtents = {span, span, 1.0};
    world->addPiece({table}, {tilt * Vec3(0, 0, -1), tilt});
    std::vector<Vec3> places;
    for (NewBody& block : blocksOf(wall)) {
        block.pose = {tilt * block.pose.position, tilt};
        places.push_back(block.pose.position);
        world->addBody(block);
    }
    return staysInPlace(*world, places, movedShare * wall.block.x(), wallStandsSeconds, wall.stepRate, execution);
}

}  // namespace

double tiltingAngle(const TiltedWall& wall, const Execution& execution) {
    double standing = 0.0, falling = 60.0;
    while (falling - standing > finestAngle) {
        const double middle = 0.5 * (standing + falling);
        (stands(wall, middle, execution) ? standing : falling) = middle;
    }
    return 0.5 * (standing + falling);
}

double limitAngle(const TiltedWall& wall) {
    return std::atan(std::min(wall.friction, wall.block.x() / (wall.courses * wall.block.z()))) / toRadians;
}

}  // namespace rubble
