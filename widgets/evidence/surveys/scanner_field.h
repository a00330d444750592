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

/// Where scanners stood, in the system of the case: typed as easting, northing and height of each, clicked in the model, or taken
/// from a table.
class ScannerField : public QWidget {
    Q_OBJECT

public:
    /// @param otherwise  what none of them means, for people
    explicit ScannerField(const QString& otherwise, QWidget* parent = nullptr);

    void setPlaces(const std::vector<Vec3>& places);
    /// As if they had been typed: Ctrl+Z in the field takes them back.
    void takePlaces(const std::vector<Vec3>& places);
    /// m, easting, northing and height; unset: what is typed is no such list.
    std::optional<std::vector<Vec3>> places() const;
    /// Puts the keyboard where they are typed.
    void ask();

signals:
    void edited(const std::vector<rubble::Vec3>& places);
    void tableRequested();
    /// They are to be clicked in the model.
    void pickRequested();

private:
    void take();

    std::vector<Vec3> m_places;
    QLineEdit* m_text;
    QPushButton* m_pick;
    QPushButton* m_table;
    Notice* m_complaint;
};

}  // namespace rubble::widgets
