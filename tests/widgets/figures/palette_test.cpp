#include "widgets/figures/palette.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/whole_file.h"

namespace rubble::figures {
namespace {

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

/// Relative luminance, WCAG 2.1.
double luminance(const QColor& c) {
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

constexpr render::Theme themes[] = {render::Theme::Light, render::Theme::Dark, render::Theme::Print};

TEST(Palette, TextIsLegibleEverywhere) {
    for (const render::Theme theme : themes) {
        const Palette& p = palette(theme);
        for (const QColor& ground : {p.window, p.panel, p.field, p.accentTint, p.findingTint}) {
            EXPECT_GE(contrast(p.text, ground), 7.0);
        }
        EXPECT_GE(contrast(p.muted, p.panel), 4.5);
        EXPECT_GE(contrast(p.accentText, p.accent), 4.5);
        EXPECT_GE(contrast(p.error, p.panel), 4.5);
        // Chips are translucent: the text must stand out from the chip over anything that may lie under it.
        for (const QColor& under : {p.ground, p.skyTop, p.skyHorizon, p.fragment, p.structure}) {
            const double a = p.chip.alphaF();
            const QColor mixed =
                QColor::fromRgbF(a * p.chip.redF() + (1 - a) * under.redF(), a * p.chip.greenF() + (1 - a) * under.greenF(),
                                 a * p.chip.blueF() + (1 - a) * under.blueF());
            EXPECT_GE(contrast(p.chipText, mixed), 7.0);
        }
    }
}

/// A colour as people without red cones see it (Vienot, Brettel, Mollon 1999), in linear light.
Eigen::Vector3d protanope(const QColor& c) {
    const Eigen::Vector3d rgb(linear(c.redF()), linear(c.greenF()), linear(c.blueF()));
    Eigen::Matrix3d m;
    m << 0.11238, 0.88762, 0.0, 0.11238, 0.88762, 0.0, 0.00401, -0.00401, 1.0;
    return m * rgb;
}

TEST(Palette, FragmentsStandOutFromStructureForTheColourBlindToo) {
    for (const render::Theme theme : themes) {
        const Palette& p = palette(theme);
        for (const QColor& grey : p.structureGreys) {
            EXPECT_GT((protanope(p.fragment) - protanope(grey)).norm(), 0.15);
            EXPECT_LT(grey.hsvSaturationF(), 0.25);  // stone is grey
        }
    }
}

TEST(Palette, ReleasedStructureIsNeitherFragmentNorStructureNorSelection) {
    for (const render::Theme theme : themes) {
        const Palette& p = palette(theme);
        EXPECT_GT((protanope(p.released) - protanope(p.fragment)).norm(), 0.15);
        EXPECT_GT((protanope(p.released) - protanope(p.accent)).norm(), 0.15);
        for (const QColor& grey : p.structureGreys) {
            EXPECT_GT((protanope(p.released) - protanope(grey)).norm(), 0.15);
        }
    }
}

TEST(Palette, ScalesRiseInLightness) {
    for (int i = 1; i <= 100; ++i) {
        EXPECT_GT(luminance(birthColour(i / 100.0)), luminance(birthColour((i - 1) / 100.0)));
        EXPECT_GT(luminance(speedColour(i / 100.0)), luminance(speedColour((i - 1) / 100.0)));
    }
    for (const auto map : {render::ColourMap::Viridis, render::ColourMap::Cividis, render::ColourMap::Grey}) {
        for (int i = 1; i <= 100; ++i) {
            EXPECT_GT(luminance(birthColour(i / 100.0, map)), luminance(birthColour((i - 1) / 100.0, map)));
        }
        EXPECT_EQ(birthColour(0.4, map), speedColour(0.4, map)) << "a shared scale is the same for both";
    }
    for (int i = 1; i <= 100; ++i) {
        EXPECT_LT(luminance(errorColour(i / 100.0)), luminance(errorColour((i - 1) / 100.0)));
    }
    EXPECT_EQ(birthColour(-3.0), birthColour(0.0));
    EXPECT_EQ(birthColour(7.0), birthColour(1.0));
    EXPECT_EQ(speedColour(std::nan("")), speedColour(0.0));
}

TEST(Palette, SceneDrawsWithTheSameColours) {
    for (const render::Theme theme : themes) {
        const render::SceneColours scene = sceneColours(theme);
        const Palette& p = palette(theme);
        EXPECT_EQ(QColor(scene.fragment.r, scene.fragment.g, scene.fragment.b), p.fragment);
        EXPECT_EQ(QColor(scene.released.r, scene.released.g, scene.released.b), p.released);
        EXPECT_EQ(QColor(scene.selection.r, scene.selection.g, scene.selection.b), p.accent);
        EXPECT_EQ(scene.structure.size(), p.structureGreys.size());
        EXPECT_EQ(scene.categories.size(), p.categories.size());
    }
    EXPECT_EQ(palette(render::Theme::Print).window, QColor(Qt::white));
}

TEST(Palette, APageHasTheMaterialsOfTheViews) {
    std::string row = "const materialTones = [";
    for (const QColor& colour : palette(render::Theme::Light).materials) {
        row += (row.back() == '[' ? "[" : ", [") + std::to_string(colour.red()) + ", " + std::to_string(colour.green()) + ", " +
               std::to_string(colour.blue()) + "]";
    }
    EXPECT_NE(io::wholeFile(sourcePath("resources/page/60-player.js")).find(row + "];"), std::string::npos) << row;
}

}  // namespace
}  // namespace rubble::figures
