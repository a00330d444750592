#include "widgets/figures/report/report_pictures.h"

#include <QDir>

#include <algorithm>

#include "core/base/error.h"
#include "widgets/figures/figure_file.h"

namespace rubble::figures {
namespace {

constexpr QSize widePixels(1800, 1150);
constexpr QSize endPixels(1800, 1100);
constexpr QSize mapPixels(1800, 1050);
constexpr double dpi = 250.0;

}  // namespace

ReportPictures drawReportPictures(const render::SceneData& data, const ReportFacts& facts, const MapPictureStyle& place,
                                  const Execution& execution) {
    Studio studio(data);
    ReportPictures pictures;
    FigureStyle style;
    style.dpi = dpi;
    const auto draw = [&](FigurePreset preset, QSize pixels, double share) {
        execution.report({"report.drawing", "Drawing the figures", {}}, share);
        style.pixels = pixels;
        PresetRequest request;
        request.preset = preset;
        request.end = std::max(facts.result->endTime, facts.fe->times().back());
        const render::View view = render::defaultView(data, pixels.width(), pixels.height());
        return studio.sheet(presetSheet(request, view, data, pixels, dpi), style).image();
    };
    pictures.pairs = draw(FigurePreset::Pairs, widePixels, 0.0);
    pictures.end = draw(FigurePreset::End, endPixels, 0.4);
    pictures.stages = draw(FigurePreset::Stages, widePixels, 0.6);
    execution.report({"report.drawing", "Drawing the figures", {}}, 0.9);
    MapPictureStyle map = place;
    map.pixels = mapPixels;
    map.dpi = dpi;
    pictures.map = mapPicture(facts.map.map, MapLayer::Mass, map);
    if (facts.probability != nullptr) {
        map.shown = "simulated, at rest";
        pictures.probability = mapPicture(*facts.probability, MapLayer::Probability, map);
    }
    return pictures;
}

std::vector<std::string> writeReport(const std::string& folder, const ReportFacts& facts, const ReportPictures& pictures,
                                     const std::string& metadata) {
    const QDir place(QString::fromStdString(folder));
    if (!place.mkpath(QStringLiteral("."))) {
        throw WorldError({"report.folder", "The folder {0} cannot be made", {folder}},
                         {"report.folder.remedy", "Choose a folder that you may write to.", {}});
    }
    const ReportDocument document = composeReport(facts, pictures);
    const std::string html = place.filePath(QStringLiteral("report.html")).toStdString();
    const std::string pdf = place.filePath(QStringLiteral("report.pdf")).toStdString();
    writeBytes(html, reportHtml(document, metadata));
    writeReportPdf(pdf, document, metadata);
    return {html, pdf};
}

}  // namespace rubble::figures
