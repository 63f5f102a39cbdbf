// Edits a list of records (conditions, states, columns, …) or named values: the rows on the left, the fields of the
// chosen row on the right. It changes nothing itself; `value()` is taken when it was accepted. Owned by its Qt parent.
#pragma once
#include "hmi/designer/sheet/property_mapping.h"

#include <QDialog>

class QListWidget;

namespace plc::hmi {

class RecordsDialog final : public QDialog {
    Q_OBJECT
public:
    /// `storeText` gives a typed text its key (see DesignContext::storeText).
    using StoreText = std::function<QString(const QString& present, const QString& typed)>;
    RecordsDialog(const PropertyDescriptor& property, const Json& value, const DesignContext& context,
                  StoreText storeText, QWidget* parent);

    Json value() const;
    int rowCount() const { return static_cast<int>(m_rows.size()); }
    void addRow();
    void removeRow();
    void moveRow(int by);
    void selectRow(int row);
    kit::PropertyGrid& grid() { return *m_grid; }

private:
    void showRow();
    void refreshTitles();
    QString titleOfRow(size_t row) const;
    std::vector<PropertyDescriptor> fields() const;
    const PropertyDescriptor m_property;
    const DesignContext& m_context;
    StoreText m_storeText;
    std::vector<Json> m_rows; // of named values: {"name", "expression"}
    QListWidget* m_list;
    kit::PropertyGrid* m_grid;
    int m_shown = -1; // row in the grid
};

} // namespace plc::hmi
