#include "app/gui/stage/view_area.h"

#include <QLabel>
#include <QVBoxLayout>

#include "widgets/accuracy/error_bar.h"
#include "widgets/basics/theme.h"
#include "widgets/case/start_page.h"
#include "widgets/views/clip_bar.h"
#include "widgets/views/scenario_bar.h"

namespace rubble {

ViewArea::ViewArea(QWidget* parent)
    : QStackedWidget(parent),
      m_start(new widgets::StartPage),
      m_views(new widgets::ViewWidget),
      m_errorBar(new widgets::ErrorBar),
      m_scenarioBar(new widgets::ScenarioBar),
      m_clipBar(new widgets::ClipBar),
      m_error(new widgets::Notice),
      m_activity(new QLabel) {
    addWidget(m_start);
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_errorBar->hide();
    column->addWidget(m_errorBar);
    m_scenarioBar->hide();
    column->addWidget(m_scenarioBar);
    column->addWidget(m_views, 1);
    m_clipBar->hide();
    column->addWidget(m_clipBar);
    addWidget(page);
    addWidget(buildEmpty());
}

widgets::ViewWidget& ViewArea::watched() {
    return m_besidePhotograph != nullptr && m_besidePhotograph->isVisible() ? *m_besidePhotograph : *m_views;
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
    auto* title = new QLabel(tr("Nothing to view yet"));
    title->setFont(widgets::titleFont());
    auto* text =
        new QLabel(tr("The case is open, but there is nothing to view of it. What is wrong is said here and in the Case panel."));
    text->setWordWrap(true);
    m_activity->setObjectName(QStringLiteral("muted"));
    column->addWidget(title);
    column->addWidget(text);
    column->addWidget(m_activity);
    column->addWidget(m_error);
    auto* centred = new QHBoxLayout;
    centred->addStretch();
    centred->addWidget(body, 10);
    centred->addStretch();
    outer->addLayout(centred);
    outer->addStretch(3);
    return page;
}

void ViewArea::showViews(bool show, bool open) {
    setCurrentIndex(show ? 1 : open ? 2 : 0);
}

void ViewArea::setError(const QString& what, const QString& remedy) {
    m_error->set(widgets::Notice::Kind::Error, what, remedy);
    m_start->setError(what, remedy);
}

void ViewArea::setActivity(const QString& what) {
    m_activity->setText(what);
    m_start->setActivity(what);
}

}  // namespace rubble
