#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/fe/frame_transform.h"
#include "io/fe/d3plot/d3plot_header.h"
#include "io/fe/fe_format.h"
#include "io/fe/fe_reader.h"
#include "tests/io/collapse_identity.h"
#include "tests/io/fe/d3plot/d3plot_builder.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Counts = std::vector<std::int64_t>;

class D3plotReader : public ::testing::Test {
protected:
    std::shared_ptr<const FeResult> open(const D3plotBuilder& builder, const std::string& name = "d3plot",
                                         const Frame& frame = {}) {
        builder.write(m_folder / name);
        return openFe(m_folder / name, {}, frame, Execution{});
    }

    std::string errorOf(const D3plotBuilder& builder) {
        try {
            open(builder);
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("d3plot"));
            return englishText(error.message()) + " | " + englishText(error.remedy());
        }
        ADD_FAILURE() << "no error";
        return {};
    }

    TemporaryFolder m_folder;
};

// Every kind of element at once, with deaths in all of them.
D3plotBuilder everyKind() {
    D3plotBuilder builder;
    builder.cubes = 4;
    builder.thickShells = 3;
    builder.shells = 3;
    builder.beams = 2;
    builder.particles = 2;
    builder.times = {0.0, 0.5, 1.0, 1.5, 2.0};
    builder.deaths = {{1, 2}, {5, 3}, {8, 1}, {10, 4}, {11, 3}};
    builder.particleDeaths = {{1, 2}};
    return builder;
}

// A d3plot begins with its title, and words behind that are all that it is known by: those of files of OpenSees came to one.
TEST_F(D3plotReader, WhatBeginsAsAnotherContainerIsNone) {
    const std::string path = m_folder / "d3plot";
    everyKind().write(path);
    ASSERT_TRUE(recognisesD3plot(readHead(path)));
    for (const std::string& begins : {std::string("\x89HDF\r\n\x1a\n"), std::string("CDF\x01"), std::string("PK\x03\x04")}) {
        std::fstream(path, std::ios::in | std::ios::out | std::ios::binary) << begins;
        EXPECT_FALSE(recognisesD3plot(readHead(path))) << begins;
    }
}

TEST_F(D3plotReader, EveryKindOfElementInEveryWordFormat) {
    std::optional<Digest> first;
    for (const std::int64_t bytes : {4, 8}) {
        for (const bool bigEndian : {false, true}) {
            D3plotBuilder builder = everyKind();
            builder.format = {bytes, bigEndian};
            const auto fe = open(builder, "d3plot" + std::to_string(bytes) + (bigEndian ? "be" : "le"));
            const Mesh& mesh = fe->mesh();
            EXPECT_THAT(mesh.elementIds, ElementsAre(101, 102, 103, 104, 201, 202, 203, 301, 302, 401, 402, 403, 1001, 1009));
            EXPECT_EQ(mesh.nodeCount(), 32u + 2 * 8);
            EXPECT_THAT(fe->times(), ElementsAre(0.0, 0.5, 1.0, 1.5, 2.0));
            EXPECT_EQ(deadPerState(*fe), (Counts{0, 1, 3, 5, 6}));
            const auto dies = [&](std::size_t element, std::size_t state) {
                const auto id = idAt<ElementIndex>(element);
                EXPECT_TRUE(fe->activity().active(state - 1, id)) << element;
                EXPECT_FALSE(fe->activity().active(state, id)) << element;
            };
            dies(1, 2);      // the second cube
            dies(5, 3);      // entry 5 of the table: the second thick shell
            dies(7 + 3, 1);  // entry 8: the second shell, behind the beams in the mesh
            dies(7, 4);      // entry 10: the first beam
            dies(8, 3);      // entry 11: the second beam
            dies(13, 2);     // a particle
            const Digest digest = collapseDigest(*fe, {0, 1, 2, 3, 4});
            EXPECT_EQ(digest, first.value_or(digest));
            first = digest;
        }
    }
}

