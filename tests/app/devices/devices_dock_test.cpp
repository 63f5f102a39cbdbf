// The devices dock as one works with it: describe a device, correct what the problem list says, connect it to the
// running program, see its values, disconnect. The other side is a second engine that is the server.
#include "app/online/device_fields.h"
#include "app/online/devices_view.h"
#include "app/project/problems_view.h"
#include "app/project/project_tree.h"
#include "projects/devices/engine.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"
#include "tests/support/settle.h"

#include <QAbstractItemDelegate>
#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTableWidget>
#include <QTreeWidget>

#include <memory>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace plc::app {
namespace {

const char* const kProgram = R"(VAR_GLOBAL LevelGood : BOOL; END_VAR
PROGRAM Main
VAR level AT %IW0 : INT; speed AT %QW0 : INT; count : DINT; END_VAR
count := count + 1;
speed := 1234;
END_PROGRAM
CONFIGURATION Plc RESOURCE Cpu ON Pc TASK Fast(INTERVAL := T#5ms, PRIORITY := 1); PROGRAM Main WITH Fast : Main; END_RESOURCE END_CONFIGURATION
)";

uint16_t freePort() {
    const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
    ::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
    ::close(listener);
    return ntohs(address.sin_port);
}

class DevicesDock : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        write("src/main.st", kProgram);
        ASSERT_TRUE(window->openProject(folder.path()));
        ASSERT_TRUE(waitFor([&] { return window->workspace().model() != nullptr; }));
        window->showDock("devices");
    }
    DevicesView& view() { return DevicesView::of(*window); }
    std::string onDisk() {
        QFile file(folder.filePath("devices.json"));
        return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
    }
    /// Through the cell's editor, by the words that a user sees.
    void set(const QString& title, const QString& value) {
        QTableWidget& fields = view().fields();
        for (int row = 0; row < fields.rowCount(); ++row) {
            if (fields.item(row, 0)->text() != title) continue;
            const QModelIndex cell = fields.model()->index(row, 1);
            const std::unique_ptr<QWidget> editor(fields.itemDelegate()->createEditor(fields.viewport(), {}, cell));
            if (auto* box = qobject_cast<QComboBox*>(editor.get()))
                box->setCurrentText(value);
            else
                editor->setProperty("text", value);
            fields.itemDelegate()->setModelData(editor.get(), fields.model(), cell);
            QCoreApplication::processEvents(); // the edit is queued behind the editor
            return;
        }
        ADD_FAILURE() << "no field " << title.toStdString();
    }
    QStringList problems() {
        QStringList all;
        QTreeWidget& list = window->problems().list();
        for (int i = 0; i < list.topLevelItemCount(); ++i)
            if (list.topLevelItem(i)->text(1) == "D1000") all << list.topLevelItem(i)->text(0);
        return all;
    }
};

} // namespace

TEST_F(DevicesDock, TheTreeOfTheProjectLeadsToIt) {
    QTreeWidget& tree = window->projectTree().tree();
    const QList<QTreeWidgetItem*> found = tree.findItems("Devices", Qt::MatchExactly);
    ASSERT_EQ(found.size(), 1);
    window->dock("devices")->hide();
    emit tree.itemActivated(found.front(), 0);
    EXPECT_TRUE(window->dock("devices")->isVisible());
}

TEST_F(DevicesDock, WithoutDevicesItSaysHowToBegin) {
    auto* begin = view().findChild<QWidget*>("devicesBegin");
    ASSERT_TRUE(waitFor([&] { return begin->isVisible(); }));
    auto* add = begin->findChild<QPushButton*>();
    inNextMenu(window.get(), [](QMenu& menu) {
        QTest::keyClick(&menu, Qt::Key_Down);
        QTest::keyClick(&menu, Qt::Key_Return);
    });
    QTest::mouseClick(add, Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return onDisk().find("modbus-tcp") != std::string::npos; })) << onDisk();
    EXPECT_FALSE(begin->isVisible());
    view().undo();
    EXPECT_TRUE(begin->isVisible());
}

