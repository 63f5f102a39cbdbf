#include "hmi/designer/sheet/records_dialog.h"

#include "editor/kit/icons.h"

#include <QColorDialog>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QListWidget>
#include <QSplitter>
#include <QToolBar>
#include <QVBoxLayout>

namespace plc::hmi {

RecordsDialog::RecordsDialog(const PropertyDescriptor& property, const Json& value, const DesignContext& context,
                             StoreText storeText, QWidget* parent)
    : QDialog(parent), m_property(property), m_context(context), m_storeText(std::move(storeText)),
      m_list(new QListWidget), m_grid(new kit::PropertyGrid) {
    setWindowTitle(QCoreApplication::translate("Hmi", property.title));
    m_list->setAccessibleName(windowTitle());
    resize(760, 460);
    if (property.type == PropertyType::Bindings && value.is_object()) {
        for (const auto& [name, expression] : value.items())
            m_rows.push_back(Json{{"name", name}, {"expression", expression}});
    } else if (value.is_array()) {
        for (const Json& row : value) m_rows.push_back(row.is_object() ? row : Json::object());
    }
    auto* tools = new QToolBar;
    tools->addAction(kit::icon(kit::Icon::Add), tr("Add"), this, &RecordsDialog::addRow);
    tools->addAction(kit::icon(kit::Icon::Remove), tr("Remove"), this, &RecordsDialog::removeRow);
    tools->addAction(kit::icon(kit::Icon::Up), tr("Up"), this, [this] { moveRow(-1); });
    tools->addAction(kit::icon(kit::Icon::Down), tr("Down"), this, [this] { moveRow(1); });
    auto* left = new QWidget;
    auto* leftLayout = new QVBoxLayout(left);
    leftLayout->setContentsMargins(0, 0, 0, 0);
    leftLayout->addWidget(tools);
    leftLayout->addWidget(m_list);
    auto* splitter = new QSplitter;
    splitter->addWidget(left);
    splitter->addWidget(m_grid);
    splitter->setStretchFactor(1, 2);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(splitter, 1);
    layout->addWidget(buttons);

    m_grid->setCompletionSource(context.completions());
    m_grid->setPicker(context.picker());
    m_grid->setCheck([this](const QString& id, const QString& text) {
        for (const PropertyDescriptor& field : fields())
            if (propertyOf(id) == field.key)
                return m_context.checkBinding(text, field.hint, field.type == PropertyType::Target);
        return QString();
    });
    std::vector<kit::PropertyDescriptor> rows;
    for (const PropertyDescriptor& field : fields())
        for (kit::PropertyDescriptor& row : gridRows(field, context)) rows.push_back(std::move(row));
    m_grid->setDescriptors(std::move(rows));
    m_grid->resizeColumnToContents(0); // some names of fields say what may be written there
    connect(m_grid, &kit::PropertyGrid::committed, this, [this](const QString& id, const QVariant& edited) {
        const int row = m_shown;
        if (row < 0 || row >= rowCount()) return;
        Json& record = m_rows[static_cast<size_t>(row)];
        for (const PropertyDescriptor& field : fields()) {
            if (propertyOf(id) != field.key) continue;
            const std::string key(field.key);
            const Json present = record.contains(key) ? record[key] : field.fallback;
            QVariant value = edited;
            if (field.type == PropertyType::Color && edited.toString() == QStringLiteral("?")) {
                const QColor chosen = QColorDialog::getColor(QColor(toQString(present)), this);
                if (!chosen.isValid()) return showRow();
                value = chosen.name();
            }
            Json now = fromGrid(field, present, id, value);
            if (field.type == PropertyType::Text && m_storeText)
                now = toUtf8(m_storeText(toQString(present), value.toString()));
            if (now == field.fallback)
                record.erase(key);
            else
                record[key] = now;
        }
        showRow();
        refreshTitles();
    });
    connect(m_list, &QListWidget::currentRowChanged, this, &RecordsDialog::showRow);
    refreshTitles();
    selectRow(m_rows.empty() ? -1 : 0);
    showRow();
}

std::vector<PropertyDescriptor> RecordsDialog::fields() const {
    if (m_property.type == PropertyType::Records) return recordFields(m_property.hint);
    return {
        {"name", PropertyType::String, "", PropertyGroup::Value, QT_TRANSLATE_NOOP("Hmi", "Name"), ""},
        {"expression", PropertyType::Expression, "", PropertyGroup::Value, QT_TRANSLATE_NOOP("Hmi", "Value"), "any"}};
}

QString RecordsDialog::titleOfRow(size_t row) const {
    QStringList parts;
    for (const PropertyDescriptor& field : fields()) {
        const auto found = m_rows[row].find(std::string(field.key));
        if (found != m_rows[row].end() && found->is_string()) parts += m_context.shownText(toQString(*found));
    }
    return QStringLiteral("%1  %2").arg(row + 1).arg(parts.join(QStringLiteral("  ")));
}

void RecordsDialog::refreshTitles() {
    const int current = m_list->currentRow();
    while (m_list->count() > rowCount()) delete m_list->takeItem(m_list->count() - 1);
    while (m_list->count() < rowCount()) m_list->addItem(QString());
    for (int i = 0; i < rowCount(); ++i) m_list->item(i)->setText(titleOfRow(static_cast<size_t>(i)));
    if (current >= 0 && current < rowCount()) m_list->setCurrentRow(current);
}

void RecordsDialog::showRow() {
    if (m_list->currentRow() != m_shown) m_grid->endEditing();
    const int row = m_shown = m_list->currentRow();
    m_grid->setEnabled(row >= 0);
    if (row < 0 || row >= rowCount()) return;
    const Json& record = m_rows[static_cast<size_t>(row)];
    for (const PropertyDescriptor& field : fields()) {
        const std::string key(field.key);
        const QString id = QString::fromStdString(key);
        m_grid->setValue(id, gridValue(field, record.contains(key) ? record[key] : field.fallback, id, m_context));
    }
}

void RecordsDialog::addRow() {
    m_rows.push_back(Json::object());
    if (m_property.type == PropertyType::Bindings) m_rows.back()["name"] = "v" + std::to_string(m_rows.size());
    refreshTitles();
    selectRow(rowCount() - 1);
}

void RecordsDialog::removeRow() {
    m_grid->endEditing();
    const int row = m_list->currentRow();
    if (row < 0) return;
    m_rows.erase(m_rows.begin() + row);
    refreshTitles();
    selectRow(std::min(row, rowCount() - 1));
    showRow();
}

void RecordsDialog::moveRow(int by) {
    m_grid->endEditing();
    const int row = m_list->currentRow(), to = row + by;
    if (row < 0 || to < 0 || to >= rowCount()) return;
    std::swap(m_rows[static_cast<size_t>(row)], m_rows[static_cast<size_t>(to)]);
    refreshTitles();
    selectRow(to);
}

void RecordsDialog::selectRow(int row) { m_list->setCurrentRow(row); }

Json RecordsDialog::value() const {
    if (m_property.type == PropertyType::Records) {
        Json out = Json::array();
        for (const Json& row : m_rows) out.push_back(row);
        return out;
    }
    Json out = Json::object();
    for (const Json& row : m_rows) {
        const std::string name = row.value("name", std::string());
        if (!name.empty()) out[name] = row.value("expression", std::string());
    }
    return out;
}

} // namespace plc::hmi
