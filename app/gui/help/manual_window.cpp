#include <QEvent>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/gui/help/manual.h"
#include "widgets/basics/language.h"
#include "widgets/basics/theme.h"

namespace rubble {

namespace {

constexpr std::size_t mostFinds = 200;

/// A line without the marks of Markdown.
QString plainLine(QString line) {
    for (const QChar mark : {u'`', u'*', u'#'}) {
        line.remove(mark);
    }
    return line.replace(u'|', QStringLiteral("  ")).simplified();
}

/// "What to ask the solver for": what-to-ask-the-solver-for, as links name it.
QString anchorOf(const QString& heading) {
    QString anchor;
    for (const QChar c : heading.toLower()) {
        if (c.isLetterOrNumber() || c == u'-' || c == u'_') {
            anchor += c;
        } else if (c == u' ') {
            anchor += u'-';
        }
    }
    return anchor;
}

bool holdsAll(const QString& text, const QStringList& words) {
    return std::all_of(words.begin(), words.end(), [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

std::vector<ManualFind> findInManual(const std::vector<ManualPage>& pages, const QString& words) {
    const QStringList wanted = words.split(u' ', Qt::SkipEmptyParts);
    std::vector<ManualFind> titles;
    std::vector<ManualFind> finds;
    if (wanted.isEmpty()) {
        return finds;
    }
    for (std::size_t page = 0; page < pages.size(); ++page) {
        if (holdsAll(pages[page].title, wanted)) {
            titles.push_back({static_cast<int>(page), {}, pages[page].title});
        }
        QString heading;
        const QStringList lines = pages[page].text.split(u'\n');
        for (qsizetype i = 1; i < lines.size(); ++i) {
            const QString line = plainLine(lines[i]);
            if (lines[i].startsWith(u'#')) {
                heading = line;
            }
            if (!lines[i].startsWith(QLatin1String("![")) && holdsAll(line, wanted) && titles.size() + finds.size() < mostFinds) {
                finds.push_back({static_cast<int>(page), heading, line});
            }
        }
    }
    titles.insert(titles.end(), finds.begin(), finds.end());
    return titles;
}

namespace {

/// Shows the pictures of the pages, no wider than there is room.
class PageBrowser : public QTextBrowser {
public:
    QVariant loadResource(int type, const QUrl& name) override {
        if (type != QTextDocument::ImageResource) {
            return QTextBrowser::loadResource(type, name);
        }
        const QImage picture(QStringLiteral(":/manual/") + name.path());
        const int room = std::max(240, viewport()->width() - 56);
        const double scale = devicePixelRatioF();
        const int pixels = static_cast<int>(room * scale);
        QImage fitting = picture.width() > pixels ? picture.scaledToWidth(pixels, Qt::SmoothTransformation) : picture;
        fitting.setDevicePixelRatio(fitting.width() > room ? scale : 1.0);
        return fitting;
    }
};

/// Of words that are pointed at.
QTextCharFormat markFormat() {
    QTextCharFormat format;
    format.setBackground(widgets::tints().findingTint);
    format.setForeground(widgets::tints().text);
    format.setFontWeight(QFont::Bold);
    return format;
}

}  // namespace

ManualWindow::ManualWindow(QWidget* parent)
    : QDialog(parent),
      m_search(new QLineEdit),
      m_titles(new QListWidget),
      m_results(new QListWidget),
      m_found(new QLabel),
      m_language(new QLabel),
      m_text(new PageBrowser) {
    setWindowTitle(tr("Rubble manual"));
    resize(1000, 700);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    auto* left = new QWidget;
    left->setFixedWidth(260);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(12, 12, 8, 12);
    column->setSpacing(8);
    m_search->setObjectName(QStringLiteral("search"));
    m_search->setPlaceholderText(tr("Search the manual"));
    m_search->setAccessibleName(tr("Search the manual"));
    m_search->setToolTip(tr("Words to find; where all of them stand together is listed below"));
    m_search->setClearButtonEnabled(true);
    m_found->setObjectName(QStringLiteral("muted"));
    m_found->setWordWrap(true);
    m_language->setObjectName(QStringLiteral("muted"));
    m_language->setWordWrap(true);
    for (QListWidget* list : {m_titles, m_results}) {
        list->setFrameShape(QFrame::NoFrame);
        list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        list->setTextElideMode(Qt::ElideRight);
    }
    m_titles->setAccessibleName(tr("Pages"));
    m_results->setAccessibleName(tr("Places found"));
    m_results->setObjectName(QStringLiteral("results"));
    m_language->setText(tr("This page is in English."));
    column->addWidget(m_search);
    column->addWidget(m_found);
    column->addWidget(m_titles, 1);
    column->addWidget(m_results, 1);
    column->addWidget(m_language);
    m_text->document()->setDocumentMargin(16);
    // The browser itself would look for a file beside the program.
    m_text->setOpenLinks(false);
    connect(m_text, &QTextBrowser::anchorClicked, this, &ManualWindow::follow);
    row->addWidget(left);
    row->addWidget(m_text, 1);
    connect(m_titles, &QListWidget::currentRowChanged, this, &ManualWindow::open);
    connect(m_results, &QListWidget::currentRowChanged, this, &ManualWindow::openFind);
    connect(m_search, &QLineEdit::textChanged, this, &ManualWindow::search);
    connect(m_search, &QLineEdit::returnPressed, this, [this] { m_results->setCurrentRow(m_results->count() > 0 ? 0 : -1); });
    search({});
    loadPages();
}

void ManualWindow::open(int page) {
    if (page >= 0 && page < static_cast<int>(m_pages.size())) {
        m_text->setMarkdown(m_pages[static_cast<std::size_t>(page)].text);
        m_text->setExtraSelections({});
        m_language->setVisible(!m_pages[static_cast<std::size_t>(page)].ownLanguage);
    }
}

void ManualWindow::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        recolour();
    }
}

void ManualWindow::recolour() {
    QTextCursor cursor(m_text->document());
    QTextCharFormat link;
    link.setForeground(palette().link());
    std::vector<std::pair<int, int>> links;
    for (QTextBlock block = m_text->document()->begin(); block.isValid(); block = block.next()) {
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            if (part.fragment().charFormat().isAnchor()) {
                links.emplace_back(part.fragment().position(), part.fragment().length());
            }
        }
    }
    for (const auto& [from, length] : links) {
        cursor.setPosition(from);
        cursor.setPosition(from + length, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(link);
    }
    QList<QTextEdit::ExtraSelection> marks = m_text->extraSelections();
    for (QTextEdit::ExtraSelection& mark : marks) {
        mark.format = markFormat();
    }
    m_text->setExtraSelections(marks);
}

void ManualWindow::showPage(const QString& title) {
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        if (m_pages[i].name.contains(title, Qt::CaseInsensitive)) {
            m_search->clear();
            m_titles->setCurrentRow(static_cast<int>(i));
            return;
        }
    }
}

void ManualWindow::showPlace(const QString& title, const QString& heading, const QString& words) {
    showPage(title);
    m_text->setExtraSelections({});
    // Headings are asked for in English and stand in the same order in every language.
    const int page = m_titles->currentRow();
    if (page >= 0) {
        const ManualPage& shown = m_pages[static_cast<std::size_t>(page)];
        goToHeading(headingsOf(shown.text).value(shown.headings.indexOf(heading)));
    }
    pointAt(words, true);
}

void ManualWindow::goToHeading(const QString& heading) {
    m_text->moveCursor(QTextCursor::Start);
    for (QTextBlock block = m_text->document()->begin(); !heading.isEmpty() && block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() > 0 && block.text() == heading) {
            // First to the end, so that the heading comes to stand at the top.
            m_text->moveCursor(QTextCursor::End);
            QTextCursor cursor(block);
            m_text->setTextCursor(cursor);
            return;
        }
    }
}

void ManualWindow::follow(const QUrl& link) {
    const auto page =
        std::find_if(m_pages.begin(), m_pages.end(), [&](const ManualPage& each) { return each.file == link.path(); });
    if (!link.path().isEmpty() && page != m_pages.end()) {
        m_search->clear();
        m_titles->setCurrentRow(static_cast<int>(page - m_pages.begin()));
        m_text->moveCursor(QTextCursor::Start);
    }
    if (link.hasFragment() && m_titles->currentRow() >= 0) {
        // Anchors are made of the English headings in every language, which stand in the same order.
        const ManualPage& shown = m_pages[static_cast<std::size_t>(m_titles->currentRow())];
        const auto heading = std::find_if(shown.headings.begin(), shown.headings.end(),
                                          [&](const QString& each) { return anchorOf(each) == link.fragment(); });
        goToHeading(headingsOf(shown.text).value(heading - shown.headings.begin()));
    }
}

void ManualWindow::pointAt(const QString& words, bool go) {
    QList<QTextEdit::ExtraSelection> marks;
    const QStringList wanted = go ? QStringList(words) : words.split(u' ', Qt::SkipEmptyParts);
    for (const QString& word : wanted) {
        if (word.isEmpty()) {
            continue;
        }
        for (QTextCursor at = m_text->document()->find(word); !at.isNull(); at = m_text->document()->find(word, at)) {
            QTextEdit::ExtraSelection mark;
            mark.cursor = at;
            mark.format = markFormat();
            marks << mark;
        }
    }
    m_text->setExtraSelections(marks);
    if (go && !marks.isEmpty()) {
        QTextCursor first = marks.front().cursor;
        first.clearSelection();
        m_text->moveCursor(QTextCursor::End);
        m_text->setTextCursor(first);
        m_text->ensureCursorVisible();
    }
}

QStringList ManualWindow::pointedAt() const {
    QStringList words;
    for (const QTextEdit::ExtraSelection& mark : m_text->extraSelections()) {
        words << mark.cursor.selectedText();
    }
    return words;
}

void ManualWindow::beginSearch() {
    m_search->setFocus();
    m_search->selectAll();
}

void ManualWindow::search(const QString& words) {
    m_finds = findInManual(m_pages, words);
    const bool searching = !words.trimmed().isEmpty();
    m_titles->setVisible(!searching);
    m_results->setVisible(searching);
    m_found->setVisible(searching);
    m_found->setText(m_finds.empty()               ? tr("Nothing found. Try fewer words, or the name of a parameter.")
                     : m_finds.size() >= mostFinds ? tr("%1 places and more").arg(m_finds.size())
                                                   : tr("Places: %1").arg(m_finds.size()));
    const QSignalBlocker quiet(m_results);
    m_results->clear();
    for (const ManualFind& find : m_finds) {
        const QString& title = m_pages[static_cast<std::size_t>(find.page)].title;
        auto* item = new QListWidgetItem(find.heading.isEmpty() ? title : QStringLiteral("%1 › %2").arg(title, find.heading));
        item->setToolTip(find.line);
        m_results->addItem(item);
    }
}

void ManualWindow::openFind(int row) {
    if (row < 0 || row >= static_cast<int>(m_finds.size())) {
        return;
    }
    const ManualFind& find = m_finds[static_cast<std::size_t>(row)];
    open(find.page);
    goToHeading(find.heading);
    pointAt(m_search->text(), false);
}

void ManualWindow::loadPages() {
    const int row = std::max(0, m_titles->currentRow());
    m_pages = manualPages();
    const QSignalBlocker quiet(m_titles);
    m_titles->clear();
    for (const ManualPage& page : m_pages) {
        m_titles->addItem(page.title);
    }
    m_titles->setCurrentRow(row);
    open(row);
}

QString ManualWindow::page() const {
    const int row = m_titles->currentRow();
    return row >= 0 && row < static_cast<int>(m_pages.size()) ? m_pages[static_cast<std::size_t>(row)].name : QString();
}

}  // namespace rubble
