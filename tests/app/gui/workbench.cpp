#include "tests/app/gui/workbench.h"

#include <QPainter>
#include <QSettings>
#include <utility>

#include "app/gui/stage/view_area.h"
#include "widgets/basics/language.h"
#include "widgets/views/view_widget.h"

namespace rubble {

QImage pictureOf(QWidget& shown) {
    QImage picture = shown.grab().toImage();
    // A widget that is grabbed paints its captions elsewhere: the views are taken from their own frame buffer.
    for (auto* views : shown.findChildren<widgets::ViewWidget*>()) {
        if (views->isVisible()) {
            QPainter painter(&picture);
            painter.drawImage(QRect(views->mapTo(&shown, QPoint(0, 0)), views->size()), views->picture());
        }
    }
    return picture;
}

void Workbench::drawViews() {
    widgets::ViewWidget& views = window->area().views();
    const auto place = [&] { return std::pair(views.geometry(), views.view().cameras); };
    // A dock that comes takes room beside the views and leaves it again where it floats, by layouts that are made later.
    for (auto before = place();; before = place()) {
        QTest::qWait(1);
        QCoreApplication::sendPostedEvents();
        views.grabFramebuffer();
        if (place() == before) {
            return;
        }
    }
}

void FreshWorkbench::SetUp() {
    qputenv("RUBBLE_STATE", m_state.path().toUtf8());
    QSettings().clear();
    widgets::speak(QStringLiteral("en"));
    Workbench::SetUp();
}

void FreshWorkbench::TearDown() {
    session->document().undoStack().setClean();
    endProgram();
    qputenv("RUBBLE_STATE", m_stateBefore);
    widgets::speak(QStringLiteral("en"));
}

}  // namespace rubble
