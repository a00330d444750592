#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

const Vec3 stand(-20.0, -30.0, 1.8);

/// What a scanner sees of level ground and a wall, in one direction after another.
std::vector<Vec3> seenFromStand() {
    std::vector<Vec3> places;
    const double degree = std::numbers::pi / 180.0;
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 0.7) {
        for (double elevation = -70.0; elevation < 20.0; elevation += 0.7) {
            const Vec3 along(std::cos(elevation * degree) * std::cos(azimuth * degree),
                             std::cos(elevation * degree) * std::sin(azimuth * degree), std::sin(elevation * degree));
            const double ground = along.z() < 0.0 ? -stand.z() / along.z() : 1e9;
            const double wall = along.x() > 0.0 ? (5.0 - stand.x()) / along.x() : 1e9;
            const Vec3 hit = stand + std::min(ground, wall) * along;
            if ((hit - stand).norm() < 80.0 && hit.z() < 10.0) {
                places.push_back(hit);
            }
        }
    }
    return places;
}

std::string numbersOf(const Vec3& place) {
    std::ostringstream text;
    text.precision(12);
    text << place.x() << ' ' << place.y() << ' ' << place.z();
    return text.str();
}

/// A scan of PTX. @param told  scanner in the head; @param shift  of the matrix
std::string ptxOf(const std::vector<Vec3>& places, const Vec3& told, const Vec3& shift) {
    std::string text = std::to_string(places.size()) + "\n1\n" + numbersOf(told) + "\n1 0 0\n0 1 0\n0 0 1\n" +
                       "1 0 0 0\n0 1 0 0\n0 0 1 0\n" + numbersOf(shift) + " 1\n";
    for (const Vec3& place : places) {
        text += numbersOf(place) + " 0.5\n";
    }
    return text;
}

std::vector<Vec3> shifted(std::vector<Vec3> places, const Vec3& by) {
    for (Vec3& place : places) {
        place += by;
    }
    return places;
}

class ScannerPlaces : public testing::Test {
protected:
    TemporaryFolder m_folder;

    /// Whether each scan is known to have been taken from where it says; it must be told where not.
    template <class Content>
    std::vector<bool> posed(const Content& content) {
        const WholeCloud cloud = readCloud(layCloud(m_folder / "cloud", content));
        const auto unknown = std::count(cloud.summary.posed.begin(), cloud.summary.posed.end(), false);
        EXPECT_EQ(cloud.summary.findings.count("cloud.pose_unknown"), unknown);
        m_scans = cloud.head.scans;
        return cloud.summary.posed;
    }
    std::vector<CloudScan> m_scans;
};

using Known = std::vector<bool>;

TEST_F(ScannerPlaces, AMatrixThatDoesNothingIsNoPlaceAmidRegisteredPoints) {
    const std::vector<Vec3> places = seenFromStand();
    const std::vector<Vec3> own = shifted(places, -stand);
    EXPECT_EQ(posed(ptxOf(own, stand, stand)), Known{true}) << "the matrix brings the points to their places";
    EXPECT_EQ(posed(ptxOf(own, Vec3::Zero(), Vec3::Zero())), Known{true}) << "the points count from the scanner";
    EXPECT_EQ(posed(ptxOf(places, Vec3::Zero(), Vec3::Zero())), Known{false}) << "the origin lies amid them";
    EXPECT_EQ(posed(ptxOf(places, stand, Vec3::Zero())), Known{true});
    EXPECT_EQ(m_scans.front().pose.position, stand) << "the first lines of the head tell another place";
    // Of several scans each is judged by itself.
    EXPECT_EQ(posed(ptxOf(own, stand, stand) + ptxOf(places, Vec3::Zero(), Vec3::Zero())), (Known{true, false}));
}

TEST_F(ScannerPlaces, AMatrixThatDoesNothingIsNoPlaceFarFromMapCoordinates) {
    const Vec3 map(636'000.0, 849'000.0, 400.0);
    const std::vector<Vec3> places = shifted(seenFromStand(), map);
    EXPECT_EQ(posed(ptxOf(places, Vec3::Zero(), Vec3::Zero())), Known{false});
    EXPECT_EQ(posed(ptxOf(places, map + stand, Vec3::Zero())), Known{true});
    EXPECT_EQ(posed(ptxOf(shifted(places, -map - stand), map + stand, map + stand)), Known{true});
    // Too few to tell directions apart, but far from their origin.
    EXPECT_EQ(posed(ptxOf({map, map + Vec3::UnitX(), map + Vec3::UnitY()}, Vec3::Zero(), Vec3::Zero())), Known{false});
}

CloudBytes e57Of(const std::vector<Vec3>& places, const Vec3& shift) {
    std::vector<MadeE57::Column> columns(3);
    for (const Vec3& place : places) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            columns[static_cast<std::size_t>(axis)].raw.push_back(std::bit_cast<std::uint64_t>(place[axis]));
        }
    }
    MadeE57 made;
    const std::uint64_t at = made.addPoints(columns, 1000);
    const auto real = [](const char* name, double number) {
        return "<" + std::string(name) + " type=\"Float\">" + std::to_string(number) + "</" + name + ">";
    };
    return made.bytes(
        "<?xml version=\"1.0\"?><e57Root type=\"Structure\"><data3D type=\"Vector\"><vectorChild type=\"Structure\">"
        "<pose type=\"Structure\"><rotation type=\"Structure\">" +
        real("w", 1.0) + "</rotation><translation type=\"Structure\">" + real("x", shift.x()) + real("y", shift.y()) +
        real("z", shift.z()) + "</translation></pose><points type=\"CompressedVector\" fileOffset=\"" + std::to_string(at) +
        "\" recordCount=\"" + std::to_string(places.size()) +
        "\"><prototype type=\"Structure\"><cartesianX type=\"Float\"/><cartesianY type=\"Float\"/>"
        "<cartesianZ type=\"Float\"/></prototype></points></vectorChild></data3D></e57Root>");
}

TEST_F(ScannerPlaces, APoseOfAnE57ThatDoesNothingIsJudgedLikewise) {
    const std::vector<Vec3> places = seenFromStand();
    EXPECT_EQ(posed(e57Of(shifted(places, -stand), stand)), Known{true});
    EXPECT_EQ(posed(e57Of(shifted(places, -stand), Vec3::Zero())), Known{true});
    EXPECT_EQ(posed(e57Of(places, Vec3::Zero())), Known{false});
    EXPECT_EQ(posed(e57Of(shifted(places, Vec3(636'000.0, 849'000.0, 0.0)), Vec3::Zero())), Known{false});
}

}  // namespace

}  // namespace rubble::io
