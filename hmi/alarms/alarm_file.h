// hmi/alarms.json: which conditions are alarms, of which class and priority, with which text. A value, any thread.
#pragma once
#include "hmi/model/panel.h"

namespace plc::hmi {

struct AlarmClass {
    QString name;  // as alarms refer to it
    QString title; // shown: "@key" or text
    QString color; // role of the theme or "#rrggbb"; empty: by priority
};

struct AlarmDefinition {
    QString id, condition, className, text, inhibit;
    QString help;                     // what it means and what to do: "@key" or text
    QString show;                     // the panel where its place is seen
    QString firstOut;                 // of the alarms of one group, the one that came first is marked
    int priority = 2;                 // 1 is the most urgent
    double onDelay = 0, offDelay = 0; // seconds
    bool mustAcknowledge = true;
    std::vector<std::pair<QString, QString>> values; // placeholder name → expression
};

class AlarmFile {
public:
    AlarmFile() = default;
    /// With `problems`, a row that is wrong costs only itself: it is named there, and nothing of it is lost when the
    /// file is written. Without, the first of them is the error.
    static Result<AlarmFile> parse(const std::string& utf8, const QString& place,
                                   std::vector<Error>* problems = nullptr);
    std::string write() const;

    const std::vector<Properties>& rows() const { return m_alarms; }
    std::vector<Properties>& rows() { return m_alarms; }
    const std::vector<Properties>& classRows() const { return m_classes; }
    std::vector<Properties>& classRows() { return m_classes; }
    std::vector<AlarmDefinition> definitions() const;
    std::vector<AlarmClass> classes() const;
    Properties newRow() const;

private:
    Json m_fields = Json{{"version", 1}, {"classes", nullptr}, {"alarms", nullptr}};
    std::vector<Properties> m_classes, m_alarms;
    std::vector<Json> m_unreadClasses, m_unreadAlarms; // what is no object; written behind the others
};

} // namespace plc::hmi
