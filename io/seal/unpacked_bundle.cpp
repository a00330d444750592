#include "io/seal/unpacked_bundle.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/seal/bag.h"
#include "io/site/input_files.h"

namespace rubble::io {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    std::error_code failed;
    const fs::path parent = fs::temp_directory_path(failed);
    m_path = (parent / "rubble-XXXXXX").string();
    if (failed || mkdtemp(m_path.data()) == nullptr) {
        throw WorldError({"io.seal.no_scratch", "No folder for temporary files can be made in {0}", {parent.string()}},
                         {"io.seal.no_scratch.remedy", "Set TMPDIR to a folder with room.", {}});
    }
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

UnpackedBundle::UnpackedBundle(const std::string& bundle, const SealCheck& check, const std::string& folder,
                               const Execution& execution)
    : m_check(check), m_folder(folder) {
    std::error_code failed;
    const bool there = fs::exists(folder, failed);
    if (there && !fs::is_empty(folder, failed)) {
        throw UsageError(Message{"io.seal.folder_full", "{0} is not empty, so nothing is unpacked there", {folder}},
                         Message{"io.seal.folder_full.remedy", "Name a folder that is empty or not there yet.", {}});
    }
    try {
        unpack(bundle, execution);
    } catch (...) {
        for (const fs::path& each : fs::directory_iterator(folder, failed)) {
            fs::remove_all(each, failed);
        }
        if (!there) {
            fs::remove(folder, failed);
        }
        throw;
    }
}

void UnpackedBundle::unpack(const std::string& bundle, const Execution& execution) {
    PackedBag packed(bundle);
    m_folder = fs::absolute(m_folder + "/" + packed.folder()).lexically_normal().string();
    m_folder.erase(m_folder.find_last_not_of('/') + 1);
    double all = 1.0, done = 0.0;
    for (const ZipReader::Entry& entry : packed.entries()) {
        all += static_cast<double>(entry.bytes);
    }
    for (const ZipReader::Entry& entry : packed.entries()) {
        const std::string place = packed.placeOf(entry);
        if (!isBagPlace(place)) {
            continue;
        }
        const std::string path = pathOf(place);
        makeFolderOf(path);
        writeAtomically(path, [&](std::ostream& out) {
            packed.zip().read(entry, [&](const char* data, std::size_t size) {
                out.write(data, static_cast<std::streamsize>(size));
                done += static_cast<double>(size);
                execution.report({"io.seal.unpacking", "Unpacking the bundle", {}}, std::min(1.0, done / all));
            });
        });
        std::error_code ignored;
        fs::permissions(path, fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read, ignored);
    }
}

namespace {

/// Throws UsageError if a file that is read with an input is not the one that was sealed with it.
void checkOthers(const SealedInput& input, const std::string& path, const Execution& execution) {
    const std::vector<std::string> read = filesOfInput(path, InputRole::Terrain);
    for (const auto& [name, sha256] : input.others) {
        const std::string file = (fs::absolute(path).parent_path() / name).lexically_normal().string();
        std::error_code ignored;
        const bool there = fs::is_regular_file(file, ignored);
        const bool counts =
            std::any_of(read.begin(), read.end(), [&](const std::string& each) { return fs::equivalent(each, file, ignored); });
        // Older bundles name pyramids and statistics too, which change nothing.
        if (there && !counts) {
            continue;
        }
        if (!there || sha256OfFile(file, [&](std::size_t) { execution.check(); }) != sha256) {
            throw UsageError(Message{"io.seal.located_other",
                                     "{0}, which is read with the input {1}, is not there or not the file that was sealed",
                                     {file, input.id}},
                             Message{"io.seal.located_other.remedy", "Put the file with the SHA-256 {0} there.", {sha256}});
        }
    }
}

}  // namespace

std::vector<SealedInput> inputsOf(const SealCheck& check) {
    std::vector<SealedInput> all = check.statement.inputs;
    for (const CheckedRecord& checked : check.records) {
        const std::vector<SealedInput>& more = checked.record.addendum.inputs;
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

std::string checkLocated(const SealCheck& check, const std::string& id, const std::string& path, const Execution& execution) {
    const std::vector<SealedInput> all = inputsOf(check);
    const auto found = std::find_if(all.begin(), all.end(), [&](const SealedInput& input) { return input.id == id; });
    if (found == all.end()) {
        throw UsageError(Message{"io.seal.no_sealed_input", "The bundle has no input \"{0}\"", {id}},
                         Message{"io.seal.no_input.remedy", "Name an input of the case by its id.", {}});
    }
    // The digest alone tells an FE result, which may be many files, from another file.
    for (const InputRole role : {InputRole::Terrain, InputRole::Fe}) {
        if (digestOfInput(path, role, execution).is(found->sha256)) {
            checkOthers(*found, path, execution);
            return found->sha256;
        }
    }
    checkOthers(*found, path, execution);
    throw UsageError(Message{"io.seal.located_differs",
                             "{0} is not the input {1} that was sealed: its SHA-256 is another than {2}",
                             {path, id, found->sha256}},
                     Message{"io.seal.located_differs.remedy", "Name the file with that SHA-256.", {}});
}

void UnpackedBundle::locate(const std::string& id, const std::string& path, const Execution& execution) {
    m_located[checkLocated(m_check, id, path, execution)] = fs::absolute(path).lexically_normal().string();
}

std::string UnpackedBundle::placeOf(const SealedInput& input) const {
    const auto located = m_located.find(input.sha256);
    return located != m_located.end() ? located->second : input.files.empty() ? std::string() : pathOf(input.files.front());
}

std::string UnpackedBundle::inputWith(const std::string& sha256) const {
    for (const SealedInput& input : inputsOf(m_check)) {
        if (const std::string place = placeOf(input); input.sha256 == sha256 && !place.empty()) {
            return place;
        }
    }
    return {};
}

std::string UnpackedBundle::inputOfRun(const std::string& sha256, const Execution& execution) const {
    if (std::string place = inputWith(sha256); !place.empty()) {
        return place;
    }
    // Of the digests that case and run keep one may be of the file alone, the other of all that is read with it.
    for (const SealedInput& input : inputsOf(m_check)) {
        const std::string place = placeOf(input);
        std::error_code ignored;
        if (!place.empty() && fs::is_regular_file(place, ignored)) {
            const InputDigest digest = digestOfInput(place, InputRole::Terrain, execution);
            if (digest.is(sha256) && digest.is(input.sha256)) {
                return place;
            }
        }
    }
    return {};
}

void UnpackedBundle::writeWorkingCase(const std::string& path, std::int64_t addendum) const {
    std::vector<SealedInput> sealed = m_check.statement.inputs;
    std::string place = m_check.statement.casePlace;
    if (addendum != 0) {
        const auto meant = [&](const CheckedRecord& each) { return each.record.isAddendum && each.record.number == addendum; };
        const auto found = std::find_if(m_check.records.begin(), m_check.records.end(), meant);
        if (found == m_check.records.end()) {
            throw UsageError(Message{"io.seal.no_addendum", "Entry {0} of the bundle is no addendum", {addendum}},
                             Message{"io.seal.no_addendum.remedy", "Name an addendum by its number.", {}});
        }
        // Its own inputs come first: the others are those of the sealed case.
        const SealAddendum& theirs = found->record.addendum;
        sealed.insert(sealed.begin(), theirs.inputs.begin(), theirs.inputs.end());
        place = theirs.casePlace;
    }
    Case theCase = loadCase(pathOf(place));
    const fs::path folder = fs::absolute(path).lexically_normal().parent_path();
    for (CaseInput& input : theCase.inputs) {
        const auto named = std::find_if(sealed.begin(), sealed.end(), [&](const SealedInput& each) {
            return each.id == input.id && (input.sha256.empty() || each.sha256 == input.sha256);
        });
        const std::string now = inputWith(named != sealed.end() ? named->sha256 : input.sha256);
        if (!now.empty()) {
            input.path = fs::path(now).lexically_relative(folder).generic_string();
        }
    }
    saveCase(path, theCase);
}

std::vector<SealedRun> UnpackedBundle::runs() const {
    std::vector<SealedRun> all = m_check.statement.runs;
    for (const CheckedRecord& checked : m_check.records) {
        const std::vector<SealedRun>& more = checked.record.addendum.runs;
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

RunRepeat UnpackedBundle::repeat(const SealedRun& run, const Execution& execution) const {
    const std::string path = pathOf(run.place);
    const std::shared_ptr<RunReader> recorded = openRun(path);
    checkRunDigest(path, execution);
    RunOrigin origin = recorded->origin();
    const auto located = [&](const std::string& sha256, const std::string& then) {
        std::string now = inputOfRun(sha256, execution);
        if (now.empty()) {
            throw WorldError(
                Message{"io.seal.not_here",
                        "The run {0} stands on {1}, which did not travel: SHA-256 {2}",
                        {run.place, fs::path(then).filename().string(), sha256}},
                Message{
                    "io.seal.not_here.remedy",
                    "Get the file, and say where it is: in the window under Runs, or by rubble-cli open-sealed --input ID=FILE.",
                    {}});
        }
        return now;
    };
    origin.fePath = located(origin.feSha256, origin.fePath);
    if (!origin.terrainPath.empty()) {
        origin.terrainPath = located(origin.terrainSha256, origin.terrainPath);
    }
    for (RecordedInput& mesh : origin.surroundings) {
        mesh.path = located(mesh.sha256, mesh.path);
    }
    Findings place, terrain;
    const Inputs inputs = openRunInputs(origin, place, terrain, execution);
    RunRepeat repeat = repeatRun(*recorded, inputs, execution);
    // What the statement says of a run is sealed with it.
    repeat.figures.push_back({"sealed trajectory hash", run.trajectoryHash, recorded->result()->trajectoryHash.hex()});
    repeat.figures.push_back({"sealed build", run.build, origin.build});
    repeat.equal = repeat.equal && repeat.figures.rbegin()[0].same() && repeat.figures.rbegin()[1].same();
    return repeat;
}

}  // namespace rubble::io
