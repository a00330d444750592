#include "widgets/basics/icons.h"

#include <QIconEngine>
#include <QPixmapCache>
#include <QStandardPaths>
#include <algorithm>
#include <array>
#include <cassert>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

/// Where the picture of a glyph comes from.
struct Source {
    Glyph glyph;
    const char* name;       ///< in the icon theme, or of our own drawing
    bool own = false;       ///< a notion of Rubble's, which no theme knows
    bool mirrored = false;  ///< right and left change places
};

constexpr bool own = true, mirrored = true;

constexpr std::array sources = {
    Source{Glyph::Case, "case", own},
    Source{Glyph::Fragments, "fragments", own},
    Source{Glyph::Grid, "grid", own},
    Source{Glyph::Effects, "effects", own},
    Source{Glyph::Run, "run", own},
    Source{Glyph::Accuracy, "accuracy", own},
    Source{Glyph::Finding, "finding", own},
    Source{Glyph::Evidence, "camera-photo"},
    Source{Glyph::Report, "report", own},
    Source{Glyph::New, "document-new"},
    Source{Glyph::Open, "document-open"},
    Source{Glyph::Refresh, "view-refresh"},
    Source{Glyph::Duplicate, "edit-copy"},
    Source{Glyph::Save, "document-save"},
    Source{Glyph::SaveAs, "document-save-as"},
    Source{Glyph::Quit, "application-exit"},
    Source{Glyph::Undo, "edit-undo"},
    Source{Glyph::Redo, "edit-redo"},
    Source{Glyph::Preferences, "configure"},
    Source{Glyph::Play, "media-playback-start"},
    Source{Glyph::Pause, "media-playback-pause"},
    Source{Glyph::First, "media-skip-backward"},
    Source{Glyph::Last, "media-skip-forward"},
    Source{Glyph::Back, "media-seek-backward"},
    Source{Glyph::Forward, "media-seek-forward"},
    Source{Glyph::Beside, "view-split-left-right"},
    Source{Glyph::Stacked, "view-split-top-bottom"},
    Source{Glyph::FeOnly, "fe-only", own},
    Source{Glyph::FragmentsOnly, "fragments-only", own},
    Source{Glyph::Link, "insert-link"},
    Source{Glyph::Fit, "zoom-fit-best"},
    Source{Glyph::Live, "live", own},
    Source{Glyph::Stop, "media-playback-stop"},
    Source{Glyph::PlayBack, "media-playback-start", !own, mirrored},
    Source{Glyph::Loop, "media-playlist-repeat"},
    Source{Glyph::Bookmark, "bookmark-new"},
    Source{Glyph::Unfold, "go-next"},
    Source{Glyph::Fold, "go-down"},
    Source{Glyph::Close, "window-close"},
    Source{Glyph::Float, "view-restore"},
    Source{Glyph::Reset, "edit-undo"},
    Source{Glyph::Help, "help-contents"},
    Source{Glyph::Search, "edit-find"},
    Source{Glyph::About, "help-about"},
};
static_assert(sources.size() == static_cast<std::size_t>(Glyph::About) + 1);

const Source& sourceOf(Glyph glyph) {
    const auto* found = std::ranges::find(sources, glyph, &Source::glyph);
    assert(found != sources.end());
    return *found;
}

/// The glyph in one colour, as many pixels wide and high as a square of that side has on the screen.
QPixmap pictureOf(Glyph glyph, int side, double ratio, const QColor& colour) {
    const QString key = QStringLiteral("rubble glyph %1 %2 %3 %4 %5")
                            .arg(static_cast<int>(glyph))
                            .arg(side)
                            .arg(ratio)
                            .arg(colour.name(QColor::HexArgb), QIcon::themeName());
    QPixmap picture;
    if (QPixmapCache::find(key, &picture)) {
        return picture;
    }
    const Source& source = sourceOf(glyph);
    const QString name = QString::fromLatin1(source.name);
    const QIcon icon = source.own ? QIcon(QStringLiteral(":/icons/%1.svg").arg(name)) : QIcon::fromTheme(name);
    picture = icon.pixmap(QSize(side, side), ratio);
    if (picture.isNull()) {
        return picture;
    }
    if (source.mirrored) {
        picture = picture.transformed(QTransform::fromScale(-1.0, 1.0));
    }
    QPainter painter(&picture);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(QRectF(QPointF(0.0, 0.0), picture.deviceIndependentSize()), colour);
    painter.end();
    QPixmapCache::insert(key, picture);
    return picture;
}

/// Draws at any size and in the colours of the theme of the moment.
class GlyphEngine : public QIconEngine {
public:
    explicit GlyphEngine(Glyph glyph) : m_glyph(glyph) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        QColor colour = mode == QIcon::Disabled ? tints().muted : tints().text;
        if (mode != QIcon::Disabled && state == QIcon::On) {
            colour = tints().accent;
        }
        colour.setAlphaF(mode == QIcon::Disabled ? 0.5F : 1.0F);
        painter->setPen(colour);
        const int side = std::min(rect.width(), rect.height());
        drawGlyph(*painter, m_glyph,
                  QRect(rect.x() + (rect.width() - side) / 2, rect.y() + (rect.height() - side) / 2, side, side));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap image(size);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return image;
    }
    QIconEngine* clone() const override { return new GlyphEngine(m_glyph); }

private:
    Glyph m_glyph;
};

}  // namespace

void useIconTheme(bool dark) {
    // Without a desktop nobody tells Qt where icon themes lie.
    QStringList paths = QIcon::themeSearchPaths();
    for (const QString& path :
         QStandardPaths::locateAll(QStandardPaths::GenericDataLocation, QStringLiteral("icons"), QStandardPaths::LocateDirectory)) {
        if (!paths.contains(path)) {
            paths << path;
        }
    }
    QIcon::setThemeSearchPaths(paths);
    static const QString ofTheDesktop = QIcon::themeName();
    QIcon::setFallbackThemeName(ofTheDesktop);
    QIcon::setThemeName(dark ? QStringLiteral("breeze-dark") : QStringLiteral("breeze"));
}

void drawGlyph(QPainter& painter, Glyph glyph, const QRect& square) {
    const QPixmap picture = pictureOf(glyph, square.width(), painter.device()->devicePixelRatioF(), painter.pen().color());
    painter.drawPixmap(square, picture);
}

QIcon glyphIcon(Glyph glyph) {
    return QIcon(new GlyphEngine(glyph));
}

}  // namespace rubble::widgets
