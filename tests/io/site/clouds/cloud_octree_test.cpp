#include "io/site/clouds/octree/cloud_octree.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <map>
#include <random>
#include <set>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/site/clouds/octree/cloud_bulk.h"
#include "io/site/clouds/octree/octree_choice.h"
#include "io/site/clouds/octree/octree_file.h"
#include "io/site/clouds/octree/point_sorter.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

/// A hilly surface of 200 m x 100 m with a tower of dense points, in millimetres about a far offset.
MadeLas hills(std::size_t points) {
    MadeLas las;
    las.minor = 2;
    las.format = 2;
    las.scale = Vec3::Constant(0.001);
    las.offset = Vec3(431'000.0, 5'412'000.0, 100.0);
    std::mt19937 random(7);  // NOLINT: the same points each time
    std::uniform_int_distribution<std::int32_t> along(0, 200'000);
    for (std::size_t i = 0; i < points; ++i) {
        const bool tower = i % 4 == 0;
        const std::int32_t x = tower ? 50'000 + along(random) / 200 : along(random);
        const std::int32_t y = tower ? 50'000 + along(random) / 200 : along(random) / 2;
        const std::int32_t z = tower ? along(random) / 10 : (x / 50 + y / 80) % 5'000;
        MadePoint point;
        point.place = {x, y, z};
        point.intensity = static_cast<std::uint16_t>(i);
        point.kind = tower ? 6 : 2;
        point.colour = {static_cast<std::uint16_t>(i), 40'000, 65'535};
        las.points.push_back(point);
    }
    las.points.back() = las.points.front();  // a point twice is two points
    return las;
}

/// Changes foot and first row of an octree as its maker never would, with digests that fit.
void forge(const std::string& path, const std::function<void(OctreeFoot&, OctreeRow&)>& change) {
    std::ifstream in(path, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(in)), {});
    OctreeFoot foot;
    OctreeRow row;
    const std::size_t footAt = bytes.size() - sizeof foot;
    std::memcpy(&foot, &bytes[footAt], sizeof foot);
    const std::size_t rowAt = foot.table;
    std::memcpy(&row, &bytes[rowAt], sizeof row);
    change(foot, row);
    std::memcpy(&bytes[rowAt], &row, sizeof row);
    std::memcpy(&bytes[footAt], &foot, sizeof foot);
    foot.digest = Hasher().bytes(&bytes[foot.table], footAt - foot.table + offsetof(OctreeFoot, digest)).finish().bytes;
    std::memcpy(&bytes[footAt], &foot, sizeof foot);
    std::ofstream(path, std::ios::binary) << bytes;
}

using Place = std::array<std::int64_t, 3>;

/// Millimetres about the first corner, in which the points of hills() are whole.
Place placeOf(const Vec3& place) {
    const Vec3 from = place - Vec3(431'000.0, 5'412'000.0, 100.0);
    return {std::llround(from.x() * 1000.0), std::llround(from.y() * 1000.0), std::llround(from.z() * 1000.0)};
}

std::multiset<Place> placesOf(const CloudOctree& octree) {
    std::multiset<Place> all;
    for (std::size_t n = 0; n < octree.nodes().size(); ++n) {
        for (const Vec3& place : octree.read(n).places) {
            all.insert(placeOf(place));
        }
    }
    return all;
}

}  // namespace

class CloudOctreeTest : public ::testing::Test {
protected:
    std::string lay(std::size_t points) { return layCloud(m_folder / "hills.las", hills(points).bytes()); }
    TemporaryFolder m_folder;
};

TEST_F(CloudOctreeTest, HoldsEachPointOnceExactToAThousandthOfAMillimetre) {
    const std::string path = lay(120'000);
    const OpenedOctree opened = openOctree(path, {}, Execution());
    EXPECT_TRUE(opened.made);
    EXPECT_EQ(opened.octree->path(), path + ".octree");
    EXPECT_EQ(opened.octree->head().points, 120'000U);
    EXPECT_GE(opened.octree->levels(), 3);

    const WholeCloud whole = readCloud(path);
    std::multiset<Place> expected;
    std::map<Place, std::tuple<float, std::uint16_t, std::uint16_t>> facts;
    for (std::size_t i = 0; i < whole.points.size(); ++i) {
        expected.insert(placeOf(whole.points.places[i]));
        facts[placeOf(whole.points.places[i])] = {whole.points.intensity[i], whole.points.classes[i], whole.points.colours[i][0]};
    }
    EXPECT_EQ(placesOf(*opened.octree), expected);
    const CloudBlock root = opened.octree->read(0);
    ASSERT_FALSE(root.places.empty());
    std::size_t same = 0;
    for (std::size_t i = 0; i < root.size(); ++i) {
        const Place place = placeOf(root.places[i]);
        const Vec3 exact =
            Vec3(431'000.0, 5'412'000.0, 100.0) +
            0.001 * Vec3(static_cast<double>(place[0]), static_cast<double>(place[1]), static_cast<double>(place[2]));
        EXPECT_LT((root.places[i] - exact).cwiseAbs().maxCoeff(), 1e-6);
        const auto& [intensity, kind, red] = facts.at(place);
        same +=
            root.intensity[i] == intensity && root.classes[i] == kind && root.colours[i][0] == std::lround(255.0 * red / 65535.0)
                ? 1
                : 0;
    }
    EXPECT_GE(same + 10, root.size());  // points at one place may be told apart by nothing else
}

TEST_F(CloudOctreeTest, ANodeHasOnePointInEachOfItsCellsAndLiesBelowItsParent) {
    const std::shared_ptr<const CloudOctree> octree = openOctree(lay(120'000), {}, Execution()).octree;
    const std::vector<OctreeNode>& nodes = octree->nodes();
    std::set<std::size_t> parents;
    for (const OctreeNode& node : nodes) {
        if (node.parent) {
            parents.insert(*node.parent);
            EXPECT_LT(nodes[*node.parent].level, node.level);
            EXPECT_LT(nodes[*node.parent].box.exteriorDistance(node.box.center()), 1e-9);
            EXPECT_LT(node.box.sizes().x(), nodes[*node.parent].box.sizes().x());
        }
    }
    std::size_t inner = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const CloudBlock block = octree->read(n);
        std::set<Place> cells;
        for (const Vec3& place : block.places) {
            EXPECT_TRUE(nodes[n].box.contains(place));
            const Vec3 cell = (place - nodes[n].box.min()) / nodes[n].spacing;
            cells.insert(
                {std::llround(std::floor(cell.x())), std::llround(std::floor(cell.y())), std::llround(std::floor(cell.z()))});
        }
        if (parents.contains(n)) {
            ++inner;
            EXPECT_EQ(cells.size(), block.size());
        } else {
            EXPECT_LE(block.size(), octreeLeafPoints);
        }
    }
    EXPECT_GT(inner, 1U);
}

TEST_F(CloudOctreeTest, IsKeptUntilTheCloudChanges) {
    const std::string path = lay(3'000);
    EXPECT_EQ(keptOctree(path), nullptr);
    EXPECT_TRUE(openOctree(path, {}, Execution()).made);
    EXPECT_FALSE(openOctree(path, {}, Execution()).made);
    // Read in another way it is another cloud.
    EXPECT_EQ(keptOctree(path, {"EPSG:25832", {}}), nullptr);
    // A copy has another time and the same content.
    fs::last_write_time(path, fs::last_write_time(path) + std::chrono::hours(1));
    EXPECT_NE(keptOctree(path), nullptr);
    // As long, of the same time but for a second, another content.
    const auto time = fs::last_write_time(path);
    std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(1'000).put('\x55');
    fs::last_write_time(path, time + std::chrono::seconds(1));
    EXPECT_EQ(keptOctree(path), nullptr);
    EXPECT_TRUE(openOctree(path, {}, Execution()).made);
}

TEST_F(CloudOctreeTest, OneThatWasCutShortOrDamagedIsMadeAnew) {
    const std::string path = lay(30'000);
    const std::string kept = openOctree(path, {}, Execution()).octree->path();
    const auto size = fs::file_size(kept);
    for (const std::uintmax_t left : {size - 1, size / 2, std::uintmax_t{3}}) {
        fs::resize_file(kept, left);
        EXPECT_THROW(CloudOctree{kept}, ParseError);
        EXPECT_EQ(keptOctree(path), nullptr);
        const OpenedOctree again = openOctree(path, {}, Execution());
        EXPECT_TRUE(again.made);
        EXPECT_EQ(placesOf(*again.octree).size(), 30'000U);
    }
    // A byte of a node: the table stands, the node says so.
    std::fstream(kept, std::ios::in | std::ios::out | std::ios::binary).seekp(20).put('\x55');
    const CloudOctree octree(kept);
    const auto readAll = [&] { placesOf(octree); };
    EXPECT_THROW(readAll(), ParseError);
}

TEST_F(CloudOctreeTest, OneThatDoesNotBeginWithARootIsDamaged) {
    const std::string path = lay(30'000);
    using Change = std::function<void(OctreeFoot&, OctreeRow&)>;
    const Change none = [](OctreeFoot&, OctreeRow&) {};
    const Change noNodes = [](OctreeFoot& foot, OctreeRow&) {
        foot.table += foot.nodes * sizeof(OctreeRow);
        foot.points = foot.nodes = 0;
    };
    const Change far = [](OctreeFoot& foot, OctreeRow& row) {
        row.part = 1;
        foot.farPoints = row.points;
    };
    const Change deep = [](OctreeFoot&, OctreeRow& row) { row.level = 1; };
    const std::string kept = openOctree(path, {}, Execution()).octree->path();
    forge(kept, none);
    EXPECT_NE(keptOctree(path), nullptr);
    for (const Change& change : {noNodes, far, deep}) {
        forge(openOctree(path, {}, Execution()).octree->path(), change);
        EXPECT_THROW(CloudOctree{kept}, ParseError);
        EXPECT_EQ(keptOctree(path), nullptr);
    }
}

TEST_F(CloudOctreeTest, NothingOfOthersIsReplaced) {
    const std::string path = lay(3'000);
    std::ofstream(path + ".octree") << "notes of somebody";
    const std::string elsewhere = openOctree(path, {}, Execution()).octree->path();
    EXPECT_NE(elsewhere, path + ".octree");
    std::string kept;
    std::getline(std::ifstream(path + ".octree"), kept);
    EXPECT_EQ(kept, "notes of somebody");
    fs::remove(elsewhere);
    // Nor is what a link leads to.
    fs::remove(path + ".octree");
    std::ofstream(m_folder / "far") << "RBOCT002";
    fs::create_symlink(m_folder / "far", path + ".octree");
    EXPECT_EQ(openOctree(path, {}, Execution()).octree->path(), elsewhere);
    EXPECT_EQ(fs::file_size(m_folder / "far"), 8U);
    fs::remove(elsewhere);
}

TEST_F(CloudOctreeTest, ColoursOf8BitsAreAsBrightAsInTheFile) {
    MadeLas las = hills(3'000);
    for (MadePoint& point : las.points) {
        point.colour = {200, 100, 50};
    }
    const OpenedOctree opened = openOctree(layCloud(m_folder / "dark.las", las.bytes()), {}, Execution());
    const CloudBlock root = opened.octree->read(0);
    ASSERT_FALSE(root.colours.empty());
    EXPECT_EQ(root.colours.front(), (std::array<std::uint16_t, 3>{200, 100, 50}));
}

TEST_F(CloudOctreeTest, SaysHowExactlyPlacesAreKept) {
    // 200 m wide, 2^31 steps.
    EXPECT_NEAR(openOctree(lay(3'000), {}, Execution()).octree->placeStep(), 200.0 / 2147483648.0, 1e-9);
}

TEST_F(CloudOctreeTest, PointsInRunsOnDiskComeInTheSameOrder) {
    std::mt19937_64 random(3);  // NOLINT: the same points each time
    PointSorter few(m_folder / "few", 1'000);
    PointSorter one(m_folder / "one");
    for (int i = 0; i < 10'500; ++i) {
        OctreePoint point;
        point.key = random() >> 40U;
        point.rest = static_cast<std::uint32_t>(random());
        few.add(point);
        one.add(point);
    }
    const auto keysOf = [](PointSorter& sorter) {
        std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
        sorter.forEach(Execution(), [&](const OctreePoint& point) { keys.emplace_back(point.key, point.rest); });
        return keys;
    };
    const auto expected = keysOf(one);
    EXPECT_EQ(expected.size(), 10'500U);
    EXPECT_TRUE(std::is_sorted(expected.begin(), expected.end()));
    EXPECT_EQ(keysOf(few), expected);
    EXPECT_TRUE(fs::is_empty(m_folder.path()));
}

TEST_F(CloudOctreeTest, FarPointsCostTheOthersNoDetail) {
    const WholeCloud clean = readCloud(lay(30'000));
    const std::shared_ptr<const CloudOctree> alone = openOctree(m_folder / "hills.las", {}, Execution()).octree;
    EXPECT_EQ(alone->head().farPoints, 0U);
    for (const std::size_t zeros : {std::size_t{1}, std::size_t{300}, std::size_t{60'000}}) {
        SCOPED_TRACE(zeros);
        // Coordinates of a scanner beside those of UTM; a table states no bounds, and 0, 0, 0 in it is no return.
        const std::string path = m_folder / "zeros" + std::to_string(zeros) + ".xyz";
        std::ofstream table(path);
        table << std::fixed << std::setprecision(3);
        for (std::size_t i = 0; i < clean.points.size(); ++i) {
            table << clean.points.places[i].x() << ' ' << clean.points.places[i].y() << ' ' << clean.points.places[i].z() << '\n';
            for (std::size_t z = i * zeros / 30'000; z < (i + 1) * zeros / 30'000; ++z) {
                table << "0 0 0.001\n";
            }
        }
        table.close();
        const std::shared_ptr<const CloudOctree> octree = openOctree(path, {{}, {"x", "y", "z"}}, Execution()).octree;
        EXPECT_EQ(octree->head().points, 30'000 + zeros);
        EXPECT_EQ(octree->head().farPoints, zeros);
        EXPECT_LT(octree->nodes().front().spacing, 4.0 * alone->nodes().front().spacing);
        EXPECT_LT(octree->placeStep(), 4.0 * alone->placeStep());
        EXPECT_GE(octree->levels(), alone->levels());
        std::multiset<Place> expected = placesOf(*alone);
        std::multiset<Place> near;
        std::uint64_t far = 0;
        for (std::size_t n = 0; n < octree->nodes().size(); ++n) {
            for (const Vec3& place : octree->read(n).places) {
                if (octree->nodes()[n].far) {
                    ++far;
                    EXPECT_LT(place.cwiseAbs().maxCoeff(), 0.001 + octree->farPlaceStep());
                } else {
                    near.insert(placeOf(place));
                }
            }
        }
        EXPECT_EQ(far, zeros);
        EXPECT_EQ(near, expected);
    }
}

TEST_F(CloudOctreeTest, FarPointsWithinTheBoundsOfAHeadAreFound) {
    MadeLas las = hills(30'000);
    las.points[17].place = {-431'000'000, -2'000'000'000, -100'000};
    const std::shared_ptr<const CloudOctree> octree =
        openOctree(layCloud(m_folder / "far.las", las.bytes()), {}, Execution()).octree;
    EXPECT_EQ(octree->head().points, 30'000U);
    EXPECT_EQ(octree->head().farPoints, 1U);
    EXPECT_LT(octree->placeStep(), 1e-6);
    EXPECT_TRUE(octree->nodes().back().far);
    EXPECT_NEAR(octree->read(octree->nodes().size() - 1).places.front().x(), 0.0, octree->farPlaceStep());
    EXPECT_LE(octree->farPlaceStep(), 0.002);
}

TEST_F(CloudOctreeTest, AMastThatTheDrawMissedIsNoFarPoint) {
    MadeLas las = hills(140'000);
    las.points[17].place = {-431'000'000, -2'000'000'000, -100'000};
    // 2 widths of the others beside them, of a number that the draw passes over.
    const std::array<std::int32_t, 3> mast{600'000, 50'000, 9'000};
    const auto missed = [&](std::size_t number) {
        CloudBulk bulk;
        for (std::size_t i = 0; i < las.points.size(); ++i) {
            const auto& at = i == number ? mast : las.points[i].place;
            bulk.add(0.001 * Vec3(at[0], at[1], at[2]));
        }
        return !bulk.box({}).contains(Vec3(600.0, 50.0, 9.0));
    };
    std::size_t number = 1'001;
    while (number < 1'020 && !missed(number)) {
        ++number;
    }
    ASSERT_LT(number, 1'020U);
    las.points[number].place = mast;
    const std::shared_ptr<const CloudOctree> octree =
        openOctree(layCloud(m_folder / "mast.las", las.bytes()), {}, Execution()).octree;
    EXPECT_EQ(octree->head().points, 140'000U);
    EXPECT_EQ(octree->head().farPoints, 1U);
    EXPECT_NEAR(octree->placeStep(), 600.0 / 2147483648.0, 1e-9);
    EXPECT_EQ(placesOf(*octree).count({600'000, 50'000, 9'000}), 1U);
}

TEST_F(CloudOctreeTest, ADrawHasNoBeatWithTheRowsOfAScan) {
    // Rows of 1,024 points: each 16th of all would be the same 64 of each row.
    CloudBulk bulk;
    for (int i = 0; i < 1'048'576; ++i) {
        // Every 16th column is at the near edge.
        bulk.add({i % 16 == 0 ? 0.0 : 1.0 * (i % 1'024), 0.001 * (i / 1'024), 0.0});
    }
    EXPECT_TRUE(bulk.box({}).contains(Vec3(1'023.0, 0.5, 0.0)));
    EXPECT_TRUE(bulk.reach({}).contains(Vec3(5'000.0, 0.5, 0.0)));
    EXPECT_FALSE(bulk.reach({}).contains(Vec3(50'000.0, 0.5, 0.0)));
}

TEST_F(CloudOctreeTest, WallsApartAndSparseSurroundingsAreNoFarPoints) {
    CloudBulk walls;
    CloudBulk scan;
    std::mt19937 random(5);  // NOLINT: the same points each time
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < 40'000; ++i) {
        walls.add({i % 3 == 0 ? 60.0 : 0.0, 20.0 * share(random), 10.0 * share(random)});
        // Half within 5 m of the scanner, the farthest at 500 m.
        const double range = 0.5 * std::pow(1000.0, share(random));
        const double angle = 6.28 * share(random);
        scan.add({range * std::cos(angle), range * std::sin(angle), 0.1 * range});
    }
    EXPECT_TRUE(walls.box({}).contains(Vec3(60.0, 10.0, 5.0)));
    EXPECT_TRUE(walls.box({}).contains(Vec3(0.0, 10.0, 5.0)));
    for (const double angle : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}) {
        EXPECT_TRUE(scan.box({}).contains(Vec3(495.0 * std::cos(angle), 495.0 * std::sin(angle), 49.0)));
    }
    EXPECT_TRUE(CloudBulk().box({}).isEmpty());
}

TEST_F(CloudOctreeTest, TheContentOfACopyIsReadOnceAndCanBeGivenUp) {
    const std::string path = lay(30'000);
    const std::string kept = openOctree(path, {}, Execution()).octree->path();
    const auto copied = [&] { fs::last_write_time(path, fs::last_write_time(path) + std::chrono::hours(1)); };
    copied();
    Execution given;
    given.cancel();
    EXPECT_THROW(keptOctree(path, {}, given), Cancelled);
    EXPECT_FALSE(fs::exists(kept + ".checked"));
    EXPECT_NE(keptOctree(path), nullptr);
    EXPECT_TRUE(fs::exists(kept + ".checked"));
    // What is not read is not given up.
    EXPECT_NE(keptOctree(path, {}, given), nullptr);
    copied();
    EXPECT_THROW(keptOctree(path, {}, given), Cancelled);
    // A note that is no digest counts for nothing.
    EXPECT_NE(keptOctree(path), nullptr);
    fs::resize_file(kept + ".checked", fs::file_size(kept + ".checked") - 1);
    EXPECT_THROW(keptOctree(path, {}, given), Cancelled);
}

TEST_F(CloudOctreeTest, AFileOfTheUserIsNotTakenForANoteOfOurs) {
    const std::string path = lay(3'000);
    const std::string note = openOctree(path, {}, Execution()).octree->path() + ".checked";
    fs::last_write_time(path, fs::last_write_time(path) + std::chrono::hours(1));
    std::ofstream(note) << "checked by hand on Monday";
    EXPECT_NE(keptOctree(path), nullptr);
    EXPECT_EQ(contentOf(note), "checked by hand on Monday");
}

TEST_F(CloudOctreeTest, WhatAKilledProcessLeftIsTakenAway) {
    const std::string path = lay(3'000);
    const std::string old = path + ".octree.123-0.part";
    const std::string fresh = path + ".octree.124-0.part";
    const std::string other = path + "2.octree.123-0.part";
    for (const std::string& left : {old, fresh, other}) {
        std::ofstream(left) << "RBOCT";
    }
    for (const std::string& left : {old, other}) {
        fs::last_write_time(left, fs::file_time_type::clock::now() - std::chrono::hours(1));
    }
    openOctree(path, {}, Execution());
    EXPECT_FALSE(fs::exists(old));
    EXPECT_TRUE(fs::exists(fresh)) << "somebody may be writing it";
    EXPECT_TRUE(fs::exists(other));
}

TEST_F(CloudOctreeTest, WhereItCannotBeWrittenBesideTheCloudItLiesInTheCache) {
    // A name that leaves no room for that of a file that is not whole.
    const std::string path = layCloud(m_folder / std::string(242, 'n') + ".las", hills(3'000).bytes());
    const std::string kept = openOctree(path, {}, Execution()).octree->path();
    EXPECT_NE(kept, path + ".octree");
    EXPECT_NE(keptOctree(path), nullptr);
    fs::remove(kept);
}

TEST_F(CloudOctreeTest, AFullDiskSaysWhereAndHowMuchRoomIsNeeded) {
    const std::string path = lay(30'000);
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{100'000, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    std::string id;
    std::string told;
    try {
        openOctree(path, {}, Execution());
    } catch (const WorldError& error) {
        id = error.message().id;
        told = error.what() + englishText(error.remedy());
    }
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(id, "octree.no_room");
    EXPECT_NE(told.find(path), std::string::npos) << told;
    EXPECT_NE(told.find("about 2 MB"), std::string::npos) << told;
    EXPECT_EQ(std::distance(fs::directory_iterator(m_folder.path()), fs::directory_iterator()), 1) << "nothing is left";
}

TEST_F(CloudOctreeTest, ManyPointsAtOnePlaceArePartsOfOneNode) {
    MadeLas las = hills(2'000);
    las.points.resize(600'000, las.points.front());
    const OpenedOctree opened = openOctree(layCloud(m_folder / "one.las", las.bytes()), {}, Execution());
    std::uint64_t points = 0;
    for (const OctreeNode& node : opened.octree->nodes()) {
        points += node.points;
        EXPECT_LE(node.points, std::uint32_t{1} << 18U);
    }
    EXPECT_EQ(points, 600'000U);
}

TEST_F(CloudOctreeTest, AViewKeepsItsBudgetAndComesWithTheParents) {
    const std::shared_ptr<const CloudOctree> octree = openOctree(lay(120'000), {}, Execution()).octree;
    const std::vector<OctreeNode>& nodes = octree->nodes();
    const auto near = [&](std::size_t n) { return 1000.0 * nodes[n].spacing; };
    for (const std::uint64_t budget : {std::uint64_t{10'000}, std::uint64_t{60'000}, std::uint64_t{200'000}}) {
        const OctreeChoice choice = chooseNodes(nodes, near, budget, 0.001);
        EXPECT_LE(choice.points, budget);
        EXPECT_EQ(choice.whole, budget > 120'000);
        std::set<std::size_t> there;
        std::uint64_t points = 0;
        for (const std::size_t n : choice.nodes) {
            EXPECT_TRUE(!nodes[n].parent || there.contains(*nodes[n].parent));
            there.insert(n);
            points += nodes[n].points;
        }
        EXPECT_EQ(points, choice.points);
    }
    EXPECT_EQ(chooseNodes(nodes, near, 200'000, 0.001).points, 120'000U);
    // From afar the coarsest level is enough, out of sight nothing is.
    EXPECT_EQ(chooseNodes(nodes, [](std::size_t) { return 0.5; }, 200'000).nodes, std::vector<std::size_t>{0});
    EXPECT_TRUE(chooseNodes(nodes, [](std::size_t) { return 0.0; }, 200'000).nodes.empty());
}

TEST_F(CloudOctreeTest, ACloudWithoutPointsHasNone) {
    EXPECT_THROW(openOctree(layCloud(m_folder / "none.las", hills(1).bytes()), {"no system", {}}, Execution()), Error);
    MadeLas withheld = hills(1);
    withheld.points.front().withheld = true;
    const std::string path = layCloud(m_folder / "withheld.las", withheld.bytes());
    EXPECT_THROW(openOctree(path, {}, Execution()), ParseError);
    EXPECT_FALSE(fs::exists(path + ".octree"));
}

}  // namespace rubble::io
