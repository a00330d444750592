#include "widgets/figures/survey_picture.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/fe/north.h"
#include "widgets/figures/draw.h"
#include "widgets/figures/figure_sheet.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/sheets/map_edges.h"
#include "widgets/figures/sheets/sheet_text.h"
#include "widgets/figures/shown_units.h"

namespace rubble::figures {
namespace {

constexpr double topShare = 0.98;
const QColor lessColour(0x00, 0x72, 0xb2);
const QColor moreColour(0xd5, 0x5e, 0x00);
const QColor scopeColour(0x00, 0x9e, 0x73);

QColor mixed(const QColor& a, const QColor& b, double share) {
    return QColor::fromRgbF(static_cast<float>(a.redF() + share * (b.redF() - a.redF())),
                            static_cast<float>(a.greenF() + share * (b.greenF() - a.greenF())),
                            static_cast<float>(a.blueF() + share * (b.blueF() - a.blueF())));
}

/// Cells to be shown: what holds numbers, and a margin.
struct Window {
    int left = 0, right = 0, bottom = 0, top = 0;

    explicit Window(const SurveyComparison& made) {
        const CellGrid& grid = made.difference;
        bool any = false;
        for (int row = 0; row < grid.rows; ++row) {
            for (int column = 0; column < grid.columns; ++column) {
                if (!std::isnan(grid.values[grid.index(column, row)])) {
                    left = any ? std::min(left, column) : column;
                    right = any ? std::max(right, column) : column;
                    if (!any) {
                        bottom = row;
                    }
                    top = row;
                    any = true;
                }
            }
        }
        if (!any) {
            right = grid.columns - 1;
            top = grid.rows - 1;
        }
        take(grid, made.settings.scope.area, any);
        take(grid, made.settings.scope.leftOut, any);
        const int margin = 2 + std::max(right - left, top - bottom) / 40;
        left = std::max(0, left - margin);
        bottom = std::max(0, bottom - margin);
        right = std::min(grid.columns - 1, right + margin);
        top = std::min(grid.rows - 1, top + margin);
    }
    /// Polygons that say what is compared are shown too.
    void take(const CellGrid& grid, const Outline& outline, bool any) {
        if (outline.empty() || !any) {
            return;
        }
        const auto [low, high] = outline.bounds();
        const auto cell = [&](double place, int first, int count) {
            return static_cast<int>(std::clamp(std::floor(place / grid.cell) - first, 0.0, count - 1.0));
        };
        left = std::min(left, cell(low.x(), grid.low.i, grid.columns));
        right = std::max(right, cell(high.x(), grid.low.i, grid.columns));
        bottom = std::min(bottom, cell(low.y(), grid.low.j, grid.rows));
        top = std::max(top, cell(high.y(), grid.low.j, grid.rows));
    }
    int columns() const { return right - left + 1; }
    int rows() const { return top - bottom + 1; }
};

/// Draws one picture.
class SurveySheet {
    Q_DECLARE_TR_FUNCTIONS(rubble::figures::SurveySheet)
public:
    SurveySheet(const SurveyComparison& made, const SurveyPictureStyle& style)
        : m_made(made),
          m_grid(made.difference),
          m_style(style),
          m_palette(palette(style.theme)),
          m_window(made),
          m_image(style.pixels, QImage::Format_RGB32),
          m_text(style.textPixels),
          m_small(style.theme == render::Theme::Print ? 0.68 * style.textPixels : 0.85 * style.textPixels) {
        const bool print = style.theme == render::Theme::Print;
        m_paper = print ? QColor(Qt::white) : m_palette.window;
        m_image.fill(m_paper);
        m_line = QFontMetricsF(sheetFont(m_text)).height();
        m_zero = style.theme == render::Theme::Dark ? QColor(0x3c, 0x40, 0x45) : QColor(0xee, 0xee, 0xec);
        findReach();
        layOut();
    }

    QImage draw() {
        QPainter painter(&m_image);
        painter.setRenderHint(QPainter::Antialiasing);
        drawCells(painter);
        drawOutlines(painter);
        if (m_style.scope) {
            painter.save();
            painter.setClipRect(m_cells);
            drawScope(painter, field(), m_made.settings.scope, 1.4 * edgeWidth());
            painter.restore();
        }
        drawCentre(painter);
        drawEdges(painter);
        drawLegend(painter);
        drawScaleBar(painter);
        drawHead(painter);
        drawFoot(painter);
        return m_image;
    }

