#include "io/fe/fe_copy/copy_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/base/native_lock.h"
#include "io/exports/convert/fe_conversion.h"
#include "io/fe/fe_reader.h"
#include "tests/io/exports/convert/mixed_result.h"
#include "tests/io/fe/fe_copy/chunk_damage.h"
#include "tests/support/run_tests.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

using testing::HasSubstr;

std::string bytesOfFile(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void putBytes(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary | std::ios::trunc).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

class FeCopyFile : public testing::Test {
protected:
    FeCopyFile() { convertFe(*m_fe, {}, m_path, false, Execution{}); }

    std::string errorOfOpening() const {
        try {
            openFe(m_path, {}, {}, Execution{});
        } catch (const Error& error) {
            EXPECT_FALSE(error.remedy().empty());
            return englishText(error.message());
        }
        ADD_FAILURE() << "no error";
        return {};
    }

    TemporaryFolder m_folder;
    MixedResult m_fe;
    const std::string m_path = m_folder / "copy.h5";
};

TEST_F(FeCopyFile, KeepsEveryBit) {
    const auto back = openFe(m_path, {}, {}, Execution{});
    EXPECT_EQ(back->contents().format, "Rubble copy");
    expectSameResult(*m_fe, *back);
    EXPECT_EQ(back->contents().activityFrom, m_fe->contents().activityFrom);
    ASSERT_EQ(back->contents().findings.list().size(), 1u);
    const Finding& finding = back->contents().findings.list().front();
    EXPECT_EQ(englishText(finding.what), "Found 3 of 0.5 m");
    EXPECT_EQ(finding.count, 4);
    EXPECT_EQ(finding.example, "an example");
    EXPECT_EQ(openFeCopy(m_path).about.sha256, "0123");
}

TEST_F(FeCopyFile, IsKnownByItsContent) {
    std::filesystem::rename(m_path, m_folder / "anything.exo");
    EXPECT_EQ(openFe(m_folder / "anything.exo", {}, {}, Execution{})->contents().format, "Rubble copy");
}

TEST_F(FeCopyFile, AStateIsReadWithoutTheOthers) {
    damageChunk(m_path, "/positions/000001");
    damageChunk(m_path, "/velocities/000003");
    const auto back = openFe(m_path, {}, {}, Execution{});
    for (const std::size_t k : {4u, 0u, 2u}) {
        EXPECT_EQ(back->state(k)->positions, m_fe->state(k)->positions);
    }
    EXPECT_THROW(back->state(1), ParseError);
    EXPECT_THROW(back->state(3), ParseError);
}

TEST_F(FeCopyFile, DamagedTablesAreRefused) {
    for (const char* table : {"/mesh/corners", "/activity", "/times", "/digests", "/about", "/seal"}) {
        const std::string whole = bytesOfFile(m_path);
        damageChunk(m_path, table);
        EXPECT_THAT(errorOfOpening(), HasSubstr("copy.h5")) << table;
        putBytes(m_path, whole);
    }
    EXPECT_EQ(openFe(m_path, {}, {}, Execution{})->stateCount(), 5u);
}

// By its reader alone, since what openFe() does besides takes most of the time.
TEST_F(FeCopyFile, CutOffAtEveryByteItIsRefused) {
    for (std::size_t size = std::filesystem::file_size(m_path); size-- > 0;) {
        std::filesystem::resize_file(m_path, size);
        try {
            readFeCopy(m_path, {}, Execution{});
            FAIL() << "read at byte " << size;
        } catch (const Error& error) {
            ASSERT_THAT(error.what(), HasSubstr("copy.h5")) << size;
            ASSERT_FALSE(error.remedy().empty()) << size;
        }
    }
    EXPECT_THAT(errorOfOpening(), HasSubstr("is empty"));
}

// Whatever byte is wrong: an error of ours, or a result that is right.
TEST_F(FeCopyFile, AWrongByteGivesAnErrorOrTheRightResult) {
    const std::string whole = bytesOfFile(m_path);
    std::size_t refused = 0;
    const auto bytesTried = sizedTo<std::size_t>(50, 150, 150);
    for (std::size_t at = 0; at < whole.size(); at += whole.size() / bytesTried + 1) {
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ 0x5a);
        putBytes(m_path, bytes);
        try {
            const auto back = openFe(m_path, {}, {}, Execution{});
            for (std::size_t k = 0; k < back->stateCount(); ++k) {
                ASSERT_EQ(back->state(k)->positions, m_fe->state(k)->positions) << "byte " << at;
            }
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, bytesTried / 3) << "most bytes are of tables or states";
}

TEST_F(FeCopyFile, ANewerVersionIsRefused) {
    {
        const std::scoped_lock lock(nativeLibraries());
        const hid_t file = H5Fopen(m_path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
        const hid_t attribute = H5Aopen(file, "version", H5P_DEFAULT);
        const int version = 2;
        H5Awrite(attribute, H5T_NATIVE_INT, &version);
        H5Aclose(attribute);
        H5Fclose(file);
    }
    EXPECT_THAT(errorOfOpening(), HasSubstr("version 2"));
}

TEST_F(FeCopyFile, SettingsAndFrameOfACaseAreHeeded) {
    ImportSettings settings;
    settings.statusVariable = "EROSION";
    Frame frame;
    frame.origin << 10, 20, 0;
    frame.metresPerUnit = 0.5;
    const auto back = openFe(m_path, settings, frame, Execution{});
    EXPECT_EQ(back->contents().findings.count("fe_copy.settled"), 1);
    const Vec3 expected = 0.5 * m_fe->state(1)->positions[7] - Vec3(10, 20, 0);
    EXPECT_LE((back->state(1)->positions[7] - expected).norm(), 1e-14);
    EXPECT_LE((back->state(1)->velocities[7] - 0.5 * m_fe->state(1)->velocities[7]).norm(), 1e-15);
    EXPECT_EQ(back->mesh().section[1], 0.5 * 0.02);
    EXPECT_EQ(back->mesh().section[3], 0.25 * 0.0004);
}

}  // namespace
}  // namespace rubble::io
