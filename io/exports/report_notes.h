#pragma once

#include <string>

#include "core/evidence/report_facts.h"

namespace rubble::io {

/// What the author of a report has said of a case, beside what a case file holds.
struct ReportNotes {
    std::string question;
    std::string author;
    OwnWords words;
    std::string causes;  ///< file of a comparison of causes, absolute; empty: none

    bool empty() const;
};

/// Where the notes on a case are kept: CASE.rubble.report.json beside it. The case itself does not change by them.
std::string reportNotesPath(const std::string& casePath);

/// The notes of a file; empty ones if there is none. Throws WorldError, ParseError naming file and place.
ReportNotes readReportNotes(const std::string& file);

/// The notes in a text. @param name  what errors call it. Throws ParseError.
ReportNotes reportNotesFrom(const std::string& text, const std::string& name);

/// Writes them atomically; empty ones remove the file. Throws WorldError; the old file is then unchanged.
void writeReportNotes(const std::string& file, const ReportNotes& notes);

}  // namespace rubble::io
