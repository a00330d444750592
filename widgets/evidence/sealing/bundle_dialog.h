#pragma once

#include <QDialog>
#include <QPointer>

#include "widgets/evidence/sealing/bundle_content.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTabWidget;

namespace rubble::widgets {

class BundleAddendaPage;
class BundleCustodyPage;
class BundleRunsPage;
class BundleStampPage;
class BundleTable;
class BundleTrustPage;
class Notice;

/// A sealed bundle: what was checked in it, its runs, whom its reader trusts, custody, addenda and time stamp. It shows and asks;
/// whoever holds the bundle acts.
class BundleDialog : public QDialog {
    Q_OBJECT

public:
    explicit BundleDialog(QWidget* parent = nullptr);

    void setContent(const BundleContent& content);
    void setTrust(const BundleTrust& trust);
    BundleTrust trust() const;
    void setSigner(const SignerChoice& signer);
    void setDifferences(const QStringList& differences, const QStringList& runs);
    /// Work goes on: nothing else can be asked for meanwhile. @param what  empty: it has ended
    void setProgress(const QString& what, double fraction);
    bool working() const { return m_working; }
    /// What went wrong, and what to do about it; empty takes it away.
    void setFailure(const QString& what, const QString& remedy = {});
    /// What came of something.
    void setNote(const QString& what);
    /// All that it shows of what was checked, as plain text.
    QString text() const;

    /// Esc cancels what runs first.
    void reject() override;

signals:
    void checkRequested();
    void runRequested();
    void cancelRequested();
    void saveTextRequested();
    /// The case is to be opened. @param addendum  number of the one that is meant; 0: the sealed case
    void openRequested(int addendum);
    void locateRequested(const QString& id, const QString& path);
    void custodyRequested(const rubble::widgets::CustodyChoice& choice);
    void compareRequested();
    void addendumRequested(const rubble::widgets::SignerChoice& signer, const QString& note);
    void stampRequestRequested(const QString& path);
    void stampAnswerRequested(const QString& path);

private:
    QWidget* buildTabs();
    void connectPages();
    QWidget* buildProgress();
    QWidget* buildButtons();
    void showReady();

    BundleContent m_content;
    bool m_working = false;
    QPointer<QWidget> m_focused;  ///< before work began
    QLabel* m_verdict;
    QLabel* m_facts;
    QTabWidget* m_tabs;
    BundleTable* m_checks;
    BundleRunsPage* m_runs;
    BundleTrustPage* m_trust;
    BundleCustodyPage* m_custody;
    BundleAddendaPage* m_addenda;
    BundleStampPage* m_stamp;
    Notice* m_notice;
    QWidget* m_progress = nullptr;
    QLabel* m_progressText = nullptr;
    QProgressBar* m_bar = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_open = nullptr;
};

}  // namespace rubble::widgets
