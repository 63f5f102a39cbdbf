#include "runtime/compiler/jit/write_marks.h"

#include "runtime/image/runtime_context.h"

#include <llvm/Analysis/ValueTracking.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InlineAsm.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Module.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace plc::jit {

namespace {

constexpr const char* kKeeper = "# context and image";

/// Functions that take context and image; the helpers of the module (plc.raise, plc.site) have no business with the
/// image.
bool hasImage(const llvm::Function& function) {
    if (function.isDeclaration() || function.arg_size() < 2) return false;
    return function.getArg(0)->getType()->isPointerTy() && function.getArg(1)->getType()->isPointerTy();
}

llvm::InlineAsm* keeper(llvm::Module& module) {
    llvm::Type* pointer = llvm::PointerType::getUnqual(module.getContext());
    auto* type = llvm::FunctionType::get(llvm::Type::getVoidTy(module.getContext()), {pointer, pointer}, false);
    return llvm::InlineAsm::get(type, kKeeper, "r,r", true);
}

bool isKeeper(const llvm::Instruction& instruction) {
    const auto* call = llvm::dyn_cast<llvm::CallInst>(&instruction);
    const auto* text = call ? llvm::dyn_cast<llvm::InlineAsm>(call->getCalledOperand()) : nullptr;
    return text && text->getAsmString() == kKeeper;
}

class Marker {
public:
    Marker(llvm::Function& function, uint32_t imageSize)
        : m_function(function), m_builder(function.getContext()), m_pages(image::dirtyPageCount(imageSize)),
          m_i8(llvm::Type::getInt8Ty(function.getContext())), m_i64(llvm::Type::getInt64Ty(function.getContext())) {}

    void run() {
        std::vector<llvm::Instruction*> writers;
        for (llvm::Instruction& instruction : llvm::instructions(m_function))
            if (instruction.mayWriteToMemory()) writers.push_back(&instruction);
        for (llvm::Instruction* writer : writers) visit(*writer);
    }

private:
    void visit(llvm::Instruction& writer) {
        if (auto* store = llvm::dyn_cast<llvm::StoreInst>(&writer)) return visitStore(*store);
        auto* call = llvm::dyn_cast<llvm::CallInst>(&writer);
        if (!call) return;
        if (auto* bytes = llvm::dyn_cast<llvm::MemIntrinsic>(call)) {
            if (mayBeImage(bytes->getRawDest())) markRange(writer, bytes->getRawDest(), bytes->getLength());
            return;
        }
        const llvm::Function* callee = call->getCalledFunction();
        if (!callee || !callee->isDeclaration() || callee->isIntrinsic()) return;
        const llvm::StringRef name = callee->getName();
        if (name == "memcpy" || name == "memmove" || name == "memset") {
            if (mayBeImage(call->getArgOperand(0))) markRange(writer, call->getArgOperand(0), call->getArgOperand(2));
            return;
        }
        if (!name.starts_with("plc_text_") && !name.starts_with("plc_wtext_")) return;
        // Text functions write to their first argument; its capacity is the second. Two bytes a character is the most.
        if (!mayBeImage(call->getArgOperand(0)) || call->arg_size() < 2 ||
            !call->getArgOperand(1)->getType()->isIntegerTy(32))
            return;
        m_builder.SetInsertPoint(&writer);
        llvm::Value* capacity = m_builder.CreateZExt(call->getArgOperand(1), m_i64);
        markRange(writer, call->getArgOperand(0),
                  m_builder.CreateMul(m_builder.CreateAdd(capacity, m_builder.getInt64(1)), m_builder.getInt64(2)));
    }

    void visitStore(llvm::StoreInst& store) {
        llvm::Value* pointer = store.getPointerOperand();
        if (!mayBeImage(pointer)) return;
        const llvm::DataLayout& layout = m_function.getParent()->getDataLayout();
        const uint64_t size = layout.getTypeStoreSize(store.getValueOperand()->getType()).getFixedValue();
        m_builder.SetInsertPoint(&store);
        llvm::Value* offset = offsetOf(pointer);
        markPage(offset);
        if (size > store.getAlign().value())
            markPage(m_builder.CreateAdd(offset, m_builder.getInt64(size - 1))); // may lie over a border
    }

