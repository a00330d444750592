#include "app/gui/window/mnemonics.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace rubble {

namespace {

QString plain(QString text) {
    static const QRegularExpression suffix(QStringLiteral("\\s?\\(&[A-Z0-9]\\)"));
    return text.remove(suffix).remove(u'&');
}

bool isLatin(QChar c) {
    return (c >= u'a' && c <= u'z') || (c >= u'A' && c <= u'Z');
}

bool isOwnScript(const QString& text) {
    return std::any_of(text.begin(), text.end(), [](QChar c) { return c.unicode() > 0x2E80; });
}

/// Letters that may be the mnemonic of a text, as capitals: first letters of words, then the others, best first. In a script
/// without them those of the English words, then any.
std::vector<QChar> lettersFor(const QAction& action, const QString& text) {
    const bool ownScript = isOwnScript(text);
    const QString source = ownScript ? action.property("source").toString() : text;
    std::vector<QChar> letters;
    const auto add = [&](QChar letter) {
        if (std::find(letters.begin(), letters.end(), letter) == letters.end()) {
            letters.push_back(letter);
        }
    };
    for (const bool initials : {true, false}) {
        for (qsizetype i = 0; i < source.size(); ++i) {
            const bool initial = i == 0 || !source[i - 1].isLetterOrNumber();
            if (isLatin(source[i]) && (initial || !initials)) {
                add(source[i].toUpper());
            }
        }
    }
    for (char letter = 'A'; ownScript && letter <= 'Z'; ++letter) {
        add(QLatin1Char(letter));
    }
    return letters;
}

/// Each action gets a letter of its own: who finds all of its own taken makes others take another one (Kuhn 1955).
class Letters {
public:
    explicit Letters(std::vector<std::vector<QChar>> wanted) : m_wanted(std::move(wanted)) {
        for (std::size_t i = 0; i < m_wanted.size(); ++i) {
            QSet<QChar> asked;
            give(i, asked);
        }
    }
    /// Null: none is left for it.
    QChar of(std::size_t action) const {
        const auto found =
            std::find_if(m_owners.begin(), m_owners.end(), [&](const auto& letter) { return letter.second == action; });
        return found != m_owners.end() ? found->first : QChar();
    }

private:
    bool give(std::size_t action, QSet<QChar>& asked) {
        const auto take = [&](QChar letter) {
            m_owners[letter] = action;
            return true;
        };
        for (const QChar letter : m_wanted[action]) {
            if (!m_owners.contains(letter)) {
                return take(letter);
            }
        }
        for (const QChar letter : m_wanted[action]) {
            if (!asked.contains(letter)) {
                asked.insert(letter);
                if (give(m_owners.at(letter), asked)) {
                    return take(letter);
                }
            }
        }
        return false;
    }

    std::vector<std::vector<QChar>> m_wanted;  ///< [actions]
    std::map<QChar, std::size_t> m_owners;
};

QString marked(QString text, QChar letter) {
    if (isOwnScript(text)) {
        // The dots that say "a dialog follows" stay last.
        const qsizetype end = text.endsWith(QChar(0x2026)) ? text.size() - 1 : text.size();
        return text.insert(end, QStringLiteral("(&%1)").arg(letter));
    }
    qsizetype place = -1;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const bool initial = i == 0 || !text[i - 1].isLetterOrNumber();
        if (text[i].toUpper() == letter && (place < 0 || initial)) {
            place = i;
            if (initial) {
                break;
            }
        }
    }
    return text.insert(place, u'&');
}

void give(const QList<QAction*>& actions) {
    std::vector<QAction*> named;
    std::vector<std::vector<QChar>> wanted;
    for (QAction* action : actions) {
        const QString text = plain(action->text());
        if (!text.isEmpty() && !action->isSeparator()) {
            named.push_back(action);
            wanted.push_back(lettersFor(*action, text));
        }
    }
    const Letters letters(std::move(wanted));
    for (std::size_t i = 0; i < named.size(); ++i) {
        const QString text = plain(named[i]->text());
        named[i]->setIconText(text);
        const QString tip = named[i]->toolTip();
        named[i]->setText(letters.of(i).isNull() ? text : marked(text, letters.of(i)));
        named[i]->setToolTip(tip);
    }
}

}  // namespace

void giveMnemonics(QMenuBar& bar) {
    give(bar.actions());
    for (QAction* action : bar.actions()) {
        if (QMenu* menu = action->menu()) {
            giveMnemonics(*menu);
            if (!menu->property("mnemonics").toBool()) {
                menu->setProperty("mnemonics", true);
                QObject::connect(menu, &QMenu::aboutToShow, menu, [menu] { giveMnemonics(*menu); });
            }
        }
    }
}

void giveMnemonics(QMenu& menu) {
    give(menu.actions());
    for (QAction* action : menu.actions()) {
        if (QMenu* inner = action->menu()) {
            giveMnemonics(*inner);
        }
    }
}

}  // namespace rubble
