#include "app/gui/exports/picture_export.h"

#include <QFileInfo>
#include <algorithm>
#include <tuple>

#include "app/gui/exports/export_source.h"
#include "app/gui/exports/folder_choice.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "core/fe/north.h"
#include "io/run/run_cautions.h"
#include "io/site/site_place.h"
#include "widgets/figures/export_record.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/view_json.h"
#include "widgets/run/caution_words.h"

namespace rubble {

namespace {

constexpr double movieDpi = 110.0;

double lastInstant(const render::SceneData& data) {
    const double end = data.fe->times().back();
    const auto& run = data.trajectory;
    return run != nullptr && run->frameCount() > 0 ? std::max(end, run->frameTime(run->frameCount() - 1)) : end;
}

figures::Sheet sheetFor(const widgets::FigureChoice& choice, const render::View& view, const render::SceneData& data) {
    if (!choice.preset) {
        return figures::sheetOf(view);
    }
    figures::PresetRequest request;
    request.preset = *choice.preset;
    request.end = lastInstant(data);
    request.style = view.style;
    return figures::presetSheet(request, view, data);
}

/// A figure shows what is selected only if that was asked for.
render::View shownIn(const widgets::FigureChoice& choice, render::View view) {
    if (!choice.selection) {
        view.selection.clear();
    }
    return view;
}

std::optional<double> northOfSite(const PictureExport::Made& made) {
    return northOf(io::SitePlace(made.origin.frame, made.origin.site).transform(), made.origin.frame.crs);
}

std::string_view coloursOf(render::SitePoints::Scale scale) {
    using Scale = render::SitePoints::Scale;
    switch (scale) {
        case Scale::Intensity:
            return "intensity";
        case Scale::Height:
            return "height";
        case Scale::Class:
            return "class";
        case Scale::Distance:
            return "distance";
        case Scale::Own:
            break;
    }
    return "own";
}

/// The cloud of a view, if its points are drawn, with the digest of its file.
std::vector<io::ShownCloud> shownClouds(const render::View& view, const render::SceneData& data, const Execution& execution) {
    if (data.points == nullptr || view.cloud.empty()) {
        return {};
    }
    const render::SitePoints& points = *data.points;
    const render::SitePoints::Source& source = points.source;
    io::ShownCloud cloud;
    cloud.file = io::shownCloudFile(source.path, {source.bytes, source.time}, execution);
    cloud.placed = source.placed;
    cloud.shown = points.shown;
    cloud.all = points.all;
    cloud.far = source.far;
    cloud.whole = source.whole;
    cloud.colours = coloursOf(points.scale);
    if (points.scale == render::SitePoints::Scale::Distance) {
        cloud.detection = points.detection;
        cloud.registrationInDetection = points.registered;
    } else {
        cloud.finest = source.finest;
    }
    return {cloud};
}

void writeFigureFile(const std::string& path, const widgets::FigureChoice& choice, const render::View& shown,
                     const render::SceneData& data, const PictureExport::Made& made, const Execution& execution) {
    const render::View view = shownIn(choice, shown);
    figures::FigureStyle style;
    style.pixels = choice.pixels;
    style.dpi = choice.dpi;
    style.provenance = io::footLine(made.origin, made.run != nullptr);
    style.cautions = made.cautions.toStdString();
    style.north = northOfSite(made);
    figures::Studio studio(data);
    const figures::SheetPicture picture = studio.sheet(sheetFor(choice, view, data), style);
    const std::string drawn = figures::toJson(choice.preset ? picture.panels().back().view : view);
    io::ExportRecord record{
        "figure",
        {},
        figures::settingsText(picture.pixels(), choice.dpi, choice.preset, picture.panels().back().place.size(), view, data),
        drawn,
        made.casePath,
        made.around,
        shownClouds(view, data, execution)};
    for (const figures::SheetPicture::Panel& panel : picture.panels()) {
        record.shown.push_back({panel.shown.caption.toStdString(), panel.shown.status.time, std::nullopt,
                                figures::shownAs(panel.shown.content, panel.shown.status)});
    }
    figures::writeSheet(path, picture, style, io::exportProvenance(record, made.origin, made.run.get()));
}

/// Returns where the movie lies.
std::string writeMovieFile(const std::string& path, const widgets::MovieChoice& choice, render::View view,
                           const render::SceneData& data, const PictureExport::Made& made, const Execution& execution) {
    view.captions = true;
    view.selection.clear();
    view.time = choice.settings.from;
    io::ExportRecord record{"movie",
                            {},
                            figures::settingsText(choice.pixels, choice.settings, view, data),
                            figures::toJson(view),
                            made.casePath,
                            made.around,
                            shownClouds(view, data, execution)};
    for (const figures::MoviePane& pane : figures::moviePanes(view, made.run != nullptr)) {
        record.shown.push_back({pane.name, choice.settings.from, choice.settings.to, pane.shownAs});
    }
    figures::FigureStyle style;
    style.pixels = choice.pixels;
    style.dpi = movieDpi * choice.pixels.height() / 720.0;
    style.cautions = made.cautions.toStdString();
    const auto target =
        figures::movieTarget(path, style.pixels, choice.settings.fps, io::exportProvenance(record, made.origin, made.run.get()));
    figures::Studio studio(data);
    figures::makeMovie(studio, view, style, choice.settings, *target, execution);
    return target->path();
}

}  // namespace

io::RunOrigin shownOrigin(const Document& document, const Computation& computation) {
    const RunRecord* record = computation.currentRun();
    if (record != nullptr && record->reader != nullptr) {
        return record->reader->origin();
    }
    const CaseScenario* active = document.active();
    return io::originOf(computation.content(), document.scenario(), active != nullptr ? active->name : std::string());
}

PictureExport::PictureExport(Session& session, QWidget& window)
    : m_session(session), m_document(session.document()), m_computation(session.computation()), m_window(window) {}

QString PictureExport::proposed(const QString& suffix) const {
    const QFileInfo base(m_document.base());
    return base.absolutePath() + u'/' + base.completeBaseName() + suffix;
}

PictureExport::Made PictureExport::madeNow(const render::SceneData& data) const {
    const RunRecord* record = m_computation.currentRun();
    std::vector<io::ShownFile> around = io::shownFiles(m_computation.terrain());
    // A map may lie on the ground in place of the orthophoto.
    if (data.orthophoto != m_computation.terrain().orthophoto) {
        std::erase_if(around, [](const io::ShownFile& file) { return file.role == "orthophoto"; });
    }
    const std::shared_ptr<io::RunReader> run = record != nullptr ? record->reader : nullptr;
    return {shownOrigin(m_document, m_computation), run, m_document.path().toStdString(), std::move(around),
            run != nullptr ? widgets::cautionWords(runCautions(io::standingOf(*run))) : QString()};
}

void PictureExport::exportFigure(const render::View& view, const render::SceneData& data) {
    if (data.fe == nullptr) {
        return;
    }
    // What is shown now: other work may change that before the dialogs are answered.
    const Made made = madeNow(data);
    const render::View shown = view;
    widgets::FigureDialog dialog(m_session.part<LastFigure>().choice, &m_window);
    dialog.setCautions(made.cautions);
    connect(&dialog, &widgets::FigureDialog::previewRequested, &dialog, [&](const widgets::FigureChoice& choice) {
        try {
            // Smaller, with text as large for the picture as it will be.
            constexpr double longest = 1120.0;
            const double scale = std::min(1.0, longest / std::max(choice.pixels.width(), choice.pixels.height()));
            figures::FigureStyle style;
            style.pixels = {std::max(100, static_cast<int>(scale * choice.pixels.width())),
                            choice.pixels.height() > 0 ? std::max(100, static_cast<int>(scale * choice.pixels.height())) : 0};
            style.dpi = std::max(20.0, scale * choice.dpi);
            style.provenance = io::footLine(made.origin, data.trajectory != nullptr);
            style.cautions = made.cautions.toStdString();
            style.north = northOfSite(made);
            figures::Studio studio(data);
            dialog.setPreview(studio.sheet(sheetFor(choice, shownIn(choice, shown), data), style).image());
        } catch (...) {
            const auto failure = failureOf(std::current_exception());
            dialog.setPreview({}, failure ? failure->inOneLine() : QString());
        }
    });
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    m_session.part<LastFigure>().choice = dialog.choice();
    const QString path = askSavePath(&m_window, tr("Figure"), proposed(QStringLiteral(".png")), tr("Figures (*.png *.svg *.pdf)"));
    if (path.isEmpty()) {
        return;
    }
    writeFigure(path, m_session.part<LastFigure>().choice, shown, data, made);
}

void PictureExport::exportFigureTo(const QString& path, const widgets::FigureChoice& choice, const render::View& view,
                                   const render::SceneData& data) {
    writeFigure(path, choice, view, data, madeNow(data));
}

void PictureExport::writeFigure(const QString& path, const widgets::FigureChoice& choice, const render::View& view,
                                const render::SceneData& data, const Made& made) {
    m_computation.write(
        [path, choice, view, data, made](const Execution& execution) {
            execution.report({"gui.drawing_figure", "Drawing the figure", {}}, 0.0);
            writeFigureFile(path.toStdString(), choice, view, data, made, execution);
        },
        [session = &m_session, path](const std::exception_ptr& thrown) { session->tellWritten(path, thrown); });
}

void PictureExport::exportMovie(const render::View& view, const render::SceneData& data) {
    if (data.fe == nullptr) {
        return;
    }
    const Made made = madeNow(data);
    const render::View shown = view;
    widgets::MovieChoice choice;
    const bool fragments = shown.layout != render::Layout::FeOnly;
    std::tie(choice.settings.from, choice.settings.to) = figures::movieSpan(*data.fe, fragments ? data.trajectory.get() : nullptr);
    choice.settings.cameras = m_document.theCase().cameraKeys;
    widgets::MovieDialog dialog(choice, figures::ffmpegInstalled(), &m_window);
    dialog.setCautions(made.cautions);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    choice = dialog.choice();
    const QString path =
        choice.encoded
            ? askSavePath(&m_window, tr("Movie"), proposed(QStringLiteral(".mp4")), tr("Movies (*.mp4)"))
            : chooseFolder(m_window, tr("Folder for the pictures of the movie"), QFileInfo(m_document.base()).absolutePath());
    if (path.isEmpty()) {
        return;
    }
    writeMovie(path, choice, shown, data, made);
}

void PictureExport::exportMovieTo(const QString& path, const widgets::MovieChoice& choice, const render::View& view,
                                  const render::SceneData& data) {
    writeMovie(path, choice, view, data, madeNow(data));
}

void PictureExport::writeMovie(const QString& path, const widgets::MovieChoice& choice, const render::View& view,
                               const render::SceneData& data, const Made& made) {
    const auto lies = std::make_shared<std::string>();
    m_computation.write(
        [path, choice, view, data, made, lies](const Execution& execution) {
            *lies = writeMovieFile(path.toStdString(), choice, view, data, made, execution);
        },
        [session = &m_session, lies](const std::exception_ptr& thrown) {
            session->tellWritten(QString::fromStdString(*lies), thrown);
        });
}

}  // namespace rubble