    SurveyField field() const {
        const Eigen::Vector2d low = m_grid.cell * Eigen::Vector2d(m_grid.low.i + m_window.left, m_grid.low.j + m_window.bottom);
        return {m_cells, low, low + m_grid.cell * Eigen::Vector2d(m_window.columns(), m_window.rows())};
    }

private:
    void write(QPainter& painter, const QRectF& box, const QString& text, int alignment, double size, bool italic = false) const {
        const QFont font = sheetFont(size, italic);
        writeLine(painter, box, QFontMetricsF(font).elidedText(text, Qt::ElideRight, box.width()), alignment, font, m_palette.text);
    }

    void findReach() {
        std::vector<double> sizes;
        for (const double value : m_grid.values) {
            if (std::isfinite(value) && value != 0.0) {
                sizes.push_back(std::abs(value));
            }
        }
        if (m_made.isFootprint || sizes.empty()) {
            return;
        }
        std::sort(sizes.begin(), sizes.end());
        const auto at = static_cast<std::size_t>(topShare * static_cast<double>(sizes.size() - 1));
        m_reach = sizes[at];
        // Half of it is a number that reads well too.
        const double power = std::pow(10.0, std::floor(std::log10(m_reach)));
        for (const double factor : {10.0, 8.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0}) {
            if (factor * power >= sizes[at] * (1.0 - 1e-9)) {
                m_reach = factor * power;
            }
        }
        m_cut = sizes.back() > m_reach;
    }

    /// Room of cautions and provenance, pixels.
    double belowCaption() const {
        return (m_style.cautions.empty() ? 0.0 : cautionHeight(m_text)) + (m_style.provenance.empty() ? 0.0 : 2.5 * m_small);
    }

    /// Lines of the legend above the scale bar at most, and of that.
    double linesOfLegend() const {
        constexpr double pitch = 1.25;
        constexpr double scaleBar = 2.2;
        const bool scope = m_style.scope && !m_made.settings.scope.whole();
        const double bar = m_made.isFootprint ? 3.0 * pitch : 1.4 + 5.0 + 0.8;
        return bar + 0.4 + (4.0 + (scope ? 2.0 : 0.0)) * pitch + scaleBar;
    }

    /// Where the column of the legend is low, words are smaller: they must not lie over the scale bar.
    void suitLowPicture() {
        constexpr double smallest = 0.6;
        const double room = m_style.pixels.height() - belowCaption() - 5.0 * m_line;
        const double needed = linesOfLegend() * m_line;
        if (needed > room) {
            m_text *= std::clamp(room / needed, smallest, 1.0);
            m_line = QFontMetricsF(sheetFont(m_text)).height();
        }
    }

    void layOut() {
        suitLowPicture();
        const double foot = (m_style.caption ? 2.2 * m_line : 0.4 * m_line) + belowCaption();
        const double width = m_style.pixels.width();
        const double height = m_style.pixels.height();
        m_foot = QRectF(0.0, height - foot, width, foot);
        const double top = (m_style.subject.empty() ? 0.6 : 2.0) * m_line;
        m_legend = QRectF(width - 15.0 * m_line, top, 14.5 * m_line, height - foot - top - 0.4 * m_line);
        const double left = 6.5 * m_small;
        const QRectF field(left, top, m_legend.left() - left - m_line, height - foot - top - 2.2 * m_small);
        m_cellPixels = std::max(1e-3, std::min(field.width() / m_window.columns(), field.height() / m_window.rows()));
        const QSizeF size(m_cellPixels * m_window.columns(), m_cellPixels * m_window.rows());
        m_cells = QRectF(QPointF(field.center().x() - 0.5 * size.width(), field.center().y() - 0.5 * size.height()), size);
    }

    QColor colourAt(double share) const {
        return mixed(m_zero, share < 0.0 ? lessColour : moreColour, std::min(1.0, std::abs(share)));
    }
    QPointF place(double column, double row) const {
        return {m_cells.left() + (column - m_window.left) * m_cellPixels,
                m_cells.bottom() - (row - m_window.bottom) * m_cellPixels};
    }
    double columnOf(double x) const { return x / m_grid.cell - m_grid.low.i; }
    double rowOf(double y) const { return y / m_grid.cell - m_grid.low.j; }

