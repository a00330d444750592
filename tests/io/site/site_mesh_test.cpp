#include "io/site/site_mesh_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>
#include <random>

#include "core/base/error.h"
#include "io/fe/meshes/polygon_cut.h"
#include "io/fe/meshes/raw_mesh.h"
#include "tests/support/error_id.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

double meshArea(const std::vector<Vec3>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    double sum = 0.0;
    for (const auto& t : triangles) {
        sum += 0.5 * (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm();
    }
    return sum;
}

class SiteMeshFile : public testing::Test {
protected:
    TemporaryFolder folder;
    Frame frame;
    Site site;
    SiteMeshRequest request;

    std::string lay(const std::string& name, const std::string& text) const {
        const std::string path = folder / name;
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }
    SiteMeshReading read(const std::string& name, const std::string& text) const {
        return readSiteMesh(lay(name, text), frame, site, Execution(), request);
    }
    double area(const std::string& name, const std::string& text) const {
        const SiteMeshReading reading = read(name, text);
        return meshArea(reading.mesh.points, reading.mesh.triangles);
    }
    /// The id of the error that a mesh is refused with; "read" if it is not.
    std::string refusal(const std::string& name, const std::string& text) const {
        try {
            read(name, text);
        } catch (const Error& error) {
            said = error.what();
            return error.message().id;
        }
        return "read";
    }
    mutable std::string said;
};

constexpr const char* objPoints = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 5\n";

TEST_F(SiteMeshFile, AWallWithAWindowKeepsItsArea) {
    const std::string window = std::string(objPoints) + "v 2 2 0\nv 2 8 0\nv 8 8 0\nv 8 2 0\n";
    // The wall as one polygon with a slit to its window, and a triangle.
    const SiteMeshReading reading = read("a.obj", window + "f 1 2 3 4 1 6 7 8 9 6\nf 1 2 5\n");
    EXPECT_NEAR(meshArea(reading.mesh.points, reading.mesh.triangles), 64.0 + 25.0, 1e-9);
    EXPECT_TRUE(reading.findings.empty());
    EXPECT_NEAR(area("b.obj", window + "f 9 8 7 6 1 4 3 2 1 6\n"), 64.0, 1e-9) << "the other way round";
}

TEST(PolygonCut, AnySimpleOutlineKeepsItsArea) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int trial = 0; trial < 300; ++trial) {
        const int corners = 4 + trial % 40;
        const Eigen::Quaterniond turn =
            Eigen::Quaterniond(unit(random), unit(random), unit(random), 0.1 + unit(random)).normalized();
        const Vec3 far(356500.0, 5699500.0, 100.0);
        std::vector<Vec3> points;
        std::vector<std::uint32_t> outline;
        double twice = 0.0;
        Eigen::Vector2d first;
        Eigen::Vector2d last;
        for (int k = 0; k < corners; ++k) {
            // A star: corners at rising angles and any distance.
            const double angle = 2.0 * std::numbers::pi * (k + 0.8 * unit(random)) / corners;
            const Eigen::Vector2d at = (1.0 + 20.0 * unit(random)) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
            twice += k == 0 ? 0.0 : last.x() * at.y() - last.y() * at.x();
            first = k == 0 ? at : first;
            last = at;
            points.push_back(far + turn * Vec3(at.x(), at.y(), 0.0));
            outline.push_back(static_cast<std::uint32_t>(k));
        }
        twice += last.x() * first.y() - last.y() * first.x();
        std::vector<std::array<std::uint32_t, 3>> triangles;
        EXPECT_TRUE(cutPolygon(points, outline, triangles)) << trial;
        EXPECT_LE(triangles.size(), static_cast<std::size_t>(corners - 2));
        // Coordinates of millions of metres keep a nanometre.
        EXPECT_NEAR(meshArea(points, triangles), 0.5 * twice, 1e-6 * twice + 1e-6) << trial << ", " << corners << " corners";
    }
}

