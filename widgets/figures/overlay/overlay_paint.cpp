#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>
#include <QTextLayout>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/figures/draw.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/overlay/overlay.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/shown_units.h"

namespace rubble::figures {
namespace {

constexpr double widestBar = 46.0;  // of a scale with its margins, in units of the look
constexpr double legendGap = 5.0;   // between entries of one line, in units of the look

/// Units of length that the axes take in the corner opposite the caption.
constexpr double axesRoom = 11.0;

/// Metrics that everything over a pane is laid out with.
struct Look {
    const Palette& palette;
    QFont font;
    double unit;  ///< 4 px of a 13 px font
    double line;
};

Look lookFor(render::Theme theme, double textHeight) {
    QFont font;
    font.setPixelSize(std::max(6, static_cast<int>(std::lround(textHeight))));
    const double unit = 4.0 * textHeight / 13.0;
    return {palette(theme), font, unit, QFontMetricsF(font).height()};
}

double widthOf(const Look& look, const QString& text) {
    return QFontMetricsF(look.font).horizontalAdvance(text);
}

void chip(QPainter& painter, const Look& look, const QRectF& box) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.palette.chip);
    painter.drawRoundedRect(box, 0.75 * look.unit, 0.75 * look.unit);
}

void write(QPainter& painter, const Look& look, const QRectF& box, const QString& text, Qt::Alignment alignment) {
    painter.setPen(look.palette.chipText);
    painter.drawText(box, static_cast<int>(alignment | Qt::AlignVCenter | Qt::TextSingleLine), text);
}

/// @return its box
QRectF paintCaption(QPainter& painter, const Look& look, const QPointF& corner, const QString& text) {
    const double pad = 2.0 * look.unit;
    const QRectF box(corner, QSizeF(widthOf(look, text) + 2.0 * pad, look.line + 1.5 * look.unit));
    chip(painter, look, box);
    write(painter, look, box, text, Qt::AlignHCenter);
    return box;
}

/// Words on as many lines as they take.
QStringList wrapped(const Look& look, double room, const QString& words) {
    QTextLayout layout(words, look.font);
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    QStringList lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(room);
        lines.push_back(words.mid(line.textStart(), line.textLength()).trimmed());
    }
    layout.endLayout();
    return lines;
}

/// In one line, or name and instant in two where the pane is narrow, or more: nothing of it may be cut off.
QStringList captionLines(const Look& look, double paneWidth, const QString& caption) {
    if (caption.isEmpty()) {
        return {};
    }
    const QString between = QStringLiteral(" · ");
    const double room = std::max(paneWidth - 8.0 * look.unit, 8.0 * look.unit);
    const qsizetype end = caption.indexOf(between);
    // The first line leaves the axes their corner, where its longest word does.
    double longest = 0.0;
    for (const QString& word : caption.left(end).split(QLatin1Char(' '))) {
        longest = std::max(longest, widthOf(look, word));
    }
    const double besideAxes = room - axesRoom * look.unit;
    const double first = besideAxes > longest ? besideAxes : room;
    if (end < 0 || widthOf(look, caption) <= first) {
        return wrapped(look, first, caption);
    }
    return wrapped(look, first, caption.left(end)) + wrapped(look, room, caption.mid(end + between.size()));
}

/// The caption, and what moving leaves out: beside it, or below where that is too long.
void paintCaptions(QPainter& painter, const Look& look, const QRectF& pane, const Overlay& overlay) {
    const double pad = 2.0 * look.unit;
    QPointF corner(pane.left() + pad, pane.top() + pad);
    QRectF box;
    for (const QString& line : captionLines(look, pane.width(), overlay.caption)) {
        corner = box.isNull() ? corner : QPointF(box.left(), box.bottom());
        box = paintCaption(painter, look, corner, line);
    }
    if (!box.isNull()) {
        const double axes = axesRoom * look.unit;
        const bool beside = box.right() + look.unit + widthOf(look, overlay.moving) + 3.0 * pad <= pane.right() - axes;
        corner = beside ? QPointF(box.right() + look.unit, box.top()) : QPointF(box.left(), box.bottom() + look.unit);
    }
    if (!overlay.moving.isEmpty()) {
        for (const QString& line :
             wrapped(look, std::max(pane.right() - corner.x() - 6.0 * look.unit, 8.0 * look.unit), overlay.moving)) {
            corner = paintCaption(painter, look, corner, line).bottomLeft();
        }
    }
}

void swatch(QPainter& painter, const Look& look, const LegendEntry& entry, double x, double middle) {
    const double side = 2.25 * look.unit;
    const QRectF square(x, middle - 0.5 * side, side, side);
    if (entry.outlined) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(entry.colour, 0.5 * look.unit));
        painter.drawEllipse(square.adjusted(0.25 * look.unit, 0.25 * look.unit, -0.25 * look.unit, -0.25 * look.unit));
        return;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(entry.colour);
    painter.drawRoundedRect(square, 0.4 * look.unit, 0.4 * look.unit);
}

