#include "app/online/devices_view.h"

#include "app/online/device_connections.h"
#include "app/online/device_fields.h"
#include "editor/kit/bar_menu.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"
#include "projects/devices/configuration/proposal.h"
#include "projects/storage/project_file.h"

#include <QAction>
#include <QApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>
#include <QToolBar>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace plc::app {

namespace {

using devices::Protocol;

enum Column { Name, Variable, Where, State, Value, Traffic, Count };
constexpr int kDevice = Qt::UserRole, kChannel = Qt::UserRole + 1;

QString placeOf(const devices::Device& device) {
    if (device.protocol == Protocol::ModbusRtu) return kit::fromView(device.serial) + QString(" · %1").arg(device.unit);
    return kit::fromView(device.host) + QString(":%1").arg(device.port);
}

QString placeOf(const devices::Device& device, const devices::Channel& channel) {
    const QString arrow = channel.direction == devices::Direction::In ? "← " : "→ ";
    if (!device.isModbus()) return arrow + kit::fromView(channel.topic + channel.jsonPath);
    const QString bit = channel.bit >= 0 ? QString(".%1").arg(channel.bit) : QString();
    const QString table = wordTitle("table", kit::fromView(devices::spelling(channel.table)));
    return arrow + table + QString(" %1").arg(channel.address) + bit + " " +
           kit::fromView(devices::spelling(channel.type));
}

QString nameOf(devices::LinkState state) {
    switch (state) {
    case devices::LinkState::Off:
        return DevicesView::tr("off");
    case devices::LinkState::Connecting:
        return DevicesView::tr("connecting");
    case devices::LinkState::Online:
        return DevicesView::tr("online");
    case devices::LinkState::Lost:
        return DevicesView::tr("lost");
    }
    return {};
}

QString nameOf(devices::Quality quality) {
    switch (quality) {
    case devices::Quality::Good:
        return DevicesView::tr("good");
    case devices::Quality::Waiting:
        return DevicesView::tr("nothing yet");
    case devices::Quality::Lost:
        return DevicesView::tr("lost");
    case devices::Quality::Refused:
        return DevicesView::tr("refused by the device");
    case devices::Quality::Unfit:
        return DevicesView::tr("does not fit");
    }
    return {};
}

/// A name that no other has: "Device", "Device2", …
std::string freeName(const std::string& wish, const std::function<bool(const std::string&)>& isTaken) {
    std::string name = wish;
    for (int n = 2; isTaken(name); ++n) name = wish + std::to_string(n);
    return name;
}

} // namespace

DevicesView& DevicesView::of(const QWidget& window) { return *window.findChild<DevicesView*>(); }

