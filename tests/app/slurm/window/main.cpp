#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "tests/app/slurm/one_node.h"
#include "tests/support/run_tests.h"

// Runs under an X server (xvfb-run) and beside the Slurm of one node.
int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "xcb");
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("rubble-tests"));
    QApplication application(argc, argv);
    QLocale::setDefault(QLocale(QLocale::English));
    const QTemporaryDir state;
    qputenv("RUBBLE_STATE", state.path().toUtf8());
    QSettings().clear();
    testing::AddGlobalTestEnvironment(new rubble::OneNode);
    return rubble::runTests(argc, argv);
}
