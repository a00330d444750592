#pragma once

#include <array>
#include <limits>
#include <vector>

#include "core/base/archive.h"
#include "core/scenario/scenario.h"
#include "core/simulation/health/health.h"

namespace rubble {

/// A limit that is passed at one instant.
struct HealthObservation {
    HealthCheck check{};
    double measured = 0.0;
    double limit = 0.0;
    double severity = 1.0;  ///< how far beyond the limit; compares observations of one check that have different limits
    std::optional<BodyId> body;
    Vec3 place = Vec3::Zero();  ///< m, of that body
    double depth = 0.0;         ///< m, of a penetration
    std::int64_t bodies = 0;    ///< that break the limit now

    void keep(Archive& archive) { archive(check, measured, limit, severity, body, place, depth, bodies); }
};

/// What of the settings of a run decides which remedies are left.
struct HealthSettings {
    bool autoRemedy = false;  ///< steps are halved after a breach
    bool softStep = true;     ///< the solver
};

HealthSettings healthSettings(const SimulationSettings& settings);

/// Makes breaches of observations: those of one check that follow each other closely are one, with the worst of them.
class BreachLog {
public:
    explicit BreachLog(double interval, const HealthSettings& settings = {}) : m_interval(interval), m_settings(settings) {}

    /// A limit is passed at `time`, and has been since `since` [s].
    void hold(const HealthObservation& observation, double since, double time);
    bool empty(HealthCheck check) const { return m_spans[static_cast<std::size_t>(check)].empty(); }
    /// In the order in which they began, those of one instant in the order of the checks, with their texts.
    std::vector<HealthBreach> breaches() const;
    /// Those that have begun since the last call, and those that have grown longer or worse and were last told of a second or more
    /// before `time` [s]. A breach is known by its check and its beginning.
    std::vector<HealthBreach> news(double time);
    void keep(Archive& archive) { archive(m_spans); }

private:
    struct Span {
        double from = 0.0;
        double to = 0.0;
        double worstAt = 0.0;
        HealthObservation worst;
        double toldAt = -std::numeric_limits<double>::infinity();
        bool changed = true;  ///< since it was told

        void keep(Archive& archive) { archive(from, to, worstAt, worst, toldAt, changed); }
    };
    HealthBreach breachOf(const Span& span) const;

    double m_interval;
    HealthSettings m_settings;
    std::array<std::vector<Span>, healthCheckCount> m_spans;
};

/// What the user can do about a check, naming the settings. What was set already is not advised.
Message healthRemedy(HealthCheck check, double measured, double limit, const HealthSettings& ran);

}  // namespace rubble