TEST_F(DevicesDock, ADeviceIsDescribedCheckedAndUndone) {
    view().addDevice(devices::Protocol::ModbusTcp);
    EXPECT_NE(onDisk().find("\"Device\""), std::string::npos);
    view().addChannel();
    EXPECT_FALSE(problems().filter("has no variable yet").isEmpty()) << problems().join('\n').toStdString();
    set("Variable", "%QW0");
    set("Direction", "Input");
    EXPECT_FALSE(problems().filter("is an output of the program").isEmpty()) << problems().join('\n').toStdString();
    set("Variable", "%IW0");
    EXPECT_TRUE(problems().isEmpty()) << problems().join('\n').toStdString();
    const std::string good = onDisk();
    set("Address", "many");
    EXPECT_FALSE(problems().isEmpty());
    view().undo();
    EXPECT_EQ(onDisk(), good);
    // A click on a problem selects its channel.
    set("Variable", "Main.nothing");
    view().select("Device");
    QTreeWidget& list = window->problems().list();
    for (int i = 0; i < list.topLevelItemCount(); ++i)
        if (list.topLevelItem(i)->text(1) == "D1000") emit list.itemActivated(list.topLevelItem(i), 0);
    ASSERT_TRUE(view().tree().currentItem());
    EXPECT_EQ(view().tree().currentItem()->text(0), "Channel");
    view().remove();
    view().remove();
    EXPECT_TRUE(view().file().devices().empty());
}

TEST_F(DevicesDock, NoFieldOrWordIsShownAsTheFileSpellsIt) {
    using devices::Protocol;
    QStringList fields;
    for (const Protocol each : {Protocol::ModbusTcp, Protocol::ModbusRtu, Protocol::ModbusServer, Protocol::Mqtt})
        fields += fieldsOf(each) + channelFieldsOf(each);
    const QStringList wordsOfTheField{"type", "order"}; // REAL and ABCD are called so by everybody
    for (const QString& field : fields) {
        EXPECT_NE(fieldTitle(field), field) << field.toStdString();
        if (wordsOfTheField.contains(field)) continue;
        for (const QString& word : wordsOf(field)) EXPECT_NE(wordTitle(field, word), word) << word.toStdString();
    }
    view().addDevice(Protocol::ModbusRtu);
    set("Parity", "Odd");
    EXPECT_NE(onDisk().find("\"parity\": \"odd\""), std::string::npos) << onDisk();
    set("Parity", "");
    EXPECT_EQ(onDisk().find("parity"), std::string::npos) << onDisk();
    EXPECT_EQ(wordTitle("parity", "prime"), "prime") << "a word that the file has by mistake is seen";
}

TEST_F(DevicesDock, AddressesAreProposed) {
    view().addDevice(devices::Protocol::Mqtt);
    view().addChannel();
    view().proposeAddresses();
    EXPECT_EQ(view().file().devices()[0].channels[0].variable, "%IL8");
}

TEST_F(DevicesDock, TheRunningProgramExchangesValuesOnlyWhenConnected) {
    devices::Device far;
    far.name = "Far";
    far.protocol = devices::Protocol::ModbusServer;
    far.host = "127.0.0.1";
    far.port = freePort();
    far.timeout = {};
    devices::Channel taken;
    taken.name = "taken";
    taken.address = 7;
    far.channels.push_back(taken);
    devices::Engine server({far});
    server.connect();
    ASSERT_TRUE(waitFor([&] { return server.status()[0].state == devices::LinkState::Online; }));
    view().addDevice(devices::Protocol::ModbusTcp);
    set("Port", QString::number(far.port));
    set("Poll interval", "10ms");
    view().addChannel();
    set("Address", "7");
    set("Direction", "Output");
    set("Variable", "%QW0");
    ASSERT_TRUE(problems().isEmpty()) << problems().join('\n').toStdString();
    window->action("run.devices")->trigger();
    EXPECT_FALSE(view().tree().topLevelItem(0)->text(3) == "online") << "there is no controller";
    window->control().start();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 10; }));
    EXPECT_EQ(server.status()[0].channels[0].value, "") << "not connected";
    window->action("run.devices")->trigger();
    EXPECT_TRUE(waitFor([&] { return server.status()[0].channels[0].value == "1234"; }));
    EXPECT_TRUE(waitFor([&] { return view().tree().topLevelItem(0)->text(3) == "online"; }));
    EXPECT_TRUE(waitFor([&] { return view().tree().topLevelItem(0)->child(0)->text(4) == "1234"; }));
    const auto* summary = view().findChild<QLabel*>("devicesSummary");
    EXPECT_TRUE(waitFor([&] { return summary->text() == "online: 1 of 1"; })) << summary->text().toStdString();
    const QHeaderView& header = *view().tree().header();
    EXPECT_LT(header.sectionPosition(4) + header.sectionSize(4), 400) << "what is live is seen in a small window";
    if (const QString picture = qEnvironmentVariable("STEPWISE_PICTURE"); !picture.isEmpty()) {
        window->resize(1024, 700);
        window->dock("devices")->raise();
        settle();
        window->grab().save(picture);
    }
    window->action("run.devices")->trigger();
    EXPECT_TRUE(waitFor([&] { return server.status()[0].channels[0].value == "0"; }))
        << "outputs are safe before the connection ends";
    EXPECT_TRUE(waitFor([&] { return view().tree().topLevelItem(0)->text(3) == ""; }));
}

} // namespace plc::app