DevicesView::DevicesView(DeviceConnections& connections, editor::Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_connections(connections), m_workspace(workspace), m_tree(new QTreeWidget),
      m_fields(new QTableWidget(0, 2)), m_summary(new QLabel(this)) {
    m_summary->setObjectName("devicesSummary");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    makeToolBar(*layout);
    m_tree->setObjectName("deviceTree");
    m_tree->setAccessibleName(tr("Devices"));
    m_tree->setHeaderLabels(
        {tr("Device or channel"), tr("Variable"), tr("Place"), tr("State"), tr("Value"), tr("Traffic")});
    m_tree->setAlternatingRowColors(true);
    m_tree->setColumnWidth(Name, 140);
    m_tree->setColumnWidth(Column::State, 110);
    m_tree->setColumnWidth(Value, 120);
    m_tree->setColumnWidth(Variable, 130);
    m_tree->setColumnWidth(Where, 150);
    // What moves is beside the name: in a small window the rest is out of sight, not this.
    m_tree->header()->moveSection(m_tree->header()->visualIndex(Column::State), 1);
    m_tree->header()->moveSection(m_tree->header()->visualIndex(Value), 2);
    m_fields->setObjectName("deviceFields");
    m_fields->setAccessibleName(tr("Fields of the device or channel"));
    m_fields->setHorizontalHeaderLabels({tr("Field"), tr("Content")});
    m_fields->horizontalHeader()->setStretchLastSection(true);
    m_fields->verticalHeader()->hide();
    m_fields->setItemDelegate(newFieldDelegate(m_fields));
    m_fields->setEditTriggers(QAbstractItemView::AllEditTriggers);
    m_begin = newBeginning();
    auto* splitter = new QSplitter(this);
    splitter->addWidget(m_tree);
    splitter->addWidget(m_fields);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 1);
    layout->addWidget(splitter);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, [this] {
        showFields();
        updateActions();
    });
    connect(m_fields, &QTableWidget::cellChanged, this, [this](int row) { setField(row); });
    connect(&m_connections, &DeviceConnections::changed, this, &DevicesView::showStatus);
    connect(&m_workspace, &editor::Workspace::opened, this, &DevicesView::reload);
    connect(&m_workspace, &editor::Workspace::closed, this, &DevicesView::reload);
    connect(&m_workspace, &editor::Workspace::analysed, this, &DevicesView::reload); // another program: check again
    connect(&m_refresh, &QTimer::timeout, this, &DevicesView::showStatus);
    m_refresh.start(300);
    reload();
}

/// A dock without devices says what they are and offers one.
QWidget* DevicesView::newBeginning() {
    auto* begin = new QWidget(m_tree->viewport());
    begin->setObjectName("devicesBegin");
    auto* text =
        new QLabel(tr("This project has no devices yet. A device (Modbus, MQTT) brings values from outside into "
                      "variables and takes values of variables out."));
    text->setWordWrap(true);
    text->setAlignment(Qt::AlignCenter);
    auto* add = new QPushButton(kit::icon(kit::Icon::Add), tr("Add a device"));
    add->setMenu(findChild<QMenu*>("devicesAdd"));
    auto* column = new QVBoxLayout(begin);
    column->addStretch();
    column->addWidget(text);
    column->addWidget(add, 0, Qt::AlignHCenter);
    column->addStretch();
    auto* over = new QVBoxLayout(m_tree->viewport());
    over->setContentsMargins(0, 0, 0, 0);
    over->addWidget(begin);
    begin->hide();
    return begin;
}

void DevicesView::makeToolBar(QVBoxLayout& layout) {
    auto* bar = new QToolBar(this);
    bar->setIconSize({16, 16});
    m_connect = bar->addAction(kit::icon(kit::Icon::Link), tr("Connect or disconnect the devices"), this,
                               &DevicesView::toggleConnection);
    m_connect->setObjectName("devicesConnect");
    m_connect->setCheckable(true);
    QMenu* menu = kit::addBarMenu(*bar, kit::icon(kit::Icon::Add), tr("Add a device"));
    menu->setObjectName("devicesAdd");
    const std::pair<Protocol, QString> kinds[] = {{Protocol::ModbusTcp, tr("Modbus TCP device")},
                                                  {Protocol::ModbusRtu, tr("Modbus RTU device (serial)")},
                                                  {Protocol::ModbusServer, tr("Modbus TCP server")},
                                                  {Protocol::Mqtt, tr("MQTT broker")}};
    for (const auto& [protocol, title] : kinds)
        menu->addAction(title, this, [this, kind = protocol] { addDevice(kind); });
    m_addChannel = bar->addAction(kit::icon(kit::Icon::Variable), tr("Add a channel"), this, &DevicesView::addChannel);
    m_remove =
        bar->addAction(kit::icon(kit::Icon::Delete), tr("Delete the device or channel"), this, &DevicesView::remove);
    m_propose = bar->addAction(kit::icon(kit::Icon::Lightbulb), tr("Propose addresses for channels without a variable"),
                               this, &DevicesView::proposeAddresses);
    m_undoAction =
        bar->addAction(kit::icon(kit::Icon::Undo), tr("Undo the last change of the devices"), this, &DevicesView::undo);
    m_summary->setContentsMargins(10, 0, 0, 0);
    bar->addWidget(m_summary);
    layout.addWidget(bar);
}

