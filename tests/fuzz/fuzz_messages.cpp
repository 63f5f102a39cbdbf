// Messages from outside: what other editors send to the language server and the debug adapter. An input is a session
// as in tests/projects/*/scripts: "> {…}" is sent, "? name" waits for an event, other lines are not read. Mostly a
// message is changed as JSON, or a session as a list of messages: a change of bytes seldom leaves one that is read.
#include "projects/debug_adapter/adapter.h"
#include "projects/language_server/server.h"
#include "runtime/compiler/jit/jit.h"
#include "tests/support/damage.h"
#include "tests/support/rpc_script.h"

#include <array>
#include <cstring>
#include <optional>
#include <sstream>
#include <thread>

namespace {

using plc::testing::Damage;

/// The project that the sessions are about, in a folder of its own: sessions change texts, and some write.
const std::string& rootOf(bool isLanguageServer) {
    static const std::string tests = std::string(STEPWISE_SOURCE_DIR) + "/tests/projects/";
    static const plc::FolderCopy edited(tests + "language_server/plant", "fuzz_edited");
    static const plc::FolderCopy debugged(tests + "debug_adapter/plant", "fuzz_debugged");
    static const std::string roots[] = {debugged.root().string(), edited.root().string()};
    return roots[isLanguageServer];
}

/// A changed path may be that of the whole machine, which would be searched for sources.
bool staysInside(const Damage::Json& value, const std::string& root) {
    if (value.is_structured())
        return std::all_of(value.begin(), value.end(), [&](const auto& each) { return staysInside(each, root); });
    if (!value.is_string()) return true;
    const auto& text = value.get_ref<const std::string&>();
    const bool isPath = text.starts_with("/") || text.starts_with("file:");
    return !isPath || (text.find(root + "/") != std::string::npos && text.find("..") == std::string::npos);
}

class Session {
public:
    void send(std::string line) {
        const bool isLanguageServer = line.find("\"jsonrpc\"") != std::string::npos;
        const std::string &root = rootOf(isLanguageServer), name = "${ROOT}";
        for (size_t at = 0; (at = line.find(name, at)) != std::string::npos; at += root.size())
            line.replace(at, name.size(), root);
        if (const auto json = Damage::readable(line); json && json->is_object()) {
            if (!staysInside(*json, root)) return;
            const std::string command = json->value("/command"_json_pointer, Damage::Json()).dump();
            if (command == "\"attach\"") return; // the network
            if (command == "\"launch\"" && line.find(root) == std::string::npos) return;
        }
        if (isLanguageServer) {
            m_server.receive(line);
            for (int i = 0; i < 100 && m_server.hasWork(); ++i) m_server.work();
        } else {
            m_adapter.receive(line);
            m_adapter.work();
        }
    }
    /// Not for long.
    void waitFor(std::string_view event) {
        const std::string wanted = "\"event\":\"" + std::string(event) + "\"";
        m_seen.clear();
        for (int i = 0; i < 20 && m_seen.find(wanted) == std::string::npos; ++i) {
            m_adapter.work();
            // a duration: most changed sessions have no such event
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

private:
    plc::lsp::Server m_server{[](const plc::protocol::Json&) {}, {}};
    std::string m_seen;
    plc::dap::Adapter m_adapter{
        [this](const plc::protocol::Json& message) { m_seen = plc::protocol::toText(message); }};
};

bool isRead(std::string_view line) { return line.starts_with("> ") || line.starts_with("? "); }

std::vector<std::string> linesOf(const unsigned char* data, size_t size) {
    std::vector<std::string> out;
    std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
    for (std::string line; std::getline(text, line);)
        if (isRead(line)) out.push_back(std::move(line));
    return out;
}

/// Lines of sessions tried before, which others borrow.
class Lent {
public:
    [[nodiscard]] const std::string& any(Damage& damage) const { return m_lines[damage.pick(m_count)]; }
    void keep(const std::string& line, Damage& damage) {
        const size_t at = m_count < m_lines.size() ? m_count++ : damage.pick(m_lines.size());
        m_lines[at] = line;
    }

private:
    std::array<std::string, 256> m_lines;
    size_t m_count = 0;
};

std::string changedMessage(const std::string& line, const Lent& lent, Damage& damage) {
    const auto message = Damage::readable(std::string_view(line).substr(2));
    if (!line.starts_with("> ") || !message) return "> " + damage.text(line.substr(2));
    const auto donor = Damage::readable(std::string_view(lent.any(damage)).substr(2));
    return "> " + damage.json(*message, donor ? *donor : *message)
                      .dump(-1, ' ', false, Damage::Json::error_handler_t::replace);
}

} // namespace

extern "C" size_t LLVMFuzzerMutate(unsigned char* data, size_t size, size_t maxSize);

extern "C" size_t LLVMFuzzerCustomMutator(unsigned char* data, size_t size, size_t maxSize, unsigned seed) {
    static Lent lent;
    Damage damage(seed);
    std::vector<std::string> lines = linesOf(data, size);
    if (lines.empty() || damage.pick(16) == 0) return LLVMFuzzerMutate(data, size, maxSize);
    lent.keep(lines[damage.pick(lines.size())], damage);
    const auto at = [&](size_t index) { return lines.begin() + static_cast<std::ptrdiff_t>(index); };
    for (size_t i = 1 + damage.pick(3); i > 0 && !lines.empty(); --i) {
        const size_t chosen = damage.pick(lines.size());
        switch (damage.pick(8)) {
        case 0:
            lines.erase(at(chosen));
            break;
        case 1: // a message of another session
        case 2:
            lines.insert(at(damage.pick(lines.size() + 1)), lent.any(damage));
            break;
        case 3:
            std::swap(lines[chosen], lines[damage.pick(lines.size())]);
            break;
        default:
            lines[chosen] = changedMessage(lines[chosen], lent, damage);
        }
    }
    std::string mutant;
    for (const std::string& line : lines) mutant += line + "\n";
    if (mutant.empty() || mutant.size() > maxSize) return LLVMFuzzerMutate(data, size, maxSize);
    std::memcpy(data, mutant.data(), mutant.size());
    return mutant.size();
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    static const bool ready = (plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols()),
                               ::setenv("XDG_CACHE_HOME", (rootOf(true) + "/cache").c_str(), 1) == 0);
    if (!ready) return 0;
    Session session;
    for (const std::string& line : linesOf(data, size))
        if (line.starts_with("> "))
            session.send(line.substr(2));
        else
            session.waitFor(std::string_view(line).substr(2));
    return 0;
}
