#include "io/base/hdf5_rows.h"

#include <algorithm>
#include <array>

namespace rubble::io {

Hdf5Handle GrowingRows::make(hid_t file, const char* path, hid_t type) const {
    const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(links.get(), 1);
    const std::array<hsize_t, 2> none{0, width};
    const std::array<hsize_t, 2> most{H5S_UNLIMITED, width};
    const std::array<hsize_t, 2> chunk{chunkRows, width};
    const Hdf5Handle space(H5Screate_simple(rank(), none.data(), most.data()), H5Sclose);
    const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_chunk(creation.get(), rank(), chunk.data());
    H5Pset_shuffle(creation.get());
    H5Pset_deflate(creation.get(), 1);
    H5Pset_obj_track_times(creation.get(), false);
    return {H5Dcreate2(file, path, type, space.get(), links.get(), creation.get(), H5P_DEFAULT), H5Dclose};
}

Hdf5Handle GrowingRows::open(hid_t file, const char* path) const {
    const Hdf5Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
    // Room for two chunks; full ones leave first, the one being filled stays.
    H5Pset_chunk_cache(access.get(), 101, std::max<std::size_t>(2 * chunkRows * rowBytes, std::size_t{1} << 16), 1.0);
    return {H5Dopen2(file, path, access.get()), H5Dclose};
}

std::optional<std::string> GrowingRows::append(hid_t dataset, hid_t type, hsize_t before, const void* rows, hsize_t count) const {
    if (count == 0) {
        return std::nullopt;
    }
    const std::array<hsize_t, 2> extent{before + count, width};
    const std::array<hsize_t, 2> start{before, 0};
    const std::array<hsize_t, 2> size{count, width};
    if (H5Dset_extent(dataset, extent.data()) < 0) {
        return hdf5Reason();
    }
    const Hdf5Handle fileSpace(H5Dget_space(dataset), H5Sclose);
    const Hdf5Handle memorySpace(H5Screate_simple(rank(), size.data(), nullptr), H5Sclose);
    const bool written = H5Sselect_hyperslab(fileSpace.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) >= 0 &&
                         H5Dwrite(dataset, type, memorySpace.get(), fileSpace.get(), H5P_DEFAULT, rows) >= 0;
    return written ? std::nullopt : std::optional(hdf5Reason());
}

}  // namespace rubble::io
