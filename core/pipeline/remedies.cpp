#include "core/pipeline/remedies.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <variant>

namespace rubble {

namespace {

/// 1/s, the most that can be set.
constexpr double mostSteps = 10'000.0;
/// s, the most that can be set.
constexpr double longestSettling = 10'000.0;
/// The most that can be set.
constexpr std::int64_t mostBodies = 10'000'000;

// What is found, by the ids of its messages.
constexpr std::string_view longBirthWindow = "fragments.birth_window";
constexpr std::string_view noDeathTime = "fragments.no_death_time";
constexpr std::string_view deathTimeOutside = "fragments.death_time_outside";
constexpr std::string_view notHeld = "effect.not_held";
constexpr std::string_view looseBeside = "sizing.loose_beside";
constexpr std::string_view looseBesideRun = "sizing.loose_beside.run";
constexpr std::string_view speedHeld = "simulation.speed_held";
constexpr std::string_view stepsRaised = "simulation.auto_remedy";
constexpr std::string_view stillMoving = "simulation.still_moving";
constexpr std::string_view heldTogether = "simulation.held_together";
constexpr std::string_view islandsLive = "simulation.live_islands";
constexpr std::string_view waterMissed = "simulation.water_missed";
constexpr std::string_view roughnessAlone = "simulation.roughness_alone";

using Choice = std::optional<RemedySetting>;

/// The first that is another value than what was set.
Choice firstOther(const RemedyGrounds& grounds, std::initializer_list<Choice> choices) {
    for (const Choice& choice : choices) {
        if (choice && parameterValue(grounds.ran, choice->key) != choice->value) {
            return choice;
        }
    }
    return std::nullopt;
}

/// Twice as many steps as the run had, in tens.
Choice moreSteps(const RemedyGrounds& grounds) {
    if (!(grounds.stepRate > 0.0) || grounds.stepRate >= mostSteps) {
        return std::nullopt;
    }
    return RemedySetting{"step_rate", std::min(mostSteps, 10.0 * std::ceil(0.2 * grounds.stepRate))};
}

Choice moreBodies(const RemedyGrounds& grounds) {
    return firstOther(grounds, {RemedySetting{"bodies_max", std::min(mostBodies, 2 * std::int64_t{grounds.ran.grid.bodiesMax})}});
}

Choice word(std::string_view key, std::string_view value) {
    return RemedySetting{std::string(key), std::string(value)};
}

Choice slimmerShapes(const RemedyGrounds& grounds) {
    const bool compound = parameterValue(grounds.ran, "cluster_shape") == ParameterValue(std::string("compound"));
    return firstOther(grounds, {compound ? std::nullopt : word("cluster_shape", "hull"), moreBodies(grounds)});
}

/// A number that the remedy itself names.
Choice named(std::string_view key, const Message& remedy) {
    const auto* number = remedy.arguments.empty() ? nullptr : std::get_if<double>(&remedy.arguments.front().value);
    return number != nullptr ? Choice(RemedySetting{std::string(key), *number}) : std::nullopt;
}

bool groundSwitchedOff(const Scenario& scenario) {
    return scenario.effects.of(EffectKind::Ground) == EffectSwitch::Off;
}

}  // namespace

std::optional<RemedySetting> remedySettingOf(const HealthBreach& breach, const RemedyGrounds& grounds) {
    const SimulationSettings& ran = grounds.ran.simulation;
    switch (breach.check) {
        case HealthCheck::Energy:
        case HealthCheck::Penetration:
            // Halving comes after the step that gained or pressed: it seldom helps.
            return firstOther(grounds, {moreSteps(grounds), RemedySetting{"auto_remedy", true}});
        case HealthCheck::Speed:
        case HealthCheck::BelowGround:
            return firstOther(grounds, {moreSteps(grounds)});
        case HealthCheck::AsleepShare:
            return firstOther(grounds, {RemedySetting{"freeze_delay", std::min(60.0, 2.0 * ran.freezeDelay)}});
        case HealthCheck::OutsideSite:
            // Debris without its birth velocity is another collapse: nobody is led to that by a button.
            return groundSwitchedOff(grounds.ran) ? word("ground", "auto") : std::nullopt;
        case HealthCheck::Bulking:
            return breach.worst >= breach.limit ? slimmerShapes(grounds)
                                                : firstOther(grounds, {word("solver", "soft-step"), moreSteps(grounds)});
        case HealthCheck::NotANumber:
            break;
    }
    return std::nullopt;
}

std::optional<RemedySetting> remedySettingOf(const Finding& finding, const RemedyGrounds& grounds) {
    const std::string_view id = finding.what.id;
    if (id == longBirthWindow) {
        return named("birth_window", finding.remedy);
    }
    if (id == noDeathTime || id == deathTimeOutside) {
        return firstOther(grounds, {word("birth_time", "state")});
    }
    if (id == notHeld || id == looseBeside || id == looseBesideRun) {
        return firstOther(grounds, {word("loose_structure", "fe")});
    }
    if (id == speedHeld && grounds.ran.simulation.stepRate) {
        return std::nullopt;  // they were raised already, and it did not help
    }
    if (id == speedHeld || id == stepsRaised) {
        return firstOther(grounds, {moreSteps(grounds)});
    }
    if (id == stillMoving) {
        return firstOther(grounds,
                          {RemedySetting{"settle_time", std::min(longestSettling, 2.0 * grounds.ran.simulation.settleTime)}});
    }
    if (id == heldTogether) {
        return moreBodies(grounds);
    }
    if (id == islandsLive) {
        return firstOther(grounds, {word("live_islands", "released")});
    }
    if (id == waterMissed) {
        return firstOther(grounds, {word("water", "on")});
    }
    if (id == roughnessAlone) {
        return firstOther(grounds, {RemedySetting{"terrain_roughness", 0.0}});
    }
    return std::nullopt;
}

double meanStepRate(std::int64_t steps, double seconds) {
    return seconds > 0.0 ? static_cast<double>(steps) / seconds : 0.0;
}

}  // namespace rubble
