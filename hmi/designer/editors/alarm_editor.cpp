#include "hmi/designer/editors/alarm_editor.h"

#include "editor/kit/edit_history.h"
#include "editor/kit/icons.h"
#include "hmi/designer/editors/edit_bar.h"
#include "hmi/designer/sheet/records_dialog.h"
#include "hmi/model/property_literals.h"
#include "hmi/view/paint/panel_theme.h"

#include <QAction>
#include <QColorDialog>
#include <QCoreApplication>
#include <QHeaderView>
#include <QPainter>
#include <QSplitter>
#include <QToolBar>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace plc::hmi {

namespace {
constexpr int kIndexRole = Qt::UserRole, kClassRole = Qt::UserRole + 1;
}

AlarmEditor::AlarmEditor(DesignContext& context, QWidget* parent)
    : QWidget(parent), m_context(context), m_list(new QTreeWidget), m_grid(new kit::PropertyGrid) {
    m_list->setAccessibleName(tr("Alarms"));
    m_list->setHeaderLabels({tr("Alarm"), tr("Priority"), tr("Condition"), tr("Text")});
    m_list->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(2, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(3, QHeaderView::Stretch);
    QToolBar* bar = makeEditBar(m_undo, this);
    bar->addAction(kit::icon(kit::Icon::Alarm), tr("Add an alarm"), this, &AlarmEditor::addAlarm);
    bar->addAction(kit::icon(kit::Icon::Layers), tr("Add a class"), this, &AlarmEditor::addClass);
    bar->addAction(kit::icon(kit::Icon::Remove), tr("Remove"), this, &AlarmEditor::removeSelected);
    auto* splitter = new QSplitter;
    splitter->addWidget(m_list);
    splitter->addWidget(m_grid);
    splitter->setStretchFactor(0, 2);
    splitter->setStretchFactor(1, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(bar);
    layout->addWidget(splitter, 1);
    m_grid->setPicker(context.picker());
    m_grid->setCompletionSource([this](const QString& text, int cursor) {
        return m_context.completions() ? m_context.completions()(text, cursor) : std::vector<kit::Completion>();
    });
    m_grid->setCheck([this](const QString& id, const QString& text) {
        const PropertyDescriptor* property = alarmDescriptor().property(propertyOf(id));
        return property ? m_context.checkBinding(text, property->hint, false) : QString();
    });
    connect(&m_context, &DesignContext::alarmsTaken, &m_undo, &QUndoStack::clear); // its steps are of another file
    connect(m_grid, &kit::PropertyGrid::committed, this, &AlarmEditor::commit);
    connect(m_grid, &kit::PropertyGrid::actionRequested, this, [this](const QString& id) {
        const Row row = current();
        const Properties* now = properties(m_context.project().alarms, row);
        const PropertyDescriptor* property = now ? now->descriptor().property(propertyOf(id)) : nullptr;
        if (!property) return;
        RecordsDialog dialog(*property, now->at(property->key), m_context, {}, this);
        if (dialog.exec() != QDialog::Accepted) return;
        const Json value = dialog.value();
        edit(tr("Values"),
             [&](AlarmFile& file) { const_cast<Properties*>(properties(file, row))->set(property->key, value); });
    });
    connect(m_list, &QTreeWidget::currentItemChanged, this, &AlarmEditor::showRow);
    connect(&context, &DesignContext::alarmsChanged, this, &AlarmEditor::rebuild);
    connect(&context, &DesignContext::textsChanged, this, &AlarmEditor::rebuild);
    connect(&context, &DesignContext::languageChanged, this, &AlarmEditor::rebuild);
    rebuild();
}

AlarmEditor::Row AlarmEditor::current() const {
    const QTreeWidgetItem* item = m_list->currentItem();
    if (!item || item->data(0, kIndexRole).isNull()) return {};
    return {item->data(0, kClassRole).toBool(), item->data(0, kIndexRole).toInt()};
}

const Properties* AlarmEditor::properties(const AlarmFile& file, Row row) const {
    const std::vector<Properties>& rows = row.isClass ? file.classRows() : file.rows();
    return row.isValid() && row.index < static_cast<int>(rows.size()) ? &rows[static_cast<size_t>(row.index)] : nullptr;
}

void AlarmEditor::edit(const QString& title, const std::function<void(AlarmFile&)>& change) {
    const AlarmFile before = m_context.project().alarms;
    AlarmFile after = before;
    change(after);
    if (after.write() == before.write()) return;
    m_undo.push(new kit::ClosureCommand(
        title, [this, after] { m_context.setAlarms(after); }, [this, before] { m_context.setAlarms(before); }));
}

void AlarmEditor::rebuild() {
    const Row kept = current();
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    const AlarmFile& file = m_context.project().alarms;
    auto* alarms = new QTreeWidgetItem(m_list, {tr("Alarms")});
    auto* classes = new QTreeWidgetItem(m_list, {tr("Classes")});
    const PanelTheme& theme = PanelTheme::of(PanelThemeKind::Light);
    const auto add = [&](QTreeWidgetItem* parent, const QStringList& texts, Row row, const QColor& color) {
        auto* item = new QTreeWidgetItem(parent, texts);
        item->setData(0, kIndexRole, row.index);
        item->setData(0, kClassRole, row.isClass);
        QPixmap mark(12, 12);
        mark.fill(color);
        item->setIcon(0, QIcon(mark));
        if (row.isClass == kept.isClass && row.index == kept.index) m_list->setCurrentItem(item);
    };
    for (int i = 0; i < static_cast<int>(file.rows().size()); ++i) {
        const Properties& row = file.rows()[static_cast<size_t>(i)];
        add(alarms,
            {row.text("id"_text), QString::number(row.integer("priority"_number)), row.text("condition"_text),
             m_context.shownText(row.text("text"_text))},
            {false, i}, theme.priority(row.integer("priority"_number)));
    }
    for (int i = 0; i < static_cast<int>(file.classRows().size()); ++i) {
        const Properties& row = file.classRows()[static_cast<size_t>(i)];
        const QColor color = theme.color(row.text("color"_text));
        add(classes, {row.text("name"_text), QString(), QString(), m_context.shownText(row.text("title"_text))},
            {true, i}, color.isValid() ? color : theme.color("off"));
    }
    m_list->expandAll();
    m_list->resizeColumnToContents(0);
    showRow();
}

void AlarmEditor::showRow() {
    if (current() != m_shown) m_grid->endEditing();
    const Row row = m_shown = current();
    const Properties* found = properties(m_context.project().alarms, row);
    m_grid->setEnabled(found != nullptr);
    if (!found) return;
    const Properties now = *found;
    const QString shape = row.isClass ? QStringLiteral("class") : QStringLiteral("alarm");
    const auto rowsOf = [&](const PropertyDescriptor& property) {
        std::vector<kit::PropertyDescriptor> rows = gridRows(property, m_context);
        if (property.key == "id") { // an alarm's id is its number in books and logs: it may be edited
            kit::PropertyDescriptor id;
            id.id = QStringLiteral("id");
            id.group = titleOf(property.group);
            id.label = QCoreApplication::translate("Hmi", property.title);
            rows.push_back(id);
        }
        if (property.key == "class") {
            rows.front().kind = kit::PropertyKind::Enumeration;
            rows.front().choices = {{QString(), tr("none"), {}}};
            for (const AlarmClass& one : m_context.project().alarms.classes())
                rows.front().choices.push_back({one.name, one.name, {}});
        }
        return rows;
    };
    if (shape != m_shape || !row.isClass) {
        m_shape = shape;
        std::vector<kit::PropertyDescriptor> rows;
        for (const PropertyDescriptor& property : now.descriptor().properties)
            for (kit::PropertyDescriptor& one : rowsOf(property)) rows.push_back(std::move(one));
        m_grid->setDescriptors(std::move(rows));
    }
    for (const PropertyDescriptor& property : now.descriptor().properties)
        for (const kit::PropertyDescriptor& one : rowsOf(property))
            m_grid->setValue(one.id, property.key == "id"
                                         ? QVariant(now.text("id"_text))
                                         : gridValue(property, now.at(property.key), one.id, m_context));
}

void AlarmEditor::commit(const QString& gridId, const QVariant& value) {
    const Row row = m_shown;
    const Properties* now = properties(m_context.project().alarms, row);
    if (!now) return;
    const PropertyDescriptor* property = now->descriptor().property(propertyOf(gridId));
    if (!property) return;
    const QString title = QCoreApplication::translate("Hmi", property->title);
    kit::MacroScope macro(m_undo, title);
    Json stored = property->key == "id" ? Json(toUtf8(value.toString()))
                                        : fromGrid(*property, now->at(property->key), gridId, value);
    if (property->key == "id") { // an id is never empty and never there twice
        bool isTaken = value.toString().trimmed().isEmpty();
        for (const Properties& other : m_context.project().alarms.rows())
            isTaken |= other.text("id"_text) == value.toString() && &other != now;
        if (isTaken) return rebuild();
    }
    if (property->type == PropertyType::Text)
        stored =
            toUtf8(m_context.storeText(now->text(property->key), value.toString(), QStringLiteral("alarm"), m_undo));
    edit(title, [&](AlarmFile& file) {
        auto* row_ = const_cast<Properties*>(properties(file, row));
        if (stored == property->fallback)
            row_->setField(property->key, std::nullopt, 0);
        else
            row_->set(property->key, stored);
    });
}

void AlarmEditor::addAlarm() {
    const Properties row = m_context.project().alarms.newRow();
    edit(tr("Add alarm"), [&](AlarmFile& file) { file.rows().push_back(row); });
    select(row.text("id"_text));
}

void AlarmEditor::addClass() {
    const std::string name = "class" + std::to_string(m_context.project().alarms.classRows().size() + 1);
    edit(tr("Add class"), [&](AlarmFile& file) {
        file.classRows().push_back(Properties(alarmClassDescriptor(), Json{{"name", name}}));
    });
    select(QString::fromStdString(name));
}

void AlarmEditor::removeSelected() {
    const Row row = current();
    if (!row.isValid()) return;
    edit(tr("Remove"), [&](AlarmFile& file) {
        auto& rows = row.isClass ? file.classRows() : file.rows();
        rows.erase(rows.begin() + row.index);
    });
}

void AlarmEditor::select(const QString& id) {
    const QList<QTreeWidgetItem*> found = m_list->findItems(id, Qt::MatchExactly | Qt::MatchRecursive, 0);
    if (!found.isEmpty()) m_list->setCurrentItem(found.front());
}

} // namespace plc::hmi
