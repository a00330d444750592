#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/message.h"
#include "core/base/same_bits.h"
#include "core/base/standard_gravity.h"
#include "core/selftest/pile.h"

namespace rubble::selftest {

namespace {

/// Share of 5 cm boxes shot at a 2 cm plate that come out behind it.
double shareThrough(const CaseSetting& setting, double speed) {
    WorldScene scene(setting);
    scene.settings.gravity = 0.0;
    scene.settings.ground = false;
    scene.piece({0, 0, 0}, {0.02, 12, 12});
    Sequence random(15);
    constexpr int shots = 100;
    for (int i = 0; i < shots; ++i) {
        // Distances that differ by the way of a step, so that every phase of it occurs.
        const double x = -1.0 - random.between(0.0, speed / 60.0);
        scene.box({x, i % 10 - 4.5, i / 10 - 4.5}, {0.05, 0.05, 0.05}, {speed, 0, 0}, random.turn());
    }
    scene.run((2.0 + speed / 60.0) / speed + 0.1);
    int through = 0;
    for (std::size_t i = 0; i < shots; ++i) {
        through += !(scene.place(idAt<BodyId>(i)).x() < 0.0);
    }
    return static_cast<double>(through) / shots;
}

void bullets(const CaseSetting& setting, Outcome& outcome) {
    for (const double speed : {15.0, 50.0, 100.0}) {
        outcome.none("share through the plate at " + englishNumber(speed) + " m/s", shareThrough(setting, speed));
    }
}

/// Hills of 3 m on a grid of 1 m.
std::shared_ptr<const TerrainGrid> hills() {
    constexpr std::size_t n = 61;
    std::vector<double> heights;
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; i < n; ++i) {
            heights.push_back(3.0 * sineOf(0.4 * static_cast<double>(i)) * cosineOf(0.3 * static_cast<double>(j)));
        }
    }
    return std::make_shared<const TerrainGrid>(-30.0, -30.0, 1.0, n, n, std::move(heights));
}

void terrain(const CaseSetting& setting, Outcome& outcome) {
    for (const double speed : {15.0, 30.0, 100.0}) {
        WorldScene scene(setting);
        scene.settings.terrain = hills();
        scene.settings.reach = Aabb(Vec3(-10, -10, 0), Vec3(10, 10, 20));
        Sequence random(100);
        for (int i = 0; i < 100; ++i) {
            const double height = 6.0 + random.between(0.0, speed / 60.0);
            const double side = i % 2 == 0 ? 0.05 : 0.3;
            // One draw a line: compilers take arguments in an order of their own.
            const Quat turn = random.turn();
            const double across = random.between(-0.3, 0.3), along = random.between(-0.3, 0.3);
            scene.box({2.0 * (i % 10) - 9.0, 2.0 * (i / 10) - 9.0, height}, Vec3::Constant(side),
                      speed * Vec3(along, across, -0.9).normalized(), turn);
        }
        int below = 0;
        for (int i = 0; i < 20; ++i) {
            scene.run(0.1);
        }
        for (std::size_t i = 0; i < 100; ++i) {
            const Vec3 place = scene.place(idAt<BodyId>(i));
            below += !(place.z() > scene.settings.terrain->height(place.x(), place.y()));
        }
        outcome.none("bodies of 100 below the terrain, hit at " + englishNumber(speed) + " m/s", below);
    }
}

void thinDeck(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    scene.settings.ground = false;
    scene.settings.reach = Aabb(Vec3(-20, -20, -60), Vec3(20, 20, 62));
    constexpr double drop = 60.0, along = 4.0, down = 1.0, thick = 0.05;
    const double fall = std::sqrt(2.0 * drop / standardGravity);
    // The deck is where the boxes come down when they do.
    const auto deckAt = [&](double time) { return Vec3(along * (time - fall), 0, -0.5 * thick - down * (time - fall)); };
    const PieceId deck = scene.piece(deckAt(0.0), {16, 16, thick});
    Sequence random(60);
    constexpr int count = 64;
    const double sides[]{0.05, 0.1, 0.3, 0.6};
    for (int i = 0; i < count; ++i) {
        const Quat turn = random.turn();
        scene.box({1.2 * (i % 8) - 4.2, 1.2 * (i / 8) - 4.2, drop + random.between(-1.0, 1.0)}, Vec3::Constant(sides[i % 4]),
                  Vec3::Zero(), turn);
    }
    double fastest = 0.0;
    scene.run(fall + 0.7, [&](double time) {
        scene.world().movePiece(deck, {deckAt(time), Quat::Identity()});
        fastest = std::max(fastest, scene.maxSpeed());
    });
    const Vec3 end = deckAt(scene.time());
    int through = 0;
    for (std::size_t i = 0; i < count; ++i) {
        through += !(scene.place(idAt<BodyId>(i)).z() > end.z());
    }
    outcome.none("boxes of 64 that fell through the deck", through);
    outcome.atMost("fastest over sqrt(2 g h), h = 62 m", fastest / std::sqrt(2.0 * standardGravity * 62.0), 1.05);
}

