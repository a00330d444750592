#pragma once

#include <QByteArray>
#include <QImage>
#include <QSize>

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "widgets/figures/figure_sheet.h"
#include "widgets/figures/x_display.h"
#include "widgets/render/basics/scene_data.h"
#include "widgets/render/basics/view.h"
#include "widgets/render/scene.h"

class QPdfWriter;

namespace rubble::figures {

/// Makes a QGuiApplication with the platform "offscreen" if there is none: text in figures needs one. Call once from the main
/// thread.
void ensureGuiApplication();

/// Size and place of a figure.
struct FigureStyle {
    QSize pixels{1600, 1000};       ///< of a sheet a height of 0 is settled by what it shows, see arrange()
    double dpi = 200.0;             ///< decides the size of text: 9 pt
    bool framed = true;             ///< figure style: white background, captions below; false: as in the window
    std::string provenance;         ///< one line in 6 pt at the foot, empty for none
    std::string cautions{};         ///< what must be known beside it, above that; empty for none
    std::optional<double> north{};  ///< rad from +y of the local frame, clockwise; unset: not known
};

/// Draws views off-screen. Opens its GL window once and keeps it: use one studio for many pictures (movie frames).
class Studio {
public:
    /// Throws WorldError (remedy: an X display, or Xvfb) when no display answers; call ensureGuiApplication() first.
    explicit Studio(const render::SceneData& data);
    ~Studio();
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;

    /// The picture of a view. A framed figure takes the Print theme whatever the view says.
    QImage picture(const render::View& view, const FigureStyle& style);
    /// A figure for print, in the Print theme, its size and text as the style says. Throws UsageError for a size out of range.
    SheetPicture sheet(const Sheet& sheet, const FigureStyle& style);
    /// What all pictures of a sheet show, from its `look`.
    render::Framing framing(const Sheet& sheet);
    /// Called before each picture of a sheet: may throw Cancelled.
    void setCheck(std::function<void()> check);
    /// The status that the last picture showed.
    const render::PaneStatus& status(render::PaneContent content) const;
    /// As Scene::setAllFaces().
    void setAllFaces(bool all);
    /// The scene behind the pictures, as of the last one.
    const render::Scene& scene() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Draws one view and writes it as PNG (resolution and provenance inside). Throws WorldError naming the path.
void writeFigure(const std::string& path, const render::View& view, const render::SceneData& data, const FigureStyle& style);

/// Writes a figure in the format that the path's ending names: PNG, or SVG and PDF with text, lines and legends as vectors around
/// pictures of the scene. Atomic.
/// @param metadata  JSON of its provenance, put into the file: text chunk, <metadata>, XMP and attachment; empty: none
/// Throws UsageError for another ending, WorldError naming the path.
void writeSheet(const std::string& path, const SheetPicture& picture, const FigureStyle& style, const std::string& metadata);
/// Whether writeSheet() knows the ending of a path.
bool isFigurePath(const std::string& path);
/// Puts a provenance into a PDF that is about to be painted.
void tagPdf(QPdfWriter& writer, const std::string& metadata);
/// Writes a file atomically. Throws WorldError naming the path.
void writeBytes(const std::string& path, const QByteArray& bytes);

/// Writes an image as PNG, atomically. Throws WorldError naming the path.
/// @param metadata  as of writeSheet()
void writePng(const std::string& path, const QImage& image, const std::string& metadata = {});

}  // namespace rubble::figures
