#pragma once

#include <QElapsedTimer>
#include <QObject>

namespace rubble {

/// Lets the wheel scroll: boxes, sliders, spin boxes and tabs of all windows change by it only while they have the focus, and never
/// in the middle of a scroll that began elsewhere. Nothing takes the focus by the wheel. What has the focus because its window was
/// opened was not chosen: there the wheel changes nothing before a key or a button was pressed in the window.
class WheelGuard : public QObject {
    Q_OBJECT

public:
    explicit WheelGuard(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool passesBy(const QWidget& widget) const;

    QElapsedTimer m_scrolled;  ///< since something was scrolled
};

}  // namespace rubble
