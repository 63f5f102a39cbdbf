// What compiled functions take of the machine's own stack, as LLVM reports it while it makes the machine code. Belongs
// to the compilation of one module; one thread.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace llvm {
class LLVMContext;
class Module;
} // namespace llvm

namespace plc::jit {

/// A function may overshoot the limit of the stack by its own frame only: so much is kept free behind it.
inline constexpr uint64_t kMaximumStackFrame = 512 * 1024;

class StackUse {
public:
    explicit StackUse(llvm::LLVMContext& context); // must outlive the context's use
    struct Frame {
        std::string function; // LLVM's name
        uint64_t bytes = 0;
        bool isGuarded = false; // asks for room at its entry
    };
    /// Frames above codegen::kSmallStackFrame.
    [[nodiscard]] const std::vector<Frame>& large() const { return m_large; }
    void add(Frame frame) { m_large.push_back(std::move(frame)); }

private:
    std::vector<Frame> m_large;
};

} // namespace plc::jit
