#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "core/base/message.h"
#include "core/base/same_bits.h"
#include "core/selftest/pile.h"

namespace rubble::selftest {

namespace {

constexpr double blockSide = 0.4;

/// A heap of a few hundred boxes that fell from a cloud.
void addHeap(Pile& pile, std::uint64_t seed, int layers = 8) {
    Sequence random(seed);
    pile.addCloud(random, {-2.1, -2.1, 0.1}, {6, 6, layers}, {blockSide, blockSide, blockSide}, 0.7);
}

void manyBodies(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    Pile pile(scene);
    // 50 x 50 columns of 20 cubes of 0.3 m: touching blocks, every layer moved by a little, as a wall that is let go.
    const int across = setting.small ? 16 : 50;
    const int layers = 20;
    constexpr double cube = 0.3;
    Sequence random(50000);
    for (int k = 0; k < layers; ++k) {
        for (int j = 0; j < across; ++j) {
            for (int i = 0; i < across; ++i) {
                const Quat turn(turnAbout(Vec3::UnitZ(), random.between(-0.05, 0.05)));
                pile.add({0.33 * i + random.between(-0.005, 0.005), 0.33 * j + random.between(-0.005, 0.005), cube * (k + 0.5)},
                         {cube, cube, cube}, turn);
            }
        }
    }
    EnergyWatch watch;
    watch.look(scene);
    double fastest = 0.0;
    const double height = layers * cube;
    for (int i = 0; i < 60; ++i) {
        scene.run(scene.dt);
        watch.look(scene);
        fastest = std::max(fastest, scene.maxSpeed());
    }
    const OverlapMeasure overlap = pile.overlap();
    outcome.none("centres below ground", static_cast<double>(pile.centresBelow(0.0)));
    outcome.atMost("99th percentile of overlap", overlap.p99, 0.05 * cube, "m");
    outcome.atMost("share of bodies deeper than 5 % of their side",
                   static_cast<double>(overlap.beyondFive) / static_cast<double>(pile.sizes().size()), 0.01);
    outcome.atMost("energy gained over that of gravity", watch.drift(), 1e-3);
    outcome.atMost("fastest over sqrt(2 g h)", fastest / std::sqrt(2.0 * scene.settings.gravity * height), 1.05);
}

/// The middle one of several.
double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

/// What heaps do in a minute after they have come to rest. Without freezing a block that leans may tip over at last, as stones do,
/// and one heap says nothing of others: what a middle heap does counts, and how many of all bodies rest.
void atRest(const CaseSetting& setting, Outcome& outcome) {
    const std::uint64_t heaps = setting.small ? 3 : 7;
    for (const bool freeze : {true, false}) {
        std::vector<double> asleep, sunk, moves, fastest;
        for (std::uint64_t heap = 0; heap < heaps; ++heap) {
            WorldScene scene(setting);
            scene.settings.freeze = freeze;
            Pile pile(scene);
            addHeap(pile, 60 + heap, setting.small ? 3 : 6);
            scene.run(12.0);
            const std::vector<Vec3> start = pile.places();
            const double height = pile.meanHeight();
            asleep.push_back(scene.asleep());
            fastest.push_back(0.0);
            for (int i = 0; i < 3600; ++i) {
                scene.run(scene.dt);
                fastest.back() = std::max(fastest.back(), scene.maxSpeed());
            }
            sunk.push_back(std::abs(pile.meanHeight() / height - 1.0));
            moves.push_back(pile.largestMove(start));
        }
        const std::string how = freeze ? "" : ", freezing off";
        const double resting = std::accumulate(asleep.begin(), asleep.end(), 0.0) / static_cast<double>(heaps);
        outcome.atLeast("share asleep after 12 s, mean of the heaps" + how, resting, 0.95);
        outcome.atMost("change of mean height in 60 s, middle heap" + how, median(sunk), freeze ? 0.001 : 0.01);
        outcome.atMost("largest move in 60 s, middle heap" + how, median(moves), freeze ? 0.01 : 0.1, "m");
        // A block that tips over through the 0.1 m it may move reaches sqrt(2 g 0.1).
        outcome.atMost("fastest in these 60 s, middle heap" + how, median(fastest), freeze ? 0.5 : 1.4, "m/s");
        if (freeze) {
            outcome.atMost("largest move in 60 s, any heap", std::ranges::max(moves), 0.1, "m");
        }
    }
}

/// Mean over seeds, and its standard error.
struct SeedMean {
    double mean = 0.0;
    double error = 0.0;

