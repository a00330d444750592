#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>

#include "tests/support/command_run.h"
#include "tests/support/places.h"
#include "tests/support/run_tests.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

/// A fenced block of the README that a comment marks for testing.
struct Block {
    bool output = false;  ///< lines that the commands before it print; otherwise commands
    std::vector<std::string> lines;
};

std::vector<Block> markedBlocks() {
    std::istringstream stream(textOf(sourcePath("README.md")));
    std::vector<Block> blocks;
    std::string mark;
    bool inside = false;
    for (std::string line; std::getline(stream, line);) {
        if (inside && line == "```") {
            inside = false;
        } else if (inside) {
            blocks.back().lines.push_back(line);
        } else if (!mark.empty() && line.starts_with("```")) {
            blocks.push_back({mark == "<!-- output -->", {}});
            mark.clear();
            inside = true;
        } else if (line == "<!-- tested -->" || line == "<!-- output -->") {
            mark = line;
        }
    }
    return blocks;
}

/// Repeating the tour's run takes as long as the run: only the whole tests do. Others repeat smaller ones, and hold hashes of the
/// samples.
bool isOfEveryDay(const std::string& command) {
    return command.find("rubble-cli verify") == std::string::npos;
}

// The tour is walked in a folder that has the samples and the programs where the README says they are.
TEST(Readme, ItsCommandsRunAndPrintWhatItShows) {
    const io::TemporaryFolder folder;
    fs::create_directories(folder / "build/release");
    fs::create_directory_symlink(sourcePath("resources"), folder / "resources");
    fs::create_directory_symlink(buildPath("bin"), folder / "build/release/bin");
    std::size_t commands = 0;
    std::size_t shown = 0;
    std::string printed;
    bool all = true;  // commands of the block ran
    for (const Block& block : markedBlocks()) {
        if (!block.output) {
            printed.clear();
            all = true;
        } else if (!all) {
            continue;
        }
        std::string begun;
        for (const std::string& part : block.lines) {
            // A backslash carries a command on to the next line.
            if (!block.output && part.ends_with('\\')) {
                begun += part.substr(0, part.size() - 1);
                continue;
            }
            const std::string line = std::exchange(begun, "") + part;
            if (block.output) {
                ++shown;
                EXPECT_TRUE(line == "..." || printed.find(line + "\n") != std::string::npos) << "not printed: " << line;
                continue;
            }
            ++commands;
            if (!wholeTests() && !isOfEveryDay(line)) {
                all = false;
                continue;
            }
            const Outcome outcome = CommandRun().in(folder.path()).with("DISPLAY", std::nullopt).run({"sh", "-ec", line});
            EXPECT_EQ(outcome.exitCode, 0) << line << '\n' << outcome.err;
            printed += outcome.out;
        }
    }
    EXPECT_GE(commands, 6u);
    EXPECT_GE(shown, 6u);
    EXPECT_GT(fs::file_size(folder / "out/mid-collapse.png"), 10'000u);
    EXPECT_GT(fs::file_size(folder / "out/fragments.csv"), 1'000'000u);
}

TEST(Readme, PicturesAndPagesItNamesExist) {
    const std::string text = textOf(sourcePath("README.md"));
    std::size_t links = 0;
    for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
        const std::string target = text.substr(at + 2, text.find(')', at) - at - 2);
        EXPECT_TRUE(fs::exists(sourcePath(target.substr(0, target.find('#'))))) << target;
        ++links;
    }
    EXPECT_GE(links, 4u);
}

}  // namespace

}  // namespace rubble::cli
