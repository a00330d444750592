#include "app/gui/window/mnemonics.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>
#include <algorithm>

namespace rubble {

namespace {

QString plain(QString text) {
    static const QRegularExpression suffix(QStringLiteral("\\s?\\(&[A-Z0-9]\\)"));
    return text.remove(suffix).remove(u'&');
}

bool isLatin(QChar c) {
    return (c >= u'a' && c <= u'z') || (c >= u'A' && c <= u'Z');
}

/// The first letter of a word, then any letter, that is still free.
qsizetype freeLetter(const QString& text, const QSet<QChar>& taken) {
    for (const bool initials : {true, false}) {
        for (qsizetype i = 0; i < text.size(); ++i) {
            const bool initial = i == 0 || !text[i - 1].isLetterOrNumber();
            if (isLatin(text[i]) && (initial || !initials) && !taken.contains(text[i].toUpper())) {
                return i;
            }
        }
    }
    return -1;
}

void give(const QList<QAction*>& actions) {
    QSet<QChar> taken;
    for (QAction* action : actions) {
        const QString text = plain(action->text());
        if (text.isEmpty() || action->isSeparator()) {
            continue;
        }
        const bool ownScript = std::any_of(text.begin(), text.end(), [](QChar c) { return c.unicode() > 0x2E80; });
        const QString source = ownScript ? action->property("source").toString() : text;
        const qsizetype place = freeLetter(source, taken);
        QString marked = text;
        if (place >= 0 && !ownScript) {
            taken.insert(text[place].toUpper());
            marked.insert(place, u'&');
        } else if (ownScript) {
            QChar letter = place >= 0 ? source[place].toUpper() : QChar(u'A');
            while (letter <= u'Z' && taken.contains(letter)) {
                letter = QChar(letter.unicode() + 1);
            }
            if (letter > u'Z') {
                continue;
            }
            taken.insert(letter);
            // The dots that say "a dialog follows" stay last.
            const qsizetype end = text.endsWith(QChar(0x2026)) ? text.size() - 1 : text.size();
            marked.insert(end, QStringLiteral("(&%1)").arg(letter));
        }
        action->setIconText(text);
        const QString tip = action->toolTip();
        action->setText(marked);
        action->setToolTip(tip);
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
