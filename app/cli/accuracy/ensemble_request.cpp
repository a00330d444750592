#include "app/cli/accuracy/ensemble_request.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/cli/accuracy/study_options.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/subject.h"
#include "core/base/error.h"
#include "core/scenario/case_lookup.h"
#include "io/base/machine.h"
#include "io/case/case_file.h"

namespace rubble::cli {

std::vector<Option> EnsembleRequest::options() {
    return {{"--members", "N", false, "how often the collapse is simulated (default: that of the case, 16)"},
            {"--vary", "KEY=DIST", true,
             "what is drawn for each member: uniform:A:B, normal:MEAN:DEV or choice:A:B, of any parameter, or of scenario "
             "(default: that of the case)"},
            {"--seed", "N", false, "of what is drawn (default: that of the case, 1)"},
            {"--cell", "M", false, "side of the cells of the maps, m (default: 0.5)"},
            {"--live", "on|off", false, "fallen live structure counts as debris (default: on)"},
            {"--live-threshold", "M", false, "live structure has fallen if it moved farther than this, m (default: 1)"},
            {"--instant", "WHEN", false, "debris at rest (default) or at fe_end, the last FE state"},
            {"--jobs", "N", false, "members at a time (default: one for each thread); no result depends on it"},
            {"--threads", "N", false, "threads to work on (default: as many as the machine has); no result depends on it"},
            {"--cache", "FOLDER", false, "where members are kept (default: RUBBLE_CACHE, else the user's cache)"}};
}

EnsembleRequest::EnsembleRequest(const Arguments& arguments) {
    for (const std::string& text : arguments.values("--vary")) {
        const auto [key, distribution] = splitAssignment("--vary", text);
        m_varied.push_back(variationFrom(key, distribution));
    }
    const auto number = [&](std::string_view option, int low, int high) -> std::optional<std::int64_t> {
        return arguments.has(option) ? std::optional<std::int64_t>(parseCount(arguments, option, low, high, 0)) : std::nullopt;
    };
    m_members = number("--members", 1, static_cast<int>(ensembleMembersMax));
    m_seed = number("--seed", 0, 2147483647);
    m_surface.cell = parseLength(arguments, "--cell", m_surface.cell);
    m_surface.withFallen = parseOnOff(arguments, "--live", true);
    m_surface.liveThreshold = parseLength(arguments, "--live-threshold", m_surface.liveThreshold, true);
    const std::string instant = arguments.value("--instant").value_or("rest");
    if (instant != "rest" && instant != "fe_end") {
        throw wrongValue("--instant", instant, "rest or fe_end");
    }
    m_instant = instant == "rest" ? DebrisInstant::AtRest : DebrisInstant::AtFeEnd;
    m_jobs = parseCount(arguments, "--jobs", 1, jobsMax, 0);
    m_threads = parseCount(arguments, "--threads", 1, jobsMax, 0);
}

EnsembleOptions EnsembleRequest::studyOptions(SettledStore* store) const {
    EnsembleOptions options;
    options.instant = m_instant;
    options.surface = m_surface;
    options.jobs = m_jobs;
    options.threads = m_threads;
    options.machine = io::machineText();
    options.store = store;
    return options;
}

EnsembleSettings EnsembleRequest::settingsFor(const Case& theCase) const {
    EnsembleSettings settings = theCase.ensemble;
    settings.members = m_members.value_or(settings.members);
    settings.seed = m_seed.value_or(settings.seed);
    if (!m_varied.empty()) {
        settings.varied = m_varied;
    }
    checkEnsemble(settings);
    return settings;
}

EnsembleSubject openEnsembleSubject(const std::string& path, const std::optional<std::string>& scenario, const Arguments& arguments,
                                    const EnsembleRequest& request, Session& session, const EnsembleSubject* like) {
    io::CaseRequest opening = caseRequest(arguments, path);
    opening.scenario = scenario;
    const bool isCase = io::isCaseFile(path);
    const bool alike = !isCase && like != nullptr && !like->theCase.scenarios.empty();
    if (isCase) {
        opening.theCase = io::loadCase(path);
    } else if (alike) {
        const CaseScenario& active = *findScenario(like->theCase, std::nullopt);
        opening.path = like->path;
        opening.theCase = io::caseOfCause(like->theCase, active, std::filesystem::absolute(path).string());
    }
    const EnsembleSettings settings = request.settingsFor(opening.theCase.value_or(Case()));
    EnsembleSubject subject{io::openEnsemble(opening, settings, session.execution()), settings, opening.path};
    if (alike) {
        subject.name = std::filesystem::path(path).stem().string();
        Message what{"causes.like_first",
                     "{0} is an FE result without a case: settings, frame and site are those of {1}",
                     {path, like->path}};
        what.id += '.' + subject.name;
        subject.findings.add(what, {"causes.like_first.remedy", "give a case of it if it is to have others", {}});
    }
    if (scenario) {
        // One scenario is asked for: then it is not varied.
        std::erase_if(subject.settings.varied, [](const VariedSetting& varied) { return varied.key == scenarioKey; });
    }
    return subject;
}

std::vector<StudyTask> tasksOf(const EnsembleSubject& subject, const EnsembleRequest& request, const Execution& execution) {
    return ensembleTasks(subject.scenes, subject.settings, request.studyOptions(nullptr), execution);
}

std::vector<std::string> operandsOf(const Arguments& arguments) {
    std::vector<std::string> operands;
    for (std::size_t i = 0; !arguments.operand(i).empty(); ++i) {
        operands.push_back(arguments.operand(i));
    }
    return operands;
}

HeightThresholds parseThresholds(const Arguments& arguments) {
    const auto text = arguments.value("--heights");
    if (!text) {
        return usualThresholds;
    }
    const std::vector<double> numbers = parsePositives(arguments, "--heights", "three ascending heights in m, separated by commas");
    if (numbers.size() != 3 || !(numbers[0] < numbers[1]) || !(numbers[1] < numbers[2])) {
        throw wrongValue("--heights", *text, "three ascending heights in m, separated by commas");
    }
    return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace rubble::cli
