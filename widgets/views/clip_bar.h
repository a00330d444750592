#pragma once

#include <QFrame>
#include <optional>

#include "core/base/geometry.h"
#include "widgets/render/basics/view.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QSlider;
class QToolButton;

namespace rubble::widgets {

class UnitLabel;

/// Moves the plane that opens the model: along an axis or along the direction in which the views looked, by slider or by number.
class ClipBar : public QFrame {
    Q_OBJECT

public:
    explicit ClipBar(QWidget* parent = nullptr);

    /// What the plane may move through [m], and what is added to places when they are shown.
    void setBounds(const Aabb& bounds, const Vec3& origin);
    /// A plane through the middle across x, or the one that was set last.
    std::optional<render::ClipPlane> plane() const;
    /// Shows a plane; one that stands along no axis is free.
    void setPlane(const render::ClipPlane& plane);

signals:
    void planeChanged(const rubble::render::ClipPlane& plane);
    /// The user wants the plane across the direction in which the views look.
    void viewDirectionRequested();
    void closeRequested();

protected:
    bool event(QEvent* event) override;

private:
    enum Direction { X, Y, Z, Free };
    void chooseDirection();
    void showPlane();
    void typed();
    void slid(int place);
    Vec3 axis() const;
    std::pair<double, double> reach() const;
    double placeOf() const;
    void move(double place);

    QComboBox* m_direction;
    QSlider* m_slider;
    QLineEdit* m_place;
    UnitLabel* m_unit;
    QToolButton* m_flip;
    Aabb m_bounds;
    Vec3 m_origin = Vec3::Zero();
    std::optional<render::ClipPlane> m_plane;
    bool m_showing = false;
};

}  // namespace rubble::widgets
