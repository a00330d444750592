#include "io/site/input_files.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/case/input_check.h"
#include "io/case/terrain_reader.h"
#include "io/site/raster_file.h"
#include "io/site/survey_file.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

constexpr std::string_view statistics =
    "<PAMDataset><Metadata domain=\"Esri\"><MDI key=\"PyramidResamplingType\">NEAREST</MDI></Metadata><PAMRasterBand band=\"1\">"
    "<Histograms><HistItem><HistMin>0</HistMin></HistItem></Histograms><Metadata><MDI key=\"STATISTICS_MAXIMUM\">3</MDI>"
    "<MDI key=\"STATISTICS_APPROXIMATE\">YES</MDI></Metadata></PAMRasterBand></PAMDataset>";

class InputFiles : public testing::Test {
protected:
    TemporaryFolder folder;

    void write(const std::string& name, std::string_view text) const { std::ofstream(folder / name, std::ios::binary) << text; }
    std::vector<std::string> names(const std::string& name, InputRole role = InputRole::Terrain, bool all = false) const {
        std::vector<std::string> list;
        for (const std::string& file : all ? filesWithInput(folder / name, role) : filesOfInput(folder / name, role)) {
            list.push_back(fs::path(file).lexically_relative(folder.path()).generic_string());
        }
        return list;
    }
    /// A level raster of 4 by 4 pixels without a place of its own.
    void writePicture(const std::string& name, int pixels, double value) const {
        GDALAllRegister();
        GDALDatasetUniquePtr file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create((folder / name).c_str(), pixels, pixels,
                                                                                           1, GDT_Float64, nullptr));
        const std::vector<double> values(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels), value);
        ASSERT_EQ(file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, pixels, pixels, const_cast<double*>(values.data()), pixels,
                                                   pixels, GDT_Float64, 0, 0, nullptr),
                  CE_None);
    }
    void writePlace(const std::string& name, double east) const { write(name, "1\n0\n0\n-1\n" + std::to_string(east) + "\n1.5\n"); }
};

TEST_F(InputFiles, AreThoseThatCanChangeWhatIsRead) {
    for (const char* name : {"ground.tif", "ground.tfw", "ground.TIFW", "ground.prj", "ground.tif.msk", "ground.tif.ovr",
                             "ground.aux", "ground.shp", "ground.shx", "ground.dbf", "ground.cpg", "ground.geojson", "ground.csvt",
                             "ground.csv", "ground.las", "ground.mtl", "ground.obj", "groundwork.tfw"}) {
        write(name, "1");
    }
    EXPECT_THAT(names("ground.tif"), ElementsAre("ground.tif", "ground.TIFW", "ground.prj", "ground.tfw", "ground.tif.msk"));
    EXPECT_THAT(names("ground.shp", InputRole::Survey),
                ElementsAre("ground.shp", "ground.cpg", "ground.dbf", "ground.prj", "ground.shx"));
    EXPECT_THAT(names("ground.obj", InputRole::Surroundings), ElementsAre("ground.obj", "ground.mtl"));
    for (const char* alone : {"ground.geojson", "ground.csv", "ground.las"}) {
        EXPECT_THAT(names(alone, InputRole::Survey), ElementsAre(alone));
    }
    EXPECT_THAT(names("ground.tif", InputRole::Photograph), ElementsAre("ground.tif"));
    write("ground.aux", "EHFA_HEADER_TAG and more");
    EXPECT_THAT(names("ground.tif"), testing::Contains("ground.aux"));
    // Pyramids travel all the same; tables of another program do not travel with a raster.
    EXPECT_THAT(names("ground.tif", InputRole::Terrain, true), testing::Contains("ground.tif.ovr"));
    EXPECT_THAT(names("ground.tif", InputRole::Terrain, true), testing::Not(testing::Contains("ground.csvt")));
    EXPECT_THAT(names("ground.csv", InputRole::Survey, true), testing::Contains("ground.csvt"));
}

