#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <filesystem>

#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/run/run_panel.h"
#include "widgets/views/status_line.h"

namespace rubble {

namespace {

/// The small collapse up to some state, as an analysis that goes on would have written it by then.
/// @param perSecond  s in which it does what takes a second
void writeUpTo(std::size_t states, const std::string& path, double perSecond = 1.0) {
    io::ExodusBuilder builder = cli::smallCollapse();
    builder.times.resize(states);
    for (double& time : builder.times) {
        time *= perSecond;
    }
    builder.write(path + ".next");
    std::filesystem::rename(path + ".next", path);
}

}  // namespace

TEST_F(Workbench, RefreshShowsWhatHasComeAndKeepsTheRest) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("growing.exo")).toStdString();
    writeUpTo(3, path);
    window->open(QString::fromStdString(path));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    session->document().setParameter(QStringLiteral("multiple"), 3.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    window->area().views().setAnimated(false);
    window->area().views().look(render::Preset::Top);
    window->rooms().playback->showInstant(0.1);
    const render::View view = window->area().views().view();
    const int panel = window->rooms().deck->stack().currentIndex();
    const auto before = session->computation().inputs().fe;
    ASSERT_EQ(before->stateCount(), 3u);

    QTest::keyClick(window, Qt::Key_F5);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window->findChild<widgets::StatusLine*>()->activityText().contains(QStringLiteral("Nothing new")); },
        patience))
        << window->findChild<widgets::StatusLine*>()->activityText().toStdString();
    EXPECT_EQ(session->computation().inputs().fe, before);

    writeUpTo(6, path);
    QTest::keyClick(window, Qt::Key_F5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().inputs().fe != before && prepared(); }, patience));
    EXPECT_EQ(session->computation().inputs().fe->stateCount(), 6u);
    EXPECT_DOUBLE_EQ(window->rooms().playback->clock().time(), 0.1);
    EXPECT_EQ(window->area().views().view().cameras[0], view.cameras[0]);
    EXPECT_EQ(window->area().views().view().layout, view.layout);
    EXPECT_EQ(window->rooms().deck->stack().currentIndex(), panel);
    EXPECT_EQ(session->document().scenario().grid.multiple, 3.0);
    EXPECT_TRUE(session->document().undoStack().canUndo());
    EXPECT_THAT(window->findChild<widgets::StatusLine*>()->activityText().toStdString(),
                testing::HasSubstr("3 states more, to 0.50 s"));
}

TEST_F(Workbench, RefreshOfAGrowingBlastKeepsWhatIsHalfTyped) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("blast.exo")).toStdString();
    writeUpTo(3, path, 1e-4);
    window->open(QString::fromStdString(path));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    const auto before = session->computation().inputs().fe;
    window->rooms().deck->choose(PanelDeck::Run);
    auto* field = window->findChild<widgets::ParameterEditor*>(QStringLiteral("settle_time"))->findChild<QLineEdit*>();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("12"));
    const auto* said = window->findChild<widgets::Notice*>(QStringLiteral("briefResult"));
    EXPECT_TRUE(said->text().contains(QStringLiteral("20.00 µs"))) << qPrintable(said->text());
    writeUpTo(6, path, 1e-4);
    QTest::keyClick(window, Qt::Key_F5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().inputs().fe != before && prepared(); }, patience));
    EXPECT_EQ(field->text(), QStringLiteral("12"));
    EXPECT_TRUE(said->text().contains(QStringLiteral("50.00 µs"))) << qPrintable(said->text());
    field->undo();
    window->actions()[ActionId::Close].trigger();
}

TEST_F(Workbench, CopiesOfResultsAreKeptWhenAskedFor) {
    const QTemporaryDir folder, cache;
    qputenv("RUBBLE_CACHE", cache.path().toUtf8());
    const std::string path = folder.filePath(QStringLiteral("small.exo")).toStdString();
    writeUpTo(6, path);
    const auto openIt = [&] {
        window->open(QString::fromStdString(path));
        EXPECT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        return session->computation().inputs().fe->contents().fingerprint;
    };
    const Digest plain = openIt();
    EXPECT_FALSE(std::filesystem::exists(cache.path().toStdString() + "/fe"));
    window->actions()[ActionId::KeepCopies].trigger();
    window->actions()[ActionId::Close].trigger();
    EXPECT_EQ(openIt(), plain);
    ASSERT_TRUE(std::filesystem::exists(cache.path().toStdString() + "/fe"));
    window->actions()[ActionId::Close].trigger();
    EXPECT_EQ(openIt(), plain);
    window->actions()[ActionId::KeepCopies].trigger();
    qunsetenv("RUBBLE_CACHE");
}

}  // namespace rubble
