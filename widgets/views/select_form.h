#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace rubble::widgets {

/// Names elements by what they are: component, birth interval, cluster, region. What is left empty does not count.
class SelectForm : public QWidget {
    Q_OBJECT

public:
    enum class How { Replace, Add, Remove };
    struct Criteria {
        How how = How::Replace;
        std::string component;                   ///< empty: any
        std::optional<double> bornFrom, bornTo;  ///< s
        std::optional<std::size_t> cluster;
        std::array<std::optional<double>, 3> low, high;  ///< m, of the centre at the time shown, as exported tables give them

        bool empty() const;
    };

    explicit SelectForm(QWidget* parent = nullptr);

    void setComponents(const std::vector<std::string>& names);
    /// How many elements the last criteria named.
    void setFound(std::size_t count);
    Criteria criteria() const;

protected:
    bool event(QEvent* event) override;

signals:
    void selectRequested(const rubble::widgets::SelectForm::Criteria& criteria);

private:
    QLineEdit* addField(const QString& name, const QString& tip);
    std::optional<double> numberIn(const QLineEdit* field, const QString& name, QString& complaint, const char* unit = "") const;
    void ask(How how);

    QComboBox* m_component;
    QLineEdit* m_bornFrom;
    QLineEdit* m_bornTo;
    QLineEdit* m_cluster;
    std::array<QLineEdit*, 3> m_low{};
    std::array<QLineEdit*, 3> m_high{};
    QLabel* m_found;
};

}  // namespace rubble::widgets