// Word 54 counts the particles of airbags, or says above ten millions that there are discrete elements.
TEST_F(D3plotReader, DiscreteElementsAreNamedAndTheRestIsRead) {
    D3plotBuilder builder = everyKind();
    const auto without = open(builder);
    EXPECT_EQ(without->contents().findings.count("d3plot.spheres"), 0);
    builder.words = {{54, 10'000'001}};
    const auto fe = open(builder, "spheres");
    EXPECT_EQ(fe->contents().findings.count("d3plot.spheres"), 1);
    EXPECT_EQ(collapseDigest(*fe, {0, 1, 2, 3, 4}), collapseDigest(*without, {0, 1, 2, 3, 4}));
    builder.words = {{54, 10'000'000}};
    EXPECT_THAT(errorOf(builder), HasSubstr("the word on airbags"));
}

TEST_F(D3plotReader, PartsNumbersTitlesAndWhatElementsAreMadeOf) {
    const auto fe = open(everyKind());
    const Mesh& mesh = fe->mesh();
    ASSERT_EQ(mesh.parts.size(), 5u) << "the rigid part has no elements";
    EXPECT_EQ(mesh.parts[0].name, "part number 1");
    EXPECT_EQ(mesh.parts[0].fileId, 10);
    EXPECT_EQ(mesh.parts[4].name, "part number 6");
    EXPECT_EQ(mesh.nodeIds.front(), 1001);
    EXPECT_EQ(mesh.shapes[4], ElementShape::Hexahedron) << "a thick shell";
    for (const std::size_t e : {0u, 4u, 9u, 12u}) {
        EXPECT_NEAR(mesh.density[e], D3plotBuilder::density, 1e-6) << e;
    }
    EXPECT_TRUE(std::isnan(mesh.density[7])) << "the section of beams is not in the file, so their density is not either";
    EXPECT_TRUE(std::isnan(mesh.section[7]));
    EXPECT_FLOAT_EQ(static_cast<float>(mesh.section[9]), 0.25f);
    // A particle is a cube of its volume around its node.
    const auto corners = mesh.cornersOf(idAt<ElementIndex>(12));
    const Vec3 diagonal = mesh.nodes[corners[6]] - mesh.nodes[corners[0]];
    EXPECT_NEAR(diagonal.prod(), D3plotBuilder::particleVolume, 1e-6);
    EXPECT_NEAR((0.5 * (mesh.nodes[corners[6]] + mesh.nodes[corners[0]]) - mesh.nodes[0]).norm(), 0.0, 1e-6);
}

TEST_F(D3plotReader, TheKeywordDeckSaysWhatTheFamilyCannot) {
    D3plotBuilder builder = everyKind();
    const auto without = open(builder);
    std::ofstream(m_folder / "include.k")
        << "*KEYWORD\n*SECTION_BEAM_TITLE\na tie\n        30         1       1.0         2         0\n"
           "      0.02      0.02      0.05      0.05\n*END\n";
    std::filesystem::rename(m_folder / "include.k", m_folder / "beams.inc");
    std::ofstream(m_folder / "bridge.k")
        << "$ comment\n*KEYWORD\n*INCLUDE\nbeams.inc\n*PART\nties\n        30        30         7         0\n"
           "*MAT_ELASTIC\n         7      7850       2.0       0.3\n*PART\nskin\n50,50,8\n*SECTION_SHELL\n"
           "        50         2       1.0         2\n       0.3       0.3\n*END\n";
    const auto with = open(builder);
    EXPECT_EQ(with->contents().files.back(), m_folder / "bridge.k");
    EXPECT_NE(with->contents().fingerprint, without->contents().fingerprint);
    EXPECT_NEAR(with->mesh().section[7], 0.001, 1e-12) << "0.02 x 0.05";
    // The mass of the beams is in the family: with their section known their density follows from it, 1 over 2 x 0.001.
    EXPECT_NEAR(with->mesh().density[7], 500.0, 1e-6);
    std::ofstream(m_folder / "second.key") << "*KEYWORD\n";
    EXPECT_TRUE(std::isnan(open(everyKind())->mesh().section[7])) << "of two decks none is taken";
}