TEST_F(InputFiles, NotesCountByWhatTheySay) {
    write("ground.tif", "1");
    const auto counts = [&](std::string_view notes) {
        write("ground.tif.aux.xml", notes);
        return names("ground.tif").size() == 2;
    };
    EXPECT_FALSE(counts(statistics));
    EXPECT_EQ(names("ground.tif", InputRole::Terrain, true).size(), 2u);
    EXPECT_FALSE(counts("<PAMDataset/>"));
    for (const char* inBand : {"<NoDataValue>0</NoDataValue>", "<UnitType>ft</UnitType>", "<Scale>2</Scale>", "<Offset>1</Offset>",
                               "<ColorInterp>Alpha</ColorInterp>", "<Description>height_m</Description>"}) {
        EXPECT_TRUE(counts(std::string("<PAMDataset><PAMRasterBand band=\"1\">") + inBand + "</PAMRasterBand></PAMDataset>"))
            << inBand;
    }
    for (const char* inAll : {"<SRS>EPSG:32633</SRS>", "<GeoTransform>0,1,0,4,0,-1</GeoTransform>",
                              "<Metadata><MDI key=\"AREA_OR_POINT\">Point</MDI></Metadata>",
                              "<Metadata domain=\"xml:ESRI\" format=\"xml\"><GeodataXform/></Metadata>"}) {
        EXPECT_TRUE(counts(std::string("<PAMDataset>") + inAll + "</PAMDataset>")) << inAll;
    }
    EXPECT_TRUE(counts("<PAMDataset><cut")) << "what cannot be read may say anything";
}

TEST_F(InputFiles, TheDigestIsThatOfTheListAsSha256SumPrintsIt) {
    writePicture("ground.tif", 4, 1.0);
    const Execution execution;
    const std::string file = sha256OfFile(folder / "ground.tif");
    EXPECT_EQ(digestOfInput(folder / "ground.tif", InputRole::Terrain, execution).sha256, file);
    writePlace("ground.tfw", 0.5);
    const InputDigest digest = digestOfInput(folder / "ground.tif", InputRole::Terrain, execution);
    EXPECT_EQ(digest.sha256, sha256OfText(file + "  ground.tif\n" + sha256OfFile(folder / "ground.tfw") + "  ground.tfw\n"));
    EXPECT_EQ(digest.fileSha256, file);
    EXPECT_TRUE(digest.is(file));
    EXPECT_EQ(digest.against(file), file);
    EXPECT_EQ(digest.against("of another"), digest.sha256);
    // It does not depend on where the files lie.
    fs::create_directory(folder / "elsewhere");
    for (const char* name : {"ground.tif", "ground.tfw"}) {
        fs::copy_file(folder / name, folder / (std::string("elsewhere/") + name));
    }
    EXPECT_EQ(digestOfInput(folder / "elsewhere/ground.tif", InputRole::Terrain, execution).sha256, digest.sha256);
}

TEST_F(InputFiles, AMeshIsReadWithItsBuffersAndItsOffset) {
    fs::create_directories(folder / "model/parts");
    write("model/roof.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"uri":"parts/roof%20points.bin","byteLength":60},)"
                             R"({"uri":"data:application/octet-stream;base64,AAAA","byteLength":3}]})");
    EXPECT_THAT(names("model/roof.gltf", InputRole::Surroundings), ElementsAre("model/roof.gltf")) << "the other is not there";
    write("model/parts/roof points.bin", "1");
    write("model/offset.txt", "400000 5300000 100");
    EXPECT_THAT(names("model/roof.gltf", InputRole::Surroundings),
                ElementsAre("model/roof.gltf", "model/offset.txt", "model/parts/roof points.bin"));
    write("model/roof.gltf", "{ cut");
    EXPECT_THAT(names("model/roof.gltf", InputRole::Surroundings), ElementsAre("model/roof.gltf", "model/offset.txt"));
}

