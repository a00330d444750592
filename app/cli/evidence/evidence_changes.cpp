#include "app/cli/evidence/evidence_changes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/cli/evidence/placed_survey.h"
#include "app/cli/evidence/scanned_site.h"
#include "app/cli/exports/map_subject.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/run_inputs.h"
#include "app/cli/frame/subject.h"
#include "core/base/error.h"
#include "core/evidence/surveys/stated_survey.h"
#include "io/case/case_file.h"
#include "io/case/case_photographs.h"
#include "io/case/case_surveys.h"
#include "io/case/terrain_reader.h"
#include "io/site/clouds/height_source.h"
#include "io/site/survey_file.h"
#include "io/site/surveys/survey_registration.h"

namespace rubble::cli {

namespace {

/// Options that say something of a survey.
constexpr std::array<std::string_view, 12> surveyOptions{"--pairs",      "--pairs-error", "--fit",     "--registration-error",
                                                         "--unregister", "--taken",       "--instant", "--before",
                                                         "--columns",    "--crs",         "--scanner", "--held-as"};

void needs(const Arguments& arguments, std::string_view option, std::string_view other) {
    if (arguments.has(option) && !arguments.has(other)) {
        throw UsageError({"cli.option_alone", "{0} goes with {1}", {std::string(option), std::string(other)}},
                         {"cli.option_alone.remedy", "Give both, or leave {0} out.", {std::string(option)}});
    }
}

void checkEvidenceOptions(const Arguments& arguments) {
    for (const std::string_view option : surveyOptions) {
        needs(arguments, option, "--survey");
    }
    needs(arguments, "--pairs-error", "--pairs");
    needs(arguments, "--fit", "--radius");
    needs(arguments, "--radius", "--fit");
    needs(arguments, "--removed", "--since");
    needs(arguments, "--since", "--removed");
    if (arguments.has("--unregister") && (arguments.has("--pairs") || arguments.has("--fit"))) {
        throw UsageError({"cli.unregister", "--unregister takes the registration out, --pairs and --fit make one", {}},
                         {"cli.unregister.remedy", "Give one or the other.", {}});
    }
}

std::string clockFrom(const Arguments& arguments, std::string_view option) {
    const std::string time = clockTimeFrom(*arguments.value(option));
    if (time.empty()) {
        throw wrongValue(option, *arguments.value(option), "date and time by the clock of the site, such as 2021-06-25T16:30");
    }
    return time;
}

/// Registers a survey of a case that was opened.
class Registering {
public:
    Registering(const Arguments& arguments, CaseInput& survey, const std::string& path, Session& session, Findings& findings)
        : m_arguments(arguments),
          m_survey(survey),
          m_path(path),
          m_session(session),
          m_findings(findings),
          m_opened(openSubject(arguments, session)) {}

    void byPairs() {
        io::PairsRequest request{m_path, *m_arguments.value("--pairs"), m_survey.read, m_opened.inputs.frame, site(), {}};
        request.around = io::boundsAtRest(m_opened.inputs.fe->mesh());
        request.control = pairsErrorFrom(m_arguments);
        const PairFit fit = io::placeByPairs(request);
        m_findings.append(fit.findings);
        m_survey.registration = fit.registration;
    }

    void byFit() {
        if (!io::holdsCloud(m_path, m_survey.read)) {
            throw UsageError({"cli.fit_no_cloud", "{0} is no point cloud: only points are fitted", {m_path}},
                             {"cli.fit_no_cloud.remedy",
                              "Give pairs, or shift it where it is compared, with rubble-cli survey --register ground.",
                              {}});
        }
        io::RunDistanceRequest request;
        request.cloud = m_path;
        request.read = m_survey.read;
        request.frame = m_opened.inputs.frame;
        request.site = site();
        request.settings = io::scalesOfFit(parseLength(m_arguments, "--radius", 0.0));
        request.placed = m_survey.registration;
        request.scanners = m_survey.scanners;
        const std::string area = *m_arguments.value("--fit");
        request.stable = area == "all" ? Outline() : io::readScope(area, request.frame, site(), m_findings, m_session.execution());
        ScannedSite target = targetSite();
        const CloudFit fit = io::fitCloudToSite(request, std::move(target.shape), target.ground, m_findings, m_session.execution());
        m_survey.registration = fittedOn(m_survey.registration, fit, io::boundsAtRest(m_opened.inputs.fe->mesh()));
    }

private:
    const Site& site() const { return m_opened.theCase.site; }

    /// What stands and lies where the run of --run ends, else the terrain of the case alone.
    ScannedSite targetSite() {
        const auto path = m_arguments.value("--run");
        if (path) {
            const std::shared_ptr<io::RunReader> run = io::openRun(*path);
            const Inputs inputs = openInputsOfRun(*path, run->origin(), m_arguments, m_session, &m_findings);
            return scannedSite(*run, inputs, std::nullopt, 1.0, m_session.execution());
        }
        ScannedSite target;
        target.ground = {true, m_opened.scenario.simulation.groundHeight, m_opened.inputs.terrain};
        return target;
    }

