#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/scenario/journal.h"
#include "io/seal/seal_statement.h"

namespace rubble::io {

/// Who received a bundle from whom: an entry of its chain of custody, in the terms of ISO/IEC 27037.
struct CustodyEntry {
    std::string from;
    std::string to;
    std::string where;
    std::string why;
    std::string bundleSha256;  ///< of the whole file as it was received, before this entry came into it
};

/// What another expert changed, and what came of it.
struct SealAddendum {
    std::string note;
    std::string casePlace;
    std::vector<JournalChange> differences;  ///< from the sealed case to theirs
    std::vector<SealedInput> inputs;         ///< that the sealed case does not have
    std::vector<SealedRun> runs;
};

/// What was added to a bundle after it was sealed. Each names the digest of the one before, the first that of the statement.
struct SealRecord {
    std::int64_t number = 0;  ///< from 1
    bool isAddendum = false;
    std::string when;  ///< UTC
    std::string by;
    std::string before;
    std::string seal;    ///< digest of the statement
    std::string signer;  ///< fingerprint of the key; empty: not signed
    Manifest files;      ///< that came with it
    CustodyEntry custody;
    SealAddendum addendum;
};

/// The folder of a record in the bag, with its slash.
std::string recordFolder(std::int64_t number, bool isAddendum);
/// What the case of an addendum assumes otherwise than the sealed one, as a record has it. Where a file lies is no assumption.
/// @param sealed  text of the sealed case @param theirs  of the other one @param sealedName, theirsName  for errors
/// Throws ParseError.
std::vector<JournalChange> assumptionChanges(const std::string& sealed, const std::string& sealedName, const std::string& theirs,
                                             const std::string& theirsName);
/// JSON, sorted.
std::string recordText(const SealRecord& record);
/// Throws ParseError naming file and place.
SealRecord recordFrom(const std::string& text, const std::string& name);

}  // namespace rubble::io