// ---------------------------------------------------------------- the file

void DevicesView::reload() {
    const QWidget* focus = QApplication::focusWidget();
    if (focus && m_fields->viewport()->isAncestorOf(focus)) return; // somebody writes here; the next time
    const auto file =
        devices::DeviceFile::load(m_workspace.isOpen() ? m_workspace.folder().toStdString() : std::string());
    if (!file) {
        emit message(kit::messageText(file.error().message), true);
        return;
    }
    if (!m_workspace.isOpen()) m_undo.clear();
    if (file->text() != m_file.text() || m_tree->topLevelItemCount() == 0) {
        m_file = *file;
        showTree();
    }
    check();
}

void DevicesView::check() {
    std::vector<OtherProblem> problems;
    if (m_workspace.isOpen())
        for (const devices::Finding& finding : m_connections.findings(m_file)) {
            QString place = "devices.json";
            if (finding.line > 0) place += QString(":%1").arg(finding.line);
            const std::string name = finding.device + (finding.channel.empty() ? "" : "." + finding.channel);
            if (!name.empty()) place += "  " + kit::fromView(name);
            problems.push_back({"D1000", kit::messageText(finding.message), place, finding.isError, "devices.json",
                                kit::fromView(name)});
        }
    emit problemsChanged(std::move(problems));
}

bool DevicesView::save() {
    const auto saved = m_file.save(m_workspace.folder().toStdString());
    if (!saved) emit message(kit::messageText(saved.error().message), true);
    return bool(saved);
}

void DevicesView::edit(const std::function<void(devices::DeviceFile&)>& change) {
    if (!m_workspace.isOpen()) return;
    const std::string before = m_file.text();
    change(m_file);
    if (m_file.text() == before) return;
    m_undo.push_back(before);
    (void)save();
    showTree();
    check();
}

void DevicesView::undo() {
    if (m_undo.empty()) return;
    m_file = devices::DeviceFile::parse(m_undo.back());
    m_undo.pop_back();
    (void)save();
    showTree();
    check();
}

void DevicesView::addDevice(Protocol protocol) {
    const std::string name = freeName("Device", [this](const std::string& wish) {
        return std::any_of(m_file.devices().begin(), m_file.devices().end(),
                           [&](const devices::Device& each) { return each.name == wish; });
    });
    edit([&](devices::DeviceFile& file) { file.addDevice(protocol, name); });
    select(kit::fromView(name));
}

void DevicesView::addChannel() {
    const auto entry = current();
    if (!entry) return;
    const devices::Device& device = m_file.devices()[entry->device];
    const std::string name = freeName("Channel", [&](const std::string& wish) {
        return std::any_of(device.channels.begin(), device.channels.end(),
                           [&](const devices::Channel& each) { return each.name == wish; });
    });
    const QString path = kit::fromView(device.name + "." + name);
    edit([&](devices::DeviceFile& file) { file.addChannel(entry->device, name); });
    select(path);
}

void DevicesView::remove() {
    const auto entry = current();
    if (!entry) return;
    edit([&](devices::DeviceFile& file) {
        if (entry->channel)
            file.removeChannel(entry->device, *entry->channel);
        else
            file.removeDevice(entry->device);
    });
}

void DevicesView::proposeAddresses() {
    const auto model = m_workspace.model();
    const bool hasLayout = model && !model->checked().analysis->hasErrors && model->checked().analysis->program;
    const std::vector<devices::Proposal> proposals =
        devices::proposeAddresses(m_file, hasLayout ? &model->checked().analysis->program->layout : nullptr);
    if (proposals.empty()) return emit message(tr("Every channel has a variable"), false);
    edit([&](devices::DeviceFile& file) {
        for (const devices::Proposal& each : proposals)
            file.setField(each.device, each.channel, "variable", each.address);
    });
    emit message(tr("%n address(es) proposed", nullptr, static_cast<int>(proposals.size())), false);
}

