#include "io/seal/seal_check.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/build.h"
#include "core/base/error.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/base/files.h"
#include "io/base/sha256.h"
#include "io/base/trimmed.h"
#include "io/case/journal_check.h"
#include "io/exports/report_notes.h"
#include "io/seal/bag.h"
#include "io/seal/earlier_bundle.h"
#include "io/seal/time_stamp.h"

namespace rubble::io {

namespace {

/// s between what a signer and a service say of one moment: sealing and asking take a while, and clocks differ.
constexpr double clockTolerance = 600.0;
constexpr double secondsOfDay = 86400.0;

/// Checks one bundle, part by part.
class BundleCheck {
public:
    BundleCheck(PackedBag& packed, const SealTrust& trust, const Execution& execution)
        : m_bag(packed), m_trust(trust), m_execution(execution) {}

    SealCheck check() {
        readEverything();
        readStatement();
        checkManifests();
        checkPlaces();
        if (m_stated) {
            checkStatement();
            checkSignature();
            checkJournal();
            checkNotes();
            checkRuns();
        }
        checkRecords();
        checkKnown();
        return std::move(m_check);
    }

private:
    void fault(const std::string& place, Message what) { m_check.faults.push_back({place, std::move(what)}); }
    void doubt(const std::string& place, Message what) { m_check.doubts.push_back({place, std::move(what)}); }

    void readEverything();
    void readStatement();
    std::optional<Manifest> readManifest(const char* place);
    void checkManifests();
    void checkListed(const Manifest& manifest, bool payload);
    void checkPlaces();
    void checkStatement();
    void checkSignature();
    void checkStamp(const std::string& signature);
    void checkTimes();
    void checkJournal();
    void checkNotes();
    void checkRuns();
    void checkSettings(const SealedRun& run);
    void checkRecords();
    void checkRecord(const std::string& place, std::int64_t number);
    void checkCustody(const SealRecord& record, const std::string& place, const std::string& folder);
    void checkAddendum(const SealRecord& record, const std::string& place);
    void checkSignatureOf(CheckedRecord& checked, const std::string& folder, const std::string& text);
    void checkKnown();
    std::string textOr(const std::string& place);

