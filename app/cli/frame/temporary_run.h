#pragma once

#include <memory>
#include <string>

#include "io/run/run_file.h"

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
    /// Opens what was written: no export names its path, which goes. Throws what openRun() throws.
    std::shared_ptr<io::RunReader> open() const;

private:
    std::string m_folder;
};

}  // namespace rubble::cli
