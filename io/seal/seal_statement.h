#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "io/seal/bag.h"

namespace rubble::io {

/// An input of the case as it was sealed.
struct SealedInput {
    std::string id;
    std::string path;  ///< as the case names it
    std::string sha256;
    std::vector<std::string> files;  ///< in the bag, the first is the one to open; empty: it does not travel, only its digests
    Manifest others = {};            ///< of one that does not travel: digests of what is read with it, by path from its folder
};

/// A setting of a run that is not that of the case.
struct OtherSetting {
    std::string key;  ///< "friction"; "scenario": the case has none of that name
    std::string run;
    std::string ofCase;
    friend bool operator==(const OtherSetting&, const OtherSetting&) = default;
};

/// A run as it was sealed.
struct SealedRun {
    std::string place;
    std::string sha256;
    std::string scenario;
    std::string fingerprint;
    std::string trajectoryHash;
    std::string build;
    std::vector<OtherSetting> otherSettings = {};
    std::vector<Message> cautions = {};  ///< what must be known beside its figures; bundles of before say nothing of it
};

/// What a signer states of a bundle: the one text that the signature is of.
struct SealStatement {
    std::string sealedAt;  ///< UTC
    std::string sealedBy;
    std::string note;
    std::string title;
    std::string casePlace;
    std::string caseSha256;
    std::int64_t journalEntries = 0;
    std::string journalHead;  ///< digest of the last entry; empty: there is none
    std::string manifestSha256;
    std::int64_t files = 0;
    std::int64_t bytes = 0;
    Manifest tags;  ///< of the files about the bag that are sealed with it
    std::vector<SealedInput> inputs;
    std::vector<SealedRun> runs;
    std::string build;
    std::string version;
    std::string signer;   ///< fingerprint of the key
    std::string subject;  ///< of the certificate; empty: none
    bool stampAsked = false;
};

/// JSON, sorted.
std::string statementText(const SealStatement& statement);
/// Throws ParseError naming file and place.
SealStatement statementFrom(const std::string& text, const std::string& name);

}  // namespace rubble::io