    void drawCells(QPainter& painter) {
        QImage cells(m_window.columns(), m_window.rows(), QImage::Format_ARGB32_Premultiplied);
        cells.fill(Qt::transparent);
        for (int row = m_window.bottom; row <= m_window.top; ++row) {
            for (int column = m_window.left; column <= m_window.right; ++column) {
                const std::size_t k = m_grid.index(column, row);
                const bool unsurveyed = std::isnan(m_made.surveyedCells.values[k]);
                const QPoint at(column - m_window.left, m_window.top - row);
                if (!std::isnan(m_grid.values[k])) {
                    cells.setPixelColor(at, colourAt(m_grid.values[k] / m_reach));
                } else if (m_made.compared[k] == 0) {
                    m_uncompared = true;
                    cells.setPixelColor(at, mixed(m_paper, m_palette.muted, 0.5));
                } else if (unsurveyed) {
                    m_unsurveyed = true;
                    cells.setPixelColor(at, mixed(m_paper, m_palette.muted, 0.25));
                }
            }
        }
        painter.setRenderHint(QPainter::SmoothPixmapTransform, m_cellPixels < 1.0);
        painter.drawImage(m_cells, cells);
    }

    /// Sides of cells where the debris of one kind ends.
    QPainterPath outlineOf(bool surveyed) const {
        const auto inside = [&](int column, int row) {
            if (column < 0 || row < 0 || column >= m_grid.columns || row >= m_grid.rows) {
                return false;
            }
            const std::size_t k = m_grid.index(column, row);
            return surveyed ? surveyedDebris(m_made, k) : simulatedDebris(m_made, k);
        };
        QPainterPath path;
        const auto run = [&](bool along) {
            const int lines = along ? m_window.rows() : m_window.columns();
            const int steps = along ? m_window.columns() : m_window.rows();
            for (int line = 0; line <= lines; ++line) {
                int from = -1;
                for (int step = 0; step <= steps; ++step) {
                    const int column = m_window.left + (along ? step : line);
                    const int row = m_window.bottom + (along ? line : step);
                    const bool edge =
                        step < steps && inside(column, row) != (along ? inside(column, row - 1) : inside(column - 1, row));
                    if (edge && from < 0) {
                        from = step;
                    } else if (!edge && from >= 0) {
                        path.moveTo(along ? place(m_window.left + from, row) : place(column, m_window.bottom + from));
                        path.lineTo(along ? place(m_window.left + step, row) : place(column, m_window.bottom + step));
                        from = -1;
                    }
                }
            }
        };
        run(true);
        run(false);
        return path;
    }

    /// A line wider than a cell would hide the cells that only one side covers.
    double edgeWidth() const { return std::clamp(0.8 * m_cellPixels, std::max(1.0, 0.045 * m_text), std::max(1.0, 0.09 * m_text)); }
    QPen surveyPen() const { return QPen(m_palette.text, edgeWidth()); }
    QPen simulationPen() const {
        QPen pen(m_palette.fragment, edgeWidth(), Qt::CustomDashLine, Qt::FlatCap);
        pen.setDashPattern({3.0, 2.0});
        return pen;
    }

    void drawOutlines(QPainter& painter) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(surveyPen());
        painter.drawPath(outlineOf(true));
        painter.setPen(simulationPen());
        painter.drawPath(outlineOf(false));
    }

    void drawCentre(QPainter& painter) {
        const QPointF at = place(columnOf(m_made.centre.x()), rowOf(m_made.centre.y()));
        if (!m_cells.contains(at)) {
            return;
        }
        const double arm = 0.5 * m_text;
        painter.setPen(QPen(m_palette.text, std::max(1.0, 0.08 * m_text)));
        painter.drawLine(at - QPointF(arm, 0.0), at + QPointF(arm, 0.0));
        painter.drawLine(at - QPointF(0.0, arm), at + QPointF(0.0, arm));
    }

