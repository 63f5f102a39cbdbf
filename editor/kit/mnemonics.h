// A letter to press with Alt for every entry of a menu and every button and field of a dialog, no two alike, in each
// language. A letter written with & in a text is kept. GUI thread.
#pragma once
#include <QStringList>

class QApplication;
class QWidget;

namespace plc::kit {

/// The texts with one & each. Texts in Chinese get theirs as “(&X)”: of the English they were translated from, else of
/// the name in `hints`.
[[nodiscard]] QStringList withMnemonics(const QStringList& texts, const QStringList& hints);

/// "&Save" without its mark, "保存(&S)" without the letter.
[[nodiscard]] QString withoutMnemonic(const QString& text);

/// To a menu bar, a menu or a dialog as it is now.
void giveMnemonics(QWidget& of);

/// To every menu and dialog of the application when it opens; Tab leaves every field of a dialog, too. Once is enough.
void keepMnemonics(QApplication& application);

} // namespace plc::kit
