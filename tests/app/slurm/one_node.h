#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace rubble {

/// The Slurm of one node that all cases of a program run on.
class OneNode : public testing::Environment {
public:
    void SetUp() override;
    void TearDown() override;

    /// What a program of Slurm says.
    static std::string slurm(const std::vector<std::string>& words);
    static std::string node();
    /// Tasks that are in a state of Slurm, "RUNNING".
    static std::size_t tasksIn(const std::string& state);
    /// Nothing starts any more, or again.
    static void drain();
    static void resume();
    /// As it was before the case.
    static void restore();

private:
    io::TemporaryFolder m_folder;
};

}  // namespace rubble
