#include "widgets/evidence/sealing/bundle_dialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/basics/form_row.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/theme.h"
#include "widgets/evidence/sealing/bundle_pages.h"
#include "widgets/evidence/sealing/bundle_table.h"

namespace rubble::widgets {

namespace {

constexpr int barSteps = 1000;

/// A page that scrolls where the window is low.
QScrollArea* scrolled(QWidget* page) {
    auto* scroll = new QScrollArea;
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    return scroll;
}

}  // namespace

BundleDialog::BundleDialog(QWidget* parent)
    : QDialog(parent),
      m_verdict(new QLabel),
      m_facts(new QLabel),
      m_tabs(new QTabWidget),
      m_checks(new BundleTable("bundleChecks", tr("Checked"))),
      m_runs(new BundleRunsPage),
      m_trust(new BundleTrustPage),
      m_custody(new BundleCustodyPage),
      m_addenda(new BundleAddendaPage),
      m_stamp(new BundleStampPage),
      m_notice(new Notice) {
    setWindowTitle(tr("Sealed bundle"));
    setObjectName(QStringLiteral("bundleDialog"));
    auto* column = dialogColumn(*this);
    m_verdict->setObjectName(QStringLiteral("bundleVerdict"));
    m_verdict->setFont(titleFont());
    m_verdict->setWordWrap(true);
    m_facts->setObjectName(QStringLiteral("bundleFacts"));
    m_facts->setWordWrap(true);
    m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    column->addWidget(m_verdict);
    column->addWidget(m_facts);
    column->addWidget(buildTabs(), 1);
    column->addWidget(m_notice);
    column->addWidget(buildProgress());
    column->addWidget(buildButtons());
    connectPages();
    resize(860, 700);
    setContent({});
    m_checks->setFocus();
}

QWidget* BundleDialog::buildTabs() {
    m_tabs->setObjectName(QStringLiteral("bundleTabs"));
    m_tabs->setDocumentMode(true);
    m_tabs->addTab(m_checks, tr("Checks"));
    m_tabs->addTab(scrolled(m_runs), tr("Runs"));
    m_tabs->addTab(scrolled(m_trust), tr("Trust"));
    m_tabs->addTab(scrolled(m_custody), tr("Custody"));
    m_tabs->addTab(scrolled(m_addenda), tr("Addenda"));
    m_tabs->addTab(scrolled(m_stamp), tr("Time stamp"));
    return m_tabs;
}

void BundleDialog::connectPages() {
    connect(m_runs, &BundleRunsPage::runRequested, this, &BundleDialog::runRequested);
    connect(m_runs, &BundleRunsPage::locateRequested, this, &BundleDialog::locateRequested);
    connect(m_trust, &BundleTrustPage::checkRequested, this, &BundleDialog::checkRequested);
    connect(m_custody, &BundleCustodyPage::addRequested, this, &BundleDialog::custodyRequested);
    connect(m_addenda, &BundleAddendaPage::compareRequested, this, &BundleDialog::compareRequested);
    connect(m_addenda, &BundleAddendaPage::addRequested, this, &BundleDialog::addendumRequested);
    connect(m_addenda, &BundleAddendaPage::openRequested, this, &BundleDialog::openRequested);
    connect(m_stamp, &BundleStampPage::requestRequested, this, &BundleDialog::stampRequestRequested);
    connect(m_stamp, &BundleStampPage::answerRequested, this, &BundleDialog::stampAnswerRequested);
}

QWidget* BundleDialog::buildProgress() {
    m_progress = new QWidget;
    auto* row = new QHBoxLayout(m_progress);
    row->setContentsMargins(0, 0, 0, 0);
    m_progressText = new QLabel;
    m_progressText->setObjectName(QStringLiteral("bundleProgress"));
    m_bar = new QProgressBar;
    m_bar->setRange(0, barSteps);
    m_bar->setTextVisible(false);
    m_bar->setAccessibleName(tr("How far the work on the bundle is"));
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName(QStringLiteral("bundleCancel"));
    cancel->setAutoDefault(false);
    row->addWidget(m_progressText, 1);
    row->addWidget(m_bar, 1);
    row->addWidget(cancel);
    connect(cancel, &QPushButton::clicked, this, &BundleDialog::cancelRequested);
    m_progress->hide();
    return m_progress;
}

QWidget* BundleDialog::buildButtons() {
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    m_save = new QPushButton(tr("Save the list…"));
    m_save->setObjectName(QStringLiteral("bundleSave"));
    m_open = new QPushButton(tr("Open the case…"));
    m_open->setObjectName(QStringLiteral("primary"));
    m_open->setToolTip(
        tr("Unpacks the bundle into an empty folder and opens the case to be read only; changes are saved under another "
           "name"));
    auto* close = new QPushButton(tr("Close"));
    close->setObjectName(QStringLiteral("bundleClose"));
    row->addWidget(m_save);
    row->addStretch();
    row->addWidget(m_open);
    row->addWidget(close);
    for (QPushButton* each : {m_save, m_open, close}) {
        each->setAutoDefault(false);
    }
    connect(m_save, &QPushButton::clicked, this, &BundleDialog::saveTextRequested);
    connect(m_open, &QPushButton::clicked, this, [this] { emit openRequested(0); });
    connect(close, &QPushButton::clicked, this, &BundleDialog::reject);
    return buttons;
}

void BundleDialog::setContent(const BundleContent& content) {
    m_content = content;
    m_verdict->setText(content.verdict);
    m_verdict->setVisible(!content.verdict.isEmpty());
    m_facts->setText(content.facts);
    m_facts->setVisible(!content.facts.isEmpty());
    m_checks->setRows(content.checks);
    m_runs->setContent(content);
    m_custody->setContent(content);
    m_addenda->setContent(content);
    m_stamp->setContent(content);
    showReady();
}

void BundleDialog::setTrust(const BundleTrust& trust) {
    m_trust->setTrust(trust);
}

BundleTrust BundleDialog::trust() const {
    return m_trust->trust();
}

void BundleDialog::setSigner(const SignerChoice& signer) {
    m_custody->setSigner(signer);
    m_addenda->setSigner(signer);
}

void BundleDialog::setDifferences(const QStringList& differences, const QStringList& runs) {
    m_addenda->setDifferences(differences, runs);
}

void BundleDialog::setProgress(const QString& what, double fraction) {
    if (!m_working) {
        m_focused = focusWidget();
    }
    const bool ends = m_working && what.isEmpty();
    m_working = !what.isEmpty();
    m_progress->setVisible(m_working);
    m_progressText->setText(what);
    m_bar->setValue(static_cast<int>(fraction * barSteps));
    if (m_working) {
        setFailure({});
    }
    showReady();
    // What is disabled loses the focus: the keys go on where they were.
    if (ends && m_focused != nullptr) {
        m_focused->setFocus();
    }
}

void BundleDialog::setFailure(const QString& what, const QString& remedy) {
    m_notice->set(Notice::Kind::Error, what, remedy);
}

void BundleDialog::setNote(const QString& what) {
    m_notice->set(Notice::Kind::Note, what);
}

void BundleDialog::showReady() {
    m_tabs->setEnabled(!m_working);
    m_save->setEnabled(m_content.read && !m_working);
    m_open->setEnabled(m_content.read && !m_content.altered && !m_working);
}

QString BundleDialog::text() const {
    QString text = m_content.file + QStringLiteral(": ") + m_content.verdict + u'\n' + m_content.facts + QStringLiteral("\n\n") +
                   bundleRowsText(m_content.checks);
    if (!m_content.runs.empty()) {
        text += u'\n' + bundleRowsText(m_content.runs);
    }
    for (const BundleRecord& record : m_content.records) {
        text += u'\n' + (record.isAddendum
                             ? tr("%1. %2: addendum of %3").arg(record.number).arg(record.when, record.by)
                             : tr("%1. %2: %3 received it from %4").arg(record.number).arg(record.when, record.by, record.from));
        for (const QString& detail : {record.where, record.note, record.bundleDigest, record.digest}) {
            text += detail.isEmpty() ? QString() : QStringLiteral("\n   ") + detail;
        }
        for (const QString& difference : record.differences) {
            text += QStringLiteral("\n   ") + difference;
        }
        text += u'\n';
    }
    return text;
}

void BundleDialog::reject() {
    if (m_working) {
        emit cancelRequested();
    } else {
        QDialog::reject();
    }
}

}  // namespace rubble::widgets
