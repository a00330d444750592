#include "widgets/figures/map_picture.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "core/base/error.h"
#include "core/fe/north.h"
#include "widgets/figures/draw.h"
#include "widgets/figures/figure_sheet.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/sheets/map_contours.h"
#include "widgets/figures/sheets/map_edges.h"
#include "widgets/figures/sheets/map_head.h"
#include "widgets/figures/sheets/map_window.h"
#include "widgets/figures/sheets/map_words.h"
#include "widgets/figures/sheets/sheet_text.h"
#include "widgets/figures/shown_units.h"
#include "widgets/render/basics/colour_choice.h"

namespace rubble::figures {
namespace {

constexpr double mapTextPoints = 9.0;
constexpr double smallPoints = 6.0;
constexpr double entryPitch = 1.2;               // lines from one entry of the legend to the next
constexpr double aboveTitle = 4.2;               // lines that north takes above the legend
constexpr QColor paperOfMaps(0xe9, 0xe9, 0xe4);  // of a dark page
constexpr double causeLines = 2.9;               // lines of two causes that are told apart

/// Light is little, dark is much; early is dark as in the views.
QColor colourAt(MapLayer layer, double place) {
    if (layer == MapLayer::Separation) {
        const QColor ends = place > 0.5 ? QColor(0x00, 0x72, 0xb2) : QColor(0xd5, 0x5e, 0x00);
        const double away = std::abs(2.0 * place - 1.0);
        const auto mixed = [away](int end) { return static_cast<int>(std::lround(235.0 + away * (end - 235.0))); };
        return {mixed(ends.red()), mixed(ends.green()), mixed(ends.blue())};
    }
    return layer == MapLayer::Arrival ? birthColour(place) : speedColour(1.0 - place);
}

/// As the views colour a component.
QColor categoryColour(render::Theme theme, std::size_t component) {
    const render::Rgb colour = render::colour_choice::category(sceneColours(theme), component);
    return {colour.r, colour.g, colour.b};
}

/// Draws one picture.
class MapSheet {
    Q_DECLARE_TR_FUNCTIONS(rubble::figures::Sheet)
public:
    MapSheet(const DebrisMap& map, MapLayer layer, const MapPictureStyle& style)
        : m_map(map),
          m_layer(layer),
          m_style(style),
          m_palette(palette(style.theme)),
          m_window(windowOf(map, style.outlines)),
          m_range(rangeOf(map.layer(layer), layer)),
          m_valued(std::any_of(map.layer(layer).begin(), map.layer(layer).end(), [](double v) { return std::isfinite(v); })),
          m_text(mapTextPoints / 72.0 * style.dpi),
          m_small(smallPoints / 72.0 * style.dpi) {
        m_line = QFontMetricsF(sheetFont(m_text)).height();
        suitLowPicture();
        layOut();
        if (style.fitted && !map.cells.empty()) {
            fit();
        }
        m_image = QImage(m_style.pixels, QImage::Format_RGB32);
        m_image.fill(style.theme == render::Theme::Print ? QColor(Qt::white) : m_palette.panel);
        if (layer == MapLayer::Component) {
            chooseCategories();
        }
    }

    QImage draw() {
        QPainter painter(&m_image);
        painter.setRenderHint(QPainter::Antialiasing);
        if (m_map.cells.empty()) {
            write(painter, m_field, tr("No debris at this time"), Qt::AlignCenter, m_text);
        } else {
            drawCells(painter);
            figures::drawContours(
                painter, m_map,
                {m_style.contours, m_frame, [this](const Eigen::Vector2d& at) { return QPointF(pixelX(at.x()), pixelY(at.y())); },
                 contourPen(), m_small});
            drawOutlines(painter);
            drawEdges(painter);
            drawRing(painter);
            drawScaleBar(painter);
            if (!m_valued) {
                write(painter, m_field, tr("This layer is empty here: no cell has a value"), Qt::AlignCenter, m_text);
            }
        }
        drawNorth(painter);
        drawLegend(painter);
        drawHead(painter);
        drawFoot(painter);
        painter.end();
        setResolution(m_image, m_style.dpi);
        m_image.setText(QStringLiteral("Description"), QString::fromStdString(m_style.provenance));
        return m_image;
    }

