<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>DeviceFields</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protocole</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>Activé</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Hôte</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Unit number</source>
        <translation>Numéro d’unité</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Port série</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Vitesse de transmission</translation>
    </message>
    <message>
        <source>Parity</source>
        <translation>Parité</translation>
    </message>
    <message>
        <source>Data bits</source>
        <translation>Bits de données</translation>
    </message>
    <message>
        <source>Stop bits</source>
        <translation>Bits d’arrêt</translation>
    </message>
    <message>
        <source>Poll interval</source>
        <translation>Intervalle de scrutation</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>Délai d’attente</translation>
    </message>
    <message>
        <source>Longest pause between attempts</source>
        <translation>Pause maximale entre les tentatives</translation>
    </message>
    <message>
        <source>Variable: device responds</source>
        <translation>Variable&#xa0;: l’appareil répond</translation>
    </message>
    <message>
        <source>Client ID</source>
        <translation>Identifiant du client</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Utilisateur</translation>
    </message>
    <message>
        <source>Password file</source>
        <translation>Fichier du mot de passe</translation>
    </message>
    <message>
        <source>TLS encryption</source>
        <translation>Chiffrement TLS</translation>
    </message>
    <message>
        <source>File of CA certificates</source>
        <translation>Fichier des certificats de l’AC</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Table</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Bit of the register</source>
        <translation>Bit du registre</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Ordre des octets</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>Topic</translation>
    </message>
    <message>
        <source>Path in the JSON message</source>
        <translation>Chemin dans le message JSON</translation>
    </message>
    <message>
        <source>Quality of service (0 to 2)</source>
        <translation>Qualité de service (QoS 0 à 2)</translation>
    </message>
    <message>
        <source>Retained message</source>
        <translation>Message conservé par le broker (retain)</translation>
    </message>
    <message>
        <source>If the connection is lost</source>
        <translation>En cas de perte de connexion</translation>
    </message>
    <message>
        <source>Safe value</source>
        <translation>Valeur sûre</translation>
    </message>
    <message>
        <source>Variable: channel is good</source>
        <translation>Variable&#xa0;: la voie est valide</translation>
    </message>
    <message>
        <source>Modbus TCP device</source>
        <translation>Appareil Modbus TCP</translation>
    </message>
    <message>
        <source>Modbus RTU device (serial)</source>
        <translation>Appareil Modbus RTU (série)</translation>
    </message>
    <message>
        <source>Modbus TCP server</source>
        <translation>Serveur Modbus TCP</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>Broker MQTT</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>Bobine (coil)</translation>
    </message>
    <message>
        <source>Discrete input</source>
        <translation>Entrée discrète</translation>
    </message>
    <message>
        <source>Holding register</source>
        <translation>Registre de maintien</translation>
    </message>
    <message>
        <source>Input register</source>
        <translation>Registre d’entrée</translation>
    </message>
    <message>
        <source>Keep the last value</source>
        <translation>Garder la dernière valeur</translation>
    </message>
    <message>
        <source>Use the safe value</source>
        <translation>Utiliser la valeur sûre</translation>
    </message>
    <message>
        <source>Stop the controller</source>
        <translation>Arrêter l’automate</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Paire</translation>
    </message>
    <message>
        <source>Odd</source>
        <translation>Impaire</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Sortie</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Oui</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Non</translation>
    </message>
</context>
<context>
    <name>Devices</name>
    <message>
        <source>This is not valid JSON; check the commas and quotes in front of this line</source>
        <translation>Ce n’est pas du JSON valide&#x202f;; vérifiez les virgules et les guillemets avant cette ligne</translation>
    </message>
    <message>
        <source>The file must be an object with a list named &quot;devices&quot;</source>
        <translation>Le fichier doit être un objet avec une liste nommée «&#xa0;devices&#xa0;»</translation>
    </message>
    <message>
        <source>Each entry of &quot;{0}&quot; must be an object in braces</source>
        <translation>Chaque élément de «&#xa0;{0}&#xa0;» doit être un objet entre accolades</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is missing; add it</source>
        <translation>«&#xa0;{0}&#xa0;» manque&#x202f;; ajoutez-le</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a text in quotes</source>
        <translation>«&#xa0;{0}&#xa0;» doit être un texte entre guillemets</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be true or false</source>
        <translation>«&#xa0;{0}&#xa0;» doit être true ou false</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a number</source>
        <translation>«&#xa0;{0}&#xa0;» doit être un nombre</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a whole number from {1} to {2}</source>
        <translation>«&#xa0;{0}&#xa0;» doit être un entier de {1} à {2}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a time such as &quot;100ms&quot; or &quot;2s&quot;, at least {1} ms and at most an hour</source>
        <translation>«&#xa0;{0}&#xa0;» doit être une durée comme «&#xa0;100ms&#xa0;» ou «&#xa0;2s&#xa0;», d’au moins {1}&#xa0;ms et d’une heure au plus</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; cannot be {1}; choose one of: {2}</source>
        <translation>«&#xa0;{0}&#xa0;» ne peut pas être {1}&#x202f;; choisissez parmi&#xa0;: {2}</translation>
    </message>
    <message>
        <source>There is no field &quot;{0}&quot;; it is kept but has no effect</source>
        <translation>Le champ «&#xa0;{0}&#xa0;» n’existe pas&#x202f;; il est conservé, mais sans effet</translation>
    </message>
    <message>
        <source>There is no field &quot;{0}&quot;; did you mean &quot;{1}&quot;?</source>
        <translation>Le champ «&#xa0;{0}&#xa0;» n’existe pas&#x202f;; vouliez-vous dire «&#xa0;{1}&#xa0;»&#x202f;?</translation>
    </message>
    <message>
        <source>There are two devices named {0}; rename one</source>
        <translation>Deux appareils se nomment {0}&#x202f;; renommez l’un d’eux</translation>
    </message>
    <message>
        <source>{0} has two channels named {1}; rename one</source>
        <translation>{0} a deux voies nommées {1}&#x202f;; renommez l’une d’elles</translation>
    </message>
    <message>
        <source>{0} is not a name; use letters, digits and underscores, and begin with a letter</source>
        <translation>{0} n’est pas un nom valide&#x202f;; utilisez des lettres, des chiffres et des traits de soulignement, en commençant par une lettre</translation>
    </message>
    <message>
        <source>{0} is neither a host name nor an address, for example plc1.local or 192.168.0.10</source>
        <translation>{0} n’est ni un nom d’hôte ni une adresse, par exemple plc1.local ou 192.168.0.10</translation>
    </message>
    <message>
        <source>{0} is not a serial port; write its path, for example /dev/ttyUSB0</source>
        <translation>{0} n’est pas un port série&#x202f;; écrivez son chemin, par exemple /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>{0} and {1} both listen on port {2}; change one of the ports</source>
        <translation>{0} et {1} écoutent tous deux sur le port {2}&#x202f;; changez l’un d’eux</translation>
    </message>
    <message>
        <source>Ports below 1024 require special privileges; use a port such as 1502</source>
        <translation>Les ports inférieurs à 1024 demandent des droits particuliers&#x202f;; utilisez un port tel que 1502</translation>
    </message>
    <message>
        <source>A channel of an MQTT device needs a &quot;topic&quot;, for example &quot;plant/level&quot;</source>
        <translation>Une voie d’un appareil MQTT demande un «&#xa0;topic&#xa0;», par exemple «&#xa0;plant/level&#xa0;»</translation>
    </message>
    <message>
        <source>{0}: a channel has one topic, without the wildcards + and #</source>
        <translation>{0}&#xa0;: une voie a un seul topic, sans les jokers + et #</translation>
    </message>
    <message>
        <source>{0} is not a path into JSON; write for example /sensor/temperature</source>
        <translation>{0} n’est pas un chemin dans du JSON&#x202f;; écrivez par exemple /sensor/temperature</translation>
    </message>
    <message>
        <source>A device does not let others write its table &quot;{0}&quot;; use &quot;coil&quot; or &quot;holding&quot;, or the direction &quot;in&quot;</source>
        <translation>Un appareil ne laisse pas écrire sa table «&#xa0;{0}&#xa0;»&#x202f;; utilisez «&#xa0;coil&#xa0;» ou «&#xa0;holding&#xa0;», ou la direction «&#xa0;in&#xa0;»</translation>
    </message>
    <message>
        <source>Clients cannot write the table &quot;{0}&quot; of a server; use &quot;coil&quot; or &quot;holding&quot;, or the direction &quot;out&quot;</source>
        <translation>Les clients ne peuvent pas écrire la table «&#xa0;{0}&#xa0;» d’un serveur&#x202f;; utilisez «&#xa0;coil&#xa0;» ou «&#xa0;holding&#xa0;», ou la direction «&#xa0;out&#xa0;»</translation>
    </message>
    <message>
        <source>{0} needs {1} {1:register|registers} from {2}, but 65535 is the last; choose a lower address</source>
        <translation>{0} demande {1} {1:registre|registres} à partir de {2}, mais 65535 est le dernier&#x202f;; choisissez une adresse plus basse</translation>
    </message>
    <message>
        <source>&quot;bit&quot; selects one bit of a register; the type must then be BOOL</source>
        <translation>«&#xa0;bit&#xa0;» choisit un bit d’un registre&#x202f;; le type doit alors être BOOL</translation>
    </message>
    <message>
        <source>The table &quot;{0}&quot; holds bits; the type must be BOOL</source>
        <translation>La table «&#xa0;{0}&#xa0;» contient des bits&#x202f;; le type doit être BOOL</translation>
    </message>
    <message>
        <source>A BOOL in a register needs &quot;bit&quot;, from 0 to 15</source>
        <translation>Un BOOL dans un registre demande «&#xa0;bit&#xa0;», de 0 à 15</translation>
    </message>
    <message>
        <source>Only an MQTT channel can be of type STRING; use a number or BOOL</source>
        <translation>Seule une voie MQTT peut être de type STRING&#x202f;; utilisez un nombre ou BOOL</translation>
    </message>
    <message>
        <source>&quot;scale&quot; must not be 0; omit it for 1</source>
        <translation>«&#xa0;scale&#xa0;» ne doit pas être 0&#x202f;; omettez-le pour 1</translation>
    </message>
    <message>
        <source>A {0} has no &quot;scale&quot; and &quot;offset&quot;; remove them</source>
        <translation>{0} n’a ni «&#xa0;scale&#xa0;» ni «&#xa0;offset&#xa0;»&#x202f;; supprimez-les</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}&#xa0;: {1}</translation>
    </message>
    <message>
        <source>{0} has no variable yet; enter one, or have the addresses proposed (stepwise devices PROJECT --propose)</source>
        <translation>{0} n’a pas encore de variable&#x202f;; nommez-en une ou faites proposer les adresses (stepwise devices PROJECT --propose)</translation>
    </message>
    <message>
        <source>{0} is of type {1} and cannot hold a {2}; use a variable of that type</source>
        <translation>{0} est de type {1} et ne peut pas contenir un {2}&#x202f;; utilisez une variable de ce type</translation>
    </message>
    <message>
        <source>A {0} may not fit into {1} of type {2}; a value that does not fit leaves the variable as it is and makes the channel bad</source>
        <translation>Un {0} peut ne pas tenir dans {1} de type {2}&#x202f;; une valeur trop grande laisse la variable telle quelle et invalide la voie</translation>
    </message>
    <message>
        <source>{0} is an output of the program; an input channel needs %I or a variable</source>
        <translation>{0} est une sortie du programme&#x202f;; une voie d’entrée demande %I ou une variable</translation>
    </message>
    <message>
        <source>{0} is an input of the program; an output channel needs %Q or a variable</source>
        <translation>{0} est une entrée du programme&#x202f;; une voie de sortie demande %Q ou une variable</translation>
    </message>
    <message>
        <source>{0} is a constant and cannot be written; choose a variable</source>
        <translation>{0} est une constante et ne peut pas être écrite&#x202f;; choisissez une variable</translation>
    </message>
    <message>
        <source>{0} reports the quality of the channel and must be a BOOL or an integer</source>
        <translation>{0} indique si la voie est valide et doit être un BOOL ou un entier</translation>
    </message>
    <message>
        <source>{0} reports whether the device responds and must be a BOOL</source>
        <translation>{0} indique si l’appareil répond et doit être un BOOL</translation>
    </message>
    <message>
        <source>&quot;onLoss&quot;: &quot;safe&quot; needs the value in &quot;safe&quot;</source>
        <translation>«&#xa0;onLoss&#xa0;»&#xa0;: «&#xa0;safe&#xa0;» demande la valeur dans «&#xa0;safe&#xa0;»</translation>
    </message>
    <message>
        <source>{0} cannot be read; its first line must be the password</source>
        <translation>{0} ne peut pas être lu&#x202f;; sa première ligne doit être le mot de passe</translation>
    </message>
    <message>
        <source>{0} cannot be read; it must contain the certificates of the authority (PEM)</source>
        <translation>{0} ne peut pas être lu&#x202f;; il doit contenir les certificats de l’autorité (PEM)</translation>
    </message>
    <message>
        <source>no response within {0} ms; check the cable, the address and the unit number</source>
        <translation>pas de réponse en {0}&#xa0;ms&#x202f;; vérifiez le câble, l’adresse et le numéro d’unité</translation>
    </message>
    <message>
        <source>the connection ended: {0}; it is being set up again</source>
        <translation>la connexion a été interrompue&#xa0;: {0}&#x202f;; elle est en cours de rétablissement</translation>
    </message>
    <message>
        <source>the response does not match the request; check baud rate, parity and unit number</source>
        <translation>la réponse ne correspond pas à la requête&#x202f;; vérifiez la vitesse de transmission, la parité et le numéro d’unité</translation>
    </message>
    <message>
        <source>the device rejects {0} {1}: {2}</source>
        <translation>l’appareil refuse {0} {1}&#xa0;: {2}</translation>
    </message>
    <message>
        <source>it does not know the function; choose another table</source>
        <translation>il ne connaît pas la fonction&#x202f;; choisissez une autre table</translation>
    </message>
    <message>
        <source>it has no such address; check the address in its manual</source>
        <translation>il n’a pas cette adresse&#x202f;; vérifiez l’adresse dans son manuel</translation>
    </message>
    <message>
        <source>it does not accept the value; check the range in its manual</source>
        <translation>il n’accepte pas la valeur&#x202f;; vérifiez la plage dans son manuel</translation>
    </message>
    <message>
        <source>it reports a failure; check the device</source>
        <translation>il signale une défaillance&#x202f;; vérifiez l’appareil</translation>
    </message>
    <message>
        <source>it is busy; the request will be repeated</source>
        <translation>il est occupé&#x202f;; la requête sera répétée</translation>
    </message>
    <message>
        <source>the gateway cannot reach it; check the unit number and the cable after the gateway</source>
        <translation>la passerelle ne l’atteint pas&#x202f;; vérifiez le numéro d’unité et le câble derrière elle</translation>
    </message>
    <message>
        <source>cannot listen on {0}: {1}; choose another address or port</source>
        <translation>écoute impossible sur {0}&#xa0;: {1}&#x202f;; choisissez une autre adresse ou un autre port</translation>
    </message>
    <message>
        <source>{0}: the message holds no value that can be read; check what the device publishes</source>
        <translation>{0}&#xa0;: le message ne contient aucune valeur lisible&#x202f;; vérifiez ce que l’appareil publie</translation>
    </message>
    <message>
        <source>{0}: a value does not fit into the variable; use a larger type or a scale</source>
        <translation>{0}&#xa0;: une valeur ne tient pas dans la variable&#x202f;; utilisez un type plus grand ou une échelle</translation>
    </message>
    <message>
        <source>no client has written for {0} ms; check the client and its address</source>
        <translation>aucun client n’a écrit depuis {0}&#xa0;ms&#x202f;; vérifiez le client et son adresse</translation>
    </message>
    <message>
        <source>the broker rejects the connection: {0}; check the user and the password</source>
        <translation>le broker refuse la connexion&#xa0;: {0}&#x202f;; vérifiez l’utilisateur et le mot de passe</translation>
    </message>
    <message>
        <source>the input {0} of the device {1} was lost; check the device and its cable</source>
        <translation>l’entrée {0} de l’appareil {1} a été perdue&#x202f;; vérifiez l’appareil et son câble</translation>
    </message>
    <message>
        <source>the input {0} of the device {1} was lost: {2}</source>
        <translation>l’entrée {0} de l’appareil {1} a été perdue&#xa0;: {2}</translation>
    </message>
    <message>
        <source>Start or build the project first; the devices are connected to its controller</source>
        <translation>Démarrez ou compilez d’abord le projet&#x202f;; les appareils sont reliés à son automate</translation>
    </message>
    <message>
        <source>The project had no devices when its controller was built; add them and build again</source>
        <translation>Le projet n’avait pas d’appareils lors de la compilation de son automate&#x202f;; ajoutez-les et recompilez</translation>
    </message>
    <message>
        <source>The devices had errors when the controller was built; correct them and build again</source>
        <translation>Les appareils comportaient des erreurs lors de la compilation de l’automate&#x202f;; corrigez-les et recompilez</translation>
    </message>
    <message>
        <source>Set the speed to real time first; devices cannot follow any other speed</source>
        <translation>Réglez d’abord la vitesse sur le temps réel&#x202f;; les appareils ne peuvent pas en suivre une autre</translation>
    </message>
    <message>
        <source>The devices of an attached controller are connected there; detach to connect them here</source>
        <translation>Les appareils d’un automate distant sont reliés là-bas&#x202f;; déconnectez-vous pour les relier ici</translation>
    </message>
    <message>
        <source>{0} and {1} write the same bytes: {2}; change an address</source>
        <translation>{0} et {1} écrivent les mêmes octets&#xa0;: {2}&#x202f;; modifiez une adresse</translation>
    </message>
    <message>
        <source>There is no free address left for {0}; give it a variable</source>
        <translation>Il n’y a plus d’adresse libre pour {0}&#x202f;; donnez-lui une variable</translation>
    </message>
    <message>
        <source>{0} has no channels, so nothing is exchanged; add one</source>
        <translation>{0} n’a pas de voies&#x202f;; rien n’est donc échangé&#x202f;; ajoutez-en une</translation>
    </message>
    <message>
        <source>cannot connect to {0}: {1}; check the address and the cable</source>
        <translation>connexion impossible à {0}&#xa0;: {1}&#x202f;; vérifiez l’adresse et le câble</translation>
    </message>
    <message>
        <source>{0} and {1} are both unit {2} of {3}; give one of them another number</source>
        <translation>{0} et {1} ont tous deux l’adresse {2} sur {3}&#x202f;; donnez-en une autre à l’un d’eux</translation>
    </message>
    <message>
        <source>{0} and {1} use {2} with different baud rates, parities or bits; set the same for both</source>
        <translation>{0} et {1} utilisent {2} avec une vitesse, une parité ou un nombre de bits différents&#x202f;; réglez les deux de la même façon</translation>
    </message>
    <message>
        <source>{0} and {1} both set {2} {3}; give each its own</source>
        <translation>{0} et {1} écrivent tous deux {2} {3}&#x202f;; donnez-en un à chacun</translation>
    </message>
    <message>
        <source>{0} and {1} are both unit {2} at {3}; if one was copied from the other, change its address</source>
        <translation>{0} et {1} ont tous deux l’adresse {2} sur {3}&#x202f;; si l’un a été copié de l’autre, changez son adresse</translation>
    </message>
</context>
<context>
    <name>Diagnostics</name>
    <message>
        <source>Unterminated comment; close it with *)</source>
        <translation>Commentaire non terminé&#x202f;; le fermer par *)</translation>
    </message>
    <message>
        <source>Unterminated string; add the closing quote</source>
        <translation>Chaîne non terminée&#x202f;; ajouter le guillemet fermant</translation>
    </message>
    <message>
        <source>Expected {0} before {1}</source>
        <translation>Attendu avant {1}&#xa0;: {0}</translation>
    </message>
    <message>
        <source>A semicolon is missing here; add it</source>
        <translation>Il manque un point-virgule ici&#x202f;; l’ajouter</translation>
    </message>
    <message>
        <source>{0} is missing for this {1}; add it</source>
        <translation>Il manque {0} pour ce {1}&#x202f;; l’ajouter</translation>
    </message>
    <message>
        <source>This comparison has no effect; use := to assign</source>
        <translation>Cette comparaison est sans effet&#x202f;; utiliser := pour affecter</translation>
    </message>
    <message>
        <source>An assignment is not a condition; use = to compare</source>
        <translation>Une affectation n’est pas une condition&#x202f;; utiliser = pour comparer</translation>
    </message>
    <message>
        <source>A colon is missing between the name and its type; add it</source>
        <translation>Il manque un deux-points entre le nom et son type&#x202f;; l’ajouter</translation>
    </message>
    <message>
        <source>Decimal numbers use a point; write {0}</source>
        <translation>Les nombres décimaux utilisent le point&#x202f;; écrire {0}</translation>
    </message>
    <message>
        <source>An open bound is written ARRAY[*] and is only allowed for VAR_IN_OUT; declare it there, or write a number</source>
        <translation>Une borne ouverte s’écrit ARRAY[*] et n’est autorisée que pour VAR_IN_OUT&#x202f;; la déclarer là ou indiquer un nombre</translation>
    </message>
    <message>
        <source>{0} is missing: the program unit ends here; add it</source>
        <translation>Il manque {0}&#xa0;: le POU se termine ici&#x202f;; l’ajouter</translation>
    </message>
    <message>
        <source>A semicolon is missing: the statement ends here; add it</source>
        <translation>Il manque un point-virgule&#xa0;: l’instruction se termine ici&#x202f;; l’ajouter</translation>
    </message>
    <message>
        <source>Implicit conversion from {0} to {1} may lose data; convert it explicitly</source>
        <translation>La conversion implicite de {0} en {1} peut perdre des données&#x202f;; convertir explicitement</translation>
    </message>
    <message>
        <source>{0} is an IN_OUT parameter and needs a variable of type {1}</source>
        <translation>{0} est un paramètre IN_OUT et demande une variable de type {1}</translation>
    </message>
    <message>
        <source>{0} has only the bits 0 to {1}; use one of them</source>
        <translation>{0} n’a que les bits 0 à {1}&#x202f;; utiliser l’un d’eux</translation>
    </message>
    <message>
        <source>{0} is ambiguous: {1}; write the namespace before it</source>
        <translation>{0} est ambigu&#xa0;: {1}&#x202f;; le faire précéder de l’espace de noms</translation>
    </message>
    <message>
        <source>The character {0} is not in STRING ({1}); use WSTRING, or &quot;stringEncoding&quot;: &quot;UTF-8&quot; in project.json</source>
        <translation>Le caractère {0} n’existe pas en STRING ({1})&#x202f;; utiliser WSTRING, ou &quot;stringEncoding&quot;: &quot;UTF-8&quot; dans project.json</translation>
    </message>
    <message>
        <source>{0} and {1} are compared as {2}; convert one of them</source>
        <translation>{0} et {1} sont comparés en {2}&#x202f;; convertir l’un des deux</translation>
    </message>
    <message>
        <source>{0} is not checked against the enumeration {1}; use one of its names</source>
        <translation>{0} n’est pas vérifié par rapport à l’énumération {1}&#x202f;; utiliser l’un de ses noms</translation>
    </message>
    <message>
        <source>{0} is {1}; write {2}</source>
        <translation>{0} est {1}&#x202f;; écrire {2}</translation>
    </message>
    <message>
        <source>{0} contains itself; use a REFERENCE TO</source>
        <translation>{0} se contient lui-même&#x202f;; utiliser un REFERENCE TO</translation>
    </message>
    <message>
        <source>The parameters of {0} must match those of the overridden method; copy its declarations</source>
        <translation>Les paramètres de {0} doivent correspondre à ceux de la méthode redéfinie&#x202f;; copier ses déclarations</translation>
    </message>
    <message>
        <source>There are several programs and no CONFIGURATION; name one of them Main or write a CONFIGURATION</source>
        <translation>Il y a plusieurs programmes et pas de CONFIGURATION&#x202f;; en nommer un Main ou écrire une CONFIGURATION</translation>
    </message>
    <message>
        <source>The range {0}..{1} is not valid: the lower bound is above the upper bound or there are too many elements; correct the bounds</source>
        <translation>La plage {0}..{1} n’est pas valide&#xa0;: la borne inférieure dépasse la borne supérieure ou il y a trop d’éléments&#x202f;; corriger les bornes</translation>
    </message>
    <message>
        <source>{0} has an incomplete address; complete it in a VAR_CONFIG</source>
        <translation>{0} a une adresse incomplète&#x202f;; la compléter dans un VAR_CONFIG</translation>
    </message>
    <message>
        <source>{0} may call itself; the depth of recursion is limited at run time; a loop is safer</source>
        <translation>{0} peut s’appeler lui-même&#x202f;; la profondeur de récursion est limitée à l’exécution&#x202f;; une boucle est plus sûre</translation>
    </message>
    <message>
        <source>The steps before this transition cannot be active together; start them from one simultaneous branch</source>
        <translation>Les étapes avant cette transition ne peuvent pas être actives ensemble&#x202f;; les démarrer par une même divergence simultanée</translation>
    </message>
    <message>
        <source>This transition is always true; the step before it lasts one scan; write the condition to wait for</source>
        <translation>Cette transition est toujours vraie&#x202f;; l’étape qui la précède dure un cycle&#x202f;; écrire la condition à attendre</translation>
    </message>
    <message>
        <source>The qualifier {0} needs a time, for example T#2s</source>
        <translation>Le qualificatif {0} demande un temps, par exemple T#2s</translation>
    </message>
    <message>
        <source>{0} needs a current result; load one with LD</source>
        <translation>{0} demande un résultat courant&#x202f;; en charger un avec LD</translation>
    </message>
    <message>
        <source>{0} is not a value of the strict enumeration {1}; use one of its names</source>
        <translation>{0} n’est pas une valeur de l’énumération stricte {1}&#x202f;; utiliser l’un de ses noms</translation>
    </message>
    <message>
        <source>{0} is a strict enumeration and cannot be used in arithmetic; convert the value with {1}</source>
        <translation>{0} est une énumération stricte et ne peut pas être utilisée dans un calcul&#x202f;; convertir la valeur avec {1}</translation>
    </message>
    <message>
        <source>{0} cannot compare {1} as a whole; compare the members one by one</source>
        <translation>{0} ne peut pas comparer {1} en entier&#x202f;; comparer les membres un par un</translation>
    </message>
    <message>
        <source>A CASE selector must be an integer, enumeration or character, not {0}; use IF and ELSIF</source>
        <translation>Le sélecteur d’un CASE doit être un entier, une énumération ou un caractère, et non {0}&#x202f;; utiliser IF et ELSIF</translation>
    </message>
    <message>
        <source>{0} and {1} share storage at {2}; move one of them or write STRUCT OVERLAP</source>
        <translation>{0} et {1} partagent la mémoire en {2}&#x202f;; déplacer l’un des deux ou écrire STRUCT OVERLAP</translation>
    </message>
    <message>
        <source>A member&apos;s address is relative to the start of its structure (%B4, %X4.1), not {0}</source>
        <translation>L’adresse d’un membre est relative au début de sa structure (%B4, %X4.1), et non {0}</translation>
    </message>
    <message>
        <source>{0} and {1} share the address {2}; {3} is free</source>
        <translation>{0} et {1} partagent l’adresse {2}&#x202f;; {3} est libre</translation>
    </message>
    <message>
        <source>{0} belongs to the chart and must be {1}</source>
        <translation>{0} appartient au grafcet et doit être {1}</translation>
    </message>
    <message>
        <source>{0} has no effect without {1}; declare both</source>
        <translation>{0} est sans effet sans {1}&#x202f;; déclarer les deux</translation>
    </message>
    <message>
        <source>A step lists its actions here; write statements in an ACTION</source>
        <translation>Une étape énumère ici ses actions&#x202f;; écrire les instructions dans une ACTION</translation>
    </message>
    <message>
        <source>No transition leads away from step {0}; the chart ends here; add a TRANSITION if it should go on</source>
        <translation>Aucune transition ne part de l’étape {0}&#x202f;; le grafcet se termine ici&#x202f;; ajouter une TRANSITION s’il doit continuer</translation>
    </message>
    <message>
        <source>{0} is also a variable; steps and calls mean the ACTION; rename one of the two</source>
        <translation>{0} est aussi une variable&#x202f;; les étapes et les appels désignent l’ACTION&#x202f;; renommer l’un des deux</translation>
    </message>
    <message>
        <source>Use {1} instead of {0} in Structured Text</source>
        <translation>En texte structuré, utiliser {1} au lieu de {0}</translation>
    </message>
    <message>
        <source>The task {0} has no INTERVAL above zero and no SINGLE; it runs in every scan; give it an INTERVAL to slow it down</source>
        <translation>La tâche {0} n’a ni INTERVAL supérieur à zéro ni SINGLE&#x202f;; elle s’exécute à chaque cycle&#x202f;; indiquer INTERVAL pour la ralentir</translation>
    </message>
    <message>
        <source>{0} is read as {1}; write a time with its unit</source>
        <translation>{0} est lu comme {1}&#x202f;; écrire un temps avec son unité</translation>
    </message>
    <message>
        <source>The address {0} has {1} {1:bit|bits}, {2} has {3}; write {4}</source>
        <translation>L’adresse {0} a {1} {1:bit|bits}, {2} en a {3}&#x202f;; écrire {4}</translation>
    </message>
    <message>
        <source>{0} is an input declared CONSTANT and is assigned to here; remove CONSTANT or assign to another variable</source>
        <translation>{0} est une entrée déclarée CONSTANT et reçoit une valeur ici&#x202f;; retirer CONSTANT ou affecter à une autre variable</translation>
    </message>
    <message>
        <source>{0}</source>
        <translation>{0}</translation>
    </message>
    <message>
        <source>The condition {0} is not known; combine defined, hasvalue, hasattribute and hastype with NOT, AND and OR</source>
        <translation>La condition {0} est inconnue&#x202f;; combiner defined, hasvalue, hasattribute et hastype avec NOT, AND et OR</translation>
    </message>
    <message>
        <source>The pragma {0} is missing for this {1}; add it</source>
        <translation>Il manque le pragma {0} pour ce {1}&#x202f;; l’ajouter</translation>
    </message>
    <message>
        <source>The character {0} has no meaning here; remove it</source>
        <translation>Le caractère {0} n’a pas de sens ici&#x202f;; le supprimer</translation>
    </message>
    <message>
        <source>This is nested too deeply to be compiled; split it into several statements or units</source>
        <translation>Imbrication trop profonde pour être compilée&#x202f;; la répartir sur plusieurs instructions ou POU</translation>
    </message>
    <message>
        <source>Code in C is not executed; write it in ST</source>
        <translation>Le code en C n’est pas exécuté&#x202f;; l’écrire en ST</translation>
    </message>
    <message>
        <source>{0} is specified twice; remove one of the two</source>
        <translation>{0} est indiqué deux fois&#x202f;; supprimer l’un des deux</translation>
    </message>
    <message>
        <source>{0} is not an array or string; remove the index or declare it as an ARRAY</source>
        <translation>{0} n’est ni un tableau ni une chaîne&#x202f;; supprimer l’indice ou déclarer un ARRAY</translation>
    </message>
    <message>
        <source>The divisor is always zero; divide by another value</source>
        <translation>Le diviseur est toujours nul&#x202f;; diviser par une autre valeur</translation>
    </message>
    <message>
        <source>A constant is needed here; write a value or the name of a VAR CONSTANT</source>
        <translation>Une constante est nécessaire ici&#x202f;; écrire une valeur ou le nom d’une VAR CONSTANT</translation>
    </message>
    <message>
        <source>{0} is not a pointer or reference; use it without ^ or declare it with REF_TO</source>
        <translation>{0} n’est ni un pointeur ni une référence&#x202f;; l’utiliser sans ^ ou le déclarer avec REF_TO</translation>
    </message>
    <message>
        <source>{0} does not return a value; call it in a statement of its own</source>
        <translation>{0} ne renvoie pas de valeur&#x202f;; l’appeler dans une instruction à part</translation>
    </message>
    <message>
        <source>{0} is abstract and cannot be instantiated; use a block that extends it</source>
        <translation>{0} est abstrait et ne peut pas être instancié&#x202f;; utiliser un bloc qui l’étend</translation>
    </message>
    <message>
        <source>{0} is {1} and cannot be used here; make it PUBLIC or use it inside its block</source>
        <translation>{0} est {1} et ne peut pas être utilisé ici&#x202f;; le déclarer PUBLIC ou l’utiliser dans son bloc</translation>
    </message>
    <message>
        <source>The result of {0} is not used; assign it to a variable</source>
        <translation>Le résultat de {0} n’est pas utilisé&#x202f;; l’affecter à une variable</translation>
    </message>
    <message>
        <source>{0} is declared twice; rename or remove one of the two</source>
        <translation>{0} est déclaré deux fois&#x202f;; renommer ou supprimer l’un des deux</translation>
    </message>
    <message>
        <source>There is no type {0}; declare it or add the library that contains it</source>
        <translation>Le type {0} n’existe pas&#x202f;; le déclarer ou ajouter la bibliothèque qui le contient</translation>
    </message>
    <message>
        <source>{0} is never used; remove its declaration</source>
        <translation>{0} n’est jamais utilisé&#x202f;; supprimer sa déclaration</translation>
    </message>
    <message>
        <source>{0} is read but never written; give it a value or declare it as CONSTANT</source>
        <translation>{0} est lu mais jamais écrit&#x202f;; lui donner une valeur ou le déclarer CONSTANT</translation>
    </message>
    <message>
        <source>This is never executed; remove it or change what is before it</source>
        <translation>Ceci n’est jamais exécuté&#x202f;; supprimer ceci ou modifier ce qui précède</translation>
    </message>
    <message>
        <source>The result of {0} is not set on every path; assign it before the first RETURN or IF</source>
        <translation>Le résultat de {0} n’est pas affecté sur tous les chemins&#x202f;; l’affecter avant le premier RETURN ou IF</translation>
    </message>
    <message>
        <source>CASE has no branch for {0} and no ELSE; add one of them</source>
        <translation>CASE n’a ni branche pour {0} ni ELSE&#x202f;; ajouter l’un des deux</translation>
    </message>
    <message>
        <source>{0} already has a branch; remove one of the two</source>
        <translation>{0} a déjà une branche&#x202f;; supprimer l’une des deux</translation>
    </message>
    <message>
        <source>The task {0} is declared twice; rename one of the two</source>
        <translation>La tâche {0} est déclarée deux fois&#x202f;; renommer l’une des deux</translation>
    </message>
    <message>
        <source>There is no task {0}; declare it with TASK in this configuration</source>
        <translation>La tâche {0} n’existe pas&#x202f;; la déclarer avec TASK dans cette configuration</translation>
    </message>
    <message>
        <source>{0} does not implement {1} of {2}; add it</source>
        <translation>{0} n’implémente pas {1} de {2}&#x202f;; l’ajouter</translation>
    </message>
    <message>
        <source>{0} is FINAL and cannot be extended or overridden; remove FINAL or use another base</source>
        <translation>{0} est FINAL et ne peut être ni étendu ni redéfini&#x202f;; supprimer FINAL ou utiliser une autre base</translation>
    </message>
    <message>
        <source>There is no label {0}; write it with a colon before a statement of this unit</source>
        <translation>L’étiquette {0} n’existe pas&#x202f;; l’écrire avec un deux-points devant une instruction de ce POU</translation>
    </message>
    <message>
        <source>The variables need {0} bytes; the maximum is {1}: make arrays or strings smaller</source>
        <translation>Les variables demandent {0} octets&#x202f;; le maximum est {1}&#xa0;: réduire les tableaux ou les chaînes</translation>
    </message>
    <message>
        <source>There is no PROGRAM to run; add one</source>
        <translation>Il n’y a pas de PROGRAM à exécuter&#x202f;; en ajouter un</translation>
    </message>
    <message>
        <source>There is no namespace {0}; declare it or add the library that contains it</source>
        <translation>L’espace de noms {0} n’existe pas&#x202f;; le déclarer ou ajouter la bibliothèque qui le contient</translation>
    </message>
    <message>
        <source>{0} is not a variable of this configuration; write program instance and variable, as in Main.x</source>
        <translation>{0} n’est pas une variable de cette configuration&#x202f;; écrire l’instance de programme et la variable, comme Main.x</translation>
    </message>
    <message>
        <source>{0} restarts on every call because functions keep no state; use a FUNCTION_BLOCK</source>
        <translation>{0} redémarre à chaque appel, car une fonction ne garde pas d’état&#x202f;; utiliser un FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>Too many initial values: {0} for {1} {1:element|elements}; remove some or enlarge the array</source>
        <translation>Trop de valeurs initiales&#xa0;: {0} pour {1} {1:élément|éléments}&#x202f;; en supprimer ou agrandir le tableau</translation>
    </message>
    <message>
        <source>This loop never ends and would stop the controller; give it a condition or an EXIT</source>
        <translation>Cette boucle ne se termine jamais et bloquerait l’automate&#x202f;; lui donner une condition ou un EXIT</translation>
    </message>
    <message>
        <source>{0} is marked OVERRIDE, but no base has a method with this name; remove OVERRIDE or correct the name</source>
        <translation>{0} est marqué OVERRIDE, mais aucune base n’a de méthode de ce nom&#x202f;; supprimer OVERRIDE ou corriger le nom</translation>
    </message>
    <message>
        <source>The chart has no INITIAL_STEP; declare its first step with INITIAL_STEP instead of STEP</source>
        <translation>Le grafcet n’a pas d’INITIAL_STEP&#x202f;; déclarer sa première étape avec INITIAL_STEP au lieu de STEP</translation>
    </message>
    <message>
        <source>The chart has two initial steps: {0} and {1}; declare one of them with STEP</source>
        <translation>Le grafcet a deux étapes initiales&#xa0;: {0} et {1}&#x202f;; déclarer l’une d’elles avec STEP</translation>
    </message>
    <message>
        <source>There is no step {0}; declare it or correct the name</source>
        <translation>L’étape {0} n’existe pas&#x202f;; la déclarer ou corriger le nom</translation>
    </message>
    <message>
        <source>No transition leads to step {0}; it can never become active: add a TRANSITION to it</source>
        <translation>Aucune transition ne mène à l’étape {0}&#x202f;; elle ne peut jamais devenir active&#xa0;: ajouter une TRANSITION vers elle</translation>
    </message>
    <message>
        <source>There is no action or BOOL variable {0}; add an ACTION or declare the variable</source>
        <translation>Il n’y a ni action ni variable BOOL {0}&#x202f;; ajouter une ACTION ou déclarer la variable</translation>
    </message>
    <message>
        <source>The step {0} is declared twice; rename or remove one of the two</source>
        <translation>L’étape {0} est déclarée deux fois&#x202f;; renommer ou supprimer l’une des deux</translation>
    </message>
    <message>
        <source>{0} appears twice in this step with qualifier {1}; remove one of the two</source>
        <translation>{0} apparaît deux fois dans cette étape avec le qualificatif {1}&#x202f;; supprimer l’un des deux</translation>
    </message>
    <message>
        <source>The parenthesis of this instruction is not closed; add an instruction ) after its operands</source>
        <translation>La parenthèse de cette instruction n’est pas fermée&#x202f;; ajouter une instruction ) après ses opérandes</translation>
    </message>
    <message>
        <source>{0} needs memory that the project does not set aside; write &quot;memoryForNew&quot;: 65536 into project.json</source>
        <translation>{0} demande de la mémoire que le projet ne réserve pas&#x202f;; écrire &quot;memoryForNew&quot;: 65536 dans project.json</translation>
    </message>
    <message>
        <source>{0} is not a block of this program and cannot have a task of its own; name one of its blocks</source>
        <translation>{0} n’est pas un bloc de ce programme et ne peut pas avoir sa propre tâche&#x202f;; indiquer l’un de ses blocs</translation>
    </message>
    <message>
        <source>{0} cannot hold an exception code; declare it as __SYSTEM.ExceptionCode</source>
        <translation>{0} ne peut pas contenir de code d’exception&#x202f;; déclarer avec __SYSTEM.ExceptionCode</translation>
    </message>
    <message>
        <source>{0} converts the number, as in CODESYS; to keep the bits, put both types into a UNION</source>
        <translation>{0} convertit le nombre, comme dans CODESYS&#x202f;; pour conserver les bits, placer les deux types dans une UNION</translation>
    </message>
    <message>
        <source>{0} calls itself, which is not allowed: {1}; use a loop instead</source>
        <translation>{0} s’appelle lui-même, ce qui n’est pas autorisé&#xa0;: {1}&#x202f;; utiliser une boucle à la place</translation>
    </message>
    <message>
        <source>The loop variable {0} is changed inside its loop; use WHILE or another variable</source>
        <translation>La variable de boucle {0} est modifiée dans sa boucle&#x202f;; utiliser WHILE ou une autre variable</translation>
    </message>
    <message>
        <source>There is no global variable {0} of type {1}; declare it in VAR_GLOBAL</source>
        <translation>La variable globale {0} de type {1} n’existe pas&#x202f;; la déclarer dans VAR_GLOBAL</translation>
    </message>
    <message>
        <source>The text has {0} and will be truncated to {1}; declare a longer string</source>
        <translation>Le texte a {0} et sera tronqué à {1}&#x202f;; déclarer une chaîne plus longue</translation>
    </message>
    <message>
        <source>This integer division discards the fraction before the conversion to {0}; convert an operand first</source>
        <translation>Cette division entière supprime la partie décimale avant la conversion en {0}&#x202f;; convertir d’abord un opérande</translation>
    </message>
    <message>
        <source>{0} is computed as {1} and may overflow before the conversion to {2}; convert an operand first</source>
        <translation>{0} est calculé en {1} et peut déborder avant la conversion en {2}&#x202f;; convertir d’abord un opérande</translation>
    </message>
    <message>
        <source>{0} is not an IL operator; use one such as LD, ST, AND or JMP</source>
        <translation>{0} n’est pas un opérateur IL&#x202f;; utiliser par exemple LD, ST, AND ou JMP</translation>
    </message>
    <message>
        <source>This array has {0} {0:dimension|dimensions}, not {1}; write an index for each</source>
        <translation>Ce tableau a {0} {0:dimension|dimensions}, et non {1}&#x202f;; écrire un indice pour chacune</translation>
    </message>
    <message>
        <source>{0} is not a valid {1} literal; check its prefix, digits and units</source>
        <translation>{0} n’est pas un littéral valide ({1})&#x202f;; vérifier le préfixe, les chiffres et les unités</translation>
    </message>
    <message>
        <source>Unexpected {0}; remove it or complete the statement before it</source>
        <translation>{0} inattendu&#x202f;; le supprimer ou compléter l’instruction qui précède</translation>
    </message>
    <message>
        <source>The pragma {0} is not known and has no effect; remove it or correct its name</source>
        <translation>Le pragma {0} est inconnu et sans effet&#x202f;; le supprimer ou corriger son nom</translation>
    </message>
    <message>
        <source>{0} is a keyword and cannot be used as a name; choose another name</source>
        <translation>{0} est un mot-clé et ne peut pas servir de nom&#x202f;; choisir un autre nom</translation>
    </message>
    <message>
        <source>{0} is not declared; declare it or correct the name</source>
        <translation>{0} n’est pas déclaré&#x202f;; le déclarer ou corriger le nom</translation>
    </message>
    <message>
        <source>{0} has no member {1}; correct the name or add the member</source>
        <translation>{0} n’a pas de membre {1}&#x202f;; corriger le nom ou ajouter le membre</translation>
    </message>
    <message>
        <source>{0} cannot be converted to {1}; use a value of that type or a conversion function</source>
        <translation>{0} ne peut pas être converti en {1}&#x202f;; utiliser une valeur de ce type ou une fonction de conversion</translation>
    </message>
    <message>
        <source>{0} cannot be assigned to; assign to a variable</source>
        <translation>Il n’est pas possible d’affecter une valeur à {0}&#x202f;; affecter à une variable</translation>
    </message>
    <message>
        <source>{0} cannot be used with {1}; convert the operand first</source>
        <translation>{0} ne peut pas être utilisé avec {1}&#x202f;; convertir d’abord l’opérande</translation>
    </message>
    <message>
        <source>{0} cannot combine {1} and {2}; convert one of them</source>
        <translation>{0} ne peut pas combiner {1} et {2}&#x202f;; convertir l’un des deux</translation>
    </message>
    <message>
        <source>{0} cannot be called; call a function, a method or an instance of a block</source>
        <translation>{0} ne peut pas être appelé&#x202f;; appeler une fonction, une méthode ou une instance de bloc</translation>
    </message>
    <message>
        <source>{0} has no parameter {1}; correct the name or declare the parameter</source>
        <translation>{0} n’a pas de paramètre {1}&#x202f;; corriger le nom ou déclarer le paramètre</translation>
    </message>
    <message>
        <source>The argument for {1} of {0} is missing; add it to the call</source>
        <translation>Il manque l’argument pour {1} de {0}&#x202f;; l’ajouter à l’appel</translation>
    </message>
    <message>
        <source>{0} takes {1} {1:argument|arguments}; remove the others</source>
        <translation>{0} attend {1} {1:argument|arguments}&#x202f;; supprimer les autres</translation>
    </message>
    <message>
        <source>The index {0} is outside {1}..{2}; correct it or enlarge the array</source>
        <translation>L’indice {0} est en dehors de {1}..{2}&#x202f;; corriger l’indice ou agrandir le tableau</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}; use another value or a larger type</source>
        <translation>{0} dépasse la plage de {1}&#x202f;; utiliser une autre valeur ou un type plus grand</translation>
    </message>
    <message>
        <source>The condition must be BOOL, not {0}; add a comparison</source>
        <translation>La condition doit être de type BOOL, et non {0}&#x202f;; ajouter une comparaison</translation>
    </message>
    <message>
        <source>The address {0} is outside {1}; use an address in that range</source>
        <translation>L’adresse {0} est en dehors de {1}&#x202f;; utiliser une adresse de cette plage</translation>
    </message>
    <message>
        <source>{0} is not allowed in a watch or binding, which cannot have side effects; do it in the program</source>
        <translation>{0} n’est pas autorisé dans une surveillance ou une liaison de variable, qui doit être sans effet de bord&#x202f;; le faire dans le programme</translation>
    </message>
    <message>
        <source>A reference needs a variable that has an address; assign the value to a variable first</source>
        <translation>Une référence demande une variable qui a une adresse&#x202f;; affecter d’abord la valeur à une variable</translation>
    </message>
    <message>
        <source>An index must be an integer, not {0}; convert it</source>
        <translation>Un indice doit être un entier, et non {0}&#x202f;; le convertir</translation>
    </message>
    <message>
        <source>{1} cannot extend {0}; choose a base of the same kind</source>
        <translation>{1} ne peut pas étendre {0}&#x202f;; choisir une base du même genre</translation>
    </message>
    <message>
        <source>{0} is not allowed {1}; move or remove it</source>
        <translation>{0} n’est pas autorisé {1}&#x202f;; le déplacer ou le supprimer</translation>
    </message>
    <message>
        <source>{0} is only allowed inside a loop; move or remove it</source>
        <translation>{0} n’est autorisé que dans une boucle&#x202f;; le déplacer ou le supprimer</translation>
    </message>
    <message>
        <source>Step {0} can become active twice at the same time: the branches from here do not join; join them with one transition</source>
        <translation>L’étape {0} peut devenir active deux fois en même temps&#xa0;: les branches qui partent d’ici ne convergent pas&#x202f;; les réunir par une seule transition</translation>
    </message>
    <message>
        <source>{0} is only allowed in a TEST; move it there</source>
        <translation>{0} n’est autorisé que dans un TEST&#x202f;; l’y déplacer</translation>
    </message>
    <message>
        <source>This is not text in UTF-8; save the file as UTF-8, or remove it from the project if it is not a text file</source>
        <translation>Ce n’est pas du texte en UTF-8&#x202f;; enregistrer le fichier en UTF-8, ou le retirer du projet si ce n’est pas un fichier texte</translation>
    </message>
    <message>
        <source>{0} is not an action qualifier; use N, R, S, L, D, P, P0, P1, SD, DS or SL</source>
        <translation>{0} n’est pas un qualificatif d’action&#x202f;; utiliser N, R, S, L, D, P, P0, P1, SD, DS ou SL</translation>
    </message>
    <message>
        <source>{0} needs a time after :=, for example T#5s; write one or remove the pragma</source>
        <translation>{0} demande un temps après :=, par exemple T#5s&#x202f;; en écrire un ou supprimer le pragma</translation>
    </message>
</context>
<context>
    <name>DiskChange</name>
    <message>
        <source>Changed outside</source>
        <translation>Modifié à l’extérieur</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and here too.</source>
        <translation>%1 a été modifié par un autre programme, et ici aussi.</translation>
    </message>
    <message>
        <source>Compare both side by side, load the file from disk and lose the changes made here, or keep what is here and replace the file with the next save?</source>
        <translation>Comparer les deux côte à côte, charger le fichier du disque et perdre les modifications faites ici, ou garder ce qui est ici et remplacer le fichier au prochain enregistrement&#x202f;?</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Comparer…</translation>
    </message>
    <message>
        <source>Load from Disk</source>
        <translation>Charger du disque</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Garder ma version</translation>
    </message>
</context>
<context>
    <name>EditHistory</name>
    <message>
        <source>&amp;Undo</source>
        <translation>Ann&amp;uler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>division by zero; check the divisor first</source>
        <translation>division par zéro&#x202f;; vérifiez d’abord le diviseur</translation>
    </message>
    <message>
        <source>index {0} is used on an empty array; check its bounds first</source>
        <translation>accès à l’indice {0} d’un tableau vide&#x202f;; vérifiez d’abord ses bornes</translation>
    </message>
    <message>
        <source>index {0} is outside {1}..{2}; use an index in this range or enlarge the array</source>
        <translation>l’indice {0} est en dehors de {1}..{2}&#x202f;; utilisez un indice de cette plage ou agrandissez le tableau</translation>
    </message>
    <message>
        <source>character {0} is read from an empty string; check LEN first</source>
        <translation>lecture du caractère {0} d’une chaîne vide&#x202f;; vérifiez d’abord LEN</translation>
    </message>
    <message>
        <source>character {0} is outside {1}..{2} of the string; use an index in this range</source>
        <translation>le caractère {0} est en dehors de {1}..{2} de la chaîne&#x202f;; utilisez un indice de cette plage</translation>
    </message>
    <message>
        <source>calls are nested too deeply; check for endless recursion</source>
        <translation>les appels sont imbriqués trop profondément&#x202f;; recherchez une récursion sans fin</translation>
    </message>
    <message>
        <source>the called method has no body; override it in the block that is called</source>
        <translation>la méthode appelée n’a pas de corps&#x202f;; redéfinissez-la dans le bloc appelé</translation>
    </message>
    <message>
        <source>the scan was aborted</source>
        <translation>le cycle a été interrompu</translation>
    </message>
    <message>
        <source>there is no expression; enter one</source>
        <translation>il n’y a pas d’expression&#x202f;; saisissez-en une</translation>
    </message>
    <message>
        <source>the program of this scan does not have it; choose a later scan</source>
        <translation>absent du programme de ce cycle&#x202f;; choisissez un cycle ultérieur</translation>
    </message>
    <message>
        <source>has no value here</source>
        <translation>n’a pas de valeur ici</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}&#xa0;: {1}</translation>
    </message>
    <message>
        <source>simulation: {0}</source>
        <translation>simulation&#xa0;: {0}</translation>
    </message>
    <message>
        <source>warm</source>
        <translation>à chaud</translation>
    </message>
    <message>
        <source>cold</source>
        <translation>à froid</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>d’origine</translation>
    </message>
    <message>
        <source>in the middle of a scan</source>
        <translation>au milieu d’un cycle</translation>
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
        <translation>fichier ou dossier introuvable&#x202f;; vérifiez le chemin</translation>
    </message>
    <message>
        <source>permission denied; check the permissions of the file and its folder</source>
        <translation>permission refusée&#x202f;; vérifiez les droits du fichier et de son dossier</translation>
    </message>
    <message>
        <source>no space left on the device; free some space and try again</source>
        <translation>plus d’espace libre sur le périphérique&#x202f;; libérez de l’espace et réessayez</translation>
    </message>
    <message>
        <source>it is a folder; choose a file</source>
        <translation>c’est un dossier&#x202f;; choisissez un fichier</translation>
    </message>
    <message>
        <source>it is not a folder; choose a folder</source>
        <translation>ce n’est pas un dossier&#x202f;; choisissez un dossier</translation>
    </message>
    <message>
        <source>the device reports a read or write error; check the drive or the cable</source>
        <translation>le périphérique signale une erreur de lecture ou d’écriture&#x202f;; vérifiez le disque ou le câble</translation>
    </message>
    <message>
        <source>it already exists; choose another name</source>
        <translation>il existe déjà&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>the file is too large; choose a smaller one</source>
        <translation>le fichier est trop grand&#x202f;; choisissez-en un plus petit</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>This is not a regular file and cannot be replaced; choose another name</source>
        <translation>Ce n’est pas un fichier ordinaire et il ne peut pas être remplacé&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>The recording cannot be written: {0}</source>
        <translation>L’enregistrement ne peut pas être écrit&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The recording cannot be read: {0}</source>
        <translation>L’enregistrement ne peut pas être lu&#xa0;: {0}</translation>
    </message>
    <message>
        <source>This version of Stepwise lays out the program&apos;s variables differently; open the recording with the version that made it</source>
        <translation>Cette version de Stepwise dispose autrement les variables du programme&#x202f;; ouvrez l’enregistrement avec la version qui l’a créé</translation>
    </message>
    <message>
        <source>The recording cannot be opened: {0}</source>
        <translation>L’enregistrement ne peut pas être ouvert&#xa0;: {0}</translation>
    </message>
    <message>
        <source>its program has errors; open the recording with the version of Stepwise that made it</source>
        <translation>son programme contient des erreurs&#x202f;; ouvrez l’enregistrement avec la version de Stepwise qui l’a créé</translation>
    </message>
    <message>
        <source>The recording contains no program; record the run again with this version</source>
        <translation>L’enregistrement ne contient pas de programme&#x202f;; enregistrez de nouveau l’exécution avec cette version</translation>
    </message>
    <message>
        <source>This scan is no longer in the recording; choose a later one</source>
        <translation>Ce cycle n’est plus dans l’enregistrement&#x202f;; choisissez-en un plus récent</translation>
    </message>
    <message>
        <source>The program that recorded this scan is no longer available; choose a scan after the last change of the program</source>
        <translation>Le programme qui a enregistré ce cycle n’est plus disponible&#x202f;; choisissez un cycle postérieur à la dernière modification du programme</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is ambiguous; write one of {1}</source>
        <translation>«&#xa0;{0}&#xa0;» est ambigu&#x202f;; écrivez l’une des formes {1}</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; has no variable &apos;{1}&apos;; did you mean &apos;{2}&apos;?</source>
        <translation>«&#xa0;{0}&#xa0;» n’a pas de variable «&#xa0;{1}&#xa0;»&#x202f;; vouliez-vous dire «&#xa0;{2}&#xa0;»&#x202f;?</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; has no variable &apos;{1}&apos;; check the name</source>
        <translation>«&#xa0;{0}&#xa0;» n’a pas de variable «&#xa0;{1}&#xa0;»&#x202f;; vérifiez le nom</translation>
    </message>
    <message>
        <source>there is no variable &apos;{0}&apos;; did you mean &apos;{1}&apos;?</source>
        <translation>la variable «&#xa0;{0}&#xa0;» n’existe pas&#x202f;; vouliez-vous dire «&#xa0;{1}&#xa0;»&#x202f;?</translation>
    </message>
    <message>
        <source>there is no variable &apos;{0}&apos;; check the name or declare it</source>
        <translation>la variable «&#xa0;{0}&#xa0;» n’existe pas&#x202f;; vérifiez le nom ou déclarez-la</translation>
    </message>
    <message>
        <source>a variable of type {1} has no member &apos;{0}&apos;; check the name</source>
        <translation>une variable de type {1} n’a pas de membre «&#xa0;{0}&#xa0;»&#x202f;; vérifiez le nom</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is a VAR_IN_OUT; write the variable that is connected to it</source>
        <translation>«&#xa0;{0}&#xa0;» est un VAR_IN_OUT&#x202f;; écrivez la variable qui lui est reliée</translation>
    </message>
    <message>
        <source>{0} needs {1} {1:index|indices}, not {2}; write one for each dimension</source>
        <translation>{0} demande {1} {1:indice|indices}, et non {2}&#x202f;; écrivez-en un par dimension</translation>
    </message>
    <message>
        <source>bit {0} is outside 0..{1}; use a bit in this range</source>
        <translation>le bit {0} est en dehors de 0..{1}&#x202f;; utilisez un bit de cette plage</translation>
    </message>
    <message>
        <source>part {0} is outside 0..{1}; use a part in this range</source>
        <translation>la partie {0} est en dehors de 0..{1}&#x202f;; utilisez une partie de cette plage</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is not an address; write for example %IX0.0, %QB4 or %MW2</source>
        <translation>«&#xa0;{0}&#xa0;» n’est pas une adresse&#x202f;; écrivez par exemple %IX0.0, %QB4 ou %MW2</translation>
    </message>
    <message>
        <source>the path cannot be read from &apos;{0}&apos; on; write for example Main.a[2].x</source>
        <translation>le chemin n’est plus lisible à partir de «&#xa0;{0}&#xa0;»&#x202f;; écrivez par exemple Main.a[2].x</translation>
    </message>
    <message>
        <source>{0} is forced; release the force before writing</source>
        <translation>{0} est forcé&#x202f;; levez le forçage avant d’écrire</translation>
    </message>
    <message>
        <source>the variable is not forced; there is nothing to release</source>
        <translation>la variable n’est pas forcée&#x202f;; il n’y a aucun forçage à lever</translation>
    </message>
    <message>
        <source>the initial values of the new program cause a fault: {0}</source>
        <translation>les valeurs initiales du nouveau programme provoquent une erreur&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The retain file cannot be written: {0}</source>
        <translation>Le fichier des valeurs rémanentes ne peut pas être écrit&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The retain file cannot be read: {0}; the program starts with its initial values</source>
        <translation>Le fichier des valeurs rémanentes ne peut pas être lu&#xa0;: {0}&#x202f;; le programme démarre avec ses valeurs initiales</translation>
    </message>
    <message>
        <source>The retain file is damaged; the program starts with its initial values</source>
        <translation>Le fichier des valeurs rémanentes est endommagé&#x202f;; le programme démarre avec ses valeurs initiales</translation>
    </message>
    <message>
        <source>{0}; it is kept as {1}</source>
        <translation>{0}&#x202f;; il est conservé sous {1}</translation>
    </message>
    <message>
        <source>{0} retained {0:value does|values do} not fit the program: {1}; they start with their initial values</source>
        <translation>{0} {0:valeur rémanente ne correspond|valeurs rémanentes ne correspondent} pas au programme&#xa0;: {1}&#x202f;; elles démarrent avec leurs valeurs initiales</translation>
    </message>
    <message>
        <source>{0} does not fit into a variable of type {1}; enter a value in its range</source>
        <translation>{0} dépasse la plage d’une variable de type {1}&#x202f;; entrez une valeur de sa plage</translation>
    </message>
    <message>
        <source>the value does not fit into a variable of type {0}; enter one in its range</source>
        <translation>la valeur dépasse la plage d’une variable de type {0}&#x202f;; entrez-en une de sa plage</translation>
    </message>
    <message>
        <source>{0} is outside {1}..{2}; enter a value in this range</source>
        <translation>{0} est en dehors de {1}..{2}&#x202f;; entrez une valeur de cette plage</translation>
    </message>
    <message>
        <source>a character of the text does not fit into a STRING; use a WSTRING</source>
        <translation>un caractère du texte n’existe pas en STRING&#x202f;; utilisez une WSTRING</translation>
    </message>
    <message>
        <source>a reference can only be set to NULL from outside; assign a variable to it in the program</source>
        <translation>de l’extérieur, une référence ne peut être mise qu’à NULL&#x202f;; affectez-lui une variable dans le programme</translation>
    </message>
    <message>
        <source>{0} is not a value for {1}, which is {2}</source>
        <translation>{0} n’est pas une valeur pour {1} de type {2}</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}, which is {2}</source>
        <translation>{0} dépasse la plage de {1} de type {2}</translation>
    </message>
    <message>
        <source>{0}; {1}</source>
        <translation>{0}&#x202f;; {1}</translation>
    </message>
    <message>
        <source>did you mean {0}?</source>
        <translation>vouliez-vous dire {0}&#x202f;?</translation>
    </message>
    <message>
        <source>its values are {0}</source>
        <translation>ses valeurs sont {0}</translation>
    </message>
    <message>
        <source>write it in quotes, for example {0}; only WSTRING has every character</source>
        <translation>écrivez-le entre apostrophes, par exemple {0}&#x202f;; seul WSTRING a tous les caractères</translation>
    </message>
    <message>
        <source>write it in quotes, for example {0}</source>
        <translation>écrivez-le entre guillemets, par exemple {0}</translation>
    </message>
    <message>
        <source>write one character in quotes, for example {0}</source>
        <translation>écrivez un caractère entre guillemets, par exemple {0}</translation>
    </message>
    <message>
        <source>write all elements, for example {0}, or a single one by its index</source>
        <translation>écrivez tous les éléments, par exemple {0}, ou un seul par son indice</translation>
    </message>
    <message>
        <source>write its members, for example {0}, or a single one by its path</source>
        <translation>écrivez ses membres, par exemple {0}, ou un seul par son chemin</translation>
    </message>
    <message>
        <source>write {0} or {1}</source>
        <translation>écrivez {0} ou {1}</translation>
    </message>
    <message>
        <source>write for example {0}</source>
        <translation>écrivez par exemple {0}</translation>
    </message>
    <message>
        <source>write a number, for example {0}</source>
        <translation>écrivez un nombre, par exemple {0}</translation>
    </message>
    <message>
        <source>write an integer, for example {0}</source>
        <translation>écrivez un entier, par exemple {0}</translation>
    </message>
    <message>
        <source>There is no program to optimise; declare a PROGRAM</source>
        <translation>Il n’y a pas de programme à optimiser&#x202f;; déclarez un PROGRAM</translation>
    </message>
    <message>
        <source>this is local to a running call and has no address of its own; pause in the call to see it</source>
        <translation>ceci est local à un appel en cours et n’a pas d’adresse propre&#x202f;; arrêtez-vous dans l’appel pour le voir</translation>
    </message>
    <message>
        <source>this part of a computed value cannot be shown; assign the value to a variable first</source>
        <translation>cette partie d’une valeur calculée ne peut pas être affichée&#x202f;; affectez d’abord la valeur à une variable</translation>
    </message>
    <message>
        <source>a character of a string has no address of its own; use the whole string</source>
        <translation>un caractère d’une chaîne n’a pas d’adresse propre&#x202f;; utilisez la chaîne entière</translation>
    </message>
    <message>
        <source>this variable cannot be shown; assign it to another variable and watch that one</source>
        <translation>cette variable ne peut pas être affichée&#x202f;; affectez-la à une autre variable et surveillez celle-ci</translation>
    </message>
    <message>
        <source>this array of variable length has no address here; watch the array that is passed to it</source>
        <translation>ce tableau de longueur variable n’a pas d’adresse ici&#x202f;; surveillez le tableau qui lui est passé</translation>
    </message>
    <message>
        <source>the array has no such dimension; count them from 1</source>
        <translation>le tableau n’a pas cette dimension&#x202f;; comptez-les à partir de 1</translation>
    </message>
    <message>
        <source>this has no value</source>
        <translation>ceci n’a pas de valeur</translation>
    </message>
    <message>
        <source>only standard functions can be called here; use a function of the library</source>
        <translation>seules les fonctions standard peuvent être appelées ici&#x202f;; utilisez une fonction de la bibliothèque</translation>
    </message>
    <message>
        <source>a cast to an interface cannot be watched; watch the instance itself</source>
        <translation>une conversion vers une interface ne peut pas être surveillée&#x202f;; surveillez l’instance elle-même</translation>
    </message>
    <message>
        <source>this cannot be evaluated; use variables, operators and standard functions</source>
        <translation>ceci ne peut pas être évalué&#x202f;; utilisez des variables, des opérateurs et des fonctions standard</translation>
    </message>
    <message>
        <source>The code generator failed, which is an error of Stepwise: {0}; report it with the program</source>
        <translation>Le générateur de code a échoué, une erreur de Stepwise&#xa0;: {0}&#x202f;; signalez-la avec le programme</translation>
    </message>
    <message>
        <source>The code generator produced an invalid module, which is an error of Stepwise: {0}; report it with the program</source>
        <translation>Le générateur de code a produit un module incorrect, une erreur de Stepwise&#xa0;: {0}&#x202f;; signalez-la avec le programme</translation>
    </message>
    <message>
        <source>not compiled</source>
        <translation>non compilé</translation>
    </message>
    <message>
        <source>Code for the thread sanitizer needs a process that runs under it</source>
        <translation>Le code pour le détecteur d’accès concurrents demande un processus qui s’exécute avec lui</translation>
    </message>
    <message>
        <source>the program could not be optimised: {0}</source>
        <translation>le programme n’a pas pu être optimisé&#xa0;: {0}</translation>
    </message>
    <message>
        <source>the program has errors; correct them first</source>
        <translation>le programme contient des erreurs&#x202f;; corrigez-les d’abord</translation>
    </message>
    <message>
        <source>the online change waits until the scan that is halted at a breakpoint has ended; press F5 to continue</source>
        <translation>la modification en ligne attend la fin du cycle arrêté à un point d’arrêt&#x202f;; appuyez sur F5 pour continuer</translation>
    </message>
    <message>
        <source>This body is not an instruction list; choose a unit that is written in IL</source>
        <translation>Ce corps n’est pas une liste d’instructions&#x202f;; choisissez un POU écrit en IL</translation>
    </message>
    <message>
        <source>This body is not ST; choose a unit that is written in ST</source>
        <translation>Ce corps n’est pas en ST&#x202f;; choisissez un POU écrit en ST</translation>
    </message>
    <message>
        <source>{0} has no equivalent in an instruction list; write it with simpler statements first</source>
        <translation>{0} n’a pas d’équivalent dans une liste d’instructions&#x202f;; écrivez-le d’abord avec des instructions plus simples</translation>
    </message>
    <message>
        <source>{0} is already written in ST</source>
        <translation>{0} est déjà écrit en ST</translation>
    </message>
    <message>
        <source>{0} is already written in IL</source>
        <translation>{0} est déjà écrit en IL</translation>
    </message>
    <message>
        <source>Fix the text first: {0}</source>
        <translation>Corrigez d’abord le texte&#xa0;: {0}</translation>
    </message>
    <message>
        <source>There is no equivalent in the other language: {0}</source>
        <translation>Il n’y a pas d’équivalent dans l’autre langage&#xa0;: {0}</translation>
    </message>
    <message>
        <source>This is a folder; choose a file</source>
        <translation>C’est un dossier&#x202f;; choisissez un fichier</translation>
    </message>
    <message>
        <source>This is a device; choose a file</source>
        <translation>C’est un périphérique&#x202f;; choisissez un fichier</translation>
    </message>
    <message>
        <source>The file cannot be read: {0}</source>
        <translation>Le fichier ne peut pas être lu&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The file cannot be replaced: {0}</source>
        <translation>Le fichier ne peut pas être remplacé&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The file cannot be written: {0}</source>
        <translation>Le fichier ne peut pas être écrit&#xa0;: {0}</translation>
    </message>
    <message>
        <source>project.json is not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>project.json n’est pas du JSON valide&#x202f;; recherchez une virgule, un guillemet ou un crochet manquant</translation>
    </message>
    <message>
        <source>project.json must contain one JSON object; put its contents in braces</source>
        <translation>project.json doit contenir un objet JSON&#x202f;; mettez son contenu entre accolades</translation>
    </message>
    <message>
        <source>There is no library &quot;{0}&quot;; available are {1}</source>
        <translation>La bibliothèque «&#xa0;{0}&#xa0;» n’existe pas&#x202f;; sont disponibles {1}</translation>
    </message>
    <message>
        <source>There is no library {0}; did you mean {1}?</source>
        <translation>La bibliothèque {0} n’existe pas&#x202f;; vouliez-vous dire {1}&#x202f;?</translation>
    </message>
    <message>
        <source>Specify a project folder or ST files</source>
        <translation>Indiquez un dossier de projet ou des fichiers ST</translation>
    </message>
    <message>
        <source>Specify one project folder or ST files, not both</source>
        <translation>Indiquez un dossier de projet ou des fichiers ST, pas les deux</translation>
    </message>
    <message>
        <source>{0} belongs to a library and cannot be renamed; rename only names of the project</source>
        <translation>{0} appartient à une bibliothèque et ne peut pas être renommé&#x202f;; renommez seulement les noms du projet</translation>
    </message>
    <message>
        <source>{0} is not a valid name; use letters, digits and _, start with a letter and avoid keywords</source>
        <translation>{0} n’est pas un nom valide&#x202f;; utilisez des lettres, des chiffres et _, commencez par une lettre et évitez les mots-clés</translation>
    </message>
    <message>
        <source>The folder cannot be created: {0}</source>
        <translation>Le dossier ne peut pas être créé&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The folder cannot be read: {0}</source>
        <translation>Le dossier ne peut pas être lu&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The file cannot be copied: {0}</source>
        <translation>Le fichier ne peut pas être copié&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The folder already exists and is not empty; choose another name</source>
        <translation>Le dossier existe déjà et n’est pas vide&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>The page cannot be written; check the free space and the permissions of the folder</source>
        <translation>La page ne peut pas être écrite&#x202f;; vérifiez l’espace libre et les droits du dossier</translation>
    </message>
    <message>
        <source>There is no such file in the project; choose one from the project tree</source>
        <translation>Le projet ne contient pas ce fichier&#x202f;; choisissez-en un dans l’arbre du projet</translation>
    </message>
    <message>
        <source>The file&apos;s permissions cannot be changed; change them as the file&apos;s owner</source>
        <translation>Les droits du fichier ne peuvent pas être modifiés&#x202f;; modifiez-les en tant que propriétaire du fichier</translation>
    </message>
    <message>
        <source>The file cannot be removed; check the permissions of the folder</source>
        <translation>Le fichier ne peut pas être supprimé&#x202f;; vérifiez les droits du dossier</translation>
    </message>
    <message>
        <source>The file cannot be renamed; check the permissions of the folder</source>
        <translation>Le fichier ne peut pas être renommé&#x202f;; vérifiez les droits du dossier</translation>
    </message>
    <message>
        <source>Open a project first</source>
        <translation>Ouvrez d’abord un projet</translation>
    </message>
    <message>
        <source>This statement is not possible in a TEST together with RUN or ASSERT around it; move it out of RUN and ASSERT</source>
        <translation>Cette instruction n’est pas possible dans un TEST avec RUN ou ASSERT autour d’elle&#x202f;; sortez-la de RUN et ASSERT</translation>
    </message>
    <message>
        <source>The code of this statement is missing</source>
        <translation>Le code de cette instruction manque</translation>
    </message>
    <message>
        <source>Fault in the test: {0}</source>
        <translation>Erreur dans le test&#xa0;: {0}</translation>
    </message>
    <message>
        <source>{0} is not a value for {1}; write a value of its type</source>
        <translation>{0} n’est pas une valeur pour {1}&#x202f;; écrivez une valeur de son type</translation>
    </message>
    <message>
        <source>The simulation stopped: {0}</source>
        <translation>La simulation s’est arrêtée&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The controller stopped: {0}</source>
        <translation>L’automate s’est arrêté&#xa0;: {0}</translation>
    </message>
    <message>
        <source>at {0}:{1}</source>
        <translation>à {0}:{1}</translation>
    </message>
    <message>
        <source>{0} has no value: {1}</source>
        <translation>{0} n’a pas de valeur&#xa0;: {1}</translation>
    </message>
    <message>
        <source>{0} did not become true within {1}; check the condition or allow more time</source>
        <translation>{0} n’est pas devenu vrai en {1}&#x202f;; vérifiez la condition ou laissez plus de temps</translation>
    </message>
    <message>
        <source>ASSERT failed: {0}</source>
        <translation>Échec d’ASSERT&#xa0;: {0}</translation>
    </message>
    <message>
        <source>ASSERT failed: {0} ({1})</source>
        <translation>Échec d’ASSERT&#xa0;: {0} ({1})</translation>
    </message>
    <message>
        <source>A coil writes a variable; enter the name of one.</source>
        <translation>Une bobine écrit une variable&#x202f;; saisissez son nom.</translation>
    </message>
    <message>
        <source>A pin has no contacts; type an expression.</source>
        <translation>Une broche n’a pas de contacts&#x202f;; saisissez une expression.</translation>
    </message>
    <message>
        <source>A rung cannot be moved into itself; choose a place outside it.</source>
        <translation>Un réseau ne peut pas être déplacé dans lui-même&#x202f;; choisissez un emplacement à l’extérieur.</translation>
    </message>
    <message>
        <source>A rung moves within its block of statements; use cut and paste in the text for more.</source>
        <translation>Un réseau se déplace au sein de son bloc d’instructions&#x202f;; au-delà, utilisez couper et coller dans le texte.</translation>
    </message>
    <message>
        <source>Delete the call in the text: other statements may use its outputs.</source>
        <translation>Supprimez l’appel dans le texte&#xa0;: d’autres instructions peuvent utiliser ses sorties.</translation>
    </message>
    <message>
        <source>Delete this output in the text.</source>
        <translation>Supprimez cette sortie dans le texte.</translation>
    </message>
    <message>
        <source>Other outputs depend on the same IF; give this coil a rung of its own first.</source>
        <translation>D’autres sorties dépendent du même IF&#x202f;; donnez d’abord à cette bobine son propre réseau.</translation>
    </message>
    <message>
        <source>Select a box with text.</source>
        <translation>Sélectionnez une boîte contenant du texte.</translation>
    </message>
    <message>
        <source>Select a coil.</source>
        <translation>Sélectionnez une bobine.</translation>
    </message>
    <message>
        <source>Select a contact or a wire.</source>
        <translation>Sélectionnez un contact ou une liaison.</translation>
    </message>
    <message>
        <source>Select a contact, a pin or a coil.</source>
        <translation>Sélectionnez un contact, une broche ou une bobine.</translation>
    </message>
    <message>
        <source>Select a rung with contacts.</source>
        <translation>Sélectionnez un réseau avec des contacts.</translation>
    </message>
    <message>
        <source>Select a rung with one output.</source>
        <translation>Sélectionnez un réseau avec une seule sortie.</translation>
    </message>
    <message>
        <source>Select the rung beside which it is inserted.</source>
        <translation>Sélectionnez le réseau à côté duquel insérer.</translation>
    </message>
    <message>
        <source>Select the rung that the comment belongs to.</source>
        <translation>Sélectionnez le réseau auquel appartient le commentaire.</translation>
    </message>
    <message>
        <source>Select what is to be changed.</source>
        <translation>Sélectionnez ce qui doit être modifié.</translation>
    </message>
    <message>
        <source>Select what is to be deleted.</source>
        <translation>Sélectionnez ce qui doit être supprimé.</translation>
    </message>
    <message>
        <source>Several variables are assigned in one statement; separate them in the text first.</source>
        <translation>Plusieurs variables sont affectées dans une même instruction&#x202f;; séparez-les d’abord dans le texte.</translation>
    </message>
    <message>
        <source>Statements on one line cannot be moved; separate them in the text first.</source>
        <translation>Des instructions sur la même ligne ne peuvent pas être déplacées&#x202f;; séparez-les d’abord dans le texte.</translation>
    </message>
    <message>
        <source>The rung reads what it writes; add this coil in a rung of its own.</source>
        <translation>Le réseau lit ce qu’il écrit&#x202f;; ajoutez cette bobine dans un réseau à part.</translation>
    </message>
    <message>
        <source>There is no function block {0}; declare it or check the name.</source>
        <translation>Il n’y a pas de bloc fonctionnel {0}&#x202f;; déclarez-le ou vérifiez le nom.</translation>
    </message>
    <message>
        <source>This edit cannot be made in the picture; edit the text.</source>
        <translation>Cette modification n’est pas possible dans le schéma&#x202f;; modifiez le texte.</translation>
    </message>
    <message>
        <source>This element has no operand; select a contact, a pin or a coil.</source>
        <translation>Cet élément n’a pas d’opérande&#x202f;; sélectionnez un contact, une broche ou une bobine.</translation>
    </message>
    <message>
        <source>This is not a statement: {0}</source>
        <translation>Ce n’est pas une instruction&#xa0;: {0}</translation>
    </message>
    <message>
        <source>This is not an expression: {0}</source>
        <translation>Ce n’est pas une expression&#xa0;: {0}</translation>
    </message>
    <message>
        <source>This rung has no condition; put it under IF in the text.</source>
        <translation>Ce réseau n’a pas de condition&#x202f;; placez-le sous un IF dans le texte.</translation>
    </message>
    <message>
        <source>{0} is {1}</source>
        <translation>{0} est {1}</translation>
    </message>
    <message>
        <source>{0} is {1}, expected {2} {3}</source>
        <translation>{0} est {1}, attendu {2} {3}</translation>
    </message>
    <message>
        <source>{0} is {1}, recorded {2} in scan {3}</source>
        <translation>{0} est {1}, enregistré {2} au cycle {3}</translation>
    </message>
    <message>
        <source>The recording {0} has {1} {1:scan|scans}, this run {2}</source>
        <translation>L’enregistrement {0} a {1} {1:cycle|cycles}, cette exécution {2}</translation>
    </message>
    <message>
        <source>The run differs from the recording {0}; delete it to record it again, if the new behaviour is right</source>
        <translation>L’exécution diffère de l’enregistrement {0}&#x202f;; supprimez-le pour enregistrer de nouveau, si le nouveau comportement est juste</translation>
    </message>
    <message>
        <source>the condition cannot be evaluated; use variables, operators and standard functions</source>
        <translation>la condition ne peut pas être évaluée&#x202f;; utilisez des variables, des opérateurs et des fonctions standard</translation>
    </message>
    <message>
        <source>There is no action {0}; add it or correct the name</source>
        <translation>L’action {0} n’existe pas&#x202f;; ajoutez-la ou corrigez le nom</translation>
    </message>
    <message>
        <source>{0} is not a valid name; use letters, digits and underscores</source>
        <translation>{0} n’est pas un nom valide&#x202f;; utilisez des lettres, des chiffres et le trait de soulignement</translation>
    </message>
    <message>
        <source>The initial step stays at the top; make another step the initial step first</source>
        <translation>L’étape initiale reste en haut&#x202f;; faites d’abord d’une autre étape l’étape initiale</translation>
    </message>
    <message>
        <source>Only a step with a single transition of its own can be moved; move it in the text</source>
        <translation>Seule une étape dotée d’une seule transition propre peut être déplacée&#x202f;; déplacez-la dans le texte</translation>
    </message>
    <message>
        <source>The step is already there; choose another place</source>
        <translation>L’étape s’y trouve déjà&#x202f;; choisissez un autre endroit</translation>
    </message>
    <message>
        <source>A step can be placed after a transition that leads to one step; choose such a transition</source>
        <translation>Une étape se place après une transition qui mène à une seule étape&#x202f;; choisissez une telle transition</translation>
    </message>
    <message>
        <source>This step only leads to itself; connect it to another step first</source>
        <translation>Cette étape ne mène qu’à elle-même&#x202f;; reliez-la d’abord à une autre étape</translation>
    </message>
    <message>
        <source>A transition needs a condition; enter one, for example Main.done</source>
        <translation>Une transition demande une condition&#x202f;; entrez-en une, par exemple Main.done</translation>
    </message>
    <message>
        <source>A priority must be a positive number; enter 1 or more</source>
        <translation>Une priorité doit être un nombre positif&#x202f;; entrez 1 ou plus</translation>
    </message>
    <message>
        <source>Nothing follows this step yet; insert a step after it first</source>
        <translation>Rien ne suit encore cette étape&#x202f;; insérez d’abord une étape après elle</translation>
    </message>
    <message>
        <source>There is no such action; select one that is in the chart</source>
        <translation>Cette action n’existe pas&#x202f;; sélectionnez-en une du grafcet</translation>
    </message>
    <message>
        <source>The initial step cannot be deleted; make another step the initial step first</source>
        <translation>L’étape initiale ne peut pas être supprimée&#x202f;; définissez d’abord une autre étape comme étape initiale</translation>
    </message>
    <message>
        <source>Several transitions leave this step; delete its branches first</source>
        <translation>Plusieurs transitions quittent cette étape&#x202f;; supprimez d’abord ses branches</translation>
    </message>
    <message>
        <source>The condition of this transition cannot be read; edit it in the text</source>
        <translation>La condition de cette transition n’est pas lisible&#x202f;; modifiez-la dans le texte</translation>
    </message>
    <message>
        <source>The branches after this transition do not join; connect them in the text first</source>
        <translation>Les branches après cette transition ne convergent pas&#x202f;; reliez-les d’abord dans le texte</translation>
    </message>
    <message>
        <source>A panel must be a JSON object; put its contents in braces</source>
        <translation>Une vue doit être un objet JSON&#x202f;; mettez son contenu entre accolades</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a list; put it in square brackets</source>
        <translation>«&#xa0;{0}&#xa0;» doit être une liste&#x202f;; mettez-la entre crochets</translation>
    </message>
    <message>
        <source>Element {0} is not an object; put it in braces</source>
        <translation>L’élément {0} n’est pas un objet&#x202f;; mettez-le entre accolades</translation>
    </message>
    <message>
        <source>The kind of element {0} is not a text; write it in quotes</source>
        <translation>Le type de l’élément {0} n’est pas un texte&#x202f;; écrivez-le entre guillemets</translation>
    </message>
    <message>
        <source>Two elements have the id &quot;{0}&quot;; change one of them</source>
        <translation>Deux éléments ont l’identifiant «&#xa0;{0}&#xa0;»&#x202f;; modifiez l’un des deux</translation>
    </message>
    <message>
        <source>Every alarm and every alarm class must be a JSON object; put it in braces</source>
        <translation>Chaque alarme et chaque classe d’alarme doit être un objet JSON&#x202f;; mettez-la entre accolades</translation>
    </message>
    <message>
        <source>This line is not valid UTF-8; save the file as UTF-8</source>
        <translation>Cette ligne n’est pas de l’UTF-8 valide&#x202f;; enregistrez le fichier en UTF-8</translation>
    </message>
    <message>
        <source>There is text after a closing quote; double a quote that belongs to the text</source>
        <translation>Du texte suit un guillemet fermant&#x202f;; doublez un guillemet qui appartient au texte</translation>
    </message>
    <message>
        <source>The first line must be {0} and one language tag per column</source>
        <translation>La première ligne doit être {0} suivi d’une étiquette de langue par colonne</translation>
    </message>
    <message>
        <source>This line has {0} {0:field|fields}, the header has {1}; put texts with separators in quotes</source>
        <translation>Cette ligne a {0} {0:champ|champs}, l’en-tête en a {1}&#x202f;; mettez entre guillemets les textes qui contiennent des séparateurs</translation>
    </message>
    <message>
        <source>The alarm history cannot be opened: {0}</source>
        <translation>L’historique des alarmes ne peut pas être ouvert&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The alarm history cannot be used: {0}</source>
        <translation>L’historique des alarmes ne peut pas être utilisé&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The alarm history cannot be written: {0}</source>
        <translation>L’historique des alarmes ne peut pas être écrit&#xa0;: {0}</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}; use a larger type or a smaller limit</source>
        <translation>{0} dépasse la plage de {1}&#x202f;; utilisez un type plus grand ou une limite plus petite</translation>
    </message>
    <message>
        <source>STRING contains characters of {0} only; declare the variable as WSTRING</source>
        <translation>STRING ne contient que des caractères de {0}&#x202f;; déclarez la variable en WSTRING</translation>
    </message>
    <message>
        <source>A {0} cannot be written from a panel; write its members one by one</source>
        <translation>Un {0} ne peut pas être écrit depuis une vue&#x202f;; écrivez ses membres un à un</translation>
    </message>
    <message>
        <source>The folder for the pictures cannot be created; check the path and its permissions</source>
        <translation>Le dossier des images ne peut pas être créé&#x202f;; vérifiez le chemin et ses droits</translation>
    </message>
    <message>
        <source>The picture cannot be written; check the free space and the permissions of the folder</source>
        <translation>L’image ne peut pas être écrite&#x202f;; vérifiez l’espace libre et les droits du dossier</translation>
    </message>
    <message>
        <source>The project has no such panel; choose one from hmi/</source>
        <translation>Le projet n’a pas cette vue&#x202f;; choisissez-en une dans hmi/</translation>
    </message>
    <message>
        <source>The text &quot;{0}&quot; has no key, so it cannot be translated; move it into the text table</source>
        <translation>Le texte «&#xa0;{0}&#xa0;» n’a pas de clé et ne peut donc pas être traduit&#x202f;; déplacez-le dans la table des textes</translation>
    </message>
    <message>
        <source>The text needs a value for {0}; specify it in &quot;Values in texts&quot;</source>
        <translation>Le texte demande une valeur pour {0}&#x202f;; indiquez-la dans «&#xa0;Valeurs des textes&#xa0;»</translation>
    </message>
    <message>
        <source>The text list {0} is empty: there is no key {1}; add it to the text table</source>
        <translation>La liste de textes {0} est vide&#xa0;: la clé {1} n’existe pas&#x202f;; ajoutez-la à la table des textes</translation>
    </message>
    <message>
        <source>This version does not know the element kind &quot;{0}&quot;; it is kept as it is</source>
        <translation>Cette version ne connaît pas le type d’élément «&#xa0;{0}&#xa0;»&#x202f;; il est conservé tel quel</translation>
    </message>
    <message>
        <source>The format {0} is not known; use for example {1} or {2}</source>
        <translation>Le format {0} est inconnu&#x202f;; utilisez par exemple {1} ou {2}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; does not fit: it needs {1} px, the maximum is {2}; make the element wider or the text shorter</source>
        <translation>«&#xa0;{0}&#xa0;» ne tient pas&#xa0;: il faut {1}&#xa0;px, le maximum est {2}&#x202f;; élargissez l’élément ou raccourcissez le texte</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; does not fit: it needs a height of {1} px, the maximum is {2}; make the element taller or the text shorter</source>
        <translation>«&#xa0;{0}&#xa0;» ne tient pas&#xa0;: il faut une hauteur de {1}&#xa0;px, le maximum est {2}&#x202f;; agrandissez l’élément en hauteur ou raccourcissez le texte</translation>
    </message>
    <message>
        <source>{0}; did you mean {1}?</source>
        <translation>{0}&#x202f;; vouliez-vous dire {1}&#x202f;?</translation>
    </message>
    <message>
        <source>{0} is not a variable, so it cannot be written; name a variable</source>
        <translation>{0} n’est pas une variable et ne peut donc pas être écrit&#x202f;; indiquez une variable</translation>
    </message>
    <message>
        <source>{0} is {1}; a BOOL is needed here</source>
        <translation>{0} est {1}&#x202f;; il faut ici un BOOL</translation>
    </message>
    <message>
        <source>{0} is {1}; a number is needed here</source>
        <translation>{0} est {1}&#x202f;; il faut ici un nombre</translation>
    </message>
    <message>
        <source>{0} is {1}; a STRING is needed here</source>
        <translation>{0} est {1}&#x202f;; il faut ici une STRING</translation>
    </message>
    <message>
        <source>{0} is {1}; an array is needed here</source>
        <translation>{0} est {1}&#x202f;; il faut ici un tableau</translation>
    </message>
    <message>
        <source>{0} is {1}; a single value is needed here</source>
        <translation>{0} est {1}&#x202f;; il faut ici une valeur simple</translation>
    </message>
    <message>
        <source>A placeholder is not closed; add {0}</source>
        <translation>Un espace réservé n’est pas fermé&#x202f;; ajoutez {0}</translation>
    </message>
    <message>
        <source>The format {0} is not known; use one such as %.1f</source>
        <translation>Le format {0} est inconnu&#x202f;; utilisez par exemple %.1f</translation>
    </message>
    <message>
        <source>A trace configuration must be a JSON object; put its contents in braces</source>
        <translation>Une configuration de trace doit être un objet JSON&#x202f;; mettez son contenu entre accolades</translation>
    </message>
    <message>
        <source>The trace configuration is invalid: {0}</source>
        <translation>La configuration de trace n’est pas valide&#xa0;: {0}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be {1}</source>
        <translation>«&#xa0;{0}&#xa0;» doit être {1}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is missing; add it</source>
        <translation>«&#xa0;{0}&#xa0;» manque&#x202f;; ajoutez-le</translation>
    </message>
    <message>
        <source>A picture&apos;s name must end in one of {0}</source>
        <translation>Le nom d’une image doit se terminer par {0}</translation>
    </message>
    <message>
        <source>no longer recorded</source>
        <translation>n’est plus enregistré</translation>
    </message>
    <message>
        <source>A recording from a file cannot be written; go back to the running controller first</source>
        <translation>Un enregistrement ouvert depuis un fichier ne peut pas être écrit&#x202f;; revenez d’abord à l’automate en marche</translation>
    </message>
    <message>
        <source>Recorded values cannot be written; resume from here first</source>
        <translation>Des valeurs enregistrées ne peuvent pas être écrites&#x202f;; reprenez d’abord ici</translation>
    </message>
    <message>
        <source>Recorded values cannot be forced; resume from here or go back to live first</source>
        <translation>Des valeurs enregistrées ne peuvent pas être forcées&#x202f;; reprenez ici ou revenez d’abord au direct</translation>
    </message>
    <message>
        <source>A recording from a file cannot be resumed, only what the controller itself recorded; press F5 to run the program</source>
        <translation>Un enregistrement ouvert depuis un fichier ne peut pas être repris, seulement ce que l’automate a lui-même enregistré&#x202f;; appuyez sur F5 pour exécuter le programme</translation>
    </message>
    <message>
        <source>A priority is a number; 0 removes it</source>
        <translation>Une priorité est un nombre&#x202f;; 0 la supprime</translation>
    </message>
    <message>
        <source>This file cannot be imported; PLCopen XML (.xml), TwinCAT (.TcPOU and so on), text of CODESYS (.EXP, .export) and structured text (.st) can be read</source>
        <translation>Ce fichier ne peut pas être importé&#xa0;: PLCopen XML (.xml), TwinCAT (.TcPOU, etc.), texte de CODESYS (.EXP, .export) et texte structuré (.st) peuvent être lus</translation>
    </message>
    <message>
        <source>This XML is neither PLCopen XML nor of TwinCAT or CODESYS; export the project as PLCopen XML and import that file</source>
        <translation>Ce XML n’est ni du PLCopen XML ni de TwinCAT ou CODESYS&#x202f;; exportez le projet en PLCopen XML et importez ce fichier</translation>
    </message>
    <message>
        <source>It contains nothing that can be imported; export the project again with its units</source>
        <translation>Il ne contient rien qui puisse être importé&#x202f;; exportez de nouveau le projet avec ses POU</translation>
    </message>
    <message>
        <source>The folder exists and is not empty; name a new one</source>
        <translation>Le dossier existe et n’est pas vide&#x202f;; indiquez-en un nouveau</translation>
    </message>
    <message>
        <source>The sources have syntax errors; stepwise check lists them</source>
        <translation>Les sources ont des erreurs de syntaxe&#x202f;; stepwise check les énumère</translation>
    </message>
    <message>
        <source>The file is too large to be read; export its parts one by one</source>
        <translation>Le fichier est trop grand pour être lu&#x202f;; exportez ses parties une à une</translation>
    </message>
    <message>
        <source>The file is in the encoding {0}, which is not supported; save it as UTF-8</source>
        <translation>Le fichier est dans l’encodage {0}, qui n’est pas pris en charge&#x202f;; enregistrez-le en UTF-8</translation>
    </message>
    <message>
        <source>The file declares a document type or entities of its own, which is not supported; export it again without them</source>
        <translation>Le fichier déclare un type de document ou des entités propres, ce qui n’est pas pris en charge&#x202f;; exportez-le de nouveau sans eux</translation>
    </message>
    <message>
        <source>The elements of the file are nested too deeply; export its parts one by one</source>
        <translation>Les éléments du fichier sont imbriqués trop profondément&#x202f;; exportez ses parties une à une</translation>
    </message>
    <message>
        <source>This is not well-formed XML: {0}; export the file again</source>
        <translation>Ce XML n’est pas bien formé&#xa0;: {0}&#x202f;; exportez de nouveau le fichier</translation>
    </message>
    <message>
        <source>The file has no elements; export it again</source>
        <translation>Le fichier n’a pas d’éléments&#x202f;; exportez-le de nouveau</translation>
    </message>
    <message>
        <source>This is XML, not structured text; import it (stepwise import --help)</source>
        <translation>C’est du XML, pas du texte structuré&#x202f;; importez-le (stepwise import --help)</translation>
    </message>
    <message>
        <source>Windows-1252 does not have the character {0}; write the file as UTF-8</source>
        <translation>Windows-1252 n’a pas le caractère {0}&#x202f;; écrivez le fichier en UTF-8</translation>
    </message>
    <message>
        <source>The first input and the first output of {0} must be BOOL for it to be part of a rung; choose another block, or call it in the text.</source>
        <translation>La première entrée et la première sortie de {0} doivent être de type BOOL pour qu’il fasse partie d’un réseau&#x202f;; choisissez un autre bloc ou appelez-le dans le texte.</translation>
    </message>
    <message>
        <source>Type a name and a block: T1 : TON</source>
        <translation>Saisissez un nom et un bloc&#xa0;: T1 : TON</translation>
    </message>
    <message>
        <source>the local variables of {0} and of what it calls need {1} bytes; the maximum is {2}; declare large arrays in a program or block</source>
        <translation>les variables locales de {0} et de ce qu’il appelle demandent {1} octets&#x202f;; le maximum est {2}&#x202f;; déclarez les grands tableaux dans un programme ou un bloc</translation>
    </message>
    <message>
        <source>{0} is too large for the stack; divide it into several functions</source>
        <translation>{0} est trop grand pour la pile&#x202f;; répartissez-le en plusieurs fonctions</translation>
    </message>
    <message>
        <source>more than {0} units of work (loop passes, calls, copies) in one run of the task; check for an endless loop</source>
        <translation>plus de {0} unités de travail (passages de boucle, appels, copies) en une exécution de la tâche&#x202f;; recherchez une boucle sans fin</translation>
    </message>
    <message>
        <source>{0} is not a name: use letters, digits and underscores.</source>
        <translation>{0} n’est pas un nom valide&#x202f;; utilisez des lettres, des chiffres et des traits de soulignement.</translation>
    </message>
    <message>
        <source>The XLIFF version {0} is not known; save the file as 1.2 or 2.0</source>
        <translation>La version XLIFF {0} est inconnue&#x202f;; enregistrez le fichier en 1.2 ou 2.0</translation>
    </message>
    <message>
        <source>The file does not say into which language it is translated; export it again with --language</source>
        <translation>Le fichier n’indique pas dans quelle langue il est traduit&#x202f;; exportez-le de nouveau avec --language</translation>
    </message>
    <message>
        <source>The XML is wrong: {0}; export the file again</source>
        <translation>Le XML est incorrect&#xa0;: {0}&#x202f;; exportez de nouveau le fichier</translation>
    </message>
    <message>
        <source>The text of the key {0} in {1} has changed since the export; check the translation</source>
        <translation>Le texte de la clé {0} en {1} a changé depuis l’exportation&#x202f;; vérifiez la traduction</translation>
    </message>
    <message>
        <source>The translation of the key {0} has other placeholders than its source and was not taken; use the same ones</source>
        <translation>La traduction de la clé {0} n’a pas les mêmes espaces réservés que sa source et n’a pas été reprise&#x202f;; utilisez les mêmes</translation>
    </message>
    <message>
        <source>The picture {0} is outside the project; copy it into the project, or set {1} to true under {2} in project.json</source>
        <translation>L’image {0} est en dehors du projet&#x202f;; copiez-la dans le projet, ou mettez {1} à true sous {2} dans project.json</translation>
    </message>
    <message>
        <source>The picture {0} unpacks to more than {1} MB; use a smaller one</source>
        <translation>L’image {0} dépasse {1}&#xa0;Mo une fois décompressée&#x202f;; utilisez-en une plus petite</translation>
    </message>
    <message>
        <source>The picture {0} is {1} x {2} pixels; more than {3} million are not drawn; use a smaller one</source>
        <translation>L’image {0} fait {1} x {2} pixels&#x202f;; au-delà de {3} millions, elle n’est pas dessinée&#x202f;; utilisez-en une plus petite</translation>
    </message>
    <message>
        <source>{0} is not a picture in a known format such as PNG, JPEG or SVG; save it as one of them</source>
        <translation>{0} n’est pas une image dans un format connu tel que PNG, JPEG ou SVG&#x202f;; enregistrez-la dans l’un d’eux</translation>
    </message>
    <message>
        <source>The picture {0} draws more than {1} shapes; simplify it or save it as PNG</source>
        <translation>L’image {0} contient plus de {1} formes&#x202f;; simplifiez-la ou enregistrez-la en PNG</translation>
    </message>
    <message>
        <source>The shapes of the picture {0} are nested more than {1} deep or contain themselves; simplify it or save it as PNG</source>
        <translation>Les formes de l’image {0} sont imbriquées sur plus de {1} niveaux ou se contiennent elles-mêmes&#x202f;; simplifiez-la ou enregistrez-la en PNG</translation>
    </message>
    <message>
        <source>The picture {0} loads {1}; embed it in the picture as PNG or JPEG</source>
        <translation>L’image {0} charge {1}&#x202f;; intégrez-le dans l’image en PNG ou JPEG</translation>
    </message>
    <message>
        <source>The picture {0} has dashed lines of more than {1} dashes; make the dashes longer or save it as PNG</source>
        <translation>L’image {0} a des lignes pointillées de plus de {1} tirets&#x202f;; allongez les tirets ou enregistrez-la en PNG</translation>
    </message>
    <message>
        <source>This version does not know the property {0}; it is kept as it is</source>
        <translation>Cette version ne connaît pas la propriété {0}&#x202f;; elle est conservée telle quelle</translation>
    </message>
    <message>
        <source>This version does not know the property {0}; did you mean {1}?</source>
        <translation>Cette version ne connaît pas la propriété {0}&#x202f;; vouliez-vous dire {1}&#x202f;?</translation>
    </message>
    <message>
        <source>The value must be true or false</source>
        <translation>La valeur doit être true ou false</translation>
    </message>
    <message>
        <source>The value must be a whole number</source>
        <translation>La valeur doit être un nombre entier</translation>
    </message>
    <message>
        <source>The value must be a number</source>
        <translation>La valeur doit être un nombre</translation>
    </message>
    <message>
        <source>The value must be a list of two numbers: width and height</source>
        <translation>La valeur doit être une liste de deux nombres&#xa0;: largeur et hauteur</translation>
    </message>
    <message>
        <source>The value must be a list of four numbers: x, y, width and height</source>
        <translation>La valeur doit être une liste de quatre nombres&#xa0;: x, y, largeur et hauteur</translation>
    </message>
    <message>
        <source>The value must be a list of points, each a list of two numbers</source>
        <translation>La valeur doit être une liste de points, chacun une liste de deux nombres</translation>
    </message>
    <message>
        <source>The value must be an object with an expression for each name</source>
        <translation>La valeur doit être un objet avec une expression par nom</translation>
    </message>
    <message>
        <source>The value must be a list of objects</source>
        <translation>La valeur doit être une liste d’objets</translation>
    </message>
    <message>
        <source>The value must be a text in quotes</source>
        <translation>La valeur doit être un texte entre guillemets</translation>
    </message>
    <message>
        <source>{0} is not one of the choices: {1}</source>
        <translation>{0} n’est pas l’un des choix&#xa0;: {1}</translation>
    </message>
    <message>
        <source>{0} is not a colour; use the name of a role of the theme or a value such as {1}</source>
        <translation>{0} n’est pas une couleur&#x202f;; utilisez le nom d’un rôle du thème ou une valeur telle que {1}</translation>
    </message>
    <message>
        <source>{0} is not a colour; did you mean {1}?</source>
        <translation>{0} n’est pas une couleur&#x202f;; vouliez-vous dire {1}&#x202f;?</translation>
    </message>
    <message>
        <source>{0} ({1}) must be greater than {2} ({3}); exchange or correct the values</source>
        <translation>{0} ({1}) doit être supérieur à {2} ({3})&#x202f;; échangez ou corrigez les valeurs</translation>
    </message>
    <message>
        <source>{0} has no page {1}; its {2} {2:page is|pages are} numbered from 0</source>
        <translation>{0} n’a pas de page {1}&#x202f;; ses {2} {2:page est numérotée|pages sont numérotées} à partir de 0</translation>
    </message>
    <message>
        <source>The format {0} needs a number, and {1} is none; use {2}</source>
        <translation>Le format {0} demande un nombre, et {1} n’en est pas un&#x202f;; utilisez {2}</translation>
    </message>
    <message>
        <source>The project has no language {0}, so operators never see this column; add it to the languages in project.json</source>
        <translation>Le projet n’a pas la langue {0}, les opérateurs ne voient donc jamais cette colonne&#x202f;; ajoutez-la aux langues dans project.json</translation>
    </message>
    <message>
        <source>No text says what this does; add one, or place one next to it</source>
        <translation>Aucun texte n’indique à quoi cela sert&#x202f;; ajoutez-en un, ou placez-en un à côté</translation>
    </message>
    <message>
        <source>{0} is between {1} and {2} in the recording, so the range from {3} to {4} cuts it off; widen the range</source>
        <translation>{0} est entre {1} et {2} dans l’enregistrement, la plage de {3} à {4} le tronque donc&#x202f;; élargissez-la</translation>
    </message>
    <message>
        <source>{0} is not between {1} and {2}, so {3} is used; correct it</source>
        <translation>{0} n’est pas entre {1} et {2}, {3} est donc utilisé&#x202f;; corrigez la valeur</translation>
    </message>
    <message>
        <source>The panel {0} contains this one, so it cannot be placed in it; choose another one</source>
        <translation>La vue {0} contient celle-ci et ne peut donc pas y être placée&#x202f;; choisissez-en une autre</translation>
    </message>
    <message>
        <source>The panel {0} has no parameter {1}; remove the argument or add the parameter</source>
        <translation>La vue {0} n’a pas de paramètre {1}&#x202f;; supprimez l’argument ou ajoutez le paramètre</translation>
    </message>
    <message>
        <source>The program has no type {0}; name a block or a structure, BOOL, REAL or the like, or text</source>
        <translation>Le programme n’a pas de type {0}&#x202f;; indiquez un bloc ou une structure, BOOL, REAL ou similaire, ou text</translation>
    </message>
    <message>
        <source>The parameter {0} needs an argument of type {1}; enter one in the properties of this faceplate</source>
        <translation>Le paramètre {0} demande un argument de type {1}&#x202f;; saisissez-en un dans les propriétés de cette vue d’objet</translation>
    </message>
    <message>
        <source>{0} is {1}; the parameter {2} needs {3}</source>
        <translation>{0} est {1}&#x202f;; le paramètre {2} demande {3}</translation>
    </message>
    <message>
        <source>{0} (tried with {1})</source>
        <translation>{0} (essayé avec {1})</translation>
    </message>
    <message>
        <source>The program was not built from sources; open its project.</source>
        <translation>Le programme n’a pas été compilé à partir de sources&#x202f;; ouvrez son projet.</translation>
    </message>
    <message>
        <source>The recording does not contain the program of this scan; choose a later scan.</source>
        <translation>L’enregistrement ne contient pas le programme de ce cycle&#x202f;; choisissez un cycle ultérieur.</translation>
    </message>
    <message>
        <source>This scan is no longer in the recording; choose a later scan.</source>
        <translation>Ce cycle n’est plus dans l’enregistrement&#x202f;; choisissez un cycle ultérieur.</translation>
    </message>
    <message>
        <source>The scan before it is not in the recording, so the values with which this scan began are not known; choose a later scan.</source>
        <translation>Le cycle précédent n’est pas dans l’enregistrement, les valeurs au début de ce cycle sont donc inconnues&#x202f;; choisissez un cycle ultérieur.</translation>
    </message>
    <message>
        <source>There is no user {0}; create the user or check the name</source>
        <translation>L’utilisateur {0} n’existe pas&#x202f;; créez-le ou vérifiez le nom</translation>
    </message>
    <message>
        <source>The password cannot be saved: {0}</source>
        <translation>Le mot de passe ne peut pas être enregistré&#xa0;: {0}</translation>
    </message>
    <message>
        <source>A password needs at least {0} characters; choose a longer one</source>
        <translation>Un mot de passe doit avoir au moins {0} caractères&#x202f;; choisissez-en un plus long</translation>
    </message>
    <message>
        <source>The password must not be the name of the user; choose another one</source>
        <translation>Le mot de passe ne doit pas être le nom de l’utilisateur&#x202f;; choisissez-en un autre</translation>
    </message>
    <message>
        <source>The audit trail cannot be written: {0}</source>
        <translation>La piste d’audit ne peut pas être écrite&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The audit trail cannot be read: {0}</source>
        <translation>La piste d’audit ne peut pas être lue&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The frame {0} has no panel area, so no panel is shown in it; add one</source>
        <translation>Le cadre {0} n’a pas de zone de vue, aucune vue n’y est donc affichée&#x202f;; ajoutez-en une</translation>
    </message>
    <message>
        <source>Only for the roles {0}, but the project has no users, so anybody may operate it; add users</source>
        <translation>Seulement pour les rôles {0}, mais le projet n’a pas d’utilisateurs, tout le monde peut donc le commander&#x202f;; ajoutez des utilisateurs</translation>
    </message>
    <message>
        <source>A row of a recipe names no variable; enter one or remove the row</source>
        <translation>Une ligne d’une recette n’indique pas de variable&#x202f;; indiquez-en une ou supprimez la ligne</translation>
    </message>
    <message>
        <source>The first column must be named variable, and each set has a column of its own</source>
        <translation>La première colonne doit s’appeler variable, et chaque jeu de valeurs a sa propre colonne</translation>
    </message>
    <message>
        <source>The recipe {0} has no variable {1}; add it or correct the name</source>
        <translation>La recette {0} n’a pas de variable {1}&#x202f;; ajoutez-la ou corrigez le nom</translation>
    </message>
    <message>
        <source>There is no recipe {0}; create it or check the name</source>
        <translation>La recette {0} n’existe pas&#x202f;; créez-la ou vérifiez le nom</translation>
    </message>
    <message>
        <source>The recipe {0} has no set {1}; create it or check the name</source>
        <translation>La recette {0} n’a pas de jeu de valeurs {1}&#x202f;; créez-le ou vérifiez le nom</translation>
    </message>
    <message>
        <source>{0} is outside the limits of {1}, {2} to {3}; enter a value within them</source>
        <translation>{0} est hors des limites de {1}, {2} à {3}&#x202f;; entrez une valeur comprise entre elles</translation>
    </message>
    <message>
        <source>The list of shelved alarms cannot be read, so none is shelved: {0}</source>
        <translation>La liste des alarmes mises de côté ne peut pas être lue, aucune n’est donc mise de côté&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The list of shelved alarms cannot be written: {0}</source>
        <translation>La liste des alarmes mises de côté ne peut pas être écrite&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Pourquoi&#x202f;?</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>Pourquoi pas&#x202f;?</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>Qui a écrit cela&#x202f;?</translation>
    </message>
    <message>
        <source>There is no rule {0}; &quot;stepwise panel --rules&quot; lists them</source>
        <translation>La règle {0} n’existe pas&#x202f;; «&#xa0;stepwise panel --rules&#xa0;» les affiche toutes</translation>
    </message>
    <message>
        <source>There is no rule {0}; did you mean {1}?</source>
        <translation>La règle {0} n’existe pas&#x202f;; vouliez-vous dire {1}&#x202f;?</translation>
    </message>
    <message>
        <source>The rule stays on until a reason for switching it off is given</source>
        <translation>La règle reste active tant qu’aucune raison de la désactiver n’est donnée</translation>
    </message>
    <message>
        <source>The value must be a list of texts in quotes</source>
        <translation>La valeur doit être une liste de textes entre guillemets</translation>
    </message>
    <message>
        <source>The value must be an object with the reason for each rule</source>
        <translation>La valeur doit être un objet avec la raison de chaque règle</translation>
    </message>
    <message>
        <source>The value must be an object with a level, the distance, and rules that are off</source>
        <translation>La valeur doit être un objet avec un niveau, la distance et les règles désactivées</translation>
    </message>
    <message>
        <source>The colour {0} is always visible, whatever the state; use {1}</source>
        <translation>La couleur {0} est toujours visible, quel que soit l’état&#x202f;; utilisez {1}</translation>
    </message>
    <message>
        <source>{0} is an alarm colour, but it is visible in normal operation; use {1}</source>
        <translation>{0} est une couleur d’alarme, mais elle est visible en fonctionnement normal&#x202f;; utilisez {1}</translation>
    </message>
    <message>
        <source>Only the hue distinguishes {0} from {1}; choose a brighter one, or add a text or blinking</source>
        <translation>Seule la teinte distingue {0} de {1}&#x202f;; choisissez-en une plus claire, ou ajoutez un texte ou un clignotement</translation>
    </message>
    <message>
        <source>No text says what the lamp means; give it a label, or place a text next to it</source>
        <translation>Aucun texte n’indique ce que signifie le voyant&#x202f;; donnez-lui un libellé ou placez un texte à côté</translation>
    </message>
    <message>
        <source>{0} on {1} has a contrast of {2} to 1 in the theme {3}; {4} to 1 is needed; choose another colour</source>
        <translation>{0} sur {1} a un contraste de {2} pour 1 dans le thème {3}&#x202f;; il faut {4} pour 1&#x202f;; choisissez une autre couleur</translation>
    </message>
    <message>
        <source>A font of {0} px cannot be read from {2} mm; use at least {1} px</source>
        <translation>Une police de {0}&#xa0;px n’est pas lisible à {2}&#xa0;mm&#x202f;; utilisez au moins {1}&#xa0;px</translation>
    </message>
    <message>
        <source>The faceplate is so small here that its smallest font has {0} px; from {2} mm, {1} px are needed; enlarge it</source>
        <translation>La vue d’objet est si petite ici que sa plus petite police a {0}&#xa0;px&#x202f;; à {2}&#xa0;mm, il faut {1}&#xa0;px&#x202f;; agrandissez-la</translation>
    </message>
    <message>
        <source>The faceplate is so small here that only {0} px remain for a finger; {1} px are needed; enlarge it</source>
        <translation>La vue d’objet est si petite ici qu’il ne reste que {0}&#xa0;px pour un doigt&#x202f;; il faut {1}&#xa0;px&#x202f;; agrandissez-la</translation>
    </message>
    <message>
        <source>{0} x {1} px is too small for a finger next to other controls; {2} px are needed in both directions; make it larger</source>
        <translation>{0} × {1}&#xa0;px sont trop petits pour un doigt à côté d’autres commandes&#x202f;; il faut {2}&#xa0;px dans les deux sens&#x202f;; agrandissez l’élément</translation>
    </message>
    <message>
        <source>The panel shows {0} values and controls; the maximum for its size is {1}; move some to another panel</source>
        <translation>La vue affiche {0} valeurs et commandes&#x202f;; le maximum pour sa taille est {1}&#x202f;; déplacez-en vers une autre vue</translation>
    </message>
    <message>
        <source>The panel {0} is {1} presses away from the start panel; add a way of at most {2}</source>
        <translation>La vue {0} est à {1} appuis de la vue de départ&#x202f;; ajoutez un accès en {2} au plus</translation>
    </message>
    <message>
        <source>Nothing on the panel {0} leads back; add a button with the action back or home, or a navigation bar</source>
        <translation>Rien sur la vue {0} ne ramène en arrière&#x202f;; ajoutez un bouton avec l’action back ou home, ou une barre de navigation</translation>
    </message>
    <message>
        <source>{0} is in a different place on the panel {1}; put it in the same place on both</source>
        <translation>{0} est à un autre endroit sur la vue {1}&#x202f;; placez-le au même endroit sur les deux</translation>
    </message>
    <message>
        <source>Normal states are grey so that abnormal ones are noticed (ISA-101). Use a role of the theme such as surface, off or running, and give colour only to conditions.</source>
        <translation>Les états normaux sont gris, pour que les états anormaux ressortent (ISA-101). Utilisez un rôle du thème comme surface, off ou running, et ne donnez de couleur que par des conditions.</translation>
    </message>
    <message>
        <source>Red, orange and yellow are reserved for alarms. An operator who sees them all day long no longer notices them when they matter (ISA-101, ISA-18.2).</source>
        <translation>Le rouge, l’orange et le jaune sont réservés aux alarmes. Un opérateur qui les voit toute la journée ne les voit plus quand elles comptent (ISA-101, ISA-18.2).</translation>
    </message>
    <message>
        <source>Text needs a contrast of 4.5 to 1 against its background, large text 3 to 1 (WCAG 2, ISO 9241-303). The colour roles ensure this in every theme.</source>
        <translation>Un texte demande un contraste de 4,5 pour 1 avec son fond, un grand texte 3 pour 1 (WCAG 2, ISO 9241-303). Les rôles du thème le garantissent dans tous les thèmes.</translation>
    </message>
    <message>
        <source>A capital letter must be seen at an angle of 16 minutes at least (ISO 9241-303). The distance and the size of a pixel are set in project.json.</source>
        <translation>Une majuscule doit être vue sous un angle d’au moins 16 minutes (ISO 9241-303). La distance et la taille d’un pixel sont définies dans project.json.</translation>
    </message>
    <message>
        <source>On a panel that shows everything, operators have to search. Move details to a panel of the next level (ISA-101).</source>
        <translation>Sur une vue qui affiche tout, l’opérateur doit chercher. Déplacez les détails vers une vue du niveau suivant (ISA-101).</translation>
    </message>
    <message>
        <source>In an abnormal situation, every panel should be at most three presses away, and there should be a way back from it (ISA-101).</source>
        <translation>En situation anormale, chaque vue devrait être à trois appuis au plus, avec un chemin de retour (ISA-101).</translation>
    </message>
    <message>
        <source>Operators find what is on several panels without searching if it is always in the same place. Put it on the frame, or in the same place everywhere.</source>
        <translation>Ce qui figure sur plusieurs vues se trouve sans chercher si sa place ne change pas. Placez-le sur le cadre, ou partout au même endroit.</translation>
    </message>
    <message>
        <source>One element covers the other, so that a text cannot be read or the wrong element is pressed.</source>
        <translation>Un élément en couvre un autre&#xa0;: un texte n’est plus lisible, ou un appui touche le mauvais élément.</translation>
    </message>
    <message>
        <source>The element looks as if it had a function. Bind it to a variable, or remove it.</source>
        <translation>L’élément semble avoir une fonction. Liez-le à une variable ou supprimez-le.</translation>
    </message>
    <message>
        <source>A typing error sends 500 instead of 50. Limits reject it on entry.</source>
        <translation>Une faute de frappe envoie 500 au lieu de 50. Des limites la refusent à la saisie.</translation>
    </message>
    <message>
        <source>An alarm that nobody sees is useless. Put an alarm banner on the frame or an alarm list on a panel (ISA-18.2).</source>
        <translation>Une alarme que personne ne voit est inutile. Placez un bandeau d’alarmes sur le cadre ou une liste d’alarmes sur une vue (ISA-18.2).</translation>
    </message>
    <message>
        <source>An alarm requires the operator to act. Its help must say what to do, and what happens otherwise (ISA-18.2).</source>
        <translation>Une alarme demande une action de l’opérateur. Son aide doit indiquer laquelle, et ce qui arrive sinon (ISA-18.2).</translation>
    </message>
    <message>
        <source>If everything is urgent, nothing is: about 5 % of the alarms should have the highest priority, 15 % the next (ISA-18.2).</source>
        <translation>Si tout est urgent, rien ne l’est&#xa0;: environ 5&#xa0;% des alarmes devraient avoir la plus haute priorité, 15&#xa0;% la suivante (ISA-18.2).</translation>
    </message>
    <message>
        <source>the value {0} is outside the subrange {1}..{2}; limit it before the assignment or widen the subrange</source>
        <translation>la valeur {0} est en dehors du sous-intervalle {1}..{2}&#x202f;; limitez-la avant l’affectation ou élargissez le sous-intervalle</translation>
    </message>
    <message>
        <source>&quot;addressing&quot; in project.json is &quot;byte&quot; or &quot;word&quot;, not &quot;{0}&quot;</source>
        <translation>«&#xa0;addressing&#xa0;» dans project.json est «&#xa0;byte&#xa0;» ou «&#xa0;word&#xa0;», pas «&#xa0;{0}&#xa0;»</translation>
    </message>
    <message>
        <source>&quot;memoryForNew&quot; in project.json is a number of bytes from 0 to {0}</source>
        <translation>«&#xa0;memoryForNew&#xa0;» dans project.json est un nombre d’octets de 0 à {0}</translation>
    </message>
    <message>
        <source>A finger needs 7 mm in both directions, a gloved one 9 mm, as the strict level requires. The size of a pixel is set in project.json.</source>
        <translation>Un doigt demande 7&#xa0;mm dans les deux sens, 9&#xa0;mm avec un gant, comme l’exige le niveau strict. La taille d’un pixel est définie dans project.json.</translation>
    </message>
    <message>
        <source>Nothing is bound; fill in “{0}”</source>
        <translation>Rien n’est lié&#x202f;; remplissez «&#xa0;{0}&#xa0;»</translation>
    </message>
    <message>
        <source>Any number can be written to {0}; set “{1}”</source>
        <translation>N’importe quel nombre peut être écrit dans {0}&#x202f;; définissez «&#xa0;{1}&#xa0;»</translation>
    </message>
    <message>
        <source>One man in twelve cannot tell some colours apart, and bright light washes them out. Show the same information with a text, a shape, blinking or at least a different brightness.</source>
        <translation>Un homme sur douze ne distingue pas certaines couleurs, et une lumière vive les efface. Affichez la même chose par un texte, une forme, un clignotement ou au moins une autre luminosité.</translation>
    </message>
    <message>
        <source>A write that is restricted to some roles, or that project.json lists as critical, must not be triggered by an accidental touch. Set &quot;Writes are confirmed&quot;, or enter a question.</source>
        <translation>Une écriture réservée à certains rôles, ou que project.json déclare critique, ne doit pas être déclenchée par un contact accidentel. Activez «&#xa0;Les écritures sont confirmées&#xa0;» ou saisissez une question.</translation>
    </message>
    <message>
        <source>Only {1} may write {0}, but no confirmation is required; set &quot;Writes are confirmed&quot;</source>
        <translation>Seul {1} peut écrire {0}, mais aucune confirmation n’est demandée&#x202f;; activez «&#xa0;Les écritures sont confirmées&#xa0;»</translation>
    </message>
    <message>
        <source>The theme is not valid JSON with a base and colors</source>
        <translation>Le thème n’est pas du JSON valide avec base et colors</translation>
    </message>
    <message>
        <source>There is no built-in theme &quot;{0}&quot;; a base is light, dark or contrast</source>
        <translation>Le thème intégré «&#xa0;{0}&#xa0;» n’existe pas&#x202f;; la base doit être light, dark ou contrast</translation>
    </message>
    <message>
        <source>There is no colour role {0}; check the spelling</source>
        <translation>Le rôle de couleur {0} n’existe pas&#x202f;; vérifiez l’orthographe</translation>
    </message>
    <message>
        <source>There is no colour role {0}; did you mean {1}?</source>
        <translation>Le rôle de couleur {0} n’existe pas&#x202f;; vouliez-vous dire {1}&#x202f;?</translation>
    </message>
    <message>
        <source>The colour of {0} must be written like {1}</source>
        <translation>La couleur de {0} doit s’écrire comme {1}</translation>
    </message>
    <message>
        <source>There is no theme {0}; choose one of {1}</source>
        <translation>Le thème {0} n’existe pas&#x202f;; choisissez parmi {1}</translation>
    </message>
    <message>
        <source>This edit would change the same text twice; undo it and edit the text</source>
        <translation>Cette modification changerait deux fois le même texte&#x202f;; annulez-la et modifiez le texte</translation>
    </message>
    <message>
        <source>This transition does not lead to a step yet; connect it to one first</source>
        <translation>Cette transition ne mène encore à aucune étape&#x202f;; reliez-la d’abord à une étape</translation>
    </message>
    <message>
        <source>The panel was written by a newer version of Stepwise; open it with that version</source>
        <translation>La vue a été écrite par une version plus récente de Stepwise&#x202f;; ouvrez-la avec cette version</translation>
    </message>
    <message>
        <source>This trace configuration was written by a newer version of Stepwise (version {0}); open it with that version</source>
        <translation>Cette configuration de trace a été écrite par une version plus récente de Stepwise (version {0})&#x202f;; ouvrez-la avec cette version</translation>
    </message>
    <message>
        <source>The recorded program can no longer be built; open the recording with the version of Stepwise that made it</source>
        <translation>Le programme enregistré ne peut plus être compilé&#x202f;; ouvrez l’enregistrement avec la version de Stepwise qui l’a créé</translation>
    </message>
    <message>
        <source>The controller is not running; press F5</source>
        <translation>L’automate n’est pas en marche&#x202f;; appuyez sur F5</translation>
    </message>
    <message>
        <source>There is no program to run; declare a PROGRAM</source>
        <translation>Il n’y a pas de programme à exécuter&#x202f;; déclarez un PROGRAM</translation>
    </message>
    <message>
        <source>There is no program to test; declare a PROGRAM</source>
        <translation>Il n’y a pas de programme à tester&#x202f;; déclarez un PROGRAM</translation>
    </message>
    <message>
        <source>A file with this name already exists; choose another name</source>
        <translation>Un fichier de ce nom existe déjà&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>A panel with this name already exists; choose another name</source>
        <translation>Une vue de ce nom existe déjà&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>A step {0} already exists; choose another name</source>
        <translation>Une étape {0} existe déjà&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>The step of this loop is 0; write BY with another number</source>
        <translation>Le pas de cette boucle est 0&#x202f;; écrivez BY avec un autre nombre</translation>
    </message>
    <message>
        <source>This loop of the test does not end; give it a condition that becomes FALSE</source>
        <translation>Cette boucle du test ne se termine pas&#x202f;; donnez-lui une condition qui devient FALSE</translation>
    </message>
    <message>
        <source>There is no name here that can be renamed; put the cursor on one</source>
        <translation>Il n’y a ici aucun nom qui puisse être renommé&#x202f;; placez le curseur sur un nom</translation>
    </message>
    <message>
        <source>The file was changed by another program and was not overwritten; compare both first</source>
        <translation>Le fichier a été modifié par un autre programme et n’a pas été écrasé&#x202f;; comparez d’abord les deux</translation>
    </message>
    <message>
        <source>The type of {0} is not known here; correct the errors of the program first</source>
        <translation>Le type de {0} est inconnu ici&#x202f;; corrigez d’abord les erreurs du programme</translation>
    </message>
    <message>
        <source>Nothing has been recorded yet; start the controller with F5</source>
        <translation>Rien n’a encore été enregistré&#x202f;; démarrez l’automate avec F5</translation>
    </message>
    <message>
        <source>a constant cannot be forced; change it in the program</source>
        <translation>une constante ne peut pas être forcée&#x202f;; modifiez-la dans le programme</translation>
    </message>
    <message>
        <source>the path is incomplete; write it to a single value, for example Main.x</source>
        <translation>le chemin est incomplet&#x202f;; écrivez-le jusqu’à une valeur simple, par exemple Main.x</translation>
    </message>
    <message>
        <source>The panel is not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>La vue n’est pas du JSON valide&#x202f;; recherchez une virgule, un guillemet ou un crochet manquant</translation>
    </message>
    <message>
        <source>The alarms are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Les alarmes ne sont pas du JSON valide&#x202f;; recherchez une virgule, un guillemet ou un crochet manquant</translation>
    </message>
    <message>
        <source>The recipes are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Les recettes ne sont pas du JSON valide&#x202f;; recherchez une virgule, un guillemet ou un crochet manquant</translation>
    </message>
    <message>
        <source>The users and roles are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>Les utilisateurs et les rôles ne sont pas du JSON valide&#x202f;; recherchez une virgule, un guillemet ou un crochet manquant</translation>
    </message>
    <message>
        <source>The trace configuration is not valid JSON (see line {0}); look for a missing comma, quote or bracket</source>
        <translation>La configuration de trace n’est pas du JSON valide (voir la ligne {0})&#x202f;; recherchez une virgule, un guillemet ou un crochet manquant</translation>
    </message>
    <message>
        <source>Two alarms have the id &quot;{0}&quot;; change one of them</source>
        <translation>Deux alarmes ont l’identifiant «&#xa0;{0}&#xa0;»&#x202f;; modifiez l’un des deux</translation>
    </message>
    <message>
        <source>The quote that opens here is never closed; add one at the end of the text</source>
        <translation>Le guillemet ouvert ici n’est jamais fermé&#x202f;; ajoutez-en un à la fin du texte</translation>
    </message>
    <message>
        <source>The language {0} has two columns; remove one of them</source>
        <translation>La langue {0} a deux colonnes&#x202f;; supprimez-en une</translation>
    </message>
    <message>
        <source>The key {0} is already on line {1}; remove one of the two lines</source>
        <translation>La clé {0} figure déjà à la ligne {1}&#x202f;; supprimez l’une des deux lignes</translation>
    </message>
    <message>
        <source>Two roles are named {0}; rename one</source>
        <translation>Deux rôles s’appellent {0}&#x202f;; renommez l’un des deux</translation>
    </message>
    <message>
        <source>Two users are named {0}; rename one</source>
        <translation>Deux utilisateurs s’appellent {0}&#x202f;; renommez l’un des deux</translation>
    </message>
    <message>
        <source>Two recipes are named {0}; rename one</source>
        <translation>Deux recettes s’appellent {0}&#x202f;; renommez l’une d’elles</translation>
    </message>
    <message>
        <source>Two sets of the recipe are named {0}; rename one</source>
        <translation>Deux jeux de valeurs de la recette s’appellent {0}&#x202f;; renommez l’un des deux</translation>
    </message>
    <message>
        <source>The alarm has no condition; enter one</source>
        <translation>L’alarme n’a pas de condition&#x202f;; saisissez-en une</translation>
    </message>
    <message>
        <source>The element is outside the panel; move it inside</source>
        <translation>L’élément est en dehors de la vue&#x202f;; ramenez-le à l’intérieur</translation>
    </message>
    <message>
        <source>The picture {0} is larger than {1} MB; use a smaller one</source>
        <translation>L’image {0} dépasse {1}&#xa0;Mo&#x202f;; utilisez-en une plus petite</translation>
    </message>
    <message>
        <source>The faceplate does not say which panel it shows; choose one</source>
        <translation>La vue d’objet n’indique pas quelle vue elle affiche&#x202f;; choisissez-en une</translation>
    </message>
    <message>
        <source>The key {0} has no text in {1}; enter it in the text table</source>
        <translation>La clé {0} n’a pas de texte en {1}&#x202f;; saisissez-le dans la table des textes</translation>
    </message>
    <message>
        <source>The help of the alarm {0} does not say what to do; add the operator&apos;s next step</source>
        <translation>L’aide de l’alarme {0} ne dit pas quoi faire&#x202f;; ajoutez la prochaine action de l’opérateur</translation>
    </message>
    <message>
        <source>the reference is NULL; assign a variable to it, or compare it with NULL first</source>
        <translation>la référence est NULL&#x202f;; affectez-lui une variable ou comparez-la d’abord avec NULL</translation>
    </message>
    <message>
        <source>the reference does not point to a variable of its type; assign one to it</source>
        <translation>la référence ne désigne pas une variable de son type&#x202f;; affectez-lui-en une</translation>
    </message>
    <message>
        <source>a VAR_IN_OUT is not connected to a variable; connect it in the call</source>
        <translation>un VAR_IN_OUT n’est relié à aucune variable&#x202f;; reliez-le dans l’appel</translation>
    </message>
    <message>
        <source>the watchdog stopped a task that did not end; check for an endless loop</source>
        <translation>le chien de garde a arrêté une tâche qui ne se terminait pas&#x202f;; cherchez une boucle sans fin</translation>
    </message>
    <message>
        <source>the task ran longer than its watchdog time of {0}; shorten its work or raise the time</source>
        <translation>la tâche a dépassé son temps de chien de garde de {0}&#x202f;; allégez son travail ou augmentez ce temps</translation>
    </message>
    <message>
        <source>the file name is too long; choose a shorter one</source>
        <translation>le nom du fichier est trop long&#x202f;; choisissez-en un plus court</translation>
    </message>
    <message>
        <source>the folder is not empty; choose another one</source>
        <translation>le dossier n’est pas vide&#x202f;; choisissez-en un autre</translation>
    </message>
    <message>
        <source>the file system is read-only; choose another folder</source>
        <translation>le système de fichiers est en lecture seule&#x202f;; choisissez un autre dossier</translation>
    </message>
    <message>
        <source>too many files are open; close some of them</source>
        <translation>trop de fichiers sont ouverts&#x202f;; fermez-en quelques-uns</translation>
    </message>
    <message>
        <source>The file is damaged or is not a recording; choose a file that Stepwise wrote (.rec)</source>
        <translation>Le fichier est endommagé ou n’est pas un enregistrement&#x202f;; choisissez un fichier écrit par Stepwise (.rec)</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is reached through a reference, which a path cannot follow; name the variable it refers to</source>
        <translation>«&#xa0;{0}&#xa0;» est atteint par une référence, qu’un chemin ne peut pas suivre&#x202f;; indiquez la variable désignée</translation>
    </message>
    <message>
        <source>a string has one index; remove the others</source>
        <translation>une chaîne a un seul indice&#x202f;; supprimez les autres</translation>
    </message>
    <message>
        <source>a variable of type {0} has no elements; remove the index</source>
        <translation>une variable de type {0} n’a pas d’éléments&#x202f;; supprimez l’indice</translation>
    </message>
    <message>
        <source>a variable of type {0} has no bits; remove the bit number</source>
        <translation>une variable de type {0} n’a pas de bits&#x202f;; supprimez le numéro de bit</translation>
    </message>
    <message>
        <source>the program does not use the address &apos;{0}&apos;; declare a variable AT this address</source>
        <translation>le programme n’utilise pas l’adresse «&#xa0;{0}&#xa0;»&#x202f;; déclarez une variable AT à cette adresse</translation>
    </message>
    <message>
        <source>the path is empty; write for example Main.x</source>
        <translation>le chemin est vide&#x202f;; écrivez par exemple Main.x</translation>
    </message>
    <message>
        <source>a constant cannot be written; change it in the program</source>
        <translation>une constante ne peut pas être écrite&#x202f;; modifiez-la dans le programme</translation>
    </message>
    <message>
        <source>The retain file is not a regular file; remove it or choose another one</source>
        <translation>Le fichier des valeurs rémanentes n’est pas un fichier ordinaire&#x202f;; supprimez-le ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>the text has {0} characters, the maximum is {1}; shorten it</source>
        <translation>le texte a {0} caractères, le maximum est {1}&#x202f;; raccourcissez-le</translation>
    </message>
    <message>
        <source>{0} has {1} {1:part|parts}, the value has {2}; write one value for each</source>
        <translation>{0} a {1} {1:partie|parties}, la valeur en a {2}&#x202f;; écrivez une valeur pour chacune</translation>
    </message>
    <message>
        <source>there is no value to write; enter one first</source>
        <translation>il n’y a pas de valeur à écrire&#x202f;; saisissez-en d’abord une</translation>
    </message>
    <message>
        <source>The expression is nested too deeply; divide it into several</source>
        <translation>L’expression est imbriquée trop profondément&#x202f;; divisez-la en plusieurs</translation>
    </message>
    <message>
        <source>this is not an expression; write for example Main.x &gt; 5</source>
        <translation>ce n’est pas une expression&#x202f;; écrivez par exemple Main.x &gt; 5</translation>
    </message>
    <message>
        <source>this is not an array; remove the index</source>
        <translation>ce n’est pas un tableau&#x202f;; supprimez l’indice</translation>
    </message>
    <message>
        <source>an expression cannot have side effects; use variables, operators and standard functions only</source>
        <translation>une expression doit être sans effet de bord&#x202f;; utilisez seulement des variables, des opérateurs et des fonctions standard</translation>
    </message>
    <message>
        <source>There is no body in ST or IL here; put the cursor into one</source>
        <translation>Il n’y a pas de corps en ST ou en IL ici&#x202f;; placez le curseur dans l’un d’eux</translation>
    </message>
    <message>
        <source>There is no library {0}; check &quot;libraries&quot; in project.json</source>
        <translation>La bibliothèque {0} n’existe pas&#x202f;; vérifiez «&#xa0;libraries&#xa0;» dans project.json</translation>
    </message>
    <message>
        <source>This folder contains neither a project.json nor ST files; choose another folder or create a project</source>
        <translation>Ce dossier ne contient ni project.json ni fichiers ST&#x202f;; choisissez un autre dossier ou créez un projet</translation>
    </message>
    <message>
        <source>There is no such file or folder; check the path</source>
        <translation>Fichier ou dossier introuvable&#x202f;; vérifiez le chemin</translation>
    </message>
    <message>
        <source>{0} already exists in the project; choose another name</source>
        <translation>{0} existe déjà dans le projet&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>{0} already exists in {1}; choose another name</source>
        <translation>{0} existe déjà dans {1}&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>The file is read-only and was not overwritten; make it writable or choose another name</source>
        <translation>Le fichier est en lecture seule et n’a pas été écrasé&#x202f;; autorisez l’écriture ou choisissez un autre nom</translation>
    </message>
    <message>
        <source>{0} is not a time; write for example T#2s</source>
        <translation>{0} n’est pas un temps&#x202f;; écrivez par exemple T#2s</translation>
    </message>
    <message>
        <source>{0} is not a whole number; write for example 5</source>
        <translation>{0} n’est pas un nombre entier&#x202f;; écrivez par exemple 5</translation>
    </message>
    <message>
        <source>{0} is not a number of scans; write for example 10</source>
        <translation>{0} n’est pas un nombre de cycles&#x202f;; écrivez par exemple 10</translation>
    </message>
    <message>
        <source>Nothing would lead to the join after this step; delete the join first</source>
        <translation>Rien ne mènerait à la convergence après cette étape&#x202f;; supprimez d’abord la convergence</translation>
    </message>
    <message>
        <source>There is no branch here; choose a step or transition in a branch</source>
        <translation>Il n’y a pas de branche ici&#x202f;; choisissez une étape ou une transition dans une branche</translation>
    </message>
    <message>
        <source>The last branch does not lead to a step; connect it first</source>
        <translation>La dernière branche ne mène à aucune étape&#x202f;; reliez-la d’abord</translation>
    </message>
    <message>
        <source>There is no chart yet; write an INITIAL_STEP first</source>
        <translation>Il n’y a pas encore de grafcet&#x202f;; écrivez d’abord un INITIAL_STEP</translation>
    </message>
    <message>
        <source>An alarm has no id; give it one</source>
        <translation>Une alarme n’a pas d’identifiant&#x202f;; donnez-lui-en un</translation>
    </message>
    <message>
        <source>Column {0} has no language tag; write one such as de or en-GB</source>
        <translation>La colonne {0} n’a pas d’étiquette de langue&#x202f;; écrivez par exemple de ou en-GB</translation>
    </message>
    <message>
        <source>This line has no key; write one in the first column</source>
        <translation>Cette ligne n’a pas de clé&#x202f;; écrivez-en une dans la première colonne</translation>
    </message>
    <message>
        <source>This is not an XLIFF file; choose one that was exported for translation</source>
        <translation>Ce n’est pas un fichier XLIFF&#x202f;; choisissez-en un exporté pour la traduction</translation>
    </message>
    <message>
        <source>There is no panel {0}; create it or choose another one</source>
        <translation>La vue {0} n’existe pas&#x202f;; créez-la ou choisissez-en une autre</translation>
    </message>
    <message>
        <source>The key {0} is not in the text table; add it there</source>
        <translation>La clé {0} n’est pas dans la table des textes&#x202f;; ajoutez-l’y</translation>
    </message>
    <message>
        <source>The project has no language {0}; add a column for it to texts.csv</source>
        <translation>Le projet n’a pas la langue {0}&#x202f;; ajoutez-lui une colonne dans texts.csv</translation>
    </message>
    <message>
        <source>The file {0} does not exist; add it to the project or choose another one</source>
        <translation>Le fichier {0} n’existe pas&#x202f;; ajoutez-le au projet ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>The panel has no group or tab {0}; create it or choose another one</source>
        <translation>La vue n’a ni groupe ni onglets {0}&#x202f;; créez-le ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>The group {0} contains itself; choose another parent</source>
        <translation>Le groupe {0} se contient lui-même&#x202f;; choisissez un autre parent</translation>
    </message>
    <message>
        <source>A role has no name; give it one</source>
        <translation>Un rôle n’a pas de nom&#x202f;; donnez-lui-en un</translation>
    </message>
    <message>
        <source>A user has no name; give it one</source>
        <translation>Un utilisateur n’a pas de nom&#x202f;; donnez-lui-en un</translation>
    </message>
    <message>
        <source>There is no role {0}; create it or choose another one</source>
        <translation>Le rôle {0} n’existe pas&#x202f;; créez-le ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>A recipe has no name; give it one</source>
        <translation>Une recette n’a pas de nom&#x202f;; donnez-lui-en un</translation>
    </message>
    <message>
        <source>A set of a recipe has no name; give it one</source>
        <translation>Un jeu de valeurs d’une recette n’a pas de nom&#x202f;; donnez-lui-en un</translation>
    </message>
    <message>
        <source>The recipe has the variable {0} twice; remove one of the two</source>
        <translation>La recette contient deux fois la variable {0}&#x202f;; supprimez l’une des deux</translation>
    </message>
    <message>
        <source>The set {0} has no value for {1}; enter one</source>
        <translation>Le jeu de valeurs {0} n’a pas de valeur pour {1}&#x202f;; saisissez-en une</translation>
    </message>
    <message>
        <source>There is no alarm class {0}; add it or choose another one</source>
        <translation>La classe d’alarme {0} n’existe pas&#x202f;; ajoutez-la ou choisissez-en une autre</translation>
    </message>
    <message>
        <source>No panel and no alarm uses the key {0}; use it or remove it</source>
        <translation>Aucune vue ni alarme n’utilise la clé {0}&#x202f;; utilisez-la ou supprimez-la</translation>
    </message>
    <message>
        <source>The placeholders differ: {0} has {1}, {2} has {3}; use the same in both</source>
        <translation>Les espaces réservés diffèrent&#xa0;: {0} a {1}, {2} a {3}&#x202f;; utilisez les mêmes dans les deux</translation>
    </message>
    <message>
        <source>The font {0} is not installed here, so texts cannot be measured; install it</source>
        <translation>La police {0} n’est pas installée ici, les textes ne peuvent donc pas être mesurés&#x202f;; installez-la</translation>
    </message>
    <message>
        <source>No font has the character {0}; use another one</source>
        <translation>Aucune police n’a le caractère {0}&#x202f;; utilisez-en un autre</translation>
    </message>
    <message>
        <source>{0} covers a part of it; move one of the two</source>
        <translation>{0} en couvre une partie&#x202f;; déplacez l’un des deux</translation>
    </message>
    <message>
        <source>Nothing leads from the start panel {1} to the panel {0}; add a button, a navigation bar or an alarm, or choose another start panel</source>
        <translation>Rien ne mène de la vue de départ {1} à la vue {0}&#x202f;; ajoutez un bouton, une barre de navigation ou une alarme, ou choisissez une autre vue de départ</translation>
    </message>
    <message>
        <source>{0} of {1} alarms have the highest priority; keep it for the few that cannot wait</source>
        <translation>{0} alarmes sur {1} ont la plus haute priorité&#x202f;; réservez-la aux rares qui ne peuvent pas attendre</translation>
    </message>
    <message>
        <source>The project has {0} {0:alarm|alarms}, but no panel has an alarm list or banner; add one</source>
        <translation>Le projet a {0} {0:alarme|alarmes}, mais aucune vue n’a de liste ni de bandeau d’alarmes&#x202f;; ajoutez-en un</translation>
    </message>
    <message>
        <source>{0} is critical according to project.json, but a single press writes it; set &quot;Writes are confirmed&quot;</source>
        <translation>{0} est critique d’après project.json, mais un seul appui l’écrit&#x202f;; activez «&#xa0;Les écritures sont confirmées&#xa0;»</translation>
    </message>
    <message>
        <source>{0} suppresses alarms, but a single press writes it; set &quot;Writes are confirmed&quot;</source>
        <translation>{0} inhibe des alarmes, mais un seul appui l’écrit&#x202f;; activez «&#xa0;Les écritures sont confirmées&#xa0;»</translation>
    </message>
    <message>
        <source>The start panel has {0} controls, but no text says what to press when nothing moves; add a sentence, or a state text that names a control</source>
        <translation>La vue de départ a {0} éléments de commande, mais aucun texte ne dit sur quoi appuyer quand rien ne bouge&#x202f;; ajoutez une phrase, ou un texte d’état qui nomme un élément de commande</translation>
    </message>
    <message>
        <source>A machine at rest looks the same whether it is broken or just waiting. The start panel must say what to press next: a sentence below the title, or a state text such as “Ready: press S1”.</source>
        <translation>Une machine à l’arrêt a le même aspect, qu’elle soit en panne ou qu’elle attende. La vue de départ doit dire sur quoi appuyer ensuite&#xa0;: une phrase sous le titre, ou un texte d’état tel que «&#xa0;Prêt&#xa0;: appuyez sur S1&#xa0;».</translation>
    </message>
    <message>
        <source>{0} is not the code of a language; use codes such as {1} or {2}</source>
        <translation>{0} n’est pas un code de langue&#x202f;; utilisez des codes comme {1} ou {2}</translation>
    </message>
    <message>
        <source>Single files have no project.json for settings; create a project and put them into its folder src</source>
        <translation>Des fichiers isolés n&apos;ont pas de project.json pour les paramètres&#x202f;; créez un projet et placez-les dans son dossier src</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>Alarm texts in five languages</source>
        <translation>Textes d’alarme en cinq langues</translation>
    </message>
    <message>
        <source>Heated tank with analog blocks</source>
        <translation>Cuve chauffée avec blocs analogiques</translation>
    </message>
    <message>
        <source>Bottling line</source>
        <translation>Ligne d’embouteillage</translation>
    </message>
    <message>
        <source>Car park with a robot</source>
        <translation>Parking robotisé</translation>
    </message>
    <message>
        <source>Car wash with recipes</source>
        <translation>Station de lavage avec recettes</translation>
    </message>
    <message>
        <source>Room heating with supply air</source>
        <translation>Local chauffé par air soufflé</translation>
    </message>
    <message>
        <source>Motor valve with command monitor</source>
        <translation>Vanne motorisée et sa surveillance</translation>
    </message>
    <message>
        <source>Conveyor with a sequence</source>
        <translation>Convoyeur avec séquence</translation>
    </message>
    <message>
        <source>Depalletiser</source>
        <translation>Dépalettiseur</translation>
    </message>
    <message>
        <source>District-heating substation</source>
        <translation>Sous-station de chauffage urbain</translation>
    </message>
    <message>
        <source>Dosing</source>
        <translation>Dosage</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Gravel plant</source>
        <translation>Installation de gravier</translation>
    </message>
    <message>
        <source>Heater and valve</source>
        <translation>Chauffage et vanne</translation>
    </message>
    <message>
        <source>Hour meter with reset and enable</source>
        <translation>Compteur horaire</translation>
    </message>
    <message>
        <source>Hourly production</source>
        <translation>Pièces par heure</translation>
    </message>
    <message>
        <source>Item counter and meters</source>
        <translation>Pièces et compteurs</translation>
    </message>
    <message>
        <source>Level lamps</source>
        <translation>Voyants de niveau</translation>
    </message>
    <message>
        <source>Light tower</source>
        <translation>Colonne lumineuse</translation>
    </message>
    <message>
        <source>Tuning a control loop</source>
        <translation>Réglage d’une boucle de régulation</translation>
    </message>
    <message>
        <source>Mixer for two liquids and two bricks</source>
        <translation>Mélangeur, liquides et briques</translation>
    </message>
    <message>
        <source>Motor with latching</source>
        <translation>Moteur avec auto-maintien</translation>
    </message>
    <message>
        <source>Operation mode of an agitator</source>
        <translation>Mode de marche d’un agitateur</translation>
    </message>
    <message>
        <source>PID loop on a first-order process</source>
        <translation>Boucle PID, procédé du premier ordre</translation>
    </message>
    <message>
        <source>Two pumps in a well</source>
        <translation>Deux pompes dans un puits</translation>
    </message>
    <message>
        <source>Pulse width modulation of a sine</source>
        <translation>Modulation de largeur d’impulsion</translation>
    </message>
    <message>
        <source>Storage rack with a robot</source>
        <translation>Rayonnage avec robot</translation>
    </message>
    <message>
        <source>Robot and CNC machine</source>
        <translation>Robot et machine CNC</translation>
    </message>
    <message>
        <source>Packing robot with camera inspection</source>
        <translation>Robot qui remplit des cartons</translation>
    </message>
    <message>
        <source>Two redundant level sensors</source>
        <translation>Deux capteurs de niveau comparés</translation>
    </message>
    <message>
        <source>Pumping station with six pumps</source>
        <translation>Station de pompage à six pompes</translation>
    </message>
    <message>
        <source>Motor with selector switch</source>
        <translation>Moteur avec sélecteur</translation>
    </message>
    <message>
        <source>Stack of integers</source>
        <translation>Pile d’entiers</translation>
    </message>
    <message>
        <source>Tank with filling, heating and emptying</source>
        <translation>Cuve remplie, chauffée et vidée</translation>
    </message>
    <message>
        <source>Manually operated tank</source>
        <translation>Cuve en mode manuel</translation>
    </message>
    <message>
        <source>Level and volume</source>
        <translation>Niveau et volume</translation>
    </message>
    <message>
        <source>Traffic light</source>
        <translation>Feu tricolore</translation>
    </message>
    <message>
        <source>Valve matrix</source>
        <translation>Matrice de vannes</translation>
    </message>
    <message>
        <source>Three kinds of valves</source>
        <translation>Trois types de vannes</translation>
    </message>
    <message>
        <source>Pump control with waves</source>
        <translation>Pompe dans les vagues</translation>
    </message>
    <message>
        <source>Truck scale</source>
        <translation>Pont-bascule</translation>
    </message>
    <message>
        <source>Workbook</source>
        <translation>Cahier d’exercices</translation>
    </message>
    <message>
        <source>Tank over Modbus</source>
        <translation>Cuve via Modbus</translation>
    </message>
    <message>
        <source>A vehicle between two limit switches, controlled by two linked sequential function charts</source>
        <translation>Un véhicule entre deux fins de course, commandé par deux grafcets liés</translation>
    </message>
    <message>
        <source>A motor with three alarms that operators read in five languages</source>
        <translation>Un moteur avec trois alarmes que l’opérateur lit en cinq langues</translation>
    </message>
    <message>
        <source>One control loop with a block for each task: filter, monitor, ramp, PID, transfer</source>
        <translation>Une boucle avec un bloc par tâche&#xa0;: filtre, surveillance, rampe, PID, commutation</translation>
    </message>
    <message>
        <source>Filler, capper and labeller with buffers between them, controlled as PackML units</source>
        <translation>Remplisseuse, boucheuse et étiqueteuse avec tampons, pilotées selon PackML</translation>
    </message>
    <message>
        <source>A robot parks cars by number plate and retrieves them again</source>
        <translation>Un robot gare les voitures d’après leur plaque et va les rechercher</translation>
    </message>
    <message>
        <source>Five wash programmes, each with a price and a recipe that the owner can edit</source>
        <translation>Cinq programmes de lavage, chacun avec un prix et une recette modifiables</translation>
    </message>
    <message>
        <source>Cascade control: a slow loop for the room, a fast one for the supply air</source>
        <translation>Régulation en cascade&#xa0;: une boucle lente pour la pièce, une rapide pour l’air soufflé</translation>
    </message>
    <message>
        <source>A motor valve whose travel is monitored; if it takes too long, an alarm sounds</source>
        <translation>Une vanne motorisée à course surveillée&#x202f;; si elle tarde trop, une alarme retentit</translation>
    </message>
    <message>
        <source>A belt carries an item to the right, waits ten seconds and carries it back</source>
        <translation>Un convoyeur amène une pièce à droite, attend dix secondes et la ramène</translation>
    </message>
    <message>
        <source>Four belts take boxes off pallets; the settings of one can be copied to another</source>
        <translation>Quatre convoyeurs déchargent des cartons de palettes&#x202f;; leurs réglages peuvent être copiés</translation>
    </message>
    <message>
        <source>Heating and hot water from a district-heating network, with frost protection and summer mode</source>
        <translation>Chauffage et eau chaude par réseau de chaleur, avec hors-gel et mode été</translation>
    </message>
    <message>
        <source>A valve doses in pulses and pauses until the batch is complete</source>
        <translation>Une vanne dose par impulsions et pauses jusqu’à ce que le lot soit complet</translation>
    </message>
    <message>
        <source>The pressure drop shows how dirty a filter is; an alarm reports when it is out of range</source>
        <translation>La perte de charge indique l’encrassement d’un filtre&#x202f;; hors plage, une alarme</translation>
    </message>
    <message>
        <source>Silo, bin, conveyor and truck, controlled by three parallel sequential function charts</source>
        <translation>Silo, trémie, convoyeur et camion, commandés par trois grafcets en parallèle</translation>
    </message>
    <message>
        <source>Two on-off controls: a heater with a set point, and a valve that opens on a pump alarm</source>
        <translation>Deux commandes tout ou rien&#xa0;: un chauffage avec consigne et une vanne liée à une alarme</translation>
    </message>
    <message>
        <source>An hour meter that is loaded, enabled and held, giving a sawtooth</source>
        <translation>Un compteur horaire chargé, validé et arrêté, ce qui dessine une dent de scie</translation>
    </message>
    <message>
        <source>A press makes items; a table counts how many in each hour of the day</source>
        <translation>Une presse fabrique des pièces&#x202f;; un tableau les compte heure par heure</translation>
    </message>
    <message>
        <source>Counts items, energy and water; the counts survive a power failure</source>
        <translation>Compte les pièces, l’énergie et l’eau&#x202f;; tout survit à une coupure de courant</translation>
    </message>
    <message>
        <source>A 4 to 20 mA level sensor, three lamps and wire break detection</source>
        <translation>Un capteur de niveau de 4 à 20&#xa0;mA, trois voyants et la détection de rupture de fil</translation>
    </message>
    <message>
        <source>Three machine signals on three lamps that flash or stay on</source>
        <translation>Trois signaux d’une machine sur trois voyants, fixes ou clignotants</translation>
    </message>
    <message>
        <source>A heat exchanger that oscillates; an experiment and its recording give better settings</source>
        <translation>Un échangeur oscille&#x202f;; un essai et son enregistrement donnent de meilleurs réglages</translation>
    </message>
    <message>
        <source>Liquids are weighed while a belt brings two bricks; then the mixer turns and tips</source>
        <translation>Les liquides sont pesés, un convoyeur amène deux briques, puis le mélangeur tourne et bascule</translation>
    </message>
    <message>
        <source>Start, stop and a latching contactor, written in five ways that agree</source>
        <translation>Marche, arrêt et un contacteur à auto-maintien, écrits de cinq façons équivalentes</translation>
    </message>
    <message>
        <source>The local control box or the panel: one block decides which of them is in control</source>
        <translation>Commande locale ou pupitre&#xa0;: un bloc décide lequel a la main</translation>
    </message>
    <message>
        <source>The same process with and without a PID controller, side by side in one trace</source>
        <translation>Le même procédé avec et sans régulateur PID, côte à côte sur une trace</translation>
    </message>
    <message>
        <source>One filter, two sines: the slow one passes, the fast one is attenuated and delayed</source>
        <translation>Un filtre, deux sinus&#xa0;: le lent passe, le rapide est atténué et déphasé</translation>
    </message>
    <message>
        <source>A pump tries its speeds and keeps the one with the least energy per cubic metre</source>
        <translation>Une pompe essaie ses vitesses et garde la plus économe par mètre cube</translation>
    </message>
    <message>
        <source>Two alternating pumps; a float switch is accepted only after two steady seconds</source>
        <translation>Deux pompes alternent&#x202f;; un flotteur ne compte qu’après deux secondes stables</translation>
    </message>
    <message>
        <source>A sine becomes pulses for two outputs, as for a motor with two directions</source>
        <translation>Un sinus devient des impulsions sur deux sorties, comme pour un moteur à deux sens</translation>
    </message>
    <message>
        <source>A robot counts encoder pulses to store and retrieve loads in twelve locations</source>
        <translation>Un robot compte les impulsions des codeurs pour ranger des charges dans douze cases</translation>
    </message>
    <message>
        <source>A robot takes 25 items one by one to a CNC machine and back</source>
        <translation>Un robot porte 25 pièces une à une à une machine CNC et les rapporte</translation>
    </message>
    <message>
        <source>A robot puts three items into each box; a camera checks the result</source>
        <translation>Un robot met trois pièces dans chaque carton&#x202f;; une caméra contrôle le résultat</translation>
    </message>
    <message>
        <source>Two sensors are compared; a faulty one is replaced with the healthy one without a jump</source>
        <translation>Deux capteurs comparés&#x202f;; l’un remplace sans à-coup l’autre s’il est en défaut</translation>
    </message>
    <message>
        <source>Starts and stops six pumps by level and running hours, with the daily inflow of a town</source>
        <translation>Six pompes mises en marche selon le niveau et les heures, au rythme d’une ville</translation>
    </message>
    <message>
        <source>A rotary switch selects the speed of a motor, a number what a module does</source>
        <translation>Un commutateur choisit la vitesse d’un moteur, un nombre la fonction d’un module</translation>
    </message>
    <message>
        <source>Last in, first out: push, pop and reset, in ST and as an instruction list</source>
        <translation>Dernier entré, premier sorti&#xa0;: push, pop et reset, en ST et en liste d’instructions</translation>
    </message>
    <message>
        <source>The same sequence twice: with CASE and as a sequential function chart; either can be in control</source>
        <translation>La même séquence deux fois&#xa0;: avec CASE et en grafcet&#x202f;; chacune peut commander</translation>
    </message>
    <message>
        <source>Fill, empty and stir with three switches; two level switches prevent operating errors</source>
        <translation>Remplir, vider et agiter avec trois interrupteurs&#x202f;; deux détecteurs évitent les erreurs</translation>
    </message>
    <message>
        <source>A current of 4 to 20 mA becomes a level, and the level becomes a volume</source>
        <translation>Un courant de 4 à 20&#xa0;mA devient un niveau, et le niveau un volume</translation>
    </message>
    <message>
        <source>Red, yellow and green from one seconds counter, written in three ways</source>
        <translation>Rouge, orange et vert à partir d’un compteur de secondes, de trois façons</translation>
    </message>
    <message>
        <source>Five tanks, three pipelines, fifteen valves; two tanks never feed the same pipeline</source>
        <translation>Cinq cuves, trois conduites, quinze vannes&#x202f;; jamais deux cuves sur une conduite</translation>
    </message>
    <message>
        <source>A motor valve, a spring-return valve and a control valve, each with its block</source>
        <translation>Une vanne motorisée, une à rappel par ressort et une de régulation, chacune avec son bloc</translation>
    </message>
    <message>
        <source>A float switch in waves: the pump starts and stops only after five steady seconds</source>
        <translation>Un flotteur dans les vagues&#xa0;: la pompe ne commute qu’après cinq secondes stables</translation>
    </message>
    <message>
        <source>Four BCD digits become the net weight once the scale has settled</source>
        <translation>Quatre chiffres BCD donnent le poids net dès que la balance est stable</translation>
    </message>
    <message>
        <source>Language samples on four pages, each a separate program with a test</source>
        <translation>Exemples du langage sur quatre pages, chacun un programme avec son test</translation>
    </message>
    <message>
        <source>Automated guided vehicle</source>
        <translation>Véhicule à guidage automatique</translation>
    </message>
    <message>
        <source>First-order filter and two sines</source>
        <translation>Filtre du premier ordre et deux sinus</translation>
    </message>
    <message>
        <source>Pump at its most efficient speed</source>
        <translation>Pompe à sa vitesse la plus économe</translation>
    </message>
    <message>
        <source>A controller and a tank, connected on this computer by real Modbus TCP</source>
        <translation>Un automate et une cuve, reliés sur cet ordinateur par une vraie ligne Modbus TCP</translation>
    </message>
</context>
<context>
    <name>Exchange</name>
    <message>
        <source>The file is written in {0}</source>
        <translation>Le fichier est encodé en {0}</translation>
    </message>
    <message>
        <source>The file was not read: {0}</source>
        <translation>Le fichier n’a pas été lu&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The element {0} was not read; add it by hand if the program needs it</source>
        <translation>L’élément {0} n’a pas été lu&#x202f;; ajoutez-le à la main si le programme en a besoin</translation>
    </message>
    <message>
        <source>The vendor&apos;s data {0} is kept in exchange.json</source>
        <translation>Les données {0} de l’éditeur d’origine sont conservées dans exchange.json</translation>
    </message>
    <message>
        <source>The body in {0} became structured text; the diagram is kept in exchange.json</source>
        <translation>Le corps de {0} est devenu du texte structuré&#x202f;; le schéma est conservé dans exchange.json</translation>
    </message>
    <message>
        <source>The body in {0} is stored in a form that only its own editor reads; export it there as PLCopen XML</source>
        <translation>Le corps de {0} est stocké sous une forme que seul son propre éditeur lit&#x202f;; exportez-le là-bas en PLCopen XML</translation>
    </message>
    <message>
        <source>A jump leads to the step {0}, which does not exist; add the step or correct the jump</source>
        <translation>Un saut mène à l’étape {0}, qui n’existe pas&#x202f;; ajoutez l’étape ou corrigez le saut</translation>
    </message>
    <message>
        <source>The element {0} of the chart is not connected and was left out; connect it in the other tool and export again</source>
        <translation>L’élément {0} du grafcet n’est pas relié et a été omis&#x202f;; reliez-le dans l’autre outil et exportez de nouveau</translation>
    </message>
    <message>
        <source>The transition from {0} has no condition and is written as FALSE; enter its condition</source>
        <translation>La transition depuis {0} n’a pas de condition et est écrite comme FALSE&#x202f;; saisissez sa condition</translation>
    </message>
    <message>
        <source>The element {0} takes part in a loop without a block that stores a value, so its last value is not kept; store it in a variable</source>
        <translation>L’élément {0} fait partie d’une boucle sans bloc qui mémorise une valeur, sa dernière valeur n’est donc pas conservée&#x202f;; mémorisez-la dans une variable</translation>
    </message>
    <message>
        <source>The element {0} is not connected and was left out; connect it in the other tool and export again</source>
        <translation>L’élément {0} n’est pas relié et a été omis&#x202f;; reliez-le dans l’autre outil et exportez de nouveau</translation>
    </message>
    <message>
        <source>An input of {0} is not connected, so its call has too few arguments; add the value that is meant</source>
        <translation>Une entrée de {0} n’est pas reliée, son appel a donc trop peu d’arguments&#x202f;; ajouter la valeur voulue</translation>
    </message>
    <message>
        <source>An edge in a function needs the value of the last call, which a function does not store; make it a FUNCTION_BLOCK</source>
        <translation>Un front dans une fonction demande la valeur du dernier appel, qu’une fonction ne mémorise pas&#x202f;; faites-en un FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>The result of {0} is used in several places and is computed in each; assign it to a variable to compute it once</source>
        <translation>Le résultat de {0} est utilisé à plusieurs endroits et calculé à chacun&#x202f;; affectez-le à une variable pour ne le calculer qu’une fois</translation>
    </message>
    <message>
        <source>The type of the result of {0} is not known, so it is computed although EN is FALSE; call it under an IF</source>
        <translation>Le type du résultat de {0} est inconnu, il est donc calculé même si EN est FALSE&#x202f;; appelez-le sous un IF</translation>
    </message>
    <message>
        <source>The library {0} is not part of Stepwise; uses of it are reported by the check</source>
        <translation>La bibliothèque {0} ne fait pas partie de Stepwise&#x202f;; ses utilisations sont signalées par la vérification</translation>
    </message>
    <message>
        <source>Code in C is kept as a comment and is not executed; write it in ST</source>
        <translation>Le code en C est conservé en commentaire et n’est pas exécuté&#x202f;; écrivez-le en ST</translation>
    </message>
    <message>
        <source>There are two units named {0}; the second is in {1}</source>
        <translation>Deux POU s’appellent {0}&#x202f;; le second est dans {1}</translation>
    </message>
    <message>
        <source>The configuration of the devices was not read; assign the inputs and outputs again</source>
        <translation>La configuration des appareils n’a pas été lue&#x202f;; affectez de nouveau les entrées et les sorties</translation>
    </message>
    <message>
        <source>The task {0} is started by the event {1}, which does not exist here; give it an INTERVAL or a SINGLE</source>
        <translation>La tâche {0} est lancée par l’événement {1}, qui n’existe pas ici&#x202f;; donnez-lui un INTERVAL ou un SINGLE</translation>
    </message>
    <message>
        <source>A comment outside of the elements was left out: {0}</source>
        <translation>Un commentaire hors des éléments a été omis&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The diagram in {0} was not read: an expression refers to itself endlessly; write its body in ST</source>
        <translation>Le schéma dans {0} n’a pas été lu&#xa0;: une expression se réfère à elle-même sans fin&#x202f;; écrivez son corps en ST</translation>
    </message>
    <message>
        <source>The transition {0} is not a single expression and was not read; write its condition in the text</source>
        <translation>La transition {0} n’est pas une expression unique et n’a pas été lue&#x202f;; écrivez sa condition dans le texte</translation>
    </message>
    <message>
        <source>PLCopen XML does not support panels; they were left out</source>
        <translation>PLCopen XML ne prend pas en charge les vues&#x202f;; elles ont été omises</translation>
    </message>
    <message>
        <source>PLCopen XML does not support traces; they were left out</source>
        <translation>PLCopen XML ne prend pas en charge les traces&#x202f;; elles ont été omises</translation>
    </message>
    <message>
        <source>PLCopen XML does not support tests; they were left out</source>
        <translation>PLCopen XML ne prend pas en charge les tests&#x202f;; ils ont été omis</translation>
    </message>
    <message>
        <source>PLCopen XML does not support tests; the TEST &apos;{0}&apos; was left out</source>
        <translation>PLCopen XML ne prend pas en charge les tests&#x202f;; le TEST «&#xa0;{0}&#xa0;» a été omis</translation>
    </message>
    <message>
        <source>PLCopen XML does not support namespaces; the names of {0} are written without the prefix</source>
        <translation>PLCopen XML ne prend pas en charge les espaces de noms&#x202f;; les noms de {0} sont écrits sans le préfixe</translation>
    </message>
    <message>
        <source>PLCopen XML does not support namespaces; {0} was left out with its units because there is another {1}; rename one of them</source>
        <translation>PLCopen XML ne prend pas en charge les espaces de noms&#x202f;; {0} a été omis avec ses POU, car il existe un autre {1}&#x202f;; renommer l’un des deux</translation>
    </message>
    <message>
        <source>PLCopen XML does not support USING; it was left out</source>
        <translation>PLCopen XML ne prend pas en charge USING&#x202f;; il a été omis</translation>
    </message>
    <message>
        <source>PLCopen XML does not support the name of the transition {0}; it was left out</source>
        <translation>PLCopen XML ne prend pas en charge le nom de la transition {0}&#x202f;; il a été omis</translation>
    </message>
    <message>
        <source>PLCopen XML has one indicator per action; {0} was left out</source>
        <translation>PLCopen XML a un indicateur par action&#x202f;; {0} a été omis</translation>
    </message>
    <message>
        <source>Version 0201 has no methods; {0} was left out</source>
        <translation>La version 0201 n’a pas de méthodes&#x202f;; {0} a été omis</translation>
    </message>
    <message>
        <source>Version 0201 has no properties; {0} was left out</source>
        <translation>La version 0201 n’a pas de propriétés&#x202f;; {0} a été omis</translation>
    </message>
    <message>
        <source>Version 0201 has no interfaces; {0} was left out</source>
        <translation>La version 0201 n’a pas d’interfaces&#x202f;; {0} a été omis</translation>
    </message>
    <message>
        <source>Version 0201 has no unions; {0} was left out</source>
        <translation>La version 0201 n’a pas d’unions&#x202f;; {0} a été omis</translation>
    </message>
    <message>
        <source>Version 0201 has no inheritance; EXTENDS or IMPLEMENTS of {0} was left out</source>
        <translation>La version 0201 n’a pas d’héritage&#x202f;; EXTENDS ou IMPLEMENTS de {0} a été omis</translation>
    </message>
    <message>
        <source>Version 0201 does not have the type {0}; other tools will not know it</source>
        <translation>La version 0201 n’a pas le type {0}&#x202f;; les autres outils ne le connaîtront pas</translation>
    </message>
    <message>
        <source>Version 0201 does not support the pragma {0} of a step; it was left out</source>
        <translation>La version 0201 ne prend pas en charge le pragma {0} d’une étape&#x202f;; il a été omis</translation>
    </message>
    <message>
        <source>Version 0201 does not support {0} of a task; it was left out</source>
        <translation>La version 0201 ne prend pas en charge {0} d’une tâche&#x202f;; il a été omis</translation>
    </message>
    <message>
        <source>Version 0201 does not support the connections of the program {0}; they were left out</source>
        <translation>La version 0201 ne prend pas en charge les connexions du programme {0}&#x202f;; elles ont été omises</translation>
    </message>
    <message>
        <source>Version 0201 does not support libraries; {0} was left out</source>
        <translation>La version 0201 ne prend pas en charge les bibliothèques&#x202f;; {0} a été omis</translation>
    </message>
    <message>
        <source>The file is not a program source and was left out; import it separately if it is one</source>
        <translation>Le fichier n’est pas une source de programme et a été omis&#x202f;; importez-le seul s’il en est une</translation>
    </message>
    <message>
        <source>The network &apos;{0}&apos; is commented out in the diagram and was left out of the text</source>
        <translation>Le réseau «&#xa0;{0}&#xa0;» est mis en commentaire dans le diagramme et a été omis du texte</translation>
    </message>
    <message>
        <source>Types that are predefined in {0} are declared here</source>
        <translation>Les types prédéfinis de {0} sont déclarés ici</translation>
    </message>
    <message>
        <source>{0} counts %MW1 in words; &quot;addressing&quot; in project.json says the same</source>
        <translation>{0} compte %MW1 en mots&#x202f;; «&#xa0;addressing&#xa0;» dans project.json dit la même chose</translation>
    </message>
    <message>
        <source>The address {0} starts at a byte that tools counting in words cannot address; move it to a multiple of its size</source>
        <translation>L’adresse {0} commence à un octet que d’autres outils, qui comptent en mots, ne peuvent pas adresser&#x202f;; déplacez-la à un multiple de sa taille</translation>
    </message>
    <message>
        <source>{0} accesses the system outside the controller; it is declared here with its inputs and outputs but does nothing</source>
        <translation>{0} accède au système en dehors de l’automate&#x202f;; il est déclaré ici avec ses entrées et sorties, mais ne fait rien</translation>
    </message>
    <message>
        <source>The library {0} is part of this import; its names are written without the prefix {0}</source>
        <translation>La bibliothèque {0} fait partie de cette importation&#x202f;; ses noms sont écrits sans le préfixe {0}</translation>
    </message>
    <message>
        <source>The names of the library {0} are built into Stepwise; they are written without the prefix {0}</source>
        <translation>Les noms de la bibliothèque {0} sont intégrés à Stepwise&#x202f;; ils sont écrits sans le préfixe {0}</translation>
    </message>
    <message>
        <source>The program uses __NEW; &quot;memoryForNew&quot; in project.json sets 65536 bytes aside for it</source>
        <translation>Le programme utilise __NEW&#x202f;; «&#xa0;memoryForNew&#xa0;» dans project.json lui réserve 65536 octets</translation>
    </message>
    <message>
        <source>STRING constants contain characters that Latin-1 does not have ({0} and so on); &quot;stringEncoding&quot; in project.json is {1}</source>
        <translation>Des constantes STRING contiennent des caractères que Latin-1 n’a pas ({0}, etc.)&#x202f;; «&#xa0;stringEncoding&#xa0;» dans project.json est {1}</translation>
    </message>
    <message>
        <source>The file is empty; export it again</source>
        <translation>Le fichier est vide&#x202f;; exportez-le de nouveau</translation>
    </message>
    <message>
        <source>This is a ZIP archive despite its name; extract it and import the folder</source>
        <translation>Malgré son nom, c’est une archive ZIP&#x202f;; décompressez-la et importez le dossier</translation>
    </message>
    <message>
        <source>The file is in the folder of the project {0}, which does not list it or excludes it from its build; it was left out</source>
        <translation>Le fichier est dans le dossier du projet {0}, qui ne le mentionne pas ou l’exclut de sa compilation&#x202f;; il a été omis</translation>
    </message>
    <message>
        <source>Several projects of the folder have a unit named {0}; each became a project of its own, together with the libraries it uses: this one is {1}</source>
        <translation>Plusieurs projets du dossier ont un POU nommé {0}&#x202f;; chacun est devenu un projet à part, avec les bibliothèques qu’il utilise&#xa0;: celui-ci est {1}</translation>
    </message>
    <message>
        <source>The program {0} of the library {1} was left out: the project that uses the library has one of that name</source>
        <translation>Le programme {0} de la bibliothèque {1} a été omis&#xa0;: le projet qui utilise la bibliothèque en a un du même nom</translation>
    </message>
    <message>
        <source>The folder has no project named {0}; it has: {1}</source>
        <translation>Le dossier ne contient aucun projet nommé {0}&#x202f;; il contient&#xa0;: {1}</translation>
    </message>
    <message>
        <source>The names of inputs and outputs that the configuration of the devices declares ({0} and so on) are in PLC_Configuration</source>
        <translation>Les noms des entrées et sorties que déclare la configuration des appareils ({0}, etc.) sont dans PLC_Configuration</translation>
    </message>
    <message>
        <source>The file is not valid UTF-8 and specifies no other encoding; it was read as {0}. If letters are wrong, import it again with another encoding</source>
        <translation>Le fichier n’est pas en UTF-8 valide et ne déclare aucun autre encodage&#x202f;; il a été lu en {0}. Si des lettres sont fausses, importez-le de nouveau avec un autre encodage</translation>
    </message>
    <message>
        <source>Macro step {0} was replaced by the steps inside it; steps whose names were already used are prefixed with {0}</source>
        <translation>La macro-étape {0} a été remplacée par les étapes qu’elle contient&#x202f;; les étapes dont le nom était déjà utilisé sont préfixées de {0}</translation>
    </message>
    <message>
        <source>The program uses {0} of the library {1}, which reaches outside a simulated controller; declare POUs of these names that do what the simulation needs</source>
        <translation>Le programme utilise {0} de la bibliothèque {1}, qui sort du cadre d’un automate simulé&#x202f;; déclarez des POU de ces noms qui font ce dont la simulation a besoin</translation>
    </message>
    <message>
        <source>Conditions in {0} are drawn with blocks; the action {1}, which runs in every scan from the initial step on, calls them</source>
        <translation>Des conditions dans {0} sont dessinées avec des blocs&#x202f;; l’action {1}, exécutée à chaque cycle dès l’étape initiale, les appelle</translation>
    </message>
    <message>
        <source>The drawn body of {0} was not read; open the project in CODESYS V3 and export it there as PLCopen XML</source>
        <translation>Le corps dessiné de {0} n’a pas été lu&#x202f;; ouvrez le projet dans CODESYS V3 et exportez-le depuis là en PLCopen XML</translation>
    </message>
    <message>
        <source>The drawn body of {0} was not read: the order of the inputs of {1} is not known. Import the file that declares {1} together with this one</source>
        <translation>Le corps dessiné de {0} n’a pas été lu&#xa0;: l’ordre des entrées de {1} n’est pas connu. Importez le fichier qui déclare {1} avec celui-ci</translation>
    </message>
    <message>
        <source>The program uses {0}, which none of its files declares; the project uses the library {1}, which has it</source>
        <translation>Le programme utilise {0}, qu’aucun de ses fichiers ne déclare&#x202f;; le projet utilise la bibliothèque {1}, qui le contient</translation>
    </message>
    <message>
        <source>The task {0} runs {1}, a program of a library; it was left out. Call what the machine needs of it from a program of the project</source>
        <translation>La tâche {0} exécute {1}, un programme d’une bibliothèque&#x202f;; il a été omis. Appelez ce dont la machine a besoin depuis un programme du projet</translation>
    </message>
    <message>
        <source>The variables of this extension are declared in {0}; its code in C or Python is not executed. Write to them in ST what the code does</source>
        <translation>Les variables de cette extension sont déclarées dans {0}&#x202f;; son code en C ou en Python n’est pas exécuté. Écrivez-les en ST comme le fait le code</translation>
    </message>
    <message>
        <source>Version 0201 does not support the constructor arguments of {0}; they were left out</source>
        <translation>La version 0201 ne prend pas en charge les arguments du constructeur de {0}&#x202f;; ils ont été omis</translation>
    </message>
</context>
<context>
    <name>FigureText</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>An XY plot draws one channel against another: add a second channel to the trace.</source>
        <translation>Un tracé XY affiche une voie en fonction d’une autre&#xa0;: ajoutez une deuxième voie à la trace.</translation>
    </message>
    <message>
        <source>XY plot</source>
        <translation>Tracé XY</translation>
    </message>
    <message>
        <source>There are no samples in view: run the program or show another section.</source>
        <translation>Aucun échantillon dans la zone visible&#xa0;: exécutez le programme ou affichez une autre plage.</translation>
    </message>
    <message>
        <source>%L1 points over %2</source>
        <translation>%L1 points sur %2</translation>
    </message>
    <message>
        <source>A spectrum shows the frequencies of the visible channels: add a channel.</source>
        <translation>Un spectre affiche les fréquences des voies visibles&#xa0;: ajoutez une voie.</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spectre</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>Fréquence [Hz]</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>amplitude</translation>
    </message>
    <message>
        <source>%1: no peak, RMS %2</source>
        <translation>%1&#xa0;: pas de pic, valeur efficace %2</translation>
    </message>
    <message>
        <source>%1: %2, RMS %3</source>
        <translation>%1&#xa0;: %2, valeur efficace %3</translation>
    </message>
    <message>
        <source>A frequency response compares an output with an input: add both as channels, and choose the input.</source>
        <translation>Une réponse en fréquence compare une sortie à une entrée&#xa0;: ajoutez les deux comme voies, et choisissez l’entrée.</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Réponse en fréquence</translation>
    </message>
    <message>
        <source>gain [dB]</source>
        <translation>gain [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>phase [°]</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>cohérence</translation>
    </message>
    <message>
        <source>%1: %L2 of %L3 frequencies with a coherence above 0.8</source>
        <translation>%1&#xa0;: %L2 fréquences sur %L3 avec une cohérence supérieure à 0,8</translation>
    </message>
    <message>
        <source>Runs are overlaid at their triggers: enter a trigger in the properties of the trace.</source>
        <translation>Les exécutions sont superposées à leur déclenchement&#xa0;: saisissez un déclencheur dans les propriétés de la trace.</translation>
    </message>
    <message>
        <source>The trigger has not fired in this recording yet.</source>
        <translation>Le déclencheur ne s’est pas encore déclenché dans cet enregistrement.</translation>
    </message>
    <message>
        <source>The runs of the visible channels are overlaid: add a channel.</source>
        <translation>Les exécutions des voies visibles sont superposées&#xa0;: ajoutez une voie.</translation>
    </message>
    <message>
        <source>Time since the trigger [s]</source>
        <translation>Temps depuis le déclenchement [s]</translation>
    </message>
    <message>
        <source>%1: runs differ most %2 after the trigger, by %3</source>
        <translation>%1&#xa0;: écart maximal des exécutions %2 après le déclenchement, de %3</translation>
    </message>
    <message>
        <source>Charts over Time Only</source>
        <translation>Courbes temporelles seules</translation>
    </message>
    <message>
        <source>XY Plot</source>
        <translation>Tracé XY</translation>
    </message>
    <message>
        <source>Frequency Response (Bode)</source>
        <translation>Réponse en fréquence (Bode)</translation>
    </message>
    <message>
        <source>Runs over Each Other</source>
        <translation>Exécutions superposées</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n exécution</numerusform>
            <numerusform>%n exécutions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Fixes</name>
    <message>
        <source>Replace with {0}</source>
        <translation>Remplacer par {0}</translation>
    </message>
    <message>
        <source>Insert {0}</source>
        <translation>Insérer {0}</translation>
    </message>
    <message>
        <source>Did you mean {0}?</source>
        <translation>Vouliez-vous dire {0}&#x202f;?</translation>
    </message>
    <message>
        <source>Convert with {0}</source>
        <translation>Convertir avec {0}</translation>
    </message>
    <message>
        <source>Move {0} to {1}</source>
        <translation>Déplacer {0} vers {1}</translation>
    </message>
    <message>
        <source>Add the property {0}</source>
        <translation>Ajouter la propriété {0}</translation>
    </message>
    <message>
        <source>Add the method {0}</source>
        <translation>Ajouter la méthode {0}</translation>
    </message>
    <message>
        <source>Add the missing branches</source>
        <translation>Ajouter les branches manquantes</translation>
    </message>
    <message>
        <source>Add ELSE</source>
        <translation>Ajouter ELSE</translation>
    </message>
    <message>
        <source>Add () to call it</source>
        <translation>Ajouter () pour l’appeler</translation>
    </message>
    <message>
        <source>Compare with 0</source>
        <translation>Comparer avec 0</translation>
    </message>
    <message>
        <source>Remove the unused declaration</source>
        <translation>Supprimer la déclaration inutilisée</translation>
    </message>
    <message>
        <source>Replace with IF and ELSIF</source>
        <translation>Remplacer par IF et ELSIF</translation>
    </message>
    <message>
        <source>Change to a WSTRING literal</source>
        <translation>Transformer en littéral WSTRING</translation>
    </message>
    <message>
        <source>Replace with straight quotes</source>
        <translation>Remplacer par des guillemets droits</translation>
    </message>
    <message>
        <source>Make {0} the initial step</source>
        <translation>Faire de {0} l’étape initiale</translation>
    </message>
    <message>
        <source>Dereference the pointer with ^</source>
        <translation>Déréférencer le pointeur avec ^</translation>
    </message>
</context>
<context>
    <name>Hmi</name>
    <message>
        <source>as it is</source>
        <translation>tel quel</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Autre…</translation>
    </message>
    <message>
        <source>A variable that is written</source>
        <translation>Une variable qui est écrite</translation>
    </message>
    <message>
        <source>An ST expression</source>
        <translation>Une expression ST</translation>
    </message>
    <message>
        <source>Shown to the operator. A typed text gets its key automatically; @key uses an existing one.</source>
        <translation>Affiché à l’opérateur. Un texte saisi reçoit automatiquement sa clé&#x202f;; @clé en utilise une existante.</translation>
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
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.svg)</source>
        <translation>Images (*.png *.jpg *.svg)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Unknown element</source>
        <translation>Élément inconnu</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Alarm class</source>
        <translation>Classe d’alarme</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Épaisseur du trait</translation>
    </message>
    <message>
        <source>Line style</source>
        <translation>Style du trait</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>Fill level</source>
        <translation>Niveau de remplissage</translation>
    </message>
    <message>
        <source>Full at</source>
        <translation>Plein à</translation>
    </message>
    <message>
        <source>Level colour</source>
        <translation>Couleur du niveau</translation>
    </message>
    <message>
        <source>Font size</source>
        <translation>Taille de la police</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>Gras</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Alignement</translation>
    </message>
    <message>
        <source>Text colour</source>
        <translation>Couleur du texte</translation>
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
        <translation>Unité</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Limit low-low</source>
        <translation>Limite très basse (LL)</translation>
    </message>
    <message>
        <source>Limit low</source>
        <translation>Limite basse (L)</translation>
    </message>
    <message>
        <source>Limit high</source>
        <translation>Limite haute (H)</translation>
    </message>
    <message>
        <source>Limit high-high</source>
        <translation>Limite très haute (HH)</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Choix</translation>
    </message>
    <message>
        <source>Text list</source>
        <translation>Liste de textes</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Arrière-plan</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Identifiant</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Priorité</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Values in texts</source>
        <translation>Valeurs des textes</translation>
    </message>
    <message>
        <source>On delay in seconds</source>
        <translation>Retard à l’apparition en secondes</translation>
    </message>
    <message>
        <source>Off delay in seconds</source>
        <translation>Retard à la disparition en secondes</translation>
    </message>
    <message>
        <source>Must be acknowledged</source>
        <translation>À acquitter</translation>
    </message>
    <message>
        <source>Suppressed if</source>
        <translation>Inhibée si</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Tab page</source>
        <translation>Page d’onglet</translation>
    </message>
    <message>
        <source>Position and size</source>
        <translation>Position et taille</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillé</translation>
    </message>
    <message>
        <source>Visible if</source>
        <translation>Visible si</translation>
    </message>
    <message>
        <source>Enabled if</source>
        <translation>Utilisable si</translation>
    </message>
    <message>
        <source>Appearance by condition</source>
        <translation>Apparence selon condition</translation>
    </message>
    <message>
        <source>Move right by</source>
        <translation>Déplacer à droite de</translation>
    </message>
    <message>
        <source>Move down by</source>
        <translation>Déplacer vers le bas de</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>Tourner de</translation>
    </message>
    <message>
        <source>Fixed language</source>
        <translation>Langue fixe</translation>
    </message>
    <message>
        <source>If</source>
        <translation>Si</translation>
    </message>
    <message>
        <source>Blinks</source>
        <translation>Clignote</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>Utilisable</translation>
    </message>
    <message>
        <source>On if</source>
        <translation>Allumé si</translation>
    </message>
    <message>
        <source>Blinks if</source>
        <translation>Clignote si</translation>
    </message>
    <message>
        <source>Variable with [#] as index</source>
        <translation>Variable avec [#] comme indice</translation>
    </message>
    <message>
        <source>Editable</source>
        <translation>Modifiable</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Paliers</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Polyline</source>
        <translation>Polyligne</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>Rounded rectangle</source>
        <translation>Rectangle arrondi</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygone</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Arc</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Angle de départ</translation>
    </message>
    <message>
        <source>Span</source>
        <translation>Ouverture</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Pipe</source>
        <translation>Conduite</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Flow (sign gives the direction)</source>
        <translation>Débit (le signe donne le sens)</translation>
    </message>
    <message>
        <source>Flow colour</source>
        <translation>Couleur du débit</translation>
    </message>
    <message>
        <source>Wraps</source>
        <translation>Retour à la ligne</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustement</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Symbole</translation>
    </message>
    <message>
        <source>Running if</source>
        <translation>En marche si</translation>
    </message>
    <message>
        <source>Warning if</source>
        <translation>Avertissement si</translation>
    </message>
    <message>
        <source>Fault if</source>
        <translation>Défaut si</translation>
    </message>
    <message>
        <source>Colour off</source>
        <translation>Couleur à l’état 0</translation>
    </message>
    <message>
        <source>Colour running</source>
        <translation>Couleur (en marche)</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Libellé</translation>
    </message>
    <message>
        <source>Button</source>
        <translation>Bouton</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Value to write</source>
        <translation>Valeur à écrire</translation>
    </message>
    <message>
        <source>Go to panel</source>
        <translation>Aller à la vue</translation>
    </message>
    <message>
        <source>Language tag</source>
        <translation>Étiquette de langue</translation>
    </message>
    <message>
        <source>Question to confirm</source>
        <translation>Question de confirmation</translation>
    </message>
    <message>
        <source>Lit if</source>
        <translation>Allumé si</translation>
    </message>
    <message>
        <source>Colour lit</source>
        <translation>Couleur (allumé)</translation>
    </message>
    <message>
        <source>Icon</source>
        <translation>Icône</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Commutateur</translation>
    </message>
    <message>
        <source>Text on</source>
        <translation>Texte à l’état 1</translation>
    </message>
    <message>
        <source>Text off</source>
        <translation>Texte à l’état 0</translation>
    </message>
    <message>
        <source>Colour on</source>
        <translation>Couleur à l’état 1</translation>
    </message>
    <message>
        <source>Rotary selector</source>
        <translation>Sélecteur rotatif</translation>
    </message>
    <message>
        <source>Check box</source>
        <translation>Case à cocher</translation>
    </message>
    <message>
        <source>Radio group</source>
        <translation>Groupe d’options</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Combo box</source>
        <translation>Liste déroulante</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>Curseur</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientation</translation>
    </message>
    <message>
        <source>Show the value</source>
        <translation>Afficher la valeur</translation>
    </message>
    <message>
        <source>Rotary knob</source>
        <translation>Bouton rotatif</translation>
    </message>
    <message>
        <source>Numeric entry</source>
        <translation>Saisie numérique</translation>
    </message>
    <message>
        <source>Lowest value</source>
        <translation>Valeur minimale</translation>
    </message>
    <message>
        <source>Highest value</source>
        <translation>Valeur maximale</translation>
    </message>
    <message>
        <source>Title of the keypad</source>
        <translation>Titre du clavier</translation>
    </message>
    <message>
        <source>Text entry</source>
        <translation>Saisie de texte</translation>
    </message>
    <message>
        <source>Longest text</source>
        <translation>Longueur maximale</translation>
    </message>
    <message>
        <source>Masked entry</source>
        <translation>Saisie masquée</translation>
    </message>
    <message>
        <source>Mask (# digit, A letter, * any)</source>
        <translation>Masque (# chiffre, A lettre, * quelconque)</translation>
    </message>
    <message>
        <source>Hide the value</source>
        <translation>Masquer la valeur</translation>
    </message>
    <message>
        <source>Numeric display</source>
        <translation>Afficheur numérique</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Cadre</translation>
    </message>
    <message>
        <source>Date and time</source>
        <translation>Date et heure</translation>
    </message>
    <message>
        <source>Value (empty: the controller&apos;s clock)</source>
        <translation>Valeur (vide&#xa0;: l’horloge de l’automate)</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Secondes</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Voyant</translation>
    </message>
    <message>
        <source>Blinks when on</source>
        <translation>Clignote à l’état 1</translation>
    </message>
    <message>
        <source>Multi-state indicator</source>
        <translation>Indicateur multi-états</translation>
    </message>
    <message>
        <source>States</source>
        <translation>États</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>Bargraphe</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Tank level</source>
        <translation>Niveau de cuve</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>Cadran</translation>
    </message>
    <message>
        <source>Span of the scale</source>
        <translation>Ouverture de l’échelle</translation>
    </message>
    <message>
        <source>Divisions</source>
        <translation>Graduations</translation>
    </message>
    <message>
        <source>7-segment display</source>
        <translation>Afficheur à 7 segments</translation>
    </message>
    <message>
        <source>Digits</source>
        <translation>Chiffres</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>Décimales</translation>
    </message>
    <message>
        <source>Leading zeros</source>
        <translation>Zéros en tête</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Light tower</source>
        <translation>Colonne lumineuse</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Feux</translation>
    </message>
    <message>
        <source>Siren if</source>
        <translation>Sirène si</translation>
    </message>
    <message>
        <source>Float switch</source>
        <translation>Contact à flotteur</translation>
    </message>
    <message>
        <source>Raised if</source>
        <translation>Levé si</translation>
    </message>
    <message>
        <source>Colour raised</source>
        <translation>Couleur (levé)</translation>
    </message>
    <message>
        <source>Colour hanging</source>
        <translation>Couleur (pendant)</translation>
    </message>
    <message>
        <source>Cell grid</source>
        <translation>Grille de cellules</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Tableau</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Variable of a cell with [#]</source>
        <translation>Variable d’une cellule avec [#]</translation>
    </message>
    <message>
        <source>On press</source>
        <translation>À l’appui</translation>
    </message>
    <message>
        <source>First index</source>
        <translation>Premier indice</translation>
    </message>
    <message>
        <source>Show the numbers</source>
        <translation>Afficher les numéros</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tableau de valeurs</translation>
    </message>
    <message>
        <source>Index of the selected row</source>
        <translation>Indice de la ligne sélectionnée</translation>
    </message>
    <message>
        <source>Bar chart</source>
        <translation>Graphique à barres</translation>
    </message>
    <message>
        <source>Text list of the bars</source>
        <translation>Liste de textes des barres</translation>
    </message>
    <message>
        <source>XY chart</source>
        <translation>Graphique XY</translation>
    </message>
    <message>
        <source>Array of x</source>
        <translation>Tableau des valeurs x</translation>
    </message>
    <message>
        <source>Array of y</source>
        <translation>Tableau des valeurs y</translation>
    </message>
    <message>
        <source>Operating point x</source>
        <translation>Point de fonctionnement x</translation>
    </message>
    <message>
        <source>Operating point y</source>
        <translation>Point de fonctionnement y</translation>
    </message>
    <message>
        <source>X from</source>
        <translation>X de</translation>
    </message>
    <message>
        <source>X to</source>
        <translation>X à</translation>
    </message>
    <message>
        <source>Y from</source>
        <translation>Y de</translation>
    </message>
    <message>
        <source>Y to</source>
        <translation>Y à</translation>
    </message>
    <message>
        <source>Title of x</source>
        <translation>Titre de l’axe x</translation>
    </message>
    <message>
        <source>Title of y</source>
        <translation>Titre de l’axe y</translation>
    </message>
    <message>
        <source>Trend chart</source>
        <translation>Courbe de tendance</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Time span in seconds</source>
        <translation>Durée affichée en secondes</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Légende</translation>
    </message>
    <message>
        <source>Alarm list</source>
        <translation>Liste des alarmes</translation>
    </message>
    <message>
        <source>Only these classes</source>
        <translation>Ces classes seulement</translation>
    </message>
    <message>
        <source>Sorted by</source>
        <translation>Tri</translation>
    </message>
    <message>
        <source>Acknowledge buttons</source>
        <translation>Boutons d’acquittement</translation>
    </message>
    <message>
        <source>Alarm banner</source>
        <translation>Bandeau d’alarme</translation>
    </message>
    <message>
        <source>Language selector</source>
        <translation>Sélecteur de langue</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Style</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Noms</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Onglets</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
    <message>
        <source>Index of the page</source>
        <translation>Indice de la page</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Formes</translation>
    </message>
    <message>
        <source>Text and pictures</source>
        <translation>Texte et images</translation>
    </message>
    <message>
        <source>Symbols</source>
        <translation>Symboles</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Éléments de commande</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Éléments d’affichage</translation>
    </message>
    <message>
        <source>Arrays and charts</source>
        <translation>Tableaux et graphiques</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Containers</source>
        <translation>Conteneurs</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Géométrie</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Comportement</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Type (a block, a structure, BOOL, REAL, text)</source>
        <translation>Type (un bloc, une structure, BOOL, REAL, text)</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Valeur par défaut</translation>
    </message>
    <message>
        <source>Faceplate</source>
        <translation>Vue d’objet</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Arguments</translation>
    </message>
    <message>
        <source>Adapts to the screen by</source>
        <translation>S’adapte à l’écran par</translation>
    </message>
    <message>
        <source>On a tall screen</source>
        <translation>Sur un écran en hauteur</translation>
    </message>
    <message>
        <source>Shown in the frame</source>
        <translation>Affiché dans le cadre</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Panel to show</source>
        <translation>Vue à afficher</translation>
    </message>
    <message>
        <source>First-out group</source>
        <translation>Groupe de première alarme</translation>
    </message>
    <message>
        <source>Horizontal anchor</source>
        <translation>Ancrage horizontal</translation>
    </message>
    <message>
        <source>Vertical anchor</source>
        <translation>Ancrage vertical</translation>
    </message>
    <message>
        <source>Only for the roles</source>
        <translation>Seulement pour les rôles</translation>
    </message>
    <message>
        <source>For all others</source>
        <translation>Pour tous les autres</translation>
    </message>
    <message>
        <source>Writes are confirmed</source>
        <translation>Les écritures sont confirmées</translation>
    </message>
    <message>
        <source>Navigation bar</source>
        <translation>Barre de navigation</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Vues</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Utilisateur</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Recette</translation>
    </message>
    <message>
        <source>Alarm statistics</source>
        <translation>Statistiques des alarmes</translation>
    </message>
    <message>
        <source>Hours to look back</source>
        <translation>Heures à considérer</translation>
    </message>
    <message>
        <source>Panel area</source>
        <translation>Zone de vue</translation>
    </message>
    <message>
        <source>Share of the remaining space</source>
        <translation>Part de l’espace restant</translation>
    </message>
    <message>
        <source>Column span in a grid</source>
        <translation>Nombre de colonnes dans la grille</translation>
    </message>
    <message>
        <source>Closed if</source>
        <translation>Fermé si</translation>
    </message>
    <message>
        <source>In transit if</source>
        <translation>En mouvement si</translation>
    </message>
    <message>
        <source>In manual mode if</source>
        <translation>En manuel si</translation>
    </message>
    <message>
        <source>Out of service if</source>
        <translation>Hors service si</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>Columns (0: as many as fit)</source>
        <translation>Colonnes (0&#xa0;: autant que possible)</translation>
    </message>
    <message>
        <source>Smallest column</source>
        <translation>Largeur minimale de colonne</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Cross-axis alignment</source>
        <translation>Alignement transversal</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>tout le monde</translation>
    </message>
</context>
<context>
    <name>HmiChoices</name>
    <message>
        <source>Dot</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Start sign</source>
        <translation>Signe de marche</translation>
    </message>
    <message>
        <source>Stop sign</source>
        <translation>Signe d’arrêt</translation>
    </message>
    <message>
        <source>Pause sign</source>
        <translation>Signe de pause</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>Signe plus</translation>
    </message>
    <message>
        <source>Minus</source>
        <translation>Signe moins</translation>
    </message>
    <message>
        <source>House</source>
        <translation>Maison</translation>
    </message>
    <message>
        <source>Circular arrow</source>
        <translation>Flèche circulaire</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>By time</source>
        <translation>Par heure</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Continu</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Tirets</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Pointillé</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>Centred</source>
        <translation>Centré</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>À la fin</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contraste élevé</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Flèche</translation>
    </message>
    <message>
        <source>Arc line</source>
        <translation>Ligne d’arc</translation>
    </message>
    <message>
        <source>Pie</source>
        <translation>Secteur</translation>
    </message>
    <message>
        <source>Chord</source>
        <translation>Segment de cercle</translation>
    </message>
    <message>
        <source>Show all of it</source>
        <translation>Afficher en entier</translation>
    </message>
    <message>
        <source>Fill the frame</source>
        <translation>Remplir le cadre</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Étirer</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Bas</translation>
    </message>
    <message>
        <source>Momentary</source>
        <translation>Fugitif</translation>
    </message>
    <message>
        <source>Toggle</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Set to TRUE</source>
        <translation>Mettre à TRUE</translation>
    </message>
    <message>
        <source>Set to FALSE</source>
        <translation>Mettre à FALSE</translation>
    </message>
    <message>
        <source>Write a value</source>
        <translation>Écrire une valeur</translation>
    </message>
    <message>
        <source>Go to a panel</source>
        <translation>Aller à une vue</translation>
    </message>
    <message>
        <source>Change the language</source>
        <translation>Changer la langue</translation>
    </message>
    <message>
        <source>Acknowledge alarms</source>
        <translation>Acquitter les alarmes</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Horizontale</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Verticale</translation>
    </message>
    <message>
        <source>Date and time of day</source>
        <translation>Date et heure</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Calendar week</source>
        <translation>Semaine calendaire</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rond</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Carré</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Arrondi</translation>
    </message>
    <message>
        <source>Dished ends</source>
        <translation>Fonds bombés</translation>
    </message>
    <message>
        <source>Flat ends</source>
        <translation>Fonds plats</translation>
    </message>
    <message>
        <source>Hopper</source>
        <translation>Trémie</translation>
    </message>
    <message>
        <source>Open at the top</source>
        <translation>Ouvert en haut</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>Present alarms</source>
        <translation>Alarmes présentes</translation>
    </message>
    <message>
        <source>Alarm history</source>
        <translation>Historique des alarmes</translation>
    </message>
    <message>
        <source>By priority</source>
        <translation>Par priorité</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Boutons</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>In their own language</source>
        <translation>Dans leur propre langue</translation>
    </message>
    <message>
        <source>Language tags</source>
        <translation>Étiquettes de langue</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Moteur</translation>
    </message>
    <message>
        <source>Pump</source>
        <translation>Pompe</translation>
    </message>
    <message>
        <source>Valve</source>
        <translation>Vanne</translation>
    </message>
    <message>
        <source>Tank</source>
        <translation>Cuve</translation>
    </message>
    <message>
        <source>Silo</source>
        <translation>Silo</translation>
    </message>
    <message>
        <source>Conveyor</source>
        <translation>Convoyeur</translation>
    </message>
    <message>
        <source>Agitator</source>
        <translation>Agitateur</translation>
    </message>
    <message>
        <source>Heater</source>
        <translation>Résistance chauffante</translation>
    </message>
    <message>
        <source>Fan</source>
        <translation>Ventilateur</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Capteur</translation>
    </message>
    <message>
        <source>Siren</source>
        <translation>Sirène</translation>
    </message>
    <message>
        <source>Lorry</source>
        <translation>Camion</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>Véhicule</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Arrière-plan</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Raised surface</source>
        <translation>Surface en relief</translation>
    </message>
    <message>
        <source>Sunken surface</source>
        <translation>Surface en creux</translation>
    </message>
    <message>
        <source>Line colour</source>
        <translation>Couleur de ligne</translation>
    </message>
    <message>
        <source>Faint line</source>
        <translation>Ligne discrète</translation>
    </message>
    <message>
        <source>Text colour</source>
        <translation>Couleur du texte</translation>
    </message>
    <message>
        <source>Muted text</source>
        <translation>Texte atténué</translation>
    </message>
    <message>
        <source>Button colour</source>
        <translation>Couleur de bouton</translation>
    </message>
    <message>
        <source>Accent</source>
        <translation>Accent</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>À l’arrêt</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marche</translation>
    </message>
    <message>
        <source>Liquid</source>
        <translation>Liquide</translation>
    </message>
    <message>
        <source>Pipe colour</source>
        <translation>Couleur de conduite</translation>
    </message>
    <message>
        <source>Measured value</source>
        <translation>Valeur mesurée</translation>
    </message>
    <message>
        <source>Lit segment</source>
        <translation>Segment allumé</translation>
    </message>
    <message>
        <source>Display glass</source>
        <translation>Verre d’afficheur</translation>
    </message>
    <message>
        <source>Alarm colour</source>
        <translation>Couleur d’alarme</translation>
    </message>
    <message>
        <source>High priority</source>
        <translation>Priorité haute</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Low priority</source>
        <translation>Priorité basse</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rouge</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Jaune</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Vert</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Bleu</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanc</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Noir</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Good state</source>
        <translation>Bon état</translation>
    </message>
    <message>
        <source>Curve 1</source>
        <translation>Courbe 1</translation>
    </message>
    <message>
        <source>Curve 2</source>
        <translation>Courbe 2</translation>
    </message>
    <message>
        <source>Curve 3</source>
        <translation>Courbe 3</translation>
    </message>
    <message>
        <source>Curve 4</source>
        <translation>Courbe 4</translation>
    </message>
    <message>
        <source>Curve 5</source>
        <translation>Courbe 5</translation>
    </message>
    <message>
        <source>Curve 6</source>
        <translation>Courbe 6</translation>
    </message>
    <message>
        <source>Curve 7</source>
        <translation>Courbe 7</translation>
    </message>
    <message>
        <source>Curve 8</source>
        <translation>Courbe 8</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a BOOL</source>
        <translation>un BOOL</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>un tableau</translation>
    </message>
    <message>
        <source>any type</source>
        <translation>type quelconque</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Gauche et droite</translation>
    </message>
    <message>
        <source>Top and bottom</source>
        <translation>Haut et bas</translation>
    </message>
    <message>
        <source>Scaling to its size</source>
        <translation>Mise à l’échelle</translation>
    </message>
    <message>
        <source>Moving what is anchored</source>
        <translation>Déplacement des éléments ancrés</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Garder les proportions</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Bas</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillé</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Masqué</translation>
    </message>
    <message>
        <source>Open a panel in a window</source>
        <translation>Ouvrir une vue dans une fenêtre</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Fermer la fenêtre</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Revenir en arrière</translation>
    </message>
    <message>
        <source>Go to the start panel</source>
        <translation>Aller à la vue de départ</translation>
    </message>
    <message>
        <source>Log out</source>
        <translation>Se déconnecter</translation>
    </message>
    <message>
        <source>Shelved alarms</source>
        <translation>Alarmes mises de côté</translation>
    </message>
    <message>
        <source>Compressor</source>
        <translation>Compresseur</translation>
    </message>
    <message>
        <source>Heat exchanger</source>
        <translation>Échangeur de chaleur</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Centrifuge</source>
        <translation>Centrifugeuse</translation>
    </message>
    <message>
        <source>Control valve</source>
        <translation>Vanne de régulation</translation>
    </message>
    <message>
        <source>Three-way valve</source>
        <translation>Vanne à trois voies</translation>
    </message>
    <message>
        <source>Boiler</source>
        <translation>Chaudière</translation>
    </message>
    <message>
        <source>Cooling tower</source>
        <translation>Tour de refroidissement</translation>
    </message>
    <message>
        <source>Filler</source>
        <translation>Remplisseuse</translation>
    </message>
    <message>
        <source>Carton</source>
        <translation>Carton</translation>
    </message>
    <message>
        <source>Pallet</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>Roller conveyor</source>
        <translation>Convoyeur à rouleaux</translation>
    </message>
    <message>
        <source>Bucket elevator</source>
        <translation>Élévateur à godets</translation>
    </message>
    <message>
        <source>Screw conveyor</source>
        <translation>Convoyeur à vis</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Table tournante</translation>
    </message>
    <message>
        <source>Gantry</source>
        <translation>Portique</translation>
    </message>
    <message>
        <source>SCARA robot</source>
        <translation>Robot SCARA</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Préhenseur</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>Porte</translation>
    </message>
    <message>
        <source>Damper</source>
        <translation>Registre</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Bâtiment</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Colonne</translation>
    </message>
    <message>
        <source>Row if wide, column if tall</source>
        <translation>Ligne si large, colonne si haut</translation>
    </message>
    <message>
        <source>Filling it</source>
        <translation>Remplir</translation>
    </message>
    <message>
        <source>Change the theme</source>
        <translation>Changer de thème</translation>
    </message>
    <message>
        <source>Light bulb</source>
        <translation>Ampoule</translation>
    </message>
</context>
<context>
    <name>Inside</name>
    <message>
        <source>set by {0}  {1} ({2}, task {3})</source>
        <translation>écrit par {0}  {1} ({2}, tâche {3})</translation>
    </message>
    <message>
        <source>set by {0}  {1} ({2})</source>
        <translation>écrit par {0}  {1} ({2})</translation>
    </message>
    <message>
        <source>set by code that the compiler adds ({0})</source>
        <translation>écrit par du code que le compilateur ajoute ({0})</translation>
    </message>
    <message>
        <source>written from outside</source>
        <translation>écrit de l’extérieur</translation>
    </message>
    <message>
        <source>written from {0}</source>
        <translation>écrit depuis {0}</translation>
    </message>
    <message>
        <source>forced</source>
        <translation>forcé</translation>
    </message>
    <message>
        <source>forced from {0}</source>
        <translation>forcé depuis {0}</translation>
    </message>
    <message>
        <source>put back by a reset</source>
        <translation>remis à sa valeur par un reset</translation>
    </message>
    <message>
        <source>carried over by an online change</source>
        <translation>repris lors d’une modification en ligne</translation>
    </message>
    <message>
        <source>restored from the retained values</source>
        <translation>restauré à partir des valeurs rémanentes</translation>
    </message>
    <message>
        <source>its initial value</source>
        <translation>sa valeur initiale</translation>
    </message>
    <message>
        <source>put into the safe state when the controller stopped</source>
        <translation>mis à l’état sûr à l’arrêt de l’automate</translation>
    </message>
    <message>
        <source>as recorded in the scan that was resumed from</source>
        <translation>tel qu’enregistré dans le cycle à partir duquel l’exécution a repris</translation>
    </message>
    <message>
        <source>set by a statement of a test</source>
        <translation>écrit par une instruction d’un test</translation>
    </message>
    <message>
        <source>origin not known</source>
        <translation>origine inconnue</translation>
    </message>
    <message>
        <source>the command line</source>
        <translation>la ligne de commande</translation>
    </message>
    <message>
        <source>the studio</source>
        <translation>le studio</translation>
    </message>
    <message>
        <source>panel {0}, {1}</source>
        <translation>la vue {0}, {1}</translation>
    </message>
    <message>
        <source>{0} (scan {1})</source>
        <translation>{0} (cycle {1})</translation>
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
        <translation>{0}  {1} de {2} à {3}, {4}</translation>
    </message>
    <message>
        <source>{0}  {1} to {2}, {3}</source>
        <translation>{0}  {1} à {2}, {3}</translation>
    </message>
    <message>
        <source>called by {0}  {1}</source>
        <translation>appelé par {0}  {1}</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}, since {3}.</source>
        <translation>{0} est {1} à {2}, depuis {3}.</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}, as it was when the recording began.</source>
        <translation>{0} est {1} à {2}, comme au début de l’enregistrement.</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}.</source>
        <translation>{0} est {1} à {2}.</translation>
    </message>
    <message>
        <source>It was {0}.</source>
        <translation>Valeur&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>It has its initial value.</source>
        <translation>La variable a sa valeur initiale.</translation>
    </message>
    <message>
        <source>It became {0} because</source>
        <translation>Elle est devenue {0} parce que</translation>
    </message>
    <message>
        <source>This needed</source>
        <translation>Il fallait</translation>
    </message>
    <message>
        <source>It needs</source>
        <translation>Il faut</translation>
    </message>
    <message>
        <source>It stays so because</source>
        <translation>Elle le reste parce que</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Étape par étape</translation>
    </message>
    <message>
        <source>because</source>
        <translation>parce que</translation>
    </message>
    <message>
        <source>time passed.</source>
        <translation>du temps s’est écoulé.</translation>
    </message>
    <message>
        <source>it was the first scan.</source>
        <translation>c’était le premier cycle.</translation>
    </message>
    <message>
        <source>other variables were forced.</source>
        <translation>d’autres variables étaient forcées.</translation>
    </message>
    <message>
        <source>{0} became {1}.</source>
        <translation>{0} est devenu {1}.</translation>
    </message>
    <message>
        <source>{0} became {1}, {2}.</source>
        <translation>{0} est devenu {1}, {2}.</translation>
    </message>
    <message>
        <source>{0} changed.</source>
        <translation>{0} a changé.</translation>
    </message>
    <message>
        <source>{0} changed, {1}.</source>
        <translation>{0} a changé, {1}.</translation>
    </message>
    <message>
        <source>{0} was {1}.</source>
        <translation>{0} était {1}.</translation>
    </message>
    <message>
        <source>{0} was {1} since {2}, {3}.</source>
        <translation>{0} était {1} depuis {2}, {3}.</translation>
    </message>
    <message>
        <source>{0}   → {1}</source>
        <translation>{0}   → {1}</translation>
    </message>
    <message>
        <source>it ran because {0} was {1}</source>
        <translation>exécuté parce que {0} était {1}</translation>
    </message>
    <message>
        <source>nothing wrote it later because {0} was {1}</source>
        <translation>rien ne l’a écrit ensuite parce que {0} était {1}</translation>
    </message>
    <message>
        <source>a statement that would write it did not run because {0} was {1}</source>
        <translation>une instruction qui l’écrirait n’a pas été exécutée parce que {0} était {1}</translation>
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
        <translation>{0}&#xa0;: {1}</translation>
    </message>
    <message>
        <source>{0} was {1} when the scan began</source>
        <translation>{0} était {1} au début du cycle</translation>
    </message>
    <message>
        <source>{0}   {1}</source>
        <translation>{0}   {1}</translation>
    </message>
    <message>
        <source>its time of {0} has elapsed</source>
        <translation>son temps de {0} est écoulé</translation>
    </message>
    <message>
        <source>it does not run</source>
        <translation>n’est pas en marche</translation>
    </message>
    <message>
        <source>it has run {0} of {1}, {2} to go</source>
        <translation>{0} sur {1} écoulés, reste {2}</translation>
    </message>
    <message>
        <source>it has counted {0} of {1}</source>
        <translation>a compté {0} sur {1}</translation>
    </message>
    <message>
        <source>No change of up to three variables makes it {0} in this scan.</source>
        <translation>Aucun changement de trois variables au plus ne la rend {0} dans ce cycle.</translation>
    </message>
    <message>
        <source>It would be {0} if {1}.</source>
        <translation>Elle serait {0} si {1}.</translation>
    </message>
    <message>
        <source>It would also be {0} if {1}.</source>
        <translation>Elle serait aussi {0} si {1}.</translation>
    </message>
    <message>
        <source>{0} were {1} (it is {2})</source>
        <translation>{0} était {1} (actuellement {2})</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} et {1}</translation>
    </message>
    <message>
        <source>What keeps it {0}</source>
        <translation>Ce qui la maintient à {0}</translation>
    </message>
    <message>
        <source>Note: {0}.</source>
        <translation>Remarque&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>recorded by an earlier version, which kept no journal</source>
        <translation>enregistré par une version antérieure, qui ne tenait pas de journal</translation>
    </message>
    <message>
        <source>it was written to while it was halted at a breakpoint</source>
        <translation>des valeurs ont été écrites pendant l’arrêt à un point d’arrêt</translation>
    </message>
    <message>
        <source>the scan did more than can be kept: only its beginning is known</source>
        <translation>le cycle a fait plus que ce qui peut être conservé&#xa0;: seul son début est connu</translation>
    </message>
    <message>
        <source>the scan had a different result when it was run again</source>
        <translation>le cycle a donné un autre résultat lors de sa réexécution</translation>
    </message>
    <message>
        <source>it has no value in this scan: {0}</source>
        <translation>pas de valeur dans ce cycle&#xa0;: {0}</translation>
    </message>
    <message>
        <source>&quot;Why not?&quot; needs a condition (BOOL), for example &quot;Main.level &gt; 80&quot;</source>
        <translation>«&#xa0;Pourquoi pas&#x202f;?&#xa0;» demande une condition (BOOL), par exemple «&#xa0;Main.level &gt; 80&#xa0;»</translation>
    </message>
    <message>
        <source>the program was not built from sources; open its project</source>
        <translation>le programme n’a pas été compilé à partir de sources&#x202f;; ouvrez son projet</translation>
    </message>
    <message>
        <source>this scan is not in the recording</source>
        <translation>ce cycle n’est pas dans l’enregistrement</translation>
    </message>
    <message>
        <source>it does not change in this recording</source>
        <translation>ne change pas dans cet enregistrement</translation>
    </message>
    <message>
        <source>nothing wrote it in this scan</source>
        <translation>rien ne l’a écrit dans ce cycle</translation>
    </message>
    <message>
        <source>no statement of the project ran in this scan</source>
        <translation>aucune instruction du projet n’a été exécutée dans ce cycle</translation>
    </message>
    <message>
        <source>never {0}</source>
        <translation>jamais {0}</translation>
    </message>
    <message>
        <source>missing: {0}</source>
        <translation>manque&#xa0;: {0}</translation>
    </message>
    <message>
        <source>not run</source>
        <translation>non exécuté</translation>
    </message>
    <message>
        <source>run {0} {0:time|times}</source>
        <translation>exécuté {0} fois</translation>
    </message>
</context>
<context>
    <name>LongTask</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>Loops</name>
    <message>
        <source>The program has no controller block; name the signals with --input and --output</source>
        <translation>Le programme n’a pas de bloc régulateur&#x202f;; indiquez les signaux avec --input et --output</translation>
    </message>
    <message>
        <source>There is no loop {0}; the program has {1}</source>
        <translation>Il n’y a pas de boucle {0}&#x202f;; le programme a {1}</translation>
    </message>
    <message>
        <source>{0} is the name of several loops; give the whole name of one: {1}</source>
        <translation>Plusieurs boucles s’appellent {0}&#x202f;; indiquez le nom complet de l’une d’elles&#xa0;: {1}</translation>
    </message>
    <message>
        <source>The recording contains no program that knows it; choose a loop of the open program</source>
        <translation>L’enregistrement ne contient aucun programme qui la connaît&#x202f;; choisissez une boucle du programme ouvert</translation>
    </message>
    <message>
        <source>It is not a number and cannot be a signal of a loop; name a variable of type REAL or INT</source>
        <translation>Ce n’est pas un nombre et ne peut pas être un signal de boucle&#x202f;; indiquez une variable de type REAL ou INT</translation>
    </message>
    <message>
        <source>This range is no longer recorded, or the program was changed in it; choose another one</source>
        <translation>Cette plage n’est plus enregistrée, ou le programme y a été modifié&#x202f;; choisissez-en une autre</translation>
    </message>
    <message>
        <source>{0} gets an expression in the call; give the measured value a variable of its own to try settings</source>
        <translation>{0} reçoit une expression dans l’appel&#x202f;; donnez à la valeur mesurée sa propre variable pour essayer des paramètres</translation>
    </message>
    <message>
        <source>The call has constants; settings in their place can only be tried on the recording of the running controller</source>
        <translation>L’appel contient des constantes&#x202f;; d’autres paramètres à leur place ne peuvent être essayés que sur l’enregistrement de l’automate en marche</translation>
    </message>
</context>
<context>
    <name>MarkText</name>
    <message>
        <source>Started</source>
        <translation>Démarré</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialisation</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Écrit</translation>
    </message>
    <message>
        <source>Forced</source>
        <translation>Forcé</translation>
    </message>
    <message>
        <source>All forces released</source>
        <translation>Tous les forçages levés</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Forçage levé</translation>
    </message>
    <message>
        <source>Online change</source>
        <translation>Modification en ligne</translation>
    </message>
    <message>
        <source>Breakpoint</source>
        <translation>Point d’arrêt</translation>
    </message>
    <message>
        <source>Retained values saved</source>
        <translation>Valeurs rémanentes enregistrées</translation>
    </message>
    <message>
        <source>Retained values restored</source>
        <translation>Valeurs rémanentes restaurées</translation>
    </message>
    <message numerus="yes">
        <source>%n scan(s) skipped: the machine was late</source>
        <translation>
            <numerusform>%n cycle sauté&#xa0;: l’ordinateur était en retard</numerusform>
            <numerusform>%n cycles sautés&#xa0;: l’ordinateur était en retard</numerusform>
        </translation>
    </message>
    <message>
        <source>Resumed from this scan</source>
        <translation>Repris à partir de ce cycle</translation>
    </message>
</context>
<context>
    <name>Notes</name>
    <message>
        <source>first declared here</source>
        <translation>première déclaration ici</translation>
    </message>
    <message>
        <source>declared here</source>
        <translation>déclaré ici</translation>
    </message>
    <message>
        <source>the variable</source>
        <translation>la variable</translation>
    </message>
    <message>
        <source>the first program</source>
        <translation>le premier programme</translation>
    </message>
    <message>
        <source>overridden here</source>
        <translation>redéfini ici</translation>
    </message>
    <message>
        <source>the first one</source>
        <translation>le premier</translation>
    </message>
    <message>
        <source>by this transition, while it is active</source>
        <translation>par cette transition, tant qu’elle est active</translation>
    </message>
    <message>
        <source>comments nest: the next *) closes the one that begins here</source>
        <translation>les commentaires s’imbriquent&#xa0;: le prochain *) ferme celui qui commence ici</translation>
    </message>
</context>
<context>
    <name>Phrases</name>
    <message>
        <source>a name</source>
        <translation>un nom</translation>
    </message>
    <message>
        <source>a label</source>
        <translation>une étiquette</translation>
    </message>
    <message>
        <source>an operand</source>
        <translation>un opérande</translation>
    </message>
    <message>
        <source>an expression</source>
        <translation>une expression</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>une valeur</translation>
    </message>
    <message>
        <source>a type</source>
        <translation>un type</translation>
    </message>
    <message>
        <source>an index</source>
        <translation>un indice</translation>
    </message>
    <message>
        <source>an argument</source>
        <translation>un argument</translation>
    </message>
    <message>
        <source>an address</source>
        <translation>une adresse</translation>
    </message>
    <message>
        <source>an action</source>
        <translation>une action</translation>
    </message>
    <message>
        <source>a CASE label</source>
        <translation>une étiquette CASE</translation>
    </message>
    <message>
        <source>a block&apos;s name</source>
        <translation>le nom d’un bloc</translation>
    </message>
    <message>
        <source>a processor&apos;s name</source>
        <translation>le nom d’un processeur</translation>
    </message>
    <message>
        <source>a task&apos;s name</source>
        <translation>le nom d’une tâche</translation>
    </message>
    <message>
        <source>a program instance&apos;s name</source>
        <translation>le nom d’une instance de programme</translation>
    </message>
    <message>
        <source>an input or output</source>
        <translation>une entrée ou une sortie</translation>
    </message>
    <message>
        <source>a variable&apos;s name</source>
        <translation>le nom d’une variable</translation>
    </message>
    <message>
        <source>a variable&apos;s path</source>
        <translation>le chemin d’une variable</translation>
    </message>
    <message>
        <source>a step&apos;s name</source>
        <translation>le nom d’une étape</translation>
    </message>
    <message>
        <source>a type&apos;s name</source>
        <translation>le nom d’un type</translation>
    </message>
    <message>
        <source>a member&apos;s name</source>
        <translation>le nom d’un membre</translation>
    </message>
    <message>
        <source>an access name</source>
        <translation>un nom d’accès</translation>
    </message>
    <message>
        <source>an enumeration value</source>
        <translation>une valeur d’énumération</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>la fin de la ligne</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>la fin du fichier</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} ou {1}</translation>
    </message>
    <message>
        <source>FOR and a time</source>
        <translation>FOR et un temps</translation>
    </message>
    <message>
        <source>:= or instructions</source>
        <translation>:= ou des instructions</translation>
    </message>
    <message>
        <source>a subrange</source>
        <translation>un sous-intervalle</translation>
    </message>
    <message>
        <source>an enumeration</source>
        <translation>une énumération</translation>
    </message>
    <message>
        <source>in parentheses</source>
        <translation>entre parenthèses</translation>
    </message>
    <message>
        <source>a chart</source>
        <translation>un grafcet</translation>
    </message>
    <message>
        <source>a body</source>
        <translation>un corps</translation>
    </message>
    <message>
        <source>in a CLASS</source>
        <translation>dans une CLASS</translation>
    </message>
    <message>
        <source>in a FUNCTION</source>
        <translation>dans une FUNCTION</translation>
    </message>
    <message>
        <source>in a METHOD</source>
        <translation>dans une METHOD</translation>
    </message>
    <message>
        <source>in a PROGRAM</source>
        <translation>dans un PROGRAM</translation>
    </message>
    <message>
        <source>in a FUNCTION_BLOCK</source>
        <translation>dans un FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>here</source>
        <translation>ici</translation>
    </message>
    <message>
        <source>{0} {0:character|characters}</source>
        <translation>{0} {0:caractère|caractères}</translation>
    </message>
    <message>
        <source>{0} {0:byte|bytes} in UTF-8</source>
        <translation>{0} {0:octet|octets} en UTF-8</translation>
    </message>
    <message>
        <source>in {0}</source>
        <translation>dans {0}</translation>
    </message>
    <message>
        <source>in an expression</source>
        <translation>dans une expression</translation>
    </message>
    <message>
        <source>in an initial value</source>
        <translation>dans une valeur initiale</translation>
    </message>
    <message>
        <source>in this section</source>
        <translation>dans cette section</translation>
    </message>
    <message>
        <source>an initial value</source>
        <translation>une valeur initiale</translation>
    </message>
    <message>
        <source>RETURN with a value</source>
        <translation>RETURN avec une valeur</translation>
    </message>
    <message>
        <source>in a declaration that calls FB_Init</source>
        <translation>dans une déclaration qui appelle FB_Init</translation>
    </message>
    <message>
        <source>{0} (VAR_IN_OUT)</source>
        <translation>{0} (VAR_IN_OUT)</translation>
    </message>
    <message>
        <source>in {0}, which is not abstract itself</source>
        <translation>dans {0}, qui n’est pas lui-même abstrait</translation>
    </message>
    <message>
        <source>address</source>
        <translation>adresse</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>durée</translation>
    </message>
    <message>
        <source>date</source>
        <translation>date</translation>
    </message>
    <message>
        <source>time of day</source>
        <translation>heure du jour</translation>
    </message>
    <message>
        <source>date and time</source>
        <translation>date et heure</translation>
    </message>
    <message>
        <source>integer</source>
        <translation>entier</translation>
    </message>
    <message>
        <source>string</source>
        <translation>chaîne</translation>
    </message>
    <message>
        <source>{0} (a constant)</source>
        <translation>{0} (une constante)</translation>
    </message>
    <message>
        <source>{0} (an output)</source>
        <translation>{0} (une sortie)</translation>
    </message>
    <message>
        <source>{0} (a local variable of {1})</source>
        <translation>{0} (une variable locale de {1})</translation>
    </message>
    <message>
        <source>{0} (an input)</source>
        <translation>{0} (une entrée)</translation>
    </message>
    <message>
        <source>{0} (an input; the next scan overwrites it)</source>
        <translation>{0} (une entrée&#x202f;; le prochain cycle l’écrase)</translation>
    </message>
    <message>
        <source>{0} (a property without SET)</source>
        <translation>{0} (une propriété sans SET)</translation>
    </message>
    <message>
        <source>{0} (no instance, or several)</source>
        <translation>{0} (aucune instance, ou plusieurs)</translation>
    </message>
    <message>
        <source>{0} (a type; declare an instance of it)</source>
        <translation>{0} (un type&#x202f;; en déclarer une instance)</translation>
    </message>
    <message>
        <source>{0} (a variable, which hides the function of this name)</source>
        <translation>{0} (une variable, qui masque la fonction de ce nom)</translation>
    </message>
    <message>
        <source>an output</source>
        <translation>une sortie</translation>
    </message>
    <message>
        <source>an input</source>
        <translation>une entrée</translation>
    </message>
    <message>
        <source>an IN_OUT parameter</source>
        <translation>un paramètre IN_OUT</translation>
    </message>
    <message>
        <source>a power of a computed number</source>
        <translation>une puissance d’un nombre calculé</translation>
    </message>
    <message>
        <source>a call of {0}</source>
        <translation>un appel de {0}</translation>
    </message>
    <message>
        <source>a call without arguments</source>
        <translation>un appel sans arguments</translation>
    </message>
    <message>
        <source>a computed second argument of {0}</source>
        <translation>un second argument calculé de {0}</translation>
    </message>
    <message>
        <source>{0} outside a loop</source>
        <translation>{0} en dehors d’une boucle</translation>
    </message>
    <message>
        <source>this statement</source>
        <translation>cette instruction</translation>
    </message>
    <message>
        <source>FOR with this end or step</source>
        <translation>FOR avec cette fin ou ce pas</translation>
    </message>
    <message>
        <source>an assignment of several variables</source>
        <translation>une affectation de plusieurs variables</translation>
    </message>
    <message>
        <source>CASE of a computed value</source>
        <translation>CASE d’une valeur calculée</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>un entier</translation>
    </message>
    <message>
        <source>a number of seconds</source>
        <translation>un nombre de secondes</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>une liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>one of {0}</source>
        <translation>un élément de {0}</translation>
    </message>
</context>
<context>
    <name>PlotText</name>
    <message>
        <source>no longer kept</source>
        <translation>n’est plus conservé</translation>
    </message>
    <message>
        <source>did not exist</source>
        <translation>n’existait pas</translation>
    </message>
    <message>
        <source>scans skipped</source>
        <translation>cycles sautés</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>non enregistré</translation>
    </message>
    <message>
        <source>Time [%1]</source>
        <translation>Temps [%1]</translation>
    </message>
    <message>
        <source>Time from the trigger [%1]</source>
        <translation>Temps depuis le déclenchement [%1]</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Voie</translation>
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
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Valeur efficace</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>Temps de montée</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Dépassement</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Temps de stabilisation</translation>
    </message>
</context>
<context>
    <name>Remote</name>
    <message>
        <source>The request is not understood; studio and controller may be of different versions</source>
        <translation>La requête n’est pas comprise&#x202f;; le studio et l’automate sont peut-être de versions différentes</translation>
    </message>
    <message>
        <source>There is no request {0}; studio and controller may be of different versions</source>
        <translation>La requête {0} n’existe pas&#x202f;; le studio et l’automate sont peut-être de versions différentes</translation>
    </message>
    <message>
        <source>Breakpoints stop a machine in the middle of a scan; `stepwise serve` allows them with --allow-breakpoints</source>
        <translation>Les points d’arrêt immobilisent une machine au milieu d’un cycle&#x202f;; «&#xa0;stepwise serve&#xa0;» les autorise avec --allow-breakpoints</translation>
    </message>
    <message>
        <source>{0} is forced; release it before writing</source>
        <translation>{0} est forcé&#x202f;; levez le forçage avant d’écrire</translation>
    </message>
    <message>
        <source>{0} is not forced; there is nothing to release</source>
        <translation>{0} n’est pas forcé&#x202f;; il n’y a aucun forçage à lever</translation>
    </message>
    <message>
        <source>Another program is being built for this controller; try again when it is loaded</source>
        <translation>Un autre programme est en cours de compilation pour cet automate&#x202f;; réessayez quand il sera chargé</translation>
    </message>
    <message>
        <source>The program has {0} {0:error|errors}; correct them: the controller continues with the old program until then</source>
        <translation>Le programme a {0} {0:erreur|erreurs}&#x202f;; corrigez-les&#xa0;: en attendant, l’automate continue avec l’ancien</translation>
    </message>
    <message>
        <source>The controller&apos;s program has no file {0}; load its program again</source>
        <translation>Le programme de l’automate n’a pas de fichier {0}&#x202f;; rechargez son programme</translation>
    </message>
    <message>
        <source>A recording is already being downloaded; wait until it is complete</source>
        <translation>Un enregistrement est déjà en cours de téléchargement&#x202f;; attendez qu’il soit complet</translation>
    </message>
    <message>
        <source>A served controller cannot be resumed from an earlier scan; download its recording and resume from there</source>
        <translation>Un automate exécuté en service ne peut pas reprendre à partir d’un cycle antérieur&#x202f;; téléchargez son enregistrement et reprenez à partir de là</translation>
    </message>
    <message>
        <source>{0} is not the address of a controller; write for example https://plant:8443/</source>
        <translation>{0} n’est pas l’adresse d’un automate&#x202f;; écrivez par exemple https://plant:8443/</translation>
    </message>
    <message>
        <source>{0} rejects the connection: {1}</source>
        <translation>{0} refuse la connexion&#xa0;: {1}</translation>
    </message>
    <message>
        <source>The code is wrong; it is in the file attach-code of the controller&apos;s state folder</source>
        <translation>Le code est faux&#x202f;; il se trouve dans le fichier attach-code du dossier d’état de l’automate</translation>
    </message>
    <message>
        <source>There were too many wrong codes from this computer; wait a minute</source>
        <translation>Trop de codes faux depuis cet ordinateur&#x202f;; attendez une minute</translation>
    </message>
    <message>
        <source>The code would be sent over the network unencrypted; use an https address, and start the controller with --certificate</source>
        <translation>Le code serait envoyé sur le réseau sans chiffrement&#x202f;; utilisez une adresse https et démarrez l’automate avec --certificate</translation>
    </message>
    <message>
        <source>The certificate of {0} is not trusted: {1}; name the file of the certificate that you trust</source>
        <translation>Le certificat de {0} n’est pas approuvé&#xa0;: {1}&#x202f;; indiquez le fichier du certificat auquel vous faites confiance</translation>
    </message>
    <message>
        <source>The certificate cannot be read from {0}; it must be a PEM file</source>
        <translation>Le certificat ne peut pas être lu depuis {0}&#x202f;; ce doit être un fichier PEM</translation>
    </message>
    <message>
        <source>The connection to {0} is lost; check the network and the controller</source>
        <translation>La connexion à {0} est perdue&#x202f;; vérifiez le réseau et l’automate</translation>
    </message>
    <message>
        <source>{0} does not answer; check the address and whether the controller runs</source>
        <translation>{0} ne répond pas&#x202f;; vérifiez l’adresse et si l’automate fonctionne</translation>
    </message>
    <message>
        <source>The controller&apos;s program cannot be built here as it is there; use the same version of Stepwise on both sides</source>
        <translation>Le programme de l’automate ne peut pas être compilé ici comme là-bas&#x202f;; utilisez la même version de Stepwise des deux côtés</translation>
    </message>
    <message>
        <source>{0} speaks TLS on this port; use the address {1}</source>
        <translation>{0} utilise TLS sur ce port&#x202f;; utilisez l’adresse {1}</translation>
    </message>
    <message>
        <source>{0} cannot be reached: {1}; check the address and the network</source>
        <translation>{0} est injoignable&#xa0;: {1}&#x202f;; vérifiez l’adresse et le réseau</translation>
    </message>
    <message>
        <source>Nothing answers at {0}; check the port, and whether `stepwise serve` runs there</source>
        <translation>Rien ne répond à {0}&#x202f;; vérifiez le port et si «&#xa0;stepwise serve&#xa0;» y est en marche</translation>
    </message>
    <message>
        <source>There is no computer named {0}; check the name in the address</source>
        <translation>Il n’y a pas d’ordinateur nommé {0}&#x202f;; vérifiez le nom dans l’adresse</translation>
    </message>
    <message>
        <source>The server at {0} is not a controller started with `stepwise serve`; check the host and the port</source>
        <translation>Le serveur à {0} n’est pas un automate démarré avec «&#xa0;stepwise serve&#xa0;»&#x202f;; vérifiez l’hôte et le port</translation>
    </message>
    <message>
        <source>The server at {0} does not speak TLS; start the controller with --certificate, or use an http address on the same computer</source>
        <translation>Le serveur à {0} ne parle pas TLS&#x202f;; démarrez l’automate avec --certificate, ou utilisez une adresse http sur le même ordinateur</translation>
    </message>
</context>
<context>
    <name>Storage</name>
    <message>
        <source>{0} does not have the character {1}; write the file as UTF-8</source>
        <translation>{0} ne contient pas le caractère {1}&#x202f;; écrivez le fichier en UTF-8</translation>
    </message>
    <message>
        <source>The encoding {0} is not known; choose one of {1}</source>
        <translation>L’encodage {0} est inconnu&#x202f;; choisissez parmi {1}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a list of names; write them in quotes, in square brackets</source>
        <translation>«&#xa0;{0}&#xa0;» doit être une liste de noms&#x202f;; écrivez-les entre guillemets, entre crochets</translation>
    </message>
</context>
<context>
    <name>TraceText</name>
    <message>
        <source>Triggered at %1.</source>
        <translation>Déclenchement à %1.</translation>
    </message>
    <message>
        <source>The trigger did not fire.</source>
        <translation>Le déclenchement n’a pas eu lieu.</translation>
    </message>
</context>
<context>
    <name>Tuning</name>
    <message>
        <source>{0} {0:sample is|samples are} too few for a model; record for longer</source>
        <translation>{0} {0:échantillon ne suffit|échantillons ne suffisent} pas pour un modèle&#x202f;; enregistrez plus longtemps</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>utilisable</translation>
    </message>
    <message>
        <source>the input is at a limit for {0} % of the time</source>
        <translation>l’entrée est à une limite pendant {0}&#xa0;% du temps</translation>
    </message>
    <message>
        <source>the output moves by only {0} times its noise</source>
        <translation>la sortie ne bouge que de {0} fois son bruit</translation>
    </message>
    <message>
        <source>too short: {0} {0:sample|samples} until the next change or the end</source>
        <translation>trop court&#xa0;: {0} {0:échantillon|échantillons} jusqu’au changement suivant ou jusqu’à la fin</translation>
    </message>
    <message>
        <source>disturbed: no model explains more than {0} % of it</source>
        <translation>perturbé&#xa0;: aucun modèle n’en explique plus de {0}&#xa0;%</translation>
    </message>
    <message>
        <source>usable; not at rest before it</source>
        <translation>utilisable&#x202f;; pas au repos avant</translation>
    </message>
    <message>
        <source>There is no step or disturbance in the recording; change the set point or the output once and record the response</source>
        <translation>Il n’y a ni échelon ni perturbation dans l’enregistrement&#x202f;; changez une fois la consigne ou la sortie et enregistrez la réponse</translation>
    </message>
    <message>
        <source>None of the {0} changes found is usable: {1}</source>
        <translation>Aucun des {0} changements trouvés n’est utilisable&#xa0;: {1}</translation>
    </message>
    <message>
        <source>No model explains the output; something else affects it</source>
        <translation>Aucun modèle n’explique la sortie&#x202f;; autre chose agit sur elle</translation>
    </message>
    <message>
        <source>The rule {0} does not apply to this process; choose another one</source>
        <translation>La règle {0} ne s’applique pas à ce procédé&#x202f;; choisissez-en une autre</translation>
    </message>
    <message>
        <source>Unstable: the oscillation would grow. Do not use these settings.</source>
        <translation>Instable&#xa0;: l’oscillation augmenterait. Ne pas utiliser ces paramètres.</translation>
    </message>
    <message>
        <source>Fragile: a small change of the process makes it oscillate.</source>
        <translation>Fragile&#xa0;: un petit changement du procédé la fait osciller.</translation>
    </message>
    <message>
        <source>Brisk: fast, with slight oscillation; the process should not change much.</source>
        <translation>Vif&#xa0;: rapide, avec une légère oscillation&#x202f;; le procédé ne doit pas beaucoup changer.</translation>
    </message>
    <message>
        <source>Good: fast enough, and tolerant of the usual process changes.</source>
        <translation>Bon&#xa0;: assez rapide, et tolère les changements habituels d’un procédé.</translation>
    </message>
    <message>
        <source>Calm: slow, and tolerant of large process changes.</source>
        <translation>Calme&#xa0;: lent, et tolère un procédé qui change beaucoup.</translation>
    </message>
    <message>
        <source>A step of the set point does not overshoot.</source>
        <translation>Un échelon de consigne ne provoque pas de dépassement.</translation>
    </message>
    <message>
        <source>A step of the set point overshoots by {0} %.</source>
        <translation>Un échelon de consigne provoque un dépassement de {0}&#xa0;%.</translation>
    </message>
    <message>
        <source>Ziegler-Nichols is included for comparison: it oscillates and tolerates little change. Use SIMC or the optimum instead.</source>
        <translation>Ziegler-Nichols sert ici de comparaison&#xa0;: elle oscille et tolère peu de changements. Utilisez plutôt SIMC ou l’optimum.</translation>
    </message>
    <message>
        <source>The rule considers only one lag; check the margins.</source>
        <translation>La règle ne tient compte que d’une seule constante de temps&#x202f;; vérifiez les marges.</translation>
    </message>
    <message>
        <source>gain and dead time</source>
        <translation>gain et temps mort</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>premier ordre</translation>
    </message>
    <message>
        <source>first order with dead time</source>
        <translation>premier ordre avec temps mort</translation>
    </message>
    <message>
        <source>second order</source>
        <translation>deuxième ordre</translation>
    </message>
    <message>
        <source>second order with dead time</source>
        <translation>deuxième ordre avec temps mort</translation>
    </message>
    <message>
        <source>two equal lags</source>
        <translation>deux constantes de temps égales</translation>
    </message>
    <message>
        <source>two equal lags with dead time</source>
        <translation>deux constantes de temps égales avec temps mort</translation>
    </message>
    <message>
        <source>oscillating</source>
        <translation>oscillant</translation>
    </message>
    <message>
        <source>oscillating with dead time</source>
        <translation>oscillant avec temps mort</translation>
    </message>
    <message>
        <source>oscillating with a lag</source>
        <translation>oscillant avec une constante de temps</translation>
    </message>
    <message>
        <source>second order with a zero</source>
        <translation>deuxième ordre avec un zéro</translation>
    </message>
    <message>
        <source>second order with a zero and dead time</source>
        <translation>deuxième ordre avec un zéro et temps mort</translation>
    </message>
    <message>
        <source>three equal lags</source>
        <translation>trois constantes de temps égales</translation>
    </message>
    <message>
        <source>three equal lags with a zero</source>
        <translation>trois constantes de temps égales avec un zéro</translation>
    </message>
    <message>
        <source>four equal lags</source>
        <translation>quatre constantes de temps égales</translation>
    </message>
    <message>
        <source>five equal lags</source>
        <translation>cinq constantes de temps égales</translation>
    </message>
    <message>
        <source>six equal lags</source>
        <translation>six constantes de temps égales</translation>
    </message>
    <message>
        <source>seven equal lags</source>
        <translation>sept constantes de temps égales</translation>
    </message>
    <message>
        <source>eight equal lags</source>
        <translation>huit constantes de temps égales</translation>
    </message>
    <message>
        <source>three equal lags with dead time</source>
        <translation>trois constantes de temps égales avec temps mort</translation>
    </message>
    <message>
        <source>three lags</source>
        <translation>trois constantes de temps</translation>
    </message>
    <message>
        <source>three lags with dead time</source>
        <translation>trois constantes de temps avec temps mort</translation>
    </message>
    <message>
        <source>four lags</source>
        <translation>quatre constantes de temps</translation>
    </message>
    <message>
        <source>integrating</source>
        <translation>intégrateur</translation>
    </message>
    <message>
        <source>integrating with dead time</source>
        <translation>intégrateur avec temps mort</translation>
    </message>
    <message>
        <source>integrating with a lag</source>
        <translation>intégrateur avec une constante de temps</translation>
    </message>
    <message>
        <source>integrating with a lag and dead time</source>
        <translation>intégrateur avec une constante de temps et temps mort</translation>
    </message>
    <message>
        <source>integrating with two equal lags</source>
        <translation>intégrateur avec deux constantes de temps égales</translation>
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
        <translation>l’enregistrement y présente une lacune</translation>
    </message>
    <message>
        <source>It oscillates with a period of {0} s and an amplitude of {1}, for {2} cycles in a row.</source>
        <translation>Oscille avec une période de {0}&#xa0;s et une amplitude de {1}, pendant {2} périodes de suite.</translation>
    </message>
    <message>
        <source>It does not oscillate.</source>
        <translation>N’oscille pas.</translation>
    </message>
    <message>
        <source>The settings are the likely cause: with the model, the loop oscillates with this period.</source>
        <translation>Les paramètres sont la cause probable&#xa0;: avec le modèle, la boucle oscille à cette période.</translation>
    </message>
    <message>
        <source>A sticking valve or an external disturbance is the likely cause; the recording cannot tell them apart. Switch the controller to manual: if the oscillation stops, the valve sticks; if it continues, the cause is external.</source>
        <translation>La cause probable est une vanne qui colle ou une perturbation externe&#xa0;; l’enregistrement ne permet pas de les distinguer. Passez le régulateur en manuel&#xa0;: si l’oscillation s’arrête, la vanne colle&#x202f;; si elle continue, la cause est externe.</translation>
    </message>
    <message>
        <source>The likely cause is external: neither the settings nor a sticking valve explains it.</source>
        <translation>La cause probable est extérieure&#xa0;: ni les paramètres ni une vanne qui colle ne l’expliquent.</translation>
    </message>
    <message>
        <source>The output is at a limit for {0} % of the time.</source>
        <translation>La sortie est à une limite pendant {0}&#xa0;% du temps.</translation>
    </message>
    <message>
        <source>{0} % of what the measured value does is noise.</source>
        <translation>{0}&#xa0;% de la variation de la valeur mesurée est du bruit.</translation>
    </message>
    <message>
        <source>the output did not respond: the controller was not active</source>
        <translation>la sortie n’a pas réagi&#xa0;: le régulateur n’était pas actif</translation>
    </message>
    <message>
        <source>too short: not at rest again before the next change</source>
        <translation>trop court&#xa0;: pas encore stabilisé avant le changement suivant</translation>
    </message>
    <message>
        <source>The recording has {0} {0:disturbance|disturbances}, but no step that a model can be made from; change the set point or the output once and record the response</source>
        <translation>L’enregistrement contient {0} {0:perturbation|perturbations}, mais aucun échelon dont on puisse tirer un modèle&#x202f;; changez une fois la consigne ou la sortie et enregistrez la réponse</translation>
    </message>
    <message>
        <source>Change {0} is a disturbance: its cause is not known, so no model can be made from it; choose a change of the set point or of the output</source>
        <translation>Le changement {0} est une perturbation&#xa0;: sa cause est inconnue, il ne donne donc pas de modèle&#x202f;; choisissez une variation de la consigne ou de la sortie</translation>
    </message>
    <message>
        <source>the measured value is at the end of its range for {0} % of the time</source>
        <translation>la valeur mesurée est en bout d’échelle pendant {0}&#xa0;% du temps</translation>
    </message>
    <message>
        <source>{0}, controlled by {1}</source>
        <translation>{0}, réglé par {1}</translation>
    </message>
    <message>
        <source>Changes in the recording</source>
        <translation>Variations dans l’enregistrement</translation>
    </message>
    <message>
        <source>{0} found, {1} used for the model</source>
        <translation>{0} trouvées, {1} utilisées pour le modèle</translation>
    </message>
    <message>
        <source>… and {0} more</source>
        <translation>… et {0} autres</translation>
    </message>
    <message>
        <source>No model: {0}</source>
        <translation>Pas de modèle&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>{0}, explains {1} %</source>
        <translation>{0}, explique {1}&#xa0;%</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Parameters by {0}</source>
        <translation>Paramètres selon {0}</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>enregistré</translation>
    </message>
    <message>
        <source>output at a limit</source>
        <translation>sortie à une limite</translation>
    </message>
    <message>
        <source>mean absolute error</source>
        <translation>erreur absolue moyenne</translation>
    </message>
    <message>
        <source>integrated absolute error</source>
        <translation>intégrale de l’erreur absolue</translation>
    </message>
    <message>
        <source>movements of the output in an hour</source>
        <translation>mouvements de la sortie par heure</translation>
    </message>
    <message>
        <source>noise of the measured value</source>
        <translation>bruit de la valeur mesurée</translation>
    </message>
    <message>
        <source>at [s]</source>
        <translation>à [s]</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>variation</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>évaluation</translation>
    </message>
    <message>
        <source>output</source>
        <translation>sortie</translation>
    </message>
    <message>
        <source>set point</source>
        <translation>consigne</translation>
    </message>
    <message>
        <source>disturbance</source>
        <translation>perturbation</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>gain</translation>
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
        <translation>marge de gain</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>marge de phase</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>dépassement</translation>
    </message>
    <message>
        <source>settling time [s]</source>
        <translation>temps de stabilisation [s]</translation>
    </message>
    <message>
        <source>error after a load step</source>
        <translation>erreur après un échelon de charge</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instable</translation>
    </message>
    <message>
        <source>now</source>
        <translation>actuel</translation>
    </message>
    <message>
        <source>Recorded and modelled</source>
        <translation>Enregistré et modélisé</translation>
    </message>
    <message>
        <source>Step of the set point by 1</source>
        <translation>Échelon de consigne de 1</translation>
    </message>
    <message>
        <source>Step of the load by 1</source>
        <translation>Échelon de charge de 1</translation>
    </message>
    <message>
        <source>Bode plot</source>
        <translation>Diagramme de Bode</translation>
    </message>
    <message>
        <source>Set point and measured value</source>
        <translation>Consigne et valeur mesurée</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Sortie</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>temps [s]</translation>
    </message>
    <message>
        <source>magnitude [dB]</source>
        <translation>module [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>phase [°]</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>fréquence [rad/s]</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modèle</translation>
    </message>
    <message>
        <source>loop now</source>
        <translation>boucle actuelle</translation>
    </message>
    <message>
        <source>loop, {0}</source>
        <translation>boucle, {0}</translation>
    </message>
    <message>
        <source>process</source>
        <translation>procédé</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>gain {0} ± {1}</source>
        <translation>gain {0} ± {1}</translation>
    </message>
    <message>
        <source>lag {0} s ± {1} s</source>
        <translation>constante de temps {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>frequency {0} rad/s ± {1} rad/s</source>
        <translation>fréquence {0}&#xa0;rad/s ± {1}&#xa0;rad/s</translation>
    </message>
    <message>
        <source>damping {0} ± {1}</source>
        <translation>amortissement {0} ± {1}</translation>
    </message>
    <message>
        <source>zero {0} s ± {1} s</source>
        <translation>zéro {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>dead time {0} s ± {1} s</source>
        <translation>temps mort {0}&#xa0;s ± {1}&#xa0;s</translation>
    </message>
    <message>
        <source>The gain is {0} upwards and {1} downwards; settings are made for {2}.</source>
        <translation>Le gain est de {0} à la montée et de {1} à la descente&#x202f;; les paramètres sont calculés pour {2}.</translation>
    </message>
    <message>
        <source>The gain depends on the operating point: it is {0} where the measured value is about {1}, and {2} about {3}; settings are made for {4}. For one range alone, choose its steps only.</source>
        <translation>Le gain dépend du point de fonctionnement&#xa0;: il est de {0} lorsque la valeur mesurée est voisine de {1}, et de {2} vers {3}&#x202f;; les paramètres sont calculés pour {4}. Pour une seule plage, ne choisissez que ses échelons.</translation>
    </message>
    <message>
        <source>usable; the output was set to its limit</source>
        <translation>utilisable&#x202f;; la sortie a été mise à sa limite</translation>
    </message>
    <message>
        <source>Loop health</source>
        <translation>État de la boucle</translation>
    </message>
    <message>
        <source>It explains {0} % of the steps it was not fitted to.</source>
        <translation>Il explique {0}&#xa0;% des échelons auxquels il n’a pas été ajusté.</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Résidus</translation>
    </message>
    <message>
        <source>The controller output and the measured value are the same in every sample; choose another measured value</source>
        <translation>La sortie du régulateur et la valeur mesurée sont identiques à chaque échantillon&#x202f;; choisissez une autre valeur mesurée</translation>
    </message>
    <message>
        <source>A sticking valve is the likely cause: the output moves evenly, but the process responds in jumps. Check it with the controller in manual: the oscillation then stops; if it continues, the cause is external.</source>
        <translation>Une vanne qui colle est la cause probable&#xa0;: la sortie bouge régulièrement, le procédé répond par à-coups. Vérifiez-le avec le régulateur en manuel&#xa0;: l’oscillation s’arrête alors&#x202f;; si elle continue, la cause est externe.</translation>
    </message>
</context>
<context>
    <name>Waveform</name>
    <message>
        <source>The table has no column of times; name one time_s (seconds) or time_ms</source>
        <translation>Le tableau n’a pas de colonne de temps&#x202f;; nommez-en une time_s (secondes) ou time_ms</translation>
    </message>
    <message>
        <source>The table has no column {0}; it has {1}</source>
        <translation>Le tableau n’a pas de colonne {0}&#x202f;; il a {1}</translation>
    </message>
    <message>
        <source>The table has no column {0}; did you mean {1}?</source>
        <translation>Le tableau n’a pas de colonne {0}&#x202f;; vouliez-vous dire {1}&#x202f;?</translation>
    </message>
    <message>
        <source>Line {0} has no number in column {1}; correct or remove the line</source>
        <translation>La ligne {0} n’a pas de nombre dans la colonne {1}&#x202f;; corrigez ou supprimez la ligne</translation>
    </message>
    <message>
        <source>The time in line {0} is before that of the line above; sort the lines by time</source>
        <translation>Le temps de la ligne {0} est antérieur à celui de la ligne précédente&#x202f;; triez les lignes par temps</translation>
    </message>
    <message>
        <source>The table has no column of numbers besides the time; add one with a heading</source>
        <translation>Le tableau n’a pas de colonne de nombres en dehors du temps&#x202f;; ajoutez-en une avec un en-tête</translation>
    </message>
    <message>
        <source>The table has no rows below its headings; write one row per sample</source>
        <translation>Le tableau n’a pas de lignes sous ses en-têtes&#x202f;; écrivez une ligne par échantillon</translation>
    </message>
    <message>
        <source>The table cannot be shown as a recording: {0}</source>
        <translation>Le tableau ne peut pas être affiché comme enregistrement&#xa0;: {0}</translation>
    </message>
    <message>
        <source>the names of its columns cannot be variables; use letters, digits and underscores</source>
        <translation>les noms de ses colonnes ne peuvent pas être des variables&#x202f;; utilisez des lettres, des chiffres et des traits de soulignement</translation>
    </message>
    <message>
        <source>{0} {0:sample is|samples are} too few for a spectrum; show a longer section</source>
        <translation>{0} {0:échantillon|échantillons}, c’est trop peu pour un spectre&#x202f;; affichez une plage plus longue</translation>
    </message>
    <message>
        <source>{0} {0:sample is|samples are} too few for a frequency response; show a longer section</source>
        <translation>{0} {0:échantillon|échantillons}, c’est trop peu pour une réponse en fréquence&#x202f;; affichez une plage plus longue</translation>
    </message>
    <message>
        <source>The input does not change here, so there is no response; show another section</source>
        <translation>L’entrée ne varie pas ici, il n’y a donc pas de réponse&#x202f;; affichez une autre plage</translation>
    </message>
    <message>
        <source>{0} needs a closing parenthesis at the end; it must enclose the whole expression</source>
        <translation>{0} demande une parenthèse fermante à la fin&#x202f;; elle doit entourer toute l’expression</translation>
    </message>
    <message>
        <source>{0} needs a time above 0 as its second argument, for example {1}</source>
        <translation>{0} demande un temps supérieur à 0 comme deuxième argument, par exemple {1}</translation>
    </message>
    <message>
        <source>{0} takes one expression; remove the others</source>
        <translation>{0} prend une seule expression&#x202f;; supprimez les autres</translation>
    </message>
    <message>
        <source>The file is not a table; a recording of Stepwise ends with .rec</source>
        <translation>Le fichier n’est pas un tableau&#x202f;; un enregistrement de Stepwise se termine par .rec</translation>
    </message>
    <message>
        <source>Column {0}: {1} {1:cell is not a number|cells are not numbers}, the first ({2}) in line {3}; the value above it is kept</source>
        <translation>Colonne {0}&#xa0;: {1} {1:cellule n’est pas un nombre|cellules ne sont pas des nombres}, la première ({2}) à la ligne {3}&#x202f;; la valeur précédente est conservée</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} fewer cells than the header, the first in line {1}; the values above are kept</source>
        <translation>{0} {0:ligne a|lignes ont} moins de cellules que l’en-tête, la première est la ligne {1}&#x202f;; les valeurs précédentes sont conservées</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} more cells than the header, the first in line {1}; the surplus cells are ignored. Put numbers with a decimal comma in quotes</source>
        <translation>{0} {0:ligne a|lignes ont} plus de cellules que l’en-tête, la première est la ligne {1}&#x202f;; les cellules en trop sont ignorées. Mettez les nombres à virgule décimale entre guillemets</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} the same time as the row above, the first in line {1}; {0:it is|they are} left out</source>
        <translation>{0} {0:ligne a|lignes ont} le même temps que la ligne précédente, la première est la ligne {1}&#x202f;; {0:elle est omise|elles sont omises}</translation>
    </message>
    <message>
        <source>Line {0} is not a sample of a variable: it needs a time and a value</source>
        <translation>La ligne {0} n’est pas un échantillon d’une variable&#xa0;: il lui faut un temps et une valeur</translation>
    </message>
    <message>
        <source>The trace cannot be read as XML: {0}; save it again</source>
        <translation>La trace ne peut pas être lue comme XML&#xa0;: {0}&#x202f;; enregistrez-la de nouveau</translation>
    </message>
    <message>
        <source>{0} has {1} {1:value|values} but {2} {2:time|times}; save the trace again</source>
        <translation>{0} a {1} {1:valeur|valeurs} mais {2} {2:temps|temps}&#x202f;; enregistrez la trace de nouveau</translation>
    </message>
    <message>
        <source>The times of {0} run backwards; save the trace again</source>
        <translation>Les temps de {0} reculent&#x202f;; enregistrez la trace de nouveau</translation>
    </message>
    <message>
        <source>The file is empty; export the table again</source>
        <translation>Le fichier est vide&#x202f;; exportez de nouveau le tableau</translation>
    </message>
    <message>
        <source>The table has {0} columns {1}; give each its own heading</source>
        <translation>Le tableau a {0} colonnes {1}&#x202f;; donnez à chacune son propre en-tête</translation>
    </message>
    <message>
        <source>Column {0} has no numbers; choose one of {1}</source>
        <translation>La colonne {0} ne contient pas de nombres&#x202f;; choisissez-en une parmi {1}</translation>
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
        <translation>Se connecter à un automate</translation>
    </message>
    <message>
        <source>from the file attach-code of the controller</source>
        <translation>du fichier attach-code de l’automate</translation>
    </message>
    <message>
        <source>only for certificates that this computer does not know</source>
        <translation>certificats inconnus de cet ordinateur</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose a certificate</source>
        <translation>Choisir un certificat</translation>
    </message>
    <message>
        <source>Trusted certificate</source>
        <translation>Certificat de confiance</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>Se connecter</translation>
    </message>
    <message>
        <source>Choose a Certificate</source>
        <translation>Choisir un certificat</translation>
    </message>
    <message>
        <source>Certificates (*.pem *.crt *.cer);;All files (*)</source>
        <translation>Certificats (*.pem *.crt *.cer);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Attaching…</source>
        <translation>Connexion…</translation>
    </message>
</context>
<context>
    <name>plc::app::Attachment</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Se déconnecter</translation>
    </message>
    <message>
        <source>Attached to %1</source>
        <translation>Connecté à %1</translation>
    </message>
    <message>
        <source>Attached to %1; its program is not the one that is open here</source>
        <translation>Connecté à %1&#x202f;; son programme n’est pas celui qui est ouvert ici</translation>
    </message>
    <message>
        <source>Connection to %1 lost – reconnecting…</source>
        <translation>Connexion à %1 perdue – reconnexion…</translation>
    </message>
    <message>
        <source>Attaching to %1…</source>
        <translation>Connexion à %1…</translation>
    </message>
    <message>
        <source>The controller runs remotely; values written and forced here take effect there</source>
        <translation>L’automate s’exécute à distance&#x202f;; les valeurs écrites et forcées ici agissent là-bas</translation>
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
        <translation>%1 en liste d’instructions</translation>
    </message>
    <message>
        <source>Instruction list (current text)</source>
        <translation>Liste d’instructions (texte actuel)</translation>
    </message>
    <message>
        <source>ST (current text)</source>
        <translation>ST (texte actuel)</translation>
    </message>
    <message>
        <source>The same as ST</source>
        <translation>L’équivalent en ST</translation>
    </message>
    <message>
        <source>The same as an instruction list</source>
        <translation>L’équivalent en liste d’instructions</translation>
    </message>
    <message>
        <source>Both give the same results. Replacing can be undone in one step; comments are kept, each above its statement.</source>
        <translation>Les deux donnent les mêmes résultats. Le remplacement peut être annulé en une seule étape&#x202f;; les commentaires restent, chacun au-dessus de son instruction.</translation>
    </message>
    <message>
        <source>Replace the Text</source>
        <translation>Remplacer le texte</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
</context>
<context>
    <name>plc::app::DesignPages</name>
    <message>
        <source>Texts</source>
        <translation>Textes</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recettes</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Utilisateurs et droits</translation>
    </message>
    <message>
        <source>New Panel</source>
        <translation>Nouvelle vue</translation>
    </message>
    <message>
        <source>Name of the panel:</source>
        <translation>Nom de la vue&#xa0;:</translation>
    </message>
    <message>
        <source>overview</source>
        <translation>vue_generale</translation>
    </message>
    <message>
        <source>A panel&apos;s name cannot contain / or \; choose another name</source>
        <translation>Le nom d’une vue ne peut contenir ni / ni \&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>%1 was changed. Save it?</source>
        <translation>%1 a été modifié. L’enregistrer&#x202f;?</translation>
    </message>
</context>
<context>
    <name>plc::app::DevicesView</name>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>connexion en cours</translation>
    </message>
    <message>
        <source>online</source>
        <translation>en ligne</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bon</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>encore rien</translation>
    </message>
    <message>
        <source>refused by the device</source>
        <translation>refusé par l’appareil</translation>
    </message>
    <message>
        <source>does not fit</source>
        <translation>ne tient pas</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Appareils</translation>
    </message>
    <message>
        <source>Device or channel</source>
        <translation>Appareil ou voie</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Traffic</source>
        <translation>Échanges</translation>
    </message>
    <message>
        <source>Fields of the device or channel</source>
        <translation>Champs de l’appareil ou de la voie</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Champ</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Contenu</translation>
    </message>
    <message>
        <source>Connect or disconnect the devices</source>
        <translation>Connecter ou déconnecter les appareils</translation>
    </message>
    <message>
        <source>Add a device</source>
        <translation>Ajouter un appareil</translation>
    </message>
    <message>
        <source>This project has no devices yet. A device (Modbus, MQTT) brings values from outside into variables and takes values of variables out.</source>
        <translation>Ce projet n’a pas encore d’appareil. Un appareil (Modbus, MQTT) apporte des valeurs extérieures dans des variables et transmet des valeurs de variables vers l’extérieur.</translation>
    </message>
    <message>
        <source>Modbus TCP device</source>
        <translation>Appareil Modbus TCP</translation>
    </message>
    <message>
        <source>Modbus RTU device (serial)</source>
        <translation>Appareil Modbus RTU (série)</translation>
    </message>
    <message>
        <source>Modbus TCP server</source>
        <translation>Serveur Modbus TCP</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>Broker MQTT</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Ajouter une voie</translation>
    </message>
    <message>
        <source>Delete the device or channel</source>
        <translation>Supprimer l’appareil ou la voie</translation>
    </message>
    <message>
        <source>Propose addresses for channels without a variable</source>
        <translation>Proposer des adresses pour les voies sans variable</translation>
    </message>
    <message>
        <source>Undo the last change of the devices</source>
        <translation>Annuler la dernière modification des appareils</translation>
    </message>
    <message>
        <source>Every channel has a variable</source>
        <translation>Chaque voie a une variable</translation>
    </message>
    <message numerus="yes">
        <source>%n address(es) proposed</source>
        <translation>
            <numerusform>%n adresse proposée</numerusform>
            <numerusform>%n adresses proposées</numerusform>
        </translation>
    </message>
    <message>
        <source>not enabled</source>
        <translation>non activé</translation>
    </message>
    <message>
        <source>%1 requests, %2 errors, %3 ms</source>
        <translation>%1 requêtes, %2 erreurs, %3&#xa0;ms</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>non connecté</translation>
    </message>
    <message>
        <source>online: %1 of %2</source>
        <translation>en ligne&#xa0;: %1 sur %2</translation>
    </message>
    <message>
        <source>“%1” in devices.json</source>
        <translation>«&#xa0;%1&#xa0;» dans devices.json</translation>
    </message>
</context>
<context>
    <name>plc::app::EditorTabs</name>
    <message>
        <source>Documents</source>
        <translation>Documents</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close Others</source>
        <translation>Fermer les autres</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>%1 was changed. Save it?</source>
        <translation>%1 a été modifié. L’enregistrer&#x202f;?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were changed: %1. Save them?</source>
        <translation>
            <numerusform>%n fichier a été modifié&#xa0;: %1. L’enregistrer&#x202f;?</numerusform>
            <numerusform>%n fichiers ont été modifiés&#xa0;: %1. Les enregistrer&#x202f;?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s); those edited since stay as they are</source>
        <translation>
            <numerusform>Modifié dans %n fichier&#x202f;; ceux modifiés depuis restent tels quels</numerusform>
            <numerusform>Modifié dans %n fichiers&#x202f;; ceux modifiés depuis restent tels quels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s)</source>
        <translation>
            <numerusform>Modifié dans %n fichier</numerusform>
            <numerusform>Modifié dans %n fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>Read-only file</source>
        <translation>Fichier en lecture seule</translation>
    </message>
    <message>
        <source>%1 is read-only. Replace it anyway? It stays read-only.</source>
        <translation>%1 est en lecture seule. Le remplacer quand même&#x202f;? Il reste en lecture seule.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>%1 was not saved</source>
        <translation>%1 n’a pas été enregistré</translation>
    </message>
    <message>
        <source>%1 is not a variable of the running program; check the name, or press F5 to build the program</source>
        <translation>%1 n’est pas une variable du programme en cours&#x202f;; vérifiez le nom ou compilez le programme avec F5</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Forcer</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Écrire</translation>
    </message>
</context>
<context>
    <name>plc::app::ExplanationDialog</name>
    <message>
        <source>Explanation</source>
        <translation>Explication</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <extracomment>an example&apos;s line, then what is wrong there</extracomment>
        <translation>Ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>What %1 Means</source>
        <translation>Ce que signifie %1</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Incorrect</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Correct</translation>
    </message>
    <message>
        <source>Put the cursor on a problem, or choose one in the list, and press F1 again</source>
        <translation>Placez le curseur sur un problème ou choisissez-en un dans la liste, puis appuyez de nouveau sur F1</translation>
    </message>
    <message>
        <source>There is no page for %1; choose a code from the list</source>
        <translation>Il n’existe pas de page pour %1&#x202f;; choisissez un code de la liste</translation>
    </message>
</context>
<context>
    <name>plc::app::ExportDialog</name>
    <message>
        <source>Export the Project</source>
        <translation>Exporter le projet</translation>
    </message>
    <message>
        <source>PLCopen XML 0200, for CODESYS and TwinCAT</source>
        <translation>PLCopen XML 0200, pour CODESYS et TwinCAT</translation>
    </message>
    <message>
        <source>PLCopen XML 0201, for Beremiz and OpenPLC</source>
        <translation>PLCopen XML 0201, pour Beremiz et OpenPLC</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Fichier…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Format:</source>
        <translation>Format&#xa0;:</translation>
    </message>
    <message>
        <source>To:</source>
        <translation>Vers&#xa0;:</translation>
    </message>
    <message>
        <source>This file exists and will be replaced</source>
        <translation>Ce fichier existe et sera remplacé</translation>
    </message>
</context>
<context>
    <name>plc::app::FileCommands</name>
    <message>
        <source>New Trace</source>
        <translation>Nouvelle trace</translation>
    </message>
    <message>
        <source>Name of the trace:</source>
        <translation>Nom de la trace&#xa0;:</translation>
    </message>
    <message>
        <source>trace</source>
        <translation>trace</translation>
    </message>
    <message>
        <source>A file name cannot contain / or \; choose another name</source>
        <translation>Un nom de fichier ne peut contenir ni / ni \&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>A trace %1 already exists; choose another name</source>
        <translation>Une trace %1 existe déjà&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>New name of %1:</source>
        <translation>Nouveau nom de %1&#xa0;:</translation>
    </message>
    <message>
        <source>A file %1 already exists; choose another name</source>
        <translation>Un fichier %1 existe déjà&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>The file cannot be renamed; check the permissions of the folder</source>
        <translation>Le fichier ne peut pas être renommé&#x202f;; vérifiez les droits du dossier</translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>Supprimer %1&#x202f;?</translation>
    </message>
    <message>
        <source>It contains %1.</source>
        <translation>Il contient %1.</translation>
    </message>
    <message>
        <source>These panels link to it; their buttons will be reported as errors: %1</source>
        <translation>Ces vues y renvoient&#x202f;; leurs boutons seront signalés comme erreurs&#xa0;: %1</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>The file cannot be removed; check the permissions of the folder</source>
        <translation>Le fichier ne peut pas être supprimé&#x202f;; vérifiez les droits du dossier</translation>
    </message>
</context>
<context>
    <name>plc::app::GuideView</name>
    <message>
        <source>About this project</source>
        <translation>À propos de ce projet</translation>
    </message>
    <message>
        <source>A README.md in the project&apos;s folder is shown here.</source>
        <translation>Un README.md dans le dossier du projet est affiché ici.</translation>
    </message>
</context>
<context>
    <name>plc::app::ImportDialog</name>
    <message>
        <source>Place</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Objects: %1
Bodies: %2
Not kept: %3</source>
        <translation>Objets&#xa0;: %1
Corps&#xa0;: %2
Non conservés&#xa0;: %3</translation>
    </message>
    <message>
        <source>Import a Project</source>
        <translation>Importer un projet</translation>
    </message>
    <message>
        <source>PLCopen XML, TwinCAT or CODESYS files, structured text</source>
        <translation>PLCopen XML, fichiers TwinCAT ou CODESYS, texte structuré</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Fichier…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Dossier…</translation>
    </message>
    <message>
        <source>Source files</source>
        <translation>Fichiers sources</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>From:</source>
        <translation>Depuis&#xa0;:</translation>
    </message>
    <message>
        <source>New project in:</source>
        <translation>Nouveau projet dans&#xa0;:</translation>
    </message>
    <message>
        <source>Projects of other tools (%1)</source>
        <translation>Projets d’autres outils (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>This folder is not empty; name a new one</source>
        <translation>Ce dossier n’est pas vide&#x202f;; indiquez-en un nouveau</translation>
    </message>
    <message>
        <source>program units</source>
        <translation>POU</translation>
    </message>
    <message>
        <source>data types</source>
        <translation>types de données</translation>
    </message>
    <message>
        <source>global variable lists</source>
        <translation>listes de variables globales</translation>
    </message>
    <message>
        <source>configurations</source>
        <translation>configurations</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>textes</translation>
    </message>
    <message>
        <source>files</source>
        <translation>fichiers</translation>
    </message>
    <message>
        <source>PLCopen XML, TwinCAT, CODESYS, ST</source>
        <translation>PLCopen XML, TwinCAT, CODESYS, ST</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message>
        <source>Becomes a separate project with the libraries it uses</source>
        <translation>Devient un projet à part, avec les bibliothèques qu’il utilise</translation>
    </message>
    <message>
        <source>Writing the project…</source>
        <translation>Écriture du projet…</translation>
    </message>
    <message>
        <source>Encoding:</source>
        <translation>Encodage&#xa0;:</translation>
    </message>
    <message>
        <source>Recognised</source>
        <translation>Détecté</translation>
    </message>
    <message>
        <source>For files that are not in Unicode and do not specify their encoding</source>
        <translation>Pour les fichiers qui ne sont pas en Unicode et ne déclarent pas leur encodage</translation>
    </message>
</context>
<context>
    <name>plc::app::InsideViews</name>
    <message>
        <source>Coverage of the latest %1 of %2 recorded scans</source>
        <translation>Couverture des %1 derniers cycles sur %2 enregistrés</translation>
    </message>
    <message>
        <source>There is no recording yet: run the program first.</source>
        <translation>Il n’y a pas encore d’enregistrement&#xa0;: exécutez d’abord le programme.</translation>
    </message>
    <message>
        <source>Put the cursor on a variable, or select an expression, to ask about it</source>
        <translation>Placez le curseur sur une variable, ou sélectionnez une expression, pour poser une question à son sujet</translation>
    </message>
</context>
<context>
    <name>plc::app::InstanceBar</name>
    <message>
        <source>Instance whose values are shown</source>
        <translation>Instance dont les valeurs sont affichées</translation>
    </message>
    <message>
        <source>Values of the instance of %1:</source>
        <translation>Valeurs de l’instance de %1&#xa0;:</translation>
    </message>
</context>
<context>
    <name>plc::app::LiveViews</name>
    <message>
        <source>Panel shown</source>
        <translation>Vue affichée</translation>
    </message>
    <message>
        <source>Full screen (Esc to exit)</source>
        <translation>Plein écran (Échap pour quitter)</translation>
    </message>
    <message>
        <source>This project has no panel yet.
To draw one, right-click Panels in the project tree and choose New.</source>
        <translation>Ce projet n’a pas encore de vue.
Pour en dessiner une, cliquez avec le bouton droit sur Vues dans l’arborescence du projet et choisissez Nouveau.</translation>
    </message>
    <message>
        <source>No panel can be read: %1.
Problems says what is wrong; a double click there opens the file as text.</source>
        <translation>Aucune vue n’est lisible&#xa0;: %1.
Problèmes indique ce qui ne va pas&#x202f;; un double-clic y ouvre le fichier en texte.</translation>
    </message>
    <message>
        <source>The alarm history is kept in memory only: %1</source>
        <translation>L’historique des alarmes n’est conservé qu’en mémoire&#xa0;: %1</translation>
    </message>
    <message>
        <source>Saving the recording…</source>
        <translation>Écriture de l’enregistrement…</translation>
    </message>
    <message>
        <source>Export the alarm history…</source>
        <translation>Exporter l’historique des alarmes…</translation>
    </message>
    <message>
        <source>Export the Alarm History</source>
        <translation>Exporter l’historique des alarmes</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Vue</translation>
    </message>
</context>
<context>
    <name>plc::app::MainWindow</name>
    <message>
        <source>Project</source>
        <translation>Projet</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Surveillance</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Forçages</translation>
    </message>
    <message>
        <source>Call Stack</source>
        <translation>Pile d’appels</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>Points d’arrêt</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tâches</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Recent Projects</source>
        <translation>Projets récents</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Barre d’outils</translation>
    </message>
    <message>
        <source>State of the controller</source>
        <translation>État de l’automate</translation>
    </message>
    <message>
        <source>%1 : %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>OFFLINE</source>
        <translation>HORS LIGNE</translation>
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
        <translation>HALTE</translation>
    </message>
    <message>
        <source>FAULT</source>
        <translation>ERREUR</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>PAST</source>
        <translation>PASSÉ</translation>
    </message>
    <message>
        <source>%1 · scan %2</source>
        <translation>%1 · cycle %2</translation>
    </message>
    <message>
        <source>%1 µs · %2 % load</source>
        <translation>%1&#xa0;µs · charge %2&#xa0;%</translation>
    </message>
    <message>
        <source>%1 MB recorded</source>
        <translation>%1&#xa0;Mo enregistrés</translation>
    </message>
    <message>
        <source>%1 scans of %2 MB at most</source>
        <translation>%1 cycles, %2&#xa0;Mo au maximum</translation>
    </message>
    <message>
        <source>Go to the line</source>
        <translation>Aller à la ligne</translation>
    </message>
    <message>
        <source>no problems</source>
        <translation>aucun problème</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Ouvrir un projet</translation>
    </message>
    <message>
        <source>%1 – Stepwise</source>
        <translation>%1 – Stepwise</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Récupération</translation>
    </message>
    <message>
        <source>Stepwise was closed without saving. Unsaved changes to %1 were kept. Restore them?</source>
        <translation>Stepwise a été fermé sans enregistrer. Les modifications non enregistrées de %1 ont été conservées. Les restaurer&#x202f;?</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliothèques</translation>
    </message>
    <message>
        <source>Running tests…</source>
        <translation>Les tests sont en cours…</translation>
    </message>
    <message>
        <source>passed: %1</source>
        <translation>réussi&#xa0;: %1</translation>
    </message>
    <message>
        <source>FAILED: %1</source>
        <translation>ÉCHEC&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 passed, %2 failed</source>
        <translation>Réussis&#xa0;: %1, en échec&#xa0;: %2</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Temps réel</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>Aussi vite que possible</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Memory for the recording of every scan [MB]:</source>
        <translation>Mémoire pour l’enregistrement de chaque cycle [Mo]&#xa0;:</translation>
    </message>
    <message>
        <source>Save the Recording</source>
        <translation>Sauvegarder l’enregistrement</translation>
    </message>
    <message>
        <source>Recordings (*.rec)</source>
        <translation>Enregistrements (*.rec)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>About Stepwise</source>
        <translation>À propos de Stepwise</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bienvenue</translation>
    </message>
    <message>
        <source>The project</source>
        <translation>Le projet</translation>
    </message>
    <message>
        <source>Programs, blocks, tasks, panels, traces and tests, made from the text files in the folder.</source>
        <translation>Programmes, blocs, tâches, vues, traces et tests, issus des fichiers texte du dossier.</translation>
    </message>
    <message>
        <source>The program</source>
        <translation>Le programme</translation>
    </message>
    <message>
        <source>Structured Text with semantic highlighting. Errors are underlined as you type; Alt+Enter offers quick fixes; Ctrl+Space completes.</source>
        <translation>Texte structuré avec coloration sémantique. Les erreurs sont soulignées pendant la saisie&#x202f;; Alt+Entrée propose des corrections rapides&#x202f;; Ctrl+Espace complète.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Exécuter</translation>
    </message>
    <message>
        <source>F5 compiles to native code and runs it. Values then appear next to each line.</source>
        <translation>F5 compile en code natif et exécute. Les valeurs s’affichent alors à côté de chaque ligne.</translation>
    </message>
    <message>
        <source>Any expression, at any moment. Prepare a value and write or force it with one click.</source>
        <translation>N’importe quelle expression, à tout moment. Préparez une valeur, puis écrivez-la ou forcez-la d’un clic.</translation>
    </message>
    <message>
        <source>The trace</source>
        <translation>La trace</translation>
    </message>
    <message>
        <source>Nothing has to be selected in advance: every scan is recorded, and any expression can be charted afterwards.</source>
        <translation>Il n’y a rien à choisir à l’avance&#xa0;: chaque cycle est enregistré, et une courbe de n’importe quelle expression peut être tracée après coup.</translation>
    </message>
    <message>
        <source>The panel</source>
        <translation>La vue</translation>
    </message>
    <message>
        <source>What the operator sees, in the languages of the machine. It works here as it will on the machine.</source>
        <translation>Ce que voit l’opérateur, dans les langues de la machine. Elle fonctionne ici comme sur la machine.</translation>
    </message>
    <message>
        <source>Time runs backwards, too</source>
        <translation>Le temps s’écoule aussi à rebours</translation>
    </message>
    <message>
        <source>That’s it</source>
        <translation>C’est tout</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P finds every command. The start page has more machines to play with.</source>
        <translation>Ctrl+Maj+P trouve chaque commande. La page de démarrage propose d’autres machines à essayer.</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>Nouveau projet…</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>Ouvrir un projet…</translation>
    </message>
    <message>
        <source>Close Project</source>
        <translation>Fermer le projet</translation>
    </message>
    <message>
        <source>New Program, Block, Type…</source>
        <translation>Ajouter un programme, un bloc, un type…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>New Panel…</source>
        <translation>Nouvelle vue…</translation>
    </message>
    <message>
        <source>Panel Texts</source>
        <translation>Textes des vues</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Enregistrer tout</translation>
    </message>
    <message>
        <source>Close Document</source>
        <translation>Fermer le document</translation>
    </message>
    <message>
        <source>Libraries…</source>
        <translation>Bibliothèques…</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Paramètres…</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>Rechercher…</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Remplacer…</translation>
    </message>
    <message>
        <source>Find Next</source>
        <translation>Rechercher le suivant</translation>
    </message>
    <message>
        <source>Find Previous</source>
        <translation>Rechercher le précédent</translation>
    </message>
    <message>
        <source>Find in All Files…</source>
        <translation>Rechercher dans tous les fichiers…</translation>
    </message>
    <message>
        <source>Go to Line…</source>
        <translation>Aller à la ligne…</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Aller à la définition</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Rechercher les références</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Compléter</translation>
    </message>
    <message>
        <source>Quick Fix (Alt+Enter)</source>
        <translation>Correction rapide (Alt+Entrée)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Mettre en forme</translation>
    </message>
    <message>
        <source>Toggle Comment (Ctrl+/)</source>
        <translation>Commenter ou décommenter (Ctrl+/)</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer la ligne</translation>
    </message>
    <message>
        <source>Select Enclosing Block</source>
        <translation>Sélectionner le bloc englobant</translation>
    </message>
    <message>
        <source>Go to Matching Keyword</source>
        <translation>Aller au mot-clé correspondant</translation>
    </message>
    <message>
        <source>Next Problem</source>
        <translation>Problème suivant</translation>
    </message>
    <message>
        <source>Previous Problem</source>
        <translation>Problème précédent</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Compiler</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Single Scan</source>
        <translation>Un seul cycle</translation>
    </message>
    <message>
        <source>Step Into</source>
        <translation>Pas à pas détaillé</translation>
    </message>
    <message>
        <source>Step Over</source>
        <translation>Pas à pas principal</translation>
    </message>
    <message>
        <source>Step Out</source>
        <translation>Pas à pas sortant</translation>
    </message>
    <message>
        <source>Run to Cursor</source>
        <translation>Exécuter jusqu’au curseur</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Basculer le point d’arrêt</translation>
    </message>
    <message>
        <source>Reset Warm</source>
        <translation>Reset à chaud</translation>
    </message>
    <message>
        <source>Reset Cold</source>
        <translation>Reset à froid</translation>
    </message>
    <message>
        <source>Reset Origin</source>
        <translation>Reset d’origine</translation>
    </message>
    <message>
        <source>Online Change</source>
        <translation>Modification en ligne</translation>
    </message>
    <message>
        <source>Speed…</source>
        <translation>Vitesse…</translation>
    </message>
    <message>
        <source>Memory for the Recording…</source>
        <translation>Mémoire pour l’enregistrement…</translation>
    </message>
    <message>
        <source>Save the Recording…</source>
        <translation>Sauvegarder l’enregistrement…</translation>
    </message>
    <message>
        <source>Write Prepared Values</source>
        <translation>Écrire les valeurs préparées</translation>
    </message>
    <message>
        <source>Force Prepared Values</source>
        <translation>Forcer les valeurs préparées</translation>
    </message>
    <message>
        <source>Release All Forces</source>
        <translation>Lever tous les forçages</translation>
    </message>
    <message>
        <source>Run the Tests</source>
        <translation>Exécuter les tests</translation>
    </message>
    <message>
        <source>One Scan Back</source>
        <translation>Un cycle en arrière</translation>
    </message>
    <message>
        <source>One Scan Forward</source>
        <translation>Un cycle en avant</translation>
    </message>
    <message>
        <source>Back to Live</source>
        <translation>Retour au direct</translation>
    </message>
    <message>
        <source>Resume from Here</source>
        <translation>Reprendre ici</translation>
    </message>
    <message>
        <source>Command Palette</source>
        <translation>Palette de commandes</translation>
    </message>
    <message>
        <source>Split the Editor</source>
        <translation>Fractionner l’éditeur</translation>
    </message>
    <message>
        <source>Declarations as a Table</source>
        <translation>Déclarations en tableau</translation>
    </message>
    <message>
        <source>Online Values in the Text</source>
        <translation>Valeurs en ligne dans le texte</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Agrandir</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Réduire</translation>
    </message>
    <message>
        <source>Light Theme</source>
        <translation>Thème clair</translation>
    </message>
    <message>
        <source>Dark Theme</source>
        <translation>Thème sombre</translation>
    </message>
    <message>
        <source>System Theme</source>
        <translation>Thème du système</translation>
    </message>
    <message>
        <source>Reset the Layout</source>
        <translation>Réinitialiser la disposition</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>Open a Recording…</source>
        <translation>Ouvrir un enregistrement…</translation>
    </message>
    <message>
        <source>All values are from a recording file. Click to go back to the controller.</source>
        <translation>Toutes les valeurs proviennent d’un enregistrement dans un fichier. Un clic ramène à l’automate.</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>ENREGISTREMENT</translation>
    </message>
    <message>
        <source>%1 – back to live</source>
        <translation>%1 – retour au direct</translation>
    </message>
    <message>
        <source>Open a Recording</source>
        <translation>Ouvrir un enregistrement</translation>
    </message>
    <message>
        <source>Show as ST…</source>
        <translation>Afficher en ST…</translation>
    </message>
    <message>
        <source>Show as an Instruction List…</source>
        <translation>Afficher en liste d’instructions…</translation>
    </message>
    <message>
        <source>New Trace…</source>
        <translation>Nouvelle trace…</translation>
    </message>
    <message>
        <source>The build was cancelled; everything is as it was</source>
        <translation>La compilation a été annulée&#x202f;; tout est comme avant</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Tests</translation>
    </message>
    <message>
        <source>The tests were cancelled</source>
        <translation>Les tests ont été annulés</translation>
    </message>
    <message>
        <source>Cancelled: nothing was saved</source>
        <translation>Annulé&#xa0;: rien n’a été enregistré</translation>
    </message>
    <message>
        <source>%1 is encoded in %2 and will be saved in that encoding</source>
        <translation>%1 est encodé en %2 et sera enregistré dans cet encodage</translation>
    </message>
    <message>
        <source>This is a copy of the example, in %1: change what you like</source>
        <translation>Ceci est une copie de l’exemple, dans %1&#xa0;: modifiez ce que vous voulez</translation>
    </message>
    <message>
        <source>This is your copy of the example, in %1</source>
        <translation>Ceci est votre copie de l’exemple, dans %1</translation>
    </message>
    <message>
        <source>The language changes when the tests have ended</source>
        <translation>La langue change quand les tests sont terminés</translation>
    </message>
    <message>
        <source>Controller fault</source>
        <translation>Erreur de l’automate</translation>
    </message>
    <message>
        <source>RUN %1</source>
        <translation>RUN %1</translation>
    </message>
    <message>
        <source>at full speed</source>
        <translation>à pleine vitesse</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Speed of the controller; any factor can be entered:</source>
        <translation>Vitesse de l’automate&#x202f;; tout facteur peut être saisi&#xa0;:</translation>
    </message>
    <message>
        <source>The speed is a factor from 0.001 to 10000</source>
        <translation>La vitesse est un facteur de 0,001 à 10000</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importer…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>The project was exported</source>
        <translation>Le projet a été exporté</translation>
    </message>
    <message>
        <source>Add Next Occurrence to Selection</source>
        <translation>Sélectionner aussi l’occurrence suivante</translation>
    </message>
    <message>
        <source>Arrange for Editing</source>
        <translation>Disposition pour l’édition</translation>
    </message>
    <message>
        <source>Arrange for Debugging</source>
        <translation>Disposition pour le débogage</translation>
    </message>
    <message>
        <source>Arrange for Drawing Panels</source>
        <translation>Disposition pour dessiner des vues</translation>
    </message>
    <message>
        <source>Maximise the Editor</source>
        <translation>Agrandir l’éditeur</translation>
    </message>
    <message>
        <source>Keeping the recording of the last run…</source>
        <translation>Conservation de l’enregistrement de la dernière exécution…</translation>
    </message>
    <message>
        <source>Diagram Beside the Text</source>
        <translation>Schéma à côté du texte</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>Signet</translation>
    </message>
    <message>
        <source>Next Bookmark</source>
        <translation>Signet suivant</translation>
    </message>
    <message>
        <source>Previous Bookmark</source>
        <translation>Signet précédent</translation>
    </message>
    <message>
        <source>Open Another File Beside…</source>
        <translation>Ouvrir un autre fichier à côté…</translation>
    </message>
    <message>
        <source>About This Project</source>
        <translation>À propos de ce projet</translation>
    </message>
    <message>
        <source>The project has no other file</source>
        <translation>Le projet n’a pas d’autre fichier</translation>
    </message>
    <message>
        <source>The tour runs on an example, and none is installed: open or create a project and start the tour again</source>
        <translation>La visite guidée utilise un exemple et aucun n’est installé&#xa0;: ouvrez ou créez un projet et relancez la visite guidée</translation>
    </message>
    <message>
        <source>Open Another File Beside</source>
        <translation>Ouvrir un autre fichier à côté</translation>
    </message>
    <message>
        <source>%1 Nothing can break: the plant is only a simulation. Press Next to look around for a minute, or F5 to run it straight away.</source>
        <translation>%1 Rien ne peut être endommagé&#xa0;: l’installation n’est qu’une simulation. Cliquez sur Suivant pour une courte visite, ou appuyez sur F5 pour démarrer tout de suite.</translation>
    </message>
    <message>
        <source>This is the project %1.</source>
        <translation>Voici le projet %1.</translation>
    </message>
    <message>
        <source>What to press</source>
        <translation>Sur quoi appuyer</translation>
    </message>
    <message>
        <source>The page next to the program is the project&apos;s README: what it shows, what to press, what to watch.</source>
        <translation>La page à côté du programme est le README du projet&#xa0;: ce qu’il affiche, sur quoi appuyer, ce qu’il faut surveiller.</translation>
    </message>
    <message>
        <source>What the operator sees. This project has no panel yet; new ones are drawn with the mouse.</source>
        <translation>Ce que voit l’opérateur. Ce projet n’a pas encore de vue&#x202f;; les nouvelles se dessinent à la souris.</translation>
    </message>
    <message>
        <source>Drag the time slider, or press Alt+PgUp: code, charts and panel show the past. “Resume from Here” continues from there.</source>
        <translation>Faites glisser le curseur temporel, ou appuyez sur Alt+Page préc&#xa0;: le code, les courbes et la vue affichent le passé. «&#xa0;Reprendre ici&#xa0;» repart de là.</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Walk Through the Scan</source>
        <translation>Parcourir le cycle</translation>
    </message>
    <message>
        <source>Step Back In</source>
        <translation>Pas détaillé en arrière</translation>
    </message>
    <message>
        <source>Step Back Over</source>
        <translation>Pas principal en arrière</translation>
    </message>
    <message>
        <source>Step Back Out</source>
        <translation>Pas sortant en arrière</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Pourquoi&#x202f;?</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>Pourquoi pas&#x202f;?</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>Qui a écrit cela&#x202f;?</translation>
    </message>
    <message>
        <source>What If…</source>
        <translation>Et si…</translation>
    </message>
    <message>
        <source>Coverage of the Recording</source>
        <translation>Couverture de l’enregistrement</translation>
    </message>
    <message>
        <source>Hide the Coverage</source>
        <translation>Masquer la couverture</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Pourquoi</translation>
    </message>
    <message>
        <source>Slow Scan</source>
        <translation>Cycle au ralenti</translation>
    </message>
    <message>
        <source>What if? needs a running controller: a recording from a file cannot be resumed; press F5 to run the program</source>
        <translation>«&#xa0;Et si&#xa0;» demande un automate en marche&#xa0;: un enregistrement ouvert depuis un fichier ne peut pas être repris&#x202f;; appuyez sur F5 pour exécuter le programme</translation>
    </message>
    <message>
        <source>Explain the Problem</source>
        <translation>Expliquer le problème</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recettes</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Utilisateurs et droits</translation>
    </message>
    <message>
        <source>Connect or Disconnect the Devices</source>
        <translation>Connecter ou déconnecter les appareils</translation>
    </message>
    <message>
        <source>Hide Dock Automatically</source>
        <translation>Masquer le volet automatiquement</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Appareils</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Stepwise %1&lt;/h3&gt;&lt;p&gt;An open PLC studio: IEC 61131-3 programs as native code, every scan recorded, operator panels in many languages.&lt;/p&gt;&lt;p&gt;Licence: GPL-3.0&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Stepwise %1&lt;/h3&gt;&lt;p&gt;Un studio API ouvert&#xa0;: programmes CEI 61131-3 en code natif, chaque cycle enregistré, vues d’exploitation en plusieurs langues.&lt;/p&gt;&lt;p&gt;Licence&#xa0;: GPL-3.0&lt;/p&gt;</translation>
    </message>
    <message>
        <source>High-Contrast Theme</source>
        <translation>Thème à contraste élevé</translation>
    </message>
    <message>
        <source>Attach to a Controller…</source>
        <translation>Se connecter à un automate…</translation>
    </message>
    <message>
        <source>Detach from the Controller</source>
        <translation>Se déconnecter de l’automate</translation>
    </message>
    <message>
        <source>Build a Native Program…</source>
        <translation>Créer un programme natif…</translation>
    </message>
    <message>
        <source>%1 arranges the window for drawing panels</source>
        <translation>%1 dispose la fenêtre pour dessiner des vues</translation>
    </message>
    <message>
        <source>Close Other Documents</source>
        <translation>Fermer les autres documents</translation>
    </message>
    <message>
        <source>Fold or Unfold the Block</source>
        <translation>Replier ou déplier le bloc</translation>
    </message>
    <message>
        <source>Fold or Unfold All</source>
        <translation>Tout replier ou déplier</translation>
    </message>
    <message>
        <source>Previous Pass of the Loop</source>
        <translation>Passage précédent de la boucle</translation>
    </message>
    <message>
        <source>Next Pass of the Loop</source>
        <translation>Passage suivant de la boucle</translation>
    </message>
    <message>
        <source>Context Menu</source>
        <translation>Menu contextuel</translation>
    </message>
    <message>
        <source>Columns…</source>
        <translation>Colonnes…</translation>
    </message>
    <message>
        <source>Move Dock to the Next Side</source>
        <translation>Déplacer le volet vers le côté suivant</translation>
    </message>
    <message>
        <source>Float or Dock Again</source>
        <translation>Détacher ou ancrer de nouveau</translation>
    </message>
    <message>
        <source>Next Pane</source>
        <translation>Volet suivant</translation>
    </message>
    <message>
        <source>Previous Pane</source>
        <translation>Volet précédent</translation>
    </message>
    <message>
        <source>Wider Pane</source>
        <translation>Élargir le volet</translation>
    </message>
    <message>
        <source>Narrower Pane</source>
        <translation>Rétrécir le volet</translation>
    </message>
    <message>
        <source>Taller Pane</source>
        <translation>Augmenter la hauteur du volet</translation>
    </message>
    <message>
        <source>Shorter Pane</source>
        <translation>Réduire la hauteur du volet</translation>
    </message>
    <message>
        <source>Move Document Left</source>
        <translation>Déplacer le document à gauche</translation>
    </message>
    <message>
        <source>Move Document Right</source>
        <translation>Déplacer le document à droite</translation>
    </message>
    <message>
        <source>Show Tooltip at the Cursor</source>
        <translation>Afficher l’info-bulle au curseur</translation>
    </message>
    <message>
        <source>There are no columns here; go to a table or a list with columns first</source>
        <translation>Il n’y a pas de colonnes ici&#x202f;; allez d’abord dans un tableau ou une liste avec des colonnes</translation>
    </message>
    <message>
        <source>Project Settings…</source>
        <translation>Paramètres du projet…</translation>
    </message>
    <message>
        <source>Panel Themes…</source>
        <translation>Thèmes des vues…</translation>
    </message>
</context>
<context>
    <name>plc::app::Menu</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Exécution</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Go To</source>
        <translation>Aller à</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Signets</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>Docks</source>
        <translation>Volets</translation>
    </message>
    <message>
        <source>Folding</source>
        <translation>Repliage</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Volets et documents</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Rechercher</translation>
    </message>
</context>
<context>
    <name>plc::app::MergeDialog</name>
    <message>
        <source>Compare %1</source>
        <translation>Comparer %1</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Précédente</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivante</translation>
    </message>
    <message>
        <source>Take Over</source>
        <translation>Adopter</translation>
    </message>
    <message>
        <source>Take Over All</source>
        <translation>Tout adopter</translation>
    </message>
    <message>
        <source>Here (this text is kept)</source>
        <translation>Ici (ce texte est conservé)</translation>
    </message>
    <message>
        <source>On disk</source>
        <translation>Sur le disque</translation>
    </message>
    <message>
        <source>Use the Text on the Left</source>
        <translation>Utiliser le texte de gauche</translation>
    </message>
    <message>
        <source>No differences</source>
        <translation>Aucune différence</translation>
    </message>
    <message>
        <source>Difference %1 of %2</source>
        <translation>Différence %1 sur %2</translation>
    </message>
</context>
<context>
    <name>plc::app::NativeProgramDialog</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Créer</translation>
    </message>
    <message>
        <source>Build a Native Program</source>
        <translation>Créer un programme natif</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Choisir le fichier</translation>
    </message>
    <message>
        <source>Native Program</source>
        <translation>Programme natif</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>The program runs without Stepwise on a machine with Linux: its PLC code and a small runner in one file.</source>
        <translation>Le programme s’exécute sans Stepwise sur une machine Linux&#xa0;: son code d’automate (API) et un petit moteur d’exécution dans un seul fichier.</translation>
    </message>
    <message>
        <source>Building…</source>
        <translation>Création…</translation>
    </message>
    <message>
        <source>%1 is built</source>
        <translation>%1 est créé</translation>
    </message>
</context>
<context>
    <name>plc::app::NewProjectDialog</name>
    <message>
        <source>Empty</source>
        <translation>Vide</translation>
    </message>
    <message>
        <source>One program in a task of 10 ms</source>
        <translation>Un programme dans une tâche de 10&#xa0;ms</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Moteur</translation>
    </message>
    <message>
        <source>Start, stop, a simulated motor and a test</source>
        <translation>Marche, arrêt, un moteur simulé et un test</translation>
    </message>
    <message>
        <source>PID loop</source>
        <translation>Boucle PID</translation>
    </message>
    <message>
        <source>A temperature loop with its plant</source>
        <translation>Une boucle de température avec son installation</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Séquence</translation>
    </message>
    <message>
        <source>Fill, mix, empty as a sequential function chart</source>
        <translation>Remplir, mélanger, vider, en grafcet (SFC)</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Nouveau projet</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>My machine</source>
        <translation>Ma machine</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Choisir un dossier</translation>
    </message>
    <message>
        <source>Folder of the project</source>
        <translation>Dossier du projet</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>In folder</source>
        <translation>Dans le dossier</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Créer</translation>
    </message>
    <message>
        <source>Enter a project name</source>
        <translation>Saisissez un nom de projet</translation>
    </message>
    <message>
        <source>%1 already exists and is not empty; choose another name</source>
        <translation>%1 existe déjà et n’est pas vide&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>Will be created in %1</source>
        <translation>Sera créé dans %1</translation>
    </message>
</context>
<context>
    <name>plc::app::NewUnitDialog</name>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Function block</source>
        <translation>Bloc fonctionnel</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Fonction</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Enumeration</source>
        <translation>Énumération</translation>
    </message>
    <message>
        <source>Interface</source>
        <translation>Interface</translation>
    </message>
    <message>
        <source>Global variables</source>
        <translation>Variables globales</translation>
    </message>
    <message>
        <source>Sequential function chart</source>
        <translation>Grafcet (SFC)</translation>
    </message>
    <message>
        <source>Simulation of the plant</source>
        <translation>Simulation de l’installation</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>a file of its own</source>
        <translation>un fichier à part</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Dans</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Créer</translation>
    </message>
    <message>
        <source>Enter a name</source>
        <translation>Saisissez un nom</translation>
    </message>
    <message>
        <source>A name has letters, digits and _, starts with a letter and is not a keyword</source>
        <translation>Un nom se compose de lettres, de chiffres et de _, commence par une lettre et n’est pas un mot-clé</translation>
    </message>
    <message>
        <source>%1 already exists in the project; choose another name</source>
        <translation>%1 existe déjà dans le projet&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>A file %1 already exists: choose it, or another name</source>
        <translation>Le fichier %1 existe déjà&#xa0;: choisissez-le, ou un autre nom</translation>
    </message>
    <message>
        <source>Program as a ladder diagram</source>
        <translation>Programme en schéma à contacts (LD)</translation>
    </message>
    <message>
        <source>Program as a function block diagram</source>
        <translation>Programme en diagramme de blocs fonctionnels (FBD)</translation>
    </message>
</context>
<context>
    <name>plc::app::PanelFiles</name>
    <message>
        <source>Texts</source>
        <translation>Textes</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Panel %1</source>
        <translation>Vue %1</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recettes</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Utilisateurs et droits</translation>
    </message>
    <message>
        <source>%1 is gone or cannot be reached: what is open stays here, and Save All writes it again</source>
        <translation>%1 a disparu ou n’est pas accessible&#xa0;: ce qui est ouvert reste ici et Enregistrer tout l’écrit à nouveau</translation>
    </message>
</context>
<context>
    <name>plc::app::ProblemsView</name>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>Show errors</source>
        <translation>Afficher les erreurs</translation>
    </message>
    <message>
        <source>Show warnings</source>
        <translation>Afficher les avertissements</translation>
    </message>
    <message>
        <source>Show notes</source>
        <translation>Afficher les remarques</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Filter of the problem list</source>
        <translation>Filtre de la liste des problèmes</translation>
    </message>
</context>
<context>
    <name>plc::app::ProjectSettingsDialog</name>
    <message>
        <source>Project Settings</source>
        <translation>Paramètres du projet</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Bytes: %MW1 is bytes 1 and 2 (TwinCAT)</source>
        <translation>Octets&#xa0;: %MW1 désigne les octets 1 et 2 (TwinCAT)</translation>
    </message>
    <message>
        <source>Words: %MW1 is the second word (CODESYS)</source>
        <translation>Mots&#xa0;: %MW1 désigne le deuxième mot (CODESYS)</translation>
    </message>
    <message>
        <source> bytes</source>
        <translation> octets</translation>
    </message>
    <message>
        <source>None (no __NEW)</source>
        <translation>Aucune (pas de __NEW)</translation>
    </message>
    <message>
        <source>What the number of a memory address counts</source>
        <translation>Ce que compte le numéro d&apos;une adresse mémoire</translation>
    </message>
    <message>
        <source>What the bytes of STRING values stand for</source>
        <translation>Ce que représentent les octets des valeurs STRING</translation>
    </message>
    <message>
        <source>What {IF defined (…)} in the sources finds, separated by commas</source>
        <translation>Ce que {IF defined (…)} trouve dans les sources, séparé par des virgules</translation>
    </message>
    <message>
        <source>The part of the controller&apos;s memory that __NEW takes objects from</source>
        <translation>La partie de la mémoire de l&apos;automate où __NEW prend ses objets</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Addressing</source>
        <translation>Adressage</translation>
    </message>
    <message>
        <source>Encoding of STRING</source>
        <translation>Encodage de STRING</translation>
    </message>
    <message>
        <source>Defined symbols</source>
        <translation>Symboles définis</translation>
    </message>
    <message>
        <source>Memory for __NEW</source>
        <translation>Mémoire pour __NEW</translation>
    </message>
    <message>
        <source>Date and time of the first scan</source>
        <translation>Date et heure du premier cycle</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Vues</translation>
    </message>
    <message>
        <source>The first panel</source>
        <translation>La première vue</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Allow pictures outside the project folder</source>
        <translation>Autoriser les images hors du dossier du projet</translation>
    </message>
    <message>
        <source>The panel that is drawn around all others</source>
        <translation>La vue dessinée autour de toutes les autres</translation>
    </message>
    <message>
        <source>A variable with the operator&apos;s language; panels read and write it</source>
        <translation>Une variable contenant la langue de l&apos;opérateur&#x202f;; les vues la lisent et l&apos;écrivent</translation>
    </message>
    <message>
        <source>Start panel</source>
        <translation>Vue de départ</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Cadre</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Police</translation>
    </message>
    <message>
        <source>Language variable</source>
        <translation>Variable de langue</translation>
    </message>
    <message>
        <source>A project needs a name.</source>
        <translation>Un projet doit avoir un nom.</translation>
    </message>
    <message>
        <source>“%1” is not a date and time; write for example DT#2026-01-31-06:00:00.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas une date avec heure&#x202f;; écrivez par exemple DT#2026-01-31-06:00:00.</translation>
    </message>
</context>
<context>
    <name>plc::app::ProjectTree</name>
    <message>
        <source>Source of %1 with the Values of %2</source>
        <translation>Source de %1 avec les valeurs de %2</translation>
    </message>
    <message>
        <source>Values of Instance</source>
        <translation>Valeurs de l’instance</translation>
    </message>
    <message>
        <source>More: choose in the watch</source>
        <translation>Autres&#xa0;: choisir dans la fenêtre de surveillance</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projet</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Filter of the project tree</source>
        <translation>Filtre de l’arborescence du projet</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Grafcet</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programmes</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blocs</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>Fonctions</translation>
    </message>
    <message>
        <source>Types</source>
        <translation>Types</translation>
    </message>
    <message>
        <source>Globals</source>
        <translation>Variables globales</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tâches</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Vues</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Textes</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
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
        <translation>Bibliothèques</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Nouveau…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Supprimer…</translation>
    </message>
    <message>
        <source>Libraries…</source>
        <translation>Bibliothèques…</translation>
    </message>
    <message>
        <source>Run Tests</source>
        <translation>Exécuter les tests</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Ajouter à la surveillance</translation>
    </message>
    <message>
        <source>Arrange by file</source>
        <translation>Classer par fichier</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recettes</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>Utilisateurs et droits</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Appareils</translation>
    </message>
    <message>
        <source>Panel Themes</source>
        <translation>Thèmes des vues</translation>
    </message>
</context>
<context>
    <name>plc::app::RenameDialog</name>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>New name of %1, in the whole project:</source>
        <translation>Nouveau nom de %1, dans tout le projet&#xa0;:</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Places that change</source>
        <translation>Endroits modifiés</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) change:</source>
        <translation>
            <numerusform>%n endroit change&#xa0;:</numerusform>
            <numerusform>%n endroits changent&#xa0;:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::app::RunsMenu</name>
    <message>
        <source>Earlier Runs</source>
        <translation>Exécutions précédentes</translation>
    </message>
    <message>
        <source>%1, ended by a fault, %2</source>
        <translation>%1, terminée par une erreur, %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The last run is being written…</source>
        <translation>Écriture de la dernière exécution…</translation>
    </message>
    <message>
        <source>No run has ended yet</source>
        <translation>Aucune exécution n’est encore terminée</translation>
    </message>
</context>
<context>
    <name>plc::app::SearchView</name>
    <message>
        <source>Find in all files</source>
        <translation>Rechercher dans tous les fichiers</translation>
    </message>
    <message>
        <source>Text to find in all files</source>
        <translation>Texte à rechercher dans tous les fichiers</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Remplacer par</translation>
    </message>
    <message>
        <source>Replacement in all files</source>
        <translation>Texte de remplacement dans tous les fichiers</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>Expression régulière</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Respecter la casse</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>Remplacer tout</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Utilisation</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Search results</source>
        <translation>Résultats de la recherche</translation>
    </message>
    <message>
        <source>Invalid regular expression: %1</source>
        <translation>Expression régulière incorrecte&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n endroit</numerusform>
            <numerusform>%n endroits</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n fichier</numerusform>
            <numerusform>%n fichiers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced</source>
        <translation>
            <numerusform>%n endroit remplacé</numerusform>
            <numerusform>%n endroits remplacés</numerusform>
        </translation>
    </message>
    <message>
        <source>declared</source>
        <translation>déclaré</translation>
    </message>
    <message>
        <source>read, write</source>
        <translation>lecture, écriture</translation>
    </message>
    <message>
        <source>write</source>
        <translation>écriture</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>%1: %2 read, %3 written</source>
        <translation>%1&#xa0;: %2 lectures, %3 écritures</translation>
    </message>
    <message>
        <source>Searching all files…</source>
        <translation>Recherche dans tous les fichiers…</translation>
    </message>
    <message>
        <source>Cancelled; so far: %1 in %2</source>
        <translation>Annulé&#x202f;; jusqu’ici&#xa0;: %1 dans %2</translation>
    </message>
    <message>
        <source>Replacing in all files…</source>
        <translation>Remplacement dans tous les fichiers…</translation>
    </message>
    <message>
        <source>Cancelled; nothing was replaced</source>
        <translation>Annulé&#x202f;; rien n’a été remplacé</translation>
    </message>
</context>
<context>
    <name>plc::app::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Editor</source>
        <translation>Éditeur</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Exécution</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Language of the studio</source>
        <translation>Langue du studio</translation>
    </message>
    <message>
        <source>Indentation</source>
        <translation>Retrait</translation>
    </message>
    <message>
        <source>Write keywords in capitals while typing</source>
        <translation>Mettre les mots-clés en majuscules pendant la saisie</translation>
    </message>
    <message>
        <source>Close blocks with Enter (IF … END_IF)</source>
        <translation>Fermer les blocs avec Entrée (IF … END_IF)</translation>
    </message>
    <message>
        <source>Show online values in the text</source>
        <translation>Afficher les valeurs en ligne dans le texte</translation>
    </message>
    <message>
        <source>Format when saving</source>
        <translation>Mettre en forme à l’enregistrement</translation>
    </message>
    <message>
        <source>Apply an online change when saving</source>
        <translation>Appliquer une modification en ligne à l’enregistrement</translation>
    </message>
    <message>
        <source>Memory for the recording of every scan</source>
        <translation>Mémoire pour l’enregistrement de chaque cycle</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>Another action has the same shortcut</source>
        <translation>Une autre commande a le même raccourci</translation>
    </message>
    <message>
        <source>Shortcut of %1</source>
        <translation>Raccourci de %1</translation>
    </message>
    <message>
        <source>Filter of the actions</source>
        <translation>Filtre des commandes</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Valeurs par défaut</translation>
    </message>
    <message>
        <source>%1 is now assigned to “%2” instead of “%3”.</source>
        <translation>%1 est maintenant attribué à «&#xa0;%2&#xa0;» au lieu de «&#xa0;%3&#xa0;».</translation>
    </message>
    <message>
        <source>none is kept</source>
        <translation>aucun n’est conservé</translation>
    </message>
    <message>
        <source>Disk space for the recordings of earlier runs, per project</source>
        <translation>Espace disque pour les enregistrements des exécutions précédentes, par projet</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> Mo</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contraste élevé</translation>
    </message>
</context>
<context>
    <name>plc::app::SideBars</name>
    <message>
        <source>Hide Automatically</source>
        <translation>Masquer automatiquement</translation>
    </message>
    <message>
        <source>Keep Open</source>
        <translation>Garder ouvert</translation>
    </message>
    <message>
        <source>Hidden Docks</source>
        <translation>Volets masqués</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Détacher</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>plc::app::StPage</name>
    <message>
        <source>This file is read-only on disk. Saving asks before it replaces it.</source>
        <translation>Ce fichier est en lecture seule sur le disque. L’enregistrement demande confirmation avant de le remplacer.</translation>
    </message>
    <message>
        <source>Make Writable</source>
        <translation>Lever la protection en écriture</translation>
    </message>
    <message>
        <source>Close this side</source>
        <translation>Fermer ce côté</translation>
    </message>
</context>
<context>
    <name>plc::app::StartPage</name>
    <message>
        <source>Write, run and watch PLC programs. Every scan is recorded; time runs backwards, too.</source>
        <translation>Écrivez, exécutez et surveillez des programmes d’automate. Chaque cycle est enregistré&#x202f;; le temps s’écoule aussi à rebours.</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Projets récents</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>Nouveau projet…</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>Ouvrir un projet…</translation>
    </message>
    <message>
        <source>Take the Tour</source>
        <translation>Suivre la visite guidée</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Récents</translation>
    </message>
    <message>
        <source>Examples: open one and press Run</source>
        <translation>Exemples&#xa0;: ouvrez-en un et lancez l’exécution</translation>
    </message>
    <message>
        <source>No examples were found in:
%1

Install the examples, or set the environment variable STEPWISE_EXAMPLES to the folder that contains them, and start Stepwise again.</source>
        <translation>Aucun exemple trouvé dans&#xa0;:
%1

Installez les exemples ou donnez à la variable d’environnement STEPWISE_EXAMPLES le dossier qui les contient, puis redémarrez Stepwise.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open a Fresh Copy</source>
        <translation>Ouvrir une nouvelle copie</translation>
    </message>
</context>
<context>
    <name>plc::app::TestView</name>
    <message>
        <source>Run all tests</source>
        <translation>Exécuter tous les tests</translation>
    </message>
    <message>
        <source>Run the selected tests</source>
        <translation>Exécuter les tests sélectionnés</translation>
    </message>
    <message>
        <source>Run the failed tests</source>
        <translation>Exécuter les tests en échec</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Tests</translation>
    </message>
    <message>
        <source>%1 passed, %2 failed</source>
        <translation>Réussis&#xa0;: %1, en échec&#xa0;: %2</translation>
    </message>
    <message>
        <source>not run yet</source>
        <translation>pas encore exécuté</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>réussi</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>Show the Recording of the Failure</source>
        <translation>Afficher l’enregistrement de l’échec</translation>
    </message>
    <message>
        <source>Show what the tests cover</source>
        <translation>Afficher ce que les tests couvrent</translation>
    </message>
</context>
<context>
    <name>plc::app::TextPage</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Ligne %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>plc::app::Tour</name>
    <message>
        <source>Back</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Terminer la visite</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visite guidée</translation>
    </message>
</context>
<context>
    <name>plc::app::UnitCommands</name>
    <message>
        <source>The program is running. To an online change the new name is another variable: it begins with its initial value.</source>
        <translation>Le programme est en cours d’exécution. Pour une modification en ligne, le nouveau nom désigne une autre variable&#x202f;: elle commence par sa valeur initiale.</translation>
    </message>
    <message>
        <source>Go to Line</source>
        <translation>Aller à la ligne</translation>
    </message>
    <message>
        <source>Line (1 to %1)</source>
        <translation>Ligne (1 à %1)</translation>
    </message>
    <message>
        <source>Nothing is declared under this name; declare it or check the name</source>
        <translation>Rien n’est déclaré sous ce nom&#x202f;; déclarez-le ou vérifiez-le</translation>
    </message>
    <message>
        <source>Put the cursor into a unit that is written in ST or IL</source>
        <translation>Placez le curseur dans un POU écrit en ST ou en IL</translation>
    </message>
    <message>
        <source>The text has changed meanwhile</source>
        <translation>Le texte a changé entre-temps</translation>
    </message>
    <message>
        <source>There is no name at the cursor; put the cursor on one</source>
        <translation>Il n’y a pas de nom sous le curseur&#x202f;; placez le curseur sur un nom</translation>
    </message>
    <message>
        <source>The project is still being checked; try again in a moment</source>
        <translation>Le projet est encore en cours de vérification&#x202f;; réessayez dans un instant</translation>
    </message>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s); the panels are saved, the sources not yet</source>
        <translation>
            <numerusform>%1 s’appelle maintenant %2, à %n endroit&#x202f;; les vues sont enregistrées, les sources pas encore</numerusform>
            <numerusform>%1 s’appelle maintenant %2, à %n endroits&#x202f;; les vues sont enregistrées, les sources pas encore</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s)</source>
        <translation>
            <numerusform>%1 s’appelle maintenant %2, à %n endroit</numerusform>
            <numerusform>%1 s’appelle maintenant %2, à %n endroits</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>Supprimer %1&#x202f;?</translation>
    </message>
    <message numerus="yes">
        <source>It is used in %n other place(s).</source>
        <translation>
            <numerusform>Utilisé à %n autre endroit.</numerusform>
            <numerusform>Utilisé à %n autres endroits.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete and Comment Out the Uses</source>
        <translation>Supprimer et commenter les utilisations</translation>
    </message>
    <message>
        <source>Show the Uses</source>
        <translation>Afficher les utilisations</translation>
    </message>
    <message>
        <source>%1 is not a source of this project; open the project that contains it</source>
        <translation>%1 n’est pas un fichier source de ce projet&#x202f;; ouvrez le projet qui le contient</translation>
    </message>
</context>
<context>
    <name>plc::app::WhatIfDialog</name>
    <message>
        <source>What If?</source>
        <translation>Et si&#x202f;?</translation>
    </message>
    <message>
        <source>The controller goes back to the scan shown and continues from there with these values. The trace draws what really happened behind the new curves.</source>
        <translation>L’automate revient au cycle affiché et repart de là avec ces valeurs. La trace dessine à l’arrière-plan ce qui s’est réellement passé.</translation>
    </message>
    <message>
        <source>A variable, such as Main.level</source>
        <translation>Une variable, par exemple Main.level</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>Était</translation>
    </message>
    <message>
        <source>Instead</source>
        <translation>À la place</translation>
    </message>
    <message>
        <source>Values to change</source>
        <translation>Valeurs à modifier</translation>
    </message>
    <message>
        <source>Run from Here</source>
        <translation>Exécuter à partir d’ici</translation>
    </message>
    <message>
        <source>%1 has no value in this scan; choose another variable</source>
        <translation>%1 n’a pas de valeur dans ce cycle&#x202f;; choisissez une autre variable</translation>
    </message>
    <message>
        <source>Enter a different value for at least one variable</source>
        <translation>Donnez une autre valeur à au moins une variable</translation>
    </message>
</context>
<context>
    <name>plc::editor::BreakpointView</name>
    <message>
        <source>Place</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Hit count</source>
        <translation>Nombre de passages</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>Instance</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>Points d’arrêt</translation>
    </message>
    <message>
        <source>Remove selected</source>
        <translation>Supprimer la sélection</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Tout supprimer</translation>
    </message>
    <message>
        <source>The running program has no code at or below this line; choose a line with a statement</source>
        <translation>Le programme en cours n’a pas de code à cette ligne ni plus bas&#x202f;; choisissez une ligne avec une instruction</translation>
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
        <translation>Instance</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Call stack</source>
        <translation>Pile d’appels</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Values of the frame</source>
        <translation>Valeurs du niveau d’appel</translation>
    </message>
    <message>
        <source>This scan has run to its end: it has no call stack.</source>
        <translation>Ce cycle est terminé&#xa0;: il n’a pas de pile d’appels.</translation>
    </message>
</context>
<context>
    <name>plc::editor::ChartView</name>
    <message>
        <source>Sequential function chart</source>
        <translation>Grafcet (SFC)</translation>
    </message>
    <message>
        <source>Insert a step after it (Ins)</source>
        <translation>Insérer une étape après (Inser)</translation>
    </message>
    <message>
        <source>Insert an alternative branch</source>
        <translation>Insérer une branche alternative</translation>
    </message>
    <message>
        <source>Insert a simultaneous branch</source>
        <translation>Insérer une divergence simultanée</translation>
    </message>
    <message>
        <source>Add an action</source>
        <translation>Ajouter une action</translation>
    </message>
    <message>
        <source>Edit name or condition (F2)</source>
        <translation>Modifier le nom ou la condition (F2)</translation>
    </message>
    <message>
        <source>Delete (Del)</source>
        <translation>Supprimer (Suppr)</translation>
    </message>
    <message>
        <source>The unit %1 is no longer in the text; undo the change or close this view</source>
        <translation>Le POU %1 n’est plus dans le texte&#x202f;; annulez la modification ou fermez cette vue</translation>
    </message>
    <message>
        <source>The text has errors: this is the last valid drawing</source>
        <translation>Le texte contient des erreurs&#xa0;: ceci est le dernier tracé correct</translation>
    </message>
    <message>
        <source>Select the step from which the branch goes out</source>
        <translation>Sélectionnez l’étape d’où part la branche</translation>
    </message>
    <message>
        <source>Select the transition after which the steps run at the same time</source>
        <translation>Sélectionnez la transition après laquelle les étapes sont simultanées</translation>
    </message>
    <message>
        <source>Select the step that gets the action</source>
        <translation>Sélectionnez l’étape qui reçoit l’action</translation>
    </message>
    <message>
        <source>Insert a Step After It</source>
        <translation>Insérer une étape après</translation>
    </message>
    <message>
        <source>Insert an Alternative Branch</source>
        <translation>Insérer une branche alternative</translation>
    </message>
    <message>
        <source>Insert a Simultaneous Branch</source>
        <translation>Insérer une divergence simultanée</translation>
    </message>
    <message>
        <source>Add an Action</source>
        <translation>Ajouter une action</translation>
    </message>
    <message>
        <source>Set as Initial Step</source>
        <translation>Définir comme étape initiale</translation>
    </message>
    <message>
        <source>Force the Step Active</source>
        <translation>Forcer l’étape active</translation>
    </message>
    <message>
        <source>Release the Step</source>
        <translation>Lever le forçage de l’étape</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Basculer le point d’arrêt</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Modifier</translation>
    </message>
    <message>
        <source>Move Left</source>
        <translation>Déplacer à gauche</translation>
    </message>
    <message>
        <source>Move Right</source>
        <translation>Déplacer à droite</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Branch to the left</source>
        <translation>Branche à gauche</translation>
    </message>
    <message>
        <source>Branch to the right</source>
        <translation>Branche à droite</translation>
    </message>
    <message>
        <source>%1 after this transition</source>
        <translation>%1 après cette transition</translation>
    </message>
    <message>
        <source>leads to %1</source>
        <translation>mène à %1</translation>
    </message>
    <message>
        <source>further up</source>
        <translation>plus haut</translation>
    </message>
    <message>
        <source>further down</source>
        <translation>plus bas</translation>
    </message>
    <message>
        <source>%1 in step %2</source>
        <translation>%1 dans l’étape %2</translation>
    </message>
    <message>
        <source>A condition is a BOOL; add a comparison</source>
        <translation>Une condition est un BOOL&#x202f;; ajoutez une comparaison</translation>
    </message>
    <message>
        <source>qualifier</source>
        <translation>qualificatif</translation>
    </message>
    <message>
        <source>action</source>
        <translation>action</translation>
    </message>
    <message>
        <source>To the enclosing chart (Backspace)</source>
        <translation>Vers le grafcet supérieur (Retour arrière)</translation>
    </message>
    <message>
        <source>Breakpoint: stops when the step becomes active or the transition is taken (F9)</source>
        <translation>Point d’arrêt&#xa0;: arrêt quand l’étape devient active ou quand la transition est franchie (F9)</translation>
    </message>
    <message>
        <source>Force the step active</source>
        <translation>Forcer l’étape active</translation>
    </message>
    <message>
        <source>Release the step</source>
        <translation>Lever le forçage de l’étape</translation>
    </message>
    <message>
        <source>%1 is a variable: it has no body</source>
        <translation>%1 est une variable&#xa0;: elle n’a pas de corps</translation>
    </message>
    <message>
        <source>Select a step or a transition</source>
        <translation>Sélectionnez une étape ou une transition</translation>
    </message>
    <message>
        <source>Select a step</source>
        <translation>Sélectionnez une étape</translation>
    </message>
    <message>
        <source>Open Its Chart or Text</source>
        <translation>Ouvrir son grafcet ou son texte</translation>
    </message>
    <message>
        <source>Priority…</source>
        <translation>Priorité…</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Déplacer vers le haut</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Déplacer vers le bas</translation>
    </message>
    <message>
        <source>Delete the Whole Branch</source>
        <translation>Supprimer toute la branche</translation>
    </message>
    <message>
        <source>Select what is to be copied</source>
        <translation>Sélectionnez ce qui doit être copié</translation>
    </message>
    <message>
        <source>Select what is to be cut</source>
        <translation>Sélectionnez ce qui doit être coupé</translation>
    </message>
    <message>
        <source>The clipboard contains no step, action or transition; copy one first</source>
        <translation>Le presse-papiers ne contient ni étape, ni action, ni transition&#x202f;; copiez-en d’abord une</translation>
    </message>
    <message>
        <source>Select the step or transition to paste after</source>
        <translation>Sélectionnez l’étape ou la transition après laquelle coller</translation>
    </message>
    <message>
        <source>Select the transition that gets the condition</source>
        <translation>Sélectionnez la transition qui reçoit la condition</translation>
    </message>
    <message>
        <source>Start a Chart</source>
        <translation>Commencer un grafcet</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>%1 has no chart yet. A chart starts with an initial step; more steps are inserted after it with Ins, and F2 edits names and conditions.</source>
        <translation>%1 n’a pas encore de grafcet. Un grafcet commence par une étape initiale&#x202f;; Inser ajoute d’autres étapes après elle, F2 modifie les noms et les conditions.</translation>
    </message>
    <message>
        <source>%1 is not a chart: its body has statements. A chart can be started in a program or function block whose body is empty.</source>
        <translation>%1 n’est pas un grafcet&#xa0;: son corps contient des instructions. Un grafcet peut être commencé dans un programme ou un bloc fonctionnel dont le corps est vide.</translation>
    </message>
</context>
<context>
    <name>plc::editor::DeclarationTable</name>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
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
        <translation>Valeur initiale</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Declarations</source>
        <translation>Déclarations</translation>
    </message>
    <message>
        <source>Add a variable</source>
        <translation>Ajouter une variable</translation>
    </message>
    <message>
        <source>Remove the selected variables</source>
        <translation>Supprimer les variables sélectionnées</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Déplacer vers le haut</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Déplacer vers le bas</translation>
    </message>
</context>
<context>
    <name>plc::editor::EventLog</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>PLC time</source>
        <translation>Temps API</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Cycle</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all rows</source>
        <translation>Copier les lignes sélectionnées, sinon toutes</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Only faults and rejections</source>
        <translation>Erreurs et refus seulement</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Filter of the events</source>
        <translation>Filtre des événements</translation>
    </message>
    <message>
        <source>Step: %1</source>
        <translation>Étape&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>event at file:line</comment>
        <translation>%1 à %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::FindBar</name>
    <message>
        <source>Find</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Text to find</source>
        <translation>Texte à rechercher</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Remplacer par</translation>
    </message>
    <message>
        <source>Replacement</source>
        <translation>Texte de remplacement</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Respecter la casse</translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>Mots entiers</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>Expression régulière</translation>
    </message>
    <message>
        <source>Previous (Shift+Enter)</source>
        <translation>Précédent (Maj+Entrée)</translation>
    </message>
    <message>
        <source>Next (Enter)</source>
        <translation>Suivant (Entrée)</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Fermer (Échap)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>Remplacer tout</translation>
    </message>
    <message numerus="yes">
        <source>%n replaced</source>
        <translation>
            <numerusform>%n remplacé</numerusform>
            <numerusform>%n remplacés</numerusform>
        </translation>
    </message>
    <message>
        <source>invalid regular expression</source>
        <translation>expression régulière incorrecte</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n trouvé</numerusform>
            <numerusform>%n trouvés</numerusform>
        </translation>
    </message>
    <message>
        <source>not found</source>
        <translation>introuvable</translation>
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
        <translation>Valeur forcée</translation>
    </message>
    <message>
        <source>Forced variables</source>
        <translation>Variables forcées</translation>
    </message>
    <message>
        <source>Release selected</source>
        <translation>Lever le forçage de la sélection</translation>
    </message>
    <message>
        <source>Release all</source>
        <translation>Lever tous les forçages</translation>
    </message>
</context>
<context>
    <name>plc::editor::GraphView</name>
    <message>
        <source>Show all</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>Export as SVG, PNG or PDF…</source>
        <translation>Exporter en SVG, PNG ou PDF…</translation>
    </message>
    <message>
        <source>Export the Drawing</source>
        <translation>Exporter le tracé</translation>
    </message>
    <message>
        <source>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</source>
        <translation>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be written; choose a variable of the program</source>
        <translation>%1 ne peut pas être écrit&#x202f;; choisissez une variable du programme</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Imprimer…</translation>
    </message>
    <message>
        <source>Fix the text first: this is the last valid drawing</source>
        <translation>Corrigez d’abord le texte&#xa0;: ceci est le dernier tracé correct</translation>
    </message>
</context>
<context>
    <name>plc::editor::LadderView</name>
    <message>
        <source>Ladder or function block diagram</source>
        <translation>Schéma à contacts ou diagramme de blocs fonctionnels</translation>
    </message>
    <message>
        <source>Insert a rung below (Ctrl+T)</source>
        <translation>Insérer un réseau en dessous (Ctrl+T)</translation>
    </message>
    <message>
        <source>Insert a contact on the left (Ctrl+K)</source>
        <translation>Insérer un contact à gauche (Ctrl+K)</translation>
    </message>
    <message>
        <source>Insert a contact on the right (Ctrl+D)</source>
        <translation>Insérer un contact à droite (Ctrl+D)</translation>
    </message>
    <message>
        <source>Insert a parallel contact (Ctrl+R)</source>
        <translation>Insérer un contact en parallèle (Ctrl+R)</translation>
    </message>
    <message>
        <source>Insert a coil (Ctrl+A)</source>
        <translation>Insérer une bobine (Ctrl+A)</translation>
    </message>
    <message>
        <source>Insert a function block (Ctrl+B)</source>
        <translation>Insérer un bloc fonctionnel (Ctrl+B)</translation>
    </message>
    <message>
        <source>Edit (F2)</source>
        <translation>Modifier (F2)</translation>
    </message>
    <message>
        <source>Delete (Del)</source>
        <translation>Supprimer (Suppr)</translation>
    </message>
    <message>
        <source>Breakpoint on the rung (F9)</source>
        <translation>Point d’arrêt sur le réseau (F9)</translation>
    </message>
    <message>
        <source>Show as a function block diagram</source>
        <translation>Afficher en diagramme de blocs fonctionnels</translation>
    </message>
    <message>
        <source>Show as a ladder diagram</source>
        <translation>Afficher en schéma à contacts</translation>
    </message>
    <message>
        <source>%1 is no longer in the text; undo the change or close this view</source>
        <translation>%1 n’est plus dans le texte&#x202f;; annulez la modification ou fermez cette vue</translation>
    </message>
    <message>
        <source>The text has errors: this is the last valid drawing</source>
        <translation>Le texte contient des erreurs&#xa0;: ceci est le dernier tracé correct</translation>
    </message>
    <message>
        <source>Fix the text first: this is the last valid drawing</source>
        <translation>Corrigez d’abord le texte&#xa0;: ceci est le dernier tracé correct</translation>
    </message>
    <message>
        <source>Select a rung</source>
        <translation>Sélectionnez un réseau</translation>
    </message>
    <message>
        <source>Select a coil</source>
        <translation>Sélectionnez une bobine</translation>
    </message>
    <message>
        <source>Select a contact, a coil or a pin with a variable</source>
        <translation>Sélectionnez un contact, une bobine ou une broche avec une variable</translation>
    </message>
    <message>
        <source>The rung has no contact yet</source>
        <translation>Le réseau n’a pas encore de contact</translation>
    </message>
    <message>
        <source>Select the rung that gets the block</source>
        <translation>Sélectionnez le réseau qui reçoit le bloc</translation>
    </message>
    <message>
        <source>block</source>
        <translation>bloc</translation>
    </message>
    <message>
        <source>Contact on the left; at a coil, the last contact</source>
        <translation>Contact à gauche&#x202f;; sur une bobine, le dernier contact</translation>
    </message>
    <message>
        <source>Contact on the right</source>
        <translation>Contact à droite</translation>
    </message>
    <message>
        <source>Parallel contact</source>
        <translation>Contact en parallèle</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>Bobine</translation>
    </message>
    <message>
        <source>Function block in the rung</source>
        <translation>Bloc fonctionnel dans le réseau</translation>
    </message>
    <message>
        <source>Rung above</source>
        <translation>Réseau au-dessus</translation>
    </message>
    <message>
        <source>Rung below</source>
        <translation>Réseau en dessous</translation>
    </message>
    <message>
        <source>Negate a contact, a coil or a pin</source>
        <translation>Inverser un contact, une bobine ou une broche</translation>
    </message>
    <message>
        <source>Coil: normal, set, reset</source>
        <translation>Bobine&#xa0;: normale, mise à 1, mise à 0</translation>
    </message>
    <message>
        <source>Comment of the rung</source>
        <translation>Commentaire du réseau</translation>
    </message>
    <message>
        <source>Edit what is selected (or Enter)</source>
        <translation>Modifier la sélection (ou Entrée)</translation>
    </message>
    <message>
        <source>Delete what is selected</source>
        <translation>Supprimer la sélection</translation>
    </message>
    <message>
        <source>Breakpoint on the rung</source>
        <translation>Point d’arrêt sur le réseau</translation>
    </message>
    <message>
        <source>This list</source>
        <translation>Cette liste</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Flèches</translation>
    </message>
    <message>
        <source>Select the next part; Up and Down also the next rung</source>
        <translation>Sélectionner l’élément suivant&#x202f;; Haut et Bas aussi le réseau suivant</translation>
    </message>
    <message>
        <source>Move the rung up; with Down, down</source>
        <translation>Déplacer le réseau vers le haut&#x202f;; avec Bas, vers le bas</translation>
    </message>
    <message>
        <source>Typed before a name: a negated contact</source>
        <translation>Tapé avant un nom&#xa0;: un contact inversé</translation>
    </message>
    <message>
        <source>Keys in Ladder and Function Block Diagrams</source>
        <translation>Touches des schémas à contacts et diagrammes de blocs fonctionnels</translation>
    </message>
    <message>
        <source>Insert a Rung Above</source>
        <translation>Insérer un réseau au-dessus</translation>
    </message>
    <message>
        <source>Insert a Rung Below</source>
        <translation>Insérer un réseau en dessous</translation>
    </message>
    <message>
        <source>Insert a Contact</source>
        <translation>Insérer un contact</translation>
    </message>
    <message>
        <source>Insert a Parallel Contact</source>
        <translation>Insérer un contact en parallèle</translation>
    </message>
    <message>
        <source>Insert a Coil</source>
        <translation>Insérer une bobine</translation>
    </message>
    <message>
        <source>Insert a Function Block…</source>
        <translation>Insérer un bloc fonctionnel…</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Modifier</translation>
    </message>
    <message>
        <source>Comment…</source>
        <translation>Commentaire…</translation>
    </message>
    <message>
        <source>Negate</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Set or Reset</source>
        <translation>Mettre à 1 ou à 0</translation>
    </message>
    <message>
        <source>Move the Rung Up</source>
        <translation>Déplacer le réseau vers le haut</translation>
    </message>
    <message>
        <source>Move the Rung Down</source>
        <translation>Déplacer le réseau vers le bas</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Force TRUE</source>
        <translation>Forcer à TRUE</translation>
    </message>
    <message>
        <source>Force FALSE</source>
        <translation>Forcer à FALSE</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Lever le forçage</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Basculer le point d’arrêt</translation>
    </message>
    <message>
        <source>Contacts as Bars (IEC 61131-3, ANSI)</source>
        <translation>Contacts en barres (CEI 61131-3, ANSI)</translation>
    </message>
    <message>
        <source>Contacts as in Circuit Diagrams (IEC 60617)</source>
        <translation>Contacts comme dans les schémas électriques (CEI 60617)</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Noms</translation>
    </message>
    <message>
        <source>Addresses</source>
        <translation>Adresses</translation>
    </message>
    <message>
        <source>Names and Addresses</source>
        <translation>Noms et adresses</translation>
    </message>
    <message>
        <source>Comments of the Variables</source>
        <translation>Commentaires des variables</translation>
    </message>
    <message>
        <source>Comments of the Rungs</source>
        <translation>Commentaires des réseaux</translation>
    </message>
    <message>
        <source>High Contrast</source>
        <translation>Contraste élevé</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Ce qui est affiché</translation>
    </message>
    <message>
        <source>type</source>
        <translation>type</translation>
    </message>
    <message>
        <source>Rename the variable everywhere</source>
        <translation>Renommer la variable partout</translation>
    </message>
    <message>
        <source>Go to the definition</source>
        <translation>Aller à la définition</translation>
    </message>
    <message>
        <source>References to the variable</source>
        <translation>Références de la variable</translation>
    </message>
    <message>
        <source>Quick fix</source>
        <translation>Correction rapide</translation>
    </message>
    <message>
        <source>Bookmark on the rung</source>
        <translation>Signet sur le réseau</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Rechercher les références</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Aller à la définition</translation>
    </message>
    <message>
        <source>Quick Fix</source>
        <translation>Correction rapide</translation>
    </message>
    <message>
        <source>Write TRUE</source>
        <translation>Écrire TRUE</translation>
    </message>
    <message>
        <source>Write FALSE</source>
        <translation>Écrire FALSE</translation>
    </message>
    <message>
        <source>Toggle Bookmark</source>
        <translation>Basculer le signet</translation>
    </message>
    <message>
        <source>Contact Here</source>
        <translation>Contact ici</translation>
    </message>
    <message>
        <source>Negated Contact Here</source>
        <translation>Contact inversé ici</translation>
    </message>
    <message>
        <source>Function Block Here</source>
        <translation>Bloc fonctionnel ici</translation>
    </message>
    <message>
        <source>Move the contact left; with Right, right</source>
        <translation>Déplacer le contact vers la gauche&#x202f;; avec Droite, vers la droite</translation>
    </message>
    <message>
        <source>Select a contact; a rung moves up and down</source>
        <translation>Sélectionnez un contact&#x202f;; un réseau se déplace vers le haut et le bas</translation>
    </message>
</context>
<context>
    <name>plc::editor::RunArchive</name>
    <message>
        <source>The recording of the last run was not kept: %1</source>
        <translation>L’enregistrement de la dernière exécution n’a pas été conservé&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>plc::editor::RunControl</name>
    <message>
        <source>Built in %1 ms</source>
        <translation>Compilé en %1&#xa0;ms</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s): the program was not built</source>
        <translation>
            <numerusform>%n erreur&#xa0;: le programme n’a pas été compilé</numerusform>
            <numerusform>%n erreurs&#xa0;: le programme n’a pas été compilé</numerusform>
        </translation>
    </message>
    <message>
        <source>Online change: %1 kept, %2 new, %3 lost</source>
        <translation>Modification en ligne&#xa0;: %1 variables conservées, %2 nouvelles, %3 supprimées</translation>
    </message>
    <message>
        <source>The change waits for the end of the scan</source>
        <translation>La modification attend la fin du cycle</translation>
    </message>
    <message>
        <source>The program has errors; the controller continues with the old program</source>
        <translation>Le programme contient des erreurs&#x202f;; l’automate continue avec l’ancien</translation>
    </message>
    <message>
        <source>did not exist in this scan</source>
        <translation>n’existait pas dans ce cycle</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Compilation</translation>
    </message>
    <message>
        <source>Not optimised: the quick code keeps running</source>
        <translation>Non optimisé&#xa0;: le code compilé rapidement continue</translation>
    </message>
    <message>
        <source>Optimising</source>
        <translation>Optimisation</translation>
    </message>
    <message>
        <source>There is no code at or below line %1 of %2; choose an earlier line</source>
        <translation>Il n’y a pas de code à la ligne %1 de %2 ni plus bas&#x202f;; choisissez une ligne précédente</translation>
    </message>
    <message>
        <source>The condition of the breakpoint: %1</source>
        <translation>La condition du point d’arrêt&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>plc::editor::SlowScanView</name>
    <message>
        <source>Back to the previous breakpoint or to the first statement of the scan</source>
        <translation>Retour au point d’arrêt précédent, ou à la première instruction du cycle</translation>
    </message>
    <message>
        <source>Back out of the call</source>
        <translation>Revenir hors de l’appel</translation>
    </message>
    <message>
        <source>Back over calls</source>
        <translation>Revenir par-dessus les appels</translation>
    </message>
    <message>
        <source>One statement back</source>
        <translation>Une instruction en arrière</translation>
    </message>
    <message>
        <source>Step in</source>
        <translation>Pas à pas détaillé</translation>
    </message>
    <message>
        <source>Step over</source>
        <translation>Pas à pas principal</translation>
    </message>
    <message>
        <source>Step out</source>
        <translation>Pas à pas sortant</translation>
    </message>
    <message>
        <source>Forward to the next breakpoint or to the end of the scan</source>
        <translation>Aller au point d’arrêt suivant, ou à la fin du cycle</translation>
    </message>
    <message>
        <source>End the walk</source>
        <translation>Terminer le parcours</translation>
    </message>
    <message>
        <source>Current position of the walk</source>
        <translation>Position dans le parcours</translation>
    </message>
    <message>
        <source>Call</source>
        <translation>Appel</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>Instance</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Call path</source>
        <translation>Pile d’appels</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Values at this moment</source>
        <translation>Valeurs à cet instant</translation>
    </message>
    <message>
        <source>There is no recorded scan yet: run the program first.</source>
        <translation>Il n’y a pas encore de cycle enregistré&#xa0;: exécutez d’abord le programme.</translation>
    </message>
    <message>
        <source>Running the scan again…</source>
        <translation>Réexécution du cycle…</translation>
    </message>
    <message>
        <source>Walks through a recorded scan statement by statement, forwards and backwards (Time, Walk Through the Scan).</source>
        <translation>Parcourt un cycle enregistré instruction par instruction, en avant et en arrière (Temps, Parcourir le cycle).</translation>
    </message>
    <message>
        <source>The end of scan %1 at %2</source>
        <translation>Fin du cycle %1 à %2</translation>
    </message>
    <message>
        <source>Scan %1 at %2: before statement %3 of %4</source>
        <translation>Cycle %1 à %2&#xa0;: avant l’instruction %3 sur %4</translation>
    </message>
    <message>
        <source> · pass %1</source>
        <comment>of loops, outermost first</comment>
        <translation> · passage %1</translation>
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
        <translation>Éditeur de texte structuré</translation>
    </message>
    <message>
        <source>Declare %1</source>
        <translation>Déclarer %1</translation>
    </message>
    <message>
        <source>There is no fix for this line; press F1 for an explanation</source>
        <translation>Il n’y a pas de correction pour cette ligne&#x202f;; appuyez sur F1 pour une explication</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>Aller à la définition</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>Rechercher les références</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Add to Watch</source>
        <translation>Ajouter à la surveillance</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>Basculer le point d’arrêt</translation>
    </message>
    <message>
        <source>CR</source>
        <comment>current result of an instruction list</comment>
        <translation>RC</translation>
    </message>
    <message>
        <source>Declare %1 as an input</source>
        <translation>Déclarer %1 comme entrée</translation>
    </message>
    <message>
        <source>Declare %1 as an output</source>
        <translation>Déclarer %1 comme sortie</translation>
    </message>
    <message>
        <source>Declare %1 as a global variable</source>
        <translation>Déclarer %1 comme variable globale</translation>
    </message>
    <message>
        <source>Declare %1 in %2</source>
        <translation>Déclarer %1 dans %2</translation>
    </message>
    <message>
        <source>Write a Value…</source>
        <translation>Écrire une valeur…</translation>
    </message>
    <message>
        <source>Force…</source>
        <translation>Forcer…</translation>
    </message>
    <message>
        <source>Release the Force</source>
        <translation>Lever le forçage</translation>
    </message>
    <message>
        <source>pass</source>
        <comment>of a loop</comment>
        <translation>passage</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::TaskMonitor</name>
    <message>
        <source>Histogram of execution times</source>
        <translation>Histogramme des temps d’exécution</translation>
    </message>
    <message>
        <source>Execution times appear here while the controller runs</source>
        <translation>Les temps d’exécution s’affichent ici quand l’automate est en marche</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Exécutions</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Dernier</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Gigue</translation>
    </message>
    <message>
        <source>Overruns</source>
        <translation>Dépassements</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tâches</translation>
    </message>
    <message>
        <source>Reset the statistics</source>
        <translation>Réinitialiser les statistiques</translation>
    </message>
</context>
<context>
    <name>plc::editor::TuningView</name>
    <message>
        <source>Charts of the loop</source>
        <translation>Graphiques de la boucle</translation>
    </message>
    <message>
        <source>Recording and model</source>
        <translation>Enregistrement et modèle</translation>
    </message>
    <message>
        <source>Response to the set point</source>
        <translation>Réponse à la consigne</translation>
    </message>
    <message>
        <source>Response to a disturbance</source>
        <translation>Réponse à une perturbation</translation>
    </message>
    <message>
        <source>Simulation with the actual block</source>
        <translation>Simulation avec le bloc réel</translation>
    </message>
    <message>
        <source>Control loop</source>
        <translation>Boucle de régulation</translation>
    </message>
    <message>
        <source>Find Steps</source>
        <translation>Rechercher les échelons</translation>
    </message>
    <message>
        <source>Searches the recording for steps of the set point and of the output and fits a model of the process.</source>
        <translation>Recherche des échelons de la consigne et de la sortie dans l’enregistrement et en tire un modèle du procédé.</translation>
    </message>
    <message>
        <source>Write Parameters</source>
        <translation>Écrire les paramètres</translation>
    </message>
    <message>
        <source>Writes all parameters in one scan.</source>
        <translation>Écrit tous les paramètres en un seul cycle.</translation>
    </message>
    <message>
        <source>Take Back</source>
        <translation>Restaurer</translation>
    </message>
    <message>
        <source>Writes the parameters that were in force before.</source>
        <translation>Écrit les paramètres qui étaient en vigueur auparavant.</translation>
    </message>
    <message>
        <source>Loop:</source>
        <translation>Boucle&#xa0;:</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Utiliser</translation>
    </message>
    <message>
        <source>At</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Évaluation</translation>
    </message>
    <message>
        <source>Steps found</source>
        <translation>Échelons trouvés</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Règle</translation>
    </message>
    <message>
        <source>Kind of controller</source>
        <translation>Type de régulateur</translation>
    </message>
    <message>
        <source>Calm to brisk</source>
        <translation>Calme à vif</translation>
    </message>
    <message>
        <source>Disturbance to set point</source>
        <translation>Perturbation à consigne</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Actuel</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Proposé</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Avant et après</translation>
    </message>
    <message>
        <source>Model:</source>
        <translation>Modèle&#xa0;:</translation>
    </message>
    <message>
        <source>Rule:</source>
        <translation>Règle&#xa0;:</translation>
    </message>
    <message>
        <source>Controller:</source>
        <translation>Régulateur&#xa0;:</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>Calme</translation>
    </message>
    <message>
        <source>Brisk</source>
        <translation>Vif</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>Perturbation</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>The program has no controller block; call one, for example PID.</source>
        <translation>Le programme n’a pas de bloc régulateur&#x202f;; appelez-en un, par exemple PID.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Recherche…</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) found, %1 used.</source>
        <translation>
            <numerusform>%n échelon trouvé, %1 utilisé.</numerusform>
            <numerusform>%n échelons trouvés, %1 utilisés.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, explains %2 %</source>
        <translation>%1, explique %2&#xa0;%</translation>
    </message>
    <message>
        <source>set point</source>
        <translation>consigne</translation>
    </message>
    <message>
        <source>output</source>
        <translation>sortie</translation>
    </message>
    <message>
        <source>Choose at least one step.</source>
        <translation>Choisissez au moins un échelon.</translation>
    </message>
    <message>
        <source>The rule does not apply to this process; choose another rule.</source>
        <translation>La règle ne s’applique pas à ce procédé&#x202f;; choisissez une autre règle.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>tous</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>Integral time</source>
        <translation>Temps d’intégration</translation>
    </message>
    <message>
        <source>Derivative time</source>
        <translation>Temps de dérivation</translation>
    </message>
    <message>
        <source>Sensitivity Ms</source>
        <translation>Sensibilité Ms</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instable</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Marge de gain</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Marge de phase</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Dépassement</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Temps de stabilisation</translation>
    </message>
    <message>
        <source>Error after a load step</source>
        <translation>Erreur après un échelon de charge</translation>
    </message>
    <message>
        <source>Control effort</source>
        <translation>Effort de commande</translation>
    </message>
    <message>
        <source>Noise in the output</source>
        <translation>Bruit en sortie</translation>
    </message>
    <message>
        <source>Recorded and modelled</source>
        <translation>Enregistré et modélisé</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>temps [s]</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>enregistré</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modèle</translation>
    </message>
    <message>
        <source>now</source>
        <translation>actuel</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>proposé</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Taken back: %1</source>
        <translation>Restauré&#xa0;: %1</translation>
    </message>
    <message>
        <source>Residuals of the model</source>
        <translation>Résidus du modèle</translation>
    </message>
    <message>
        <source>recorded minus model</source>
        <translation>enregistré moins modèle</translation>
    </message>
    <message>
        <source>loop now</source>
        <translation>boucle actuelle</translation>
    </message>
    <message>
        <source>loop as proposed</source>
        <translation>boucle proposée</translation>
    </message>
    <message>
        <source>Bode plot</source>
        <translation>Diagramme de Bode</translation>
    </message>
    <message>
        <source>Bode Plot</source>
        <translation>Diagramme de Bode</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>fréquence [rad/s]</translation>
    </message>
    <message>
        <source>process</source>
        <translation>procédé</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>marge de gain</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>marge de phase</translation>
    </message>
    <message>
        <source>Constants in the call: %1. Write Parameters changes them in the text and in the running controller by an online change.</source>
        <translation>Constantes dans l’appel&#xa0;: %1. «&#xa0;Écrire les paramètres&#xa0;» les change dans le texte et, par une modification en ligne, dans l’automate en marche.</translation>
    </message>
    <message>
        <source>Computed in the call and not written: %1.</source>
        <translation>Calculé dans l’appel et non écrit&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The recorded disturbance with these settings</source>
        <translation>La perturbation enregistrée avec ces paramètres</translation>
    </message>
    <message>
        <source>The recorded step with these settings</source>
        <translation>L’échelon enregistré avec ces paramètres</translation>
    </message>
    <message>
        <source>The text was changed since the controller was started: change the constants after the next start or online change.</source>
        <translation>Le texte a été modifié depuis le démarrage de l’automate&#xa0;: changez les constantes après le prochain démarrage ou la prochaine modification en ligne.</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Réponses</translation>
    </message>
    <message>
        <source>Start the controller or open a recording to search it for steps.</source>
        <translation>Démarrez l’automate ou ouvrez un enregistrement&#x202f;; des échelons y sont recherchés.</translation>
    </message>
    <message>
        <source>disturbance</source>
        <translation>perturbation</translation>
    </message>
    <message>
        <source>gain [dB]</source>
        <translation>gain [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>phase [°]</translation>
    </message>
    <message>
        <source>Health in figures</source>
        <translation>État en chiffres</translation>
    </message>
    <message>
        <source>The whole recording</source>
        <translation>L’enregistrement entier</translation>
    </message>
    <message>
        <source>Save Report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Web pages (*.html);;PDF (*.pdf)</source>
        <translation>Pages web (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Report written: %1</source>
        <translation>Rapport écrit&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Saves a report on the loop with model and settings as HTML or PDF.</source>
        <translation>Enregistre un rapport sur la boucle avec modèle et paramètres en HTML ou PDF.</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>État</translation>
    </message>
</context>
<context>
    <name>plc::editor::WatchView</name>
    <message>
        <source>A list %1 already exists; choose another name</source>
        <translation>Une liste %1 existe déjà&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Expression</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Prepared</source>
        <translation>Préparée</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>Liste de surveillance</translation>
    </message>
    <message>
        <source>Add an expression: Main.x, a[i] * 2, fb.Q AND NOT done</source>
        <translation>Ajouter une expression&#xa0;: Main.x, a[i] * 2, fb.Q AND NOT done</translation>
    </message>
    <message>
        <source>New watch expression</source>
        <translation>Nouvelle expression de surveillance</translation>
    </message>
    <message>
        <source>Write prepared values</source>
        <translation>Écrire les valeurs préparées</translation>
    </message>
    <message>
        <source>Force prepared values</source>
        <translation>Forcer les valeurs préparées</translation>
    </message>
    <message>
        <source>Release the selected forces</source>
        <translation>Lever les forçages sélectionnés</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>Décimal</translation>
    </message>
    <message>
        <source>Hexadecimal</source>
        <translation>Hexadécimal</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>Binaire</translation>
    </message>
    <message>
        <source>Number format</source>
        <translation>Format des nombres</translation>
    </message>
    <message>
        <source>Toggle</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Force to %1</source>
        <translation>Forcer à %1</translation>
    </message>
    <message>
        <source>Release Force</source>
        <translation>Lever le forçage</translation>
    </message>
    <message>
        <source>Show in Trace</source>
        <translation>Afficher dans la trace</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>Tout supprimer</translation>
    </message>
    <message>
        <source>Time</source>
        <comment>number format</comment>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Numbers as decimals, in hexadecimal or binary, or milliseconds as a time</source>
        <translation>Nombres en décimal, en hexadécimal ou en binaire, ou millisecondes sous forme de temps</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <comment>stretch of an array</comment>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Surveillance</translation>
    </message>
    <message>
        <source>Add, rename or remove a list</source>
        <translation>Ajouter, renommer ou supprimer une liste</translation>
    </message>
    <message>
        <source>Name of the list:</source>
        <translation>Nom de la liste&#xa0;:</translation>
    </message>
    <message>
        <source>New List…</source>
        <translation>Nouvelle liste…</translation>
    </message>
    <message>
        <source>New List</source>
        <translation>Nouvelle liste</translation>
    </message>
    <message>
        <source>Rename the List…</source>
        <translation>Renommer la liste…</translation>
    </message>
    <message>
        <source>Rename the List</source>
        <translation>Renommer la liste</translation>
    </message>
    <message>
        <source>Remove the List</source>
        <translation>Supprimer la liste</translation>
    </message>
    <message>
        <source>Number Format</source>
        <translation>Format des nombres</translation>
    </message>
    <message>
        <source>As in the list</source>
        <translation>Comme la liste</translation>
    </message>
    <message>
        <source>Source of %1 with the Values of %2</source>
        <translation>Source de %1 avec les valeurs de %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::WhyView</name>
    <message>
        <source>For example Main.level &gt; 80</source>
        <translation>Par exemple Main.level &gt; 80</translation>
    </message>
    <message>
        <source>Variable or expression to explain</source>
        <translation>Variable ou expression à expliquer</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Pourquoi&#x202f;?</translation>
    </message>
    <message>
        <source>What changed it, and what had to hold</source>
        <translation>Ce qui l’a modifié, et ce qui devait être vrai</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>Pourquoi pas&#x202f;?</translation>
    </message>
    <message>
        <source>The smallest changes that would change the result of the condition</source>
        <translation>Les plus petits changements qui donneraient un autre résultat à la condition</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>Qui a écrit cela&#x202f;?</translation>
    </message>
    <message>
        <source>All changes in the recording, and what made each of them</source>
        <translation>Tous les changements dans l’enregistrement, et la cause de chacun</translation>
    </message>
    <message>
        <source>Explanation</source>
        <translation>Explication</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Cycle</translation>
    </message>
    <message>
        <source>Right-click a variable in the text, the watch, the tree, the trace or a panel and ask why it has its value.</source>
        <translation>Cliquez avec le bouton droit sur une variable dans le texte, la surveillance, l’arborescence, la trace ou une vue, et demandez pourquoi elle a cette valeur.</translation>
    </message>
    <message>
        <source>Searching the recorded scans…</source>
        <translation>Examen des cycles enregistrés…</translation>
    </message>
    <message>
        <source>There is no recording yet: run the program first.</source>
        <translation>Il n’y a pas encore d’enregistrement&#xa0;: exécutez d’abord le programme.</translation>
    </message>
    <message>
        <source>%1 · scan %2</source>
        <comment>time and number</comment>
        <translation>%1 · cycle %2</translation>
    </message>
    <message>
        <source>Earlier changes…</source>
        <translation>Changements antérieurs…</translation>
    </message>
    <message>
        <source>Why Is %1 So?</source>
        <translation>Pourquoi %1 est-il ainsi&#x202f;?</translation>
    </message>
    <message>
        <source>Who Set %1?</source>
        <translation>Qui a écrit %1&#x202f;?</translation>
    </message>
    <message>
        <source>Copy the Answer</source>
        <translation>Copier la réponse</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancel (Esc)</source>
        <translation>Annuler (Échap)</translation>
    </message>
    <message>
        <source>Cancelled: there is no answer.</source>
        <translation>Annulé&#xa0;: il n’y a pas de réponse.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::AlarmEditor</name>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Priorité</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Add an alarm</source>
        <translation>Ajouter une alarme</translation>
    </message>
    <message>
        <source>Add a class</source>
        <translation>Ajouter une classe</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Classes</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Add alarm</source>
        <translation>Ajouter une alarme</translation>
    </message>
    <message>
        <source>Add class</source>
        <translation>Ajouter une classe</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ArrayArrangementDialog</name>
    <message>
        <source>Arrange over array</source>
        <translation>Disposer selon un tableau</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Tableau</translation>
    </message>
    <message>
        <source>First index</source>
        <translation>Premier indice</translation>
    </message>
    <message>
        <source>Last index</source>
        <translation>Dernier indice</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Horizontal gap</source>
        <translation>Écart horizontal</translation>
    </message>
    <message>
        <source>Vertical gap</source>
        <translation>Écart vertical</translation>
    </message>
    <message>
        <source>In the other arguments, # becomes the index.</source>
        <translation>Dans les autres arguments, # devient l’indice.</translation>
    </message>
    <message>
        <source>Choose an array with one index, for example Plant.Valves.</source>
        <translation>Choisissez un tableau à un indice, par exemple Plant.Valves.</translation>
    </message>
    <message>
        <source>They reach to %1 × %2, the panel only to %3 × %4: make the faceplate smaller or the panel larger.</source>
        <translation>Elles vont jusqu’à %1 × %2, la vue seulement jusqu’à %3 × %4&#xa0;: réduisez la vue d’objet ou agrandissez la vue.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ArrayDialog</name>
    <message>
        <source>Duplicate as array</source>
        <translation>Dupliquer en tableau</translation>
    </message>
    <message>
        <source>Number of elements</source>
        <translation>Nombre d’éléments</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Vertical gap</source>
        <translation>Écart vertical</translation>
    </message>
    <message>
        <source>Index step</source>
        <translation>Pas d’indice</translation>
    </message>
    <message>
        <source>Horizontal gap</source>
        <translation>Écart horizontal</translation>
    </message>
</context>
<context>
    <name>plc::hmi::DesignCanvas</name>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Move point</source>
        <translation>Déplacer le point</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Insérer</translation>
    </message>
    <message>
        <source>Resize</source>
        <translation>Redimensionner</translation>
    </message>
    <message>
        <source>Bind</source>
        <translation>Lier</translation>
    </message>
    <message>
        <source>%1 has no single value: drop one of its members, or first draw a panel with a parameter of the type %2</source>
        <translation>%1 n’a pas de valeur unique&#xa0;: déposez l’un de ses membres ou dessinez d’abord une vue avec un paramètre du type %2</translation>
    </message>
    <message>
        <source>Place in cell</source>
        <translation>Placer dans la cellule</translation>
    </message>
</context>
<context>
    <name>plc::hmi::DesignContext</name>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renommer %1</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Rename Theme</source>
        <translation>Renommer le thème</translation>
    </message>
</context>
<context>
    <name>plc::hmi::Outline</name>
    <message>
        <source>Lock</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>No elements yet. Drag one from the palette onto the panel.</source>
        <translation>Aucun élément. Faites-en glisser un de la palette sur la vue.</translation>
    </message>
    <message>
        <source>Reorder</source>
        <translation>Changer l’ordre</translation>
    </message>
</context>
<context>
    <name>plc::hmi::Palette</name>
    <message>
        <source>Search elements</source>
        <translation>Chercher un élément</translation>
    </message>
    <message>
        <source>Faceplates</source>
        <translation>Vues d’objet</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Éléments</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PanelDesigner</name>
    <message>
        <source>Issue</source>
        <translation>Problème</translation>
    </message>
    <message>
        <source>Element</source>
        <translation>Élément</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Duplicate as Array…</source>
        <translation>Dupliquer en tableau…</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Tout sélectionner</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Align Left</source>
        <translation>Aligner à gauche</translation>
    </message>
    <message>
        <source>Align Centres</source>
        <translation>Centrer horizontalement</translation>
    </message>
    <message>
        <source>Align Right</source>
        <translation>Aligner à droite</translation>
    </message>
    <message>
        <source>Align Top</source>
        <translation>Aligner en haut</translation>
    </message>
    <message>
        <source>Align Middles</source>
        <translation>Centrer verticalement</translation>
    </message>
    <message>
        <source>Align Bottom</source>
        <translation>Aligner en bas</translation>
    </message>
    <message>
        <source>Distribute Horizontally</source>
        <translation>Répartir horizontalement</translation>
    </message>
    <message>
        <source>Distribute Vertically</source>
        <translation>Répartir verticalement</translation>
    </message>
    <message>
        <source>Same Width</source>
        <translation>Même largeur</translation>
    </message>
    <message>
        <source>Same Height</source>
        <translation>Même hauteur</translation>
    </message>
    <message>
        <source>Bring to Front</source>
        <translation>Mettre au premier plan</translation>
    </message>
    <message>
        <source>Bring Forward</source>
        <translation>Avancer</translation>
    </message>
    <message>
        <source>Send Backward</source>
        <translation>Reculer</translation>
    </message>
    <message>
        <source>Send to Back</source>
        <translation>Mettre à l’arrière-plan</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grouper</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Dissocier</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>Show the Grid</source>
        <translation>Afficher la grille</translation>
    </message>
    <message>
        <source>Snap (Alt: not now)</source>
        <translation>Aimanter (Alt&#xa0;: pas maintenant)</translation>
    </message>
    <message>
        <source>Live Preview</source>
        <translation>Aperçu en direct</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Zoom avant</translation>
    </message>
    <message>
        <source>Zoom Out</source>
        <translation>Zoom arrière</translation>
    </message>
    <message>
        <source>Zoom 100 %</source>
        <translation>Zoom 100&#xa0;%</translation>
    </message>
    <message>
        <source>Zoom to Fit</source>
        <translation>Ajuster à la fenêtre</translation>
    </message>
    <message>
        <source>Language shown</source>
        <translation>Langue affichée</translation>
    </message>
    <message>
        <source>Theme of the panel</source>
        <translation>Thème de la vue</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contraste élevé</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Duplicate as array</source>
        <translation>Dupliquer en tableau</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Éléments</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Same Size</source>
        <translation>Même taille</translation>
    </message>
    <message>
        <source>Paste in Place</source>
        <translation>Coller au même endroit</translation>
    </message>
    <message>
        <source>Arrange Over Array…</source>
        <translation>Disposer selon un tableau…</translation>
    </message>
    <message>
        <source>Arrange over array</source>
        <translation>Disposer selon un tableau</translation>
    </message>
    <message>
        <source>Fix All Issues</source>
        <translation>Corriger tous les problèmes</translation>
    </message>
    <message>
        <source>Fix Issue</source>
        <translation>Corriger le problème</translation>
    </message>
    <message>
        <source>Explain Issue</source>
        <translation>Expliquer le problème</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Issues</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>Lay Out in a Row</source>
        <translation>Disposer en ligne</translation>
    </message>
    <message>
        <source>Lay Out in a Column</source>
        <translation>Disposer en colonne</translation>
    </message>
    <message>
        <source>Lay Out in a Grid</source>
        <translation>Disposer en grille</translation>
    </message>
    <message>
        <source>Lay out</source>
        <translation>Disposer</translation>
    </message>
    <message>
        <source>Edit Themes…</source>
        <translation>Modifier les thèmes…</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PanelKeys</name>
    <message>
        <source>Panel</source>
        <translation>Vue</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PasswordDialog</name>
    <message>
        <source>Set Password</source>
        <translation>Définir le mot de passe</translation>
    </message>
    <message>
        <source>Password of %1:</source>
        <translation>Mot de passe de&#xa0;%1&#xa0;:</translation>
    </message>
    <message>
        <source>The two passwords differ.</source>
        <translation>Les deux mots de passe sont différents.</translation>
    </message>
    <message>
        <source>Repeat:</source>
        <translation>Répéter&#xa0;:</translation>
    </message>
    <message>
        <source>Repeat the password.</source>
        <translation>Répétez le mot de passe.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PeopleEditor</name>
    <message>
        <source>User</source>
        <translation>Utilisateur</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Rôles</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Start panel</source>
        <translation>Vue de départ</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Mot de passe</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Utilisateurs</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Add a User</source>
        <translation>Ajouter un utilisateur</translation>
    </message>
    <message>
        <source>Set Password…</source>
        <translation>Définir le mot de passe…</translation>
    </message>
    <message>
        <source>Remove User</source>
        <translation>Retirer l’utilisateur</translation>
    </message>
    <message>
        <source>Add a Role</source>
        <translation>Ajouter un rôle</translation>
    </message>
    <message>
        <source>Remove Role</source>
        <translation>Retirer le rôle</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>never</source>
        <translation>jamais</translation>
    </message>
    <message>
        <source>Logged out after</source>
        <translation>Déconnexion après</translation>
    </message>
    <message>
        <source>Logged out after </source>
        <translation>Déconnexion après </translation>
    </message>
    <message>
        <source>Logged Out After</source>
        <translation>Déconnexion après</translation>
    </message>
    <message>
        <source>Set Password</source>
        <translation>Définir le mot de passe</translation>
    </message>
    <message>
        <source>none: cannot log in</source>
        <translation>aucun&#xa0;: connexion impossible</translation>
    </message>
    <message>
        <source>set</source>
        <translation>défini</translation>
    </message>
    <message>
        <source>Rename Role</source>
        <translation>Renommer le rôle</translation>
    </message>
    <message>
        <source>Without users, everybody may do everything. Add a role, then a user with a password.</source>
        <translation>Sans utilisateurs, tout est permis à tous. Ajoutez un rôle, puis un utilisateur avec un mot de passe.</translation>
    </message>
    <message>
        <source>To restrict an element to some users, set its property &quot;Only for the roles&quot;.</source>
        <translation>Pour réserver un élément à certains utilisateurs, définissez sa propriété «&#xa0;Seulement pour les rôles&#xa0;».</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PropertySheet</name>
    <message>
        <source>Search properties</source>
        <translation>Rechercher des propriétés</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n élément</numerusform>
            <numerusform>%n éléments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::hmi::RecipeEditor</name>
    <message>
        <source>Add a Recipe</source>
        <translation>Ajouter une recette</translation>
    </message>
    <message>
        <source>Add a Variable</source>
        <translation>Ajouter une variable</translation>
    </message>
    <message>
        <source>Add a Set</source>
        <translation>Ajouter un jeu de valeurs</translation>
    </message>
    <message>
        <source>Remove Row or Set</source>
        <translation>Retirer la ligne ou le jeu de valeurs</translation>
    </message>
    <message>
        <source>Remove Recipe</source>
        <translation>Retirer la recette</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>Importer un fichier CSV</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>Exporter en CSV</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recettes</translation>
    </message>
    <message>
        <source>Variables and sets of the recipe</source>
        <translation>Variables et jeux de valeurs de la recette</translation>
    </message>
    <message>
        <source>Rename Recipe</source>
        <translation>Renommer la recette</translation>
    </message>
    <message>
        <source>Rename Set</source>
        <translation>Renommer le jeu de valeurs</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nom&#xa0;:</translation>
    </message>
    <message>
        <source>Remove Set</source>
        <translation>Retirer le jeu de valeurs</translation>
    </message>
    <message>
        <source>Remove Row</source>
        <translation>Retirer la ligne</translation>
    </message>
    <message>
        <source>Add a recipe, then its variables, then a set for each product.</source>
        <translation>Ajoutez une recette, puis ses variables, puis un jeu de valeurs pour chaque produit.</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
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
        <translation>Une recette doit avoir un nom.</translation>
    </message>
    <message>
        <source>The recipe &quot;%1&quot; already exists; choose another name.</source>
        <translation>Une recette «&#xa0;%1&#xa0;» existe déjà&#x202f;; choisissez un autre nom.</translation>
    </message>
    <message>
        <source>The set &quot;%1&quot; already exists; choose another name.</source>
        <translation>Un jeu de valeurs «&#xa0;%1&#xa0;» existe déjà&#x202f;; choisissez un autre nom.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number; a limit is written like 12.5.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre&#x202f;; une limite s’écrit par exemple 12.5.</translation>
    </message>
    <message>
        <source>A row needs a variable; Remove Row or Set takes the row away.</source>
        <translation>Une ligne doit avoir une variable&#x202f;; «&#xa0;Retirer la ligne ou le jeu de valeurs&#xa0;» la supprime.</translation>
    </message>
    <message>
        <source>%1 is already in the recipe; choose another variable.</source>
        <translation>%1 est déjà dans la recette&#x202f;; choisissez une autre variable.</translation>
    </message>
    <message>
        <source>Select a cell of the set that is to be renamed.</source>
        <translation>Sélectionnez une cellule du jeu de valeurs à renommer.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::RecordsDialog</name>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Vers le haut</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Vers le bas</translation>
    </message>
</context>
<context>
    <name>plc::hmi::TextEditor</name>
    <message>
        <source>A key %1 already exists; choose another name</source>
        <translation>Une clé %1 existe déjà&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>Only incomplete</source>
        <translation>Incomplets seulement</translation>
    </message>
    <message>
        <source>Search texts</source>
        <translation>Rechercher des textes</translation>
    </message>
    <message>
        <source>Add a key</source>
        <translation>Ajouter une clé</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Clé</translation>
    </message>
    <message>
        <source>Remove the selected keys</source>
        <translation>Supprimer les clés sélectionnées</translation>
    </message>
    <message>
        <source>Add a language</source>
        <translation>Ajouter une langue</translation>
    </message>
    <message>
        <source>Language tag, for example de or zh-CN</source>
        <translation>Étiquette de langue, par exemple de ou zh-CN</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>Importer un fichier CSV</translation>
    </message>
    <message>
        <source>Text tables (*.csv *.txt)</source>
        <translation>Tables de textes (*.csv *.txt)</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>Exporter en CSV</translation>
    </message>
    <message>
        <source>Text tables (*.csv)</source>
        <translation>Tables de textes (*.csv)</translation>
    </message>
    <message>
        <source>Add key</source>
        <translation>Ajouter une clé</translation>
    </message>
    <message>
        <source>Remove keys</source>
        <translation>Supprimer les clés</translation>
    </message>
    <message>
        <source>Add language</source>
        <translation>Ajouter une langue</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>%n texte</numerusform>
            <numerusform>%n textes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is not used.</source>
        <translation>%1 n’est pas utilisé.</translation>
    </message>
    <message>
        <source>%1 is used by %2</source>
        <translation>%1 est utilisé par %2</translation>
    </message>
    <message>
        <source>Import XLIFF</source>
        <translation>Importer XLIFF</translation>
    </message>
    <message>
        <source>Translations (*.xlf *.xliff)</source>
        <translation>Traductions (*.xlf *.xliff)</translation>
    </message>
    <message>
        <source>Export XLIFF</source>
        <translation>Exporter XLIFF</translation>
    </message>
    <message>
        <source>Translated from</source>
        <translation>Traduit depuis</translation>
    </message>
    <message>
        <source>Translated into</source>
        <translation>Traduit vers</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) taken.</source>
        <translation>
            <numerusform>%n texte repris.</numerusform>
            <numerusform>%n textes repris.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) as they were.</source>
        <translation>
            <numerusform>%n texte inchangé.</numerusform>
            <numerusform>%n textes inchangés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) without a translation.</source>
        <translation>
            <numerusform>%n texte sans traduction.</numerusform>
            <numerusform>%n textes sans traduction.</numerusform>
        </translation>
    </message>
    <message>
        <source>XLIFF %1</source>
        <translation>XLIFF %1</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Textes</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Remove language</source>
        <translation>Retirer la langue</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Retirer&#xa0;%1</translation>
    </message>
    <message>
        <source>%1 is not a language tag; choose one from the list, or enter a tag such as de or zh-CN</source>
        <translation>%1 n’est pas une étiquette de langue&#x202f;; choisissez-en une dans la liste ou saisissez une étiquette telle que de ou zh-CN</translation>
    </message>
    <message>
        <source>The table already has %1; choose another language</source>
        <translation>Le tableau contient déjà&#xa0;%1&#x202f;; choisissez une autre langue</translation>
    </message>
    <message>
        <source>Remove the language</source>
        <translation>Retirer la langue</translation>
    </message>
    <message>
        <source>Select a cell of the language that is to be removed.</source>
        <translation>Sélectionnez une cellule de la langue à retirer.</translation>
    </message>
    <message>
        <source>A table of texts keeps one language; add another one first.</source>
        <translation>Une table de textes garde une langue&#x202f;; ajoutez-en d’abord une autre.</translation>
    </message>
</context>
<context>
    <name>plc::hmi::TextModel</name>
    <message>
        <source>Key</source>
        <translation>Clé</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>Rename key</source>
        <translation>Renommer la clé</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ThemeDialog</name>
    <message>
        <source>Grounds, lines and texts</source>
        <translation>Fonds, lignes et textes</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Processus</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Colours by name</source>
        <translation>Couleurs nommées</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Based on</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Colours that this theme does not change are those of the base.</source>
        <translation>Les couleurs que ce thème ne change pas sont celles de la base.</translation>
    </message>
    <message>
        <source>Panel Themes</source>
        <translation>Thèmes des vues</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Base of the Theme</source>
        <translation>Base du thème</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Nouveau…</translation>
    </message>
    <message>
        <source>New Theme</source>
        <translation>Nouveau thème</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Rename Theme</source>
        <translation>Renommer le thème</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Name of the theme:</source>
        <translation>Nom du thème&#xa0;:</translation>
    </message>
    <message>
        <source>A theme&apos;s name cannot contain %1; choose another name</source>
        <translation>Le nom d’un thème ne peut pas contenir %1&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>A theme&apos;s name begins with a letter or a digit</source>
        <translation>Le nom d’un thème commence par une lettre ou un chiffre</translation>
    </message>
    <message>
        <source>There is a theme %1 already; choose another name</source>
        <translation>Il y a déjà un thème %1&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>There is a file %1 already; choose another name</source>
        <translation>Il y a déjà un fichier %1&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>%1 is used on %2; choose another theme there before it is deleted</source>
        <translation>%1 est utilisé dans %2&#x202f;; choisissez-y d’abord un autre thème</translation>
    </message>
    <message>
        <source>Delete Theme</source>
        <translation>Supprimer le thème</translation>
    </message>
    <message>
        <source>The project has no theme of its own yet. New… makes one that begins with the colours shown.</source>
        <translation>Le projet n’a pas encore de thème à lui. Nouveau… en crée un qui part des couleurs affichées.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 on %2: contrast %L3, %L4 is needed</source>
        <translation>%1 sur %2&#xa0;: contraste %L3, il faut %L4</translation>
    </message>
    <message>
        <source>Changed on disk too: %1. OK replaces what is there.</source>
        <translation>Modifiés aussi sur le disque&#xa0;: %1. OK remplace ce qui s’y trouve.</translation>
    </message>
    <message>
        <source>Discard the changes of the themes?</source>
        <translation>Abandonner les modifications des thèmes&#x202f;?</translation>
    </message>
</context>
<context>
    <name>plc::kit::Canvas</name>
    <message>
        <source>Overview</source>
        <translation>Vue d’ensemble</translation>
    </message>
</context>
<context>
    <name>plc::kit::ColorPopup</name>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>More colours…</source>
        <translation>Autres couleurs…</translation>
    </message>
    <message>
        <source>No colour</source>
        <translation>Aucune couleur</translation>
    </message>
</context>
<context>
    <name>plc::kit::ColumnMenu</name>
    <message>
        <source>Column %1</source>
        <translation>Colonne %1</translation>
    </message>
    <message>
        <source>Fit to Contents</source>
        <translation>Ajuster au contenu</translation>
    </message>
    <message>
        <source>Wider</source>
        <translation>Plus large</translation>
    </message>
    <message>
        <source>Narrower</source>
        <translation>Plus étroite</translation>
    </message>
    <message>
        <source>Move Left</source>
        <translation>Déplacer à gauche</translation>
    </message>
    <message>
        <source>Move Right</source>
        <translation>Déplacer à droite</translation>
    </message>
    <message>
        <source>Sort Ascending</source>
        <translation>Trier par ordre croissant</translation>
    </message>
    <message>
        <source>Sort Descending</source>
        <translation>Trier par ordre décroissant</translation>
    </message>
</context>
<context>
    <name>plc::kit::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation>Palette de commandes</translation>
    </message>
    <message>
        <source>Type to find a command</source>
        <translation>Tapez pour trouver une commande</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>menu and command</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>plc::kit::PropertyGrid</name>
    <message>
        <source>Choose a variable</source>
        <translation>Choisir une variable</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Choisir un fichier</translation>
    </message>
    <message>
        <source>Edit in a window</source>
        <translation>Modifier dans une fenêtre</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Oui</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Non</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>Propriété</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>various</source>
        <translation>différents</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Choose from a list</source>
        <translation>Choisir dans une liste</translation>
    </message>
</context>
<context>
    <name>plc::kit::VariablePicker</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>Search variables</source>
        <translation>Rechercher des variables</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Found variables</source>
        <translation>Variables trouvées</translation>
    </message>
    <message>
        <source>Choose a variable</source>
        <translation>Choisir une variable</translation>
    </message>
</context>
<context>
    <name>plc::kit::WorkStrip</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>%1 is being cancelled…</source>
        <translation>Annulation en cours&#xa0;: %1…</translation>
    </message>
    <message>
        <source>Cancel: %1</source>
        <translation>Annuler&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>plc::plot::PlotView</name>
    <message>
        <source>Chart</source>
        <translation>Graphique</translation>
    </message>
    <message>
        <source>%1
Click selects, Ctrl+click shows or hides.</source>
        <translation>%1
Un clic sélectionne, Ctrl+clic affiche ou masque.</translation>
    </message>
</context>
<context>
    <name>plc::trace::ChannelPanel</name>
    <message>
        <source>Variable or expression</source>
        <translation>Variable ou expression</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>Ajouter une voie</translation>
    </message>
    <message>
        <source>Add as a channel</source>
        <translation>Ajouter comme voie</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Voie</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Voies</translation>
    </message>
    <message>
        <source>Show channel</source>
        <translation>Afficher la voie</translation>
    </message>
    <message>
        <source>Hide channel</source>
        <translation>Masquer la voie</translation>
    </message>
    <message>
        <source>Chart %1</source>
        <translation>Graphique %1</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erreur</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Expression</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Style</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Palier</translation>
    </message>
    <message>
        <source>Digital</source>
        <translation>Numérique</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Épaisseur du trait</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Graphique</translation>
    </message>
    <message>
        <source>New chart</source>
        <translation>Nouveau graphique</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Axe %1</translation>
    </message>
    <message>
        <source>New axis</source>
        <translation>Nouvel axe</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Share of height</source>
        <translation>Part de la hauteur</translation>
    </message>
    <message>
        <source>Scaling</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Fit to view</source>
        <translation>Ajuster à l’affichage</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fixe</translation>
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
        <translation>À droite</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Every n-th scan</source>
        <translation>Tous les n cycles</translation>
    </message>
    <message>
        <source>Record while</source>
        <translation>Condition d’enregistrement</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Déclencheur</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Front</translation>
    </message>
    <message>
        <source>Rising</source>
        <translation>Montant</translation>
    </message>
    <message>
        <source>Falling</source>
        <translation>Descendant</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Désactivé</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Unique</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Répété</translation>
    </message>
    <message>
        <source>Shown before</source>
        <translation>Affiché avant le déclenchement</translation>
    </message>
    <message>
        <source>Shown after</source>
        <translation>Affiché après le déclenchement</translation>
    </message>
    <message>
        <source>Change channel</source>
        <translation>Modifier la voie</translation>
    </message>
    <message>
        <source>Change chart</source>
        <translation>Modifier le graphique</translation>
    </message>
    <message>
        <source>Change trace</source>
        <translation>Modifier la trace</translation>
    </message>
    <message>
        <source>Remove channel</source>
        <translation>Supprimer la voie</translation>
    </message>
    <message>
        <source>Remove chart</source>
        <translation>Supprimer le graphique</translation>
    </message>
    <message>
        <source>Move channel</source>
        <translation>Déplacer la voie</translation>
    </message>
    <message>
        <source>Compared recording</source>
        <translation>Enregistrement comparé</translation>
    </message>
    <message>
        <source>Offset in time</source>
        <translation>Décalage temporel</translation>
    </message>
</context>
<context>
    <name>plc::trace::FigurePane</name>
    <message>
        <source>Save as %1</source>
        <translation>Enregistrer en %1</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Copy as Picture</source>
        <translation>Copier comme image</translation>
    </message>
    <message>
        <source>Save as %1…</source>
        <translation>Enregistrer en %1…</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>Hann window</source>
        <translation>Fenêtre de Hann</translation>
    </message>
    <message>
        <source>Flat top: exact amplitudes</source>
        <translation>Flat top&#xa0;: amplitudes exactes</translation>
    </message>
    <message>
        <source>No window</source>
        <translation>Pas de fenêtre</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmique</translation>
    </message>
    <message>
        <source>Charts over time only</source>
        <translation>Courbes temporelles seules</translation>
    </message>
    <message>
        <source>Horizontal value</source>
        <translation>Valeur horizontale</translation>
    </message>
    <message>
        <source>Window of the spectrum</source>
        <translation>Fenêtre du spectre</translation>
    </message>
    <message>
        <source>Logarithmic axes</source>
        <translation>Axes logarithmiques</translation>
    </message>
    <message>
        <source>Input:</source>
        <translation>Entrée&#xa0;:</translation>
    </message>
    <message>
        <source>Horizontal:</source>
        <translation>Horizontal&#xa0;:</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Measure between Points</source>
        <translation>Mesurer entre deux points</translation>
    </message>
</context>
<context>
    <name>plc::trace::TimeBar</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Resumed from here
%1</source>
        <translation>Repris ici
%1</translation>
    </message>
</context>
<context>
    <name>plc::trace::TimeSlider</name>
    <message>
        <source>Time slider</source>
        <translation>Curseur temporel</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Variable whose changes to step to</source>
        <translation>Variable dont on parcourt les changements</translation>
    </message>
    <message>
        <source>The arrows beside step to its previous and next change</source>
        <translation>Les flèches à côté vont à son changement précédent et suivant</translation>
    </message>
    <message>
        <source>One scan back (Left)</source>
        <translation>Un cycle en arrière (Gauche)</translation>
    </message>
    <message>
        <source>One scan forward (Right)</source>
        <translation>Un cycle en avant (Droite)</translation>
    </message>
    <message>
        <source>Previous change of the variable (Ctrl+Left)</source>
        <translation>Changement précédent de la variable (Ctrl+Gauche)</translation>
    </message>
    <message>
        <source>Next change of the variable (Ctrl+Right)</source>
        <translation>Changement suivant de la variable (Ctrl+Droite)</translation>
    </message>
    <message>
        <source>Resume the controller from this scan</source>
        <translation>Reprendre l’automate à partir de ce cycle</translation>
    </message>
    <message>
        <source>Back to the newest scan (End)</source>
        <translation>Retour au cycle le plus récent (Fin)</translation>
    </message>
    <message>
        <source>Older scans are no longer kept.</source>
        <translation>Les cycles plus anciens ne sont plus conservés.</translation>
    </message>
    <message>
        <source>%1 does not change before this scan.</source>
        <translation>%1 ne change pas avant ce cycle.</translation>
    </message>
    <message>
        <source>%1 does not change after this scan.</source>
        <translation>%1 ne change pas après ce cycle.</translation>
    </message>
    <message>
        <source>No recording</source>
        <translation>Pas d’enregistrement</translation>
    </message>
    <message>
        <source>no longer kept</source>
        <translation>n’est plus conservé</translation>
    </message>
    <message>
        <source>scan %1  %2</source>
        <translation>cycle %1  %2</translation>
    </message>
</context>
<context>
    <name>plc::trace::TraceView</name>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Show channel</source>
        <translation>Afficher la voie</translation>
    </message>
    <message>
        <source>Hide channel</source>
        <translation>Masquer la voie</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Suivre</translation>
    </message>
    <message>
        <source>Follow the newest scan (End)</source>
        <translation>Suivre le cycle le plus récent (Fin)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Show everything recorded (Home)</source>
        <translation>Afficher tout ce qui est enregistré (Début)</translation>
    </message>
    <message>
        <source>Fit values</source>
        <translation>Ajuster les valeurs</translation>
    </message>
    <message>
        <source>Let the value axes fit again</source>
        <translation>Réajuster les axes des valeurs</translation>
    </message>
    <message>
        <source>Zoom back</source>
        <translation>Zoom précédent</translation>
    </message>
    <message>
        <source>Back to the view before (Backspace)</source>
        <translation>Revenir à l’affichage précédent (Retour arrière)</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Drag a box to zoom: flat for time, upright for values</source>
        <translation>Tracez un cadre pour zoomer&#xa0;: plat pour le temps, haut pour les valeurs</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Déplacer l’affichage</translation>
    </message>
    <message>
        <source>Drag to pan (middle button always does)</source>
        <translation>Faites glisser pour déplacer l’affichage (toujours avec le bouton central)</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Curseurs</translation>
    </message>
    <message>
        <source>Two cursors (Ctrl+click sets A, Shift+click sets B)</source>
        <translation>Deux curseurs (Ctrl+clic place A, Maj+clic place B)</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Table of values and statistics between the cursors</source>
        <translation>Tableau des valeurs et statistiques entre les curseurs</translation>
    </message>
    <message>
        <source>Measuring table</source>
        <translation>Tableau de mesure</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Déclencheur</translation>
    </message>
    <message>
        <source>Arm the trigger set in the properties of the trace</source>
        <translation>Armer le déclencheur défini dans les propriétés de la trace</translation>
    </message>
    <message>
        <source>Previous trigger</source>
        <translation>Déclenchement précédent</translation>
    </message>
    <message>
        <source>Where the trigger would have fired before</source>
        <translation>Où le déclencheur aurait agi auparavant</translation>
    </message>
    <message>
        <source>Next trigger</source>
        <translation>Déclenchement suivant</translation>
    </message>
    <message>
        <source>Where the trigger would have fired next</source>
        <translation>Où le déclencheur aurait agi ensuite</translation>
    </message>
    <message>
        <source>Add chart</source>
        <translation>Ajouter un graphique</translation>
    </message>
    <message>
        <source>Another chart over the same time</source>
        <translation>Un autre graphique sur la même durée</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Load an older recording beneath the present one</source>
        <translation>Charger un enregistrement plus ancien sous l’actuel</translation>
    </message>
    <message>
        <source>Recording to draw beneath</source>
        <translation>Enregistrement à tracer en dessous</translation>
    </message>
    <message>
        <source>Trace configuration</source>
        <translation>Configuration de trace</translation>
    </message>
    <message>
        <source>Open Configuration…</source>
        <translation>Ouvrir une configuration…</translation>
    </message>
    <message>
        <source>Open trace configuration</source>
        <translation>Ouvrir une configuration de trace</translation>
    </message>
    <message>
        <source>Trace configurations (*.trace.json)</source>
        <translation>Configurations de trace (*.trace.json)</translation>
    </message>
    <message>
        <source>Save trace configuration</source>
        <translation>Enregistrer la configuration de trace</translation>
    </message>
    <message>
        <source>Save Configuration</source>
        <translation>Enregistrer la configuration</translation>
    </message>
    <message>
        <source>Save Configuration As…</source>
        <translation>Enregistrer la configuration sous…</translation>
    </message>
    <message>
        <source>Open Recording…</source>
        <translation>Ouvrir un enregistrement…</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Ouvrir un enregistrement</translation>
    </message>
    <message>
        <source>Back to the Running PLC</source>
        <translation>Retour au direct de l’automate</translation>
    </message>
    <message>
        <source>Save Recording…</source>
        <translation>Sauvegarder l’enregistrement…</translation>
    </message>
    <message>
        <source>Save recording</source>
        <translation>Sauvegarder l’enregistrement</translation>
    </message>
    <message>
        <source>Recordings (*.rec)</source>
        <translation>Enregistrements (*.rec)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Copy as Picture</source>
        <translation>Copier comme image</translation>
    </message>
    <message>
        <source>Save Samples in View as CSV…</source>
        <translation>Enregistrer les valeurs visibles en CSV…</translation>
    </message>
    <message>
        <source>Save as %1…</source>
        <translation>Enregistrer en %1…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Imprimer…</translation>
    </message>
    <message>
        <source>Save as %1</source>
        <translation>Enregistrer en %1</translation>
    </message>
    <message>
        <source>Add channel</source>
        <translation>Ajouter une voie</translation>
    </message>
    <message>
        <source>Arm trigger</source>
        <translation>Armer le déclencheur</translation>
    </message>
    <message>
        <source>The trigger has no expression yet: enter one in the properties of the trace.</source>
        <translation>Le déclencheur n’a pas encore d’expression&#xa0;: saisissez-en une dans les propriétés de la trace.</translation>
    </message>
    <message>
        <source>Trigger armed</source>
        <translation>Déclencheur armé</translation>
    </message>
    <message>
        <source>Triggered, collecting</source>
        <translation>Déclenché, acquisition en cours</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>Déclenché</translation>
    </message>
    <message numerus="yes">
        <source>(%n shot(s))</source>
        <translation>
            <numerusform>(%n déclenchement)</numerusform>
            <numerusform>(%n déclenchements)</numerusform>
        </translation>
    </message>
    <message>
        <source>Not running</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>%L1 scans kept  ·  history %2 of %3 MB  ·  channels %4 of %5 MB</source>
        <translation>%L1 cycles conservés  ·  historique %2 sur %3&#xa0;Mo  ·  voies %4 sur %5&#xa0;Mo</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>Remove Channel</source>
        <translation>Supprimer la voie</translation>
    </message>
    <message>
        <source>Add Channel…</source>
        <translation>Ajouter une voie…</translation>
    </message>
    <message>
        <source>Trigger off</source>
        <translation>Désactiver le déclencheur</translation>
    </message>
    <message>
        <source>Saving the samples…</source>
        <translation>Enregistrement des valeurs…</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Ouverture de %1…</translation>
    </message>
    <message>
        <source>Saving the recording…</source>
        <translation>Écriture de l’enregistrement…</translation>
    </message>
    <message>
        <source>%1, %2 later</source>
        <translation>%1, %2 plus tard</translation>
    </message>
    <message>
        <source>%1, %2 earlier</source>
        <translation>%1, %2 plus tôt</translation>
    </message>
    <message>
        <source>Measure between points</source>
        <translation>Mesurer entre deux points</translation>
    </message>
    <message>
        <source>Drag from one point to another: time, value, slope and frequency between them (M)</source>
        <translation>Glisser d’un point à un autre&#xa0;: temps, valeur, pente et fréquence entre les deux (M)</translation>
    </message>
    <message>
        <source>XY plot, spectrum, frequency response, runs</source>
        <translation>Tracé XY, spectre, réponse en fréquence, exécutions</translation>
    </message>
    <message>
        <source>Add Channel of Another File…</source>
        <translation>Ajouter une voie d’un autre fichier…</translation>
    </message>
    <message>
        <source>Show Beside</source>
        <translation>Afficher à côté</translation>
    </message>
    <message>
        <source>Measure between Points</source>
        <translation>Mesurer entre deux points</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>Ajouter une note</translation>
    </message>
    <message>
        <source>Add Note</source>
        <translation>Ajouter une note</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Note&#xa0;:</translation>
    </message>
    <message>
        <source>Edit Note</source>
        <translation>Modifier la note</translation>
    </message>
    <message>
        <source>Edit note</source>
        <translation>Modifier la note</translation>
    </message>
    <message>
        <source>Remove note</source>
        <translation>Supprimer la note</translation>
    </message>
    <message>
        <source>Edit Note…</source>
        <translation>Modifier la note…</translation>
    </message>
    <message>
        <source>Remove Note</source>
        <translation>Supprimer la note</translation>
    </message>
    <message>
        <source>Add Note…</source>
        <translation>Ajouter une note…</translation>
    </message>
    <message>
        <source>File to add a channel of</source>
        <translation>Fichier dont ajouter une voie</translation>
    </message>
    <message>
        <source>Recordings and tables (*.rec *.csv *.tsv *.txt *.trace);;All files (*)</source>
        <translation>Enregistrements et tableaux (*.rec *.csv *.tsv *.txt *.trace);;Tous les fichiers (*)</translation>
    </message>
</context>
</TS>
