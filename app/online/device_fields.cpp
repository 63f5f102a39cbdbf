#include "app/online/device_fields.h"

#include "editor/kit/texts.h"

#include <QAbstractItemModel>
#include <QComboBox>
#include <QCoreApplication>
#include <QStyledItemDelegate>

#include <string_view>

namespace plc::app {

namespace {

using devices::Protocol;

struct Title {
    std::string_view field, word; // without a word: of the field itself
    const char* title;
};

constexpr Title kTitles[] = {
    {"name", "", QT_TRANSLATE_NOOP("DeviceFields", "Name")},
    {"comment", "", QT_TRANSLATE_NOOP("DeviceFields", "Comment")},
    {"protocol", "", QT_TRANSLATE_NOOP("DeviceFields", "Protocol")},
    {"enabled", "", QT_TRANSLATE_NOOP("DeviceFields", "Enabled")},
    {"host", "", QT_TRANSLATE_NOOP("DeviceFields", "Host")},
    {"port", "", QT_TRANSLATE_NOOP("DeviceFields", "Port")},
    {"unit", "", QT_TRANSLATE_NOOP("DeviceFields", "Unit number")},
    {"serial", "", QT_TRANSLATE_NOOP("DeviceFields", "Serial port")},
    {"baud", "", QT_TRANSLATE_NOOP("DeviceFields", "Baud rate")},
    {"parity", "", QT_TRANSLATE_NOOP("DeviceFields", "Parity")},
    {"dataBits", "", QT_TRANSLATE_NOOP("DeviceFields", "Data bits")},
    {"stopBits", "", QT_TRANSLATE_NOOP("DeviceFields", "Stop bits")},
    {"poll", "", QT_TRANSLATE_NOOP("DeviceFields", "Poll interval")},
    {"timeout", "", QT_TRANSLATE_NOOP("DeviceFields", "Timeout")},
    {"retry", "", QT_TRANSLATE_NOOP("DeviceFields", "Longest pause between attempts")},
    {"online", "", QT_TRANSLATE_NOOP("DeviceFields", "Variable: device responds")},
    {"clientId", "", QT_TRANSLATE_NOOP("DeviceFields", "Client ID")},
    {"user", "", QT_TRANSLATE_NOOP("DeviceFields", "User")},
    {"passwordFile", "", QT_TRANSLATE_NOOP("DeviceFields", "Password file")},
    {"tls", "", QT_TRANSLATE_NOOP("DeviceFields", "TLS encryption")},
    {"caFile", "", QT_TRANSLATE_NOOP("DeviceFields", "File of CA certificates")},
    {"variable", "", QT_TRANSLATE_NOOP("DeviceFields", "Variable")},
    {"direction", "", QT_TRANSLATE_NOOP("DeviceFields", "Direction")},
    {"table", "", QT_TRANSLATE_NOOP("DeviceFields", "Table")},
    {"address", "", QT_TRANSLATE_NOOP("DeviceFields", "Address")},
    {"bit", "", QT_TRANSLATE_NOOP("DeviceFields", "Bit of the register")},
    {"type", "", QT_TRANSLATE_NOOP("DeviceFields", "Type")},
    {"order", "", QT_TRANSLATE_NOOP("DeviceFields", "Byte order")},
    {"scale", "", QT_TRANSLATE_NOOP("DeviceFields", "Scale")},
    {"offset", "", QT_TRANSLATE_NOOP("DeviceFields", "Offset")},
    {"topic", "", QT_TRANSLATE_NOOP("DeviceFields", "Topic")},
    {"json", "", QT_TRANSLATE_NOOP("DeviceFields", "Path in the JSON message")},
    {"qos", "", QT_TRANSLATE_NOOP("DeviceFields", "Quality of service (0 to 2)")},
    {"retain", "", QT_TRANSLATE_NOOP("DeviceFields", "Retained message")},
    {"onLoss", "", QT_TRANSLATE_NOOP("DeviceFields", "If the connection is lost")},
    {"safe", "", QT_TRANSLATE_NOOP("DeviceFields", "Safe value")},
    {"quality", "", QT_TRANSLATE_NOOP("DeviceFields", "Variable: channel is good")},
    {"protocol", "modbus-tcp", QT_TRANSLATE_NOOP("DeviceFields", "Modbus TCP device")},
    {"protocol", "modbus-rtu", QT_TRANSLATE_NOOP("DeviceFields", "Modbus RTU device (serial)")},
    {"protocol", "modbus-server", QT_TRANSLATE_NOOP("DeviceFields", "Modbus TCP server")},
    {"protocol", "mqtt", QT_TRANSLATE_NOOP("DeviceFields", "MQTT broker")},
    {"table", "coil", QT_TRANSLATE_NOOP("DeviceFields", "Coil")},
    {"table", "discrete", QT_TRANSLATE_NOOP("DeviceFields", "Discrete input")},
    {"table", "holding", QT_TRANSLATE_NOOP("DeviceFields", "Holding register")},
    {"table", "input", QT_TRANSLATE_NOOP("DeviceFields", "Input register")},
    {"onLoss", "last", QT_TRANSLATE_NOOP("DeviceFields", "Keep the last value")},
    {"onLoss", "safe", QT_TRANSLATE_NOOP("DeviceFields", "Use the safe value")},
    {"onLoss", "fault", QT_TRANSLATE_NOOP("DeviceFields", "Stop the controller")},
    {"parity", "none", QT_TRANSLATE_NOOP("DeviceFields", "None")},
    {"parity", "even", QT_TRANSLATE_NOOP("DeviceFields", "Even")},
    {"parity", "odd", QT_TRANSLATE_NOOP("DeviceFields", "Odd")},
    {"direction", "in", QT_TRANSLATE_NOOP("DeviceFields", "Input")},
    {"direction", "out", QT_TRANSLATE_NOOP("DeviceFields", "Output")},
    {"", "true", QT_TRANSLATE_NOOP("DeviceFields", "Yes")},
    {"", "false", QT_TRANSLATE_NOOP("DeviceFields", "No")},
};

QString titleOf(const std::string& field, const std::string& word, const QString& otherwise) {
    for (const Title& each : kTitles)
        if (each.word == word && (each.field == field || each.field.empty()))
            return QCoreApplication::translate("DeviceFields", each.title);
    return otherwise;
}

class FieldDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        const QString field = index.siblingAtColumn(0).data(kFieldRole).toString();
        const QStringList words = wordsOf(field);
        if (words.isEmpty()) return QStyledItemDelegate::createEditor(parent, option, index);
        auto* box = new QComboBox(parent);
        box->addItem(QString());
        for (const QString& word : words) box->addItem(wordTitle(field, word), word);
        return box;
    }
    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        if (auto* box = qobject_cast<QComboBox*>(editor)) return box->setCurrentText(index.data().toString());
        QStyledItemDelegate::setEditorData(editor, index);
    }
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
        const auto* box = qobject_cast<QComboBox*>(editor);
        if (!box) return QStyledItemDelegate::setModelData(editor, model, index);
        model->setItemData(index, {{kWordRole, box->currentData()}, {Qt::EditRole, box->currentText()}});
    }
};

} // namespace

