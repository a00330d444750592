#include <fstream>

#include "app/gui/case/file_commands.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/evidence/survey_reach.h"
#include "app/gui/stage/panel_deck.h"
#include "tests/app/gui/workbench.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/temporary_folder.h"
#include "widgets/basics/panel.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/evidence_table.h"
#include "widgets/evidence/survey_box.h"

namespace rubble {

namespace {

/// Clouds that are not what they should be, added to the case of the arch: what is wrong and the remedy stand there at once.
class OddClouds : public FreshWorkbench {
protected:
    void SetUp() override {
        FreshWorkbench::SetUp();
        openArch();
        ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    }
    /// A sheet of points around the arch, a metre apart, in hundredths of a metre.
    static io::MadeLas sheet(int format, std::int32_t east = 0) {
        io::MadeLas las;
        las.format = format;
        for (int x = -30; x <= 30; ++x) {
            for (int y = -10; y <= 10; ++y) {
                io::MadePoint point;
                point.place = {east + 100 * x, 100 * y, 10};
                point.colour = {40'000, 50'000, 60'000};
                las.points.push_back(point);
            }
        }
        return las;
    }
    /// Adds a cloud and waits until it was looked at.
    void add(const std::string& path) {
        window->rooms().survey->add(QString::fromStdString(path));
        window->rooms().deck->choose(PanelDeck::Evidence);
        const SurveyReach& reach = session->part<SurveyReach>();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !reach.busy(); }, patience));
    }
    const Findings& findings() { return window->rooms().deck->evidence().survey().content().findings; }
    /// All that the box says, with the remedies.
    QString said() {
        QString all;
        const auto& box = window->rooms().deck->evidence().survey();
        for (const auto* notice : box.findChildren<widgets::Notice*>()) {
            all += notice->isVisibleTo(&box) ? notice->text() + u'\n' : QString();
        }
        return all;
    }
    QString placeInList() { return window->rooms().deck->evidence().list().item(0, 2)->text(); }
    io::TemporaryFolder m_folder;
};

TEST_F(OddClouds, OfVegetationAloneShowsNeitherGroundNorDebris) {
    io::MadeLas las = sheet(0);
    for (io::MadePoint& point : las.points) {
        point.kind = 5;
    }
    add(io::layCloud(m_folder / "trees.las", las.bytes()));
    EXPECT_EQ(findings().count("cloud.vegetation_only"), 1);
    EXPECT_TRUE(said().contains(QStringLiteral("neither ground nor debris"))) << qPrintable(said());
    EXPECT_TRUE(said().contains(QStringLiteral("give the cloud with its ground"), Qt::CaseInsensitive)) << qPrintable(said());
}

TEST_F(OddClouds, ColouredBy8BitsIsTakenSoAndBy16BitsAsItIs) {
    add(io::layCloud(m_folder / "wide.las", sheet(2).bytes()));
    EXPECT_EQ(findings().count("cloud.colours_of_8_bits"), 0) << qPrintable(said());
    io::MadeLas narrow = sheet(2);
    for (io::MadePoint& point : narrow.points) {
        point.colour = {40, 50, 60};
    }
    add(io::layCloud(m_folder / "narrow.las", narrow.bytes()));
    EXPECT_EQ(findings().count("cloud.colours_of_8_bits"), 1);
    EXPECT_TRUE(said().contains(QStringLiteral("colours of 8 bits"))) << qPrintable(said());
}

TEST_F(OddClouds, PointsAtZeroThatGaveNoEchoAreLeftOutAndCounted) {
    // As a scanner writes them: a PTS with the place 0, 0, 0 for each ray without an echo.
    std::ofstream out(m_folder / "echo.ptx");
    out << "3000\n1\n0 0 2\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
    for (int k = 0; k < 3'000; ++k) {
        if (k < 2'000) {
            out << "0 0 0 0.5\n";
        } else {
            out << (k % 40) - 20 << ' ' << (k % 25) - 12 << " 0.1 0.5\n";
        }
    }
    out.close();
    add(m_folder / "echo.ptx");
    EXPECT_EQ(findings().count("cloud.left_out"), 2'000);
    EXPECT_TRUE(said().contains(QStringLiteral("2,000 of 3,000 points are left out"))) << qPrintable(said());
}

TEST_F(OddClouds, CoordinatesOfSinglePrecisionAreToldWithTheirStep) {
    // Binary floats of a UTM zone: an easting is known to 3 cm, a northing to half a metre.
    std::ofstream out(m_folder / "coarse.ply", std::ios::binary);
    out << "ply\nformat binary_little_endian 1.0\nelement vertex 500\nproperty float x\nproperty float y\nproperty float "
           "z\nend_header\n";
    for (int k = 0; k < 500; ++k) {
        const std::array<float, 3> place{500'000.0F + static_cast<float>(k % 25), 5'400'000.0F + static_cast<float>(k / 25),
                                         100.0F};
        out.write(reinterpret_cast<const char*>(place.data()), sizeof place);
    }
    out.close();
    add(m_folder / "coarse.ply");
    EXPECT_EQ(findings().count("cloud.coarse"), 1) << qPrintable(said());
    EXPECT_TRUE(said().contains(QStringLiteral("double precision"))) << "and the remedy";
    EXPECT_EQ(placeInList(), QStringLiteral("elsewhere")) << "the arch has coordinates of its own";
}

TEST_F(OddClouds, OfAnotherSiteIsMarkedInItsRow) {
    add(io::layCloud(m_folder / "far.las", sheet(0, 100 * 8'000).bytes()));
    EXPECT_EQ(placeInList(), QStringLiteral("elsewhere"));
    EXPECT_TRUE(said().contains(QStringLiteral("from the structure"))) << qPrintable(said());
}

TEST_F(OddClouds, ThatCannotBeReadSaysSoInItsRow) {
    add(io::layCloud(m_folder / "whole.las", sheet(0).bytes()));
    EXPECT_EQ(placeInList(), QStringLiteral("not known"));
    // The file is gone by the next time.
    std::filesystem::remove(m_folder / "whole.las");
    std::vector<CaseInput> inputs = session->document().theCase().inputs;
    inputs.back().registration.emplace().shift = Vec3(0.5, 0.0, 0.0);
    session->document().setSurveys(std::move(inputs), [] { return QStringLiteral("placed"); });
    const SurveyReach& reach = session->part<SurveyReach>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !reach.busy(); }, patience));
    EXPECT_EQ(placeInList(), QStringLiteral("unreadable"));
    EXPECT_TRUE(window->rooms().deck->evidence().list().item(0, 0)->toolTip().contains(QStringLiteral("whole.las")));
}

}  // namespace

}  // namespace rubble
