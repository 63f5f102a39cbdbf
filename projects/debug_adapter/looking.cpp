// What a stopped program shows: threads, frames, scopes, variables, values; and values that are set.
#include "projects/debug_adapter/adapter.h"

#include "projects/protocol/errors.h"
#include "runtime/base/text.h"
#include "runtime/image/variable_tree.h"

#include <algorithm>
#include <filesystem>

namespace plc::dap {

namespace errors = protocol::errors;
namespace fs = std::filesystem;

namespace {

std::string frameName(const std::string& function, const std::string& instance) {
    return instance.empty() || instance == function ? function : errors::FunctionOn(function, instance).english();
}

} // namespace

Adapter::Body Adapter::threads(const Json&) {
    Json out = Json::array();
    const std::vector<image::Task>& tasks = m_debuggee->program().tasks;
    for (size_t i = 0; i < tasks.size(); ++i) out.push_back({{"id", i + 1}, {"name", tasks[i].name}});
    return Json{{"threads", std::move(out)}};
}

const std::vector<Frame>& Adapter::frames() {
    if (!m_frames) m_frames = m_debuggee->frames();
    return *m_frames;
}

/// On disk where there is such a file, else by number: the file's, from 1.
Json Adapter::sourceOf(FileId file) const {
    const std::string& path = m_debuggee->program().sources[file].path();
    const fs::path folder = m_debuggee->folder();
    const fs::path absolute = folder.empty() ? fs::absolute(path) : folder / path;
    Json out{{"name", fs::path(path).filename().string()}};
    std::error_code ignored;
    if (!path.starts_with("library/") && fs::exists(absolute, ignored))
        out["path"] = absolute.lexically_normal().string();
    else
        out["sourceReference"] = file.index() + 1;
    return out;
}

Adapter::Body Adapter::source(const Json& arguments) {
    auto number = protocol::integerAt(arguments, "source.sourceReference");
    if (!number) number = protocol::integerAt(arguments, "sourceReference");
    const auto& files = m_debuggee->program().sources.files;
    if (!number || *number < 1 || static_cast<size_t>(*number) > files.size()) return Error{errors::NoSuchSource(), {}};
    return Json{{"content", files[static_cast<size_t>(*number) - 1].text()}};
}

Adapter::Body Adapter::stackTrace(const Json& arguments) {
    const auto thread = protocol::integerAt(arguments, "threadId");
    const int64_t start = std::max<int64_t>(protocol::integerAt(arguments, "startFrame").value_or(0), 0);
    const int64_t levels = protocol::integerAt(arguments, "levels").value_or(0);
    Json out = Json::array();
    int64_t total = 0;
    for (const Frame& each : frames()) {
        if (thread && each.task && *each.task + 1 != static_cast<size_t>(*thread)) continue;
        const int64_t index = total++;
        if (index < start || (levels > 0 && index >= start + levels)) continue;
        Json frame{{"id", each.id + 1}, {"name", frameName(each.function, each.instance)}};
        frame["line"] = frame["column"] = 0;
        if (each.range.file.isValid()) {
            const SourceText& text = m_debuggee->program().sources[each.range.file];
            const LineColumn begin = text.lineColumn(each.range.begin), end = text.lineColumn(each.range.end);
            frame["source"] = sourceOf(each.range.file);
            frame["line"] = begin.line - 1 + m_firstLine;
            frame["column"] = begin.column - 1 + m_firstColumn;
            frame["endLine"] = end.line - 1 + m_firstLine;
            frame["endColumn"] = end.column - 1 + m_firstColumn;
        }
        out.push_back(std::move(frame));
    }
    return Json{{"stackFrames", std::move(out)}, {"totalFrames", total}};
}

std::optional<Frame> Adapter::frameAt(const Json& arguments, std::string_view key) {
    const auto id = protocol::integerAt(arguments, key);
    if (!id) return std::nullopt;
    for (const Frame& each : frames())
        if (each.id + 1 == static_cast<uint64_t>(*id)) return each;
    return std::nullopt;
}

// ---------------------------------------------------------------- variables

std::vector<Variables::Line> Adapter::linesOf(const Frame& frame, bool areLocals) {
    std::vector<Variables::Line> out;
    for (const Debuggee::Variable& each : m_debuggee->variables(frame)) {
        if (each.isLocal != areLocals) continue;
        const bool hasPath = !areLocals && !frame.instance.empty();
        out.push_back({each.name, each.value, hasPath ? frame.instance + "." + each.name : "", each.isChanged});
    }
    return out;
}

std::vector<Variables::Line> Adapter::globals() {
    std::vector<Variables::Line> out;
    for (const image::VariableNode& node : image::VariableTree(m_debuggee->program().layout).declared()) {
        if (node.kind == image::VariableKind::Program || node.root->name.empty()) continue;
        const auto value = m_debuggee->evaluate(node.path, std::nullopt);
        out.push_back({node.path, value ? *value : types::Value(), node.isConstant ? "" : node.path, false});
    }
    return out;
}

Adapter::Body Adapter::scopes(const Json& arguments) {
    const auto frame = frameAt(arguments, "frameId");
    if (!frame) return Error{errors::NoSuchFrame(), {}};
    Json out = Json::array();
    const auto add = [&](const std::string& name, const char* hint, bool isExpensive, Variables::Lines lines) {
        Json scope{{"name", name}};
        if (hint) scope["presentationHint"] = hint;
        scope["variablesReference"] = m_variables.add(std::move(lines));
        scope["expensive"] = isExpensive;
        out.push_back(std::move(scope));
    };
    if (!linesOf(*frame, true).empty())
        add(errors::Locals().english(), "locals", false, [this, f = *frame] { return linesOf(f, true); });
    if (!linesOf(*frame, false).empty())
        add(frame->instance.empty() ? errors::Instance().english() : frame->instance, nullptr, false,
            [this, f = *frame] { return linesOf(f, false); });
    add(errors::Globals().english(), nullptr, true, [this] { return globals(); });
    return Json{{"scopes", std::move(out)}};
}

Adapter::Body Adapter::variables(const Json& arguments) {
    const auto number = protocol::integerAt(arguments, "variablesReference");
    const auto lines = number ? m_variables.lines(*number) : std::nullopt;
    if (!lines) return Error{errors::NoSuchFrame(), {}};
    const auto start = static_cast<size_t>(std::max<int64_t>(protocol::integerAt(arguments, "start").value_or(0), 0));
    const auto count = static_cast<size_t>(std::max<int64_t>(protocol::integerAt(arguments, "count").value_or(0), 0));
    Json out = Json::array();
    for (size_t i = start; i < lines->size() && (count == 0 || i - start < count); ++i)
        out.push_back(m_variables.toJson(types(), (*lines)[i]));
    return Json{{"variables", std::move(out)}};
}

namespace {

std::string trimmed(std::string_view text) {
    const size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(" \t;") + 1 - begin));
}

} // namespace

