#include "core/base/nearest_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rubble {
namespace {

using ::testing::ElementsAre;

const std::vector<std::string> names{"arch ring 1", "arch ring 2", "deck", "Pier 1", "pier 2"};

TEST(NearestNames, TypingErrorsFindTheirName) {
    EXPECT_THAT(nearestNames("dekc", names, 1), ElementsAre("deck"));
    EXPECT_THAT(nearestNames("PIER1", names, 2), ElementsAre("Pier 1", "pier 2"));
    EXPECT_THAT(nearestNames("arch rng 2", names, 1), ElementsAre("arch ring 2"));
}

TEST(NearestNames, TiesKeepTheirOrderAndPreferNamesThatContainIt) {
    const std::vector<std::string> tied{"ab", "ba", "xa"};
    EXPECT_THAT(nearestNames("a", tied, 3), ElementsAre("ab", "ba", "xa"));
    const std::vector<std::string> containing{"b", "ab"};
    EXPECT_THAT(nearestNames("a", containing, 1), ElementsAre("ab"));
}

TEST(NearestNames, EmptyListsAndVeryLongNamesDoNoHarm) {
    EXPECT_TRUE(nearestNames("x", {}).empty());
    const std::vector<std::string> longNames{std::string(100'000, 'a'), "b"};
    EXPECT_EQ(nearestNames(std::string(100'000, 'a'), longNames, 1).front().size(), 100'000u);
}

TEST(QuotedList, SaysHowManyItLeavesOut) {
    EXPECT_EQ(quotedList(names, 2), "\"arch ring 1\", \"arch ring 2\", and 3 more");
    EXPECT_EQ(quotedList({}), "none");
    EXPECT_EQ(quotedList(std::vector<std::string>{"a"}), "\"a\"");
}

}  // namespace
}  // namespace rubble
