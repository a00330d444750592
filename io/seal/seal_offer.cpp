#include "io/seal/seal_offer.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "io/jobs/program.h"
#include "io/json/json_cursor.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_file.h"
#include "io/run/run_history.h"
#include "io/seal/bag.h"
#include "io/seal/unpacked_bundle.h"
#include "io/site/input_files.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

constexpr const char* reportPage = "report.html";
constexpr const char* pageEnding = ".html";
constexpr const char* runEnding = ".run.h5";
constexpr const char* bundleEnding = ".rubblecase";
constexpr const char* provenanceEnding = ".provenance.json";

std::uint64_t bytesOf(const fs::path& path) {
    std::error_code failed;
    if (!fs::is_directory(path, failed)) {
        const std::uintmax_t size = fs::file_size(path, failed);
        return failed ? 0 : size;
    }
    std::uint64_t sum = 0;
    for (fs::recursive_directory_iterator it(path, failed), end; it != end; it.increment(failed)) {
        sum += it->is_regular_file(failed) ? it->file_size(failed) : 0;
    }
    return sum;
}

std::string whole(const fs::path& path) {
    return fs::absolute(path).lexically_normal().string();
}

/// What a file says of itself: tables and files for other programs have it beside them, pictures, reports and pages in them.
ReadProvenance provenanceOf(const std::string& file) {
    const std::string beside = file + provenanceEnding;
    const std::optional<std::string> text = contentOf(beside);
    if (!text) {
        return readProvenance(file).value_or(ReadProvenance());
    }
    const nlohmann::json about = parseJson(*text, beside);
    ReadProvenance read;
    read.fingerprint = about.value("fingerprint", std::string());
    read.casePath = about.value("case_path", std::string());
    return read;
}

OfferedPart partAt(const std::string& path) {
    std::error_code ignored;
    const bool report = fs::is_directory(path, ignored);
    const OfferedPart::Kind kind = report                        ? OfferedPart::Kind::Report
                                   : hasEnding(path, pageEnding) ? OfferedPart::Kind::Page
                                   : hasEnding(path, runEnding)  ? OfferedPart::Kind::Run
                                                                 : OfferedPart::Kind::Export;
    return {kind, {}, whole(path), bytesOf(path) + (report ? 0 : bytesOf(path + provenanceEnding))};
}

/// Fingerprint of a run, or of the run that something was made of; empty where that is not told.
std::string fingerprintOf(const OfferedPart& part) {
    try {
        if (part.kind == OfferedPart::Kind::Run) {
            return openRun(part.path)->origin().fingerprint.hex();
        }
        return provenanceOf(part.kind == OfferedPart::Kind::Report ? part.path + "/" + reportPage : part.path).fingerprint;
    } catch (const std::exception&) {
        // What cannot be read says nothing.
        return {};
    }
}

/// Complete runs whose file is there, in the order in which they ended.
std::vector<RunEntry> keptRuns(const std::string& casePath) {
    std::vector<RunEntry> kept = readRunHistory(runHistoryPath(casePath));
    std::erase_if(kept, [](const RunEntry& entry) {
        std::error_code ignored;
        return !entry.complete || entry.file.empty() || !fs::exists(entry.file, ignored);
    });
    return kept;
}

/// Collects what a case has.
class Offer {
public:
    Offer(const std::string& casePath, const Execution& execution)
        : m_casePath(casePath), m_case(loadCase(casePath)), m_execution(execution) {}

    std::vector<OfferedPart> collect() {
        addInputs();
        listBeside();
        addRuns();
        addRunsBeside();
        addFilesBeside();
        addMissing();
        addVerdicts();
        std::stable_sort(m_parts.begin(), m_parts.end(),
                         [](const OfferedPart& a, const OfferedPart& b) { return a.kind < b.kind; });
        return std::move(m_parts);
    }

private:
    void addInputs() {
        for (const CaseInput& input : m_case.inputs) {
            const std::string path = inputPath(m_casePath, input);
            OfferedPart part{OfferedPart::Kind::Input, input.id, whole(path), 0};
            if (std::error_code ignored; fs::exists(path, ignored)) {
                for (const std::string& file : filesWithInput(path, input.role)) {
                    part.bytes += bytesOf(file);
                }
            } else {
                part.chosen = false;
                part.remark = {"io.seal.offer_missing", "its file is not there", {}};
            }
            m_inputs.insert(part.path);
            m_parts.push_back(std::move(part));
        }
    }

    void addRuns() {
        const std::vector<std::string> newest = newestRuns(m_casePath);
        std::set<std::string> told;
        for (RunEntry& entry : keptRuns(m_casePath)) {
            m_fingerprints.insert(entry.fingerprint.hex());
            if (!told.insert(entry.file).second) {
                continue;
            }
            OfferedPart part{OfferedPart::Kind::Run, entry.scenarioName, whole(entry.file), bytesOf(entry.file)};
            takeVerdict(entry);
            if (entry.tainted()) {
                m_tainted.insert(part.path);
            }
            part.bytes += bytesOf(acknowledgementPath(entry.file));
            part.fingerprint = entry.fingerprint.hex();
            part.chosen = std::find(newest.begin(), newest.end(), entry.file) != newest.end();
            if (!hasFe(entry.feSha256)) {
                part.chosen = false;
                part.remark = {"io.seal.offer_other_fe", "it was made of another FE result", {}};
            }
            m_parts.push_back(std::move(part));
        }
    }

