#include "io/fe/exodus/exodus_chunks.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include "core/base/error.h"
#include "io/base/hdf5_handle.h"

namespace rubble::io {

namespace {

// HDF5 1.10 goes through all chunks before the one that is asked for.
constexpr std::size_t mostStates = 2000;

bool isHdf5(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return file.get() == 0x89;
}

/// The filters of a dataset if they are deflate, or shuffle and deflate: whether it is shuffled. Nothing: others.
std::optional<bool> shuffledBy(hid_t creation) {
    std::vector<H5Z_filter_t> filters;
    for (int i = 0; i < H5Pget_nfilters(creation); ++i) {
        unsigned flags = 0;
        std::size_t values = 0;
        filters.push_back(H5Pget_filter2(creation, static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, nullptr));
    }
    const bool plain = filters == std::vector<H5Z_filter_t>{H5Z_FILTER_DEFLATE};
    const bool shuffled = filters == std::vector<H5Z_filter_t>{H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE};
    return plain || shuffled ? std::optional(shuffled) : std::nullopt;
}

/// The file that the library holds open; opened anew it must be closed the same way.
Hdf5Handle openBeside(const std::string& path) {
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    for (const H5F_close_degree_t degree : {H5F_CLOSE_SEMI, H5F_CLOSE_STRONG, H5F_CLOSE_WEAK}) {
        H5Pset_fclose_degree(access.get(), degree);
        Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
        if (file.valid()) {
            return file;
        }
    }
    return {};
}

}  // namespace

ExodusChunks::ExodusChunks(std::string path, std::size_t states) : m_path(std::move(path)), m_states(states) {
    try {
        if (states <= mostStates && isHdf5(m_path)) {
            m_file.emplace(m_path);
        }
    } catch (const WorldError&) {
        // The library says what is wrong with it.
    }
}

ExodusChunks::~ExodusChunks() = default;

ExodusChunks::Dataset ExodusChunks::look(const std::string& name, std::size_t values) const {
    const Hdf5Session session;
    const Hdf5Handle file = openBeside(m_path);
    const Hdf5Handle set(file.valid() ? H5Dopen2(file.get(), name.c_str(), H5P_DEFAULT) : H5I_INVALID_HID, H5Dclose);
    if (!set.valid()) {
        return {};
    }
    const Hdf5Handle creation(H5Dget_create_plist(set.get()), H5Pclose);
    const Hdf5Handle space(H5Dget_space(set.get()), H5Sclose);
    const Hdf5Handle type(H5Dget_type(set.get()), H5Tclose);
    std::array<hsize_t, 2> extent{}, chunk{};
    const bool rows = H5Sget_simple_extent_ndims(space.get()) == 2 &&
                      H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr) == 2 && extent[1] == values &&
                      H5Pget_layout(creation.get()) == H5D_CHUNKED && H5Pget_chunk(creation.get(), 2, chunk.data()) == 2 &&
                      chunk == std::array<hsize_t, 2>{1, extent[1]};
    const bool numbers = H5Tequal(type.get(), H5T_IEEE_F32LE) > 0 || H5Tequal(type.get(), H5T_IEEE_F64LE) > 0;
    const std::optional<bool> shuffled = shuffledBy(creation.get());
    if (!rows || !numbers || !shuffled) {
        return {};
    }
    Dataset found{*shuffled, std::vector<ChunkPlace>(m_states)};
    for (std::size_t k = 0; k < std::min<std::size_t>(m_states, extent[0]); ++k) {
        const std::array<hsize_t, 2> begin{k, 0};
        unsigned mask = 0;
        haddr_t address = HADDR_UNDEF;
        hsize_t bytes = 0;
        // What never was written has no chunk, and no bytes then.
        if (H5Dget_chunk_info_by_coord(set.get(), begin.data(), &mask, &address, &bytes) >= 0 && address != HADDR_UNDEF &&
            mask == 0) {
            found.places[k] = {static_cast<std::int64_t>(address), static_cast<std::int64_t>(bytes), 0};
        }
    }
    return found;
}

std::shared_ptr<const ExodusChunks::Dataset> ExodusChunks::find(const std::string& name, std::size_t values) const {
    const std::lock_guard lock(m_mutex);
    std::shared_ptr<const Dataset>& known = m_datasets[name];
    if (!known) {
        known = std::make_shared<const Dataset>(look(name, values));
    }
    return known;
}

bool ExodusChunks::read(const std::string& dataset, std::size_t written, std::span<double> values) const {
    if (!m_file) {
        return false;
    }
    const std::shared_ptr<const Dataset> found = find(dataset, values.size());
    return written < found->places.size() && m_file->read(found->places[written], values, found->shuffled);
}

}  // namespace rubble::io
