#include "widgets/figures/overlay.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "widgets/figures/draw.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/shown_units.h"
#include "widgets/figures/translated.h"
#include "widgets/render/basics/camera.h"
#include "widgets/render/basics/colour_choice.h"

namespace rubble::figures {
namespace {

constexpr std::size_t longestLegend = 6;
constexpr double legendGap = 5.0;  // between entries of one line, in units of the look

QColor colourOf(const render::Rgb& c) {
    return {c.r, c.g, c.b};
}

/// One line for each component that has most fragments, the rest in one.
void addComponents(std::vector<LegendEntry>& legend, const render::View& view, const render::SceneData& data,
                   const render::PaneStatus& status, const render::SceneColours& colours) {
    const auto& components = data.components;
    if (!components || status.bornByComponent.size() != components->list.size()) {
        return;
    }
    std::vector<std::size_t> order(components->list.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return status.bornByComponent[a] > status.bornByComponent[b]; });
    std::erase_if(order, [&](std::size_t c) { return status.bornByComponent[c] == 0; });
    const std::size_t shown = order.size() > longestLegend ? longestLegend - 1 : order.size();
    std::size_t rest = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t c = order[i];
        if (i >= shown) {
            rest += status.bornByComponent[c];
            continue;
        }
        const auto chosen = view.componentColours.find(components->list[c].name);
        legend.push_back(
            {colourOf(chosen != view.componentColours.end() ? chosen->second : render::colour_choice::category(colours, c)),
             QString::fromStdString(components->list[c].name) + QStringLiteral(" · ") + countText(status.bornByComponent[c])});
    }
    if (rest > 0) {
        legend.push_back({QColor(), tr("%1 more components · %2").arg(order.size() - shown).arg(countText(rest))});
    }
}

/// What stands, and one line for each of the largest islands with its number, the rest in one.
void addIslands(std::vector<LegendEntry>& legend, const Palette& p, const render::PaneStatus& status,
                const render::SceneColours& colours) {
    if (!status.islandsKnown) {
        legend.push_back({QColor(), tr("loose islands are not known yet")});
        return;
    }
    const auto& islands = status.islands;
    const std::size_t shown = islands.size() > longestLegend ? longestLegend - 1 : islands.size();
    const std::size_t loose =
        std::accumulate(islands.begin(), islands.end(), std::size_t{0},
                        [](std::size_t sum, const render::ShownIsland& island) { return sum + island.elements; });
    legend.push_back({p.structure, tr("not loose")});
    legend.push_back({QColor(), tr("in loose islands %1").arg(countText(loose))});
    for (std::size_t i = 0; i < shown; ++i) {
        // Counted from 1, as rubble-cli inspect does.
        legend.push_back({colourOf(render::colour_choice::category(colours, islands[i].category)),
                          tr("island %1 · %2").arg(countText(islands[i].island + 1), countText(islands[i].elements))});
    }
    if (shown < islands.size()) {
        legend.push_back({QColor(), tr("smaller islands: %1").arg(countText(islands.size() - shown))});
    }
}

/// The next number with two digits, for what need not be told more finely.
double twoDigitsUp(double value) {
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return std::ceil(value / step) * step;
}

/// One entry for each material that a component has.
void addMaterials(std::vector<LegendEntry>& legend, const render::SceneData& data, const render::SceneColours& colours) {
    std::array<bool, materialCount> present{};
    for (std::size_t c = 0; data.components && c < data.components->list.size(); ++c) {
        present[static_cast<std::size_t>(data.components->list[c].material)] = true;
    }
    const std::array<QString, materialCount> names{tr("stone"),   tr("concrete"), tr("steel"),
                                                   tr("masonry"), tr("soil"),     tr("water bed")};
    for (std::size_t m = 0; m < materialCount; ++m) {
        if (present[m]) {
            legend.push_back({colourOf(colours.materials[m]), names[m]});
        }
    }
}

