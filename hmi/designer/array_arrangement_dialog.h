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
    QLabel& complaint() { return *m_complaint; }

private:
    void listArrays();
    void takeBounds();
    /// Says so when what is arranged will not fit on the panel.
    void showRoom();
    const DesignContext& m_context;
    const QSizeF m_panel;
    const QRectF m_element;
    std::vector<Parameter> m_parameters;
    QComboBox *m_parameter, *m_array;
    QSpinBox *m_first, *m_last, *m_columns;
    QDoubleSpinBox *m_gapX, *m_gapY;
    QLabel* m_complaint;
    QPushButton* m_ok;
};

} // namespace plc::hmi