TEST_F(InputFiles, AChangeBesideAnInputIsFound) {
    for (const char* name : {"ground.tif", "ground.tfw", "ground.prj", "outline.shp", "outline.dbf", "roof.obj", "roof.mtl"}) {
        write(name, "1");
    }
    const std::string casePath = folder / "case.rubble";
    Case theCase;
    theCase.inputs.push_back({"terrain-1", InputRole::Terrain, "ground.tif", {}});
    theCase.inputs.push_back({"survey-1", InputRole::Survey, "outline.shp", {}});
    theCase.inputs.push_back({"surroundings-1", InputRole::Surroundings, "roof.obj", {}});
    theCase = saveCase(casePath, theCase);
    const auto changed = [&] {
        std::vector<std::string> ids;
        for (const CaseInput& input : theCase.inputs) {
            if (findInput(casePath, input, {}, Execution()).sha256 != input.sha256) {
                ids.push_back(input.id);
            }
        }
        return ids;
    };
    EXPECT_THAT(changed(), ElementsAre());
    write("ground.tif.ovr", "pyramids");
    write("ground.tif.aux.xml", statistics);
    EXPECT_THAT(changed(), ElementsAre()) << "a program looked at it";
    for (const auto& [name, id] : {std::pair("ground.tfw", "terrain-1"), std::pair("ground.prj", "terrain-1"),
                                   std::pair("outline.dbf", "survey-1"), std::pair("roof.mtl", "surroundings-1")}) {
        write(name, "2");
        EXPECT_THAT(changed(), ElementsAre(id)) << name;
        fs::remove(folder / name);
        EXPECT_THAT(changed(), ElementsAre(id)) << name;
        write(name, "1");
        EXPECT_THAT(changed(), ElementsAre()) << name;
    }
    write("ground.tif.aux.xml", "<PAMDataset><PAMRasterBand band=\"1\"><NoDataValue>1</NoDataValue></PAMRasterBand></PAMDataset>");
    EXPECT_THAT(changed(), ElementsAre("terrain-1"));

    // A case of before has the digest of the file alone.
    for (CaseInput& input : theCase.inputs) {
        input.sha256 = sha256OfFile(inputPath(casePath, input));
    }
    EXPECT_THAT(changed(), ElementsAre());
    const CaseInput& terrain = theCase.inputs.front();
    const InputDigest known = digestOfInput(folder / "ground.tif", InputRole::Terrain, Execution());
    EXPECT_EQ(findInput(casePath, terrain, known, Execution()).sha256, terrain.sha256) << "as it is known by whoever read it";
    write("ground.tif", "2");
    EXPECT_THAT(changed(), ElementsAre("terrain-1"));
}

TEST_F(InputFiles, OpeningTellsATerrainWhosePlaceHasChanged) {
    writePicture("ground.tif", 4, 1.0);
    writePlace("ground.tfw", 0.5);
    const std::string casePath = folder / "case.rubble";
    Case theCase;
    theCase.inputs.push_back({"terrain-1", InputRole::Terrain, "ground.tif", {}});
    theCase = saveCase(casePath, theCase);
    const auto told = [&] {
        return openTerrainOfCase(theCase, casePath, Mesh(), Execution()).findings.count("case.terrain_changed");
    };
    EXPECT_EQ(told(), 0);
    writePlace("ground.tfw", 10.5);
    EXPECT_EQ(told(), 1);
    theCase.inputs.front().sha256 = sha256OfFile(folder / "ground.tif");
    EXPECT_EQ(told(), 0) << "a case of before says nothing of it";
    const TerrainInput terrain = openTerrainOfCase(theCase, casePath, Mesh(), Execution());
    EXPECT_EQ(terrain.sha256, digestOfInput(folder / "ground.tif", InputRole::Terrain, Execution()).sha256)
        << "for the run's origin";
}

