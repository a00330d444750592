#include "app/gui/window/speed_measure.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"

namespace rubble {

namespace {

class Speed : public testing::Test {
protected:
    /// What is printed for a file; its exit code in `code`.
    QJsonObject measured(const QString& path, bool simulate) {
        Session session;
        MainWindow window(session);
        Options options;
        options.path = path;
        options.simulate = simulate;
        SpeedMeasure measure(window, options);
        QSignalSpy finished(&measure, &SpeedMeasure::finished);
        testing::internal::CaptureStdout();
        window.show();
        EXPECT_TRUE(QTest::qWaitFor([&] { return !finished.isEmpty(); }, 180'000));
        const std::string text = testing::internal::GetCapturedStdout();
        code = finished.isEmpty() ? -1 : finished.front().front().toInt();
        return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    }

    QTemporaryDir folder;
    int code = -1;
};

TEST_F(Speed, IsMeasuredOverFeResultAndRun) {
    const QString path =
        QString::fromStdString(cli::writeSmallCollapse(folder.filePath(QStringLiteral("small.exo")).toStdString()));
    const QJsonObject result = measured(path, true);
    EXPECT_EQ(code, 0);
    EXPECT_EQ(result["elements"].toInt(), cli::smallElements);
    EXPECT_TRUE(result["simulated"].toBool());
    EXPECT_GT(result["first_window_s"].toDouble(), 0.0);
    EXPECT_GT(result["first_picture_s"].toDouble(), 0.0);
    EXPECT_GT(result["prepared_s"].toDouble(), 0.0);
    EXPECT_GT(result["memory_peak_mib"].toDouble(), result["memory_mib"].toDouble() / 2.0);
    for (const char* visit : {"scrub_first_visit", "scrub_again"}) {
        const QJsonObject times = result[QLatin1String(visit)].toObject();
        EXPECT_GE(times["instants"].toInt(), 50) << visit;
        EXPECT_GT(times["median_ms"].toDouble(), 0.0) << visit;
        EXPECT_LE(times["median_ms"].toDouble(), times["p95_ms"].toDouble()) << visit;
        EXPECT_LE(times["p95_ms"].toDouble(), times["worst_ms"].toDouble()) << visit;
    }
}

TEST_F(Speed, OfWhatIsNoResultIsAFailure) {
    QFile rubbish(folder.filePath(QStringLiteral("rubbish.exo")));
    ASSERT_TRUE(rubbish.open(QIODevice::WriteOnly) && rubbish.write("no result at all") > 0);
    rubbish.close();
    EXPECT_TRUE(measured(rubbish.fileName(), false).isEmpty());
    EXPECT_EQ(code, 1);
}

}  // namespace
}  // namespace rubble
