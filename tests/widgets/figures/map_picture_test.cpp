#include "widgets/figures/map_picture.h"

#include <gtest/gtest.h>

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/base/error.h"
#include "tests/core/analysis/debris_scene.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/sheets/map_head.h"

namespace rubble::figures {
namespace {

DebrisMap fieldMap(const Debris& debris, bool live) {
    FragmentSet set;
    set.list.resize(debris.fragments.size());
    const std::vector<double> known(debris.fragments.size(), 2.0);
    LiveStructure fallen;
    MapPiece slab;
    slab.box = {Vec3(-14.0, 0.0, 0.5), Quat::Identity(), Vec3(1.0, 1.0, 0.5)};
    slab.centre = slab.box.centre;
    slab.mass = slab.volume = 4.0;
    fallen.pieces.push_back(slab);
    MapSettings settings;
    settings.cell = 0.5;
    return makeDebrisMap(2.0, mapPieces(set, debris, known, known), true, live ? &fallen : nullptr, {"deck"}, SiteSurface{},
                         settings, Execution());
}

std::size_t pixelsOf(const QImage& image, const QColor& colour) {
    std::size_t count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            count += image.pixelColor(x, y) == colour;
        }
    }
    return count;
}

class MapPicture : public testing::Test {
protected:
    void SetUp() override {
        ensureGuiApplication();
        style.pixels = {800, 500};
        style.dpi = 100.0;
    }
    MapPictureStyle style;
    DebrisMap map = fieldMap(analysis_scene::randomField(2, 300, 10.0), true);
};

TEST_F(MapPicture, AMapThatLiesAcrossHasTheWidthOfANarrowPicture) {
    DebrisMap across = map;
    // Eight times as long as wide.
    for (MapCell& cell : across.cells) {
        cell.i *= 8;
    }
    const auto columnsDrawn = [&](const DebrisMap& drawn, int width) {
        style.pixels = {width, 620};
        const QImage picture = mapPicture(drawn, MapLayer::Height, style);
        const QColor full = picture.pixelColor(1, 1);
        int low = picture.width(), high = 0;
        // The frame of the map is the longest line across.
        for (int y = 0; y < picture.height(); ++y) {
            int first = -1, last = -1;
            int count = 0;
            for (int x = 0; x < picture.width(); ++x) {
                if (picture.pixelColor(x, y) != full) {
                    first = first < 0 ? x : first;
                    last = x;
                    ++count;
                }
            }
            if (count > 0.9 * (last - first) && last - first > high - low) {
                low = first;
                high = last;
            }
        }
        return high - low;
    };
    EXPECT_GT(columnsDrawn(across, 430), 0.7 * 430) << "its legend stands below";
}

TEST_F(MapPicture, NothingCoversAnotherInTheLegendOfALowPicture) {
    for (const int height : {170, 200, 240}) {
        style.pixels = {480, height};
        const QImage picture = mapPicture(map, MapLayer::Height, style);
        int live = 0, scale = 0;
        for (int y = 0; y < height; ++y) {
            int run = 0;
            for (int x = 292; x < 480; ++x) {
                const QColor c = picture.pixelColor(x, y);
                live = c == palette(render::Theme::Print).released ? y : live;
                run = c.lightness() < 90 && c.hslSaturation() < 60 ? run + 1 : 0;
                scale = run > 14 ? y : scale;
            }
        }
        ASSERT_GT(live, 0) << height;
        EXPECT_GT(scale, live + 12) << height << ": the scale bar with its length stands below all entries";
    }
}

TEST_F(MapPicture, EveryLayerIsDrawnOnWhite) {
    std::set<QByteArray> pictures;
    for (const MapLayer layer : map.present()) {
        const QImage picture = mapPicture(map, layer, style);
        EXPECT_EQ(picture.size(), style.pixels);
        EXPECT_GT(pixelsOf(picture, Qt::white), 100000u);
        EXPECT_TRUE(pictures.insert(QByteArray(reinterpret_cast<const char*>(picture.constBits()), picture.sizeInBytes())).second)
            << mapLayerRow(layer).key << " looks like another layer";
    }
    EXPECT_EQ(pictures.size(), 11u);
}

