#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QPainter>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/gui/case/new_case.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/places.h"
#include "widgets/case/case_preview.h"
#include "widgets/case/new_case_wizard.h"

namespace rubble {

namespace {

constexpr QSize pictureSize(800, 500);

/// Pictures of the screens that stand in the manual, held against the window as it is now.
///
/// Compared are the mean colours of tiles of 20 px: a letter or an edge that another font engine or rasteriser sets elsewhere by a
/// pixel moves a mean by a few of 255, a figure of time in a panel by somewhat more. A tile counts as another one when a channel
/// of its mean is off by more than 24 of 255. Up to 4 % of such tiles are figures that differ from run to run; a panel that is
/// missing, a view that is empty or another theme changes 10 % and more.
class Pictures : public Workbench {
protected:
    static constexpr int tile = 20;
    static constexpr int channelTolerance = 24;
    static constexpr double shareTolerance = 0.04;

    static QString kept(const QString& name) {
        return QString::fromStdString(sourcePath("resources/manual/pictures/")) + name + QStringLiteral(".png");
    }

    static QImage smallPictureOf(QWidget& shown) {
        QTest::qWait(400);
        return pictureOf(shown)
            .scaled(pictureSize, Qt::KeepAspectRatio, Qt::SmoothTransformation)
            .convertToFormat(QImage::Format_RGB32);
    }
    static double shareOfOthers(const QImage& a, const QImage& b) {
        int others = 0;
        int all = 0;
        for (int y = 0; y + tile <= a.height(); y += tile) {
            for (int x = 0; x + tile <= a.width(); x += tile) {
                std::array<int, 3> sums{};
                for (int j = 0; j < tile; ++j) {
                    for (int i = 0; i < tile; ++i) {
                        const QRgb p = a.pixel(x + i, y + j);
                        const QRgb q = b.pixel(x + i, y + j);
                        sums[0] += qRed(p) - qRed(q);
                        sums[1] += qGreen(p) - qGreen(q);
                        sums[2] += qBlue(p) - qBlue(q);
                    }
                }
                const bool other =
                    std::any_of(sums.begin(), sums.end(), [](int sum) { return std::abs(sum) > channelTolerance * tile * tile; });
                others += other ? 1 : 0;
                ++all;
            }
        }
        return static_cast<double>(others) / all;
    }
    /// With 32 shades of each colour, which halves the file and moves no channel by more than 7.
    static QImage thrifty(QImage picture) {
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const auto shade = [](int value) { return (value & 0xF8) | (value >> 5); };
                const QRgb p = picture.pixel(x, y);
                picture.setPixel(x, y, qRgb(shade(qRed(p)), shade(qGreen(p)), shade(qBlue(p))));
            }
        }
        return picture;
    }
    /// Compares, or takes the picture anew where RUBBLE_TAKE_PICTURES is set.
    void hold(const QString& name, QWidget& shown) {
        const QImage now = smallPictureOf(shown);
        if (qEnvironmentVariableIsSet("RUBBLE_TAKE_PICTURES")) {
            ASSERT_TRUE(thrifty(now).save(kept(name), "PNG", 0)) << kept(name).toStdString();
            return;
        }
        const QImage before = QImage(kept(name)).convertToFormat(QImage::Format_RGB32);
        ASSERT_EQ(before.size(), now.size()) << kept(name).toStdString();
        const double share = shareOfOthers(before, now);
        if (share > shareTolerance) {
            const QString actual = QString::fromStdString(buildPath()) + '/' + name + QStringLiteral(".actual.png");
            now.save(actual);
            ADD_FAILURE() << name.toStdString() << ": " << 100.0 * share << " % of the tiles are others; see "
                          << actual.toStdString() << ". RUBBLE_TAKE_PICTURES=1 takes all pictures anew.";
        }
    }
};

TEST_F(Pictures, WholeOfTheManualShowTheWindowAsItIs) {
    window->setTheme(QStringLiteral("light"));
    hold(QStringLiteral("start"), *window);
    openArch(wholeArch());
    makeCheap();
    session->document().setParameter(QStringLiteral("loose_structure"), std::string("at_once"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    window->rooms().deck->choose(PanelDeck::Fragments);
    hold(QStringLiteral("fragments"), *window);
    window->rooms().deck->choose(PanelDeck::Grid);
    hold(QStringLiteral("grid"), *window);
    window->rooms().deck->choose(PanelDeck::Effects);
    hold(QStringLiteral("effects"), *window);
    simulateToEnd();
    window->rooms().playback->clock().pause();
    window->rooms().playback->showInstant(window->rooms().playback->clock().last());
    hold(QStringLiteral("run"), *window);
    window->rooms().deck->choose(PanelDeck::Case);
    hold(QStringLiteral("views"), *window);
    window->rooms().opening->newCase(wholeArch());
    NewCase& making = *window->rooms().opening->caseInTheMaking();
    making.wizard().go(widgets::NewCaseWizard::Components);
    ASSERT_TRUE(QTest::qWaitFor([&] { return making.settled() && making.computation().results().fragments != nullptr; }, patience));
    making.wizard().components().tree().tree().topLevelItem(0)->child(0)->setSelected(true);
    making.preview().clock().setTime(making.preview().clock().last());
    hold(QStringLiteral("new-case"), making.wizard());
    making.wizard().reject();
    session->document().undoStack().setClean();
}

// What the tolerance lets pass is less than any of these.
TEST_F(Pictures, WholeTellAMissingViewAnotherPanelAndAnotherTheme) {
    window->setTheme(QStringLiteral("light"));
    openArch(wholeArch());
    window->rooms().playback->showInstant(window->rooms().playback->clock().last());
    const QImage whole = smallPictureOf(*window);
    EXPECT_LT(shareOfOthers(whole, smallPictureOf(*window)), shareTolerance / 4.0);
    EXPECT_LT(shareOfOthers(whole, thrifty(whole)), shareTolerance / 4.0);
    QImage without = whole;
    const QPoint corner = window->area().mapTo(window, QPoint(0, 0)) * whole.width() / window->width();
    QPainter(&without).fillRect(QRect(corner, window->area().size() * whole.width() / window->width()), Qt::white);
    EXPECT_GT(shareOfOthers(whole, without), 2.0 * shareTolerance);
    window->rooms().deck->choose(PanelDeck::Grid);
    EXPECT_GT(shareOfOthers(whole, smallPictureOf(*window)), shareTolerance);
    window->rooms().deck->choose(PanelDeck::Case);
    window->setTheme(QStringLiteral("dark"));
    EXPECT_GT(shareOfOthers(whole, smallPictureOf(*window)), 10.0 * shareTolerance);
    window->setTheme(QStringLiteral("light"));
}

}  // namespace
}  // namespace rubble
