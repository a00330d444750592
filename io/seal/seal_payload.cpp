#include "io/seal/seal_payload.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/base/build.h"
#include "core/base/error.h"
#include "core/scenario/differences.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/base/files.h"
#include "io/base/sha256.h"
#include "io/case/case_file.h"
#include "io/case/journal_check.h"
#include "io/exports/report_notes.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_cautions.h"
#include "io/run/run_file.h"
#include "io/site/input_files.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

/// The folder that holds all files and those below it.
fs::path commonFolder(const std::vector<std::string>& files) {
    fs::path common = fs::absolute(files.front()).lexically_normal().parent_path();
    for (const std::string& file : files) {
        const fs::path whole = fs::absolute(file).lexically_normal();
        while (common != common.root_path()) {
            const fs::path inside = whole.lexically_relative(common);
            if (!inside.empty() && *inside.begin() != "..") {
                break;
            }
            common = common.parent_path();
        }
    }
    return common;
}

/// Settings in which a run is not what the case says under the name of its scenario.
std::vector<OtherSetting> otherSettings(const RunOrigin& origin, const Case& theCase) {
    const auto scenario = std::find_if(theCase.scenarios.begin(), theCase.scenarios.end(),
                                       [&](const CaseScenario& each) { return each.name == origin.scenarioName; });
    if (scenario == theCase.scenarios.end()) {
        return {{"scenario", origin.scenarioName, {}}};
    }
    std::vector<OtherSetting> other;
    // A run keeps no setting that was as its program had it by default: what "auto" came to in another one is not known here.
    const bool sameProgram = origin.build == buildText();
    for (const SharedDifference& difference : sharedDifferences(differencesBetween(origin.scenario, scenario->scenario))) {
        const bool known = sameProgram || !std::holds_alternative<std::monostate>(difference.change.first);
        other.push_back(
            {difference.key(), known ? valueText(difference.change.first) : "not recorded", valueText(difference.change.second)});
    }
    if (!(origin.scenario.regrouping == scenario->scenario.regrouping)) {
        other.push_back({"regrouping", std::to_string(origin.scenario.regrouping.size()),
                         std::to_string(scenario->scenario.regrouping.size())});
    }
    return other;
}

[[noreturn]] void refuseInput(const std::string& id, const Message& what) {
    throw UsageError(
        what,
        Message{"io.seal.input.remedy",
                "Find the file and save the case anew, or seal without it: rubble-cli seal --leave-out {0}; its digest stays.",
                {id}});
}

}  // namespace

std::vector<PayloadFile> payloadOfInput(const std::string& folder, const std::string& path, InputRole role) {
    std::vector<std::string> files = filesWithInput(path, role);
    const std::string whole = fs::absolute(path).lexically_normal().string();
    // The file that the case names is the one to be opened.
    std::stable_partition(files.begin(), files.end(),
                          [&](const std::string& file) { return fs::absolute(file).lexically_normal().string() == whole; });
    const fs::path common = commonFolder(files);
    std::vector<PayloadFile> payload;
    for (const std::string& file : files) {
        const std::string inside = fs::absolute(file).lexically_normal().lexically_relative(common).generic_string();
        std::string place = folder + inside;
        // The names of a series are part of its digest.
        if (!isBagPlace(place) && files.size() == 1) {
            place = folder + bagName(inside);
        }
        if (!isBagPlace(place)) {
            throw UsageError(
                Message{"io.seal.name", "The name {0} holds characters that do not travel: %, \\ or line ends", {file}},
                Message{"io.seal.name.remedy", "Rename the files of this input, and save the case anew.", {}});
        }
        payload.push_back({place, file, {}, 0, {}});
    }
    return payload;
}

Manifest othersOfInput(const std::string& path, InputRole role, const Execution& execution) {
    Manifest others;
    std::error_code ignored;
    // The digest of an FE result is that of all its files.
    if (role == InputRole::Fe || !fs::exists(path, ignored)) {
        return others;
    }
    const std::vector<std::string> files = filesOfInput(path, role);
    const fs::path folder = fs::absolute(path).lexically_normal().parent_path();
    for (std::size_t i = 1; i < files.size(); ++i) {
        const std::string name = fs::absolute(files[i]).lexically_normal().lexically_relative(folder).generic_string();
        others[name] = sha256OfFile(files[i], [&](std::size_t) { execution.check(); });
    }
    return others;
}

