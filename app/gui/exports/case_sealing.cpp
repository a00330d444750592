#include "app/gui/exports/case_sealing.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPointer>
#include <algorithm>

#include "app/gui/case/file_commands.h"
#include "app/gui/exports/seal_memory.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "io/base/files.h"
#include "widgets/basics/wording.h"

namespace rubble {

namespace {

const QString bundleEnding = QStringLiteral(".rubblecase");

widgets::SealPart partOf(const io::OfferedPart& part) {
    return {static_cast<widgets::SealPart::Kind>(part.kind),
            QString::fromStdString(part.id),
            QString::fromStdString(part.path),
            part.remark.empty() ? QString() : widgets::worded(part.remark),
            static_cast<qint64>(part.bytes),
            part.chosen};
}

/// Where the request for a time stamp goes: beside the bundle.
QString requestBeside(const QString& bundle) {
    return bundle.left(bundle.size() - bundleEnding.size()) + QStringLiteral(".tsq");
}

}  // namespace

CaseSealing::CaseSealing(Session& session, FileCommands& files, Actions& actions, QWidget& window)
    : m_session(session), m_files(files), m_window(window) {
    connect(&actions[ActionId::SealCase], &QAction::triggered, this, &CaseSealing::seal);
}

void CaseSealing::seal() {
    const Document& document = m_session.document();
    // What is sealed is the file, so it must be what is seen.
    if ((document.path().isEmpty() || document.modified()) && !m_files.save()) {
        return;
    }
    const auto offer = std::make_shared<std::vector<io::OfferedPart>>();
    m_session.computation().write(
        [offer, path = document.path().toStdString()](const Execution& execution) { *offer = io::sealOffer(path, execution); },
        [self = QPointer<CaseSealing>(this), session = &m_session, offer](const std::exception_ptr& thrown) {
            if (const auto failure = failureOf(thrown)) {
                session->report(*failure);
            } else if (thrown == nullptr && self != nullptr) {
                self->addShownRun(*offer);
                self->ask(*offer);
            }
        });
}

void CaseSealing::addShownRun(std::vector<io::OfferedPart>& offer) const {
    Computation& computation = m_session.computation();
    const RunRecord* record = computation.currentRun();
    if (record == nullptr || record->outcome == nullptr || record->running) {
        return;
    }
    io::OfferedPart shown = io::addedPart(record->path.toStdString());
    if (std::any_of(offer.begin(), offer.end(), [&](const io::OfferedPart& each) { return each.path == shown.path; })) {
        return;
    }
    shown.id = record->scenarioName.toStdString();
    shown.chosen = !computation.runStale(m_session.document().scenario());
    const auto firstAfter =
        std::find_if(offer.begin(), offer.end(), [&](const io::OfferedPart& each) { return each.kind > shown.kind; });
    offer.insert(firstAfter, std::move(shown));
}

void CaseSealing::ask(const std::vector<io::OfferedPart>& offer) {
    LastSeal& last = m_session.part<LastSeal>();
    widgets::SealChoice proposed{rememberedSigner(), last.note, last.stampRequest, {}};
    std::transform(offer.begin(), offer.end(), std::back_inserter(proposed.parts), partOf);
    auto* dialog = new widgets::SealDialog(proposed, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAdding([](const QString& path) { return partOf(io::addedPart(path.toStdString())); });
    dialog->setCheck([](const widgets::SealChoice& choice) {
        try {
            const io::Signer signer(signerFiles(choice.signer));
            return widgets::SealObjection();
        } catch (...) {
            return objectionOf(std::current_exception());
        }
    });
    connect(dialog, &QDialog::accepted, this, [this, dialog, &last] {
        const widgets::SealChoice choice = dialog->choice();
        last = {choice.note, choice.stampRequest};
        rememberSigner(choice.signer);
        if (const QString path = askForBundle(); !path.isEmpty()) {
            sealAt(path, choice);
        }
    });
    dialog->open();
}

QString CaseSealing::askForBundle() {
    const QFileInfo base(m_session.document().path());
    QString path = QFileDialog::getSaveFileName(&m_window, tr("Seal the case"),
                                                base.absolutePath() + u'/' + base.completeBaseName() + bundleEnding,
                                                tr("Sealed bundles (*.rubblecase)"));
    if (!path.isEmpty() && !path.endsWith(bundleEnding, Qt::CaseInsensitive)) {
        path += bundleEnding;
    }
    return path;
}

void CaseSealing::sealAt(const QString& path, const widgets::SealChoice& choice) {
    io::SealRequest request;
    request.casePath = m_session.document().path().toStdString();
    request.by = choice.signer.by.toStdString();
    request.note = choice.note.toStdString();
    request.signer = signerFiles(choice.signer);
    request.stampRequest = choice.stampRequest;
    std::vector<io::OfferedPart> parts;
    for (const widgets::SealPart& part : choice.parts) {
        parts.push_back({static_cast<io::OfferedPart::Kind>(part.kind), part.id.toStdString(), part.path.toStdString(),
                         static_cast<std::uint64_t>(part.bytes), part.chosen});
    }
    io::choose(request, parts);
    // The reader keeps a run of the window in its place until it is packed.
    const RunRecord* record = m_session.computation().currentRun();
    const std::shared_ptr<io::RunReader> kept = record != nullptr ? record->reader : nullptr;
    const auto report = std::make_shared<io::SealReport>();
    m_session.computation().write(
        [request, kept, report, path](const Execution& execution) {
            *report = io::sealCase(path.toStdString(), request, execution);
            if (!report->stampRequest.empty()) {
                io::writeIn(requestBeside(path).toStdString(), report->stampRequest);
            }
        },
        [self = QPointer<CaseSealing>(this), session = &m_session, report, path](const std::exception_ptr& thrown) {
            if (const auto failure = failureOf(thrown)) {
                session->report(*failure);
            } else if (thrown != nullptr) {
                session->tell(tr("Cancelled; nothing half-made is left"));
            } else {
                session->tell(tr("Sealed %1; runs in it: %2").arg(QFileInfo(path).fileName()).arg(report->statement.runs.size()));
                if (self != nullptr) {
                    self->tell(path, *report);
                }
            }
        });
}

void CaseSealing::tell(const QString& path, const io::SealReport& report) {
    const io::SealStatement& statement = report.statement;
    QStringList lines{tr("%1 in %2 files, signed with the key %3.")
                          .arg(QLocale().formattedDataSize(statement.bytes, 1, QLocale::DataSizeSIFormat),
                               widgets::shownCount(statement.files), QString::fromStdString(statement.signer)),
                      tr("Note the SHA-256 of the statement, and give it to whoever receives the bundle another way: %1")
                          .arg(QString::fromStdString(report.sealSha256))};
    lines +=
        report.stampRequest.empty()
            ? tr("There is no time stamp: the time of sealing is your word.")
            : tr("The request for a time stamp lies in %1. Send it to a time-stamping service, and put its answer in with Open "
                 "sealed…, Time stamp.")
                  .arg(QFileInfo(requestBeside(path)).fileName());
    for (const Finding& finding : report.findings.list()) {
        lines += tr("%1; %2").arg(widgets::worded(finding.what), widgets::worded(finding.remedy));
    }
    auto* box = new QMessageBox(report.findings.empty() ? QMessageBox::Information : QMessageBox::Warning, tr("Sealed bundle"),
                                tr("The case is sealed: %1").arg(QFileInfo(path).fileName()), QMessageBox::Ok, &m_window);
    box->setObjectName(QStringLiteral("sealOutcome"));
    box->setTextFormat(Qt::PlainText);
    box->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    box->setInformativeText(lines.join(QStringLiteral("\n\n")));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace rubble
