#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/d3plot/d3plot_builder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {

namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Reads everything there is; any error of ours will do.
std::optional<std::size_t> statesOf(const std::string& path) {
    try {
        const auto fe = openFe(path, {}, {}, Execution{});
        for (std::size_t k = 0; k < fe->stateCount(); ++k) {
            fe->state(k);
        }
        return fe->stateCount();
    } catch (const Error& error) {
        EXPECT_FALSE(error.message().empty());
        EXPECT_FALSE(error.remedy().empty()) << error.what();
        EXPECT_THAT(error.what(), HasSubstr("d3plot"));
        return std::nullopt;
    }
}

D3plotBuilder small(std::int64_t bytes) {
    D3plotBuilder builder;
    builder.format = {bytes, bytes == 8};
    builder.cubes = 1;
    builder.shells = 1;
    builder.beams = 1;
    builder.thickShells = 1;
    builder.particles = 1;
    builder.times = {0, 1};
    builder.statesInRoot = 2;
    return builder;
}

TEST(D3plotDamage, EveryTruncationOfAFileWithItsStates) {
    const TemporaryFolder folder;
    for (const std::int64_t bytes : {4, 8}) {
        const D3plotBuilder builder = small(bytes);
        const std::string whole = builder.files().front();
        const std::size_t state = builder.stateWords() * static_cast<std::size_t>(bytes);
        const std::size_t end = whole.size();
        writeContent(folder / "d3plot", whole);
        ASSERT_EQ(statesOf(folder / "d3plot"), 2u);
        std::size_t before = 0;
        std::map<std::size_t, std::size_t> opened;
        for (std::size_t size = 1; size < end; ++size) {
            writeContent(folder / "d3plot", whole.substr(0, size));
            const std::size_t states = statesOf(folder / "d3plot").value_or(0);
            EXPECT_GE(states, before) << "more bytes never show less";
            before = states;
            ++opened[states];
        }
        // One complete state opens over the length of the next one, byte by byte.
        EXPECT_EQ(opened[1], state);
        EXPECT_EQ(before, 2u);
    }
}

TEST(D3plotDamage, EveryTruncationOfTheRootOfAFamily) {
    const TemporaryFolder folder;
    D3plotBuilder builder = small(4);
    builder.statesInRoot = 0;
    builder.write(folder / "d3plot");
    const std::string root = builder.files().front();
    for (std::size_t size = 0; size < root.size(); ++size) {
        writeContent(folder / "d3plot", root.substr(0, size));
        statesOf(folder / "d3plot");
    }
    writeContent(folder / "d3plot", root);
    EXPECT_EQ(statesOf(folder / "d3plot"), 2u);
}

TEST(D3plotDamage, FlippedBitsNeverCrash) {
    const TemporaryFolder folder;
    std::mt19937 random(11);
    int errors = 0;
    for (const std::int64_t bytes : {4, 8}) {
        const std::string whole = small(bytes).files().front();
        const std::size_t used = whole.size() / 2;
        for (int i = 0; i < 1500; ++i) {
            std::string damaged = whole;
            // The header is short and matters most.
            const std::size_t where = random() % (i % 2 == 0 ? 64 * static_cast<std::size_t>(bytes) : used);
            damaged[where] = static_cast<char>(damaged[where] ^ (1 << (random() % 8)));
            writeContent(folder / "d3plot", damaged);
            errors += !statesOf(folder / "d3plot");
        }
    }
    EXPECT_GT(errors, 300) << "the flips met nothing that matters";
}

// Every word of the header with values that overflow sums and products, or ask for all the memory there is.
TEST(D3plotDamage, HugeCountsAreRefusedBeforeMemoryIsTaken) {
    const TemporaryFolder folder;
    rusage before{};
    ::getrusage(RUSAGE_SELF, &before);
    for (const std::int64_t bytes : {4, 8}) {
        for (std::size_t word = 10; word < 64; ++word) {
            for (const std::int64_t value :
                 {std::int64_t{2147483647}, std::int64_t{-2147483648}, std::int64_t{1} << 29, std::int64_t{-1},
                  std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min(), std::int64_t{1} << 61}) {
                D3plotBuilder builder = small(bytes);
                builder.words[word] = bytes == 4 ? static_cast<std::int32_t>(value) : value;
                builder.write(folder / "d3plot");
                statesOf(folder / "d3plot");
            }
        }
    }
    rusage after{};
    ::getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 200 * 1024) << "kB: the files have 20 kB";
    D3plotBuilder builder = small(4);
    builder.words[16] = 2147483647;
    builder.write(folder / "d3plot");
    try {
        openFe(folder / "d3plot", {}, {}, Execution{});
        FAIL();
    } catch (const ParseError& error) {
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("number of nodes"), HasSubstr("2,147,483,647"), HasSubstr("byte 64"), HasSubstr("expected")));
    }
}

