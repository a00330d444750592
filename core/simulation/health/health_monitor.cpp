#include "core/simulation/health/health_monitor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/simulation/health/passed_limits.h"
#include "core/simulation/health/value_archive.h"

namespace rubble {

namespace {

/// m. Rounding of a centre that lies on the ground.
constexpr double groundSlack = 1e-6;
/// m/s. A body slower than this is never too fast, whatever its birth.
constexpr double speedFloor = 1.0;

}  // namespace

HealthMonitor::HealthMonitor(const HealthSite& site, const HealthLimits& limits)
    : m_site(site), m_limits(limits), m_log(limits.interval, site.settings) {
    if (!site.structure.isEmpty()) {
        m_reach = limits.siteHeights * std::max(1.0, site.structure.sizes().z());
    }
}

void HealthMonitor::take(const RigidWorld& world, std::span<const TrackedBody> bodies, double time) {
    for (std::size_t i = m_bodies.size(); i < bodies.size(); ++i) {
        const TrackedBody& body = bodies[i];
        Watched watched;
        watched.side = world.smallestSide(idAt<BodyId>(i));
        watched.entered = time;
        watched.energy = body.birthEnergy + m_site.gravity * body.birthHeight;
        const Vec3& place = body.latest.pose.position;
        watched.bornBelow = m_site.surface.depth({place.x(), place.y(), body.birthHeight}) > 0.0;
        m_topEnergy = std::max(m_topEnergy, watched.energy);
        m_bodies.push_back(watched);
    }
}

void HealthMonitor::stepped(const RigidWorld& world, std::span<const TrackedBody> bodies, const HealthStep& step) {
    const bool entered = bodies.size() > m_bodies.size();
    take(world, bodies, step.time);
    m_deep = m_crowd = m_fast = m_below = m_outside = m_gain = Tally{};
    m_present = m_frozen = 0;
    m_movingDeep = m_movingCrowd = false;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const BodyState state = world.state(idAt<BodyId>(i));
        if (state == BodyState::Removed || bodies[i].lost) {
            continue;
        }
        Watched& watched = m_bodies[i];
        const bool frozen = state == BodyState::Frozen;
        ++m_present;
        m_frozen += frozen;
        // What rests since the step before is as it was.
        if (!frozen || !watched.wasFrozen) {
            watchPenetration(watched, world.penetration(idAt<BodyId>(i)), step.time);
            watchSpeed(world, i, bodies[i]);
            watchPlace(watched, bodies[i].latest.pose.position, step.time);
        }
        watched.wasFrozen = frozen;
        if (step.time - watched.deepSince > m_limits.sustained + 1e-9) {
            m_deep.add(i, watched.share, watched.deepSince);
            m_movingDeep = m_movingDeep || !frozen;
            watched.everDeep = true;
        }
        if (step.time - watched.crowdSince > m_limits.sustained + 1e-9) {
            m_crowd.add(i, watched.share, watched.crowdSince);
            m_movingCrowd = m_movingCrowd || !frozen;
        }
        if (watched.below > 0.0) {
            m_below.add(i, watched.below, step.time);
        }
        if (watched.outside > 0.0) {
            m_outside.add(i, watched.outside, step.time);
        }
    }
    m_report.contactsPeak = std::max(m_report.contactsPeak, world.contacts().pairs);
    note(HealthCheck::Speed, m_fast, m_limits.speed, bodies, step.time);
    note(HealthCheck::BelowGround, m_below, 0.0, bodies, step.time);
    if (m_outside.bodies > 0) {
        note(HealthCheck::OutsideSite, m_outside, reachAt(bodies[m_outside.body].latest.pose.position), bodies, step.time);
    }
    notePenetration(bodies, step.time);
    noteEnergy(step, bodies);
    noteSleep(step.time, step.stirred || entered);
}

void HealthMonitor::watchPenetration(Watched& watched, double depth, double time) const {
    watched.share = watched.side > 0.0 ? depth / watched.side : 0.0;
    if (!(watched.share > m_limits.crowdPenetration)) {
        watched.crowdSince = never;
    } else if (watched.crowdSince == never) {
        watched.crowdSince = time;
    }
    if (!(watched.share > m_limits.penetration)) {
        watched.deepSince = never;
    } else if (watched.deepSince == never) {
        watched.deepSince = time;
    }
}