    const Arguments& m_arguments;
    CaseInput& m_survey;
    std::string m_path;
    Session& m_session;
    Findings& m_findings;
    io::OpenedCase m_opened;
};

/// What measured points are held to say.
void holdAs(CaseInput& survey, const std::string& held) {
    const auto found = std::find(pointsHeldNames.begin(), pointsHeldNames.end(), held);
    if (found == pointsHeldNames.end()) {
        throw wrongValue("--held-as", held, "section, outline or control");
    }
    if (survey.kind != SurveyKind::Points) {
        throw UsageError({"cli.held_no_points", "{0} holds no measured points: what it says is told by its content", {survey.path}},
                         {"cli.held_no_points.remedy",
                          "Give a table of a total station with names of its points, or a DXF without closed lines.",
                          {}});
    }
    survey.held = static_cast<PointsHeld>(found - pointsHeldNames.begin());
}

void changeSurvey(Case& theCase, const Arguments& arguments, Session& session, Findings& findings) {
    const std::string path = *arguments.value("--survey");
    CaseInput& survey = theCase.inputs[io::takeSurvey(theCase, arguments.operand(), path)];
    if (arguments.has("--columns") || arguments.has("--crs")) {
        CloudRequest read = survey.read;
        takeCloudRequest(arguments, read);
        io::stateReading(survey, path, read);
    }
    if (const auto held = arguments.value("--held-as")) {
        holdAs(survey, *held);
    }
    if (arguments.has("--scanner")) {
        survey.scanners = scannersFrom(arguments);
    }
    if (arguments.has("--taken")) {
        survey.taken = clockFrom(arguments, "--taken");
    }
    if (arguments.has("--before")) {
        survey.before = parseOnOff(arguments, "--before", true);
    }
    if (const auto instant = arguments.value("--instant")) {
        double seconds = 0.0;
        if (*instant == "end") {
            survey.instant.reset();
        } else if (parseNumber(*instant, seconds) && std::isfinite(seconds)) {
            survey.instant = seconds;
        } else {
            throw wrongValue("--instant", *instant, "seconds with a point as decimal sign, or end");
        }
    }
    if (arguments.has("--unregister")) {
        survey.registration.reset();
    }
    if (arguments.has("--pairs") || arguments.has("--fit")) {
        Registering registering(arguments, survey, path, session, findings);
        if (arguments.has("--pairs")) {
            registering.byPairs();
        }
        if (arguments.has("--fit")) {
            registering.byFit();
        }
    }
    if (arguments.has("--registration-error")) {
        const double error = parseLength(arguments, "--registration-error", 0.0, true);
        if (!survey.registration) {
            survey.offsetError = error;
        } else {
            survey.registration->error = error;
        }
    }
}

void addRemoval(Case& theCase, const Arguments& arguments, Session& session, Findings& findings) {
    const io::OpenedCase opened = openSubject(arguments, session);
    Removal removal;
    removal.time = clockFrom(arguments, "--since");
    const std::string path = *arguments.value("--removed");
    removal.name = path.substr(path.find_last_of('/') + 1);
    removal.area = io::readScope(path, opened.inputs.frame, opened.theCase.site, findings, session.execution());
    theCase.removals.push_back(std::move(removal));
    std::stable_sort(theCase.removals.begin(), theCase.removals.end(),
                     [](const Removal& a, const Removal& b) { return a.time < b.time; });
}

}  // namespace

std::vector<Option> evidenceChangeOptions() {
    return {{"--survey", "FILE", false, "a survey, cloud or outline: it is taken into the case if it is none of its surveys"},
            {"--pairs", "FILE", false, "place it by three pairs or more: a table of survey_x,survey_y,survey_z,x_m,y_m,z_m"},
            pairsErrorOption("M"),
            {"--fit", "FILE|all", false, "place a cloud by what did not move: polygons of it, or all; after the pairs"},
            {"--radius", "M", false, "about a point, m: surfaces within it are what it is fitted to"},
            scannerOption("where a scanner of a cloud stood, easting, northing and height, m; kept (default: as the cloud says)"),
            {"--registration-error", "M", false, "standard deviation by which a place of it may be off, m (default: as found)"},
            {"--unregister", "", false, "let it lie as its coordinates say"},
            {"--held-as", "WHAT", false,
             "what measured points are held to say: section, outline (the edge of the debris) or control (default: section)"},
            columnsOption(),
            systemOption(),
            {"--taken", "TIME", false, "when it was taken, by the clock of the site, such as 2021-06-25T16:30"},
            {"--before", "on|off", false, "it was taken before the collapse and shows no debris"},
            {"--instant", "SECONDS", false, "instant that it shows on the file's clock, or end (default: end)"},
            {"--photographs-of", "CLOUD", false,
             "add the pictures of an E57 that have a pinhole and a pose as photographs with that camera"},
            {"--removed", "FILE", false, "polygons of places whose debris was taken away"},
            {"--since", "TIME", false, "from when on it was gone"}};
}

bool changesEvidence(const Arguments& arguments) {
    const std::vector<Option> options = evidenceChangeOptions();
    return std::any_of(options.begin(), options.end(), [&](const Option& option) { return arguments.has(option.name); });
}

void changeEvidence(Case& theCase, const Arguments& arguments, Session& session, Findings& findings) {
    checkEvidenceOptions(arguments);
    if (arguments.has("--survey")) {
        changeSurvey(theCase, arguments, session, findings);
    }
    if (const auto cloud = arguments.value("--photographs-of")) {
        const io::OpenedCase opened = openSubject(arguments, session);
        const io::AddedPhotographs added =
            io::addPhotographsOfCloud(theCase, arguments.operand(), *cloud, opened.inputs.frame, findings);
        if (added.ids.empty() && added.known == 0) {
            throw UsageError({"cli.no_placed_photographs", "{0} holds no picture with a pinhole and a pose", {*cloud}},
                             {"cli.no_placed_photographs.remedy",
                              "Write them out with rubble-cli cloud --photographs, add them, and place them by pairs of points.",
                              {}});
        }
        added.written->kept = true;
    }
    if (arguments.has("--removed")) {
        addRemoval(theCase, arguments, session, findings);
    }
}

}  // namespace rubble::cli
