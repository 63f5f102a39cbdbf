// Takes the reports of watched code down into a Look. Lives for one scan on the thread that runs it again.
#pragma once
#include "runtime/inside/look.h"

namespace plc::inside {

class Recorder {
public:
    Recorder(Look& look, const LookOptions& options);
    /// Reports go here from now on.
    void attach(image::RuntimeContext& context);

private:
    static void receive(image::RuntimeContext* context, const void* node, image::WatchKind kind, uint64_t where,
                        uint64_t a, uint64_t b);
    void report(image::RuntimeContext& context, const void* node, image::WatchKind kind, uint64_t where, uint64_t a,
                uint64_t b);
    void begin(uint64_t where, uint32_t function, uint32_t depth);
    void end();
    void pass(const tree::Stmt& loop);
    void load(image::RuntimeContext& context, const tree::Expr& expr, uint64_t where, uint64_t a, uint64_t b);
    [[nodiscard]] bool isLeftOut(const void* node, image::WatchKind kind);
    [[nodiscard]] uint64_t copyOf(uint64_t address, uint64_t size);
    [[nodiscard]] SourceRange extentOf(const tree::Stmt& loop);
    [[nodiscard]] const PassWindow* windowOf(const tree::Stmt& loop) const;

    Look& m_look;
    const LookOptions& m_options;
    struct Running {
        uint32_t activation;
        uint32_t depth; // of the call records
        uint32_t function = 0;
        uint32_t passes = kNone;             // of its loops
        const tree::Stmt* outside = nullptr; // a loop that is in a pass outside its window
        bool isLeftOut = false;              // beyond the limit: `activation` is its caller's
    };
    std::vector<Running> m_running;
    std::unordered_map<const tree::Stmt*, SourceRange> m_extents; // of loops
    EventIndex m_lastCall = kNone;
};

} // namespace plc::inside
