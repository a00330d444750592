#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/fe/audit.h"
#include "widgets/basics/panel.h"

class QTableWidget;
class QVBoxLayout;

namespace rubble::widgets {

/// Fourth step of a new case: what dies when, by component, and what is odd about it.
class NewCaseDeaths : public Panel {
    Q_OBJECT

public:
    /// When the elements of a component die; unset: none does.
    struct Span {
        std::optional<double> first;  ///< s
        std::optional<double> last;   ///< s
    };
    /// An account of every death.
    struct Content {
        Audit audit;
        std::vector<Span> spans;  ///< by component
    };

    explicit NewCaseDeaths(QWidget* parent = nullptr);

    /// Null while the account is being made.
    void setContent(const std::shared_ptr<const Content>& content);

signals:
    /// A component was chosen: the instant of its first death is worth a look.
    void instantRequested(double time);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Column { Name, Dead, Share, First, Last, ColumnCount };

    void buildTable();
    void showTable();
    void showAnomalies();

    std::shared_ptr<const Content> m_content;
    QLabel* m_summary;
    QTableWidget* m_table;
    QVBoxLayout* m_anomalies;
};

/// What an anomaly of a stable kind means, for people.
QString anomalyWords(const std::string& kind);

}  // namespace rubble::widgets
