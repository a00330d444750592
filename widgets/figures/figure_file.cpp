#include "widgets/figures/figure_file.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <QBuffer>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImageWriter>
#include <QLocale>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <system_error>

#include "core/base/build.h"
#include "core/base/error.h"
#include "widgets/figures/draw.h"
#include "widgets/figures/marks.h"
#include "widgets/figures/overlay/overlay.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/sheets/sheet_text.h"
#include "widgets/figures/shown_units.h"
#include "widgets/render/panes.h"

namespace rubble::figures {
namespace {

constexpr double textPoints = 9.0;
constexpr const char* provenanceKey = "Rubble-Provenance";
constexpr int samples = 4;  // per pixel; figures are for the eye, not for speed

[[noreturn]] void failWriting(const std::string& path, const QString& why) {
    throw WorldError({"figure.write", "{0} cannot be written: {1}", {path, why.toStdString()}},
                     {"figure.write.remedy", "Check that the folder exists, may be written and has room.", {}});
}

double pixelsOf(double points, double dpi) {
    return points / 72.0 * dpi;
}

/// An off-screen VTK window as a surface: the GL picture is read back into an image.
class OffscreenSurface : public Surface {
public:
    OffscreenSurface(vtkRenderWindow& window, QSize pixels, double textHeight)
        : m_window(window), m_pixels(pixels), m_textHeight(textHeight) {}

    QSize pixels() const override { return m_pixels; }
    double textHeight() const override { return m_textHeight; }
    QPaintDevice& drawScene() override {
        m_window.SetSize(m_pixels.width(), m_pixels.height());
        m_window.Render();
        vtkNew<vtkUnsignedCharArray> rgb;
        m_window.GetPixelData(0, 0, m_pixels.width() - 1, m_pixels.height() - 1, 1, rgb);
        const QImage upsideDown(rgb->GetPointer(0), m_pixels.width(), m_pixels.height(), 3 * m_pixels.width(),
                                QImage::Format_RGB888);
        m_image = upsideDown.mirrored().convertToFormat(QImage::Format_RGB32);
        return m_image;
    }
    const QImage& image() const { return m_image; }

private:
    vtkRenderWindow& m_window;
    QSize m_pixels;
    double m_textHeight;
    QImage m_image;
};

}  // namespace

void ensureGuiApplication() {
    if (QCoreApplication::instance()) {
        return;
    }
    // Said as an argument, so that a platform in the environment, meant for windows, does not count.
    static int argc = 3;
    static char name[] = "rubble";
    static char option[] = "-platform";
    static char platform[] = "offscreen";
    static char* argv[] = {name, option, platform, nullptr};
    // Lives until the process ends: Qt's own statics may outlast ours.
    new QGuiApplication(argc, argv);
    // Without a window words are English, and so are numbers, whatever the system counts in.
    QLocale::setDefault(QLocale(QLocale::English));
}

struct Studio::Impl {
    vtkNew<vtkRenderWindow> window;
    render::Scene scene;
    std::function<void()> check;

    QImage drawn(const render::View& view, QSize pixels, double textHeight) {
        OffscreenSurface surface(*window, pixels, textHeight);
        draw(view, scene, surface);
        return surface.image();
    }

    SheetPicture sheet(Sheet sheet, const FigureStyle& style) {
        QSize pixels = style.pixels;
        const bool foot = !style.provenance.empty();
        if (sheet.framed || !sheet.choices.empty() || pixels.height() == 0) {
            arrange(sheet, framing(sheet), pixels, style.dpi, foot, !style.cautions.empty());
        }
        const SheetLayout layout =
            layOutSheet(sheet.columns, sheet.rows(), legendOf(sheet), foot, pixels, style.dpi, !style.cautions.empty());
        SheetPicture picture(pixels, layout);
        bool released = false;
        m_looking.clear();
        for (std::size_t i = 0; i < sheet.panels.size(); ++i) {
            if (check) {
                check();
            }
            SheetPicture::Panel panel = drawPanel(sheet, i, layout, style.north);
            released = released || panel.shown.status.released > 0;
            picture.add(std::move(panel));
        }
        std::vector<LegendEntry> legend;
        std::vector<ColourBar> bars;
        if (sheet.commonLegend && !picture.panels().empty()) {
            legend = commonLegend(picture.panels().front().view, scene.data(), released);
            bars = m_bars;
            m_looking.removeDuplicates();
            if (m_looking.size() == 1) {
                legend.push_back({QColor(), m_looking.front()});
            }
        }
        picture.setFoot(std::move(legend), std::move(bars), QString::fromStdString(style.provenance),
                        QString::fromStdString(style.cautions));
        return picture;
    }

