#pragma once

#include <QBoxLayout>
#include <QEvent>
#include <QWidget>
#include <algorithm>
#include <initializer_list>
#include <vector>

namespace rubble::widgets {

/// Two or more groups of tools beside each other; below each other where the window is too narrow for that.
class FoldingBar : public QWidget {
public:
    explicit FoldingBar(QWidget* parent = nullptr) : QWidget(parent), m_line(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
        m_line->setContentsMargins(10, 6, 10, 6);
        m_line->setSpacing(8);
    }

    /// One more group, its tools from left to right; what is left over of the width lies behind the last one.
    QHBoxLayout* add(std::initializer_list<QWidget*> tools = {}) {
        for (QWidget* before : m_groups) {
            m_line->setStretchFactor(before, 0);
        }
        auto* group = new QWidget;
        auto* line = new QHBoxLayout(group);
        line->setContentsMargins(0, 0, 0, 0);
        line->setSpacing(4);
        for (QWidget* tool : tools) {
            line->addWidget(tool);
        }
        if (tools.size() > 0) {
            line->addStretch();
        }
        m_groups.push_back(group);
        m_line->addWidget(group, 1);
        return line;
    }

    QSize minimumSizeHint() const override {
        int widest = 0;
        for (const QWidget* group : m_groups) {
            widest = std::max(widest, group->minimumSizeHint().width());
        }
        return {widest + margins(), m_line->minimumSize().height()};
    }

protected:
    void resizeEvent(QResizeEvent* event) override {
        QWidget::resizeEvent(event);
        fold();
    }
    bool event(QEvent* event) override {
        const bool taken = QWidget::event(event);
        // Tools come and go, and other languages have other lengths.
        if (event->type() == QEvent::LayoutRequest) {
            fold();
        }
        return taken;
    }

private:
    void fold() {
        int together = margins() - m_line->spacing();
        for (const QWidget* group : m_groups) {
            together += group->minimumSizeHint().width() + m_line->spacing();
        }
        const auto direction = width() < together ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
        if (direction != m_line->direction()) {
            m_line->setDirection(direction);
            updateGeometry();
        }
    }
    int margins() const { return m_line->contentsMargins().left() + m_line->contentsMargins().right(); }

    QBoxLayout* m_line;
    std::vector<QWidget*> m_groups;
};

}  // namespace rubble::widgets
