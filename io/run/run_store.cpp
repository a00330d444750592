#include "io/run/run_store.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/base/hdf5_rows.h"
#include "io/base/run_driver.h"

namespace rubble::io {

namespace {

GrowingRows rowsOf(const RunDatasetLayout& layout) {
    return {layout.width > 1 ? layout.width : 0, layout.chunkRows, layout.rowBytes};
}

bool writeText(hid_t object, const char* name, const std::string& text) {
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), text.size() + 1);
    H5Tset_cset(type.get(), H5T_CSET_UTF8);
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle attribute(H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    return attribute.valid() && H5Awrite(attribute.get(), type.get(), text.c_str()) >= 0;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
        text += (text.empty() ? "" : " ") + name;
    }
    return text;
}

}  // namespace

RunStore::RunStore(const std::string& path, std::string_view originText) : m_path(path) {
    const std::string temporary = unfinishedName(path);
    try {
        create(temporary, originText);
        if (std::rename(temporary.c_str(), path.c_str()) != 0) {
            fail(systemReason(errno));
        }
    } catch (...) {
        for (Open& open : m_open) {
            open.dataset.reset();
        }
        m_file.reset();
        ::unlink(temporary.c_str());
        throw;
    }
}

RunStore::~RunStore() {
    const Hdf5Session session;
    for (Open& open : m_open) {
        open.dataset.reset();
    }
    m_file.reset();
}

void RunStore::fail(const std::string& reason) const {
    throw WorldError(
        Message{"io.run.unwritable", "Cannot write the run file {0}: {1}", {m_path, reason}},
        Message{"io.run.unwritable.remedy",
                "Free space on that disk or choose another place for the run file, then run again; the frames written so "
                "far can be read.",
                {}});
}

void RunStore::require(bool good) const {
    if (const int error = runDriverError(m_file.get())) {
        fail(systemReason(error));
    }
    if (!good) {
        fail(hdf5Reason());
    }
}

void RunStore::create(const std::string& temporary, std::string_view originText) {
    const Hdf5Session session;
    const Hdf5Handle access = runFileAccess();
    m_file = Hdf5Handle(H5Fcreate(temporary.c_str(), H5F_ACC_EXCL, H5P_DEFAULT, access.get()), H5Fclose);
    if (!m_file.valid()) {
        fail(systemReason(runDriverOpenError()));
    }
    {
        const Hdf5Handle root(H5Gopen2(m_file.get(), "/", H5P_DEFAULT), H5Gclose);
        require(writeText(root.get(), "format", runFormatName) && writeText(root.get(), "version", std::to_string(runVersion)));
    }
    makeDatasets();
    openDatasets();
    appendOpen(RunDataset::Origin, originText.data(), originText.size());
    // The library wants nothing open when readers are let in.
    for (Open& open : m_open) {
        require(open.dataset.reset());
    }
    require(H5Fflush(m_file.get(), H5F_SCOPE_GLOBAL) >= 0);
    require(H5Fstart_swmr_write(m_file.get()) >= 0);
    openDatasets();
}

void RunStore::makeDatasets() {
    for (const RunDataset dataset : runDatasets()) {
        const RunDatasetLayout& layout = layoutOf(dataset);
        const Hdf5Handle type = fileTypeOf(dataset);
        const Hdf5Handle made = rowsOf(layout).make(m_file.get(), layout.path, type.get());
        require(made.valid());
        require(layout.columns.empty() || writeText(made.get(), "columns", joined(layout.columns)));
    }
}

void RunStore::openDatasets() {
    for (const RunDataset dataset : runDatasets()) {
        const RunDatasetLayout& layout = layoutOf(dataset);
        Open& open = m_open[static_cast<std::size_t>(dataset)];
        open.dataset = rowsOf(layout).open(m_file.get(), layout.path);
        require(open.dataset.valid());
        open.memoryType = memoryTypeOf(dataset);
        if (growsWithFrames(dataset)) {
            open.packed.emplace(rowsOf(layout), layout.rowBytes / layout.width);
        }
    }
}

void RunStore::append(RunDataset dataset, const void* rows, std::size_t count) {
    const Hdf5Session session;
    appendOpen(dataset, rows, count);
}

void RunStore::appendOpen(RunDataset dataset, const void* rows, std::size_t count) {
    if (count == 0) {
        return;
    }
    const RunDatasetLayout& layout = layoutOf(dataset);
    Open& open = m_open[static_cast<std::size_t>(dataset)];
    const auto failure = open.packed ? open.packed->append(open.dataset.get(), open.memoryType.get(), open.rows, rows, count)
                                     : rowsOf(layout).append(open.dataset.get(), open.memoryType.get(), open.rows, rows, count);
    require(true);
    if (failure) {
        fail(*failure);
    }
    open.rows += count;
    open.hasher.bytes(rows, count * layout.rowBytes);
}

void RunStore::flush(RunDataset dataset) {
    const Hdf5Session session;
    require(H5Dflush(m_open[static_cast<std::size_t>(dataset)].dataset.get()) >= 0);
}

void RunStore::flushAll() {
    const Hdf5Session session;
    require(H5Fflush(m_file.get(), H5F_SCOPE_GLOBAL) >= 0);
}

void RunStore::close() {
    const Hdf5Session session;
    for (Open& open : m_open) {
        require(open.dataset.reset());
    }
    // What closing writes is only bookkeeping: all rows were flushed before.
    require(true);
    if (!m_file.reset()) {
        fail("the file cannot be closed");
    }
}

DatasetDigest RunStore::digestOf(RunDataset dataset) const {
    const Open& open = m_open[static_cast<std::size_t>(dataset)];
    return {dataset, open.rows, open.hasher.finish()};
}

std::string RunStore::digestsText() const {
    std::vector<DatasetDigest> datasets;
    for (const RunDataset dataset : runDatasets()) {
        if (dataset != RunDataset::Digests) {
            datasets.push_back(digestOf(dataset));
        }
    }
    return io::digestsText(datasets);
}

std::uint64_t frameChecksum(const TrajectoryFrame& frame) {
    Hasher hasher;
    hasher.value(frame.time);
    hasher.bytes(frame.positions.data(), frame.positions.size() * sizeof(Eigen::Vector3f));
    hasher.bytes(frame.orientations.data(), frame.orientations.size() * sizeof(Eigen::Quaternionf));
    hasher.values(std::span(frame.speeds)).values(std::span(frame.states));
    const Digest digest = hasher.finish();
    std::uint64_t checksum = 0;
    std::memcpy(&checksum, digest.bytes.data(), sizeof checksum);
    return checksum;
}

std::string digestsText(std::span<const DatasetDigest> datasets) {
    nlohmann::json list = nlohmann::json::object();
    Hasher whole;
    for (const DatasetDigest& entry : datasets) {
        list[layoutOf(entry.dataset).path] = {{"rows", entry.rows}, {"hash", entry.hash.hex()}};
        whole.text(layoutOf(entry.dataset).path).value(entry.rows).digest(entry.hash);
    }
    return nlohmann::json{{"datasets", std::move(list)}, {"hash", whole.finish().hex()}}.dump(1);
}

}  // namespace rubble::io
