// A channel that is computed from samples in their order: DERIVATIVE(…), INTEGRAL(…) and FILTER(…, T#1s) around an ST
// expression, in any nesting. An expression itself knows one scan only (D7), so these are peeled off its text and
// applied to what it gave. Values; any thread.
#pragma once
#include "runtime/base/result.h"

#include <string>
#include <vector>

namespace plc::waveform {

enum class OperationKind : uint8_t { Derivative, Integral, Filter };

struct Operation {
    OperationKind kind = OperationKind::Derivative;
    double time = 0; // of the filter [s]
};

struct Derivation {
    std::string expression;            // what a scan gives
    std::vector<Operation> operations; // the innermost first
    [[nodiscard]] bool isPlain() const { return operations.empty(); }
};

/// Anything but the three words at its beginning is left to the expression.
[[nodiscard]] Result<Derivation> parseDerivation(const std::string& text);

/// Applies the operations to one sample after the other.
class Deriver {
public:
    explicit Deriver(const Derivation& derivation);
    /// `time` in seconds. What is not a number passes unchanged, and the operations start again after it.
    double next(double time, double value);
    void restart();

private:
    struct Stage {
        Operation operation;
        bool hasLast = false;
        double lastTime = 0, last = 0, state = 0;
    };
    static double step(Stage& stage, double time, double value);
    std::vector<Stage> m_stages;
};

} // namespace plc::waveform
