#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "io/case_file.h"
#include "io/files.h"
#include "tests/app/cli/command_run.h"
#include "tests/app/cli/small_collapse.h"
#include "tests/core/evidence/camera_scene.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

/// An uncompressed grey TIFF.
void writeTiff(const std::string& path, std::uint16_t width, std::uint16_t height) {
    std::vector<std::uint8_t> bytes{'I', 'I', 42, 0, 8, 0, 0, 0, 8, 0};
    const auto put = [&](std::uint32_t value, int count) {
        for (int k = 0; k < count; ++k) {
            bytes.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
        }
    };
    const std::uint32_t pixels = std::uint32_t{width} * height;
    const std::uint32_t begin = 8 + 2 + 8 * 12 + 4;
    const std::array<std::array<std::uint32_t, 2>, 8> tags{
        {{256, width}, {257, height}, {258, 8}, {259, 1}, {262, 1}, {273, begin}, {278, height}, {279, pixels}}};
    for (const auto& [tag, value] : tags) {
        put(tag, 2);
        put(4, 2);
        put(1, 4);
        put(value, 4);
    }
    put(0, 4);
    bytes.resize(begin + pixels, 128);
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// A case of the small collapse with one photograph of it, taken by a camera that is known.
class PhotoOfCase : public SmallRun {
protected:
    void SetUp() override {
        run({}, "2");
        writeTiff(m_folder / "site.tif", 800, 600);
        m_case = io::caseForFe(m_path, m_folder / "small.rubble");
        m_case.inputs.push_back({"photograph-1", InputRole::Photograph, "site.tif", io::sha256OfFile(m_folder / "site.tif")});
        CameraScene scene(3, 4, 0.0);
        scene.camera.focal = 900.0;
        scene.camera.principal = {400.0, 300.0};
        scene.camera.place = {-4.0, -12.0, 4.0};
        scene.look({3.0, 0.5, 1.0}, 0.01);
        Photograph photograph;
        photograph.input = "photograph-1";
        photograph.facts.width = photograph.camera.width = 800;
        photograph.facts.height = photograph.camera.height = 600;
        photograph.camera.focal = 900.0;
        const std::array clicks{0.4, -0.7, 0.3, 0.8, -0.5, -0.2, 0.6, -0.6};
        for (int k = 0; k < 8; ++k) {
            const Vec3 point(6.0 * (k & 1), 2.0 * ((k >> 1) & 1), 3.0 * (k >> 2));
            const std::size_t i = static_cast<std::size_t>(k);
            photograph.pairs.push_back({"corner", *scene.camera.project(point) + Eigen::Vector2d(clicks[i], clicks[7 - i]), point});
        }
        photograph.masks = {{MaskClass::Debris, {{250.0, 250.0}, {650.0, 250.0}, {650.0, 450.0}, {250.0, 450.0}}}};
        m_case.photographs = {photograph};
    }
    std::string save() {
        const std::string path = m_folder / "small.rubble";
        io::saveCase(path, m_case);
        return path;
    }
    Case m_case;
};

TEST_F(PhotoOfCase, TellsCameraAndAgreementWithTheirUncertainty) {
    const Outcome outcome = cli({"photo", save(), "--run", m_out, "--json", "--csv", m_folder / "scores.csv"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err << outcome.out;
    const nlohmann::json photo = outcome.json()["photographs"][0];
    EXPECT_EQ(photo["photograph"], "photograph-1");
    EXPECT_TRUE(photo["unchanged"].get<bool>());
    EXPECT_EQ(photo["facts"]["width_px"], 800);
    EXPECT_TRUE(photo["time_s"].is_null());
    EXPECT_LT(photo["match"]["rms_px"].get<double>(), 2.0);
    const nlohmann::json made = photo["comparison"];
    EXPECT_GT(made["iou"]["best"].get<double>(), 0.0);
    EXPECT_LT(made["iou"]["best"].get<double>(), 1.0);
    EXPECT_GT(made["iou"]["spread"].get<double>(), 0.0);
    EXPECT_GT(made["edge_distance_m"]["best"].get<double>(), 0.0);
    EXPECT_NEAR(made["pixel_m"].get<double>(), made["distance_m"].get<double>() / 900.0, 1e-9);
    EXPECT_EQ(made["cameras"], 64);
    EXPECT_THAT(textOf(m_folder / "scores.csv"), HasSubstr("photograph-1,"));
    // Once more the same, and as text.
    const Outcome again = cli({"photo", save(), "--run", m_out, "--photograph", "site.tif"});
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("The silhouettes overlap by"));
    EXPECT_EQ(cli({"photo", save(), "--run", m_out, "--json"}).json()["photographs"][0]["comparison"], made);
}

TEST_F(PhotoOfCase, SaysWhatKeepsItFromComparing) {
    m_case.photographs[0].pairs.resize(3);
    const Outcome few = cli({"photo", save(), "--json"});
    EXPECT_EQ(few.exitCode, 1);
    EXPECT_TRUE(few.json()["photographs"][0]["match"].is_null());
    EXPECT_EQ(few.json()["warnings"][0]["id"], "camera.too_few");
    EXPECT_EQ(cli({"photo", save(), "--photograph", "other"}).exitCode, 2);
    EXPECT_EQ(cli({"photo", save(), "--cameras", "1"}).exitCode, 2);
    m_case.photographs.clear();
    EXPECT_THAT(cli({"photo", save()}).err, HasSubstr("has no photographs"));
}

TEST_F(PhotoOfCase, AChangedFileIsPointedOut) {
    const std::string path = save();
    writeTiff(m_folder / "site.tif", 801, 600);
    const Outcome outcome = cli({"photo", path});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.out, HasSubstr("is another file than the case names"));
    EXPECT_EQ(cli({"verify", path}).exitCode, 1);
}

TEST_F(PhotoOfCase, ATimeBeyondTheRunIsRefusedWithItsSpan) {
    m_case.photographs[0].time = 1e5;
    const Outcome late = cli({"photo", save(), "--run", m_out});
    EXPECT_EQ(late.exitCode, 1);
    EXPECT_THAT(late.out, HasSubstr("but the run goes from"));
    m_case.photographs[0].time = 0.4;
    m_case.photographs[0].timeUncertainty = 0.2;
    const nlohmann::json made = cli({"photo", save(), "--run", m_out, "--json"}).json()["photographs"][0]["comparison"];
    EXPECT_LE(made["iou_over_time"][0].get<double>(), made["iou"]["best"].get<double>());
    EXPECT_GE(made["iou_over_time"][1].get<double>(), made["iou"]["best"].get<double>());
}

}  // namespace

}  // namespace rubble::cli