TEST_F(InputFiles, AnOutlineIsKnownByItsTableToo) {
    GDALAllRegister();
    {
        GDALDatasetUniquePtr file(GetGDALDriverManager()
                                      ->GetDriverByName("ESRI Shapefile")
                                      ->Create((folder / "outline.shp").c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        OGRLayer* layer = file->CreateLayer("outline", nullptr, wkbPolygon, nullptr);
        OGRLinearRing ring;
        for (const auto& [x, y] : {std::pair(0, 0), std::pair(4, 0), std::pair(4, 4), std::pair(0, 0)}) {
            ring.addPoint(x, y);
        }
        OGRPolygon polygon;
        polygon.addRing(&ring);
        OGRFeature feature(layer->GetLayerDefn());
        feature.SetGeometry(&polygon);
        ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    }
    const auto read = [&] { return readSurvey(folder / "outline.shp", Frame(), Site(), Aabb(), Execution()); };
    const SurveyInput before = read();
    EXPECT_EQ(before.fileSha256, sha256OfFile(folder / "outline.shp"));
    std::ofstream(folder / "outline.dbf", std::ios::app) << ' ';
    EXPECT_NE(read().sha256, before.sha256);
    EXPECT_EQ(read().fileSha256, before.fileSha256);
}

TEST_F(InputFiles, PyramidsAndStatisticsChangeNoHeight) {
    writePicture("ground.tif", 4, 1.0);
    writePlace("ground.tfw", 0.5);
    writePicture("ground.tif.ovr", 2, 7.0);
    write("ground.tif.aux.xml", statistics);
    const RasterFile file(folder / "ground.tif");
    EXPECT_THAT(file.values({0, 0, 4, 4, 2}, Execution()), ElementsAre(1.0, 1.0, 1.0, 1.0));
    EXPECT_EQ(file.place().x0, 0.5) << "its world file is seen";
}

TEST_F(InputFiles, PyramidsWithinAFileChangeNoHeight) {
    writePicture("ground.tif", 8, 1.0);
    const std::string path = folder / "ground.tif";
    {
        GDALDatasetUniquePtr file(GDALDataset::FromHandle(GDALOpen(path.c_str(), GA_Update)));
        ASSERT_TRUE(file);
        std::array<int, 1> levels{2};
        ASSERT_EQ(file->BuildOverviews("NEAREST", 1, levels.data(), 0, nullptr, nullptr, nullptr), CE_None);
        GDALRasterBand* const pyramid = file->GetRasterBand(1)->GetOverview(0);
        ASSERT_NE(pyramid, nullptr);
        ASSERT_EQ(pyramid->Fill(7.0), CE_None);
    }
    ASSERT_FALSE(fs::exists(path + ".ovr"));
    writePlace("ground.tfw", 0.5);
    const RasterFile file(path);
    EXPECT_THAT(file.values({0, 0, 8, 8, 2}, Execution()), testing::Each(1.0));
    EXPECT_THAT(file.values({0, 0, 8, 8, 4}, Execution()), testing::Each(1.0));
}

TEST_F(InputFiles, BesidePyramidsARasterSaysTheSame) {
    GDALAllRegister();
    const std::string path = folder / "ground.tif";
    {
        GDALDatasetUniquePtr file(
            GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), 4, 4, 2, GDT_Float64, nullptr));
        std::array<double, 6> place{500000.0, 2.0, 0.0, 5300000.0, 0.0, -2.0};
        file->SetGeoTransform(place.data());
        OGRSpatialReference system;
        system.SetFromUserInput("EPSG:32633+5773");
        file->SetSpatialRef(&system);
        file->SetMetadataItem("RUBBLE_CLASS", "test");
        for (int b = 1; b <= 2; ++b) {
            GDALRasterBand* band = file->GetRasterBand(b);
            band->SetNoDataValue(-9999.0);
            band->SetScale(2.0);
            band->SetOffset(1.0);
            band->SetUnitType("ft");
            band->SetDescription(b == 1 ? "low" : "high");
            std::vector<double> values{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, -9999.0};
            ASSERT_EQ(band->RasterIO(GF_Write, 0, 0, 4, 4, values.data(), 4, 4, GDT_Float64, 0, 0, nullptr), CE_None);
        }
    }
    const auto said = [&] {
        RasterFile file(path);
        std::ostringstream text;
        text << std::setprecision(17) << file.crsName() << file.verticalDatum() << file.heightUnit() << file.metresPerHeightUnit()
             << ' ' << file.place().x0 << ' ' << file.place().y0 << ' ' << file.place().dx << ' ' << file.place().dy << ' '
             << file.bands() << file.entry("RUBBLE_CLASS") << file.bandNames().at(1);
        for (const std::size_t factor : {1, 2}) {
            for (const double value : file.values({0, 0, 4, 4, factor}, Execution())) {
                text << ' ' << value;
            }
        }
        return text.str();
    };
    const std::string before = said();
    EXPECT_THAT(before, testing::HasSubstr("nan"));
    writePicture("ground.tif.ovr", 2, 7.0);
    EXPECT_EQ(said(), before);
}

TEST_F(InputFiles, NotesThatSayMoreAreRead) {
    writePicture("ground.tif", 4, 1.0);
    write("ground.tif.aux.xml",
          "<PAMDataset><GeoTransform>30,1,0,4,0,-1</GeoTransform><PAMRasterBand band=\"1\"><Scale>2</Scale>"
          "</PAMRasterBand></PAMDataset>");
    const RasterFile file(folder / "ground.tif");
    EXPECT_EQ(file.place().x0, 30.5);
    EXPECT_THAT(file.values({0, 0, 1, 1, 1}, Execution()), ElementsAre(2.0));
}

}  // namespace
}  // namespace rubble::io
