#pragma once

#include <QApplication>
#include <QMessageBox>
#include <QTest>
#include <QTimer>

namespace rubble {

/// Answers the question that comes up by one of its buttons, and tells whether one came.
class BoxAnswer {
public:
    explicit BoxAnswer(QMessageBox::StandardButton button) {
        m_timer.setInterval(50);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this, button] {
            if (auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                m_asked = true;
                QTest::mouseClick(question->button(button), Qt::LeftButton);
            }
        });
        m_timer.start();
    }
    bool asked() const { return m_asked; }

private:
    QTimer m_timer;
    bool m_asked = false;
};

}  // namespace rubble
