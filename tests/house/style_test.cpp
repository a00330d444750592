#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "tests/house/source_tree.h"
#include "tests/support/places.h"

namespace rubble::house {

namespace {

constexpr std::size_t longestFile = 600;

bool comment(const std::string& line) {
    const std::size_t first = line.find_first_not_of(' ');
    return first != std::string::npos && line.compare(first, 2, "//") == 0;
}

TEST(Style, NoFileIsLongerThan600Lines) {
    const std::vector<SourceFile> files = allSources();
    ASSERT_GT(files.size(), 100u) << "the sources were not found";
    for (const SourceFile& file : files) {
        EXPECT_LE(file.lines.size(), longestFile) << file.path << ": split it by noun";
    }
}

TEST(Style, FilesAreNamedInSnakeCaseAndByNouns) {
    const std::regex snake("^[a-z][a-z0-9]*(_[a-z0-9]+)*$");
    const std::regex vague("(^|_)(utils?|helpers?|managers?|misc|common)(_|$)");
    for (const SourceFile& file : allSources()) {
        const std::string name = std::filesystem::path(file.path).stem().string();
        EXPECT_TRUE(std::regex_match(name, snake)) << file.path;
        EXPECT_FALSE(std::regex_search(name, vague)) << file.path << ": name it by what it holds";
    }
}

TEST(Style, HeadersAreGuardedByPragmaOnce) {
    for (const SourceFile& file : allSources()) {
        if (file.header()) {
            ASSERT_FALSE(file.lines.empty()) << file.path << " is empty";
            EXPECT_EQ(file.lines.front(), "#pragma once") << file.path;
        }
    }
}

TEST(Style, TypesAreUpperCamel) {
    const std::regex type(
        R"(^\s*(?:template <[^>]*>\s*)?(?:class|struct|enum class|enum) ([A-Za-z_][A-Za-z0-9_]*)\s*(?:final\s*)?(?::[^:]|\{))");
    const std::regex upperCamel("^[A-Z][A-Za-z0-9]*$");
    std::size_t found = 0;
    for (const SourceFile& file : allSources()) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            std::smatch match;
            if (std::regex_search(file.lines[i], match, type)) {
                ++found;
                // The operating system's own types keep their names, as in `struct sigaction action {};`.
                EXPECT_TRUE(std::regex_match(match[1].str(), upperCamel)) << place(file, i + 1) << ": " << match[1];
            }
        }
    }
    EXPECT_GT(found, 100u);
}

// Members of a class start with m_ or are constants; plain structs have no prefix.
TEST(Style, MembersOfStructsHaveNoPrefix) {
    const std::regex structStart(R"(^struct [A-Z][A-Za-z0-9]* \{$)");
    const std::regex prefixed(R"(^    [A-Za-z_:<>,0-9 \*&]+ m_[A-Za-z0-9]+( = .*|\{.*)?;)");
    for (const SourceFile& file : allSources()) {
        bool inside = false;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            inside = inside ? file.lines[i] != "};" : std::regex_match(file.lines[i], structStart);
            EXPECT_FALSE(inside && std::regex_search(file.lines[i], prefixed)) << place(file, i + 1);
        }
    }
}

TEST(Style, EverythingLivesInANamespaceOfTheHouse) {
    for (const SourceFile& file : programSources()) {
        if (file.path.ends_with("main.cpp")) {
            continue;
        }
        const bool named = std::any_of(file.lines.begin(), file.lines.end(),
                                       [](const std::string& line) { return line.starts_with("namespace rubble"); });
        EXPECT_TRUE(named) << file.path;
        for (std::size_t i = 0; file.header() && i < file.lines.size(); ++i) {
            EXPECT_EQ(file.lines[i].find("using namespace"), std::string::npos) << place(file, i + 1);
        }
    }
}

TEST(Style, LinesHaveNoTabsAndUnixEnds) {
    for (const SourceFile& file : allSources()) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string& line = file.lines[i];
            EXPECT_EQ(line.find('\t'), std::string::npos) << place(file, i + 1) << ": a tab";
            EXPECT_EQ(line.find('\r'), std::string::npos) << place(file, i + 1) << ": a carriage return";
        }
    }
}

