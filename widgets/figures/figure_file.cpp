#include "widgets/figures/figure_file.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QImageWriter>
#include <QPainter>
#include <QSaveFile>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "widgets/figures/draw.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/palette.h"
#include "widgets/render/panes.h"

namespace rubble::figures {
namespace {

constexpr double textPoints = 9.0;
constexpr double provenancePoints = 6.0;
constexpr int samples = 4;  // per pixel; figures are for the eye, not for speed

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

/// Where panes, captions and provenance go in a framed figure.
struct Frame {
    double text = 0.0;      ///< px
    double small = 0.0;     ///< px
    int captionHeight = 0;  ///< below each row of panes
    int provenanceHeight = 0;
    QSize panes;  ///< of the drawn view, captions left out
};

Frame frameFor(render::Layout layout, const FigureStyle& style) {
    Frame frame;
    frame.text = pixelsOf(textPoints, style.dpi);
    frame.small = pixelsOf(provenancePoints, style.dpi);
    frame.captionHeight = static_cast<int>(std::lround(2.2 * frame.text));
    frame.provenanceHeight = style.provenance.empty() ? 0 : static_cast<int>(std::lround(2.0 * frame.small));
    const int rows = layout == render::Layout::Stacked || layout == render::Layout::Four ? 2 : 1;
    const int height = style.pixels.height() - rows * frame.captionHeight - frame.provenanceHeight;
    frame.panes = {style.pixels.width(), std::max(height, 16)};
    return frame;
}

QFont fontOf(double pixels, bool italic) {
    QFont font;
    font.setPixelSize(std::max(5, static_cast<int>(std::lround(pixels))));
    font.setItalic(italic);
    return font;
}

/// "a) Conventional FE result, t = 5.76 s"
QString captionBelow(std::size_t index, render::PaneContent content, const render::PaneStatus& status) {
    QString text = captionText(content, status);
    text.replace(QStringLiteral(" · "), QStringLiteral(", "));
    return QStringLiteral("%1) %2").arg(QChar(static_cast<char16_t>('a' + index))).arg(text);
}

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
}

struct Studio::Impl {
    vtkNew<vtkRenderWindow> window;
    render::Scene scene;

    QImage drawn(const render::View& view, QSize pixels, double textHeight) {
        OffscreenSurface surface(*window, pixels, textHeight);
        draw(view, scene, surface);
        return surface.image();
    }

    QImage framed(render::View view, const FigureStyle& style) {
        const Frame frame = frameFor(view.layout, style);
        view.theme = render::Theme::Print;
        const bool captions = view.captions;
        view.captions = false;
        const QImage panes = drawn(view, frame.panes, frame.text);
        QImage figure(style.pixels, QImage::Format_RGB32);
        figure.fill(Qt::white);
        QPainter painter(&figure);
        const Palette& colours = palette(view.theme);
        std::size_t index = 0;
        for (const render::Pane& pane : render::panesOf(view.layout, frame.panes.width(), frame.panes.height())) {
            const int down = pane.y > 0 ? frame.captionHeight : 0;
            painter.drawImage(QPoint(pane.x, pane.y + down), panes, QRect(pane.x, pane.y, pane.width, pane.height));
            if (captions) {
                painter.setFont(fontOf(frame.text, true));
                painter.setPen(colours.text);
                painter.drawText(QRect(pane.x, pane.y + pane.height + down, pane.width, frame.captionHeight),
                                 static_cast<int>(Qt::AlignHCenter | Qt::AlignVCenter),
                                 captionBelow(index, pane.content, scene.status(pane.content)));
            }
            ++index;
        }
        if (frame.provenanceHeight > 0) {
            painter.setFont(fontOf(frame.small, false));
            painter.setPen(colours.muted);
            const QRect foot(0, style.pixels.height() - frame.provenanceHeight, style.pixels.width(), frame.provenanceHeight);
            painter.drawText(
                foot, static_cast<int>(Qt::AlignHCenter | Qt::AlignVCenter),
                painter.fontMetrics().elidedText(QString::fromStdString(style.provenance), Qt::ElideMiddle, foot.width()));
        }
        return figure;
    }
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

QImage Studio::picture(const render::View& view, const FigureStyle& style) {
    constexpr int largest = 16384;
    if (style.pixels.width() < 16 || style.pixels.height() < 16 || style.pixels.width() > largest ||
        style.pixels.height() > largest || !(style.dpi >= 20.0 && style.dpi <= 2400.0)) {
        throw UsageError({"figure.size",
                          "A figure of {0} x {1} pixels at {2} dpi cannot be drawn",
                          {style.pixels.width(), style.pixels.height(), style.dpi}},
                         {"figure.size.remedy", "Ask for 16 to {0} pixels a side and 20 to 2400 dpi.", {largest}});
    }
    QImage image = style.framed ? m_impl->framed(view, style) : m_impl->drawn(view, style.pixels, pixelsOf(textPoints, style.dpi));
    image.setDotsPerMeterX(static_cast<int>(std::lround(style.dpi / 0.0254)));
    image.setDotsPerMeterY(static_cast<int>(std::lround(style.dpi / 0.0254)));
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

void writePng(const std::string& path, const QImage& image) {
    QSaveFile file(QString::fromStdString(path));
    QImageWriter writer(&file, "png");
    const bool written = file.open(QIODevice::WriteOnly) && writer.write(image) && file.commit();
    if (!written) {
        throw WorldError({"figure.write", "{0}: the picture cannot be written: {1}", {path, file.errorString().toStdString()}},
                         {"figure.write.remedy", "Check that the folder exists, may be written and has room.", {}});
    }
}

void writeFigure(const std::string& path, const render::View& view, const render::SceneData& data, const FigureStyle& style) {
    Studio studio(data);
    writePng(path, studio.picture(view, style));
}

}  // namespace rubble::figures
