#include <QApplication>
#include <QLocale>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "tests/app/gui/left_session.h"
#include "tests/support/run_tests.h"

#ifdef __SANITIZE_ADDRESS__
// Libraries stay where they are, so that what they have lost at the end has a name.
extern "C" int dlclose(void*) noexcept {
    return 0;
}
#endif

// Runs under an X server (xvfb-run): the views need GLX. Settings and state go to places of their own.
int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "xcb");
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("rubble-tests"));
    QApplication application(argc, argv);
    QLocale::setDefault(QLocale(QLocale::English));
    // Processes of this program run side by side: each has settings of its own, and a session left early those of its test.
    const auto keepSettingsIn = [](const QString& folder) {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder);
    };
    if (const QStringList words = QCoreApplication::arguments(); words.value(1) == rubble::leftSessionWord) {
        keepSettingsIn(qEnvironmentVariable("RUBBLE_STATE"));
        return rubble::leaveSession(words.mid(2));
    }
    const QTemporaryDir state;
    qputenv("RUBBLE_STATE", state.path().toUtf8());
    // What the user has calibrated and compared on this machine is no part of a test.
    const QTemporaryDir cache;
    qputenv("XDG_CACHE_HOME", cache.path().toUtf8());
    keepSettingsIn(state.path());
    return rubble::runTests(argc, argv);
}
