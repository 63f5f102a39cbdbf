#include "runtime/compiler/jit/stack_use.h"

#include "runtime/compiler/codegen/codegen.h"

#include <llvm/IR/DiagnosticInfo.h>
#include <llvm/IR/Function.h>
#include <llvm/IR/LLVMContext.h>

namespace plc::jit {

StackUse::StackUse(llvm::LLVMContext& context) {
    context.setDiagnosticHandlerCallBack(
        [](const llvm::DiagnosticInfo* info, void* self) {
            if (const auto* size = llvm::dyn_cast<llvm::DiagnosticInfoStackSize>(info))
                static_cast<StackUse*>(self)->add({size->getFunction().getName().str(), size->getResourceSize(),
                                                   size->getFunction().hasFnAttribute(codegen::kGuardsStack)});
        },
        this);
}

} // namespace plc::jit
