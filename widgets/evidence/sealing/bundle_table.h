#pragma once

#include <QWidget>
#include <vector>

#include "widgets/evidence/sealing/bundle_content.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace rubble::widgets {

/// What was checked in a bundle, one row each with verdict and meaning; what it is about stands below it. The row that is chosen is
/// told in full, to be read whole and copied.
class BundleTable : public QWidget {
    Q_OBJECT

public:
    /// @param name  object name of the list @param label  what its rows are
    BundleTable(const char* name, const QString& label, QWidget* parent = nullptr);

    void setRows(const std::vector<BundleRow>& rows);

private:
    void tell(const QTreeWidgetItem* item);

    QTreeWidget* m_list;
    QLabel* m_whole;
};

/// The same as plain text, one line each.
QString bundleRowsText(const std::vector<BundleRow>& rows);

}  // namespace rubble::widgets