    /// Not the context, not the stack.
    [[nodiscard]] bool mayBeImage(const llvm::Value* pointer) const {
        const llvm::Value* object = llvm::getUnderlyingObject(pointer, 0);
        return object != m_function.getArg(0) && !llvm::isa<llvm::AllocaInst>(object) &&
               !llvm::isa<llvm::GlobalValue>(object);
    }

    llvm::Value* offsetOf(llvm::Value* pointer) {
        llvm::APInt constant(64, 0);
        const llvm::DataLayout& layout = m_function.getParent()->getDataLayout();
        const llvm::Value* base = pointer->stripAndAccumulateConstantOffsets(layout, constant, true);
        if (base == m_function.getArg(1)) return m_builder.getInt64(constant.getZExtValue());
        return m_builder.CreateSub(m_builder.CreatePtrToInt(pointer, m_i64),
                                   m_builder.CreatePtrToInt(m_function.getArg(1), m_i64));
    }

    void markPage(llvm::Value* offset) {
        llvm::Value* page = m_builder.CreateUDiv(offset, m_builder.getInt64(image::kDirtyPage));
        page = m_builder.CreateBinaryIntrinsic(llvm::Intrinsic::umin, page, m_builder.getInt64(m_pages));
        m_builder.CreateStore(m_builder.getInt8(1), m_builder.CreateInBoundsGEP(m_i8, dirtyPages(), page));
    }

    void markRange(llvm::Instruction& before, llvm::Value* pointer, llvm::Value* length) {
        m_builder.SetInsertPoint(&before);
        llvm::Module& module = *m_function.getParent();
        llvm::FunctionCallee mark = module.getOrInsertFunction(
            "plc_mark_written",
            llvm::FunctionType::get(m_builder.getVoidTy(), {dirtyPages()->getType(), m_i64, m_i64, m_i64}, false));
        m_builder.SetInsertPoint(&before);
        m_builder.CreateCall(mark, {dirtyPages(), offsetOf(pointer), m_builder.CreateZExtOrTrunc(length, m_i64),
                                    m_builder.getInt64(m_pages)});
    }

    /// Loaded once, at the function's begin.
    llvm::Value* dirtyPages() {
        if (m_dirtyPages) return m_dirtyPages;
        llvm::BasicBlock& entry = m_function.getEntryBlock();
        llvm::IRBuilder<> begin(&entry, entry.getFirstInsertionPt());
        llvm::Value* field =
            begin.CreateConstInBoundsGEP1_64(m_i8, m_function.getArg(0), offsetof(image::RuntimeContext, dirtyPages));
        m_dirtyPages = begin.CreateLoad(m_function.getArg(0)->getType(), field);
        return m_dirtyPages;
    }

    llvm::Function& m_function;
    llvm::IRBuilder<> m_builder;
    uint64_t m_pages;
    llvm::Type* m_i8;
    llvm::Type* m_i64;
    llvm::Value* m_dirtyPages = nullptr;
};

} // namespace

void keepImageArguments(llvm::Module& module) {
    for (llvm::Function& function : module) {
        if (!hasImage(function)) continue;
        llvm::BasicBlock& entry = function.getEntryBlock();
        llvm::IRBuilder<> begin(&entry, entry.getFirstInsertionPt());
        begin.CreateCall(keeper(module), {function.getArg(0), function.getArg(1)});
    }
}

void markWrites(llvm::Module& module, uint32_t imageSize) {
    std::vector<llvm::Function*> functions;
    for (llvm::Function& function : module)
        if (hasImage(function)) functions.push_back(&function);
    for (llvm::Function* function : functions) {
        std::vector<llvm::Instruction*> keepers;
        for (llvm::Instruction& instruction : llvm::instructions(*function))
            if (isKeeper(instruction)) keepers.push_back(&instruction);
        for (llvm::Instruction* instruction : keepers) instruction->eraseFromParent();
        Marker(*function, imageSize).run();
    }
}

} // namespace plc::jit