    void drawEdges(QPainter& painter) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_palette.muted, std::max(1.0, 0.06 * m_text)));
        painter.drawRect(m_cells);
        const double metres = m_grid.cell / m_cellPixels;
        const double step = roundLength(metres, std::min({9.0 * m_text, 0.4 * m_cells.width(), 0.4 * m_cells.height()}));
        const SurveyField shown = field();
        drawCoordinates(painter, {m_cells, shown.low, shown.high, stepAcross(step, metres, m_small), step}, m_style.place,
                        QStringLiteral("m"), m_small, m_palette.muted, m_palette.text);
    }

    void drawScaleBar(QPainter& painter) {
        const double length = roundLength(m_grid.cell / m_cellPixels, 0.7 * m_legend.width());
        if (!(length > 0.0)) {
            return;
        }
        const double pixels = length / m_grid.cell * m_cellPixels;
        const double y = m_legend.bottom() - 0.4 * m_line;
        write(painter, QRectF(m_legend.left(), y - 1.4 * m_line, m_legend.width(), m_line), lengthText(length),
              static_cast<int>(Qt::AlignLeft), m_text);
        painter.setPen(QPen(m_palette.text, std::max(1.0, 0.09 * m_text), Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
        const double tick = 0.35 * m_text;
        const std::array<QPointF, 4> points{QPointF(m_legend.left(), y - tick), QPointF(m_legend.left(), y),
                                            QPointF(m_legend.left() + pixels, y), QPointF(m_legend.left() + pixels, y - tick)};
        painter.drawPolyline(points.data(), static_cast<int>(points.size()));
    }

    void drawKey(QPainter& painter, double& y, const QPen& pen, const QString& text) {
        painter.setPen(pen);
        painter.drawLine(QPointF(m_legend.left(), y + 0.5 * m_line), QPointF(m_legend.left() + 1.4 * m_line, y + 0.5 * m_line));
        write(painter, QRectF(m_legend.left() + 1.8 * m_line, y, m_legend.width() - 1.8 * m_line, m_line), text,
              static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), m_text);
        y += 1.25 * m_line;
    }
    void drawPatch(QPainter& painter, double& y, const QColor& colour, const QString& text) {
        painter.setPen(QPen(m_palette.muted, 1.0));
        painter.setBrush(colour);
        painter.drawRect(QRectF(m_legend.left(), y + 0.15 * m_line, 1.4 * m_line, 0.7 * m_line));
        write(painter, QRectF(m_legend.left() + 1.8 * m_line, y, m_legend.width() - 1.8 * m_line, m_line), text,
              static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), m_text);
        y += 1.25 * m_line;
    }

    void drawLegend(QPainter& painter) {
        double y = m_legend.top();
        if (m_made.isFootprint) {
            drawPatch(painter, y, moreColour, tr("simulated only"));
            drawPatch(painter, y, lessColour, tr("surveyed only"));
            drawPatch(painter, y, m_zero, tr("both"));
        } else {
            write(painter, QRectF(m_legend.left(), y, m_legend.width(), m_line), tr("Simulated less surveyed [m]"),
                  static_cast<int>(Qt::AlignLeft), m_text);
            y += 1.4 * m_line;
            y = drawBar(painter, y);
        }
        y += 0.4 * m_line;
        drawKey(painter, y, surveyPen(), tr("edge of the survey"));
        drawKey(painter, y, simulationPen(), tr("edge of the simulation"));
        if (m_unsurveyed) {
            drawPatch(painter, y, mixed(m_paper, m_palette.muted, 0.25), tr("not surveyed"));
        }
        if (m_uncompared) {
            drawPatch(painter, y, mixed(m_paper, m_palette.muted, 0.5), tr("not compared"));
        }
        if (m_style.scope && !m_made.settings.scope.area.empty()) {
            drawKey(painter, y, QPen(scopeColour, 1.4 * edgeWidth()), tr("area of interest"));
        }
        if (m_style.scope && !m_made.settings.scope.leftOut.empty()) {
            drawKey(painter, y, QPen(scopeColour, 1.4 * edgeWidth(), Qt::DotLine), tr("left out"));
        }
    }

    double drawBar(QPainter& painter, double y) {
        const double height = std::min(7.0 * m_line, std::max(5.0 * m_line, 0.4 * m_legend.height()));
        const QRectF bar(m_legend.left(), y, 1.1 * m_line, height);
        QLinearGradient ramp(bar.bottomLeft(), bar.topLeft());
        for (int i = 0; i <= 16; ++i) {
            ramp.setColorAt(i / 16.0, colourAt(i / 8.0 - 1.0));
        }
        painter.setPen(QPen(m_palette.muted, 1.0));
        painter.setBrush(ramp);
        painter.drawRect(bar);
        for (int k = -2; k <= 2; ++k) {
            const QString number = (k > 0 ? QStringLiteral("+") : QString()) + numberText(0.5 * k * m_reach);
            const QString shown = m_cut && k == 2    ? QStringLiteral("≥ ") + number
                                  : m_cut && k == -2 ? QStringLiteral("≤ ") + number
                                                     : number;
            write(painter,
                  QRectF(bar.right() + 0.4 * m_line, bar.center().y() - 0.25 * k * height - 0.5 * m_line, 8.0 * m_line, m_line),
                  shown, static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), m_text);
        }
        return bar.bottom() + 0.8 * m_line;
    }

    /// Which survey it is, and what it was held against.
    void drawHead(QPainter& painter) const {
        if (!m_style.subject.empty()) {
            const QRectF line(m_cells.left(), 0.5 * m_line, m_style.pixels.width() - m_cells.left() - m_line, m_line);
            write(painter, line, QString::fromStdString(m_style.subject), static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter),
                  m_text);
        }
    }

    void drawFoot(QPainter& painter) {
        if (m_style.caption) {
            const QString caption =
                tr("Simulated debris at t = %1 against the survey; IoU %2, cells of %3; fallen live structure %4")
                    .arg(timeText(m_made.time), numberText(m_made.iou), lengthText(m_grid.cell),
                         m_made.settings.withFallen ? tr("counted") : tr("left out"));
            painter.setPen(m_palette.text);
            writeWhole(painter, QRectF(0.01 * m_foot.width(), m_foot.top() + 0.4 * m_line, 0.98 * m_foot.width(), 1.5 * m_line),
                       caption, Qt::AlignCenter, {m_text, 0.4 * m_text, true});
        }
        if (!m_style.cautions.empty()) {
            paintCautions(painter, QRectF(0.0, m_foot.bottom() - belowCaption(), m_foot.width(), cautionHeight(m_text)),
                          QString::fromStdString(m_style.cautions), m_text, m_style.theme);
        }
        if (!m_style.provenance.empty()) {
            const std::string placed = placedSystem(m_style.place, m_style.system);
            const QString system = placed.empty() ? tr("local coordinates in metres") : QString::fromStdString(placed);
            painter.setFont(sheetFont(m_small));
            painter.setPen(m_palette.muted);
            const QRectF foot(0.0, m_foot.bottom() - 2.3 * m_small, m_foot.width(), 2.0 * m_small);
            painter.drawText(
                foot, static_cast<int>(Qt::AlignCenter),
                painter.fontMetrics().elidedText(system + QStringLiteral(" · ") + QString::fromStdString(m_style.provenance),
                                                 Qt::ElideMiddle, static_cast<int>(foot.width())));
        }
    }

    const SurveyComparison& m_made;
    const CellGrid& m_grid;
    const SurveyPictureStyle& m_style;
    const Palette& m_palette;
    Window m_window;
    QImage m_image;
    QColor m_paper;
    QColor m_zero;
    double m_text;
    double m_small;
    double m_line = 0.0;
    double m_reach = 1.0;  ///< m, at the ends of the colours
    bool m_cut = false;
    bool m_unsurveyed = false;  ///< somewhere in what is shown
    bool m_uncompared = false;
    QRectF m_legend;
    QRectF m_cells;
    QRectF m_foot;
    double m_cellPixels = 1.0;
};

}  // namespace

