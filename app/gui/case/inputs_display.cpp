#include "app/gui/case/inputs_display.h"

#include <QBoxLayout>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>
#include <algorithm>

#include "app/gui/session/session.h"
#include "io/case/case_file.h"
#include "io/case/input_check.h"
#include "io/site/input_files.h"
#include "widgets/basics/notice_bar.h"

namespace rubble {

namespace {

/// The beginning of a digest, enough to tell two files apart by eye.
QString shortened(const std::string& sha256) {
    return QString::fromStdString(sha256.substr(0, 8)) + QChar(0x2026);
}

QString roleName(InputRole role) {
    switch (role) {
        case InputRole::Fe:
            return InputsDisplay::tr("The FE result");
        case InputRole::Terrain:
            return InputsDisplay::tr("The terrain");
        case InputRole::Photograph:
            return InputsDisplay::tr("The photograph");
        case InputRole::Orthophoto:
            return InputsDisplay::tr("The orthophoto");
        case InputRole::Surroundings:
            return InputsDisplay::tr("The mesh of surroundings");
        case InputRole::Survey:
            break;
    }
    return InputsDisplay::tr("The survey");
}

}  // namespace

InputsDisplay::InputsDisplay(Session& session, QBoxLayout& notices, QWidget& window)
    : m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_notices(notices),
      m_window(window) {
    connect(&m_document, &Document::replaced, this, [this] {
        m_candidates.clear();
        refresh();
    });
    connect(&m_document, &Document::titleChanged, this, &InputsDisplay::refresh);
    connect(&m_document, &Document::inputsAccepted, this, [this] {
        m_computation.acceptInputs(m_document.theCase().inputs);
        refresh();
    });
    connect(&m_document, &Document::inputsChanged, this, &InputsDisplay::refresh);
    connect(&m_computation, &Computation::inputsFound, this, &InputsDisplay::refresh);
    connect(&m_computation, &Computation::failed, this, &InputsDisplay::refresh);
    connect(&m_computation, &Computation::prepared, this, &InputsDisplay::refresh);
    refresh();
}

const CaseInput* InputsDisplay::inputOf(const std::string& id) const {
    const auto& all = m_document.theCase().inputs;
    const auto found = std::find_if(all.begin(), all.end(), [&](const CaseInput& each) { return each.id == id; });
    return found != all.end() ? &*found : nullptr;
}

widgets::NoticeBar& InputsDisplay::bar(const std::string& id) {
    widgets::NoticeBar*& bar = m_bars[QString::fromStdString(id)];
    if (bar == nullptr) {
        // The layout may belong to no widget yet: without a parent the bar would be a window of its own.
        bar = new widgets::NoticeBar(&m_window);
        m_notices.addWidget(bar);
        connect(bar, &widgets::NoticeBar::chosen, this, [this, id](const QString& what) { choose(id, what); });
    }
    return *bar;
}

void InputsDisplay::refresh() {
    for (widgets::NoticeBar* each : std::as_const(m_bars)) {
        each->hide();
    }
    for (const CaseInput& input : m_document.theCase().inputs) {
        show(input);
    }
}

void InputsDisplay::show(const CaseInput& input) {
    using Choice = widgets::NoticeBar::Choice;
    const Choice locate{QStringLiteral("locate"), tr("Locate…"), tr("Choose where this file lies now"), false};
    const QString role = roleName(input.role);
    if (const auto other = m_candidates.constFind(QString::fromStdString(input.id)); other != m_candidates.constEnd()) {
        bar(input.id).setContent(
            tr("%1 is another file than the case was made with.").arg(QFileInfo(other->path).fileName()),
            tr("SHA-256 %1 instead of %2: results may differ from before.").arg(shortened(other->sha256), shortened(input.sha256)),
            {{QStringLiteral("use"), tr("Use it all the same"), tr("Take this file for the one that the case names; can be undone"),
              true},
             locate,
             {QStringLiteral("leave"), tr("Leave it"), tr("Keep the case as it is"), false}});
        bar(input.id).show();
        return;
    }
    const std::string path = io::inputPath(m_document.base().toStdString(), input);
    const bool isTerrain = input.role == InputRole::Terrain;
    const Choice without{QStringLiteral("without"), tr("Without terrain"),
                         tr("Let the debris fall on level ground again; can be undone"), true};
    if (isTerrain && m_computation.terrainFailed() && QFileInfo::exists(QString::fromStdString(path))) {
        bar(input.id).setContent(tr("The terrain %1 cannot be used.").arg(QFileInfo(QString::fromStdString(path)).fileName()),
                                 m_computation.failure()->what(), {without, locate});
        bar(input.id).show();
        return;
    }
    for (const io::FoundInput& found : m_computation.foundInputs()) {
        if (found.id != input.id || found.path != path) {
            continue;
        }
        const QString name = QFileInfo(QString::fromStdString(path)).fileName();
        if (!found.exists) {
            bar(input.id).setContent(tr("%1 %2 is missing.").arg(role, name),
                                     tr("It should lie in %1.").arg(QFileInfo(QString::fromStdString(path)).absolutePath()),
                                     isTerrain ? std::vector<Choice>{{locate.id, locate.text, locate.tip, true},
                                                                     {without.id, without.text, without.tip, false}}
                                               : std::vector<Choice>{{locate.id, locate.text, locate.tip, true}});
            bar(input.id).show();
        } else if (!input.sha256.empty() && !found.sha256.empty() && found.sha256 != input.sha256) {
            bar(input.id).setContent(tr("%1 %2 has changed since the case was saved.").arg(role, name),
                                     tr("SHA-256 %1 instead of %2: results may differ from before.")
                                         .arg(shortened(found.sha256), shortened(input.sha256)),
                                     {{QStringLiteral("accept"), tr("Accept"),
                                       tr("Take the file as it is now; the case records it, and it can be undone"), true},
                                      locate});
            bar(input.id).show();
        }
    }
}

void InputsDisplay::choose(const std::string& id, const QString& what) {
    const CaseInput* input = inputOf(id);
    if (input == nullptr) {
        return;
    }
    const QString key = QString::fromStdString(id);
    if (what == QLatin1String("locate")) {
        const QString from =
            QFileInfo(QString::fromStdString(io::inputPath(m_document.base().toStdString(), *input))).absolutePath();
        const QString path =
            QFileDialog::getOpenFileName(&m_window, tr("Locate %1").arg(QFileInfo(QString::fromStdString(input->path)).fileName()),
                                         QDir(from).exists() ? from : QFileInfo(m_document.base()).absolutePath());
        if (!path.isEmpty()) {
            locate(id, path);
        }
    } else if (what == QLatin1String("without")) {
        emit withoutTerrainRequested();
    } else if (what == QLatin1String("accept")) {
        accept(id);
    } else if (what == QLatin1String("use")) {
        const Candidate other = m_candidates.take(key);
        put(id, other.path, other.sha256, [name = QFileInfo(other.path).fileName()] { return tr("%1 used instead").arg(name); });
    } else {
        m_candidates.remove(key);
        refresh();
    }
}

void InputsDisplay::locate(const std::string& id, const QString& path) {
    const CaseInput* input = inputOf(id);
    if (input == nullptr) {
        return;
    }
    m_candidates.remove(QString::fromStdString(id));
    auto sha256 = std::make_shared<std::string>();
    m_computation.write(
        [path = path.toStdString(), role = input->role, kept = input->sha256, sha256](const Execution& execution) {
            execution.report({"gui.comparing_input", "Comparing with what the case was made with", {}}, 0.0);
            *sha256 = io::digestOfInput(path, role, execution).against(kept);
        },
        [self = QPointer(this), this, id, path, sha256, before = m_document.theCase().inputs](const std::exception_ptr& thrown) {
            if (self.isNull()) {
                return;  // the window has gone; its bar offers the choice anew
            }
            if (const auto failure = failureOf(thrown)) {
                m_session.report(*failure);
                return;
            }
            const CaseInput* now = inputOf(id);
            if (thrown != nullptr || now == nullptr || !(m_document.theCase().inputs == before)) {
                return;
            }
            const QString name = QFileInfo(path).fileName();
            if (now->sha256.empty() || now->sha256 == *sha256) {
                put(id, path, *sha256, [name] { return tr("%1 located").arg(name); });
                m_session.tell(tr("%1 was found; the case names its place").arg(name));
            } else {
                m_candidates.insert(QString::fromStdString(id), {path, *sha256});
                refresh();
            }
        });
}

void InputsDisplay::accept(const std::string& id) {
    for (const io::FoundInput& found : m_computation.foundInputs()) {
        if (found.id == id && !found.sha256.empty()) {
            const QString path = QString::fromStdString(found.path);
            put(id, path, found.sha256, [name = QFileInfo(path).fileName()] { return tr("changed %1 accepted").arg(name); });
            return;
        }
    }
}

void InputsDisplay::put(const std::string& id, const QString& path, const std::string& sha256, const widgets::Wording& what) {
    std::vector<CaseInput> inputs = m_document.theCase().inputs;
    const QDir folder = QFileInfo(m_document.base()).absoluteDir();
    for (CaseInput& input : inputs) {
        if (input.id == id) {
            input.path = folder.relativeFilePath(path).toStdString();
            input.sha256 = sha256;
        }
    }
    m_document.setInputs(std::move(inputs), what);
    refresh();
}

QStringList InputsDisplay::texts() const {
    QStringList all;
    for (const widgets::NoticeBar* each : m_bars) {
        if (!each->isHidden()) {
            all << each->text();
        }
    }
    return all;
}

}  // namespace rubble
