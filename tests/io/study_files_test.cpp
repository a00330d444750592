#include "io/run/study_files.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/unknown.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "io/base/machine.h"
#include "io/run/world_record.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

WorldOrigin someOrigin() {
    WorldOrigin origin;
    origin.key = Hasher().text("world").finish();
    origin.build = "some build";
    origin.feSha256 = std::string(64, 'a');
    origin.scenario = Hasher().text("scenario").finish();
    origin.repeat = 2;
    origin.birthShift = 1e-6;
    origin.machine = "some machine";
    return origin;
}

SimulatedWorld someWorld(std::size_t fragments) {
    SimulatedWorld world;
    world.trajectoryHash = Hasher().text("trajectory").finish();
    world.endTime = 19.7;
    world.wallSeconds = 30.25;
    world.stepMeanMs = 17.1;
    world.stepWorstMs = 76.6;
    world.breaches = 3;
    world.bodiesPeak = 4500;
    for (std::size_t f = 0; f < fragments; ++f) {
        DebrisFragment lies;
        lies.present = f % 3 != 0;
        lies.centre = Vec3(0.1 * static_cast<double>(f), -1.0 / 3.0, 1e-300);
        lies.box = {lies.centre + Vec3(0, 0, 1), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY())), Vec3(0.5, 0.25, 0.125)};
        lies.mass = 2400.0;
        lies.volume = 1.0;
        world.atRest.fragments.push_back(lies);
        lies.centre.x() += 1.0;
        world.atFeEnd.fragments.push_back(lies);
    }
    world.atRest.time = 19.7;
    world.atFeEnd.time = 9.6;
    return world;
}

void expectSame(const Debris& a, const Debris& b) {
    EXPECT_EQ(a.time, b.time);
    ASSERT_EQ(a.fragments.size(), b.fragments.size());
    for (std::size_t f = 0; f < a.fragments.size(); ++f) {
        EXPECT_EQ(a.fragments[f].present, b.fragments[f].present);
        EXPECT_EQ(a.fragments[f].centre, b.fragments[f].centre);
        EXPECT_EQ(a.fragments[f].box.centre, b.fragments[f].box.centre);
        EXPECT_EQ(a.fragments[f].box.orientation.coeffs(), b.fragments[f].box.orientation.coeffs());
        EXPECT_EQ(a.fragments[f].box.halfExtents, b.fragments[f].box.halfExtents);
        EXPECT_EQ(a.fragments[f].mass, b.fragments[f].mass);
        EXPECT_EQ(a.fragments[f].volume, b.fragments[f].volume);
    }
}

class StudyFilesTest : public testing::Test {
protected:
    std::string contentOf(const std::string& path) const {
        std::stringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }
    void write(const std::string& path, const std::string& content) const {
        std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
    }
    TemporaryFolder folder;
    StudyFiles files{folder / "cache"};
    Findings findings;
};

TEST_F(StudyFilesTest, AWorldComesBackBitForBit) {
    EXPECT_FALSE(files.world(someOrigin(), findings));
    const SimulatedWorld world = someWorld(7);
    files.keep(someOrigin(), world);
    const std::optional<SimulatedWorld> back = files.world(someOrigin(), findings);
    ASSERT_TRUE(back);
    EXPECT_TRUE(findings.empty());
    EXPECT_EQ(back->trajectoryHash, world.trajectoryHash);
    EXPECT_EQ(back->endTime, world.endTime);
    EXPECT_EQ(back->wallSeconds, world.wallSeconds);
    EXPECT_EQ(back->stepMeanMs, world.stepMeanMs);
    EXPECT_EQ(back->stepWorstMs, world.stepWorstMs);
    EXPECT_EQ(back->breaches, 3);
    EXPECT_EQ(back->bodiesPeak, 4500);
    expectSame(back->atRest, world.atRest);
    expectSame(back->atFeEnd, world.atFeEnd);
}

