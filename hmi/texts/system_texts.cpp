#include "hmi/texts/system_texts.h"

#include <array>

namespace plc::hmi {

namespace {

constexpr int kLanguages = 7;
constexpr const char* kTags[kLanguages] = {"en", "de", "da", "es", "fr", "ar", "zh"};

struct Row {
    SystemText text;
    const char* key;
    const char* words[kLanguages];
};

constexpr Row kRows[] = {
    {SystemText::Ok, "ok", {"OK", "OK", "OK", "Aceptar", "OK", "موافق", "确定"}},
    {SystemText::Cancel, "cancel", {"Cancel", "Abbrechen", "Annuller", "Cancelar", "Annuler", "إلغاء", "取消"}},
    {SystemText::Yes, "yes", {"Yes", "Ja", "Ja", "Sí", "Oui", "نعم", "是"}},
    {SystemText::No, "no", {"No", "Nein", "Nej", "No", "Non", "لا", "否"}},
    {SystemText::Clear, "clear", {"Clear", "Löschen", "Ryd", "Borrar", "Effacer", "مسح", "清除"}},
    {SystemText::Close, "close", {"Close", "Schließen", "Luk", "Cerrar", "Fermer", "إغلاق", "关闭"}},
    {SystemText::Time, "time", {"Time", "Zeit", "Tid", "Hora", "Heure", "الوقت", "时间"}},
    {SystemText::Alarm, "alarm", {"Alarm", "Alarm", "Alarm", "Alarma", "Alarme", "إنذار", "报警"}},
    {SystemText::NoAlarms,
     "no_alarms",
     {"No alarms", "Keine Alarme", "Ingen alarmer", "Sin alarmas", "Aucune alarme", "لا توجد إنذارات", "无报警"}},
    {SystemText::AcknowledgeAll,
     "acknowledge_all",
     {"Acknowledge all", "Alle quittieren", "Kvittér alle", "Confirmar todas", "Tout acquitter", "تأكيد الكل",
      "全部确认"}},
    {SystemText::All, "all", {"All", "Alle", "Alle", "Todas", "Toutes", "الكل", "全部"}},
    {SystemText::Unacknowledged,
     "unacknowledged",
     {"Not acknowledged", "Nicht quittiert", "Ikke kvitteret", "Sin confirmar", "Non acquittée", "غير مؤكد", "未确认"}},
    {SystemText::Acknowledged,
     "acknowledged",
     {"Acknowledged", "Quittiert", "Kvitteret", "Confirmada", "Acquittée", "مؤكد", "已确认"}},
    {SystemText::Returned,
     "returned",
     {"Returned, not acknowledged", "Gegangen, nicht quittiert", "Væk, ikke kvitteret", "Desaparecida, sin confirmar",
      "Disparue, non acquittée", "زال ولم يؤكد", "已恢复，未确认"}},
    {SystemText::Gone, "gone", {"Gone", "Gegangen", "Væk", "Desaparecida", "Disparue", "زال", "已恢复"}},
    {SystemText::Stopped,
     "stopped",
     {"The controller is stopped", "Die Steuerung ist gestoppt", "Styringen er stoppet", "El controlador está parado",
      "L’automate est arrêté", "وحدة التحكم متوقفة", "控制器已停止"}},
    {SystemText::Paused,
     "paused",
     {"The controller is paused", "Die Steuerung ist angehalten", "Styringen er sat på pause",
      "El controlador está en pausa", "L’automate est en pause", "وحدة التحكم متوقفة مؤقتًا", "控制器已暂停"}},
    {SystemText::Fault,
     "fault",
     {"The controller has a fault", "Die Steuerung meldet einen Fehler", "Styringen har en fejl",
      "El controlador tiene un fallo", "L’automate est en défaut", "عطل في وحدة التحكم", "控制器故障"}},
    {SystemText::Past,
     "past",
     {"This is the past", "Dies ist die Vergangenheit", "Dette er fortiden", "Esto es el pasado", "Ceci est le passé",
      "هذا من الماضي", "这是历史数据"}},
    {SystemText::NoController,
     "no_controller",
     {"No controller", "Keine Steuerung", "Ingen styring", "Sin controlador", "Pas d’automate", "لا توجد وحدة تحكم",
      "无控制器"}},
    {SystemText::Between,
     "between",
     {"%1 to %2", "%1 bis %2", "%1 til %2", "%1 a %2", "%1 à %2", "من %1 إلى %2", "%1 至 %2"}},
    {SystemText::AtLeast,
     "at_least",
     {"at least %1", "mindestens %1", "mindst %1", "mínimo %1", "au moins %1", "على الأقل %1", "至少 %1"}},
    {SystemText::AtMost,
     "at_most",
     {"at most %1", "höchstens %1", "højst %1", "máximo %1", "au plus %1", "على الأكثر %1", "至多 %1"}},
    {SystemText::TooLong,
     "too_long",
     {"Not written: at most %1 characters.", "Nicht geschrieben: höchstens %1 Zeichen.", "Ikke skrevet: højst %1 tegn.",
      "No escrito: %1 caracteres como máximo.", "Non écrit : %1 caractères au plus.",
      "لم تتم الكتابة: ‏%1 حرفًا على الأكثر.", "未写入：最多 %1 个字符。"}},
    {SystemText::BadCharacter,
     "bad_character",
     {"Not written: the variable can not hold one of the characters.",
      "Nicht geschrieben: Die Variable kann eines der Zeichen nicht aufnehmen.",
      "Ikke skrevet: Variablen kan ikke rumme et af tegnene.",
      "No escrito: la variable no admite uno de los caracteres.",
      "Non écrit : la variable n’admet pas l’un des caractères.", "لم تتم الكتابة: لا يقبل المتغير أحد الأحرف.",
      "未写入：变量无法保存其中的某个字符。"}},
    {SystemText::NotANumber,
     "not_a_number",
     {"This is not a number.", "Das ist keine Zahl.", "Det er ikke et tal.", "No es un número.",
      "Ce n’est pas un nombre.", "هذا ليس رقمًا.", "这不是数字。"}},
    {SystemText::OutsideLimits,
     "outside_limits",
     {"Not written: the value lies outside its limits.", "Nicht geschrieben: Der Wert liegt außerhalb der Grenzen.",
      "Ikke skrevet: Værdien ligger uden for grænserne.", "No escrito: el valor está fuera de los límites.",
      "Non écrit : la valeur est hors limites.", "لم تتم الكتابة: القيمة خارج الحدود.", "未写入:数值超出限制。"}},
    {SystemText::IsForced,
     "is_forced",
     {"Not written: the variable is forced.", "Nicht geschrieben: Die Variable ist geforct.",
      "Ikke skrevet: Variablen er tvunget.", "No escrito: la variable está forzada.",
      "Non écrit : la variable est forcée.", "لم تتم الكتابة: المتغير مفروض.", "未写入:变量已被强制。"}},
    {SystemText::NotRunning,
     "not_running",
     {"Not written: the controller is not running.", "Nicht geschrieben: Die Steuerung läuft nicht.",
      "Ikke skrevet: Styringen kører ikke.", "No escrito: el controlador no está en marcha.",
      "Non écrit : l’automate ne tourne pas.", "لم تتم الكتابة: وحدة التحكم لا تعمل.", "未写入:控制器未运行。"}},
    {SystemText::InThePast,
     "in_the_past",
     {"Not written: the panel shows the past.", "Nicht geschrieben: Das Bild zeigt die Vergangenheit.",
      "Ikke skrevet: Panelet viser fortiden.", "No escrito: el panel muestra el pasado.",
      "Non écrit : le panneau montre le passé.", "لم تتم الكتابة: تعرض اللوحة الماضي.", "未写入:面板显示历史数据。"}},
    {SystemText::NotWritable,
     "not_writable",
     {"Not written: this is not a variable.", "Nicht geschrieben: Das ist keine Variable.",
      "Ikke skrevet: Det er ikke en variabel.", "No escrito: no es una variable.",
      "Non écrit : ce n’est pas une variable.", "لم تتم الكتابة: هذا ليس متغيرًا.", "未写入:这不是变量。"}},
    {SystemText::LogIn,
     "log_in",
     {"Log in", "Anmelden", "Log ind", "Iniciar sesión", "Se connecter", "تسجيل الدخول", "登录"}},
    {SystemText::LogOut,
     "log_out",
     {"Log out", "Abmelden", "Log ud", "Cerrar sesión", "Se déconnecter", "تسجيل الخروج", "注销"}},
    {SystemText::Password,
     "password",
     {"Password", "Passwort", "Adgangskode", "Contraseña", "Mot de passe", "كلمة المرور", "密码"}},
    {SystemText::WrongPassword,
     "wrong_password",
     {"The password is wrong.", "Das Passwort ist falsch.", "Adgangskoden er forkert.", "La contraseña no es correcta.",
      "Le mot de passe est incorrect.", "كلمة المرور خاطئة.", "密码错误。"}},
    {SystemText::TooManyTries,
     "too_many_tries",
     {"Too many wrong passwords. Try again in a moment.", "Zu viele falsche Passwörter. Bitte später erneut versuchen.",
      "For mange forkerte adgangskoder. Prøv igen om lidt.", "Demasiadas contraseñas incorrectas. Inténtelo más tarde.",
      "Trop de mots de passe incorrects. Réessayez plus tard.", "كلمات مرور خاطئة كثيرة. حاول مرة أخرى لاحقًا.",
      "密码错误次数过多，请稍后再试。"}},
    {SystemText::OnlyFor,
     "only_for",
     {"Only for: %1", "Nur für: %1", "Kun for: %1", "Solo para: %1", "Réservé à : %1", "فقط لـ: %1", "仅限：%1"}},
    {SystemText::ConfirmWrite,
     "confirm_write",
     {"Write %2 to %1?", "%2 in %1 schreiben?", "Skriv %2 til %1?", "¿Escribir %2 en %1?", "Écrire %2 dans %1 ?",
      "كتابة %2 في %1؟", "将 %2 写入 %1？"}},
    {SystemText::Acknowledge,
     "acknowledge",
     {"Acknowledge", "Quittieren", "Kvittér", "Confirmar", "Acquitter", "تأكيد", "确认"}},
    {SystemText::ShowMe, "show_me", {"Show me", "Zeigen", "Vis mig", "Mostrar", "Montrer", "أرني", "显示位置"}},
    {SystemText::ShelveFor,
     "shelve_for",
     {"Shelve for %1", "Zurückstellen für %1", "Udsæt i %1", "Aplazar %1", "Mettre de côté %1", "تأجيل لمدة %1",
      "搁置 %1"}},
    {SystemText::ShelvedUntil,
     "shelved_until",
     {"Shelved until %1", "Zurückgestellt bis %1", "Udsat til %1", "Aplazada hasta %1", "Mise de côté jusqu’à %1",
      "مؤجل حتى %1", "搁置至 %1"}},
    {SystemText::OutOfService,
     "out_of_service",
     {"Out of service", "Außer Betrieb", "Ude af drift", "Fuera de servicio", "Hors service", "خارج الخدمة", "停用"}},
    {SystemText::PutBack,
     "put_back",
     {"Put back into service", "Wieder in Betrieb", "Tilbage i drift", "Volver a poner en servicio",
      "Remettre en service", "إعادة إلى الخدمة", "恢复使用"}},
    {SystemText::AlarmsPerHour,
     "alarms_per_hour",
     {"Alarms per hour", "Alarme pro Stunde", "Alarmer pr. time", "Alarmas por hora", "Alarmes par heure",
      "إنذارات في الساعة", "每小时报警数"}},
    {SystemText::AlarmFloods,
     "alarm_floods",
     {"Floods", "Alarmschauer", "Alarmbølger", "Avalanchas", "Avalanches", "فيضانات", "报警泛滥"}},
    {SystemText::StandingAlarms,
     "standing_alarms",
     {"Standing", "Anstehend", "Stående", "Permanentes", "Permanentes", "مستمرة", "长期报警"}},
    {SystemText::ChatteringAlarms,
     "chattering_alarms",
     {"Chattering", "Flatternd", "Flagrende", "Intermitentes", "Intermittentes", "متذبذبة", "抖动报警"}},
};

} // namespace

QString systemKey(SystemText text) {
    for (const Row& row : kRows)
        if (row.text == text) return QStringLiteral("hmi.") + QString::fromLatin1(row.key);
    return {};
}

QString systemText(const TextCatalog& texts, SystemText text, const QString& tag) {
    const QString key = systemKey(text);
    if (texts.table().contains(key)) return texts.text(u'@' + key, tag);
    for (const Row& row : kRows) {
        if (row.text != text) continue;
        if (tag.compare(kPseudoTag, Qt::CaseInsensitive) != 0)
            for (const QString& one : texts.settings().chain(tag))
                for (int i = 0; i < kLanguages; ++i)
                    if (one.section(u'-', 0, 0).compare(QLatin1String(kTags[i]), Qt::CaseInsensitive) == 0)
                        return QString::fromUtf8(row.words[i]);
        const QString english = QString::fromUtf8(row.words[0]);
        return tag.compare(kPseudoTag, Qt::CaseInsensitive) == 0 ? pseudoText(english) : english;
    }
    return {};
}

} // namespace plc::hmi
