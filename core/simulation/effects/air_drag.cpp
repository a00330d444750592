#include "core/simulation/effects/air_drag.h"

#include <numeric>

#include "core/simulation/effects/submerged_box.h"

namespace rubble {

void AirDrag::beforeSubstep(const SubstepBodies& bodies, double h) {
    m_works.assign(bodies.moving.size(), 0.0);
    bodies.forEach([&](std::size_t i) {
        MovingBody& body = bodies.moving[i];
        const double speed = body.velocity.norm();
        if (!(speed > 0.0) || !isNumber(body) || body.inverseMass <= 0.0) {
            return;
        }
        OrientedBox box = body.box;
        box.orientation = body.orientation * box.orientation;
        const double k = m_half * projectedArea(box, body.velocity / speed) * body.inverseMass;
        const double left = 1.0 / (1.0 + k * speed * h);
        body.velocity *= left;
        m_works[i] = 0.5 * speed * speed * (left * left - 1.0) / body.inverseMass;
    });
    m_work = std::accumulate(m_works.begin(), m_works.end(), m_work);
}

}  // namespace rubble
