// A panel of 1,000 elements, all of which change from scan to scan: what browsers are measured with. Functions.
#pragma once
#include <QDir>
#include <QFile>

#include <array>
#include <string>

namespace plc::serve {

/// Bars, lamps, numbers, switches, entries and tanks, side by side on 1920 × 1080.
inline std::string thousandElements() {
    constexpr std::array kKinds = {"number", "lamp", "bar", "number", "progress", "switch", "numberEntry", "tankLevel"};
    std::string out;
    for (size_t i = 0; i < 1000; ++i) {
        const std::string kind = kKinds[i % kKinds.size()], at = std::to_string(i);
        const bool isBool = kind == "lamp" || kind == "switch", isTarget = kind == "switch" || kind == "numberEntry";
        out += (i ? "," : "") + std::string(R"({"id":"e)") + at + R"(","kind":")" + kind + R"(","rect":[)" +
               std::to_string(4 + i % 40 * 48) + "," + std::to_string(4 + i / 40 * 43) + R"(,44,39],")" +
               (isTarget ? "target" : "value") + R"(":"Main.)" + (isBool ? "b[" : "r[") + at + R"(]")" +
               (kind == "number" || kind == "numberEntry" ? R"(,"fontSize":11)" : "") + "}";
    }
    return out;
}

inline std::string thousandElementPanel() {
    return R"({"size": [1920, 1080], "elements": [)" + thousandElements() + "]}";
}

inline constexpr const char* kThousandValues =
    "PROGRAM Main VAR b : ARRAY[0..999] OF BOOL; r : ARRAY[0..999] OF REAL; i, n : DINT; END_VAR\n"
    "n := n + 1; FOR i := 0 TO 999 DO r[i] := 50.0 + 45.0 * SIN(DINT_TO_REAL(n) * 0.1 + DINT_TO_REAL(i)); "
    "b[i] := (n / 10 + i) MOD 2 = 0; END_FOR;\nEND_PROGRAM\nCONFIGURATION C RESOURCE R ON PLC "
    "TASK T(INTERVAL := T#20ms, PRIORITY := 1); PROGRAM Main WITH T : Main; END_RESOURCE END_CONFIGURATION\n";

/// As a project for a server in a process of its own.
inline bool writeThousandElements(const QString& folder) {
    const auto write = [&](const QString& name, const std::string& text) {
        QFile file(folder + u'/' + name);
        return QDir().mkpath(QFileInfo(file).path()) && file.open(QIODevice::WriteOnly) &&
               file.write(QByteArray::fromStdString(text)) == static_cast<qint64>(text.size());
    };
    return write("project.json", R"({"name": "thousand", "hmi": {"startPanel": "main", "languages": ["en"]}})") &&
           write("src/main.st", kThousandValues) && write("hmi/main.panel.json", thousandElementPanel());
}

} // namespace plc::serve
