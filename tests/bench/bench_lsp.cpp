// From a keystroke in another editor to its diagnostics: one letter changes in a file of many lines, as an editor sends
// it, until the answer is a text for the pipe. And what an editor asks while one types. bench_lsp [LINES…]
#include "projects/language_server/server.h"
#include "tests/bench/program_generator.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {
using namespace plc;
using lsp::Json;

/// Of the processor, so that what else runs on the machine does not count.
double now() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

double median(std::vector<double> all) {
    std::sort(all.begin(), all.end());
    return all[all.size() / 2];
}

/// A server that holds one file; its answers are counted by their bytes.
struct Editor {
    size_t bytes = 0;
    int id = 0;
    double sentAt = 0;
    lsp::Server server{[this](const Json& message) {
                           bytes += protocol::toText(message).size();
                           sentAt = now();
                       },
                       {{"toolbox", "util"}}};
    /// Milliseconds until the answer is a text for the pipe.
    double say(const char* method, Json parameters, bool isRequest = false) {
        Json message{{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(parameters)}};
        if (isRequest) message["id"] = ++id;
        const std::string text = protocol::toText(message);
        const double begin = now();
        server.receive(text);
        while (server.hasWork()) server.work();
        return sentAt - begin;
    }
};
} // namespace

int main(int argc, char** argv) {
    std::vector<size_t> sizes{10'000, 100'000};
    if (argc > 1) sizes.clear();
    for (int i = 1; i < argc; ++i) sizes.push_back(static_cast<size_t>(std::atol(argv[i])));
    std::printf("| lines | opened | keystroke to diagnostics, median of 50 | slowest | completion | colours |\n"
                "|---|---|---|---|---|---|\n");
    for (const size_t size : sizes) {
        const std::string text = bench::generateProgram(size);
        const lsp::Places places(text);
        const size_t at = text.rfind("level > 2000");
        if (at == std::string::npos) return 1;
        const lsp::Position digit = places.positionOf(static_cast<uint32_t>(at + 11));
        const Json document{{"uri", "file:///bench/plant.st"}, {"version", 1}, {"text", text}};
        const Json name{{"uri", "file:///bench/plant.st"}};
        const Json range{{"start", lsp::toJson(digit)}, {"end", lsp::toJson({digit.line, digit.character + 1})}};
        Editor editor;
        (void)editor.say("initialize", {{"capabilities", Json::object()}}, true);
        const double opened = editor.say("textDocument/didOpen", {{"textDocument", document}});
        std::vector<double> times;
        for (int step = 0; step < 50; ++step) {
            Json change{{"range", range}, {"text", std::to_string(step % 10)}};
            times.push_back(editor.say("textDocument/didChange",
                                       {{"textDocument", name}, {"contentChanges", Json::array({std::move(change)})}}));
        }
        const Json spot{{"textDocument", name}, {"position", lsp::toJson(digit)}};
        const double completion = editor.say("textDocument/completion", spot, true);
        const double colours = editor.say("textDocument/semanticTokens/full", {{"textDocument", name}}, true);
        std::printf("| %u | %.1f ms | %.1f ms | %.1f ms | %.1f ms | %.1f ms |\n", places.lineCount(), opened,
                    median(times), *std::max_element(times.begin(), times.end()), completion, colours);
    }
    return 0;
}