    explicit SeedMean(const std::vector<double>& values) {
        const auto n = static_cast<double>(values.size());
        for (const double value : values) {
            mean += value / n;
        }
        for (const double value : values) {
            error += (value - mean) * (value - mean) / (n * (n - 1.0));
        }
        error = std::sqrt(error);
    }
    /// Share by which it differs from another beyond two standard errors of the difference.
    double beyondChance(const SeedMean& other) const {
        return std::max(0.0, std::abs(mean - other.mean) - 2.0 * std::hypot(error, other.error)) / other.mean;
    }
};

struct PileMeasures {
    SeedMean height;
    SeedMean spread;
};

PileMeasures measuresAt(const CaseSetting& setting, double rate, int seeds) {
    std::vector<double> heights, spreads;
    for (int seed = 1; seed <= seeds; ++seed) {
        WorldScene scene(setting);
        scene.dt = 1.0 / rate;
        Pile pile(scene);
        addHeap(pile, static_cast<std::uint64_t>(seed), 5);
        scene.run(6.0);
        heights.push_back(pile.meanHeight());
        spreads.push_back(pile.spread());
    }
    return {SeedMean(heights), SeedMean(spreads)};
}

void stepHalved(const CaseSetting& setting, Outcome& outcome) {
    // One heap's averages repeat to a few per cent only (PHYSICS section 3): what seeds differ by is taken off.
    std::vector<PileMeasures> at;
    for (const double rate : {60.0, 120.0, 240.0, 480.0}) {
        at.push_back(measuresAt(setting, rate, 8));
    }
    outcome.atMost("change of mean height, 60 to 480 steps per second", at[0].height.beyondChance(at[3].height), 0.05);
    outcome.atMost("change of mean height, 240 to 480 steps per second", at[2].height.beyondChance(at[3].height), 0.025);
    outcome.atMost("change of spread, 60 to 480 steps per second", at[0].spread.beyondChance(at[3].spread), 0.05);
    outcome.atMost("change of spread, 240 to 480 steps per second", at[2].spread.beyondChance(at[3].spread), 0.025);
}

void otherGravity(const CaseSetting& setting, Outcome& outcome) {
    for (const double factor : {1.0 / 6.0, 10.0}) {
        WorldScene scene(setting);
        scene.settings.gravity *= factor;
        Pile pile(scene);
        addHeap(pile, 10, 6);
        EnergyWatch watch;
        watch.look(scene);
        double fastest = 0.0;
        const int steps = factor < 1.0 ? 900 : 360;
        for (int i = 0; i < steps; ++i) {
            scene.run(scene.dt);
            watch.look(scene);
            fastest = std::max(fastest, scene.maxSpeed());
        }
        const std::string at = factor < 1.0 ? ", g / 6" : ", 10 g";
        const OverlapMeasure overlap = pile.overlap();
        outcome.atMost("energy gained over that of gravity" + at, watch.drift(), 1e-3);
        outcome.atMost("fastest over sqrt(2 g h), h = 4.3 m" + at, fastest / std::sqrt(2.0 * scene.settings.gravity * 4.3), 1.05);
        outcome.atMost("99th percentile of overlap" + at, overlap.p99, 0.1 * blockSide, "m");
        outcome.none("centres below ground" + at, static_cast<double>(pile.centresBelow(0.0)));
    }
}

void heapWithFriction(const CaseSetting& setting, Outcome& outcome) {
    for (const double friction : {0.0, 2.0}) {
        WorldScene scene(setting);
        scene.settings.pairs = PairTable::uniform(friction, 0.1);
        // Without friction nothing stays: walls keep it together.
        for (const double at : {-1.0, 1.0}) {
            scene.piece({at * 4.0, 0, 2}, {1, 9, 4});
            scene.piece({0, at * 4.0, 2}, {7, 1, 4});
        }
        Pile pile(scene);
        addHeap(pile, 20, 6);
        EnergyWatch watch;
        watch.look(scene);
        double fastest = 0.0;
        for (int i = 0; i < 420; ++i) {
            scene.run(scene.dt);
            watch.look(scene);
            fastest = std::max(fastest, scene.maxSpeed());
        }
        const std::string at = ", friction " + englishNumber(friction);
        outcome.atMost("energy gained over that of gravity" + at, watch.drift(), 1e-3);
        outcome.atMost("fastest over sqrt(2 g h), h = 4.3 m" + at, fastest / std::sqrt(2.0 * scene.settings.gravity * 4.3), 1.05);
        outcome.atMost("99th percentile of overlap" + at, pile.overlap().p99, 0.1 * blockSide, "m");
        outcome.none("centres below ground" + at, static_cast<double>(pile.centresBelow(0.0)));
    }
}

}  // namespace

std::vector<HardCase> pileCases() {
    return {
        {"pile-50000", "50,000 touching blocks let go at once", "squeeze, explode, take for ever",
         "99 % overlap below 5 % of a side, gain below 0.1 %, no faster than a fall, none below ground", 90.0, manyBodies},
        {"pile-rest-60s", "seven heaps at rest for 60 s, with freezing and without", "creeps, boils, wakes",
         "mean height within 0.1 % (1 % without freezing), nobody above 0.5 m/s, in a middle heap", 80.0, atRest},
        {"step-halved", "the step halved three times", "another step, another pile",
         "mean height and spread within 5 % of the finest, the last halving within 2.5 %, beyond two standard errors of 8 seeds",
         40.0, stepHalved},
        {"gravity", "gravity of 1/6 and of 10 g", "squeezes, gains energy", "gain below 0.1 %, 99 % overlap below 10 % of a side",
         8.0, otherGravity},
        {"friction-pile", "a heap without friction, and with 2", "gains energy, squeezes",
         "gain below 0.1 %, 99 % overlap below 10 % of a side, none below ground", 5.0, heapWithFriction},
    };
}

}  // namespace rubble::selftest
