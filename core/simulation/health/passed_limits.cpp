#include "core/simulation/health/passed_limits.h"

#include <algorithm>
#include <array>
#include <limits>

namespace rubble {

namespace {

/// Bodies inside each other: of many of them, each a little.
bool ofManyBodies(const HealthBreach& breach) {
    return breach.check == HealthCheck::Penetration && breach.limit < HealthLimits{}.penetration;
}

bool tooLittle(const HealthBreach& breach) {
    return breach.check == HealthCheck::AsleepShare || (breach.check == HealthCheck::Bulking && breach.worst < breach.limit);
}

bool sameLimit(const HealthBreach& a, const HealthBreach& b) {
    return a.check == b.check && ofManyBodies(a) == ofManyBodies(b) &&
           (a.check != HealthCheck::Bulking || tooLittle(a) == tooLittle(b));
}

bool worseThan(const HealthBreach& a, const HealthBreach& b) {
    return tooLittle(a) ? a.worst < b.worst : a.worst > b.worst;
}

/// Up to which value a breach keeps its milder grade; NaN: it has one grade only.
double milderUpTo(const HealthBreach& breach, const HealthGradeLimits& limits) {
    switch (breach.check) {
        case HealthCheck::Energy:
            return limits.energyFinding;
        case HealthCheck::Penetration:
            return ofManyBodies(breach) ? limits.crowdFinding : limits.penetrationNotice;
        case HealthCheck::Speed:
            return limits.speedFinding;
        case HealthCheck::BelowGround:
            return limits.belowGroundFinding;
        case HealthCheck::AsleepShare:
            return limits.asleepNotice;
        case HealthCheck::Bulking:
            return tooLittle(breach) ? limits.bulkingLeast : limits.bulkingMost;
        case HealthCheck::OutsideSite:
        case HealthCheck::NotANumber:
            break;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// False also for a value that is no number, and for what has one grade only.
bool isMilder(const HealthBreach& breach, const HealthGradeLimits& limits) {
    const double bound = milderUpTo(breach, limits);
    return tooLittle(breach) ? breach.worst >= bound : breach.worst <= bound;
}

struct Reasons {
    Message milder;
    Message graver;
};

Reasons reasonsOf(const HealthBreach& breach, const Message& bound) {
    const std::string upTo = englishText(bound);
    switch (breach.check) {
        case HealthCheck::Energy:
            return {{"health.energy.milder", "up to {0} single bodies move otherwise, and hardly the shape of the debris", {upTo}},
                    {"health.energy.graver", "beyond {0} debris is thrown farther than it can fall", {upTo}}};
        case HealthCheck::Penetration:
            if (ofManyBodies(breach)) {
                return {{"health.crowd.milder", "up to {0} of the bodies the pile lies only a little too low", {upTo}},
                        {"health.crowd.graver",
                         "with more than {0} of the bodies the pile is squeezed into itself: its heights are too small",
                         {upTo}}};
            }
            return {
                {"health.penetration.milder", "it is single bodies, no deeper than they are thick: the pile keeps its shape", {}},
                {"health.penetration.graver",
                 "deeper than it is thick a body has gone through another: where it lies means nothing",
                 {}}};
        case HealthCheck::Speed:
            return {{"health.speed.milder", "up to {0} single bodies fly too far", {upTo}},
                    {"health.speed.graver", "beyond {0} something launched it, and whatever it hit", {upTo}}};
        case HealthCheck::BelowGround:
            return {{"health.below_ground.milder", "up to {0} it has sunk in: it lies a little too low", {upTo}},
                    {"health.below_ground.graver", "deeper than {0} it has fallen through the ground and lies nowhere", {upTo}}};
        case HealthCheck::OutsideSite:
            return {{},
                    {"health.outside_site.graver",
                     "nothing of this collapse falls there: the FE result threw it, or it is an error; covered area and run-out "
                     "hold it",
                     {}}};
        case HealthCheck::NotANumber:
            return {{}, {"health.not_a_number.graver", "its mass is missing from then on", {}}};
        case HealthCheck::AsleepShare:
            return {
                {"health.asleep_share.milder", "at least {0} stayed at rest: the end comes later, the pile is the same", {upTo}},
                {"health.asleep_share.graver", "less than {0} stayed at rest: the pile was not at rest before", {upTo}}};
        case HealthCheck::Bulking:
            break;
    }
    return tooLittle(breach)
               ? Reasons{{"health.bulking_low.milder", "the pile lies too low, yet holds its material", {}},
                         {"health.bulking_low.graver", "a pile smaller than its material lies inside itself", {}}}
               : Reasons{{"health.bulking_high.milder", "up to {0} the pile lies too high, and in its place", {upTo}},
                         {"health.bulking_high.graver", "beyond {0} heights and volumes are those of its shapes", {upTo}}};
}

}  // namespace

std::string_view healthGradeName(HealthGrade grade) {
    static constexpr std::array<std::string_view, 3> names{"notice", "finding", "tainted"};
    return names[static_cast<std::size_t>(grade)];
}

HealthGrade gradeOf(const HealthBreach& breach, const HealthGradeLimits& limits) {
    const bool milder = isMilder(breach, limits);
    if (breach.check == HealthCheck::AsleepShare || (breach.check == HealthCheck::Penetration && !ofManyBodies(breach))) {
        return milder ? HealthGrade::Notice : HealthGrade::Finding;
    }
    return milder ? HealthGrade::Finding : HealthGrade::Tainted;
}

Message gradeReason(const HealthBreach& breach, const HealthGradeLimits& limits) {
    const Reasons reasons = reasonsOf(breach, healthMeasure(breach.check, milderUpTo(breach, limits)));
    return isMilder(breach, limits) ? reasons.milder : reasons.graver;
}

std::vector<PassedLimit> passedLimits(std::span<const HealthBreach> breaches) {
    std::vector<PassedLimit> list;
    for (std::size_t i = 0; i < breaches.size(); ++i) {
        const auto same = std::find_if(list.begin(), list.end(), [&](const PassedLimit& limit) {
            return sameLimit(breaches[limit.breaches.front()], breaches[i]);
        });
        if (same == list.end()) {
            list.push_back({breaches[i].check, gradeOf(breaches[i]), i, {i}});
            continue;
        }
        same->breaches.push_back(i);
        same->grade = std::max(same->grade, gradeOf(breaches[i]));
        if (worseThan(breaches[i], breaches[same->worst])) {
            same->worst = i;
        }
    }
    return list;
}

HealthGrade gravestGrade(std::span<const HealthBreach> breaches) {
    HealthGrade grade = HealthGrade::Notice;
    for (const HealthBreach& breach : breaches) {
        grade = std::max(grade, gradeOf(breach));
    }
    return grade;
}

double heldFor(const PassedLimit& limit, std::span<const HealthBreach> breaches) {
    double seconds = 0.0;
    for (const std::size_t i : limit.breaches) {
        seconds += breaches[i].to - breaches[i].from;
    }
    return seconds;
}

Message healthMeasure(HealthCheck check, double value) {
    switch (check) {
        case HealthCheck::Energy:
        case HealthCheck::AsleepShare:
            return {"health.measure.share", "{0}", {Argument(100.0 * value, "%")}};
        case HealthCheck::Penetration:
            // From one on it is no part of the side any more.
            if (!(value >= 1.0)) {
                return {"health.measure.share", "{0}", {Argument(100.0 * value, "%")}};
            }
            [[fallthrough]];
        case HealthCheck::Speed:
        case HealthCheck::Bulking:
            return {"health.measure.times", "{0}×", {value}};
        case HealthCheck::BelowGround:
        case HealthCheck::OutsideSite:
            return {"health.measure.length", "{0}", {Argument(value, "m")}};
        case HealthCheck::NotANumber:
            break;
    }
    return {"health.measure.no_number", "no number", {}};
}

std::optional<Message> thinPile(double bulking, std::span<const HealthBreach> breaches, const HealthLimits& limits) {
    const bool outside = bulking < limits.bulkingLow || bulking > limits.bulkingHigh;
    if (!outside ||
        std::any_of(breaches.begin(), breaches.end(), [](const HealthBreach& b) { return b.check == HealthCheck::Bulking; })) {
        return std::nullopt;
    }
    return Message{"health.thin_pile",
                   "outside the {0} to {1} of a pile, yet no pile to judge: the debris lies less than {2} fragments deep",
                   {englishNumber(limits.bulkingLow), englishNumber(limits.bulkingHigh), englishNumber(limits.bulkingLayers)}};
}

std::string bodiesText(std::int64_t count) {
    return count == 1 ? std::string("1 body") : englishInteger(count) + " bodies";
}

}  // namespace rubble
