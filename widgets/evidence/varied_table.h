#pragma once

#include <QWidget>
#include <vector>

#include "core/scenario/ensemble.h"
#include "widgets/basics/wording.h"

class QComboBox;
class QLabel;
class QVBoxLayout;

namespace rubble::widgets {

/// What members of an ensemble get different values of: a row for each parameter with its distribution, and a list to add others
/// from. Shows what it is given; an edit that can be drawn from leaves as the whole list, any other is explained in place.
class VariedTable : public QWidget {
    Q_OBJECT

public:
    explicit VariedTable(QWidget* parent = nullptr);

    /// Scenarios of the case, which can be varied too.
    struct Choice {
        QString id;
        QString name;
        friend bool operator==(const Choice&, const Choice&) = default;
    };
    void setContent(const std::vector<VariedSetting>& varied, const std::vector<Choice>& scenarios);
    const std::vector<VariedSetting>& varied() const { return m_varied; }
    void add(const QString& key);

signals:
    /// @param what  names the edit for undo
    void variedEdited(const std::vector<rubble::VariedSetting>& varied, const rubble::widgets::Wording& what);

private:
    void build();
    QWidget* rowOf(std::size_t place);
    QComboBox* kindOf(std::size_t place);
    QWidget* numbersOf(std::size_t place);
    QWidget* choicesOf(std::size_t place);
    void fillAdditions();
    void edit(std::size_t place, const VariedSetting& after);
    void propose(std::vector<VariedSetting> varied, const Wording& what);
    static QString nameOf(const std::string& key);

    std::vector<VariedSetting> m_varied;
    std::vector<Choice> m_scenarios;
    bool m_built = false;
    QVBoxLayout* m_rows;
    QComboBox* m_add;
    QLabel* m_complaint;
};

}  // namespace rubble::widgets