    render::Framing framing(const Sheet& sheet) {
        render::Framing all(sheet.look);
        const render::SceneData& data = scene.data();
        double largest = 0.0;
        for (std::size_t f = 0; data.fragments && f < data.fragments->size(); ++f) {
            largest = std::max(largest, data.fragments->list[f].bounds.sizes().norm());
        }
        const Aabb structure = data.fe ? render::boundsOf(data) : Aabb();
        for (const SheetPanel& panel : sheet.panels) {
            if (check) {
                check();
            }
            const render::PaneContent drawn = drawnAs(panel.content);
            scene.update(panel.view, 64, 64);
            std::vector<Vec3> points = scene.shownPoints(drawn);
            if (panel.content == render::PaneContent::Overlay && !structure.isEmpty()) {
                // The outline of the intact structure is shown beside.
                for (const Vec3& node : data.fe->mesh().nodes) {
                    points.push_back(node);
                }
            }
            std::vector<Vec3> centres;
            scene.elementsWhere(drawn, [&](const Vec3& centre) {
                centres.push_back(centre);
                return false;
            });
            all.add(points, centres, structure, largest);
        }
        if (sheet.around > 1.0) {
            all.widen(sheet.around);
        }
        return all;
    }

private:
    static render::PaneContent drawnAs(render::PaneContent content) {
        return content == render::PaneContent::Plan ? render::PaneContent::Fragments : content;
    }

    SheetPicture::Panel drawPanel(const Sheet& sheet, std::size_t index, const SheetLayout& layout, std::optional<double> north) {
        const SheetPanel& from = sheet.panels[index];
        SheetPicture::Panel panel;
        panel.view = from.view;
        panel.view.theme = render::Theme::Print;
        panel.place = layout.panelAt(static_cast<int>(index) % sheet.columns, static_cast<int>(index) / sheet.columns);
        panel.picture = bare(panel.view, panel.place.size());
        const render::PaneContent drawn = drawnAs(from.content);
        const render::Pane pane{drawn, 0, 0, panel.place.width(), panel.place.height()};
        const render::Camera& camera = render::cameraOf(panel.view, drawn);
        panel.overlay = makeOverlay(panel.view, scene, pane);
        panel.overlay.caption.clear();
        if (sheet.commonLegend && !panel.overlay.bars.empty()) {
            m_bars = panel.overlay.bars;
        }
        panel.axes = axesCorner(pane, layout.text,
                                [&](std::span<const std::array<double, 4>> squares) { return scene.covered(pane, squares); });
        if (panel.view.axes && (north || !panel.axes)) {
            m_looking << lookingText(camera, north);
            if (!panel.overlay.legend.empty()) {
                panel.overlay.legend.push_back({QColor(), m_looking.back()});
            }
        }
        if (sheet.commonLegend) {
            panel.overlay.legend.clear();
            panel.overlay.bars.clear();
        }
        takeMarksBelow(panel, layout);
        if (!panel.overlay.legend.empty() || !panel.overlay.bars.empty()) {
            panel.axes = Corner::UpperRight;
        }
        panel.shown = {from.content, scene.status(drawn), {}};
        std::size_t outside = 0;
        if (from.framed) {
            outside = scene
                          .elementsWhere(drawn,
                                         [&](const Vec3& centre) {
                                             const auto at = render::project(camera, centre, pane.aspect());
                                             return !at || at->u < 0.0 || at->u > 1.0 || at->v < 0.0 || at->v > 1.0;
                                         })
                          .size();
        }
        panel.shown.caption =
            panel.view.captions ? captionBelow(index, from.content, panel.shown.status, panel.view.timeOrigin, from.stage, outside)
                                : classWords(from.content, panel.shown.status);
        return panel;
    }
    /// The scene alone, nothing painted over it.
    QImage bare(const render::View& view, QSize pixels) {
        OffscreenSurface surface(*window, pixels, 0.0);
        scene.setColours(sceneColours(view.theme, view.colourMap));
        scene.update(view, pixels.width(), pixels.height());
        surface.drawScene();
        return surface.image();
    }

