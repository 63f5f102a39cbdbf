// devices.json: what it reads, what it says about wrong ones, and that an edit changes nothing else.
#include "projects/devices/configuration/device_check.h"
#include "projects/devices/configuration/proposal.h"
#include "tests/projects/devices/peers.h"

using namespace plc;
using namespace plc::devices;
using plc::testing::buildProgram;

namespace {

const char* const kProgram = R"(
VAR_GLOBAL CONSTANT limit : INT := 3; END_VAR
PROGRAM Main
VAR
    level AT %IW0 : INT; speed AT %QW0 : UINT; other AT %IW2 : WORD; small : SINT; flag : BOOL; factor : REAL; text : STRING(20); date : DATE; good : BOOL;
END_VAR
END_PROGRAM
)";

std::string inDevice(const std::string& fields, const std::string& channels) {
    return "{\"devices\": [{\"name\": \"Pump\", " + fields + ", \"channels\": [" + channels + "]}]}";
}
std::string tcp(const std::string& channels) {
    return inDevice("\"protocol\": \"modbus-tcp\", \"host\": \"plc.local\"", channels);
}
std::string mqtt(const std::string& channels) {
    return inDevice("\"protocol\": \"mqtt\", \"host\": \"broker\"", channels);
}
std::string channel(const std::string& fields) { return "{\"name\": \"c\", " + fields + "}"; }

struct Row {
    std::string json, message;
    bool isError = true;
};

} // namespace