    MapPlacing placing() const {
        return {m_cells, m_map.cell * Eigen::Vector2d(m_window.low.i, m_window.low.j), m_map.cell / m_cellPixels};
    }

private:
    void write(QPainter& painter, const QRectF& box, const QString& text, int alignment, double size, bool italic = false) const {
        writeLine(painter, box, text, alignment, sheetFont(size, italic), m_palette.text);
    }

    /// Room of cautions and provenance, pixels.
    double belowCaption() const {
        return (m_style.cautions.empty() ? 0.0 : cautionHeight(m_text)) + (m_style.provenance.empty() ? 0.0 : 2.5 * m_small);
    }

    /// Room of the subject and of the sums, pixels.
    double aboveMap() const { return head().height(headWidth(), m_text); }
    double headWidth() const { return m_style.pixels.width() - leftOfMap() - m_line; }
    double leftOfMap() const { return 6.5 * m_small; }
    MapHead head() const {
        const bool sums = m_map.members == 0 && !m_map.cells.empty();
        return {QString::fromStdString(m_style.subject), sums ? debrisSums(m_map) : QString()};
    }

    /// Where the column of the legend is low, north stands beside its title, and words are smaller.
    void suitLowPicture() {
        constexpr double smallest = 0.7;
        const auto lines = [this] { return (m_style.pixels.height() - belowCaption() - aboveMap()) / m_line - 4.2; };
        const double needed = linesOfLegend();
        m_low = lines() < needed + aboveTitle;
        if (lines() < needed) {
            m_text *= std::clamp(lines() / needed, smallest, 1.0);
            m_line = QFontMetricsF(sheetFont(m_text)).height();
        }
    }

    /// Title and bar, what is marked on the map, the scale.
    double linesOfLegend() const {
        return 7.2 + (showsLive() ? entryPitch : 0.0) + entryPitch * lineEntries() + (namesCauses() ? causeLines : 0.0);
    }
    bool namesCauses() const { return m_layer == MapLayer::Separation && m_map.hypotheses.size() == 2; }

    /// Takes away the room beside or below a map of another shape than the picture, as far as legend and caption can spare it.
    void fit() {
        constexpr double fewestLines = 40.0;  // across: a caption
        const double below = m_field.bottom() < m_legend.top() ? 0.0 : m_field.height() - m_frame.height();
        const double besides = m_field.bottom() < m_legend.top() ? 0.0 : m_field.width() - m_frame.width();
        const double components = m_layer == MapLayer::Component ? 12.0 : 0.0;
        const double least = (linesOfLegend() + aboveTitle + components + 4.2) * m_line + belowCaption() + aboveMap();
        const QSize most = m_style.pixels;
        m_style.pixels.setHeight(std::clamp(static_cast<int>(std::lround(most.height() - below)),
                                            std::min(most.height(), static_cast<int>(least)), most.height()));
        m_style.pixels.setWidth(std::clamp(static_cast<int>(std::lround(most.width() - besides)),
                                           std::min(most.width(), static_cast<int>(fewestLines * m_line)), most.width()));
        layOut();
    }

    /// The map fills what legend, coordinates and caption leave.
    void layOut() {
        const double foot = 2.2 * m_line + belowCaption();
        const double left = leftOfMap();
        const double top = aboveMap() + m_line;
        m_legend =
            QRectF(m_style.pixels.width() - 11.0 * m_line, top, 10.0 * m_line, m_style.pixels.height() - foot - top - m_line);
        m_field = QRectF(left, top, m_legend.left() - left - m_line, m_style.pixels.height() - foot - top - 2.2 * m_small);
        const double columns = 1.04 * m_window.columns();
        const double rows = 1.04 * m_window.rows();
        layOutBelow(left, foot, columns, rows);
        m_cellPixels = std::min(m_field.width() / columns, m_field.height() / rows);
        const QPointF middle = m_field.center();
        const double width = m_cellPixels * m_window.columns();
        const double height = m_cellPixels * m_window.rows();
        m_cells = QRectF(middle.x() - 0.5 * width, middle.y() - 0.5 * height, width, height);
        const double margin = 0.02 * std::max(width, height);
        m_frame = m_cells.adjusted(-margin, -margin, margin, margin).intersected(m_field);
    }

