// The two emitters behind emitModule: ModuleEmitter holds what functions share (declarations, tables, helpers, alias
// nodes), FunctionEmitter writes one body. LLVM types are visible only here and in the .cpp files. One thread.
#pragma once
#include "runtime/compiler/codegen/codegen.h"
#include "runtime/compiler/facts/program_facts.h"
#include "runtime/image/watch.h"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/MDBuilder.h>
#include <llvm/IR/Module.h>

#include <initializer_list>
#include <map>
#include <set>

namespace plc::codegen {

using facts::extentOf;
using facts::FunctionFacts;
using facts::hasEffects;
using facts::kNoFrame;
using facts::ProgramFacts;
using facts::rootOf;
using facts::Target;
using facts::Use;
using facts::Walker;
using facts::WriteSummary;

/// How a function of the tree looks to LLVM: (ctx, image, this as pointer, frame as i64 offset, arguments…) → {result,
/// scalar outputs…}.
struct Abi {
    llvm::FunctionType* type = nullptr;
    bool returnsScalar = false;          // the result is element 0 of what is returned
    std::vector<uint32_t> scalarOutputs; // locals returned after it
    unsigned returned = 0;               // elements returned
};

/// A place after evaluation. Image places know their offset too.
struct Address {
    llvm::Value* base = nullptr;       // image, THIS, frame, an alloca or a constant
    llvm::Value* baseOffset = nullptr; // i64 image offset of base, null = 0
    llvm::Value* dynamic = nullptr;    // i64 bytes, null = 0
    int64_t constant = 0;
    types::TypeId type;
    int bit = -1;
    bool isImage = true;
    llvm::MDNode* alias = nullptr; // null: may be anything in the image
    types::TypeId container;       // struct or block whose field this is inside, while alias stays precise
    bool isPrecise = false;        // alias nodes may be derived for its fields
    uint32_t align = 1;
    std::vector<std::pair<llvm::Value*, llvm::Value*>> bounds; // OpenArray: low, high
};

/// Text in memory.
struct Text {
    llvm::Value* pointer = nullptr;
    llvm::Value* capacity = nullptr; // i32
    bool isWide = false;
};

struct Range {
    int64_t low = INT64_MIN, high = INT64_MAX;
};

class ModuleEmitter {
public:
    ModuleEmitter(llvm::LLVMContext& context, const tree::Program& program, const ProgramFacts& facts,
                  const Options& options, Part part);
    Result<std::unique_ptr<llvm::Module>> emit();

    [[nodiscard]] const types::TypeTable& types() const { return *program.types; }
    [[nodiscard]] llvm::Type* scalarType(types::TypeId type);
    [[nodiscard]] llvm::Type* memoryType(types::TypeId type);
    [[nodiscard]] bool isScalar(types::TypeId type) const;
    [[nodiscard]] const Abi& abi(uint32_t function);
    [[nodiscard]] llvm::Function* function(uint32_t index);
    [[nodiscard]] uint32_t frameOffset(uint32_t function, uint32_t local) const;
    [[nodiscard]] bool isQuick() const { return options.tier == Tier::Quick; }

    /// A C function of the runtime library; `effects` none: only a value, no memory touched.
    enum class Effects : uint8_t { None, ReadsArguments, WritesArguments, Context, Fault, Any };
    llvm::FunctionCallee helper(const char* name, llvm::Type* result, llvm::ArrayRef<llvm::Type*> parameters,
                                Effects effects);
    void addAttributes(llvm::Function& function);
    llvm::Function* raise(); // stores code, site and details, leaves
    llvm::Function* watchFunction();
    llvm::Function* siteCheck(); // quick tier: notes the statement, stops when flagged
    llvm::FunctionCallee budgetUsedUp();
    llvm::GlobalVariable* constantBytes(std::string bytes, uint32_t align);
    llvm::GlobalVariable* dispatchTable(uint32_t method);
    llvm::GlobalVariable* blockFlags(types::TypeId wanted, bool& any); // i8 per block number: 1 = is a `wanted`

