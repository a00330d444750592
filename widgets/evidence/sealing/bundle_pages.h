#pragma once

#include <QWidget>

#include "widgets/evidence/sealing/bundle_content.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace rubble::widgets {

class BundleTable;
class FileField;

/// The runs of a bundle, simulated again, and the inputs that did not travel with it.
class BundleRunsPage : public QWidget {
    Q_OBJECT

public:
    explicit BundleRunsPage(QWidget* parent = nullptr);
    void setContent(const BundleContent& content);

signals:
    void runRequested();
    /// Somebody said where an input lies.
    void locateRequested(const QString& id, const QString& path);

private:
    void locate();

    QLabel* m_about;
    BundleTable* m_runs;
    QLabel* m_absentAbout;
    QTreeWidget* m_absent;
    QPushButton* m_run;
    QPushButton* m_locate;
};

/// Whom the reader trusts.
class BundleTrustPage : public QWidget {
    Q_OBJECT

public:
    explicit BundleTrustPage(QWidget* parent = nullptr);
    void setTrust(const BundleTrust& trust);
    BundleTrust trust() const;

signals:
    void checkRequested();

private:
    FileField* m_signer;
    FileField* m_roots;
    FileField* m_stampRoots;
    QLineEdit* m_digest;
};

/// Who received the bundle from whom; adds an entry.
class BundleCustodyPage : public QWidget {
    Q_OBJECT

public:
    explicit BundleCustodyPage(QWidget* parent = nullptr);
    void setContent(const BundleContent& content);
    void setSigner(const SignerChoice& signer) { m_signer->setChoice(signer); }

signals:
    void addRequested(const rubble::widgets::CustodyChoice& choice);

private:
    void showReady();

    QTreeWidget* m_list;
    QLineEdit* m_from;
    QLineEdit* m_where;
    QLineEdit* m_why;
    SignerForm* m_signer = nullptr;
    QPushButton* m_add;
    bool m_sound = false;
};

/// What other experts assume otherwise; makes an addendum of the case that is open, and opens one.
class BundleAddendaPage : public QWidget {
    Q_OBJECT

public:
    explicit BundleAddendaPage(QWidget* parent = nullptr);
    void setContent(const BundleContent& content);
    void setSigner(const SignerChoice& signer) { m_signer->setChoice(signer); }
    /// What the case that is open assumes otherwise than the sealed one. @param runs  of it that go along
    void setDifferences(const QStringList& differences, const QStringList& runs);

signals:
    /// Differences of the open case are wanted.
    void compareRequested();
    void addRequested(const rubble::widgets::SignerChoice& signer, const QString& note);
    void openRequested(int addendum);

private:
    void showReady();

    QTreeWidget* m_list;
    QPushButton* m_open;
    QLabel* m_case;
    QTreeWidget* m_differences;
    QPushButton* m_compare;
    QLineEdit* m_note;
    SignerForm* m_signer = nullptr;
    QPushButton* m_add;
    bool m_sound = false;
    bool m_compared = false;
};

/// The time stamp of a bundle: its request, and the answer of the service.
class BundleStampPage : public QWidget {
    Q_OBJECT

public:
    explicit BundleStampPage(QWidget* parent = nullptr);
    void setContent(const BundleContent& content);

signals:
    void requestRequested(const QString& path);
    void answerRequested(const QString& path);

private:
    QLabel* m_state;
    QPushButton* m_request;
    QPushButton* m_answer;
    QString m_bundle;
};

}  // namespace rubble::widgets
