#pragma once

#include <string>
#include <vector>

namespace rubble::io {

/// One file of a series over time.
struct PvdEntry {
    double time = 0.0;  ///< s
    int part = 0;
    std::string name;  ///< of the part; empty: none
    std::string file;  ///< as seen from the index
};

/// Writes the index of a series as ParaView reads it, times shortest and exact. Throws WorldError; what stood there stays then.
void writePvdIndex(const std::string& path, const std::vector<PvdEntry>& entries);

}  // namespace rubble::io
