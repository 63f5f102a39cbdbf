// What the name of a curve already says: its unit, and a colour. So that no legend has a unit twice, and the lamp
// called "red" is not drawn green. Pure functions, any thread.
#pragma once
#include <QString>

namespace plc::kit {

/// "Level [%]"; the name alone where it ends with the unit or there is none.
[[nodiscard]] QString withUnit(const QString& name, const QString& unit);
[[nodiscard]] bool namesUnit(const QString& name, const QString& unit);
/// "red" of `Main.LampRed`, `bRed`, `red_lamp` or "Rote Lampe"; empty where no colour or more than one is named.
[[nodiscard]] QString colorNamed(const QString& name);

} // namespace plc::kit
