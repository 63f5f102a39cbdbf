#include "hmi/designer/array_arrangement_dialog.h"

#include "hmi/model/property_literals.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <cmath>

namespace plc::hmi {

namespace {

constexpr int kMostIndices = 10000;

QSpinBox* indexBox() {
    auto* box = new QSpinBox;
    box->setRange(-1000000, 1000000);
    return box;
}

QDoubleSpinBox* gapBox() {
    auto* box = new QDoubleSpinBox;
    box->setRange(-2000, 2000);
    box->setDecimals(0);
    box->setValue(8);
    return box;
}

/// As many as fit beside each other from where the element is.
int columnsThatFit(const Panel& panel, const Element& element) {
    const double room = panel.size().width() - element.rect().left() + 8, step = element.rect().width() + 8;
    return std::clamp(static_cast<int>(room / step), 1, 500);
}

} // namespace

ArrayArrangementDialog::ArrayArrangementDialog(const Panel& panel, const Element& element, const DesignContext& context,
                                               QWidget* parent)
    : QDialog(parent), m_context(context), m_panel(panel.size()), m_element(element.rect()), m_parameter(new QComboBox),
      m_array(new QComboBox), m_first(indexBox()), m_last(indexBox()), m_columns(new QSpinBox), m_gapX(gapBox()),
      m_gapY(gapBox()), m_complaint(new QLabel) {
    setWindowTitle(tr("Arrange over array"));
    if (const Panel* placed = context.project().panelLookup()(element.text("panel"_text)))
        for (Parameter& one : parametersOf(*placed))
            if (!one.isText()) m_parameters.push_back(std::move(one));
    for (const Parameter& one : m_parameters)
        m_parameter->addItem(one.type.isEmpty() ? u'$' + one.name : QStringLiteral("$%1 : %2").arg(one.name, one.type),
                             one.name);
    m_array->setEditable(true);
    m_array->setMinimumContentsLength(28);
    m_columns->setRange(1, 500);
    m_columns->setValue(columnsThatFit(panel, element));
    auto* form = new QFormLayout(this);
    form->addRow(tr("Parameter"), m_parameter);
    form->addRow(tr("Array"), m_array);
    form->addRow(tr("First index"), m_first);
    form->addRow(tr("Last index"), m_last);
    form->addRow(tr("Columns"), m_columns);
    form->addRow(tr("Horizontal gap"), m_gapX);
    form->addRow(tr("Vertical gap"), m_gapY);
    auto* note = new QLabel(tr("In the other arguments, # becomes the index."));
    note->setWordWrap(true);
    form->addRow(note);
    m_complaint->setWordWrap(true);
    form->addRow(m_complaint);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
    connect(m_parameter, &QComboBox::currentIndexChanged, this, &ArrayArrangementDialog::listArrays);
    connect(m_array, &QComboBox::currentTextChanged, this, &ArrayArrangementDialog::takeBounds);
    for (QSpinBox* box : {m_first, m_last, m_columns})
        connect(box, &QSpinBox::valueChanged, this, &ArrayArrangementDialog::showRoom);
    for (QDoubleSpinBox* box : {m_gapX, m_gapY})
        connect(box, &QDoubleSpinBox::valueChanged, this, &ArrayArrangementDialog::showRoom);
    listArrays();
}

void ArrayArrangementDialog::listArrays() {
    const QSignalBlocker quiet(m_array);
    m_array->clear();
    const int index = m_parameter->currentIndex();
    if (index >= 0) m_array->addItems(arraysOf(m_context.checked(), m_parameters[static_cast<size_t>(index)].type));
    takeBounds();
}

void ArrayArrangementDialog::takeBounds() {
    const auto bounds = boundsOf(m_context.checked(), m_array->currentText());
    const bool isGood = bounds && m_parameter->currentIndex() >= 0;
    m_ok->setEnabled(isGood);
    m_complaint->setText(isGood ? QString() : tr("Choose an array with one index, for example Plant.Valves."));
    if (!bounds) return;
    for (QSpinBox* box : {m_first, m_last}) box->setRange(bounds->first, bounds->second);
    m_first->setValue(bounds->first);
    m_last->setValue(std::min(bounds->second, bounds->first + kMostIndices - 1));
    showRoom();
}

void ArrayArrangementDialog::showRoom() {
    if (!m_ok->isEnabled()) return; // there is more to complain about
    const int count = std::abs(m_last->value() - m_first->value()) + 1, columns = std::min(count, m_columns->value()),
              rows = (count + columns - 1) / columns;
    const double right = m_element.left() + columns * (m_element.width() + m_gapX->value()) - m_gapX->value(),
                 bottom = m_element.top() + rows * (m_element.height() + m_gapY->value()) - m_gapY->value();
    const bool fits = right <= m_panel.width() && bottom <= m_panel.height();
    m_complaint->setText(fits ? QString()
                              : tr("They reach to %1 × %2, the panel only to %3 × %4: make the faceplate smaller or "
                                   "the panel larger.")
                                    .arg(std::ceil(right))
                                    .arg(std::ceil(bottom))
                                    .arg(m_panel.width())
                                    .arg(m_panel.height()));
}

ArrayArrangement ArrayArrangementDialog::arrangement() const {
    return {m_array->currentText().trimmed(),
            m_parameter->currentData().toString(),
            m_first->value(),
            m_last->value(),
            m_columns->value(),
            QPointF(m_gapX->value(), m_gapY->value())};
}

} // namespace plc::hmi
