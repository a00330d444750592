#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::house {

namespace {

/// What cmake/commit.cmake writes for a folder of sources.
std::string commitOf(const std::string& folder, const std::string& header) {
    const std::string command = "GIT_CEILING_DIRECTORIES=" + folder + " cmake -D SOURCE=" + folder + " -D OUT=" + header + " -P " +
                                sourcePath("cmake/commit.cmake");
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::ifstream written(header);
    const std::string text{std::istreambuf_iterator<char>(written), {}};
    const std::size_t begin = text.find('"') + 1;
    return text.substr(begin, text.find('"', begin) - begin);
}

}  // namespace

// A bundle tells by which commit it was made: a wrong one would send its reader to other sources.
TEST(Commit, IsThatOfTheSourcesAndSaysWhatIsNotCommitted) {
    const io::TemporaryFolder folder, beside;
    const std::string header = beside / "commit.h";
    EXPECT_EQ(commitOf(folder.path(), header), "") << "no checkout";
    std::ofstream(folder / "a.cpp") << "int a;\n";
    const std::string git = "cd " + folder.path() + " && git -c user.name=a -c user.email=a@b ";
    ASSERT_EQ(std::system((git + "init -q && git add a.cpp && " + git + "commit -q -m a").c_str()), 0);
    const std::string commit = commitOf(folder.path(), header);
    EXPECT_EQ(commit.size(), 40u) << commit;
    EXPECT_EQ(commit.find_first_not_of("0123456789abcdef"), std::string::npos);
    std::ofstream(folder / "a.cpp") << "int b;\n";
    EXPECT_EQ(commitOf(folder.path(), header), commit + ", with changes that are not committed");
}

}  // namespace rubble::house
