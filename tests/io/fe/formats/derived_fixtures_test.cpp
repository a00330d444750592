#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "io/fe/fe_reader.h"
#include "tests/io/fe/formats/collapse_digest.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

constexpr std::array<std::size_t, 16> deadOfAll{0, 0, 8, 23, 39, 54, 74, 97, 132, 161, 186, 203, 217, 222, 222, 222};

// Bricks of the projectile come first, then those of the plate.
constexpr std::int64_t lastOfProjectile = 1864;

// For a format that has no displacements.
constexpr double atRestOnly = std::numeric_limits<double>::infinity();

/// What a fixture says of masses. The d3plots and animation files of the slab carry masses of whole parts, not those of the slab.
enum class Masses { None, Stated, OfWholeParts };

/// One file of the collapse and what it can tell.
struct Derived {
    std::string name;
    std::string file;
    std::string format;
    std::size_t states;
    double precision;  ///< of places, cm
    Masses masses = Masses::Stated;
    std::vector<std::int64_t> left = {};  ///< elements that only this fixture has
    ImportSettings settings = {};
};

void PrintTo(const Derived& derived, std::ostream* out) {
    *out << derived.name;
}

// Places are floats of up to 30 cm in most files (2e-6); six digits in the legacy VTK files (1e-4).
std::vector<Derived> allDerived() {
    return {
        {"VtuFlagged", "vtu-status/series.pvd", "VTK XML", 16, 1e-5},
        {"VtuRemoved", "vtu-cells-removed/s.vtu.series", "VTK XML", 16, 1e-5},
        {"VtkHdf", "vtkhdf/transient20.vtkhdf", "VTKHDF", 16, 1e-5, Masses::None},
        {"Xdmf", "xdmf/proj.xdmf", "XDMF", 16, 1e-5, Masses::None},
        {"ExodusZeroIsAlive", "exodus/elem_status0alive.exo", "Exodus II", 16, 1e-5, Masses::None},
        {"ExodusDeathStatus", "exodus/death_status.exo", "Exodus II", 16, 1e-5, Masses::None},
        {"ExodusSequence", "exodus/seq.e-s0004", "Exodus II", 16, 1e-5, Masses::None},
        {"AbaqusAscii", "abaqus-fil/proj_ascii.fil", "Abaqus results file", 6, 1e-5},
        {"AbaqusBinary", "abaqus-fil/proj_binle.fil", "Abaqus results file", 6, 1e-5},
        {"MarcRemoved", "marc/proj_removed.t19", "MSC Marc post file", 6, 1e-4, Masses::None},
        {"MarcKept", "marc/proj_kept.t19", "MSC Marc post file", 6, 1e-4, Masses::None},
        {"AnsysDatabases", "ansys-cdb/proj_03.cdb", "Ansys coded database", 6, atRestOnly},
        {"D3plotBe64Single", "d3plot/be64-single/d3plot", "LS-DYNA d3plot", 16, 1e-5, Masses::OfWholeParts},
        {"D3plotLe32Multi", "d3plot/le32-multi/d3plot", "LS-DYNA d3plot", 16, 1e-5, Masses::OfWholeParts},
        {"D3plotLe64Rootstates", "d3plot/le64-rootstates/d3plot", "LS-DYNA d3plot", 16, 1e-5, Masses::OfWholeParts},
        {"D3plotLe32Extra64", "d3plot/le32-extra64/d3plot", "LS-DYNA d3plot", 16, 1e-5, Masses::OfWholeParts},
        {"D3plotLe32Split", "d3plot/le32-split/d3plot", "LS-DYNA d3plot", 16, 1e-5, Masses::OfWholeParts},
        {"D3plotLe32MattypNdim5", "d3plot/le32-mattyp-ndim5/d3plot", "LS-DYNA d3plot", 16, 1e-5, Masses::OfWholeParts},
        {"D3plotLe32Mdlopt0", "d3plot/le32-mdlopt0/d3plot", "LS-DYNA d3plot", 16, 1e-5, Masses::OfWholeParts},
        {"RadiossAnimation", "radioss-anim/PROJA001", "OpenRadioss animation", 16, 1e-5, Masses::OfWholeParts, {900001}},
        {"VtkLegacy",
         "vtk-legacy-anim_to_vtk/PROJ_001.vtk",
         "OpenRadioss animation converted to VTK",
         16,
         2e-4,
         Masses::None,
         {900001}},
    };
}

