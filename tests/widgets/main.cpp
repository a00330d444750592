#include <QApplication>
#include <QLocale>

#include "tests/support/run_tests.h"

// Widgets without OpenGL need no X server.
int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QLocale::setDefault(QLocale(QLocale::English));
    return rubble::runTests(argc, argv);
}
