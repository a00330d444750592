#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/run/run_layout.h"
#include "io/run/run_tables.h"

namespace rubble::io {

/// The HDF5 file behind a run that is being read, complete or growing. Not thread-safe by itself; holds the lock of the native
/// libraries during each call. Throws WorldError if the file cannot be read, ParseError naming the dataset if its content cannot.
class RunColumns {
public:
    explicit RunColumns(const std::string& path);

    const std::string& path() const { return m_path; }
    /// False for what may be missing in files of older versions, and is; such a dataset reads as empty.
    bool has(RunDataset dataset) const { return m_datasets[static_cast<std::size_t>(dataset)].valid(); }
    /// Closes the file and opens it anew.
    void reopen();
    /// Looks for rows that were written since, by whatever process.
    void refresh(RunDataset dataset);
    std::uint64_t rows(RunDataset dataset) const;
    /// Rows [from, from + count) in the memory type of the dataset.
    void read(RunDataset dataset, std::uint64_t from, std::uint64_t count, void* out) const;
    /// All rows as one text.
    std::string text(RunDataset dataset) const;

    /// Rows from `from` on as a flat list; T is the type of one number, or a packed vector of them.
    template <class T>
    std::vector<T> list(RunDataset dataset, std::uint64_t from = 0) const {
        const std::uint64_t count = rows(dataset) > from ? rows(dataset) - from : 0;
        std::vector<T> values(count * layoutOf(dataset).rowBytes / sizeof(T));
        read(dataset, from, count, values.data());
        return values;
    }
    template <class T>
    std::vector<T> table(RunDataset dataset, std::uint64_t from = 0) const {
        return unpackRows<T>(list<double>(dataset, from));
    }

    /// Says that a dataset holds what it should not.
    [[noreturn]] void failContent(RunDataset dataset, const std::string& reason) const;

private:
    void openFile();
    void openDatasets();
    void checkFormat() const;

    std::string m_path;
    Hdf5Handle m_file;
    std::array<Hdf5Handle, runDatasetCount> m_datasets;
    std::array<Hdf5Handle, runDatasetCount> m_types;
};

}  // namespace rubble::io
