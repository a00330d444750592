#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "app/cli/evidence/evidence_changes.h"
#include "app/cli/evidence/placed_survey.h"
#include "app/cli/exports/run_surroundings.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/run_inputs.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "core/evidence/cautions.h"
#include "core/evidence/evidence_list.h"
#include "core/evidence/no_evidence.h"
#include "core/evidence/photographs/photo_comparison.h"
#include "core/evidence/surveys/stated_survey.h"
#include "io/case/case_file.h"
#include "io/case/case_surveys.h"
#include "io/case/terrain_reader.h"
#include "io/exports/survey_files.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_cautions.h"
#include "io/site/cause_evidence.h"
#include "io/site/site_place.h"
#include "io/site/surveys/evidence_origin.h"

namespace rubble::cli {

namespace {

/// The run that evidence is held against.
class ScoredRun {
public:
    ScoredRun(const std::string& path, const Arguments& arguments, Session& session, Findings& findings)
        : m_path(path), m_run(io::openRun(path)), m_inputs(openInputsOfRun(path, m_run->origin(), arguments, session, &findings)) {}

    MappedRun mapped() const {
        return {m_inputs.fe.get(), m_run.get(), m_run->fragments(), m_run->result(), m_inputs.terrain, m_run->origin().scenario};
    }
    const io::RunReader& run() const { return *m_run; }

    /// Overlap of the debris that a survey shows with that of the run; NaN of a survey of before.
    double scoreOf(const Case& theCase, const std::string& casePath, const CaseInput& survey, Findings& findings,
                   const Execution& execution) const {
        if (survey.before) {
            return unknown;
        }
        Site site = theCase.site;
        site.groundClasses = m_run->origin().site.groundClasses;
        const io::SurveyRequest wanted = io::surveyRequest(m_run->origin(), survey);
        const io::SiteWindow window(io::boundsAtRest(m_inputs.fe->mesh()), debrisBounds(mapped(), survey.instant));
        const io::SurveyInput input =
            io::readSurvey(io::inputPath(casePath, survey), m_inputs.frame, site, window, execution, wanted);
        // That it shows a run is said of every piece at once.
        findings.append(otherThanNoEvidence(input.findings));
        SurveySettings settings = surveySettingsOf(theCase);
        takeStated(settings, theCase, survey, findings);
        settings.turn = io::SitePlace(input.frame, input.site).transform().angle;
        const SurveyComparison made = compareRunWithSurvey(mapped(), survey.instant, input.survey, settings, execution);
        findings.append(made.findings);
        return made.iou;
    }

private:
    std::string m_path;
    std::shared_ptr<io::RunReader> m_run;
    Inputs m_inputs;
};

/// Fills in what the list leaves open: places of photographs, and scores against a run.
class EvidenceScores {
public:
    EvidenceScores(const Case& theCase, const std::string& casePath, const ScoredRun* run, Findings& findings,
                   const Execution& execution)
        : m_case(theCase), m_casePath(casePath), m_run(run), m_findings(findings), m_execution(execution) {}

    void fill(EvidenceRow& row) {
        try {
            if (row.form == EvidenceForm::Photograph) {
                const std::string path = io::inputPath(m_casePath, inputOf(row.id));
                takeOrigin(row, path, io::photographOriginOf(path));
                fillPhotograph(row);
            } else if (row.form != EvidenceForm::Points) {
                const CaseInput& survey = inputOf(row.id);
                const std::string path = io::inputPath(m_casePath, survey);
                takeOrigin(row, path, io::surveyOriginOf(path, survey.read));
                m_findings.append(io::checkKind(survey, path));
                if (m_run != nullptr && hasOverlap(survey)) {
                    row.score = m_run->scoreOf(m_case, m_casePath, survey, m_findings, m_execution);
                }
            }
        } catch (const Cancelled&) {
            throw;
        } catch (const Error& error) {
            // One that cannot be read or compared takes nothing from the others.
            m_findings.add(error.message(), error.remedy(), row.path);
        }
    }

private:
    const CaseInput& inputOf(const std::string& id) const {
        return *std::find_if(m_case.inputs.begin(), m_case.inputs.end(), [&](const CaseInput& each) { return each.id == id; });
    }

    void takeOrigin(EvidenceRow& row, const std::string& path, const io::EvidenceOrigin& origin) {
        io::takeOrigin(row, origin);
        io::noteOrigin(m_findings, path, origin, m_run != nullptr ? m_run->run().origin().fingerprint.hex() : std::string());
    }

    void fillPhotograph(EvidenceRow& row) {
        const auto photograph = std::find_if(m_case.photographs.begin(), m_case.photographs.end(),
                                             [&](const Photograph& each) { return each.input == row.id; });
        if (photograph == m_case.photographs.end() || photograph->pairs.empty()) {
            return;
        }
        const CameraMatch match = matchPhotograph(*photograph, m_execution);
        row.within = match.placeRadius;
        const bool drawn = std::any_of(photograph->masks.begin(), photograph->masks.end(),
                                       [](const PhotoMask& mask) { return mask.kind == MaskClass::Debris; });
        if (m_run != nullptr && drawn) {
            row.score =
                compareRunWithPhoto(m_run->mapped(), *photograph, match, photographSettingsOf(m_case), m_execution).iou.best;
        }
    }

