#pragma once

#include <functional>
#include <vector>

#include "widgets/evidence/surveys/picked_places_dialog.h"

namespace rubble::widgets {

class NumberField;

/// Where scanners stood, clicked in the model: each place gets a height above what was clicked and a row whose numbers can be typed
/// anew. Nothing changes before it is accepted.
class ScannerDialog : public PickedPlacesDialog {
    Q_OBJECT

public:
    /// Between the local frame and the system of the case, m.
    struct Way {
        std::function<Vec3(const Vec3&)> toWorld;
        std::function<Vec3(const Vec3&)> toLocal;
    };

    /// @param places  that are known, in the system of the case, m
    ScannerDialog(std::vector<Vec3> places, Way way, QWidget* parent = nullptr);

    /// A click in the model. @param place  m, local
    void pick(const Vec3& place);
    void undo() override;
    /// m, easting, northing and height in the system of the case.
    const std::vector<Vec3>& places() const { return m_now; }
    /// m, of a scanner above what is clicked.
    NumberField& above() { return *m_above; }

protected:
    void placePicked(const Vec3& place) override { pick(place); }
    void removeChosen() override;
    void removeAll() override;
    void leave() override;
    void showMarks() override;

private:
    QWidget* buildTable();
    void take(std::vector<Vec3> now);
    void takeCell(int row, int column);
    void showPlaces();

    Way m_way;
    std::vector<Vec3> m_now;
    std::vector<Vec3> m_first;  ///< as it was opened
    std::vector<std::vector<Vec3>> m_past;
    bool m_filling = false;
    NumberField* m_above;
};

}  // namespace rubble::widgets