QPointF SurveyField::toPicture(const Eigen::Vector2d& place) const {
    return {frame.left() + (place.x() - low.x()) / (high.x() - low.x()) * frame.width(),
            frame.bottom() - (place.y() - low.y()) / (high.y() - low.y()) * frame.height()};
}

Eigen::Vector2d SurveyField::toPlace(const QPointF& point) const {
    return {low.x() + (point.x() - frame.left()) / frame.width() * (high.x() - low.x()),
            low.y() + (frame.bottom() - point.y()) / frame.height() * (high.y() - low.y())};
}

SurveyField surveyField(const SurveyComparison& made, const SurveyPictureStyle& style) {
    return SurveySheet(made, style).field();
}

void drawScope(QPainter& painter, const SurveyField& field, const SurveyScope& scope, double lineWidth) {
    for (const ScopePart part : {ScopePart::Area, ScopePart::LeftOut}) {
        const bool area = part == ScopePart::Area;
        painter.setPen(QPen(scopeColour, lineWidth, area ? Qt::SolidLine : Qt::DotLine));
        painter.setBrush(area ? QBrush(Qt::NoBrush) : QBrush(scopeColour, Qt::BDiagPattern));
        for (const OutlinePolygon& polygon : scope.part(part).polygons) {
            QPainterPath path;
            for (const OutlineRing& ring : polygon) {
                QPolygonF corners;
                for (const Eigen::Vector2d& corner : ring) {
                    corners << field.toPicture(corner);
                }
                path.addPolygon(corners);
                path.closeSubpath();
            }
            painter.drawPath(path);
        }
    }
}

QImage surveyPicture(const SurveyComparison& made, const SurveyPictureStyle& style) {
    // As a debris map.
    const FileUnits inSi;
    constexpr int smallest = 100;
    constexpr int largest = 16384;
    const auto fits = [](int side) { return side >= smallest && side <= largest; };
    if (!fits(style.pixels.width()) || !fits(style.pixels.height())) {
        throw UsageError({"figure.map_size",
                          "A map of {0} x {1} pixels at {2} dpi cannot be drawn",
                          {style.pixels.width(), style.pixels.height(), 200.0}},
                         {"figure.map_size.remedy", "Ask for {0} to {1} pixels a side and 20 to 2400 dpi.", {smallest, largest}});
    }
    return SurveySheet(made, style).draw();
}

}  // namespace rubble::figures
