#include <QDir>
#include <QImageWriter>
#include <QSignalSpy>
#include <QTest>
#include <array>
#include <fstream>

#include "app/gui/case/file_commands.h"
#include "app/gui/evidence/evidence_display.h"
#include "app/gui/evidence/photograph_places.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/places.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/evidence_table.h"
#include "widgets/figures/camera_picture.h"
#include "widgets/views/view_widget.h"

namespace rubble {
namespace {

/// Where the photographs of these tests and their case lie; kept for a look.
QString folder() {
    const QString path = QString::fromStdString(buildPath("evidence"));
    QDir().mkpath(path);
    return path;
}

constexpr QSize photoSize(2000, 1500);

/// A camera beside a structure that sees it whole, with a lens that bends lines.
CameraModel cameraFor(const Mesh& mesh) {
    Aabb bounds;
    for (const Vec3& node : mesh.nodes) {
        bounds.extend(node);
    }
    CameraModel camera;
    const double size = bounds.sizes().head<2>().norm();
    camera.place = bounds.center() + Vec3(-0.35 * size, -0.95 * size, 0.25 * size);
    const Vec3 ahead = (bounds.center() - camera.place).normalized();
    const Vec3 right = ahead.cross(Vec3::UnitZ()).normalized();
    Mat3 axes;
    axes.row(0) = right;
    axes.row(1) = ahead.cross(right);
    axes.row(2) = ahead;
    camera.toCamera = Quat(axes);
    camera.focal = 1900.0;
    camera.principal = {photoSize.width() / 2.0, photoSize.height() / 2.0};
    camera.radial = {-0.06, 0.0};
    return camera;
}

class Evidence : public Workbench {
protected:
    void simulated() {
        openArch(wholeArch());
        session->document().setParameter(QStringLiteral("loose_structure"), std::string("fe"));  // quicker
        makeCheap();
        simulateToEnd();
    }
    /// What a camera sees at the end of the run, as a photograph.
    QString photograph(const CameraModel& camera, const QString& name) {
        render::View view = window->area().views().view();
        view.time = window->rooms().playback->clock().last();
        view.theme = render::Theme::Dark;  // unlike the overlay, so that a swap would show
        figures::CameraStudio studio(window->rooms().scene->data());
        const QImage picture = studio.picture(view, camera, photoSize, photoSize.width(), 50.0);
        const QString path = folder() + u'/' + name;
        QImageWriter writer(path);
        writer.setQuality(90);
        EXPECT_TRUE(writer.write(picture));
        return path;
    }
    void add(const QString& path) {
        const std::size_t before = session->document().theCase().photographs.size();
        window->rooms().evidence->add({path});
        ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().theCase().photographs.size() > before; }, patience));
        ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().evidence->settled(); }, patience));
    }
    /// Clicks nodes of the structure with an error of a pixel or so, the fourth by far too much.
    void clickPoints(const CameraModel& camera) {
        const FeResult& fe = *session->computation().inputs().fe;
        const auto state = fe.state(fe.stateCount() - 1);
        const std::size_t count = fe.mesh().nodeCount();
        int clicked = 0;
        for (std::size_t k = 0; clicked < 14; ++k) {
            const Vec3& node = state->positions[(k * 2654435761u) % count];
            const auto at = camera.project(node);
            if (!at || at->x() < 20.0 || at->y() < 20.0 || at->x() > photoSize.width() - 20.0 ||
                at->y() > photoSize.height() - 20.0) {
                continue;
            }
            const double off = clicked == 3 ? 140.0 : 0.8 * ((clicked * 7) % 5 - 2);
            window->rooms().evidence->placePicture(QPointF(at->x() + off, at->y() - 0.5 * off));
            window->rooms().evidence->placeModel(node, QStringLiteral("node %1").arg(clicked + 1));
            ++clicked;
        }
    }
    const Photograph& photo() { return session->document().theCase().photographs.at(0); }
    void edit(const std::function<void(Photograph&)>& change, const char* what) {
        Photograph after = photo();
        change(after);
        emit window->rooms().deck->evidence().photographEdited(after, [what] { return QString::fromLatin1(what); });
    }
};