TEST(DeviceFile, EveryMistakeIsNamedWithItsRemedy) {
    const driver::Built built = buildProgram(kProgram);
    const std::string level = R"("variable": "%IW0", "address": 4)";
    const Row rows[] = {
        {"{", "not valid JSON"},
        {"[]", "named \"devices\""},
        {R"({"devices": [7]})", "must be an object"},
        {R"({"devices": [{"protocol": "mqtt", "host": "b"}]})", "\"name\" is missing; add it"},
        {R"({"devices": [{"name": "a", "host": "b"}]})", "\"protocol\" is missing; add it"},
        {inDevice(R"("protocol": "profinet")", ""), "choose one of: modbus-tcp"},
        {inDevice(R"("protocol": "modbus-tcp")", ""), "\"host\" is missing; add it"},
        {inDevice(R"("protocol": "modbus-tcp", "host": "a b")", ""), "neither a host name nor an address"},
        {inDevice(R"("protocol": "modbus-tcp", "host": "h", "port": 70000)", ""), "from 1 to 65535"},
        {inDevice(R"("protocol": "modbus-tcp", "host": "h", "poll": "fast")", ""), "such as \"100ms\""},
        {inDevice(R"("protocol": "modbus-tcp", "host": "h", "poll": 5)", ""), "such as \"100ms\""},
        {inDevice(R"("protocol": "modbus-tcp", "host": 5)", ""), "must be a text"},
        {inDevice(R"("protocol": "modbus-tcp", "host": "h", "enabled": 1)", ""), "true or false"},
        {inDevice(R"("protocol": "modbus-tcp", "host": "h", "polll": "5ms")", ""), "did you mean \"poll\"", false},
        {inDevice(R"("protocol": "modbus-tcp", "host": "h")", ""), "no channels", false},
        {inDevice(R"("protocol": "modbus-rtu", "serial": "COM1")", ""), "not a serial port"},
        {inDevice(R"("protocol": "modbus-server", "port": 502)", channel(level)), "below 1024", false},
        {inDevice(R"("protocol": "mqtt", "host": "b", "passwordFile": "none")", ""), "cannot be read"},
        {inDevice(R"("protocol": "mqtt", "host": "b", "caFile": "none")", ""), "cannot be read"},
        {inDevice(R"("protocol": "mqtt", "host": "b", "online": "Main.factor")", ""), "must be a BOOL"},
        {tcp(channel(R"("variable": "%IW0")")), "\"address\" is missing; add it"},
        {tcp(channel(R"("variable": "%IW0", "address": 65536)")), "from 0 to 65535"},
        {tcp(channel(R"("variable": "%IW0", "address": 1.5)")), "from 0 to 65535"},
        {tcp(channel(R"("variable": "Main.factor", "address": 65535, "type": "REAL")")), "65535 is the last"},
        {tcp(channel(level + R"(, "table": "holdng")")), "choose one of: coil, discrete, holding, input"},
        {tcp(channel(level + R"(, "scale": 0)")), "must not be 0"},
        {tcp(channel(level + R"(, "scale": "x")")), "must be a number"},
        {tcp(channel(level + R"(, "onLoss": "safe")")), "needs the value in \"safe\""},
        {tcp(channel(level + R"(, "bit": 3)")), "must then be BOOL"},
        {tcp(channel(level + R"(, "type": "STRING")")), "Only an MQTT channel"},
        {tcp(channel(R"("variable": "Main.flag", "address": 1, "type": "BOOL")")), "needs \"bit\""},
        {tcp(channel(R"("variable": "Main.flag", "address": 1, "table": "coil", "scale": 2)")), "no \"scale\""},
        {tcp(channel(R"("variable": "%IW0", "address": 1, "table": "coil", "type": "INT")")), "holds bits"},
        {tcp(channel(R"("variable": "%QW0", "address": 1, "table": "input", "type": "UINT")")),
         "does not let others write"},
        {inDevice(R"("protocol": "modbus-server")",
                  channel(R"("variable": "%IW0", "address": 1, "table": "input", "direction": "in")")),
         "Clients cannot write"},
        {tcp(channel(R"("variable": "", "address": 1)")), "no variable yet"},
        {tcp(channel(R"("variable": "Main.levl", "address": 1)")), "levl"},
        {tcp(channel(R"("variable": "%IW9000", "address": 1)")), "%IW9000"},
        {tcp(channel(R"("variable": "Main.date", "address": 1)")), "is of type DATE"},
        {tcp(channel(R"("variable": "Main.flag", "address": 1)")), "is of type BOOL"},
        {tcp(channel(R"("variable": "Main.text", "address": 1)")), "is of type STRING(20)"},
        {tcp(channel(R"("variable": "Main.small", "address": 1)")), "may not fit", false},
        {tcp(channel(R"("variable": "%QW0", "address": 1, "type": "UINT", "direction": "in")")),
         "an output of the program"},
        {tcp(channel(R"("variable": "%IW0", "address": 1, "direction": "out")")), "an input of the program"},
        {tcp(channel(R"("variable": "limit", "address": 1)")), "is a constant"},
        {tcp(channel(level + R"(, "quality": "Main.factor")")), "must be a BOOL or an integer"},
        {tcp(channel(level + R"(, "quality": "Main.nothing")")), "nothing"},
        {tcp(R"({"name": "1x", "variable": "%IW0", "address": 1})"), "is not a name"},
        {tcp(R"({"name": "a", "variable": "%IW0", "address": 1}, {"name": "A", "variable": "%IW2", "address": 2})"),
         "two channels named A"},
        {tcp(R"({"name": "a", "variable": "%IW0", "address": 1}, {"name": "b", "variable": "Main.level", "address": 2})"),
         "write the same bytes"},
        {tcp(R"({"name": "a", "variable": "%IW0", "address": 1, "quality": "Main.good"}, {"name": "b", "variable": "%IW2", "address": 2, "quality": "Main.good"})"),
         "write the same bytes"},
        {tcp(R"({"name": "a", "variable": "Main.factor", "direction": "out", "type": "REAL", "address": 1}, {"name": "b", "variable": "%QW0", "type": "UINT", "address": 2})"),
         "both set holding 2"},
        {mqtt(channel(R"("variable": "Main.factor")")), "needs a \"topic\""},
        {mqtt(channel(R"("variable": "Main.factor", "topic": "a/#")")), "without the wildcards"},
        {mqtt(channel(R"("variable": "Main.factor", "topic": "a", "json": "b")")), "not a path into JSON"},
        {mqtt(channel(R"("variable": "Main.factor", "topic": "a", "qos": 3)")), "from 0 to 2"},
        {R"({"devices": [{"name": "a", "protocol": "mqtt", "host": "b"}, {"name": "A", "protocol": "mqtt", "host": "b"}]})",
         "two devices named A"},
        {R"({"devices": [{"name": "a", "protocol": "modbus-server"}, {"name": "b", "protocol": "modbus-server"}]})",
         "both listen on port 1502"},
        {R"({"devices": [{"name": "a", "protocol": "modbus-rtu", "serial": "/dev/x"}, {"name": "b", "protocol": "modbus-rtu", "serial": "/dev/x"}]})",
         "both unit 1"},
        {R"({"devices": [{"name": "a", "protocol": "modbus-rtu", "serial": "/dev/x"}, {"name": "b", "unit": 2, "baud": 9600, "protocol": "modbus-rtu", "serial": "/dev/x"}]})",
         "different baud rates"},
        {R"({"devices": [{"name": "a", "protocol": "modbus-tcp", "host": "h"}, {"name": "b", "protocol": "modbus-tcp", "host": "h"}]})",
         "a and b are both unit 1 at h", false},
    };
    for (const Row& row : rows) {
        bool isFound = false;
        std::string all;
        for (const Finding& finding : checkDevices(DeviceFile::parse(row.json), &built.program->layout, "/nowhere")) {
            all += finding.english("devices.json") + "\n";
            isFound |=
                finding.isError == row.isError && finding.message.english().find(row.message) != std::string::npos;
        }
        EXPECT_TRUE(isFound) << row.json << "\nhas not \"" << row.message << "\" but\n" << all;
    }
}

TEST(DeviceFile, AGoodFileHasNoFindings) {
    const driver::Built built = buildProgram(kProgram);
    const std::string json = tcp(
        R"({"name": "level", "variable": "%IW0", "address": 0, "quality": "Main.good", "onLoss": "safe", "safe": -1},
           {"name": "speed", "variable": "%QW0", "type": "UINT", "address": 10, "safe": 0},
           {"name": "b3", "variable": "Main.flag", "address": 7, "type": "BOOL", "bit": 3})");
    for (const Finding& finding : checkDevices(DeviceFile::parse(json), &built.program->layout, {}))
        ADD_FAILURE() << finding.english("devices.json");
}

TEST(DeviceFile, FindingsNameTheirLine) {
    const DeviceFile file =
        DeviceFile::parse("{\n  \"devices\": [\n    {\n      \"name\": \"a\",\n      \"protocol\": "
                          "\"mqtt\",\n      \"host\": \"b\",\n      \"port\": \"{[x\"\n    }\n  ]\n}\n");
    ASSERT_EQ(file.findings().size(), 1u);
    EXPECT_EQ(file.findings()[0].line, 7);
    EXPECT_EQ(file.findings()[0].english("devices.json"),
              "devices.json:7: error: a: \"port\" must be a whole number from 1 to 65535");
}

TEST(DeviceFile, AnEditKeepsWhatItDoesNotKnow) {
    const std::string text =
        "{\n  \"devices\": [\n    {\n      \"name\": \"a\",\n      \"colour\": \"red\",\n      "
        "\"protocol\": \"mqtt\",\n      \"host\": \"b\",\n      \"channels\": [\n        {\n          \"name\": "
        "\"t\",\n"
        "          \"variable\": \"\",\n          \"topic\": \"x\"\n        }\n      ]\n    }\n  ]\n}\n";
    DeviceFile file = DeviceFile::parse(text);
    EXPECT_EQ(file.text(), text);
    file.setField(0, 0, "scale", "0.5");
    file.setField(0, {}, "port", "1884");
    EXPECT_EQ(file.devices()[0].channels[0].scale, 0.5);
    EXPECT_EQ(file.devices()[0].port, 1884);
    file.setField(0, 0, "scale", "");
    file.setField(0, {}, "port", "");
    EXPECT_EQ(file.text(), text);
    file.addChannel(0, "u");
    EXPECT_EQ(file.devices()[0].channels.size(), 2u);
    file.removeChannel(0, 1);
    EXPECT_EQ(file.text(), text);
    file.addDevice(Protocol::ModbusServer, "s");
    EXPECT_EQ(file.devices().size(), 2u);
    file.removeDevice(1);
    EXPECT_EQ(file.text(), text);
    file.setField(0, {}, "port", "many");
    EXPECT_FALSE(file.findings().empty()) << "what a person writes is kept and named";
}

TEST(DeviceFile, AddressesAreProposedBehindWhatIsUsed) {
    const driver::Built built = buildProgram(kProgram); // %IW0, %IW2 and %QW0 are used
    DeviceFile file = DeviceFile::parse(
        tcp(R"({"name": "a", "variable": "", "address": 0}, {"name": "b", "variable": "", "address": 1, "type": "REAL"},
               {"name": "c", "variable": "", "table": "discrete", "address": 1},
               {"name": "d", "variable": "", "table": "coil", "address": 1, "direction": "out"},
               {"name": "e", "variable": "Main.level", "address": 1})"));
    const std::vector<Proposal> proposals = proposeAddresses(file, &built.program->layout);
    ASSERT_EQ(proposals.size(), 4u);
    EXPECT_EQ(proposals[0].address, "%IW4");
    EXPECT_EQ(proposals[1].address, "%ID8");
    EXPECT_EQ(proposals[2].address, "%IX12.0");
    EXPECT_EQ(proposals[3].address, "%QX2.0");
    // Declared as proposed, the program and the file go together.
    const driver::Built grown = buildProgram(declarationsOf(proposals) + kProgram);
    ASSERT_TRUE(grown.program);
    for (const Proposal& proposal : proposals)
        file.setField(proposal.device, proposal.channel, "variable", proposal.address);
    file.setField(0, 4, "variable", "Main.factor");
    EXPECT_FALSE(hasErrors(checkDevices(file, &grown.program->layout, {})));
}