TEST(PolygonCut, TwoHolesOneOutlineAndRepeatedCorners) {
    const std::vector<Vec3> points{{0, 0, 0}, {20, 0, 0}, {20, 10, 0}, {0, 10, 0}, {2, 2, 0},  {2, 8, 0},
                                   {8, 8, 0}, {8, 2, 0},  {12, 2, 0},  {12, 8, 0}, {18, 8, 0}, {18, 2, 0}};
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const std::vector<std::uint32_t> outline{0, 0, 1, 11, 8, 9, 10, 11, 1, 2, 3, 0, 4, 5, 6, 7, 4, 0};
    EXPECT_TRUE(cutPolygon(points, outline, triangles));
    EXPECT_NEAR(meshArea(points, triangles), 200.0 - 2.0 * 36.0, 1e-9);
    triangles.clear();
    const std::vector<std::uint32_t> line{0, 1, 0, 1};
    EXPECT_TRUE(cutPolygon(points, line, triangles));
    EXPECT_TRUE(triangles.empty());
    const std::vector<std::uint32_t> bowTie{0, 1, 3, 2};
    EXPECT_FALSE(cutPolygon(points, bowTie, triangles)) << "its two halves take each other's area away";
    EXPECT_FALSE(triangles.empty());
}

TEST_F(SiteMeshFile, FacesThatNameMissingPointsAreCounted) {
    const SiteMeshReading obj = read("a.obj", std::string(objPoints) + "f 1 2 3\nf 1 3 9\nf 0 1 2\nf -9 1 2\n");
    EXPECT_EQ(obj.mesh.triangles.size(), 1u);
    EXPECT_EQ(obj.findings.count("surroundings.missing_corners_in_line"), 3);
    const SiteMeshReading crossing = read("b.obj", std::string(objPoints) + "f 1 2 3\nf 1 2 4 3\nl 1 2\np 1\n");
    EXPECT_EQ(crossing.findings.count("surroundings.crossing"), 1);
    EXPECT_EQ(crossing.findings.count("surroundings.other_shapes"), 2);
}

TEST_F(SiteMeshFile, EveryWayToWriteAnObjIsRead) {
    for (const char* faces :
         {"usemtl\nf 1 2 3\nf 1 3 4\n", "usemtl \nf 1 2 3 4\n", "f 1// 2// 3// 4//\n", "f 1/1/ 2/1/ 3/1/ 4/1/", "f -5 -4 -3 -2\n",
          "f 1 2 \\\n 3 4\r\n", "mtllib none.mtl\no a\ng b c\ns off\nf\t1\t2\t3\t4\n", "f 1/1/1 2/2/2 3/3/3 4/4/4\n# end"}) {
        EXPECT_NEAR(area("a.obj", std::string(objPoints) + faces), 100.0, 1e-9) << faces;
    }
    EXPECT_NEAR(area("colours.obj", "v 0 0 0 1 0 0\nv 4 0 0 1 0 0\nv 4 3 0 0.5 0.5 0.5\nf 1 2 3\n"), 6.0, 1e-12);
    EXPECT_NEAR(area("later.obj", "f 1 2 3\nv 0 0 0\nv +4 0 0\nv 4 3e0 0\n"), 6.0, 1e-12) << "points after faces";
    EXPECT_EQ(refusal("a.obj", "v 1,5 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"), "surroundings.no_number");
    EXPECT_NE(said.find("line 1: \"1,5\""), std::string::npos) << said;
    EXPECT_EQ(refusal("a.obj", "v nan 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"), "surroundings.no_number");
    EXPECT_EQ(refusal("a.obj", std::string(objPoints) + "f a b c\n"), "surroundings.no_corner");
    EXPECT_EQ(refusal("a.obj", objPoints), "surroundings.no_faces");
    EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3 1\n"), "surroundings.no_area");
    EXPECT_EQ(refusal("a.obj", ""), "surroundings.empty");
    EXPECT_EQ(refusal("a.obj", std::string(3 << 20, 'v')), "surroundings.long_line");
    EXPECT_EQ(read("b.obj", std::string(objPoints) + "f 1 2 3\ncurv 0 1 1 2\n").findings.count("surroundings.curved"), 1);
}

std::string plyHead(const std::string& format, const std::string& number, const std::string& faces) {
    return "ply\nformat " + format + " 1.0\ncomment made here\nelement vertex 4\nproperty " + number + " x\nproperty " + number +
           " y\nproperty " + number + " z\n" + faces + "end_header\n";
}

