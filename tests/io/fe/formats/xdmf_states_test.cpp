#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two bricks in a row; the second is dead from the second state on. What lies where in the file is up to the test.
class XdmfStatesTest : public testing::Test {
protected:
    std::shared_ptr<const FeResult> open(const std::string& domain, const std::string& attributes = "") {
        writeContent(m_folder / "wall.xdmf",
                     "<?xml version=\"1.0\"?><Xdmf Version=\"3.0\"" + attributes + "><Domain>" + domain + "</Domain></Xdmf>");
        return openFe(m_folder / "wall.xdmf", {}, {}, Execution{});
    }

    static std::vector<std::size_t> dead(const FeResult& fe) {
        std::vector<std::size_t> counts;
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            counts.push_back(fe.mesh().elementCount() - fe.activity().activeCount(k));
        }
        return counts;
    }

    TemporaryFolder m_folder;
};

const char* const topology =
    "<Topology TopologyType=\"Hexahedron\" NumberOfElements=\"2\"><DataItem Dimensions=\"2 8\" Format=\"XML\">"
    "0 4 5 1 3 7 6 2 4 8 9 5 7 11 10 6</DataItem></Topology>";
const char* const geometry =
    "<Geometry GeometryType=\"XYZ\"><DataItem Dimensions=\"12 3\" Format=\"XML\">0 0 0 0 1 0 0 1 1 0 0 1 1 0 0 1 1 0 1 1 1 1 0 1 "
    "2 0 0 2 1 0 2 1 1 2 0 1</DataItem></Geometry>";

std::string mesh() {
    return std::string("<Grid Name=\"mesh\" GridType=\"Uniform\">") + topology + geometry + "</Grid>";
}

std::string include(const std::string& prefix) {
    return "<" + prefix + "include xpointer=\"xpointer(//Grid[@Name='mesh']/*[self::Topology or self::Geometry])\"/>";
}

std::string alive(bool second) {
    return std::string("<Attribute Name=\"alive\" Center=\"Cell\"><DataItem Dimensions=\"2\" Format=\"XML\">1 ") +
           (second ? "1" : "0") + "</DataItem></Attribute>";
}

std::string fallen(double by) {
    std::string text =
        "<Attribute Name=\"displacement\" AttributeType=\"Vector\" Center=\"Node\"><DataItem Dimensions=\"12 3\" Format=\"XML\">";
    for (int n = 0; n < 12; ++n) {
        text += "0 0 " + std::to_string(-by) + " ";
    }
    return text + "</DataItem></Attribute>";
}

std::string grid(const std::string& within, const std::string& time = "") {
    return "<Grid GridType=\"Uniform\">" + within + (time.empty() ? "" : "<Time Value=\"" + time + "\"/>") + "</Grid>";
}

std::string collection(const std::string& within) {
    return "<Grid GridType=\"Collection\" CollectionType=\"Temporal\">" + within + "</Grid>";
}

TEST_F(XdmfStatesTest, AMeshBesideACollectionIsNoState) {
    const auto states = [](const std::string& prefix, double first) {
        std::string text;
        for (int k = 0; k < 3; ++k) {
            text += grid(include(prefix) + alive(k < 1), std::to_string(first + k));
        }
        return collection(text);
    };
    for (const char* prefix : {"xi:", "ns0:", "", "other:"}) {
        for (const double first : {0.0, 1.0}) {
            const auto before = open(mesh() + states(prefix, first));
            EXPECT_THAT(dead(*before), ElementsAre(0, 1, 1)) << prefix << first;
            EXPECT_THAT(before->times(), ElementsAre(first, first + 1, first + 2));
            EXPECT_THAT(dead(*open(states(prefix, first) + mesh())), ElementsAre(0, 1, 1)) << prefix << first;
        }
    }
}

TEST_F(XdmfStatesTest, CollectionsOfOneTimeAreOneSeriesWithAllArrays) {
    std::string flags, places;
    for (int k = 0; k < 3; ++k) {
        flags += grid(include("xi:") + alive(k < 1), std::to_string(k));
        places += grid(include("xi:") + fallen(0.1 * k), std::to_string(k));
    }
    for (const std::string& both : {collection(flags) + collection(places), collection(places) + collection(flags)}) {
        const auto fe = open(mesh() + both);
        EXPECT_THAT(dead(*fe), ElementsAre(0, 1, 1));
        EXPECT_NEAR(fe->state(2)->positions[0].z(), -0.2, 1e-9);
        EXPECT_EQ(fe->mesh().elementCount(), 2u);
    }
}

