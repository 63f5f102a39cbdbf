// The Language Server Protocol 3.17 over what the studio's editor uses (D9): it keeps the texts that the editor holds
// and answers from projects/analysis. It knows no pipe: messages come in as texts and go out through `send`. One
// thread.
#pragma once
#include "projects/language_server/desk.h"
#include "projects/language_server/live_values.h"

#include <functional>

namespace plc::lsp {

using protocol::Answer;
using protocol::Failure;

struct Settings {
    std::vector<std::string> libraries; // of files that belong to no project
    std::shared_ptr<LiveValues> values; // of a controller that runs; none: no hints
};

class Server {
public:
    using Send = std::function<void(const Json& message)>;
    Server(Send send, Settings settings);
    ~Server();

    /// A message as it came, or why it could not be framed.
    void receive(const Result<std::string>& message);
    /// Texts changed since their diagnostics were sent.
    [[nodiscard]] bool hasWork() const;
    void work();
    /// Asks the editor to show its hints again when values changed; now and then, by whoever waits for messages.
    void refreshHints();
    [[nodiscard]] bool isOver() const { return m_isOver; }
    [[nodiscard]] int exitCode() const { return m_isShutDown ? 0 : 1; }
    /// Asked before a request is worked on.
    std::function<bool(const Json& id)> isCancelled;

private:
    using Method = Answer (Server::*)(const Json& parameters);
    using Note = void (Server::*)(const Json& parameters);
    [[nodiscard]] static Method methodOf(std::string_view name);
    [[nodiscard]] static Note noteOf(std::string_view name);
    [[nodiscard]] Answer answer(const protocol::Incoming& request);
    void take(const protocol::Incoming& message);

    // --- life
    Answer initialize(const Json& parameters);
    Answer shutdown(const Json& parameters);
    void initialized(const Json& parameters);
    void exit(const Json& parameters);

    // --- documents
    struct Document {
        std::string path;
        int64_t version = 0;
        std::unique_ptr<Places> places; // of its text now
        Desk* desk = nullptr;
    };
    void didOpen(const Json& parameters);
    void didChange(const Json& parameters);
    void didClose(const Json& parameters);
    void didSave(const Json& parameters);
    void didChangeWatchedFiles(const Json& parameters);
    bool change(Document& document, const Json& change);
    [[nodiscard]] Desk& deskFor(const std::string& path);
    void settle(Document& document);
    void publish(Desk& desk);
    void publish(const std::string& path, Json diagnostics);
    void withdraw(Desk& desk);
    void dropUnused();
    void show(const Error& error);
    /// A place in an open document.
    struct Spot {
        Document* document = nullptr;
        Desk* desk = nullptr;
        FileId file;
        uint32_t offset = 0;
        [[nodiscard]] const analysis::CodeModel& model() const { return desk->model(); }
    };
    using SpotOf = std::variant<Spot, Failure>;
    [[nodiscard]] SpotOf documentAt(const Json& parameters);
    [[nodiscard]] SpotOf spotAt(const Json& parameters);
    [[nodiscard]] Json workspaceEdit(Desk& desk, const std::vector<analysis::FileEdits>& edits);

    // --- navigation
    Answer hover(const Json& parameters);
    Answer definition(const Json& parameters);
    Answer references(const Json& parameters);
    Answer highlights(const Json& parameters);
    Answer prepareRename(const Json& parameters);
    Answer rename(const Json& parameters);

    // --- typing
    Answer completion(const Json& parameters);
    Answer resolveCompletion(const Json& parameters);
    Answer signatureHelp(const Json& parameters);
    Answer formatting(const Json& parameters);
    Answer codeActions(const Json& parameters);

    // --- structure
    Answer documentSymbols(const Json& parameters);
    Answer workspaceSymbols(const Json& parameters);
    Answer foldingRanges(const Json& parameters);
    Answer semanticTokens(const Json& parameters);
    Answer inlineValues(const Json& parameters);
    Answer inlayHints(const Json& parameters);
    struct LineValues;
    [[nodiscard]] std::vector<LineValues> valuesIn(const Spot& spot, uint32_t from, uint32_t to) const;

    Send m_send;
    Settings m_settings;
    bool m_isInitialised = false, m_isShutDown = false, m_isOver = false;
    bool m_takesSnippets = false, m_watchesFiles = false, m_refreshesHints = false;
    std::map<std::string, Document> m_documents;          // by URI
    std::map<std::string, std::unique_ptr<Desk>> m_desks; // by folder, or file
    std::map<std::string, std::string> m_published;       // by path, as sent last
    struct Reported {
        uint64_t revision = 0;       // of the desk; 0: nothing was reported
        std::set<std::string> paths; // that have diagnostics
    };
    [[nodiscard]] bool isReported(const Desk& desk) const;
    std::map<const Desk*, Reported> m_reported;
    std::vector<analysis::CompletionItem> m_offered; // the last list, for resolve
    uint64_t m_offer = 0, m_shownValues = 0, m_refreshes = 0;
};

/// Edits that make `after` of `before` when only blanks and the case of words differ; else one for all of it.
[[nodiscard]] std::vector<diagnostics::TextEdit> formattingEdits(std::string_view before, std::string_view after);
/// Names and modifiers of the tokens, as the client decodes them.
[[nodiscard]] Json semanticLegend();

} // namespace plc::lsp
