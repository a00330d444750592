#include "io/site/clouds/e57/placed_photographs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/evidence/cautions.h"
#include "core/evidence/photographs/camera_match.h"
#include "io/case/case_file.h"
#include "io/case/case_photographs.h"
#include "io/site/clouds/e57/e57_source.h"
#include "io/site/photograph_file.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

TEST(PlacedPhotographs, AreMatchedToTheCameraThatTheCloudStates) {
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "pictures.e57", cloudWithPictures());
    Findings findings;
    const std::vector<PlacedPhotograph> placed = placedPhotographs(path, {}, {}, {}, std::nullopt, findings);
    ASSERT_EQ(placed.size(), 1U);
    EXPECT_EQ(findings.count("cloud.photographs_without_place"), 1);
    EXPECT_EQ(placed.front().name, "1-from_above.png");
    EXPECT_EQ(placed.front().bytes.size(), 1073U);
    const CameraMatch match = matchCamera(placed.front().pairs, placed.front().camera, Execution());
    EXPECT_LT((match.camera.place - Vec3(10.0, 20.0, 50.0)).norm(), 1e-5);
    EXPECT_NEAR(match.camera.focal, 200.0, 1e-9);
    // A place 1 m to the right, 2 m up in the picture and 40 m below the camera.
    const auto seen = match.camera.project(Vec3(11.0, 22.0, 10.0));
    ASSERT_TRUE(seen.has_value());
    EXPECT_NEAR(seen->x(), 48.0 + 200.0 * 1.0 / 40.0, 1e-4);
    EXPECT_NEAR(seen->y(), 53.0 - 200.0 * 2.0 / 40.0, 1e-4);

    Photograph photograph;
    photograph.pairs = placed.front().pairs;
    EXPECT_TRUE(cameraStated(photograph));
    const std::vector<Caution> cautions = photographCautions(photograph, &match, nullptr);
    ASSERT_EQ(cautions.size(), 1U);
    EXPECT_EQ(cautions.front().key, "stated_camera");
    // One pair of somebody beside those of the cloud tells no more of how well the camera is known.
    photograph.camera = placed.front().camera;
    photograph.pairs.front().name = "crown of the arch";
    EXPECT_TRUE(cameraStated(photograph));
    const CameraMatch stated = matchPhotograph(photograph, Execution());
    EXPECT_TRUE(std::isnan(stated.placeRadius));
    EXPECT_TRUE(std::isnan(stated.turnRadius));
    for (PointPair& pair : photograph.pairs) {
        pair.name = "clicked";
    }
    EXPECT_FALSE(cameraStated(photograph));
    EXPECT_TRUE(std::isfinite(matchPhotograph(photograph, Execution()).placeRadius));
}

TEST(PlacedPhotographs, WithPixelsThatAreNotSquareHaveNoKnownCamera) {
    const TemporaryFolder folder;
    const auto placed = [&](const std::string& height) {
        const std::string path = layCloud(folder / "pictures.e57", cloudWithPictures("100", 1, height));
        Findings findings;
        return placedPhotographs(path, {}, {}, {}, std::nullopt, findings).size();
    };
    EXPECT_EQ(placed("0.00010005"), 1U) << "rounded";
    EXPECT_EQ(placed("0.000075"), 0U);
    EXPECT_EQ(placed("0"), 1U) << "not stated: square";
}

TEST(PlacedPhotographs, NeverReplacePicturesOfAnotherCloud) {
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "scan.e57", cloudWithPictures());
    const std::string other = folder / "scan.e57-photographs/1-from_above.png";
    std::filesystem::create_directories(folder / "scan.e57-photographs");
    std::ofstream(other) << "a picture of another cloud";
    Case theCase;
    Findings findings;
    const AddedPhotographs added = addPhotographsOfCloud(theCase, folder / "case.rubble", path, {}, findings);
    ASSERT_EQ(added.ids.size(), 1U);
    added.written->kept = true;
    ASSERT_EQ(theCase.inputs.size(), 1U);
    EXPECT_NE(theCase.inputs.front().path, "scan.e57-photographs/1-from_above.png");
    EXPECT_EQ(readPhotograph(inputPath(folder / "case.rubble", theCase.inputs.front())).sha256, theCase.inputs.front().sha256);
    std::string kept;
    std::getline(std::ifstream(other), kept);
    EXPECT_EQ(kept, "a picture of another cloud");
    // Once more adds nothing.
    EXPECT_EQ(addPhotographsOfCloud(theCase, folder / "case.rubble", path, {}, findings).known, 1);
}

