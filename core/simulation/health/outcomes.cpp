#include "core/simulation/health/outcomes.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/health/value_archive.h"

namespace rubble {

namespace {

/// A change of velocity beyond this many times what gravity does in a step is a hit and not the load of lying there.
constexpr double hitOverRest = 1.5;
/// Bodies that one thread follows at a time.
constexpr std::size_t followGrain = 512;

bool isNumber(const BodyMotion& motion) {
    // One sum instead of thirteen questions: it is finite only if all its terms are.
    return std::isfinite(motion.pose.position.sum() + motion.pose.orientation.coeffs().sum() + motion.velocity.sum() +
                         motion.angularVelocity.sum());
}

Vec3 velocityAt(const BodyMotion& motion, const Vec3& place) {
    return motion.velocity + motion.angularVelocity.cross(place - motion.pose.position);
}

}  // namespace

Outcomes::Outcomes(const RunDescription& description, double gravity) : m_description(description), m_gravity(gravity) {
    for (const Fragment& f : description.fragments->list) {
        // What never becomes a body stays where it was.
        m_fragments.push_back({f.centre, f.velocity.norm(), f.centre, 0.0});
    }
    m_carried.resize(m_fragments.size(), false);
}

Vec3 Outcomes::placeOf(const Carrier& carrier, const Pose& body) const {
    return body * (carrier.handOverToBody * m_description.fragments->list[at(carrier.fragment)].centre);
}

void Outcomes::entered(const HandOver& handOver, const RigidWorld& world) {
    std::size_t next = 0;
    for (const BodyRecord& record : handOver.bodies) {
        TrackedBody body;
        body.mass = world.mass(record.body);
        body.latest = world.motion(record.body);
        body.birthEnergy = world.kineticEnergy(record.body) / body.mass;
        body.birthHeight = body.latest.pose.position.z();
        body.firstCarrier = static_cast<std::uint32_t>(m_carriers.size());
        while (next < handOver.carriers.size() && handOver.carriers[next].body == record.body) {
            carry(handOver.carriers[next++]);
        }
        body.carriers = static_cast<std::uint32_t>(m_carriers.size()) - body.firstCarrier;
        m_bodies.push_back(body);
    }
}

void Outcomes::carry(const Carrier& carrier) {
    const auto index = static_cast<std::uint32_t>(m_carriers.size());
    m_carriers.push_back(carrier);
    if (!m_carried[at(carrier.fragment)]) {
        m_carried[at(carrier.fragment)] = true;
        m_pending.push_back({m_description.fragments->list[at(carrier.fragment)].birthTime, index});
        return;
    }
    for (Pending& pending : m_pending) {
        if (m_carriers[pending.carrier].fragment == carrier.fragment) {
            pending.carrier = index;
        }
    }
}

bool Outcomes::follow(const RigidWorld& world, std::size_t i, const Vec3& fall) {
    const BodyId id = idAt<BodyId>(i);
    TrackedBody& body = m_bodies[i];
    if (world.state(id) == BodyState::Removed || body.lost) {
        return false;
    }
    const BodyMotion now = world.motion(id);
    if (!isNumber(now)) {
        body.lost = true;
        return true;
    }
    const double hit = (now.velocity - body.latest.velocity - fall).norm();
    if (hit > hitOverRest * fall.norm() && hit > body.hardest) {
        body.hardest = hit;
        body.before = body.latest;
    }
    body.latest = now;
    body.kinetic = world.kineticEnergy(id);
    return true;
}

void Outcomes::stepped(const RigidWorld& world, double time, double dt) {
    const Vec3 fall(0.0, 0.0, -m_gravity * dt);
    std::vector<char> followed(m_bodies.size());
    world.onThreads(m_bodies.size(), followGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            followed[i] = follow(world, i, fall);
        }
    });
    m_kinetic = m_massHeight = 0.0;
    m_lost.clear();
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        const TrackedBody& body = m_bodies[i];
        if (followed[i] == 0) {
            continue;
        }
        if (body.lost) {
            m_lost.push_back(idAt<BodyId>(i));
            continue;
        }
        m_maxSpeed = std::max(m_maxSpeed, body.latest.velocity.norm());
        m_kinetic += body.kinetic;
        m_massHeight += body.mass * body.latest.pose.position.z();
    }
    std::erase_if(m_pending, [&](const Pending& pending) {
        if (pending.time > time + 1e-9 * std::abs(time)) {
            return false;
        }
        const Carrier& carrier = m_carriers[pending.carrier];
        const BodyMotion& motion = m_bodies[at(carrier.body)].latest;
        const Vec3 place = placeOf(carrier, motion.pose);
        const Vec3 velocity = velocityAt(motion, place);
        FragmentOutcome& outcome = m_fragments[at(carrier.fragment)];
        // An exact birth time may lie within the step that has just ended.
        outcome.birthPosition = place - std::max(0.0, time - pending.time) * velocity;
        outcome.birthSpeed = velocity.norm();
        return true;
    });
}

void Outcomes::Pending::keep(Archive& archive) {
    archive(time, carrier);
}

void Outcomes::keep(Archive& archive) {
    const std::size_t fragments = m_fragments.size();
    archive(m_fragments, m_carriers, m_carried, m_bodies, m_lost, m_pending, m_maxSpeed, m_kinetic, m_massHeight);
    if (m_fragments.size() != fragments || m_carried.size() != fragments) {
        Archive::fail();
    }
}

void Outcomes::finish(const RigidWorld& world) {
    std::vector<double> hardest(m_fragments.size(), 0.0);
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        TrackedBody& body = m_bodies[i];
        if (!body.lost && world.state(idAt<BodyId>(i)) != BodyState::Removed) {
            body.latest = world.motion(idAt<BodyId>(i));
        }
        for (std::uint32_t c = body.firstCarrier; c < body.firstCarrier + body.carriers; ++c) {
            FragmentOutcome& outcome = m_fragments[at(m_carriers[c].fragment)];
            outcome.finalPosition = placeOf(m_carriers[c], body.latest.pose);
            double& hit = hardest[at(m_carriers[c].fragment)];
            if (body.hardest > hit) {
                hit = body.hardest;
                outcome.impactSpeed = velocityAt(body.before, placeOf(m_carriers[c], body.before.pose)).norm();
            }
        }
    }
}

}  // namespace rubble
