#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <memory>

#include "app/gui/exports/bundle_words.h"
#include "io/seal/seal_addition.h"

class QWidget;

namespace rubble {

namespace widgets {
class BundleDialog;
}
class Actions;
class Session;

/// Opens bundles that others sealed: checks them, simulates their runs again, opens their cases to be read only, and adds what
/// comes since: custody, addenda, the answer of a time stamp. All of it on the worker.
class BundleOpening : public QObject {
    Q_OBJECT

public:
    BundleOpening(Session& session, Actions& actions, QWidget& window);
    ~BundleOpening() override;

    /// Checks a bundle and shows what came of it.
    void open(const QString& bundle);

signals:
    /// The case of a bundle was unpacked: this is its copy, which is not to be written.
    void opened(const QString& casePath);

private:
    using Work = std::function<void(OpenBundle& bundle, const Execution& execution)>;
    void choose();
    void makeDialog();
    void connectDialog();
    /// Works on a copy of what is known of the bundle, which replaces it if nothing goes wrong. @param done  gets it on this thread
    void start(const Work& work, std::function<void()> done = {});
    void check();
    void runAgain();
    void openCase(int addendum);
    void unpackInto(const QString& folder, int addendum);
    void locate(const QString& id, const QString& path);
    void addCustody(const widgets::CustodyChoice& choice);
    void addAddendum(const widgets::SignerChoice& signer, const QString& note);
    void add(const io::SealAddition& addition, const widgets::SignerChoice& signer, const QString& told);
    void compare();
    void writeRequest(const QString& path);
    void putAnswer(const QString& path);
    void saveText();
    io::SealTrust trust() const;
    QString ownCase() const;
    void show();

    Session& m_session;
    QWidget& m_window;
    OpenBundle m_bundle;
    QPointer<widgets::BundleDialog> m_dialog;
};

}  // namespace rubble
