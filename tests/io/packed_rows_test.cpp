#include "io/base/packed_rows.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "io/base/hdf5_handle.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

constexpr std::size_t chunkRows = 50;

/// Appends rows in blocks of several sizes and reads them back after each.
template <class Number>
void expectRowsBack(hid_t type, hsize_t width, const std::vector<Number>& numbers) {
    const TemporaryFolder folder;
    const Hdf5Session session;
    const Hdf5Handle file(H5Fcreate((folder / "rows.h5").c_str(), H5F_ACC_EXCL, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    const GrowingRows growing{width > 1 ? width : 0, chunkRows, width * sizeof(Number)};
    ASSERT_TRUE(growing.make(file.get(), "/rows", type).valid());
    const Hdf5Handle dataset = growing.open(file.get(), "/rows");
    PackedRows packed(growing, sizeof(Number));
    std::size_t rows = 0;
    for (const std::size_t count : {7u, 43u, 50u, 1u, 260u, 0u, 30u}) {
        ASSERT_EQ(packed.append(dataset.get(), type, rows, numbers.data() + rows * width, count), std::nullopt);
        rows += count;
        std::vector<Number> back(rows * width);
        ASSERT_GE(H5Dread(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, back.data()), 0);
        ASSERT_EQ(back, std::vector<Number>(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(back.size()))) << rows;
    }
}

TEST(PackedRows, AreReadBackWhereverAChunkBegins) {
    std::vector<float> slow(3 * 391);
    for (std::size_t i = 0; i < slow.size(); ++i) {
        slow[i] = 0.01f * static_cast<float>(i / 3);
    }
    expectRowsBack(H5T_IEEE_F32LE, 3, slow);
}

TEST(PackedRows, MayBeWhatDoesNotGetSmaller) {
    std::mt19937 random(5);
    std::vector<std::uint8_t> noise(391);
    for (std::uint8_t& byte : noise) {
        byte = static_cast<std::uint8_t>(random());
    }
    expectRowsBack(H5T_STD_U8LE, 1, noise);
}

}  // namespace
}  // namespace rubble::io
