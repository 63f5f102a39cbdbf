#include "hmi/check/standard_settings.h"

#include "hmi/model/errors.h"
#include "runtime/base/text.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plc::hmi {

namespace {

#define HMI_RULE(Kind, Name, Level, Why) constexpr messages::TypedForm<> k##Kind{"Errors", "Why" #Kind, Why};
#include "hmi/check/standard_rules.def"

constexpr std::array<std::string_view, 4> kLevels = {"off", "basic", "standard", "strict"};

std::vector<std::string> ruleNames() {
    std::vector<std::string> out;
    for (const StandardRuleRow& row : standardRules()) out.emplace_back(row.name);
    return out;
}

/// The complaint about a name that no rule has, or nothing.
Message complaintAbout(const QString& rule) {
    const std::string name = toUtf8(rule);
    const std::vector<std::string> names = ruleNames();
    if (std::find(names.begin(), names.end(), name) != names.end()) return {};
    if (const std::optional<std::string> near = nearestName(name, names))
        return errors::CheckRuleUnknownSuggest(name, *near);
    return errors::CheckRuleUnknown(name);
}

std::string_view nameOf(StandardRule rule) { return standardRules()[static_cast<size_t>(rule)].name; }

class Reader {
public:
    Reader(const Json& json, StandardSettings& out) : m_json(json), m_out(out) {}

    void run() {
        for (const auto& [key, value] : m_json.items())
            if (!read(key, value)) complain(key, errors::PropertyUnknown(key));
    }

private:
    void complain(const std::string& key, Message message) {
        m_out.problems.emplace_back(QStringLiteral("checks.") + QString::fromStdString(key), std::move(message));
    }

    bool read(const std::string& key, const Json& value) {
        if (key == "level") return readLevel(value), true;
        if (key == "viewingDistance") return readNumber(key, value, {100, 20000}, m_out.viewingDistance), true;
        if (key == "pixelPitch") return readNumber(key, value, {0.02, 5}, m_out.pixelPitch), true;
        if (key == "critical") return readNames(key, value, m_out.critical), true;
        if (key == "errors") return readRules(value), true;
        if (key == "off") return readOff(value), true;
        return false;
    }

    void readLevel(const Json& value) {
        const auto level = value.is_string() ? checkLevelOf(value.get<std::string>()) : std::nullopt;
        if (level)
            m_out.level = *level;
        else
            complain("level", errors::ChoiceUnknown(value.is_string() ? value.get<std::string>() : value.dump(),
                                                    std::vector<std::string>(kLevels.begin(), kLevels.end())));
    }

    void readNumber(const std::string& key, const Json& value, std::pair<double, double> range, double& out) {
        if (!value.is_number()) return complain(key, errors::MustBeNumber());
        const auto words = [](double number) { return toUtf8(QString::number(number)); };
        const double number = value.get<double>();
        out = std::clamp(number, range.first, range.second);
        if (out != number)
            complain(key, errors::NumberOutOfRange(words(number), words(range.first), words(range.second), words(out)));
    }

    void readNames(const std::string& key, const Json& value, QStringList& out) {
        if (!value.is_array()) return complain(key, errors::MustBeListOfNames());
        for (const Json& one : value)
            if (one.is_string())
                out += toQString(one);
            else
                complain(key, errors::MustBeListOfNames());
    }

    void readRules(const Json& value) {
        QStringList names;
        readNames("errors", value, names);
        for (const QString& name : names) {
            if (Message wrong = complaintAbout(name); !wrong.isEmpty()) complain("errors", std::move(wrong));
            m_out.errors += name;
        }
    }

    void readOff(const Json& value) {
        if (!value.is_object()) return complain("off", errors::MustBeReasons());
        for (const auto& [place, reason] : value.items()) {
            const QString key = QString::fromStdString(place);
            if (Message wrong = complaintAbout(key.section(u'@', 0, 0)); !wrong.isEmpty())
                complain("off." + place, std::move(wrong));
            // A rule without a reason stays on: whoever reads the project later could not tell a choice from a slip.
            if (!reason.is_string() || toQString(reason).trimmed().isEmpty())
                complain("off." + place, errors::RuleOffWithoutReason());
            else
                m_out.off.insert(key, toQString(reason));
        }
    }

    const Json& m_json;
    StandardSettings& m_out;
};

} // namespace

const std::vector<StandardRuleRow>& standardRules() {
    static const std::vector<StandardRuleRow> rows = {
#define HMI_RULE(Kind, Name, Level, Why) {StandardRule::Kind, Name, CheckLevel::Level, k##Kind()},
#include "hmi/check/standard_rules.def"
    };
    return rows;
}

std::optional<CheckLevel> checkLevelOf(std::string_view name) {
    const auto found = std::find(kLevels.begin(), kLevels.end(), name);
    if (found == kLevels.end()) return {};
    return static_cast<CheckLevel>(found - kLevels.begin());
}

StandardSettings StandardSettings::fromJson(const Json& hmi) {
    StandardSettings out;
    out.level = CheckLevel::Standard;
    if (!hmi.is_object()) return out;
    const auto checks = hmi.find("checks");
    if (checks == hmi.end()) return out;
    if (checks->is_object())
        Reader(*checks, out).run();
    else
        out.problems.emplace_back(QStringLiteral("checks"), errors::MustBeChecks());
    return out;
}

bool StandardSettings::isChecked(StandardRule rule) const {
    return level >= standardRules()[static_cast<size_t>(rule)].level;
}

bool StandardSettings::isOff(StandardRule rule, const QString& panel, const QString& element) const {
    const QString name = QString::fromStdString(std::string(nameOf(rule)));
    const QString onPanel = name + u'@' + panel;
    return off.contains(name) || off.contains(onPanel) || off.contains(onPanel + u'/' + element);
}

bool StandardSettings::isError(StandardRule rule) const {
    return errors.contains(QString::fromStdString(std::string(nameOf(rule))));
}

bool StandardSettings::isCritical(const QString& variable) const {
    return std::any_of(critical.begin(), critical.end(), [&](const QString& pattern) {
        const QString expression =
            QRegularExpression::wildcardToRegularExpression(pattern, QRegularExpression::UnanchoredWildcardConversion);
        return QRegularExpression(QRegularExpression::anchoredPattern(expression),
                                  QRegularExpression::CaseInsensitiveOption)
            .match(variable)
            .hasMatch();
    });
}

double StandardSettings::smallestFont() const {
    constexpr double Angle = 16.0 / 60 * std::numbers::pi / 180, CapitalsPerSize = 0.714; // of Noto Sans
    return std::floor(viewingDistance * std::tan(Angle) / pixelPitch / CapitalsPerSize);
}

double StandardSettings::smallestTarget() const {
    constexpr double Finger = 7, Glove = 9; // mm
    return std::round((level >= CheckLevel::Strict ? Glove : Finger) / pixelPitch);
}

} // namespace plc::hmi
