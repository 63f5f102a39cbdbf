// What can be asked of a value wherever it is shown (text, watch, tree, trace, panel), and the entries of the menus
// that ask it. GUI thread.
#pragma once
#include <QString>

#include <cstdint>
#include <functional>

class QAction;
class QMenu;

namespace plc::kit {

enum class AskWhy : uint8_t { Why, WhyNot, Who };

/// "Why?", "Why Not?" and "Who Set This?", before an entry or at the end; `language`: of a panel, empty: the studio's.
void addWhyActions(QMenu& menu, const std::function<void(AskWhy)>& ask, QAction* before = nullptr,
                   const QString& language = {});

} // namespace plc::kit
