// The recursive-descent parser behind parser.h: a cursor over the tokens that are not pragmas, error recovery, and one
// method per construct, defined in the file of that construct (expressions.cpp, statements.cpp, …). One use, one
// thread.
#pragma once
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"

#include <initializer_list>

namespace plc::parse {

using lex::SoftWord;
using lex::Token;
using lex::TokenKind;
using syntax::Access;
using syntax::ActionAssociation;
using syntax::ActionDecl;
using syntax::Argument;
using syntax::ArgumentKind;
using syntax::Block;
using syntax::Body;
using syntax::BodyLanguage;
using syntax::Bounds;
using syntax::CaseArm;
using syntax::CaseLabel;
using syntax::ConfigurationDecl;
using syntax::Decl;
using syntax::DeclKind;
using syntax::EnumeratorDecl;
using syntax::Expr;
using syntax::ExprKind;
using syntax::GlobalList;
using syntax::IfBranch;
using syntax::IlInstruction;
using syntax::Name;
using syntax::NamespaceDecl;
using syntax::Path;
using syntax::Pou;
using syntax::PouKind;
using syntax::Pragma;
using syntax::ProgramInstance;
using syntax::Property;
using syntax::ResourceDecl;
using syntax::SectionKind;
using syntax::SfcBody;
using syntax::StepDecl;
using syntax::Stmt;
using syntax::StmtKind;
using syntax::SyntaxFile;
using syntax::TaskDecl;
using syntax::TestDecl;
using syntax::TransitionDecl;
using syntax::TypeDecl;
using syntax::TypeSpec;
using syntax::TypeSpecKind;
using syntax::VarDecl;
using syntax::VarEdge;
using syntax::VarSection;

/// Whether a token that is no keyword everywhere is this word where it has a meaning.
inline bool isWord(std::string_view text, std::string_view word) {
    return text.size() == word.size() && equalsIgnoringCase(text, word);
}

/// A list of statements stands in a unit, whose members and neighbours end it, or alone.
enum class BodyContext : uint8_t { Unit, Fragment };

class Parser {
public:
    Parser(SyntaxFile& file, const lex::TokenList& tokens, std::string_view text, diagnostics::Sink& sink,
           size_t lexicalErrors, Conditions conditions = {}, size_t firstToken = 0);

    // declarations.cpp
    void parseFile();
    Decl* parseDeclaration();
    void parseDeclarationsUntil(std::vector<Decl*>& out, bool inNamespace);
    Pou* parsePou(PouKind kind, TokenKind end);
    void parsePouParts(Pou& pou, TokenKind end);
    void parsePouHeader(Pou& pou);
    Pou* parseInterface();
    Pou* parseMethod(bool inInterface);
    Property* parseProperty(bool inInterface);
    Pou* parseAccessor(PouKind kind, TokenKind end, bool inInterface);
    ActionDecl* parseAction();
    Decl* parseNamespace();
    Decl* parseUsing();
    void parseModifiers(Access& access, bool* isAbstract, bool* isFinal, bool* isOverride);
    Body parseBody(BodyContext context, const std::vector<Pragma>& pragmas);
    bool atPouMember() const;
    bool atDeclaration() const;

    // types.cpp
    void parseTypeBlock(std::vector<Decl*>& out);
    TypeSpec* parseTypeSpec(bool inTypeBlock);
    TypeSpec* parseArraySpec();
    TypeSpec* parseStructSpec(TypeSpecKind kind);
    TypeSpec* parseStringSpec();
    TypeSpec* parseNamedSpec(bool inTypeBlock);
    void parseGenericValues(TypeSpec& spec);
    void parseBases(Pou& pou);
    void parseEnumerators(TypeSpec& spec);

    // variables.cpp
    VarSection* parseVarSection();
    VarDecl* parseVarDecl();
    VarDecl* parseConfigDecl(SectionKind section);
    Expr* parseInitialiser(const TypeSpec* type);
    bool atVarSection() const;
    bool atGenericSection() const;

    // expressions.cpp
    Expr* parseExpression();
    Expr* parseCondition();
    Expr* parsePlace();
    Expr* parsePrimaryIl();
    enum class LeftOut : uint8_t { Allowed, Refused }; // f(a, , b) and [1, , 3] are, m[1, , 3] is not
    void parseArguments(std::vector<Argument>& out, TokenKind close, LeftOut leftOut = LeftOut::Allowed);
    Expr* makeName(Name name);

