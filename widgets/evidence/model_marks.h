#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/scenario/photograph.h"
#include "widgets/render/basics/view.h"

namespace rubble::widgets {

class ViewWidget;

/// Lies over a model beside a photograph: marks of the points of its pairs, and a loupe at the mouse while points are picked. Takes
/// no event away from the model.
class ModelMarks : public QWidget {
    Q_OBJECT

public:
    struct Mark {
        Vec3 place = Vec3::Zero();  ///< m
        bool used = true;           ///< false: it looks wrong
    };
    struct Content {
        std::vector<Mark> marks;
        int chosen = -1;
        std::optional<Vec3> pending;  ///< m, clicked, waits for its counterpart
    };

    explicit ModelMarks(ViewWidget& model);

    void setContent(const Content& content);
    /// The points of pairs, numbered as in the photograph. @param used  [pairs] false: it looks wrong; empty: not known
    void setPairs(const std::vector<PointPair>& pairs, const std::vector<bool>& used, int chosen,
                  const std::optional<Vec3>& pending);
    const Content& content() const { return m_content; }
    void setPicking(bool picking);
    /// Where a point of the model is seen; unset: it is not in the view.
    std::optional<QPointF> placeOf(const Vec3& point) const;
    /// Where the loupe stands; unset: there is none.
    std::optional<QPointF> loupe() const;

signals:
    /// The model was clicked while points are picked, as a place in its widget.
    void picked(const QPointF& place);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void noteClick(QEvent* event);
    bool pictureIsNow() const;
    void takePicture();
    void paintMarks(QPainter& painter) const;

    ViewWidget& m_model;
    Content m_content;
    bool m_picking = false;
    QPointF m_pressed;
    std::optional<QPointF> m_mouse;  ///< over the model while points are picked
    QImage m_picture;                ///< what the loupe shows larger
    render::View m_pictureOf;
    QTimer m_rest;  ///< a picture is taken once mouse and camera rest
};

}  // namespace rubble::widgets
