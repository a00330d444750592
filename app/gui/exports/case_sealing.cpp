#include "app/gui/exports/case_sealing.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPointer>
#include <memory>
#include <vector>

#include "app/gui/case/file_commands.h"
#include "app/gui/exports/folder_choice.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "core/base/error.h"
#include "io/seal/seal_case.h"
#include "io/seal/seal_check.h"
#include "io/seal/unpacked_bundle.h"
#include "widgets/basics/wording.h"

namespace rubble {

namespace {

constexpr qsizetype mostLines = 12;

/// What the worker found in a bundle.
struct OpenedBundle {
    io::SealCheck check;
    std::vector<std::pair<std::string, io::RunRepeat>> repeats;
    std::vector<io::SealFault> notSimulated;  ///< runs, and why
    QString workingCase;                      ///< empty: it was not unpacked
};

void checkAndUnpack(OpenedBundle& bundle, const std::string& path, const std::string& folder, const Execution& execution) {
    bundle.check = io::checkBundle(path, {}, execution);
    if (!bundle.check.sound()) {
        return;
    }
    const io::UnpackedBundle unpacked(path, bundle.check, folder, execution);
    for (const io::SealedRun& run : unpacked.runs()) {
        try {
            bundle.repeats.emplace_back(run.place, unpacked.repeat(run, execution));
        } catch (const WorldError& error) {
            // What was checked is told all the same.
            bundle.notSimulated.push_back({run.place, error.message()});
        }
    }
    const QString name = QFileInfo(QString::fromStdString(bundle.check.statement.casePlace)).fileName();
    bundle.workingCase = QString::fromStdString(folder) + u'/' + name;
    unpacked.writeWorkingCase(bundle.workingCase.toStdString());
}

void addFaults(QStringList& lines, const std::vector<io::SealFault>& faults) {
    for (const io::SealFault& fault : faults) {
        const QString place = fault.place.empty() ? CaseSealing::tr("container") : QString::fromStdString(fault.place);
        lines += QStringLiteral("%1: %2").arg(place, widgets::worded(fault.what));
    }
}

void showOutcome(QWidget& window, const OpenedBundle& bundle) {
    const io::SealCheck& check = bundle.check;
    QStringList lines;
    addFaults(lines, check.faults);
    addFaults(lines, bundle.notSimulated);
    addFaults(lines, check.doubts);
    bool equal = true;
    for (const auto& [place, repeat] : bundle.repeats) {
        equal = equal && repeat.equal;
        const QString difference =
            repeat.firstDifference.empty() ? CaseSealing::tr("not equal") : widgets::worded(repeat.firstDifference);
        lines += QStringLiteral("%1: %2").arg(QString::fromStdString(place), repeat.equal ? CaseSealing::tr("equal") : difference);
    }
    for (const io::CheckedRecord& checked : check.records) {
        for (const JournalChange& change : checked.record.addendum.differences) {
            lines += CaseSealing::tr("%1 assumes otherwise: %2")
                         .arg(QString::fromStdString(checked.record.by), QString::fromStdString(change.place));
        }
    }
    if (lines.size() > mostLines) {
        const qsizetype more = lines.size() - mostLines;
        lines = lines.first(mostLines);
        lines += CaseSealing::tr("and %1 more; rubble-cli open-sealed tells all").arg(more);
    }
    QString verdict = CaseSealing::tr("The bundle is as it was sealed, and every run is equal.");
    if (!check.sound()) {
        verdict = CaseSealing::tr("The bundle is not as it was sealed. It was not opened.");
    } else if (!equal) {
        verdict = CaseSealing::tr("The bundle is as it was sealed, but a run does not repeat.");
    } else if (!bundle.notSimulated.empty()) {
        verdict = CaseSealing::tr("The bundle is as it was sealed, but a run could not be simulated.");
    } else if (bundle.repeats.empty()) {
        verdict = CaseSealing::tr("The bundle is as it was sealed. It holds no run.");
    }
    auto* box =
        new QMessageBox(check.sound() && equal && bundle.notSimulated.empty() ? QMessageBox::Information : QMessageBox::Warning,
                        CaseSealing::tr("Sealed bundle"), verdict, QMessageBox::Ok, &window);
    box->setObjectName(QStringLiteral("sealOutcome"));
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(CaseSealing::tr("Sealed %1 by %2, key %3.")
                                .arg(QString::fromStdString(check.statement.sealedAt),
                                     QString::fromStdString(check.statement.sealedBy),
                                     QString::fromStdString(check.signature.signer.fingerprint)) +
                            u'\n' + lines.join(u'\n'));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace

CaseSealing::CaseSealing(Session& session, FileCommands& files, Actions& actions, QWidget& window)
    : m_session(session), m_files(files), m_window(window) {
    connect(&actions[ActionId::SealCase], &QAction::triggered, this, &CaseSealing::seal);
    connect(&actions[ActionId::OpenSealed], &QAction::triggered, this, &CaseSealing::open);
}

void CaseSealing::seal() {
    const Document& document = m_session.document();
    // What is sealed is the file, so it must be what is seen.
    if ((document.path().isEmpty() || document.modified()) && !m_files.save()) {
        return;
    }
    widgets::SealChoice& last = m_session.part<LastSeal>().choice;
    widgets::SealDialog dialog(last, &m_window);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    const widgets::SealChoice choice = dialog.choice();
    last = choice;
    last.passphrase.clear();
    const QFileInfo base(document.path());
    QString path = QFileDialog::getSaveFileName(
        &m_window, tr("Seal the case"), base.absolutePath() + u'/' + base.completeBaseName() + QStringLiteral(".rubblecase"),
        tr("Sealed bundles (*.rubblecase)"));
    if (path.isEmpty()) {
        return;
    }
    if (!path.endsWith(QLatin1String(".rubblecase"), Qt::CaseInsensitive)) {
        path += QStringLiteral(".rubblecase");
    }
    sealAt(path, choice);
}

void CaseSealing::sealAt(const QString& path, const widgets::SealChoice& choice) {
    Computation& computation = m_session.computation();
    io::SealRequest request;
    request.casePath = m_session.document().path().toStdString();
    request.by = choice.by.toStdString();
    request.note = choice.note.toStdString();
    request.signer = {choice.key.toStdString(), choice.certificate.toStdString(), choice.passphrase.toStdString()};
    const RunRecord* record = computation.currentRun();
    // The reader keeps a run of the window in its place until it is packed.
    std::shared_ptr<io::RunReader> kept;
    if (record != nullptr && record->outcome != nullptr && !record->running &&
        !computation.runStale(m_session.document().scenario())) {
        request.runs.push_back(record->path.toStdString());
        kept = record->reader;
    }
    const auto report = std::make_shared<io::SealReport>();
    computation.write(
        [request, kept, report, file = path.toStdString()](const Execution& execution) {
            *report = io::sealCase(file, request, execution);
        },
        [session = &m_session, report, path](const std::exception_ptr& thrown) {
            if (const auto failure = failureOf(thrown)) {
                session->report(*failure);
            } else if (thrown != nullptr) {
                session->tell(tr("Cancelled; nothing half-made is left"));
            } else {
                session->tell(tr("Sealed %1; runs in it: %2").arg(QFileInfo(path).fileName()).arg(report->statement.runs.size()));
            }
        });
}

void CaseSealing::open() {
    const QString beside = QFileInfo(m_session.document().base()).absolutePath();
    const QString bundle = QFileDialog::getOpenFileName(&m_window, tr("Open a sealed bundle"), beside,
                                                        tr("Sealed bundles (*.rubblecase);;All files (*)"));
    if (!bundle.isEmpty()) {
        openBundle(bundle);
    }
}

void CaseSealing::openBundle(const QString& bundle) {
    const QString folder = chooseFolder(m_window, tr("Empty folder to unpack into"), QFileInfo(bundle).absolutePath());
    if (!folder.isEmpty()) {
        openAt(bundle, folder);
    }
}

void CaseSealing::openAt(const QString& bundle, const QString& folder) {
    const auto found = std::make_shared<OpenedBundle>();
    m_session.computation().write(
        [found, path = bundle.toStdString(), into = folder.toStdString()](const Execution& execution) {
            checkAndUnpack(*found, path, into, execution);
        },
        [self = QPointer<CaseSealing>(this), session = &m_session, found](const std::exception_ptr& thrown) {
            if (const auto failure = failureOf(thrown)) {
                session->report(*failure);
            } else if (thrown != nullptr) {
                session->tell(tr("Cancelled; nothing half-made is left"));
            } else if (self != nullptr) {
                showOutcome(self->m_window, *found);
                if (!found->workingCase.isEmpty()) {
                    emit self->opened(found->workingCase);
                }
            }
        });
}

}  // namespace rubble
