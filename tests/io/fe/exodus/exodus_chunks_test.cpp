#include "io/fe/exodus/exodus_chunks.h"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "io/fe/exodus/exodus_file.h"
#include "io/fe/exodus/library_lock.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// What the library reads.
std::vector<double> byLibrary(const std::string& path, const std::string& name, std::size_t state, std::size_t count) {
    const LibraryLock lock;
    std::vector<double> values(count);
    int file = -1, variable = -1;
    EXPECT_EQ(nc_open(path.c_str(), NC_NOWRITE, &file), NC_NOERR);
    EXPECT_EQ(nc_inq_varid(file, name.c_str(), &variable), NC_NOERR);
    const std::array<std::size_t, 2> begin{state, 0}, length{1, count};
    EXPECT_EQ(nc_get_vara_double(file, variable, begin.data(), length.data(), values.data()), NC_NOERR);
    nc_close(file);
    return values;
}

class ExodusChunksTest : public ::testing::Test {
protected:
    const std::string m_path = sourcePath("resources/samples/stone-arch.exo");
    const ExodusFile m_file{m_path};  // holds it open, as a result does
    const ExodusChunks m_chunks{m_path, m_file.times().size()};
};

TEST_F(ExodusChunksTest, ReadsWhatTheLibraryReads) {
    for (const std::size_t state : {std::size_t{0}, m_file.times().size() / 2, m_file.times().size() - 1}) {
        std::vector<double> nodal(m_file.nodeCount());
        ASSERT_TRUE(m_chunks.read("vals_nod_var1", state, nodal)) << "the sample lies as most writers lay it";
        EXPECT_EQ(nodal, byLibrary(m_path, "vals_nod_var1", state, nodal.size())) << state;
        std::vector<double> flags(static_cast<std::size_t>(m_file.blocks().front().elements));
        ASSERT_TRUE(m_chunks.read("vals_elem_var1eb1", state, flags));
        EXPECT_EQ(flags, byLibrary(m_path, "vals_elem_var1eb1", state, flags.size())) << state;
    }
}

TEST_F(ExodusChunksTest, LeavesToTheLibraryWhatIsNotThere) {
    std::vector<double> nodal(m_file.nodeCount());
    EXPECT_FALSE(m_chunks.read("vals_nod_var99", 0, nodal));
    EXPECT_FALSE(m_chunks.read("vals_nod_var1", m_file.times().size(), nodal));
    std::vector<double> fewer(m_file.nodeCount() - 1);
    EXPECT_FALSE(m_chunks.read("vals_nod_var2", 0, fewer)) << "another length";
}

TEST_F(ExodusChunksTest, LeavesToTheLibraryWhatIsDamaged) {
    const TemporaryFolder folder;
    const std::string damaged = folder / "damaged.exo";
    std::filesystem::copy_file(m_path, damaged);
    std::filesystem::resize_file(damaged, std::filesystem::file_size(damaged) / 2);
    const ExodusChunks chunks(damaged, m_file.times().size());
    std::vector<double> nodal(m_file.nodeCount());
    EXPECT_FALSE(chunks.read("vals_nod_var1", m_file.times().size() - 1, nodal));
}

TEST_F(ExodusChunksTest, LeavesFilesOfOtherKindsToTheLibrary) {
    const TemporaryFolder folder;
    std::ofstream(folder / "classic.exo") << "CDF";
    const ExodusChunks chunks(folder / "classic.exo", 1);
    std::vector<double> nodal(8);
    EXPECT_FALSE(chunks.read("vals_nod_var1", 0, nodal));
}

}  // namespace
}  // namespace rubble::io