void bouncy(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    scene.settings.pairs = PairTable::uniform(0.5, 0.9);
    Pile pile(scene);
    Sequence random(9);
    pile.addCloud(random, {-2.5, -2.5, 1.0}, {5, 5, 6}, {0.5, 0.5, 0.5}, 1.0);
    EnergyWatch watch;
    watch.look(scene);
    double fastest = 0.0;
    for (int i = 0; i < 600; ++i) {
        scene.run(scene.dt);
        watch.look(scene);
        fastest = std::max(fastest, scene.maxSpeed());
    }
    outcome.atMost("energy gained over that of gravity", watch.drift(), 1e-3);
    // A light hit between heavier ones may be faster than any fall, but not with equal masses and losses in every hit.
    outcome.atMost("fastest over sqrt(2 g h), h = 7 m", fastest / std::sqrt(2.0 * standardGravity * 7.0), 1.05);
    outcome.none("centres below ground", static_cast<double>(pile.centresBelow(0.0)));
}

/// Cubes let go on a slope of 30 degrees that ends level, turned in every way, each as if alone.
void roughSlope(const CaseSetting& setting, Outcome& outcome) {
    constexpr std::size_t columns = 61, rows = 41;
    const double fall = std::numbers::inv_sqrt3;
    std::vector<double> heights;
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            heights.push_back(std::max(0.0, 100.0 - 5.0 * static_cast<double>(i)) * fall);
        }
    }
    const TerrainGrid slope(-100, -100, 5.0, columns, rows, std::move(heights));
    WorldScene scene(setting);
    scene.dt = 1.0 / 75.0;
    scene.settings.bounceFriction = true;
    scene.settings.bodyContacts = false;
    scene.settings.pairs = PairTable::uniform(0.55, 0.1);
    scene.settings.terrain = std::make_shared<const TerrainGrid>(slope.roughened({0.05, 0.25, 1}));
    scene.settings.reach = Aabb(Vec3(-100, -100, 0), Vec3(200, 100, 70));
    Sequence random(5);
    constexpr int count = 40;
    for (int i = 0; i < count; ++i) {
        scene.box({-60.0, 2.0 * i - count, 60.0 * fall + 0.8}, {0.4, 0.4, 0.4}, {2, 0, 0}, random.turn());
    }
    scene.run(40.0);
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double way = scene.place(idAt<BodyId>(i)).x() + 60.0;
        sum += way;
        squares += way * way;
    }
    const double mean = sum / count;
    // Measured at Tschamut: 20 of 98 m. On the bare raster of 5 m these cubes end within 1.7 of 62 m.
    outcome.atLeast("scatter of the run-out over its mean", std::sqrt(squares / count - mean * mean) / mean, 0.2);
    outcome.atMost("share still awake", 1.0 - scene.asleep(), 0.05);
}

/// A cube thrown onto a floor of stone, as a box or as the hull of its corners, after a while.
Pose tossed(const CaseSetting& setting, bool hull, bool ground, std::uint64_t seed) {
    WorldScene scene(setting);
    scene.settings.pairs = PairTable::uniform(0.3, 0.1);
    scene.settings.ground = ground;
    scene.dt = 1.0 / 120.0;
    if (!ground) {
        scene.piece({0, 0, -0.5}, {20, 20, 1});
    }
    Sequence random(seed);
    const Vec3 spin = 3.0 * random.direction();
    const Quat turn = random.turn();
    NewBody body = boxBody({0, 0, 1}, {0.4, 0.4, 0.4}, {random.between(0.5, 1.5), 0, -1}, turn, spin);
    if (hull) {
        for (int i = 0; i < 8; ++i) {
            body.shape.front().points.emplace_back(i & 1 ? 0.2 : -0.2, i & 2 ? 0.2 : -0.2, i & 4 ? 0.2 : -0.2);
        }
    }
    const BodyId id = scene.world().addBody(body);
    scene.run(0.8);
    return scene.world().motion(id).pose;
}

void hulls(const CaseSetting& setting, Outcome& outcome) {
    for (const bool ground : {true, false}) {
        double most = 0.0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const Pose box = tossed(setting, false, ground, seed), hull = tossed(setting, true, ground, seed);
            most = std::max(most, (box.position - hull.position).norm() + 0.2 * box.orientation.angularDistance(hull.orientation));
        }
        // The same corners and the same edges meet the same floor; the order of the points alone may differ.
        outcome.atMost(ground ? "box and hull apart on the ground" : "box and hull apart on a floor", most, 0.02, "m");
    }
}

}  // namespace

std::vector<HardCase> impactCases() {
    return {
        {"bullets-plate", "5 cm boxes hit a 2 cm plate at 15, 50, 100 m/s", "pass through between two steps", "none of 100 through",
         0.5, bullets},
        {"terrain", "boxes of 5 and 30 cm hit terrain at 15, 30, 100 m/s", "pass through the surface", "none of 100 below", 1.0,
         terrain},
        {"rough-slope", "40 cubes on a slope of 30 degrees with obstacles of 5 cm", "blocks of all orientations end at one place",
         "run-out scatters by 20 % or more, 95 % at rest after 40 s", 0.5, roughSlope},
        {"thin-deck-60m", "60 m fall onto a moving deck of 5 cm", "fall through the deck, are shot off it",
         "none of 64 through, no faster than the fall", 0.5, thinDeck},
        {"restitution-09", "150 boxes with restitution 0.9", "energy grows with every bounce",
         "gain below 0.1 %, no faster than a fall, none below ground", 2.0, bouncy},
        {"hull-toss", "20 cubes thrown onto ground and floor, as boxes and as hulls of their corners",
         "hulls turn and rest elsewhere", "places and corners within 2 cm after 0.8 s", 0.3, hulls},
    };
}

}  // namespace rubble::selftest
