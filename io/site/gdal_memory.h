#pragma once

#include <string>

namespace rubble::io {

/// A file that GDAL writes into memory, so that what reaches the disk is whole or not there: its drivers write in place and tell
/// of a full disk late or not at all. Removed with this object.
class GdalMemoryFile {
public:
    /// @param suffix  with its point; drivers look at it
    explicit GdalMemoryFile(const std::string& suffix);
    ~GdalMemoryFile();
    GdalMemoryFile(const GdalMemoryFile&) = delete;
    GdalMemoryFile& operator=(const GdalMemoryFile&) = delete;

    const std::string& name() const { return m_name; }
    /// Writes its bytes to a path, atomically. Throws WorldError.
    void save(const std::string& path) const;

private:
    std::string m_name;
};

/// Throws WorldError: a library could not make a file, with its reason.
[[noreturn]] void failGdal(const std::string& path);

}  // namespace rubble::io
