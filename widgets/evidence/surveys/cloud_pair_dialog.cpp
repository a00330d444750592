#include "widgets/evidence/surveys/cloud_pair_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/basics/panel.h"
#include "widgets/evidence/surveys/distance_fields.h"

namespace rubble::widgets {

namespace {

QString takenText(const CloudPairDialog::Cloud& cloud) {
    return cloud.taken.empty() ? CloudPairDialog::tr("not known") : QString::fromStdString(cloud.taken);
}

}  // namespace

CloudPairDialog::CloudPairDialog(const std::vector<Cloud>& clouds, QWidget* parent)
    : QDialog(parent),
      m_clouds(clouds),
      m_first(new QComboBox),
      m_second(new QComboBox),
      m_distances(new DistanceFields({tr("not known"), tr("By which one cloud may be out of place against the other, m")}, this)),
      m_epochs(new QLabel),
      m_said(new QLabel),
      m_notice(new Notice),
      m_findings(new FindingList),
      m_measure(new QPushButton(tr("Measure distances"))),
      m_cancel(new QPushButton(tr("Cancel measuring"))),
      m_save(new QPushButton(tr("Save distances…"))) {
    setWindowTitle(tr("Compare two clouds"));
    auto* column = new QVBoxLayout(this);
    auto* words = new QLabel(tr(
        "Measures from the first cloud to the second along the local normal (M3C2), as their files have them: what the case says "
        "of their place does not move them. Lengths are brought to metres."));
    words->setWordWrap(true);
    words->setMinimumWidth(460);
    column->addWidget(words);
    auto* form = new QFormLayout;
    for (const bool second : {false, true}) {
        QComboBox* box = second ? m_second : m_first;
        auto* row = new QHBoxLayout;
        auto* file = new QPushButton(tr("File…"));
        file->setAutoDefault(false);
        file->setToolTip(tr("Take a cloud that is not in the case"));
        box->setAccessibleName(second ? tr("Second cloud") : tr("First cloud"));
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(24);
        row->addWidget(box, 1);
        row->addWidget(file);
        form->addRow(second ? tr("Later cloud") : tr("Earlier cloud"), row);
        connect(file, &QPushButton::clicked, this, [this, second] { emit fileRequested(second); });
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            if (!m_filling) {
                change();
            }
        });
    }
    m_epochs->setWordWrap(true);
    form->addRow(m_epochs);
    m_distances->addTo(*form);
    column->addLayout(form);
    connect(m_distances, &DistanceFields::edited, this, &CloudPairDialog::change);
    auto* row = new QHBoxLayout;
    row->addWidget(m_measure);
    row->addWidget(m_cancel);
    row->addWidget(m_save);
    row->addStretch(1);
    column->addLayout(row);
    m_said->setWordWrap(true);
    m_said->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_said);
    column->addWidget(m_notice);
    column->addWidget(m_findings);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    for (QPushButton* button : {m_measure, m_cancel, m_save, buttons->button(QDialogButtonBox::Close)}) {
        button->setAutoDefault(false);  // Enter in a field takes its number
    }
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    connect(m_measure, &QPushButton::clicked, this, &CloudPairDialog::measureRequested);
    connect(m_cancel, &QPushButton::clicked, this, &CloudPairDialog::cancelRequested);
    connect(m_save, &QPushButton::clicked, this, &CloudPairDialog::saveRequested);
    fill();
    m_first->setCurrentIndex(m_clouds.empty() ? -1 : 0);
    m_second->setCurrentIndex(m_clouds.size() > 1 ? 1 : -1);
    showState();
}

void CloudPairDialog::fill() {
    m_filling = true;
    for (QComboBox* box : {m_first, m_second}) {
        const int current = box->currentIndex();
        box->clear();
        for (const Cloud& cloud : m_clouds) {
            box->addItem(QFileInfo(QString::fromStdString(cloud.path)).fileName());
        }
        box->setCurrentIndex(current);
    }
    m_filling = false;
}

void CloudPairDialog::addCloud(const Cloud& cloud, bool second) {
    m_clouds.push_back(cloud);
    fill();
    (second ? m_second : m_first)->setCurrentIndex(static_cast<int>(m_clouds.size()) - 1);
}

std::optional<CloudPairDialog::Cloud> CloudPairDialog::first() const {
    const int at = m_first->currentIndex();
    return at >= 0 ? std::optional(m_clouds[static_cast<std::size_t>(at)]) : std::nullopt;
}

std::optional<CloudPairDialog::Cloud> CloudPairDialog::second() const {
    const int at = m_second->currentIndex();
    return at >= 0 ? std::optional(m_clouds[static_cast<std::size_t>(at)]) : std::nullopt;
}

CloudDistanceSettings CloudPairDialog::settings() const {
    return m_distances->settings();
}

double CloudPairDialog::cell() const {
    return m_distances->cell().value_or(0.0);
}

QString CloudPairDialog::epochs() const {
    const std::optional<Cloud> one = first();
    const std::optional<Cloud> other = second();
    if (!one || !other) {
        return tr("Choose two clouds.");
    }
    QString words = tr("Taken: %1, and %2.").arg(takenText(*one), takenText(*other));
    if (!one->taken.empty() && !other->taken.empty() && other->taken < one->taken) {
        words += u' ' + tr("The second is the older one: fill is what was there before.");
    }
    return words;
}

void CloudPairDialog::change() {
    m_content = {};
    showState();
    emit outdated();
}

void CloudPairDialog::setContent(const Content& content) {
    m_content = content;
    showState();
}

void CloudPairDialog::showState() {
    m_epochs->setText(epochs());
    const bool two = first() && second() && first()->path != second()->path;
    m_measure->setEnabled(two && !m_content.measuring);
    m_cancel->setVisible(m_content.measuring);
    m_save->setVisible(m_content.savable);
    m_said->setText(m_content.measuring ? tr("Distances are being measured.") : m_content.said);
    m_said->setVisible(!m_said->text().isEmpty());
    m_notice->set(Notice::Kind::Error, m_content.complaint);
    m_findings->set(m_content.findings);
}

}  // namespace rubble::widgets
