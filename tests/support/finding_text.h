#pragma once

#include <string>
#include <string_view>

#include "core/base/finding.h"

namespace rubble {

/// English remedy of the finding with this id; empty: there is none.
inline std::string remedyOf(const Findings& findings, std::string_view id) {
    for (const Finding& finding : findings.list()) {
        if (finding.what.id == id) {
            return englishText(finding.remedy);
        }
    }
    return {};
}

}  // namespace rubble