    /// In a narrow picture a map that lies across has the whole width, and its legend stands below.
    void layOutBelow(double left, double foot, double columns, double rows) {
        constexpr double narrow = 50.0;       // lines
        constexpr double legendLines = 16.0;  // of the column that the legend is
        constexpr double worth = 1.25;        // times as large
        const double wide = m_style.pixels.width() - left - m_line;
        const double tall = m_field.height() - legendLines * m_line;
        const double beside = std::min(m_field.width() / columns, m_field.height() / rows);
        const double below = std::min(wide / columns, tall / rows);
        if (m_style.pixels.width() > narrow * m_line || below < worth * beside) {
            return;
        }
        m_field = QRectF(left, m_field.top(), wide, below * rows);
        const double top = m_field.bottom() + 2.2 * m_small + m_line;
        m_legend = QRectF(left, top, wide, std::min(m_style.pixels.height() - foot - top, legendLines * m_line));
    }

    QColor cellColour(std::size_t c) const {
        const double value = m_map.layer(m_layer)[c];
        if (std::isnan(value)) {
            const bool live = m_map.has(MapLayer::LiveMass) && !std::isnan(m_map.layer(MapLayer::LiveMass)[c]);
            return live ? liveColour() : QColor(0, 0, 0, 0);
        }
        if (m_layer == MapLayer::Component) {
            return m_categories.at(static_cast<std::size_t>(value));
        }
        return colourAt(m_layer, m_range.place(value));
    }
    QColor liveColour() const { return m_palette.released; }

    void drawCells(QPainter& painter) {
        // The scales run to dark: on a dark page they need paper of their own.
        if (m_style.theme == render::Theme::Dark) {
            painter.fillRect(m_frame, paperOfMaps);
        }
        // Of a map finer than the picture every few cells make a dot: the largest value would hide the rest, so they are mixed.
        QImage cells(m_window.columns(), m_window.rows(), QImage::Format_ARGB32_Premultiplied);
        cells.fill(Qt::transparent);
        for (std::size_t c = 0; c < m_map.cells.size(); ++c) {
            const MapCell& cell = m_map.cells[c];
            if (!m_window.holds(cell)) {
                ++m_outside;
                m_farthest = std::max(m_farthest, m_window.beyond(cell));
                continue;
            }
            cells.setPixelColor(cell.i - m_window.low.i, m_window.high.j - cell.j, cellColour(c));
        }
        painter.setRenderHint(QPainter::SmoothPixmapTransform, m_cellPixels < 1.0);
        painter.drawImage(m_cells, cells);
    }

    double pixelX(double x) const { return m_cells.left() + (x / m_map.cell - m_window.low.i) * m_cellPixels; }
    double pixelY(double y) const { return m_cells.bottom() - (y / m_map.cell - m_window.low.j) * m_cellPixels; }