    // Alias nodes (TBAA): distinct fields and globals never overlap unless tainted.
    llvm::MDNode* aliasTag(llvm::MDNode* node);
    llvm::MDNode* contextTag();
    llvm::MDNode* imageNode() { return m_imageNode; }
    llvm::MDNode* fieldNode(types::TypeId container, size_t field);
    llvm::MDNode* rootNode(size_t root);
    [[nodiscard]] bool isTainted(types::TypeId type) const { return m_tainted.count(type.value) != 0; }
    [[nodiscard]] int rootAt(uint32_t offset) const;

    /// `instruction`'s operand becomes the function's frame size or its bounded need once all are known.
    void patchFrameSize(llvm::Instruction* instruction, unsigned operand, uint32_t function) {
        m_sizePatches.push_back({instruction, operand, function, false});
    }
    void patchNeed(llvm::Instruction* instruction, unsigned operand, uint32_t function) {
        m_sizePatches.push_back({instruction, operand, function, true});
    }
    std::vector<uint64_t> frameSizes; // by function, temporaries included

    llvm::LLVMContext& context;
    std::unique_ptr<llvm::Module> module;
    const tree::Program& program;
    const Options& options;
    const ProgramFacts& facts;
    const Part part;
    [[nodiscard]] bool isOwn(uint32_t function) const {
        return function % part.count == part.index && (!options.only || (*options.only)[function]);
    }
    llvm::IntegerType *i1, *i8, *i16, *i32, *i64;
    llvm::PointerType* ptr;
    llvm::Type *f32, *f64, *voidType;

private:
    llvm::GlobalVariable* newConstant(const std::string& name, llvm::Constant* value);
    void taint();
    void taintType(types::TypeId type);
    [[nodiscard]] std::vector<uint32_t> entryFunctions() const;
    llvm::Function* emitEntry(uint32_t function);
    void emitEntries();
    void limitInlining();
    void resolvePatches();
    uint64_t need(uint32_t function);
    struct SizePatch {
        llvm::Instruction* instruction;
        unsigned operand;
        uint32_t function;
        bool isNeed;
    };
    std::vector<SizePatch> m_sizePatches;
    std::vector<Abi> m_abis;
    std::vector<llvm::Function*> m_functions;
    std::vector<std::optional<uint64_t>> m_needs;
    std::map<std::string, llvm::GlobalVariable*> m_constants;
    std::map<uint32_t, llvm::GlobalVariable*> m_dispatchTables, m_blockFlags;
    std::map<uint32_t, llvm::Function*> m_abstractCalls;
    std::set<uint32_t> m_tainted;
    std::vector<std::pair<uint32_t, size_t>> m_rootsByOffset;
    llvm::Function *m_raise = nullptr, *m_siteCheck = nullptr, *m_watch = nullptr;
    llvm::MDNode *m_imageNode = nullptr, *m_contextTag = nullptr;
    std::map<std::pair<uint32_t, uint32_t>, llvm::MDNode*> m_fieldNodes;
    std::map<size_t, llvm::MDNode*> m_rootNodes;
    std::map<llvm::MDNode*, llvm::MDNode*> m_tags;
};

class FunctionEmitter {
public:
    FunctionEmitter(ModuleEmitter& module, uint32_t index);
    void emit();

private:
    using Builder = llvm::IRBuilder<>;
    using Value = llvm::Value;
    using Block = llvm::BasicBlock;

    // function_emitter.cpp
    Block* emitEntry(); // what every part of a function begins with; returns the block behind it
    void emitPrologue();
    void closeBlocks();
    void emitEpilogue();
    void guardStack();
    void initialiseLocal(uint32_t local);
    Block* newBlock(const char* name);
    void enter(Block* block) { b.SetInsertPoint(block); }
    void jump(Block* target);
    llvm::AllocaInst* newSlot(llvm::Type* type, const char* name); // in the entry block, zero at entry
    uint32_t allocateTemporary(uint64_t size, uint32_t align);
    Address temporary(types::TypeId type);
    Value* contextField(size_t offset);
    llvm::LoadInst* loadContext(llvm::Type* type, size_t offset);
    void storeContext(Value* value, size_t offset);
    void setSite(const tree::Stmt& stmt);
    Value* int32(uint64_t v) { return b.getInt32(static_cast<uint32_t>(v)); }
    Value* int64(int64_t v) { return b.getInt64(static_cast<uint64_t>(v)); }

