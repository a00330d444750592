#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/finding.h"

namespace rubble::io {

/// The files that differ from this one only in a number, by that number; the file alone if there is none. The number may stand
/// before the ending (s001.vtu) or be the ending (out.vtk.1).
std::vector<std::string> numberedSiblings(const std::string& path);

/// Numbers that a series lacks.
struct NumberGap {
    std::string before;      ///< the file behind the gap
    std::int64_t count = 0;  ///< files that are not there
};

/// Gaps between numbered siblings: where the smallest step between neighbours divides all steps, and most are that one. Series
/// whose numbers come otherwise, such as those of iterations, have none.
std::vector<NumberGap> numberGaps(const std::vector<std::string>& siblings);
/// Adds a finding for each.
void noteNumberGaps(const std::vector<std::string>& siblings, Findings& findings);

/// Whether a file is there and holds nothing.
bool isEmptyFile(const std::string& path);
/// Throws ParseError for an empty file of a series that is not its last, which may still be being written: its state is lost.
void requireNotEmpty(const std::string& path);

/// The names of files for people, the first three and how many there are: "s0.vtu, s1.vtu, s2.vtu, ... (12 files)".
std::string takenForStates(const std::vector<std::string>& files);
/// Whether a name stands before another one where numbers in them count as numbers: "step 9" before "step 10".
bool naturallyBefore(const std::string& a, const std::string& b);
/// A file that another one names: where it says, else beside that one, since results are moved together. Folders may be parted as
/// on Windows. What is in neither place is given where it should be.
std::string namedFile(const std::string& owner, const std::string& named);

/// The regular files of the folder that a path lies in, each as it would be given beside that path, sorted. Never throws.
std::vector<std::string> filesBeside(const std::string& path);

}  // namespace rubble::io
