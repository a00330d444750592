#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iomanip>

#include "tests/core/evidence/camera_scene.h"
#include "tests/support/command_run.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

class Camera : public testing::Test {
protected:
    std::string write(const CameraScene& scene) {
        const std::string path = m_folder / "pairs.csv";
        std::ofstream out(path);
        out << "name,picture_x_px,picture_y_px,x_m,y_m,z_m\n" << std::setprecision(17);
        for (const PointPair& pair : scene.pairs) {
            out << '"' << pair.name << "\"," << pair.picture.x() << ',' << pair.picture.y() << ',' << pair.model.x() << ','
                << pair.model.y() << ',' << pair.model.z() << '\n';
        }
        return path;
    }
    io::TemporaryFolder m_folder;
};

TEST_F(Camera, IsFoundWithItsUncertaintyAndTheWrongPair) {
    CameraScene scene(11, 14, 1.0);
    scene.pairs[5].picture.x() += 300.0;
    const std::string path = write(scene);
    const Outcome outcome = cli({"camera", path, "--size", "4000x3000", "--focal", std::to_string(scene.camera.focal), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json object = outcome.json();
    const double radius = object["place_radius_95_m"];
    EXPECT_GT(radius, 0.0);
    EXPECT_LT(radius, 1.0) << "a pixel at 60 m and 4,000 px of focal length is 15 mm";
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(object["place_m"][static_cast<std::size_t>(axis)].get<double>(), scene.camera.place[axis], 2.0 * radius);
    }
    EXPECT_EQ(object["verdict"], "good");
    EXPECT_EQ(object["found"].size(), 8u) << "the lens is found as far as the points tell it";
    EXPECT_EQ(object["covariance"].size(), 8u);
    ASSERT_EQ(object["warnings"].size(), 1u) << object["warnings"].dump();
    EXPECT_EQ(object["warnings"][0]["id"], "camera.lens_untold") << "the pairs lie in the middle of the picture";
    EXPECT_FALSE(object["pairs"][5]["used"].get<bool>());
    EXPECT_EQ(object["pairs"].size(), 14u);
    const std::string csv = m_folder / "residuals.csv";
    const Outcome text = cli({"camera", path, "--size", "4000x3000", "--csv", csv});
    ASSERT_EQ(text.exitCode, 0) << text.err;
    EXPECT_THAT(text.out, HasSubstr("The pair P6 looks wrong"));
    EXPECT_THAT(text.out, HasSubstr("focal_px"));
    EXPECT_THAT(textOf(csv), testing::StartsWith("name,residual_x_px,residual_y_px,length_px,used\nP1,"));
}

// 20 clicks of 1 px with the lens of a phone: the region holds the place by itself, and what is said to be no lens is doubted.
TEST_F(Camera, TheLensOfAPhoneStaysWithinTheRegion) {
    CameraScene scene(12, 20, 0.0);
    scene.camera.radial = {0.0885, -0.2324};
    scene.retake(1.0);
    const std::string path = write(scene);
    const std::string focal = std::to_string(scene.camera.focal);
    for (const std::vector<std::string>& more : {std::vector<std::string>{"--focal", focal}, {}}) {
        std::vector<std::string> words{"camera", path, "--size", "4000x3000", "--json"};
        words.insert(words.end(), more.begin(), more.end());
        const nlohmann::json object = cli(words).json();
        const auto place = object["place_m"].get<std::vector<double>>();
        EXPECT_LT((Vec3(place[0], place[1], place[2]) - scene.camera.place).norm(), object["place_radius_95_m"].get<double>());
    }
    const nlohmann::json none = cli({"camera", path, "--size", "4000x3000", "--focal", focal, "--radial", "0", "--json"}).json();
    EXPECT_EQ(none["warnings"][0]["id"], "camera.lens_doubted");
    EXPECT_NE(none["verdict"], "good");
}

TEST_F(Camera, DegenerateSetsAndWrongWordsAreRefusedWithAReason) {
    const std::string path = write(CameraScene(2, 3, 0.0));
    const Outcome few = cli({"camera", path, "--size", "4000x3000"});
    EXPECT_EQ(few.exitCode, 2);
    EXPECT_THAT(few.err, HasSubstr("too few"));
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{},
                                                                                       {"--size", "4000"},
                                                                                       {"--size", "4000x3000", "--focal", "long"},
                                                                                       {"--size", "4000x3000", "--principal", "1"},
                                                                                       {"--size", "4000x3000", "--radial", "3"}}) {
        std::vector<std::string> all{"camera", path};
        all.insert(all.end(), words.begin(), words.end());
        EXPECT_EQ(cli(all).exitCode, 2);
    }
}

TEST_F(Camera, ATableThatIsNoneIsRefusedWithItsLine) {
    const std::string path = m_folder / "pairs.csv";
    const auto refusal = [&](const std::string& text) {
        std::ofstream(path, std::ios::trunc) << text;
        const Outcome outcome = cli({"camera", path, "--size", "4000x3000"});
        EXPECT_EQ(outcome.exitCode, 1) << text;
        return outcome.err;
    };
    EXPECT_THAT(refusal(""), HasSubstr("picture_x_px"));
    EXPECT_THAT(refusal("picture_x_px,picture_y_px,x_m,y_m\n1,2,3,4\n"), HasSubstr("no column z_m"));
    EXPECT_THAT(refusal("picture_x_px,picture_y_px,x_m,y_m,z_m\n1,2,3,4,5\n1,2,3,4,nan\n"), HasSubstr("line 3"));
    EXPECT_THAT(refusal("picture_x_px,picture_y_px,x_m,y_m,z_m\n1,2,3\n"), HasSubstr("line 2"));
    EXPECT_EQ(cli({"camera", m_folder / "none.csv", "--size", "4000x3000"}).exitCode, 1);
    EXPECT_EQ(cli({"camera", m_folder.path(), "--size", "4000x3000"}).exitCode, 1);
}

}  // namespace

}  // namespace rubble::cli
