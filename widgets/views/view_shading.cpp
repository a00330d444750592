#include <QMetaObject>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include "widgets/views/view_widget.h"

namespace rubble::widgets {

namespace {

double& slowestShaded() {
    static double seconds = ViewWidget::slowShading;
    return seconds;
}

}  // namespace

void ViewWidget::watchShading(const QElapsedTimer& clock) {
    if (!m_view.shading) {
        m_slowShaded = 0;
        return;
    }
    context()->functions()->glFinish();
    const double seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
    // One picture alone may have waited for what had to be built anew.
    if (seconds > slowestShaded()) {
        ++m_slowShaded;
    } else if (!m_simplified) {
        m_slowShaded = 0;
    }
    if (m_slowShaded < 2) {
        return;
    }
    m_slowShaded = 0;
    m_view.shading = false;
    // Not from within a picture that is being painted.
    QMetaObject::invokeMethod(
        this,
        [this, seconds] {
            update();
            emit viewChanged(m_view);
            emit shadingEnded(seconds);
        },
        Qt::QueuedConnection);
}

void ViewWidget::shadeUpTo(double seconds) {
    slowestShaded() = seconds;
}

}  // namespace rubble::widgets
