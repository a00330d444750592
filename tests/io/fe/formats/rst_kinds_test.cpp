#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/formats/small_results.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::HasSubstr;

class RstKinds : public testing::Test {
protected:
    std::shared_ptr<const FeResult> open(const RstHeader& header) {
        writeContent(m_folder / "wall.rst", smallRst(3, header));
        writeContent(m_folder / "wall.rst.deaths.csv", "element,time\n2,1.5\n");
        return openFe(m_folder / "wall.rst", {}, {}, Execution{});
    }

    TemporaryFolder m_folder;
};

TEST_F(RstKinds, StaticAndTransientAnalysesOfAnyReleaseAreRead) {
    for (const int analysis : {0, 4}) {
        for (const std::size_t words : {std::size_t{40}, std::size_t{80}}) {
            const auto fe = open({analysis, words, 200});
            EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 1.0, 2.0}));
            ASSERT_EQ(fe->mesh().elementIds, (std::vector<std::int64_t>{1, 2}));
            EXPECT_EQ(fe->mesh().shapes[1], ElementShape::Hexahedron);
            EXPECT_TRUE(fe->activity().active(1, idAt<ElementIndex>(1)));
            EXPECT_FALSE(fe->activity().active(2, idAt<ElementIndex>(1)));
            EXPECT_NEAR(fe->state(2)->positions[11].x(), 2.2, 1e-12);
        }
    }
}

// Ansys writes 2^100 where no element of a node resists, as along z in a plane model.
TEST_F(RstKinds, DirectionsWithoutAValueStayAtRest) {
    const auto fe = open({.unset = true});
    const auto state = fe->state(2);
    for (std::size_t n = 0; n < fe->mesh().nodeCount(); ++n) {
        EXPECT_NEAR(state->positions[n].x(), fe->mesh().nodes[n].x() + 0.2, 1e-12);
        EXPECT_EQ(state->positions[n].z(), fe->mesh().nodes[n].z());
    }
    EXPECT_EQ(fe->contents().findings.count("rst.unset"), 12);
    EXPECT_EQ(open({})->contents().findings.count("rst.unset"), 0);
}

TEST_F(RstKinds, ShapesAreNoCourseOfTime) {
    const std::vector<std::pair<int, std::string>> kinds{{1, "an eigenvalue buckling analysis"},
                                                         {2, "a modal analysis"},
                                                         {3, "a harmonic analysis"},
                                                         {7, "a substructure analysis"}};
    for (const auto& [analysis, name] : kinds) {
        for (const std::size_t words : {std::size_t{40}, std::size_t{80}}) {
            try {
                open({analysis, words, 200});
                ADD_FAILURE() << name;
            } catch (const ParseError& error) {
                EXPECT_THAT(error.what(), HasSubstr("wall.rst is " + name));
            }
        }
    }
}

}  // namespace
}  // namespace rubble::io
