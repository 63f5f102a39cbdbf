// THE CONTRACT, part 3: a compiled program as the controller, history, debugger and studio see it. Shared and immutable
// (std::shared_ptr<const CompiledProgram>); the code lives as long as it.
#pragma once
#include "runtime/image/layout.h"
#include "runtime/image/runtime_context.h"

#include <atomic>
#include <chrono>
#include <memory>

namespace plc::image {

struct TaskProgram {
    uint32_t root = 0;      // Layout::roots index of the program instance
    uint32_t function = 0;  // functions index of its body
    uint32_t connectIn = 0; // function that copies mapped inputs before the body; 0 = none
    uint32_t connectOut = 0;
};

enum class TaskKind : uint8_t { Cyclic, Event, Freewheeling };

struct Task {
    std::string name;
    TaskKind kind = TaskKind::Cyclic;
    std::chrono::nanoseconds interval{10'000'000};
    int32_t priority = 0;                 // 0 most urgent
    std::optional<Place> trigger;         // SINGLE of an event task (rising edge)
    std::chrono::nanoseconds watchdog{0}; // 0 = the controller's default
    uint32_t watchdogSensitivity = 1;
    bool isSimulation = false; // only simulation programs: runs in the input phase, also in STOP and FAULT
    std::vector<TaskProgram> programs;
    SourceRange declaration;
};

/// A statement of the user's text that code can stand at.
struct Site {
    uint32_t function = 0;
    SourceRange range;
};

struct FunctionLocal {
    std::string name;
    types::TypeId type;
    uint32_t frameOffset = 0; // from the begin of the frame; valid in the quick tier (which keeps all locals in memory)
    bool isInOut = false;     // holds the 8-byte offset of the variable
    bool isHidden = false;
};

struct FunctionInfo {
    std::string name;           // "Motor", "Motor.Start", "Main.Fill" (action), "Limit"
    std::string library;        // namespace when it comes from a library, else empty
    types::TypeId instanceType; // of THIS; none for plain functions
    std::vector<FunctionLocal> locals;
    uint32_t frameSize = 0;
    SourceRange declaration;
};

/// One tier's machine code: entry points by functions index (nullptr where a function needs no entry of its own).
struct Code {
    std::vector<Entry> entries;
    bool hasSites = false;    // quick tier: calls atSite, keeps locals in the frame
    bool marksWrites = false; // sets RuntimeContext::dirtyPages
    std::shared_ptr<void> keepAlive;
};

struct CompiledProgram {
    Layout layout;
    std::vector<std::byte> initialImage; // layout.imageSize bytes: header, areas, initial values
    uint32_t initializer =
        0; // function that computes initial values that need code (FB_Init, REF, …); 0 = none; index 0 is reserved
    std::vector<Task> tasks;             // by priority, then declaration; simulation tasks apart by flag
    std::vector<FunctionInfo> functions; // index 0 unused
    std::vector<Site> sites;             // index 0 unused
    SourceSet sources;                   // the texts it was compiled from
    uint64_t version = 0;                // hash of code and layout; names the program in history segments

    /// Quick code is there from the start; optimised code may arrive later (published once, read at scan boundaries).
    std::shared_ptr<const Code> quick;
    mutable std::atomic<const Code*> optimised{nullptr};
    mutable std::shared_ptr<const Code> optimisedOwner; // set before `optimised` is published, never changed after
};

} // namespace plc::image