class DerivedFixture : public testing::TestWithParam<Derived> {
protected:
    static std::shared_ptr<const FeResult> reference() {
        static const auto fe = openFe(fixture("exodus/status1alive.exo"), {}, {}, Execution{});
        return fe;
    }

    void SetUp() override { m_fe = openFe(fixture(GetParam().file), GetParam().settings, {}, Execution{}); }

    std::shared_ptr<const FeResult> m_fe;
};

TEST_P(DerivedFixture, IsRecognisedByItsContent) {
    EXPECT_EQ(m_fe->contents().format, GetParam().format);
    EXPECT_EQ(m_fe->stateCount(), GetParam().states);
}

TEST_P(DerivedFixture, HasTheElementsAndComponentsOfTheCollapse) {
    EXPECT_EQ(CollapseDigest(*m_fe, GetParam().left).elements(), CollapseDigest(*reference()).elements());
}

TEST_P(DerivedFixture, HasTheDeadOfTheCollapseAtEveryState) {
    const CollapseDigest own(*m_fe, GetParam().left), theirs(*reference());
    for (std::size_t k = 0; k < m_fe->stateCount(); ++k) {
        const std::size_t state = theirs.stateAt(m_fe->times()[k]);
        ASSERT_LT(state, reference()->stateCount()) << "no state at " << m_fe->times()[k];
        EXPECT_EQ(own.deadCount(k), deadOfAll[state]) << "state " << k;
        EXPECT_EQ(own.dead(k), theirs.dead(state)) << "state " << k;
    }
}

TEST_P(DerivedFixture, HasTheElementsWhereTheyAre) {
    const CollapseDigest own(*m_fe, GetParam().left), theirs(*reference());
    // Last first: a state is read without the others.
    for (std::size_t k = m_fe->stateCount(); k-- > 0;) {
        const std::size_t state = theirs.stateAt(m_fe->times()[k]);
        ASSERT_LT(state, reference()->stateCount()) << "no state at " << m_fe->times()[k];
        const double precision = k == 0 && GetParam().precision == atRestOnly ? 1e-5 : GetParam().precision;
        EXPECT_LE(own.distance(k, theirs, state), precision) << "state " << k;
    }
}

TEST_P(DerivedFixture, HasTheMassesOrSaysThatItHasNone) {
    const auto own = CollapseDigest(*m_fe, GetParam().left).masses();
    const auto theirs = CollapseDigest(*reference()).volumes();
    ASSERT_EQ(own.size(), theirs.size());
    for (const auto& [number, mass] : own) {
        // The densities are those that the masses in the d3plot give; bricks of 0.1 cm with places to 1e-5 cm at the worst.
        const double volume = theirs.at(number), density = number <= lastOfProjectile ? 18.62 : 7.896;
        if (GetParam().masses == Masses::None) {
            ASSERT_TRUE(std::isnan(mass)) << number;
        } else if (GetParam().masses == Masses::Stated) {
            ASSERT_NEAR(mass, density * volume, 1e-3 * mass) << number;
        } else {
            const std::int64_t first = number <= lastOfProjectile ? own.begin()->first : own.upper_bound(lastOfProjectile)->first;
            ASSERT_NEAR(mass / volume, own.at(first) / theirs.at(first), 1e-3 * mass / volume) << number;
            ASSERT_GT(mass / volume, density) << number;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, DerivedFixture, testing::ValuesIn(allDerived()),
                         [](const testing::TestParamInfo<Derived>& derived) { return derived.param.name; });

}  // namespace
}  // namespace rubble::io