TEST_F(StudyFilesTest, AWorldOfSomethingElseIsRefused) {
    const WorldOrigin origin = someOrigin();
    const auto foreign = [&](const char* part, auto change) {
        WorldOrigin other = origin;
        change(other);
        // As a file that somebody copied under this name.
        std::filesystem::create_directories(std::filesystem::path(files.worldPath(origin)).parent_path());
        write(files.worldPath(origin), worldBytes(other, someWorld(2)));
        Findings found;
        EXPECT_FALSE(files.world(origin, found)) << part;
        ASSERT_EQ(found.count("study.foreign"), 1) << part;
        EXPECT_THAT(found.list()[0].example, testing::HasSubstr(part));
    };
    foreign("build", [](WorldOrigin& o) { o.build = "another build"; });
    foreign("scenario", [](WorldOrigin& o) { o.scenario = Digest{}; });
    foreign("FE result", [](WorldOrigin& o) { o.feSha256 = std::string(64, 'b'); });
    foreign("repeat", [](WorldOrigin& o) { o.repeat = 1; });
    foreign("terrain", [](WorldOrigin& o) { o.key = Digest{}; });
}

TEST_F(StudyFilesTest, AWorldOfAnotherMachineIsMarked) {
    files.keep(someOrigin(), someWorld(2));
    WorldOrigin here = someOrigin();
    here.machine = "another machine";
    EXPECT_TRUE(files.world(here, findings));
    EXPECT_EQ(findings.count("study.other_machine"), 1);
}

TEST_F(StudyFilesTest, DamageIsSeenAtEveryByteAndIsNoError) {
    files.keep(someOrigin(), someWorld(3));
    const std::string path = files.worldPath(someOrigin());
    const std::string sound = contentOf(path);
    for (std::size_t i = 0; i < sound.size(); i += 5) {
        std::string changed = sound;
        changed[i] = static_cast<char>(changed[i] ^ 0x10);
        EXPECT_THROW(worldFromBytes(changed, "f"), ParseError) << i;
        EXPECT_THROW(worldFromBytes(std::string_view(sound).substr(0, i), "f"), ParseError) << i;
    }
    EXPECT_THROW(worldFromBytes(sound + "x", "f"), ParseError);
    EXPECT_THROW(worldFromBytes("", "f"), ParseError);
    write(path, sound.substr(0, sound.size() / 2));
    EXPECT_FALSE(files.world(someOrigin(), findings));
    EXPECT_EQ(findings.count("study.damaged"), 1);
    files.keep(someOrigin(), someWorld(3));
    EXPECT_TRUE(files.world(someOrigin(), findings)) << "made again, it is sound";
}

TEST_F(StudyFilesTest, ARecordThatClaimsMoreThanItHoldsIsRefused) {
    // Right digest, wrong count: the number of fragments at rest is the eighth byte before the first of them.
    std::string bytes = worldBytes(someOrigin(), someWorld(0));
    const std::size_t count = bytes.size() - 16 - 16 - 16 + 8;
    bytes[count + 7] = 0x7f;
    const Digest digest = Hasher().bytes(bytes.data(), bytes.size() - 16).finish();
    bytes.replace(bytes.size() - 16, 16, reinterpret_cast<const char*>(digest.bytes.data()), 16);
    EXPECT_THROW(worldFromBytes(bytes, "f"), ParseError);
}

TEST_F(StudyFilesTest, AFullDiskIsAnErrorAndLeavesNothing) {
    {
        const FileSizeLimit limit(1000);
        EXPECT_THROW(files.keep(someOrigin(), someWorld(100)), WorldError);
    }
    EXPECT_FALSE(files.world(someOrigin(), findings));
    EXPECT_TRUE(findings.empty());
}

TEST_F(StudyFilesTest, CostsHoldForOneMachineAndItsThreads) {
    SettingCost cost;
    cost.wallSeconds = 12.5;
    cost.stepMeanMs = 0.1 + 0.2;
    cost.threads = 2;
    files.keep(someOrigin(), cost);
    const auto back = files.cost(someOrigin(), 2);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->wallSeconds, 12.5);
    EXPECT_EQ(back->stepMeanMs, 0.1 + 0.2);
    EXPECT_TRUE(std::isnan(back->fps));
    EXPECT_FALSE(files.cost(someOrigin(), 4));
    WorldOrigin elsewhere = someOrigin();
    elsewhere.machine = "another machine";
    EXPECT_FALSE(files.cost(elsewhere, 2));
}

