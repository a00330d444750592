#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "io/seal/seal_check.h"
#include "io/seal/seal_record.h"
#include "io/seal/signature.h"

namespace rubble::io {

/// What is added to a bundle: who received it, or what another expert changed.
struct SealAddition {
    std::string by;                       ///< who adds it
    std::optional<SignerFiles> signer;    ///< unset: not signed, which an addendum must be
    std::optional<CustodyEntry> custody;  ///< set: who received it; the digest of the bundle is taken here
    std::string casePath;                 ///< of an addendum: the other expert's case
    std::vector<std::string> runs;        ///< of an addendum: run files of that case
    std::string note;                     ///< of an addendum: why
};

/// What a case assumes otherwise than the sealed one of a bundle, before an addendum is made of it. Throws ParseError, WorldError.
std::vector<JournalChange> differencesToSealed(const std::string& bundle, const std::string& casePath);

/// A record as it was added.
struct AddedRecord {
    SealRecord record;
    std::string sha256;  ///< what the next one names
};

/// Adds a record to a sound bundle, at the end of its chain. Nothing that was sealed is touched. Atomic.
/// @param path  of the bundle @param out  where the longer bundle is written; may be the same
/// Throws UsageError (a bundle that is not sound, a clock that is behind its last record, an addendum that changes nothing),
/// WorldError, ParseError, Cancelled.
AddedRecord addRecord(const std::string& path, const std::string& out, const SealAddition& addition, const Execution& execution);

/// Puts the answer of a time-stamping service into a bundle. @param answer  DER
/// Throws as addRecord(), and ParseError for an answer that is not of this bundle.
void addTimeStamp(const std::string& path, const std::string& out, const std::string& answer, const Execution& execution);

/// The answer of a service as it lies in a file. Throws WorldError.
std::string timeStampAnswer(const std::string& file);

/// The request for a time stamp of a bundle: the one that lies in it, else a new one. Throws ParseError.
std::string timeStampRequestOf(const std::string& path);

}  // namespace rubble::io
