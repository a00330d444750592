#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>

#include "io/base/files.h"
#include "io/seal/seal_check.h"
#include "tests/app/gui/exports/sealed_workbench.h"
#include "widgets/evidence/report_panel.h"

namespace rubble {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Reports and pages that *Seal...* makes of runs that have none.
class SealMakingWindow : public SealedWorkbench {
protected:
    QTreeWidgetItem* row(QDialog& dialog, const char* begin) {
        const auto found =
            child<QTreeWidget>(dialog, "sealParts").findItems(QString::fromLatin1(begin), Qt::MatchStartsWith | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.front();
    }
    /// Ticks or unticks it by the keyboard.
    void toggle(QDialog& dialog, const char* begin) {
        auto& tree = child<QTreeWidget>(dialog, "sealParts");
        ASSERT_NE(row(dialog, begin), nullptr) << begin;
        tree.setFocus();
        tree.setCurrentItem(row(dialog, begin));
        QTest::keyClick(&tree, Qt::Key_Space);
    }
    /// A report without what takes long.
    void makeReportsCheap() {
        widgets::ReportPanel& panel = window->rooms().deck->report();
        panel.findChild<QSpinBox*>(QStringLiteral("reportRepeats"))->setValue(0);
        auto* selfTest = panel.findChild<QComboBox*>(QStringLiteral("reportSelfTest"));
        selfTest->setCurrentIndex(selfTest->findData(QStringLiteral("none")));
    }
    QStringList filesBeside() const { return QDir(QString::fromStdString(m_folder.path())).entryList(QDir::Files); }
    std::string runName() const {
        return QFileInfo(session->computation().currentRun()->path).fileName().section(u'.', 0, 0).toStdString();
    }
};

TEST_F(SealMakingWindow, ReportAndPageAreMadeOfTheRunBeforeItIsSealed) {
    simulated();
    makeReportsCheap();
    const QStringList before = filesBeside();
    QDialog* dialog = askToSeal();
    ASSERT_NE(dialog, nullptr);
    for (const char* begin : {"Make a report of", "Make a page of"}) {
        ASSERT_NE(row(*dialog, begin), nullptr) << begin;
        EXPECT_EQ(row(*dialog, begin)->checkState(0), Qt::Unchecked) << begin;
        EXPECT_EQ(row(*dialog, begin)->text(2), QStringLiteral("there is none yet"));
        toggle(*dialog, begin);
        EXPECT_EQ(row(*dialog, begin)->checkState(0), Qt::Checked) << begin;
    }
    EXPECT_THAT(child<QLabel>(*dialog, "sealSum").text().toStdString(), HasSubstr("What is made comes on top."));
    type(*dialog, "sealKey", m_key);
    QMessageBox* told = sealBy(*dialog);
    ASSERT_NE(told, nullptr);
    EXPECT_THAT(told->informativeText().toStdString(), HasSubstr("1-" + runName() + ".html"));
    told->accept();
    EXPECT_TRUE(io::checkBundle(m_bundle, {}, Execution()).sound());
    const std::string bytes = io::contentOf(m_bundle).value();
    EXPECT_THAT(bytes, HasSubstr("data/report/1-" + runName() + "/report.html"));
    EXPECT_THAT(bytes, HasSubstr("data/report/1-" + runName() + "/report.pdf"));
    EXPECT_THAT(bytes, HasSubstr("data/page/1-" + runName() + ".html"));
    EXPECT_THAT(bytes, HasSubstr("\"kind\":\"page\""));
    EXPECT_EQ(filesBeside(), before + QStringList{QStringLiteral("small.rubblecase")});
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->findChild<QDialog*>(QStringLiteral("sealDialog")) == nullptr; }, patience));
    dialog = askToSeal();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(row(*dialog, "Make a page of")->checkState(0), Qt::Checked) << "as it was chosen last";
    dialog->reject();
}

TEST_F(SealMakingWindow, NothingIsMadeOfARunThatStays) {
    simulated();
    QDialog* dialog = askToSeal();
    ASSERT_NE(dialog, nullptr);
    toggle(*dialog, "Make a page of");
    const std::string run = runName();
    toggle(*dialog, run.c_str());
    EXPECT_FALSE(row(*dialog, "Make a page of")->flags().testFlag(Qt::ItemIsEnabled));
    EXPECT_THAT(row(*dialog, "Make a page of")->text(2).toStdString(), HasSubstr("its run is not sealed"));
    type(*dialog, "sealKey", m_key);
    QMessageBox* told = sealBy(*dialog);
    ASSERT_NE(told, nullptr);
    EXPECT_THAT(told->informativeText().toStdString(), Not(HasSubstr("Made for it")));
    told->accept();
    EXPECT_THAT(io::contentOf(m_bundle).value(), Not(HasSubstr("data/page/1")));
}