// Some writers store the mesh with every function.
TEST_F(XdmfStatesTest, EqualMeshesOfTwoFunctionsAreOne) {
    std::string flags, places;
    for (int k = 0; k < 3; ++k) {
        flags += grid(std::string(topology) + geometry + alive(k < 1), std::to_string(k));
        places += grid(std::string(topology) + geometry + fallen(0.1 * k), std::to_string(k));
    }
    const auto fe = open(collection(flags) + collection(places));
    EXPECT_EQ(fe->mesh().elementCount(), 2u);
    EXPECT_THAT(dead(*fe), ElementsAre(0, 1, 1));
}

TEST_F(XdmfStatesTest, TimesThatOneFunctionLacksAreNamed) {
    std::string flags, places;
    for (int k = 0; k < 5; ++k) {
        places += grid(include("xi:") + fallen(0.1 * k), std::to_string(k));
        if (k % 2 == 0) {
            flags += grid(include("xi:") + alive(k < 1), std::to_string(k));
        }
    }
    const auto fe = open(mesh() + collection(flags) + collection(places));
    EXPECT_THAT(fe->times(), ElementsAre(0, 2, 4));
    EXPECT_EQ(fe->contents().findings.count("xdmf.times_differ"), 2);
}

TEST_F(XdmfStatesTest, ACollectionWithTheSameArraysGoesOn) {
    const std::string first = grid(include("xi:") + alive(true), "0") + grid(include("xi:") + alive(false), "1");
    const std::string second = grid(include("xi:") + alive(true), "1") + grid(include("xi:") + alive(true), "2");
    const auto fe = open(mesh() + collection(first) + collection(second));
    EXPECT_THAT(fe->times(), ElementsAre(0, 1, 2));
    EXPECT_THAT(dead(*fe), ElementsAre(0, 0, 0));
    EXPECT_EQ(fe->contents().findings.count("fe.written_twice"), 1);
}

std::string named(const std::string& name, const std::string& within, double time) {
    return "<Grid Name=\"" + name + "\" GridType=\"Uniform\">" + within + "<Time Value=\"" + std::to_string(time) + "\"/></Grid>";
}

// One rule holds in all formats: the later states count. Both functions of a run go back, which is said once.
TEST_F(XdmfStatesTest, StatesThatARestartAbandonedAreLeftOutAndSaid) {
    std::string flags, places, goesOn;
    for (const double time : {0.0, 1.0, 2.0, 3.0, 1.5, 2.5}) {
        const bool restarted = time == 1.5 || time == 2.5;
        const std::string state = include("xi:") + alive(restarted || time < 2.0);
        (restarted ? goesOn : flags) += named("run", state, time);
        places += named("run", include("xi:") + fallen(0.1 * time), time);
    }
    for (const std::string& all :
         {collection(flags + goesOn), collection(flags) + collection(goesOn), collection(flags + goesOn) + collection(places)}) {
        const auto fe = open(mesh() + all);
        EXPECT_THAT(fe->times(), ElementsAre(0, 1, 1.5, 2.5));
        EXPECT_THAT(dead(*fe), ElementsAre(0, 0, 0, 0));
        EXPECT_EQ(fe->contents().findings.count("fe.abandoned"), 2);
        EXPECT_EQ(fe->contents().findings.count("xdmf.times_differ"), 0);
    }
}

TEST_F(XdmfStatesTest, GridsInTheOrderOfTheirNamesAreInDisorderOnly) {
    std::string text;
    for (const int k : {0, 1, 10, 2}) {
        text += named("step " + std::to_string(k), include("xi:") + alive(k < 2), 0.5 * k);
    }
    const auto fe = open(mesh() + collection(text));
    EXPECT_THAT(fe->times(), ElementsAre(0, 0.5, 1, 5));
    EXPECT_THAT(dead(*fe), ElementsAre(0, 0, 1, 1));
    EXPECT_EQ(fe->contents().findings.count("fe.abandoned"), 0);
}

