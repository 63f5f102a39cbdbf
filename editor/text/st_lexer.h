// Colours of ST text in QScintilla, from the compiler's own tokens (D3): lexical at once, by meaning as soon as the
// analysis is there. Owned by its editor; GUI thread.
#pragma once
#include "projects/analysis/code_model.h"

#include <Qsci/qscilexercustom.h>

#include <unordered_map>

namespace plc::editor {

class StLexer : public QsciLexerCustom {
    Q_OBJECT
public:
    explicit StLexer(QsciScintilla* parent);
    [[nodiscard]] const char* language() const override { return "Structured Text"; }
    [[nodiscard]] QString description(int style) const override;
    void styleText(int start, int end) override;
    /// Meanings of the names of this file, from the newest analysis.
    void setModel(const std::shared_ptr<const analysis::CodeModel>& model, std::optional<FileId> file,
                  std::string_view analysedText);
    void applyTheme();
    [[nodiscard]] QColor colourOf(analysis::TokenClass kind) const;

private:
    [[nodiscard]] std::vector<analysis::ColouredToken> coloursOf(std::string_view text, uint32_t first,
                                                                 uint32_t end) const;
    void addColours(std::string_view piece, uint32_t at, std::vector<analysis::ColouredToken>& tokens) const;
    std::unordered_map<std::string, analysis::TokenClass> m_classOfName; // folded
    std::vector<analysis::ColouredToken> m_exact;                        // of m_analysedText
    std::string m_analysedText;
};

} // namespace plc::editor
