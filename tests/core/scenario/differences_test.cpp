#include "core/scenario/differences.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace rubble {

TEST(Differences, AreEmptyBetweenEqualScenariosAndSymmetric) {
    Scenario a;
    a.components["deck"].density = 2350.0;
    Scenario b = a;
    EXPECT_TRUE(differencesBetween(a, b).empty());
    setParameter(b, "friction", 0.65);
    setParameter(b, "component[pier].density", 1900.0);
    setParameter(b, "component[deck].density", {});
    const auto there = differencesBetween(a, b);
    const auto back = differencesBetween(b, a);
    ASSERT_EQ(there.size(), 3U);
    ASSERT_EQ(back.size(), 3U);
    for (const SettingDifference& each : there) {
        EXPECT_EQ(each.first, parameterValue(a, each.row->keyFor(each.subject))) << each.row->key;
        EXPECT_EQ(each.second, parameterValue(b, each.row->keyFor(each.subject))) << each.row->key;
    }
}

TEST(Differences, ThatAreTheSameForSeveralComponentsAreToldOnce) {
    Scenario stone;
    for (const char* name : {"deck", "pier", "wall"}) {
        stone.components[name].material = Material::Stone;
    }
    stone.components["roof"].material = Material::Steel;
    setParameter(stone, "friction", 0.65);
    const auto shared = sharedDifferences(differencesBetween({}, stone));
    ASSERT_EQ(shared.size(), 3U);
    EXPECT_EQ(shared[0].key(), "component[*].material (3)");
    EXPECT_EQ(shared[0].subjects, (std::vector<std::string>{"deck", "pier", "wall"}));
    EXPECT_EQ(shared[0].change.second, ParameterValue(std::string("stone")));
    EXPECT_EQ(shared[1].key(), "component[roof].material");
    EXPECT_EQ(shared[2].key(), "friction");
}

// Every row of the table is compared: what can be set shows as a difference.
TEST(Differences, SeeEveryParameter) {
    for (const Parameter& row : parameterTable()) {
        const std::string key = row.keyFor(row.subject() == ParameterSubject::Pair ? "stone,soil" : "deck");
        Scenario other;
        ParameterValue value = row.low + std::min(1.0, row.high - row.low) * 0.7071;
        if (row.kind == ParameterKind::Switch) {
            const ParameterValue before = parameterValue(other, key);
            value = std::holds_alternative<bool>(before) ? !std::get<bool>(before) : true;
        } else if (row.kind == ParameterKind::Integer) {
            value = static_cast<std::int64_t>(std::max(row.low, 1.0)) + 2;
        } else if (row.kind == ParameterKind::Choice) {
            value = std::string(row.choices.back());
            if (value == parameterValue(other, key)) {
                value = std::string(row.choices.front());
            }
        } else if (row.kind == ParameterKind::Text) {
            value = std::string("NAME");
        }
        setParameter(other, key, value);
        const auto found = differencesBetween(Scenario(), other);
        ASSERT_EQ(found.size(), 1U) << key;
        EXPECT_EQ(found[0].row->key, row.key);
        EXPECT_EQ(found[0].second, value);
    }
}

}  // namespace rubble
