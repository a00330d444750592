#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/support/places.h"

namespace rubble::house {

namespace {

namespace fs = std::filesystem;

const fs::path& folder() {
    static const fs::path path = fs::path(sourcePath("resources/manual"));
    return path;
}

std::set<std::string> pagesIn(const fs::path& where) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(where)) {
        if (entry.path().extension() == ".md") {
            names.insert(entry.path().filename().string());
        }
    }
    return names;
}

std::vector<std::string> linesOf(const fs::path& page) {
    std::ifstream file(page);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// "#", "##", ... in their order.
std::vector<std::string> headingLevels(const fs::path& page) {
    std::vector<std::string> levels;
    for (const std::string& line : linesOf(page)) {
        if (line.starts_with('#')) {
            levels.push_back(line.substr(0, line.find_first_not_of('#')));
        }
    }
    return levels;
}

/// What a page links to or shows, in its order.
std::vector<std::string> targets(const fs::path& page) {
    static const std::regex link(R"(\]\(([^)]+)\))");
    std::vector<std::string> found;
    for (const std::string& line : linesOf(page)) {
        for (std::sregex_iterator at(line.begin(), line.end(), link); at != std::sregex_iterator(); ++at) {
            found.push_back((*at)[1].str());
        }
    }
    return found;
}

}  // namespace

TEST(Manual, EveryPageExistsInBothLanguages) {
    const std::set<std::string> english = pagesIn(folder());
    ASSERT_GT(english.size(), 20u);
    EXPECT_EQ(pagesIn(folder() / "zh_CN"), english);
}

// Headings are asked for in English and found by their order; pictures and links are the same in every language.
TEST(Manual, PagesHaveTheSameHeadingsAndTargetsInBothLanguages) {
    for (const std::string& name : pagesIn(folder())) {
        EXPECT_EQ(headingLevels(folder() / "zh_CN" / name), headingLevels(folder() / name)) << name;
        EXPECT_EQ(targets(folder() / "zh_CN" / name), targets(folder() / name)) << name;
    }
}

TEST(Manual, WhatPagesLinkToIsThere) {
    for (const std::string& name : pagesIn(folder())) {
        for (const std::string& target : targets(folder() / name)) {
            const std::string file = target.substr(0, target.find('#'));
            EXPECT_TRUE(target.starts_with("http") || file.empty() || fs::exists(folder() / file)) << name << ": " << target;
        }
    }
}

}  // namespace rubble::house