/// One line for each step of the error, with its count.
void addErrors(Overlay& overlay, const render::View& view, const render::PaneStatus& status, const Palette& p) {
    if (view.errorSteps.empty() || status.errors.size() != view.errorSteps.size() + 1) {
        overlay.legend.push_back(
            {p.fragment, tr("fragments %1, no reference: errors are not known").arg(countText(status.fragments))});
        return;
    }
    overlay.legend.push_back({QColor(), tr("error against the reference:")});
    const std::size_t last = view.errorSteps.size();
    for (std::size_t i = 0; i <= last; ++i) {
        const QString bound = lengthText(view.errorSteps[std::min(i, last - 1)]);
        const QString range = i == last ? tr("over %1").arg(bound) : tr("≤ %1").arg(bound);
        overlay.legend.push_back({errorColour(static_cast<double>(i) / static_cast<double>(last)),
                                  range + QStringLiteral(" · ") + countText(status.errors[i])});
    }
    if (status.errorsUnknown > 0) {
        overlay.legend.push_back({p.muted, tr("not in the reference · %1").arg(countText(status.errorsUnknown))});
    }
}

void addFragments(Overlay& overlay, const render::View& view, const render::Scene& scene, const render::SceneData& data,
                  const render::PaneStatus& status, const render::SceneColours& colours) {
    const Palette& p = palette(view.theme);
    const QString count = countText(status.fragments);
    switch (view.colourBy) {
        case render::ColourBy::Highlight:
        case render::ColourBy::Island:
            overlay.legend.push_back(
                {view.style == render::Style::Presentation ? QColor() : p.fragment, tr("fragments %1").arg(count)});
            break;
        case render::ColourBy::Component:
            addComponents(overlay.legend, view, data, status, colours);
            if (overlay.legend.empty()) {
                overlay.legend.push_back({p.fragment, tr("fragments %1").arg(count)});
            }
            break;
        case render::ColourBy::Cluster:
            overlay.legend.push_back({QColor(), tr("fragments %1 in %2 clusters").arg(count, countText(status.clusters))});
            break;
        case render::ColourBy::BirthTime: {
            const auto [first, last] = scene.birthSpan();
            overlay.legend.push_back({QColor(), tr("fragments %1").arg(count)});
            overlay.bars.push_back({true, timeText(first), timeText(last), tr("birth time"), view.colourMap});
            break;
        }
        case render::ColourBy::Error:
            addErrors(overlay, view, status, p);
            break;
        case render::ColourBy::Speed:
            overlay.legend.push_back({QColor(), tr("fragments %1").arg(count)});
            overlay.bars.push_back({false, speedText(0.0), speedText(scene.speedTop()), tr("speed"), view.colourMap});
            break;
    }
}

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

