#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/finding.h"

namespace rubble::io {

/// Refuses the content of a file. The remedy has the id of the message with ".remedy". Throws ParseError.
[[noreturn]] inline void refuseContent(Message what, std::string_view remedy) {
    std::string id = what.id + ".remedy";
    throw ParseError(std::move(what), {std::move(id), std::string(remedy), {}});
}

/// Counts what was found in a file, with a remedy as above.
inline void addFinding(Findings& findings, const std::string& path, Message what, std::string_view remedy, std::int64_t count = 1) {
    std::string id = what.id + ".remedy";
    findings.add(what, {std::move(id), std::string(remedy), {}}, path, count);
}

}  // namespace rubble::io
