#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "core/scenario/removal.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QToolButton;

namespace rubble::widgets {

/// Places whose debris was taken away, each with the time from when on it was gone: surveys of later are compared without them.
class RemovalBox : public QWidget {
    Q_OBJECT

public:
    explicit RemovalBox(QWidget* parent = nullptr);

    /// @param some  there is a case to keep them in
    void setRemovals(const std::vector<Removal>& removals, bool some);

signals:
    /// A place is to be drawn on the difference map, or taken from a file. @param since  as clockTime() gives it
    void drawRequested(const std::string& since);
    void fileRequested(const std::string& since);
    /// @param removal  its number
    void timeChosen(int removal, const std::string& since);
    void removeRequested(int removal);

private:
    std::string since() const;
    void showState();
    void takeTime();

    std::vector<Removal> m_removals;
    bool m_some = false;
    bool m_showing = false;
    QLineEdit* m_since;
    QLabel* m_said;
    QToolButton* m_add;
    QToolButton* m_remove;
    QListWidget* m_list;
};

}  // namespace rubble::widgets
