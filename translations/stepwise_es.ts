<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>DeviceFields</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protocolo</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>Habilitado</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Puerto</translation>
    </message>
    <message>
        <source>Unit number</source>
        <translation>Número de unidad</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Puerto serie</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Velocidad de transmisión</translation>
    </message>
    <message>
        <source>Parity</source>
        <translation>Paridad</translation>
    </message>
    <message>
        <source>Data bits</source>
        <translation>Bits de datos</translation>
    </message>
    <message>
        <source>Stop bits</source>
        <translation>Bits de parada</translation>
    </message>
    <message>
        <source>Poll interval</source>
        <translation>Intervalo de sondeo</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>Tiempo de espera</translation>
    </message>
    <message>
        <source>Longest pause between attempts</source>
        <translation>Pausa máxima entre intentos</translation>
    </message>
    <message>
        <source>Variable: device responds</source>
        <translation>Variable: el dispositivo responde</translation>
    </message>
    <message>
        <source>Client ID</source>
        <translation>Identificador del cliente</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Usuario</translation>
    </message>
    <message>
        <source>Password file</source>
        <translation>Archivo de la contraseña</translation>
    </message>
    <message>
        <source>TLS encryption</source>
        <translation>Cifrado TLS</translation>
    </message>
    <message>
        <source>File of CA certificates</source>
        <translation>Archivo de certificados de la CA</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabla</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Bit of the register</source>
        <translation>Bit del registro</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Orden de los bytes</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Factor</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Desplazamiento</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>Topic</translation>
    </message>
    <message>
        <source>Path in the JSON message</source>
        <translation>Ruta en el mensaje JSON</translation>
    </message>
    <message>
        <source>Quality of service (0 to 2)</source>
        <translation>Calidad de servicio (QoS, 0 a 2)</translation>
    </message>
    <message>
        <source>Retained message</source>
        <translation>Mensaje retenido (retain)</translation>
    </message>
    <message>
        <source>If the connection is lost</source>
        <translation>Si se pierde la conexión</translation>
    </message>
    <message>
        <source>Safe value</source>
        <translation>Valor seguro</translation>
    </message>
    <message>
        <source>Variable: channel is good</source>
        <translation>Variable: el canal es válido</translation>
    </message>
    <message>
        <source>Modbus TCP device</source>
        <translation>Dispositivo Modbus TCP</translation>
    </message>
    <message>
        <source>Modbus RTU device (serial)</source>
        <translation>Dispositivo Modbus RTU (serie)</translation>
    </message>
    <message>
        <source>Modbus TCP server</source>
        <translation>Servidor Modbus TCP</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>Bróker MQTT</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>Bobina (coil)</translation>
    </message>
    <message>
        <source>Discrete input</source>
        <translation>Entrada discreta</translation>
    </message>
    <message>
        <source>Holding register</source>
        <translation>Registro de retención</translation>
    </message>
    <message>
        <source>Input register</source>
        <translation>Registro de entrada</translation>
    </message>
    <message>
        <source>Keep the last value</source>
        <translation>Conservar el último valor</translation>
    </message>
    <message>
        <source>Use the safe value</source>
        <translation>Usar el valor seguro</translation>
    </message>
    <message>
        <source>Stop the controller</source>
        <translation>Parar el controlador</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Par</translation>
    </message>
    <message>
        <source>Odd</source>
        <translation>Impar</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Salida</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Sí</translation>
    </message>
    <message>
        <source>No</source>
        <translation>No</translation>
    </message>
</context>
<context>
    <name>Devices</name>
    <message>
        <source>This is not valid JSON; check the commas and quotes in front of this line</source>
        <translation>Esto no es JSON válido; compruebe las comas y comillas antes de esta línea</translation>
    </message>
    <message>
        <source>The file must be an object with a list named &quot;devices&quot;</source>
        <translation>El archivo debe ser un objeto con una lista llamada «devices»</translation>
    </message>
    <message>
        <source>Each entry of &quot;{0}&quot; must be an object in braces</source>
        <translation>Cada elemento de «{0}» debe ser un objeto entre llaves</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is missing; add it</source>
        <translation>Falta «{0}»; añádalo</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a text in quotes</source>
        <translation>«{0}» debe ser un texto entre comillas</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be true or false</source>
        <translation>«{0}» debe ser true o false</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a number</source>
        <translation>«{0}» debe ser un número</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a whole number from {1} to {2}</source>
        <translation>«{0}» debe ser un número entero de {1} a {2}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a time such as &quot;100ms&quot; or &quot;2s&quot;, at least {1} ms and at most an hour</source>
        <translation>«{0}» debe ser un tiempo como «100ms» o «2s», de al menos {1}&#xa0;ms y como máximo una hora</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; cannot be {1}; choose one of: {2}</source>
        <translation>«{0}» no puede ser {1}; elija uno de estos: {2}</translation>
    </message>
    <message>
        <source>There is no field &quot;{0}&quot;; it is kept but has no effect</source>
        <translation>No existe el campo «{0}»; se conserva, pero no tiene efecto</translation>
    </message>
    <message>
        <source>There is no field &quot;{0}&quot;; did you mean &quot;{1}&quot;?</source>
        <translation>No existe el campo «{0}»; ¿quería decir «{1}»?</translation>
    </message>
    <message>
        <source>There are two devices named {0}; rename one</source>
        <translation>Hay dos dispositivos llamados {0}; renombre uno</translation>
    </message>
    <message>
        <source>{0} has two channels named {1}; rename one</source>
        <translation>{0} tiene dos canales llamados {1}; renombre uno</translation>
    </message>
    <message>
        <source>{0} is not a name; use letters, digits and underscores, and begin with a letter</source>
        <translation>{0} no es un nombre válido; use letras, cifras y guiones bajos, y empiece por una letra</translation>
    </message>
    <message>
        <source>{0} is neither a host name nor an address, for example plc1.local or 192.168.0.10</source>
        <translation>{0} no es un nombre de equipo ni una dirección, por ejemplo plc1.local o 192.168.0.10</translation>
    </message>
    <message>
        <source>{0} is not a serial port; write its path, for example /dev/ttyUSB0</source>
        <translation>{0} no es un puerto serie; escriba su ruta, por ejemplo /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>{0} and {1} both listen on port {2}; change one of the ports</source>
        <translation>{0} y {1} escuchan ambos en el puerto {2}; cambie uno de los puertos</translation>
    </message>
    <message>
        <source>Ports below 1024 require special privileges; use a port such as 1502</source>
        <translation>Los puertos por debajo de 1024 necesitan permisos especiales; use un puerto como 1502</translation>
    </message>
    <message>
        <source>A channel of an MQTT device needs a &quot;topic&quot;, for example &quot;plant/level&quot;</source>
        <translation>Un canal de un dispositivo MQTT necesita un «topic», por ejemplo «plant/level»</translation>
    </message>
    <message>
        <source>{0}: a channel has one topic, without the wildcards + and #</source>
        <translation>{0}: un canal tiene un topic, sin los comodines + y #</translation>
    </message>
    <message>
        <source>{0} is not a path into JSON; write for example /sensor/temperature</source>
        <translation>{0} no es una ruta en JSON; escriba por ejemplo /sensor/temperature</translation>
    </message>
    <message>
        <source>A device does not let others write its table &quot;{0}&quot;; use &quot;coil&quot; or &quot;holding&quot;, or the direction &quot;in&quot;</source>
        <translation>Un dispositivo no deja que otros escriban su tabla «{0}»; use «coil» o «holding», o la dirección «in»</translation>
    </message>
    <message>
        <source>Clients cannot write the table &quot;{0}&quot; of a server; use &quot;coil&quot; or &quot;holding&quot;, or the direction &quot;out&quot;</source>
        <translation>Los clientes no pueden escribir en la tabla «{0}» de un servidor; use «coil» o «holding», o la dirección «out»</translation>
    </message>
    <message>
        <source>{0} needs {1} {1:register|registers} from {2}, but 65535 is the last; choose a lower address</source>
        <translation>{0} necesita {1} {1:registro|registros} desde {2}, pero 65535 es el último; elija una dirección más baja</translation>
    </message>
    <message>
        <source>&quot;bit&quot; selects one bit of a register; the type must then be BOOL</source>
        <translation>«bit» elige un bit de un registro; el tipo debe ser entonces BOOL</translation>
    </message>
    <message>
        <source>The table &quot;{0}&quot; holds bits; the type must be BOOL</source>
        <translation>La tabla «{0}» contiene bits; el tipo debe ser BOOL</translation>
    </message>
    <message>
        <source>A BOOL in a register needs &quot;bit&quot;, from 0 to 15</source>
        <translation>Un BOOL en un registro necesita «bit», de 0 a 15</translation>
    </message>
    <message>
        <source>Only an MQTT channel can be of type STRING; use a number or BOOL</source>
        <translation>Solo un canal MQTT puede ser de tipo STRING; use un número o BOOL</translation>
    </message>
    <message>
        <source>&quot;scale&quot; must not be 0; omit it for 1</source>
        <translation>«scale» no debe ser 0; omítalo para 1</translation>
    </message>
    <message>
        <source>A {0} has no &quot;scale&quot; and &quot;offset&quot;; remove them</source>
        <translation>{0} no tiene «scale» ni «offset»; quítelos</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}: {1}</translation>
    </message>
    <message>
        <source>{0} has no variable yet; enter one, or have the addresses proposed (stepwise devices PROJECT --propose)</source>
        <translation>{0} aún no tiene variable; indique una o haga que se propongan las direcciones (stepwise devices PROJECT --propose)</translation>
    </message>
    <message>
        <source>{0} is of type {1} and cannot hold a {2}; use a variable of that type</source>
        <translation>{0} es de tipo {1} y no puede contener un {2}; use una variable de ese tipo</translation>
    </message>
    <message>
        <source>A {0} may not fit into {1} of type {2}; a value that does not fit leaves the variable as it is and makes the channel bad</source>
        <translation>Un {0} puede no caber en {1} de tipo {2}; un valor que no cabe deja la variable como está e invalida el canal</translation>
    </message>
    <message>
        <source>{0} is an output of the program; an input channel needs %I or a variable</source>
        <translation>{0} es una salida del programa; un canal de entrada necesita %I o una variable</translation>
    </message>
    <message>
        <source>{0} is an input of the program; an output channel needs %Q or a variable</source>
        <translation>{0} es una entrada del programa; un canal de salida necesita %Q o una variable</translation>
    </message>
    <message>
        <source>{0} is a constant and cannot be written; choose a variable</source>
        <translation>{0} es una constante y no se puede escribir; elija una variable</translation>
    </message>
    <message>
        <source>{0} reports the quality of the channel and must be a BOOL or an integer</source>
        <translation>{0} indica si el canal es válido y debe ser BOOL o un entero</translation>
    </message>
    <message>
        <source>{0} reports whether the device responds and must be a BOOL</source>
        <translation>{0} indica si el dispositivo responde y debe ser BOOL</translation>
    </message>
    <message>
        <source>&quot;onLoss&quot;: &quot;safe&quot; needs the value in &quot;safe&quot;</source>
        <translation>«onLoss»: «safe» necesita el valor en «safe»</translation>
    </message>
    <message>
        <source>{0} cannot be read; its first line must be the password</source>
        <translation>{0} no se puede leer; su primera línea debe ser la contraseña</translation>
    </message>
    <message>
        <source>{0} cannot be read; it must contain the certificates of the authority (PEM)</source>
        <translation>{0} no se puede leer; debe contener los certificados de la autoridad (PEM)</translation>
    </message>
    <message>
        <source>no response within {0} ms; check the cable, the address and the unit number</source>
        <translation>sin respuesta en {0}&#xa0;ms; compruebe el cable, la dirección y el número de unidad</translation>
    </message>
    <message>
        <source>the connection ended: {0}; it is being set up again</source>
        <translation>la conexión se ha cerrado: {0}; se está restableciendo</translation>
    </message>
    <message>
        <source>the response does not match the request; check baud rate, parity and unit number</source>
        <translation>la respuesta no corresponde a la solicitud; compruebe la velocidad de transmisión, la paridad y el número de unidad</translation>
    </message>
    <message>
        <source>the device rejects {0} {1}: {2}</source>
        <translation>el dispositivo rechaza {0} {1}: {2}</translation>
    </message>
    <message>
        <source>it does not know the function; choose another table</source>
        <translation>no conoce la función; elija otra tabla</translation>
    </message>
    <message>
        <source>it has no such address; check the address in its manual</source>
        <translation>no tiene esa dirección; compruebe la dirección en su manual</translation>
    </message>
    <message>
        <source>it does not accept the value; check the range in its manual</source>
        <translation>no acepta el valor; compruebe el rango en su manual</translation>
    </message>
    <message>
        <source>it reports a failure; check the device</source>
        <translation>notifica un fallo; revise el dispositivo</translation>
    </message>
    <message>
        <source>it is busy; the request will be repeated</source>
        <translation>está ocupado; se repetirá la solicitud</translation>
    </message>
    <message>
        <source>the gateway cannot reach it; check the unit number and the cable after the gateway</source>
        <translation>la pasarela no lo alcanza; compruebe el número de unidad y el cable detrás de ella</translation>
    </message>
    <message>
        <source>cannot listen on {0}: {1}; choose another address or port</source>
        <translation>no se puede escuchar en {0}: {1}; elija otra dirección u otro puerto</translation>
    </message>
    <message>
        <source>{0}: the message holds no value that can be read; check what the device publishes</source>
        <translation>{0}: el mensaje no contiene ningún valor legible; compruebe lo que publica el dispositivo</translation>
    </message>
    <message>
        <source>{0}: a value does not fit into the variable; use a larger type or a scale</source>
        <translation>{0}: un valor no cabe en la variable; use un tipo mayor o un factor de escala</translation>
    </message>
    <message>
        <source>no client has written for {0} ms; check the client and its address</source>
        <translation>ningún cliente ha escrito en {0}&#xa0;ms; compruebe el cliente y su dirección</translation>
    </message>
    <message>
        <source>the broker rejects the connection: {0}; check the user and the password</source>
        <translation>el bróker rechaza la conexión: {0}; compruebe el usuario y la contraseña</translation>
    </message>
    <message>
        <source>the input {0} of the device {1} was lost; check the device and its cable</source>
        <translation>se perdió la entrada {0} del dispositivo {1}; compruebe el dispositivo y su cable</translation>
    </message>
    <message>
        <source>the input {0} of the device {1} was lost: {2}</source>
        <translation>se perdió la entrada {0} del dispositivo {1}: {2}</translation>
    </message>
    <message>
        <source>Start or build the project first; the devices are connected to its controller</source>
        <translation>Inicie o compile primero el proyecto; los dispositivos están conectados a su controlador</translation>
    </message>
    <message>
        <source>The project had no devices when its controller was built; add them and build again</source>
        <translation>El proyecto no tenía dispositivos cuando se compiló su controlador; añádalos y vuelva a compilar</translation>
    </message>
    <message>
        <source>The devices had errors when the controller was built; correct them and build again</source>
        <translation>Los dispositivos tenían errores cuando se compiló el controlador; corríjalos y vuelva a compilar</translation>
    </message>
    <message>
        <source>Set the speed to real time first; devices cannot follow any other speed</source>
        <translation>Ajuste primero la velocidad a tiempo real; los dispositivos no pueden seguir otra</translation>
    </message>
    <message>
        <source>The devices of an attached controller are connected there; detach to connect them here</source>
        <translation>Los dispositivos de un controlador remoto están conectados allí; desconéctese para conectarlos aquí</translation>
    </message>
    <message>
        <source>{0} and {1} write the same bytes: {2}; change an address</source>
        <translation>{0} y {1} escriben los mismos bytes: {2}; cambie una dirección</translation>
    </message>
    <message>
        <source>There is no free address left for {0}; give it a variable</source>
        <translation>No queda ninguna dirección libre para {0}; asígnele una variable</translation>
    </message>
    <message>
        <source>{0} has no channels, so nothing is exchanged; add one</source>
        <translation>{0} no tiene canales, por lo que no se intercambia nada; añada uno</translation>
    </message>
    <message>
        <source>cannot connect to {0}: {1}; check the address and the cable</source>
        <translation>no se puede conectar con {0}: {1}; compruebe la dirección y el cable</translation>
    </message>
    <message>
        <source>{0} and {1} are both unit {2} of {3}; give one of them another number</source>
        <translation>{0} y {1} tienen ambos la dirección {2} en {3}; dé otra a uno de ellos</translation>
    </message>
    <message>
        <source>{0} and {1} use {2} with different baud rates, parities or bits; set the same for both</source>
        <translation>{0} y {1} usan {2} con velocidades, paridades o bits distintos; ajuste lo mismo en ambos</translation>
    </message>
    <message>
        <source>{0} and {1} both set {2} {3}; give each its own</source>
        <translation>{0} y {1} escriben ambos {2} {3}; dé uno propio a cada uno</translation>
    </message>
    <message>
        <source>{0} and {1} are both unit {2} at {3}; if one was copied from the other, change its address</source>
        <translation>{0} y {1} tienen ambos la dirección {2} en {3}; si uno se copió del otro, cambie su dirección</translation>
    </message>
</context>
<context>
    <name>Diagnostics</name>
    <message>
        <source>Unterminated comment; close it with *)</source>
        <translation>Comentario sin terminar; ciérrelo con *)</translation>
    </message>
    <message>
        <source>Unterminated string; add the closing quote</source>
        <translation>Cadena sin terminar; añada la comilla de cierre</translation>
    </message>
    <message>
        <source>Expected {0} before {1}</source>
        <translation>Se esperaba {0} antes de {1}</translation>
    </message>
    <message>
        <source>A semicolon is missing here; add it</source>
        <translation>Falta un punto y coma aquí; añádalo</translation>
    </message>
    <message>
        <source>{0} is missing for this {1}; add it</source>
        <translation>Falta {0} para este {1}; añádalo</translation>
    </message>
    <message>
        <source>This comparison has no effect; use := to assign</source>
        <translation>Esta comparación no tiene efecto; use := para asignar</translation>
    </message>
    <message>
        <source>An assignment is not a condition; use = to compare</source>
        <translation>Una asignación no es una condición; use = para comparar</translation>
    </message>
    <message>
        <source>A colon is missing between the name and its type; add it</source>
        <translation>Faltan dos puntos entre el nombre y su tipo; añádalos</translation>
    </message>
    <message>
        <source>Decimal numbers use a point; write {0}</source>
        <translation>Los números decimales usan punto; escriba {0}</translation>
    </message>
    <message>
        <source>An open bound is written ARRAY[*] and is only allowed for VAR_IN_OUT; declare it there, or write a number</source>
        <translation>Un límite abierto se escribe ARRAY[*] y solo se permite en VAR_IN_OUT; declárelo allí o escriba un número</translation>
    </message>
    <message>
        <source>{0} is missing: the program unit ends here; add it</source>
        <translation>Falta {0}: la POU termina aquí; añádalo</translation>
    </message>
    <message>
        <source>A semicolon is missing: the statement ends here; add it</source>
        <translation>Falta un punto y coma: la instrucción termina aquí; añádalo</translation>
    </message>
    <message>
        <source>Implicit conversion from {0} to {1} may lose data; convert it explicitly</source>
        <translation>La conversión implícita de {0} a {1} puede perder datos; convierta explícitamente</translation>
    </message>
    <message>
        <source>{0} is an IN_OUT parameter and needs a variable of type {1}</source>
        <translation>{0} es un parámetro IN_OUT y necesita una variable de tipo {1}</translation>
    </message>
    <message>
        <source>{0} has only the bits 0 to {1}; use one of them</source>
        <translation>{0} solo tiene los bits 0 a {1}; use uno de ellos</translation>
    </message>
    <message>
        <source>{0} is ambiguous: {1}; write the namespace before it</source>
        <translation>{0} es ambiguo: {1}; escriba delante el espacio de nombres</translation>
    </message>
    <message>
        <source>The character {0} is not in STRING ({1}); use WSTRING, or &quot;stringEncoding&quot;: &quot;UTF-8&quot; in project.json</source>
        <translation>El carácter {0} no existe en STRING ({1}); use WSTRING, o &quot;stringEncoding&quot;: &quot;UTF-8&quot; en project.json</translation>
    </message>
    <message>
        <source>{0} and {1} are compared as {2}; convert one of them</source>
        <translation>{0} y {1} se comparan como {2}; convierta uno de los dos</translation>
    </message>
    <message>
        <source>{0} is not checked against the enumeration {1}; use one of its names</source>
        <translation>{0} no se comprueba con la enumeración {1}; use uno de sus nombres</translation>
    </message>
    <message>
        <source>{0} is {1}; write {2}</source>
        <translation>{0} es {1}; escriba {2}</translation>
    </message>
    <message>
        <source>{0} contains itself; use a REFERENCE TO</source>
        <translation>{0} se contiene a sí mismo; use un REFERENCE TO</translation>
    </message>
    <message>
        <source>The parameters of {0} must match those of the overridden method; copy its declarations</source>
        <translation>Los parámetros de {0} deben coincidir con los del método sobrescrito; copie sus declaraciones</translation>
    </message>
    <message>
        <source>There are several programs and no CONFIGURATION; name one of them Main or write a CONFIGURATION</source>
        <translation>Hay varios programas y ninguna CONFIGURATION; llame Main a uno de ellos o escriba una CONFIGURATION</translation>
    </message>
    <message>
        <source>The range {0}..{1} is not valid: the lower bound is above the upper bound or there are too many elements; correct the bounds</source>
        <translation>El rango {0}..{1} no es válido: el límite inferior supera al superior o hay demasiados elementos; corrija los límites</translation>
    </message>
    <message>
        <source>{0} has an incomplete address; complete it in a VAR_CONFIG</source>
        <translation>{0} tiene una dirección incompleta; complétela en un VAR_CONFIG</translation>
    </message>
    <message>
        <source>{0} may call itself; the depth of recursion is limited at run time; a loop is safer</source>
        <translation>{0} puede llamarse a sí mismo; la profundidad de recursión está limitada en ejecución; un bucle es más seguro</translation>
    </message>
    <message>
        <source>The steps before this transition cannot be active together; start them from one simultaneous branch</source>
        <translation>Las etapas anteriores a esta transición no pueden estar activas a la vez; inícielas desde una misma rama simultánea</translation>
    </message>
    <message>
        <source>This transition is always true; the step before it lasts one scan; write the condition to wait for</source>
        <translation>Esta transición es siempre verdadera; la etapa anterior dura un ciclo; escriba la condición que se debe esperar</translation>
    </message>
    <message>
        <source>The qualifier {0} needs a time, for example T#2s</source>
        <translation>El calificador {0} necesita un tiempo, por ejemplo T#2s</translation>
    </message>
    <message>
        <source>{0} needs a current result; load one with LD</source>
        <translation>{0} necesita un resultado actual; cargue uno con LD</translation>
    </message>
    <message>
        <source>{0} is not a value of the strict enumeration {1}; use one of its names</source>
        <translation>{0} no es un valor de la enumeración estricta {1}; use uno de sus nombres</translation>
    </message>
    <message>
        <source>{0} is a strict enumeration and cannot be used in arithmetic; convert the value with {1}</source>
        <translation>{0} es una enumeración estricta y no se puede usar en cálculos; convierta el valor con {1}</translation>
    </message>
    <message>
        <source>{0} cannot compare {1} as a whole; compare the members one by one</source>
        <translation>{0} no puede comparar {1} entero; compare los miembros uno por uno</translation>
    </message>
    <message>
        <source>A CASE selector must be an integer, enumeration or character, not {0}; use IF and ELSIF</source>
        <translation>El selector de un CASE debe ser un entero, una enumeración o un carácter, no {0}; use IF y ELSIF</translation>
    </message>
    <message>
        <source>{0} and {1} share storage at {2}; move one of them or write STRUCT OVERLAP</source>
        <translation>{0} y {1} comparten memoria en {2}; mueva uno de los dos o escriba STRUCT OVERLAP</translation>
    </message>
    <message>
        <source>A member&apos;s address is relative to the start of its structure (%B4, %X4.1), not {0}</source>
        <translation>La dirección de un miembro es relativa al comienzo de su estructura (%B4, %X4.1), no {0}</translation>
    </message>
    <message>
        <source>{0} and {1} share the address {2}; {3} is free</source>
        <translation>{0} y {1} comparten la dirección {2}; {3} está libre</translation>
    </message>
    <message>
        <source>{0} belongs to the chart and must be {1}</source>
        <translation>{0} pertenece a la secuencia y debe ser {1}</translation>
    </message>
    <message>
        <source>{0} has no effect without {1}; declare both</source>
        <translation>{0} no tiene efecto sin {1}; declare los dos</translation>
    </message>
    <message>
        <source>A step lists its actions here; write statements in an ACTION</source>
        <translation>Aquí una etapa enumera sus acciones; escriba las instrucciones en una ACTION</translation>
    </message>
    <message>
        <source>No transition leads away from step {0}; the chart ends here; add a TRANSITION if it should go on</source>
        <translation>Ninguna transición sale de la etapa {0}; la secuencia termina aquí; añada una TRANSITION si debe continuar</translation>
    </message>
    <message>
        <source>{0} is also a variable; steps and calls mean the ACTION; rename one of the two</source>
        <translation>{0} también es una variable; las etapas y las llamadas se refieren a la ACTION; cambie el nombre de uno de los dos</translation>
    </message>
    <message>
        <source>Use {1} instead of {0} in Structured Text</source>
        <translation>En texto estructurado, use {1} en lugar de {0}</translation>
    </message>
    <message>
        <source>The task {0} has no INTERVAL above zero and no SINGLE; it runs in every scan; give it an INTERVAL to slow it down</source>
        <translation>La tarea {0} no tiene INTERVAL mayor que cero ni SINGLE; se ejecuta en cada ciclo; indique un INTERVAL para espaciarla</translation>
    </message>
    <message>
        <source>{0} is read as {1}; write a time with its unit</source>
        <translation>{0} se lee como {1}; escriba un tiempo con su unidad</translation>
    </message>
    <message>
        <source>The address {0} has {1} {1:bit|bits}, {2} has {3}; write {4}</source>
        <translation>La dirección {0} tiene {1} {1:bit|bits}, {2} tiene {3}; escriba {4}</translation>
    </message>
    <message>
        <source>{0} is an input declared CONSTANT and is assigned to here; remove CONSTANT or assign to another variable</source>
        <translation>{0} es una entrada declarada CONSTANT y aquí se le asigna un valor; quite CONSTANT o asigne a otra variable</translation>
    </message>
    <message>
        <source>{0}</source>
        <translation>{0}</translation>
    </message>
    <message>
        <source>The condition {0} is not known; combine defined, hasvalue, hasattribute and hastype with NOT, AND and OR</source>
        <translation>La condición {0} no se conoce; use defined, hasvalue, hasattribute y hastype con NOT, AND y OR</translation>
    </message>
    <message>
        <source>The pragma {0} is missing for this {1}; add it</source>
        <translation>Falta el pragma {0} para este {1}; añádalo</translation>
    </message>
    <message>
        <source>The character {0} has no meaning here; remove it</source>
        <translation>El carácter {0} no tiene significado aquí; elimínelo</translation>
    </message>
    <message>
        <source>This is nested too deeply to be compiled; split it into several statements or units</source>
        <translation>El anidamiento es demasiado profundo para compilarlo; divídalo en varias instrucciones o POU</translation>
    </message>
    <message>
        <source>Code in C is not executed; write it in ST</source>
        <translation>El código en C no se ejecuta; escríbalo en ST</translation>
    </message>
    <message>
        <source>{0} is specified twice; remove one of the two</source>
        <translation>{0} se indica dos veces; elimine uno de los dos</translation>
    </message>
    <message>
        <source>{0} is not an array or string; remove the index or declare it as an ARRAY</source>
        <translation>{0} no es un array ni una cadena; elimine el índice o declárelo como ARRAY</translation>
    </message>
    <message>
        <source>The divisor is always zero; divide by another value</source>
        <translation>El divisor es siempre cero; divida por otro valor</translation>
    </message>
    <message>
        <source>A constant is needed here; write a value or the name of a VAR CONSTANT</source>
        <translation>Aquí se necesita una constante; escriba un valor o el nombre de una VAR CONSTANT</translation>
    </message>
    <message>
        <source>{0} is not a pointer or reference; use it without ^ or declare it with REF_TO</source>
        <translation>{0} no es un puntero ni una referencia; úselo sin ^ o declárelo con REF_TO</translation>
    </message>
    <message>
        <source>{0} does not return a value; call it in a statement of its own</source>
        <translation>{0} no devuelve ningún valor; llámelo en una instrucción propia</translation>
    </message>
    <message>
        <source>{0} is abstract and cannot be instantiated; use a block that extends it</source>
        <translation>{0} es abstracto y no se puede instanciar; use un bloque que lo extienda</translation>
    </message>
    <message>
        <source>{0} is {1} and cannot be used here; make it PUBLIC or use it inside its block</source>
        <translation>{0} es {1} y no se puede usar aquí; declárelo PUBLIC o úselo dentro de su bloque</translation>
    </message>
    <message>
        <source>The result of {0} is not used; assign it to a variable</source>
        <translation>El resultado de {0} no se usa; asígnelo a una variable</translation>
    </message>
    <message>
        <source>{0} is declared twice; rename or remove one of the two</source>
        <translation>{0} está declarado dos veces; cambie el nombre de uno de los dos o elimínelo</translation>
    </message>
    <message>
        <source>There is no type {0}; declare it or add the library that contains it</source>
        <translation>No existe el tipo {0}; declárelo o añada la biblioteca que lo contiene</translation>
    </message>
    <message>
        <source>{0} is never used; remove its declaration</source>
        <translation>{0} no se usa nunca; elimine su declaración</translation>
    </message>
    <message>
        <source>{0} is read but never written; give it a value or declare it as CONSTANT</source>
        <translation>{0} se lee, pero no se escribe nunca; dele un valor o declárelo como CONSTANT</translation>
    </message>
    <message>
        <source>This is never executed; remove it or change what is before it</source>
        <translation>Esto no se ejecuta nunca; elimínelo o cambie lo que hay antes</translation>
    </message>
    <message>
        <source>The result of {0} is not set on every path; assign it before the first RETURN or IF</source>
        <translation>El resultado de {0} no se asigna en todos los caminos; asígnelo antes del primer RETURN o IF</translation>
    </message>
    <message>
        <source>CASE has no branch for {0} and no ELSE; add one of them</source>
        <translation>CASE no tiene ninguna rama para {0} ni ELSE; añada una de las dos cosas</translation>
    </message>
    <message>
        <source>{0} already has a branch; remove one of the two</source>
        <translation>{0} ya tiene una rama; elimine una de las dos</translation>
    </message>
    <message>
        <source>The task {0} is declared twice; rename one of the two</source>
        <translation>La tarea {0} está declarada dos veces; cambie el nombre de una de las dos</translation>
    </message>
    <message>
        <source>There is no task {0}; declare it with TASK in this configuration</source>
        <translation>No existe la tarea {0}; declárela con TASK en esta configuración</translation>
    </message>
    <message>
        <source>{0} does not implement {1} of {2}; add it</source>
        <translation>{0} no implementa {1} de {2}; añádalo</translation>
    </message>
    <message>
        <source>{0} is FINAL and cannot be extended or overridden; remove FINAL or use another base</source>
        <translation>{0} es FINAL y no se puede extender ni sobrescribir; elimine FINAL o use otra base</translation>
    </message>
    <message>
        <source>There is no label {0}; write it with a colon before a statement of this unit</source>
        <translation>No existe la etiqueta {0}; escríbala con dos puntos antes de una instrucción de esta POU</translation>
    </message>
    <message>
        <source>The variables need {0} bytes; the maximum is {1}: make arrays or strings smaller</source>
        <translation>Las variables necesitan {0} bytes; el máximo es {1}: reduzca arrays o cadenas</translation>
    </message>
    <message>
        <source>There is no PROGRAM to run; add one</source>
        <translation>No hay ningún PROGRAM que ejecutar; añada uno</translation>
    </message>
    <message>
        <source>There is no namespace {0}; declare it or add the library that contains it</source>
        <translation>No existe el espacio de nombres {0}; declárelo o añada la biblioteca que lo contiene</translation>
    </message>
    <message>
        <source>{0} is not a variable of this configuration; write program instance and variable, as in Main.x</source>
        <translation>{0} no es una variable de esta configuración; escriba la instancia de programa y la variable, como en Main.x</translation>
    </message>
    <message>
        <source>{0} restarts on every call because functions keep no state; use a FUNCTION_BLOCK</source>
        <translation>{0} se reinicia en cada llamada, porque las funciones no conservan estado; use un FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>Too many initial values: {0} for {1} {1:element|elements}; remove some or enlarge the array</source>
        <translation>Demasiados valores iniciales: {0} para {1} {1:elemento|elementos}; elimine algunos o amplíe el array</translation>
    </message>
    <message>
        <source>This loop never ends and would stop the controller; give it a condition or an EXIT</source>
        <translation>Este bucle no termina nunca y bloquearía el controlador; dele una condición o un EXIT</translation>
    </message>
    <message>
        <source>{0} is marked OVERRIDE, but no base has a method with this name; remove OVERRIDE or correct the name</source>
        <translation>{0} está marcado como OVERRIDE, pero ninguna base tiene un método con ese nombre; elimine OVERRIDE o corrija el nombre</translation>
    </message>
    <message>
        <source>The chart has no INITIAL_STEP; declare its first step with INITIAL_STEP instead of STEP</source>
        <translation>La secuencia no tiene INITIAL_STEP; declare su primera etapa con INITIAL_STEP en lugar de STEP</translation>
    </message>
    <message>
        <source>The chart has two initial steps: {0} and {1}; declare one of them with STEP</source>
        <translation>La secuencia tiene dos etapas iniciales: {0} y {1}; declare una de ellas con STEP</translation>
    </message>
    <message>
        <source>There is no step {0}; declare it or correct the name</source>
        <translation>No existe la etapa {0}; declárela o corrija el nombre</translation>
    </message>
    <message>
        <source>No transition leads to step {0}; it can never become active: add a TRANSITION to it</source>
        <translation>Ninguna transición lleva a la etapa {0}; nunca puede activarse: añada una TRANSITION hacia ella</translation>
    </message>
    <message>
        <source>There is no action or BOOL variable {0}; add an ACTION or declare the variable</source>
        <translation>No existe ninguna acción ni variable BOOL {0}; añada una ACTION o declare la variable</translation>
    </message>
    <message>
        <source>The step {0} is declared twice; rename or remove one of the two</source>
        <translation>La etapa {0} está declarada dos veces; cambie el nombre de una de las dos o elimínela</translation>
    </message>
    <message>
        <source>{0} appears twice in this step with qualifier {1}; remove one of the two</source>
        <translation>{0} aparece dos veces en esta etapa con el calificador {1}; elimine una de las dos</translation>
    </message>
    <message>
        <source>The parenthesis of this instruction is not closed; add an instruction ) after its operands</source>
        <translation>El paréntesis de esta instrucción no está cerrado; añada una instrucción ) después de sus operandos</translation>
    </message>
    <message>
        <source>{0} needs memory that the project does not set aside; write &quot;memoryForNew&quot;: 65536 into project.json</source>
        <translation>{0} necesita memoria que el proyecto no reserva; escriba &quot;memoryForNew&quot;: 65536 en project.json</translation>
    </message>
    <message>
        <source>{0} is not a block of this program and cannot have a task of its own; name one of its blocks</source>
        <translation>{0} no es un bloque de este programa y no puede tener una tarea propia; indique uno de sus bloques</translation>
    </message>
    <message>
        <source>{0} cannot hold an exception code; declare it as __SYSTEM.ExceptionCode</source>
        <translation>{0} no puede contener un código de excepción; declárelo como __SYSTEM.ExceptionCode</translation>
    </message>
    <message>
        <source>{0} converts the number, as in CODESYS; to keep the bits, put both types into a UNION</source>
        <translation>{0} convierte el número, como en CODESYS; para conservar los bits, ponga ambos tipos en una UNION</translation>
    </message>
    <message>
        <source>{0} calls itself, which is not allowed: {1}; use a loop instead</source>
        <translation>{0} se llama a sí mismo, lo que no está permitido: {1}; use un bucle en su lugar</translation>
    </message>
    <message>
        <source>The loop variable {0} is changed inside its loop; use WHILE or another variable</source>
        <translation>La variable de bucle {0} se modifica dentro de su bucle; use WHILE u otra variable</translation>
    </message>
    <message>
        <source>There is no global variable {0} of type {1}; declare it in VAR_GLOBAL</source>
        <translation>No existe la variable global {0} de tipo {1}; declárela en VAR_GLOBAL</translation>
    </message>
    <message>
        <source>The text has {0} and will be truncated to {1}; declare a longer string</source>
        <translation>El texto tiene {0} y se truncará a {1}; declare una cadena más larga</translation>
    </message>
    <message>
        <source>This integer division discards the fraction before the conversion to {0}; convert an operand first</source>
        <translation>Esta división entera descarta los decimales antes de la conversión a {0}; convierta antes un operando</translation>
    </message>
    <message>
        <source>{0} is computed as {1} and may overflow before the conversion to {2}; convert an operand first</source>
        <translation>{0} se calcula como {1} y puede desbordarse antes de la conversión a {2}; convierta antes un operando</translation>
    </message>
    <message>
        <source>{0} is not an IL operator; use one such as LD, ST, AND or JMP</source>
        <translation>{0} no es un operador de IL; use por ejemplo LD, ST, AND o JMP</translation>
    </message>
    <message>
        <source>This array has {0} {0:dimension|dimensions}, not {1}; write an index for each</source>
        <translation>Este array tiene {0} {0:dimensión|dimensiones}, no {1}; escriba un índice para cada una</translation>
    </message>
    <message>
        <source>{0} is not a valid {1} literal; check its prefix, digits and units</source>
        <translation>{0} no es un literal válido ({1}); compruebe el prefijo, las cifras y las unidades</translation>
    </message>
    <message>
        <source>Unexpected {0}; remove it or complete the statement before it</source>
        <translation>{0} inesperado; elimínelo o complete la instrucción anterior</translation>
    </message>
    <message>
        <source>The pragma {0} is not known and has no effect; remove it or correct its name</source>
        <translation>El pragma {0} no se conoce y no tiene efecto; elimínelo o corrija el nombre</translation>
    </message>
    <message>
        <source>{0} is a keyword and cannot be used as a name; choose another name</source>
        <translation>{0} es una palabra clave y no se puede usar como nombre; elija otro nombre</translation>
    </message>
    <message>
        <source>{0} is not declared; declare it or correct the name</source>
        <translation>{0} no está declarado; declárelo o corrija el nombre</translation>
    </message>
    <message>
        <source>{0} has no member {1}; correct the name or add the member</source>
        <translation>{0} no tiene ningún miembro {1}; corrija el nombre o añada el miembro</translation>
    </message>
    <message>
        <source>{0} cannot be converted to {1}; use a value of that type or a conversion function</source>
        <translation>{0} no se puede convertir a {1}; use un valor de ese tipo o una función de conversión</translation>
    </message>
    <message>
        <source>{0} cannot be assigned to; assign to a variable</source>
        <translation>No se puede asignar un valor a {0}; asigne a una variable</translation>
    </message>
    <message>
        <source>{0} cannot be used with {1}; convert the operand first</source>
        <translation>{0} no se puede usar con {1}; convierta antes el operando</translation>
    </message>
    <message>
        <source>{0} cannot combine {1} and {2}; convert one of them</source>
        <translation>{0} no puede combinar {1} y {2}; convierta uno de los dos</translation>
    </message>
    <message>
        <source>{0} cannot be called; call a function, a method or an instance of a block</source>
        <translation>{0} no se puede llamar; llame a una función, un método o una instancia de bloque</translation>
    </message>
    <message>
        <source>{0} has no parameter {1}; correct the name or declare the parameter</source>
        <translation>{0} no tiene ningún parámetro {1}; corrija el nombre o declare el parámetro</translation>
    </message>
    <message>
        <source>The argument for {1} of {0} is missing; add it to the call</source>
        <translation>Falta el argumento de {1} en {0}; añádalo a la llamada</translation>
    </message>
    <message>
        <source>{0} takes {1} {1:argument|arguments}; remove the others</source>
        <translation>{0} espera {1} {1:argumento|argumentos}; elimine los demás</translation>
    </message>
    <message>
        <source>The index {0} is outside {1}..{2}; correct it or enlarge the array</source>
        <translation>El índice {0} está fuera de {1}..{2}; corrija el índice o amplíe el array</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}; use another value or a larger type</source>
        <translation>{0} no cabe en {1}; use otro valor o un tipo mayor</translation>
    </message>
    <message>
        <source>The condition must be BOOL, not {0}; add a comparison</source>
        <translation>La condición debe ser BOOL, no {0}; añada una comparación</translation>
    </message>
    <message>
        <source>The address {0} is outside {1}; use an address in that range</source>
        <translation>La dirección {0} está fuera de {1}; use una dirección de ese rango</translation>
    </message>
    <message>
        <source>{0} is not allowed in a watch or binding, which cannot have side effects; do it in the program</source>
        <translation>{0} no se permite en una supervisión ni en una vinculación de variable, que no pueden tener efectos secundarios; hágalo en el programa</translation>
    </message>
    <message>
        <source>A reference needs a variable that has an address; assign the value to a variable first</source>
        <translation>Una referencia necesita una variable con dirección; asigne antes el valor a una variable</translation>
    </message>
    <message>
        <source>An index must be an integer, not {0}; convert it</source>
        <translation>Un índice debe ser un entero, no {0}; conviértalo</translation>
    </message>
    <message>
        <source>{1} cannot extend {0}; choose a base of the same kind</source>
        <translation>{1} no puede extender {0}; elija una base de la misma clase</translation>
    </message>
    <message>
        <source>{0} is not allowed {1}; move or remove it</source>
        <translation>{0} no se permite {1}; muévalo o elimínelo</translation>
    </message>
    <message>
        <source>{0} is only allowed inside a loop; move or remove it</source>
        <translation>{0} solo se permite dentro de un bucle; muévalo o elimínelo</translation>
    </message>
    <message>
        <source>Step {0} can become active twice at the same time: the branches from here do not join; join them with one transition</source>
        <translation>La etapa {0} puede activarse dos veces a la vez: las ramas que salen de aquí no convergen; únalas con una sola transición</translation>
    </message>
    <message>
        <source>{0} is only allowed in a TEST; move it there</source>
        <translation>{0} solo se permite en un TEST; muévalo allí</translation>
    </message>
    <message>
        <source>This is not text in UTF-8; save the file as UTF-8, or remove it from the project if it is not a text file</source>
        <translation>No es texto en UTF-8; guarde el archivo como UTF-8, o quítelo del proyecto si no es un archivo de texto</translation>
    </message>
    <message>
        <source>{0} is not an action qualifier; use N, R, S, L, D, P, P0, P1, SD, DS or SL</source>
        <translation>{0} no es un calificador de acción; use N, R, S, L, D, P, P0, P1, SD, DS o SL</translation>
    </message>
    <message>
        <source>{0} needs a time after :=, for example T#5s; write one or remove the pragma</source>
        <translation>{0} necesita un tiempo después de :=, por ejemplo T#5s; escriba uno o elimine el pragma</translation>
    </message>
</context>
<context>
    <name>DiskChange</name>
    <message>
        <source>Changed outside</source>
        <translation>Cambiado desde fuera</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and here too.</source>
        <translation>Otro programa cambió %1, y aquí también se cambió.</translation>
    </message>
    <message>
        <source>Compare both side by side, load the file from disk and lose the changes made here, or keep what is here and replace the file with the next save?</source>
        <translation>¿Comparar los dos uno al lado del otro, cargar el archivo del disco y perder los cambios hechos aquí, o conservar lo de aquí y reemplazar el archivo la próxima vez que se guarde?</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Comparar…</translation>
    </message>
    <message>
        <source>Load from Disk</source>
        <translation>Cargar del disco</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Conservar mi versión</translation>
    </message>
</context>
<context>
    <name>EditHistory</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>division by zero; check the divisor first</source>
        <translation>división por cero; compruebe antes el divisor</translation>
    </message>
    <message>
        <source>index {0} is used on an empty array; check its bounds first</source>
        <translation>acceso al índice {0} de un array vacío; compruebe antes sus límites</translation>
    </message>
    <message>
        <source>index {0} is outside {1}..{2}; use an index in this range or enlarge the array</source>
        <translation>el índice {0} está fuera de {1}..{2}; use un índice de este rango o amplíe el array</translation>
    </message>
    <message>
        <source>character {0} is read from an empty string; check LEN first</source>
        <translation>lectura del carácter {0} de una cadena vacía; compruebe antes LEN</translation>
    </message>
    <message>
        <source>character {0} is outside {1}..{2} of the string; use an index in this range</source>
        <translation>el carácter {0} está fuera de {1}..{2} de la cadena; use un índice de este rango</translation>
    </message>
    <message>
        <source>calls are nested too deeply; check for endless recursion</source>
        <translation>las llamadas están anidadas demasiado profundamente; busque una recursión infinita</translation>
    </message>
    <message>
        <source>the called method has no body; override it in the block that is called</source>
        <translation>el método llamado no tiene cuerpo; sobrescríbalo en el bloque al que se llama</translation>
    </message>
    <message>
        <source>the scan was aborted</source>
        <translation>el ciclo se ha interrumpido</translation>
    </message>
    <message>
        <source>there is no expression; enter one</source>
        <translation>no hay ninguna expresión; escriba una</translation>
    </message>
    <message>
        <source>the program of this scan does not have it; choose a later scan</source>
        <translation>no existe en el programa de este ciclo; elija un ciclo posterior</translation>
    </message>
    <message>
        <source>has no value here</source>
        <translation>no tiene valor aquí</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}: {1}</translation>
    </message>
    <message>
        <source>simulation: {0}</source>
        <translation>simulación: {0}</translation>
    </message>
    <message>
        <source>warm</source>
        <translation>en caliente</translation>
    </message>
    <message>
        <source>cold</source>
        <translation>en frío</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>de origen</translation>
    </message>
    <message>
        <source>in the middle of a scan</source>
        <translation>en mitad de un ciclo</translation>
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
        <translation>no se encuentra el archivo o la carpeta; compruebe la ruta</translation>
    </message>
    <message>
        <source>permission denied; check the permissions of the file and its folder</source>
        <translation>permiso denegado; compruebe los permisos del archivo y de su carpeta</translation>
    </message>
    <message>
        <source>no space left on the device; free some space and try again</source>
        <translation>no queda espacio en el dispositivo; libere espacio e inténtelo de nuevo</translation>
    </message>
    <message>
        <source>it is a folder; choose a file</source>
        <translation>es una carpeta; elija un archivo</translation>
    </message>
    <message>
        <source>it is not a folder; choose a folder</source>
        <translation>no es una carpeta; elija una carpeta</translation>
    </message>
    <message>
        <source>the device reports a read or write error; check the drive or the cable</source>
        <translation>el dispositivo notifica un error de lectura o escritura; compruebe la unidad o el cable</translation>
    </message>
    <message>
        <source>it already exists; choose another name</source>
        <translation>ya existe; elija otro nombre</translation>
    </message>
    <message>
        <source>the file is too large; choose a smaller one</source>
        <translation>el archivo es demasiado grande; elija uno más pequeño</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>cancelado</translation>
    </message>
    <message>
        <source>This is not a regular file and cannot be replaced; choose another name</source>
        <translation>No es un archivo normal y no se puede reemplazar; elija otro nombre</translation>
    </message>
    <message>
        <source>The recording cannot be written: {0}</source>
        <translation>No se puede escribir la grabación: {0}</translation>
    </message>
    <message>
        <source>The recording cannot be read: {0}</source>
        <translation>No se puede leer la grabación: {0}</translation>
    </message>
    <message>
        <source>This version of Stepwise lays out the program&apos;s variables differently; open the recording with the version that made it</source>
        <translation>Esta versión de Stepwise dispone las variables del programa de otro modo; abra la grabación con la versión que la creó</translation>
    </message>
    <message>
        <source>The recording cannot be opened: {0}</source>
        <translation>No se puede abrir la grabación: {0}</translation>
    </message>
    <message>
        <source>its program has errors; open the recording with the version of Stepwise that made it</source>
        <translation>su programa tiene errores; abra la grabación con la versión de Stepwise que la creó</translation>
    </message>
    <message>
        <source>The recording contains no program; record the run again with this version</source>
        <translation>La grabación no contiene ningún programa; vuelva a grabar la ejecución con esta versión</translation>
    </message>
    <message>
        <source>This scan is no longer in the recording; choose a later one</source>
        <translation>Este ciclo ya no está en la grabación; elija uno posterior</translation>
    </message>
    <message>
        <source>The program that recorded this scan is no longer available; choose a scan after the last change of the program</source>
        <translation>El programa que grabó este ciclo ya no está disponible; elija un ciclo posterior al último cambio del programa</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is ambiguous; write one of {1}</source>
        <translation>«{0}» es ambiguo; escriba uno de {1}</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; has no variable &apos;{1}&apos;; did you mean &apos;{2}&apos;?</source>
        <translation>«{0}» no tiene ninguna variable «{1}»; ¿quería decir «{2}»?</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; has no variable &apos;{1}&apos;; check the name</source>
        <translation>«{0}» no tiene ninguna variable «{1}»; compruebe el nombre</translation>
    </message>
    <message>
        <source>there is no variable &apos;{0}&apos;; did you mean &apos;{1}&apos;?</source>
        <translation>no existe la variable «{0}»; ¿quería decir «{1}»?</translation>
    </message>
    <message>
        <source>there is no variable &apos;{0}&apos;; check the name or declare it</source>
        <translation>no existe la variable «{0}»; compruebe el nombre o declárela</translation>
    </message>
    <message>
        <source>a variable of type {1} has no member &apos;{0}&apos;; check the name</source>
        <translation>una variable de tipo {1} no tiene ningún miembro «{0}»; compruebe el nombre</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is a VAR_IN_OUT; write the variable that is connected to it</source>
        <translation>«{0}» es un VAR_IN_OUT; escriba la variable conectada</translation>
    </message>
    <message>
        <source>{0} needs {1} {1:index|indices}, not {2}; write one for each dimension</source>
        <translation>{0} necesita {1} {1:índice|índices}, no {2}; escriba uno por dimensión</translation>
    </message>
    <message>
        <source>bit {0} is outside 0..{1}; use a bit in this range</source>
        <translation>el bit {0} está fuera de 0..{1}; use un bit de este rango</translation>
    </message>
    <message>
        <source>part {0} is outside 0..{1}; use a part in this range</source>
        <translation>la parte {0} está fuera de 0..{1}; use una parte de este rango</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is not an address; write for example %IX0.0, %QB4 or %MW2</source>
        <translation>«{0}» no es una dirección; escriba por ejemplo %IX0.0, %QB4 o %MW2</translation>
    </message>
    <message>
        <source>the path cannot be read from &apos;{0}&apos; on; write for example Main.a[2].x</source>
        <translation>la ruta no se puede leer a partir de «{0}»; escriba por ejemplo Main.a[2].x</translation>
    </message>
    <message>
        <source>{0} is forced; release the force before writing</source>
        <translation>{0} está forzada; anule el forzado antes de escribir</translation>
    </message>
    <message>
        <source>the variable is not forced; there is nothing to release</source>
        <translation>la variable no está forzada; no hay forzado que anular</translation>
    </message>
    <message>
        <source>the initial values of the new program cause a fault: {0}</source>
        <translation>los valores iniciales del programa nuevo provocan un error: {0}</translation>
    </message>
    <message>
        <source>The retain file cannot be written: {0}</source>
        <translation>No se puede escribir el archivo de valores remanentes: {0}</translation>
    </message>
    <message>
        <source>The retain file cannot be read: {0}; the program starts with its initial values</source>
        <translation>No se puede leer el archivo de valores remanentes: {0}; el programa arranca con sus valores iniciales</translation>
    </message>
    <message>
        <source>The retain file is damaged; the program starts with its initial values</source>
        <translation>El archivo de valores remanentes está dañado; el programa arranca con sus valores iniciales</translation>
    </message>
    <message>
        <source>{0}; it is kept as {1}</source>
        <translation>{0}; se conserva como {1}</translation>
    </message>
    <message>
        <source>{0} retained {0:value does|values do} not fit the program: {1}; they start with their initial values</source>
        <translation>{0} {0:valor remanente no corresponde|valores remanentes no corresponden} al programa: {1}; arrancan con sus valores iniciales</translation>
    </message>
    <message>
        <source>{0} does not fit into a variable of type {1}; enter a value in its range</source>
        <translation>{0} no cabe en una variable de tipo {1}; introduzca un valor de su rango</translation>
    </message>
    <message>
        <source>the value does not fit into a variable of type {0}; enter one in its range</source>
        <translation>el valor no cabe en una variable de tipo {0}; introduzca uno de su rango</translation>
    </message>
    <message>
        <source>{0} is outside {1}..{2}; enter a value in this range</source>
        <translation>{0} está fuera de {1}..{2}; introduzca un valor de este rango</translation>
    </message>
    <message>
        <source>a character of the text does not fit into a STRING; use a WSTRING</source>
        <translation>un carácter del texto no existe en STRING; use una WSTRING</translation>
    </message>
    <message>
        <source>a reference can only be set to NULL from outside; assign a variable to it in the program</source>
        <translation>desde fuera, una referencia solo se puede poner a NULL; asígnele una variable en el programa</translation>
    </message>
    <message>
        <source>{0} is not a value for {1}, which is {2}</source>
        <translation>{0} no es un valor para {1}, de tipo {2}</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}, which is {2}</source>
        <translation>{0} no cabe en {1}, de tipo {2}</translation>
    </message>
    <message>
        <source>{0}; {1}</source>
        <translation>{0}; {1}</translation>
    </message>
    <message>
        <source>did you mean {0}?</source>
        <translation>¿quería decir {0}?</translation>
    </message>
    <message>
        <source>its values are {0}</source>
        <translation>sus valores son {0}</translation>
    </message>
    <message>
        <source>write it in quotes, for example {0}; only WSTRING has every character</source>
        <translation>escríbalo entre comillas, por ejemplo {0}; solo WSTRING tiene todos los caracteres</translation>
    </message>
    <message>
        <source>write it in quotes, for example {0}</source>
        <translation>escríbalo entre comillas, por ejemplo {0}</translation>
    </message>
    <message>
        <source>write one character in quotes, for example {0}</source>
        <translation>escriba un carácter entre comillas, por ejemplo {0}</translation>
    </message>
    <message>
        <source>write all elements, for example {0}, or a single one by its index</source>
        <translation>escriba todos los elementos, por ejemplo {0}, o uno solo con su índice</translation>
    </message>
    <message>
        <source>write its members, for example {0}, or a single one by its path</source>
        <translation>escriba sus miembros, por ejemplo {0}, o uno solo con su ruta</translation>
    </message>
    <message>
        <source>write {0} or {1}</source>
        <translation>escriba {0} o {1}</translation>
    </message>
    <message>
        <source>write for example {0}</source>
        <translation>escriba por ejemplo {0}</translation>
    </message>
    <message>
        <source>write a number, for example {0}</source>
        <translation>escriba un número, por ejemplo {0}</translation>
    </message>
    <message>
        <source>write an integer, for example {0}</source>
        <translation>escriba un entero, por ejemplo {0}</translation>
    </message>
    <message>
        <source>There is no program to optimise; declare a PROGRAM</source>
        <translation>No hay ningún programa que optimizar; declare un PROGRAM</translation>
    </message>
    <message>
        <source>this is local to a running call and has no address of its own; pause in the call to see it</source>
        <translation>esto es local de una llamada en curso y no tiene dirección propia; pause dentro de la llamada para verlo</translation>
    </message>
    <message>
        <source>this part of a computed value cannot be shown; assign the value to a variable first</source>
        <translation>esta parte de un valor calculado no se puede mostrar; asigne antes el valor a una variable</translation>
    </message>
    <message>
        <source>a character of a string has no address of its own; use the whole string</source>
        <translation>un carácter de una cadena no tiene dirección propia; use toda la cadena</translation>
    </message>
    <message>
        <source>this variable cannot be shown; assign it to another variable and watch that one</source>
        <translation>esta variable no se puede mostrar; asígnela a otra variable y supervise esa</translation>
    </message>
    <message>
        <source>this array of variable length has no address here; watch the array that is passed to it</source>
        <translation>este array de longitud variable no tiene dirección aquí; supervise el array que se le pasa</translation>
    </message>
    <message>
        <source>the array has no such dimension; count them from 1</source>
        <translation>el array no tiene esa dimensión; cuéntelas desde 1</translation>
    </message>
    <message>
        <source>this has no value</source>
        <translation>esto no tiene valor</translation>
    </message>
    <message>
        <source>only standard functions can be called here; use a function of the library</source>
        <translation>aquí solo se pueden llamar funciones estándar; use una función de la biblioteca</translation>
    </message>
    <message>
        <source>a cast to an interface cannot be watched; watch the instance itself</source>
        <translation>una conversión a una interfaz no se puede supervisar; supervise la propia instancia</translation>
    </message>
    <message>
        <source>this cannot be evaluated; use variables, operators and standard functions</source>
        <translation>esto no se puede evaluar; use variables, operadores y funciones estándar</translation>
    </message>
    <message>
        <source>The code generator failed, which is an error of Stepwise: {0}; report it with the program</source>
        <translation>El generador de código ha fallado, un error de Stepwise: {0}; notifíquelo con el programa</translation>
    </message>
    <message>
        <source>The code generator produced an invalid module, which is an error of Stepwise: {0}; report it with the program</source>
        <translation>El generador de código ha producido un módulo no válido, un error de Stepwise: {0}; notifíquelo con el programa</translation>
    </message>
    <message>
        <source>not compiled</source>
        <translation>sin compilar</translation>
    </message>
    <message>
        <source>Code for the thread sanitizer needs a process that runs under it</source>
        <translation>El código para el detector de accesos concurrentes necesita un proceso que se ejecute con él</translation>
    </message>
    <message>
        <source>the program could not be optimised: {0}</source>
        <translation>no se ha podido optimizar el programa: {0}</translation>
    </message>
    <message>
        <source>the program has errors; correct them first</source>
        <translation>el programa tiene errores; corríjalos antes</translation>
    </message>
    <message>
        <source>the online change waits until the scan that is halted at a breakpoint has ended; press F5 to continue</source>
        <translation>el cambio online espera a que termine el ciclo detenido en un punto de interrupción; pulse F5 para continuar</translation>
    </message>
    <message>
        <source>This body is not an instruction list; choose a unit that is written in IL</source>
        <translation>Este cuerpo no es una lista de instrucciones; elija una POU escrita en IL</translation>
    </message>
    <message>
        <source>This body is not ST; choose a unit that is written in ST</source>
        <translation>Este cuerpo no es ST; elija una POU escrita en ST</translation>
    </message>
    <message>
        <source>{0} has no equivalent in an instruction list; write it with simpler statements first</source>
        <translation>{0} no tiene equivalente en una lista de instrucciones; escríbalo antes con instrucciones más sencillas</translation>
    </message>
    <message>
        <source>{0} is already written in ST</source>
        <translation>{0} ya está escrito en ST</translation>
    </message>
    <message>
        <source>{0} is already written in IL</source>
        <translation>{0} ya está escrito en IL</translation>
    </message>
    <message>
        <source>Fix the text first: {0}</source>
        <translation>Corrija primero el texto: {0}</translation>
    </message>
    <message>
        <source>There is no equivalent in the other language: {0}</source>
        <translation>No hay equivalente en el otro lenguaje: {0}</translation>
    </message>
    <message>
        <source>This is a folder; choose a file</source>
        <translation>Es una carpeta; elija un archivo</translation>
    </message>
    <message>
        <source>This is a device; choose a file</source>
        <translation>Es un dispositivo; elija un archivo</translation>
    </message>
    <message>
        <source>The file cannot be read: {0}</source>
        <translation>No se puede leer el archivo: {0}</translation>
    </message>
    <message>
        <source>The file cannot be replaced: {0}</source>
        <translation>No se puede reemplazar el archivo: {0}</translation>
    </message>
    <message>
        <source>The file cannot be written: {0}</source>
        <translation>No se puede escribir el archivo: {0}</translation>
    </message>
    <message>
        <source>project.json is not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>project.json no es JSON válido; busque una coma, una comilla o un corchete que falte</translation>
    </message>
    <message>
        <source>project.json must contain one JSON object; put its contents in braces</source>
        <translation>project.json debe contener un objeto JSON; ponga su contenido entre llaves</translation>
    </message>
    <message>
        <source>There is no library &quot;{0}&quot;; available are {1}</source>
        <translation>No existe la biblioteca «{0}»; están disponibles {1}</translation>
    </message>
    <message>
        <source>There is no library {0}; did you mean {1}?</source>
        <translation>No existe la biblioteca {0}; ¿quería decir {1}?</translation>
    </message>
    <message>
        <source>Specify a project folder or ST files</source>
        <translation>Indique una carpeta de proyecto o archivos ST</translation>
    </message>
    <message>
        <source>Specify one project folder or ST files, not both</source>
        <translation>Indique una carpeta de proyecto o archivos ST, no ambos</translation>
    </message>
    <message>
        <source>{0} belongs to a library and cannot be renamed; rename only names of the project</source>
        <translation>{0} pertenece a una biblioteca y no se puede renombrar; renombre solo los nombres del proyecto</translation>
    </message>
    <message>
        <source>{0} is not a valid name; use letters, digits and _, start with a letter and avoid keywords</source>
        <translation>{0} no es un nombre válido; use letras, cifras y _, empiece por una letra y evite las palabras clave</translation>
    </message>
    <message>
        <source>The folder cannot be created: {0}</source>
        <translation>No se puede crear la carpeta: {0}</translation>
    </message>
    <message>
        <source>The folder cannot be read: {0}</source>
        <translation>No se puede leer la carpeta: {0}</translation>
    </message>
    <message>
        <source>The file cannot be copied: {0}</source>
        <translation>No se puede copiar el archivo: {0}</translation>
    </message>
    <message>
        <source>The folder already exists and is not empty; choose another name</source>
        <translation>La carpeta ya existe y no está vacía; elija otro nombre</translation>
    </message>
    <message>
        <source>The page cannot be written; check the free space and the permissions of the folder</source>
        <translation>No se puede escribir la página; compruebe el espacio libre y los permisos de la carpeta</translation>
    </message>
    <message>
        <source>There is no such file in the project; choose one from the project tree</source>
        <translation>El proyecto no contiene ese archivo; elija uno del árbol del proyecto</translation>
    </message>
    <message>
        <source>The file&apos;s permissions cannot be changed; change them as the file&apos;s owner</source>
        <translation>No se pueden cambiar los permisos del archivo; cámbielos como propietario del archivo</translation>
    </message>
    <message>
        <source>The file cannot be removed; check the permissions of the folder</source>
        <translation>No se puede eliminar el archivo; compruebe los permisos de la carpeta</translation>
    </message>
    <message>
        <source>The file cannot be renamed; check the permissions of the folder</source>
        <translation>No se puede renombrar el archivo; compruebe los permisos de la carpeta</translation>
    </message>
    <message>
        <source>Open a project first</source>
        <translation>Abra primero un proyecto</translation>
    </message>
    <message>
        <source>This statement is not possible in a TEST together with RUN or ASSERT around it; move it out of RUN and ASSERT</source>
        <translation>Esta instrucción no es posible en un TEST cuando la rodea RUN o ASSERT; sáquela de RUN y ASSERT</translation>
    </message>
    <message>
        <source>The code of this statement is missing</source>
        <translation>Falta el código de esta instrucción</translation>
    </message>
    <message>
        <source>Fault in the test: {0}</source>
        <translation>Error en la prueba: {0}</translation>
    </message>
    <message>
        <source>{0} is not a value for {1}; write a value of its type</source>
        <translation>{0} no es un valor para {1}; escriba un valor de su tipo</translation>
    </message>
    <message>
        <source>The simulation stopped: {0}</source>
        <translation>La simulación se ha detenido: {0}</translation>
    </message>
    <message>
        <source>The controller stopped: {0}</source>
        <translation>El controlador se ha detenido: {0}</translation>
    </message>
    <message>
        <source>at {0}:{1}</source>
        <translation>en {0}:{1}</translation>
    </message>
    <message>
        <source>{0} has no value: {1}</source>
        <translation>{0} no tiene valor: {1}</translation>
    </message>
    <message>
        <source>{0} did not become true within {1}; check the condition or allow more time</source>
        <translation>{0} no se ha hecho verdadero en {1}; compruebe la condición o deje más tiempo</translation>
    </message>
    <message>
        <source>ASSERT failed: {0}</source>
        <translation>ASSERT ha fallado: {0}</translation>
    </message>
    <message>
        <source>ASSERT failed: {0} ({1})</source>
        <translation>ASSERT ha fallado: {0} ({1})</translation>
    </message>
    <message>
        <source>A coil writes a variable; enter the name of one.</source>
        <translation>Una bobina escribe una variable; introduzca su nombre.</translation>
    </message>
    <message>
        <source>A pin has no contacts; type an expression.</source>
        <translation>Un pin no tiene contactos; escriba una expresión.</translation>
    </message>
    <message>
        <source>A rung cannot be moved into itself; choose a place outside it.</source>
        <translation>Un segmento no se puede mover dentro de sí mismo; elija un lugar fuera de él.</translation>
    </message>
    <message>
        <source>A rung moves within its block of statements; use cut and paste in the text for more.</source>
        <translation>Un segmento se mueve dentro de su bloque de instrucciones; para más, use cortar y pegar en el texto.</translation>
    </message>
    <message>
        <source>Delete the call in the text: other statements may use its outputs.</source>
        <translation>Elimine la llamada en el texto: otras instrucciones pueden usar sus salidas.</translation>
    </message>
    <message>
        <source>Delete this output in the text.</source>
        <translation>Elimine esta salida en el texto.</translation>
    </message>
    <message>
        <source>Other outputs depend on the same IF; give this coil a rung of its own first.</source>
        <translation>Otras salidas dependen del mismo IF; dé primero a esta bobina un segmento propio.</translation>
    </message>
    <message>
        <source>Select a box with text.</source>
        <translation>Seleccione un cuadro con texto.</translation>
    </message>
    <message>
        <source>Select a coil.</source>
        <translation>Seleccione una bobina.</translation>
    </message>
    <message>
        <source>Select a contact or a wire.</source>
        <translation>Seleccione un contacto o una conexión.</translation>
    </message>
    <message>
        <source>Select a contact, a pin or a coil.</source>
        <translation>Seleccione un contacto, un pin o una bobina.</translation>
    </message>
    <message>
        <source>Select a rung with contacts.</source>
        <translation>Seleccione un segmento con contactos.</translation>
    </message>
    <message>
        <source>Select a rung with one output.</source>
        <translation>Seleccione un segmento con una sola salida.</translation>
    </message>
    <message>
        <source>Select the rung beside which it is inserted.</source>
        <translation>Seleccione el segmento junto al que se inserta.</translation>
    </message>
    <message>
        <source>Select the rung that the comment belongs to.</source>
        <translation>Seleccione el segmento al que pertenece el comentario.</translation>
    </message>
    <message>
        <source>Select what is to be changed.</source>
        <translation>Seleccione lo que se va a cambiar.</translation>
    </message>
    <message>
        <source>Select what is to be deleted.</source>
        <translation>Seleccione lo que se va a eliminar.</translation>
    </message>
    <message>
        <source>Several variables are assigned in one statement; separate them in the text first.</source>
        <translation>Se asignan varias variables en una instrucción; sepárelas primero en el texto.</translation>
    </message>
    <message>
        <source>Statements on one line cannot be moved; separate them in the text first.</source>
        <translation>No se pueden mover instrucciones que están en una misma línea; sepárelas primero en el texto.</translation>
    </message>
    <message>
        <source>The rung reads what it writes; add this coil in a rung of its own.</source>
        <translation>El segmento lee lo que escribe; añada esta bobina en un segmento propio.</translation>
    </message>
    <message>
        <source>There is no function block {0}; declare it or check the name.</source>
        <translation>No existe el bloque de función {0}; declárelo o compruebe el nombre.</translation>
    </message>
    <message>
        <source>This edit cannot be made in the picture; edit the text.</source>
        <translation>Este cambio no se puede hacer en el esquema; edite el texto.</translation>
    </message>
    <message>
        <source>This element has no operand; select a contact, a pin or a coil.</source>
        <translation>Este elemento no tiene operando; seleccione un contacto, un pin o una bobina.</translation>
    </message>
    <message>
        <source>This is not a statement: {0}</source>
        <translation>Esto no es una instrucción: {0}</translation>
    </message>
    <message>
        <source>This is not an expression: {0}</source>
        <translation>Esto no es una expresión: {0}</translation>
    </message>
    <message>
        <source>This rung has no condition; put it under IF in the text.</source>
        <translation>Este segmento no tiene condición; póngalo bajo un IF en el texto.</translation>
    </message>
    <message>
        <source>{0} is {1}</source>
        <translation>{0} es {1}</translation>
    </message>
    <message>
        <source>{0} is {1}, expected {2} {3}</source>
        <translation>{0} es {1}, se esperaba {2} {3}</translation>
    </message>
    <message>
        <source>{0} is {1}, recorded {2} in scan {3}</source>
        <translation>{0} es {1}, grabado {2} en el ciclo {3}</translation>
    </message>
    <message>
        <source>The recording {0} has {1} {1:scan|scans}, this run {2}</source>
        <translation>La grabación {0} tiene {1} {1:ciclo|ciclos}, esta ejecución {2}</translation>
    </message>
    <message>
        <source>The run differs from the recording {0}; delete it to record it again, if the new behaviour is right</source>
        <translation>La ejecución difiere de la grabación {0}; elimínela para volver a grabarla si el nuevo comportamiento es correcto</translation>
    </message>
    <message>
        <source>the condition cannot be evaluated; use variables, operators and standard functions</source>
        <translation>la condición no se puede evaluar; use variables, operadores y funciones estándar</translation>
    </message>
    <message>
        <source>There is no action {0}; add it or correct the name</source>
        <translation>No existe la acción {0}; añádala o corrija el nombre</translation>
    </message>
    <message>
        <source>{0} is not a valid name; use letters, digits and underscores</source>
        <translation>{0} no es un nombre válido; use letras, cifras y guiones bajos</translation>
    </message>
    <message>
        <source>The initial step stays at the top; make another step the initial step first</source>
        <translation>La etapa inicial se queda arriba; convierta antes otra etapa en la etapa inicial</translation>
    </message>
    <message>
        <source>Only a step with a single transition of its own can be moved; move it in the text</source>
        <translation>Solo se puede mover una etapa con una única transición propia; muévala en el texto</translation>
    </message>
    <message>
        <source>The step is already there; choose another place</source>
        <translation>La etapa ya está ahí; elija otro lugar</translation>
    </message>
    <message>
        <source>A step can be placed after a transition that leads to one step; choose such a transition</source>
        <translation>Una etapa se puede colocar tras una transición que lleve a una sola etapa; elija una transición así</translation>
    </message>
    <message>
        <source>This step only leads to itself; connect it to another step first</source>
        <translation>Esta etapa solo lleva a sí misma; conéctela antes a otra etapa</translation>
    </message>
    <message>
        <source>A transition needs a condition; enter one, for example Main.done</source>
        <translation>Una transición necesita una condición; introduzca una, por ejemplo Main.done</translation>
    </message>
    <message>
        <source>A priority must be a positive number; enter 1 or more</source>
        <translation>Una prioridad debe ser un número positivo; introduzca 1 o más</translation>
    </message>
    <message>
        <source>Nothing follows this step yet; insert a step after it first</source>
        <translation>Aún no sigue nada a esta etapa; inserte primero una etapa detrás</translation>
    </message>
    <message>
        <source>There is no such action; select one that is in the chart</source>
        <translation>No existe esa acción; seleccione una de la secuencia</translation>
    </message>
    <message>
        <source>The initial step cannot be deleted; make another step the initial step first</source>
        <translation>La etapa inicial no se puede eliminar; convierta primero otra etapa en etapa inicial</translation>
    </message>
    <message>
        <source>Several transitions leave this step; delete its branches first</source>
        <translation>Varias transiciones salen de esta etapa; elimine primero sus ramas</translation>
    </message>
    <message>
        <source>The condition of this transition cannot be read; edit it in the text</source>
        <translation>La condición de esta transición no se puede leer; edítela en el texto</translation>
    </message>
    <message>
        <source>The branches after this transition do not join; connect them in the text first</source>
        <translation>Las ramas tras esta transición no convergen; conéctelas primero en el texto</translation>
    </message>
    <message>
        <source>A panel must be a JSON object; put its contents in braces</source>
        <translation>Un panel debe ser un objeto JSON; ponga su contenido entre llaves</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a list; put it in square brackets</source>
        <translation>«{0}» debe ser una lista; póngala entre corchetes</translation>
    </message>
    <message>
        <source>Element {0} is not an object; put it in braces</source>
        <translation>El elemento {0} no es un objeto; póngalo entre llaves</translation>
    </message>
    <message>
        <source>The kind of element {0} is not a text; write it in quotes</source>
        <translation>El tipo del elemento {0} no es un texto; escríbalo entre comillas</translation>
    </message>
    <message>
        <source>Two elements have the id &quot;{0}&quot;; change one of them</source>
        <translation>Dos elementos tienen el identificador «{0}»; cambie uno de ellos</translation>
    </message>
    <message>
        <source>Every alarm and every alarm class must be a JSON object; put it in braces</source>
        <translation>Cada alarma y cada clase de alarma debe ser un objeto JSON; póngala entre llaves</translation>
    </message>
    <message>
        <source>This line is not valid UTF-8; save the file as UTF-8</source>
        <translation>Esta línea no es UTF-8 válido; guarde el archivo como UTF-8</translation>
    </message>
    <message>
        <source>There is text after a closing quote; double a quote that belongs to the text</source>
        <translation>Hay texto tras una comilla de cierre; duplique la comilla que pertenece al texto</translation>
    </message>
    <message>
        <source>The first line must be {0} and one language tag per column</source>
        <translation>La primera línea debe ser {0} y una etiqueta de idioma por columna</translation>
    </message>
    <message>
        <source>This line has {0} {0:field|fields}, the header has {1}; put texts with separators in quotes</source>
        <translation>Esta línea tiene {0} {0:campo|campos}, la cabecera tiene {1}; ponga entre comillas los textos con separadores</translation>
    </message>
    <message>
        <source>The alarm history cannot be opened: {0}</source>
        <translation>No se puede abrir el historial de alarmas: {0}</translation>
    </message>
    <message>
        <source>The alarm history cannot be used: {0}</source>
        <translation>No se puede usar el historial de alarmas: {0}</translation>
    </message>
    <message>
        <source>The alarm history cannot be written: {0}</source>
        <translation>No se puede escribir el historial de alarmas: {0}</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}; use a larger type or a smaller limit</source>
        <translation>{0} no cabe en {1}; use un tipo mayor o un límite menor</translation>
    </message>
    <message>
        <source>STRING contains characters of {0} only; declare the variable as WSTRING</source>
        <translation>STRING solo contiene caracteres de {0}; declare la variable como WSTRING</translation>
    </message>
    <message>
        <source>A {0} cannot be written from a panel; write its members one by one</source>
        <translation>Un {0} no se puede escribir desde un panel; escriba sus miembros uno a uno</translation>
    </message>
    <message>
        <source>The folder for the pictures cannot be created; check the path and its permissions</source>
        <translation>No se puede crear la carpeta de las imágenes; compruebe la ruta y sus permisos</translation>
    </message>
    <message>
        <source>The picture cannot be written; check the free space and the permissions of the folder</source>
        <translation>No se puede escribir la imagen; compruebe el espacio libre y los permisos de la carpeta</translation>
    </message>
    <message>
        <source>The project has no such panel; choose one from hmi/</source>
        <translation>El proyecto no tiene ese panel; elija uno de hmi/</translation>
    </message>
    <message>
        <source>The text &quot;{0}&quot; has no key, so it cannot be translated; move it into the text table</source>
        <translation>El texto «{0}» no tiene clave y por eso no se puede traducir; páselo a la tabla de textos</translation>
    </message>
    <message>
        <source>The text needs a value for {0}; specify it in &quot;Values in texts&quot;</source>
        <translation>El texto necesita un valor para {0}; indíquelo en «Valores en textos»</translation>
    </message>
    <message>
        <source>The text list {0} is empty: there is no key {1}; add it to the text table</source>
        <translation>La lista de textos {0} está vacía: no existe la clave {1}; añádala a la tabla de textos</translation>
    </message>
    <message>
        <source>This version does not know the element kind &quot;{0}&quot;; it is kept as it is</source>
        <translation>Esta versión no conoce el tipo de elemento «{0}»; se conserva tal cual</translation>
    </message>
    <message>
        <source>The format {0} is not known; use for example {1} or {2}</source>
        <translation>El formato {0} no se conoce; use por ejemplo {1} o {2}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; does not fit: it needs {1} px, the maximum is {2}; make the element wider or the text shorter</source>
        <translation>«{0}» no cabe: necesita {1}&#xa0;px, el máximo es {2}; ensanche el elemento o acorte el texto</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; does not fit: it needs a height of {1} px, the maximum is {2}; make the element taller or the text shorter</source>
        <translation>«{0}» no cabe: necesita una altura de {1}&#xa0;px, el máximo es {2}; haga más alto el elemento o acorte el texto</translation>
    </message>
    <message>
        <source>{0}; did you mean {1}?</source>
        <translation>{0}; ¿quería decir {1}?</translation>
    </message>
    <message>
        <source>{0} is not a variable, so it cannot be written; name a variable</source>
        <translation>{0} no es una variable y por eso no se puede escribir; indique una variable</translation>
    </message>
    <message>
        <source>{0} is {1}; a BOOL is needed here</source>
        <translation>{0} es {1}; aquí se necesita un BOOL</translation>
    </message>
    <message>
        <source>{0} is {1}; a number is needed here</source>
        <translation>{0} es {1}; aquí se necesita un número</translation>
    </message>
    <message>
        <source>{0} is {1}; a STRING is needed here</source>
        <translation>{0} es {1}; aquí se necesita una STRING</translation>
    </message>
    <message>
        <source>{0} is {1}; an array is needed here</source>
        <translation>{0} es {1}; aquí se necesita un array</translation>
    </message>
    <message>
        <source>{0} is {1}; a single value is needed here</source>
        <translation>{0} es {1}; aquí se necesita un único valor</translation>
    </message>
    <message>
        <source>A placeholder is not closed; add {0}</source>
        <translation>Un marcador de posición no está cerrado; añada {0}</translation>
    </message>
    <message>
        <source>The format {0} is not known; use one such as %.1f</source>
        <translation>El formato {0} no se conoce; use por ejemplo %.1f</translation>
    </message>
    <message>
        <source>A trace configuration must be a JSON object; put its contents in braces</source>
        <translation>Una configuración de traza debe ser un objeto JSON; ponga su contenido entre llaves</translation>
    </message>
    <message>
        <source>The trace configuration is invalid: {0}</source>
        <translation>La configuración de la traza no es válida: {0}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be {1}</source>
        <translation>«{0}» debe ser {1}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is missing; add it</source>
        <translation>falta «{0}»; añádalo</translation>
    </message>
    <message>
        <source>A picture&apos;s name must end in one of {0}</source>
        <translation>El nombre de una imagen debe terminar en {0}</translation>
    </message>
    <message>
        <source>no longer recorded</source>
        <translation>ya no está grabado</translation>
    </message>
    <message>
        <source>A recording from a file cannot be written; go back to the running controller first</source>
        <translation>Una grabación de un archivo no se puede escribir; vuelva primero al controlador en marcha</translation>
    </message>
    <message>
        <source>Recorded values cannot be written; resume from here first</source>
        <translation>Los valores grabados no se pueden escribir; reanude primero desde aquí</translation>
    </message>
    <message>
        <source>Recorded values cannot be forced; resume from here or go back to live first</source>
        <translation>Los valores grabados no se pueden forzar; reanude desde aquí o vuelva primero al directo</translation>
    </message>
    <message>
        <source>A recording from a file cannot be resumed, only what the controller itself recorded; press F5 to run the program</source>
        <translation>Una grabación de un archivo no se puede reanudar, solo lo que grabó el propio controlador; pulse F5 para ejecutar el programa</translation>
    </message>
    <message>
        <source>A priority is a number; 0 removes it</source>
        <translation>Una prioridad es un número; 0 la quita</translation>
    </message>
    <message>
        <source>This file cannot be imported; PLCopen XML (.xml), TwinCAT (.TcPOU and so on), text of CODESYS (.EXP, .export) and structured text (.st) can be read</source>
        <translation>Este archivo no se puede importar: se leen PLCopen XML (.xml), TwinCAT (.TcPOU, etc.), texto de CODESYS (.EXP, .export) y texto estructurado (.st)</translation>
    </message>
    <message>
        <source>This XML is neither PLCopen XML nor of TwinCAT or CODESYS; export the project as PLCopen XML and import that file</source>
        <translation>Este XML no es PLCopen XML ni de TwinCAT o CODESYS; exporte el proyecto como PLCopen XML e importe ese archivo</translation>
    </message>
    <message>
        <source>It contains nothing that can be imported; export the project again with its units</source>
        <translation>No contiene nada que se pueda importar; exporte de nuevo el proyecto con sus POU</translation>
    </message>
    <message>
        <source>The folder exists and is not empty; name a new one</source>
        <translation>La carpeta existe y no está vacía; indique una nueva</translation>
    </message>
    <message>
        <source>The sources have syntax errors; stepwise check lists them</source>
        <translation>Las fuentes tienen errores de sintaxis; stepwise check los enumera</translation>
    </message>
    <message>
        <source>The file is too large to be read; export its parts one by one</source>
        <translation>El archivo es demasiado grande para leerlo; exporte sus partes una a una</translation>
    </message>
    <message>
        <source>The file is in the encoding {0}, which is not supported; save it as UTF-8</source>
        <translation>El archivo tiene la codificación {0}, que no se admite; guárdelo como UTF-8</translation>
    </message>
    <message>
        <source>The file declares a document type or entities of its own, which is not supported; export it again without them</source>
        <translation>El archivo declara un tipo de documento o entidades propias, lo que no se admite; expórtelo de nuevo sin ellos</translation>
    </message>
    <message>
        <source>The elements of the file are nested too deeply; export its parts one by one</source>
        <translation>Los elementos del archivo están anidados demasiado profundamente; exporte sus partes una a una</translation>
    </message>
    <message>
        <source>This is not well-formed XML: {0}; export the file again</source>
        <translation>Este XML no está bien formado: {0}; exporte de nuevo el archivo</translation>
    </message>
    <message>
        <source>The file has no elements; export it again</source>
        <translation>El archivo no tiene elementos; expórtelo de nuevo</translation>
    </message>
    <message>
        <source>This is XML, not structured text; import it (stepwise import --help)</source>
        <translation>Esto es XML, no texto estructurado; impórtelo (stepwise import --help)</translation>
    </message>
    <message>
        <source>Windows-1252 does not have the character {0}; write the file as UTF-8</source>
        <translation>Windows-1252 no tiene el carácter {0}; escriba el archivo como UTF-8</translation>
    </message>
    <message>
        <source>The first input and the first output of {0} must be BOOL for it to be part of a rung; choose another block, or call it in the text.</source>
        <translation>La primera entrada y la primera salida de {0} deben ser BOOL para que forme parte de un segmento; elija otro bloque o llámelo en el texto.</translation>
    </message>
    <message>
        <source>Type a name and a block: T1 : TON</source>
        <translation>Escriba un nombre y un bloque: T1 : TON</translation>
    </message>
    <message>
        <source>the local variables of {0} and of what it calls need {1} bytes; the maximum is {2}; declare large arrays in a program or block</source>
        <translation>las variables locales de {0} y de lo que llama necesitan {1} bytes; el máximo es {2}; declare los arrays grandes en un programa o bloque</translation>
    </message>
    <message>
        <source>{0} is too large for the stack; divide it into several functions</source>
        <translation>{0} es demasiado grande para la pila; divídalo en varias funciones</translation>
    </message>
    <message>
        <source>more than {0} units of work (loop passes, calls, copies) in one run of the task; check for an endless loop</source>
        <translation>más de {0} unidades de trabajo (pasadas de bucle, llamadas, copias) en una ejecución de la tarea; busque un bucle infinito</translation>
    </message>
    <message>
        <source>{0} is not a name: use letters, digits and underscores.</source>
        <translation>{0} no es un nombre válido; use letras, cifras y guiones bajos.</translation>
    </message>
    <message>
        <source>The XLIFF version {0} is not known; save the file as 1.2 or 2.0</source>
        <translation>La versión de XLIFF {0} no se conoce; guarde el archivo como 1.2 o 2.0</translation>
    </message>
    <message>
        <source>The file does not say into which language it is translated; export it again with --language</source>
        <translation>El archivo no indica a qué idioma está traducido; expórtelo de nuevo con --language</translation>
    </message>
    <message>
        <source>The XML is wrong: {0}; export the file again</source>
        <translation>El XML es incorrecto: {0}; exporte de nuevo el archivo</translation>
    </message>
    <message>
        <source>The text of the key {0} in {1} has changed since the export; check the translation</source>
        <translation>El texto de la clave {0} en {1} ha cambiado desde la exportación; compruebe la traducción</translation>
    </message>
    <message>
        <source>The translation of the key {0} has other placeholders than its source and was not taken; use the same ones</source>
        <translation>La traducción de la clave {0} tiene otros marcadores de posición que su origen y no se ha aceptado; use los mismos</translation>
    </message>
    <message>
        <source>The picture {0} is outside the project; copy it into the project, or set {1} to true under {2} in project.json</source>
        <translation>La imagen {0} está fuera del proyecto; cópiela en el proyecto o ponga {1} a true bajo {2} en project.json</translation>
    </message>
    <message>
        <source>The picture {0} unpacks to more than {1} MB; use a smaller one</source>
        <translation>La imagen {0} supera {1}&#xa0;MB al descomprimirse; use una más pequeña</translation>
    </message>
    <message>
        <source>The picture {0} is {1} x {2} pixels; more than {3} million are not drawn; use a smaller one</source>
        <translation>La imagen {0} tiene {1} x {2} píxeles; no se dibujan más de {3} millones; use una más pequeña</translation>
    </message>
    <message>
        <source>{0} is not a picture in a known format such as PNG, JPEG or SVG; save it as one of them</source>
        <translation>{0} no es una imagen en un formato conocido como PNG, JPEG o SVG; guárdela en uno de ellos</translation>
    </message>
    <message>
        <source>The picture {0} draws more than {1} shapes; simplify it or save it as PNG</source>
        <translation>La imagen {0} contiene más de {1} formas; simplifíquela o guárdela como PNG</translation>
    </message>
    <message>
        <source>The shapes of the picture {0} are nested more than {1} deep or contain themselves; simplify it or save it as PNG</source>
        <translation>Las formas de la imagen {0} están anidadas a más de {1} niveles o se contienen a sí mismas; simplifíquela o guárdela como PNG</translation>
    </message>
    <message>
        <source>The picture {0} loads {1}; embed it in the picture as PNG or JPEG</source>
        <translation>La imagen {0} carga {1}; incrústelo en la imagen como PNG o JPEG</translation>
    </message>
    <message>
        <source>The picture {0} has dashed lines of more than {1} dashes; make the dashes longer or save it as PNG</source>
        <translation>La imagen {0} tiene líneas discontinuas de más de {1} trazos; alargue los trazos o guárdela como PNG</translation>
    </message>
    <message>
        <source>This version does not know the property {0}; it is kept as it is</source>
        <translation>Esta versión no conoce la propiedad {0}; se conserva tal cual</translation>
    </message>
    <message>
        <source>This version does not know the property {0}; did you mean {1}?</source>
        <translation>Esta versión no conoce la propiedad {0}; ¿quería decir {1}?</translation>
    </message>
    <message>
        <source>The value must be true or false</source>
        <translation>El valor debe ser true o false</translation>
    </message>
    <message>
        <source>The value must be a whole number</source>
        <translation>El valor debe ser un número entero</translation>
    </message>
    <message>
        <source>The value must be a number</source>
        <translation>El valor debe ser un número</translation>
    </message>
    <message>
        <source>The value must be a list of two numbers: width and height</source>
        <translation>El valor debe ser una lista de dos números: anchura y altura</translation>
    </message>
    <message>
        <source>The value must be a list of four numbers: x, y, width and height</source>
        <translation>El valor debe ser una lista de cuatro números: x, y, anchura y altura</translation>
    </message>
    <message>
        <source>The value must be a list of points, each a list of two numbers</source>
        <translation>El valor debe ser una lista de puntos, cada uno una lista de dos números</translation>
    </message>
    <message>
        <source>The value must be an object with an expression for each name</source>
        <translation>El valor debe ser un objeto con una expresión por nombre</translation>
    </message>
    <message>
        <source>The value must be a list of objects</source>
        <translation>El valor debe ser una lista de objetos</translation>
    </message>
    <message>
        <source>The value must be a text in quotes</source>
        <translation>El valor debe ser un texto entre comillas</translation>
    </message>
    <message>
        <source>{0} is not one of the choices: {1}</source>
        <translation>{0} no es una de las opciones: {1}</translation>
    </message>
    <message>
        <source>{0} is not a colour; use the name of a role of the theme or a value such as {1}</source>
        <translation>{0} no es un color; use el nombre de un rol del tema o un valor como {1}</translation>
    </message>
    <message>
        <source>{0} is not a colour; did you mean {1}?</source>
        <translation>{0} no es un color; ¿quería decir {1}?</translation>
    </message>
    <message>
        <source>{0} ({1}) must be greater than {2} ({3}); exchange or correct the values</source>
        <translation>{0} ({1}) debe ser mayor que {2} ({3}); intercambie o corrija los valores</translation>
    </message>
    <message>
        <source>{0} has no page {1}; its {2} {2:page is|pages are} numbered from 0</source>
        <translation>{0} no tiene página {1}; sus {2} {2:página se numera|páginas se numeran} desde 0</translation>
    </message>
    <message>
        <source>The format {0} needs a number, and {1} is none; use {2}</source>
        <translation>El formato {0} necesita un número y {1} no lo es; use {2}</translation>
    </message>
    <message>
        <source>The project has no language {0}, so operators never see this column; add it to the languages in project.json</source>
        <translation>El proyecto no tiene el idioma {0}, así que los operadores nunca ven esta columna; añádalo a los idiomas en project.json</translation>
    </message>
    <message>
        <source>No text says what this does; add one, or place one next to it</source>
        <translation>Ningún texto indica para qué sirve esto; añada uno o coloque uno al lado</translation>
    </message>
    <message>
        <source>{0} is between {1} and {2} in the recording, so the range from {3} to {4} cuts it off; widen the range</source>
        <translation>{0} está entre {1} y {2} en la grabación, por lo que el rango de {3} a {4} lo recorta; amplíe el rango</translation>
    </message>
    <message>
        <source>{0} is not between {1} and {2}, so {3} is used; correct it</source>
        <translation>{0} no está entre {1} y {2}, por lo que se usa {3}; corríjalo</translation>
    </message>
    <message>
        <source>The panel {0} contains this one, so it cannot be placed in it; choose another one</source>
        <translation>El panel {0} contiene a este, por lo que no se puede colocar en él; elija otro</translation>
    </message>
    <message>
        <source>The panel {0} has no parameter {1}; remove the argument or add the parameter</source>
        <translation>El panel {0} no tiene ningún parámetro {1}; quite el argumento o añada el parámetro</translation>
    </message>
    <message>
        <source>The program has no type {0}; name a block or a structure, BOOL, REAL or the like, or text</source>
        <translation>El programa no tiene ningún tipo {0}; indique un bloque o una estructura, BOOL, REAL o similar, o text</translation>
    </message>
    <message>
        <source>The parameter {0} needs an argument of type {1}; enter one in the properties of this faceplate</source>
        <translation>El parámetro {0} necesita un argumento de tipo {1}; introduzca uno en las propiedades de este faceplate</translation>
    </message>
    <message>
        <source>{0} is {1}; the parameter {2} needs {3}</source>
        <translation>{0} es {1}; el parámetro {2} necesita {3}</translation>
    </message>
    <message>
        <source>{0} (tried with {1})</source>
        <translation>{0} (probado con {1})</translation>
    </message>
    <message>
        <source>The program was not built from sources; open its project.</source>
        <translation>El programa no se compiló a partir de código fuente; abra su proyecto.</translation>
    </message>
    <message>
        <source>The recording does not contain the program of this scan; choose a later scan.</source>
        <translation>La grabación no contiene el programa de este ciclo; elija un ciclo posterior.</translation>
    </message>
    <message>
        <source>This scan is no longer in the recording; choose a later scan.</source>
        <translation>Este ciclo ya no está en la grabación; elija un ciclo posterior.</translation>
    </message>
    <message>
        <source>The scan before it is not in the recording, so the values with which this scan began are not known; choose a later scan.</source>
        <translation>El ciclo anterior no está en la grabación, por lo que no se conocen los valores con los que empezó este ciclo; elija un ciclo posterior.</translation>
    </message>
    <message>
        <source>There is no user {0}; create the user or check the name</source>
        <translation>No existe el usuario {0}; créelo o compruebe el nombre</translation>
    </message>
    <message>
        <source>The password cannot be saved: {0}</source>
        <translation>No se puede guardar la contraseña: {0}</translation>
    </message>
    <message>
        <source>A password needs at least {0} characters; choose a longer one</source>
        <translation>Una contraseña debe tener al menos {0} caracteres; elija una más larga</translation>
    </message>
    <message>
        <source>The password must not be the name of the user; choose another one</source>
        <translation>La contraseña no debe ser el nombre del usuario; elija otra</translation>
    </message>
    <message>
        <source>The audit trail cannot be written: {0}</source>
        <translation>No se puede escribir el registro de auditoría: {0}</translation>
    </message>
    <message>
        <source>The audit trail cannot be read: {0}</source>
        <translation>No se puede leer el registro de auditoría: {0}</translation>
    </message>
    <message>
        <source>The frame {0} has no panel area, so no panel is shown in it; add one</source>
        <translation>El marco {0} no tiene área de panel, por lo que no se muestra ningún panel en él; añada una</translation>
    </message>
    <message>
        <source>Only for the roles {0}, but the project has no users, so anybody may operate it; add users</source>
        <translation>Solo para los roles {0}, pero el proyecto no tiene usuarios, así que cualquiera puede operarlo; añada usuarios</translation>
    </message>
    <message>
        <source>A row of a recipe names no variable; enter one or remove the row</source>
        <translation>Una fila de una receta no indica ninguna variable; indique una o quite la fila</translation>
    </message>
    <message>
        <source>The first column must be named variable, and each set has a column of its own</source>
        <translation>La primera columna debe llamarse variable, y cada juego de valores tiene su propia columna</translation>
    </message>
    <message>
        <source>The recipe {0} has no variable {1}; add it or correct the name</source>
        <translation>La receta {0} no tiene ninguna variable {1}; añádala o corrija el nombre</translation>
    </message>
    <message>
        <source>There is no recipe {0}; create it or check the name</source>
        <translation>No existe la receta {0}; créela o compruebe el nombre</translation>
    </message>
    <message>
        <source>The recipe {0} has no set {1}; create it or check the name</source>
        <translation>La receta {0} no tiene ningún juego de valores {1}; créelo o compruebe el nombre</translation>
    </message>
    <message>
        <source>{0} is outside the limits of {1}, {2} to {3}; enter a value within them</source>
        <translation>{0} está fuera de los límites de {1}, de {2} a {3}; introduzca un valor dentro de ellos</translation>
    </message>
    <message>
        <source>The list of shelved alarms cannot be read, so none is shelved: {0}</source>
        <translation>No se puede leer la lista de alarmas aplazadas, por lo que no hay ninguna aplazada: {0}</translation>
    </message>
    <message>
        <source>The list of shelved alarms cannot be written: {0}</source>
        <translation>No se puede escribir la lista de alarmas aplazadas: {0}</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>¿Por qué?</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>¿Por qué no?</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>¿Quién lo asignó?</translation>
    </message>
    <message>
        <source>There is no rule {0}; &quot;stepwise panel --rules&quot; lists them</source>
        <translation>No existe la regla {0}; «stepwise panel --rules» las muestra todas</translation>
    </message>
    <message>
        <source>There is no rule {0}; did you mean {1}?</source>
        <translation>No existe la regla {0}; ¿quería decir {1}?</translation>
    </message>
    <message>
        <source>The rule stays on until a reason for switching it off is given</source>
        <translation>La regla sigue activa hasta que se indique un motivo para desactivarla</translation>
    </message>
    <message>
        <source>The value must be a list of texts in quotes</source>
        <translation>El valor debe ser una lista de textos entre comillas</translation>
    </message>
    <message>
        <source>The value must be an object with the reason for each rule</source>
        <translation>El valor debe ser un objeto con el motivo de cada regla</translation>
    </message>
    <message>
        <source>The value must be an object with a level, the distance, and rules that are off</source>
        <translation>El valor debe ser un objeto con un nivel, la distancia y las reglas desactivadas</translation>
    </message>
    <message>
        <source>The colour {0} is always visible, whatever the state; use {1}</source>
        <translation>El color {0} se ve siempre, sea cual sea el estado; use {1}</translation>
    </message>
    <message>
        <source>{0} is an alarm colour, but it is visible in normal operation; use {1}</source>
        <translation>{0} es un color de alarma, pero se ve en funcionamiento normal; use {1}</translation>
    </message>
    <message>
        <source>Only the hue distinguishes {0} from {1}; choose a brighter one, or add a text or blinking</source>
        <translation>Solo el tono distingue {0} de {1}; elija uno más claro o añada un texto o un parpadeo</translation>
    </message>
    <message>
        <source>No text says what the lamp means; give it a label, or place a text next to it</source>
        <translation>Ningún texto indica qué significa el piloto; póngale un rótulo o coloque un texto al lado</translation>
    </message>
    <message>
        <source>{0} on {1} has a contrast of {2} to 1 in the theme {3}; {4} to 1 is needed; choose another colour</source>
        <translation>{0} sobre {1} tiene un contraste de {2} a 1 en el tema {3}; se necesita {4} a 1; elija otro color</translation>
    </message>
    <message>
        <source>A font of {0} px cannot be read from {2} mm; use at least {1} px</source>
        <translation>Una fuente de {0}&#xa0;px no se puede leer a {2}&#xa0;mm; use al menos {1}&#xa0;px</translation>
    </message>
    <message>
        <source>The faceplate is so small here that its smallest font has {0} px; from {2} mm, {1} px are needed; enlarge it</source>
        <translation>El faceplate es tan pequeño aquí que su fuente más pequeña tiene {0}&#xa0;px; a {2}&#xa0;mm se necesitan {1}&#xa0;px; agrándelo</translation>
    </message>
    <message>
        <source>The faceplate is so small here that only {0} px remain for a finger; {1} px are needed; enlarge it</source>
        <translation>El faceplate es tan pequeño aquí que solo quedan {0}&#xa0;px para un dedo; se necesitan {1}&#xa0;px; agrándelo</translation>
    </message>
    <message>
        <source>{0} x {1} px is too small for a finger next to other controls; {2} px are needed in both directions; make it larger</source>
        <translation>{0} × {1}&#xa0;px son demasiado pequeños para un dedo junto a otros controles; se necesitan {2}&#xa0;px en ambas direcciones; agrande el elemento</translation>
    </message>
    <message>
        <source>The panel shows {0} values and controls; the maximum for its size is {1}; move some to another panel</source>
        <translation>El panel muestra {0} valores y controles; el máximo para su tamaño es {1}; pase algunos a otro panel</translation>
    </message>
    <message>
        <source>The panel {0} is {1} presses away from the start panel; add a way of at most {2}</source>
        <translation>El panel {0} está a {1} pulsaciones del panel inicial; añada un camino de {2} como máximo</translation>
    </message>
    <message>
        <source>Nothing on the panel {0} leads back; add a button with the action back or home, or a navigation bar</source>
        <translation>Nada en el panel {0} lleva atrás; añada un botón con la acción back o home, o una barra de navegación</translation>
    </message>
    <message>
        <source>{0} is in a different place on the panel {1}; put it in the same place on both</source>
        <translation>{0} está en otro lugar en el panel {1}; póngalo en el mismo lugar en los dos</translation>
    </message>
    <message>
        <source>Normal states are grey so that abnormal ones are noticed (ISA-101). Use a role of the theme such as surface, off or running, and give colour only to conditions.</source>
        <translation>Los estados normales son grises, para que se noten los anormales (ISA-101). Use un rol del tema como surface, off o running, y dé color solo mediante condiciones.</translation>
    </message>
    <message>
        <source>Red, orange and yellow are reserved for alarms. An operator who sees them all day long no longer notices them when they matter (ISA-101, ISA-18.2).</source>
        <translation>El rojo, el naranja y el amarillo se reservan para las alarmas. Un operador que los ve todo el día deja de verlos cuando importan (ISA-101, ISA-18.2).</translation>
    </message>
    <message>
        <source>Text needs a contrast of 4.5 to 1 against its background, large text 3 to 1 (WCAG 2, ISO 9241-303). The colour roles ensure this in every theme.</source>
        <translation>El texto necesita un contraste de 4,5 a 1 con su fondo; el texto grande, de 3 a 1 (WCAG 2, ISO 9241-303). Los roles del tema lo garantizan en todos los temas.</translation>
    </message>
    <message>
        <source>A capital letter must be seen at an angle of 16 minutes at least (ISO 9241-303). The distance and the size of a pixel are set in project.json.</source>
        <translation>Una mayúscula debe verse bajo un ángulo de al menos 16 minutos (ISO 9241-303). La distancia y el tamaño de un píxel se definen en project.json.</translation>
    </message>
    <message>
        <source>On a panel that shows everything, operators have to search. Move details to a panel of the next level (ISA-101).</source>
        <translation>En un panel que muestra todo, el operador tiene que buscar. Mueva los detalles a un panel del nivel siguiente (ISA-101).</translation>
    </message>
    <message>
        <source>In an abnormal situation, every panel should be at most three presses away, and there should be a way back from it (ISA-101).</source>
        <translation>En una situación anómala, cada panel debería estar a tres pulsaciones como máximo, y debería haber un camino de vuelta (ISA-101).</translation>
    </message>
    <message>
        <source>Operators find what is on several panels without searching if it is always in the same place. Put it on the frame, or in the same place everywhere.</source>
        <translation>Lo que está en varios paneles se encuentra sin buscar si siempre está en el mismo lugar. Póngalo en el marco o en el mismo lugar en todas partes.</translation>
    </message>
    <message>
        <source>One element covers the other, so that a text cannot be read or the wrong element is pressed.</source>
        <translation>Un elemento cubre a otro, de modo que un texto no se puede leer o se pulsa el elemento equivocado.</translation>
    </message>
    <message>
        <source>The element looks as if it had a function. Bind it to a variable, or remove it.</source>
        <translation>El elemento parece tener una función. Vincúlelo a una variable o elimínelo.</translation>
    </message>
    <message>
        <source>A typing error sends 500 instead of 50. Limits reject it on entry.</source>
        <translation>Un error al teclear envía 500 en vez de 50. Los límites lo rechazan al introducirlo.</translation>
    </message>
    <message>
        <source>An alarm that nobody sees is useless. Put an alarm banner on the frame or an alarm list on a panel (ISA-18.2).</source>
        <translation>Una alarma que nadie ve es inútil. Ponga un banner de alarmas en el marco o una lista de alarmas en un panel (ISA-18.2).</translation>
    </message>
    <message>
        <source>An alarm requires the operator to act. Its help must say what to do, and what happens otherwise (ISA-18.2).</source>
        <translation>Una alarma requiere una acción del operador. Su ayuda debe indicar cuál y qué ocurre si no se hace (ISA-18.2).</translation>
    </message>
    <message>
        <source>If everything is urgent, nothing is: about 5 % of the alarms should have the highest priority, 15 % the next (ISA-18.2).</source>
        <translation>Si todo es urgente, nada lo es: alrededor del 5&#xa0;% de las alarmas debería tener la prioridad más alta, y el 15&#xa0;% la siguiente (ISA-18.2).</translation>
    </message>
    <message>
        <source>the value {0} is outside the subrange {1}..{2}; limit it before the assignment or widen the subrange</source>
        <translation>el valor {0} está fuera del subrango {1}..{2}; limítelo antes de la asignación o amplíe el subrango</translation>
    </message>
    <message>
        <source>&quot;addressing&quot; in project.json is &quot;byte&quot; or &quot;word&quot;, not &quot;{0}&quot;</source>
        <translation>«addressing» en project.json es «byte» o «word», no «{0}»</translation>
    </message>
    <message>
        <source>&quot;memoryForNew&quot; in project.json is a number of bytes from 0 to {0}</source>
        <translation>«memoryForNew» en project.json es un número de bytes de 0 a {0}</translation>
    </message>
    <message>
        <source>A finger needs 7 mm in both directions, a gloved one 9 mm, as the strict level requires. The size of a pixel is set in project.json.</source>
        <translation>Un dedo necesita 7&#xa0;mm en ambas direcciones, y 9&#xa0;mm con guante, como exige el nivel estricto. El tamaño de un píxel se define en project.json.</translation>
    </message>
    <message>
        <source>Nothing is bound; fill in “{0}”</source>
        <translation>No hay nada vinculado; rellene «{0}»</translation>
    </message>
    <message>
        <source>Any number can be written to {0}; set “{1}”</source>
        <translation>Se puede escribir cualquier número en {0}; defina «{1}»</translation>
    </message>
    <message>
        <source>One man in twelve cannot tell some colours apart, and bright light washes them out. Show the same information with a text, a shape, blinking or at least a different brightness.</source>
        <translation>Uno de cada doce hombres no distingue ciertos colores, y la luz intensa los atenúa. Muestre lo mismo con un texto, una forma, un parpadeo o al menos otro brillo.</translation>
    </message>
    <message>
        <source>A write that is restricted to some roles, or that project.json lists as critical, must not be triggered by an accidental touch. Set &quot;Writes are confirmed&quot;, or enter a question.</source>
        <translation>Una escritura restringida a ciertos roles, o que project.json declara crítica, no debe activarse con un toque accidental. Active «Las escrituras se confirman» o introduzca una pregunta.</translation>
    </message>
    <message>
        <source>Only {1} may write {0}, but no confirmation is required; set &quot;Writes are confirmed&quot;</source>
        <translation>Solo {1} puede escribir {0}, pero no se pide confirmación; active «Las escrituras se confirman»</translation>
    </message>
    <message>
        <source>The theme is not valid JSON with a base and colors</source>
        <translation>El tema no es JSON válido con base y colors</translation>
    </message>
    <message>
        <source>There is no built-in theme &quot;{0}&quot;; a base is light, dark or contrast</source>
        <translation>No existe el tema integrado «{0}»; la base debe ser light, dark o contrast</translation>
    </message>
    <message>
        <source>There is no colour role {0}; check the spelling</source>
        <translation>No existe el rol de color {0}; compruebe la ortografía</translation>
    </message>
    <message>
        <source>There is no colour role {0}; did you mean {1}?</source>
        <translation>No existe el rol de color {0}; ¿quería decir {1}?</translation>
    </message>
    <message>
        <source>The colour of {0} must be written like {1}</source>
        <translation>El color de {0} debe escribirse como {1}</translation>
    </message>
    <message>
        <source>There is no theme {0}; choose one of {1}</source>
        <translation>No existe el tema {0}; elija uno de {1}</translation>
    </message>
    <message>
        <source>This edit would change the same text twice; undo it and edit the text</source>
        <translation>Este cambio modificaría dos veces el mismo texto; elija deshacer y edite el texto</translation>
    </message>
    <message>
        <source>This transition does not lead to a step yet; connect it to one first</source>
        <translation>Esta transición aún no lleva a ninguna etapa; conéctela primero con una</translation>
    </message>
    <message>
        <source>The panel was written by a newer version of Stepwise; open it with that version</source>
        <translation>El panel se guardó con una versión más reciente de Stepwise; ábralo con esa versión</translation>
    </message>
    <message>
        <source>This trace configuration was written by a newer version of Stepwise (version {0}); open it with that version</source>
        <translation>Esta configuración de traza se guardó con una versión más reciente de Stepwise (versión {0}); ábrala con esa versión</translation>
    </message>
    <message>
        <source>The recorded program can no longer be built; open the recording with the version of Stepwise that made it</source>
        <translation>El programa grabado ya no se puede compilar; abra la grabación con la versión de Stepwise que la creó</translation>
    </message>
    <message>
        <source>The controller is not running; press F5</source>
        <translation>El controlador no está en marcha; pulse F5</translation>
    </message>
    <message>
        <source>There is no program to run; declare a PROGRAM</source>
        <translation>No hay ningún programa que ejecutar; declare un PROGRAM</translation>
    </message>
    <message>
        <source>There is no program to test; declare a PROGRAM</source>
        <translation>No hay ningún programa que probar; declare un PROGRAM</translation>
    </message>
    <message>
        <source>A file with this name already exists; choose another name</source>
        <translation>Ya existe un archivo con ese nombre; elija otro nombre</translation>
    </message>
    <message>
        <source>A panel with this name already exists; choose another name</source>
        <translation>Ya existe un panel con ese nombre; elija otro nombre</translation>
    </message>
    <message>
        <source>A step {0} already exists; choose another name</source>
        <translation>Ya existe una etapa {0}; elija otro nombre</translation>
    </message>
    <message>
        <source>The step of this loop is 0; write BY with another number</source>
        <translation>El paso de este bucle es 0; escriba BY con otro número</translation>
    </message>
    <message>
        <source>This loop of the test does not end; give it a condition that becomes FALSE</source>
        <translation>Este bucle de la prueba no termina; dele una condición que llegue a ser FALSE</translation>
    </message>
    <message>
        <source>There is no name here that can be renamed; put the cursor on one</source>
        <translation>Aquí no hay ningún nombre que se pueda renombrar; ponga el cursor sobre uno</translation>
    </message>
    <message>
        <source>The file was changed by another program and was not overwritten; compare both first</source>
        <translation>Otro programa cambió el archivo y no se ha sobrescrito; compare primero ambos</translation>
    </message>
    <message>
        <source>The type of {0} is not known here; correct the errors of the program first</source>
        <translation>El tipo de {0} no se conoce aquí; corrija primero los errores del programa</translation>
    </message>
    <message>
        <source>Nothing has been recorded yet; start the controller with F5</source>
        <translation>Aún no se ha grabado nada; inicie el controlador con F5</translation>
    </message>
    <message>
        <source>a constant cannot be forced; change it in the program</source>
        <translation>una constante no se puede forzar; cámbiela en el programa</translation>
    </message>
    <message>
        <source>the path is incomplete; write it to a single value, for example Main.x</source>
        <translation>la ruta está incompleta; escríbala hasta un único valor, por ejemplo Main.x</translation>
    </message>
    <message>
        <source>The panel is not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>El panel no es JSON válido; busque una coma, una comilla o un corchete que falte</translation>
    </message>
    <message>
        <source>The alarms are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Las alarmas no son JSON válido; busque una coma, una comilla o un corchete que falte</translation>
    </message>
    <message>
        <source>The recipes are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Las recetas no son JSON válido; busque una coma, una comilla o un corchete que falte</translation>
    </message>
    <message>
        <source>The users and roles are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Los usuarios y los roles no son JSON válido; busque una coma, una comilla o un corchete que falte</translation>
    </message>
    <message>
        <source>The trace configuration is not valid JSON (see line {0}); look for a missing comma, quote or bracket</source>
        <translation>La configuración de la traza no es JSON válido (vea la línea {0}); busque una coma, una comilla o un corchete que falte</translation>
    </message>
    <message>
        <source>Two alarms have the id &quot;{0}&quot;; change one of them</source>
        <translation>Dos alarmas tienen el identificador «{0}»; cambie uno de ellos</translation>
    </message>
    <message>
        <source>The quote that opens here is never closed; add one at the end of the text</source>
        <translation>La comilla que se abre aquí no se cierra; añada una al final del texto</translation>
    </message>
    <message>
        <source>The language {0} has two columns; remove one of them</source>
        <translation>El idioma {0} tiene dos columnas; elimine una de ellas</translation>
    </message>
    <message>
        <source>The key {0} is already on line {1}; remove one of the two lines</source>
        <translation>La clave {0} ya está en la línea {1}; elimine una de las dos líneas</translation>
    </message>
    <message>
        <source>Two roles are named {0}; rename one</source>
        <translation>Dos roles se llaman {0}; renombre uno</translation>
    </message>
    <message>
        <source>Two users are named {0}; rename one</source>
        <translation>Dos usuarios se llaman {0}; renombre uno</translation>
    </message>
    <message>
        <source>Two recipes are named {0}; rename one</source>
        <translation>Dos recetas se llaman {0}; renombre una</translation>
    </message>
    <message>
        <source>Two sets of the recipe are named {0}; rename one</source>
        <translation>Dos juegos de valores de la receta se llaman {0}; renombre uno</translation>
    </message>
    <message>
        <source>The alarm has no condition; enter one</source>
        <translation>La alarma no tiene condición; introduzca una</translation>
    </message>
    <message>
        <source>The element is outside the panel; move it inside</source>
        <translation>El elemento está fuera del panel; muévalo adentro</translation>
    </message>
    <message>
        <source>The picture {0} is larger than {1} MB; use a smaller one</source>
        <translation>La imagen {0} supera {1}&#xa0;MB; use una más pequeña</translation>
    </message>
    <message>
        <source>The faceplate does not say which panel it shows; choose one</source>
        <translation>El faceplate no indica qué panel muestra; elija uno</translation>
    </message>
    <message>
        <source>The key {0} has no text in {1}; enter it in the text table</source>
        <translation>La clave {0} no tiene texto en {1}; introdúzcalo en la tabla de textos</translation>
    </message>
    <message>
        <source>The help of the alarm {0} does not say what to do; add the operator&apos;s next step</source>
        <translation>La ayuda de la alarma {0} no dice qué hacer; añada el siguiente paso del operador</translation>
    </message>
    <message>
        <source>the reference is NULL; assign a variable to it, or compare it with NULL first</source>
        <translation>la referencia es NULL; asígnele una variable o compárela antes con NULL</translation>
    </message>
    <message>
        <source>the reference does not point to a variable of its type; assign one to it</source>
        <translation>la referencia no apunta a una variable de su tipo; asígnele una</translation>
    </message>
    <message>
        <source>a VAR_IN_OUT is not connected to a variable; connect it in the call</source>
        <translation>un VAR_IN_OUT no está conectado a ninguna variable; conéctelo en la llamada</translation>
    </message>
    <message>
        <source>the watchdog stopped a task that did not end; check for an endless loop</source>
        <translation>el watchdog ha detenido una tarea que no terminaba; compruebe si hay un bucle sin fin</translation>
    </message>
    <message>
        <source>the task ran longer than its watchdog time of {0}; shorten its work or raise the time</source>
        <translation>la tarea ha superado su tiempo de watchdog de {0}; reduzca su trabajo o aumente el tiempo</translation>
    </message>
    <message>
        <source>the file name is too long; choose a shorter one</source>
        <translation>el nombre del archivo es demasiado largo; elija uno más corto</translation>
    </message>
    <message>
        <source>the folder is not empty; choose another one</source>
        <translation>la carpeta no está vacía; elija otra</translation>
    </message>
    <message>
        <source>the file system is read-only; choose another folder</source>
        <translation>el sistema de archivos es de solo lectura; elija otra carpeta</translation>
    </message>
    <message>
        <source>too many files are open; close some of them</source>
        <translation>hay demasiados archivos abiertos; cierre algunos</translation>
    </message>
    <message>
        <source>The file is damaged or is not a recording; choose a file that Stepwise wrote (.rec)</source>
        <translation>El archivo está dañado o no es una grabación; elija un archivo escrito por Stepwise (.rec)</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is reached through a reference, which a path cannot follow; name the variable it refers to</source>
        <translation>a «{0}» se llega por una referencia, que una ruta no puede seguir; indique la variable a la que apunta</translation>
    </message>
    <message>
        <source>a string has one index; remove the others</source>
        <translation>una cadena tiene un solo índice; elimine los demás</translation>
    </message>
    <message>
        <source>a variable of type {0} has no elements; remove the index</source>
        <translation>una variable de tipo {0} no tiene elementos; elimine el índice</translation>
    </message>
    <message>
        <source>a variable of type {0} has no bits; remove the bit number</source>
        <translation>una variable de tipo {0} no tiene bits; elimine el número de bit</translation>
    </message>
    <message>
        <source>the program does not use the address &apos;{0}&apos;; declare a variable AT this address</source>
        <translation>el programa no usa la dirección «{0}»; declare una variable AT en esta dirección</translation>
    </message>
    <message>
        <source>the path is empty; write for example Main.x</source>
        <translation>la ruta está vacía; escriba por ejemplo Main.x</translation>
    </message>
    <message>
        <source>a constant cannot be written; change it in the program</source>
        <translation>una constante no se puede escribir; cámbiela en el programa</translation>
    </message>
    <message>
        <source>The retain file is not a regular file; remove it or choose another one</source>
        <translation>El archivo de valores remanentes no es un archivo normal; elimínelo o elija otro</translation>
    </message>
    <message>
        <source>the text has {0} characters, the maximum is {1}; shorten it</source>
        <translation>el texto tiene {0} caracteres, el máximo es {1}; acórtelo</translation>
    </message>
    <message>
        <source>{0} has {1} {1:part|parts}, the value has {2}; write one value for each</source>
        <translation>{0} tiene {1} {1:parte|partes}, el valor tiene {2}; escriba un valor para cada una</translation>
    </message>
    <message>
        <source>there is no value to write; enter one first</source>
        <translation>no hay ningún valor que escribir; introduzca antes uno</translation>
    </message>
    <message>
        <source>The expression is nested too deeply; divide it into several</source>
        <translation>La expresión está anidada demasiado profundamente; divídala en varias</translation>
    </message>
    <message>
        <source>this is not an expression; write for example Main.x &gt; 5</source>
        <translation>esto no es una expresión; escriba por ejemplo Main.x &gt; 5</translation>
    </message>
    <message>
        <source>this is not an array; remove the index</source>
        <translation>esto no es un array; elimine el índice</translation>
    </message>
    <message>
        <source>an expression cannot have side effects; use variables, operators and standard functions only</source>
        <translation>una expresión no puede tener efectos secundarios; use solo variables, operadores y funciones estándar</translation>
    </message>
    <message>
        <source>There is no body in ST or IL here; put the cursor into one</source>
        <translation>Aquí no hay ningún cuerpo en ST o IL; sitúe el cursor en uno</translation>
    </message>
    <message>
        <source>There is no library {0}; check &quot;libraries&quot; in project.json</source>
        <translation>No existe la biblioteca {0}; compruebe «libraries» en project.json</translation>
    </message>
    <message>
        <source>This folder contains neither a project.json nor ST files; choose another folder or create a project</source>
        <translation>Esta carpeta no contiene ni un project.json ni archivos ST; elija otra carpeta o cree un proyecto</translation>
    </message>
    <message>
        <source>There is no such file or folder; check the path</source>
        <translation>No se encuentra el archivo o la carpeta; compruebe la ruta</translation>
    </message>
    <message>
        <source>{0} already exists in the project; choose another name</source>
        <translation>{0} ya existe en el proyecto; elija otro nombre</translation>
    </message>
    <message>
        <source>{0} already exists in {1}; choose another name</source>
        <translation>{0} ya existe en {1}; elija otro nombre</translation>
    </message>
    <message>
        <source>The file is read-only and was not overwritten; make it writable or choose another name</source>
        <translation>El archivo es de solo lectura y no se ha sobrescrito; permita la escritura o elija otro nombre</translation>
    </message>
    <message>
        <source>{0} is not a time; write for example T#2s</source>
        <translation>{0} no es un tiempo; escriba por ejemplo T#2s</translation>
    </message>
    <message>
        <source>{0} is not a whole number; write for example 5</source>
        <translation>{0} no es un número entero; escriba por ejemplo 5</translation>
    </message>
    <message>
        <source>{0} is not a number of scans; write for example 10</source>
        <translation>{0} no es un número de ciclos; escriba por ejemplo 10</translation>
    </message>
    <message>
        <source>Nothing would lead to the join after this step; delete the join first</source>
        <translation>Nada llevaría a la convergencia después de esta etapa; elimine antes la convergencia</translation>
    </message>
    <message>
        <source>There is no branch here; choose a step or transition in a branch</source>
        <translation>Aquí no hay ninguna rama; elija una etapa o una transición en una rama</translation>
    </message>
    <message>
        <source>The last branch does not lead to a step; connect it first</source>
        <translation>La última rama no lleva a ninguna etapa; conéctela antes</translation>
    </message>
    <message>
        <source>There is no chart yet; write an INITIAL_STEP first</source>
        <translation>Aún no hay ninguna secuencia; escriba antes un INITIAL_STEP</translation>
    </message>
    <message>
        <source>An alarm has no id; give it one</source>
        <translation>Una alarma no tiene identificador; dele uno</translation>
    </message>
    <message>
        <source>Column {0} has no language tag; write one such as de or en-GB</source>
        <translation>La columna {0} no tiene etiqueta de idioma; escriba por ejemplo de o en-GB</translation>
    </message>
    <message>
        <source>This line has no key; write one in the first column</source>
        <translation>Esta línea no tiene clave; escriba una en la primera columna</translation>
    </message>
    <message>
        <source>This is not an XLIFF file; choose one that was exported for translation</source>
        <translation>Esto no es un archivo XLIFF; elija uno exportado para traducir</translation>
    </message>
    <message>
        <source>There is no panel {0}; create it or choose another one</source>
        <translation>No existe el panel {0}; créelo o elija otro</translation>
    </message>
    <message>
        <source>The key {0} is not in the text table; add it there</source>
        <translation>La clave {0} no está en la tabla de textos; añádala allí</translation>
    </message>
    <message>
        <source>The project has no language {0}; add a column for it to texts.csv</source>
        <translation>El proyecto no tiene el idioma {0}; añada una columna para él en texts.csv</translation>
    </message>
    <message>
        <source>The file {0} does not exist; add it to the project or choose another one</source>
        <translation>El archivo {0} no existe; añádalo al proyecto o elija otro</translation>
    </message>
    <message>
        <source>The panel has no group or tab {0}; create it or choose another one</source>
        <translation>El panel no tiene ningún grupo ni pestañas {0}; créelo o elija otro</translation>
    </message>
    <message>
        <source>The group {0} contains itself; choose another parent</source>
        <translation>El grupo {0} se contiene a sí mismo; elija otro elemento superior</translation>
    </message>
    <message>
        <source>A role has no name; give it one</source>
        <translation>Un rol no tiene nombre; dele uno</translation>
    </message>
    <message>
        <source>A user has no name; give it one</source>
        <translation>Un usuario no tiene nombre; dele uno</translation>
    </message>
    <message>
        <source>There is no role {0}; create it or choose another one</source>
        <translation>No existe el rol {0}; créelo o elija otro</translation>
    </message>
    <message>
        <source>A recipe has no name; give it one</source>
        <translation>Una receta no tiene nombre; dele uno</translation>
    </message>
    <message>
        <source>A set of a recipe has no name; give it one</source>
        <translation>Un juego de valores de una receta no tiene nombre; dele uno</translation>
    </message>
    <message>
        <source>The recipe has the variable {0} twice; remove one of the two</source>
        <translation>La receta tiene la variable {0} dos veces; elimine una de las dos</translation>
    </message>
    <message>
        <source>The set {0} has no value for {1}; enter one</source>
        <translation>El juego de valores {0} no tiene valor para {1}; introduzca uno</translation>
    </message>
    <message>
        <source>There is no alarm class {0}; add it or choose another one</source>
        <translation>No existe la clase de alarma {0}; añádala o elija otra</translation>
    </message>
    <message>
        <source>No panel and no alarm uses the key {0}; use it or remove it</source>
        <translation>Ningún panel ni alarma usa la clave {0}; úsela o elimínela</translation>
    </message>
    <message>
        <source>The placeholders differ: {0} has {1}, {2} has {3}; use the same in both</source>
        <translation>Los marcadores de posición difieren: {0} tiene {1}, {2} tiene {3}; use los mismos en ambos</translation>
    </message>
    <message>
        <source>The font {0} is not installed here, so texts cannot be measured; install it</source>
        <translation>La fuente {0} no está instalada aquí, por lo que los textos no se pueden medir; instálela</translation>
    </message>
    <message>
        <source>No font has the character {0}; use another one</source>
        <translation>Ninguna fuente tiene el carácter {0}; use otro</translation>
    </message>
    <message>
        <source>{0} covers a part of it; move one of the two</source>
        <translation>{0} cubre una parte; mueva uno de los dos</translation>
    </message>
    <message>
        <source>Nothing leads from the start panel {1} to the panel {0}; add a button, a navigation bar or an alarm, or choose another start panel</source>
        <translation>Nada lleva del panel inicial {1} al panel {0}; añada un botón, una barra de navegación o una alarma, o elija otro panel inicial</translation>
    </message>
    <message>
        <source>{0} of {1} alarms have the highest priority; keep it for the few that cannot wait</source>
        <translation>{0} de {1} alarmas tienen la prioridad más alta; resérvela para las pocas que no pueden esperar</translation>
    </message>
    <message>
        <source>The project has {0} {0:alarm|alarms}, but no panel has an alarm list or banner; add one</source>
        <translation>El proyecto tiene {0} {0:alarma|alarmas}, pero ningún panel tiene una lista ni un banner de alarmas; añada uno</translation>
    </message>
    <message>
        <source>{0} is critical according to project.json, but a single press writes it; set &quot;Writes are confirmed&quot;</source>
        <translation>{0} es crítico según project.json, pero una sola pulsación lo escribe; active «Las escrituras se confirman»</translation>
    </message>
    <message>
        <source>{0} suppresses alarms, but a single press writes it; set &quot;Writes are confirmed&quot;</source>
        <translation>{0} suprime alarmas, pero una sola pulsación lo escribe; active «Las escrituras se confirman»</translation>
    </message>
    <message>
        <source>The start panel has {0} controls, but no text says what to press when nothing moves; add a sentence, or a state text that names a control</source>
        <translation>El panel inicial tiene {0} elementos de mando, pero ningún texto dice qué pulsar cuando nada se mueve; añada una frase o un texto de estado que nombre un elemento de mando</translation>
    </message>
    <message>
        <source>A machine at rest looks the same whether it is broken or just waiting. The start panel must say what to press next: a sentence below the title, or a state text such as “Ready: press S1”.</source>
        <translation>Una máquina parada tiene el mismo aspecto si está averiada que si solo espera. El panel inicial debe decir qué pulsar a continuación: una frase bajo el título o un texto de estado como «Listo: pulse S1».</translation>
    </message>
    <message>
        <source>{0} is not the code of a language; use codes such as {1} or {2}</source>
        <translation>{0} no es un código de idioma; use códigos como {1} o {2}</translation>
    </message>
    <message>
        <source>Single files have no project.json for settings; create a project and put them into its folder src</source>
        <translation>Los archivos sueltos no tienen project.json para los ajustes; cree un proyecto y póngalos en su carpeta src</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>Alarm texts in five languages</source>
        <translation>Textos de alarma en cinco idiomas</translation>
    </message>
    <message>
        <source>Heated tank with analog blocks</source>
        <translation>Depósito con bloques analógicos</translation>
    </message>
    <message>
        <source>Bottling line</source>
        <translation>Línea de embotellado</translation>
    </message>
    <message>
        <source>Car park with a robot</source>
        <translation>Aparcamiento robotizado</translation>
    </message>
    <message>
        <source>Car wash with recipes</source>
        <translation>Túnel de lavado con recetas</translation>
    </message>
    <message>
        <source>Room heating with supply air</source>
        <translation>Sala calefactada con aire de impulsión</translation>
    </message>
    <message>
        <source>Motor valve with command monitor</source>
        <translation>Válvula motorizada con supervisión</translation>
    </message>
    <message>
        <source>Conveyor with a sequence</source>
        <translation>Cinta con secuencia</translation>
    </message>
    <message>
        <source>Depalletiser</source>
        <translation>Despaletizador</translation>
    </message>
    <message>
        <source>District-heating substation</source>
        <translation>Subestación de calefacción urbana</translation>
    </message>
    <message>
        <source>Dosing</source>
        <translation>Dosificación</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Gravel plant</source>
        <translation>Planta de grava</translation>
    </message>
    <message>
        <source>Heater and valve</source>
        <translation>Calefactor y válvula</translation>
    </message>
    <message>
        <source>Hour meter with reset and enable</source>
        <translation>Cuentahoras con habilitación</translation>
    </message>
    <message>
        <source>Hourly production</source>
        <translation>Piezas por hora</translation>
    </message>
    <message>
        <source>Item counter and meters</source>
        <translation>Piezas y contadores</translation>
    </message>
    <message>
        <source>Level lamps</source>
        <translation>Pilotos de nivel</translation>
    </message>
    <message>
        <source>Light tower</source>
        <translation>Columna luminosa</translation>
    </message>
    <message>
        <source>Tuning a control loop</source>
        <translation>Ajuste de un lazo de control</translation>
    </message>
    <message>
        <source>Mixer for two liquids and two bricks</source>
        <translation>Mezclador de dos líquidos y dos bloques</translation>
    </message>
    <message>
        <source>Motor with latching</source>
        <translation>Motor con autorretención</translation>
    </message>
    <message>
        <source>Operation mode of an agitator</source>
        <translation>Modo de operación de un agitador</translation>
    </message>
    <message>
        <source>PID loop on a first-order process</source>
        <translation>Lazo PID, proceso de primer orden</translation>
    </message>
    <message>
        <source>Two pumps in a well</source>
        <translation>Dos bombas en un pozo</translation>
    </message>
    <message>
        <source>Pulse width modulation of a sine</source>
        <translation>Modulación por ancho de pulso</translation>
    </message>
    <message>
        <source>Storage rack with a robot</source>
        <translation>Estantería con robot</translation>
    </message>
    <message>
        <source>Robot and CNC machine</source>
        <translation>Robot y máquina CNC</translation>
    </message>
    <message>
        <source>Packing robot with camera inspection</source>
        <translation>Robot que llena cajas</translation>
    </message>
    <message>
        <source>Two redundant level sensors</source>
        <translation>Dos sensores de nivel que se supervisan</translation>
    </message>
    <message>
        <source>Pumping station with six pumps</source>
        <translation>Estación de bombeo con seis bombas</translation>
    </message>
    <message>
        <source>Motor with selector switch</source>
        <translation>Motor con selector</translation>
    </message>
    <message>
        <source>Stack of integers</source>
        <translation>Pila de enteros</translation>
    </message>
    <message>
        <source>Tank with filling, heating and emptying</source>
        <translation>Depósito que se llena, calienta y vacía</translation>
    </message>
    <message>
        <source>Manually operated tank</source>
        <translation>Depósito en modo manual</translation>
    </message>
    <message>
        <source>Level and volume</source>
        <translation>Nivel y volumen</translation>
    </message>
    <message>
        <source>Traffic light</source>
        <translation>Semáforo</translation>
    </message>
    <message>
        <source>Valve matrix</source>
        <translation>Matriz de válvulas</translation>
    </message>
    <message>
        <source>Three kinds of valves</source>
        <translation>Tres tipos de válvulas</translation>
    </message>
    <message>
        <source>Pump control with waves</source>
        <translation>Bomba con oleaje</translation>
    </message>
    <message>
        <source>Truck scale</source>
        <translation>Báscula de camiones</translation>
    </message>
    <message>
        <source>Workbook</source>
        <translation>Cuaderno de ejercicios</translation>
    </message>
    <message>
        <source>Tank over Modbus</source>
        <translation>Depósito por Modbus</translation>
    </message>
    <message>
        <source>A vehicle between two limit switches, controlled by two linked sequential function charts</source>
        <translation>Un vehículo entre dos finales de carrera, con dos secuencias SFC enlazadas</translation>
    </message>
    <message>
        <source>A motor with three alarms that operators read in five languages</source>
        <translation>Un motor con tres alarmas que el operador lee en cinco idiomas</translation>
    </message>
    <message>
        <source>One control loop with a block for each task: filter, monitor, ramp, PID, transfer</source>
        <translation>Un lazo con un bloque para cada tarea: filtro, supervisión, rampa, PID, conmutación</translation>
    </message>
    <message>
        <source>Filler, capper and labeller with buffers between them, controlled as PackML units</source>
        <translation>Llenadora, taponadora y etiquetadora con pulmones intermedios, según PackML</translation>
    </message>
    <message>
        <source>A robot parks cars by number plate and retrieves them again</source>
        <translation>Un robot aparca los coches según su matrícula y los recoge de nuevo</translation>
    </message>
    <message>
        <source>Five wash programmes, each with a price and a recipe that the owner can edit</source>
        <translation>Cinco programas de lavado, cada uno con precio y receta modificables</translation>
    </message>
    <message>
        <source>Cascade control: a slow loop for the room, a fast one for the supply air</source>
        <translation>Control en cascada: un lazo lento para la sala y uno rápido para el aire de impulsión</translation>
    </message>
    <message>
        <source>A motor valve whose travel is monitored; if it takes too long, an alarm sounds</source>
        <translation>Una válvula motorizada con recorrido supervisado; si tarda demasiado, suena una alarma</translation>
    </message>
    <message>
        <source>A belt carries an item to the right, waits ten seconds and carries it back</source>
        <translation>Una cinta lleva una pieza a la derecha, espera diez segundos y la devuelve</translation>
    </message>
    <message>
        <source>Four belts take boxes off pallets; the settings of one can be copied to another</source>
        <translation>Cuatro cintas descargan cajas de palés; los ajustes de una se copian a otra</translation>
    </message>
    <message>
        <source>Heating and hot water from a district-heating network, with frost protection and summer mode</source>
        <translation>Calefacción y agua caliente de una red de calor, con antihielo y modo verano</translation>
    </message>
    <message>
        <source>A valve doses in pulses and pauses until the batch is complete</source>
        <translation>Una válvula dosifica con pulsos y pausas hasta completar el lote</translation>
    </message>
    <message>
        <source>The pressure drop shows how dirty a filter is; an alarm reports when it is out of range</source>
        <translation>La pérdida de carga indica la suciedad de un filtro; fuera de rango, una alarma</translation>
    </message>
    <message>
        <source>Silo, bin, conveyor and truck, controlled by three parallel sequential function charts</source>
        <translation>Silo, tolva, cinta y camión, controlados por tres secuencias SFC en paralelo</translation>
    </message>
    <message>
        <source>Two on-off controls: a heater with a set point, and a valve that opens on a pump alarm</source>
        <translation>Dos controles todo o nada: un calefactor con consigna y una válvula ligada a una alarma</translation>
    </message>
    <message>
        <source>An hour meter that is loaded, enabled and held, giving a sawtooth</source>
        <translation>Un contador de horas que se carga, se habilita y se detiene: un diente de sierra</translation>
    </message>
    <message>
        <source>A press makes items; a table counts how many in each hour of the day</source>
        <translation>Una prensa fabrica piezas; una tabla las cuenta por cada hora del día</translation>
    </message>
    <message>
        <source>Counts items, energy and water; the counts survive a power failure</source>
        <translation>Cuenta piezas, energía y agua; los valores sobreviven a un corte de corriente</translation>
    </message>
    <message>
        <source>A 4 to 20 mA level sensor, three lamps and wire break detection</source>
        <translation>Un sensor de nivel de 4 a 20&#xa0;mA, tres pilotos y detección de rotura de cable</translation>
    </message>
    <message>
        <source>Three machine signals on three lamps that flash or stay on</source>
        <translation>Tres señales de una máquina en tres pilotos, fijos o intermitentes</translation>
    </message>
    <message>
        <source>A heat exchanger that oscillates; an experiment and its recording give better settings</source>
        <translation>Un intercambiador oscila; un ensayo y su grabación dan mejores parámetros</translation>
    </message>
    <message>
        <source>Liquids are weighed while a belt brings two bricks; then the mixer turns and tips</source>
        <translation>Se pesan líquidos, una cinta trae dos bloques; después el mezclador gira y vuelca</translation>
    </message>
    <message>
        <source>Start, stop and a latching contactor, written in five ways that agree</source>
        <translation>Marcha, paro y un contactor con autorretención, escritos de cinco formas equivalentes</translation>
    </message>
    <message>
        <source>The local control box or the panel: one block decides which of them is in control</source>
        <translation>Mando local o panel: un bloque decide cuál de los dos tiene el control</translation>
    </message>
    <message>
        <source>The same process with and without a PID controller, side by side in one trace</source>
        <translation>El mismo proceso con y sin regulador PID, juntos en una traza</translation>
    </message>
    <message>
        <source>One filter, two sines: the slow one passes, the fast one is attenuated and delayed</source>
        <translation>Un filtro, dos senos: el lento pasa, el rápido se atenúa y se retrasa</translation>
    </message>
    <message>
        <source>A pump tries its speeds and keeps the one with the least energy per cubic metre</source>
        <translation>Una bomba prueba velocidades y mantiene la de menor energía por metro cúbico</translation>
    </message>
    <message>
        <source>Two alternating pumps; a float switch is accepted only after two steady seconds</source>
        <translation>Dos bombas se turnan; un flotador cuenta solo tras dos segundos estables</translation>
    </message>
    <message>
        <source>A sine becomes pulses for two outputs, as for a motor with two directions</source>
        <translation>Un seno se convierte en pulsos para dos salidas, como en un motor de dos sentidos</translation>
    </message>
    <message>
        <source>A robot counts encoder pulses to store and retrieve loads in twelve locations</source>
        <translation>Un robot cuenta pulsos de encoder para guardar y recoger cargas en doce huecos</translation>
    </message>
    <message>
        <source>A robot takes 25 items one by one to a CNC machine and back</source>
        <translation>Un robot lleva 25 piezas, una a una, a una máquina CNC y las devuelve</translation>
    </message>
    <message>
        <source>A robot puts three items into each box; a camera checks the result</source>
        <translation>Un robot pone tres piezas en cada caja; una cámara comprueba el resultado</translation>
    </message>
    <message>
        <source>Two sensors are compared; a faulty one is replaced with the healthy one without a jump</source>
        <translation>Dos sensores se comparan; uno sustituye sin saltos al otro si falla</translation>
    </message>
    <message>
        <source>Starts and stops six pumps by level and running hours, with the daily inflow of a town</source>
        <translation>Seis bombas según el nivel y las horas de servicio, al ritmo diario de una ciudad</translation>
    </message>
    <message>
        <source>A rotary switch selects the speed of a motor, a number what a module does</source>
        <translation>Un selector elige la velocidad de un motor y un número, la función de un módulo</translation>
    </message>
    <message>
        <source>Last in, first out: push, pop and reset, in ST and as an instruction list</source>
        <translation>Último en entrar, primero en salir: push, pop y reset, en ST y en lista de instrucciones</translation>
    </message>
    <message>
        <source>The same sequence twice: with CASE and as a sequential function chart; either can be in control</source>
        <translation>La misma secuencia dos veces: con CASE y en SFC; cualquiera puede mandar</translation>
    </message>
    <message>
        <source>Fill, empty and stir with three switches; two level switches prevent operating errors</source>
        <translation>Llenar, vaciar y agitar con tres interruptores; dos de nivel evitan errores</translation>
    </message>
    <message>
        <source>A current of 4 to 20 mA becomes a level, and the level becomes a volume</source>
        <translation>Una corriente de 4 a 20&#xa0;mA se convierte en nivel, y el nivel en volumen</translation>
    </message>
    <message>
        <source>Red, yellow and green from one seconds counter, written in three ways</source>
        <translation>Rojo, amarillo y verde con un contador de segundos, escrito de tres formas</translation>
    </message>
    <message>
        <source>Five tanks, three pipelines, fifteen valves; two tanks never feed the same pipeline</source>
        <translation>Cinco depósitos, tres tuberías, quince válvulas; nunca dos depósitos en una tubería</translation>
    </message>
    <message>
        <source>A motor valve, a spring-return valve and a control valve, each with its block</source>
        <translation>Una válvula motorizada, una con retorno por muelle y una de control, cada una con su bloque</translation>
    </message>
    <message>
        <source>A float switch in waves: the pump starts and stops only after five steady seconds</source>
        <translation>Un flotador entre olas: la bomba conmuta solo tras cinco segundos estables</translation>
    </message>
    <message>
        <source>Four BCD digits become the net weight once the scale has settled</source>
        <translation>Cuatro dígitos BCD dan el peso neto en cuanto la báscula se estabiliza</translation>
    </message>
    <message>
        <source>Language samples on four pages, each a separate program with a test</source>
        <translation>Ejemplos del lenguaje en cuatro páginas, cada uno un programa con su prueba</translation>
    </message>
    <message>
        <source>Automated guided vehicle</source>
        <translation>Vehículo de guiado automático</translation>
    </message>
    <message>
        <source>First-order filter and two sines</source>
        <translation>Filtro de primer orden y dos senos</translation>
    </message>
    <message>
        <source>Pump at its most efficient speed</source>
        <translation>Bomba a su velocidad óptima</translation>
    </message>
    <message>
        <source>A controller and a tank, connected on this computer by real Modbus TCP</source>
        <translation>Un controlador y un depósito, unidos en este equipo por Modbus TCP real</translation>
    </message>
</context>
<context>
    <name>Exchange</name>
    <message>
        <source>The file is written in {0}</source>
        <translation>El archivo está escrito en {0}</translation>
    </message>
    <message>
        <source>The file was not read: {0}</source>
        <translation>El archivo no se ha leído: {0}</translation>
    </message>
    <message>
        <source>The element {0} was not read; add it by hand if the program needs it</source>
        <translation>El elemento {0} no se ha leído; añádalo a mano si el programa lo necesita</translation>
    </message>
    <message>
        <source>The vendor&apos;s data {0} is kept in exchange.json</source>
        <translation>Los datos {0} del fabricante se conservan en exchange.json</translation>
    </message>
    <message>
        <source>The body in {0} became structured text; the diagram is kept in exchange.json</source>
        <translation>El cuerpo de {0} se ha convertido en texto estructurado; el diagrama se conserva en exchange.json</translation>
    </message>
    <message>
        <source>The body in {0} is stored in a form that only its own editor reads; export it there as PLCopen XML</source>
        <translation>El cuerpo de {0} está guardado en un formato que solo lee su propio editor; expórtelo allí como PLCopen XML</translation>
    </message>
    <message>
        <source>A jump leads to the step {0}, which does not exist; add the step or correct the jump</source>
        <translation>Un salto lleva a la etapa {0}, que no existe; añada la etapa o corrija el salto</translation>
    </message>
    <message>
        <source>The element {0} of the chart is not connected and was left out; connect it in the other tool and export again</source>
        <translation>El elemento {0} de la secuencia (SFC) no está conectado y se ha omitido; conéctelo en la otra herramienta y exporte de nuevo</translation>
    </message>
    <message>
        <source>The transition from {0} has no condition and is written as FALSE; enter its condition</source>
        <translation>La transición desde {0} no tiene condición y se escribe como FALSE; introduzca su condición</translation>
    </message>
    <message>
        <source>The element {0} takes part in a loop without a block that stores a value, so its last value is not kept; store it in a variable</source>
        <translation>El elemento {0} forma parte de un bucle sin bloque que almacene un valor, por lo que su último valor no se conserva; guárdelo en una variable</translation>
    </message>
    <message>
        <source>The element {0} is not connected and was left out; connect it in the other tool and export again</source>
        <translation>El elemento {0} no está conectado y se ha omitido; conéctelo en la otra herramienta y exporte de nuevo</translation>
    </message>
    <message>
        <source>An input of {0} is not connected, so its call has too few arguments; add the value that is meant</source>
        <translation>Una entrada de {0} no está conectada, por lo que su llamada tiene muy pocos argumentos; añada el valor previsto</translation>
    </message>
    <message>
        <source>An edge in a function needs the value of the last call, which a function does not store; make it a FUNCTION_BLOCK</source>
        <translation>Un flanco en una función necesita el valor de la última llamada, que una función no almacena; conviértala en un FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>The result of {0} is used in several places and is computed in each; assign it to a variable to compute it once</source>
        <translation>El resultado de {0} se usa en varios lugares y se calcula en cada uno; asígnelo a una variable para calcularlo una sola vez</translation>
    </message>
    <message>
        <source>The type of the result of {0} is not known, so it is computed although EN is FALSE; call it under an IF</source>
        <translation>El tipo del resultado de {0} no se conoce, por lo que se calcula aunque EN sea FALSE; llámelo bajo un IF</translation>
    </message>
    <message>
        <source>The library {0} is not part of Stepwise; uses of it are reported by the check</source>
        <translation>La biblioteca {0} no forma parte de Stepwise; la comprobación notifica sus usos</translation>
    </message>
    <message>
        <source>Code in C is kept as a comment and is not executed; write it in ST</source>
        <translation>El código en C se conserva como comentario y no se ejecuta; escríbalo en ST</translation>
    </message>
    <message>
        <source>There are two units named {0}; the second is in {1}</source>
        <translation>Hay dos POU llamadas {0}; la segunda está en {1}</translation>
    </message>
    <message>
        <source>The configuration of the devices was not read; assign the inputs and outputs again</source>
        <translation>La configuración de los dispositivos no se ha leído; vuelva a asignar las entradas y salidas</translation>
    </message>
    <message>
        <source>The task {0} is started by the event {1}, which does not exist here; give it an INTERVAL or a SINGLE</source>
        <translation>La tarea {0} la inicia el evento {1}, que aquí no existe; asígnele un INTERVAL o un SINGLE</translation>
    </message>
    <message>
        <source>A comment outside of the elements was left out: {0}</source>
        <translation>Se ha omitido un comentario fuera de los elementos: {0}</translation>
    </message>
    <message>
        <source>The diagram in {0} was not read: an expression refers to itself endlessly; write its body in ST</source>
        <translation>El diagrama en {0} no se ha leído: una expresión se refiere a sí misma sin fin; escriba su cuerpo en ST</translation>
    </message>
    <message>
        <source>The transition {0} is not a single expression and was not read; write its condition in the text</source>
        <translation>La transición {0} no es una única expresión y no se ha leído; escriba su condición en el texto</translation>
    </message>
    <message>
        <source>PLCopen XML does not support panels; they were left out</source>
        <translation>PLCopen XML no admite paneles; se han omitido</translation>
    </message>
    <message>
        <source>PLCopen XML does not support traces; they were left out</source>
        <translation>PLCopen XML no admite trazas; se han omitido</translation>
    </message>
    <message>
        <source>PLCopen XML does not support tests; they were left out</source>
        <translation>PLCopen XML no admite pruebas; se han omitido</translation>
    </message>
    <message>
        <source>PLCopen XML does not support tests; the TEST &apos;{0}&apos; was left out</source>
        <translation>PLCopen XML no admite pruebas; el TEST «{0}» se ha omitido</translation>
    </message>
    <message>
        <source>PLCopen XML does not support namespaces; the names of {0} are written without the prefix</source>
        <translation>PLCopen XML no admite espacios de nombres; los nombres de {0} se escriben sin el prefijo</translation>
    </message>
    <message>
        <source>PLCopen XML does not support namespaces; {0} was left out with its units because there is another {1}; rename one of them</source>
        <translation>PLCopen XML no admite espacios de nombres; se ha omitido {0} con sus POU porque hay otro {1}; cambie el nombre de uno de ellos</translation>
    </message>
    <message>
        <source>PLCopen XML does not support USING; it was left out</source>
        <translation>PLCopen XML no admite USING; se ha omitido</translation>
    </message>
    <message>
        <source>PLCopen XML does not support the name of the transition {0}; it was left out</source>
        <translation>PLCopen XML no admite el nombre de la transición {0}; se ha omitido</translation>
    </message>
    <message>
        <source>PLCopen XML has one indicator per action; {0} was left out</source>
        <translation>PLCopen XML tiene un indicador por acción; {0} se ha omitido</translation>
    </message>
    <message>
        <source>Version 0201 has no methods; {0} was left out</source>
        <translation>La versión 0201 no tiene métodos; {0} se ha omitido</translation>
    </message>
    <message>
        <source>Version 0201 has no properties; {0} was left out</source>
        <translation>La versión 0201 no tiene propiedades; {0} se ha omitido</translation>
    </message>
    <message>
        <source>Version 0201 has no interfaces; {0} was left out</source>
        <translation>La versión 0201 no tiene interfaces; {0} se ha omitido</translation>
    </message>
    <message>
        <source>Version 0201 has no unions; {0} was left out</source>
        <translation>La versión 0201 no tiene uniones; {0} se ha omitido</translation>
    </message>
    <message>
        <source>Version 0201 has no inheritance; EXTENDS or IMPLEMENTS of {0} was left out</source>
        <translation>La versión 0201 no tiene herencia; se ha omitido EXTENDS o IMPLEMENTS de {0}</translation>
    </message>
    <message>
        <source>Version 0201 does not have the type {0}; other tools will not know it</source>
        <translation>La versión 0201 no tiene el tipo {0}; otras herramientas no lo conocerán</translation>
    </message>
    <message>
        <source>Version 0201 does not support the pragma {0} of a step; it was left out</source>
        <translation>La versión 0201 no admite el pragma {0} de una etapa; se ha omitido</translation>
    </message>
    <message>
        <source>Version 0201 does not support {0} of a task; it was left out</source>
        <translation>La versión 0201 no admite {0} de una tarea; se ha omitido</translation>
    </message>
    <message>
        <source>Version 0201 does not support the connections of the program {0}; they were left out</source>
        <translation>La versión 0201 no admite las conexiones del programa {0}; se han omitido</translation>
    </message>
    <message>
        <source>Version 0201 does not support libraries; {0} was left out</source>
        <translation>La versión 0201 no admite bibliotecas; {0} se ha omitido</translation>
    </message>
    <message>
        <source>The file is not a program source and was left out; import it separately if it is one</source>
        <translation>El archivo no es código fuente y se ha omitido; impórtelo solo si lo es</translation>
    </message>
    <message>
        <source>The network &apos;{0}&apos; is commented out in the diagram and was left out of the text</source>
        <translation>El segmento «{0}» está comentado en el diagrama y se ha omitido del texto</translation>
    </message>
    <message>
        <source>Types that are predefined in {0} are declared here</source>
        <translation>Los tipos predefinidos de {0} se declaran aquí</translation>
    </message>
    <message>
        <source>{0} counts %MW1 in words; &quot;addressing&quot; in project.json says the same</source>
        <translation>{0} cuenta %MW1 en palabras; «addressing» en project.json dice lo mismo</translation>
    </message>
    <message>
        <source>The address {0} starts at a byte that tools counting in words cannot address; move it to a multiple of its size</source>
        <translation>La dirección {0} empieza en un byte que las herramientas que cuentan en palabras no pueden direccionar; muévala a un múltiplo de su tamaño</translation>
    </message>
    <message>
        <source>{0} accesses the system outside the controller; it is declared here with its inputs and outputs but does nothing</source>
        <translation>{0} accede al sistema fuera del controlador; se declara aquí con sus entradas y salidas, pero no hace nada</translation>
    </message>
    <message>
        <source>The library {0} is part of this import; its names are written without the prefix {0}</source>
        <translation>La biblioteca {0} forma parte de esta importación; sus nombres se escriben sin el prefijo {0}</translation>
    </message>
    <message>
        <source>The names of the library {0} are built into Stepwise; they are written without the prefix {0}</source>
        <translation>Los nombres de la biblioteca {0} están integrados en Stepwise; se escriben sin el prefijo {0}</translation>
    </message>
    <message>
        <source>The program uses __NEW; &quot;memoryForNew&quot; in project.json sets 65536 bytes aside for it</source>
        <translation>El programa usa __NEW; «memoryForNew» en project.json le reserva 65536 bytes</translation>
    </message>
    <message>
        <source>STRING constants contain characters that Latin-1 does not have ({0} and so on); &quot;stringEncoding&quot; in project.json is {1}</source>
        <translation>Hay constantes STRING con caracteres que Latin-1 no tiene ({0}, etc.); «stringEncoding» en project.json es {1}</translation>
    </message>
    <message>
        <source>The file is empty; export it again</source>
        <translation>El archivo está vacío; expórtelo de nuevo</translation>
    </message>
    <message>
        <source>This is a ZIP archive despite its name; extract it and import the folder</source>
        <translation>A pesar de su nombre, es un archivo ZIP; descomprímalo e importe la carpeta</translation>
    </message>
    <message>
        <source>The file is in the folder of the project {0}, which does not list it or excludes it from its build; it was left out</source>
        <translation>El archivo está en la carpeta del proyecto {0}, que no lo incluye en su lista o lo excluye de su compilación; se ha omitido</translation>
    </message>
    <message>
        <source>Several projects of the folder have a unit named {0}; each became a project of its own, together with the libraries it uses: this one is {1}</source>
        <translation>Varios proyectos de la carpeta tienen una POU llamada {0}; cada uno pasó a ser un proyecto propio, con las bibliotecas que usa: este es {1}</translation>
    </message>
    <message>
        <source>The program {0} of the library {1} was left out: the project that uses the library has one of that name</source>
        <translation>Se ha omitido el programa {0} de la biblioteca {1}: el proyecto que usa la biblioteca tiene uno con ese nombre</translation>
    </message>
    <message>
        <source>The folder has no project named {0}; it has: {1}</source>
        <translation>La carpeta no contiene ningún proyecto llamado {0}; contiene: {1}</translation>
    </message>
    <message>
        <source>The names of inputs and outputs that the configuration of the devices declares ({0} and so on) are in PLC_Configuration</source>
        <translation>Los nombres de las entradas y salidas que declara la configuración de los dispositivos ({0}, etc.) están en PLC_Configuration</translation>
    </message>
    <message>
        <source>The file is not valid UTF-8 and specifies no other encoding; it was read as {0}. If letters are wrong, import it again with another encoding</source>
        <translation>El archivo no es UTF-8 válido y no declara otra codificación; se leyó como {0}. Si hay letras incorrectas, impórtelo de nuevo con otra codificación</translation>
    </message>
    <message>
        <source>Macro step {0} was replaced by the steps inside it; steps whose names were already used are prefixed with {0}</source>
        <translation>La macroetapa {0} se ha sustituido por las etapas que contiene; las etapas cuyo nombre ya se usaba llevan el prefijo {0}</translation>
    </message>
    <message>
        <source>The program uses {0} of the library {1}, which reaches outside a simulated controller; declare POUs of these names that do what the simulation needs</source>
        <translation>El programa usa {0} de la biblioteca {1}, que va más allá de un controlador simulado; declare POU con esos nombres que hagan lo que la simulación necesita</translation>
    </message>
    <message>
        <source>Conditions in {0} are drawn with blocks; the action {1}, which runs in every scan from the initial step on, calls them</source>
        <translation>Hay condiciones en {0} dibujadas con bloques; la acción {1}, que se ejecuta en cada ciclo desde la etapa inicial, los llama</translation>
    </message>
    <message>
        <source>The drawn body of {0} was not read; open the project in CODESYS V3 and export it there as PLCopen XML</source>
        <translation>El cuerpo dibujado de {0} no se ha leído; abra el proyecto en CODESYS V3 y expórtelo allí como PLCopen XML</translation>
    </message>
    <message>
        <source>The drawn body of {0} was not read: the order of the inputs of {1} is not known. Import the file that declares {1} together with this one</source>
        <translation>El cuerpo dibujado de {0} no se ha leído: no se conoce el orden de las entradas de {1}. Importe el archivo que declara {1} junto con este</translation>
    </message>
    <message>
        <source>The program uses {0}, which none of its files declares; the project uses the library {1}, which has it</source>
        <translation>El programa usa {0}, que ninguno de sus archivos declara; el proyecto usa la biblioteca {1}, que lo contiene</translation>
    </message>
    <message>
        <source>The task {0} runs {1}, a program of a library; it was left out. Call what the machine needs of it from a program of the project</source>
        <translation>La tarea {0} ejecuta {1}, un programa de una biblioteca; se ha omitido. Llame a lo que la máquina necesite de él desde un programa del proyecto</translation>
    </message>
    <message>
        <source>The variables of this extension are declared in {0}; its code in C or Python is not executed. Write to them in ST what the code does</source>
        <translation>Las variables de esta extensión están declaradas en {0}; su código en C o Python no se ejecuta. Escríbalas en ST como lo hace el código</translation>
    </message>
    <message>
        <source>Version 0201 does not support the constructor arguments of {0}; they were left out</source>
        <translation>La versión 0201 no admite los argumentos del constructor de {0}; se han omitido</translation>
    </message>
</context>
<context>
    <name>FigureText</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>An XY plot draws one channel against another: add a second channel to the trace.</source>
        <translation>Un gráfico XY muestra un canal frente a otro: añada un segundo canal a la traza.</translation>
    </message>
    <message>
        <source>XY plot</source>
        <translation>Gráfico XY</translation>
    </message>
    <message>
        <source>There are no samples in view: run the program or show another section.</source>
        <translation>No hay muestras a la vista: ejecute el programa o muestre otro tramo.</translation>
    </message>
    <message>
        <source>%L1 points over %2</source>
        <translation>%L1 puntos en %2</translation>
    </message>
    <message>
        <source>A spectrum shows the frequencies of the visible channels: add a channel.</source>
        <translation>Un espectro muestra las frecuencias de los canales visibles: añada un canal.</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Espectro</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>Frecuencia [Hz]</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>amplitud</translation>
    </message>
    <message>
        <source>%1: no peak, RMS %2</source>
        <translation>%1: sin pico, valor eficaz %2</translation>
    </message>
    <message>
        <source>%1: %2, RMS %3</source>
        <translation>%1: %2, valor eficaz %3</translation>
    </message>
    <message>
        <source>A frequency response compares an output with an input: add both as channels, and choose the input.</source>
        <translation>Una respuesta en frecuencia compara una salida con una entrada: añada ambas como canales y elija la entrada.</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Respuesta en frecuencia</translation>
    </message>
    <message>
        <source>gain [dB]</source>
        <translation>ganancia [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>fase [°]</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>coherencia</translation>
    </message>
    <message>
        <source>%1: %L2 of %L3 frequencies with a coherence above 0.8</source>
        <translation>%1: %L2 de %L3 frecuencias con una coherencia superior a 0,8</translation>
    </message>
    <message>
        <source>Runs are overlaid at their triggers: enter a trigger in the properties of the trace.</source>
        <translation>Las ejecuciones se superponen en su disparo: introduzca un disparador en las propiedades de la traza.</translation>
    </message>
    <message>
        <source>The trigger has not fired in this recording yet.</source>
        <translation>El disparador aún no se ha activado en esta grabación.</translation>
    </message>
    <message>
        <source>The runs of the visible channels are overlaid: add a channel.</source>
        <translation>Las ejecuciones de los canales visibles se superponen: añada un canal.</translation>
    </message>
    <message>
        <source>Time since the trigger [s]</source>
        <translation>Tiempo desde el disparo [s]</translation>
    </message>
    <message>
        <source>%1: runs differ most %2 after the trigger, by %3</source>
        <translation>%1: las ejecuciones difieren más %2 después del disparo, en %3</translation>
    </message>
    <message>
        <source>Charts over Time Only</source>
        <translation>Solo gráficos temporales</translation>
    </message>
    <message>
        <source>XY Plot</source>
        <translation>Gráfico XY</translation>
    </message>
    <message>
        <source>Frequency Response (Bode)</source>
        <translation>Respuesta en frecuencia (Bode)</translation>
    </message>
    <message>
        <source>Runs over Each Other</source>
        <translation>Ejecuciones superpuestas</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n ejecución</numerusform>
            <numerusform>%n ejecuciones</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Fixes</name>
    <message>
        <source>Replace with {0}</source>
        <translation>Reemplazar por {0}</translation>
    </message>
    <message>
        <source>Insert {0}</source>
        <translation>Insertar {0}</translation>
    </message>
    <message>
        <source>Did you mean {0}?</source>
        <translation>¿Quería decir {0}?</translation>
    </message>
    <message>
        <source>Convert with {0}</source>
        <translation>Convertir con {0}</translation>
    </message>
    <message>
        <source>Move {0} to {1}</source>
        <translation>Mover {0} a {1}</translation>
    </message>
    <message>
        <source>Add the property {0}</source>
        <translation>Añadir la propiedad {0}</translation>
    </message>
    <message>
        <source>Add the method {0}</source>
        <translation>Añadir el método {0}</translation>
    </message>
    <message>
        <source>Add the missing branches</source>
        <translation>Añadir las ramas que faltan</translation>
    </message>
    <message>
        <source>Add ELSE</source>
        <translation>Añadir ELSE</translation>
    </message>
    <message>
        <source>Add () to call it</source>
        <translation>Añadir () para llamarlo</translation>
    </message>
    <message>
        <source>Compare with 0</source>
        <translation>Comparar con 0</translation>
    </message>
    <message>
        <source>Remove the unused declaration</source>
        <translation>Quitar la declaración sin usar</translation>
    </message>
    <message>
        <source>Replace with IF and ELSIF</source>
        <translation>Reemplazar por IF y ELSIF</translation>
    </message>
    <message>
        <source>Change to a WSTRING literal</source>
        <translation>Cambiar a un literal WSTRING</translation>
    </message>
    <message>
        <source>Replace with straight quotes</source>
        <translation>Reemplazar por comillas rectas</translation>
    </message>
    <message>
        <source>Make {0} the initial step</source>
        <translation>Convertir {0} en la etapa inicial</translation>
    </message>
    <message>
        <source>Dereference the pointer with ^</source>
        <translation>Desreferenciar el puntero con ^</translation>
    </message>
</context>
<context>
    <name>Hmi</name>
    <message>
        <source>as it is</source>
        <translation>sin cambios</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Otro…</translation>
    </message>
    <message>
        <source>A variable that is written</source>
        <translation>Una variable que se escribe</translation>
    </message>
    <message>
        <source>An ST expression</source>
        <translation>Una expresión ST</translation>
    </message>
    <message>
        <source>Shown to the operator. A typed text gets its key automatically; @key uses an existing one.</source>
        <translation>Se muestra al operador. Un texto escrito recibe su clave automáticamente; @clave usa una existente.</translation>
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
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.svg)</source>
        <translation>Imágenes (*.png *.jpg *.svg)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Unknown element</source>
        <translation>Elemento desconocido</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarma</translation>
    </message>
    <message>
        <source>Alarm class</source>
        <translation>Clase de alarma</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Grosor de línea</translation>
    </message>
    <message>
        <source>Line style</source>
        <translation>Estilo de línea</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Relleno</translation>
    </message>
    <message>
        <source>Fill level</source>
        <translation>Nivel de llenado</translation>
    </message>
    <message>
        <source>Full at</source>
        <translation>Lleno con</translation>
    </message>
    <message>
        <source>Level colour</source>
        <translation>Color del nivel</translation>
    </message>
    <message>
        <source>Font size</source>
        <translation>Tamaño de letra</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>Negrita</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Alineación</translation>
    </message>
    <message>
        <source>Text colour</source>
        <translation>Color del texto</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Mínimo</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Limit low-low</source>
        <translation>Límite muy bajo (LL)</translation>
    </message>
    <message>
        <source>Limit low</source>
        <translation>Límite bajo (L)</translation>
    </message>
    <message>
        <source>Limit high</source>
        <translation>Límite alto (H)</translation>
    </message>
    <message>
        <source>Limit high-high</source>
        <translation>Límite muy alto (HH)</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Opciones</translation>
    </message>
    <message>
        <source>Text list</source>
        <translation>Lista de textos</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Cuadrícula</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Identificador</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condición</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Prioridad</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Values in texts</source>
        <translation>Valores en textos</translation>
    </message>
    <message>
        <source>On delay in seconds</source>
        <translation>Retardo a la conexión en segundos</translation>
    </message>
    <message>
        <source>Off delay in seconds</source>
        <translation>Retardo a la desconexión en segundos</translation>
    </message>
    <message>
        <source>Must be acknowledged</source>
        <translation>Requiere acuse</translation>
    </message>
    <message>
        <source>Suppressed if</source>
        <translation>Suprimida si</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Tab page</source>
        <translation>Página de pestaña</translation>
    </message>
    <message>
        <source>Position and size</source>
        <translation>Posición y tamaño</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Bloqueado</translation>
    </message>
    <message>
        <source>Visible if</source>
        <translation>Visible si</translation>
    </message>
    <message>
        <source>Enabled if</source>
        <translation>Operable si</translation>
    </message>
    <message>
        <source>Appearance by condition</source>
        <translation>Aspecto según condición</translation>
    </message>
    <message>
        <source>Move right by</source>
        <translation>Mover a la derecha</translation>
    </message>
    <message>
        <source>Move down by</source>
        <translation>Mover hacia abajo</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Fixed language</source>
        <translation>Idioma fijo</translation>
    </message>
    <message>
        <source>If</source>
        <translation>Si</translation>
    </message>
    <message>
        <source>Blinks</source>
        <translation>Parpadea</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>Operable</translation>
    </message>
    <message>
        <source>On if</source>
        <translation>Encendido si</translation>
    </message>
    <message>
        <source>Blinks if</source>
        <translation>Parpadea si</translation>
    </message>
    <message>
        <source>Variable with [#] as index</source>
        <translation>Variable con [#] como índice</translation>
    </message>
    <message>
        <source>Editable</source>
        <translation>Editable</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Escalones</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Polyline</source>
        <translation>Polilínea</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>Rounded rectangle</source>
        <translation>Rectángulo redondeado</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polígono</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Arco</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Ángulo inicial</translation>
    </message>
    <message>
        <source>Span</source>
        <translation>Apertura</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Pipe</source>
        <translation>Tubería</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>Flow (sign gives the direction)</source>
        <translation>Caudal (el signo indica el sentido)</translation>
    </message>
    <message>
        <source>Flow colour</source>
        <translation>Color del caudal</translation>
    </message>
    <message>
        <source>Wraps</source>
        <translation>Ajuste de línea</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Símbolo</translation>
    </message>
    <message>
        <source>Running if</source>
        <translation>En marcha si</translation>
    </message>
    <message>
        <source>Warning if</source>
        <translation>Advertencia si</translation>
    </message>
    <message>
        <source>Fault if</source>
        <translation>Fallo si</translation>
    </message>
    <message>
        <source>Colour off</source>
        <translation>Color (desconectado)</translation>
    </message>
    <message>
        <source>Colour running</source>
        <translation>Color (en marcha)</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Rótulo</translation>
    </message>
    <message>
        <source>Button</source>
        <translation>Botón</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Value to write</source>
        <translation>Valor que se escribe</translation>
    </message>
    <message>
        <source>Go to panel</source>
        <translation>Ir al panel</translation>
    </message>
    <message>
        <source>Language tag</source>
        <translation>Etiqueta de idioma</translation>
    </message>
    <message>
        <source>Question to confirm</source>
        <translation>Pregunta de confirmación</translation>
    </message>
    <message>
        <source>Lit if</source>
        <translation>Iluminado si</translation>
    </message>
    <message>
        <source>Colour lit</source>
        <translation>Color (iluminado)</translation>
    </message>
    <message>
        <source>Icon</source>
        <translation>Icono</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Interruptor</translation>
    </message>
    <message>
        <source>Text on</source>
        <translation>Texto (conectado)</translation>
    </message>
    <message>
        <source>Text off</source>
        <translation>Texto (desconectado)</translation>
    </message>
    <message>
        <source>Colour on</source>
        <translation>Color (conectado)</translation>
    </message>
    <message>
        <source>Rotary selector</source>
        <translation>Selector giratorio</translation>
    </message>
    <message>
        <source>Check box</source>
        <translation>Casilla de verificación</translation>
    </message>
    <message>
        <source>Radio group</source>
        <translation>Grupo de opciones</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Columnas</translation>
    </message>
    <message>
        <source>Combo box</source>
        <translation>Cuadro combinado</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>Control deslizante</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>Show the value</source>
        <translation>Mostrar el valor</translation>
    </message>
    <message>
        <source>Rotary knob</source>
        <translation>Botón giratorio</translation>
    </message>
    <message>
        <source>Numeric entry</source>
        <translation>Entrada numérica</translation>
    </message>
    <message>
        <source>Lowest value</source>
        <translation>Valor mínimo</translation>
    </message>
    <message>
        <source>Highest value</source>
        <translation>Valor máximo</translation>
    </message>
    <message>
        <source>Title of the keypad</source>
        <translation>Título del teclado</translation>
    </message>
    <message>
        <source>Text entry</source>
        <translation>Entrada de texto</translation>
    </message>
    <message>
        <source>Longest text</source>
        <translation>Longitud máxima</translation>
    </message>
    <message>
        <source>Masked entry</source>
        <translation>Entrada con máscara</translation>
    </message>
    <message>
        <source>Mask (# digit, A letter, * any)</source>
        <translation>Máscara (# cifra, A letra, * cualquiera)</translation>
    </message>
    <message>
        <source>Hide the value</source>
        <translation>Ocultar el valor</translation>
    </message>
    <message>
        <source>Numeric display</source>
        <translation>Indicador numérico</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Marco</translation>
    </message>
    <message>
        <source>Date and time</source>
        <translation>Fecha y hora</translation>
    </message>
    <message>
        <source>Value (empty: the controller&apos;s clock)</source>
        <translation>Valor (vacío: el reloj del controlador)</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>Muestra</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Segundos</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Piloto</translation>
    </message>
    <message>
        <source>Blinks when on</source>
        <translation>Parpadea cuando está conectado</translation>
    </message>
    <message>
        <source>Multi-state indicator</source>
        <translation>Indicador de varios estados</translation>
    </message>
    <message>
        <source>States</source>
        <translation>Estados</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>Barra</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Consigna</translation>
    </message>
    <message>
        <source>Tank level</source>
        <translation>Nivel de depósito</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>Indicador de aguja</translation>
    </message>
    <message>
        <source>Span of the scale</source>
        <translation>Apertura de la escala</translation>
    </message>
    <message>
        <source>Divisions</source>
        <translation>Divisiones</translation>
    </message>
    <message>
        <source>7-segment display</source>
        <translation>Indicador de 7 segmentos</translation>
    </message>
    <message>
        <source>Digits</source>
        <translation>Cifras</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>Decimales</translation>
    </message>
    <message>
        <source>Leading zeros</source>
        <translation>Ceros a la izquierda</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Light tower</source>
        <translation>Columna luminosa</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Luces</translation>
    </message>
    <message>
        <source>Siren if</source>
        <translation>Sirena si</translation>
    </message>
    <message>
        <source>Float switch</source>
        <translation>Interruptor de flotador</translation>
    </message>
    <message>
        <source>Raised if</source>
        <translation>Elevado si</translation>
    </message>
    <message>
        <source>Colour raised</source>
        <translation>Color (elevado)</translation>
    </message>
    <message>
        <source>Colour hanging</source>
        <translation>Color (colgante)</translation>
    </message>
    <message>
        <source>Cell grid</source>
        <translation>Cuadrícula de celdas</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Array</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Filas</translation>
    </message>
    <message>
        <source>Variable of a cell with [#]</source>
        <translation>Variable de una celda con [#]</translation>
    </message>
    <message>
        <source>On press</source>
        <translation>Al pulsar</translation>
    </message>
    <message>
        <source>First index</source>
        <translation>Primer índice</translation>
    </message>
    <message>
        <source>Show the numbers</source>
        <translation>Mostrar los números</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabla</translation>
    </message>
    <message>
        <source>Index of the selected row</source>
        <translation>Índice de la fila seleccionada</translation>
    </message>
    <message>
        <source>Bar chart</source>
        <translation>Gráfico de barras</translation>
    </message>
    <message>
        <source>Text list of the bars</source>
        <translation>Lista de textos de las barras</translation>
    </message>
    <message>
        <source>XY chart</source>
        <translation>Gráfico XY</translation>
    </message>
    <message>
        <source>Array of x</source>
        <translation>Array de los valores x</translation>
    </message>
    <message>
        <source>Array of y</source>
        <translation>Array de los valores y</translation>
    </message>
    <message>
        <source>Operating point x</source>
        <translation>Punto de trabajo x</translation>
    </message>
    <message>
        <source>Operating point y</source>
        <translation>Punto de trabajo y</translation>
    </message>
    <message>
        <source>X from</source>
        <translation>X desde</translation>
    </message>
    <message>
        <source>X to</source>
        <translation>X hasta</translation>
    </message>
    <message>
        <source>Y from</source>
        <translation>Y desde</translation>
    </message>
    <message>
        <source>Y to</source>
        <translation>Y hasta</translation>
    </message>
    <message>
        <source>Title of x</source>
        <translation>Título del eje x</translation>
    </message>
    <message>
        <source>Title of y</source>
        <translation>Título del eje y</translation>
    </message>
    <message>
        <source>Trend chart</source>
        <translation>Gráfico de tendencia</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Curvas</translation>
    </message>
    <message>
        <source>Time span in seconds</source>
        <translation>Intervalo en segundos</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Leyenda</translation>
    </message>
    <message>
        <source>Alarm list</source>
        <translation>Lista de alarmas</translation>
    </message>
    <message>
        <source>Only these classes</source>
        <translation>Solo estas clases</translation>
    </message>
    <message>
        <source>Sorted by</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Acknowledge buttons</source>
        <translation>Botones de acuse</translation>
    </message>
    <message>
        <source>Alarm banner</source>
        <translation>Banner de alarmas</translation>
    </message>
    <message>
        <source>Language selector</source>
        <translation>Selector de idioma</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Estilo</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Nombres</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Pestañas</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>Index of the page</source>
        <translation>Índice de la página</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Formas</translation>
    </message>
    <message>
        <source>Text and pictures</source>
        <translation>Texto e imágenes</translation>
    </message>
    <message>
        <source>Symbols</source>
        <translation>Símbolos</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Elementos de mando</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Elementos de visualización</translation>
    </message>
    <message>
        <source>Arrays and charts</source>
        <translation>Arrays y gráficos</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>Containers</source>
        <translation>Contenedores</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometría</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Comportamiento</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Type (a block, a structure, BOOL, REAL, text)</source>
        <translation>Tipo (un bloque, una estructura, BOOL, REAL, text)</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Predeterminado</translation>
    </message>
    <message>
        <source>Faceplate</source>
        <translation>Faceplate</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Argumentos</translation>
    </message>
    <message>
        <source>Adapts to the screen by</source>
        <translation>Se adapta a la pantalla mediante</translation>
    </message>
    <message>
        <source>On a tall screen</source>
        <translation>En una pantalla vertical</translation>
    </message>
    <message>
        <source>Shown in the frame</source>
        <translation>Se muestra en el marco</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Panel to show</source>
        <translation>Panel que se muestra</translation>
    </message>
    <message>
        <source>First-out group</source>
        <translation>Grupo de primera alarma</translation>
    </message>
    <message>
        <source>Horizontal anchor</source>
        <translation>Anclaje horizontal</translation>
    </message>
    <message>
        <source>Vertical anchor</source>
        <translation>Anclaje vertical</translation>
    </message>
    <message>
        <source>Only for the roles</source>
        <translation>Solo para los roles</translation>
    </message>
    <message>
        <source>For all others</source>
        <translation>Para todos los demás</translation>
    </message>
    <message>
        <source>Writes are confirmed</source>
        <translation>Las escrituras se confirman</translation>
    </message>
    <message>
        <source>Navigation bar</source>
        <translation>Barra de navegación</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Paneles</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Usuario</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Receta</translation>
    </message>
    <message>
        <source>Alarm statistics</source>
        <translation>Estadística de alarmas</translation>
    </message>
    <message>
        <source>Hours to look back</source>
        <translation>Horas consideradas</translation>
    </message>
    <message>
        <source>Panel area</source>
        <translation>Área de panel</translation>
    </message>
    <message>
        <source>Share of the remaining space</source>
        <translation>Parte del espacio restante</translation>
    </message>
    <message>
        <source>Column span in a grid</source>
        <translation>Número de columnas en la cuadrícula</translation>
    </message>
    <message>
        <source>Closed if</source>
        <translation>Cerrado si</translation>
    </message>
    <message>
        <source>In transit if</source>
        <translation>En movimiento si</translation>
    </message>
    <message>
        <source>In manual mode if</source>
        <translation>En manual si</translation>
    </message>
    <message>
        <source>Out of service if</source>
        <translation>Fuera de servicio si</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposición</translation>
    </message>
    <message>
        <source>Columns (0: as many as fit)</source>
        <translation>Columnas (0: las que quepan)</translation>
    </message>
    <message>
        <source>Smallest column</source>
        <translation>Ancho mínimo de columna</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Separación</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>Cross-axis alignment</source>
        <translation>Alineación transversal</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>todos</translation>
    </message>
</context>
<context>
    <name>HmiChoices</name>
    <message>
        <source>Dot</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Start sign</source>
        <translation>Signo de marcha</translation>
    </message>
    <message>
        <source>Stop sign</source>
        <translation>Signo de paro</translation>
    </message>
    <message>
        <source>Pause sign</source>
        <translation>Signo de pausa</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>Signo más</translation>
    </message>
    <message>
        <source>Minus</source>
        <translation>Signo menos</translation>
    </message>
    <message>
        <source>House</source>
        <translation>Casa</translation>
    </message>
    <message>
        <source>Circular arrow</source>
        <translation>Flecha circular</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>By time</source>
        <translation>Por hora</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Continua</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Discontinua</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>De puntos</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Al principio</translation>
    </message>
    <message>
        <source>Centred</source>
        <translation>Centrado</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Al final</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contraste alto</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Flecha</translation>
    </message>
    <message>
        <source>Arc line</source>
        <translation>Línea de arco</translation>
    </message>
    <message>
        <source>Pie</source>
        <translation>Sector</translation>
    </message>
    <message>
        <source>Chord</source>
        <translation>Segmento circular</translation>
    </message>
    <message>
        <source>Show all of it</source>
        <translation>Mostrar entera</translation>
    </message>
    <message>
        <source>Fill the frame</source>
        <translation>Rellenar el marco</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Estirar</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Abajo</translation>
    </message>
    <message>
        <source>Momentary</source>
        <translation>Momentáneo</translation>
    </message>
    <message>
        <source>Toggle</source>
        <translation>Conmutar</translation>
    </message>
    <message>
        <source>Set to TRUE</source>
        <translation>Poner a TRUE</translation>
    </message>
    <message>
        <source>Set to FALSE</source>
        <translation>Poner a FALSE</translation>
    </message>
    <message>
        <source>Write a value</source>
        <translation>Escribir un valor</translation>
    </message>
    <message>
        <source>Go to a panel</source>
        <translation>Ir a un panel</translation>
    </message>
    <message>
        <source>Change the language</source>
        <translation>Cambiar el idioma</translation>
    </message>
    <message>
        <source>Acknowledge alarms</source>
        <translation>Acusar las alarmas</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Horizontal</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Date and time of day</source>
        <translation>Fecha y hora</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Calendar week</source>
        <translation>Número de semana</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Redondo</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Cuadrado</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Redondeado</translation>
    </message>
    <message>
        <source>Dished ends</source>
        <translation>Fondos abombados</translation>
    </message>
    <message>
        <source>Flat ends</source>
        <translation>Fondos planos</translation>
    </message>
    <message>
        <source>Hopper</source>
        <translation>Tolva</translation>
    </message>
    <message>
        <source>Open at the top</source>
        <translation>Abierto por arriba</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Seleccionar</translation>
    </message>
    <message>
        <source>Present alarms</source>
        <translation>Alarmas presentes</translation>
    </message>
    <message>
        <source>Alarm history</source>
        <translation>Historial de alarmas</translation>
    </message>
    <message>
        <source>By priority</source>
        <translation>Por prioridad</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Botones</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menú</translation>
    </message>
    <message>
        <source>In their own language</source>
        <translation>En su propio idioma</translation>
    </message>
    <message>
        <source>Language tags</source>
        <translation>Etiquetas de idioma</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Pump</source>
        <translation>Bomba</translation>
    </message>
    <message>
        <source>Valve</source>
        <translation>Válvula</translation>
    </message>
    <message>
        <source>Tank</source>
        <translation>Depósito</translation>
    </message>
    <message>
        <source>Silo</source>
        <translation>Silo</translation>
    </message>
    <message>
        <source>Conveyor</source>
        <translation>Cinta transportadora</translation>
    </message>
    <message>
        <source>Agitator</source>
        <translation>Agitador</translation>
    </message>
    <message>
        <source>Heater</source>
        <translation>Calefactor</translation>
    </message>
    <message>
        <source>Fan</source>
        <translation>Ventilador</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Siren</source>
        <translation>Sirena</translation>
    </message>
    <message>
        <source>Lorry</source>
        <translation>Camión</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>Vehículo</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Raised surface</source>
        <translation>Superficie en relieve</translation>
    </message>
    <message>
        <source>Sunken surface</source>
        <translation>Superficie hundida</translation>
    </message>
    <message>
        <source>Line colour</source>
        <translation>Color de línea</translation>
    </message>
    <message>
        <source>Faint line</source>
        <translation>Línea tenue</translation>
    </message>
    <message>
        <source>Text colour</source>
        <translation>Color del texto</translation>
    </message>
    <message>
        <source>Muted text</source>
        <translation>Texto atenuado</translation>
    </message>
    <message>
        <source>Button colour</source>
        <translation>Color de botón</translation>
    </message>
    <message>
        <source>Accent</source>
        <translation>Acento</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Apagado</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marcha</translation>
    </message>
    <message>
        <source>Liquid</source>
        <translation>Líquido</translation>
    </message>
    <message>
        <source>Pipe colour</source>
        <translation>Color de tubería</translation>
    </message>
    <message>
        <source>Measured value</source>
        <translation>Valor medido</translation>
    </message>
    <message>
        <source>Lit segment</source>
        <translation>Segmento encendido</translation>
    </message>
    <message>
        <source>Display glass</source>
        <translation>Cristal del indicador</translation>
    </message>
    <message>
        <source>Alarm colour</source>
        <translation>Color de alarma</translation>
    </message>
    <message>
        <source>High priority</source>
        <translation>Prioridad alta</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Advertencia</translation>
    </message>
    <message>
        <source>Low priority</source>
        <translation>Prioridad baja</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rojo</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Naranja</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Amarillo</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Verde</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Azul</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanco</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Negro</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Good state</source>
        <translation>Estado correcto</translation>
    </message>
    <message>
        <source>Curve 1</source>
        <translation>Curva 1</translation>
    </message>
    <message>
        <source>Curve 2</source>
        <translation>Curva 2</translation>
    </message>
    <message>
        <source>Curve 3</source>
        <translation>Curva 3</translation>
    </message>
    <message>
        <source>Curve 4</source>
        <translation>Curva 4</translation>
    </message>
    <message>
        <source>Curve 5</source>
        <translation>Curva 5</translation>
    </message>
    <message>
        <source>Curve 6</source>
        <translation>Curva 6</translation>
    </message>
    <message>
        <source>Curve 7</source>
        <translation>Curva 7</translation>
    </message>
    <message>
        <source>Curve 8</source>
        <translation>Curva 8</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>a BOOL</source>
        <translation>un BOOL</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texto</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>un array</translation>
    </message>
    <message>
        <source>any type</source>
        <translation>cualquier tipo</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Izquierda y derecha</translation>
    </message>
    <message>
        <source>Top and bottom</source>
        <translation>Arriba y abajo</translation>
    </message>
    <message>
        <source>Scaling to its size</source>
        <translation>Escalado a su tamaño</translation>
    </message>
    <message>
        <source>Moving what is anchored</source>
        <translation>Desplazamiento de lo anclado</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Mantener las proporciones</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Abajo</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Bloqueado</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Oculto</translation>
    </message>
    <message>
        <source>Open a panel in a window</source>
        <translation>Abrir un panel en una ventana</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Cerrar la ventana</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Volver atrás</translation>
    </message>
    <message>
        <source>Go to the start panel</source>
        <translation>Ir al panel inicial</translation>
    </message>
    <message>
        <source>Log out</source>
        <translation>Cerrar sesión</translation>
    </message>
    <message>
        <source>Shelved alarms</source>
        <translation>Alarmas aplazadas</translation>
    </message>
    <message>
        <source>Compressor</source>
        <translation>Compresor</translation>
    </message>
    <message>
        <source>Heat exchanger</source>
        <translation>Intercambiador de calor</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Centrifuge</source>
        <translation>Centrífuga</translation>
    </message>
    <message>
        <source>Control valve</source>
        <translation>Válvula de control</translation>
    </message>
    <message>
        <source>Three-way valve</source>
        <translation>Válvula de tres vías</translation>
    </message>
    <message>
        <source>Boiler</source>
        <translation>Caldera</translation>
    </message>
    <message>
        <source>Cooling tower</source>
        <translation>Torre de refrigeración</translation>
    </message>
    <message>
        <source>Filler</source>
        <translation>Llenadora</translation>
    </message>
    <message>
        <source>Carton</source>
        <translation>Caja de cartón</translation>
    </message>
    <message>
        <source>Pallet</source>
        <translation>Palé</translation>
    </message>
    <message>
        <source>Roller conveyor</source>
        <translation>Transportador de rodillos</translation>
    </message>
    <message>
        <source>Bucket elevator</source>
        <translation>Elevador de cangilones</translation>
    </message>
    <message>
        <source>Screw conveyor</source>
        <translation>Transportador de tornillo</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Mesa giratoria</translation>
    </message>
    <message>
        <source>Gantry</source>
        <translation>Pórtico</translation>
    </message>
    <message>
        <source>SCARA robot</source>
        <translation>Robot SCARA</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Pinza</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>Puerta</translation>
    </message>
    <message>
        <source>Damper</source>
        <translation>Compuerta</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Edificio</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Cuadrícula</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Fila</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Columna</translation>
    </message>
    <message>
        <source>Row if wide, column if tall</source>
        <translation>Fila si es ancho, columna si es alto</translation>
    </message>
    <message>
        <source>Filling it</source>
        <translation>Rellenar</translation>
    </message>
    <message>
        <source>Change the theme</source>
        <translation>Cambiar el tema</translation>
    </message>
    <message>
        <source>Light bulb</source>
        <translation>Bombilla</translation>
    </message>
</context>
<context>
    <name>Inside</name>
    <message>
        <source>set by {0}  {1} ({2}, task {3})</source>
        <translation>asignado por {0}  {1} ({2}, tarea {3})</translation>
    </message>
    <message>
        <source>set by {0}  {1} ({2})</source>
        <translation>asignado por {0}  {1} ({2})</translation>
    </message>
    <message>
        <source>set by code that the compiler adds ({0})</source>
        <translation>asignado por código que añade el compilador ({0})</translation>
    </message>
    <message>
        <source>written from outside</source>
        <translation>escrito desde fuera</translation>
    </message>
    <message>
        <source>written from {0}</source>
        <translation>escrito desde {0}</translation>
    </message>
    <message>
        <source>forced</source>
        <translation>forzado</translation>
    </message>
    <message>
        <source>forced from {0}</source>
        <translation>forzado desde {0}</translation>
    </message>
    <message>
        <source>put back by a reset</source>
        <translation>restablecido por un reset</translation>
    </message>
    <message>
        <source>carried over by an online change</source>
        <translation>conservado en un cambio online</translation>
    </message>
    <message>
        <source>restored from the retained values</source>
        <translation>restaurado a partir de los valores remanentes</translation>
    </message>
    <message>
        <source>its initial value</source>
        <translation>su valor inicial</translation>
    </message>
    <message>
        <source>put into the safe state when the controller stopped</source>
        <translation>puesto en estado seguro al parar el controlador</translation>
    </message>
    <message>
        <source>as recorded in the scan that was resumed from</source>
        <translation>como se grabó en el ciclo desde el que se reanudó</translation>
    </message>
    <message>
        <source>set by a statement of a test</source>
        <translation>asignado por una instrucción de una prueba</translation>
    </message>
    <message>
        <source>origin not known</source>
        <translation>origen desconocido</translation>
    </message>
    <message>
        <source>the command line</source>
        <translation>la línea de comandos</translation>
    </message>
    <message>
        <source>the studio</source>
        <translation>el estudio</translation>
    </message>
    <message>
        <source>panel {0}, {1}</source>
        <translation>el panel {0}, {1}</translation>
    </message>
    <message>
        <source>{0} (scan {1})</source>
        <translation>{0} (ciclo {1})</translation>
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
        <translation>{0}  {1} de {2} a {3}, {4}</translation>
    </message>
    <message>
        <source>{0}  {1} to {2}, {3}</source>
        <translation>{0}  {1} a {2}, {3}</translation>
    </message>
    <message>
        <source>called by {0}  {1}</source>
        <translation>llamado por {0}  {1}</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}, since {3}.</source>
        <translation>{0} es {1} en {2}, desde {3}.</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}, as it was when the recording began.</source>
        <translation>{0} es {1} en {2}, como al comenzar la grabación.</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}.</source>
        <translation>{0} es {1} en {2}.</translation>
    </message>
    <message>
        <source>It was {0}.</source>
        <translation>Valor: {0}.</translation>
    </message>
    <message>
        <source>It has its initial value.</source>
        <translation>La variable tiene su valor inicial.</translation>
    </message>
    <message>
        <source>It became {0} because</source>
        <translation>Pasó a {0} porque</translation>
    </message>
    <message>
        <source>This needed</source>
        <translation>Hizo falta</translation>
    </message>
    <message>
        <source>It needs</source>
        <translation>Hace falta</translation>
    </message>
    <message>
        <source>It stays so because</source>
        <translation>Sigue así porque</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Paso a paso</translation>
    </message>
    <message>
        <source>because</source>
        <translation>porque</translation>
    </message>
    <message>
        <source>time passed.</source>
        <translation>pasó el tiempo.</translation>
    </message>
    <message>
        <source>it was the first scan.</source>
        <translation>era el primer ciclo.</translation>
    </message>
    <message>
        <source>other variables were forced.</source>
        <translation>había otras variables forzadas.</translation>
    </message>
    <message>
        <source>{0} became {1}.</source>
        <translation>{0} pasó a {1}.</translation>
    </message>
    <message>
        <source>{0} became {1}, {2}.</source>
        <translation>{0} pasó a {1}, {2}.</translation>
    </message>
    <message>
        <source>{0} changed.</source>
        <translation>{0} cambió.</translation>
    </message>
    <message>
        <source>{0} changed, {1}.</source>
        <translation>{0} cambió, {1}.</translation>
    </message>
    <message>
        <source>{0} was {1}.</source>
        <translation>{0} era {1}.</translation>
    </message>
    <message>
        <source>{0} was {1} since {2}, {3}.</source>
        <translation>{0} era {1} desde {2}, {3}.</translation>
    </message>
    <message>
        <source>{0}   → {1}</source>
        <translation>{0}   → {1}</translation>
    </message>
    <message>
        <source>it ran because {0} was {1}</source>
        <translation>se ejecutó porque {0} era {1}</translation>
    </message>
    <message>
        <source>nothing wrote it later because {0} was {1}</source>
        <translation>nada lo escribió después porque {0} era {1}</translation>
    </message>
    <message>
        <source>a statement that would write it did not run because {0} was {1}</source>
        <translation>una instrucción que lo escribiría no se ejecutó porque {0} era {1}</translation>
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
        <translation>{0} era {1} al comenzar el ciclo</translation>
    </message>
    <message>
        <source>{0}   {1}</source>
        <translation>{0}   {1}</translation>
    </message>
    <message>
        <source>its time of {0} has elapsed</source>
        <translation>su tiempo de {0} ha transcurrido</translation>
    </message>
    <message>
        <source>it does not run</source>
        <translation>no está en marcha</translation>
    </message>
    <message>
        <source>it has run {0} of {1}, {2} to go</source>
        <translation>han transcurrido {0} de {1}, faltan {2}</translation>
    </message>
    <message>
        <source>it has counted {0} of {1}</source>
        <translation>ha contado {0} de {1}</translation>
    </message>
    <message>
        <source>No change of up to three variables makes it {0} in this scan.</source>
        <translation>Ningún cambio de hasta tres variables la hace {0} en este ciclo.</translation>
    </message>
    <message>
        <source>It would be {0} if {1}.</source>
        <translation>Sería {0} si {1}.</translation>
    </message>
    <message>
        <source>It would also be {0} if {1}.</source>
        <translation>También sería {0} si {1}.</translation>
    </message>
    <message>
        <source>{0} were {1} (it is {2})</source>
        <translation>{0} fuera {1} (es {2})</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} y {1}</translation>
    </message>
    <message>
        <source>What keeps it {0}</source>
        <translation>Lo que la mantiene en {0}</translation>
    </message>
    <message>
        <source>Note: {0}.</source>
        <translation>Nota: {0}.</translation>
    </message>
    <message>
        <source>recorded by an earlier version, which kept no journal</source>
        <translation>grabado por una versión anterior, que no llevaba diario</translation>
    </message>
    <message>
        <source>it was written to while it was halted at a breakpoint</source>
        <translation>se escribió en él mientras estaba detenido en un punto de interrupción</translation>
    </message>
    <message>
        <source>the scan did more than can be kept: only its beginning is known</source>
        <translation>el ciclo hizo más de lo que se puede conservar: solo se conoce su comienzo</translation>
    </message>
    <message>
        <source>the scan had a different result when it was run again</source>
        <translation>el ciclo dio otro resultado al repetirlo</translation>
    </message>
    <message>
        <source>it has no value in this scan: {0}</source>
        <translation>sin valor en este ciclo: {0}</translation>
    </message>
    <message>
        <source>&quot;Why not?&quot; needs a condition (BOOL), for example &quot;Main.level &gt; 80&quot;</source>
        <translation>«¿Por qué no?» necesita una condición (BOOL), por ejemplo «Main.level &gt; 80»</translation>
    </message>
    <message>
        <source>the program was not built from sources; open its project</source>
        <translation>el programa no se compiló a partir de código fuente; abra su proyecto</translation>
    </message>
    <message>
        <source>this scan is not in the recording</source>
        <translation>este ciclo no está en la grabación</translation>
    </message>
    <message>
        <source>it does not change in this recording</source>
        <translation>no cambia en esta grabación</translation>
    </message>
    <message>
        <source>nothing wrote it in this scan</source>
        <translation>nada lo escribió en este ciclo</translation>
    </message>
    <message>
        <source>no statement of the project ran in this scan</source>
        <translation>ninguna instrucción del proyecto se ejecutó en este ciclo</translation>
    </message>
    <message>
        <source>never {0}</source>
        <translation>nunca {0}</translation>
    </message>
    <message>
        <source>missing: {0}</source>
        <translation>falta: {0}</translation>
    </message>
    <message>
        <source>not run</source>
        <translation>sin ejecutar</translation>
    </message>
    <message>
        <source>run {0} {0:time|times}</source>
        <translation>ejecutado {0} {0:vez|veces}</translation>
    </message>
</context>
<context>
    <name>LongTask</name>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>Loops</name>
    <message>
        <source>The program has no controller block; name the signals with --input and --output</source>
        <translation>El programa no tiene ningún bloque regulador; indique las señales con --input y --output</translation>
    </message>
    <message>
        <source>There is no loop {0}; the program has {1}</source>
        <translation>No hay ningún lazo {0}; el programa tiene {1}</translation>
    </message>
    <message>
        <source>{0} is the name of several loops; give the whole name of one: {1}</source>
        <translation>Varios lazos se llaman {0}; indique el nombre completo de uno: {1}</translation>
    </message>
    <message>
        <source>The recording contains no program that knows it; choose a loop of the open program</source>
        <translation>La grabación no contiene ningún programa que la conozca; elija un lazo del programa abierto</translation>
    </message>
    <message>
        <source>It is not a number and cannot be a signal of a loop; name a variable of type REAL or INT</source>
        <translation>No es un número y no puede ser una señal de un lazo; indique una variable de tipo REAL o INT</translation>
    </message>
    <message>
        <source>This range is no longer recorded, or the program was changed in it; choose another one</source>
        <translation>Este tramo ya no está grabado, o el programa se cambió en él; elija otro</translation>
    </message>
    <message>
        <source>{0} gets an expression in the call; give the measured value a variable of its own to try settings</source>
        <translation>{0} recibe una expresión en la llamada; dé al valor medido una variable propia para probar ajustes</translation>
    </message>
    <message>
        <source>The call has constants; settings in their place can only be tried on the recording of the running controller</source>
        <translation>La llamada tiene constantes; otros ajustes en su lugar solo se pueden probar en la grabación del controlador en marcha</translation>
    </message>
</context>
<context>
    <name>MarkText</name>
    <message>
        <source>Started</source>
        <translation>Arrancado</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Parado</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecido</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Escrito</translation>
    </message>
    <message>
        <source>Forced</source>
        <translation>Forzado</translation>
    </message>
    <message>
        <source>All forces released</source>
        <translation>Todos los forzados anulados</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Forzado anulado</translation>
    </message>
    <message>
        <source>Online change</source>
        <translation>Cambio online</translation>
    </message>
    <message>
        <source>Breakpoint</source>
        <translation>Punto de interrupción</translation>
    </message>
    <message>
        <source>Retained values saved</source>
        <translation>Valores remanentes guardados</translation>
    </message>
    <message>
        <source>Retained values restored</source>
        <translation>Valores remanentes restaurados</translation>
    </message>
    <message numerus="yes">
        <source>%n scan(s) skipped: the machine was late</source>
        <translation>
            <numerusform>%n ciclo omitido: el equipo iba con retraso</numerusform>
            <numerusform>%n ciclos omitidos: el equipo iba con retraso</numerusform>
        </translation>
    </message>
    <message>
        <source>Resumed from this scan</source>
        <translation>Reanudado desde este ciclo</translation>
    </message>
</context>
<context>
    <name>Notes</name>
    <message>
        <source>first declared here</source>
        <translation>declarado aquí por primera vez</translation>
    </message>
    <message>
        <source>declared here</source>
        <translation>declarado aquí</translation>
    </message>
    <message>
        <source>the variable</source>
        <translation>la variable</translation>
    </message>
    <message>
        <source>the first program</source>
        <translation>el primer programa</translation>
    </message>
    <message>
        <source>overridden here</source>
        <translation>sobrescrito aquí</translation>
    </message>
    <message>
        <source>the first one</source>
        <translation>el primero</translation>
    </message>
    <message>
        <source>by this transition, while it is active</source>
        <translation>por esta transición, mientras está activa</translation>
    </message>
    <message>
        <source>comments nest: the next *) closes the one that begins here</source>
        <translation>los comentarios se anidan: el siguiente *) cierra el que empieza aquí</translation>
    </message>
</context>
<context>
    <name>Phrases</name>
    <message>
        <source>a name</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a label</source>
        <translation>una etiqueta</translation>
    </message>
    <message>
        <source>an operand</source>
        <translation>un operando</translation>
    </message>
    <message>
        <source>an expression</source>
        <translation>una expresión</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>un valor</translation>
    </message>
    <message>
        <source>a type</source>
        <translation>un tipo</translation>
    </message>
    <message>
        <source>an index</source>
        <translation>un índice</translation>
    </message>
    <message>
        <source>an argument</source>
        <translation>un argumento</translation>
    </message>
    <message>
        <source>an address</source>
        <translation>una dirección</translation>
    </message>
    <message>
        <source>an action</source>
        <translation>una acción</translation>
    </message>
    <message>
        <source>a CASE label</source>
        <translation>una etiqueta CASE</translation>
    </message>
    <message>
        <source>a block&apos;s name</source>
        <translation>el nombre de un bloque</translation>
    </message>
    <message>
        <source>a processor&apos;s name</source>
        <translation>el nombre de un procesador</translation>
    </message>
    <message>
        <source>a task&apos;s name</source>
        <translation>el nombre de una tarea</translation>
    </message>
    <message>
        <source>a program instance&apos;s name</source>
        <translation>el nombre de una instancia de programa</translation>
    </message>
    <message>
        <source>an input or output</source>
        <translation>una entrada o salida</translation>
    </message>
    <message>
        <source>a variable&apos;s name</source>
        <translation>el nombre de una variable</translation>
    </message>
    <message>
        <source>a variable&apos;s path</source>
        <translation>la ruta de una variable</translation>
    </message>
    <message>
        <source>a step&apos;s name</source>
        <translation>el nombre de una etapa</translation>
    </message>
    <message>
        <source>a type&apos;s name</source>
        <translation>el nombre de un tipo</translation>
    </message>
    <message>
        <source>a member&apos;s name</source>
        <translation>el nombre de un miembro</translation>
    </message>
    <message>
        <source>an access name</source>
        <translation>un nombre de acceso</translation>
    </message>
    <message>
        <source>an enumeration value</source>
        <translation>un valor de enumeración</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>el final de la línea</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>el final del archivo</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} o {1}</translation>
    </message>
    <message>
        <source>FOR and a time</source>
        <translation>FOR y un tiempo</translation>
    </message>
    <message>
        <source>:= or instructions</source>
        <translation>:= o instrucciones</translation>
    </message>
    <message>
        <source>a subrange</source>
        <translation>un subrango</translation>
    </message>
    <message>
        <source>an enumeration</source>
        <translation>una enumeración</translation>
    </message>
    <message>
        <source>in parentheses</source>
        <translation>entre paréntesis</translation>
    </message>
    <message>
        <source>a chart</source>
        <translation>una secuencia (SFC)</translation>
    </message>
    <message>
        <source>a body</source>
        <translation>un cuerpo</translation>
    </message>
    <message>
        <source>in a CLASS</source>
        <translation>en una CLASS</translation>
    </message>
    <message>
        <source>in a FUNCTION</source>
        <translation>en una FUNCTION</translation>
    </message>
    <message>
        <source>in a METHOD</source>
        <translation>en un METHOD</translation>
    </message>
    <message>
        <source>in a PROGRAM</source>
        <translation>en un PROGRAM</translation>
    </message>
    <message>
        <source>in a FUNCTION_BLOCK</source>
        <translation>en un FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>here</source>
        <translation>aquí</translation>
    </message>
    <message>
        <source>{0} {0:character|characters}</source>
        <translation>{0} {0:carácter|caracteres}</translation>
    </message>
    <message>
        <source>{0} {0:byte|bytes} in UTF-8</source>
        <translation>{0} {0:byte|bytes} en UTF-8</translation>
    </message>
    <message>
        <source>in {0}</source>
        <translation>en {0}</translation>
    </message>
    <message>
        <source>in an expression</source>
        <translation>en una expresión</translation>
    </message>
    <message>
        <source>in an initial value</source>
        <translation>en un valor inicial</translation>
    </message>
    <message>
        <source>in this section</source>
        <translation>en esta sección</translation>
    </message>
    <message>
        <source>an initial value</source>
        <translation>un valor inicial</translation>
    </message>
    <message>
        <source>RETURN with a value</source>
        <translation>RETURN con un valor</translation>
    </message>
    <message>
        <source>in a declaration that calls FB_Init</source>
        <translation>en una declaración que llama a FB_Init</translation>
    </message>
    <message>
        <source>{0} (VAR_IN_OUT)</source>
        <translation>{0} (VAR_IN_OUT)</translation>
    </message>
    <message>
        <source>in {0}, which is not abstract itself</source>
        <translation>en {0}, que no es abstracto</translation>
    </message>
    <message>
        <source>address</source>
        <translation>dirección</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>duración</translation>
    </message>
    <message>
        <source>date</source>
        <translation>fecha</translation>
    </message>
    <message>
        <source>time of day</source>
        <translation>hora del día</translation>
    </message>
    <message>
        <source>date and time</source>
        <translation>fecha y hora</translation>
    </message>
    <message>
        <source>integer</source>
        <translation>entero</translation>
    </message>
    <message>
        <source>string</source>
        <translation>cadena</translation>
    </message>
    <message>
        <source>{0} (a constant)</source>
        <translation>{0} (una constante)</translation>
    </message>
    <message>
        <source>{0} (an output)</source>
        <translation>{0} (una salida)</translation>
    </message>
    <message>
        <source>{0} (a local variable of {1})</source>
        <translation>{0} (una variable local de {1})</translation>
    </message>
    <message>
        <source>{0} (an input)</source>
        <translation>{0} (una entrada)</translation>
    </message>
    <message>
        <source>{0} (an input; the next scan overwrites it)</source>
        <translation>{0} (una entrada; el próximo ciclo la sobrescribe)</translation>
    </message>
    <message>
        <source>{0} (a property without SET)</source>
        <translation>{0} (una propiedad sin SET)</translation>
    </message>
    <message>
        <source>{0} (no instance, or several)</source>
        <translation>{0} (ninguna instancia, o varias)</translation>
    </message>
    <message>
        <source>{0} (a type; declare an instance of it)</source>
        <translation>{0} (un tipo; declare una instancia)</translation>
    </message>
    <message>
        <source>{0} (a variable, which hides the function of this name)</source>
        <translation>{0} (una variable que oculta la función del mismo nombre)</translation>
    </message>
    <message>
        <source>an output</source>
        <translation>una salida</translation>
    </message>
    <message>
        <source>an input</source>
        <translation>una entrada</translation>
    </message>
    <message>
        <source>an IN_OUT parameter</source>
        <translation>un parámetro IN_OUT</translation>
    </message>
    <message>
        <source>a power of a computed number</source>
        <translation>una potencia de un número calculado</translation>
    </message>
    <message>
        <source>a call of {0}</source>
        <translation>una llamada a {0}</translation>
    </message>
    <message>
        <source>a call without arguments</source>
        <translation>una llamada sin argumentos</translation>
    </message>
    <message>
        <source>a computed second argument of {0}</source>
        <translation>un segundo argumento calculado de {0}</translation>
    </message>
    <message>
        <source>{0} outside a loop</source>
        <translation>{0} fuera de un bucle</translation>
    </message>
    <message>
        <source>this statement</source>
        <translation>esta instrucción</translation>
    </message>
    <message>
        <source>FOR with this end or step</source>
        <translation>FOR con este final o paso</translation>
    </message>
    <message>
        <source>an assignment of several variables</source>
        <translation>una asignación de varias variables</translation>
    </message>
    <message>
        <source>CASE of a computed value</source>
        <translation>CASE de un valor calculado</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texto</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>un entero</translation>
    </message>
    <message>
        <source>a number of seconds</source>
        <translation>un número de segundos</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>una lista</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objeto</translation>
    </message>
    <message>
        <source>one of {0}</source>
        <translation>uno de {0}</translation>
    </message>
</context>
<context>
    <name>PlotText</name>
    <message>
        <source>no longer kept</source>
        <translation>ya no se conserva</translation>
    </message>
    <message>
        <source>did not exist</source>
        <translation>no existía</translation>
    </message>
    <message>
        <source>scans skipped</source>
        <translation>ciclos omitidos</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>no grabado</translation>
    </message>
    <message>
        <source>Time [%1]</source>
        <translation>Tiempo [%1]</translation>
    </message>
    <message>
        <source>Time from the trigger [%1]</source>
        <translation>Tiempo desde el disparo [%1]</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Canal</translation>
    </message>
    <message>
        <source>At A</source>
        <translation>En A</translation>
    </message>
    <message>
        <source>At B</source>
        <translation>En B</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Mín</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Máx</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Valor eficaz</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>Tiempo de subida</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Sobreoscilación</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Tiempo de establecimiento</translation>
    </message>
</context>
<context>
    <name>Remote</name>
    <message>
        <source>The request is not understood; studio and controller may be of different versions</source>
        <translation>No se entiende la solicitud; el estudio y el controlador pueden ser de versiones distintas</translation>
    </message>
    <message>
        <source>There is no request {0}; studio and controller may be of different versions</source>
        <translation>No existe la solicitud {0}; el estudio y el controlador pueden ser de versiones distintas</translation>
    </message>
    <message>
        <source>Breakpoints stop a machine in the middle of a scan; `stepwise serve` allows them with --allow-breakpoints</source>
        <translation>Los puntos de interrupción detienen una máquina en medio de un ciclo; «stepwise serve» los permite con --allow-breakpoints</translation>
    </message>
    <message>
        <source>{0} is forced; release it before writing</source>
        <translation>{0} está forzada; anule el forzado antes de escribir</translation>
    </message>
    <message>
        <source>{0} is not forced; there is nothing to release</source>
        <translation>{0} no está forzado; no hay forzado que anular</translation>
    </message>
    <message>
        <source>Another program is being built for this controller; try again when it is loaded</source>
        <translation>Se está compilando otro programa para este controlador; inténtelo de nuevo cuando esté cargado</translation>
    </message>
    <message>
        <source>The program has {0} {0:error|errors}; correct them: the controller continues with the old program until then</source>
        <translation>El programa tiene {0} {0:error|errores}; corríjalos: hasta entonces, el controlador sigue con el anterior</translation>
    </message>
    <message>
        <source>The controller&apos;s program has no file {0}; load its program again</source>
        <translation>El programa del controlador no tiene el archivo {0}; vuelva a cargar su programa</translation>
    </message>
    <message>
        <source>A recording is already being downloaded; wait until it is complete</source>
        <translation>Ya se está descargando una grabación; espere a que esté completa</translation>
    </message>
    <message>
        <source>A served controller cannot be resumed from an earlier scan; download its recording and resume from there</source>
        <translation>Un controlador que funciona como servicio no se puede reanudar desde un ciclo anterior; descargue su grabación y reanude desde ahí</translation>
    </message>
    <message>
        <source>{0} is not the address of a controller; write for example https://plant:8443/</source>
        <translation>{0} no es la dirección de un controlador; escriba por ejemplo https://plant:8443/</translation>
    </message>
    <message>
        <source>{0} rejects the connection: {1}</source>
        <translation>{0} rechaza la conexión: {1}</translation>
    </message>
    <message>
        <source>The code is wrong; it is in the file attach-code of the controller&apos;s state folder</source>
        <translation>El código es incorrecto; está en el archivo attach-code de la carpeta de estado del controlador</translation>
    </message>
    <message>
        <source>There were too many wrong codes from this computer; wait a minute</source>
        <translation>Hubo demasiados códigos incorrectos desde este equipo; espere un minuto</translation>
    </message>
    <message>
        <source>The code would be sent over the network unencrypted; use an https address, and start the controller with --certificate</source>
        <translation>El código se enviaría por la red sin cifrar; use una dirección https e inicie el controlador con --certificate</translation>
    </message>
    <message>
        <source>The certificate of {0} is not trusted: {1}; name the file of the certificate that you trust</source>
        <translation>El certificado de {0} no es de confianza: {1}; indique el archivo del certificado en el que confía</translation>
    </message>
    <message>
        <source>The certificate cannot be read from {0}; it must be a PEM file</source>
        <translation>No se puede leer el certificado de {0}; debe ser un archivo PEM</translation>
    </message>
    <message>
        <source>The connection to {0} is lost; check the network and the controller</source>
        <translation>Se ha perdido la conexión con {0}; compruebe la red y el controlador</translation>
    </message>
    <message>
        <source>{0} does not answer; check the address and whether the controller runs</source>
        <translation>{0} no responde; compruebe la dirección y que el controlador esté en marcha</translation>
    </message>
    <message>
        <source>The controller&apos;s program cannot be built here as it is there; use the same version of Stepwise on both sides</source>
        <translation>El programa del controlador no se puede compilar aquí como allí; use la misma versión de Stepwise en ambos lados</translation>
    </message>
    <message>
        <source>{0} speaks TLS on this port; use the address {1}</source>
        <translation>{0} usa TLS en este puerto; use la dirección {1}</translation>
    </message>
    <message>
        <source>{0} cannot be reached: {1}; check the address and the network</source>
        <translation>No se puede acceder a {0}: {1}; compruebe la dirección y la red</translation>
    </message>
    <message>
        <source>Nothing answers at {0}; check the port, and whether `stepwise serve` runs there</source>
        <translation>Nada responde en {0}; compruebe el puerto y si «stepwise serve» se está ejecutando allí</translation>
    </message>
    <message>
        <source>There is no computer named {0}; check the name in the address</source>
        <translation>No hay ningún equipo llamado {0}; compruebe el nombre en la dirección</translation>
    </message>
    <message>
        <source>The server at {0} is not a controller started with `stepwise serve`; check the host and the port</source>
        <translation>El servidor en {0} no es un controlador iniciado con «stepwise serve»; compruebe el equipo y el puerto</translation>
    </message>
    <message>
        <source>The server at {0} does not speak TLS; start the controller with --certificate, or use an http address on the same computer</source>
        <translation>El servidor en {0} no habla TLS; inicie el controlador con --certificate o use una dirección http en el mismo equipo</translation>
    </message>
</context>
<context>
    <name>Storage</name>
    <message>
        <source>{0} does not have the character {1}; write the file as UTF-8</source>
        <translation>{0} no contiene el carácter {1}; escriba el archivo en UTF-8</translation>
    </message>
    <message>
        <source>The encoding {0} is not known; choose one of {1}</source>
        <translation>La codificación {0} no se conoce; elija una de {1}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a list of names; write them in quotes, in square brackets</source>
        <translation>«{0}» debe ser una lista de nombres; escríbalos entre comillas y entre corchetes</translation>
    </message>
</context>
<context>
    <name>TraceText</name>
    <message>
        <source>Triggered at %1.</source>
        <translation>Disparo en %1.</translation>
    </message>
    <message>
        <source>The trigger did not fire.</source>
        <translation>El disparo no se ha producido.</translation>
    </message>
</context>
<context>
    <name>Tuning</name>
    <message>
        <source>{0} {0:sample is|samples are} too few for a model; record for longer</source>
        <translation>{0} {0:muestra no basta|muestras no bastan} para un modelo; grabe durante más tiempo</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>utilizable</translation>
    </message>
    <message>
        <source>the input is at a limit for {0} % of the time</source>
        <translation>la entrada está en un límite el {0}&#xa0;% del tiempo</translation>
    </message>
    <message>
        <source>the output moves by only {0} times its noise</source>
        <translation>la salida solo se mueve {0} veces su ruido</translation>
    </message>
    <message>
        <source>too short: {0} {0:sample|samples} until the next change or the end</source>
        <translation>demasiado corto: {0} {0:muestra|muestras} hasta el cambio siguiente o el final</translation>
    </message>
    <message>
        <source>disturbed: no model explains more than {0} % of it</source>
        <translation>perturbado: ningún modelo explica más del {0}&#xa0;%</translation>
    </message>
    <message>
        <source>usable; not at rest before it</source>
        <translation>utilizable; no estaba en reposo antes</translation>
    </message>
    <message>
        <source>There is no step or disturbance in the recording; change the set point or the output once and record the response</source>
        <translation>No hay ningún escalón ni perturbación en la grabación; cambie una vez la consigna o la salida y grabe la respuesta</translation>
    </message>
    <message>
        <source>None of the {0} changes found is usable: {1}</source>
        <translation>Ninguno de los {0} cambios encontrados es utilizable: {1}</translation>
    </message>
    <message>
        <source>No model explains the output; something else affects it</source>
        <translation>Ningún modelo explica la salida; algo más influye en ella</translation>
    </message>
    <message>
        <source>The rule {0} does not apply to this process; choose another one</source>
        <translation>La regla {0} no es aplicable a este proceso; elija otra</translation>
    </message>
    <message>
        <source>Unstable: the oscillation would grow. Do not use these settings.</source>
        <translation>Inestable: la oscilación aumentaría. No use estos ajustes.</translation>
    </message>
    <message>
        <source>Fragile: a small change of the process makes it oscillate.</source>
        <translation>Frágil: un pequeño cambio del proceso lo hace oscilar.</translation>
    </message>
    <message>
        <source>Brisk: fast, with slight oscillation; the process should not change much.</source>
        <translation>Ágil: rápido, con una ligera oscilación; el proceso no debería cambiar mucho.</translation>
    </message>
    <message>
        <source>Good: fast enough, and tolerant of the usual process changes.</source>
        <translation>Bueno: suficientemente rápido y tolera los cambios habituales de un proceso.</translation>
    </message>
    <message>
        <source>Calm: slow, and tolerant of large process changes.</source>
        <translation>Tranquilo: lento y tolera un proceso que cambia mucho.</translation>
    </message>
    <message>
        <source>A step of the set point does not overshoot.</source>
        <translation>Un escalón de la consigna no produce sobreoscilación.</translation>
    </message>
    <message>
        <source>A step of the set point overshoots by {0} %.</source>
        <translation>Un escalón de la consigna produce una sobreoscilación del {0}&#xa0;%.</translation>
    </message>
    <message>
        <source>Ziegler-Nichols is included for comparison: it oscillates and tolerates little change. Use SIMC or the optimum instead.</source>
        <translation>Ziegler-Nichols está aquí para comparar: oscila y tolera pocos cambios. Use en su lugar SIMC o el óptimo.</translation>
    </message>
    <message>
        <source>The rule considers only one lag; check the margins.</source>
        <translation>La regla solo considera una constante de tiempo; compruebe los márgenes.</translation>
    </message>
    <message>
        <source>gain and dead time</source>
        <translation>ganancia y tiempo muerto</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>primer orden</translation>
    </message>
    <message>
        <source>first order with dead time</source>
        <translation>primer orden con tiempo muerto</translation>
    </message>
    <message>
        <source>second order</source>
        <translation>segundo orden</translation>
    </message>
    <message>
        <source>second order with dead time</source>
        <translation>segundo orden con tiempo muerto</translation>
    </message>
    <message>
        <source>two equal lags</source>
        <translation>dos constantes de tiempo iguales</translation>
    </message>
    <message>
        <source>two equal lags with dead time</source>
        <translation>dos constantes de tiempo iguales con tiempo muerto</translation>
    </message>
    <message>
        <source>oscillating</source>
        <translation>oscilante</translation>
    </message>
    <message>
        <source>oscillating with dead time</source>
        <translation>oscilante con tiempo muerto</translation>
    </message>
    <message>
        <source>oscillating with a lag</source>
        <translation>oscilante con una constante de tiempo</translation>
    </message>
    <message>
        <source>second order with a zero</source>
        <translation>segundo orden con un cero</translation>
    </message>
    <message>
        <source>second order with a zero and dead time</source>
        <translation>segundo orden con un cero y tiempo muerto</translation>
    </message>
    <message>
        <source>three equal lags</source>
        <translation>tres constantes de tiempo iguales</translation>
    </message>
    <message>
        <source>three equal lags with a zero</source>
        <translation>tres constantes de tiempo iguales con un cero</translation>
    </message>
    <message>
        <source>four equal lags</source>
        <translation>cuatro constantes de tiempo iguales</translation>
    </message>
    <message>
        <source>five equal lags</source>
        <translation>cinco constantes de tiempo iguales</translation>
    </message>
    <message>
        <source>six equal lags</source>
        <translation>seis constantes de tiempo iguales</translation>
    </message>
    <message>
        <source>seven equal lags</source>
        <translation>siete constantes de tiempo iguales</translation>
    </message>
    <message>
        <source>eight equal lags</source>
        <translation>ocho constantes de tiempo iguales</translation>
    </message>
    <message>
        <source>three equal lags with dead time</source>
        <translation>tres constantes de tiempo iguales con tiempo muerto</translation>
    </message>
    <message>
        <source>three lags</source>
        <translation>tres constantes de tiempo</translation>
    </message>
    <message>
        <source>three lags with dead time</source>
        <translation>tres constantes de tiempo con tiempo muerto</translation>
    </message>
    <message>
        <source>four lags</source>
        <translation>cuatro constantes de tiempo</translation>
    </message>
    <message>
        <source>integrating</source>
        <translation>integrador</translation>
    </message>
    <message>
        <source>integrating with dead time</source>
        <translation>integrador con tiempo muerto</translation>
    </message>
    <message>
        <source>integrating with a lag</source>
        <translation>integrador con una constante de tiempo</translation>
    </message>
    <message>
        <source>integrating with a lag and dead time</source>
        <translation>integrador con una constante de tiempo y tiempo muerto</translation>
    </message>
    <message>
        <source>integrating with two equal lags</source>
        <translation>integrador con dos constantes de tiempo iguales</translation>
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
        <translation>Óptimo</translation>
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
        <translation>la grabación tiene un hueco ahí</translation>
    </message>
    <message>
        <source>It oscillates with a period of {0} s and an amplitude of {1}, for {2} cycles in a row.</source>
        <translation>Oscila con un período de {0}&#xa0;s y una amplitud de {1}, durante {2} períodos seguidos.</translation>
    </message>
    <message>
        <source>It does not oscillate.</source>
        <translation>No oscila.</translation>
    </message>
    <message>
        <source>The settings are the likely cause: with the model, the loop oscillates with this period.</source>
        <translation>Los ajustes son la causa probable: con el modelo, el lazo oscila con este período.</translation>
    </message>
    <message>
        <source>A sticking valve or an external disturbance is the likely cause; the recording cannot tell them apart. Switch the controller to manual: if the oscillation stops, the valve sticks; if it continues, the cause is external.</source>
        <translation>La causa probable es una válvula que se atasca o una perturbación externa; la grabación no permite distinguirlas. Pase el regulador a manual: si la oscilación cesa, la válvula se atasca; si continúa, la causa es externa.</translation>
    </message>
    <message>
        <source>The likely cause is external: neither the settings nor a sticking valve explains it.</source>
        <translation>La causa probable es externa: ni los ajustes ni una válvula que se atasca lo explican.</translation>
    </message>
    <message>
        <source>The output is at a limit for {0} % of the time.</source>
        <translation>La salida está en un límite el {0}&#xa0;% del tiempo.</translation>
    </message>
    <message>
        <source>{0} % of what the measured value does is noise.</source>
        <translation>El {0}&#xa0;% de la variación del valor medido es ruido.</translation>
    </message>
    <message>
        <source>the output did not respond: the controller was not active</source>
        <translation>la salida no respondió: el regulador no estaba activo</translation>
    </message>
    <message>
        <source>too short: not at rest again before the next change</source>
        <translation>demasiado corto: no se estabilizó antes del cambio siguiente</translation>
    </message>
    <message>
        <source>The recording has {0} {0:disturbance|disturbances}, but no step that a model can be made from; change the set point or the output once and record the response</source>
        <translation>La grabación tiene {0} {0:perturbación|perturbaciones}, pero ningún escalón del que obtener un modelo; cambie una vez la consigna o la salida y grabe la respuesta</translation>
    </message>
    <message>
        <source>Change {0} is a disturbance: its cause is not known, so no model can be made from it; choose a change of the set point or of the output</source>
        <translation>El cambio {0} es una perturbación: su causa es desconocida, por lo que no da un modelo; elija un cambio de la consigna o de la salida</translation>
    </message>
    <message>
        <source>the measured value is at the end of its range for {0} % of the time</source>
        <translation>el valor medido está en el extremo de su rango durante el {0}&#xa0;% del tiempo</translation>
    </message>
    <message>
        <source>{0}, controlled by {1}</source>
        <translation>{0}, regulado por {1}</translation>
    </message>
    <message>
        <source>Changes in the recording</source>
        <translation>Cambios en la grabación</translation>
    </message>
    <message>
        <source>{0} found, {1} used for the model</source>
        <translation>{0} encontrados, {1} usados para el modelo</translation>
    </message>
    <message>
        <source>… and {0} more</source>
        <translation>… y {0} más</translation>
    </message>
    <message>
        <source>No model: {0}</source>
        <translation>Sin modelo: {0}</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>{0}, explains {1} %</source>
        <translation>{0}, explica el {1}&#xa0;%</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Parameters by {0}</source>
        <translation>Parámetros según {0}</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>grabado</translation>
    </message>
    <message>
        <source>output at a limit</source>
        <translation>salida en un límite</translation>
    </message>
    <message>
        <source>mean absolute error</source>
        <translation>error absoluto medio</translation>
    </message>
    <message>
        <source>integrated absolute error</source>
        <translation>integral del error absoluto</translation>
    </message>
    <message>
        <source>movements of the output in an hour</source>
        <translation>movimientos de la salida por hora</translation>
    </message>
    <message>
        <source>noise of the measured value</source>
        <translation>ruido del valor medido</translation>
    </message>
    <message>
        <source>at [s]</source>
        <translation>en [s]</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>variación</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>valoración</translation>
    </message>
    <message>
        <source>output</source>
        <translation>salida</translation>
    </message>
    <message>
        <source>set point</source>
        <translation>consigna</translation>
    </message>
    <message>
        <source>disturbance</source>
        <translation>perturbación</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>ganancia</translation>
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
        <translation>margen de ganancia</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>margen de fase</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>sobreoscilación</translation>
    </message>
    <message>
        <source>settling time [s]</source>
        <translation>tiempo de establecimiento [s]</translation>
    </message>
    <message>
        <source>error after a load step</source>
        <translation>error tras un escalón de carga</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>inestable</translation>
    </message>
    <message>
        <source>now</source>
        <translation>ahora</translation>
    </message>
    <message>
        <source>Recorded and modelled</source>
        <translation>Grabado y modelado</translation>
    </message>
    <message>
        <source>Step of the set point by 1</source>
        <translation>Escalón de consigna de 1</translation>
    </message>
    <message>
        <source>Step of the load by 1</source>
        <translation>Escalón de carga de 1</translation>
    </message>
    <message>
        <source>Bode plot</source>
        <translation>Diagrama de Bode</translation>
    </message>
    <message>
        <source>Set point and measured value</source>
        <translation>Consigna y valor medido</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Salida</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>tiempo [s]</translation>
    </message>
    <message>
        <source>magnitude [dB]</source>
        <translation>magnitud [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>fase [°]</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>frecuencia [rad/s]</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modelo</translation>
    </message>
    <message>
        <source>loop now</source>
        <translation>lazo actual</translation>
    </message>
    <message>
        <source>loop, {0}</source>
        <translation>lazo, {0}</translation>
    </message>
    <message>
        <source>process</source>
        <translation>proceso</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>medido</translation>
    </message>
    <message>
        <source>gain {0} ± {1}</source>
        <translation>ganancia {0} ± {1}</translation>
    </message>
    <message>
        <source>lag {0} s ± {1} s</source>
        <translation>constante de tiempo {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>frequency {0} rad/s ± {1} rad/s</source>
        <translation>frecuencia {0}&#xa0;rad/s ± {1}&#xa0;rad/s</translation>
    </message>
    <message>
        <source>damping {0} ± {1}</source>
        <translation>amortiguamiento {0} ± {1}</translation>
    </message>
    <message>
        <source>zero {0} s ± {1} s</source>
        <translation>cero {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>dead time {0} s ± {1} s</source>
        <translation>tiempo muerto {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>The gain is {0} upwards and {1} downwards; settings are made for {2}.</source>
        <translation>La ganancia es {0} al subir y {1} al bajar; los ajustes se calculan para {2}.</translation>
    </message>
    <message>
        <source>The gain depends on the operating point: it is {0} where the measured value is about {1}, and {2} about {3}; settings are made for {4}. For one range alone, choose its steps only.</source>
        <translation>La ganancia depende del punto de trabajo: es {0} donde el valor medido ronda {1}, y {2} alrededor de {3}; los ajustes se calculan para {4}. Para un solo rango, elija solo sus escalones.</translation>
    </message>
    <message>
        <source>usable; the output was set to its limit</source>
        <translation>utilizable; la salida se puso en su límite</translation>
    </message>
    <message>
        <source>Loop health</source>
        <translation>Estado del lazo</translation>
    </message>
    <message>
        <source>It explains {0} % of the steps it was not fitted to.</source>
        <translation>Explica el {0}&#xa0;% de los escalones a los que no se ajustó.</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residuos</translation>
    </message>
    <message>
        <source>The controller output and the measured value are the same in every sample; choose another measured value</source>
        <translation>La salida del regulador y el valor medido son iguales en todas las muestras; elija otro valor medido</translation>
    </message>
    <message>
        <source>A sticking valve is the likely cause: the output moves evenly, but the process responds in jumps. Check it with the controller in manual: the oscillation then stops; if it continues, the cause is external.</source>
        <translation>Una válvula que se atasca es la causa probable: la salida se mueve de forma uniforme y el proceso responde a saltos. Compruébelo con el regulador en manual: la oscilación cesa; si continúa, la causa es externa.</translation>
    </message>
</context>
<context>
    <name>Waveform</name>
    <message>
        <source>The table has no column of times; name one time_s (seconds) or time_ms</source>
        <translation>La tabla no tiene columna de tiempos; llame a una time_s (segundos) o time_ms</translation>
    </message>
    <message>
        <source>The table has no column {0}; it has {1}</source>
        <translation>La tabla no tiene columna {0}; tiene {1}</translation>
    </message>
    <message>
        <source>The table has no column {0}; did you mean {1}?</source>
        <translation>La tabla no tiene columna {0}; ¿quería decir {1}?</translation>
    </message>
    <message>
        <source>Line {0} has no number in column {1}; correct or remove the line</source>
        <translation>La línea {0} no tiene ningún número en la columna {1}; corrija o quite la línea</translation>
    </message>
    <message>
        <source>The time in line {0} is before that of the line above; sort the lines by time</source>
        <translation>El tiempo de la línea {0} es anterior al de la línea de arriba; ordene las líneas por tiempo</translation>
    </message>
    <message>
        <source>The table has no column of numbers besides the time; add one with a heading</source>
        <translation>La tabla no tiene ninguna columna de números aparte del tiempo; añada una con encabezado</translation>
    </message>
    <message>
        <source>The table has no rows below its headings; write one row per sample</source>
        <translation>La tabla no tiene filas bajo sus encabezados; escriba una fila por muestra</translation>
    </message>
    <message>
        <source>The table cannot be shown as a recording: {0}</source>
        <translation>La tabla no se puede mostrar como grabación: {0}</translation>
    </message>
    <message>
        <source>the names of its columns cannot be variables; use letters, digits and underscores</source>
        <translation>los nombres de sus columnas no pueden ser variables; use letras, cifras y guiones bajos</translation>
    </message>
    <message>
        <source>{0} {0:sample is|samples are} too few for a spectrum; show a longer section</source>
        <translation>{0} {0:muestra no basta|muestras no bastan} para un espectro; muestre un tramo más largo</translation>
    </message>
    <message>
        <source>{0} {0:sample is|samples are} too few for a frequency response; show a longer section</source>
        <translation>{0} {0:muestra no basta|muestras no bastan} para una respuesta en frecuencia; muestre un tramo más largo</translation>
    </message>
    <message>
        <source>The input does not change here, so there is no response; show another section</source>
        <translation>La entrada no varía aquí, por lo que no hay respuesta; muestre otro tramo</translation>
    </message>
    <message>
        <source>{0} needs a closing parenthesis at the end; it must enclose the whole expression</source>
        <translation>{0} necesita un paréntesis de cierre al final; debe rodear toda la expresión</translation>
    </message>
    <message>
        <source>{0} needs a time above 0 as its second argument, for example {1}</source>
        <translation>{0} necesita un tiempo mayor que 0 como segundo argumento, por ejemplo {1}</translation>
    </message>
    <message>
        <source>{0} takes one expression; remove the others</source>
        <translation>{0} admite una sola expresión; quite las demás</translation>
    </message>
    <message>
        <source>The file is not a table; a recording of Stepwise ends with .rec</source>
        <translation>El archivo no es una tabla; una grabación de Stepwise termina en .rec</translation>
    </message>
    <message>
        <source>Column {0}: {1} {1:cell is not a number|cells are not numbers}, the first ({2}) in line {3}; the value above it is kept</source>
        <translation>Columna {0}: {1} {1:celda no es un número|celdas no son números}, la primera ({2}) en la línea {3}; se conserva el valor anterior</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} fewer cells than the header, the first in line {1}; the values above are kept</source>
        <translation>{0} {0:fila tiene|filas tienen} menos celdas que la cabecera, la primera en la línea {1}; se conservan los valores anteriores</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} more cells than the header, the first in line {1}; the surplus cells are ignored. Put numbers with a decimal comma in quotes</source>
        <translation>{0} {0:fila tiene|filas tienen} más celdas que la cabecera, la primera en la línea {1}; las celdas sobrantes se ignoran. Ponga entre comillas los números con coma</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} the same time as the row above, the first in line {1}; {0:it is|they are} left out</source>
        <translation>{0} {0:fila tiene|filas tienen} el mismo tiempo que la fila anterior, la primera en la línea {1}; se {0:omite|omiten}</translation>
    </message>
    <message>
        <source>Line {0} is not a sample of a variable: it needs a time and a value</source>
        <translation>La línea {0} no es una muestra de una variable: necesita un tiempo y un valor</translation>
    </message>
    <message>
        <source>The trace cannot be read as XML: {0}; save it again</source>
        <translation>La traza no se puede leer como XML: {0}; guárdela de nuevo</translation>
    </message>
    <message>
        <source>{0} has {1} {1:value|values} but {2} {2:time|times}; save the trace again</source>
        <translation>{0} tiene {1} {1:valor|valores} pero {2} {2:tiempo|tiempos}; guarde la traza de nuevo</translation>
    </message>
    <message>
        <source>The times of {0} run backwards; save the trace again</source>
        <translation>Los tiempos de {0} van hacia atrás; guarde la traza de nuevo</translation>
    </message>
    <message>
        <source>The file is empty; export the table again</source>
        <translation>El archivo está vacío; vuelva a exportar la tabla</translation>
    </message>
    <message>
        <source>The table has {0} columns {1}; give each its own heading</source>
        <translation>La tabla tiene {0} columnas {1}; dé a cada una su propio encabezado</translation>
    </message>
    <message>
        <source>Column {0} has no numbers; choose one of {1}</source>
        <translation>La columna {0} no tiene números; elija una de {1}</translation>
    </message>
</context>
<context>
    <name>plc::app::AttachDialog</name>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Código</translation>
    </message>
    <message>
        <source>Attach to a Controller</source>
        <translation>Conectar con un controlador</translation>
    </message>
    <message>
        <source>from the file attach-code of the controller</source>
        <translation>del archivo attach-code del controlador</translation>
    </message>
    <message>
        <source>only for certificates that this computer does not know</source>
        <translation>solo para certificados que este equipo no conoce</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose a certificate</source>
        <translation>Elegir un certificado</translation>
    </message>
    <message>
        <source>Trusted certificate</source>
        <translation>Certificado de confianza</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>Conectar</translation>
    </message>
    <message>
        <source>Choose a Certificate</source>
        <translation>Elegir un certificado</translation>
    </message>
    <message>
        <source>Certificates (*.pem *.crt *.cer);;All files (*)</source>
        <translation>Certificados (*.pem *.crt *.cer);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Attaching…</source>
        <translation>Conectando…</translation>
    </message>
</context>
<context>
    <name>plc::app::Attachment</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Desconectar</translation>
    </message>
    <message>
        <source>Attached to %1</source>
        <translation>Conectado con %1</translation>
    </message>
    <message>
        <source>Attached to %1; its program is not the one that is open here</source>
        <translation>Conectado con %1; su programa no es el que está abierto aquí</translation>
    </message>
    <message>
        <source>Connection to %1 lost – reconnecting…</source>
        <translation>Conexión con %1 perdida – reconectando…</translation>
    </message>
    <message>
        <source>Attaching to %1…</source>
        <translation>Conectando con %1…</translation>
    </message>
    <message>
        <source>The controller runs remotely; values written and forced here take effect there</source>
        <translation>El controlador se ejecuta de forma remota; los valores escritos y forzados aquí actúan allí</translation>
    </message>
</context>
<context>
    <name>plc::app::ConversionDialog</name>
    <message>
        <source>%1 as ST</source>
        <translation>%1 en ST</translation>
    </message>
    <message>
        <source>%1 as an Instruction List</source>
        <translation>%1 en lista de instrucciones</translation>
    </message>
    <message>
        <source>Instruction list (current text)</source>
        <translation>Lista de instrucciones (texto actual)</translation>
    </message>
    <message>
        <source>ST (current text)</source>
        <translation>ST (texto actual)</translation>
    </message>
    <message>
        <source>The same as ST</source>
        <translation>Lo mismo en ST</translation>
    </message>
    <message>
        <source>The same as an instruction list</source>
        <translation>Lo mismo en lista de instrucciones</translation>
    </message>
    <message>
        <source>Both give the same results. Replacing can be undone in one step; comments are kept, each above its statement.</source>
        <translation>Ambos dan los mismos resultados. El reemplazo se puede deshacer en un solo paso; los comentarios se quedan, cada uno sobre su instrucción.</translation>
    </message>
    <message>
        <source>Replace the Text</source>
        <translation>Reemplazar el texto</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
</context>
<context>
    <name>plc::app::DesignPages</name>
    <message>
        <source>Texts</source>
        <translation>Textos</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recetas</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Usuarios y permisos</translation>
    </message>
    <message>
        <source>New Panel</source>
        <translation>Panel nuevo</translation>
    </message>
    <message>
        <source>Name of the panel:</source>
        <translation>Nombre del panel:</translation>
    </message>
    <message>
        <source>overview</source>
        <translation>vista_general</translation>
    </message>
    <message>
        <source>A panel&apos;s name cannot contain / or \; choose another name</source>
        <translation>El nombre de un panel no puede contener / ni \; elija otro nombre</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>%1 was changed. Save it?</source>
        <translation>%1 ha cambiado. ¿Guardarlo?</translation>
    </message>
</context>
<context>
    <name>plc::app::DevicesView</name>
    <message>
        <source>off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>conectando</translation>
    </message>
    <message>
        <source>online</source>
        <translation>en línea</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdido</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bueno</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>nada todavía</translation>
    </message>
    <message>
        <source>refused by the device</source>
        <translation>rechazado por el dispositivo</translation>
    </message>
    <message>
        <source>does not fit</source>
        <translation>no cabe</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Dispositivos</translation>
    </message>
    <message>
        <source>Device or channel</source>
        <translation>Dispositivo o canal</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Traffic</source>
        <translation>Tráfico</translation>
    </message>
    <message>
        <source>Fields of the device or channel</source>
        <translation>Campos del dispositivo o canal</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Campo</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Contenido</translation>
    </message>
    <message>
        <source>Connect or disconnect the devices</source>
        <translation>Conectar o desconectar los dispositivos</translation>
    </message>
    <message>
        <source>Add a device</source>
        <translation>Añadir un dispositivo</translation>
    </message>
    <message>
        <source>This project has no devices yet. A device (Modbus, MQTT) brings values from outside into variables and takes values of variables out.</source>
        <translation>Este proyecto aún no tiene dispositivos. Un dispositivo (Modbus, MQTT) trae valores del exterior a variables y lleva valores de variables al exterior.</translation>
    </message>
    <message>
        <source>Modbus TCP device</source>
        <translation>Dispositivo Modbus TCP</translation>
    </message>
    <message>
        <source>Modbus RTU device (serial)</source>
        <translation>Dispositivo Modbus RTU (serie)</translation>
    </message>
    <message>
        <source>Modbus TCP server</source>
        <translation>Servidor Modbus TCP</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>Bróker MQTT</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Añadir un canal</translation>
    </message>
    <message>
        <source>Delete the device or channel</source>
        <translation>Eliminar el dispositivo o canal</translation>
    </message>
    <message>
        <source>Propose addresses for channels without a variable</source>
        <translation>Proponer direcciones para los canales sin variable</translation>
    </message>
    <message>
        <source>Undo the last change of the devices</source>
        <translation>Deshacer el último cambio de los dispositivos</translation>
    </message>
    <message>
        <source>Every channel has a variable</source>
        <translation>Todos los canales tienen una variable</translation>
    </message>
    <message numerus="yes">
        <source>%n address(es) proposed</source>
        <translation>
            <numerusform>%n dirección propuesta</numerusform>
            <numerusform>%n direcciones propuestas</numerusform>
        </translation>
    </message>
    <message>
        <source>not enabled</source>
        <translation>no habilitado</translation>
    </message>
    <message>
        <source>%1 requests, %2 errors, %3 ms</source>
        <translation>%1 solicitudes, %2 errores, %3&#xa0;ms</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>no conectado</translation>
    </message>
    <message>
        <source>online: %1 of %2</source>
        <translation>en línea: %1 de %2</translation>
    </message>
    <message>
        <source>“%1” in devices.json</source>
        <translation>«%1» en devices.json</translation>
    </message>
</context>
<context>
    <name>plc::app::EditorTabs</name>
    <message>
        <source>Documents</source>
        <translation>Documentos</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close Others</source>
        <translation>Cerrar los demás</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>%1 was changed. Save it?</source>
        <translation>%1 ha cambiado. ¿Guardarlo?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were changed: %1. Save them?</source>
        <translation>
            <numerusform>%n archivo ha cambiado: %1. ¿Guardarlo?</numerusform>
            <numerusform>%n archivos han cambiado: %1. ¿Guardarlos?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s); those edited since stay as they are</source>
        <translation>
            <numerusform>Cambiado en %n archivo; los editados después se quedan como están</numerusform>
            <numerusform>Cambiado en %n archivos; los editados después se quedan como están</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s)</source>
        <translation>
            <numerusform>Cambiado en %n archivo</numerusform>
            <numerusform>Cambiado en %n archivos</numerusform>
        </translation>
    </message>
    <message>
        <source>Read-only file</source>
        <translation>Archivo de solo lectura</translation>
    </message>
    <message>
        <source>%1 is read-only. Replace it anyway? It stays read-only.</source>
        <translation>%1 es de solo lectura. ¿Reemplazarlo de todos modos? Seguirá siendo de solo lectura.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>%1 was not saved</source>
        <translation>%1 no se ha guardado</translation>
    </message>
    <message>
        <source>%1 is not a variable of the running program; check the name, or press F5 to build the program</source>
        <translation>%1 no es una variable del programa en marcha; compruebe el nombre o compile el programa con F5</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Forzar</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Escribir</translation>
    </message>
</context>
<context>
    <name>plc::app::ExplanationDialog</name>
    <message>
        <source>Explanation</source>
        <translation>Explicación</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <extracomment>an example&apos;s line, then what is wrong there</extracomment>
        <translation>Línea %1: %2</translation>
    </message>
    <message>
        <source>What %1 Means</source>
        <translation>Qué significa %1</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Incorrecto</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Correcto</translation>
    </message>
    <message>
        <source>Put the cursor on a problem, or choose one in the list, and press F1 again</source>
        <translation>Coloque el cursor sobre un problema o elija uno en la lista y vuelva a pulsar F1</translation>
    </message>
    <message>
        <source>There is no page for %1; choose a code from the list</source>
        <translation>No hay ninguna página para %1; elija un código de la lista</translation>
    </message>
</context>
<context>
    <name>plc::app::ExportDialog</name>
    <message>
        <source>Export the Project</source>
        <translation>Exportar el proyecto</translation>
    </message>
    <message>
        <source>PLCopen XML 0200, for CODESYS and TwinCAT</source>
        <translation>PLCopen XML 0200, para CODESYS y TwinCAT</translation>
    </message>
    <message>
        <source>PLCopen XML 0201, for Beremiz and OpenPLC</source>
        <translation>PLCopen XML 0201, para Beremiz y OpenPLC</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Archivo…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Format:</source>
        <translation>Formato:</translation>
    </message>
    <message>
        <source>To:</source>
        <translation>A:</translation>
    </message>
    <message>
        <source>This file exists and will be replaced</source>
        <translation>Este archivo existe y se reemplazará</translation>
    </message>
</context>
<context>
    <name>plc::app::FileCommands</name>
    <message>
        <source>New Trace</source>
        <translation>Traza nueva</translation>
    </message>
    <message>
        <source>Name of the trace:</source>
        <translation>Nombre de la traza:</translation>
    </message>
    <message>
        <source>trace</source>
        <translation>traza</translation>
    </message>
    <message>
        <source>A file name cannot contain / or \; choose another name</source>
        <translation>Un nombre de archivo no puede contener / ni \; elija otro nombre</translation>
    </message>
    <message>
        <source>A trace %1 already exists; choose another name</source>
        <translation>Ya existe una traza %1; elija otro nombre</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>New name of %1:</source>
        <translation>Nombre nuevo de %1:</translation>
    </message>
    <message>
        <source>A file %1 already exists; choose another name</source>
        <translation>Ya existe un archivo %1; elija otro nombre</translation>
    </message>
    <message>
        <source>The file cannot be renamed; check the permissions of the folder</source>
        <translation>No se puede renombrar el archivo; compruebe los permisos de la carpeta</translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>¿Eliminar %1?</translation>
    </message>
    <message>
        <source>It contains %1.</source>
        <translation>Contiene %1.</translation>
    </message>
    <message>
        <source>These panels link to it; their buttons will be reported as errors: %1</source>
        <translation>Estos paneles llevan a él; sus botones se notificarán como errores: %1</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>The file cannot be removed; check the permissions of the folder</source>
        <translation>No se puede eliminar el archivo; compruebe los permisos de la carpeta</translation>
    </message>
</context>
<context>
    <name>plc::app::GuideView</name>
    <message>
        <source>About this project</source>
        <translation>Acerca de este proyecto</translation>
    </message>
    <message>
        <source>A README.md in the project&apos;s folder is shown here.</source>
        <translation>Aquí se muestra un README.md de la carpeta del proyecto.</translation>
    </message>
</context>
<context>
    <name>plc::app::ImportDialog</name>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>Objects: %1
Bodies: %2
Not kept: %3</source>
        <translation>Objetos: %1
Cuerpos: %2
No conservados: %3</translation>
    </message>
    <message>
        <source>Import a Project</source>
        <translation>Importar un proyecto</translation>
    </message>
    <message>
        <source>PLCopen XML, TwinCAT or CODESYS files, structured text</source>
        <translation>PLCopen XML, archivos de TwinCAT o CODESYS, texto estructurado</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Archivo…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Carpeta…</translation>
    </message>
    <message>
        <source>Source files</source>
        <translation>Archivos fuente</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>From:</source>
        <translation>Desde:</translation>
    </message>
    <message>
        <source>New project in:</source>
        <translation>Proyecto nuevo en:</translation>
    </message>
    <message>
        <source>Projects of other tools (%1)</source>
        <translation>Proyectos de otras herramientas (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>This folder is not empty; name a new one</source>
        <translation>Esta carpeta no está vacía; indique una nueva</translation>
    </message>
    <message>
        <source>program units</source>
        <translation>POU</translation>
    </message>
    <message>
        <source>data types</source>
        <translation>tipos de datos</translation>
    </message>
    <message>
        <source>global variable lists</source>
        <translation>listas de variables globales</translation>
    </message>
    <message>
        <source>configurations</source>
        <translation>configuraciones</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>textos</translation>
    </message>
    <message>
        <source>files</source>
        <translation>archivos</translation>
    </message>
    <message>
        <source>PLCopen XML, TwinCAT, CODESYS, ST</source>
        <translation>PLCopen XML, TwinCAT, CODESYS, ST</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Leyendo %1…</translation>
    </message>
    <message>
        <source>Becomes a separate project with the libraries it uses</source>
        <translation>Pasa a ser un proyecto propio, con las bibliotecas que usa</translation>
    </message>
    <message>
        <source>Writing the project…</source>
        <translation>Escribiendo el proyecto…</translation>
    </message>
    <message>
        <source>Encoding:</source>
        <translation>Codificación:</translation>
    </message>
    <message>
        <source>Recognised</source>
        <translation>Reconocida</translation>
    </message>
    <message>
        <source>For files that are not in Unicode and do not specify their encoding</source>
        <translation>Para archivos que no están en Unicode y no declaran su codificación</translation>
    </message>
</context>
<context>
    <name>plc::app::InsideViews</name>
    <message>
        <source>Coverage of the latest %1 of %2 recorded scans</source>
        <translation>Cobertura de los %1 ciclos más recientes de %2 grabados</translation>
    </message>
    <message>
        <source>There is no recording yet: run the program first.</source>
        <translation>Aún no hay ninguna grabación: ejecute primero el programa.</translation>
    </message>
    <message>
        <source>Put the cursor on a variable, or select an expression, to ask about it</source>
        <translation>Ponga el cursor en una variable o seleccione una expresión para preguntar por ella</translation>
    </message>
</context>
<context>
    <name>plc::app::InstanceBar</name>
    <message>
        <source>Instance whose values are shown</source>
        <translation>Instancia cuyos valores se muestran</translation>
    </message>
    <message>
        <source>Values of the instance of %1:</source>
        <translation>Valores de la instancia de %1:</translation>
    </message>
</context>
<context>
    <name>plc::app::LiveViews</name>
    <message>
        <source>Panel shown</source>
        <translation>Panel que se muestra</translation>
    </message>
    <message>
        <source>Full screen (Esc to exit)</source>
        <translation>Pantalla completa (Esc para salir)</translation>
    </message>
    <message>
        <source>This project has no panel yet.
To draw one, right-click Panels in the project tree and choose New.</source>
        <translation>Este proyecto aún no tiene paneles.
Para dibujar uno, haga clic derecho en Paneles en el árbol del proyecto y elija Nuevo.</translation>
    </message>
    <message>
        <source>No panel can be read: %1.
Problems says what is wrong; a double click there opens the file as text.</source>
        <translation>No se puede leer ningún panel: %1.
En Problemas se indica qué falla; un doble clic allí abre el archivo como texto.</translation>
    </message>
    <message>
        <source>The alarm history is kept in memory only: %1</source>
        <translation>El historial de alarmas solo se conserva en memoria: %1</translation>
    </message>
    <message>
        <source>Saving the recording…</source>
        <translation>Guardando la grabación…</translation>
    </message>
    <message>
        <source>Export the alarm history…</source>
        <translation>Exportar el historial de alarmas…</translation>
    </message>
    <message>
        <source>Export the Alarm History</source>
        <translation>Exportar el historial de alarmas</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
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
        <translation>Proyecto</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Supervisión</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Forzados</translation>
    </message>
    <message>
        <source>Call Stack</source>
        <translation>Pila de llamadas</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>Puntos de interrupción</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Búsqueda</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tareas</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Traza</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Recent Projects</source>
        <translation>Proyectos recientes</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Barra de herramientas</translation>
    </message>
    <message>
        <source>State of the controller</source>
        <translation>Estado del controlador</translation>
    </message>
    <message>
        <source>%1 : %2</source>
        <translation>%1: %2</translation>
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
        <translation>PAUSA</translation>
    </message>
    <message>
        <source>HALT</source>
        <translation>DETENIDO</translation>
    </message>
    <message>
        <source>FAULT</source>
        <translation>ERROR</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>PAST</source>
        <translation>PASADO</translation>
    </message>
    <message>
        <source>%1 · scan %2</source>
        <translation>%1 · ciclo %2</translation>
    </message>
    <message>
        <source>%1 µs · %2 % load</source>
        <translation>%1&#xa0;µs · carga del %2&#xa0;%</translation>
    </message>
    <message>
        <source>%1 MB recorded</source>
        <translation>%1&#xa0;MB grabados</translation>
    </message>
    <message>
        <source>%1 scans of %2 MB at most</source>
        <translation>%1 ciclos, %2&#xa0;MB como máximo</translation>
    </message>
    <message>
        <source>Go to the line</source>
        <translation>Ir a la línea</translation>
    </message>
    <message>
        <source>no problems</source>
        <translation>sin problemas</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Abrir proyecto</translation>
    </message>
    <message>
        <source>%1 – Stepwise</source>
        <translation>%1 – Stepwise</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Recuperación</translation>
    </message>
    <message>
        <source>Stepwise was closed without saving. Unsaved changes to %1 were kept. Restore them?</source>
        <translation>Stepwise se cerró sin guardar. Se conservaron los cambios sin guardar de %1. ¿Restaurarlos?</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliotecas</translation>
    </message>
    <message>
        <source>Running tests…</source>
        <translation>Ejecutando las pruebas…</translation>
    </message>
    <message>
        <source>passed: %1</source>
        <translation>superada: %1</translation>
    </message>
    <message>
        <source>FAILED: %1</source>
        <translation>FALLIDA: %1</translation>
    </message>
    <message>
        <source>%1 passed, %2 failed</source>
        <translation>%1 superadas, %2 fallidas</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Tiempo real</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>Lo más rápido posible</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Grabación</translation>
    </message>
    <message>
        <source>Memory for the recording of every scan [MB]:</source>
        <translation>Memoria para la grabación de cada ciclo [MB]:</translation>
    </message>
    <message>
        <source>Save the Recording</source>
        <translation>Guardar la grabación</translation>
    </message>
    <message>
        <source>Recordings (*.rec)</source>
        <translation>Grabaciones (*.rec)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Guardado: %1</translation>
    </message>
    <message>
        <source>About Stepwise</source>
        <translation>Acerca de Stepwise</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bienvenida</translation>
    </message>
    <message>
        <source>The project</source>
        <translation>El proyecto</translation>
    </message>
    <message>
        <source>Programs, blocks, tasks, panels, traces and tests, made from the text files in the folder.</source>
        <translation>Programas, bloques, tareas, paneles, trazas y pruebas, a partir de los archivos de texto de la carpeta.</translation>
    </message>
    <message>
        <source>The program</source>
        <translation>El programa</translation>
    </message>
    <message>
        <source>Structured Text with semantic highlighting. Errors are underlined as you type; Alt+Enter offers quick fixes; Ctrl+Space completes.</source>
        <translation>Texto estructurado con resaltado semántico. Los errores se subrayan al escribir; Alt+Intro ofrece correcciones rápidas; Control+Espacio completa.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecutar</translation>
    </message>
    <message>
        <source>F5 compiles to native code and runs it. Values then appear next to each line.</source>
        <translation>F5 compila a código nativo y lo ejecuta. Los valores aparecen entonces junto a cada línea.</translation>
    </message>
    <message>
        <source>Any expression, at any moment. Prepare a value and write or force it with one click.</source>
        <translation>Cualquier expresión, en cualquier momento. Prepare un valor y escríbalo o fuércelo con un clic.</translation>
    </message>
    <message>
        <source>The trace</source>
        <translation>La traza</translation>
    </message>
    <message>
        <source>Nothing has to be selected in advance: every scan is recorded, and any expression can be charted afterwards.</source>
        <translation>No hay que elegir nada de antemano: cada ciclo queda grabado, y después se puede hacer un gráfico de cualquier expresión.</translation>
    </message>
    <message>
        <source>The panel</source>
        <translation>El panel</translation>
    </message>
    <message>
        <source>What the operator sees, in the languages of the machine. It works here as it will on the machine.</source>
        <translation>Lo que ve el operador, en los idiomas de la máquina. Aquí funciona igual que en la máquina.</translation>
    </message>
    <message>
        <source>Time runs backwards, too</source>
        <translation>El tiempo también corre hacia atrás</translation>
    </message>
    <message>
        <source>That’s it</source>
        <translation>Eso es todo</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P finds every command. The start page has more machines to play with.</source>
        <translation>Control+Mayúsculas+P encuentra cualquier comando. La página de inicio tiene más máquinas para probar.</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>Proyecto nuevo…</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>Abrir proyecto…</translation>
    </message>
    <message>
        <source>Close Project</source>
        <translation>Cerrar proyecto</translation>
    </message>
    <message>
        <source>New Program, Block, Type…</source>
        <translation>Añadir programa, bloque, tipo…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>New Panel…</source>
        <translation>Panel nuevo…</translation>
    </message>
    <message>
        <source>Panel Texts</source>
        <translation>Textos de los paneles</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Guardar todo</translation>
    </message>
    <message>
        <source>Close Document</source>
        <translation>Cerrar documento</translation>
    </message>
    <message>
        <source>Libraries…</source>
        <translation>Bibliotecas…</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Ajustes…</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Edición</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>Buscar…</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Reemplazar…</translation>
    </message>
    <message>
        <source>Find Next</source>
        <translation>Buscar siguiente</translation>
    </message>
    <message>
        <source>Find Previous</source>
        <translation>Buscar anterior</translation>
    </message>
    <message>
        <source>Find in All Files…</source>
        <translation>Buscar en todos los archivos…</translation>
    </message>
    <message>
        <source>Go to Line…</source>
        <translation>Ir a la línea…</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Ir a la definición</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Buscar referencias</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renombrar…</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Completar</translation>
    </message>
    <message>
        <source>Quick Fix (Alt+Enter)</source>
        <translation>Corrección rápida (Alt+Intro)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Dar formato</translation>
    </message>
    <message>
        <source>Toggle Comment (Ctrl+/)</source>
        <translation>Comentar o descomentar (Control+/)</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar la línea</translation>
    </message>
    <message>
        <source>Select Enclosing Block</source>
        <translation>Seleccionar el bloque contenedor</translation>
    </message>
    <message>
        <source>Go to Matching Keyword</source>
        <translation>Ir a la palabra clave correspondiente</translation>
    </message>
    <message>
        <source>Next Problem</source>
        <translation>Problema siguiente</translation>
    </message>
    <message>
        <source>Previous Problem</source>
        <translation>Problema anterior</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Adelante</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Compilar</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Single Scan</source>
        <translation>Un solo ciclo</translation>
    </message>
    <message>
        <source>Step Into</source>
        <translation>Paso a paso por instrucciones</translation>
    </message>
    <message>
        <source>Step Over</source>
        <translation>Paso a paso por procedimientos</translation>
    </message>
    <message>
        <source>Step Out</source>
        <translation>Paso a paso para salir</translation>
    </message>
    <message>
        <source>Run to Cursor</source>
        <translation>Ejecutar hasta el cursor</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Alternar punto de interrupción</translation>
    </message>
    <message>
        <source>Reset Warm</source>
        <translation>Reset en caliente</translation>
    </message>
    <message>
        <source>Reset Cold</source>
        <translation>Reset en frío</translation>
    </message>
    <message>
        <source>Reset Origin</source>
        <translation>Reset de origen</translation>
    </message>
    <message>
        <source>Online Change</source>
        <translation>Cambio online</translation>
    </message>
    <message>
        <source>Speed…</source>
        <translation>Velocidad…</translation>
    </message>
    <message>
        <source>Memory for the Recording…</source>
        <translation>Memoria para la grabación…</translation>
    </message>
    <message>
        <source>Save the Recording…</source>
        <translation>Guardar la grabación…</translation>
    </message>
    <message>
        <source>Write Prepared Values</source>
        <translation>Escribir los valores preparados</translation>
    </message>
    <message>
        <source>Force Prepared Values</source>
        <translation>Forzar los valores preparados</translation>
    </message>
    <message>
        <source>Release All Forces</source>
        <translation>Anular todos los forzados</translation>
    </message>
    <message>
        <source>Run the Tests</source>
        <translation>Ejecutar las pruebas</translation>
    </message>
    <message>
        <source>One Scan Back</source>
        <translation>Un ciclo atrás</translation>
    </message>
    <message>
        <source>One Scan Forward</source>
        <translation>Un ciclo adelante</translation>
    </message>
    <message>
        <source>Back to Live</source>
        <translation>Volver al directo</translation>
    </message>
    <message>
        <source>Resume from Here</source>
        <translation>Reanudar desde aquí</translation>
    </message>
    <message>
        <source>Command Palette</source>
        <translation>Paleta de comandos</translation>
    </message>
    <message>
        <source>Split the Editor</source>
        <translation>Dividir el editor</translation>
    </message>
    <message>
        <source>Declarations as a Table</source>
        <translation>Declaraciones como tabla</translation>
    </message>
    <message>
        <source>Online Values in the Text</source>
        <translation>Valores online en el texto</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Más grande</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Más pequeño</translation>
    </message>
    <message>
        <source>Light Theme</source>
        <translation>Tema claro</translation>
    </message>
    <message>
        <source>Dark Theme</source>
        <translation>Tema oscuro</translation>
    </message>
    <message>
        <source>System Theme</source>
        <translation>Tema del sistema</translation>
    </message>
    <message>
        <source>Reset the Layout</source>
        <translation>Restablecer la disposición</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Open a Recording…</source>
        <translation>Abrir una grabación…</translation>
    </message>
    <message>
        <source>All values are from a recording file. Click to go back to the controller.</source>
        <translation>Todos los valores son de una grabación de un archivo. Un clic vuelve al controlador.</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>GRABACIÓN</translation>
    </message>
    <message>
        <source>%1 – back to live</source>
        <translation>%1 – volver al directo</translation>
    </message>
    <message>
        <source>Open a Recording</source>
        <translation>Abrir una grabación</translation>
    </message>
    <message>
        <source>Show as ST…</source>
        <translation>Mostrar como ST…</translation>
    </message>
    <message>
        <source>Show as an Instruction List…</source>
        <translation>Mostrar como lista de instrucciones…</translation>
    </message>
    <message>
        <source>New Trace…</source>
        <translation>Traza nueva…</translation>
    </message>
    <message>
        <source>The build was cancelled; everything is as it was</source>
        <translation>La compilación se ha cancelado; todo está como antes</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Pruebas</translation>
    </message>
    <message>
        <source>The tests were cancelled</source>
        <translation>Las pruebas se han cancelado</translation>
    </message>
    <message>
        <source>Cancelled: nothing was saved</source>
        <translation>Cancelado: no se ha guardado nada</translation>
    </message>
    <message>
        <source>%1 is encoded in %2 and will be saved in that encoding</source>
        <translation>%1 está codificado en %2 y se guardará con esa codificación</translation>
    </message>
    <message>
        <source>This is a copy of the example, in %1: change what you like</source>
        <translation>Esta es una copia del ejemplo, en %1: cambie lo que quiera</translation>
    </message>
    <message>
        <source>This is your copy of the example, in %1</source>
        <translation>Esta es su copia del ejemplo, en %1</translation>
    </message>
    <message>
        <source>The language changes when the tests have ended</source>
        <translation>El idioma cambia cuando terminen las pruebas</translation>
    </message>
    <message>
        <source>Controller fault</source>
        <translation>Error del controlador</translation>
    </message>
    <message>
        <source>RUN %1</source>
        <translation>RUN %1</translation>
    </message>
    <message>
        <source>at full speed</source>
        <translation>a toda velocidad</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Speed of the controller; any factor can be entered:</source>
        <translation>Velocidad del controlador; se puede escribir cualquier factor:</translation>
    </message>
    <message>
        <source>The speed is a factor from 0.001 to 10000</source>
        <translation>La velocidad es un factor de 0,001 a 10000</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importar…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>The project was exported</source>
        <translation>El proyecto se ha exportado</translation>
    </message>
    <message>
        <source>Add Next Occurrence to Selection</source>
        <translation>Seleccionar también la siguiente aparición</translation>
    </message>
    <message>
        <source>Arrange for Editing</source>
        <translation>Disposición para editar</translation>
    </message>
    <message>
        <source>Arrange for Debugging</source>
        <translation>Disposición para depurar</translation>
    </message>
    <message>
        <source>Arrange for Drawing Panels</source>
        <translation>Disposición para dibujar paneles</translation>
    </message>
    <message>
        <source>Maximise the Editor</source>
        <translation>Maximizar el editor</translation>
    </message>
    <message>
        <source>Keeping the recording of the last run…</source>
        <translation>Conservando la grabación de la última ejecución…</translation>
    </message>
    <message>
        <source>Diagram Beside the Text</source>
        <translation>Diagrama junto al texto</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>Marcador</translation>
    </message>
    <message>
        <source>Next Bookmark</source>
        <translation>Marcador siguiente</translation>
    </message>
    <message>
        <source>Previous Bookmark</source>
        <translation>Marcador anterior</translation>
    </message>
    <message>
        <source>Open Another File Beside…</source>
        <translation>Abrir otro archivo al lado…</translation>
    </message>
    <message>
        <source>About This Project</source>
        <translation>Acerca de este proyecto</translation>
    </message>
    <message>
        <source>The project has no other file</source>
        <translation>El proyecto no tiene otro archivo</translation>
    </message>
    <message>
        <source>The tour runs on an example, and none is installed: open or create a project and start the tour again</source>
        <translation>El recorrido usa un ejemplo y no hay ninguno instalado: abra o cree un proyecto e inicie el recorrido de nuevo</translation>
    </message>
    <message>
        <source>Open Another File Beside</source>
        <translation>Abrir otro archivo al lado</translation>
    </message>
    <message>
        <source>%1 Nothing can break: the plant is only a simulation. Press Next to look around for a minute, or F5 to run it straight away.</source>
        <translation>%1 No se puede romper nada: la planta es solo una simulación. Pulse Siguiente para un recorrido de un minuto, o F5 para arrancar ahora mismo.</translation>
    </message>
    <message>
        <source>This is the project %1.</source>
        <translation>Este es el proyecto %1.</translation>
    </message>
    <message>
        <source>What to press</source>
        <translation>Qué pulsar</translation>
    </message>
    <message>
        <source>The page next to the program is the project&apos;s README: what it shows, what to press, what to watch.</source>
        <translation>La página junto al programa es el README del proyecto: qué muestra, qué pulsar y qué observar.</translation>
    </message>
    <message>
        <source>What the operator sees. This project has no panel yet; new ones are drawn with the mouse.</source>
        <translation>Lo que ve el operador. Este proyecto aún no tiene ningún panel; los nuevos se dibujan con el ratón.</translation>
    </message>
    <message>
        <source>Drag the time slider, or press Alt+PgUp: code, charts and panel show the past. “Resume from Here” continues from there.</source>
        <translation>Arrastre el control de tiempo o pulse Alt+Re Pág: el código, los gráficos y el panel muestran el pasado. «Reanudar desde aquí» sigue desde ese punto.</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Sintonización</translation>
    </message>
    <message>
        <source>Walk Through the Scan</source>
        <translation>Recorrer el ciclo</translation>
    </message>
    <message>
        <source>Step Back In</source>
        <translation>Paso atrás por instrucciones</translation>
    </message>
    <message>
        <source>Step Back Over</source>
        <translation>Paso atrás por procedimientos</translation>
    </message>
    <message>
        <source>Step Back Out</source>
        <translation>Paso atrás para salir</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>¿Por qué?</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>¿Por qué no?</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>¿Quién lo asignó?</translation>
    </message>
    <message>
        <source>What If…</source>
        <translation>Y si…</translation>
    </message>
    <message>
        <source>Coverage of the Recording</source>
        <translation>Cobertura de la grabación</translation>
    </message>
    <message>
        <source>Hide the Coverage</source>
        <translation>Ocultar la cobertura</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Por qué</translation>
    </message>
    <message>
        <source>Slow Scan</source>
        <translation>Ciclo a cámara lenta</translation>
    </message>
    <message>
        <source>What if? needs a running controller: a recording from a file cannot be resumed; press F5 to run the program</source>
        <translation>«Y si» necesita un controlador en marcha: una grabación de un archivo no se puede reanudar; pulse F5 para ejecutar el programa</translation>
    </message>
    <message>
        <source>Explain the Problem</source>
        <translation>Explicar el problema</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recetas</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Usuarios y permisos</translation>
    </message>
    <message>
        <source>Connect or Disconnect the Devices</source>
        <translation>Conectar o desconectar los dispositivos</translation>
    </message>
    <message>
        <source>Hide Dock Automatically</source>
        <translation>Ocultar la ventana automáticamente</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Dispositivos</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Stepwise %1&lt;/h3&gt;&lt;p&gt;An open PLC studio: IEC 61131-3 programs as native code, every scan recorded, operator panels in many languages.&lt;/p&gt;&lt;p&gt;Licence: GPL-3.0&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Stepwise %1&lt;/h3&gt;&lt;p&gt;Un estudio de PLC abierto: programas IEC 61131-3 como código nativo, cada ciclo grabado, paneles de operador en muchos idiomas.&lt;/p&gt;&lt;p&gt;Licencia: GPL-3.0&lt;/p&gt;</translation>
    </message>
    <message>
        <source>High-Contrast Theme</source>
        <translation>Tema de alto contraste</translation>
    </message>
    <message>
        <source>Attach to a Controller…</source>
        <translation>Conectar con un controlador…</translation>
    </message>
    <message>
        <source>Detach from the Controller</source>
        <translation>Desconectar del controlador</translation>
    </message>
    <message>
        <source>Build a Native Program…</source>
        <translation>Crear un programa nativo…</translation>
    </message>
    <message>
        <source>%1 arranges the window for drawing panels</source>
        <translation>%1 organiza la ventana para dibujar paneles</translation>
    </message>
    <message>
        <source>Close Other Documents</source>
        <translation>Cerrar los demás documentos</translation>
    </message>
    <message>
        <source>Fold or Unfold the Block</source>
        <translation>Contraer o expandir el bloque</translation>
    </message>
    <message>
        <source>Fold or Unfold All</source>
        <translation>Contraer o expandir todo</translation>
    </message>
    <message>
        <source>Previous Pass of the Loop</source>
        <translation>Pasada anterior del bucle</translation>
    </message>
    <message>
        <source>Next Pass of the Loop</source>
        <translation>Pasada siguiente del bucle</translation>
    </message>
    <message>
        <source>Context Menu</source>
        <translation>Menú contextual</translation>
    </message>
    <message>
        <source>Columns…</source>
        <translation>Columnas…</translation>
    </message>
    <message>
        <source>Move Dock to the Next Side</source>
        <translation>Mover la ventana al lado siguiente</translation>
    </message>
    <message>
        <source>Float or Dock Again</source>
        <translation>Desacoplar o acoplar de nuevo</translation>
    </message>
    <message>
        <source>Next Pane</source>
        <translation>Área siguiente</translation>
    </message>
    <message>
        <source>Previous Pane</source>
        <translation>Área anterior</translation>
    </message>
    <message>
        <source>Wider Pane</source>
        <translation>Ensanchar el área</translation>
    </message>
    <message>
        <source>Narrower Pane</source>
        <translation>Estrechar el área</translation>
    </message>
    <message>
        <source>Taller Pane</source>
        <translation>Aumentar la altura del área</translation>
    </message>
    <message>
        <source>Shorter Pane</source>
        <translation>Reducir la altura del área</translation>
    </message>
    <message>
        <source>Move Document Left</source>
        <translation>Mover el documento a la izquierda</translation>
    </message>
    <message>
        <source>Move Document Right</source>
        <translation>Mover el documento a la derecha</translation>
    </message>
    <message>
        <source>Show Tooltip at the Cursor</source>
        <translation>Mostrar la información del cursor</translation>
    </message>
    <message>
        <source>There are no columns here; go to a table or a list with columns first</source>
        <translation>Aquí no hay columnas; vaya antes a una tabla o a una lista con columnas</translation>
    </message>
    <message>
        <source>Project Settings…</source>
        <translation>Ajustes del proyecto…</translation>
    </message>
    <message>
        <source>Panel Themes…</source>
        <translation>Temas de los paneles…</translation>
    </message>
</context>
<context>
    <name>plc::app::Menu</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Edición</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Go To</source>
        <translation>Ir a</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Marcadores</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Grabación</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposición</translation>
    </message>
    <message>
        <source>Docks</source>
        <translation>Ventanas</translation>
    </message>
    <message>
        <source>Folding</source>
        <translation>Contracción</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Áreas</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Buscar</translation>
    </message>
</context>
<context>
    <name>plc::app::MergeDialog</name>
    <message>
        <source>Compare %1</source>
        <translation>Comparar %1</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Take Over</source>
        <translation>Adoptar</translation>
    </message>
    <message>
        <source>Take Over All</source>
        <translation>Adoptar todo</translation>
    </message>
    <message>
        <source>Here (this text is kept)</source>
        <translation>Aquí (este texto se conserva)</translation>
    </message>
    <message>
        <source>On disk</source>
        <translation>En el disco</translation>
    </message>
    <message>
        <source>Use the Text on the Left</source>
        <translation>Usar el texto de la izquierda</translation>
    </message>
    <message>
        <source>No differences</source>
        <translation>Sin diferencias</translation>
    </message>
    <message>
        <source>Difference %1 of %2</source>
        <translation>Diferencia %1 de %2</translation>
    </message>
</context>
<context>
    <name>plc::app::NativeProgramDialog</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Crear</translation>
    </message>
    <message>
        <source>Build a Native Program</source>
        <translation>Crear un programa nativo</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Elegir el archivo</translation>
    </message>
    <message>
        <source>Native Program</source>
        <translation>Programa nativo</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>The program runs without Stepwise on a machine with Linux: its PLC code and a small runner in one file.</source>
        <translation>El programa se ejecuta sin Stepwise en una máquina con Linux: su código de PLC y un pequeño entorno de ejecución en un archivo.</translation>
    </message>
    <message>
        <source>Building…</source>
        <translation>Creando…</translation>
    </message>
    <message>
        <source>%1 is built</source>
        <translation>%1 se ha creado</translation>
    </message>
</context>
<context>
    <name>plc::app::NewProjectDialog</name>
    <message>
        <source>Empty</source>
        <translation>Vacío</translation>
    </message>
    <message>
        <source>One program in a task of 10 ms</source>
        <translation>Un programa en una tarea de 10&#xa0;ms</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Start, stop, a simulated motor and a test</source>
        <translation>Marcha, paro, un motor simulado y una prueba</translation>
    </message>
    <message>
        <source>PID loop</source>
        <translation>Lazo PID</translation>
    </message>
    <message>
        <source>A temperature loop with its plant</source>
        <translation>Un lazo de temperatura con su planta</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Secuencia</translation>
    </message>
    <message>
        <source>Fill, mix, empty as a sequential function chart</source>
        <translation>Llenar, mezclar y vaciar como SFC</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Proyecto nuevo</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Plantilla</translation>
    </message>
    <message>
        <source>My machine</source>
        <translation>Mi máquina</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Elija una carpeta</translation>
    </message>
    <message>
        <source>Folder of the project</source>
        <translation>Carpeta del proyecto</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>In folder</source>
        <translation>En la carpeta</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Crear</translation>
    </message>
    <message>
        <source>Enter a project name</source>
        <translation>Escriba un nombre de proyecto</translation>
    </message>
    <message>
        <source>%1 already exists and is not empty; choose another name</source>
        <translation>%1 ya existe y no está vacía; elija otro nombre</translation>
    </message>
    <message>
        <source>Will be created in %1</source>
        <translation>Se creará en %1</translation>
    </message>
</context>
<context>
    <name>plc::app::NewUnitDialog</name>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Function block</source>
        <translation>Bloque de función</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Función</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Estructura</translation>
    </message>
    <message>
        <source>Enumeration</source>
        <translation>Enumeración</translation>
    </message>
    <message>
        <source>Interface</source>
        <translation>Interfaz</translation>
    </message>
    <message>
        <source>Global variables</source>
        <translation>Variables globales</translation>
    </message>
    <message>
        <source>Sequential function chart</source>
        <translation>Diagrama funcional secuencial (SFC)</translation>
    </message>
    <message>
        <source>Simulation of the plant</source>
        <translation>Simulación de la planta</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Prueba</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nuevo</translation>
    </message>
    <message>
        <source>a file of its own</source>
        <translation>un archivo propio</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>In</source>
        <translation>En</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Crear</translation>
    </message>
    <message>
        <source>Enter a name</source>
        <translation>Escriba un nombre</translation>
    </message>
    <message>
        <source>A name has letters, digits and _, starts with a letter and is not a keyword</source>
        <translation>Un nombre consta de letras, cifras y _, empieza por una letra y no es una palabra clave</translation>
    </message>
    <message>
        <source>%1 already exists in the project; choose another name</source>
        <translation>%1 ya existe en el proyecto; elija otro nombre</translation>
    </message>
    <message>
        <source>A file %1 already exists: choose it, or another name</source>
        <translation>El archivo %1 ya existe: elíjalo o elija otro nombre</translation>
    </message>
    <message>
        <source>Program as a ladder diagram</source>
        <translation>Programa como esquema de contactos (LD)</translation>
    </message>
    <message>
        <source>Program as a function block diagram</source>
        <translation>Programa como diagrama de bloques (FBD)</translation>
    </message>
</context>
<context>
    <name>plc::app::PanelFiles</name>
    <message>
        <source>Texts</source>
        <translation>Textos</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>Panel %1</source>
        <translation>Panel %1</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recetas</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Usuarios y permisos</translation>
    </message>
    <message>
        <source>%1 is gone or cannot be reached: what is open stays here, and Save All writes it again</source>
        <translation>%1 ha desaparecido o no está accesible: lo abierto permanece aquí y Guardar todo lo escribe de nuevo</translation>
    </message>
</context>
<context>
    <name>plc::app::ProblemsView</name>
    <message>
        <source>Message</source>
        <translation>Mensaje</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Código</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>Show errors</source>
        <translation>Mostrar errores</translation>
    </message>
    <message>
        <source>Show warnings</source>
        <translation>Mostrar advertencias</translation>
    </message>
    <message>
        <source>Show notes</source>
        <translation>Mostrar notas</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Filter of the problem list</source>
        <translation>Filtro de la lista de problemas</translation>
    </message>
</context>
<context>
    <name>plc::app::ProjectSettingsDialog</name>
    <message>
        <source>Project Settings</source>
        <translation>Ajustes del proyecto</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Bytes: %MW1 is bytes 1 and 2 (TwinCAT)</source>
        <translation>Byte: %MW1 son los bytes 1 y 2 (TwinCAT)</translation>
    </message>
    <message>
        <source>Words: %MW1 is the second word (CODESYS)</source>
        <translation>Palabras: %MW1 es la segunda palabra (CODESYS)</translation>
    </message>
    <message>
        <source> bytes</source>
        <translation> bytes</translation>
    </message>
    <message>
        <source>None (no __NEW)</source>
        <translation>Ninguna (sin __NEW)</translation>
    </message>
    <message>
        <source>What the number of a memory address counts</source>
        <translation>Lo que cuenta el número de una dirección de memoria</translation>
    </message>
    <message>
        <source>What the bytes of STRING values stand for</source>
        <translation>Lo que representan los bytes de los valores STRING</translation>
    </message>
    <message>
        <source>What {IF defined (…)} in the sources finds, separated by commas</source>
        <translation>Lo que {IF defined (…)} encuentra en las fuentes, separado por comas</translation>
    </message>
    <message>
        <source>The part of the controller&apos;s memory that __NEW takes objects from</source>
        <translation>La parte de la memoria del controlador de la que __NEW toma objetos</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Addressing</source>
        <translation>Direccionamiento</translation>
    </message>
    <message>
        <source>Encoding of STRING</source>
        <translation>Codificación de STRING</translation>
    </message>
    <message>
        <source>Defined symbols</source>
        <translation>Símbolos definidos</translation>
    </message>
    <message>
        <source>Memory for __NEW</source>
        <translation>Memoria para __NEW</translation>
    </message>
    <message>
        <source>Date and time of the first scan</source>
        <translation>Fecha y hora del primer ciclo</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Paneles</translation>
    </message>
    <message>
        <source>The first panel</source>
        <translation>El primer panel</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Allow pictures outside the project folder</source>
        <translation>Permitir imágenes fuera de la carpeta del proyecto</translation>
    </message>
    <message>
        <source>The panel that is drawn around all others</source>
        <translation>El panel que se dibuja alrededor de todos los demás</translation>
    </message>
    <message>
        <source>A variable with the operator&apos;s language; panels read and write it</source>
        <translation>Una variable con el idioma del operador; los paneles la leen y la escriben</translation>
    </message>
    <message>
        <source>Start panel</source>
        <translation>Panel inicial</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Marco</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Fuente</translation>
    </message>
    <message>
        <source>Language variable</source>
        <translation>Variable de idioma</translation>
    </message>
    <message>
        <source>A project needs a name.</source>
        <translation>Un proyecto necesita un nombre.</translation>
    </message>
    <message>
        <source>“%1” is not a date and time; write for example DT#2026-01-31-06:00:00.</source>
        <translation>«%1» no es una fecha con hora; escriba, por ejemplo, DT#2026-01-31-06:00:00.</translation>
    </message>
</context>
<context>
    <name>plc::app::ProjectTree</name>
    <message>
        <source>Source of %1 with the Values of %2</source>
        <translation>Código fuente de %1 con los valores de %2</translation>
    </message>
    <message>
        <source>Values of Instance</source>
        <translation>Valores de la instancia</translation>
    </message>
    <message>
        <source>More: choose in the watch</source>
        <translation>Más: elegir en la supervisión</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Proyecto</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Filter of the project tree</source>
        <translation>Filtro del árbol del proyecto</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Secuencia (SFC)</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programas</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Bloques</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>Funciones</translation>
    </message>
    <message>
        <source>Types</source>
        <translation>Tipos</translation>
    </message>
    <message>
        <source>Globals</source>
        <translation>Variables globales</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tareas</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulación</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Paneles</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Textos</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Trazas</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Pruebas</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliotecas</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Nuevo…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renombrar…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Eliminar…</translation>
    </message>
    <message>
        <source>Libraries…</source>
        <translation>Bibliotecas…</translation>
    </message>
    <message>
        <source>Run Tests</source>
        <translation>Ejecutar las pruebas</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Añadir a la supervisión</translation>
    </message>
    <message>
        <source>Arrange by file</source>
        <translation>Ordenar por archivo</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recetas</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Usuarios y permisos</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Dispositivos</translation>
    </message>
    <message>
        <source>Panel Themes</source>
        <translation>Temas de los paneles</translation>
    </message>
</context>
<context>
    <name>plc::app::RenameDialog</name>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>New name of %1, in the whole project:</source>
        <translation>Nombre nuevo de %1, en todo el proyecto:</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Places that change</source>
        <translation>Lugares que cambian</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) change:</source>
        <translation>
            <numerusform>%n lugar cambia:</numerusform>
            <numerusform>%n lugares cambian:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::app::RunsMenu</name>
    <message>
        <source>Earlier Runs</source>
        <translation>Ejecuciones anteriores</translation>
    </message>
    <message>
        <source>%1, ended by a fault, %2</source>
        <translation>%1, terminada por un error, %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The last run is being written…</source>
        <translation>Escribiendo la última ejecución…</translation>
    </message>
    <message>
        <source>No run has ended yet</source>
        <translation>Aún no ha terminado ninguna ejecución</translation>
    </message>
</context>
<context>
    <name>plc::app::SearchView</name>
    <message>
        <source>Find in all files</source>
        <translation>Buscar en todos los archivos</translation>
    </message>
    <message>
        <source>Text to find in all files</source>
        <translation>Texto que buscar en todos los archivos</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Reemplazar por</translation>
    </message>
    <message>
        <source>Replacement in all files</source>
        <translation>Texto de reemplazo en todos los archivos</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>Expresión regular</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Distinguir mayúsculas</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>Reemplazar todo</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Uso</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Search results</source>
        <translation>Resultados de la búsqueda</translation>
    </message>
    <message>
        <source>Invalid regular expression: %1</source>
        <translation>Expresión regular no válida: %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n lugar</numerusform>
            <numerusform>%n lugares</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n archivo</numerusform>
            <numerusform>%n archivos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced</source>
        <translation>
            <numerusform>%n lugar reemplazado</numerusform>
            <numerusform>%n lugares reemplazados</numerusform>
        </translation>
    </message>
    <message>
        <source>declared</source>
        <translation>declarado</translation>
    </message>
    <message>
        <source>read, write</source>
        <translation>lectura, escritura</translation>
    </message>
    <message>
        <source>write</source>
        <translation>escritura</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lectura</translation>
    </message>
    <message>
        <source>%1: %2 read, %3 written</source>
        <translation>%1: %2 lecturas, %3 escrituras</translation>
    </message>
    <message>
        <source>Searching all files…</source>
        <translation>Buscando en todos los archivos…</translation>
    </message>
    <message>
        <source>Cancelled; so far: %1 in %2</source>
        <translation>Cancelado; hasta ahora: %1 en %2</translation>
    </message>
    <message>
        <source>Replacing in all files…</source>
        <translation>Reemplazando en todos los archivos…</translation>
    </message>
    <message>
        <source>Cancelled; nothing was replaced</source>
        <translation>Cancelado; no se ha reemplazado nada</translation>
    </message>
</context>
<context>
    <name>plc::app::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>General</source>
        <translation>General</translation>
    </message>
    <message>
        <source>Editor</source>
        <translation>Editor</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Atajos</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Language of the studio</source>
        <translation>Idioma del estudio</translation>
    </message>
    <message>
        <source>Indentation</source>
        <translation>Sangría</translation>
    </message>
    <message>
        <source>Write keywords in capitals while typing</source>
        <translation>Poner las palabras clave en mayúsculas al escribir</translation>
    </message>
    <message>
        <source>Close blocks with Enter (IF … END_IF)</source>
        <translation>Cerrar los bloques con Intro (IF … END_IF)</translation>
    </message>
    <message>
        <source>Show online values in the text</source>
        <translation>Mostrar valores online en el texto</translation>
    </message>
    <message>
        <source>Format when saving</source>
        <translation>Dar formato al guardar</translation>
    </message>
    <message>
        <source>Apply an online change when saving</source>
        <translation>Aplicar un cambio online al guardar</translation>
    </message>
    <message>
        <source>Memory for the recording of every scan</source>
        <translation>Memoria para la grabación de cada ciclo</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Atajo</translation>
    </message>
    <message>
        <source>Another action has the same shortcut</source>
        <translation>Otro comando tiene el mismo atajo</translation>
    </message>
    <message>
        <source>Shortcut of %1</source>
        <translation>Atajo de %1</translation>
    </message>
    <message>
        <source>Filter of the actions</source>
        <translation>Filtro de los comandos</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Valores predeterminados</translation>
    </message>
    <message>
        <source>%1 is now assigned to “%2” instead of “%3”.</source>
        <translation>%1 está ahora asignado a «%2» en lugar de «%3».</translation>
    </message>
    <message>
        <source>none is kept</source>
        <translation>no se conserva ninguna</translation>
    </message>
    <message>
        <source>Disk space for the recordings of earlier runs, per project</source>
        <translation>Espacio en disco para las grabaciones de ejecuciones anteriores, por proyecto</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Alto contraste</translation>
    </message>
</context>
<context>
    <name>plc::app::SideBars</name>
    <message>
        <source>Hide Automatically</source>
        <translation>Ocultar automáticamente</translation>
    </message>
    <message>
        <source>Keep Open</source>
        <translation>Mantener abierto</translation>
    </message>
    <message>
        <source>Hidden Docks</source>
        <translation>Ventanas ocultas</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Desacoplar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>plc::app::StPage</name>
    <message>
        <source>This file is read-only on disk. Saving asks before it replaces it.</source>
        <translation>Este archivo es de solo lectura en el disco. Al guardarlo se pregunta antes de reemplazarlo.</translation>
    </message>
    <message>
        <source>Make Writable</source>
        <translation>Quitar la protección contra escritura</translation>
    </message>
    <message>
        <source>Close this side</source>
        <translation>Cerrar este lado</translation>
    </message>
</context>
<context>
    <name>plc::app::StartPage</name>
    <message>
        <source>Write, run and watch PLC programs. Every scan is recorded; time runs backwards, too.</source>
        <translation>Escriba, ejecute y supervise programas PLC. Cada ciclo queda grabado; el tiempo también corre hacia atrás.</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Proyectos recientes</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>Proyecto nuevo…</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>Abrir proyecto…</translation>
    </message>
    <message>
        <source>Take the Tour</source>
        <translation>Hacer el recorrido</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>Examples: open one and press Run</source>
        <translation>Ejemplos: abra uno y pulse Ejecutar</translation>
    </message>
    <message>
        <source>No examples were found in:
%1

Install the examples, or set the environment variable STEPWISE_EXAMPLES to the folder that contains them, and start Stepwise again.</source>
        <translation>No se encontraron ejemplos en:
%1

Instale los ejemplos o asigne a la variable de entorno STEPWISE_EXAMPLES la carpeta que los contiene y vuelva a iniciar Stepwise.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open a Fresh Copy</source>
        <translation>Abrir una copia nueva</translation>
    </message>
</context>
<context>
    <name>plc::app::TestView</name>
    <message>
        <source>Run all tests</source>
        <translation>Ejecutar todas las pruebas</translation>
    </message>
    <message>
        <source>Run the selected tests</source>
        <translation>Ejecutar las pruebas seleccionadas</translation>
    </message>
    <message>
        <source>Run the failed tests</source>
        <translation>Ejecutar las pruebas fallidas</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Prueba</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Pruebas</translation>
    </message>
    <message>
        <source>%1 passed, %2 failed</source>
        <translation>%1 superadas, %2 fallidas</translation>
    </message>
    <message>
        <source>not run yet</source>
        <translation>aún sin ejecutar</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>superada</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fallida</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>Show the Recording of the Failure</source>
        <translation>Mostrar la grabación del fallo</translation>
    </message>
    <message>
        <source>Show what the tests cover</source>
        <translation>Mostrar lo que cubren las pruebas</translation>
    </message>
</context>
<context>
    <name>plc::app::TextPage</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Línea %1: %2</translation>
    </message>
</context>
<context>
    <name>plc::app::Tour</name>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Terminar el recorrido</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Recorrido</translation>
    </message>
</context>
<context>
    <name>plc::app::UnitCommands</name>
    <message>
        <source>The program is running. To an online change the new name is another variable: it begins with its initial value.</source>
        <translation>El programa está en ejecución. Para un cambio online, el nombre nuevo es otra variable: empieza con su valor inicial.</translation>
    </message>
    <message>
        <source>Go to Line</source>
        <translation>Ir a la línea</translation>
    </message>
    <message>
        <source>Line (1 to %1)</source>
        <translation>Línea (1 a %1)</translation>
    </message>
    <message>
        <source>Nothing is declared under this name; declare it or check the name</source>
        <translation>No hay nada declarado con este nombre; declárelo o compruébelo</translation>
    </message>
    <message>
        <source>Put the cursor into a unit that is written in ST or IL</source>
        <translation>Ponga el cursor en una POU escrita en ST o IL</translation>
    </message>
    <message>
        <source>The text has changed meanwhile</source>
        <translation>El texto ha cambiado mientras tanto</translation>
    </message>
    <message>
        <source>There is no name at the cursor; put the cursor on one</source>
        <translation>No hay ningún nombre en el cursor; ponga el cursor sobre uno</translation>
    </message>
    <message>
        <source>The project is still being checked; try again in a moment</source>
        <translation>El proyecto aún se está comprobando; vuelva a intentarlo en un momento</translation>
    </message>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s); the panels are saved, the sources not yet</source>
        <translation>
            <numerusform>%1 se llama ahora %2, en %n lugar; los paneles están guardados, el código fuente aún no</numerusform>
            <numerusform>%1 se llama ahora %2, en %n lugares; los paneles están guardados, el código fuente aún no</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s)</source>
        <translation>
            <numerusform>%1 se llama ahora %2, en %n lugar</numerusform>
            <numerusform>%1 se llama ahora %2, en %n lugares</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>¿Eliminar %1?</translation>
    </message>
    <message numerus="yes">
        <source>It is used in %n other place(s).</source>
        <translation>
            <numerusform>Se usa en %n lugar más.</numerusform>
            <numerusform>Se usa en %n lugares más.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete and Comment Out the Uses</source>
        <translation>Eliminar y comentar los usos</translation>
    </message>
    <message>
        <source>Show the Uses</source>
        <translation>Mostrar los usos</translation>
    </message>
    <message>
        <source>%1 is not a source of this project; open the project that contains it</source>
        <translation>%1 no es un archivo fuente de este proyecto; abra el proyecto que lo contiene</translation>
    </message>
</context>
<context>
    <name>plc::app::WhatIfDialog</name>
    <message>
        <source>What If?</source>
        <translation>¿Y si?</translation>
    </message>
    <message>
        <source>The controller goes back to the scan shown and continues from there with these values. The trace draws what really happened behind the new curves.</source>
        <translation>El controlador vuelve al ciclo que se muestra y sigue desde ahí con estos valores. La traza dibuja detrás lo que ocurrió en realidad.</translation>
    </message>
    <message>
        <source>A variable, such as Main.level</source>
        <translation>Una variable, por ejemplo Main.level</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>Era</translation>
    </message>
    <message>
        <source>Instead</source>
        <translation>En su lugar</translation>
    </message>
    <message>
        <source>Values to change</source>
        <translation>Valores que se cambian</translation>
    </message>
    <message>
        <source>Run from Here</source>
        <translation>Ejecutar desde aquí</translation>
    </message>
    <message>
        <source>%1 has no value in this scan; choose another variable</source>
        <translation>%1 no tiene valor en este ciclo; elija otra variable</translation>
    </message>
    <message>
        <source>Enter a different value for at least one variable</source>
        <translation>Dé otro valor al menos a una variable</translation>
    </message>
</context>
<context>
    <name>plc::editor::BreakpointView</name>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condición</translation>
    </message>
    <message>
        <source>Hit count</source>
        <translation>Número de pasos por el punto</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>Instancia</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>Puntos de interrupción</translation>
    </message>
    <message>
        <source>Remove selected</source>
        <translation>Quitar la selección</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Quitar todos</translation>
    </message>
    <message>
        <source>The running program has no code at or below this line; choose a line with a statement</source>
        <translation>El programa en marcha no tiene código en esta línea ni más abajo; elija una línea con una instrucción</translation>
    </message>
</context>
<context>
    <name>plc::editor::CallPathView</name>
    <message>
        <source>Unit</source>
        <translation>POU</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>Instancia</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Call stack</source>
        <translation>Pila de llamadas</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Values of the frame</source>
        <translation>Valores del nivel de llamada</translation>
    </message>
    <message>
        <source>This scan has run to its end: it has no call stack.</source>
        <translation>Este ciclo ha terminado: no tiene pila de llamadas.</translation>
    </message>
</context>
<context>
    <name>plc::editor::ChartView</name>
    <message>
        <source>Sequential function chart</source>
        <translation>Diagrama funcional secuencial (SFC)</translation>
    </message>
    <message>
        <source>Insert a step after it (Ins)</source>
        <translation>Insertar una etapa después (Ins)</translation>
    </message>
    <message>
        <source>Insert an alternative branch</source>
        <translation>Insertar una rama alternativa</translation>
    </message>
    <message>
        <source>Insert a simultaneous branch</source>
        <translation>Insertar una rama simultánea</translation>
    </message>
    <message>
        <source>Add an action</source>
        <translation>Añadir una acción</translation>
    </message>
    <message>
        <source>Edit name or condition (F2)</source>
        <translation>Editar el nombre o la condición (F2)</translation>
    </message>
    <message>
        <source>Delete (Del)</source>
        <translation>Eliminar (Supr)</translation>
    </message>
    <message>
        <source>The unit %1 is no longer in the text; undo the change or close this view</source>
        <translation>La POU %1 ya no está en el texto; deshaga el cambio o cierre esta vista</translation>
    </message>
    <message>
        <source>The text has errors: this is the last valid drawing</source>
        <translation>El texto tiene errores: este es el último dibujo correcto</translation>
    </message>
    <message>
        <source>Select the step from which the branch goes out</source>
        <translation>Seleccione la etapa de la que sale la rama</translation>
    </message>
    <message>
        <source>Select the transition after which the steps run at the same time</source>
        <translation>Seleccione la transición tras la que las etapas se ejecutan en paralelo</translation>
    </message>
    <message>
        <source>Select the step that gets the action</source>
        <translation>Seleccione la etapa que recibe la acción</translation>
    </message>
    <message>
        <source>Insert a Step After It</source>
        <translation>Insertar una etapa después</translation>
    </message>
    <message>
        <source>Insert an Alternative Branch</source>
        <translation>Insertar una rama alternativa</translation>
    </message>
    <message>
        <source>Insert a Simultaneous Branch</source>
        <translation>Insertar una rama simultánea</translation>
    </message>
    <message>
        <source>Add an Action</source>
        <translation>Añadir una acción</translation>
    </message>
    <message>
        <source>Set as Initial Step</source>
        <translation>Establecer como etapa inicial</translation>
    </message>
    <message>
        <source>Force the Step Active</source>
        <translation>Forzar la etapa activa</translation>
    </message>
    <message>
        <source>Release the Step</source>
        <translation>Anular el forzado de la etapa</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Alternar punto de interrupción</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>Move Left</source>
        <translation>Mover a la izquierda</translation>
    </message>
    <message>
        <source>Move Right</source>
        <translation>Mover a la derecha</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Branch to the left</source>
        <translation>Rama a la izquierda</translation>
    </message>
    <message>
        <source>Branch to the right</source>
        <translation>Rama a la derecha</translation>
    </message>
    <message>
        <source>%1 after this transition</source>
        <translation>%1 después de esta transición</translation>
    </message>
    <message>
        <source>leads to %1</source>
        <translation>lleva a %1</translation>
    </message>
    <message>
        <source>further up</source>
        <translation>más arriba</translation>
    </message>
    <message>
        <source>further down</source>
        <translation>más abajo</translation>
    </message>
    <message>
        <source>%1 in step %2</source>
        <translation>%1 en la etapa %2</translation>
    </message>
    <message>
        <source>A condition is a BOOL; add a comparison</source>
        <translation>Una condición es un BOOL; añada una comparación</translation>
    </message>
    <message>
        <source>qualifier</source>
        <translation>calificador</translation>
    </message>
    <message>
        <source>action</source>
        <translation>acción</translation>
    </message>
    <message>
        <source>To the enclosing chart (Backspace)</source>
        <translation>A la secuencia superior (Retroceso)</translation>
    </message>
    <message>
        <source>Breakpoint: stops when the step becomes active or the transition is taken (F9)</source>
        <translation>Punto de interrupción: se detiene cuando la etapa se activa o la transición se franquea (F9)</translation>
    </message>
    <message>
        <source>Force the step active</source>
        <translation>Forzar la etapa activa</translation>
    </message>
    <message>
        <source>Release the step</source>
        <translation>Anular el forzado de la etapa</translation>
    </message>
    <message>
        <source>%1 is a variable: it has no body</source>
        <translation>%1 es una variable: no tiene cuerpo</translation>
    </message>
    <message>
        <source>Select a step or a transition</source>
        <translation>Seleccione una etapa o una transición</translation>
    </message>
    <message>
        <source>Select a step</source>
        <translation>Seleccione una etapa</translation>
    </message>
    <message>
        <source>Open Its Chart or Text</source>
        <translation>Abrir su secuencia (SFC) o su texto</translation>
    </message>
    <message>
        <source>Priority…</source>
        <translation>Prioridad…</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Subir</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Bajar</translation>
    </message>
    <message>
        <source>Delete the Whole Branch</source>
        <translation>Eliminar toda la rama</translation>
    </message>
    <message>
        <source>Select what is to be copied</source>
        <translation>Seleccione lo que se va a copiar</translation>
    </message>
    <message>
        <source>Select what is to be cut</source>
        <translation>Seleccione lo que se va a cortar</translation>
    </message>
    <message>
        <source>The clipboard contains no step, action or transition; copy one first</source>
        <translation>El portapapeles no contiene ninguna etapa, acción ni transición; copie antes una</translation>
    </message>
    <message>
        <source>Select the step or transition to paste after</source>
        <translation>Seleccione la etapa o transición tras la que se pega</translation>
    </message>
    <message>
        <source>Select the transition that gets the condition</source>
        <translation>Seleccione la transición que recibe la condición</translation>
    </message>
    <message>
        <source>Start a Chart</source>
        <translation>Empezar una secuencia (SFC)</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>%1 has no chart yet. A chart starts with an initial step; more steps are inserted after it with Ins, and F2 edits names and conditions.</source>
        <translation>%1 aún no tiene secuencia (SFC). Una secuencia empieza con una etapa inicial; con Ins se insertan más etapas detrás y F2 edita nombres y condiciones.</translation>
    </message>
    <message>
        <source>%1 is not a chart: its body has statements. A chart can be started in a program or function block whose body is empty.</source>
        <translation>%1 no es una secuencia (SFC): su cuerpo tiene instrucciones. Una secuencia se puede empezar en un programa o bloque de función cuyo cuerpo esté vacío.</translation>
    </message>
</context>
<context>
    <name>plc::editor::DeclarationTable</name>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Initial value</source>
        <translation>Valor inicial</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Declarations</source>
        <translation>Declaraciones</translation>
    </message>
    <message>
        <source>Add a variable</source>
        <translation>Añadir una variable</translation>
    </message>
    <message>
        <source>Remove the selected variables</source>
        <translation>Quitar las variables seleccionadas</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Subir</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Bajar</translation>
    </message>
</context>
<context>
    <name>plc::editor::EventLog</name>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>PLC time</source>
        <translation>Tiempo del PLC</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Evento</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Eventos</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vaciar</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all rows</source>
        <translation>Copiar las filas seleccionadas, o todas</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Only faults and rejections</source>
        <translation>Solo errores y rechazos</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Filter of the events</source>
        <translation>Filtro de los eventos</translation>
    </message>
    <message>
        <source>Step: %1</source>
        <translation>Etapa: %1</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>event at file:line</comment>
        <translation>%1 en %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::FindBar</name>
    <message>
        <source>Find</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Text to find</source>
        <translation>Texto que buscar</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Reemplazar por</translation>
    </message>
    <message>
        <source>Replacement</source>
        <translation>Texto de reemplazo</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Distinguir mayúsculas</translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>Palabras completas</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>Expresión regular</translation>
    </message>
    <message>
        <source>Previous (Shift+Enter)</source>
        <translation>Anterior (Mayúsculas+Intro)</translation>
    </message>
    <message>
        <source>Next (Enter)</source>
        <translation>Siguiente (Intro)</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Cerrar (Esc)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>Reemplazar todo</translation>
    </message>
    <message numerus="yes">
        <source>%n replaced</source>
        <translation>
            <numerusform>%n reemplazado</numerusform>
            <numerusform>%n reemplazados</numerusform>
        </translation>
    </message>
    <message>
        <source>invalid regular expression</source>
        <translation>expresión regular no válida</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n encontrado</numerusform>
            <numerusform>%n encontrados</numerusform>
        </translation>
    </message>
    <message>
        <source>not found</source>
        <translation>no encontrado</translation>
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
        <translation>Valor forzado</translation>
    </message>
    <message>
        <source>Forced variables</source>
        <translation>Variables forzadas</translation>
    </message>
    <message>
        <source>Release selected</source>
        <translation>Anular los forzados seleccionados</translation>
    </message>
    <message>
        <source>Release all</source>
        <translation>Anular todos los forzados</translation>
    </message>
</context>
<context>
    <name>plc::editor::GraphView</name>
    <message>
        <source>Show all</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>Export as SVG, PNG or PDF…</source>
        <translation>Exportar como SVG, PNG o PDF…</translation>
    </message>
    <message>
        <source>Export the Drawing</source>
        <translation>Exportar el dibujo</translation>
    </message>
    <message>
        <source>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</source>
        <translation>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be written; choose a variable of the program</source>
        <translation>No se puede escribir %1; elija una variable del programa</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Imprimir…</translation>
    </message>
    <message>
        <source>Fix the text first: this is the last valid drawing</source>
        <translation>Corrija primero el texto: este es el último dibujo correcto</translation>
    </message>
</context>
<context>
    <name>plc::editor::LadderView</name>
    <message>
        <source>Ladder or function block diagram</source>
        <translation>Esquema de contactos o diagrama de bloques</translation>
    </message>
    <message>
        <source>Insert a rung below (Ctrl+T)</source>
        <translation>Insertar un segmento debajo (Control+T)</translation>
    </message>
    <message>
        <source>Insert a contact on the left (Ctrl+K)</source>
        <translation>Insertar un contacto a la izquierda (Control+K)</translation>
    </message>
    <message>
        <source>Insert a contact on the right (Ctrl+D)</source>
        <translation>Insertar un contacto a la derecha (Control+D)</translation>
    </message>
    <message>
        <source>Insert a parallel contact (Ctrl+R)</source>
        <translation>Insertar un contacto en paralelo (Control+R)</translation>
    </message>
    <message>
        <source>Insert a coil (Ctrl+A)</source>
        <translation>Insertar una bobina (Control+A)</translation>
    </message>
    <message>
        <source>Insert a function block (Ctrl+B)</source>
        <translation>Insertar un bloque de función (Control+B)</translation>
    </message>
    <message>
        <source>Edit (F2)</source>
        <translation>Editar (F2)</translation>
    </message>
    <message>
        <source>Delete (Del)</source>
        <translation>Eliminar (Supr)</translation>
    </message>
    <message>
        <source>Breakpoint on the rung (F9)</source>
        <translation>Punto de interrupción en el segmento (F9)</translation>
    </message>
    <message>
        <source>Show as a function block diagram</source>
        <translation>Mostrar como diagrama de bloques</translation>
    </message>
    <message>
        <source>Show as a ladder diagram</source>
        <translation>Mostrar como esquema de contactos</translation>
    </message>
    <message>
        <source>%1 is no longer in the text; undo the change or close this view</source>
        <translation>%1 ya no está en el texto; deshaga el cambio o cierre esta vista</translation>
    </message>
    <message>
        <source>The text has errors: this is the last valid drawing</source>
        <translation>El texto tiene errores: este es el último dibujo correcto</translation>
    </message>
    <message>
        <source>Fix the text first: this is the last valid drawing</source>
        <translation>Corrija primero el texto: este es el último dibujo correcto</translation>
    </message>
    <message>
        <source>Select a rung</source>
        <translation>Seleccione un segmento</translation>
    </message>
    <message>
        <source>Select a coil</source>
        <translation>Seleccione una bobina</translation>
    </message>
    <message>
        <source>Select a contact, a coil or a pin with a variable</source>
        <translation>Seleccione un contacto, una bobina o un pin con una variable</translation>
    </message>
    <message>
        <source>The rung has no contact yet</source>
        <translation>El segmento aún no tiene ningún contacto</translation>
    </message>
    <message>
        <source>Select the rung that gets the block</source>
        <translation>Seleccione el segmento que recibe el bloque</translation>
    </message>
    <message>
        <source>block</source>
        <translation>bloque</translation>
    </message>
    <message>
        <source>Contact on the left; at a coil, the last contact</source>
        <translation>Contacto a la izquierda; en una bobina, el último contacto</translation>
    </message>
    <message>
        <source>Contact on the right</source>
        <translation>Contacto a la derecha</translation>
    </message>
    <message>
        <source>Parallel contact</source>
        <translation>Contacto en paralelo</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>Bobina</translation>
    </message>
    <message>
        <source>Function block in the rung</source>
        <translation>Bloque de función en el segmento</translation>
    </message>
    <message>
        <source>Rung above</source>
        <translation>Segmento encima</translation>
    </message>
    <message>
        <source>Rung below</source>
        <translation>Segmento debajo</translation>
    </message>
    <message>
        <source>Negate a contact, a coil or a pin</source>
        <translation>Negar un contacto, una bobina o un pin</translation>
    </message>
    <message>
        <source>Coil: normal, set, reset</source>
        <translation>Bobina: normal, set, reset</translation>
    </message>
    <message>
        <source>Comment of the rung</source>
        <translation>Comentario del segmento</translation>
    </message>
    <message>
        <source>Edit what is selected (or Enter)</source>
        <translation>Editar lo seleccionado (o Intro)</translation>
    </message>
    <message>
        <source>Delete what is selected</source>
        <translation>Eliminar lo seleccionado</translation>
    </message>
    <message>
        <source>Breakpoint on the rung</source>
        <translation>Punto de interrupción en el segmento</translation>
    </message>
    <message>
        <source>This list</source>
        <translation>Esta lista</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Flechas</translation>
    </message>
    <message>
        <source>Select the next part; Up and Down also the next rung</source>
        <translation>Seleccionar la parte siguiente; Arriba y Abajo también el segmento siguiente</translation>
    </message>
    <message>
        <source>Move the rung up; with Down, down</source>
        <translation>Mover el segmento hacia arriba; con Abajo, hacia abajo</translation>
    </message>
    <message>
        <source>Typed before a name: a negated contact</source>
        <translation>Escrito delante de un nombre: un contacto negado</translation>
    </message>
    <message>
        <source>Keys in Ladder and Function Block Diagrams</source>
        <translation>Teclas en esquemas de contactos y diagramas de bloques</translation>
    </message>
    <message>
        <source>Insert a Rung Above</source>
        <translation>Insertar un segmento encima</translation>
    </message>
    <message>
        <source>Insert a Rung Below</source>
        <translation>Insertar un segmento debajo</translation>
    </message>
    <message>
        <source>Insert a Contact</source>
        <translation>Insertar un contacto</translation>
    </message>
    <message>
        <source>Insert a Parallel Contact</source>
        <translation>Insertar un contacto en paralelo</translation>
    </message>
    <message>
        <source>Insert a Coil</source>
        <translation>Insertar una bobina</translation>
    </message>
    <message>
        <source>Insert a Function Block…</source>
        <translation>Insertar un bloque de función…</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>Comment…</source>
        <translation>Comentario…</translation>
    </message>
    <message>
        <source>Negate</source>
        <translation>Negar</translation>
    </message>
    <message>
        <source>Set or Reset</source>
        <translation>Set o reset</translation>
    </message>
    <message>
        <source>Move the Rung Up</source>
        <translation>Subir el segmento</translation>
    </message>
    <message>
        <source>Move the Rung Down</source>
        <translation>Bajar el segmento</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Force TRUE</source>
        <translation>Forzar TRUE</translation>
    </message>
    <message>
        <source>Force FALSE</source>
        <translation>Forzar FALSE</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Anular el forzado</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Alternar punto de interrupción</translation>
    </message>
    <message>
        <source>Contacts as Bars (IEC 61131-3, ANSI)</source>
        <translation>Contactos como barras (IEC 61131-3, ANSI)</translation>
    </message>
    <message>
        <source>Contacts as in Circuit Diagrams (IEC 60617)</source>
        <translation>Contactos como en esquemas eléctricos (IEC 60617)</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Nombres</translation>
    </message>
    <message>
        <source>Addresses</source>
        <translation>Direcciones</translation>
    </message>
    <message>
        <source>Names and Addresses</source>
        <translation>Nombres y direcciones</translation>
    </message>
    <message>
        <source>Comments of the Variables</source>
        <translation>Comentarios de las variables</translation>
    </message>
    <message>
        <source>Comments of the Rungs</source>
        <translation>Comentarios de los segmentos</translation>
    </message>
    <message>
        <source>High Contrast</source>
        <translation>Contraste alto</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Qué se muestra</translation>
    </message>
    <message>
        <source>type</source>
        <translation>tipo</translation>
    </message>
    <message>
        <source>Rename the variable everywhere</source>
        <translation>Renombrar la variable en todas partes</translation>
    </message>
    <message>
        <source>Go to the definition</source>
        <translation>Ir a la definición</translation>
    </message>
    <message>
        <source>References to the variable</source>
        <translation>Referencias de la variable</translation>
    </message>
    <message>
        <source>Quick fix</source>
        <translation>Corrección rápida</translation>
    </message>
    <message>
        <source>Bookmark on the rung</source>
        <translation>Marcador en el segmento</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renombrar…</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Buscar referencias</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Ir a la definición</translation>
    </message>
    <message>
        <source>Quick Fix</source>
        <translation>Corrección rápida</translation>
    </message>
    <message>
        <source>Write TRUE</source>
        <translation>Escribir TRUE</translation>
    </message>
    <message>
        <source>Write FALSE</source>
        <translation>Escribir FALSE</translation>
    </message>
    <message>
        <source>Toggle Bookmark</source>
        <translation>Alternar marcador</translation>
    </message>
    <message>
        <source>Contact Here</source>
        <translation>Contacto aquí</translation>
    </message>
    <message>
        <source>Negated Contact Here</source>
        <translation>Contacto negado aquí</translation>
    </message>
    <message>
        <source>Function Block Here</source>
        <translation>Bloque de función aquí</translation>
    </message>
    <message>
        <source>Move the contact left; with Right, right</source>
        <translation>Mover el contacto a la izquierda; con Derecha, a la derecha</translation>
    </message>
    <message>
        <source>Select a contact; a rung moves up and down</source>
        <translation>Seleccione un contacto; un segmento se mueve hacia arriba y abajo</translation>
    </message>
</context>
<context>
    <name>plc::editor::RunArchive</name>
    <message>
        <source>The recording of the last run was not kept: %1</source>
        <translation>La grabación de la última ejecución no se ha conservado: %1</translation>
    </message>
</context>
<context>
    <name>plc::editor::RunControl</name>
    <message>
        <source>Built in %1 ms</source>
        <translation>Compilado en %1&#xa0;ms</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s): the program was not built</source>
        <translation>
            <numerusform>%n error: el programa no se ha compilado</numerusform>
            <numerusform>%n errores: el programa no se ha compilado</numerusform>
        </translation>
    </message>
    <message>
        <source>Online change: %1 kept, %2 new, %3 lost</source>
        <translation>Cambio online: %1 variables conservadas, %2 nuevas, %3 eliminadas</translation>
    </message>
    <message>
        <source>The change waits for the end of the scan</source>
        <translation>El cambio espera al final del ciclo</translation>
    </message>
    <message>
        <source>The program has errors; the controller continues with the old program</source>
        <translation>El programa tiene errores; el controlador sigue con el anterior</translation>
    </message>
    <message>
        <source>did not exist in this scan</source>
        <translation>no existía en este ciclo</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Compilación</translation>
    </message>
    <message>
        <source>Not optimised: the quick code keeps running</source>
        <translation>Sin optimizar: sigue el código compilado rápidamente</translation>
    </message>
    <message>
        <source>Optimising</source>
        <translation>Optimización</translation>
    </message>
    <message>
        <source>There is no code at or below line %1 of %2; choose an earlier line</source>
        <translation>No hay código en la línea %1 de %2 ni más abajo; elija una línea anterior</translation>
    </message>
    <message>
        <source>The condition of the breakpoint: %1</source>
        <translation>La condición del punto de interrupción: %1</translation>
    </message>
</context>
<context>
    <name>plc::editor::SlowScanView</name>
    <message>
        <source>Back to the previous breakpoint or to the first statement of the scan</source>
        <translation>Volver al punto de interrupción anterior o a la primera instrucción del ciclo</translation>
    </message>
    <message>
        <source>Back out of the call</source>
        <translation>Salir de la llamada</translation>
    </message>
    <message>
        <source>Back over calls</source>
        <translation>Volver por encima de las llamadas</translation>
    </message>
    <message>
        <source>One statement back</source>
        <translation>Una instrucción atrás</translation>
    </message>
    <message>
        <source>Step in</source>
        <translation>Paso a paso por instrucciones</translation>
    </message>
    <message>
        <source>Step over</source>
        <translation>Paso a paso por procedimientos</translation>
    </message>
    <message>
        <source>Step out</source>
        <translation>Paso a paso para salir</translation>
    </message>
    <message>
        <source>Forward to the next breakpoint or to the end of the scan</source>
        <translation>Seguir hasta el punto de interrupción siguiente o el final del ciclo</translation>
    </message>
    <message>
        <source>End the walk</source>
        <translation>Terminar el recorrido</translation>
    </message>
    <message>
        <source>Current position of the walk</source>
        <translation>Posición actual del recorrido</translation>
    </message>
    <message>
        <source>Call</source>
        <translation>Llamada</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>Instancia</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Call path</source>
        <translation>Pila de llamadas</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Values at this moment</source>
        <translation>Valores en este momento</translation>
    </message>
    <message>
        <source>There is no recorded scan yet: run the program first.</source>
        <translation>Aún no hay ningún ciclo grabado: ejecute primero el programa.</translation>
    </message>
    <message>
        <source>Running the scan again…</source>
        <translation>Repitiendo el ciclo…</translation>
    </message>
    <message>
        <source>Walks through a recorded scan statement by statement, forwards and backwards (Time, Walk Through the Scan).</source>
        <translation>Recorre un ciclo grabado instrucción por instrucción, hacia delante y hacia atrás (Tiempo, Recorrer el ciclo).</translation>
    </message>
    <message>
        <source>The end of scan %1 at %2</source>
        <translation>Final del ciclo %1 en %2</translation>
    </message>
    <message>
        <source>Scan %1 at %2: before statement %3 of %4</source>
        <translation>Ciclo %1 en %2: antes de la instrucción %3 de %4</translation>
    </message>
    <message>
        <source> · pass %1</source>
        <comment>of loops, outermost first</comment>
        <translation> · pasada %1</translation>
    </message>
    <message>
        <source>Locals</source>
        <translation>Variables locales</translation>
    </message>
</context>
<context>
    <name>plc::editor::StEditor</name>
    <message>
        <source>Structured Text editor</source>
        <translation>Editor de texto estructurado</translation>
    </message>
    <message>
        <source>Declare %1</source>
        <translation>Declarar %1</translation>
    </message>
    <message>
        <source>There is no fix for this line; press F1 for an explanation</source>
        <translation>No hay ninguna corrección para esta línea; pulse F1 para ver una explicación</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Ir a la definición</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Buscar referencias</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renombrar…</translation>
    </message>
    <message>
        <source>Add to Watch</source>
        <translation>Añadir a la supervisión</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Alternar punto de interrupción</translation>
    </message>
    <message>
        <source>CR</source>
        <comment>current result of an instruction list</comment>
        <translation>RA</translation>
    </message>
    <message>
        <source>Declare %1 as an input</source>
        <translation>Declarar %1 como entrada</translation>
    </message>
    <message>
        <source>Declare %1 as an output</source>
        <translation>Declarar %1 como salida</translation>
    </message>
    <message>
        <source>Declare %1 as a global variable</source>
        <translation>Declarar %1 como variable global</translation>
    </message>
    <message>
        <source>Declare %1 in %2</source>
        <translation>Declarar %1 en %2</translation>
    </message>
    <message>
        <source>Write a Value…</source>
        <translation>Escribir un valor…</translation>
    </message>
    <message>
        <source>Force…</source>
        <translation>Forzar…</translation>
    </message>
    <message>
        <source>Release the Force</source>
        <translation>Anular el forzado</translation>
    </message>
    <message>
        <source>pass</source>
        <comment>of a loop</comment>
        <translation>pasada</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::TaskMonitor</name>
    <message>
        <source>Histogram of execution times</source>
        <translation>Histograma de los tiempos de ejecución</translation>
    </message>
    <message>
        <source>Execution times appear here while the controller runs</source>
        <translation>Los tiempos de ejecución aparecen aquí mientras el controlador está en marcha</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Ejecuciones</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Último</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Mín</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Máx</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Jitter</translation>
    </message>
    <message>
        <source>Overruns</source>
        <translation>Tiempo excedido</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Carga</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tareas</translation>
    </message>
    <message>
        <source>Reset the statistics</source>
        <translation>Restablecer las estadísticas</translation>
    </message>
</context>
<context>
    <name>plc::editor::TuningView</name>
    <message>
        <source>Charts of the loop</source>
        <translation>Gráficos del lazo</translation>
    </message>
    <message>
        <source>Recording and model</source>
        <translation>Grabación y modelo</translation>
    </message>
    <message>
        <source>Response to the set point</source>
        <translation>Respuesta a la consigna</translation>
    </message>
    <message>
        <source>Response to a disturbance</source>
        <translation>Respuesta a una perturbación</translation>
    </message>
    <message>
        <source>Simulation with the actual block</source>
        <translation>Simulación con el bloque real</translation>
    </message>
    <message>
        <source>Control loop</source>
        <translation>Lazo de control</translation>
    </message>
    <message>
        <source>Find Steps</source>
        <translation>Buscar escalones</translation>
    </message>
    <message>
        <source>Searches the recording for steps of the set point and of the output and fits a model of the process.</source>
        <translation>Busca escalones de la consigna y de la salida en la grabación y crea un modelo del proceso.</translation>
    </message>
    <message>
        <source>Write Parameters</source>
        <translation>Escribir parámetros</translation>
    </message>
    <message>
        <source>Writes all parameters in one scan.</source>
        <translation>Escribe todos los parámetros en un ciclo.</translation>
    </message>
    <message>
        <source>Take Back</source>
        <translation>Revertir</translation>
    </message>
    <message>
        <source>Writes the parameters that were in force before.</source>
        <translation>Escribe los parámetros que estaban en vigor antes.</translation>
    </message>
    <message>
        <source>Loop:</source>
        <translation>Lazo:</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Usar</translation>
    </message>
    <message>
        <source>At</source>
        <translation>En</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Variación</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Valoración</translation>
    </message>
    <message>
        <source>Steps found</source>
        <translation>Escalones encontrados</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regla</translation>
    </message>
    <message>
        <source>Kind of controller</source>
        <translation>Tipo de regulador</translation>
    </message>
    <message>
        <source>Calm to brisk</source>
        <translation>Tranquilo a ágil</translation>
    </message>
    <message>
        <source>Disturbance to set point</source>
        <translation>Perturbación a consigna</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Propuesto</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Antes y después</translation>
    </message>
    <message>
        <source>Model:</source>
        <translation>Modelo:</translation>
    </message>
    <message>
        <source>Rule:</source>
        <translation>Regla:</translation>
    </message>
    <message>
        <source>Controller:</source>
        <translation>Regulador:</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>Tranquilo</translation>
    </message>
    <message>
        <source>Brisk</source>
        <translation>Ágil</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>Perturbación</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Consigna</translation>
    </message>
    <message>
        <source>The program has no controller block; call one, for example PID.</source>
        <translation>El programa no tiene ningún bloque regulador; llame a uno, por ejemplo PID.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Buscando…</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) found, %1 used.</source>
        <translation>
            <numerusform>%n escalón encontrado, %1 usado.</numerusform>
            <numerusform>%n escalones encontrados, %1 usados.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, explains %2 %</source>
        <translation>%1, explica el %2&#xa0;%</translation>
    </message>
    <message>
        <source>set point</source>
        <translation>consigna</translation>
    </message>
    <message>
        <source>output</source>
        <translation>salida</translation>
    </message>
    <message>
        <source>Choose at least one step.</source>
        <translation>Elija al menos un escalón.</translation>
    </message>
    <message>
        <source>The rule does not apply to this process; choose another rule.</source>
        <translation>La regla no es aplicable a este proceso; elija otra regla.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>cualquiera</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Ganancia</translation>
    </message>
    <message>
        <source>Integral time</source>
        <translation>Tiempo integral</translation>
    </message>
    <message>
        <source>Derivative time</source>
        <translation>Tiempo derivativo</translation>
    </message>
    <message>
        <source>Sensitivity Ms</source>
        <translation>Sensibilidad Ms</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>inestable</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Margen de ganancia</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Margen de fase</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Sobreoscilación</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Tiempo de establecimiento</translation>
    </message>
    <message>
        <source>Error after a load step</source>
        <translation>Error tras un escalón de carga</translation>
    </message>
    <message>
        <source>Control effort</source>
        <translation>Esfuerzo de control</translation>
    </message>
    <message>
        <source>Noise in the output</source>
        <translation>Ruido en la salida</translation>
    </message>
    <message>
        <source>Recorded and modelled</source>
        <translation>Grabado y modelado</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>tiempo [s]</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>grabado</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modelo</translation>
    </message>
    <message>
        <source>now</source>
        <translation>ahora</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>propuesto</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Sintonización</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>Taken back: %1</source>
        <translation>Revertido: %1</translation>
    </message>
    <message>
        <source>Residuals of the model</source>
        <translation>Residuos del modelo</translation>
    </message>
    <message>
        <source>recorded minus model</source>
        <translation>grabado menos modelo</translation>
    </message>
    <message>
        <source>loop now</source>
        <translation>lazo actual</translation>
    </message>
    <message>
        <source>loop as proposed</source>
        <translation>lazo propuesto</translation>
    </message>
    <message>
        <source>Bode plot</source>
        <translation>Diagrama de Bode</translation>
    </message>
    <message>
        <source>Bode Plot</source>
        <translation>Diagrama de Bode</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>frecuencia [rad/s]</translation>
    </message>
    <message>
        <source>process</source>
        <translation>proceso</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>margen de ganancia</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>margen de fase</translation>
    </message>
    <message>
        <source>Constants in the call: %1. Write Parameters changes them in the text and in the running controller by an online change.</source>
        <translation>Constantes en la llamada: %1. «Escribir parámetros» las cambia en el texto y, con un cambio online, en el controlador en marcha.</translation>
    </message>
    <message>
        <source>Computed in the call and not written: %1.</source>
        <translation>Calculado en la llamada y no escrito: %1.</translation>
    </message>
    <message>
        <source>The recorded disturbance with these settings</source>
        <translation>La perturbación grabada con estos ajustes</translation>
    </message>
    <message>
        <source>The recorded step with these settings</source>
        <translation>El escalón grabado con estos ajustes</translation>
    </message>
    <message>
        <source>The text was changed since the controller was started: change the constants after the next start or online change.</source>
        <translation>El texto se ha cambiado desde el arranque del controlador: cambie las constantes tras el próximo arranque o cambio online.</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Respuestas</translation>
    </message>
    <message>
        <source>Start the controller or open a recording to search it for steps.</source>
        <translation>Inicie el controlador o abra una grabación; se buscarán escalones en ella.</translation>
    </message>
    <message>
        <source>disturbance</source>
        <translation>perturbación</translation>
    </message>
    <message>
        <source>gain [dB]</source>
        <translation>ganancia [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>fase [°]</translation>
    </message>
    <message>
        <source>Health in figures</source>
        <translation>Estado en cifras</translation>
    </message>
    <message>
        <source>The whole recording</source>
        <translation>Toda la grabación</translation>
    </message>
    <message>
        <source>Save Report</source>
        <translation>Guardar informe</translation>
    </message>
    <message>
        <source>Web pages (*.html);;PDF (*.pdf)</source>
        <translation>Páginas web (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Report written: %1</source>
        <translation>Informe escrito:&#xa0;%1</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Informe…</translation>
    </message>
    <message>
        <source>Saves a report on the loop with model and settings as HTML or PDF.</source>
        <translation>Guarda un informe del lazo con modelo y ajustes como HTML o PDF.</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>Estado</translation>
    </message>
</context>
<context>
    <name>plc::editor::WatchView</name>
    <message>
        <source>A list %1 already exists; choose another name</source>
        <translation>Ya existe una lista %1; elija otro nombre</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Expresión</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Prepared</source>
        <translation>Preparado</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>Lista de supervisión</translation>
    </message>
    <message>
        <source>Add an expression: Main.x, a[i] * 2, fb.Q AND NOT done</source>
        <translation>Añadir una expresión: Main.x, a[i] * 2, fb.Q AND NOT done</translation>
    </message>
    <message>
        <source>New watch expression</source>
        <translation>Nueva expresión de supervisión</translation>
    </message>
    <message>
        <source>Write prepared values</source>
        <translation>Escribir los valores preparados</translation>
    </message>
    <message>
        <source>Force prepared values</source>
        <translation>Forzar los valores preparados</translation>
    </message>
    <message>
        <source>Release the selected forces</source>
        <translation>Anular los forzados seleccionados</translation>
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
        <translation>Binario</translation>
    </message>
    <message>
        <source>Number format</source>
        <translation>Formato de los números</translation>
    </message>
    <message>
        <source>Toggle</source>
        <translation>Conmutar</translation>
    </message>
    <message>
        <source>Force to %1</source>
        <translation>Forzar a %1</translation>
    </message>
    <message>
        <source>Release Force</source>
        <translation>Anular el forzado</translation>
    </message>
    <message>
        <source>Show in Trace</source>
        <translation>Mostrar en la traza</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>Quitar todos</translation>
    </message>
    <message>
        <source>Time</source>
        <comment>number format</comment>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Numbers as decimals, in hexadecimal or binary, or milliseconds as a time</source>
        <translation>Números en decimal, hexadecimal o binario, o milisegundos como tiempo</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <comment>stretch of an array</comment>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Supervisión</translation>
    </message>
    <message>
        <source>Add, rename or remove a list</source>
        <translation>Añadir, renombrar o quitar una lista</translation>
    </message>
    <message>
        <source>Name of the list:</source>
        <translation>Nombre de la lista:</translation>
    </message>
    <message>
        <source>New List…</source>
        <translation>Lista nueva…</translation>
    </message>
    <message>
        <source>New List</source>
        <translation>Lista nueva</translation>
    </message>
    <message>
        <source>Rename the List…</source>
        <translation>Renombrar la lista…</translation>
    </message>
    <message>
        <source>Rename the List</source>
        <translation>Renombrar la lista</translation>
    </message>
    <message>
        <source>Remove the List</source>
        <translation>Quitar la lista</translation>
    </message>
    <message>
        <source>Number Format</source>
        <translation>Formato de los números</translation>
    </message>
    <message>
        <source>As in the list</source>
        <translation>Como la lista</translation>
    </message>
    <message>
        <source>Source of %1 with the Values of %2</source>
        <translation>Código fuente de %1 con los valores de %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::WhyView</name>
    <message>
        <source>For example Main.level &gt; 80</source>
        <translation>Por ejemplo Main.level &gt; 80</translation>
    </message>
    <message>
        <source>Variable or expression to explain</source>
        <translation>Variable o expresión que explicar</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>¿Por qué?</translation>
    </message>
    <message>
        <source>What changed it, and what had to hold</source>
        <translation>Qué lo cambió y qué debía cumplirse</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>¿Por qué no?</translation>
    </message>
    <message>
        <source>The smallest changes that would change the result of the condition</source>
        <translation>Los cambios más pequeños que darían otro resultado a la condición</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>¿Quién lo asignó?</translation>
    </message>
    <message>
        <source>All changes in the recording, and what made each of them</source>
        <translation>Todos los cambios en la grabación y qué causó cada uno</translation>
    </message>
    <message>
        <source>Explanation</source>
        <translation>Explicación</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>Right-click a variable in the text, the watch, the tree, the trace or a panel and ask why it has its value.</source>
        <translation>Haga clic con el botón derecho en una variable del texto, la supervisión, el árbol, la traza o un panel y pregunte por qué tiene su valor.</translation>
    </message>
    <message>
        <source>Searching the recorded scans…</source>
        <translation>Examinando los ciclos grabados…</translation>
    </message>
    <message>
        <source>There is no recording yet: run the program first.</source>
        <translation>Aún no hay ninguna grabación: ejecute primero el programa.</translation>
    </message>
    <message>
        <source>%1 · scan %2</source>
        <comment>time and number</comment>
        <translation>%1 · ciclo %2</translation>
    </message>
    <message>
        <source>Earlier changes…</source>
        <translation>Cambios anteriores…</translation>
    </message>
    <message>
        <source>Why Is %1 So?</source>
        <translation>¿Por qué está así %1?</translation>
    </message>
    <message>
        <source>Who Set %1?</source>
        <translation>¿Quién asignó %1?</translation>
    </message>
    <message>
        <source>Copy the Answer</source>
        <translation>Copiar la respuesta</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cancel (Esc)</source>
        <translation>Cancelar (Esc)</translation>
    </message>
    <message>
        <source>Cancelled: there is no answer.</source>
        <translation>Cancelado: no hay respuesta.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::AlarmEditor</name>
    <message>
        <source>Alarm</source>
        <translation>Alarma</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Prioridad</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condición</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Add an alarm</source>
        <translation>Añadir una alarma</translation>
    </message>
    <message>
        <source>Add a class</source>
        <translation>Añadir una clase</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Clases</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Add alarm</source>
        <translation>Añadir alarma</translation>
    </message>
    <message>
        <source>Add class</source>
        <translation>Añadir clase</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ArrayArrangementDialog</name>
    <message>
        <source>Arrange over array</source>
        <translation>Disponer según un array</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parámetro</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Array</translation>
    </message>
    <message>
        <source>First index</source>
        <translation>Primer índice</translation>
    </message>
    <message>
        <source>Last index</source>
        <translation>Último índice</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Columnas</translation>
    </message>
    <message>
        <source>Horizontal gap</source>
        <translation>Separación horizontal</translation>
    </message>
    <message>
        <source>Vertical gap</source>
        <translation>Separación vertical</translation>
    </message>
    <message>
        <source>In the other arguments, # becomes the index.</source>
        <translation>En los demás argumentos, # se convierte en el índice.</translation>
    </message>
    <message>
        <source>Choose an array with one index, for example Plant.Valves.</source>
        <translation>Elija un array con un solo índice, por ejemplo Plant.Valves.</translation>
    </message>
    <message>
        <source>They reach to %1 × %2, the panel only to %3 × %4: make the faceplate smaller or the panel larger.</source>
        <translation>Llegan hasta %1 × %2, el panel solo hasta %3 × %4: reduzca el faceplate o amplíe el panel.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ArrayDialog</name>
    <message>
        <source>Duplicate as array</source>
        <translation>Duplicar como array</translation>
    </message>
    <message>
        <source>Number of elements</source>
        <translation>Número de elementos</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Columnas</translation>
    </message>
    <message>
        <source>Vertical gap</source>
        <translation>Separación vertical</translation>
    </message>
    <message>
        <source>Index step</source>
        <translation>Paso del índice</translation>
    </message>
    <message>
        <source>Horizontal gap</source>
        <translation>Separación horizontal</translation>
    </message>
</context>
<context>
    <name>plc::hmi::DesignCanvas</name>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Move point</source>
        <translation>Mover el punto</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Insertar</translation>
    </message>
    <message>
        <source>Resize</source>
        <translation>Cambiar el tamaño</translation>
    </message>
    <message>
        <source>Bind</source>
        <translation>Vincular</translation>
    </message>
    <message>
        <source>%1 has no single value: drop one of its members, or first draw a panel with a parameter of the type %2</source>
        <translation>%1 no tiene un valor único: suelte uno de sus miembros o dibuje antes un panel con un parámetro del tipo %2</translation>
    </message>
    <message>
        <source>Place in cell</source>
        <translation>Colocar en la celda</translation>
    </message>
</context>
<context>
    <name>plc::hmi::DesignContext</name>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renombrar %1</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>Rename Theme</source>
        <translation>Renombrar el tema</translation>
    </message>
</context>
<context>
    <name>plc::hmi::Outline</name>
    <message>
        <source>Lock</source>
        <translation>Bloquear</translation>
    </message>
    <message>
        <source>No elements yet. Drag one from the palette onto the panel.</source>
        <translation>Aún no hay elementos. Arrastre uno de la paleta al panel.</translation>
    </message>
    <message>
        <source>Reorder</source>
        <translation>Cambiar el orden</translation>
    </message>
</context>
<context>
    <name>plc::hmi::Palette</name>
    <message>
        <source>Search elements</source>
        <translation>Buscar elementos</translation>
    </message>
    <message>
        <source>Faceplates</source>
        <translation>Faceplates</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elementos</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PanelDesigner</name>
    <message>
        <source>Issue</source>
        <translation>Problema</translation>
    </message>
    <message>
        <source>Element</source>
        <translation>Elemento</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Duplicate as Array…</source>
        <translation>Duplicar como array…</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Seleccionar todo</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Align Left</source>
        <translation>Alinear a la izquierda</translation>
    </message>
    <message>
        <source>Align Centres</source>
        <translation>Centrar horizontalmente</translation>
    </message>
    <message>
        <source>Align Right</source>
        <translation>Alinear a la derecha</translation>
    </message>
    <message>
        <source>Align Top</source>
        <translation>Alinear arriba</translation>
    </message>
    <message>
        <source>Align Middles</source>
        <translation>Centrar verticalmente</translation>
    </message>
    <message>
        <source>Align Bottom</source>
        <translation>Alinear abajo</translation>
    </message>
    <message>
        <source>Distribute Horizontally</source>
        <translation>Distribuir horizontalmente</translation>
    </message>
    <message>
        <source>Distribute Vertically</source>
        <translation>Distribuir verticalmente</translation>
    </message>
    <message>
        <source>Same Width</source>
        <translation>Misma anchura</translation>
    </message>
    <message>
        <source>Same Height</source>
        <translation>Misma altura</translation>
    </message>
    <message>
        <source>Bring to Front</source>
        <translation>Traer al frente</translation>
    </message>
    <message>
        <source>Bring Forward</source>
        <translation>Traer adelante</translation>
    </message>
    <message>
        <source>Send Backward</source>
        <translation>Enviar atrás</translation>
    </message>
    <message>
        <source>Send to Back</source>
        <translation>Enviar al fondo</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Agrupar</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Desagrupar</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Bloquear</translation>
    </message>
    <message>
        <source>Show the Grid</source>
        <translation>Mostrar la cuadrícula</translation>
    </message>
    <message>
        <source>Snap (Alt: not now)</source>
        <translation>Ajustar a la cuadrícula (Alt: ahora no)</translation>
    </message>
    <message>
        <source>Live Preview</source>
        <translation>Vista previa en vivo</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Acercar</translation>
    </message>
    <message>
        <source>Zoom Out</source>
        <translation>Alejar</translation>
    </message>
    <message>
        <source>Zoom 100 %</source>
        <translation>Zoom 100&#xa0;%</translation>
    </message>
    <message>
        <source>Zoom to Fit</source>
        <translation>Ajustar a la ventana</translation>
    </message>
    <message>
        <source>Language shown</source>
        <translation>Idioma que se muestra</translation>
    </message>
    <message>
        <source>Theme of the panel</source>
        <translation>Tema del panel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contraste alto</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Duplicate as array</source>
        <translation>Duplicar como array</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elementos</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Same Size</source>
        <translation>Mismo tamaño</translation>
    </message>
    <message>
        <source>Paste in Place</source>
        <translation>Pegar en el mismo lugar</translation>
    </message>
    <message>
        <source>Arrange Over Array…</source>
        <translation>Disponer según un array…</translation>
    </message>
    <message>
        <source>Arrange over array</source>
        <translation>Disponer según un array</translation>
    </message>
    <message>
        <source>Fix All Issues</source>
        <translation>Corregir todos los problemas</translation>
    </message>
    <message>
        <source>Fix Issue</source>
        <translation>Corregir el problema</translation>
    </message>
    <message>
        <source>Explain Issue</source>
        <translation>Explicar el problema</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Estructura</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Issues</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>Lay Out in a Row</source>
        <translation>Disponer en fila</translation>
    </message>
    <message>
        <source>Lay Out in a Column</source>
        <translation>Disponer en columna</translation>
    </message>
    <message>
        <source>Lay Out in a Grid</source>
        <translation>Disponer en cuadrícula</translation>
    </message>
    <message>
        <source>Lay out</source>
        <translation>Disponer</translation>
    </message>
    <message>
        <source>Edit Themes…</source>
        <translation>Editar los temas…</translation>
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
        <translation>Establecer contraseña</translation>
    </message>
    <message>
        <source>Password of %1:</source>
        <translation>Contraseña de&#xa0;%1:</translation>
    </message>
    <message>
        <source>The two passwords differ.</source>
        <translation>Las dos contraseñas no coinciden.</translation>
    </message>
    <message>
        <source>Repeat:</source>
        <translation>Repetir:</translation>
    </message>
    <message>
        <source>Repeat the password.</source>
        <translation>Repita la contraseña.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PeopleEditor</name>
    <message>
        <source>User</source>
        <translation>Usuario</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Roles</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Start panel</source>
        <translation>Panel inicial</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Contraseña</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Usuarios</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rol</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Add a User</source>
        <translation>Añadir un usuario</translation>
    </message>
    <message>
        <source>Set Password…</source>
        <translation>Establecer contraseña…</translation>
    </message>
    <message>
        <source>Remove User</source>
        <translation>Quitar usuario</translation>
    </message>
    <message>
        <source>Add a Role</source>
        <translation>Añadir un rol</translation>
    </message>
    <message>
        <source>Remove Role</source>
        <translation>Quitar rol</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nunca</translation>
    </message>
    <message>
        <source>Logged out after</source>
        <translation>Cerrar sesión tras</translation>
    </message>
    <message>
        <source>Logged out after </source>
        <translation>Cerrar sesión tras </translation>
    </message>
    <message>
        <source>Logged Out After</source>
        <translation>Cerrar sesión tras</translation>
    </message>
    <message>
        <source>Set Password</source>
        <translation>Establecer contraseña</translation>
    </message>
    <message>
        <source>none: cannot log in</source>
        <translation>ninguna: no puede iniciar sesión</translation>
    </message>
    <message>
        <source>set</source>
        <translation>establecida</translation>
    </message>
    <message>
        <source>Rename Role</source>
        <translation>Renombrar rol</translation>
    </message>
    <message>
        <source>Without users, everybody may do everything. Add a role, then a user with a password.</source>
        <translation>Sin usuarios, todos pueden hacerlo todo. Añada un rol y después un usuario con contraseña.</translation>
    </message>
    <message>
        <source>To restrict an element to some users, set its property &quot;Only for the roles&quot;.</source>
        <translation>Para limitar un elemento a algunos usuarios, defina su propiedad «Solo para los roles».</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PropertySheet</name>
    <message>
        <source>Search properties</source>
        <translation>Buscar propiedades</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n elemento</numerusform>
            <numerusform>%n elementos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::hmi::RecipeEditor</name>
    <message>
        <source>Add a Recipe</source>
        <translation>Añadir una receta</translation>
    </message>
    <message>
        <source>Add a Variable</source>
        <translation>Añadir una variable</translation>
    </message>
    <message>
        <source>Add a Set</source>
        <translation>Añadir un juego de valores</translation>
    </message>
    <message>
        <source>Remove Row or Set</source>
        <translation>Quitar fila o juego de valores</translation>
    </message>
    <message>
        <source>Remove Recipe</source>
        <translation>Quitar receta</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>Importar CSV</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>Exportar CSV</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recetas</translation>
    </message>
    <message>
        <source>Variables and sets of the recipe</source>
        <translation>Variables y juegos de valores de la receta</translation>
    </message>
    <message>
        <source>Rename Recipe</source>
        <translation>Renombrar la receta</translation>
    </message>
    <message>
        <source>Rename Set</source>
        <translation>Renombrar el juego de valores</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nombre:</translation>
    </message>
    <message>
        <source>Remove Set</source>
        <translation>Quitar juego de valores</translation>
    </message>
    <message>
        <source>Remove Row</source>
        <translation>Quitar fila</translation>
    </message>
    <message>
        <source>Add a recipe, then its variables, then a set for each product.</source>
        <translation>Añada una receta, después sus variables y después un juego de valores para cada producto.</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Mínimo</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>A recipe needs a name.</source>
        <translation>Una receta necesita un nombre.</translation>
    </message>
    <message>
        <source>The recipe &quot;%1&quot; already exists; choose another name.</source>
        <translation>Ya existe una receta «%1»; elija otro nombre.</translation>
    </message>
    <message>
        <source>The set &quot;%1&quot; already exists; choose another name.</source>
        <translation>Ya existe un juego de valores «%1»; elija otro nombre.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number; a limit is written like 12.5.</source>
        <translation>«%1» no es un número; un límite se escribe por ejemplo 12.5.</translation>
    </message>
    <message>
        <source>A row needs a variable; Remove Row or Set takes the row away.</source>
        <translation>Una fila necesita una variable; «Quitar fila o juego de valores» la elimina.</translation>
    </message>
    <message>
        <source>%1 is already in the recipe; choose another variable.</source>
        <translation>%1 ya está en la receta; elija otra variable.</translation>
    </message>
    <message>
        <source>Select a cell of the set that is to be renamed.</source>
        <translation>Seleccione una celda del juego de valores que se va a renombrar.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::RecordsDialog</name>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Abajo</translation>
    </message>
</context>
<context>
    <name>plc::hmi::TextEditor</name>
    <message>
        <source>A key %1 already exists; choose another name</source>
        <translation>Ya existe una clave %1; elija otro nombre</translation>
    </message>
    <message>
        <source>Only incomplete</source>
        <translation>Solo incompletos</translation>
    </message>
    <message>
        <source>Search texts</source>
        <translation>Buscar textos</translation>
    </message>
    <message>
        <source>Add a key</source>
        <translation>Añadir una clave</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Clave</translation>
    </message>
    <message>
        <source>Remove the selected keys</source>
        <translation>Quitar las claves seleccionadas</translation>
    </message>
    <message>
        <source>Add a language</source>
        <translation>Añadir un idioma</translation>
    </message>
    <message>
        <source>Language tag, for example de or zh-CN</source>
        <translation>Etiqueta de idioma, por ejemplo de o zh-CN</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>Importar CSV</translation>
    </message>
    <message>
        <source>Text tables (*.csv *.txt)</source>
        <translation>Tablas de textos (*.csv *.txt)</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>Exportar CSV</translation>
    </message>
    <message>
        <source>Text tables (*.csv)</source>
        <translation>Tablas de textos (*.csv)</translation>
    </message>
    <message>
        <source>Add key</source>
        <translation>Añadir clave</translation>
    </message>
    <message>
        <source>Remove keys</source>
        <translation>Quitar claves</translation>
    </message>
    <message>
        <source>Add language</source>
        <translation>Añadir idioma</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>%n texto</numerusform>
            <numerusform>%n textos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is not used.</source>
        <translation>%1 no se usa.</translation>
    </message>
    <message>
        <source>%1 is used by %2</source>
        <translation>%1 se usa en %2</translation>
    </message>
    <message>
        <source>Import XLIFF</source>
        <translation>Importar XLIFF</translation>
    </message>
    <message>
        <source>Translations (*.xlf *.xliff)</source>
        <translation>Traducciones (*.xlf *.xliff)</translation>
    </message>
    <message>
        <source>Export XLIFF</source>
        <translation>Exportar XLIFF</translation>
    </message>
    <message>
        <source>Translated from</source>
        <translation>Traducido de</translation>
    </message>
    <message>
        <source>Translated into</source>
        <translation>Traducido a</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Versión</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) taken.</source>
        <translation>
            <numerusform>%n texto aceptado.</numerusform>
            <numerusform>%n textos aceptados.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) as they were.</source>
        <translation>
            <numerusform>%n texto sin cambios.</numerusform>
            <numerusform>%n textos sin cambios.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) without a translation.</source>
        <translation>
            <numerusform>%n texto sin traducción.</numerusform>
            <numerusform>%n textos sin traducción.</numerusform>
        </translation>
    </message>
    <message>
        <source>XLIFF %1</source>
        <translation>XLIFF %1</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Textos</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Remove language</source>
        <translation>Quitar idioma</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Quitar&#xa0;%1</translation>
    </message>
    <message>
        <source>%1 is not a language tag; choose one from the list, or enter a tag such as de or zh-CN</source>
        <translation>%1 no es una etiqueta de idioma; elija una de la lista o escriba una etiqueta como de o zh-CN</translation>
    </message>
    <message>
        <source>The table already has %1; choose another language</source>
        <translation>La tabla ya tiene&#xa0;%1; elija otro idioma</translation>
    </message>
    <message>
        <source>Remove the language</source>
        <translation>Quitar el idioma</translation>
    </message>
    <message>
        <source>Select a cell of the language that is to be removed.</source>
        <translation>Seleccione una celda del idioma que se va a quitar.</translation>
    </message>
    <message>
        <source>A table of texts keeps one language; add another one first.</source>
        <translation>Una tabla de textos conserva un idioma; añada antes otro.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::TextModel</name>
    <message>
        <source>Key</source>
        <translation>Clave</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>Rename key</source>
        <translation>Renombrar la clave</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ThemeDialog</name>
    <message>
        <source>Grounds, lines and texts</source>
        <translation>Fondos, líneas y textos</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Proceso</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>Colours by name</source>
        <translation>Colores por nombre</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Curvas</translation>
    </message>
    <message>
        <source>Based on</source>
        <translation>Basado en</translation>
    </message>
    <message>
        <source>Colours that this theme does not change are those of the base.</source>
        <translation>Los colores que este tema no cambia son los de la base.</translation>
    </message>
    <message>
        <source>Panel Themes</source>
        <translation>Temas de los paneles</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Base of the Theme</source>
        <translation>Base del tema</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Nuevo…</translation>
    </message>
    <message>
        <source>New Theme</source>
        <translation>Tema nuevo</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renombrar…</translation>
    </message>
    <message>
        <source>Rename Theme</source>
        <translation>Renombrar el tema</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Name of the theme:</source>
        <translation>Nombre del tema:</translation>
    </message>
    <message>
        <source>A theme&apos;s name cannot contain %1; choose another name</source>
        <translation>El nombre de un tema no puede contener %1; elija otro nombre</translation>
    </message>
    <message>
        <source>A theme&apos;s name begins with a letter or a digit</source>
        <translation>El nombre de un tema empieza por una letra o una cifra</translation>
    </message>
    <message>
        <source>There is a theme %1 already; choose another name</source>
        <translation>Ya hay un tema %1; elija otro nombre</translation>
    </message>
    <message>
        <source>There is a file %1 already; choose another name</source>
        <translation>Ya hay un archivo %1; elija otro nombre</translation>
    </message>
    <message>
        <source>%1 is used on %2; choose another theme there before it is deleted</source>
        <translation>%1 se usa en %2; elija allí antes otro tema</translation>
    </message>
    <message>
        <source>Delete Theme</source>
        <translation>Eliminar el tema</translation>
    </message>
    <message>
        <source>The project has no theme of its own yet. New… makes one that begins with the colours shown.</source>
        <translation>El proyecto todavía no tiene un tema propio. Nuevo… crea uno que empieza con los colores mostrados.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 on %2: contrast %L3, %L4 is needed</source>
        <translation>%1 sobre %2: contraste %L3, se necesita %L4</translation>
    </message>
    <message>
        <source>Changed on disk too: %1. OK replaces what is there.</source>
        <translation>También cambiado en el disco: %1. Aceptar sustituye lo que hay allí.</translation>
    </message>
    <message>
        <source>Discard the changes of the themes?</source>
        <translation>¿Descartar los cambios de los temas?</translation>
    </message>
</context>
<context>
    <name>plc::kit::Canvas</name>
    <message>
        <source>Overview</source>
        <translation>Vista general</translation>
    </message>
</context>
<context>
    <name>plc::kit::ColorPopup</name>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>More colours…</source>
        <translation>Más colores…</translation>
    </message>
    <message>
        <source>No colour</source>
        <translation>Sin color</translation>
    </message>
</context>
<context>
    <name>plc::kit::ColumnMenu</name>
    <message>
        <source>Column %1</source>
        <translation>Columna %1</translation>
    </message>
    <message>
        <source>Fit to Contents</source>
        <translation>Ajustar al contenido</translation>
    </message>
    <message>
        <source>Wider</source>
        <translation>Más ancha</translation>
    </message>
    <message>
        <source>Narrower</source>
        <translation>Más estrecha</translation>
    </message>
    <message>
        <source>Move Left</source>
        <translation>Mover a la izquierda</translation>
    </message>
    <message>
        <source>Move Right</source>
        <translation>Mover a la derecha</translation>
    </message>
    <message>
        <source>Sort Ascending</source>
        <translation>Orden ascendente</translation>
    </message>
    <message>
        <source>Sort Descending</source>
        <translation>Orden descendente</translation>
    </message>
</context>
<context>
    <name>plc::kit::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation>Paleta de comandos</translation>
    </message>
    <message>
        <source>Type to find a command</source>
        <translation>Escriba para encontrar un comando</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandos</translation>
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
        <translation>Elija una variable</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Elija un archivo</translation>
    </message>
    <message>
        <source>Edit in a window</source>
        <translation>Editar en una ventana</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Sí</translation>
    </message>
    <message>
        <source>No</source>
        <translation>No</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>Propiedad</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propiedades</translation>
    </message>
    <message>
        <source>various</source>
        <translation>distintos</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Choose from a list</source>
        <translation>Elegir de una lista</translation>
    </message>
</context>
<context>
    <name>plc::kit::VariablePicker</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>Search variables</source>
        <translation>Buscar variables</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Found variables</source>
        <translation>Variables encontradas</translation>
    </message>
    <message>
        <source>Choose a variable</source>
        <translation>Elija una variable</translation>
    </message>
</context>
<context>
    <name>plc::kit::WorkStrip</name>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>%1 is being cancelled…</source>
        <translation>Cancelando: %1…</translation>
    </message>
    <message>
        <source>Cancel: %1</source>
        <translation>Cancelar: %1</translation>
    </message>
</context>
<context>
    <name>plc::plot::PlotView</name>
    <message>
        <source>Chart</source>
        <translation>Gráfico</translation>
    </message>
    <message>
        <source>%1
Click selects, Ctrl+click shows or hides.</source>
        <translation>%1
Un clic selecciona, Control+clic muestra u oculta.</translation>
    </message>
</context>
<context>
    <name>plc::trace::ChannelPanel</name>
    <message>
        <source>Variable or expression</source>
        <translation>Variable o expresión</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Añadir un canal</translation>
    </message>
    <message>
        <source>Add as a channel</source>
        <translation>Añadir como canal</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Canal</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Canales</translation>
    </message>
    <message>
        <source>Show channel</source>
        <translation>Mostrar el canal</translation>
    </message>
    <message>
        <source>Hide channel</source>
        <translation>Ocultar el canal</translation>
    </message>
    <message>
        <source>Chart %1</source>
        <translation>Gráfico %1</translation>
    </message>
    <message>
        <source>error</source>
        <translation>error</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Expresión</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Estilo</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Escalón</translation>
    </message>
    <message>
        <source>Digital</source>
        <translation>Digital</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Grosor de línea</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Factor</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Desplazamiento</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Gráfico</translation>
    </message>
    <message>
        <source>New chart</source>
        <translation>Gráfico nuevo</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Eje %1</translation>
    </message>
    <message>
        <source>New axis</source>
        <translation>Eje nuevo</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Share of height</source>
        <translation>Parte de la altura</translation>
    </message>
    <message>
        <source>Scaling</source>
        <translation>Escalado</translation>
    </message>
    <message>
        <source>Fit to view</source>
        <translation>Ajustar a la vista</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fijo</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Mínimo</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>On the right</source>
        <translation>A la derecha</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Traza</translation>
    </message>
    <message>
        <source>Every n-th scan</source>
        <translation>Cada n ciclos</translation>
    </message>
    <message>
        <source>Record while</source>
        <translation>Condición de grabación</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Disparador</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Flanco</translation>
    </message>
    <message>
        <source>Rising</source>
        <translation>Ascendente</translation>
    </message>
    <message>
        <source>Falling</source>
        <translation>Descendente</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Ambos</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Desactivado</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Único</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Repetido</translation>
    </message>
    <message>
        <source>Shown before</source>
        <translation>Mostrado antes del disparo</translation>
    </message>
    <message>
        <source>Shown after</source>
        <translation>Mostrado después del disparo</translation>
    </message>
    <message>
        <source>Change channel</source>
        <translation>Cambiar el canal</translation>
    </message>
    <message>
        <source>Change chart</source>
        <translation>Cambiar el gráfico</translation>
    </message>
    <message>
        <source>Change trace</source>
        <translation>Cambiar la traza</translation>
    </message>
    <message>
        <source>Remove channel</source>
        <translation>Quitar el canal</translation>
    </message>
    <message>
        <source>Remove chart</source>
        <translation>Quitar el gráfico</translation>
    </message>
    <message>
        <source>Move channel</source>
        <translation>Mover el canal</translation>
    </message>
    <message>
        <source>Compared recording</source>
        <translation>Grabación comparada</translation>
    </message>
    <message>
        <source>Offset in time</source>
        <translation>Desplazamiento en el tiempo</translation>
    </message>
</context>
<context>
    <name>plc::trace::FigurePane</name>
    <message>
        <source>Save as %1</source>
        <translation>Guardar como %1</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Copy as Picture</source>
        <translation>Copiar como imagen</translation>
    </message>
    <message>
        <source>Save as %1…</source>
        <translation>Guardar como %1…</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Hann window</source>
        <translation>Ventana de Hann</translation>
    </message>
    <message>
        <source>Flat top: exact amplitudes</source>
        <translation>Flat top: amplitudes exactas</translation>
    </message>
    <message>
        <source>No window</source>
        <translation>Sin ventana</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarítmico</translation>
    </message>
    <message>
        <source>Charts over time only</source>
        <translation>Solo gráficos temporales</translation>
    </message>
    <message>
        <source>Horizontal value</source>
        <translation>Valor horizontal</translation>
    </message>
    <message>
        <source>Window of the spectrum</source>
        <translation>Ventana del espectro</translation>
    </message>
    <message>
        <source>Logarithmic axes</source>
        <translation>Ejes logarítmicos</translation>
    </message>
    <message>
        <source>Input:</source>
        <translation>Entrada:</translation>
    </message>
    <message>
        <source>Horizontal:</source>
        <translation>Horizontal:</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Measure between Points</source>
        <translation>Medir entre puntos</translation>
    </message>
</context>
<context>
    <name>plc::trace::TimeBar</name>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Resumed from here
%1</source>
        <translation>Reanudado desde aquí
%1</translation>
    </message>
</context>
<context>
    <name>plc::trace::TimeSlider</name>
    <message>
        <source>Time slider</source>
        <translation>Control deslizante del tiempo</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Variable whose changes to step to</source>
        <translation>Variable por cuyos cambios se avanza</translation>
    </message>
    <message>
        <source>The arrows beside step to its previous and next change</source>
        <translation>Las flechas de al lado van a su cambio anterior y siguiente</translation>
    </message>
    <message>
        <source>One scan back (Left)</source>
        <translation>Un ciclo atrás (Izquierda)</translation>
    </message>
    <message>
        <source>One scan forward (Right)</source>
        <translation>Un ciclo adelante (Derecha)</translation>
    </message>
    <message>
        <source>Previous change of the variable (Ctrl+Left)</source>
        <translation>Cambio anterior de la variable (Control+Izquierda)</translation>
    </message>
    <message>
        <source>Next change of the variable (Ctrl+Right)</source>
        <translation>Cambio siguiente de la variable (Control+Derecha)</translation>
    </message>
    <message>
        <source>Resume the controller from this scan</source>
        <translation>Reanudar el controlador desde este ciclo</translation>
    </message>
    <message>
        <source>Back to the newest scan (End)</source>
        <translation>Volver al ciclo más reciente (Fin)</translation>
    </message>
    <message>
        <source>Older scans are no longer kept.</source>
        <translation>Los ciclos más antiguos ya no se conservan.</translation>
    </message>
    <message>
        <source>%1 does not change before this scan.</source>
        <translation>%1 no cambia antes de este ciclo.</translation>
    </message>
    <message>
        <source>%1 does not change after this scan.</source>
        <translation>%1 no cambia después de este ciclo.</translation>
    </message>
    <message>
        <source>No recording</source>
        <translation>Sin grabación</translation>
    </message>
    <message>
        <source>no longer kept</source>
        <translation>ya no se conserva</translation>
    </message>
    <message>
        <source>scan %1  %2</source>
        <translation>ciclo %1  %2</translation>
    </message>
</context>
<context>
    <name>plc::trace::TraceView</name>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Traza</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mediciones</translation>
    </message>
    <message>
        <source>Show channel</source>
        <translation>Mostrar el canal</translation>
    </message>
    <message>
        <source>Hide channel</source>
        <translation>Ocultar el canal</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Follow the newest scan (End)</source>
        <translation>Seguir el ciclo más reciente (Fin)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Show everything recorded (Home)</source>
        <translation>Mostrar todo lo grabado (Inicio)</translation>
    </message>
    <message>
        <source>Fit values</source>
        <translation>Ajustar los valores</translation>
    </message>
    <message>
        <source>Let the value axes fit again</source>
        <translation>Volver a ajustar los ejes de valores</translation>
    </message>
    <message>
        <source>Zoom back</source>
        <translation>Zoom anterior</translation>
    </message>
    <message>
        <source>Back to the view before (Backspace)</source>
        <translation>Volver a la vista anterior (Retroceso)</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Drag a box to zoom: flat for time, upright for values</source>
        <translation>Arrastre un recuadro para ampliar: plano para el tiempo, alto para los valores</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Desplazar la vista</translation>
    </message>
    <message>
        <source>Drag to pan (middle button always does)</source>
        <translation>Arrastre para desplazar la vista (con el botón central, siempre)</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursores</translation>
    </message>
    <message>
        <source>Two cursors (Ctrl+click sets A, Shift+click sets B)</source>
        <translation>Dos cursores (Control+clic pone A, Mayúsculas+clic pone B)</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Table of values and statistics between the cursors</source>
        <translation>Tabla de valores y estadísticas entre los cursores</translation>
    </message>
    <message>
        <source>Measuring table</source>
        <translation>Tabla de medición</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Disparador</translation>
    </message>
    <message>
        <source>Arm the trigger set in the properties of the trace</source>
        <translation>Armar el disparador definido en las propiedades de la traza</translation>
    </message>
    <message>
        <source>Previous trigger</source>
        <translation>Disparo anterior</translation>
    </message>
    <message>
        <source>Where the trigger would have fired before</source>
        <translation>Dónde se habría disparado antes el disparador</translation>
    </message>
    <message>
        <source>Next trigger</source>
        <translation>Disparo siguiente</translation>
    </message>
    <message>
        <source>Where the trigger would have fired next</source>
        <translation>Dónde se habría disparado después el disparador</translation>
    </message>
    <message>
        <source>Add chart</source>
        <translation>Añadir gráfico</translation>
    </message>
    <message>
        <source>Another chart over the same time</source>
        <translation>Otro gráfico sobre el mismo tiempo</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Load an older recording beneath the present one</source>
        <translation>Cargar una grabación anterior debajo de la actual</translation>
    </message>
    <message>
        <source>Recording to draw beneath</source>
        <translation>Grabación que se dibuja debajo</translation>
    </message>
    <message>
        <source>Trace configuration</source>
        <translation>Configuración de traza</translation>
    </message>
    <message>
        <source>Open Configuration…</source>
        <translation>Abrir configuración…</translation>
    </message>
    <message>
        <source>Open trace configuration</source>
        <translation>Abrir configuración de traza</translation>
    </message>
    <message>
        <source>Trace configurations (*.trace.json)</source>
        <translation>Configuraciones de traza (*.trace.json)</translation>
    </message>
    <message>
        <source>Save trace configuration</source>
        <translation>Guardar configuración de traza</translation>
    </message>
    <message>
        <source>Save Configuration</source>
        <translation>Guardar configuración</translation>
    </message>
    <message>
        <source>Save Configuration As…</source>
        <translation>Guardar configuración como…</translation>
    </message>
    <message>
        <source>Open Recording…</source>
        <translation>Abrir grabación…</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Abrir grabación</translation>
    </message>
    <message>
        <source>Back to the Running PLC</source>
        <translation>Volver al directo del PLC</translation>
    </message>
    <message>
        <source>Save Recording…</source>
        <translation>Guardar grabación…</translation>
    </message>
    <message>
        <source>Save recording</source>
        <translation>Guardar grabación</translation>
    </message>
    <message>
        <source>Recordings (*.rec)</source>
        <translation>Grabaciones (*.rec)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Copy as Picture</source>
        <translation>Copiar como imagen</translation>
    </message>
    <message>
        <source>Save Samples in View as CSV…</source>
        <translation>Guardar los valores visibles como CSV…</translation>
    </message>
    <message>
        <source>Save as %1…</source>
        <translation>Guardar como %1…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Imprimir…</translation>
    </message>
    <message>
        <source>Save as %1</source>
        <translation>Guardar como %1</translation>
    </message>
    <message>
        <source>Add channel</source>
        <translation>Añadir canal</translation>
    </message>
    <message>
        <source>Arm trigger</source>
        <translation>Armar el disparador</translation>
    </message>
    <message>
        <source>The trigger has no expression yet: enter one in the properties of the trace.</source>
        <translation>El disparador aún no tiene expresión: escriba una en las propiedades de la traza.</translation>
    </message>
    <message>
        <source>Trigger armed</source>
        <translation>Disparador armado</translation>
    </message>
    <message>
        <source>Triggered, collecting</source>
        <translation>Disparado, recogiendo valores</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>Disparado</translation>
    </message>
    <message numerus="yes">
        <source>(%n shot(s))</source>
        <translation>
            <numerusform>(%n disparo)</numerusform>
            <numerusform>(%n disparos)</numerusform>
        </translation>
    </message>
    <message>
        <source>Not running</source>
        <translation>Parado</translation>
    </message>
    <message>
        <source>%L1 scans kept  ·  history %2 of %3 MB  ·  channels %4 of %5 MB</source>
        <translation>%L1 ciclos conservados  ·  historial %2 de %3&#xa0;MB  ·  canales %4 de %5&#xa0;MB</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propiedades</translation>
    </message>
    <message>
        <source>Remove Channel</source>
        <translation>Quitar el canal</translation>
    </message>
    <message>
        <source>Add Channel…</source>
        <translation>Añadir canal…</translation>
    </message>
    <message>
        <source>Trigger off</source>
        <translation>Desactivar el disparador</translation>
    </message>
    <message>
        <source>Saving the samples…</source>
        <translation>Guardando los valores…</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Abriendo %1…</translation>
    </message>
    <message>
        <source>Saving the recording…</source>
        <translation>Guardando la grabación…</translation>
    </message>
    <message>
        <source>%1, %2 later</source>
        <translation>%1, %2 después</translation>
    </message>
    <message>
        <source>%1, %2 earlier</source>
        <translation>%1, %2 antes</translation>
    </message>
    <message>
        <source>Measure between points</source>
        <translation>Medir entre puntos</translation>
    </message>
    <message>
        <source>Drag from one point to another: time, value, slope and frequency between them (M)</source>
        <translation>Arrastre de un punto a otro: tiempo, valor, pendiente y frecuencia entre ellos (M)</translation>
    </message>
    <message>
        <source>XY plot, spectrum, frequency response, runs</source>
        <translation>Gráfico XY, espectro, respuesta en frecuencia, ejecuciones</translation>
    </message>
    <message>
        <source>Add Channel of Another File…</source>
        <translation>Añadir canal de otro archivo…</translation>
    </message>
    <message>
        <source>Show Beside</source>
        <translation>Mostrar al lado</translation>
    </message>
    <message>
        <source>Measure between Points</source>
        <translation>Medir entre puntos</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>Añadir nota</translation>
    </message>
    <message>
        <source>Add Note</source>
        <translation>Añadir nota</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Nota:</translation>
    </message>
    <message>
        <source>Edit Note</source>
        <translation>Editar nota</translation>
    </message>
    <message>
        <source>Edit note</source>
        <translation>Editar nota</translation>
    </message>
    <message>
        <source>Remove note</source>
        <translation>Quitar nota</translation>
    </message>
    <message>
        <source>Edit Note…</source>
        <translation>Editar nota…</translation>
    </message>
    <message>
        <source>Remove Note</source>
        <translation>Quitar nota</translation>
    </message>
    <message>
        <source>Add Note…</source>
        <translation>Añadir nota…</translation>
    </message>
    <message>
        <source>File to add a channel of</source>
        <translation>Archivo del que añadir un canal</translation>
    </message>
    <message>
        <source>Recordings and tables (*.rec *.csv *.tsv *.txt *.trace);;All files (*)</source>
        <translation>Grabaciones y tablas (*.rec *.csv *.tsv *.txt *.trace);;Todos los archivos (*)</translation>
    </message>
</context>
</TS>
