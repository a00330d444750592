#include "io/run/settled_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "io/json/ensemble_json.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

WorldOrigin memberOrigin() {
    WorldOrigin origin;
    origin.key = Hasher().text("member").finish();
    origin.build = "some build";
    origin.feSha256 = std::string(64, 'a');
    origin.machine = "some machine";
    return origin;
}

SettledWorld settledWorld() {
    SettledWorld settled;
    settled.world.trajectoryHash = Hasher().text("trajectory").finish();
    settled.world.endTime = 12.5;
    CarriedIsland& island = settled.islands.emplace_back();
    island.elements = {idAt<ElementIndex>(3), idAt<ElementIndex>(70000)};
    island.state = 17;
    island.moved = {Vec3(1.0 / 3.0, -2.0, 1e-300), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()))};
    settled.arrivals.squares = {{-3, 4, 1.0 / 3.0}, {0, -70, 12.25}};
    return settled;
}

TEST(SettledFiles, WhatIsKeptComesBackToTheBit) {
    const TemporaryFolder folder;
    SettledFiles files(folder.path());
    Findings findings;
    EXPECT_FALSE(files.settled(memberOrigin(), findings));
    files.keep(memberOrigin(), settledWorld());
    const auto back = files.settled(memberOrigin(), findings);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->world.endTime, 12.5);
    ASSERT_EQ(back->islands.size(), 1u);
    EXPECT_EQ(back->islands[0].elements, settledWorld().islands[0].elements);
    EXPECT_EQ(back->islands[0].state, 17u);
    EXPECT_EQ(back->islands[0].moved.position, settledWorld().islands[0].moved.position);
    EXPECT_EQ(back->islands[0].moved.orientation.coeffs(), settledWorld().islands[0].moved.orientation.coeffs());
    EXPECT_EQ(back->arrivals, settledWorld().arrivals);
    EXPECT_TRUE(findings.empty());
    // Other studies find the world under the same key.
    StudyFiles study(folder.path());
    EXPECT_TRUE(study.world(memberOrigin(), findings));
}

TEST(SettledFiles, AWorldWithoutItsIslandsIsMadeAgain) {
    const TemporaryFolder folder;
    SettledFiles files(folder.path());
    StudyFiles study(folder.path());
    study.keep(memberOrigin(), settledWorld().world);
    Findings findings;
    EXPECT_FALSE(files.settled(memberOrigin(), findings));
    EXPECT_TRUE(findings.empty());
}

TEST(SettledFiles, DamagedIslandsAreToldAndNotTaken) {
    const TemporaryFolder folder;
    SettledFiles files(folder.path());
    files.keep(memberOrigin(), settledWorld());
    for (const char* text :
         {"", "{", "[]", "{\"version\": 3}", "{\"version\":2,\"world\":\"x\",\"trajectory\":\"y\",\"islands\":[]}"}) {
        std::ofstream(files.islandsPath(memberOrigin())) << text;
        Findings findings;
        EXPECT_FALSE(files.settled(memberOrigin(), findings)) << text;
        EXPECT_EQ(findings.list().size(), 1u) << text;
    }
}

TEST(EnsembleJson, ComesBackTheSameAndNamesWhatIsWrong) {
    EnsembleSettings settings{usualVariations(), 40, 7};
    settings.varied.push_back(variationFrom("scenario", "choice:a:b"));
    const nlohmann::json json = ensembleJson(settings);
    EXPECT_EQ(ensembleFromJson(JsonCursor(json, "case")), settings);
    nlohmann::json wrong = json;
    wrong["varied"][0]["distribution"] = "uniform:2:1";
    EXPECT_THROW(ensembleFromJson(JsonCursor(wrong, "case")), ParseError);
    wrong = json;
    wrong["members"] = 0;
    EXPECT_THROW(ensembleFromJson(JsonCursor(wrong, "case")), ParseError);
}

}  // namespace
}  // namespace rubble::io
