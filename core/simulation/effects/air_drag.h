#pragma once

#include <vector>

#include "core/base/archive.h"
#include "core/scenario/scenario.h"
#include "core/simulation/effects/effect.h"

namespace rubble {

/// Drag of still air: F = -1/2 rho C_d A |v| v, with A the area of the body's box seen along its velocity (sum over axes of |n . v|
/// over |v| times the area of the face). rho and C_d are settings (1.225 kg/m3, ISO 2533 at sea level; 1.05, a cube face on:
/// Hoerner, Fluid-Dynamic Drag, 1965, chapter 3).
///
/// Within a substep A is constant and gravity acts after it, so that the velocity left by drag alone, v / (1 + k |v| h) with
/// k = rho C_d A / 2 m, is exact: it never turns round, whatever the step.
///
/// Limits: no wind, no lift, no torque. Damping of spin is left out: strips of a plate turning in air give the torque
/// 1/2 rho C_d w^2 (b^4 + c^4) L / 2, which takes 0.1 % a second from a 0.3 m stone block at 10 rad/s. Bodies in each other's wake,
/// and the part of a body that is under water, feel the full drag.
class AirDrag : public Effect {
public:
    explicit AirDrag(const EffectSettings& settings) : m_half(0.5 * settings.airDensity * settings.airDrag) {}

    EffectKind kind() const override { return EffectKind::AirDrag; }
    void beforeSubstep(const SubstepBodies& bodies, double h) override;
    double work() const override { return m_work; }
    void keep(Archive& archive) override { archive(m_work); }

private:
    double m_half;  ///< kg/m3, rho C_d / 2
    double m_work = 0.0;
    std::vector<double> m_works;  ///< J, [moving bodies] in this substep
};

}  // namespace rubble
