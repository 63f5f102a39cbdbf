#include "projects/tuning/block_forms.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <cmath>

namespace plc::tuning {

namespace {

constexpr double kAnyGain = 3.4e38;
constexpr double kLongestTime = 4294967.295; // of a TIME in milliseconds
constexpr double kMinute = 60;
/// FB_PID and FB_PI_PID take less than a minute.
constexpr double kBelowMinute = 59.999;

std::vector<BlockForm> makeForms() {
    using enum Quantity;
    using enum Unit;
    const auto util = [](std::string_view type, std::string_view cycle) {
        return BlockForm{type,
                         "",
                         "Y",
                         "ACTUAL",
                         "SET_POINT",
                         "Y_MIN",
                         "Y_MAX",
                         "MANUAL",
                         "core.wasManual",
                         "",
                         "",
                         cycle,
                         Seconds,
                         false,
                         {{"KP", Gain, Plain, -kAnyGain, kAnyGain},
                          {"TN", IntegralTime, Seconds, 0, kAnyGain},
                          {"TV", DerivativeTime, Seconds, 0, kAnyGain}}};
    };
    const auto annexF = [](std::string_view type) {
        return BlockForm{type,
                         "",
                         "XOUT",
                         "PV",
                         "SP",
                         "",
                         "",
                         "AUTO",
                         "",
                         "ITERM.sum",
                         "DTERM.XOUT",
                         "CYCLE",
                         TimeLiteral,
                         true,
                         {{"KP", Gain, Plain, -kAnyGain, kAnyGain},
                          {"TR", IntegralTime, Seconds, 0, kAnyGain},
                          {"TD", DerivativeTime, Seconds, 0, kAnyGain}}};
    };
    return {
        {"FB_P",
         "",
         "q_rOput",
         "i_rActVal",
         "i_rSp",
         "",
         "",
         "i_xManMode",
         "",
         "",
         "",
         "",
         Plain,
         false,
         {{"i_rKp", Gain, Plain, 0, kAnyGain}}},
        {"FB_PI",
         "",
         "q_rOput",
         "i_rActVal",
         "i_rSp",
         "i_stPara.rMinLim",
         "i_stPara.rMaxLim",
         "i_xManMode",
         "core.wasHeld",
         "",
         "",
         "i_stPara.tCyclTime",
         TimeLiteral,
         false,
         {{"i_stPara.rKp", Gain, Plain, 0, kAnyGain},
          {"i_stPara.tTn", IntegralTime, TimeLiteral, 0.001, kLongestTime}}},
        {"FB_PID",
         "",
         "q_rPidOput",
         "i_rPv1",
         "i_rSp",
         "i_stPid.rLowLim",
         "i_stPid.rHighLim",
         "i_xManMode",
         "core.wasHeld",
         "",
         "",
         "i_stPid.rTargCyclTime",
         Milliseconds,
         false,
         {{"i_rKp", Gain, Plain, 0, kAnyGain},
          {"i_rTn", IntegralTime, Milliseconds, 0, kMinute},
          {"i_rTv", DerivativeTime, Milliseconds, 0, kMinute},
          {"i_rTd", FilterTime, Milliseconds, 0, kBelowMinute}}},
        {"FB_PI_PID",
         "PI",
         "innerSetPoint",
         "i_rActValPI",
         "i_rSp",
         "i_stParaPI.rMinLim",
         "i_stParaPI.rMaxLim",
         "i_xManModePI",
         "pi.wasHeld",
         "",
         "",
         "i_stParaPI.tCyclTime",
         TimeLiteral,
         false,
         {{"i_stParaPI.rKp", Gain, Plain, 0, 1e38}, {"i_stParaPI.tTn", IntegralTime, TimeLiteral, 0, kMinute}}},
        {"FB_PI_PID",
         "PID",
         "q_rOput",
         "i_rActValPID",
         "innerSetPoint",
         "i_stParaPID.rMinLim",
         "i_stParaPID.rMaxLim",
         "i_xManModePID",
         "pid.wasHeld",
         "",
         "",
         "i_stParaPI.tCyclTime",
         TimeLiteral,
         false,
         {{"i_stParaPID.rKp", Gain, Plain, 0, 1e38},
          {"i_stParaPID.tTn", IntegralTime, TimeLiteral, 0, kMinute},
          {"i_stParaPID.tTv", DerivativeTime, TimeLiteral, 0, kMinute},
          {"i_stParaPID.tTd", FilterTime, TimeLiteral, 0, kMinute}}},
        util("PID", ""),
        util("PID_FIXCYCLE", "CYCLE"),
        annexF("PID"),
        annexF("PID_LREAL"),
    };
}

std::string timeText(double seconds) {
    const auto microseconds = std::llround(seconds * 1e6);
    if (microseconds % 1000 == 0) return "T#" + std::to_string(microseconds / 1000) + "ms";
    return "T#" + shortestReal(static_cast<double>(microseconds) / 1000) + "ms";
}

std::string textOf(Unit unit, double value) {
    const auto rounded = static_cast<float>(std::strtod(numberText(value, 5).c_str(), nullptr));
    switch (unit) {
    case Unit::Plain:
    case Unit::Seconds:
        return shortestReal(rounded);
    case Unit::Milliseconds:
        return shortestReal(static_cast<float>(std::strtod(numberText(value * 1000, 5).c_str(), nullptr)));
    case Unit::TimeLiteral:
        return timeText(std::round(value * 1e3) / 1e3);
    }
    return {};
}

double wanted(const ControllerGains& gains, Quantity quantity) {
    switch (quantity) {
    case Quantity::Gain:
        return gains.gain;
    case Quantity::IntegralTime:
        return gains.integralTime;
    case Quantity::DerivativeTime:
        return gains.derivativeTime;
    case Quantity::FilterTime:
        return gains.filterTime;
    }
    return 0;
}

} // namespace

std::vector<ControllerKind> BlockForm::kinds() const {
    std::vector<ControllerKind> out{ControllerKind::P};
    for (const ParameterForm& parameter : parameters) {
        if (parameter.quantity == Quantity::IntegralTime) out.push_back(ControllerKind::Pi);
        if (parameter.quantity == Quantity::DerivativeTime) out.push_back(ControllerKind::Pid);
    }
    return out;
}

const std::vector<BlockForm>& blockForms() {
    static const std::vector<BlockForm> all = makeForms();
    return all;
}

std::vector<ParameterValue> parametersOf(const BlockForm& form, const ControllerGains& gains, double cycle) {
    std::vector<ParameterValue> out;
    for (const ParameterForm& parameter : form.parameters) {
        // without a derivative its filter stays as it is
        if (parameter.quantity == Quantity::FilterTime && gains.derivativeTime <= 0) continue;
        double value = wanted(gains, parameter.quantity);
        if (parameter.quantity == Quantity::Gain && form.isReversed) value = -value;
        double least = parameter.least;
        if (parameter.quantity == Quantity::FilterTime) {
            least = cycle * 1.001; // the filter cannot be quicker than the calls
            value = std::max(value, least);
        }
        // no integral part: as far from one as the block can be, where 0 is not taken
        if (parameter.quantity == Quantity::IntegralTime && value <= 0 && least > 0) value = parameter.greatest;
        const double limited = std::clamp(value, least, parameter.greatest);
        out.push_back({std::string(parameter.member), textOf(parameter.unit, limited), limited, limited != value});
    }
    return out;
}

ControllerGains gainsOf(const BlockForm& form, const std::vector<double>& values) {
    ControllerGains out{0, 0, 0, 0};
    for (size_t i = 0; i < form.parameters.size() && i < values.size(); ++i) {
        const ParameterForm& parameter = form.parameters[i];
        const double scale = parameter.unit == Unit::Milliseconds ? 1e-3 : 1;
        switch (parameter.quantity) {
        case Quantity::Gain:
            out.gain = form.isReversed ? -values[i] : values[i];
            break;
        case Quantity::IntegralTime:
            out.integralTime = values[i] * scale;
            break;
        case Quantity::DerivativeTime:
            out.derivativeTime = values[i] * scale;
            break;
        case Quantity::FilterTime:
            out.filterTime = values[i] * scale;
            break;
        }
    }
    return out;
}

} // namespace plc::tuning
