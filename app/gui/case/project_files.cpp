#include "app/gui/case/project_files.h"

#include "app/gui/session/session.h"
#include "io/base/machine.h"

namespace rubble {

namespace {

/// A folder in the state folder; empty where there is none, and then nothing is kept.
QString stateFolder(const char* name) {
    try {
        return QString::fromStdString(io::stateFolder()) + u'/' + QLatin1String(name);
    } catch (...) {
        return {};
    }
}

}  // namespace

ProjectFiles::ProjectFiles(Session& session)
    : autosave(session.document(), stateFolder("unsaved")), runs(session, stateFolder("runs")), recent(stateFolder("pictures")) {
    autosave.setInterval(session.preferences().autosaveSeconds);
    connect(&session, &Session::preferencesChanged, this,
            [this, &session] { autosave.setInterval(session.preferences().autosaveSeconds); });
    connect(&autosave, &Autosave::failed, &session, &Session::report);
    connect(&autosave, &Autosave::setAside, &session, [&session](const Failure& failure, const QString& where) {
        session.report({[what = failure.what] { return tr("Unsaved work of an earlier session cannot be read. %1").arg(what()); },
                        [where] { return where.isEmpty() ? QString() : tr("It was set aside as %1.").arg(where); }, "gui.project"});
    });
}

}  // namespace rubble
