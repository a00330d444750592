#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/base/error.h"
#include "core/fe/units.h"
#include "io/fe/fe_copy/copy_writer.h"
#include "io/fe/fe_format.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/formats/growing_results.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::HasSubstr;

const std::string bodies = "mass_kg,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m\n10,1,1,1,0,0,5\n20,1,1,1,3,0,5\n";

/// Whether and where an element stands in a mesh.
std::size_t placeOf(const Mesh& mesh, std::int64_t element) {
    const auto found = std::find(mesh.elementIds.begin(), mesh.elementIds.end(), element);
    return static_cast<std::size_t>(found - mesh.elementIds.begin());
}

/// Whether deaths are not told but concluded, from stresses or nodes: then a list counts before them.
bool isConcluded(const FeResult& fe) {
    const auto& list = fe.contents().findings.list();
    return std::any_of(list.begin(), list.end(), [](const Finding& finding) { return finding.what.id.ends_with(".inferred"); });
}

class DeathLists : public testing::TestWithParam<Growing> {
protected:
    std::string result() const { return m_folder / GetParam().opened; }
    std::shared_ptr<const FeResult> open() { return openFe(result(), {}, {}, Execution{}); }

    TemporaryFolder m_folder;
};

class DeathListsThatCount : public DeathLists {};

// As people and spreadsheets of different countries write them.
TEST_P(DeathListsThatCount, ATimeIsReadWithPointAndCommaAndCountsExactly) {
    GetParam().write(m_folder, 3, false);
    const auto without = open();
    const std::size_t dying = placeOf(without->mesh(), GetParam().dying);
    ASSERT_LT(dying, without->mesh().elementCount());
    EXPECT_TRUE(without->contents().findings.count("fe.no_deaths") > 0 || isConcluded(*without));
    const std::string number = std::to_string(GetParam().dying);
    for (const std::string& text :
         {"element,time\n" + number + ",0.75\n", number + ",0.75\n", "element;time\n" + number + ";0,75\n",
          "element;time;status\n" + number + ";0.75;0\n", "time\telement\n0,75\t" + number + "\n", number + " 0.75\n"}) {
        writeContent(result() + ".deaths.csv", text);
        const auto fe = open();
        ASSERT_EQ(fe->mesh().elementCount(), without->mesh().elementCount()) << text;
        ASSERT_EQ(fe->contents().deathTime.size(), fe->mesh().elementCount()) << text;
        for (std::size_t e = 0; e < fe->mesh().elementCount(); ++e) {
            EXPECT_EQ(std::isfinite(fe->contents().deathTime[e]), e == dying) << text << e;
            for (std::size_t k = 0; k < fe->stateCount(); ++k) {
                const bool dead = e == dying && fe->times()[k] >= 0.75;
                ASSERT_EQ(fe->activity().active(k, idAt<ElementIndex>(e)), !dead) << text << e << " at " << fe->times()[k];
            }
        }
        EXPECT_DOUBLE_EQ(fe->contents().deathTime[dying], 0.75) << text;
        EXPECT_EQ(fe->contents().findings.count("fe.no_deaths"), 0) << text;
        EXPECT_EQ(fe->contents().findings.count("fe.death_list.unused"), 0) << text;
        EXPECT_THAT(fe->contents().activityFrom, HasSubstr("a list of 1 deaths")) << text;
        EXPECT_EQ(fe->contents().files.back(), result() + ".deaths.csv") << text;
    }
}

