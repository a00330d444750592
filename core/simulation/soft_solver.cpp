#include "core/simulation/soft_solver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace rubble {

namespace {

/// Damping ratio of a contact: above 1, so that overlap comes apart without a bounce.
constexpr double dampingRatio = 10.0;
/// A load comes back in the next substep, a blow does not: what is new may grow by this factor from substep to substep. Lower:
/// slow under a pile that is lifted; higher: what was hit flies on.
constexpr double warmGrowth = 3.0;
/// Rounds over the points of a contact that bounces.
constexpr int restitutionRounds = 8;
/// Contacts that one thread takes at a time.
constexpr std::size_t grain = 96;
/// Groups; a body with more contacts than this puts the rest into the ordered group.
constexpr std::uint32_t mostColours = 63;

Vec3 relativeVelocity(const SolverBody& a, const SolverBody& b, const SolverPoint& p) {
    return b.velocity + b.spin.cross(p.fromB) - a.velocity - a.spin.cross(p.fromA);
}

void apply(const SolverContact& c, SolverBody& a, SolverBody& b, const SolverPoint& p, const Vec3& impulse) {
    // Threads may share an immovable body, so nothing is written to it.
    if (a.inverseMass > 0.0) {
        a.velocity -= (c.yieldA * a.inverseMass) * impulse;
        a.spin -= a.inverseInertia * (p.fromA.cross(impulse) * c.yieldA);
    }
    if (b.inverseMass > 0.0) {
        b.velocity += (c.yieldB * b.inverseMass) * impulse;
        b.spin += b.inverseInertia * (p.fromB.cross(impulse) * c.yieldB);
    }
}

/// kg that a push at the point along a direction moves.
double massAlong(const SolverContact& c, const SolverBody& a, const SolverBody& b, const SolverPoint& p, const Vec3& direction) {
    const Vec3 ra = p.fromA.cross(direction);
    const Vec3 rb = p.fromB.cross(direction);
    const double inverse =
        c.yieldA * (a.inverseMass + ra.dot(a.inverseInertia * ra)) + c.yieldB * (b.inverseMass + rb.dot(b.inverseInertia * rb));
    return inverse > 0.0 ? 1.0 / inverse : 0.0;
}

/// Stiffness of a soft contact as rates for one substep (Catto 2024, Solver2D).
void setSoftness(SolverContact& c, double omega, double h) {
    const double a1 = 2.0 * dampingRatio + h * omega;
    const double a2 = h * omega * a1;
    const double a3 = 1.0 / (1.0 + a2);
    c.biasRate = omega / a1;
    c.massScale = a2 * a3;
    c.impulseScale = a3;
}

void prepareContact(SolverContact& c, std::span<SolverPoint> points, const SolverBody& a, const SolverBody& b, double h) {
    const double soft = 2.0 * std::numbers::pi * c.frequency;
    double squared = soft * soft;
    for (SolverPoint& p : points) {
        p.normalMass = massAlong(c, a, b, p, c.normal);
        p.tangentMass[0] = massAlong(c, a, b, p, c.tangent[0]);
        p.tangentMass[1] = massAlong(c, a, b, p, c.tangent[1]);
        p.approachSpeed = -c.normal.dot(relativeVelocity(a, b, p));
        p.largestImpulse = p.impulseSum = p.opening = 0.0;
        // At rest a contact sinks by load / (mass omega^2).
        if (p.normalMass > 0.0) {
            squared = std::max(squared, p.normalImpulse / h / (p.normalMass * c.sinkAllowed));
        }
    }
    setSoftness(c, std::min(std::sqrt(squared), SoftSolver::stiffest / h), h);
}

void solveFriction(const SolverContact& c, SolverPoint& p, SolverBody& a, SolverBody& b) {
    const Vec3 relative = relativeVelocity(a, b, p);
    double t0 = p.tangentImpulse[0] - p.tangentMass[0] * c.tangent[0].dot(relative);
    double t1 = p.tangentImpulse[1] - p.tangentMass[1] * c.tangent[1].dot(relative);
    const double limit = c.friction * p.normalImpulse;
    const double length = t0 * t0 + t1 * t1;
    if (length > limit * limit) {
        const double scale = limit / std::sqrt(length);
        t0 *= scale;
        t1 *= scale;
    }
    const Vec3 impulse = (t0 - p.tangentImpulse[0]) * c.tangent[0] + (t1 - p.tangentImpulse[1]) * c.tangent[1];
    p.tangentImpulse[0] = t0;
    p.tangentImpulse[1] = t1;
    apply(c, a, b, p, impulse);
}

/// One pass over the points of a contact. @param push  m/s at most for pushing overlap apart; zero: relax
void solveContact(const SolverContact& c, std::span<SolverPoint> points, SolverBody& a, SolverBody& b, double h, double push) {
    const Vec3 moved = b.moved - a.moved;
    const double limit = c.impulseLimit < 0.0 ? 1e300 : c.impulseLimit;
    for (SolverPoint& p : points) {
        const double separation = p.separation + c.normal.dot(moved + b.turned.cross(p.fromB) - a.turned.cross(p.fromA));
        double bias = 0.0;
        double massScale = 1.0;
        double impulseScale = 0.0;
        if (separation > 0.0) {
            bias = separation / h;
        } else if (push > 0.0) {
            bias = std::max(c.biasRate * separation, -push);
            massScale = c.massScale;
            impulseScale = c.impulseScale;
        }
        const double speed = c.normal.dot(relativeVelocity(a, b, p));
        const double wanted = p.normalImpulse - p.normalMass * massScale * (speed + bias) - impulseScale * p.normalImpulse;
        double total = std::clamp(wanted, 0.0, limit);
        if (push > 0.0 && c.parting > 0.0) {
            // Beyond what holds the two where they are, little is spent on bringing them apart.
            total = std::max(total, std::min(p.normalImpulse - p.normalMass * (speed - c.parting), c.partingLimit));
        }
        const double change = total - p.normalImpulse;
        p.normalImpulse = total;
        p.largestImpulse = std::max(p.largestImpulse, total);
        if (change != 0.0) {
            apply(c, a, b, p, change * c.normal);
        }
        if (total > 0.0) {
            if (a.inverseMass > 0.0) {
                a.active = true;
            }
            if (b.inverseMass > 0.0) {
                b.active = true;
            }
        }
    }
    for (SolverPoint& p : points) {
        if (p.normalImpulse > 0.0 || p.tangentImpulse[0] != 0.0 || p.tangentImpulse[1] != 0.0) {
            solveFriction(c, p, a, b);
        }
    }
}

void restituteContact(const SolverContact& c, std::span<SolverPoint> points, SolverBody& a, SolverBody& b, double threshold) {
    // The points of one face share a blow; a few rounds find their shares.
    for (int round = 0; round < restitutionRounds; ++round) {
        for (SolverPoint& p : points) {
            if (p.approachSpeed < threshold || p.largestImpulse == 0.0) {
                continue;
            }
            const double speed = c.normal.dot(relativeVelocity(a, b, p));
            // Over the whole step a contact never pulls.
            const double change = std::max(-p.normalMass * (speed - c.restitution * p.approachSpeed), -p.impulseSum);
            // What a limit left of a moving piece's approach is not made up for here.
            if (c.driven && change > 0.0) {
                continue;
            }
            p.impulseSum += change;
            p.normalImpulse = std::max(0.0, p.normalImpulse + change);
            apply(c, a, b, p, change * c.normal);
        }
    }
}

}  // namespace

