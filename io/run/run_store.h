#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/hash.h"
#include "core/trajectory/trajectory.h"
#include "io/base/packed_rows.h"
#include "io/run/run_layout.h"

namespace rubble::io {

/// Row count and hash of one dataset.
struct DatasetDigest {
    RunDataset dataset{};
    std::uint64_t rows = 0;
    Digest hash;
};

/// The HDF5 file behind a run that is being written: creates every dataset, then appends rows. Not thread-safe by itself; holds the
/// lock of the native libraries during each call. All members throw WorldError naming the file and the remedy.
class RunStore {
public:
    /// Makes the file under a temporary name, puts the origin in, opens it to readers and moves it to its place, so that what lay
    /// there before is lost only once the new file stands.
    RunStore(const std::string& path, std::string_view originText);
    ~RunStore();
    RunStore(const RunStore&) = delete;
    RunStore& operator=(const RunStore&) = delete;

    /// @param rows  in the memory type of the dataset, whole rows
    void append(RunDataset dataset, const void* rows, std::size_t count);
    void appendText(RunDataset dataset, std::string_view text) { append(dataset, text.data(), text.size()); }
    /// Row count and hash of a dataset as it is.
    DatasetDigest digestOf(RunDataset dataset) const;
    /// Hands one dataset's rows to the operating system, so that other processes and a crash find them.
    void flush(RunDataset dataset);
    void flushAll();
    /// Row count and hash of every dataset but the digests themselves, as text of the digests dataset.
    std::string digestsText() const;
    /// Closes the file in an orderly way.
    void close();

private:
    struct Open {
        Hdf5Handle dataset;
        Hdf5Handle memoryType;
        std::optional<PackedRows> packed;  ///< of the datasets that grow with every frame
        std::uint64_t rows = 0;
        Hasher hasher;
    };

    void create(const std::string& temporary, std::string_view originText);
    void makeDatasets();
    void openDatasets();
    void appendOpen(RunDataset dataset, const void* rows, std::size_t count);
    [[noreturn]] void fail(const std::string& reason) const;
    void require(bool good) const;

    std::string m_path;
    Hdf5Handle m_file;
    std::array<Open, runDatasetCount> m_open;
};

/// Checksum of a frame, as its index row keeps it.
std::uint64_t frameChecksum(const TrajectoryFrame& frame);

/// Text of the digests dataset from those of the others, in the order of runDatasets(); ends with a hash of the list itself.
std::string digestsText(std::span<const DatasetDigest> datasets);

}  // namespace rubble::io