double entryWidth(const Look& look, const LegendEntry& entry) {
    return (entry.colour.isValid() ? 4.0 * look.unit : 0.0) + widthOf(look, entry.text);
}

/// The lines of an entry of a legend. Where the room is narrow it is broken, or cut in its middle: its count is at its end.
QStringList entryLines(const Look& look, const LegendEntry& entry, double room, bool broken) {
    if (entryWidth(look, entry) <= room) {
        return {entry.text};
    }
    room -= entryWidth(look, entry) - widthOf(look, entry.text);
    return broken ? wrapped(look, room, entry.text)
                  : QStringList{QFontMetricsF(look.font).elidedText(entry.text, Qt::ElideMiddle, room)};
}

void paintEntry(QPainter& painter, const Look& look, const LegendEntry& entry, const QStringList& lines, double x, double top) {
    if (entry.colour.isValid()) {
        swatch(painter, look, entry, x, top + 0.5 * look.line);
        x += 4.0 * look.unit;
    }
    for (const QString& line : lines) {
        write(painter, look, QRectF(x, top, widthOf(look, line) + look.unit, look.line), line, Qt::AlignLeft);
        top += look.line;
    }
}

constexpr double rampWidth = 30.0;  // of a colour bar, in units of the look
constexpr double leastRamp = 6.0;   // where the room is narrow

/// @param ramp  of its colours alone, in units of the look
double barWidth(const Look& look, const ColourBar& bar, double ramp = rampWidth) {
    return widthOf(look, bar.title) + widthOf(look, bar.low) + widthOf(look, bar.high) + (ramp + 8.0) * look.unit;
}

/// In units of the look: as long as there is room for.
double rampIn(const Look& look, const ColourBar& bar, double room) {
    return std::clamp((room - barWidth(look, bar, 0.0)) / look.unit, leastRamp, rampWidth);
}

void paintBar(QPainter& painter, const Look& look, const ColourBar& bar, double x, double top, double ramped = rampWidth) {
    const auto put = [&](const QString& text) {
        write(painter, look, QRectF(x, top, 4096.0, look.line), text, Qt::AlignLeft);
        x += widthOf(look, text) + 2.0 * look.unit;
    };
    put(bar.title);
    x += 1.0 * look.unit;
    put(bar.low);
    QLinearGradient ramp(x, 0.0, x + ramped * look.unit, 0.0);
    for (int i = 0; i <= 16; ++i) {
        ramp.setColorAt(i / 16.0, bar.birthTime ? birthColour(i / 16.0, bar.map) : speedColour(i / 16.0, bar.map));
    }
    painter.setPen(QPen(look.palette.muted, 0.0));
    painter.setBrush(ramp);
    painter.drawRect(QRectF(x, top + 0.5 * look.line - 1.25 * look.unit, ramped * look.unit, 2.5 * look.unit));
    x += (ramped + 2.0) * look.unit;
    put(bar.high);
}

/// Where an entry of a legend stands: its line and its distance from the left of the first, device pixels.
struct LegendPlace {
    double width;       ///< device pixels
    QStringList texts;  ///< its lines; of a bar none
    std::size_t line = 0;
    double x = 0.0;

    std::size_t lines() const { return std::max<std::size_t>(1, static_cast<std::size_t>(texts.size())); }
};

/// Entries one after the other, in as many lines as they need.
std::vector<LegendPlace> legendPlaces(const Look& look, const Overlay& overlay, double room, bool broken) {
    std::vector<LegendPlace> places;
    for (const LegendEntry& entry : overlay.legend) {
        places.push_back({std::min(entryWidth(look, entry), room), entryLines(look, entry, room, broken)});
    }
    for (const ColourBar& bar : overlay.bars) {
        places.push_back({barWidth(look, bar, rampIn(look, bar, room)), {}});
    }
    std::size_t line = 0;
    std::size_t tallest = 1;
    double x = 0.0;
    for (LegendPlace& place : places) {
        if (x > 0.0 && x + place.width > room) {
            line += tallest;
            tallest = 1;
            x = 0.0;
        }
        place.line = line;
        place.x = x;
        tallest = std::max(tallest, place.lines());
        x += place.width + 3.0 * look.unit;
    }
    return places;
}

double chipHeight(const Look& look, std::size_t lines) {
    const double count = static_cast<double>(lines);
    return count * look.line + (count - 1.0) * look.unit + 1.5 * look.unit;
}

double scaleBarHeight(const Look& look) {
    return look.line + 3.5 * look.unit;
}

