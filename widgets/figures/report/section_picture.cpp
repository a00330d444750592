#include "widgets/figures/report/section_picture.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainter>
#include <cmath>
#include <utility>
#include <vector>

#include "widgets/figures/palette.h"
#include "widgets/figures/report/report_chart.h"
#include "widgets/figures/translated.h"

namespace rubble::figures {

namespace {

/// Points that a picture shows at most, evenly along the line.
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

}  // namespace

QImage sectionPicture(const SiteSection& section, const SectionPictureStyle& style) {
    const Palette& colours = palette(style.theme);
    ReportChart chart;
    chart.theme = style.theme;
    chart.xTitle = tr("along the section [m]");
    chart.yTitle = tr("height [m]");
    chart.fromZero = false;
    // What was measured lies below the lines, which it would hide.
    ChartSeries measured;
    measured.colour = colours.muted;
    measured.line = false;
    const std::size_t stride = section.points.size() / pointsDrawn + 1;
    for (std::size_t p = 0; p < section.points.size(); p += stride) {
        measured.points.push_back({section.points[p].along, section.points[p].place.z() + style.zero, {}});
    }
    if (!measured.points.empty()) {
        chart.series.push_back(std::move(measured));
    }
    addProfile(chart.series, colours.text, true, section, style.zero, &SectionStep::ground);
    addProfile(chart.series, colours.fragment, false, section, style.zero, &SectionStep::simulated);
    QImage image(style.pixels, QImage::Format_RGB32);
    image.fill(style.theme == render::Theme::Print ? QColor(Qt::white) : colours.panel);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const double text = style.textPixels;
    chart.paint(painter, QRectF(text, 2.5 * text, style.pixels.width() - 2.0 * text, style.pixels.height() - 3.5 * text), text);
    QFont font = painter.font();
    font.setPixelSize(static_cast<int>(text));
    painter.setFont(font);
    double at = 6.0 * text;
    for (const auto& [name, colour] : {std::pair(tr("simulated"), colours.fragment), std::pair(tr("measured"), colours.muted),
                                       std::pair(tr("ground (dashed)"), colours.text)}) {
        painter.setPen(colour);
        painter.drawText(QPointF(at, 2.0 * text), name);
        at += QFontMetricsF(font).horizontalAdvance(name) + 2.0 * text;
    }
    return image;
}

}  // namespace rubble::figures
