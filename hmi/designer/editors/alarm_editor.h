// The alarms of the project as a list with the properties of the chosen one; classes beside them; with undo.
// Owned by its Qt parent; the context must outlive it. Main thread.
#pragma once
#include "hmi/designer/sheet/property_mapping.h"

#include <QUndoStack>
#include <QWidget>

class QTreeWidget;

namespace plc::hmi {

class AlarmEditor final : public QWidget {
    Q_OBJECT
public:
    explicit AlarmEditor(DesignContext& context, QWidget* parent = nullptr);
    QUndoStack& undoStack() { return m_undo; }
    kit::PropertyGrid& grid() { return *m_grid; }
    void addAlarm();
    void addClass();
    void removeSelected();
    void select(const QString& id);
    void commit(const QString& gridId, const QVariant& value);

private:
    struct Row {
        bool isClass = false;
        int index = -1;
        bool isValid() const { return index >= 0; }
        bool operator==(const Row&) const = default;
    };
    Row current() const;
    const Properties* properties(const AlarmFile& file, Row row) const;
    void edit(const QString& title, const std::function<void(AlarmFile&)>& change);
    void rebuild();
    void showRow();
    DesignContext& m_context;
    QUndoStack m_undo;
    QTreeWidget* m_list;
    kit::PropertyGrid* m_grid;
    QString m_shape;
    Row m_shown; // in the grid
};

} // namespace plc::hmi
