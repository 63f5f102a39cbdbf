// The controllers of the libraries as tuning sees them: which pins are what, in which unit each parameter is, and
// within which limits the block takes it. A table, any thread.
#pragma once
#include "projects/tuning/optimum.h"

#include <string>
#include <string_view>
#include <vector>

namespace plc::tuning {

enum class Quantity : uint8_t { Gain, IntegralTime, DerivativeTime, FilterTime };
enum class Unit : uint8_t { Plain, Seconds, Milliseconds, TimeLiteral };

struct ParameterForm {
    std::string_view member; // "i_rKp", "i_stPara.tTn"
    Quantity quantity;
    Unit unit;
    double least, greatest; // in the quantity's own unit, times in seconds
};

struct BlockForm {
    std::string_view type;                    // "FB_PID"
    std::string_view part = {};               // of a cascade: "PI", "PID"; else empty
    std::string_view input, output, setPoint; // of the process: the block's output, actual value, set point
    std::string_view low = {}, high = {};     // limits of the output, may be empty
    std::string_view manual;                  // BOOL
    /// BOOL inside the block: the next call goes on from the output as it is, whatever the parameters; empty where
    /// there is no integral part.
    std::string_view resumes = {};
    std::string_view cycle = {}; // the interval that a call stands for, may be empty: the task's
    Unit cycleUnit = Unit::Plain;
    bool isReversed = false; // acts on actual value - set point
    std::vector<ParameterForm> parameters;
    [[nodiscard]] std::vector<ControllerKind> kinds() const;
};

/// All blocks that can be tuned.
[[nodiscard]] const std::vector<BlockForm>& blockForms();

struct ParameterValue {
    std::string member;
    std::string text;       // as ST writes it: 7.5, T#250ms
    double value = 0;       // as the block will use it: gain, or time in seconds
    bool isLimited = false; // the block does not take what was wanted
};
/// The parameters for these gains, each within what the block takes.
[[nodiscard]] std::vector<ParameterValue> parametersOf(const BlockForm& form, const ControllerGains& gains,
                                                       double cycle);
/// The gains that these values mean, in the order of the form's parameters.
[[nodiscard]] ControllerGains gainsOf(const BlockForm& form, const std::vector<double>& values);

} // namespace plc::tuning