void DevicesView::setField(int row) {
    const auto entry = current();
    if (m_isFilling || !entry || !m_fields->item(row, 0)) return;
    const QString name = m_fields->item(row, 0)->data(kFieldRole).toString();
    const QTableWidgetItem& cell = *m_fields->item(row, 1);
    const bool isWord = !wordsOf(name).isEmpty();
    const std::string field = name.toStdString();
    const std::string value = (isWord ? cell.data(kWordRole).toString() : cell.text().trimmed()).toStdString();
    // The table is made again by the edit, after the editor of the cell has closed.
    kit::post(this, [this, entry, field, value] {
        edit([&](devices::DeviceFile& file) { file.setField(entry->device, entry->channel, field, value); });
    });
}

// ---------------------------------------------------------------- what is shown

std::optional<DevicesView::Entry> DevicesView::current() const {
    const QTreeWidgetItem* item = m_tree->currentItem();
    if (!item) return std::nullopt;
    Entry entry{item->data(0, kDevice).toUInt(), {}};
    if (item->parent()) entry.channel = item->data(0, kChannel).toUInt();
    if (entry.device >= m_file.devices().size()) return std::nullopt;
    if (entry.channel && *entry.channel >= m_file.devices()[entry.device].channels.size()) return std::nullopt;
    return entry;
}

void DevicesView::showTree() {
    const auto before = current();
    m_tree->clear();
    for (size_t d = 0; d < m_file.devices().size(); ++d) {
        const devices::Device& device = m_file.devices()[d];
        auto* item =
            new QTreeWidgetItem(m_tree, {kit::fromView(device.name), kit::fromView(device.online), placeOf(device)});
        item->setData(0, kDevice, static_cast<uint>(d));
        item->setIcon(0, kit::icon(kit::Icon::Link));
        for (size_t c = 0; c < device.channels.size(); ++c) {
            const devices::Channel& channel = device.channels[c];
            auto* child = new QTreeWidgetItem(
                item, {kit::fromView(channel.name), kit::fromView(channel.variable), placeOf(device, channel)});
            child->setData(0, kDevice, static_cast<uint>(d));
            child->setData(0, kChannel, static_cast<uint>(c));
            if (before && before->device == d && before->channel == c) m_tree->setCurrentItem(child);
        }
        item->setExpanded(true);
        if (before && before->device == d && !m_tree->currentItem()) m_tree->setCurrentItem(item);
    }
    if (!m_tree->currentItem() && m_tree->topLevelItemCount() > 0) m_tree->setCurrentItem(m_tree->topLevelItem(0));
    m_begin->setVisible(m_workspace.isOpen() && m_file.devices().empty());
    showFields();
    showStatus();
}

void DevicesView::showFields() {
    m_isFilling = true;
    const auto entry = current();
    const QStringList names = !entry           ? QStringList()
                              : entry->channel ? channelFieldsOf(m_file.devices()[entry->device].protocol)
                                               : fieldsOf(m_file.devices()[entry->device].protocol);
    m_fields->setRowCount(static_cast<int>(names.size()));
    for (int row = 0; row < names.size(); ++row) {
        auto* name = new QTableWidgetItem(fieldTitle(names[row]));
        name->setData(kFieldRole, names[row]);
        name->setToolTip(tr("“%1” in devices.json").arg(names[row]));
        name->setFlags(Qt::ItemIsEnabled);
        const QString word = kit::fromView(m_file.field(entry->device, entry->channel, names[row].toStdString()));
        auto* value = new QTableWidgetItem(wordsOf(names[row]).isEmpty() ? word : wordTitle(names[row], word));
        value->setData(kWordRole, word);
        m_fields->setItem(row, 0, name);
        m_fields->setItem(row, 1, value);
    }
    m_isFilling = false;
}

