#include "widgets/figures/figure_sheet.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "widgets/figures/draw.h"
#include "widgets/figures/marks.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/sheets/sheet_text.h"
#include "widgets/figures/translated.h"
#include "widgets/render/basics/camera.h"
#include "widgets/render/panes.h"

namespace rubble::figures {
namespace {

constexpr double sheetTextPoints = 9.0;
constexpr double provenancePoints = 6.0;
constexpr double cautionShare = 0.85;   // of the text
constexpr double smallestLegend = 0.7;  // of the text: below that it is not read any more
constexpr double surroundingsFactor = 1.4;
constexpr double smallestCaption = 0.5;  // of the text
constexpr double tallestPage = 1.25;     // height over width of a figure that settles its own height
/// The instants of the published figures over the 9.6 s of its FE result.
constexpr std::array<double, 3> publishedShares{1.68 / 9.6, 3.36 / 9.6, 5.52 / 9.6};

/// One panel of a view; what it shows is drawn alone.
SheetPanel panelOf(const render::View& view, render::PaneContent content, double time, const QString& stage = {}) {
    SheetPanel panel{content, view, stage};
    const render::Camera camera = render::cameraOf(view, content);
    panel.view.camerasLinked = false;
    panel.view.cameras.fill(camera);
    panel.view.time = time;
    panel.view.layout = content == render::PaneContent::Fe        ? render::Layout::FeOnly
                        : content == render::PaneContent::Overlay ? render::Layout::OverlayOnly
                                                                  : render::Layout::FragmentsOnly;
    return panel;
}

/// The state next to a share of the FE result: published figures show states, not something between two of them.
double stateNear(const std::vector<double>& times, double share) {
    const double wanted = times.front() + share * (times.back() - times.front());
    return *std::min_element(times.begin(), times.end(),
                             [&](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
}

std::vector<double> instantsOf(const PresetRequest& request, const render::SceneData& data) {
    const std::vector<double>& states = data.fe->times();
    if (!request.times.empty()) {
        if (request.times.size() != presetInstants(request.preset)) {
            throw UsageError({"figure.instants",
                              "This arrangement shows {0} instants, not {1}",
                              {presetInstants(request.preset), request.times.size()}},
                             {"figure.instants.remedy", "Name as many, in seconds on the file's clock.", {}});
        }
        return request.times;
    }
    switch (request.preset) {
        case FigurePreset::Pairs:
            return {stateNear(states, publishedShares[0]), stateNear(states, publishedShares[1]),
                    stateNear(states, publishedShares[2])};
        case FigurePreset::Stages:
            return {states.front(), stateNear(states, publishedShares[0]), stateNear(states, publishedShares[2]), request.end};
        case FigurePreset::End:
        case FigurePreset::Surroundings:
            break;
    }
    return {request.end};
}

/// Pixels that pictures of a shape need, at most those of a page.
int fittingHeight(int columns, int rows, SheetLegend legend, bool provenance, bool cautions, int width, double dpi, double aspect) {
    const SheetLayout lines = layOutSheet(columns, rows, legend, provenance, {width, 1}, dpi, cautions);
    const int picture = std::max(static_cast<int>(std::lround(lines.panel.width() / aspect)), static_cast<int>(5.0 * lines.text));
    const int height = rows * (picture + lines.key + lines.caption) + lines.legend + lines.cautions + lines.provenance;
    return std::min(height, static_cast<int>(tallestPage * width));
}

/// The firsts of all pairs in one row, the seconds below.
void besideEachOther(std::vector<SheetPanel>& panels) {
    std::vector<SheetPanel> rows;
    for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
        for (std::size_t i = first; i < panels.size(); i += 2) {
            rows.push_back(panels[i]);
        }
    }
    panels = std::move(rows);
}

}  // namespace

void dress(render::View& view, render::Style style) {
    view.style = style;
    if (style == render::Style::Presentation) {
        view.groundGrid = false;
        view.shading = true;
    }
}

QString paneName(render::PaneContent content, bool looseBodies) {
    switch (content) {
        case render::PaneContent::Fe:
            return looseBodies ? tr("Bodies that are not let go yet") : tr("Conventional FE result");
        case render::PaneContent::Overlay:
            return tr("Fragments and intact outline");
        case render::PaneContent::Plan:
            return tr("Fragments in plan");
        case render::PaneContent::Other:
            return tr("Fragments of another scenario");
        case render::PaneContent::Fragments:
            break;
    }
    return tr("Fragments");
}

QSize usualSize(std::optional<FigurePreset> preset) {
    return {1600, preset ? 0 : 1000};
}

std::size_t presetInstants(FigurePreset preset) {
    return preset == FigurePreset::Pairs ? 3 : preset == FigurePreset::Stages ? 4 : 1;
}

QRect SheetLayout::panelAt(int column, int row) const {
    return {column * (panel.width() + gap), row * (panel.height() + key + caption), panel.width(), panel.height()};
}

int cautionHeight(double text) {
    return static_cast<int>(std::lround(3.4 * cautionShare * text));
}

void paintCautions(QPainter& painter, const QRectF& strip, const QString& cautions, double text, render::Theme theme) {
    painter.fillRect(strip, palette(theme).findingTint);
    painter.setPen(palette(theme).text);
    const double largest = cautionShare * text;
    writeWhole(painter, strip.adjusted(0.6 * largest, 0.0, -0.6 * largest, 0.0), cautions, Qt::AlignCenter,
               {largest, 0.3 * largest, false});
}

SheetLayout layOutSheet(int columns, int rows, SheetLegend legend, bool provenance, QSize pixels, double dpi, bool cautions) {
    SheetLayout layout;
    layout.text = sheetTextPoints / 72.0 * dpi;
    layout.small = provenancePoints / 72.0 * dpi;
    layout.gap = columns > 1 ? std::max(1, static_cast<int>(std::lround(0.6 * layout.text))) : 0;
    layout.caption = static_cast<int>(std::lround(2.2 * layout.text));
    layout.key = legend == SheetLegend::Below ? static_cast<int>(std::lround(1.8 * layout.text)) : 0;
    layout.legend = legend == SheetLegend::Foot ? static_cast<int>(std::lround(2.0 * layout.text)) : 0;
    layout.provenance = provenance ? static_cast<int>(std::lround(2.0 * layout.small)) : 0;
    layout.cautions = cautions ? cautionHeight(layout.text) : 0;
    const int foot = layout.legend + layout.cautions + layout.provenance;
    const int height = pixels.height() - rows * (layout.key + layout.caption) - foot;
    layout.panel = {std::max((pixels.width() - (columns - 1) * layout.gap) / columns, 16), std::max(height / rows, 16)};
    return layout;
}

Sheet sheetOf(const render::View& view) {
    const std::vector<render::Pane> panes = render::panesOf(view.layout, 100, 100);
    Sheet sheet;
    sheet.columns = view.layout == render::Layout::Stacked ? 1 : std::min<int>(2, static_cast<int>(panes.size()));
    for (const render::Pane& pane : panes) {
        sheet.panels.push_back(panelOf(view, pane.content, view.time));
    }
    return sheet;
}

Sheet presetSheet(const PresetRequest& request, const render::View& like, const render::SceneData& data) {
    using render::PaneContent;
    const std::vector<double> times = instantsOf(request, data);
    const bool around = request.preset == FigurePreset::Surroundings;
    Sheet sheet;
    sheet.framed = !request.camerasOfView;
    sheet.look = request.look.value_or(around ? render::Preset::Corner : render::Preset::Side);
    render::View view = like;
    view.captions = true;
    dress(view, request.style.value_or(render::Style::Presentation));
    const auto add = [&](PaneContent content, double time, const QString& stage = {}) {
        sheet.panels.push_back(panelOf(view, content, time, stage));
    };
    if (request.preset == FigurePreset::Pairs) {
        sheet.commonLegend = sheet.pairs = true;
        sheet.choices = {3, 1};
        for (const double time : times) {
            add(PaneContent::Fe, time);
            add(PaneContent::Fragments, time);
        }
    } else if (request.preset == FigurePreset::End) {
        sheet.choices = {1, 2};
        add(PaneContent::Fe, times[0]);
        add(PaneContent::Fragments, times[0]);
    } else if (around) {
        sheet.around = surroundingsFactor;
        add(PaneContent::Fragments, times[0], tr("Debris and surroundings"));
    } else {
        sheet.commonLegend = true;
        sheet.choices = {2, 1, 4};
        const std::array<QString, 4> stages{tr("Original"), tr("Early stage"), tr("Intermediate stage"), tr("Final stage")};
        for (std::size_t i = 0; i < stages.size(); ++i) {
            add(PaneContent::Fragments, times[i], stages[i]);
        }
    }
    return sheet;
}

void arrange(Sheet& sheet, const render::Framing& framing, QSize& pixels, double dpi, bool provenance, bool cautions) {
    const double natural = framing.aspect();
    const SheetLegend legend = legendOf(sheet);
    const auto panels = static_cast<int>(sheet.panels.size());
    const int width = pixels.width();
    const int asked = pixels.height();
    double most = 0.0;
    for (const int columns : sheet.choices.empty() ? std::vector<int>{sheet.columns} : sheet.choices) {
        const int rows = (panels + columns - 1) / columns;
        const int height = asked > 0 ? asked : fittingHeight(columns, rows, legend, provenance, cautions, width, dpi, natural);
        const QSize panel = layOutSheet(columns, rows, legend, provenance, {width, height}, dpi, cautions).panel;
        const render::Camera camera = framing.camera(static_cast<double>(panel.width()) / panel.height());
        // Where the model comes out largest.
        const double scale = 1.0 / render::metresPerPixel(camera, panel.height());
        if (scale > 1.02 * most) {
            most = scale;
            sheet.columns = columns;
            pixels.setHeight(height);
            for (SheetPanel& each : sheet.panels) {
                if (sheet.framed && !framing.empty() && each.content != render::PaneContent::Plan) {
                    each.view.cameras.fill(camera);
                    each.framed = true;
                }
            }
        }
    }
    if (sheet.pairs && sheet.columns > 1) {
        besideEachOther(sheet.panels);
    }
    // It is settled now.
    sheet.choices.clear();
    sheet.framed = sheet.pairs = false;
}

SheetLegend legendOf(const Sheet& sheet) {
    const bool each =
        std::any_of(sheet.panels.begin(), sheet.panels.end(), [](const SheetPanel& panel) { return panel.view.legends; });
    return sheet.commonLegend ? SheetLegend::Foot : each ? SheetLegend::Below : SheetLegend::None;
}

QString classWords(render::PaneContent content, const render::PaneStatus& status) {
    if (content == render::PaneContent::Fe && status.looseBodies) {
        return tr("given");
    }
    if (content == render::PaneContent::Fe) {
        return status.interpolated ? tr("computed, between two states")
               : status.afterFeEnd ? tr("computed, last state")
                                   : tr("computed");
    }
    if (status.fragments == 0 && status.released == 0) {
        // Nothing has come off yet: the structure moves as the FE result says.
        return tr("computed");
    }
    if (!status.simulated) {
        return tr("illustrative, not simulated");
    }
    return status.kind == FrameKind::Interpolated ? tr("simulated, interpolated") : tr("simulated");
}

QString captionBelow(std::size_t index, render::PaneContent content, const render::PaneStatus& status, double timeOrigin,
                     const QString& stage, std::size_t outside) {
    const QString letter = QStringLiteral("%1) ").arg(QChar(static_cast<char16_t>('a' + index % 26)));
    const QString name = stage.isEmpty() ? paneName(content, status.looseBodies) : stage;
    if (status.states == 0) {
        return letter + name;
    }
    QStringList brackets{QStringLiteral("t = ") + timeText(status.time - timeOrigin), classWords(content, status)};
    if (outside > 0) {
        brackets << tr("%1 outside the picture").arg(countText(outside));
    }
    return letter + QStringLiteral("%1 (%2)").arg(name, brackets.join(QStringLiteral(", ")));
}

std::string shownAs(render::PaneContent content, const render::PaneStatus& status) {
    if (content == render::PaneContent::Fe) {
        return status.interpolated ? "FE, interpolated between two states" : "FE";
    }
    if (!status.simulated) {
        return status.fragments > 0 ? "illustrative" : "FE";
    }
    return status.kind == FrameKind::Interpolated ? "simulated, interpolated between two recorded instants" : "simulated";
}

void takeMarksBelow(SheetPicture::Panel& panel, const SheetLayout& layout) {
    Overlay& over = panel.overlay;
    panel.metresPerPixel = std::exchange(over.metresPerPixel, 0.0);
    const double room = panel.place.width() - 1.2 * scaleLineWidth(panel.metresPerPixel, panel.place.width(), layout.text);
    if (layout.key == 0 || smallestLegend * legendLineWidth(over.legend, over.bars, layout.text) > room) {
        return;
    }
    panel.legend = std::move(over.legend);
    panel.bars = std::move(over.bars);
    over.legend.clear();
    over.bars.clear();
}

void SheetPicture::setFoot(std::vector<LegendEntry> legend, std::vector<ColourBar> bars, QString provenance, QString cautions) {
    m_legend = std::move(legend);
    m_bars = std::move(bars);
    m_provenance = std::move(provenance);
    m_cautions = std::move(cautions);
}

void SheetPicture::paint(QPainter& painter) const {
    painter.fillRect(QRect(QPoint(0, 0), m_pixels), Qt::white);
    for (const Panel& panel : m_panels) {
        painter.drawImage(panel.place, panel.picture);
        painter.save();
        painter.translate(panel.place.topLeft());
        const render::Pane pane{panel.shown.content, 0, 0, panel.place.width(), panel.place.height()};
        paintMarks(painter, panel.view, pane, m_layout.text, panel.axes);
        paintOverlay(painter, panel.overlay, pane, render::Theme::Print, m_layout.text);
        painter.restore();
    }
    paintCaptions(painter);
    paintLegends(painter);
    paintProvenance(painter);
}

/// Where the pictures share a legend and a scale, one scale bar stands for all.
double SheetPicture::commonScale() const {
    const bool same =
        m_layout.legend > 0 && !m_panels.empty() && std::all_of(m_panels.begin(), m_panels.end(), [&](const Panel& panel) {
            return std::abs(panel.metresPerPixel - m_panels.front().metresPerPixel) <= 1e-6 * panel.metresPerPixel;
        });
    return same ? m_panels.front().metresPerPixel : 0.0;
}

void SheetPicture::paintCaptions(QPainter& painter) const {
    const bool scaled = m_layout.key == 0 && !(commonScale() > 0.0);
    for (const Panel& panel : m_panels) {
        QRect box(panel.place.left(), panel.place.bottom() + 1 + m_layout.key, panel.place.width(), m_layout.caption);
        if (scaled) {
            const render::Pane strip{panel.shown.content, box.left(), box.top(), box.width(), box.height()};
            box.setWidth(box.width() - static_cast<int>(paintScaleLine(painter, panel.metresPerPixel, strip, m_layout.text)));
        }
        painter.setPen(palette(render::Theme::Print).text);
        writeWhole(painter, box, panel.shown.caption, Qt::AlignCenter, {m_layout.text, smallestCaption * m_layout.text, true});
    }
}

void SheetPicture::paintLegends(QPainter& painter) const {
    for (const Panel& panel : m_panels) {
        render::Pane strip{panel.shown.content, panel.place.left(), panel.place.bottom() + 1, panel.place.width(), m_layout.key};
        if (m_layout.key > 0) {
            strip.width -= static_cast<int>(paintScaleLine(painter, panel.metresPerPixel, strip, m_layout.text));
        }
        const double needed = legendLineWidth(panel.legend, panel.bars, m_layout.text);
        paintLegendLine(painter, panel.legend, panel.bars, strip,
                        m_layout.text * std::clamp(0.98 * strip.width / std::max(needed, 1.0), smallestLegend, 1.0));
    }
    if (m_layout.legend == 0) {
        return;
    }
    const int top = m_pixels.height() - m_layout.provenance - m_layout.cautions - m_layout.legend;
    render::Pane strip{render::PaneContent::Fragments, 0, top, m_pixels.width(), m_layout.legend};
    render::Pane last = strip;
    last.width = m_panels.empty() ? strip.width : m_panels.front().place.width();
    last.x = strip.width - last.width;
    strip.width -= static_cast<int>(paintScaleLine(painter, commonScale(), last, m_layout.text));
    paintLegendLine(painter, m_legend, m_bars, strip, m_layout.text);
}

void SheetPicture::paintProvenance(QPainter& painter) const {
    if (m_layout.cautions > 0) {
        const int top = m_pixels.height() - m_layout.provenance - m_layout.cautions;
        paintCautions(painter, QRectF(0, top, m_pixels.width(), m_layout.cautions), m_cautions, m_layout.text,
                      render::Theme::Print);
    }
    if (m_layout.provenance == 0) {
        return;
    }
    painter.setFont(sheetFont(m_layout.small, false));
    painter.setPen(palette(render::Theme::Print).muted);
    const QRect foot(0, m_pixels.height() - m_layout.provenance, m_pixels.width(), m_layout.provenance);
    painter.drawText(foot, static_cast<int>(Qt::AlignHCenter | Qt::AlignVCenter),
                     QFontMetricsF(sheetFont(m_layout.small, false)).elidedText(m_provenance, Qt::ElideMiddle, foot.width()));
}

QImage SheetPicture::image() const {
    QImage figure(m_pixels, QImage::Format_RGB32);
    figure.fill(Qt::white);
    QPainter painter(&figure);
    paint(painter);
    return figure;
}

}  // namespace rubble::figures