    std::vector<ColourBar> m_bars;
    QStringList m_looking;  ///< where the pictures of a sheet look from, as far as that is said
};

Studio::Studio(const render::SceneData& data) {
    requireDisplay();
    m_impl = std::make_unique<Impl>();
    m_impl->window->SetOffScreenRendering(1);
    m_impl->window->SetMultiSamples(samples);
    m_impl->scene.attach(*m_impl->window);
    m_impl->scene.setData(data);
}

Studio::~Studio() = default;

namespace {

/// @param settled  a height of 0 is settled later
void checkSize(const FigureStyle& style, bool settled) {
    constexpr int largest = 16384;
    if (style.pixels.width() < 16 || (style.pixels.height() < 16 && !(settled && style.pixels.height() == 0)) ||
        style.pixels.width() > largest || style.pixels.height() > largest || !(style.dpi >= 20.0 && style.dpi <= 2400.0)) {
        throw UsageError({"figure.size",
                          "A figure of {0} x {1} pixels at {2} dpi cannot be drawn",
                          {style.pixels.width(), style.pixels.height(), style.dpi}},
                         {"figure.size.remedy", "Ask for 16 to {0} pixels a side and 20 to 2400 dpi.", {largest}});
    }
}

}  // namespace

void Studio::setCheck(std::function<void()> check) {
    m_impl->check = std::move(check);
}

SheetPicture Studio::sheet(const Sheet& sheet, const FigureStyle& style) {
    const FileUnits inSi;
    checkSize(style, true);
    return m_impl->sheet(sheet, style);
}

render::Framing Studio::framing(const Sheet& sheet) {
    return m_impl->framing(sheet);
}

QImage Studio::picture(const render::View& view, const FigureStyle& style) {
    const FileUnits inSi;
    checkSize(style, style.framed);
    QImage image = style.framed ? m_impl->sheet(sheetOf(view), style).image()
                                : m_impl->drawn(view, style.pixels, pixelsOf(textPoints, style.dpi));
    setResolution(image, style.dpi);
    if (!style.provenance.empty()) {
        image.setText(QStringLiteral("Description"), QString::fromStdString(style.provenance));
    }
    return image;
}

const render::PaneStatus& Studio::status(render::PaneContent content) const {
    return m_impl->scene.status(content);
}

void Studio::setAllFaces(bool all) {
    m_impl->scene.setAllFaces(all);
}

const render::Scene& Studio::scene() const {
    return m_impl->scene;
}

void writePng(const std::string& path, const QImage& image, const std::string& metadata) {
    QImage tagged = image;
    if (!metadata.empty()) {
        tagged.setText(QString::fromLatin1(provenanceKey), QString::fromStdString(metadata));
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QImageWriter writer(&buffer, "png");
    if (!(buffer.open(QIODevice::WriteOnly) && writer.write(tagged))) {
        failWriting(path, writer.errorString());
    }
    writeBytes(path, bytes);
}

void writeFigure(const std::string& path, const render::View& view, const render::SceneData& data, const FigureStyle& style) {
    Studio studio(data);
    writePng(path, studio.picture(view, style));
}

namespace {

QString endingOf(const std::string& path) {
    return QFileInfo(QString::fromStdString(path)).suffix().toLower();
}

/// What the generator wrote, with the provenance where SVG has its place for it.
QByteArray svgOf(const SheetPicture& picture, const FigureStyle& style, const std::string& metadata) {
    QByteArray svg;
    {
        QBuffer buffer(&svg);
        QSvgGenerator generator;
        generator.setOutputDevice(&buffer);
        generator.setResolution(static_cast<int>(std::lround(style.dpi)));
        generator.setSize(picture.pixels());
        generator.setViewBox(QRect(QPoint(0, 0), picture.pixels()));
        generator.setTitle(QStringLiteral("Rubble"));
        // Qt 6.4 writes a description as it is given.
        generator.setDescription(QString::fromStdString(style.provenance).toHtmlEscaped());
        QPainter painter(&generator);
        picture.paint(painter);
    }
    if (!metadata.empty()) {
        const QByteArray block = "<metadata><![CDATA[" + QByteArray::fromStdString(metadata) + "]]></metadata>\n";
        const qsizetype place = svg.indexOf("<defs>");
        svg.insert(place < 0 ? svg.indexOf('>', svg.indexOf("<svg")) + 1 : place, block);
    }
    return svg;
}

QByteArray pdfOf(const SheetPicture& picture, const FigureStyle& style, const std::string& metadata) {
    QByteArray pdf;
    QBuffer buffer(&pdf);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(static_cast<int>(std::lround(style.dpi)));
    writer.setPageSize(QPageSize(QSizeF(picture.pixels()) / style.dpi, QPageSize::Inch));
    writer.setPageMargins(QMarginsF());
    writer.setTitle(QStringLiteral("Rubble"));
    tagPdf(writer, metadata);
    QPainter painter(&writer);
    picture.paint(painter);
    painter.end();
    return pdf;
}

}  // namespace

void tagPdf(QPdfWriter& writer, const std::string& metadata) {
    writer.setCreator(QString::fromStdString(std::string(buildText())));
    if (metadata.empty()) {
        return;
    }
    const QByteArray json = QByteArray::fromStdString(metadata);
    // Readers of tags take the title from here (ISO 14289-1, 7.1).
    const QByteArray title = writer.title().isEmpty()
                                 ? QByteArray()
                                 : "<dc:title><rdf:Alt><rdf:li xml:lang='x-default'>" + writer.title().toHtmlEscaped().toUtf8() +
                                       "</rdf:li></rdf:Alt></dc:title>";
    writer.setDocumentXmpMetadata(
        "<?xpacket begin='' id='W5M0MpCehiHzreSzNTczkc9d'?>\n<x:xmpmeta xmlns:x='adobe:ns:meta/'>"
        "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'>"
        "<rdf:Description rdf:about='' xmlns:dc='http://purl.org/dc/elements/1.1/'>" +
        title + "<dc:source><![CDATA[" + json + "]]></dc:source></rdf:Description></rdf:RDF></x:xmpmeta>\n<?xpacket end='w'?>");
    writer.addFileAttachment(QStringLiteral("provenance.json"), json, QStringLiteral("application/json"));
}

bool isFigurePath(const std::string& path) {
    const QString ending = endingOf(path);
    return ending == QLatin1String("png") || ending == QLatin1String("svg") || ending == QLatin1String("pdf");
}

void writeBytes(const std::string& path, const QByteArray& bytes) {
    QSaveFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::WriteOnly)) {
        failWriting(path, file.errorString());
    }
    // Qt forgets why the last of its buffer could not be written.
    errno = 0;
    if (file.write(bytes) != bytes.size() || !file.flush()) {
        const int why = errno;
        file.cancelWriting();
        failWriting(path, why != 0 ? QString::fromStdString(std::generic_category().message(why)) : file.errorString());
    }
    if (!file.commit()) {
        failWriting(path, file.errorString());
    }
}

void writeSheet(const std::string& path, const SheetPicture& picture, const FigureStyle& style, const std::string& metadata) {
    if (!isFigurePath(path)) {
        throw UsageError({"figure.format", "{0} does not say by its ending what kind of figure it is to be", {path}},
                         {"figure.format.remedy", "Endings: .png, .svg, .pdf.", {}});
    }
    const QString ending = endingOf(path);
    if (ending == QLatin1String("png")) {
        QImage image = picture.image();
        setResolution(image, style.dpi);
        image.setText(QStringLiteral("Description"), QString::fromStdString(style.provenance));
        writePng(path, image, metadata);
    } else {
        writeBytes(path, ending == QLatin1String("svg") ? svgOf(picture, style, metadata) : pdfOf(picture, style, metadata));
    }
}

}  // namespace rubble::figures
