#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "io/seal/seal_statement.h"
#include "io/seal/signature.h"

namespace rubble::io {

/// A file that goes into a bundle beside case, inputs and runs.
struct SealedExtra {
    std::string folder;  ///< in the bag: "exports", "report", "page"
    std::string path;    ///< a file, or a folder with all in it
};

/// Asks a service for a time stamp: takes the request, gives the answer, both in DER.
using StampService = std::function<std::string(const std::string& request)>;

/// What is sealed, by whom.
struct SealRequest {
    std::string casePath;
    std::vector<std::string> runs;      ///< run files that are complete and of this case
    std::vector<std::string> leftHome;  ///< ids of inputs that do not travel: only their digests do
    std::vector<SealedExtra> extras;
    std::string by;    ///< who seals; empty: nobody is named
    std::string note;  ///< why, in their words
    SignerFiles signer;
    bool stampRequest = false;  ///< a request for a time stamp is put in, to be answered later
    StampService service;       ///< unset: nobody is asked now
};

/// What was sealed.
struct SealReport {
    SealStatement statement;
    std::string sealSha256;    ///< of the statement: what custody and addenda name
    std::string stampRequest;  ///< DER; empty: none
    Findings findings;
};

/// Packs a case with its journal, its inputs, runs and what was made of them into one bundle: a bag (BagIt, RFC 8493) in a zip
/// container, with a statement that the signer signs. Atomic. Files that change while they are sealed are an error.
/// Throws UsageError (an input that is not what the case was saved with, a run of another case or without end, a clock that is
/// behind the journal), WorldError, ParseError, Cancelled.
SealReport sealCase(const std::string& path, const SealRequest& request, const Execution& execution);

}  // namespace rubble::io