TEST_F(D3plotReader, PlacesAndVelocitiesInTheFrameOfTheCase) {
    Frame frame;
    frame.metresPerUnit = 0.01;
    frame.upAxis = "y";
    frame.origin = {1, 0, 0};
    D3plotBuilder builder = everyKind();
    const auto fe = open(builder, "d3plot", frame);
    const auto state = fe->state(3);
    const FrameTransform transform(frame);
    const std::vector<Vec3> nodes = builder.nodes();
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        EXPECT_NEAR((state->positions[n] - transform.point(nodes[n] + Vec3(1.5, 0, 0))).norm(), 0.0, 1e-8);
        EXPECT_NEAR((state->velocities[n] - transform.vector(Vec3(1, 2, 3))).norm(), 0.0, 1e-8);
    }
    EXPECT_NEAR(fe->mesh().density[0], 2500.0, 1e-3) << "2.5 g/cm3";
    EXPECT_NEAR(fe->mesh().section[9], 0.0025, 1e-8);
}

TEST_F(D3plotReader, DisplacementsAndNoPlacesAtAll) {
    D3plotBuilder builder;
    const auto absolute = open(builder, "absolute");
    builder.coordinates = 2;
    const auto displaced = open(builder, "displaced");
    EXPECT_EQ(absolute->state(2)->positions, displaced->state(2)->positions);
    builder.coordinates = 0;
    builder.velocities = false;
    builder.temperature = 1;
    const auto still = open(builder, "still");
    EXPECT_EQ(still->state(2)->positions, still->state(0)->positions);
    EXPECT_TRUE(still->state(2)->velocities.empty());
    EXPECT_EQ(still->contents().findings.count("d3plot.no_coordinates"), 1);
}

TEST_F(D3plotReader, OptionsOfDeletionAgreeOnWhatEachCanSee) {
    D3plotBuilder builder;
    builder.cubes = 5;
    builder.times = {0, 1, 2, 3};
    builder.deaths = {{0, 2}, {3, 3}};
    for (const int option : {0, 1, 2}) {
        builder.deletionOption = option;
        const auto fe = open(builder, "option" + std::to_string(option));
        EXPECT_EQ(deadPerState(*fe), (Counts{0, 0, 1, 2})) << option;
        EXPECT_THAT(fe->contents().activityFrom, HasSubstr("MDLOPT " + std::to_string(option)));
    }
    EXPECT_EQ(openFe(m_folder / "option0", {}, {}, Execution{})->contents().findings.count("d3plot.inferred"), 1);
    EXPECT_EQ(openFe(m_folder / "option1", {}, {}, Execution{})->contents().findings.count("d3plot.node_table"), 1);
}

TEST_F(D3plotReader, StressTellsTheDeathsOfEveryKind) {
    D3plotBuilder builder = everyKind();
    builder.deletionOption = 0;
    builder.dimension = 5;
    builder.rigidShells = 1;
    const auto fe = open(builder);
    // The third shell is rigid and leaves no row; the others keep theirs.
    EXPECT_EQ(deadPerState(*fe), (Counts{0, 0, 2, 4, 5}))
        << "the second shell dies before it ever carried stress: that cannot be seen";
    EXPECT_TRUE(std::isnan(fe->mesh().section[11])) << "a rigid shell has no thickness in the states";
    EXPECT_NEAR(fe->mesh().section[10], 0.25, 1e-6);
}

TEST_F(D3plotReader, RigidIsNotDead) {
    D3plotBuilder builder = everyKind();
    builder.dimension = 5;
    builder.rigidShells = 2;
    const auto fe = open(builder);
    EXPECT_EQ(deadPerState(*fe), (Counts{0, 1, 3, 5, 6}));
    EXPECT_EQ(fe->mesh().parts[fe->mesh().part[11]].name, "part number 5");
}

