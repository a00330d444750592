#include "app/cli/exports/report_request.h"

#include "app/cli/exports/figure_request.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/picture_options.h"
#include "app/cli/frame/virtual_display.h"
#include "core/selftest/report_checks.h"
#include "io/exports/provenance.h"
#include "io/site/site_place.h"
#include "widgets/figures/report/report_language.h"
#include "widgets/figures/report/report_pictures.h"

namespace rubble::cli {

namespace {

constexpr int mostRepeats = 100;

}  // namespace

std::vector<Option> ReportMaking::options() {
    return {{"--repeats", "N", false, "repeats simulated for the spread of the results, 0 for none (default: 2)"},
            {"--language", "CODE", false, "language of a report and of what is told of it: en (default) or zh_CN"},
            {"--self-test", "SCOPE", false, "all, closed-form (default) or none"}};
}

ReportMaking::ReportMaking(const Arguments& arguments) {
    const std::string number = arguments.value("--repeats").value_or("2");
    if (!parseNumber(number, repeats) || repeats < 0 || repeats > mostRepeats) {
        throw wrongValue("--repeats", number, "a number from 0 to 100");
    }
    language = arguments.value("--language").value_or(language);
    if (language != "en" && language != "zh_CN") {
        throw wrongValue("--language", language, "en or zh_CN");
    }
    selfTest = arguments.value("--self-test").value_or(selfTest);
    if (selfTest != "all" && selfTest != "closed-form" && selfTest != "none") {
        throw wrongValue("--self-test", selfTest, "all, closed-form or none");
    }
}

WrittenReport writeReport(const std::string& folder, const io::ReportRequest& request, const RunSurroundings& around,
                          const ReportMaking& making, Session& session) {
    WrittenReport report;
    report.facts = io::reportFacts(request, session.execution());
    selftest::addReportChecks(report.facts, making.selfTest, session.execution());
    quietQt();
    figures::ensureGuiApplication();
    const figures::WrittenLanguage written(making.language);
    const VirtualDisplay display;
    const io::RunOrigin& origin = request.run->origin();
    figures::MapPictureStyle map;
    map.place = io::SitePlace(origin.frame, origin.site).transform();
    map.system = origin.frame.crs;
    figures::ReportPictures pictures =
        figures::drawReportPictures(sceneOfRun(request.run, request.inputs, around), report.facts, map, session.execution());
    pictures.say = written.say();
    const io::ExportRecord record{"report",
                                  {{"Debris at the end", report.facts.result->endTime, std::nullopt, "simulated"}},
                                  {},
                                  {},
                                  request.casePath,
                                  io::shownFiles(around.shown)};
    report.files = figures::writeReport(folder, report.facts, pictures, io::exportProvenance(record, origin, request.run.get()),
                                        session.execution(), &report.lacks);
    return report;
}

}  // namespace rubble::cli
