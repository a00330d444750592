#include "widgets/evidence/sealing/bundle_table.h"

#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

constexpr int widestName = 280;  // px

enum RowColumn { RowName, RowVerdict, RowMeaning };

/// A sign beside the word, for those who do not tell the colours apart.
QString signOf(BundleRow::Standing standing) {
    switch (standing) {
        case BundleRow::Standing::Good:
            return QStringLiteral("✓ ");
        case BundleRow::Standing::Doubtful:
            return QStringLiteral("? ");
        case BundleRow::Standing::Bad:
            return QStringLiteral("✗ ");
        case BundleRow::Standing::Nothing:
            break;
    }
    return {};
}

QColor colourOf(BundleRow::Standing standing) {
    switch (standing) {
        case BundleRow::Standing::Good:
            return tints().good;
        case BundleRow::Standing::Doubtful:
            return tints().finding;
        case BundleRow::Standing::Bad:
            return tints().error;
        case BundleRow::Standing::Nothing:
            break;
    }
    return tints().muted;
}

QTreeWidgetItem* rowItem(const BundleRow& row) {
    auto* item = new QTreeWidgetItem({row.name, signOf(row.standing) + row.verdict, row.meaning});
    item->setData(RowVerdict, Qt::UserRole, row.verdict);
    item->setForeground(RowVerdict, colourOf(row.standing));
    for (const int column : {RowName, RowMeaning}) {
        item->setToolTip(column, item->text(column));
    }
    item->setData(RowName, Qt::AccessibleTextRole, QStringLiteral("%1: %2. %3").arg(row.name, row.verdict, row.meaning));
    for (const BundleRow& part : row.parts) {
        item->addChild(rowItem(part));
    }
    return item;
}

void addLines(QString& text, const std::vector<BundleRow>& rows, int depth) {
    for (const BundleRow& row : rows) {
        text += QString(2 * depth, u' ') + row.name + QStringLiteral(": ") + row.verdict;
        text += row.meaning.isEmpty() ? QStringLiteral("\n") : QStringLiteral(" (") + row.meaning + QStringLiteral(")\n");
        addLines(text, row.parts, depth + 1);
    }
}

}  // namespace

BundleTable::BundleTable(const char* name, const QString& label, QWidget* parent)
    : QWidget(parent), m_list(new QTreeWidget), m_whole(new QLabel) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    m_list->setObjectName(QLatin1String(name));
    m_list->setAccessibleName(label);
    m_list->setHeaderLabels({label, tr("Verdict"), tr("What it means")});
    m_list->setSelectionMode(QAbstractItemView::SingleSelection);
    m_list->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setMinimumHeight(84);
    m_whole->setObjectName(QLatin1String(name) + QStringLiteral("Whole"));
    m_whole->setWordWrap(true);
    m_whole->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    column->addWidget(m_list, 1);
    column->addWidget(m_whole);
    setFocusProxy(m_list);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &BundleTable::tell);
    tell(nullptr);
}

void BundleTable::tell(const QTreeWidgetItem* item) {
    m_whole->setVisible(item != nullptr);
    m_whole->setText(item == nullptr
                         ? QString()
                         : QStringLiteral("%1: %2. %3")
                               .arg(item->text(RowName), item->data(RowVerdict, Qt::UserRole).toString(), item->text(RowMeaning)));
}

void BundleTable::setRows(const std::vector<BundleRow>& rows) {
    m_list->clear();
    QTreeWidgetItem* worst = nullptr;
    auto standing = BundleRow::Standing::Good;
    for (const BundleRow& row : rows) {
        QTreeWidgetItem* item = rowItem(row);
        m_list->addTopLevelItem(item);
        // The first that needs a reader's eye: bad before doubtful.
        if (worst == nullptr || (row.standing != BundleRow::Standing::Nothing && row.standing > standing)) {
            worst = item;
            standing = row.standing;
        }
    }
    m_list->expandAll();
    m_list->resizeColumnToContents(RowName);
    m_list->resizeColumnToContents(RowVerdict);
    m_list->setColumnWidth(RowName, std::min(m_list->columnWidth(RowName), widestName));
    m_list->setCurrentItem(worst);
}

QString bundleRowsText(const std::vector<BundleRow>& rows) {
    QString text;
    addLines(text, rows, 0);
    return text;
}

}  // namespace rubble::widgets