void paintCaption(QPainter& painter, const Look& look, const QRectF& pane, const QString& caption) {
    const double pad = 2.0 * look.unit;
    const double room = pane.width() - 4.0 * pad;
    const QString text = QFontMetricsF(look.font).elidedText(caption, Qt::ElideRight, room);
    const QRectF box(pane.left() + pad, pane.top() + pad, widthOf(look, text) + 2.0 * pad, look.line + 1.5 * look.unit);
    chip(painter, look, box);
    write(painter, look, box, text, Qt::AlignHCenter);
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

void paintEntry(QPainter& painter, const Look& look, const LegendEntry& entry, double x, double top) {
    if (entry.colour.isValid()) {
        swatch(painter, look, entry, x, top + 0.5 * look.line);
        x += 4.0 * look.unit;
    }
    write(painter, look, QRectF(x, top, 4096.0, look.line), entry.text, Qt::AlignLeft);
}

double barWidth(const Look& look, const ColourBar& bar) {
    return widthOf(look, bar.title) + widthOf(look, bar.low) + widthOf(look, bar.high) + 38.0 * look.unit;
}

void paintBar(QPainter& painter, const Look& look, const ColourBar& bar, double x, double top) {
    const auto put = [&](const QString& text) {
        write(painter, look, QRectF(x, top, 4096.0, look.line), text, Qt::AlignLeft);
        x += widthOf(look, text) + 2.0 * look.unit;
    };
    put(bar.title);
    x += 1.0 * look.unit;
    put(bar.low);
    QLinearGradient ramp(x, 0.0, x + 30.0 * look.unit, 0.0);
    for (int i = 0; i <= 16; ++i) {
        ramp.setColorAt(i / 16.0, bar.birthTime ? birthColour(i / 16.0, bar.map) : speedColour(i / 16.0, bar.map));
    }
    painter.setPen(QPen(look.palette.muted, 0.0));
    painter.setBrush(ramp);
    painter.drawRect(QRectF(x, top + 0.5 * look.line - 1.25 * look.unit, 30.0 * look.unit, 2.5 * look.unit));
    x += 32.0 * look.unit;
    put(bar.high);
}

/// Legend and colour bar share one chip: side by side at the lower left while there is room, else one under the other above.
void paintLegend(QPainter& painter, const Look& look, const QRectF& pane, const Overlay& overlay, double reservedRight) {
    if (overlay.legend.empty() && overlay.bars.empty()) {
        return;
    }
    const double pad = 2.0 * look.unit;
    const double gap = 3.0 * look.unit;
    double along = 0.0;
    double widest = 0.0;
    for (const LegendEntry& entry : overlay.legend) {
        along += entryWidth(look, entry) + gap;
        widest = std::max(widest, entryWidth(look, entry));
    }
    for (const ColourBar& bar : overlay.bars) {
        along += barWidth(look, bar) + gap;
        widest = std::max(widest, barWidth(look, bar));
    }
    along -= gap;
    const bool inRow = along + 4.0 * pad + reservedRight <= pane.width();
    const double rows = inRow ? 1.0 : static_cast<double>(overlay.legend.size() + overlay.bars.size());
    const double height = rows * look.line + (rows - 1.0) * look.unit + 1.5 * look.unit;
    // Debris lies low: what needs several lines goes below the caption, into the sky.
    const double captionHeight = overlay.caption.isEmpty() ? 0.0 : look.line + 1.5 * look.unit + pad;
    const double top = inRow ? pane.bottom() - pad - height : pane.top() + pad + captionHeight;
    const QRectF box(pane.left() + pad, top, (inRow ? along : widest) + 2.0 * pad, height);
    chip(painter, look, box);
    double x = box.left() + pad;
    double y = box.top() + 0.75 * look.unit;
    const auto next = [&](double width) { inRow ? x += width + gap : y += look.line + look.unit; };
    for (const LegendEntry& entry : overlay.legend) {
        paintEntry(painter, look, entry, x, y);
        next(entryWidth(look, entry));
    }
    for (const ColourBar& bar : overlay.bars) {
        paintBar(painter, look, bar, x, y);
        next(barWidth(look, bar));
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
    const QRectF box(pane.right() - pad - width, pane.bottom() - pad - look.line - 3.5 * look.unit, width,
                     look.line + 3.5 * look.unit);
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

QString captionText(render::PaneContent content, const render::PaneStatus& status) {
    const bool fe = content == render::PaneContent::Fe;
    const QString name = fe                                        ? tr("Conventional FE result")
                         : content == render::PaneContent::Overlay ? tr("Fragments and intact outline")
                         : content == render::PaneContent::Plan    ? tr("Fragments in plan")
                                                                   : tr("Fragments");
    if (status.states == 0) {
        return content == render::PaneContent::Other ? tr("No run of another scenario is chosen") : name;
    }
    QString how;
    if (fe) {
        how = status.interpolated ? tr("interpolated after state %1 of %2")
              : status.afterFeEnd ? tr("last state, %1 of %2")
                                  : tr("state %1 of %2");
        how = how.arg(status.state + 1).arg(status.states);
    } else if (!status.simulated) {
        how = tr("not simulated, at their birth places");
    } else if (status.waitsForRun) {
        how = tr("simulated so far");
    } else {
        how = status.kind == FrameKind::Interpolated ? tr("simulated, interpolated") : tr("simulated");
    }
    return tr("%1 · t = %2, %3").arg(name, timeText(status.time), how);
}

Overlay makeOverlay(const render::View& view, const render::Scene& scene, const render::Pane& pane) {
    Overlay overlay;
    const render::PaneStatus& status = scene.status(pane.content);
    const render::SceneData& data = scene.dataOf(pane.content);
    if (view.captions) {
        render::PaneStatus counted = status;
        counted.time -= view.timeOrigin;
        overlay.caption = captionText(pane.content, counted);
        if (pane.content == render::PaneContent::Other && !scene.otherScenario().empty()) {
            overlay.caption = tr("Scenario %1 · %2").arg(QString::fromStdString(scene.otherScenario()), overlay.caption);
        }
    }
    if (view.legends && status.states > 0) {
        const Palette& p = palette(view.theme);
        const bool byIsland = view.colourBy == render::ColourBy::Island;
        if (pane.content != render::PaneContent::Fe && data.fragments) {
            addFragments(overlay, view, scene, data, status, sceneColours(view.theme, view.colourMap));
            const bool plain = view.style == render::Style::Presentation || byIsland;
            overlay.legend.push_back({plain ? QColor() : p.structure, tr("active structure %1").arg(countText(status.active))});
            if (pane.content == render::PaneContent::Overlay) {
                overlay.legend.push_back({p.outline, tr("intact structure"), true});
            }
            if (status.released > 0) {
                overlay.legend.push_back(
                    {plain ? QColor() : p.released, tr("released structure %1").arg(countText(status.released))});
            }
            if (view.style == render::Style::Presentation) {
                addMaterials(overlay.legend, data, sceneColours(view.theme));
            }
        } else {
            const bool material = view.style == render::Style::Presentation;
            overlay.legend.push_back({material || byIsland ? QColor() : p.structure,
                                      tr("active %1 of %2 elements").arg(countText(status.active), countText(status.elements))});
            if (material) {
                addMaterials(overlay.legend, data, sceneColours(view.theme));
            }
        }
        if (byIsland) {
            addIslands(overlay.legend, p, status, sceneColours(view.theme));
        }
        if (view.clip) {
            overlay.legend.push_back({QColor(), tr("cut open")});
        }
        if (status.hidden > 0) {
            overlay.legend.push_back({QColor(), tr("hidden %1").arg(countText(status.hidden))});
        }
        if (status.meeting && pane.content != render::PaneContent::Fe) {
            overlay.legend.push_back(
                {QColor(), tr("filter: %1 of %2 shown").arg(countText(*status.meeting), countText(status.fragments))});
        }
        if (!view.selection.empty()) {
            overlay.legend.push_back({p.accent, tr("selected %1").arg(countText(view.selection.size())), true});
        }
    }
    // One line, so that the legend stays where it is at rest.
    QStringList simplified;
    if (status.simplifiedTo > 0.0) {
        simplified.push_back(tr("to within %1").arg(lengthText(twoDigitsUp(status.simplifiedTo))));
    }
    if (status.resolution < 1.0) {
        simplified.push_back(tr("resolution %1 %").arg(std::lround(100.0 * status.resolution)));
    }
    if (status.statesApart > 1) {
        simplified.push_back(tr("over %1 FE intervals").arg(status.statesApart));
    }
    if (!simplified.isEmpty()) {
        overlay.legend.push_back({QColor(), tr("simplified while moving: %1").arg(simplified.join(QStringLiteral(", ")))});
    }
    if (view.scaleBar && status.states > 0) {
        overlay.metresPerPixel = render::metresPerPixel(render::cameraOf(view, pane.content), pane.height);
    }
    return overlay;
}

void paintOverlay(QPainter& painter, const Overlay& overlay, const render::Pane& pane, render::Theme theme, double textHeight) {
    const Look look = lookFor(theme, textHeight);
    const QRectF area(pane.x, pane.y, pane.width, pane.height);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(look.font);
    painter.setClipRect(area);
    if (!overlay.caption.isEmpty()) {
        paintCaption(painter, look, area, overlay.caption);
    }
    const double taken = overlay.metresPerPixel > 0 ? paintScaleBar(painter, look, area, overlay.metresPerPixel) : 0.0;
    paintLegend(painter, look, area, overlay, taken);
    painter.restore();
}

std::vector<LegendEntry> commonLegend(const render::View& view, bool released) {
    const Palette& p = palette(view.theme);
    std::vector<LegendEntry> legend;
    const bool byIsland = view.colourBy == render::ColourBy::Island;
    if (view.style == render::Style::Analysis) {
        if (view.colourBy == render::ColourBy::Highlight || byIsland) {
            legend.push_back({p.fragment, tr("fragments")});
        }
        legend.push_back({p.structure, byIsland ? tr("not loose") : tr("active structure")});
    }
    if (byIsland) {
        legend.push_back({QColor(), tr("each loose island in a colour of its own")});
    } else if (released && view.style == render::Style::Analysis) {
        legend.push_back({p.released, tr("released structure")});
    }
    return legend;
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
        paintEntry(painter, look, entry, x, top);
        x += entryWidth(look, entry) + gap;
    }
    for (const ColourBar& bar : bars) {
        paintBar(painter, look, bar, x, top);
        x += barWidth(look, bar) + gap;
    }
    painter.restore();
}

}  // namespace rubble::figures