template <class T>
void putBytes(std::string& bytes, T value, bool big) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof(T));
    if (big) {
        std::reverse(raw.begin(), raw.end());
    }
    bytes.append(raw.data(), raw.size());
}

TEST_F(SiteMeshFile, EveryWayToWriteAPlyIsRead) {
    const std::string places = "0 0 0\n10 0 0\n10 10 0\n0 10 0\n";
    const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
    EXPECT_NEAR(area("a.ply", plyHead("ascii", "float", face) + places + "4 0 1 2 3"), 100.0, 1e-9) << "no end of the last line";
    EXPECT_NEAR(area("b.ply", plyHead("ascii", "double", "element tristrips 1\nproperty list int int vertex_indices\n") + places +
                                  "4 0 1 3 2\n"),
                100.0, 1e-9);
    EXPECT_NEAR(area("c.ply", plyHead("ascii", "float", "element tristrips 1\nproperty list int int vertex_indices\n") + places +
                                  "7 0 1 2 -1 0 2 3\n"),
                100.0, 1e-9);
    const SiteMeshReading missing =
        read("d.ply",
             plyHead("ascii", "float", "element face 2\nproperty list uchar int vertex_index\n") + places + "3 0 1 2\n3 0 2 9\n");
    EXPECT_EQ(missing.mesh.triangles.size(), 1u);
    EXPECT_EQ(missing.findings.count("surroundings.missing_corners_in_line"), 1);
    for (const bool big : {false, true}) {
        std::string bytes =
            plyHead(big ? "binary_big_endian" : "binary_little_endian", "double",
                    "property uchar red\nelement face 1\nproperty uchar flags\nproperty list uchar uint vertex_indices\n");
        for (const auto& [x, y] : {std::pair(0.25, 0.0), {10.25, 0.0}, {10.25, 10.0}, {0.25, 10.0}}) {
            for (const double value : {356500.0 + x, 5699500.75 + y, 100.5}) {
                putBytes(bytes, value, big);
            }
            putBytes(bytes, std::uint8_t{7}, big);
        }
        bytes += std::string("\1\4", 2);
        for (const std::uint32_t corner : {0u, 1u, 2u, 3u}) {
            putBytes(bytes, corner, big);
        }
        const SiteMeshReading reading = read("e.ply", bytes);
        EXPECT_EQ(reading.mesh.points[0], Vec3(356500.25, 5699500.75, 100.5)) << "not rounded to single precision";
        EXPECT_NEAR(meshArea(reading.mesh.points, reading.mesh.triangles), 100.0, 1e-6);
        EXPECT_TRUE(reading.findings.empty());
        EXPECT_EQ(refusal("f.ply", bytes.substr(0, bytes.size() - 2)), "surroundings.cut");
    }
    EXPECT_EQ(refusal("g.ply", plyHead("ascii", "float", face) + "nan 0 0\n10 0 0\n10 10 0\n0 10 0\n4 0 1 2 3\n"),
              "surroundings.no_number");
    EXPECT_EQ(refusal("h.obj", "v 0 0 0\nv 10 0 0\nv 10 10 0\n"), "surroundings.no_faces");
    EXPECT_EQ(refusal("i.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\n" + face + "end_header\n1\n"),
              "surroundings.cut");
    EXPECT_EQ(refusal("j.ply", "solid\n"), "surroundings.no_ply");
}

