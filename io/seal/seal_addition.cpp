#include "io/seal/seal_addition.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/base/files.h"
#include "io/base/sha256.h"
#include "io/base/trimmed.h"
#include "io/case/case_file.h"
#include "io/seal/bag.h"
#include "io/seal/seal_payload.h"
#include "io/seal/time_stamp.h"
#include "io/site/input_files.h"

namespace rubble::io {

using nlohmann::json;

namespace {

SealCheck soundBundle(const std::string& path, const Execution& execution) {
    SealCheck check = checkBundle(path, {}, execution);
    if (!check.sound()) {
        const SealFault& first = check.faults.front();
        throw UsageError(
            Message{"io.seal.unsound", "{0} is not as it was sealed, first {1}: {2}", {path, first.place, englishText(first.what)}},
            Message{"io.seal.damaged.remedy", "Get the bundle anew from whoever sealed it, or from another copy.", {}});
    }
    return check;
}

/// Packs a bundle anew with more files about it; what lies in it is copied as it is.
class LongerBundle {
public:
    LongerBundle(const std::string& path, const Execution& execution) : m_bag(path), m_execution(execution) {}

    void addText(const std::string& place, std::string text) {
        const std::string digest = sha256OfText(text);
        const std::uint64_t bytes = text.size();
        m_added.push_back({place, {}, std::move(text), bytes, digest});
    }
    void addFile(PayloadFile file) { m_added.push_back(std::move(file)); }

    void write(const std::string& out) {
        Manifest tags = manifestOf(m_bag.text(bag::tagManifest).value_or("")).value_or(Manifest());
        for (const PayloadFile& file : m_added) {
            tags[file.place] = file.sha256;
        }
        writeFileAtomically(out, [&](const std::string& temporary) {
            ZipWriter zip(temporary);
            for (const ZipReader::Entry& entry : m_bag.entries()) {
                copy(zip, entry);
            }
            for (const PayloadFile& file : m_added) {
                pack(zip, file);
            }
            zip.add(m_bag.folder() + bag::tagManifest, manifestText(tags));
            zip.finish();
        });
    }

private:
    void copy(ZipWriter& zip, const ZipReader::Entry& entry) {
        const std::string place = m_bag.placeOf(entry);
        const bool replaced =
            std::any_of(m_added.begin(), m_added.end(), [&](const PayloadFile& file) { return file.place == place; });
        if (place == bag::tagManifest || replaced) {
            return;
        }
        zip.open(entry.name, entry.bytes);
        m_bag.zip().read(entry, [&](const char* data, std::size_t size) {
            zip.write(data, size);
            m_execution.report({"io.seal.packing", "Packing the bundle", {}}, 0.5);
        });
        zip.close();
    }

    void pack(ZipWriter& zip, const PayloadFile& file) {
        const std::string name = m_bag.folder() + file.place;
        if (file.source.empty()) {
            zip.add(name, file.text);
        } else {
            packFile(zip, name, file, [&](std::size_t) { m_execution.check(); });
        }
    }

    PackedBag m_bag;
    const Execution& m_execution;
    std::vector<PayloadFile> m_added;
};

/// Builds the addendum of another expert: differences, and the files that the bundle does not have yet.
class AddendumPacking {
public:
    AddendumPacking(const std::string& bundle, const SealStatement& statement, const SealAddition& addition, std::string folder,
                    const Execution& execution)
        : m_bag(bundle), m_statement(statement), m_addition(addition), m_folder(std::move(folder)), m_execution(execution) {}

    SealAddendum build() {
        m_addendum.note = m_addition.note;
        const std::optional<std::string> text = contentOf(m_addition.casePath);
        if (!text) {
            failToRead(m_addition.casePath);
        }
        compare(*text);
        const Case theirs = caseFromText(*text, m_addition.casePath);
        addInputs(theirs);
        m_addendum.casePlace = m_folder + "case/" + bagName(std::filesystem::path(m_addition.casePath).filename().string());
        m_files.push_back({m_addendum.casePlace, m_addition.casePath, {}, 0, {}});
        addRuns(theirs);
        takeDigests(m_files, m_execution);
        for (SealedRun& run : m_addendum.runs) {
            run.sha256 = std::find_if(m_files.begin(), m_files.end(), [&](const PayloadFile& file) {
                             return file.place == run.place;
                         })->sha256;
        }
        return m_addendum;
    }
    const std::vector<PayloadFile>& files() const { return m_files; }

private:
    void compare(const std::string& text) {
        const std::string sealed = m_bag.text(m_statement.casePlace).value_or("");
        m_addendum.differences = assumptionChanges(sealed, m_statement.casePlace, text, m_addition.casePath);
        if (m_addendum.differences.empty() && m_addition.runs.empty()) {
            throw UsageError(
                Message{"io.seal.nothing_changed", "{0} says the same as the sealed case", {m_addition.casePath}},
                Message{"io.seal.nothing_changed.remedy", "Change what you assume otherwise, save the case, and add it then.", {}});
        }
    }

    void addInputs(const Case& theirs) {
        for (const CaseInput& input : theirs.inputs) {
            const auto has = [&](const SealedInput& each) { return !input.sha256.empty() && each.sha256 == input.sha256; };
            if (std::any_of(m_statement.inputs.begin(), m_statement.inputs.end(), has)) {
                continue;
            }
            const std::string path = inputPath(m_addition.casePath, input);
            SealedInput added{input.id, input.path, digestOfInput(path, input.role, m_execution).sha256, {}};
            for (PayloadFile& file : payloadOfInput(m_folder + "inputs/" + bagName(input.id) + "/", path, input.role)) {
                added.files.push_back(file.place);
                m_files.push_back(std::move(file));
            }
            m_addendum.inputs.push_back(std::move(added));
        }
    }

