#include "app/gui/exports/bundle_opening.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

#include "app/gui/exports/folder_choice.h"
#include "app/gui/exports/seal_memory.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/seal/seal_offer.h"
#include "widgets/evidence/sealing/bundle_dialog.h"

namespace rubble {

namespace {

/// The bundle in a folder, with inputs that did not travel where somebody said that they are.
std::unique_ptr<io::UnpackedBundle> unpacked(const OpenBundle& bundle, const std::string& folder, const Execution& execution) {
    auto files = std::make_unique<io::UnpackedBundle>(bundle.path.toStdString(), bundle.check, folder, execution);
    for (const auto& [id, path] : bundle.located) {
        files->locate(id, path.toStdString(), execution);
    }
    return files;
}

}  // namespace

BundleOpening::BundleOpening(Session& session, Actions& actions, QWidget& window) : m_session(session), m_window(window) {
    connect(&actions[ActionId::OpenSealed], &QAction::triggered, this, &BundleOpening::choose);
    connect(&session.document(), &Document::replaced, this, &BundleOpening::show);
    connect(&session.document().undoStack(), &QUndoStack::cleanChanged, this, &BundleOpening::show);
    connect(&session.computation(), &Computation::progressed, this, [this](const QString& what, double fraction) {
        if (m_dialog != nullptr && m_dialog->working() && !what.isEmpty()) {
            m_dialog->setProgress(what, fraction);
        }
    });
}

BundleOpening::~BundleOpening() = default;

void BundleOpening::choose() {
    const QString beside = QFileInfo(m_session.document().base()).absolutePath();
    const QString bundle = QFileDialog::getOpenFileName(&m_window, tr("Open a sealed bundle"), beside,
                                                        tr("Sealed bundles (*.rubblecase);;All files (*)"));
    if (!bundle.isEmpty()) {
        open(bundle);
    }
}

void BundleOpening::open(const QString& bundle) {
    if (m_dialog != nullptr && m_dialog->working()) {
        m_dialog->raise();
        return;
    }
    m_bundle = {};
    m_bundle.path = bundle;
    makeDialog();
    show();
    check();
}

void BundleOpening::makeDialog() {
    delete m_dialog;
    m_dialog = new widgets::BundleDialog(&m_window);
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    m_dialog->setTrust(rememberedTrust());
    m_dialog->setSigner(rememberedSigner());
    connectDialog();
    m_dialog->show();
}

void BundleOpening::connectDialog() {
    using widgets::BundleDialog;
    connect(m_dialog, &BundleDialog::checkRequested, this, &BundleOpening::check);
    connect(m_dialog, &BundleDialog::runRequested, this, &BundleOpening::runAgain);
    connect(m_dialog, &BundleDialog::cancelRequested, &m_session.computation(), &Computation::cancel);
    connect(m_dialog, &BundleDialog::saveTextRequested, this, &BundleOpening::saveText);
    connect(m_dialog, &BundleDialog::openRequested, this, &BundleOpening::openCase);
    connect(m_dialog, &BundleDialog::locateRequested, this, &BundleOpening::locate);
    connect(m_dialog, &BundleDialog::custodyRequested, this, &BundleOpening::addCustody);
    connect(m_dialog, &BundleDialog::compareRequested, this, &BundleOpening::compare);
    connect(m_dialog, &BundleDialog::addendumRequested, this, &BundleOpening::addAddendum);
    connect(m_dialog, &BundleDialog::stampRequestRequested, this, &BundleOpening::writeRequest);
    connect(m_dialog, &BundleDialog::stampAnswerRequested, this, &BundleOpening::putAnswer);
}

void BundleOpening::start(const Work& work, std::function<void()> done) {
    const auto bundle = std::make_shared<OpenBundle>(m_bundle);
    m_dialog->setProgress(tr("Waiting for other work"), 0.0);
    m_session.computation().write([bundle, work](const Execution& execution) { work(*bundle, execution); },
                                  [self = QPointer<BundleOpening>(this), dialog = m_dialog, bundle,
                                   done = std::move(done)](const std::exception_ptr& thrown) {
                                      if (self == nullptr || dialog == nullptr || self->m_dialog != dialog) {
                                          return;
                                      }
                                      dialog->setProgress({}, 0.0);
                                      if (const widgets::SealObjection objection = objectionOf(thrown); !objection.what.isEmpty()) {
                                          dialog->setFailure(objection.what, objection.remedy);
                                      } else if (thrown != nullptr) {
                                          dialog->setNote(tr("Cancelled; nothing half-made is left"));
                                      } else {
                                          self->m_bundle = std::move(*bundle);
                                          self->show();
                                          if (done) {
                                              done();
                                          }
                                      }
                                  });
}

io::SealTrust BundleOpening::trust() const {
    const widgets::BundleTrust trust = m_dialog->trust();
    return {{trust.roots.toStdString(), trust.signer.toStdString()}, trust.stampRoots.toStdString(), trust.digest.toStdString()};
}

QString BundleOpening::ownCase() const {
    const Document& document = m_session.document();
    return document.modified() ? QString() : document.path();
}

void BundleOpening::show() {
    if (m_dialog != nullptr) {
        m_dialog->setContent(contentOf(m_bundle, ownCase()));
    }
}

void BundleOpening::check() {
    rememberTrust(m_dialog->trust());
    start([trust = trust()](OpenBundle& bundle, const Execution& execution) {
        bundle.check = io::checkBundle(bundle.path.toStdString(), trust, execution);
        bundle.checked = true;
        if (!bundle.check.sound()) {
            bundle.repeats.clear();
            bundle.simulated = false;
        }
    });
}

void BundleOpening::runAgain() {
    start([](OpenBundle& bundle, const Execution& execution) {
        const io::ScratchFolder scratch;
        bundle.repeats = io::repeatRuns(*unpacked(bundle, scratch.path(), execution), execution);
        bundle.simulated = true;
    });
}

void BundleOpening::openCase(int addendum) {
    const QString folder = chooseFolder(m_window, tr("Empty folder to unpack into"), QFileInfo(m_bundle.path).absolutePath());
    if (!folder.isEmpty()) {
        unpackInto(folder, addendum);
    }
}

void BundleOpening::unpackInto(const QString& folder, int addendum) {
    const QString path = folder + u'/' + QFileInfo(QString::fromStdString(m_bundle.check.statement.casePlace)).fileName();
    start(
        [folder = folder.toStdString(), path = path.toStdString(), addendum](OpenBundle& bundle, const Execution& execution) {
            unpacked(bundle, folder, execution)->writeWorkingCase(path, addendum);
            QFile::setPermissions(QString::fromStdString(path), QFile::ReadOwner | QFile::ReadGroup | QFile::ReadOther);
        },
        [this, path] { emit opened(path); });
}

void BundleOpening::locate(const QString& id, const QString& path) {
    start([id = id.toStdString(), path](OpenBundle& bundle, const Execution& execution) {
        io::checkLocated(bundle.check, id, path.toStdString(), execution);
        bundle.located[id] = path;
    });
}

void BundleOpening::addCustody(const widgets::CustodyChoice& choice) {
    io::SealAddition addition;
    addition.by = choice.signer.by.toStdString();
    addition.custody =
        io::CustodyEntry{choice.from.toStdString(), addition.by, choice.where.toStdString(), choice.why.toStdString(), {}};
    add(addition, choice.signer, tr("The entry is added. Note its SHA-256: %1"));
}

void BundleOpening::addAddendum(const widgets::SignerChoice& signer, const QString& note) {
    io::SealAddition addition;
    addition.by = signer.by.toStdString();
    addition.casePath = ownCase().toStdString();
    addition.runs = io::newestRuns(addition.casePath);
    addition.note = note.toStdString();
    add(addition, signer, tr("The addendum is signed and added. Note its SHA-256: %1"));
}

void BundleOpening::add(const io::SealAddition& addition, const widgets::SignerChoice& signer, const QString& told) {
    io::SealAddition whole = addition;
    if (!signer.key.isEmpty()) {
        whole.signer = signerFiles(signer);
    }
    rememberSigner(signer);
    start(
        [whole, trust = trust()](OpenBundle& bundle, const Execution& execution) {
            const std::string path = bundle.path.toStdString();
            io::addRecord(path, path, whole, execution);
            bundle.check = io::checkBundle(path, trust, execution);
        },
        [this, told] { m_dialog->setNote(told.arg(QString::fromStdString(m_bundle.check.head()))); });
}

void BundleOpening::compare() {
    const auto differences = std::make_shared<QStringList>(), runs = std::make_shared<QStringList>();
    start(
        [differences, runs, theirs = ownCase().toStdString()](OpenBundle& bundle, const Execution& execution) {
            execution.check();
            for (const JournalChange& change : io::differencesToSealed(bundle.path.toStdString(), theirs)) {
                *differences += differenceText(change);
            }
            for (const std::string& run : io::newestRuns(theirs)) {
                *runs += QString::fromStdString(run);
            }
        },
        [this, differences, runs] { m_dialog->setDifferences(*differences, *runs); });
}

void BundleOpening::writeRequest(const QString& path) {
    start([path = path.toStdString()](OpenBundle& bundle,
                                      const Execution&) { io::writeIn(path, io::timeStampRequestOf(bundle.path.toStdString())); },
          [this, path] { m_dialog->setNote(tr("The request lies in %1.").arg(path)); });
}

void BundleOpening::putAnswer(const QString& path) {
    start(
        [answer = path.toStdString(), trust = trust()](OpenBundle& bundle, const Execution& execution) {
            const std::string file = bundle.path.toStdString();
            io::addTimeStamp(file, file, io::timeStampAnswer(answer), execution);
            bundle.check = io::checkBundle(file, trust, execution);
        },
        [this] { m_dialog->setNote(tr("The answer is of this bundle, and lies in it now.")); });
}

void BundleOpening::saveText() {
    const QFileInfo bundle(m_bundle.path);
    const QString path =
        askSavePath(m_dialog, tr("Save the list"),
                    bundle.absolutePath() + u'/' + bundle.completeBaseName() + QStringLiteral("-checked.txt"), tr("Texts (*.txt)"));
    if (!path.isEmpty() && m_session.writeNow(path, [&] { io::writeIn(path.toStdString(), m_dialog->text().toStdString()); })) {
        m_dialog->setNote(tr("The list lies in %1.").arg(path));
    }
}

}  // namespace rubble
