#include "app/cli/exports/page_request.h"

#include <optional>

#include "app/cli/exports/figure_request.h"
#include "app/cli/frame/picture_options.h"
#include "app/cli/frame/text_output.h"
#include "app/cli/frame/virtual_display.h"
#include "core/base/error.h"
#include "core/evidence/maps/run_map.h"
#include "io/case/case_file.h"
#include "io/exports/page/page_export.h"
#include "io/exports/report_facts.h"
#include "io/run/run_cautions.h"
#include "io/site/site_place.h"
#include "io/validation/kept_validation.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/page_pictures.h"
#include "widgets/figures/report/report_language.h"

namespace rubble::cli {

namespace {

void addPictures(io::PageExtras& extras, const render::SceneData& scene, const io::RunReader& run,
                 std::span<const ReportPhoto> photographs, Session& session) {
    quietQt();
    figures::ensureGuiApplication();
    figures::PageDrawing drawing;
    drawing.times = figures::pageTimes(scene, extras.theCase != nullptr ? extras.theCase->bookmarks : std::vector<Bookmark>());
    drawing.map = extras.map.get();
    drawing.mapStyle.place = io::SitePlace(run.origin().frame, run.origin().site).transform();
    drawing.mapStyle.system = run.origin().frame.crs;
    drawing.mapStyle.cautions = pictureCautions(runCautions(io::standingOf(run)));
    drawing.photographs = photographs;
    try {
        const VirtualDisplay display;
        extras.pictures = figures::drawPagePictures(scene, drawing, session.execution());
    } catch (const WorldError& error) {
        // The views of the page need none of them.
        session.err() << "rubble-cli: note: the page has no pictures: " << englishText(error.message()) << '\n';
    }
}

}  // namespace

void writePage(const std::string& path, const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs,
               const RunSurroundings& around, Session& session) {
    io::checkPage(*run, *inputs.fe);
    const render::SceneData scene = sceneOfRun(run, inputs, around);
    const MappedRun mapped{inputs.fe.get(), run.get(), run->fragments(), run->result(), inputs.terrain, run->origin().scenario};
    std::optional<Case> theCase;
    std::vector<ReportPhoto> photographs;
    io::PageExtras extras;
    if (!around.casePath.empty()) {
        theCase = io::loadCase(around.casePath);
        photographs = io::photographsOfCase(mapped, *theCase, around.casePath, io::standingOf(*run), session.execution());
        extras.theCase = &*theCase;
        extras.title = theCase->title;
        extras.casePath = around.casePath;
    }
    extras.terrain = scene.terrain;
    extras.around = io::shownFiles(around.shown);
    extras.siteFindings = around.shown.findings;
    extras.surroundings = scene.surroundings;
    extras.orthophoto = scene.orthophoto;
    extras.validation = io::keptValidations();
    extras.chinese = figures::chineseWords(true);
    extras.map = std::make_shared<const DebrisMap>(mapOfRun(mapped, std::nullopt, {}, true, session.execution()).map);
    addPictures(extras, scene, *run, photographs, session);
    if (scene.orthophoto != nullptr) {
        extras.pictures.push_back(figures::groundPicture(*scene.orthophoto));
    }
    const io::PageReport report = io::exportPage(path, *run, *inputs.fe, extras, session.execution());
    session.err() << "rubble-cli: note: " << path << ": places lie within " << englishNumber(1000.0 * report.placeError)
                  << " mm of those recorded, nodes of the FE result within " << englishNumber(1000.0 * report.nodeError) << " mm\n";
    if (report.siteTriangles > 0) {
        session.err() << "rubble-cli: note: " << path << ": what stands around the structure, "
                      << englishInteger(static_cast<std::int64_t>(report.siteTriangles)) << " triangles, lies within "
                      << englishNumber(1000.0 * report.siteError) << " mm of its files\n";
    } else if (report.siteLeftOut) {
        session.err() << "rubble-cli: note: " << path << ": what stands around the structure is too large for the views\n";
    }
    if (report.statesLeftOut > 0) {
        session.err() << "rubble-cli: note: " << path << ": " << englishInteger(static_cast<std::int64_t>(report.statesLeftOut))
                      << " states of the FE result are left out to keep the page small; there nodes lie up to "
                      << englishNumber(1000.0 * report.nodeErrorBetween) << " mm from where they were computed\n";
    }
}

}  // namespace rubble::cli
