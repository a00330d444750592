#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/fe/fe_copy/state_chunks.h"

namespace rubble::io {

/// Reads values at a state from an Exodus file in HDF5 past the library, which looks through all variables before each of its reads
/// and unpacks under one lock. What does not lie as most writers lay it (a chunk a state, shuffled or not, deflated, little-endian)
/// is left to the library, and so is all that is damaged. Reading is from any thread.
class ExodusChunks {
public:
    /// @param states  in the file, whole or not
    ExodusChunks(std::string path, std::size_t states);
    ~ExodusChunks();
    ExodusChunks(const ExodusChunks&) = delete;
    ExodusChunks& operator=(const ExodusChunks&) = delete;

    /// False: the library is to read it; what stands in `values` is then of no use.
    /// @param dataset  "vals_nod_var1"
    /// @param written  place of the state in the file, 0-based
    bool read(const std::string& dataset, std::size_t written, std::span<double> values) const;

private:
    struct Dataset {
        bool shuffled = false;
        std::vector<ChunkPlace> places;  ///< by state; empty: for the library
    };
    std::shared_ptr<const Dataset> find(const std::string& name, std::size_t values) const;
    Dataset look(const std::string& name, std::size_t values) const;

    const std::string m_path;
    const std::size_t m_states;
    std::optional<StateChunks> m_file;  ///< unset: for the library
    mutable std::mutex m_mutex;
    mutable std::map<std::string, std::shared_ptr<const Dataset>> m_datasets;
};

}  // namespace rubble::io