TEST_F(MapPicture, APictureIsFittedToItsMapAndSaysWhatItIsOf) {
    const QImage plain = mapPicture(map, MapLayer::Height, style);
    style.subject = "arch.rubble · As computed";
    const QImage named = mapPicture(map, MapLayer::Height, style);
    EXPECT_EQ(named.size(), plain.size());
    const auto inked = [](const QImage& image, int rows) {
        std::size_t count = 0;
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < image.width(); ++x) {
                count += image.pixelColor(x, y).lightness() < 128 ? 1 : 0;
            }
        }
        return count;
    };
    EXPECT_EQ(inked(plain, 14), 0u);
    EXPECT_GT(inked(named, 30), 200u) << "case, scenario and sums stand above the map";

    DebrisMap across = map;
    for (MapCell& cell : across.cells) {
        cell.i *= 8;
    }
    style.fitted = true;
    const QImage low = mapPicture(across, MapLayer::Height, style);
    EXPECT_EQ(low.width(), style.pixels.width());
    EXPECT_LT(low.height(), style.pixels.height()) << "no empty room above and below a map that lies across";
    DebrisMap along = map;
    for (MapCell& cell : along.cells) {
        cell.j *= 8;
    }
    style.pixels = {1600, 500};
    const QImage narrow = mapPicture(along, MapLayer::Height, style);
    EXPECT_LT(narrow.width(), 1600);
    EXPECT_EQ(narrow.height(), 500);
}

TEST_F(MapPicture, ItsHeadIsReadWholeInANarrowPicture) {
    const MapHead head{QStringLiteral("river-arch · case.rubble · default"),
                       QString(QStringLiteral("1,234 fragments of 567 t; ")).repeated(8).trimmed()};
    const QRectF box(3.0, 5.0, 400.0, head.height(400.0, 12.0));
    EXPECT_GT(box.height(), 1.5 * head.height(4000.0, 12.0)) << "it takes the lines that it needs";
    const MapHead none{QString(), head.sums};
    EXPECT_EQ(none.height(400.0, 12.0), 0.0);
    // The end of the last line: letters stand there, and none outside of the box.
    const auto drawn = [&](const MapHead& what) {
        QImage image(420, 200, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        what.paint(painter, box, 12.0, Qt::black);
        return image;
    };
    EXPECT_EQ(pixelsOf(drawn(none), Qt::white), 420U * 200U) << "without a subject there is no head";
    const QImage whole = drawn(head);
    MapHead longer = head;
    longer.sums += u'X';
    EXPECT_NE(drawn(longer), whole) << "the last letter is drawn";
    for (int y = 0; y < whole.height(); ++y) {
        for (int x = 0; x < whole.width(); ++x) {
            ASSERT_TRUE(box.adjusted(-1, -1, 1, 1).contains(x, y) || whole.pixelColor(x, y) == QColor(Qt::white)) << x << ' ' << y;
        }
    }
}

TEST_F(MapPicture, ASystemWithoutAPlaceOfTheModelIsNotClaimed) {
    const QImage local = mapPicture(map, MapLayer::Mass, style);
    style.system = "EPSG:25832";
    EXPECT_EQ(mapPicture(map, MapLayer::Mass, style), local) << "no north, no name of the system";
    style.place.shift = {500.0, 700.0};
    const QImage placed = mapPicture(map, MapLayer::Mass, style);
    EXPECT_NE(placed, local);
    style.system.clear();
    EXPECT_NE(mapPicture(map, MapLayer::Mass, style), placed) << "without a system y is not north";
}

TEST_F(MapPicture, AnEmptyLayerHasNoScale) {
    DebrisMap empty = map;
    for (double& value : empty.layers[static_cast<std::size_t>(MapLayer::Arrival)]) {
        value = std::numeric_limits<double>::quiet_NaN();
    }
    const QImage picture = mapPicture(empty, MapLayer::Arrival, style);
    const QImage full = mapPicture(map, MapLayer::Arrival, style);
    // The ramp is the only thing there with more than a few colours.
    const auto coloursOfLegend = [&](const QImage& drawn) {
        std::set<QRgb> colours;
        for (int y = 0; y < drawn.height(); ++y) {
            for (int x = 3 * drawn.width() / 4; x < drawn.width(); ++x) {
                const QColor colour = drawn.pixelColor(x, y);
                if (colour.hslSaturation() > 60) {
                    colours.insert(colour.rgb());
                }
            }
        }
        return colours.size();
    };
    EXPECT_GT(coloursOfLegend(full), 30U);
    EXPECT_LT(coloursOfLegend(picture), 5U);
    // The same map with nothing said in its middle.
    EXPECT_NE(picture.copy(0, 0, 500, 400), mapPicture(empty, MapLayer::ImpactEnergy, style).copy(0, 0, 500, 400));
}

TEST_F(MapPicture, AnEnsembleHasPicturesOfItsProbabilities) {
    DebrisMap ensemble;
    ensemble.cell = 0.5;
    ensemble.members = 8;
    ensemble.hypotheses = {"west", "pier"};
    for (std::int32_t k = 0; k < 400; ++k) {
        ensemble.cells.push_back({k / 20, k % 20});
    }
    const auto fill = [&](MapLayer layer, double low, double high) {
        for (std::size_t c = 0; c < ensemble.cells.size(); ++c) {
            ensemble.layers[static_cast<std::size_t>(layer)].push_back(low + (high - low) * static_cast<double>(c) / 399.0);
        }
    };
    fill(MapLayer::Separation, -3.0, 3.0);
    EXPECT_EQ(ensemble.present(), std::vector<MapLayer>{MapLayer::Separation});
    const QImage separation = mapPicture(ensemble, MapLayer::Separation, style);
    // Blue for the first, vermilion for the second, in the map and beside their names.
    EXPECT_GT(pixelsOf(separation, QColor(0x00, 0x72, 0xb2)), 100u);
    EXPECT_GT(pixelsOf(separation, QColor(0xd5, 0x5e, 0x00)), 100u);
    ensemble.hypotheses.clear();
    fill(MapLayer::Probability, 0.0, 0.5);
    const QImage half = mapPicture(ensemble, MapLayer::Probability, style);
    fill(MapLayer::AboveFirst, 0.0, 1.0);
    EXPECT_NE(half, mapPicture(ensemble, MapLayer::AboveFirst, style)) << "colours of probabilities always end at 1";
    EXPECT_THROW(mapPicture(ensemble, MapLayer::Mass, style), UsageError);
}

TEST_F(MapPicture, ComponentsAreToldApartByColour) {
    // Twelve components, more than the palette has hues; each covers a strip of its own.
    DebrisMap strips;
    strips.cell = 1.0;
    for (std::int32_t k = 0; k < 12; ++k) {
        strips.components.push_back("component " + std::to_string(k));
        for (std::int32_t j = 0; j < 20; ++j) {
            strips.cells.push_back({j, k});
        }
    }
    std::sort(strips.cells.begin(), strips.cells.end());
    for (const MapCell& cell : strips.cells) {
        strips.layers[static_cast<std::size_t>(MapLayer::Component)].push_back(cell.i);
        strips.layers[static_cast<std::size_t>(MapLayer::Mass)].push_back(1.0);
    }
    style.pixels = {800, 800};
    const auto loud = [](const QImage& image) {
        std::map<QRgb, int> counts;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                ++counts[image.pixel(x, y)];
            }
        }
        return std::count_if(counts.begin(), counts.end(), [](const auto& each) { return each.second > 2000; });
    };
    EXPECT_EQ(loud(mapPicture(strips, MapLayer::Component, style)), 13) << "and the paper";
    // Where the legend has no room for all, the rest is of one grey.
    style.pixels = {800, 330};
    const QImage low = mapPicture(strips, MapLayer::Component, style);
    EXPECT_GT(pixelsOf(low, palette(render::Theme::Print).muted), 1000u);
}

