#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/standard_gravity.h"
#include "core/engine/world/constants.h"
#include "core/selftest/pile.h"

namespace rubble::selftest {

namespace {

void overlappingPairs(const CaseSetting& setting, Outcome& outcome) {
    double fastest = 0.0, still = 0.0;
    for (const double overlap : {0.001, 0.003, 0.01, 0.03, 0.1}) {
        WorldScene scene(setting);
        scene.settings.gravity = 0.0;
        scene.settings.ground = false;
        scene.settings.freeze = false;
        Pile pile(scene);
        pile.add({0, 0, 0}, {0.5, 0.5, 0.5});
        pile.add({0.5 - overlap, 0.05, 0.02}, {0.5, 0.5, 0.5});
        scene.run(3.0, [&](double) { fastest = std::max(fastest, scene.maxSpeed()); });
        fastest = std::max(fastest, scene.maxSpeed());
        still = std::max(still, pile.overlap().deepest);
    }
    outcome.atMost("fastest, born 1 to 100 mm inside each other", fastest, 0.01, "m/s");
    outcome.atMost("overlap left after 3 s", still, 0.002, "m");
}

/// 4 x 4 x 4 cubes side by side, each with its own velocity.
double gainOfScattered(const CaseSetting& setting, double scatter) {
    WorldScene scene(setting);
    scene.settings.gravity = 0.0;
    scene.settings.ground = false;
    scene.settings.freeze = false;
    Pile pile(scene);
    Sequence random(64);
    for (int i = 0; i < 64; ++i) {
        pile.add(0.5 * Vec3(i % 4, (i / 4) % 4, i / 16), {0.5, 0.5, 0.5}, Quat::Identity(), scatter * random.direction());
    }
    EnergyWatch watch;
    watch.look(scene);
    for (int i = 0; i < 120; ++i) {
        scene.run(scene.dt);
        watch.look(scene);
    }
    return watch.drift();
}

void scatteredNeighbours(const CaseSetting& setting, Outcome& outcome) {
    outcome.atMost("energy gained, 1 m/s of scatter", gainOfScattered(setting, 1.0), 1e-3);
    outcome.atMost("energy gained, 10 m/s of scatter", gainOfScattered(setting, 10.0), 1e-3);
}

void touchingNeighbours(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    Pile pile(scene);
    for (int k = 0; k < 6; ++k) {
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 8; ++i) {
                pile.add({0.5 * i, 0.5 * j, 0.25 + 0.5 * k}, {0.5, 0.5, 0.5});
            }
        }
    }
    const std::vector<Vec3> start = pile.places();
    EnergyWatch watch;
    watch.look(scene);
    double fastest = 0.0, sideways = 0.0;
    scene.run(3.0, [&](double) { fastest = std::max(fastest, scene.maxSpeed()); });
    for (std::size_t i = 0; i < start.size(); ++i) {
        sideways = std::max(sideways, (scene.place(idAt<BodyId>(i)) - start[i]).head<2>().norm());
    }
    // Nothing has anywhere to fall: contacts hold from the first step on, so that one step of gravity is the most.
    outcome.atMost("fastest of 192 blocks born as a standing wall, over g dt", fastest / (standardGravity * scene.dt), 1.0);
    outcome.atMost("largest sideways move in 3 s", sideways, 0.01, "m");
    outcome.atLeast("mean height over that at birth", pile.meanHeight() / 1.5, 0.99);
}

/// Boxes for a heap in a walled pit: half of them lie there already, half are born into it.
struct Pit {
    static constexpr double width = 3.0;
    explicit Pit(const CaseSetting& setting) : scene(setting), pile(scene) {
        for (const double side : {-1.0, 1.0}) {
            scene.piece({side * (0.5 * width + 0.5), 0, 15}, {1.0, width + 2.0, 30});
            scene.piece({0, side * (0.5 * width + 0.5), 15}, {width, 1.0, 30});
        }
    }
    static Vec3 sizeOf(int i) { return {0.4, 0.3 + 0.1 * (i % 3), 0.3}; }
    void pour(Sequence& random, int count, double bottom) {
        for (int i = 0; i < count; ++i) {
            const int layer = i / 16;
            pile.add({-1.05 + 0.7 * (i % 4), -1.05 + 0.7 * (i / 4 % 4), bottom + 0.7 * layer + 0.35}, sizeOf(i), random.turn());
        }
    }
    /// How deep a box would be in what is there, over its smallest side.
    double depthOf(const OrientedBox& box) {
        double deepest = -1.0;
        for (const OrientedBox& other : placedBoxes(scene.world(), pile.sizes())) {
            deepest = std::max(deepest, overlapOf(box, other) / (2.0 * box.halfExtents.minCoeff()));
        }
        return deepest;
    }
    /// A place between 20 and 100 % of its smallest side deep in other boxes (of the stone arch's: half of the side in the median).
    Pose occupiedPlace(Sequence& random, const Vec3& size) {
        for (int i = 0; i < 1000; ++i) {
            const OrientedBox box{
                {random.between(-1.1, 1.1), random.between(-1.1, 1.1), random.between(0.3, 3.0)}, random.turn(), 0.5 * size};
            const double depth = depthOf(box);
            if (depth > 0.2 && depth < 1.0) {
                return {box.centre, box.orientation};
            }
        }
        return {Vec3(0, 0, 1), Quat::Identity()};
    }
    /// The lowest free place above a random point.
    Pose freePlace(Sequence& random, const Vec3& size) {
        OrientedBox box{{random.between(-1.1, 1.1), random.between(-1.1, 1.1), 0.4}, random.turn(), 0.5 * size};
        while (depthOf(box) > 0.0) {
            box.centre.z() += 0.1;
        }
        return {box.centre, box.orientation};
    }
    WorldScene scene;
    Pile pile;
};

