#include "io/base/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>

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

/// Takes from the owner of this machine, as whom tests may run, the right to read every file.
class AsNobody {
public:
    AsNobody() {
        if (m_was == 0 && ::seteuid(nobody) != 0) {
            ADD_FAILURE() << "cannot become nobody";
        }
    }
    ~AsNobody() {
        if (m_was == 0 && ::seteuid(m_was) != 0) {
            std::abort();
        }
    }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;

private:
    static constexpr uid_t nobody = 65534;
    const uid_t m_was = ::geteuid();
};

// A file that may not be read is not an empty one: what reads it would complain of its content.
TEST(ContentOf, AFileThatMayNotBeReadHasNone) {
    const TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
    const std::string path = folder / "key.pem";
    std::ofstream(path) << "secret";
    EXPECT_EQ(contentOf(path), "secret");
    std::filesystem::permissions(path, std::filesystem::perms::none);
    const AsNobody nobody;
    EXPECT_EQ(contentOf(path), std::nullopt);
}

TEST(FailToRead, FindsTheReasonThatStreamsDoNotSay) {
    const TemporaryFolder folder;
    EXPECT_THAT(saidOf(folder / "none.vtu"), testing::HasSubstr("none.vtu: No such file or directory"));
    EXPECT_THAT(saidOf(folder.path()), testing::HasSubstr("Is a directory"));
    EXPECT_THAT(saidOf(folder / "none.vtu", ENOSPC), testing::HasSubstr("No space left on device")) << "one that is known";
}

}  // namespace
}  // namespace rubble::io
