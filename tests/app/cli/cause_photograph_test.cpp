#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/evidence/photographs/silhouette.h"
#include "core/pipeline/pipeline.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/fe/fe_reader.h"
#include "tests/core/evidence/camera_scene.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"

namespace rubble::cli {

namespace {

/// Two causes of one collapse, the second six metres to the east, and a photograph in the case of the first that a known camera
/// took of the debris of one of them: its outline is that of a simulation with a friction that no member has.
class CausePhotograph : public testing::Test {
protected:
    void SetUp() override {
        writeSmallCollapse(m_folder / "west.exo");
        io::ExodusBuilder builder = smallCollapse();
        for (Vec3& node : builder.nodes) {
            node.x() += 6.0;
        }
        builder.write(m_folder / "east.exo");
        writeAtomically("site.png", "no picture: its outline is in the case");
        m_scene.camera.focal = 1100.0;
        m_scene.camera.principal = {600.0, 400.0};
        m_scene.camera.place = {5.0, -22.0, 7.0};
        m_scene.look({5.0, 0.5, 1.0}, 0.01);
    }
    void writeAtomically(const std::string& name, const std::string& text) {
        io::writeAtomically(m_folder / name, [&](std::ostream& out) { out << text; });
    }
    static double areaOf(const std::vector<Eigen::Vector2d>& ring) {
        double area = 0.0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Eigen::Vector2d& a = ring[i];
            const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
            area += 0.5 * (a.x() * b.y() - b.x() * a.y());
        }
        return area;
    }
    /// Outlines of the debris at rest as the camera sees it.
    std::vector<PhotoMask> seenBy(const std::string& name) {
        const Inputs inputs{io::openFe(m_folder / name, {}, Frame(), Execution()), Frame()};
        Scenario scenario;
        scenario.simulation.friction = 0.43;
        scenario.simulation.settleTime = 1.0;
        MemoryTrajectory trajectory;
        const Results results = run(inputs, scenario, Stage::Simulation, {}, &trajectory, Execution());
        const MappedRun mapped{inputs.fe.get(), &trajectory, results.fragments, results.simulation, nullptr, scenario};
        const SiteShape site = siteOfRun(mapped, std::nullopt, 1.0, m_scene.camera.place, Execution());
        const SitePicture picture = pictureOf(site, m_scene.camera, 1200, 800, 1200);
        std::vector<PhotoMask> masks;
        for (const auto& ring : outlinesOf(picture, debrisIn(picture, true))) {
            // The first ring is an outer one; those that turn the other way are holes.
            const bool hole = !masks.empty() && areaOf(ring) * areaOf(masks.front().corners) < 0.0;
            masks.push_back({hole ? MaskClass::NotDebris : MaskClass::Debris, ring});
        }
        return masks;
    }
    /// The case of the first cause with the photograph of the debris of either. @param error  px, of each click
    std::string caseWith(const std::string& seen, double error = 0.5) {
        Case theCase = io::caseForFe(m_folder / "west.exo", m_folder / "west.rubble");
        theCase.inputs.push_back({"photograph-1", InputRole::Photograph, "site.png", io::sha256OfFile(m_folder / "site.png")});
        Photograph photograph;
        photograph.input = "photograph-1";
        photograph.facts.width = photograph.camera.width = 1200;
        photograph.facts.height = photograph.camera.height = 800;
        photograph.camera.focal = m_scene.camera.focal;
        for (int k = 0; k < 12; ++k) {
            const Vec3 point(5.0 * (k % 3), 2.0 * ((k / 3) % 2), 3.0 * (k / 6));
            photograph.pairs.push_back({"corner", *m_scene.camera.project(point) + m_scene.noise(error), point});
        }
        photograph.masks = seenBy(seen);
        EXPECT_FALSE(photograph.masks.empty());
        theCase.photographs = {photograph};
        return save(theCase);
    }
    std::string save(const Case& theCase) {
        const std::string path = m_folder / "west.rubble";
        io::saveCase(path, theCase);
        return path;
    }
    Outcome compare(const std::string& casePath, std::vector<std::string> more = {}) {
        std::vector<std::string> words{"compare",
                                       casePath,
                                       m_folder / "east.exo",
                                       "--members",
                                       "10",
                                       "--vary",
                                       "friction=uniform:0.3:0.5",
                                       "--set",
                                       "settle_time=1",
                                       "--cache",
                                       m_folder / "cache",
                                       "--json",
                                       "--against",
                                       "photographs"};
        words.insert(words.end(), more.begin(), more.end());
        return cli(words);
    }

    io::TemporaryFolder m_folder;
    CameraScene m_scene{5, 4, 0.0};
};

TEST_F(CausePhotograph, TheHiddenCauseIsFoundWhicheverItIs) {
    for (const std::string truth : {"east", "west"}) {
        const Outcome outcome = compare(caseWith(truth + ".exo"));
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const nlohmann::json object = outcome.json();
        EXPECT_EQ(object["closest"], truth);
        EXPECT_TRUE(object["told_apart"]) << object["words"];
        ASSERT_EQ(object["evidence"].size(), 1u);
        EXPECT_EQ(object["evidence"][0]["kind"], "photograph");
        EXPECT_EQ(object["telling_evidence"], "site.png");
        // Its own members depart by how their friction differs, those of the other cause lie elsewhere.
        EXPECT_LT(object["ranking"][0]["departures"][0]["mean"].get<double>(), 0.4);
        EXPECT_GT(object["ranking"][1]["departures"][0]["mean"].get<double>(), 0.6);
        EXPECT_TRUE(object["telling_place"].is_null()) << "no evidence lies on the ground";
    }
}

TEST_F(CausePhotograph, ACameraThatIsNotSureTellsLess) {
    const nlohmann::json sharp = compare(caseWith("east.exo", 0.3)).json();
    const nlohmann::json blurred = compare(caseWith("east.exo", 12.0)).json();
    EXPECT_EQ(sharp["closest"], "east");
    EXPECT_GT(blurred["ranking"][0]["departures"][0]["mean"].get<double>(),
              sharp["ranking"][0]["departures"][0]["mean"].get<double>());
}

TEST_F(CausePhotograph, OneThatSaysNothingIsLeftOutInWords) {
    Case theCase = io::loadCase(caseWith("east.exo"));
    theCase.photographs[0].time = 0.3;
    const Outcome outcome = compare(save(theCase));
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.err, testing::HasSubstr("no photograph at rest"));
    theCase.photographs[0].time.reset();
    theCase.photographs[0].masks.clear();
    EXPECT_EQ(compare(save(theCase)).exitCode, 2);
    EXPECT_EQ(compare(caseWith("east.exo"), {"--instant", "fe_end"}).exitCode, 2);
}

}  // namespace

}  // namespace rubble::cli
