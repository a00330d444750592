#pragma once

#include <QLineEdit>
#include <limits>
#include <optional>
#include <string>

namespace rubble::widgets {

/// A number that is typed, in the locale's or the plain way; may be left empty where that means something. What is no number or out
/// of range is marked and not told.
class NumberField : public QLineEdit {
    Q_OBJECT

public:
    explicit NumberField(const QString& name, QWidget* parent = nullptr);

    /// @param low, high  what is accepted
    void setRange(double low, double high);
    /// Nothing typed is an answer, shown as this.
    void setEmptyMeans(const QString& words);
    /// The unit of the number, as figures::shownUnit(): typed and shown in the one that is shown in its place.
    void setUnit(const std::string& unit) { m_unit = unit; }
    /// Significant digits that are shown: more for what lies far from zero, such as coordinates of a country.
    void setDigits(int digits) { m_digits = digits; }
    void setNumber(std::optional<double> number);
    std::optional<double> number() const { return m_number; }

signals:
    /// The user has set another number, or emptied the field.
    void edited(std::optional<double> number);

protected:
    bool event(QEvent* event) override;

private:
    void take();

    std::string m_unit;
    double m_low = -std::numeric_limits<double>::infinity();
    double m_high = std::numeric_limits<double>::infinity();
    int m_digits = 8;
    bool m_mayBeEmpty = false;
    std::optional<double> m_number;
};

}  // namespace rubble::widgets
