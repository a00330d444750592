#include <gtest/gtest.h>

#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <optional>

#include "app/gui/case/file_commands.h"
#include "app/gui/case/new_case.h"
#include "app/gui/window/opening.h"
#include "core/evidence/cautions.h"
#include "io/run/run_cautions.h"
#include "tests/app/gui/window/hour_of_use.h"
#include "widgets/case/new_case_wizard.h"

namespace rubble {

namespace {

/// What somebody met who changed the units of a case, or its settings, after its run.
class FourthHour : public HourOfUse {
protected:
    void openSmallAndSimulate() {
        openAndAwait(smallAs("small.exo"));
        simulateToEnd();
    }
    bool exportsSay(const char* key) {
        const std::vector<Caution> said = runCautions(io::standingOf(*session->computation().currentRun()->reader));
        return std::any_of(said.begin(), said.end(), [key](const Caution& each) { return each.key == key && each.inPictures(); });
    }
    /// Another choice of units, and the FE result read by it.
    void readIn(const char* units) {
        const auto before = session->computation().inputs().fe;
        session->document().setParameter(QStringLiteral("units"), std::string(units));
        ASSERT_TRUE(QTest::qWaitFor(
            [&] {
                const auto now = session->computation().inputs().fe;
                return now != nullptr && now != before && prepared();
            },
            patience));
    }
    /// Answers the next question with the button of these words; what was asked stands in `asked`.
    void answer(const QString& label) {
        whenAsked([this, label](QDialog& dialog) {
            asked = dynamic_cast<QMessageBox&>(dialog).text();
            for (auto* each : dialog.findChildren<QPushButton*>()) {
                if (each->text() == label) {
                    QTest::mouseClick(each, Qt::LeftButton);
                    return;
                }
            }
            dialog.reject();
        });
    }

    QString asked;
};

TEST_F(FourthHour, ARunIsNotShownWithTheResultReadInOtherUnits) {
    openSmallAndSimulate();
    const QString run = session->computation().currentRun()->path;
    ASSERT_TRUE(QFile::exists(run));
    readIn("g-mm-ms");
    ASSERT_EQ(session->computation().currentRun(), nullptr) << "what was simulated of the result as it was read before";
    std::optional<Failure> failure;
    const auto watch =
        QObject::connect(&session->computation(), &Computation::failed, window, [&](const Failure& told) { failure = told; });
    session->computation().showRun(run, 1.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return failure.has_value(); }, patience));
    QObject::disconnect(watch);
    EXPECT_EQ(session->computation().currentRun(), nullptr);
    EXPECT_TRUE(failure->inOneLine().contains(QStringLiteral("kg-m-s"))) << failure->inOneLine().toStdString();
    EXPECT_TRUE(failure->inOneLine().contains(QStringLiteral("g-mm-ms"))) << failure->inOneLine().toStdString();

    // The same reading by another word is none that differs.
    readIn("kg-m-s");
    session->computation().showRun(run, 1.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().currentRun() != nullptr; }, patience));
}

TEST_F(FourthHour, ExportsOfARunThatItsCaseHasOutgrownSaySo) {
    openSmallAndSimulate();
    EXPECT_FALSE(exportsSay("other_settings"));
    session->document().setParameter(QStringLiteral("gravity"), 1.62);
    EXPECT_TRUE(QTest::qWaitFor([&] { return exportsSay("other_settings"); }, patience));
    session->document().undoStack().undo();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !exportsSay("other_settings"); }, patience));
    // A run that is shown again is judged by the case as it is then.
    const QString run = session->computation().currentRun()->path;
    session->document().setParameter(QStringLiteral("gravity"), 1.62);
    const RunRecord* before = session->computation().currentRun();
    session->computation().showRun(run, 1.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().currentRun() != before; }, patience));
    EXPECT_TRUE(exportsSay("other_settings"));
}

TEST_F(FourthHour, UnitsThatNobodyHasSaidAreAskedForAndThenKnown) {
    // Without densities, and nothing falls: a size alone tells no units.
    const QString path = folder.filePath(QStringLiteral("slow.exo"));
    io::ExodusBuilder builder = cli::smallCollapse();
    builder.nodal.back().second = [](std::size_t, std::size_t) { return 0.0; };
    for (io::ExodusBuilder::Block& block : builder.blocks) {
        block.attributeNames.clear();
        block.attributes.clear();
        block.attributeCount = 0;
    }
    builder.write(path.toStdString());
    window->rooms().opening->newCase(path);
    NewCase& making = *window->rooms().opening->caseInTheMaking();
    const auto settled = [&] {
        NewCase* now = window->rooms().opening->caseInTheMaking();
        return now == nullptr || (now->settled() && now->computation().results().fragments != nullptr);
    };
    ASSERT_TRUE(QTest::qWaitFor(settled, patience));
    widgets::NewCaseWizard& wizard = making.wizard();
    ASSERT_FALSE(wizard.units().rivals().isEmpty());
    const QString taken = QString::fromStdString(wizard.units().taken());
    const auto press = [&](const QString& text) {
        for (auto* each : wizard.findChildren<QPushButton*>()) {
            if (each->text() == text) {
                QTest::mouseClick(each, Qt::LeftButton);
                return;
            }
        }
        FAIL() << text.toStdString();
    };
    answer(QStringLiteral("Back to the units"));
    press(QStringLiteral("&Next"));
    EXPECT_TRUE(asked.contains(taken)) << asked.toStdString();
    EXPECT_EQ(wizard.step(), widgets::NewCaseWizard::Units);
    answer(QStringLiteral("They are %1").arg(taken));
    press(QStringLiteral("&Next"));
    EXPECT_EQ(wizard.step(), widgets::NewCaseWizard::Ground);
    ASSERT_TRUE(QTest::qWaitFor(settled, patience));
    EXPECT_EQ(decidedBy(making.document().scenario().import.units), Decided::ByName) << "the case says what was chosen";
    EXPECT_EQ(making.computation().inputs().fe->contents().findings.count("fe.units_rivals"), 0);
}

}  // namespace

}  // namespace rubble