    const Case& m_case;
    const std::string& m_casePath;
    const ScoredRun* m_run;
    Findings& m_findings;
    const Execution& m_execution;
};

TextTable evidenceTable(const std::vector<EvidenceRow>& rows) {
    TextTable table({{"evidence", "evidence"},
                     {"kind", "kind"},
                     {"file", "file"},
                     {"taken", "taken"},
                     {"shows", "shows"},
                     {"place within [m]", "place_within_95_m"},
                     {"overlap", "iou"}});
    for (const EvidenceRow& row : rows) {
        table.add({textCell(row.id), textCell(evidenceFormNames[static_cast<std::size_t>(row.form)]), textCell(row.path),
                   textCell(row.taken.empty() && row.form != EvidenceForm::Points ? "not known" : row.taken),
                   textCell(englishText(row.says)), numberCell(row.within), numberCell(row.score)});
    }
    return table;
}

Json evidenceNumber(double number) {
    return std::isfinite(number) ? Json(number) : Json();
}

Json evidenceJson(const Case& theCase, const std::vector<EvidenceRow>& rows) {
    Json object;
    object["evidence"] = Json::array();
    for (const EvidenceRow& row : rows) {
        const auto input = std::find_if(theCase.inputs.begin(), theCase.inputs.end(),
                                        [&](const CaseInput& each) { return !row.id.empty() && each.id == row.id; });
        Json entry;
        entry["id"] = row.id.empty() ? Json() : Json(row.id);
        entry["kind"] = evidenceFormNames[static_cast<std::size_t>(row.form)];
        entry["held_as"] = row.held ? Json(pointsHeldNames[static_cast<std::size_t>(*row.held)]) : Json();
        entry["kind_by_ending"] = row.byEnding;
        entry["file"] = row.path.empty() ? Json() : Json(row.path);
        entry["taken"] = row.taken.empty() ? Json() : Json(row.taken);
        entry["shows"] = englishText(row.says);
        entry["of_run"] = row.run.empty() ? Json() : Json(row.run);
        entry["made_by_program"] = row.ours;
        entry["place_within_95_m"] = evidenceNumber(row.within);
        entry["iou"] = evidenceNumber(row.score);
        entry["placed"] = input != theCase.inputs.end() ? registrationJson(input->registration) : Json();
        object["evidence"].push_back(std::move(entry));
    }
    object["removals"] = Json::array();
    for (const Removal& removal : theCase.removals) {
        object["removals"].push_back({{"name", removal.name}, {"since", removal.time}, {"places", removal.area.polygons.size()}});
    }
    return object;
}

void printEvidence(std::ostream& out, const Case& theCase, const std::vector<EvidenceRow>& rows) {
    printHeading(out, "Evidence of the case");
    evidenceTable(rows).print(out);
    FactList facts;
    for (const CaseInput& input : theCase.inputs) {
        if (input.role == InputRole::Survey) {
            facts.add(input.id, placedText(theCase.frame, theCase.site, input.registration));
        }
    }
    for (const Removal& removal : theCase.removals) {
        facts.add("removed", removal.name + ", " +
                                 counted(static_cast<std::int64_t>(removal.area.polygons.size()), "place", "places") +
                                 ", gone since " + removal.time);
    }
    facts.print(out);
}

ExitCode evidence(const Arguments& arguments, Session& session) {
    const std::string& path = arguments.operand();
    if (!io::isCaseFile(path)) {
        throw UsageError({"cli.evidence_no_case", "{0} is no case: evidence belongs to one", {path}},
                         {"cli.evidence_no_case.remedy", "Give a *.rubble file.", {}});
    }
    checkCsvPath(arguments, std::vector<std::string>{path});
    Case theCase = io::loadCase(path);
    Findings findings;
    if (changesEvidence(arguments)) {
        changeEvidence(theCase, arguments, session, findings);
        theCase = io::saveCase(path, theCase);
    }
    std::optional<ScoredRun> run;
    if (const auto runPath = arguments.value("--run")) {
        run.emplace(*runPath, arguments, session, findings);
        loadCaseOfRun(path, run->run().origin());
    }
    std::vector<EvidenceRow> rows = evidenceOf(theCase);
    EvidenceScores scores(theCase, path, run ? &*run : nullptr, findings, session.execution());
    for (EvidenceRow& row : rows) {
        scores.fill(row);
    }
    findings.append(sameEvidence(theCase));
    findings = noEvidenceFirst(findings);
    writeCsv(arguments, evidenceTable(rows));
    if (arguments.json()) {
        Json object = evidenceJson(theCase, rows);
        object["warnings"] = findingsJson(findings);
        printJson(session, object);
    } else {
        printEvidence(session.out(), theCase, rows);
        printFindings(session.out(), findings);
    }
    if (run) {
        warnIfTainted(session, *arguments.value("--run"), io::taintOf(run->run()));
    }
    return ExitCode::Ok;
}

}  // namespace

Command evidenceCommand() {
    std::vector<Option> options = evidenceChangeOptions();
    options.push_back({"--run", "FILE", false, "hold all against this run: overlaps, and what --fit places a cloud on"});
    options.push_back(feOption());
    options.push_back(runTerrainOption());
    options.push_back(csvOption("write the list"));
    return {"evidence",
            "CASE",
            "the evidence of a case in one list, and how each piece lies and when it was taken",
            "Lists photographs, surveys, clouds, outlines and control points with what each is held to show, how well its place is "
            "known and, with --run, how far the run agrees. With --survey it places a survey by pairs of points or by what did not "
            "move, and says when it was taken; with --removed it keeps places whose debris was taken away. The case file keeps it.",
            options,
            evidence};
}

}  // namespace rubble::cli
