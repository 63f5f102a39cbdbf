#include "runtime/compiler/parse/parser_state.h"

namespace plc::parse {

std::unique_ptr<syntax::SyntaxFile> parseFile(FileId file, std::string_view text, diagnostics::Sink& sink) {
    auto tree = std::make_unique<syntax::SyntaxFile>();
    tree->file = file;
    const size_t before = sink.all().size();
    tree->tokens = lex::tokenize(file, text, sink);
    Parser(*tree, tree->tokens, text, sink, before).parseFile();
    return tree;
}

syntax::Expr* parseExpression(syntax::SyntaxFile& file, std::string_view text, diagnostics::Sink& sink) {
    const size_t before = sink.all().size();
    const lex::TokenList tokens = lex::tokenize(file.file, text, sink);
    Parser parser(file, tokens, text, sink, before);
    if (parser.atEnd()) {
        parser.expected(phrases::AnExpression());
        return nullptr;
    }
    syntax::Expr* e = parser.parseExpression();
    parser.take(TokenKind::Semicolon);
    if (!parser.atEnd())
        parser.report(parser.rangeOf(parser.peek()), findings::UnexpectedToken(parser.shown(parser.peek())));
    return e->kind == syntax::ExprKind::Error ? nullptr : e;
}

syntax::Block parseStatements(syntax::SyntaxFile& file, std::string_view text, diagnostics::Sink& sink) {
    const size_t before = sink.all().size();
    const lex::TokenList tokens = lex::tokenize(file.file, text, sink);
    Parser parser(file, tokens, text, sink, before);
    return parser.atInstructionList() ? parser.parseInstructions(BodyContext::Fragment)
                                      : parser.parseStatements(BodyContext::Fragment);
}

} // namespace plc::parse