TEST_F(D3plotReader, NodalArraysAndLongHeadersAreStridden) {
    std::optional<std::vector<Vec3>> expected;
    for (const std::int64_t temperature : {0, 1, 2, 3, 10, 11, 13}) {
        for (const std::int64_t extra : {0, 64}) {
            D3plotBuilder builder;
            builder.temperature = temperature;
            builder.extraWords = extra;
            builder.deaths = {{1, 1}};
            const auto fe = open(builder, "t" + std::to_string(temperature) + "_" + std::to_string(extra) + "x");
            EXPECT_EQ(deadPerState(*fe), (Counts{0, 1, 1}));
            const auto state = fe->state(2);
            EXPECT_EQ(state->positions, expected.value_or(state->positions));
            EXPECT_EQ(state->velocities[5], Vec3(1, 2, 3));
            expected = state->positions;
        }
    }
}

TEST_F(D3plotReader, StatesInTheRootAndStatesLongerThanAFile) {
    D3plotBuilder builder = everyKind();
    const Digest expected = collapseDigest(*open(builder, "plain"), {0, 1, 2, 3, 4});
    builder.statesInRoot = 2;
    EXPECT_EQ(collapseDigest(*open(builder, "inroot"), {0, 1, 2, 3, 4}), expected);
    builder.statesInRoot = 0;
    builder.titles = false;
    builder.statesPerFile = 1;
    for (const std::size_t words : {64u, 100u, 127u}) {
        builder.fileWords = words;
        ASSERT_GT(builder.stateWords(), words);
        const auto fe = open(builder, "split" + std::to_string(words) + "x");
        EXPECT_EQ(collapseDigest(*fe, {0, 1, 2, 3, 4}), expected) << words;
        EXPECT_GT(fe->contents().files.size(), 10u);
    }
}

TEST_F(D3plotReader, AnyMemberOpensTheWholeFamilyByNumberNotByText) {
    D3plotBuilder builder;
    builder.statesPerFile = 1;
    builder.times.clear();
    for (int k = 0; k < 105; ++k) {
        builder.times.push_back(0.5 * k);
    }
    const auto fe = open(builder, "BRIDGE.d3plot");
    EXPECT_EQ(fe->stateCount(), 105u);
    EXPECT_EQ(fe->contents().files.size(), 106u);
    EXPECT_EQ(std::filesystem::path(fe->contents().files.back()).filename(), "BRIDGE.d3plot105");
    for (const char* member : {"/BRIDGE.d3plot07", "/BRIDGE.d3plot22", "/BRIDGE.d3plot100", ""}) {
        const auto other = openFe(m_folder.path() + member, {}, {}, Execution{});
        EXPECT_EQ(other->contents().fingerprint, fe->contents().fingerprint) << member;
        EXPECT_EQ(other->contents().sha256, sha256OfFe(m_folder.path() + member));
    }
}

TEST_F(D3plotReader, AMissingNumberEndsTheFamilyAndIsSaid) {
    D3plotBuilder builder;
    builder.statesPerFile = 1;
    builder.times = {0, 1, 2, 3, 4};
    builder.write(m_folder / "d3plot");
    std::filesystem::remove(m_folder / "d3plot03");
    const auto fe = openFe(m_folder / "d3plot", {}, {}, Execution{});
    EXPECT_EQ(fe->stateCount(), 2u);
    EXPECT_EQ(fe->contents().findings.count("d3plot.left_behind"), 2);
    // Without the first file nobody can tell what the others hold.
    std::filesystem::remove(m_folder / "d3plot");
    try {
        openFe(m_folder / "d3plot04", {}, {}, Execution{});
        FAIL();
    } catch (const ParseError& error) {
        EXPECT_THAT(englishText(error.remedy()), ::testing::HasSubstr("the first file of the family, d3plot, beside it"));
    }
}

