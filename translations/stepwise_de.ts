<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>DeviceFields</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>Aktiviert</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Unit number</source>
        <translation>Gerätenummer</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Serielle Schnittstelle</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Baudrate</translation>
    </message>
    <message>
        <source>Parity</source>
        <translation>Parität</translation>
    </message>
    <message>
        <source>Data bits</source>
        <translation>Datenbits</translation>
    </message>
    <message>
        <source>Stop bits</source>
        <translation>Stoppbits</translation>
    </message>
    <message>
        <source>Poll interval</source>
        <translation>Abfrageintervall</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>Zeitlimit</translation>
    </message>
    <message>
        <source>Longest pause between attempts</source>
        <translation>Längste Pause zwischen Versuchen</translation>
    </message>
    <message>
        <source>Variable: device responds</source>
        <translation>Variable: Gerät antwortet</translation>
    </message>
    <message>
        <source>Client ID</source>
        <translation>Client-ID</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Password file</source>
        <translation>Passwortdatei</translation>
    </message>
    <message>
        <source>TLS encryption</source>
        <translation>TLS-Verschlüsselung</translation>
    </message>
    <message>
        <source>File of CA certificates</source>
        <translation>Datei der CA-Zertifikate</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Bit of the register</source>
        <translation>Bit des Registers</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Bytereihenfolge</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Offset</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>Topic</translation>
    </message>
    <message>
        <source>Path in the JSON message</source>
        <translation>Pfad in der JSON-Nachricht</translation>
    </message>
    <message>
        <source>Quality of service (0 to 2)</source>
        <translation>Dienstgüte (QoS 0 bis 2)</translation>
    </message>
    <message>
        <source>Retained message</source>
        <translation>Nachricht bleibt beim Broker (Retain)</translation>
    </message>
    <message>
        <source>If the connection is lost</source>
        <translation>Bei Verbindungsverlust</translation>
    </message>
    <message>
        <source>Safe value</source>
        <translation>Sicherer Wert</translation>
    </message>
    <message>
        <source>Variable: channel is good</source>
        <translation>Variable: Kanal ist gültig</translation>
    </message>
    <message>
        <source>Modbus TCP device</source>
        <translation>Modbus-TCP-Gerät</translation>
    </message>
    <message>
        <source>Modbus RTU device (serial)</source>
        <translation>Modbus-RTU-Gerät (seriell)</translation>
    </message>
    <message>
        <source>Modbus TCP server</source>
        <translation>Modbus-TCP-Server</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>MQTT-Broker</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>Coil</translation>
    </message>
    <message>
        <source>Discrete input</source>
        <translation>Diskreter Eingang</translation>
    </message>
    <message>
        <source>Holding register</source>
        <translation>Halteregister</translation>
    </message>
    <message>
        <source>Input register</source>
        <translation>Eingangsregister</translation>
    </message>
    <message>
        <source>Keep the last value</source>
        <translation>Letzten Wert behalten</translation>
    </message>
    <message>
        <source>Use the safe value</source>
        <translation>Sicheren Wert verwenden</translation>
    </message>
    <message>
        <source>Stop the controller</source>
        <translation>Steuerung anhalten</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>Odd</source>
        <translation>Ungerade</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
</context>
<context>
    <name>Devices</name>
    <message>
        <source>This is not valid JSON; check the commas and quotes in front of this line</source>
        <translation>Das ist kein gültiges JSON; prüfen Sie Kommas und Anführungszeichen vor dieser Zeile</translation>
    </message>
    <message>
        <source>The file must be an object with a list named &quot;devices&quot;</source>
        <translation>Die Datei muss ein Objekt mit einer Liste namens „devices“ sein</translation>
    </message>
    <message>
        <source>Each entry of &quot;{0}&quot; must be an object in braces</source>
        <translation>Jeder Eintrag von „{0}“ muss ein Objekt in geschweiften Klammern sein</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is missing; add it</source>
        <translation>„{0}“ fehlt; ergänzen Sie es</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a text in quotes</source>
        <translation>„{0}“ muss ein Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be true or false</source>
        <translation>„{0}“ muss true oder false sein</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a number</source>
        <translation>„{0}“ muss eine Zahl sein</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a whole number from {1} to {2}</source>
        <translation>„{0}“ muss eine ganze Zahl von {1} bis {2} sein</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a time such as &quot;100ms&quot; or &quot;2s&quot;, at least {1} ms and at most an hour</source>
        <translation>„{0}“ muss eine Zeit wie „100ms“ oder „2s“ sein, mindestens {1}&#xa0;ms und höchstens eine Stunde</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; cannot be {1}; choose one of: {2}</source>
        <translation>„{0}“ kann nicht {1} sein; zulässig sind: {2}</translation>
    </message>
    <message>
        <source>There is no field &quot;{0}&quot;; it is kept but has no effect</source>
        <translation>Es gibt kein Feld „{0}“; es bleibt erhalten, hat aber keine Wirkung</translation>
    </message>
    <message>
        <source>There is no field &quot;{0}&quot;; did you mean &quot;{1}&quot;?</source>
        <translation>Es gibt kein Feld „{0}“; war „{1}“ gemeint?</translation>
    </message>
    <message>
        <source>There are two devices named {0}; rename one</source>
        <translation>Zwei Geräte heißen {0}; benennen Sie eines um</translation>
    </message>
    <message>
        <source>{0} has two channels named {1}; rename one</source>
        <translation>{0} hat zwei Kanäle namens {1}; benennen Sie einen um</translation>
    </message>
    <message>
        <source>{0} is not a name; use letters, digits and underscores, and begin with a letter</source>
        <translation>{0} ist kein gültiger Name; verwenden Sie Buchstaben, Ziffern und Unterstriche, am Anfang einen Buchstaben</translation>
    </message>
    <message>
        <source>{0} is neither a host name nor an address, for example plc1.local or 192.168.0.10</source>
        <translation>{0} ist weder ein Hostname noch eine Adresse, zum Beispiel plc1.local oder 192.168.0.10</translation>
    </message>
    <message>
        <source>{0} is not a serial port; write its path, for example /dev/ttyUSB0</source>
        <translation>{0} ist keine serielle Schnittstelle; schreiben Sie ihren Pfad, zum Beispiel /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>{0} and {1} both listen on port {2}; change one of the ports</source>
        <translation>{0} und {1} verwenden beide den Port {2}; ändern Sie einen der Ports</translation>
    </message>
    <message>
        <source>Ports below 1024 require special privileges; use a port such as 1502</source>
        <translation>Ports unter 1024 erfordern besondere Rechte; verwenden Sie einen Port wie 1502</translation>
    </message>
    <message>
        <source>A channel of an MQTT device needs a &quot;topic&quot;, for example &quot;plant/level&quot;</source>
        <translation>Ein Kanal eines MQTT-Geräts braucht ein „topic“, zum Beispiel „plant/level“</translation>
    </message>
    <message>
        <source>{0}: a channel has one topic, without the wildcards + and #</source>
        <translation>{0}: Ein Kanal hat genau ein Topic, ohne die Platzhalter + und #</translation>
    </message>
    <message>
        <source>{0} is not a path into JSON; write for example /sensor/temperature</source>
        <translation>{0} ist kein Pfad in JSON; schreiben Sie zum Beispiel /sensor/temperature</translation>
    </message>
    <message>
        <source>A device does not let others write its table &quot;{0}&quot;; use &quot;coil&quot; or &quot;holding&quot;, or the direction &quot;in&quot;</source>
        <translation>Die Tabelle „{0}“ eines Geräts kann nicht geschrieben werden; verwenden Sie „coil“ oder „holding“ oder die Richtung „in“</translation>
    </message>
    <message>
        <source>Clients cannot write the table &quot;{0}&quot; of a server; use &quot;coil&quot; or &quot;holding&quot;, or the direction &quot;out&quot;</source>
        <translation>Clients können die Tabelle „{0}“ eines Servers nicht schreiben; verwenden Sie „coil“ oder „holding“ oder die Richtung „out“</translation>
    </message>
    <message>
        <source>{0} needs {1} {1:register|registers} from {2}, but 65535 is the last; choose a lower address</source>
        <translation>{0} braucht {1} Register ab {2}, das letzte ist jedoch 65535; wählen Sie eine niedrigere Adresse</translation>
    </message>
    <message>
        <source>&quot;bit&quot; selects one bit of a register; the type must then be BOOL</source>
        <translation>„bit“ wählt ein Bit eines Registers; der Typ muss dann BOOL sein</translation>
    </message>
    <message>
        <source>The table &quot;{0}&quot; holds bits; the type must be BOOL</source>
        <translation>Die Tabelle „{0}“ enthält Bits; der Typ muss BOOL sein</translation>
    </message>
    <message>
        <source>A BOOL in a register needs &quot;bit&quot;, from 0 to 15</source>
        <translation>Ein BOOL in einem Register braucht „bit“, von 0 bis 15</translation>
    </message>
    <message>
        <source>Only an MQTT channel can be of type STRING; use a number or BOOL</source>
        <translation>Nur ein MQTT-Kanal kann vom Typ STRING sein; verwenden Sie eine Zahl oder BOOL</translation>
    </message>
    <message>
        <source>&quot;scale&quot; must not be 0; omit it for 1</source>
        <translation>„scale“ darf nicht 0 sein; lassen Sie es für 1 weg</translation>
    </message>
    <message>
        <source>A {0} has no &quot;scale&quot; and &quot;offset&quot;; remove them</source>
        <translation>{0} hat weder „scale“ noch „offset“; entfernen Sie beide</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}: {1}</translation>
    </message>
    <message>
        <source>{0} has no variable yet; enter one, or have the addresses proposed (stepwise devices PROJECT --propose)</source>
        <translation>{0} hat noch keine Variable; geben Sie eine an oder lassen Sie Adressen vorschlagen (stepwise devices PROJECT --propose)</translation>
    </message>
    <message>
        <source>{0} is of type {1} and cannot hold a {2}; use a variable of that type</source>
        <translation>{0} ist vom Typ {1} und kann kein {2} aufnehmen; verwenden Sie eine Variable dieses Typs</translation>
    </message>
    <message>
        <source>A {0} may not fit into {1} of type {2}; a value that does not fit leaves the variable as it is and makes the channel bad</source>
        <translation>Ein {0} passt eventuell nicht in {1} vom Typ {2}; ein zu großer Wert lässt die Variable unverändert und macht den Kanal ungültig</translation>
    </message>
    <message>
        <source>{0} is an output of the program; an input channel needs %I or a variable</source>
        <translation>{0} ist ein Ausgang des Programms; ein Eingangskanal braucht %I oder eine Variable</translation>
    </message>
    <message>
        <source>{0} is an input of the program; an output channel needs %Q or a variable</source>
        <translation>{0} ist ein Eingang des Programms; ein Ausgangskanal braucht %Q oder eine Variable</translation>
    </message>
    <message>
        <source>{0} is a constant and cannot be written; choose a variable</source>
        <translation>{0} ist eine Konstante und kann nicht geschrieben werden; wählen Sie eine Variable</translation>
    </message>
    <message>
        <source>{0} reports the quality of the channel and must be a BOOL or an integer</source>
        <translation>{0} zeigt an, ob der Kanal gültig ist, und muss BOOL oder eine Ganzzahl sein</translation>
    </message>
    <message>
        <source>{0} reports whether the device responds and must be a BOOL</source>
        <translation>{0} zeigt an, ob das Gerät antwortet, und muss BOOL sein</translation>
    </message>
    <message>
        <source>&quot;onLoss&quot;: &quot;safe&quot; needs the value in &quot;safe&quot;</source>
        <translation>„onLoss“: „safe“ braucht den Wert in „safe“</translation>
    </message>
    <message>
        <source>{0} cannot be read; its first line must be the password</source>
        <translation>{0} kann nicht gelesen werden; die erste Zeile muss das Passwort sein</translation>
    </message>
    <message>
        <source>{0} cannot be read; it must contain the certificates of the authority (PEM)</source>
        <translation>{0} kann nicht gelesen werden; die Datei muss die Zertifikate der Zertifizierungsstelle enthalten (PEM)</translation>
    </message>
    <message>
        <source>no response within {0} ms; check the cable, the address and the unit number</source>
        <translation>keine Antwort innerhalb von {0}&#xa0;ms; prüfen Sie Kabel, Adresse und Gerätenummer</translation>
    </message>
    <message>
        <source>the connection ended: {0}; it is being set up again</source>
        <translation>die Verbindung wurde beendet: {0}; sie wird wieder aufgebaut</translation>
    </message>
    <message>
        <source>the response does not match the request; check baud rate, parity and unit number</source>
        <translation>die Antwort passt nicht zur Anfrage; prüfen Sie Baudrate, Parität und Gerätenummer</translation>
    </message>
    <message>
        <source>the device rejects {0} {1}: {2}</source>
        <translation>das Gerät lehnt {0} {1} ab: {2}</translation>
    </message>
    <message>
        <source>it does not know the function; choose another table</source>
        <translation>es kennt die Funktion nicht; wählen Sie eine andere Tabelle</translation>
    </message>
    <message>
        <source>it has no such address; check the address in its manual</source>
        <translation>es hat keine solche Adresse; prüfen Sie die Adresse in seinem Handbuch</translation>
    </message>
    <message>
        <source>it does not accept the value; check the range in its manual</source>
        <translation>es nimmt den Wert nicht an; prüfen Sie den Bereich in seinem Handbuch</translation>
    </message>
    <message>
        <source>it reports a failure; check the device</source>
        <translation>es meldet eine Störung; prüfen Sie das Gerät</translation>
    </message>
    <message>
        <source>it is busy; the request will be repeated</source>
        <translation>es ist beschäftigt; die Anfrage wird wiederholt</translation>
    </message>
    <message>
        <source>the gateway cannot reach it; check the unit number and the cable after the gateway</source>
        <translation>das Gateway erreicht es nicht; prüfen Sie die Gerätenummer und das Kabel hinter dem Gateway</translation>
    </message>
    <message>
        <source>cannot listen on {0}: {1}; choose another address or port</source>
        <translation>kann an {0} nicht auf Verbindungen warten: {1}; wählen Sie eine andere Adresse oder einen anderen Port</translation>
    </message>
    <message>
        <source>{0}: the message holds no value that can be read; check what the device publishes</source>
        <translation>{0}: Die Nachricht enthält keinen lesbaren Wert; prüfen Sie, was das Gerät veröffentlicht</translation>
    </message>
    <message>
        <source>{0}: a value does not fit into the variable; use a larger type or a scale</source>
        <translation>{0}: Ein Wert passt nicht in die Variable; verwenden Sie einen größeren Typ oder eine Skalierung</translation>
    </message>
    <message>
        <source>no client has written for {0} ms; check the client and its address</source>
        <translation>seit {0}&#xa0;ms hat kein Client geschrieben; prüfen Sie den Client und seine Adresse</translation>
    </message>
    <message>
        <source>the broker rejects the connection: {0}; check the user and the password</source>
        <translation>der Broker lehnt die Verbindung ab: {0}; prüfen Sie Benutzer und Passwort</translation>
    </message>
    <message>
        <source>the input {0} of the device {1} was lost; check the device and its cable</source>
        <translation>der Eingang {0} des Geräts {1} ist ausgefallen; prüfen Sie das Gerät und sein Kabel</translation>
    </message>
    <message>
        <source>the input {0} of the device {1} was lost: {2}</source>
        <translation>der Eingang {0} des Geräts {1} ist ausgefallen: {2}</translation>
    </message>
    <message>
        <source>Start or build the project first; the devices are connected to its controller</source>
        <translation>Starten oder übersetzen Sie das Projekt zuerst; die Geräte sind mit seiner Steuerung verbunden</translation>
    </message>
    <message>
        <source>The project had no devices when its controller was built; add them and build again</source>
        <translation>Das Projekt hatte keine Geräte, als das Programm der Steuerung übersetzt wurde; fügen Sie sie hinzu und übersetzen Sie erneut</translation>
    </message>
    <message>
        <source>The devices had errors when the controller was built; correct them and build again</source>
        <translation>Die Geräte hatten Fehler, als das Programm der Steuerung übersetzt wurde; berichtigen Sie sie und übersetzen Sie erneut</translation>
    </message>
    <message>
        <source>Set the speed to real time first; devices cannot follow any other speed</source>
        <translation>Stellen Sie die Geschwindigkeit zuerst auf Echtzeit; mit einer anderen können Geräte nicht mithalten</translation>
    </message>
    <message>
        <source>The devices of an attached controller are connected there; detach to connect them here</source>
        <translation>Die Geräte einer angebundenen Steuerung sind dort verbunden; beenden Sie die Verbindung, um sie hier anzuschließen</translation>
    </message>
    <message>
        <source>{0} and {1} write the same bytes: {2}; change an address</source>
        <translation>{0} und {1} schreiben dieselben Bytes: {2}; ändern Sie eine Adresse</translation>
    </message>
    <message>
        <source>There is no free address left for {0}; give it a variable</source>
        <translation>Für {0} ist keine Adresse mehr frei; geben Sie ihm eine Variable</translation>
    </message>
    <message>
        <source>{0} has no channels, so nothing is exchanged; add one</source>
        <translation>{0} hat keine Kanäle, es wird also nichts ausgetauscht; fügen Sie einen hinzu</translation>
    </message>
    <message>
        <source>cannot connect to {0}: {1}; check the address and the cable</source>
        <translation>keine Verbindung zu {0}: {1}; prüfen Sie Adresse und Kabel</translation>
    </message>
    <message>
        <source>{0} and {1} are both unit {2} of {3}; give one of them another number</source>
        <translation>{0} und {1} haben beide die Adresse {2} an {3}; geben Sie einem davon eine andere</translation>
    </message>
    <message>
        <source>{0} and {1} use {2} with different baud rates, parities or bits; set the same for both</source>
        <translation>{0} und {1} verwenden {2} mit unterschiedlichen Baudraten, Paritäten oder Bits; stellen Sie für beide dasselbe ein</translation>
    </message>
    <message>
        <source>{0} and {1} both set {2} {3}; give each its own</source>
        <translation>{0} und {1} setzen beide {2} {3}; geben Sie jedem ein eigenes</translation>
    </message>
    <message>
        <source>{0} and {1} are both unit {2} at {3}; if one was copied from the other, change its address</source>
        <translation>{0} und {1} haben beide die Adresse {2} an {3}; wurde eines vom anderen kopiert, ändern Sie seine Adresse</translation>
    </message>
</context>
<context>
    <name>Diagnostics</name>
    <message>
        <source>Unterminated comment; close it with *)</source>
        <translation>Kommentar nicht abgeschlossen; mit *) schließen</translation>
    </message>
    <message>
        <source>Unterminated string; add the closing quote</source>
        <translation>Zeichenkette nicht abgeschlossen; schließendes Anführungszeichen ergänzen</translation>
    </message>
    <message>
        <source>Expected {0} before {1}</source>
        <translation>{0} wird vor {1} erwartet</translation>
    </message>
    <message>
        <source>A semicolon is missing here; add it</source>
        <translation>Hier fehlt ein Semikolon; ergänzen</translation>
    </message>
    <message>
        <source>{0} is missing for this {1}; add it</source>
        <translation>{0} fehlt zu diesem {1}; ergänzen</translation>
    </message>
    <message>
        <source>This comparison has no effect; use := to assign</source>
        <translation>Dieser Vergleich hat keine Wirkung; zum Zuweisen := verwenden</translation>
    </message>
    <message>
        <source>An assignment is not a condition; use = to compare</source>
        <translation>Eine Zuweisung ist keine Bedingung; zum Vergleichen = verwenden</translation>
    </message>
    <message>
        <source>A colon is missing between the name and its type; add it</source>
        <translation>Zwischen Name und Typ fehlt ein Doppelpunkt; ergänzen</translation>
    </message>
    <message>
        <source>Decimal numbers use a point; write {0}</source>
        <translation>In Dezimalzahlen wird ein Punkt verwendet; {0} schreiben</translation>
    </message>
    <message>
        <source>An open bound is written ARRAY[*] and is only allowed for VAR_IN_OUT; declare it there, or write a number</source>
        <translation>Eine offene Grenze wird als ARRAY[*] geschrieben und ist nur bei VAR_IN_OUT erlaubt; dort deklarieren oder eine Zahl angeben</translation>
    </message>
    <message>
        <source>{0} is missing: the program unit ends here; add it</source>
        <translation>{0} fehlt: Der Baustein endet hier; ergänzen</translation>
    </message>
    <message>
        <source>A semicolon is missing: the statement ends here; add it</source>
        <translation>Ein Semikolon fehlt: Die Anweisung endet hier; ergänzen</translation>
    </message>
    <message>
        <source>Implicit conversion from {0} to {1} may lose data; convert it explicitly</source>
        <translation>Bei der impliziten Konvertierung von {0} nach {1} können Daten verloren gehen; explizit konvertieren</translation>
    </message>
    <message>
        <source>{0} is an IN_OUT parameter and needs a variable of type {1}</source>
        <translation>{0} ist ein IN_OUT-Parameter und braucht eine Variable vom Typ {1}</translation>
    </message>
    <message>
        <source>{0} has only the bits 0 to {1}; use one of them</source>
        <translation>{0} hat nur die Bits 0 bis {1}; eines davon verwenden</translation>
    </message>
    <message>
        <source>{0} is ambiguous: {1}; write the namespace before it</source>
        <translation>{0} ist mehrdeutig: {1}; den Namensraum davor schreiben</translation>
    </message>
    <message>
        <source>The character {0} is not in STRING ({1}); use WSTRING, or &quot;stringEncoding&quot;: &quot;UTF-8&quot; in project.json</source>
        <translation>Das Zeichen {0} ist nicht in STRING ({1}); WSTRING verwenden oder &quot;stringEncoding&quot;: &quot;UTF-8&quot; in project.json</translation>
    </message>
    <message>
        <source>{0} and {1} are compared as {2}; convert one of them</source>
        <translation>{0} und {1} werden als {2} verglichen; eines davon konvertieren</translation>
    </message>
    <message>
        <source>{0} is not checked against the enumeration {1}; use one of its names</source>
        <translation>{0} wird nicht gegen die Enumeration {1} geprüft; einen ihrer Namen verwenden</translation>
    </message>
    <message>
        <source>{0} is {1}; write {2}</source>
        <translation>{0} ist {1}; {2} schreiben</translation>
    </message>
    <message>
        <source>{0} contains itself; use a REFERENCE TO</source>
        <translation>{0} enthält sich selbst; REFERENCE TO verwenden</translation>
    </message>
    <message>
        <source>The parameters of {0} must match those of the overridden method; copy its declarations</source>
        <translation>Die Parameter von {0} müssen mit denen der überschriebenen Methode übereinstimmen; deren Deklarationen übernehmen</translation>
    </message>
    <message>
        <source>There are several programs and no CONFIGURATION; name one of them Main or write a CONFIGURATION</source>
        <translation>Es gibt mehrere Programme und keine CONFIGURATION; eines in Main umbenennen oder eine CONFIGURATION schreiben</translation>
    </message>
    <message>
        <source>The range {0}..{1} is not valid: the lower bound is above the upper bound or there are too many elements; correct the bounds</source>
        <translation>Der Bereich {0}..{1} ist ungültig: Die Untergrenze liegt über der Obergrenze oder es sind zu viele Elemente; die Grenzen berichtigen</translation>
    </message>
    <message>
        <source>{0} has an incomplete address; complete it in a VAR_CONFIG</source>
        <translation>{0} hat eine unvollständige Adresse; in einem VAR_CONFIG vervollständigen</translation>
    </message>
    <message>
        <source>{0} may call itself; the depth of recursion is limited at run time; a loop is safer</source>
        <translation>{0} kann sich selbst aufrufen; die Rekursionstiefe ist zur Laufzeit begrenzt; eine Schleife ist sicherer</translation>
    </message>
    <message>
        <source>The steps before this transition cannot be active together; start them from one simultaneous branch</source>
        <translation>Die Schritte vor dieser Transition können nicht gemeinsam aktiv sein; aus einem Parallelzweig starten</translation>
    </message>
    <message>
        <source>This transition is always true; the step before it lasts one scan; write the condition to wait for</source>
        <translation>Diese Transition ist immer wahr; der Schritt davor ist nur einen Zyklus aktiv; die Bedingung schreiben, auf die gewartet werden soll</translation>
    </message>
    <message>
        <source>The qualifier {0} needs a time, for example T#2s</source>
        <translation>Das Bestimmungszeichen {0} braucht eine Zeit, zum Beispiel T#2s</translation>
    </message>
    <message>
        <source>{0} needs a current result; load one with LD</source>
        <translation>{0} braucht ein aktuelles Ergebnis; mit LD laden</translation>
    </message>
    <message>
        <source>{0} is not a value of the strict enumeration {1}; use one of its names</source>
        <translation>{0} ist kein Wert der strikten Enumeration {1}; einen ihrer Namen verwenden</translation>
    </message>
    <message>
        <source>{0} is a strict enumeration and cannot be used in arithmetic; convert the value with {1}</source>
        <translation>{0} ist eine strikte Enumeration und kann nicht in Berechnungen verwendet werden; den Wert mit {1} konvertieren</translation>
    </message>
    <message>
        <source>{0} cannot compare {1} as a whole; compare the members one by one</source>
        <translation>{0} kann {1} nicht als Ganzes vergleichen; die Elemente einzeln vergleichen</translation>
    </message>
    <message>
        <source>A CASE selector must be an integer, enumeration or character, not {0}; use IF and ELSIF</source>
        <translation>Ein CASE-Selektor muss eine Ganzzahl, eine Enumeration oder ein Zeichen sein, nicht {0}; IF und ELSIF verwenden</translation>
    </message>
    <message>
        <source>{0} and {1} share storage at {2}; move one of them or write STRUCT OVERLAP</source>
        <translation>{0} und {1} teilen sich den Speicher bei {2}; eines davon verschieben oder STRUCT OVERLAP schreiben</translation>
    </message>
    <message>
        <source>A member&apos;s address is relative to the start of its structure (%B4, %X4.1), not {0}</source>
        <translation>Die Adresse eines Elements ist relativ zum Anfang seiner Struktur (%B4, %X4.1), nicht {0}</translation>
    </message>
    <message>
        <source>{0} and {1} share the address {2}; {3} is free</source>
        <translation>{0} und {1} teilen sich die Adresse {2}; frei ist {3}</translation>
    </message>
    <message>
        <source>{0} belongs to the chart and must be {1}</source>
        <translation>{0} gehört zur Schrittkette und muss {1} sein</translation>
    </message>
    <message>
        <source>{0} has no effect without {1}; declare both</source>
        <translation>{0} wirkt nicht ohne {1}; beide deklarieren</translation>
    </message>
    <message>
        <source>A step lists its actions here; write statements in an ACTION</source>
        <translation>Ein Schritt führt hier seine Aktionen auf; Anweisungen gehören in eine ACTION</translation>
    </message>
    <message>
        <source>No transition leads away from step {0}; the chart ends here; add a TRANSITION if it should go on</source>
        <translation>Von Schritt {0} führt keine Transition weg; die Schrittkette endet hier; eine TRANSITION ergänzen, wenn sie weiterlaufen soll</translation>
    </message>
    <message>
        <source>{0} is also a variable; steps and calls mean the ACTION; rename one of the two</source>
        <translation>{0} ist auch eine Variable; Schritte und Aufrufe meinen die ACTION; eines von beiden umbenennen</translation>
    </message>
    <message>
        <source>Use {1} instead of {0} in Structured Text</source>
        <translation>In Strukturiertem Text {1} statt {0} verwenden</translation>
    </message>
    <message>
        <source>The task {0} has no INTERVAL above zero and no SINGLE; it runs in every scan; give it an INTERVAL to slow it down</source>
        <translation>Die Task {0} hat kein INTERVAL über null und kein SINGLE; sie läuft in jedem Zyklus; mit INTERVAL eine Zykluszeit angeben</translation>
    </message>
    <message>
        <source>{0} is read as {1}; write a time with its unit</source>
        <translation>{0} wird als {1} gelesen; eine Zeit mit Einheit schreiben</translation>
    </message>
    <message>
        <source>The address {0} has {1} {1:bit|bits}, {2} has {3}; write {4}</source>
        <translation>Die Adresse {0} hat {1} Bit, {2} hat {3}; {4} schreiben</translation>
    </message>
    <message>
        <source>{0} is an input declared CONSTANT and is assigned to here; remove CONSTANT or assign to another variable</source>
        <translation>{0} ist als Eingang mit CONSTANT deklariert, und hier wird ihm ein Wert zugewiesen; CONSTANT entfernen oder einer anderen Variablen zuweisen</translation>
    </message>
    <message>
        <source>{0}</source>
        <translation>{0}</translation>
    </message>
    <message>
        <source>The condition {0} is not known; combine defined, hasvalue, hasattribute and hastype with NOT, AND and OR</source>
        <translation>Die Bedingung {0} ist unbekannt; defined, hasvalue, hasattribute und hastype mit NOT, AND und OR verknüpfen</translation>
    </message>
    <message>
        <source>The pragma {0} is missing for this {1}; add it</source>
        <translation>Zu diesem {1} fehlt das Pragma {0}; ergänzen</translation>
    </message>
    <message>
        <source>The character {0} has no meaning here; remove it</source>
        <translation>Das Zeichen {0} hat hier keine Bedeutung; entfernen</translation>
    </message>
    <message>
        <source>This is nested too deeply to be compiled; split it into several statements or units</source>
        <translation>Das ist zu tief verschachtelt, um übersetzt zu werden; in mehrere Anweisungen oder Bausteine aufteilen</translation>
    </message>
    <message>
        <source>Code in C is not executed; write it in ST</source>
        <translation>Code in C wird nicht ausgeführt; in ST schreiben</translation>
    </message>
    <message>
        <source>{0} is specified twice; remove one of the two</source>
        <translation>{0} ist doppelt angegeben; eine der beiden Angaben entfernen</translation>
    </message>
    <message>
        <source>{0} is not an array or string; remove the index or declare it as an ARRAY</source>
        <translation>{0} ist weder Array noch Zeichenkette; den Index entfernen oder als ARRAY deklarieren</translation>
    </message>
    <message>
        <source>The divisor is always zero; divide by another value</source>
        <translation>Der Divisor ist immer null; durch einen anderen Wert teilen</translation>
    </message>
    <message>
        <source>A constant is needed here; write a value or the name of a VAR CONSTANT</source>
        <translation>Hier wird eine Konstante gebraucht; einen Wert oder den Namen einer VAR CONSTANT schreiben</translation>
    </message>
    <message>
        <source>{0} is not a pointer or reference; use it without ^ or declare it with REF_TO</source>
        <translation>{0} ist weder Zeiger noch Referenz; ohne ^ verwenden oder mit REF_TO deklarieren</translation>
    </message>
    <message>
        <source>{0} does not return a value; call it in a statement of its own</source>
        <translation>{0} liefert keinen Wert; in einer eigenen Anweisung aufrufen</translation>
    </message>
    <message>
        <source>{0} is abstract and cannot be instantiated; use a block that extends it</source>
        <translation>{0} ist abstrakt und kann nicht instanziiert werden; einen Baustein verwenden, der ihn erweitert</translation>
    </message>
    <message>
        <source>{0} is {1} and cannot be used here; make it PUBLIC or use it inside its block</source>
        <translation>{0} ist {1} und kann hier nicht verwendet werden; als PUBLIC deklarieren oder innerhalb des Bausteins verwenden</translation>
    </message>
    <message>
        <source>The result of {0} is not used; assign it to a variable</source>
        <translation>Das Ergebnis von {0} wird nicht verwendet; einer Variablen zuweisen</translation>
    </message>
    <message>
        <source>{0} is declared twice; rename or remove one of the two</source>
        <translation>{0} ist doppelt deklariert; eine der beiden Deklarationen umbenennen oder entfernen</translation>
    </message>
    <message>
        <source>There is no type {0}; declare it or add the library that contains it</source>
        <translation>Es gibt keinen Typ {0}; ihn deklarieren oder die Bibliothek hinzufügen, die ihn enthält</translation>
    </message>
    <message>
        <source>{0} is never used; remove its declaration</source>
        <translation>{0} wird nie verwendet; die Deklaration entfernen</translation>
    </message>
    <message>
        <source>{0} is read but never written; give it a value or declare it as CONSTANT</source>
        <translation>{0} wird gelesen, aber nie geschrieben; einen Wert zuweisen oder als CONSTANT deklarieren</translation>
    </message>
    <message>
        <source>This is never executed; remove it or change what is before it</source>
        <translation>Das wird nie ausgeführt; entfernen oder ändern, was davor steht</translation>
    </message>
    <message>
        <source>The result of {0} is not set on every path; assign it before the first RETURN or IF</source>
        <translation>Das Ergebnis von {0} wird nicht auf jedem Pfad gesetzt; vor dem ersten RETURN oder IF zuweisen</translation>
    </message>
    <message>
        <source>CASE has no branch for {0} and no ELSE; add one of them</source>
        <translation>CASE hat keinen Zweig für {0} und kein ELSE; eines von beiden hinzufügen</translation>
    </message>
    <message>
        <source>{0} already has a branch; remove one of the two</source>
        <translation>{0} hat bereits einen Zweig; einen der beiden entfernen</translation>
    </message>
    <message>
        <source>The task {0} is declared twice; rename one of the two</source>
        <translation>Die Task {0} ist doppelt deklariert; eine der beiden umbenennen</translation>
    </message>
    <message>
        <source>There is no task {0}; declare it with TASK in this configuration</source>
        <translation>Es gibt keine Task {0}; mit TASK in dieser Konfiguration deklarieren</translation>
    </message>
    <message>
        <source>{0} does not implement {1} of {2}; add it</source>
        <translation>{0} implementiert {1} von {2} nicht; {1} hinzufügen</translation>
    </message>
    <message>
        <source>{0} is FINAL and cannot be extended or overridden; remove FINAL or use another base</source>
        <translation>{0} ist FINAL und kann weder erweitert noch überschrieben werden; FINAL entfernen oder eine andere Basis verwenden</translation>
    </message>
    <message>
        <source>There is no label {0}; write it with a colon before a statement of this unit</source>
        <translation>Es gibt keine Sprungmarke {0}; sie mit Doppelpunkt vor eine Anweisung dieses Bausteins schreiben</translation>
    </message>
    <message>
        <source>The variables need {0} bytes; the maximum is {1}: make arrays or strings smaller</source>
        <translation>Die Variablen brauchen {0} Bytes; das Maximum ist {1}: Arrays oder Zeichenketten verkleinern</translation>
    </message>
    <message>
        <source>There is no PROGRAM to run; add one</source>
        <translation>Es gibt kein PROGRAM zum Ausführen; eines hinzufügen</translation>
    </message>
    <message>
        <source>There is no namespace {0}; declare it or add the library that contains it</source>
        <translation>Es gibt keinen Namensraum {0}; ihn deklarieren oder die Bibliothek hinzufügen, die ihn enthält</translation>
    </message>
    <message>
        <source>{0} is not a variable of this configuration; write program instance and variable, as in Main.x</source>
        <translation>{0} ist keine Variable dieser Konfiguration; Programminstanz und Variable schreiben, wie in Main.x</translation>
    </message>
    <message>
        <source>{0} restarts on every call because functions keep no state; use a FUNCTION_BLOCK</source>
        <translation>{0} beginnt bei jedem Aufruf neu, weil Funktionen keinen Zustand speichern; einen FUNCTION_BLOCK verwenden</translation>
    </message>
    <message>
        <source>Too many initial values: {0} for {1} {1:element|elements}; remove some or enlarge the array</source>
        <translation>Zu viele Initialwerte: {0} für {1} {1:Element|Elemente}; einige entfernen oder das Array vergrößern</translation>
    </message>
    <message>
        <source>This loop never ends and would stop the controller; give it a condition or an EXIT</source>
        <translation>Diese Schleife endet nie; die Steuerung würde darin hängen bleiben; eine Bedingung oder ein EXIT hinzufügen</translation>
    </message>
    <message>
        <source>{0} is marked OVERRIDE, but no base has a method with this name; remove OVERRIDE or correct the name</source>
        <translation>{0} ist mit OVERRIDE gekennzeichnet, aber kein Basisbaustein hat eine Methode dieses Namens; OVERRIDE entfernen oder den Namen berichtigen</translation>
    </message>
    <message>
        <source>The chart has no INITIAL_STEP; declare its first step with INITIAL_STEP instead of STEP</source>
        <translation>Die Schrittkette hat keinen INITIAL_STEP; den ersten Schritt mit INITIAL_STEP statt STEP deklarieren</translation>
    </message>
    <message>
        <source>The chart has two initial steps: {0} and {1}; declare one of them with STEP</source>
        <translation>Die Schrittkette hat zwei Initialschritte: {0} und {1}; einen davon mit STEP deklarieren</translation>
    </message>
    <message>
        <source>There is no step {0}; declare it or correct the name</source>
        <translation>Es gibt keinen Schritt {0}; ihn deklarieren oder den Namen berichtigen</translation>
    </message>
    <message>
        <source>No transition leads to step {0}; it can never become active: add a TRANSITION to it</source>
        <translation>Zu Schritt {0} führt keine Transition; er kann nie aktiv werden: eine TRANSITION zu ihm hinzufügen</translation>
    </message>
    <message>
        <source>There is no action or BOOL variable {0}; add an ACTION or declare the variable</source>
        <translation>Es gibt keine Aktion oder BOOL-Variable {0}; eine ACTION hinzufügen oder die Variable deklarieren</translation>
    </message>
    <message>
        <source>The step {0} is declared twice; rename or remove one of the two</source>
        <translation>Der Schritt {0} ist doppelt deklariert; einen der beiden umbenennen oder entfernen</translation>
    </message>
    <message>
        <source>{0} appears twice in this step with qualifier {1}; remove one of the two</source>
        <translation>{0} kommt in diesem Schritt doppelt mit dem Bestimmungszeichen {1} vor; eines der beiden entfernen</translation>
    </message>
    <message>
        <source>The parenthesis of this instruction is not closed; add an instruction ) after its operands</source>
        <translation>Die Klammer dieser Anweisung ist nicht geschlossen; nach ihren Operanden eine Anweisung ) hinzufügen</translation>
    </message>
    <message>
        <source>{0} needs memory that the project does not set aside; write &quot;memoryForNew&quot;: 65536 into project.json</source>
        <translation>{0} braucht Speicher, den das Projekt nicht vorsieht; &quot;memoryForNew&quot;: 65536 in project.json eintragen</translation>
    </message>
    <message>
        <source>{0} is not a block of this program and cannot have a task of its own; name one of its blocks</source>
        <translation>{0} ist kein Funktionsbaustein dieses Programms und kann keine eigene Task haben; einen seiner Funktionsbausteine angeben</translation>
    </message>
    <message>
        <source>{0} cannot hold an exception code; declare it as __SYSTEM.ExceptionCode</source>
        <translation>{0} kann keinen Ausnahmecode aufnehmen; als __SYSTEM.ExceptionCode deklarieren</translation>
    </message>
    <message>
        <source>{0} converts the number, as in CODESYS; to keep the bits, put both types into a UNION</source>
        <translation>{0} konvertiert die Zahl wie in CODESYS; um die Bits zu erhalten, beide Typen in eine UNION legen</translation>
    </message>
    <message>
        <source>{0} calls itself, which is not allowed: {1}; use a loop instead</source>
        <translation>{0} ruft sich selbst auf, was nicht erlaubt ist: {1}; stattdessen eine Schleife verwenden</translation>
    </message>
    <message>
        <source>The loop variable {0} is changed inside its loop; use WHILE or another variable</source>
        <translation>Die Schleifenvariable {0} wird in ihrer Schleife geändert; WHILE oder eine andere Variable verwenden</translation>
    </message>
    <message>
        <source>There is no global variable {0} of type {1}; declare it in VAR_GLOBAL</source>
        <translation>Es gibt keine globale Variable {0} vom Typ {1}; in VAR_GLOBAL deklarieren</translation>
    </message>
    <message>
        <source>The text has {0} and will be truncated to {1}; declare a longer string</source>
        <translation>Der Text hat {0} und wird auf {1} gekürzt; eine längere Zeichenkette deklarieren</translation>
    </message>
    <message>
        <source>This integer division discards the fraction before the conversion to {0}; convert an operand first</source>
        <translation>Diese Ganzzahldivision schneidet die Nachkommastellen vor der Konvertierung nach {0} ab; zuerst einen Operanden konvertieren</translation>
    </message>
    <message>
        <source>{0} is computed as {1} and may overflow before the conversion to {2}; convert an operand first</source>
        <translation>{0} wird als {1} berechnet und kann vor der Konvertierung in {2} überlaufen; zuerst einen Operanden konvertieren</translation>
    </message>
    <message>
        <source>{0} is not an IL operator; use one such as LD, ST, AND or JMP</source>
        <translation>{0} ist kein AWL-Operator; zum Beispiel LD, ST, AND oder JMP verwenden</translation>
    </message>
    <message>
        <source>This array has {0} {0:dimension|dimensions}, not {1}; write an index for each</source>
        <translation>Dieses Array hat {0} {0:Dimension|Dimensionen}, nicht {1}; für jede einen Index schreiben</translation>
    </message>
    <message>
        <source>{0} is not a valid {1} literal; check its prefix, digits and units</source>
        <translation>{0} ist kein gültiges Literal ({1}); Präfix, Ziffern und Einheiten prüfen</translation>
    </message>
    <message>
        <source>Unexpected {0}; remove it or complete the statement before it</source>
        <translation>Unerwartet: {0}; entfernen oder die Anweisung davor vervollständigen</translation>
    </message>
    <message>
        <source>The pragma {0} is not known and has no effect; remove it or correct its name</source>
        <translation>Das Pragma {0} ist unbekannt und ohne Wirkung; entfernen oder den Namen korrigieren</translation>
    </message>
    <message>
        <source>{0} is a keyword and cannot be used as a name; choose another name</source>
        <translation>{0} ist ein Schlüsselwort und kann nicht als Name verwendet werden; einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>{0} is not declared; declare it or correct the name</source>
        <translation>{0} ist nicht deklariert; deklarieren oder den Namen korrigieren</translation>
    </message>
    <message>
        <source>{0} has no member {1}; correct the name or add the member</source>
        <translation>{0} hat kein Element {1}; den Namen korrigieren oder das Element hinzufügen</translation>
    </message>
    <message>
        <source>{0} cannot be converted to {1}; use a value of that type or a conversion function</source>
        <translation>{0} kann nicht in {1} konvertiert werden; einen Wert dieses Typs oder eine Konvertierungsfunktion verwenden</translation>
    </message>
    <message>
        <source>{0} cannot be assigned to; assign to a variable</source>
        <translation>{0} kann nichts zugewiesen werden; einer Variablen zuweisen</translation>
    </message>
    <message>
        <source>{0} cannot be used with {1}; convert the operand first</source>
        <translation>{0} kann nicht mit {1} verwendet werden; den Operanden zuerst konvertieren</translation>
    </message>
    <message>
        <source>{0} cannot combine {1} and {2}; convert one of them</source>
        <translation>{0} kann {1} und {2} nicht verknüpfen; einen von beiden konvertieren</translation>
    </message>
    <message>
        <source>{0} cannot be called; call a function, a method or an instance of a block</source>
        <translation>{0} kann nicht aufgerufen werden; eine Funktion, eine Methode oder eine Bausteininstanz aufrufen</translation>
    </message>
    <message>
        <source>{0} has no parameter {1}; correct the name or declare the parameter</source>
        <translation>{0} hat keinen Parameter {1}; den Namen korrigieren oder den Parameter deklarieren</translation>
    </message>
    <message>
        <source>The argument for {1} of {0} is missing; add it to the call</source>
        <translation>Das Argument für {1} von {0} fehlt; im Aufruf ergänzen</translation>
    </message>
    <message>
        <source>{0} takes {1} {1:argument|arguments}; remove the others</source>
        <translation>{0} hat {1} {1:Argument|Argumente}; die übrigen entfernen</translation>
    </message>
    <message>
        <source>The index {0} is outside {1}..{2}; correct it or enlarge the array</source>
        <translation>Der Index {0} liegt außerhalb von {1}..{2}; den Index korrigieren oder das Array vergrößern</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}; use another value or a larger type</source>
        <translation>{0} passt nicht in {1}; einen anderen Wert oder einen größeren Typ verwenden</translation>
    </message>
    <message>
        <source>The condition must be BOOL, not {0}; add a comparison</source>
        <translation>Die Bedingung muss BOOL sein, nicht {0}; einen Vergleich hinzufügen</translation>
    </message>
    <message>
        <source>The address {0} is outside {1}; use an address in that range</source>
        <translation>Die Adresse {0} liegt außerhalb von {1}; eine Adresse in diesem Bereich verwenden</translation>
    </message>
    <message>
        <source>{0} is not allowed in a watch or binding, which cannot have side effects; do it in the program</source>
        <translation>{0} ist in Überwachungen und Variablenbindungen nicht erlaubt; dort sind keine Seiteneffekte zulässig; im Programm ausführen</translation>
    </message>
    <message>
        <source>A reference needs a variable that has an address; assign the value to a variable first</source>
        <translation>Eine Referenz braucht eine Variable mit Adresse; den Wert zuerst einer Variablen zuweisen</translation>
    </message>
    <message>
        <source>An index must be an integer, not {0}; convert it</source>
        <translation>Ein Index muss eine Ganzzahl sein, nicht {0}; konvertieren</translation>
    </message>
    <message>
        <source>{1} cannot extend {0}; choose a base of the same kind</source>
        <translation>{1} kann {0} nicht erweitern; eine Basis derselben Art wählen</translation>
    </message>
    <message>
        <source>{0} is not allowed {1}; move or remove it</source>
        <translation>{0} ist {1} nicht erlaubt; verschieben oder entfernen</translation>
    </message>
    <message>
        <source>{0} is only allowed inside a loop; move or remove it</source>
        <translation>{0} ist nur in einer Schleife erlaubt; verschieben oder entfernen</translation>
    </message>
    <message>
        <source>Step {0} can become active twice at the same time: the branches from here do not join; join them with one transition</source>
        <translation>Schritt {0} kann zweimal gleichzeitig aktiv werden: Die Zweige von hier werden nicht zusammengeführt; mit einer Transition zusammenführen</translation>
    </message>
    <message>
        <source>{0} is only allowed in a TEST; move it there</source>
        <translation>{0} ist nur in einem TEST erlaubt; dorthin verschieben</translation>
    </message>
    <message>
        <source>This is not text in UTF-8; save the file as UTF-8, or remove it from the project if it is not a text file</source>
        <translation>Das ist kein Text in UTF-8; die Datei als UTF-8 speichern oder, falls sie keine Textdatei ist, aus dem Projekt entfernen</translation>
    </message>
    <message>
        <source>{0} is not an action qualifier; use N, R, S, L, D, P, P0, P1, SD, DS or SL</source>
        <translation>{0} ist kein Bestimmungszeichen; N, R, S, L, D, P, P0, P1, SD, DS oder SL verwenden</translation>
    </message>
    <message>
        <source>{0} needs a time after :=, for example T#5s; write one or remove the pragma</source>
        <translation>{0} braucht hinter := eine Zeit, zum Beispiel T#5s; eine schreiben oder das Pragma entfernen</translation>
    </message>
</context>
<context>
    <name>DiskChange</name>
    <message>
        <source>Changed outside</source>
        <translation>Außerhalb geändert</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and here too.</source>
        <translation>%1 wurde von einem anderen Programm geändert und auch hier.</translation>
    </message>
    <message>
        <source>Compare both side by side, load the file from disk and lose the changes made here, or keep what is here and replace the file with the next save?</source>
        <translation>Beide nebeneinander vergleichen, die Datei von der Platte laden und die Änderungen hier verlieren, oder behalten, was hier steht, und die Datei beim nächsten Speichern ersetzen?</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Vergleichen…</translation>
    </message>
    <message>
        <source>Load from Disk</source>
        <translation>Von der Platte laden</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Meine Version behalten</translation>
    </message>
</context>
<context>
    <name>EditHistory</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>division by zero; check the divisor first</source>
        <translation>Division durch null; prüfen Sie zuerst den Divisor</translation>
    </message>
    <message>
        <source>index {0} is used on an empty array; check its bounds first</source>
        <translation>Zugriff auf Index {0} eines leeren Arrays; prüfen Sie zuerst seine Grenzen</translation>
    </message>
    <message>
        <source>index {0} is outside {1}..{2}; use an index in this range or enlarge the array</source>
        <translation>Index {0} liegt außerhalb von {1}..{2}; verwenden Sie einen Index aus diesem Bereich oder vergrößern Sie das Array</translation>
    </message>
    <message>
        <source>character {0} is read from an empty string; check LEN first</source>
        <translation>Zugriff auf Zeichen {0} einer leeren Zeichenkette; prüfen Sie zuerst LEN</translation>
    </message>
    <message>
        <source>character {0} is outside {1}..{2} of the string; use an index in this range</source>
        <translation>Zeichen {0} liegt außerhalb von {1}..{2} der Zeichenkette; verwenden Sie einen Index aus diesem Bereich</translation>
    </message>
    <message>
        <source>calls are nested too deeply; check for endless recursion</source>
        <translation>Aufrufe sind zu tief verschachtelt; prüfen Sie auf endlose Rekursion</translation>
    </message>
    <message>
        <source>the called method has no body; override it in the block that is called</source>
        <translation>die aufgerufene Methode hat keinen Rumpf; überschreiben Sie sie in dem Baustein, der aufgerufen wird</translation>
    </message>
    <message>
        <source>the scan was aborted</source>
        <translation>der Zyklus wurde abgebrochen</translation>
    </message>
    <message>
        <source>there is no expression; enter one</source>
        <translation>es gibt keinen Ausdruck; geben Sie einen ein</translation>
    </message>
    <message>
        <source>the program of this scan does not have it; choose a later scan</source>
        <translation>im Programm dieses Zyklus nicht vorhanden; wählen Sie einen späteren Zyklus</translation>
    </message>
    <message>
        <source>has no value here</source>
        <translation>hat hier keinen Wert</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}: {1}</translation>
    </message>
    <message>
        <source>simulation: {0}</source>
        <translation>Simulation: {0}</translation>
    </message>
    <message>
        <source>warm</source>
        <translation>warm</translation>
    </message>
    <message>
        <source>cold</source>
        <translation>kalt</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>in the middle of a scan</source>
        <translation>mitten in einem Zyklus</translation>
    </message>
    <message>
        <source>{0}</source>
        <translation>{0}</translation>
    </message>
    <message>
        <source>{0} := {1}</source>
        <translation>{0} := {1}</translation>
    </message>
    <message>
        <source>no such file or folder; check the path</source>
        <translation>Datei oder Ordner nicht gefunden; prüfen Sie den Pfad</translation>
    </message>
    <message>
        <source>permission denied; check the permissions of the file and its folder</source>
        <translation>keine Berechtigung; prüfen Sie die Rechte der Datei und ihres Ordners</translation>
    </message>
    <message>
        <source>no space left on the device; free some space and try again</source>
        <translation>kein Speicherplatz mehr auf dem Datenträger; geben Sie Speicherplatz frei und versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>it is a folder; choose a file</source>
        <translation>es ist ein Ordner; wählen Sie eine Datei</translation>
    </message>
    <message>
        <source>it is not a folder; choose a folder</source>
        <translation>es ist kein Ordner; wählen Sie einen Ordner</translation>
    </message>
    <message>
        <source>the device reports a read or write error; check the drive or the cable</source>
        <translation>der Datenträger meldet einen Lese- oder Schreibfehler; prüfen Sie das Laufwerk oder das Kabel</translation>
    </message>
    <message>
        <source>it already exists; choose another name</source>
        <translation>es ist bereits vorhanden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>the file is too large; choose a smaller one</source>
        <translation>die Datei ist zu groß; wählen Sie eine kleinere</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>This is not a regular file and cannot be replaced; choose another name</source>
        <translation>Das ist keine gewöhnliche Datei und kann nicht ersetzt werden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>The recording cannot be written: {0}</source>
        <translation>Die Aufzeichnung kann nicht geschrieben werden: {0}</translation>
    </message>
    <message>
        <source>The recording cannot be read: {0}</source>
        <translation>Die Aufzeichnung kann nicht gelesen werden: {0}</translation>
    </message>
    <message>
        <source>This version of Stepwise lays out the program&apos;s variables differently; open the recording with the version that made it</source>
        <translation>Diese Version von Stepwise ordnet die Variablen des Programms anders an; öffnen Sie die Aufzeichnung mit der Version, die sie erstellt hat</translation>
    </message>
    <message>
        <source>The recording cannot be opened: {0}</source>
        <translation>Die Aufzeichnung kann nicht geöffnet werden: {0}</translation>
    </message>
    <message>
        <source>its program has errors; open the recording with the version of Stepwise that made it</source>
        <translation>ihr Programm enthält Fehler; öffnen Sie die Aufzeichnung mit der Version von Stepwise, die sie erstellt hat</translation>
    </message>
    <message>
        <source>The recording contains no program; record the run again with this version</source>
        <translation>Die Aufzeichnung enthält kein Programm; zeichnen Sie den Lauf mit dieser Version neu auf</translation>
    </message>
    <message>
        <source>This scan is no longer in the recording; choose a later one</source>
        <translation>Dieser Zyklus ist nicht mehr in der Aufzeichnung; wählen Sie einen späteren</translation>
    </message>
    <message>
        <source>The program that recorded this scan is no longer available; choose a scan after the last change of the program</source>
        <translation>Das Programm, das diesen Zyklus aufgezeichnet hat, ist nicht mehr verfügbar; wählen Sie einen Zyklus nach der letzten Programmänderung</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is ambiguous; write one of {1}</source>
        <translation>„{0}“ ist mehrdeutig; geben Sie eines von {1} an</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; has no variable &apos;{1}&apos;; did you mean &apos;{2}&apos;?</source>
        <translation>„{0}“ hat keine Variable „{1}“; meinten Sie „{2}“?</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; has no variable &apos;{1}&apos;; check the name</source>
        <translation>„{0}“ hat keine Variable „{1}“; prüfen Sie den Namen</translation>
    </message>
    <message>
        <source>there is no variable &apos;{0}&apos;; did you mean &apos;{1}&apos;?</source>
        <translation>es gibt keine Variable „{0}“; meinten Sie „{1}“?</translation>
    </message>
    <message>
        <source>there is no variable &apos;{0}&apos;; check the name or declare it</source>
        <translation>es gibt keine Variable „{0}“; prüfen Sie den Namen oder deklarieren Sie sie</translation>
    </message>
    <message>
        <source>a variable of type {1} has no member &apos;{0}&apos;; check the name</source>
        <translation>eine Variable vom Typ {1} hat kein Element „{0}“; prüfen Sie den Namen</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is a VAR_IN_OUT; write the variable that is connected to it</source>
        <translation>„{0}“ ist ein VAR_IN_OUT; schreiben Sie die damit verbundene Variable</translation>
    </message>
    <message>
        <source>{0} needs {1} {1:index|indices}, not {2}; write one for each dimension</source>
        <translation>{0} braucht {1} {1:Index|Indizes}, nicht {2}; schreiben Sie je Dimension einen</translation>
    </message>
    <message>
        <source>bit {0} is outside 0..{1}; use a bit in this range</source>
        <translation>Bit {0} liegt außerhalb von 0..{1}; verwenden Sie ein Bit aus diesem Bereich</translation>
    </message>
    <message>
        <source>part {0} is outside 0..{1}; use a part in this range</source>
        <translation>Teil {0} liegt außerhalb von 0..{1}; verwenden Sie einen Teil aus diesem Bereich</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is not an address; write for example %IX0.0, %QB4 or %MW2</source>
        <translation>„{0}“ ist keine Adresse; schreiben Sie zum Beispiel %IX0.0, %QB4 oder %MW2</translation>
    </message>
    <message>
        <source>the path cannot be read from &apos;{0}&apos; on; write for example Main.a[2].x</source>
        <translation>der Pfad ist ab „{0}“ nicht lesbar; schreiben Sie zum Beispiel Main.a[2].x</translation>
    </message>
    <message>
        <source>{0} is forced; release the force before writing</source>
        <translation>{0} ist geforct; heben Sie das Forcen vor dem Schreiben auf</translation>
    </message>
    <message>
        <source>the variable is not forced; there is nothing to release</source>
        <translation>die Variable ist nicht geforct; es gibt kein Forcen aufzuheben</translation>
    </message>
    <message>
        <source>the initial values of the new program cause a fault: {0}</source>
        <translation>die Initialwerte des neuen Programms führen zu einem Fehler: {0}</translation>
    </message>
    <message>
        <source>The retain file cannot be written: {0}</source>
        <translation>Die Retain-Datei kann nicht geschrieben werden: {0}</translation>
    </message>
    <message>
        <source>The retain file cannot be read: {0}; the program starts with its initial values</source>
        <translation>Die Retain-Datei kann nicht gelesen werden: {0}; das Programm startet mit seinen Initialwerten</translation>
    </message>
    <message>
        <source>The retain file is damaged; the program starts with its initial values</source>
        <translation>Die Retain-Datei ist beschädigt; das Programm startet mit seinen Initialwerten</translation>
    </message>
    <message>
        <source>{0}; it is kept as {1}</source>
        <translation>{0}; sie bleibt als {1} erhalten</translation>
    </message>
    <message>
        <source>{0} retained {0:value does|values do} not fit the program: {1}; they start with their initial values</source>
        <translation>{0} {0:remanenter Wert passt|remanente Werte passen} nicht zum Programm: {1}; sie starten mit ihren Initialwerten</translation>
    </message>
    <message>
        <source>{0} does not fit into a variable of type {1}; enter a value in its range</source>
        <translation>{0} passt nicht in eine Variable vom Typ {1}; geben Sie einen Wert aus seinem Bereich ein</translation>
    </message>
    <message>
        <source>the value does not fit into a variable of type {0}; enter one in its range</source>
        <translation>der Wert passt nicht in eine Variable vom Typ {0}; geben Sie einen aus seinem Bereich ein</translation>
    </message>
    <message>
        <source>{0} is outside {1}..{2}; enter a value in this range</source>
        <translation>{0} liegt außerhalb von {1}..{2}; geben Sie einen Wert aus diesem Bereich ein</translation>
    </message>
    <message>
        <source>a character of the text does not fit into a STRING; use a WSTRING</source>
        <translation>ein Zeichen des Textes passt nicht in einen STRING; verwenden Sie einen WSTRING</translation>
    </message>
    <message>
        <source>a reference can only be set to NULL from outside; assign a variable to it in the program</source>
        <translation>eine Referenz kann von außen nur auf NULL gesetzt werden; weisen Sie ihr im Programm eine Variable zu</translation>
    </message>
    <message>
        <source>{0} is not a value for {1}, which is {2}</source>
        <translation>{0} ist kein Wert für {1} vom Typ {2}</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}, which is {2}</source>
        <translation>{0} passt nicht in {1} vom Typ {2}</translation>
    </message>
    <message>
        <source>{0}; {1}</source>
        <translation>{0}; {1}</translation>
    </message>
    <message>
        <source>did you mean {0}?</source>
        <translation>meinten Sie {0}?</translation>
    </message>
    <message>
        <source>its values are {0}</source>
        <translation>die Werte sind {0}</translation>
    </message>
    <message>
        <source>write it in quotes, for example {0}; only WSTRING has every character</source>
        <translation>schreiben Sie ihn in Anführungszeichen, zum Beispiel {0}; nur WSTRING hat alle Zeichen</translation>
    </message>
    <message>
        <source>write it in quotes, for example {0}</source>
        <translation>schreiben Sie ihn in Anführungszeichen, zum Beispiel {0}</translation>
    </message>
    <message>
        <source>write one character in quotes, for example {0}</source>
        <translation>schreiben Sie ein Zeichen in Anführungszeichen, zum Beispiel {0}</translation>
    </message>
    <message>
        <source>write all elements, for example {0}, or a single one by its index</source>
        <translation>schreiben Sie alle Elemente, zum Beispiel {0}, oder ein einzelnes über seinen Index</translation>
    </message>
    <message>
        <source>write its members, for example {0}, or a single one by its path</source>
        <translation>schreiben Sie seine Elemente, zum Beispiel {0}, oder ein einzelnes über seinen Pfad</translation>
    </message>
    <message>
        <source>write {0} or {1}</source>
        <translation>schreiben Sie {0} oder {1}</translation>
    </message>
    <message>
        <source>write for example {0}</source>
        <translation>schreiben Sie zum Beispiel {0}</translation>
    </message>
    <message>
        <source>write a number, for example {0}</source>
        <translation>schreiben Sie eine Zahl, zum Beispiel {0}</translation>
    </message>
    <message>
        <source>write an integer, for example {0}</source>
        <translation>schreiben Sie eine ganze Zahl, zum Beispiel {0}</translation>
    </message>
    <message>
        <source>There is no program to optimise; declare a PROGRAM</source>
        <translation>Kein Programm zum Optimieren vorhanden; deklarieren Sie ein PROGRAM</translation>
    </message>
    <message>
        <source>this is local to a running call and has no address of its own; pause in the call to see it</source>
        <translation>das ist lokal in einem laufenden Aufruf und hat keine eigene Adresse; halten Sie im Aufruf an, um es zu sehen</translation>
    </message>
    <message>
        <source>this part of a computed value cannot be shown; assign the value to a variable first</source>
        <translation>dieser Teil eines berechneten Werts kann nicht angezeigt werden; weisen Sie den Wert zuerst einer Variablen zu</translation>
    </message>
    <message>
        <source>a character of a string has no address of its own; use the whole string</source>
        <translation>ein Zeichen einer Zeichenkette hat keine eigene Adresse; verwenden Sie die ganze Zeichenkette</translation>
    </message>
    <message>
        <source>this variable cannot be shown; assign it to another variable and watch that one</source>
        <translation>diese Variable kann nicht angezeigt werden; weisen Sie sie einer anderen Variablen zu und überwachen Sie diese</translation>
    </message>
    <message>
        <source>this array of variable length has no address here; watch the array that is passed to it</source>
        <translation>dieses Array variabler Länge hat hier keine Adresse; überwachen Sie das Array, das übergeben wird</translation>
    </message>
    <message>
        <source>the array has no such dimension; count them from 1</source>
        <translation>das Array hat keine solche Dimension; zählen Sie ab 1</translation>
    </message>
    <message>
        <source>this has no value</source>
        <translation>das hat keinen Wert</translation>
    </message>
    <message>
        <source>only standard functions can be called here; use a function of the library</source>
        <translation>hier können nur Standardfunktionen aufgerufen werden; verwenden Sie eine Funktion der Bibliothek</translation>
    </message>
    <message>
        <source>a cast to an interface cannot be watched; watch the instance itself</source>
        <translation>eine Konvertierung in eine Schnittstelle kann nicht überwacht werden; überwachen Sie die Instanz selbst</translation>
    </message>
    <message>
        <source>this cannot be evaluated; use variables, operators and standard functions</source>
        <translation>das kann nicht ausgewertet werden; verwenden Sie Variablen, Operatoren und Standardfunktionen</translation>
    </message>
    <message>
        <source>The code generator failed, which is an error of Stepwise: {0}; report it with the program</source>
        <translation>Der Codegenerator ist fehlgeschlagen, ein Fehler in Stepwise: {0}; melden Sie ihn mit dem Programm</translation>
    </message>
    <message>
        <source>The code generator produced an invalid module, which is an error of Stepwise: {0}; report it with the program</source>
        <translation>Der Codegenerator hat ein ungültiges Modul erzeugt, ein Fehler in Stepwise: {0}; melden Sie ihn mit dem Programm</translation>
    </message>
    <message>
        <source>not compiled</source>
        <translation>nicht übersetzt</translation>
    </message>
    <message>
        <source>Code for the thread sanitizer needs a process that runs under it</source>
        <translation>Code für den Thread-Sanitizer braucht einen Prozess, der unter ihm läuft</translation>
    </message>
    <message>
        <source>the program could not be optimised: {0}</source>
        <translation>das Programm konnte nicht optimiert werden: {0}</translation>
    </message>
    <message>
        <source>the program has errors; correct them first</source>
        <translation>das Programm enthält Fehler; beheben Sie sie zuerst</translation>
    </message>
    <message>
        <source>the online change waits until the scan that is halted at a breakpoint has ended; press F5 to continue</source>
        <translation>der Online-Change wartet, bis der am Haltepunkt angehaltene Zyklus beendet ist; fahren Sie mit F5 fort</translation>
    </message>
    <message>
        <source>This body is not an instruction list; choose a unit that is written in IL</source>
        <translation>Dieser Rumpf ist keine Anweisungsliste; wählen Sie einen Baustein in AWL</translation>
    </message>
    <message>
        <source>This body is not ST; choose a unit that is written in ST</source>
        <translation>Dieser Rumpf ist kein ST; wählen Sie einen Baustein in ST</translation>
    </message>
    <message>
        <source>{0} has no equivalent in an instruction list; write it with simpler statements first</source>
        <translation>{0} hat in einer Anweisungsliste keine Entsprechung; schreiben Sie es zuerst mit einfacheren Anweisungen</translation>
    </message>
    <message>
        <source>{0} is already written in ST</source>
        <translation>{0} ist bereits in ST geschrieben</translation>
    </message>
    <message>
        <source>{0} is already written in IL</source>
        <translation>{0} ist bereits in AWL geschrieben</translation>
    </message>
    <message>
        <source>Fix the text first: {0}</source>
        <translation>Beheben Sie zuerst den Fehler im Text: {0}</translation>
    </message>
    <message>
        <source>There is no equivalent in the other language: {0}</source>
        <translation>In der anderen Sprache gibt es keine Entsprechung: {0}</translation>
    </message>
    <message>
        <source>This is a folder; choose a file</source>
        <translation>Das ist ein Ordner; wählen Sie eine Datei</translation>
    </message>
    <message>
        <source>This is a device; choose a file</source>
        <translation>Das ist ein Gerät; wählen Sie eine Datei</translation>
    </message>
    <message>
        <source>The file cannot be read: {0}</source>
        <translation>Die Datei kann nicht gelesen werden: {0}</translation>
    </message>
    <message>
        <source>The file cannot be replaced: {0}</source>
        <translation>Die Datei kann nicht ersetzt werden: {0}</translation>
    </message>
    <message>
        <source>The file cannot be written: {0}</source>
        <translation>Die Datei kann nicht geschrieben werden: {0}</translation>
    </message>
    <message>
        <source>project.json is not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>project.json ist kein gültiges JSON; suchen Sie nach einem fehlenden Komma, Anführungszeichen oder einer Klammer</translation>
    </message>
    <message>
        <source>project.json must contain one JSON object; put its contents in braces</source>
        <translation>project.json muss ein JSON-Objekt enthalten; setzen Sie seinen Inhalt in geschweifte Klammern</translation>
    </message>
    <message>
        <source>There is no library &quot;{0}&quot;; available are {1}</source>
        <translation>Es gibt keine Bibliothek „{0}“; verfügbar sind {1}</translation>
    </message>
    <message>
        <source>There is no library {0}; did you mean {1}?</source>
        <translation>Es gibt keine Bibliothek {0}; meinten Sie {1}?</translation>
    </message>
    <message>
        <source>Specify a project folder or ST files</source>
        <translation>Geben Sie einen Projektordner oder ST-Dateien an</translation>
    </message>
    <message>
        <source>Specify one project folder or ST files, not both</source>
        <translation>Geben Sie einen Projektordner oder ST-Dateien an, nicht beides</translation>
    </message>
    <message>
        <source>{0} belongs to a library and cannot be renamed; rename only names of the project</source>
        <translation>{0} gehört zu einer Bibliothek und kann nicht umbenannt werden; benennen Sie nur Namen des Projekts um</translation>
    </message>
    <message>
        <source>{0} is not a valid name; use letters, digits and _, start with a letter and avoid keywords</source>
        <translation>{0} ist kein gültiger Name; verwenden Sie Buchstaben, Ziffern und _, am Anfang einen Buchstaben, und keine Schlüsselwörter</translation>
    </message>
    <message>
        <source>The folder cannot be created: {0}</source>
        <translation>Der Ordner kann nicht angelegt werden: {0}</translation>
    </message>
    <message>
        <source>The folder cannot be read: {0}</source>
        <translation>Der Ordner kann nicht gelesen werden: {0}</translation>
    </message>
    <message>
        <source>The file cannot be copied: {0}</source>
        <translation>Die Datei kann nicht kopiert werden: {0}</translation>
    </message>
    <message>
        <source>The folder already exists and is not empty; choose another name</source>
        <translation>Der Ordner ist bereits vorhanden und nicht leer; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>The page cannot be written; check the free space and the permissions of the folder</source>
        <translation>Die Seite kann nicht geschrieben werden; prüfen Sie den Speicherplatz und die Rechte des Ordners</translation>
    </message>
    <message>
        <source>There is no such file in the project; choose one from the project tree</source>
        <translation>Diese Datei ist im Projekt nicht vorhanden; wählen Sie eine aus dem Projektbaum</translation>
    </message>
    <message>
        <source>The file&apos;s permissions cannot be changed; change them as the file&apos;s owner</source>
        <translation>Die Rechte der Datei können nicht geändert werden; ändern Sie sie als Eigentümer der Datei</translation>
    </message>
    <message>
        <source>The file cannot be removed; check the permissions of the folder</source>
        <translation>Die Datei kann nicht gelöscht werden; prüfen Sie die Rechte des Ordners</translation>
    </message>
    <message>
        <source>The file cannot be renamed; check the permissions of the folder</source>
        <translation>Die Datei kann nicht umbenannt werden; prüfen Sie die Rechte des Ordners</translation>
    </message>
    <message>
        <source>Open a project first</source>
        <translation>Öffnen Sie zuerst ein Projekt</translation>
    </message>
    <message>
        <source>This statement is not possible in a TEST together with RUN or ASSERT around it; move it out of RUN and ASSERT</source>
        <translation>Diese Anweisung ist in einem TEST mit RUN oder ASSERT darum nicht möglich; verschieben Sie sie aus RUN und ASSERT heraus</translation>
    </message>
    <message>
        <source>The code of this statement is missing</source>
        <translation>Der Code dieser Anweisung fehlt</translation>
    </message>
    <message>
        <source>Fault in the test: {0}</source>
        <translation>Fehler im Test: {0}</translation>
    </message>
    <message>
        <source>{0} is not a value for {1}; write a value of its type</source>
        <translation>{0} ist kein Wert für {1}; schreiben Sie einen Wert seines Typs</translation>
    </message>
    <message>
        <source>The simulation stopped: {0}</source>
        <translation>Die Simulation hat angehalten: {0}</translation>
    </message>
    <message>
        <source>The controller stopped: {0}</source>
        <translation>Die Steuerung hat angehalten: {0}</translation>
    </message>
    <message>
        <source>at {0}:{1}</source>
        <translation>bei {0}:{1}</translation>
    </message>
    <message>
        <source>{0} has no value: {1}</source>
        <translation>{0} hat keinen Wert: {1}</translation>
    </message>
    <message>
        <source>{0} did not become true within {1}; check the condition or allow more time</source>
        <translation>{0} wurde innerhalb von {1} nicht wahr; prüfen Sie die Bedingung oder geben Sie mehr Zeit</translation>
    </message>
    <message>
        <source>ASSERT failed: {0}</source>
        <translation>ASSERT nicht erfüllt: {0}</translation>
    </message>
    <message>
        <source>ASSERT failed: {0} ({1})</source>
        <translation>ASSERT nicht erfüllt: {0} ({1})</translation>
    </message>
    <message>
        <source>A coil writes a variable; enter the name of one.</source>
        <translation>Eine Spule schreibt eine Variable; geben Sie deren Namen ein.</translation>
    </message>
    <message>
        <source>A pin has no contacts; type an expression.</source>
        <translation>Ein Anschluss hat keine Kontakte; geben Sie einen Ausdruck ein.</translation>
    </message>
    <message>
        <source>A rung cannot be moved into itself; choose a place outside it.</source>
        <translation>Ein Netzwerk kann nicht in sich selbst verschoben werden; wählen Sie eine Stelle außerhalb.</translation>
    </message>
    <message>
        <source>A rung moves within its block of statements; use cut and paste in the text for more.</source>
        <translation>Ein Netzwerk lässt sich innerhalb seines Anweisungsblocks verschieben; verwenden Sie für mehr Ausschneiden und Einfügen im Text.</translation>
    </message>
    <message>
        <source>Delete the call in the text: other statements may use its outputs.</source>
        <translation>Löschen Sie den Aufruf im Text: Andere Anweisungen könnten seine Ausgänge verwenden.</translation>
    </message>
    <message>
        <source>Delete this output in the text.</source>
        <translation>Löschen Sie diesen Ausgang im Text.</translation>
    </message>
    <message>
        <source>Other outputs depend on the same IF; give this coil a rung of its own first.</source>
        <translation>Andere Ausgänge hängen vom selben IF ab; geben Sie dieser Spule zuerst ein eigenes Netzwerk.</translation>
    </message>
    <message>
        <source>Select a box with text.</source>
        <translation>Wählen Sie eine Box mit Text.</translation>
    </message>
    <message>
        <source>Select a coil.</source>
        <translation>Wählen Sie eine Spule.</translation>
    </message>
    <message>
        <source>Select a contact or a wire.</source>
        <translation>Wählen Sie einen Kontakt oder eine Leitung.</translation>
    </message>
    <message>
        <source>Select a contact, a pin or a coil.</source>
        <translation>Wählen Sie einen Kontakt, einen Anschluss oder eine Spule.</translation>
    </message>
    <message>
        <source>Select a rung with contacts.</source>
        <translation>Wählen Sie ein Netzwerk mit Kontakten.</translation>
    </message>
    <message>
        <source>Select a rung with one output.</source>
        <translation>Wählen Sie ein Netzwerk mit einem Ausgang.</translation>
    </message>
    <message>
        <source>Select the rung beside which it is inserted.</source>
        <translation>Wählen Sie das Netzwerk, neben dem eingefügt wird.</translation>
    </message>
    <message>
        <source>Select the rung that the comment belongs to.</source>
        <translation>Wählen Sie das Netzwerk, zu dem der Kommentar gehört.</translation>
    </message>
    <message>
        <source>Select what is to be changed.</source>
        <translation>Wählen Sie, was geändert werden soll.</translation>
    </message>
    <message>
        <source>Select what is to be deleted.</source>
        <translation>Wählen Sie, was gelöscht werden soll.</translation>
    </message>
    <message>
        <source>Several variables are assigned in one statement; separate them in the text first.</source>
        <translation>Mehrere Variablen werden in einer Anweisung zugewiesen; trennen Sie sie zuerst im Text.</translation>
    </message>
    <message>
        <source>Statements on one line cannot be moved; separate them in the text first.</source>
        <translation>Anweisungen in einer Zeile können nicht verschoben werden; trennen Sie sie zuerst im Text.</translation>
    </message>
    <message>
        <source>The rung reads what it writes; add this coil in a rung of its own.</source>
        <translation>Das Netzwerk liest, was es schreibt; fügen Sie diese Spule in einem eigenen Netzwerk hinzu.</translation>
    </message>
    <message>
        <source>There is no function block {0}; declare it or check the name.</source>
        <translation>Es gibt keinen Funktionsbaustein {0}; deklarieren Sie ihn oder prüfen Sie den Namen.</translation>
    </message>
    <message>
        <source>This edit cannot be made in the picture; edit the text.</source>
        <translation>Diese Änderung ist in der Zeichnung nicht möglich; ändern Sie den Text.</translation>
    </message>
    <message>
        <source>This element has no operand; select a contact, a pin or a coil.</source>
        <translation>Dieses Element hat keinen Operanden; wählen Sie einen Kontakt, einen Anschluss oder eine Spule.</translation>
    </message>
    <message>
        <source>This is not a statement: {0}</source>
        <translation>Das ist keine Anweisung: {0}</translation>
    </message>
    <message>
        <source>This is not an expression: {0}</source>
        <translation>Das ist kein Ausdruck: {0}</translation>
    </message>
    <message>
        <source>This rung has no condition; put it under IF in the text.</source>
        <translation>Dieses Netzwerk hat keine Bedingung; stellen Sie es im Text unter ein IF.</translation>
    </message>
    <message>
        <source>{0} is {1}</source>
        <translation>{0} ist {1}</translation>
    </message>
    <message>
        <source>{0} is {1}, expected {2} {3}</source>
        <translation>{0} ist {1}, erwartet {2} {3}</translation>
    </message>
    <message>
        <source>{0} is {1}, recorded {2} in scan {3}</source>
        <translation>{0} ist {1}, aufgezeichnet {2} in Zyklus {3}</translation>
    </message>
    <message>
        <source>The recording {0} has {1} {1:scan|scans}, this run {2}</source>
        <translation>Die Aufzeichnung {0} hat {1} {1:Zyklus|Zyklen}, dieser Lauf {2}</translation>
    </message>
    <message>
        <source>The run differs from the recording {0}; delete it to record it again, if the new behaviour is right</source>
        <translation>Der Lauf weicht von der Aufzeichnung {0} ab; löschen Sie sie, um neu aufzuzeichnen, wenn das neue Verhalten richtig ist</translation>
    </message>
    <message>
        <source>the condition cannot be evaluated; use variables, operators and standard functions</source>
        <translation>die Bedingung kann nicht ausgewertet werden; verwenden Sie Variablen, Operatoren und Standardfunktionen</translation>
    </message>
    <message>
        <source>There is no action {0}; add it or correct the name</source>
        <translation>Es gibt keine Aktion {0}; fügen Sie sie hinzu oder berichtigen Sie den Namen</translation>
    </message>
    <message>
        <source>{0} is not a valid name; use letters, digits and underscores</source>
        <translation>{0} ist kein gültiger Name; verwenden Sie Buchstaben, Ziffern und Unterstriche</translation>
    </message>
    <message>
        <source>The initial step stays at the top; make another step the initial step first</source>
        <translation>Der Initialschritt bleibt oben; machen Sie zuerst einen anderen Schritt zum Initialschritt</translation>
    </message>
    <message>
        <source>Only a step with a single transition of its own can be moved; move it in the text</source>
        <translation>Nur ein Schritt mit einer einzelnen eigenen Transition kann verschoben werden; verschieben Sie ihn im Text</translation>
    </message>
    <message>
        <source>The step is already there; choose another place</source>
        <translation>Der Schritt ist schon dort; wählen Sie eine andere Stelle</translation>
    </message>
    <message>
        <source>A step can be placed after a transition that leads to one step; choose such a transition</source>
        <translation>Ein Schritt kann nach einer Transition eingefügt werden, die zu einem einzigen Schritt führt; wählen Sie eine solche Transition</translation>
    </message>
    <message>
        <source>This step only leads to itself; connect it to another step first</source>
        <translation>Dieser Schritt führt nur zu sich selbst; verbinden Sie ihn zuerst mit einem anderen Schritt</translation>
    </message>
    <message>
        <source>A transition needs a condition; enter one, for example Main.done</source>
        <translation>Eine Transition braucht eine Bedingung; geben Sie eine ein, zum Beispiel Main.done</translation>
    </message>
    <message>
        <source>A priority must be a positive number; enter 1 or more</source>
        <translation>Eine Priorität muss eine positive Zahl sein; geben Sie 1 oder mehr ein</translation>
    </message>
    <message>
        <source>Nothing follows this step yet; insert a step after it first</source>
        <translation>Auf diesen Schritt folgt noch nichts; fügen Sie zuerst einen Schritt danach ein</translation>
    </message>
    <message>
        <source>There is no such action; select one that is in the chart</source>
        <translation>Diese Aktion ist nicht vorhanden; wählen Sie eine aus der Schrittkette</translation>
    </message>
    <message>
        <source>The initial step cannot be deleted; make another step the initial step first</source>
        <translation>Der Initialschritt kann nicht gelöscht werden; machen Sie zuerst einen anderen Schritt zum Initialschritt</translation>
    </message>
    <message>
        <source>Several transitions leave this step; delete its branches first</source>
        <translation>Mehrere Transitionen verlassen diesen Schritt; löschen Sie zuerst seine Zweige</translation>
    </message>
    <message>
        <source>The condition of this transition cannot be read; edit it in the text</source>
        <translation>Die Bedingung dieser Transition ist nicht lesbar; bearbeiten Sie sie im Text</translation>
    </message>
    <message>
        <source>The branches after this transition do not join; connect them in the text first</source>
        <translation>Die Zweige nach dieser Transition werden nicht zusammengeführt; verbinden Sie sie zuerst im Text</translation>
    </message>
    <message>
        <source>A panel must be a JSON object; put its contents in braces</source>
        <translation>Ein Panel muss ein JSON-Objekt sein; setzen Sie seinen Inhalt in geschweifte Klammern</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a list; put it in square brackets</source>
        <translation>„{0}“ muss eine Liste sein; setzen Sie es in eckige Klammern</translation>
    </message>
    <message>
        <source>Element {0} is not an object; put it in braces</source>
        <translation>Element {0} ist kein Objekt; setzen Sie es in geschweifte Klammern</translation>
    </message>
    <message>
        <source>The kind of element {0} is not a text; write it in quotes</source>
        <translation>Die Art von Element {0} ist kein Text; schreiben Sie sie in Anführungszeichen</translation>
    </message>
    <message>
        <source>Two elements have the id &quot;{0}&quot;; change one of them</source>
        <translation>Zwei Elemente haben die Kennung „{0}“; ändern Sie eine davon</translation>
    </message>
    <message>
        <source>Every alarm and every alarm class must be a JSON object; put it in braces</source>
        <translation>Jeder Alarm und jede Alarmklasse muss ein JSON-Objekt sein; setzen Sie den Eintrag in geschweifte Klammern</translation>
    </message>
    <message>
        <source>This line is not valid UTF-8; save the file as UTF-8</source>
        <translation>Diese Zeile ist kein gültiges UTF-8; speichern Sie die Datei als UTF-8</translation>
    </message>
    <message>
        <source>There is text after a closing quote; double a quote that belongs to the text</source>
        <translation>Nach einem schließenden Anführungszeichen steht Text; verdoppeln Sie ein Anführungszeichen, das zum Text gehört</translation>
    </message>
    <message>
        <source>The first line must be {0} and one language tag per column</source>
        <translation>Die erste Zeile muss {0} und ein Sprachkürzel je Spalte sein</translation>
    </message>
    <message>
        <source>This line has {0} {0:field|fields}, the header has {1}; put texts with separators in quotes</source>
        <translation>Diese Zeile hat {0} {0:Feld|Felder}, die Kopfzeile hat {1}; setzen Sie Texte mit Trennzeichen in Anführungszeichen</translation>
    </message>
    <message>
        <source>The alarm history cannot be opened: {0}</source>
        <translation>Die Alarmhistorie kann nicht geöffnet werden: {0}</translation>
    </message>
    <message>
        <source>The alarm history cannot be used: {0}</source>
        <translation>Die Alarmhistorie kann nicht verwendet werden: {0}</translation>
    </message>
    <message>
        <source>The alarm history cannot be written: {0}</source>
        <translation>Die Alarmhistorie kann nicht geschrieben werden: {0}</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}; use a larger type or a smaller limit</source>
        <translation>{0} passt nicht in {1}; verwenden Sie einen größeren Typ oder einen kleineren Grenzwert</translation>
    </message>
    <message>
        <source>STRING contains characters of {0} only; declare the variable as WSTRING</source>
        <translation>STRING fasst nur Zeichen in {0}; deklarieren Sie die Variable als WSTRING</translation>
    </message>
    <message>
        <source>A {0} cannot be written from a panel; write its members one by one</source>
        <translation>Ein {0} kann von einem Panel nicht geschrieben werden; schreiben Sie seine Elemente einzeln</translation>
    </message>
    <message>
        <source>The folder for the pictures cannot be created; check the path and its permissions</source>
        <translation>Der Ordner für die Bilder kann nicht angelegt werden; prüfen Sie den Pfad und seine Rechte</translation>
    </message>
    <message>
        <source>The picture cannot be written; check the free space and the permissions of the folder</source>
        <translation>Das Bild kann nicht geschrieben werden; prüfen Sie den Speicherplatz und die Rechte des Ordners</translation>
    </message>
    <message>
        <source>The project has no such panel; choose one from hmi/</source>
        <translation>Das Projekt hat kein solches Panel; wählen Sie eines aus hmi/</translation>
    </message>
    <message>
        <source>The text &quot;{0}&quot; has no key, so it cannot be translated; move it into the text table</source>
        <translation>Der Text „{0}“ hat keinen Schlüssel und kann deshalb nicht übersetzt werden; verschieben Sie ihn in die Texttabelle</translation>
    </message>
    <message>
        <source>The text needs a value for {0}; specify it in &quot;Values in texts&quot;</source>
        <translation>Der Text braucht einen Wert für {0}; geben Sie ihn unter „Werte in Texten“ an</translation>
    </message>
    <message>
        <source>The text list {0} is empty: there is no key {1}; add it to the text table</source>
        <translation>Die Textliste {0} ist leer: Es gibt keinen Schlüssel {1}; fügen Sie ihn in die Texttabelle ein</translation>
    </message>
    <message>
        <source>This version does not know the element kind &quot;{0}&quot;; it is kept as it is</source>
        <translation>Diese Version kennt die Elementart „{0}“ nicht; sie bleibt unverändert</translation>
    </message>
    <message>
        <source>The format {0} is not known; use for example {1} or {2}</source>
        <translation>Das Format {0} ist nicht bekannt; verwenden Sie zum Beispiel {1} oder {2}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; does not fit: it needs {1} px, the maximum is {2}; make the element wider or the text shorter</source>
        <translation>„{0}“ passt nicht: benötigt {1}&#xa0;px, verfügbar sind {2}; machen Sie das Element breiter oder den Text kürzer</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; does not fit: it needs a height of {1} px, the maximum is {2}; make the element taller or the text shorter</source>
        <translation>„{0}“ passt nicht: benötigt eine Höhe von {1}&#xa0;px, verfügbar sind {2}; machen Sie das Element höher oder den Text kürzer</translation>
    </message>
    <message>
        <source>{0}; did you mean {1}?</source>
        <translation>{0}; meinten Sie {1}?</translation>
    </message>
    <message>
        <source>{0} is not a variable, so it cannot be written; name a variable</source>
        <translation>{0} ist keine Variable und kann deshalb nicht geschrieben werden; geben Sie eine Variable an</translation>
    </message>
    <message>
        <source>{0} is {1}; a BOOL is needed here</source>
        <translation>{0} ist {1}; hier wird ein BOOL gebraucht</translation>
    </message>
    <message>
        <source>{0} is {1}; a number is needed here</source>
        <translation>{0} ist {1}; hier wird eine Zahl gebraucht</translation>
    </message>
    <message>
        <source>{0} is {1}; a STRING is needed here</source>
        <translation>{0} ist {1}; hier wird ein STRING gebraucht</translation>
    </message>
    <message>
        <source>{0} is {1}; an array is needed here</source>
        <translation>{0} ist {1}; hier wird ein Array gebraucht</translation>
    </message>
    <message>
        <source>{0} is {1}; a single value is needed here</source>
        <translation>{0} ist {1}; hier wird ein einzelner Wert gebraucht</translation>
    </message>
    <message>
        <source>A placeholder is not closed; add {0}</source>
        <translation>Ein Platzhalter ist nicht geschlossen; ergänzen Sie {0}</translation>
    </message>
    <message>
        <source>The format {0} is not known; use one such as %.1f</source>
        <translation>Das Format {0} ist nicht bekannt; verwenden Sie zum Beispiel %.1f</translation>
    </message>
    <message>
        <source>A trace configuration must be a JSON object; put its contents in braces</source>
        <translation>Eine Trace-Konfiguration muss ein JSON-Objekt sein; setzen Sie ihren Inhalt in geschweifte Klammern</translation>
    </message>
    <message>
        <source>The trace configuration is invalid: {0}</source>
        <translation>Die Trace-Konfiguration ist ungültig: {0}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be {1}</source>
        <translation>„{0}“ muss {1} sein</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is missing; add it</source>
        <translation>„{0}“ fehlt; ergänzen Sie es</translation>
    </message>
    <message>
        <source>A picture&apos;s name must end in one of {0}</source>
        <translation>Der Name eines Bilds muss auf eines von {0} enden</translation>
    </message>
    <message>
        <source>no longer recorded</source>
        <translation>nicht mehr aufgezeichnet</translation>
    </message>
    <message>
        <source>A recording from a file cannot be written; go back to the running controller first</source>
        <translation>Eine Aufzeichnung aus einer Datei kann nicht geschrieben werden; kehren Sie zuerst zur laufenden Steuerung zurück</translation>
    </message>
    <message>
        <source>Recorded values cannot be written; resume from here first</source>
        <translation>Aufgezeichnete Werte können nicht geschrieben werden; setzen Sie zuerst ab hier fort</translation>
    </message>
    <message>
        <source>Recorded values cannot be forced; resume from here or go back to live first</source>
        <translation>Aufgezeichnete Werte können nicht geforct werden; setzen Sie zuerst ab hier fort oder kehren Sie zum Livebetrieb zurück</translation>
    </message>
    <message>
        <source>A recording from a file cannot be resumed, only what the controller itself recorded; press F5 to run the program</source>
        <translation>Eine Aufzeichnung aus einer Datei kann nicht fortgesetzt werden, nur was die Steuerung selbst aufgezeichnet hat; starten Sie das Programm mit F5</translation>
    </message>
    <message>
        <source>A priority is a number; 0 removes it</source>
        <translation>Eine Priorität ist eine Zahl; 0 entfernt sie</translation>
    </message>
    <message>
        <source>This file cannot be imported; PLCopen XML (.xml), TwinCAT (.TcPOU and so on), text of CODESYS (.EXP, .export) and structured text (.st) can be read</source>
        <translation>Diese Datei kann nicht importiert werden; lesbar sind PLCopen XML (.xml), TwinCAT (.TcPOU und so weiter), Text von CODESYS (.EXP, .export) und strukturierter Text (.st)</translation>
    </message>
    <message>
        <source>This XML is neither PLCopen XML nor of TwinCAT or CODESYS; export the project as PLCopen XML and import that file</source>
        <translation>Dieses XML ist weder PLCopen XML noch von TwinCAT oder CODESYS; exportieren Sie das Projekt als PLCopen XML und importieren Sie diese Datei</translation>
    </message>
    <message>
        <source>It contains nothing that can be imported; export the project again with its units</source>
        <translation>Darin ist nichts, das importiert werden kann; exportieren Sie das Projekt erneut mit seinen Bausteinen</translation>
    </message>
    <message>
        <source>The folder exists and is not empty; name a new one</source>
        <translation>Der Ordner ist bereits vorhanden und nicht leer; geben Sie einen neuen an</translation>
    </message>
    <message>
        <source>The sources have syntax errors; stepwise check lists them</source>
        <translation>Die Quelltexte haben Syntaxfehler; stepwise check listet sie auf</translation>
    </message>
    <message>
        <source>The file is too large to be read; export its parts one by one</source>
        <translation>Die Datei ist zu groß, um gelesen zu werden; exportieren Sie die Teile einzeln</translation>
    </message>
    <message>
        <source>The file is in the encoding {0}, which is not supported; save it as UTF-8</source>
        <translation>Die Datei hat die Codierung {0}, die nicht unterstützt wird; speichern Sie sie als UTF-8</translation>
    </message>
    <message>
        <source>The file declares a document type or entities of its own, which is not supported; export it again without them</source>
        <translation>Die Datei deklariert einen Dokumenttyp oder eigene Entitäten, was nicht unterstützt wird; exportieren Sie sie erneut ohne diese</translation>
    </message>
    <message>
        <source>The elements of the file are nested too deeply; export its parts one by one</source>
        <translation>Die Elemente der Datei sind zu tief verschachtelt; exportieren Sie die Teile einzeln</translation>
    </message>
    <message>
        <source>This is not well-formed XML: {0}; export the file again</source>
        <translation>Dies ist kein wohlgeformtes XML: {0}; exportieren Sie die Datei erneut</translation>
    </message>
    <message>
        <source>The file has no elements; export it again</source>
        <translation>Die Datei hat keine Elemente; exportieren Sie sie erneut</translation>
    </message>
    <message>
        <source>This is XML, not structured text; import it (stepwise import --help)</source>
        <translation>Dies ist XML, kein strukturierter Text; importieren Sie es (stepwise import --help)</translation>
    </message>
    <message>
        <source>Windows-1252 does not have the character {0}; write the file as UTF-8</source>
        <translation>Windows-1252 hat das Zeichen {0} nicht; schreiben Sie die Datei als UTF-8</translation>
    </message>
    <message>
        <source>The first input and the first output of {0} must be BOOL for it to be part of a rung; choose another block, or call it in the text.</source>
        <translation>Der erste Eingang und der erste Ausgang von {0} müssen BOOL sein, damit der Baustein Teil eines Netzwerks sein kann; wählen Sie einen anderen, oder rufen Sie ihn im Text auf.</translation>
    </message>
    <message>
        <source>Type a name and a block: T1 : TON</source>
        <translation>Geben Sie einen Namen und einen Baustein ein: T1 : TON</translation>
    </message>
    <message>
        <source>the local variables of {0} and of what it calls need {1} bytes; the maximum is {2}; declare large arrays in a program or block</source>
        <translation>die lokalen Variablen von {0} und allem, was es aufruft, brauchen {1} Bytes; möglich sind höchstens {2}; deklarieren Sie große Arrays in einem Programm oder Baustein</translation>
    </message>
    <message>
        <source>{0} is too large for the stack; divide it into several functions</source>
        <translation>{0} ist zu groß für den Stack; teilen Sie es in mehrere Funktionen auf</translation>
    </message>
    <message>
        <source>more than {0} units of work (loop passes, calls, copies) in one run of the task; check for an endless loop</source>
        <translation>mehr als {0} Arbeitseinheiten (Schleifendurchläufe, Aufrufe, Kopien) in einem Lauf der Task; prüfen Sie auf eine Endlosschleife</translation>
    </message>
    <message>
        <source>{0} is not a name: use letters, digits and underscores.</source>
        <translation>{0} ist kein gültiger Name; verwenden Sie Buchstaben, Ziffern und Unterstriche.</translation>
    </message>
    <message>
        <source>The XLIFF version {0} is not known; save the file as 1.2 or 2.0</source>
        <translation>Die XLIFF-Version {0} ist nicht bekannt; speichern Sie die Datei als 1.2 oder 2.0</translation>
    </message>
    <message>
        <source>The file does not say into which language it is translated; export it again with --language</source>
        <translation>Die Datei gibt nicht an, in welche Sprache sie übersetzt ist; exportieren Sie sie erneut mit --language</translation>
    </message>
    <message>
        <source>The XML is wrong: {0}; export the file again</source>
        <translation>Das XML ist fehlerhaft: {0}; exportieren Sie die Datei erneut</translation>
    </message>
    <message>
        <source>The text of the key {0} in {1} has changed since the export; check the translation</source>
        <translation>Der Text des Schlüssels {0} in {1} hat sich seit dem Export geändert; prüfen Sie die Übersetzung</translation>
    </message>
    <message>
        <source>The translation of the key {0} has other placeholders than its source and was not taken; use the same ones</source>
        <translation>Die Übersetzung des Schlüssels {0} hat andere Platzhalter als ihre Quelle und wurde nicht übernommen; verwenden Sie dieselben</translation>
    </message>
    <message>
        <source>The picture {0} is outside the project; copy it into the project, or set {1} to true under {2} in project.json</source>
        <translation>Das Bild {0} liegt außerhalb des Projekts; kopieren Sie es in das Projekt oder setzen Sie {1} unter {2} in project.json auf true</translation>
    </message>
    <message>
        <source>The picture {0} unpacks to more than {1} MB; use a smaller one</source>
        <translation>Das Bild {0} wird entpackt größer als {1}&#xa0;MB; verwenden Sie ein kleineres</translation>
    </message>
    <message>
        <source>The picture {0} is {1} x {2} pixels; more than {3} million are not drawn; use a smaller one</source>
        <translation>Das Bild {0} hat {1} x {2} Pixel; mehr als {3} Millionen werden nicht gezeichnet; verwenden Sie ein kleineres</translation>
    </message>
    <message>
        <source>{0} is not a picture in a known format such as PNG, JPEG or SVG; save it as one of them</source>
        <translation>{0} ist kein Bild in einem bekannten Format wie PNG, JPEG oder SVG; speichern Sie es in einem davon</translation>
    </message>
    <message>
        <source>The picture {0} draws more than {1} shapes; simplify it or save it as PNG</source>
        <translation>Das Bild {0} enthält mehr als {1} Formen; vereinfachen Sie es oder speichern Sie es als PNG</translation>
    </message>
    <message>
        <source>The shapes of the picture {0} are nested more than {1} deep or contain themselves; simplify it or save it as PNG</source>
        <translation>Die Formen des Bildes {0} sind mehr als {1} tief verschachtelt oder enthalten sich selbst; vereinfachen Sie es oder speichern Sie es als PNG</translation>
    </message>
    <message>
        <source>The picture {0} loads {1}; embed it in the picture as PNG or JPEG</source>
        <translation>Das Bild {0} lädt {1}; betten Sie es als PNG oder JPEG in das Bild ein</translation>
    </message>
    <message>
        <source>The picture {0} has dashed lines of more than {1} dashes; make the dashes longer or save it as PNG</source>
        <translation>Das Bild {0} hat gestrichelte Linien mit mehr als {1} Strichen; machen Sie die Striche länger oder speichern Sie es als PNG</translation>
    </message>
    <message>
        <source>This version does not know the property {0}; it is kept as it is</source>
        <translation>Diese Version kennt die Eigenschaft {0} nicht; sie bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>This version does not know the property {0}; did you mean {1}?</source>
        <translation>Diese Version kennt die Eigenschaft {0} nicht; meinten Sie {1}?</translation>
    </message>
    <message>
        <source>The value must be true or false</source>
        <translation>Der Wert muss true oder false sein</translation>
    </message>
    <message>
        <source>The value must be a whole number</source>
        <translation>Der Wert muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>The value must be a number</source>
        <translation>Der Wert muss eine Zahl sein</translation>
    </message>
    <message>
        <source>The value must be a list of two numbers: width and height</source>
        <translation>Der Wert muss eine Liste aus zwei Zahlen sein: Breite und Höhe</translation>
    </message>
    <message>
        <source>The value must be a list of four numbers: x, y, width and height</source>
        <translation>Der Wert muss eine Liste aus vier Zahlen sein: x, y, Breite und Höhe</translation>
    </message>
    <message>
        <source>The value must be a list of points, each a list of two numbers</source>
        <translation>Der Wert muss eine Liste von Punkten sein, jeder eine Liste aus zwei Zahlen</translation>
    </message>
    <message>
        <source>The value must be an object with an expression for each name</source>
        <translation>Der Wert muss ein Objekt mit einem Ausdruck je Name sein</translation>
    </message>
    <message>
        <source>The value must be a list of objects</source>
        <translation>Der Wert muss eine Liste von Objekten sein</translation>
    </message>
    <message>
        <source>The value must be a text in quotes</source>
        <translation>Der Wert muss ein Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>{0} is not one of the choices: {1}</source>
        <translation>{0} ist keine der Möglichkeiten: {1}</translation>
    </message>
    <message>
        <source>{0} is not a colour; use the name of a role of the theme or a value such as {1}</source>
        <translation>{0} ist keine Farbe; verwenden Sie den Namen einer Rolle des Farbschemas oder einen Wert wie {1}</translation>
    </message>
    <message>
        <source>{0} is not a colour; did you mean {1}?</source>
        <translation>{0} ist keine Farbe; meinten Sie {1}?</translation>
    </message>
    <message>
        <source>{0} ({1}) must be greater than {2} ({3}); exchange or correct the values</source>
        <translation>{0} ({1}) muss größer als {2} ({3}) sein; vertauschen oder berichtigen Sie die Werte</translation>
    </message>
    <message>
        <source>{0} has no page {1}; its {2} {2:page is|pages are} numbered from 0</source>
        <translation>{0} hat keine Seite {1}; die {2} {2:Seite ist|Seiten sind} ab 0 nummeriert</translation>
    </message>
    <message>
        <source>The format {0} needs a number, and {1} is none; use {2}</source>
        <translation>Das Format {0} braucht eine Zahl, und {1} ist keine; verwenden Sie {2}</translation>
    </message>
    <message>
        <source>The project has no language {0}, so operators never see this column; add it to the languages in project.json</source>
        <translation>Das Projekt hat die Sprache {0} nicht, Bediener sehen diese Spalte also nie; fügen Sie sie in project.json zu den Sprachen hinzu</translation>
    </message>
    <message>
        <source>No text says what this does; add one, or place one next to it</source>
        <translation>Kein Text sagt, was das bewirkt; fügen Sie einen hinzu oder setzen Sie einen daneben</translation>
    </message>
    <message>
        <source>{0} is between {1} and {2} in the recording, so the range from {3} to {4} cuts it off; widen the range</source>
        <translation>{0} liegt in der Aufzeichnung zwischen {1} und {2}, der Bereich von {3} bis {4} schneidet also etwas ab; erweitern Sie den Bereich</translation>
    </message>
    <message>
        <source>{0} is not between {1} and {2}, so {3} is used; correct it</source>
        <translation>{0} liegt nicht zwischen {1} und {2}, verwendet wird {3}; berichtigen Sie den Wert</translation>
    </message>
    <message>
        <source>The panel {0} contains this one, so it cannot be placed in it; choose another one</source>
        <translation>Das Panel {0} enthält dieses hier und kann deshalb nicht darin platziert werden; wählen Sie ein anderes</translation>
    </message>
    <message>
        <source>The panel {0} has no parameter {1}; remove the argument or add the parameter</source>
        <translation>Das Panel {0} hat keinen Parameter {1}; entfernen Sie das Argument oder fügen Sie den Parameter hinzu</translation>
    </message>
    <message>
        <source>The program has no type {0}; name a block or a structure, BOOL, REAL or the like, or text</source>
        <translation>Das Programm hat keinen Typ {0}; geben Sie einen Baustein oder eine Struktur an, BOOL, REAL oder dergleichen, oder text</translation>
    </message>
    <message>
        <source>The parameter {0} needs an argument of type {1}; enter one in the properties of this faceplate</source>
        <translation>Der Parameter {0} braucht ein Argument vom Typ {1}; geben Sie eines in den Eigenschaften dieses Faceplates ein</translation>
    </message>
    <message>
        <source>{0} is {1}; the parameter {2} needs {3}</source>
        <translation>{0} ist {1}; der Parameter {2} braucht {3}</translation>
    </message>
    <message>
        <source>{0} (tried with {1})</source>
        <translation>{0} (versucht mit {1})</translation>
    </message>
    <message>
        <source>The program was not built from sources; open its project.</source>
        <translation>Das Programm wurde nicht aus Quelltexten übersetzt; öffnen Sie sein Projekt.</translation>
    </message>
    <message>
        <source>The recording does not contain the program of this scan; choose a later scan.</source>
        <translation>Die Aufzeichnung enthält das Programm dieses Zyklus nicht; wählen Sie einen späteren Zyklus.</translation>
    </message>
    <message>
        <source>This scan is no longer in the recording; choose a later scan.</source>
        <translation>Dieser Zyklus ist nicht mehr in der Aufzeichnung; wählen Sie einen späteren Zyklus.</translation>
    </message>
    <message>
        <source>The scan before it is not in the recording, so the values with which this scan began are not known; choose a later scan.</source>
        <translation>Der Zyklus davor ist nicht in der Aufzeichnung; die Werte, mit denen dieser Zyklus begann, sind daher nicht bekannt; wählen Sie einen späteren Zyklus.</translation>
    </message>
    <message>
        <source>There is no user {0}; create the user or check the name</source>
        <translation>Den Benutzer {0} gibt es nicht; legen Sie ihn an oder prüfen Sie den Namen</translation>
    </message>
    <message>
        <source>The password cannot be saved: {0}</source>
        <translation>Das Passwort kann nicht gespeichert werden: {0}</translation>
    </message>
    <message>
        <source>A password needs at least {0} characters; choose a longer one</source>
        <translation>Ein Passwort braucht mindestens {0} Zeichen; wählen Sie ein längeres</translation>
    </message>
    <message>
        <source>The password must not be the name of the user; choose another one</source>
        <translation>Das Passwort darf nicht der Name des Benutzers sein; wählen Sie ein anderes</translation>
    </message>
    <message>
        <source>The audit trail cannot be written: {0}</source>
        <translation>Das Audit-Protokoll kann nicht geschrieben werden: {0}</translation>
    </message>
    <message>
        <source>The audit trail cannot be read: {0}</source>
        <translation>Das Audit-Protokoll kann nicht gelesen werden: {0}</translation>
    </message>
    <message>
        <source>The frame {0} has no panel area, so no panel is shown in it; add one</source>
        <translation>Der Rahmen {0} hat keinen Panelbereich, darin wird also kein Panel angezeigt; fügen Sie einen hinzu</translation>
    </message>
    <message>
        <source>Only for the roles {0}, but the project has no users, so anybody may operate it; add users</source>
        <translation>Nur für die Rollen {0}, aber das Projekt hat keine Benutzer, also darf es jeder bedienen; fügen Sie Benutzer hinzu</translation>
    </message>
    <message>
        <source>A row of a recipe names no variable; enter one or remove the row</source>
        <translation>Eine Zeile einer Rezeptur nennt keine Variable; geben Sie eine an oder entfernen Sie die Zeile</translation>
    </message>
    <message>
        <source>The first column must be named variable, and each set has a column of its own</source>
        <translation>Die erste Spalte muss variable heißen, und jeder Datensatz hat eine eigene Spalte</translation>
    </message>
    <message>
        <source>The recipe {0} has no variable {1}; add it or correct the name</source>
        <translation>Die Rezeptur {0} hat keine Variable {1}; fügen Sie sie hinzu oder berichtigen Sie den Namen</translation>
    </message>
    <message>
        <source>There is no recipe {0}; create it or check the name</source>
        <translation>Die Rezeptur {0} gibt es nicht; legen Sie sie an oder prüfen Sie den Namen</translation>
    </message>
    <message>
        <source>The recipe {0} has no set {1}; create it or check the name</source>
        <translation>Die Rezeptur {0} hat keinen Datensatz {1}; legen Sie ihn an oder prüfen Sie den Namen</translation>
    </message>
    <message>
        <source>{0} is outside the limits of {1}, {2} to {3}; enter a value within them</source>
        <translation>{0} liegt außerhalb der Grenzen von {1}, {2} bis {3}; geben Sie einen Wert innerhalb davon ein</translation>
    </message>
    <message>
        <source>The list of shelved alarms cannot be read, so none is shelved: {0}</source>
        <translation>Die Liste der zurückgestellten Alarme kann nicht gelesen werden; es ist also keiner zurückgestellt: {0}</translation>
    </message>
    <message>
        <source>The list of shelved alarms cannot be written: {0}</source>
        <translation>Die Liste der zurückgestellten Alarme kann nicht geschrieben werden: {0}</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Warum?</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>Warum nicht?</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>Wer hat das gesetzt?</translation>
    </message>
    <message>
        <source>There is no rule {0}; &quot;stepwise panel --rules&quot; lists them</source>
        <translation>Es gibt keine Regel {0}; „stepwise panel --rules“ führt alle auf</translation>
    </message>
    <message>
        <source>There is no rule {0}; did you mean {1}?</source>
        <translation>Es gibt keine Regel {0}; war {1} gemeint?</translation>
    </message>
    <message>
        <source>The rule stays on until a reason for switching it off is given</source>
        <translation>Die Regel bleibt eingeschaltet, bis ein Grund für das Abschalten angegeben ist</translation>
    </message>
    <message>
        <source>The value must be a list of texts in quotes</source>
        <translation>Der Wert muss eine Liste von Texten in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>The value must be an object with the reason for each rule</source>
        <translation>Der Wert muss ein Objekt mit der Begründung für jede Regel sein</translation>
    </message>
    <message>
        <source>The value must be an object with a level, the distance, and rules that are off</source>
        <translation>Der Wert muss ein Objekt mit Stufe, Abstand und ausgeschalteten Regeln sein</translation>
    </message>
    <message>
        <source>The colour {0} is always visible, whatever the state; use {1}</source>
        <translation>Die Farbe {0} ist in jedem Zustand sichtbar; verwenden Sie {1}</translation>
    </message>
    <message>
        <source>{0} is an alarm colour, but it is visible in normal operation; use {1}</source>
        <translation>{0} ist eine Alarmfarbe, aber im Normalbetrieb sichtbar; verwenden Sie {1}</translation>
    </message>
    <message>
        <source>Only the hue distinguishes {0} from {1}; choose a brighter one, or add a text or blinking</source>
        <translation>Nur der Farbton unterscheidet {0} von {1}; wählen Sie eine hellere Farbe oder ergänzen Sie einen Text oder Blinken</translation>
    </message>
    <message>
        <source>No text says what the lamp means; give it a label, or place a text next to it</source>
        <translation>Kein Text sagt, was die Lampe bedeutet; geben Sie ihr eine Beschriftung oder setzen Sie einen Text daneben</translation>
    </message>
    <message>
        <source>{0} on {1} has a contrast of {2} to 1 in the theme {3}; {4} to 1 is needed; choose another colour</source>
        <translation>{0} auf {1} hat im Farbschema {3} einen Kontrast von {2} zu 1; nötig ist {4} zu 1; wählen Sie eine andere Farbe</translation>
    </message>
    <message>
        <source>A font of {0} px cannot be read from {2} mm; use at least {1} px</source>
        <translation>Eine Schrift von {0}&#xa0;px ist aus {2}&#xa0;mm nicht lesbar; verwenden Sie mindestens {1}&#xa0;px</translation>
    </message>
    <message>
        <source>The faceplate is so small here that its smallest font has {0} px; from {2} mm, {1} px are needed; enlarge it</source>
        <translation>Das Faceplate ist hier so klein, dass seine kleinste Schrift {0}&#xa0;px hat; aus {2}&#xa0;mm sind {1}&#xa0;px nötig; vergrößern Sie es</translation>
    </message>
    <message>
        <source>The faceplate is so small here that only {0} px remain for a finger; {1} px are needed; enlarge it</source>
        <translation>Das Faceplate ist hier so klein, dass für einen Finger nur {0}&#xa0;px bleiben; nötig sind {1}&#xa0;px; vergrößern Sie es</translation>
    </message>
    <message>
        <source>{0} x {1} px is too small for a finger next to other controls; {2} px are needed in both directions; make it larger</source>
        <translation>{0} × {1}&#xa0;px sind neben anderen Bedienelementen zu klein für einen Finger; nötig sind {2}&#xa0;px in beiden Richtungen; vergrößern Sie das Element</translation>
    </message>
    <message>
        <source>The panel shows {0} values and controls; the maximum for its size is {1}; move some to another panel</source>
        <translation>Auf dem Panel werden {0} Werte und Bedienelemente angezeigt; das Maximum für seine Größe ist {1}; verschieben Sie einige auf ein anderes Panel</translation>
    </message>
    <message>
        <source>The panel {0} is {1} presses away from the start panel; add a way of at most {2}</source>
        <translation>Das Panel {0} ist {1} Berührungen vom Startpanel entfernt; fügen Sie einen Weg mit höchstens {2} hinzu</translation>
    </message>
    <message>
        <source>Nothing on the panel {0} leads back; add a button with the action back or home, or a navigation bar</source>
        <translation>Nichts auf dem Panel {0} führt zurück; fügen Sie eine Schaltfläche mit der Aktion back oder home oder eine Navigationsleiste hinzu</translation>
    </message>
    <message>
        <source>{0} is in a different place on the panel {1}; put it in the same place on both</source>
        <translation>{0} ist auf dem Panel {1} an einer anderen Stelle; setzen Sie es auf beiden an dieselbe Stelle</translation>
    </message>
    <message>
        <source>Normal states are grey so that abnormal ones are noticed (ISA-101). Use a role of the theme such as surface, off or running, and give colour only to conditions.</source>
        <translation>Normale Zustände sind grau, damit Abweichungen auffallen (ISA-101). Verwenden Sie eine Rolle des Farbschemas wie surface, off oder running und vergeben Sie Farben nur über Bedingungen.</translation>
    </message>
    <message>
        <source>Red, orange and yellow are reserved for alarms. An operator who sees them all day long no longer notices them when they matter (ISA-101, ISA-18.2).</source>
        <translation>Rot, Orange und Gelb sind Alarmen vorbehalten. Wer sie den ganzen Tag sieht, sieht sie nicht mehr, wenn es darauf ankommt (ISA-101, ISA-18.2).</translation>
    </message>
    <message>
        <source>Text needs a contrast of 4.5 to 1 against its background, large text 3 to 1 (WCAG 2, ISO 9241-303). The colour roles ensure this in every theme.</source>
        <translation>Text braucht gegen seinen Hintergrund einen Kontrast von 4,5 zu 1, großer Text 3 zu 1 (WCAG 2, ISO 9241-303). Die Farbrollen stellen das in jedem Farbschema sicher.</translation>
    </message>
    <message>
        <source>A capital letter must be seen at an angle of 16 minutes at least (ISO 9241-303). The distance and the size of a pixel are set in project.json.</source>
        <translation>Ein Großbuchstabe muss unter einem Winkel von mindestens 16 Bogenminuten zu sehen sein (ISO 9241-303). Der Betrachtungsabstand und die Größe eines Pixels werden in project.json angegeben.</translation>
    </message>
    <message>
        <source>On a panel that shows everything, operators have to search. Move details to a panel of the next level (ISA-101).</source>
        <translation>Auf einem Panel, das alles anzeigt, muss der Bediener suchen. Verschieben Sie Einzelheiten auf ein Panel der nächsten Ebene (ISA-101).</translation>
    </message>
    <message>
        <source>In an abnormal situation, every panel should be at most three presses away, and there should be a way back from it (ISA-101).</source>
        <translation>Im Störfall sollte jedes Panel höchstens drei Berührungen entfernt sein, und es sollte einen Weg zurück geben (ISA-101).</translation>
    </message>
    <message>
        <source>Operators find what is on several panels without searching if it is always in the same place. Put it on the frame, or in the same place everywhere.</source>
        <translation>Was auf mehreren Panels vorkommt, findet der Bediener ohne Suchen, wenn es immer an derselben Stelle ist. Setzen Sie es auf den Rahmen oder überall an dieselbe Stelle.</translation>
    </message>
    <message>
        <source>One element covers the other, so that a text cannot be read or the wrong element is pressed.</source>
        <translation>Ein Element verdeckt das andere, sodass ein Text nicht lesbar ist oder das falsche Element gedrückt wird.</translation>
    </message>
    <message>
        <source>The element looks as if it had a function. Bind it to a variable, or remove it.</source>
        <translation>Das Element sieht aus, als hätte es eine Funktion. Verknüpfen Sie es mit einer Variablen oder entfernen Sie es.</translation>
    </message>
    <message>
        <source>A typing error sends 500 instead of 50. Limits reject it on entry.</source>
        <translation>Ein Tippfehler sendet 500 statt 50. Grenzwerte weisen ihn bei der Eingabe ab.</translation>
    </message>
    <message>
        <source>An alarm that nobody sees is useless. Put an alarm banner on the frame or an alarm list on a panel (ISA-18.2).</source>
        <translation>Ein Alarm, den niemand sieht, ist nutzlos. Setzen Sie ein Alarmbanner auf den Rahmen oder eine Alarmliste auf ein Panel (ISA-18.2).</translation>
    </message>
    <message>
        <source>An alarm requires the operator to act. Its help must say what to do, and what happens otherwise (ISA-18.2).</source>
        <translation>Ein Alarm verlangt eine Handlung des Bedieners. Seine Hilfe muss angeben, welche, und was sonst geschieht (ISA-18.2).</translation>
    </message>
    <message>
        <source>If everything is urgent, nothing is: about 5 % of the alarms should have the highest priority, 15 % the next (ISA-18.2).</source>
        <translation>Wenn alles dringend ist, ist es nichts: Etwa 5&#xa0;% der Alarme sollten die höchste Priorität haben, 15&#xa0;% die nächste (ISA-18.2).</translation>
    </message>
    <message>
        <source>the value {0} is outside the subrange {1}..{2}; limit it before the assignment or widen the subrange</source>
        <translation>der Wert {0} liegt außerhalb des Unterbereichs {1}..{2}; begrenzen Sie ihn vor der Zuweisung oder erweitern Sie den Unterbereich</translation>
    </message>
    <message>
        <source>&quot;addressing&quot; in project.json is &quot;byte&quot; or &quot;word&quot;, not &quot;{0}&quot;</source>
        <translation>„addressing“ in project.json ist „byte“ oder „word“, nicht „{0}“</translation>
    </message>
    <message>
        <source>&quot;memoryForNew&quot; in project.json is a number of bytes from 0 to {0}</source>
        <translation>„memoryForNew“ in project.json ist eine Anzahl Bytes von 0 bis {0}</translation>
    </message>
    <message>
        <source>A finger needs 7 mm in both directions, a gloved one 9 mm, as the strict level requires. The size of a pixel is set in project.json.</source>
        <translation>Ein Finger braucht 7&#xa0;mm in beiden Richtungen, im Handschuh 9&#xa0;mm, wie es die strenge Stufe verlangt. Die Größe eines Pixels wird in project.json angegeben.</translation>
    </message>
    <message>
        <source>Nothing is bound; fill in “{0}”</source>
        <translation>Nichts ist verknüpft; füllen Sie „{0}“ aus</translation>
    </message>
    <message>
        <source>Any number can be written to {0}; set “{1}”</source>
        <translation>In {0} kann jede Zahl geschrieben werden; legen Sie „{1}“ fest</translation>
    </message>
    <message>
        <source>One man in twelve cannot tell some colours apart, and bright light washes them out. Show the same information with a text, a shape, blinking or at least a different brightness.</source>
        <translation>Jeder zwölfte Mann kann manche Farben nicht unterscheiden, und bei grellem Licht verblassen sie. Zeigen Sie dasselbe auch durch einen Text, eine Form, Blinken oder wenigstens eine andere Helligkeit.</translation>
    </message>
    <message>
        <source>A write that is restricted to some roles, or that project.json lists as critical, must not be triggered by an accidental touch. Set &quot;Writes are confirmed&quot;, or enter a question.</source>
        <translation>Ein Schreibvorgang, der bestimmten Rollen vorbehalten oder in project.json als kritisch aufgeführt ist, darf nicht durch versehentliches Berühren ausgelöst werden. Aktivieren Sie „Schreiben wird bestätigt“ oder geben Sie eine Rückfrage ein.</translation>
    </message>
    <message>
        <source>Only {1} may write {0}, but no confirmation is required; set &quot;Writes are confirmed&quot;</source>
        <translation>Nur {1} darf {0} schreiben, aber es wird keine Bestätigung verlangt; aktivieren Sie „Schreiben wird bestätigt“</translation>
    </message>
    <message>
        <source>The theme is not valid JSON with a base and colors</source>
        <translation>Das Farbschema ist kein gültiges JSON mit base und colors</translation>
    </message>
    <message>
        <source>There is no built-in theme &quot;{0}&quot;; a base is light, dark or contrast</source>
        <translation>Es gibt kein eingebautes Farbschema „{0}“; die Basis muss light, dark oder contrast sein</translation>
    </message>
    <message>
        <source>There is no colour role {0}; check the spelling</source>
        <translation>Es gibt keine Farbrolle {0}; prüfen Sie die Schreibweise</translation>
    </message>
    <message>
        <source>There is no colour role {0}; did you mean {1}?</source>
        <translation>Es gibt keine Farbrolle {0}; meinten Sie {1}?</translation>
    </message>
    <message>
        <source>The colour of {0} must be written like {1}</source>
        <translation>Die Farbe von {0} muss wie {1} geschrieben werden</translation>
    </message>
    <message>
        <source>There is no theme {0}; choose one of {1}</source>
        <translation>Es gibt kein Farbschema {0}; wählen Sie eines von {1}</translation>
    </message>
    <message>
        <source>This edit would change the same text twice; undo it and edit the text</source>
        <translation>Diese Änderung würde denselben Text zweimal ändern; machen Sie sie rückgängig und bearbeiten Sie den Text</translation>
    </message>
    <message>
        <source>This transition does not lead to a step yet; connect it to one first</source>
        <translation>Diese Transition führt noch zu keinem Schritt; verbinden Sie sie zuerst mit einem</translation>
    </message>
    <message>
        <source>The panel was written by a newer version of Stepwise; open it with that version</source>
        <translation>Das Panel wurde von einer neueren Version von Stepwise geschrieben; öffnen Sie es mit dieser Version</translation>
    </message>
    <message>
        <source>This trace configuration was written by a newer version of Stepwise (version {0}); open it with that version</source>
        <translation>Diese Trace-Konfiguration wurde von einer neueren Version von Stepwise geschrieben (Version {0}); öffnen Sie sie mit dieser Version</translation>
    </message>
    <message>
        <source>The recorded program can no longer be built; open the recording with the version of Stepwise that made it</source>
        <translation>Das aufgezeichnete Programm lässt sich nicht mehr übersetzen; öffnen Sie die Aufzeichnung mit der Version von Stepwise, die sie erstellt hat</translation>
    </message>
    <message>
        <source>The controller is not running; press F5</source>
        <translation>Die Steuerung läuft nicht; drücken Sie F5</translation>
    </message>
    <message>
        <source>There is no program to run; declare a PROGRAM</source>
        <translation>Kein Programm zum Ausführen vorhanden; deklarieren Sie ein PROGRAM</translation>
    </message>
    <message>
        <source>There is no program to test; declare a PROGRAM</source>
        <translation>Kein Programm zum Testen vorhanden; deklarieren Sie ein PROGRAM</translation>
    </message>
    <message>
        <source>A file with this name already exists; choose another name</source>
        <translation>Eine Datei dieses Namens ist bereits vorhanden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>A panel with this name already exists; choose another name</source>
        <translation>Ein Panel dieses Namens ist bereits vorhanden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>A step {0} already exists; choose another name</source>
        <translation>Ein Schritt {0} ist bereits vorhanden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>The step of this loop is 0; write BY with another number</source>
        <translation>Die Schrittweite dieser Schleife ist 0; schreiben Sie BY mit einer anderen Zahl</translation>
    </message>
    <message>
        <source>This loop of the test does not end; give it a condition that becomes FALSE</source>
        <translation>Diese Schleife des Tests endet nicht; geben Sie ihr eine Bedingung, die FALSE wird</translation>
    </message>
    <message>
        <source>There is no name here that can be renamed; put the cursor on one</source>
        <translation>Hier ist kein Name, der umbenannt werden kann; setzen Sie den Cursor auf einen</translation>
    </message>
    <message>
        <source>The file was changed by another program and was not overwritten; compare both first</source>
        <translation>Die Datei wurde von einem anderen Programm geändert und nicht überschrieben; vergleichen Sie zuerst beide</translation>
    </message>
    <message>
        <source>The type of {0} is not known here; correct the errors of the program first</source>
        <translation>Der Typ von {0} ist hier nicht bekannt; beheben Sie zuerst die Fehler des Programms</translation>
    </message>
    <message>
        <source>Nothing has been recorded yet; start the controller with F5</source>
        <translation>Es wurde noch nichts aufgezeichnet; starten Sie die Steuerung mit F5</translation>
    </message>
    <message>
        <source>a constant cannot be forced; change it in the program</source>
        <translation>eine Konstante kann nicht geforct werden; ändern Sie sie im Programm</translation>
    </message>
    <message>
        <source>the path is incomplete; write it to a single value, for example Main.x</source>
        <translation>der Pfad ist unvollständig; schreiben Sie ihn bis zu einem einzelnen Wert, zum Beispiel Main.x</translation>
    </message>
    <message>
        <source>The panel is not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Das Panel ist kein gültiges JSON; suchen Sie nach einem fehlenden Komma, Anführungszeichen oder einer Klammer</translation>
    </message>
    <message>
        <source>The alarms are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Die Alarme sind kein gültiges JSON; suchen Sie nach einem fehlenden Komma, Anführungszeichen oder einer Klammer</translation>
    </message>
    <message>
        <source>The recipes are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Die Rezepturen sind kein gültiges JSON; suchen Sie nach einem fehlenden Komma, Anführungszeichen oder einer Klammer</translation>
    </message>
    <message>
        <source>The users and roles are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Die Benutzer und Rollen sind kein gültiges JSON; suchen Sie nach einem fehlenden Komma, Anführungszeichen oder einer Klammer</translation>
    </message>
    <message>
        <source>The trace configuration is not valid JSON (see line {0}); look for a missing comma, quote or bracket</source>
        <translation>Die Trace-Konfiguration ist kein gültiges JSON (siehe Zeile {0}); suchen Sie nach einem fehlenden Komma, Anführungszeichen oder einer Klammer</translation>
    </message>
    <message>
        <source>Two alarms have the id &quot;{0}&quot;; change one of them</source>
        <translation>Zwei Alarme haben die Kennung „{0}“; ändern Sie eine davon</translation>
    </message>
    <message>
        <source>The quote that opens here is never closed; add one at the end of the text</source>
        <translation>Das hier geöffnete Anführungszeichen wird nicht geschlossen; ergänzen Sie eines am Ende des Textes</translation>
    </message>
    <message>
        <source>The language {0} has two columns; remove one of them</source>
        <translation>Die Sprache {0} hat zwei Spalten; entfernen Sie eine davon</translation>
    </message>
    <message>
        <source>The key {0} is already on line {1}; remove one of the two lines</source>
        <translation>Der Schlüssel {0} ist bereits in Zeile {1} vorhanden; entfernen Sie eine der beiden Zeilen</translation>
    </message>
    <message>
        <source>Two roles are named {0}; rename one</source>
        <translation>Zwei Rollen heißen {0}; benennen Sie eine um</translation>
    </message>
    <message>
        <source>Two users are named {0}; rename one</source>
        <translation>Zwei Benutzer heißen {0}; benennen Sie einen um</translation>
    </message>
    <message>
        <source>Two recipes are named {0}; rename one</source>
        <translation>Zwei Rezepturen heißen {0}; benennen Sie eine um</translation>
    </message>
    <message>
        <source>Two sets of the recipe are named {0}; rename one</source>
        <translation>Zwei Datensätze der Rezeptur heißen {0}; benennen Sie einen um</translation>
    </message>
    <message>
        <source>The alarm has no condition; enter one</source>
        <translation>Der Alarm hat keine Bedingung; geben Sie eine ein</translation>
    </message>
    <message>
        <source>The element is outside the panel; move it inside</source>
        <translation>Das Element liegt außerhalb des Panels; verschieben Sie es hinein</translation>
    </message>
    <message>
        <source>The picture {0} is larger than {1} MB; use a smaller one</source>
        <translation>Das Bild {0} ist größer als {1}&#xa0;MB; verwenden Sie ein kleineres</translation>
    </message>
    <message>
        <source>The faceplate does not say which panel it shows; choose one</source>
        <translation>Das Faceplate gibt nicht an, welches Panel angezeigt wird; wählen Sie eines</translation>
    </message>
    <message>
        <source>The key {0} has no text in {1}; enter it in the text table</source>
        <translation>Der Schlüssel {0} hat keinen Text in {1}; geben Sie ihn in der Texttabelle ein</translation>
    </message>
    <message>
        <source>The help of the alarm {0} does not say what to do; add the operator&apos;s next step</source>
        <translation>Die Hilfe des Alarms {0} sagt nicht, was zu tun ist; ergänzen Sie den nächsten Schritt des Bedieners</translation>
    </message>
    <message>
        <source>the reference is NULL; assign a variable to it, or compare it with NULL first</source>
        <translation>die Referenz ist NULL; weisen Sie ihr eine Variable zu oder vergleichen Sie sie zuerst mit NULL</translation>
    </message>
    <message>
        <source>the reference does not point to a variable of its type; assign one to it</source>
        <translation>die Referenz zeigt auf keine Variable ihres Typs; weisen Sie ihr eine zu</translation>
    </message>
    <message>
        <source>a VAR_IN_OUT is not connected to a variable; connect it in the call</source>
        <translation>ein VAR_IN_OUT ist mit keiner Variablen verbunden; verbinden Sie ihn im Aufruf</translation>
    </message>
    <message>
        <source>the watchdog stopped a task that did not end; check for an endless loop</source>
        <translation>der Watchdog hat eine Task abgebrochen, die nicht endete; prüfen Sie, ob eine Schleife nicht endet</translation>
    </message>
    <message>
        <source>the task ran longer than its watchdog time of {0}; shorten its work or raise the time</source>
        <translation>die Task lief länger als ihre Watchdog-Zeit von {0}; verkürzen Sie ihre Arbeit oder erhöhen Sie die Zeit</translation>
    </message>
    <message>
        <source>the file name is too long; choose a shorter one</source>
        <translation>der Dateiname ist zu lang; wählen Sie einen kürzeren</translation>
    </message>
    <message>
        <source>the folder is not empty; choose another one</source>
        <translation>der Ordner ist nicht leer; wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>the file system is read-only; choose another folder</source>
        <translation>das Dateisystem ist schreibgeschützt; wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>too many files are open; close some of them</source>
        <translation>zu viele Dateien sind geöffnet; schließen Sie einige davon</translation>
    </message>
    <message>
        <source>The file is damaged or is not a recording; choose a file that Stepwise wrote (.rec)</source>
        <translation>Die Datei ist beschädigt oder keine Aufzeichnung; wählen Sie eine von Stepwise geschriebene Datei (.rec)</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is reached through a reference, which a path cannot follow; name the variable it refers to</source>
        <translation>„{0}“ ist nur über eine Referenz erreichbar, der ein Pfad nicht folgt; geben Sie die Variable an, auf die sie zeigt</translation>
    </message>
    <message>
        <source>a string has one index; remove the others</source>
        <translation>eine Zeichenkette hat einen Index; entfernen Sie die übrigen</translation>
    </message>
    <message>
        <source>a variable of type {0} has no elements; remove the index</source>
        <translation>eine Variable vom Typ {0} hat keine Elemente; entfernen Sie den Index</translation>
    </message>
    <message>
        <source>a variable of type {0} has no bits; remove the bit number</source>
        <translation>eine Variable vom Typ {0} hat keine Bits; entfernen Sie die Bitnummer</translation>
    </message>
    <message>
        <source>the program does not use the address &apos;{0}&apos;; declare a variable AT this address</source>
        <translation>das Programm verwendet die Adresse „{0}“ nicht; deklarieren Sie eine Variable mit AT an dieser Adresse</translation>
    </message>
    <message>
        <source>the path is empty; write for example Main.x</source>
        <translation>der Pfad ist leer; schreiben Sie zum Beispiel Main.x</translation>
    </message>
    <message>
        <source>a constant cannot be written; change it in the program</source>
        <translation>eine Konstante kann nicht geschrieben werden; ändern Sie sie im Programm</translation>
    </message>
    <message>
        <source>The retain file is not a regular file; remove it or choose another one</source>
        <translation>Die Retain-Datei ist keine gewöhnliche Datei; löschen Sie sie oder wählen Sie eine andere</translation>
    </message>
    <message>
        <source>the text has {0} characters, the maximum is {1}; shorten it</source>
        <translation>der Text hat {0} Zeichen, das Maximum ist {1}; kürzen Sie ihn</translation>
    </message>
    <message>
        <source>{0} has {1} {1:part|parts}, the value has {2}; write one value for each</source>
        <translation>{0} hat {1} {1:Teil|Teile}, der Wert hat {2}; schreiben Sie für jedes Teil einen Wert</translation>
    </message>
    <message>
        <source>there is no value to write; enter one first</source>
        <translation>kein Wert zum Schreiben vorhanden; geben Sie zuerst einen ein</translation>
    </message>
    <message>
        <source>The expression is nested too deeply; divide it into several</source>
        <translation>Der Ausdruck ist zu tief verschachtelt; teilen Sie ihn in mehrere auf</translation>
    </message>
    <message>
        <source>this is not an expression; write for example Main.x &gt; 5</source>
        <translation>das ist kein Ausdruck; schreiben Sie zum Beispiel Main.x &gt; 5</translation>
    </message>
    <message>
        <source>this is not an array; remove the index</source>
        <translation>das ist kein Array; entfernen Sie den Index</translation>
    </message>
    <message>
        <source>an expression cannot have side effects; use variables, operators and standard functions only</source>
        <translation>ein Ausdruck darf keine Seiteneffekte haben; verwenden Sie nur Variablen, Operatoren und Standardfunktionen</translation>
    </message>
    <message>
        <source>There is no body in ST or IL here; put the cursor into one</source>
        <translation>Hier ist kein Rumpf in ST oder AWL; setzen Sie den Cursor in einen</translation>
    </message>
    <message>
        <source>There is no library {0}; check &quot;libraries&quot; in project.json</source>
        <translation>Es gibt keine Bibliothek {0}; prüfen Sie „libraries“ in project.json</translation>
    </message>
    <message>
        <source>This folder contains neither a project.json nor ST files; choose another folder or create a project</source>
        <translation>Dieser Ordner enthält weder eine project.json noch ST-Dateien; wählen Sie einen anderen Ordner oder legen Sie ein Projekt an</translation>
    </message>
    <message>
        <source>There is no such file or folder; check the path</source>
        <translation>Datei oder Ordner nicht gefunden; prüfen Sie den Pfad</translation>
    </message>
    <message>
        <source>{0} already exists in the project; choose another name</source>
        <translation>{0} ist im Projekt bereits vorhanden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>{0} already exists in {1}; choose another name</source>
        <translation>{0} ist in {1} bereits vorhanden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>The file is read-only and was not overwritten; make it writable or choose another name</source>
        <translation>Die Datei ist schreibgeschützt und wurde nicht überschrieben; erlauben Sie das Schreiben oder wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>{0} is not a time; write for example T#2s</source>
        <translation>{0} ist keine Zeit; schreiben Sie zum Beispiel T#2s</translation>
    </message>
    <message>
        <source>{0} is not a whole number; write for example 5</source>
        <translation>{0} ist keine ganze Zahl; schreiben Sie zum Beispiel 5</translation>
    </message>
    <message>
        <source>{0} is not a number of scans; write for example 10</source>
        <translation>{0} ist keine Anzahl von Zyklen; schreiben Sie zum Beispiel 10</translation>
    </message>
    <message>
        <source>Nothing would lead to the join after this step; delete the join first</source>
        <translation>Zur Zusammenführung nach diesem Schritt würde nichts mehr führen; löschen Sie zuerst die Zusammenführung</translation>
    </message>
    <message>
        <source>There is no branch here; choose a step or transition in a branch</source>
        <translation>Hier gibt es keinen Zweig; wählen Sie einen Schritt oder eine Transition in einem Zweig</translation>
    </message>
    <message>
        <source>The last branch does not lead to a step; connect it first</source>
        <translation>Der letzte Zweig führt zu keinem Schritt; verbinden Sie ihn zuerst</translation>
    </message>
    <message>
        <source>There is no chart yet; write an INITIAL_STEP first</source>
        <translation>Es gibt noch keine Schrittkette; schreiben Sie zuerst einen INITIAL_STEP</translation>
    </message>
    <message>
        <source>An alarm has no id; give it one</source>
        <translation>Ein Alarm hat keine Kennung; geben Sie ihm eine</translation>
    </message>
    <message>
        <source>Column {0} has no language tag; write one such as de or en-GB</source>
        <translation>Spalte {0} hat kein Sprachkürzel; schreiben Sie zum Beispiel de oder en-GB</translation>
    </message>
    <message>
        <source>This line has no key; write one in the first column</source>
        <translation>Diese Zeile hat keinen Schlüssel; schreiben Sie einen in die erste Spalte</translation>
    </message>
    <message>
        <source>This is not an XLIFF file; choose one that was exported for translation</source>
        <translation>Das ist keine XLIFF-Datei; wählen Sie eine, die zum Übersetzen exportiert wurde</translation>
    </message>
    <message>
        <source>There is no panel {0}; create it or choose another one</source>
        <translation>Es gibt kein Panel {0}; legen Sie es an oder wählen Sie ein anderes</translation>
    </message>
    <message>
        <source>The key {0} is not in the text table; add it there</source>
        <translation>Der Schlüssel {0} ist nicht in der Texttabelle; fügen Sie ihn dort hinzu</translation>
    </message>
    <message>
        <source>The project has no language {0}; add a column for it to texts.csv</source>
        <translation>Das Projekt hat keine Sprache {0}; fügen Sie in texts.csv eine Spalte dafür hinzu</translation>
    </message>
    <message>
        <source>The file {0} does not exist; add it to the project or choose another one</source>
        <translation>Die Datei {0} ist nicht vorhanden; fügen Sie sie dem Projekt hinzu oder wählen Sie eine andere</translation>
    </message>
    <message>
        <source>The panel has no group or tab {0}; create it or choose another one</source>
        <translation>Das Panel hat keine Gruppe und keine Registerkarten {0}; legen Sie sie an oder wählen Sie eine andere</translation>
    </message>
    <message>
        <source>The group {0} contains itself; choose another parent</source>
        <translation>Die Gruppe {0} enthält sich selbst; wählen Sie eine andere übergeordnete Gruppe</translation>
    </message>
    <message>
        <source>A role has no name; give it one</source>
        <translation>Eine Rolle hat keinen Namen; geben Sie ihr einen</translation>
    </message>
    <message>
        <source>A user has no name; give it one</source>
        <translation>Ein Benutzer hat keinen Namen; geben Sie ihm einen</translation>
    </message>
    <message>
        <source>There is no role {0}; create it or choose another one</source>
        <translation>Die Rolle {0} gibt es nicht; legen Sie sie an oder wählen Sie eine andere</translation>
    </message>
    <message>
        <source>A recipe has no name; give it one</source>
        <translation>Eine Rezeptur hat keinen Namen; geben Sie ihr einen</translation>
    </message>
    <message>
        <source>A set of a recipe has no name; give it one</source>
        <translation>Ein Datensatz einer Rezeptur hat keinen Namen; geben Sie ihm einen</translation>
    </message>
    <message>
        <source>The recipe has the variable {0} twice; remove one of the two</source>
        <translation>Die Rezeptur enthält die Variable {0} doppelt; entfernen Sie eine von beiden</translation>
    </message>
    <message>
        <source>The set {0} has no value for {1}; enter one</source>
        <translation>Der Datensatz {0} hat keinen Wert für {1}; geben Sie einen ein</translation>
    </message>
    <message>
        <source>There is no alarm class {0}; add it or choose another one</source>
        <translation>Es gibt keine Alarmklasse {0}; fügen Sie sie hinzu oder wählen Sie eine andere</translation>
    </message>
    <message>
        <source>No panel and no alarm uses the key {0}; use it or remove it</source>
        <translation>Kein Panel und kein Alarm verwendet den Schlüssel {0}; verwenden oder entfernen Sie ihn</translation>
    </message>
    <message>
        <source>The placeholders differ: {0} has {1}, {2} has {3}; use the same in both</source>
        <translation>Die Platzhalter sind unterschiedlich: {0} hat {1}, {2} hat {3}; verwenden Sie in beiden dieselben</translation>
    </message>
    <message>
        <source>The font {0} is not installed here, so texts cannot be measured; install it</source>
        <translation>Die Schrift {0} ist hier nicht installiert, deshalb können Texte nicht gemessen werden; installieren Sie sie</translation>
    </message>
    <message>
        <source>No font has the character {0}; use another one</source>
        <translation>Keine Schrift hat das Zeichen {0}; verwenden Sie ein anderes</translation>
    </message>
    <message>
        <source>{0} covers a part of it; move one of the two</source>
        <translation>{0} verdeckt einen Teil davon; verschieben Sie eines der beiden</translation>
    </message>
    <message>
        <source>Nothing leads from the start panel {1} to the panel {0}; add a button, a navigation bar or an alarm, or choose another start panel</source>
        <translation>Vom Startpanel {1} führt nichts zum Panel {0}; fügen Sie eine Schaltfläche, eine Navigationsleiste oder einen Alarm hinzu, oder wählen Sie ein anderes Startpanel</translation>
    </message>
    <message>
        <source>{0} of {1} alarms have the highest priority; keep it for the few that cannot wait</source>
        <translation>{0} von {1} Alarmen haben die höchste Priorität; verwenden Sie sie nur für die wenigen, die nicht warten können</translation>
    </message>
    <message>
        <source>The project has {0} {0:alarm|alarms}, but no panel has an alarm list or banner; add one</source>
        <translation>Das Projekt hat {0} {0:Alarm|Alarme}, aber kein Panel hat eine Alarmliste oder ein Alarmbanner; fügen Sie eines hinzu</translation>
    </message>
    <message>
        <source>{0} is critical according to project.json, but a single press writes it; set &quot;Writes are confirmed&quot;</source>
        <translation>{0} ist laut project.json kritisch, doch ein einziger Druck schreibt den Wert; aktivieren Sie „Schreiben wird bestätigt“</translation>
    </message>
    <message>
        <source>{0} suppresses alarms, but a single press writes it; set &quot;Writes are confirmed&quot;</source>
        <translation>{0} unterdrückt Alarme, doch ein einziger Druck schreibt den Wert; aktivieren Sie „Schreiben wird bestätigt“</translation>
    </message>
    <message>
        <source>The start panel has {0} controls, but no text says what to press when nothing moves; add a sentence, or a state text that names a control</source>
        <translation>Das Startpanel hat {0} Bedienelemente, aber kein Text sagt, was zu drücken ist, wenn sich nichts bewegt; fügen Sie einen Satz hinzu oder einen Zustandstext, der ein Bedienelement nennt</translation>
    </message>
    <message>
        <source>A machine at rest looks the same whether it is broken or just waiting. The start panel must say what to press next: a sentence below the title, or a state text such as “Ready: press S1”.</source>
        <translation>Eine stillstehende Maschine sieht gleich aus, ob sie defekt ist oder nur wartet. Das Startpanel muss angeben, was als Nächstes zu drücken ist: mit einem Satz unter dem Titel oder einem Zustandstext wie „Bereit: S1 drücken“.</translation>
    </message>
    <message>
        <source>{0} is not the code of a language; use codes such as {1} or {2}</source>
        <translation>{0} ist kein Sprachcode; verwenden Sie Codes wie {1} oder {2}</translation>
    </message>
    <message>
        <source>Single files have no project.json for settings; create a project and put them into its folder src</source>
        <translation>Einzelne Dateien haben keine project.json für Einstellungen; legen Sie ein Projekt an und die Dateien in seinen Ordner src</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>Alarm texts in five languages</source>
        <translation>Alarmtexte in fünf Sprachen</translation>
    </message>
    <message>
        <source>Heated tank with analog blocks</source>
        <translation>Behälter mit Analogbausteinen</translation>
    </message>
    <message>
        <source>Bottling line</source>
        <translation>Abfüllanlage</translation>
    </message>
    <message>
        <source>Car park with a robot</source>
        <translation>Parkhaus mit Roboter</translation>
    </message>
    <message>
        <source>Car wash with recipes</source>
        <translation>Autowaschanlage mit Rezepturen</translation>
    </message>
    <message>
        <source>Room heating with supply air</source>
        <translation>Raumheizung über Zuluft</translation>
    </message>
    <message>
        <source>Motor valve with command monitor</source>
        <translation>Motorventil mit Laufzeitüberwachung</translation>
    </message>
    <message>
        <source>Conveyor with a sequence</source>
        <translation>Förderband mit Schrittkette</translation>
    </message>
    <message>
        <source>Depalletiser</source>
        <translation>Depalettierer</translation>
    </message>
    <message>
        <source>District-heating substation</source>
        <translation>Fernwärme-Übergabestation</translation>
    </message>
    <message>
        <source>Dosing</source>
        <translation>Dosierung</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Gravel plant</source>
        <translation>Kieswerk</translation>
    </message>
    <message>
        <source>Heater and valve</source>
        <translation>Heizung und Ventil</translation>
    </message>
    <message>
        <source>Hour meter with reset and enable</source>
        <translation>Betriebsstundenzähler mit Freigabe</translation>
    </message>
    <message>
        <source>Hourly production</source>
        <translation>Teile pro Stunde</translation>
    </message>
    <message>
        <source>Item counter and meters</source>
        <translation>Teile und Zähler</translation>
    </message>
    <message>
        <source>Level lamps</source>
        <translation>Füllstandslampen</translation>
    </message>
    <message>
        <source>Light tower</source>
        <translation>Signalsäule</translation>
    </message>
    <message>
        <source>Tuning a control loop</source>
        <translation>Einstellen eines Regelkreises</translation>
    </message>
    <message>
        <source>Mixer for two liquids and two bricks</source>
        <translation>Mischer für Flüssigkeiten und Briketts</translation>
    </message>
    <message>
        <source>Motor with latching</source>
        <translation>Motor mit Selbsthaltung</translation>
    </message>
    <message>
        <source>Operation mode of an agitator</source>
        <translation>Betriebsart eines Rührwerks</translation>
    </message>
    <message>
        <source>PID loop on a first-order process</source>
        <translation>PID-Regelkreis an einer PT1-Strecke</translation>
    </message>
    <message>
        <source>Two pumps in a well</source>
        <translation>Zwei Pumpen in einem Schacht</translation>
    </message>
    <message>
        <source>Pulse width modulation of a sine</source>
        <translation>Pulsweitenmodulation eines Sinus</translation>
    </message>
    <message>
        <source>Storage rack with a robot</source>
        <translation>Regal mit Roboter</translation>
    </message>
    <message>
        <source>Robot and CNC machine</source>
        <translation>Roboter und CNC-Maschine</translation>
    </message>
    <message>
        <source>Packing robot with camera inspection</source>
        <translation>Packroboter mit Kameraprüfung</translation>
    </message>
    <message>
        <source>Two redundant level sensors</source>
        <translation>Zwei Füllstandsensoren im Vergleich</translation>
    </message>
    <message>
        <source>Pumping station with six pumps</source>
        <translation>Pumpstation mit sechs Pumpen</translation>
    </message>
    <message>
        <source>Motor with selector switch</source>
        <translation>Motor mit Wahlschalter</translation>
    </message>
    <message>
        <source>Stack of integers</source>
        <translation>Stapel für ganze Zahlen</translation>
    </message>
    <message>
        <source>Tank with filling, heating and emptying</source>
        <translation>Behälter füllen, heizen und leeren</translation>
    </message>
    <message>
        <source>Manually operated tank</source>
        <translation>Behälter mit Handbedienung</translation>
    </message>
    <message>
        <source>Level and volume</source>
        <translation>Füllstand und Volumen</translation>
    </message>
    <message>
        <source>Traffic light</source>
        <translation>Ampel</translation>
    </message>
    <message>
        <source>Valve matrix</source>
        <translation>Ventilmatrix</translation>
    </message>
    <message>
        <source>Three kinds of valves</source>
        <translation>Drei Arten von Ventilen</translation>
    </message>
    <message>
        <source>Pump control with waves</source>
        <translation>Pumpe bei Wellengang</translation>
    </message>
    <message>
        <source>Truck scale</source>
        <translation>Lkw-Waage</translation>
    </message>
    <message>
        <source>Workbook</source>
        <translation>Übungsbuch</translation>
    </message>
    <message>
        <source>Tank over Modbus</source>
        <translation>Behälter über Modbus</translation>
    </message>
    <message>
        <source>A vehicle between two limit switches, controlled by two linked sequential function charts</source>
        <translation>Ein Fahrzeug zwischen zwei Endschaltern, gesteuert von zwei verknüpften Schrittketten</translation>
    </message>
    <message>
        <source>A motor with three alarms that operators read in five languages</source>
        <translation>Ein Motor mit drei Alarmen, die der Bediener in fünf Sprachen liest</translation>
    </message>
    <message>
        <source>One control loop with a block for each task: filter, monitor, ramp, PID, transfer</source>
        <translation>Ein Regelkreis mit einem Baustein je Aufgabe: Filter, Überwachung, Rampe, PID, Umschaltung</translation>
    </message>
    <message>
        <source>Filler, capper and labeller with buffers between them, controlled as PackML units</source>
        <translation>Füller, Verschließer und Etikettierer mit Puffern dazwischen, gesteuert nach PackML</translation>
    </message>
    <message>
        <source>A robot parks cars by number plate and retrieves them again</source>
        <translation>Ein Roboter parkt Autos nach ihrem Kennzeichen ein und holt sie wieder</translation>
    </message>
    <message>
        <source>Five wash programmes, each with a price and a recipe that the owner can edit</source>
        <translation>Fünf Waschprogramme, jedes mit Preis und Rezeptur, die der Betreiber ändern kann</translation>
    </message>
    <message>
        <source>Cascade control: a slow loop for the room, a fast one for the supply air</source>
        <translation>Kaskadenregelung: ein langsamer Kreis für den Raum, ein schneller für die Zuluft</translation>
    </message>
    <message>
        <source>A motor valve whose travel is monitored; if it takes too long, an alarm sounds</source>
        <translation>Ein Motorventil mit Laufzeitüberwachung; dauert es zu lange, ertönt ein Alarm</translation>
    </message>
    <message>
        <source>A belt carries an item to the right, waits ten seconds and carries it back</source>
        <translation>Ein Förderband bringt ein Teil nach rechts, wartet zehn Sekunden und bringt es zurück</translation>
    </message>
    <message>
        <source>Four belts take boxes off pallets; the settings of one can be copied to another</source>
        <translation>Vier Bänder nehmen Kartons von Paletten; Einstellungen lassen sich kopieren</translation>
    </message>
    <message>
        <source>Heating and hot water from a district-heating network, with frost protection and summer mode</source>
        <translation>Heizung und Warmwasser aus Fernwärme, mit Frostschutz und Sommerbetrieb</translation>
    </message>
    <message>
        <source>A valve doses in pulses and pauses until the batch is complete</source>
        <translation>Ein Ventil dosiert in Impulsen und Pausen, bis die Charge vollständig ist</translation>
    </message>
    <message>
        <source>The pressure drop shows how dirty a filter is; an alarm reports when it is out of range</source>
        <translation>Der Druckverlust zeigt, wie verschmutzt ein Filter ist; außerhalb des Bereichs folgt ein Alarm</translation>
    </message>
    <message>
        <source>Silo, bin, conveyor and truck, controlled by three parallel sequential function charts</source>
        <translation>Silo, Behälter, Förderband und Lkw, gesteuert von drei parallelen Schrittketten</translation>
    </message>
    <message>
        <source>Two on-off controls: a heater with a set point, and a valve that opens on a pump alarm</source>
        <translation>Zwei Zweipunktregelungen: eine Heizung mit Sollwert und ein Ventil, das bei Pumpenalarm öffnet</translation>
    </message>
    <message>
        <source>An hour meter that is loaded, enabled and held, giving a sawtooth</source>
        <translation>Ein Betriebsstundenzähler, der geladen, freigegeben und angehalten wird: ein Sägezahn</translation>
    </message>
    <message>
        <source>A press makes items; a table counts how many in each hour of the day</source>
        <translation>Eine Presse fertigt Teile; eine Tabelle zählt sie je Stunde des Tages</translation>
    </message>
    <message>
        <source>Counts items, energy and water; the counts survive a power failure</source>
        <translation>Zählt Teile, Energie und Wasser; die Zählerstände überstehen einen Stromausfall</translation>
    </message>
    <message>
        <source>A 4 to 20 mA level sensor, three lamps and wire break detection</source>
        <translation>Ein Füllstandsensor mit 4 bis 20&#xa0;mA, drei Lampen und Drahtbrucherkennung</translation>
    </message>
    <message>
        <source>Three machine signals on three lamps that flash or stay on</source>
        <translation>Drei Signale einer Maschine auf drei Lampen, die blinken oder leuchten</translation>
    </message>
    <message>
        <source>A heat exchanger that oscillates; an experiment and its recording give better settings</source>
        <translation>Ein Wärmetauscher schwingt; ein Versuch und seine Aufzeichnung ergeben bessere Parameter</translation>
    </message>
    <message>
        <source>Liquids are weighed while a belt brings two bricks; then the mixer turns and tips</source>
        <translation>Flüssigkeiten werden gewogen, ein Band bringt zwei Briketts; dann mischt und kippt der Mischer</translation>
    </message>
    <message>
        <source>Start, stop and a latching contactor, written in five ways that agree</source>
        <translation>Start, Stopp und ein Schütz mit Selbsthaltung, auf fünf gleichwertige Arten geschrieben</translation>
    </message>
    <message>
        <source>The local control box or the panel: one block decides which of them is in control</source>
        <translation>Vor-Ort-Steuerung oder Panel: Ein Baustein entscheidet, wer die Bedienhoheit hat</translation>
    </message>
    <message>
        <source>The same process with and without a PID controller, side by side in one trace</source>
        <translation>Derselbe Prozess mit und ohne PID-Regler, nebeneinander in einem Trace</translation>
    </message>
    <message>
        <source>One filter, two sines: the slow one passes, the fast one is attenuated and delayed</source>
        <translation>Ein Filter, zwei Sinussignale: Das langsame passiert, das schnelle wird gedämpft und eilt nach</translation>
    </message>
    <message>
        <source>A pump tries its speeds and keeps the one with the least energy per cubic metre</source>
        <translation>Eine Pumpe probiert Drehzahlen aus und behält die mit der geringsten Energie je Kubikmeter</translation>
    </message>
    <message>
        <source>Two alternating pumps; a float switch is accepted only after two steady seconds</source>
        <translation>Zwei Pumpen wechseln sich ab; ein Schwimmer zählt erst nach zwei ruhigen Sekunden</translation>
    </message>
    <message>
        <source>A sine becomes pulses for two outputs, as for a motor with two directions</source>
        <translation>Ein Sinus wird zu Impulsen für zwei Ausgänge, wie für einen Motor mit zwei Drehrichtungen</translation>
    </message>
    <message>
        <source>A robot counts encoder pulses to store and retrieve loads in twelve locations</source>
        <translation>Ein Roboter zählt Geberimpulse und lagert Lasten in zwölf Fächern ein und aus</translation>
    </message>
    <message>
        <source>A robot takes 25 items one by one to a CNC machine and back</source>
        <translation>Ein Roboter bringt 25 Teile nacheinander zu einer CNC-Maschine und zurück</translation>
    </message>
    <message>
        <source>A robot puts three items into each box; a camera checks the result</source>
        <translation>Ein Roboter legt drei Teile in jeden Karton; eine Kamera prüft das Ergebnis</translation>
    </message>
    <message>
        <source>Two sensors are compared; a faulty one is replaced with the healthy one without a jump</source>
        <translation>Zwei Sensoren im Vergleich; ein gestörter wird stoßfrei durch den gesunden ersetzt</translation>
    </message>
    <message>
        <source>Starts and stops six pumps by level and running hours, with the daily inflow of a town</source>
        <translation>Schaltet sechs Pumpen nach Füllstand und Betriebsstunden über den Tagesgang einer Stadt</translation>
    </message>
    <message>
        <source>A rotary switch selects the speed of a motor, a number what a module does</source>
        <translation>Ein Drehschalter wählt die Drehzahl eines Motors, eine Zahl die Funktion eines Moduls</translation>
    </message>
    <message>
        <source>Last in, first out: push, pop and reset, in ST and as an instruction list</source>
        <translation>Zuletzt hinein, zuerst heraus: Push, Pop und Reset, in ST und als Anweisungsliste</translation>
    </message>
    <message>
        <source>The same sequence twice: with CASE and as a sequential function chart; either can be in control</source>
        <translation>Derselbe Ablauf zweimal: mit CASE und als Schrittkette; beide können steuern</translation>
    </message>
    <message>
        <source>Fill, empty and stir with three switches; two level switches prevent operating errors</source>
        <translation>Füllen, Leeren und Rühren mit drei Schaltern; zwei Niveauschalter verhindern Fehler</translation>
    </message>
    <message>
        <source>A current of 4 to 20 mA becomes a level, and the level becomes a volume</source>
        <translation>Aus einem Strom von 4 bis 20&#xa0;mA wird ein Füllstand, aus dem Füllstand ein Volumen</translation>
    </message>
    <message>
        <source>Red, yellow and green from one seconds counter, written in three ways</source>
        <translation>Rot, Gelb und Grün aus einem Sekundenzähler, auf drei Arten geschrieben</translation>
    </message>
    <message>
        <source>Five tanks, three pipelines, fifteen valves; two tanks never feed the same pipeline</source>
        <translation>Fünf Behälter, drei Leitungen, fünfzehn Ventile; nie speisen zwei Behälter eine Leitung</translation>
    </message>
    <message>
        <source>A motor valve, a spring-return valve and a control valve, each with its block</source>
        <translation>Ein Motorventil, ein Ventil mit Federrückstellung und ein Regelventil, je mit Baustein</translation>
    </message>
    <message>
        <source>A float switch in waves: the pump starts and stops only after five steady seconds</source>
        <translation>Ein Schwimmer in Wellen: Die Pumpe schaltet erst nach fünf ruhigen Sekunden</translation>
    </message>
    <message>
        <source>Four BCD digits become the net weight once the scale has settled</source>
        <translation>Vier BCD-Ziffern werden zum Nettogewicht, sobald die Waage zur Ruhe gekommen ist</translation>
    </message>
    <message>
        <source>Language samples on four pages, each a separate program with a test</source>
        <translation>Sprachbeispiele auf vier Seiten, jedes ein eigenes Programm mit Test</translation>
    </message>
    <message>
        <source>Automated guided vehicle</source>
        <translation>Fahrerloses Transportfahrzeug</translation>
    </message>
    <message>
        <source>First-order filter and two sines</source>
        <translation>PT1-Filter und zwei Sinussignale</translation>
    </message>
    <message>
        <source>Pump at its most efficient speed</source>
        <translation>Pumpe mit effizientester Drehzahl</translation>
    </message>
    <message>
        <source>A controller and a tank, connected on this computer by real Modbus TCP</source>
        <translation>Eine Steuerung und ein Behälter, auf diesem Rechner über echtes Modbus TCP verbunden</translation>
    </message>
</context>
<context>
    <name>Exchange</name>
    <message>
        <source>The file is written in {0}</source>
        <translation>Die Datei ist in {0} geschrieben</translation>
    </message>
    <message>
        <source>The file was not read: {0}</source>
        <translation>Die Datei wurde nicht gelesen: {0}</translation>
    </message>
    <message>
        <source>The element {0} was not read; add it by hand if the program needs it</source>
        <translation>Das Element {0} wurde nicht gelesen; ergänzen Sie es von Hand, falls das Programm es braucht</translation>
    </message>
    <message>
        <source>The vendor&apos;s data {0} is kept in exchange.json</source>
        <translation>Die Herstellerdaten {0} bleiben in exchange.json erhalten</translation>
    </message>
    <message>
        <source>The body in {0} became structured text; the diagram is kept in exchange.json</source>
        <translation>Der Rumpf von {0} wurde zu strukturiertem Text; das Diagramm bleibt in exchange.json erhalten</translation>
    </message>
    <message>
        <source>The body in {0} is stored in a form that only its own editor reads; export it there as PLCopen XML</source>
        <translation>Der Rumpf von {0} ist in einer Form gespeichert, die nur der eigene Editor liest; exportieren Sie ihn dort als PLCopen XML</translation>
    </message>
    <message>
        <source>A jump leads to the step {0}, which does not exist; add the step or correct the jump</source>
        <translation>Ein Sprung führt zum Schritt {0}, den es nicht gibt; fügen Sie den Schritt hinzu oder berichtigen Sie den Sprung</translation>
    </message>
    <message>
        <source>The element {0} of the chart is not connected and was left out; connect it in the other tool and export again</source>
        <translation>Das Element {0} der Schrittkette ist nicht verbunden und wurde ausgelassen; verbinden Sie es im anderen Werkzeug und exportieren Sie erneut</translation>
    </message>
    <message>
        <source>The transition from {0} has no condition and is written as FALSE; enter its condition</source>
        <translation>Die Transition von {0} hat keine Bedingung und ist als FALSE geschrieben; geben Sie ihre Bedingung ein</translation>
    </message>
    <message>
        <source>The element {0} takes part in a loop without a block that stores a value, so its last value is not kept; store it in a variable</source>
        <translation>Das Element {0} gehört zu einer Schleife ohne Baustein, der einen Wert speichert, sein letzter Wert bleibt also nicht erhalten; speichern Sie ihn in einer Variablen</translation>
    </message>
    <message>
        <source>The element {0} is not connected and was left out; connect it in the other tool and export again</source>
        <translation>Das Element {0} ist nicht verbunden und wurde ausgelassen; verbinden Sie es im anderen Werkzeug und exportieren Sie erneut</translation>
    </message>
    <message>
        <source>An input of {0} is not connected, so its call has too few arguments; add the value that is meant</source>
        <translation>Ein Eingang von {0} ist nicht verbunden, daher hat der Aufruf zu wenige Argumente; den gemeinten Wert ergänzen</translation>
    </message>
    <message>
        <source>An edge in a function needs the value of the last call, which a function does not store; make it a FUNCTION_BLOCK</source>
        <translation>Eine Flanke in einer Funktion braucht den Wert des letzten Aufrufs, den eine Funktion nicht speichert; machen Sie daraus einen FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>The result of {0} is used in several places and is computed in each; assign it to a variable to compute it once</source>
        <translation>Das Ergebnis von {0} wird an mehreren Stellen verwendet und an jeder berechnet; weisen Sie es einer Variablen zu, um es einmal zu berechnen</translation>
    </message>
    <message>
        <source>The type of the result of {0} is not known, so it is computed although EN is FALSE; call it under an IF</source>
        <translation>Der Typ des Ergebnisses von {0} ist nicht bekannt, daher wird es berechnet, obwohl EN FALSE ist; rufen Sie es unter einem IF auf</translation>
    </message>
    <message>
        <source>The library {0} is not part of Stepwise; uses of it are reported by the check</source>
        <translation>Die Bibliothek {0} gehört nicht zu Stepwise; die Prüfung meldet ihre Verwendungen</translation>
    </message>
    <message>
        <source>Code in C is kept as a comment and is not executed; write it in ST</source>
        <translation>Code in C bleibt als Kommentar erhalten und wird nicht ausgeführt; schreiben Sie ihn in ST</translation>
    </message>
    <message>
        <source>There are two units named {0}; the second is in {1}</source>
        <translation>Es gibt zwei Bausteine namens {0}; der zweite steht in {1}</translation>
    </message>
    <message>
        <source>The configuration of the devices was not read; assign the inputs and outputs again</source>
        <translation>Die Konfiguration der Geräte wurde nicht gelesen; weisen Sie die Ein- und Ausgänge neu zu</translation>
    </message>
    <message>
        <source>The task {0} is started by the event {1}, which does not exist here; give it an INTERVAL or a SINGLE</source>
        <translation>Die Task {0} startet mit dem Ereignis {1}, das es hier nicht gibt; geben Sie ihr ein INTERVAL oder ein SINGLE</translation>
    </message>
    <message>
        <source>A comment outside of the elements was left out: {0}</source>
        <translation>Ein Kommentar außerhalb der Elemente wurde ausgelassen: {0}</translation>
    </message>
    <message>
        <source>The diagram in {0} was not read: an expression refers to itself endlessly; write its body in ST</source>
        <translation>Das Diagramm in {0} wurde nicht gelesen: Ein Ausdruck verweist endlos auf sich selbst; schreiben Sie seinen Rumpf in ST</translation>
    </message>
    <message>
        <source>The transition {0} is not a single expression and was not read; write its condition in the text</source>
        <translation>Die Transition {0} ist kein einzelner Ausdruck und wurde nicht gelesen; schreiben Sie ihre Bedingung im Text</translation>
    </message>
    <message>
        <source>PLCopen XML does not support panels; they were left out</source>
        <translation>PLCopen XML unterstützt Panels nicht; sie wurden ausgelassen</translation>
    </message>
    <message>
        <source>PLCopen XML does not support traces; they were left out</source>
        <translation>PLCopen XML unterstützt Traces nicht; sie wurden ausgelassen</translation>
    </message>
    <message>
        <source>PLCopen XML does not support tests; they were left out</source>
        <translation>PLCopen XML unterstützt Tests nicht; sie wurden ausgelassen</translation>
    </message>
    <message>
        <source>PLCopen XML does not support tests; the TEST &apos;{0}&apos; was left out</source>
        <translation>PLCopen XML unterstützt Tests nicht; der TEST „{0}“ wurde ausgelassen</translation>
    </message>
    <message>
        <source>PLCopen XML does not support namespaces; the names of {0} are written without the prefix</source>
        <translation>PLCopen XML unterstützt Namensräume nicht; die Namen aus {0} werden ohne das Präfix geschrieben</translation>
    </message>
    <message>
        <source>PLCopen XML does not support namespaces; {0} was left out with its units because there is another {1}; rename one of them</source>
        <translation>PLCopen XML unterstützt Namensräume nicht; {0} wurde mit seinen Bausteinen ausgelassen, weil es ein weiteres {1} gibt; eines davon umbenennen</translation>
    </message>
    <message>
        <source>PLCopen XML does not support USING; it was left out</source>
        <translation>PLCopen XML unterstützt USING nicht; es wurde ausgelassen</translation>
    </message>
    <message>
        <source>PLCopen XML does not support the name of the transition {0}; it was left out</source>
        <translation>PLCopen XML unterstützt den Namen der Transition {0} nicht; er wurde ausgelassen</translation>
    </message>
    <message>
        <source>PLCopen XML has one indicator per action; {0} was left out</source>
        <translation>PLCopen XML hat eine Rückmeldevariable je Aktion; {0} wurde ausgelassen</translation>
    </message>
    <message>
        <source>Version 0201 has no methods; {0} was left out</source>
        <translation>Version 0201 hat keine Methoden; {0} wurde ausgelassen</translation>
    </message>
    <message>
        <source>Version 0201 has no properties; {0} was left out</source>
        <translation>Version 0201 hat keine Eigenschaften; {0} wurde ausgelassen</translation>
    </message>
    <message>
        <source>Version 0201 has no interfaces; {0} was left out</source>
        <translation>Version 0201 hat keine Schnittstellen; {0} wurde ausgelassen</translation>
    </message>
    <message>
        <source>Version 0201 has no unions; {0} was left out</source>
        <translation>Version 0201 hat keine Unions; {0} wurde ausgelassen</translation>
    </message>
    <message>
        <source>Version 0201 has no inheritance; EXTENDS or IMPLEMENTS of {0} was left out</source>
        <translation>Version 0201 hat keine Vererbung; EXTENDS oder IMPLEMENTS von {0} wurde ausgelassen</translation>
    </message>
    <message>
        <source>Version 0201 does not have the type {0}; other tools will not know it</source>
        <translation>Version 0201 kennt den Typ {0} nicht; andere Werkzeuge werden ihn nicht kennen</translation>
    </message>
    <message>
        <source>Version 0201 does not support the pragma {0} of a step; it was left out</source>
        <translation>Version 0201 unterstützt das Pragma {0} eines Schritts nicht; es wurde ausgelassen</translation>
    </message>
    <message>
        <source>Version 0201 does not support {0} of a task; it was left out</source>
        <translation>Version 0201 unterstützt {0} einer Task nicht; es wurde ausgelassen</translation>
    </message>
    <message>
        <source>Version 0201 does not support the connections of the program {0}; they were left out</source>
        <translation>Version 0201 unterstützt die Verbindungen des Programms {0} nicht; sie wurden ausgelassen</translation>
    </message>
    <message>
        <source>Version 0201 does not support libraries; {0} was left out</source>
        <translation>Version 0201 unterstützt Bibliotheken nicht; {0} wurde ausgelassen</translation>
    </message>
    <message>
        <source>The file is not a program source and was left out; import it separately if it is one</source>
        <translation>Die Datei ist kein Programmquelltext und wurde ausgelassen; importieren Sie sie einzeln, falls sie doch einer ist</translation>
    </message>
    <message>
        <source>The network &apos;{0}&apos; is commented out in the diagram and was left out of the text</source>
        <translation>Das Netzwerk „{0}“ ist im Diagramm auskommentiert und fehlt im Text</translation>
    </message>
    <message>
        <source>Types that are predefined in {0} are declared here</source>
        <translation>Typen, die in {0} vordefiniert sind, sind hier deklariert</translation>
    </message>
    <message>
        <source>{0} counts %MW1 in words; &quot;addressing&quot; in project.json says the same</source>
        <translation>{0} zählt %MW1 in Wörtern; „addressing“ in project.json ist entsprechend gesetzt</translation>
    </message>
    <message>
        <source>The address {0} starts at a byte that tools counting in words cannot address; move it to a multiple of its size</source>
        <translation>Die Adresse {0} beginnt an einem Byte, das Werkzeuge mit Wortzählung nicht adressieren können; verschieben Sie sie auf ein Vielfaches ihrer Größe</translation>
    </message>
    <message>
        <source>{0} accesses the system outside the controller; it is declared here with its inputs and outputs but does nothing</source>
        <translation>{0} greift auf das System außerhalb der Steuerung zu; hier ist der Baustein mit seinen Ein- und Ausgängen deklariert, tut aber nichts</translation>
    </message>
    <message>
        <source>The library {0} is part of this import; its names are written without the prefix {0}</source>
        <translation>Die Bibliothek {0} ist Teil dieses Imports; ihre Namen werden ohne das Präfix {0} geschrieben</translation>
    </message>
    <message>
        <source>The names of the library {0} are built into Stepwise; they are written without the prefix {0}</source>
        <translation>Die Namen der Bibliothek {0} sind in Stepwise eingebaut; sie werden ohne das Präfix {0} geschrieben</translation>
    </message>
    <message>
        <source>The program uses __NEW; &quot;memoryForNew&quot; in project.json sets 65536 bytes aside for it</source>
        <translation>Das Programm verwendet __NEW; „memoryForNew“ in project.json reserviert dafür 65536 Bytes</translation>
    </message>
    <message>
        <source>STRING constants contain characters that Latin-1 does not have ({0} and so on); &quot;stringEncoding&quot; in project.json is {1}</source>
        <translation>STRING-Konstanten enthalten Zeichen, die Latin-1 nicht hat ({0} und so weiter); „stringEncoding“ in project.json ist {1}</translation>
    </message>
    <message>
        <source>The file is empty; export it again</source>
        <translation>Die Datei ist leer; exportieren Sie sie erneut</translation>
    </message>
    <message>
        <source>This is a ZIP archive despite its name; extract it and import the folder</source>
        <translation>Trotz ihres Namens ist die Datei ein ZIP-Archiv; entpacken Sie es und importieren Sie den Ordner</translation>
    </message>
    <message>
        <source>The file is in the folder of the project {0}, which does not list it or excludes it from its build; it was left out</source>
        <translation>Die Datei liegt im Ordner des Projekts {0}, das sie nicht aufführt oder vom Build ausschließt; sie wurde ausgelassen</translation>
    </message>
    <message>
        <source>Several projects of the folder have a unit named {0}; each became a project of its own, together with the libraries it uses: this one is {1}</source>
        <translation>Mehrere Projekte des Ordners haben einen Baustein {0}; aus jedem wurde ein eigenes Projekt mit den Bibliotheken, die es verwendet: Dieses ist {1}</translation>
    </message>
    <message>
        <source>The program {0} of the library {1} was left out: the project that uses the library has one of that name</source>
        <translation>Das Programm {0} der Bibliothek {1} wurde ausgelassen: Das Projekt, das die Bibliothek verwendet, hat eines dieses Namens</translation>
    </message>
    <message>
        <source>The folder has no project named {0}; it has: {1}</source>
        <translation>Der Ordner hat kein Projekt {0}; er hat: {1}</translation>
    </message>
    <message>
        <source>The names of inputs and outputs that the configuration of the devices declares ({0} and so on) are in PLC_Configuration</source>
        <translation>Die Namen der Ein- und Ausgänge, die die Konfiguration der Geräte deklariert ({0} und weitere), stehen in PLC_Configuration</translation>
    </message>
    <message>
        <source>The file is not valid UTF-8 and specifies no other encoding; it was read as {0}. If letters are wrong, import it again with another encoding</source>
        <translation>Die Datei ist kein gültiges UTF-8 und gibt keine andere Codierung an; sie wurde als {0} gelesen. Sind Buchstaben falsch, importieren Sie sie mit einer anderen Codierung erneut</translation>
    </message>
    <message>
        <source>Macro step {0} was replaced by the steps inside it; steps whose names were already used are prefixed with {0}</source>
        <translation>Der Makroschritt {0} wurde durch seine Schritte ersetzt; Schritten mit bereits verwendetem Namen ist {0} vorangestellt</translation>
    </message>
    <message>
        <source>The program uses {0} of the library {1}, which reaches outside a simulated controller; declare POUs of these names that do what the simulation needs</source>
        <translation>Das Programm verwendet {0} der Bibliothek {1}, die über eine simulierte Steuerung hinausgreift; deklarieren Sie Bausteine dieser Namen, die das tun, was die Simulation braucht</translation>
    </message>
    <message>
        <source>Conditions in {0} are drawn with blocks; the action {1}, which runs in every scan from the initial step on, calls them</source>
        <translation>Bedingungen in {0} sind mit Bausteinen gezeichnet; die Aktion {1}, die vom Initialschritt an in jedem Zyklus läuft, ruft sie auf</translation>
    </message>
    <message>
        <source>The drawn body of {0} was not read; open the project in CODESYS V3 and export it there as PLCopen XML</source>
        <translation>Der gezeichnete Rumpf von {0} wurde nicht gelesen; öffnen Sie das Projekt in CODESYS V3 und exportieren Sie es dort als PLCopen XML</translation>
    </message>
    <message>
        <source>The drawn body of {0} was not read: the order of the inputs of {1} is not known. Import the file that declares {1} together with this one</source>
        <translation>Der gezeichnete Rumpf von {0} wurde nicht gelesen: Die Reihenfolge der Eingänge von {1} ist nicht bekannt. Importieren Sie die Datei, die {1} deklariert, zusammen mit dieser</translation>
    </message>
    <message>
        <source>The program uses {0}, which none of its files declares; the project uses the library {1}, which has it</source>
        <translation>Das Programm verwendet {0}, das keine seiner Dateien deklariert; das Projekt verwendet die Bibliothek {1}, die es enthält</translation>
    </message>
    <message>
        <source>The task {0} runs {1}, a program of a library; it was left out. Call what the machine needs of it from a program of the project</source>
        <translation>Die Task {0} führt {1} aus, ein Programm einer Bibliothek; es wurde ausgelassen. Rufen Sie das, was die Maschine davon braucht, aus einem Programm des Projekts auf</translation>
    </message>
    <message>
        <source>The variables of this extension are declared in {0}; its code in C or Python is not executed. Write to them in ST what the code does</source>
        <translation>Die Variablen dieser Erweiterung sind in {0} deklariert; ihr Code in C oder Python wird nicht ausgeführt. Schreiben Sie ihre Werte in ST so, wie es der Code tut</translation>
    </message>
    <message>
        <source>Version 0201 does not support the constructor arguments of {0}; they were left out</source>
        <translation>Version 0201 unterstützt die Konstruktorargumente von {0} nicht; sie wurden ausgelassen</translation>
    </message>
</context>
<context>
    <name>FigureText</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>An XY plot draws one channel against another: add a second channel to the trace.</source>
        <translation>Ein XY-Diagramm stellt einen Kanal über einem anderen dar: Fügen Sie dem Trace einen zweiten Kanal hinzu.</translation>
    </message>
    <message>
        <source>XY plot</source>
        <translation>XY-Diagramm</translation>
    </message>
    <message>
        <source>There are no samples in view: run the program or show another section.</source>
        <translation>Im sichtbaren Bereich gibt es keine Abtastwerte: Lassen Sie das Programm laufen oder blenden Sie einen anderen Bereich ein.</translation>
    </message>
    <message>
        <source>%L1 points over %2</source>
        <translation>%L1 Punkte über %2</translation>
    </message>
    <message>
        <source>A spectrum shows the frequencies of the visible channels: add a channel.</source>
        <translation>Im Spektrum werden die Frequenzen der sichtbaren Kanäle angezeigt: Fügen Sie einen Kanal hinzu.</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>Frequenz [Hz]</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>%1: no peak, RMS %2</source>
        <translation>%1: keine Spitze, Effektivwert %2</translation>
    </message>
    <message>
        <source>%1: %2, RMS %3</source>
        <translation>%1: %2, Effektivwert %3</translation>
    </message>
    <message>
        <source>A frequency response compares an output with an input: add both as channels, and choose the input.</source>
        <translation>Ein Frequenzgang vergleicht einen Ausgang mit einem Eingang: Fügen Sie beide als Kanäle hinzu und wählen Sie den Eingang.</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>gain [dB]</source>
        <translation>Verstärkung [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>Phase [°]</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>%1: %L2 of %L3 frequencies with a coherence above 0.8</source>
        <translation>%1: %L2 von %L3 Frequenzen mit einer Kohärenz über 0,8</translation>
    </message>
    <message>
        <source>Runs are overlaid at their triggers: enter a trigger in the properties of the trace.</source>
        <translation>Läufe werden an ihren Triggern übereinandergelegt: Geben Sie in den Eigenschaften des Trace einen Trigger ein.</translation>
    </message>
    <message>
        <source>The trigger has not fired in this recording yet.</source>
        <translation>Der Trigger hat in dieser Aufzeichnung noch nicht ausgelöst.</translation>
    </message>
    <message>
        <source>The runs of the visible channels are overlaid: add a channel.</source>
        <translation>Läufe der sichtbaren Kanäle werden übereinandergelegt: Fügen Sie einen Kanal hinzu.</translation>
    </message>
    <message>
        <source>Time since the trigger [s]</source>
        <translation>Zeit seit dem Trigger [s]</translation>
    </message>
    <message>
        <source>%1: runs differ most %2 after the trigger, by %3</source>
        <translation>%1: größte Abweichung der Läufe %2 nach dem Trigger, %3</translation>
    </message>
    <message>
        <source>Charts over Time Only</source>
        <translation>Nur Zeitdiagramme</translation>
    </message>
    <message>
        <source>XY Plot</source>
        <translation>XY-Diagramm</translation>
    </message>
    <message>
        <source>Frequency Response (Bode)</source>
        <translation>Frequenzgang (Bode)</translation>
    </message>
    <message>
        <source>Runs over Each Other</source>
        <translation>Läufe übereinander</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n Lauf</numerusform>
            <numerusform>%n Läufe</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Fixes</name>
    <message>
        <source>Replace with {0}</source>
        <translation>Durch {0} ersetzen</translation>
    </message>
    <message>
        <source>Insert {0}</source>
        <translation>{0} einfügen</translation>
    </message>
    <message>
        <source>Did you mean {0}?</source>
        <translation>Meinten Sie {0}?</translation>
    </message>
    <message>
        <source>Convert with {0}</source>
        <translation>Mit {0} konvertieren</translation>
    </message>
    <message>
        <source>Move {0} to {1}</source>
        <translation>{0} nach {1} verschieben</translation>
    </message>
    <message>
        <source>Add the property {0}</source>
        <translation>Eigenschaft {0} hinzufügen</translation>
    </message>
    <message>
        <source>Add the method {0}</source>
        <translation>Methode {0} hinzufügen</translation>
    </message>
    <message>
        <source>Add the missing branches</source>
        <translation>Fehlende Zweige hinzufügen</translation>
    </message>
    <message>
        <source>Add ELSE</source>
        <translation>ELSE hinzufügen</translation>
    </message>
    <message>
        <source>Add () to call it</source>
        <translation>Mit () aufrufen</translation>
    </message>
    <message>
        <source>Compare with 0</source>
        <translation>Mit 0 vergleichen</translation>
    </message>
    <message>
        <source>Remove the unused declaration</source>
        <translation>Nicht verwendete Deklaration entfernen</translation>
    </message>
    <message>
        <source>Replace with IF and ELSIF</source>
        <translation>Durch IF und ELSIF ersetzen</translation>
    </message>
    <message>
        <source>Change to a WSTRING literal</source>
        <translation>In ein WSTRING-Literal ändern</translation>
    </message>
    <message>
        <source>Replace with straight quotes</source>
        <translation>Durch gerade Anführungszeichen ersetzen</translation>
    </message>
    <message>
        <source>Make {0} the initial step</source>
        <translation>{0} zum Initialschritt machen</translation>
    </message>
    <message>
        <source>Dereference the pointer with ^</source>
        <translation>Zeiger mit ^ dereferenzieren</translation>
    </message>
</context>
<context>
    <name>Hmi</name>
    <message>
        <source>as it is</source>
        <translation>wie es ist</translation>
    </message>
    <message>
        <source>none</source>
        <translation>(keine Auswahl)</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Andere…</translation>
    </message>
    <message>
        <source>A variable that is written</source>
        <translation>Eine Variable, die geschrieben wird</translation>
    </message>
    <message>
        <source>An ST expression</source>
        <translation>Ein ST-Ausdruck</translation>
    </message>
    <message>
        <source>Shown to the operator. A typed text gets its key automatically; @key uses an existing one.</source>
        <translation>Wird dem Bediener angezeigt. Eingegebener Text erhält automatisch einen Schlüssel; @Schlüssel verwendet einen vorhandenen.</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.svg)</source>
        <translation>Bilder (*.png *.jpg *.svg)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unknown element</source>
        <translation>Unbekanntes Element</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Alarm class</source>
        <translation>Alarmklasse</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Linienbreite</translation>
    </message>
    <message>
        <source>Line style</source>
        <translation>Linienart</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>Fill level</source>
        <translation>Füllstand</translation>
    </message>
    <message>
        <source>Full at</source>
        <translation>Voll bei</translation>
    </message>
    <message>
        <source>Level colour</source>
        <translation>Farbe des Füllstands</translation>
    </message>
    <message>
        <source>Font size</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Text colour</source>
        <translation>Textfarbe</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Limit low-low</source>
        <translation>Unterster Grenzwert (LL)</translation>
    </message>
    <message>
        <source>Limit low</source>
        <translation>Unterer Grenzwert (L)</translation>
    </message>
    <message>
        <source>Limit high</source>
        <translation>Oberer Grenzwert (H)</translation>
    </message>
    <message>
        <source>Limit high-high</source>
        <translation>Oberster Grenzwert (HH)</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Auswahlmöglichkeiten</translation>
    </message>
    <message>
        <source>Text list</source>
        <translation>Textliste</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Priorität</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Values in texts</source>
        <translation>Werte in Texten</translation>
    </message>
    <message>
        <source>On delay in seconds</source>
        <translation>Einschaltverzögerung in Sekunden</translation>
    </message>
    <message>
        <source>Off delay in seconds</source>
        <translation>Ausschaltverzögerung in Sekunden</translation>
    </message>
    <message>
        <source>Must be acknowledged</source>
        <translation>Quittierpflichtig</translation>
    </message>
    <message>
        <source>Suppressed if</source>
        <translation>Unterdrückt, wenn</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Tab page</source>
        <translation>Registerkarte</translation>
    </message>
    <message>
        <source>Position and size</source>
        <translation>Position und Größe</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Visible if</source>
        <translation>Sichtbar, wenn</translation>
    </message>
    <message>
        <source>Enabled if</source>
        <translation>Bedienbar, wenn</translation>
    </message>
    <message>
        <source>Appearance by condition</source>
        <translation>Aussehen nach Bedingung</translation>
    </message>
    <message>
        <source>Move right by</source>
        <translation>Nach rechts um</translation>
    </message>
    <message>
        <source>Move down by</source>
        <translation>Nach unten um</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>Drehen um</translation>
    </message>
    <message>
        <source>Fixed language</source>
        <translation>Feste Sprache</translation>
    </message>
    <message>
        <source>If</source>
        <translation>Wenn</translation>
    </message>
    <message>
        <source>Blinks</source>
        <translation>Blinkt</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>Bedienbar</translation>
    </message>
    <message>
        <source>On if</source>
        <translation>Ein, wenn</translation>
    </message>
    <message>
        <source>Blinks if</source>
        <translation>Blinkt, wenn</translation>
    </message>
    <message>
        <source>Variable with [#] as index</source>
        <translation>Variable mit [#] als Index</translation>
    </message>
    <message>
        <source>Editable</source>
        <translation>Änderbar</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Polyline</source>
        <translation>Linienzug</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Rounded rectangle</source>
        <translation>Abgerundetes Rechteck</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygon</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Anfangswinkel</translation>
    </message>
    <message>
        <source>Span</source>
        <translation>Bogenwinkel</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Pipe</source>
        <translation>Rohr</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Flow (sign gives the direction)</source>
        <translation>Durchfluss (Vorzeichen gibt die Richtung)</translation>
    </message>
    <message>
        <source>Flow colour</source>
        <translation>Farbe des Durchflusses</translation>
    </message>
    <message>
        <source>Wraps</source>
        <translation>Zeilenumbruch</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Symbol</translation>
    </message>
    <message>
        <source>Running if</source>
        <translation>Läuft, wenn</translation>
    </message>
    <message>
        <source>Warning if</source>
        <translation>Warnung, wenn</translation>
    </message>
    <message>
        <source>Fault if</source>
        <translation>Störung, wenn</translation>
    </message>
    <message>
        <source>Colour off</source>
        <translation>Farbe (aus)</translation>
    </message>
    <message>
        <source>Colour running</source>
        <translation>Farbe (in Betrieb)</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Button</source>
        <translation>Schaltfläche</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Value to write</source>
        <translation>Zu schreibender Wert</translation>
    </message>
    <message>
        <source>Go to panel</source>
        <translation>Gehe zu Panel</translation>
    </message>
    <message>
        <source>Language tag</source>
        <translation>Sprachkürzel</translation>
    </message>
    <message>
        <source>Question to confirm</source>
        <translation>Rückfrage</translation>
    </message>
    <message>
        <source>Lit if</source>
        <translation>Leuchtet, wenn</translation>
    </message>
    <message>
        <source>Colour lit</source>
        <translation>Farbe (leuchtend)</translation>
    </message>
    <message>
        <source>Icon</source>
        <translation>Icon</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Schalter</translation>
    </message>
    <message>
        <source>Text on</source>
        <translation>Text (ein)</translation>
    </message>
    <message>
        <source>Text off</source>
        <translation>Text (aus)</translation>
    </message>
    <message>
        <source>Colour on</source>
        <translation>Farbe (ein)</translation>
    </message>
    <message>
        <source>Rotary selector</source>
        <translation>Wahlschalter</translation>
    </message>
    <message>
        <source>Check box</source>
        <translation>Kontrollkästchen</translation>
    </message>
    <message>
        <source>Radio group</source>
        <translation>Optionsgruppe</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Combo box</source>
        <translation>Kombinationsfeld</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>Schieberegler</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>Show the value</source>
        <translation>Wert anzeigen</translation>
    </message>
    <message>
        <source>Rotary knob</source>
        <translation>Drehknopf</translation>
    </message>
    <message>
        <source>Numeric entry</source>
        <translation>Zahleneingabe</translation>
    </message>
    <message>
        <source>Lowest value</source>
        <translation>Kleinster Wert</translation>
    </message>
    <message>
        <source>Highest value</source>
        <translation>Größter Wert</translation>
    </message>
    <message>
        <source>Title of the keypad</source>
        <translation>Titel des Ziffernblocks</translation>
    </message>
    <message>
        <source>Text entry</source>
        <translation>Texteingabe</translation>
    </message>
    <message>
        <source>Longest text</source>
        <translation>Längster Text</translation>
    </message>
    <message>
        <source>Masked entry</source>
        <translation>Maskeneingabe</translation>
    </message>
    <message>
        <source>Mask (# digit, A letter, * any)</source>
        <translation>Maske (# Ziffer, A Buchstabe, * beliebig)</translation>
    </message>
    <message>
        <source>Hide the value</source>
        <translation>Wert verbergen</translation>
    </message>
    <message>
        <source>Numeric display</source>
        <translation>Zahlenanzeige</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>Date and time</source>
        <translation>Datum und Uhrzeit</translation>
    </message>
    <message>
        <source>Value (empty: the controller&apos;s clock)</source>
        <translation>Wert (leer: Uhr der Steuerung)</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>Blinks when on</source>
        <translation>Blinkt im Ein-Zustand</translation>
    </message>
    <message>
        <source>Multi-state indicator</source>
        <translation>Mehrzustandsanzeige</translation>
    </message>
    <message>
        <source>States</source>
        <translation>Zustände</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>Balkenanzeige</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>Tank level</source>
        <translation>Behälterfüllstand</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>Zeigerinstrument</translation>
    </message>
    <message>
        <source>Span of the scale</source>
        <translation>Skalenwinkel</translation>
    </message>
    <message>
        <source>Divisions</source>
        <translation>Skalenteilung</translation>
    </message>
    <message>
        <source>7-segment display</source>
        <translation>7-Segment-Anzeige</translation>
    </message>
    <message>
        <source>Digits</source>
        <translation>Ziffern</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>Nachkommastellen</translation>
    </message>
    <message>
        <source>Leading zeros</source>
        <translation>Führende Nullen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Light tower</source>
        <translation>Signalsäule</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Leuchten</translation>
    </message>
    <message>
        <source>Siren if</source>
        <translation>Sirene, wenn</translation>
    </message>
    <message>
        <source>Float switch</source>
        <translation>Schwimmerschalter</translation>
    </message>
    <message>
        <source>Raised if</source>
        <translation>Angehoben, wenn</translation>
    </message>
    <message>
        <source>Colour raised</source>
        <translation>Farbe (angehoben)</translation>
    </message>
    <message>
        <source>Colour hanging</source>
        <translation>Farbe (hängend)</translation>
    </message>
    <message>
        <source>Cell grid</source>
        <translation>Zellenraster</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Array</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Variable of a cell with [#]</source>
        <translation>Variable einer Zelle mit [#]</translation>
    </message>
    <message>
        <source>On press</source>
        <translation>Beim Drücken</translation>
    </message>
    <message>
        <source>First index</source>
        <translation>Erster Index</translation>
    </message>
    <message>
        <source>Show the numbers</source>
        <translation>Nummern anzeigen</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Index of the selected row</source>
        <translation>Index der gewählten Zeile</translation>
    </message>
    <message>
        <source>Bar chart</source>
        <translation>Balkendiagramm</translation>
    </message>
    <message>
        <source>Text list of the bars</source>
        <translation>Textliste der Balken</translation>
    </message>
    <message>
        <source>XY chart</source>
        <translation>XY-Diagramm</translation>
    </message>
    <message>
        <source>Array of x</source>
        <translation>Array der x-Werte</translation>
    </message>
    <message>
        <source>Array of y</source>
        <translation>Array der y-Werte</translation>
    </message>
    <message>
        <source>Operating point x</source>
        <translation>Arbeitspunkt x</translation>
    </message>
    <message>
        <source>Operating point y</source>
        <translation>Arbeitspunkt y</translation>
    </message>
    <message>
        <source>X from</source>
        <translation>X von</translation>
    </message>
    <message>
        <source>X to</source>
        <translation>X bis</translation>
    </message>
    <message>
        <source>Y from</source>
        <translation>Y von</translation>
    </message>
    <message>
        <source>Y to</source>
        <translation>Y bis</translation>
    </message>
    <message>
        <source>Title of x</source>
        <translation>Titel der x-Achse</translation>
    </message>
    <message>
        <source>Title of y</source>
        <translation>Titel der y-Achse</translation>
    </message>
    <message>
        <source>Trend chart</source>
        <translation>Trenddiagramm</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Time span in seconds</source>
        <translation>Zeitspanne in Sekunden</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Alarm list</source>
        <translation>Alarmliste</translation>
    </message>
    <message>
        <source>Only these classes</source>
        <translation>Nur diese Klassen</translation>
    </message>
    <message>
        <source>Sorted by</source>
        <translation>Sortiert nach</translation>
    </message>
    <message>
        <source>Acknowledge buttons</source>
        <translation>Quittierschaltflächen</translation>
    </message>
    <message>
        <source>Alarm banner</source>
        <translation>Alarmbanner</translation>
    </message>
    <message>
        <source>Language selector</source>
        <translation>Sprachwahl</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Registerkarten</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Index of the page</source>
        <translation>Index der Seite</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Text and pictures</source>
        <translation>Text und Bilder</translation>
    </message>
    <message>
        <source>Symbols</source>
        <translation>Symbole</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Bedienelemente</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Anzeigeelemente</translation>
    </message>
    <message>
        <source>Arrays and charts</source>
        <translation>Arrays und Diagramme</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Containers</source>
        <translation>Container</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Type (a block, a structure, BOOL, REAL, text)</source>
        <translation>Typ (ein Baustein, eine Struktur, BOOL, REAL, text)</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Faceplate</source>
        <translation>Faceplate</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Argumente</translation>
    </message>
    <message>
        <source>Adapts to the screen by</source>
        <translation>Passt sich dem Bildschirm an durch</translation>
    </message>
    <message>
        <source>On a tall screen</source>
        <translation>Auf hohem Bildschirm</translation>
    </message>
    <message>
        <source>Shown in the frame</source>
        <translation>Im Rahmen angezeigt</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Panel to show</source>
        <translation>Anzuzeigendes Panel</translation>
    </message>
    <message>
        <source>First-out group</source>
        <translation>Erstmeldegruppe</translation>
    </message>
    <message>
        <source>Horizontal anchor</source>
        <translation>Anker waagrecht</translation>
    </message>
    <message>
        <source>Vertical anchor</source>
        <translation>Anker senkrecht</translation>
    </message>
    <message>
        <source>Only for the roles</source>
        <translation>Nur für die Rollen</translation>
    </message>
    <message>
        <source>For all others</source>
        <translation>Für alle anderen</translation>
    </message>
    <message>
        <source>Writes are confirmed</source>
        <translation>Schreiben wird bestätigt</translation>
    </message>
    <message>
        <source>Navigation bar</source>
        <translation>Navigationsleiste</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panels</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezeptur</translation>
    </message>
    <message>
        <source>Alarm statistics</source>
        <translation>Alarmstatistik</translation>
    </message>
    <message>
        <source>Hours to look back</source>
        <translation>Betrachtete Stunden</translation>
    </message>
    <message>
        <source>Panel area</source>
        <translation>Panelbereich</translation>
    </message>
    <message>
        <source>Share of the remaining space</source>
        <translation>Anteil am restlichen Platz</translation>
    </message>
    <message>
        <source>Column span in a grid</source>
        <translation>Spaltenanzahl im Raster</translation>
    </message>
    <message>
        <source>Closed if</source>
        <translation>Geschlossen, wenn</translation>
    </message>
    <message>
        <source>In transit if</source>
        <translation>In Bewegung, wenn</translation>
    </message>
    <message>
        <source>In manual mode if</source>
        <translation>Handbetrieb, wenn</translation>
    </message>
    <message>
        <source>Out of service if</source>
        <translation>Außer Betrieb, wenn</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Columns (0: as many as fit)</source>
        <translation>Spalten (0: so viele wie passen)</translation>
    </message>
    <message>
        <source>Smallest column</source>
        <translation>Kleinste Spaltenbreite</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Cross-axis alignment</source>
        <translation>Ausrichtung quer</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>alle</translation>
    </message>
</context>
<context>
    <name>HmiChoices</name>
    <message>
        <source>Dot</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Start sign</source>
        <translation>Startzeichen</translation>
    </message>
    <message>
        <source>Stop sign</source>
        <translation>Stoppzeichen</translation>
    </message>
    <message>
        <source>Pause sign</source>
        <translation>Pausezeichen</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>Pluszeichen</translation>
    </message>
    <message>
        <source>Minus</source>
        <translation>Minuszeichen</translation>
    </message>
    <message>
        <source>House</source>
        <translation>Haus</translation>
    </message>
    <message>
        <source>Circular arrow</source>
        <translation>Kreispfeil</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Uhrzeit</translation>
    </message>
    <message>
        <source>By time</source>
        <translation>Nach Zeit</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Durchgezogen</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Gestrichelt</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Gepunktet</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Am Anfang</translation>
    </message>
    <message>
        <source>Centred</source>
        <translation>Zentriert</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Am Ende</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Pfeil</translation>
    </message>
    <message>
        <source>Arc line</source>
        <translation>Bogenlinie</translation>
    </message>
    <message>
        <source>Pie</source>
        <translation>Kreisausschnitt</translation>
    </message>
    <message>
        <source>Chord</source>
        <translation>Kreisabschnitt</translation>
    </message>
    <message>
        <source>Show all of it</source>
        <translation>Ganz anzeigen</translation>
    </message>
    <message>
        <source>Fill the frame</source>
        <translation>Rahmen ausfüllen</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Strecken</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Momentary</source>
        <translation>Tastend</translation>
    </message>
    <message>
        <source>Toggle</source>
        <translation>Umschalten</translation>
    </message>
    <message>
        <source>Set to TRUE</source>
        <translation>Auf TRUE setzen</translation>
    </message>
    <message>
        <source>Set to FALSE</source>
        <translation>Auf FALSE setzen</translation>
    </message>
    <message>
        <source>Write a value</source>
        <translation>Wert schreiben</translation>
    </message>
    <message>
        <source>Go to a panel</source>
        <translation>Zu einem Panel gehen</translation>
    </message>
    <message>
        <source>Change the language</source>
        <translation>Sprache wechseln</translation>
    </message>
    <message>
        <source>Acknowledge alarms</source>
        <translation>Alarme quittieren</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Waagrecht</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>Date and time of day</source>
        <translation>Datum und Uhrzeit</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Calendar week</source>
        <translation>Kalenderwoche</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadratisch</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Abgerundet</translation>
    </message>
    <message>
        <source>Dished ends</source>
        <translation>Gewölbte Böden</translation>
    </message>
    <message>
        <source>Flat ends</source>
        <translation>Ebene Böden</translation>
    </message>
    <message>
        <source>Hopper</source>
        <translation>Trichter</translation>
    </message>
    <message>
        <source>Open at the top</source>
        <translation>Oben offen</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Present alarms</source>
        <translation>Anstehende Alarme</translation>
    </message>
    <message>
        <source>Alarm history</source>
        <translation>Alarmhistorie</translation>
    </message>
    <message>
        <source>By priority</source>
        <translation>Nach Priorität</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Schaltflächen</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>In their own language</source>
        <translation>In der eigenen Sprache</translation>
    </message>
    <message>
        <source>Language tags</source>
        <translation>Sprachkürzel</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Pump</source>
        <translation>Pumpe</translation>
    </message>
    <message>
        <source>Valve</source>
        <translation>Ventil</translation>
    </message>
    <message>
        <source>Tank</source>
        <translation>Behälter</translation>
    </message>
    <message>
        <source>Silo</source>
        <translation>Silo</translation>
    </message>
    <message>
        <source>Conveyor</source>
        <translation>Förderband</translation>
    </message>
    <message>
        <source>Agitator</source>
        <translation>Rührwerk</translation>
    </message>
    <message>
        <source>Heater</source>
        <translation>Heizung</translation>
    </message>
    <message>
        <source>Fan</source>
        <translation>Ventilator</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Siren</source>
        <translation>Sirene</translation>
    </message>
    <message>
        <source>Lorry</source>
        <translation>Lkw</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>Fahrzeug</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Raised surface</source>
        <translation>Erhabene Fläche</translation>
    </message>
    <message>
        <source>Sunken surface</source>
        <translation>Vertiefte Fläche</translation>
    </message>
    <message>
        <source>Line colour</source>
        <translation>Linienfarbe</translation>
    </message>
    <message>
        <source>Faint line</source>
        <translation>Schwache Linie</translation>
    </message>
    <message>
        <source>Text colour</source>
        <translation>Textfarbe</translation>
    </message>
    <message>
        <source>Muted text</source>
        <translation>Gedämpfter Text</translation>
    </message>
    <message>
        <source>Button colour</source>
        <translation>Farbe der Schaltfläche</translation>
    </message>
    <message>
        <source>Accent</source>
        <translation>Akzent</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Ausgeschaltet</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>In Betrieb</translation>
    </message>
    <message>
        <source>Liquid</source>
        <translation>Flüssigkeit</translation>
    </message>
    <message>
        <source>Pipe colour</source>
        <translation>Rohrfarbe</translation>
    </message>
    <message>
        <source>Measured value</source>
        <translation>Messwert</translation>
    </message>
    <message>
        <source>Lit segment</source>
        <translation>Leuchtendes Segment</translation>
    </message>
    <message>
        <source>Display glass</source>
        <translation>Anzeigeglas</translation>
    </message>
    <message>
        <source>Alarm colour</source>
        <translation>Alarmfarbe</translation>
    </message>
    <message>
        <source>High priority</source>
        <translation>Hohe Priorität</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Low priority</source>
        <translation>Niedrige Priorität</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Good state</source>
        <translation>Guter Zustand</translation>
    </message>
    <message>
        <source>Curve 1</source>
        <translation>Kurve 1</translation>
    </message>
    <message>
        <source>Curve 2</source>
        <translation>Kurve 2</translation>
    </message>
    <message>
        <source>Curve 3</source>
        <translation>Kurve 3</translation>
    </message>
    <message>
        <source>Curve 4</source>
        <translation>Kurve 4</translation>
    </message>
    <message>
        <source>Curve 5</source>
        <translation>Kurve 5</translation>
    </message>
    <message>
        <source>Curve 6</source>
        <translation>Kurve 6</translation>
    </message>
    <message>
        <source>Curve 7</source>
        <translation>Kurve 7</translation>
    </message>
    <message>
        <source>Curve 8</source>
        <translation>Kurve 8</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a BOOL</source>
        <translation>ein BOOL</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>ein Array</translation>
    </message>
    <message>
        <source>any type</source>
        <translation>beliebiger Typ</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Links und rechts</translation>
    </message>
    <message>
        <source>Top and bottom</source>
        <translation>Oben und unten</translation>
    </message>
    <message>
        <source>Scaling to its size</source>
        <translation>Skalieren auf seine Größe</translation>
    </message>
    <message>
        <source>Moving what is anchored</source>
        <translation>Verschieben der verankerten Elemente</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Seitenverhältnis behalten</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ausgeblendet</translation>
    </message>
    <message>
        <source>Open a panel in a window</source>
        <translation>Panel in einem Fenster öffnen</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Fenster schließen</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurückgehen</translation>
    </message>
    <message>
        <source>Go to the start panel</source>
        <translation>Zum Startpanel gehen</translation>
    </message>
    <message>
        <source>Log out</source>
        <translation>Abmelden</translation>
    </message>
    <message>
        <source>Shelved alarms</source>
        <translation>Zurückgestellte Alarme</translation>
    </message>
    <message>
        <source>Compressor</source>
        <translation>Verdichter</translation>
    </message>
    <message>
        <source>Heat exchanger</source>
        <translation>Wärmetauscher</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Centrifuge</source>
        <translation>Zentrifuge</translation>
    </message>
    <message>
        <source>Control valve</source>
        <translation>Regelventil</translation>
    </message>
    <message>
        <source>Three-way valve</source>
        <translation>Dreiwegeventil</translation>
    </message>
    <message>
        <source>Boiler</source>
        <translation>Kessel</translation>
    </message>
    <message>
        <source>Cooling tower</source>
        <translation>Kühlturm</translation>
    </message>
    <message>
        <source>Filler</source>
        <translation>Abfüllmaschine</translation>
    </message>
    <message>
        <source>Carton</source>
        <translation>Karton</translation>
    </message>
    <message>
        <source>Pallet</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>Roller conveyor</source>
        <translation>Rollenbahn</translation>
    </message>
    <message>
        <source>Bucket elevator</source>
        <translation>Becherwerk</translation>
    </message>
    <message>
        <source>Screw conveyor</source>
        <translation>Förderschnecke</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehtisch</translation>
    </message>
    <message>
        <source>Gantry</source>
        <translation>Portal</translation>
    </message>
    <message>
        <source>SCARA robot</source>
        <translation>SCARA-Roboter</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>Tür</translation>
    </message>
    <message>
        <source>Damper</source>
        <translation>Klappe</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Row if wide, column if tall</source>
        <translation>Zeile im Querformat, Spalte im Hochformat</translation>
    </message>
    <message>
        <source>Filling it</source>
        <translation>Ausfüllend</translation>
    </message>
    <message>
        <source>Change the theme</source>
        <translation>Farbschema wechseln</translation>
    </message>
    <message>
        <source>Light bulb</source>
        <translation>Glühbirne</translation>
    </message>
</context>
<context>
    <name>Inside</name>
    <message>
        <source>set by {0}  {1} ({2}, task {3})</source>
        <translation>gesetzt von {0}  {1} ({2}, Task {3})</translation>
    </message>
    <message>
        <source>set by {0}  {1} ({2})</source>
        <translation>gesetzt von {0}  {1} ({2})</translation>
    </message>
    <message>
        <source>set by code that the compiler adds ({0})</source>
        <translation>gesetzt von Code, den der Compiler ergänzt ({0})</translation>
    </message>
    <message>
        <source>written from outside</source>
        <translation>von außen geschrieben</translation>
    </message>
    <message>
        <source>written from {0}</source>
        <translation>geschrieben von: {0}</translation>
    </message>
    <message>
        <source>forced</source>
        <translation>geforct</translation>
    </message>
    <message>
        <source>forced from {0}</source>
        <translation>geforct von: {0}</translation>
    </message>
    <message>
        <source>put back by a reset</source>
        <translation>durch einen Reset zurückgesetzt</translation>
    </message>
    <message>
        <source>carried over by an online change</source>
        <translation>bei einem Online-Change übernommen</translation>
    </message>
    <message>
        <source>restored from the retained values</source>
        <translation>aus den remanenten Werten wiederhergestellt</translation>
    </message>
    <message>
        <source>its initial value</source>
        <translation>sein Initialwert</translation>
    </message>
    <message>
        <source>put into the safe state when the controller stopped</source>
        <translation>beim Anhalten der Steuerung in den sicheren Zustand gesetzt</translation>
    </message>
    <message>
        <source>as recorded in the scan that was resumed from</source>
        <translation>wie aufgezeichnet in dem Zyklus, ab dem fortgesetzt wurde</translation>
    </message>
    <message>
        <source>set by a statement of a test</source>
        <translation>von einer Anweisung eines Tests gesetzt</translation>
    </message>
    <message>
        <source>origin not known</source>
        <translation>Herkunft unbekannt</translation>
    </message>
    <message>
        <source>the command line</source>
        <translation>Befehlszeile</translation>
    </message>
    <message>
        <source>the studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>panel {0}, {1}</source>
        <translation>Panel {0}, {1}</translation>
    </message>
    <message>
        <source>{0} (scan {1})</source>
        <translation>{0} (Zyklus {1})</translation>
    </message>
    <message>
        <source>{0} µs</source>
        <translation>{0}&#xa0;µs</translation>
    </message>
    <message>
        <source>{0} s</source>
        <translation>{0}&#xa0;s</translation>
    </message>
    <message>
        <source>{0} min {1} s</source>
        <translation>{0}&#xa0;min {1}&#xa0;s</translation>
    </message>
    <message>
        <source>{0}  {1} from {2} to {3}, {4}</source>
        <translation>{0}  {1} von {2} auf {3}, {4}</translation>
    </message>
    <message>
        <source>{0}  {1} to {2}, {3}</source>
        <translation>{0}  {1} auf {2}, {3}</translation>
    </message>
    <message>
        <source>called by {0}  {1}</source>
        <translation>aufgerufen von {0}  {1}</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}, since {3}.</source>
        <translation>{0} ist bei {2} {1}, seit {3}.</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}, as it was when the recording began.</source>
        <translation>{0} ist bei {2} {1}, wie zu Beginn der Aufzeichnung.</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}.</source>
        <translation>{0} ist bei {2} {1}.</translation>
    </message>
    <message>
        <source>It was {0}.</source>
        <translation>Der Wert wurde {0}.</translation>
    </message>
    <message>
        <source>It has its initial value.</source>
        <translation>Die Variable hat ihren Initialwert.</translation>
    </message>
    <message>
        <source>It became {0} because</source>
        <translation>Sie wurde {0}, weil</translation>
    </message>
    <message>
        <source>This needed</source>
        <translation>Voraussetzung war</translation>
    </message>
    <message>
        <source>It needs</source>
        <translation>Voraussetzung ist</translation>
    </message>
    <message>
        <source>It stays so because</source>
        <translation>Sie bleibt so, weil</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Schritt für Schritt</translation>
    </message>
    <message>
        <source>because</source>
        <translation>weil</translation>
    </message>
    <message>
        <source>time passed.</source>
        <translation>Zeit vergangen ist.</translation>
    </message>
    <message>
        <source>it was the first scan.</source>
        <translation>es der erste Zyklus war.</translation>
    </message>
    <message>
        <source>other variables were forced.</source>
        <translation>andere Variablen geforct waren.</translation>
    </message>
    <message>
        <source>{0} became {1}.</source>
        <translation>{0} wurde {1}.</translation>
    </message>
    <message>
        <source>{0} became {1}, {2}.</source>
        <translation>{0} wurde {1}, {2}.</translation>
    </message>
    <message>
        <source>{0} changed.</source>
        <translation>{0} hat sich geändert.</translation>
    </message>
    <message>
        <source>{0} changed, {1}.</source>
        <translation>{0} hat sich geändert, {1}.</translation>
    </message>
    <message>
        <source>{0} was {1}.</source>
        <translation>{0} war {1}.</translation>
    </message>
    <message>
        <source>{0} was {1} since {2}, {3}.</source>
        <translation>{0} war {1} seit {2}, {3}.</translation>
    </message>
    <message>
        <source>{0}   → {1}</source>
        <translation>{0}   → {1}</translation>
    </message>
    <message>
        <source>it ran because {0} was {1}</source>
        <translation>ausgeführt, weil {0} {1} war</translation>
    </message>
    <message>
        <source>nothing wrote it later because {0} was {1}</source>
        <translation>danach nicht mehr geschrieben, weil {0} {1} war</translation>
    </message>
    <message>
        <source>a statement that would write it did not run because {0} was {1}</source>
        <translation>eine Anweisung, die den Wert schreiben würde, wurde nicht ausgeführt, weil {0} {1} war</translation>
    </message>
    <message>
        <source>{0} ({1})</source>
        <translation>{0} ({1})</translation>
    </message>
    <message>
        <source>{0}</source>
        <translation>{0}</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}: {1}</translation>
    </message>
    <message>
        <source>{0} was {1} when the scan began</source>
        <translation>{0} war {1}, als der Zyklus begann</translation>
    </message>
    <message>
        <source>{0}   {1}</source>
        <translation>{0}   {1}</translation>
    </message>
    <message>
        <source>its time of {0} has elapsed</source>
        <translation>die Zeit von {0} ist abgelaufen</translation>
    </message>
    <message>
        <source>it does not run</source>
        <translation>läuft nicht</translation>
    </message>
    <message>
        <source>it has run {0} of {1}, {2} to go</source>
        <translation>{0} von {1} sind abgelaufen, {2} fehlen noch</translation>
    </message>
    <message>
        <source>it has counted {0} of {1}</source>
        <translation>hat {0} von {1} gezählt</translation>
    </message>
    <message>
        <source>No change of up to three variables makes it {0} in this scan.</source>
        <translation>Keine Änderung von bis zu drei Variablen macht sie in diesem Zyklus {0}.</translation>
    </message>
    <message>
        <source>It would be {0} if {1}.</source>
        <translation>Sie wäre {0}, wenn {1}.</translation>
    </message>
    <message>
        <source>It would also be {0} if {1}.</source>
        <translation>Sie wäre auch {0}, wenn {1}.</translation>
    </message>
    <message>
        <source>{0} were {1} (it is {2})</source>
        <translation>{0} {1} wäre (ist {2})</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} und {1}</translation>
    </message>
    <message>
        <source>What keeps it {0}</source>
        <translation>Was sie auf {0} hält</translation>
    </message>
    <message>
        <source>Note: {0}.</source>
        <translation>Hinweis: {0}.</translation>
    </message>
    <message>
        <source>recorded by an earlier version, which kept no journal</source>
        <translation>von einer älteren Version aufgezeichnet, die kein Journal führte</translation>
    </message>
    <message>
        <source>it was written to while it was halted at a breakpoint</source>
        <translation>während des Halts an einem Haltepunkt wurde geschrieben</translation>
    </message>
    <message>
        <source>the scan did more than can be kept: only its beginning is known</source>
        <translation>der Zyklus tat mehr, als aufbewahrt werden kann: nur sein Anfang ist bekannt</translation>
    </message>
    <message>
        <source>the scan had a different result when it was run again</source>
        <translation>der Zyklus hatte bei der Wiederholung ein anderes Ergebnis</translation>
    </message>
    <message>
        <source>it has no value in this scan: {0}</source>
        <translation>kein Wert in diesem Zyklus: {0}</translation>
    </message>
    <message>
        <source>&quot;Why not?&quot; needs a condition (BOOL), for example &quot;Main.level &gt; 80&quot;</source>
        <translation>„Warum nicht?“ braucht eine Bedingung (BOOL), zum Beispiel „Main.level &gt; 80“</translation>
    </message>
    <message>
        <source>the program was not built from sources; open its project</source>
        <translation>das Programm wurde nicht aus Quelltexten übersetzt; öffnen Sie sein Projekt</translation>
    </message>
    <message>
        <source>this scan is not in the recording</source>
        <translation>dieser Zyklus ist nicht in der Aufzeichnung</translation>
    </message>
    <message>
        <source>it does not change in this recording</source>
        <translation>ändert sich in dieser Aufzeichnung nicht</translation>
    </message>
    <message>
        <source>nothing wrote it in this scan</source>
        <translation>in diesem Zyklus nicht geschrieben</translation>
    </message>
    <message>
        <source>no statement of the project ran in this scan</source>
        <translation>keine Anweisung des Projekts wurde in diesem Zyklus ausgeführt</translation>
    </message>
    <message>
        <source>never {0}</source>
        <translation>nie {0}</translation>
    </message>
    <message>
        <source>missing: {0}</source>
        <translation>fehlt: {0}</translation>
    </message>
    <message>
        <source>not run</source>
        <translation>nicht ausgeführt</translation>
    </message>
    <message>
        <source>run {0} {0:time|times}</source>
        <translation>{0}-mal ausgeführt</translation>
    </message>
</context>
<context>
    <name>LongTask</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>Loops</name>
    <message>
        <source>The program has no controller block; name the signals with --input and --output</source>
        <translation>Das Programm hat keinen Reglerbaustein; geben Sie die Signale mit --input und --output an</translation>
    </message>
    <message>
        <source>There is no loop {0}; the program has {1}</source>
        <translation>Es gibt keinen Regelkreis {0}; das Programm hat {1}</translation>
    </message>
    <message>
        <source>{0} is the name of several loops; give the whole name of one: {1}</source>
        <translation>{0} heißen mehrere Regelkreise; geben Sie den vollen Namen eines von ihnen an: {1}</translation>
    </message>
    <message>
        <source>The recording contains no program that knows it; choose a loop of the open program</source>
        <translation>Die Aufzeichnung enthält kein Programm, das sie kennt; wählen Sie einen Regelkreis des geöffneten Programms</translation>
    </message>
    <message>
        <source>It is not a number and cannot be a signal of a loop; name a variable of type REAL or INT</source>
        <translation>Das ist keine Zahl und kann kein Signal eines Regelkreises sein; geben Sie eine Variable vom Typ REAL oder INT an</translation>
    </message>
    <message>
        <source>This range is no longer recorded, or the program was changed in it; choose another one</source>
        <translation>Dieser Bereich ist nicht mehr aufgezeichnet, oder das Programm wurde darin geändert; wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>{0} gets an expression in the call; give the measured value a variable of its own to try settings</source>
        <translation>{0} erhält im Aufruf einen Ausdruck; geben Sie dem Messwert eine eigene Variable, um Einstellungen zu erproben</translation>
    </message>
    <message>
        <source>The call has constants; settings in their place can only be tried on the recording of the running controller</source>
        <translation>Der Aufruf enthält Konstanten; andere Einstellungen an ihrer Stelle lassen sich nur an der Aufzeichnung der laufenden Steuerung erproben</translation>
    </message>
</context>
<context>
    <name>MarkText</name>
    <message>
        <source>Started</source>
        <translation>Gestartet</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurückgesetzt</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>Forced</source>
        <translation>Geforct</translation>
    </message>
    <message>
        <source>All forces released</source>
        <translation>Forcen für alle Werte aufgehoben</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Forcen aufgehoben</translation>
    </message>
    <message>
        <source>Online change</source>
        <translation>Online-Change</translation>
    </message>
    <message>
        <source>Breakpoint</source>
        <translation>Haltepunkt</translation>
    </message>
    <message>
        <source>Retained values saved</source>
        <translation>Remanente Werte gespeichert</translation>
    </message>
    <message>
        <source>Retained values restored</source>
        <translation>Remanente Werte wiederhergestellt</translation>
    </message>
    <message numerus="yes">
        <source>%n scan(s) skipped: the machine was late</source>
        <translation>
            <numerusform>%n Zyklus ausgelassen: Der Rechner war zu spät</numerusform>
            <numerusform>%n Zyklen ausgelassen: Der Rechner war zu spät</numerusform>
        </translation>
    </message>
    <message>
        <source>Resumed from this scan</source>
        <translation>Ab diesem Zyklus fortgesetzt</translation>
    </message>
</context>
<context>
    <name>Notes</name>
    <message>
        <source>first declared here</source>
        <translation>zuerst hier deklariert</translation>
    </message>
    <message>
        <source>declared here</source>
        <translation>hier deklariert</translation>
    </message>
    <message>
        <source>the variable</source>
        <translation>die Variable</translation>
    </message>
    <message>
        <source>the first program</source>
        <translation>das erste Programm</translation>
    </message>
    <message>
        <source>overridden here</source>
        <translation>hier überschrieben</translation>
    </message>
    <message>
        <source>the first one</source>
        <translation>der erste</translation>
    </message>
    <message>
        <source>by this transition, while it is active</source>
        <translation>durch diese Transition, während er aktiv ist</translation>
    </message>
    <message>
        <source>comments nest: the next *) closes the one that begins here</source>
        <translation>Kommentare sind verschachtelt: Das nächste *) schließt den, der hier beginnt</translation>
    </message>
</context>
<context>
    <name>Phrases</name>
    <message>
        <source>a name</source>
        <translation>ein Name</translation>
    </message>
    <message>
        <source>a label</source>
        <translation>eine Sprungmarke</translation>
    </message>
    <message>
        <source>an operand</source>
        <translation>ein Operand</translation>
    </message>
    <message>
        <source>an expression</source>
        <translation>ein Ausdruck</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>ein Wert</translation>
    </message>
    <message>
        <source>a type</source>
        <translation>ein Typ</translation>
    </message>
    <message>
        <source>an index</source>
        <translation>ein Index</translation>
    </message>
    <message>
        <source>an argument</source>
        <translation>ein Argument</translation>
    </message>
    <message>
        <source>an address</source>
        <translation>eine Adresse</translation>
    </message>
    <message>
        <source>an action</source>
        <translation>eine Aktion</translation>
    </message>
    <message>
        <source>a CASE label</source>
        <translation>eine CASE-Marke</translation>
    </message>
    <message>
        <source>a block&apos;s name</source>
        <translation>der Name eines Funktionsbausteins</translation>
    </message>
    <message>
        <source>a processor&apos;s name</source>
        <translation>der Name eines Prozessors</translation>
    </message>
    <message>
        <source>a task&apos;s name</source>
        <translation>der Name einer Task</translation>
    </message>
    <message>
        <source>a program instance&apos;s name</source>
        <translation>der Name einer Programminstanz</translation>
    </message>
    <message>
        <source>an input or output</source>
        <translation>ein Ein- oder Ausgang</translation>
    </message>
    <message>
        <source>a variable&apos;s name</source>
        <translation>der Name einer Variablen</translation>
    </message>
    <message>
        <source>a variable&apos;s path</source>
        <translation>der Pfad einer Variablen</translation>
    </message>
    <message>
        <source>a step&apos;s name</source>
        <translation>der Name eines Schritts</translation>
    </message>
    <message>
        <source>a type&apos;s name</source>
        <translation>der Name eines Typs</translation>
    </message>
    <message>
        <source>a member&apos;s name</source>
        <translation>der Name eines Elements</translation>
    </message>
    <message>
        <source>an access name</source>
        <translation>ein Zugriffsname</translation>
    </message>
    <message>
        <source>an enumeration value</source>
        <translation>ein Enumerationswert</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>Zeilenende</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>Dateiende</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} oder {1}</translation>
    </message>
    <message>
        <source>FOR and a time</source>
        <translation>FOR und eine Zeit</translation>
    </message>
    <message>
        <source>:= or instructions</source>
        <translation>:= oder Anweisungen</translation>
    </message>
    <message>
        <source>a subrange</source>
        <translation>ein Unterbereich</translation>
    </message>
    <message>
        <source>an enumeration</source>
        <translation>eine Enumeration</translation>
    </message>
    <message>
        <source>in parentheses</source>
        <translation>in Klammern</translation>
    </message>
    <message>
        <source>a chart</source>
        <translation>eine Schrittkette</translation>
    </message>
    <message>
        <source>a body</source>
        <translation>ein Rumpf</translation>
    </message>
    <message>
        <source>in a CLASS</source>
        <translation>in einer CLASS</translation>
    </message>
    <message>
        <source>in a FUNCTION</source>
        <translation>in einer FUNCTION</translation>
    </message>
    <message>
        <source>in a METHOD</source>
        <translation>in einer METHOD</translation>
    </message>
    <message>
        <source>in a PROGRAM</source>
        <translation>in einem PROGRAM</translation>
    </message>
    <message>
        <source>in a FUNCTION_BLOCK</source>
        <translation>in einem FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>here</source>
        <translation>hier</translation>
    </message>
    <message>
        <source>{0} {0:character|characters}</source>
        <translation>{0} Zeichen</translation>
    </message>
    <message>
        <source>{0} {0:byte|bytes} in UTF-8</source>
        <translation>{0} {0:Byte|Bytes} in UTF-8</translation>
    </message>
    <message>
        <source>in {0}</source>
        <translation>in {0}</translation>
    </message>
    <message>
        <source>in an expression</source>
        <translation>in einem Ausdruck</translation>
    </message>
    <message>
        <source>in an initial value</source>
        <translation>in einem Initialwert</translation>
    </message>
    <message>
        <source>in this section</source>
        <translation>in diesem Abschnitt</translation>
    </message>
    <message>
        <source>an initial value</source>
        <translation>ein Initialwert</translation>
    </message>
    <message>
        <source>RETURN with a value</source>
        <translation>RETURN mit einem Wert</translation>
    </message>
    <message>
        <source>in a declaration that calls FB_Init</source>
        <translation>in einer Deklaration, die FB_Init aufruft</translation>
    </message>
    <message>
        <source>{0} (VAR_IN_OUT)</source>
        <translation>{0} (VAR_IN_OUT)</translation>
    </message>
    <message>
        <source>in {0}, which is not abstract itself</source>
        <translation>in {0}, das selbst nicht abstrakt ist</translation>
    </message>
    <message>
        <source>address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>Zeitdauer</translation>
    </message>
    <message>
        <source>date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>time of day</source>
        <translation>Tageszeit</translation>
    </message>
    <message>
        <source>date and time</source>
        <translation>Datum und Uhrzeit</translation>
    </message>
    <message>
        <source>integer</source>
        <translation>Ganzzahl</translation>
    </message>
    <message>
        <source>string</source>
        <translation>Zeichenkette</translation>
    </message>
    <message>
        <source>{0} (a constant)</source>
        <translation>{0} (eine Konstante)</translation>
    </message>
    <message>
        <source>{0} (an output)</source>
        <translation>{0} (ein Ausgang)</translation>
    </message>
    <message>
        <source>{0} (a local variable of {1})</source>
        <translation>{0} (eine lokale Variable von {1})</translation>
    </message>
    <message>
        <source>{0} (an input)</source>
        <translation>{0} (ein Eingang)</translation>
    </message>
    <message>
        <source>{0} (an input; the next scan overwrites it)</source>
        <translation>{0} (ein Eingang; der nächste Zyklus überschreibt ihn)</translation>
    </message>
    <message>
        <source>{0} (a property without SET)</source>
        <translation>{0} (eine Eigenschaft ohne SET)</translation>
    </message>
    <message>
        <source>{0} (no instance, or several)</source>
        <translation>{0} (keine Instanz oder mehrere)</translation>
    </message>
    <message>
        <source>{0} (a type; declare an instance of it)</source>
        <translation>{0} (ein Typ; eine Instanz davon deklarieren)</translation>
    </message>
    <message>
        <source>{0} (a variable, which hides the function of this name)</source>
        <translation>{0} (eine Variable, die die Funktion dieses Namens verdeckt)</translation>
    </message>
    <message>
        <source>an output</source>
        <translation>ein Ausgang</translation>
    </message>
    <message>
        <source>an input</source>
        <translation>ein Eingang</translation>
    </message>
    <message>
        <source>an IN_OUT parameter</source>
        <translation>ein IN_OUT-Parameter</translation>
    </message>
    <message>
        <source>a power of a computed number</source>
        <translation>eine Potenz einer berechneten Zahl</translation>
    </message>
    <message>
        <source>a call of {0}</source>
        <translation>ein Aufruf von {0}</translation>
    </message>
    <message>
        <source>a call without arguments</source>
        <translation>ein Aufruf ohne Argumente</translation>
    </message>
    <message>
        <source>a computed second argument of {0}</source>
        <translation>ein berechnetes zweites Argument von {0}</translation>
    </message>
    <message>
        <source>{0} outside a loop</source>
        <translation>{0} außerhalb einer Schleife</translation>
    </message>
    <message>
        <source>this statement</source>
        <translation>diese Anweisung</translation>
    </message>
    <message>
        <source>FOR with this end or step</source>
        <translation>FOR mit diesem Ende oder dieser Schrittweite</translation>
    </message>
    <message>
        <source>an assignment of several variables</source>
        <translation>eine Zuweisung mehrerer Variablen</translation>
    </message>
    <message>
        <source>CASE of a computed value</source>
        <translation>CASE eines berechneten Werts</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a number of seconds</source>
        <translation>eine Anzahl Sekunden</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>one of {0}</source>
        <translation>eines von {0}</translation>
    </message>
</context>
<context>
    <name>PlotText</name>
    <message>
        <source>no longer kept</source>
        <translation>nicht mehr vorhanden</translation>
    </message>
    <message>
        <source>did not exist</source>
        <translation>gab es nicht</translation>
    </message>
    <message>
        <source>scans skipped</source>
        <translation>Zyklen ausgelassen</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>Time [%1]</source>
        <translation>Zeit [%1]</translation>
    </message>
    <message>
        <source>Time from the trigger [%1]</source>
        <translation>Zeit ab Trigger [%1]</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>At A</source>
        <translation>Bei A</translation>
    </message>
    <message>
        <source>At B</source>
        <translation>Bei B</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Effektivwert</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>Anstiegszeit</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Ausregelzeit</translation>
    </message>
</context>
<context>
    <name>Remote</name>
    <message>
        <source>The request is not understood; studio and controller may be of different versions</source>
        <translation>Die Anfrage wird nicht verstanden; Studio und Steuerung haben eventuell unterschiedliche Versionen</translation>
    </message>
    <message>
        <source>There is no request {0}; studio and controller may be of different versions</source>
        <translation>Es gibt keine Anfrage {0}; Studio und Steuerung haben eventuell unterschiedliche Versionen</translation>
    </message>
    <message>
        <source>Breakpoints stop a machine in the middle of a scan; `stepwise serve` allows them with --allow-breakpoints</source>
        <translation>Haltepunkte halten eine Maschine mitten im Zyklus an; „stepwise serve“ erlaubt sie mit --allow-breakpoints</translation>
    </message>
    <message>
        <source>{0} is forced; release it before writing</source>
        <translation>{0} ist geforct; heben Sie das Forcen vor dem Schreiben auf</translation>
    </message>
    <message>
        <source>{0} is not forced; there is nothing to release</source>
        <translation>{0} ist nicht geforct; es gibt kein Forcen aufzuheben</translation>
    </message>
    <message>
        <source>Another program is being built for this controller; try again when it is loaded</source>
        <translation>Für diese Steuerung wird gerade ein anderes Programm übersetzt; versuchen Sie es erneut, wenn es geladen ist</translation>
    </message>
    <message>
        <source>The program has {0} {0:error|errors}; correct them: the controller continues with the old program until then</source>
        <translation>Das Programm hat {0} Fehler; beheben Sie sie: Bis dahin läuft die Steuerung mit dem alten weiter</translation>
    </message>
    <message>
        <source>The controller&apos;s program has no file {0}; load its program again</source>
        <translation>Das Programm der Steuerung hat keine Datei {0}; laden Sie das Programm erneut</translation>
    </message>
    <message>
        <source>A recording is already being downloaded; wait until it is complete</source>
        <translation>Es wird bereits eine Aufzeichnung heruntergeladen; warten Sie, bis sie vollständig ist</translation>
    </message>
    <message>
        <source>A served controller cannot be resumed from an earlier scan; download its recording and resume from there</source>
        <translation>Eine als Dienst laufende Steuerung kann nicht ab einem früheren Zyklus fortgesetzt werden; laden Sie ihre Aufzeichnung herunter und setzen Sie dort fort</translation>
    </message>
    <message>
        <source>{0} is not the address of a controller; write for example https://plant:8443/</source>
        <translation>{0} ist nicht die Adresse einer Steuerung; schreiben Sie zum Beispiel https://plant:8443/</translation>
    </message>
    <message>
        <source>{0} rejects the connection: {1}</source>
        <translation>{0} lehnt die Verbindung ab: {1}</translation>
    </message>
    <message>
        <source>The code is wrong; it is in the file attach-code of the controller&apos;s state folder</source>
        <translation>Der Code ist falsch; er steht in der Datei attach-code im Zustandsordner der Steuerung</translation>
    </message>
    <message>
        <source>There were too many wrong codes from this computer; wait a minute</source>
        <translation>Von diesem Rechner kamen zu viele falsche Codes; warten Sie eine Minute</translation>
    </message>
    <message>
        <source>The code would be sent over the network unencrypted; use an https address, and start the controller with --certificate</source>
        <translation>Der Code würde unverschlüsselt über das Netzwerk gesendet; verwenden Sie eine https-Adresse und starten Sie die Steuerung mit --certificate</translation>
    </message>
    <message>
        <source>The certificate of {0} is not trusted: {1}; name the file of the certificate that you trust</source>
        <translation>Dem Zertifikat von {0} wird nicht vertraut: {1}; geben Sie die Datei des Zertifikats an, dem Sie vertrauen</translation>
    </message>
    <message>
        <source>The certificate cannot be read from {0}; it must be a PEM file</source>
        <translation>Das Zertifikat kann nicht aus {0} gelesen werden; es muss eine PEM-Datei sein</translation>
    </message>
    <message>
        <source>The connection to {0} is lost; check the network and the controller</source>
        <translation>Die Verbindung zu {0} ist unterbrochen; prüfen Sie das Netzwerk und die Steuerung</translation>
    </message>
    <message>
        <source>{0} does not answer; check the address and whether the controller runs</source>
        <translation>{0} antwortet nicht; prüfen Sie die Adresse und ob die Steuerung läuft</translation>
    </message>
    <message>
        <source>The controller&apos;s program cannot be built here as it is there; use the same version of Stepwise on both sides</source>
        <translation>Das Programm der Steuerung lässt sich hier nicht so übersetzen wie dort; verwenden Sie auf beiden Seiten dieselbe Version von Stepwise</translation>
    </message>
    <message>
        <source>{0} speaks TLS on this port; use the address {1}</source>
        <translation>{0} verwendet an diesem Port TLS; geben Sie die Adresse {1} ein</translation>
    </message>
    <message>
        <source>{0} cannot be reached: {1}; check the address and the network</source>
        <translation>{0} ist nicht erreichbar: {1}; prüfen Sie die Adresse und das Netz</translation>
    </message>
    <message>
        <source>Nothing answers at {0}; check the port, and whether `stepwise serve` runs there</source>
        <translation>Unter {0} antwortet nichts; prüfen Sie den Port und ob „stepwise serve“ dort läuft</translation>
    </message>
    <message>
        <source>There is no computer named {0}; check the name in the address</source>
        <translation>Es gibt keinen Rechner namens {0}; prüfen Sie den Namen in der Adresse</translation>
    </message>
    <message>
        <source>The server at {0} is not a controller started with `stepwise serve`; check the host and the port</source>
        <translation>Der Server unter {0} ist keine mit „stepwise serve“ gestartete Steuerung; prüfen Sie Rechner und Port</translation>
    </message>
    <message>
        <source>The server at {0} does not speak TLS; start the controller with --certificate, or use an http address on the same computer</source>
        <translation>Der Server unter {0} spricht kein TLS; starten Sie die Steuerung mit --certificate oder verwenden Sie auf demselben Rechner eine http-Adresse</translation>
    </message>
</context>
<context>
    <name>Storage</name>
    <message>
        <source>{0} does not have the character {1}; write the file as UTF-8</source>
        <translation>{0} enthält das Zeichen {1} nicht; schreiben Sie die Datei als UTF-8</translation>
    </message>
    <message>
        <source>The encoding {0} is not known; choose one of {1}</source>
        <translation>Die Codierung {0} ist nicht bekannt; wählen Sie eine von {1}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a list of names; write them in quotes, in square brackets</source>
        <translation>„{0}“ muss eine Liste von Namen sein; schreiben Sie sie in Anführungszeichen, in eckigen Klammern</translation>
    </message>
</context>
<context>
    <name>TraceText</name>
    <message>
        <source>Triggered at %1.</source>
        <translation>Ausgelöst bei %1.</translation>
    </message>
    <message>
        <source>The trigger did not fire.</source>
        <translation>Der Trigger hat nicht ausgelöst.</translation>
    </message>
</context>
<context>
    <name>Tuning</name>
    <message>
        <source>{0} {0:sample is|samples are} too few for a model; record for longer</source>
        <translation>{0} {0:Messwert ist|Messwerte sind} zu wenig für ein Modell; zeichnen Sie länger auf</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>brauchbar</translation>
    </message>
    <message>
        <source>the input is at a limit for {0} % of the time</source>
        <translation>der Eingang ist während {0}&#xa0;% der Zeit an einer Grenze</translation>
    </message>
    <message>
        <source>the output moves by only {0} times its noise</source>
        <translation>der Ausgang bewegt sich nur um das {0}-Fache seines Rauschens</translation>
    </message>
    <message>
        <source>too short: {0} {0:sample|samples} until the next change or the end</source>
        <translation>zu kurz: {0} {0:Messwert|Messwerte} bis zur nächsten Änderung oder zum Ende</translation>
    </message>
    <message>
        <source>disturbed: no model explains more than {0} % of it</source>
        <translation>gestört: kein Modell erklärt mehr als {0}&#xa0;% davon</translation>
    </message>
    <message>
        <source>usable; not at rest before it</source>
        <translation>brauchbar; davor nicht in Ruhe</translation>
    </message>
    <message>
        <source>There is no step or disturbance in the recording; change the set point or the output once and record the response</source>
        <translation>In der Aufzeichnung ist kein Sprung und keine Störung; ändern Sie einmal den Sollwert oder den Ausgang und zeichnen Sie die Antwort auf</translation>
    </message>
    <message>
        <source>None of the {0} changes found is usable: {1}</source>
        <translation>Keine der {0} gefundenen Änderungen ist brauchbar: {1}</translation>
    </message>
    <message>
        <source>No model explains the output; something else affects it</source>
        <translation>Kein Modell erklärt den Verlauf des Ausgangs; etwas anderes beeinflusst ihn</translation>
    </message>
    <message>
        <source>The rule {0} does not apply to this process; choose another one</source>
        <translation>Die Regel {0} ist für diese Strecke nicht anwendbar; wählen Sie eine andere</translation>
    </message>
    <message>
        <source>Unstable: the oscillation would grow. Do not use these settings.</source>
        <translation>Instabil: Die Schwingung würde zunehmen. Diese Einstellungen nicht verwenden.</translation>
    </message>
    <message>
        <source>Fragile: a small change of the process makes it oscillate.</source>
        <translation>Empfindlich: Schon eine kleine Änderung der Strecke bringt den Regelkreis zum Schwingen.</translation>
    </message>
    <message>
        <source>Brisk: fast, with slight oscillation; the process should not change much.</source>
        <translation>Zügig: schnell, mit leichtem Schwingen; die Strecke sollte sich nicht stark ändern.</translation>
    </message>
    <message>
        <source>Good: fast enough, and tolerant of the usual process changes.</source>
        <translation>Gut: schnell genug, verträgt die üblichen Änderungen der Strecke.</translation>
    </message>
    <message>
        <source>Calm: slow, and tolerant of large process changes.</source>
        <translation>Ruhig: langsam, verträgt auch starke Änderungen der Strecke.</translation>
    </message>
    <message>
        <source>A step of the set point does not overshoot.</source>
        <translation>Ein Sprung des Sollwerts führt zu keinem Überschwingen.</translation>
    </message>
    <message>
        <source>A step of the set point overshoots by {0} %.</source>
        <translation>Ein Sprung des Sollwerts führt zu {0}&#xa0;% Überschwingen.</translation>
    </message>
    <message>
        <source>Ziegler-Nichols is included for comparison: it oscillates and tolerates little change. Use SIMC or the optimum instead.</source>
        <translation>Ziegler-Nichols dient hier zum Vergleich: Es schwingt und verträgt wenig Änderung. Verwenden Sie stattdessen SIMC oder das Optimum.</translation>
    </message>
    <message>
        <source>The rule considers only one lag; check the margins.</source>
        <translation>Die Regel berücksichtigt nur ein Verzögerungsglied; prüfen Sie die Reserven.</translation>
    </message>
    <message>
        <source>gain and dead time</source>
        <translation>Verstärkung und Totzeit</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>1. Ordnung</translation>
    </message>
    <message>
        <source>first order with dead time</source>
        <translation>1. Ordnung mit Totzeit</translation>
    </message>
    <message>
        <source>second order</source>
        <translation>2. Ordnung</translation>
    </message>
    <message>
        <source>second order with dead time</source>
        <translation>2. Ordnung mit Totzeit</translation>
    </message>
    <message>
        <source>two equal lags</source>
        <translation>zwei gleiche Verzögerungsglieder</translation>
    </message>
    <message>
        <source>two equal lags with dead time</source>
        <translation>zwei gleiche Verzögerungsglieder mit Totzeit</translation>
    </message>
    <message>
        <source>oscillating</source>
        <translation>schwingend</translation>
    </message>
    <message>
        <source>oscillating with dead time</source>
        <translation>schwingend mit Totzeit</translation>
    </message>
    <message>
        <source>oscillating with a lag</source>
        <translation>schwingend mit einem Verzögerungsglied</translation>
    </message>
    <message>
        <source>second order with a zero</source>
        <translation>2. Ordnung mit einer Nullstelle</translation>
    </message>
    <message>
        <source>second order with a zero and dead time</source>
        <translation>2. Ordnung mit einer Nullstelle und Totzeit</translation>
    </message>
    <message>
        <source>three equal lags</source>
        <translation>drei gleiche Verzögerungsglieder</translation>
    </message>
    <message>
        <source>three equal lags with a zero</source>
        <translation>drei gleiche Verzögerungsglieder mit einer Nullstelle</translation>
    </message>
    <message>
        <source>four equal lags</source>
        <translation>vier gleiche Verzögerungsglieder</translation>
    </message>
    <message>
        <source>five equal lags</source>
        <translation>fünf gleiche Verzögerungsglieder</translation>
    </message>
    <message>
        <source>six equal lags</source>
        <translation>sechs gleiche Verzögerungsglieder</translation>
    </message>
    <message>
        <source>seven equal lags</source>
        <translation>sieben gleiche Verzögerungsglieder</translation>
    </message>
    <message>
        <source>eight equal lags</source>
        <translation>acht gleiche Verzögerungsglieder</translation>
    </message>
    <message>
        <source>three equal lags with dead time</source>
        <translation>drei gleiche Verzögerungsglieder mit Totzeit</translation>
    </message>
    <message>
        <source>three lags</source>
        <translation>drei Verzögerungsglieder</translation>
    </message>
    <message>
        <source>three lags with dead time</source>
        <translation>drei Verzögerungsglieder mit Totzeit</translation>
    </message>
    <message>
        <source>four lags</source>
        <translation>vier Verzögerungsglieder</translation>
    </message>
    <message>
        <source>integrating</source>
        <translation>integrierend</translation>
    </message>
    <message>
        <source>integrating with dead time</source>
        <translation>integrierend mit Totzeit</translation>
    </message>
    <message>
        <source>integrating with a lag</source>
        <translation>integrierend mit einem Verzögerungsglied</translation>
    </message>
    <message>
        <source>integrating with a lag and dead time</source>
        <translation>integrierend mit einem Verzögerungsglied und Totzeit</translation>
    </message>
    <message>
        <source>integrating with two equal lags</source>
        <translation>integrierend mit zwei gleichen Verzögerungsgliedern</translation>
    </message>
    <message>
        <source>SIMC</source>
        <translation>SIMC</translation>
    </message>
    <message>
        <source>AMIGO</source>
        <translation>AMIGO</translation>
    </message>
    <message>
        <source>Optimum</source>
        <translation>Optimum</translation>
    </message>
    <message>
        <source>Chien-Hrones-Reswick</source>
        <translation>Chien-Hrones-Reswick</translation>
    </message>
    <message>
        <source>Ziegler-Nichols</source>
        <translation>Ziegler-Nichols</translation>
    </message>
    <message>
        <source>the recording has a gap in it</source>
        <translation>die Aufzeichnung hat darin eine Lücke</translation>
    </message>
    <message>
        <source>It oscillates with a period of {0} s and an amplitude of {1}, for {2} cycles in a row.</source>
        <translation>Schwingt mit einer Periode von {0}&#xa0;s und einer Amplitude von {1}, {2} Perioden in Folge.</translation>
    </message>
    <message>
        <source>It does not oscillate.</source>
        <translation>Schwingt nicht.</translation>
    </message>
    <message>
        <source>The settings are the likely cause: with the model, the loop oscillates with this period.</source>
        <translation>Wahrscheinliche Ursache sind die Einstellungen: Mit dem Modell schwingt der Regelkreis mit dieser Periode.</translation>
    </message>
    <message>
        <source>A sticking valve or an external disturbance is the likely cause; the recording cannot tell them apart. Switch the controller to manual: if the oscillation stops, the valve sticks; if it continues, the cause is external.</source>
        <translation>Wahrscheinliche Ursache ist ein klemmendes Ventil oder eine Störung von außen; die Aufzeichnung lässt beides nicht unterscheiden. Schalten Sie den Regler auf Hand: Hört die Schwingung auf, klemmt das Ventil; bleibt sie, kommt die Ursache von außen.</translation>
    </message>
    <message>
        <source>The likely cause is external: neither the settings nor a sticking valve explains it.</source>
        <translation>Die wahrscheinliche Ursache liegt außerhalb: Weder die Einstellungen noch ein klemmendes Ventil erklären es.</translation>
    </message>
    <message>
        <source>The output is at a limit for {0} % of the time.</source>
        <translation>Der Ausgang ist während {0}&#xa0;% der Zeit an einer Grenze.</translation>
    </message>
    <message>
        <source>{0} % of what the measured value does is noise.</source>
        <translation>{0}&#xa0;% der Bewegung des Messwerts sind Rauschen.</translation>
    </message>
    <message>
        <source>the output did not respond: the controller was not active</source>
        <translation>der Ausgang hat nicht reagiert: Der Regler war nicht aktiv</translation>
    </message>
    <message>
        <source>too short: not at rest again before the next change</source>
        <translation>zu kurz: vor der nächsten Änderung nicht wieder in Ruhe</translation>
    </message>
    <message>
        <source>The recording has {0} {0:disturbance|disturbances}, but no step that a model can be made from; change the set point or the output once and record the response</source>
        <translation>Die Aufzeichnung enthält {0} {0:Störung|Störungen}, aber keinen Sprung, aus dem sich ein Modell bilden lässt; ändern Sie einmal den Sollwert oder den Ausgang und zeichnen Sie die Antwort auf</translation>
    </message>
    <message>
        <source>Change {0} is a disturbance: its cause is not known, so no model can be made from it; choose a change of the set point or of the output</source>
        <translation>Änderung {0} ist eine Störung: Ihre Ursache ist unbekannt, daher ergibt sie kein Modell; wählen Sie eine Änderung des Sollwerts oder des Ausgangs</translation>
    </message>
    <message>
        <source>the measured value is at the end of its range for {0} % of the time</source>
        <translation>der Messwert ist während {0}&#xa0;% der Zeit am Ende seines Bereichs</translation>
    </message>
    <message>
        <source>{0}, controlled by {1}</source>
        <translation>{0}, geregelt von {1}</translation>
    </message>
    <message>
        <source>Changes in the recording</source>
        <translation>Änderungen in der Aufzeichnung</translation>
    </message>
    <message>
        <source>{0} found, {1} used for the model</source>
        <translation>{0} gefunden, {1} für das Modell verwendet</translation>
    </message>
    <message>
        <source>… and {0} more</source>
        <translation>… und {0} weitere</translation>
    </message>
    <message>
        <source>No model: {0}</source>
        <translation>Kein Modell: {0}</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>{0}, explains {1} %</source>
        <translation>{0}, erklärt {1}&#xa0;%</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Parameters by {0}</source>
        <translation>Parameter nach {0}</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>aufgezeichnet</translation>
    </message>
    <message>
        <source>output at a limit</source>
        <translation>Ausgang an einer Grenze</translation>
    </message>
    <message>
        <source>mean absolute error</source>
        <translation>mittlere absolute Regelabweichung</translation>
    </message>
    <message>
        <source>integrated absolute error</source>
        <translation>integrierte absolute Regelabweichung</translation>
    </message>
    <message>
        <source>movements of the output in an hour</source>
        <translation>Bewegungen des Ausgangs pro Stunde</translation>
    </message>
    <message>
        <source>noise of the measured value</source>
        <translation>Rauschen des Messwerts</translation>
    </message>
    <message>
        <source>at [s]</source>
        <translation>bei [s]</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>auf</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Beurteilung</translation>
    </message>
    <message>
        <source>output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>set point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>disturbance</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Ti [s]</source>
        <translation>Ti [s]</translation>
    </message>
    <message>
        <source>Td [s]</source>
        <translation>Td [s]</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>Amplitudenreserve</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>settling time [s]</source>
        <translation>Ausregelzeit [s]</translation>
    </message>
    <message>
        <source>error after a load step</source>
        <translation>Regelabweichung nach einem Lastsprung</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instabil</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>Recorded and modelled</source>
        <translation>Aufgezeichnet und modelliert</translation>
    </message>
    <message>
        <source>Step of the set point by 1</source>
        <translation>Sollwertsprung um 1</translation>
    </message>
    <message>
        <source>Step of the load by 1</source>
        <translation>Lastsprung um 1</translation>
    </message>
    <message>
        <source>Bode plot</source>
        <translation>Bode-Diagramm</translation>
    </message>
    <message>
        <source>Set point and measured value</source>
        <translation>Sollwert und Messwert</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>magnitude [dB]</source>
        <translation>Betrag [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>Phase [°]</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>Frequenz [rad/s]</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>loop now</source>
        <translation>aktueller Regelkreis</translation>
    </message>
    <message>
        <source>loop, {0}</source>
        <translation>Regelkreis, {0}</translation>
    </message>
    <message>
        <source>process</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>gain {0} ± {1}</source>
        <translation>Verstärkung {0} ± {1}</translation>
    </message>
    <message>
        <source>lag {0} s ± {1} s</source>
        <translation>Zeitkonstante {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>frequency {0} rad/s ± {1} rad/s</source>
        <translation>Frequenz {0}&#xa0;rad/s ± {1}&#xa0;rad/s</translation>
    </message>
    <message>
        <source>damping {0} ± {1}</source>
        <translation>Dämpfung {0} ± {1}</translation>
    </message>
    <message>
        <source>zero {0} s ± {1} s</source>
        <translation>Nullstelle {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>dead time {0} s ± {1} s</source>
        <translation>Totzeit {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>The gain is {0} upwards and {1} downwards; settings are made for {2}.</source>
        <translation>Die Verstärkung ist aufwärts {0} und abwärts {1}; die Einstellungen gelten für {2}.</translation>
    </message>
    <message>
        <source>The gain depends on the operating point: it is {0} where the measured value is about {1}, and {2} about {3}; settings are made for {4}. For one range alone, choose its steps only.</source>
        <translation>Die Verstärkung hängt vom Arbeitspunkt ab: Sie beträgt {0} bei einem Messwert um {1} und {2} um {3}; die Einstellungen gelten für {4}. Für einen Bereich allein wählen Sie nur dessen Sprünge.</translation>
    </message>
    <message>
        <source>usable; the output was set to its limit</source>
        <translation>brauchbar; der Ausgang wurde auf seine Grenze gestellt</translation>
    </message>
    <message>
        <source>Loop health</source>
        <translation>Zustand des Regelkreises</translation>
    </message>
    <message>
        <source>It explains {0} % of the steps it was not fitted to.</source>
        <translation>Von den Sprüngen, an die es nicht angepasst wurde, erklärt es {0}&#xa0;%.</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residuen</translation>
    </message>
    <message>
        <source>The controller output and the measured value are the same in every sample; choose another measured value</source>
        <translation>Reglerausgang und Messwert sind in jedem Abtastwert gleich; wählen Sie einen anderen Messwert</translation>
    </message>
    <message>
        <source>A sticking valve is the likely cause: the output moves evenly, but the process responds in jumps. Check it with the controller in manual: the oscillation then stops; if it continues, the cause is external.</source>
        <translation>Wahrscheinliche Ursache ist ein klemmendes Ventil: Der Ausgang bewegt sich gleichmäßig, die Strecke antwortet in Sprüngen. Prüfen Sie es mit dem Regler in Hand: Die Schwingung hört dann auf; bleibt sie, kommt die Ursache von außen.</translation>
    </message>
</context>
<context>
    <name>Waveform</name>
    <message>
        <source>The table has no column of times; name one time_s (seconds) or time_ms</source>
        <translation>Die Tabelle hat keine Zeitspalte; benennen Sie eine Spalte time_s (Sekunden) oder time_ms</translation>
    </message>
    <message>
        <source>The table has no column {0}; it has {1}</source>
        <translation>Die Tabelle hat keine Spalte {0}; sie hat {1}</translation>
    </message>
    <message>
        <source>The table has no column {0}; did you mean {1}?</source>
        <translation>Die Tabelle hat keine Spalte {0}; meinten Sie {1}?</translation>
    </message>
    <message>
        <source>Line {0} has no number in column {1}; correct or remove the line</source>
        <translation>Zeile {0} hat keine Zahl in Spalte {1}; berichtigen oder entfernen Sie die Zeile</translation>
    </message>
    <message>
        <source>The time in line {0} is before that of the line above; sort the lines by time</source>
        <translation>Die Zeit in Zeile {0} liegt vor der Zeit in der Zeile darüber; sortieren Sie die Zeilen nach der Zeit</translation>
    </message>
    <message>
        <source>The table has no column of numbers besides the time; add one with a heading</source>
        <translation>Die Tabelle hat außer der Zeit keine Spalte mit Zahlen; fügen Sie eine mit Überschrift hinzu</translation>
    </message>
    <message>
        <source>The table has no rows below its headings; write one row per sample</source>
        <translation>Die Tabelle hat unter den Überschriften keine Zeilen; schreiben Sie eine Zeile je Abtastwert</translation>
    </message>
    <message>
        <source>The table cannot be shown as a recording: {0}</source>
        <translation>Die Tabelle kann nicht als Aufzeichnung angezeigt werden: {0}</translation>
    </message>
    <message>
        <source>the names of its columns cannot be variables; use letters, digits and underscores</source>
        <translation>die Namen ihrer Spalten sind als Variablen nicht möglich; verwenden Sie Buchstaben, Ziffern und Unterstriche</translation>
    </message>
    <message>
        <source>{0} {0:sample is|samples are} too few for a spectrum; show a longer section</source>
        <translation>{0} {0:Abtastwert ist|Abtastwerte sind} zu wenig für ein Spektrum; zeigen Sie einen längeren Bereich an</translation>
    </message>
    <message>
        <source>{0} {0:sample is|samples are} too few for a frequency response; show a longer section</source>
        <translation>{0} {0:Abtastwert ist|Abtastwerte sind} zu wenig für einen Frequenzgang; zeigen Sie einen längeren Bereich an</translation>
    </message>
    <message>
        <source>The input does not change here, so there is no response; show another section</source>
        <translation>Der Eingang ändert sich hier nicht, daher gibt es keine Antwort; zeigen Sie einen anderen Bereich an</translation>
    </message>
    <message>
        <source>{0} needs a closing parenthesis at the end; it must enclose the whole expression</source>
        <translation>{0} braucht am Ende eine schließende Klammer; sie muss den ganzen Ausdruck umschließen</translation>
    </message>
    <message>
        <source>{0} needs a time above 0 as its second argument, for example {1}</source>
        <translation>{0} braucht als zweites Argument eine Zeit über 0, zum Beispiel {1}</translation>
    </message>
    <message>
        <source>{0} takes one expression; remove the others</source>
        <translation>{0} nimmt genau einen Ausdruck; entfernen Sie die anderen</translation>
    </message>
    <message>
        <source>The file is not a table; a recording of Stepwise ends with .rec</source>
        <translation>Die Datei ist keine Tabelle; eine Aufzeichnung von Stepwise endet auf .rec</translation>
    </message>
    <message>
        <source>Column {0}: {1} {1:cell is not a number|cells are not numbers}, the first ({2}) in line {3}; the value above it is kept</source>
        <translation>Spalte {0}: {1} {1:Zelle ist keine Zahl|Zellen sind keine Zahlen}, die erste ({2}) in Zeile {3}; der Wert darüber gilt weiter</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} fewer cells than the header, the first in line {1}; the values above are kept</source>
        <translation>{0} {0:Zeile hat|Zeilen haben} weniger Zellen als die Kopfzeile, die erste ist Zeile {1}; die Werte darüber gelten weiter</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} more cells than the header, the first in line {1}; the surplus cells are ignored. Put numbers with a decimal comma in quotes</source>
        <translation>{0} {0:Zeile hat|Zeilen haben} mehr Zellen als die Kopfzeile, die erste ist Zeile {1}; die überzähligen Zellen werden ignoriert. Setzen Sie Zahlen mit Dezimalkomma in Anführungszeichen</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} the same time as the row above, the first in line {1}; {0:it is|they are} left out</source>
        <translation>{0} {0:Zeile hat|Zeilen haben} dieselbe Zeit wie die Zeile darüber, die erste ist Zeile {1}; {0:sie wird|sie werden} ausgelassen</translation>
    </message>
    <message>
        <source>Line {0} is not a sample of a variable: it needs a time and a value</source>
        <translation>Zeile {0} ist kein Abtastwert einer Variablen: Sie braucht eine Zeit und einen Wert</translation>
    </message>
    <message>
        <source>The trace cannot be read as XML: {0}; save it again</source>
        <translation>Der Trace lässt sich nicht als XML lesen: {0}; speichern Sie ihn erneut</translation>
    </message>
    <message>
        <source>{0} has {1} {1:value|values} but {2} {2:time|times}; save the trace again</source>
        <translation>{0} hat {1} {1:Wert|Werte}, aber {2} {2:Zeit|Zeiten}; speichern Sie den Trace erneut</translation>
    </message>
    <message>
        <source>The times of {0} run backwards; save the trace again</source>
        <translation>Die Zeiten von {0} laufen rückwärts; speichern Sie den Trace erneut</translation>
    </message>
    <message>
        <source>The file is empty; export the table again</source>
        <translation>Die Datei ist leer; exportieren Sie die Tabelle erneut</translation>
    </message>
    <message>
        <source>The table has {0} columns {1}; give each its own heading</source>
        <translation>Die Tabelle hat {0} Spalten {1}; geben Sie jeder eine eigene Überschrift</translation>
    </message>
    <message>
        <source>Column {0} has no numbers; choose one of {1}</source>
        <translation>Spalte {0} hat keine Zahlen; wählen Sie eine von {1}</translation>
    </message>
</context>
<context>
    <name>plc::app::AttachDialog</name>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Attach to a Controller</source>
        <translation>Mit einer Steuerung verbinden</translation>
    </message>
    <message>
        <source>from the file attach-code of the controller</source>
        <translation>aus der Datei attach-code der Steuerung</translation>
    </message>
    <message>
        <source>only for certificates that this computer does not know</source>
        <translation>nur für Zertifikate, die dieser Rechner nicht kennt</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose a certificate</source>
        <translation>Zertifikat wählen</translation>
    </message>
    <message>
        <source>Trusted certificate</source>
        <translation>Vertrauenswürdiges Zertifikat</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Choose a Certificate</source>
        <translation>Zertifikat wählen</translation>
    </message>
    <message>
        <source>Certificates (*.pem *.crt *.cer);;All files (*)</source>
        <translation>Zertifikate (*.pem *.crt *.cer);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Attaching…</source>
        <translation>Wird verbunden…</translation>
    </message>
</context>
<context>
    <name>plc::app::Attachment</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Attached to %1</source>
        <translation>Verbunden mit %1</translation>
    </message>
    <message>
        <source>Attached to %1; its program is not the one that is open here</source>
        <translation>Verbunden mit %1; das Programm dort ist nicht das hier geöffnete</translation>
    </message>
    <message>
        <source>Connection to %1 lost – reconnecting…</source>
        <translation>Verbindung zu %1 unterbrochen – wird wiederhergestellt…</translation>
    </message>
    <message>
        <source>Attaching to %1…</source>
        <translation>Verbindung mit %1 wird hergestellt…</translation>
    </message>
    <message>
        <source>The controller runs remotely; values written and forced here take effect there</source>
        <translation>Die Steuerung läuft entfernt; hier geschriebene und geforcte Werte wirken dort</translation>
    </message>
</context>
<context>
    <name>plc::app::ConversionDialog</name>
    <message>
        <source>%1 as ST</source>
        <translation>%1 als ST</translation>
    </message>
    <message>
        <source>%1 as an Instruction List</source>
        <translation>%1 als Anweisungsliste</translation>
    </message>
    <message>
        <source>Instruction list (current text)</source>
        <translation>Anweisungsliste (vorhandener Text)</translation>
    </message>
    <message>
        <source>ST (current text)</source>
        <translation>ST (vorhandener Text)</translation>
    </message>
    <message>
        <source>The same as ST</source>
        <translation>Dasselbe als ST</translation>
    </message>
    <message>
        <source>The same as an instruction list</source>
        <translation>Dasselbe als Anweisungsliste</translation>
    </message>
    <message>
        <source>Both give the same results. Replacing can be undone in one step; comments are kept, each above its statement.</source>
        <translation>Beide liefern dieselben Ergebnisse. Das Ersetzen lässt sich in einem Schritt rückgängig machen; Kommentare bleiben erhalten, jeder über seiner Anweisung.</translation>
    </message>
    <message>
        <source>Replace the Text</source>
        <translation>Text ersetzen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
</context>
<context>
    <name>plc::app::DesignPages</name>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepturen</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Benutzer und Rechte</translation>
    </message>
    <message>
        <source>New Panel</source>
        <translation>Neues Panel</translation>
    </message>
    <message>
        <source>Name of the panel:</source>
        <translation>Name des Panels:</translation>
    </message>
    <message>
        <source>overview</source>
        <translation>uebersicht</translation>
    </message>
    <message>
        <source>A panel&apos;s name cannot contain / or \; choose another name</source>
        <translation>Der Name eines Panels darf weder / noch \ enthalten; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>%1 was changed. Save it?</source>
        <translation>%1 wurde geändert. Speichern?</translation>
    </message>
</context>
<context>
    <name>plc::app::DevicesView</name>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>wird verbunden</translation>
    </message>
    <message>
        <source>online</source>
        <translation>online</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>noch nichts</translation>
    </message>
    <message>
        <source>refused by the device</source>
        <translation>vom Gerät abgelehnt</translation>
    </message>
    <message>
        <source>does not fit</source>
        <translation>passt nicht</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Device or channel</source>
        <translation>Gerät oder Kanal</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Traffic</source>
        <translation>Datenverkehr</translation>
    </message>
    <message>
        <source>Fields of the device or channel</source>
        <translation>Felder des Geräts oder Kanals</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Connect or disconnect the devices</source>
        <translation>Geräte verbinden oder trennen</translation>
    </message>
    <message>
        <source>Add a device</source>
        <translation>Gerät hinzufügen</translation>
    </message>
    <message>
        <source>This project has no devices yet. A device (Modbus, MQTT) brings values from outside into variables and takes values of variables out.</source>
        <translation>Dieses Projekt hat noch keine Geräte. Ein Gerät (Modbus, MQTT) bringt Werte von außen in Variablen und gibt Werte von Variablen nach außen.</translation>
    </message>
    <message>
        <source>Modbus TCP device</source>
        <translation>Modbus-TCP-Gerät</translation>
    </message>
    <message>
        <source>Modbus RTU device (serial)</source>
        <translation>Modbus-RTU-Gerät (seriell)</translation>
    </message>
    <message>
        <source>Modbus TCP server</source>
        <translation>Modbus-TCP-Server</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>MQTT-Broker</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Kanal hinzufügen</translation>
    </message>
    <message>
        <source>Delete the device or channel</source>
        <translation>Gerät oder Kanal löschen</translation>
    </message>
    <message>
        <source>Propose addresses for channels without a variable</source>
        <translation>Adressen für Kanäle ohne Variable vorschlagen</translation>
    </message>
    <message>
        <source>Undo the last change of the devices</source>
        <translation>Letzte Änderung der Geräte rückgängig machen</translation>
    </message>
    <message>
        <source>Every channel has a variable</source>
        <translation>Jeder Kanal hat eine Variable</translation>
    </message>
    <message numerus="yes">
        <source>%n address(es) proposed</source>
        <translation>
            <numerusform>%n Adresse vorgeschlagen</numerusform>
            <numerusform>%n Adressen vorgeschlagen</numerusform>
        </translation>
    </message>
    <message>
        <source>not enabled</source>
        <translation>nicht aktiviert</translation>
    </message>
    <message>
        <source>%1 requests, %2 errors, %3 ms</source>
        <translation>%1 Anfragen, %2 Fehler, %3&#xa0;ms</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>online: %1 of %2</source>
        <translation>online: %1 von %2</translation>
    </message>
    <message>
        <source>“%1” in devices.json</source>
        <translation>„%1“ in devices.json</translation>
    </message>
</context>
<context>
    <name>plc::app::EditorTabs</name>
    <message>
        <source>Documents</source>
        <translation>Dokumente</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close Others</source>
        <translation>Andere schließen</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>%1 was changed. Save it?</source>
        <translation>%1 wurde geändert. Speichern?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were changed: %1. Save them?</source>
        <translation>
            <numerusform>%n Datei wurde geändert: %1. Speichern?</numerusform>
            <numerusform>%n Dateien wurden geändert: %1. Speichern?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s); those edited since stay as they are</source>
        <translation>
            <numerusform>In %n Datei geändert; seither bearbeitete bleiben, wie sie sind</numerusform>
            <numerusform>In %n Dateien geändert; seither bearbeitete bleiben, wie sie sind</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s)</source>
        <translation>
            <numerusform>In %n Datei geändert</numerusform>
            <numerusform>In %n Dateien geändert</numerusform>
        </translation>
    </message>
    <message>
        <source>Read-only file</source>
        <translation>Schreibgeschützte Datei</translation>
    </message>
    <message>
        <source>%1 is read-only. Replace it anyway? It stays read-only.</source>
        <translation>%1 ist schreibgeschützt. Trotzdem ersetzen? Die Datei bleibt schreibgeschützt.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>%1 was not saved</source>
        <translation>%1 wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>%1 is not a variable of the running program; check the name, or press F5 to build the program</source>
        <translation>%1 ist keine Variable des laufenden Programms; prüfen Sie den Namen oder übersetzen Sie das Programm mit F5</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Forcen</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
</context>
<context>
    <name>plc::app::ExplanationDialog</name>
    <message>
        <source>Explanation</source>
        <translation>Erklärung</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <extracomment>an example&apos;s line, then what is wrong there</extracomment>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>What %1 Means</source>
        <translation>Was %1 bedeutet</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Falsch</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Richtig</translation>
    </message>
    <message>
        <source>Put the cursor on a problem, or choose one in the list, and press F1 again</source>
        <translation>Setzen Sie den Cursor auf ein Problem oder wählen Sie eines in der Liste und drücken Sie F1 erneut</translation>
    </message>
    <message>
        <source>There is no page for %1; choose a code from the list</source>
        <translation>Zu %1 gibt es keine Seite; wählen Sie einen Code aus der Liste</translation>
    </message>
</context>
<context>
    <name>plc::app::ExportDialog</name>
    <message>
        <source>Export the Project</source>
        <translation>Projekt exportieren</translation>
    </message>
    <message>
        <source>PLCopen XML 0200, for CODESYS and TwinCAT</source>
        <translation>PLCopen XML 0200, für CODESYS und TwinCAT</translation>
    </message>
    <message>
        <source>PLCopen XML 0201, for Beremiz and OpenPLC</source>
        <translation>PLCopen XML 0201, für Beremiz und OpenPLC</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Format:</source>
        <translation>Format:</translation>
    </message>
    <message>
        <source>To:</source>
        <translation>Nach:</translation>
    </message>
    <message>
        <source>This file exists and will be replaced</source>
        <translation>Diese Datei ist vorhanden und wird ersetzt</translation>
    </message>
</context>
<context>
    <name>plc::app::FileCommands</name>
    <message>
        <source>New Trace</source>
        <translation>Neuer Trace</translation>
    </message>
    <message>
        <source>Name of the trace:</source>
        <translation>Name des Trace:</translation>
    </message>
    <message>
        <source>trace</source>
        <translation>trace</translation>
    </message>
    <message>
        <source>A file name cannot contain / or \; choose another name</source>
        <translation>Ein Dateiname darf weder / noch \ enthalten; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>A trace %1 already exists; choose another name</source>
        <translation>Ein Trace %1 ist bereits vorhanden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>New name of %1:</source>
        <translation>Neuer Name von %1:</translation>
    </message>
    <message>
        <source>A file %1 already exists; choose another name</source>
        <translation>Eine Datei %1 ist bereits vorhanden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>The file cannot be renamed; check the permissions of the folder</source>
        <translation>Die Datei kann nicht umbenannt werden; prüfen Sie die Rechte des Ordners</translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>%1 löschen?</translation>
    </message>
    <message>
        <source>It contains %1.</source>
        <translation>Sie enthält %1.</translation>
    </message>
    <message>
        <source>These panels link to it; their buttons will be reported as errors: %1</source>
        <translation>Diese Panels verweisen darauf; ihre Schaltflächen führen dann ins Leere: %1</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>The file cannot be removed; check the permissions of the folder</source>
        <translation>Die Datei kann nicht gelöscht werden; prüfen Sie die Rechte des Ordners</translation>
    </message>
</context>
<context>
    <name>plc::app::GuideView</name>
    <message>
        <source>About this project</source>
        <translation>Über dieses Projekt</translation>
    </message>
    <message>
        <source>A README.md in the project&apos;s folder is shown here.</source>
        <translation>Eine README.md im Projektordner wird hier angezeigt.</translation>
    </message>
</context>
<context>
    <name>plc::app::ImportDialog</name>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Objects: %1
Bodies: %2
Not kept: %3</source>
        <translation>Objekte: %1
Rümpfe: %2
Nicht erhalten: %3</translation>
    </message>
    <message>
        <source>Import a Project</source>
        <translation>Projekt importieren</translation>
    </message>
    <message>
        <source>PLCopen XML, TwinCAT or CODESYS files, structured text</source>
        <translation>PLCopen XML, Dateien von TwinCAT oder CODESYS, strukturierter Text</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner…</translation>
    </message>
    <message>
        <source>Source files</source>
        <translation>Quelldateien</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>From:</source>
        <translation>Von:</translation>
    </message>
    <message>
        <source>New project in:</source>
        <translation>Neues Projekt in:</translation>
    </message>
    <message>
        <source>Projects of other tools (%1)</source>
        <translation>Projekte anderer Werkzeuge (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>This folder is not empty; name a new one</source>
        <translation>Dieser Ordner ist nicht leer; geben Sie einen neuen an</translation>
    </message>
    <message>
        <source>program units</source>
        <translation>Bausteine</translation>
    </message>
    <message>
        <source>data types</source>
        <translation>Datentypen</translation>
    </message>
    <message>
        <source>global variable lists</source>
        <translation>Globale Variablenlisten</translation>
    </message>
    <message>
        <source>configurations</source>
        <translation>Konfigurationen</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>PLCopen XML, TwinCAT, CODESYS, ST</source>
        <translation>PLCopen XML, TwinCAT, CODESYS, ST</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wird gelesen…</translation>
    </message>
    <message>
        <source>Becomes a separate project with the libraries it uses</source>
        <translation>Wird ein eigenes Projekt mit den Bibliotheken, die es verwendet</translation>
    </message>
    <message>
        <source>Writing the project…</source>
        <translation>Projekt wird geschrieben…</translation>
    </message>
    <message>
        <source>Encoding:</source>
        <translation>Codierung:</translation>
    </message>
    <message>
        <source>Recognised</source>
        <translation>Erkannt</translation>
    </message>
    <message>
        <source>For files that are not in Unicode and do not specify their encoding</source>
        <translation>Für Dateien, die nicht in Unicode sind und ihre Codierung nicht angeben</translation>
    </message>
</context>
<context>
    <name>plc::app::InsideViews</name>
    <message>
        <source>Coverage of the latest %1 of %2 recorded scans</source>
        <translation>Abdeckung der neuesten %1 von %2 aufgezeichneten Zyklen</translation>
    </message>
    <message>
        <source>There is no recording yet: run the program first.</source>
        <translation>Es gibt noch keine Aufzeichnung: Starten Sie zuerst das Programm.</translation>
    </message>
    <message>
        <source>Put the cursor on a variable, or select an expression, to ask about it</source>
        <translation>Setzen Sie den Cursor auf eine Variable, oder markieren Sie einen Ausdruck, um danach zu fragen</translation>
    </message>
</context>
<context>
    <name>plc::app::InstanceBar</name>
    <message>
        <source>Instance whose values are shown</source>
        <translation>Instanz, deren Werte angezeigt werden</translation>
    </message>
    <message>
        <source>Values of the instance of %1:</source>
        <translation>Werte der Instanz von %1:</translation>
    </message>
</context>
<context>
    <name>plc::app::LiveViews</name>
    <message>
        <source>Panel shown</source>
        <translation>Angezeigtes Panel</translation>
    </message>
    <message>
        <source>Full screen (Esc to exit)</source>
        <translation>Vollbild (Esc zum Beenden)</translation>
    </message>
    <message>
        <source>This project has no panel yet.
To draw one, right-click Panels in the project tree and choose New.</source>
        <translation>Dieses Projekt hat noch kein Panel.
Um eines zu zeichnen, klicken Sie im Projektbaum mit der rechten Maustaste auf Panels und wählen Neu.</translation>
    </message>
    <message>
        <source>No panel can be read: %1.
Problems says what is wrong; a double click there opens the file as text.</source>
        <translation>Kein Panel kann gelesen werden: %1.
Unter Probleme steht, was falsch ist; ein Doppelklick dort öffnet die Datei als Text.</translation>
    </message>
    <message>
        <source>The alarm history is kept in memory only: %1</source>
        <translation>Die Alarmhistorie bleibt nur im Speicher erhalten: %1</translation>
    </message>
    <message>
        <source>Saving the recording…</source>
        <translation>Die Aufzeichnung wird gespeichert…</translation>
    </message>
    <message>
        <source>Export the alarm history…</source>
        <translation>Alarmhistorie exportieren…</translation>
    </message>
    <message>
        <source>Export the Alarm History</source>
        <translation>Alarmhistorie exportieren</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
</context>
<context>
    <name>plc::app::MainWindow</name>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Überwachung</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Geforcte Werte</translation>
    </message>
    <message>
        <source>Call Stack</source>
        <translation>Aufrufliste</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>Haltepunkte</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tasks</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Recent Projects</source>
        <translation>Zuletzt verwendete Projekte</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Symbolleiste</translation>
    </message>
    <message>
        <source>State of the controller</source>
        <translation>Zustand der Steuerung</translation>
    </message>
    <message>
        <source>%1 : %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>OFFLINE</source>
        <translation>OFFLINE</translation>
    </message>
    <message>
        <source>RUN</source>
        <translation>RUN</translation>
    </message>
    <message>
        <source>PAUSE</source>
        <translation>PAUSE</translation>
    </message>
    <message>
        <source>HALT</source>
        <translation>HALT</translation>
    </message>
    <message>
        <source>FAULT</source>
        <translation>FEHLER</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>PAST</source>
        <translation>VERGANGENHEIT</translation>
    </message>
    <message>
        <source>%1 · scan %2</source>
        <translation>%1 · Zyklus %2</translation>
    </message>
    <message>
        <source>%1 µs · %2 % load</source>
        <translation>%1&#xa0;µs · %2&#xa0;% Auslastung</translation>
    </message>
    <message>
        <source>%1 MB recorded</source>
        <translation>%1&#xa0;MB aufgezeichnet</translation>
    </message>
    <message>
        <source>%1 scans of %2 MB at most</source>
        <translation>%1 Zyklen, höchstens %2&#xa0;MB</translation>
    </message>
    <message>
        <source>Go to the line</source>
        <translation>Zur Zeile gehen</translation>
    </message>
    <message>
        <source>no problems</source>
        <translation>keine Probleme</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>%1 – Stepwise</source>
        <translation>%1 – Stepwise</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Wiederherstellung</translation>
    </message>
    <message>
        <source>Stepwise was closed without saving. Unsaved changes to %1 were kept. Restore them?</source>
        <translation>Stepwise wurde beendet, ohne zu speichern. Ungespeicherte Änderungen an %1 sind erhalten. Wiederherstellen?</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliotheken</translation>
    </message>
    <message>
        <source>Running tests…</source>
        <translation>Die Tests laufen…</translation>
    </message>
    <message>
        <source>passed: %1</source>
        <translation>bestanden: %1</translation>
    </message>
    <message>
        <source>FAILED: %1</source>
        <translation>FEHLGESCHLAGEN: %1</translation>
    </message>
    <message>
        <source>%1 passed, %2 failed</source>
        <translation>%1 bestanden, %2 fehlgeschlagen</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>So schnell wie möglich</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Memory for the recording of every scan [MB]:</source>
        <translation>Speicher für die Aufzeichnung aller Zyklen [MB]:</translation>
    </message>
    <message>
        <source>Save the Recording</source>
        <translation>Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>Recordings (*.rec)</source>
        <translation>Aufzeichnungen (*.rec)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>About Stepwise</source>
        <translation>Über Stepwise</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>The project</source>
        <translation>Das Projekt</translation>
    </message>
    <message>
        <source>Programs, blocks, tasks, panels, traces and tests, made from the text files in the folder.</source>
        <translation>Programme, Bausteine, Tasks, Panels, Traces und Tests, aus den Textdateien im Ordner.</translation>
    </message>
    <message>
        <source>The program</source>
        <translation>Das Programm</translation>
    </message>
    <message>
        <source>Structured Text with semantic highlighting. Errors are underlined as you type; Alt+Enter offers quick fixes; Ctrl+Space completes.</source>
        <translation>Strukturierter Text mit semantischer Hervorhebung. Fehler werden beim Tippen unterstrichen; Alt+Enter bietet Schnellkorrekturen an; Strg+Leertaste vervollständigt.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>F5 compiles to native code and runs it. Values then appear next to each line.</source>
        <translation>F5 übersetzt in Maschinencode und führt ihn aus. Die Werte erscheinen dann neben jeder Zeile.</translation>
    </message>
    <message>
        <source>Any expression, at any moment. Prepare a value and write or force it with one click.</source>
        <translation>Jeder Ausdruck, jederzeit. Einen Wert vorbereiten und mit einem Klick schreiben oder forcen.</translation>
    </message>
    <message>
        <source>The trace</source>
        <translation>Der Trace</translation>
    </message>
    <message>
        <source>Nothing has to be selected in advance: every scan is recorded, and any expression can be charted afterwards.</source>
        <translation>Nichts muss vorher gewählt werden: Jeder Zyklus wird aufgezeichnet, und jeder Ausdruck lässt sich nachträglich als Diagramm darstellen.</translation>
    </message>
    <message>
        <source>The panel</source>
        <translation>Das Panel</translation>
    </message>
    <message>
        <source>What the operator sees, in the languages of the machine. It works here as it will on the machine.</source>
        <translation>Was der Bediener sieht, in den Sprachen der Maschine. Es arbeitet hier wie später an der Maschine.</translation>
    </message>
    <message>
        <source>Time runs backwards, too</source>
        <translation>Die Zeit läuft auch rückwärts</translation>
    </message>
    <message>
        <source>That’s it</source>
        <translation>Das war es</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P finds every command. The start page has more machines to play with.</source>
        <translation>Strg+Umschalt+P findet jeden Befehl. Die Startseite hat weitere Maschinen zum Ausprobieren.</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>Neues Projekt…</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>Projekt öffnen…</translation>
    </message>
    <message>
        <source>Close Project</source>
        <translation>Projekt schließen</translation>
    </message>
    <message>
        <source>New Program, Block, Type…</source>
        <translation>Programm, Baustein, Datentyp hinzufügen…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>New Panel…</source>
        <translation>Neues Panel…</translation>
    </message>
    <message>
        <source>Panel Texts</source>
        <translation>Paneltexte</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Alles speichern</translation>
    </message>
    <message>
        <source>Close Document</source>
        <translation>Dokument schließen</translation>
    </message>
    <message>
        <source>Libraries…</source>
        <translation>Bibliotheken…</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Einstellungen…</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>Suchen…</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Ersetzen…</translation>
    </message>
    <message>
        <source>Find Next</source>
        <translation>Weitersuchen</translation>
    </message>
    <message>
        <source>Find Previous</source>
        <translation>Rückwärts suchen</translation>
    </message>
    <message>
        <source>Find in All Files…</source>
        <translation>In allen Dateien suchen…</translation>
    </message>
    <message>
        <source>Go to Line…</source>
        <translation>Gehe zu Zeile…</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Gehe zur Definition</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Referenzen suchen</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Vervollständigen</translation>
    </message>
    <message>
        <source>Quick Fix (Alt+Enter)</source>
        <translation>Schnellkorrektur (Alt+Enter)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formatieren</translation>
    </message>
    <message>
        <source>Toggle Comment (Ctrl+/)</source>
        <translation>Ein- oder auskommentieren (Strg+#)</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Zeile duplizieren</translation>
    </message>
    <message>
        <source>Select Enclosing Block</source>
        <translation>Umgebenden Block markieren</translation>
    </message>
    <message>
        <source>Go to Matching Keyword</source>
        <translation>Gehe zum zugehörigen Schlüsselwort</translation>
    </message>
    <message>
        <source>Next Problem</source>
        <translation>Nächstes Problem</translation>
    </message>
    <message>
        <source>Previous Problem</source>
        <translation>Voriges Problem</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Übersetzen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Single Scan</source>
        <translation>Einzelzyklus</translation>
    </message>
    <message>
        <source>Step Into</source>
        <translation>Einzelschritt</translation>
    </message>
    <message>
        <source>Step Over</source>
        <translation>Prozedurschritt</translation>
    </message>
    <message>
        <source>Step Out</source>
        <translation>Ausführen bis Rücksprung</translation>
    </message>
    <message>
        <source>Run to Cursor</source>
        <translation>Ausführen bis Cursor</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Haltepunkt umschalten</translation>
    </message>
    <message>
        <source>Reset Warm</source>
        <translation>Reset warm</translation>
    </message>
    <message>
        <source>Reset Cold</source>
        <translation>Reset kalt</translation>
    </message>
    <message>
        <source>Reset Origin</source>
        <translation>Reset Ursprung</translation>
    </message>
    <message>
        <source>Online Change</source>
        <translation>Online-Change</translation>
    </message>
    <message>
        <source>Speed…</source>
        <translation>Geschwindigkeit…</translation>
    </message>
    <message>
        <source>Memory for the Recording…</source>
        <translation>Speicher für die Aufzeichnung…</translation>
    </message>
    <message>
        <source>Save the Recording…</source>
        <translation>Aufzeichnung speichern…</translation>
    </message>
    <message>
        <source>Write Prepared Values</source>
        <translation>Werte schreiben</translation>
    </message>
    <message>
        <source>Force Prepared Values</source>
        <translation>Werte forcen</translation>
    </message>
    <message>
        <source>Release All Forces</source>
        <translation>Forcen für alle Werte aufheben</translation>
    </message>
    <message>
        <source>Run the Tests</source>
        <translation>Tests ausführen</translation>
    </message>
    <message>
        <source>One Scan Back</source>
        <translation>Einen Zyklus zurück</translation>
    </message>
    <message>
        <source>One Scan Forward</source>
        <translation>Einen Zyklus vor</translation>
    </message>
    <message>
        <source>Back to Live</source>
        <translation>Zurück zum Livebetrieb</translation>
    </message>
    <message>
        <source>Resume from Here</source>
        <translation>Ab hier fortsetzen</translation>
    </message>
    <message>
        <source>Command Palette</source>
        <translation>Befehlspalette</translation>
    </message>
    <message>
        <source>Split the Editor</source>
        <translation>Editor teilen</translation>
    </message>
    <message>
        <source>Declarations as a Table</source>
        <translation>Deklarationen als Tabelle</translation>
    </message>
    <message>
        <source>Online Values in the Text</source>
        <translation>Online-Werte im Text</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Light Theme</source>
        <translation>Helles Farbschema</translation>
    </message>
    <message>
        <source>Dark Theme</source>
        <translation>Dunkles Farbschema</translation>
    </message>
    <message>
        <source>System Theme</source>
        <translation>Farbschema des Systems</translation>
    </message>
    <message>
        <source>Reset the Layout</source>
        <translation>Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Open a Recording…</source>
        <translation>Aufzeichnung öffnen…</translation>
    </message>
    <message>
        <source>All values are from a recording file. Click to go back to the controller.</source>
        <translation>Alle Werte stammen aus der Aufzeichnung in einer Datei. Ein Klick führt zurück zur Steuerung.</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>AUFZEICHNUNG</translation>
    </message>
    <message>
        <source>%1 – back to live</source>
        <translation>%1 – zurück zum Livebetrieb</translation>
    </message>
    <message>
        <source>Open a Recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Show as ST…</source>
        <translation>Als ST anzeigen…</translation>
    </message>
    <message>
        <source>Show as an Instruction List…</source>
        <translation>Als Anweisungsliste anzeigen…</translation>
    </message>
    <message>
        <source>New Trace…</source>
        <translation>Neuer Trace…</translation>
    </message>
    <message>
        <source>The build was cancelled; everything is as it was</source>
        <translation>Das Übersetzen wurde abgebrochen; alles ist wie vorher</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Tests</translation>
    </message>
    <message>
        <source>The tests were cancelled</source>
        <translation>Die Tests wurden abgebrochen</translation>
    </message>
    <message>
        <source>Cancelled: nothing was saved</source>
        <translation>Abgebrochen: Nichts wurde gespeichert</translation>
    </message>
    <message>
        <source>%1 is encoded in %2 and will be saved in that encoding</source>
        <translation>%1 ist in %2 codiert und wird in dieser Codierung gespeichert</translation>
    </message>
    <message>
        <source>This is a copy of the example, in %1: change what you like</source>
        <translation>Das ist eine Kopie des Beispiels, in %1: Ändern Sie, was Sie möchten</translation>
    </message>
    <message>
        <source>This is your copy of the example, in %1</source>
        <translation>Das ist Ihre Kopie des Beispiels, in %1</translation>
    </message>
    <message>
        <source>The language changes when the tests have ended</source>
        <translation>Die Sprache wechselt, wenn die Tests zu Ende sind</translation>
    </message>
    <message>
        <source>Controller fault</source>
        <translation>Steuerungsfehler</translation>
    </message>
    <message>
        <source>RUN %1</source>
        <translation>RUN %1</translation>
    </message>
    <message>
        <source>at full speed</source>
        <translation>so schnell wie möglich</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Speed of the controller; any factor can be entered:</source>
        <translation>Geschwindigkeit der Steuerung; jeder Faktor kann eingegeben werden:</translation>
    </message>
    <message>
        <source>The speed is a factor from 0.001 to 10000</source>
        <translation>Die Geschwindigkeit ist ein Faktor von 0,001 bis 10000</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>The project was exported</source>
        <translation>Das Projekt wurde exportiert</translation>
    </message>
    <message>
        <source>Add Next Occurrence to Selection</source>
        <translation>Nächstes Vorkommen auch auswählen</translation>
    </message>
    <message>
        <source>Arrange for Editing</source>
        <translation>Zum Bearbeiten anordnen</translation>
    </message>
    <message>
        <source>Arrange for Debugging</source>
        <translation>Zum Debuggen anordnen</translation>
    </message>
    <message>
        <source>Arrange for Drawing Panels</source>
        <translation>Zum Zeichnen von Panels anordnen</translation>
    </message>
    <message>
        <source>Maximise the Editor</source>
        <translation>Editor maximieren</translation>
    </message>
    <message>
        <source>Keeping the recording of the last run…</source>
        <translation>Die Aufzeichnung des letzten Laufs wird aufbewahrt…</translation>
    </message>
    <message>
        <source>Diagram Beside the Text</source>
        <translation>Diagramm neben dem Text</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>Next Bookmark</source>
        <translation>Nächstes Lesezeichen</translation>
    </message>
    <message>
        <source>Previous Bookmark</source>
        <translation>Voriges Lesezeichen</translation>
    </message>
    <message>
        <source>Open Another File Beside…</source>
        <translation>Andere Datei daneben öffnen…</translation>
    </message>
    <message>
        <source>About This Project</source>
        <translation>Über dieses Projekt</translation>
    </message>
    <message>
        <source>The project has no other file</source>
        <translation>Das Projekt hat keine andere Datei</translation>
    </message>
    <message>
        <source>The tour runs on an example, and none is installed: open or create a project and start the tour again</source>
        <translation>Der Rundgang braucht ein Beispiel, und es ist keines installiert: Öffnen oder erstellen Sie ein Projekt und starten Sie den Rundgang erneut</translation>
    </message>
    <message>
        <source>Open Another File Beside</source>
        <translation>Andere Datei daneben öffnen</translation>
    </message>
    <message>
        <source>%1 Nothing can break: the plant is only a simulation. Press Next to look around for a minute, or F5 to run it straight away.</source>
        <translation>%1 Es kann nichts kaputtgehen: Die Anlage ist nur eine Simulation. Mit „Weiter“ sehen Sie sich eine Minute lang um, mit F5 starten Sie sofort.</translation>
    </message>
    <message>
        <source>This is the project %1.</source>
        <translation>Dies ist das Projekt %1.</translation>
    </message>
    <message>
        <source>What to press</source>
        <translation>Was zu drücken ist</translation>
    </message>
    <message>
        <source>The page next to the program is the project&apos;s README: what it shows, what to press, what to watch.</source>
        <translation>Die Seite neben dem Programm ist die README des Projekts: was es anzeigt, was zu drücken und was zu überwachen ist.</translation>
    </message>
    <message>
        <source>What the operator sees. This project has no panel yet; new ones are drawn with the mouse.</source>
        <translation>Was der Bediener sieht. Dieses Projekt hat noch kein Panel; neue zeichnen Sie mit der Maus.</translation>
    </message>
    <message>
        <source>Drag the time slider, or press Alt+PgUp: code, charts and panel show the past. “Resume from Here” continues from there.</source>
        <translation>Ziehen Sie den Zeitschieber, oder drücken Sie Alt+Bild aufwärts: Code, Diagramme und Panel werden im Zustand von damals angezeigt. „Ab hier fortsetzen“ läuft von dort weiter.</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Reglereinstellung</translation>
    </message>
    <message>
        <source>Walk Through the Scan</source>
        <translation>Zyklus durchgehen</translation>
    </message>
    <message>
        <source>Step Back In</source>
        <translation>Einzelschritt zurück</translation>
    </message>
    <message>
        <source>Step Back Over</source>
        <translation>Prozedurschritt zurück</translation>
    </message>
    <message>
        <source>Step Back Out</source>
        <translation>Schritt zurück aus dem Aufruf</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Warum?</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>Warum nicht?</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>Wer hat das gesetzt?</translation>
    </message>
    <message>
        <source>What If…</source>
        <translation>Was wäre, wenn…</translation>
    </message>
    <message>
        <source>Coverage of the Recording</source>
        <translation>Abdeckung der Aufzeichnung</translation>
    </message>
    <message>
        <source>Hide the Coverage</source>
        <translation>Abdeckung ausblenden</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Slow Scan</source>
        <translation>Zeitlupe des Zyklus</translation>
    </message>
    <message>
        <source>What if? needs a running controller: a recording from a file cannot be resumed; press F5 to run the program</source>
        <translation>„Was wäre, wenn“ braucht eine laufende Steuerung: Eine Aufzeichnung aus einer Datei kann nicht fortgesetzt werden; starten Sie das Programm mit F5</translation>
    </message>
    <message>
        <source>Explain the Problem</source>
        <translation>Problem erklären</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepturen</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Benutzer und Rechte</translation>
    </message>
    <message>
        <source>Connect or Disconnect the Devices</source>
        <translation>Geräte verbinden oder trennen</translation>
    </message>
    <message>
        <source>Hide Dock Automatically</source>
        <translation>Dockfenster automatisch ausblenden</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Stepwise %1&lt;/h3&gt;&lt;p&gt;An open PLC studio: IEC 61131-3 programs as native code, every scan recorded, operator panels in many languages.&lt;/p&gt;&lt;p&gt;Licence: GPL-3.0&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Stepwise %1&lt;/h3&gt;&lt;p&gt;Ein offenes SPS-Studio: IEC-61131-3-Programme als nativer Code, jeder Zyklus aufgezeichnet, Bedienpanels in vielen Sprachen.&lt;/p&gt;&lt;p&gt;Lizenz: GPL-3.0&lt;/p&gt;</translation>
    </message>
    <message>
        <source>High-Contrast Theme</source>
        <translation>Farbschema mit hohem Kontrast</translation>
    </message>
    <message>
        <source>Attach to a Controller…</source>
        <translation>Mit einer Steuerung verbinden…</translation>
    </message>
    <message>
        <source>Detach from the Controller</source>
        <translation>Von der Steuerung trennen</translation>
    </message>
    <message>
        <source>Build a Native Program…</source>
        <translation>Natives Programm erzeugen…</translation>
    </message>
    <message>
        <source>%1 arranges the window for drawing panels</source>
        <translation>%1 ordnet das Fenster zum Zeichnen von Panels an</translation>
    </message>
    <message>
        <source>Close Other Documents</source>
        <translation>Andere Dokumente schließen</translation>
    </message>
    <message>
        <source>Fold or Unfold the Block</source>
        <translation>Block ein- oder ausklappen</translation>
    </message>
    <message>
        <source>Fold or Unfold All</source>
        <translation>Alles ein- oder ausklappen</translation>
    </message>
    <message>
        <source>Previous Pass of the Loop</source>
        <translation>Vorheriger Durchlauf der Schleife</translation>
    </message>
    <message>
        <source>Next Pass of the Loop</source>
        <translation>Nächster Durchlauf der Schleife</translation>
    </message>
    <message>
        <source>Context Menu</source>
        <translation>Kontextmenü</translation>
    </message>
    <message>
        <source>Columns…</source>
        <translation>Spalten…</translation>
    </message>
    <message>
        <source>Move Dock to the Next Side</source>
        <translation>Dockfenster zur nächsten Seite verschieben</translation>
    </message>
    <message>
        <source>Float or Dock Again</source>
        <translation>Lösen oder wieder andocken</translation>
    </message>
    <message>
        <source>Next Pane</source>
        <translation>Nächster Bereich</translation>
    </message>
    <message>
        <source>Previous Pane</source>
        <translation>Vorheriger Bereich</translation>
    </message>
    <message>
        <source>Wider Pane</source>
        <translation>Bereich verbreitern</translation>
    </message>
    <message>
        <source>Narrower Pane</source>
        <translation>Bereich verschmälern</translation>
    </message>
    <message>
        <source>Taller Pane</source>
        <translation>Bereich erhöhen</translation>
    </message>
    <message>
        <source>Shorter Pane</source>
        <translation>Bereich niedriger machen</translation>
    </message>
    <message>
        <source>Move Document Left</source>
        <translation>Dokument nach links</translation>
    </message>
    <message>
        <source>Move Document Right</source>
        <translation>Dokument nach rechts</translation>
    </message>
    <message>
        <source>Show Tooltip at the Cursor</source>
        <translation>QuickInfo am Cursor anzeigen</translation>
    </message>
    <message>
        <source>There are no columns here; go to a table or a list with columns first</source>
        <translation>Hier gibt es keine Spalten; gehen Sie zuerst in eine Tabelle oder eine Liste mit Spalten</translation>
    </message>
    <message>
        <source>Project Settings…</source>
        <translation>Projekteinstellungen…</translation>
    </message>
    <message>
        <source>Panel Themes…</source>
        <translation>Farbschemas der Panels…</translation>
    </message>
</context>
<context>
    <name>plc::app::Menu</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Debug</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Go To</source>
        <translation>Gehe zu</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Docks</source>
        <translation>Dockfenster</translation>
    </message>
    <message>
        <source>Folding</source>
        <translation>Einklappen</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
</context>
<context>
    <name>plc::app::MergeDialog</name>
    <message>
        <source>Compare %1</source>
        <translation>%1 vergleichen</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Voriger</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nächster</translation>
    </message>
    <message>
        <source>Take Over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Take Over All</source>
        <translation>Alle übernehmen</translation>
    </message>
    <message>
        <source>Here (this text is kept)</source>
        <translation>Hier (dieser Text wird behalten)</translation>
    </message>
    <message>
        <source>On disk</source>
        <translation>Auf der Platte</translation>
    </message>
    <message>
        <source>Use the Text on the Left</source>
        <translation>Den linken Text verwenden</translation>
    </message>
    <message>
        <source>No differences</source>
        <translation>Keine Unterschiede</translation>
    </message>
    <message>
        <source>Difference %1 of %2</source>
        <translation>Unterschied %1 von %2</translation>
    </message>
</context>
<context>
    <name>plc::app::NativeProgramDialog</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Erzeugen</translation>
    </message>
    <message>
        <source>Build a Native Program</source>
        <translation>Natives Programm erzeugen</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Native Program</source>
        <translation>Natives Programm</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>The program runs without Stepwise on a machine with Linux: its PLC code and a small runner in one file.</source>
        <translation>Das Programm läuft ohne Stepwise auf einem Linux-Rechner: sein SPS-Code und ein kleines Laufzeitsystem in einer Datei.</translation>
    </message>
    <message>
        <source>Building…</source>
        <translation>Wird erzeugt…</translation>
    </message>
    <message>
        <source>%1 is built</source>
        <translation>%1 wurde erzeugt</translation>
    </message>
</context>
<context>
    <name>plc::app::NewProjectDialog</name>
    <message>
        <source>Empty</source>
        <translation>Leer</translation>
    </message>
    <message>
        <source>One program in a task of 10 ms</source>
        <translation>Ein Programm in einer Task von 10&#xa0;ms</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Start, stop, a simulated motor and a test</source>
        <translation>Start, Stopp, ein simulierter Motor und ein Test</translation>
    </message>
    <message>
        <source>PID loop</source>
        <translation>PID-Regelkreis</translation>
    </message>
    <message>
        <source>A temperature loop with its plant</source>
        <translation>Ein Temperaturregelkreis mit seiner Strecke</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Ablaufsteuerung</translation>
    </message>
    <message>
        <source>Fill, mix, empty as a sequential function chart</source>
        <translation>Füllen, mischen, leeren als Schrittkette</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>My machine</source>
        <translation>Meine Maschine</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Folder of the project</source>
        <translation>Ordner des Projekts</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>In folder</source>
        <translation>Im Ordner</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>Enter a project name</source>
        <translation>Geben Sie einen Projektnamen ein</translation>
    </message>
    <message>
        <source>%1 already exists and is not empty; choose another name</source>
        <translation>%1 ist bereits vorhanden und nicht leer; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>Will be created in %1</source>
        <translation>Wird in %1 angelegt</translation>
    </message>
</context>
<context>
    <name>plc::app::NewUnitDialog</name>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Function block</source>
        <translation>Funktionsbaustein</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Funktion</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Enumeration</source>
        <translation>Enumeration</translation>
    </message>
    <message>
        <source>Interface</source>
        <translation>Schnittstelle</translation>
    </message>
    <message>
        <source>Global variables</source>
        <translation>Globale Variablen</translation>
    </message>
    <message>
        <source>Sequential function chart</source>
        <translation>Schrittkette (AS)</translation>
    </message>
    <message>
        <source>Simulation of the plant</source>
        <translation>Simulation der Anlage</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>a file of its own</source>
        <translation>eine eigene Datei</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>In</source>
        <translation>In</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>Enter a name</source>
        <translation>Geben Sie einen Namen ein</translation>
    </message>
    <message>
        <source>A name has letters, digits and _, starts with a letter and is not a keyword</source>
        <translation>Ein Name besteht aus Buchstaben, Ziffern und _, beginnt mit einem Buchstaben und ist kein Schlüsselwort</translation>
    </message>
    <message>
        <source>%1 already exists in the project; choose another name</source>
        <translation>%1 ist im Projekt bereits vorhanden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>A file %1 already exists: choose it, or another name</source>
        <translation>Die Datei %1 ist bereits vorhanden: Wählen Sie sie oder einen anderen Namen</translation>
    </message>
    <message>
        <source>Program as a ladder diagram</source>
        <translation>Programm als Kontaktplan</translation>
    </message>
    <message>
        <source>Program as a function block diagram</source>
        <translation>Programm als Funktionsplan</translation>
    </message>
</context>
<context>
    <name>plc::app::PanelFiles</name>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Panel %1</source>
        <translation>Panel %1</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepturen</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Benutzer und Rechte</translation>
    </message>
    <message>
        <source>%1 is gone or cannot be reached: what is open stays here, and Save All writes it again</source>
        <translation>%1 ist verschwunden oder nicht erreichbar: Was geöffnet ist, bleibt hier, und „Alle speichern“ schreibt es neu</translation>
    </message>
</context>
<context>
    <name>plc::app::ProblemsView</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Show errors</source>
        <translation>Fehler anzeigen</translation>
    </message>
    <message>
        <source>Show warnings</source>
        <translation>Warnungen anzeigen</translation>
    </message>
    <message>
        <source>Show notes</source>
        <translation>Hinweise anzeigen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter of the problem list</source>
        <translation>Filter der Problemliste</translation>
    </message>
</context>
<context>
    <name>plc::app::ProjectSettingsDialog</name>
    <message>
        <source>Project Settings</source>
        <translation>Projekteinstellungen</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Bytes: %MW1 is bytes 1 and 2 (TwinCAT)</source>
        <translation>Byte: %MW1 ist Byte 1 und 2 (TwinCAT)</translation>
    </message>
    <message>
        <source>Words: %MW1 is the second word (CODESYS)</source>
        <translation>Wörter: %MW1 ist das zweite Wort (CODESYS)</translation>
    </message>
    <message>
        <source> bytes</source>
        <translation> Bytes</translation>
    </message>
    <message>
        <source>None (no __NEW)</source>
        <translation>Keiner (kein __NEW)</translation>
    </message>
    <message>
        <source>What the number of a memory address counts</source>
        <translation>Was die Nummer einer Speicheradresse zählt</translation>
    </message>
    <message>
        <source>What the bytes of STRING values stand for</source>
        <translation>Wofür die Bytes von STRING-Werten stehen</translation>
    </message>
    <message>
        <source>What {IF defined (…)} in the sources finds, separated by commas</source>
        <translation>Was {IF defined (…)} in den Quelltexten findet, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>The part of the controller&apos;s memory that __NEW takes objects from</source>
        <translation>Der Teil des Steuerungsspeichers, aus dem __NEW Objekte nimmt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Addressing</source>
        <translation>Adressierung</translation>
    </message>
    <message>
        <source>Encoding of STRING</source>
        <translation>Codierung von STRING</translation>
    </message>
    <message>
        <source>Defined symbols</source>
        <translation>Definierte Symbole</translation>
    </message>
    <message>
        <source>Memory for __NEW</source>
        <translation>Speicher für __NEW</translation>
    </message>
    <message>
        <source>Date and time of the first scan</source>
        <translation>Datum und Uhrzeit des ersten Zyklus</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panels</translation>
    </message>
    <message>
        <source>The first panel</source>
        <translation>Das erste Panel</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>Allow pictures outside the project folder</source>
        <translation>Bilder außerhalb des Projektordners zulassen</translation>
    </message>
    <message>
        <source>The panel that is drawn around all others</source>
        <translation>Das Panel, das um alle anderen gezeichnet wird</translation>
    </message>
    <message>
        <source>A variable with the operator&apos;s language; panels read and write it</source>
        <translation>Eine Variable mit der Sprache des Bedieners; Panels lesen und schreiben sie</translation>
    </message>
    <message>
        <source>Start panel</source>
        <translation>Startpanel</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Schriftart</translation>
    </message>
    <message>
        <source>Language variable</source>
        <translation>Sprachvariable</translation>
    </message>
    <message>
        <source>A project needs a name.</source>
        <translation>Ein Projekt braucht einen Namen.</translation>
    </message>
    <message>
        <source>“%1” is not a date and time; write for example DT#2026-01-31-06:00:00.</source>
        <translation>„%1“ ist kein Datum mit Uhrzeit; schreiben Sie zum Beispiel DT#2026-01-31-06:00:00.</translation>
    </message>
</context>
<context>
    <name>plc::app::ProjectTree</name>
    <message>
        <source>Source of %1 with the Values of %2</source>
        <translation>Quelltext von %1 mit den Werten von %2</translation>
    </message>
    <message>
        <source>Values of Instance</source>
        <translation>Werte der Instanz</translation>
    </message>
    <message>
        <source>More: choose in the watch</source>
        <translation>Weitere: in der Überwachung wählen</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter of the project tree</source>
        <translation>Filter des Projektbaums</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Schrittkette</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Bausteine</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>Funktionen</translation>
    </message>
    <message>
        <source>Types</source>
        <translation>Typen</translation>
    </message>
    <message>
        <source>Globals</source>
        <translation>Globale Variablen</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tasks</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panels</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Traces</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Tests</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliotheken</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Neu…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Löschen…</translation>
    </message>
    <message>
        <source>Libraries…</source>
        <translation>Bibliotheken…</translation>
    </message>
    <message>
        <source>Run Tests</source>
        <translation>Tests ausführen</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Zur Überwachung hinzufügen</translation>
    </message>
    <message>
        <source>Arrange by file</source>
        <translation>Nach Dateien ordnen</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepturen</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Benutzer und Rechte</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Panel Themes</source>
        <translation>Farbschemas der Panels</translation>
    </message>
</context>
<context>
    <name>plc::app::RenameDialog</name>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>New name of %1, in the whole project:</source>
        <translation>Neuer Name von %1, im ganzen Projekt:</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Places that change</source>
        <translation>Stellen, die sich ändern</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) change:</source>
        <translation>
            <numerusform>%n Stelle ändert sich:</numerusform>
            <numerusform>%n Stellen ändern sich:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::app::RunsMenu</name>
    <message>
        <source>Earlier Runs</source>
        <translation>Frühere Läufe</translation>
    </message>
    <message>
        <source>%1, ended by a fault, %2</source>
        <translation>%1, durch einen Fehler beendet, %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The last run is being written…</source>
        <translation>Der letzte Lauf wird geschrieben…</translation>
    </message>
    <message>
        <source>No run has ended yet</source>
        <translation>Noch kein Lauf beendet</translation>
    </message>
</context>
<context>
    <name>plc::app::SearchView</name>
    <message>
        <source>Find in all files</source>
        <translation>In allen Dateien suchen</translation>
    </message>
    <message>
        <source>Text to find in all files</source>
        <translation>In allen Dateien gesuchter Text</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Ersetzen durch</translation>
    </message>
    <message>
        <source>Replacement in all files</source>
        <translation>Ersatztext in allen Dateien</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>Regulärer Ausdruck</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Groß-/Kleinschreibung</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>Alle ersetzen</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwendung</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Search results</source>
        <translation>Suchergebnisse</translation>
    </message>
    <message>
        <source>Invalid regular expression: %1</source>
        <translation>Ungültiger regulärer Ausdruck: %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n Stelle</numerusform>
            <numerusform>%n Stellen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n Datei</numerusform>
            <numerusform>%n Dateien</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced</source>
        <translation>
            <numerusform>%n Stelle ersetzt</numerusform>
            <numerusform>%n Stellen ersetzt</numerusform>
        </translation>
    </message>
    <message>
        <source>declared</source>
        <translation>deklariert</translation>
    </message>
    <message>
        <source>read, write</source>
        <translation>gelesen, geschrieben</translation>
    </message>
    <message>
        <source>write</source>
        <translation>geschrieben</translation>
    </message>
    <message>
        <source>read</source>
        <translation>gelesen</translation>
    </message>
    <message>
        <source>%1: %2 read, %3 written</source>
        <translation>%1: %2-mal gelesen, %3-mal geschrieben</translation>
    </message>
    <message>
        <source>Searching all files…</source>
        <translation>Alle Dateien werden durchsucht…</translation>
    </message>
    <message>
        <source>Cancelled; so far: %1 in %2</source>
        <translation>Abgebrochen; bis dahin: %1 in %2</translation>
    </message>
    <message>
        <source>Replacing in all files…</source>
        <translation>In allen Dateien wird ersetzt…</translation>
    </message>
    <message>
        <source>Cancelled; nothing was replaced</source>
        <translation>Abgebrochen; nichts wurde ersetzt</translation>
    </message>
</context>
<context>
    <name>plc::app::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Editor</source>
        <translation>Editor</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Ausführung</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Language of the studio</source>
        <translation>Sprache des Studios</translation>
    </message>
    <message>
        <source>Indentation</source>
        <translation>Einrückung</translation>
    </message>
    <message>
        <source>Write keywords in capitals while typing</source>
        <translation>Schlüsselwörter beim Tippen in Großbuchstaben umwandeln</translation>
    </message>
    <message>
        <source>Close blocks with Enter (IF … END_IF)</source>
        <translation>Blöcke mit Enter schließen (IF … END_IF)</translation>
    </message>
    <message>
        <source>Show online values in the text</source>
        <translation>Online-Werte im Text anzeigen</translation>
    </message>
    <message>
        <source>Format when saving</source>
        <translation>Beim Speichern formatieren</translation>
    </message>
    <message>
        <source>Apply an online change when saving</source>
        <translation>Beim Speichern Online-Change ausführen</translation>
    </message>
    <message>
        <source>Memory for the recording of every scan</source>
        <translation>Speicher für die Aufzeichnung aller Zyklen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Another action has the same shortcut</source>
        <translation>Ein anderer Befehl hat dasselbe Tastenkürzel</translation>
    </message>
    <message>
        <source>Shortcut of %1</source>
        <translation>Tastenkürzel von %1</translation>
    </message>
    <message>
        <source>Filter of the actions</source>
        <translation>Filter der Befehle</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Standard wiederherstellen</translation>
    </message>
    <message>
        <source>%1 is now assigned to “%2” instead of “%3”.</source>
        <translation>%1 ist jetzt „%2“ statt „%3“ zugewiesen.</translation>
    </message>
    <message>
        <source>none is kept</source>
        <translation>keine wird aufbewahrt</translation>
    </message>
    <message>
        <source>Disk space for the recordings of earlier runs, per project</source>
        <translation>Speicherplatz für die Aufzeichnungen früherer Läufe, je Projekt</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
</context>
<context>
    <name>plc::app::SideBars</name>
    <message>
        <source>Hide Automatically</source>
        <translation>Automatisch ausblenden</translation>
    </message>
    <message>
        <source>Keep Open</source>
        <translation>Offen halten</translation>
    </message>
    <message>
        <source>Hidden Docks</source>
        <translation>Ausgeblendete Dockfenster</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>plc::app::StPage</name>
    <message>
        <source>This file is read-only on disk. Saving asks before it replaces it.</source>
        <translation>Diese Datei ist schreibgeschützt. Vor dem Ersetzen wird beim Speichern gefragt.</translation>
    </message>
    <message>
        <source>Make Writable</source>
        <translation>Schreibschutz aufheben</translation>
    </message>
    <message>
        <source>Close this side</source>
        <translation>Diese Seite schließen</translation>
    </message>
</context>
<context>
    <name>plc::app::StartPage</name>
    <message>
        <source>Write, run and watch PLC programs. Every scan is recorded; time runs backwards, too.</source>
        <translation>SPS-Programme schreiben, ausführen und überwachen. Jeder Zyklus wird aufgezeichnet; die Zeit läuft auch rückwärts.</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Zuletzt verwendete Projekte</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>Neues Projekt…</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>Projekt öffnen…</translation>
    </message>
    <message>
        <source>Take the Tour</source>
        <translation>Rundgang machen</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt verwendet</translation>
    </message>
    <message>
        <source>Examples: open one and press Run</source>
        <translation>Beispiele: eines öffnen und Start drücken</translation>
    </message>
    <message>
        <source>No examples were found in:
%1

Install the examples, or set the environment variable STEPWISE_EXAMPLES to the folder that contains them, and start Stepwise again.</source>
        <translation>Keine Beispiele gefunden in:
%1

Installieren Sie die Beispiele oder setzen Sie die Umgebungsvariable STEPWISE_EXAMPLES auf den Ordner, der sie enthält, und starten Sie Stepwise neu.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open a Fresh Copy</source>
        <translation>Neue Kopie öffnen</translation>
    </message>
</context>
<context>
    <name>plc::app::TestView</name>
    <message>
        <source>Run all tests</source>
        <translation>Alle Tests ausführen</translation>
    </message>
    <message>
        <source>Run the selected tests</source>
        <translation>Die ausgewählten Tests ausführen</translation>
    </message>
    <message>
        <source>Run the failed tests</source>
        <translation>Die fehlgeschlagenen Tests ausführen</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Tests</translation>
    </message>
    <message>
        <source>%1 passed, %2 failed</source>
        <translation>%1 bestanden, %2 fehlgeschlagen</translation>
    </message>
    <message>
        <source>not run yet</source>
        <translation>noch nicht gelaufen</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>Show the Recording of the Failure</source>
        <translation>Aufzeichnung des Fehlschlags anzeigen</translation>
    </message>
    <message>
        <source>Show what the tests cover</source>
        <translation>Anzeigen, was die Tests abdecken</translation>
    </message>
</context>
<context>
    <name>plc::app::TextPage</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
</context>
<context>
    <name>plc::app::Tour</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
</context>
<context>
    <name>plc::app::UnitCommands</name>
    <message>
        <source>The program is running. To an online change the new name is another variable: it begins with its initial value.</source>
        <translation>Das Programm läuft. Für einen Online-Change ist der neue Name eine andere Variable: Sie beginnt mit ihrem Initialwert.</translation>
    </message>
    <message>
        <source>Go to Line</source>
        <translation>Gehe zu Zeile</translation>
    </message>
    <message>
        <source>Line (1 to %1)</source>
        <translation>Zeile (1 bis %1)</translation>
    </message>
    <message>
        <source>Nothing is declared under this name; declare it or check the name</source>
        <translation>Unter diesem Namen ist nichts deklariert; deklarieren Sie ihn oder prüfen Sie ihn</translation>
    </message>
    <message>
        <source>Put the cursor into a unit that is written in ST or IL</source>
        <translation>Setzen Sie den Cursor in einen ST- oder AWL-Baustein</translation>
    </message>
    <message>
        <source>The text has changed meanwhile</source>
        <translation>Der Text hat sich inzwischen geändert</translation>
    </message>
    <message>
        <source>There is no name at the cursor; put the cursor on one</source>
        <translation>Am Cursor steht kein Name; setzen Sie den Cursor auf einen</translation>
    </message>
    <message>
        <source>The project is still being checked; try again in a moment</source>
        <translation>Das Projekt wird noch geprüft; versuchen Sie es gleich noch einmal</translation>
    </message>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s); the panels are saved, the sources not yet</source>
        <translation>
            <numerusform>%1 heißt jetzt %2, an %n Stelle; die Panels sind gespeichert, die Quelltexte noch nicht</numerusform>
            <numerusform>%1 heißt jetzt %2, an %n Stellen; die Panels sind gespeichert, die Quelltexte noch nicht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s)</source>
        <translation>
            <numerusform>%1 heißt jetzt %2, an %n Stelle</numerusform>
            <numerusform>%1 heißt jetzt %2, an %n Stellen</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>%1 löschen?</translation>
    </message>
    <message numerus="yes">
        <source>It is used in %n other place(s).</source>
        <translation>
            <numerusform>Verwendet an %n weiteren Stelle.</numerusform>
            <numerusform>Verwendet an %n weiteren Stellen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete and Comment Out the Uses</source>
        <translation>Löschen, Verwendungen auskommentieren</translation>
    </message>
    <message>
        <source>Show the Uses</source>
        <translation>Verwendungen anzeigen</translation>
    </message>
    <message>
        <source>%1 is not a source of this project; open the project that contains it</source>
        <translation>%1 ist keine Quelldatei dieses Projekts; öffnen Sie das Projekt, das sie enthält</translation>
    </message>
</context>
<context>
    <name>plc::app::WhatIfDialog</name>
    <message>
        <source>What If?</source>
        <translation>Was wäre, wenn?</translation>
    </message>
    <message>
        <source>The controller goes back to the scan shown and continues from there with these values. The trace draws what really happened behind the new curves.</source>
        <translation>Die Steuerung geht zum angezeigten Zyklus zurück und läuft von dort mit diesen Werten weiter. Der Trace zeichnet dahinter, was tatsächlich geschah.</translation>
    </message>
    <message>
        <source>A variable, such as Main.level</source>
        <translation>Eine Variable, zum Beispiel Main.level</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>War</translation>
    </message>
    <message>
        <source>Instead</source>
        <translation>Stattdessen</translation>
    </message>
    <message>
        <source>Values to change</source>
        <translation>Zu ändernde Werte</translation>
    </message>
    <message>
        <source>Run from Here</source>
        <translation>Ab hier ausführen</translation>
    </message>
    <message>
        <source>%1 has no value in this scan; choose another variable</source>
        <translation>%1 hat in diesem Zyklus keinen Wert; wählen Sie eine andere Variable</translation>
    </message>
    <message>
        <source>Enter a different value for at least one variable</source>
        <translation>Geben Sie mindestens einer Variablen einen anderen Wert</translation>
    </message>
</context>
<context>
    <name>plc::editor::BreakpointView</name>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Hit count</source>
        <translation>Treffer</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>Instanz</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>Haltepunkte</translation>
    </message>
    <message>
        <source>Remove selected</source>
        <translation>Auswahl entfernen</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>The running program has no code at or below this line; choose a line with a statement</source>
        <translation>Das laufende Programm hat in dieser Zeile und darunter keinen Code; wählen Sie eine Zeile mit einer Anweisung</translation>
    </message>
</context>
<context>
    <name>plc::editor::CallPathView</name>
    <message>
        <source>Unit</source>
        <translation>Baustein</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>Instanz</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Call stack</source>
        <translation>Aufrufliste</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Values of the frame</source>
        <translation>Werte des Aufrufs</translation>
    </message>
    <message>
        <source>This scan has run to its end: it has no call stack.</source>
        <translation>Dieser Zyklus ist abgeschlossen: Er hat keine Aufrufliste.</translation>
    </message>
</context>
<context>
    <name>plc::editor::ChartView</name>
    <message>
        <source>Sequential function chart</source>
        <translation>Schrittkette</translation>
    </message>
    <message>
        <source>Insert a step after it (Ins)</source>
        <translation>Schritt danach einfügen (Einfg)</translation>
    </message>
    <message>
        <source>Insert an alternative branch</source>
        <translation>Alternativzweig einfügen</translation>
    </message>
    <message>
        <source>Insert a simultaneous branch</source>
        <translation>Parallelzweig einfügen</translation>
    </message>
    <message>
        <source>Add an action</source>
        <translation>Aktion hinzufügen</translation>
    </message>
    <message>
        <source>Edit name or condition (F2)</source>
        <translation>Name oder Bedingung bearbeiten (F2)</translation>
    </message>
    <message>
        <source>Delete (Del)</source>
        <translation>Löschen (Entf)</translation>
    </message>
    <message>
        <source>The unit %1 is no longer in the text; undo the change or close this view</source>
        <translation>Der Baustein %1 ist im Text nicht mehr vorhanden; machen Sie die Änderung rückgängig oder schließen Sie diese Ansicht</translation>
    </message>
    <message>
        <source>The text has errors: this is the last valid drawing</source>
        <translation>Der Text hat Fehler: Dies ist die letzte gültige Zeichnung</translation>
    </message>
    <message>
        <source>Select the step from which the branch goes out</source>
        <translation>Wählen Sie den Schritt, von dem der Zweig ausgeht</translation>
    </message>
    <message>
        <source>Select the transition after which the steps run at the same time</source>
        <translation>Wählen Sie die Transition, nach der die Schritte gleichzeitig laufen</translation>
    </message>
    <message>
        <source>Select the step that gets the action</source>
        <translation>Wählen Sie den Schritt, der die Aktion bekommt</translation>
    </message>
    <message>
        <source>Insert a Step After It</source>
        <translation>Schritt danach einfügen</translation>
    </message>
    <message>
        <source>Insert an Alternative Branch</source>
        <translation>Alternativzweig einfügen</translation>
    </message>
    <message>
        <source>Insert a Simultaneous Branch</source>
        <translation>Parallelzweig einfügen</translation>
    </message>
    <message>
        <source>Add an Action</source>
        <translation>Aktion hinzufügen</translation>
    </message>
    <message>
        <source>Set as Initial Step</source>
        <translation>Zum Initialschritt machen</translation>
    </message>
    <message>
        <source>Force the Step Active</source>
        <translation>Schritt aktiv forcen</translation>
    </message>
    <message>
        <source>Release the Step</source>
        <translation>Forcen des Schritts aufheben</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Haltepunkt umschalten</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Move Left</source>
        <translation>Nach links</translation>
    </message>
    <message>
        <source>Move Right</source>
        <translation>Nach rechts</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Branch to the left</source>
        <translation>Zweig nach links</translation>
    </message>
    <message>
        <source>Branch to the right</source>
        <translation>Zweig nach rechts</translation>
    </message>
    <message>
        <source>%1 after this transition</source>
        <translation>%1 nach dieser Transition</translation>
    </message>
    <message>
        <source>leads to %1</source>
        <translation>führt zu %1</translation>
    </message>
    <message>
        <source>further up</source>
        <translation>weiter nach oben</translation>
    </message>
    <message>
        <source>further down</source>
        <translation>weiter nach unten</translation>
    </message>
    <message>
        <source>%1 in step %2</source>
        <translation>%1 in Schritt %2</translation>
    </message>
    <message>
        <source>A condition is a BOOL; add a comparison</source>
        <translation>Eine Bedingung ist ein BOOL; ergänzen Sie einen Vergleich</translation>
    </message>
    <message>
        <source>qualifier</source>
        <translation>Bestimmungszeichen</translation>
    </message>
    <message>
        <source>action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>To the enclosing chart (Backspace)</source>
        <translation>Zur übergeordneten Schrittkette (Rücktaste)</translation>
    </message>
    <message>
        <source>Breakpoint: stops when the step becomes active or the transition is taken (F9)</source>
        <translation>Haltepunkt: hält, wenn der Schritt aktiv wird oder die Transition schaltet (F9)</translation>
    </message>
    <message>
        <source>Force the step active</source>
        <translation>Schritt aktiv forcen</translation>
    </message>
    <message>
        <source>Release the step</source>
        <translation>Forcen des Schritts aufheben</translation>
    </message>
    <message>
        <source>%1 is a variable: it has no body</source>
        <translation>%1 ist eine Variable: Sie hat keinen Rumpf</translation>
    </message>
    <message>
        <source>Select a step or a transition</source>
        <translation>Wählen Sie einen Schritt oder eine Transition</translation>
    </message>
    <message>
        <source>Select a step</source>
        <translation>Wählen Sie einen Schritt</translation>
    </message>
    <message>
        <source>Open Its Chart or Text</source>
        <translation>Schrittkette oder Text öffnen</translation>
    </message>
    <message>
        <source>Priority…</source>
        <translation>Priorität…</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Delete the Whole Branch</source>
        <translation>Ganzen Zweig löschen</translation>
    </message>
    <message>
        <source>Select what is to be copied</source>
        <translation>Wählen Sie aus, was kopiert werden soll</translation>
    </message>
    <message>
        <source>Select what is to be cut</source>
        <translation>Wählen Sie aus, was ausgeschnitten werden soll</translation>
    </message>
    <message>
        <source>The clipboard contains no step, action or transition; copy one first</source>
        <translation>Die Zwischenablage enthält keinen Schritt, keine Aktion und keine Transition; kopieren Sie zuerst etwas davon</translation>
    </message>
    <message>
        <source>Select the step or transition to paste after</source>
        <translation>Wählen Sie einen Schritt oder eine Transition; eingefügt wird danach</translation>
    </message>
    <message>
        <source>Select the transition that gets the condition</source>
        <translation>Wählen Sie die Transition, die die Bedingung erhält</translation>
    </message>
    <message>
        <source>Start a Chart</source>
        <translation>Schrittkette beginnen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>%1 has no chart yet. A chart starts with an initial step; more steps are inserted after it with Ins, and F2 edits names and conditions.</source>
        <translation>%1 hat noch keine Schrittkette. Eine Schrittkette beginnt mit einem Initialschritt; weitere Schritte werden mit Einfg dahinter eingefügt, F2 bearbeitet Namen und Bedingungen.</translation>
    </message>
    <message>
        <source>%1 is not a chart: its body has statements. A chart can be started in a program or function block whose body is empty.</source>
        <translation>%1 ist keine Schrittkette: Der Rumpf enthält Anweisungen. Eine Schrittkette kann in einem Programm oder Funktionsbaustein mit leerem Rumpf begonnen werden.</translation>
    </message>
</context>
<context>
    <name>plc::editor::DeclarationTable</name>
    <message>
        <source>Section</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Initial value</source>
        <translation>Initialwert</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Declarations</source>
        <translation>Deklarationen</translation>
    </message>
    <message>
        <source>Add a variable</source>
        <translation>Variable hinzufügen</translation>
    </message>
    <message>
        <source>Remove the selected variables</source>
        <translation>Gewählte Variablen entfernen</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Nach unten</translation>
    </message>
</context>
<context>
    <name>plc::editor::EventLog</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>PLC time</source>
        <translation>SPS-Zeit</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all rows</source>
        <translation>Die gewählten Zeilen kopieren, sonst alle</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Only faults and rejections</source>
        <translation>Nur Fehler und Ablehnungen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter of the events</source>
        <translation>Filter der Ereignisse</translation>
    </message>
    <message>
        <source>Step: %1</source>
        <translation>Schritt: %1</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>event at file:line</comment>
        <translation>%1 bei %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::FindBar</name>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Text to find</source>
        <translation>Gesuchter Text</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Ersetzen durch</translation>
    </message>
    <message>
        <source>Replacement</source>
        <translation>Ersatztext</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Groß-/Kleinschreibung</translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>Ganze Wörter</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>Regulärer Ausdruck</translation>
    </message>
    <message>
        <source>Previous (Shift+Enter)</source>
        <translation>Voriges (Umschalt+Enter)</translation>
    </message>
    <message>
        <source>Next (Enter)</source>
        <translation>Nächstes (Enter)</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>Alle ersetzen</translation>
    </message>
    <message numerus="yes">
        <source>%n replaced</source>
        <translation>
            <numerusform>%n ersetzt</numerusform>
            <numerusform>%n ersetzt</numerusform>
        </translation>
    </message>
    <message>
        <source>invalid regular expression</source>
        <translation>ungültiger regulärer Ausdruck</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n gefunden</numerusform>
            <numerusform>%n gefunden</numerusform>
        </translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
</context>
<context>
    <name>plc::editor::ForceView</name>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Forced value</source>
        <translation>Geforcter Wert</translation>
    </message>
    <message>
        <source>Forced variables</source>
        <translation>Geforcte Variablen</translation>
    </message>
    <message>
        <source>Release selected</source>
        <translation>Forcen der Auswahl aufheben</translation>
    </message>
    <message>
        <source>Release all</source>
        <translation>Forcen für alle aufheben</translation>
    </message>
</context>
<context>
    <name>plc::editor::GraphView</name>
    <message>
        <source>Show all</source>
        <translation>Alles anzeigen</translation>
    </message>
    <message>
        <source>Export as SVG, PNG or PDF…</source>
        <translation>Als SVG, PNG oder PDF exportieren…</translation>
    </message>
    <message>
        <source>Export the Drawing</source>
        <translation>Zeichnung exportieren</translation>
    </message>
    <message>
        <source>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</source>
        <translation>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be written; choose a variable of the program</source>
        <translation>%1 kann nicht geschrieben werden; wählen Sie eine Variable des Programms</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Drucken…</translation>
    </message>
    <message>
        <source>Fix the text first: this is the last valid drawing</source>
        <translation>Beheben Sie zuerst die Fehler im Text: Dies ist die letzte gültige Zeichnung</translation>
    </message>
</context>
<context>
    <name>plc::editor::LadderView</name>
    <message>
        <source>Ladder or function block diagram</source>
        <translation>Kontaktplan oder Funktionsplan</translation>
    </message>
    <message>
        <source>Insert a rung below (Ctrl+T)</source>
        <translation>Netzwerk darunter einfügen (Strg+T)</translation>
    </message>
    <message>
        <source>Insert a contact on the left (Ctrl+K)</source>
        <translation>Kontakt links einfügen (Strg+K)</translation>
    </message>
    <message>
        <source>Insert a contact on the right (Ctrl+D)</source>
        <translation>Kontakt rechts einfügen (Strg+D)</translation>
    </message>
    <message>
        <source>Insert a parallel contact (Ctrl+R)</source>
        <translation>Parallelen Kontakt einfügen (Strg+R)</translation>
    </message>
    <message>
        <source>Insert a coil (Ctrl+A)</source>
        <translation>Spule einfügen (Strg+A)</translation>
    </message>
    <message>
        <source>Insert a function block (Ctrl+B)</source>
        <translation>Funktionsbaustein einfügen (Strg+B)</translation>
    </message>
    <message>
        <source>Edit (F2)</source>
        <translation>Bearbeiten (F2)</translation>
    </message>
    <message>
        <source>Delete (Del)</source>
        <translation>Löschen (Entf)</translation>
    </message>
    <message>
        <source>Breakpoint on the rung (F9)</source>
        <translation>Haltepunkt am Netzwerk (F9)</translation>
    </message>
    <message>
        <source>Show as a function block diagram</source>
        <translation>Als Funktionsplan anzeigen</translation>
    </message>
    <message>
        <source>Show as a ladder diagram</source>
        <translation>Als Kontaktplan anzeigen</translation>
    </message>
    <message>
        <source>%1 is no longer in the text; undo the change or close this view</source>
        <translation>%1 ist im Text nicht mehr vorhanden; machen Sie die Änderung rückgängig oder schließen Sie diese Ansicht</translation>
    </message>
    <message>
        <source>The text has errors: this is the last valid drawing</source>
        <translation>Der Text hat Fehler: Dies ist die letzte gültige Zeichnung</translation>
    </message>
    <message>
        <source>Fix the text first: this is the last valid drawing</source>
        <translation>Beheben Sie zuerst die Fehler im Text: Dies ist die letzte gültige Zeichnung</translation>
    </message>
    <message>
        <source>Select a rung</source>
        <translation>Wählen Sie ein Netzwerk</translation>
    </message>
    <message>
        <source>Select a coil</source>
        <translation>Wählen Sie eine Spule</translation>
    </message>
    <message>
        <source>Select a contact, a coil or a pin with a variable</source>
        <translation>Wählen Sie einen Kontakt, eine Spule oder einen Anschluss mit einer Variablen</translation>
    </message>
    <message>
        <source>The rung has no contact yet</source>
        <translation>Das Netzwerk hat noch keinen Kontakt</translation>
    </message>
    <message>
        <source>Select the rung that gets the block</source>
        <translation>Wählen Sie das Netzwerk für den Baustein</translation>
    </message>
    <message>
        <source>block</source>
        <translation>Baustein</translation>
    </message>
    <message>
        <source>Contact on the left; at a coil, the last contact</source>
        <translation>Kontakt links; an einer Spule der letzte Kontakt</translation>
    </message>
    <message>
        <source>Contact on the right</source>
        <translation>Kontakt rechts</translation>
    </message>
    <message>
        <source>Parallel contact</source>
        <translation>Paralleler Kontakt</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>Spule</translation>
    </message>
    <message>
        <source>Function block in the rung</source>
        <translation>Funktionsbaustein im Netzwerk</translation>
    </message>
    <message>
        <source>Rung above</source>
        <translation>Netzwerk darüber</translation>
    </message>
    <message>
        <source>Rung below</source>
        <translation>Netzwerk darunter</translation>
    </message>
    <message>
        <source>Negate a contact, a coil or a pin</source>
        <translation>Kontakt, Spule oder Anschluss negieren</translation>
    </message>
    <message>
        <source>Coil: normal, set, reset</source>
        <translation>Spule: normal, setzen, rücksetzen</translation>
    </message>
    <message>
        <source>Comment of the rung</source>
        <translation>Kommentar des Netzwerks</translation>
    </message>
    <message>
        <source>Edit what is selected (or Enter)</source>
        <translation>Auswahl bearbeiten (oder Enter)</translation>
    </message>
    <message>
        <source>Delete what is selected</source>
        <translation>Auswahl löschen</translation>
    </message>
    <message>
        <source>Breakpoint on the rung</source>
        <translation>Haltepunkt am Netzwerk</translation>
    </message>
    <message>
        <source>This list</source>
        <translation>Diese Liste</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Select the next part; Up and Down also the next rung</source>
        <translation>Nächsten Teil auswählen; Auf und Ab auch das nächste Netzwerk</translation>
    </message>
    <message>
        <source>Move the rung up; with Down, down</source>
        <translation>Netzwerk nach oben schieben; mit Ab nach unten</translation>
    </message>
    <message>
        <source>Typed before a name: a negated contact</source>
        <translation>Vor einem Namen getippt: ein negierter Kontakt</translation>
    </message>
    <message>
        <source>Keys in Ladder and Function Block Diagrams</source>
        <translation>Tasten in Kontakt- und Funktionsplänen</translation>
    </message>
    <message>
        <source>Insert a Rung Above</source>
        <translation>Netzwerk darüber einfügen</translation>
    </message>
    <message>
        <source>Insert a Rung Below</source>
        <translation>Netzwerk darunter einfügen</translation>
    </message>
    <message>
        <source>Insert a Contact</source>
        <translation>Kontakt einfügen</translation>
    </message>
    <message>
        <source>Insert a Parallel Contact</source>
        <translation>Parallelen Kontakt einfügen</translation>
    </message>
    <message>
        <source>Insert a Coil</source>
        <translation>Spule einfügen</translation>
    </message>
    <message>
        <source>Insert a Function Block…</source>
        <translation>Funktionsbaustein einfügen…</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Comment…</source>
        <translation>Kommentar…</translation>
    </message>
    <message>
        <source>Negate</source>
        <translation>Negieren</translation>
    </message>
    <message>
        <source>Set or Reset</source>
        <translation>Setzen oder rücksetzen</translation>
    </message>
    <message>
        <source>Move the Rung Up</source>
        <translation>Netzwerk nach oben</translation>
    </message>
    <message>
        <source>Move the Rung Down</source>
        <translation>Netzwerk nach unten</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Force TRUE</source>
        <translation>TRUE forcen</translation>
    </message>
    <message>
        <source>Force FALSE</source>
        <translation>FALSE forcen</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Forcen aufheben</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Haltepunkt umschalten</translation>
    </message>
    <message>
        <source>Contacts as Bars (IEC 61131-3, ANSI)</source>
        <translation>Kontakte als Striche (IEC 61131-3, ANSI)</translation>
    </message>
    <message>
        <source>Contacts as in Circuit Diagrams (IEC 60617)</source>
        <translation>Kontakte wie in Stromlaufplänen (IEC 60617)</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>Addresses</source>
        <translation>Adressen</translation>
    </message>
    <message>
        <source>Names and Addresses</source>
        <translation>Namen und Adressen</translation>
    </message>
    <message>
        <source>Comments of the Variables</source>
        <translation>Kommentare der Variablen</translation>
    </message>
    <message>
        <source>Comments of the Rungs</source>
        <translation>Kommentare der Netzwerke</translation>
    </message>
    <message>
        <source>High Contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Was angezeigt wird</translation>
    </message>
    <message>
        <source>type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Rename the variable everywhere</source>
        <translation>Variable überall umbenennen</translation>
    </message>
    <message>
        <source>Go to the definition</source>
        <translation>Gehe zur Definition</translation>
    </message>
    <message>
        <source>References to the variable</source>
        <translation>Referenzen der Variablen</translation>
    </message>
    <message>
        <source>Quick fix</source>
        <translation>Schnellkorrektur</translation>
    </message>
    <message>
        <source>Bookmark on the rung</source>
        <translation>Lesezeichen am Netzwerk</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Referenzen suchen</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Gehe zur Definition</translation>
    </message>
    <message>
        <source>Quick Fix</source>
        <translation>Schnellkorrektur</translation>
    </message>
    <message>
        <source>Write TRUE</source>
        <translation>TRUE schreiben</translation>
    </message>
    <message>
        <source>Write FALSE</source>
        <translation>FALSE schreiben</translation>
    </message>
    <message>
        <source>Toggle Bookmark</source>
        <translation>Lesezeichen umschalten</translation>
    </message>
    <message>
        <source>Contact Here</source>
        <translation>Kontakt hier</translation>
    </message>
    <message>
        <source>Negated Contact Here</source>
        <translation>Negierter Kontakt hier</translation>
    </message>
    <message>
        <source>Function Block Here</source>
        <translation>Funktionsbaustein hier</translation>
    </message>
    <message>
        <source>Move the contact left; with Right, right</source>
        <translation>Kontakt nach links schieben; mit Rechts nach rechts</translation>
    </message>
    <message>
        <source>Select a contact; a rung moves up and down</source>
        <translation>Wählen Sie einen Kontakt; ein Netzwerk wird nach oben und unten verschoben</translation>
    </message>
</context>
<context>
    <name>plc::editor::RunArchive</name>
    <message>
        <source>The recording of the last run was not kept: %1</source>
        <translation>Die Aufzeichnung des letzten Laufs wurde nicht aufbewahrt: %1</translation>
    </message>
</context>
<context>
    <name>plc::editor::RunControl</name>
    <message>
        <source>Built in %1 ms</source>
        <translation>Übersetzt in %1&#xa0;ms</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s): the program was not built</source>
        <translation>
            <numerusform>%n Fehler: Das Programm wurde nicht übersetzt</numerusform>
            <numerusform>%n Fehler: Das Programm wurde nicht übersetzt</numerusform>
        </translation>
    </message>
    <message>
        <source>Online change: %1 kept, %2 new, %3 lost</source>
        <translation>Online-Change: %1 Variablen erhalten, %2 neu, %3 entfernt</translation>
    </message>
    <message>
        <source>The change waits for the end of the scan</source>
        <translation>Die Änderung wartet auf das Zyklusende</translation>
    </message>
    <message>
        <source>The program has errors; the controller continues with the old program</source>
        <translation>Das Programm hat Fehler; die Steuerung läuft mit dem alten weiter</translation>
    </message>
    <message>
        <source>did not exist in this scan</source>
        <translation>gab es in diesem Zyklus nicht</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Übersetzen</translation>
    </message>
    <message>
        <source>Not optimised: the quick code keeps running</source>
        <translation>Nicht optimiert: der schnell übersetzte Code läuft weiter</translation>
    </message>
    <message>
        <source>Optimising</source>
        <translation>Optimieren</translation>
    </message>
    <message>
        <source>There is no code at or below line %1 of %2; choose an earlier line</source>
        <translation>In %2 gibt es in und unter Zeile %1 keinen Code; wählen Sie eine frühere Zeile</translation>
    </message>
    <message>
        <source>The condition of the breakpoint: %1</source>
        <translation>Die Bedingung des Haltepunkts: %1</translation>
    </message>
</context>
<context>
    <name>plc::editor::SlowScanView</name>
    <message>
        <source>Back to the previous breakpoint or to the first statement of the scan</source>
        <translation>Zurück zum vorigen Haltepunkt oder zur ersten Anweisung des Zyklus</translation>
    </message>
    <message>
        <source>Back out of the call</source>
        <translation>Rückwärts aus dem Aufruf</translation>
    </message>
    <message>
        <source>Back over calls</source>
        <translation>Rückwärts über Aufrufe</translation>
    </message>
    <message>
        <source>One statement back</source>
        <translation>Eine Anweisung zurück</translation>
    </message>
    <message>
        <source>Step in</source>
        <translation>Einzelschritt</translation>
    </message>
    <message>
        <source>Step over</source>
        <translation>Prozedurschritt</translation>
    </message>
    <message>
        <source>Step out</source>
        <translation>Ausführen bis Rücksprung</translation>
    </message>
    <message>
        <source>Forward to the next breakpoint or to the end of the scan</source>
        <translation>Weiter zum nächsten Haltepunkt oder zum Ende des Zyklus</translation>
    </message>
    <message>
        <source>End the walk</source>
        <translation>Durchgang beenden</translation>
    </message>
    <message>
        <source>Current position of the walk</source>
        <translation>Stand des Durchgangs</translation>
    </message>
    <message>
        <source>Call</source>
        <translation>Aufruf</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>Instanz</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Call path</source>
        <translation>Aufrufliste</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Values at this moment</source>
        <translation>Werte zu diesem Zeitpunkt</translation>
    </message>
    <message>
        <source>There is no recorded scan yet: run the program first.</source>
        <translation>Es gibt noch keinen aufgezeichneten Zyklus: Starten Sie zuerst das Programm.</translation>
    </message>
    <message>
        <source>Running the scan again…</source>
        <translation>Der Zyklus wird wiederholt…</translation>
    </message>
    <message>
        <source>Walks through a recorded scan statement by statement, forwards and backwards (Time, Walk Through the Scan).</source>
        <translation>Geht einen aufgezeichneten Zyklus Anweisung für Anweisung durch, vorwärts und rückwärts (Zeit, Zyklus durchgehen).</translation>
    </message>
    <message>
        <source>The end of scan %1 at %2</source>
        <translation>Ende des Zyklus %1 bei %2</translation>
    </message>
    <message>
        <source>Scan %1 at %2: before statement %3 of %4</source>
        <translation>Zyklus %1 bei %2: vor Anweisung %3 von %4</translation>
    </message>
    <message>
        <source> · pass %1</source>
        <comment>of loops, outermost first</comment>
        <translation> · Durchlauf %1</translation>
    </message>
    <message>
        <source>Locals</source>
        <translation>Lokale Variablen</translation>
    </message>
</context>
<context>
    <name>plc::editor::StEditor</name>
    <message>
        <source>Structured Text editor</source>
        <translation>Editor für Strukturierten Text</translation>
    </message>
    <message>
        <source>Declare %1</source>
        <translation>%1 deklarieren</translation>
    </message>
    <message>
        <source>There is no fix for this line; press F1 for an explanation</source>
        <translation>Für diese Zeile gibt es keine Korrektur; F1 zeigt eine Erklärung</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Gehe zur Definition</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Referenzen suchen</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Add to Watch</source>
        <translation>Zur Überwachung hinzufügen</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Haltepunkt umschalten</translation>
    </message>
    <message>
        <source>CR</source>
        <comment>current result of an instruction list</comment>
        <translation>AE</translation>
    </message>
    <message>
        <source>Declare %1 as an input</source>
        <translation>%1 als Eingang deklarieren</translation>
    </message>
    <message>
        <source>Declare %1 as an output</source>
        <translation>%1 als Ausgang deklarieren</translation>
    </message>
    <message>
        <source>Declare %1 as a global variable</source>
        <translation>%1 als globale Variable deklarieren</translation>
    </message>
    <message>
        <source>Declare %1 in %2</source>
        <translation>%1 in %2 deklarieren</translation>
    </message>
    <message>
        <source>Write a Value…</source>
        <translation>Wert schreiben…</translation>
    </message>
    <message>
        <source>Force…</source>
        <translation>Forcen…</translation>
    </message>
    <message>
        <source>Release the Force</source>
        <translation>Forcen aufheben</translation>
    </message>
    <message>
        <source>pass</source>
        <comment>of a loop</comment>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::TaskMonitor</name>
    <message>
        <source>Histogram of execution times</source>
        <translation>Histogramm der Ausführungszeiten</translation>
    </message>
    <message>
        <source>Execution times appear here while the controller runs</source>
        <translation>Hier erscheinen die Ausführungszeiten, während die Steuerung läuft</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Task</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Anzahl Zyklen</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Letzte</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Durchschnitt</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Jitter</translation>
    </message>
    <message>
        <source>Overruns</source>
        <translation>Zeitüberschreitungen</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Auslastung</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tasks</translation>
    </message>
    <message>
        <source>Reset the statistics</source>
        <translation>Statistik zurücksetzen</translation>
    </message>
</context>
<context>
    <name>plc::editor::TuningView</name>
    <message>
        <source>Charts of the loop</source>
        <translation>Diagramme des Regelkreises</translation>
    </message>
    <message>
        <source>Recording and model</source>
        <translation>Aufzeichnung und Modell</translation>
    </message>
    <message>
        <source>Response to the set point</source>
        <translation>Führungsverhalten</translation>
    </message>
    <message>
        <source>Response to a disturbance</source>
        <translation>Störverhalten</translation>
    </message>
    <message>
        <source>Simulation with the actual block</source>
        <translation>Simulation mit dem echten Baustein</translation>
    </message>
    <message>
        <source>Control loop</source>
        <translation>Regelkreis</translation>
    </message>
    <message>
        <source>Find Steps</source>
        <translation>Sprünge suchen</translation>
    </message>
    <message>
        <source>Searches the recording for steps of the set point and of the output and fits a model of the process.</source>
        <translation>Sucht in der Aufzeichnung nach Sprüngen des Sollwerts und des Ausgangs und bildet ein Modell der Strecke.</translation>
    </message>
    <message>
        <source>Write Parameters</source>
        <translation>Parameter schreiben</translation>
    </message>
    <message>
        <source>Writes all parameters in one scan.</source>
        <translation>Schreibt alle Parameter in einem Zyklus.</translation>
    </message>
    <message>
        <source>Take Back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Writes the parameters that were in force before.</source>
        <translation>Schreibt die Parameter, die vorher galten.</translation>
    </message>
    <message>
        <source>Loop:</source>
        <translation>Regelkreis:</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Bei</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Beurteilung</translation>
    </message>
    <message>
        <source>Steps found</source>
        <translation>Gefundene Sprünge</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Kind of controller</source>
        <translation>Reglerart</translation>
    </message>
    <message>
        <source>Calm to brisk</source>
        <translation>Ruhig bis zügig</translation>
    </message>
    <message>
        <source>Disturbance to set point</source>
        <translation>Störverhalten bis Führungsverhalten</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Vorgeschlagen</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Vorher und nachher</translation>
    </message>
    <message>
        <source>Model:</source>
        <translation>Modell:</translation>
    </message>
    <message>
        <source>Rule:</source>
        <translation>Regel:</translation>
    </message>
    <message>
        <source>Controller:</source>
        <translation>Regler:</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>Ruhig</translation>
    </message>
    <message>
        <source>Brisk</source>
        <translation>Zügig</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>Störgröße</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>The program has no controller block; call one, for example PID.</source>
        <translation>Das Programm hat keinen Reglerbaustein; rufen Sie einen auf, zum Beispiel PID.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche läuft…</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) found, %1 used.</source>
        <translation>
            <numerusform>%n Sprung gefunden, %1 verwendet.</numerusform>
            <numerusform>%n Sprünge gefunden, %1 verwendet.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, explains %2 %</source>
        <translation>%1, erklärt %2&#xa0;%</translation>
    </message>
    <message>
        <source>set point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Choose at least one step.</source>
        <translation>Wählen Sie mindestens einen Sprung.</translation>
    </message>
    <message>
        <source>The rule does not apply to this process; choose another rule.</source>
        <translation>Die Regel ist für diese Strecke nicht anwendbar; wählen Sie eine andere Regel.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Integral time</source>
        <translation>Nachstellzeit</translation>
    </message>
    <message>
        <source>Derivative time</source>
        <translation>Vorhaltzeit</translation>
    </message>
    <message>
        <source>Sensitivity Ms</source>
        <translation>Empfindlichkeit Ms</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instabil</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Amplitudenreserve</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Ausregelzeit</translation>
    </message>
    <message>
        <source>Error after a load step</source>
        <translation>Regelabweichung nach einem Lastsprung</translation>
    </message>
    <message>
        <source>Control effort</source>
        <translation>Stellaufwand</translation>
    </message>
    <message>
        <source>Noise in the output</source>
        <translation>Rauschen im Ausgang</translation>
    </message>
    <message>
        <source>Recorded and modelled</source>
        <translation>Aufgezeichnet und modelliert</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>aufgezeichnet</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>vorgeschlagen</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Reglereinstellung</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Taken back: %1</source>
        <translation>Zurückgenommen: %1</translation>
    </message>
    <message>
        <source>Residuals of the model</source>
        <translation>Residuen des Modells</translation>
    </message>
    <message>
        <source>recorded minus model</source>
        <translation>aufgezeichnet minus Modell</translation>
    </message>
    <message>
        <source>loop now</source>
        <translation>aktueller Regelkreis</translation>
    </message>
    <message>
        <source>loop as proposed</source>
        <translation>Regelkreis wie vorgeschlagen</translation>
    </message>
    <message>
        <source>Bode plot</source>
        <translation>Bode-Diagramm</translation>
    </message>
    <message>
        <source>Bode Plot</source>
        <translation>Bode-Diagramm</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>Frequenz [rad/s]</translation>
    </message>
    <message>
        <source>process</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>Amplitudenreserve</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>Constants in the call: %1. Write Parameters changes them in the text and in the running controller by an online change.</source>
        <translation>Konstanten im Aufruf: %1. „Parameter schreiben“ ändert sie im Text und mit einem Online-Change in der laufenden Steuerung.</translation>
    </message>
    <message>
        <source>Computed in the call and not written: %1.</source>
        <translation>Im Aufruf berechnet und nicht geschrieben: %1.</translation>
    </message>
    <message>
        <source>The recorded disturbance with these settings</source>
        <translation>Die aufgezeichnete Störung mit diesen Einstellungen</translation>
    </message>
    <message>
        <source>The recorded step with these settings</source>
        <translation>Der aufgezeichnete Sprung mit diesen Einstellungen</translation>
    </message>
    <message>
        <source>The text was changed since the controller was started: change the constants after the next start or online change.</source>
        <translation>Der Text wurde seit dem Start der Steuerung geändert: Ändern Sie die Konstanten nach dem nächsten Start oder Online-Change.</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Sprungantworten</translation>
    </message>
    <message>
        <source>Start the controller or open a recording to search it for steps.</source>
        <translation>Starten Sie die Steuerung, oder öffnen Sie eine Aufzeichnung; darin wird nach Sprüngen gesucht.</translation>
    </message>
    <message>
        <source>disturbance</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>gain [dB]</source>
        <translation>Verstärkung [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>Phase [°]</translation>
    </message>
    <message>
        <source>Health in figures</source>
        <translation>Zustand in Zahlen</translation>
    </message>
    <message>
        <source>The whole recording</source>
        <translation>Die gesamte Aufzeichnung</translation>
    </message>
    <message>
        <source>Save Report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Web pages (*.html);;PDF (*.pdf)</source>
        <translation>Webseiten (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Report written: %1</source>
        <translation>Bericht geschrieben:&#xa0;%1</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Saves a report on the loop with model and settings as HTML or PDF.</source>
        <translation>Speichert einen Bericht über den Regelkreis mit Modell und Einstellungen als HTML oder PDF.</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>Zustand</translation>
    </message>
</context>
<context>
    <name>plc::editor::WatchView</name>
    <message>
        <source>A list %1 already exists; choose another name</source>
        <translation>Eine Liste %1 ist bereits vorhanden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Ausdruck</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Prepared</source>
        <translation>Vorbereitet</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>Überwachungsliste</translation>
    </message>
    <message>
        <source>Add an expression: Main.x, a[i] * 2, fb.Q AND NOT done</source>
        <translation>Ausdruck hinzufügen: Main.x, a[i] * 2, fb.Q AND NOT done</translation>
    </message>
    <message>
        <source>New watch expression</source>
        <translation>Neuer überwachter Ausdruck</translation>
    </message>
    <message>
        <source>Write prepared values</source>
        <translation>Werte schreiben</translation>
    </message>
    <message>
        <source>Force prepared values</source>
        <translation>Werte forcen</translation>
    </message>
    <message>
        <source>Release the selected forces</source>
        <translation>Forcen der gewählten Werte aufheben</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>Dezimal</translation>
    </message>
    <message>
        <source>Hexadecimal</source>
        <translation>Hexadezimal</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>Binär</translation>
    </message>
    <message>
        <source>Number format</source>
        <translation>Zahlenformat</translation>
    </message>
    <message>
        <source>Toggle</source>
        <translation>Umschalten</translation>
    </message>
    <message>
        <source>Force to %1</source>
        <translation>Auf %1 forcen</translation>
    </message>
    <message>
        <source>Release Force</source>
        <translation>Forcen aufheben</translation>
    </message>
    <message>
        <source>Show in Trace</source>
        <translation>Im Trace anzeigen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>Time</source>
        <comment>number format</comment>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Numbers as decimals, in hexadecimal or binary, or milliseconds as a time</source>
        <translation>Zahlen dezimal, hexadezimal oder binär, oder Millisekunden als Zeit</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <comment>stretch of an array</comment>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Überwachung</translation>
    </message>
    <message>
        <source>Add, rename or remove a list</source>
        <translation>Liste hinzufügen, umbenennen oder entfernen</translation>
    </message>
    <message>
        <source>Name of the list:</source>
        <translation>Name der Liste:</translation>
    </message>
    <message>
        <source>New List…</source>
        <translation>Neue Liste…</translation>
    </message>
    <message>
        <source>New List</source>
        <translation>Neue Liste</translation>
    </message>
    <message>
        <source>Rename the List…</source>
        <translation>Liste umbenennen…</translation>
    </message>
    <message>
        <source>Rename the List</source>
        <translation>Liste umbenennen</translation>
    </message>
    <message>
        <source>Remove the List</source>
        <translation>Liste entfernen</translation>
    </message>
    <message>
        <source>Number Format</source>
        <translation>Zahlenformat</translation>
    </message>
    <message>
        <source>As in the list</source>
        <translation>Wie die Liste</translation>
    </message>
    <message>
        <source>Source of %1 with the Values of %2</source>
        <translation>Quelltext von %1 mit den Werten von %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::WhyView</name>
    <message>
        <source>For example Main.level &gt; 80</source>
        <translation>Zum Beispiel Main.level &gt; 80</translation>
    </message>
    <message>
        <source>Variable or expression to explain</source>
        <translation>Zu erklärende Variable oder Ausdruck</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Warum?</translation>
    </message>
    <message>
        <source>What changed it, and what had to hold</source>
        <translation>Was es geändert hat und was dafür gelten musste</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>Warum nicht?</translation>
    </message>
    <message>
        <source>The smallest changes that would change the result of the condition</source>
        <translation>Die kleinsten Änderungen, mit denen die Bedingung ein anderes Ergebnis hätte</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>Wer hat das gesetzt?</translation>
    </message>
    <message>
        <source>All changes in the recording, and what made each of them</source>
        <translation>Alle Änderungen in der Aufzeichnung, und was sie jeweils bewirkt hat</translation>
    </message>
    <message>
        <source>Explanation</source>
        <translation>Erklärung</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>Right-click a variable in the text, the watch, the tree, the trace or a panel and ask why it has its value.</source>
        <translation>Klicken Sie mit der rechten Maustaste auf eine Variable im Text, in der Überwachung, im Baum, im Trace oder in einem Panel, und fragen Sie, warum sie ihren Wert hat.</translation>
    </message>
    <message>
        <source>Searching the recorded scans…</source>
        <translation>Die aufgezeichneten Zyklen werden untersucht…</translation>
    </message>
    <message>
        <source>There is no recording yet: run the program first.</source>
        <translation>Es gibt noch keine Aufzeichnung: Starten Sie zuerst das Programm.</translation>
    </message>
    <message>
        <source>%1 · scan %2</source>
        <comment>time and number</comment>
        <translation>%1 · Zyklus %2</translation>
    </message>
    <message>
        <source>Earlier changes…</source>
        <translation>Frühere Änderungen…</translation>
    </message>
    <message>
        <source>Why Is %1 So?</source>
        <translation>Warum ist %1 so?</translation>
    </message>
    <message>
        <source>Who Set %1?</source>
        <translation>Wer hat %1 gesetzt?</translation>
    </message>
    <message>
        <source>Copy the Answer</source>
        <translation>Antwort kopieren</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel (Esc)</source>
        <translation>Abbrechen (Esc)</translation>
    </message>
    <message>
        <source>Cancelled: there is no answer.</source>
        <translation>Abgebrochen: Es gibt keine Antwort.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::AlarmEditor</name>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Priorität</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Add an alarm</source>
        <translation>Alarm hinzufügen</translation>
    </message>
    <message>
        <source>Add a class</source>
        <translation>Klasse hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Add alarm</source>
        <translation>Alarm hinzufügen</translation>
    </message>
    <message>
        <source>Add class</source>
        <translation>Klasse hinzufügen</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ArrayArrangementDialog</name>
    <message>
        <source>Arrange over array</source>
        <translation>Über ein Array anordnen</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Array</translation>
    </message>
    <message>
        <source>First index</source>
        <translation>Erster Index</translation>
    </message>
    <message>
        <source>Last index</source>
        <translation>Letzter Index</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Horizontal gap</source>
        <translation>Abstand waagrecht</translation>
    </message>
    <message>
        <source>Vertical gap</source>
        <translation>Abstand senkrecht</translation>
    </message>
    <message>
        <source>In the other arguments, # becomes the index.</source>
        <translation>In den anderen Argumenten wird # zum Index.</translation>
    </message>
    <message>
        <source>Choose an array with one index, for example Plant.Valves.</source>
        <translation>Wählen Sie ein Array mit einem Index, zum Beispiel Plant.Valves.</translation>
    </message>
    <message>
        <source>They reach to %1 × %2, the panel only to %3 × %4: make the faceplate smaller or the panel larger.</source>
        <translation>Sie reichen bis %1 × %2, das Panel nur bis %3 × %4: Verkleinern Sie das Faceplate oder vergrößern Sie das Panel.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ArrayDialog</name>
    <message>
        <source>Duplicate as array</source>
        <translation>Als Array duplizieren</translation>
    </message>
    <message>
        <source>Number of elements</source>
        <translation>Anzahl der Elemente</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Vertical gap</source>
        <translation>Abstand senkrecht</translation>
    </message>
    <message>
        <source>Index step</source>
        <translation>Indexschritt</translation>
    </message>
    <message>
        <source>Horizontal gap</source>
        <translation>Abstand waagrecht</translation>
    </message>
</context>
<context>
    <name>plc::hmi::DesignCanvas</name>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Move point</source>
        <translation>Punkt verschieben</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Resize</source>
        <translation>Größe ändern</translation>
    </message>
    <message>
        <source>Bind</source>
        <translation>Verknüpfen</translation>
    </message>
    <message>
        <source>%1 has no single value: drop one of its members, or first draw a panel with a parameter of the type %2</source>
        <translation>%1 hat keinen einzelnen Wert: Ziehen Sie eines seiner Elemente hierher, oder zeichnen Sie zuerst ein Panel mit einem Parameter vom Typ %2</translation>
    </message>
    <message>
        <source>Place in cell</source>
        <translation>In Zelle platzieren</translation>
    </message>
</context>
<context>
    <name>plc::hmi::DesignContext</name>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Rename Theme</source>
        <translation>Farbschema umbenennen</translation>
    </message>
</context>
<context>
    <name>plc::hmi::Outline</name>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>No elements yet. Drag one from the palette onto the panel.</source>
        <translation>Noch keine Elemente. Ziehen Sie eines aus der Palette auf das Panel.</translation>
    </message>
    <message>
        <source>Reorder</source>
        <translation>Umordnen</translation>
    </message>
</context>
<context>
    <name>plc::hmi::Palette</name>
    <message>
        <source>Search elements</source>
        <translation>Elemente suchen</translation>
    </message>
    <message>
        <source>Faceplates</source>
        <translation>Faceplates</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PanelDesigner</name>
    <message>
        <source>Issue</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Element</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Duplicate as Array…</source>
        <translation>Als Array duplizieren…</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Align Left</source>
        <translation>Links ausrichten</translation>
    </message>
    <message>
        <source>Align Centres</source>
        <translation>Mitten waagrecht ausrichten</translation>
    </message>
    <message>
        <source>Align Right</source>
        <translation>Rechts ausrichten</translation>
    </message>
    <message>
        <source>Align Top</source>
        <translation>Oben ausrichten</translation>
    </message>
    <message>
        <source>Align Middles</source>
        <translation>Mitten senkrecht ausrichten</translation>
    </message>
    <message>
        <source>Align Bottom</source>
        <translation>Unten ausrichten</translation>
    </message>
    <message>
        <source>Distribute Horizontally</source>
        <translation>Gleiche Abstände waagrecht</translation>
    </message>
    <message>
        <source>Distribute Vertically</source>
        <translation>Gleiche Abstände senkrecht</translation>
    </message>
    <message>
        <source>Same Width</source>
        <translation>Gleiche Breite</translation>
    </message>
    <message>
        <source>Same Height</source>
        <translation>Gleiche Höhe</translation>
    </message>
    <message>
        <source>Bring to Front</source>
        <translation>In den Vordergrund</translation>
    </message>
    <message>
        <source>Bring Forward</source>
        <translation>Eine Ebene nach vorn</translation>
    </message>
    <message>
        <source>Send Backward</source>
        <translation>Eine Ebene nach hinten</translation>
    </message>
    <message>
        <source>Send to Back</source>
        <translation>In den Hintergrund</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppieren</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Gruppierung aufheben</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Show the Grid</source>
        <translation>Raster anzeigen</translation>
    </message>
    <message>
        <source>Snap (Alt: not now)</source>
        <translation>Einrasten (Alt: jetzt nicht)</translation>
    </message>
    <message>
        <source>Live Preview</source>
        <translation>Live-Vorschau</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom Out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Zoom 100 %</source>
        <translation>Zoom 100&#xa0;%</translation>
    </message>
    <message>
        <source>Zoom to Fit</source>
        <translation>Zoom anpassen</translation>
    </message>
    <message>
        <source>Language shown</source>
        <translation>Angezeigte Sprache</translation>
    </message>
    <message>
        <source>Theme of the panel</source>
        <translation>Farbschema des Panels</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Duplicate as array</source>
        <translation>Als Array duplizieren</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variablen</translation>
    </message>
    <message>
        <source>Same Size</source>
        <translation>Gleiche Größe</translation>
    </message>
    <message>
        <source>Paste in Place</source>
        <translation>An derselben Stelle einfügen</translation>
    </message>
    <message>
        <source>Arrange Over Array…</source>
        <translation>Über ein Array anordnen…</translation>
    </message>
    <message>
        <source>Arrange over array</source>
        <translation>Über ein Array anordnen</translation>
    </message>
    <message>
        <source>Fix All Issues</source>
        <translation>Alle Probleme beheben</translation>
    </message>
    <message>
        <source>Fix Issue</source>
        <translation>Problem beheben</translation>
    </message>
    <message>
        <source>Explain Issue</source>
        <translation>Problem erklären</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Gliederung</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Issues</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Lay Out in a Row</source>
        <translation>In einer Zeile anordnen</translation>
    </message>
    <message>
        <source>Lay Out in a Column</source>
        <translation>In einer Spalte anordnen</translation>
    </message>
    <message>
        <source>Lay Out in a Grid</source>
        <translation>In einem Raster anordnen</translation>
    </message>
    <message>
        <source>Lay out</source>
        <translation>Anordnen</translation>
    </message>
    <message>
        <source>Edit Themes…</source>
        <translation>Farbschemas bearbeiten…</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PanelKeys</name>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PasswordDialog</name>
    <message>
        <source>Set Password</source>
        <translation>Passwort setzen</translation>
    </message>
    <message>
        <source>Password of %1:</source>
        <translation>Passwort von&#xa0;%1:</translation>
    </message>
    <message>
        <source>The two passwords differ.</source>
        <translation>Die beiden Passwörter stimmen nicht überein.</translation>
    </message>
    <message>
        <source>Repeat:</source>
        <translation>Wiederholen:</translation>
    </message>
    <message>
        <source>Repeat the password.</source>
        <translation>Wiederholen Sie das Passwort.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PeopleEditor</name>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Start panel</source>
        <translation>Startpanel</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Add a User</source>
        <translation>Benutzer hinzufügen</translation>
    </message>
    <message>
        <source>Set Password…</source>
        <translation>Passwort setzen…</translation>
    </message>
    <message>
        <source>Remove User</source>
        <translation>Benutzer entfernen</translation>
    </message>
    <message>
        <source>Add a Role</source>
        <translation>Rolle hinzufügen</translation>
    </message>
    <message>
        <source>Remove Role</source>
        <translation>Rolle entfernen</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>Logged out after</source>
        <translation>Abmelden nach</translation>
    </message>
    <message>
        <source>Logged out after </source>
        <translation>Abmelden nach </translation>
    </message>
    <message>
        <source>Logged Out After</source>
        <translation>Abmelden nach</translation>
    </message>
    <message>
        <source>Set Password</source>
        <translation>Passwort setzen</translation>
    </message>
    <message>
        <source>none: cannot log in</source>
        <translation>keines: Anmelden nicht möglich</translation>
    </message>
    <message>
        <source>set</source>
        <translation>gesetzt</translation>
    </message>
    <message>
        <source>Rename Role</source>
        <translation>Rolle umbenennen</translation>
    </message>
    <message>
        <source>Without users, everybody may do everything. Add a role, then a user with a password.</source>
        <translation>Ohne Benutzer darf jeder alles. Fügen Sie eine Rolle hinzu, dann einen Benutzer mit Passwort.</translation>
    </message>
    <message>
        <source>To restrict an element to some users, set its property &quot;Only for the roles&quot;.</source>
        <translation>Um ein Element auf bestimmte Benutzer zu beschränken, setzen Sie seine Eigenschaft „Nur für die Rollen“.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PropertySheet</name>
    <message>
        <source>Search properties</source>
        <translation>Eigenschaften suchen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n Element</numerusform>
            <numerusform>%n Elemente</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::hmi::RecipeEditor</name>
    <message>
        <source>Add a Recipe</source>
        <translation>Rezeptur hinzufügen</translation>
    </message>
    <message>
        <source>Add a Variable</source>
        <translation>Variable hinzufügen</translation>
    </message>
    <message>
        <source>Add a Set</source>
        <translation>Datensatz hinzufügen</translation>
    </message>
    <message>
        <source>Remove Row or Set</source>
        <translation>Zeile oder Datensatz entfernen</translation>
    </message>
    <message>
        <source>Remove Recipe</source>
        <translation>Rezeptur entfernen</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>CSV importieren</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>CSV exportieren</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepturen</translation>
    </message>
    <message>
        <source>Variables and sets of the recipe</source>
        <translation>Variablen und Datensätze der Rezeptur</translation>
    </message>
    <message>
        <source>Rename Recipe</source>
        <translation>Rezeptur umbenennen</translation>
    </message>
    <message>
        <source>Rename Set</source>
        <translation>Datensatz umbenennen</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>Remove Set</source>
        <translation>Datensatz entfernen</translation>
    </message>
    <message>
        <source>Remove Row</source>
        <translation>Zeile entfernen</translation>
    </message>
    <message>
        <source>Add a recipe, then its variables, then a set for each product.</source>
        <translation>Fügen Sie eine Rezeptur hinzu, dann ihre Variablen, dann einen Datensatz für jedes Produkt.</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>A recipe needs a name.</source>
        <translation>Eine Rezeptur braucht einen Namen.</translation>
    </message>
    <message>
        <source>The recipe &quot;%1&quot; already exists; choose another name.</source>
        <translation>Eine Rezeptur „%1“ ist bereits vorhanden; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The set &quot;%1&quot; already exists; choose another name.</source>
        <translation>Ein Datensatz „%1“ ist bereits vorhanden; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number; a limit is written like 12.5.</source>
        <translation>„%1“ ist keine Zahl; ein Grenzwert wird zum Beispiel als 12.5 geschrieben.</translation>
    </message>
    <message>
        <source>A row needs a variable; Remove Row or Set takes the row away.</source>
        <translation>Eine Zeile braucht eine Variable; „Zeile oder Datensatz entfernen“ löscht die Zeile.</translation>
    </message>
    <message>
        <source>%1 is already in the recipe; choose another variable.</source>
        <translation>%1 ist in der Rezeptur bereits enthalten; wählen Sie eine andere Variable.</translation>
    </message>
    <message>
        <source>Select a cell of the set that is to be renamed.</source>
        <translation>Wählen Sie eine Zelle des Datensatzes, der umbenannt werden soll.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::RecordsDialog</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ab</translation>
    </message>
</context>
<context>
    <name>plc::hmi::TextEditor</name>
    <message>
        <source>A key %1 already exists; choose another name</source>
        <translation>Ein Schlüssel %1 ist bereits vorhanden; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>Only incomplete</source>
        <translation>Nur unvollständige</translation>
    </message>
    <message>
        <source>Search texts</source>
        <translation>Texte suchen</translation>
    </message>
    <message>
        <source>Add a key</source>
        <translation>Schlüssel hinzufügen</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>Remove the selected keys</source>
        <translation>Gewählte Schlüssel entfernen</translation>
    </message>
    <message>
        <source>Add a language</source>
        <translation>Sprache hinzufügen</translation>
    </message>
    <message>
        <source>Language tag, for example de or zh-CN</source>
        <translation>Sprachkürzel, zum Beispiel de oder zh-CN</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>CSV importieren</translation>
    </message>
    <message>
        <source>Text tables (*.csv *.txt)</source>
        <translation>Texttabellen (*.csv *.txt)</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>CSV exportieren</translation>
    </message>
    <message>
        <source>Text tables (*.csv)</source>
        <translation>Texttabellen (*.csv)</translation>
    </message>
    <message>
        <source>Add key</source>
        <translation>Schlüssel hinzufügen</translation>
    </message>
    <message>
        <source>Remove keys</source>
        <translation>Schlüssel entfernen</translation>
    </message>
    <message>
        <source>Add language</source>
        <translation>Sprache hinzufügen</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>%n Text</numerusform>
            <numerusform>%n Texte</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is not used.</source>
        <translation>%1 wird nicht verwendet.</translation>
    </message>
    <message>
        <source>%1 is used by %2</source>
        <translation>%1 wird von %2 verwendet</translation>
    </message>
    <message>
        <source>Import XLIFF</source>
        <translation>XLIFF importieren</translation>
    </message>
    <message>
        <source>Translations (*.xlf *.xliff)</source>
        <translation>Übersetzungen (*.xlf *.xliff)</translation>
    </message>
    <message>
        <source>Export XLIFF</source>
        <translation>XLIFF exportieren</translation>
    </message>
    <message>
        <source>Translated from</source>
        <translation>Übersetzt aus</translation>
    </message>
    <message>
        <source>Translated into</source>
        <translation>Übersetzt in</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) taken.</source>
        <translation>
            <numerusform>%n Text übernommen.</numerusform>
            <numerusform>%n Texte übernommen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) as they were.</source>
        <translation>
            <numerusform>%n Text unverändert.</numerusform>
            <numerusform>%n Texte unverändert.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) without a translation.</source>
        <translation>
            <numerusform>%n Text ohne Übersetzung.</numerusform>
            <numerusform>%n Texte ohne Übersetzung.</numerusform>
        </translation>
    </message>
    <message>
        <source>XLIFF %1</source>
        <translation>XLIFF %1</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Remove language</source>
        <translation>Sprache entfernen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>%1 is not a language tag; choose one from the list, or enter a tag such as de or zh-CN</source>
        <translation>%1 ist kein Sprachkürzel; wählen Sie eines aus der Liste oder geben Sie ein Kürzel wie de oder zh-CN ein</translation>
    </message>
    <message>
        <source>The table already has %1; choose another language</source>
        <translation>Die Tabelle hat&#xa0;%1 bereits; wählen Sie eine andere Sprache</translation>
    </message>
    <message>
        <source>Remove the language</source>
        <translation>Sprache entfernen</translation>
    </message>
    <message>
        <source>Select a cell of the language that is to be removed.</source>
        <translation>Wählen Sie eine Zelle der Sprache, die entfernt werden soll.</translation>
    </message>
    <message>
        <source>A table of texts keeps one language; add another one first.</source>
        <translation>Eine Texttabelle behält eine Sprache; fügen Sie zuerst eine andere hinzu.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::TextModel</name>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Rename key</source>
        <translation>Schlüssel umbenennen</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ThemeDialog</name>
    <message>
        <source>Grounds, lines and texts</source>
        <translation>Hintergründe, Linien und Texte</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Prozess</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Colours by name</source>
        <translation>Farben nach Namen</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Based on</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Colours that this theme does not change are those of the base.</source>
        <translation>Farben, die dieses Farbschema nicht ändert, sind die der Basis.</translation>
    </message>
    <message>
        <source>Panel Themes</source>
        <translation>Farbschemas der Panels</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Base of the Theme</source>
        <translation>Basis des Farbschemas</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Neu…</translation>
    </message>
    <message>
        <source>New Theme</source>
        <translation>Neues Farbschema</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Rename Theme</source>
        <translation>Farbschema umbenennen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Name of the theme:</source>
        <translation>Name des Farbschemas:</translation>
    </message>
    <message>
        <source>A theme&apos;s name cannot contain %1; choose another name</source>
        <translation>Der Name eines Farbschemas darf %1 nicht enthalten; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>A theme&apos;s name begins with a letter or a digit</source>
        <translation>Der Name eines Farbschemas beginnt mit einem Buchstaben oder einer Ziffer</translation>
    </message>
    <message>
        <source>There is a theme %1 already; choose another name</source>
        <translation>Es gibt schon ein Farbschema %1; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>There is a file %1 already; choose another name</source>
        <translation>Es gibt schon eine Datei %1; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>%1 is used on %2; choose another theme there before it is deleted</source>
        <translation>%1 wird in %2 verwendet; wählen Sie dort erst ein anderes Farbschema</translation>
    </message>
    <message>
        <source>Delete Theme</source>
        <translation>Farbschema löschen</translation>
    </message>
    <message>
        <source>The project has no theme of its own yet. New… makes one that begins with the colours shown.</source>
        <translation>Das Projekt hat noch kein eigenes Farbschema. Neu… legt eines an, das mit den angezeigten Farben beginnt.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiterer</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 on %2: contrast %L3, %L4 is needed</source>
        <translation>%1 auf %2: Kontrast %L3, nötig ist %L4</translation>
    </message>
    <message>
        <source>Changed on disk too: %1. OK replaces what is there.</source>
        <translation>Auch auf dem Datenträger geändert: %1. OK ersetzt, was dort steht.</translation>
    </message>
    <message>
        <source>Discard the changes of the themes?</source>
        <translation>Die Änderungen der Farbschemas verwerfen?</translation>
    </message>
</context>
<context>
    <name>plc::kit::Canvas</name>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
</context>
<context>
    <name>plc::kit::ColorPopup</name>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>More colours…</source>
        <translation>Weitere Farben…</translation>
    </message>
    <message>
        <source>No colour</source>
        <translation>Keine Farbe</translation>
    </message>
</context>
<context>
    <name>plc::kit::ColumnMenu</name>
    <message>
        <source>Column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>Fit to Contents</source>
        <translation>An Inhalt anpassen</translation>
    </message>
    <message>
        <source>Wider</source>
        <translation>Breiter</translation>
    </message>
    <message>
        <source>Narrower</source>
        <translation>Schmaler</translation>
    </message>
    <message>
        <source>Move Left</source>
        <translation>Nach links</translation>
    </message>
    <message>
        <source>Move Right</source>
        <translation>Nach rechts</translation>
    </message>
    <message>
        <source>Sort Ascending</source>
        <translation>Aufsteigend sortieren</translation>
    </message>
    <message>
        <source>Sort Descending</source>
        <translation>Absteigend sortieren</translation>
    </message>
</context>
<context>
    <name>plc::kit::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation>Befehlspalette</translation>
    </message>
    <message>
        <source>Type to find a command</source>
        <translation>Tippen, um einen Befehl zu finden</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>menu and command</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>plc::kit::PropertyGrid</name>
    <message>
        <source>Choose a variable</source>
        <translation>Variable wählen</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Edit in a window</source>
        <translation>In einem Fenster bearbeiten</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>various</source>
        <translation>unterschiedlich</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Choose from a list</source>
        <translation>Aus einer Liste wählen</translation>
    </message>
</context>
<context>
    <name>plc::kit::VariablePicker</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Search variables</source>
        <translation>Variablen suchen</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variablen</translation>
    </message>
    <message>
        <source>Found variables</source>
        <translation>Gefundene Variablen</translation>
    </message>
    <message>
        <source>Choose a variable</source>
        <translation>Variable wählen</translation>
    </message>
</context>
<context>
    <name>plc::kit::WorkStrip</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 is being cancelled…</source>
        <translation>%1: wird abgebrochen…</translation>
    </message>
    <message>
        <source>Cancel: %1</source>
        <translation>Abbrechen: %1</translation>
    </message>
</context>
<context>
    <name>plc::plot::PlotView</name>
    <message>
        <source>Chart</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>%1
Click selects, Ctrl+click shows or hides.</source>
        <translation>%1
Klick wählt aus, Strg+Klick blendet ein oder aus.</translation>
    </message>
</context>
<context>
    <name>plc::trace::ChannelPanel</name>
    <message>
        <source>Variable or expression</source>
        <translation>Variable oder Ausdruck</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Kanal hinzufügen</translation>
    </message>
    <message>
        <source>Add as a channel</source>
        <translation>Als Kanal hinzufügen</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Show channel</source>
        <translation>Kanal anzeigen</translation>
    </message>
    <message>
        <source>Hide channel</source>
        <translation>Kanal ausblenden</translation>
    </message>
    <message>
        <source>Chart %1</source>
        <translation>Diagramm %1</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Ausdruck</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Digital</source>
        <translation>Digital</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Linienbreite</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Offset</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>New chart</source>
        <translation>Neues Diagramm</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>New axis</source>
        <translation>Neue Achse</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Share of height</source>
        <translation>Anteil der Höhe</translation>
    </message>
    <message>
        <source>Scaling</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>Fit to view</source>
        <translation>An Ansicht anpassen</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>On the right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Every n-th scan</source>
        <translation>Jeder n-te Zyklus</translation>
    </message>
    <message>
        <source>Record while</source>
        <translation>Aufzeichnungsbedingung</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Flanke</translation>
    </message>
    <message>
        <source>Rising</source>
        <translation>Steigend</translation>
    </message>
    <message>
        <source>Falling</source>
        <translation>Fallend</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Einzeln</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Wiederholt</translation>
    </message>
    <message>
        <source>Shown before</source>
        <translation>Anzeige vor dem Trigger</translation>
    </message>
    <message>
        <source>Shown after</source>
        <translation>Anzeige nach dem Trigger</translation>
    </message>
    <message>
        <source>Change channel</source>
        <translation>Kanal ändern</translation>
    </message>
    <message>
        <source>Change chart</source>
        <translation>Diagramm ändern</translation>
    </message>
    <message>
        <source>Change trace</source>
        <translation>Trace ändern</translation>
    </message>
    <message>
        <source>Remove channel</source>
        <translation>Kanal entfernen</translation>
    </message>
    <message>
        <source>Remove chart</source>
        <translation>Diagramm entfernen</translation>
    </message>
    <message>
        <source>Move channel</source>
        <translation>Kanal verschieben</translation>
    </message>
    <message>
        <source>Compared recording</source>
        <translation>Verglichene Aufzeichnung</translation>
    </message>
    <message>
        <source>Offset in time</source>
        <translation>Zeitversatz</translation>
    </message>
</context>
<context>
    <name>plc::trace::FigurePane</name>
    <message>
        <source>Save as %1</source>
        <translation>Als %1 speichern</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Copy as Picture</source>
        <translation>Als Bild kopieren</translation>
    </message>
    <message>
        <source>Save as %1…</source>
        <translation>Als %1 speichern…</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fensterfunktion</translation>
    </message>
    <message>
        <source>Hann window</source>
        <translation>Hann-Fenster</translation>
    </message>
    <message>
        <source>Flat top: exact amplitudes</source>
        <translation>Flat-Top: genaue Amplituden</translation>
    </message>
    <message>
        <source>No window</source>
        <translation>Kein Fenster</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Charts over time only</source>
        <translation>Nur Zeitdiagramme</translation>
    </message>
    <message>
        <source>Horizontal value</source>
        <translation>Waagrechter Wert</translation>
    </message>
    <message>
        <source>Window of the spectrum</source>
        <translation>Fensterfunktion des Spektrums</translation>
    </message>
    <message>
        <source>Logarithmic axes</source>
        <translation>Logarithmische Achsen</translation>
    </message>
    <message>
        <source>Input:</source>
        <translation>Eingang:</translation>
    </message>
    <message>
        <source>Horizontal:</source>
        <translation>Waagrecht:</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>Measure between Points</source>
        <translation>Zwischen Punkten messen</translation>
    </message>
</context>
<context>
    <name>plc::trace::TimeBar</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Resumed from here
%1</source>
        <translation>Ab hier fortgesetzt
%1</translation>
    </message>
</context>
<context>
    <name>plc::trace::TimeSlider</name>
    <message>
        <source>Time slider</source>
        <translation>Zeitschieber</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Variable whose changes to step to</source>
        <translation>Variable, zu deren Änderungen gesprungen wird</translation>
    </message>
    <message>
        <source>The arrows beside step to its previous and next change</source>
        <translation>Die Pfeile daneben gehen zur vorigen und nächsten Änderung</translation>
    </message>
    <message>
        <source>One scan back (Left)</source>
        <translation>Einen Zyklus zurück (Links)</translation>
    </message>
    <message>
        <source>One scan forward (Right)</source>
        <translation>Einen Zyklus vor (Rechts)</translation>
    </message>
    <message>
        <source>Previous change of the variable (Ctrl+Left)</source>
        <translation>Vorige Änderung der Variablen (Strg+Links)</translation>
    </message>
    <message>
        <source>Next change of the variable (Ctrl+Right)</source>
        <translation>Nächste Änderung der Variablen (Strg+Rechts)</translation>
    </message>
    <message>
        <source>Resume the controller from this scan</source>
        <translation>Steuerung ab diesem Zyklus fortsetzen</translation>
    </message>
    <message>
        <source>Back to the newest scan (End)</source>
        <translation>Zurück zum neuesten Zyklus (Ende)</translation>
    </message>
    <message>
        <source>Older scans are no longer kept.</source>
        <translation>Ältere Zyklen sind nicht mehr vorhanden.</translation>
    </message>
    <message>
        <source>%1 does not change before this scan.</source>
        <translation>%1 ändert sich vor diesem Zyklus nicht.</translation>
    </message>
    <message>
        <source>%1 does not change after this scan.</source>
        <translation>%1 ändert sich nach diesem Zyklus nicht.</translation>
    </message>
    <message>
        <source>No recording</source>
        <translation>Keine Aufzeichnung</translation>
    </message>
    <message>
        <source>no longer kept</source>
        <translation>nicht mehr vorhanden</translation>
    </message>
    <message>
        <source>scan %1  %2</source>
        <translation>Zyklus %1  %2</translation>
    </message>
</context>
<context>
    <name>plc::trace::TraceView</name>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Show channel</source>
        <translation>Kanal anzeigen</translation>
    </message>
    <message>
        <source>Hide channel</source>
        <translation>Kanal ausblenden</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Follow the newest scan (End)</source>
        <translation>Dem neuesten Zyklus folgen (Ende)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Show everything recorded (Home)</source>
        <translation>Alles Aufgezeichnete anzeigen (Pos1)</translation>
    </message>
    <message>
        <source>Fit values</source>
        <translation>Werte anpassen</translation>
    </message>
    <message>
        <source>Let the value axes fit again</source>
        <translation>Werteachsen wieder automatisch anpassen</translation>
    </message>
    <message>
        <source>Zoom back</source>
        <translation>Zoom zurück</translation>
    </message>
    <message>
        <source>Back to the view before (Backspace)</source>
        <translation>Zurück zur vorigen Ansicht (Rücktaste)</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Drag a box to zoom: flat for time, upright for values</source>
        <translation>Rahmen zum Zoomen ziehen: flach für Zeit, hoch für Werte</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Drag to pan (middle button always does)</source>
        <translation>Ziehen verschiebt (mittlere Maustaste immer)</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Two cursors (Ctrl+click sets A, Shift+click sets B)</source>
        <translation>Zwei Cursor (Strg+Klick setzt A, Umschalt+Klick setzt B)</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Table of values and statistics between the cursors</source>
        <translation>Tabelle der Werte und Statistik zwischen den Cursorn</translation>
    </message>
    <message>
        <source>Measuring table</source>
        <translation>Messtabelle</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Arm the trigger set in the properties of the trace</source>
        <translation>Den in den Eigenschaften des Trace gesetzten Trigger scharf schalten</translation>
    </message>
    <message>
        <source>Previous trigger</source>
        <translation>Voriger Trigger</translation>
    </message>
    <message>
        <source>Where the trigger would have fired before</source>
        <translation>Wo der Trigger vorher ausgelöst hätte</translation>
    </message>
    <message>
        <source>Next trigger</source>
        <translation>Nächster Trigger</translation>
    </message>
    <message>
        <source>Where the trigger would have fired next</source>
        <translation>Wo der Trigger als Nächstes ausgelöst hätte</translation>
    </message>
    <message>
        <source>Add chart</source>
        <translation>Diagramm hinzufügen</translation>
    </message>
    <message>
        <source>Another chart over the same time</source>
        <translation>Ein weiteres Diagramm über derselben Zeit</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Load an older recording beneath the present one</source>
        <translation>Eine ältere Aufzeichnung laden und unter die jetzige legen</translation>
    </message>
    <message>
        <source>Recording to draw beneath</source>
        <translation>Aufzeichnung, die darunter gezeichnet wird</translation>
    </message>
    <message>
        <source>Trace configuration</source>
        <translation>Trace-Konfiguration</translation>
    </message>
    <message>
        <source>Open Configuration…</source>
        <translation>Konfiguration öffnen…</translation>
    </message>
    <message>
        <source>Open trace configuration</source>
        <translation>Trace-Konfiguration öffnen</translation>
    </message>
    <message>
        <source>Trace configurations (*.trace.json)</source>
        <translation>Trace-Konfigurationen (*.trace.json)</translation>
    </message>
    <message>
        <source>Save trace configuration</source>
        <translation>Trace-Konfiguration speichern</translation>
    </message>
    <message>
        <source>Save Configuration</source>
        <translation>Konfiguration speichern</translation>
    </message>
    <message>
        <source>Save Configuration As…</source>
        <translation>Konfiguration speichern unter…</translation>
    </message>
    <message>
        <source>Open Recording…</source>
        <translation>Aufzeichnung öffnen…</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Back to the Running PLC</source>
        <translation>Zurück zum Livebetrieb</translation>
    </message>
    <message>
        <source>Save Recording…</source>
        <translation>Aufzeichnung speichern…</translation>
    </message>
    <message>
        <source>Save recording</source>
        <translation>Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>Recordings (*.rec)</source>
        <translation>Aufzeichnungen (*.rec)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Copy as Picture</source>
        <translation>Als Bild kopieren</translation>
    </message>
    <message>
        <source>Save Samples in View as CSV…</source>
        <translation>Sichtbare Werte als CSV speichern…</translation>
    </message>
    <message>
        <source>Save as %1…</source>
        <translation>Als %1 speichern…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Drucken…</translation>
    </message>
    <message>
        <source>Save as %1</source>
        <translation>Als %1 speichern</translation>
    </message>
    <message>
        <source>Add channel</source>
        <translation>Kanal hinzufügen</translation>
    </message>
    <message>
        <source>Arm trigger</source>
        <translation>Trigger scharf schalten</translation>
    </message>
    <message>
        <source>The trigger has no expression yet: enter one in the properties of the trace.</source>
        <translation>Der Trigger hat noch keinen Ausdruck: Geben Sie ihn in den Eigenschaften des Trace ein.</translation>
    </message>
    <message>
        <source>Trigger armed</source>
        <translation>Trigger scharf</translation>
    </message>
    <message>
        <source>Triggered, collecting</source>
        <translation>Ausgelöst, Werte werden gesammelt</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>Ausgelöst</translation>
    </message>
    <message numerus="yes">
        <source>(%n shot(s))</source>
        <translation>
            <numerusform>(%n Auslösung)</numerusform>
            <numerusform>(%n Auslösungen)</numerusform>
        </translation>
    </message>
    <message>
        <source>Not running</source>
        <translation>Läuft nicht</translation>
    </message>
    <message>
        <source>%L1 scans kept  ·  history %2 of %3 MB  ·  channels %4 of %5 MB</source>
        <translation>%L1 Zyklen gespeichert  ·  Historie %2 von %3&#xa0;MB  ·  Kanäle %4 von %5&#xa0;MB</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Remove Channel</source>
        <translation>Kanal entfernen</translation>
    </message>
    <message>
        <source>Add Channel…</source>
        <translation>Kanal hinzufügen…</translation>
    </message>
    <message>
        <source>Trigger off</source>
        <translation>Trigger aus</translation>
    </message>
    <message>
        <source>Saving the samples…</source>
        <translation>Messwerte werden gespeichert…</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet…</translation>
    </message>
    <message>
        <source>Saving the recording…</source>
        <translation>Die Aufzeichnung wird gespeichert…</translation>
    </message>
    <message>
        <source>%1, %2 later</source>
        <translation>%1, %2 später</translation>
    </message>
    <message>
        <source>%1, %2 earlier</source>
        <translation>%1, %2 früher</translation>
    </message>
    <message>
        <source>Measure between points</source>
        <translation>Zwischen Punkten messen</translation>
    </message>
    <message>
        <source>Drag from one point to another: time, value, slope and frequency between them (M)</source>
        <translation>Von einem Punkt zum anderen ziehen: Zeit, Wert, Steigung und Frequenz dazwischen (M)</translation>
    </message>
    <message>
        <source>XY plot, spectrum, frequency response, runs</source>
        <translation>XY-Diagramm, Spektrum, Frequenzgang, Läufe</translation>
    </message>
    <message>
        <source>Add Channel of Another File…</source>
        <translation>Kanal aus einer anderen Datei hinzufügen…</translation>
    </message>
    <message>
        <source>Show Beside</source>
        <translation>Daneben anzeigen</translation>
    </message>
    <message>
        <source>Measure between Points</source>
        <translation>Zwischen Punkten messen</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>Notiz hinzufügen</translation>
    </message>
    <message>
        <source>Add Note</source>
        <translation>Notiz hinzufügen</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Notiz:</translation>
    </message>
    <message>
        <source>Edit Note</source>
        <translation>Notiz bearbeiten</translation>
    </message>
    <message>
        <source>Edit note</source>
        <translation>Notiz bearbeiten</translation>
    </message>
    <message>
        <source>Remove note</source>
        <translation>Notiz entfernen</translation>
    </message>
    <message>
        <source>Edit Note…</source>
        <translation>Notiz bearbeiten…</translation>
    </message>
    <message>
        <source>Remove Note</source>
        <translation>Notiz entfernen</translation>
    </message>
    <message>
        <source>Add Note…</source>
        <translation>Notiz hinzufügen…</translation>
    </message>
    <message>
        <source>File to add a channel of</source>
        <translation>Datei, aus der ein Kanal hinzugefügt wird</translation>
    </message>
    <message>
        <source>Recordings and tables (*.rec *.csv *.tsv *.txt *.trace);;All files (*)</source>
        <translation>Aufzeichnungen und Tabellen (*.rec *.csv *.tsv *.txt *.trace);;Alle Dateien (*)</translation>
    </message>
</context>
</TS>
