#include "tests/support/small_collapse.h"

#include <array>

#include "core/base/standard_gravity.h"
#include "tests/support/command_run.h"

namespace rubble::cli {

io::ExodusBuilder smallCollapse() {
    io::ExodusBuilder builder;
    builder.addCubes(3, "deck", 1);
    builder.addCubes(3, "girder", 2);
    builder.addCubes(3, "pier", 3);
    constexpr std::size_t fallingNodes = 32;
    for (std::size_t n = 0; n < fallingNodes; ++n) {
        builder.nodes[n].z() += 2.0;
    }
    for (io::ExodusBuilder::Block& block : builder.blocks) {
        block.attributeNames = {"DENSITY"};
        block.attributeCount = 1;
        block.attributes.assign(static_cast<std::size_t>(block.elements()), 2000.0);
    }
    builder.times = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5};
    const auto times = builder.times;
    builder.nodal.emplace_back("disp_x", [](std::size_t, std::size_t) { return 0.0; });
    builder.nodal.emplace_back("disp_y", [](std::size_t, std::size_t) { return 0.0; });
    builder.nodal.emplace_back("disp_z", [times](std::size_t state, std::size_t node) {
        return node < fallingNodes ? -0.5 * standardGravity * times[state] * times[state] : 0.0;
    });
    builder.element.emplace_back("STATUS", [](std::size_t state, std::size_t element) {
        constexpr std::array<std::size_t, smallElements> deathState{1, 1, 2, 2, 2, 9, 9, 9, 9};
        return state < deathState[element] ? 1.0 : 0.0;
    });
    return builder;
}

std::string writeSmallCollapse(const std::string& path) {
    smallCollapse().write(path);
    return path;
}

nlohmann::json SmallRun::run(std::vector<std::string> more, const std::string& settleTime) {
    std::vector<std::string> words{"run", m_path, "--out", m_out, "--json", "--set", "settle_time=" + settleTime};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = cli(words);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return outcome.json();
}

}  // namespace rubble::cli
