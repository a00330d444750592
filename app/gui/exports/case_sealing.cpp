#include "app/gui/exports/case_sealing.h"

#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPointer>
#include <algorithm>

#include "app/gui/case/file_commands.h"
#include "app/gui/exports/report_work.h"
#include "app/gui/exports/seal_making.h"
#include "app/gui/exports/seal_memory.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "io/base/files.h"
#include "io/seal/unpacked_bundle.h"
#include "widgets/basics/wording.h"

namespace rubble {

namespace {

const QString bundleEnding = QStringLiteral(".rubblecase");

widgets::SealPart sealPartOf(const io::OfferedPart& part) {
    return {static_cast<widgets::SealPart::Kind>(part.kind),
            QString::fromStdString(part.id),
            QString::fromStdString(part.path),
            part.remark.empty() ? QString() : widgets::worded(part.remark),
            static_cast<qint64>(part.bytes),
            part.chosen,
            QString::fromStdString(part.run)};
}

io::OfferedPart offeredPart(const widgets::SealPart& part) {
    io::OfferedPart offered{static_cast<io::OfferedPart::Kind>(part.kind), part.id.toStdString(), part.path.toStdString(),
                            static_cast<std::uint64_t>(part.bytes), part.chosen};
    offered.run = part.run.toStdString();
    return offered;
}

bool isMade(const widgets::SealPart& part, widgets::SealPart::Kind kind) {
    return part.kind == kind && part.chosen && !part.run.isEmpty();
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
    const std::vector<io::OfferedPart> missing = io::missingOf(shown, offer);
    const auto firstAfter =
        std::find_if(offer.begin(), offer.end(), [&](const io::OfferedPart& each) { return each.kind > shown.kind; });
    offer.insert(firstAfter, std::move(shown));
    offer.insert(offer.end(), missing.begin(), missing.end());
}

void CaseSealing::ask(const std::vector<io::OfferedPart>& offer) {
    LastSeal& last = m_session.part<LastSeal>();
    widgets::SealChoice proposed{rememberedSigner(), last.note, last.stampRequest, {}};
    std::transform(offer.begin(), offer.end(), std::back_inserter(proposed.parts), sealPartOf);
    for (widgets::SealPart& part : proposed.parts) {
        if (!part.run.isEmpty()) {
            part.chosen = part.kind == widgets::SealPart::Kind::Report ? last.report : last.page;
        }
    }
    auto* dialog = new widgets::SealDialog(proposed, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAdding([offer](const QString& path) {
        const io::OfferedPart added = io::addedPart(path.toStdString());
        std::vector<widgets::SealPart> parts{sealPartOf(added)};
        if (added.kind == io::OfferedPart::Kind::Run) {
            const std::vector<io::OfferedPart> missing = io::missingOf(added, offer);
            std::transform(missing.begin(), missing.end(), std::back_inserter(parts), sealPartOf);
        }
        return parts;
    });
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
        const auto made = [&](widgets::SealPart::Kind kind) {
            return std::any_of(choice.parts.begin(), choice.parts.end(),
                               [kind](const widgets::SealPart& part) { return isMade(part, kind); });
        };
        last = {choice.note, choice.stampRequest, made(widgets::SealPart::Kind::Report), made(widgets::SealPart::Kind::Page)};
        rememberSigner(choice.signer);
        if (const QString path = askForBundle(); !path.isEmpty()) {
            sealAt(path, choice);
        }
    });
    dialog->open();
}

QString CaseSealing::askForBundle() {
    const QFileInfo base(m_session.document().path());
    return askSavePath(&m_window, tr("Seal the case"), base.absolutePath() + u'/' + base.completeBaseName() + bundleEnding,
                       tr("Sealed bundles (*.rubblecase)"));
}

void CaseSealing::sealAt(const QString& path, const widgets::SealChoice& choice) {
    io::SealRequest request;
    request.casePath = m_session.document().path().toStdString();
    request.by = choice.signer.by.toStdString();
    request.note = choice.note.toStdString();
    request.signer = signerFiles(choice.signer);
    request.stampRequest = choice.stampRequest;
    std::vector<io::OfferedPart> parts;
    std::transform(choice.parts.begin(), choice.parts.end(), std::back_inserter(parts), offeredPart);
    io::choose(request, parts);
    const auto making = std::make_shared<SealMaking>();
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(making->parts),
                 [](const io::OfferedPart& part) { return part.chosen && !part.run.empty(); });
    if (!making->empty()) {
        making->opened = m_session.computation().content();
        making->theCase = m_session.document().theCase();
        making->casePath = request.casePath;
        making->report = m_report->wished();
    }
    // The reader keeps a run of the window in its place until it is packed.
    const RunRecord* record = m_session.computation().currentRun();
    const std::shared_ptr<io::RunReader> kept = record != nullptr ? record->reader : nullptr;
    const auto report = std::make_shared<io::SealReport>();
    const auto made = std::make_shared<std::vector<io::SealedExtra>>();
    m_session.computation().write(
        [request, kept, making, made, report, path](const Execution& execution) {
            // What is made lies in the bundle alone; given up, nothing of it is left.
            const io::ScratchFolder scratch;
            *made = making->make(request.runs, scratch.path(), execution);
            io::SealRequest whole = request;
            whole.extras.insert(whole.extras.end(), made->begin(), made->end());
            *report = io::sealCase(path.toStdString(), whole, execution);
            if (!report->stampRequest.empty()) {
                io::writeIn(requestBeside(path).toStdString(), report->stampRequest);
            }
        },
        [self = QPointer<CaseSealing>(this), session = &m_session, made, report, path](const std::exception_ptr& thrown) {
            if (const auto failure = failureOf(thrown)) {
                session->report(*failure);
            } else if (thrown != nullptr) {
                session->tell(tr("Cancelled; nothing half-made is left"));
            } else {
                session->tell(tr("Sealed %1; runs in it: %2").arg(QFileInfo(path).fileName()).arg(report->statement.runs.size()));
                if (self != nullptr) {
                    self->tell(path, *report, *made);
                }
            }
        });
}

void CaseSealing::tell(const QString& path, const io::SealReport& report, const std::vector<io::SealedExtra>& made) {
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
    if (!made.empty()) {
        QStringList names;
        for (const io::SealedExtra& extra : made) {
            names += QString::fromStdString(io::placeInBag(extra));
        }
        lines += tr("Made for it, and in it: %1").arg(QLocale().createSeparatedList(names));
    }
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
