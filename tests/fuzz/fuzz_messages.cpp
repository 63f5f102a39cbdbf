// Messages from outside: what other editors send to the language server and the debug adapter. An input is a session
// as in tests/projects/*/scripts: "> {…}" is sent, "? name" waits for an event.
#include "projects/debug_adapter/adapter.h"
#include "projects/language_server/server.h"
#include "runtime/compiler/jit/jit.h"
#include "tests/fuzz/script_mutator.h"
#include "tests/support/rpc_script.h"

#include <optional>
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

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    static const bool ready = (plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols()),
                               ::setenv("XDG_CACHE_HOME", (rootOf(true) + "/cache").c_str(), 1) == 0);
    if (!ready) return 0;
    Session session;
    for (const std::string& line : plc::fuzz::linesOf(std::string(reinterpret_cast<const char*>(data), size)))
        if (line.starts_with("> "))
            session.send(line.substr(2));
        else
            session.waitFor(std::string_view(line).substr(2));
    return 0;
}