TEST_F(SealMakingWindow, APageOfTheRunIsNotMadeAgain) {
    simulated();
    const QString page = QString::fromStdString(m_folder / "shared.html");
    window->rooms().pictures->sharePageAt(page, window->rooms().scene->data());
    ASSERT_TRUE(idle());
    ASSERT_TRUE(QFile::exists(page));
    QDialog* dialog = askToSeal();
    ASSERT_NE(dialog, nullptr);
    EXPECT_NE(row(*dialog, "shared.html"), nullptr);
    EXPECT_EQ(row(*dialog, "Make a page of"), nullptr);
    EXPECT_NE(row(*dialog, "Make a report of"), nullptr);
    dialog->reject();
}

TEST_F(SealMakingWindow, GivenUpWhileItIsMadeNothingIsLeft) {
    simulated();
    const QStringList before = filesBeside();
    // Of this test alone, so that what others make is not counted.
    const io::TemporaryFolder scratch;
    const QByteArray usual = qgetenv("TMPDIR");
    qputenv("TMPDIR", QByteArray::fromStdString(scratch.path()));
    QDialog* dialog = askToSeal();
    ASSERT_NE(dialog, nullptr);
    toggle(*dialog, "Make a page of");
    type(*dialog, "sealKey", m_key);
    QStringList told;
    QObject::connect(session.get(), &Session::told, window, [&](const QString& what) { told += what; });
    QString given;
    QObject::connect(&session->computation(), &Computation::progressed, window, [&](const QString& what, double) {
        if (given.isEmpty() && !what.isEmpty()) {
            given = what;
            session->computation().cancel();
        }
    });
    chooseFile(m_bundle);
    click(*dialog, "sealAccept");
    ASSERT_TRUE(QTest::qWaitFor([&] { return !given.isEmpty() && !session->computation().busy(); }, patience));
    EXPECT_FALSE(given.startsWith(QStringLiteral("Packing")) || given.startsWith(QStringLiteral("Taking digests")))
        << "too late: " << given.toStdString();
    EXPECT_TRUE(told.contains(QStringLiteral("Cancelled; nothing half-made is left"))) << told.join(u'|').toStdString();
    EXPECT_EQ(filesBeside(), before);
    EXPECT_TRUE(QDir(QString::fromStdString(scratch.path())).isEmpty());
    if (usual.isNull()) {
        qunsetenv("TMPDIR");
    } else {
        qputenv("TMPDIR", usual);
    }
}

TEST_F(SealMakingWindow, DialogAndOutcomeAreReadableInBothLanguages) {
    simulated();
    exportTable();
    for (const char* language : {"en", "zh_CN"}) {
        renewed->speak(QLatin1String(language));
        QDialog* dialog = askToSeal();
        ASSERT_NE(dialog, nullptr);
        auto& tree = child<QTreeWidget>(*dialog, "sealParts");
        QTreeWidgetItem* pages = tree.topLevelItem(tree.topLevelItemCount() - 1);
        ASSERT_EQ(pages->childCount(), 1);
        if (pages->child(0)->checkState(0) == Qt::Unchecked) {
            tree.setFocus();
            tree.setCurrentItem(pages->child(0));
            QTest::keyClick(&tree, Qt::Key_Space);
        }
        if (!child<QAbstractButton>(*dialog, "sealStamp").isChecked()) {
            QTest::keyClick(&child<QAbstractButton>(*dialog, "sealStamp"), Qt::Key_Space);
        }
        type(*dialog, "sealKey", m_key);
        const QString name = pages->child(0)->text(0);
        EXPECT_GT(tree.columnWidth(0), tree.fontMetrics().horizontalAdvance(name)) << "names are read whole";
        expectReadable(*dialog, QStringLiteral("seal"));
        // The dialog for files would ask whether to write over the one of the other language.
        QFile::remove(QString::fromStdString(m_bundle));
        QMessageBox* told = sealBy(*dialog);
        ASSERT_NE(told, nullptr);
        expectReadable(*told, QStringLiteral("seal-outcome"));
        told->accept();
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return window->findChild<QDialog*>(QStringLiteral("sealDialog")) == nullptr; }, patience));
    }
    renewed->speak(QStringLiteral("en"));
}

}  // namespace
}  // namespace rubble
