#pragma once

#include <QDialog>

#include "core/base/geometry.h"
#include "widgets/render/basics/view.h"
#include "widgets/render/scene.h"

class QBoxLayout;
class QDialogButtonBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace rubble::widgets {

class ModelMarks;
class ViewWidget;

/// Places that are clicked in a model and stand in a table below it: a line above says what to click next, Ctrl+Z and Delete change
/// what was picked, Enter ends what is typed, and Escape leaves only where nothing would be lost. Nothing changes before it is
/// accepted.
class PickedPlacesDialog : public QDialog {
    Q_OBJECT

public:
    void setModel(const render::SceneData& scene, render::View view);
    /// Takes back the last click or change.
    virtual void undo() = 0;
    ViewWidget& model() { return *m_model; }

protected:
    /// @param model  what the model is called for who cannot see it
    PickedPlacesDialog(const QString& title, const QString& model, QWidget* parent);

    void keyPressEvent(QKeyEvent* event) override;
    /// The rows have room for five.
    void prepareTable(const QStringList& heads, const QString& name, const QString& tip);
    /// Undo, remove and remove all, in a row. @param remove  what is removed: "Remove scanner"
    QBoxLayout* changeButtons(const QString& undoTip, const QString& remove);
    /// @param take  on the button that accepts. Enter presses neither: it ends what is typed
    QDialogButtonBox* endButtons(const QString& take);

    /// A click in the model. @param place  m, local
    virtual void placePicked(const Vec3& place) = 0;
    virtual void removeChosen() = 0;
    virtual void removeAll() = 0;
    /// Escape.
    virtual void leave() = 0;
    /// Marks of what was picked, and the hint.
    virtual void showMarks() = 0;

    QString m_said;  ///< of the last click or number
    QLabel* m_hint;
    ViewWidget* m_model;
    ModelMarks* m_marks;
    QTableWidget* m_table;
    QPushButton* m_undo;
    QPushButton* m_remove;
    QPushButton* m_clear;
};

}  // namespace rubble::widgets