    // statements.cpp
    Block parseStatements(BodyContext context);
    Stmt* parseStatement();
    bool atStatementEnd() const;

    // instruction_list.cpp
    bool atFunctionInstruction(size_t ahead) const;
    bool atInstructionList(size_t ahead = 0) const;
    Block parseInstructions(BodyContext context);
    Stmt* parseInstruction();

    // chart.cpp
    bool atChart() const;
    bool atStep() const;
    bool atTransition() const;
    SfcBody* parseChart();
    StepDecl* parseStep();
    TransitionDecl* parseTransition();

    // configuration.cpp
    ConfigurationDecl* parseConfiguration();

    // tests.cpp
    TestDecl* parseTest();
    Stmt* parseTestStatement(); // null when the words here are not one

    // the cursor
    const Token& peek(size_t ahead = 0) const { return m_tokens[std::min(m_at + ahead, m_tokens.size() - 1)]; }
    const Token& previous() const { return m_tokens[m_at == 0 ? 0 : m_at - 1]; }
    TokenKind kind(size_t ahead = 0) const { return peek(ahead).kind; }
    bool at(TokenKind k) const { return peek().kind == k; }
    bool at(SoftWord w) const { return peek().soft == w; }
    bool atAny(std::initializer_list<TokenKind> kinds) const;
    bool atEnd() const { return at(TokenKind::EndOfFile); }
    void advance() {
        if (m_at + 1 < m_tokens.size()) ++m_at;
    }
    bool take(TokenKind k) {
        if (!at(k)) return false;
        advance();
        return true;
    }
    bool take(SoftWord w) {
        if (!at(w)) return false;
        advance();
        return true;
    }
    std::string_view textOf(const Token& token) const { return m_text.substr(token.begin, token.end - token.begin); }
    SourceRange rangeOf(const Token& token) const { return {m_file.file, token.begin, token.end}; }
    /// From the token at `first` (an index as from `mark()`) to the last one taken.
    size_t mark() const { return m_at; }
    SourceRange rangeFrom(size_t first) const;
    template <class T> T* make() { return m_file.arena.make<T>(); }
    Name nameOf(const Token& token) const;
    bool atName(size_t ahead = 0) const;
    [[nodiscard]] bool atKeywordAsName() const;
    Name takeName(messages::Thing what = phrases::AName());
    Path takePath();

    // messages and recovery (recovery.cpp)
    /// Null when the mistake was reported already (the same token, or a token the lexer complained about).
    diagnostics::Diagnostic* report(SourceRange range, diagnostics::Finding finding);
    void expected(messages::Thing what);
    bool expect(TokenKind kind);
    messages::Thing shown(const Token& token) const;
    SourceRange afterPrevious() const; // empty, where something is missing
    void insertFix(diagnostics::Diagnostic* diagnostic, std::string text);
    void missingSemicolon(bool accepted);
    void endStatement();
    /// `END_IF` and the like; on another word says what is missing and for which word.
    bool expectEnd(TokenKind end, const Token& opening, SourceRange elseIf = {});
    void skipStatement();
    void skipTo(std::initializer_list<TokenKind> kinds);
    bool startsStatement(size_t ahead = 0) const;
    bool startsExpression() const;
    bool onNewLine() const { return peek().afterNewline || atEnd(); }
    bool endIsOpen(TokenKind end) const;

    // pragmas and comments (trivia.cpp)
    std::vector<Pragma> pragmasHere(); // directly before the current token
    Pragma readPragma(const Token& token);
    std::string_view docCommentAbove(uint32_t tokenIndex) const;
    std::string_view commentBehind(uint32_t tokenIndex) const;
    SourceRange extentOf(SourceRange range, size_t firstToken) const;
    std::string_view cleanComment(uint32_t firstComment, uint32_t lastComment) const;
    uint32_t sourceIndex(size_t at) const { return m_sourceIndex[std::min(at, m_sourceIndex.size() - 1)]; }
    bool hasNewline(uint32_t begin, uint32_t end) const;

    /// Counts nesting while it lives.
    struct Nesting {
        Parser& parser;
        bool tooDeep;
        explicit Nesting(Parser& p);
        ~Nesting() { --parser.m_depth; }
        Nesting(const Nesting&) = delete;
    };
    /// A block that is open while it lives: the words that end outer blocks are no surprise inside.
    struct OpenBlock {
        Parser& parser;
        OpenBlock(Parser& p, TokenKind end) : parser(p) { parser.m_open.push_back(end); }
        ~OpenBlock() { parser.m_open.pop_back(); }
        OpenBlock(const OpenBlock&) = delete;
    };

