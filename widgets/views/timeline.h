#pragma once

#include <QWidget>
#include <optional>
#include <utility>
#include <vector>

namespace rubble::widgets {

/// A limit of health that was passed, as the timeline shows it.
struct HealthMark {
    double from = 0.0;  ///< s
    double to = 0.0;    ///< s
    QString title;      ///< a few words
    QString words;      ///< rich text: what, where, when, worst against limit, remedy
    bool acknowledged = false;
};

/// An instant that was marked, as the timeline shows it.
struct TimeMark {
    double time = 0.0;  ///< s
    QString note;
};

/// Loose structure went over to the engine, as the timeline shows it.
struct HandOverMark {
    double time = 0.0;  ///< s
    QString words;      ///< what and how much
};

/// When a photograph was taken, as far as that is known.
struct PhotographTime {
    double time = 0.0;         ///< s
    double uncertainty = 0.0;  ///< s, as much before as after
    QString name;
};

/// Deaths over time as an area, those in islands as one within it, what is computed as a bar that grows, breaches of health as
/// intervals with a warning sign, the end of the FE result as a dashed line, bookmarks as flags, the range that playback goes round
/// as a band, one playhead. Emits scrubbed() while the mouse drags, loopDragged() with Shift, markChosen() when a warning sign is
/// clicked. Times in s, on the file's clock.
class Timeline : public QWidget {
    Q_OBJECT

public:
    explicit Timeline(QWidget* parent = nullptr);

    /// The span of the axis.
    void setRange(double first, double last);
    /// Elements that died in the interval that ends at each state.
    void setDeaths(std::vector<double> times, std::vector<double> deaths);
    /// How many of these died in islands that the engine carried, and when it took such over: an area within the other one, and
    /// ticks below it. Empty where it carried none.
    void setIslands(std::vector<double> deaths, std::vector<HandOverMark> handOvers);
    void setFeEnd(double time);
    /// What is computed; empty (last <= first) for nothing.
    void setComputed(double first, double last, bool stale);
    void setTime(double time);
    /// Breaches of health in the order in which they began; the row goes when there are none.
    void setHealth(std::vector<HealthMark> marks);

    /// Bookmarks in the order of their times; the row goes when there are none.
    void setBookmarks(std::vector<TimeMark> bookmarks);
    /// Times of photographs, as small frames in the row of the bookmarks; a click goes there.
    void setPhotographs(std::vector<PhotographTime> photographs);
    std::optional<std::size_t> photographAt(const QPointF& point) const;
    /// The range that playback goes round; unset: none.
    void setLoop(const std::optional<std::pair<double, double>>& range);
    /// Labels of the axis count from here.
    void setTimeOrigin(double origin);

    double time() const { return m_time; }
    /// Times of the camera keys of movies, as diamonds in the row of the bookmarks.
    void setCameraKeys(std::vector<double> times);
    const std::vector<double>& cameraKeys() const { return m_cameraKeys; }
    /// Centre of the flag of a bookmark.
    QPointF flagOf(std::size_t bookmark) const;
    std::optional<std::size_t> bookmarkAt(const QPointF& point) const;
    /// Centre of the tick of a hand-over; the hand-over whose tick is nearest to a point on it.
    QPointF tickOf(std::size_t handOver) const;
    std::optional<std::size_t> handOverAt(const QPointF& point) const;
    /// Place of a time on the axis and back [px].
    double toX(double time) const;
    double toTime(double x) const;
    /// s: where the scale of the axis changes, so that a brief FE result has half of it; unset: one scale.
    std::optional<double> fold() const;
    /// Marks under a point, in their order; the sign of a group stands for all of them.
    std::vector<std::size_t> marksAt(const QPointF& point) const;
    /// Centre of the sign of a mark.
    QPointF signOf(std::size_t mark) const;
    QSize sizeHint() const override { return {600, 116 + (eventless() ? 0 : bookmarkRow)}; }
    QSize minimumSizeHint() const override { return {240, 96}; }

signals:
    void scrubbed(double time);
    void markChosen(std::size_t mark);
    void bookmarkChosen(std::size_t bookmark);
    /// Double-clicked: its note is to be changed.
    void bookmarkOpened(std::size_t bookmark);
    /// Dragged with Shift held. @param done  the button was let go
    void loopDragged(double from, double to, bool done);

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    static constexpr int bookmarkRow = 16;      // px
    static constexpr double leastShare = 0.02;  // of the axis: a result that has less gets half
    bool eventless() const { return m_bookmarks.empty() && m_photographs.empty() && m_cameraKeys.empty(); }
    /// There is more than bookmarks in their row.
    bool mixed() const { return !m_photographs.empty() || !m_cameraKeys.empty(); }
    /// Where things stand, from top to bottom.
    struct Rows {
        double left, right;
        double deathsTop, deathsBottom;
        double barTop, barBottom;
        double bookmarks;  // centre of the row of flags
        double health;     // centre of the row of warning signs
        double axis;
    };
    Rows rows() const;
    void paintDeaths(QPainter& painter, const Rows& rows) const;
    void paintHandOvers(QPainter& painter, const Rows& rows) const;
    bool showToolTip(const QPointF& point, const QPoint& global);
    /// The highest peak of the deaths, labelled directly.
    void paintPeak(QPainter& painter, const Rows& rows) const;
    /// A caption in the row of the deaths, legible where the line of the shown time passes through it.
    void paintCaption(QPainter& painter, const Rows& rows, double at, double gap, const QString& text) const;
    void paintComputed(QPainter& painter, const Rows& rows) const;
    void paintAxis(QPainter& painter, const Rows& rows) const;
    void paintTicks(QPainter& painter, const Rows& rows, double first, double last) const;
    void paintMarks(QPainter& painter, const Rows& rows) const;
    void paintHealth(QPainter& painter, const Rows& rows) const;
    void paintBookmarks(QPainter& painter, const Rows& rows) const;
    void paintCameraKeys(QPainter& painter, const Rows& rows) const;
    void paintPhotographs(QPainter& painter, const Rows& rows) const;
    void paintLoop(QPainter& painter, const Rows& rows) const;
    /// A time as the axis counts it: "4.88 s".
    QString shownTime(double time) const;
    void groupSigns();
    QString wordsOf(const std::vector<std::size_t>& marks) const;

    double m_first = 0.0;
    double m_last = 0.0;
    std::vector<double> m_times;
    std::vector<double> m_deaths;
    std::vector<double> m_islandDeaths;  // as m_deaths, or empty
    std::vector<HandOverMark> m_handOvers;
    double m_feEnd = 0.0;
    double m_computedFirst = 0.0;
    double m_computedLast = 0.0;
    bool m_stale = false;
    double m_time = 0.0;
    std::vector<HealthMark> m_marks;
    // Signs that would cover each other stand as one: marks from first to last.
    struct Sign {
        std::size_t first, last;
    };
    std::vector<Sign> m_signs;
    std::vector<TimeMark> m_bookmarks;
    std::vector<double> m_cameraKeys;  ///< s
    std::vector<PhotographTime> m_photographs;
    std::optional<std::pair<double, double>> m_loop;
    double m_origin = 0.0;
    bool m_scrubbing = false;
    std::optional<double> m_loopStart;  // where a drag with Shift began
};

}  // namespace rubble::widgets
