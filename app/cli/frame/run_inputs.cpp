#include "app/cli/frame/run_inputs.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "io/seal/run_repeat.h"
#include "io/site/input_files.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

/// A file that a run was made from, and the words to speak of it.
struct RecordedFile {
    std::string_view kind;  ///< "FE", "terrain"
    InputRole role = InputRole::Fe;
    std::string_view option;  ///< that names its place; empty: none does
    std::string path;         ///< then
    std::string sha256;
    std::optional<std::string> given;
};

bool hasDigest(const RecordedFile& file, const std::string& path, const Execution& execution) {
    try {
        return io::digestOfInput(path, file.role, execution).is(file.sha256);
    } catch (const WorldError&) {
        // A file that cannot be read is not the one looked for.
        return false;
    }
}

// A series is looked at once, by its first file.
bool opensSeries(const RecordedFile& file, const std::string& path) {
    try {
        return file.role != InputRole::Fe || io::feFiles(path).front() == path;
    } catch (const WorldError&) {
        return false;
    }
}

/// Files beside the run that may be the one looked for: the same ending first keeps the search short.
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

std::string find(const std::string& runPath, const RecordedFile& file, const Execution& execution) {
    if (file.given) {
        const io::InputDigest found = io::digestOfInput(*file.given, file.role, execution);
        if (!found.is(file.sha256)) {
            throw WorldError({"cli.fe_differs",
                              "{0} is not the {1} file of {2}: its SHA-256 is {3}, the run was made from {4}.",
                              {*file.given, file.kind, runPath, found.sha256, file.sha256}},
                             {"cli.fe_differs.remedy", "Give the file with that SHA-256, or simulate again.", {}});
        }
        return *file.given;
    }
    if (hasDigest(file, file.path, execution)) {
        return file.path;
    }
    for (const fs::path& candidate : candidatesBeside(runPath, file.path)) {
        if (opensSeries(file, candidate.string()) && hasDigest(file, candidate.string(), execution)) {
            return candidate.string();
        }
    }
    throw WorldError(
        {"cli.fe_missing",
         "The {0} file of {1} was not found: neither {2} nor a file beside the run has the SHA-256 {3}.",
         {file.kind, runPath, file.path, file.sha256}},
        file.option.empty()
            ? Message{"cli.fe_missing.beside", "Put the file beside the run.", {}}
            : Message{"cli.fe_missing.remedy", "Put the file beside the run, or name it with {0} FILE.", {file.option}});
}

}  // namespace

std::string findFeOfRun(const std::string& runPath, const io::RunOrigin& origin, const std::optional<std::string>& given,
                        const Execution& execution) {
    return find(runPath, {"FE", InputRole::Fe, "--fe", origin.fePath, origin.feSha256, given}, execution);
}

Inputs openInputsOfRun(const io::RunOrigin& origin, const Arguments& arguments, Session& session) {
    return openInputsOfRun(arguments.operand(), origin, arguments, session);
}

Inputs openInputsOfRun(const std::string& runPath, const io::RunOrigin& origin, const Arguments& arguments, Session& session,
                       Findings* site) {
    io::RunOrigin located = origin;
    located.fePath = findFeOfRun(runPath, origin, arguments.value("--fe"), session.execution());
    if (!origin.terrainPath.empty()) {
        located.terrainPath = find(
            runPath,
            {"terrain", InputRole::Terrain, "--terrain", origin.terrainPath, origin.terrainSha256, arguments.value("--terrain")},
            session.execution());
        for (io::RecordedInput& mesh : located.surroundings) {
            mesh.path = find(runPath, {"surroundings", InputRole::Surroundings, "", mesh.path, mesh.sha256, std::nullopt},
                             session.execution());
        }
    }
    Findings place, terrain;
    Inputs inputs = io::openRunInputs(located, place, terrain, session.execution());
    if (site != nullptr) {
        site->append(place);
        site->append(terrain);
    } else {
        printNotes(session, place);
    }
    return inputs;
}

}  // namespace rubble::cli
