#include "core/selftest/trajectory_hashes.h"
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "core/selftest/suite.h"
#include "tests/support/places.h"

namespace rubble::selftest {
namespace {

/// Small scenes of every kind: the engine alone, boxes, hulls, terrain, pieces, air, water, ties, and the whole way from a result.
const std::vector<std::string> scenes{
    "topple",    "tower-10", "births-scatter", "terrain",  "hull-toss",       "piece-closes", "coarse-output", "revival-follow",
    "form-spin", "form-air", "form-water",     "form-tie", "births-shuffled", "form-bounce",  "sizes-1cm-10m", "restitution-09"};

std::string hashOf(const std::string& id, bool hashes = true) {
    SuiteSettings settings;
    settings.small = true;
    settings.hashes = hashes;
    return runCase(*chosenCases({id}).front(), settings, Execution()).trajectories.hex();
}

/// The same bits by every compiler, optimisation and processor: `tests/bits/compare.py` holds builds against each other.
TEST(TrajectoryHashes, AreThoseThatWereKept) {
    const std::string path = sourcePath("tests/bits/hashes.txt");
    if (std::getenv("RUBBLE_RENEW_HASHES") != nullptr) {
        std::ofstream file(path);
        for (const std::string& id : scenes) {
            file << id << ' ' << hashOf(id) << '\n';
        }
        ASSERT_TRUE(file.flush());
    }
    std::map<std::string, std::string> kept;
    std::ifstream file(path);
    for (std::string id, hash; file >> id >> hash;) {
        kept[id] = hash;
    }
    EXPECT_EQ(kept.size(), scenes.size());
    for (const std::string& id : scenes) {
        EXPECT_EQ(hashOf(id), kept[id]) << id
                                        << " moves otherwise in some bit; RUBBLE_RENEW_HASHES=1 renews what was meant to change";
    }
}

TEST(TrajectoryHashes, AreMadeOnlyWhereTheyAreAskedFor) {
    EXPECT_EQ(hashOf("form-impact", false), Digest().hex());
    EXPECT_NE(hashOf("form-impact"), Digest().hex());
}

TEST(TrajectoryHashes, DoNotDependOnTheOrderInWhichWorldsEnd) {
    TrajectoryHashes one, other;
    const Digest a{{1}}, b{{2}};
    one.add(a);
    one.add(b);
    other.add(b);
    EXPECT_NE(one.finish(), other.finish());
    other.add(a);
    EXPECT_EQ(one.finish(), other.finish());
}

}  // namespace
}  // namespace rubble::selftest
