#include "widgets/evidence/sealing/seal_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/form_row.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr int partRole = Qt::UserRole;
constexpr int rowHeight = 24;  // px, that a tick has room

enum PartColumn { PartName, PartSize, PartRemark };

QString kindText(SealPart::Kind kind) {
    switch (kind) {
        case SealPart::Kind::Input:
            return SealDialog::tr("Inputs");
        case SealPart::Kind::Run:
            return SealDialog::tr("Runs");
        case SealPart::Kind::Export:
            return SealDialog::tr("Exports");
        case SealPart::Kind::Report:
            return SealDialog::tr("Reports");
        case SealPart::Kind::Page:
            break;
    }
    return SealDialog::tr("Pages");
}

QString sizeText(qint64 bytes) {
    return QLocale().formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat);
}

QString nameOf(const SealPart& part) {
    const QString file = QFileInfo(part.run.isEmpty() ? part.path : part.run).fileName();
    const QString name = part.id.isEmpty() ? file : QStringLiteral("%1 (%2)").arg(file, part.id);
    if (part.run.isEmpty()) {
        return name;
    }
    return part.kind == SealPart::Kind::Report ? SealDialog::tr("Make a report of %1").arg(name)
                                               : SealDialog::tr("Make a page of %1").arg(name);
}

/// Where it lies, or how it is made.
QString tipOf(const SealPart& part) {
    if (part.run.isEmpty()) {
        return part.path;
    }
    return part.kind == SealPart::Kind::Report
               ? SealDialog::tr(
                     "Made before the bundle is written, as Export > Report… makes it of what its panel asks for. It "
                     "simulates the repeats that are set there.")
               : SealDialog::tr("Made before the bundle is written, as Export > Share as a page… makes it.");
}

}  // namespace

SealDialog::SealDialog(const SealChoice& choice, QWidget* parent)
    : QDialog(parent),
      m_tree(new QTreeWidget),
      m_sum(new QLabel),
      m_note(new QLineEdit(choice.note)),
      m_stamp(new QCheckBox(tr("Write a request for a time stamp"))),
      m_notice(new Notice) {
    setWindowTitle(tr("Seal the case"));
    setObjectName(QStringLiteral("sealDialog"));
    auto* column = dialogColumn(*this);
    column->addWidget(buildParts(), 1);
    buildSigner(*column, choice);
    column->addWidget(m_notice);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_seal = buttons->addButton(tr("Seal…"), QDialogButtonBox::AcceptRole);
    m_seal->setObjectName(QStringLiteral("sealAccept"));
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &SealDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (const SealPart& part : choice.parts) {
        addPart(part);
    }
    connect(m_tree, &QTreeWidget::itemChanged, this, &SealDialog::showChosen);
    resize(720, 640);
    showChosen();
    showReady();
}

