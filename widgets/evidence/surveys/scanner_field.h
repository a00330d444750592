#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/base/geometry.h"

class QLineEdit;
class QPushButton;

namespace rubble::widgets {

class Notice;

/// Where scanners stood, in the system of the case: typed as easting, northing and height of each, or taken from a table.
class ScannerField : public QWidget {
    Q_OBJECT

public:
    /// @param otherwise  what none of them means, for people
    explicit ScannerField(const QString& otherwise, QWidget* parent = nullptr);

    void setPlaces(const std::vector<Vec3>& places);
    /// m, easting, northing and height; unset: what is typed is no such list.
    std::optional<std::vector<Vec3>> places() const;
    /// Puts the keyboard where they are typed.
    void ask();

signals:
    void edited(const std::vector<rubble::Vec3>& places);
    void tableRequested();

private:
    void take();

    std::vector<Vec3> m_places;
    QLineEdit* m_text;
    QPushButton* m_table;
    Notice* m_complaint;
};

}  // namespace rubble::widgets
