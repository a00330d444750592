#include "widgets/figures/report/report_sections.h"
#include "widgets/figures/report/validation_rows.h"

namespace rubble::figures {

void ReportSections::addValidation() {
    heading(tr("Validation: held against measured falls"));
    text(tr(
        "Agreement with the reference, in the section before, compares a simulation with a finer one: a verification, which says "
        "nothing of the world. Validation holds the same program against bodies that really fell, and gives the known rate of "
        "error as far as such measurements go. None of them is of this collapse."));
    if (m_facts.validation.empty()) {
        notice(
            tr("The program that made this report was not held against measured falls on this machine: its rate of error is not "
               "part of this report. <code>rubble-cli validate</code>, or <i>Validation</i> in the menu <i>Help</i>, does so."));
        return;
    }
    text(validationTerms());
    ReportTable figures;
    figures.caption = tr("Measured and simulated falls");
    figures.columns = QStringList{tr("set, variant"),     tr("figure"),           tr("measured D"), tr("simulated S"),
                                  tr("E = S − D (95 %)"), tr("area (by chance)"), tr("not known"),  tr("asked")};
    figures.words = {true, true, false, false, false, false, false, true};
    figures.shares = {0.15, 0.17, 0.12, 0.14, 0.14, 0.1, 0.06, 0.12};
    figures.small = true;
    ReportTable parameters;
    parameters.caption = tr("What these falls were simulated with, and where the values come from");
    parameters.columns = QStringList{tr("set, variant"), tr("setting"), tr("source")};
    parameters.words = {true, true, true};
    parameters.shares = {0.25, 0.25, 0.5};
    parameters.small = true;
    QStringList sets;
    for (const ValidationRecord& record : m_facts.validation) {
        sets << validationSummary(record);
        for (const ValidationRow& row : validationRows(record)) {
            figures.rows.push_back({row.set, row.figure, row.measured, row.simulated, row.error, row.area, row.lost, row.asked});
        }
        for (const ValidationParameterRow& row : validationParameters(record)) {
            parameters.rows.push_back({row.set, row.setting, row.source});
        }
    }
    figures.source = parameters.source =
        tr("From simulations of these sets by the program that made this report, apart from its run.");
    m_blocks.push_back(ReportList{sets});
    m_blocks.push_back(std::move(figures));
    m_blocks.push_back(std::move(parameters));
}

}  // namespace rubble::figures