double HealthMonitor::allowedSpeedSquared(const TrackedBody& body, double lifted, double push) const {
    const double z = body.latest.pose.position.z();
    double fall = body.birthHeight + lifted - z;
    double own = 2.0 * body.birthEnergy + speedFloor * speedFloor / (m_limits.speed * m_limits.speed);
    if (m_site.waterLevel) {
        // Buoyancy lifts what is lighter than water; the current carries.
        fall = z < *m_site.waterLevel ? std::abs(fall) : fall;
        own += m_site.current * m_site.current;
    }
    own += 2.0 * m_site.gravity * std::max(0.0, fall);
    // What another body pushes goes with the point that pushes it.
    if (push > noPush) {
        own = std::max(own, 2.0 * (push - m_site.gravity * z));
    }
    // What was hit may be as fast as whatever hit it.
    return body.hardest > 0.0 ? std::max(own, 2.0 * (m_topEnergy - m_site.gravity * z)) : own;
}

void HealthMonitor::watchSpeed(const RigidWorld& world, std::size_t index, const TrackedBody& body) {
    Watched& watched = m_bodies[index];
    const double speedSquared = body.latest.velocity.squaredNorm();
    const double push = world.handedEnergy(idAt<BodyId>(index));
    const double allowed = allowedSpeedSquared(body, world.lifted(idAt<BodyId>(index)), push);
    const double energy = 0.5 * speedSquared + m_site.gravity * body.latest.pose.position.z();
    if (push > noPush) {
        // It may hand on what it got.
        m_topEnergy = std::max(m_topEnergy, std::min(energy, push));
    }
    m_gain.add(index, body.mass * (energy - watched.energy), never);
    watched.energy = energy;
    if (speedSquared <= m_report.fastestOverLimit * m_report.fastestOverLimit * allowed &&
        speedSquared <= m_limits.speed * m_limits.speed * allowed) {
        return;
    }
    if (world.pushedByPiece(idAt<BodyId>(index))) {
        // It brought in what the piece gave it, and may hand that on.
        m_topEnergy = std::max(m_topEnergy, energy);
        return;
    }
    const double ratio = std::sqrt(speedSquared / allowed);
    m_report.fastestOverLimit = std::max(m_report.fastestOverLimit, ratio);
    if (ratio > m_limits.speed) {
        m_fast.add(index, ratio, never);
        watched.everFast = true;
    }
}

void HealthMonitor::watchPlace(Watched& watched, const Vec3& place, double time) {
    const double depth = m_site.surface.depth(place);
    watched.bornBelow = watched.bornBelow && depth > 0.0;
    const bool mayComeUp = watched.bornBelow && time - watched.entered <= m_limits.bornBelowGrace;
    watched.below = depth > groundSlack && !mayComeUp ? depth : 0.0;
    watched.everBelow = watched.everBelow || watched.below > 0.0;
    if (m_site.structure.isEmpty()) {
        return;
    }
    const double squared = m_site.structure.squaredExteriorDistance(place);
    if (squared > m_report.farthest * m_report.farthest) {
        m_report.farthest = std::sqrt(squared);
    }
    watched.outside = 0.0;
    if (squared > m_reach * m_reach && squared > reachAt(place) * reachAt(place)) {
        watched.outside = std::sqrt(squared);
    }
    watched.everOutside = watched.everOutside || watched.outside > 0.0;
}

double HealthMonitor::reachAt(const Vec3& place) const {
    if (!m_site.surface.terrain) {
        return m_reach;
    }
    const double drop = m_site.structure.min().z() - m_site.surface.height(place.x(), place.y());
    return m_reach + m_limits.siteHeights * std::max(0.0, drop);
}

void HealthMonitor::note(HealthCheck check, const Tally& tally, double limit, std::span<const TrackedBody> bodies, double time) {
    if (tally.bodies == 0) {
        return;
    }
    HealthObservation seen;
    seen.check = check;
    seen.measured = seen.severity = tally.measured;
    seen.limit = limit;
    seen.body = idAt<BodyId>(tally.body);
    seen.place = bodies[tally.body].latest.pose.position;
    seen.bodies = tally.bodies;
    m_log.hold(seen, time, time);
}