QStringList fieldsOf(Protocol protocol) {
    switch (protocol) {
    case Protocol::ModbusTcp:
        return {"name", "protocol", "enabled", "host", "port", "unit", "poll", "timeout", "retry", "online", "comment"};
    case Protocol::ModbusRtu:
        return {"name",     "protocol", "enabled", "serial",  "baud",  "parity", "dataBits",
                "stopBits", "unit",     "poll",    "timeout", "retry", "online", "comment"};
    case Protocol::ModbusServer:
        return {"name", "protocol", "enabled", "host", "port", "unit", "timeout", "online", "comment"};
    case Protocol::Mqtt:
        return {"name", "protocol", "enabled", "host",    "port",  "clientId", "user",   "passwordFile",
                "tls",  "caFile",   "poll",    "timeout", "retry", "online",   "comment"};
    }
    return {};
}

QStringList channelFieldsOf(Protocol protocol) {
    if (protocol == Protocol::Mqtt)
        return {"name",   "variable", "direction", "topic",  "json", "type",    "scale",
                "offset", "qos",      "retain",    "onLoss", "safe", "quality", "comment"};
    return {"name",  "variable", "direction", "table",  "address", "bit",     "type",   "order",
            "scale", "offset",   "poll",      "onLoss", "safe",    "quality", "comment"};
}

QString fieldTitle(const QString& field) { return titleOf(field.toStdString(), {}, field); }

QStringList wordsOf(const QString& field) {
    if (field == "enabled" || field == "tls" || field == "retain") return {"true", "false"};
    QStringList words;
    const auto add = [&](const char* list, const char* word) {
        if (field == list) words << word;
    };
#define PLC_PROTOCOL(Name, Spelling) add("protocol", Spelling);
#define PLC_TABLE(Name, Spelling) add("table", Spelling);
#define PLC_WIRE_TYPE(Name, Spelling, Registers) add("type", Spelling);
#define PLC_ORDER(Name, Spelling) add("order", Spelling);
#define PLC_ON_LOSS(Name, Spelling) add("onLoss", Spelling);
#define PLC_PARITY(Name, Spelling) add("parity", Spelling);
#define PLC_DIRECTION(Name, Spelling) add("direction", Spelling);
#include "projects/devices/configuration/words.def"
    return words;
}

QString wordTitle(const QString& field, const QString& word) {
    return word.isEmpty() ? word : titleOf(field.toStdString(), word.toStdString(), word);
}

QAbstractItemDelegate* newFieldDelegate(QObject* parent) { return new FieldDelegate(parent); }

} // namespace plc::app