double legendRoom(const Look& look, double paneWidth, double reservedRight) {
    return paneWidth - 8.0 * look.unit - reservedRight;
}

/// Where all entries stand, and how far above the foot of the strip, device pixels.
struct LegendLayout {
    std::vector<LegendPlace> places;
    double above = 0.0;

    std::size_t lines() const {
        std::size_t count = 0;
        for (const LegendPlace& place : places) {
            count = std::max(count, place.line + place.lines());
        }
        return count;
    }
    bool wrapped() const {
        return std::any_of(places.begin(), places.end(), [](const LegendPlace& place) { return place.lines() > 1; });
    }
};

/// Long entries are broken, but not where a narrow pane would hold nothing but its legend.
LegendLayout layoutIn(const Look& look, const Overlay& overlay, double room) {
    constexpr std::size_t mostLines = 4;
    LegendLayout broken{legendPlaces(look, overlay, room, true)};
    return broken.wrapped() && broken.lines() > mostLines ? LegendLayout{legendPlaces(look, overlay, room, false)} : broken;
}

/// Beside the scale bar, or above it over the whole width where that takes less height.
LegendLayout legendLayout(const Look& look, const Overlay& overlay, double paneWidth, double reservedRight) {
    const double room = legendRoom(look, paneWidth, reservedRight);
    LegendLayout beside = layoutIn(look, overlay, room);
    // An entry that is broken or cut says less than one a line higher.
    const bool narrow = std::any_of(overlay.legend.begin(), overlay.legend.end(),
                                    [&](const LegendEntry& entry) { return entryWidth(look, entry) > room; });
    if (!(reservedRight > 0.0) || (beside.lines() < 3 && !narrow)) {
        return beside;
    }
    LegendLayout over = layoutIn(look, overlay, legendRoom(look, paneWidth, 0.0));
    over.above = scaleBarHeight(look) + look.unit;
    return narrow || chipHeight(look, over.lines()) + over.above < chipHeight(look, beside.lines()) ? over : beside;
}

/// Legend and colour bar share one chip in the free strip below the model, in as few lines as they fit.
void paintLegend(QPainter& painter, const Look& look, const QRectF& pane, const Overlay& overlay, double reservedRight) {
    const LegendLayout layout = legendLayout(look, overlay, pane.width(), reservedRight);
    if (layout.places.empty()) {
        return;
    }
    const double pad = 2.0 * look.unit;
    double widest = 0.0;
    for (const LegendPlace& place : layout.places) {
        widest = std::max(widest, place.x + place.width);
    }
    const double height = chipHeight(look, layout.lines());
    const QRectF box(pane.left() + pad, pane.bottom() - pad - layout.above - height, widest + 2.0 * pad, height);
    chip(painter, look, box);
    for (std::size_t i = 0; i < layout.places.size(); ++i) {
        const LegendPlace& place = layout.places[i];
        const double x = box.left() + pad + place.x;
        const double y = box.top() + 0.75 * look.unit + static_cast<double>(place.line) * (look.line + look.unit);
        if (i < overlay.legend.size()) {
            paintEntry(painter, look, overlay.legend[i], place.texts, x, y);
        } else {
            const ColourBar& bar = overlay.bars[i - overlay.legend.size()];
            paintBar(painter, look, bar, x, y, rampIn(look, bar, place.width));
        }
    }
}

/// The longest round length that fits, m.
double barLength(const Look& look, double metresPerPixel, double room) {
    return roundLength(metresPerPixel, std::min(0.2 * room, 40.0 * look.unit));
}