TEST(D3plotDamage, EmptyMembersAndPaddingOnly) {
    const TemporaryFolder folder;
    D3plotBuilder builder;
    builder.statesPerFile = 1;
    builder.write(folder / "d3plot");
    writeContent(folder / "d3plot03", "");
    EXPECT_EQ(statesOf(folder / "d3plot"), 2u);
    writeContent(folder / "d3plot02", std::string(2048, '\0'));
    writeContent(folder / "d3plot03", builder.files()[3]);
    EXPECT_EQ(statesOf(folder / "d3plot"), 2u) << "a file of zeros holds no state";
    writeContent(folder / "d3plot01", "");
    writeContent(folder / "d3plot02", "");
    writeContent(folder / "d3plot03", "");
    try {
        openFe(folder / "d3plot", {}, {}, Execution{});
        FAIL();
    } catch (const ParseError& error) {
        EXPECT_THAT(error.what(), HasSubstr("no complete state"));
    }
    writeContent(folder / "d3plot", std::string(8192, '\0'));
    EXPECT_EQ(statesOf(folder / "d3plot"), std::nullopt);
}

// In the middle a state is lost; at the end it may still come.
TEST(D3plotDamage, EmptyMembersAreNamed) {
    const TemporaryFolder folder;
    D3plotBuilder builder;
    builder.statesPerFile = 1;
    builder.write(folder / "d3plot");
    const auto placesOf = [&](const std::string& id) {
        const auto fe = openFe(folder / "d3plot", {}, {}, Execution{});
        std::vector<std::string> places;
        for (const Finding& finding : fe->contents().findings.list()) {
            if (finding.what.id == id) {
                places.push_back(finding.example);
            }
        }
        return places;
    };
    EXPECT_THAT(placesOf("fe.unfinished"), IsEmpty());
    EXPECT_THAT(placesOf("d3plot.cut_state"), IsEmpty());
    writeContent(folder / "d3plot02", "");
    EXPECT_EQ(openFe(folder / "d3plot", {}, {}, Execution{})->times(), (std::vector<double>{0.0, 2.0}));
    EXPECT_THAT(placesOf("fe.unfinished"), IsEmpty());
    EXPECT_THAT(placesOf("d3plot.cut_state"), ElementsAre(HasSubstr("d3plot02: 0 of ")));
    writeContent(folder / "d3plot02", builder.files()[2]);
    writeContent(folder / "d3plot03", "");
    EXPECT_EQ(openFe(folder / "d3plot", {}, {}, Execution{})->times(), (std::vector<double>{0.0, 1.0}));
    EXPECT_THAT(placesOf("fe.unfinished"), ElementsAre("d3plot03"));
    EXPECT_THAT(placesOf("d3plot.cut_state"), IsEmpty());
}

TEST(D3plotDamage, NumbersThatAreNoneWhereTheyMatter) {
    const TemporaryFolder folder;
    D3plotBuilder builder;
    builder.deaths = {{1, 1}};
    std::vector<std::string> files = builder.files();
    const std::size_t place = (1 + 6 + 7 * D3plotBuilder::parts) * 4;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto withNan = [&](std::size_t node) {
        std::string damaged = files[1];
        damaged.replace(builder.stateWords() * 4 + place + 12 * node, 4, reinterpret_cast<const char*>(&nan), 4);
        return damaged;
    };
    builder.write(folder / "d3plot");
    writeContent(folder / "d3plot01", withNan(8));  // a node of the dead cube
    EXPECT_EQ(statesOf(folder / "d3plot"), 3u);
    writeContent(folder / "d3plot01", withNan(1));
    EXPECT_EQ(statesOf(folder / "d3plot"), std::nullopt);
}

}  // namespace

}  // namespace rubble::io
