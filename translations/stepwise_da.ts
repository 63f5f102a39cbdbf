<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="da" sourcelanguage="en">
<context>
    <name>DeviceFields</name>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokol</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>Aktiveret</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Vært</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Unit number</source>
        <translation>Enhedsnummer</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Seriel port</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Baudrate</translation>
    </message>
    <message>
        <source>Parity</source>
        <translation>Paritet</translation>
    </message>
    <message>
        <source>Data bits</source>
        <translation>Databit</translation>
    </message>
    <message>
        <source>Stop bits</source>
        <translation>Stopbit</translation>
    </message>
    <message>
        <source>Poll interval</source>
        <translation>Aflæsningsinterval</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>Tidsgrænse</translation>
    </message>
    <message>
        <source>Longest pause between attempts</source>
        <translation>Længste pause mellem forsøg</translation>
    </message>
    <message>
        <source>Variable: device responds</source>
        <translation>Variabel: enheden svarer</translation>
    </message>
    <message>
        <source>Client ID</source>
        <translation>Klient-id</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Bruger</translation>
    </message>
    <message>
        <source>Password file</source>
        <translation>Adgangskodefil</translation>
    </message>
    <message>
        <source>TLS encryption</source>
        <translation>TLS-kryptering</translation>
    </message>
    <message>
        <source>File of CA certificates</source>
        <translation>Fil med CA-certifikater</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variabel</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Retning</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabel</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Bit of the register</source>
        <translation>Bit i registret</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Byterækkefølge</translation>
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
        <translation>Sti i JSON-meddelelsen</translation>
    </message>
    <message>
        <source>Quality of service (0 to 2)</source>
        <translation>Servicekvalitet (QoS 0 til 2)</translation>
    </message>
    <message>
        <source>Retained message</source>
        <translation>Broker beholder meddelelsen (retain)</translation>
    </message>
    <message>
        <source>If the connection is lost</source>
        <translation>Ved tabt forbindelse</translation>
    </message>
    <message>
        <source>Safe value</source>
        <translation>Sikker værdi</translation>
    </message>
    <message>
        <source>Variable: channel is good</source>
        <translation>Variabel: kanalen er gyldig</translation>
    </message>
    <message>
        <source>Modbus TCP device</source>
        <translation>Modbus TCP-enhed</translation>
    </message>
    <message>
        <source>Modbus RTU device (serial)</source>
        <translation>Modbus RTU-enhed (seriel)</translation>
    </message>
    <message>
        <source>Modbus TCP server</source>
        <translation>Modbus TCP-server</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>MQTT-broker</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>Coil</translation>
    </message>
    <message>
        <source>Discrete input</source>
        <translation>Diskret indgang</translation>
    </message>
    <message>
        <source>Holding register</source>
        <translation>Holderegister</translation>
    </message>
    <message>
        <source>Input register</source>
        <translation>Inputregister (indgang)</translation>
    </message>
    <message>
        <source>Keep the last value</source>
        <translation>Behold den seneste værdi</translation>
    </message>
    <message>
        <source>Use the safe value</source>
        <translation>Brug den sikre værdi</translation>
    </message>
    <message>
        <source>Stop the controller</source>
        <translation>Stop styringen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Lige</translation>
    </message>
    <message>
        <source>Odd</source>
        <translation>Ulige</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Indgang</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Udgang</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nej</translation>
    </message>
</context>
<context>
    <name>Devices</name>
    <message>
        <source>This is not valid JSON; check the commas and quotes in front of this line</source>
        <translation>Dette er ikke gyldig JSON; kontroller kommaer og anførselstegn før denne linje</translation>
    </message>
    <message>
        <source>The file must be an object with a list named &quot;devices&quot;</source>
        <translation>Filen skal være et objekt med en liste ved navn ”devices”</translation>
    </message>
    <message>
        <source>Each entry of &quot;{0}&quot; must be an object in braces</source>
        <translation>Hver post i ”{0}” skal være et objekt i krøllede parenteser</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is missing; add it</source>
        <translation>”{0}” mangler; tilføj det</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a text in quotes</source>
        <translation>”{0}” skal være en tekst i anførselstegn</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be true or false</source>
        <translation>”{0}” skal være true eller false</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a number</source>
        <translation>”{0}” skal være et tal</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a whole number from {1} to {2}</source>
        <translation>”{0}” skal være et heltal fra {1} til {2}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a time such as &quot;100ms&quot; or &quot;2s&quot;, at least {1} ms and at most an hour</source>
        <translation>”{0}” skal være en tid som ”100ms” eller ”2s”, mindst {1}&#xa0;ms og højst en time</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; cannot be {1}; choose one of: {2}</source>
        <translation>”{0}” kan ikke være {1}; vælg en af: {2}</translation>
    </message>
    <message>
        <source>There is no field &quot;{0}&quot;; it is kept but has no effect</source>
        <translation>Der er intet felt ”{0}”; det bevares, men har ingen virkning</translation>
    </message>
    <message>
        <source>There is no field &quot;{0}&quot;; did you mean &quot;{1}&quot;?</source>
        <translation>Der er intet felt ”{0}”; mente du ”{1}”?</translation>
    </message>
    <message>
        <source>There are two devices named {0}; rename one</source>
        <translation>Der er to enheder med navnet {0}; omdøb den ene</translation>
    </message>
    <message>
        <source>{0} has two channels named {1}; rename one</source>
        <translation>{0} har to kanaler med navnet {1}; omdøb den ene</translation>
    </message>
    <message>
        <source>{0} is not a name; use letters, digits and underscores, and begin with a letter</source>
        <translation>{0} er ikke et gyldigt navn; brug bogstaver, cifre og understreger, og begynd med et bogstav</translation>
    </message>
    <message>
        <source>{0} is neither a host name nor an address, for example plc1.local or 192.168.0.10</source>
        <translation>{0} er hverken et værtsnavn eller en adresse, for eksempel plc1.local eller 192.168.0.10</translation>
    </message>
    <message>
        <source>{0} is not a serial port; write its path, for example /dev/ttyUSB0</source>
        <translation>{0} er ikke en seriel port; skriv dens sti, for eksempel /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>{0} and {1} both listen on port {2}; change one of the ports</source>
        <translation>{0} og {1} lytter begge på port {2}; skift den ene port</translation>
    </message>
    <message>
        <source>Ports below 1024 require special privileges; use a port such as 1502</source>
        <translation>Porte under 1024 kræver særlige rettigheder; brug en port som 1502</translation>
    </message>
    <message>
        <source>A channel of an MQTT device needs a &quot;topic&quot;, for example &quot;plant/level&quot;</source>
        <translation>En kanal på en MQTT-enhed kræver et ”topic”, for eksempel ”plant/level”</translation>
    </message>
    <message>
        <source>{0}: a channel has one topic, without the wildcards + and #</source>
        <translation>{0}: en kanal har ét topic, uden jokertegnene + og #</translation>
    </message>
    <message>
        <source>{0} is not a path into JSON; write for example /sensor/temperature</source>
        <translation>{0} er ikke en sti i JSON; skriv for eksempel /sensor/temperature</translation>
    </message>
    <message>
        <source>A device does not let others write its table &quot;{0}&quot;; use &quot;coil&quot; or &quot;holding&quot;, or the direction &quot;in&quot;</source>
        <translation>Tabellen ”{0}” i en enhed kan ikke skrives; brug ”coil” eller ”holding” eller retningen ”in”</translation>
    </message>
    <message>
        <source>Clients cannot write the table &quot;{0}&quot; of a server; use &quot;coil&quot; or &quot;holding&quot;, or the direction &quot;out&quot;</source>
        <translation>Klienter kan ikke skrive en servers tabel ”{0}”; brug ”coil” eller ”holding” eller retningen ”out”</translation>
    </message>
    <message>
        <source>{0} needs {1} {1:register|registers} from {2}, but 65535 is the last; choose a lower address</source>
        <translation>{0} kræver {1} {1:register|registre} fra {2}, men 65535 er det sidste; vælg en lavere adresse</translation>
    </message>
    <message>
        <source>&quot;bit&quot; selects one bit of a register; the type must then be BOOL</source>
        <translation>”bit” vælger én bit i et register; typen skal da være BOOL</translation>
    </message>
    <message>
        <source>The table &quot;{0}&quot; holds bits; the type must be BOOL</source>
        <translation>Tabellen ”{0}” indeholder bits; typen skal være BOOL</translation>
    </message>
    <message>
        <source>A BOOL in a register needs &quot;bit&quot;, from 0 to 15</source>
        <translation>En BOOL i et register kræver ”bit”, fra 0 til 15</translation>
    </message>
    <message>
        <source>Only an MQTT channel can be of type STRING; use a number or BOOL</source>
        <translation>Kun en MQTT-kanal kan være af typen STRING; brug et tal eller BOOL</translation>
    </message>
    <message>
        <source>&quot;scale&quot; must not be 0; omit it for 1</source>
        <translation>”scale” må ikke være 0; udelad den for 1</translation>
    </message>
    <message>
        <source>A {0} has no &quot;scale&quot; and &quot;offset&quot;; remove them</source>
        <translation>{0} har hverken ”scale” eller ”offset”; fjern dem</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}: {1}</translation>
    </message>
    <message>
        <source>{0} has no variable yet; enter one, or have the addresses proposed (stepwise devices PROJECT --propose)</source>
        <translation>{0} har ingen variabel endnu; angiv en, eller lad adresserne foreslå (stepwise devices PROJECT --propose)</translation>
    </message>
    <message>
        <source>{0} is of type {1} and cannot hold a {2}; use a variable of that type</source>
        <translation>{0} er af typen {1} og kan ikke indeholde en {2}; brug en variabel af den type</translation>
    </message>
    <message>
        <source>A {0} may not fit into {1} of type {2}; a value that does not fit leaves the variable as it is and makes the channel bad</source>
        <translation>En {0} passer måske ikke i {1} af typen {2}; en værdi, der ikke passer, lader variablen være uændret og gør kanalen ugyldig</translation>
    </message>
    <message>
        <source>{0} is an output of the program; an input channel needs %I or a variable</source>
        <translation>{0} er en udgang i programmet; en indgangskanal kræver %I eller en variabel</translation>
    </message>
    <message>
        <source>{0} is an input of the program; an output channel needs %Q or a variable</source>
        <translation>{0} er en indgang i programmet; en udgangskanal kræver %Q eller en variabel</translation>
    </message>
    <message>
        <source>{0} is a constant and cannot be written; choose a variable</source>
        <translation>{0} er en konstant og kan ikke skrives; vælg en variabel</translation>
    </message>
    <message>
        <source>{0} reports the quality of the channel and must be a BOOL or an integer</source>
        <translation>{0} angiver, om kanalen er gyldig, og skal være BOOL eller et heltal</translation>
    </message>
    <message>
        <source>{0} reports whether the device responds and must be a BOOL</source>
        <translation>{0} angiver, om enheden svarer, og skal være BOOL</translation>
    </message>
    <message>
        <source>&quot;onLoss&quot;: &quot;safe&quot; needs the value in &quot;safe&quot;</source>
        <translation>”onLoss”: ”safe” kræver værdien i ”safe”</translation>
    </message>
    <message>
        <source>{0} cannot be read; its first line must be the password</source>
        <translation>{0} kan ikke læses; dens første linje skal være adgangskoden</translation>
    </message>
    <message>
        <source>{0} cannot be read; it must contain the certificates of the authority (PEM)</source>
        <translation>{0} kan ikke læses; den skal indeholde udstederens certifikater (PEM)</translation>
    </message>
    <message>
        <source>no response within {0} ms; check the cable, the address and the unit number</source>
        <translation>intet svar inden for {0}&#xa0;ms; kontroller kabel, adresse og enhedsnummer</translation>
    </message>
    <message>
        <source>the connection ended: {0}; it is being set up again</source>
        <translation>forbindelsen blev afbrudt: {0}; den oprettes igen</translation>
    </message>
    <message>
        <source>the response does not match the request; check baud rate, parity and unit number</source>
        <translation>svaret passer ikke til forespørgslen; kontroller baudrate, paritet og enhedsnummer</translation>
    </message>
    <message>
        <source>the device rejects {0} {1}: {2}</source>
        <translation>enheden afviser {0} {1}: {2}</translation>
    </message>
    <message>
        <source>it does not know the function; choose another table</source>
        <translation>den kender ikke funktionen; vælg en anden tabel</translation>
    </message>
    <message>
        <source>it has no such address; check the address in its manual</source>
        <translation>den har ingen sådan adresse; kontroller adressen i dens manual</translation>
    </message>
    <message>
        <source>it does not accept the value; check the range in its manual</source>
        <translation>den tager ikke imod værdien; kontroller området i dens manual</translation>
    </message>
    <message>
        <source>it reports a failure; check the device</source>
        <translation>den melder en fejl; kontroller enheden</translation>
    </message>
    <message>
        <source>it is busy; the request will be repeated</source>
        <translation>den er optaget; forespørgslen gentages</translation>
    </message>
    <message>
        <source>the gateway cannot reach it; check the unit number and the cable after the gateway</source>
        <translation>gatewayen kan ikke nå den; kontroller enhedsnummeret og kablet bag den</translation>
    </message>
    <message>
        <source>cannot listen on {0}: {1}; choose another address or port</source>
        <translation>kan ikke lytte på {0}: {1}; vælg en anden adresse eller port</translation>
    </message>
    <message>
        <source>{0}: the message holds no value that can be read; check what the device publishes</source>
        <translation>{0}: meddelelsen indeholder ingen værdi, der kan læses; kontroller, hvad enheden udgiver</translation>
    </message>
    <message>
        <source>{0}: a value does not fit into the variable; use a larger type or a scale</source>
        <translation>{0}: en værdi passer ikke i variablen; brug en større type eller en skalering</translation>
    </message>
    <message>
        <source>no client has written for {0} ms; check the client and its address</source>
        <translation>ingen klient har skrevet i {0}&#xa0;ms; kontroller klienten og dens adresse</translation>
    </message>
    <message>
        <source>the broker rejects the connection: {0}; check the user and the password</source>
        <translation>brokeren afviser forbindelsen: {0}; kontroller bruger og adgangskode</translation>
    </message>
    <message>
        <source>the input {0} of the device {1} was lost; check the device and its cable</source>
        <translation>indgangen {0} fra enheden {1} gik tabt; kontroller enheden og dens kabel</translation>
    </message>
    <message>
        <source>the input {0} of the device {1} was lost: {2}</source>
        <translation>indgangen {0} fra enheden {1} gik tabt: {2}</translation>
    </message>
    <message>
        <source>Start or build the project first; the devices are connected to its controller</source>
        <translation>Start eller oversæt projektet først; enhederne er forbundet med dets styring</translation>
    </message>
    <message>
        <source>The project had no devices when its controller was built; add them and build again</source>
        <translation>Projektet havde ingen enheder, da styringens program blev oversat; tilføj dem, og oversæt igen</translation>
    </message>
    <message>
        <source>The devices had errors when the controller was built; correct them and build again</source>
        <translation>Enhederne havde fejl, da styringens program blev oversat; ret dem, og oversæt igen</translation>
    </message>
    <message>
        <source>Set the speed to real time first; devices cannot follow any other speed</source>
        <translation>Sæt først hastigheden til realtid; enheder kan ikke følge med en anden</translation>
    </message>
    <message>
        <source>The devices of an attached controller are connected there; detach to connect them here</source>
        <translation>Enhederne til en tilkoblet styring er forbundet dér; afbryd forbindelsen for at forbinde dem her</translation>
    </message>
    <message>
        <source>{0} and {1} write the same bytes: {2}; change an address</source>
        <translation>{0} og {1} skriver de samme bytes: {2}; ret en adresse</translation>
    </message>
    <message>
        <source>There is no free address left for {0}; give it a variable</source>
        <translation>Der er ingen ledig adresse tilbage til {0}; giv den en variabel</translation>
    </message>
    <message>
        <source>{0} has no channels, so nothing is exchanged; add one</source>
        <translation>{0} har ingen kanaler, så intet udveksles; tilføj en</translation>
    </message>
    <message>
        <source>cannot connect to {0}: {1}; check the address and the cable</source>
        <translation>kan ikke forbinde til {0}: {1}; kontroller adressen og kablet</translation>
    </message>
    <message>
        <source>{0} and {1} are both unit {2} of {3}; give one of them another number</source>
        <translation>{0} og {1} har begge adressen {2} på {3}; giv den ene en anden</translation>
    </message>
    <message>
        <source>{0} and {1} use {2} with different baud rates, parities or bits; set the same for both</source>
        <translation>{0} og {1} bruger {2} med forskellig baudrate, paritet eller bitantal; indstil det samme for begge</translation>
    </message>
    <message>
        <source>{0} and {1} both set {2} {3}; give each its own</source>
        <translation>{0} og {1} sætter begge {2} {3}; giv hver sit eget</translation>
    </message>
    <message>
        <source>{0} and {1} are both unit {2} at {3}; if one was copied from the other, change its address</source>
        <translation>{0} og {1} har begge adressen {2} på {3}; er den ene kopieret fra den anden, så ret dens adresse</translation>
    </message>
</context>
<context>
    <name>Diagnostics</name>
    <message>
        <source>Unterminated comment; close it with *)</source>
        <translation>Kommentaren er ikke afsluttet; luk den med *)</translation>
    </message>
    <message>
        <source>Unterminated string; add the closing quote</source>
        <translation>Strengen er ikke afsluttet; tilføj det afsluttende anførselstegn</translation>
    </message>
    <message>
        <source>Expected {0} before {1}</source>
        <translation>{0} forventes før {1}</translation>
    </message>
    <message>
        <source>A semicolon is missing here; add it</source>
        <translation>Her mangler et semikolon; tilføj det</translation>
    </message>
    <message>
        <source>{0} is missing for this {1}; add it</source>
        <translation>{0} mangler til denne {1}; tilføj det</translation>
    </message>
    <message>
        <source>This comparison has no effect; use := to assign</source>
        <translation>Denne sammenligning har ingen virkning; brug := til tildeling</translation>
    </message>
    <message>
        <source>An assignment is not a condition; use = to compare</source>
        <translation>En tildeling er ikke en betingelse; brug = til sammenligning</translation>
    </message>
    <message>
        <source>A colon is missing between the name and its type; add it</source>
        <translation>Der mangler et kolon mellem navnet og dets type; tilføj det</translation>
    </message>
    <message>
        <source>Decimal numbers use a point; write {0}</source>
        <translation>Decimaltal bruger punktum; skriv {0}</translation>
    </message>
    <message>
        <source>An open bound is written ARRAY[*] and is only allowed for VAR_IN_OUT; declare it there, or write a number</source>
        <translation>En åben grænse skrives ARRAY[*] og er kun tilladt for VAR_IN_OUT; erklær den der, eller skriv et tal</translation>
    </message>
    <message>
        <source>{0} is missing: the program unit ends here; add it</source>
        <translation>{0} mangler: programenheden slutter her; tilføj det</translation>
    </message>
    <message>
        <source>A semicolon is missing: the statement ends here; add it</source>
        <translation>Der mangler et semikolon: sætningen slutter her; tilføj det</translation>
    </message>
    <message>
        <source>Implicit conversion from {0} to {1} may lose data; convert it explicitly</source>
        <translation>Implicit konvertering fra {0} til {1} kan miste data; konverter eksplicit</translation>
    </message>
    <message>
        <source>{0} is an IN_OUT parameter and needs a variable of type {1}</source>
        <translation>{0} er en IN_OUT-parameter og kræver en variabel af typen {1}</translation>
    </message>
    <message>
        <source>{0} has only the bits 0 to {1}; use one of them</source>
        <translation>{0} har kun bittene 0 til {1}; brug en af dem</translation>
    </message>
    <message>
        <source>{0} is ambiguous: {1}; write the namespace before it</source>
        <translation>{0} er flertydig: {1}; skriv navnerummet foran</translation>
    </message>
    <message>
        <source>The character {0} is not in STRING ({1}); use WSTRING, or &quot;stringEncoding&quot;: &quot;UTF-8&quot; in project.json</source>
        <translation>Tegnet {0} findes ikke i STRING ({1}); brug WSTRING, eller &quot;stringEncoding&quot;: &quot;UTF-8&quot; i project.json</translation>
    </message>
    <message>
        <source>{0} and {1} are compared as {2}; convert one of them</source>
        <translation>{0} og {1} sammenlignes som {2}; konverter den ene</translation>
    </message>
    <message>
        <source>{0} is not checked against the enumeration {1}; use one of its names</source>
        <translation>{0} kontrolleres ikke mod enumerationen {1}; brug et af dens navne</translation>
    </message>
    <message>
        <source>{0} is {1}; write {2}</source>
        <translation>{0} er {1}; skriv {2}</translation>
    </message>
    <message>
        <source>{0} contains itself; use a REFERENCE TO</source>
        <translation>{0} indeholder sig selv; brug REFERENCE TO</translation>
    </message>
    <message>
        <source>The parameters of {0} must match those of the overridden method; copy its declarations</source>
        <translation>Parametrene i {0} skal svare til den tilsidesatte metodes; kopier dens erklæringer</translation>
    </message>
    <message>
        <source>There are several programs and no CONFIGURATION; name one of them Main or write a CONFIGURATION</source>
        <translation>Der er flere programmer og ingen CONFIGURATION; omdøb ét til Main, eller skriv en CONFIGURATION</translation>
    </message>
    <message>
        <source>The range {0}..{1} is not valid: the lower bound is above the upper bound or there are too many elements; correct the bounds</source>
        <translation>Området {0}..{1} er ugyldigt: den nedre grænse er over den øvre, eller der er for mange elementer; ret grænserne</translation>
    </message>
    <message>
        <source>{0} has an incomplete address; complete it in a VAR_CONFIG</source>
        <translation>{0} har en ufuldstændig adresse; gør den færdig i en VAR_CONFIG</translation>
    </message>
    <message>
        <source>{0} may call itself; the depth of recursion is limited at run time; a loop is safer</source>
        <translation>{0} kan kalde sig selv; rekursionsdybden er begrænset under kørslen; en løkke er sikrere</translation>
    </message>
    <message>
        <source>The steps before this transition cannot be active together; start them from one simultaneous branch</source>
        <translation>Trinnene før denne transition kan ikke være aktive samtidig; start dem fra én parallelgren</translation>
    </message>
    <message>
        <source>This transition is always true; the step before it lasts one scan; write the condition to wait for</source>
        <translation>Denne transition er altid sand; trinnet før den er kun aktivt i ét scan; skriv den betingelse, der skal ventes på</translation>
    </message>
    <message>
        <source>The qualifier {0} needs a time, for example T#2s</source>
        <translation>Kvalifikatoren {0} kræver en tid, for eksempel T#2s</translation>
    </message>
    <message>
        <source>{0} needs a current result; load one with LD</source>
        <translation>{0} kræver et aktuelt resultat; indlæs et med LD</translation>
    </message>
    <message>
        <source>{0} is not a value of the strict enumeration {1}; use one of its names</source>
        <translation>{0} er ikke en værdi i den strikte enumeration {1}; brug et af dens navne</translation>
    </message>
    <message>
        <source>{0} is a strict enumeration and cannot be used in arithmetic; convert the value with {1}</source>
        <translation>{0} er en strikt enumeration og kan ikke bruges i beregninger; konverter værdien med {1}</translation>
    </message>
    <message>
        <source>{0} cannot compare {1} as a whole; compare the members one by one</source>
        <translation>{0} kan ikke sammenligne {1} som helhed; sammenlign medlemmerne enkeltvis</translation>
    </message>
    <message>
        <source>A CASE selector must be an integer, enumeration or character, not {0}; use IF and ELSIF</source>
        <translation>En CASE-selektor skal være et heltal, en enumeration eller et tegn, ikke {0}; brug IF og ELSIF</translation>
    </message>
    <message>
        <source>{0} and {1} share storage at {2}; move one of them or write STRUCT OVERLAP</source>
        <translation>{0} og {1} deler lageret ved {2}; flyt det ene, eller skriv STRUCT OVERLAP</translation>
    </message>
    <message>
        <source>A member&apos;s address is relative to the start of its structure (%B4, %X4.1), not {0}</source>
        <translation>Et medlems adresse er relativ til strukturens start (%B4, %X4.1), ikke {0}</translation>
    </message>
    <message>
        <source>{0} and {1} share the address {2}; {3} is free</source>
        <translation>{0} og {1} deler adressen {2}; {3} er ledig</translation>
    </message>
    <message>
        <source>{0} belongs to the chart and must be {1}</source>
        <translation>{0} hører til SFC-diagrammet og skal være {1}</translation>
    </message>
    <message>
        <source>{0} has no effect without {1}; declare both</source>
        <translation>{0} har ingen virkning uden {1}; erklær begge</translation>
    </message>
    <message>
        <source>A step lists its actions here; write statements in an ACTION</source>
        <translation>Et trin angiver her sine aktioner; skriv sætninger i en ACTION</translation>
    </message>
    <message>
        <source>No transition leads away from step {0}; the chart ends here; add a TRANSITION if it should go on</source>
        <translation>Ingen transition fører væk fra trin {0}; SFC-diagrammet slutter her; tilføj en TRANSITION, hvis det skal fortsætte</translation>
    </message>
    <message>
        <source>{0} is also a variable; steps and calls mean the ACTION; rename one of the two</source>
        <translation>{0} er også en variabel; trin og kald betyder aktionen; omdøb en af dem</translation>
    </message>
    <message>
        <source>Use {1} instead of {0} in Structured Text</source>
        <translation>Brug {1} i stedet for {0} i struktureret tekst</translation>
    </message>
    <message>
        <source>The task {0} has no INTERVAL above zero and no SINGLE; it runs in every scan; give it an INTERVAL to slow it down</source>
        <translation>Tasken {0} har intet INTERVAL over nul og intet SINGLE; den kører i hvert scan; angiv INTERVAL for at gøre den langsommere</translation>
    </message>
    <message>
        <source>{0} is read as {1}; write a time with its unit</source>
        <translation>{0} læses som {1}; skriv en tid med enhed</translation>
    </message>
    <message>
        <source>The address {0} has {1} {1:bit|bits}, {2} has {3}; write {4}</source>
        <translation>Adressen {0} har {1} bit, {2} har {3}; skriv {4}</translation>
    </message>
    <message>
        <source>{0} is an input declared CONSTANT and is assigned to here; remove CONSTANT or assign to another variable</source>
        <translation>{0} er erklæret som indgang med CONSTANT og tildeles en værdi her; fjern CONSTANT, eller tildel til en anden variabel</translation>
    </message>
    <message>
        <source>{0}</source>
        <translation>{0}</translation>
    </message>
    <message>
        <source>The condition {0} is not known; combine defined, hasvalue, hasattribute and hastype with NOT, AND and OR</source>
        <translation>Betingelsen {0} er ukendt; kombiner defined, hasvalue, hasattribute og hastype med NOT, AND og OR</translation>
    </message>
    <message>
        <source>The pragma {0} is missing for this {1}; add it</source>
        <translation>Pragmaet {0} mangler til dette {1}; tilføj det</translation>
    </message>
    <message>
        <source>The character {0} has no meaning here; remove it</source>
        <translation>Tegnet {0} har ingen betydning her; fjern det</translation>
    </message>
    <message>
        <source>This is nested too deeply to be compiled; split it into several statements or units</source>
        <translation>Dette er indlejret for dybt til at blive oversat; del det op i flere sætninger eller programenheder</translation>
    </message>
    <message>
        <source>Code in C is not executed; write it in ST</source>
        <translation>Kode i C udføres ikke; skriv den i ST</translation>
    </message>
    <message>
        <source>{0} is specified twice; remove one of the two</source>
        <translation>{0} er angivet to gange; fjern den ene</translation>
    </message>
    <message>
        <source>{0} is not an array or string; remove the index or declare it as an ARRAY</source>
        <translation>{0} er hverken array eller streng; fjern indekset, eller erklær den som ARRAY</translation>
    </message>
    <message>
        <source>The divisor is always zero; divide by another value</source>
        <translation>Divisoren er altid nul; divider med en anden værdi</translation>
    </message>
    <message>
        <source>A constant is needed here; write a value or the name of a VAR CONSTANT</source>
        <translation>Her kræves en konstant; skriv en værdi eller navnet på en VAR CONSTANT</translation>
    </message>
    <message>
        <source>{0} is not a pointer or reference; use it without ^ or declare it with REF_TO</source>
        <translation>{0} er hverken pointer eller reference; brug den uden ^, eller erklær den med REF_TO</translation>
    </message>
    <message>
        <source>{0} does not return a value; call it in a statement of its own</source>
        <translation>{0} returnerer ingen værdi; kald den i en sætning for sig</translation>
    </message>
    <message>
        <source>{0} is abstract and cannot be instantiated; use a block that extends it</source>
        <translation>{0} er abstrakt og kan ikke instantieres; brug en blok, der udvider den</translation>
    </message>
    <message>
        <source>{0} is {1} and cannot be used here; make it PUBLIC or use it inside its block</source>
        <translation>{0} er {1} og kan ikke bruges her; gør den PUBLIC, eller brug den inden i dens blok</translation>
    </message>
    <message>
        <source>The result of {0} is not used; assign it to a variable</source>
        <translation>Resultatet af {0} bruges ikke; tildel det til en variabel</translation>
    </message>
    <message>
        <source>{0} is declared twice; rename or remove one of the two</source>
        <translation>{0} er erklæret to gange; omdøb eller fjern den ene</translation>
    </message>
    <message>
        <source>There is no type {0}; declare it or add the library that contains it</source>
        <translation>Der er ingen type {0}; erklær den, eller tilføj det bibliotek, der indeholder den</translation>
    </message>
    <message>
        <source>{0} is never used; remove its declaration</source>
        <translation>{0} bruges aldrig; fjern erklæringen</translation>
    </message>
    <message>
        <source>{0} is read but never written; give it a value or declare it as CONSTANT</source>
        <translation>{0} læses, men skrives aldrig; giv den en værdi, eller erklær den som CONSTANT</translation>
    </message>
    <message>
        <source>This is never executed; remove it or change what is before it</source>
        <translation>Dette udføres aldrig; fjern det, eller ret det, der står før</translation>
    </message>
    <message>
        <source>The result of {0} is not set on every path; assign it before the first RETURN or IF</source>
        <translation>Resultatet af {0} sættes ikke på alle stier; tildel det før første RETURN eller IF</translation>
    </message>
    <message>
        <source>CASE has no branch for {0} and no ELSE; add one of them</source>
        <translation>CASE har ingen gren for {0} og ingen ELSE; tilføj en af delene</translation>
    </message>
    <message>
        <source>{0} already has a branch; remove one of the two</source>
        <translation>{0} har allerede en gren; fjern den ene</translation>
    </message>
    <message>
        <source>The task {0} is declared twice; rename one of the two</source>
        <translation>Tasken {0} er erklæret to gange; omdøb den ene</translation>
    </message>
    <message>
        <source>There is no task {0}; declare it with TASK in this configuration</source>
        <translation>Der er ingen task {0}; erklær den med TASK i denne konfiguration</translation>
    </message>
    <message>
        <source>{0} does not implement {1} of {2}; add it</source>
        <translation>{0} implementerer ikke {1} fra {2}; tilføj det</translation>
    </message>
    <message>
        <source>{0} is FINAL and cannot be extended or overridden; remove FINAL or use another base</source>
        <translation>{0} er FINAL og kan hverken udvides eller tilsidesættes; fjern FINAL, eller brug en anden basis</translation>
    </message>
    <message>
        <source>There is no label {0}; write it with a colon before a statement of this unit</source>
        <translation>Der er ingen etiket {0}; skriv den med kolon før en sætning i denne programenhed</translation>
    </message>
    <message>
        <source>The variables need {0} bytes; the maximum is {1}: make arrays or strings smaller</source>
        <translation>Variablerne kræver {0} byte; maksimum er {1}: gør arrays eller strenge mindre</translation>
    </message>
    <message>
        <source>There is no PROGRAM to run; add one</source>
        <translation>Der er intet PROGRAM at køre; tilføj et</translation>
    </message>
    <message>
        <source>There is no namespace {0}; declare it or add the library that contains it</source>
        <translation>Der er intet navnerum {0}; erklær det, eller tilføj det bibliotek, der indeholder det</translation>
    </message>
    <message>
        <source>{0} is not a variable of this configuration; write program instance and variable, as in Main.x</source>
        <translation>{0} er ikke en variabel i denne konfiguration; skriv programinstans og variabel, som i Main.x</translation>
    </message>
    <message>
        <source>{0} restarts on every call because functions keep no state; use a FUNCTION_BLOCK</source>
        <translation>{0} starter forfra ved hvert kald, fordi funktioner ikke gemmer nogen tilstand; brug en FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>Too many initial values: {0} for {1} {1:element|elements}; remove some or enlarge the array</source>
        <translation>For mange startværdier: {0} til {1} {1:element|elementer}; fjern nogle, eller gør arrayet større</translation>
    </message>
    <message>
        <source>This loop never ends and would stop the controller; give it a condition or an EXIT</source>
        <translation>Denne løkke slutter aldrig; styringen ville blive hængende i den; giv den en betingelse eller en EXIT</translation>
    </message>
    <message>
        <source>{0} is marked OVERRIDE, but no base has a method with this name; remove OVERRIDE or correct the name</source>
        <translation>{0} er mærket OVERRIDE, men ingen basisblok har en metode med dette navn; fjern OVERRIDE, eller ret navnet</translation>
    </message>
    <message>
        <source>The chart has no INITIAL_STEP; declare its first step with INITIAL_STEP instead of STEP</source>
        <translation>SFC-diagrammet har ingen INITIAL_STEP; erklær dets første trin med INITIAL_STEP i stedet for STEP</translation>
    </message>
    <message>
        <source>The chart has two initial steps: {0} and {1}; declare one of them with STEP</source>
        <translation>SFC-diagrammet har to starttrin: {0} og {1}; erklær det ene med STEP</translation>
    </message>
    <message>
        <source>There is no step {0}; declare it or correct the name</source>
        <translation>Der er intet trin {0}; erklær det, eller ret navnet</translation>
    </message>
    <message>
        <source>No transition leads to step {0}; it can never become active: add a TRANSITION to it</source>
        <translation>Ingen transition fører til trin {0}; det kan aldrig blive aktivt: tilføj en TRANSITION til det</translation>
    </message>
    <message>
        <source>There is no action or BOOL variable {0}; add an ACTION or declare the variable</source>
        <translation>Der er ingen aktion eller BOOL-variabel {0}; tilføj en ACTION, eller erklær variablen</translation>
    </message>
    <message>
        <source>The step {0} is declared twice; rename or remove one of the two</source>
        <translation>Trinnet {0} er erklæret to gange; omdøb eller fjern det ene</translation>
    </message>
    <message>
        <source>{0} appears twice in this step with qualifier {1}; remove one of the two</source>
        <translation>{0} forekommer to gange i dette trin med kvalifikatoren {1}; fjern den ene</translation>
    </message>
    <message>
        <source>The parenthesis of this instruction is not closed; add an instruction ) after its operands</source>
        <translation>Parentesen i denne instruktion er ikke lukket; tilføj en instruktion ) efter operanderne</translation>
    </message>
    <message>
        <source>{0} needs memory that the project does not set aside; write &quot;memoryForNew&quot;: 65536 into project.json</source>
        <translation>{0} kræver hukommelse, som projektet ikke afsætter; skriv &quot;memoryForNew&quot;: 65536 i project.json</translation>
    </message>
    <message>
        <source>{0} is not a block of this program and cannot have a task of its own; name one of its blocks</source>
        <translation>{0} er ikke en blok i dette program og kan ikke have sin egen task; angiv en af dets blokke</translation>
    </message>
    <message>
        <source>{0} cannot hold an exception code; declare it as __SYSTEM.ExceptionCode</source>
        <translation>{0} kan ikke indeholde en undtagelseskode; erklær den som __SYSTEM.ExceptionCode</translation>
    </message>
    <message>
        <source>{0} converts the number, as in CODESYS; to keep the bits, put both types into a UNION</source>
        <translation>{0} konverterer tallet, som i CODESYS; læg begge typer i en UNION for at bevare bittene</translation>
    </message>
    <message>
        <source>{0} calls itself, which is not allowed: {1}; use a loop instead</source>
        <translation>{0} kalder sig selv, hvilket ikke er tilladt: {1}; brug en løkke i stedet</translation>
    </message>
    <message>
        <source>The loop variable {0} is changed inside its loop; use WHILE or another variable</source>
        <translation>Løkkevariablen {0} ændres inde i sin løkke; brug WHILE eller en anden variabel</translation>
    </message>
    <message>
        <source>There is no global variable {0} of type {1}; declare it in VAR_GLOBAL</source>
        <translation>Der er ingen global variabel {0} af typen {1}; erklær den i VAR_GLOBAL</translation>
    </message>
    <message>
        <source>The text has {0} and will be truncated to {1}; declare a longer string</source>
        <translation>Teksten har {0} og afkortes til {1}; erklær en længere streng</translation>
    </message>
    <message>
        <source>This integer division discards the fraction before the conversion to {0}; convert an operand first</source>
        <translation>Denne heltalsdivision fjerner decimalerne før konverteringen til {0}; konverter først en operand</translation>
    </message>
    <message>
        <source>{0} is computed as {1} and may overflow before the conversion to {2}; convert an operand first</source>
        <translation>{0} beregnes som {1} og kan løbe over før konverteringen til {2}; konverter først en operand</translation>
    </message>
    <message>
        <source>{0} is not an IL operator; use one such as LD, ST, AND or JMP</source>
        <translation>{0} er ikke en IL-operator; brug for eksempel LD, ST, AND eller JMP</translation>
    </message>
    <message>
        <source>This array has {0} {0:dimension|dimensions}, not {1}; write an index for each</source>
        <translation>Dette array har {0} {0:dimension|dimensioner}, ikke {1}; skriv et indeks for hver</translation>
    </message>
    <message>
        <source>{0} is not a valid {1} literal; check its prefix, digits and units</source>
        <translation>{0} er ikke en gyldig literal ({1}); kontroller præfiks, cifre og enheder</translation>
    </message>
    <message>
        <source>Unexpected {0}; remove it or complete the statement before it</source>
        <translation>Uventet {0}; fjern det, eller fuldend sætningen før det</translation>
    </message>
    <message>
        <source>The pragma {0} is not known and has no effect; remove it or correct its name</source>
        <translation>Pragmaet {0} er ukendt og uden virkning; fjern det, eller ret navnet</translation>
    </message>
    <message>
        <source>{0} is a keyword and cannot be used as a name; choose another name</source>
        <translation>{0} er et nøgleord og kan ikke bruges som navn; vælg et andet navn</translation>
    </message>
    <message>
        <source>{0} is not declared; declare it or correct the name</source>
        <translation>{0} er ikke erklæret; erklær det, eller ret navnet</translation>
    </message>
    <message>
        <source>{0} has no member {1}; correct the name or add the member</source>
        <translation>{0} har intet medlem {1}; ret navnet, eller tilføj medlemmet</translation>
    </message>
    <message>
        <source>{0} cannot be converted to {1}; use a value of that type or a conversion function</source>
        <translation>{0} kan ikke konverteres til {1}; brug en værdi af denne type eller en konverteringsfunktion</translation>
    </message>
    <message>
        <source>{0} cannot be assigned to; assign to a variable</source>
        <translation>{0} kan ikke tildeles en værdi; tildel til en variabel</translation>
    </message>
    <message>
        <source>{0} cannot be used with {1}; convert the operand first</source>
        <translation>{0} kan ikke bruges med {1}; konverter operanden først</translation>
    </message>
    <message>
        <source>{0} cannot combine {1} and {2}; convert one of them</source>
        <translation>{0} kan ikke kombinere {1} og {2}; konverter den ene</translation>
    </message>
    <message>
        <source>{0} cannot be called; call a function, a method or an instance of a block</source>
        <translation>{0} kan ikke kaldes; kald en funktion, en metode eller en blokinstans</translation>
    </message>
    <message>
        <source>{0} has no parameter {1}; correct the name or declare the parameter</source>
        <translation>{0} har ingen parameter {1}; ret navnet, eller erklær parameteren</translation>
    </message>
    <message>
        <source>The argument for {1} of {0} is missing; add it to the call</source>
        <translation>Argumentet for {1} i {0} mangler; tilføj det i kaldet</translation>
    </message>
    <message>
        <source>{0} takes {1} {1:argument|arguments}; remove the others</source>
        <translation>{0} tager {1} {1:argument|argumenter}; fjern resten</translation>
    </message>
    <message>
        <source>The index {0} is outside {1}..{2}; correct it or enlarge the array</source>
        <translation>Indekset {0} ligger uden for {1}..{2}; ret indekset, eller gør arrayet større</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}; use another value or a larger type</source>
        <translation>{0} passer ikke i {1}; brug en anden værdi eller en større type</translation>
    </message>
    <message>
        <source>The condition must be BOOL, not {0}; add a comparison</source>
        <translation>Betingelsen skal være BOOL, ikke {0}; tilføj en sammenligning</translation>
    </message>
    <message>
        <source>The address {0} is outside {1}; use an address in that range</source>
        <translation>Adressen {0} ligger uden for {1}; brug en adresse i dette område</translation>
    </message>
    <message>
        <source>{0} is not allowed in a watch or binding, which cannot have side effects; do it in the program</source>
        <translation>{0} er ikke tilladt i en overvågning eller binding, som ikke må have sideeffekter; gør det i programmet</translation>
    </message>
    <message>
        <source>A reference needs a variable that has an address; assign the value to a variable first</source>
        <translation>En reference kræver en variabel, der har en adresse; tildel først værdien til en variabel</translation>
    </message>
    <message>
        <source>An index must be an integer, not {0}; convert it</source>
        <translation>Et indeks skal være et heltal, ikke {0}; konverter det</translation>
    </message>
    <message>
        <source>{1} cannot extend {0}; choose a base of the same kind</source>
        <translation>{1} kan ikke udvide {0}; vælg en basis af samme slags</translation>
    </message>
    <message>
        <source>{0} is not allowed {1}; move or remove it</source>
        <translation>{0} er ikke tilladt {1}; flyt eller fjern det</translation>
    </message>
    <message>
        <source>{0} is only allowed inside a loop; move or remove it</source>
        <translation>{0} er kun tilladt i en løkke; flyt eller fjern det</translation>
    </message>
    <message>
        <source>Step {0} can become active twice at the same time: the branches from here do not join; join them with one transition</source>
        <translation>Trin {0} kan blive aktivt to gange samtidig: grenene herfra samles ikke; saml dem med én transition</translation>
    </message>
    <message>
        <source>{0} is only allowed in a TEST; move it there</source>
        <translation>{0} er kun tilladt i en TEST; flyt det dertil</translation>
    </message>
    <message>
        <source>This is not text in UTF-8; save the file as UTF-8, or remove it from the project if it is not a text file</source>
        <translation>Dette er ikke tekst i UTF-8; gem filen som UTF-8, eller fjern den fra projektet, hvis den ikke er en tekstfil</translation>
    </message>
    <message>
        <source>{0} is not an action qualifier; use N, R, S, L, D, P, P0, P1, SD, DS or SL</source>
        <translation>{0} er ikke en aktionskvalifikator; brug N, R, S, L, D, P, P0, P1, SD, DS eller SL</translation>
    </message>
    <message>
        <source>{0} needs a time after :=, for example T#5s; write one or remove the pragma</source>
        <translation>{0} kræver en tid efter :=, for eksempel T#5s; skriv en, eller fjern pragmaet</translation>
    </message>
</context>
<context>
    <name>DiskChange</name>
    <message>
        <source>Changed outside</source>
        <translation>Ændret udefra</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and here too.</source>
        <translation>%1 blev ændret af et andet program, og her også.</translation>
    </message>
    <message>
        <source>Compare both side by side, load the file from disk and lose the changes made here, or keep what is here and replace the file with the next save?</source>
        <translation>Sammenlign begge side om side, indlæs filen fra disken og mist ændringerne her, eller behold det, der er her, og erstat filen, næste gang der gemmes?</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Sammenlign…</translation>
    </message>
    <message>
        <source>Load from Disk</source>
        <translation>Indlæs fra disken</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Behold min version</translation>
    </message>
</context>
<context>
    <name>EditHistory</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Fortryd</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gentag</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>division by zero; check the divisor first</source>
        <translation>division med nul; kontroller først divisoren</translation>
    </message>
    <message>
        <source>index {0} is used on an empty array; check its bounds first</source>
        <translation>adgang til indeks {0} i et tomt array; kontroller først dets grænser</translation>
    </message>
    <message>
        <source>index {0} is outside {1}..{2}; use an index in this range or enlarge the array</source>
        <translation>indeks {0} ligger uden for {1}..{2}; brug et indeks i dette område, eller gør arrayet større</translation>
    </message>
    <message>
        <source>character {0} is read from an empty string; check LEN first</source>
        <translation>adgang til tegn {0} i en tom streng; kontroller først LEN</translation>
    </message>
    <message>
        <source>character {0} is outside {1}..{2} of the string; use an index in this range</source>
        <translation>tegn {0} ligger uden for {1}..{2} i strengen; brug et indeks i dette område</translation>
    </message>
    <message>
        <source>calls are nested too deeply; check for endless recursion</source>
        <translation>kald er indlejret for dybt; kontroller for endeløs rekursion</translation>
    </message>
    <message>
        <source>the called method has no body; override it in the block that is called</source>
        <translation>den kaldte metode har ingen krop; tilsidesæt den i den blok, der kaldes</translation>
    </message>
    <message>
        <source>the scan was aborted</source>
        <translation>scannet blev afbrudt</translation>
    </message>
    <message>
        <source>there is no expression; enter one</source>
        <translation>der er intet udtryk; indtast et</translation>
    </message>
    <message>
        <source>the program of this scan does not have it; choose a later scan</source>
        <translation>findes ikke i programmet til dette scan; vælg et senere scan</translation>
    </message>
    <message>
        <source>has no value here</source>
        <translation>har ingen værdi her</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}: {1}</translation>
    </message>
    <message>
        <source>simulation: {0}</source>
        <translation>simulering: {0}</translation>
    </message>
    <message>
        <source>warm</source>
        <translation>varm</translation>
    </message>
    <message>
        <source>cold</source>
        <translation>kold</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>oprindelig</translation>
    </message>
    <message>
        <source>in the middle of a scan</source>
        <translation>midt i et scan</translation>
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
        <translation>filen eller mappen findes ikke; kontroller stien</translation>
    </message>
    <message>
        <source>permission denied; check the permissions of the file and its folder</source>
        <translation>ingen tilladelse; kontroller rettighederne til filen og dens mappe</translation>
    </message>
    <message>
        <source>no space left on the device; free some space and try again</source>
        <translation>der er ikke mere plads på drevet; frigør plads, og prøv igen</translation>
    </message>
    <message>
        <source>it is a folder; choose a file</source>
        <translation>det er en mappe; vælg en fil</translation>
    </message>
    <message>
        <source>it is not a folder; choose a folder</source>
        <translation>det er ikke en mappe; vælg en mappe</translation>
    </message>
    <message>
        <source>the device reports a read or write error; check the drive or the cable</source>
        <translation>drevet melder en læse- eller skrivefejl; kontroller drevet eller kablet</translation>
    </message>
    <message>
        <source>it already exists; choose another name</source>
        <translation>det findes allerede; vælg et andet navn</translation>
    </message>
    <message>
        <source>the file is too large; choose a smaller one</source>
        <translation>filen er for stor; vælg en mindre</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>afbrudt</translation>
    </message>
    <message>
        <source>This is not a regular file and cannot be replaced; choose another name</source>
        <translation>Det er ikke en almindelig fil og kan ikke erstattes; vælg et andet navn</translation>
    </message>
    <message>
        <source>The recording cannot be written: {0}</source>
        <translation>Optagelsen kan ikke skrives: {0}</translation>
    </message>
    <message>
        <source>The recording cannot be read: {0}</source>
        <translation>Optagelsen kan ikke læses: {0}</translation>
    </message>
    <message>
        <source>This version of Stepwise lays out the program&apos;s variables differently; open the recording with the version that made it</source>
        <translation>Denne version af Stepwise placerer programmets variabler anderledes; åbn optagelsen med den version, der lavede den</translation>
    </message>
    <message>
        <source>The recording cannot be opened: {0}</source>
        <translation>Optagelsen kan ikke åbnes: {0}</translation>
    </message>
    <message>
        <source>its program has errors; open the recording with the version of Stepwise that made it</source>
        <translation>dens program har fejl; åbn optagelsen med den version af Stepwise, der lavede den</translation>
    </message>
    <message>
        <source>The recording contains no program; record the run again with this version</source>
        <translation>Optagelsen indeholder intet program; optag kørslen igen med denne version</translation>
    </message>
    <message>
        <source>This scan is no longer in the recording; choose a later one</source>
        <translation>Dette scan er ikke længere i optagelsen; vælg et senere</translation>
    </message>
    <message>
        <source>The program that recorded this scan is no longer available; choose a scan after the last change of the program</source>
        <translation>Programmet, der optog dette scan, er ikke længere til rådighed; vælg et scan efter den sidste ændring af programmet</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is ambiguous; write one of {1}</source>
        <translation>”{0}” er flertydig; skriv en af {1}</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; has no variable &apos;{1}&apos;; did you mean &apos;{2}&apos;?</source>
        <translation>”{0}” har ingen variabel ”{1}”; mente du ”{2}”?</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; has no variable &apos;{1}&apos;; check the name</source>
        <translation>”{0}” har ingen variabel ”{1}”; kontroller navnet</translation>
    </message>
    <message>
        <source>there is no variable &apos;{0}&apos;; did you mean &apos;{1}&apos;?</source>
        <translation>der er ingen variabel ”{0}”; mente du ”{1}”?</translation>
    </message>
    <message>
        <source>there is no variable &apos;{0}&apos;; check the name or declare it</source>
        <translation>der er ingen variabel ”{0}”; kontroller navnet, eller erklær den</translation>
    </message>
    <message>
        <source>a variable of type {1} has no member &apos;{0}&apos;; check the name</source>
        <translation>en variabel af typen {1} har intet medlem ”{0}”; kontroller navnet</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is a VAR_IN_OUT; write the variable that is connected to it</source>
        <translation>”{0}” er en VAR_IN_OUT; skriv den variabel, der er forbundet med den</translation>
    </message>
    <message>
        <source>{0} needs {1} {1:index|indices}, not {2}; write one for each dimension</source>
        <translation>{0} kræver {1} {1:indeks|indekser}, ikke {2}; skriv ét for hver dimension</translation>
    </message>
    <message>
        <source>bit {0} is outside 0..{1}; use a bit in this range</source>
        <translation>bit {0} ligger uden for 0..{1}; brug en bit i dette område</translation>
    </message>
    <message>
        <source>part {0} is outside 0..{1}; use a part in this range</source>
        <translation>del {0} ligger uden for 0..{1}; brug en del i dette område</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is not an address; write for example %IX0.0, %QB4 or %MW2</source>
        <translation>”{0}” er ikke en adresse; skriv for eksempel %IX0.0, %QB4 eller %MW2</translation>
    </message>
    <message>
        <source>the path cannot be read from &apos;{0}&apos; on; write for example Main.a[2].x</source>
        <translation>stien kan ikke læses fra ”{0}”; skriv for eksempel Main.a[2].x</translation>
    </message>
    <message>
        <source>{0} is forced; release the force before writing</source>
        <translation>{0} er forceret; ophæv forceringen før skrivning</translation>
    </message>
    <message>
        <source>the variable is not forced; there is nothing to release</source>
        <translation>variablen er ikke forceret; der er intet at ophæve</translation>
    </message>
    <message>
        <source>the initial values of the new program cause a fault: {0}</source>
        <translation>det nye programs startværdier giver en fejl: {0}</translation>
    </message>
    <message>
        <source>The retain file cannot be written: {0}</source>
        <translation>Retain-filen kan ikke skrives: {0}</translation>
    </message>
    <message>
        <source>The retain file cannot be read: {0}; the program starts with its initial values</source>
        <translation>Retain-filen kan ikke læses: {0}; programmet starter med sine startværdier</translation>
    </message>
    <message>
        <source>The retain file is damaged; the program starts with its initial values</source>
        <translation>Retain-filen er beskadiget; programmet starter med sine startværdier</translation>
    </message>
    <message>
        <source>{0}; it is kept as {1}</source>
        <translation>{0}; den er gemt som {1}</translation>
    </message>
    <message>
        <source>{0} retained {0:value does|values do} not fit the program: {1}; they start with their initial values</source>
        <translation>{0} {0:remanent værdi|remanente værdier} passer ikke til programmet: {1}; de starter med deres startværdier</translation>
    </message>
    <message>
        <source>{0} does not fit into a variable of type {1}; enter a value in its range</source>
        <translation>{0} passer ikke i en variabel af typen {1}; indtast en værdi i dens område</translation>
    </message>
    <message>
        <source>the value does not fit into a variable of type {0}; enter one in its range</source>
        <translation>værdien passer ikke i en variabel af typen {0}; indtast en i dens område</translation>
    </message>
    <message>
        <source>{0} is outside {1}..{2}; enter a value in this range</source>
        <translation>{0} ligger uden for {1}..{2}; indtast en værdi i dette område</translation>
    </message>
    <message>
        <source>a character of the text does not fit into a STRING; use a WSTRING</source>
        <translation>et tegn i teksten kan ikke gemmes i en STRING; brug en WSTRING</translation>
    </message>
    <message>
        <source>a reference can only be set to NULL from outside; assign a variable to it in the program</source>
        <translation>en reference kan udefra kun sættes til NULL; tildel den en variabel i programmet</translation>
    </message>
    <message>
        <source>{0} is not a value for {1}, which is {2}</source>
        <translation>{0} er ikke en værdi for {1}, som er {2}</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}, which is {2}</source>
        <translation>{0} passer ikke i {1}, som er {2}</translation>
    </message>
    <message>
        <source>{0}; {1}</source>
        <translation>{0}; {1}</translation>
    </message>
    <message>
        <source>did you mean {0}?</source>
        <translation>mente du {0}?</translation>
    </message>
    <message>
        <source>its values are {0}</source>
        <translation>værdierne er {0}</translation>
    </message>
    <message>
        <source>write it in quotes, for example {0}; only WSTRING has every character</source>
        <translation>skriv den i anførselstegn, for eksempel {0}; kun WSTRING har alle tegn</translation>
    </message>
    <message>
        <source>write it in quotes, for example {0}</source>
        <translation>skriv den i anførselstegn, for eksempel {0}</translation>
    </message>
    <message>
        <source>write one character in quotes, for example {0}</source>
        <translation>skriv ét tegn i anførselstegn, for eksempel {0}</translation>
    </message>
    <message>
        <source>write all elements, for example {0}, or a single one by its index</source>
        <translation>skriv alle elementer, for eksempel {0}, eller et enkelt via dets indeks</translation>
    </message>
    <message>
        <source>write its members, for example {0}, or a single one by its path</source>
        <translation>skriv dens medlemmer, for eksempel {0}, eller et enkelt via dets sti</translation>
    </message>
    <message>
        <source>write {0} or {1}</source>
        <translation>skriv {0} eller {1}</translation>
    </message>
    <message>
        <source>write for example {0}</source>
        <translation>skriv for eksempel {0}</translation>
    </message>
    <message>
        <source>write a number, for example {0}</source>
        <translation>skriv et tal, for eksempel {0}</translation>
    </message>
    <message>
        <source>write an integer, for example {0}</source>
        <translation>skriv et heltal, for eksempel {0}</translation>
    </message>
    <message>
        <source>There is no program to optimise; declare a PROGRAM</source>
        <translation>Der er intet program at optimere; erklær et PROGRAM</translation>
    </message>
    <message>
        <source>this is local to a running call and has no address of its own; pause in the call to see it</source>
        <translation>dette er lokalt i et kørende kald og har ingen egen adresse; sæt på pause i kaldet for at se den</translation>
    </message>
    <message>
        <source>this part of a computed value cannot be shown; assign the value to a variable first</source>
        <translation>denne del af en beregnet værdi kan ikke vises; tildel først værdien til en variabel</translation>
    </message>
    <message>
        <source>a character of a string has no address of its own; use the whole string</source>
        <translation>et tegn i en streng har ingen egen adresse; brug hele strengen</translation>
    </message>
    <message>
        <source>this variable cannot be shown; assign it to another variable and watch that one</source>
        <translation>denne variabel kan ikke vises; tildel den til en anden variabel, og overvåg den</translation>
    </message>
    <message>
        <source>this array of variable length has no address here; watch the array that is passed to it</source>
        <translation>dette array med variabel længde har ingen adresse her; overvåg det array, der overføres</translation>
    </message>
    <message>
        <source>the array has no such dimension; count them from 1</source>
        <translation>arrayet har ingen sådan dimension; tæl dem fra 1</translation>
    </message>
    <message>
        <source>this has no value</source>
        <translation>dette har ingen værdi</translation>
    </message>
    <message>
        <source>only standard functions can be called here; use a function of the library</source>
        <translation>her kan kun standardfunktioner kaldes; brug en funktion fra biblioteket</translation>
    </message>
    <message>
        <source>a cast to an interface cannot be watched; watch the instance itself</source>
        <translation>en konvertering til et interface kan ikke overvåges; overvåg selve instansen</translation>
    </message>
    <message>
        <source>this cannot be evaluated; use variables, operators and standard functions</source>
        <translation>dette kan ikke beregnes; brug variabler, operatorer og standardfunktioner</translation>
    </message>
    <message>
        <source>The code generator failed, which is an error of Stepwise: {0}; report it with the program</source>
        <translation>Kodegeneratoren fejlede, en fejl i Stepwise: {0}; rapporter den sammen med programmet</translation>
    </message>
    <message>
        <source>The code generator produced an invalid module, which is an error of Stepwise: {0}; report it with the program</source>
        <translation>Kodegeneratoren dannede et ugyldigt modul, en fejl i Stepwise: {0}; rapporter den sammen med programmet</translation>
    </message>
    <message>
        <source>not compiled</source>
        <translation>ikke oversat</translation>
    </message>
    <message>
        <source>Code for the thread sanitizer needs a process that runs under it</source>
        <translation>Kode til trådsanitizeren kræver en proces, der kører under den</translation>
    </message>
    <message>
        <source>the program could not be optimised: {0}</source>
        <translation>programmet kunne ikke optimeres: {0}</translation>
    </message>
    <message>
        <source>the program has errors; correct them first</source>
        <translation>programmet har fejl; ret dem først</translation>
    </message>
    <message>
        <source>the online change waits until the scan that is halted at a breakpoint has ended; press F5 to continue</source>
        <translation>onlineændringen venter, til scannet ved stoppunktet er slut; tryk på F5 for at fortsætte</translation>
    </message>
    <message>
        <source>This body is not an instruction list; choose a unit that is written in IL</source>
        <translation>Denne krop er ikke en instruktionsliste; vælg en programenhed, der er skrevet i IL</translation>
    </message>
    <message>
        <source>This body is not ST; choose a unit that is written in ST</source>
        <translation>Denne krop er ikke ST; vælg en programenhed, der er skrevet i ST</translation>
    </message>
    <message>
        <source>{0} has no equivalent in an instruction list; write it with simpler statements first</source>
        <translation>{0} har intet modstykke i en instruktionsliste; skriv det først med enklere sætninger</translation>
    </message>
    <message>
        <source>{0} is already written in ST</source>
        <translation>{0} er allerede skrevet i ST</translation>
    </message>
    <message>
        <source>{0} is already written in IL</source>
        <translation>{0} er allerede skrevet i IL</translation>
    </message>
    <message>
        <source>Fix the text first: {0}</source>
        <translation>Ret først teksten: {0}</translation>
    </message>
    <message>
        <source>There is no equivalent in the other language: {0}</source>
        <translation>Der er intet modstykke i det andet sprog: {0}</translation>
    </message>
    <message>
        <source>This is a folder; choose a file</source>
        <translation>Det er en mappe; vælg en fil</translation>
    </message>
    <message>
        <source>This is a device; choose a file</source>
        <translation>Det er en enhed; vælg en fil</translation>
    </message>
    <message>
        <source>The file cannot be read: {0}</source>
        <translation>Filen kan ikke læses: {0}</translation>
    </message>
    <message>
        <source>The file cannot be replaced: {0}</source>
        <translation>Filen kan ikke erstattes: {0}</translation>
    </message>
    <message>
        <source>The file cannot be written: {0}</source>
        <translation>Filen kan ikke skrives: {0}</translation>
    </message>
    <message>
        <source>project.json is not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>project.json er ikke gyldig JSON; led efter et manglende komma, anførselstegn eller en parentes</translation>
    </message>
    <message>
        <source>project.json must contain one JSON object; put its contents in braces</source>
        <translation>project.json skal indeholde ét JSON-objekt; sæt indholdet i krøllede parenteser</translation>
    </message>
    <message>
        <source>There is no library &quot;{0}&quot;; available are {1}</source>
        <translation>Der er intet bibliotek ”{0}”; der findes {1}</translation>
    </message>
    <message>
        <source>There is no library {0}; did you mean {1}?</source>
        <translation>Der er intet bibliotek {0}; mente du {1}?</translation>
    </message>
    <message>
        <source>Specify a project folder or ST files</source>
        <translation>Angiv en projektmappe eller ST-filer</translation>
    </message>
    <message>
        <source>Specify one project folder or ST files, not both</source>
        <translation>Angiv en projektmappe eller ST-filer, ikke begge dele</translation>
    </message>
    <message>
        <source>{0} belongs to a library and cannot be renamed; rename only names of the project</source>
        <translation>{0} hører til et bibliotek og kan ikke omdøbes; omdøb kun projektets egne navne</translation>
    </message>
    <message>
        <source>{0} is not a valid name; use letters, digits and _, start with a letter and avoid keywords</source>
        <translation>{0} er ikke et gyldigt navn; brug bogstaver, cifre og _, begynd med et bogstav og undgå nøgleord</translation>
    </message>
    <message>
        <source>The folder cannot be created: {0}</source>
        <translation>Mappen kan ikke oprettes: {0}</translation>
    </message>
    <message>
        <source>The folder cannot be read: {0}</source>
        <translation>Mappen kan ikke læses: {0}</translation>
    </message>
    <message>
        <source>The file cannot be copied: {0}</source>
        <translation>Filen kan ikke kopieres: {0}</translation>
    </message>
    <message>
        <source>The folder already exists and is not empty; choose another name</source>
        <translation>Mappen findes allerede og er ikke tom; vælg et andet navn</translation>
    </message>
    <message>
        <source>The page cannot be written; check the free space and the permissions of the folder</source>
        <translation>Siden kan ikke skrives; kontroller pladsen og rettighederne til mappen</translation>
    </message>
    <message>
        <source>There is no such file in the project; choose one from the project tree</source>
        <translation>Filen findes ikke i projektet; vælg en i projekttræet</translation>
    </message>
    <message>
        <source>The file&apos;s permissions cannot be changed; change them as the file&apos;s owner</source>
        <translation>Filens rettigheder kan ikke ændres; ret dem som filens ejer</translation>
    </message>
    <message>
        <source>The file cannot be removed; check the permissions of the folder</source>
        <translation>Filen kan ikke slettes; kontroller mappens rettigheder</translation>
    </message>
    <message>
        <source>The file cannot be renamed; check the permissions of the folder</source>
        <translation>Filen kan ikke omdøbes; kontroller mappens rettigheder</translation>
    </message>
    <message>
        <source>Open a project first</source>
        <translation>Åbn først et projekt</translation>
    </message>
    <message>
        <source>This statement is not possible in a TEST together with RUN or ASSERT around it; move it out of RUN and ASSERT</source>
        <translation>Denne sætning er ikke mulig i en TEST med RUN eller ASSERT omkring; flyt den ud af RUN og ASSERT</translation>
    </message>
    <message>
        <source>The code of this statement is missing</source>
        <translation>Koden til denne sætning mangler</translation>
    </message>
    <message>
        <source>Fault in the test: {0}</source>
        <translation>Fejl i testen: {0}</translation>
    </message>
    <message>
        <source>{0} is not a value for {1}; write a value of its type</source>
        <translation>{0} er ikke en værdi for {1}; skriv en værdi af dens type</translation>
    </message>
    <message>
        <source>The simulation stopped: {0}</source>
        <translation>Simuleringen stoppede: {0}</translation>
    </message>
    <message>
        <source>The controller stopped: {0}</source>
        <translation>Styringen stoppede: {0}</translation>
    </message>
    <message>
        <source>at {0}:{1}</source>
        <translation>ved {0}:{1}</translation>
    </message>
    <message>
        <source>{0} has no value: {1}</source>
        <translation>{0} har ingen værdi: {1}</translation>
    </message>
    <message>
        <source>{0} did not become true within {1}; check the condition or allow more time</source>
        <translation>{0} blev ikke sand inden for {1}; kontroller betingelsen, eller giv mere tid</translation>
    </message>
    <message>
        <source>ASSERT failed: {0}</source>
        <translation>ASSERT ikke opfyldt: {0}</translation>
    </message>
    <message>
        <source>ASSERT failed: {0} ({1})</source>
        <translation>ASSERT ikke opfyldt: {0} ({1})</translation>
    </message>
    <message>
        <source>{0} is {1}</source>
        <translation>{0} er {1}</translation>
    </message>
    <message>
        <source>{0} is {1}, expected {2} {3}</source>
        <translation>{0} er {1}, forventet {2} {3}</translation>
    </message>
    <message>
        <source>{0} is {1}, recorded {2} in scan {3}</source>
        <translation>{0} er {1}, optaget {2} i scan {3}</translation>
    </message>
    <message>
        <source>The recording {0} has {1} {1:scan|scans}, this run {2}</source>
        <translation>Optagelsen {0} har {1} scan, denne kørsel {2}</translation>
    </message>
    <message>
        <source>The run differs from the recording {0}; delete it to record it again, if the new behaviour is right</source>
        <translation>Kørslen afviger fra optagelsen {0}; slet den for at optage den igen, hvis den nye opførsel er rigtig</translation>
    </message>
    <message>
        <source>the condition cannot be evaluated; use variables, operators and standard functions</source>
        <translation>betingelsen kan ikke beregnes; brug variabler, operatorer og standardfunktioner</translation>
    </message>
    <message>
        <source>There is no action {0}; add it or correct the name</source>
        <translation>Der er ingen aktion {0}; tilføj den, eller ret navnet</translation>
    </message>
    <message>
        <source>A coil writes a variable; enter the name of one.</source>
        <translation>En spole skriver en variabel; indtast dens navn.</translation>
    </message>
    <message>
        <source>A pin has no contacts; type an expression.</source>
        <translation>Et ben har ingen kontakter; skriv et udtryk.</translation>
    </message>
    <message>
        <source>A rung cannot be moved into itself; choose a place outside it.</source>
        <translation>Et netværk kan ikke flyttes ind i sig selv; vælg et sted uden for det.</translation>
    </message>
    <message>
        <source>A rung moves within its block of statements; use cut and paste in the text for more.</source>
        <translation>Et netværk flyttes inden for sin blok af sætninger; brug klip og sæt ind i teksten til mere.</translation>
    </message>
    <message>
        <source>Delete the call in the text: other statements may use its outputs.</source>
        <translation>Slet kaldet i teksten: andre sætninger bruger måske dets udgange.</translation>
    </message>
    <message>
        <source>Delete this output in the text.</source>
        <translation>Slet denne udgang i teksten.</translation>
    </message>
    <message>
        <source>Other outputs depend on the same IF; give this coil a rung of its own first.</source>
        <translation>Andre udgange afhænger af samme IF; giv først denne spole sit eget netværk.</translation>
    </message>
    <message>
        <source>Select a box with text.</source>
        <translation>Vælg en boks med tekst.</translation>
    </message>
    <message>
        <source>Select a coil.</source>
        <translation>Vælg en spole.</translation>
    </message>
    <message>
        <source>Select a contact or a wire.</source>
        <translation>Vælg en kontakt eller en ledning.</translation>
    </message>
    <message>
        <source>Select a contact, a pin or a coil.</source>
        <translation>Vælg en kontakt, et ben eller en spole.</translation>
    </message>
    <message>
        <source>Select a rung with contacts.</source>
        <translation>Vælg et netværk med kontakter.</translation>
    </message>
    <message>
        <source>Select a rung with one output.</source>
        <translation>Vælg et netværk med én udgang.</translation>
    </message>
    <message>
        <source>Select the rung beside which it is inserted.</source>
        <translation>Vælg det netværk, der skal indsættes ved siden af.</translation>
    </message>
    <message>
        <source>Select the rung that the comment belongs to.</source>
        <translation>Vælg det netværk, kommentaren hører til.</translation>
    </message>
    <message>
        <source>Select what is to be changed.</source>
        <translation>Vælg det, der skal ændres.</translation>
    </message>
    <message>
        <source>Select what is to be deleted.</source>
        <translation>Vælg det, der skal slettes.</translation>
    </message>
    <message>
        <source>Several variables are assigned in one statement; separate them in the text first.</source>
        <translation>Flere variabler tildeles i én sætning; skil dem først ad i teksten.</translation>
    </message>
    <message>
        <source>Statements on one line cannot be moved; separate them in the text first.</source>
        <translation>Sætninger på én linje kan ikke flyttes; skil dem først ad i teksten.</translation>
    </message>
    <message>
        <source>The rung reads what it writes; add this coil in a rung of its own.</source>
        <translation>Netværket læser det, det skriver; tilføj denne spole i sit eget netværk.</translation>
    </message>
    <message>
        <source>There is no function block {0}; declare it or check the name.</source>
        <translation>Der er ingen funktionsblok {0}; erklær den, eller kontroller navnet.</translation>
    </message>
    <message>
        <source>This edit cannot be made in the picture; edit the text.</source>
        <translation>Denne ændring kan ikke laves i tegningen; ret teksten.</translation>
    </message>
    <message>
        <source>This element has no operand; select a contact, a pin or a coil.</source>
        <translation>Dette element har ingen operand; vælg en kontakt, et ben eller en spole.</translation>
    </message>
    <message>
        <source>This is not a statement: {0}</source>
        <translation>Dette er ikke en sætning: {0}</translation>
    </message>
    <message>
        <source>This is not an expression: {0}</source>
        <translation>Dette er ikke et udtryk: {0}</translation>
    </message>
    <message>
        <source>This rung has no condition; put it under IF in the text.</source>
        <translation>Dette netværk har ingen betingelse; sæt det under et IF i teksten.</translation>
    </message>
    <message>
        <source>{0} is not a valid name; use letters, digits and underscores</source>
        <translation>{0} er ikke et gyldigt navn; brug bogstaver, cifre og understreg</translation>
    </message>
    <message>
        <source>The initial step stays at the top; make another step the initial step first</source>
        <translation>Starttrinnet bliver øverst; gør først et andet trin til starttrin</translation>
    </message>
    <message>
        <source>Only a step with a single transition of its own can be moved; move it in the text</source>
        <translation>Kun et trin med sin egen enkelte transition kan flyttes; flyt det i teksten</translation>
    </message>
    <message>
        <source>The step is already there; choose another place</source>
        <translation>Trinnet er der allerede; vælg et andet sted</translation>
    </message>
    <message>
        <source>A step can be placed after a transition that leads to one step; choose such a transition</source>
        <translation>Et trin kan sættes efter en transition, der fører til ét trin; vælg sådan en transition</translation>
    </message>
    <message>
        <source>This step only leads to itself; connect it to another step first</source>
        <translation>Dette trin fører kun til sig selv; forbind det først med et andet trin</translation>
    </message>
    <message>
        <source>A transition needs a condition; enter one, for example Main.done</source>
        <translation>En transition kræver en betingelse; indtast en, for eksempel Main.done</translation>
    </message>
    <message>
        <source>A priority must be a positive number; enter 1 or more</source>
        <translation>En prioritet skal være et positivt tal; indtast 1 eller mere</translation>
    </message>
    <message>
        <source>Nothing follows this step yet; insert a step after it first</source>
        <translation>Intet følger efter dette trin endnu; indsæt først et trin efter det</translation>
    </message>
    <message>
        <source>There is no such action; select one that is in the chart</source>
        <translation>Aktionen findes ikke; vælg en i SFC-diagrammet</translation>
    </message>
    <message>
        <source>The initial step cannot be deleted; make another step the initial step first</source>
        <translation>Starttrinnet kan ikke slettes; gør først et andet trin til starttrin</translation>
    </message>
    <message>
        <source>Several transitions leave this step; delete its branches first</source>
        <translation>Flere transitioner forlader dette trin; slet først dets grene</translation>
    </message>
    <message>
        <source>The condition of this transition cannot be read; edit it in the text</source>
        <translation>Betingelsen for denne transition kan ikke læses; rediger den i teksten</translation>
    </message>
    <message>
        <source>The branches after this transition do not join; connect them in the text first</source>
        <translation>Grenene efter denne transition samles ikke; forbind dem først i teksten</translation>
    </message>
    <message>
        <source>A panel must be a JSON object; put its contents in braces</source>
        <translation>Et panel skal være et JSON-objekt; sæt indholdet i krøllede parenteser</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a list; put it in square brackets</source>
        <translation>”{0}” skal være en liste; sæt den i kantede parenteser</translation>
    </message>
    <message>
        <source>Element {0} is not an object; put it in braces</source>
        <translation>Element {0} er ikke et objekt; sæt det i krøllede parenteser</translation>
    </message>
    <message>
        <source>The kind of element {0} is not a text; write it in quotes</source>
        <translation>Arten af element {0} er ikke en tekst; skriv den i anførselstegn</translation>
    </message>
    <message>
        <source>Two elements have the id &quot;{0}&quot;; change one of them</source>
        <translation>To elementer har id’et ”{0}”; ret det ene</translation>
    </message>
    <message>
        <source>Every alarm and every alarm class must be a JSON object; put it in braces</source>
        <translation>Hver alarm og hver alarmklasse skal være et JSON-objekt; sæt den i krøllede parenteser</translation>
    </message>
    <message>
        <source>This line is not valid UTF-8; save the file as UTF-8</source>
        <translation>Denne linje er ikke gyldig UTF-8; gem filen som UTF-8</translation>
    </message>
    <message>
        <source>There is text after a closing quote; double a quote that belongs to the text</source>
        <translation>Der er tekst efter et afsluttende anførselstegn; fordobl et anførselstegn, der hører til teksten</translation>
    </message>
    <message>
        <source>The first line must be {0} and one language tag per column</source>
        <translation>Den første linje skal være {0} og en sprogkode pr. kolonne</translation>
    </message>
    <message>
        <source>This line has {0} {0:field|fields}, the header has {1}; put texts with separators in quotes</source>
        <translation>Denne linje har {0} {0:felt|felter}, overskriften har {1}; sæt tekster med skilletegn i anførselstegn</translation>
    </message>
    <message>
        <source>The alarm history cannot be opened: {0}</source>
        <translation>Alarmhistorikken kan ikke åbnes: {0}</translation>
    </message>
    <message>
        <source>The alarm history cannot be used: {0}</source>
        <translation>Alarmhistorikken kan ikke bruges: {0}</translation>
    </message>
    <message>
        <source>The alarm history cannot be written: {0}</source>
        <translation>Alarmhistorikken kan ikke skrives: {0}</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}; use a larger type or a smaller limit</source>
        <translation>{0} passer ikke i {1}; brug en større type eller en mindre grænse</translation>
    </message>
    <message>
        <source>STRING contains characters of {0} only; declare the variable as WSTRING</source>
        <translation>STRING rummer kun tegn i {0}; erklær variablen som WSTRING</translation>
    </message>
    <message>
        <source>A {0} cannot be written from a panel; write its members one by one</source>
        <translation>En {0} kan ikke skrives fra et panel; skriv dens medlemmer ét for ét</translation>
    </message>
    <message>
        <source>The folder for the pictures cannot be created; check the path and its permissions</source>
        <translation>Mappen til billederne kan ikke oprettes; kontroller stien og dens rettigheder</translation>
    </message>
    <message>
        <source>The picture cannot be written; check the free space and the permissions of the folder</source>
        <translation>Billedet kan ikke skrives; kontroller pladsen og rettighederne til mappen</translation>
    </message>
    <message>
        <source>The project has no such panel; choose one from hmi/</source>
        <translation>Projektet har ikke det panel; vælg et fra hmi/</translation>
    </message>
    <message>
        <source>The text &quot;{0}&quot; has no key, so it cannot be translated; move it into the text table</source>
        <translation>Teksten ”{0}” har ingen nøgle og kan derfor ikke oversættes; flyt den til teksttabellen</translation>
    </message>
    <message>
        <source>The text needs a value for {0}; specify it in &quot;Values in texts&quot;</source>
        <translation>Teksten kræver en værdi for {0}; angiv den under ”Værdier i tekster”</translation>
    </message>
    <message>
        <source>The text list {0} is empty: there is no key {1}; add it to the text table</source>
        <translation>Tekstlisten {0} er tom: der er ingen nøgle {1}; tilføj den i teksttabellen</translation>
    </message>
    <message>
        <source>This version does not know the element kind &quot;{0}&quot;; it is kept as it is</source>
        <translation>Denne version kender ikke elementarten ”{0}”; den bevares uændret</translation>
    </message>
    <message>
        <source>The format {0} is not known; use for example {1} or {2}</source>
        <translation>Formatet {0} er ukendt; brug for eksempel {1} eller {2}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; does not fit: it needs {1} px, the maximum is {2}; make the element wider or the text shorter</source>
        <translation>”{0}” passer ikke: kræver {1}&#xa0;px, men der er kun plads til {2}; gør elementet bredere eller teksten kortere</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; does not fit: it needs a height of {1} px, the maximum is {2}; make the element taller or the text shorter</source>
        <translation>”{0}” passer ikke: kræver en højde på {1}&#xa0;px, men der er kun plads til {2}; gør elementet højere eller teksten kortere</translation>
    </message>
    <message>
        <source>{0}; did you mean {1}?</source>
        <translation>{0}; mente du {1}?</translation>
    </message>
    <message>
        <source>{0} is not a variable, so it cannot be written; name a variable</source>
        <translation>{0} er ikke en variabel og kan derfor ikke skrives; angiv en variabel</translation>
    </message>
    <message>
        <source>{0} is {1}; a BOOL is needed here</source>
        <translation>{0} er {1}; her kræves en BOOL</translation>
    </message>
    <message>
        <source>{0} is {1}; a number is needed here</source>
        <translation>{0} er {1}; her kræves et tal</translation>
    </message>
    <message>
        <source>{0} is {1}; a STRING is needed here</source>
        <translation>{0} er {1}; her kræves en STRING</translation>
    </message>
    <message>
        <source>{0} is {1}; an array is needed here</source>
        <translation>{0} er {1}; her kræves et array</translation>
    </message>
    <message>
        <source>{0} is {1}; a single value is needed here</source>
        <translation>{0} er {1}; her kræves en enkelt værdi</translation>
    </message>
    <message>
        <source>A placeholder is not closed; add {0}</source>
        <translation>En pladsholder er ikke lukket; tilføj {0}</translation>
    </message>
    <message>
        <source>The format {0} is not known; use one such as %.1f</source>
        <translation>Formatet {0} er ukendt; brug for eksempel %.1f</translation>
    </message>
    <message>
        <source>A trace configuration must be a JSON object; put its contents in braces</source>
        <translation>En traceopsætning skal være et JSON-objekt; sæt indholdet i krøllede parenteser</translation>
    </message>
    <message>
        <source>The trace configuration is invalid: {0}</source>
        <translation>Traceopsætningen er ugyldig: {0}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be {1}</source>
        <translation>”{0}” skal være {1}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is missing; add it</source>
        <translation>”{0}” mangler; tilføj det</translation>
    </message>
    <message>
        <source>A picture&apos;s name must end in one of {0}</source>
        <translation>Et billedes navn skal ende på en af {0}</translation>
    </message>
    <message>
        <source>no longer recorded</source>
        <translation>ikke længere optaget</translation>
    </message>
    <message>
        <source>A recording from a file cannot be written; go back to the running controller first</source>
        <translation>En optagelse fra en fil kan ikke skrives; gå først tilbage til den kørende styring</translation>
    </message>
    <message>
        <source>Recorded values cannot be written; resume from here first</source>
        <translation>Optagede værdier kan ikke skrives; fortsæt først herfra</translation>
    </message>
    <message>
        <source>Recorded values cannot be forced; resume from here or go back to live first</source>
        <translation>Optagede værdier kan ikke forceres; fortsæt først herfra, eller gå tilbage til livevisning</translation>
    </message>
    <message>
        <source>A recording from a file cannot be resumed, only what the controller itself recorded; press F5 to run the program</source>
        <translation>En optagelse fra en fil kan ikke fortsættes, kun det styringen selv har optaget; tryk på F5 for at køre programmet</translation>
    </message>
    <message>
        <source>A priority is a number; 0 removes it</source>
        <translation>En prioritet er et tal; 0 fjerner den</translation>
    </message>
    <message>
        <source>This file cannot be imported; PLCopen XML (.xml), TwinCAT (.TcPOU and so on), text of CODESYS (.EXP, .export) and structured text (.st) can be read</source>
        <translation>Filen kan ikke importeres: PLCopen XML (.xml), TwinCAT (.TcPOU og så videre), tekst fra CODESYS (.EXP, .export) og struktureret tekst (.st) kan læses</translation>
    </message>
    <message>
        <source>This XML is neither PLCopen XML nor of TwinCAT or CODESYS; export the project as PLCopen XML and import that file</source>
        <translation>Denne XML er hverken PLCopen XML eller fra TwinCAT eller CODESYS; eksporter projektet som PLCopen XML, og importer den fil</translation>
    </message>
    <message>
        <source>It contains nothing that can be imported; export the project again with its units</source>
        <translation>Der er intet i den, som kan importeres; eksporter projektet igen med dets programenheder</translation>
    </message>
    <message>
        <source>The folder exists and is not empty; name a new one</source>
        <translation>Mappen findes og er ikke tom; angiv en ny</translation>
    </message>
    <message>
        <source>The sources have syntax errors; stepwise check lists them</source>
        <translation>Kilderne har syntaksfejl; stepwise check viser dem</translation>
    </message>
    <message>
        <source>The file is too large to be read; export its parts one by one</source>
        <translation>Filen er for stor til at blive læst; eksporter delene hver for sig</translation>
    </message>
    <message>
        <source>The file is in the encoding {0}, which is not supported; save it as UTF-8</source>
        <translation>Filen har tegnkodningen {0}, som ikke understøttes; gem den som UTF-8</translation>
    </message>
    <message>
        <source>The file declares a document type or entities of its own, which is not supported; export it again without them</source>
        <translation>Filen erklærer en dokumenttype eller egne entiteter, hvilket ikke understøttes; eksporter den igen uden dem</translation>
    </message>
    <message>
        <source>The elements of the file are nested too deeply; export its parts one by one</source>
        <translation>Filens elementer er for dybt indlejret; eksporter delene hver for sig</translation>
    </message>
    <message>
        <source>This is not well-formed XML: {0}; export the file again</source>
        <translation>Dette er ikke velformet XML: {0}; eksporter filen igen</translation>
    </message>
    <message>
        <source>The file has no elements; export it again</source>
        <translation>Filen har ingen elementer; eksporter den igen</translation>
    </message>
    <message>
        <source>This is XML, not structured text; import it (stepwise import --help)</source>
        <translation>Dette er XML, ikke struktureret tekst; importer det (stepwise import --help)</translation>
    </message>
    <message>
        <source>Windows-1252 does not have the character {0}; write the file as UTF-8</source>
        <translation>Windows-1252 har ikke tegnet {0}; skriv filen som UTF-8</translation>
    </message>
    <message>
        <source>The first input and the first output of {0} must be BOOL for it to be part of a rung; choose another block, or call it in the text.</source>
        <translation>Den første indgang og den første udgang af {0} skal være BOOL, for at den kan være i et netværk; vælg en anden blok, eller kald den i teksten.</translation>
    </message>
    <message>
        <source>Type a name and a block: T1 : TON</source>
        <translation>Skriv et navn og en blok: T1 : TON</translation>
    </message>
    <message>
        <source>the local variables of {0} and of what it calls need {1} bytes; the maximum is {2}; declare large arrays in a program or block</source>
        <translation>de lokale variabler i {0} og alt, hvad den kalder, kræver {1} bytes; der er højst plads til {2}; erklær store arrays i et program eller en blok</translation>
    </message>
    <message>
        <source>{0} is too large for the stack; divide it into several functions</source>
        <translation>{0} er for stor til stakken; del den op i flere funktioner</translation>
    </message>
    <message>
        <source>more than {0} units of work (loop passes, calls, copies) in one run of the task; check for an endless loop</source>
        <translation>mere end {0} arbejdsenheder (løkkegennemløb, kald, kopier) i én kørsel af tasken; kontroller for en endeløs løkke</translation>
    </message>
    <message>
        <source>{0} is not a name: use letters, digits and underscores.</source>
        <translation>{0} er ikke et gyldigt navn; brug bogstaver, cifre og understreg.</translation>
    </message>
    <message>
        <source>The XLIFF version {0} is not known; save the file as 1.2 or 2.0</source>
        <translation>XLIFF-versionen {0} er ikke kendt; gem filen som 1.2 eller 2.0</translation>
    </message>
    <message>
        <source>The file does not say into which language it is translated; export it again with --language</source>
        <translation>Filen angiver ikke, hvilket sprog den er oversat til; eksporter den igen med --language</translation>
    </message>
    <message>
        <source>The XML is wrong: {0}; export the file again</source>
        <translation>XML’en er forkert: {0}; eksporter filen igen</translation>
    </message>
    <message>
        <source>The text of the key {0} in {1} has changed since the export; check the translation</source>
        <translation>Teksten til nøglen {0} på {1} er ændret siden eksporten; kontroller oversættelsen</translation>
    </message>
    <message>
        <source>The translation of the key {0} has other placeholders than its source and was not taken; use the same ones</source>
        <translation>Oversættelsen af nøglen {0} har andre pladsholdere end kilden og blev ikke overtaget; brug de samme</translation>
    </message>
    <message>
        <source>The picture {0} is outside the project; copy it into the project, or set {1} to true under {2} in project.json</source>
        <translation>Billedet {0} er uden for projektet; kopier det ind i projektet, eller sæt {1} til true under {2} i project.json</translation>
    </message>
    <message>
        <source>The picture {0} unpacks to more than {1} MB; use a smaller one</source>
        <translation>Billedet {0} fylder mere end {1}&#xa0;MB udpakket; brug et mindre</translation>
    </message>
    <message>
        <source>The picture {0} is {1} x {2} pixels; more than {3} million are not drawn; use a smaller one</source>
        <translation>Billedet {0} er på {1} x {2} pixels; flere end {3} millioner tegnes ikke; brug et mindre</translation>
    </message>
    <message>
        <source>{0} is not a picture in a known format such as PNG, JPEG or SVG; save it as one of them</source>
        <translation>{0} er ikke et billede i et kendt format som PNG, JPEG eller SVG; gem det i et af dem</translation>
    </message>
    <message>
        <source>The picture {0} draws more than {1} shapes; simplify it or save it as PNG</source>
        <translation>Billedet {0} indeholder flere end {1} former; forenkl det, eller gem det som PNG</translation>
    </message>
    <message>
        <source>The shapes of the picture {0} are nested more than {1} deep or contain themselves; simplify it or save it as PNG</source>
        <translation>Formerne i billedet {0} er indlejret mere end {1} niveauer eller indeholder sig selv; forenkl det, eller gem det som PNG</translation>
    </message>
    <message>
        <source>The picture {0} loads {1}; embed it in the picture as PNG or JPEG</source>
        <translation>Billedet {0} indlæser {1}; indlejr det i billedet som PNG eller JPEG</translation>
    </message>
    <message>
        <source>The picture {0} has dashed lines of more than {1} dashes; make the dashes longer or save it as PNG</source>
        <translation>Billedet {0} har stiplede linjer med mere end {1} streger; gør stregerne længere, eller gem det som PNG</translation>
    </message>
    <message>
        <source>This version does not know the property {0}; it is kept as it is</source>
        <translation>Denne version kender ikke egenskaben {0}; den beholdes, som den er</translation>
    </message>
    <message>
        <source>This version does not know the property {0}; did you mean {1}?</source>
        <translation>Denne version kender ikke egenskaben {0}; mente du {1}?</translation>
    </message>
    <message>
        <source>The value must be true or false</source>
        <translation>Værdien skal være true eller false</translation>
    </message>
    <message>
        <source>The value must be a whole number</source>
        <translation>Værdien skal være et helt tal</translation>
    </message>
    <message>
        <source>The value must be a number</source>
        <translation>Værdien skal være et tal</translation>
    </message>
    <message>
        <source>The value must be a list of two numbers: width and height</source>
        <translation>Værdien skal være en liste med to tal: bredde og højde</translation>
    </message>
    <message>
        <source>The value must be a list of four numbers: x, y, width and height</source>
        <translation>Værdien skal være en liste med fire tal: x, y, bredde og højde</translation>
    </message>
    <message>
        <source>The value must be a list of points, each a list of two numbers</source>
        <translation>Værdien skal være en liste med punkter, hvert en liste med to tal</translation>
    </message>
    <message>
        <source>The value must be an object with an expression for each name</source>
        <translation>Værdien skal være et objekt med et udtryk for hvert navn</translation>
    </message>
    <message>
        <source>The value must be a list of objects</source>
        <translation>Værdien skal være en liste med objekter</translation>
    </message>
    <message>
        <source>The value must be a text in quotes</source>
        <translation>Værdien skal være en tekst i anførselstegn</translation>
    </message>
    <message>
        <source>{0} is not one of the choices: {1}</source>
        <translation>{0} er ikke en af mulighederne: {1}</translation>
    </message>
    <message>
        <source>{0} is not a colour; use the name of a role of the theme or a value such as {1}</source>
        <translation>{0} er ikke en farve; brug navnet på en rolle i temaet eller en værdi som {1}</translation>
    </message>
    <message>
        <source>{0} is not a colour; did you mean {1}?</source>
        <translation>{0} er ikke en farve; mente du {1}?</translation>
    </message>
    <message>
        <source>{0} ({1}) must be greater than {2} ({3}); exchange or correct the values</source>
        <translation>{0} ({1}) skal være større end {2} ({3}); byt om på værdierne, eller ret dem</translation>
    </message>
    <message>
        <source>{0} has no page {1}; its {2} {2:page is|pages are} numbered from 0</source>
        <translation>{0} har ingen side {1}; dens {2} {2:side er|sider er} nummereret fra 0</translation>
    </message>
    <message>
        <source>The format {0} needs a number, and {1} is none; use {2}</source>
        <translation>Formatet {0} kræver et tal, og {1} er ikke et; brug {2}</translation>
    </message>
    <message>
        <source>The project has no language {0}, so operators never see this column; add it to the languages in project.json</source>
        <translation>Projektet har ikke sproget {0}, så operatører ser aldrig denne kolonne; føj det til sprogene i project.json</translation>
    </message>
    <message>
        <source>No text says what this does; add one, or place one next to it</source>
        <translation>Ingen tekst fortæller, hvad dette gør; tilføj en, eller sæt en ved siden af</translation>
    </message>
    <message>
        <source>{0} is between {1} and {2} in the recording, so the range from {3} to {4} cuts it off; widen the range</source>
        <translation>{0} ligger mellem {1} og {2} i optagelsen, så området fra {3} til {4} skærer noget af; gør området større</translation>
    </message>
    <message>
        <source>{0} is not between {1} and {2}, so {3} is used; correct it</source>
        <translation>{0} er ikke mellem {1} og {2}, så {3} bruges; ret værdien</translation>
    </message>
    <message>
        <source>The panel {0} contains this one, so it cannot be placed in it; choose another one</source>
        <translation>Panelet {0} indeholder dette og kan derfor ikke placeres i det; vælg et andet</translation>
    </message>
    <message>
        <source>The panel {0} has no parameter {1}; remove the argument or add the parameter</source>
        <translation>Panelet {0} har ingen parameter {1}; fjern argumentet, eller tilføj parameteren</translation>
    </message>
    <message>
        <source>The program has no type {0}; name a block or a structure, BOOL, REAL or the like, or text</source>
        <translation>Programmet har ingen type {0}; angiv en blok eller en struktur, BOOL, REAL eller lignende, eller text</translation>
    </message>
    <message>
        <source>The parameter {0} needs an argument of type {1}; enter one in the properties of this faceplate</source>
        <translation>Parameteren {0} kræver et argument af typen {1}; skriv et i faceplatens egenskaber</translation>
    </message>
    <message>
        <source>{0} is {1}; the parameter {2} needs {3}</source>
        <translation>{0} er {1}; parameteren {2} kræver {3}</translation>
    </message>
    <message>
        <source>{0} (tried with {1})</source>
        <translation>{0} (prøvet med {1})</translation>
    </message>
    <message>
        <source>The program was not built from sources; open its project.</source>
        <translation>Programmet blev ikke oversat fra kildetekster; åbn dets projekt.</translation>
    </message>
    <message>
        <source>The recording does not contain the program of this scan; choose a later scan.</source>
        <translation>Optagelsen indeholder ikke programmet for dette scan; vælg et senere scan.</translation>
    </message>
    <message>
        <source>This scan is no longer in the recording; choose a later scan.</source>
        <translation>Dette scan er ikke længere i optagelsen; vælg et senere scan.</translation>
    </message>
    <message>
        <source>The scan before it is not in the recording, so the values with which this scan began are not known; choose a later scan.</source>
        <translation>Scannet før er ikke i optagelsen, så de værdier, som dette scan begyndte med, er ikke kendt; vælg et senere scan.</translation>
    </message>
    <message>
        <source>There is no user {0}; create the user or check the name</source>
        <translation>Brugeren {0} findes ikke; opret brugeren, eller kontroller navnet</translation>
    </message>
    <message>
        <source>The password cannot be saved: {0}</source>
        <translation>Adgangskoden kan ikke gemmes: {0}</translation>
    </message>
    <message>
        <source>A password needs at least {0} characters; choose a longer one</source>
        <translation>En adgangskode skal have mindst {0} tegn; vælg en længere</translation>
    </message>
    <message>
        <source>The password must not be the name of the user; choose another one</source>
        <translation>Adgangskoden må ikke være brugerens navn; vælg en anden</translation>
    </message>
    <message>
        <source>The audit trail cannot be written: {0}</source>
        <translation>Revisionssporet kan ikke skrives: {0}</translation>
    </message>
    <message>
        <source>The audit trail cannot be read: {0}</source>
        <translation>Revisionssporet kan ikke læses: {0}</translation>
    </message>
    <message>
        <source>The frame {0} has no panel area, so no panel is shown in it; add one</source>
        <translation>Rammen {0} har intet panelområde, så intet panel vises i den; tilføj et</translation>
    </message>
    <message>
        <source>Only for the roles {0}, but the project has no users, so anybody may operate it; add users</source>
        <translation>Kun for rollerne {0}, men projektet har ingen brugere, så enhver må betjene det; tilføj brugere</translation>
    </message>
    <message>
        <source>A row of a recipe names no variable; enter one or remove the row</source>
        <translation>En række i en recept angiver ingen variabel; angiv en, eller fjern rækken</translation>
    </message>
    <message>
        <source>The first column must be named variable, and each set has a column of its own</source>
        <translation>Den første kolonne skal hedde variable, og hvert sæt har sin egen kolonne</translation>
    </message>
    <message>
        <source>The recipe {0} has no variable {1}; add it or correct the name</source>
        <translation>Recepten {0} har ingen variabel {1}; tilføj den, eller ret navnet</translation>
    </message>
    <message>
        <source>There is no recipe {0}; create it or check the name</source>
        <translation>Recepten {0} findes ikke; opret den, eller kontroller navnet</translation>
    </message>
    <message>
        <source>The recipe {0} has no set {1}; create it or check the name</source>
        <translation>Recepten {0} har intet sæt {1}; opret det, eller kontroller navnet</translation>
    </message>
    <message>
        <source>{0} is outside the limits of {1}, {2} to {3}; enter a value within them</source>
        <translation>{0} er uden for grænserne for {1}, {2} til {3}; indtast en værdi inden for dem</translation>
    </message>
    <message>
        <source>The list of shelved alarms cannot be read, so none is shelved: {0}</source>
        <translation>Listen over udsatte alarmer kan ikke læses, så ingen er udsat: {0}</translation>
    </message>
    <message>
        <source>The list of shelved alarms cannot be written: {0}</source>
        <translation>Listen over udsatte alarmer kan ikke skrives: {0}</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Hvorfor?</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>Hvorfor ikke?</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>Hvem satte det?</translation>
    </message>
    <message>
        <source>There is no rule {0}; &quot;stepwise panel --rules&quot; lists them</source>
        <translation>Der er ingen regel {0}; ”stepwise panel --rules” viser dem</translation>
    </message>
    <message>
        <source>There is no rule {0}; did you mean {1}?</source>
        <translation>Der er ingen regel {0}; mente du {1}?</translation>
    </message>
    <message>
        <source>The rule stays on until a reason for switching it off is given</source>
        <translation>Reglen forbliver slået til, indtil der er angivet en grund til at slå den fra</translation>
    </message>
    <message>
        <source>The value must be a list of texts in quotes</source>
        <translation>Værdien skal være en liste af tekster i anførselstegn</translation>
    </message>
    <message>
        <source>The value must be an object with the reason for each rule</source>
        <translation>Værdien skal være et objekt med begrundelsen for hver regel</translation>
    </message>
    <message>
        <source>The value must be an object with a level, the distance, and rules that are off</source>
        <translation>Værdien skal være et objekt med et niveau, afstanden og regler, der er slået fra</translation>
    </message>
    <message>
        <source>The colour {0} is always visible, whatever the state; use {1}</source>
        <translation>Farven {0} ses altid, uanset tilstanden; brug {1}</translation>
    </message>
    <message>
        <source>{0} is an alarm colour, but it is visible in normal operation; use {1}</source>
        <translation>{0} er en alarmfarve, men den ses i normal drift; brug {1}</translation>
    </message>
    <message>
        <source>Only the hue distinguishes {0} from {1}; choose a brighter one, or add a text or blinking</source>
        <translation>Kun farvetonen adskiller {0} fra {1}; vælg en, der er lysere, eller tilføj en tekst eller blink</translation>
    </message>
    <message>
        <source>No text says what the lamp means; give it a label, or place a text next to it</source>
        <translation>Ingen tekst fortæller, hvad lampen betyder; giv den en etiket, eller anbring en tekst ved siden af</translation>
    </message>
    <message>
        <source>{0} on {1} has a contrast of {2} to 1 in the theme {3}; {4} to 1 is needed; choose another colour</source>
        <translation>{0} på {1} har en kontrast på {2} til 1 i temaet {3}; der kræves {4} til 1; vælg en anden farve</translation>
    </message>
    <message>
        <source>A font of {0} px cannot be read from {2} mm; use at least {1} px</source>
        <translation>En skrift på {0}&#xa0;px kan ikke læses på {2}&#xa0;mm; brug mindst {1}&#xa0;px</translation>
    </message>
    <message>
        <source>The faceplate is so small here that its smallest font has {0} px; from {2} mm, {1} px are needed; enlarge it</source>
        <translation>Faceplaten er så lille her, at dens mindste skrift er {0}&#xa0;px; på {2}&#xa0;mm kræves {1}&#xa0;px; gør den større</translation>
    </message>
    <message>
        <source>The faceplate is so small here that only {0} px remain for a finger; {1} px are needed; enlarge it</source>
        <translation>Faceplaten er så lille her, at en finger kun har {0}&#xa0;px at trykke på; der kræves {1}&#xa0;px; gør den større</translation>
    </message>
    <message>
        <source>{0} x {1} px is too small for a finger next to other controls; {2} px are needed in both directions; make it larger</source>
        <translation>{0} × {1}&#xa0;px er for lidt til en finger ved siden af andre betjeningselementer; der kræves {2}&#xa0;px i begge retninger; gør elementet større</translation>
    </message>
    <message>
        <source>The panel shows {0} values and controls; the maximum for its size is {1}; move some to another panel</source>
        <translation>Panelet viser {0} værdier og betjeningselementer; det højeste antal for størrelsen er {1}; flyt nogle til et andet panel</translation>
    </message>
    <message>
        <source>The panel {0} is {1} presses away from the start panel; add a way of at most {2}</source>
        <translation>Panelet {0} er {1} tryk fra startpanelet; tilføj en vej med højst {2}</translation>
    </message>
    <message>
        <source>Nothing on the panel {0} leads back; add a button with the action back or home, or a navigation bar</source>
        <translation>Intet på panelet {0} fører tilbage; tilføj en knap med aktionen back eller home, eller en navigationslinje</translation>
    </message>
    <message>
        <source>{0} is in a different place on the panel {1}; put it in the same place on both</source>
        <translation>{0} er et andet sted på panelet {1}; sæt det samme sted på begge</translation>
    </message>
    <message>
        <source>Normal states are grey so that abnormal ones are noticed (ISA-101). Use a role of the theme such as surface, off or running, and give colour only to conditions.</source>
        <translation>Normale tilstande er grå, så afvigelser ses (ISA-101). Brug en rolle i temaet som surface, off eller running, og giv kun farve gennem betingelser.</translation>
    </message>
    <message>
        <source>Red, orange and yellow are reserved for alarms. An operator who sees them all day long no longer notices them when they matter (ISA-101, ISA-18.2).</source>
        <translation>Rød, orange og gul er forbeholdt alarmer. En operatør, der ser dem hele dagen, ser dem ikke længere, når de betyder noget (ISA-101, ISA-18.2).</translation>
    </message>
    <message>
        <source>Text needs a contrast of 4.5 to 1 against its background, large text 3 to 1 (WCAG 2, ISO 9241-303). The colour roles ensure this in every theme.</source>
        <translation>Tekst kræver en kontrast på 4,5 til 1 mod sin baggrund, stor tekst 3 til 1 (WCAG 2, ISO 9241-303). Farverollerne sikrer det i alle temaer.</translation>
    </message>
    <message>
        <source>A capital letter must be seen at an angle of 16 minutes at least (ISO 9241-303). The distance and the size of a pixel are set in project.json.</source>
        <translation>Et stort bogstav skal ses under en vinkel på mindst 16 bueminutter (ISO 9241-303). Afstanden og størrelsen af en pixel angives i project.json.</translation>
    </message>
    <message>
        <source>On a panel that shows everything, operators have to search. Move details to a panel of the next level (ISA-101).</source>
        <translation>På et panel, der viser alt, må operatøren lede. Flyt detaljer til et panel på næste niveau (ISA-101).</translation>
    </message>
    <message>
        <source>In an abnormal situation, every panel should be at most three presses away, and there should be a way back from it (ISA-101).</source>
        <translation>I en unormal situation bør hvert panel højst være tre tryk væk, og der bør være en vej tilbage (ISA-101).</translation>
    </message>
    <message>
        <source>Operators find what is on several panels without searching if it is always in the same place. Put it on the frame, or in the same place everywhere.</source>
        <translation>Det, der er på flere paneler, finder operatøren uden at lede, hvis det altid er samme sted. Anbring det på rammen eller samme sted overalt.</translation>
    </message>
    <message>
        <source>One element covers the other, so that a text cannot be read or the wrong element is pressed.</source>
        <translation>Et element dækker et andet, så en tekst ikke kan læses, eller der trykkes på det forkerte element.</translation>
    </message>
    <message>
        <source>The element looks as if it had a function. Bind it to a variable, or remove it.</source>
        <translation>Elementet ser ud, som om det har en funktion. Bind det til en variabel, eller fjern det.</translation>
    </message>
    <message>
        <source>A typing error sends 500 instead of 50. Limits reject it on entry.</source>
        <translation>En tastefejl sender 500 i stedet for 50. Grænser afviser den ved indtastningen.</translation>
    </message>
    <message>
        <source>An alarm that nobody sees is useless. Put an alarm banner on the frame or an alarm list on a panel (ISA-18.2).</source>
        <translation>En alarm, som ingen ser, er nytteløs. Anbring et alarmbanner på rammen eller en alarmliste på et panel (ISA-18.2).</translation>
    </message>
    <message>
        <source>An alarm requires the operator to act. Its help must say what to do, and what happens otherwise (ISA-18.2).</source>
        <translation>En alarm kræver en handling af operatøren. Dens hjælp skal angive hvilken, og hvad der ellers sker (ISA-18.2).</translation>
    </message>
    <message>
        <source>If everything is urgent, nothing is: about 5 % of the alarms should have the highest priority, 15 % the next (ISA-18.2).</source>
        <translation>Hvis alt haster, haster intet: ca. 5&#xa0;% af alarmerne bør have den højeste prioritet, 15&#xa0;% den næste (ISA-18.2).</translation>
    </message>
    <message>
        <source>the value {0} is outside the subrange {1}..{2}; limit it before the assignment or widen the subrange</source>
        <translation>værdien {0} er uden for delområdet {1}..{2}; begræns den før tildelingen, eller gør delområdet større</translation>
    </message>
    <message>
        <source>&quot;addressing&quot; in project.json is &quot;byte&quot; or &quot;word&quot;, not &quot;{0}&quot;</source>
        <translation>”addressing” i project.json er ”byte” eller ”word”, ikke ”{0}”</translation>
    </message>
    <message>
        <source>&quot;memoryForNew&quot; in project.json is a number of bytes from 0 to {0}</source>
        <translation>”memoryForNew” i project.json er et antal bytes fra 0 til {0}</translation>
    </message>
    <message>
        <source>A finger needs 7 mm in both directions, a gloved one 9 mm, as the strict level requires. The size of a pixel is set in project.json.</source>
        <translation>En finger kræver 7&#xa0;mm i begge retninger, i handske 9&#xa0;mm, som det strenge niveau kræver. Størrelsen af en pixel angives i project.json.</translation>
    </message>
    <message>
        <source>Nothing is bound; fill in “{0}”</source>
        <translation>Intet er bundet; udfyld ”{0}”</translation>
    </message>
    <message>
        <source>Any number can be written to {0}; set “{1}”</source>
        <translation>Ethvert tal kan skrives til {0}; angiv ”{1}”</translation>
    </message>
    <message>
        <source>One man in twelve cannot tell some colours apart, and bright light washes them out. Show the same information with a text, a shape, blinking or at least a different brightness.</source>
        <translation>Hver tolvte mand kan ikke skelne visse farver, og skarpt lys får dem til at blegne. Vis det samme med en tekst, en form, blink eller i det mindste en anden lysstyrke.</translation>
    </message>
    <message>
        <source>A write that is restricted to some roles, or that project.json lists as critical, must not be triggered by an accidental touch. Set &quot;Writes are confirmed&quot;, or enter a question.</source>
        <translation>En skrivning, der er forbeholdt bestemte roller, eller som project.json angiver som kritisk, må ikke udløses ved en utilsigtet berøring. Slå ”Skrivning bekræftes” til, eller indtast et spørgsmål.</translation>
    </message>
    <message>
        <source>Only {1} may write {0}, but no confirmation is required; set &quot;Writes are confirmed&quot;</source>
        <translation>Kun {1} må skrive {0}, men der kræves ingen bekræftelse; slå ”Skrivning bekræftes” til</translation>
    </message>
    <message>
        <source>The theme is not valid JSON with a base and colors</source>
        <translation>Temaet er ikke gyldig JSON med base og colors</translation>
    </message>
    <message>
        <source>There is no built-in theme &quot;{0}&quot;; a base is light, dark or contrast</source>
        <translation>Der er intet indbygget tema ”{0}”; basen skal være light, dark eller contrast</translation>
    </message>
    <message>
        <source>There is no colour role {0}; check the spelling</source>
        <translation>Der er ingen farverolle {0}; kontroller stavningen</translation>
    </message>
    <message>
        <source>There is no colour role {0}; did you mean {1}?</source>
        <translation>Der er ingen farverolle {0}; mente du {1}?</translation>
    </message>
    <message>
        <source>The colour of {0} must be written like {1}</source>
        <translation>Farven på {0} skal skrives som {1}</translation>
    </message>
    <message>
        <source>There is no theme {0}; choose one of {1}</source>
        <translation>Der er intet tema {0}; vælg et af {1}</translation>
    </message>
    <message>
        <source>This edit would change the same text twice; undo it and edit the text</source>
        <translation>Denne ændring ville ændre den samme tekst to gange; fortryd den, og rediger teksten</translation>
    </message>
    <message>
        <source>This transition does not lead to a step yet; connect it to one first</source>
        <translation>Denne transition fører endnu ikke til et trin; forbind den først med et</translation>
    </message>
    <message>
        <source>The panel was written by a newer version of Stepwise; open it with that version</source>
        <translation>Panelet er skrevet af en nyere version af Stepwise; åbn det med den version</translation>
    </message>
    <message>
        <source>This trace configuration was written by a newer version of Stepwise (version {0}); open it with that version</source>
        <translation>Denne traceopsætning er skrevet af en nyere version af Stepwise (version {0}); åbn den med den version</translation>
    </message>
    <message>
        <source>The recorded program can no longer be built; open the recording with the version of Stepwise that made it</source>
        <translation>Det optagede program kan ikke længere oversættes; åbn optagelsen med den version af Stepwise, der lavede den</translation>
    </message>
    <message>
        <source>The controller is not running; press F5</source>
        <translation>Styringen kører ikke; tryk på F5</translation>
    </message>
    <message>
        <source>There is no program to run; declare a PROGRAM</source>
        <translation>Der er intet program at køre; erklær et PROGRAM</translation>
    </message>
    <message>
        <source>There is no program to test; declare a PROGRAM</source>
        <translation>Der er intet program at teste; erklær et PROGRAM</translation>
    </message>
    <message>
        <source>A file with this name already exists; choose another name</source>
        <translation>Der er allerede en fil med det navn; vælg et andet navn</translation>
    </message>
    <message>
        <source>A panel with this name already exists; choose another name</source>
        <translation>Der er allerede et panel med det navn; vælg et andet navn</translation>
    </message>
    <message>
        <source>A step {0} already exists; choose another name</source>
        <translation>Der er allerede et trin {0}; vælg et andet navn</translation>
    </message>
    <message>
        <source>The step of this loop is 0; write BY with another number</source>
        <translation>Skridtet i denne løkke er 0; skriv BY med et andet tal</translation>
    </message>
    <message>
        <source>This loop of the test does not end; give it a condition that becomes FALSE</source>
        <translation>Denne løkke i testen slutter ikke; giv den en betingelse, der bliver FALSE</translation>
    </message>
    <message>
        <source>There is no name here that can be renamed; put the cursor on one</source>
        <translation>Her er intet navn, der kan omdøbes; sæt markøren på et</translation>
    </message>
    <message>
        <source>The file was changed by another program and was not overwritten; compare both first</source>
        <translation>Filen blev ændret af et andet program og blev ikke overskrevet; sammenlign først begge</translation>
    </message>
    <message>
        <source>The type of {0} is not known here; correct the errors of the program first</source>
        <translation>Typen af {0} er ikke kendt her; ret først programmets fejl</translation>
    </message>
    <message>
        <source>Nothing has been recorded yet; start the controller with F5</source>
        <translation>Der er endnu ikke optaget noget; start styringen med F5</translation>
    </message>
    <message>
        <source>a constant cannot be forced; change it in the program</source>
        <translation>en konstant kan ikke forceres; ret den i programmet</translation>
    </message>
    <message>
        <source>the path is incomplete; write it to a single value, for example Main.x</source>
        <translation>stien er ufuldstændig; skriv den frem til en enkelt værdi, for eksempel Main.x</translation>
    </message>
    <message>
        <source>The panel is not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Panelet er ikke gyldig JSON; led efter et manglende komma, anførselstegn eller en parentes</translation>
    </message>
    <message>
        <source>The alarms are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Alarmerne er ikke gyldig JSON; led efter et manglende komma, anførselstegn eller en parentes</translation>
    </message>
    <message>
        <source>The recipes are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Recepterne er ikke gyldig JSON; led efter et manglende komma, anførselstegn eller en parentes</translation>
    </message>
    <message>
        <source>The users and roles are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Brugerne og rollerne er ikke gyldig JSON; led efter et manglende komma, anførselstegn eller en parentes</translation>
    </message>
    <message>
        <source>The trace configuration is not valid JSON (see line {0}); look for a missing comma, quote or bracket</source>
        <translation>Traceopsætningen er ikke gyldig JSON (se linje {0}); led efter et manglende komma, anførselstegn eller en parentes</translation>
    </message>
    <message>
        <source>Two alarms have the id &quot;{0}&quot;; change one of them</source>
        <translation>To alarmer har id’et ”{0}”; ret det ene</translation>
    </message>
    <message>
        <source>The quote that opens here is never closed; add one at the end of the text</source>
        <translation>Anførselstegnet, der åbner her, bliver aldrig lukket; tilføj et efter teksten</translation>
    </message>
    <message>
        <source>The language {0} has two columns; remove one of them</source>
        <translation>Sproget {0} har to kolonner; fjern den ene</translation>
    </message>
    <message>
        <source>The key {0} is already on line {1}; remove one of the two lines</source>
        <translation>Nøglen {0} er allerede på linje {1}; fjern den ene af de to linjer</translation>
    </message>
    <message>
        <source>Two roles are named {0}; rename one</source>
        <translation>To roller hedder {0}; omdøb den ene</translation>
    </message>
    <message>
        <source>Two users are named {0}; rename one</source>
        <translation>To brugere hedder {0}; omdøb den ene</translation>
    </message>
    <message>
        <source>Two recipes are named {0}; rename one</source>
        <translation>To recepter hedder {0}; omdøb den ene</translation>
    </message>
    <message>
        <source>Two sets of the recipe are named {0}; rename one</source>
        <translation>To sæt i recepten hedder {0}; omdøb det ene</translation>
    </message>
    <message>
        <source>The alarm has no condition; enter one</source>
        <translation>Alarmen har ingen betingelse; angiv en</translation>
    </message>
    <message>
        <source>The element is outside the panel; move it inside</source>
        <translation>Elementet ligger uden for panelet; flyt det ind</translation>
    </message>
    <message>
        <source>The picture {0} is larger than {1} MB; use a smaller one</source>
        <translation>Billedet {0} er større end {1}&#xa0;MB; brug et mindre</translation>
    </message>
    <message>
        <source>The faceplate does not say which panel it shows; choose one</source>
        <translation>Faceplaten angiver ikke, hvilket panel den viser; vælg et</translation>
    </message>
    <message>
        <source>The key {0} has no text in {1}; enter it in the text table</source>
        <translation>Nøglen {0} har ingen tekst på {1}; indtast den i teksttabellen</translation>
    </message>
    <message>
        <source>The help of the alarm {0} does not say what to do; add the operator&apos;s next step</source>
        <translation>Hjælpen til alarmen {0} siger ikke, hvad der skal gøres; tilføj operatørens næste skridt</translation>
    </message>
    <message>
        <source>the reference is NULL; assign a variable to it, or compare it with NULL first</source>
        <translation>referencen er NULL; tildel den en variabel, eller sammenlign den først med NULL</translation>
    </message>
    <message>
        <source>the reference does not point to a variable of its type; assign one to it</source>
        <translation>referencen peger ikke på en variabel af sin type; tildel den en variabel af typen</translation>
    </message>
    <message>
        <source>a VAR_IN_OUT is not connected to a variable; connect it in the call</source>
        <translation>en VAR_IN_OUT er ikke forbundet med en variabel; forbind den i kaldet</translation>
    </message>
    <message>
        <source>the watchdog stopped a task that did not end; check for an endless loop</source>
        <translation>watchdoggen afbrød en task, der ikke sluttede; kontroller, om en løkke aldrig slutter</translation>
    </message>
    <message>
        <source>the task ran longer than its watchdog time of {0}; shorten its work or raise the time</source>
        <translation>tasken kørte længere end sin watchdogtid på {0}; gør dens arbejde kortere, eller forlæng tiden</translation>
    </message>
    <message>
        <source>the file name is too long; choose a shorter one</source>
        <translation>filnavnet er for langt; vælg et kortere</translation>
    </message>
    <message>
        <source>the folder is not empty; choose another one</source>
        <translation>mappen er ikke tom; vælg en anden</translation>
    </message>
    <message>
        <source>the file system is read-only; choose another folder</source>
        <translation>filsystemet er skrivebeskyttet; vælg en anden mappe</translation>
    </message>
    <message>
        <source>too many files are open; close some of them</source>
        <translation>der er for mange åbne filer; luk nogle af dem</translation>
    </message>
    <message>
        <source>The file is damaged or is not a recording; choose a file that Stepwise wrote (.rec)</source>
        <translation>Filen er beskadiget eller er ikke en optagelse; vælg en fil, som Stepwise har skrevet (.rec)</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is reached through a reference, which a path cannot follow; name the variable it refers to</source>
        <translation>”{0}” nås kun gennem en reference, som en sti ikke kan følge; angiv den variabel, den peger på</translation>
    </message>
    <message>
        <source>a string has one index; remove the others</source>
        <translation>en streng har ét indeks; fjern de andre</translation>
    </message>
    <message>
        <source>a variable of type {0} has no elements; remove the index</source>
        <translation>en variabel af typen {0} har ingen elementer; fjern indekset</translation>
    </message>
    <message>
        <source>a variable of type {0} has no bits; remove the bit number</source>
        <translation>en variabel af typen {0} har ingen bit; fjern bitnummeret</translation>
    </message>
    <message>
        <source>the program does not use the address &apos;{0}&apos;; declare a variable AT this address</source>
        <translation>programmet bruger ikke adressen ”{0}”; erklær en variabel med AT på denne adresse</translation>
    </message>
    <message>
        <source>the path is empty; write for example Main.x</source>
        <translation>stien er tom; skriv for eksempel Main.x</translation>
    </message>
    <message>
        <source>a constant cannot be written; change it in the program</source>
        <translation>en konstant kan ikke skrives; ret den i programmet</translation>
    </message>
    <message>
        <source>The retain file is not a regular file; remove it or choose another one</source>
        <translation>Retain-filen er ikke en almindelig fil; fjern den, eller vælg en anden</translation>
    </message>
    <message>
        <source>the text has {0} characters, the maximum is {1}; shorten it</source>
        <translation>teksten har {0} tegn, maksimum er {1}; gør den kortere</translation>
    </message>
    <message>
        <source>{0} has {1} {1:part|parts}, the value has {2}; write one value for each</source>
        <translation>{0} har {1} {1:del|dele}, værdien har {2}; skriv en værdi for hver</translation>
    </message>
    <message>
        <source>there is no value to write; enter one first</source>
        <translation>der er ingen værdi at skrive; indtast først en værdi</translation>
    </message>
    <message>
        <source>The expression is nested too deeply; divide it into several</source>
        <translation>Udtrykket er indlejret for dybt; del det i flere</translation>
    </message>
    <message>
        <source>this is not an expression; write for example Main.x &gt; 5</source>
        <translation>dette er ikke et udtryk; skriv for eksempel Main.x &gt; 5</translation>
    </message>
    <message>
        <source>this is not an array; remove the index</source>
        <translation>dette er ikke et array; fjern indekset</translation>
    </message>
    <message>
        <source>an expression cannot have side effects; use variables, operators and standard functions only</source>
        <translation>et udtryk må ikke have sideeffekter; brug kun variabler, operatorer og standardfunktioner</translation>
    </message>
    <message>
        <source>There is no body in ST or IL here; put the cursor into one</source>
        <translation>Her er ingen krop i ST eller IL; sæt markøren i en</translation>
    </message>
    <message>
        <source>There is no library {0}; check &quot;libraries&quot; in project.json</source>
        <translation>Der er intet bibliotek {0}; kontroller ”libraries” i project.json</translation>
    </message>
    <message>
        <source>This folder contains neither a project.json nor ST files; choose another folder or create a project</source>
        <translation>Denne mappe indeholder hverken en project.json eller ST-filer; vælg en anden mappe, eller opret et projekt</translation>
    </message>
    <message>
        <source>There is no such file or folder; check the path</source>
        <translation>Filen eller mappen findes ikke; kontroller stien</translation>
    </message>
    <message>
        <source>{0} already exists in the project; choose another name</source>
        <translation>{0} findes allerede i projektet; vælg et andet navn</translation>
    </message>
    <message>
        <source>{0} already exists in {1}; choose another name</source>
        <translation>{0} findes allerede i {1}; vælg et andet navn</translation>
    </message>
    <message>
        <source>The file is read-only and was not overwritten; make it writable or choose another name</source>
        <translation>Filen er skrivebeskyttet og blev ikke overskrevet; gør den skrivbar, eller vælg et andet navn</translation>
    </message>
    <message>
        <source>{0} is not a time; write for example T#2s</source>
        <translation>{0} er ikke en tid; skriv for eksempel T#2s</translation>
    </message>
    <message>
        <source>{0} is not a whole number; write for example 5</source>
        <translation>{0} er ikke et heltal; skriv for eksempel 5</translation>
    </message>
    <message>
        <source>{0} is not a number of scans; write for example 10</source>
        <translation>{0} er ikke et antal scan; skriv for eksempel 10</translation>
    </message>
    <message>
        <source>Nothing would lead to the join after this step; delete the join first</source>
        <translation>Intet ville føre til sammenføringen efter dette trin; slet først sammenføringen</translation>
    </message>
    <message>
        <source>There is no branch here; choose a step or transition in a branch</source>
        <translation>Her er ingen gren; vælg et trin eller en transition i en gren</translation>
    </message>
    <message>
        <source>The last branch does not lead to a step; connect it first</source>
        <translation>Den sidste gren fører ikke til et trin; forbind den først</translation>
    </message>
    <message>
        <source>There is no chart yet; write an INITIAL_STEP first</source>
        <translation>Der er endnu intet SFC-diagram; skriv først et INITIAL_STEP</translation>
    </message>
    <message>
        <source>An alarm has no id; give it one</source>
        <translation>En alarm har intet id; giv den et</translation>
    </message>
    <message>
        <source>Column {0} has no language tag; write one such as de or en-GB</source>
        <translation>Kolonne {0} har ingen sprogkode; skriv for eksempel de eller en-GB</translation>
    </message>
    <message>
        <source>This line has no key; write one in the first column</source>
        <translation>Denne linje har ingen nøgle; skriv en i første kolonne</translation>
    </message>
    <message>
        <source>This is not an XLIFF file; choose one that was exported for translation</source>
        <translation>Dette er ikke en XLIFF-fil; vælg en, der er eksporteret til oversættelse</translation>
    </message>
    <message>
        <source>There is no panel {0}; create it or choose another one</source>
        <translation>Der er intet panel {0}; opret det, eller vælg et andet</translation>
    </message>
    <message>
        <source>The key {0} is not in the text table; add it there</source>
        <translation>Nøglen {0} er ikke i teksttabellen; tilføj den dér</translation>
    </message>
    <message>
        <source>The project has no language {0}; add a column for it to texts.csv</source>
        <translation>Projektet har ikke sproget {0}; tilføj en kolonne til det i texts.csv</translation>
    </message>
    <message>
        <source>The file {0} does not exist; add it to the project or choose another one</source>
        <translation>Filen {0} findes ikke; føj den til projektet, eller vælg en anden</translation>
    </message>
    <message>
        <source>The panel has no group or tab {0}; create it or choose another one</source>
        <translation>Panelet har ingen gruppe og ingen faner {0}; opret den, eller vælg en anden</translation>
    </message>
    <message>
        <source>The group {0} contains itself; choose another parent</source>
        <translation>Gruppen {0} indeholder sig selv; vælg en anden overordnet</translation>
    </message>
    <message>
        <source>A role has no name; give it one</source>
        <translation>En rolle har intet navn; giv den et</translation>
    </message>
    <message>
        <source>A user has no name; give it one</source>
        <translation>En bruger har intet navn; giv brugeren et</translation>
    </message>
    <message>
        <source>There is no role {0}; create it or choose another one</source>
        <translation>Rollen {0} findes ikke; opret den, eller vælg en anden</translation>
    </message>
    <message>
        <source>A recipe has no name; give it one</source>
        <translation>En recept har intet navn; giv den et</translation>
    </message>
    <message>
        <source>A set of a recipe has no name; give it one</source>
        <translation>Et sæt i en recept har intet navn; giv det et</translation>
    </message>
    <message>
        <source>The recipe has the variable {0} twice; remove one of the two</source>
        <translation>Recepten har variablen {0} to gange; fjern den ene</translation>
    </message>
    <message>
        <source>The set {0} has no value for {1}; enter one</source>
        <translation>Sættet {0} har ingen værdi for {1}; indtast en</translation>
    </message>
    <message>
        <source>There is no alarm class {0}; add it or choose another one</source>
        <translation>Der er ingen alarmklasse {0}; tilføj den, eller vælg en anden</translation>
    </message>
    <message>
        <source>No panel and no alarm uses the key {0}; use it or remove it</source>
        <translation>Intet panel og ingen alarm bruger nøglen {0}; brug eller fjern den</translation>
    </message>
    <message>
        <source>The placeholders differ: {0} has {1}, {2} has {3}; use the same in both</source>
        <translation>Pladsholderne er forskellige: {0} har {1}, {2} har {3}; brug de samme i begge</translation>
    </message>
    <message>
        <source>The font {0} is not installed here, so texts cannot be measured; install it</source>
        <translation>Skrifttypen {0} er ikke installeret her, så tekster kan ikke måles; installer den</translation>
    </message>
    <message>
        <source>No font has the character {0}; use another one</source>
        <translation>Ingen skrifttype har tegnet {0}; brug et andet</translation>
    </message>
    <message>
        <source>{0} covers a part of it; move one of the two</source>
        <translation>{0} dækker en del af det; flyt et af de to</translation>
    </message>
    <message>
        <source>Nothing leads from the start panel {1} to the panel {0}; add a button, a navigation bar or an alarm, or choose another start panel</source>
        <translation>Intet fører fra startpanelet {1} til panelet {0}; tilføj en knap, en navigationslinje eller en alarm, eller vælg et andet startpanel</translation>
    </message>
    <message>
        <source>{0} of {1} alarms have the highest priority; keep it for the few that cannot wait</source>
        <translation>{0} af {1} alarmer har den højeste prioritet; brug den kun til de få, der ikke kan vente</translation>
    </message>
    <message>
        <source>The project has {0} {0:alarm|alarms}, but no panel has an alarm list or banner; add one</source>
        <translation>Projektet har {0} {0:alarm|alarmer}, men intet panel har en alarmliste eller et alarmbanner; tilføj en</translation>
    </message>
    <message>
        <source>{0} is critical according to project.json, but a single press writes it; set &quot;Writes are confirmed&quot;</source>
        <translation>{0} er kritisk ifølge project.json, men ét tryk skriver den; slå ”Skrivning bekræftes” til</translation>
    </message>
    <message>
        <source>{0} suppresses alarms, but a single press writes it; set &quot;Writes are confirmed&quot;</source>
        <translation>{0} undertrykker alarmer, men ét tryk skriver den; slå ”Skrivning bekræftes” til</translation>
    </message>
    <message>
        <source>The start panel has {0} controls, but no text says what to press when nothing moves; add a sentence, or a state text that names a control</source>
        <translation>Startpanelet har {0} betjeningselementer, men ingen tekst siger, hvad man skal trykke på, når intet bevæger sig; tilføj en sætning eller en tilstandstekst, der nævner et betjeningselement</translation>
    </message>
    <message>
        <source>A machine at rest looks the same whether it is broken or just waiting. The start panel must say what to press next: a sentence below the title, or a state text such as “Ready: press S1”.</source>
        <translation>En maskine, der holder stille, ser ens ud, hvad enten den er i stykker eller kun venter. Startpanelet skal sige, hvad man nu skal trykke på: med en sætning under titlen eller en tilstandstekst som ”Klar: tryk på S1”.</translation>
    </message>
    <message>
        <source>{0} is not the code of a language; use codes such as {1} or {2}</source>
        <translation>{0} er ikke en sprogkode; brug koder som {1} eller {2}</translation>
    </message>
    <message>
        <source>Single files have no project.json for settings; create a project and put them into its folder src</source>
        <translation>Enkelte filer har ingen project.json til indstillinger; opret et projekt, og læg dem i mappen src</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>Alarm texts in five languages</source>
        <translation>Alarmtekster på fem sprog</translation>
    </message>
    <message>
        <source>Heated tank with analog blocks</source>
        <translation>Opvarmet tank med analoge blokke</translation>
    </message>
    <message>
        <source>Bottling line</source>
        <translation>Tappelinje</translation>
    </message>
    <message>
        <source>Car park with a robot</source>
        <translation>Parkeringshus med robot</translation>
    </message>
    <message>
        <source>Car wash with recipes</source>
        <translation>Bilvask med recepter</translation>
    </message>
    <message>
        <source>Room heating with supply air</source>
        <translation>Rum opvarmet med indblæsningsluft</translation>
    </message>
    <message>
        <source>Motor valve with command monitor</source>
        <translation>Motorventil med overvågning</translation>
    </message>
    <message>
        <source>Conveyor with a sequence</source>
        <translation>Transportbånd med sekvens</translation>
    </message>
    <message>
        <source>Depalletiser</source>
        <translation>Depalleteringsanlæg</translation>
    </message>
    <message>
        <source>District-heating substation</source>
        <translation>Fjernvarmeunit</translation>
    </message>
    <message>
        <source>Dosing</source>
        <translation>Dosering</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Gravel plant</source>
        <translation>Grusværk</translation>
    </message>
    <message>
        <source>Heater and valve</source>
        <translation>Varmelegeme og ventil</translation>
    </message>
    <message>
        <source>Hour meter with reset and enable</source>
        <translation>Timetæller med nulstilling og frigivelse</translation>
    </message>
    <message>
        <source>Hourly production</source>
        <translation>Emner pr. time</translation>
    </message>
    <message>
        <source>Item counter and meters</source>
        <translation>Emner og målere</translation>
    </message>
    <message>
        <source>Level lamps</source>
        <translation>Niveaulamper</translation>
    </message>
    <message>
        <source>Light tower</source>
        <translation>Lystårn</translation>
    </message>
    <message>
        <source>Tuning a control loop</source>
        <translation>Indstilling af en reguleringssløjfe</translation>
    </message>
    <message>
        <source>Mixer for two liquids and two bricks</source>
        <translation>Mixer til to væsker og to blokke</translation>
    </message>
    <message>
        <source>Motor with latching</source>
        <translation>Motor med selvhold</translation>
    </message>
    <message>
        <source>Operation mode of an agitator</source>
        <translation>Driftsform for en omrører</translation>
    </message>
    <message>
        <source>PID loop on a first-order process</source>
        <translation>PID-sløjfe på en førsteordensproces</translation>
    </message>
    <message>
        <source>Two pumps in a well</source>
        <translation>To pumper i en brønd</translation>
    </message>
    <message>
        <source>Pulse width modulation of a sine</source>
        <translation>Pulsbreddemodulation af en sinus</translation>
    </message>
    <message>
        <source>Storage rack with a robot</source>
        <translation>Reol med robot</translation>
    </message>
    <message>
        <source>Robot and CNC machine</source>
        <translation>Robot og CNC-maskine</translation>
    </message>
    <message>
        <source>Packing robot with camera inspection</source>
        <translation>Robot, der pakker kasser</translation>
    </message>
    <message>
        <source>Two redundant level sensors</source>
        <translation>To niveausensorer sammenlignes</translation>
    </message>
    <message>
        <source>Pumping station with six pumps</source>
        <translation>Pumpestation med seks pumper</translation>
    </message>
    <message>
        <source>Motor with selector switch</source>
        <translation>Motor med vælger</translation>
    </message>
    <message>
        <source>Stack of integers</source>
        <translation>Stak af heltal</translation>
    </message>
    <message>
        <source>Tank with filling, heating and emptying</source>
        <translation>Tank, der fyldes, opvarmes og tømmes</translation>
    </message>
    <message>
        <source>Manually operated tank</source>
        <translation>Tank med manuel betjening</translation>
    </message>
    <message>
        <source>Level and volume</source>
        <translation>Niveau og volumen</translation>
    </message>
    <message>
        <source>Traffic light</source>
        <translation>Trafiklys</translation>
    </message>
    <message>
        <source>Valve matrix</source>
        <translation>Ventilmatrix</translation>
    </message>
    <message>
        <source>Three kinds of valves</source>
        <translation>Tre slags ventiler</translation>
    </message>
    <message>
        <source>Pump control with waves</source>
        <translation>Pumpe i bølger</translation>
    </message>
    <message>
        <source>Truck scale</source>
        <translation>Lastbilvægt</translation>
    </message>
    <message>
        <source>Workbook</source>
        <translation>Arbejdsbog</translation>
    </message>
    <message>
        <source>Tank over Modbus</source>
        <translation>Tank over Modbus</translation>
    </message>
    <message>
        <source>A vehicle between two limit switches, controlled by two linked sequential function charts</source>
        <translation>En vogn mellem to endestop, styret af to forbundne SFC-diagrammer</translation>
    </message>
    <message>
        <source>A motor with three alarms that operators read in five languages</source>
        <translation>En motor med tre alarmer, som operatøren kan læse på fem sprog</translation>
    </message>
    <message>
        <source>One control loop with a block for each task: filter, monitor, ramp, PID, transfer</source>
        <translation>En reguleringssløjfe med en blok til hver opgave: filter, overvågning, rampe, PID, omskiftning</translation>
    </message>
    <message>
        <source>Filler, capper and labeller with buffers between them, controlled as PackML units</source>
        <translation>Fylder, lukker og etiketteringsmaskine med buffere imellem, styret efter PackML</translation>
    </message>
    <message>
        <source>A robot parks cars by number plate and retrieves them again</source>
        <translation>En robot parkerer biler efter nummerplade og henter dem igen</translation>
    </message>
    <message>
        <source>Five wash programmes, each with a price and a recipe that the owner can edit</source>
        <translation>Fem vaskeprogrammer, hvert med pris og recept, som ejeren kan ændre</translation>
    </message>
    <message>
        <source>Cascade control: a slow loop for the room, a fast one for the supply air</source>
        <translation>Kaskaderegulering: en langsom sløjfe til rummet, en hurtig til indblæsningen</translation>
    </message>
    <message>
        <source>A motor valve whose travel is monitored; if it takes too long, an alarm sounds</source>
        <translation>En motorventil med overvåget gangtid; tager det for lang tid, lyder en alarm</translation>
    </message>
    <message>
        <source>A belt carries an item to the right, waits ten seconds and carries it back</source>
        <translation>Et transportbånd fører et emne til højre, venter ti sekunder og fører det tilbage</translation>
    </message>
    <message>
        <source>Four belts take boxes off pallets; the settings of one can be copied to another</source>
        <translation>Fire bånd tager kasser af paller; indstillingerne kan kopieres mellem dem</translation>
    </message>
    <message>
        <source>Heating and hot water from a district-heating network, with frost protection and summer mode</source>
        <translation>Varme og varmt brugsvand fra fjernvarme, med frostsikring og sommerdrift</translation>
    </message>
    <message>
        <source>A valve doses in pulses and pauses until the batch is complete</source>
        <translation>En ventil doserer i pulser og pauser, indtil batchen er færdig</translation>
    </message>
    <message>
        <source>The pressure drop shows how dirty a filter is; an alarm reports when it is out of range</source>
        <translation>Tryktabet viser, hvor snavset et filter er; uden for området kommer en alarm</translation>
    </message>
    <message>
        <source>Silo, bin, conveyor and truck, controlled by three parallel sequential function charts</source>
        <translation>Silo, beholder, transportbånd og lastbil, styret af tre parallelle SFC-diagrammer</translation>
    </message>
    <message>
        <source>Two on-off controls: a heater with a set point, and a valve that opens on a pump alarm</source>
        <translation>To on/off-reguleringer: et varmelegeme med setpunkt og en ventil, der åbner ved pumpealarm</translation>
    </message>
    <message>
        <source>An hour meter that is loaded, enabled and held, giving a sawtooth</source>
        <translation>En timetæller, der indlæses, aktiveres og holdes: en savtand</translation>
    </message>
    <message>
        <source>A press makes items; a table counts how many in each hour of the day</source>
        <translation>En presse laver emner; en tabel tæller, hvor mange hver time</translation>
    </message>
    <message>
        <source>Counts items, energy and water; the counts survive a power failure</source>
        <translation>Tæller emner, energi og vand; tallene overlever et strømsvigt</translation>
    </message>
    <message>
        <source>A 4 to 20 mA level sensor, three lamps and wire break detection</source>
        <translation>En niveausensor på 4 til 20&#xa0;mA, tre lamper og registrering af ledningsbrud</translation>
    </message>
    <message>
        <source>Three machine signals on three lamps that flash or stay on</source>
        <translation>Tre signaler fra en maskine på tre lamper, der blinker eller lyser</translation>
    </message>
    <message>
        <source>A heat exchanger that oscillates; an experiment and its recording give better settings</source>
        <translation>En varmeveksler svinger; et forsøg og dets optagelse giver bedre parametre</translation>
    </message>
    <message>
        <source>Liquids are weighed while a belt brings two bricks; then the mixer turns and tips</source>
        <translation>Væsker vejes, mens et bånd bringer to blokke; derefter blander og tipper mixeren</translation>
    </message>
    <message>
        <source>Start, stop and a latching contactor, written in five ways that agree</source>
        <translation>Start, stop og en kontaktor med selvhold, skrevet på fem ens måder</translation>
    </message>
    <message>
        <source>The local control box or the panel: one block decides which of them is in control</source>
        <translation>Lokal betjening eller panel: en blok afgør, hvem der har styringen</translation>
    </message>
    <message>
        <source>The same process with and without a PID controller, side by side in one trace</source>
        <translation>Den samme proces med og uden PID-regulator, side om side i én trace</translation>
    </message>
    <message>
        <source>One filter, two sines: the slow one passes, the fast one is attenuated and delayed</source>
        <translation>Ét filter, to sinussignaler: det langsomme passerer, det hurtige dæmpes og forsinkes</translation>
    </message>
    <message>
        <source>A pump tries its speeds and keeps the one with the least energy per cubic metre</source>
        <translation>En pumpe prøver omdrejningstal og beholder det med mindst energi pr. kubikmeter</translation>
    </message>
    <message>
        <source>Two alternating pumps; a float switch is accepted only after two steady seconds</source>
        <translation>To pumper skiftes; en svømmer tæller først efter to rolige sekunder</translation>
    </message>
    <message>
        <source>A sine becomes pulses for two outputs, as for a motor with two directions</source>
        <translation>En sinus bliver til pulser på to udgange, som til en motor med to retninger</translation>
    </message>
    <message>
        <source>A robot counts encoder pulses to store and retrieve loads in twelve locations</source>
        <translation>En robot tæller encoderpulser for at lægge last på tolv hylder og hente den igen</translation>
    </message>
    <message>
        <source>A robot takes 25 items one by one to a CNC machine and back</source>
        <translation>En robot bringer 25 emner ét for ét til en CNC-maskine og tilbage</translation>
    </message>
    <message>
        <source>A robot puts three items into each box; a camera checks the result</source>
        <translation>En robot lægger tre emner i hver kasse; et kamera kontrollerer resultatet</translation>
    </message>
    <message>
        <source>Two sensors are compared; a faulty one is replaced with the healthy one without a jump</source>
        <translation>To sensorer sammenlignes; en defekt erstattes stødfrit af den raske</translation>
    </message>
    <message>
        <source>Starts and stops six pumps by level and running hours, with the daily inflow of a town</source>
        <translation>Starter og stopper seks pumper efter niveau og driftstimer gennem en bys døgn</translation>
    </message>
    <message>
        <source>A rotary switch selects the speed of a motor, a number what a module does</source>
        <translation>En drejekontakt vælger en motors omdrejningstal, et tal vælger et moduls funktion</translation>
    </message>
    <message>
        <source>Last in, first out: push, pop and reset, in ST and as an instruction list</source>
        <translation>Sidst ind, først ud: push, pop og reset, i ST og som instruktionsliste</translation>
    </message>
    <message>
        <source>The same sequence twice: with CASE and as a sequential function chart; either can be in control</source>
        <translation>Det samme forløb to gange: med CASE og som SFC-diagram; begge kan styre</translation>
    </message>
    <message>
        <source>Fill, empty and stir with three switches; two level switches prevent operating errors</source>
        <translation>Fyld, tøm og rør med tre kontakter; to niveaukontakter forhindrer fejl</translation>
    </message>
    <message>
        <source>A current of 4 to 20 mA becomes a level, and the level becomes a volume</source>
        <translation>En strøm på 4 til 20&#xa0;mA bliver til et niveau, og niveauet til et volumen</translation>
    </message>
    <message>
        <source>Red, yellow and green from one seconds counter, written in three ways</source>
        <translation>Rødt, gult og grønt fra én sekundtæller, skrevet på tre måder</translation>
    </message>
    <message>
        <source>Five tanks, three pipelines, fifteen valves; two tanks never feed the same pipeline</source>
        <translation>Fem tanke, tre rørledninger, femten ventiler; aldrig to tanke på samme ledning</translation>
    </message>
    <message>
        <source>A motor valve, a spring-return valve and a control valve, each with its block</source>
        <translation>En motorventil, en ventil med fjederretur og en reguleringsventil, hver med sin blok</translation>
    </message>
    <message>
        <source>A float switch in waves: the pump starts and stops only after five steady seconds</source>
        <translation>En svømmer i bølger: pumpen kobler først efter fem rolige sekunder</translation>
    </message>
    <message>
        <source>Four BCD digits become the net weight once the scale has settled</source>
        <translation>Fire BCD-cifre bliver til nettovægten, når vægten er i ro</translation>
    </message>
    <message>
        <source>Language samples on four pages, each a separate program with a test</source>
        <translation>Sprogeksempler på fire sider, hvert et program for sig med en test</translation>
    </message>
    <message>
        <source>Automated guided vehicle</source>
        <translation>Førerløst køretøj</translation>
    </message>
    <message>
        <source>First-order filter and two sines</source>
        <translation>Førsteordensfilter og to sinussignaler</translation>
    </message>
    <message>
        <source>Pump at its most efficient speed</source>
        <translation>Pumpe ved bedste omdrejningstal</translation>
    </message>
    <message>
        <source>A controller and a tank, connected on this computer by real Modbus TCP</source>
        <translation>En styring og en tank, forbundet med ægte Modbus TCP på denne computer</translation>
    </message>
</context>
<context>
    <name>Exchange</name>
    <message>
        <source>The file is written in {0}</source>
        <translation>Filen er skrevet i {0}</translation>
    </message>
    <message>
        <source>The file was not read: {0}</source>
        <translation>Filen blev ikke læst: {0}</translation>
    </message>
    <message>
        <source>The element {0} was not read; add it by hand if the program needs it</source>
        <translation>Elementet {0} blev ikke læst; tilføj det selv, hvis programmet har brug for det</translation>
    </message>
    <message>
        <source>The vendor&apos;s data {0} is kept in exchange.json</source>
        <translation>Leverandørens data {0} er gemt i exchange.json</translation>
    </message>
    <message>
        <source>The body in {0} became structured text; the diagram is kept in exchange.json</source>
        <translation>Kroppen i {0} blev til struktureret tekst; diagrammet er gemt i exchange.json</translation>
    </message>
    <message>
        <source>The body in {0} is stored in a form that only its own editor reads; export it there as PLCopen XML</source>
        <translation>Kroppen i {0} er gemt i en form, som kun dens egen editor læser; eksporter den der som PLCopen XML</translation>
    </message>
    <message>
        <source>A jump leads to the step {0}, which does not exist; add the step or correct the jump</source>
        <translation>Et spring fører til trinnet {0}, som ikke findes; tilføj trinnet, eller ret springet</translation>
    </message>
    <message>
        <source>The element {0} of the chart is not connected and was left out; connect it in the other tool and export again</source>
        <translation>Elementet {0} i SFC-diagrammet er ikke forbundet og blev udeladt; forbind det i det andet værktøj, og eksporter igen</translation>
    </message>
    <message>
        <source>The transition from {0} has no condition and is written as FALSE; enter its condition</source>
        <translation>Transitionen fra {0} har ingen betingelse og er skrevet som FALSE; indtast dens betingelse</translation>
    </message>
    <message>
        <source>The element {0} takes part in a loop without a block that stores a value, so its last value is not kept; store it in a variable</source>
        <translation>Elementet {0} indgår i en sløjfe uden en blok, der gemmer en værdi, så dets sidste værdi bevares ikke; gem den i en variabel</translation>
    </message>
    <message>
        <source>The element {0} is not connected and was left out; connect it in the other tool and export again</source>
        <translation>Elementet {0} er ikke forbundet og blev udeladt; forbind det i det andet værktøj, og eksporter igen</translation>
    </message>
    <message>
        <source>An input of {0} is not connected, so its call has too few arguments; add the value that is meant</source>
        <translation>En indgang på {0} er ikke forbundet, så kaldet har for få argumenter; tilføj den værdi, der menes</translation>
    </message>
    <message>
        <source>An edge in a function needs the value of the last call, which a function does not store; make it a FUNCTION_BLOCK</source>
        <translation>En flanke i en funktion kræver værdien fra sidste kald, som en funktion ikke gemmer; gør den til en FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>The result of {0} is used in several places and is computed in each; assign it to a variable to compute it once</source>
        <translation>Resultatet af {0} bruges flere steder og beregnes hvert sted; tildel det til en variabel for at beregne det én gang</translation>
    </message>
    <message>
        <source>The type of the result of {0} is not known, so it is computed although EN is FALSE; call it under an IF</source>
        <translation>Typen af resultatet af {0} er ikke kendt, så det beregnes, selv om EN er FALSE; kald det under et IF</translation>
    </message>
    <message>
        <source>The library {0} is not part of Stepwise; uses of it are reported by the check</source>
        <translation>Biblioteket {0} hører ikke til Stepwise; kontrollen melder, hvor det bruges</translation>
    </message>
    <message>
        <source>Code in C is kept as a comment and is not executed; write it in ST</source>
        <translation>Kode i C er bevaret som kommentar og udføres ikke; skriv den i ST</translation>
    </message>
    <message>
        <source>There are two units named {0}; the second is in {1}</source>
        <translation>Der er to programenheder med navnet {0}; den anden er i {1}</translation>
    </message>
    <message>
        <source>The configuration of the devices was not read; assign the inputs and outputs again</source>
        <translation>Enhedernes konfiguration blev ikke læst; tildel ind- og udgange igen</translation>
    </message>
    <message>
        <source>The task {0} is started by the event {1}, which does not exist here; give it an INTERVAL or a SINGLE</source>
        <translation>Tasken {0} startes af hændelsen {1}, som ikke findes her; giv den et INTERVAL eller et SINGLE</translation>
    </message>
    <message>
        <source>A comment outside of the elements was left out: {0}</source>
        <translation>En kommentar uden for elementerne blev udeladt: {0}</translation>
    </message>
    <message>
        <source>The diagram in {0} was not read: an expression refers to itself endlessly; write its body in ST</source>
        <translation>Diagrammet i {0} blev ikke læst: et udtryk henviser til sig selv uden ende; skriv dets krop i ST</translation>
    </message>
    <message>
        <source>The transition {0} is not a single expression and was not read; write its condition in the text</source>
        <translation>Transitionen {0} er ikke et enkelt udtryk og blev ikke læst; skriv dens betingelse i teksten</translation>
    </message>
    <message>
        <source>PLCopen XML does not support panels; they were left out</source>
        <translation>PLCopen XML understøtter ikke paneler; de blev udeladt</translation>
    </message>
    <message>
        <source>PLCopen XML does not support traces; they were left out</source>
        <translation>PLCopen XML understøtter ikke traces; de blev udeladt</translation>
    </message>
    <message>
        <source>PLCopen XML does not support tests; they were left out</source>
        <translation>PLCopen XML understøtter ikke tests; de blev udeladt</translation>
    </message>
    <message>
        <source>PLCopen XML does not support tests; the TEST &apos;{0}&apos; was left out</source>
        <translation>PLCopen XML understøtter ikke tests; TEST ”{0}” blev udeladt</translation>
    </message>
    <message>
        <source>PLCopen XML does not support namespaces; the names of {0} are written without the prefix</source>
        <translation>PLCopen XML understøtter ikke navnerum; navnene i {0} skrives uden præfikset</translation>
    </message>
    <message>
        <source>PLCopen XML does not support namespaces; {0} was left out with its units because there is another {1}; rename one of them</source>
        <translation>PLCopen XML understøtter ikke navnerum; {0} blev udeladt med sine programenheder, fordi der findes endnu et {1}; omdøb et af dem</translation>
    </message>
    <message>
        <source>PLCopen XML does not support USING; it was left out</source>
        <translation>PLCopen XML understøtter ikke USING; det blev udeladt</translation>
    </message>
    <message>
        <source>PLCopen XML does not support the name of the transition {0}; it was left out</source>
        <translation>PLCopen XML understøtter ikke navnet på transitionen {0}; det blev udeladt</translation>
    </message>
    <message>
        <source>PLCopen XML has one indicator per action; {0} was left out</source>
        <translation>PLCopen XML har én indikator pr. aktion; {0} blev udeladt</translation>
    </message>
    <message>
        <source>Version 0201 has no methods; {0} was left out</source>
        <translation>Version 0201 har ingen metoder; {0} blev udeladt</translation>
    </message>
    <message>
        <source>Version 0201 has no properties; {0} was left out</source>
        <translation>Version 0201 har ingen egenskaber; {0} blev udeladt</translation>
    </message>
    <message>
        <source>Version 0201 has no interfaces; {0} was left out</source>
        <translation>Version 0201 har ingen interfaces; {0} blev udeladt</translation>
    </message>
    <message>
        <source>Version 0201 has no unions; {0} was left out</source>
        <translation>Version 0201 har ingen unions; {0} blev udeladt</translation>
    </message>
    <message>
        <source>Version 0201 has no inheritance; EXTENDS or IMPLEMENTS of {0} was left out</source>
        <translation>Version 0201 har ingen nedarvning; EXTENDS eller IMPLEMENTS i {0} blev udeladt</translation>
    </message>
    <message>
        <source>Version 0201 does not have the type {0}; other tools will not know it</source>
        <translation>Version 0201 har ikke typen {0}; andre værktøjer kender den ikke</translation>
    </message>
    <message>
        <source>Version 0201 does not support the pragma {0} of a step; it was left out</source>
        <translation>Version 0201 understøtter ikke pragmaet {0} på et trin; det blev udeladt</translation>
    </message>
    <message>
        <source>Version 0201 does not support {0} of a task; it was left out</source>
        <translation>Version 0201 understøtter ikke {0} for en task; det blev udeladt</translation>
    </message>
    <message>
        <source>Version 0201 does not support the connections of the program {0}; they were left out</source>
        <translation>Version 0201 understøtter ikke forbindelserne for programmet {0}; de blev udeladt</translation>
    </message>
    <message>
        <source>Version 0201 does not support libraries; {0} was left out</source>
        <translation>Version 0201 understøtter ikke biblioteker; {0} blev udeladt</translation>
    </message>
    <message>
        <source>The file is not a program source and was left out; import it separately if it is one</source>
        <translation>Filen er ikke en programkilde og blev udeladt; importer den alene, hvis den er det</translation>
    </message>
    <message>
        <source>The network &apos;{0}&apos; is commented out in the diagram and was left out of the text</source>
        <translation>Netværket ”{0}” er kommenteret ud i diagrammet og er udeladt af teksten</translation>
    </message>
    <message>
        <source>Types that are predefined in {0} are declared here</source>
        <translation>Typer, der er foruddefineret i {0}, er erklæret her</translation>
    </message>
    <message>
        <source>{0} counts %MW1 in words; &quot;addressing&quot; in project.json says the same</source>
        <translation>{0} tæller %MW1 i ord; ”addressing” i project.json siger det samme</translation>
    </message>
    <message>
        <source>The address {0} starts at a byte that tools counting in words cannot address; move it to a multiple of its size</source>
        <translation>Adressen {0} begynder ved en byte, som andre værktøjer, der tæller i ord, ikke kan adressere; flyt den til et multiplum af dens størrelse</translation>
    </message>
    <message>
        <source>{0} accesses the system outside the controller; it is declared here with its inputs and outputs but does nothing</source>
        <translation>{0} bruger systemet uden for styringen; den er erklæret her med sine indgange og udgange, men gør intet</translation>
    </message>
    <message>
        <source>The library {0} is part of this import; its names are written without the prefix {0}</source>
        <translation>Biblioteket {0} er en del af denne import; dets navne skrives uden præfikset {0}</translation>
    </message>
    <message>
        <source>The names of the library {0} are built into Stepwise; they are written without the prefix {0}</source>
        <translation>Navnene i biblioteket {0} er indbygget i Stepwise; de skrives uden præfikset {0}</translation>
    </message>
    <message>
        <source>The program uses __NEW; &quot;memoryForNew&quot; in project.json sets 65536 bytes aside for it</source>
        <translation>Programmet bruger __NEW; ”memoryForNew” i project.json afsætter 65536 byte til det</translation>
    </message>
    <message>
        <source>STRING constants contain characters that Latin-1 does not have ({0} and so on); &quot;stringEncoding&quot; in project.json is {1}</source>
        <translation>STRING-konstanter indeholder tegn, som Latin-1 ikke har ({0} og så videre); ”stringEncoding” i project.json er {1}</translation>
    </message>
    <message>
        <source>The file is empty; export it again</source>
        <translation>Filen er tom; eksporter den igen</translation>
    </message>
    <message>
        <source>This is a ZIP archive despite its name; extract it and import the folder</source>
        <translation>Dette er et ZIP-arkiv trods navnet; pak det ud, og importer mappen</translation>
    </message>
    <message>
        <source>The file is in the folder of the project {0}, which does not list it or excludes it from its build; it was left out</source>
        <translation>Filen er i mappen til projektet {0}, som ikke har den på sin liste eller udelukker den fra oversættelsen; den blev udeladt</translation>
    </message>
    <message>
        <source>Several projects of the folder have a unit named {0}; each became a project of its own, together with the libraries it uses: this one is {1}</source>
        <translation>Flere projekter i mappen har en programenhed med navnet {0}; hvert blev til sit eget projekt sammen med de biblioteker, det bruger: dette er {1}</translation>
    </message>
    <message>
        <source>The program {0} of the library {1} was left out: the project that uses the library has one of that name</source>
        <translation>Programmet {0} i biblioteket {1} blev udeladt: projektet, der bruger biblioteket, har et med samme navn</translation>
    </message>
    <message>
        <source>The folder has no project named {0}; it has: {1}</source>
        <translation>Mappen har intet projekt med navnet {0}; den har: {1}</translation>
    </message>
    <message>
        <source>The names of inputs and outputs that the configuration of the devices declares ({0} and so on) are in PLC_Configuration</source>
        <translation>Navnene på de ind- og udgange, som enhedernes konfiguration erklærer ({0} osv.), er i PLC_Configuration</translation>
    </message>
    <message>
        <source>The file is not valid UTF-8 and specifies no other encoding; it was read as {0}. If letters are wrong, import it again with another encoding</source>
        <translation>Filen er ikke gyldig UTF-8 og angiver ingen anden tegnkodning; den blev læst som {0}. Hvis bogstaver er forkerte, så importer den igen med en anden tegnkodning</translation>
    </message>
    <message>
        <source>Macro step {0} was replaced by the steps inside it; steps whose names were already used are prefixed with {0}</source>
        <translation>Makrotrinnet {0} blev erstattet af sine trin; trin med et navn, der allerede var brugt, har fået {0} foran</translation>
    </message>
    <message>
        <source>The program uses {0} of the library {1}, which reaches outside a simulated controller; declare POUs of these names that do what the simulation needs</source>
        <translation>Programmet bruger {0} fra biblioteket {1}, som rækker ud over en simuleret styring; erklær POU’er med disse navne, som gør det, simuleringen skal bruge</translation>
    </message>
    <message>
        <source>Conditions in {0} are drawn with blocks; the action {1}, which runs in every scan from the initial step on, calls them</source>
        <translation>Betingelser i {0} er tegnet med blokke; aktionen {1}, der kører i hvert scan fra starttrinnet, kalder dem</translation>
    </message>
    <message>
        <source>The drawn body of {0} was not read; open the project in CODESYS V3 and export it there as PLCopen XML</source>
        <translation>Den tegnede krop i {0} blev ikke læst; åbn projektet i CODESYS V3, og eksporter det dér som PLCopen XML</translation>
    </message>
    <message>
        <source>The drawn body of {0} was not read: the order of the inputs of {1} is not known. Import the file that declares {1} together with this one</source>
        <translation>Den tegnede krop i {0} blev ikke læst: rækkefølgen af indgangene på {1} er ikke kendt. Importer filen, der erklærer {1}, sammen med denne</translation>
    </message>
    <message>
        <source>The program uses {0}, which none of its files declares; the project uses the library {1}, which has it</source>
        <translation>Programmet bruger {0}, som ingen af dets filer erklærer; projektet bruger biblioteket {1}, som indeholder det</translation>
    </message>
    <message>
        <source>The task {0} runs {1}, a program of a library; it was left out. Call what the machine needs of it from a program of the project</source>
        <translation>Tasken {0} kører {1}, et program i et bibliotek; det blev udeladt. Kald det, maskinen har brug for af det, fra et program i projektet</translation>
    </message>
    <message>
        <source>The variables of this extension are declared in {0}; its code in C or Python is not executed. Write to them in ST what the code does</source>
        <translation>Denne udvidelses variabler er erklæret i {0}; dens kode i C eller Python udføres ikke. Skriv til dem i ST det, som koden gør</translation>
    </message>
    <message>
        <source>Version 0201 does not support the constructor arguments of {0}; they were left out</source>
        <translation>Version 0201 understøtter ikke konstruktørargumenterne til {0}; de blev udeladt</translation>
    </message>
</context>
<context>
    <name>FigureText</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 ved %2</translation>
    </message>
    <message>
        <source>An XY plot draws one channel against another: add a second channel to the trace.</source>
        <translation>Et XY-diagram viser én kanal over en anden: tilføj en kanal mere til tracen.</translation>
    </message>
    <message>
        <source>XY plot</source>
        <translation>XY-diagram</translation>
    </message>
    <message>
        <source>There are no samples in view: run the program or show another section.</source>
        <translation>Der er ingen målepunkter i det viste område: kør programmet, eller vis et andet område.</translation>
    </message>
    <message>
        <source>%L1 points over %2</source>
        <translation>%L1 punkter over %2</translation>
    </message>
    <message>
        <source>A spectrum shows the frequencies of the visible channels: add a channel.</source>
        <translation>Et spektrum viser frekvenserne i de synlige kanaler: tilføj en kanal.</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>Frekvens [Hz]</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>amplitude</translation>
    </message>
    <message>
        <source>%1: no peak, RMS %2</source>
        <translation>%1: ingen top, effektivværdi %2</translation>
    </message>
    <message>
        <source>%1: %2, RMS %3</source>
        <translation>%1: %2, effektivværdi %3</translation>
    </message>
    <message>
        <source>A frequency response compares an output with an input: add both as channels, and choose the input.</source>
        <translation>En frekvensrespons sammenligner en udgang med en indgang: tilføj begge som kanaler, og vælg indgangen.</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frekvensrespons</translation>
    </message>
    <message>
        <source>gain [dB]</source>
        <translation>forstærkning [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>fase [°]</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>kohærens</translation>
    </message>
    <message>
        <source>%1: %L2 of %L3 frequencies with a coherence above 0.8</source>
        <translation>%1: %L2 af %L3 frekvenser med en kohærens over 0,8</translation>
    </message>
    <message>
        <source>Runs are overlaid at their triggers: enter a trigger in the properties of the trace.</source>
        <translation>Kørsler lægges oven på hinanden ved deres trigger: angiv en trigger i tracens egenskaber.</translation>
    </message>
    <message>
        <source>The trigger has not fired in this recording yet.</source>
        <translation>Triggeren er endnu ikke udløst i denne optagelse.</translation>
    </message>
    <message>
        <source>The runs of the visible channels are overlaid: add a channel.</source>
        <translation>Kørsler af de synlige kanaler lægges oven på hinanden: tilføj en kanal.</translation>
    </message>
    <message>
        <source>Time since the trigger [s]</source>
        <translation>Tid siden trigger [s]</translation>
    </message>
    <message>
        <source>%1: runs differ most %2 after the trigger, by %3</source>
        <translation>%1: kørslerne afviger mest %2 efter trigger, med %3</translation>
    </message>
    <message>
        <source>Charts over Time Only</source>
        <translation>Kun tidsdiagrammer</translation>
    </message>
    <message>
        <source>XY Plot</source>
        <translation>XY-diagram</translation>
    </message>
    <message>
        <source>Frequency Response (Bode)</source>
        <translation>Frekvensrespons (Bode)</translation>
    </message>
    <message>
        <source>Runs over Each Other</source>
        <translation>Kørsler oven på hinanden</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n kørsel</numerusform>
            <numerusform>%n kørsler</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Fixes</name>
    <message>
        <source>Replace with {0}</source>
        <translation>Erstat med {0}</translation>
    </message>
    <message>
        <source>Insert {0}</source>
        <translation>Indsæt {0}</translation>
    </message>
    <message>
        <source>Did you mean {0}?</source>
        <translation>Mente du {0}?</translation>
    </message>
    <message>
        <source>Convert with {0}</source>
        <translation>Konverter med {0}</translation>
    </message>
    <message>
        <source>Move {0} to {1}</source>
        <translation>Flyt {0} til {1}</translation>
    </message>
    <message>
        <source>Add the property {0}</source>
        <translation>Tilføj egenskaben {0}</translation>
    </message>
    <message>
        <source>Add the method {0}</source>
        <translation>Tilføj metoden {0}</translation>
    </message>
    <message>
        <source>Add the missing branches</source>
        <translation>Tilføj de manglende grene</translation>
    </message>
    <message>
        <source>Add ELSE</source>
        <translation>Tilføj ELSE</translation>
    </message>
    <message>
        <source>Add () to call it</source>
        <translation>Tilføj () for at kalde den</translation>
    </message>
    <message>
        <source>Compare with 0</source>
        <translation>Sammenlign med 0</translation>
    </message>
    <message>
        <source>Remove the unused declaration</source>
        <translation>Fjern den ubrugte erklæring</translation>
    </message>
    <message>
        <source>Replace with IF and ELSIF</source>
        <translation>Erstat med IF og ELSIF</translation>
    </message>
    <message>
        <source>Change to a WSTRING literal</source>
        <translation>Skift til en WSTRING-literal</translation>
    </message>
    <message>
        <source>Replace with straight quotes</source>
        <translation>Erstat med lige anførselstegn</translation>
    </message>
    <message>
        <source>Make {0} the initial step</source>
        <translation>Gør {0} til starttrin</translation>
    </message>
    <message>
        <source>Dereference the pointer with ^</source>
        <translation>Dereferer pointeren med ^</translation>
    </message>
</context>
<context>
    <name>Hmi</name>
    <message>
        <source>as it is</source>
        <translation>som det er</translation>
    </message>
    <message>
        <source>none</source>
        <translation>(intet valgt)</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Andet…</translation>
    </message>
    <message>
        <source>A variable that is written</source>
        <translation>En variabel, der skrives</translation>
    </message>
    <message>
        <source>An ST expression</source>
        <translation>Et ST-udtryk</translation>
    </message>
    <message>
        <source>Shown to the operator. A typed text gets its key automatically; @key uses an existing one.</source>
        <translation>Vises til operatøren. Indtastet tekst får automatisk en nøgle; @nøgle bruger en, der findes.</translation>
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
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Højde</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.svg)</source>
        <translation>Billeder (*.png *.jpg *.svg)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Værdi</translation>
    </message>
    <message>
        <source>Unknown element</source>
        <translation>Ukendt element</translation>
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
        <translation>Linje</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Linjebredde</translation>
    </message>
    <message>
        <source>Line style</source>
        <translation>Linjetype</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Udfyldning</translation>
    </message>
    <message>
        <source>Fill level</source>
        <translation>Fyldniveau</translation>
    </message>
    <message>
        <source>Full at</source>
        <translation>Fuld ved</translation>
    </message>
    <message>
        <source>Level colour</source>
        <translation>Niveaufarve</translation>
    </message>
    <message>
        <source>Font size</source>
        <translation>Skriftstørrelse</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>Fed</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Justering</translation>
    </message>
    <message>
        <source>Text colour</source>
        <translation>Tekstfarve</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maksimum</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Enhed</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Limit low-low</source>
        <translation>Nederste grænseværdi (LL)</translation>
    </message>
    <message>
        <source>Limit low</source>
        <translation>Nedre grænseværdi (L)</translation>
    </message>
    <message>
        <source>Limit high</source>
        <translation>Øvre grænseværdi (H)</translation>
    </message>
    <message>
        <source>Limit high-high</source>
        <translation>Øverste grænseværdi (HH)</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Valgmuligheder</translation>
    </message>
    <message>
        <source>Text list</source>
        <translation>Tekstliste</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Størrelse</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Baggrund</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Betingelse</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Prioritet</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>Values in texts</source>
        <translation>Værdier i tekster</translation>
    </message>
    <message>
        <source>On delay in seconds</source>
        <translation>Tilforsinkelse i sekunder</translation>
    </message>
    <message>
        <source>Off delay in seconds</source>
        <translation>Fraforsinkelse i sekunder</translation>
    </message>
    <message>
        <source>Must be acknowledged</source>
        <translation>Kræver kvittering</translation>
    </message>
    <message>
        <source>Suppressed if</source>
        <translation>Undertrykt hvis</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farve</translation>
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
        <translation>Faneblad</translation>
    </message>
    <message>
        <source>Position and size</source>
        <translation>Position og størrelse</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Vinkel</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Låst</translation>
    </message>
    <message>
        <source>Visible if</source>
        <translation>Synlig hvis</translation>
    </message>
    <message>
        <source>Enabled if</source>
        <translation>Kan betjenes, hvis</translation>
    </message>
    <message>
        <source>Appearance by condition</source>
        <translation>Udseende efter betingelse</translation>
    </message>
    <message>
        <source>Move right by</source>
        <translation>Flyt til højre med</translation>
    </message>
    <message>
        <source>Move down by</source>
        <translation>Flyt ned med</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>Roter med</translation>
    </message>
    <message>
        <source>Fixed language</source>
        <translation>Fast sprog</translation>
    </message>
    <message>
        <source>If</source>
        <translation>Hvis</translation>
    </message>
    <message>
        <source>Blinks</source>
        <translation>Blinker</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Synlig</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>Kan betjenes</translation>
    </message>
    <message>
        <source>On if</source>
        <translation>Tændt hvis</translation>
    </message>
    <message>
        <source>Blinks if</source>
        <translation>Blinker hvis</translation>
    </message>
    <message>
        <source>Variable with [#] as index</source>
        <translation>Variabel med [#] som indeks</translation>
    </message>
    <message>
        <source>Editable</source>
        <translation>Kan redigeres</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Trappe</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkter</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Slut</translation>
    </message>
    <message>
        <source>Polyline</source>
        <translation>Polylinje</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rektangel</translation>
    </message>
    <message>
        <source>Rounded rectangle</source>
        <translation>Afrundet rektangel</translation>
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
        <translation>Bue</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Startvinkel</translation>
    </message>
    <message>
        <source>Span</source>
        <translation>Buevinkel</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Pipe</source>
        <translation>Rør</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tykkelse</translation>
    </message>
    <message>
        <source>Flow (sign gives the direction)</source>
        <translation>Flow (fortegnet giver retningen)</translation>
    </message>
    <message>
        <source>Flow colour</source>
        <translation>Flowfarve</translation>
    </message>
    <message>
        <source>Wraps</source>
        <translation>Tekstombrydning</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Billede</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Tilpas</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Symbol</translation>
    </message>
    <message>
        <source>Running if</source>
        <translation>Kører hvis</translation>
    </message>
    <message>
        <source>Warning if</source>
        <translation>Advarsel hvis</translation>
    </message>
    <message>
        <source>Fault if</source>
        <translation>Fejl hvis</translation>
    </message>
    <message>
        <source>Colour off</source>
        <translation>Farve (fra)</translation>
    </message>
    <message>
        <source>Colour running</source>
        <translation>Farve (kørende)</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Retning</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etiket</translation>
    </message>
    <message>
        <source>Button</source>
        <translation>Knap</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variabel</translation>
    </message>
    <message>
        <source>Value to write</source>
        <translation>Værdi at skrive</translation>
    </message>
    <message>
        <source>Go to panel</source>
        <translation>Gå til panel</translation>
    </message>
    <message>
        <source>Language tag</source>
        <translation>Sprogkode</translation>
    </message>
    <message>
        <source>Question to confirm</source>
        <translation>Bekræftelsesspørgsmål</translation>
    </message>
    <message>
        <source>Lit if</source>
        <translation>Lyser hvis</translation>
    </message>
    <message>
        <source>Colour lit</source>
        <translation>Farve (lysende)</translation>
    </message>
    <message>
        <source>Icon</source>
        <translation>Ikon</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Afbryder</translation>
    </message>
    <message>
        <source>Text on</source>
        <translation>Tekst (til)</translation>
    </message>
    <message>
        <source>Text off</source>
        <translation>Tekst (fra)</translation>
    </message>
    <message>
        <source>Colour on</source>
        <translation>Farve (til)</translation>
    </message>
    <message>
        <source>Rotary selector</source>
        <translation>Drejevælger</translation>
    </message>
    <message>
        <source>Check box</source>
        <translation>Afkrydsningsfelt</translation>
    </message>
    <message>
        <source>Radio group</source>
        <translation>Radiogruppe</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Kolonner</translation>
    </message>
    <message>
        <source>Combo box</source>
        <translation>Kombinationsfelt</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>Skyder</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Trin</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientering</translation>
    </message>
    <message>
        <source>Show the value</source>
        <translation>Vis værdien</translation>
    </message>
    <message>
        <source>Rotary knob</source>
        <translation>Drejeknap</translation>
    </message>
    <message>
        <source>Numeric entry</source>
        <translation>Talindtastning</translation>
    </message>
    <message>
        <source>Lowest value</source>
        <translation>Mindste værdi</translation>
    </message>
    <message>
        <source>Highest value</source>
        <translation>Største værdi</translation>
    </message>
    <message>
        <source>Title of the keypad</source>
        <translation>Tastaturets titel</translation>
    </message>
    <message>
        <source>Text entry</source>
        <translation>Tekstindtastning</translation>
    </message>
    <message>
        <source>Longest text</source>
        <translation>Længste tekst</translation>
    </message>
    <message>
        <source>Masked entry</source>
        <translation>Maskeret indtastning</translation>
    </message>
    <message>
        <source>Mask (# digit, A letter, * any)</source>
        <translation>Maske (# ciffer, A bogstav, * vilkårlig)</translation>
    </message>
    <message>
        <source>Hide the value</source>
        <translation>Skjul værdien</translation>
    </message>
    <message>
        <source>Numeric display</source>
        <translation>Talvisning</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Ramme</translation>
    </message>
    <message>
        <source>Date and time</source>
        <translation>Dato og klokkeslæt</translation>
    </message>
    <message>
        <source>Value (empty: the controller&apos;s clock)</source>
        <translation>Værdi (tom: styringens ur)</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>Visning</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunder</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>Blinks when on</source>
        <translation>Blinker, når den er tændt</translation>
    </message>
    <message>
        <source>Multi-state indicator</source>
        <translation>Flertilstandsindikator</translation>
    </message>
    <message>
        <source>States</source>
        <translation>Tilstande</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>Bjælkevisning</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Setpunkt</translation>
    </message>
    <message>
        <source>Tank level</source>
        <translation>Tankniveau</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>Viserinstrument</translation>
    </message>
    <message>
        <source>Span of the scale</source>
        <translation>Skalaens vinkel</translation>
    </message>
    <message>
        <source>Divisions</source>
        <translation>Skalainddeling</translation>
    </message>
    <message>
        <source>7-segment display</source>
        <translation>7-segmentdisplay</translation>
    </message>
    <message>
        <source>Digits</source>
        <translation>Cifre</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>Decimaler</translation>
    </message>
    <message>
        <source>Leading zeros</source>
        <translation>Foranstillede nuller</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fremdrift</translation>
    </message>
    <message>
        <source>Light tower</source>
        <translation>Lystårn</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Lys</translation>
    </message>
    <message>
        <source>Siren if</source>
        <translation>Sirene hvis</translation>
    </message>
    <message>
        <source>Float switch</source>
        <translation>Svømmerafbryder</translation>
    </message>
    <message>
        <source>Raised if</source>
        <translation>Løftet hvis</translation>
    </message>
    <message>
        <source>Colour raised</source>
        <translation>Farve (løftet)</translation>
    </message>
    <message>
        <source>Colour hanging</source>
        <translation>Farve (hængende)</translation>
    </message>
    <message>
        <source>Cell grid</source>
        <translation>Cellegitter</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Array</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Rækker</translation>
    </message>
    <message>
        <source>Variable of a cell with [#]</source>
        <translation>Variabel for en celle med [#]</translation>
    </message>
    <message>
        <source>On press</source>
        <translation>Ved tryk</translation>
    </message>
    <message>
        <source>First index</source>
        <translation>Første indeks</translation>
    </message>
    <message>
        <source>Show the numbers</source>
        <translation>Vis numre</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabel</translation>
    </message>
    <message>
        <source>Index of the selected row</source>
        <translation>Indeks for den valgte række</translation>
    </message>
    <message>
        <source>Bar chart</source>
        <translation>Søjlediagram</translation>
    </message>
    <message>
        <source>Text list of the bars</source>
        <translation>Søjlernes tekstliste</translation>
    </message>
    <message>
        <source>XY chart</source>
        <translation>XY-diagram</translation>
    </message>
    <message>
        <source>Array of x</source>
        <translation>Array med x-værdier</translation>
    </message>
    <message>
        <source>Array of y</source>
        <translation>Array med y-værdier</translation>
    </message>
    <message>
        <source>Operating point x</source>
        <translation>Arbejdspunkt x</translation>
    </message>
    <message>
        <source>Operating point y</source>
        <translation>Arbejdspunkt y</translation>
    </message>
    <message>
        <source>X from</source>
        <translation>X fra</translation>
    </message>
    <message>
        <source>X to</source>
        <translation>X til</translation>
    </message>
    <message>
        <source>Y from</source>
        <translation>Y fra</translation>
    </message>
    <message>
        <source>Y to</source>
        <translation>Y til</translation>
    </message>
    <message>
        <source>Title of x</source>
        <translation>x-aksens titel</translation>
    </message>
    <message>
        <source>Title of y</source>
        <translation>y-aksens titel</translation>
    </message>
    <message>
        <source>Trend chart</source>
        <translation>Trenddiagram</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurver</translation>
    </message>
    <message>
        <source>Time span in seconds</source>
        <translation>Tidsrum i sekunder</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Fra</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Til</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Signaturforklaring</translation>
    </message>
    <message>
        <source>Alarm list</source>
        <translation>Alarmliste</translation>
    </message>
    <message>
        <source>Only these classes</source>
        <translation>Kun disse klasser</translation>
    </message>
    <message>
        <source>Sorted by</source>
        <translation>Sorteret efter</translation>
    </message>
    <message>
        <source>Acknowledge buttons</source>
        <translation>Kvitteringsknapper</translation>
    </message>
    <message>
        <source>Alarm banner</source>
        <translation>Alarmbanner</translation>
    </message>
    <message>
        <source>Language selector</source>
        <translation>Sprogvælger</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Navne</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Faneblade</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Sider</translation>
    </message>
    <message>
        <source>Index of the page</source>
        <translation>Sidens indeks</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Former</translation>
    </message>
    <message>
        <source>Text and pictures</source>
        <translation>Tekst og billeder</translation>
    </message>
    <message>
        <source>Symbols</source>
        <translation>Symboler</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Betjeningselementer</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Visningselementer</translation>
    </message>
    <message>
        <source>Arrays and charts</source>
        <translation>Arrays og diagrammer</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmer</translation>
    </message>
    <message>
        <source>Containers</source>
        <translation>Containere</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometri</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Udseende</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Opførsel</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bevægelse</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parametre</translation>
    </message>
    <message>
        <source>Type (a block, a structure, BOOL, REAL, text)</source>
        <translation>Type (en blok, en struktur, BOOL, REAL, text)</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Faceplate</source>
        <translation>Faceplate</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Argumenter</translation>
    </message>
    <message>
        <source>Adapts to the screen by</source>
        <translation>Tilpasser sig skærmen ved</translation>
    </message>
    <message>
        <source>On a tall screen</source>
        <translation>På en høj skærm</translation>
    </message>
    <message>
        <source>Shown in the frame</source>
        <translation>Vises i rammen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hjælp</translation>
    </message>
    <message>
        <source>Panel to show</source>
        <translation>Panel, der vises</translation>
    </message>
    <message>
        <source>First-out group</source>
        <translation>Førstalarmgruppe</translation>
    </message>
    <message>
        <source>Horizontal anchor</source>
        <translation>Vandret anker</translation>
    </message>
    <message>
        <source>Vertical anchor</source>
        <translation>Lodret anker</translation>
    </message>
    <message>
        <source>Only for the roles</source>
        <translation>Kun for rollerne</translation>
    </message>
    <message>
        <source>For all others</source>
        <translation>For alle andre</translation>
    </message>
    <message>
        <source>Writes are confirmed</source>
        <translation>Skrivning bekræftes</translation>
    </message>
    <message>
        <source>Navigation bar</source>
        <translation>Navigationslinje</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Paneler</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Bruger</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Recept</translation>
    </message>
    <message>
        <source>Alarm statistics</source>
        <translation>Alarmstatistik</translation>
    </message>
    <message>
        <source>Hours to look back</source>
        <translation>Timer tilbage i tiden</translation>
    </message>
    <message>
        <source>Panel area</source>
        <translation>Panelområde</translation>
    </message>
    <message>
        <source>Share of the remaining space</source>
        <translation>Andel af den resterende plads</translation>
    </message>
    <message>
        <source>Column span in a grid</source>
        <translation>Antal kolonner i et gitter</translation>
    </message>
    <message>
        <source>Closed if</source>
        <translation>Lukket hvis</translation>
    </message>
    <message>
        <source>In transit if</source>
        <translation>Undervejs hvis</translation>
    </message>
    <message>
        <source>In manual mode if</source>
        <translation>Manuel hvis</translation>
    </message>
    <message>
        <source>Out of service if</source>
        <translation>Ude af drift hvis</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Layout</translation>
    </message>
    <message>
        <source>Columns (0: as many as fit)</source>
        <translation>Kolonner (0: så mange der er plads til)</translation>
    </message>
    <message>
        <source>Smallest column</source>
        <translation>Mindste kolonnebredde</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Afstand</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>Cross-axis alignment</source>
        <translation>Justering på tværs</translation>
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
        <translation>Prik</translation>
    </message>
    <message>
        <source>Start sign</source>
        <translation>Startsymbol</translation>
    </message>
    <message>
        <source>Stop sign</source>
        <translation>Stopsymbol</translation>
    </message>
    <message>
        <source>Pause sign</source>
        <translation>Pausesymbol</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>Plustegn</translation>
    </message>
    <message>
        <source>Minus</source>
        <translation>Minustegn</translation>
    </message>
    <message>
        <source>House</source>
        <translation>Hus</translation>
    </message>
    <message>
        <source>Circular arrow</source>
        <translation>Cirkelpil</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Klokkeslæt</translation>
    </message>
    <message>
        <source>By time</source>
        <translation>Efter tid</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Fuldt optrukket</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Stiplet</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Prikket</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>I starten</translation>
    </message>
    <message>
        <source>Centred</source>
        <translation>Centreret</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>I slutningen</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lyst</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Mørkt</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Høj kontrast</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Pil</translation>
    </message>
    <message>
        <source>Arc line</source>
        <translation>Buelinje</translation>
    </message>
    <message>
        <source>Pie</source>
        <translation>Cirkeludsnit</translation>
    </message>
    <message>
        <source>Chord</source>
        <translation>Cirkelafsnit</translation>
    </message>
    <message>
        <source>Show all of it</source>
        <translation>Vis hele billedet</translation>
    </message>
    <message>
        <source>Fill the frame</source>
        <translation>Udfyld rammen</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Stræk</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Højre</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Venstre</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Op</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ned</translation>
    </message>
    <message>
        <source>Momentary</source>
        <translation>Momentan</translation>
    </message>
    <message>
        <source>Toggle</source>
        <translation>Skift</translation>
    </message>
    <message>
        <source>Set to TRUE</source>
        <translation>Sæt til TRUE</translation>
    </message>
    <message>
        <source>Set to FALSE</source>
        <translation>Sæt til FALSE</translation>
    </message>
    <message>
        <source>Write a value</source>
        <translation>Skriv en værdi</translation>
    </message>
    <message>
        <source>Go to a panel</source>
        <translation>Gå til et panel</translation>
    </message>
    <message>
        <source>Change the language</source>
        <translation>Skift sprog</translation>
    </message>
    <message>
        <source>Acknowledge alarms</source>
        <translation>Kvitter alarmer</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Vandret</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Lodret</translation>
    </message>
    <message>
        <source>Date and time of day</source>
        <translation>Dato og klokkeslæt</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Dato</translation>
    </message>
    <message>
        <source>Calendar week</source>
        <translation>Kalenderuge</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Kvadratisk</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Afrundet</translation>
    </message>
    <message>
        <source>Dished ends</source>
        <translation>Hvælvede bunde</translation>
    </message>
    <message>
        <source>Flat ends</source>
        <translation>Flade bunde</translation>
    </message>
    <message>
        <source>Hopper</source>
        <translation>Tragt</translation>
    </message>
    <message>
        <source>Open at the top</source>
        <translation>Åben foroven</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Vælg</translation>
    </message>
    <message>
        <source>Present alarms</source>
        <translation>Aktuelle alarmer</translation>
    </message>
    <message>
        <source>Alarm history</source>
        <translation>Alarmhistorik</translation>
    </message>
    <message>
        <source>By priority</source>
        <translation>Efter prioritet</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Knapper</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>In their own language</source>
        <translation>På deres eget sprog</translation>
    </message>
    <message>
        <source>Language tags</source>
        <translation>Sprogkoder</translation>
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
        <translation>Tank</translation>
    </message>
    <message>
        <source>Silo</source>
        <translation>Silo</translation>
    </message>
    <message>
        <source>Conveyor</source>
        <translation>Transportbånd</translation>
    </message>
    <message>
        <source>Agitator</source>
        <translation>Omrører</translation>
    </message>
    <message>
        <source>Heater</source>
        <translation>Varmelegeme</translation>
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
        <translation>Lastbil</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>Køretøj</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Baggrund</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Flade</translation>
    </message>
    <message>
        <source>Raised surface</source>
        <translation>Hævet flade</translation>
    </message>
    <message>
        <source>Sunken surface</source>
        <translation>Forsænket flade</translation>
    </message>
    <message>
        <source>Line colour</source>
        <translation>Linjefarve</translation>
    </message>
    <message>
        <source>Faint line</source>
        <translation>Svag linje</translation>
    </message>
    <message>
        <source>Text colour</source>
        <translation>Tekstfarve</translation>
    </message>
    <message>
        <source>Muted text</source>
        <translation>Dæmpet tekst</translation>
    </message>
    <message>
        <source>Button colour</source>
        <translation>Knapfarve</translation>
    </message>
    <message>
        <source>Accent</source>
        <translation>Fremhævning</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Slukket</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>I drift</translation>
    </message>
    <message>
        <source>Liquid</source>
        <translation>Væske</translation>
    </message>
    <message>
        <source>Pipe colour</source>
        <translation>Rørfarve</translation>
    </message>
    <message>
        <source>Measured value</source>
        <translation>Måleværdi</translation>
    </message>
    <message>
        <source>Lit segment</source>
        <translation>Lysende segment</translation>
    </message>
    <message>
        <source>Display glass</source>
        <translation>Displayglas</translation>
    </message>
    <message>
        <source>Alarm colour</source>
        <translation>Alarmfarve</translation>
    </message>
    <message>
        <source>High priority</source>
        <translation>Høj prioritet</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Advarsel</translation>
    </message>
    <message>
        <source>Low priority</source>
        <translation>Lav prioritet</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rød</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gul</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grøn</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blå</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Hvid</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Sort</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grå</translation>
    </message>
    <message>
        <source>Good state</source>
        <translation>God tilstand</translation>
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
        <translation>et tal</translation>
    </message>
    <message>
        <source>a BOOL</source>
        <translation>en BOOL</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>en tekst</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>et array</translation>
    </message>
    <message>
        <source>any type</source>
        <translation>enhver type</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Venstre og højre</translation>
    </message>
    <message>
        <source>Top and bottom</source>
        <translation>Øverst og nederst</translation>
    </message>
    <message>
        <source>Scaling to its size</source>
        <translation>Skalering til dens størrelse</translation>
    </message>
    <message>
        <source>Moving what is anchored</source>
        <translation>Flytning af det forankrede</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Bevar proportionerne</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Øverst</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Nederst</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Låst</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Skjult</translation>
    </message>
    <message>
        <source>Open a panel in a window</source>
        <translation>Åbn et panel i et vindue</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Luk vinduet</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Gå tilbage</translation>
    </message>
    <message>
        <source>Go to the start panel</source>
        <translation>Gå til startpanelet</translation>
    </message>
    <message>
        <source>Log out</source>
        <translation>Log ud</translation>
    </message>
    <message>
        <source>Shelved alarms</source>
        <translation>Udsatte alarmer</translation>
    </message>
    <message>
        <source>Compressor</source>
        <translation>Kompressor</translation>
    </message>
    <message>
        <source>Heat exchanger</source>
        <translation>Varmeveksler</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Centrifuge</source>
        <translation>Centrifuge</translation>
    </message>
    <message>
        <source>Control valve</source>
        <translation>Reguleringsventil</translation>
    </message>
    <message>
        <source>Three-way valve</source>
        <translation>Trevejsventil</translation>
    </message>
    <message>
        <source>Boiler</source>
        <translation>Kedel</translation>
    </message>
    <message>
        <source>Cooling tower</source>
        <translation>Køletårn</translation>
    </message>
    <message>
        <source>Filler</source>
        <translation>Fyldemaskine</translation>
    </message>
    <message>
        <source>Carton</source>
        <translation>Karton</translation>
    </message>
    <message>
        <source>Pallet</source>
        <translation>Palle</translation>
    </message>
    <message>
        <source>Roller conveyor</source>
        <translation>Rullebane</translation>
    </message>
    <message>
        <source>Bucket elevator</source>
        <translation>Kopelevator</translation>
    </message>
    <message>
        <source>Screw conveyor</source>
        <translation>Snegletransportør</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drejebord</translation>
    </message>
    <message>
        <source>Gantry</source>
        <translation>Portal</translation>
    </message>
    <message>
        <source>SCARA robot</source>
        <translation>SCARA-robot</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Griber</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>Dør</translation>
    </message>
    <message>
        <source>Damper</source>
        <translation>Spjæld</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Bygning</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Fri</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Række</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Kolonne</translation>
    </message>
    <message>
        <source>Row if wide, column if tall</source>
        <translation>Række i bredformat, kolonne i højformat</translation>
    </message>
    <message>
        <source>Filling it</source>
        <translation>Udfyldende</translation>
    </message>
    <message>
        <source>Change the theme</source>
        <translation>Skift tema</translation>
    </message>
    <message>
        <source>Light bulb</source>
        <translation>Elpære</translation>
    </message>
</context>
<context>
    <name>Inside</name>
    <message>
        <source>set by {0}  {1} ({2}, task {3})</source>
        <translation>sat af {0}  {1} ({2}, task {3})</translation>
    </message>
    <message>
        <source>set by {0}  {1} ({2})</source>
        <translation>sat af {0}  {1} ({2})</translation>
    </message>
    <message>
        <source>set by code that the compiler adds ({0})</source>
        <translation>sat af kode, som compileren tilføjer ({0})</translation>
    </message>
    <message>
        <source>written from outside</source>
        <translation>skrevet udefra</translation>
    </message>
    <message>
        <source>written from {0}</source>
        <translation>skrevet fra {0}</translation>
    </message>
    <message>
        <source>forced</source>
        <translation>forceret</translation>
    </message>
    <message>
        <source>forced from {0}</source>
        <translation>forceret fra {0}</translation>
    </message>
    <message>
        <source>put back by a reset</source>
        <translation>sat tilbage af en nulstilling</translation>
    </message>
    <message>
        <source>carried over by an online change</source>
        <translation>overført ved en onlineændring</translation>
    </message>
    <message>
        <source>restored from the retained values</source>
        <translation>gendannet fra de remanente værdier</translation>
    </message>
    <message>
        <source>its initial value</source>
        <translation>dens startværdi</translation>
    </message>
    <message>
        <source>put into the safe state when the controller stopped</source>
        <translation>sat i sikker tilstand, da styringen stoppede</translation>
    </message>
    <message>
        <source>as recorded in the scan that was resumed from</source>
        <translation>som optaget i det scan, der blev fortsat fra</translation>
    </message>
    <message>
        <source>set by a statement of a test</source>
        <translation>sat af en sætning i en test</translation>
    </message>
    <message>
        <source>origin not known</source>
        <translation>oprindelse ukendt</translation>
    </message>
    <message>
        <source>the command line</source>
        <translation>kommandolinjen</translation>
    </message>
    <message>
        <source>the studio</source>
        <translation>studiet</translation>
    </message>
    <message>
        <source>panel {0}, {1}</source>
        <translation>panel {0}, {1}</translation>
    </message>
    <message>
        <source>{0} (scan {1})</source>
        <translation>{0} (scan {1})</translation>
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
        <translation>{0}  {1} fra {2} til {3}, {4}</translation>
    </message>
    <message>
        <source>{0}  {1} to {2}, {3}</source>
        <translation>{0}  {1} til {2}, {3}</translation>
    </message>
    <message>
        <source>called by {0}  {1}</source>
        <translation>kaldt af {0}  {1}</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}, since {3}.</source>
        <translation>{0} er {1} ved {2}, siden {3}.</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}, as it was when the recording began.</source>
        <translation>{0} er {1} ved {2}, som da optagelsen begyndte.</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}.</source>
        <translation>{0} er {1} ved {2}.</translation>
    </message>
    <message>
        <source>It was {0}.</source>
        <translation>Værdien blev {0}.</translation>
    </message>
    <message>
        <source>It has its initial value.</source>
        <translation>Variablen har sin startværdi.</translation>
    </message>
    <message>
        <source>It became {0} because</source>
        <translation>Den blev {0}, fordi</translation>
    </message>
    <message>
        <source>This needed</source>
        <translation>Det krævede</translation>
    </message>
    <message>
        <source>It needs</source>
        <translation>Det kræver</translation>
    </message>
    <message>
        <source>It stays so because</source>
        <translation>Den forbliver sådan, fordi</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Trin for trin</translation>
    </message>
    <message>
        <source>because</source>
        <translation>fordi</translation>
    </message>
    <message>
        <source>time passed.</source>
        <translation>tiden gik.</translation>
    </message>
    <message>
        <source>it was the first scan.</source>
        <translation>det var det første scan.</translation>
    </message>
    <message>
        <source>other variables were forced.</source>
        <translation>andre variabler var forceret.</translation>
    </message>
    <message>
        <source>{0} became {1}.</source>
        <translation>{0} blev {1}.</translation>
    </message>
    <message>
        <source>{0} became {1}, {2}.</source>
        <translation>{0} blev {1}, {2}.</translation>
    </message>
    <message>
        <source>{0} changed.</source>
        <translation>{0} ændrede sig.</translation>
    </message>
    <message>
        <source>{0} changed, {1}.</source>
        <translation>{0} ændrede sig, {1}.</translation>
    </message>
    <message>
        <source>{0} was {1}.</source>
        <translation>{0} var {1}.</translation>
    </message>
    <message>
        <source>{0} was {1} since {2}, {3}.</source>
        <translation>{0} var {1} siden {2}, {3}.</translation>
    </message>
    <message>
        <source>{0}   → {1}</source>
        <translation>{0}   → {1}</translation>
    </message>
    <message>
        <source>it ran because {0} was {1}</source>
        <translation>udført, fordi {0} var {1}</translation>
    </message>
    <message>
        <source>nothing wrote it later because {0} was {1}</source>
        <translation>ikke skrevet senere, fordi {0} var {1}</translation>
    </message>
    <message>
        <source>a statement that would write it did not run because {0} was {1}</source>
        <translation>en sætning, der ville skrive den, blev ikke udført, fordi {0} var {1}</translation>
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
        <translation>{0} var {1}, da scannet begyndte</translation>
    </message>
    <message>
        <source>{0}   {1}</source>
        <translation>{0}   {1}</translation>
    </message>
    <message>
        <source>its time of {0} has elapsed</source>
        <translation>dens tid på {0} er gået</translation>
    </message>
    <message>
        <source>it does not run</source>
        <translation>kører ikke</translation>
    </message>
    <message>
        <source>it has run {0} of {1}, {2} to go</source>
        <translation>{0} af {1} er gået, {2} mangler</translation>
    </message>
    <message>
        <source>it has counted {0} of {1}</source>
        <translation>har talt {0} af {1}</translation>
    </message>
    <message>
        <source>No change of up to three variables makes it {0} in this scan.</source>
        <translation>Ingen ændring af op til tre variabler gør den {0} i dette scan.</translation>
    </message>
    <message>
        <source>It would be {0} if {1}.</source>
        <translation>Den ville være {0}, hvis {1}.</translation>
    </message>
    <message>
        <source>It would also be {0} if {1}.</source>
        <translation>Den ville også være {0}, hvis {1}.</translation>
    </message>
    <message>
        <source>{0} were {1} (it is {2})</source>
        <translation>{0} var {1} (er {2})</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} og {1}</translation>
    </message>
    <message>
        <source>What keeps it {0}</source>
        <translation>Hvad der holder den {0}</translation>
    </message>
    <message>
        <source>Note: {0}.</source>
        <translation>Bemærk: {0}.</translation>
    </message>
    <message>
        <source>recorded by an earlier version, which kept no journal</source>
        <translation>optaget af en ældre version, som ikke førte journal</translation>
    </message>
    <message>
        <source>it was written to while it was halted at a breakpoint</source>
        <translation>der blev skrevet, mens det var standset ved et stoppunkt</translation>
    </message>
    <message>
        <source>the scan did more than can be kept: only its beginning is known</source>
        <translation>scannet gjorde mere, end der kan gemmes: kun dets begyndelse er kendt</translation>
    </message>
    <message>
        <source>the scan had a different result when it was run again</source>
        <translation>scannet gav et andet resultat, da det blev kørt igen</translation>
    </message>
    <message>
        <source>it has no value in this scan: {0}</source>
        <translation>ingen værdi i dette scan: {0}</translation>
    </message>
    <message>
        <source>&quot;Why not?&quot; needs a condition (BOOL), for example &quot;Main.level &gt; 80&quot;</source>
        <translation>”Hvorfor ikke?” kræver en betingelse (BOOL), for eksempel ”Main.level &gt; 80”</translation>
    </message>
    <message>
        <source>the program was not built from sources; open its project</source>
        <translation>programmet blev ikke oversat fra kildetekster; åbn dets projekt</translation>
    </message>
    <message>
        <source>this scan is not in the recording</source>
        <translation>dette scan er ikke i optagelsen</translation>
    </message>
    <message>
        <source>it does not change in this recording</source>
        <translation>ændrer sig ikke i denne optagelse</translation>
    </message>
    <message>
        <source>nothing wrote it in this scan</source>
        <translation>intet skrev den i dette scan</translation>
    </message>
    <message>
        <source>no statement of the project ran in this scan</source>
        <translation>ingen sætning i projektet blev udført i dette scan</translation>
    </message>
    <message>
        <source>never {0}</source>
        <translation>aldrig {0}</translation>
    </message>
    <message>
        <source>missing: {0}</source>
        <translation>mangler: {0}</translation>
    </message>
    <message>
        <source>not run</source>
        <translation>ikke udført</translation>
    </message>
    <message>
        <source>run {0} {0:time|times}</source>
        <translation>udført {0} {0:gang|gange}</translation>
    </message>
</context>
<context>
    <name>LongTask</name>
    <message>
        <source>Cancel</source>
        <translation>Annuller</translation>
    </message>
</context>
<context>
    <name>Loops</name>
    <message>
        <source>The program has no controller block; name the signals with --input and --output</source>
        <translation>Programmet har ingen regulatorblok; angiv signalerne med --input og --output</translation>
    </message>
    <message>
        <source>There is no loop {0}; the program has {1}</source>
        <translation>Der er ingen sløjfe {0}; programmet har {1}</translation>
    </message>
    <message>
        <source>{0} is the name of several loops; give the whole name of one: {1}</source>
        <translation>{0} er navnet på flere sløjfer; angiv hele navnet på en af dem: {1}</translation>
    </message>
    <message>
        <source>The recording contains no program that knows it; choose a loop of the open program</source>
        <translation>Optagelsen indeholder intet program, der kender den; vælg en sløjfe i det åbne program</translation>
    </message>
    <message>
        <source>It is not a number and cannot be a signal of a loop; name a variable of type REAL or INT</source>
        <translation>Det er ikke et tal og kan ikke være et signal i en sløjfe; angiv en variabel af typen REAL eller INT</translation>
    </message>
    <message>
        <source>This range is no longer recorded, or the program was changed in it; choose another one</source>
        <translation>Dette område er ikke længere optaget, eller programmet blev ændret i det; vælg et andet</translation>
    </message>
    <message>
        <source>{0} gets an expression in the call; give the measured value a variable of its own to try settings</source>
        <translation>{0} får et udtryk i kaldet; giv måleværdien sin egen variabel for at prøve indstillinger</translation>
    </message>
    <message>
        <source>The call has constants; settings in their place can only be tried on the recording of the running controller</source>
        <translation>Kaldet har konstanter; andre indstillinger i deres sted kan kun prøves på optagelsen fra den kørende styring</translation>
    </message>
</context>
<context>
    <name>MarkText</name>
    <message>
        <source>Started</source>
        <translation>Startet</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Stoppet</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>På pause</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fejl</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Nulstillet</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Skrevet</translation>
    </message>
    <message>
        <source>Forced</source>
        <translation>Forceret</translation>
    </message>
    <message>
        <source>All forces released</source>
        <translation>Al forcering ophævet</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Forcering ophævet</translation>
    </message>
    <message>
        <source>Online change</source>
        <translation>Onlineændring</translation>
    </message>
    <message>
        <source>Breakpoint</source>
        <translation>Stoppunkt</translation>
    </message>
    <message>
        <source>Retained values saved</source>
        <translation>Remanente værdier gemt</translation>
    </message>
    <message>
        <source>Retained values restored</source>
        <translation>Remanente værdier gendannet</translation>
    </message>
    <message numerus="yes">
        <source>%n scan(s) skipped: the machine was late</source>
        <translation>
            <numerusform>%n scan sprunget over: maskinen var forsinket</numerusform>
            <numerusform>%n scan sprunget over: maskinen var forsinket</numerusform>
        </translation>
    </message>
    <message>
        <source>Resumed from this scan</source>
        <translation>Fortsat fra dette scan</translation>
    </message>
</context>
<context>
    <name>Notes</name>
    <message>
        <source>first declared here</source>
        <translation>først erklæret her</translation>
    </message>
    <message>
        <source>declared here</source>
        <translation>erklæret her</translation>
    </message>
    <message>
        <source>the variable</source>
        <translation>variablen</translation>
    </message>
    <message>
        <source>the first program</source>
        <translation>det første program</translation>
    </message>
    <message>
        <source>overridden here</source>
        <translation>tilsidesat her</translation>
    </message>
    <message>
        <source>the first one</source>
        <translation>den første</translation>
    </message>
    <message>
        <source>by this transition, while it is active</source>
        <translation>ved denne transition, mens det er aktivt</translation>
    </message>
    <message>
        <source>comments nest: the next *) closes the one that begins here</source>
        <translation>kommentarer kan indlejres: det næste *) lukker den, der begynder her</translation>
    </message>
</context>
<context>
    <name>Phrases</name>
    <message>
        <source>a name</source>
        <translation>et navn</translation>
    </message>
    <message>
        <source>a label</source>
        <translation>en etiket</translation>
    </message>
    <message>
        <source>an operand</source>
        <translation>en operand</translation>
    </message>
    <message>
        <source>an expression</source>
        <translation>et udtryk</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>en værdi</translation>
    </message>
    <message>
        <source>a type</source>
        <translation>en type</translation>
    </message>
    <message>
        <source>an index</source>
        <translation>et indeks</translation>
    </message>
    <message>
        <source>an argument</source>
        <translation>et argument</translation>
    </message>
    <message>
        <source>an address</source>
        <translation>en adresse</translation>
    </message>
    <message>
        <source>an action</source>
        <translation>en aktion</translation>
    </message>
    <message>
        <source>a CASE label</source>
        <translation>en CASE-etiket</translation>
    </message>
    <message>
        <source>a block&apos;s name</source>
        <translation>navnet på en funktionsblok</translation>
    </message>
    <message>
        <source>a processor&apos;s name</source>
        <translation>navnet på en processor</translation>
    </message>
    <message>
        <source>a task&apos;s name</source>
        <translation>navnet på en task</translation>
    </message>
    <message>
        <source>a program instance&apos;s name</source>
        <translation>navnet på en programinstans</translation>
    </message>
    <message>
        <source>an input or output</source>
        <translation>en ind- eller udgang</translation>
    </message>
    <message>
        <source>a variable&apos;s name</source>
        <translation>navnet på en variabel</translation>
    </message>
    <message>
        <source>a variable&apos;s path</source>
        <translation>stien til en variabel</translation>
    </message>
    <message>
        <source>a step&apos;s name</source>
        <translation>navnet på et trin</translation>
    </message>
    <message>
        <source>a type&apos;s name</source>
        <translation>navnet på en type</translation>
    </message>
    <message>
        <source>a member&apos;s name</source>
        <translation>navnet på et medlem</translation>
    </message>
    <message>
        <source>an access name</source>
        <translation>et adgangsnavn</translation>
    </message>
    <message>
        <source>an enumeration value</source>
        <translation>en enumerationsværdi</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>linjens slutning</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>filens slutning</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} eller {1}</translation>
    </message>
    <message>
        <source>FOR and a time</source>
        <translation>FOR og en tid</translation>
    </message>
    <message>
        <source>:= or instructions</source>
        <translation>:= eller instruktioner</translation>
    </message>
    <message>
        <source>a subrange</source>
        <translation>et delområde</translation>
    </message>
    <message>
        <source>an enumeration</source>
        <translation>en enumeration</translation>
    </message>
    <message>
        <source>in parentheses</source>
        <translation>i parentes</translation>
    </message>
    <message>
        <source>a chart</source>
        <translation>et SFC-diagram</translation>
    </message>
    <message>
        <source>a body</source>
        <translation>en krop</translation>
    </message>
    <message>
        <source>in a CLASS</source>
        <translation>i en CLASS</translation>
    </message>
    <message>
        <source>in a FUNCTION</source>
        <translation>i en FUNCTION</translation>
    </message>
    <message>
        <source>in a METHOD</source>
        <translation>i en METHOD</translation>
    </message>
    <message>
        <source>in a PROGRAM</source>
        <translation>i et PROGRAM</translation>
    </message>
    <message>
        <source>in a FUNCTION_BLOCK</source>
        <translation>i en FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>here</source>
        <translation>her</translation>
    </message>
    <message>
        <source>{0} {0:character|characters}</source>
        <translation>{0} tegn</translation>
    </message>
    <message>
        <source>{0} {0:byte|bytes} in UTF-8</source>
        <translation>{0} byte i UTF-8</translation>
    </message>
    <message>
        <source>in {0}</source>
        <translation>i {0}</translation>
    </message>
    <message>
        <source>in an expression</source>
        <translation>i et udtryk</translation>
    </message>
    <message>
        <source>in an initial value</source>
        <translation>i en startværdi</translation>
    </message>
    <message>
        <source>in this section</source>
        <translation>i dette afsnit</translation>
    </message>
    <message>
        <source>an initial value</source>
        <translation>en startværdi</translation>
    </message>
    <message>
        <source>RETURN with a value</source>
        <translation>RETURN med en værdi</translation>
    </message>
    <message>
        <source>in a declaration that calls FB_Init</source>
        <translation>i en erklæring, der kalder FB_Init</translation>
    </message>
    <message>
        <source>{0} (VAR_IN_OUT)</source>
        <translation>{0} (VAR_IN_OUT)</translation>
    </message>
    <message>
        <source>in {0}, which is not abstract itself</source>
        <translation>i {0}, som ikke selv er abstrakt</translation>
    </message>
    <message>
        <source>address</source>
        <translation>adresse</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>tidsrum</translation>
    </message>
    <message>
        <source>date</source>
        <translation>dato</translation>
    </message>
    <message>
        <source>time of day</source>
        <translation>klokkeslæt</translation>
    </message>
    <message>
        <source>date and time</source>
        <translation>dato og klokkeslæt</translation>
    </message>
    <message>
        <source>integer</source>
        <translation>heltal</translation>
    </message>
    <message>
        <source>string</source>
        <translation>streng</translation>
    </message>
    <message>
        <source>{0} (a constant)</source>
        <translation>{0} (en konstant)</translation>
    </message>
    <message>
        <source>{0} (an output)</source>
        <translation>{0} (en udgang)</translation>
    </message>
    <message>
        <source>{0} (a local variable of {1})</source>
        <translation>{0} (en lokal variabel i {1})</translation>
    </message>
    <message>
        <source>{0} (an input)</source>
        <translation>{0} (en indgang)</translation>
    </message>
    <message>
        <source>{0} (an input; the next scan overwrites it)</source>
        <translation>{0} (en indgang; næste scan overskriver den)</translation>
    </message>
    <message>
        <source>{0} (a property without SET)</source>
        <translation>{0} (en egenskab uden SET)</translation>
    </message>
    <message>
        <source>{0} (no instance, or several)</source>
        <translation>{0} (ingen instans eller flere)</translation>
    </message>
    <message>
        <source>{0} (a type; declare an instance of it)</source>
        <translation>{0} (en type; erklær en instans af den)</translation>
    </message>
    <message>
        <source>{0} (a variable, which hides the function of this name)</source>
        <translation>{0} (en variabel, som skjuler funktionen af dette navn)</translation>
    </message>
    <message>
        <source>an output</source>
        <translation>en udgang</translation>
    </message>
    <message>
        <source>an input</source>
        <translation>en indgang</translation>
    </message>
    <message>
        <source>an IN_OUT parameter</source>
        <translation>en IN_OUT-parameter</translation>
    </message>
    <message>
        <source>a power of a computed number</source>
        <translation>en potens af et beregnet tal</translation>
    </message>
    <message>
        <source>a call of {0}</source>
        <translation>et kald af {0}</translation>
    </message>
    <message>
        <source>a call without arguments</source>
        <translation>et kald uden argumenter</translation>
    </message>
    <message>
        <source>a computed second argument of {0}</source>
        <translation>et beregnet andet argument til {0}</translation>
    </message>
    <message>
        <source>{0} outside a loop</source>
        <translation>{0} uden for en løkke</translation>
    </message>
    <message>
        <source>this statement</source>
        <translation>denne sætning</translation>
    </message>
    <message>
        <source>FOR with this end or step</source>
        <translation>FOR med denne slutning eller dette skridt</translation>
    </message>
    <message>
        <source>an assignment of several variables</source>
        <translation>en tildeling af flere variabler</translation>
    </message>
    <message>
        <source>CASE of a computed value</source>
        <translation>CASE af en beregnet værdi</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>en tekst</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>et tal</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>et heltal</translation>
    </message>
    <message>
        <source>a number of seconds</source>
        <translation>et antal sekunder</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>en liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>et objekt</translation>
    </message>
    <message>
        <source>one of {0}</source>
        <translation>en af {0}</translation>
    </message>
</context>
<context>
    <name>PlotText</name>
    <message>
        <source>no longer kept</source>
        <translation>ikke længere bevaret</translation>
    </message>
    <message>
        <source>did not exist</source>
        <translation>fandtes ikke</translation>
    </message>
    <message>
        <source>scans skipped</source>
        <translation>scan sprunget over</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>ikke optaget</translation>
    </message>
    <message>
        <source>Time [%1]</source>
        <translation>Tid [%1]</translation>
    </message>
    <message>
        <source>Time from the trigger [%1]</source>
        <translation>Tid fra triggeren [%1]</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>At A</source>
        <translation>Ved A</translation>
    </message>
    <message>
        <source>At B</source>
        <translation>Ved B</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Maks</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Middelværdi</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Effektivværdi</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>Stigetid</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Oversving</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Indsvingningstid</translation>
    </message>
</context>
<context>
    <name>Remote</name>
    <message>
        <source>The request is not understood; studio and controller may be of different versions</source>
        <translation>Forespørgslen forstås ikke; studiet og styringen har måske forskellige versioner</translation>
    </message>
    <message>
        <source>There is no request {0}; studio and controller may be of different versions</source>
        <translation>Der er ingen forespørgsel {0}; studiet og styringen har måske forskellige versioner</translation>
    </message>
    <message>
        <source>Breakpoints stop a machine in the middle of a scan; `stepwise serve` allows them with --allow-breakpoints</source>
        <translation>Stoppunkter stopper en maskine midt i et scan; ”stepwise serve” tillader dem med --allow-breakpoints</translation>
    </message>
    <message>
        <source>{0} is forced; release it before writing</source>
        <translation>{0} er forceret; ophæv forceringen før skrivning</translation>
    </message>
    <message>
        <source>{0} is not forced; there is nothing to release</source>
        <translation>{0} er ikke forceret; der er intet at ophæve</translation>
    </message>
    <message>
        <source>Another program is being built for this controller; try again when it is loaded</source>
        <translation>Et andet program oversættes til denne styring; prøv igen, når det er indlæst</translation>
    </message>
    <message>
        <source>The program has {0} {0:error|errors}; correct them: the controller continues with the old program until then</source>
        <translation>Programmet har {0} fejl; ret dem: indtil da fortsætter styringen med det gamle</translation>
    </message>
    <message>
        <source>The controller&apos;s program has no file {0}; load its program again</source>
        <translation>Styringens program har ingen fil {0}; indlæs programmet igen</translation>
    </message>
    <message>
        <source>A recording is already being downloaded; wait until it is complete</source>
        <translation>En optagelse hentes allerede; vent, til den er fuldstændig</translation>
    </message>
    <message>
        <source>A served controller cannot be resumed from an earlier scan; download its recording and resume from there</source>
        <translation>En styring, der kører som tjeneste, kan ikke genoptages fra et tidligere scan; hent dens optagelse, og genoptag derfra</translation>
    </message>
    <message>
        <source>{0} is not the address of a controller; write for example https://plant:8443/</source>
        <translation>{0} er ikke adressen på en styring; skriv for eksempel https://plant:8443/</translation>
    </message>
    <message>
        <source>{0} rejects the connection: {1}</source>
        <translation>{0} afviser forbindelsen: {1}</translation>
    </message>
    <message>
        <source>The code is wrong; it is in the file attach-code of the controller&apos;s state folder</source>
        <translation>Koden er forkert; den findes i filen attach-code i styringens tilstandsmappe</translation>
    </message>
    <message>
        <source>There were too many wrong codes from this computer; wait a minute</source>
        <translation>Der kom for mange forkerte koder fra denne computer; vent et minut</translation>
    </message>
    <message>
        <source>The code would be sent over the network unencrypted; use an https address, and start the controller with --certificate</source>
        <translation>Koden ville blive sendt ukrypteret over nettet; brug en https-adresse, og start styringen med --certificate</translation>
    </message>
    <message>
        <source>The certificate of {0} is not trusted: {1}; name the file of the certificate that you trust</source>
        <translation>Der er ikke tillid til certifikatet for {0}: {1}; angiv filen med det certifikat, du har tillid til</translation>
    </message>
    <message>
        <source>The certificate cannot be read from {0}; it must be a PEM file</source>
        <translation>Certifikatet kan ikke læses fra {0}; det skal være en PEM-fil</translation>
    </message>
    <message>
        <source>The connection to {0} is lost; check the network and the controller</source>
        <translation>Forbindelsen til {0} er afbrudt; kontroller netværket og styringen</translation>
    </message>
    <message>
        <source>{0} does not answer; check the address and whether the controller runs</source>
        <translation>{0} svarer ikke; kontroller adressen, og om styringen kører</translation>
    </message>
    <message>
        <source>The controller&apos;s program cannot be built here as it is there; use the same version of Stepwise on both sides</source>
        <translation>Styringens program kan ikke oversættes her, som det er dér; brug samme version af Stepwise på begge sider</translation>
    </message>
    <message>
        <source>{0} speaks TLS on this port; use the address {1}</source>
        <translation>{0} bruger TLS på denne port; brug adressen {1}</translation>
    </message>
    <message>
        <source>{0} cannot be reached: {1}; check the address and the network</source>
        <translation>{0} kan ikke nås: {1}; kontroller adressen og netværket</translation>
    </message>
    <message>
        <source>Nothing answers at {0}; check the port, and whether `stepwise serve` runs there</source>
        <translation>Intet svarer på {0}; kontroller porten, og om ”stepwise serve” kører dér</translation>
    </message>
    <message>
        <source>There is no computer named {0}; check the name in the address</source>
        <translation>Der er ingen computer med navnet {0}; kontroller navnet i adressen</translation>
    </message>
    <message>
        <source>The server at {0} is not a controller started with `stepwise serve`; check the host and the port</source>
        <translation>Serveren på {0} er ikke en styring startet med ”stepwise serve”; kontroller værten og porten</translation>
    </message>
    <message>
        <source>The server at {0} does not speak TLS; start the controller with --certificate, or use an http address on the same computer</source>
        <translation>Serveren på {0} taler ikke TLS; start styringen med --certificate, eller brug en http-adresse på samme computer</translation>
    </message>
</context>
<context>
    <name>Storage</name>
    <message>
        <source>{0} does not have the character {1}; write the file as UTF-8</source>
        <translation>{0} har ikke tegnet {1}; skriv filen som UTF-8</translation>
    </message>
    <message>
        <source>The encoding {0} is not known; choose one of {1}</source>
        <translation>Tegnkodningen {0} kendes ikke; vælg en af {1}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a list of names; write them in quotes, in square brackets</source>
        <translation>”{0}” skal være en liste med navne; skriv dem i anførselstegn i kantede parenteser</translation>
    </message>
</context>
<context>
    <name>TraceText</name>
    <message>
        <source>Triggered at %1.</source>
        <translation>Udløst ved %1.</translation>
    </message>
    <message>
        <source>The trigger did not fire.</source>
        <translation>Triggeren blev ikke udløst.</translation>
    </message>
</context>
<context>
    <name>Tuning</name>
    <message>
        <source>{0} {0:sample is|samples are} too few for a model; record for longer</source>
        <translation>{0} {0:måling er|målinger er} for lidt til en model; optag i længere tid</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>brugbar</translation>
    </message>
    <message>
        <source>the input is at a limit for {0} % of the time</source>
        <translation>indgangen er ved en grænse i {0}&#xa0;% af tiden</translation>
    </message>
    <message>
        <source>the output moves by only {0} times its noise</source>
        <translation>udgangen bevæger sig kun {0} gange sin støj</translation>
    </message>
    <message>
        <source>too short: {0} {0:sample|samples} until the next change or the end</source>
        <translation>for kort: {0} {0:måling|målinger} til næste ændring eller slutningen</translation>
    </message>
    <message>
        <source>disturbed: no model explains more than {0} % of it</source>
        <translation>forstyrret: ingen model forklarer mere end {0}&#xa0;% af det</translation>
    </message>
    <message>
        <source>usable; not at rest before it</source>
        <translation>brugbar; ikke i ro før</translation>
    </message>
    <message>
        <source>There is no step or disturbance in the recording; change the set point or the output once and record the response</source>
        <translation>Der er intet spring og ingen forstyrrelse i optagelsen; ændr setpunktet eller udgangen én gang, og optag responsen</translation>
    </message>
    <message>
        <source>None of the {0} changes found is usable: {1}</source>
        <translation>Ingen af de {0} fundne ændringer er brugbare: {1}</translation>
    </message>
    <message>
        <source>No model explains the output; something else affects it</source>
        <translation>Ingen model forklarer udgangen; noget andet påvirker den</translation>
    </message>
    <message>
        <source>The rule {0} does not apply to this process; choose another one</source>
        <translation>Reglen {0} gælder ikke for denne proces; vælg en anden</translation>
    </message>
    <message>
        <source>Unstable: the oscillation would grow. Do not use these settings.</source>
        <translation>Ustabil: Svingningen ville vokse. Brug ikke disse indstillinger.</translation>
    </message>
    <message>
        <source>Fragile: a small change of the process makes it oscillate.</source>
        <translation>Skrøbelig: En lille ændring af processen får den til at svinge.</translation>
    </message>
    <message>
        <source>Brisk: fast, with slight oscillation; the process should not change much.</source>
        <translation>Rask: hurtig, med svage svingninger; processen bør ikke ændre sig meget.</translation>
    </message>
    <message>
        <source>Good: fast enough, and tolerant of the usual process changes.</source>
        <translation>God: hurtig nok, og den tåler de sædvanlige ændringer af en proces.</translation>
    </message>
    <message>
        <source>Calm: slow, and tolerant of large process changes.</source>
        <translation>Rolig: langsom, og den tåler en proces, der ændrer sig meget.</translation>
    </message>
    <message>
        <source>A step of the set point does not overshoot.</source>
        <translation>Et spring i setpunktet giver intet oversving.</translation>
    </message>
    <message>
        <source>A step of the set point overshoots by {0} %.</source>
        <translation>Et spring i setpunktet giver {0}&#xa0;% oversving.</translation>
    </message>
    <message>
        <source>Ziegler-Nichols is included for comparison: it oscillates and tolerates little change. Use SIMC or the optimum instead.</source>
        <translation>Ziegler-Nichols er her til sammenligning: Den svinger og tåler lidt ændring. Brug SIMC eller optimum i stedet.</translation>
    </message>
    <message>
        <source>The rule considers only one lag; check the margins.</source>
        <translation>Reglen tager kun hensyn til én tidskonstant; kontroller marginerne.</translation>
    </message>
    <message>
        <source>gain and dead time</source>
        <translation>forstærkning og dødtid</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>1. orden</translation>
    </message>
    <message>
        <source>first order with dead time</source>
        <translation>1. orden med dødtid</translation>
    </message>
    <message>
        <source>second order</source>
        <translation>2. orden</translation>
    </message>
    <message>
        <source>second order with dead time</source>
        <translation>2. orden med dødtid</translation>
    </message>
    <message>
        <source>two equal lags</source>
        <translation>to ens tidskonstanter</translation>
    </message>
    <message>
        <source>two equal lags with dead time</source>
        <translation>to ens tidskonstanter med dødtid</translation>
    </message>
    <message>
        <source>oscillating</source>
        <translation>svingende</translation>
    </message>
    <message>
        <source>oscillating with dead time</source>
        <translation>svingende med dødtid</translation>
    </message>
    <message>
        <source>oscillating with a lag</source>
        <translation>svingende med en tidskonstant</translation>
    </message>
    <message>
        <source>second order with a zero</source>
        <translation>2. orden med et nulpunkt</translation>
    </message>
    <message>
        <source>second order with a zero and dead time</source>
        <translation>2. orden med et nulpunkt og dødtid</translation>
    </message>
    <message>
        <source>three equal lags</source>
        <translation>tre ens tidskonstanter</translation>
    </message>
    <message>
        <source>three equal lags with a zero</source>
        <translation>tre ens tidskonstanter med et nulpunkt</translation>
    </message>
    <message>
        <source>four equal lags</source>
        <translation>fire ens tidskonstanter</translation>
    </message>
    <message>
        <source>five equal lags</source>
        <translation>fem ens tidskonstanter</translation>
    </message>
    <message>
        <source>six equal lags</source>
        <translation>seks ens tidskonstanter</translation>
    </message>
    <message>
        <source>seven equal lags</source>
        <translation>syv ens tidskonstanter</translation>
    </message>
    <message>
        <source>eight equal lags</source>
        <translation>otte ens tidskonstanter</translation>
    </message>
    <message>
        <source>three equal lags with dead time</source>
        <translation>tre ens tidskonstanter med dødtid</translation>
    </message>
    <message>
        <source>three lags</source>
        <translation>tre tidskonstanter</translation>
    </message>
    <message>
        <source>three lags with dead time</source>
        <translation>tre tidskonstanter med dødtid</translation>
    </message>
    <message>
        <source>four lags</source>
        <translation>fire tidskonstanter</translation>
    </message>
    <message>
        <source>integrating</source>
        <translation>integrerende</translation>
    </message>
    <message>
        <source>integrating with dead time</source>
        <translation>integrerende med dødtid</translation>
    </message>
    <message>
        <source>integrating with a lag</source>
        <translation>integrerende med en tidskonstant</translation>
    </message>
    <message>
        <source>integrating with a lag and dead time</source>
        <translation>integrerende med en tidskonstant og dødtid</translation>
    </message>
    <message>
        <source>integrating with two equal lags</source>
        <translation>integrerende med to ens tidskonstanter</translation>
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
        <translation>optagelsen har et hul i det</translation>
    </message>
    <message>
        <source>It oscillates with a period of {0} s and an amplitude of {1}, for {2} cycles in a row.</source>
        <translation>Det svinger med en periode på {0}&#xa0;s og en amplitude på {1}, {2} perioder i træk.</translation>
    </message>
    <message>
        <source>It does not oscillate.</source>
        <translation>Det svinger ikke.</translation>
    </message>
    <message>
        <source>The settings are the likely cause: with the model, the loop oscillates with this period.</source>
        <translation>Indstillingerne er den sandsynlige årsag: Med modellen svinger sløjfen med denne periode.</translation>
    </message>
    <message>
        <source>A sticking valve or an external disturbance is the likely cause; the recording cannot tell them apart. Switch the controller to manual: if the oscillation stops, the valve sticks; if it continues, the cause is external.</source>
        <translation>Den sandsynlige årsag er en ventil, der hænger, eller en forstyrrelse udefra; optagelsen kan ikke skelne mellem dem. Skift regulatoren til manuel: Hører svingningen op, hænger ventilen; fortsætter den, kommer årsagen udefra.</translation>
    </message>
    <message>
        <source>The likely cause is external: neither the settings nor a sticking valve explains it.</source>
        <translation>Den sandsynlige årsag kommer udefra: Hverken indstillingerne eller en ventil, der hænger, forklarer det.</translation>
    </message>
    <message>
        <source>The output is at a limit for {0} % of the time.</source>
        <translation>Udgangen er ved en grænse i {0}&#xa0;% af tiden.</translation>
    </message>
    <message>
        <source>{0} % of what the measured value does is noise.</source>
        <translation>{0}&#xa0;% af måleværdiens bevægelse er støj.</translation>
    </message>
    <message>
        <source>the output did not respond: the controller was not active</source>
        <translation>udgangen svarede ikke: regulatoren var ikke aktiv</translation>
    </message>
    <message>
        <source>too short: not at rest again before the next change</source>
        <translation>for kort: ikke i ro igen før den næste ændring</translation>
    </message>
    <message>
        <source>The recording has {0} {0:disturbance|disturbances}, but no step that a model can be made from; change the set point or the output once and record the response</source>
        <translation>Optagelsen har {0} {0:forstyrrelse|forstyrrelser}, men intet spring, der kan laves en model af; ændr setpunktet eller udgangen én gang, og optag responsen</translation>
    </message>
    <message>
        <source>Change {0} is a disturbance: its cause is not known, so no model can be made from it; choose a change of the set point or of the output</source>
        <translation>Ændring {0} er en forstyrrelse: årsagen kendes ikke, så den giver ingen model; vælg en ændring af setpunktet eller udgangen</translation>
    </message>
    <message>
        <source>the measured value is at the end of its range for {0} % of the time</source>
        <translation>måleværdien er ved enden af sit område i {0}&#xa0;% af tiden</translation>
    </message>
    <message>
        <source>{0}, controlled by {1}</source>
        <translation>{0}, reguleret af {1}</translation>
    </message>
    <message>
        <source>Changes in the recording</source>
        <translation>Ændringer i optagelsen</translation>
    </message>
    <message>
        <source>{0} found, {1} used for the model</source>
        <translation>{0} fundet, {1} brugt til modellen</translation>
    </message>
    <message>
        <source>… and {0} more</source>
        <translation>… og {0} flere</translation>
    </message>
    <message>
        <source>No model: {0}</source>
        <translation>Ingen model: {0}</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>{0}, explains {1} %</source>
        <translation>{0}, forklarer {1}&#xa0;%</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Indstillinger</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagrammer</translation>
    </message>
    <message>
        <source>Parameters by {0}</source>
        <translation>Parametre efter {0}</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>optaget</translation>
    </message>
    <message>
        <source>output at a limit</source>
        <translation>udgang ved en grænse</translation>
    </message>
    <message>
        <source>mean absolute error</source>
        <translation>gennemsnitlig absolut reguleringsfejl</translation>
    </message>
    <message>
        <source>integrated absolute error</source>
        <translation>integreret absolut reguleringsfejl</translation>
    </message>
    <message>
        <source>movements of the output in an hour</source>
        <translation>udgangens bevægelser pr. time</translation>
    </message>
    <message>
        <source>noise of the measured value</source>
        <translation>støj på måleværdien</translation>
    </message>
    <message>
        <source>at [s]</source>
        <translation>ved [s]</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>ændring</translation>
    </message>
    <message>
        <source>from</source>
        <translation>fra</translation>
    </message>
    <message>
        <source>to</source>
        <translation>til</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>vurdering</translation>
    </message>
    <message>
        <source>output</source>
        <translation>udgang</translation>
    </message>
    <message>
        <source>set point</source>
        <translation>setpunkt</translation>
    </message>
    <message>
        <source>disturbance</source>
        <translation>forstyrrelse</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>forstærkning</translation>
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
        <translation>forstærkningsmargin</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>fasemargin</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>oversving</translation>
    </message>
    <message>
        <source>settling time [s]</source>
        <translation>indsvingningstid [s]</translation>
    </message>
    <message>
        <source>error after a load step</source>
        <translation>fejl efter et lastspring</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>ustabil</translation>
    </message>
    <message>
        <source>now</source>
        <translation>nu</translation>
    </message>
    <message>
        <source>Recorded and modelled</source>
        <translation>Optaget og modelleret</translation>
    </message>
    <message>
        <source>Step of the set point by 1</source>
        <translation>Spring i setpunktet på 1</translation>
    </message>
    <message>
        <source>Step of the load by 1</source>
        <translation>Spring i lasten på 1</translation>
    </message>
    <message>
        <source>Bode plot</source>
        <translation>Bodediagram</translation>
    </message>
    <message>
        <source>Set point and measured value</source>
        <translation>Setpunkt og måleværdi</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Udgang</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>tid [s]</translation>
    </message>
    <message>
        <source>magnitude [dB]</source>
        <translation>amplitude [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>fase [°]</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>frekvens [rad/s]</translation>
    </message>
    <message>
        <source>model</source>
        <translation>model</translation>
    </message>
    <message>
        <source>loop now</source>
        <translation>nuværende sløjfe</translation>
    </message>
    <message>
        <source>loop, {0}</source>
        <translation>sløjfe, {0}</translation>
    </message>
    <message>
        <source>process</source>
        <translation>proces</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>målt</translation>
    </message>
    <message>
        <source>gain {0} ± {1}</source>
        <translation>forstærkning {0} ± {1}</translation>
    </message>
    <message>
        <source>lag {0} s ± {1} s</source>
        <translation>tidskonstant {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>frequency {0} rad/s ± {1} rad/s</source>
        <translation>frekvens {0}&#xa0;rad/s ± {1}&#xa0;rad/s</translation>
    </message>
    <message>
        <source>damping {0} ± {1}</source>
        <translation>dæmpning {0} ± {1}</translation>
    </message>
    <message>
        <source>zero {0} s ± {1} s</source>
        <translation>nulpunkt {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>dead time {0} s ± {1} s</source>
        <translation>dødtid {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>The gain is {0} upwards and {1} downwards; settings are made for {2}.</source>
        <translation>Forstærkningen er {0} opad og {1} nedad; indstillingerne er lavet til {2}.</translation>
    </message>
    <message>
        <source>The gain depends on the operating point: it is {0} where the measured value is about {1}, and {2} about {3}; settings are made for {4}. For one range alone, choose its steps only.</source>
        <translation>Forstærkningen afhænger af arbejdspunktet: den er {0}, hvor måleværdien er omkring {1}, og {2} omkring {3}; indstillingerne er lavet til {4}. Vælg kun springene i ét område for at indstille til det alene.</translation>
    </message>
    <message>
        <source>usable; the output was set to its limit</source>
        <translation>brugbar; udgangen blev sat til sin grænse</translation>
    </message>
    <message>
        <source>Loop health</source>
        <translation>Reguleringssløjfens tilstand</translation>
    </message>
    <message>
        <source>It explains {0} % of the steps it was not fitted to.</source>
        <translation>Den forklarer {0}&#xa0;% af de spring, den ikke blev tilpasset.</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residualer</translation>
    </message>
    <message>
        <source>The controller output and the measured value are the same in every sample; choose another measured value</source>
        <translation>Regulatorudgangen og måleværdien er ens i hver måling; vælg en anden måleværdi</translation>
    </message>
    <message>
        <source>A sticking valve is the likely cause: the output moves evenly, but the process responds in jumps. Check it with the controller in manual: the oscillation then stops; if it continues, the cause is external.</source>
        <translation>En ventil, der hænger, er den sandsynlige årsag: Udgangen bevæger sig jævnt, processen svarer i spring. Kontroller det med regulatoren i manuel: Så hører svingningen op; fortsætter den, kommer årsagen udefra.</translation>
    </message>
</context>
<context>
    <name>Waveform</name>
    <message>
        <source>The table has no column of times; name one time_s (seconds) or time_ms</source>
        <translation>Tabellen har ingen kolonne med tider; kald en time_s (sekunder) eller time_ms</translation>
    </message>
    <message>
        <source>The table has no column {0}; it has {1}</source>
        <translation>Tabellen har ingen kolonne {0}; den har {1}</translation>
    </message>
    <message>
        <source>The table has no column {0}; did you mean {1}?</source>
        <translation>Tabellen har ingen kolonne {0}; mente du {1}?</translation>
    </message>
    <message>
        <source>Line {0} has no number in column {1}; correct or remove the line</source>
        <translation>Linje {0} har intet tal i kolonne {1}; ret eller fjern linjen</translation>
    </message>
    <message>
        <source>The time in line {0} is before that of the line above; sort the lines by time</source>
        <translation>Tiden i linje {0} er før tiden i linjen ovenover; sorter linjerne efter tid</translation>
    </message>
    <message>
        <source>The table has no column of numbers besides the time; add one with a heading</source>
        <translation>Tabellen har ingen kolonne med tal ud over tiden; tilføj en med overskrift</translation>
    </message>
    <message>
        <source>The table has no rows below its headings; write one row per sample</source>
        <translation>Tabellen har ingen rækker under overskrifterne; skriv én række pr. måling</translation>
    </message>
    <message>
        <source>The table cannot be shown as a recording: {0}</source>
        <translation>Tabellen kan ikke vises som en optagelse: {0}</translation>
    </message>
    <message>
        <source>the names of its columns cannot be variables; use letters, digits and underscores</source>
        <translation>navnene på dens kolonner kan ikke være variabler; brug bogstaver, cifre og understreger</translation>
    </message>
    <message>
        <source>{0} {0:sample is|samples are} too few for a spectrum; show a longer section</source>
        <translation>{0} {0:målepunkt|målepunkter} er for lidt til et spektrum; vis et længere område</translation>
    </message>
    <message>
        <source>{0} {0:sample is|samples are} too few for a frequency response; show a longer section</source>
        <translation>{0} {0:målepunkt|målepunkter} er for lidt til en frekvensrespons; vis et længere område</translation>
    </message>
    <message>
        <source>The input does not change here, so there is no response; show another section</source>
        <translation>Indgangen ændrer sig ikke her, så der er ingen respons; vis et andet område</translation>
    </message>
    <message>
        <source>{0} needs a closing parenthesis at the end; it must enclose the whole expression</source>
        <translation>{0} kræver en afsluttende parentes til sidst; den skal omslutte hele udtrykket</translation>
    </message>
    <message>
        <source>{0} needs a time above 0 as its second argument, for example {1}</source>
        <translation>{0} kræver en tid over 0 som andet argument, for eksempel {1}</translation>
    </message>
    <message>
        <source>{0} takes one expression; remove the others</source>
        <translation>{0} tager ét udtryk; fjern de andre</translation>
    </message>
    <message>
        <source>The file is not a table; a recording of Stepwise ends with .rec</source>
        <translation>Filen er ikke en tabel; en optagelse fra Stepwise ender på .rec</translation>
    </message>
    <message>
        <source>Column {0}: {1} {1:cell is not a number|cells are not numbers}, the first ({2}) in line {3}; the value above it is kept</source>
        <translation>Kolonne {0}: {1} {1:celle er ikke et tal|celler er ikke tal}, den første ({2}) i linje {3}; værdien ovenover gælder fortsat</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} fewer cells than the header, the first in line {1}; the values above are kept</source>
        <translation>{0} {0:række har|rækker har} færre celler end overskriften, den første i linje {1}; værdierne ovenover gælder fortsat</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} more cells than the header, the first in line {1}; the surplus cells are ignored. Put numbers with a decimal comma in quotes</source>
        <translation>{0} {0:række har|rækker har} flere celler end overskriften, den første i linje {1}; de overskydende celler ignoreres. Sæt tal med decimalkomma i anførselstegn</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} the same time as the row above, the first in line {1}; {0:it is|they are} left out</source>
        <translation>{0} {0:række har|rækker har} samme tid som rækken ovenover, den første i linje {1}; {0:den|de} udelades</translation>
    </message>
    <message>
        <source>Line {0} is not a sample of a variable: it needs a time and a value</source>
        <translation>Linje {0} er ikke et målepunkt for en variabel: den skal have en tid og en værdi</translation>
    </message>
    <message>
        <source>The trace cannot be read as XML: {0}; save it again</source>
        <translation>Tracen kan ikke læses som XML: {0}; gem den igen</translation>
    </message>
    <message>
        <source>{0} has {1} {1:value|values} but {2} {2:time|times}; save the trace again</source>
        <translation>{0} har {1} {1:værdi|værdier}, men {2} {2:tid|tider}; gem tracen igen</translation>
    </message>
    <message>
        <source>The times of {0} run backwards; save the trace again</source>
        <translation>Tiderne for {0} løber baglæns; gem tracen igen</translation>
    </message>
    <message>
        <source>The file is empty; export the table again</source>
        <translation>Filen er tom; eksporter tabellen igen</translation>
    </message>
    <message>
        <source>The table has {0} columns {1}; give each its own heading</source>
        <translation>Tabellen har {0} kolonner {1}; giv hver sin egen overskrift</translation>
    </message>
    <message>
        <source>Column {0} has no numbers; choose one of {1}</source>
        <translation>Kolonne {0} har ingen tal; vælg en af {1}</translation>
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
        <translation>Kode</translation>
    </message>
    <message>
        <source>Attach to a Controller</source>
        <translation>Forbind med en styring</translation>
    </message>
    <message>
        <source>from the file attach-code of the controller</source>
        <translation>fra filen attach-code på styringen</translation>
    </message>
    <message>
        <source>only for certificates that this computer does not know</source>
        <translation>kun til certifikater, som denne computer ikke kender</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose a certificate</source>
        <translation>Vælg et certifikat</translation>
    </message>
    <message>
        <source>Trusted certificate</source>
        <translation>Certifikat, du har tillid til</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>Forbind</translation>
    </message>
    <message>
        <source>Choose a Certificate</source>
        <translation>Vælg et certifikat</translation>
    </message>
    <message>
        <source>Certificates (*.pem *.crt *.cer);;All files (*)</source>
        <translation>Certifikater (*.pem *.crt *.cer);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Attaching…</source>
        <translation>Forbinder…</translation>
    </message>
</context>
<context>
    <name>plc::app::Attachment</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 ved %2</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Afbryd</translation>
    </message>
    <message>
        <source>Attached to %1</source>
        <translation>Forbundet med %1</translation>
    </message>
    <message>
        <source>Attached to %1; its program is not the one that is open here</source>
        <translation>Forbundet med %1; dens program er ikke det, der er åbent her</translation>
    </message>
    <message>
        <source>Connection to %1 lost – reconnecting…</source>
        <translation>Forbindelsen til %1 er afbrudt – forbinder igen…</translation>
    </message>
    <message>
        <source>Attaching to %1…</source>
        <translation>Forbinder med %1…</translation>
    </message>
    <message>
        <source>The controller runs remotely; values written and forced here take effect there</source>
        <translation>Styringen kører eksternt; værdier, der skrives og forceres her, virker dér</translation>
    </message>
</context>
<context>
    <name>plc::app::ConversionDialog</name>
    <message>
        <source>%1 as ST</source>
        <translation>%1 som ST</translation>
    </message>
    <message>
        <source>%1 as an Instruction List</source>
        <translation>%1 som instruktionsliste</translation>
    </message>
    <message>
        <source>Instruction list (current text)</source>
        <translation>Instruktionsliste (nuværende tekst)</translation>
    </message>
    <message>
        <source>ST (current text)</source>
        <translation>ST (nuværende tekst)</translation>
    </message>
    <message>
        <source>The same as ST</source>
        <translation>Det samme som ST</translation>
    </message>
    <message>
        <source>The same as an instruction list</source>
        <translation>Det samme som instruktionsliste</translation>
    </message>
    <message>
        <source>Both give the same results. Replacing can be undone in one step; comments are kept, each above its statement.</source>
        <translation>Begge giver samme resultater. Erstatningen kan fortrydes i ét trin; kommentarer bevares, hver over sin sætning.</translation>
    </message>
    <message>
        <source>Replace the Text</source>
        <translation>Erstat teksten</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopier</translation>
    </message>
</context>
<context>
    <name>plc::app::DesignPages</name>
    <message>
        <source>Texts</source>
        <translation>Tekster</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmer</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recepter</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Brugere og rettigheder</translation>
    </message>
    <message>
        <source>New Panel</source>
        <translation>Nyt panel</translation>
    </message>
    <message>
        <source>Name of the panel:</source>
        <translation>Panelets navn:</translation>
    </message>
    <message>
        <source>overview</source>
        <translation>oversigt</translation>
    </message>
    <message>
        <source>A panel&apos;s name cannot contain / or \; choose another name</source>
        <translation>Et panels navn kan ikke indeholde / eller \; vælg et andet navn</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ændringer, der ikke er gemt</translation>
    </message>
    <message>
        <source>%1 was changed. Save it?</source>
        <translation>%1 er ændret. Skal ændringerne gemmes?</translation>
    </message>
</context>
<context>
    <name>plc::app::DevicesView</name>
    <message>
        <source>off</source>
        <translation>fra</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>forbinder</translation>
    </message>
    <message>
        <source>online</source>
        <translation>online</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>afbrudt</translation>
    </message>
    <message>
        <source>good</source>
        <translation>god</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>intet endnu</translation>
    </message>
    <message>
        <source>refused by the device</source>
        <translation>afvist af enheden</translation>
    </message>
    <message>
        <source>does not fit</source>
        <translation>passer ikke</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Enheder</translation>
    </message>
    <message>
        <source>Device or channel</source>
        <translation>Enhed eller kanal</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variabel</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Sted</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Tilstand</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Værdi</translation>
    </message>
    <message>
        <source>Traffic</source>
        <translation>Trafik</translation>
    </message>
    <message>
        <source>Fields of the device or channel</source>
        <translation>Enhedens eller kanalens felter</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Felt</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Indhold</translation>
    </message>
    <message>
        <source>Connect or disconnect the devices</source>
        <translation>Forbind eller afbryd enhederne</translation>
    </message>
    <message>
        <source>Add a device</source>
        <translation>Tilføj en enhed</translation>
    </message>
    <message>
        <source>This project has no devices yet. A device (Modbus, MQTT) brings values from outside into variables and takes values of variables out.</source>
        <translation>Dette projekt har endnu ingen enheder. En enhed (Modbus, MQTT) henter værdier udefra ind i variabler og sender variablers værdier ud.</translation>
    </message>
    <message>
        <source>Modbus TCP device</source>
        <translation>Modbus TCP-enhed</translation>
    </message>
    <message>
        <source>Modbus RTU device (serial)</source>
        <translation>Modbus RTU-enhed (seriel)</translation>
    </message>
    <message>
        <source>Modbus TCP server</source>
        <translation>Modbus TCP-server</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>MQTT-broker</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Tilføj en kanal</translation>
    </message>
    <message>
        <source>Delete the device or channel</source>
        <translation>Slet enheden eller kanalen</translation>
    </message>
    <message>
        <source>Propose addresses for channels without a variable</source>
        <translation>Foreslå adresser til kanaler uden variabel</translation>
    </message>
    <message>
        <source>Undo the last change of the devices</source>
        <translation>Fortryd den seneste ændring af enhederne</translation>
    </message>
    <message>
        <source>Every channel has a variable</source>
        <translation>Alle kanaler har en variabel</translation>
    </message>
    <message numerus="yes">
        <source>%n address(es) proposed</source>
        <translation>
            <numerusform>%n adresse foreslået</numerusform>
            <numerusform>%n adresser foreslået</numerusform>
        </translation>
    </message>
    <message>
        <source>not enabled</source>
        <translation>ikke aktiveret</translation>
    </message>
    <message>
        <source>%1 requests, %2 errors, %3 ms</source>
        <translation>%1 forespørgsler, %2 fejl, %3&#xa0;ms</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>ikke forbundet</translation>
    </message>
    <message>
        <source>online: %1 of %2</source>
        <translation>online: %1 af %2</translation>
    </message>
    <message>
        <source>“%1” in devices.json</source>
        <translation>”%1” i devices.json</translation>
    </message>
</context>
<context>
    <name>plc::app::EditorTabs</name>
    <message>
        <source>Documents</source>
        <translation>Dokumenter</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Luk</translation>
    </message>
    <message>
        <source>Close Others</source>
        <translation>Luk andre</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ændringer, der ikke er gemt</translation>
    </message>
    <message>
        <source>%1 was changed. Save it?</source>
        <translation>%1 er ændret. Skal ændringerne gemmes?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were changed: %1. Save them?</source>
        <translation>
            <numerusform>%n fil er ændret: %1. Gem den?</numerusform>
            <numerusform>%n filer er ændret: %1. Gem dem?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s); those edited since stay as they are</source>
        <translation>
            <numerusform>Ændret i %n fil; filer redigeret siden forbliver, som de er</numerusform>
            <numerusform>Ændret i %n filer; filer redigeret siden forbliver, som de er</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s)</source>
        <translation>
            <numerusform>Ændret i %n fil</numerusform>
            <numerusform>Ændret i %n filer</numerusform>
        </translation>
    </message>
    <message>
        <source>Read-only file</source>
        <translation>Skrivebeskyttet fil</translation>
    </message>
    <message>
        <source>%1 is read-only. Replace it anyway? It stays read-only.</source>
        <translation>%1 er skrivebeskyttet. Skal den alligevel erstattes? Den forbliver skrivebeskyttet.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Erstat</translation>
    </message>
    <message>
        <source>%1 was not saved</source>
        <translation>%1 blev ikke gemt</translation>
    </message>
    <message>
        <source>%1 is not a variable of the running program; check the name, or press F5 to build the program</source>
        <translation>%1 er ikke en variabel i det kørende program; kontroller navnet, eller oversæt programmet med F5</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Forcer</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Skriv</translation>
    </message>
</context>
<context>
    <name>plc::app::ExplanationDialog</name>
    <message>
        <source>Explanation</source>
        <translation>Forklaring</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <extracomment>an example&apos;s line, then what is wrong there</extracomment>
        <translation>Linje %1: %2</translation>
    </message>
    <message>
        <source>What %1 Means</source>
        <translation>Hvad %1 betyder</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Forkert</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rigtigt</translation>
    </message>
    <message>
        <source>Put the cursor on a problem, or choose one in the list, and press F1 again</source>
        <translation>Sæt markøren på et problem, eller vælg et på listen, og tryk på F1 igen</translation>
    </message>
    <message>
        <source>There is no page for %1; choose a code from the list</source>
        <translation>Der er ingen side om %1; vælg en kode fra listen</translation>
    </message>
</context>
<context>
    <name>plc::app::ExportDialog</name>
    <message>
        <source>Export the Project</source>
        <translation>Eksporter projektet</translation>
    </message>
    <message>
        <source>PLCopen XML 0200, for CODESYS and TwinCAT</source>
        <translation>PLCopen XML 0200, til CODESYS og TwinCAT</translation>
    </message>
    <message>
        <source>PLCopen XML 0201, for Beremiz and OpenPLC</source>
        <translation>PLCopen XML 0201, til Beremiz og OpenPLC</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Fil…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksporter</translation>
    </message>
    <message>
        <source>Format:</source>
        <translation>Format:</translation>
    </message>
    <message>
        <source>To:</source>
        <translation>Til:</translation>
    </message>
    <message>
        <source>This file exists and will be replaced</source>
        <translation>Filen findes og bliver erstattet</translation>
    </message>
</context>
<context>
    <name>plc::app::FileCommands</name>
    <message>
        <source>New Trace</source>
        <translation>Ny trace</translation>
    </message>
    <message>
        <source>Name of the trace:</source>
        <translation>Tracens navn:</translation>
    </message>
    <message>
        <source>trace</source>
        <translation>trace</translation>
    </message>
    <message>
        <source>A file name cannot contain / or \; choose another name</source>
        <translation>Et filnavn kan ikke indeholde / eller \; vælg et andet navn</translation>
    </message>
    <message>
        <source>A trace %1 already exists; choose another name</source>
        <translation>Der findes allerede en trace %1; vælg et andet navn</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Omdøb</translation>
    </message>
    <message>
        <source>New name of %1:</source>
        <translation>Nyt navn på %1:</translation>
    </message>
    <message>
        <source>A file %1 already exists; choose another name</source>
        <translation>Der findes allerede en fil %1; vælg et andet navn</translation>
    </message>
    <message>
        <source>The file cannot be renamed; check the permissions of the folder</source>
        <translation>Filen kan ikke omdøbes; kontroller mappens rettigheder</translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>Slet %1?</translation>
    </message>
    <message>
        <source>It contains %1.</source>
        <translation>Den indeholder %1.</translation>
    </message>
    <message>
        <source>These panels link to it; their buttons will be reported as errors: %1</source>
        <translation>Disse paneler henviser til det; deres knapper fører så ingen steder hen: %1</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Slet</translation>
    </message>
    <message>
        <source>The file cannot be removed; check the permissions of the folder</source>
        <translation>Filen kan ikke slettes; kontroller mappens rettigheder</translation>
    </message>
</context>
<context>
    <name>plc::app::GuideView</name>
    <message>
        <source>About this project</source>
        <translation>Om dette projekt</translation>
    </message>
    <message>
        <source>A README.md in the project&apos;s folder is shown here.</source>
        <translation>En README.md i projektets mappe vises her.</translation>
    </message>
</context>
<context>
    <name>plc::app::ImportDialog</name>
    <message>
        <source>Place</source>
        <translation>Sted</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Bemærkning</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Objects: %1
Bodies: %2
Not kept: %3</source>
        <translation>Objekter: %1
Kroppe: %2
Ikke bevaret: %3</translation>
    </message>
    <message>
        <source>Import a Project</source>
        <translation>Importer et projekt</translation>
    </message>
    <message>
        <source>PLCopen XML, TwinCAT or CODESYS files, structured text</source>
        <translation>PLCopen XML, filer fra TwinCAT eller CODESYS, struktureret tekst</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Fil…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Mappe…</translation>
    </message>
    <message>
        <source>Source files</source>
        <translation>Kildefiler</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Forhåndsvisning</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>From:</source>
        <translation>Fra:</translation>
    </message>
    <message>
        <source>New project in:</source>
        <translation>Nyt projekt i:</translation>
    </message>
    <message>
        <source>Projects of other tools (%1)</source>
        <translation>Projekter fra andre værktøjer (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle filer (*)</translation>
    </message>
    <message>
        <source>This folder is not empty; name a new one</source>
        <translation>Denne mappe er ikke tom; angiv en ny</translation>
    </message>
    <message>
        <source>program units</source>
        <translation>programenheder</translation>
    </message>
    <message>
        <source>data types</source>
        <translation>datatyper</translation>
    </message>
    <message>
        <source>global variable lists</source>
        <translation>globale variabellister</translation>
    </message>
    <message>
        <source>configurations</source>
        <translation>konfigurationer</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>tekster</translation>
    </message>
    <message>
        <source>files</source>
        <translation>filer</translation>
    </message>
    <message>
        <source>PLCopen XML, TwinCAT, CODESYS, ST</source>
        <translation>PLCopen XML, TwinCAT, CODESYS, ST</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Læser %1…</translation>
    </message>
    <message>
        <source>Becomes a separate project with the libraries it uses</source>
        <translation>Bliver sit eget projekt med de biblioteker, det bruger</translation>
    </message>
    <message>
        <source>Writing the project…</source>
        <translation>Skriver projektet…</translation>
    </message>
    <message>
        <source>Encoding:</source>
        <translation>Tegnkodning:</translation>
    </message>
    <message>
        <source>Recognised</source>
        <translation>Genkendt</translation>
    </message>
    <message>
        <source>For files that are not in Unicode and do not specify their encoding</source>
        <translation>Til filer, der ikke er i Unicode og ikke angiver deres tegnkodning</translation>
    </message>
</context>
<context>
    <name>plc::app::InsideViews</name>
    <message>
        <source>Coverage of the latest %1 of %2 recorded scans</source>
        <translation>Dækning af de nyeste %1 af %2 optagede scan</translation>
    </message>
    <message>
        <source>There is no recording yet: run the program first.</source>
        <translation>Der er endnu ingen optagelse: Kør først programmet.</translation>
    </message>
    <message>
        <source>Put the cursor on a variable, or select an expression, to ask about it</source>
        <translation>Sæt markøren på en variabel, eller marker et udtryk, for at spørge om det</translation>
    </message>
</context>
<context>
    <name>plc::app::InstanceBar</name>
    <message>
        <source>Instance whose values are shown</source>
        <translation>Instans, hvis værdier vises</translation>
    </message>
    <message>
        <source>Values of the instance of %1:</source>
        <translation>Værdier for instansen af %1:</translation>
    </message>
</context>
<context>
    <name>plc::app::LiveViews</name>
    <message>
        <source>Panel shown</source>
        <translation>Vist panel</translation>
    </message>
    <message>
        <source>Full screen (Esc to exit)</source>
        <translation>Fuld skærm (Esc afslutter)</translation>
    </message>
    <message>
        <source>This project has no panel yet.
To draw one, right-click Panels in the project tree and choose New.</source>
        <translation>Projektet har endnu intet panel.
Højreklik på Paneler i projekttræet, og vælg Ny for at tegne et.</translation>
    </message>
    <message>
        <source>No panel can be read: %1.
Problems says what is wrong; a double click there opens the file as text.</source>
        <translation>Intet panel kan læses: %1.
Under Problemer står, hvad der er galt; et dobbeltklik der åbner filen som tekst.</translation>
    </message>
    <message>
        <source>The alarm history is kept in memory only: %1</source>
        <translation>Alarmhistorikken holdes kun i hukommelsen: %1</translation>
    </message>
    <message>
        <source>Saving the recording…</source>
        <translation>Gemmer optagelsen…</translation>
    </message>
    <message>
        <source>Export the alarm history…</source>
        <translation>Eksporter alarmhistorikken…</translation>
    </message>
    <message>
        <source>Export the Alarm History</source>
        <translation>Eksporter alarmhistorikken</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabeller (*.csv)</translation>
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
        <translation>Overvågning</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Forcerede værdier</translation>
    </message>
    <message>
        <source>Call Stack</source>
        <translation>Kaldestak</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>Stoppunkter</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemer</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Søgning</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tasks</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
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
        <translation>Tid</translation>
    </message>
    <message>
        <source>Recent Projects</source>
        <translation>Seneste projekter</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Værktøjslinje</translation>
    </message>
    <message>
        <source>State of the controller</source>
        <translation>Styringens tilstand</translation>
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
        <translation>FEJL</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>PAST</source>
        <translation>FORTID</translation>
    </message>
    <message>
        <source>%1 · scan %2</source>
        <translation>%1 · scan %2</translation>
    </message>
    <message>
        <source>%1 µs · %2 % load</source>
        <translation>%1&#xa0;µs · %2&#xa0;% belastning</translation>
    </message>
    <message>
        <source>%1 MB recorded</source>
        <translation>%1&#xa0;MB optaget</translation>
    </message>
    <message>
        <source>%1 scans of %2 MB at most</source>
        <translation>%1 scan, højst %2&#xa0;MB</translation>
    </message>
    <message>
        <source>Go to the line</source>
        <translation>Gå til linjen</translation>
    </message>
    <message>
        <source>no problems</source>
        <translation>ingen problemer</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Åbn projekt</translation>
    </message>
    <message>
        <source>%1 – Stepwise</source>
        <translation>%1 – Stepwise</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Gendannelse</translation>
    </message>
    <message>
        <source>Stepwise was closed without saving. Unsaved changes to %1 were kept. Restore them?</source>
        <translation>Stepwise blev lukket uden at gemme. Ændringer i %1, der ikke er gemt, er bevaret. Skal de gendannes?</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Biblioteker</translation>
    </message>
    <message>
        <source>Running tests…</source>
        <translation>Testene kører…</translation>
    </message>
    <message>
        <source>passed: %1</source>
        <translation>bestået: %1</translation>
    </message>
    <message>
        <source>FAILED: %1</source>
        <translation>FEJLET: %1</translation>
    </message>
    <message>
        <source>%1 passed, %2 failed</source>
        <translation>%1 bestået, %2 fejlet</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Realtid</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>Så hurtigt som muligt</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Hastighed</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Optagelse</translation>
    </message>
    <message>
        <source>Memory for the recording of every scan [MB]:</source>
        <translation>Hukommelse til optagelsen af hvert scan [MB]:</translation>
    </message>
    <message>
        <source>Save the Recording</source>
        <translation>Gem optagelsen</translation>
    </message>
    <message>
        <source>Recordings (*.rec)</source>
        <translation>Optagelser (*.rec)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gemt: %1</translation>
    </message>
    <message>
        <source>About Stepwise</source>
        <translation>Om Stepwise</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Velkommen</translation>
    </message>
    <message>
        <source>The project</source>
        <translation>Projektet</translation>
    </message>
    <message>
        <source>Programs, blocks, tasks, panels, traces and tests, made from the text files in the folder.</source>
        <translation>Programmer, blokke, tasks, paneler, traces og tests, lavet af tekstfilerne i mappen.</translation>
    </message>
    <message>
        <source>The program</source>
        <translation>Programmet</translation>
    </message>
    <message>
        <source>Structured Text with semantic highlighting. Errors are underlined as you type; Alt+Enter offers quick fixes; Ctrl+Space completes.</source>
        <translation>Struktureret tekst med semantisk fremhævning. Fejl understreges, mens du skriver; Alt+Enter tilbyder hurtige rettelser; Ctrl+Mellemrum fuldfører.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Kør</translation>
    </message>
    <message>
        <source>F5 compiles to native code and runs it. Values then appear next to each line.</source>
        <translation>F5 oversætter til maskinkode og kører den. Værdierne vises derefter ved hver linje.</translation>
    </message>
    <message>
        <source>Any expression, at any moment. Prepare a value and write or force it with one click.</source>
        <translation>Ethvert udtryk, når som helst. Forbered en værdi, og skriv eller forcer den med ét klik.</translation>
    </message>
    <message>
        <source>The trace</source>
        <translation>Tracen</translation>
    </message>
    <message>
        <source>Nothing has to be selected in advance: every scan is recorded, and any expression can be charted afterwards.</source>
        <translation>Intet skal vælges på forhånd: hvert scan optages, og ethvert udtryk kan bagefter vises i et diagram.</translation>
    </message>
    <message>
        <source>The panel</source>
        <translation>Panelet</translation>
    </message>
    <message>
        <source>What the operator sees, in the languages of the machine. It works here as it will on the machine.</source>
        <translation>Det, operatøren ser, på maskinens sprog. Det virker her, som det vil på maskinen.</translation>
    </message>
    <message>
        <source>Time runs backwards, too</source>
        <translation>Tiden går også baglæns</translation>
    </message>
    <message>
        <source>That’s it</source>
        <translation>Det var det</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P finds every command. The start page has more machines to play with.</source>
        <translation>Ctrl+Skift+P finder alle kommandoer. Startsiden har flere maskiner at lege med.</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmer</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>Nyt projekt…</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>Åbn projekt…</translation>
    </message>
    <message>
        <source>Close Project</source>
        <translation>Luk projekt</translation>
    </message>
    <message>
        <source>New Program, Block, Type…</source>
        <translation>Nyt program, ny blok, datatype…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Gem</translation>
    </message>
    <message>
        <source>New Panel…</source>
        <translation>Nyt panel…</translation>
    </message>
    <message>
        <source>Panel Texts</source>
        <translation>Paneltekster</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Gem alle</translation>
    </message>
    <message>
        <source>Close Document</source>
        <translation>Luk dokument</translation>
    </message>
    <message>
        <source>Libraries…</source>
        <translation>Biblioteker…</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Indstillinger…</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Afslut</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Rediger</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Fortryd</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Gentag</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Klip</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopier</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Sæt ind</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>Søg…</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Erstat…</translation>
    </message>
    <message>
        <source>Find Next</source>
        <translation>Søg næste</translation>
    </message>
    <message>
        <source>Find Previous</source>
        <translation>Søg forrige</translation>
    </message>
    <message>
        <source>Find in All Files…</source>
        <translation>Søg i alle filer…</translation>
    </message>
    <message>
        <source>Go to Line…</source>
        <translation>Gå til linje…</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Gå til definitionen</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Find referencer</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Omdøb…</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Fuldfør</translation>
    </message>
    <message>
        <source>Quick Fix (Alt+Enter)</source>
        <translation>Hurtig rettelse (Alt+Enter)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formater</translation>
    </message>
    <message>
        <source>Toggle Comment (Ctrl+/)</source>
        <translation>Kommenter ind eller ud (Ctrl+/)</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliker linjen</translation>
    </message>
    <message>
        <source>Select Enclosing Block</source>
        <translation>Marker den omgivende blok</translation>
    </message>
    <message>
        <source>Go to Matching Keyword</source>
        <translation>Gå til det tilhørende nøgleord</translation>
    </message>
    <message>
        <source>Next Problem</source>
        <translation>Næste problem</translation>
    </message>
    <message>
        <source>Previous Problem</source>
        <translation>Forrige problem</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Tilbage</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Fremad</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Oversæt</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>Single Scan</source>
        <translation>Enkelt scan</translation>
    </message>
    <message>
        <source>Step Into</source>
        <translation>Trin ind</translation>
    </message>
    <message>
        <source>Step Over</source>
        <translation>Trin over</translation>
    </message>
    <message>
        <source>Step Out</source>
        <translation>Trin ud</translation>
    </message>
    <message>
        <source>Run to Cursor</source>
        <translation>Kør til markøren</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Slå stoppunkt til/fra</translation>
    </message>
    <message>
        <source>Reset Warm</source>
        <translation>Varm nulstilling</translation>
    </message>
    <message>
        <source>Reset Cold</source>
        <translation>Kold nulstilling</translation>
    </message>
    <message>
        <source>Reset Origin</source>
        <translation>Nulstil til oprindelig tilstand</translation>
    </message>
    <message>
        <source>Online Change</source>
        <translation>Onlineændring</translation>
    </message>
    <message>
        <source>Speed…</source>
        <translation>Hastighed…</translation>
    </message>
    <message>
        <source>Memory for the Recording…</source>
        <translation>Hukommelse til optagelsen…</translation>
    </message>
    <message>
        <source>Save the Recording…</source>
        <translation>Gem optagelsen…</translation>
    </message>
    <message>
        <source>Write Prepared Values</source>
        <translation>Skriv forberedte værdier</translation>
    </message>
    <message>
        <source>Force Prepared Values</source>
        <translation>Forcer forberedte værdier</translation>
    </message>
    <message>
        <source>Release All Forces</source>
        <translation>Ophæv al forcering</translation>
    </message>
    <message>
        <source>Run the Tests</source>
        <translation>Kør testene</translation>
    </message>
    <message>
        <source>One Scan Back</source>
        <translation>Et scan tilbage</translation>
    </message>
    <message>
        <source>One Scan Forward</source>
        <translation>Et scan frem</translation>
    </message>
    <message>
        <source>Back to Live</source>
        <translation>Tilbage til livevisning</translation>
    </message>
    <message>
        <source>Resume from Here</source>
        <translation>Fortsæt herfra</translation>
    </message>
    <message>
        <source>Command Palette</source>
        <translation>Kommandopalet</translation>
    </message>
    <message>
        <source>Split the Editor</source>
        <translation>Del editoren</translation>
    </message>
    <message>
        <source>Declarations as a Table</source>
        <translation>Erklæringer som tabel</translation>
    </message>
    <message>
        <source>Online Values in the Text</source>
        <translation>Onlineværdier i teksten</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Større</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Mindre</translation>
    </message>
    <message>
        <source>Light Theme</source>
        <translation>Lyst tema</translation>
    </message>
    <message>
        <source>Dark Theme</source>
        <translation>Mørkt tema</translation>
    </message>
    <message>
        <source>System Theme</source>
        <translation>Systemets tema</translation>
    </message>
    <message>
        <source>Reset the Layout</source>
        <translation>Nulstil layoutet</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hjælp</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundtur</translation>
    </message>
    <message>
        <source>Open a Recording…</source>
        <translation>Åbn en optagelse…</translation>
    </message>
    <message>
        <source>All values are from a recording file. Click to go back to the controller.</source>
        <translation>Alle værdier er fra en optagelse i en fil. Et klik fører tilbage til styringen.</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>OPTAGELSE</translation>
    </message>
    <message>
        <source>%1 – back to live</source>
        <translation>%1 – tilbage til livevisning</translation>
    </message>
    <message>
        <source>Open a Recording</source>
        <translation>Åbn en optagelse</translation>
    </message>
    <message>
        <source>Show as ST…</source>
        <translation>Vis som ST…</translation>
    </message>
    <message>
        <source>Show as an Instruction List…</source>
        <translation>Vis som instruktionsliste…</translation>
    </message>
    <message>
        <source>New Trace…</source>
        <translation>Ny trace…</translation>
    </message>
    <message>
        <source>The build was cancelled; everything is as it was</source>
        <translation>Oversættelsen blev afbrudt; alt er som før</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Tests</translation>
    </message>
    <message>
        <source>The tests were cancelled</source>
        <translation>Testene blev afbrudt</translation>
    </message>
    <message>
        <source>Cancelled: nothing was saved</source>
        <translation>Annulleret: intet blev gemt</translation>
    </message>
    <message>
        <source>%1 is encoded in %2 and will be saved in that encoding</source>
        <translation>%1 har tegnkodningen %2 og gemmes i den</translation>
    </message>
    <message>
        <source>This is a copy of the example, in %1: change what you like</source>
        <translation>Dette er en kopi af eksemplet, i %1: ret hvad du vil</translation>
    </message>
    <message>
        <source>This is your copy of the example, in %1</source>
        <translation>Dette er din kopi af eksemplet, i %1</translation>
    </message>
    <message>
        <source>The language changes when the tests have ended</source>
        <translation>Sproget skifter, når testene er færdige</translation>
    </message>
    <message>
        <source>Controller fault</source>
        <translation>Styringsfejl</translation>
    </message>
    <message>
        <source>RUN %1</source>
        <translation>RUN %1</translation>
    </message>
    <message>
        <source>at full speed</source>
        <translation>så hurtigt som muligt</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Speed of the controller; any factor can be entered:</source>
        <translation>Styringens hastighed; enhver faktor kan indtastes:</translation>
    </message>
    <message>
        <source>The speed is a factor from 0.001 to 10000</source>
        <translation>Hastigheden er en faktor fra 0,001 til 10000</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importer…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksporter…</translation>
    </message>
    <message>
        <source>The project was exported</source>
        <translation>Projektet blev eksporteret</translation>
    </message>
    <message>
        <source>Add Next Occurrence to Selection</source>
        <translation>Vælg også næste forekomst</translation>
    </message>
    <message>
        <source>Arrange for Editing</source>
        <translation>Arranger til redigering</translation>
    </message>
    <message>
        <source>Arrange for Debugging</source>
        <translation>Arranger til fejlfinding</translation>
    </message>
    <message>
        <source>Arrange for Drawing Panels</source>
        <translation>Arranger til tegning af paneler</translation>
    </message>
    <message>
        <source>Maximise the Editor</source>
        <translation>Maksimer editoren</translation>
    </message>
    <message>
        <source>Keeping the recording of the last run…</source>
        <translation>Optagelsen af den seneste kørsel gemmes…</translation>
    </message>
    <message>
        <source>Diagram Beside the Text</source>
        <translation>Diagram ved siden af teksten</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>Bogmærke</translation>
    </message>
    <message>
        <source>Next Bookmark</source>
        <translation>Næste bogmærke</translation>
    </message>
    <message>
        <source>Previous Bookmark</source>
        <translation>Forrige bogmærke</translation>
    </message>
    <message>
        <source>Open Another File Beside…</source>
        <translation>Åbn en anden fil ved siden af…</translation>
    </message>
    <message>
        <source>About This Project</source>
        <translation>Om dette projekt</translation>
    </message>
    <message>
        <source>The project has no other file</source>
        <translation>Projektet har ingen anden fil</translation>
    </message>
    <message>
        <source>The tour runs on an example, and none is installed: open or create a project and start the tour again</source>
        <translation>Rundturen bruger et eksempel, og der er ikke installeret noget: åbn eller opret et projekt, og start rundturen igen</translation>
    </message>
    <message>
        <source>Open Another File Beside</source>
        <translation>Åbn en anden fil ved siden af</translation>
    </message>
    <message>
        <source>%1 Nothing can break: the plant is only a simulation. Press Next to look around for a minute, or F5 to run it straight away.</source>
        <translation>%1 Intet kan gå i stykker: Anlægget er kun en simulering. Tryk på Næste for at se dig om i et minut, eller på F5 for at køre det med det samme.</translation>
    </message>
    <message>
        <source>This is the project %1.</source>
        <translation>Dette er projektet %1.</translation>
    </message>
    <message>
        <source>What to press</source>
        <translation>Hvad du skal trykke på</translation>
    </message>
    <message>
        <source>The page next to the program is the project&apos;s README: what it shows, what to press, what to watch.</source>
        <translation>Siden ved siden af programmet er projektets README: hvad det viser, hvad du skal trykke på, og hvad du skal overvåge.</translation>
    </message>
    <message>
        <source>What the operator sees. This project has no panel yet; new ones are drawn with the mouse.</source>
        <translation>Hvad operatøren ser. Dette projekt har endnu intet panel; nye tegnes med musen.</translation>
    </message>
    <message>
        <source>Drag the time slider, or press Alt+PgUp: code, charts and panel show the past. “Resume from Here” continues from there.</source>
        <translation>Træk tidsskyderen, eller tryk på Alt+PgUp: kode, diagrammer og panel viser fortiden. ”Fortsæt herfra” kører videre derfra.</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Regulatorindstilling</translation>
    </message>
    <message>
        <source>Walk Through the Scan</source>
        <translation>Gå gennem scannet</translation>
    </message>
    <message>
        <source>Step Back In</source>
        <translation>Trin tilbage ind</translation>
    </message>
    <message>
        <source>Step Back Over</source>
        <translation>Trin tilbage over</translation>
    </message>
    <message>
        <source>Step Back Out</source>
        <translation>Trin tilbage ud</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Hvorfor?</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>Hvorfor ikke?</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>Hvem satte det?</translation>
    </message>
    <message>
        <source>What If…</source>
        <translation>Hvad nu hvis…</translation>
    </message>
    <message>
        <source>Coverage of the Recording</source>
        <translation>Optagelsens dækning</translation>
    </message>
    <message>
        <source>Hide the Coverage</source>
        <translation>Skjul dækningen</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Hvorfor</translation>
    </message>
    <message>
        <source>Slow Scan</source>
        <translation>Langsomt scan</translation>
    </message>
    <message>
        <source>What if? needs a running controller: a recording from a file cannot be resumed; press F5 to run the program</source>
        <translation>”Hvad nu hvis” kræver en kørende styring: En optagelse fra en fil kan ikke fortsættes; tryk på F5 for at køre programmet</translation>
    </message>
    <message>
        <source>Explain the Problem</source>
        <translation>Forklar problemet</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recepter</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Brugere og rettigheder</translation>
    </message>
    <message>
        <source>Connect or Disconnect the Devices</source>
        <translation>Forbind eller afbryd enhederne</translation>
    </message>
    <message>
        <source>Hide Dock Automatically</source>
        <translation>Skjul vinduet automatisk</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Enheder</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Stepwise %1&lt;/h3&gt;&lt;p&gt;An open PLC studio: IEC 61131-3 programs as native code, every scan recorded, operator panels in many languages.&lt;/p&gt;&lt;p&gt;Licence: GPL-3.0&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Stepwise %1&lt;/h3&gt;&lt;p&gt;Et åbent PLC-studie: IEC 61131-3-programmer som maskinkode, hvert scan optaget, betjeningspaneler på mange sprog.&lt;/p&gt;&lt;p&gt;Licens: GPL-3.0&lt;/p&gt;</translation>
    </message>
    <message>
        <source>High-Contrast Theme</source>
        <translation>Tema med høj kontrast</translation>
    </message>
    <message>
        <source>Attach to a Controller…</source>
        <translation>Forbind med en styring…</translation>
    </message>
    <message>
        <source>Detach from the Controller</source>
        <translation>Afbryd forbindelsen til styringen</translation>
    </message>
    <message>
        <source>Build a Native Program…</source>
        <translation>Byg et selvstændigt program…</translation>
    </message>
    <message>
        <source>%1 arranges the window for drawing panels</source>
        <translation>%1 indretter vinduet til at tegne paneler</translation>
    </message>
    <message>
        <source>Close Other Documents</source>
        <translation>Luk andre dokumenter</translation>
    </message>
    <message>
        <source>Fold or Unfold the Block</source>
        <translation>Klap blokken sammen eller ud</translation>
    </message>
    <message>
        <source>Fold or Unfold All</source>
        <translation>Klap alt sammen eller ud</translation>
    </message>
    <message>
        <source>Previous Pass of the Loop</source>
        <translation>Forrige gennemløb af løkken</translation>
    </message>
    <message>
        <source>Next Pass of the Loop</source>
        <translation>Næste gennemløb af løkken</translation>
    </message>
    <message>
        <source>Context Menu</source>
        <translation>Genvejsmenu</translation>
    </message>
    <message>
        <source>Columns…</source>
        <translation>Kolonner…</translation>
    </message>
    <message>
        <source>Move Dock to the Next Side</source>
        <translation>Flyt vinduet til næste side</translation>
    </message>
    <message>
        <source>Float or Dock Again</source>
        <translation>Frigør eller fastgør igen</translation>
    </message>
    <message>
        <source>Next Pane</source>
        <translation>Næste rude</translation>
    </message>
    <message>
        <source>Previous Pane</source>
        <translation>Forrige rude</translation>
    </message>
    <message>
        <source>Wider Pane</source>
        <translation>Gør ruden bredere</translation>
    </message>
    <message>
        <source>Narrower Pane</source>
        <translation>Gør ruden smallere</translation>
    </message>
    <message>
        <source>Taller Pane</source>
        <translation>Gør ruden højere</translation>
    </message>
    <message>
        <source>Shorter Pane</source>
        <translation>Gør ruden lavere</translation>
    </message>
    <message>
        <source>Move Document Left</source>
        <translation>Flyt dokumentet til venstre</translation>
    </message>
    <message>
        <source>Move Document Right</source>
        <translation>Flyt dokumentet til højre</translation>
    </message>
    <message>
        <source>Show Tooltip at the Cursor</source>
        <translation>Vis værktøjstip ved markøren</translation>
    </message>
    <message>
        <source>There are no columns here; go to a table or a list with columns first</source>
        <translation>Der er ingen kolonner her; gå først til en tabel eller en liste med kolonner</translation>
    </message>
    <message>
        <source>Project Settings…</source>
        <translation>Projektindstillinger…</translation>
    </message>
    <message>
        <source>Panel Themes…</source>
        <translation>Panelernes temaer…</translation>
    </message>
</context>
<context>
    <name>plc::app::Menu</name>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Rediger</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Kør</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hjælp</translation>
    </message>
    <message>
        <source>Go To</source>
        <translation>Gå til</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Bogmærker</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Nulstilling</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Optagelse</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Layout</translation>
    </message>
    <message>
        <source>Docks</source>
        <translation>Vinduer</translation>
    </message>
    <message>
        <source>Folding</source>
        <translation>Sammenklapning</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Ruder</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Søg</translation>
    </message>
</context>
<context>
    <name>plc::app::MergeDialog</name>
    <message>
        <source>Compare %1</source>
        <translation>Sammenlign %1</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Forrige</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Næste</translation>
    </message>
    <message>
        <source>Take Over</source>
        <translation>Overtag</translation>
    </message>
    <message>
        <source>Take Over All</source>
        <translation>Overtag alle</translation>
    </message>
    <message>
        <source>Here (this text is kept)</source>
        <translation>Her (denne tekst beholdes)</translation>
    </message>
    <message>
        <source>On disk</source>
        <translation>På disken</translation>
    </message>
    <message>
        <source>Use the Text on the Left</source>
        <translation>Brug teksten til venstre</translation>
    </message>
    <message>
        <source>No differences</source>
        <translation>Ingen forskelle</translation>
    </message>
    <message>
        <source>Difference %1 of %2</source>
        <translation>Forskel %1 af %2</translation>
    </message>
</context>
<context>
    <name>plc::app::NativeProgramDialog</name>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Byg</translation>
    </message>
    <message>
        <source>Build a Native Program</source>
        <translation>Byg et selvstændigt program</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Vælg filen</translation>
    </message>
    <message>
        <source>Native Program</source>
        <translation>Selvstændigt program</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maskine</translation>
    </message>
    <message>
        <source>The program runs without Stepwise on a machine with Linux: its PLC code and a small runner in one file.</source>
        <translation>Programmet kører uden Stepwise på en maskine med Linux: dets PLC-kode og et lille kørselssystem i én fil.</translation>
    </message>
    <message>
        <source>Building…</source>
        <translation>Bygger…</translation>
    </message>
    <message>
        <source>%1 is built</source>
        <translation>%1 er bygget</translation>
    </message>
</context>
<context>
    <name>plc::app::NewProjectDialog</name>
    <message>
        <source>Empty</source>
        <translation>Tomt</translation>
    </message>
    <message>
        <source>One program in a task of 10 ms</source>
        <translation>Ét program i en task på 10&#xa0;ms</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Start, stop, a simulated motor and a test</source>
        <translation>Start, stop, en simuleret motor og en test</translation>
    </message>
    <message>
        <source>PID loop</source>
        <translation>PID-sløjfe</translation>
    </message>
    <message>
        <source>A temperature loop with its plant</source>
        <translation>En temperatursløjfe med tilhørende anlæg</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Sekvensstyring</translation>
    </message>
    <message>
        <source>Fill, mix, empty as a sequential function chart</source>
        <translation>Fyld, bland, tøm som SFC-diagram</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Nyt projekt</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Skabelon</translation>
    </message>
    <message>
        <source>My machine</source>
        <translation>Min maskine</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Vælg en mappe</translation>
    </message>
    <message>
        <source>Folder of the project</source>
        <translation>Projektets mappe</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>In folder</source>
        <translation>I mappen</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Opret</translation>
    </message>
    <message>
        <source>Enter a project name</source>
        <translation>Angiv et projektnavn</translation>
    </message>
    <message>
        <source>%1 already exists and is not empty; choose another name</source>
        <translation>%1 findes allerede og er ikke tom; vælg et andet navn</translation>
    </message>
    <message>
        <source>Will be created in %1</source>
        <translation>Oprettes i %1</translation>
    </message>
</context>
<context>
    <name>plc::app::NewUnitDialog</name>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>Function block</source>
        <translation>Funktionsblok</translation>
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
        <translation>Interface</translation>
    </message>
    <message>
        <source>Global variables</source>
        <translation>Globale variabler</translation>
    </message>
    <message>
        <source>Sequential function chart</source>
        <translation>SFC-diagram</translation>
    </message>
    <message>
        <source>Simulation of the plant</source>
        <translation>Simulering af anlægget</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Ny</translation>
    </message>
    <message>
        <source>a file of its own</source>
        <translation>en fil for sig selv</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>In</source>
        <translation>I</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Opret</translation>
    </message>
    <message>
        <source>Enter a name</source>
        <translation>Angiv et navn</translation>
    </message>
    <message>
        <source>A name has letters, digits and _, starts with a letter and is not a keyword</source>
        <translation>Et navn består af bogstaver, cifre og _, begynder med et bogstav og er ikke et nøgleord</translation>
    </message>
    <message>
        <source>%1 already exists in the project; choose another name</source>
        <translation>Der er allerede en %1 i projektet; vælg et andet navn</translation>
    </message>
    <message>
        <source>A file %1 already exists: choose it, or another name</source>
        <translation>Der er allerede en fil %1: vælg den eller et andet navn</translation>
    </message>
    <message>
        <source>Program as a ladder diagram</source>
        <translation>Program som ladderdiagram</translation>
    </message>
    <message>
        <source>Program as a function block diagram</source>
        <translation>Program som funktionsblokdiagram</translation>
    </message>
</context>
<context>
    <name>plc::app::PanelFiles</name>
    <message>
        <source>Texts</source>
        <translation>Tekster</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmer</translation>
    </message>
    <message>
        <source>Panel %1</source>
        <translation>Panel %1</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recepter</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Brugere og rettigheder</translation>
    </message>
    <message>
        <source>%1 is gone or cannot be reached: what is open stays here, and Save All writes it again</source>
        <translation>%1 er væk eller kan ikke nås: det åbne bliver her, og Gem alle skriver det igen</translation>
    </message>
</context>
<context>
    <name>plc::app::ProblemsView</name>
    <message>
        <source>Message</source>
        <translation>Meddelelse</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Kode</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Sted</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemer</translation>
    </message>
    <message>
        <source>Show errors</source>
        <translation>Vis fejl</translation>
    </message>
    <message>
        <source>Show warnings</source>
        <translation>Vis advarsler</translation>
    </message>
    <message>
        <source>Show notes</source>
        <translation>Vis bemærkninger</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter of the problem list</source>
        <translation>Filter til problemlisten</translation>
    </message>
</context>
<context>
    <name>plc::app::ProjectSettingsDialog</name>
    <message>
        <source>Project Settings</source>
        <translation>Projektindstillinger</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>Bytes: %MW1 is bytes 1 and 2 (TwinCAT)</source>
        <translation>Byte: %MW1 er byte 1 og 2 (TwinCAT)</translation>
    </message>
    <message>
        <source>Words: %MW1 is the second word (CODESYS)</source>
        <translation>Ord: %MW1 er det andet ord (CODESYS)</translation>
    </message>
    <message>
        <source> bytes</source>
        <translation> byte</translation>
    </message>
    <message>
        <source>None (no __NEW)</source>
        <translation>Ingen (intet __NEW)</translation>
    </message>
    <message>
        <source>What the number of a memory address counts</source>
        <translation>Hvad nummeret i en hukommelsesadresse tæller</translation>
    </message>
    <message>
        <source>What the bytes of STRING values stand for</source>
        <translation>Hvad byte i STRING-værdier står for</translation>
    </message>
    <message>
        <source>What {IF defined (…)} in the sources finds, separated by commas</source>
        <translation>Det som {IF defined (…)} i kildeteksten finder, adskilt af kommaer</translation>
    </message>
    <message>
        <source>The part of the controller&apos;s memory that __NEW takes objects from</source>
        <translation>Den del af styringens hukommelse som __NEW tager objekter fra</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Addressing</source>
        <translation>Adressering</translation>
    </message>
    <message>
        <source>Encoding of STRING</source>
        <translation>Tegnkodning af STRING</translation>
    </message>
    <message>
        <source>Defined symbols</source>
        <translation>Definerede symboler</translation>
    </message>
    <message>
        <source>Memory for __NEW</source>
        <translation>Hukommelse til __NEW</translation>
    </message>
    <message>
        <source>Date and time of the first scan</source>
        <translation>Dato og klokkeslæt for første scan</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Paneler</translation>
    </message>
    <message>
        <source>The first panel</source>
        <translation>Det første panel</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>Allow pictures outside the project folder</source>
        <translation>Tillad billeder uden for projektmappen</translation>
    </message>
    <message>
        <source>The panel that is drawn around all others</source>
        <translation>Panelet der tegnes rundt om alle andre</translation>
    </message>
    <message>
        <source>A variable with the operator&apos;s language; panels read and write it</source>
        <translation>En variabel med operatørens sprog; paneler læser og skriver den</translation>
    </message>
    <message>
        <source>Start panel</source>
        <translation>Startpanel</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Ramme</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Skrifttype</translation>
    </message>
    <message>
        <source>Language variable</source>
        <translation>Sprogvariabel</translation>
    </message>
    <message>
        <source>A project needs a name.</source>
        <translation>Et projekt skal have et navn.</translation>
    </message>
    <message>
        <source>“%1” is not a date and time; write for example DT#2026-01-31-06:00:00.</source>
        <translation>”%1” er ikke en dato med klokkeslæt; skriv f.eks. DT#2026-01-31-06:00:00.</translation>
    </message>
</context>
<context>
    <name>plc::app::ProjectTree</name>
    <message>
        <source>Source of %1 with the Values of %2</source>
        <translation>Kildetekst til %1 med værdierne fra %2</translation>
    </message>
    <message>
        <source>Values of Instance</source>
        <translation>Instansens værdier</translation>
    </message>
    <message>
        <source>More: choose in the watch</source>
        <translation>Flere: vælg i overvågningen</translation>
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
        <translation>Filter til projekttræet</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>SFC-diagram</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programmer</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blokke</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>Funktioner</translation>
    </message>
    <message>
        <source>Types</source>
        <translation>Typer</translation>
    </message>
    <message>
        <source>Globals</source>
        <translation>Globale variabler</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tasks</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulering</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Paneler</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Tekster</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmer</translation>
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
        <translation>Biblioteker</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Ny…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Åbn</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Omdøb…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Slet…</translation>
    </message>
    <message>
        <source>Libraries…</source>
        <translation>Biblioteker…</translation>
    </message>
    <message>
        <source>Run Tests</source>
        <translation>Kør tests</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Føj til overvågning</translation>
    </message>
    <message>
        <source>Arrange by file</source>
        <translation>Ordn efter fil</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Filer</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recepter</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Brugere og rettigheder</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Enheder</translation>
    </message>
    <message>
        <source>Panel Themes</source>
        <translation>Panelernes temaer</translation>
    </message>
</context>
<context>
    <name>plc::app::RenameDialog</name>
    <message>
        <source>Rename</source>
        <translation>Omdøb</translation>
    </message>
    <message>
        <source>New name of %1, in the whole project:</source>
        <translation>Nyt navn til %1, i hele projektet:</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Sted</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>Places that change</source>
        <translation>Steder, der ændres</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) change:</source>
        <translation>
            <numerusform>%n sted ændres:</numerusform>
            <numerusform>%n steder ændres:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::app::RunsMenu</name>
    <message>
        <source>Earlier Runs</source>
        <translation>Tidligere kørsler</translation>
    </message>
    <message>
        <source>%1, ended by a fault, %2</source>
        <translation>%1, afsluttet af en fejl, %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The last run is being written…</source>
        <translation>Den seneste kørsel skrives…</translation>
    </message>
    <message>
        <source>No run has ended yet</source>
        <translation>Ingen kørsel er slut endnu</translation>
    </message>
</context>
<context>
    <name>plc::app::SearchView</name>
    <message>
        <source>Find in all files</source>
        <translation>Søg i alle filer</translation>
    </message>
    <message>
        <source>Text to find in all files</source>
        <translation>Tekst at søge efter i alle filer</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Erstat med</translation>
    </message>
    <message>
        <source>Replacement in all files</source>
        <translation>Erstatning i alle filer</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>Regulært udtryk</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Store/små bogstaver</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Søg</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>Erstat alle</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Sted</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Brug</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linje</translation>
    </message>
    <message>
        <source>Search results</source>
        <translation>Søgeresultater</translation>
    </message>
    <message>
        <source>Invalid regular expression: %1</source>
        <translation>Ugyldigt regulært udtryk: %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 i %2</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n sted</numerusform>
            <numerusform>%n steder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n fil</numerusform>
            <numerusform>%n filer</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced</source>
        <translation>
            <numerusform>%n sted erstattet</numerusform>
            <numerusform>%n steder erstattet</numerusform>
        </translation>
    </message>
    <message>
        <source>declared</source>
        <translation>erklæret</translation>
    </message>
    <message>
        <source>read, write</source>
        <translation>læst, skrevet</translation>
    </message>
    <message>
        <source>write</source>
        <translation>skrevet</translation>
    </message>
    <message>
        <source>read</source>
        <translation>læst</translation>
    </message>
    <message>
        <source>%1: %2 read, %3 written</source>
        <translation>%1: læst %2, skrevet %3</translation>
    </message>
    <message>
        <source>Searching all files…</source>
        <translation>Søger i alle filer…</translation>
    </message>
    <message>
        <source>Cancelled; so far: %1 in %2</source>
        <translation>Afbrudt; indtil da: %1 i %2</translation>
    </message>
    <message>
        <source>Replacing in all files…</source>
        <translation>Erstatter i alle filer…</translation>
    </message>
    <message>
        <source>Cancelled; nothing was replaced</source>
        <translation>Afbrudt; intet blev erstattet</translation>
    </message>
</context>
<context>
    <name>plc::app::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Indstillinger</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Generelt</translation>
    </message>
    <message>
        <source>Editor</source>
        <translation>Editor</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Kørsel</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Genveje</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Som systemet</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lyst</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Mørkt</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Language of the studio</source>
        <translation>Studiets sprog</translation>
    </message>
    <message>
        <source>Indentation</source>
        <translation>Indrykning</translation>
    </message>
    <message>
        <source>Write keywords in capitals while typing</source>
        <translation>Ændr nøgleord til store bogstaver under indtastning</translation>
    </message>
    <message>
        <source>Close blocks with Enter (IF … END_IF)</source>
        <translation>Luk blokke med Enter (IF … END_IF)</translation>
    </message>
    <message>
        <source>Show online values in the text</source>
        <translation>Vis onlineværdier i teksten</translation>
    </message>
    <message>
        <source>Format when saving</source>
        <translation>Formater ved lagring</translation>
    </message>
    <message>
        <source>Apply an online change when saving</source>
        <translation>Udfør onlineændring, når der gemmes</translation>
    </message>
    <message>
        <source>Memory for the recording of every scan</source>
        <translation>Hukommelse til optagelsen af hvert scan</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Kommando</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Genvej</translation>
    </message>
    <message>
        <source>Another action has the same shortcut</source>
        <translation>En anden kommando har samme genvej</translation>
    </message>
    <message>
        <source>Shortcut of %1</source>
        <translation>Genvej for %1</translation>
    </message>
    <message>
        <source>Filter of the actions</source>
        <translation>Filter for kommandoerne</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Gendan standarder</translation>
    </message>
    <message>
        <source>%1 is now assigned to “%2” instead of “%3”.</source>
        <translation>%1 er nu tildelt ”%2” i stedet for ”%3”.</translation>
    </message>
    <message>
        <source>none is kept</source>
        <translation>ingen gemmes</translation>
    </message>
    <message>
        <source>Disk space for the recordings of earlier runs, per project</source>
        <translation>Diskplads til optagelser af tidligere kørsler, pr. projekt</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Høj kontrast</translation>
    </message>
</context>
<context>
    <name>plc::app::SideBars</name>
    <message>
        <source>Hide Automatically</source>
        <translation>Skjul automatisk</translation>
    </message>
    <message>
        <source>Keep Open</source>
        <translation>Hold åben</translation>
    </message>
    <message>
        <source>Hidden Docks</source>
        <translation>Skjulte vinduer</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Frigør</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Luk</translation>
    </message>
</context>
<context>
    <name>plc::app::StPage</name>
    <message>
        <source>This file is read-only on disk. Saving asks before it replaces it.</source>
        <translation>Filen er skrivebeskyttet. Der spørges, før den erstattes ved lagring.</translation>
    </message>
    <message>
        <source>Make Writable</source>
        <translation>Fjern skrivebeskyttelsen</translation>
    </message>
    <message>
        <source>Close this side</source>
        <translation>Luk denne side</translation>
    </message>
</context>
<context>
    <name>plc::app::StartPage</name>
    <message>
        <source>Write, run and watch PLC programs. Every scan is recorded; time runs backwards, too.</source>
        <translation>Skriv, kør og overvåg PLC-programmer. Hvert scan optages; tiden går også baglæns.</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Seneste projekter</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Eksempler</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>Nyt projekt…</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>Åbn projekt…</translation>
    </message>
    <message>
        <source>Take the Tour</source>
        <translation>Tag rundturen</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Seneste</translation>
    </message>
    <message>
        <source>Examples: open one and press Run</source>
        <translation>Eksempler: åbn et, og tryk Kør</translation>
    </message>
    <message>
        <source>No examples were found in:
%1

Install the examples, or set the environment variable STEPWISE_EXAMPLES to the folder that contains them, and start Stepwise again.</source>
        <translation>Der blev ikke fundet eksempler i:
%1

Installér eksemplerne, eller sæt miljøvariablen STEPWISE_EXAMPLES til den mappe, de ligger i, og start Stepwise igen.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Åbn</translation>
    </message>
    <message>
        <source>Open a Fresh Copy</source>
        <translation>Åbn en ny kopi</translation>
    </message>
</context>
<context>
    <name>plc::app::TestView</name>
    <message>
        <source>Run all tests</source>
        <translation>Kør alle tests</translation>
    </message>
    <message>
        <source>Run the selected tests</source>
        <translation>Kør de valgte tests</translation>
    </message>
    <message>
        <source>Run the failed tests</source>
        <translation>Kør de fejlede tests</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultat</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Tests</translation>
    </message>
    <message>
        <source>%1 passed, %2 failed</source>
        <translation>%1 bestået, %2 fejlet</translation>
    </message>
    <message>
        <source>not run yet</source>
        <translation>endnu ikke kørt</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestået</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fejlet</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>Show the Recording of the Failure</source>
        <translation>Vis optagelsen af fejlen</translation>
    </message>
    <message>
        <source>Show what the tests cover</source>
        <translation>Vis, hvad testene dækker</translation>
    </message>
</context>
<context>
    <name>plc::app::TextPage</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Linje %1: %2</translation>
    </message>
</context>
<context>
    <name>plc::app::Tour</name>
    <message>
        <source>Back</source>
        <translation>Tilbage</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Næste</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Afslut rundturen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 af %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Færdig</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundtur</translation>
    </message>
</context>
<context>
    <name>plc::app::UnitCommands</name>
    <message>
        <source>The program is running. To an online change the new name is another variable: it begins with its initial value.</source>
        <translation>Programmet kører. For en onlineændring er det nye navn en anden variabel: Den begynder med sin startværdi.</translation>
    </message>
    <message>
        <source>Go to Line</source>
        <translation>Gå til linje</translation>
    </message>
    <message>
        <source>Line (1 to %1)</source>
        <translation>Linje (1 til %1)</translation>
    </message>
    <message>
        <source>Nothing is declared under this name; declare it or check the name</source>
        <translation>Intet er erklæret under dette navn; erklær det, eller kontroller det</translation>
    </message>
    <message>
        <source>Put the cursor into a unit that is written in ST or IL</source>
        <translation>Sæt markøren i en programenhed, der er skrevet i ST eller IL</translation>
    </message>
    <message>
        <source>The text has changed meanwhile</source>
        <translation>Teksten er ændret i mellemtiden</translation>
    </message>
    <message>
        <source>There is no name at the cursor; put the cursor on one</source>
        <translation>Der er intet navn ved markøren; sæt markøren på et</translation>
    </message>
    <message>
        <source>The project is still being checked; try again in a moment</source>
        <translation>Projektet kontrolleres stadig; prøv igen om et øjeblik</translation>
    </message>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s); the panels are saved, the sources not yet</source>
        <translation>
            <numerusform>%1 hedder nu %2, %n sted; panelerne er gemt, kilderne endnu ikke</numerusform>
            <numerusform>%1 hedder nu %2, %n steder; panelerne er gemt, kilderne endnu ikke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s)</source>
        <translation>
            <numerusform>%1 hedder nu %2, %n sted</numerusform>
            <numerusform>%1 hedder nu %2, %n steder</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>Slet %1?</translation>
    </message>
    <message numerus="yes">
        <source>It is used in %n other place(s).</source>
        <translation>
            <numerusform>Den bruges %n andet sted.</numerusform>
            <numerusform>Den bruges %n andre steder.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Slet</translation>
    </message>
    <message>
        <source>Delete and Comment Out the Uses</source>
        <translation>Slet, og udkommenter anvendelserne</translation>
    </message>
    <message>
        <source>Show the Uses</source>
        <translation>Vis anvendelserne</translation>
    </message>
    <message>
        <source>%1 is not a source of this project; open the project that contains it</source>
        <translation>%1 er ikke en kildefil i dette projekt; åbn det projekt, der indeholder den</translation>
    </message>
</context>
<context>
    <name>plc::app::WhatIfDialog</name>
    <message>
        <source>What If?</source>
        <translation>Hvad nu hvis?</translation>
    </message>
    <message>
        <source>The controller goes back to the scan shown and continues from there with these values. The trace draws what really happened behind the new curves.</source>
        <translation>Styringen går tilbage til det scan, der vises, og kører videre derfra med disse værdier. Tracen tegner det, der faktisk skete, bagved.</translation>
    </message>
    <message>
        <source>A variable, such as Main.level</source>
        <translation>En variabel, for eksempel Main.level</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Tilføj</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variabel</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>Var</translation>
    </message>
    <message>
        <source>Instead</source>
        <translation>I stedet</translation>
    </message>
    <message>
        <source>Values to change</source>
        <translation>Værdier, der ændres</translation>
    </message>
    <message>
        <source>Run from Here</source>
        <translation>Kør herfra</translation>
    </message>
    <message>
        <source>%1 has no value in this scan; choose another variable</source>
        <translation>%1 har ingen værdi i dette scan; vælg en anden variabel</translation>
    </message>
    <message>
        <source>Enter a different value for at least one variable</source>
        <translation>Giv mindst én variabel en anden værdi</translation>
    </message>
</context>
<context>
    <name>plc::editor::BreakpointView</name>
    <message>
        <source>Place</source>
        <translation>Sted</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Betingelse</translation>
    </message>
    <message>
        <source>Hit count</source>
        <translation>Antal træf</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>Instans</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>Stoppunkter</translation>
    </message>
    <message>
        <source>Remove selected</source>
        <translation>Fjern valgte</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Fjern alle</translation>
    </message>
    <message>
        <source>The running program has no code at or below this line; choose a line with a statement</source>
        <translation>Programmet, der kører, har ingen kode i denne linje eller under den; vælg en linje med en sætning</translation>
    </message>
</context>
<context>
    <name>plc::editor::CallPathView</name>
    <message>
        <source>Unit</source>
        <translation>Programenhed</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>Instans</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linje</translation>
    </message>
    <message>
        <source>Call stack</source>
        <translation>Kaldestak</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variabel</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Værdi</translation>
    </message>
    <message>
        <source>Values of the frame</source>
        <translation>Kaldets værdier</translation>
    </message>
    <message>
        <source>This scan has run to its end: it has no call stack.</source>
        <translation>Dette scan er kørt til ende: det har ingen kaldestak.</translation>
    </message>
</context>
<context>
    <name>plc::editor::ChartView</name>
    <message>
        <source>Sequential function chart</source>
        <translation>SFC-diagram</translation>
    </message>
    <message>
        <source>Insert a step after it (Ins)</source>
        <translation>Indsæt et trin efter (Ins)</translation>
    </message>
    <message>
        <source>Insert an alternative branch</source>
        <translation>Indsæt en alternativgren</translation>
    </message>
    <message>
        <source>Insert a simultaneous branch</source>
        <translation>Indsæt en parallelgren</translation>
    </message>
    <message>
        <source>Add an action</source>
        <translation>Tilføj en aktion</translation>
    </message>
    <message>
        <source>Edit name or condition (F2)</source>
        <translation>Rediger navn eller betingelse (F2)</translation>
    </message>
    <message>
        <source>Delete (Del)</source>
        <translation>Slet (Del)</translation>
    </message>
    <message>
        <source>The unit %1 is no longer in the text; undo the change or close this view</source>
        <translation>Programenheden %1 er ikke længere i teksten; fortryd ændringen, eller luk denne visning</translation>
    </message>
    <message>
        <source>The text has errors: this is the last valid drawing</source>
        <translation>Teksten har fejl: dette er den sidste gyldige tegning</translation>
    </message>
    <message>
        <source>Select the step from which the branch goes out</source>
        <translation>Vælg det trin, grenen går ud fra</translation>
    </message>
    <message>
        <source>Select the transition after which the steps run at the same time</source>
        <translation>Vælg den transition, efter hvilken trinnene kører samtidig</translation>
    </message>
    <message>
        <source>Select the step that gets the action</source>
        <translation>Vælg det trin, der får aktionen</translation>
    </message>
    <message>
        <source>Insert a Step After It</source>
        <translation>Indsæt et trin efter</translation>
    </message>
    <message>
        <source>Insert an Alternative Branch</source>
        <translation>Indsæt en alternativgren</translation>
    </message>
    <message>
        <source>Insert a Simultaneous Branch</source>
        <translation>Indsæt en parallelgren</translation>
    </message>
    <message>
        <source>Add an Action</source>
        <translation>Tilføj en aktion</translation>
    </message>
    <message>
        <source>Set as Initial Step</source>
        <translation>Gør til starttrin</translation>
    </message>
    <message>
        <source>Force the Step Active</source>
        <translation>Forcer trinnet aktivt</translation>
    </message>
    <message>
        <source>Release the Step</source>
        <translation>Ophæv forcering af trinnet</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Slå stoppunkt til/fra</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Rediger</translation>
    </message>
    <message>
        <source>Move Left</source>
        <translation>Flyt til venstre</translation>
    </message>
    <message>
        <source>Move Right</source>
        <translation>Flyt til højre</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Slet</translation>
    </message>
    <message>
        <source>Branch to the left</source>
        <translation>Gren til venstre</translation>
    </message>
    <message>
        <source>Branch to the right</source>
        <translation>Gren til højre</translation>
    </message>
    <message>
        <source>%1 after this transition</source>
        <translation>%1 efter denne transition</translation>
    </message>
    <message>
        <source>leads to %1</source>
        <translation>fører til %1</translation>
    </message>
    <message>
        <source>further up</source>
        <translation>længere op</translation>
    </message>
    <message>
        <source>further down</source>
        <translation>længere ned</translation>
    </message>
    <message>
        <source>%1 in step %2</source>
        <translation>%1 i trin %2</translation>
    </message>
    <message>
        <source>A condition is a BOOL; add a comparison</source>
        <translation>En betingelse er en BOOL; tilføj en sammenligning</translation>
    </message>
    <message>
        <source>qualifier</source>
        <translation>kvalifikator</translation>
    </message>
    <message>
        <source>action</source>
        <translation>aktion</translation>
    </message>
    <message>
        <source>To the enclosing chart (Backspace)</source>
        <translation>Til det overordnede SFC-diagram (Backspace)</translation>
    </message>
    <message>
        <source>Breakpoint: stops when the step becomes active or the transition is taken (F9)</source>
        <translation>Stoppunkt: stopper, når trinnet bliver aktivt, eller transitionen udløses (F9)</translation>
    </message>
    <message>
        <source>Force the step active</source>
        <translation>Forcer trinnet aktivt</translation>
    </message>
    <message>
        <source>Release the step</source>
        <translation>Ophæv forcering af trinnet</translation>
    </message>
    <message>
        <source>%1 is a variable: it has no body</source>
        <translation>%1 er en variabel: den har ingen krop</translation>
    </message>
    <message>
        <source>Select a step or a transition</source>
        <translation>Vælg et trin eller en transition</translation>
    </message>
    <message>
        <source>Select a step</source>
        <translation>Vælg et trin</translation>
    </message>
    <message>
        <source>Open Its Chart or Text</source>
        <translation>Åbn dets SFC-diagram eller tekst</translation>
    </message>
    <message>
        <source>Priority…</source>
        <translation>Prioritet…</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Flyt op</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Flyt ned</translation>
    </message>
    <message>
        <source>Delete the Whole Branch</source>
        <translation>Slet hele grenen</translation>
    </message>
    <message>
        <source>Select what is to be copied</source>
        <translation>Vælg det, der skal kopieres</translation>
    </message>
    <message>
        <source>Select what is to be cut</source>
        <translation>Vælg det, der skal klippes</translation>
    </message>
    <message>
        <source>The clipboard contains no step, action or transition; copy one first</source>
        <translation>Udklipsholderen indeholder intet trin, ingen aktion og ingen transition; kopier først en af dem</translation>
    </message>
    <message>
        <source>Select the step or transition to paste after</source>
        <translation>Vælg det trin eller den transition, der skal indsættes efter</translation>
    </message>
    <message>
        <source>Select the transition that gets the condition</source>
        <translation>Vælg den transition, der får betingelsen</translation>
    </message>
    <message>
        <source>Start a Chart</source>
        <translation>Start et SFC-diagram</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Klip</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopier</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Sæt ind</translation>
    </message>
    <message>
        <source>%1 has no chart yet. A chart starts with an initial step; more steps are inserted after it with Ins, and F2 edits names and conditions.</source>
        <translation>%1 har endnu intet SFC-diagram. Et SFC-diagram begynder med et starttrin; flere trin indsættes efter det med Ins, og F2 redigerer navne og betingelser.</translation>
    </message>
    <message>
        <source>%1 is not a chart: its body has statements. A chart can be started in a program or function block whose body is empty.</source>
        <translation>%1 er ikke et SFC-diagram: Kroppen indeholder sætninger. Et SFC-diagram kan startes i et program eller en funktionsblok med tom krop.</translation>
    </message>
</context>
<context>
    <name>plc::editor::DeclarationTable</name>
    <message>
        <source>Section</source>
        <translation>Afsnit</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Initial value</source>
        <translation>Startværdi</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Værdi</translation>
    </message>
    <message>
        <source>Declarations</source>
        <translation>Erklæringer</translation>
    </message>
    <message>
        <source>Add a variable</source>
        <translation>Tilføj en variabel</translation>
    </message>
    <message>
        <source>Remove the selected variables</source>
        <translation>Fjern de valgte variabler</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Flyt op</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Flyt ned</translation>
    </message>
</context>
<context>
    <name>plc::editor::EventLog</name>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>PLC time</source>
        <translation>PLC-tid</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Hændelse</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Hændelser</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Ryd</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all rows</source>
        <translation>Kopier de valgte rækker, ellers alle</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopier</translation>
    </message>
    <message>
        <source>Only faults and rejections</source>
        <translation>Kun fejl og afvisninger</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter of the events</source>
        <translation>Filter for hændelserne</translation>
    </message>
    <message>
        <source>Step: %1</source>
        <translation>Trin: %1</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>event at file:line</comment>
        <translation>%1 ved %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::FindBar</name>
    <message>
        <source>Find</source>
        <translation>Søg</translation>
    </message>
    <message>
        <source>Text to find</source>
        <translation>Tekst at søge efter</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Erstat med</translation>
    </message>
    <message>
        <source>Replacement</source>
        <translation>Erstatning</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Store/små bogstaver</translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>Hele ord</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>Regulært udtryk</translation>
    </message>
    <message>
        <source>Previous (Shift+Enter)</source>
        <translation>Forrige (Skift+Enter)</translation>
    </message>
    <message>
        <source>Next (Enter)</source>
        <translation>Næste (Enter)</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Luk (Esc)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Erstat</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>Erstat alle</translation>
    </message>
    <message numerus="yes">
        <source>%n replaced</source>
        <translation>
            <numerusform>%n erstattet</numerusform>
            <numerusform>%n erstattet</numerusform>
        </translation>
    </message>
    <message>
        <source>invalid regular expression</source>
        <translation>ugyldigt regulært udtryk</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n fundet</numerusform>
            <numerusform>%n fundet</numerusform>
        </translation>
    </message>
    <message>
        <source>not found</source>
        <translation>ikke fundet</translation>
    </message>
</context>
<context>
    <name>plc::editor::ForceView</name>
    <message>
        <source>Variable</source>
        <translation>Variabel</translation>
    </message>
    <message>
        <source>Forced value</source>
        <translation>Forceret værdi</translation>
    </message>
    <message>
        <source>Forced variables</source>
        <translation>Forcerede variabler</translation>
    </message>
    <message>
        <source>Release selected</source>
        <translation>Ophæv forcering af de valgte</translation>
    </message>
    <message>
        <source>Release all</source>
        <translation>Ophæv al forcering</translation>
    </message>
</context>
<context>
    <name>plc::editor::GraphView</name>
    <message>
        <source>Show all</source>
        <translation>Vis alt</translation>
    </message>
    <message>
        <source>Export as SVG, PNG or PDF…</source>
        <translation>Eksporter som SVG, PNG eller PDF…</translation>
    </message>
    <message>
        <source>Export the Drawing</source>
        <translation>Eksporter tegningen</translation>
    </message>
    <message>
        <source>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</source>
        <translation>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be written; choose a variable of the program</source>
        <translation>%1 kan ikke skrives; vælg en variabel i programmet</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Udskriv…</translation>
    </message>
    <message>
        <source>Fix the text first: this is the last valid drawing</source>
        <translation>Ret teksten først: dette er den sidste gyldige tegning</translation>
    </message>
</context>
<context>
    <name>plc::editor::LadderView</name>
    <message>
        <source>Ladder or function block diagram</source>
        <translation>Ladder- eller funktionsblokdiagram</translation>
    </message>
    <message>
        <source>Insert a rung below (Ctrl+T)</source>
        <translation>Indsæt et netværk nedenunder (Ctrl+T)</translation>
    </message>
    <message>
        <source>Insert a contact on the left (Ctrl+K)</source>
        <translation>Indsæt en kontakt til venstre (Ctrl+K)</translation>
    </message>
    <message>
        <source>Insert a contact on the right (Ctrl+D)</source>
        <translation>Indsæt en kontakt til højre (Ctrl+D)</translation>
    </message>
    <message>
        <source>Insert a parallel contact (Ctrl+R)</source>
        <translation>Indsæt en parallel kontakt (Ctrl+R)</translation>
    </message>
    <message>
        <source>Insert a coil (Ctrl+A)</source>
        <translation>Indsæt en spole (Ctrl+A)</translation>
    </message>
    <message>
        <source>Insert a function block (Ctrl+B)</source>
        <translation>Indsæt en funktionsblok (Ctrl+B)</translation>
    </message>
    <message>
        <source>Edit (F2)</source>
        <translation>Rediger (F2)</translation>
    </message>
    <message>
        <source>Delete (Del)</source>
        <translation>Slet (Del)</translation>
    </message>
    <message>
        <source>Breakpoint on the rung (F9)</source>
        <translation>Stoppunkt på netværket (F9)</translation>
    </message>
    <message>
        <source>Show as a function block diagram</source>
        <translation>Vis som funktionsblokdiagram</translation>
    </message>
    <message>
        <source>Show as a ladder diagram</source>
        <translation>Vis som ladderdiagram</translation>
    </message>
    <message>
        <source>%1 is no longer in the text; undo the change or close this view</source>
        <translation>%1 er ikke længere i teksten; fortryd ændringen, eller luk denne visning</translation>
    </message>
    <message>
        <source>The text has errors: this is the last valid drawing</source>
        <translation>Teksten har fejl: dette er den sidste gyldige tegning</translation>
    </message>
    <message>
        <source>Fix the text first: this is the last valid drawing</source>
        <translation>Ret teksten først: dette er den sidste gyldige tegning</translation>
    </message>
    <message>
        <source>Select a rung</source>
        <translation>Vælg et netværk</translation>
    </message>
    <message>
        <source>Select a coil</source>
        <translation>Vælg en spole</translation>
    </message>
    <message>
        <source>Select a contact, a coil or a pin with a variable</source>
        <translation>Vælg en kontakt, en spole eller et ben med en variabel</translation>
    </message>
    <message>
        <source>The rung has no contact yet</source>
        <translation>Netværket har ingen kontakt endnu</translation>
    </message>
    <message>
        <source>Select the rung that gets the block</source>
        <translation>Vælg det netværk, der skal have blokken</translation>
    </message>
    <message>
        <source>block</source>
        <translation>blok</translation>
    </message>
    <message>
        <source>Contact on the left; at a coil, the last contact</source>
        <translation>Kontakt til venstre; ved en spole den sidste kontakt</translation>
    </message>
    <message>
        <source>Contact on the right</source>
        <translation>Kontakt til højre</translation>
    </message>
    <message>
        <source>Parallel contact</source>
        <translation>Parallel kontakt</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>Spole</translation>
    </message>
    <message>
        <source>Function block in the rung</source>
        <translation>Funktionsblok i netværket</translation>
    </message>
    <message>
        <source>Rung above</source>
        <translation>Netværk ovenover</translation>
    </message>
    <message>
        <source>Rung below</source>
        <translation>Netværk nedenunder</translation>
    </message>
    <message>
        <source>Negate a contact, a coil or a pin</source>
        <translation>Inverter en kontakt, en spole eller et ben</translation>
    </message>
    <message>
        <source>Coil: normal, set, reset</source>
        <translation>Spole: normal, sæt, nulstil</translation>
    </message>
    <message>
        <source>Comment of the rung</source>
        <translation>Netværkets kommentar</translation>
    </message>
    <message>
        <source>Edit what is selected (or Enter)</source>
        <translation>Rediger det valgte (eller Enter)</translation>
    </message>
    <message>
        <source>Delete what is selected</source>
        <translation>Slet det valgte</translation>
    </message>
    <message>
        <source>Breakpoint on the rung</source>
        <translation>Stoppunkt på netværket</translation>
    </message>
    <message>
        <source>This list</source>
        <translation>Denne liste</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Piletaster</translation>
    </message>
    <message>
        <source>Select the next part; Up and Down also the next rung</source>
        <translation>Vælg næste del; op og ned også næste netværk</translation>
    </message>
    <message>
        <source>Move the rung up; with Down, down</source>
        <translation>Flyt netværket op; med pil ned, ned</translation>
    </message>
    <message>
        <source>Typed before a name: a negated contact</source>
        <translation>Skrevet foran et navn: en inverteret kontakt</translation>
    </message>
    <message>
        <source>Keys in Ladder and Function Block Diagrams</source>
        <translation>Taster i ladder- og funktionsblokdiagrammer</translation>
    </message>
    <message>
        <source>Insert a Rung Above</source>
        <translation>Indsæt et netværk ovenover</translation>
    </message>
    <message>
        <source>Insert a Rung Below</source>
        <translation>Indsæt et netværk nedenunder</translation>
    </message>
    <message>
        <source>Insert a Contact</source>
        <translation>Indsæt en kontakt</translation>
    </message>
    <message>
        <source>Insert a Parallel Contact</source>
        <translation>Indsæt en parallel kontakt</translation>
    </message>
    <message>
        <source>Insert a Coil</source>
        <translation>Indsæt en spole</translation>
    </message>
    <message>
        <source>Insert a Function Block…</source>
        <translation>Indsæt en funktionsblok…</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Rediger</translation>
    </message>
    <message>
        <source>Comment…</source>
        <translation>Kommentar…</translation>
    </message>
    <message>
        <source>Negate</source>
        <translation>Inverter</translation>
    </message>
    <message>
        <source>Set or Reset</source>
        <translation>Sæt eller nulstil</translation>
    </message>
    <message>
        <source>Move the Rung Up</source>
        <translation>Flyt netværket op</translation>
    </message>
    <message>
        <source>Move the Rung Down</source>
        <translation>Flyt netværket ned</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Slet</translation>
    </message>
    <message>
        <source>Force TRUE</source>
        <translation>Forcer TRUE</translation>
    </message>
    <message>
        <source>Force FALSE</source>
        <translation>Forcer FALSE</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Ophæv forcering</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Slå stoppunkt til/fra</translation>
    </message>
    <message>
        <source>Contacts as Bars (IEC 61131-3, ANSI)</source>
        <translation>Kontakter som streger (IEC 61131-3, ANSI)</translation>
    </message>
    <message>
        <source>Contacts as in Circuit Diagrams (IEC 60617)</source>
        <translation>Kontakter som i eldiagrammer (IEC 60617)</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Navne</translation>
    </message>
    <message>
        <source>Addresses</source>
        <translation>Adresser</translation>
    </message>
    <message>
        <source>Names and Addresses</source>
        <translation>Navne og adresser</translation>
    </message>
    <message>
        <source>Comments of the Variables</source>
        <translation>Variablernes kommentarer</translation>
    </message>
    <message>
        <source>Comments of the Rungs</source>
        <translation>Netværkenes kommentarer</translation>
    </message>
    <message>
        <source>High Contrast</source>
        <translation>Høj kontrast</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Hvad der vises</translation>
    </message>
    <message>
        <source>type</source>
        <translation>type</translation>
    </message>
    <message>
        <source>Rename the variable everywhere</source>
        <translation>Omdøb variablen overalt</translation>
    </message>
    <message>
        <source>Go to the definition</source>
        <translation>Gå til definitionen</translation>
    </message>
    <message>
        <source>References to the variable</source>
        <translation>Referencer til variablen</translation>
    </message>
    <message>
        <source>Quick fix</source>
        <translation>Hurtig rettelse</translation>
    </message>
    <message>
        <source>Bookmark on the rung</source>
        <translation>Bogmærke på netværket</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Omdøb…</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Find referencer</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Gå til definitionen</translation>
    </message>
    <message>
        <source>Quick Fix</source>
        <translation>Hurtig rettelse</translation>
    </message>
    <message>
        <source>Write TRUE</source>
        <translation>Skriv TRUE</translation>
    </message>
    <message>
        <source>Write FALSE</source>
        <translation>Skriv FALSE</translation>
    </message>
    <message>
        <source>Toggle Bookmark</source>
        <translation>Slå bogmærke til eller fra</translation>
    </message>
    <message>
        <source>Contact Here</source>
        <translation>Kontakt her</translation>
    </message>
    <message>
        <source>Negated Contact Here</source>
        <translation>Inverteret kontakt her</translation>
    </message>
    <message>
        <source>Function Block Here</source>
        <translation>Funktionsblok her</translation>
    </message>
    <message>
        <source>Move the contact left; with Right, right</source>
        <translation>Flyt kontakten til venstre; med pil højre, til højre</translation>
    </message>
    <message>
        <source>Select a contact; a rung moves up and down</source>
        <translation>Vælg en kontakt; et netværk flyttes op og ned</translation>
    </message>
</context>
<context>
    <name>plc::editor::RunArchive</name>
    <message>
        <source>The recording of the last run was not kept: %1</source>
        <translation>Optagelsen af den seneste kørsel blev ikke gemt: %1</translation>
    </message>
</context>
<context>
    <name>plc::editor::RunControl</name>
    <message>
        <source>Built in %1 ms</source>
        <translation>Oversat på %1&#xa0;ms</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s): the program was not built</source>
        <translation>
            <numerusform>%n fejl: programmet blev ikke oversat</numerusform>
            <numerusform>%n fejl: programmet blev ikke oversat</numerusform>
        </translation>
    </message>
    <message>
        <source>Online change: %1 kept, %2 new, %3 lost</source>
        <translation>Onlineændring: %1 variabler bevaret, %2 nye, %3 fjernet</translation>
    </message>
    <message>
        <source>The change waits for the end of the scan</source>
        <translation>Ændringen venter på scannets afslutning</translation>
    </message>
    <message>
        <source>The program has errors; the controller continues with the old program</source>
        <translation>Programmet har fejl; styringen fortsætter med det gamle</translation>
    </message>
    <message>
        <source>did not exist in this scan</source>
        <translation>fandtes ikke i dette scan</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Oversætter</translation>
    </message>
    <message>
        <source>Not optimised: the quick code keeps running</source>
        <translation>Ikke optimeret: den hurtigt oversatte kode fortsætter</translation>
    </message>
    <message>
        <source>Optimising</source>
        <translation>Optimerer</translation>
    </message>
    <message>
        <source>There is no code at or below line %1 of %2; choose an earlier line</source>
        <translation>I %2 er der ingen kode i eller under linje %1; vælg en tidligere linje</translation>
    </message>
    <message>
        <source>The condition of the breakpoint: %1</source>
        <translation>Stoppunktets betingelse: %1</translation>
    </message>
</context>
<context>
    <name>plc::editor::SlowScanView</name>
    <message>
        <source>Back to the previous breakpoint or to the first statement of the scan</source>
        <translation>Tilbage til det forrige stoppunkt eller til scannets første sætning</translation>
    </message>
    <message>
        <source>Back out of the call</source>
        <translation>Tilbage ud af kaldet</translation>
    </message>
    <message>
        <source>Back over calls</source>
        <translation>Tilbage over kald</translation>
    </message>
    <message>
        <source>One statement back</source>
        <translation>En sætning tilbage</translation>
    </message>
    <message>
        <source>Step in</source>
        <translation>Trin ind</translation>
    </message>
    <message>
        <source>Step over</source>
        <translation>Trin over</translation>
    </message>
    <message>
        <source>Step out</source>
        <translation>Trin ud</translation>
    </message>
    <message>
        <source>Forward to the next breakpoint or to the end of the scan</source>
        <translation>Videre til det næste stoppunkt eller til scannets slutning</translation>
    </message>
    <message>
        <source>End the walk</source>
        <translation>Afslut gennemgangen</translation>
    </message>
    <message>
        <source>Current position of the walk</source>
        <translation>Gennemgangens aktuelle position</translation>
    </message>
    <message>
        <source>Call</source>
        <translation>Kald</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>Instans</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linje</translation>
    </message>
    <message>
        <source>Call path</source>
        <translation>Kaldestak</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Værdi</translation>
    </message>
    <message>
        <source>Values at this moment</source>
        <translation>Værdier i dette øjeblik</translation>
    </message>
    <message>
        <source>There is no recorded scan yet: run the program first.</source>
        <translation>Der er endnu intet optaget scan: Kør først programmet.</translation>
    </message>
    <message>
        <source>Running the scan again…</source>
        <translation>Kører scannet igen…</translation>
    </message>
    <message>
        <source>Walks through a recorded scan statement by statement, forwards and backwards (Time, Walk Through the Scan).</source>
        <translation>Går gennem et optaget scan sætning for sætning, forlæns og baglæns (Tid, Gå gennem scannet).</translation>
    </message>
    <message>
        <source>The end of scan %1 at %2</source>
        <translation>Slutningen af scan %1 ved %2</translation>
    </message>
    <message>
        <source>Scan %1 at %2: before statement %3 of %4</source>
        <translation>Scan %1 ved %2: før sætning %3 af %4</translation>
    </message>
    <message>
        <source> · pass %1</source>
        <comment>of loops, outermost first</comment>
        <translation> · gennemløb %1</translation>
    </message>
    <message>
        <source>Locals</source>
        <translation>Lokale variabler</translation>
    </message>
</context>
<context>
    <name>plc::editor::StEditor</name>
    <message>
        <source>Structured Text editor</source>
        <translation>Editor til struktureret tekst</translation>
    </message>
    <message>
        <source>Declare %1</source>
        <translation>Erklær %1</translation>
    </message>
    <message>
        <source>There is no fix for this line; press F1 for an explanation</source>
        <translation>Der er ingen rettelse til denne linje; tryk på F1 for en forklaring</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Gå til definitionen</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Find referencer</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Omdøb…</translation>
    </message>
    <message>
        <source>Add to Watch</source>
        <translation>Føj til overvågning</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Slå stoppunkt til/fra</translation>
    </message>
    <message>
        <source>CR</source>
        <comment>current result of an instruction list</comment>
        <translation>AR</translation>
    </message>
    <message>
        <source>Declare %1 as an input</source>
        <translation>Erklær %1 som indgang</translation>
    </message>
    <message>
        <source>Declare %1 as an output</source>
        <translation>Erklær %1 som udgang</translation>
    </message>
    <message>
        <source>Declare %1 as a global variable</source>
        <translation>Erklær %1 som global variabel</translation>
    </message>
    <message>
        <source>Declare %1 in %2</source>
        <translation>Erklær %1 i %2</translation>
    </message>
    <message>
        <source>Write a Value…</source>
        <translation>Skriv en værdi…</translation>
    </message>
    <message>
        <source>Force…</source>
        <translation>Forcer…</translation>
    </message>
    <message>
        <source>Release the Force</source>
        <translation>Ophæv forcering</translation>
    </message>
    <message>
        <source>pass</source>
        <comment>of a loop</comment>
        <translation>gennemløb</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 af %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::TaskMonitor</name>
    <message>
        <source>Histogram of execution times</source>
        <translation>Histogram over udførelsestider</translation>
    </message>
    <message>
        <source>Execution times appear here while the controller runs</source>
        <translation>Udførelsestider vises her, mens styringen kører</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Task</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Antal kørsler</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Seneste</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Gennemsnit</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Maks</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Jitter</translation>
    </message>
    <message>
        <source>Overruns</source>
        <translation>Tidsoverskridelser</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Belastning</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tasks</translation>
    </message>
    <message>
        <source>Reset the statistics</source>
        <translation>Nulstil statistikken</translation>
    </message>
</context>
<context>
    <name>plc::editor::TuningView</name>
    <message>
        <source>Charts of the loop</source>
        <translation>Diagrammer for sløjfen</translation>
    </message>
    <message>
        <source>Recording and model</source>
        <translation>Optagelse og model</translation>
    </message>
    <message>
        <source>Response to the set point</source>
        <translation>Respons på setpunktet</translation>
    </message>
    <message>
        <source>Response to a disturbance</source>
        <translation>Respons på en forstyrrelse</translation>
    </message>
    <message>
        <source>Simulation with the actual block</source>
        <translation>Simulering med den rigtige blok</translation>
    </message>
    <message>
        <source>Control loop</source>
        <translation>Reguleringssløjfe</translation>
    </message>
    <message>
        <source>Find Steps</source>
        <translation>Find spring</translation>
    </message>
    <message>
        <source>Searches the recording for steps of the set point and of the output and fits a model of the process.</source>
        <translation>Leder efter spring i setpunktet og udgangen i optagelsen og laver en model af processen.</translation>
    </message>
    <message>
        <source>Write Parameters</source>
        <translation>Skriv parametre</translation>
    </message>
    <message>
        <source>Writes all parameters in one scan.</source>
        <translation>Skriver alle parametre i ét scan.</translation>
    </message>
    <message>
        <source>Take Back</source>
        <translation>Tag tilbage</translation>
    </message>
    <message>
        <source>Writes the parameters that were in force before.</source>
        <translation>Skriver de parametre, der gjaldt før.</translation>
    </message>
    <message>
        <source>Loop:</source>
        <translation>Sløjfe:</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Brug</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Ved</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Ændring</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Fra</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Til</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Vurdering</translation>
    </message>
    <message>
        <source>Steps found</source>
        <translation>Fundne spring</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Kind of controller</source>
        <translation>Regulatortype</translation>
    </message>
    <message>
        <source>Calm to brisk</source>
        <translation>Rolig til rask</translation>
    </message>
    <message>
        <source>Disturbance to set point</source>
        <translation>Forstyrrelse til setpunkt</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Nu</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Foreslået</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Før og efter</translation>
    </message>
    <message>
        <source>Model:</source>
        <translation>Model:</translation>
    </message>
    <message>
        <source>Rule:</source>
        <translation>Regel:</translation>
    </message>
    <message>
        <source>Controller:</source>
        <translation>Regulator:</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>Rolig</translation>
    </message>
    <message>
        <source>Brisk</source>
        <translation>Rask</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>Forstyrrelse</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Setpunkt</translation>
    </message>
    <message>
        <source>The program has no controller block; call one, for example PID.</source>
        <translation>Programmet har ingen regulatorblok; kald en, for eksempel PID.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Søger…</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) found, %1 used.</source>
        <translation>
            <numerusform>%n spring fundet, %1 brugt.</numerusform>
            <numerusform>%n spring fundet, %1 brugt.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, explains %2 %</source>
        <translation>%1, forklarer %2&#xa0;%</translation>
    </message>
    <message>
        <source>set point</source>
        <translation>setpunkt</translation>
    </message>
    <message>
        <source>output</source>
        <translation>udgang</translation>
    </message>
    <message>
        <source>Choose at least one step.</source>
        <translation>Vælg mindst ét spring.</translation>
    </message>
    <message>
        <source>The rule does not apply to this process; choose another rule.</source>
        <translation>Reglen gælder ikke for denne proces; vælg en anden regel.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>enhver</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Forstærkning</translation>
    </message>
    <message>
        <source>Integral time</source>
        <translation>Integraltid</translation>
    </message>
    <message>
        <source>Derivative time</source>
        <translation>Differentialtid</translation>
    </message>
    <message>
        <source>Sensitivity Ms</source>
        <translation>Følsomhed Ms</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>ustabil</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Forstærkningsmargin</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Fasemargin</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Oversving</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Indsvingningstid</translation>
    </message>
    <message>
        <source>Error after a load step</source>
        <translation>Fejl efter et lastspring</translation>
    </message>
    <message>
        <source>Control effort</source>
        <translation>Styreindsats</translation>
    </message>
    <message>
        <source>Noise in the output</source>
        <translation>Støj i udgangen</translation>
    </message>
    <message>
        <source>Recorded and modelled</source>
        <translation>Optaget og modelleret</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>tid [s]</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>optaget</translation>
    </message>
    <message>
        <source>model</source>
        <translation>model</translation>
    </message>
    <message>
        <source>now</source>
        <translation>nu</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>foreslået</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Regulatorindstilling</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Skrevet: %1</translation>
    </message>
    <message>
        <source>Taken back: %1</source>
        <translation>Taget tilbage: %1</translation>
    </message>
    <message>
        <source>Residuals of the model</source>
        <translation>Modellens residualer</translation>
    </message>
    <message>
        <source>recorded minus model</source>
        <translation>optaget minus model</translation>
    </message>
    <message>
        <source>loop now</source>
        <translation>nuværende sløjfe</translation>
    </message>
    <message>
        <source>loop as proposed</source>
        <translation>sløjfen som foreslået</translation>
    </message>
    <message>
        <source>Bode plot</source>
        <translation>Bodediagram</translation>
    </message>
    <message>
        <source>Bode Plot</source>
        <translation>Bodediagram</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>frekvens [rad/s]</translation>
    </message>
    <message>
        <source>process</source>
        <translation>proces</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>forstærkningsmargin</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>fasemargin</translation>
    </message>
    <message>
        <source>Constants in the call: %1. Write Parameters changes them in the text and in the running controller by an online change.</source>
        <translation>Konstanter i kaldet: %1. ”Skriv parametre” ændrer dem i teksten og i den kørende styring med en onlineændring.</translation>
    </message>
    <message>
        <source>Computed in the call and not written: %1.</source>
        <translation>Beregnet i kaldet og ikke skrevet: %1.</translation>
    </message>
    <message>
        <source>The recorded disturbance with these settings</source>
        <translation>Den optagede forstyrrelse med disse indstillinger</translation>
    </message>
    <message>
        <source>The recorded step with these settings</source>
        <translation>Det optagede spring med disse indstillinger</translation>
    </message>
    <message>
        <source>The text was changed since the controller was started: change the constants after the next start or online change.</source>
        <translation>Teksten er ændret, siden styringen blev startet: ændr konstanterne efter næste start eller onlineændring.</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Responser</translation>
    </message>
    <message>
        <source>Start the controller or open a recording to search it for steps.</source>
        <translation>Start styringen, eller åbn en optagelse; der ledes efter spring i den.</translation>
    </message>
    <message>
        <source>disturbance</source>
        <translation>forstyrrelse</translation>
    </message>
    <message>
        <source>gain [dB]</source>
        <translation>forstærkning [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>fase [°]</translation>
    </message>
    <message>
        <source>Health in figures</source>
        <translation>Tilstand i tal</translation>
    </message>
    <message>
        <source>The whole recording</source>
        <translation>Hele optagelsen</translation>
    </message>
    <message>
        <source>Save Report</source>
        <translation>Gem rapport</translation>
    </message>
    <message>
        <source>Web pages (*.html);;PDF (*.pdf)</source>
        <translation>Websider (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Report written: %1</source>
        <translation>Rapport skrevet:&#xa0;%1</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Saves a report on the loop with model and settings as HTML or PDF.</source>
        <translation>Gemmer en rapport om reguleringssløjfen med model og indstillinger som HTML eller PDF.</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>Tilstand</translation>
    </message>
</context>
<context>
    <name>plc::editor::WatchView</name>
    <message>
        <source>A list %1 already exists; choose another name</source>
        <translation>Der findes allerede en liste %1; vælg et andet navn</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Udtryk</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Værdi</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Prepared</source>
        <translation>Forberedt</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>Overvågningsliste</translation>
    </message>
    <message>
        <source>Add an expression: Main.x, a[i] * 2, fb.Q AND NOT done</source>
        <translation>Tilføj et udtryk: Main.x, a[i] * 2, fb.Q AND NOT done</translation>
    </message>
    <message>
        <source>New watch expression</source>
        <translation>Nyt overvågningsudtryk</translation>
    </message>
    <message>
        <source>Write prepared values</source>
        <translation>Skriv forberedte værdier</translation>
    </message>
    <message>
        <source>Force prepared values</source>
        <translation>Forcer forberedte værdier</translation>
    </message>
    <message>
        <source>Release the selected forces</source>
        <translation>Ophæv forcering af de valgte værdier</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>Decimal</translation>
    </message>
    <message>
        <source>Hexadecimal</source>
        <translation>Hexadecimal</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>Binær</translation>
    </message>
    <message>
        <source>Number format</source>
        <translation>Talformat</translation>
    </message>
    <message>
        <source>Toggle</source>
        <translation>Skift</translation>
    </message>
    <message>
        <source>Force to %1</source>
        <translation>Forcer til %1</translation>
    </message>
    <message>
        <source>Release Force</source>
        <translation>Ophæv forcering</translation>
    </message>
    <message>
        <source>Show in Trace</source>
        <translation>Vis i trace</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>Fjern alle</translation>
    </message>
    <message>
        <source>Time</source>
        <comment>number format</comment>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Numbers as decimals, in hexadecimal or binary, or milliseconds as a time</source>
        <translation>Tal decimalt, hexadecimalt eller binært, eller millisekunder som tid</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <comment>stretch of an array</comment>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Overvågning</translation>
    </message>
    <message>
        <source>Add, rename or remove a list</source>
        <translation>Tilføj, omdøb eller fjern en liste</translation>
    </message>
    <message>
        <source>Name of the list:</source>
        <translation>Listens navn:</translation>
    </message>
    <message>
        <source>New List…</source>
        <translation>Ny liste…</translation>
    </message>
    <message>
        <source>New List</source>
        <translation>Ny liste</translation>
    </message>
    <message>
        <source>Rename the List…</source>
        <translation>Omdøb listen…</translation>
    </message>
    <message>
        <source>Rename the List</source>
        <translation>Omdøb listen</translation>
    </message>
    <message>
        <source>Remove the List</source>
        <translation>Fjern listen</translation>
    </message>
    <message>
        <source>Number Format</source>
        <translation>Talformat</translation>
    </message>
    <message>
        <source>As in the list</source>
        <translation>Som listen</translation>
    </message>
    <message>
        <source>Source of %1 with the Values of %2</source>
        <translation>Kildetekst til %1 med værdierne fra %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::WhyView</name>
    <message>
        <source>For example Main.level &gt; 80</source>
        <translation>F.eks. Main.level &gt; 80</translation>
    </message>
    <message>
        <source>Variable or expression to explain</source>
        <translation>Variabel eller udtryk, der skal forklares</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Hvorfor?</translation>
    </message>
    <message>
        <source>What changed it, and what had to hold</source>
        <translation>Hvad der ændrede det, og hvad der skulle gælde</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>Hvorfor ikke?</translation>
    </message>
    <message>
        <source>The smallest changes that would change the result of the condition</source>
        <translation>De mindste ændringer, der ville give betingelsen et andet resultat</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>Hvem satte det?</translation>
    </message>
    <message>
        <source>All changes in the recording, and what made each of them</source>
        <translation>Alle ændringer i optagelsen, og hvad der forårsagede hver af dem</translation>
    </message>
    <message>
        <source>Explanation</source>
        <translation>Forklaring</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Right-click a variable in the text, the watch, the tree, the trace or a panel and ask why it has its value.</source>
        <translation>Højreklik på en variabel i teksten, overvågningen, træet, tracen eller et panel, og spørg, hvorfor den har sin værdi.</translation>
    </message>
    <message>
        <source>Searching the recorded scans…</source>
        <translation>Undersøger de optagede scan…</translation>
    </message>
    <message>
        <source>There is no recording yet: run the program first.</source>
        <translation>Der er endnu ingen optagelse: Kør først programmet.</translation>
    </message>
    <message>
        <source>%1 · scan %2</source>
        <comment>time and number</comment>
        <translation>%1 · scan %2</translation>
    </message>
    <message>
        <source>Earlier changes…</source>
        <translation>Tidligere ændringer…</translation>
    </message>
    <message>
        <source>Why Is %1 So?</source>
        <translation>Hvorfor er %1 sådan?</translation>
    </message>
    <message>
        <source>Who Set %1?</source>
        <translation>Hvem satte %1?</translation>
    </message>
    <message>
        <source>Copy the Answer</source>
        <translation>Kopier svaret</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuller</translation>
    </message>
    <message>
        <source>Cancel (Esc)</source>
        <translation>Annuller (Esc)</translation>
    </message>
    <message>
        <source>Cancelled: there is no answer.</source>
        <translation>Annulleret: der er intet svar.</translation>
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
        <translation>Prioritet</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Betingelse</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>Add an alarm</source>
        <translation>Tilføj en alarm</translation>
    </message>
    <message>
        <source>Add a class</source>
        <translation>Tilføj en klasse</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Værdier</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmer</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Klasser</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>Add alarm</source>
        <translation>Tilføj alarm</translation>
    </message>
    <message>
        <source>Add class</source>
        <translation>Tilføj klasse</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ArrayArrangementDialog</name>
    <message>
        <source>Arrange over array</source>
        <translation>Arranger over et array</translation>
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
        <translation>Første indeks</translation>
    </message>
    <message>
        <source>Last index</source>
        <translation>Sidste indeks</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Kolonner</translation>
    </message>
    <message>
        <source>Horizontal gap</source>
        <translation>Vandret afstand</translation>
    </message>
    <message>
        <source>Vertical gap</source>
        <translation>Lodret afstand</translation>
    </message>
    <message>
        <source>In the other arguments, # becomes the index.</source>
        <translation>I de andre argumenter bliver # til indekset.</translation>
    </message>
    <message>
        <source>Choose an array with one index, for example Plant.Valves.</source>
        <translation>Vælg et array med ét indeks, for eksempel Plant.Valves.</translation>
    </message>
    <message>
        <source>They reach to %1 × %2, the panel only to %3 × %4: make the faceplate smaller or the panel larger.</source>
        <translation>De når til %1 × %2, panelet kun til %3 × %4: gør faceplaten mindre eller panelet større.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ArrayDialog</name>
    <message>
        <source>Duplicate as array</source>
        <translation>Dupliker som array</translation>
    </message>
    <message>
        <source>Number of elements</source>
        <translation>Antal elementer</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Kolonner</translation>
    </message>
    <message>
        <source>Vertical gap</source>
        <translation>Lodret afstand</translation>
    </message>
    <message>
        <source>Index step</source>
        <translation>Indekstrin</translation>
    </message>
    <message>
        <source>Horizontal gap</source>
        <translation>Vandret afstand</translation>
    </message>
</context>
<context>
    <name>plc::hmi::DesignCanvas</name>
    <message>
        <source>Move</source>
        <translation>Flyt</translation>
    </message>
    <message>
        <source>Move point</source>
        <translation>Flyt punkt</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkter</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Slet</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Indsæt</translation>
    </message>
    <message>
        <source>Resize</source>
        <translation>Ændr størrelse</translation>
    </message>
    <message>
        <source>Bind</source>
        <translation>Bind</translation>
    </message>
    <message>
        <source>%1 has no single value: drop one of its members, or first draw a panel with a parameter of the type %2</source>
        <translation>%1 har ikke én enkelt værdi: træk et af dens medlemmer hertil, eller tegn først et panel med en parameter af typen %2</translation>
    </message>
    <message>
        <source>Place in cell</source>
        <translation>Placer i celle</translation>
    </message>
</context>
<context>
    <name>plc::hmi::DesignContext</name>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Omdøb %1</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmer</translation>
    </message>
    <message>
        <source>Rename Theme</source>
        <translation>Omdøb tema</translation>
    </message>
</context>
<context>
    <name>plc::hmi::Outline</name>
    <message>
        <source>Lock</source>
        <translation>Lås</translation>
    </message>
    <message>
        <source>No elements yet. Drag one from the palette onto the panel.</source>
        <translation>Ingen elementer endnu. Træk et fra paletten til panelet.</translation>
    </message>
    <message>
        <source>Reorder</source>
        <translation>Omarranger</translation>
    </message>
</context>
<context>
    <name>plc::hmi::Palette</name>
    <message>
        <source>Search elements</source>
        <translation>Søg elementer</translation>
    </message>
    <message>
        <source>Faceplates</source>
        <translation>Faceplates</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elementer</translation>
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
        <translation>Sprog</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Klip</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopier</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Sæt ind</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliker</translation>
    </message>
    <message>
        <source>Duplicate as Array…</source>
        <translation>Dupliker som array…</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Marker alt</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Slet</translation>
    </message>
    <message>
        <source>Align Left</source>
        <translation>Juster til venstre</translation>
    </message>
    <message>
        <source>Align Centres</source>
        <translation>Centrer vandret</translation>
    </message>
    <message>
        <source>Align Right</source>
        <translation>Juster til højre</translation>
    </message>
    <message>
        <source>Align Top</source>
        <translation>Juster foroven</translation>
    </message>
    <message>
        <source>Align Middles</source>
        <translation>Centrer lodret</translation>
    </message>
    <message>
        <source>Align Bottom</source>
        <translation>Juster forneden</translation>
    </message>
    <message>
        <source>Distribute Horizontally</source>
        <translation>Ens afstande vandret</translation>
    </message>
    <message>
        <source>Distribute Vertically</source>
        <translation>Ens afstande lodret</translation>
    </message>
    <message>
        <source>Same Width</source>
        <translation>Samme bredde</translation>
    </message>
    <message>
        <source>Same Height</source>
        <translation>Samme højde</translation>
    </message>
    <message>
        <source>Bring to Front</source>
        <translation>Forrest</translation>
    </message>
    <message>
        <source>Bring Forward</source>
        <translation>Et lag frem</translation>
    </message>
    <message>
        <source>Send Backward</source>
        <translation>Et lag tilbage</translation>
    </message>
    <message>
        <source>Send to Back</source>
        <translation>Bagest</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupper</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Opløs gruppe</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Lås</translation>
    </message>
    <message>
        <source>Show the Grid</source>
        <translation>Vis gitteret</translation>
    </message>
    <message>
        <source>Snap (Alt: not now)</source>
        <translation>Fastgør (Alt: ikke nu)</translation>
    </message>
    <message>
        <source>Live Preview</source>
        <translation>Liveforhåndsvisning</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Zoom ind</translation>
    </message>
    <message>
        <source>Zoom Out</source>
        <translation>Zoom ud</translation>
    </message>
    <message>
        <source>Zoom 100 %</source>
        <translation>Zoom 100&#xa0;%</translation>
    </message>
    <message>
        <source>Zoom to Fit</source>
        <translation>Zoom til vinduet</translation>
    </message>
    <message>
        <source>Language shown</source>
        <translation>Vist sprog</translation>
    </message>
    <message>
        <source>Theme of the panel</source>
        <translation>Panelets tema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lyst</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Mørkt</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Høj kontrast</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Duplicate as array</source>
        <translation>Dupliker som array</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elementer</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variabler</translation>
    </message>
    <message>
        <source>Same Size</source>
        <translation>Samme størrelse</translation>
    </message>
    <message>
        <source>Paste in Place</source>
        <translation>Sæt ind på samme sted</translation>
    </message>
    <message>
        <source>Arrange Over Array…</source>
        <translation>Arranger over et array…</translation>
    </message>
    <message>
        <source>Arrange over array</source>
        <translation>Arranger over et array</translation>
    </message>
    <message>
        <source>Fix All Issues</source>
        <translation>Ret alle problemer</translation>
    </message>
    <message>
        <source>Fix Issue</source>
        <translation>Ret problemet</translation>
    </message>
    <message>
        <source>Explain Issue</source>
        <translation>Forklar problemet</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Issues</source>
        <translation>Problemer</translation>
    </message>
    <message>
        <source>Lay Out in a Row</source>
        <translation>Anbring i en række</translation>
    </message>
    <message>
        <source>Lay Out in a Column</source>
        <translation>Anbring i en kolonne</translation>
    </message>
    <message>
        <source>Lay Out in a Grid</source>
        <translation>Anbring i et gitter</translation>
    </message>
    <message>
        <source>Lay out</source>
        <translation>Anbring</translation>
    </message>
    <message>
        <source>Edit Themes…</source>
        <translation>Rediger temaer…</translation>
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
        <translation>Angiv adgangskode</translation>
    </message>
    <message>
        <source>Password of %1:</source>
        <translation>Adgangskode for&#xa0;%1:</translation>
    </message>
    <message>
        <source>The two passwords differ.</source>
        <translation>De to adgangskoder er forskellige.</translation>
    </message>
    <message>
        <source>Repeat:</source>
        <translation>Gentag:</translation>
    </message>
    <message>
        <source>Repeat the password.</source>
        <translation>Gentag adgangskoden.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PeopleEditor</name>
    <message>
        <source>User</source>
        <translation>Bruger</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Roller</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprog</translation>
    </message>
    <message>
        <source>Start panel</source>
        <translation>Startpanel</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Adgangskode</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Brugere</translation>
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
        <translation>Tilføj en bruger</translation>
    </message>
    <message>
        <source>Set Password…</source>
        <translation>Angiv adgangskode…</translation>
    </message>
    <message>
        <source>Remove User</source>
        <translation>Fjern bruger</translation>
    </message>
    <message>
        <source>Add a Role</source>
        <translation>Tilføj en rolle</translation>
    </message>
    <message>
        <source>Remove Role</source>
        <translation>Fjern rolle</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>never</source>
        <translation>aldrig</translation>
    </message>
    <message>
        <source>Logged out after</source>
        <translation>Log ud efter</translation>
    </message>
    <message>
        <source>Logged out after </source>
        <translation>Log ud efter </translation>
    </message>
    <message>
        <source>Logged Out After</source>
        <translation>Log ud efter</translation>
    </message>
    <message>
        <source>Set Password</source>
        <translation>Angiv adgangskode</translation>
    </message>
    <message>
        <source>none: cannot log in</source>
        <translation>ingen: kan ikke logge ind</translation>
    </message>
    <message>
        <source>set</source>
        <translation>angivet</translation>
    </message>
    <message>
        <source>Rename Role</source>
        <translation>Omdøb rolle</translation>
    </message>
    <message>
        <source>Without users, everybody may do everything. Add a role, then a user with a password.</source>
        <translation>Uden brugere må alle alt. Tilføj en rolle, derefter en bruger med adgangskode.</translation>
    </message>
    <message>
        <source>To restrict an element to some users, set its property &quot;Only for the roles&quot;.</source>
        <translation>Sæt egenskaben ”Kun for rollerne” for at begrænse et element til nogle brugere.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PropertySheet</name>
    <message>
        <source>Search properties</source>
        <translation>Søg egenskaber</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Nulstil</translation>
    </message>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n element</numerusform>
            <numerusform>%n elementer</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::hmi::RecipeEditor</name>
    <message>
        <source>Add a Recipe</source>
        <translation>Tilføj en recept</translation>
    </message>
    <message>
        <source>Add a Variable</source>
        <translation>Tilføj en variabel</translation>
    </message>
    <message>
        <source>Add a Set</source>
        <translation>Tilføj et sæt</translation>
    </message>
    <message>
        <source>Remove Row or Set</source>
        <translation>Fjern række eller sæt</translation>
    </message>
    <message>
        <source>Remove Recipe</source>
        <translation>Fjern recept</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabeller (*.csv)</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>Importer CSV</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>Eksporter CSV</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recepter</translation>
    </message>
    <message>
        <source>Variables and sets of the recipe</source>
        <translation>Receptens variabler og sæt</translation>
    </message>
    <message>
        <source>Rename Recipe</source>
        <translation>Omdøb recept</translation>
    </message>
    <message>
        <source>Rename Set</source>
        <translation>Omdøb sæt</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Navn:</translation>
    </message>
    <message>
        <source>Remove Set</source>
        <translation>Fjern sæt</translation>
    </message>
    <message>
        <source>Remove Row</source>
        <translation>Fjern række</translation>
    </message>
    <message>
        <source>Add a recipe, then its variables, then a set for each product.</source>
        <translation>Tilføj en recept, derefter dens variabler, derefter et sæt for hvert produkt.</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variabel</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Enhed</translation>
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
        <translation>Maksimum</translation>
    </message>
    <message>
        <source>A recipe needs a name.</source>
        <translation>En recept skal have et navn.</translation>
    </message>
    <message>
        <source>The recipe &quot;%1&quot; already exists; choose another name.</source>
        <translation>Der er allerede en recept ”%1”; vælg et andet navn.</translation>
    </message>
    <message>
        <source>The set &quot;%1&quot; already exists; choose another name.</source>
        <translation>Der er allerede et sæt ”%1”; vælg et andet navn.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number; a limit is written like 12.5.</source>
        <translation>”%1” er ikke et tal; en grænse skrives for eksempel som 12.5.</translation>
    </message>
    <message>
        <source>A row needs a variable; Remove Row or Set takes the row away.</source>
        <translation>En række skal have en variabel; ”Fjern række eller sæt” fjerner rækken.</translation>
    </message>
    <message>
        <source>%1 is already in the recipe; choose another variable.</source>
        <translation>%1 er allerede i recepten; vælg en anden variabel.</translation>
    </message>
    <message>
        <source>Select a cell of the set that is to be renamed.</source>
        <translation>Vælg en celle i det sæt, der skal omdøbes.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::RecordsDialog</name>
    <message>
        <source>Add</source>
        <translation>Tilføj</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Op</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ned</translation>
    </message>
</context>
<context>
    <name>plc::hmi::TextEditor</name>
    <message>
        <source>A key %1 already exists; choose another name</source>
        <translation>Der findes allerede en nøgle %1; vælg et andet navn</translation>
    </message>
    <message>
        <source>Only incomplete</source>
        <translation>Kun ufuldstændige</translation>
    </message>
    <message>
        <source>Search texts</source>
        <translation>Søg tekster</translation>
    </message>
    <message>
        <source>Add a key</source>
        <translation>Tilføj en nøgle</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Nøgle</translation>
    </message>
    <message>
        <source>Remove the selected keys</source>
        <translation>Fjern de valgte nøgler</translation>
    </message>
    <message>
        <source>Add a language</source>
        <translation>Tilføj et sprog</translation>
    </message>
    <message>
        <source>Language tag, for example de or zh-CN</source>
        <translation>Sprogkode, for eksempel de eller zh-CN</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>Importer CSV</translation>
    </message>
    <message>
        <source>Text tables (*.csv *.txt)</source>
        <translation>Teksttabeller (*.csv *.txt)</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>Eksporter CSV</translation>
    </message>
    <message>
        <source>Text tables (*.csv)</source>
        <translation>Teksttabeller (*.csv)</translation>
    </message>
    <message>
        <source>Add key</source>
        <translation>Tilføj nøgle</translation>
    </message>
    <message>
        <source>Remove keys</source>
        <translation>Fjern nøgler</translation>
    </message>
    <message>
        <source>Add language</source>
        <translation>Tilføj sprog</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>%n tekst</numerusform>
            <numerusform>%n tekster</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is not used.</source>
        <translation>%1 bruges ikke.</translation>
    </message>
    <message>
        <source>%1 is used by %2</source>
        <translation>%1 bruges af %2</translation>
    </message>
    <message>
        <source>Import XLIFF</source>
        <translation>Importer XLIFF</translation>
    </message>
    <message>
        <source>Translations (*.xlf *.xliff)</source>
        <translation>Oversættelser (*.xlf *.xliff)</translation>
    </message>
    <message>
        <source>Export XLIFF</source>
        <translation>Eksporter XLIFF</translation>
    </message>
    <message>
        <source>Translated from</source>
        <translation>Oversat fra</translation>
    </message>
    <message>
        <source>Translated into</source>
        <translation>Oversat til</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) taken.</source>
        <translation>
            <numerusform>%n tekst overtaget.</numerusform>
            <numerusform>%n tekster overtaget.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) as they were.</source>
        <translation>
            <numerusform>%n tekst som før.</numerusform>
            <numerusform>%n tekster som før.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) without a translation.</source>
        <translation>
            <numerusform>%n tekst uden oversættelse.</numerusform>
            <numerusform>%n tekster uden oversættelse.</numerusform>
        </translation>
    </message>
    <message>
        <source>XLIFF %1</source>
        <translation>XLIFF %1</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Tekster</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksporter</translation>
    </message>
    <message>
        <source>Remove language</source>
        <translation>Fjern sprog</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Fjern&#xa0;%1</translation>
    </message>
    <message>
        <source>%1 is not a language tag; choose one from the list, or enter a tag such as de or zh-CN</source>
        <translation>%1 er ikke en sprogkode; vælg en på listen, eller skriv en kode som de eller zh-CN</translation>
    </message>
    <message>
        <source>The table already has %1; choose another language</source>
        <translation>Tabellen har allerede&#xa0;%1; vælg et andet sprog</translation>
    </message>
    <message>
        <source>Remove the language</source>
        <translation>Fjern sproget</translation>
    </message>
    <message>
        <source>Select a cell of the language that is to be removed.</source>
        <translation>Vælg en celle i det sprog, der skal fjernes.</translation>
    </message>
    <message>
        <source>A table of texts keeps one language; add another one first.</source>
        <translation>En teksttabel beholder ét sprog; tilføj først et andet.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::TextModel</name>
    <message>
        <source>Key</source>
        <translation>Nøgle</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Rename key</source>
        <translation>Omdøb nøgle</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ThemeDialog</name>
    <message>
        <source>Grounds, lines and texts</source>
        <translation>Baggrunde, linjer og tekster</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Proces</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmer</translation>
    </message>
    <message>
        <source>Colours by name</source>
        <translation>Farver efter navn</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurver</translation>
    </message>
    <message>
        <source>Based on</source>
        <translation>Baseret på</translation>
    </message>
    <message>
        <source>Colours that this theme does not change are those of the base.</source>
        <translation>Farver, som dette tema ikke ændrer, er basens.</translation>
    </message>
    <message>
        <source>Panel Themes</source>
        <translation>Panelernes temaer</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Forhåndsvisning</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farver</translation>
    </message>
    <message>
        <source>Base of the Theme</source>
        <translation>Temaets base</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Ny…</translation>
    </message>
    <message>
        <source>New Theme</source>
        <translation>Nyt tema</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Omdøb…</translation>
    </message>
    <message>
        <source>Rename Theme</source>
        <translation>Omdøb tema</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Slet</translation>
    </message>
    <message>
        <source>Name of the theme:</source>
        <translation>Temaets navn:</translation>
    </message>
    <message>
        <source>A theme&apos;s name cannot contain %1; choose another name</source>
        <translation>Et temas navn må ikke indeholde %1; vælg et andet navn</translation>
    </message>
    <message>
        <source>A theme&apos;s name begins with a letter or a digit</source>
        <translation>Et temas navn begynder med et bogstav eller et ciffer</translation>
    </message>
    <message>
        <source>There is a theme %1 already; choose another name</source>
        <translation>Der er allerede et tema %1; vælg et andet navn</translation>
    </message>
    <message>
        <source>There is a file %1 already; choose another name</source>
        <translation>Der er allerede en fil %1; vælg et andet navn</translation>
    </message>
    <message>
        <source>%1 is used on %2; choose another theme there before it is deleted</source>
        <translation>%1 bruges på %2; vælg først et andet tema dér</translation>
    </message>
    <message>
        <source>Delete Theme</source>
        <translation>Slet tema</translation>
    </message>
    <message>
        <source>The project has no theme of its own yet. New… makes one that begins with the colours shown.</source>
        <translation>Projektet har endnu ikke sit eget tema. Ny… opretter et, der begynder med de viste farver.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>og %n mere</numerusform>
            <numerusform>og %n mere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 on %2: contrast %L3, %L4 is needed</source>
        <translation>%1 på %2: kontrast %L3, der kræves %L4</translation>
    </message>
    <message>
        <source>Changed on disk too: %1. OK replaces what is there.</source>
        <translation>Også ændret på disken: %1. OK erstatter det, der står dér.</translation>
    </message>
    <message>
        <source>Discard the changes of the themes?</source>
        <translation>Kassér ændringerne af temaerne?</translation>
    </message>
</context>
<context>
    <name>plc::kit::Canvas</name>
    <message>
        <source>Overview</source>
        <translation>Oversigt</translation>
    </message>
</context>
<context>
    <name>plc::kit::ColorPopup</name>
    <message>
        <source>Colours</source>
        <translation>Farver</translation>
    </message>
    <message>
        <source>More colours…</source>
        <translation>Flere farver…</translation>
    </message>
    <message>
        <source>No colour</source>
        <translation>Ingen farve</translation>
    </message>
</context>
<context>
    <name>plc::kit::ColumnMenu</name>
    <message>
        <source>Column %1</source>
        <translation>Kolonne %1</translation>
    </message>
    <message>
        <source>Fit to Contents</source>
        <translation>Tilpas til indholdet</translation>
    </message>
    <message>
        <source>Wider</source>
        <translation>Bredere</translation>
    </message>
    <message>
        <source>Narrower</source>
        <translation>Smallere</translation>
    </message>
    <message>
        <source>Move Left</source>
        <translation>Flyt til venstre</translation>
    </message>
    <message>
        <source>Move Right</source>
        <translation>Flyt til højre</translation>
    </message>
    <message>
        <source>Sort Ascending</source>
        <translation>Sorter stigende</translation>
    </message>
    <message>
        <source>Sort Descending</source>
        <translation>Sorter faldende</translation>
    </message>
</context>
<context>
    <name>plc::kit::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation>Kommandopalet</translation>
    </message>
    <message>
        <source>Type to find a command</source>
        <translation>Skriv for at finde en kommando</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Kommando</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Kommandoer</translation>
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
        <translation>Vælg en variabel</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Vælg en fil</translation>
    </message>
    <message>
        <source>Edit in a window</source>
        <translation>Rediger i et vindue</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nej</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>Egenskab</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Værdi</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Egenskaber</translation>
    </message>
    <message>
        <source>various</source>
        <translation>forskellige</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Nulstil</translation>
    </message>
    <message>
        <source>Choose from a list</source>
        <translation>Vælg fra en liste</translation>
    </message>
</context>
<context>
    <name>plc::kit::VariablePicker</name>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Search variables</source>
        <translation>Søg variabler</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variabler</translation>
    </message>
    <message>
        <source>Found variables</source>
        <translation>Fundne variabler</translation>
    </message>
    <message>
        <source>Choose a variable</source>
        <translation>Vælg en variabel</translation>
    </message>
</context>
<context>
    <name>plc::kit::WorkStrip</name>
    <message>
        <source>Cancel</source>
        <translation>Annuller</translation>
    </message>
    <message>
        <source>%1 is being cancelled…</source>
        <translation>%1: afbrydes…</translation>
    </message>
    <message>
        <source>Cancel: %1</source>
        <translation>Annuller: %1</translation>
    </message>
</context>
<context>
    <name>plc::plot::PlotView</name>
    <message>
        <source>Chart</source>
        <translation>Diagram</translation>
    </message>
    <message>
        <source>%1
Click selects, Ctrl+click shows or hides.</source>
        <translation>%1
Klik vælger, Ctrl+klik viser eller skjuler.</translation>
    </message>
</context>
<context>
    <name>plc::trace::ChannelPanel</name>
    <message>
        <source>Variable or expression</source>
        <translation>Variabel eller udtryk</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Tilføj en kanal</translation>
    </message>
    <message>
        <source>Add as a channel</source>
        <translation>Tilføj som kanal</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Værdi</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanaler</translation>
    </message>
    <message>
        <source>Show channel</source>
        <translation>Vis kanal</translation>
    </message>
    <message>
        <source>Hide channel</source>
        <translation>Skjul kanal</translation>
    </message>
    <message>
        <source>Chart %1</source>
        <translation>Diagram %1</translation>
    </message>
    <message>
        <source>error</source>
        <translation>fejl</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Udtryk</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Enhed</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linje</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Trappe</translation>
    </message>
    <message>
        <source>Digital</source>
        <translation>Digital</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farve</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Linjebredde</translation>
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
        <translation>Diagram</translation>
    </message>
    <message>
        <source>New chart</source>
        <translation>Nyt diagram</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Akse</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Akse %1</translation>
    </message>
    <message>
        <source>New axis</source>
        <translation>Ny akse</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Share of height</source>
        <translation>Andel af højden</translation>
    </message>
    <message>
        <source>Scaling</source>
        <translation>Skalering</translation>
    </message>
    <message>
        <source>Fit to view</source>
        <translation>Tilpas til visning</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fast</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maksimum</translation>
    </message>
    <message>
        <source>On the right</source>
        <translation>Til højre</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Every n-th scan</source>
        <translation>Hvert n-te scan</translation>
    </message>
    <message>
        <source>Record while</source>
        <translation>Optagelsesbetingelse</translation>
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
        <translation>Stigende</translation>
    </message>
    <message>
        <source>Falling</source>
        <translation>Faldende</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Begge</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Tilstand</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Fra</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Enkelt</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Gentaget</translation>
    </message>
    <message>
        <source>Shown before</source>
        <translation>Vist før triggeren</translation>
    </message>
    <message>
        <source>Shown after</source>
        <translation>Vist efter triggeren</translation>
    </message>
    <message>
        <source>Change channel</source>
        <translation>Ændr kanal</translation>
    </message>
    <message>
        <source>Change chart</source>
        <translation>Ændr diagram</translation>
    </message>
    <message>
        <source>Change trace</source>
        <translation>Ændr trace</translation>
    </message>
    <message>
        <source>Remove channel</source>
        <translation>Fjern kanal</translation>
    </message>
    <message>
        <source>Remove chart</source>
        <translation>Fjern diagram</translation>
    </message>
    <message>
        <source>Move channel</source>
        <translation>Flyt kanal</translation>
    </message>
    <message>
        <source>Compared recording</source>
        <translation>Sammenlignet optagelse</translation>
    </message>
    <message>
        <source>Offset in time</source>
        <translation>Forskydning i tid</translation>
    </message>
</context>
<context>
    <name>plc::trace::FigurePane</name>
    <message>
        <source>Save as %1</source>
        <translation>Gem som %1</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Tilpas</translation>
    </message>
    <message>
        <source>Copy as Picture</source>
        <translation>Kopier som billede</translation>
    </message>
    <message>
        <source>Save as %1…</source>
        <translation>Gem som %1…</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Vinduesfunktion</translation>
    </message>
    <message>
        <source>Hann window</source>
        <translation>Hann-vindue</translation>
    </message>
    <message>
        <source>Flat top: exact amplitudes</source>
        <translation>Flat top: nøjagtige amplituder</translation>
    </message>
    <message>
        <source>No window</source>
        <translation>Intet vindue</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logaritmisk</translation>
    </message>
    <message>
        <source>Charts over time only</source>
        <translation>Kun tidsdiagrammer</translation>
    </message>
    <message>
        <source>Horizontal value</source>
        <translation>Vandret værdi</translation>
    </message>
    <message>
        <source>Window of the spectrum</source>
        <translation>Spektrets vinduesfunktion</translation>
    </message>
    <message>
        <source>Logarithmic axes</source>
        <translation>Logaritmiske akser</translation>
    </message>
    <message>
        <source>Input:</source>
        <translation>Indgang:</translation>
    </message>
    <message>
        <source>Horizontal:</source>
        <translation>Vandret:</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Indgang</translation>
    </message>
    <message>
        <source>Measure between Points</source>
        <translation>Mål mellem punkter</translation>
    </message>
</context>
<context>
    <name>plc::trace::TimeBar</name>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Resumed from here
%1</source>
        <translation>Fortsat herfra
%1</translation>
    </message>
</context>
<context>
    <name>plc::trace::TimeSlider</name>
    <message>
        <source>Time slider</source>
        <translation>Tidsskyder</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variabel</translation>
    </message>
    <message>
        <source>Variable whose changes to step to</source>
        <translation>Variabel, hvis ændringer der springes til</translation>
    </message>
    <message>
        <source>The arrows beside step to its previous and next change</source>
        <translation>Pilene ved siden af går til forrige og næste ændring</translation>
    </message>
    <message>
        <source>One scan back (Left)</source>
        <translation>Ét scan tilbage (Venstre)</translation>
    </message>
    <message>
        <source>One scan forward (Right)</source>
        <translation>Ét scan frem (Højre)</translation>
    </message>
    <message>
        <source>Previous change of the variable (Ctrl+Left)</source>
        <translation>Variablens forrige ændring (Ctrl+Venstre)</translation>
    </message>
    <message>
        <source>Next change of the variable (Ctrl+Right)</source>
        <translation>Variablens næste ændring (Ctrl+Højre)</translation>
    </message>
    <message>
        <source>Resume the controller from this scan</source>
        <translation>Fortsæt styringen fra dette scan</translation>
    </message>
    <message>
        <source>Back to the newest scan (End)</source>
        <translation>Tilbage til nyeste scan (End)</translation>
    </message>
    <message>
        <source>Older scans are no longer kept.</source>
        <translation>Ældre scan er ikke længere bevaret.</translation>
    </message>
    <message>
        <source>%1 does not change before this scan.</source>
        <translation>%1 ændrer sig ikke før dette scan.</translation>
    </message>
    <message>
        <source>%1 does not change after this scan.</source>
        <translation>%1 ændrer sig ikke efter dette scan.</translation>
    </message>
    <message>
        <source>No recording</source>
        <translation>Ingen optagelse</translation>
    </message>
    <message>
        <source>no longer kept</source>
        <translation>ikke længere bevaret</translation>
    </message>
    <message>
        <source>scan %1  %2</source>
        <translation>scan %1  %2</translation>
    </message>
</context>
<context>
    <name>plc::trace::TraceView</name>
    <message>
        <source>Rename</source>
        <translation>Omdøb</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Målinger</translation>
    </message>
    <message>
        <source>Show channel</source>
        <translation>Vis kanal</translation>
    </message>
    <message>
        <source>Hide channel</source>
        <translation>Skjul kanal</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Følg</translation>
    </message>
    <message>
        <source>Follow the newest scan (End)</source>
        <translation>Følg det nyeste scan (End)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Tilpas</translation>
    </message>
    <message>
        <source>Show everything recorded (Home)</source>
        <translation>Vis alt optaget (Home)</translation>
    </message>
    <message>
        <source>Fit values</source>
        <translation>Tilpas værdier</translation>
    </message>
    <message>
        <source>Let the value axes fit again</source>
        <translation>Tilpas værdiakserne automatisk igen</translation>
    </message>
    <message>
        <source>Zoom back</source>
        <translation>Zoom tilbage</translation>
    </message>
    <message>
        <source>Back to the view before (Backspace)</source>
        <translation>Tilbage til forrige visning (Backspace)</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Drag a box to zoom: flat for time, upright for values</source>
        <translation>Træk en ramme for at zoome: flad for tid, høj for værdier</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Panorer</translation>
    </message>
    <message>
        <source>Drag to pan (middle button always does)</source>
        <translation>Træk for at panorere (midterste museknap gør det altid)</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Markører</translation>
    </message>
    <message>
        <source>Two cursors (Ctrl+click sets A, Shift+click sets B)</source>
        <translation>To markører (Ctrl+klik sætter A, Skift+klik sætter B)</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mål</translation>
    </message>
    <message>
        <source>Table of values and statistics between the cursors</source>
        <translation>Tabel med værdier og statistik mellem markørerne</translation>
    </message>
    <message>
        <source>Measuring table</source>
        <translation>Måletabel</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Arm the trigger set in the properties of the trace</source>
        <translation>Aktiver triggeren fra tracens egenskaber</translation>
    </message>
    <message>
        <source>Previous trigger</source>
        <translation>Forrige trigger</translation>
    </message>
    <message>
        <source>Where the trigger would have fired before</source>
        <translation>Hvor triggeren ville være udløst før</translation>
    </message>
    <message>
        <source>Next trigger</source>
        <translation>Næste trigger</translation>
    </message>
    <message>
        <source>Where the trigger would have fired next</source>
        <translation>Hvor triggeren ville være udløst næste gang</translation>
    </message>
    <message>
        <source>Add chart</source>
        <translation>Tilføj diagram</translation>
    </message>
    <message>
        <source>Another chart over the same time</source>
        <translation>Endnu et diagram over samme tid</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Sammenlign</translation>
    </message>
    <message>
        <source>Load an older recording beneath the present one</source>
        <translation>Indlæs en ældre optagelse under den nuværende</translation>
    </message>
    <message>
        <source>Recording to draw beneath</source>
        <translation>Optagelse, der tegnes nedenunder</translation>
    </message>
    <message>
        <source>Trace configuration</source>
        <translation>Traceopsætning</translation>
    </message>
    <message>
        <source>Open Configuration…</source>
        <translation>Åbn opsætning…</translation>
    </message>
    <message>
        <source>Open trace configuration</source>
        <translation>Åbn traceopsætning</translation>
    </message>
    <message>
        <source>Trace configurations (*.trace.json)</source>
        <translation>Traceopsætninger (*.trace.json)</translation>
    </message>
    <message>
        <source>Save trace configuration</source>
        <translation>Gem traceopsætning</translation>
    </message>
    <message>
        <source>Save Configuration</source>
        <translation>Gem opsætning</translation>
    </message>
    <message>
        <source>Save Configuration As…</source>
        <translation>Gem opsætning som…</translation>
    </message>
    <message>
        <source>Open Recording…</source>
        <translation>Åbn optagelse…</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Åbn optagelse</translation>
    </message>
    <message>
        <source>Back to the Running PLC</source>
        <translation>Tilbage til livevisning</translation>
    </message>
    <message>
        <source>Save Recording…</source>
        <translation>Gem optagelse…</translation>
    </message>
    <message>
        <source>Save recording</source>
        <translation>Gem optagelse</translation>
    </message>
    <message>
        <source>Recordings (*.rec)</source>
        <translation>Optagelser (*.rec)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksporter</translation>
    </message>
    <message>
        <source>Copy as Picture</source>
        <translation>Kopier som billede</translation>
    </message>
    <message>
        <source>Save Samples in View as CSV…</source>
        <translation>Gem viste målinger som CSV…</translation>
    </message>
    <message>
        <source>Save as %1…</source>
        <translation>Gem som %1…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Udskriv…</translation>
    </message>
    <message>
        <source>Save as %1</source>
        <translation>Gem som %1</translation>
    </message>
    <message>
        <source>Add channel</source>
        <translation>Tilføj kanal</translation>
    </message>
    <message>
        <source>Arm trigger</source>
        <translation>Aktiver trigger</translation>
    </message>
    <message>
        <source>The trigger has no expression yet: enter one in the properties of the trace.</source>
        <translation>Triggeren har endnu intet udtryk: indtast et i tracens egenskaber.</translation>
    </message>
    <message>
        <source>Trigger armed</source>
        <translation>Trigger aktiveret</translation>
    </message>
    <message>
        <source>Triggered, collecting</source>
        <translation>Udløst, samler</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>Udløst</translation>
    </message>
    <message numerus="yes">
        <source>(%n shot(s))</source>
        <translation>
            <numerusform>(%n udløsning)</numerusform>
            <numerusform>(%n udløsninger)</numerusform>
        </translation>
    </message>
    <message>
        <source>Not running</source>
        <translation>Kører ikke</translation>
    </message>
    <message>
        <source>%L1 scans kept  ·  history %2 of %3 MB  ·  channels %4 of %5 MB</source>
        <translation>%L1 scan gemt  ·  historik %2 af %3&#xa0;MB  ·  kanaler %4 af %5&#xa0;MB</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Egenskaber</translation>
    </message>
    <message>
        <source>Remove Channel</source>
        <translation>Fjern kanal</translation>
    </message>
    <message>
        <source>Add Channel…</source>
        <translation>Tilføj kanal…</translation>
    </message>
    <message>
        <source>Trigger off</source>
        <translation>Trigger fra</translation>
    </message>
    <message>
        <source>Saving the samples…</source>
        <translation>Måleværdier gemmes…</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Åbner %1…</translation>
    </message>
    <message>
        <source>Saving the recording…</source>
        <translation>Gemmer optagelsen…</translation>
    </message>
    <message>
        <source>%1, %2 later</source>
        <translation>%1, %2 senere</translation>
    </message>
    <message>
        <source>%1, %2 earlier</source>
        <translation>%1, %2 tidligere</translation>
    </message>
    <message>
        <source>Measure between points</source>
        <translation>Mål mellem punkter</translation>
    </message>
    <message>
        <source>Drag from one point to another: time, value, slope and frequency between them (M)</source>
        <translation>Træk fra ét punkt til et andet: tid, værdi, hældning og frekvens mellem dem (M)</translation>
    </message>
    <message>
        <source>XY plot, spectrum, frequency response, runs</source>
        <translation>XY-diagram, spektrum, frekvensrespons, kørsler</translation>
    </message>
    <message>
        <source>Add Channel of Another File…</source>
        <translation>Tilføj kanal fra en anden fil…</translation>
    </message>
    <message>
        <source>Show Beside</source>
        <translation>Vis ved siden af</translation>
    </message>
    <message>
        <source>Measure between Points</source>
        <translation>Mål mellem punkter</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>Tilføj note</translation>
    </message>
    <message>
        <source>Add Note</source>
        <translation>Tilføj note</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Note:</translation>
    </message>
    <message>
        <source>Edit Note</source>
        <translation>Rediger note</translation>
    </message>
    <message>
        <source>Edit note</source>
        <translation>Rediger note</translation>
    </message>
    <message>
        <source>Remove note</source>
        <translation>Fjern note</translation>
    </message>
    <message>
        <source>Edit Note…</source>
        <translation>Rediger note…</translation>
    </message>
    <message>
        <source>Remove Note</source>
        <translation>Fjern note</translation>
    </message>
    <message>
        <source>Add Note…</source>
        <translation>Tilføj note…</translation>
    </message>
    <message>
        <source>File to add a channel of</source>
        <translation>Fil, som en kanal tilføjes fra</translation>
    </message>
    <message>
        <source>Recordings and tables (*.rec *.csv *.tsv *.txt *.trace);;All files (*)</source>
        <translation>Optagelser og tabeller (*.rec *.csv *.tsv *.txt *.trace);;Alle filer (*)</translation>
    </message>
</context>
</TS>
