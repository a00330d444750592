#include "widgets/evidence/sealing/bundle_pages.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/form_row.h"
#include "widgets/evidence/sealing/bundle_table.h"
#include "widgets/evidence/sealing/file_field.h"

namespace rubble::widgets {

namespace {

constexpr int numberRole = Qt::UserRole;

QVBoxLayout* columnOf(QWidget& page) {
    auto* column = new QVBoxLayout(&page);
    column->setContentsMargins(12, 12, 12, 12);
    column->setSpacing(8);
    return column;
}

QLabel* explanation(const QString& text) {
    auto* label = new QLabel(text);
    label->setObjectName(QStringLiteral("muted"));
    label->setWordWrap(true);
    return label;
}

QPushButton* button(const char* name, const QString& text) {
    auto* made = new QPushButton(text);
    made->setObjectName(QLatin1String(name));
    made->setAutoDefault(false);
    return made;
}

void addButtons(QVBoxLayout& column, std::initializer_list<QPushButton*> buttons) {
    auto* row = new QHBoxLayout;
    for (QPushButton* each : buttons) {
        row->addWidget(each);
    }
    row->addStretch();
    column.addLayout(row);
}

QTreeWidget* list(const char* name, const QString& label, const QStringList& heads) {
    auto* tree = new QTreeWidget;
    tree->setObjectName(QLatin1String(name));
    tree->setAccessibleName(label);
    tree->setHeaderLabels(heads);
    tree->setSelectionMode(QAbstractItemView::SingleSelection);
    tree->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    tree->setMinimumHeight(84);
    // It takes what is left: by its own wish what is below it would have to be scrolled to.
    tree->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    return tree;
}

void fitColumns(QTreeWidget& tree) {
    tree.expandAll();
    for (int i = 0; i < tree.columnCount(); ++i) {
        tree.resizeColumnToContents(i);
        tree.setColumnWidth(i, std::min(tree.columnWidth(i), 360));
    }
}

QTreeWidgetItem* cellsItem(const QStringList& cells) {
    auto* item = new QTreeWidgetItem(cells);
    for (int i = 0; i < cells.size(); ++i) {
        item->setToolTip(i, cells[i]);
    }
    return item;
}

}  // namespace

BundleRunsPage::BundleRunsPage(QWidget* parent)
    : QWidget(parent),
      m_about(explanation({})),
      m_runs(new BundleTable("bundleRuns", tr("Run"))),
      m_absentAbout(explanation(tr("These inputs did not travel. Say where they lie; each must have the digest that was sealed."))),
      m_absent(
          list("bundleAbsent", tr("Inputs that did not travel"), {tr("Input"), tr("Was called"), tr("Lies here"), tr("SHA-256")})),
      m_run(button("bundleRun", tr("Run again"))),
      m_locate(button("bundleLocate", tr("Point at the file…"))) {
    auto* column = columnOf(*this);
    column->addWidget(m_about);
    column->addWidget(m_runs, 2);
    addButtons(*column, {m_run});
    column->addWidget(m_absentAbout);
    column->addWidget(m_absent, 1);
    addButtons(*column, {m_locate});
    connect(m_run, &QPushButton::clicked, this, &BundleRunsPage::runRequested);
    connect(m_locate, &QPushButton::clicked, this, &BundleRunsPage::locate);
    connect(m_absent, &QTreeWidget::currentItemChanged, this,
            [this](QTreeWidgetItem* item) { m_locate->setEnabled(item != nullptr); });
}

void BundleRunsPage::setContent(const BundleContent& content) {
    m_about->setText(content.altered ? tr("The bundle is not as it was sealed: nothing of it is simulated.")
                                     : tr("Each run is simulated again with the sealed settings and compared bit by bit. Only the "
                                          "same build repeats a run so."));
    m_runs->setRows(content.runs);
    m_run->setEnabled(content.read && !content.altered);
    m_absent->clear();
    for (const AbsentInput& input : content.absent) {
        m_absent->addTopLevelItem(cellsItem({input.id, input.path, input.located, input.digest}));
    }
    fitColumns(*m_absent);
    const bool some = !content.absent.empty();
    for (QWidget* each : std::initializer_list<QWidget*>{m_absentAbout, m_absent, m_locate}) {
        each->setVisible(some);
    }
    m_absent->setCurrentItem(m_absent->topLevelItem(0));
    m_locate->setEnabled(some);
}

void BundleRunsPage::locate() {
    const QString id = m_absent->currentItem()->text(0);
    const QString path = QFileDialog::getOpenFileName(this, tr("Where is the input %1?").arg(id), {}, tr("All files (*)"));
    if (!path.isEmpty()) {
        emit locateRequested(id, path);
    }
}

BundleTrustPage::BundleTrustPage(QWidget* parent)
    : QWidget(parent),
      m_signer(new FileField("trustSigner", tr("Signer"))),
      m_roots(new FileField("trustRoots", tr("Roots for signers"))),
      m_stampRoots(new FileField("trustStampRoots", tr("Roots for the time stamp"))),
      m_digest(new QLineEdit) {
    auto* column = columnOf(*this);
    column->addWidget(
        explanation(tr("What is in a bundle can prove only what you compare with something that you got another way. All "
                       "files are PEM; nothing is looked up in a network.")));
    auto* form = dialogForm();
    addRow(*form, tr("Signer"), m_signer, tr("Public key or certificate that must have signed, or the SHA-256 of that key"));
    addRow(*form, tr("Roots for signers"), m_roots, tr("Certificates that vouch for that of the signer"));
    addRow(*form, tr("Roots for the time stamp"), m_stampRoots, tr("Certificates that vouch for the time-stamping service"));
    m_digest->setObjectName(QStringLiteral("trustDigest"));
    addRow(*form, tr("Known digest"), m_digest, tr("SHA-256 of the statement or of an entry that the bundle must hold"));
    column->addLayout(form);
    auto* check = button("bundleCheck", tr("Check again"));
    addButtons(*column, {check});
    column->addStretch();
    connect(check, &QPushButton::clicked, this, &BundleTrustPage::checkRequested);
}

void BundleTrustPage::setTrust(const BundleTrust& trust) {
    m_signer->setPath(trust.signer);
    m_roots->setPath(trust.roots);
    m_stampRoots->setPath(trust.stampRoots);
    m_digest->setText(trust.digest);
}

BundleTrust BundleTrustPage::trust() const {
    return {m_signer->path(), m_roots->path(), m_stampRoots->path(), m_digest->text().trimmed()};
}

BundleCustodyPage::BundleCustodyPage(QWidget* parent)
    : QWidget(parent),
      m_list(list("bundleCustody", tr("Chain of custody"),
                  {tr("No."), tr("When"), tr("Received by"), tr("From"), tr("Where"), tr("Why"), tr("Signed"),
                   tr("SHA-256 of the bundle then"), tr("SHA-256 of the entry")})),
      m_from(new QLineEdit),
      m_where(new QLineEdit),
      m_why(new QLineEdit),
      m_add(button("custodyAdd", tr("Add the entry"))) {
    m_from->setObjectName(QStringLiteral("custodyFrom"));
    m_where->setObjectName(QStringLiteral("custodyWhere"));
    m_why->setObjectName(QStringLiteral("custodyWhy"));
    auto* column = columnOf(*this);
    column->addWidget(m_list, 1);
    column->addWidget(
        explanation(tr("An entry holds the SHA-256 of the bundle as it was received and that of the entry before. Note "
                       "the SHA-256 of yours: it shows later that it was not left out.")));
    auto* form = dialogForm();
    m_signer = new SignerForm(*form, QStringLiteral("custody"), tr("Received by"), tr("Who received the bundle, now"), this);
    addRow(*form, tr("From"), m_from, tr("Who handed it over"));
    addRow(*form, tr("Where"), m_where, tr("Where, and on what medium"));
    addRow(*form, tr("Why"), m_why, tr("For what purpose, on whose authority"));
    column->addLayout(form);
    addButtons(*column, {m_add});
    connect(m_signer, &SignerForm::changed, this, &BundleCustodyPage::showReady);
    connect(m_from, &QLineEdit::textChanged, this, &BundleCustodyPage::showReady);
    connect(m_add, &QPushButton::clicked, this, [this] {
        emit addRequested({m_from->text().trimmed(), m_where->text().trimmed(), m_why->text().trimmed(), m_signer->choice()});
    });
}

void BundleCustodyPage::setContent(const BundleContent& content) {
    m_list->clear();
    for (const BundleRecord& record : content.records) {
        if (!record.isAddendum) {
            m_list->addTopLevelItem(
                cellsItem({QString::number(record.number), record.when, record.by, record.from, record.where, record.note,
                           record.isSigned ? tr("yes") : tr("no"), record.bundleDigest, record.digest}));
        }
    }
    fitColumns(*m_list);
    m_sound = content.read && !content.altered;
    m_signer->forgetPassphrase();
    showReady();
}

void BundleCustodyPage::showReady() {
    m_add->setEnabled(m_sound && !m_signer->choice().by.isEmpty() && !m_from->text().trimmed().isEmpty());
    m_add->setToolTip(m_add->isEnabled() ? QString() : tr("Say who received a sound bundle, and from whom."));
}

BundleAddendaPage::BundleAddendaPage(QWidget* parent)
    : QWidget(parent),
      m_list(list("bundleAddenda", tr("Addenda"), {tr("Addenda"), tr("When"), tr("SHA-256 of the entry")})),
      m_open(button("addendumOpen", tr("Open its case…"))),
      m_case(explanation({})),
      m_differences(list("addendumDifferences", tr("Differences of the open case"), {tr("What the open case assumes otherwise")})),
      m_compare(button("addendumCompare", tr("List the differences"))),
      m_note(new QLineEdit),
      m_add(button("addendumAdd", tr("Sign and add"))) {
    m_note->setObjectName(QStringLiteral("addendumNote"));
    auto* column = columnOf(*this);
    column->addWidget(m_list, 1);
    addButtons(*column, {m_open});
    column->addWidget(m_case);
    column->addWidget(m_differences, 1);
    addButtons(*column, {m_compare});
    auto* form = dialogForm();
    m_signer = new SignerForm(*form, QStringLiteral("addendum"), tr("Made by"), tr("Who assumes otherwise"), this);
    addRow(*form, tr("Note"), m_note, tr("Why it is assumed otherwise"));
    column->addLayout(form);
    addButtons(*column, {m_add});
    connect(m_list, &QTreeWidget::currentItemChanged, this,
            [this](QTreeWidgetItem* item) { m_open->setEnabled(m_sound && item != nullptr); });
    connect(m_open, &QPushButton::clicked, this, [this] {
        QTreeWidgetItem* item = m_list->currentItem();
        item = item->parent() != nullptr ? item->parent() : item;
        emit openRequested(item->data(0, numberRole).toInt());
    });
    connect(m_compare, &QPushButton::clicked, this, &BundleAddendaPage::compareRequested);
    connect(m_signer, &SignerForm::changed, this, &BundleAddendaPage::showReady);
    connect(m_add, &QPushButton::clicked, this, [this] { emit addRequested(m_signer->choice(), m_note->text().trimmed()); });
}

void BundleAddendaPage::setContent(const BundleContent& content) {
    m_list->clear();
    for (const BundleRecord& record : content.records) {
        if (record.isAddendum) {
            const QString title = record.note.isEmpty() ? tr("%1. %2").arg(record.number).arg(record.by)
                                                        : tr("%1. %2: %3").arg(record.number).arg(record.by, record.note);
            QTreeWidgetItem* item = cellsItem({title, record.when, record.digest});
            item->setData(0, numberRole, record.number);
            for (const QString& difference : record.differences) {
                item->addChild(cellsItem({difference}));
            }
            m_list->addTopLevelItem(item);
        }
    }
    fitColumns(*m_list);
    m_sound = content.read && !content.altered;
    m_list->setCurrentItem(m_list->topLevelItem(0));
    m_open->setEnabled(m_sound && m_list->topLevelItemCount() > 0);
    m_case->setText(
        content.ownCase.isEmpty()
            ? tr("To make an addendum, open the case of the bundle, change what you assume otherwise, and save it under "
                 "another name.")
            : tr("An addendum can be made of the case that is open: %1").arg(content.ownCase));
    m_compare->setEnabled(m_sound && !content.ownCase.isEmpty());
    m_signer->forgetPassphrase();
    m_differences->clear();
    m_compared = false;
    showReady();
}

void BundleAddendaPage::setDifferences(const QStringList& differences, const QStringList& runs) {
    m_differences->clear();
    for (const QString& difference : differences) {
        m_differences->addTopLevelItem(cellsItem({difference}));
    }
    for (const QString& run : runs) {
        m_differences->addTopLevelItem(cellsItem({tr("goes along: the run %1").arg(run)}));
    }
    if (differences.isEmpty()) {
        m_differences->insertTopLevelItem(0, cellsItem({tr("nothing: the open case says the same as the sealed one")}));
    }
    fitColumns(*m_differences);
    m_compared = !differences.isEmpty() || !runs.isEmpty();
    showReady();
}

void BundleAddendaPage::showReady() {
    const SignerChoice signer = m_signer->choice();
    m_add->setEnabled(m_sound && m_compared && !signer.key.isEmpty() && !signer.by.isEmpty());
    m_add->setToolTip(m_add->isEnabled() ? QString() : tr("List the differences first, and say who signs with which key."));
}

BundleStampPage::BundleStampPage(QWidget* parent)
    : QWidget(parent),
      m_state(new QLabel),
      m_request(button("stampRequest", tr("Write the request…"))),
      m_answer(button("stampAnswer", tr("Put the answer in…"))) {
    m_state->setObjectName(QStringLiteral("stampState"));
    m_state->setWordWrap(true);
    auto* column = columnOf(*this);
    column->addWidget(m_state);
    column->addWidget(
        explanation(tr("1. Write the request (*.tsq).\n2. Send it to a time-stamping service (RFC 3161) by the program that "
                       "the service names; Rubble uses no network.\n3. Put its answer (*.tsr) in. It must be of this "
                       "bundle. With the roots of the service under Trust it is verified offline.")));
    addButtons(*column, {m_request, m_answer});
    column->addStretch();
    connect(m_request, &QPushButton::clicked, this, [this] {
        const QFileInfo bundle(m_bundle);
        const QString path = QFileDialog::getSaveFileName(
            this, tr("Request for a time stamp"), bundle.absolutePath() + u'/' + bundle.completeBaseName() + QStringLiteral(".tsq"),
            tr("Requests (*.tsq)"));
        if (!path.isEmpty()) {
            emit requestRequested(path);
        }
    });
    connect(m_answer, &QPushButton::clicked, this, [this] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Answer of the service"), QFileInfo(m_bundle).absolutePath(),
                                                          tr("Answers (*.tsr);;All files (*)"));
        if (!path.isEmpty()) {
            emit answerRequested(path);
        }
    });
}

void BundleStampPage::setContent(const BundleContent& content) {
    m_bundle = content.file;
    m_state->setText(content.stampSaid);
    m_request->setEnabled(content.read && !content.stampThere);
    m_answer->setEnabled(content.read && !content.altered && !content.stampThere);
}

}  // namespace rubble::widgets