    void listBeside() {
        std::error_code failed;
        for (fs::directory_iterator it(fs::absolute(m_casePath).parent_path(), failed), end; it != end; it.increment(failed)) {
            m_beside.push_back(it->path());
        }
        std::sort(m_beside.begin(), m_beside.end());
    }

    /// Runs that no history knows, as the command line makes them. Of a scenario that has none, the last one is chosen.
    void addRunsBeside() {
        std::vector<fs::path> runs;
        const auto known = [&](const fs::path& path) {
            return std::any_of(m_parts.begin(), m_parts.end(), [&](const OfferedPart& part) { return part.path == whole(path); });
        };
        std::copy_if(m_beside.begin(), m_beside.end(), std::back_inserter(runs),
                     [&](const fs::path& path) { return hasEnding(path.string(), runEnding) && !known(path); });
        std::stable_sort(runs.begin(), runs.end(), [](const fs::path& a, const fs::path& b) {
            std::error_code ignored;
            return fs::last_write_time(a, ignored) > fs::last_write_time(b, ignored);
        });
        for (const fs::path& path : runs) {
            addRunBeside(path);
        }
    }

    void addRunBeside(const fs::path& path) {
        m_execution.check();
        try {
            const std::shared_ptr<RunReader> run = openRun(path.string());
            const RunOrigin& origin = run->origin();
            if (!run->complete() || !hasFe(origin.feSha256)) {
                return;
            }
            m_fingerprints.insert(origin.fingerprint.hex());
            OfferedPart part{OfferedPart::Kind::Run, origin.scenarioName, whole(path), bytesOf(path)};
            if (taintOf(*run).tainted()) {
                m_tainted.insert(part.path);
            }
            part.bytes += bytesOf(acknowledgementPath(path.string()));
            part.fingerprint = origin.fingerprint.hex();
            part.chosen = std::none_of(m_parts.begin(), m_parts.end(), [&](const OfferedPart& each) {
                return each.kind == OfferedPart::Kind::Run && each.chosen && each.id == part.id;
            });
            m_parts.push_back(std::move(part));
        } catch (const Error&) {
            // What cannot be read is no run of this case.
        }
    }

    bool hasFe(const std::string& sha256) const {
        return std::any_of(m_case.inputs.begin(), m_case.inputs.end(), [&](const CaseInput& input) {
            return input.role == InputRole::Fe && (input.sha256.empty() || input.sha256 == sha256);
        });
    }

    void addFilesBeside() {
        std::error_code failed;
        for (const fs::path& path : m_beside) {
            m_execution.report({"io.seal.offer", "Looking for what the case has", {}}, 0.0);
            const bool report = fs::is_directory(path, failed);
            const std::string file = whole(report ? path / reportPage : path);
            if (!fs::is_regular_file(file, failed)) {
                continue;
            }
            if (const std::optional<std::string> fingerprint = madeOfTheCase(file)) {
                OfferedPart part = partAt(report ? path.string() : file);
                part.fingerprint = *fingerprint;
                m_parts.push_back(std::move(part));
            }
        }
    }

    /// The fingerprint of the run, or empty, if a file says that it was made of this case.
    std::optional<std::string> madeOfTheCase(const std::string& file) {
        // An earlier bundle holds files that say so.
        if (m_inputs.contains(file) || hasEnding(file, provenanceEnding) || hasEnding(file, runEnding) ||
            hasEnding(file, bundleEnding)) {
            return {};
        }
        try {
            const ReadProvenance about = provenanceOf(file);
            std::error_code ignored;
            const bool ofCase = (!about.casePath.empty() && fs::equivalent(about.casePath, m_casePath, ignored)) ||
                                (!about.fingerprint.empty() && m_fingerprints.contains(about.fingerprint));
            return ofCase ? std::optional(about.fingerprint) : std::nullopt;
        } catch (const std::exception&) {
            // What cannot be read says nothing.
            return {};
        }
    }

    void addMissing() {
        const std::vector<OfferedPart> there = m_parts;
        for (const OfferedPart& part : there) {
            if (part.kind == OfferedPart::Kind::Run && part.remark.empty()) {
                const std::vector<OfferedPart> missing = missingOf(part, there);
                m_parts.insert(m_parts.end(), missing.begin(), missing.end());
            }
        }
    }

    /// What is sealed is read by others.
    void addVerdicts() {
        for (OfferedPart& part : m_parts) {
            if (part.kind == OfferedPart::Kind::Run && part.remark.empty() && m_tainted.contains(part.path)) {
                part.remark = {"io.seal.offer_tainted", "tainted: it passed limits of health, and nobody vouches for it", {}};
            }
        }
    }