TEST(Style, NothingIsLeftOpen) {
    // Put together here, so that this file does not find itself.
    const std::regex open(std::string("\\b(TO") + "DO|FIX" + "ME|XX" + "X|HA" + "CK)\\b");
    const std::regex off(std::string("GTEST_") + "SKIP|DISABLED" + "_");
    for (const SourceFile& file : allSources()) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            EXPECT_FALSE(std::regex_search(file.lines[i], open)) << place(file, i + 1);
            EXPECT_FALSE(std::regex_search(file.lines[i], off)) << place(file, i + 1) << ": a test that is switched off";
        }
    }
}

TEST(Style, NoPathOfAMachineAndNoBanner) {
    const std::regex machine("(^|[\"' (=])/(home|root|work)/");
    const std::regex banner("^\\s*//\\s*[-=*#/]{8,}");
    const std::regex author("@author|[Cc]opyright \\(c\\)");
    for (const SourceFile& file : allSources()) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            if (file.path == "tests/house/style_test.cpp") {
                continue;
            }
            EXPECT_FALSE(std::regex_search(file.lines[i], machine)) << place(file, i + 1) << ": a path of one machine";
            EXPECT_FALSE(comment(file.lines[i]) && std::regex_search(file.lines[i], banner)) << place(file, i + 1) << ": a banner";
            EXPECT_FALSE(std::regex_search(file.lines[i], author)) << place(file, i + 1) << ": authorship";
        }
    }
}

// The order of an unordered container is nobody's promise, and results must repeat bit by bit: such a container may be looked
// into, never walked through.
TEST(Style, CoreAndIoWalkThroughNoUnorderedContainer) {
    const std::regex declaration(R"(std::unordered_[a-z]+<.*>&? ([A-Za-z_]+)( = .*|\{.*)?[;,)])");
    const std::vector<SourceFile> files = readSources({"core", "io"});
    for (const SourceFile& file : files) {
        const std::string stem = file.path.substr(0, file.path.rfind('.'));
        for (const std::string& line : file.lines) {
            std::smatch match;
            if (!std::regex_search(line, match, declaration)) {
                EXPECT_EQ(line.find("std::unordered_"), std::string::npos) << file.path << ": " << line;
                continue;
            }
            const std::regex walk("for \\(.* : (this->)?" + match[1].str() + "\\)|\\b" + match[1].str() + "\\.c?begin\\(");
            for (const SourceFile& user : files) {
                if (user.path.substr(0, user.path.rfind('.')) != stem) {
                    continue;
                }
                for (std::size_t i = 0; i < user.lines.size(); ++i) {
                    EXPECT_FALSE(std::regex_search(user.lines[i], walk)) << place(user, i + 1) << ": its order reaches a result";
                }
            }
        }
    }
}

// Distributions of the standard library differ between implementations.
TEST(Style, TheProgramUsesNoDistributionsOfTheStandardLibrary) {
    const std::regex distribution(R"(std::[a-z_]+_distribution|std::random_device|\brand\(\))");
    for (const SourceFile& file : programSources()) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            EXPECT_FALSE(std::regex_search(file.lines[i], distribution)) << place(file, i + 1);
        }
    }
}

TEST(Style, PackagesAreListedOnceInOrder) {
    std::ifstream stream(sourcePath("packages.txt"));
    std::vector<std::string> packages;
    for (std::string line; std::getline(stream, line);) {
        packages.push_back(line);
    }
    ASSERT_GT(packages.size(), 10u);
    EXPECT_TRUE(std::is_sorted(packages.begin(), packages.end()));
    EXPECT_EQ(std::adjacent_find(packages.begin(), packages.end()), packages.end());
    for (const std::string& package : packages) {
        EXPECT_TRUE(std::regex_match(package, std::regex("[a-z0-9][a-z0-9+.-]+"))) << package;
    }
}

TEST(Style, LicenceIsBsdThreeClause) {
    std::ifstream stream(sourcePath("LICENSE"));
    std::stringstream text;
    text << stream.rdbuf();
    for (const char* part : {"BSD 3-Clause License", "The Rubble authors", "Neither the name of the copyright holder"}) {
        EXPECT_NE(text.str().find(part), std::string::npos) << part;
    }
}

}  // namespace

}  // namespace rubble::house
