#include "tests/support/run_tests.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

namespace rubble {

namespace {

/// What was asked of a program of tests.
struct Chosen {
    std::string filter;   ///< as GoogleTest takes it
    int inFile = 0;       ///< tests of the file
    int ofWholeOnly = 0;  ///< those of them that run under `./run test all` only
};

bool isOf(const testing::TestInfo& test, std::string_view file) {
    const std::string_view path = test.file();
    return file.empty() || (path.ends_with(file) && (path.size() == file.size() || path[path.size() - file.size() - 1] == '/'));
}

/// Its own name, which for a test with parameters follows its place in the list: "SelfTest/HardCases.WholeColumn/FormColumn".
bool wholeOnly(const testing::TestInfo& test) {
    return std::string_view(test.name()).starts_with("Whole");
}

Chosen chosen(std::string_view file) {
    Chosen result;
    const testing::UnitTest& unit = *testing::UnitTest::GetInstance();
    for (int s = 0; s < unit.total_test_suite_count(); ++s) {
        const testing::TestSuite& suite = *unit.GetTestSuite(s);
        for (int t = 0; t < suite.total_test_count(); ++t) {
            const testing::TestInfo& test = *suite.GetTestInfo(t);
            if (!isOf(test, file)) {
                continue;
            }
            ++result.inFile;
            if (wholeOnly(test) && !wholeTests()) {
                ++result.ofWholeOnly;
                continue;
            }
            result.filter += (result.filter.empty() ? "" : ":") + std::string(suite.name()) + "." + test.name();
        }
    }
    return result;
}

/// The value of --file=PATH, which is taken out of the words; empty if there is none.
std::string takeFile(int& argc, char** argv) {
    constexpr std::string_view option = "--file=";
    std::string file;
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]).starts_with(option)) {
            file = argv[i] + option.size();
        } else {
            argv[kept++] = argv[i];
        }
    }
    argc = kept;
    argv[argc] = nullptr;
    return file;
}

}  // namespace

bool wholeTests() {
    const char* scope = std::getenv("RUBBLE_TESTS");
    return scope && std::string_view(scope) == "all";
}

bool sanitizedTests() {
#ifdef __SANITIZE_ADDRESS__
    return true;
#else
    return false;
#endif
}

int runTests(int argc, char** argv) {
    const std::string file = takeFile(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    if (GTEST_FLAG_GET(filter) == "*") {
        const Chosen tests = chosen(file);
        if (tests.inFile == 0) {
            std::cerr << "No test of this program stands in " << file << '\n';
            return EXIT_FAILURE;
        }
        if (tests.ofWholeOnly > 0) {
            std::cout << tests.ofWholeOnly << " of " << tests.inFile << " tests run under `./run test all` only\n";
        }
        if (tests.filter.empty()) {
            return EXIT_SUCCESS;
        }
        GTEST_FLAG_SET(filter, tests.filter);
    }
    return RUN_ALL_TESTS();
}

}  // namespace rubble