    void drawEdges(QPainter& painter) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_palette.muted, std::max(1.0, 0.06 * m_text)));
        painter.drawRect(m_frame);
        const ShownUnit unit = coordinateUnit(m_style);
        const double metres = m_map.cell / m_cellPixels;
        const double step =
            coordinateStep(m_style, metres, std::min({9.0 * m_text, 0.4 * m_frame.width(), 0.4 * m_frame.height()}));
        SiteFit place = m_style.place;
        place.scale *= unit.perSi;
        place.shift *= unit.perSi;
        const auto local = [&](const QPointF& pixel) {
            return Eigen::Vector2d(m_map.cell * (m_window.low.i + (pixel.x() - m_cells.left()) / m_cellPixels),
                                   m_map.cell * (m_window.low.j + (m_cells.bottom() - pixel.y()) / m_cellPixels));
        };
        drawCoordinates(
            painter,
            {m_frame, local(m_frame.bottomLeft()), local(m_frame.topRight()), stepAcross(step, unit.perSi * metres, m_small), step},
            place, unit.name, m_small, m_palette.muted, m_palette.text);
    }

    bool showsContours() const { return hasContours(m_map, m_style.contours); }
    QPen contourPen() const { return {QColor(0x20, 0x22, 0x26, 170), std::max(0.7, 0.06 * m_text)}; }
    QPen outlinePen(MapOutline::Of of) const { return lineOf(of, m_palette, std::max(1.5, 0.15 * m_text)); }

    void drawRings(QPainter& painter, const std::vector<OutlineRing>& rings) {
        for (const OutlineRing& ring : rings) {
            QPolygonF line;
            for (const Eigen::Vector2d& corner : ring) {
                line << QPointF(pixelX(corner.x()), pixelY(corner.y()));
            }
            painter.drawPolygon(line);
        }
    }

    void drawOutlines(QPainter& painter) {
        painter.save();
        painter.setClipRect(m_frame);
        painter.setBrush(Qt::NoBrush);
        for (const MapOutline& outline : m_style.outlines) {
            painter.setPen(outlinePen(outline.of));
            drawRings(painter, outline.rings);
        }
        painter.restore();
    }

    /// What the lines on the map are.
    void drawLineEntries(QPainter& painter, double& y) {
        const auto entry = [&](const QPen& pen, const QString& text) {
            painter.setPen(pen);
            const double middle = y + 0.5 * m_line;
            painter.drawLine(QPointF(m_legend.left(), middle), QPointF(m_legend.left() + 1.4 * m_line, middle));
            writeEntry(painter, QRectF(m_legend.left() + 1.8 * m_line, y, m_legend.width() - 1.8 * m_line, m_line), text);
            y += entryPitch * m_line;
        };
        if (showsContours()) {
            if (m_style.theme == render::Theme::Dark) {
                painter.fillRect(QRectF(m_legend.left(), y, 1.4 * m_line, m_line), paperOfMaps);
            }
            entry(contourPen(), tr("height of the debris, every %1").arg(lengthText(m_style.contours)));
        }
        for (const MapOutline::Of of : MapOutline::all) {
            if (outlines(of)) {
                entry(outlinePen(of), outlineWords(of));
            }
        }
    }

    /// Lines below the bar or the categories.
    int lineEntries() const {
        return (showsContours() ? 1 : 0) + static_cast<int>(std::count_if(MapOutline::all.begin(), MapOutline::all.end(),
                                                                          [this](auto of) { return outlines(of); }));
    }
    bool outlines(MapOutline::Of of) const {
        return std::any_of(m_style.outlines.begin(), m_style.outlines.end(),
                           [of](const MapOutline& each) { return each.of == of && !each.rings.empty(); });
    }

    void drawRing(QPainter& painter) {
        if (!m_style.ring) {
            return;
        }
        const double radius = std::max(m_style.ring->radius / m_map.cell * m_cellPixels, 0.5 * m_text);
        const QPointF middle(pixelX(m_style.ring->middle.x()), pixelY(m_style.ring->middle.y()));
        painter.save();
        painter.setClipRect(m_frame);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(0x20, 0x22, 0x26), std::max(1.5, 0.15 * m_text), Qt::DashLine));
        painter.drawEllipse(middle, radius, radius);
        painter.restore();
    }

    void drawScaleBar(QPainter& painter) {
        const double length = roundLength(m_map.cell / m_cellPixels, 0.8 * m_legend.width());
        if (!(length > 0.0)) {
            return;
        }
        const double pixels = length / m_map.cell * m_cellPixels;
        const double y = m_legend.bottom() - 0.6 * m_line;
        const double x = m_legend.left();
        write(painter, QRectF(x, y - 1.4 * m_line, m_legend.width(), m_line), lengthText(length), static_cast<int>(Qt::AlignLeft),
              m_text);
        painter.setPen(QPen(m_palette.text, std::max(1.0, 0.09 * m_text), Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
        const double tick = 0.35 * m_text;
        const std::array<QPointF, 4> points{QPointF(x, y - tick), QPointF(x, y), QPointF(x + pixels, y),
                                            QPointF(x + pixels, y - tick)};
        painter.drawPolyline(points.data(), static_cast<int>(points.size()));
    }

    /// Without a coordinate system or control points nobody said that y is north.
    void drawNorth(QPainter& painter) {
        const double x = m_low ? m_legend.right() - 0.5 * m_line : m_legend.left() + 0.5 * m_line;
        const double top = m_legend.top() + 1.2 * m_line;
        const QString letter = northOf(m_style.place, m_style.system) ? tr("N") : QStringLiteral("y");
        painter.save();
        painter.translate(x, top + 0.5 * m_line);
        painter.rotate(m_style.place.angle / std::numbers::pi * 180.0);
        painter.translate(-x, -top - 0.5 * m_line);
        write(painter, QRectF(x - m_line, top - 1.2 * m_line, 2.0 * m_line, 1.1 * m_line), letter,
              static_cast<int>(Qt::AlignHCenter | Qt::AlignBottom), m_text);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_palette.text);
        const std::array<QPointF, 4> arrow{QPointF(x, top), QPointF(x + 0.45 * m_line, top + 1.6 * m_line),
                                           QPointF(x, top + 1.25 * m_line), QPointF(x - 0.45 * m_line, top + 1.6 * m_line)};
        painter.drawConvexPolygon(arrow.data(), 4);
        painter.restore();
    }

    void drawLegend(QPainter& painter) {
        double y = m_legend.top() + (m_low ? 0.0 : aboveTitle * m_line);
        const double room = m_legend.width() - (m_low ? 2.0 * m_line : 0.0);
        const QString title = legendTitle(m_map, m_layer);
        const double share = room / QFontMetricsF(sheetFont(m_text)).horizontalAdvance(title);
        write(painter, QRectF(m_legend.left(), y, room, m_line), title, static_cast<int>(Qt::AlignLeft),
              m_text * (share >= 1.0 ? 1.0 : 0.94 * share));
        y += 1.5 * m_line;
        if (namesCauses()) {
            drawEntry(painter, y, colourAt(m_layer, 1.0), tr("for %1").arg(QString::fromStdString(m_map.hypotheses[0])));
            drawEntry(painter, y, colourAt(m_layer, 0.0), tr("for %1").arg(QString::fromStdString(m_map.hypotheses[1])));
            y += 0.5 * m_line;
        }
        if (m_valued) {
            y = m_layer == MapLayer::Component ? drawCategories(painter, y) : drawBar(painter, y);
        }
        if (showsLive()) {
            drawEntry(painter, y, liveColour(), tr("fallen structure alone"));
        }
        drawLineEntries(painter, y);
    }
    /// Fallen live structure is marked in what layers of debris leave free.
    bool showsLive() const { return m_map.live && m_map.ledger.liveElements > 0 && !mapLayerRow(m_layer).live; }

    void drawEntry(QPainter& painter, double& y, const QColor& colour, const QString& text) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawRect(QRectF(m_legend.left(), y + 0.2 * m_line, 0.6 * m_line, 0.6 * m_line));
        writeEntry(painter, QRectF(m_legend.left() + m_line, y, m_legend.width() - m_line, m_line), text);
        y += entryPitch * m_line;
    }

    void writeEntry(QPainter& painter, const QRectF& box, const QString& text) const {
        painter.setPen(m_palette.text);
        writeWhole(painter, box, text, static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), {m_text, 0.5 * m_text, false});
    }

    /// Components that debris comes from, those with most cells first; what the legend has no room for is of one grey.
    void chooseCategories() {
        std::vector<std::size_t> cells(m_map.components.size(), 0);
        for (const double value : m_map.layer(m_layer)) {
            if (value >= 0.0) {
                ++cells.at(static_cast<std::size_t>(value));
            }
        }
        m_listed.resize(cells.size());
        std::iota(m_listed.begin(), m_listed.end(), std::size_t{0});
        std::stable_sort(m_listed.begin(), m_listed.end(), [&](std::size_t a, std::size_t b) { return cells[a] > cells[b]; });
        std::erase_if(m_listed, [&](std::size_t c) { return cells[c] == 0; });
        const double room =
            (m_legend.height() - (m_low ? 4.8 : 9.0) * m_line) / (entryPitch * m_line) - (showsLive() ? 1.0 : 0.0) - lineEntries();
        if (const auto most = static_cast<std::size_t>(std::max(1.0, std::floor(room))); m_listed.size() > most) {
            m_unlisted = m_listed.size() - (most - 1);
            m_listed.resize(most - 1);
        }
        m_categories.assign(cells.size(), m_palette.muted);
        for (const std::size_t c : m_listed) {
            m_categories[c] = categoryColour(m_style.theme, c);
        }
    }

    /// Returns where the next entry goes.
    double drawCategories(QPainter& painter, double y) {
        for (const std::size_t c : m_listed) {
            drawEntry(painter, y, m_categories[c], QString::fromStdString(m_map.components[c]));
        }
        if (m_unlisted > 0) {
            drawEntry(painter, y, m_palette.muted, tr("%1 more").arg(m_unlisted));
        }
        return y;
    }

    double drawBar(QPainter& painter, double y) {
        // The scale bar stands below, also in a low picture.
        const double below = (3.2 + (showsLive() ? entryPitch : 0.0) + entryPitch * lineEntries()) * m_line;
        const double height = std::clamp(m_legend.bottom() - below - y, 2.4 * m_line, 7.0 * m_line);
        const QRectF bar(m_legend.left(), y, 1.1 * m_line, height);
        QLinearGradient ramp(bar.bottomLeft(), bar.topLeft());
        for (int i = 0; i <= 16; ++i) {
            ramp.setColorAt(i / 16.0, colourAt(m_layer, i / 16.0));
        }
        painter.setPen(QPen(m_palette.muted, 1.0));
        painter.setBrush(ramp);
        painter.drawRect(bar);
        const int steps = std::max(1, static_cast<int>(std::lround((m_range.high - m_range.low) / m_range.step)));
        const int every = height < 1.1 * m_line * steps ? steps : 1;
        for (int k = 0; k <= steps; k += every) {
            const double share = static_cast<double>(k) / steps;
            const QString number = legendNumber((m_range.low + k * m_range.step) * shownScale(m_layer));
            write(painter, QRectF(bar.right() + 0.4 * m_line, bar.bottom() - share * height - 0.5 * m_line, 8.0 * m_line, m_line),
                  k == steps && m_range.cut ? QStringLiteral("≥ ") + number : number,
                  static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), m_text);
        }
        return bar.bottom() + 1.2 * m_line;
    }

    /// What it is a map of, and how much lies there.
    void drawHead(QPainter& painter) {
        head().paint(painter, QRectF(leftOfMap(), 0.4 * m_line, headWidth(), aboveMap()), m_text, m_palette.text);
    }

    void drawFoot(QPainter& painter) {
        const QString shown = QCoreApplication::translate("messages", m_style.shown.c_str());
        QString caption = m_map.members > 0
                              ? tr("%1; %2 members of an ensemble, %3, cells of %4")
                                    .arg(layerName(m_map, m_layer))
                                    .arg(m_map.members)
                                    .arg(shown, lengthText(m_map.cell))
                              : tr("%1, t = %2, %3, cells of %4")
                                    .arg(layerName(m_map, m_layer), timeText(m_map.time), shown, lengthText(m_map.cell));
        if (m_outside > 0) {
            caption += (m_outside == 1 ? tr("; %1 cell with debris lies outside the picture, %2 beyond it")
                                       : tr("; %1 cells with debris lie outside the picture, up to %2 beyond it"))
                           .arg(countText(m_outside), lengthText(m_map.cell * m_farthest));
        }
        const double bottom = m_style.pixels.height() - belowCaption();
        const double room = 0.98 * m_style.pixels.width();
        painter.setPen(m_palette.text);
        writeWhole(painter, QRectF(0.5 * (m_style.pixels.width() - room), bottom - 1.8 * m_line, room, 1.5 * m_line), caption,
                   Qt::AlignCenter, {m_text, 0.4 * m_text, true});
        if (!m_style.cautions.empty()) {
            paintCautions(painter, QRectF(0.0, bottom, m_style.pixels.width(), cautionHeight(m_text)),
                          QString::fromStdString(m_style.cautions), m_text, m_style.theme);
        }
        painter.setFont(sheetFont(m_small));
        painter.setPen(m_palette.muted);
        const double line = m_style.pixels.height() - (m_style.provenance.empty() ? 0.0 : 2.5 * m_small);
        const QRectF foot(0.0, line, m_style.pixels.width(), 2.0 * m_small);
        painter.drawText(foot, static_cast<int>(Qt::AlignCenter),
                         painter.fontMetrics().elidedText(
                             coordinatesWords(m_style) + QStringLiteral(" · ") + QString::fromStdString(m_style.provenance),
                             Qt::ElideMiddle, static_cast<int>(foot.width())));
    }

    const DebrisMap& m_map;
    MapLayer m_layer;
    MapPictureStyle m_style;
    const Palette& m_palette;
    MapWindow m_window;
    MapRange m_range;
    bool m_valued;  ///< some cell has a value of the layer
    double m_text;
    double m_small;
    double m_line = 0.0;
    QImage m_image;
    bool m_low = false;                 ///< the column of the legend has no room for all below each other
    std::vector<std::size_t> m_listed;  ///< components in the legend
    std::size_t m_unlisted = 0;
    std::vector<QColor> m_categories;  ///< [component]
    QRectF m_legend;
    QRectF m_field;
    QRectF m_cells;  ///< of the cells shown
    QRectF m_frame;
    double m_cellPixels = 1.0;
    std::size_t m_outside = 0;
    int m_farthest = 0;  ///< of these, cells beyond the picture
};

