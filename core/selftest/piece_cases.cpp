#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/message.h"
#include "core/base/same_bits.h"
#include "core/base/standard_gravity.h"
#include "core/engine/world/constants.h"
#include "core/selftest/pile.h"

namespace rubble::selftest {

namespace {

/// Deepest overlap of a pile's boxes with one box, m.
double deepestIn(WorldScene& scene, const Pile& pile, const OrientedBox& piece) {
    double deepest = 0.0;
    for (const OrientedBox& box : placedBoxes(scene.world(), pile.sizes())) {
        deepest = std::max(deepest, overlapOf(box, piece));
    }
    return deepest;
}

void risingPiece(const CaseSetting& setting, Outcome& outcome) {
    for (const double speed : {1.0, 5.0, 20.0}) {
        WorldScene scene(setting);
        scene.settings.ground = false;
        const auto floorAt = [&](double time) { return Vec3(0, 0, -0.5 + speed * std::max(0.0, time - 1.0)); };
        const PieceId floor = scene.piece(floorAt(0), {8, 8, 1});
        Pile pile(scene);
        for (int i = 0; i < 27; ++i) {
            pile.add({0.6 * (i % 3 - 1), 0.6 * (i / 3 % 3 - 1), 0.25 + 0.5 * (i / 9)}, {0.5, 0.5, 0.5});
        }
        double fastest = 0.0, deepest = 0.0;
        scene.run(1.0);
        for (int i = 0; i < 40; ++i) {
            scene.run(scene.dt, [&](double time) { scene.world().movePiece(floor, {floorAt(time), Quat::Identity()}); });
            fastest = std::max(fastest, scene.maxSpeed());
            deepest = std::max(deepest, deepestIn(scene, pile, {floorAt(scene.time()), Quat::Identity(), {4, 4, 0.5}}));
        }
        const std::string at = ", piece at " + englishNumber(speed) + " m/s";
        outcome.atMost("deepest in the piece" + at, deepest, 0.05, "m");
        outcome.atMost("fastest over the piece" + at, fastest / speed, 1.3);
    }
}

void closingPiece(const CaseSetting& setting, Outcome& outcome) {
    for (const double speed : {1.0, 5.0, 25.0}) {
        for (const bool ground : {false, true}) {
            WorldScene scene(setting);
            scene.settings.ground = ground;
            // Down onto a box that lies on the ground, or on a piece that stands still.
            if (!ground) {
                scene.piece({0, 0, -1}, {4, 4, 2});
            }
            const auto highAt = [&](double time) { return Vec3(0, 0, 3.0 - std::min(2.5, speed * time)); };
            const PieceId high = scene.piece(highAt(0), {4, 4, 2});
            const BodyId body = scene.box({0.1, 0.05, 0.5}, {1, 1, 1}, Vec3::Zero(), Quat(turnAbout(Vec3::UnitZ(), 0.3)));
            double fastest = 0.0;
            scene.run(3.0 / speed + 1.0, [&](double time) {
                scene.world().movePiece(high, {highAt(time), Quat::Identity()});
                fastest = std::max(fastest, scene.maxSpeed());
            });
            const double last = scene.maxSpeed();
            const std::string at = ", piece at " + englishNumber(speed) + " m/s" + (ground ? " on ground" : " on a piece");
            outcome.atMost("fastest over the piece" + at,
                           std::max(fastest, std::isnan(last) ? std::numeric_limits<double>::infinity() : last) / speed, 2.0);
            outcome.atLeast("height of the trapped centre" + at, scene.place(body).z(), 0.0, "m");
        }
    }
}

void carried(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    scene.settings.ground = false;
    const auto floorAt = [](double time) { return Vec3(2.0 * time, 0, -0.5); };
    const PieceId floor = scene.piece(floorAt(0), {30, 6, 1});
    const BodyId body = scene.box({0, 0, 0.25}, {1, 1, 0.5});
    const auto move = [&](double time) { scene.world().movePiece(floor, {floorAt(time), Quat::Identity()}); };
    scene.run(1.0, move);
    const Vec3 start = scene.place(body);
    scene.run(3.0, move);
    outcome.atMost("error of the way after the slip", std::abs((scene.place(body) - start).x() / 6.0 - 1.0), 0.01);
    outcome.atMost("sideways", std::abs(scene.place(body).y()), 0.01, "m");
}

void comingDown(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    Pile pile(scene);
    Sequence random(25);
    pile.addCloud(random, {-2.0, -2.0, 0.0}, {6, 6, 4}, {0.4, 0.4, 0.4}, 0.7);
    scene.run(4.0);
    double top = 0.0;
    for (const Vec3& place : pile.places()) {
        top = std::max(top, place.z());
    }
    const double start = scene.time();
    const auto deckAt = [&](double time) { return Vec3(0, 0, 8.0 - 25.0 * std::max(0.0, time - start)); };
    const PieceId deck = scene.piece(deckAt(start), {8, 8, 1});
    EnergyWatch watch;
    watch.look(scene);
    double fastest = 0.0, highest = 0.0;
    const auto look = [&] {
        watch.look(scene);
        fastest = std::max(fastest, scene.maxSpeed());
        for (const Vec3& place : pile.places()) {
            highest = std::max(highest, place.z());
        }
    };
    // Down to half a metre above ground, through the heap; then its elements die.
    for (int i = 0; i < 17; ++i) {
        scene.run(scene.dt, [&](double time) { scene.world().movePiece(deck, {deckAt(time), Quat::Identity()}); });
        look();
    }
    scene.world().removePiece(deck);
    for (int i = 0; i < 180; ++i) {
        scene.run(scene.dt);
        look();
    }
    // The piece may add piecePressSpeed, and what is on top may fall to the ground.
    outcome.atMost("fastest over sqrt(v_press^2 + 2 g h)",
                   fastest / std::sqrt(piecePressSpeed * piecePressSpeed + 2.0 * standardGravity * top), 1.05);
    outcome.atMost("rise of the highest centre", highest - top, 0.1, "m");
    outcome.atMost("energy gained beyond the work booked, over that of gravity", watch.drift(), 1e-3);
    outcome.none("centres below ground", static_cast<double>(pile.centresBelow(0.0)));
}

void supportDies(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    const PieceId deck = scene.piece({0, 0, 4}, {6, 6, 0.5});
    Pile pile(scene);
    Sequence random(5);
    pile.addCloud(random, {-2.0, -2.0, 4.3}, {5, 5, 3}, {0.4, 0.4, 0.4}, 0.75);
    scene.run(8.0);
    const double sleepers = scene.asleep();
    std::int64_t carried = 0;
    for (const Vec3& place : pile.places()) {
        carried += place.z() > 4.2;
    }
    scene.world().removePiece(deck);
    scene.run(0.5);
    // Half a second of free fall is 1.2 m; whoever hangs in the air has stayed.
    std::int64_t hanging = 0;
    for (const Vec3& place : pile.places()) {
        hanging += place.z() > 5.2;
    }
    scene.run(5.0);
    for (const Vec3& place : pile.places()) {
        hanging += !(place.z() < 2.0);
    }
    outcome.atLeast("bodies on the deck before it dies", static_cast<double>(carried), 60);
    outcome.atLeast("share asleep before the deck dies", sleepers, 0.95);
    outcome.none("bodies that hang in the air", static_cast<double>(hanging));
    outcome.none("centres below ground", static_cast<double>(pile.centresBelow(0.0)));
}

}  // namespace

std::vector<HardCase> pieceCases() {
    return {
        {"piece-rises", "a piece rises under a pile at 1, 5, 20 m/s", "runs into the pile, shoots it up",
         "at most 5 cm deep, bodies below 1.3 v", 0.5, risingPiece},
        {"piece-closes", "a piece closes on a trapped fragment at 1, 5, 25 m/s", "NaN, shot out, pressed into the ground",
         "below 2 v, centre above ground", 0.3, closingPiece},
        {"piece-carries", "a moving piece carries a fragment", "left behind", "travels within 1 % after the slip", 0.1, carried},
        {"piece-25", "a piece comes down on debris at 25 m/s", "launches it, presses it into the ground",
         "no faster than press and fall, no rise above 0.1 m, gain below 0.1 %", 2.0, comingDown},
        {"support-dies", "the support of a sleeping pile dies", "hangs in the air", "all fall within 0.5 s, none below ground", 2.0,
         supportDies},
    };
}

}  // namespace rubble::selftest
