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
    {SystemText::LogIn,
     "log_in",
     {"Log in", "Anmelden", "Log ind", "Iniciar sesión", "Se connecter", "تسجيل الدخول", "登录"}},
    {SystemText::LogOut,
     "log_out",
     {"Log out", "Abmelden", "Log ud", "Cerrar sesión", "Se déconnecter", "تسجيل الخروج", "退出"}},
    {SystemText::AccessCode,
     "access_code",
     {"Access code", "Zugangscode", "Adgangskode", "Código de acceso", "Code d’accès", "رمز الدخول", "访问码"}},
    {SystemText::WrongAccessCode,
     "wrong_access_code",
     {"The access code is wrong", "Der Zugangscode ist falsch", "Adgangskoden er forkert",
      "El código de acceso es incorrecto", "Le code d’accès est incorrect", "رمز الدخول غير صحيح", "访问码错误"}},
    {SystemText::LogInFirst,
     "log_in_first",
     {"Read only: log in to operate", "Nur Anzeige: zum Bedienen anmelden", "Kun visning: log ind for at betjene",
      "Solo lectura: inicie sesión para operar", "Lecture seule : connectez-vous pour commander",
      "للعرض فقط: سجّل الدخول للتشغيل", "只读：请登录后操作"}},
    {SystemText::ConnectionLost,
     "connection_lost",
     {"Connection lost, trying again", "Verbindung getrennt, neuer Versuch läuft",
      "Forbindelsen er afbrudt, prøver igen", "Conexión perdida, reintentando", "Connexion perdue, nouvel essai",
      "انقطع الاتصال، تجري إعادة المحاولة", "连接中断，正在重试"}},
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
    {SystemText::UntilRestart,
     "until_restart",
     {"Until the restart, not acknowledged", "Bis zum Neustart, nicht quittiert", "Indtil genstart, ikke kvitteret",
      "Hasta el reinicio, sin confirmar", "Jusqu’au redémarrage, non acquittée", "حتى إعادة التشغيل، غير مؤكد",
      "直到重启，未确认"}},
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
