#include "app/gui/exports/seal_making.h"

#include <filesystem>
#include <optional>

#include "core/scenario/case_lookup.h"
#include "io/case/site_reader.h"
#include "io/seal/run_repeat.h"
#include "widgets/render/basics/run_scene.h"

namespace rubble {

namespace {

/// A run with what it was made from.
struct MadeRun {
    std::shared_ptr<io::RunReader> run;
    Inputs inputs;
    std::string fePath;
    std::string terrainPath;
    Findings site;
    io::TerrainInput around;
};

MadeRun openedRun(const SealMaking& making, const std::string& path, const Execution& execution) {
    MadeRun made;
    made.run = io::openRun(path);
    const io::OpenedCase& opened = making.opened;
    const io::RunOrigin& then = made.run->origin();
    // The fingerprint is of all inputs; of another build it is another one, and they are read.
    if (opened.inputs.fe != nullptr && stageKey(opened.inputs, then.scenario, Stage::Simulation) == then.fingerprint) {
        made.inputs = opened.inputs;
        made.fePath = opened.inputs.fe->contents().path;
        made.terrainPath = opened.terrain.path;
        made.site = io::openingFindings(opened);
        made.around = opened.terrain;
        return made;
    }
    const io::RunOrigin origin = io::originInCase(*made.run, making.casePath, making.theCase, execution);
    Findings terrain;
    made.inputs = io::openRunInputs(origin, made.site, terrain, execution);
    made.site.append(terrain);
    made.fePath = origin.fePath;
    made.terrainPath = origin.terrainPath;
    made.around = io::openSurroundingsOfCase(making.theCase, making.casePath, made.inputs.fe->mesh(), made.inputs.frame,
                                             origin.site, made.inputs.terrain.get(), execution);
    return made;
}

}  // namespace

std::vector<io::SealedExtra> SealMaking::make(const std::vector<std::string>& runs, const std::string& folder,
                                              const Execution& execution) const {
    std::vector<io::SealedExtra> extras;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        std::optional<MadeRun> made;
        for (const io::OfferedPart& part : parts) {
            if (part.run != runs[i]) {
                continue;
            }
            const std::string name = std::filesystem::path(runs[i]).filename().string();
            execution.report({"gui.seal_making", "Making what is sealed with {0}", {name}}, 0.0);
            if (!made) {
                made = openedRun(*this, runs[i], execution);
            }
            const io::RunReader& run = *made->run;
            render::SceneData scene = render::sceneOf(
                made->inputs, {&run.origin().scenario, made->run, run.fragments(), run.clustering(), run.result().get()});
            scene.orthophoto = made->around.orthophoto;
            scene.surroundings = made->around.surroundings;
            const io::SealedExtra& extra = extras.emplace_back(io::placeOfMade(part.kind, runs[i], i + 1, folder));
            const std::vector<io::ShownFile> around = io::shownFiles(made->around);
            if (part.kind == io::OfferedPart::Kind::Page) {
                PageOrder{extra.path, made->run, made->inputs, theCase, casePath, casePath, std::move(scene), around, made->site}
                    .write(execution);
            } else {
                ReportOrder order = report;
                order.request.run = made->run;
                order.request.inputs = made->inputs;
                order.request.fePath = made->fePath;
                order.request.terrainPath = made->terrainPath;
                order.request.siteFindings = made->site;
                if (const CaseScenario* scenario = findScenario(theCase, run.origin().scenarioName)) {
                    order.request.scenarioId = scenario->id;
                }
                order.scene = std::move(scene);
                order.around = around;
                order.folder = extra.path;
                order.write(execution);
            }
        }
    }
    return extras;
}

}  // namespace rubble
