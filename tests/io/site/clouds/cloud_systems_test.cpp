#include <gtest/gtest.h>

#include <cmath>

#include "io/site/clouds/cloud_place.h"
#include "io/site/height_reading.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/error_id.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

/// A cloud of two points in a system, and a case that it is brought to.
class CloudSystems : public testing::Test {
protected:
    TemporaryFolder m_folder;
    Frame m_frame;
    Vec3 m_first{356500.0, 5699500.0, 100.0};

    std::unique_ptr<PointCloud> open(const std::string& system) {
        const Vec3 second = m_first + Vec3(1e-5, 1e-5, 1.0);
        std::string text;
        for (const Vec3& at : {m_first, second}) {
            text += std::to_string(at.x()) + ' ' + std::to_string(at.y()) + ' ' + std::to_string(at.z()) + '\n';
        }
        return openCloud(layCloud(m_folder / "cloud.xyz", text), {system, {}});
    }
    Findings placed(const std::string& system) {
        Findings findings;
        const std::unique_ptr<PointCloud> cloud = open(system);
        const CloudPlace place(*cloud, m_frame, Site(), findings);
        return findings;
    }
    std::string refusal(const std::string& system) {
        return idOfError([&] { placed(system); });
    }
    /// The case stands on the first point.
    void standAt(const std::string& crs, const Vec3& origin) {
        m_frame.crs = crs;
        m_frame.origin = {std::llround(origin.x()), std::llround(origin.y()), 0};
    }
};

TEST_F(CloudSystems, OneSystemNeedsNoWord) {
    standAt("EPSG:25832", m_first);
    EXPECT_TRUE(placed("EPSG:25832").empty());
    EXPECT_EQ(placed("").count("cloud.unplaced"), 1);
}

TEST_F(CloudSystems, AnotherZoneIsProjectedAndExact) {
    standAt("EPSG:25833", Vec3(-61000.0, 5716000.0, 0.0));
    const Findings found = placed("EPSG:25832");
    EXPECT_EQ(found.count("cloud.projected"), 1);
    EXPECT_EQ(found.count("site.way_accuracy") + found.count("site.grid_missing"), 0) << "one datum";
}

TEST_F(CloudSystems, VerticalDatumsAreNamed) {
    standAt("EPSG:25832", m_first);
    EXPECT_EQ(placed("EPSG:25832+7837").count("cloud.datum_kept"), 1);
    m_frame.crs = "EPSG:25832+5783";
    EXPECT_EQ(placed("EPSG:25832+7837").count("cloud.other_datum"), 1);
    EXPECT_EQ(placed("EPSG:25832+5783").count("cloud.other_datum"), 0);
}

TEST_F(CloudSystems, PlacesThatAreNoPlanAreRefused) {
    m_first = Vec3(14.345, 47.95, 100.0);
    EXPECT_EQ(refusal("EPSG:4326"), "cloud.degrees_alone");
    m_first = Vec3(4'100'000.0, 500'000.0, 4'840'000.0);
    EXPECT_EQ(refusal("EPSG:4978"), "cloud.no_plan");
    EXPECT_EQ(idOfError([&] { open("no system"); }), "cloud.no_system");
    EXPECT_EQ(readCloud(m_folder / "cloud.xyz", {"EPSG:4978", {}}).summary.findings.count("cloud.geocentric"), 1);
}

TEST_F(CloudSystems, PlacesOfAnotherDatumAreAsGoodAsProjSays) {
    // To the metre without any grid.
    m_first = Vec3(7.0, 51.0, 100.0);
    standAt("EPSG:25832", Vec3(359700.0, 5652000.0, 0.0));
    EXPECT_EQ(placed("EPSG:4326").count("site.way_accuracy"), 1);
    // Great Britain: some metres without its grid, which is named.
    m_first = Vec3(1.716, 52.658, 10.0);
    standAt("EPSG:27700", Vec3(651400.0, 313170.0, 0.0));
    const Findings britain = placed("EPSG:4326");
    EXPECT_EQ(britain.count("site.grid_missing") + britain.count("site.way_accuracy"), 1);
    // From the datum of Puerto Rico only grids lead to that of North America.
    m_first = Vec3(-66.1, 18.4, 20.0);
    standAt("EPSG:32161", Vec3(235200.0, 262700.0, 0.0));
    const Findings sanJuan = placed("EPSG:4139");
    EXPECT_EQ(sanJuan.count("site.grid_needed") + sanJuan.count("site.way_accuracy"), 1) << "unless a grid of it is here";
    for (const Finding& finding : sanJuan.list()) {
        EXPECT_EQ(englishText(finding.what).find("not a number"), std::string::npos) << englishText(finding.what);
    }
    // An ellipsoid of Bessel's without a datum says nothing of how it lies.
    m_first = Vec3(356500.0, 5699500.0, 100.0);
    standAt("EPSG:25832", m_first);
    EXPECT_EQ(placed("+proj=utm +zone=32 +ellps=bessel +units=m +no_defs").count("site.way_unknown"), 1);
}

TEST_F(CloudSystems, PointsForWhichThereIsNoRoomAreCounted) {
    MadeLas las;
    for (int k = 0; k < 20'000; ++k) {
        las.points.push_back({{(k * 7919) % 4000 - 2000, (k * 104729) % 4001 - 2000, 100}});
    }
    for (int k = 0; k < 5; ++k) {
        las.points.push_back({{100'000'000 + k, 0, 100}});
    }
    const std::string path = layCloud(m_folder / "wide.las", las.bytes());
    const Aabb structure(Vec3(-2.0, -2.0, 0.0), Vec3(2.0, 2.0, 1.0));
    const HeightReading about = readHeights(path, Frame(), Site(), structure, Execution(), {.surface = true});
    EXPECT_EQ(about.findings.count("cloud.beside"), 5);
}

}  // namespace

}  // namespace rubble::io
