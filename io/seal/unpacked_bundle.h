#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "io/seal/run_repeat.h"
#include "io/seal/seal_check.h"

namespace rubble::io {

/// A folder for what nobody asked to keep, among the system's temporary files; removed with all in it.
class ScratchFolder {
public:
    /// Throws WorldError if none can be made.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::string& path() const { return m_path; }

private:
    std::string m_path;
};

/// All inputs of a bundle, those of addenda too.
std::vector<SealedInput> inputsOf(const SealCheck& check);
/// Whether a file is the input that was sealed under an id. Throws UsageError if there is no such input or it has another digest,
/// and as digestOfInput(). Returns the digest.
std::string checkLocated(const SealCheck& check, const std::string& id, const std::string& path, const Execution& execution);

/// A bundle whose files lie in a folder, to be read only.
class UnpackedBundle {
public:
    /// Unpacks into a folder that is empty or not there; what was written is removed again on an error. Files cannot be written.
    /// @param check  of the same bundle, which must be sound
    /// Throws UsageError (the folder holds something), WorldError, ParseError, Cancelled.
    UnpackedBundle(const std::string& bundle, const SealCheck& check, const std::string& folder, const Execution& execution);

    /// Says where an input is that did not travel. Throws as checkLocated().
    void locate(const std::string& id, const std::string& path, const Execution& execution);

    std::string pathOf(const std::string& place) const { return m_folder + "/" + place; }
    const std::string& folder() const { return m_folder; }  ///< of the bag
    /// Absolute path of the input with a digest; empty: it did not travel and nobody said where it is.
    std::string inputWith(const std::string& sha256) const;

    /// Writes the case to be worked on: as it was sealed, with the paths of its inputs as they are now, which its journal says.
    /// @param addendum  number of the record whose case is meant; 0: the sealed one
    /// Throws UsageError (there is no such addendum), WorldError.
    void writeWorkingCase(const std::string& path, std::int64_t addendum = 0) const;

    /// All runs, those of addenda too, in the order in which they were sealed.
    std::vector<SealedRun> runs() const;
    /// Simulates a run again. Throws WorldError for inputs that are not there, ParseError, Cancelled, and what run() throws.
    RunRepeat repeat(const SealedRun& run, const Execution& execution) const;

private:
    void unpack(const std::string& bundle, const Execution& execution);
    /// Absolute path of an input; empty as inputWith().
    std::string placeOf(const SealedInput& input) const;
    /// inputWith() of a digest that a run keeps, which may be of the file alone where that of the case is not, and the other way.
    std::string inputOfRun(const std::string& sha256, const Execution& execution) const;

    const SealCheck& m_check;
    std::string m_folder;
    std::map<std::string, std::string> m_located;  ///< by digest
};

}  // namespace rubble::io
