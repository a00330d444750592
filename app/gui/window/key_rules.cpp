#include "app/gui/window/key_rules.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextDocument>
#include <QTextEdit>
#include <algorithm>
#include <utility>

#include "widgets/basics/form_row.h"

namespace rubble {

namespace {

/// The line that is typed into while a widget has the focus; null if there is none.
QLineEdit* lineOf(QWidget* widget) {
    if (auto* line = qobject_cast<QLineEdit*>(widget)) {
        return line->isReadOnly() ? nullptr : line;
    }
    const bool holdsOne = qobject_cast<QAbstractSpinBox*>(widget) != nullptr || qobject_cast<QComboBox*>(widget) != nullptr;
    return holdsOne ? widget->findChild<QLineEdit*>() : nullptr;
}

bool isTypedInto(QWidget* widget) {
    if (const auto* text = qobject_cast<const QTextEdit*>(widget)) {
        return !text->isReadOnly();
    }
    return lineOf(widget) != nullptr || qobject_cast<const QPlainTextEdit*>(widget) != nullptr;
}

/// One that is not typed into. Arrows and the wheel with focus move along it; letters and ends do so once it is open.
bool isClosedList(const QWidget* widget) {
    const auto* box = qobject_cast<const QComboBox*>(widget);
    return box != nullptr && !box->isEditable();
}

bool isPushed(const QWidget* widget) {
    return qobject_cast<const QAbstractButton*>(widget) != nullptr || qobject_cast<const QComboBox*>(widget) != nullptr ||
           qobject_cast<const QAbstractItemView*>(widget) != nullptr;
}

bool isCharacter(const QKeyEvent& key) {
    const bool plain = (key.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == Qt::NoModifier;
    return plain && key.text().size() == 1 && key.text().front().isPrint() && key.key() != Qt::Key_Space;
}

/// Shift may still be held from the letter before.
bool isSpaceOfText(const QKeyEvent& key) {
    return key.key() == Qt::Key_Space && (key.modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
}

bool isModifier(const QKeyEvent& key) {
    switch (key.key()) {
        case Qt::Key_Shift:
        case Qt::Key_Control:
        case Qt::Key_Meta:
        case Qt::Key_Alt:
        case Qt::Key_AltGr:
        case Qt::Key_CapsLock:
            return true;
        default:
            return false;
    }
}

bool movesWithin(const QKeyEvent& key, const QWidget* focus) {
    const bool arrow =
        key.key() == Qt::Key_Left || key.key() == Qt::Key_Right || key.key() == Qt::Key_Home || key.key() == Qt::Key_End;
    const auto* button = qobject_cast<const QAbstractButton*>(focus);
    return arrow && (qobject_cast<const QAbstractSlider*>(focus) != nullptr || (button != nullptr && button->group() != nullptr));
}

bool isEscape(const QKeyEvent& key) {
    return key.key() == Qt::Key_Escape && key.modifiers() == Qt::NoModifier;
}

/// A field takes these keys for what was typed into it, also where nothing was.
bool takesBack(const QKeyEvent& key) {
    return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

bool hasTyped(QWidget* focus, const QKeyEvent& key) {
    const bool undo = key.matches(QKeySequence::Undo);
    if (const QLineEdit* line = lineOf(focus)) {
        return undo ? line->isUndoAvailable() : line->isRedoAvailable();
    }
    const auto* plain = qobject_cast<const QPlainTextEdit*>(focus);
    const auto* rich = qobject_cast<const QTextEdit*>(focus);
    const QTextDocument* text = plain != nullptr ? plain->document() : rich != nullptr ? rich->document() : nullptr;
    return text != nullptr && (undo ? text->isUndoAvailable() : text->isRedoAvailable());
}

/// The dock that floats in front, the one with the focus first: Esc closes it. One that is docked is a panel, and stays.
QDockWidget* dockInFront(const QWidget& window) {
    const QWidget* focus = QApplication::focusWidget();
    QDockWidget* front = nullptr;
    for (auto* dock : window.findChildren<QDockWidget*>()) {
        if (dock->isVisible() && dock->isFloating()) {
            const bool focused = focus != nullptr && dock->isAncestorOf(focus);
            front = front == nullptr || focused ? dock : front;
        }
    }
    return front;
}

}  // namespace

KeyRules::KeyRules(QWidget& window, std::vector<const QWidget*> forms, std::vector<Closable> closables)
    : QObject(&window), m_window(window), m_forms(std::move(forms)), m_closables(std::move(closables)) {
    qApp->installEventFilter(this);
    leaveFields();
}

void KeyRules::leaveFields() {
    // What is left without any focus would hand it to the first field when the window is activated.
    m_window.setFocus(Qt::OtherFocusReason);
}

bool KeyRules::ours(const QWidget& widget) const {
    const QWidget* top = widget.window();
    return top == &m_window || (qobject_cast<const QDockWidget*>(top) != nullptr && top->parentWidget() != nullptr &&
                                top->parentWidget()->window() == &m_window);
}

/// Qt hands the focus of what is hidden or disabled to the next widget, as if somebody had pressed Tab.
bool KeyRules::handedOn(const QFocusEvent& event) const {
    return event.reason() == Qt::TabFocusReason && m_focus != nullptr && (!m_focus->isVisible() || !m_focus->isEnabled());
}

void KeyRules::noteFocus(QWidget& widget, const QFocusEvent& event) {
    const bool passedOn = handedOn(event);
    m_focus = &widget;
    m_inWord = false;
    if (passedOn) {
        m_byKeyboard = false;
        QMetaObject::invokeMethod(this, &KeyRules::leaveFields, Qt::QueuedConnection);
        return;
    }
    switch (event.reason()) {
        case Qt::TabFocusReason:
        case Qt::BacktabFocusReason:
        case Qt::ShortcutFocusReason:
            m_byKeyboard = true;
            break;
        case Qt::ActiveWindowFocusReason:
        case Qt::PopupFocusReason:
        case Qt::MenuBarFocusReason:
            return;
        default:
            m_byKeyboard = false;
    }
    m_field = lineOf(&widget);
    m_before = m_field != nullptr ? m_field->text() : QString();
}

bool KeyRules::takesKey(const QKeyEvent& key) const {
    QWidget* focus = QApplication::focusWidget();
    if (isEscape(key)) {
        return key.isAutoRepeat() || escapes();
    }
    if (focus == nullptr || isTypedInto(focus)) {
        return false;
    }
    return (key.key() == Qt::Key_Space && m_byKeyboard && isPushed(focus)) || movesWithin(key, focus) || m_beside;
}

bool KeyRules::typedBeside(const QKeyEvent& key) const {
    QWidget* focus = QApplication::focusWidget();
    if (focus == nullptr || isTypedInto(focus) ||
        std::none_of(m_forms.begin(), m_forms.end(), [focus](const QWidget* form) { return form->isAncestorOf(focus); })) {
        return false;
    }
    const bool row =
        qobject_cast<const QAbstractItemView*>(focus) != nullptr && !key.text().isEmpty() && key.text().front().isLetter();
    return (isCharacter(key) && !row) || (m_inWord && isSpaceOfText(key));
}

/// A space would push a button that was clicked, and a letter would choose another line of a closed list.
bool KeyRules::wouldAct(const QKeyEvent& key) const {
    return isSpaceOfText(key) || isClosedList(QApplication::focusWidget());
}

void KeyRules::noteTool() {
    const auto open =
        std::find_if(m_closables.begin(), m_closables.end(), [](const Closable& each) { return each.tool && each.open(); });
    m_tool = open != m_closables.end() ? std::optional<std::size_t>(open - m_closables.begin()) : std::nullopt;
}

bool KeyRules::endedTool() const {
    return m_tool && !m_closables[*m_tool].open();
}

bool KeyRules::escapes() const {
    return isTypedInto(QApplication::focusWidget()) || endedTool() || dockInFront(m_window) != nullptr ||
           std::any_of(m_closables.begin(), m_closables.end(), [](const Closable& each) { return each.open(); });
}

bool KeyRules::escape() {
    if (QWidget* focus = QApplication::focusWidget(); isTypedInto(focus)) {
        const bool changed = m_field != nullptr && m_field == lineOf(focus) && m_field->text() != m_before;
        if (changed && !widgets::isKeptAsTyped(*m_field)) {
            m_field->setText(m_before);
            m_field->setModified(false);
        }
        leaveFields();
        return true;
    }
    if (endedTool()) {
        m_tool.reset();
        return true;
    }
    if (QDockWidget* dock = dockInFront(m_window)) {
        dock->close();
        return true;
    }
    const auto front = std::find_if(m_closables.begin(), m_closables.end(), [](const Closable& each) { return each.open(); });
    if (front == m_closables.end()) {
        return false;
    }
    front->close();
    return true;
}

/// Plain letters and arrows have a meaning of their own wherever they are pressed.
const QAction* KeyRules::unusable(const QKeyEvent& key) const {
    const bool ofMenus = (key.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) != Qt::NoModifier ||
                         (key.key() >= Qt::Key_F1 && key.key() <= Qt::Key_F35);
    if (!ofMenus) {
        return nullptr;
    }
    const QKeySequence pressed(key.keyCombination());
    for (const QAction* action : m_window.actions()) {
        if (!action->isEnabled() && action->shortcut() == pressed) {
            return action;
        }
    }
    return nullptr;
}

bool KeyRules::eventFilter(QObject* watched, QEvent* event) {
    auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr || !ours(*widget)) {
        return QObject::eventFilter(watched, event);
    }
    if (event->type() == QEvent::FocusIn) {
        noteFocus(*widget, *static_cast<QFocusEvent*>(event));
    } else if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick) {
        m_inWord = false;
        noteTool();
    } else if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        m_beside = typedBeside(key);
        m_inWord = isModifier(key) ? m_inWord : m_beside && isCharacter(key);
        if (!isEscape(key) && !isModifier(key)) {
            noteTool();
        } else if (isEscape(key) && !endedTool()) {
            m_tool.reset();
        }
        if (takesKey(key)) {
            event->accept();
            return true;
        }
        if (takesBack(key) && isTypedInto(widget) && !hasTyped(widget, key)) {
            event->ignore();
            return true;  // the edit of the case before is meant
        }
    } else if (event->type() == QEvent::KeyPress) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        // What nothing below has used comes to the window.
        if (isEscape(key) && widget == widget->window()) {
            return !key.isAutoRepeat() && escape();
        }
        if (const QAction* action = widget == widget->window() && !key.isAutoRepeat() ? unusable(key) : nullptr) {
            emit refused(*action);
        }
        const bool end = key.key() == Qt::Key_Home || key.key() == Qt::Key_End;
        if ((m_beside && wouldAct(key)) || (end && isClosedList(widget))) {
            return true;
        }
        m_byKeyboard = m_byKeyboard || key.key() == Qt::Key_Up || key.key() == Qt::Key_Down;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace rubble
