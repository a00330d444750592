#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/finding.h"
#include "core/base/standard_gravity.h"
#include "core/fe/site_surface.h"
#include "core/simulation/health/breach_log.h"
#include "core/simulation/health/outcomes.h"

namespace rubble {

/// Where a collapse takes place, as far as the monitor has to know.
struct HealthSite {
    double gravity = standardGravity;  ///< m/s2
    SiteSurface surface;
    Aabb structure;                    ///< m, at rest; empty: no body counts as outside
    std::optional<double> waterLevel;  ///< m; unset: no water acts
    double current = 0.0;              ///< m/s, of the water
    HealthSettings settings{};
};

/// What a step looks like from outside the world.
struct HealthStep {
    double time = 0.0;        ///< s, at its end
    double energyGain = 0.0;  ///< now, over the work of gravity so far
    bool stirred = false;     ///< pieces moved or bodies left: a pile may wake
};

/// Watches a simulation step by step, changes nothing in it, and says what was not as it should be. Reads every body once a step;
/// what it says depends on the bodies alone.
class HealthMonitor {
public:
    explicit HealthMonitor(const HealthSite& site, const HealthLimits& limits = {});

    /// Takes note of a step.
    /// @param bodies  [bodies that ever entered]
    void stepped(const RigidWorld& world, std::span<const TrackedBody> bodies, const HealthStep& step);
    /// A body was no number and was taken out of the world.
    /// @param place  m, where it was last
    void lost(BodyId body, const Vec3& place, double time);
    /// Takes note of the pile at the end.
    /// @param bulking  volume under its surface over that of its material; NaN without debris
    /// @param layers   mean depth of the debris over the size of a fragment
    void pile(double bulking, double layers, double time);

    /// Energy was gained or bodies that still move lay inside each other in the step that has just been noted, or less than the
    /// remedy's time before it: smaller steps would help.
    bool unwell(double time) const { return time - m_unwell < m_limits.remedyTime - 1e-9; }
    /// A step was halved.
    void remedied(double from, double to);

    HealthReport report() const;
    /// Breaches to tell of while the run goes on (BreachLog::news()).
    std::vector<HealthBreach> news(double time) { return m_log.news(time); }
    /// One finding for each check that was breached, counting bodies (or breaches, where it is not about bodies), and one for the
    /// remedies.
    void addFindings(Findings& findings) const;
    void keep(Archive& archive);

private:
    static constexpr double never = std::numeric_limits<double>::infinity();
    struct Watched {
        double side = 0.0;          ///< m
        double entered = 0.0;       ///< s, end of its first step
        double share = 0.0;         ///< depth over side
        double deepSince = never;   ///< s, above the limit of a body
        double crowdSince = never;  ///< s, above that of the crowd
        double energy = 0.0;        ///< J/kg, of the step before, spin left out
        double below = 0.0;         ///< m, under the ground
        double outside = 0.0;       ///< m, from the structure, if that is beyond the site
        bool bornBelow = false;
        bool wasFrozen = false;
        bool everDeep = false;
        bool everFast = false;
        bool everBelow = false;
        bool everOutside = false;

        void keep(Archive& archive) {
            archive(side, entered, share, deepSince, crowdSince, energy, below, outside, bornBelow, wasFrozen, everDeep, everFast,
                    everBelow, everOutside);
        }
    };
    /// The worst of many in one step.
    struct Tally {
        std::int64_t bodies = 0;
        double measured = -std::numeric_limits<double>::infinity();
        double since = never;
        std::size_t body = 0;
        void add(std::size_t index, double value, double start) {
            ++bodies;
            if (start < since) {
                since = start;
            }
            if (value > measured) {
                measured = value;
                body = index;
            }
        }
    };

    void take(const RigidWorld& world, std::span<const TrackedBody> bodies, double time);
    void watchPenetration(Watched& watched, double depth, double time) const;
    void watchSpeed(const RigidWorld& world, std::size_t index, const TrackedBody& body);
    void watchPlace(Watched& watched, const Vec3& place, double time);
    /// m, from the structure to a place that debris can get to: down a slope farther than on the level.
    double reachAt(const Vec3& place) const;
    double allowedSpeedSquared(const TrackedBody& body, double lifted, double push) const;
    void note(HealthCheck check, const Tally& tally, double limit, std::span<const TrackedBody> bodies, double time);
    void notePenetration(std::span<const TrackedBody> bodies, double time);
    void noteEnergy(const HealthStep& step, std::span<const TrackedBody> bodies);
    void noteSleep(double time, bool stirred);

    HealthSite m_site;
    HealthLimits m_limits;
    double m_reach = never;  ///< m, beyond which a body is outside on level ground
    std::vector<Watched> m_bodies;
    BreachLog m_log;
    HealthReport m_report;
    double m_topEnergy = -never;  ///< J/kg, the most that any body brought in
    double m_unwell = -never;     ///< s, latest instant of an energy or penetration breach that smaller steps would help
    double m_rested = 0.0;        ///< share that was at rest since a pile was last stirred

    // Of the step that is being noted.
    Tally m_deep, m_crowd, m_fast, m_below, m_outside, m_gain;
    std::int64_t m_present = 0;
    std::int64_t m_frozen = 0;
    bool m_movingDeep = false;
    bool m_movingCrowd = false;
};

}  // namespace rubble
