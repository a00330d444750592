#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QEvent>
#include <QLocale>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QWidget>

#include "tests/app/gui/left_session.h"
#include "tests/support/run_tests.h"

#ifdef __SANITIZE_ADDRESS__
// Libraries stay where they are, so that what they have lost at the end has a name.
extern "C" int dlclose(void*) noexcept {
    return 0;
}
#endif

namespace {

/// Fails a test in which a widget without a parent comes up as a window of its own: it flashes up beside the workbench.
class BareWindows : public QObject {
public:
    BareWindows() { qApp->installEventFilter(this); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Show) {
            const auto* widget = qobject_cast<const QWidget*>(watched);
            if (widget != nullptr && widget->isWindow() && widget->parentWidget() == nullptr && isOfThisProgram(*widget)) {
                ADD_FAILURE() << "a bare window: " << widget->metaObject()->className() << " \""
                              << widget->objectName().toStdString() << "\" of " << widget->width() << " x " << widget->height();
            }
        }
        return QObject::eventFilter(watched, event);
    }

private:
    /// Windows that are meant, and popups that Qt makes by itself.
    static bool isOfThisProgram(const QWidget& widget) {
        const Qt::WindowType type = widget.windowType();
        return qobject_cast<const QMainWindow*>(&widget) == nullptr && qobject_cast<const QDialog*>(&widget) == nullptr &&
               qobject_cast<const QMenu*>(&widget) == nullptr && type != Qt::Popup && type != Qt::ToolTip && type != Qt::Desktop;
    }
};

}  // namespace

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
    // Shaders that the driver has compiled are: without them each program compiles them anew.
    if (qEnvironmentVariableIsEmpty("MESA_SHADER_CACHE_DIR")) {
        const QString usual = qEnvironmentVariable("XDG_CACHE_HOME", QDir::homePath() + QStringLiteral("/.cache"));
        qputenv("MESA_SHADER_CACHE_DIR", usual.toUtf8());
    }
    qputenv("XDG_CACHE_HOME", cache.path().toUtf8());
    keepSettingsIn(state.path());
    const BareWindows bare;
    return rubble::runTests(argc, argv);
}
