// Asks over which array a faceplate is arranged: the parameter, the array, its indices, columns and gaps. Main thread.
#pragma once
#include "hmi/designer/context/arrange.h"
#include "hmi/designer/context/design_context.h"

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace plc::hmi {

class ArrayArrangementDialog final : public QDialog {
    Q_OBJECT
public:
    /// `element`: the faceplate that is arranged, with what its panel is; `panel` the one that it is in.
    ArrayArrangementDialog(const Panel& panel, const Element& element, const DesignContext& context,
                           QWidget* parent = nullptr);
    ArrayArrangement arrangement() const;
    QComboBox& parameter() { return *m_parameter; }
    QComboBox& array() { return *m_array; }
    QSpinBox& columns() { return *m_columns; }

private:
    void listArrays();
    void takeBounds();
    const DesignContext& m_context;
    std::vector<Parameter> m_parameters;
    QComboBox *m_parameter, *m_array;
    QSpinBox *m_first, *m_last, *m_columns;
    QDoubleSpinBox *m_gapX, *m_gapY;
    QLabel* m_complaint;
    QPushButton* m_ok;
};

} // namespace plc::hmi
