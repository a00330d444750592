#include "io/settled_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "io/ensemble_json.h"
#include "tests/io/temporary_folder.h"

namespace rubble::io {
namespace {

WorldOrigin someOrigin() {
    WorldOrigin origin;
    origin.key = Hasher().text("member").finish();
    origin.build = "some build";
    origin.feSha256 = std::string(64, 'a');
    origin.machine = "some machine";
    return origin;
}

SettledWorld someWorld() {
    SettledWorld settled;
    settled.world.trajectoryHash = Hasher().text("trajectory").finish();
    settled.world.endTime = 12.5;
    CarriedIsland& island = settled.islands.emplace_back();
    island.elements = {idAt<ElementIndex>(3), idAt<ElementIndex>(70000)};
    island.moved = {Vec3(1.0 / 3.0, -2.0, 1e-300), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()))};
    return settled;
}

TEST(SettledFiles, WhatIsKeptComesBackToTheBit) {
    const TemporaryFolder folder;
    SettledFiles files(folder.path());
    Findings findings;
    EXPECT_FALSE(files.settled(someOrigin(), findings));
    files.keep(someOrigin(), someWorld());
    const auto back = files.settled(someOrigin(), findings);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->world.endTime, 12.5);
    ASSERT_EQ(back->islands.size(), 1u);
    EXPECT_EQ(back->islands[0].elements, someWorld().islands[0].elements);
    EXPECT_EQ(back->islands[0].moved.position, someWorld().islands[0].moved.position);
    EXPECT_EQ(back->islands[0].moved.orientation.coeffs(), someWorld().islands[0].moved.orientation.coeffs());
    EXPECT_TRUE(findings.empty());
    // Other studies find the world under the same key.
    StudyFiles study(folder.path());
    EXPECT_TRUE(study.world(someOrigin(), findings));
}

TEST(SettledFiles, AWorldWithoutItsIslandsIsMadeAgain) {
    const TemporaryFolder folder;
    SettledFiles files(folder.path());
    StudyFiles study(folder.path());
    study.keep(someOrigin(), someWorld().world);
    Findings findings;
    EXPECT_FALSE(files.settled(someOrigin(), findings));
    EXPECT_TRUE(findings.empty());
}

TEST(SettledFiles, DamagedIslandsAreToldAndNotTaken) {
    const TemporaryFolder folder;
    SettledFiles files(folder.path());
    files.keep(someOrigin(), someWorld());
    for (const char* text :
         {"", "{", "[]", "{\"version\": 2}", "{\"version\":1,\"world\":\"x\",\"trajectory\":\"y\",\"islands\":[]}"}) {
        std::ofstream(files.islandsPath(someOrigin())) << text;
        Findings findings;
        EXPECT_FALSE(files.settled(someOrigin(), findings)) << text;
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
