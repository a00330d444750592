#pragma once

#include <QImage>

#include "core/evidence/report_facts.h"
#include "widgets/figures/report/report_document.h"

namespace rubble::figures {

/// Pictures of a report, drawn before its text.
struct ReportPictures {
    QImage pairs;                     ///< three instants, FE above fragments
    QImage end;                       ///< both at the end
    QImage stages;                    ///< four stages
    QImage map;                       ///< mass per area at the end
    QImage probability;               ///< of debris over the ensemble; null: there is none
    std::vector<QImage> photographs;  ///< one for each photograph of the facts; null: it cannot be shown
    std::vector<QImage> surveys;      ///< difference maps, one for each survey of the facts; null: not compared
    /// A message in the language that is spoken; null: in English.
    std::function<QString(const Message&)> say;
};

/// The whole report: question, evidence, method, inputs, assumptions, results with their spread, accuracy against time, validation,
/// effects, health, self-test, limits, appendix; in the language that is spoken.
ReportDocument composeReport(const ReportFacts& facts, const ReportPictures& pictures);

}  // namespace rubble::figures