QWidget* SealDialog::buildParts() {
    auto* parts = new QWidget;
    auto* column = new QVBoxLayout(parts);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    auto* about =
        new QLabel(tr("The case is sealed with its journal. What is ticked goes along; an input that is not ticked stays "
                      "here, and only its digest is sealed. A run that lacks a report or a page can have it made."));
    about->setObjectName(QStringLiteral("muted"));
    about->setWordWrap(true);
    column->addWidget(about);
    m_tree->setObjectName(QStringLiteral("sealParts"));
    m_tree->setAccessibleName(tr("What is sealed"));
    m_tree->setHeaderLabels({tr("What is sealed"), tr("Size"), tr("Remark")});
    m_tree->setSelectionMode(QAbstractItemView::SingleSelection);
    m_tree->setMinimumHeight(140);
    m_tree->header()->setStretchLastSection(true);
    m_tree->header()->setSectionResizeMode(PartName, QHeaderView::ResizeToContents);
    m_tree->header()->setSectionResizeMode(PartSize, QHeaderView::ResizeToContents);
    column->addWidget(m_tree, 1);
    auto* row = new QHBoxLayout;
    m_sum->setObjectName(QStringLiteral("sealSum"));
    m_sum->setWordWrap(true);
    row->addWidget(m_sum, 1);
    auto* files = new QPushButton(tr("Add files…"));
    files->setObjectName(QStringLiteral("sealAddFiles"));
    files->setToolTip(tr("Runs, exports and pages that lie elsewhere, with their provenance"));
    auto* folder = new QPushButton(tr("Add a report…"));
    folder->setObjectName(QStringLiteral("sealAddFolder"));
    folder->setToolTip(tr("The folder of a report, with all in it"));
    for (QPushButton* button : {files, folder}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    column->addLayout(row);
    connect(files, &QPushButton::clicked, this, &SealDialog::addFiles);
    connect(folder, &QPushButton::clicked, this, &SealDialog::addFolder);
    return parts;
}

void SealDialog::buildSigner(QVBoxLayout& column, const SealChoice& choice) {
    auto* form = dialogForm();
    m_signer = new SignerForm(*form, QStringLiteral("seal"), tr("Sealed by"), tr("Who seals the case"), this);
    m_signer->setChoice(choice.signer);
    m_note->setObjectName(QStringLiteral("sealNote"));
    addRow(*form, tr("Note"), m_note, tr("Why, or what is to be known of it"));
    column.addLayout(form);
    m_stamp->setObjectName(QStringLiteral("sealStamp"));
    m_stamp->setChecked(choice.stampRequest);
    m_stamp->setToolTip(tr("Without a time stamp the time of sealing is the signer's word."));
    column.addWidget(m_stamp);
    auto* about =
        new QLabel(tr("A file *.tsq is written beside the bundle. Send it to a time-stamping service (RFC 3161) and put its "
                      "answer in with Open sealed…, Time stamp. Nothing is sent by Rubble."));
    about->setObjectName(QStringLiteral("muted"));
    about->setWordWrap(true);
    column.addWidget(about);
    about->setVisible(choice.stampRequest);
    connect(m_stamp, &QCheckBox::toggled, about, &QWidget::setVisible);
    connect(m_signer, &SignerForm::changed, this, &SealDialog::showReady);
}

QTreeWidgetItem* SealDialog::groupOf(SealPart::Kind kind) {
    const int order = static_cast<int>(kind);
    int place = 0;
    for (; place < m_tree->topLevelItemCount(); ++place) {
        QTreeWidgetItem* group = m_tree->topLevelItem(place);
        const int other = group->data(PartName, partRole).toInt();
        if (other == order) {
            return group;
        }
        if (other > order) {
            break;
        }
    }
    auto* group = new QTreeWidgetItem({kindText(kind)});
    group->setData(PartName, partRole, order);
    group->setSizeHint(PartRemark, QSize(0, rowHeight));
    group->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    m_tree->insertTopLevelItem(place, group);
    group->setExpanded(true);
    return group;
}

void SealDialog::addPart(const SealPart& part) {
    const auto known = [&](const SealPart& each) {
        return each.path == part.path && each.kind == part.kind && each.run == part.run;
    };
    if (std::any_of(m_parts.begin(), m_parts.end(), known)) {
        return;
    }
    auto* item = new QTreeWidgetItem({nameOf(part), part.run.isEmpty() ? sizeText(part.bytes) : QString()});
    item->setData(PartName, partRole, static_cast<int>(m_parts.size()));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(PartName, part.chosen ? Qt::Checked : Qt::Unchecked);
    // In the column that takes what is left: in the others it would be their width.
    item->setSizeHint(PartRemark, QSize(0, rowHeight));
    item->setTextAlignment(PartSize, Qt::AlignRight | Qt::AlignVCenter);
    item->setToolTip(PartName, tipOf(part));
    m_parts.push_back(part);
    groupOf(part.kind)->addChild(item);
}

void SealDialog::addFiles() {
    const QStringList paths = QFileDialog::getOpenFileNames(this, tr("Seal these as well"), {}, tr("All files (*)"));
    for (const QString& path : paths) {
        for (const SealPart& part : m_part(path)) {
            addPart(part);
        }
    }
    showChosen();
}

void SealDialog::addFolder() {
    const QString path = QFileDialog::getExistingDirectory(this, tr("Folder of a report"));
    if (!path.isEmpty()) {
        for (const SealPart& part : m_part(path)) {
            addPart(part);
        }
        showChosen();
    }
}

void SealDialog::showChosen() {
    const QSignalBlocker quiet(m_tree);
    qint64 bytes = 0;
    bool made = false;
    const SealPart* largest = nullptr;
    for (int g = 0; g < m_tree->topLevelItemCount(); ++g) {
        QTreeWidgetItem* group = m_tree->topLevelItem(g);
        for (int i = 0; i < group->childCount(); ++i) {
            QTreeWidgetItem* item = group->child(i);
            SealPart& part = m_parts[item->data(PartName, partRole).toUInt()];
            const bool stays = runStays(part);
            part.chosen = item->checkState(PartName) == Qt::Checked && !stays;
            const Qt::ItemFlags usual = Qt::ItemIsSelectable | Qt::ItemIsUserCheckable;
            item->setFlags(stays ? usual : usual | Qt::ItemIsEnabled);
            item->setText(PartRemark, remarkOf(part, stays));
            item->setToolTip(PartRemark, item->text(PartRemark));
            if (part.chosen && !part.run.isEmpty()) {
                made = true;
            } else if (part.chosen) {
                bytes += part.bytes;
                largest = largest == nullptr || part.bytes > largest->bytes ? &part : largest;
            }
        }
    }
    const QString size = sizeText(bytes);
    m_sum->setText((largest == nullptr ? tr("The case alone is sealed.")
                                       : tr("About %1 are sealed; the largest is %2.").arg(size, nameOf(*largest))) +
                   (made ? u' ' + tr("What is made comes on top.") : QString()));
}

bool SealDialog::runStays(const SealPart& part) const {
    return !part.run.isEmpty() && std::none_of(m_parts.begin(), m_parts.end(), [&](const SealPart& each) {
        return each.kind == SealPart::Kind::Run && each.path == part.run && each.chosen;
    });
}

QString SealDialog::remarkOf(const SealPart& part, bool stays) const {
    QString consequence;
    if (stays) {
        consequence = tr("its run is not sealed");
    } else if (part.kind == SealPart::Kind::Input && !part.chosen) {
        consequence = tr("only its digest is sealed");
    }
    return part.remark.isEmpty() || consequence.isEmpty() ? part.remark + consequence : inOneLine({part.remark, consequence});
}

void SealDialog::showReady() {
    m_notice->set(Notice::Kind::Error, {});
    m_seal->setEnabled(!m_signer->choice().key.isEmpty());
}

SealChoice SealDialog::choice() const {
    return {m_signer->choice(), m_note->text().trimmed(), m_stamp->isChecked(), m_parts};
}

void SealDialog::accept() {
    const SealObjection objection = m_objection ? m_objection(choice()) : SealObjection();
    if (objection.what.isEmpty()) {
        QDialog::accept();
    } else {
        m_notice->set(Notice::Kind::Error, objection.what, objection.remedy);
    }
}

}  // namespace rubble::widgets
