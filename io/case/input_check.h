#pragma once

#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/scenario/case.h"

namespace rubble::io {

/// What lies where a case says that an input is.
struct FoundInput {
    std::string id;    ///< of the input
    std::string path;  ///< absolute
    bool exists = false;
    std::string sha256;  ///< hex; empty if nothing could be read there
    friend bool operator==(const FoundInput&, const FoundInput&) = default;
};

/// SHA-256 of a file in the role of an input: of all files of its series for an FE result, of the file itself for others.
/// Throws WorldError, ParseError, Cancelled.
std::string sha256OfInput(const std::string& path, InputRole role, const Execution& execution);

/// Looks for an input of a case and reads its SHA-256 where the case keeps one to compare with. Never throws but Cancelled.
/// @param known  its SHA-256 if it was read already
FoundInput findInput(const std::string& casePath, const CaseInput& input, const std::string& known, const Execution& execution);

}  // namespace rubble::io
