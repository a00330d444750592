#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>

#include "core/scenario/parameters.h"

class QAbstractButton;
class QBoxLayout;
class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace rubble::widgets {

/// Edits one row of the parameter table: the same widget wherever a parameter appears. Shows what is wrong with a typed value in
/// place and keeps the old one. An automatic value is shown as such; typing takes it over and the auto mark gives it back. What can
/// be off, on or automatic is three buttons side by side; the arrow keys move among them.
class ParameterEditor : public QWidget {
    Q_OBJECT

public:
    /// @param row      a row of parameterTable()
    /// @param subject  what stands in the brackets of a keyed row
    explicit ParameterEditor(const Parameter& row, std::string subject = {}, QWidget* parent = nullptr);

    const Parameter& row() const { return m_row; }
    QString key() const;
    QString label() const;
    /// The unit of the row.
    QString siUnit() const;
    /// Shows a value without emitting edited().
    void setValue(const ParameterValue& value);
    /// What the automatic value comes to, shown while the value is automatic.
    void setAutomaticValue(double value);
    void setAutomaticText(const QString& text);
    const ParameterValue& value() const { return m_value; }
    /// Offers words while a text is typed.
    void offer(const QStringList& words);
    /// Greyed out, the editor tells the reason as its tooltip.
    void setAvailable(bool available, const QString& reason = {});

signals:
    /// The user settled on a value (never emitted by setValue).
    void edited(const QString& key, const rubble::ParameterValue& value);
    /// The field shows its value in this unit from now on: times do in the one that suits them.
    void unitShown(const QString& unit);

protected:
    bool event(QEvent* event) override;

private:
    void build();
    void buildField();
    void buildSegments(QBoxLayout* line);
    void buildChoice(QBoxLayout* line);
    void commitText();
    void refuse(const QString& why);
    void show(const ParameterValue& value);
    QString tip() const;
    QString textOf(const ParameterValue& value) const;
    QString numberText(double value) const;
    QString withUnit(double bound) const;
    double shownSize() const;

    const Parameter& m_row;
    std::string m_subject;
    ParameterValue m_value;
    QString m_automatic;
    double m_automaticValue = 0.0;
    QCheckBox* m_switch = nullptr;
    QComboBox* m_choice = nullptr;
    QButtonGroup* m_segments = nullptr;
    QStringList m_offered;  ///< words of the newest offer
    QLineEdit* m_field = nullptr;
    QToolButton* m_auto = nullptr;
    QLabel* m_complaint = nullptr;
    QLabel* m_only = nullptr;
};

}  // namespace rubble::widgets
