#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "io/base/files.h"
#include "io/seal/seal_check.h"
#include "io/seal/time_stamp.h"
#include "tests/app/gui/exports/sealed_workbench.h"
#include "widgets/basics/panel.h"
#include "widgets/evidence/sealing/seal_dialog.h"

namespace rubble {
namespace {

using testing::HasSubstr;

class Sealing : public SealedWorkbench {
protected:
    QTreeWidgetItem* part(QDialog& dialog, const QString& begin) {
        for (QTreeWidgetItem* item :
             child<QTreeWidget>(dialog, "sealParts").findItems(begin, Qt::MatchStartsWith | Qt::MatchRecursive)) {
            return item;
        }
        return nullptr;
    }
    static QString noticeOf(QDialog& dialog) { return dialog.findChild<widgets::Notice*>()->text(); }
};

TEST_F(Sealing, WhatTheCaseHasIsTickedAndSealed) {
    EXPECT_FALSE(window->actions()[ActionId::SealCase].isEnabled()) << "nothing is open";
    EXPECT_TRUE(window->actions()[ActionId::OpenSealed].isEnabled());
    simulated();
    exportTable();
    QDialog* dialog = askToSeal();
    ASSERT_NE(dialog, nullptr);
    for (const char* begin : {"small.exo (fe-1)", "fragments.csv"}) {
        QTreeWidgetItem* item = part(*dialog, QLatin1String(begin));
        ASSERT_NE(item, nullptr) << begin;
        EXPECT_EQ(item->checkState(0), Qt::Checked) << begin;
        EXPECT_TRUE(item->text(1).contains(u'B')) << "its size";
    }
    EXPECT_EQ(part(*dialog, QStringLiteral("Runs"))->childCount(), 1);
    EXPECT_THAT(child<QLabel>(*dialog, "sealSum").text().toStdString(), HasSubstr("the largest is"));
    type(*dialog, "sealBy", "A. Engineer");
    type(*dialog, "sealKey", m_key);
    QMessageBox* told = sealBy(*dialog);
    ASSERT_NE(told, nullptr);
    EXPECT_THAT(told->informativeText().toStdString(), HasSubstr("the time of sealing is your word"));
    const io::SealCheck check = io::checkBundle(m_bundle, {}, Execution());
    EXPECT_THAT(told->informativeText().toStdString(), HasSubstr(check.sealSha256));
    told->accept();
    EXPECT_TRUE(check.sound());
    EXPECT_EQ(check.statement.sealedBy, "A. Engineer");
    EXPECT_FALSE(check.statement.inputs[0].files.empty());
    ASSERT_EQ(check.statement.runs.size(), 1u);
    EXPECT_EQ(check.statement.runs[0].trajectoryHash, session->computation().currentRun()->outcome->trajectoryHash.hex());
    const auto bytes = io::contentOf(m_bundle).value();
    EXPECT_THAT(bytes, HasSubstr("data/exports/fragments.csv.provenance.json"));
}

TEST_F(Sealing, AnInputStaysHomeAndARequestForATimeStampIsWritten) {
    simulated();
    QDialog* dialog = askToSeal();
    ASSERT_NE(dialog, nullptr);
    auto& tree = child<QTreeWidget>(*dialog, "sealParts");
    tree.setFocus();
    tree.setCurrentItem(part(*dialog, QStringLiteral("small.exo")));
    QTest::keyClick(&tree, Qt::Key_Space);
    EXPECT_EQ(part(*dialog, QStringLiteral("small.exo"))->text(2), QStringLiteral("only its digest is sealed"));
    QTest::keyClick(&child<QAbstractButton>(*dialog, "sealStamp"), Qt::Key_Space);
    type(*dialog, "sealKey", m_key);
    QMessageBox* told = sealBy(*dialog);
    ASSERT_NE(told, nullptr);
    EXPECT_THAT(told->informativeText().toStdString(), HasSubstr("small.tsq"));
    EXPECT_THAT(told->informativeText().toStdString(), HasSubstr("inputs do not travel"));
    told->accept();
    const io::SealCheck check = io::checkBundle(m_bundle, {}, Execution());
    EXPECT_TRUE(check.sound());
    EXPECT_TRUE(check.statement.inputs[0].files.empty());
    EXPECT_TRUE(check.statement.stampAsked);
    EXPECT_EQ(io::contentOf(m_folder / "small.tsq"), io::timeStampRequestOf(m_bundle));
}

TEST_F(Sealing, AKeyThatCannotBeUsedIsSaidInTheDialog) {
    simulated();
    QDialog* dialog = askToSeal();
    ASSERT_NE(dialog, nullptr);
    auto& accept = child<QPushButton>(*dialog, "sealAccept");
    EXPECT_FALSE(accept.isEnabled()) << "without a key";
    type(*dialog, "sealKey", m_folder / "none.pem");
    QTest::mouseClick(&accept, Qt::LeftButton);
    EXPECT_TRUE(dialog->isVisible());
    EXPECT_TRUE(noticeOf(*dialog).contains(QStringLiteral("none.pem")));
    type(*dialog, "sealKey", m_key);
    EXPECT_TRUE(noticeOf(*dialog).isEmpty()) << "it is about another key";
    QTest::keyClick(dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog->isVisible());
}

TEST_F(Sealing, PathsAreRememberedAndNoPassphraseIs) {
    simulated();
    QDialog* dialog = askToSeal();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(child<QLineEdit>(*dialog, "sealPassphrase").echoMode(), QLineEdit::Password);
    type(*dialog, "sealBy", "A. Engineer");
    type(*dialog, "sealKey", m_key);
    type(*dialog, "sealPassphrase", "not needed");
    type(*dialog, "sealNote", "for the court");
    QMessageBox* told = sealBy(*dialog);
    ASSERT_NE(told, nullptr);
    told->accept();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->findChild<QDialog*>(QStringLiteral("sealDialog")) == nullptr; }, patience));
    dialog = askToSeal();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(child<QLineEdit>(*dialog, "sealBy").text(), QStringLiteral("A. Engineer"));
    EXPECT_EQ(child<QLineEdit>(*dialog, "sealKey").text().toStdString(), m_key);
    EXPECT_EQ(child<QLineEdit>(*dialog, "sealNote").text(), QStringLiteral("for the court"));
    EXPECT_TRUE(child<QLineEdit>(*dialog, "sealPassphrase").text().isEmpty());
    const QSettings settings;
    for (const QString& key : settings.allKeys()) {
        EXPECT_FALSE(settings.value(key).toString().contains(QStringLiteral("not needed"))) << key.toStdString();
    }
}

