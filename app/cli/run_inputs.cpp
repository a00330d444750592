#include "app/cli/run_inputs.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/base/error.h"
#include "io/fe_reader.h"
#include "io/files.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

bool hasDigest(const fs::path& path, const std::string& sha256) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
        return false;
    }
    try {
        return io::sha256OfFile(path.string()) == sha256;
    } catch (const WorldError&) {
        // A file that cannot be read is not the one looked for.
        return false;
    }
}

/// Files beside the run that may be its FE file: the same ending first keeps the search short.
std::vector<fs::path> candidatesBeside(const std::string& runPath, const fs::path& original) {
    std::vector<fs::path> candidates;
    std::error_code ignored;
    for (fs::directory_iterator it(fs::absolute(runPath).parent_path(), ignored), end; it != end; it.increment(ignored)) {
        if (it->path().extension() == original.extension()) {
            candidates.push_back(it->path());
        }
    }
    std::sort(candidates.begin(), candidates.end());
    std::stable_partition(candidates.begin(), candidates.end(),
                          [&](const fs::path& path) { return path.filename() == original.filename(); });
    return candidates;
}

}  // namespace

std::string findFeOfRun(const std::string& runPath, const io::RunOrigin& origin, const std::optional<std::string>& given) {
    if (given) {
        const std::string found = io::sha256OfFile(*given);
        if (found != origin.feSha256) {
            throw WorldError({"cli.fe_differs",
                              "{0} is not the FE file of {1}: its SHA-256 is {2}, the run was made from {3}.",
                              {*given, runPath, found, origin.feSha256}},
                             {"cli.fe_differs.remedy", "Give the file with that SHA-256, or simulate again.", {}});
        }
        return *given;
    }
    if (hasDigest(origin.fePath, origin.feSha256)) {
        return origin.fePath;
    }
    for (const fs::path& candidate : candidatesBeside(runPath, origin.fePath)) {
        if (hasDigest(candidate, origin.feSha256)) {
            return candidate.string();
        }
    }
    throw WorldError({"cli.fe_missing",
                      "The FE file of {0} was not found: neither {1} nor a file beside the run has the SHA-256 {2}.",
                      {runPath, origin.fePath, origin.feSha256}},
                     {"cli.fe_missing.remedy", "Put the file beside the run, or name it with --fe FILE.", {}});
}

std::shared_ptr<const FeResult> openFeOfRun(const std::string& runPath, const io::RunOrigin& origin,
                                            const std::optional<std::string>& given, Session& session) {
    return io::openFe(findFeOfRun(runPath, origin, given), origin.scenario.import, origin.frame, session.execution());
}

}  // namespace rubble::cli
