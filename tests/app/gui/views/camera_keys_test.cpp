#include "app/gui/views/camera_keys.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QUndoStack>

#include "app/gui/case/file_commands.h"
#include "app/gui/exports/picture_export.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "tests/app/gui/workbench.h"
#include "widgets/evidence/movie_dialog.h"
#include "widgets/views/timeline.h"

namespace rubble {

namespace {

class CameraKeysTest : public FreshWorkbench {
protected:
    void SetUp() override {
        FreshWorkbench::SetUp();
        if (HasFatalFailure()) {
            return;
        }
        openArch();
        views().setAnimated(false);
    }
    widgets::ViewWidget& views() { return window->area().views(); }
    const std::vector<CameraKey>& keys() { return session->document().theCase().cameraKeys; }
    widgets::Timeline& timeline() { return *window->findChild<widgets::Timeline*>(); }
    void goTo(double time) { window->rooms().playback->showInstant(time); }
    /// Sets a key by its shortcut, with the camera turned so often by 15 degrees.
    void keyAt(double time, int turns) {
        goTo(time);
        for (int i = 0; i < turns; ++i) {
            QTest::keyClick(window, Qt::Key_Left, Qt::ControlModifier);
        }
        QTest::keyClick(window, Qt::Key_B, Qt::ShiftModifier);
    }
};

TEST_F(CameraKeysTest, AKeyIsSetByItsShortcutAndUndone) {
    EXPECT_FALSE(window->actions()[ActionId::AlongCameraKeys].isEnabled());
    keyAt(1.0, 0);
    ASSERT_EQ(keys().size(), 1U);
    EXPECT_EQ(keys()[0].time, 1.0);
    EXPECT_EQ(keys()[0].position, views().view().cameras[0].position);
    EXPECT_EQ(timeline().cameraKeys(), std::vector{1.0});
    keyAt(0.5, 1);
    ASSERT_EQ(keys().size(), 2U);
    EXPECT_EQ(keys()[0].time, 0.5) << "in the order of their times";
    keyAt(1.0, 1);
    ASSERT_EQ(keys().size(), 2U) << "another camera takes the place of the one at this instant";
    QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(keys().empty());
    EXPECT_TRUE(timeline().cameraKeys().empty());
}

TEST_F(CameraKeysTest, ItIsRemovedWhereItStands) {
    keyAt(1.0, 0);
    goTo(0.5);
    EXPECT_FALSE(window->actions()[ActionId::RemoveCameraKey].isEnabled());
    goTo(1.0);
    ASSERT_TRUE(window->actions()[ActionId::RemoveCameraKey].isEnabled());
    window->actions()[ActionId::RemoveCameraKey].trigger();
    EXPECT_TRUE(keys().empty());
}

TEST_F(CameraKeysTest, TheViewsLookAlongWhileTimeGoesOn) {
    keyAt(0.5, 0);
    const render::Camera first = views().view().cameras[0];
    keyAt(1.5, 3);
    const render::Camera last = views().view().cameras[0];
    window->actions()[ActionId::AlongCameraKeys].trigger();
    goTo(0.5);
    EXPECT_TRUE(views().view().cameras[0] == first);
    goTo(1.0);
    EXPECT_GT((views().view().cameras[0].position - first.position).norm(), 0.1);
    EXPECT_GT((views().view().cameras[0].position - last.position).norm(), 0.1);
    goTo(1.5);
    EXPECT_TRUE(views().view().cameras[0] == last);
    window->actions()[ActionId::AlongCameraKeys].trigger();
    goTo(0.5);
    EXPECT_TRUE(views().view().cameras[0] == last) << "it stays where it is";
}

TEST_F(CameraKeysTest, TheCaseKeepsThem) {
    keyAt(0.5, 0);
    keyAt(1.5, 2);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("keys.rubble"));
    ASSERT_TRUE(window->rooms().files->saveTo(path));
    EXPECT_EQ(io::loadCase(path.toStdString()).cameraKeys, keys());
}

TEST_F(CameraKeysTest, AMovieMovesAlongThem) {
    views().setView([&] {
        render::View view = views().view();
        view.layout = render::Layout::FeOnly;
        return view;
    }());
    keyAt(0.5, 0);
    keyAt(0.6, 6);
    widgets::MovieChoice offered;
    offered.settings.from = 0.5;
    offered.settings.to = 0.6;
    offered.settings.cameras = keys();
    widgets::MovieDialog dialog(offered, false, window);
    auto* along = dialog.findChild<QCheckBox*>(QStringLiteral("movieAlong"));
    ASSERT_TRUE(along->isChecked());
    EXPECT_EQ(dialog.choice().settings.cameras.size(), 2U);
    along->click();
    EXPECT_TRUE(dialog.choice().settings.cameras.empty());
    QTemporaryDir folder;
    std::vector<QImage> lasts;
    for (const bool moving : {false, true}) {
        widgets::MovieChoice choice;
        choice.settings = {0.5, 0.6, 10.0, 1.0, moving ? keys() : std::vector<CameraKey>()};
        choice.pixels = {320, 200};
        choice.encoded = false;
        render::View view = views().view();
        view.cameras.fill(render::Camera{keys()[0].position, keys()[0].focalPoint, keys()[0].up, keys()[0].viewAngle, false, 1.0});
        const QString path = folder.filePath(moving ? QStringLiteral("moving") : QStringLiteral("still"));
        window->rooms().pictures->exportMovieTo(path, choice, view, views().data());
        const QString last = path + QStringLiteral("/frame-00002.png");
        ASSERT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(last) && !session->computation().busy(); }, patience));
        lasts.emplace_back(last);
        EXPECT_EQ(io::readProvenance((path + QStringLiteral("/frame-00001.png")).toStdString())->text.find("camera_keys_s") !=
                      std::string::npos,
                  moving);
    }
    EXPECT_NE(lasts[0], lasts[1]) << "seen from elsewhere";
}

}  // namespace

}  // namespace rubble