void takeDigests(std::vector<PayloadFile>& files, const Execution& execution) {
    double all = 1.0, done = 0.0;
    for (const PayloadFile& file : files) {
        std::error_code failed;
        const std::uintmax_t size = file.source.empty() ? 0 : fs::file_size(file.source, failed);
        all += failed ? 0.0 : static_cast<double>(size);
    }
    for (PayloadFile& file : files) {
        if (file.source.empty()) {
            continue;
        }
        file.bytes = 0;
        file.sha256 = sha256OfFile(file.source, [&](std::size_t block) {
            file.bytes += block;
            done += static_cast<double>(block);
            execution.report({"io.seal.digests", "Taking digests: {0}", {fs::path(file.source).filename().string()}},
                             std::min(1.0, done / all));
        });
    }
}

void packFile(ZipWriter& zip, const std::string& name, const PayloadFile& file, const std::function<void(std::size_t)>& advance) {
    std::ifstream in(file.source, std::ios::binary);
    Sha256 digest;
    std::vector<char> block(std::size_t{1} << 16);
    zip.open(name, file.bytes);
    while (in.read(block.data(), static_cast<std::streamsize>(block.size())), in.gcount() > 0) {
        const auto got = static_cast<std::size_t>(in.gcount());
        digest.add(block.data(), got);
        zip.write(block.data(), got);
        advance(got);
    }
    zip.close();
    if (digest.hex() != file.sha256) {
        throw WorldError(Message{"io.seal.changed", "{0} changed while it was sealed", {file.source}},
                         Message{"io.seal.changed.remedy", "Wait until whatever writes it has ended, and seal again.", {}});
    }
}

SealedRun describeRun(const std::string& path, const Case& theCase, const std::function<bool(const std::string&)>& isInput,
                      const Execution& execution) {
    const std::shared_ptr<RunReader> run = openRun(path);
    if (!run->complete()) {
        throw UsageError(Message{"io.seal.run_incomplete", "The run {0} was stopped before its end", {path}},
                         Message{"io.seal.run_incomplete.remedy", "Run the case to its end, or leave the run out.", {}});
    }
    checkRunDigest(path, execution);
    const RunOrigin& origin = run->origin();
    std::vector<std::string> needed{origin.feSha256};
    if (!origin.terrainPath.empty()) {
        needed.push_back(origin.terrainSha256);
    }
    for (const RecordedInput& mesh : origin.surroundings) {
        needed.push_back(mesh.sha256);
    }
    for (const std::string& digest : needed) {
        if (!isInput(digest)) {
            throw UsageError(Message{"io.seal.run_of_another",
                                     "The run {0} stands on a file that is no input of the case: SHA-256 {1}",
                                     {path, digest}},
                             Message{"io.seal.run_of_another.remedy", "Seal it with the case that it was made from.", {}});
        }
    }
    std::vector<Message> cautions;
    for (const Caution& caution : runCautions(standingOf(*run))) {
        if (caution.inPictures()) {
            cautions.push_back(caution.what);
        }
    }
    return {{},
            {},
            origin.scenarioName,
            origin.fingerprint.hex(),
            run->result()->trajectoryHash.hex(),
            origin.build,
            otherSettings(origin, theCase),
            std::move(cautions)};
}

bool isInputOfCase(const std::string& casePath, const Case& theCase, const std::string& sha256, const Execution& execution) {
    return std::any_of(theCase.inputs.begin(), theCase.inputs.end(), [&](const CaseInput& input) {
        const std::string path = inputPath(casePath, input);
        std::error_code ignored;
        if (input.role == InputRole::Fe || input.role == InputRole::Photograph || !fs::exists(path, ignored)) {
            return false;
        }
        const InputDigest digest = digestOfInput(path, input.role, execution);
        return digest.is(sha256) && (input.sha256.empty() || digest.is(input.sha256));
    });
}

SealPayload::SealPayload(const SealRequest& request, const Execution& execution) : m_request(request), m_execution(execution) {
    addCase();
    addInputs();
    addRuns();
    addExtras();
    takeDigests(m_files, m_execution);
    for (SealedRun& run : m_statement.runs) {
        run.sha256 = manifest().at(run.place);
    }
}

