// Asks how many copies of the selection are laid out and how: count, columns, gaps, step of the index.
#pragma once
#include "hmi/designer/context/arrange.h"

#include <QDialog>

class QDoubleSpinBox;
class QSpinBox;

namespace plc::hmi {

class ArrayDialog final : public QDialog {
    Q_OBJECT
public:
    /// `example`: a binding of the selection, to show what becomes of it.
    ArrayDialog(const ArrayLayout& layout, const QString& example, QWidget* parent);
    ArrayLayout layoutChosen() const;

private:
    QSpinBox *m_count, *m_columns, *m_step;
    QDoubleSpinBox *m_gapX, *m_gapY;
};

} // namespace plc::hmi
