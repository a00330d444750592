#include "tests/app/gui/left_session.h"

#include "app/gui/session/computation.h"
#include "app/gui/session/session.h"
#include "app/gui/window/event_loop.h"
#include "app/gui/window/main_window.h"

namespace rubble {

int leaveSession(const QStringList& words) {
    Session session;
    MainWindow window(session);
    window.show();
    window.rooms().project->autosave().setInterval(1);
    QObject::connect(&session.computation(), &Computation::opened, &window, [&] {
        const QString setting = words.value(1);
        session.document().setParameter(setting.section(u'=', 0, 0), setting.section(u'=', 1).toDouble());
    });
    window.open(words.value(0));
    return runEventLoop();
}

}  // namespace rubble