TEST_F(D3plotReader, AFamilyBeingWrittenOpensUpToItsLastCompleteState) {
    D3plotBuilder builder;
    builder.times = {0, 1, 2, 3};
    const std::vector<std::string> files = builder.files();
    ASSERT_EQ(files.size(), 3u);
    const std::size_t state = builder.stateWords() * 4;
    std::ofstream(m_folder / "d3plot", std::ios::binary) << files[0];
    std::ofstream(m_folder / "d3plot01", std::ios::binary) << files[1];
    std::ofstream(m_folder / "d3plot02", std::ios::binary) << files[2].substr(0, state + state / 2);
    const auto before = openFe(m_folder / "d3plot", {}, {}, Execution{});
    EXPECT_EQ(before->times(), (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(before->contents().findings.count("d3plot.incomplete"), 1);
    EXPECT_FALSE(hasGrown(*before));
    std::ofstream(m_folder / "d3plot02", std::ios::binary) << files[2];
    EXPECT_TRUE(hasGrown(*before));
    const auto after = openFe(m_folder / "d3plot", {}, {}, Execution{});
    EXPECT_FALSE(hasGrown(*after));
    EXPECT_EQ(after->times(), (std::vector<double>{0, 1, 2, 3}));
    EXPECT_NE(after->contents().fingerprint, before->contents().fingerprint);
    EXPECT_EQ(before->state(2)->positions, after->state(2)->positions) << "what was opened before still reads";
    std::filesystem::resize_file(m_folder / "d3plot02", 100);
    EXPECT_THROW(after->state(3), ParseError);
}

TEST_F(D3plotReader, ForeignMembersAndAbandonedStatesAreLeftOut) {
    D3plotBuilder builder;
    builder.statesPerFile = 1;
    builder.times = {0, 1, 1, 2, 1.5, 3};
    const auto fe = open(builder);
    EXPECT_EQ(fe->times(), (std::vector<double>{0, 1, 1.5, 3}));
    EXPECT_EQ(fe->contents().findings.count("fe.written_twice"), 1);
    EXPECT_EQ(fe->contents().findings.count("fe.abandoned"), 1);
    // A member of another analysis in the middle, whose states are shorter.
    builder.times = {0, 1, 2, 3};
    builder.write(m_folder / "d3plot");
    std::filesystem::remove(m_folder / "d3plot05");
    std::filesystem::remove(m_folder / "d3plot06");
    std::filesystem::resize_file(m_folder / "d3plot02", 200);
    const auto cut = openFe(m_folder / "d3plot", {}, {}, Execution{});
    EXPECT_EQ(cut->times(), (std::vector<double>{0, 2, 3}));
    EXPECT_EQ(cut->contents().findings.count("d3plot.cut_state"), 1);
}

TEST_F(D3plotReader, AFileOfAnotherAnalysisIsLeftOutWhateverItsLength) {
    D3plotBuilder builder = everyKind();
    builder.statesPerFile = 1;
    builder.write(m_folder / "d3plot");
    for (const std::int64_t cubes : {3, 5, 9, 20}) {
        D3plotBuilder foreign = everyKind();
        foreign.cubes = cubes;
        foreign.statesPerFile = 5;
        foreign.times = {1.1e6, 1.2e6, 1.3e6, 1.4e6, 1.5e6};
        std::ofstream(m_folder / "d3plot03", std::ios::binary) << foreign.files()[1];
        const auto fe = openFe(m_folder / "d3plot", {}, {}, Execution{});
        EXPECT_EQ(fe->times(), (std::vector<double>{0, 0.5, 1.5, 2})) << cubes;
        EXPECT_EQ(fe->contents().findings.count("d3plot.foreign_file"), 1) << cubes;
    }
}

TEST_F(D3plotReader, AFileOfAnotherWordFormatIsLeftOut) {
    for (const WordFormat own : {WordFormat{4, false}, WordFormat{4, true}, WordFormat{8, false}, WordFormat{8, true}}) {
        for (const WordFormat other : {WordFormat{4, false}, WordFormat{4, true}, WordFormat{8, false}, WordFormat{8, true}}) {
            if (own.bytes == other.bytes && own.bigEndian == other.bigEndian) {
                continue;
            }
            D3plotBuilder builder = everyKind();
            builder.format = own;
            builder.statesPerFile = 1;
            builder.write(m_folder / "d3plot");
            D3plotBuilder foreign = everyKind();
            foreign.format = other;
            foreign.cubes = 20;
            foreign.statesPerFile = 5;
            foreign.times = {1.1e6, 1.2e6, 1.3e6, 1.4e6, 1.5e6};
            std::ofstream(m_folder / "d3plot03", std::ios::binary) << foreign.files()[1];
            const auto fe = openFe(m_folder / "d3plot", {}, {}, Execution{});
            EXPECT_EQ(fe->times(), (std::vector<double>{0, 0.5, 1.5, 2})) << own.bytes << own.bigEndian << other.bytes;
            EXPECT_EQ(fe->contents().findings.count("d3plot.foreign_file"), 1) << own.bytes << other.bytes;
        }
    }
}

// One that is shorter than a state is no state that is still being written: it has its end mark.
TEST_F(D3plotReader, AShortFileOfAnotherAnalysisAtTheEndIsNotCalledUnfinished) {
    D3plotBuilder builder = everyKind();
    builder.statesPerFile = 1;
    builder.write(m_folder / "d3plot");
    D3plotBuilder foreign;
    foreign.statesPerFile = 1;
    foreign.times = {1.1e6};
    ASSERT_LT(foreign.stateWords(), builder.stateWords());
    std::ofstream(m_folder / "d3plot05", std::ios::binary) << foreign.files()[1];
    const auto fe = openFe(m_folder / "d3plot", {}, {}, Execution{});
    EXPECT_EQ(fe->times(), (std::vector<double>{0, 0.5, 1, 1.5}));
    EXPECT_EQ(fe->contents().findings.count("d3plot.foreign_file"), 1);
    EXPECT_EQ(fe->contents().findings.count("d3plot.incomplete"), 0);
}

TEST_F(D3plotReader, KindsAndOptionsThatAreNotReadAreNamed) {
    const auto with = [](std::size_t word, std::int64_t value) {
        D3plotBuilder builder;
        builder.words[word] = value;
        return builder;
    };
    EXPECT_THAT(errorOf(with(11, -1)), HasSubstr("DATABASE_EXTENT_BINARY_COMP"));
    EXPECT_THAT(errorOf(with(11, 4)), HasSubstr("interface forces"));
    EXPECT_THAT(errorOf(with(11, 3)), HasSubstr("time histories"));
    EXPECT_THAT(errorOf(with(11, 11)), HasSubstr("eigenvectors"));
    EXPECT_THAT(errorOf(with(15, 2)), HasSubstr("two dimensions"));
    EXPECT_THAT(errorOf(with(15, 3)), HasSubstr("packs three"));
    EXPECT_THAT(errorOf(with(15, 8)), HasSubstr("rigid bodies"));
    EXPECT_THAT(errorOf(with(48, 1)), HasSubstr("flow"));
    D3plotBuilder higher;
    higher.extraWords = 32;
    higher.words[74] = 1;
    EXPECT_THAT(errorOf(higher), HasSubstr("higher order"));
}

TEST_F(D3plotReader, AWrongNumberSectionCostsTheNumbersOnly) {
    D3plotBuilder builder;
    builder.words[39] = 12;  // shorter than what it should hold
    builder.statesInRoot = 0;
    builder.numbers = false;
    const auto fe = open(builder);
    EXPECT_THAT(fe->mesh().elementIds, ElementsAre(1, 2));
}

TEST_F(D3plotReader, CancelIsObeyed) {
    D3plotBuilder().write(m_folder / "d3plot");
    const Execution execution;
    execution.cancel();
    EXPECT_THROW(openFe(m_folder / "d3plot", {}, {}, execution), Cancelled);
}

}  // namespace

}  // namespace rubble::io