TEST_F(Sealing, FilesThatLieElsewhereAreAdded) {
    simulated();
    QDialog* dialog = askToSeal();
    ASSERT_NE(dialog, nullptr);
    io::writeIn(m_folder / "elsewhere/notes.txt", "seen on site\n");
    io::writeIn(m_folder / "elsewhere/report/report.html", "<html>");
    chooseFile(m_folder / "elsewhere/notes.txt");
    QTest::mouseClick(&child<QPushButton>(*dialog, "sealAddFiles"), Qt::LeftButton);
    ASSERT_NE(part(*dialog, QStringLiteral("notes.txt")), nullptr);
    EXPECT_EQ(part(*dialog, QStringLiteral("notes.txt"))->parent()->text(0), QStringLiteral("Exports"));
    chooseFile(m_folder / "elsewhere/report");
    QTest::mouseClick(&child<QPushButton>(*dialog, "sealAddFolder"), Qt::LeftButton);
    ASSERT_NE(part(*dialog, QStringLiteral("report")), nullptr);
    type(*dialog, "sealKey", m_key);
    QMessageBox* told = sealBy(*dialog);
    ASSERT_NE(told, nullptr);
    told->accept();
    const auto bytes = io::contentOf(m_bundle).value();
    EXPECT_THAT(bytes, HasSubstr("data/exports/notes.txt"));
    EXPECT_THAT(bytes, HasSubstr("data/report/report.html"));
}

}  // namespace
}  // namespace rubble
