// Messages from outside: what other editors send to the language server and the debug adapter, one message a line.
#include "projects/debug_adapter/adapter.h"
#include "projects/language_server/server.h"
#include "runtime/compiler/jit/jit.h"

#include <string>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    static const bool ready = (plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols()), true);
    (void)ready;
    const auto nothing = [](const plc::protocol::Json&) {};
    plc::lsp::Server server(nothing, {});
    plc::dap::Adapter adapter(nothing);
    const std::string_view all(reinterpret_cast<const char*>(data), size);
    for (size_t at = 0; at < all.size();) {
        const size_t end = std::min(all.find('\n', at), all.size());
        const std::string line(all.substr(at, end - at));
        server.receive(line);
        for (int i = 0; i < 100 && server.hasWork(); ++i) server.work();
        adapter.receive(line);
        adapter.work();
        at = end + 1;
    }
    return 0;
}
