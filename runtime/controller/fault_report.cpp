#include "runtime/controller/fault_report.h"

#include "runtime/base/messages.h"

namespace plc::controller {

using image::FaultCode;

std::string_view name(FaultCode code) {
    switch (code) {
    case FaultCode::None:
        return "no fault";
    case FaultCode::DivisionByZero:
        return "division by zero";
    case FaultCode::IndexOutOfRange:
        return "index out of range";
    case FaultCode::NullReference:
        return "null reference";
    case FaultCode::ForeignReference:
        return "foreign reference";
    case FaultCode::MissingInOut:
        return "missing VAR_IN_OUT";
    case FaultCode::StringIndex:
        return "string index out of range";
    case FaultCode::Watchdog:
        return "watchdog";
    case FaultCode::StackOverflow:
        return "stack overflow";
    case FaultCode::AbstractCall:
        return "call of an abstract method";
    case FaultCode::Stopped:
        return "scan abandoned";
    case FaultCode::ValueOutOfRange:
        return "value out of range";
    }
    return {};
}

Message faultMessage(const image::RuntimeContext& context) {
    const int64_t at = context.faultDetail[0], low = context.faultDetail[1], high = context.faultDetail[2];
    switch (context.fault) {
    case FaultCode::None:
        return {};
    case FaultCode::DivisionByZero:
        return errors::DivisionByZero();
    case FaultCode::IndexOutOfRange:
        return high < low ? errors::IndexOfEmptyArray(at) : errors::IndexOutOfRange(at, low, high);
    case FaultCode::NullReference:
        return errors::NullReference();
    case FaultCode::ForeignReference:
        return errors::ForeignReference();
    case FaultCode::MissingInOut:
        return errors::MissingInOut();
    case FaultCode::StringIndex:
        return high < low ? errors::IndexOfEmptyText(at) : errors::TextIndexOutOfRange(at, low, high);
    case FaultCode::Watchdog:
        return errors::WatchdogExpired();
    case FaultCode::StackOverflow:
        return errors::CallsTooDeep();
    case FaultCode::AbstractCall:
        return errors::AbstractMethodCalled();
    case FaultCode::Stopped:
        return errors::ScanAbandoned();
    case FaultCode::ValueOutOfRange:
        return errors::ValueOutsideSubrange(at, low, high);
    }
    return {};
}

namespace {

FaultFrame frameOf(const image::CompiledProgram& program, const image::CallRecord& record, uint32_t site) {
    FaultFrame frame;
    frame.functionIndex = record.function;
    frame.instanceOffset = record.instance;
    frame.frameOffset = record.frame;
    if (record.function < program.functions.size()) {
        const image::FunctionInfo& function = program.functions[record.function];
        frame.function = function.library.empty() ? function.name : function.library + "." + function.name;
        frame.range = function.declaration;
        if (record.instance) frame.instance = program.layout.pathAt(record.instance, function.instanceType);
    }
    if (site && site < program.sites.size()) frame.range = program.sites[site].range;
    return frame;
}

} // namespace

std::vector<FaultFrame> callPathOf(const image::CompiledProgram& program, const image::RuntimeContext& context,
                                   uint32_t site, image::CallRecord entry) {
    std::vector<image::CallRecord> records; // outermost first
    const uint32_t depth = std::min(context.depth, image::kMaximumDepth);
    entry.site = 0;
    if (depth == 0 || context.calls[0].site != 0) records.push_back(entry);
    for (uint32_t i = 0; i < depth; ++i) records.push_back(context.calls[i]);

    std::vector<FaultFrame> path;
    // A function that was inlined has no record of its own; its site still tells its name.
    if (site && site < program.sites.size() && program.sites[site].function != records.back().function &&
        program.sites[site].function != 0) {
        image::CallRecord inlined;
        inlined.function = program.sites[site].function;
        path.push_back(frameOf(program, inlined, site));
        site = 0;
    }
    for (size_t i = records.size(); i-- > 0;) {
        path.push_back(frameOf(program, records[i], site));
        site = records[i].site;
    }
    return path;
}

} // namespace plc::controller