TEST(PlacedPhotographs, ThatTheCaseHasUnderAnotherInputLeaveNoFile) {
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "scan.e57", cloudWithPictures());
    Findings findings;
    const PlacedPhotograph picture = placedPhotographs(path, {}, {}, {}, std::nullopt, findings).front();
    const std::string known = folder / "known.png";
    std::ofstream(known, std::ios::binary).write(reinterpret_cast<const char*>(picture.bytes.data()), 1073);
    const PhotographFile file = readPhotograph(known);
    Case theCase;
    ASSERT_TRUE(addPhotograph(theCase, folder / "case.rubble", known, file.facts, file.sha256));
    const AddedPhotographs added = addPhotographsOfCloud(theCase, folder / "case.rubble", path, {}, findings);
    added.written->kept = true;
    EXPECT_EQ(added.known, 1U);
    EXPECT_TRUE(added.ids.empty());
    EXPECT_FALSE(std::filesystem::exists(folder / "scan.e57-photographs"));
}

TEST(PlacedPhotographs, GivenUpLeaveCaseAndFolderAsTheyWere) {
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "scan.e57", cloudWithPictures());
    Case theCase;
    Findings findings;
    Execution* asked = nullptr;
    Execution execution([&](const Progress& progress) {
        if (progress.stage.id == "cloud.photographs_adding" && progress.fraction == 1.0) {
            asked->cancel();
        }
    });
    asked = &execution;
    const Case before = theCase;
    for (int round = 0; round < 2; ++round) {
        EXPECT_THROW(addPhotographsOfCloud(theCase, folder / "case.rubble", path, {}, findings, execution), Cancelled);
        EXPECT_EQ(theCase, before);
        EXPECT_FALSE(std::filesystem::exists(folder / "scan.e57-photographs"));
        execution.cancel();  // the second time from the start
    }
}

TEST(PlacedPhotographs, OfACaseThatIsNotTakenAreTakenAway) {
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "scan.e57", cloudWithPictures());
    Findings findings;
    for (const bool kept : {false, true}) {
        Case theCase;
        EXPECT_EQ(addPhotographsOfCloud(theCase, folder / "case.rubble", path, {}, findings).written->kept = kept, kept);
        EXPECT_EQ(std::filesystem::exists(folder / "scan.e57-photographs/1-from_above.png"), kept);
    }
}

TEST(PlacedPhotographs, OneThatCannotBeReadIsLeftOutAndSaid) {
    // The pinhole picture of this file is all zeros.
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "scan.e57", cloudWithPictures("100", 2));
    Case theCase;
    Findings findings;
    EXPECT_TRUE(addPhotographsOfCloud(theCase, folder / "case.rubble", path, {}, findings).ids.empty());
    EXPECT_TRUE(theCase.inputs.empty());
    EXPECT_FALSE(std::filesystem::exists(folder / "scan.e57-photographs/1-from_above.png"));
    EXPECT_FALSE(findings.list().empty());
}

TEST(PlacedPhotographs, ACameraOfAnotherSizeIsNotTaken) {
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "scan.e57", cloudWithPictures("120"));
    Case theCase;
    Findings findings;
    addPhotographsOfCloud(theCase, folder / "case.rubble", path, {}, findings);
    ASSERT_EQ(theCase.photographs.size(), 1U);
    EXPECT_TRUE(theCase.photographs.front().pairs.empty());
    EXPECT_EQ(theCase.photographs.front().camera.width, 100);
    EXPECT_EQ(findings.count("cloud.photograph_size"), 1);
}

TEST(PlacedPhotographs, MoveWithTheirCloud) {
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "pictures.e57", cloudWithPictures());
    Registration moved;
    moved.turn = Vec3(0.0, 0.0, 0.5);
    moved.shift = Vec3(3.0, -4.0, 5.0);
    Findings findings;
    const std::vector<PlacedPhotograph> placed = placedPhotographs(path, {}, {}, {}, moved, findings);
    ASSERT_EQ(placed.size(), 1U);
    const CameraMatch match = matchCamera(placed.front().pairs, placed.front().camera, Execution());
    EXPECT_LT((match.camera.place - moved(Vec3(10.0, 20.0, 50.0))).norm(), 1e-5);
}

}  // namespace

}  // namespace rubble::io
