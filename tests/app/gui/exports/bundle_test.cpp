#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>

#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/seal/seal_check.h"
#include "tests/app/gui/exports/sealed_workbench.h"
#include "tests/support/time_stamp_service.h"
#include "widgets/basics/panel.h"
#include "widgets/evidence/sealing/bundle_dialog.h"

namespace rubble {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The dialog of a sealed bundle.
class Bundles : public SealedWorkbench {
protected:
    void open() {
        window->open(QString::fromStdString(m_bundle));
        ASSERT_TRUE(idle());
        m_dialog = window->findChild<widgets::BundleDialog*>();
        ASSERT_NE(m_dialog, nullptr);
        QApplication::setActiveWindow(m_dialog);
    }
    void show(int tab) { child<QTabWidget>(*m_dialog, "bundleTabs").setCurrentIndex(tab); }
    void press(const char* name) {
        click(*m_dialog, name);
        ASSERT_TRUE(idle());
    }
    std::string label(const char* name) { return child<QLabel>(*m_dialog, name).text().toStdString(); }
    std::string notice() { return m_dialog->findChild<widgets::Notice*>()->text().toStdString(); }
    /// A row of a list and what stands in its columns.
    std::string row(const char* list, int place) {
        QTreeWidgetItem* item = child<QTreeWidget>(*m_dialog, list).topLevelItem(place);
        std::string text;
        for (int i = 0; item != nullptr && i < item->columnCount(); ++i) {
            text += item->text(i).toStdString() + " | ";
        }
        return text;
    }
    int rows(const char* list) { return child<QTreeWidget>(*m_dialog, list).topLevelItemCount(); }
    bool enabled(const char* name) { return child<QPushButton>(*m_dialog, name).isEnabled(); }
    io::SealCheck check() { return io::checkBundle(m_bundle, {}, Execution()); }
    /// Unpacks its case into a folder and waits until it is open.
    void openCase(const char* button, const std::string& folder) {
        QDir().mkpath(QString::fromStdString(folder));
        chooseFile(folder);
        click(*m_dialog, button);
        ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().path() == QString::fromStdString(folder + "/small.rubble"); },
                                    patience));
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    }

    widgets::BundleDialog* m_dialog = nullptr;
};

enum Tab { Checks, Runs, Trust, Custody, Addenda, Stamp };

TEST_F(Bundles, EachCheckHasAVerdictAndTheListIsSaved) {
    sealed();
    open();
    EXPECT_EQ(label("bundleVerdict"), "The bundle is as it was sealed; nothing was simulated.");
    EXPECT_THAT(label("bundleFacts"), HasSubstr("by A. Engineer"));
    EXPECT_EQ(m_dialog->focusWidget()->objectName(), QStringLiteral("bundleChecks")) << "the keys go to what is to be read";
    EXPECT_EQ(rows("bundleChecks"), 7);
    EXPECT_EQ(row("bundleChecks", 0), "Container | ✓ holds | every byte of the file is as it was written | ");
    EXPECT_THAT(row("bundleChecks", 2), HasSubstr("Statement and signature | ? not proven | signed by the owner of the key"));
    EXPECT_THAT(label("bundleChecksWhole"),
                AllOf(HasSubstr("Statement and signature: not proven."), HasSubstr(check().statement.signer)))
        << "what is not proven is told whole";
    EXPECT_THAT(row("bundleChecks", 3), AllOf(HasSubstr("Time | ? not proven"), HasSubstr("as the signer says")));
    EXPECT_THAT(row("bundleChecks", 6), HasSubstr("Custody and addenda | not there"));
    show(Runs);
    press("bundleRun");
    EXPECT_THAT(row("bundleRuns", 0), HasSubstr("data/runs/small.run.h5 | ✓ equal"));
    EXPECT_EQ(label("bundleVerdict"), "The bundle is as it was sealed; every run is equal.");
    chooseFile(m_folder / "checked.txt");
    click(*m_dialog, "bundleSave");
    const std::string text = io::contentOf(m_folder / "checked.txt").value_or("");
    EXPECT_THAT(text, HasSubstr("every run is equal.\n"));
    EXPECT_THAT(text, HasSubstr("Container: holds (every byte of the file is as it was written)\n"));
    EXPECT_THAT(text,
                HasSubstr("  seal/seal.tsr: not proven (there is no time stamp: the time of sealing is the signer's word)\n"));
    EXPECT_THAT(text, HasSubstr("data/runs/small.run.h5: equal ("));
    EXPECT_THAT(notice(), HasSubstr("checked.txt"));
}

