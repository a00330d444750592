#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <fstream>
#include <functional>
#include <optional>

#include "io/site/orthophoto_file.h"
#include "tests/support/error_id.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// A picture of four by four pixels of a metre, each of one colour.
class Picture : public testing::Test {
protected:
    struct Band {
        double value = 0.0;
        GDALColorInterp meaning = GCI_Undefined;
        std::string name = {};
    };
    TemporaryFolder folder;
    std::string path = folder / "picture.tif";
    Findings findings;
    const char* bits = nullptr;
    const char* interpretation = "PHOTOMETRIC=MINISBLACK";
    std::optional<double> nothing;  ///< mark for no data
    int columns = 4;
    int rows = 4;
    std::function<void(GDALDataset&)> finish;  ///< changes to the file before it is closed

    void write(GDALDataType type, const std::vector<Band>& bands) const {
        GDALAllRegister();
        const char* options[] = {interpretation, bits, nullptr};
        GDALDatasetUniquePtr file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
            path.c_str(), columns, rows, static_cast<int>(bands.size()), type, const_cast<char**>(options)));
        std::array<double, 6> place{0.0, 1.0, 0.0, static_cast<double>(rows), 0.0, -1.0};
        file->SetGeoTransform(place.data());
        for (std::size_t b = 0; b < bands.size(); ++b) {
            GDALRasterBand* band = file->GetRasterBand(static_cast<int>(b) + 1);
            if (bands[b].meaning != GCI_Undefined) {
                band->SetColorInterpretation(bands[b].meaning);
            }
            band->SetDescription(bands[b].name.c_str());
            if (nothing) {
                band->SetNoDataValue(*nothing);
            }
            fill(*band, [&](int, int) { return bands[b].value; });
        }
        if (finish) {
            finish(*file);
        }
    }
    /// Writes a band, or a pyramid of it. @param value  of a column and row
    static void fill(GDALRasterBand& band, const std::function<double(int, int)>& value) {
        const int wide = band.GetXSize();
        const int high = band.GetYSize();
        std::vector<double> values;
        for (int k = 0; k < wide * high; ++k) {
            values.push_back(value(k % wide, k / wide));
        }
        ASSERT_EQ(band.RasterIO(GF_Write, 0, 0, wide, high, values.data(), wide, high, GDT_Float64, 0, 0, nullptr), CE_None);
    }
    /// Gives a file pyramids that hold other values.
    static void addOtherPyramids(GDALDataset& file, double value) {
        std::array<int, 1> levels{2};
        ASSERT_EQ(file.BuildOverviews("NEAREST", 1, levels.data(), 0, nullptr, nullptr, nullptr), CE_None);
        for (int b = 1; b <= file.GetRasterCount(); ++b) {
            ASSERT_EQ(file.GetRasterBand(b)->GetOverviewCount(), 1);
            fill(*file.GetRasterBand(b)->GetOverview(0), [value](int, int) { return value; });
        }
    }
    /// Colour and opacity of the pixel in the middle.
    std::array<int, 4> read() {
        findings = Findings();
        const auto picture = readOrthophoto(path, Frame(), Site(), Aabb(), Execution(), findings);
        const std::uint8_t* at = &picture->rgba[4 * static_cast<std::size_t>(2 * picture->width + 2)];
        return {at[0], at[1], at[2], at[3]};
    }
    using Colour = std::array<int, 4>;
};

TEST_F(Picture, SixteenBitsAreTheUpperByte) {
    const std::vector<Band> bands{
        {200 * 256.0, GCI_RedBand, {}}, {100 * 256.0, GCI_GreenBand, {}}, {50 * 256.0 + 255, GCI_BlueBand, {}}};
    write(GDT_UInt16, bands);
    EXPECT_EQ(read(), (Colour{200, 100, 50, 255}));
    EXPECT_EQ(findings.count("orthophoto.depth_assumed"), 1);
    bits = "NBITS=12";
    write(GDT_UInt16, {{4095, GCI_RedBand, {}}, {2048, GCI_GreenBand, {}}, {16, GCI_BlueBand, {}}});
    EXPECT_EQ(read(), (Colour{255, 128, 1, 255}));
    EXPECT_EQ(findings.count("orthophoto.depth"), 1);
    bits = nullptr;
    write(GDT_UInt16, {{4000, GCI_RedBand, {}}, {2048, GCI_GreenBand, {}}, {16, GCI_BlueBand, {}}});
    EXPECT_EQ(read(), (Colour{250, 128, 1, 255})) << "12 bits that do not say so";
    write(GDT_UInt16, {{250, GCI_RedBand, {}}, {128, GCI_GreenBand, {}}, {1, GCI_BlueBand, {}}});
    EXPECT_EQ(read(), (Colour{250, 128, 1, 255})) << "bytes in wider numbers";
    nothing = 65535;
    finish = [](GDALDataset& file) {
        std::vector<double> none(4, 65535.0);
        for (int b = 1; b <= 3; ++b) {
            ASSERT_EQ(file.GetRasterBand(b)->RasterIO(GF_Write, 0, 0, 4, 1, none.data(), 4, 1, GDT_Float64, 0, 0, nullptr),
                      CE_None);
        }
    };
    write(GDT_UInt16, {{4000, GCI_RedBand, {}}, {2048, GCI_GreenBand, {}}, {16, GCI_BlueBand, {}}});
    EXPECT_EQ(read(), (Colour{250, 128, 1, 255})) << "the mark for no data is no colour";
}

