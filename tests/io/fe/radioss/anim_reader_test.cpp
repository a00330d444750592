#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "io/fe/radioss/anim_file.h"
#include "tests/io/collapse_identity.h"
#include "tests/io/fe/radioss/anim_builder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {

namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Counts = std::vector<std::int64_t>;

std::shared_ptr<const FeResult> open(const std::string& path) {
    Frame millimetres;
    millimetres.metresPerUnit = 0.001;
    return openFe(path, {}, millimetres, Execution{});
}

std::string errorOf(const std::string& path) {
    try {
        const auto fe = open(path);
        for (std::size_t k = 0; k < fe->stateCount(); ++k) {
            fe->state(k);
        }
    } catch (const Error& error) {
        EXPECT_FALSE(error.remedy().empty());
        EXPECT_THAT(error.what(), HasSubstr(std::filesystem::path(path).parent_path().filename().string()));
        return englishText(error.message());
    }
    return {};
}

AnimBuilder dying() {
    AnimBuilder builder;
    builder.bricks = 5;
    builder.brickDeaths = {{1, 1.25}, {2, 2.5}};
    builder.shellDeaths = {{1, 2.0}};
    builder.rigid = {4};
    return builder;
}

TEST(AnimReader, ElementsPartsMaterialsAndExactDeaths) {
    const TemporaryFolder folder;
    dying().write(folder.path(), {0, 1, 2, 3});
    const auto fe = open(folder / "RUNA001");
    const Mesh& mesh = fe->mesh();
    EXPECT_EQ(fe->contents().format, "OpenRadioss animation");
    EXPECT_THAT(mesh.elementIds, ElementsAre(11, 12, 13, 14, 15, 31, 32, 41, 42)) << "the link of the rigid body is no element";
    EXPECT_EQ(fe->contents().findings.count("anim.links"), 1);
    ASSERT_EQ(mesh.parts.size(), 4u);
    EXPECT_EQ(mesh.parts[0].name, "COLUMN");
    EXPECT_EQ(mesh.parts[1].name, "BLOCK");
    EXPECT_EQ(mesh.parts[2].name, "SKIN");
    EXPECT_EQ(mesh.parts[3].name, "TIE");
    EXPECT_EQ(deadPerState(*fe), (Counts{0, 0, 2, 3})) << "255 is rigid, not dead";
    EXPECT_THAT(fe->contents().activityFrom, HasSubstr("1 rigid"));
    ASSERT_EQ(fe->contents().deathTime.size(), 9u);
    EXPECT_EQ(fe->contents().deathTime[1], 1.25);
    EXPECT_EQ(fe->contents().deathTime[2], 2.5);
    EXPECT_TRUE(std::isnan(fe->contents().deathTime[0])) << "alive";
    EXPECT_TRUE(std::isnan(fe->contents().deathTime[6])) << "dead, but the run did not write when";
    // Masses over volumes, in kg/m3; single precision keeps seven digits.
    EXPECT_NEAR(mesh.density[0], 2400.0, 1e-3);
    EXPECT_EQ(mesh.shapes[6], ElementShape::Triangle);
    EXPECT_TRUE(std::isnan(mesh.section[5])) << "mass alone gives no thickness";
    const auto state = fe->state(2);
    EXPECT_NEAR((state->positions[9] - 1e-3 * Vec3(2 + 1 + 2, 0, 0)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((state->velocities[9] - 1e-3 * Vec3(1, 2, 3)).norm(), 0.0, 1e-9);
}

TEST(AnimReader, TheStarterDeckSaysWhatTheFilesCannot) {
    const TemporaryFolder folder;
    AnimBuilder builder = dying();
    builder.masses = false;
    builder.densities = false;
    builder.write(folder.path(), {0, 1});
    const auto without = open(folder / "RUNA001");
    EXPECT_TRUE(std::isnan(without->mesh().density[0]));
    std::ofstream(folder / "RUN_0000.rad") << "#RADIOSS STARTER\n"
                                              "/MAT/PLAS_JOHNS/1\nstone\n             2.6e-09                   0\n"
                                              "/MAT/LAW1/2\nsteel\n#              RHO_I\n            7.85e-09\n"
                                              "/PROP/SHELL/3\nshell\n        24         0\n                   0\n"
                                              "         3                             8                   0\n"
                                              "/PROP/TRUSS/4\ntruss\n                 200                   0\n"
                                              "/PART/1\nCOLUMN\n         1         1         0\n"
                                              "/PART/3\nSKIN\n         3         2         0\n"
                                              "/PART/4\nTIE\n         4         2         0\n/END\n";
    const auto with = open(folder / "RUNA001");
    const Mesh& mesh = with->mesh();
    EXPECT_NEAR(mesh.density[0], 2600.0, 1e-9);
    EXPECT_TRUE(std::isnan(mesh.density[4])) << "a part that the deck does not have";
    EXPECT_NEAR(mesh.density[5], 7850.0, 1e-9);
    EXPECT_NEAR(mesh.section[5], 0.008, 1e-12);
    EXPECT_NEAR(mesh.section[7], 200e-6, 1e-15);
}

TEST(AnimReader, ParticlesAreCubesOfTheirVolume) {
    const TemporaryFolder folder;
    AnimBuilder builder;
    builder.particles = 2;
    builder.write(folder.path(), {0, 1});
    const auto fe = open(folder / "RUNA002");
    EXPECT_EQ(deadPerState(*fe), (Counts{0, 1}));
    const Mesh& mesh = fe->mesh();
    ASSERT_EQ(mesh.elementCount(), 3u + 2 + 2 + 2);
    EXPECT_EQ(mesh.elementIds.back(), 62);
    const auto corners = mesh.cornersOf(idAt<ElementIndex>(mesh.elementCount() - 1));
    EXPECT_NEAR((mesh.nodes[corners[6]] - mesh.nodes[corners[0]]).prod(), 0.125e-9, 1e-15) << "0.2 over 1.6";
    EXPECT_NEAR(mesh.density.back(), 1600.0, 1e-3);
    const auto state = fe->state(1);
    EXPECT_NEAR((state->positions[corners[6]] - state->positions[corners[0]]).prod(), 0.125e-9, 1e-15);
}

TEST(AnimReader, PackedOrPlainIsTheSame) {
    const TemporaryFolder plain, packed;
    const AnimBuilder builder = dying();
    builder.write(plain.path(), {0, 1, 2, 3});
    for (int k = 0; k < 4; ++k) {
        putPacked(packed / ("RUNA00" + std::to_string(k + 1) + ".gz"), builder.file(k));
    }
    const auto a = open(plain / "RUNA003"), b = open(packed / "RUNA003.gz");
    EXPECT_EQ(collapseDigest(*a, {0, 1, 2, 3}), collapseDigest(*b, {0, 1, 2, 3}));
    EXPECT_EQ(a->state(2)->positions, b->state(2)->positions);
    // Packed and plain members mix; of a file that is there twice the plain one is read.
    putFile(packed / "RUNA002", builder.file(1));
    std::filesystem::remove(packed / "RUNA003.gz");
    putFile(packed / "RUNA003", builder.file(2));
    const auto c = open(packed.path());
    EXPECT_EQ(c->stateCount(), 4u);
    EXPECT_EQ(c->contents().files.size(), 4u);
    EXPECT_EQ(collapseDigest(*c, {0, 1, 2, 3}), collapseDigest(*a, {0, 1, 2, 3}));
}

TEST(AnimReader, OrderByNumberGapsAndStatesCutOff) {
    const TemporaryFolder folder;
    const AnimBuilder builder = dying();
    for (int k = 0; k < 3; ++k) {
        putFile(folder / ("RUNA" + std::to_string(998 + k)), builder.file(k));
    }
    putFile(folder / "RUNA1003", builder.file(5));
    putFile(folder / "OTHERA999", builder.file(9));
    const auto fe = open(folder / "RUNA1000");
    EXPECT_EQ(fe->times(), (std::vector<double>{0, 1, 2, 5}));
    EXPECT_EQ(fe->contents().findings.count("anim.gap"), 2);
    const std::string whole = builder.file(5);
    putFile(folder / "RUNA1003", whole.substr(0, whole.size() / 3));
    putFile(folder / "RUNA999", whole.substr(0, whole.size() / 2));
    const auto cut = open(folder / "RUNA998");
    EXPECT_EQ(cut->times(), (std::vector<double>{0, 2}));
    EXPECT_EQ(cut->contents().findings.count("anim.incomplete"), 1);
    EXPECT_EQ(cut->contents().findings.count("anim.cut_state"), 1);
    EXPECT_THROW(fe->state(3), ParseError) << "the file has become shorter since it was opened";
    EXPECT_THROW(open(folder.path()), WorldError) << "two runs in one folder";
}

TEST(AnimReader, AFileOfAnotherRunIsRefusedByName) {
    const TemporaryFolder folder;
    AnimBuilder builder = dying();
    builder.write(folder.path(), {0, 1, 2});
    builder.firstBrick = 1;
    putFile(folder / "RUNA002", builder.file(1));
    EXPECT_THAT(errorOf(folder / "RUNA001"), AllOf(HasSubstr("RUNA002"), HasSubstr("other elements")));
    builder = dying();
    builder.magic = 0x5429;
    builder.write(folder.path(), {0, 1, 2});
    EXPECT_THAT(errorOf(folder / "RUNA001"), HasSubstr("another version"));
}

TEST(AnimReader, DeathTimesOutsideTheirIntervalAreLeftOut) {
    const TemporaryFolder folder;
    AnimBuilder builder = dying();
    builder.write(folder.path(), {0, 1});
    builder.brickDeaths[1] = 0.5;  // said to have died before a state that shows it alive
    putFile(folder / "RUNA003", builder.file(2));
    const auto fe = open(folder / "RUNA001");
    EXPECT_EQ(fe->contents().findings.count("anim.death_time"), 1);
    EXPECT_TRUE(fe->contents().deathTime.empty());
}

TEST(AnimReader, EveryTruncationPlainAndPacked) {
    const TemporaryFolder folder;
    AnimBuilder builder;
    builder.particles = 1;
    const std::string whole = builder.file(0.0);
    for (std::size_t size = 1; size < whole.size(); ++size) {
        putFile(folder / "RUNA001", whole.substr(0, size));
        const std::string error = errorOf(folder / "RUNA001");
        ASSERT_NE(error, "") << size << " of " << whole.size();
        if (size >= 8) {
            ASSERT_THAT(error, AllOf(HasSubstr("is cut off"), HasSubstr("byte"))) << size;
        }
    }
    putFile(folder / "RUNA001", whole);
    EXPECT_EQ(errorOf(folder / "RUNA001"), "");
    std::filesystem::remove(folder / "RUNA001");
    putPacked(folder / "RUNA001.gz", whole);
    const std::string packed = wholeFile(folder / "RUNA001.gz");
    EXPECT_EQ(errorOf(folder / "RUNA001.gz"), "");
    // The last eight bytes are a sum that is not needed to read what stands before.
    for (std::size_t size = 1; size + 64 < packed.size(); ++size) {
        putFile(folder / "RUNA001.gz", packed.substr(0, size));
        ASSERT_NE(errorOf(folder / "RUNA001.gz"), "") << size;
    }
}

TEST(AnimReader, HugeCountsAndFlippedBits) {
    const TemporaryFolder folder;
    const std::string whole = AnimBuilder().file(0.0);
    const std::size_t counts = 8 + 3 * 81;
    for (std::size_t place = counts; place + 4 <= counts + 72; place += 4) {
        for (const char* value : {"\x7f\xff\xff\xff", "\x80\x00\x00\x01", "\x40\x00\x00\x01"}) {
            std::string damaged = whole;
            damaged.replace(place, 4, value, 4);
            putFile(folder / "RUNA001", damaged);
            errorOf(folder / "RUNA001");
        }
    }
    std::string damaged = whole;
    damaged.replace(counts + 40, 4, "\x7f\xff\xff\xff", 4);
    putFile(folder / "RUNA001", damaged);
    EXPECT_THAT(errorOf(folder / "RUNA001"), AllOf(HasSubstr("cut off"), HasSubstr("coordinates"), HasSubstr("byte")));
    std::mt19937 random(3);
    int errors = 0;
    for (int i = 0; i < 2000; ++i) {
        damaged = whole;
        damaged[random() % whole.size()] ^= static_cast<char>(1 << (random() % 8));
        putFile(folder / "RUNA001", damaged);
        errors += !errorOf(folder / "RUNA001").empty();
    }
    EXPECT_GT(errors, 50) << "the flips met nothing that matters";
}

// A real run: bricks, shells and trusses die, a rigid block stands.
TEST(AnimReader, TheFrameInThreeFormats) {
    const auto anim = open(fixture("frame-anim"));
    const Counts dead{0, 0, 18, 22, 32, 35, 40, 42, 42, 42, 42, 42, 42, 42, 42, 42, 43, 43, 43, 43};
    EXPECT_EQ(deadPerState(*anim), dead);
    const auto converted = open(fixture("frame-vtk/FRAMEA011.vtk"));
    const auto d3plot = open(fixture("frame-d3plot/FRAME.d3plot07"));
    EXPECT_EQ(deadPerState(*d3plot), dead);
    using Name = std::tuple<ElementShape, std::int64_t, std::size_t>;
    const auto deaths = [](const FeResult& fe) {
        std::set<Name> set;
        for (std::size_t e = 0; e < fe.mesh().elementCount(); ++e) {
            const auto id = idAt<ElementIndex>(e);
            for (std::size_t k = 1; k < fe.stateCount(); ++k) {
                if (!fe.activity().active(k, id) && fe.activity().active(k - 1, id)) {
                    set.emplace(fe.mesh().shapes[e], fe.mesh().elementIds[e], k);
                }
            }
        }
        return set;
    };
    EXPECT_EQ(deaths(*anim).size(), 43u);
    EXPECT_EQ(deaths(*converted), deaths(*anim));
    EXPECT_EQ(deaths(*d3plot), deaths(*anim));
    EXPECT_EQ(converted->contents().findings.count("anim.never_active"), 4) << "the rigid block: the converter loses what it is";
    const std::map<std::string, double> densities{
        {"COLUMNS", 2400}, {"SLAB", 2400}, {"CLADDING", 1800}, {"TIES", 7850}, {"RIGID BLOCK", 7850}};
    double lost = 0.0;
    for (std::size_t e = 0; e < anim->mesh().elementCount(); ++e) {
        const Part& part = anim->mesh().parts[anim->mesh().part[e]];
        EXPECT_NEAR(anim->mesh().density[e] / densities.at(part.name), 1.0, 1e-6) << part.name;
        // Of trusses the converted files have neither mass nor section, and no deck lies beside them.
        if (part.name == "TIES") {
            EXPECT_TRUE(std::isnan(converted->mesh().density[e]));
        } else {
            EXPECT_NEAR(converted->mesh().density[e] / anim->mesh().density[e], 1.0, 1e-5) << part.name;
        }
        const auto id = idAt<ElementIndex>(e);
        if (!anim->activity().active(19, id)) {
            std::vector<Vec3> corners;
            for (const std::uint32_t node : anim->mesh().cornersOf(id)) {
                corners.push_back(anim->mesh().nodes[node]);
            }
            lost += anim->mesh().density[e] * elementVolume(anim->mesh().shapes[e], corners, anim->mesh().section[e]);
        }
    }
    // Mg to kg; what the file says of the masses of the dead: 21 bricks, 20 shells, 2 trusses.
    EXPECT_NEAR(lost, 1000.0 * (21 * 3.0e-4 + 20 * 3.6e-5 + 2 * 7.85e-4), 1e-5);
    int exact = 0;
    for (std::size_t e = 0; e < anim->mesh().elementCount(); ++e) {
        exact += !std::isnan(anim->contents().deathTime[e]);
    }
    EXPECT_EQ(exact, 21) << "every dead brick, and nothing else: the criterion of shells and trusses writes no time";
    EXPECT_EQ(anim->contents().findings.count("anim.death_time"), 0);
    EXPECT_EQ(anim->contents().findings.count("fe.units_declared"), 0);
    EXPECT_EQ(openFe(fixture("frame-anim"), {}, {}, Execution{})->contents().findings.count("fe.units_declared"), 1)
        << "the deck counts in mm";
}

TEST(AnimReader, ASmallConvertedFileIsRefusedAtEveryByte) {
    const TemporaryFolder folder;
    const std::string whole =
        "# vtk DataFile Version 3.0\nvtk output\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 2\nTIME 1 1 double\n0.5\n"
        "CYCLE 1 1 int\n0\nPOINTS 8 float\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\nCELLS 1 9\n8 0 1 2 3 4 5 6 7\n"
        "CELL_TYPES 1\n12\nPOINT_DATA 8\nSCALARS NODE_ID int 1\nLOOKUP_TABLE default\n1\n2\n3\n4\n5\n6\n7\n8\nCELL_DATA 1\n"
        "SCALARS ELEMENT_ID int 1\nLOOKUP_TABLE default\n17\nSCALARS PART_ID int 1\nLOOKUP_TABLE default\n1\n"
        "SCALARS EROSION_STATUS int 1\nLOOKUP_TABLE default\n1\n";
    putFile(folder / "X_001.vtk", whole);
    ASSERT_EQ(errorOf(folder / "X_001.vtk"), "");
    EXPECT_EQ(open(folder / "X_001.vtk")->contents().format, "OpenRadioss animation converted to VTK");
    for (std::size_t size = whole.size(); size-- > 0;) {
        std::filesystem::resize_file(folder / "X_001.vtk", size);
        ASSERT_NE(errorOf(folder / "X_001.vtk"), "") << size << " of " << whole.size();
    }
}

TEST(AnimReader, ConvertedFilesCutOffOrDamaged) {
    const TemporaryFolder folder;
    const std::string whole = wholeFile(fixture("frame-vtk/FRAMEA003.vtk"));
    const std::size_t header = whole.find("POINTS");
    // The head byte by byte, and through the tables at a stride that meets every section.
    for (std::size_t size = 1; size < whole.size(); size += size < header + 40 ? 1 : 211) {
        putFile(folder / "X_001.vtk", whole.substr(0, size));
        const std::string error = errorOf(folder / "X_001.vtk");
        const bool status = size > whole.find("1DELEM_");
        if (!status) {
            EXPECT_NE(error, "") << size << " of " << whole.size();
        }
    }
    putFile(folder / "X_001.vtk", whole);
    EXPECT_EQ(errorOf(folder / "X_001.vtk"), "");
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string damaged = whole;
        damaged.replace(damaged.find(from), from.size(), to);
        putFile(folder / "X_001.vtk", damaged);
        return errorOf(folder / "X_001.vtk");
    };
    EXPECT_THAT(with("POINTS 701", "POINTS 99999999999999"), AllOf(HasSubstr("points"), HasSubstr("expected")));
    EXPECT_THAT(with("POINTS 701", "POINTS 700"), HasSubstr("X_001.vtk"));
    EXPECT_THAT(with("CELLS 400", "CELLS 401"), HasSubstr("X_001.vtk"));
    EXPECT_THAT(with("CELL_DATA 400", "CELL_DATA 40"), HasSubstr("values of cells"));
    EXPECT_THAT(with("CELL_TYPES 400\n", "CELL_TYPES 400\n77\n"), HasSubstr("type of a cell"));
    EXPECT_THAT(with("EROSION_STATUS", "EROSION_STATES"), HasSubstr("EROSION_STATUS"));
}

}  // namespace

}  // namespace rubble::io