void DevicesView::showStatus() {
    const std::vector<devices::DeviceStatus> all = m_connections.status();
    const bool isConnected = m_connections.isConnected();
    const QLocale locale;
    for (int d = 0; d < m_tree->topLevelItemCount(); ++d) {
        QTreeWidgetItem* item = m_tree->topLevelItem(d);
        const devices::DeviceStatus* status = nullptr;
        for (const devices::DeviceStatus& each : all)
            if (kit::fromView(each.name) == item->text(Name)) status = &each;
        if (!isConnected) status = nullptr;
        const devices::Device& device = m_file.devices()[static_cast<size_t>(d)];
        item->setText(Column::State, status ? nameOf(status->state) : device.isEnabled ? QString() : tr("not enabled"));
        item->setToolTip(Column::State, status ? kit::messageText(status->problem) : QString());
        item->setText(Value, item->toolTip(Column::State));
        item->setToolTip(Value, item->toolTip(Column::State));
        const bool isLost = status && status->state == devices::LinkState::Lost;
        item->setForeground(Column::State, isLost ? kit::colors().bad : kit::colors().text);
        item->setText(Traffic, status ? tr("%1 requests, %2 errors, %3 ms")
                                            .arg(locale.toString(qulonglong(status->figures.requests)),
                                                 locale.toString(qulonglong(status->figures.errors)),
                                                 locale.toString(status->figures.meanLatencyNs / 1e6, 'f', 1))
                                      : QString());
        for (int c = 0; c < item->childCount(); ++c) {
            QTreeWidgetItem* child = item->child(c);
            const bool isKnown = status && static_cast<size_t>(c) < status->channels.size();
            const devices::ChannelStatus* channel = isKnown ? &status->channels[static_cast<size_t>(c)] : nullptr;
            child->setText(Column::State, channel ? nameOf(channel->quality) : QString());
            child->setText(Value, channel ? kit::fromView(channel->value) : QString());
            const bool isBad = channel && channel->quality != devices::Quality::Good;
            child->setForeground(Column::State, isBad ? kit::colors().warning : kit::colors().text);
        }
    }
    const auto online = std::count_if(all.begin(), all.end(), [](const devices::DeviceStatus& each) {
        return each.state == devices::LinkState::Online;
    });
    m_summary->setText(isConnected ? tr("online: %1 of %2").arg(online).arg(all.size()) : tr("not connected"));
    updateActions();
}

void DevicesView::updateActions() {
    const bool isOpen = m_workspace.isOpen();
    const auto entry = current();
    m_connect->setChecked(m_connections.isConnected());
    m_connect->setEnabled(isOpen);
    m_addChannel->setEnabled(isOpen && entry.has_value());
    m_remove->setEnabled(isOpen && entry.has_value());
    m_propose->setEnabled(isOpen && !m_file.devices().empty());
    m_undoAction->setEnabled(isOpen && !m_undo.empty());
}

void DevicesView::toggleConnection() {
    if (m_connections.isConnected())
        m_connections.disconnectDevices();
    else if (const auto connected = m_connections.connectDevices(); !connected)
        emit message(kit::messageText(connected.error().message), true);
    showStatus();
}

void DevicesView::select(const QString& name) {
    for (int d = 0; d < m_tree->topLevelItemCount(); ++d) {
        QTreeWidgetItem* item = m_tree->topLevelItem(d);
        if (item->text(Name) == name) return m_tree->setCurrentItem(item);
        for (int c = 0; c < item->childCount(); ++c)
            if (item->text(Name) + "." + item->child(c)->text(Name) == name)
                return m_tree->setCurrentItem(item->child(c));
    }
}

} // namespace plc::app
