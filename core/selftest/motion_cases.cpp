#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/same_bits.h"
#include "core/base/standard_gravity.h"
#include "core/selftest/world_scene.h"

namespace rubble::selftest {

namespace {

Quat tilt(double degrees) {
    return Quat(turnAbout(Vec3::UnitY(), degrees * std::numbers::pi / 180.0));
}

std::string inUnits(double value, std::string_view unit) {
    return englishNumber(value) + " " + std::string(unit);
}

void freeFall(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    const BodyId body = scene.box({0, 0, 100}, {0.4, 0.5, 0.6}, {3, 0, 0}, Quat::Identity(), {1, 2, 3});
    scene.run(2.0);
    outcome.atMost("error of place after 2 s", (scene.place(body) - Vec3(6, 0, 100 - 0.5 * standardGravity * 4)).norm(), 1e-3, "m");
}

/// Height of the first bounce of a box that falls flat, over e^2 h.
double bounceRatio(const CaseSetting& setting, double restitution, double height, double rate) {
    WorldScene scene(setting);
    scene.dt = 1.0 / rate;
    scene.settings.pairs = PairTable::uniform(0.6, restitution);
    const BodyId body = scene.box({0, 0, 0.5 + height}, {1, 1, 1});
    const double fall = std::sqrt(2.0 * height / standardGravity);
    double top = 0.0;
    scene.run(fall * (1.0 + 1.8 * restitution), [&](double time) {
        if (time > fall + 1.5 * scene.dt) {
            top = std::max(top, scene.place(body).z() - 0.5);
        }
    });
    return top / (restitution * restitution * height);
}

void bounce(const CaseSetting& setting, Outcome& outcome) {
    for (const double restitution : {0.3, 0.5, 0.8}) {
        double least = 10.0, most = 0.0;
        for (const double height : {2.0, 3.1, 5.0}) {
            const double ratio = bounceRatio(setting, restitution, height, 60.0);
            least = std::min(least, ratio);
            most = std::max(most, ratio);
        }
        outcome.atLeast("lowest bounce over e2 h, e = " + englishNumber(restitution), least, 0.90);
        outcome.atMost("highest bounce over e2 h, e = " + englishNumber(restitution), most, 1.05);
        outcome.near("bounce over e2 h at 240 steps per second, e = " + englishNumber(restitution),
                     bounceRatio(setting, restitution, 3.1, 240.0), 1.0, 0.03);
    }
}

/// A block on an incline of friction 0.5.
struct Incline {
    Incline(const CaseSetting& setting, double degrees) : scene(setting), turn(tilt(degrees)) {
        scene.settings.pairs = PairTable::uniform(0.5, 0.1);
        scene.settings.ground = false;
        scene.piece(turn * Vec3(0, 0, -1), {80, 20, 2}, turn);
        body = scene.box(turn * Vec3(0, 0, 0.25), {1, 1, 0.5}, Vec3::Zero(), turn);
    }
    WorldScene scene;
    Quat turn;
    BodyId body{};
};

void inclineSticks(const CaseSetting& setting, Outcome& outcome) {
    Incline incline(setting, 26.0);
    const Vec3 start = incline.scene.place(incline.body);
    incline.scene.run(1.0);
    outcome.atMost("creep in 1 s at 26 degrees, friction 0.5", (incline.scene.place(incline.body) - start).norm(), 1e-3, "m");
}

void inclineSlides(const CaseSetting& setting, Outcome& outcome) {
    Incline incline(setting, 35.0);
    incline.scene.run(0.5);
    const double before = incline.scene.velocity(incline.body).norm();
    incline.scene.run(1.0);
    const double angle = 35.0 * std::numbers::pi / 180.0;
    const double law = standardGravity * (std::sin(angle) - 0.5 * std::cos(angle));
    outcome.atMost("error of acceleration at 35 degrees, friction 0.5",
                   std::abs(incline.scene.velocity(incline.body).norm() - before - law) / law, 0.005);
}

void slideToRest(const CaseSetting& setting, Outcome& outcome) {
    for (const double heading : {0.0, 37.0, 45.0}) {
        WorldScene scene(setting);
        scene.settings.pairs = PairTable::uniform(0.5, 0.1);
        const double angle = heading * std::numbers::pi / 180.0;
        const BodyId body = scene.box({0, 0, 0.15}, {1, 1, 0.3}, 5.0 * Vec3(cosineOf(angle), sineOf(angle), 0));
        scene.run(2.0);
        const Vec3 end = scene.place(body);
        const double law = 25.0 / (2.0 * 0.5 * standardGravity);
        const std::string at = ", heading " + inUnits(heading, "degrees");
        outcome.atMost("error of distance" + at, std::abs(end.head<2>().norm() - law) / law, 0.01);
        outcome.atMost("error of heading" + at, std::abs(std::atan2(end.y(), end.x()) - angle) * 180.0 / std::numbers::pi, 0.1,
                       "degrees");
    }
}

/// Does a block of height over breadth 3 fall over within 8 s on a plane of this tilt?
bool topples(const CaseSetting& setting, double degrees) {
    WorldScene scene(setting);
    scene.settings.pairs = PairTable::uniform(1.0, 0.0);
    scene.settings.ground = false;
    const Quat turn = tilt(degrees);
    scene.piece(turn * Vec3(0, 0, -1), {20, 20, 2}, turn);
    const BodyId body = scene.box(turn * Vec3(0, 0, 0.9), {0.6, 0.6, 1.8}, Vec3::Zero(), turn);
    for (int i = 0; i < 16; ++i) {
        scene.run(0.5);
        if ((scene.world().motion(body).pose.orientation * Vec3::UnitZ()).dot(turn * Vec3::UnitZ()) < 0.8) {
            return true;
        }
    }
    return false;
}

void topple(const CaseSetting& setting, Outcome& outcome) {
    double stands = 14.0, falls = 23.0;
    if (topples(setting, stands) || !topples(setting, falls)) {
        outcome.none("topples below 14 or stands above 23 degrees", 1);
        return;
    }
    while (falls - stands > 0.02) {
        const double middle = 0.5 * (stands + falls);
        (topples(setting, middle) ? falls : stands) = middle;
    }
    const double law = std::atan(1.0 / 3.0) * 180.0 / std::numbers::pi;
    outcome.near("angle at which h/b = 3 topples", 0.5 * (stands + falls), law, 0.3, "degrees");
}

void spinPlate(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    scene.settings.gravity = 0.0;
    scene.settings.ground = false;
    const BodyId body = scene.box({0, 0, 0}, {2.0, 1.0, 0.2}, Vec3::Zero(), Quat::Identity(), {2.0, 8.0, 3.0});
    const Momenta before = scene.world().momenta(body);
    double turning = 0.0, energy = 0.0;
    scene.run(5.0, [&](double) {
        const Momenta now = scene.world().momenta(body);
        turning = std::max(turning, (now.angular - before.angular).norm() / before.angular.norm());
        energy = std::max(energy, std::abs(now.kineticEnergy / before.kineticEnergy - 1.0));
    });
    outcome.atMost("error of angular momentum", turning, 1e-3);
    outcome.atMost("error of energy", energy, 0.01);
}

void frictionless(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    scene.settings.pairs = PairTable::uniform(0.0, 0.1);
    const BodyId body = scene.box({0, 0, 0.15}, {1, 1, 0.3}, {5, 0, 0});
    scene.run(3.0);
    outcome.atMost("speed lost in 3 s without friction", std::abs(scene.velocity(body).x() - 5.0) / 5.0, 1e-3);
    outcome.atMost("sideways speed", std::abs(scene.velocity(body).y()), 1e-3, "m/s");
}

void highFriction(const CaseSetting& setting, Outcome& outcome) {
    WorldScene scene(setting);
    scene.settings.pairs = PairTable::uniform(2.0, 0.1);
    scene.settings.ground = false;
    const Quat turn = tilt(60.0);
    scene.piece(turn * Vec3(0, 0, -1), {40, 20, 2}, turn);
    // Flat enough not to topple: h/b = 0.2 stands up to 78 degrees.
    const BodyId body = scene.box(turn * Vec3(0, 0, 0.1), {1, 1, 0.2}, Vec3::Zero(), turn);
    const Vec3 start = scene.place(body);
    scene.run(1.0);
    outcome.atMost("creep in 1 s at 60 degrees, friction 2", (scene.place(body) - start).norm(), 1e-3, "m");
}

}  // namespace

std::vector<HardCase> motionCases() {
    return {
        {"free-fall", "free fall for 2 s", "integration error g dt t / 2", "place within 1 mm", 0.1, freeFall},
        {"bounce", "a box bounces, restitution 0.3, 0.5, 0.8", "bounces higher than it fell, or not at all",
         "0.90 to 1.05 of e2 h at 60 steps per second, 1 +- 0.03 at 240", 0.3, bounce},
        {"incline-sticks", "block on an incline below its angle of friction", "creeps down", "below 1 mm in 1 s", 0.1,
         inclineSticks},
        {"incline-slides", "block on an incline above its angle of friction", "too fast or too slow", "acceleration within 0.5 %",
         0.1, inclineSlides},
        {"slide-to-rest", "a block slides from 5 m/s to rest", "stops elsewhere, veers off",
         "distance within 1 %, heading 0.1 degrees", 0.1, slideToRest},
        {"topple", "block of h/b = 3 on a tilted plane", "topples too early or too late", "within 0.3 degrees of 18.43", 2.0,
         topple},
        {"spin-plate", "free plate spins about no principal axis", "energy dies or grows",
         "angular momentum within 0.1 %, energy within 1 % over 5 s", 0.1, spinPlate},
        {"friction-0", "no friction at all", "slows down, slips into nonsense", "keeps its speed within 0.1 % for 3 s", 0.1,
         frictionless},
        {"friction-2", "friction of 2", "creeps, jumps", "below 1 mm in 1 s at 60 degrees", 0.1, highFriction},
    };
}

}  // namespace rubble::selftest
