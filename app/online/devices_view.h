// The devices of the project: what devices.json says as a tree with the fields of one entry beside it, what is wrong
// with it, and how the devices do while they are connected. Each edit is saved at once and can be undone. Owned by its
// dock; GUI thread.
#pragma once
#include "app/project/problems_view.h"
#include "projects/devices/configuration/device_file.h"

#include <QTimer>
#include <QWidget>

class QAction;
class QLabel;
class QTableWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace plc::app {

class DeviceConnections;

class DevicesView : public QWidget {
    Q_OBJECT
public:
    /// The one of a window.
    [[nodiscard]] static DevicesView& of(const QWidget& window);
    DevicesView(DeviceConnections& connections, editor::Workspace& workspace, QWidget* parent = nullptr);
    void toggleConnection();
    /// "Pump" or "Pump.Level".
    void select(const QString& name);
    [[nodiscard]] const devices::DeviceFile& file() const { return m_file; }
    [[nodiscard]] QTreeWidget& tree() { return *m_tree; }
    [[nodiscard]] QTableWidget& fields() { return *m_fields; }

    void addDevice(devices::Protocol protocol);
    void addChannel();
    void remove();
    void proposeAddresses();
    void undo();

signals:
    void message(const QString& text, bool isError);
    void problemsChanged(std::vector<plc::app::OtherProblem> problems);

private:
    struct Entry {
        size_t device = 0;
        std::optional<size_t> channel;
    };
    void makeToolBar(class QVBoxLayout& layout);
    [[nodiscard]] QWidget* newBeginning();
    void reload(); // from disk
    void showTree();
    void showFields();
    void showStatus();
    void check();
    void updateActions();
    void setField(int row);
    void edit(const std::function<void(devices::DeviceFile&)>& change);
    bool save();
    [[nodiscard]] std::optional<Entry> current() const;

    DeviceConnections& m_connections;
    editor::Workspace& m_workspace;
    QTreeWidget* m_tree;
    QTableWidget* m_fields;
    QLabel* m_summary;
    QWidget* m_begin = nullptr; // over an empty tree: how to begin
    QAction *m_connect = nullptr, *m_addChannel = nullptr, *m_remove = nullptr, *m_propose = nullptr,
            *m_undoAction = nullptr;
    QTimer m_refresh;
    devices::DeviceFile m_file;
    std::vector<std::string> m_undo; // texts
    bool m_isFilling = false;
};

} // namespace plc::app
