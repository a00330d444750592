#include "tests/io/fe/fe_copy/chunk_damage.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <fstream>
#include <mutex>

#include "io/base/native_lock.h"

namespace rubble::io {

void damageChunk(const std::string& path, const char* dataset) {
    const std::scoped_lock lock(nativeLibraries());
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t set = H5Dopen2(file, dataset, H5P_DEFAULT);
    haddr_t address = HADDR_UNDEF;
    hsize_t size = 0;
    unsigned mask = 0;
    const hid_t space = H5Dget_space(set);
    const herr_t found = H5Dget_chunk_info(set, space, 0, nullptr, &mask, &address, &size);
    H5Sclose(space);
    H5Dclose(set);
    H5Fclose(file);
    ASSERT_GE(found, 0) << dataset;
    ASSERT_NE(address, HADDR_UNDEF);
    std::fstream stream(path, std::ios::binary | std::ios::in | std::ios::out);
    stream.seekg(static_cast<std::streamoff>(address + size / 2));
    const int byte = stream.get();
    stream.seekp(static_cast<std::streamoff>(address + size / 2));
    stream.put(static_cast<char>(byte ^ 0xff));
}

}  // namespace rubble::io