TEST_F(StudyFilesTest, PointsOfASceneAreKeptAndBroughtUpToDate) {
    KnownPoint point;
    point.scene = Hasher().text("scene").finish();
    point.machine = "some machine";
    point.setting = "multiple=2";
    point.parameters = {{"step_rate", "120"}};
    point.fragments = 10000;
    point.bodies = 4000;
    point.values.fill(unknown);
    point.values[0] = 12.0;
    files.keep(point);
    KnownPoint again = point;
    again.values[0] = unknown;
    again.values[2] = 24.0;
    files.keep(again);
    KnownPoint other = point;
    other.bodies = 5000;
    files.keep(other);
    const std::vector<KnownPoint> back = files.points(point.scene, findings);
    ASSERT_EQ(back.size(), 2u);
    const KnownPoint& first = back[0].bodies == 4000 ? back[0] : back[1];
    EXPECT_EQ(first.values[0], 12.0) << "what is not known now stays";
    EXPECT_EQ(first.values[2], 24.0);
    EXPECT_EQ(first.parameters, point.parameters);
    EXPECT_TRUE(files.points(Digest{}, findings).empty());
    EXPECT_TRUE(findings.empty());
    const std::filesystem::path points = std::filesystem::path(folder / "cache") / "points" / point.scene.hex();
    write(points / "broken.json", "{");
    write(points / "newer.json", R"({"version": 2})");
    EXPECT_EQ(files.points(point.scene, findings).size(), 2u);
    EXPECT_EQ(findings.count("study.damaged"), 2);
}

TEST_F(StudyFilesTest, ACalibrationIsKeptForItsMachine) {
    Calibration calibration;
    calibration.machine = "some machine";
    calibration.renderer = "llvmpipe";
    calibration.build = "some build";
    calibration.threads = 2;
    calibration.othersShare = 0.03;
    calibration.complete = true;
    calibration.points = {{PileKind::Typical, 500, 100.0, 50.0, 33.0}, {PileKind::Worst, 500, 40.0, unknown, unknown}};
    files.keep(calibration);
    const auto back = files.calibration("some machine", findings);
    ASSERT_TRUE(back);
    ASSERT_EQ(back->points.size(), 2u);
    EXPECT_EQ(back->points[0].liveFps, 33.0);
    EXPECT_EQ(back->points[1].pile, PileKind::Worst);
    EXPECT_TRUE(std::isnan(back->points[1].liveFps));
    EXPECT_EQ(back->othersShare, 0.03);
    EXPECT_EQ(back->renderer, "llvmpipe");
    EXPECT_FALSE(files.calibration("another machine", findings));
    EXPECT_TRUE(findings.empty());
    write(files.calibrationPath("some machine"), R"({"version": 1, "machine": "some machine", "points": [{"pile": "heap"}]})");
    EXPECT_FALSE(files.calibration("some machine", findings));
    EXPECT_EQ(findings.count("study.damaged"), 1);
}

TEST(Machine, SaysWhatItIs) {
    EXPECT_THAT(machineText(), testing::MatchesRegex(".+, [0-9]+ threads, [0-9.]+ GiB"));
    EXPECT_EQ(machineText(), machineText());
}

TEST(Machine, TheCacheFollowsTheEnvironment) {
    const auto with = [](const char* own, const char* shared, const char* home) {
        for (const auto& [name, value] : {std::pair{"RUBBLE_CACHE", own}, {"XDG_CACHE_HOME", shared}, {"HOME", home}}) {
            value ? setenv(name, value, 1) : unsetenv(name);
        }
        return cacheFolder();
    };
    const char* before = std::getenv("HOME");
    const std::string home = before ? before : "/";
    EXPECT_EQ(with("/a", "/b", "/c"), "/a");
    EXPECT_EQ(with(nullptr, "/b", "/c"), "/b/rubble");
    EXPECT_EQ(with("relative", "also/relative", "/c"), "/c/.cache/rubble") << "relative paths do not count";
    EXPECT_THROW(with(nullptr, nullptr, nullptr), WorldError);
    setenv("HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace rubble::io