void colourContacts(std::span<const std::pair<std::uint32_t, std::uint32_t>> ends, std::size_t movable, ContactColours& colours) {
    std::vector<std::uint64_t> used(movable, 0);
    std::vector<std::uint8_t> colour(ends.size());
    std::vector<std::uint32_t> counts(mostColours + 2, 0);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const auto [a, b] = ends[i];
        const std::uint64_t taken = (a < movable ? used[a] : 0) | (b < movable ? used[b] : 0);
        const auto free = std::min<std::uint32_t>(static_cast<std::uint32_t>(std::countr_one(taken)), mostColours);
        if (free < mostColours) {
            const std::uint64_t bit = std::uint64_t{1} << free;
            if (a < movable) {
                used[a] |= bit;
            }
            if (b < movable) {
                used[b] |= bit;
            }
        }
        colour[i] = static_cast<std::uint8_t>(free);
        ++counts[free + 1];
    }
    colours.lastInOrder = counts[mostColours + 1] > 0;
    for (std::uint32_t k = 0; k <= mostColours; ++k) {
        counts[k + 1] += counts[k];
    }
    colours.first.assign(counts.begin(), counts.end());
    colours.order.resize(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        colours.order[counts[colour[i]]++] = static_cast<std::uint32_t>(i);
    }
    while (colours.first.size() > 1 && colours.first[colours.first.size() - 2] == colours.first.back()) {
        colours.first.pop_back();
    }
}

