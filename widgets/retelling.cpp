#include "widgets/retelling.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QPointer>
#include <QTabWidget>
#include <QTextBrowser>
#include <QUndoStack>
#include <QUndoView>
#include <QVariant>
#include <QWidget>
#include <algorithm>
#include <array>

namespace rubble::widgets {

namespace {

/// Where a value stands in a text: %1 in texts of the window, {0} in messages of core.
const QRegularExpression& valuePlace() {
    static const QRegularExpression place(QStringLiteral("%L?(\\d)|\\{(\\d)\\}"));
    return place;
}

/// What parts a text that is put together: first tags, line ends and names in code, which are no words in any language, then, where
/// a piece is no text itself, dots between figures, arrows and semicolons.
const QRegularExpression& outerJoint() {
    static const QRegularExpression between(QStringLiteral("<code>[^<]*</code>|<[^>]*>|\\n|&nbsp;"));
    return between;
}
const QRegularExpression& innerJoint() {
    static const QRegularExpression between(QStringLiteral(" · | → |; |, "));
    return between;
}

/// How much a text says: letters of Latin script count one, signs of Chinese three.
int weightOf(const QString& own) {
    int weight = 0;
    for (const QChar c : own) {
        weight += c.unicode() > 0x2E80 ? 3 : c.isLetter() ? 1 : 0;
    }
    return weight;
}

/// From here on a pattern has words enough of its own to be tried on texts of other classes than its own.
constexpr int tellingWeight = 6;

/// Classes of an object and of what it lies in, innermost first.
QByteArrayList contextsOf(const QObject& object) {
    QByteArrayList contexts;
    for (const QObject* at = &object; at != nullptr; at = at->parent()) {
        for (const QMetaObject* type = at->metaObject(); type != nullptr; type = type->superClass()) {
            const QByteArray name = type->className();
            if (name.startsWith('Q')) {
                break;
            }
            contexts << name;
        }
    }
    // Free functions speak in the name of their namespace.
    for (const QByteArray& type : QByteArrayList(contexts)) {
        if (const qsizetype end = type.lastIndexOf("::"); end > 0 && !contexts.contains(type.left(end))) {
            contexts << type.left(end);
        }
    }
    return contexts;
}

/// Properties that hold words, of any widget.
constexpr std::array wordProperties = {"text",
                                       "title",
                                       "toolTip",
                                       "statusTip",
                                       "whatsThis",
                                       "accessibleName",
                                       "accessibleDescription",
                                       "placeholderText",
                                       "windowTitle",
                                       "specialValueText"};

/// A field that the user types into holds the user's words.
bool holdsWordsOfTheUser(const QObject& object, const char* property) {
    return object.inherits("QLineEdit") && qstrcmp(property, "text") == 0;
}

/// "Save &as (&A)": as it is in the catalogue, without what a menu puts in for the keyboard.
QString withoutMnemonic(QString text) {
    static const QRegularExpression suffix(QStringLiteral("\\s?\\(&[A-Za-z0-9]\\)"));
    return text.remove(suffix).remove(u'&');
}

}  // namespace

Retelling::Retelling(const Catalogue& from, const Catalogue& to) {
    for (const SourceText& source : Catalogue::spoken()) {
        learn(source, from.words(source), to.words(source));
    }
    // Patterns with much of their own before those that would fit anything.
    std::stable_sort(m_patterns.begin(), m_patterns.end(),
                     [](const Pattern& a, const Pattern& b) { return a.form.pattern().size() > b.form.pattern().size(); });
}

void Retelling::learn(const SourceText& source, const QString& from, const QString& to) {
    m_words[from] << Words{source.context, to};
    Pattern pattern{source.context, {}, weightOf(QString(from).remove(valuePlace())), {}, {}, to};
    QString form = QStringLiteral("^");
    qsizetype at = 0;
    auto places = valuePlace().globalMatch(from);
    while (places.hasNext()) {
        const QRegularExpressionMatch place = places.next();
        const QString own = from.mid(at, place.capturedStart() - at);
        pattern.longest = own.size() > pattern.longest.size() ? own : pattern.longest;
        form += QRegularExpression::escape(own) + QStringLiteral("(.*?)");
        pattern.places.push_back(place.captured(1).isEmpty() ? place.captured(2).toInt() : place.captured(1).toInt());
        at = place.capturedEnd();
    }
    const QString rest = from.mid(at);
    pattern.longest = rest.size() > pattern.longest.size() ? rest : pattern.longest;
    const auto letter = [](QChar c) { return c.isLetter(); };
    if (!pattern.places.empty() && std::any_of(pattern.longest.begin(), pattern.longest.end(), letter)) {
        pattern.form =
            QRegularExpression(form + QRegularExpression::escape(rest) + u'$', QRegularExpression::DotMatchesEverythingOption);
        m_patterns.push_back(std::move(pattern));
    }
}

QString Retelling::whole(const QString& text, const QByteArrayList& contexts) const {
    const auto found = m_words.constFind(text);
    if (found == m_words.constEnd()) {
        return {};
    }
    // Where no class of its own has it, a text is most likely the name of a parameter, of a choice or of an action.
    for (const QByteArray& context : contexts + QByteArrayList{"parameters", "choices", "actions"}) {
        for (const Words& words : *found) {
            if (words.context == context) {
                return words.to;
            }
        }
    }
    return found->front().to;
}

QString Retelling::filled(const QString& text, const QByteArrayList& contexts) const {
    for (const Pattern& pattern : m_patterns) {
        const bool own = contexts.contains(pattern.context);
        if (!text.contains(pattern.longest) || (!own && pattern.weight < tellingWeight)) {
            continue;
        }
        const QRegularExpressionMatch match = pattern.form.match(text);
        if (!match.hasMatch()) {
            continue;
        }
        QString result;
        qsizetype at = 0;
        auto places = valuePlace().globalMatch(pattern.to);
        while (places.hasNext()) {
            const QRegularExpressionMatch place = places.next();
            result += pattern.to.mid(at, place.capturedStart() - at);
            const int value = place.captured(1).isEmpty() ? place.captured(2).toInt() : place.captured(1).toInt();
            const auto known = std::find(pattern.places.begin(), pattern.places.end(), value);
            result += known == pattern.places.end()
                          ? place.captured()
                          : retold(match.captured(static_cast<int>(known - pattern.places.begin()) + 1), contexts);
            at = place.capturedEnd();
        }
        return result + pattern.to.mid(at);
    }
    return {};
}

QString Retelling::known(const QString& text, const QByteArrayList& contexts) const {
    const QString core = text.trimmed();
    for (const QString& form : {text, core, core + u' ', u' ' + core, u' ' + core + u' '}) {
        if (const QString words = whole(form, contexts); !words.isEmpty()) {
            // White space around the words stays as it was, unless it is part of them.
            const qsizetype start = text.indexOf(core);
            return form == core ? text.left(start) + words + text.mid(start + core.size()) : words;
        }
    }
    return filled(text, contexts);
}

QString Retelling::piece(const QString& text, const QByteArrayList& contexts) const {
    const auto letter = [](QChar c) { return c.isLetter(); };
    if (std::none_of(text.begin(), text.end(), letter)) {
        return text;
    }
    if (const QString words = known(text, contexts); !words.isEmpty()) {
        return words;
    }
    if (text.contains(innerJoint())) {
        return byParts(text, innerJoint(), contexts);
    }
    // A name and its value: "Unit: m".
    for (const QString& colon : {QStringLiteral(": "), QStringLiteral("：")}) {
        if (const qsizetype at = text.indexOf(colon); at > 0) {
            return piece(text.left(at), contexts) + colon + piece(text.mid(at + colon.size()), contexts);
        }
    }
    return text;
}

QString Retelling::byParts(const QString& text, const QRegularExpression& joint, const QByteArrayList& contexts) const {
    QString result;
    qsizetype at = 0;
    auto joints = joint.globalMatch(text);
    while (joints.hasNext()) {
        const QRegularExpressionMatch match = joints.next();
        result += piece(text.mid(at, match.capturedStart() - at), contexts) + match.captured();
        at = match.capturedEnd();
    }
    return result + piece(text.mid(at), contexts);
}

QString Retelling::retold(const QString& text, const QByteArrayList& contexts) const {
    if (text.isEmpty()) {
        return text;
    }
    if (const QString words = known(text, contexts); !words.isEmpty()) {
        return words;
    }
    return text.contains(outerJoint()) ? byParts(text, outerJoint(), contexts) : piece(text, contexts);
}

void Retelling::apply(QWidget& window) const {
    applyTo(window);
    // What speaks anew may let go of objects of its own, as a text of its paragraphs.
    const QList<QObject*> found = window.findChildren<QObject*>();
    const QList<QPointer<QObject>> inside(found.begin(), found.end());
    for (const QPointer<QObject>& object : inside) {
        if (object) {
            applyTo(*object);
        }
    }
}

void Retelling::applyTo(QObject& object) const {
    const QByteArrayList contexts = contextsOf(object);
    if (auto* action = qobject_cast<QAction*>(&object)) {
        applyTo(*action, QByteArrayList{"actions"} + contexts);
        return;
    }
    auto* widget = qobject_cast<QWidget*>(&object);
    if (widget == nullptr) {
        return;
    }
    for (const char* property : wordProperties) {
        const QVariant value = object.property(property);
        if (value.typeId() != QMetaType::QString || holdsWordsOfTheUser(object, property)) {
            continue;
        }
        const QString before = value.toString();
        if (const QString after = retold(before, contexts); after != before) {
            object.setProperty(property, after);
        }
    }
    if (auto* choice = qobject_cast<QComboBox*>(widget)) {
        applyTo(*choice->model(), contexts);
    }
    if (auto* tabs = qobject_cast<QTabWidget*>(widget)) {
        for (int i = 0; i < tabs->count(); ++i) {
            tabs->setTabText(i, retold(tabs->tabText(i), contexts));
            tabs->setTabToolTip(i, retold(tabs->tabToolTip(i), contexts));
        }
    }
    if (const auto* history = qobject_cast<QUndoView*>(widget); history != nullptr && history->stack() != nullptr) {
        for (int i = 0; i < history->stack()->count(); ++i) {
            // The stack lends its commands for reading; what they are called is for the screen alone.
            auto* command = const_cast<QUndoCommand*>(history->stack()->command(i));
            command->setText(retold(command->text(), contexts));
        }
    }
    if (auto* view = qobject_cast<QAbstractItemView*>(widget);
        view != nullptr && view->model() != nullptr && !widget->inherits("QHeaderView")) {
        // What a cell says is changed here, not edited by the user.
        const QSignalBlocker quiet(view);
        applyTo(*view->model(), contexts);
    }
    widget->updateGeometry();
    widget->update();
}

void Retelling::applyTo(QAction& action, const QByteArrayList& contexts) const {
    // What a menu put in for the keyboard is put in anew when it opens.
    action.setText(retold(withoutMnemonic(action.text()), contexts));
    action.setIconText(retold(withoutMnemonic(action.iconText()), contexts));
    static const QRegularExpression key(QStringLiteral("^(.*) \\(([^()]*)\\)$"));
    const QRegularExpressionMatch match = key.match(action.toolTip());
    action.setToolTip(match.hasMatch() ? retold(match.captured(1), contexts) + QStringLiteral(" (%1)").arg(match.captured(2))
                                       : retold(action.toolTip(), contexts));
    action.setStatusTip(retold(action.statusTip(), contexts));
    action.setWhatsThis(retold(action.whatsThis(), contexts));
}

void Retelling::applyTo(QAbstractItemModel& model, const QByteArrayList& contexts) const {
    for (const Qt::Orientation orientation : {Qt::Horizontal, Qt::Vertical}) {
        const int count = orientation == Qt::Horizontal ? model.columnCount() : model.rowCount();
        for (int i = 0; i < count; ++i) {
            for (const int role : {Qt::DisplayRole, Qt::ToolTipRole}) {
                const QVariant value = model.headerData(i, orientation, role);
                if (value.typeId() == QMetaType::QString) {
                    model.setHeaderData(i, orientation, retold(value.toString(), contexts), role);
                }
            }
        }
    }
    // Of models of a million rows none keeps words; those that do are the small ones that widgets fill.
    constexpr int mostRows = 1000;
    for (int row = 0; row < std::min(model.rowCount(), mostRows); ++row) {
        for (int column = 0; column < model.columnCount(); ++column) {
            const QModelIndex index = model.index(row, column);
            for (const int role : {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleTextRole}) {
                const QVariant value = index.data(role);
                if (value.typeId() != QMetaType::QString) {
                    continue;
                }
                if (const QString after = retold(value.toString(), contexts); after != value.toString()) {
                    model.setData(index, after, role);
                }
            }
        }
    }
}

}  // namespace rubble::widgets