/// One brick at a place along x, with points of its own.
std::string brick(int x, const std::string& arrays, const std::string& time = "") {
    std::string text =
        "<Topology TopologyType=\"Hexahedron\" NumberOfElements=\"1\"><DataItem Dimensions=\"1 8\" Format=\"XML\">0 1 2 3 4 5 6 7"
        "</DataItem></Topology><Geometry GeometryType=\"XYZ\"><DataItem Dimensions=\"8 3\" Format=\"XML\">";
    for (const int z : {0, 1}) {
        for (const auto& [right, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            text += std::to_string(x + right) + " " + std::to_string(y) + " " + std::to_string(z) + " ";
        }
    }
    return grid(text + "</DataItem></Geometry>" + arrays, time);
}

std::string flag(bool active) {
    return std::string("<Attribute Name=\"alive\" Center=\"Cell\"><DataItem Dimensions=\"1\" Format=\"XML\">") +
           (active ? "1" : "0") + "</DataItem></Attribute>";
}

std::string lowered(double by) {
    std::string text =
        "<Attribute Name=\"displacement\" AttributeType=\"Vector\" Center=\"Node\"><DataItem Dimensions=\"8 3\" Format=\"XML\">";
    for (int n = 0; n < 8; ++n) {
        text += "0 0 " + std::to_string(-by) + " ";
    }
    return text + "</DataItem></Attribute>";
}

std::string pieces(const std::string& within, const std::string& time = "") {
    return "<Grid GridType=\"Collection\" CollectionType=\"Spatial\">" + (time.empty() ? "" : "<Time Value=\"" + time + "\"/>") +
           within + "</Grid>";
}

TEST_F(XdmfStatesTest, SpatialCollectionsWithinATemporalOneAreStatesInPieces) {
    for (const bool inPieces : {false, true}) {
        std::string text;
        for (int k = 0; k < 3; ++k) {
            const std::string time = std::to_string(k + 1), own = inPieces ? time : "";
            text += pieces(brick(0, flag(true), own) + brick(1, flag(k < 1), own), inPieces ? "" : time);
        }
        const auto fe = open(collection(text));
        EXPECT_THAT(fe->times(), ElementsAre(1, 2, 3)) << inPieces;
        EXPECT_EQ(fe->contents().findings.count("vtk.no_times"), 0) << inPieces;
        EXPECT_EQ(fe->mesh().elementCount(), 2u) << inPieces;
        EXPECT_EQ(fe->mesh().nodeCount(), 12u) << inPieces;
        EXPECT_THAT(dead(*fe), ElementsAre(0, 1, 1)) << inPieces;
    }
}

// Some writers nest them the other way round: each piece has its course of time.
TEST_F(XdmfStatesTest, TemporalCollectionsWithinASpatialOneArePieces) {
    std::string left, right;
    for (int k = 0; k < 3; ++k) {
        left += brick(0, flag(true), std::to_string(k));
        right += brick(1, flag(k < 2), std::to_string(k));
    }
    const auto fe = open(pieces(collection(left) + collection(right)));
    EXPECT_EQ(fe->mesh().elementCount(), 2u);
    EXPECT_EQ(fe->mesh().nodeCount(), 12u);
    EXPECT_THAT(dead(*fe), ElementsAre(0, 0, 1));
}

// Two functions of a structure in pieces, one of them written less often: one does not go on with the other.
TEST_F(XdmfStatesTest, FunctionsInPiecesAreOneSeriesToo) {
    std::string flags, places;
    for (int k = 0; k < 5; ++k) {
        const std::string time = std::to_string(k);
        places += pieces(brick(0, lowered(0.1 * k)) + brick(1, lowered(0.1 * k)), time);
        if (k % 2 == 0) {
            flags += pieces(brick(0, flag(true)) + brick(1, flag(k < 2)), time);
        }
    }
    for (const std::string& both : {collection(flags) + collection(places), collection(places) + collection(flags)}) {
        const auto fe = open(both);
        EXPECT_THAT(fe->times(), ElementsAre(0, 2, 4));
        EXPECT_EQ(fe->contents().findings.count("xdmf.times_differ"), 2);
        EXPECT_EQ(fe->mesh().elementCount(), 2u);
        EXPECT_THAT(dead(*fe), ElementsAre(0, 1, 1));
        EXPECT_NEAR(fe->state(2)->positions[0].z() - fe->mesh().nodes[0].z(), -0.4, 1e-9);
    }
}

// Without temporal collections all grids of one time are a state; the domains of a file are one structure.
TEST_F(XdmfStatesTest, GridsThatNoCollectionOrdersAreStatesByTheirTimes) {
    const auto fe = open(brick(1, flag(false), "2") + brick(0, flag(true), "1") + "</Domain><Domain>" + brick(1, flag(true), "1") +
                         brick(0, flag(true), "2"));
    EXPECT_THAT(fe->times(), ElementsAre(1, 2));
    EXPECT_EQ(fe->mesh().elementCount(), 2u);
    EXPECT_THAT(dead(*fe), ElementsAre(0, 1));
}

TEST_F(XdmfStatesTest, WhatHasNoStateIsRefusedWithTheReason) {
    const auto errorOf = [this](const std::string& domain) {
        try {
            open(mesh() + domain);
        } catch (const Error& error) {
            EXPECT_FALSE(error.remedy().empty());
            return std::string(error.what());
        }
        return std::string("read");
    };
    const std::string states = grid(include("xi:") + alive(true), "0"), others = grid(include("xi:") + fallen(0.1), "1");
    EXPECT_THAT(errorOf(collection(states) + collection(others)), HasSubstr("no time in common"));
    EXPECT_THAT(errorOf(collection(grid(include("xi:") + alive(true), "soon"))), HasSubstr("\"soon\" of a grid is no number"));
    EXPECT_THAT(errorOf(collection("<Time TimeType=\"List\"><DataItem Dimensions=\"2\" Format=\"XML\">0 inf</DataItem></Time>" +
                                   grid(include("xi:") + alive(true)))),
                HasSubstr("times of a collection are no numbers"));
    EXPECT_THAT(errorOf(collection(grid("<xi:include xpointer=\"xpointer(//Grid[)\"/>" + alive(true), "0"))),
                HasSubstr("cannot be followed"));
    EXPECT_THAT(errorOf(collection(grid("<xi:include xpointer=\"xpointer(//Grid[@Name='gone'])\"/>" + alive(true), "0"))),
                HasSubstr("no topology"));
    EXPECT_THAT(errorOf(collection(grid("<Topology Reference=\"/Xdmf/Domain/Nothing\"/>" + alive(true), "0"))),
                HasSubstr("leads nowhere"));
    EXPECT_THAT(errorOf("<Topology Name=\"a\" Reference=\"/Xdmf/Domain/Topology[@Name='a']\"/>" +
                        collection(grid("<Topology Reference=\"/Xdmf/Domain/Topology\"/>" + alive(true), "0"))),
                HasSubstr("leads nowhere"));
}

TEST_F(XdmfStatesTest, ACollectionMaySayItsTimesAtOnce) {
    const std::string states = grid(include("xi:") + alive(true)) + grid(include("xi:") + alive(false));
    const auto times = [](const std::string& type, const std::string& values) {
        return "<Time TimeType=\"" + type + "\"><DataItem Dimensions=\"" + (type == "List" ? "2" : "3") + "\" Format=\"XML\">" +
               values + "</DataItem></Time>";
    };
    EXPECT_THAT(open(mesh() + collection(times("List", "0.5 2.5") + states))->times(), ElementsAre(0.5, 2.5));
    EXPECT_THAT(open(mesh() + collection(times("HyperSlab", "0.5 0.25 2") + states))->times(), ElementsAre(0.5, 0.75));
    const auto counted = open(mesh() + collection(states));
    EXPECT_THAT(counted->times(), ElementsAre(0, 1));
    EXPECT_EQ(counted->contents().findings.count("vtk.no_times"), 2);
}

// The mesh alone comes first: the flag is sought at the last state too.
TEST_F(XdmfStatesTest, AFlagMayBeginLater) {
    const auto fe = open(mesh() + collection(grid(include("xi:"), "0") + grid(include("xi:") + alive(true), "1") +
                                             grid(include("xi:") + alive(false), "2")));
    EXPECT_THAT(dead(*fe), ElementsAre(0, 0, 1));
}

TEST_F(XdmfStatesTest, PartsMayReferToOthers) {
    const std::string parts = std::string("<Topology Name=\"t\"") + (topology + 9) + geometry;
    const std::string refers = "<Topology Reference=\"/Xdmf/Domain/Topology\"/><Geometry Reference=\"/Xdmf/Domain/Geometry\"/>";
    EXPECT_THAT(dead(*open(parts + collection(grid(refers + alive(true), "0") + grid(refers + alive(false), "1")))),
                ElementsAre(0, 1));
    // The items alone, by an attribute or by a text.
    const std::string item = "/Xdmf/Domain/Topology/DataItem";
    for (const std::string& refersTo :
         {"<DataItem Reference=\"" + item + "\"/>", "<DataItem Reference=\"XML\"> " + item + " </DataItem>"}) {
        const std::string within = "<Topology TopologyType=\"Hexahedron\" NumberOfElements=\"2\">" + refersTo +
                                   "</Topology><Geometry Reference=\"/Xdmf/Domain/Geometry\"/>";
        EXPECT_THAT(dead(*open(parts + collection(grid(within + alive(true), "0") + grid(within + alive(false), "1")))),
                    ElementsAre(0, 1));
    }
}

}  // namespace
}  // namespace rubble::io