TEST_F(SiteMeshFile, CoordinatesThatTheFileKeepsCoarselyAreSaid) {
    std::string bytes = plyHead("binary_little_endian", "float", "element face 1\nproperty list uchar int vertex_indices\n");
    for (const auto& [x, y] : {std::pair(0.0F, 0.0F), {10.0F, 0.0F}, {10.0F, 10.0F}, {0.0F, 10.0F}}) {
        for (const float value : {356500.0F + x, 5699500.0F + y, 100.5F}) {
            putBytes(bytes, value, false);
        }
    }
    bytes += '\4';
    for (const std::int32_t corner : {0, 1, 2, 3}) {
        putBytes(bytes, corner, false);
    }
    EXPECT_EQ(read("a.ply", bytes).findings.count("surroundings.coarse"), 1);
    const std::string few = "v 3.565e+05 5.6995e+06 100\nv 3.566e+05 5.6995e+06 100\nv 3.566e+05 5.6996e+06 100\nf 1 2 3\n";
    EXPECT_EQ(read("a.obj", few).findings.count("surroundings.coarse"), 1);
    const std::string many = "v 3.565000000e+05 5.699500000e+06 100\nv 356510 5699500 100\nv 356510 5699510 100\nf 1 2 3\n";
    EXPECT_TRUE(read("b.obj", many).findings.empty());
}

// Two triangles (0, 0, 0), (4, 0, 0), (4, 0, -3) and so on, y up.
std::string sceneText(const std::string& node, const std::string& more, const std::string& sparse = "") {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" + node +
           R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":4,"indices":1}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3")" +
           sparse +
           R"(},{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],)"
           R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],)"
           R"("buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,)"
           R"(AAAAAAAAAAAAAAAAAACAQAAAAAAAAAAAAACAQAAAAAAAAEDAAAAAAAAAAAAAAEDAAAABAAIAAAACAAMA)"
           R"("}])" +
           more + "}";
}

TEST_F(SiteMeshFile, GltfIsPlacedByItsNodesInDoublePrecision) {
    const SiteMeshReading plain = read("a.gltf", sceneText("", ""));
    EXPECT_EQ(plain.mesh.triangles.size(), 2u);
    EXPECT_TRUE(plain.findings.empty());
    EXPECT_NEAR((plain.mesh.points[1] - Vec3(4.0, 0.0, 0.0)).norm(), 0.0, 1e-12);
    const SiteMeshReading moved = read("b.gltf", sceneText(R"(,"translation":[356500.25,100.5,-5699500.75],"scale":[2,2,2])", ""));
    EXPECT_NEAR((moved.mesh.points[1] - Vec3(356508.25, 5699500.75, 100.5)).norm(), 0.0, 1e-9);
    EXPECT_TRUE(moved.findings.empty()) << "single precision about a near origin is fine enough";
    const SiteMeshReading turned = read("c.gltf", sceneText(R"(,"rotation":[0,0.7071067811865476,0,0.7071067811865476])", ""));
    EXPECT_NEAR((turned.mesh.points[1] - Vec3(0.0, 4.0, 0.0)).norm(), 0.0, 1e-12);
    const SiteMeshReading same = read("d.gltf", sceneText(R"(,"matrix":[0,0,-1,0,0,1,0,0,1,0,0,0,0,0,0,1])", ""));
    EXPECT_NEAR((same.mesh.points[1] - turned.mesh.points[1]).norm(), 0.0, 1e-12);
}

TEST_F(SiteMeshFile, GltfThatOthersReadIsRead) {
    const std::string texture = R"(,"images":[{"uri":"not_there.png"}],"textures":[{"source":0}])";
    EXPECT_EQ(read("a.gltf", sceneText("", texture)).mesh.triangles.size(), 2u);
    std::string sceneless = sceneText("", "");
    const std::string scene = R"("scene":0,"scenes":[{"nodes":[0]}],)";
    sceneless.erase(sceneless.find(scene), scene.size());
    EXPECT_EQ(read("s.gltf", sceneless).mesh.triangles.size(), 2u);
    const std::string quantised =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[0.01,0.01,0.01]}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5123,"count":4,"type":"VEC3"}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":24}],)"
        R"("buffers":[{"byteLength":24,"uri":"data:;base64,AAAAAAAAkAEAAAAAkAEAAFgCAAAsAQAA"}],)"
        R"("extensionsUsed":["KHR_mesh_quantization"],"extensionsRequired":["KHR_mesh_quantization"]})";
    const SiteMeshReading strip = read("b.gltf", quantised);
    EXPECT_EQ(strip.mesh.triangles.size(), 2u);
    EXPECT_NEAR(strip.mesh.points[1].x(), 4.0, 1e-12);
    std::string sparse =
        sceneText("", "", R"(,"sparse":{"count":1,"indices":{"bufferView":2,"componentType":5123},"values":{"bufferView":3}})");
    const auto replace = [&](const std::string& what, const std::string& by) {
        sparse.replace(sparse.find(what), what.size(), by);
    };
    replace(
        R"("byteOffset":48,"byteLength":12})",
        R"("byteOffset":48,"byteLength":12},{"buffer":0,"byteOffset":60,"byteLength":2},{"buffer":0,"byteOffset":64,"byteLength":12})");
    replace(R"("byteLength":60)", R"("byteLength":76)");
    replace("AAACAAMA", "AAACAAMAAwAAAAAAAAAAABBBAAAAAA==");
    const SiteMeshReading replaced = read("c.gltf", sparse);
    EXPECT_NEAR((replaced.mesh.points[3] - Vec3(0.0, 0.0, 9.0)).norm(), 0.0, 1e-12) << replaced.mesh.points[3].transpose();
}

