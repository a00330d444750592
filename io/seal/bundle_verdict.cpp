#include "io/seal/bundle_verdict.h"

#include <algorithm>

#include "core/base/error.h"
#include "io/seal/bag.h"

namespace rubble::io {

namespace {

/// What faults and doubts are about.
enum class Area { Container, Files, Signature, Time, Journal, Runs, Records };

Area areaOf(const SealFault& fault, const SealStatement& statement) {
    const std::string& place = fault.place;
    const auto begins = [&](const char* with) { return fault.what.id.starts_with(with); };
    if (place.empty() || begins("io.seal.outside")) {
        return Area::Container;
    }
    if (place.starts_with(bag::records)) {
        return Area::Records;
    }
    if (place == bag::stampAnswer || place == bag::stampRequest || begins("io.seal.future") || begins("io.seal.after_stamp") ||
        begins("io.seal.before_stamp") || begins("io.seal.no_time")) {
        return Area::Time;
    }
    if (begins("io.seal.journal") || begins("io.journal")) {
        return Area::Journal;
    }
    const auto isRun = [&](const SealedRun& run) { return run.place == place; };
    if (std::any_of(statement.runs.begin(), statement.runs.end(), isRun)) {
        return begins("io.seal.other_") ? Area::Runs : Area::Files;
    }
    return place == bag::statement || place == bag::signature || place == bag::publicKey || place == bag::certificates
               ? Area::Signature
               : Area::Files;
}

Message signedBy(const SealCheck& check) {
    const SignerFacts& signer = check.signature.signer;
    return signer.subject.empty()
               ? Message{"io.seal.part_key", "signed by the owner of the key {0}", {signer.fingerprint}}
               : Message{"io.seal.part_certificate", "signed by {0}, key {1}", {signer.subject, signer.fingerprint}};
}

std::vector<SealFault> knownOfRuns(const SealCheck& check) {
    std::vector<SealFault> known;
    const auto add = [&](const std::vector<SealedRun>& runs) {
        for (const SealedRun& run : runs) {
            for (const Message& caution : run.cautions) {
                known.push_back({run.place, caution});
            }
        }
    };
    add(check.statement.runs);
    for (const CheckedRecord& record : check.records) {
        add(record.record.addendum.runs);
    }
    return known;
}

CheckedPart part(Area area, const SealCheck& check) {
    const SealStatement& statement = check.statement;
    const auto some = [](std::size_t count) { return count == 0 ? Proof::Absent : Proof::Holds; };
    switch (area) {
        case Area::Container:
            return {{"io.seal.part.container", "Container", {}},
                    Proof::Holds,
                    {"io.seal.part.container_means", "every byte of the file is as it was written", {}}};
        case Area::Files:
            return {
                {"io.seal.part.files", "Files", {}},
                Proof::Holds,
                {"io.seal.part.files_mean", "{0} files were sealed: none may be altered, left out or put in", {statement.files}}};
        case Area::Signature:
            return {{"io.seal.part.signature", "Statement and signature", {}}, Proof::Holds, signedBy(check)};
        case Area::Time:
            return {{"io.seal.part.time", "Time", {}}, Proof::Holds, sealedWhen(check)};
        case Area::Journal:
            return {{"io.seal.part.journal", "Journal of the case", {}},
                    some(static_cast<std::size_t>(statement.journalEntries)),
                    {"io.seal.part.journal_means",
                     "entries that tell who changed what: {0}; the signature holds the last digest",
                     {statement.journalEntries}}};
        case Area::Runs:
            return {{"io.seal.part.runs", "Runs as sealed", {}},
                    some(statement.runs.size()),
                    {"io.seal.part.runs_mean",
                     "runs in it: {0}; whether they repeat is seen by simulating them again",
                     {statement.runs.size()}}};
        case Area::Records:
            break;
    }
    return {{"io.seal.part.records", "Custody and addenda", {}},
            some(check.records.size()),
            {"io.seal.part.records_mean",
             "entries since it was sealed: {0}, each with the digest of the one before",
             {check.records.size()}}};
}

}  // namespace

Message sealedWhen(const SealCheck& check) {
    return check.stamp && check.stamp->matches
               ? Message{"io.seal.part_stamped", "seen by {0} on {1}", {check.stamp->service, utcOfSeconds(check.stamp->time)}}
               : Message{"io.seal.part_time", "sealed on {0}, as the signer says", {check.statement.sealedAt}};
}

Message RepeatedRun::difference() const {
    if (!notSimulated.empty()) {
        return notSimulated;
    }
    if (!repeat.firstDifference.empty()) {
        return repeat.firstDifference;
    }
    for (const RepeatedFigure& figure : repeat.figures) {
        if (!figure.same()) {
            return {"io.seal.first_figure",
                    "The first difference is the {0}: recorded {1}, now {2}.",
                    {figure.name, figure.recorded, figure.found}};
        }
    }
    return {};
}

std::vector<RepeatedRun> repeatRuns(const UnpackedBundle& unpacked, const Execution& execution) {
    std::vector<RepeatedRun> list;
    for (const SealedRun& run : unpacked.runs()) {
        try {
            list.push_back({run, unpacked.repeat(run, execution)});
        } catch (const WorldError& error) {
            // What was checked is told all the same.
            list.push_back({run, {}, error.message(), error.remedy()});
        }
    }
    return list;
}

std::vector<CheckedPart> checkedParts(const SealCheck& check) {
    std::vector<CheckedPart> parts;
    for (const Area area : {Area::Container, Area::Files, Area::Signature, Area::Time, Area::Journal, Area::Runs, Area::Records}) {
        CheckedPart each = part(area, check);
        for (const auto& [list, proof] : {std::pair{&check.faults, Proof::Fails}, {&check.doubts, Proof::Unproven}}) {
            for (const SealFault& fault : *list) {
                if (areaOf(fault, check.statement) == area) {
                    each.proof = each.said.empty() ? proof : each.proof;
                    each.said.push_back(fault);
                    each.faults += proof == Proof::Fails ? 1 : 0;
                }
            }
        }
        if (area == Area::Runs) {
            each.known = knownOfRuns(check);
        }
        parts.push_back(std::move(each));
    }
    return parts;
}

Message proofText(Proof proof) {
    switch (proof) {
        case Proof::Holds:
            return {"io.seal.proof.holds", "holds", {}};
        case Proof::Unproven:
            return {"io.seal.proof.unproven", "not proven", {}};
        case Proof::Fails:
            return {"io.seal.proof.fails", "does not hold", {}};
        case Proof::Absent:
            break;
    }
    return {"io.seal.proof.absent", "not there", {}};
}

Message bundleVerdict(const SealCheck& check, const std::vector<RepeatedRun>& repeats, bool simulated) {
    if (!check.sound()) {
        return {"io.seal.verdict.altered", "not as it was sealed", {}};
    }
    for (const RepeatedRun& each : repeats) {
        if (!each.notSimulated.empty()) {
            return {"io.seal.verdict.not_simulated", "as it was sealed, but a run could not be simulated", {}};
        }
        if (!each.repeat.equal) {
            return {"io.seal.verdict.differs", "as it was sealed, but a run does not repeat", {}};
        }
    }
    if (!repeats.empty()) {
        return {"io.seal.verdict.equal", "as it was sealed; every run is equal", {}};
    }
    return simulated ? Message{"io.seal.verdict.no_run", "as it was sealed; it holds no run", {}}
                     : Message{"io.seal.verdict.checked", "as it was sealed; nothing was simulated", {}};
}

}  // namespace rubble::io