/// A bar with ticks at its ends, up from its line.
void strokeBar(QPainter& painter, const Look& look, double x, double y, double pixels) {
    painter.setPen(QPen(look.palette.chipText, std::max(1.0, 0.3 * look.unit), Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(Qt::NoBrush);
    const double tick = 1.25 * look.unit;
    const std::array<QPointF, 4> points{QPointF(x, y - tick), QPointF(x, y), QPointF(x + pixels, y), QPointF(x + pixels, y - tick)};
    painter.drawPolyline(points.data(), static_cast<int>(points.size()));
}

/// Returns the width it took.
double paintScaleBar(QPainter& painter, const Look& look, const QRectF& pane, double metresPerPixel) {
    const double length = barLength(look, metresPerPixel, pane.width());
    if (!(length > 0)) {
        return 0.0;
    }
    const double pixels = length / metresPerPixel;
    const QString text = lengthText(length);
    const double pad = 2.0 * look.unit;
    const double width = std::max(pixels, widthOf(look, text)) + 2.0 * pad;
    const QRectF box(pane.right() - pad - width, pane.bottom() - pad - scaleBarHeight(look), width, scaleBarHeight(look));
    chip(painter, look, box);
    write(painter, look, QRectF(box.left(), box.top() + 0.5 * look.unit, box.width(), look.line), text, Qt::AlignHCenter);
    strokeBar(painter, look, box.center().x() - 0.5 * pixels, box.bottom() - 1.25 * look.unit, pixels);
    return width + pad;
}

}  // namespace

double roundLength(double metresPerPixel, double maxPixels) {
    const double perSi = shownUnit("m").perSi;
    const double longest = metresPerPixel * maxPixels * perSi;
    if (!(longest > 0) || !std::isfinite(longest)) {
        return 0.0;
    }
    const double power = std::pow(10.0, std::floor(std::log10(longest)));
    const double mantissa = longest / power;
    return power * (mantissa >= 5.0 ? 5.0 : mantissa >= 2.0 ? 2.0 : 1.0) / perSi;
}

void paintOverlay(QPainter& painter, const Overlay& overlay, const render::Pane& pane, render::Theme theme, double textHeight) {
    const Look look = lookFor(theme, textHeight);
    const QRectF area(pane.x, pane.y, pane.width, pane.height);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(look.font);
    painter.setClipRect(area);
    paintCaptions(painter, look, area, overlay);
    const double taken = overlay.metresPerPixel > 0 ? paintScaleBar(painter, look, area, overlay.metresPerPixel) : 0.0;
    paintLegend(painter, look, area, overlay, taken);
    painter.restore();
}

double overlayRoom(const Overlay& overlay, double paneWidth, double textHeight) {
    const Look look = lookFor(render::Theme::Light, textHeight);
    const double bar = overlay.metresPerPixel > 0.0 ? widestBar * look.unit : 0.0;
    const LegendLayout legend = legendLayout(look, overlay, paneWidth, bar);
    const auto captions = static_cast<double>(captionLines(look, paneWidth, overlay.caption).size());
    const double below = legend.lines() == 0 ? 0.0 : chipHeight(look, legend.lines()) + legend.above;
    const double room = std::max(below, captions * chipHeight(look, 1));
    return room > 0.0 ? room + 4.0 * look.unit : 0.0;
}

double legendLineWidth(const std::vector<LegendEntry>& legend, const std::vector<ColourBar>& bars, double textHeight) {
    const Look look = lookFor(render::Theme::Print, textHeight);
    double width = 0.0;
    for (const LegendEntry& entry : legend) {
        width += entryWidth(look, entry) + legendGap * look.unit;
    }
    for (const ColourBar& bar : bars) {
        width += barWidth(look, bar) + legendGap * look.unit;
    }
    return std::max(0.0, width - legendGap * look.unit);
}

double scaleLineWidth(double metresPerPixel, double room, double textHeight) {
    const Look look = lookFor(render::Theme::Print, textHeight);
    const double length = metresPerPixel > 0.0 ? barLength(look, metresPerPixel, room) : 0.0;
    return length > 0.0 ? length / metresPerPixel + 2.0 * look.unit + widthOf(look, lengthText(length)) : 0.0;
}

double paintScaleLine(QPainter& painter, double metresPerPixel, const render::Pane& strip, double textHeight) {
    const Look look = lookFor(render::Theme::Print, textHeight);
    const double width = scaleLineWidth(metresPerPixel, strip.width, textHeight);
    if (!(width > 0.0)) {
        return 0.0;
    }
    const double length = barLength(look, metresPerPixel, strip.width);
    const double pixels = length / metresPerPixel;
    const double pad = 2.0 * look.unit;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(look.font);
    const double x = strip.x + strip.width - pad - width;
    const double middle = strip.y + 0.5 * strip.height;
    strokeBar(painter, look, x, middle + 0.6 * look.unit, pixels);
    write(painter, look, QRectF(x + pixels + pad, middle - 0.5 * look.line, width - pixels, look.line), lengthText(length),
          Qt::AlignLeft);
    painter.restore();
    return width + 2.0 * pad;
}

void paintLegendLine(QPainter& painter, const std::vector<LegendEntry>& legend, const std::vector<ColourBar>& bars,
                     const render::Pane& strip, double textHeight) {
    const Look look = lookFor(render::Theme::Print, textHeight);
    const double gap = legendGap * look.unit;
    const double width = legendLineWidth(legend, bars, textHeight);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(look.font);
    double x = strip.x + 0.5 * (strip.width - width);
    const double top = strip.y + 0.5 * (strip.height - look.line);
    for (const LegendEntry& entry : legend) {
        paintEntry(painter, look, entry, {entry.text}, x, top);
        x += entryWidth(look, entry) + gap;
    }
    for (const ColourBar& bar : bars) {
        paintBar(painter, look, bar, x, top);
        x += barWidth(look, bar) + gap;
    }
    painter.restore();
}

}  // namespace rubble::figures
