#include <cmath>

#include "app/cli/exports/figure_request.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/picture_options.h"
#include "app/cli/frame/run_inputs.h"
#include "app/cli/frame/virtual_display.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "io/run/run_cautions.h"
#include "widgets/figures/export_record.h"
#include "widgets/figures/movie.h"
#include "widgets/figures/view_json.h"

namespace rubble::cli {

namespace {

constexpr QSize usualPixels(1280, 720);
constexpr double usualDpi = 110.0;

double numberOf(const Arguments& arguments, std::string_view option, double byDefault, std::string_view wanted) {
    const auto text = arguments.value(option);
    double number = byDefault;
    if (text && (!parseNumber(*text, number) || !std::isfinite(number))) {
        throw wrongValue(option, *text, wanted);
    }
    return number;
}

figures::MovieSettings settingsOf(const Arguments& arguments, const io::RunReader& run, const FeResult& fe) {
    const auto [first, last] = figures::movieSpan(fe, &run);
    figures::MovieSettings settings;
    settings.from = numberOf(arguments, "--from", first, "seconds");
    settings.to = numberOf(arguments, "--to", last, "seconds");
    settings.fps = numberOf(arguments, "--fps", settings.fps, "pictures per second from 1 to 120");
    settings.pace = numberOf(arguments, "--pace", settings.pace, "seconds of the collapse in a second of the movie");
    if (settings.from < first || settings.to > last) {
        throw UsageError({"cli.span_outside",
                          "From {0} to {1}: the run goes from {2} to {3}.",
                          {{settings.from, "s"}, {settings.to, "s"}, {first, "s"}, {last, "s"}}},
                         {"cli.time_outside.remedy", "Give a time within the run.", {}});
    }
    figures::movieLength(settings);
    if (arguments.has("--along-keys")) {
        const std::optional<std::string> path = arguments.value("--case");
        if (path) {
            settings.cameras = io::loadCase(*path).cameraKeys;
        }
        if (settings.cameras.empty()) {
            throw UsageError({"cli.no_camera_keys", "--along-keys: there are no camera keys.", {}},
                             {"cli.no_camera_keys.remedy",
                              "Name a case that has some: --case CASE. They are set in the window, by Camera key here.",
                              {}});
        }
    }
    return settings;
}

std::string recordOf(const io::RunReader& run, const RunSurroundings& around, const render::View& view,
                     const figures::MovieSettings& settings, QSize pixels, const render::SceneData& data) {
    io::ExportRecord record{"movie",
                            {},
                            figures::settingsText(pixels, settings, view, data),
                            figures::toJson(view),
                            around.casePath,
                            io::shownFiles(around.shown)};
    for (const figures::MoviePane& pane : figures::moviePanes(view, true)) {
        record.shown.push_back({pane.name, settings.from, settings.to, pane.shownAs});
    }
    return io::exportProvenance(record, run.origin(), &run);
}

ExitCode movie(const Arguments& arguments, Session& session) {
    const FigureRequest request(arguments);
    const std::optional<std::string> path = arguments.value("--out");
    if (!path) {
        throw UsageError({"cli.no_movie", "rubble-cli movie does not know where to write.", {}},
                         {"cli.no_movie.remedy", "Name an MP4 or a folder for pictures: --out F.mp4 or --out FOLDER.", {}});
    }
    const bool encoded = io::hasEnding(*path, ".mp4");
    if (encoded) {
        checkOutputPath(*path, std::vector<std::string>{arguments.operand()});
    }
    const std::shared_ptr<io::RunReader> run = io::openRun(arguments.operand());
    const Inputs inputs = openInputsOfRun(run->origin(), arguments, session);
    const figures::MovieSettings settings = settingsOf(arguments, *run, *inputs.fe);
    figures::FigureStyle style = request.style();
    if (!arguments.has("--size")) {
        style.pixels = usualPixels;
    }
    style.pixels = figures::evenSize(style.pixels);
    if (!arguments.has("--dpi")) {
        style.dpi = usualDpi;
    }
    const RunSurroundings around = surroundingsOfRun(run->origin(), inputs, arguments, session);
    const render::SceneData data = request.sceneFor(run, inputs, around, session.execution());
    quietQt();
    figures::ensureGuiApplication();
    const VirtualDisplay display;
    render::View view = request.viewOf(data, style.pixels);
    view.theme = render::Theme::Light;
    view.captions = true;
    view.time = settings.from;
    const auto target =
        figures::movieTarget(*path, style.pixels, settings.fps, recordOf(*run, around, view, settings, style.pixels, data));
    style.cautions = pictureCautions(runCautions(io::standingOf(*run)));
    figures::Studio studio(data);
    figures::makeMovie(studio, view, style, settings, *target, session.execution());
    const std::size_t pictures = figures::movieLength(settings);
    const io::Taint taint = io::taintOf(*run);
    warnIfTainted(session, arguments.operand(), taint);
    if (arguments.json()) {
        Json object;
        object["run"] = arguments.operand();
        object["out"] = target->path();
        object["pictures"] = pictures;
        object["seconds"] = static_cast<double>(pictures) / settings.fps;
        object["tainted"] = taint.tainted();
        object["cautions"] = cautionsOf(*run);
        printJson(session, object);
    } else {
        session.out() << target->path() << '\n';
    }
    return ExitCode::Ok;
}

}  // namespace

Command movieCommand() {
    const std::vector<Option> own{
        {"--out", "PATH", false,
         "the movie: F.mp4 through ffmpeg, or a folder that gets a PNG for each picture; beside one that holds a movie a new "
         "folder is made"},
        {"--from", "SECONDS", false, "where it begins on the file's clock (default: the first state)"},
        {"--to", "SECONDS", false, "where it ends (default: the end of the run)"},
        {"--fps", "N", false, "pictures per second, from 1 to 120 (default: 25)"},
        {"--pace", "X", false,
         "seconds of the collapse in a second of the movie: 1 is real time (default), 0.25 four times slower"},
        {"--along-keys", "", false, "the camera moves along the camera keys of --case, from key to key"}};
    return {
        "movie",
        "RUN",
        "a movie of a run: MP4 through ffmpeg, or numbered pictures",
        "Draws the run picture by picture with its time printed on it. After Ctrl-C, a full disk or the death of ffmpeg nothing "
        "half-made is left. Where no display answers, Xvfb is started for the purpose.",
        joined({own, FigureRequest::viewOptions(), {caseOption(), feOption(), runTerrainOption()}}),
        movie};
}

}  // namespace rubble::cli
