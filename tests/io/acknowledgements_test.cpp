#include "io/run/acknowledgements.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/simulation/health/passed_limits.h"
#include "io/exports/exports.h"
#include "io/run/run_file.h"
#include "tests/io/sample_run.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

class Acknowledgements : public testing::Test {
protected:
    TemporaryFolder folder;
    std::string path = folder / "a.run.h5";

    SampleRun write(std::uint32_t seed = 1) {
        const SampleRun run = makeSampleRun(seed, 10, 3);
        run.feed(*createRun(path, run.origin));
        return run;
    }
    std::string sidecar() const { return acknowledgementPath(path); }
    std::string content() const {
        std::ifstream in(sidecar());
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void put(const std::string& text) const { std::ofstream(sidecar()) << text; }
};

std::string idOf(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_FALSE(error.remedy().empty());
        return error.message().id;
    }
    return "";
}

TEST_F(Acknowledgements, ComeBackInTheOrderInWhichTheyWereMade) {
    const SampleRun run = write();
    EXPECT_TRUE(acknowledgements(path).empty());
    EXPECT_TRUE(taintOf(*openRun(path)).tainted());
    acknowledge(path, {"  Ada \xC3\x84", "", "the drift is that of one block\n", {}});
    acknowledge(path, {"Ben", "2020-01-02T03:04:05Z", "seen as well", {}});
    const std::vector<Acknowledgement> list = acknowledgements(path);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].by, "Ada \xC3\x84");
    EXPECT_EQ(list[0].note, "the drift is that of one block");
    EXPECT_EQ(list[0].when.size(), 20u);
    EXPECT_EQ(list[1].when, "2020-01-02T03:04:05Z");
    EXPECT_EQ(list[0].breaches, breachesDigest(run.result));
    const Taint taint = taintOf(*openRun(path));
    EXPECT_FALSE(taint.tainted());
    EXPECT_EQ(taint.limits, passedLimits(run.result.health.breaches).size());
    EXPECT_EQ(taint.acknowledgement->by, "Ben") << "the last one counts";
    EXPECT_NO_THROW(checkRunDigest(path, Execution())) << "the run file is untouched";
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

TEST_F(Acknowledgements, AnotherRunOfTheSameNameNeedsItsOwn) {
    write(1);
    acknowledge(path, {"Ada", "", "looked at it", {}});
    write(2);
    EXPECT_EQ(acknowledgements(path).size(), 1u);
    EXPECT_TRUE(taintOf(*openRun(path)).tainted());
    write(1);
    EXPECT_FALSE(taintOf(*openRun(path)).tainted()) << "the same run made anew is the same run";
}

TEST_F(Acknowledgements, NeedANameANoteAndARunWithBreaches) {
    write();
    EXPECT_EQ(idOf([&] { acknowledge(path, {"", "", "note", {}}); }), "io.acknowledged.empty");
    EXPECT_EQ(idOf([&] { acknowledge(path, {"Ada", "", " \t\n", {}}); }), "io.acknowledged.empty");
    EXPECT_FALSE(std::filesystem::exists(sidecar()));
    SampleRun sound = makeSampleRun(3, 10, 3);
    sound.result.health = {};
    sound.feed(*createRun(path, sound.origin));
    EXPECT_EQ(idOf([&] { acknowledge(path, {"Ada", "", "note", {}}); }), "io.acknowledged.sound");
    EXPECT_FALSE(taintOf(*openRun(path)).tainted());
    SampleRun stopped = makeSampleRun(4, 10, 3);
    ASSERT_EQ(stopped.result.health.breaches.front().check, HealthCheck::Energy);
    stopped.result.health.breaches.front().worst = 0.5;
    stopped.feed(*createRun(path, stopped.origin), 2);
    EXPECT_EQ(idOf([&] { acknowledge(path, {"Ada", "", "note", {}}); }), "io.acknowledged.incomplete");
    EXPECT_TRUE(taintOf(*openRun(path)).tainted()) << "it tells of breaches on its way";
    EXPECT_FALSE(taintOf(*openRun(path)).complete);
    EXPECT_THROW(acknowledge(folder / "none.run.h5", {"Ada", "", "note", {}}), WorldError);
    std::ofstream(folder / "text") << "no run";
    EXPECT_THROW(acknowledge(folder / "text", {"Ada", "", "note", {}}), ParseError);
}