TEST_F(MapPicture, LiveStructureIsThereOnlyWhenSwitchedOn) {
    const QColor colour = palette(render::Theme::Print).released;
    EXPECT_GT(pixelsOf(mapPicture(map, MapLayer::Mass, style), colour), 100u);
    EXPECT_EQ(pixelsOf(mapPicture(fieldMap(analysis_scene::randomField(2, 300, 10.0), false), MapLayer::Mass, style), colour), 0u);
}

TEST_F(MapPicture, TheSameMapGivesTheSamePicture) {
    EXPECT_EQ(mapPicture(map, MapLayer::Height, style), mapPicture(map, MapLayer::Height, style));
}

TEST_F(MapPicture, ABlockFarAwayDoesNotShrinkTheRest) {
    Debris far = analysis_scene::randomField(2, 3000, 10.0);
    const QImage without = mapPicture(fieldMap(far, false), MapLayer::Mass, style);
    far.fragments.push_back(analysis_scene::boxAt(Vec3(900.0, 0.0, 0.5), 1.0));
    const QImage with = mapPicture(fieldMap(far, false), MapLayer::Mass, style);
    // As much of the sheet stays white, to a few per cent.
    const auto white = [](const QImage& image) { return static_cast<double>(pixelsOf(image, Qt::white)); };
    EXPECT_LT(std::abs(white(with) - white(without)), 0.1 * white(without));
}

TEST_F(MapPicture, AnEmptyMapSaysSo) {
    const DebrisMap empty = makeDebrisMap(0.0, {}, true, nullptr, {}, SiteSurface{}, {}, Execution());
    const QImage picture = mapPicture(empty, MapLayer::Mass, style);
    EXPECT_LT(pixelsOf(picture, Qt::white), static_cast<std::size_t>(picture.width() * picture.height()));
}

TEST_F(MapPicture, RefusesSizesAndLayersThatItCannotDraw) {
    style.pixels = {50, 50};
    EXPECT_THROW(mapPicture(map, MapLayer::Mass, style), UsageError);
    style.pixels = {800, 500};
    EXPECT_THROW(mapPicture(fieldMap(analysis_scene::randomField(2, 30, 10.0), false), MapLayer::LiveMass, style), UsageError);
}

}  // namespace
}  // namespace rubble::figures
