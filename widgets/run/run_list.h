#pragma once

#include <QWidget>
#include <vector>

#include "core/pipeline/run_entry.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace rubble::widgets {

/// The runs of a case, newest first: when, which scenario, what came of it. One whose file was kept can be shown again.
class RunList : public QWidget {
    Q_OBJECT

public:
    struct Line {
        RunEntry run;
        bool fileThere = false;  ///< its run file was kept and is still there
        bool shown = false;      ///< the run in the views
        friend bool operator==(const Line&, const Line&) = default;
    };

    explicit RunList(QWidget* parent = nullptr);

    /// @param lines  in the order in which the runs ended
    void setContent(std::vector<Line> lines);
    /// While a run is simulated no other one can be shown.
    void setSimulating(bool simulating);
    int count() const;

signals:
    /// The user wants to see a kept run again. @param place  in the order in which the runs ended
    void showRequested(std::size_t place);

protected:
    void changeEvent(QEvent* event) override;

private:
    void list(int row);
    void choose();
    std::size_t placeOf(int row) const { return m_lines.size() - 1 - static_cast<std::size_t>(row); }

    std::vector<Line> m_lines;
    bool m_simulating = false;
    QLabel* m_none;
    QListWidget* m_list;
    QLabel* m_details;
    QPushButton* m_show;
};

}  // namespace rubble::widgets
