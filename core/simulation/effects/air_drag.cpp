#include "core/simulation/effects/air_drag.h"

#include "core/simulation/effects/submerged_box.h"

namespace rubble {

void AirDrag::beforeSubstep(const SubstepBodies& bodies, double h) {
    for (MovingBody& body : bodies.moving) {
        const double speed = body.velocity.norm();
        if (!(speed > 0.0) || !isNumber(body) || body.inverseMass <= 0.0) {
            continue;
        }
        OrientedBox box = body.box;
        box.orientation = body.orientation * box.orientation;
        const double k = m_half * projectedArea(box, body.velocity / speed) * body.inverseMass;
        const double left = 1.0 / (1.0 + k * speed * h);
        body.velocity *= left;
        m_work += 0.5 * speed * speed * (left * left - 1.0) / body.inverseMass;
    }
}

}  // namespace rubble