/// Mean difference of two pictures in luminance, 0 to 255.
double differenceOf(const QImage& a, const QImage& b) {
    const QImage same = b.scaled(a.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    double sum = 0.0;
    for (int y = 0; y < a.height(); y += 3) {
        for (int x = 0; x < a.width(); x += 3) {
            sum += std::abs(qGray(a.pixel(x, y)) - qGray(same.pixel(x, y)));
        }
    }
    return sum / ((a.width() / 3.0) * (a.height() / 3.0));
}

TEST_F(Evidence, ASyntheticPhotographIsMatchedSeenThroughAndCompared) {
    simulated();
    const CameraModel camera = cameraFor(session->computation().inputs().fe->mesh());
    const QString path = photograph(camera, QStringLiteral("synthetic.jpg"));
    const std::string before = io::sha256OfFile(path.toStdString());
    add(path);
    EXPECT_EQ(photo().facts.width, photoSize.width());
    EXPECT_EQ(window->rooms().deck->rail().current(), PanelDeck::Evidence);
    EXPECT_FALSE(window->rooms().evidence->match()) << "there are no points yet";
    EXPECT_FALSE(window->rooms().deck->evidence().content().noMatch.isEmpty());

    clickPoints(camera);
    edit([](Photograph& p) { p.camera.radialTerms = 1; }, "distortion");
    ASSERT_TRUE(window->rooms().evidence->match());
    const CameraMatch& match = *window->rooms().evidence->match();
    EXPECT_EQ(match.wrong(), std::vector<std::size_t>{3});
    EXPECT_LT((match.camera.place - camera.place).norm(), 2.0 * match.placeRadius);
    EXPECT_LT(match.rms, 4.0);

    // What the simulation shows from the camera that was found is what the photograph shows.
    widgets::EvidencePage& page = (*window->findChild<widgets::EvidencePage*>());
    page.setShow(widgets::PhotoView::Show::Swipe);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().evidence->settled(); }, patience));
    render::View view = page.model().view();
    view.time = window->rooms().playback->clock().last();
    view.theme = render::Theme::Dark;
    figures::CameraStudio studio(window->rooms().scene->data());
    const QImage real(path);
    const double good = differenceOf(studio.picture(view, match.camera, photoSize, 1000, 50.0), real);
    EXPECT_LT(good, 3.0);
    CameraModel straight = match.camera;
    straight.radial = {0.0, 0.0};
    straight.principal += Eigen::Vector2d(60.0, 0.0);
    EXPECT_GT(differenceOf(studio.picture(view, straight, photoSize, 1000, 50.0), real), 1.5 * good)
        << "the test would see nothing";

    // The outline as the true camera sees the debris.
    const EvidenceRun run(session->computation().inputs(), session->computation().currentRun());
    const SiteShape site = siteOfRun(run.mapped(), std::nullopt, 1.0, camera.place, Execution());
    const SitePicture seen = pictureOf(site, camera, photoSize.width(), photoSize.height(), photoSize.width());
    edit(
        [&](Photograph& p) {
            for (const auto& ring : outlinesOf(seen, debrisIn(seen, true))) {
                p.masks.push_back({MaskClass::Debris, ring});
            }
        },
        "outline");
    window->rooms().evidence->compare();
    EXPECT_TRUE(window->rooms().evidence->work().comparing());
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().evidence->comparison() != nullptr; }, patience));
    const PhotoComparison& made = *window->rooms().evidence->comparison();
    EXPECT_GT(made.iou.best, 0.8);
    EXPECT_GT(made.iou.spread, 0.0);
    EXPECT_LT(made.edgePixels.best, 6.0);
    EXPECT_FALSE(window->rooms().deck->evidence().content().comparisonStale);
    edit([](Photograph& p) { p.masks.push_back(p.masks.front()); }, "another outline");
    EXPECT_TRUE(window->rooms().deck->evidence().content().comparisonStale);
    window->rooms().evidence->compare();
    emit window->rooms().deck->evidence().cancelRequested();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().evidence->work().comparing(); }, patience));
    EXPECT_TRUE(window->rooms().deck->evidence().content().comparisonStale) << "what is shown is of the outlines before";
    page.setShow(widgets::PhotoView::Show::Outline);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return window->rooms().evidence->settled() && !page.photo().content().outlines.empty(); }, patience));
    EXPECT_EQ(io::sha256OfFile(path.toStdString()), before);

    ASSERT_TRUE(window->rooms().files->saveTo(folder() + QStringLiteral("/synthetic.rubble")));
    const Case saved = io::loadCase(folder().toStdString() + "/synthetic.rubble");
    EXPECT_EQ(saved.photographs, session->document().theCase().photographs);
    EXPECT_EQ(saved.inputs.back().path, "synthetic.jpg");
    EXPECT_EQ(saved.inputs.back().sha256, before);
}

