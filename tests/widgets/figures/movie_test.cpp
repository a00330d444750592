#include "widgets/figures/movie.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "tests/support/temporary_folder.h"

namespace rubble::figures {
namespace {

namespace fs = std::filesystem;

TEST(MovieLength, CountsPicturesAtPaceAndRate) {
    EXPECT_EQ(movieLength({0.0, 10.0, 25.0, 1.0}), 251u);
    EXPECT_EQ(movieLength({2.0, 4.0, 25.0, 0.5}), 101u) << "half as fast is twice as long";
    EXPECT_DOUBLE_EQ(movieTime({2.0, 4.0, 25.0, 0.5}, 1), 2.02);
    EXPECT_DOUBLE_EQ(movieTime({0.0, 9.99, 25.0, 1.0}, 250), 9.99);
    for (const MovieSettings& wrong : {MovieSettings{1.0, 1.0, 25.0, 1.0}, MovieSettings{0.0, 1.0, 0.0, 1.0},
                                       MovieSettings{0.0, 1.0, 25.0, 0.0}, MovieSettings{0.0, 1e6, 120.0, 0.01}}) {
        EXPECT_THROW(movieLength(wrong), UsageError);
    }
}

QImage grey(int shade) {
    QImage picture(64, 48, QImage::Format_RGB32);
    picture.fill(QColor(shade, shade, shade));
    return picture;
}

std::vector<std::string> namesIn(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

class MovieFile : public testing::Test {
protected:
    void SetUp() override {
        ensureGuiApplication();
        m_path = std::getenv("PATH");
    }
    void TearDown() override { ::setenv("PATH", m_path.c_str(), 1); }
    /// The only program of the name ffmpeg from here on.
    void install(const std::string& script) {
        const std::string program = m_folder / "bin/ffmpeg";
        fs::create_directories(m_folder / "bin");
        std::ofstream(program) << "#!/bin/sh\ncase \"$*\" in *-encoders*) echo libx264; exit 0;; esac\n" << script;
        ::chmod(program.c_str(), 0755);
        ::setenv("PATH", (m_folder / "bin" + ":/usr/bin:/bin").c_str(), 1);
    }

    /// What is said of a movie of 200 pictures that this program should write: error and remedy, nothing if it was written.
    std::string complaintAbout(const std::string& script) {
        install(script);
        try {
            const auto target = mp4Movie(m_movie, {64, 48}, 25.0, {});
            for (int i = 0; i < 200; ++i) {
                target->add(grey(i));
            }
            target->finish();
        } catch (const WorldError& error) {
            return englishText(error.message()) + ' ' + englishText(error.remedy());
        }
        return {};
    }

    io::TemporaryFolder m_folder;
    std::string m_path;
    const std::string m_movie = m_folder / "a.mp4";
};

TEST_F(MovieFile, PicturesAreNumberedAndEarlierMoviesStay) {
    const std::string folder = m_folder / "frames";
    for (const int count : {3, 2, 1}) {
        const auto target = pictureSequence(folder, R"({"rubble_provenance":1})");
        EXPECT_EQ(target->path(), count == 3 ? folder : folder + (count == 2 ? "-2" : "-3"));
        for (int i = 0; i < count; ++i) {
            target->add(grey(50 * i + count));
        }
        target->finish();
    }
    EXPECT_THAT(namesIn(folder), testing::ElementsAre("frame-00001.png", "frame-00002.png", "frame-00003.png"));
    EXPECT_THAT(namesIn(folder + "-2"), testing::ElementsAre("frame-00001.png", "frame-00002.png"));
    EXPECT_THAT(namesIn(folder + "-3"), testing::ElementsAre("frame-00001.png"));
    EXPECT_EQ(QImage(QString::fromStdString(folder + "/frame-00001.png")).pixelColor(3, 3), QColor(3, 3, 3));
    const QImage second(QString::fromStdString(folder + "-2/frame-00002.png"));
    EXPECT_EQ(second.pixelColor(3, 3), QColor(52, 52, 52));
    EXPECT_EQ(second.text("Rubble-Provenance"), R"({"rubble_provenance":1})");
}

TEST_F(MovieFile, WhatIsNotItsOwnIsNeverRemoved) {
    const std::string folder = m_folder / "frames";
    {
        const auto first = pictureSequence(folder, {});
        first->add(grey(1));
        first->finish();
    }
    {
        const auto cancelled = pictureSequence(folder, {});
        cancelled->add(grey(2));
    }
    EXPECT_THAT(namesIn(m_folder.path()), testing::ElementsAre("frames"));
    EXPECT_THAT(namesIn(folder), testing::ElementsAre("frame-00001.png"));
    {
        // Another movie is written into the same place meanwhile.
        const auto target = pictureSequence(m_folder / "shared", {});
        target->add(grey(1));
        std::ofstream(m_folder / "shared/frame-00002.png") << "of somebody else";
        EXPECT_THROW(target->add(grey(2)), WorldError);
    }
    EXPECT_THAT(namesIn(m_folder / "shared"), testing::ElementsAre("frame-00002.png"));
    EXPECT_EQ(fs::file_size(m_folder / "shared/frame-00002.png"), 16u);
    std::ofstream(m_folder / "file") << "x";
    EXPECT_THROW(pictureSequence(m_folder / "file", {}), WorldError);
}

TEST_F(MovieFile, AnUnfinishedSequenceLeavesNothingAndAForeignFolderIsRefused) {
    {
        const auto target = pictureSequence(m_folder / "frames", {});
        target->add(grey(10));
    }
    EXPECT_FALSE(fs::exists(m_folder / "frames"));
    fs::create_directories(m_folder / "mine");
    std::ofstream(m_folder / "mine/thesis.txt") << "x";
    EXPECT_THROW(pictureSequence(m_folder / "mine", {}), WorldError);
    EXPECT_TRUE(fs::exists(m_folder / "mine/thesis.txt"));
}

TEST_F(MovieFile, EveryPixelReachesTheEncoder) {
    // A box around everything that comes in, and an empty index behind it.
    install(
        "for last; do :; done\nprintf '\\000\\000\\140\\010mdat' > \"$last\"\ncat >> \"$last\"\n"
        "printf '\\000\\000\\000\\010moov' >> \"$last\"\n");
    const auto target = mp4Movie(m_movie, {64, 48}, 25.0, "{}");
    target->add(grey(7));
    target->add(grey(9));
    EXPECT_FALSE(fs::exists(m_movie)) << "it has its name only when it is whole";
    target->finish();
    EXPECT_EQ(fs::file_size(m_movie), 8u + 2u * 64u * 48u * 4u + 8u);
    EXPECT_THAT(namesIn(m_folder.path()), testing::ElementsAre("a.mp4", "bin"));
}

TEST_F(MovieFile, WithoutFfmpegTheRemedyIsNamed) {
    ::setenv("PATH", (m_folder / "nothing").c_str(), 1);
    EXPECT_FALSE(ffmpegInstalled());
    try {
        mp4Movie(m_movie, {64, 48}, 25.0, {});
        FAIL();
    } catch (const WorldError& error) {
        EXPECT_THAT(englishText(error.remedy()), testing::HasSubstr("Install the package ffmpeg"));
    }
}

TEST_F(MovieFile, TheDeathOfFfmpegIsToldInItsWordsAndLeavesNothing) {
    EXPECT_THAT(complaintAbout("head -c 100 > /dev/null\necho 'No space left on device' >&2\nexit 1\n"),
                testing::AllOf(testing::HasSubstr("No space left on device"), testing::HasSubstr(m_movie)));
    EXPECT_THAT(namesIn(m_folder.path()), testing::ElementsAre("bin"));
}

TEST_F(MovieFile, AKilledFfmpegIsToldAndLeavesNothing) {
    EXPECT_THAT(complaintAbout("for last; do :; done\nhead -c 30000 > \"$last\"\nkill -9 $$\n"),
                testing::AllOf(testing::HasSubstr("killed"), testing::HasSubstr(m_movie), testing::HasSubstr("Make room")));
    EXPECT_THAT(namesIn(m_folder.path()), testing::ElementsAre("bin"));
}

TEST_F(MovieFile, NonsenseThatFfmpegSaysIsCutToItsLastWords) {
    // A megabyte of bytes that are no text, before and while pictures come in, then the reason.
    const std::string said = complaintAbout(
        "head -c 1000000 /dev/zero | tr '\\000' '\\377' >&2\nhead -c 100000 > /dev/null\nhead -c 500000 /dev/urandom >&2\n"
        "printf '\\n\\033[31mmuxer: no room\\033[0m\\n' >&2\nexit 1\n");
    EXPECT_THAT(said, testing::HasSubstr("muxer: no room"));
    EXPECT_LT(said.size(), 2000u);
    EXPECT_TRUE(std::none_of(said.begin(), said.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; })) << said;
    EXPECT_THAT(namesIn(m_folder.path()), testing::ElementsAre("bin"));
}

TEST_F(MovieFile, AMovieWithoutItsEndIsNone) {
    // As of an encoder whose last write found no room and who ends as if all were well.
    install("for last; do :; done\nprintf '\\000\\000\\377\\377mdat' > \"$last\"\ncat >> \"$last\"\n");
    {
        const auto target = mp4Movie(m_movie, {64, 48}, 25.0, {});
        target->add(grey(1));
        EXPECT_THROW(target->finish(), WorldError);
    }
    EXPECT_THAT(namesIn(m_folder.path()), testing::ElementsAre("bin"));
}

TEST_F(MovieFile, AFullDiskIsTold) {
    // Files end here as on a full disk.
    rlimit whole{};
    ::getrlimit(RLIMIT_FSIZE, &whole);
    const auto old = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit less{20000, whole.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &less);
    const std::string said = complaintAbout("for last; do :; done\nexec cat > \"$last\"\n");
    ::setrlimit(RLIMIT_FSIZE, &whole);
    std::signal(SIGXFSZ, old);
    EXPECT_THAT(said, testing::AllOf(testing::HasSubstr(m_movie), testing::HasSubstr("File too large")));
    EXPECT_THAT(namesIn(m_folder.path()), testing::ElementsAre("bin"));
}

TEST_F(MovieFile, AnEncoderThatFailsAtTheEndLeavesTheOldMovie) {
    std::ofstream(m_movie) << "old";
    install("cat > /dev/null\nexit 3\n");
    {
        const auto target = mp4Movie(m_movie, {64, 48}, 25.0, {});
        target->add(grey(1));
        EXPECT_THROW(target->finish(), WorldError);
    }
    EXPECT_EQ(fs::file_size(m_movie), 3u);
}

}  // namespace
}  // namespace rubble::figures