TEST_F(Picture, BandsAreTakenByWhatTheyMean) {
    write(GDT_Byte, {{10, GCI_BlueBand, {}}, {20, GCI_GreenBand, {}}, {30, GCI_RedBand, {}}});
    EXPECT_EQ(read(), (Colour{30, 20, 10, 255}));
    EXPECT_TRUE(findings.empty());
    write(GDT_Byte,
          {{10, GCI_Undefined, "Blue"}, {20, GCI_Undefined, "Green"}, {30, GCI_Undefined, "Red"}, {40, GCI_Undefined, "nir"}});
    EXPECT_EQ(read(), (Colour{30, 20, 10, 255})) << "by their names";
    write(GDT_Byte, {{10}, {20}, {30}, {40}});
    EXPECT_EQ(read(), (Colour{10, 20, 30, 255}));
    EXPECT_EQ(findings.count("orthophoto.bands_assumed"), 1);
    write(GDT_Byte, {{77}});
    EXPECT_EQ(read(), (Colour{77, 77, 77, 255}));
    EXPECT_TRUE(findings.empty());
    write(GDT_UInt16, {{77 * 256.0}});
    EXPECT_EQ(read(), (Colour{77, 77, 77, 255}));
    interpretation = "PHOTOMETRIC=RGB";
    write(GDT_Byte, {{10, GCI_RedBand, {}}, {20, GCI_GreenBand, {}}, {30, GCI_BlueBand, {}}, {40}, {128, GCI_AlphaBand, {}}});
    EXPECT_EQ(read(), (Colour{10, 20, 30, 128})) << "an opacity behind more than colours";
    write(GDT_UInt16, {{2560, GCI_RedBand, {}}, {5120, GCI_GreenBand, {}}, {65280, GCI_BlueBand, {}}, {32896, GCI_AlphaBand, {}}});
    EXPECT_EQ(read(), (Colour{10, 20, 255, 128}));
}

TEST_F(Picture, APaletteIsLookedUpAndNothingIsTransparent) {
    finish = [](GDALDataset& file) {
        GDALColorTable palette;
        const GDALColorEntry red{200, 30, 20, 255};
        palette.SetColorEntry(5, &red);
        file.GetRasterBand(1)->SetColorTable(&palette);
    };
    interpretation = nullptr;
    write(GDT_Byte, {{5}});
    EXPECT_EQ(read(), (Colour{200, 30, 20, 255}));
    finish = nullptr;
    nothing = 0;
    write(GDT_Byte, {{0, GCI_RedBand, {}}, {255, GCI_GreenBand, {}}, {0, GCI_BlueBand, {}}});
    EXPECT_EQ(read(), (Colour{0, 255, 0, 255})) << "pure green is a colour, although two of its bands are none";
    write(GDT_Byte, {{0, GCI_RedBand, {}}, {0, GCI_GreenBand, {}}, {0, GCI_BlueBand, {}}});
    EXPECT_EQ(read()[3], 0);
}

TEST_F(Picture, PyramidsChangeNoColour) {
    columns = 4096;
    rows = 8;
    // Columns of 40 and 120: two put together are 80, whatever the pyramids say.
    const auto stripes = [](GDALDataset& file) {
        for (int b = 1; b <= 3; ++b) {
            fill(*file.GetRasterBand(b), [](int column, int) { return column % 2 == 0 ? 40.0 : 120.0; });
        }
    };
    const std::vector<Band> bands{{0, GCI_RedBand, {}}, {0, GCI_GreenBand, {}}, {0, GCI_BlueBand, {}}};
    finish = [&](GDALDataset& file) {
        stripes(file);
        addOtherPyramids(file, 250.0);
    };
    write(GDT_Byte, bands);
    EXPECT_EQ(read(), (Colour{80, 80, 80, 255})) << "pyramids within";
    ASSERT_EQ(findings.count("orthophoto.reduced"), 1);
    EXPECT_EQ(englishText(findings.list().front().what),
              "4,096 by 8 pixels of 1 m are more than can be drawn: the orthophoto is read as 2,048 by 4 of 2 m");
    finish = stripes;
    write(GDT_Byte, bands);
    {
        GDALDatasetUniquePtr beside(GDALDataset::FromHandle(GDALOpen(path.c_str(), GA_ReadOnly)));
        ASSERT_TRUE(beside);
        std::array<int, 1> levels{2};
        ASSERT_EQ(beside->BuildOverviews("NEAREST", 1, levels.data(), 0, nullptr, nullptr, nullptr), CE_None);
    }
    {
        GDALDatasetUniquePtr pyramids(GDALDataset::FromHandle(GDALOpen((path + ".ovr").c_str(), GA_Update)));
        ASSERT_TRUE(pyramids);
        for (int b = 1; b <= 3; ++b) {
            fill(*pyramids->GetRasterBand(b), [](int, int) { return 250.0; });
        }
    }
    EXPECT_EQ(read(), (Colour{80, 80, 80, 255})) << "pyramids beside";
    columns = rows = 4;
    finish = nullptr;
    write(GDT_Byte, bands);
    read();
    EXPECT_EQ(findings.count("orthophoto.reduced"), 0) << "all its pixels are drawn";
}

