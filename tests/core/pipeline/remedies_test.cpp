#include "core/pipeline/remedies.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

HealthBreach breachOf(HealthCheck check, double worst = 2.0, double limit = 1.0) {
    HealthBreach breach;
    breach.check = check;
    breach.worst = worst;
    breach.limit = limit;
    return breach;
}

Finding findingOf(const char* id, std::vector<Argument> ofRemedy = {}) {
    return {{id, "something", {}}, {std::string(id) + ".remedy", "do something", std::move(ofRemedy)}, 1, {}};
}

/// "key=value"; empty: no setting alone helps.
std::string textOf(const std::optional<RemedySetting>& setting) {
    return setting ? setting->key + "=" + valueText(setting->value) : std::string();
}

// Each is set as the window sets it, and what was set is not offered again.
TEST(Remedies, OfPassedLimitsAreSettingsThatDifferFromWhatRan) {
    RemedyGrounds grounds{Scenario(), 60.0};
    const auto next = [&grounds](const HealthBreach& breach) {
        const auto setting = remedySettingOf(breach, grounds);
        if (setting) {
            EXPECT_NE(parameterValue(grounds.ran, setting->key), setting->value);
            setParameter(grounds.ran, setting->key, setting->value);
        }
        return textOf(setting);
    };
    EXPECT_EQ(next(breachOf(HealthCheck::Penetration)), "step_rate=120") << "halving comes after bodies were pressed in";
    EXPECT_EQ(next(breachOf(HealthCheck::Penetration)), "auto_remedy=true");
    EXPECT_EQ(next(breachOf(HealthCheck::Bulking)), "cluster_shape=hull");
    EXPECT_EQ(next(breachOf(HealthCheck::Bulking)), "bodies_max=9000");
    EXPECT_EQ(next(breachOf(HealthCheck::OutsideSite)), "") << "the sentence says where to look";
    setParameterText(grounds.ran, "ground", "off");
    EXPECT_EQ(next(breachOf(HealthCheck::OutsideSite)), "ground=auto") << "without a ground nothing stays near";
    setParameterText(grounds.ran, "solver", "bullet");
    EXPECT_EQ(next(breachOf(HealthCheck::Bulking, 1.0, 1.15)), "solver=soft-step");
    EXPECT_EQ(next(breachOf(HealthCheck::NotANumber)), "");
    EXPECT_EQ(next(breachOf(HealthCheck::Energy)), "") << "twice the steps were set above";
    grounds.ran = Scenario();
    EXPECT_EQ(next(breachOf(HealthCheck::Energy)), "step_rate=120") << "halving comes after the step that gained";
    EXPECT_EQ(next(breachOf(HealthCheck::Energy)), "auto_remedy=true");
    grounds.stepRate = 10'000.0;
    EXPECT_EQ(next(breachOf(HealthCheck::Speed)), "") << "no more steps can be set";
}

TEST(Remedies, OfFindingsAreSettingsWhereOneHelps) {
    const RemedyGrounds grounds{Scenario(), 60.0};
    const auto of = [&](const Finding& finding) { return textOf(remedySettingOf(finding, grounds)); };
    EXPECT_EQ(of(findingOf("fragments.birth_window", {{7e-7, "s"}})), "birth_window=7e-07");
    EXPECT_EQ(of(findingOf("effect.not_held")), "loose_structure=fe");
    EXPECT_EQ(of(findingOf("sizing.loose_beside.run")), "loose_structure=fe");
    EXPECT_EQ(of(findingOf("simulation.speed_held")), "step_rate=120");
    EXPECT_EQ(of(findingOf("simulation.still_moving")), "settle_time=20");
    EXPECT_EQ(of(findingOf("simulation.held_together")), "bodies_max=9000");
    EXPECT_EQ(of(findingOf("simulation.water_missed")), "water=on");
    EXPECT_EQ(of(findingOf("simulation.live_islands")), "") << "they are released already";
    EXPECT_EQ(of(findingOf("fragments.inverted")), "");
    RemedyGrounds held = grounds;
    held.ran.effects.islands = LiveIslandPolicy::Held;
    held.ran.effects.loose = LooseStructurePolicy::Fe;
    EXPECT_EQ(textOf(remedySettingOf(findingOf("simulation.live_islands"), held)), "live_islands=released");
    EXPECT_EQ(textOf(remedySettingOf(findingOf("effect.not_held"), held)), "") << "it was so already";
    RemedyGrounds raised = grounds;
    raised.ran.simulation.stepRate = 60.0;
    EXPECT_EQ(textOf(remedySettingOf(findingOf("simulation.speed_held"), raised)), "") << "more steps did not help";
    EXPECT_EQ(meanStepRate(600, 10.0), 60.0);
    EXPECT_EQ(meanStepRate(600, 0.0), 0.0);
}

}  // namespace
}  // namespace rubble
