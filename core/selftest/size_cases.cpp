#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/message.h"
#include "core/base/same_bits.h"
#include "core/selftest/pile.h"

namespace rubble::selftest {

namespace {

void massRatio(const CaseSetting& setting, Outcome& outcome) {
    for (const double ratio : {1e2, 1e4, 1e6}) {
        WorldScene scene(setting);
        constexpr double side = 0.4;
        scene.box({0, 0, 0.5 * side}, Vec3::Constant(side));
        const Vec3 size = Vec3::Constant(1.0);
        const double small = scene.world().mass(idAt<BodyId>(0));
        const BodyId heavy = scene.world().addBody(
            boxBody({0.05, 0.02, side + 0.5}, size, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), ratio * small));
        double fastest = 0.0;
        scene.run(3.0, [&](double) { fastest = std::max(fastest, scene.maxSpeed()); });
        const std::string at = ", 1 : " + englishInteger(static_cast<std::int64_t>(ratio));
        outcome.atMost("sink over the small side" + at, (side + 0.5 - scene.place(heavy).z()) / side, 0.25);
        outcome.atMost("fastest" + at, fastest, 1.0, "m/s");
    }
}

/// Puts boxes of very different sizes on top of each other in turn, none inside another, each turned about the vertical.
void stackSizes(Pile& pile, const std::vector<Vec3>& sizes, double width, Sequence& random) {
    struct Placed {
        double x, y, half, top;
    };
    std::vector<Placed> placed;
    for (const Vec3& size : sizes) {
        const double half = 0.5 * size.head<2>().norm();
        const double x = random.between(-0.5 * width, 0.5 * width), y = random.between(-0.5 * width, 0.5 * width);
        double floor = 0.0;
        for (const Placed& other : placed) {
            if (std::abs(other.x - x) < other.half + half && std::abs(other.y - y) < other.half + half) {
                floor = std::max(floor, other.top);
            }
        }
        const Quat turn(turnAbout(Vec3::UnitZ(), random.between(0.0, 3.0)));
        pile.add({x, y, floor + 0.5 * size.z() + 0.002}, size, turn);
        placed.push_back({x, y, half, floor + size.z() + 0.002});
    }
}

struct HeapOfSizes {
    double below = 0.0;    ///< bodies with their centre below the ground at the end
    double fastest = 0.0;  ///< over sqrt(2 g h), at any time
    double left = 0.0;     ///< m/s, fastest at the end
};

HeapOfSizes heapOfSizes(const CaseSetting& setting, std::uint64_t seed) {
    WorldScene scene(setting);
    Pile pile(scene);
    Sequence random(seed);
    std::vector<Vec3> sizes;
    // Sides from 1 cm to 10 m, evenly in their logarithm.
    for (int i = 0; i < 400; ++i) {
        sizes.push_back(Vec3::Constant(powerOfTen(random.between(-2.0, 1.0))));
    }
    sizes[0] = Vec3::Constant(10.0);
    sizes[200] = Vec3::Constant(0.01);
    stackSizes(pile, sizes, 40.0, random);
    double height = 0.0;
    for (const Vec3& place : pile.places()) {
        height = std::max(height, place.z());
    }
    HeapOfSizes heap;
    const double fall = std::sqrt(2.0 * scene.settings.gravity * height);
    // The heap stands up to 100 m high at first; a pebble struck at its end flies and rolls for ten seconds more.
    for (int i = 0; i < 250; ++i) {
        scene.run(0.1);
        heap.fastest = std::max(heap.fastest, scene.maxSpeed() / fall);
    }
    heap.below = static_cast<double>(pile.centresBelow(0.0));
    heap.left = scene.maxSpeed();
    return heap;
}

void sizesTogether(const CaseSetting& setting, Outcome& outcome) {
    HeapOfSizes worst;
    // What a heap throws out depends on how its blocks come to lie.
    for (std::uint64_t seed = 400; seed < (setting.small ? 402u : 408u); ++seed) {
        const HeapOfSizes heap = heapOfSizes(setting, seed);
        worst.below += heap.below;
        worst.fastest = std::max(worst.fastest, heap.fastest);
        worst.left = std::max(worst.left, heap.left);
    }
    outcome.none("centres below ground, of 400 in each heap", worst.below);
    // What falls farthest is the fastest; a tenth for a pebble that a falling block strikes.
    outcome.atMost("fastest over sqrt(2 g h)", worst.fastest, 1.1);
    outcome.atMost("fastest at the end", worst.left, 1.0, "m/s");
}

}  // namespace

std::vector<HardCase> sizeCases() {
    return {
        {"mass-ratio", "heavy on small, 1 : 100, 10,000 and 1,000,000", "the small one is pressed through",
         "sinks less than a quarter of the small side, below 1 m/s", 0.3, massRatio},
        {"sizes-1cm-10m", "400 cubes of 1 cm to 10 m in one heap", "small ones are pressed into the ground or shot out",
         "none below ground, none above 1.1 sqrt(2 g h), end below 1 m/s, in each of several heaps", 10.0, sizesTogether},
    };
}

}  // namespace rubble::selftest
