#include <QFileDialog>

#include "app/gui/exports/picture_export.h"
#include "app/gui/session/session.h"
#include "core/evidence/maps/run_map.h"
#include "io/exports/page/page_export.h"
#include "io/exports/report_facts.h"
#include "io/run/run_cautions.h"
#include "io/site/site_place.h"
#include "io/validation/kept_validation.h"
#include "widgets/figures/page_pictures.h"
#include "widgets/figures/report/report_language.h"

namespace rubble {

namespace {

/// Everything that the worker needs, as it was when it was asked for.
struct PageOrder {
    std::string path;
    std::shared_ptr<io::RunReader> run;
    Inputs inputs;
    Case theCase;
    std::string casePath;
    std::string basePath;
    render::SceneData scene;
    std::vector<io::ShownFile> around;
};

void makePage(const PageOrder& order, const Execution& execution) {
    const io::RunReader& run = *order.run;
    io::checkPage(run, *order.inputs.fe);
    const MappedRun mapped{order.inputs.fe.get(), &run, run.fragments(), run.result(), order.inputs.terrain, run.origin().scenario};
    io::PageExtras extras;
    extras.title = order.theCase.title;
    extras.theCase = &order.theCase;
    extras.casePath = order.casePath;
    extras.terrain = order.scene.terrain;
    extras.around = order.around;
    extras.validation = io::keptValidations();
    extras.map = std::make_shared<const DebrisMap>(mapOfRun(mapped, std::nullopt, {}, true, execution).map);
    extras.chinese = figures::chineseWords();
    const std::vector<ReportPhoto> photographs =
        io::photographsOfCase(mapped, order.theCase, order.basePath, io::standingOf(run), execution);
    figures::PageDrawing drawing;
    drawing.times = figures::pageTimes(order.scene, order.theCase.bookmarks);
    drawing.map = extras.map.get();
    drawing.mapStyle.place = io::SitePlace(run.origin().frame, run.origin().site).transform();
    drawing.mapStyle.system = run.origin().frame.crs;
    drawing.photographs = photographs;
    extras.pictures = figures::drawPagePictures(order.scene, drawing, execution);
    extras.surroundings = order.scene.surroundings;
    extras.orthophoto = order.scene.orthophoto;
    if (order.scene.orthophoto != nullptr) {
        extras.pictures.push_back(figures::groundPicture(*order.scene.orthophoto));
    }
    io::exportPage(order.path, run, *order.inputs.fe, extras, execution);
}

}  // namespace

void PictureExport::sharePage(const render::SceneData& data) {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || record->reader == nullptr || record->running) {
        return;
    }
    const render::SceneData shown = data;
    QString path = QFileDialog::getSaveFileName(&m_window, tr("Page"), proposed(QStringLiteral(".html")), tr("Pages (*.html)"));
    if (path.isEmpty()) {
        return;
    }
    if (!path.endsWith(QLatin1String(".html"), Qt::CaseInsensitive)) {
        path += QStringLiteral(".html");
    }
    sharePageAt(path, shown);
}

void PictureExport::sharePageAt(const QString& path, const render::SceneData& data) {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || record->reader == nullptr || record->running) {
        return;
    }
    const auto order = std::make_shared<const PageOrder>(PageOrder{path.toStdString(), record->reader, m_computation.inputs(),
                                                                   m_document.theCase(), m_document.path().toStdString(),
                                                                   m_document.base().toStdString(), data, madeNow(data).around});
    m_computation.write([order](const Execution& execution) { makePage(*order, execution); },
                        [session = &m_session, path](const std::exception_ptr& thrown) { session->tellWritten(path, thrown); });
}

}  // namespace rubble
