#include "widgets/figures/page_pictures.h"

#include <QBuffer>

#include <algorithm>
#include <memory>

#include "core/fe/north.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/figure_sheet.h"
#include "widgets/figures/report/report_photograph.h"

namespace rubble::figures {
namespace {

constexpr QSize viewPixels(1280, 720);  // the height follows what is shown
constexpr QSize mapPixels(1500, 900);
constexpr double dpi = 130.0;
constexpr double mapDpi = 170.0;
constexpr int photographWidth = 1200;  // px
constexpr std::size_t mostTimes = 8;
constexpr int jpegQuality = 82;

std::string fileOf(const QImage& image, const char* format) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, format, QByteArray(format) == "JPG" ? jpegQuality : -1);
    return bytes.toStdString();
}

PagePicture pictureOf(const ReportPhoto& photo) {
    const QImage image = photographPicture(photo, photographWidth);
    PagePicture picture{PagePictureKind::Photograph, 0.0, photo.name, "image/jpeg", {}, photo.problem};
    if (!image.isNull()) {
        picture.bytes = fileOf(image, "JPG");
    }
    if (photo.comparison) {
        picture.note = photo.comparison->words;
    }
    for (const Caution& caution : photo.cautions) {
        if (caution.inPictures()) {
            picture.cautions.push_back(caution.what);
        }
    }
    return picture;
}

}  // namespace

std::vector<double> pageTimes(const render::SceneData& data, const std::vector<Bookmark>& bookmarks) {
    const double feEnd = data.fe->times().back();
    double end = feEnd;
    if (data.trajectory && data.trajectory->frameCount() > 0) {
        end = data.trajectory->frameTime(data.trajectory->frameCount() - 1);
    }
    const double first = data.fe->times().front();
    std::vector<double> times{first, first + (feEnd - first) / 3.0, first + 2.0 * (feEnd - first) / 3.0, feEnd, end};
    for (const Bookmark& bookmark : bookmarks) {
        if (times.size() < mostTimes) {
            times.push_back(bookmark.time);
        }
    }
    std::erase_if(times, [&](double time) { return time < first || time > end; });
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

PagePicture groundPicture(const Orthophoto& orthophoto) {
    const QImage southUp(orthophoto.rgba.data(), orthophoto.width, orthophoto.height, 4 * orthophoto.width,
                         QImage::Format_RGBA8888);
    QImage image = southUp.mirrored();
    if (std::max(image.width(), image.height()) > pageGroundPixels) {
        image = image.scaled(pageGroundPixels, pageGroundPixels, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    }
    bool whole = true;
    for (std::size_t p = 3; p < orthophoto.rgba.size(); p += 4) {
        whole = whole && orthophoto.rgba[p] == 255;
    }
    // Only PNG keeps what the picture does not cover.
    const PagePictureKind kind = PagePictureKind::Ground;
    return whole ? PagePicture{kind, 0.0, {}, "image/jpeg", fileOf(image.convertToFormat(QImage::Format_RGB888), "JPG"), {}}
                 : PagePicture{kind, 0.0, {}, "image/png", fileOf(image, "PNG"), {}};
}

std::vector<PagePicture> drawPagePictures(const render::SceneData& data, const PageDrawing& drawing, const Execution& execution) {
    const Message stage{"page.drawing", "Drawing the pictures of the page", {}};
    std::vector<PagePicture> pictures;
    Studio studio(data);
    FigureStyle style;
    style.dpi = dpi;
    style.cautions = drawing.mapStyle.cautions;
    render::View view = render::defaultView(data, viewPixels.width(), viewPixels.height());
    dress(view, render::Style::Presentation);
    // One camera for all instants, so that they can be compared.
    Sheet all;
    for (const double time : drawing.times) {
        view.time = time;
        const Sheet each = sheetOf(view);
        all.panels.insert(all.panels.end(), each.panels.begin(), each.panels.end());
    }
    studio.setCheck([&execution] { execution.check(); });
    const render::Framing framing = studio.framing(all);
    for (std::size_t i = 0; i < drawing.times.size(); ++i) {
        execution.report(stage, static_cast<double>(i) / static_cast<double>(drawing.times.size() + 1));
        view.time = drawing.times[i];
        Sheet sheet = sheetOf(view);
        sheet.framed = true;
        sheet.choices = {1, 2};
        style.pixels = {viewPixels.width(), 0};
        style.north = northOf(drawing.mapStyle.place, drawing.mapStyle.system);
        arrange(sheet, framing, style.pixels, style.dpi, false, !style.cautions.empty());
        const QImage image = studio.sheet(sheet, style).image();
        pictures.push_back({PagePictureKind::Views, view.time, {}, "image/jpeg", fileOf(image, "JPG"), {}});
    }
    if (drawing.map != nullptr) {
        MapPictureStyle map = drawing.mapStyle;
        map.pixels = mapPixels;
        map.dpi = mapDpi;
        pictures.push_back({PagePictureKind::Map,
                            drawing.map->time,
                            {},
                            "image/png",
                            fileOf(mapPicture(*drawing.map, MapLayer::Mass, map), "PNG"),
                            {}});
    }
    for (const ReportPhoto& photo : drawing.photographs) {
        execution.check();
        pictures.push_back(pictureOf(photo));
    }
    return pictures;
}

}  // namespace rubble::figures