Adapter::Body Adapter::written(const std::string& path, const std::string& text) {
    const auto value = m_debuggee->write(path, text);
    if (!value) return value.error();
    m_frames.reset();
    return m_variables.valueJson(types(), {path, *value, path, false}, "value");
}

/// A value, or at the prompt "Main.x := 5".
Adapter::Body Adapter::evaluate(const Json& arguments) {
    const auto text = protocol::textAt(arguments, "expression");
    if (!text) return Error{errors::WrongParameter(Verbatim("evaluate"), Verbatim("expression")), {}};
    const auto frame = frameAt(arguments, "frameId");
    const size_t assignment = text->find(":=");
    if (protocol::textAt(arguments, "context") == "repl" && assignment != std::string::npos) {
        std::string path = trimmed(std::string_view(*text).substr(0, assignment));
        if (frame && !frame->instance.empty())
            for (const Variables::Line& each : linesOf(*frame, false))
                if (equalsIgnoringCase(each.name, path.substr(0, path.find_first_of(".[")))) {
                    path = frame->instance + "." + path;
                    break;
                }
        Body done = written(path, trimmed(std::string_view(*text).substr(assignment + 2)));
        if (!done) return done;
        (*done)["result"] = (*done)["value"];
        done->erase("value");
        return done;
    }
    const auto value = m_debuggee->evaluate(*text, frame);
    if (!value) return value.error();
    // A plain name of the instance is found from the top as well.
    return m_variables.valueJson(types(), {*text, *value, "", false}, "result");
}

Adapter::Body Adapter::setVariable(const Json& arguments) {
    const auto number = protocol::integerAt(arguments, "variablesReference");
    const auto name = protocol::textAt(arguments, "name"), value = protocol::textAt(arguments, "value");
    const auto lines = number ? m_variables.lines(*number) : std::nullopt;
    if (!lines || !name || !value)
        return Error{errors::WrongParameter(Verbatim("setVariable"), Verbatim("variablesReference")), {}};
    for (const Variables::Line& each : *lines) {
        if (each.name != *name) continue;
        if (each.path.empty()) return Error{errors::LocalIsFixed(*name), {}};
        return written(each.path, *value);
    }
    return Error{errors::NoSuchVariable(*name), {}};
}

Adapter::Body Adapter::setExpression(const Json& arguments) {
    const auto text = protocol::textAt(arguments, "expression"), value = protocol::textAt(arguments, "value");
    if (!text || !value) return Error{errors::WrongParameter(Verbatim("setExpression"), Verbatim("expression")), {}};
    return written(*text, *value);
}

Adapter::Body Adapter::exceptionInfo(const Json&) {
    const auto fault = m_debuggee->fault();
    if (!fault) return Error{errors::NoFault(), {}};
    Json details{{"message", fault->message.english()}, {"typeName", controller::name(fault->code)}};
    std::string trace;
    for (const controller::FaultFrame& each : fault->calls) trace += frameName(each.function, each.instance) + "\n";
    details["stackTrace"] = trace;
    return Json{{"exceptionId", controller::name(fault->code)},
                {"description", fault->message.english()},
                {"breakMode", "always"},
                {"details", std::move(details)}};
}

} // namespace plc::dap