TEST_F(Evidence, TheListKnowsEachCameraWithoutARun) {
    openArch();
    const auto plain = [&](const char* name, int grey) {
        QImage picture(photoSize, QImage::Format_RGB32);
        picture.fill(qRgb(grey, grey, grey));
        const QString path = folder() + u'/' + QString::fromLatin1(name);
        EXPECT_TRUE(picture.save(path));
        return path;
    };
    add(plain("grey.jpg", 120));
    clickPoints(cameraFor(session->computation().inputs().fe->mesh()));
    ASSERT_TRUE(window->rooms().evidence->match());
    const double within = window->rooms().evidence->match()->placeRadius;
    const auto& list = window->rooms().deck->evidence().list();
    const QString shown = widgets::shownNumber(within);
    EXPECT_EQ(list.item(0, 2)->text(), shown) << "nothing was simulated";
    // Another one is chosen: what is known of the first stays.
    add(plain("dark.jpg", 40));
    ASSERT_EQ(list.rowCount(), 2);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->part<PhotographPlaces>().busy(); }, patience));
    EXPECT_EQ(list.item(0, 2)->text(), shown);
    EXPECT_EQ(list.item(1, 2)->text(), QStringLiteral("not known"));
}

TEST_F(Evidence, EveryEditIsOneStepOfUndo) {
    openArch();
    const CameraModel camera = cameraFor(session->computation().inputs().fe->mesh());
    add(photograph(camera, QStringLiteral("undo.jpg")));
    QUndoStack& stack = session->document().undoStack();
    const int begin = stack.index();
    window->rooms().evidence->placePicture({100.0, 200.0});
    EXPECT_EQ(stack.index(), begin) << "a point without its counterpart is no edit";
    window->rooms().evidence->placeModel({1.0, 2.0, 3.0}, QStringLiteral("pier"));
    edit([](Photograph& p) { p.time = 3.0; }, "time");
    emit window->findChild<widgets::EvidencePage*>()->photo().maskDrawn({MaskClass::Hidden, {{0.0, 0.0}, {9.0, 0.0}, {9.0, 9.0}}});
    emit window->findChild<widgets::EvidencePage*>()->photo().markMoved(0, {111.0, 222.0});
    EXPECT_EQ(stack.index(), begin + 4);
    EXPECT_EQ(photo().pairs.at(0).picture, Eigen::Vector2d(111.0, 222.0));
    EXPECT_EQ(photo().masks.size(), 1u);
    stack.undo();
    EXPECT_EQ(photo().pairs.at(0).picture, Eigen::Vector2d(100.0, 200.0));
    stack.undo();
    EXPECT_TRUE(photo().masks.empty());
    stack.setIndex(begin - 1);
    EXPECT_TRUE(session->document().theCase().photographs.empty());
    EXPECT_EQ(session->document().theCase().inputs.size(), 1u);
    EXPECT_EQ(window->rooms().evidence->chosen(), -1);
    stack.setIndex(begin + 4);
    EXPECT_EQ(photo().masks.size(), 1u);
    EXPECT_TRUE(prepared()) << "no result depends on photographs";
}

