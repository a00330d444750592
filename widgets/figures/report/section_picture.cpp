#include "widgets/figures/report/section_picture.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "widgets/figures/number_text.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/report/report_chart.h"
#include "widgets/figures/sheets/sheet_text.h"
#include "widgets/figures/translated.h"

namespace rubble::figures {

namespace {

/// Points that a picture shows at most, evenly along the line; the key says where it shows fewer than there are.
constexpr std::size_t pointsDrawn = 1500;

/// A line for the heights that are there; where there are none it ends and begins anew.
void addProfile(std::vector<ChartSeries>& series, const QColor& colour, bool dashed, const SiteSection& section, double zero,
                double SectionStep::* height) {
    ChartSeries line;
    line.colour = colour;
    line.dashed = dashed;
    for (const SectionStep& step : section.steps) {
        if (std::isfinite(step.*height)) {
            line.points.push_back({step.along, step.*height + zero, {}});
        } else if (!line.points.empty()) {
            series.push_back(line);
            line.points.clear();
        }
    }
    if (!line.points.empty()) {
        series.push_back(std::move(line));
    }
}

/// What a line or a mark stands for.
struct KeyEntry {
    QString name;
    QColor colour;
    std::optional<ChartMark> mark;  ///< unset: a line
    QString note = {};              ///< behind the name, never cut
};

/// Writes the key from left to right, in as many rows as it takes. @returns pixels, where it ends below
double paintKey(QPainter& painter, const std::vector<KeyEntry>& key, double width, double text) {
    painter.setFont(sheetFont(text));
    const QFontMetricsF metrics(painter.font());
    const double left = 2.0 * text;
    const double longest = 0.5 * width - left;
    double x = left;
    double y = 2.0 * text;
    for (const KeyEntry& entry : key) {
        const QString name =
            metrics.elidedText(entry.name, Qt::ElideMiddle, longest - metrics.horizontalAdvance(entry.note)) + entry.note;
        const double wide = metrics.horizontalAdvance(name) + (entry.mark ? text : 0.0);
        if (x > left && x + wide > width - text) {
            x = left;
            y += 1.5 * text;
        }
        double at = x;
        if (entry.mark) {
            paintMark(painter, *entry.mark, entry.colour, QPointF(x + 0.3 * text, y - 0.35 * text), 0.35 * text);
            at += text;
        }
        painter.setPen(entry.colour);
        painter.drawText(QPointF(at, y), name);
        x += wide + 1.5 * text;
    }
    return y + 0.5 * text;
}

/// Mark and colour of a set, in turn: the first in grey, and none in the colour of what is simulated.
std::pair<ChartMark, QColor> markOf(std::size_t source, const Palette& colours) {
    static constexpr std::array marks{ChartMark::Dot, ChartMark::Triangle, ChartMark::Square, ChartMark::Diamond};
    std::vector<QColor> tones{colours.muted};
    std::copy_if(colours.categories.begin(), colours.categories.end(), std::back_inserter(tones),
                 [&](const QColor& tone) { return tone != colours.fragment; });
    return {marks[source % marks.size()], tones[source % tones.size()]};
}

std::size_t pointsOf(const SiteSection& section, std::size_t source) {
    return static_cast<std::size_t>(section.sources[source].agreement.points);
}

/// One of how many points is drawn. A sparse set keeps all of its points beside a dense one.
std::size_t strideOf(const SiteSection& section, std::size_t source) {
    return pointsOf(section, source) > pointsDrawn / 4 ? section.points.size() / pointsDrawn + 1 : 1;
}

QString placeText(double metres) {
    constexpr double thousand = 1000.0;
    constexpr int digits = 12;
    return QString::number(std::round(metres * thousand) / thousand, 'g', digits).replace(u'-', QStringLiteral("−"));
}

/// Writes the note from the foot upwards. @returns pixels, how high it is
double paintNote(QPainter& painter, const SectionNote& note, const QSize& pixels, double text, const QColor& colour) {
    const QString system = note.system.empty() ? tr("local coordinates") : QString::fromStdString(note.system);
    QStringList lines{tr("%1, from %2, %3 to %4, %5 m (easting, northing; %6), %7 wide")
                          .arg(timeText(note.time), placeText(note.from.x()), placeText(note.from.y()), placeText(note.to.x()),
                               placeText(note.to.y()), system, lengthText(note.width))};
    if (!note.cautions.isEmpty()) {
        lines << note.cautions;
    }
    lines << QString::fromStdString(note.provenance);
    const QRectF room(2.0 * text, 0.0, pixels.width() - 3.0 * text, pixels.height() - 0.5 * text);
    painter.setFont(sheetFont(0.75 * text));
    painter.setPen(colour);
    const QString words = lines.join(QLatin1Char('\n'));
    QRectF taken;
    painter.drawText(room, Qt::AlignBottom | Qt::AlignLeft | Qt::TextWordWrap, words, &taken);
    return pixels.height() - taken.top();
}

QString counted(std::size_t count) {
    return QLocale().toString(static_cast<qulonglong>(count));
}

}  // namespace

std::size_t drawnPoints(const SiteSection& section, std::size_t source) {
    const std::size_t stride = strideOf(section, source);
    return (pointsOf(section, source) + stride - 1) / stride;
}

QImage sectionPicture(const SiteSection& section, const SectionPictureStyle& style) {
    const Palette& colours = palette(style.theme);
    ReportChart chart;
    chart.theme = style.theme;
    chart.xTitle = tr("along the section [m]");
    chart.yTitle = tr("height [m]");
    chart.fromZero = false;
    // What was measured lies below the lines, which it would hide.
    std::vector<KeyEntry> key{{tr("simulated: debris, structure or ground"), colours.fragment, {}},
                              {tr("ground (dashed)"), colours.text, {}}};
    for (std::size_t source = 0; source < section.sources.size(); ++source) {
        ChartSeries measured;
        std::tie(measured.mark, measured.colour) = markOf(source, colours);
        measured.line = false;
        const std::size_t each = strideOf(section, source);
        std::size_t met = 0;
        for (const SectionPoint& point : section.points) {
            if (point.source == source && met++ % each == 0) {
                measured.points.push_back({point.along, point.place.z() + style.zero, {}});
            }
        }
        key.push_back(
            {QString::fromStdString(section.sources[source].name), measured.colour, measured.mark,
             each > 1 ? u' ' + tr("(%1 of %2 points drawn)").arg(counted(drawnPoints(section, source)), counted(met)) : QString()});
        if (!measured.points.empty()) {
            chart.series.push_back(std::move(measured));
        }
    }
    if (std::isfinite(section.water)) {
        ChartSeries water;
        water.colour = colours.water;
        const double height = section.water + style.zero;
        water.points = {{0.0, height, {}}, {section.line.length(), height, {}}};
        chart.series.push_back(std::move(water));
        key.push_back({tr("water (still surface)"), colours.water, {}});
    }
    addProfile(chart.series, colours.text, true, section, style.zero, &SectionStep::ground);
    addProfile(chart.series, colours.fragment, false, section, style.zero, &SectionStep::simulated);
    QImage image(style.pixels, QImage::Format_RGB32);
    image.fill(style.theme == render::Theme::Print ? QColor(Qt::white) : colours.panel);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const double text = style.textPixels;
    const double top = paintKey(painter, key, style.pixels.width(), text);
    const double foot = style.note ? paintNote(painter, *style.note, style.pixels, text, colours.text) : 0.0;
    const double below = std::max(text, foot + 0.5 * text);
    chart.paint(painter, QRectF(text, top, style.pixels.width() - 2.0 * text, style.pixels.height() - top - below), text);
    return image;
}

}  // namespace rubble::figures