TEST_F(Acknowledgements, RefuseASidecarThatIsNone) {
    write();
    acknowledge(path, {"Ada", "", "looked at it", {}});
    const std::string good = content();
    for (std::size_t length = 0; length + 2 < good.size(); length += 7) {
        put(good.substr(0, length));
        EXPECT_THROW(acknowledgements(path), ParseError) << length;
        EXPECT_TRUE(taintOf(*openRun(path)).tainted()) << length;
    }
    for (
        const std::string& text :
        {std::string("\0\xFF\x7F", 3), std::string("[]"), std::string("{}"), std::string("{\"format\": \"something\"}"),
         std::string(R"({"format": "rubble-acknowledgements", "version": 1, "acknowledgements": [{"by": 3}]})"),
         std::string(
             R"({"format": "rubble-acknowledgements", "version": 1, "acknowledgements": [{"by": "a", "when": "b", "note": "c", "breaches": "xyz"}]})")}) {
        put(text);
        EXPECT_THROW(acknowledgements(path), ParseError) << text;
        EXPECT_FALSE(taintOf(*openRun(path)).problem.empty()) << text;
        EXPECT_THROW(acknowledge(path, {"Ada", "", "again", {}}), ParseError) << "what lies there is not written over";
        EXPECT_EQ(content(), text);
    }
    put(R"({"format": "rubble-acknowledgements", "version": 2, "acknowledgements": []})");
    EXPECT_EQ(idOf([&] { acknowledgements(path); }), "io.json.version");
    put(std::string(std::size_t{17} << 20, ' '));
    EXPECT_EQ(idOf([&] { acknowledgements(path); }), "io.json.too_large");
    std::filesystem::remove(sidecar());
    std::filesystem::create_directory(sidecar());
    EXPECT_THROW(acknowledgements(path), WorldError);
    std::filesystem::remove(sidecar());
    std::filesystem::create_symlink(folder / "nowhere", sidecar());
    EXPECT_THROW(acknowledgements(path), WorldError) << "a link that leads nowhere is no absence";
}

TEST_F(Acknowledgements, SayWhenTheyCannotBeWritten) {
    write();
    const FileSizeLimit limit(10);
    try {
        acknowledge(path, {"Ada", "", "looked at it", {}});
        FAIL() << "a full disk";
    } catch (const WorldError& error) {
        EXPECT_NE(std::string(error.what()).find(sidecar()), std::string::npos) << error.what();
    }
    EXPECT_FALSE(std::filesystem::exists(sidecar()));
}

TEST_F(Acknowledgements, StandInTheProvenanceOfExports) {
    const SampleRun run = write();
    const auto health = [&] { return nlohmann::json::parse(provenanceText(*openRun(path)))["health"]; };
    EXPECT_EQ(health()["breaches"], passedLimits(run.result.health.breaches).size());
    EXPECT_EQ(health()["grade"], "tainted");
    EXPECT_EQ(health()["tainted"], true);
    EXPECT_TRUE(health()["acknowledged"].is_null());
    acknowledge(path, {"Ada", "2020-01-02T03:04:05Z", "looked at it", {}});
    EXPECT_EQ(health()["tainted"], false);
    EXPECT_EQ(health()["acknowledged"]["by"], "Ada");
    EXPECT_EQ(health()["acknowledged"]["when"], "2020-01-02T03:04:05Z");
}

}  // namespace
}  // namespace rubble::io