void SealPayload::addText(const std::string& place, std::string text) {
    const std::string digest = sha256OfText(text);
    const std::uint64_t bytes = text.size();
    m_files.push_back({place, {}, std::move(text), bytes, digest});
}

Manifest SealPayload::manifest() const {
    Manifest manifest;
    for (const PayloadFile& file : m_files) {
        manifest[file.place] = file.sha256;
    }
    return manifest;
}

std::uint64_t SealPayload::bytes() const {
    std::uint64_t sum = 0;
    for (const PayloadFile& file : m_files) {
        sum += file.bytes;
    }
    return sum;
}

void SealPayload::addCase() {
    const std::string& path = m_request.casePath;
    std::optional<std::string> text = contentOf(path);
    if (!text) {
        sha256OfFile(path);
    }
    const JournalCheck journal = checkJournalText(*text, path);
    if (const std::string now = utcNow(); now < journal.last) {
        throw UsageError(Message{"io.seal.clock",
                                 "The clock of this machine says {0}, but the journal of {1} goes on until {2}",
                                 {now, path, journal.last}},
                         Message{"io.seal.clock.remedy", "Set the clock of this machine right, and seal then.", {}});
    }
    if (journal.entries == 0) {
        m_findings.add({"io.seal.no_journal", "the case has no journal, so who changed what in it cannot be told", {}},
                       {"io.seal.no_journal.remedy", "save the case once with this version", {}}, path);
    } else if (!journal.sound()) {
        m_findings.add({"io.seal.journal_unsound", "the case is not what its journal says", {}},
                       {"io.seal.journal_unsound.remedy", "look at it with rubble-cli verify before it is sealed", {}}, path);
    }
    if (!journal.backward.empty()) {
        m_findings.add({"io.seal.journal_backward", "entries of the journal are of a time before that of an earlier one", {}},
                       {"io.seal.journal_backward.remedy", "say in the note how the clock was set", {}}, path,
                       static_cast<std::int64_t>(journal.backward.size()));
    }
    m_statement.title = caseFromText(*text, path).title;
    m_statement.casePlace = "data/case/" + bagName(fs::path(path).filename().string());
    m_statement.caseSha256 = sha256OfText(*text);
    m_statement.journalEntries = static_cast<std::int64_t>(journal.entries);
    m_statement.journalHead = journal.head;
    addText(m_statement.casePlace, std::move(*text));
    addNotes();
}

/// What the author of the report has said lies beside the case, and the other side finds it there.
void SealPayload::addNotes() {
    const std::string path = reportNotesPath(m_request.casePath);
    const ReportNotes notes = readReportNotes(path);
    if (notes.empty()) {
        return;
    }
    addFile(reportNotesPath(m_statement.casePlace), path);
    if (!notes.causes.empty()) {
        m_findings.add({"io.seal.causes_home", "the comparison of causes that the report names does not travel by itself", {}},
                       {"io.seal.causes_home.remedy", "add it: rubble-cli seal --add FILE", {}}, notes.causes);
    }
}

void SealPayload::addInputs() {
    const Case theCase = loadCase(m_request.casePath);
    for (const std::string& id : m_request.leftHome) {
        if (std::none_of(theCase.inputs.begin(), theCase.inputs.end(), [&](const CaseInput& input) { return input.id == id; })) {
            throw UsageError(Message{"io.seal.no_input", "{0} has no input \"{1}\"", {m_request.casePath, id}},
                             Message{"io.seal.no_input.remedy", "Name an input of the case by its id.", {}});
        }
    }
    for (const CaseInput& input : theCase.inputs) {
        const bool leftHome = std::find(m_request.leftHome.begin(), m_request.leftHome.end(), input.id) != m_request.leftHome.end();
        const std::string path = inputPath(m_request.casePath, input);
        std::error_code ignored;
        std::string digest = input.sha256;
        if (!leftHome || digest.empty()) {
            if (!fs::exists(path, ignored)) {
                refuseInput(input.id, {"io.seal.input_missing", "The file of the input {0} is not there: {1}", {input.id, path}});
            }
            m_execution.report({"io.seal.inputs", "Taking the digests of the inputs", {}}, 0.0);
            digest = digestOfInput(path, input.role, m_execution).against(input.sha256);
        }
        if (!input.sha256.empty() && digest != input.sha256) {
            refuseInput(input.id, {"io.seal.input_differs",
                                   "The file of the input {0} is not the one that the case was saved with: {1}",
                                   {input.id, path}});
        }
        m_statement.inputs.push_back({input.id, input.path, digest, {}});
        if (!leftHome) {
            for (const PayloadFile& file : payloadOfInput("data/inputs/" + bagName(input.id) + "/", path, input.role)) {
                m_statement.inputs.back().files.push_back(addFile(file.place, file.source));
            }
        } else {
            m_statement.inputs.back().others = othersOfInput(path, input.role, m_execution);
            m_findings.add({"io.seal.input_home", "inputs do not travel: the bundle holds only their digests", {}},
                           {"io.seal.input_home.remedy", "whoever opens the bundle needs these files to simulate again", {}},
                           input.id);
        }
    }
}

