#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "core/fe/components.h"
#include "io/fe/d3plot/d3plot_activity.h"
#include "io/fe/d3plot/d3plot_mesh.h"
#include "io/fe/fe_format.h"
#include "io/fe/fe_reader.h"
#include "io/fe/one_point_volume.h"
#include "tests/io/collapse_identity.h"
#include "tests/support/whole_file.h"

namespace rubble::io {

namespace {

using ::testing::Contains;
using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Pointwise;
using Counts = std::vector<std::int64_t>;

std::shared_ptr<const FeResult> open(const std::string& name, const Frame& frame = {}) {
    return openFe(fixture(name), {}, frame, Execution{});
}

std::vector<std::size_t> upTo(std::size_t count) {
    std::vector<std::size_t> states(count);
    std::iota(states.begin(), states.end(), std::size_t{0});
    return states;
}

const Counts slabDeaths{0, 0, 8, 23, 39, 54, 74, 97, 132, 161, 186, 203, 217, 222, 222, 222};

// The same collapse in formats of other readers and in every flavour, by one hash.
TEST(D3plotData, TheSameCollapseInEveryFlavourAndFormat) {
    const auto exodus = open("exodus/status1alive.exo");
    ASSERT_EQ(deadPerState(*exodus), slabDeaths);
    const Digest expected = collapseDigest(*exodus, upTo(16));
    const auto reference = exodus->state(9);
    for (const char* name :
         {"d3plot/le32-multi", "d3plot/be64-single", "d3plot/le64-rootstates", "d3plot/le32-mdlopt0", "d3plot/le32-extra64",
          "d3plot/le32-split", "d3plot/le32-mattyp-ndim5", "radioss-anim", "vtk-legacy-anim_to_vtk"}) {
        const auto fe = open(name);
        ASSERT_EQ(fe->stateCount(), 16u) << name;
        EXPECT_EQ(collapseDigest(*fe, upTo(16)), expected) << name;
        const auto state = fe->state(9);
        const bool text = std::string(name).starts_with("vtk");
        // Single precision keeps seven digits of lengths up to 15; the text keeps six.
        const double tolerance = text ? 1e-4 : 2e-6;
        for (std::size_t n = 0; n < exodus->mesh().nodeCount(); ++n) {
            ASSERT_NEAR((state->positions[n] - reference->positions[n]).norm(), 0.0, tolerance) << name << ", node " << n;
        }
        EXPECT_TRUE(fe->contents().hasVelocity) << name;
    }
}

TEST(D3plotData, TheNodeTableShowsWhatItCan) {
    const auto fe = open("d3plot/le32-mdlopt1-nodes");
    EXPECT_EQ(deadPerState(*fe).back(), 160) << "of 222: the others share nodes with living ones";
    const auto whole = open("d3plot/le32-multi");
    for (std::size_t e = 0; e < fe->mesh().elementCount(); ++e) {
        for (std::size_t k = 0; k < 16; ++k) {
            const auto id = idAt<ElementIndex>(e);
            EXPECT_TRUE(fe->activity().active(k, id) || !whole->activity().active(k, id)) << "nothing alive is called dead";
        }
    }
}

TEST(D3plotData, UserNumbersAndTitles) {
    const auto fe = open("d3plot/le64-rootstates");
    ASSERT_EQ(fe->mesh().parts.size(), 2u);
    EXPECT_EQ(fe->mesh().parts[0].fileId, 101);
    EXPECT_EQ(fe->mesh().parts[1].fileId, 205);
    EXPECT_EQ(open("d3plot/le32-multi")->mesh().parts[0].name, "Projectile");
}

TEST(D3plotData, FilesOfAnotherWriterWithAllKinds) {
    for (const char* name : {"d3plot/lasso-written-mixed", "d3plot/lasso-written-mixed-v960"}) {
        const auto fe = open(name);
        EXPECT_EQ(fe->stateCount(), 6u);
        EXPECT_EQ(fe->mesh().elementCount(), 48u);
        std::map<std::string, std::int64_t> dead;
        for (std::size_t e = 0; e < 48; ++e) {
            dead[fe->mesh().parts[fe->mesh().part[e]].name] += !fe->activity().active(5, idAt<ElementIndex>(e));
        }
        EXPECT_EQ(dead, (std::map<std::string, std::int64_t>{{"SOLIDS", 4}, {"TSHELLS", 2}, {"SHELLS", 3}, {"BEAMS", 1}})) << name;
        std::vector<std::int64_t> ids;
        for (const Part& part : fe->mesh().parts) {
            ids.push_back(part.fileId);
        }
        std::sort(ids.begin(), ids.end());
        EXPECT_EQ(ids, (std::vector<std::int64_t>{11, 22, 33, 44}));
    }
}

TEST(D3plotData, LongHeaderBricksAndBeams) {
    const auto fe = open("beam");
    EXPECT_EQ(fe->stateCount(), 12u);
    EXPECT_EQ(deadPerState(*fe), Counts(12, 0));
    std::map<ElementShape, int> shapes;
    for (const ElementShape shape : fe->mesh().shapes) {
        ++shapes[shape];
    }
    EXPECT_EQ(shapes[ElementShape::Hexahedron], 1512);
    EXPECT_EQ(shapes[ElementShape::Beam], 544);
    fe->state(11);
}

// What the solver says it has lost is what is dead, times density and volume: deletion, parts, volume and density at once.
TEST(D3plotData, OracleOfMasses) {
    Frame centimetres;
    centimetres.metresPerUnit = 0.01;
    const auto fe = open("projectile", centimetres);
    EXPECT_EQ(deadPerState(*fe), (Counts{0, 18, 137, 514, 614}));
    EXPECT_EQ(fe->mesh().parts[0].name, "Projectile");
    EXPECT_EQ(fe->mesh().parts[1].name, "Plate");
    // Input values of the analysis, g/cm3; the masses in the file have sixteen digits.
    EXPECT_NEAR(fe->mesh().density.front(), 18620.0, 1e-8);
    EXPECT_NEAR(fe->mesh().density.back(), 7896.0, 1e-8);

    const std::string root = fixture("projectile/d3plot");
    const D3plotFamily family(d3plotMembers(root), d3plotWordFormat(readHead(root)).value());
    const D3plotHeader header = readD3plotHeader(family);
    const D3plotGeometry geometry = readD3plotGeometry(family, header, Execution{});
    const D3plotStateLayout layout = layoutOfStates(family, header, geometry);
    const D3plotStates states = findD3plotStates(family, geometry, layout, Execution{});
    ASSERT_EQ(states.begin.size(), 5u);
    const std::vector<double> initial = d3plotPartMasses(family, header, states.begin[0]);
    const std::vector<double> published{0.0, 0.363632051, 1.965665258, 5.558650954, 6.667966832};  // g, part 1
    for (std::size_t k = 1; k < states.begin.size(); ++k) {
        const std::vector<double> now = d3plotPartMasses(family, header, states.begin[k]);
        std::vector<double> lost(2, 0.0);
        for (std::size_t e = 0; e < geometry.solids.count(); ++e) {
            if (fe->activity().active(k, idAt<ElementIndex>(e))) {
                continue;
            }
            std::vector<Vec3> corners;
            for (std::size_t i = 0; i < 8; ++i) {
                corners.push_back(geometry.nodes[static_cast<std::size_t>(geometry.solids.nodes[8 * e + i])]);
            }
            const auto part = static_cast<std::size_t>(geometry.solids.part[e]);
            lost[part] += 1e-3 * fe->mesh().density[e] * onePointVolume(corners);
        }
        EXPECT_NEAR(lost[0], published[k], 1e-9) << k;
        for (const std::size_t part : {0u, 1u}) {
            // The difference of two masses carries the rounding of the whole.
            const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * initial[part];
            EXPECT_NEAR(initial[part] - now[part], lost[part], 1e-12 * lost[part] + rounding) << "part " << part << ", state " << k;
        }
    }
}

}  // namespace

}  // namespace rubble::io