// Milliseconds that are taken for seconds leave all alive.
TEST_P(DeathListsThatCount, AUnitInTheHeadingIsObeyed) {
    GetParam().write(m_folder, 3, false);
    const std::string number = std::to_string(GetParam().dying);
    for (const std::string& text :
         {"element,time_ms\n" + number + ",750\n", "element,time [ms]\n" + number + ",750\n",
          "t_ms;element\n0,75e3;" + number + "\n", "element,timeMs\n" + number + ",750\n", "element,t [s]\n" + number + ",0.75\n",
          "element,time (\xC2\xB5s)\n" + number + ",750000\n", "element,time of death\n" + number + ",0.75\n"}) {
        writeContent(result() + ".deaths.csv", text);
        const auto fe = open();
        const std::size_t dying = placeOf(fe->mesh(), GetParam().dying);
        ASSERT_EQ(fe->contents().deathTime.size(), fe->mesh().elementCount()) << text;
        EXPECT_NEAR(fe->contents().deathTime[dying], 0.75, 1e-12) << text;
        EXPECT_FALSE(fe->activity().active(fe->stateCount() - 1, idAt<ElementIndex>(static_cast<std::uint32_t>(dying)))) << text;
    }
    for (const std::string heading : {"time [weeks]", "time_ns", "time_days", "Zeit [Std]"}) {
        writeContent(result() + ".deaths.csv", "element;" + heading + "\n" + number + ";1\n");
        try {
            open();
            ADD_FAILURE() << heading;
        } catch (const ParseError& error) {
            EXPECT_THAT(error.what(), HasSubstr("\"" + heading + "\"")) << heading;
        }
    }
    ImportSettings milliseconds;
    const std::vector<std::string_view> choices = unitChoices();
    milliseconds.units = static_cast<std::size_t>(std::find(choices.begin(), choices.end(), "kg-mm-ms") - choices.begin());
    ASSERT_LT(milliseconds.units, choices.size());
    writeContent(result() + ".deaths.csv", "element,time [ms]\n" + number + ",0.75\n");
    EXPECT_THROW(openFe(result(), milliseconds, {}, Execution{}), ParseError);
}

class DeathListsBesideFlags : public DeathLists {};

TEST_P(DeathListsBesideFlags, AResultThatTellsItsDeathsDoesNotUseItAndSaysSo) {
    GetParam().write(m_folder, 3, true);
    const auto without = open();
    EXPECT_FALSE(isConcluded(*without));
    writeContent(result() + ".deaths.csv", "element;time\n" + std::to_string(without->mesh().elementIds.front()) + ";0,5\n");
    const auto fe = open();
    EXPECT_EQ(fe->contents().findings.count("fe.death_list.unused"), 1);
    ASSERT_EQ(fe->stateCount(), without->stateCount());
    for (std::size_t k = 0; k < fe->stateCount(); ++k) {
        EXPECT_EQ(fe->activity().activeCount(k), without->activity().activeCount(k)) << k;
    }
}

Growing copied() {
    return {.name = "Copy",
            .opened = "copy.h5",
            .write =
                [](const TemporaryFolder& folder, int, bool) {
                    const std::vector<Growing> all = allGrowing();
                    const auto grids = std::find_if(all.begin(), all.end(), [](const Growing& one) { return one.name == "Grids"; });
                    grids->write(folder, 3, true);
                    writeFeCopy(folder / "copy.h5", *openFe(folder / grids->opened, {}, {}, Execution{}), Vec3::Zero(),
                                Execution{});
                },
            .mayBeSilent = false};
}

Growing tableOfBodies() {
    return {.name = "Bodies",
            .opened = "bodies.csv",
            .write = [](const TemporaryFolder& folder, int, bool) { writeContent(folder / "bodies.csv", bodies); },
            .mayBeSilent = false};
}

std::vector<Growing> every() {
    std::vector<Growing> all = allGrowing();
    all.push_back(oneCdb());
    all.push_back(copied());
    all.push_back(tableOfBodies());
    return all;
}

std::vector<Growing> silent() {
    std::vector<Growing> all = every();
    std::erase_if(all, [](const Growing& growing) { return !growing.mayBeSilent; });
    return all;
}

std::vector<Growing> telling() {
    std::vector<Growing> all = every();
    std::erase_if(all, [](const Growing& growing) { return !growing.tells; });
    return all;
}

// The lists are known to work in a format only where one of its results is here.
TEST(DeathListsOf, EveryFormatAreTested) {
    std::set<std::string> formats, tested;
    for (const FeFormat& format : feFormats()) {
        formats.insert(std::string(format.name));
    }
    for (const Growing& growing : every()) {
        const TemporaryFolder folder;
        growing.write(folder, 3, true);
        tested.insert(openFe(folder / growing.opened, {}, {}, Execution{})->contents().format);
    }
    EXPECT_EQ(tested, formats);
}

std::string nameOfList(const testing::TestParamInfo<Growing>& growing) {
    return growing.param.name;
}

INSTANTIATE_TEST_SUITE_P(Formats, DeathListsThatCount, testing::ValuesIn(silent()), nameOfList);
INSTANTIATE_TEST_SUITE_P(Formats, DeathListsBesideFlags, testing::ValuesIn(telling()), nameOfList);

}  // namespace
}  // namespace rubble::io
