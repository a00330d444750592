#include "bench/results_page.h"

#include <gtest/gtest.h>

namespace rubble::bench {

namespace {

Section sectionOf(const std::string& title, const std::string& figure) {
    Section section;
    section.title = title;
    section.about = "About " + title + ".";
    section.circumstances = {
        "2026-01-02 03:04", "AMD EPYC, 2 threads, 7.6 GiB", "1a2b3c4d5e", "Rubble 1.2.3, without asserts", 0.25, 31.4};
    section.tables = {{{"rubble-bench --benchmark_filter='a|b'"}, {{"", "ms"}, {{"ours", figure}}}}};
    return section;
}

const std::vector<std::string> order{"One", "Two", "Three"};

}  // namespace

TEST(ResultsPage, ATableFillsShortRowsAndEscapesBars) {
    EXPECT_EQ(tableText({{"a", "b"}, {{"1|2"}, {"3", "4"}}}), "| a | b |\n|---|---|\n| 1\\|2 |  |\n| 3 | 4 |\n");
}

TEST(ResultsPage, ASectionSaysWhenWhereAndByWhichCommand) {
    EXPECT_EQ(sectionText(sectionOf("One", "5")),
              "## One\n\nAbout One.\n\n"
              "Measured 2026-01-02 03:04 UTC on AMD EPYC, 2 threads, 7.6 GiB. Commit 1a2b3c4d5e; Rubble 1.2.3, without asserts. "
              "Load before: 0.25. All commands: 31 s.\n"
              "\n```\nrubble-bench --benchmark_filter='a|b'\n```\n\n|  | ms |\n|---|---|\n| ours | 5 |\n");
}

TEST(ResultsPage, AMeasuredSectionTakesThePlaceOfTheOneBefore) {
    std::string page = pageWith("", "# Page\n", {sectionOf("One", "1"), sectionOf("Two", "2"), sectionOf("Three", "3")}, order);
    const std::string before = page;
    page = pageWith(page, "# Page\n", {sectionOf("Two", "7")}, order);
    EXPECT_NE(page, before);
    EXPECT_EQ(page, pageWith("", "# Page\n", {sectionOf("One", "1"), sectionOf("Two", "7"), sectionOf("Three", "3")}, order));
}

TEST(ResultsPage, ANewSectionStandsWhereTheOrderHasIt) {
    const std::string page =
        pageWith("", "# Page\n", {sectionOf("Three", "3"), sectionOf("One", "1"), sectionOf("Two", "2")}, order);
    EXPECT_LT(page.find("## One"), page.find("## Two"));
    EXPECT_LT(page.find("## Two"), page.find("## Three"));
}

TEST(ResultsPage, WhatIsNotMeasuredStays) {
    const std::string page =
        pageWith("# Old\n\n## By hand\n\nText.\n\n```\n## no heading\n```\n", "# New\n", {sectionOf("One", "1")}, order);
    EXPECT_TRUE(page.starts_with("# New\n\n"));
    EXPECT_NE(page.find("## By hand\n\nText.\n\n```\n## no heading\n```\n"), std::string::npos);
    EXPECT_EQ(page.find("# Old"), std::string::npos);
}

}  // namespace rubble::bench
