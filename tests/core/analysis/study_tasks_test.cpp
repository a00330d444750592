#include "core/analysis/accuracy/study_tasks.h"

#include <gtest/gtest.h>

#include "core/analysis/accuracy/influence.h"
#include "core/base/error.h"
#include "tests/scenes/fe_scenes.h"
#include "tests/scenes/memory_store.h"

namespace rubble {
namespace {

/// A wall that falls, and what water of 0.5 m changes in it.
class StudyTasks : public testing::Test {
protected:
    void SetUp() override {
        inputs.fe = scenes::collapsingWall();
        scenario.simulation.settleTime = 1.0;
        scenario.effects.waterLevel = 0.5;
        settings.threads = 2;
    }
    std::vector<StudyTask> tasks() const { return influenceTasks(inputs, scenario, effects, settings, Execution()); }
    InfluenceReport study(const WorldChoice& choice) {
        return influence(inputs, scenario, effects, settings, Execution(), {&store, "a machine", choice});
    }
    Inputs inputs;
    Scenario scenario;
    StudySettings settings;
    std::vector<EffectKind> effects{EffectKind::Water};
    MemoryStore store;
};

TEST_F(StudyTasks, OneByOneTheyMakeWhatTheStudyMakes) {
    const std::vector<StudyTask> list = tasks();
    ASSERT_EQ(list.size(), 4u) << "the run, two repeats, water";
    for (std::size_t i = 0; i < list.size(); ++i) {
        study(WorldChoice::only(list[i].origin.key));
        EXPECT_EQ(store.worlds.size(), i + 1);
        EXPECT_TRUE(store.worlds.contains(list[i].origin.key)) << list[i].name;
    }
    const InfluenceReport collected = study(WorldChoice::none());
    EXPECT_EQ(store.order.size(), 4u) << "collecting simulates nothing";
    EXPECT_TRUE(collected.complete);
    const InfluenceReport whole = influence(inputs, scenario, effects, settings, Execution());
    EXPECT_EQ(collected.floor->trajectoryHash, whole.floor->trajectoryHash);
    EXPECT_EQ(collected.floor->largest.values, whole.floor->largest.values);
    EXPECT_EQ(collected.effects[0].trajectoryHash, whole.effects[0].trajectoryHash);
    EXPECT_EQ(collected.effects[0].difference.values, whole.effects[0].difference.values);
}

TEST_F(StudyTasks, WhatIsMissingIsLeftOpen) {
    const InfluenceReport none = study(WorldChoice::none());
    EXPECT_FALSE(none.complete);
    EXPECT_FALSE(none.floor);
    study(WorldChoice::only(tasks()[0].origin.key));
    const InfluenceReport one = study(WorldChoice::none());
    EXPECT_FALSE(one.complete);
    ASSERT_TRUE(one.floor);
    EXPECT_TRUE(one.floor->repeats.empty());
    EXPECT_FALSE(one.effects[0].done);
}

TEST_F(StudyTasks, AWorldOfAnotherStudyIsRefused) {
    EXPECT_THROW(study(WorldChoice::only(Digest())), UsageError);
    EXPECT_EQ(store.order.size(), 0u);
}

TEST(StudyTask, DigestsComeBackFromTheirDigits) {
    const Digest digest = Hasher().text("a world").finish();
    EXPECT_EQ(digestFromHex(digest.hex()), digest);
    for (const char* wrong :
         {"", "12", "0123456789abcdef0123456789abcdeF", "0123456789abcdef0123456789abcdefa", "g123456789abcdef0123456789abcdef"}) {
        EXPECT_FALSE(digestFromHex(wrong)) << wrong;
    }
}

TEST(StudyTask, OneKeyIsOneTask) {
    StudyTask first;
    first.name = "member 0";
    StudyTask second = first;
    second.name = "member 1";
    StudyTask third;
    third.origin.key = Hasher().text("other").finish();
    const std::vector<StudyTask> distinct = distinctTasks({first, second, third});
    ASSERT_EQ(distinct.size(), 2u);
    EXPECT_EQ(distinct[0].name, "member 0");
    EXPECT_EQ(distinct[1].origin.key, third.origin.key);
}

}  // namespace
}  // namespace rubble
