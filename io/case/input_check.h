#pragma once

#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/scenario/case.h"
#include "io/site/input_files.h"

namespace rubble::io {

/// What lies where a case says that an input is.
struct FoundInput {
    std::string id;    ///< of the input
    std::string path;  ///< absolute
    bool exists = false;
    std::string sha256;  ///< hex, as the case keeps it if it is unchanged (InputDigest); empty if nothing could be read there
    friend bool operator==(const FoundInput&, const FoundInput&) = default;
};

/// Looks for an input of a case and reads its SHA-256 where the case keeps one to compare with. Never throws but Cancelled.
/// @param known  its digest if it was read already, else empty
FoundInput findInput(const std::string& casePath, const CaseInput& input, const InputDigest& known, const Execution& execution);

}  // namespace rubble::io
