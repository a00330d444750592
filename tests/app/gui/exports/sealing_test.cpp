#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>

#include "app/gui/exports/case_sealing.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/seal/seal_check.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble {
namespace {

/// The small collapse as a saved case, simulated in the window, and a key.
class Sealing : public Workbench {
protected:
    void simulated() {
        Case theCase = io::caseForFe(cli::writeSmallCollapse(m_folder / "small.exo"), m_folder / "small.rubble");
        setParameterText(theCase.scenarios[0].scenario, "settle_time", "0.2");
        io::saveCase(m_folder / "small.rubble", theCase);
        window->open(QString::fromStdString(m_folder / "small.rubble"), true);
        awaitRun();
        ASSERT_EQ(cli::CommandRun().run({"openssl", "genpkey", "-algorithm", "ed25519", "-out", m_folder / "key.pem"}).exitCode, 0);
    }
    bool idle() {
        return QTest::qWaitFor([&] { return !session->computation().busy(); }, patience);
    }
    void seal() {
        widgets::SealChoice choice;
        choice.by = QStringLiteral("A. Engineer");
        choice.key = QString::fromStdString(m_folder / "key.pem");
        window->rooms().sealing->sealAt(QString::fromStdString(m_bundle), choice);
        ASSERT_TRUE(idle());
    }
    /// What the window says of a bundle that it opened.
    QMessageBox* outcomeOfOpening() {
        QDir().mkpath(QString::fromStdString(m_folder / "opened"));
        window->rooms().sealing->openAt(QString::fromStdString(m_bundle), QString::fromStdString(m_folder / "opened"));
        QMessageBox* box = nullptr;
        EXPECT_TRUE(QTest::qWaitFor(
            [&] { return (box = window->findChild<QMessageBox*>(QStringLiteral("sealOutcome"))) != nullptr; }, patience));
        return box;
    }

    io::TemporaryFolder m_folder;
    std::string m_bundle = m_folder / "small.rubblecase";
};

TEST_F(Sealing, ACaseIsSealedWithItsRunAndOpensAsACopy) {
    EXPECT_FALSE(window->actions()[ActionId::SealCase].isEnabled()) << "nothing is open";
    EXPECT_TRUE(window->actions()[ActionId::OpenSealed].isEnabled());
    simulated();
    EXPECT_TRUE(window->actions()[ActionId::SealCase].isEnabled());
    seal();
    const io::SealCheck check = io::checkBundle(m_bundle, {}, Execution());
    EXPECT_TRUE(check.sound());
    EXPECT_EQ(check.statement.sealedBy, "A. Engineer");
    ASSERT_EQ(check.statement.runs.size(), 1u);
    EXPECT_EQ(check.statement.runs[0].trajectoryHash, session->computation().currentRun()->outcome->trajectoryHash.hex());
    QMessageBox* box = outcomeOfOpening();
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->text().contains(QStringLiteral("every run is equal"))) << box->text().toStdString();
    EXPECT_TRUE(box->informativeText().contains(QStringLiteral(": equal")));
    box->accept();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return session->document().path() == QString::fromStdString(m_folder / "opened/small.rubble"); }, patience));
    ASSERT_TRUE(idle());
    EXPECT_NE(session->computation().inputs().fe, nullptr);
}

TEST_F(Sealing, ABundleThatWasAlteredIsNotOpened) {
    simulated();
    seal();
    std::string bytes = io::contentOf(m_bundle).value();
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    io::writeIn(m_bundle, bytes);
    QMessageBox* box = outcomeOfOpening();
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->text().contains(QStringLiteral("not as it was sealed")));
    EXPECT_FALSE(box->informativeText().isEmpty());
    box->accept();
    EXPECT_EQ(session->document().path(), QString::fromStdString(m_folder / "small.rubble"));
    EXPECT_TRUE(QDir(QString::fromStdString(m_folder / "opened")).isEmpty());
}

TEST(SealDialog, SealsOnlyWithAKeyAndHidesThePassphrase) {
    widgets::SealDialog dialog({});
    auto* accept = dialog.findChild<QPushButton*>(QStringLiteral("sealAccept"));
    EXPECT_FALSE(accept->isEnabled());
    QTest::keyClicks(dialog.findChild<QLineEdit*>(QStringLiteral("sealKey")), QStringLiteral("key.pem"));
    EXPECT_TRUE(accept->isEnabled());
    auto* passphrase = dialog.findChild<QLineEdit*>(QStringLiteral("sealPassphrase"));
    EXPECT_EQ(passphrase->echoMode(), QLineEdit::Password);
    QTest::keyClicks(passphrase, QStringLiteral("secret"));
    EXPECT_EQ(dialog.choice().passphrase, QStringLiteral("secret"));
    EXPECT_EQ(dialog.choice().key, QStringLiteral("key.pem"));
}

}  // namespace
}  // namespace rubble
