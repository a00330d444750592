#include "core/scenario/setting_names.h"

#include <gtest/gtest.h>

#include "core/scenario/parameters.h"

namespace rubble {
namespace {

std::string quoted(std::string_view label) {
    return "“" + std::string(label) + "”";
}

// "raise “Steps per second” or substeps": a key without underscore stood as it is.
TEST(SettingNames, EachKeyOfTheTableIsNamedInAList) {
    const std::string known = quoted(findParameter("step_rate").first->label);
    for (const Parameter& row : parameterTable()) {
        std::string spoken(row.key);
        if (row.keyed()) {
            spoken.replace(spoken.find("[*]"), 3, "[NAME]");
        }
        EXPECT_EQ(withSettingNames("raise step_rate or " + spoken + "; that helps"),
                  "raise " + known + " or " + quoted(row.label) + "; that helps");
        EXPECT_EQ(withSettingNames("请提高 " + spoken + "、step_rate。"), "请提高 " + quoted(row.label) + "、" + known + "。");
        EXPECT_EQ(withSettingNames("look (" + spoken + ")"), "look (" + quoted(row.label) + ")");
    }
}

TEST(SettingNames, ValuesAreWordsToo) {
    EXPECT_EQ(withSettingNames("set auto_remedy = true, revival=latch."),
              "set " + quoted(findParameter("auto_remedy").first->label) + " = on, " +
                  quoted(findParameter("revival").first->label) + " = latch.");
    EXPECT_EQ(withSettingNames("set component[{0}].density, or component[NAME].structural = false"),
              "set “Density” of “{0}”, or " + quoted(findParameter("component[deck].structural").first->label) + " = off");
}

TEST(SettingNames, WordsOfASentenceStayWords) {
    for (const char* text : {"soft contacts in small substeps; friction holds them on the ground", "a list[1].of things",
                             "fe, terrain, photograph or survey", "overlap and friction", "its multiple decides nothing",
                             "soft-ground (water-filled)", "", "a = b"}) {
        EXPECT_EQ(withSettingNames(text), text);
    }
}

TEST(SettingNames, AreSaidInAnotherLanguage) {
    const auto say = [](std::string_view context, std::string_view english, std::string_view) {
        return std::string(context) + ':' + std::string(english);
    };
    EXPECT_EQ(withSettingNames("auto_remedy = true", say),
              "“parameters:" + std::string(findParameter("auto_remedy").first->label) + "” = rubble:on");
}

}  // namespace
}  // namespace rubble
