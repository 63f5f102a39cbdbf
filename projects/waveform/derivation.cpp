#include "projects/waveform/derivation.h"

#include "projects/waveform/errors.h"
#include "projects/waveform/table_parts.h"
#include "runtime/base/text.h"

#include <cmath>
#include <cstdlib>
#include <optional>

namespace plc::waveform {

namespace {

constexpr std::pair<const char*, OperationKind> kWords[] = {{"DERIVATIVE", OperationKind::Derivative},
                                                            {"INTEGRAL", OperationKind::Integral},
                                                            {"FILTER", OperationKind::Filter}};

/// The word, with the parenthesis after it in `open`; nothing where the text is not such a call.
std::optional<std::pair<const char*, OperationKind>> callAt(const std::string& text, size_t& open) {
    open = text.find('(');
    if (open == std::string::npos) return std::nullopt;
    const std::string word = trimmed(text.substr(0, open));
    for (const auto& known : kWords)
        if (equalsIgnoringCase(word, known.first)) return known;
    return std::nullopt;
}

/// Where the parenthesis at `open` closes, and the commas directly inside it.
size_t closingOf(const std::string& text, size_t open, std::vector<size_t>& commas) {
    int depth = 0;
    char quote = 0;
    for (size_t i = open; i < text.size(); ++i) {
        const char c = text[i];
        if (quote) {
            if (c == quote) quote = 0;
        } else if (c == '\'' || c == '"') {
            quote = c;
        } else if (c == '(' || c == '[') {
            ++depth;
        } else if (c == ')' || c == ']') {
            if (--depth == 0) return i;
        } else if (c == ',' && depth == 1) {
            commas.push_back(i);
        }
    }
    return std::string::npos;
}

/// T#1s500ms, TIME#2m, or a number of seconds.
std::optional<double> secondsOf(const std::string& text) {
    const size_t hash = text.find('#');
    const char* at = text.c_str() + (hash == std::string::npos ? 0 : hash + 1);
    double sum = 0;
    while (*at) {
        char* end = nullptr;
        const double value = std::strtod(at, &end);
        if (end == at || !std::isfinite(value)) return std::nullopt;
        std::string unit;
        for (at = end; (*at >= 'a' && *at <= 'z') || (*at >= 'A' && *at <= 'Z'); ++at) unit += *at;
        while (*at == '_') ++at;
        double factor = 0;
        for (const auto& [name, seconds] :
             {std::pair{"d", 86400.0}, std::pair{"h", 3600.0}, std::pair{"m", 60.0}, std::pair{"s", 1.0},
              std::pair{"ms", 1e-3}, std::pair{"us", 1e-6}, std::pair{"ns", 1e-9}, std::pair{"", 1.0}})
            if (equalsIgnoringCase(unit, name)) factor = seconds;
        if (factor == 0 || (unit.empty() && hash != std::string::npos)) return std::nullopt;
        sum += value * factor;
    }
    return sum > 0 ? std::optional(sum) : std::nullopt;
}

} // namespace

Result<Derivation> parseDerivation(const std::string& text) {
    Derivation out{trimmed(text), {}};
    for (;;) {
        size_t open = 0;
        const auto call = callAt(out.expression, open);
        if (!call) return out;
        std::vector<size_t> commas;
        const size_t close = closingOf(out.expression, open, commas);
        if (close == std::string::npos || close + 1 != out.expression.size())
            return Error{errors::OperationNeedsParenthesis(Verbatim(call->first)), text};
        Operation operation{call->second, 0};
        const size_t end = operation.kind == OperationKind::Filter && !commas.empty() ? commas.back() : close;
        if (operation.kind == OperationKind::Filter) {
            const auto time =
                commas.empty() ? std::nullopt : secondsOf(trimmed(out.expression.substr(end + 1, close - end - 1)));
            if (!time)
                return Error{errors::OperationNeedsTime(Verbatim(call->first), Verbatim("FILTER(Main.Level, T#1s)")),
                             text};
            operation.time = *time;
        } else if (!commas.empty()) {
            return Error{errors::OperationTakesOne(Verbatim(call->first)), text};
        }
        out.operations.insert(out.operations.begin(), operation);
        out.expression = trimmed(out.expression.substr(open + 1, end - open - 1));
    }
}

Deriver::Deriver(const Derivation& derivation) {
    for (const Operation& operation : derivation.operations) m_stages.push_back({operation});
}

void Deriver::restart() {
    for (Stage& stage : m_stages) stage = {stage.operation};
}

double Deriver::step(Stage& stage, double time, double value) {
    const double span = time - stage.lastTime;
    double out = stage.state;
    switch (stage.operation.kind) {
    case OperationKind::Derivative:
        out = stage.hasLast && span > 0 ? (value - stage.last) / span : stage.hasLast ? stage.state : 0;
        break;
    case OperationKind::Integral: // a value holds until the next
        out = stage.hasLast ? stage.state + stage.last * span : 0;
        break;
    case OperationKind::Filter: // exact for a value that holds until the next
        out = stage.hasLast ? stage.last + (stage.state - stage.last) * std::exp(-span / stage.operation.time) : value;
        break;
    }
    stage.hasLast = true;
    stage.lastTime = time;
    stage.last = value;
    stage.state = out;
    return out;
}

double Deriver::next(double time, double value) {
    if (!std::isfinite(value)) {
        restart();
        return value;
    }
    for (Stage& stage : m_stages) value = step(stage, time, value);
    return value;
}

} // namespace plc::waveform