    // watch.cpp: nothing unless the code is watched
    Value* watchedLoad(const tree::Expr& expr);
    void watch(image::WatchKind kind, const void* node, Value* a = nullptr, Value* more = nullptr);
    void watchValue(const tree::Expr& expr, Value* value);
    void watchText(const tree::Expr& expr, const Text& text);
    void watchTextWrite(const Text& text);
    void watchPlace(image::WatchKind kind, const void* node, const Address& address, uint32_t size = 0);
    Value* m_where = nullptr;            // THIS and frame
    const tree::Stmt* m_cause = nullptr; // the statement that runs

    // guards.cpp
    void guard(Value* isBad, image::FaultCode code, Value* d0 = nullptr, Value* d1 = nullptr, Value* d2 = nullptr);
    void raiseAlways(image::FaultCode code);
    /// Faults where `value`, computed by `from`, is outside the subrange `target`.
    void guardRange(Value* value, const tree::Expr& from, types::TypeId target);
    void guardReference(Value* offset, Value* size); // null, foreign
    Value* isLive(Value* offset, Value* size);       // lies within variables or live frames
    void guardBlock(Value* offset, types::TypeId block);
    void charge(Value* amount); // units of work (facts/work.h)
    void chargeUnits(uint64_t units);
    void flushBudget();
    void reloadBudget();
    llvm::BranchInst* branchUnlikely(Value* condition, Block* rare, Block* usual);

    // places.cpp
    Address address(const tree::Place& place);
    Address readAddress(const tree::Place& place); // of what is about to be read
    Address localAddress(uint32_t local);
    Address slotAddress(const tree::Place& place); // the IN_OUT slot itself, not followed
    Address followSlot(const tree::Place& place);
    Address indexAddress(const tree::Place& place);
    enum class Purpose : uint8_t { Read, Write };
    Address textIndexAddress(const tree::Place& place, Purpose purpose);
    Address derefAddress(const tree::Place& place);
    Address imageAddress(Value* offset, types::TypeId type);
    void describeField(Address& address, types::TypeId container, uint32_t offset, types::TypeId wanted);
    Value* pointer(const Address& address);
    Value* offset(const Address& address);
    Value* load(const Address& address);
    void store(const Address& address, Value* value);
    void plainStore(const Address& address, Value* value);
    void copy(const Address& to, const Address& from, uint32_t size);
    Text textAt(const Address& address);
    std::vector<std::pair<Value*, Value*>> boundsOf(const Address& address);
    llvm::MaybeAlign alignOf(const Address& address);
    template <class Access> void tag(Access* access, const Address& address);

    // expressions.cpp
    Value* scalar(const tree::Expr& expr);
    Value* plainScalar(const tree::Expr& expr);
    Value* scalarConstant(const types::Value& value, types::TypeId type);
    Value* unary(const tree::Expr& expr);
    Value* binary(const tree::Expr& expr);
    Value* divide(Value* a, Value* c, types::TypeId type, bool isModulo, const tree::Expr* divisor);
    Value* compare(library::BinaryOp op, Value* a, Value* c, types::TypeId type);
    Value* shortCircuit(const tree::Expr& expr);
    Value* conditional(const tree::Expr& expr);
    void sequence(const tree::Expr& expr);
    Value* bound(const tree::Expr& expr);
    Value* tryCast(const tree::Expr& expr);
    Address aggregate(const tree::Expr& expr);
    Address plainAggregate(const tree::Expr& expr);
    void aggregateInto(const tree::Expr& expr, const Address& target);
    Range rangeOf(const tree::Expr& expr);
    void storeOk(const tree::Expr& expr, Value* ok);

