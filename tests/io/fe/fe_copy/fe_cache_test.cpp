#include "io/fe/fe_copy/fe_cache.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/io/exports/convert/mixed_result.h"
#include "tests/io/fe/d3plot/d3plot_builder.h"
#include "tests/io/fe/fe_copy/chunk_damage.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;

class FeCache : public testing::Test {
protected:
    FeCache() {
        m_builder.times = {0, 1, 2, 3};
        m_builder.deaths = {{0, 2}};
        m_builder.write(m_path);
    }

    std::shared_ptr<const FeResult> open() const { return openFeCached(m_path, {}, {}, Execution{}, m_cache); }

    std::string copyPath() const {
        for (const auto& entry : fs::directory_iterator(m_cache + "/fe")) {
            if (entry.path().extension() == ".h5") {
                return entry.path().string();
            }
        }
        return {};
    }
    std::size_t filesOf(const std::string& ending) const {
        const fs::directory_iterator folder(m_cache + "/fe"), end;
        return static_cast<std::size_t>(
            std::count_if(folder, end, [&](const fs::directory_entry& entry) { return entry.path().extension() == ending; }));
    }
    fs::file_time_type copyTime() const { return fs::last_write_time(copyPath()); }

    TemporaryFolder m_folder;
    const std::string m_path = m_folder / "d3plot";
    const std::string m_cache = m_folder / "cache";
    D3plotBuilder m_builder;
};

TEST_F(FeCache, ReopeningGivesTheSameBitByBit) {
    const auto plain = openFe(m_path, {}, {}, Execution{});
    const auto first = open();
    const std::string copy = copyPath();
    ASSERT_FALSE(copy.empty());
    const auto time = copyTime();
    const auto second = open();
    for (const auto& fe : {first, second}) {
        expectSameResult(*plain, *fe);
        EXPECT_EQ(fe->contents().format, "LS-DYNA d3plot");
        EXPECT_EQ(fe->contents().path, plain->contents().path);
        EXPECT_EQ(fe->contents().files, plain->contents().files);
        EXPECT_EQ(fe->contents().bytes, plain->contents().bytes);
        EXPECT_EQ(fe->contents().sha256, plain->contents().sha256);
        EXPECT_EQ(fe->contents().fingerprint, plain->contents().fingerprint) << "names every later result";
        EXPECT_EQ(fe->contents().activityFrom, plain->contents().activityFrom);
        EXPECT_EQ(fe->contents().findings.list().size(), plain->contents().findings.list().size());
    }
    EXPECT_EQ(copyTime(), time) << "was made once";
    EXPECT_FALSE(hasGrown(*second));
}

// A digest beside the copy that does not belong to it would be noticed where files are read; here none are.
TEST_F(FeCache, UntouchedFilesAreNotReadAgain) {
    open();
    const std::vector<std::string> reports = [&] {
        std::vector<std::string> stages;
        const Execution execution =
            Execution([&](const Progress& progress) { stages.push_back(progress.stage.id); }).withThreads(1);
        openFeCached(m_path, {}, {}, execution, m_cache);
        return stages;
    }();
    EXPECT_EQ(std::count(reports.begin(), reports.end(), "fe.digest"), 0);
    // Another time: the digest decides, and is noted.
    fs::last_write_time(m_path, fs::last_write_time(m_path) + std::chrono::hours(1));
    const auto time = copyTime();
    std::vector<std::string> stages;
    const Execution execution = Execution([&](const Progress& progress) { stages.push_back(progress.stage.id); }).withThreads(1);
    openFeCached(m_path, {}, {}, execution, m_cache);
    EXPECT_GT(std::count(stages.begin(), stages.end(), "fe.digest"), 0);
    EXPECT_EQ(copyTime(), time);
    stages.clear();
    openFeCached(m_path, {}, {}, execution, m_cache);
    EXPECT_EQ(std::count(stages.begin(), stages.end(), "fe.digest"), 0);
}

TEST_F(FeCache, OtherContentOfTheSameSizeIsSeen) {
    const auto before = open();
    m_builder.deaths = {{0, 1}};
    m_builder.write(m_path);
    for (const std::string& file : before->contents().files) {
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(24));
    }
    const auto after = open();
    EXPECT_EQ(after->contents().bytes, before->contents().bytes);
    expectSameResult(*openFe(m_path, {}, {}, Execution{}), *after);
    expectSameResult(*after, *open());
    EXPECT_NE(after->contents().fingerprint, before->contents().fingerprint);
}

TEST_F(FeCache, AGrownSeriesIsCopiedAnew) {
    const auto before = open();
    m_builder.times = {0, 1, 2, 3, 4, 5};
    m_builder.write(m_path);
    const auto after = open();
    EXPECT_EQ(after->stateCount(), 6u);
    EXPECT_EQ(open()->stateCount(), 6u);
    const FeGrowth growth = growthBetween(*before, *after);
    EXPECT_EQ(growth.states, 2);
    EXPECT_EQ(growth.deaths, 0);
    EXPECT_GT(growth.bytes, 0);
    EXPECT_EQ(filesOf(".h5"), 1u);
}

TEST_F(FeCache, SettingsAndFramesHaveCopiesOfTheirOwn) {
    open();
    Frame frame;
    frame.origin << 100, 0, 0;
    const auto moved = openFeCached(m_path, {}, frame, Execution{}, m_cache);
    EXPECT_EQ(filesOf(".h5"), 2u);
    expectSameResult(*openFe(m_path, {}, frame, Execution{}), *openFeCached(m_path, {}, frame, Execution{}, m_cache));
    EXPECT_EQ(moved->state(1)->positions[0].x() + 100.0, open()->state(1)->positions[0].x());
}