TEST_F(Bundles, AnAlteredOneSaysWhatAndIsNotOpened) {
    sealed();
    std::string bytes = io::contentOf(m_bundle).value();
    bytes[bytes.find("fe_input")] ^= 1;
    io::writeIn(m_bundle, bytes);
    open();
    EXPECT_THAT(label("bundleVerdict"), HasSubstr("not as it was sealed"));
    EXPECT_THAT(row("bundleChecks", 1), HasSubstr("Files | ✗ does not hold"));
    EXPECT_FALSE(enabled("primary"));
    EXPECT_FALSE(enabled("bundleRun"));
    EXPECT_FALSE(enabled("custodyAdd"));
    io::writeIn(m_bundle, bytes.substr(0, bytes.size() / 2));
    open();
    EXPECT_THAT(notice(), HasSubstr("cut short"));
    EXPECT_FALSE(enabled("bundleSave"));
}

TEST_F(Bundles, AnInputThatDidNotTravelIsPointedAt) {
    sealed({"fe-1"});
    open();
    show(Runs);
    press("bundleRun");
    EXPECT_THAT(row("bundleRuns", 0), HasSubstr("? not simulated"));
    EXPECT_THAT(row("bundleAbsent", 0), HasSubstr("fe-1 | small.exo |  | "));
    chooseFile(m_case);
    press("bundleLocate");
    EXPECT_THAT(notice(), HasSubstr("is not the input fe-1"));
    chooseFile(m_folder / "small.exo");
    press("bundleLocate");
    EXPECT_THAT(row("bundleAbsent", 0), HasSubstr(m_folder / "small.exo"));
    press("bundleRun");
    EXPECT_THAT(row("bundleRuns", 0), HasSubstr("✓ equal"));
}

TEST_F(Bundles, WhoIsTrustedIsAskedAndComparedWith) {
    sealed();
    open();
    show(Trust);
    type(*m_dialog, "trustSigner", check().statement.signer);
    press("bundleCheck");
    EXPECT_THAT(row("bundleChecks", 2), HasSubstr("✓ holds"));
    type(*m_dialog, "trustSigner", std::string(64, '0'));
    press("bundleCheck");
    EXPECT_THAT(row("bundleChecks", 2), HasSubstr("✗ does not hold"));
    type(*m_dialog, "trustSigner", m_folder / "none.pem");
    press("bundleCheck");
    EXPECT_THAT(notice(), HasSubstr("none.pem"));
    type(*m_dialog, "trustSigner", "");
    type(*m_dialog, "trustDigest", std::string(64, '1'));
    press("bundleCheck");
    EXPECT_THAT(label("bundleVerdict"), HasSubstr("not as it was sealed"));
}

TEST_F(Bundles, ACaseOpensToBeReadOnlyAndChangesAreSavedElsewhere) {
    sealed();
    open();
    openCase("primary", m_folder / "opened");
    EXPECT_TRUE(session->document().readOnly());
    const std::string before = io::contentOf(m_folder / "opened/small.rubble").value();
    EXPECT_FALSE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "opened/small.rubble")));
    session->document().setParameter(QStringLiteral("friction"), 0.3);
    chooseFile(m_folder / "opened/theirs.rubble");
    window->actions()[ActionId::Save].trigger();
    EXPECT_EQ(io::contentOf(m_folder / "opened/small.rubble"), before);
    EXPECT_EQ(session->document().path().toStdString(), m_folder / "opened/theirs.rubble");
    EXPECT_FALSE(session->document().readOnly());
}

TEST_F(Bundles, CustodyIsListedAndAppended) {
    sealed();
    open();
    show(Custody);
    EXPECT_FALSE(enabled("custodyAdd"));
    type(*m_dialog, "custodyBy", "B. Clerk");
    EXPECT_FALSE(enabled("custodyAdd")) << "from nobody";
    type(*m_dialog, "custodyFrom", "A. Engineer");
    type(*m_dialog, "custodyWhere", "court, on a disk");
    type(*m_dialog, "custodyWhy", "file 7");
    const std::string bundle = io::sha256OfFile(m_bundle);
    press("custodyAdd");
    EXPECT_THAT(row("bundleCustody", 0), HasSubstr("B. Clerk | A. Engineer | court, on a disk | file 7 | no | " + bundle));
    EXPECT_THAT(notice(), HasSubstr(check().head()));
    type(*m_dialog, "custodyFrom", "B. Clerk");
    type(*m_dialog, "custodyBy", "C. Expert");
    type(*m_dialog, "custodyKey", m_key);
    press("custodyAdd");
    EXPECT_THAT(row("bundleCustody", 1), AllOf(HasSubstr("C. Expert | B. Clerk"), HasSubstr("| yes |")));
    EXPECT_TRUE(check().sound());
}