TEST_F(SiteMeshFile, ExtensionsThatAreRequiredAreObeyed) {
    EXPECT_EQ(refusal("a.gltf", sceneText("", R"(,"extensionsRequired":["CESIUM_RTC","EXT_meshopt_compression"])")),
              "surroundings.gltf_extension");
    EXPECT_NE(said.find("CESIUM_RTC, EXT_meshopt_compression"), std::string::npos) << said;
    EXPECT_EQ(refusal("a.gltf", sceneText("", R"(,"extensionsRequired":["KHR_materials_unlit","KHR_texture_transform"])")), "read");
    EXPECT_EQ(read("a.gltf", sceneText("", R"(,"extensionsUsed":["EXT_mesh_gpu_instancing"])"))
                  .findings.count("surroundings.gltf_left_out"),
              1);
    EXPECT_TRUE(read("a.gltf", sceneText("", R"(,"extensionsUsed":["KHR_materials_unlit"])")).findings.empty());
    std::string old = sceneText("", "");
    old.replace(old.find("\"2.0\""), 5, "\"1.0\"");
    EXPECT_EQ(refusal("a.gltf", old), "surroundings.gltf_version");
}

TEST_F(SiteMeshFile, DamagedGltfIsRefusedByItsPlace) {
    const std::string whole = sceneText("", "");
    const std::vector<std::pair<std::string, std::string>> damages{{"\"byteLength\":48", "\"byteLength\":480"},
                                                                   {"\"count\":4", "\"count\":400"},
                                                                   {"\"nodes\":[0]", "\"nodes\":[7]"},
                                                                   {"\"mesh\":0", "\"mesh\":-1"},
                                                                   {"\"mode\":4", "\"mode\":9"},
                                                                   {"5126", "5127"},
                                                                   {"\"POSITION\":0", "\"POSITION\":1"},
                                                                   {"\"mesh\":0", "\"mesh\":0,\"children\":[0]"}};
    for (const auto& [from, to] : damages) {
        std::string text = whole;
        text.replace(text.find(from), from.size(), to);
        EXPECT_NE(refusal("a.gltf", text), "read") << to;
    }
    for (std::size_t cut = 1; cut < whole.size(); cut += 7) {
        EXPECT_NE(refusal("b.gltf", whole.substr(0, cut)), "read");
    }
}