void checkLayer(const DebrisMap& map, MapLayer layer) {
    if (!map.has(layer)) {
        throw UsageError(
            {"figure.map_layer", "The map has no layer \"{0}\"", {mapLayerRow(layer).key}},
            {"figure.map_layer.remedy", "Draw another layer; impact energy needs a complete run, live structure its layers.", {}});
    }
}

}  // namespace

Eigen::Vector2d MapPlacing::at(const QPointF& pixel) const {
    return low + metres * Eigen::Vector2d(pixel.x() - cells.left(), cells.bottom() - pixel.y());
}

QImage mapPicture(const DebrisMap& map, MapLayer layer, const MapPictureStyle& style, MapPlacing* placing) {
    std::optional<FileUnits> inSi;
    if (!style.shownUnits) {
        inSi.emplace();
    }
    constexpr int smallest = 100;
    constexpr int largest = 16384;
    const auto fits = [](int side) { return side >= smallest && side <= largest; };
    if (!fits(style.pixels.width()) || !fits(style.pixels.height()) || !(style.dpi >= 20.0 && style.dpi <= 2400.0)) {
        throw UsageError({"figure.map_size",
                          "A map of {0} x {1} pixels at {2} dpi cannot be drawn",
                          {style.pixels.width(), style.pixels.height(), style.dpi}},
                         {"figure.map_size.remedy", "Ask for {0} to {1} pixels a side and 20 to 2400 dpi.", {smallest, largest}});
    }
    checkLayer(map, layer);
    MapSheet sheet(map, layer, style);
    if (placing != nullptr) {
        *placing = sheet.placing();
    }
    return sheet.draw();
}

