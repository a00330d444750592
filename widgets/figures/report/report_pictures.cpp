#include "widgets/figures/report/report_pictures.h"

#include <QDir>
#include <QFile>

#include <algorithm>

#include "core/base/error.h"
#include "core/evidence/ensembles/member_doubts.h"
#include "core/fe/north.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/report/report_photograph.h"
#include "widgets/figures/survey_picture.h"

namespace rubble::figures {
namespace {

constexpr int pictureWidth = 1800;  // px; the height follows what is shown
constexpr QSize mapPixels(pictureWidth, 1050);
constexpr double dpi = 250.0;
constexpr int lowestMap = 620;  // px, that its legend needs
constexpr double textPixels = 9.0 / 72.0 * dpi;

/// Pixels for a map of so many cells: a long bridge makes a low one.
int mapHeight(int columns, int rows) {
    const double shape = static_cast<double>(rows) / std::max(1, columns);
    return std::clamp(static_cast<int>(mapPixels.width() * shape), lowestMap, mapPixels.height());
}

int mapHeight(const DebrisMap& map) {
    if (map.cells.empty()) {
        return mapPixels.height();
    }
    const auto [west, east] = std::minmax_element(map.cells.begin(), map.cells.end(), [](auto a, auto b) { return a.i < b.i; });
    return mapHeight(east->i - west->i + 1, map.cells.back().j - map.cells.front().j + 1);
}

}  // namespace

ReportPictures drawReportPictures(const render::SceneData& data, const ReportFacts& facts, const MapPictureStyle& place,
                                  const Execution& execution) {
    Studio studio(data);
    studio.setCheck([&execution] { execution.check(); });
    ReportPictures pictures;
    FigureStyle style;
    style.dpi = dpi;
    style.pixels = {pictureWidth, 0};
    style.north = northOf(place.place, place.system);
    const render::View view = render::defaultView(data, pictureWidth, pictureWidth);
    const auto draw = [&](FigurePreset preset, double share) {
        execution.report({"report.drawing", "Drawing the figures", {}}, share);
        PresetRequest request;
        request.preset = preset;
        request.end = std::max(facts.result->endTime, facts.fe->times().back());
        return studio.sheet(presetSheet(request, view, data), style).image();
    };
    pictures.pairs = draw(FigurePreset::Pairs, 0.0);
    pictures.end = draw(FigurePreset::End, 0.4);
    pictures.stages = draw(FigurePreset::Stages, 0.6);
    execution.report({"report.drawing", "Drawing the figures", {}}, 0.9);
    MapPictureStyle map = place;
    map.pixels = mapPixels;
    map.dpi = dpi;
    map.pixels.setHeight(mapHeight(facts.map.map));
    pictures.map = mapPicture(facts.map.map, MapLayer::Mass, map);
    for (const ReportPhoto& photo : facts.photographs) {
        execution.check();
        pictures.photographs.push_back(photographPicture(photo, pictureWidth));
    }
    for (const ReportSurvey& survey : facts.surveys) {
        execution.check();
        SurveyPictureStyle drawn;
        drawn.pixels = mapPixels;
        if (survey.comparison) {
            const CellGrid& cells = survey.comparison->difference;
            drawn.pixels.setHeight(mapHeight(cells.columns, cells.rows));
        }
        drawn.textPixels = textPixels;
        drawn.place = place.place;
        drawn.system = place.system;
        drawn.caption = false;
        pictures.surveys.push_back(survey.comparison ? surveyPicture(*survey.comparison, drawn) : QImage());
    }
    if (facts.probability != nullptr) {
        map.shown = facts.ensemble ? ensembleClass(*facts.ensemble) : map.shown;
        map.pixels.setHeight(mapHeight(*facts.probability));
        pictures.probability = mapPicture(*facts.probability, MapLayer::Probability, map);
    }
    return pictures;
}

std::vector<std::string> writeReport(const std::string& folder, const ReportFacts& facts, const ReportPictures& pictures,
                                     const std::string& metadata, const Execution& execution, Findings* findings) {
    const QDir place(QString::fromStdString(folder));
    const bool made = !place.exists();
    if (!place.mkpath(QStringLiteral("."))) {
        throw WorldError({"report.folder", "The folder {0} cannot be made", {folder}},
                         {"report.folder.remedy", "Choose a folder that you may write to.", {}});
    }
    const ReportDocument document = composeReport(facts, pictures);
    const std::string html = place.filePath(QStringLiteral("report.html")).toStdString();
    const std::string pdf = place.filePath(QStringLiteral("report.pdf")).toStdString();
    const bool wasThere = QFile::exists(QString::fromStdString(html));
    Findings lacks;
    try {
        execution.check();
        writeBytes(html, reportHtml(document, metadata));
        writeReportPdf(pdf, document, metadata, lacks, execution);
    } catch (...) {
        if (!wasThere) {
            QFile::remove(QString::fromStdString(html));
        }
        // A folder of this report alone goes with it.
        if (made) {
            place.rmdir(place.absolutePath());
        }
        throw;
    }
    if (findings != nullptr) {
        findings->append(lacks);
    }
    return {html, pdf};
}

}  // namespace rubble::figures
