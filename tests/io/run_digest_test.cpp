#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/run/run_file.h"
#include "io/run/run_layout.h"
#include "tests/io/sample_run.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

// Flips one bit of one byte of a dataset, through the library, so that all its own checksums agree again.
void flipBit(const std::string& path, RunDataset dataset, std::mt19937& engine) {
    const Hdf5Session session;
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    const Hdf5Handle set(H5Dopen2(file.get(), layoutOf(dataset).path, H5P_DEFAULT), H5Dclose);
    const Hdf5Handle space(H5Dget_space(set.get()), H5Sclose);
    const Hdf5Handle type = memoryTypeOf(dataset);
    const auto numbers = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
    std::vector<unsigned char> bytes(numbers * H5Tget_size(type.get()));
    ASSERT_FALSE(bytes.empty()) << layoutOf(dataset).path;
    ASSERT_GE(H5Dread(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), 0);
    bytes[engine() % bytes.size()] ^= static_cast<unsigned char>(1u << engine() % 8);
    ASSERT_GE(H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), 0);
}

TEST(RunDigest, FindsAndNamesAChangeInAnyDataset) {
    const TemporaryFolder folder;
    const SampleRun run = makeSampleRun(21, 60, 12);
    run.feed(*createRun(folder / "good.run.h5", run.origin));
    ASSERT_NO_THROW(checkRunDigest(folder / "good.run.h5", Execution()));
    std::mt19937 engine(1);
    for (const RunDataset dataset : runDatasets()) {
        for (int i = 0; i < 8; ++i) {
            const std::string path = folder / (std::to_string(static_cast<int>(dataset)) + "-" + std::to_string(i));
            std::filesystem::copy_file(folder / "good.run.h5", path);
            flipBit(path, dataset, engine);
            try {
                checkRunDigest(path, Execution());
                ADD_FAILURE() << "not found in " << layoutOf(dataset).path;
            } catch (const ParseError& error) {
                // A changed digest names the dataset that it no longer fits.
                EXPECT_THAT(error.what(), testing::HasSubstr(dataset == RunDataset::Digests ? path : layoutOf(dataset).path));
                EXPECT_FALSE(error.remedy().empty());
            }
        }
    }
}

TEST(RunDigest, StopsWhenCancelled) {
    const TemporaryFolder folder;
    const SampleRun run = makeSampleRun(22, 5, 3);
    run.feed(*createRun(folder / "a.run.h5", run.origin));
    const Execution cancelled;
    cancelled.cancel();
    EXPECT_THROW(checkRunDigest(folder / "a.run.h5", cancelled), Cancelled);
}

// Reads all there is; what it throws is its own affair as long as it is an error of ours.
bool readsWhole(const std::string& path) {
    try {
        const auto reader = openRun(path);
        for (std::size_t i = 0; i < reader->frameCount(); ++i) {
            reader->frame(i);
        }
        reader->bodies();
        reader->carriers();
        reader->ledger();
        reader->fragments();
        reader->clustering();
        reader->result();
        checkRunDigest(path, Execution());
        return true;
    } catch (const Error&) {
        return false;
    }
}

TEST(DamagedRun, TruncatedAnywhereIsAnErrorAndNoCrash) {
    const TemporaryFolder folder;
    const SampleRun run = makeSampleRun(23, 60, 12);
    const std::string path = folder / "a.run.h5";
    run.feed(*createRun(path, run.origin));
    const std::string content = wholeFile(path);
    ASSERT_TRUE(readsWhole(path));
    std::mt19937 engine(2);
    for (int i = 0; i < 60; ++i) {
        const std::size_t length = i < 10 ? static_cast<std::size_t>(i) * 7 : engine() % content.size();
        writeContent(folder / "cut", content.substr(0, length));
        EXPECT_FALSE(readsWhole(folder / "cut")) << length;
    }
}

TEST(DamagedRun, FlippedBytesAreFoundOrLieInUnusedSpace) {
    const TemporaryFolder folder;
    const SampleRun run = makeSampleRun(24, 60, 12);
    const std::string path = folder / "a.run.h5";
    run.feed(*createRun(path, run.origin));
    const std::string content = wholeFile(path);
    std::mt19937 engine(3);
    int found = 0;
    for (int i = 0; i < 150; ++i) {
        std::string damaged = content;
        damaged[engine() % damaged.size()] ^= static_cast<char>(1u << engine() % 8);
        writeContent(folder / "flipped", damaged);
        found += !readsWhole(folder / "flipped");
    }
    // Random numbers hardly compress, so that most of the file is content.
    EXPECT_GT(found, 75);
}

// A report printed the digest of a file that changed once more when its case was left.
TEST(RunDigest, KeepsItsDigestOnceAReaderHasOpenedItAnewBehindItsWriter) {
    const TemporaryFolder folder;
    const std::string path = folder / "shown.run.h5";
    const SampleRun run = makeSampleRun(3, 300, 40);
    auto sink = createRun(path, run.origin);
    auto reader = openRun(path);
    sink->begin(run.description);
    sink->addBodies(run.bodies, run.carriers);
    for (const TrajectoryFrame& frame : run.frames) {
        sink->commit(frame);
    }
    sink->finish(run.result);
    sink.reset();
    reader->reopen();
    reader->refresh();
    const std::string digest = sha256OfFile(path);
    EXPECT_EQ(reader->frameCount(), run.frames.size());
    reader.reset();
    EXPECT_EQ(sha256OfFile(path), digest);
}

}  // namespace
}  // namespace rubble::io