    // conversions.cpp
    Value* convert(Value* value, types::TypeId from, types::TypeId to, Value** ok = nullptr);
    Value* convertCharacter(Value* value, types::TypeKind to, Value** ok);
    Value* firstNarrowed(const Text& wide);
    Value* convertExpr(const tree::Expr& expr);
    Value* integerToReal(Value* value, types::TypeId from, llvm::Type* to);
    Value* fitTime(Value* nanoseconds, types::TypeKind to);
    Value* startOfDay(Value* nanoseconds);
    Value* convertText(const tree::Expr& expr, types::TypeId to);
    Value* castInteger(Value* value, types::TypeId from, llvm::Type* to);
    llvm::AllocaInst* m_ok = nullptr;

    // intrinsics.cpp
    Value* intrinsic(const tree::Expr& expr);
    Value* intrinsicByHelper(const tree::Expr& expr);
    Value* operandAs(const tree::Expr& expr, size_t which);
    Value* square(const tree::Expr& expr);
    Value* selected(const tree::Expr& expr);
    Value* limited(const tree::Expr& expr);
    Value* sum(const tree::Expr& expr);
    Value* firstCharacter(const tree::Expr& expr);
    Value* isFinite(const tree::Expr& expr);
    Value* swappedBytes(const tree::Expr& expr);
    Value* mathCall(const char* single, const char* wide, std::initializer_list<Value*> operands);
    Value* mathFunction(const tree::Expr& expr);
    Value* wholeNumber(const tree::Expr& expr, llvm::Intrinsic::ID round);
    Value* absolute(const tree::Expr& expr);
    Value* shift(const tree::Expr& expr);
    Value* better(Value* candidate, Value* best, types::TypeId type, bool isMaximum);
    Value* extreme(const tree::Expr& expr);
    Value* mux(const tree::Expr& expr);
    Value* durationTimes(const tree::Expr& expr, bool isDivision);
    Value* sameBits(const tree::Expr& expr);
    Value* headerField(size_t at, llvm::Type* stored, types::TypeId type);
    Value* countOf(const tree::Expr& expr); // i64; ULINT beyond the signed range is "very many"
    Value* realToInteger(Value* whole, types::TypeId to);
    Value* okSlot();

    // texts.cpp
    Text text(const tree::Expr& expr);
    Text plainText(const tree::Expr& expr);
    void plainTextInto(const tree::Expr& expr, const Text& target);
    void textInto(const tree::Expr& expr, const Text& target);
    void textIntrinsicInto(const tree::Expr& expr, const Text& target);
    Text textTemporary(types::TypeId type);
    Value* textCall(const char* name, bool isWide, llvm::Type* result, std::vector<Value*> arguments, bool writes);
    void chargeTexts(llvm::ArrayRef<Value*> arguments);
    std::vector<Text> textOperands(const tree::Expr& expr);
    Text characterText(Value* code, bool isWide);
    Text widened(const Text& narrow, uint32_t capacity);
    Value* chooseText(const tree::Expr& expr, const Text& target);
    [[nodiscard]] bool mayOverlap(const tree::Expr& expr, const tree::Place& target) const;
    Value* textCompare(library::BinaryOp op, const Text& a, const Text& c);
    Value* textIntrinsicScalar(const tree::Expr& expr);
    bool addStringCode(std::vector<Value*>& arguments);
    void assignText(const Text& to, const Text& from);

    // calls.cpp
    struct Returned {
        Value* result = nullptr; // scalar result
        Value* frame = nullptr;  // i64 callee's frame: aggregate results lie at its begin
    };
    Returned call(const tree::Call& call);
    Value* pushCall(Value* function, Value* self, Value* frame);
    void takeOutputs(const tree::Call& call, Value* returned, Value* frame);
    std::vector<Value*> callArguments(const tree::Call& call);
    void popCall(Value* depth);
    Value* resolveTarget(const tree::Call& call, Value* self64, Value*& functionId);