    static constexpr int kMaxDepth = 200;
    static constexpr uint32_t kMaxHeight = 1000;

    SyntaxFile& m_file;
    const lex::TokenList& m_list;
    Conditions m_conditions; // which tokens of m_list count
    std::string_view m_text;
    diagnostics::Sink& m_sink;
    std::vector<Token> m_tokens;         // without pragmas and unknown characters
    std::vector<uint32_t> m_sourceIndex; // into m_list.tokens
    std::vector<uint32_t> m_badOffsets;  // where the lexer complained, in order
    size_t m_at = 0;
    uint32_t m_firstToken = 0; // of m_list that is read: what is in front belongs to other units
    size_t m_lastErrorAt = SIZE_MAX;
    int m_depth = 0;
    std::vector<TokenKind> m_open;
    bool m_inTest = false;
    bool m_inInitialiser = false;
    bool m_inCondition = false;
    bool m_inInstruction = false; // formal lists may hold instructions
    int m_caseDepth = 0;          // statements directly in a CASE arm: a label ends them
    bool m_inCaseArm = false;
    std::vector<std::string_view>
        m_quotedNames; // declared in this text: "…" in an expression is such a name, else a literal
    std::string_view m_gvlName;
    Pou* m_lastPou = nullptr; // members written behind END_xxx belong to it

private:
    void parseGlobals(Decl& decl);
    void parseClass(Decl& decl);
    bool parseSoftDeclaration(Decl& decl);
    void skipToDeclaration();
    void addBody(Pou& pou, Body body, bool isFirst);
    bool parsePouMember(Pou& pou);
    bool takeForeignEnd(TokenKind end);
    TypeSpec* parseBaseType();
    bool parseTypeColon();
    TypeDecl* parseTypeDecl(std::string_view blocksComment);
    void endTypeDecl(const TypeSpec& spec);
    void parseQualifiers(VarSection& section);
    bool isSectionClosed() const;
    bool atOpenSectionsEnd() const;
    void parseAddress(VarDecl& decl);
    bool parseColon();
    void parseEdge(VarDecl& decl);
    void takeMistaken(Verbatim meant, Verbatim written);
    void skipVarDecl(size_t first);
    void endVarDecl(size_t first);
    void parseConfigTarget(VarDecl& decl);
    bool atTestStatement() const;
    void parseRun(Stmt& stmt);
    void parseCompare(Stmt& stmt);
    Expr* parseQualifiedEnumerator(Expr* member);
    Expr* parseMember(Expr* base, bool& isNamed);
    Expr* parseCall(Expr* base);
    Expr* parseIndex(Expr* base);
    Stmt* parseLabelOrJump();
    bool correctMisspelledWord();
    bool isNoStatement() const;
    Stmt* parseMistakenAssignment(Expr* place);
    void skipInstruction();
    void parseIlCall(IlInstruction& il);
    void parseIlParenthesis(IlInstruction& il, const Token& opToken);
    bool parseIlOperator(IlInstruction& il);
    Expr* parseBinary(int level);
    Expr* parseUnary();
    Expr* parsePrimary();
    Expr* parsePostfix(Expr* base);
    Expr* parseLiteral();
    Expr* parseTyped();
    Expr* parseParenthesised();
    Expr* parseArrayInit();
    Expr* parseAssigned();
    Expr* errorExpr();
    void setHeight(Expr& e);
    Stmt* makeStmt(StmtKind kind);
    Stmt* parseIf();
    Stmt* parseCase();
    Stmt* parseFor();
    Stmt* parseWhile();
    Stmt* parseRepeat();
    Stmt* parseTry();
    Stmt* parseSimple();
    bool atCaseLabel() const;
    void parseCaseLabels(CaseArm& arm);
    void expectWord(TokenKind word, const char* fixText);
    Block parseBlock(TokenKind end);
    void parseIlOperands(IlInstruction& il);
    void missingBound(const Expr* low);
    bool atCompoundAssignment() const;
    Stmt* parseCompoundAssignment(Expr* place);
    bool startsStatementInStep() const;
    void parseAssociations(StepDecl& step);
    void parseStepNames(std::vector<Name>& out);
    void parseResourceParts(ResourceDecl& resource, ConfigurationDecl* configuration, TokenKind end);
    TaskDecl* parseTask();
    ProgramInstance* parseProgramInstance();
    void decimalComma(Expr* value);
    friend struct Nesting;
};

} // namespace plc::parse
