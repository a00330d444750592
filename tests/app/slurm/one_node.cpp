#include "tests/app/slurm/one_node.h"

#include <unistd.h>

#include <algorithm>

#include "tests/support/command_run.h"

namespace rubble {

namespace {

std::string script() {
    return sourcePath("tests/app/slurm/one_node.sh");
}

}  // namespace

void OneNode::SetUp() {
    const cli::Outcome outcome = cli::CommandRun().run({script(), "start", m_folder.path(), std::to_string(getpid())});
    ASSERT_EQ(outcome.exitCode, 0) << "Slurm could not be started; packages.txt lists what it takes\n" << outcome.err;
    setenv("SLURM_CONF", (m_folder / "slurm.conf").c_str(), 1);
}

void OneNode::TearDown() {
    cli::CommandRun().run({script(), "stop", m_folder.path()});
}

std::string OneNode::slurm(const std::vector<std::string>& words) {
    return cli::CommandRun().run(words).out;
}

std::string OneNode::node() {
    const std::string out = slurm({"sinfo", "--noheader", "--format=%n"});
    return out.substr(0, out.find('\n'));
}

std::size_t OneNode::tasksIn(const std::string& state) {
    const std::string out = slurm({"squeue", "--noheader", "--array", "--states=" + state, "--format=%i"});
    return static_cast<std::size_t>(std::count(out.begin(), out.end(), '\n'));
}

void OneNode::drain() {
    slurm({"scontrol", "update", "nodename=" + node(), "state=drain", "reason=test"});
}

void OneNode::resume() {
    slurm({"scontrol", "update", "nodename=" + node(), "state=resume"});
}

void OneNode::restore() {
    slurm({"scancel", "--user=root"});
    resume();
}

}  // namespace rubble