TEST_F(SiteMeshFile, WhatIsNoMeshIsRefusedWithItsReason) {
    EXPECT_EQ(refusal("a.dxf", std::string("\1\2\3")), "surroundings.ending");
    EXPECT_EQ(refusal("a.glb", "glTF"), "surroundings.glb_cut");
    std::string glb = "glTF";
    for (const std::uint32_t word : {2u, 1000u, 900u, 0x4E4F534Au}) {
        glb.append(reinterpret_cast<const char*>(&word), sizeof word);
    }
    EXPECT_EQ(refusal("a.glb", glb + "{}"), "surroundings.glb_cut") << "a chunk longer than the file";
    const std::string large = lay("large.obj", objPoints);
    std::filesystem::resize_file(large, (std::uintmax_t{2} << 30) + 1);
    EXPECT_EQ(idOfError([&] { readSiteMesh(large, frame, site, Execution(), request); }), "surroundings.too_large");
    const auto buffered = [&](const std::string& from, const std::string& to) {
        std::string text = sceneText("", "");
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    EXPECT_EQ(refusal("a.gltf", buffered("\"buffers\":[{\"byteLength\":", "\"buffers\":[{\"byteLength\":9")),
              "surroundings.buffer_cut");
    EXPECT_EQ(refusal("a.gltf", buffered("\"uri\":\"data:", "\"uri\":\"none.bin?data:")), "surroundings.missing_buffer");
    EXPECT_EQ(read("a.gltf", buffered("\"mesh\":0", "\"mesh\":0,\"skin\":0")).findings.count("surroundings.gltf_skin"), 1);
    EXPECT_EQ(
        read("a.gltf", buffered("\"attributes\":", "\"targets\":[],\"attributes\":")).findings.count("surroundings.gltf_morph"), 1);
}

TEST_F(SiteMeshFile, MorePointsThanAMeshMayHaveAreRefused) {
    const std::string path = folder / "many.obj";
    MeshGathering gathering(path);
    const auto fill = [&] {
        for (std::size_t k = 0; k <= meshPointsMax; ++k) {
            gathering.addPoint(Vec3::Zero(), 0);
        }
    };
    EXPECT_EQ(idOfError(fill), "surroundings.too_many_points");
}

class MeshOfASite : public SiteMeshFile {
protected:
    void SetUp() override {
        frame.crs = "EPSG:25832";
        site.controlPoints = {{"P0", Vec3(0, 0, 0), Vec3(356500, 5699500, 120), true},
                              {"P1", Vec3(100, 0, 0), Vec3(356600, 5699500, 120), true}};
        request.around = Aabb(Vec3(0, 0, 0), Vec3(20, 6, 10));
    }
    static constexpr const char* utm =
        "v 356500.25 5699500.75 100.5\nv 356510.25 5699500.75 100.5\nv 356510.25 5699510.75 110.5\nv 356500.25 5699510.75 110.5\n"
        "f 1 2 3 4\n";
    static constexpr const char* local = "v 0.25 0.75 0.5\nv 10.25 0.75 0.5\nv 10.25 10.75 10.5\nv 0.25 10.75 10.5\nf 1 2 3 4\n";
    static constexpr double rounding = 1e-8;  // m, of coordinates of millions of metres

    void expectPlaced(const SiteMeshReading& reading) const {
        EXPECT_NEAR((reading.mesh.points[2] - Vec3(10.25, 10.75, -9.5)).norm(), 0.0, rounding)
            << reading.mesh.points[2].transpose();
    }
};

TEST_F(MeshOfASite, LargeCoordinatesLoseNothing) {
    const SiteMeshReading reading = read("utm.obj", utm);
    expectPlaced(reading);
    EXPECT_TRUE(reading.findings.empty());
}

TEST_F(MeshOfASite, AMeshElsewhereIsRefusedUntilItHasItsOffset) {
    EXPECT_EQ(refusal("local.obj", local), "surroundings.elsewhere");
    EXPECT_NE(said.find("surroundings count within x = -100 to 120 m, y = -100 to 106 m"), std::string::npos) << said;
    request.offset = Vec3(356500, 5699500, 100);
    const SiteMeshReading reading = read("local.obj", local);
    expectPlaced(reading);
    EXPECT_EQ(reading.offset, *request.offset);
    request.offset = Vec3(356500, 5699500, 1e5);
    EXPECT_EQ(read("local.obj", local).findings.count("surroundings.far_off"), 1);
}

TEST_F(MeshOfASite, AMeshFarDownTheTerrainIsTaken) {
    const std::string far = "v 356900 5699500 90\nv 356910 5699500 90\nv 356910 5699510 95\nf 1 2 3\n";
    EXPECT_EQ(refusal("far.obj", far), "surroundings.elsewhere");
    request.around = {request.around.structure, Aabb(Vec3(-500, -500, 0), Vec3(500, 500, 0))};
    EXPECT_EQ(read("far.obj", far).mesh.triangles.size(), 1u);
    EXPECT_EQ(refusal("local.obj", local), "surroundings.elsewhere");
}

TEST_F(MeshOfASite, OffsetFilesOfManyProgramsAreFound) {
    const std::vector<std::pair<std::string, std::string>> files{
        {"local_offset.xyz", "356500.000 5699500.000 100.000\n"},
        {"project_offset.xyz", "356500 5699500 100"},
        {"offset.txt", "X axis: 356500.00\nY axis: 5699500.00\nZ axis: 100.00\n"},
        {"SHIFT.txt", "EPSG::25832 356500 5699500 100\n"},
        {"metadata.xml",
         "<?xml version=\"1.0\"?><ModelMetadata version=\"1\"><SRS>EPSG:25832</SRS>"
         "<SRSOrigin>356500,5699500,100</SRSOrigin></ModelMetadata>"}};
    for (const auto& [name, text] : files) {
        const std::string file = lay(name, text);
        const SiteMeshReading reading = read("local.obj", local);
        expectPlaced(reading);
        EXPECT_EQ(reading.findings.count("surroundings.offset_file"), 1) << name;
        std::filesystem::remove(file);
    }
    // OpenDroneMap writes no height.
    const std::string coords = lay("coords.txt", "WGS84 UTM 32N\n356500 5699500\n1.5 2.5 3.5\n4 5 6\n");
    EXPECT_EQ(read("local.obj", local).offset, Vec3(356500, 5699500, 0));
    EXPECT_EQ(read("utm.obj", utm).findings.count("surroundings.offset_left"), 1) << "it lies at the site already";
    std::filesystem::remove(coords);
    lay("offset.txt", "none yet\n");
    EXPECT_EQ(refusal("local.obj", local), "surroundings.elsewhere");
    EXPECT_EQ(read("utm.obj", utm).findings.count("surroundings.offset_unread"), 1);
}

TEST_F(SiteMeshFile, APointCloudIsTheSurfaceOfItsPointsWithItsHoles) {
    // Ground at 1 m with a roof at 5 m in its middle and a pond that gave no echo.
    std::string points;
    int count = 0;
    for (double y = -9.875; y < 10.0; y += 0.25) {
        for (double x = -9.875; x < 10.0; x += 0.25) {
            if (x < 4.0 || x > 8.0 || y < 4.0 || y > 8.0) {
                points +=
                    std::to_string(x) + ' ' + std::to_string(y) + (std::max(std::abs(x), std::abs(y)) < 3.0 ? " 5\n" : " 1\n");
                ++count;
            }
        }
    }
    const std::string head = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
                             "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    const SiteMeshReading cloud = read("scan.ply", head + points);
    EXPECT_EQ(cloud.findings.count("surroundings.cloud_surface"), 1);
    EXPECT_EQ(cloud.findings.count("surroundings.cloud_offset"), 0);
    double plan = 0.0;
    double roof = 0.0;
    for (const auto& t : cloud.mesh.triangles) {
        const Vec3& a = cloud.mesh.points[t[0]];
        const double area = 0.5 * (cloud.mesh.points[t[1]] - a).cross(cloud.mesh.points[t[2]] - a).z();
        EXPECT_GT(area, 0.0) << "seen from above";
        plan += area;
        const Vec3 middle = (a + cloud.mesh.points[t[1]] + cloud.mesh.points[t[2]]) / 3.0;
        roof += std::abs(middle.z() - 5.0) < 1e-6 ? area : 0.0;
        EXPECT_FALSE(std::abs(middle.x() - 6.0) < 1.0 && std::abs(middle.y() - 6.0) < 1.0) << "nothing is made of the pond";
    }
    EXPECT_NEAR(plan, 20.0 * 20.0 - 4.0 * 4.0, 40.0);
    // A height is that of a plane through its cell and those about it, so edges are slopes.
    EXPECT_GT(roof, 4.0 * 4.0);
    EXPECT_LT(roof, 6.0 * 6.0);
    request.offset = Vec3(100.0, 0.0, 0.0);
    EXPECT_EQ(read("scan.ply", head + points).findings.count("surroundings.cloud_offset"), 1) << "never left out silently";
}

}  // namespace
}  // namespace rubble::io
