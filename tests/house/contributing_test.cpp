#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/places.h"

namespace rubble::house {

namespace {

namespace fs = std::filesystem;

/// What a page says at a line.
struct Said {
    std::string text;
    std::string place;  ///< "docs/solver.md:12"
};

/// The pages in docs, from the root of the tree.
std::vector<std::string> pagesOfDocs() {
    std::vector<std::string> pages;
    for (const fs::directory_entry& entry : fs::directory_iterator(sourcePath("docs"))) {
        if (entry.path().extension() == ".md") {
            pages.push_back("docs/" + entry.path().filename().string());
        }
    }
    std::sort(pages.begin(), pages.end());
    return pages;
}

/// The first group of every match in a page, blocks of code left out.
std::vector<Said> matchesIn(const std::string& page, const std::regex& pattern) {
    std::ifstream file(sourcePath(page));
    EXPECT_TRUE(file) << page;
    std::vector<Said> found;
    bool inCode = false;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (line.starts_with("```")) {
            inCode = !inCode;
        } else if (!inCode) {
            for (std::sregex_iterator at(line.begin(), line.end(), pattern); at != std::sregex_iterator(); ++at) {
                found.push_back({(*at)[1].str(), page + ":" + std::to_string(number)});
            }
        }
    }
    EXPECT_FALSE(inCode) << page << " leaves a block of code open";
    return found;
}

/// Whether a text names a file or folder of the tree; patterns, commands and what is built do not.
bool namesAPath(const std::string& text) {
    return text.find('/') != std::string::npos && text.find_first_of(" <*{") == std::string::npos && !text.starts_with("build/") &&
           !text.starts_with("out/");
}

}  // namespace

TEST(Contributing, PathsThatPagesNameExist) {
    std::vector<std::string> pages = pagesOfDocs();
    pages.insert(pages.end(), {"ARCHITECTURE.md", "CONTRIBUTING.md"});
    std::size_t checked = 0;
    for (const std::string& page : pages) {
        for (const Said& quoted : matchesIn(page, std::regex("`([^`]+)`"))) {
            if (namesAPath(quoted.text)) {
                ++checked;
                EXPECT_TRUE(fs::exists(sourcePath(quoted.text))) << quoted.place << ": " << quoted.text;
            }
        }
    }
    EXPECT_GT(checked, 100u) << "the paths were not found";
}

TEST(Contributing, RelativeLinksLeadSomewhere) {
    std::vector<std::string> pages = pagesOfDocs();
    pages.insert(pages.end(), {"ARCHITECTURE.md", "CHANGELOG.md", "CONTRIBUTING.md", "README.md"});
    const std::regex elsewhere("^[a-z]+:");
    std::size_t checked = 0;
    for (const std::string& page : pages) {
        for (const Said& link : matchesIn(page, std::regex(R"(\]\(([^)]+)\))"))) {
            const std::string target = link.text.substr(0, link.text.find('#'));
            if (!target.empty() && !std::regex_search(target, elsewhere)) {
                ++checked;
                EXPECT_TRUE(fs::exists(fs::path(sourcePath(page)).parent_path() / target)) << link.place << ": " << link.text;
            }
        }
    }
    EXPECT_GT(checked, 40u) << "the links were not found";
}

// One sitting is enough to read it; what one room alone needs stands in docs.
TEST(Contributing, ArchitectureStaysShort) {
    EXPECT_LE(fs::file_size(sourcePath("ARCHITECTURE.md")), 12'000u);
}

TEST(Contributing, OnlyPathsAreTakenForPaths) {
    EXPECT_TRUE(namesAPath("core/fe/mesh.h"));
    EXPECT_TRUE(namesAPath("./run"));
    for (const char* other :
         {"packages.txt", "./run test", "io/fe/result_frame.*", "tests/<folder>", "build/dev", "out/a.png", "a/{b,c}"}) {
        EXPECT_FALSE(namesAPath(other)) << other;
    }
}

// A program that asks for an older minor version cannot be configured: before 1.0 each may change the interface.
TEST(Contributing, ExamplesAskForThisVersion) {
    const std::regex own(R"(^project\(Rubble VERSION (\d+\.\d+))"), asked(R"(find_package\(Rubble (\d+\.\d+))");
    const std::vector<Said> versions = matchesIn("CMakeLists.txt", own);
    const std::vector<Said> examples = matchesIn("resources/examples/library/CMakeLists.txt", asked);
    ASSERT_EQ(versions.size(), 1u);
    ASSERT_FALSE(examples.empty());
    for (const Said& example : examples) {
        EXPECT_EQ(example.text, versions.front().text) << example.place;
    }
}

}  // namespace rubble::house
