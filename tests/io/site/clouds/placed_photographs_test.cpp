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

/// An E57 with one point and two pinhole pictures; the first looks straight down from 10, 20, 50 with y up in it, the second has no
/// pose.
/// @param width    px, as the cloud states it
/// @param which    which one of a small cloud it holds
CloudBytes withPictures(const std::string& width = "100", std::size_t which = 1) {
    const std::string tiny = sourcePath("tests/data/clouds/tiny_pc_and_images.e57");
    const CloudBytes png = photographOfE57(tiny, openCloud(tiny)->head().photographs[which]);
    MadeE57 made;
    const std::uint64_t points = made.addPoints({{8, {1}}, {8, {2}}, {8, {3}}}, 1);
    const std::uint64_t picture = made.addBlob(std::string(png.begin(), png.end()));
    std::string fields;
    for (const char* axis : {"X", "Y", "Z"}) {
        fields += "<cartesian" + std::string(axis) + " type=\"Integer\" minimum=\"0\" maximum=\"255\"/>";
    }
    const std::string pinhole =
        "<pinholeRepresentation type=\"Structure\"><pngImage type=\"Blob\" fileOffset=\"" + std::to_string(picture) +
        "\" length=\"" + std::to_string(png.size()) + "\"/><imageWidth type=\"Integer\">" + width +
        "</imageWidth><imageHeight type=\"Integer\">100</imageHeight>"
        "<focalLength type=\"Float\">0.02</focalLength><pixelWidth type=\"Float\">0.0001</pixelWidth>"
        "<pixelHeight type=\"Float\">0.0001</pixelHeight><principalPointX type=\"Float\">48</principalPointX>"
        "<principalPointY type=\"Float\">53</principalPointY></pinholeRepresentation>";
    const std::string pose =
        "<pose type=\"Structure\"><translation type=\"Structure\"><x type=\"Float\">10</x><y type=\"Float\">20</y>"
        "<z type=\"Float\">50</z></translation></pose>";
    return made.bytes(
        "<?xml version=\"1.0\"?><e57Root type=\"Structure\"><data3D type=\"Vector\"><vectorChild type=\"Structure\">"
        "<points type=\"CompressedVector\" fileOffset=\"" +
        std::to_string(points) + "\" recordCount=\"1\"><prototype type=\"Structure\">" + fields +
        "</prototype></points></vectorChild></data3D><images2D type=\"Vector\"><vectorChild type=\"Structure\">"
        "<name type=\"String\">from above</name>" +
        pose + pinhole + "</vectorChild><vectorChild type=\"Structure\">" + pinhole + "</vectorChild></images2D></e57Root>");
}

TEST(PlacedPhotographs, AreMatchedToTheCameraThatTheCloudStates) {
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "pictures.e57", withPictures());
    Findings findings;
    const std::vector<PlacedPhotograph> placed = placedPhotographs(path, {}, {}, std::nullopt, findings);
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

TEST(PlacedPhotographs, NeverReplacePicturesOfAnotherCloud) {
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "scan.e57", withPictures());
    const std::string other = folder / "scan.e57-photographs/1-from_above.png";
    std::filesystem::create_directories(folder / "scan.e57-photographs");
    std::ofstream(other) << "a picture of another cloud";
    Case theCase;
    Findings findings;
    const AddedPhotographs added = addPhotographsOfCloud(theCase, folder / "case.rubble", path, {}, findings);
    ASSERT_EQ(added.ids.size(), 1U);
    ASSERT_EQ(theCase.inputs.size(), 1U);
    EXPECT_NE(theCase.inputs.front().path, "scan.e57-photographs/1-from_above.png");
    EXPECT_EQ(readPhotograph(inputPath(folder / "case.rubble", theCase.inputs.front())).sha256, theCase.inputs.front().sha256);
    std::string kept;
    std::getline(std::ifstream(other), kept);
    EXPECT_EQ(kept, "a picture of another cloud");
    // Once more adds nothing.
    EXPECT_EQ(addPhotographsOfCloud(theCase, folder / "case.rubble", path, {}, findings).known, 1);
}

TEST(PlacedPhotographs, OneThatCannotBeReadIsLeftOutAndSaid) {
    // The pinhole picture of this file is all zeros.
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "scan.e57", withPictures("100", 2));
    Case theCase;
    Findings findings;
    EXPECT_TRUE(addPhotographsOfCloud(theCase, folder / "case.rubble", path, {}, findings).ids.empty());
    EXPECT_TRUE(theCase.inputs.empty());
    EXPECT_FALSE(std::filesystem::exists(folder / "scan.e57-photographs/1-from_above.png"));
    EXPECT_FALSE(findings.list().empty());
}

TEST(PlacedPhotographs, ACameraOfAnotherSizeIsNotTaken) {
    const TemporaryFolder folder;
    const std::string path = layCloud(folder / "scan.e57", withPictures("120"));
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
    const std::string path = layCloud(folder / "pictures.e57", withPictures());
    Registration moved;
    moved.turn = Vec3(0.0, 0.0, 0.5);
    moved.shift = Vec3(3.0, -4.0, 5.0);
    Findings findings;
    const std::vector<PlacedPhotograph> placed = placedPhotographs(path, {}, {}, moved, findings);
    ASSERT_EQ(placed.size(), 1U);
    const CameraMatch match = matchCamera(placed.front().pairs, placed.front().camera, Execution());
    EXPECT_LT((match.camera.place - moved(Vec3(10.0, 20.0, 50.0))).norm(), 1e-5);
}

}  // namespace

}  // namespace rubble::io