    PackedBag& m_bag;
    const SealTrust& m_trust;
    const Execution& m_execution;
    SealCheck m_check;
    Manifest m_found;  ///< SHA-256 of everything that lies in the bag
    std::set<std::string> m_damaged;
    bool m_stated = false;
};

/// Each entry once: its digest, and the container around it.
void BundleCheck::readEverything() {
    ZipLayout layout;
    double all = 1.0, done = 0.0;
    for (const ZipReader::Entry& entry : m_bag.entries()) {
        all += static_cast<double>(entry.bytes);
    }
    for (const ZipReader::Entry& entry : m_bag.entries()) {
        const std::string place = m_bag.placeOf(entry);
        if (!isBagPlace(place)) {
            fault(entry.name, {"io.seal.outside", "put in: it lies outside of the bag", {}});
            m_damaged.insert(entry.name);
            continue;
        }
        // Behind what is damaged the container cannot be laid out, but the files can be read.
        const bool laidOut = m_damaged.empty();
        Sha256 digest;
        try {
            if (laidOut) {
                layout.open(entry.name, entry.bytes);
            }
            m_bag.zip().read(entry, [&](const char* data, std::size_t size) {
                digest.add(data, size);
                if (laidOut) {
                    layout.write(data, size);
                }
                done += static_cast<double>(size);
                m_execution.report({"io.seal.checking", "Checking the bundle", {}}, std::min(1.0, done / all));
            });
            if (laidOut) {
                layout.close();
            }
        } catch (const ParseError&) {
            fault(place, {"io.seal.damaged", "damaged: it cannot be unpacked", {}});
            m_damaged.insert(place);
            continue;
        }
        if (!m_found.emplace(place, digest.hex()).second) {
            fault(place, {"io.seal.twice", "put in: it lies in the container twice", {}});
        }
    }
    if (!m_damaged.empty()) {
        return;
    }
    if (const std::optional<std::uint64_t> byte = layout.firstDifference(m_bag.path())) {
        fault({}, {"io.seal.container",
                   "the container was packed anew or altered, first at byte {0}; what lies in it is told of by the rest",
                   {static_cast<std::int64_t>(*byte)}});
    }
}

std::string BundleCheck::textOr(const std::string& place) {
    try {
        return m_bag.text(place).value_or("");
    } catch (const ParseError&) {
        return {};
    }
}

void BundleCheck::readStatement() {
    const std::string text = textOr(bag::statement);
    m_check.sealSha256 = sha256OfText(text);
    if (text.empty()) {
        if (!m_damaged.contains(bag::statement)) {
            fault(bag::statement, {"io.seal.no_statement", "the statement of the signer is missing", {}});
        }
        return;
    }
    try {
        m_check.statement = statementFrom(text, bag::statement);
        m_stated = true;
    } catch (const ParseError& error) {
        fault(bag::statement, error.message());
    }
}

std::optional<Manifest> BundleCheck::readManifest(const char* place) {
    const std::string text = textOr(place);
    const std::optional<Manifest> manifest = manifestOf(text);
    if (m_damaged.contains(place)) {
        return {};
    }
    if (!manifest || manifest->empty() || manifestText(*manifest) != text) {
        fault(place, {"io.seal.no_list", "it is missing, or no list of files as it was written", {}});
        return {};
    }
    return manifest;
}

void BundleCheck::checkManifests() {
    const std::optional<Manifest> payload = readManifest(bag::manifest), tags = readManifest(bag::tagManifest);
    if (payload) {
        checkListed(*payload, true);
    }
    if (tags) {
        checkListed(*tags, false);
    }
    if (!m_damaged.contains(bag::declaration) && textOr(bag::declaration) != bagDeclaration()) {
        fault(bag::declaration, {"io.seal.declaration", "it is not what BagIt asks for", {}});
    }
}

void BundleCheck::checkListed(const Manifest& manifest, bool payload) {
    for (const auto& [place, digest] : manifest) {
        const auto found = m_found.find(place);
        if (found == m_found.end()) {
            if (!m_damaged.contains(place)) {
                fault(place, {"io.seal.missing", "left out: the list of files names it", {}});
            }
        } else if (found->second != digest) {
            fault(place, {"io.seal.altered", "altered: its SHA-256 is {0}, the list of files says {1}", {found->second, digest}});
        }
    }
    for (const auto& [place, digest] : m_found) {
        if (place.starts_with(bag::payload) == payload && place != bag::tagManifest && !manifest.contains(place)) {
            fault(place, {"io.seal.unlisted", "put in: the list of files does not name it", {}});
        }
    }
}

/// Whoever lists a file about the bag anew can put one in: only these belong there.
void BundleCheck::checkPlaces() {
    std::set<std::string> known{bag::declaration,  bag::about,        bag::manifest,   bag::tagManifest,
                                bag::readme,       bag::statement,    bag::signature,  bag::publicKey,
                                bag::certificates, bag::stampRequest, bag::stampAnswer};
    for (const auto& [place, digest] : m_check.statement.tags) {
        known.insert(place);
    }
    for (const auto& [place, digest] : m_found) {
        if (!place.starts_with(bag::payload) && !place.starts_with(bag::records) && !known.contains(place)) {
            fault(place, {"io.seal.unknown_place", "put in: nothing of a sealed bundle lies there", {}});
        }
    }
}

void BundleCheck::checkStatement() {
    const SealStatement& statement = m_check.statement;
    const auto sealed = [&](const std::string& place, const std::string& digest) {
        const auto found = m_found.find(place);
        if (m_damaged.contains(place)) {
            return;  // said already
        }
        if (found == m_found.end() || found->second != digest) {
            fault(place, {"io.seal.not_as_signed", "not what was signed: the statement names the SHA-256 {0}", {digest}});
        }
    };
    sealed(bag::manifest, statement.manifestSha256);
    sealed(statement.casePlace, statement.caseSha256);
    for (const auto& [place, digest] : statement.tags) {
        sealed(place, digest);
    }
    for (const SealedRun& run : statement.runs) {
        sealed(run.place, run.sha256);
    }
    std::int64_t files = 0;
    for (const auto& [place, digest] : m_found) {
        files += place.starts_with(bag::payload) ? 1 : 0;
    }
    files +=
        std::count_if(m_damaged.begin(), m_damaged.end(), [](const std::string& place) { return place.starts_with(bag::payload); });
    if (files != statement.files) {
        fault(bag::payload, {"io.seal.count", "{0} files lie in it, and {1} were sealed", {files, statement.files}});
    }
}

void BundleCheck::checkSignature() {
    const SealStatement& statement = m_check.statement;
    const std::string signature = textOr(bag::signature);
    checkStamp(signature);
    std::time_t at = secondsOfUtc(statement.sealedAt).value_or(0);
    if (m_check.stamp && m_check.stamp->matches) {
        at = m_check.stamp->time;
    }
    m_check.signature =
        verifySignature(textOr(bag::statement), signature, textOr(bag::publicKey), textOr(bag::certificates), m_trust.signer, at);
    const SignatureCheck& checked = m_check.signature;
    if (!checked.fault.empty()) {
        fault(bag::signature, checked.fault);
    }
    if (!checked.doubt.empty()) {
        doubt(bag::signature, checked.doubt);
    }
    if (checked.matches && (checked.signer.fingerprint != statement.signer || checked.signer.subject != statement.subject)) {
        fault(bag::publicKey, {"io.seal.key_other", "the key or certificate is not the one that the statement names", {}});
    }
    checkTimes();
}

void BundleCheck::checkStamp(const std::string& signature) {
    const std::string answer = textOr(bag::stampAnswer), request = textOr(bag::stampRequest);
    if (m_check.statement.stampAsked && request.empty() && !m_damaged.contains(bag::stampRequest)) {
        fault(bag::stampRequest, {"io.seal.request_missing", "left out: the request for the time stamp was sealed with it", {}});
    } else if (!request.empty() && !m_damaged.contains(bag::signature) && !isRequestFor(request, signature)) {
        fault(bag::stampRequest, {"io.seal.request_of_another", "it asks for a time stamp of something else", {}});
    }
    if (answer.empty()) {
        doubt(bag::stampAnswer,
              m_check.statement.stampAsked
                  ? Message{"io.seal.stamp_missing",
                            "a time stamp was asked for when it was sealed, and none is here; until its answer is "
                            "put in, the time of sealing is the signer's word",
                            {}}
                  : Message{"io.seal.no_stamp", "there is no time stamp: the time of sealing is the signer's word", {}});
        return;
    }
    m_check.stamp = checkTimeStamp(answer, request, signature, m_trust.stampRoots);
    if (!m_check.stamp->fault.empty()) {
        fault(bag::stampAnswer, m_check.stamp->fault);
    }
    if (!m_check.stamp->doubt.empty()) {
        doubt(bag::stampAnswer, m_check.stamp->doubt);
    }
}

void BundleCheck::checkTimes() {
    const std::string& sealedAt = m_check.statement.sealedAt;
    const std::optional<std::time_t> sealed = secondsOfUtc(sealedAt);
    if (!sealed) {
        fault(bag::statement, {"io.seal.no_time", "its time of sealing is none: {0}", {sealedAt}});
        return;
    }
    if (sealedAt > utcNow()) {
        doubt(bag::statement, {"io.seal.future", "sealed on {0}, which the clock of this machine has not reached", {sealedAt}});
    }
    if (!m_check.stamp || !m_check.stamp->matches) {
        return;
    }
    const double late = std::difftime(m_check.stamp->time, *sealed);
    const std::string stamped = utcOfSeconds(m_check.stamp->time);
    if (late < -clockTolerance) {
        fault(bag::statement, {"io.seal.after_stamp",
                               "sealed on {0} by its own word, but the time stamp saw it before, on {1}",
                               {sealedAt, stamped}});
    } else if (late > clockTolerance) {
        doubt(bag::statement, {"io.seal.before_stamp",
                               "sealed on {0} by its own word; the time stamp proves it only for {1}, {2} later",
                               {sealedAt, stamped, Argument(late / secondsOfDay, "d")}});
    }
}

void BundleCheck::checkJournal() {
    const SealStatement& statement = m_check.statement;
    const std::string& place = statement.casePlace;
    JournalCheck journal;
    try {
        journal = checkJournalText(textOr(place), place);
    } catch (const Error& error) {
        fault(place, error.message());
        return;
    }
    if (journal.head != statement.journalHead || static_cast<std::int64_t>(journal.entries) != statement.journalEntries) {
        fault(place,
              {"io.seal.journal_head",
               "the journal is not the one that was sealed: {0} entries with the head {1}, sealed were {2} with the head {3}",
               {static_cast<std::int64_t>(journal.entries), journal.head, statement.journalEntries, statement.journalHead}});
    }
    // A case that was sealed as it is now was no other then.
    const auto found = m_found.find(place);
    const bool asSealed = found != m_found.end() && found->second == statement.caseSha256;
    std::vector<SealFault>& told = asSealed ? m_check.doubts : m_check.faults;
    for (const std::size_t entry : journal.broken) {
        told.push_back(
            {place, {"io.seal.journal_entry", "entry {0} of the journal was altered, or misses the one before", {entry}}});
    }
    for (const JournalChange& change : journal.altered) {
        told.push_back({place, {"io.seal.journal_place", "{0} is not what the journal says", {change.place}}});
    }
    for (const std::size_t entry : journal.backward) {
        doubt(place, {"io.seal.journal_clock", "entry {0} of the journal is of a time before that of an earlier one", {entry}});
    }
    if (journal.last > statement.sealedAt) {
        fault(place, {"io.seal.journal_later",
                      "the journal goes on until {0}, after the time of sealing, {1}",
                      {journal.last, statement.sealedAt}});
    }
}

/// Words of the author are opened with the case: others than those that were sealed must not pass for them.
void BundleCheck::checkNotes() {
    const std::string place = reportNotesPath(m_check.statement.casePlace);
    if (!m_found.contains(place)) {
        return;
    }
    try {
        reportNotesFrom(textOr(place), place);
        m_check.notes = place;
    } catch (const ParseError& error) {
        fault(place, error.message());
    }
}

void BundleCheck::checkSettings(const SealedRun& run) {
    for (const OtherSetting& setting : run.otherSettings) {
        doubt(run.place, {"io.seal.other_setting",
                          "made with {0} = {1}, where the case has {2}",
                          {setting.key, setting.run, setting.ofCase.empty() ? "-" : setting.ofCase}});
    }
}

void BundleCheck::checkRuns() {
    for (const SealedRun& run : m_check.statement.runs) {
        checkSettings(run);
        if (run.build != buildText()) {
            doubt(run.place, {"io.seal.other_build",
                              "made by another build than this program, so its bits need not repeat here: {0}",
                              {run.build}});
        }
    }
}

void BundleCheck::checkRecords() {
    std::int64_t number = 0;
    for (const auto& [place, digest] : m_found) {
        if (place.starts_with(bag::records) && place.ends_with("/record.json")) {
            checkRecord(place, ++number);
        }
    }
    std::set<std::string> told;
    for (const CheckedRecord& checked : m_check.records) {
        const std::string folder = recordFolder(checked.record.number, checked.record.isAddendum);
        for (const auto& [place, digest] : checked.record.files) {
            told.insert(folder + place);
            const auto found = m_found.find(folder + place);
            if (found == m_found.end() || found->second != digest) {
                fault(folder + place, {"io.seal.record_file",
                                       "altered or left out: record {0} names the SHA-256 {1}",
                                       {checked.record.number, digest}});
            }
        }
        told.insert(folder + "record.json");
        if (!checked.record.signer.empty()) {
            told.insert({folder + "record.sig", folder + "public-key.pem"});
        }
        if (checked.signature && !checked.signature->signer.subject.empty()) {
            told.insert(folder + "signer.pem");
        }
    }
    for (const auto& [place, digest] : m_found) {
        if (place.starts_with(bag::records) && !told.contains(place)) {
            fault(place, {"io.seal.record_extra", "put in: no record names it", {}});
        }
    }
}

void BundleCheck::checkRecord(const std::string& place, std::int64_t number) {
    const std::string text = textOr(place);
    CheckedRecord checked;
    try {
        checked.record = recordFrom(text, place);
    } catch (const ParseError& error) {
        fault(place, error.message());
        return;
    }
    checked.sha256 = sha256OfText(text);
    const SealRecord& record = checked.record;
    const std::string folder = recordFolder(record.number, record.isAddendum);
    if (record.number != number || place != folder + "record.json") {
        fault(place, {"io.seal.record_number",
                      "a record was left out or moved: this is the {0}. by its place, and says {1}",
                      {number, record.number}});
    }
    if (record.before != m_check.head() || record.seal != m_check.sealSha256) {
        fault(place, {"io.seal.record_chain", "it does not follow the record before it: one was altered or left out", {}});
    }
    const std::string& earlier = m_check.records.empty() ? m_check.statement.sealedAt : m_check.records.back().record.when;
    if (record.when < earlier) {
        fault(place, {"io.seal.record_clock", "it is of {0}, before what it follows, {1}", {record.when, earlier}});
    }
    if (record.when > utcNow()) {
        doubt(place, {"io.seal.record_future", "it is of {0}, which the clock of this machine has not reached", {record.when}});
    }
    if (record.isAddendum) {
        checkAddendum(record, place);
    } else {
        checkCustody(record, place, folder);
    }
    checkSignatureOf(checked, folder, text);
    m_check.records.push_back(std::move(checked));
}

/// Equal files make equal containers, so the one that was received is made again, and its digest with it.
void BundleCheck::checkCustody(const SealRecord& record, const std::string& place, const std::string& folder) {
    const CustodyEntry& entry = record.custody;
    if (trimmed(entry.from).empty() || trimmed(entry.to).empty()) {
        fault(place, {"io.seal.nobody", "it does not name who received the bundle, and from whom", {}});
    }
    // What is altered already would be told once more by each entry.
    if (!m_check.faults.empty()) {
        return;
    }
    const EarlierBundle earlier = bundleBefore(m_bag, folder, m_execution);
    if (earlier.sha256 == entry.bundleSha256) {
        return;
    }
    if (earlier.stampedLater) {
        doubt(place, {"io.seal.custody_stamped",
                      "the SHA-256 of what was received, {0}, cannot be proven: a time stamp was put in afterwards",
                      {entry.bundleSha256}});
    } else {
        fault(place, {"io.seal.custody_digest",
                      "what was received had the SHA-256 {0}, and not {1}, which it names",
                      {earlier.sha256, entry.bundleSha256}});
    }
}

/// What an expert changed is seen in both cases, whatever a record says.
void BundleCheck::checkAddendum(const SealRecord& record, const std::string& place) {
    const SealAddendum& addendum = record.addendum;
    const std::string& sealed = m_check.statement.casePlace;
    try {
        if (assumptionChanges(textOr(sealed), sealed, textOr(addendum.casePlace), addendum.casePlace) != addendum.differences) {
            fault(place, {"io.seal.differences", "it does not list what its case assumes otherwise than the sealed one", {}});
        }
    } catch (const ParseError& error) {
        fault(addendum.casePlace, error.message());
    }
    for (const SealedRun& run : addendum.runs) {
        checkSettings(run);
    }
}

void BundleCheck::checkSignatureOf(CheckedRecord& checked, const std::string& folder, const std::string& text) {
    const SealRecord& record = checked.record;
    if (record.signer.empty()) {
        doubt(folder + "record.json", {"io.seal.record_unsigned", "the record of {0} is not signed", {record.by}});
        return;
    }
    checked.signature =
        verifySignature(text, textOr(folder + "record.sig"), textOr(folder + "public-key.pem"), textOr(folder + "signer.pem"),
                        {m_trust.signer.roots, {}}, secondsOfUtc(record.when).value_or(0));
    if (!checked.signature->fault.empty()) {
        fault(folder + "record.sig", checked.signature->fault);
    } else if (checked.signature->signer.fingerprint != record.signer) {
        fault(folder + "public-key.pem",
              {"io.seal.key_other", "the key or certificate is not the one that the statement names", {}});
    }
    if (!checked.signature->doubt.empty()) {
        doubt(folder + "record.sig", checked.signature->doubt);
    }
}

void BundleCheck::checkKnown() {
    const std::string& known = m_trust.known;
    const bool there = known.empty() || known == m_check.sealSha256 ||
                       std::any_of(m_check.records.begin(), m_check.records.end(),
                                   [&](const CheckedRecord& each) { return each.sha256 == known; });
    if (!there) {
        fault(bag::records,
              {"io.seal.known_missing", "neither the statement nor a record has the digest {0} that is known of it", {known}});
    }
}

}  // namespace

SealCheck checkBundle(const std::string& path, const SealTrust& trust, const Execution& execution) {
    PackedBag packed(path);
    return BundleCheck(packed, trust, execution).check();
}

}  // namespace rubble::io
