// How strictly a project wants its panels checked against ISA-101 and ISA-18.2: "checks" under "hmi" in project.json.
// A value, any thread.
#pragma once
#include "hmi/model/json.h"
#include "runtime/base/result.h"

#include <QMap>
#include <QStringList>

#include <string_view>
#include <vector>

namespace plc::hmi {

enum class CheckLevel { Off, Basic, Standard, Strict };

enum class StandardRule {
#define HMI_RULE(Kind, ...) Kind,
#include "hmi/check/standard_rules.def"
};

struct StandardRuleRow {
    StandardRule rule;
    std::string_view name; // "touch-target"
    CheckLevel level;
    Message why;
};
/// All rules in the order of their codes.
const std::vector<StandardRuleRow>& standardRules();
std::optional<CheckLevel> checkLevelOf(std::string_view name);

struct StandardSettings {
    CheckLevel level = CheckLevel::Off;
    double viewingDistance = 450; // mm: a panel operated by touch
    double pixelPitch = 0.25;     // mm, of the screen that the panels are made for
    QStringList critical;         // variables whose writes are confirmed, "Plant.Dose*"
    QStringList errors;           // names of rules that are errors
    /// "rule", "rule@panel" or "rule@panel/element" → why it is not checked there.
    QMap<QString, QString> off;
    std::vector<std::pair<QString, Message>> problems; // property of project.json, what is wrong with it

    /// Reads "hmi" of project.json; the standard level where it says nothing.
    static StandardSettings fromJson(const Json& hmi);
    bool isChecked(StandardRule rule) const;
    bool isOff(StandardRule rule, const QString& panel, const QString& element) const;
    bool isError(StandardRule rule) const;
    bool isCritical(const QString& variable) const;
    /// The smallest font, in pixels, whose capitals can be read at the viewing distance.
    double smallestFont() const;
    /// Pixels that a finger needs.
    double smallestTarget() const;
};

} // namespace plc::hmi
