#include "app/gui/manual.h"

#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QListWidget>
#include <QLocale>
#include <QTextBrowser>
#include <cmath>

#include "app/gui/actions.h"
#include "core/scenario/parameters.h"
#include "widgets/wording.h"

namespace rubble {

namespace {

QString qt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString rangeText(const Parameter& row) {
    if (row.kind == ParameterKind::Choice) {
        QStringList choices;
        for (const std::string_view choice : row.choices) {
            choices << qt(choice);
        }
        return choices.join(QStringLiteral(", "));
    }
    if (row.kind == ParameterKind::Switch) {
        return QStringLiteral("on, off");
    }
    if (row.kind == ParameterKind::Text) {
        return QStringLiteral("text");
    }
    const auto limit = [](double value) {
        return std::isfinite(value) ? QLocale::c().toString(value, 'g', 6) : QStringLiteral("any");
    };
    return QStringLiteral("%1 to %2%3").arg(limit(row.low), limit(row.high), row.automatic ? QStringLiteral(", auto") : QString());
}

}  // namespace

QString parameterReference() {
    const Scenario defaults;
    QString page = QStringLiteral(
        "# Parameters\n\nEvery setting of a scenario, as the panels, `rubble-cli --set key=value` and the case file know it.\n\n"
        "|Key|Meaning|Unit|Default|Values|What it does and what it costs|\n|---|---|---|---|---|---|\n");
    for (const Parameter& row : parameterTable()) {
        const QString byDefault = row.subject() == ParameterSubject::Pair
                                      ? QStringLiteral("auto")
                                      : QString::fromStdString(valueText(row.get(defaults, {})));
        page += QStringLiteral("|`%1`|%2|%3|%4|%5|%6|\n")
                    .arg(qt(row.key), qt(row.label), qt(row.unit), byDefault, rangeText(row), qt(row.help).replace(u'|', u'/'));
    }
    return page;
}

std::vector<ManualPage> manualPages() {
    std::vector<ManualPage> pages;
    const QDir folder(QStringLiteral(":/manual"));
    for (const QString& name : folder.entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name)) {
        QFile file(folder.filePath(name));
        if (file.open(QIODevice::ReadOnly)) {
            const QString text = QString::fromUtf8(file.readAll());
            pages.push_back({text.section(u'\n', 0, 0).remove(u'#').trimmed(), text});
        }
    }
    for (const QString& text : {parameterReference(), actionReference()}) {
        pages.push_back({text.section(u'\n', 0, 0).remove(u'#').trimmed(), text});
    }
    return pages;
}

ManualWindow::ManualWindow(QWidget* parent)
    : QDialog(parent), m_pages(manualPages()), m_titles(new QListWidget), m_text(new QTextBrowser) {
    setWindowTitle(tr("Rubble manual"));
    resize(960, 680);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    m_titles->setFixedWidth(200);
    m_titles->setFrameShape(QFrame::NoFrame);
    m_titles->setAccessibleName(tr("Pages"));
    for (const ManualPage& page : m_pages) {
        m_titles->addItem(page.title);
    }
    m_text->document()->setDocumentMargin(16);
    m_text->setOpenExternalLinks(false);
    row->addWidget(m_titles);
    row->addWidget(m_text, 1);
    connect(m_titles, &QListWidget::currentRowChanged, this, [this](int index) {
        if (index >= 0) {
            m_text->setMarkdown(m_pages[static_cast<std::size_t>(index)].text);
        }
    });
    m_titles->setCurrentRow(0);
}

void ManualWindow::showPage(const QString& title) {
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        if (m_pages[i].title.contains(title, Qt::CaseInsensitive)) {
            m_titles->setCurrentRow(static_cast<int>(i));
            return;
        }
    }
}

}  // namespace rubble
