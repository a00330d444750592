#include <QApplication>
#include <QFileInfo>
#include <QSettings>
#include <clocale>
#include <cstdio>
#include <cstdlib>

#include "app/gui/case/layout_memory.h"
#include "app/gui/case/new_case.h"
#include "app/gui/session/session.h"
#include "app/gui/session/settings.h"
#include "app/gui/window/event_loop.h"
#include "app/gui/window/first_visit.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/options.h"
#include "app/gui/window/renewed_window.h"
#include "app/gui/window/screenshot.h"
#include "app/gui/window/speed_measure.h"
#include "core/base/memory.h"
#include "widgets/basics/language.h"
#include "widgets/basics/theme.h"
#include "widgets/case/new_case_wizard.h"
#include "widgets/figures/figure_file.h"

namespace {

constexpr int usage = 2;

/// VTK needs GLX, so the platform is xcb unless the user says otherwise; without an X server the program would abort.
bool displayReady() {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "xcb");
    }
    return rubble::figures::displayAvailable();
}

QStringList argumentsOf(int argc, char** argv) {
    QStringList list;
    for (int i = 0; i < argc; ++i) {
        list << QString::fromLocal8Bit(argv[i]);
    }
    return list;
}

}  // namespace

int main(int argc, char** argv) {
    rubble::keepFreedMemory();
    const rubble::Options options = rubble::parseOptions(argumentsOf(argc, argv));
    if (options.wrong) {
        std::fprintf(stderr, "rubble: %s\n", qPrintable(options.text));
        return usage;
    }
    if (!options.text.isEmpty()) {
        std::printf("%s\n", qPrintable(options.text));
        return EXIT_SUCCESS;
    }
    if (!displayReady()) {
        std::fprintf(
            stderr,
            "rubble: there is no display to open a window on (DISPLAY names no X server that answers).\n"
            "Start it in a desktop session or under Xvfb (xvfb-run rubble ...), or use rubble-cli, which needs no display.\n");
        return EXIT_FAILURE;
    }
    QCoreApplication::setOrganizationName(QStringLiteral("rubble"));
    QCoreApplication::setApplicationName(QStringLiteral("rubble"));
    QGuiApplication::setDesktopFileName(QStringLiteral("org.rubble.Rubble"));
    QApplication application(argc, argv);
    // Qt takes the system's locale over for C as well, but files are read and written with a point as decimal sign everywhere.
    std::setlocale(LC_NUMERIC, "C");
    const QString aside = rubble::setDamagedSettingsAside();
    QSettings settings;
    const rubble::widgets::Preferences preferences = rubble::readPreferences(settings);
    rubble::widgets::speak(options.language.isEmpty() ? preferences.language : options.language);
    rubble::widgets::giveColours(rubble::widgets::themeNamed(preferences.theme));
    rubble::Session session;
    rubble::RenewedWindow renewed(session);
    rubble::MainWindow& window = renewed.window();
    if (!options.theme.isEmpty()) {
        window.setTheme(options.theme);
    }
    if (options.screenshot.isEmpty() && options.chart.isEmpty() && !options.measure) {
        window.restoreLayout();
        window.rooms().project->begin();
    }
    if (!aside.isEmpty()) {
        session.report(
            {[] { return QCoreApplication::translate("main", "The settings of the program could not be read."); },
             [aside] { return QCoreApplication::translate("main", "They start anew; the file was set aside as %1.").arg(aside); },
             "gui.settings"});
    }
    if (options.size.isValid()) {
        window.resize(options.size);
    }
    if (options.measure) {
        rubble::SpeedMeasure measure(window, options);
        QObject::connect(&measure, &rubble::SpeedMeasure::finished, &application, &QCoreApplication::exit);
        window.show();
        return rubble::runEventLoop();
    }
    window.show();
    if (options.accuracy) {
        window.rooms().accuracy->compareWhenReady();
    }
    if (options.sample) {
        window.rooms().opening->openSample();
    } else if (options.newCaseStep && !options.path.isEmpty()) {
        window.rooms().opening->newCase(options.path);
        window.rooms().opening->caseInTheMaking()->wizard().go(
            static_cast<rubble::widgets::NewCaseWizard::Step>(*options.newCaseStep));
    } else if (!options.path.isEmpty()) {
        window.open(options.path, options.simulate);
    } else if (aside.isEmpty() && rubble::FirstVisit::isDue(session, options)) {
        window.firstVisit().begin();
    }
    if (!options.screenshot.isEmpty() || !options.chart.isEmpty()) {
        new rubble::Screenshot(window, options);
    } else if (options.time || options.panel) {
        QObject::connect(&session.computation(), &rubble::Computation::opened, &session, [&renewed, options] {
            rubble::WindowRooms& rooms = renewed.window().rooms();
            if (options.panel) {
                rooms.deck->choosePage(*options.panel);
            }
            if (options.time) {
                rooms.playback->showInstant(*options.time);
            }
        });
    }
    return rubble::runEventLoop();
}
