#pragma once

#include <string>
#include <vector>

namespace rubble::io {

/// What the name of an Exodus file says of the files that it belongs to.
struct ExodusName {
    std::string base;    ///< "out.e" of "out.e-s0003.4.2"
    int number = 1;      ///< 3: of a sequence written at changes of topology
    int processors = 0;  ///< 4: each wrote a file of its own; 0: the name knows none
    int processor = 0;   ///< 2
};
/// @param path  with or without a folder
ExodusName exodusName(const std::string& path);

/// All files of a sequence written at changes of topology (out.e, out.e-s0002, ...), in order; the first is out.e where it is
/// there. A file that belongs to no sequence stands alone. Never throws.
std::vector<std::string> exodusSequence(const std::string& path);

/// The sequences of all processors that a name tells of, each in its order; empty lists for those that are not there; no lists for
/// a name without processors. Never throws.
std::vector<std::vector<std::string>> exodusPieces(const std::string& path);
/// The name that the first file of a processor should have.
std::string exodusPieceName(const std::string& path, int processor);

}  // namespace rubble::io
