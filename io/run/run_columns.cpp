#include "io/run/run_columns.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/base/error.h"
#include "io/base/run_driver.h"

namespace rubble::io {

namespace {

// How often a checksum that does not agree is looked at again, since a writer may be at work. The library doubles its pause from
// 1 ns each time, so that these add up to 17 ms; its own choice of 100 would never end on a damaged file.
constexpr unsigned readAttempts = 24;

// Whether a file has a dataset that older ones lack; its group may be missing as well.
bool holds(hid_t file, const std::string& path) {
    const std::size_t group = path.rfind('/');
    return (group == 0 || H5Lexists(file, path.substr(0, group).c_str(), H5P_DEFAULT) > 0) &&
           H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
}

const Message damagedRemedy{"io.run.damaged.remedy", "Run the case again, or take a good copy of the run file.", {}};

// A text attribute of the root group; empty if there is none.
std::string rootText(hid_t file, const char* name) {
    if (H5Aexists(file, name) <= 0) {
        return {};
    }
    const Hdf5Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(attribute.valid() ? H5Aget_type(attribute.get()) : H5I_INVALID_HID, H5Tclose);
    if (!type.valid() || H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0) {
        return {};
    }
    std::string text(H5Tget_size(type.get()) + 1, '\0');
    const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose);
    if (text.size() > 256 || H5Sget_simple_extent_npoints(space.get()) != 1 ||
        H5Aread(attribute.get(), type.get(), text.data()) < 0) {
        return {};
    }
    return text.c_str();
}

}  // namespace

RunColumns::RunColumns(const std::string& path) : m_path(path) {
    const Hdf5Session session;
    openFile();
    checkFormat();
    openDatasets();
}

void RunColumns::reopen() {
    const Hdf5Session session;
    // A file is closed once nothing of it is open.
    for (auto* handles : {&m_datasets, &m_types}) {
        for (Hdf5Handle& handle : *handles) {
            handle = Hdf5Handle();
        }
    }
    m_file = Hdf5Handle();
    openFile();
    openDatasets();
}

void RunColumns::openFile() {
    std::error_code ignored;
    if (::access(m_path.c_str(), R_OK) != 0 || !std::filesystem::is_regular_file(m_path, ignored)) {
        const char* reason = errno ? strerrordesc_np(errno) : nullptr;
        throw WorldError(
            Message{"io.run.unreadable", "Cannot read the run file {0}: {1}", {m_path, reason ? reason : "not a file"}},
            Message{"io.file.unreadable.remedy", "Check that the file exists and that you may read it.", {}});
    }
    const Hdf5Handle access = runFileAccess();
    H5Pset_metadata_read_attempts(access.get(), readAttempts);
    // Opening as a reader beside a writer also opens what a killed writer left.
    m_file = Hdf5Handle(H5Fopen(m_path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.get()), H5Fclose);
    if (!m_file.valid()) {
        throw ParseError(Message{"io.run.not_hdf5", "{0} is not a run file of Rubble, or is damaged: {1}", {m_path, hdf5Reason()}},
                         damagedRemedy);
    }
}

void RunColumns::checkFormat() const {
    if (rootText(m_file.get(), "format") != runFormatName) {
        throw ParseError(
            Message{"io.run.not_a_run", "{0} is an HDF5 file, but not a run of Rubble", {m_path}},
            Message{"io.run.not_a_run.remedy", "Open a *.run.h5 file that the window saved, or rubble-cli run --out.", {}});
    }
    const std::string version = rootText(m_file.get(), "version");
    if (version != std::to_string(runVersion)) {
        throw ParseError(
            Message{"io.run.version", "{0} is a run of version {1}; this program reads version {2}", {m_path, version, runVersion}},
            Message{"io.run.version.remedy", "Open it with the Rubble that wrote it, or run the case again.", {}});
    }
}

void RunColumns::openDatasets() {
    for (const RunDataset dataset : runDatasets()) {
        const auto i = static_cast<std::size_t>(dataset);
        const RunDatasetLayout& layout = layoutOf(dataset);
        if (mayBeMissing(dataset) && !holds(m_file.get(), layout.path)) {
            continue;
        }
        m_datasets[i] = Hdf5Handle(H5Dopen2(m_file.get(), layout.path, H5P_DEFAULT), H5Dclose);
        if (!m_datasets[i].valid()) {
            failContent(dataset, "it cannot be opened (" + hdf5Reason() + ")");
        }
        m_types[i] = memoryTypeOf(dataset);
        const Hdf5Handle space(H5Dget_space(m_datasets[i].get()), H5Sclose);
        const Hdf5Handle type(H5Dget_type(m_datasets[i].get()), H5Tclose);
        const Hdf5Handle expected = fileTypeOf(dataset);
        std::array<hsize_t, 2> extent{0, 1};
        const int rank = layout.width > 1 ? 2 : 1;
        if (H5Sget_simple_extent_ndims(space.get()) != rank || H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr) < 0 ||
            extent[1] != layout.width || H5Tequal(type.get(), expected.get()) <= 0) {
            failContent(dataset, "it does not have the columns of this version");
        }
    }
}

void RunColumns::failContent(RunDataset dataset, const std::string& reason) const {
    throw ParseError(Message{"io.run.content", "{0}: dataset {1}: {2}", {m_path, layoutOf(dataset).path, reason}}, damagedRemedy);
}

void RunColumns::refresh(RunDataset dataset) {
    if (!has(dataset)) {
        return;
    }
    const Hdf5Session session;
    if (H5Drefresh(m_datasets[static_cast<std::size_t>(dataset)].get()) < 0) {
        failContent(dataset, "it cannot be read anew (" + hdf5Reason() + ")");
    }
}

std::uint64_t RunColumns::rows(RunDataset dataset) const {
    if (!has(dataset)) {
        return 0;
    }
    const Hdf5Session session;
    const Hdf5Handle space(H5Dget_space(m_datasets[static_cast<std::size_t>(dataset)].get()), H5Sclose);
    std::array<hsize_t, 2> extent{0, 1};
    if (H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr) < 0) {
        failContent(dataset, "its size cannot be read");
    }
    return extent[0];
}

void RunColumns::read(RunDataset dataset, std::uint64_t from, std::uint64_t count, void* out) const {
    if (count == 0) {
        return;
    }
    const Hdf5Session session;
    const auto i = static_cast<std::size_t>(dataset);
    const RunDatasetLayout& layout = layoutOf(dataset);
    const std::array<hsize_t, 2> start{from, 0};
    const std::array<hsize_t, 2> size{count, layout.width};
    const Hdf5Handle fileSpace(H5Dget_space(m_datasets[i].get()), H5Sclose);
    const Hdf5Handle memorySpace(H5Screate_simple(layout.width > 1 ? 2 : 1, size.data(), nullptr), H5Sclose);
    if (H5Sselect_hyperslab(fileSpace.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) < 0 ||
        H5Dread(m_datasets[i].get(), m_types[i].get(), memorySpace.get(), fileSpace.get(), H5P_DEFAULT, out) < 0) {
        failContent(dataset, "rows " + std::to_string(from) + " to " + std::to_string(from + count) + " cannot be read (" +
                                 hdf5Reason() + ")");
    }
}

std::string RunColumns::text(RunDataset dataset) const {
    std::string content(rows(dataset), '\0');
    read(dataset, 0, content.size(), content.data());
    return content;
}

}  // namespace rubble::io
