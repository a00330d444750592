#pragma once

#include <string>

namespace rubble::cli {

/// A place for a run file that nobody asked to keep: an own folder among the system's temporary files, removed with all in it.
class TemporaryRun {
public:
    /// Throws WorldError if no folder can be made.
    TemporaryRun();
    ~TemporaryRun();
    TemporaryRun(const TemporaryRun&) = delete;
    TemporaryRun& operator=(const TemporaryRun&) = delete;

    std::string path() const { return m_folder + "/temporary.run.h5"; }

private:
    std::string m_folder;
};

}  // namespace rubble::cli
