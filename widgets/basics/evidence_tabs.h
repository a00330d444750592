#pragma once

#include <QWidget>

class QButtonGroup;
class QHBoxLayout;
class QStackedWidget;

namespace rubble::widgets {

/// Panels of one entry of the rail, one of them at a time, chosen above them.
class EvidenceTabs : public QWidget {
    Q_OBJECT

public:
    explicit EvidenceTabs(QWidget* parent = nullptr);

    void addPage(const QString& name, const QString& tip, QWidget* panel);
    int current() const;
    void setCurrent(int page);
    QSize sizeHint() const override;

signals:
    void currentChanged(int page);
    /// A person chose a page, perhaps the one that is shown already.
    void chosen(int page);

private:
    QButtonGroup* m_buttons;
    QHBoxLayout* m_row;
    QStackedWidget* m_stack;
};

}  // namespace rubble::widgets
