#include "widgets/evidence/movie_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "widgets/basics/form_row.h"
#include "widgets/basics/panel.h"
#include "widgets/figures/number_text.h"
#include "widgets/run/caution_words.h"

namespace rubble::widgets {

namespace {

/// A time in the units of the result.
QDoubleSpinBox* instantBox(const char* name, double low, double high, double value) {
    const figures::ShownUnit unit = figures::timeUnit();
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setDecimals(3);
    // What is shown lies within the span, not a thousandth beyond it.
    box->setRange(std::ceil(low * unit.perSi * 1000.0 - 1e-6) / 1000.0, std::floor(high * unit.perSi * 1000.0 + 1e-6) / 1000.0);
    box->setSingleStep(unit.perSi > 1.0 ? 1.0 : 0.1);
    box->setValue(value * unit.perSi);
    box->setSuffix(u' ' + unit.name);
    return box;
}

// At a pace that shows a blast, the seconds of settling after it would be millions of pictures.
double usualEnd(const figures::MovieSettings& all) {
    const double brief = figures::briefSpan();
    return brief > 0.0 ? std::min(all.to, all.from + brief) : all.to;
}

}  // namespace

MovieDialog::MovieDialog(const MovieChoice& choice, bool encoder, QWidget* parent)
    : QDialog(parent),
      m_from(instantBox("movieFrom", choice.settings.from, choice.settings.to, choice.settings.from)),
      m_to(instantBox("movieTo", choice.settings.from, choice.settings.to, usualEnd(choice.settings))),
      m_pace(new QComboBox),
      m_fps(new QSpinBox),
      m_size(new QComboBox),
      m_format(new QComboBox),
      m_along(new QCheckBox),
      m_cameras(choice.settings.cameras),
      m_length(new QLabel),
      m_cautions(new Notice),
      m_first(choice.settings.from),
      m_last(choice.settings.to) {
    setWindowTitle(tr("Movie"));
    setObjectName(QStringLiteral("movieDialog"));
    m_pace->setObjectName(QStringLiteral("moviePace"));
    if (const double perSi = figures::timeUnit().perSi; perSi > 1.0) {
        // A blast in real time is over with its first picture.
        for (const double perSecond : {10.0, 1.0, 100.0}) {
            m_pace->addItem(figures::paceText(perSecond / perSi), perSecond / perSi);
        }
    }
    m_pace->addItem(tr("Real time"), 1.0);
    m_pace->addItem(tr("Half as fast"), 0.5);
    m_pace->addItem(tr("A quarter as fast"), 0.25);
    m_pace->addItem(tr("A tenth as fast"), 0.1);
    m_pace->addItem(tr("Twice as fast"), 2.0);
    m_fps->setObjectName(QStringLiteral("movieFps"));
    m_fps->setRange(1, 120);
    m_fps->setValue(static_cast<int>(choice.settings.fps));
    m_size->setObjectName(QStringLiteral("movieSize"));
    for (const QSize size : {QSize(1280, 720), QSize(1920, 1080), QSize(3840, 2160), QSize(854, 480)}) {
        m_size->addItem(QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()), size);
    }
    m_size->setCurrentIndex(std::max(0, m_size->findData(choice.pixels)));
    m_format->setObjectName(QStringLiteral("movieFormat"));
    if (encoder) {
        m_format->addItem(tr("MP4"), true);
    }
    m_format->addItem(tr("Folder of pictures (PNG)"), false);
    auto* column = dialogColumn(*this);
    auto* form = dialogForm();
    addRow(*form, tr("From"), m_from, tr("Where the movie begins, on the clock of the FE result"));
    addRow(*form, tr("To"), m_to,
           tr("Where it ends, at the latest where the run ends; that may be after the FE result, or before its end"));
    addRow(*form, tr("Pace"), m_pace, tr("How fast the collapse runs in the movie; other paces than real time are printed on it"));
    addRow(*form, tr("Pictures per second"), m_fps, tr("1 to 120; 25 is usual"));
    addRow(*form, tr("Size"), m_size, tr("Width and height in pixels"));
    addRow(*form, tr("Format"), m_format,
           encoder ? tr("One file to play, or numbered pictures for other programs")
                   : tr("Numbered pictures; for an MP4 install the program ffmpeg"));
    column->addLayout(form);
    m_along->setObjectName(QStringLiteral("movieAlong"));
    m_along->setText(tr("Along the camera keys (%1)").arg(m_cameras.size()));
    m_along->setToolTip(tr("The camera moves from key to key; without it the movie looks as the views do"));
    m_along->setChecked(!m_cameras.empty());
    column->addWidget(m_along);
    m_along->setVisible(!m_cameras.empty());
    m_length->setObjectName(QStringLiteral("muted"));
    m_length->setWordWrap(true);
    column->addWidget(m_length);
    column->addWidget(m_cautions);
    setCautions({});
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    auto* save = buttons->addButton(tr("Save movie…"), QDialogButtonBox::AcceptRole);
    save->setObjectName(QStringLiteral("primary"));
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_from, &QDoubleSpinBox::valueChanged, this, &MovieDialog::showLength);
    connect(m_to, &QDoubleSpinBox::valueChanged, this, &MovieDialog::showLength);
    connect(m_pace, &QComboBox::currentIndexChanged, this, &MovieDialog::showLength);
    connect(m_fps, &QSpinBox::valueChanged, this, &MovieDialog::showLength);
    showLength();
}

void MovieDialog::setCautions(const QString& cautions) {
    showCautions(*m_cautions, cautions);
}

MovieChoice MovieDialog::choice() const {
    MovieChoice choice;
    const double perSi = figures::timeUnit().perSi;
    // At its ends exactly as far as there is something.
    const auto instant = [&](const QDoubleSpinBox& box) {
        const double time = box.value() <= box.minimum() ? m_first : box.value() >= box.maximum() ? m_last : box.value() / perSi;
        return std::clamp(time, m_first, m_last);
    };
    choice.settings = {instant(*m_from), instant(*m_to), static_cast<double>(m_fps->value()), m_pace->currentData().toDouble(),
                       m_along->isChecked() ? m_cameras : std::vector<CameraKey>()};
    choice.pixels = m_size->currentData().toSize();
    choice.encoded = m_format->currentData().toBool();
    return choice;
}

void MovieDialog::showLength() {
    auto* save = findChild<QPushButton*>(QStringLiteral("primary"));
    try {
        const MovieChoice now = choice();
        const std::size_t pictures = figures::movieLength(now.settings);
        m_length->setText(tr("%1 pictures, %2 s to watch; there is something to show up to %3")
                              .arg(QLocale().toString(static_cast<qulonglong>(pictures)),
                                   QLocale().toString(static_cast<double>(pictures) / now.settings.fps, 'f', 1),
                                   figures::timeText(m_last)));
        save->setEnabled(true);
    } catch (const Error&) {
        m_length->setText(tr("The end must come after the beginning, with at most 100,000 pictures between them."));
        save->setEnabled(false);
    }
}

}  // namespace rubble::widgets
