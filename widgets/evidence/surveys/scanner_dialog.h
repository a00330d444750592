#pragma once

#include <QDialog>
#include <functional>
#include <vector>

#include "core/base/geometry.h"
#include "widgets/render/basics/view.h"
#include "widgets/render/scene.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace rubble::widgets {

class ModelMarks;
class NumberField;
class ViewWidget;

/// Where scanners stood, clicked in the model: each place gets a height above what was clicked and a row whose numbers can be typed
/// anew. Nothing changes before it is accepted.
class ScannerDialog : public QDialog {
    Q_OBJECT

public:
    /// Between the local frame and the system of the case, m.
    struct Way {
        std::function<Vec3(const Vec3&)> toWorld;
        std::function<Vec3(const Vec3&)> toLocal;
    };

    /// @param places  that are known, in the system of the case, m
    ScannerDialog(std::vector<Vec3> places, Way way, QWidget* parent = nullptr);

    void setModel(const render::SceneData& scene, render::View view);
    /// A click in the model. @param place  m, local
    void pick(const Vec3& place);
    /// Takes back the last click or change.
    void undo();
    /// m, easting, northing and height in the system of the case.
    const std::vector<Vec3>& places() const { return m_now; }
    /// m, of a scanner above what is clicked.
    NumberField& above() { return *m_above; }
    ViewWidget& model() { return *m_model; }

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* buildTable();
    void take(std::vector<Vec3> now);
    void takeCell(int row, int column);
    void removeChosen();
    void leave();
    void showPlaces();
    void showMarks();

    Way m_way;
    std::vector<Vec3> m_now;
    std::vector<Vec3> m_first;  ///< as it was opened
    std::vector<std::vector<Vec3>> m_past;
    QString m_said;  ///< of the last click or number
    bool m_filling = false;
    QLabel* m_hint;
    ViewWidget* m_model;
    ModelMarks* m_marks;
    QTableWidget* m_table;
    NumberField* m_above;
    QPushButton* m_undo;
    QPushButton* m_remove;
    QPushButton* m_clear;
};

}  // namespace rubble::widgets
