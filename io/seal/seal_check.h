#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "io/seal/seal_record.h"
#include "io/seal/signature.h"
#include "io/seal/time_stamp.h"

namespace rubble::io {

/// Something in a bundle that is not as it was sealed, or that is not proven.
struct SealFault {
    std::string place;  ///< in the bag; empty: the container
    Message what;
};

/// Whom somebody who opens a bundle trusts, and what they know of it from elsewhere.
struct SealTrust {
    TrustedSigners signer;
    std::string stampRoots;  ///< file with certificates in PEM that vouch for the time-stamping service; empty: none
    std::string known;       ///< digest of the statement or of a record that the bundle must hold, hex; empty: none
};

/// A record and what its signature says.
struct CheckedRecord {
    SealRecord record;
    std::string sha256;
    std::optional<SignatureCheck> signature;  ///< unset: it has none
};

/// What comes of checking a bundle.
struct SealCheck {
    SealStatement statement;  ///< empty where it cannot be read
    std::string sealSha256;
    SignatureCheck signature;
    std::optional<StampCheck> stamp;     ///< unset: there is none
    std::vector<CheckedRecord> records;  ///< in their order
    std::vector<SealFault> faults;       ///< what is not as it was sealed
    std::vector<SealFault> doubts;       ///< what nothing in the bundle proves
    std::string notes;                   ///< where the words of the report's author lie; empty: none were sealed

    bool sound() const { return faults.empty(); }
    /// Digest that the next record names.
    const std::string& head() const { return records.empty() ? sealSha256 : records.back().sha256; }
};

/// Holds every byte of a bundle against what was sealed: container, lists of files, statement, signature, time stamp, journal and
/// records. Nothing is unpacked and nothing simulated. Throws WorldError, ParseError (no bundle, cut short), Cancelled; and for
/// what is trusted as verifySignature().
SealCheck checkBundle(const std::string& path, const SealTrust& trust, const Execution& execution);

}  // namespace rubble::io
