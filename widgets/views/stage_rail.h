#pragma once

#include <QAbstractButton>
#include <QWidget>
#include <vector>

#include "widgets/basics/icons.h"

namespace rubble::widgets {

/// How far a stage of the window's pipeline is.
enum class StageState { NotYet, Running, UpToDate, Stale };

/// One entry of the rail.
struct RailEntry {
    QString title;
    QString question;
    Glyph glyph;
};

/// The pipeline as a column of entries at the left of the window, each with its state. Emits chosen(); shows only icons with
/// tooltips when compact.
class StageRail : public QWidget {
    Q_OBJECT

public:
    explicit StageRail(const std::vector<RailEntry>& entries, QWidget* parent = nullptr);

    /// The same entries in other words.
    void setEntries(const std::vector<RailEntry>& entries);
    int current() const { return m_current; }
    void setCurrent(int index);
    /// @param findings  counted recoverable findings: an amber mark beside the state
    /// @param fraction  progress while running, in [0, 1]
    void setState(int index, StageState state, std::int64_t findings = 0, double fraction = 0.0);
    StageState state(int index) const;
    void setCompact(bool compact);
    bool compact() const { return m_compact; }

signals:
    void chosen(int index);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    class Button;
    std::vector<Button*> m_buttons;
    int m_current = -1;
    bool m_compact = false;
};

}  // namespace rubble::widgets