TEST_F(FeCache, ADamagedCopyIsMadeAgainAndSaid) {
    const auto whole = open();
    const std::string copy = copyPath();
    const auto size = fs::file_size(copy);
    for (const std::uintmax_t left : {std::uintmax_t{0}, std::uintmax_t{100}, size / 2, size - 1}) {
        fs::resize_file(copy, left);
        const auto again = open();
        EXPECT_EQ(again->contents().findings.count("fe_cache.damaged"), 1) << left;
        expectSameResult(*whole, *again);
        const auto then = open();
        EXPECT_EQ(then->contents().findings.count("fe_cache.damaged"), 0) << left;
        EXPECT_EQ(fs::file_size(copy), size) << left;
    }
    std::ofstream(copy, std::ios::trunc) << "no HDF5 at all";
    EXPECT_EQ(open()->contents().findings.count("fe_cache.damaged"), 1);
}

TEST_F(FeCache, ADamagedStateIsReadFromTheResult) {
    const auto plain = openFe(m_path, {}, {}, Execution{});
    open();
    const std::string copy = copyPath();
    damageChunk(copy, "/positions/000002");
    const auto fe = open();
    EXPECT_EQ(fe->contents().findings.count("fe_cache.damaged"), 0) << "nobody has looked at states yet";
    EXPECT_EQ(fe->state(1)->positions, plain->state(1)->positions);
    EXPECT_EQ(filesOf(".damaged"), 0u);
    expectSameResult(*plain, *fe);
    EXPECT_EQ(filesOf(".damaged"), 1u);
    const auto then = open();
    EXPECT_EQ(then->contents().findings.count("fe_cache.damaged"), 1);
    EXPECT_EQ(filesOf(".damaged"), 0u);
    expectSameResult(*plain, *then);
}

TEST_F(FeCache, ProgramsAtOnceDoNotSpoilIt) {
    const auto plain = openFe(m_path, {}, {}, Execution{});
    std::vector<pid_t> children;
    for (int i = 0; i < 4; ++i) {
        const pid_t child = ::fork();
        if (child == 0) {
            int wrong = 0;
            for (int round = 0; round < 3; ++round) {
                wrong += open()->stateCount() == 4u ? 0 : 1;
            }
            ::_exit(wrong);
        }
        children.push_back(child);
    }
    for (const pid_t child : children) {
        int status = -1;
        ::waitpid(child, &status, 0);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
    EXPECT_EQ(filesOf(".h5"), 1u);
    EXPECT_EQ(filesOf(".part"), 0u);
    const auto fe = open();
    EXPECT_TRUE(fe->contents().findings.count("fe_cache.damaged") == 0);
    expectSameResult(*plain, *fe);
}

TEST_F(FeCache, WithoutRoomTheResultOpensAllTheSame) {
    const FileSizeLimit limit(1000);
    const auto fe = open();
    EXPECT_EQ(fe->contents().findings.count("fe_cache.not_kept"), 1);
    expectSameResult(*openFe(m_path, {}, {}, Execution{}), *fe);
    EXPECT_EQ(filesOf(".part"), 0u);
    EXPECT_TRUE(copyPath().empty());
}

TEST_F(FeCache, ACancelledCopyLeavesNothing) {
    std::shared_ptr<Execution> execution;
    execution = std::make_shared<Execution>([&](const Progress& progress) {
        if (progress.stage.id == "convert.state") {
            execution->cancel();
        }
    });
    EXPECT_THROW(openFeCached(m_path, {}, {}, *execution, m_cache), Cancelled);
    EXPECT_TRUE(copyPath().empty());
    EXPECT_EQ(filesOf(".part"), 0u);
}

TEST_F(FeCache, ListsWhatItHoldsAndClearsNothingElse) {
    open();
    fs::create_directories(m_cache + "/worlds");
    fs::create_directories(m_cache + "/points/abc");
    fs::create_directories(m_cache + "/photographs");
    std::ofstream(m_cache + "/worlds/1.world") << "1234567";
    std::ofstream(m_cache + "/points/abc/2.json") << "123";
    std::ofstream(m_cache + "/photographs/3.jpg") << "a face";
    const std::vector<CacheEntry> entries = cacheEntries(m_cache);
    ASSERT_EQ(entries.size(), 3u);
    EXPECT_EQ(entries[0].kind, "fe");
    EXPECT_EQ(entries[0].of, fs::absolute(m_path).string());
    EXPECT_EQ(entries[0].bytes, fs::file_size(copyPath()));
    EXPECT_EQ(entries[1].kind, "worlds");
    EXPECT_EQ(entries[1].bytes, 7u);
    EXPECT_EQ(entries[2].kind, "points");
    EXPECT_EQ(entries[2].files, 1u);
    const std::vector<CacheEntry> removed = clearCache(m_cache, {"fe"});
    ASSERT_EQ(removed.size(), 1u);
    EXPECT_EQ(cacheEntries(m_cache).size(), 2u);
    EXPECT_EQ(clearCache(m_cache, {}).size(), 2u);
    EXPECT_TRUE(cacheEntries(m_cache).empty());
    EXPECT_TRUE(fs::exists(m_cache + "/photographs/3.jpg"));
    EXPECT_TRUE(clearCache(m_cache + "/none", {}).empty());
}

}  // namespace
}  // namespace rubble::io
