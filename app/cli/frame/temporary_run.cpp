#include "app/cli/frame/temporary_run.h"

#include <cstdlib>
#include <filesystem>

#include "core/base/error.h"

namespace rubble::cli {

namespace fs = std::filesystem;

TemporaryRun::TemporaryRun() {
    std::error_code failed;
    const fs::path parent = fs::temp_directory_path(failed);
    m_folder = (parent / "rubble-XXXXXX").string();
    if (failed || mkdtemp(m_folder.data()) == nullptr) {
        throw WorldError({"cli.no_temporary", "No folder for temporary files could be made in {0}.", {parent.string()}},
                         {"cli.no_temporary.remedy", "Set TMPDIR to a folder with room, or keep the run with --out.", {}});
    }
}

std::shared_ptr<io::RunReader> TemporaryRun::open() const {
    std::shared_ptr<io::RunReader> run = io::openRun(path());
    run->setKept(false);
    return run;
}

TemporaryRun::~TemporaryRun() {
    std::error_code ignored;
    fs::remove_all(m_folder, ignored);
}

}  // namespace rubble::cli
