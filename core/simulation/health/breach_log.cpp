#include "core/simulation/health/breach_log.h"

#include <algorithm>

#include "core/simulation/health/passed_limits.h"

namespace rubble {

namespace {

/// s. A breach that goes on is not told anew at every step.
constexpr double retellAfter = 1.0;

std::string bodyText(const HealthObservation& o) {
    return o.body ? "body " + englishInteger(static_cast<std::int64_t>(at(*o.body))) : std::string("no body");
}

Argument percent(double share) {
    return Argument(100.0 * share, "%");
}

Message penetrationText(const HealthObservation& o) {
    if (o.limit < 0.05) {
        return {"health.crowd",
                "{0} at once lay more than 5 % of a smallest side inside another for over 0.5 s, {1} of all; {2} worst",
                {bodiesText(o.bodies), percent(o.measured), bodyText(o)}};
    }
    if (o.measured >= 1.0) {
        return {"health.gone_through",
                "{0} lay {1} deep in another for over 0.5 s, {2} times its smallest side: it has gone through; the limit is {3} of "
                "that side ({4})",
                {bodyText(o), Argument(o.depth, "m"), o.measured, percent(o.limit), bodiesText(o.bodies)}};
    }
    return {"health.penetration",
            "{0} lay {1} deep in another for over 0.5 s, {2} of its smallest side; the limit is {3} ({4})",
            {bodyText(o), Argument(o.depth, "m"), percent(o.measured), percent(o.limit), bodiesText(o.bodies)}};
}

Message whatOf(const HealthObservation& o) {
    switch (o.check) {
        case HealthCheck::Energy:
            return {
                "health.energy",
                "energy rose by {0} of the work of gravity beyond gravity, births, overlap, pieces and effects; the limit is {1} "
                "({2} gained most)",
                {percent(o.measured), percent(o.limit), bodyText(o)}};
        case HealthCheck::Penetration:
            return penetrationText(o);
        case HealthCheck::Speed:
            return {"health.speed",
                    "{0} was {1} times as fast as its birth and its fall allow; the limit is {2} ({3})",
                    {bodyText(o), o.measured, o.limit, bodiesText(o.bodies)}};
        case HealthCheck::BelowGround:
            return {"health.below_ground",
                    "the centre of {0} was {1} below the ground ({2})",
                    {bodyText(o), Argument(o.measured, "m"), bodiesText(o.bodies)}};
        case HealthCheck::OutsideSite:
            return {"health.outside_site",
                    "{0} was {1} from the structure; 10 times its height (taken as 1 m at least) and the drop of the terrain are "
                    "{2} ({3})",
                    {bodyText(o), Argument(o.measured, "m"), Argument(o.limit, "m"), bodiesText(o.bodies)}};
        case HealthCheck::NotANumber:
            return {"health.not_a_number",
                    "place or velocity of {0} was no number: it was taken out ({1})",
                    {bodyText(o), bodiesText(o.bodies)}};
        case HealthCheck::AsleepShare:
            return {"health.asleep_share",
                    "the share of bodies at rest fell to {0} after it had reached {1}",
                    {percent(o.measured), percent(o.limit)}};
        case HealthCheck::Bulking:
            break;
    }
    return o.measured < o.limit
               ? Message{"health.bulking_low",
                         "the pile has {0} times the volume of its material, less than {1}: it is squeezed into itself",
                         {o.measured, o.limit}}
               : Message{"health.bulking_high",
                         "the pile has {0} times the volume of its material, more than {1}: its shapes are inflated",
                         {o.measured, o.limit}};
}

}  // namespace

HealthSettings healthSettings(const SimulationSettings& settings) {
    return {settings.autoRemedy, settings.solver == SolverKind::SoftStep};
}

void BreachLog::hold(const HealthObservation& observation, double since, double time) {
    std::vector<Span>& spans = m_spans[static_cast<std::size_t>(observation.check)];
    if (spans.empty() || since - spans.back().to > m_interval + 1e-9) {
        spans.push_back({since, time, time, observation});
        return;
    }
    Span& span = spans.back();
    span.to = std::max(span.to, time);
    span.changed = true;
    if (observation.severity > span.worst.severity) {
        span.worst = observation;
        span.worstAt = time;
    }
}

HealthBreach BreachLog::breachOf(const Span& span) const {
    const HealthObservation& o = span.worst;
    return {o.check,
            span.from,
            span.to,
            span.worstAt,
            o.body,
            o.place,
            o.measured,
            o.limit,
            o.bodies,
            whatOf(o),
            healthRemedy(o.check, o.measured, o.limit, m_settings)};
}

std::vector<HealthBreach> BreachLog::news(double time) {
    std::vector<HealthBreach> list;
    for (std::vector<Span>& spans : m_spans) {
        for (Span& span : spans) {
            if (span.changed && time - span.toldAt >= retellAfter) {
                list.push_back(breachOf(span));
                span.changed = false;
                span.toldAt = time;
            }
        }
    }
    return list;
}

std::vector<HealthBreach> BreachLog::breaches() const {
    std::vector<HealthBreach> list;
    for (const std::vector<Span>& spans : m_spans) {
        for (const Span& span : spans) {
            list.push_back(breachOf(span));
        }
    }
    std::stable_sort(list.begin(), list.end(), [](const HealthBreach& a, const HealthBreach& b) { return a.from < b.from; });
    return list;
}

namespace {

Message energyRemedy(const HealthSettings& ran) {
    if (!ran.softStep) {
        return ran.autoRemedy ? Message{"health.energy.remedy.halved_bullet",
                                        "raise step_rate (auto_remedy is on and was not enough), or set solver = soft-step, which "
                                        "gains less",
                                        {}}
                              : Message{"health.energy.remedy.bullet",
                                        "raise step_rate, set auto_remedy = true, or set solver = soft-step, which gains less",
                                        {}};
    }
    return ran.autoRemedy ? Message{"health.energy.remedy.halved", "raise step_rate: auto_remedy is on and was not enough", {}}
                          : Message{"health.energy.remedy", "raise step_rate, or set auto_remedy = true", {}};
}

Message penetrationRemedy(const HealthSettings& ran) {
    if (!ran.softStep) {
        return ran.autoRemedy ? Message{"health.penetration.remedy.halved_bullet",
                                        "set solver = soft-step: under bullet deep piles squeeze together; or raise step_rate, or "
                                        "bodies_max for smaller clusters (auto_remedy is on and was not enough)",
                                        {}}
                              : Message{"health.penetration.remedy.bullet",
                                        "set solver = soft-step: under bullet deep piles squeeze together; or raise step_rate, set "
                                        "auto_remedy = true, or raise bodies_max for smaller clusters",
                                        {}};
    }
    return ran.autoRemedy ? Message{"health.penetration.remedy.halved",
                                    "raise step_rate, or bodies_max for smaller clusters: auto_remedy is on and was not enough",
                                    {}}
                          : Message{"health.penetration.remedy",
                                    "raise step_rate, set auto_remedy = true, or raise bodies_max for smaller clusters",
                                    {}};
}

}  // namespace

Message healthRemedy(HealthCheck check, double measured, double limit, const HealthSettings& ran) {
    switch (check) {
        case HealthCheck::Energy:
            return energyRemedy(ran);
        case HealthCheck::Penetration:
            return penetrationRemedy(ran);
        case HealthCheck::Speed:
            return {"health.speed.remedy",
                    "raise step_rate; look for births inside other bodies (overlap_speed) and for restitution above 1",
                    {}};
        case HealthCheck::BelowGround:
            return {"health.below_ground.remedy", "raise step_rate, or set ground_height (or the terrain) to its real height", {}};
        case HealthCheck::OutsideSite:
            return {
                "health.outside_site.remedy",
                "look at the birth velocity of the body's element: where the FE result means it, vouch for the run, for it lies "
                "there; birth_velocity = rest takes that velocity from all debris; without ground bodies fall for ever (ground)",
                {}};
        case HealthCheck::NotANumber:
            return {"health.not_a_number.remedy",
                    "look at the element of that body in the FE file; switch the effects off one by one to find the one that fails",
                    {}};
        case HealthCheck::AsleepShare:
            return {"health.asleep_share.remedy",
                    "raise freeze_delay or lower freeze_speed, so that bodies freeze only when at rest",
                    {}};
        case HealthCheck::Bulking:
            break;
    }
    return measured < limit
               ? (ran.softStep ? Message{"health.bulking_low.remedy", "raise step_rate", {}}
                               : Message{"health.bulking_low.remedy.bullet",
                                         "set solver = soft-step: under bullet piles squeeze together; or raise step_rate",
                                         {}})
               : Message{"health.bulking_high.remedy",
                         "lower box_bulking, choose cluster_shape = hull or compound, or raise bodies_max for smaller clusters",
                         {}};
}

}  // namespace rubble
