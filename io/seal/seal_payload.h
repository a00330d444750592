#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/scenario/case.h"
#include "io/seal/bag.h"
#include "io/seal/seal_case.h"

namespace rubble::io {

/// A file of the payload: where it comes from, and where it goes.
struct PayloadFile {
    std::string place;   ///< in the bag
    std::string source;  ///< absolute; empty: the text
    std::string text;
    std::uint64_t bytes = 0;
    std::string sha256;
};

/// The files of an input with their places below a folder of the bag; the first is the one to open.
/// Throws UsageError for a name that does not travel.
std::vector<PayloadFile> payloadOfInput(const std::string& folder, const std::string& path, InputRole role);
/// Digests of what filesOfInput() names beside the file of an input, by path from its folder; nothing for an FE result, whose
/// digest is that of all its files, and where the file is not there. Throws WorldError, Cancelled.
Manifest othersOfInput(const std::string& path, InputRole role, const Execution& execution);
/// Takes digest and size of files that have a source.
void takeDigests(std::vector<PayloadFile>& files, const Execution& execution);
/// Packs a file. @param advance  called with the bytes of each block. Throws WorldError if it is not what its digest was taken of.
void packFile(ZipWriter& zip, const std::string& name, const PayloadFile& file, const std::function<void(std::size_t)>& advance);
/// What is said of a complete and sound run of a case. Throws UsageError if it stands on a file that is no input.
/// @param isInput  whether an input has this digest
SealedRun describeRun(const std::string& path, const Case& theCase, const std::function<bool(const std::string&)>& isInput,
                      const Execution& execution);
/// Whether an input of a case, unchanged since it was saved, has a digest, be it of the file alone or with what lies beside it:
/// case and run may keep one each (InputDigest). Looks at the files of site and evidence. Throws WorldError, Cancelled.
bool isInputOfCase(const std::string& casePath, const Case& theCase, const std::string& sha256, const Execution& execution);

/// Everything that goes into the payload of a bundle.
class SealPayload {
public:
    /// Looks for all files and takes their digests. Throws as sealCase().
    SealPayload(const SealRequest& request, const Execution& execution);

    /// A content that comes from no file.
    void addText(const std::string& place, std::string text);

    const std::vector<PayloadFile>& files() const { return m_files; }
    Manifest manifest() const;
    std::uint64_t bytes() const;
    /// What the statement says of case, inputs and runs.
    const SealStatement& statement() const { return m_statement; }
    const Findings& findings() const { return m_findings; }

private:
    void addCase();
    void addNotes();
    void addInputs();
    void addRuns();
    void addExtras();
    std::string addFile(const std::string& place, const std::string& source);
    const SealRequest& m_request;
    const Execution& m_execution;
    std::vector<PayloadFile> m_files;
    SealStatement m_statement;
    Findings m_findings;
};

}  // namespace rubble::io