    // protected.cpp: __TRY
    FunctionEmitter(const FunctionEmitter& outer, llvm::Function* part);
    void protectedStatement(const tree::Stmt& stmt);
    void catchFault(const tree::Stmt& stmt, llvm::AllocaInst* left);
    void finish(const std::vector<tree::Stmt*>& statements, llvm::AllocaInst* left);
    Value* protectedPart(const std::vector<tree::Stmt*>& statements);
    void emitPart(const std::vector<tree::Stmt*>& statements);
    void loadInOuts();
    void leave(image::Leaving how);
    void goOnLeaving(Value* how);
    Value* isFault(Value* left);
    llvm::AllocaInst* m_leaving = nullptr; // in a protected part: how it is left

    // statements.cpp, loops.cpp
    void body(const std::vector<tree::Stmt*>& statements);
    void breakBlock();
    void statement(const tree::Stmt& stmt);
    void plainStatement(const tree::Stmt& stmt);
    void assign(const tree::Stmt& stmt);
    void bind(const tree::Stmt& stmt);
    void ifStatement(const tree::Stmt& stmt);
    void caseStatement(const tree::Stmt& stmt);
    void whileLoop(const tree::Stmt& stmt);
    void repeatLoop(const tree::Stmt& stmt);
    void forLoop(const tree::Stmt& stmt);
    struct ForLoop {
        const tree::Stmt& stmt;
        Address variable;
        llvm::IntegerType* type;
        bool isSigned; // the variable
        bool comparesSigned;
        Value *first, *last, *step; // i64
    };
    void countedLoop(const ForLoop& loop);
    void steppedLoop(const ForLoop& loop);
    Value* widen(const ForLoop& loop, Value* value);
    /// value + step, and whether that exists in the variable's type.
    std::pair<Value*, Value*> stepped(const ForLoop& loop, Value* value);
    void storeCounter(const ForLoop& loop, Value* value64);
    Range counterRange(const ForLoop& loop) const;
    bool mayChange(const tree::Place& variable, const std::vector<tree::Stmt*>& body);
    void loopBody(const std::vector<tree::Stmt*>& statements, Block* exit, Block* next);
    Block* labelBlock(tree::LabelId label);

    struct Loop {
        Block* exit;
        Block* next;
    };
    /// A counted FOR's variable: reads inside the body take the counter.
    struct Counter {
        const tree::Place* variable;
        llvm::AllocaInst* value; // i64
        Range range;
    };
    const Counter* counterOf(const tree::Place& place) const;

    ModuleEmitter& m;
    Builder b;
    const uint32_t m_index;
    const tree::Function& m_tree;
    const FunctionFacts& m_facts;
    const Abi& m_abi;
    llvm::Function* m_function;
    Value *m_context, *m_image, *m_thisPointer, *m_frame64;
    Value *m_this64 = nullptr, *m_framePointer = nullptr, *m_nextFrame = nullptr; // offsets: i64
    llvm::AllocaInst* m_budget = nullptr; // optimised tier: the loop budget in a register
    llvm::Instruction* m_entryEnd = nullptr;
    Block* m_return = nullptr;
    std::vector<llvm::AllocaInst*> m_locals; // registers; IN_OUT: the offset
    std::vector<std::vector<std::pair<llvm::AllocaInst*, llvm::AllocaInst*>>> m_localBounds;
    struct Slot {
        llvm::AllocaInst* offset = nullptr;
        std::vector<std::pair<llvm::AllocaInst*, llvm::AllocaInst*>> bounds;
    };
    std::map<uint32_t, Slot> m_slots; // followed IN_OUT slots of THIS, by offset
    std::map<std::pair<unsigned, bool>, Value*> m_cache;
    uint64_t m_temporaryTop = 0, m_frameSize = 0;
    uint32_t m_site = 0, m_firstSite = 0;
    std::vector<Loop> m_loops;
    std::vector<Counter> m_counters;
    std::vector<Block*> m_labels;
    std::vector<bool> m_labelPlaced;
};

} // namespace plc::codegen
