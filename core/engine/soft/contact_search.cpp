#include "core/engine/soft/contact_search.h"

#include <chrono>

#include "core/base/elapsed.h"
#include "core/engine/soft/contact_wakes.h"

namespace rubble {

namespace {

using Clock = std::chrono::steady_clock;

/// Takes the time of some work from that of motion to what it was for.
template <class Work>
void timed(StepCosts& costs, double& cost, Work work) {
    const auto from = Clock::now();
    work();
    const double seconds = secondsSince(from);
    cost += seconds;
    costs.motion -= seconds;
}

}  // namespace

void ContactSearch::setOff(double dt) {
    m_scene.solids.clearSlots();
    m_scene.solids.listAwake(m_scene.sleep.still());
    m_scene.pool.loop(m_scene.solids.standing.size(), 64, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            setOffPiece(m_scene.solids.pieces[m_scene.solids.standing[i]], dt);
        }
    });
    m_scene.solids.listMoving();
    m_scene.pool.loop(m_scene.solids.awake.size(), 64, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            SoftBody& body = m_scene.solids.bodies[m_scene.solids.awake[i]];
            // Until its first step a body is given out just as it came.
            if (body.collider->newborn) {
                body.pose = throughAxes(body.pose);
            }
            m_scene.finder.place(body);
            m_scene.pairs.sweep(body.collider->number, m_scene.finder.sweep(body, dt));
            body.active = false;
            body.drivers = 0;
            body.collider->overlapping = false;
            body.collider->penetration = body.collider->overlapLeft = 0.0;
        }
    });
}

/// How a piece moves in this step, to where it was told to.
void ContactSearch::setOffPiece(SoftBody& piece, double dt) {
    piece.velocity = piece.spin = Vec3::Zero();
    m_scene.finder.stand(piece);
    if (piece.collider->moving) {
        const Pose& end = m_scene.solids.goals[piece.collider->index];
        piece.velocity = (end.position - piece.pose.position) / dt;
        const Quat q = end.orientation * piece.pose.orientation.conjugate();
        piece.spin = (q.w() < 0.0 ? -2.0 : 2.0) / dt * q.vec();
    }
    if (piece.collider->moving || piece.collider->newborn) {
        m_scene.finder.place(piece);
        m_scene.pairs.sweep(piece.collider->number, m_scene.finder.sweep(piece, dt));
    }
}

void ContactSearch::find(double dt, StepCosts& costs) {
    const auto from = Clock::now();
    m_scene.finder.begin();
    std::vector<std::uint32_t> stirring;
    stirring.reserve(m_scene.solids.awake.size() + m_scene.solids.standing.size());
    for (const std::uint32_t i : m_scene.solids.awake) {
        stirring.push_back(m_scene.solids.bodies[i].collider->number);
    }
    for (const std::uint32_t i : m_scene.solids.standing) {
        if (const Collider& piece = *m_scene.solids.pieces[i].collider; piece.moving || piece.newborn) {
            stirring.push_back(piece.number);
        }
    }
    m_scene.pairs.find(stirring);
    const NearPairs& pairs = m_scene.pairs.pairs();
    const double broad = secondsSince(from);
    const double count = static_cast<double>(pairs.structure.size() + pairs.fragments.size());
    if (count > 0.0) {
        costs.structureContact += broad * static_cast<double>(pairs.structure.size()) / count;
        costs.fragmentContact += broad * static_cast<double>(pairs.fragments.size()) / count;
        costs.motion -= broad;
    }
    timed(costs, costs.groundContact, [&] { m_scene.finder.collideWithGround(m_scene.solids.awake, dt); });
    timed(costs, costs.structureContact, [&] { m_scene.finder.collide(pairs.structure, dt); });
    timed(costs, costs.fragmentContact, [&] { m_scene.finder.collide(pairs.fragments, dt); });
    const auto woken =
        wokenByContacts(m_scene.finder.parts(), m_scene.solids, m_scene.sleep, m_scene.contacts.asleep(), m_scene.pool);
    if (!woken.empty()) {
        findOf(woken, dt, costs);
    }
}

/// Bodies that woke in this step take part in it from its start.
void ContactSearch::findOf(const std::vector<std::uint32_t>& woken, double dt, StepCosts& costs) {
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t i : woken) {
        SoftBody& body = m_scene.solids.bodies[i];
        m_scene.sleep.thaw(*body.collider, body.pose.position);
        body.active = false;
        body.drivers = 0;
        numbers.push_back(body.collider->number);
    }
    m_scene.solids.listAwake(m_scene.sleep.still());
    m_scene.solids.listMoving();
    // They were swept as bodies at rest.
    const NearPairs pairs = m_scene.pairs.ofWoken(numbers, m_scene.settings.gravity * dt * dt, m_scene.sleep);
    timed(costs, costs.structureContact, [&] { m_scene.finder.collide(pairs.structure, dt); });
    timed(costs, costs.fragmentContact, [&] { m_scene.finder.collide(pairs.fragments, dt); });
    timed(costs, costs.groundContact, [&] { m_scene.finder.collideWithGround(woken, dt); });
}

}  // namespace rubble
