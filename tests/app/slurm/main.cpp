#include <gtest/gtest.h>
#include <unistd.h>

#include <iostream>

#include "tests/app/cli/command_run.h"
#include "tests/io/temporary_folder.h"

namespace {

/// The Slurm of one node that all cases run on.
class OneNode : public testing::Environment {
public:
    void SetUp() override {
        const rubble::cli::Outcome outcome =
            rubble::cli::CommandRun().run({m_script, "start", m_folder.path(), std::to_string(getpid())});
        ASSERT_EQ(outcome.exitCode, 0) << "Slurm could not be started; packages.txt lists what it takes\n" << outcome.err;
        setenv("SLURM_CONF", (m_folder / "slurm.conf").c_str(), 1);
    }
    void TearDown() override { rubble::cli::CommandRun().run({m_script, "stop", m_folder.path()}); }

private:
    const std::string m_script = rubble::cli::sourcePath("tests/app/slurm/one_node.sh");
    rubble::io::TemporaryFolder m_folder;
};

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    testing::AddGlobalTestEnvironment(new OneNode);
    return RUN_ALL_TESTS();
}
