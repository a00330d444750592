#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/scenario/photograph.h"

namespace rubble::widgets {

/// A clicked point of a photograph, and where the matched camera sees its counterpart.
struct PhotoMark {
    QString name;
    QPointF at;                        ///< px of the photograph
    std::optional<QPointF> projected;  ///< px; unset: no camera
    bool used = true;                  ///< false: it looks wrong
};

/// A photograph with what is clicked and drawn on it, and over it what the simulation shows from the same camera. Wheel, plus and
/// minus zoom; dragging moves the picture or a point. With a tool chosen a click places a point or a corner; the arrow keys move
/// the cross by which Enter does the same. Coordinates are pixels of the upright photograph.
class PhotoView : public QWidget {
    Q_OBJECT

public:
    /// How the simulation lies over the photograph.
    enum class Show { Photograph, Swipe, Blend, Blink, Outline };
    enum class Tool { Look, Point, Mask };

    struct Content {
        QImage picture;  ///< made smaller
        QSize size;      ///< px, of the photograph
        QString title;
        std::vector<PhotoMark> marks;
        std::vector<PhotoMask> masks;
        std::vector<std::vector<Eigen::Vector2d>> outlines;  ///< of the simulated debris
        int chosenMark = -1;
        int chosenMask = -1;
        std::optional<QPointF> pending;  ///< clicked, waits for its counterpart
    };

    explicit PhotoView(QWidget* parent = nullptr);

    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    /// What the simulation shows in the frame of the photograph; a null image: nothing.
    void setOverlay(const QImage& overlay, const QString& caption);
    void setShow(Show show);
    Show show() const { return m_show; }
    /// @param kind  of the mask that is drawn
    void setTool(Tool tool, MaskClass kind = MaskClass::Debris);
    Tool tool() const { return m_tool; }
    /// How much of the simulation is seen when blended, and where the swipe stands; in [0, 1].
    void setBlend(double share);
    void setSwipe(double share);
    double swipe() const { return m_swipe; }
    /// Shows the whole photograph.
    void fit();
    /// Zooms to a point of the photograph.
    void lookAt(const QPointF& pixel);
    QPointF toWidget(const QPointF& pixel) const;
    QPointF toPhotograph(const QPointF& place) const;
    /// Where the loupe stands while points are picked; unset: there is none.
    std::optional<QPointF> loupe() const;

signals:
    void pointPlaced(const QPointF& pixel);
    void markMoved(int mark, const QPointF& pixel);
    void markChosen(int mark);
    void maskDrawn(const rubble::PhotoMask& mask);
    void maskChosen(int mask);
    void swipeMoved(double share);
    /// The user is done with the tool.
    void toolLeft();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Drag { None, Picture, Mark, Swipe };
    QRectF frame() const;
    double scale() const;
    void zoomAt(const QPointF& place, double factor);
    void use(const QPointF& pixel);
    void finishMask();
    int markAt(const QPointF& place) const;
    int maskAt(const QPointF& place) const;
    void paintPictures(QPainter& painter) const;
    void paintMasks(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintChips(QPainter& painter) const;

    Content m_content;
    QImage m_overlay;
    QString m_overlayCaption;
    Show m_show = Show::Photograph;
    Tool m_tool = Tool::Look;
    MaskClass m_kind = MaskClass::Debris;
    std::vector<Eigen::Vector2d> m_corners;  // of the mask that is being drawn
    double m_blend = 0.5;
    double m_swipe = 0.5;
    bool m_blinkOn = false;
    QTimer m_blink;
    double m_zoom = 1.0;
    QPointF m_middle{0.5, 0.5};  // of the widget, in shares of the photograph
    QPointF m_cross;             // px of the photograph
    bool m_crossShown = false;
    bool m_hovered = false;  ///< the mouse is over it, with a tool
    Drag m_drag = Drag::None;
    int m_dragged = -1;
    QPointF m_grabbed;
    bool m_moved = false;
    bool m_pressed = false;  // a double click ends without
};

/// "debris outline", "moved by rescuers" and so on: the class of a mask for people.
QString maskWords(MaskClass kind);
/// The colour of a class; classes differ in the pattern of their lines too.
QColor maskColour(MaskClass kind);

}  // namespace rubble::widgets
