#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/seal/seal_case.h"
#include "io/seal/seal_check.h"
#include "io/seal/unpacked_bundle.h"
#include "tests/io/seal/sealed_small_case.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// A tetrahedron with sides of 1 m along the axes, as binary STL.
void writeTetrahedron(const std::string& path) {
    constexpr float corners[4][3][3] = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                                        {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                                        {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::ofstream out(path, std::ios::binary);
    out << std::string(80, ' ');
    const std::uint32_t count = 4;
    out.write(reinterpret_cast<const char*>(&count), sizeof count);
    for (const auto& triangle : corners) {
        const float normal[3] = {0, 0, 0};
        out.write(reinterpret_cast<const char*>(normal), sizeof normal);
        out.write(reinterpret_cast<const char*>(triangle), sizeof triangle);
        out.write("\0\0", 2);
    }
}

/// Level ground of 80 x 80 m, 1 m below zero, whose header is a file of its own.
void writeGround(const std::string& folder) {
    std::ofstream(folder + "/ground.hdr") << "NROWS 21\nNCOLS 21\nNBANDS 1\nNBITS 32\nPIXELTYPE FLOAT\nBYTEORDER I\nLAYOUT BIL\n"
                                             "ULXMAP -40\nULYMAP 40\nXDIM 4\nYDIM 4\n";
    const std::vector<float> heights(441, -1.0F);
    std::ofstream(folder + "/ground.bil", std::ios::binary)
        .write(reinterpret_cast<const char*>(heights.data()), static_cast<std::streamsize>(heights.size() * sizeof(float)));
}

/// A roof of 4 x 4 m, 0.5 m above the ground, whose numbers are a file of their own; glTF has y up.
void writeRoof(const std::string& folder) {
    const float points[4][3] = {{-2, -0.5F, -2}, {2, -0.5F, -2}, {2, -0.5F, 2}, {-2, -0.5F, 2}};
    const std::uint16_t corners[6] = {0, 2, 1, 0, 3, 2};
    std::ofstream out(folder + "/roof points.bin", std::ios::binary);
    out.write(reinterpret_cast<const char*>(points), sizeof points);
    out.write(reinterpret_cast<const char*>(corners), sizeof corners);
    std::ofstream(folder + "/roof.gltf") << R"({"asset":{"version":"2.0"},"buffers":[{"uri":"roof%20points.bin","byteLength":60}],
               "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],
               "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-2,-0.5,-2],"max":[2,-0.5,2]},
                            {"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],
               "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
               "nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})";
}

/// To seal the case of stones with its run, signed by a new key.
SealRequest requestOf(const TemporaryFolder& folder) {
    SealRequest request;
    request.casePath = folder / "stones.rubble";
    request.runs = {folder / "stones.run.h5"};
    request.signer.key = makeKey(folder / "key.pem");
    return request;
}

TEST(SealedInputs, ATableOfBodiesTravelsWithItsMeshesItsTerrainAndItsSurroundings) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "shapes");
    writeTetrahedron(folder / "shapes/stone.stl");
    std::ofstream(folder / "wedge.obj") << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 0 1 1\n"
                                           "f 1 4 3 2\nf 1 2 5\nf 4 6 3\nf 1 5 6 4\nf 2 3 6 5\n";
    std::ofstream(folder / "bodies.csv") << "id,mass_kg,mesh,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s\n"
                                            "a,400,shapes/stone.stl,0,0,1,0.5,0,0\nb,1200,wedge.obj,6,0,1,0,0,0\n";
    writeGround(folder.path());
    writeRoof(folder.path());
    const std::string casePath = folder / "stones.rubble";
    Case theCase = caseForFe(folder / "bodies.csv", casePath);
    theCase.inputs.push_back({"terrain-1", InputRole::Terrain, "ground.bil", {}});
    theCase.inputs.push_back({"surroundings-1", InputRole::Surroundings, "roof.gltf", {}});
    theCase.site.collide = true;
    theCase.scenarios[0].scenario.simulation.settleTime = 1.0;
    saveCase(casePath, theCase);
    runSmallCase(casePath, folder / "stones.run.h5");

    SealRequest request = requestOf(folder);
    const std::string bundle = folder / "stones.rubblecase";
    const SealReport report = sealCase(bundle, request, Execution());
    ASSERT_EQ(report.statement.inputs.size(), 3u);
    const std::string fe = "data/inputs/" + report.statement.inputs[0].id + "/";
    EXPECT_EQ(report.statement.inputs[0].files.front(), fe + "bodies.csv");
    EXPECT_THAT(report.statement.inputs[0].files,
                UnorderedElementsAre(fe + "bodies.csv", fe + "shapes/stone.stl", fe + "wedge.obj"));
    EXPECT_THAT(report.statement.inputs[1].files,
                UnorderedElementsAre("data/inputs/terrain-1/ground.bil", "data/inputs/terrain-1/ground.hdr"));
    EXPECT_THAT(report.statement.inputs[2].files,
                UnorderedElementsAre("data/inputs/surroundings-1/roof.gltf", "data/inputs/surroundings-1/roof points.bin"));

    // Every file has its digest: one that is altered is named.
    for (const SealedInput& input : report.statement.inputs) {
        for (const std::string& place : input.files) {
            PackedFiles files = packedFiles(bundle);
            contentAt(files, place).back() ^= 1;
            packFiles(folder / "altered.rubblecase", files);
            EXPECT_FALSE(checkBundle(folder / "altered.rubblecase", {}, Execution()).faults.empty()) << place;
        }
    }

    // Where nothing else is, the run comes out the same.
    const SealCheck check = checkBundle(bundle, {}, Execution());
    EXPECT_THAT(check.faults, IsEmpty());
    for (const char* name : {"bodies.csv", "wedge.obj", "ground.bil", "ground.hdr", "roof.gltf", "roof points.bin"}) {
        fs::remove(folder / name);
    }
    fs::remove_all(folder / "shapes");
    const UnpackedBundle unpacked(bundle, check, folder / "opened", Execution());
    const RunRepeat repeat = unpacked.repeat(unpacked.runs().at(0), Execution());
    EXPECT_TRUE(repeat.equal) << englishText(repeat.firstDifference);
    for (const RepeatedFigure& figure : repeat.figures) {
        EXPECT_TRUE(figure.same()) << figure.name << ": " << figure.recorded << " and " << figure.found;
    }
}

TEST(SealedInputs, OneThatStaysHomeIsKnownByTheDigestsOfAllItsFiles) {
    const TemporaryFolder folder;
    writeTetrahedron(folder / "stone.stl");
    std::ofstream(folder / "bodies.csv") << "id,mass_kg,mesh,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s\na,400,stone.stl,0,0,1,0.5,0,0\n";
    writeGround(folder.path());
    const std::string casePath = folder / "stones.rubble";
    Case theCase = caseForFe(folder / "bodies.csv", casePath);
    theCase.inputs.push_back({"terrain-1", InputRole::Terrain, "ground.bil", {}});
    saveCase(casePath, theCase);

    SealRequest request;
    request.casePath = casePath;
    request.leftHome = {"terrain-1"};
    request.signer.key = makeKey(folder / "key.pem");
    const std::string bundle = folder / "stones.rubblecase";
    const SealReport report = sealCase(bundle, request, Execution());
    const Manifest header{{"ground.hdr", sha256OfFile(folder / "ground.hdr")}};
    EXPECT_EQ(report.statement.inputs.at(1).others, header);

    const SealCheck check = checkBundle(bundle, {}, Execution());
    EXPECT_EQ(check.statement.inputs.at(1).others, header);
    UnpackedBundle unpacked(bundle, check, folder / "opened", Execution());
    EXPECT_NO_THROW(unpacked.locate("terrain-1", folder / "ground.bil", Execution()));
    const auto refused = [&] {
        try {
            unpacked.locate("terrain-1", folder / "ground.bil", Execution());
        } catch (const UsageError& error) {
            return error.message().id;
        }
        return std::string("nothing");
    };
    // Heights that are read by another header are others.
    std::ofstream(folder / "ground.hdr", std::ios::app) << "SKIPBYTES 4\n";
    EXPECT_EQ(refused(), "io.seal.located_other");
    fs::remove(folder / "ground.hdr");
    EXPECT_EQ(refused(), "io.seal.located_other");
}

TEST(SealedInputs, ACaseWithTheDigestOfTheFileAloneIsSealedAndRepeated) {
    const TemporaryFolder folder;
    writeTetrahedron(folder / "stone.stl");
    std::ofstream(folder / "bodies.csv") << "id,mass_kg,mesh,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s\na,400,stone.stl,0,0,1,0.5,0,0\n";
    writeGround(folder.path());
    const std::string casePath = folder / "stones.rubble";
    Case theCase = caseForFe(folder / "bodies.csv", casePath);
    theCase.inputs.push_back({"terrain-1", InputRole::Terrain, "ground.bil", sha256OfFile(folder / "ground.bil")});
    theCase.scenarios[0].scenario.simulation.settleTime = 1.0;
    saveCase(casePath, theCase);
    // The run keeps that of header and heights.
    runSmallCase(casePath, folder / "stones.run.h5");

    SealRequest request = requestOf(folder);
    const std::string bundle = folder / "stones.rubblecase";
    const SealReport report = sealCase(bundle, request, Execution());
    EXPECT_EQ(report.statement.inputs.at(1).sha256, sha256OfFile(folder / "ground.bil"));
    const SealCheck check = checkBundle(bundle, {}, Execution());
    EXPECT_THAT(check.faults, IsEmpty());
    {
        const UnpackedBundle unpacked(bundle, check, folder / "opened", Execution());
        EXPECT_TRUE(unpacked.repeat(unpacked.runs().at(0), Execution()).equal);
    }
    // A run on another header stands on no input of the case that keeps both.
    theCase.inputs.back().sha256.clear();
    saveCase(casePath, theCase);
    std::ofstream(folder / "ground.hdr", std::ios::app) << "NODATA -5\n";
    runSmallCase(casePath, folder / "other.run.h5");
    writeGround(folder.path());
    request.runs = {folder / "other.run.h5"};
    try {
        sealCase(folder / "other.rubblecase", request, Execution());
        FAIL() << "it was sealed";
    } catch (const UsageError& error) {
        EXPECT_EQ(error.message().id, "io.seal.run_of_another");
    }
}

}  // namespace
}  // namespace rubble::io