    const std::string& m_casePath;
    const Case m_case;
    const Execution& m_execution;
    std::vector<OfferedPart> m_parts;
    std::vector<fs::path> m_beside;
    std::set<std::string> m_inputs;
    std::set<std::string> m_fingerprints;
    std::set<std::string> m_tainted;
};

void replaceAll(std::string& text, const std::string& word, const std::string& with) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + with.size())) {
        text.replace(at, word.size(), with);
    }
}

}  // namespace

std::vector<std::string> newestRuns(const std::string& casePath) {
    std::map<std::string, std::string> newest;
    for (const RunEntry& entry : keptRuns(casePath)) {
        newest[entry.scenarioId] = entry.file;
    }
    std::vector<std::string> runs;
    for (const auto& [scenario, file] : newest) {
        if (std::find(runs.begin(), runs.end(), file) == runs.end()) {
            runs.push_back(file);
        }
    }
    return runs;
}

std::vector<OfferedPart> sealOffer(const std::string& casePath, const Execution& execution) {
    return Offer(casePath, execution).collect();
}

OfferedPart addedPart(const std::string& path) {
    OfferedPart part = partAt(path);
    part.fingerprint = fingerprintOf(part);
    return part;
}

std::vector<OfferedPart> missingOf(const OfferedPart& run, const std::vector<OfferedPart>& parts) {
    std::vector<OfferedPart> missing;
    for (const OfferedPart::Kind kind : {OfferedPart::Kind::Report, OfferedPart::Kind::Page}) {
        bool there = false, others = false;
        for (const OfferedPart& part : parts) {
            const bool made = part.kind == kind && part.run.empty();
            there = there || (made && !part.fingerprint.empty() && part.fingerprint == run.fingerprint);
            others = others || made;
        }
        if (there) {
            continue;
        }
        OfferedPart part{kind, run.id, {}, 0, false};
        part.run = run.path;
        part.remark = others ? Message{"io.seal.offer_of_others", "what is there was made of another run", {}}
                             : Message{"io.seal.offer_none", "there is none yet", {}};
        missing.push_back(std::move(part));
    }
    return missing;
}

SealedExtra placeOfMade(OfferedPart::Kind kind, const std::string& run, std::size_t number, const std::string& folder) {
    const std::string name = std::to_string(number) + "-" + fs::path(run).stem().stem().string();
    return kind == OfferedPart::Kind::Report ? SealedExtra{"report/" + bagName(name), folder + "/" + name}
                                             : SealedExtra{"page", folder + "/" + name + pageEnding};
}

std::string placeInBag(const SealedExtra& made) {
    const std::string folder = bag::payload + made.folder;
    return hasEnding(made.path, pageEnding) ? folder + "/" + bagName(fs::path(made.path).filename().string()) : folder;
}

void choose(SealRequest& request, const std::vector<OfferedPart>& parts) {
    const auto reports = std::count_if(parts.begin(), parts.end(), [](const OfferedPart& part) {
        return part.kind == OfferedPart::Kind::Report && part.chosen && part.run.empty();
    });
    std::size_t report = 0;
    for (const OfferedPart& part : parts) {
        if (!part.run.empty()) {
            continue;
        }
        if (part.kind == OfferedPart::Kind::Input) {
            if (!part.chosen) {
                request.leftHome.push_back(part.id);
            }
        } else if (!part.chosen) {
            continue;
        } else if (part.kind == OfferedPart::Kind::Run) {
            request.runs.push_back(part.path);
        } else if (part.kind == OfferedPart::Kind::Report && reports > 1) {
            // Their files have the same names, and refer to each other by them.
            const std::string name = std::to_string(++report) + "-" + fs::path(part.path).filename().string();
            request.extras.push_back({"report/" + bagName(name), part.path});
        } else {
            const char* folder = part.kind == OfferedPart::Kind::Export   ? "exports"
                                 : part.kind == OfferedPart::Kind::Report ? "report"
                                                                          : "page";
            request.extras.push_back({folder, part.path});
        }
    }
}

StampService stampServiceBy(const std::string& command) {
    return [command](const std::string& request) {
        const ScratchFolder folder;
        const std::string asked = folder.path() + "/request.tsq", answered = folder.path() + "/answer.tsr";
        writeIn(asked, request);
        std::string line = command;
        replaceAll(line, "{request}", shellWord(asked));
        replaceAll(line, "{answer}", shellWord(answered));
        const std::optional<ProgramOutcome> outcome = runProgram({"sh", "-c", line});
        const std::optional<std::string> answer = contentOf(answered);
        if (!outcome || outcome->exitCode != 0 || !answer) {
            throw WorldError(
                Message{
                    "io.seal.stamp_service", "The command for the time stamp gave no answer: {0}", {outcome ? outcome->err : line}},
                Message{"io.seal.stamp_service.remedy",
                        "Try it by hand, or write the request and add its answer later: rubble-cli time-stamp.",
                        {}});
        }
        return *answer;
    };
}

}  // namespace rubble::io