TEST_F(Picture, WhatIsHiddenDarkensNoPixelBesideIt) {
    columns = 4096;
    rows = 8;
    nothing = 0;
    finish = [](GDALDataset& file) {
        for (int b = 1; b <= 3; ++b) {
            fill(*file.GetRasterBand(b), [](int column, int) { return column % 2 == 0 ? 0.0 : 120.0; });
        }
    };
    write(GDT_Byte, {{0, GCI_RedBand, {}}, {0, GCI_GreenBand, {}}, {0, GCI_BlueBand, {}}});
    EXPECT_EQ(read(), (Colour{120, 120, 120, 128}));
}

TEST_F(Picture, WhatIsNoColourIsRefusedOrSaid) {
    write(GDT_Float32, {{0.5, GCI_RedBand, {}}, {1.0, GCI_GreenBand, {}}, {0.0, GCI_BlueBand, {}}});
    EXPECT_EQ(read(), (Colour{128, 255, 0, 255}));
    EXPECT_EQ(findings.count("orthophoto.fractions"), 1);
    write(GDT_Float32, {{1e6, GCI_RedBand, {}}, {1.0, GCI_GreenBand, {}}, {0.0, GCI_BlueBand, {}}});
    EXPECT_EQ(idOfError([&] { read(); }), "orthophoto.no_colours");
    write(GDT_Float32, {{120.0}});
    EXPECT_EQ(idOfError([&] { read(); }), "terrain.no_picture") << "heights";
    path = folder / "text.tif";
    std::ofstream(path) << "this is no picture";
    EXPECT_EQ(idOfError([&] { read(); }), "terrain.unknown_picture");
}

TEST_F(Picture, WhereItLiesIsCheckedAndWhatIsCutOffIsSaid) {
    columns = rows = 100;
    write(GDT_Byte, {{77}, {88}});
    Frame frame;
    const auto about = [&](const SiteWindow& window) {
        findings = Findings();
        return readOrthophoto(path, frame, Site(), window, Execution(), findings);
    };
    const auto whole = about(SiteWindow());
    EXPECT_EQ(whole->width, 100);
    EXPECT_EQ(findings.count("orthophoto.second_band"), 1);
    EXPECT_EQ(findings.count("orthophoto.cut"), 0);
    // A wall of 1 m, 4 m long: ten metres to each side.
    const Aabb wall(Vec3(48.0, 49.5, 0.0), Vec3(52.0, 50.5, 1.0));
    const auto near = about(wall);
    EXPECT_NEAR(near->x0, 38.0, 1e-9);
    EXPECT_EQ(near->width, 24);
    EXPECT_EQ(findings.count("orthophoto.cut"), 1);
    EXPECT_EQ(englishText(findings.list().front().what),
              "the orthophoto is read from x = 38 to 62 m, y = 39.5 to 60.5 m, ten heights about the structure; it goes on 39.5 m "
              "beyond, which is cut off");
    const auto far = about({wall, Aabb(Vec3(48.0, 49.0, 0.0), Vec3(80.0, 51.0, 1.0))});
    EXPECT_NEAR(far->x0 + far->width * far->pixel, 82.0, 1e-9) << "as far as debris is known to lie";
    EXPECT_EQ(idOfError([&] { about(Aabb(Vec3(1e4, 0.0, 0.0), Vec3(1.001e4, 1.0, 1.0))); }), "orthophoto.elsewhere");
    finish = [](GDALDataset& file) {
        OGRSpatialReference system;
        system.SetFromUserInput("EPSG:4326");
        file.SetSpatialRef(&system);
    };
    write(GDT_Byte, {{77}});
    EXPECT_EQ(idOfError([&] { about(SiteWindow()); }), "orthophoto.degrees");
}

}  // namespace
}  // namespace rubble::io
