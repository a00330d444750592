#include "core/scenario/photograph.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

TEST(Photograph, TimesOfExifAreWrittenAsIso8601) {
    EXPECT_EQ(clockTime("2026:03:14 10:22:31"), "2026-03-14 10:22:31");
    EXPECT_EQ(clockTime("2026-03-14 10:22:31"), "2026-03-14 10:22:31") << "what is so stays so";
    EXPECT_EQ(clockTime("2024:02:29 23:59:59.25"), "2024-02-29 23:59:59") << "parts of a second are not kept";
}

TEST(Photograph, WhatIsNoTimeIsUnknown) {
    for (const char* text :
         {"", "0000:00:00 00:00:00", "    :  :     :  :  ", "2026:13:01 00:00:00", "2026:02:29 00:00:00", "2026:01:01 24:00:00",
          "2026:01:01 10:60:00", "2026:01:01", "14.03.2026 10:22:31", "2026:0a:01 00:00:00"}) {
        EXPECT_EQ(clockTime(text), "") << text;
    }
}

}  // namespace
}  // namespace rubble
