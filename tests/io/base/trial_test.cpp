#include "io/base/trial.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "core/base/error.h"

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

}  // namespace
}  // namespace rubble::io
