#pragma once

#include "app/cli/frame/json_output.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/text_table.h"
#include "core/analysis/accuracy/influence.h"

namespace rubble::cli {

/// What `influence` found, as its tables and its JSON object report it; complete or not.
struct InfluenceOutput {
    const io::OpenedCase& subject;
    const InfluenceReport& report;
    const StudySettings& settings;

    Json json() const;
    void print(std::ostream& out) const;
    /// One row for each effect.
    TextTable table() const;
};

}  // namespace rubble::cli