    void addRuns(const Case& theirs) {
        std::vector<SealedInput> known = m_statement.inputs;
        known.insert(known.end(), m_addendum.inputs.begin(), m_addendum.inputs.end());
        const auto isInput = [&](const std::string& sha256) {
            return std::any_of(known.begin(), known.end(), [&](const SealedInput& input) { return input.sha256 == sha256; }) ||
                   isInputOfCase(m_addition.casePath, theirs, sha256, m_execution);
        };
        for (std::size_t i = 0; i < m_addition.runs.size(); ++i) {
            const std::string& path = m_addition.runs[i];
            SealedRun run = describeRun(path, theirs, isInput, m_execution);
            run.place = m_folder + "runs/" + std::to_string(i + 1) + "-" + bagName(std::filesystem::path(path).filename().string());
            m_files.push_back({run.place, path, {}, 0, {}});
            m_addendum.runs.push_back(std::move(run));
        }
    }

    PackedBag m_bag;
    const SealStatement& m_statement;
    const SealAddition& m_addition;
    std::string m_folder;
    const Execution& m_execution;
    SealAddendum m_addendum;
    std::vector<PayloadFile> m_files;
};

void requireNames(const SealAddition& addition) {
    const Message remedy{"io.seal.no_name.remedy", "Say who it was.", {}};
    if (!addition.custody && trimmed(addition.by).empty()) {
        throw UsageError(Message{"io.seal.no_author", "An addendum must name who makes it", {}}, remedy);
    }
    if (addition.custody && (trimmed(addition.custody->to).empty() || trimmed(addition.custody->from).empty())) {
        throw UsageError(Message{"io.seal.no_name", "An entry of custody must name who received the bundle, and from whom", {}},
                         remedy);
    }
}

SealRecord newRecord(const std::string& path, const SealCheck& check, const SealAddition& addition) {
    SealRecord record;
    record.number = static_cast<std::int64_t>(check.records.size()) + 1;
    record.isAddendum = !addition.custody;
    record.when = utcNow();
    record.by = addition.by;
    record.before = check.head();
    record.seal = check.sealSha256;
    const std::string& earlier = check.records.empty() ? check.statement.sealedAt : check.records.back().record.when;
    if (record.when < earlier) {
        throw UsageError(
            Message{"io.seal.clock_record",
                    "The clock of this machine says {0}, but the last entry of {1} is of {2}",
                    {record.when, path, earlier}},
            Message{"io.seal.clock_record.remedy", "Set the clock of this machine right, and add the entry then.", {}});
    }
    return record;
}

}  // namespace

AddedRecord addRecord(const std::string& path, const std::string& out, const SealAddition& addition, const Execution& execution) {
    if (!addition.custody && !addition.signer) {
        throw UsageError(Message{"io.seal.addendum_unsigned", "An addendum must be signed by whoever makes it", {}},
                         Message{"io.seal.addendum_unsigned.remedy", "Name your key.", {}});
    }
    requireNames(addition);
    std::optional<Signer> signer;
    if (addition.signer) {
        signer.emplace(*addition.signer);
    }
    const SealCheck check = soundBundle(path, execution);
    SealRecord record = newRecord(path, check, addition);
    const std::string folder = recordFolder(record.number, record.isAddendum);
    LongerBundle longer(path, execution);
    if (addition.custody) {
        record.custody = *addition.custody;
        record.custody.bundleSha256 = sha256OfFile(path, [&](std::size_t) { execution.check(); });
    } else {
        AddendumPacking packing(path, check.statement, addition, folder, execution);
        record.addendum = packing.build();
        for (const PayloadFile& file : packing.files()) {
            record.files[file.place.substr(folder.size())] = file.sha256;
            longer.addFile(file);
        }
    }
    if (signer) {
        record.signer = signer->facts().fingerprint;
    }
    const std::string text = recordText(record) + "\n";
    longer.addText(folder + "record.json", text);
    if (signer) {
        longer.addText(folder + "record.sig", signer->sign(text));
        longer.addText(folder + "public-key.pem", signer->publicKey());
        if (!signer->certificates().empty()) {
            longer.addText(folder + "signer.pem", signer->certificates());
        }
    }
    longer.write(out);
    return {record, sha256OfText(text)};
}

std::vector<JournalChange> differencesToSealed(const std::string& bundle, const std::string& casePath) {
    PackedBag packed(bundle);
    const SealStatement statement = statementFrom(packed.text(bag::statement).value_or(""), bag::statement);
    const std::optional<std::string> theirs = contentOf(casePath);
    if (!theirs) {
        failToRead(casePath);
    }
    return assumptionChanges(packed.text(statement.casePlace).value_or(""), statement.casePlace, *theirs, casePath);
}

std::string timeStampAnswer(const std::string& file) {
    std::optional<std::string> answer = contentOf(file);
    if (!answer) {
        failToRead(file);
    }
    return std::move(*answer);
}

std::string timeStampRequestOf(const std::string& path) {
    PackedBag packed(path);
    if (std::optional<std::string> request = packed.text(bag::stampRequest)) {
        return *request;
    }
    return timeStampRequest(packed.text(bag::signature).value_or(""));
}

void addTimeStamp(const std::string& path, const std::string& out, const std::string& answer, const Execution& execution) {
    soundBundle(path, execution);
    PackedBag packed(path);
    const std::string request = packed.text(bag::stampRequest).value_or("");
    requireStamp(answer, request, packed.text(bag::signature).value_or(""));
    LongerBundle longer(path, execution);
    longer.addText(bag::stampAnswer, answer);
    longer.write(out);
}

}  // namespace rubble::io