Orthophoto groundPicture(const DebrisMap& map, MapLayer layer) {
    checkLayer(map, layer);
    constexpr std::uint8_t opacity = 215;  // of 255: the ground shows through
    const MapWindow window = windowOf(map, {});
    const MapRange range = rangeOf(map.layer(layer), layer);
    Orthophoto picture;
    picture.x0 = map.cell * window.low.i;
    picture.y0 = map.cell * window.low.j;
    picture.pixel = map.cell;
    picture.width = map.cells.empty() ? 0 : window.columns();
    picture.height = map.cells.empty() ? 0 : window.rows();
    picture.rgba.assign(4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), 0);
    for (std::size_t c = 0; c < map.cells.size(); ++c) {
        const MapCell& cell = map.cells[c];
        const double value = map.layer(layer)[c];
        if (!window.holds(cell) || std::isnan(value)) {
            continue;
        }
        const QColor colour = layer == MapLayer::Component ? categoryColour(render::Theme::Print, static_cast<std::size_t>(value))
                                                           : colourAt(layer, range.place(value));
        const std::size_t at = 4 * (static_cast<std::size_t>(cell.j - window.low.j) * static_cast<std::size_t>(picture.width) +
                                    static_cast<std::size_t>(cell.i - window.low.i));
        picture.rgba[at] = static_cast<std::uint8_t>(colour.red());
        picture.rgba[at + 1] = static_cast<std::uint8_t>(colour.green());
        picture.rgba[at + 2] = static_cast<std::uint8_t>(colour.blue());
        picture.rgba[at + 3] = opacity;
    }
    return picture;
}

}  // namespace rubble::figures
