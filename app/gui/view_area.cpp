#include "app/gui/view_area.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/error_bar.h"
#include "widgets/theme.h"

namespace rubble {

ViewArea::ViewArea(QWidget* parent)
    : QStackedWidget(parent),
      m_views(new widgets::ViewWidget),
      m_errorBar(new widgets::ErrorBar),
      m_error(new widgets::Notice),
      m_activity(new QLabel) {
    addWidget(buildEmpty());
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_errorBar->hide();
    column->addWidget(m_errorBar);
    column->addWidget(m_views, 1);
    addWidget(page);
}

QWidget* ViewArea::buildEmpty() {
    auto* page = new QWidget;
    page->setObjectName(QStringLiteral("emptyState"));
    page->setAttribute(Qt::WA_StyledBackground);
    auto* outer = new QVBoxLayout(page);
    outer->addStretch(2);
    auto* body = new QWidget;
    body->setMaximumWidth(520);
    auto* column = new QVBoxLayout(body);
    column->setSpacing(12);
    auto* title = new QLabel(tr("Where do the fragments go?"));
    title->setFont(widgets::titleFont());
    auto* text = new QLabel(tr(
        "Two views appear here: the conventional FE result, in which deactivated elements vanish, and the same collapse with every "
        "deactivated element as a fragment that falls, hits and comes to rest. Drop an FE result or a case anywhere in this "
        "window."));
    text->setWordWrap(true);
    auto* buttons = new QHBoxLayout;
    auto* sample = new QPushButton(tr("Open the sample"));
    sample->setObjectName(QStringLiteral("primary"));
    sample->setToolTip(tr("The collapse of a stone arch bridge: opens and starts to simulate"));
    auto* open = new QPushButton(tr("Open…"));
    open->setToolTip(tr("Open a case (*.rubble) or an FE result"));
    buttons->addWidget(sample);
    buttons->addWidget(open);
    buttons->addStretch();
    m_activity->setObjectName(QStringLiteral("muted"));
    column->addWidget(title);
    column->addWidget(text);
    column->addLayout(buttons);
    column->addWidget(m_activity);
    column->addWidget(m_error);
    auto* centred = new QHBoxLayout;
    centred->addStretch();
    centred->addWidget(body, 10);
    centred->addStretch();
    outer->addLayout(centred);
    outer->addStretch(3);
    connect(sample, &QPushButton::clicked, this, &ViewArea::sampleRequested);
    connect(open, &QPushButton::clicked, this, &ViewArea::openRequested);
    return page;
}

void ViewArea::showViews(bool show) {
    setCurrentIndex(show ? 1 : 0);
}

void ViewArea::setError(const QString& what, const QString& remedy) {
    m_error->set(widgets::Notice::Kind::Error, what, remedy);
}

void ViewArea::setActivity(const QString& what) {
    m_activity->setText(what);
}

}  // namespace rubble
