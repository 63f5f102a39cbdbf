#include "hmi/designer/array_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>

namespace plc::hmi {

ArrayDialog::ArrayDialog(const ArrayLayout& layout, const QString& example, QWidget* parent)
    : QDialog(parent), m_count(new QSpinBox), m_columns(new QSpinBox), m_step(new QSpinBox), m_gapX(new QDoubleSpinBox),
      m_gapY(new QDoubleSpinBox) {
    setWindowTitle(tr("Duplicate as array"));
    m_count->setRange(2, 500);
    m_count->setValue(layout.count);
    m_columns->setRange(1, 500);
    m_columns->setValue(layout.columns);
    m_step->setRange(-100, 100);
    m_step->setValue(layout.indexStep);
    for (QDoubleSpinBox* gap : {m_gapX, m_gapY}) {
        gap->setRange(-2000, 2000);
        gap->setDecimals(0);
    }
    m_gapX->setValue(layout.gap.x());
    m_gapY->setValue(layout.gap.y());
    auto* form = new QFormLayout(this);
    form->addRow(tr("Number of elements"), m_count);
    form->addRow(tr("Columns"), m_columns);
    form->addRow(tr("Horizontal gap"), m_gapX);
    form->addRow(tr("Vertical gap"), m_gapY);
    form->addRow(tr("Index step"), m_step);
    auto* preview = new QLabel;
    const auto show = [this, preview, example] {
        if (example.isEmpty()) return preview->clear();
        preview->setText(QStringLiteral("%1 … %2").arg(
            example, withShiftedIndex(example, (m_count->value() - 1) * m_step->value())));
    };
    connect(m_count, &QSpinBox::valueChanged, this, show);
    connect(m_step, &QSpinBox::valueChanged, this, show);
    show();
    form->addRow(preview);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
}

ArrayLayout ArrayDialog::layoutChosen() const {
    return {m_count->value(), m_columns->value(), QPointF(m_gapX->value(), m_gapY->value()), m_step->value()};
}

} // namespace plc::hmi