// Keys of the camera moved the views behind the page, and nothing that was seen.
TEST_F(Evidence, BesideAPhotographTheKeysOfTheCameraMoveTheModelThere) {
    openArch();
    add(photograph(cameraFor(session->computation().inputs().fe->mesh()), QStringLiteral("beside.jpg")));
    auto& page = *window->findChild<widgets::EvidencePage*>();
    page.setBeside(true);
    widgets::ViewWidget& model = page.model();
    widgets::ViewWidget& views = window->area().views();
    model.setAnimated(false);
    views.setAnimated(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return model.isVisible() && model.data().fe != nullptr; }, patience));
    const render::Camera behind = views.view().cameras[0];
    constexpr std::array moves{ActionId::LookTop, ActionId::TurnDown, ActionId::ZoomIn, ActionId::Parallel, ActionId::Fit};
    const auto press = [&](ActionId id) {
        const QKeyCombination keys = window->actions()[id].shortcut()[0];
        QTest::keyClick(&*window, keys.key(), keys.keyboardModifiers());
    };
    for (const ActionId id : moves) {
        const render::Camera before = render::cameraOf(model.view(), render::PaneContent::Fragments);
        press(id);
        EXPECT_FALSE(render::cameraOf(model.view(), render::PaneContent::Fragments) == before)
            << window->actions()[id].text().toStdString();
        EXPECT_TRUE(views.view().cameras[0] == behind);
    }
    window->rooms().deck->choose(PanelDeck::Run);
    ASSERT_TRUE(QTest::qWaitFor([&] { return views.isVisible(); }, patience));
    press(ActionId::TurnLeft);
    EXPECT_FALSE(views.view().cameras[0] == behind) << "elsewhere the views are moved";
}

TEST_F(Evidence, WhatIsNoPhotographIsRefusedInPlace) {
    openArch();
    const QString path = folder() + QStringLiteral("/text.jpg");
    std::ofstream(path.toStdString()) << "no photograph";
    EXPECT_TRUE(window->rooms().evidence->takes({path}));
    EXPECT_FALSE(window->rooms().evidence->takes({path, arch()}));
    window->rooms().evidence->add({path});
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().evidence->settled(); }, patience));
    EXPECT_TRUE(session->document().theCase().photographs.empty());
    bool said = false;
    for (const auto* notice : window->rooms().deck->evidence().findChildren<widgets::Notice*>()) {
        said = said || notice->text().contains(QStringLiteral("text.jpg"));
    }
    EXPECT_TRUE(said);
}

TEST_F(Evidence, APhotographThatChangedIsPointedOut) {
    openArch();
    const CameraModel camera = cameraFor(session->computation().inputs().fe->mesh());
    const QString path = photograph(camera, QStringLiteral("changed.jpg"));
    add(path);
    EXPECT_EQ(window->rooms().deck->evidence().content().findings.count("photo.changed"), 0);
    ASSERT_TRUE(window->rooms().files->saveTo(folder() + QStringLiteral("/changed.rubble")));
    CameraModel other = camera;
    other.focal *= 1.1;
    photograph(other, QStringLiteral("changed.jpg"));
    window->open(folder() + QStringLiteral("/changed.rubble"));
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return prepared() && window->rooms().evidence->settled() && !session->document().theCase().photographs.empty(); },
        patience));
    EXPECT_EQ(window->rooms().deck->evidence().content().findings.count("photo.changed"), 1);
}

}  // namespace
}  // namespace rubble
