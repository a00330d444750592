#pragma once

#include <QStringList>
#include <QWidget>
#include <array>

#include "core/fe/regrouping.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace rubble::widgets {

class UnitLabel;

/// Merge, rename or split the chosen components: three buttons and, once one is pressed, a small form in place.
class RegroupForm : public QWidget {
    Q_OBJECT

public:
    explicit RegroupForm(QWidget* parent = nullptr);

    /// The components the form would act on, in the order of the table, and all names that are taken.
    void setSelection(const QStringList& selected, const QStringList& all);
    /// Box of the model, the first proposal for a splitting box or plane.
    void setBounds(const Aabb& bounds);

signals:
    void regroupRequested(const rubble::RegroupStep& step);

private:
    enum class Task { None, Merge, Rename, Split };
    enum class Cut { Connectivity, Plane, Box };
    void open(Task task);
    void showCut();
    void apply();
    void refuse(const QString& why);
    std::optional<Vec3> vector(const std::array<QLineEdit*, 3>& fields) const;
    std::optional<RegroupStep> splitStep();
    QWidget* vectorRow(const QString& label, std::array<QLineEdit*, 3>& fields, UnitLabel* unit);

    QPushButton* m_merge;
    QPushButton* m_rename;
    QPushButton* m_split;
    QWidget* m_form;
    QLabel* m_what;
    QLineEdit* m_name;
    QLabel* m_nameLabel;
    QComboBox* m_cut;
    UnitLabel* m_secondUnit;
    QWidget* m_firstRow;
    QWidget* m_secondRow;
    QLabel* m_complaint;
    std::array<QLineEdit*, 3> m_first{};
    std::array<QLineEdit*, 3> m_second{};
    QStringList m_selected;
    QStringList m_all;
    Aabb m_bounds;
    Task m_task = Task::None;
};

}  // namespace rubble::widgets
