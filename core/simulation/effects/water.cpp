#include "core/simulation/effects/water.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/simulation/effects/submerged_box.h"

namespace rubble {

/// A body in the water.
struct Water::Wet {
    SubmergedBox below;
    OrientedBox box;         ///< in the world
    double share = 0.0;      ///< of the box that is under water
    double displaced = 0.0;  ///< kg
    double perArea = 0.0;    ///< N/m3, what a square metre of waterplane gains in buoyancy per metre
};

Water::Water(const EffectSettings& settings, double gravity)
    : m_level(settings.waterLevel.value_or(0.0)),
      m_density(settings.waterDensity),
      m_current(settings.currentX, settings.currentY, 0.0),
      m_drag(settings.waterDrag),
      m_linearDrag(settings.waterLinearDrag),
      m_addedMass(settings.addedMass),
      m_gravity(gravity) {
    assert(settings.waterLevel);
}

Vec3 Water::meanVelocity(const MovingBody& body, const Vec3& contact, double h) const {
    const double least = 1e-6 * m_gravity * h / body.inverseMass;
    return contact.norm() > least ? body.velocity : Vec3(body.velocity + Vec3(0.0, 0.0, 0.5 * m_gravity * h));
}

void Water::carry(MovingBody& body, const Wet& wet, double h) {
    const double mass = 1.0 / body.inverseMass;
    // What contacts did in the substep before stands for what they will do in this one.
    const Expected& expected = m_expected[at(body.id)];
    Vec3 contact = Vec3::Zero();
    if (expected.substep > 0 && expected.substep + 1 == m_substep) {
        contact = mass * (body.velocity - expected.velocity);
    }
    const Vec3 velocity = meanVelocity(body, contact, h);
    const Vec3 relative = velocity - m_current;
    const double speed = relative.norm();
    const double area = speed > 0.0 ? wet.share * projectedArea(wet.box, relative / speed) : 0.0;
    const double resistance = 0.5 * m_density * m_drag * area * speed + m_linearDrag * wet.displaced;
    const double inert = mass + m_addedMass * wet.displaced;
    const double heave = wet.perArea * wet.below.waterplane;
    const double full = wet.perArea * wet.box.volume();
    const double buoyancy = std::clamp(m_gravity * wet.displaced - heave * h * velocity.z(), 0.0, full);

    Vec3 impulse = contact - h * resistance * relative;
    impulse.z() += h * (buoyancy - mass * m_gravity);
    Vec3 change = impulse / (inert + h * resistance);
    change.z() = impulse.z() / (inert + h * resistance + h * h * heave);
    // The world adds its gravity and its contacts to this, without knowing of the added mass.
    body.velocity += change - contact * body.inverseMass + Vec3(0.0, 0.0, m_gravity * h);
}

void Water::turn(MovingBody& body, const Wet& wet, double h) const {
    const Mat3 axes = wet.box.orientation.toRotationMatrix();
    const Mat3 principal = body.orientation.toRotationMatrix();
    const Mat3 inertia = principal * body.inertia.asDiagonal() * principal.transpose();
    const Vec3 spin = axes.transpose() * body.spin;
    const Vec3& half = wet.box.halfExtents;
    Vec3 strips;
    for (int i = 0; i < 3; ++i) {
        const double b = half[(i + 1) % 3], c = half[(i + 2) % 3];
        strips[i] = 0.5 * m_density * m_drag * wet.share * std::abs(spin[i]) * half[i] * (b * b * b * b + c * c * c * c);
    }
    const Mat3 resistance =
        axes * strips.asDiagonal() * axes.transpose() + m_linearDrag * wet.displaced * body.inverseMass * inertia;
    const Vec3 righting = wet.perArea * Vec3(wet.below.momentX, wet.below.momentY, 0.0);
    const Vec3 moment = (wet.below.centroid - wet.box.centre).cross(Vec3(0.0, 0.0, m_gravity * wet.displaced));

    const Mat3 system = inertia + h * resistance + Mat3((h * h * righting).asDiagonal());
    const Vec3 drive = h * (moment - h * righting.cwiseProduct(body.spin) - resistance * body.spin);
    body.spin += system.ldlt().solve(drive);
}

void Water::beforeSubstep(const SubstepBodies& bodies, double h) {
    ++m_substep;
    m_expected.resize(bodies.slotOf.size());
    m_works.assign(bodies.moving.size(), 0.0);
    bodies.forEach([&](std::size_t i) {
        MovingBody& body = bodies.moving[i];
        if (body.inverseMass <= 0.0 || !isNumber(body)) {
            return;
        }
        Wet wet;
        wet.box = body.box;
        wet.box.centre = body.position + body.orientation * body.box.centre;
        wet.box.orientation = body.orientation * body.box.orientation;
        wet.below = submerge(wet.box, m_level);
        if (wet.below.volume <= 0.0) {
            return;
        }
        wet.share = std::min(1.0, wet.below.volume / wet.box.volume());
        wet.displaced = m_density * wet.share * body.volume;
        wet.perArea = m_density * m_gravity * body.volume / wet.box.volume();
        const double before = kineticEnergy(body);
        carry(body, wet, h);
        turn(body, wet, h);
        m_works[i] = kineticEnergy(body) - before;
        m_expected[at(body.id)] = {body.velocity - Vec3(0.0, 0.0, m_gravity * h), m_substep};
    });
    m_work = std::accumulate(m_works.begin(), m_works.end(), m_work);
}

}  // namespace rubble
