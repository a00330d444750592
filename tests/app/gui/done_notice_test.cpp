#include "app/gui/window/done_notice.h"

#include <gtest/gtest.h>

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVirtualObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"

namespace rubble {

namespace {

class Notices : public Workbench {
protected:
    void SetUp() override {
        Workbench::SetUp();
        window->open(QString::fromStdString(cli::writeSmallCollapse(m_folder.filePath(QStringLiteral("small.exo")).toStdString())));
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    }
    void simulate() {
        window->rooms().runs->simulate(false);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
        QTest::qWait(600);
    }
    QTemporaryDir m_folder;
};

TEST_F(Notices, ComeWhenLongWorkEndsAndTheUserIsElsewhere) {
    QStringList told;
    const auto show = [&](const QString& what, const QString& about) { told << what << about; };
    new DoneNotice(*window, 0, show);
    simulate();
    EXPECT_TRUE(told.isEmpty()) << "the window is in front: its status line tells";
    QApplication::setActiveWindow(nullptr);
    simulate();
    ASSERT_TRUE(QTest::qWaitFor([&] { return told.size() == 2; }, patience));
    EXPECT_TRUE(told[0].startsWith(QStringLiteral("Simulated in"))) << told[0].toStdString();
    EXPECT_EQ(told[1], QStringLiteral("small"));
}

TEST_F(Notices, DoNotComeForShortWork) {
    int told = 0;
    new DoneNotice(*window, 3'600'000, [&](const QString&, const QString&) { ++told; });
    QApplication::setActiveWindow(nullptr);
    simulate();
    EXPECT_EQ(told, 0);
}

/// Stands in for the desktop: keeps what it is asked to show.
class Desktop : public QDBusVirtualObject {
public:
    QString introspect(const QString&) const override { return {}; }
    bool handleMessage(const QDBusMessage& message, const QDBusConnection&) override {
        asked << message;
        return true;
    }
    QList<QDBusMessage> asked;
};

TEST(DesktopNotification, HasWhatTheSpecificationAsksFor) {
    QProcess daemon;
    daemon.start(QStringLiteral("dbus-daemon"),
                 {QStringLiteral("--session"), QStringLiteral("--nofork"), QStringLiteral("--print-address")});
    ASSERT_TRUE(daemon.waitForReadyRead(30'000)) << daemon.errorString().toStdString();
    const QString address = QString::fromLatin1(daemon.readAllStandardOutput().trimmed());
    {
        QDBusConnection desktopBus = QDBusConnection::connectToBus(address, QStringLiteral("desktop"));
        ASSERT_TRUE(desktopBus.registerService(QStringLiteral("org.freedesktop.Notifications")));
        Desktop desktop;
        ASSERT_TRUE(desktopBus.registerVirtualObject(QStringLiteral("/org/freedesktop/Notifications"), &desktop));
        const QDBusConnection bus = QDBusConnection::connectToBus(address, QStringLiteral("program"));
        notifyDesktop(bus, QStringLiteral("Simulated in 42 s"), QStringLiteral("arch <1>"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !desktop.asked.isEmpty(); }, 30'000));
        EXPECT_EQ(desktop.asked[0].member(), QStringLiteral("Notify"));
        EXPECT_EQ(desktop.asked[0].signature(), QStringLiteral("susssasa{sv}i"));
        EXPECT_EQ(desktop.asked[0].arguments()[3].toString(), QStringLiteral("Simulated in 42 s"));
        EXPECT_EQ(desktop.asked[0].arguments()[4].toString(), QStringLiteral("arch &lt;1&gt;"));
        desktopBus.unregisterObject(QStringLiteral("/org/freedesktop/Notifications"));
    }
    QDBusConnection::disconnectFromBus(QStringLiteral("program"));
    QDBusConnection::disconnectFromBus(QStringLiteral("desktop"));
    daemon.kill();
    daemon.waitForFinished();
    // Where there is no bus, nothing happens.
    notifyDesktop(QDBusConnection(QStringLiteral("none")), QStringLiteral("Simulated"), {});
}

}  // namespace

}  // namespace rubble
