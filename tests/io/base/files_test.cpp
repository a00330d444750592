#include "io/base/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>

#include "core/base/error.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

std::string saidOf(const std::string& path, int error = 0) {
    try {
        failToRead(path, error);
    } catch (const WorldError& failure) {
        EXPECT_EQ(failure.message().id, "io.file.unreadable");
        EXPECT_FALSE(failure.remedy().pattern.empty());
        return failure.what();
    }
}

TEST(FailToRead, FindsTheReasonThatStreamsDoNotSay) {
    const TemporaryFolder folder;
    EXPECT_THAT(saidOf(folder / "none.vtu"), testing::HasSubstr("none.vtu: No such file or directory"));
    EXPECT_THAT(saidOf(folder.path()), testing::HasSubstr("Is a directory"));
    EXPECT_THAT(saidOf(folder / "none.vtu", ENOSPC), testing::HasSubstr("No space left on device")) << "one that is known";
}

}  // namespace
}  // namespace rubble::io
