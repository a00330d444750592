#include <algorithm>
#include <cmath>
#include <string>

#include "core/selftest/pile.h"

namespace rubble::selftest {

namespace {

/// A tower of cubes of 0.5 m after 10 s.
void tower(const CaseSetting& setting, Outcome& outcome, int blocks, double driftLimit) {
    WorldScene scene(setting);
    Pile pile(scene);
    for (int i = 0; i < blocks; ++i) {
        pile.add({0, 0, 0.5 * i + 0.25}, {0.5, 0.5, 0.5});
    }
    const std::vector<Vec3> start = pile.places();
    scene.run(10.0);
    double drift = 0.0;
    for (std::size_t i = 0; i < start.size(); ++i) {
        drift = std::max(drift, (scene.place(idAt<BodyId>(i)) - start[i]).head<2>().norm());
    }
    outcome.atMost("sideways drift in 10 s", drift, driftLimit, "m");
    outcome.atLeast("height of the top block over its start", scene.place(idAt<BodyId>(start.size() - 1)).z() / start.back().z(),
                    0.95);
    outcome.atLeast("share asleep", scene.asleep(), 1.0);
}

void tower10(const CaseSetting& setting, Outcome& outcome) {
    tower(setting, outcome, 10, 0.02);
}

void tower20(const CaseSetting& setting, Outcome& outcome) {
    tower(setting, outcome, 20, 0.10);
}

void plates(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    Pile pile(scene);
    for (int i = 0; i < 20; ++i) {
        pile.add({0, 0, 0.02 * i + 0.01}, {1.0, 1.0, 0.02});
    }
    scene.run(5.0);
    outcome.atLeast("height of the top plate over 0.39 m", scene.place(idAt<BodyId>(19)).z() / 0.39, 0.95);
    outcome.atMost("deepest overlap over the thickness", pile.overlap().deepestShare, 0.25);
}

/// Walls of 1 m around a square shaft.
void addShaft(WorldScene& scene, double width, double height) {
    const double at = 0.5 * width + 0.5;
    for (const double side : {-1.0, 1.0}) {
        scene.piece({side * at, 0, 0.5 * height}, {1.0, width + 2.0, height});
        scene.piece({0, side * at, 0.5 * height}, {width, 1.0, height});
    }
}

void shaft(const CaseSetting& setting, Outcome& outcome) {
    constexpr double width = 1.6;
    WorldScene scene(setting);
    const int layers = setting.small ? 34 : 100;
    addShaft(scene, width, 0.53 * layers + 1.0);
    Pile pile(scene);
    Sequence random(900);
    // 3 x 3 a layer, further apart than their diagonals.
    pile.addCloud(random, {-0.795, -0.795, 0.0}, {3, 3, layers}, {0.3, 0.3, 0.3}, 0.53);
    scene.run(setting.small ? 6.0 : 9.0);
    outcome.atMost("solid fraction", pile.volume() / (width * width * 2.0 * pile.meanHeight()), 0.70);
    outcome.none("centres below ground", static_cast<double>(pile.centresBelow(0.0)));
    // A soft-step solver leaves 0.04 to 0.05 m between boxes of 0.3 m that fall in a stack (PHYSICS section 1).
    outcome.atMost("99th percentile of overlap", pile.overlap().p99, 0.05, "m");
}

}  // namespace

std::vector<HardCase> stackCases() {
    return {
        {"tower-10", "tower of 10 blocks for 10 s", "leans, falls, never sleeps", "stands, asleep, drifts less than 2 cm", 0.2,
         tower10},
        {"tower-20", "tower of 20 blocks for 10 s", "leans, falls, never sleeps", "stands, asleep, drifts less than 10 cm", 0.4,
         tower20},
        {"plates-2cm", "20 plates of 2 cm in a stack", "sink into each other", "at least 95 % of the height after 5 s", 0.4,
         plates},
        {"shaft-900", "900 boxes dropped into a shaft of 1.6 m", "squeeze into each other",
         "solid fraction at most 0.70, none below ground, 99 % overlap less than 5 cm", 12.0, shaft},
    };
}

}  // namespace rubble::selftest