void HealthMonitor::notePenetration(std::span<const TrackedBody> bodies, double time) {
    HealthObservation seen;
    seen.check = HealthCheck::Penetration;
    const auto hold = [&](const Tally& tally, double measured, double limit, bool moving) {
        seen.measured = measured;
        seen.limit = limit;
        seen.severity = measured / limit;
        seen.body = idAt<BodyId>(tally.body);
        seen.place = bodies[tally.body].latest.pose.position;
        seen.depth = tally.measured * m_bodies[tally.body].side;
        seen.bodies = tally.bodies;
        m_log.hold(seen, tally.since, time);
        // Smaller steps move nothing that rests.
        if (moving) {
            m_unwell = time;
        }
    };
    if (m_deep.bodies > 0) {
        hold(m_deep, m_deep.measured, m_limits.penetration, m_movingDeep);
    }
    if (m_crowd.bodies == 0) {
        return;
    }
    const double share = static_cast<double>(m_crowd.bodies) / static_cast<double>(m_present);
    m_report.crowdShare = std::max(m_report.crowdShare, share);
    m_report.penetrationShare = std::max(m_report.penetrationShare, m_crowd.measured);
    m_report.penetrationSustained = std::max(m_report.penetrationSustained, m_crowd.measured * m_bodies[m_crowd.body].side);
    if (share > m_limits.crowd) {
        hold(m_crowd, share, m_limits.crowd, m_movingCrowd);
    }
}

void HealthMonitor::noteEnergy(const HealthStep& step, std::span<const TrackedBody> bodies) {
    if (!(step.energyGain > m_limits.energyGain)) {
        return;
    }
    HealthObservation seen;
    seen.check = HealthCheck::Energy;
    seen.measured = seen.severity = step.energyGain;
    seen.limit = m_limits.energyGain;
    if (m_gain.bodies > 0 && m_gain.measured > 0.0) {
        seen.body = idAt<BodyId>(m_gain.body);
        seen.place = bodies[m_gain.body].latest.pose.position;
        seen.bodies = 1;
    }
    m_log.hold(seen, step.time, step.time);
    m_unwell = step.time;
}

void HealthMonitor::noteSleep(double time, bool stirred) {
    if (m_present == 0) {
        return;
    }
    const double share = static_cast<double>(m_frozen) / static_cast<double>(m_present);
    m_report.asleepPeak = std::max(m_report.asleepPeak, share);
    m_rested = stirred ? 0.0 : std::max(m_rested, share);
    const double slack = std::max(m_limits.asleepSlack, 1.0 / static_cast<double>(m_present));
    if (m_rested >= m_limits.asleep && share < m_limits.asleep - slack - 1e-12) {
        HealthObservation seen;
        seen.check = HealthCheck::AsleepShare;
        seen.measured = share;
        seen.limit = m_limits.asleep;
        seen.severity = 1.0 - share;
        seen.bodies = m_present - m_frozen;
        m_log.hold(seen, time, time);
    }
}

void HealthMonitor::lost(BodyId body, const Vec3& place, double time) {
    HealthObservation seen;
    seen.check = HealthCheck::NotANumber;
    seen.measured = std::numeric_limits<double>::quiet_NaN();
    seen.body = body;
    seen.place = place;
    seen.bodies = ++m_report.bodiesLost;
    // The first of a breach is the one to look at.
    m_log.hold(seen, time, time);
}

void HealthMonitor::pile(double bulking, double layers, double time) {
    const bool low = bulking < m_limits.bulkingLow;
    const bool high = bulking > m_limits.bulkingHigh;
    if (!(low || high) || !(layers >= m_limits.bulkingLayers)) {
        return;
    }
    HealthObservation seen;
    seen.check = HealthCheck::Bulking;
    seen.measured = bulking;
    seen.limit = low ? m_limits.bulkingLow : m_limits.bulkingHigh;
    m_log.hold(seen, time, time);
}