void SealPayload::addRuns() {
    const Case theCase = loadCase(m_request.casePath);
    for (const std::string& path : m_request.runs) {
        const auto isInput = [&](const std::string& sha256) {
            const auto sealed = [&](const SealedInput& input) { return input.sha256 == sha256; };
            return std::any_of(m_statement.inputs.begin(), m_statement.inputs.end(), sealed) ||
                   isInputOfCase(m_request.casePath, theCase, sha256, m_execution);
        };
        SealedRun run = describeRun(path, theCase, isInput, m_execution);
        if (!run.otherSettings.empty()) {
            m_findings.add({"io.seal.run_settings", "runs were made under other settings than those of the case", {}},
                           {"io.seal.run_settings.remedy",
                            "run the case as it is, or save it as it was run; the bundle says which settings these are",
                            {}},
                           path);
        }
        if (run.build != buildText()) {
            m_findings.add({"io.seal.run_build", "runs were made by another build than this program", {}},
                           {"io.seal.run_build.remedy", "only that build repeats them bit for bit; run them again, or keep it", {}},
                           path);
        }
        run.place = addFile("data/runs/" + bagName(fs::path(path).filename().string()), path);
        if (std::error_code ignored; fs::exists(acknowledgementPath(path), ignored)) {
            addFile(acknowledgementPath(run.place), acknowledgementPath(path));
        }
        m_statement.runs.push_back(std::move(run));
    }
}

void SealPayload::addExtras() {
    for (const SealedExtra& extra : m_request.extras) {
        std::error_code ignored;
        const fs::path whole = fs::absolute(extra.path).lexically_normal();
        if (!fs::exists(whole, ignored)) {
            throw WorldError(Message{"io.seal.extra_missing", "{0} is to be sealed as well, but is not there", {whole.string()}},
                             Message{"io.seal.extra_missing.remedy", "Make it first, or seal without it.", {}});
        }
        if (!fs::is_directory(whole, ignored)) {
            addFile("data/" + extra.folder + "/" + bagName(whole.filename().string()), whole.string());
            if (const std::string origin = whole.string() + ".provenance.json"; fs::exists(origin, ignored)) {
                addFile("data/" + extra.folder + "/" + bagName(fs::path(origin).filename().string()), origin);
            }
            continue;
        }
        std::vector<fs::path> inside;
        for (fs::recursive_directory_iterator it(whole, ignored), end; it != end; it.increment(ignored)) {
            if (it->is_regular_file(ignored)) {
                inside.push_back(it->path());
            }
        }
        std::sort(inside.begin(), inside.end());
        for (const fs::path& file : inside) {
            std::string place = "data/" + extra.folder;
            for (const fs::path& part : file.lexically_relative(whole)) {
                place += "/" + bagName(part.string());
            }
            addFile(place, file.string());
        }
    }
}

/// Two files of one name get a number before the second.
std::string SealPayload::addFile(const std::string& place, const std::string& source) {
    const auto taken = [&](const std::string& name) {
        return std::any_of(m_files.begin(), m_files.end(), [&](const PayloadFile& file) { return file.place == name; });
    };
    std::string free = place;
    for (int number = 2; taken(free); ++number) {
        const std::size_t name = place.rfind('/') + 1;
        free = place.substr(0, name) + std::to_string(number) + "-" + place.substr(name);
    }
    m_files.push_back({free, source, {}, 0, {}});
    return free;
}

}  // namespace rubble::io
