#pragma once

#include <QHash>
#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>
#include <vector>

class QAction;
class QFocusEvent;
class QKeyEvent;
class QLineEdit;
class QWidget;

namespace rubble {

/// Who gets a key of the main window: what has the focus, or the action that has the same key.
/// - Space pushes only what was reached by the keyboard, and belongs to the transport else.
/// - What vanishes or can be used no longer gives the keys to the window, not to whatever comes next.
/// - Characters do nothing beside the fields of a form: who types them there missed a field. Nor does the space after a word.
///   Lists and tables hand letters on, which stand for what is done with a row.
/// - Esc leaves a field as it was, or closes what is open in front; only when nothing is, it cancels what runs. Pressed right after
///   what ended a tool it was meant for that tool, and does nothing.
/// - A key of a menu whose action cannot be used now is answered: nothing else would tell that it was pressed.
class KeyRules : public QObject {
    Q_OBJECT

public:
    /// Something in front of the work, which Esc closes.
    struct Closable {
        std::function<bool()> open;
        std::function<void()> close;
        bool tool = false;  ///< what is done with it, a click or a key, may end it
    };
    /// @param forms      hold fields
    /// @param closables  the front one first; docks that float need not be named
    KeyRules(QWidget& window, std::vector<const QWidget*> forms, std::vector<Closable> closables);

    /// Gives the keys back to the window, so that no field takes what was not meant for it.
    void leaveFields();

signals:
    /// The key of an action was pressed that cannot be used now.
    void refused(const QAction& action);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool ours(const QWidget& widget) const;
    void noteFocus(QWidget& widget, const QFocusEvent& event);
    bool handedOn(const QFocusEvent& event) const;
    bool takesKey(const QKeyEvent& key) const;
    bool typedBeside(const QKeyEvent& key) const;
    bool wouldAct(const QKeyEvent& key) const;
    void noteTool();
    bool endedTool() const;
    bool escapes() const;
    bool escape();
    const QAction* unusable(const QKeyEvent& key) const;

    QWidget& m_window;
    std::vector<const QWidget*> m_forms;
    std::vector<Closable> m_closables;
    bool m_byKeyboard = false;          ///< what has the focus was reached by the keyboard
    bool m_beside = false;              ///< the key at hand is typed beside the fields of a form
    bool m_inWord = false;              ///< and the last one was a character
    std::optional<std::size_t> m_tool;  ///< among what Esc closes, that was open when something was clicked or pressed last
    QPointer<QWidget> m_focus;          ///< had the focus last
    QPointer<QLineEdit> m_field;
    QString m_before;  ///< what the field held when it got the focus
};

}  // namespace rubble
