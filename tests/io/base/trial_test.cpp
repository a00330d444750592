#include "io/base/trial.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

TEST(Trial, SoundWorkLeavesNothingBehind) {
    int touched = 0;
    EXPECT_TRUE(survivesTrial([&] { touched = 1; }));
    EXPECT_EQ(touched, 0);
}

TEST(Trial, ACrashStaysInTheChild) {
    EXPECT_FALSE(survivesTrial([] { ::raise(SIGSEGV); }));
    EXPECT_FALSE(survivesTrial([] { ::_exit(0); }));
}

TEST(Trial, ErrorsComeBackAsTheyAre) {
    try {
        survivesTrial([] { throw ParseError({"some.id", "{0} is not {1}", {"this", 3.5}}, {"some.remedy", "Do that.", {}}); });
        FAIL();
    } catch (const ParseError& error) {
        EXPECT_EQ(error.message().id, "some.id");
        EXPECT_EQ(std::string(error.what()).substr(0, 15), "this is not 3.5");
        EXPECT_EQ(error.remedy().id, "some.remedy");
    }
    EXPECT_THROW(survivesTrial([] { throw WorldError({"some.id", "", {}}, {}); }), WorldError);
}

// As after a lock that another thread held when the process was copied.
TEST(Trial, AChildThatStandsStillSaysNothingOfTheFile) {
    const pid_t here = ::getpid();
    int done = 0;
    EXPECT_TRUE(survivesTrial(
        [&] {
            if (::getpid() != here) {
                ::pause();
            }
            ++done;
        },
        std::chrono::seconds(1)));
    EXPECT_EQ(done, 1);
}

TEST(Trial, AFileIsTriedOnceAsLongAsItStaysAsItIs) {
    const TemporaryFolder folder;
    const std::string path = folder / "tried.txt";
    std::ofstream(path) << "one";
    TriedFiles<int> tried;
    int trials = 0;
    const auto ask = [&] { return tried.of(path, [&] { return ++trials; }); };
    EXPECT_EQ(ask(), 1);
    EXPECT_EQ(ask(), 2) << "what was written just now may be written again within one step of the clock";
    const auto earlier = std::filesystem::last_write_time(path) - std::chrono::minutes(1);
    std::filesystem::last_write_time(path, earlier);
    EXPECT_EQ(ask(), 3);
    EXPECT_EQ(ask(), 3);
    std::ofstream(path) << "three";
    EXPECT_EQ(ask(), 4);
    std::filesystem::last_write_time(path, earlier);
    EXPECT_EQ(ask(), 5) << "another size";
    TriedFiles<bool> sound;
    const auto fails = [&] { return sound.of(path, [] { return false; }); };
    EXPECT_FALSE(fails());
    EXPECT_TRUE(sound.of(path, [] { return true; })) << "a failure may pass";
    EXPECT_TRUE(fails());
    EXPECT_EQ(tried.of(folder / "absent.txt", [&] { return 7; }), 7);
    EXPECT_THROW(tried.of(path + ".other", []() -> int { throw WorldError({"some.id", "", {}}, {}); }), WorldError);
}

}  // namespace
}  // namespace rubble::io
