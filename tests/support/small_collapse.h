#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/exodus_builder.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

/// A collapse small enough to simulate within a second: two blocks of three cubes of 1 m that fall from 2 m, five of which are
/// deactivated at the states 1 (0.1 s) and 2 (0.2 s), beside a third block that stands on the ground and lives. Six states, 0.5 s.
/// Flag STATUS (1 active), displacements, density 2,000 kg/m3.
inline constexpr int smallElements = 9;
inline constexpr int smallDead = 5;
io::ExodusBuilder smallCollapse();

/// Writes it to a file and returns the path.
std::string writeSmallCollapse(const std::string& path);

/// The small collapse in a folder of its own, and its run.
class SmallRun : public testing::Test {
protected:
    /// Runs it into m_out with so many seconds to settle; the JSON of the run.
    nlohmann::json run(std::vector<std::string> more, const std::string& settleTime);

    io::TemporaryFolder m_folder;
    std::string m_path = writeSmallCollapse(m_folder / "small.exo");
    std::string m_out = m_folder / "small.run.h5";
};

}  // namespace rubble::cli
