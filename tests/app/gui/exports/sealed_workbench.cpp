#include "tests/app/gui/exports/sealed_workbench.h"

#include <QAbstractButton>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QTest>

#include "io/case/case_file.h"
#include "io/seal/seal_case.h"
#include "tests/app/gui/legibility.h"
#include "tests/app/gui/spoken_texts.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "widgets/basics/language.h"

namespace rubble {

void SealedWorkbench::SetUp() {
    FreshWorkbench::SetUp();
    Case theCase = io::caseForFe(cli::writeSmallCollapse(m_folder / "small.exo"), m_case);
    setParameterText(theCase.scenarios[0].scenario, "settle_time", "0.2");
    io::saveCase(m_case, theCase);
    m_key = makeKey("key.pem");
}

std::string SealedWorkbench::makeKey(const std::string& name) {
    EXPECT_EQ(cli::CommandRun().run({"openssl", "genpkey", "-algorithm", "ed25519", "-out", m_folder / name}).exitCode, 0);
    return m_folder / name;
}

bool SealedWorkbench::idle() {
    return QTest::qWaitFor([&] { return !session->computation().busy(); }, patience);
}

void SealedWorkbench::expectReadable(QWidget& dialog, const QString& name) {
    EXPECT_LE(dialog.height(), window->height()) << name.toStdString();
    QStringList illegible;
    (void)QTest::qWaitFor([&] { return (illegible = illegibleIn(dialog)).isEmpty(); }, 1000);
    EXPECT_TRUE(illegible.isEmpty()) << name.toStdString() << ": " << illegible.join(u'\n').toStdString();
    const QString language = widgets::currentLanguage();
    if (language != QLatin1String("en")) {
        QStringList names = namesIn(session->computation().inputs().fe.get());
        for (const char* known : {"small.run.h5", "small.rubblecase", "small.rubble", "small.exo", "small.tsq", "fragments.csv",
                                  "A. Engineer", "fe-1", "As computed", "small"}) {
            names += QLatin1String(known);
        }
        if (const RunRecord* record = session->computation().currentRun()) {
            const QString run = QFileInfo(record->path).fileName();
            names << run << run.section(u'.', 0, 0);
        }
        for (const auto& [place, text] : textsOf(dialog)) {
            EXPECT_TRUE(strangeWords(text, names).isEmpty()) << place.toStdString() << ": " << text.toStdString();
        }
    }
    const QString folder = qEnvironmentVariable("RUBBLE_TAKE_SCREENS");
    for (const char* theme : {"dark", "light"}) {
        if (!folder.isEmpty()) {
            window->setTheme(QLatin1String(theme));
            QTest::qWait(200);
            ASSERT_TRUE(
                pictureOf(dialog).save(QStringLiteral("%1/%2-%3-%4.png").arg(folder, name, language, QLatin1String(theme))));
        }
    }
}

void SealedWorkbench::simulated() {
    window->open(QString::fromStdString(m_case), true);
    awaitRun();
}

void SealedWorkbench::exportTable() {
    const std::string run = session->computation().currentRun()->path.toStdString();
    ASSERT_EQ(cli::cli({"export", run, "--export", "fragments=" + (m_folder / "fragments.csv")}).exitCode, 0);
}

QDialog* SealedWorkbench::askToSeal() {
    window->actions()[ActionId::SealCase].trigger();
    QDialog* dialog = nullptr;
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return (dialog = window->findChild<QDialog*>(QStringLiteral("sealDialog"))) != nullptr && dialog->isVisible(); },
        patience));
    QApplication::setActiveWindow(dialog);
    return dialog;
}

QMessageBox* SealedWorkbench::sealBy(QDialog& dialog) {
    chooseFile(m_bundle);
    click(dialog, "sealAccept");
    QMessageBox* told = nullptr;
    EXPECT_TRUE(QTest::qWaitFor([&] { return (told = window->findChild<QMessageBox*>(QStringLiteral("sealOutcome"))) != nullptr; },
                                patience));
    return told;
}

void SealedWorkbench::sealed(const std::vector<std::string>& leftHome, bool stampRequest) {
    const std::string run = m_folder / "small.run.h5";
    ASSERT_EQ(cli::cli({"run", m_case, "--out", run}).exitCode, 0);
    io::SealRequest request;
    request.casePath = m_case;
    request.runs = {run};
    request.leftHome = leftHome;
    request.by = "A. Engineer";
    request.signer.key = m_key;
    request.stampRequest = stampRequest;
    io::sealCase(m_bundle, request, Execution());
}

void SealedWorkbench::chooseFile(const std::string& path) {
    auto* timer = new QTimer;
    timer->setInterval(20);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, path = QString::fromStdString(path)] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (dialog == nullptr) {
            return;
        }
        timer->stop();
        timer->deleteLater();
        auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        name->setText(path);
        auto* box = dialog->findChild<QDialogButtonBox*>();
        const bool saves = dialog->acceptMode() == QFileDialog::AcceptSave;
        QTest::mouseClick(box->button(saves ? QDialogButtonBox::Save : QDialogButtonBox::Open), Qt::LeftButton);
    });
    timer->start();
}

void SealedWorkbench::type(const QWidget& dialog, const char* name, const std::string& text) {
    auto& line = child<QLineEdit>(dialog, name);
    line.setFocus();
    QTest::keySequence(&line, QKeySequence::SelectAll);
    QTest::keyClick(&line, Qt::Key_Delete);
    QTest::keyClicks(&line, QString::fromStdString(text));
}

void SealedWorkbench::click(const QWidget& dialog, const char* name) {
    auto& button = child<QAbstractButton>(dialog, name);
    EXPECT_TRUE(button.isEnabled()) << name;
    QTest::mouseClick(&button, Qt::LeftButton);
}

}  // namespace rubble