void HealthMonitor::remedied(double from, double to) {
    if (m_report.remedies.empty() || from > m_report.remedies.back().to + 1e-9) {
        m_report.remedies.push_back({from, to, 0});
    }
    m_report.remedies.back().to = to;
    ++m_report.remedies.back().steps;
}

void HealthMonitor::keep(Archive& archive) {
    // The breaches of the report are the log's.
    archive(m_bodies, m_log, m_report.remedies, m_report.penetrationSustained, m_report.penetrationShare, m_report.crowdShare,
            m_report.fastestOverLimit, m_report.farthest, m_report.asleepPeak, m_report.contactsPeak, m_report.bodiesLost,
            m_topEnergy, m_unwell, m_rested);
}

HealthReport HealthMonitor::report() const {
    HealthReport report = m_report;
    report.breaches = m_log.breaches();
    return report;
}

namespace {

struct FindingText {
    const char* id;
    const char* pattern;
};

std::string timesText(std::int64_t count) {
    return count == 1 ? std::string("once") : englishInteger(count) + " times";
}

/// In the order of the checks; {0} is how many.
constexpr std::array<FindingText, healthCheckCount> findingTexts{
    {{"simulation.energy_gain", "energy rose beyond what gravity, births, pieces and effects put in, {0}"},
     {"simulation.penetration", "in the course of the run {0} lay inside others for over 0.5 s"},
     {"simulation.too_fast", "faster than gravity and their birth allow, in the course of the run: {0}"},
     {"simulation.below_ground", "below the ground, in the course of the run: {0}"},
     {"simulation.outside_site",
      "{0} went further from the structure than 10 times its height (taken as 1 m at least) and the drop of the terrain"},
     {"simulation.not_a_number", "{0} became no number and left the simulation"},
     {"simulation.pile_woke", "a pile at rest woke again, {0}"},
     {"simulation.bulking", "the pile has not the volume that rubble has"}}};

}  // namespace

void HealthMonitor::addFindings(Findings& findings) const {
    std::array<std::int64_t, healthCheckCount> counts{};
    std::array<const HealthBreach*, healthCheckCount> worst{};
    const std::vector<HealthBreach> breaches = m_log.breaches();
    const auto countOf = [&](HealthCheck check) -> std::int64_t& { return counts[static_cast<std::size_t>(check)]; };
    for (const HealthBreach& breach : breaches) {
        ++countOf(breach.check);
        const HealthBreach*& most = worst[static_cast<std::size_t>(breach.check)];
        if (most == nullptr || breach.bodies > most->bodies) {
            most = &breach;
        }
    }
    const auto countBodies = [&](HealthCheck check, bool Watched::* ever) {
        if (countOf(check) > 0) {
            countOf(check) = std::count_if(m_bodies.begin(), m_bodies.end(), [ever](const Watched& w) { return w.*ever; });
        }
    };
    countBodies(HealthCheck::Penetration, &Watched::everDeep);
    countBodies(HealthCheck::Speed, &Watched::everFast);
    countBodies(HealthCheck::BelowGround, &Watched::everBelow);
    countBodies(HealthCheck::OutsideSite, &Watched::everOutside);
    countOf(HealthCheck::NotANumber) = m_report.bodiesLost;
    for (std::size_t i = 0; i < healthCheckCount; ++i) {
        if (counts[i] > 0) {
            const auto check = static_cast<HealthCheck>(i);
            const bool ofTimes = check == HealthCheck::Energy || check == HealthCheck::AsleepShare;
            const std::string many = ofTimes ? timesText(counts[i]) : bodiesText(counts[i]);
            findings.add({findingTexts[i].id, findingTexts[i].pattern, {many}}, worst[i]->remedy, englishText(worst[i]->what),
                         counts[i]);
        }
    }
    std::int64_t steps = 0;
    for (const HealthRemedy& remedy : m_report.remedies) {
        steps += remedy.steps;
    }
    if (steps > 0) {
        findings.add({"simulation.auto_remedy", "{0} steps were halved after health breaches", {steps}},
                     {"simulation.auto_remedy.remedy", "raise step_rate for the whole run, or set auto_remedy = false", {}}, "",
                     steps);
    }
}

}  // namespace rubble