TEST_F(Bundles, AnAddendumIsMadeOfTheOpenCaseAndOpened) {
    sealed();
    open();
    show(Addenda);
    EXPECT_FALSE(enabled("addendumCompare")) << "no case is open";
    openCase("primary", m_folder / "opened");
    session->document().setParameter(QStringLiteral("friction"), 0.3);
    EXPECT_FALSE(enabled("addendumCompare")) << "it is not saved";
    chooseFile(m_folder / "opened/theirs.rubble");
    window->actions()[ActionId::Save].trigger();
    ASSERT_TRUE(idle());
    press("addendumCompare");
    EXPECT_THAT(row("addendumDifferences", 0), HasSubstr("friction: nothing became 0.3"));
    type(*m_dialog, "addendumBy", "C. Expert");
    type(*m_dialog, "addendumKey", makeKey("their.pem"));
    type(*m_dialog, "addendumNote", "wet stone");
    press("addendumAdd");
    EXPECT_THAT(row("bundleAddenda", 0), HasSubstr("1. C. Expert: wet stone"));
    const QTreeWidgetItem* addendum = child<QTreeWidget>(*m_dialog, "bundleAddenda").topLevelItem(0);
    ASSERT_EQ(addendum->childCount(), 1);
    EXPECT_THAT(addendum->child(0)->text(0).toStdString(), HasSubstr("friction: nothing became 0.3"));
    EXPECT_TRUE(check().sound());
    openCase("addendumOpen", m_folder / "theirs");
    EXPECT_EQ(session->document().scenario().simulation.friction, 0.3);
}

TEST_F(Bundles, TheAnswerOfATimeStampIsPutInAndVerified) {
    sealed({}, true);
    open();
    show(Stamp);
    EXPECT_THAT(label("stampState"), HasSubstr("the signer's word"));
    chooseFile(m_folder / "small.tsq");
    press("stampRequest");
    io::TimeStampService service(m_folder.path());
    service.answerTo(io::contentOf(m_folder / "small.tsq").value());
    io::writeIn(m_folder / "wrong.tsr", "no answer");
    chooseFile(m_folder / "wrong.tsr");
    press("stampAnswer");
    EXPECT_THAT(notice(), HasSubstr("no answer of a time-stamping service"));
    chooseFile(service.answer());
    press("stampAnswer");
    EXPECT_THAT(label("stampState"), HasSubstr("Service of the test"));
    EXPECT_FALSE(enabled("stampAnswer"));
    show(Trust);
    type(*m_dialog, "trustStampRoots", service.roots());
    press("bundleCheck");
    EXPECT_THAT(row("bundleChecks", 3), HasSubstr("✓ holds | seen by"));
}

TEST_F(Bundles, WorkIsShownAndCancelled) {
    sealed();
    open();
    bool asked = false;
    QObject::connect(m_dialog, &widgets::BundleDialog::cancelRequested, [&] { asked = true; });
    m_dialog->setProgress(QStringLiteral("Simulating"), 0.25);
    EXPECT_FALSE(child<QTabWidget>(*m_dialog, "bundleTabs").isEnabled());
    EXPECT_EQ(m_dialog->findChild<QProgressBar*>()->value(), 250);
    EXPECT_EQ(label("bundleProgress"), "Simulating");
    click(*m_dialog, "bundleCancel");
    EXPECT_TRUE(asked);
    asked = false;
    QTest::keyClick(m_dialog, Qt::Key_Escape);
    EXPECT_TRUE(asked);
    EXPECT_TRUE(m_dialog->isVisible()) << "Esc cancels what runs first";
    m_dialog->setProgress({}, 0.0);
    show(Runs);
    click(*m_dialog, "bundleRun");
    click(*m_dialog, "bundleCancel");
    ASSERT_TRUE(idle());
    EXPECT_THAT(notice(), HasSubstr("Cancelled"));
    EXPECT_EQ(rows("bundleRuns"), 0);
    QTest::keyClick(m_dialog, Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window->findChild<widgets::BundleDialog*>() == nullptr; }, patience));
}

/// Both dialogs can be read whole at the smallest size of the window, and speak its language.
TEST_F(Bundles, BothDialogsCanBeReadWholeInBothLanguages) {
    sealed({"fe-1"}, true);
    for (const char* language : {"en", "zh_CN"}) {
        renewed->speak(QLatin1String(language));
        SCOPED_TRACE(language);
        window->open(QString::fromStdString(m_case));
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        QDialog* seal = askToSeal();
        ASSERT_NE(seal, nullptr);
        click(*seal, "sealStamp");
        expectReadable(*seal, QStringLiteral("seal-first"));
        QTest::keyClick(seal, Qt::Key_Escape);
        open();
        for (int tab = Checks; tab <= Stamp; ++tab) {
            show(tab);
            expectReadable(*m_dialog, QStringLiteral("bundle-%1").arg(child<QTabWidget>(*m_dialog, "bundleTabs").currentIndex()));
        }
        QTest::keyClick(m_dialog, Qt::Key_Escape);
        ASSERT_TRUE(QTest::qWaitFor([&] { return window->findChild<widgets::BundleDialog*>() == nullptr; }, patience));
    }
}

}  // namespace
}  // namespace rubble
