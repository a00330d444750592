#include "widgets/basics/icons.h"

#include <gtest/gtest.h>

#include <QImage>
#include <set>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

constexpr int glyphs = static_cast<int>(Glyph::About) + 1;

QImage drawn(Glyph glyph, const QColor& colour, int side = 22) {
    QImage image(side, side, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setPen(colour);
    drawGlyph(painter, glyph, QRect(0, 0, side, side));
    return image;
}

/// How many pixels are nearly covered, and whether all of them have the colour.
std::pair<int, bool> covered(const QImage& image, const QColor& colour) {
    int pixels = 0;
    bool alike = true;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor at = image.pixelColor(x, y);
            if (at.alpha() > 200) {
                ++pixels;
                alike = alike && std::abs(at.red() - colour.red()) < 8 && std::abs(at.green() - colour.green()) < 8 &&
                        std::abs(at.blue() - colour.blue()) < 8;
            }
        }
    }
    return {pixels, alike};
}

class Icons : public testing::Test {
protected:
    void SetUp() override { giveColours(render::Theme::Light); }
    void TearDown() override { giveColours(render::Theme::Light); }
};

TEST_F(Icons, EveryGlyphIsDrawnInTheColourOfThePen) {
    for (const render::Theme theme : {render::Theme::Light, render::Theme::Dark}) {
        giveColours(theme);
        for (int i = 0; i < glyphs; ++i) {
            for (const QColor colour : {tints().text, tints().accent}) {
                const auto [pixels, alike] = covered(drawn(static_cast<Glyph>(i), colour), colour);
                EXPECT_GT(pixels, 8) << "glyph " << i << " is not to be seen";
                EXPECT_LT(pixels, 22 * 22 * 2 / 3) << "glyph " << i << " is a blot";
                EXPECT_TRUE(alike) << "glyph " << i << " has colours of its own";
            }
        }
    }
}

TEST_F(Icons, NoTwoGlyphsLookAlikeButTakingBackAndGivingBack) {
    std::set<QByteArray> pictures;
    for (int i = 0; i < glyphs; ++i) {
        const QImage image = drawn(static_cast<Glyph>(i), Qt::black);
        pictures.insert(QByteArray(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes()));
    }
    EXPECT_EQ(pictures.size(), static_cast<std::size_t>(glyphs - 1));
    EXPECT_EQ(drawn(Glyph::Undo, Qt::black), drawn(Glyph::Reset, Qt::black));
}

TEST_F(Icons, PlayingBackwardsIsPlayingMirrored) {
    EXPECT_EQ(drawn(Glyph::PlayBack, Qt::black), drawn(Glyph::Play, Qt::black).mirrored(true, false));
}

TEST_F(Icons, AnIconFollowsTheThemeAndFadesWhereItIsDisabled) {
    const QIcon icon = glyphIcon(Glyph::Open);
    for (const render::Theme theme : {render::Theme::Light, render::Theme::Dark}) {
        giveColours(theme);
        EXPECT_TRUE(covered(icon.pixmap(22, 22).toImage(), tints().text).second);
        EXPECT_GT(covered(icon.pixmap(22, 22).toImage(), tints().text).first, 8);
        EXPECT_EQ(covered(icon.pixmap(QSize(22, 22), QIcon::Disabled).toImage(), tints().muted).first, 0);
    }
}

}  // namespace

}  // namespace rubble::widgets
