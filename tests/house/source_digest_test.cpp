#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace rubble::house {

namespace {

/// What the tool writes for one source of this content; empty if it fails.
std::string digestOf(const std::string& source) {
    const io::TemporaryFolder folder;
    std::ofstream(folder / "list.txt") << "source.cpp\n";
    std::ofstream(folder / "source.cpp") << source;
    const std::string command = RUBBLE_SOURCE_DIGEST " " + folder / "digest.h" + " " + folder.path() + " " + folder / "list.txt";
    if (std::system(command.c_str()) != 0) {
        return "";
    }
    std::ifstream written(folder / "digest.h");
    return {std::istreambuf_iterator<char>(written), {}};
}

std::vector<std::string> resultSources() {
    std::ifstream file(RUBBLE_RESULT_SOURCES);
    std::vector<std::string> paths;
    for (std::string line; std::getline(file, line);) {
        paths.push_back(line);
    }
    return paths;
}

}  // namespace

// Worlds, references and stages are kept under the digest: a better sentence must not throw them away, a change of the code must.
TEST(SourceDigest, CommentsAndWhiteSpaceDoNotCount) {
    const std::string plain = digestOf("int a = 1;\nconst char* b = \"x\";\n");
    ASSERT_NE(plain, "");
    EXPECT_EQ(digestOf("// A comment\nint a = 1;  // another\n\n/* and\n one more */\nconst char*  b = \"x\";\n"), plain);
    EXPECT_EQ(digestOf("int a\t= 1;\nconst char* b = \"x\"; ///< of it\n"), plain);
}

TEST(SourceDigest, EveryCharacterOfTheCodeCounts) {
    const std::string plain = digestOf("int a = 1;\n");
    EXPECT_NE(digestOf("int a = 2;\n"), plain);
    EXPECT_NE(digestOf("#define A 1\nint b;\n"), digestOf("#define A 1 int b;\n"));
    EXPECT_NE(digestOf("int ab;\n"), digestOf("int a b;\n"));
}

TEST(SourceDigest, WhatStandsInQuotesIsNoComment) {
    EXPECT_NE(digestOf("auto a = \"http://one\";\n"), digestOf("auto a = \"http://two\";\n"));
    EXPECT_NE(digestOf("auto a = \"\\\"// one\";\n"), digestOf("auto a = \"\\\"// two\";\n"));
    EXPECT_NE(digestOf("auto a = R\"x(\" // one)\" )x\";\n"), digestOf("auto a = R\"x(\" // two)\" )x\";\n"));
    EXPECT_NE(digestOf("char a = '\"'; int b = 1;\n"), digestOf("char a = '\"'; int b = 2;\n"));
    EXPECT_EQ(digestOf("int a = 1'000; // one\n"), digestOf("int a = 1'000; // two\n"));
    EXPECT_NE(digestOf("auto a = \"two  blanks\";\n"), digestOf("auto a = \"two blanks\";\n"));
}

TEST(SourceDigest, CoversWhatMakesResultsAndNothingThatOnlyLooksAtThem) {
    const std::vector<std::string> sources = resultSources();
    ASSERT_GT(sources.size(), 200u);
    for (const char* path : {"core/engine/soft/soft_step_world.cpp", "core/fragments/rigid_fit.cpp", "core/base/geometry.h",
                             "core/analysis/accuracy/study_world.h", "io/fe/result_frame.cpp", "io/fe/exodus/exodus_reader.cpp"}) {
        EXPECT_NE(std::find(sources.begin(), sources.end(), path), sources.end()) << path;
    }
    for (const std::string& path : sources) {
        EXPECT_TRUE(path.starts_with("core/") || path.starts_with("io/")) << path;
        EXPECT_FALSE(path.starts_with("core/evidence/") || path.starts_with("core/selftest/") ||
                     path.starts_with("io/exports/exports"))
            << path;
    }
}

}  // namespace rubble::house
