#include "app/gui/exports/run_orders.h"

#include "core/evidence/maps/run_map.h"
#include "core/selftest/report_checks.h"
#include "io/exports/page/page_export.h"
#include "io/run/run_cautions.h"
#include "io/site/site_place.h"
#include "io/validation/kept_validation.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/page_pictures.h"
#include "widgets/figures/report/report_language.h"
#include "widgets/figures/report/report_pictures.h"
#include "widgets/run/caution_words.h"

namespace rubble {

namespace {

figures::MapPictureStyle mapStyleOf(const io::RunOrigin& origin) {
    figures::MapPictureStyle style;
    style.place = io::SitePlace(origin.frame, origin.site).transform();
    style.system = origin.frame.crs;
    return style;
}

}  // namespace

void PageOrder::write(const Execution& execution) const {
    io::checkPage(*run, *inputs.fe);
    const MappedRun mapped{inputs.fe.get(), run.get(), run->fragments(), run->result(), inputs.terrain, run->origin().scenario};
    io::PageExtras extras;
    extras.title = theCase.title;
    extras.theCase = &theCase;
    extras.casePath = casePath;
    extras.terrain = scene.terrain;
    extras.around = around;
    extras.siteFindings = site;
    extras.validation = io::keptValidations();
    extras.map = std::make_shared<const DebrisMap>(mapOfRun(mapped, std::nullopt, {}, true, execution).map);
    extras.chinese = figures::chineseWords(true);
    const std::vector<ReportPhoto> photographs = io::photographsOfCase(mapped, theCase, basePath, io::standingOf(*run), execution);
    figures::PageDrawing drawing;
    drawing.times = figures::pageTimes(scene, theCase.bookmarks);
    drawing.map = extras.map.get();
    drawing.mapStyle = mapStyleOf(run->origin());
    drawing.mapStyle.cautions = widgets::cautionWords(runCautions(io::standingOf(*run))).toStdString();
    drawing.photographs = photographs;
    extras.pictures = figures::drawPagePictures(scene, drawing, execution);
    extras.surroundings = scene.surroundings;
    extras.orthophoto = scene.orthophoto;
    if (scene.orthophoto != nullptr) {
        extras.pictures.push_back(figures::groundPicture(*scene.orthophoto));
    }
    io::exportPage(path, *run, *inputs.fe, extras, execution);
}

ReportFacts ReportOrder::facts(const Execution& execution) const {
    io::ReportRequest whole = request;
    whole.theCase = &theCase;
    return io::reportFacts(whole, execution);
}

Findings ReportOrder::write(const Execution& execution) const {
    ReportFacts said = facts(execution);
    selftest::addReportChecks(said, selfTest.toStdString(), execution);
    const io::RunReader& run = *request.run;
    figures::ReportPictures pictures = figures::drawReportPictures(scene, said, mapStyleOf(run.origin()), execution);
    pictures.say = [](const Message& message) { return widgets::worded(message); };
    const io::ExportRecord record{
        "report", {{"Debris at the end", said.result->endTime, std::nullopt, "simulated"}}, {}, {}, request.casePath, around};
    Findings lacks;
    figures::writeReport(folder, said, pictures, io::exportProvenance(record, run.origin(), &run), execution, &lacks);
    return lacks;
}

}  // namespace rubble
