#include "widgets/views/clip_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <limits>
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr int sliderSteps = 1000;

}  // namespace

ClipBar::ClipBar(QWidget* parent)
    : QFrame(parent),
      m_direction(new QComboBox),
      m_slider(new QSlider(Qt::Horizontal)),
      m_place(new QLineEdit),
      m_unit(new UnitLabel(tr("m"))),
      m_flip(new QToolButton) {
    setObjectName(QStringLiteral("bottom"));
    setAccessibleName(tr("Cut"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 4, 12, 4);
    row->setSpacing(8);
    auto* label = new QLabel(tr("Cut across"));
    label->setObjectName(QStringLiteral("muted"));
    m_direction->addItems({QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z"), tr("line of sight")});
    m_direction->setAccessibleName(tr("Direction of the cut"));
    m_direction->setToolTip(tr("The plane stands across this axis, or across the direction in which the views look now"));
    label->setBuddy(m_direction);
    m_slider->setRange(0, sliderSteps);
    m_slider->setPageStep(sliderSteps / 20);
    m_slider->setAccessibleName(tr("Place of the cut"));
    m_slider->setToolTip(tr("Moves the plane through the model"));
    m_place->setMaximumWidth(90);
    m_place->setAlignment(Qt::AlignRight);
    m_place->setAccessibleName(tr("Place of the cut, typed"));
    m_flip->setText(tr("Other side"));
    m_flip->setToolTip(tr("Keep what was cut away, and cut away what was kept"));
    m_flip->setFocusPolicy(Qt::StrongFocus);
    auto* close = new QToolButton;
    close->setText(tr("Done"));
    close->setToolTip(tr("Show the model whole again"));
    close->setFocusPolicy(Qt::StrongFocus);
    for (QWidget* widget : {static_cast<QWidget*>(label), static_cast<QWidget*>(m_direction)}) {
        row->addWidget(widget);
    }
    row->addWidget(m_slider, 1);
    row->addWidget(m_place);
    row->addWidget(m_unit);
    row->addWidget(m_flip);
    row->addWidget(close);
    connect(m_direction, &QComboBox::activated, this, &ClipBar::chooseDirection);
    connect(m_slider, &QSlider::valueChanged, this, &ClipBar::slid);
    connect(m_place, &QLineEdit::editingFinished, this, &ClipBar::typed);
    connect(m_flip, &QToolButton::clicked, this, [this] {
        if (m_plane) {
            m_plane->normal = -m_plane->normal;
            showPlane();
            emit planeChanged(*m_plane);
        }
    });
    connect(close, &QToolButton::clicked, this, &ClipBar::closeRequested);
}

bool ClipBar::event(QEvent* event) {
    if (event->type() == unitsChanged() && m_plane) {
        showPlane();
    }
    return QFrame::event(event);
}

void ClipBar::setBounds(const Aabb& bounds, const Vec3& origin) {
    if (bounds.isEmpty() || (!m_bounds.isEmpty() && bounds.isApprox(m_bounds) && origin == m_origin)) {
        return;
    }
    m_bounds = bounds;
    m_origin = origin;
    m_plane = render::ClipPlane{bounds.center(), Vec3::UnitX()};
    showPlane();
}

std::optional<render::ClipPlane> ClipBar::plane() const {
    return m_plane;
}

void ClipBar::setPlane(const render::ClipPlane& plane) {
    if (!m_plane || !(*m_plane == plane)) {
        m_plane = plane;
        showPlane();
    }
}

/// The direction in which places are counted: the axis, whichever side is cut away.
Vec3 ClipBar::axis() const {
    for (int i = 0; i < 3; ++i) {
        if (std::abs(std::abs(m_plane->normal[i]) - 1.0) < 1e-12) {
            return Vec3::Unit(i);
        }
    }
    return m_plane->normal;
}

std::pair<double, double> ClipBar::reach() const {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (int i = 0; i < 8 && !m_bounds.isEmpty(); ++i) {
        const double place = m_bounds.corner(static_cast<Aabb::CornerType>(i)).dot(axis());
        low = std::min(low, place);
        high = std::max(high, place);
    }
    return low < high ? std::pair(low, high) : std::pair(0.0, 1.0);
}

double ClipBar::placeOf() const {
    return m_plane->point.dot(axis());
}

void ClipBar::move(double place) {
    m_plane->point += (place - placeOf()) * axis();
    showPlane();
    emit planeChanged(*m_plane);
}

void ClipBar::chooseDirection() {
    if (m_showing || !m_plane) {
        return;
    }
    if (m_direction->currentIndex() == Free) {
        emit viewDirectionRequested();
        return;
    }
    m_plane = render::ClipPlane{m_bounds.center(), Vec3::Unit(m_direction->currentIndex())};
    showPlane();
    emit planeChanged(*m_plane);
}

void ClipBar::slid(int place) {
    if (!m_showing && m_plane) {
        const auto [low, high] = reach();
        move(low + (high - low) * place / sliderSteps);
    }
}

void ClipBar::typed() {
    // What the field shows is rounded: leaving it untouched moves nothing.
    if (m_plane && m_place->text() == shownPlace(placeOf() + m_origin.dot(axis()))) {
        return;
    }
    bool ok = false;
    const double place = typedIn(QLocale().toDouble(m_place->text(), &ok), "m");
    if (m_plane && ok && std::isfinite(place)) {
        const double local = place - m_origin.dot(axis());
        if (std::abs(local - placeOf()) > 5e-4) {
            move(local);
        }
    } else if (m_plane) {
        showPlane();
    }
}

void ClipBar::showPlane() {
    m_showing = true;
    const Vec3 along = axis();
    int direction = Free;
    for (int i = 0; i < 3; ++i) {
        if (along == Vec3(Vec3::Unit(i))) {
            direction = i;
        }
    }
    m_direction->setCurrentIndex(direction);
    const auto [low, high] = reach();
    m_slider->setValue(static_cast<int>(std::lround(sliderSteps * std::clamp((placeOf() - low) / (high - low), 0.0, 1.0))));
    const double shift = m_origin.dot(along);
    m_place->setText(shownPlace(placeOf() + shift));
    m_place->setToolTip(tr("Where the plane stands; the model reaches from %1 to %2")
                            .arg(shownLength(low + shift, 4), shownLength(high + shift, 4)));
    m_showing = false;
}

}  // namespace rubble::widgets