constexpr int pitHalf = 192;

/// Mean height of the same boxes poured in from above, none inside another.
double pouredHeight(const CaseSetting& setting) {
    Pit pit(setting);
    Sequence random(61);
    pit.pour(random, 2 * pitHalf, 0.1);
    pit.scene.run(8.0);
    return pit.pile.meanHeight();
}

void birthsInDebris(const CaseSetting& setting, Outcome& outcome) {
    Pit pit(setting);
    WorldScene& scene = pit.scene;
    Sequence random(61);
    pit.pour(random, pitHalf, 0.1);
    scene.run(5.0);
    EnergyWatch watch;
    watch.look(scene);
    double fastest = 0.0, rising = 0.0;
    const auto stepOnce = [&] {
        scene.run(scene.dt);
        watch.look(scene);
        fastest = std::max(fastest, scene.maxSpeed());
        for (std::size_t i = 0; i < scene.bodies(); ++i) {
            rising = std::max(rising, scene.velocity(idAt<BodyId>(i)).z());
        }
    };
    double highestBirth = 0.0;
    // Eight at a time every quarter second, five of them (61 %) in occupied space, the others just above what lies there.
    for (int born = 0; born < pitHalf; born += 8) {
        for (int i = 0; i < 8; ++i) {
            const bool inside = (born + i) * 61 / 100 != (born + i + 1) * 61 / 100;
            const Pose place =
                inside ? pit.occupiedPlace(random, Pit::sizeOf(born + i)) : pit.freePlace(random, Pit::sizeOf(born + i));
            pit.pile.add(place.position, Pit::sizeOf(born + i), place.orientation);
            highestBirth = std::max(highestBirth, place.position.z());
        }
        watch.admit(scene);
        for (int i = 0; i < 15; ++i) {
            stepOnce();
        }
    }
    for (int i = 0; i < 300; ++i) {
        stepOnce();
    }
    int occupied = 0;
    for (int i = 0; i < pitHalf; ++i) {
        occupied += scene.world().birthDepth(idAt<BodyId>(static_cast<std::size_t>(pitHalf + i))) > occupiedShare;
    }
    outcome.atLeast("share of births in occupied space", static_cast<double>(occupied) / pitHalf, 0.58);
    // All are born at rest, so that none can be faster than its way down allows (PHYSICS section 6).
    outcome.atMost("fastest over sqrt(2 g h)", fastest / std::sqrt(2.0 * standardGravity * highestBirth), 1.05);
    outcome.atMost("fastest upwards", rising, 1.0, "m/s");
    outcome.atMost("energy gained beyond the work booked, over that of gravity", watch.drift(), 1e-3);
    outcome.atMost("mean height over the same boxes poured", pit.pile.meanHeight() / pouredHeight(setting), 1.05);
    outcome.atMost("solid fraction", pit.pile.volume() / (Pit::width * Pit::width * 2.0 * pit.pile.meanHeight()), 0.70);
    outcome.none("centres below ground", static_cast<double>(pit.pile.centresBelow(0.0)));
}

void bornInsideStructure(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    scene.piece({0, 0, 2}, {4, 4, 4});
    Pile pile(scene);
    Sequence random(7);
    // On the faces, within, and right at the centre of a standing piece.
    for (int i = 0; i < 48; ++i) {
        const double depth = random.between(-0.2, 2.0);
        const Vec3 out = i % 3 == 0 ? Vec3(1, 0, 0) : i % 3 == 1 ? Vec3(0, -1, 0) : Vec3(0, 0, 1);
        const Vec3 across = i % 3 == 0 ? Vec3(0, 1, 0) : i % 3 == 1 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        const double aside = random.between(-1.6, 1.6);
        pile.add(Vec3(0, 0, 2) + (2.0 - depth) * out + aside * across, {0.4, 0.4, 0.4}, random.turn());
    }
    EnergyWatch watch;
    watch.look(scene);
    double fastest = 0.0;
    for (int i = 0; i < 360; ++i) {
        scene.run(scene.dt);
        watch.look(scene);
        fastest = std::max(fastest, scene.maxSpeed());
    }
    outcome.atMost("fastest over sqrt(2 g h), h = 4.6 m", fastest / std::sqrt(2.0 * standardGravity * 4.6), 1.05);
    outcome.atMost("energy gained beyond the work booked, over that of gravity", watch.drift(), 1e-3);
    outcome.none("centres below ground", static_cast<double>(pile.centresBelow(0.0)));
}

}  // namespace

std::vector<HardCase> birthCases() {
    return {
        {"births-overlap", "two boxes born 1 to 100 mm inside each other", "burst apart", "never faster than 1 cm/s, then apart",
         0.2, overlappingPairs},
        {"births-scatter", "touching neighbours born with 1 and 10 m/s of scatter", "energy grows",
         "energy never rises by over 0.1 %", 1.0, scatteredNeighbours},
        {"births-neighbours", "a wall of touching neighbours born in one state", "bursts, sags",
         "below one step of gravity, moves less than 1 cm, keeps 99 % of its height", 1.5, touchingNeighbours},
        {"births-in-debris", "61 % of births inside older debris", "launches, gains energy, swells or squeezes the pile",
         "no faster than a fall, upwards below 1 m/s, gain below 0.1 %, no higher than poured by over 5 %, solid fraction below "
         "0.70",
         12.0, birthsInDebris},
        {"births-in-structure", "fragments born inside a standing piece", "shot out of it",
         "no faster than a fall, gain below 0.1 %, none below ground", 2.0, bornInsideStructure},
    };
}

}  // namespace rubble::selftest
