#include "widgets/evidence/surveys/reading_box.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/basics/panel.h"

namespace rubble::widgets {

ReadingBox::ReadingBox(QWidget* parent)
    : QWidget(parent), m_system(new QLineEdit), m_columns(new QLineEdit), m_complaint(new Notice) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    m_system->setAccessibleName(tr("Coordinate system of the cloud"));
    m_system->setPlaceholderText(tr("as the file says"));
    m_system->setToolTip(tr("EPSG code such as EPSG:25832, WKT or PROJ, of a file that names no system. Kept in the case"));
    form->addRow(tr("System"), m_system);
    m_columns->setAccessibleName(tr("Columns of the table"));
    m_columns->setPlaceholderText(tr("as its heading says"));
    m_columns->setToolTip(
        tr("Columns of a table in their order, parted by commas: x, y, z, intensity, red, green, blue, class, return, returns, "
           "time; skip for others. Kept in the case"));
    form->addRow(tr("Columns"), m_columns);
    form->addRow(m_complaint);
    for (QLineEdit* field : {m_system, m_columns}) {
        connect(field, &QLineEdit::editingFinished, this, &ReadingBox::take);
    }
}

void ReadingBox::setRequest(const CloudRequest& request) {
    m_request = request;
    QStringList columns;
    for (const std::string& column : request.columns) {
        columns << QString::fromStdString(column);
    }
    m_system->setText(QString::fromStdString(request.crs));
    m_columns->setText(columns.join(QLatin1Char(',')));
}

CloudRequest ReadingBox::request() const {
    CloudRequest said;
    said.crs = m_system->text().trimmed().toStdString();
    for (const QString& column : m_columns->text().split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        said.columns.push_back(column.trimmed().toStdString());
    }
    return said;
}

void ReadingBox::setComplaint(const QString& complaint) {
    m_complaint->set(Notice::Kind::Error, complaint);
}

void ReadingBox::take() {
    if (const CloudRequest said = request(); !(said == m_request)) {
        m_request = said;
        emit edited(said);
    }
}

ReadingDialog::ReadingDialog(const QString& name, const QStringList& open, const CloudRequest& request, QWidget* parent)
    : QDialog(parent), m_box(new ReadingBox) {
    setWindowTitle(tr("How %1 is read").arg(name));
    auto* column = new QVBoxLayout(this);
    auto* words = new QLabel(open.join(QLatin1Char(' ')));
    words->setWordWrap(true);
    words->setMinimumWidth(420);
    column->addWidget(words);
    column->addWidget(m_box);
    m_box->setRequest(request);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Add survey"));
    connect(buttons, &QDialogButtonBox::accepted, this, &ReadingDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
}

void ReadingDialog::accept() {
    const QString complaint = m_trial != nullptr ? m_trial(m_box->request()) : QString();
    m_box->setComplaint(complaint);
    if (complaint.isEmpty()) {
        QDialog::accept();
    }
}

}  // namespace rubble::widgets
