#include "widgets/basics/evidence_tabs.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace rubble::widgets {

EvidenceTabs::EvidenceTabs(QWidget* parent)
    : QWidget(parent), m_buttons(new QButtonGroup(this)), m_row(new QHBoxLayout), m_stack(new QStackedWidget) {
    setObjectName(QStringLiteral("panelBody"));
    setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_row->setContentsMargins(14, 8, 14, 0);
    m_row->setSpacing(0);
    column->addLayout(m_row);
    column->addWidget(m_stack, 1);
    connect(m_buttons, &QButtonGroup::idClicked, this, [this](int page) {
        setCurrent(page);
        emit chosen(page);
    });
}

void EvidenceTabs::addPage(const QString& name, const QString& tip, QWidget* panel) {
    auto* button = new QToolButton;
    button->setText(name);
    button->setToolTip(tip);
    button->setAccessibleName(name);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_buttons->addButton(button, m_stack->count());
    m_row->addWidget(button, 1);
    m_stack->addWidget(panel);
    button->setChecked(m_stack->count() == 1);
}

int EvidenceTabs::current() const {
    return m_stack->currentIndex();
}

void EvidenceTabs::setCurrent(int page) {
    if (QAbstractButton* button = m_buttons->button(page)) {
        button->setChecked(true);
        if (page != m_stack->currentIndex()) {
            m_stack->setCurrentIndex(page);
            emit currentChanged(page);
        }
    }
}

QSize EvidenceTabs::sizeHint() const {
    return {264, 480};
}

}  // namespace rubble::widgets