template <class Work>
void SoftSolver::forEachContact(Work work) {
    for (std::size_t group = 0; group + 1 < firstOfGroup.size(); ++group) {
        const std::size_t first = firstOfGroup[group];
        const std::size_t count = firstOfGroup[group + 1] - first;
        const bool inOrder = lastInOrder && group + 2 == firstOfGroup.size();
        m_pool.loop(count, inOrder ? count : grain, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = first + from; i < first + to; ++i) {
                SolverContact& c = contacts[i];
                work(c, std::span<SolverPoint>(points).subspan(c.firstPoint, c.points), bodies[c.a], bodies[c.b]);
            }
        });
    }
}

void SoftSolver::prepare(double h) {
    m_pool.loop(contacts.size(), grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            SolverContact& c = contacts[i];
            prepareContact(c, std::span<SolverPoint>(points).subspan(c.firstPoint, c.points), bodies[c.a], bodies[c.b], h);
        }
    });
}

void SoftSolver::solveSoft(double h, double pushOutSpeed) {
    forEachContact([](SolverContact& c, std::span<SolverPoint> own, SolverBody& a, SolverBody& b) {
        for (SolverPoint& p : own) {
            const double most = warmGrowth * std::max(p.before, c.weight);
            p.before = p.normalImpulse;
            if (p.normalImpulse > most) {
                p.tangentImpulse[0] *= most / p.normalImpulse;
                p.tangentImpulse[1] *= most / p.normalImpulse;
                p.normalImpulse = most;
            }
            if (p.normalImpulse > 0.0) {
                apply(c, a, b, p,
                      p.normalImpulse * c.normal + p.tangentImpulse[0] * c.tangent[0] + p.tangentImpulse[1] * c.tangent[1]);
            }
        }
    });
    forEachContact([&](SolverContact& c, std::span<SolverPoint> own, SolverBody& a, SolverBody& b) {
        solveContact(c, own, a, b, h, pushOutSpeed);
    });
}

void SoftSolver::noteOpening() {
    m_pool.loop(contacts.size(), grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            const SolverContact& c = contacts[i];
            for (std::size_t k = c.firstPoint; c.booked && k < c.firstPoint + c.points; ++k) {
                points[k].opening = c.normal.dot(relativeVelocity(bodies[c.a], bodies[c.b], points[k]));
            }
        }
    });
}

void SoftSolver::book() {
    m_pool.loop(contacts.size(), grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            SolverContact& c = contacts[i];
            for (std::size_t k = c.firstPoint; (c.booked || c.driven) && k < c.firstPoint + c.points; ++k) {
                SolverPoint& p = points[k];
                if (c.driven) {
                    const bool byA = bodies[c.a].inverseMass == 0.0;
                    const SolverBody& piece = bodies[byA ? c.a : c.b];
                    const Vec3 speed = piece.velocity + piece.spin.cross(byA ? p.fromA : p.fromB);
                    const Vec3 onB =
                        p.normalImpulse * c.normal + p.tangentImpulse[0] * c.tangent[0] + p.tangentImpulse[1] * c.tangent[1];
                    c.work += (byA ? 1.0 : -1.0) * onB.dot(speed);
                } else {
                    c.work += std::max(0.0, p.normalImpulse * p.opening);
                }
            }
        }
    });
}

void SoftSolver::relax(double h) {
    forEachContact([&](SolverContact& c, std::span<SolverPoint> own, SolverBody& a, SolverBody& b) {
        solveContact(c, own, a, b, h, 0.0);
        for (SolverPoint& p : own) {
            p.impulseSum += p.normalImpulse;
        }
    });
}

void SoftSolver::restitute(double threshold) {
    forEachContact([&](SolverContact& c, std::span<SolverPoint> own, SolverBody& a, SolverBody& b) {
        restituteContact(c, own, a, b, threshold);
    });
}

}  // namespace rubble
