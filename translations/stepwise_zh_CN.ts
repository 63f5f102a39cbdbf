<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>DeviceFields</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>注释</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>协议</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>启用</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>主机</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Unit number</source>
        <translation>站号</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Parity</source>
        <translation>奇偶校验</translation>
    </message>
    <message>
        <source>Data bits</source>
        <translation>数据位</translation>
    </message>
    <message>
        <source>Stop bits</source>
        <translation>停止位</translation>
    </message>
    <message>
        <source>Poll interval</source>
        <translation>轮询间隔</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>超时时间</translation>
    </message>
    <message>
        <source>Longest pause between attempts</source>
        <translation>重试的最长间隔</translation>
    </message>
    <message>
        <source>Variable: device responds</source>
        <translation>变量：设备有应答</translation>
    </message>
    <message>
        <source>Client ID</source>
        <translation>客户端标识</translation>
    </message>
    <message>
        <source>User</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>Password file</source>
        <translation>密码文件</translation>
    </message>
    <message>
        <source>TLS encryption</source>
        <translation>TLS 加密</translation>
    </message>
    <message>
        <source>File of CA certificates</source>
        <translation>CA 证书文件</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Bit of the register</source>
        <translation>寄存器的位</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>字节顺序</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>系数</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Path in the JSON message</source>
        <translation>JSON 消息中的路径</translation>
    </message>
    <message>
        <source>Quality of service (0 to 2)</source>
        <translation>服务质量（QoS 0 到 2）</translation>
    </message>
    <message>
        <source>Retained message</source>
        <translation>保留消息 (retain)</translation>
    </message>
    <message>
        <source>If the connection is lost</source>
        <translation>连接断开时</translation>
    </message>
    <message>
        <source>Safe value</source>
        <translation>安全值</translation>
    </message>
    <message>
        <source>Variable: channel is good</source>
        <translation>变量：通道有效</translation>
    </message>
    <message>
        <source>Modbus TCP device</source>
        <translation>Modbus TCP 设备</translation>
    </message>
    <message>
        <source>Modbus RTU device (serial)</source>
        <translation>Modbus RTU 设备（串行）</translation>
    </message>
    <message>
        <source>Modbus TCP server</source>
        <translation>Modbus TCP 服务器</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>MQTT 代理</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>线圈</translation>
    </message>
    <message>
        <source>Discrete input</source>
        <translation>离散输入</translation>
    </message>
    <message>
        <source>Holding register</source>
        <translation>保持寄存器</translation>
    </message>
    <message>
        <source>Input register</source>
        <translation>输入寄存器</translation>
    </message>
    <message>
        <source>Keep the last value</source>
        <translation>保持最后的值</translation>
    </message>
    <message>
        <source>Use the safe value</source>
        <translation>使用安全值</translation>
    </message>
    <message>
        <source>Stop the controller</source>
        <translation>停止控制器</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>偶校验</translation>
    </message>
    <message>
        <source>Odd</source>
        <translation>奇校验</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>No</source>
        <translation>否</translation>
    </message>
</context>
<context>
    <name>Devices</name>
    <message>
        <source>This is not valid JSON; check the commas and quotes in front of this line</source>
        <translation>这不是有效的 JSON；请检查此行之前的逗号和引号</translation>
    </message>
    <message>
        <source>The file must be an object with a list named &quot;devices&quot;</source>
        <translation>文件必须是一个对象，其中有名为“devices”的列表</translation>
    </message>
    <message>
        <source>Each entry of &quot;{0}&quot; must be an object in braces</source>
        <translation>“{0}”的每一项必须是花括号中的对象</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is missing; add it</source>
        <translation>缺少“{0}”；请添加</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a text in quotes</source>
        <translation>“{0}”必须是带引号的文本</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be true or false</source>
        <translation>“{0}”必须是 true 或 false</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a number</source>
        <translation>“{0}”必须是数字</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a whole number from {1} to {2}</source>
        <translation>“{0}”必须是 {1} 到 {2} 的整数</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a time such as &quot;100ms&quot; or &quot;2s&quot;, at least {1} ms and at most an hour</source>
        <translation>“{0}”必须是“100ms”或“2s”这样的时间，至少 {1} ms，最多一小时</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; cannot be {1}; choose one of: {2}</source>
        <translation>“{0}”不能是 {1}；请从以下选项中选择：{2}</translation>
    </message>
    <message>
        <source>There is no field &quot;{0}&quot;; it is kept but has no effect</source>
        <translation>没有字段“{0}”；它会保留，但不起作用</translation>
    </message>
    <message>
        <source>There is no field &quot;{0}&quot;; did you mean &quot;{1}&quot;?</source>
        <translation>没有字段“{0}”；是否指“{1}”？</translation>
    </message>
    <message>
        <source>There are two devices named {0}; rename one</source>
        <translation>有两个设备都名为 {0}；请重命名其中一个</translation>
    </message>
    <message>
        <source>{0} has two channels named {1}; rename one</source>
        <translation>{0} 有两个名为 {1} 的通道；请重命名其中一个</translation>
    </message>
    <message>
        <source>{0} is not a name; use letters, digits and underscores, and begin with a letter</source>
        <translation>{0} 不是有效的名称；请使用字母、数字和下划线，并以字母开头</translation>
    </message>
    <message>
        <source>{0} is neither a host name nor an address, for example plc1.local or 192.168.0.10</source>
        <translation>{0} 既不是主机名也不是地址，例如 plc1.local 或 192.168.0.10</translation>
    </message>
    <message>
        <source>{0} is not a serial port; write its path, for example /dev/ttyUSB0</source>
        <translation>{0} 不是串口；请写其路径，例如 /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>{0} and {1} both listen on port {2}; change one of the ports</source>
        <translation>{0} 和 {1} 都监听端口 {2}；请更改其中一个端口</translation>
    </message>
    <message>
        <source>Ports below 1024 require special privileges; use a port such as 1502</source>
        <translation>1024 以下的端口需要特殊权限；请使用 1502 这样的端口</translation>
    </message>
    <message>
        <source>A channel of an MQTT device needs a &quot;topic&quot;, for example &quot;plant/level&quot;</source>
        <translation>MQTT 设备的通道需要“topic”，例如“plant/level”</translation>
    </message>
    <message>
        <source>{0}: a channel has one topic, without the wildcards + and #</source>
        <translation>{0}：一个通道有一个主题，不含通配符 + 和 #</translation>
    </message>
    <message>
        <source>{0} is not a path into JSON; write for example /sensor/temperature</source>
        <translation>{0} 不是 JSON 中的路径；例如请写 /sensor/temperature</translation>
    </message>
    <message>
        <source>A device does not let others write its table &quot;{0}&quot;; use &quot;coil&quot; or &quot;holding&quot;, or the direction &quot;in&quot;</source>
        <translation>设备不允许他人写入其表“{0}”；请使用“coil”或“holding”，或方向“in”</translation>
    </message>
    <message>
        <source>Clients cannot write the table &quot;{0}&quot; of a server; use &quot;coil&quot; or &quot;holding&quot;, or the direction &quot;out&quot;</source>
        <translation>客户端不能写入服务器的表“{0}”；请使用“coil”或“holding”，或方向“out”</translation>
    </message>
    <message>
        <source>{0} needs {1} {1:register|registers} from {2}, but 65535 is the last; choose a lower address</source>
        <translation>{0} 需要从 {2} 开始的 {1} 个寄存器，但 65535 是最后一个；请使用较小的地址</translation>
    </message>
    <message>
        <source>&quot;bit&quot; selects one bit of a register; the type must then be BOOL</source>
        <translation>“bit”选择寄存器的一位；此时类型必须是 BOOL</translation>
    </message>
    <message>
        <source>The table &quot;{0}&quot; holds bits; the type must be BOOL</source>
        <translation>表“{0}”保存位；类型必须是 BOOL</translation>
    </message>
    <message>
        <source>A BOOL in a register needs &quot;bit&quot;, from 0 to 15</source>
        <translation>寄存器中的 BOOL 需要“bit”，范围 0 到 15</translation>
    </message>
    <message>
        <source>Only an MQTT channel can be of type STRING; use a number or BOOL</source>
        <translation>只有 MQTT 通道可以是 STRING 类型；请使用数值或 BOOL</translation>
    </message>
    <message>
        <source>&quot;scale&quot; must not be 0; omit it for 1</source>
        <translation>“scale”不能为 0；若为 1 则可省略</translation>
    </message>
    <message>
        <source>A {0} has no &quot;scale&quot; and &quot;offset&quot;; remove them</source>
        <translation>{0} 没有“scale”和“offset”；请删除</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}：{1}</translation>
    </message>
    <message>
        <source>{0} has no variable yet; enter one, or have the addresses proposed (stepwise devices PROJECT --propose)</source>
        <translation>{0} 尚无变量；请指定一个，或让程序建议地址（stepwise devices PROJECT --propose）</translation>
    </message>
    <message>
        <source>{0} is of type {1} and cannot hold a {2}; use a variable of that type</source>
        <translation>{0} 的类型是 {1}，不能容纳 {2}；请使用该类型的变量</translation>
    </message>
    <message>
        <source>A {0} may not fit into {1} of type {2}; a value that does not fit leaves the variable as it is and makes the channel bad</source>
        <translation>{0} 可能放不进类型为 {2} 的 {1}；放不下的值不会改变变量，并将通道标为无效</translation>
    </message>
    <message>
        <source>{0} is an output of the program; an input channel needs %I or a variable</source>
        <translation>{0} 是程序的输出；输入通道需要 %I 或变量</translation>
    </message>
    <message>
        <source>{0} is an input of the program; an output channel needs %Q or a variable</source>
        <translation>{0} 是程序的输入；输出通道需要 %Q 或变量</translation>
    </message>
    <message>
        <source>{0} is a constant and cannot be written; choose a variable</source>
        <translation>{0} 是常量，不能写入；请选择变量</translation>
    </message>
    <message>
        <source>{0} reports the quality of the channel and must be a BOOL or an integer</source>
        <translation>{0} 表示通道是否有效，必须是 BOOL 或整数</translation>
    </message>
    <message>
        <source>{0} reports whether the device responds and must be a BOOL</source>
        <translation>{0} 表示设备是否应答，必须是 BOOL</translation>
    </message>
    <message>
        <source>&quot;onLoss&quot;: &quot;safe&quot; needs the value in &quot;safe&quot;</source>
        <translation>“onLoss”：“safe”需要在“safe”中给出值</translation>
    </message>
    <message>
        <source>{0} cannot be read; its first line must be the password</source>
        <translation>无法读取 {0}；其第一行必须是密码</translation>
    </message>
    <message>
        <source>{0} cannot be read; it must contain the certificates of the authority (PEM)</source>
        <translation>无法读取 {0}；其中必须包含证书颁发机构的证书 (PEM)</translation>
    </message>
    <message>
        <source>no response within {0} ms; check the cable, the address and the unit number</source>
        <translation>{0} ms 内没有应答；请检查电缆、地址和站号</translation>
    </message>
    <message>
        <source>the connection ended: {0}; it is being set up again</source>
        <translation>连接已断开：{0}；正在重新建立</translation>
    </message>
    <message>
        <source>the response does not match the request; check baud rate, parity and unit number</source>
        <translation>应答与请求不匹配；请检查波特率、奇偶校验和站号</translation>
    </message>
    <message>
        <source>the device rejects {0} {1}: {2}</source>
        <translation>设备拒绝 {0} {1}：{2}</translation>
    </message>
    <message>
        <source>it does not know the function; choose another table</source>
        <translation>它不支持该功能；请选择其他表</translation>
    </message>
    <message>
        <source>it has no such address; check the address in its manual</source>
        <translation>它没有该地址；请在其手册中核对地址</translation>
    </message>
    <message>
        <source>it does not accept the value; check the range in its manual</source>
        <translation>它不接受该值；请在其手册中核对范围</translation>
    </message>
    <message>
        <source>it reports a failure; check the device</source>
        <translation>它报告故障；请检查设备</translation>
    </message>
    <message>
        <source>it is busy; the request will be repeated</source>
        <translation>它正忙；将重复请求</translation>
    </message>
    <message>
        <source>the gateway cannot reach it; check the unit number and the cable after the gateway</source>
        <translation>网关无法访问它；请检查站号及网关之后的电缆</translation>
    </message>
    <message>
        <source>cannot listen on {0}: {1}; choose another address or port</source>
        <translation>无法监听 {0}：{1}；请选择其他地址或端口</translation>
    </message>
    <message>
        <source>{0}: the message holds no value that can be read; check what the device publishes</source>
        <translation>{0}：消息中没有可读取的值；请检查设备发布的内容</translation>
    </message>
    <message>
        <source>{0}: a value does not fit into the variable; use a larger type or a scale</source>
        <translation>{0}：有一个值放不进变量；请使用更大的类型或缩放</translation>
    </message>
    <message>
        <source>no client has written for {0} ms; check the client and its address</source>
        <translation>已有 {0} ms 没有客户端写入；请检查客户端及其地址</translation>
    </message>
    <message>
        <source>the broker rejects the connection: {0}; check the user and the password</source>
        <translation>代理拒绝连接：{0}；请检查用户和密码</translation>
    </message>
    <message>
        <source>the input {0} of the device {1} was lost; check the device and its cable</source>
        <translation>设备 {1} 的输入 {0} 已丢失；请检查设备及其电缆</translation>
    </message>
    <message>
        <source>the input {0} of the device {1} was lost: {2}</source>
        <translation>设备 {1} 的输入 {0} 已丢失：{2}</translation>
    </message>
    <message>
        <source>Start or build the project first; the devices are connected to its controller</source>
        <translation>请先启动或编译项目；设备连接到其控制器</translation>
    </message>
    <message>
        <source>The project had no devices when its controller was built; add them and build again</source>
        <translation>编译控制器时项目没有设备；请添加设备并重新编译</translation>
    </message>
    <message>
        <source>The devices had errors when the controller was built; correct them and build again</source>
        <translation>编译控制器时设备有错误；请更正并重新编译</translation>
    </message>
    <message>
        <source>Set the speed to real time first; devices cannot follow any other speed</source>
        <translation>请先将速度设为实时；设备跟不上其他速度</translation>
    </message>
    <message>
        <source>The devices of an attached controller are connected there; detach to connect them here</source>
        <translation>已连接的远程控制器的设备在其所在处连接；请先断开，再在此处连接</translation>
    </message>
    <message>
        <source>{0} and {1} write the same bytes: {2}; change an address</source>
        <translation>{0} 和 {1} 写入相同的字节：{2}；请更改其中一个地址</translation>
    </message>
    <message>
        <source>There is no free address left for {0}; give it a variable</source>
        <translation>没有可供 {0} 使用的空闲地址；请为其指定变量</translation>
    </message>
    <message>
        <source>{0} has no channels, so nothing is exchanged; add one</source>
        <translation>{0} 没有通道，因此不交换任何数据；请添加通道</translation>
    </message>
    <message>
        <source>cannot connect to {0}: {1}; check the address and the cable</source>
        <translation>无法连接到 {0}：{1}；请检查地址和电缆</translation>
    </message>
    <message>
        <source>{0} and {1} are both unit {2} of {3}; give one of them another number</source>
        <translation>{0} 和 {1} 在 {3} 上的站号都是 {2}；请为其中一个指定其他站号</translation>
    </message>
    <message>
        <source>{0} and {1} use {2} with different baud rates, parities or bits; set the same for both</source>
        <translation>{0} 和 {1} 使用 {2} 时的波特率、校验或位数不同；请将两者设为相同</translation>
    </message>
    <message>
        <source>{0} and {1} both set {2} {3}; give each its own</source>
        <translation>{0} 和 {1} 都设置 {2} {3}；请为每个指定各自的寄存器</translation>
    </message>
    <message>
        <source>{0} and {1} are both unit {2} at {3}; if one was copied from the other, change its address</source>
        <translation>{0} 和 {1} 在 {3} 上的站号都是 {2}；若其中一个是从另一个复制的，请更改其地址</translation>
    </message>
</context>
<context>
    <name>Diagnostics</name>
    <message>
        <source>Unterminated comment; close it with *)</source>
        <translation>注释未结束；请用 *) 结束</translation>
    </message>
    <message>
        <source>Unterminated string; add the closing quote</source>
        <translation>字符串未结束；请补上结束引号</translation>
    </message>
    <message>
        <source>Expected {0} before {1}</source>
        <translation>{1} 之前应为 {0}</translation>
    </message>
    <message>
        <source>A semicolon is missing here; add it</source>
        <translation>此处缺少分号；请添加</translation>
    </message>
    <message>
        <source>{0} is missing for this {1}; add it</source>
        <translation>此 {1} 缺少 {0}；请添加</translation>
    </message>
    <message>
        <source>This comparison has no effect; use := to assign</source>
        <translation>此比较不起作用；赋值请使用 :=</translation>
    </message>
    <message>
        <source>An assignment is not a condition; use = to compare</source>
        <translation>赋值不是条件；比较请使用 =</translation>
    </message>
    <message>
        <source>A colon is missing between the name and its type; add it</source>
        <translation>名称与类型之间缺少冒号；请添加</translation>
    </message>
    <message>
        <source>Decimal numbers use a point; write {0}</source>
        <translation>小数使用点号；请写 {0}</translation>
    </message>
    <message>
        <source>An open bound is written ARRAY[*] and is only allowed for VAR_IN_OUT; declare it there, or write a number</source>
        <translation>开放边界写作 ARRAY[*]，仅允许用于 VAR_IN_OUT；请在那里声明，或写一个数字</translation>
    </message>
    <message>
        <source>{0} is missing: the program unit ends here; add it</source>
        <translation>缺少 {0}：POU 在此处结束；请添加</translation>
    </message>
    <message>
        <source>A semicolon is missing: the statement ends here; add it</source>
        <translation>缺少分号：语句在此处结束；请添加</translation>
    </message>
    <message>
        <source>Implicit conversion from {0} to {1} may lose data; convert it explicitly</source>
        <translation>从 {0} 到 {1} 的隐式转换可能丢失数据；请显式转换</translation>
    </message>
    <message>
        <source>{0} is an IN_OUT parameter and needs a variable of type {1}</source>
        <translation>{0} 是 IN_OUT 参数，需要类型为 {1} 的变量</translation>
    </message>
    <message>
        <source>{0} has only the bits 0 to {1}; use one of them</source>
        <translation>{0} 只有位 0 到 {1}；请使用其中之一</translation>
    </message>
    <message>
        <source>{0} is ambiguous: {1}; write the namespace before it</source>
        <translation>{0} 不明确：{1}；请在前面写上命名空间</translation>
    </message>
    <message>
        <source>The character {0} is not in STRING ({1}); use WSTRING, or &quot;stringEncoding&quot;: &quot;UTF-8&quot; in project.json</source>
        <translation>STRING（{1}）中没有字符 {0}；请使用 WSTRING，或在 project.json 中写入 &quot;stringEncoding&quot;: &quot;UTF-8&quot;</translation>
    </message>
    <message>
        <source>{0} and {1} are compared as {2}; convert one of them</source>
        <translation>{0} 和 {1} 按 {2} 比较；请转换其中一个</translation>
    </message>
    <message>
        <source>{0} is not checked against the enumeration {1}; use one of its names</source>
        <translation>{0} 不会按枚举 {1} 检查；请使用其中的名称</translation>
    </message>
    <message>
        <source>{0} is {1}; write {2}</source>
        <translation>{0} 是{1}；请写 {2}</translation>
    </message>
    <message>
        <source>{0} contains itself; use a REFERENCE TO</source>
        <translation>{0} 包含自身；请使用 REFERENCE TO</translation>
    </message>
    <message>
        <source>The parameters of {0} must match those of the overridden method; copy its declarations</source>
        <translation>{0} 的参数必须与被重写的方法一致；请复制其声明</translation>
    </message>
    <message>
        <source>There are several programs and no CONFIGURATION; name one of them Main or write a CONFIGURATION</source>
        <translation>有多个程序但没有 CONFIGURATION；请将其中一个命名为 Main，或编写 CONFIGURATION</translation>
    </message>
    <message>
        <source>The range {0}..{1} is not valid: the lower bound is above the upper bound or there are too many elements; correct the bounds</source>
        <translation>范围 {0}..{1} 无效：下界大于上界，或元素过多；请更正边界</translation>
    </message>
    <message>
        <source>{0} has an incomplete address; complete it in a VAR_CONFIG</source>
        <translation>{0} 的地址不完整；请在 VAR_CONFIG 中补全</translation>
    </message>
    <message>
        <source>{0} may call itself; the depth of recursion is limited at run time; a loop is safer</source>
        <translation>{0} 可能调用自身；运行时会限制递归深度；使用循环更安全</translation>
    </message>
    <message>
        <source>The steps before this transition cannot be active together; start them from one simultaneous branch</source>
        <translation>此转换之前的步不能同时激活；请从同一个并行分支启动它们</translation>
    </message>
    <message>
        <source>This transition is always true; the step before it lasts one scan; write the condition to wait for</source>
        <translation>此转换始终为真；其前面的步只持续一个扫描周期；请写入要等待的条件</translation>
    </message>
    <message>
        <source>The qualifier {0} needs a time, for example T#2s</source>
        <translation>限定符 {0} 需要时间，例如 T#2s</translation>
    </message>
    <message>
        <source>{0} needs a current result; load one with LD</source>
        <translation>{0} 需要当前结果；请用 LD 装载</translation>
    </message>
    <message>
        <source>{0} is not a value of the strict enumeration {1}; use one of its names</source>
        <translation>{0} 不是严格枚举 {1} 的值；请使用其中的名称</translation>
    </message>
    <message>
        <source>{0} is a strict enumeration and cannot be used in arithmetic; convert the value with {1}</source>
        <translation>{0} 是严格枚举，不能用于算术运算；请使用 {1} 转换该值</translation>
    </message>
    <message>
        <source>{0} cannot compare {1} as a whole; compare the members one by one</source>
        <translation>{0} 不能整体比较 {1}；请逐个比较成员</translation>
    </message>
    <message>
        <source>A CASE selector must be an integer, enumeration or character, not {0}; use IF and ELSIF</source>
        <translation>CASE 的选择值必须是整数、枚举或字符，而不是 {0}；请使用 IF 和 ELSIF</translation>
    </message>
    <message>
        <source>{0} and {1} share storage at {2}; move one of them or write STRUCT OVERLAP</source>
        <translation>{0} 和 {1} 在 {2} 处共用存储区；请移动其中一个，或写 STRUCT OVERLAP</translation>
    </message>
    <message>
        <source>A member&apos;s address is relative to the start of its structure (%B4, %X4.1), not {0}</source>
        <translation>成员地址相对于其结构的起始位置（%B4、%X4.1），而不是 {0}</translation>
    </message>
    <message>
        <source>{0} and {1} share the address {2}; {3} is free</source>
        <translation>{0} 和 {1} 共用地址 {2}；{3} 空闲</translation>
    </message>
    <message>
        <source>{0} belongs to the chart and must be {1}</source>
        <translation>{0} 属于顺序功能图，必须是 {1}</translation>
    </message>
    <message>
        <source>{0} has no effect without {1}; declare both</source>
        <translation>没有 {1} 时 {0} 不起作用；请同时声明两者</translation>
    </message>
    <message>
        <source>A step lists its actions here; write statements in an ACTION</source>
        <translation>步在此处列出其动作；请将语句写入 ACTION</translation>
    </message>
    <message>
        <source>No transition leads away from step {0}; the chart ends here; add a TRANSITION if it should go on</source>
        <translation>没有转换从步 {0} 离开；顺序功能图在此处结束；若应继续，请添加 TRANSITION</translation>
    </message>
    <message>
        <source>{0} is also a variable; steps and calls mean the ACTION; rename one of the two</source>
        <translation>{0} 也是变量；步和调用指的是 ACTION；请重命名其中之一</translation>
    </message>
    <message>
        <source>Use {1} instead of {0} in Structured Text</source>
        <translation>在结构化文本中请使用 {1} 代替 {0}</translation>
    </message>
    <message>
        <source>The task {0} has no INTERVAL above zero and no SINGLE; it runs in every scan; give it an INTERVAL to slow it down</source>
        <translation>任务 {0} 没有大于零的 INTERVAL，也没有 SINGLE；它在每个扫描周期运行；如需限速，请设置 INTERVAL</translation>
    </message>
    <message>
        <source>{0} is read as {1}; write a time with its unit</source>
        <translation>{0} 按 {1} 读取；请写带单位的时间</translation>
    </message>
    <message>
        <source>The address {0} has {1} {1:bit|bits}, {2} has {3}; write {4}</source>
        <translation>地址 {0} 有 {1} 位，{2} 有 {3} 位；请写 {4}</translation>
    </message>
    <message>
        <source>{0} is an input declared CONSTANT and is assigned to here; remove CONSTANT or assign to another variable</source>
        <translation>{0} 是声明为 CONSTANT 的输入，但在此处被赋值；请去掉 CONSTANT 或对其他变量赋值</translation>
    </message>
    <message>
        <source>{0}</source>
        <translation>{0}</translation>
    </message>
    <message>
        <source>The condition {0} is not known; combine defined, hasvalue, hasattribute and hastype with NOT, AND and OR</source>
        <translation>条件 {0} 未知；请用 NOT、AND 和 OR 组合 defined、hasvalue、hasattribute 和 hastype</translation>
    </message>
    <message>
        <source>The pragma {0} is missing for this {1}; add it</source>
        <translation>此 {1} 缺少编译指示 {0}；请添加</translation>
    </message>
    <message>
        <source>The character {0} has no meaning here; remove it</source>
        <translation>字符 {0} 在此处没有意义；请删除</translation>
    </message>
    <message>
        <source>This is nested too deeply to be compiled; split it into several statements or units</source>
        <translation>嵌套过深，无法编译；请拆分为多条语句或多个 POU</translation>
    </message>
    <message>
        <source>Code in C is not executed; write it in ST</source>
        <translation>C 代码不会执行；请用 ST 编写</translation>
    </message>
    <message>
        <source>{0} is specified twice; remove one of the two</source>
        <translation>{0} 指定了两次；请删除其中一个</translation>
    </message>
    <message>
        <source>{0} is not an array or string; remove the index or declare it as an ARRAY</source>
        <translation>{0} 不是数组或字符串；请删除下标或声明为 ARRAY</translation>
    </message>
    <message>
        <source>The divisor is always zero; divide by another value</source>
        <translation>除数始终为零；请除以其他值</translation>
    </message>
    <message>
        <source>A constant is needed here; write a value or the name of a VAR CONSTANT</source>
        <translation>此处需要常量；请写一个值或 VAR CONSTANT 的名称</translation>
    </message>
    <message>
        <source>{0} is not a pointer or reference; use it without ^ or declare it with REF_TO</source>
        <translation>{0} 不是指针或引用；请不带 ^ 使用，或用 REF_TO 声明</translation>
    </message>
    <message>
        <source>{0} does not return a value; call it in a statement of its own</source>
        <translation>{0} 不返回值；请在单独的语句中调用</translation>
    </message>
    <message>
        <source>{0} is abstract and cannot be instantiated; use a block that extends it</source>
        <translation>{0} 是抽象的，不能实例化；请使用扩展它的功能块</translation>
    </message>
    <message>
        <source>{0} is {1} and cannot be used here; make it PUBLIC or use it inside its block</source>
        <translation>{0} 是 {1}，不能在此处使用；请声明为 PUBLIC 或在其功能块内使用</translation>
    </message>
    <message>
        <source>The result of {0} is not used; assign it to a variable</source>
        <translation>{0} 的结果未使用；请赋给变量</translation>
    </message>
    <message>
        <source>{0} is declared twice; rename or remove one of the two</source>
        <translation>{0} 声明了两次；请重命名或删除其中一个</translation>
    </message>
    <message>
        <source>There is no type {0}; declare it or add the library that contains it</source>
        <translation>没有类型 {0}；请声明它，或添加包含它的库</translation>
    </message>
    <message>
        <source>{0} is never used; remove its declaration</source>
        <translation>{0} 从未使用；请删除其声明</translation>
    </message>
    <message>
        <source>{0} is read but never written; give it a value or declare it as CONSTANT</source>
        <translation>{0} 被读取，但从未写入；请赋值或声明为 CONSTANT</translation>
    </message>
    <message>
        <source>This is never executed; remove it or change what is before it</source>
        <translation>此处永远不会执行；请删除，或修改其前面的语句</translation>
    </message>
    <message>
        <source>The result of {0} is not set on every path; assign it before the first RETURN or IF</source>
        <translation>{0} 的结果未在所有路径上赋值；请在第一个 RETURN 或 IF 之前赋值</translation>
    </message>
    <message>
        <source>CASE has no branch for {0} and no ELSE; add one of them</source>
        <translation>CASE 没有 {0} 的分支，也没有 ELSE；请添加其中之一</translation>
    </message>
    <message>
        <source>{0} already has a branch; remove one of the two</source>
        <translation>{0} 已有分支；请删除其中一个</translation>
    </message>
    <message>
        <source>The task {0} is declared twice; rename one of the two</source>
        <translation>任务 {0} 声明了两次；请重命名其中一个</translation>
    </message>
    <message>
        <source>There is no task {0}; declare it with TASK in this configuration</source>
        <translation>没有任务 {0}；请在此配置中用 TASK 声明</translation>
    </message>
    <message>
        <source>{0} does not implement {1} of {2}; add it</source>
        <translation>{0} 未实现 {2} 的 {1}；请添加</translation>
    </message>
    <message>
        <source>{0} is FINAL and cannot be extended or overridden; remove FINAL or use another base</source>
        <translation>{0} 是 FINAL，不能扩展或重写；请删除 FINAL 或使用其他基类</translation>
    </message>
    <message>
        <source>There is no label {0}; write it with a colon before a statement of this unit</source>
        <translation>没有标号 {0}；请在此 POU 的一条语句前写上标号和冒号</translation>
    </message>
    <message>
        <source>The variables need {0} bytes; the maximum is {1}: make arrays or strings smaller</source>
        <translation>变量需要 {0} 字节；最大为 {1}：请减小数组或字符串</translation>
    </message>
    <message>
        <source>There is no PROGRAM to run; add one</source>
        <translation>没有可运行的 PROGRAM；请添加一个</translation>
    </message>
    <message>
        <source>There is no namespace {0}; declare it or add the library that contains it</source>
        <translation>没有命名空间 {0}；请声明它，或添加包含它的库</translation>
    </message>
    <message>
        <source>{0} is not a variable of this configuration; write program instance and variable, as in Main.x</source>
        <translation>{0} 不是此配置的变量；请写程序实例和变量，例如 Main.x</translation>
    </message>
    <message>
        <source>{0} restarts on every call because functions keep no state; use a FUNCTION_BLOCK</source>
        <translation>{0} 在每次调用时重新开始，因为函数不保存状态；请使用 FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>Too many initial values: {0} for {1} {1:element|elements}; remove some or enlarge the array</source>
        <translation>初始值过多：{1} 个元素有 {0} 个初始值；请删除一些或增大数组</translation>
    </message>
    <message>
        <source>This loop never ends and would stop the controller; give it a condition or an EXIT</source>
        <translation>此循环永不结束，会使控制器停住；请添加条件或 EXIT</translation>
    </message>
    <message>
        <source>{0} is marked OVERRIDE, but no base has a method with this name; remove OVERRIDE or correct the name</source>
        <translation>{0} 标有 OVERRIDE，但基类中没有同名方法；请删除 OVERRIDE 或更正名称</translation>
    </message>
    <message>
        <source>The chart has no INITIAL_STEP; declare its first step with INITIAL_STEP instead of STEP</source>
        <translation>顺序功能图没有 INITIAL_STEP；请用 INITIAL_STEP 代替 STEP 声明第一步</translation>
    </message>
    <message>
        <source>The chart has two initial steps: {0} and {1}; declare one of them with STEP</source>
        <translation>顺序功能图有两个初始步：{0} 和 {1}；请将其中一个声明为 STEP</translation>
    </message>
    <message>
        <source>There is no step {0}; declare it or correct the name</source>
        <translation>没有步 {0}；请声明它或更正名称</translation>
    </message>
    <message>
        <source>No transition leads to step {0}; it can never become active: add a TRANSITION to it</source>
        <translation>没有转换通向步 {0}；它永远不会激活：请添加通向它的 TRANSITION</translation>
    </message>
    <message>
        <source>There is no action or BOOL variable {0}; add an ACTION or declare the variable</source>
        <translation>没有名为 {0} 的动作或 BOOL 变量；请添加 ACTION 或声明变量</translation>
    </message>
    <message>
        <source>The step {0} is declared twice; rename or remove one of the two</source>
        <translation>步 {0} 声明了两次；请重命名或删除其中一个</translation>
    </message>
    <message>
        <source>{0} appears twice in this step with qualifier {1}; remove one of the two</source>
        <translation>{0} 在此步中以限定符 {1} 出现了两次；请删除其中一个</translation>
    </message>
    <message>
        <source>The parenthesis of this instruction is not closed; add an instruction ) after its operands</source>
        <translation>此指令的括号未闭合；请在其操作数之后添加一条 ) 指令</translation>
    </message>
    <message>
        <source>{0} needs memory that the project does not set aside; write &quot;memoryForNew&quot;: 65536 into project.json</source>
        <translation>{0} 需要项目未预留的内存；请在 project.json 中写入 &quot;memoryForNew&quot;: 65536</translation>
    </message>
    <message>
        <source>{0} is not a block of this program and cannot have a task of its own; name one of its blocks</source>
        <translation>{0} 不是此程序的功能块，不能有自己的任务；请指定其中一个功能块</translation>
    </message>
    <message>
        <source>{0} cannot hold an exception code; declare it as __SYSTEM.ExceptionCode</source>
        <translation>{0} 不能容纳异常代码；请声明为 __SYSTEM.ExceptionCode</translation>
    </message>
    <message>
        <source>{0} converts the number, as in CODESYS; to keep the bits, put both types into a UNION</source>
        <translation>{0} 与 CODESYS 一样转换数值；若要保留各位，请将两种类型放入 UNION</translation>
    </message>
    <message>
        <source>{0} calls itself, which is not allowed: {1}; use a loop instead</source>
        <translation>{0} 调用自身，这是不允许的：{1}；请改为使用循环</translation>
    </message>
    <message>
        <source>The loop variable {0} is changed inside its loop; use WHILE or another variable</source>
        <translation>循环变量 {0} 在其循环内被修改；请使用 WHILE 或其他变量</translation>
    </message>
    <message>
        <source>There is no global variable {0} of type {1}; declare it in VAR_GLOBAL</source>
        <translation>没有类型为 {1} 的全局变量 {0}；请在 VAR_GLOBAL 中声明</translation>
    </message>
    <message>
        <source>The text has {0} and will be truncated to {1}; declare a longer string</source>
        <translation>文本有 {0}，将被截断为 {1} 个；请声明更长的字符串</translation>
    </message>
    <message>
        <source>This integer division discards the fraction before the conversion to {0}; convert an operand first</source>
        <translation>此整数除法在转换为 {0} 之前会舍去小数部分；请先转换一个操作数</translation>
    </message>
    <message>
        <source>{0} is computed as {1} and may overflow before the conversion to {2}; convert an operand first</source>
        <translation>{0} 按 {1} 计算，在转换为 {2} 之前可能溢出；请先转换一个操作数</translation>
    </message>
    <message>
        <source>{0} is not an IL operator; use one such as LD, ST, AND or JMP</source>
        <translation>{0} 不是 IL 操作符；请使用 LD、ST、AND 或 JMP 等操作符</translation>
    </message>
    <message>
        <source>This array has {0} {0:dimension|dimensions}, not {1}; write an index for each</source>
        <translation>此数组有 {0} 维，而不是 {1} 维；请为每一维写一个下标</translation>
    </message>
    <message>
        <source>{0} is not a valid {1} literal; check its prefix, digits and units</source>
        <translation>{0} 不是有效的字面量（{1}）；请检查前缀、数字和单位</translation>
    </message>
    <message>
        <source>Unexpected {0}; remove it or complete the statement before it</source>
        <translation>意外的 {0}；请将其删除或补全前面的语句</translation>
    </message>
    <message>
        <source>The pragma {0} is not known and has no effect; remove it or correct its name</source>
        <translation>编译指示 {0} 未知，不起作用；请将其删除或更正名称</translation>
    </message>
    <message>
        <source>{0} is a keyword and cannot be used as a name; choose another name</source>
        <translation>{0} 是关键字，不能用作名称；请使用其他名称</translation>
    </message>
    <message>
        <source>{0} is not declared; declare it or correct the name</source>
        <translation>{0} 未声明；请声明或更正名称</translation>
    </message>
    <message>
        <source>{0} has no member {1}; correct the name or add the member</source>
        <translation>{0} 没有成员 {1}；请更正名称或添加该成员</translation>
    </message>
    <message>
        <source>{0} cannot be converted to {1}; use a value of that type or a conversion function</source>
        <translation>{0} 无法转换为 {1}；请使用该类型的值或转换函数</translation>
    </message>
    <message>
        <source>{0} cannot be assigned to; assign to a variable</source>
        <translation>无法对 {0} 赋值；请对变量赋值</translation>
    </message>
    <message>
        <source>{0} cannot be used with {1}; convert the operand first</source>
        <translation>{0} 不能与 {1} 一起使用；请先转换操作数</translation>
    </message>
    <message>
        <source>{0} cannot combine {1} and {2}; convert one of them</source>
        <translation>{0} 不能组合 {1} 和 {2}；请转换其中之一</translation>
    </message>
    <message>
        <source>{0} cannot be called; call a function, a method or an instance of a block</source>
        <translation>{0} 不可调用；请调用函数、方法或功能块实例</translation>
    </message>
    <message>
        <source>{0} has no parameter {1}; correct the name or declare the parameter</source>
        <translation>{0} 没有参数 {1}；请更正名称或声明该参数</translation>
    </message>
    <message>
        <source>The argument for {1} of {0} is missing; add it to the call</source>
        <translation>缺少 {0} 的实参 {1}；请在调用中添加</translation>
    </message>
    <message>
        <source>{0} takes {1} {1:argument|arguments}; remove the others</source>
        <translation>{0} 需要 {1} 个实参；请删除多余的实参</translation>
    </message>
    <message>
        <source>The index {0} is outside {1}..{2}; correct it or enlarge the array</source>
        <translation>下标 {0} 超出 {1}..{2}；请更正下标或增大数组</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}; use another value or a larger type</source>
        <translation>{0} 超出 {1} 的范围；请使用其他值或更大的类型</translation>
    </message>
    <message>
        <source>The condition must be BOOL, not {0}; add a comparison</source>
        <translation>条件必须是 BOOL，而不是 {0}；请添加比较</translation>
    </message>
    <message>
        <source>The address {0} is outside {1}; use an address in that range</source>
        <translation>地址 {0} 超出 {1}；请使用该范围内的地址</translation>
    </message>
    <message>
        <source>{0} is not allowed in a watch or binding, which cannot have side effects; do it in the program</source>
        <translation>监视和变量绑定不能有副作用，因此不允许使用 {0}；请在程序中执行</translation>
    </message>
    <message>
        <source>A reference needs a variable that has an address; assign the value to a variable first</source>
        <translation>引用需要具有地址的变量；请先将值赋给变量</translation>
    </message>
    <message>
        <source>An index must be an integer, not {0}; convert it</source>
        <translation>下标必须是整数，而不是 {0}；请先转换</translation>
    </message>
    <message>
        <source>{1} cannot extend {0}; choose a base of the same kind</source>
        <translation>{1} 不能扩展 {0}；请选择同类的基类型</translation>
    </message>
    <message>
        <source>{0} is not allowed {1}; move or remove it</source>
        <translation>{1}不允许使用 {0}；请移动或删除</translation>
    </message>
    <message>
        <source>{0} is only allowed inside a loop; move or remove it</source>
        <translation>{0} 只能在循环内使用；请移动或删除</translation>
    </message>
    <message>
        <source>Step {0} can become active twice at the same time: the branches from here do not join; join them with one transition</source>
        <translation>步 {0} 可能同时被激活两次：从这里出发的分支没有汇合；请用一个转换将其汇合</translation>
    </message>
    <message>
        <source>{0} is only allowed in a TEST; move it there</source>
        <translation>{0} 只能在 TEST 中使用；请将其移到测试中</translation>
    </message>
    <message>
        <source>This is not text in UTF-8; save the file as UTF-8, or remove it from the project if it is not a text file</source>
        <translation>不是 UTF-8 文本；请将文件保存为 UTF-8，若不是文本文件，请从项目中移除</translation>
    </message>
    <message>
        <source>{0} is not an action qualifier; use N, R, S, L, D, P, P0, P1, SD, DS or SL</source>
        <translation>{0} 不是动作限定符；请使用 N、R、S、L、D、P、P0、P1、SD、DS 或 SL</translation>
    </message>
    <message>
        <source>{0} needs a time after :=, for example T#5s; write one or remove the pragma</source>
        <translation>{0} 在 := 之后需要时间，例如 T#5s；请写入时间或删除此编译指示</translation>
    </message>
</context>
<context>
    <name>DiskChange</name>
    <message>
        <source>Changed outside</source>
        <translation>在外部被更改</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and here too.</source>
        <translation>%1 已被其他程序更改，此处也有更改。</translation>
    </message>
    <message>
        <source>Compare both side by side, load the file from disk and lose the changes made here, or keep what is here and replace the file with the next save?</source>
        <translation>并排比较两者，从磁盘加载文件并放弃此处的更改，还是保留此处的内容并在下次保存时替换文件？</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>比较…</translation>
    </message>
    <message>
        <source>Load from Disk</source>
        <translation>从磁盘加载</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>保留我的版本</translation>
    </message>
</context>
<context>
    <name>EditHistory</name>
    <message>
        <source>&amp;Undo</source>
        <translation>撤消(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>division by zero; check the divisor first</source>
        <translation>除以零；请先检查除数</translation>
    </message>
    <message>
        <source>index {0} is used on an empty array; check its bounds first</source>
        <translation>访问了空数组的下标 {0}；请先检查其边界</translation>
    </message>
    <message>
        <source>index {0} is outside {1}..{2}; use an index in this range or enlarge the array</source>
        <translation>下标 {0} 超出 {1}..{2}；请使用此范围内的下标，或增大数组</translation>
    </message>
    <message>
        <source>character {0} is read from an empty string; check LEN first</source>
        <translation>读取了空字符串的第 {0} 个字符；请先检查 LEN</translation>
    </message>
    <message>
        <source>character {0} is outside {1}..{2} of the string; use an index in this range</source>
        <translation>第 {0} 个字符超出字符串的 {1}..{2}；请使用此范围内的下标</translation>
    </message>
    <message>
        <source>calls are nested too deeply; check for endless recursion</source>
        <translation>调用嵌套过深；请检查是否有无限递归</translation>
    </message>
    <message>
        <source>the called method has no body; override it in the block that is called</source>
        <translation>被调用的方法没有主体；请在被调用的块中重写该方法</translation>
    </message>
    <message>
        <source>the scan was aborted</source>
        <translation>扫描已中止</translation>
    </message>
    <message>
        <source>there is no expression; enter one</source>
        <translation>没有表达式；请输入一个</translation>
    </message>
    <message>
        <source>the program of this scan does not have it; choose a later scan</source>
        <translation>此扫描周期的程序中没有它；请选择更晚的扫描周期</translation>
    </message>
    <message>
        <source>has no value here</source>
        <translation>在此处没有值</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}：{1}</translation>
    </message>
    <message>
        <source>simulation: {0}</source>
        <translation>仿真：{0}</translation>
    </message>
    <message>
        <source>warm</source>
        <translation>热复位</translation>
    </message>
    <message>
        <source>cold</source>
        <translation>冷复位</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>原始复位</translation>
    </message>
    <message>
        <source>in the middle of a scan</source>
        <translation>扫描周期中途</translation>
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
        <translation>没有这样的文件或文件夹；请检查路径</translation>
    </message>
    <message>
        <source>permission denied; check the permissions of the file and its folder</source>
        <translation>权限不足；请检查文件及其文件夹的权限</translation>
    </message>
    <message>
        <source>no space left on the device; free some space and try again</source>
        <translation>设备上没有剩余空间；请释放空间后重试</translation>
    </message>
    <message>
        <source>it is a folder; choose a file</source>
        <translation>这是文件夹；请选择文件</translation>
    </message>
    <message>
        <source>it is not a folder; choose a folder</source>
        <translation>这不是文件夹；请选择文件夹</translation>
    </message>
    <message>
        <source>the device reports a read or write error; check the drive or the cable</source>
        <translation>设备报告读写错误；请检查驱动器或电缆</translation>
    </message>
    <message>
        <source>it already exists; choose another name</source>
        <translation>已存在；请使用其他名称</translation>
    </message>
    <message>
        <source>the file is too large; choose a smaller one</source>
        <translation>文件过大；请选择较小的文件</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>This is not a regular file and cannot be replaced; choose another name</source>
        <translation>这不是普通文件，不能替换；请选择其他名称</translation>
    </message>
    <message>
        <source>The recording cannot be written: {0}</source>
        <translation>无法写入记录：{0}</translation>
    </message>
    <message>
        <source>The recording cannot be read: {0}</source>
        <translation>无法读取记录：{0}</translation>
    </message>
    <message>
        <source>This version of Stepwise lays out the program&apos;s variables differently; open the recording with the version that made it</source>
        <translation>此版本的 Stepwise 对程序变量的布局不同；请用创建该记录的版本打开</translation>
    </message>
    <message>
        <source>The recording cannot be opened: {0}</source>
        <translation>无法打开记录：{0}</translation>
    </message>
    <message>
        <source>its program has errors; open the recording with the version of Stepwise that made it</source>
        <translation>其程序有错误；请用创建该记录的 Stepwise 版本打开</translation>
    </message>
    <message>
        <source>The recording contains no program; record the run again with this version</source>
        <translation>记录中没有程序；请用此版本重新记录运行</translation>
    </message>
    <message>
        <source>This scan is no longer in the recording; choose a later one</source>
        <translation>此扫描周期已不在记录中；请选择较晚的周期</translation>
    </message>
    <message>
        <source>The program that recorded this scan is no longer available; choose a scan after the last change of the program</source>
        <translation>记录此扫描周期的程序已不可用；请选择最后一次修改程序之后的扫描周期</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is ambiguous; write one of {1}</source>
        <translation>“{0}”不明确；请写 {1} 之一</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; has no variable &apos;{1}&apos;; did you mean &apos;{2}&apos;?</source>
        <translation>“{0}”没有变量“{1}”；是否指“{2}”？</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; has no variable &apos;{1}&apos;; check the name</source>
        <translation>“{0}”没有变量“{1}”；请检查名称</translation>
    </message>
    <message>
        <source>there is no variable &apos;{0}&apos;; did you mean &apos;{1}&apos;?</source>
        <translation>没有变量“{0}”；是否指“{1}”？</translation>
    </message>
    <message>
        <source>there is no variable &apos;{0}&apos;; check the name or declare it</source>
        <translation>没有变量“{0}”；请检查名称或声明该变量</translation>
    </message>
    <message>
        <source>a variable of type {1} has no member &apos;{0}&apos;; check the name</source>
        <translation>类型 {1} 的变量没有成员“{0}”；请检查名称</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is a VAR_IN_OUT; write the variable that is connected to it</source>
        <translation>“{0}”是 VAR_IN_OUT；请写与其连接的变量</translation>
    </message>
    <message>
        <source>{0} needs {1} {1:index|indices}, not {2}; write one for each dimension</source>
        <translation>{0} 需要 {1} 个下标，而不是 {2} 个；请为每一维写一个下标</translation>
    </message>
    <message>
        <source>bit {0} is outside 0..{1}; use a bit in this range</source>
        <translation>位 {0} 超出 0..{1}；请使用此范围内的位</translation>
    </message>
    <message>
        <source>part {0} is outside 0..{1}; use a part in this range</source>
        <translation>部分 {0} 超出 0..{1}；请使用此范围内的部分</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is not an address; write for example %IX0.0, %QB4 or %MW2</source>
        <translation>“{0}”不是地址；例如请写 %IX0.0、%QB4 或 %MW2</translation>
    </message>
    <message>
        <source>the path cannot be read from &apos;{0}&apos; on; write for example Main.a[2].x</source>
        <translation>从“{0}”起无法读取路径；请写成例如 Main.a[2].x</translation>
    </message>
    <message>
        <source>{0} is forced; release the force before writing</source>
        <translation>{0} 已被强制；写入前请取消强制</translation>
    </message>
    <message>
        <source>the variable is not forced; there is nothing to release</source>
        <translation>变量未被强制；没有可解除的强制</translation>
    </message>
    <message>
        <source>the initial values of the new program cause a fault: {0}</source>
        <translation>新程序的初始值引发错误：{0}</translation>
    </message>
    <message>
        <source>The retain file cannot be written: {0}</source>
        <translation>无法写入保持值文件：{0}</translation>
    </message>
    <message>
        <source>The retain file cannot be read: {0}; the program starts with its initial values</source>
        <translation>无法读取保持值文件：{0}；程序以初始值启动</translation>
    </message>
    <message>
        <source>The retain file is damaged; the program starts with its initial values</source>
        <translation>保持值文件已损坏；程序以初始值启动</translation>
    </message>
    <message>
        <source>{0}; it is kept as {1}</source>
        <translation>{0}；已另存为 {1}</translation>
    </message>
    <message>
        <source>{0} retained {0:value does|values do} not fit the program: {1}; they start with their initial values</source>
        <translation>{0} 个保持值与程序不符：{1}；它们以初始值启动</translation>
    </message>
    <message>
        <source>{0} does not fit into a variable of type {1}; enter a value in its range</source>
        <translation>{0} 超出类型 {1} 的变量范围；请输入其范围内的值</translation>
    </message>
    <message>
        <source>the value does not fit into a variable of type {0}; enter one in its range</source>
        <translation>值超出类型 {0} 的变量范围；请输入其范围内的值</translation>
    </message>
    <message>
        <source>{0} is outside {1}..{2}; enter a value in this range</source>
        <translation>{0} 超出 {1}..{2}；请输入此范围内的值</translation>
    </message>
    <message>
        <source>a character of the text does not fit into a STRING; use a WSTRING</source>
        <translation>文本中有 STRING 不支持的字符；请使用 WSTRING</translation>
    </message>
    <message>
        <source>a reference can only be set to NULL from outside; assign a variable to it in the program</source>
        <translation>从外部只能将引用设为 NULL；请在程序中为其指定变量</translation>
    </message>
    <message>
        <source>{0} is not a value for {1}, which is {2}</source>
        <translation>{0} 不是 {1}（类型 {2}）的值</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}, which is {2}</source>
        <translation>{0} 超出 {1}（类型 {2}）的范围</translation>
    </message>
    <message>
        <source>{0}; {1}</source>
        <translation>{0}；{1}</translation>
    </message>
    <message>
        <source>did you mean {0}?</source>
        <translation>是否指 {0}？</translation>
    </message>
    <message>
        <source>its values are {0}</source>
        <translation>可用的值为 {0}</translation>
    </message>
    <message>
        <source>write it in quotes, for example {0}; only WSTRING has every character</source>
        <translation>请写在引号内，例如 {0}；只有 WSTRING 包含所有字符</translation>
    </message>
    <message>
        <source>write it in quotes, for example {0}</source>
        <translation>请写在引号内，例如 {0}</translation>
    </message>
    <message>
        <source>write one character in quotes, for example {0}</source>
        <translation>请在引号内写一个字符，例如 {0}</translation>
    </message>
    <message>
        <source>write all elements, for example {0}, or a single one by its index</source>
        <translation>请写出全部元素，例如 {0}，或用下标写单个元素</translation>
    </message>
    <message>
        <source>write its members, for example {0}, or a single one by its path</source>
        <translation>请写出其成员，例如 {0}，或用路径写单个成员</translation>
    </message>
    <message>
        <source>write {0} or {1}</source>
        <translation>请写 {0} 或 {1}</translation>
    </message>
    <message>
        <source>write for example {0}</source>
        <translation>例如请写 {0}</translation>
    </message>
    <message>
        <source>write a number, for example {0}</source>
        <translation>请写数字，例如 {0}</translation>
    </message>
    <message>
        <source>write an integer, for example {0}</source>
        <translation>请写整数，例如 {0}</translation>
    </message>
    <message>
        <source>There is no program to optimise; declare a PROGRAM</source>
        <translation>没有可优化的程序；请声明 PROGRAM</translation>
    </message>
    <message>
        <source>this is local to a running call and has no address of its own; pause in the call to see it</source>
        <translation>这是正在执行的调用中的局部量，没有自己的地址；请在该调用中暂停以查看</translation>
    </message>
    <message>
        <source>this part of a computed value cannot be shown; assign the value to a variable first</source>
        <translation>计算值的这一部分无法显示；请先将该值赋给变量</translation>
    </message>
    <message>
        <source>a character of a string has no address of its own; use the whole string</source>
        <translation>字符串中的字符没有自己的地址；请使用整个字符串</translation>
    </message>
    <message>
        <source>this variable cannot be shown; assign it to another variable and watch that one</source>
        <translation>此变量无法显示；请将其赋给另一个变量并监视该变量</translation>
    </message>
    <message>
        <source>this array of variable length has no address here; watch the array that is passed to it</source>
        <translation>此长度可变的数组在此处没有地址；请监视传递给它的数组</translation>
    </message>
    <message>
        <source>the array has no such dimension; count them from 1</source>
        <translation>数组没有此维；维数从 1 开始计</translation>
    </message>
    <message>
        <source>this has no value</source>
        <translation>这没有值</translation>
    </message>
    <message>
        <source>only standard functions can be called here; use a function of the library</source>
        <translation>此处只能调用标准函数；请使用库中的函数</translation>
    </message>
    <message>
        <source>a cast to an interface cannot be watched; watch the instance itself</source>
        <translation>转换为接口的表达式不能监视；请监视实例本身</translation>
    </message>
    <message>
        <source>this cannot be evaluated; use variables, operators and standard functions</source>
        <translation>无法求值；请使用变量、运算符和标准函数</translation>
    </message>
    <message>
        <source>The code generator failed, which is an error of Stepwise: {0}; report it with the program</source>
        <translation>代码生成器失败，这是 Stepwise 的错误：{0}；请连同程序一起报告</translation>
    </message>
    <message>
        <source>The code generator produced an invalid module, which is an error of Stepwise: {0}; report it with the program</source>
        <translation>代码生成器产生了无效模块，这是 Stepwise 的错误：{0}；请连同程序一起报告</translation>
    </message>
    <message>
        <source>not compiled</source>
        <translation>未编译</translation>
    </message>
    <message>
        <source>Code for the thread sanitizer needs a process that runs under it</source>
        <translation>用于线程检查器的代码需要在其下运行的进程</translation>
    </message>
    <message>
        <source>the program could not be optimised: {0}</source>
        <translation>程序无法优化：{0}</translation>
    </message>
    <message>
        <source>the program has errors; correct them first</source>
        <translation>程序有错误；请先更正</translation>
    </message>
    <message>
        <source>the online change waits until the scan that is halted at a breakpoint has ended; press F5 to continue</source>
        <translation>在线修改等待停在断点处的扫描周期结束；按 F5 继续</translation>
    </message>
    <message>
        <source>This body is not an instruction list; choose a unit that is written in IL</source>
        <translation>此主体不是指令表；请选择用 IL 编写的 POU</translation>
    </message>
    <message>
        <source>This body is not ST; choose a unit that is written in ST</source>
        <translation>此主体不是 ST；请选择用 ST 编写的 POU</translation>
    </message>
    <message>
        <source>{0} has no equivalent in an instruction list; write it with simpler statements first</source>
        <translation>{0} 在指令表中没有对应形式；请先用更简单的语句编写</translation>
    </message>
    <message>
        <source>{0} is already written in ST</source>
        <translation>{0} 已用 ST 编写</translation>
    </message>
    <message>
        <source>{0} is already written in IL</source>
        <translation>{0} 已用 IL 编写</translation>
    </message>
    <message>
        <source>Fix the text first: {0}</source>
        <translation>请先修正文本：{0}</translation>
    </message>
    <message>
        <source>There is no equivalent in the other language: {0}</source>
        <translation>在另一种语言中没有对应形式：{0}</translation>
    </message>
    <message>
        <source>This is a folder; choose a file</source>
        <translation>这是文件夹；请选择文件</translation>
    </message>
    <message>
        <source>This is a device; choose a file</source>
        <translation>这是设备；请选择文件</translation>
    </message>
    <message>
        <source>The file cannot be read: {0}</source>
        <translation>无法读取文件：{0}</translation>
    </message>
    <message>
        <source>The file cannot be replaced: {0}</source>
        <translation>无法替换文件：{0}</translation>
    </message>
    <message>
        <source>The file cannot be written: {0}</source>
        <translation>无法写入文件：{0}</translation>
    </message>
    <message>
        <source>project.json is not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>project.json 不是有效的 JSON；请检查是否缺少逗号、引号或括号</translation>
    </message>
    <message>
        <source>project.json must contain one JSON object; put its contents in braces</source>
        <translation>project.json 必须包含一个 JSON 对象；请将内容放在花括号中</translation>
    </message>
    <message>
        <source>There is no library &quot;{0}&quot;; available are {1}</source>
        <translation>没有库“{0}”；可用的有 {1}</translation>
    </message>
    <message>
        <source>There is no library {0}; did you mean {1}?</source>
        <translation>没有库 {0}；是否指 {1}？</translation>
    </message>
    <message>
        <source>Specify a project folder or ST files</source>
        <translation>请指定项目文件夹或 ST 文件</translation>
    </message>
    <message>
        <source>Specify one project folder or ST files, not both</source>
        <translation>请指定一个项目文件夹或若干 ST 文件，不要同时指定</translation>
    </message>
    <message>
        <source>{0} belongs to a library and cannot be renamed; rename only names of the project</source>
        <translation>{0} 属于库，不能重命名；只能重命名项目中的名称</translation>
    </message>
    <message>
        <source>{0} is not a valid name; use letters, digits and _, start with a letter and avoid keywords</source>
        <translation>{0} 不是有效的名称；请使用字母、数字和 _，以字母开头，并避免使用关键字</translation>
    </message>
    <message>
        <source>The folder cannot be created: {0}</source>
        <translation>无法创建文件夹：{0}</translation>
    </message>
    <message>
        <source>The folder cannot be read: {0}</source>
        <translation>无法读取文件夹：{0}</translation>
    </message>
    <message>
        <source>The file cannot be copied: {0}</source>
        <translation>无法复制文件：{0}</translation>
    </message>
    <message>
        <source>The folder already exists and is not empty; choose another name</source>
        <translation>文件夹已存在且不为空；请选择其他名称</translation>
    </message>
    <message>
        <source>The page cannot be written; check the free space and the permissions of the folder</source>
        <translation>无法写入页面；请检查可用空间和文件夹权限</translation>
    </message>
    <message>
        <source>There is no such file in the project; choose one from the project tree</source>
        <translation>项目中没有此文件；请从项目树中选择</translation>
    </message>
    <message>
        <source>The file&apos;s permissions cannot be changed; change them as the file&apos;s owner</source>
        <translation>无法更改文件权限；请以文件所有者身份更改</translation>
    </message>
    <message>
        <source>The file cannot be removed; check the permissions of the folder</source>
        <translation>无法删除文件；请检查文件夹权限</translation>
    </message>
    <message>
        <source>The file cannot be renamed; check the permissions of the folder</source>
        <translation>无法重命名文件；请检查文件夹权限</translation>
    </message>
    <message>
        <source>Open a project first</source>
        <translation>请先打开项目</translation>
    </message>
    <message>
        <source>This statement is not possible in a TEST together with RUN or ASSERT around it; move it out of RUN and ASSERT</source>
        <translation>在 TEST 中，此语句不能与外围的 RUN 或 ASSERT 一起使用；请将其移出 RUN 和 ASSERT</translation>
    </message>
    <message>
        <source>The code of this statement is missing</source>
        <translation>缺少此语句的代码</translation>
    </message>
    <message>
        <source>Fault in the test: {0}</source>
        <translation>测试中出现错误：{0}</translation>
    </message>
    <message>
        <source>{0} is not a value for {1}; write a value of its type</source>
        <translation>{0} 不是 {1} 的值；请写入该类型的值</translation>
    </message>
    <message>
        <source>The simulation stopped: {0}</source>
        <translation>仿真已停止：{0}</translation>
    </message>
    <message>
        <source>The controller stopped: {0}</source>
        <translation>控制器已停止：{0}</translation>
    </message>
    <message>
        <source>at {0}:{1}</source>
        <translation>位于 {0}:{1}</translation>
    </message>
    <message>
        <source>{0} has no value: {1}</source>
        <translation>{0} 没有值：{1}</translation>
    </message>
    <message>
        <source>{0} did not become true within {1}; check the condition or allow more time</source>
        <translation>{0} 在 {1} 内未变为真；请检查条件或放宽时间</translation>
    </message>
    <message>
        <source>ASSERT failed: {0}</source>
        <translation>ASSERT 失败：{0}</translation>
    </message>
    <message>
        <source>ASSERT failed: {0} ({1})</source>
        <translation>ASSERT 失败：{0}（{1}）</translation>
    </message>
    <message>
        <source>A coil writes a variable; enter the name of one.</source>
        <translation>线圈写入变量；请输入变量名。</translation>
    </message>
    <message>
        <source>A pin has no contacts; type an expression.</source>
        <translation>引脚没有触点；请输入表达式。</translation>
    </message>
    <message>
        <source>A rung cannot be moved into itself; choose a place outside it.</source>
        <translation>程序段不能移到自身内部；请选择其外部的位置。</translation>
    </message>
    <message>
        <source>A rung moves within its block of statements; use cut and paste in the text for more.</source>
        <translation>程序段只能在其语句块内移动；其他情况请在文本中使用剪切和粘贴。</translation>
    </message>
    <message>
        <source>Delete the call in the text: other statements may use its outputs.</source>
        <translation>请在文本中删除此调用：其他语句可能使用其输出。</translation>
    </message>
    <message>
        <source>Delete this output in the text.</source>
        <translation>请在文本中删除此输出。</translation>
    </message>
    <message>
        <source>Other outputs depend on the same IF; give this coil a rung of its own first.</source>
        <translation>其他输出依赖于同一个 IF；请先为此线圈建立单独的程序段。</translation>
    </message>
    <message>
        <source>Select a box with text.</source>
        <translation>请选择带文本的框。</translation>
    </message>
    <message>
        <source>Select a coil.</source>
        <translation>请选择线圈。</translation>
    </message>
    <message>
        <source>Select a contact or a wire.</source>
        <translation>请选择触点或连线。</translation>
    </message>
    <message>
        <source>Select a contact, a pin or a coil.</source>
        <translation>请选择触点、引脚或线圈。</translation>
    </message>
    <message>
        <source>Select a rung with contacts.</source>
        <translation>请选择带触点的程序段。</translation>
    </message>
    <message>
        <source>Select a rung with one output.</source>
        <translation>请选择只有一个输出的程序段。</translation>
    </message>
    <message>
        <source>Select the rung beside which it is inserted.</source>
        <translation>请选择要在其旁边插入的程序段。</translation>
    </message>
    <message>
        <source>Select the rung that the comment belongs to.</source>
        <translation>请选择注释所属的程序段。</translation>
    </message>
    <message>
        <source>Select what is to be changed.</source>
        <translation>请选择要更改的内容。</translation>
    </message>
    <message>
        <source>Select what is to be deleted.</source>
        <translation>请选择要删除的内容。</translation>
    </message>
    <message>
        <source>Several variables are assigned in one statement; separate them in the text first.</source>
        <translation>一条语句给多个变量赋值；请先在文本中分开。</translation>
    </message>
    <message>
        <source>Statements on one line cannot be moved; separate them in the text first.</source>
        <translation>同一行上的语句不能移动；请先在文本中分开。</translation>
    </message>
    <message>
        <source>The rung reads what it writes; add this coil in a rung of its own.</source>
        <translation>此程序段读取自己写入的值；请将此线圈添加到单独的程序段。</translation>
    </message>
    <message>
        <source>There is no function block {0}; declare it or check the name.</source>
        <translation>没有功能块 {0}；请声明它或检查名称。</translation>
    </message>
    <message>
        <source>This edit cannot be made in the picture; edit the text.</source>
        <translation>此编辑无法在图中进行；请编辑文本。</translation>
    </message>
    <message>
        <source>This element has no operand; select a contact, a pin or a coil.</source>
        <translation>此元素没有操作数；请选择触点、引脚或线圈。</translation>
    </message>
    <message>
        <source>This is not a statement: {0}</source>
        <translation>这不是语句：{0}</translation>
    </message>
    <message>
        <source>This is not an expression: {0}</source>
        <translation>这不是表达式：{0}</translation>
    </message>
    <message>
        <source>This rung has no condition; put it under IF in the text.</source>
        <translation>此程序段没有条件；请在文本中将其放在 IF 下。</translation>
    </message>
    <message>
        <source>{0} is {1}</source>
        <translation>{0} 为 {1}</translation>
    </message>
    <message>
        <source>{0} is {1}, expected {2} {3}</source>
        <translation>{0} 为 {1}，应为 {2} {3}</translation>
    </message>
    <message>
        <source>{0} is {1}, recorded {2} in scan {3}</source>
        <translation>{0} 为 {1}，记录值 {2}，扫描周期 {3}</translation>
    </message>
    <message>
        <source>The recording {0} has {1} {1:scan|scans}, this run {2}</source>
        <translation>记录 {0} 有 {1} 个扫描周期，本次运行有 {2} 个</translation>
    </message>
    <message>
        <source>The run differs from the recording {0}; delete it to record it again, if the new behaviour is right</source>
        <translation>本次运行与记录 {0} 不同；若新的行为正确，请删除它以重新记录</translation>
    </message>
    <message>
        <source>the condition cannot be evaluated; use variables, operators and standard functions</source>
        <translation>无法计算条件；请使用变量、运算符和标准函数</translation>
    </message>
    <message>
        <source>There is no action {0}; add it or correct the name</source>
        <translation>没有动作 {0}；请添加该动作或更正名称</translation>
    </message>
    <message>
        <source>{0} is not a valid name; use letters, digits and underscores</source>
        <translation>{0} 不是有效的名称；请使用字母、数字和下划线</translation>
    </message>
    <message>
        <source>The initial step stays at the top; make another step the initial step first</source>
        <translation>初始步保持在顶部；请先将另一步设为初始步</translation>
    </message>
    <message>
        <source>Only a step with a single transition of its own can be moved; move it in the text</source>
        <translation>只有带一个自有转换的步才能移动；请在文本中移动</translation>
    </message>
    <message>
        <source>The step is already there; choose another place</source>
        <translation>步已在该处；请选择其他位置</translation>
    </message>
    <message>
        <source>A step can be placed after a transition that leads to one step; choose such a transition</source>
        <translation>步只能放在通向单个步的转换之后；请选择这样的转换</translation>
    </message>
    <message>
        <source>This step only leads to itself; connect it to another step first</source>
        <translation>此步只通向自身；请先将其连接到另一步</translation>
    </message>
    <message>
        <source>A transition needs a condition; enter one, for example Main.done</source>
        <translation>转换需要条件；请输入条件，例如 Main.done</translation>
    </message>
    <message>
        <source>A priority must be a positive number; enter 1 or more</source>
        <translation>优先级必须是正数；请输入 1 或更大的数</translation>
    </message>
    <message>
        <source>Nothing follows this step yet; insert a step after it first</source>
        <translation>此步之后还没有内容；请先在其后插入步</translation>
    </message>
    <message>
        <source>There is no such action; select one that is in the chart</source>
        <translation>没有此动作；请选择顺序功能图中的动作</translation>
    </message>
    <message>
        <source>The initial step cannot be deleted; make another step the initial step first</source>
        <translation>初始步不能删除；请先将其他步设为初始步</translation>
    </message>
    <message>
        <source>Several transitions leave this step; delete its branches first</source>
        <translation>有多个转换离开此步；请先删除其分支</translation>
    </message>
    <message>
        <source>The condition of this transition cannot be read; edit it in the text</source>
        <translation>无法读取此转换的条件；请在文本中编辑</translation>
    </message>
    <message>
        <source>The branches after this transition do not join; connect them in the text first</source>
        <translation>此转换之后的分支没有汇合；请先在文本中连接</translation>
    </message>
    <message>
        <source>A panel must be a JSON object; put its contents in braces</source>
        <translation>画面必须是 JSON 对象；请将内容放在花括号中</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a list; put it in square brackets</source>
        <translation>“{0}”必须是列表；请放在方括号中</translation>
    </message>
    <message>
        <source>Element {0} is not an object; put it in braces</source>
        <translation>元素 {0} 不是对象；请放在花括号中</translation>
    </message>
    <message>
        <source>The kind of element {0} is not a text; write it in quotes</source>
        <translation>元素 {0} 的种类不是文本；请用引号书写</translation>
    </message>
    <message>
        <source>Two elements have the id &quot;{0}&quot;; change one of them</source>
        <translation>两个元素的标识都是“{0}”；请更改其中一个</translation>
    </message>
    <message>
        <source>Every alarm and every alarm class must be a JSON object; put it in braces</source>
        <translation>每个报警和每个报警类别都必须是 JSON 对象；请放在花括号中</translation>
    </message>
    <message>
        <source>This line is not valid UTF-8; save the file as UTF-8</source>
        <translation>此行不是有效的 UTF-8；请将文件保存为 UTF-8</translation>
    </message>
    <message>
        <source>There is text after a closing quote; double a quote that belongs to the text</source>
        <translation>结束引号之后还有文本；属于文本的引号请写两次</translation>
    </message>
    <message>
        <source>The first line must be {0} and one language tag per column</source>
        <translation>第一行必须是 {0}，且每列一个语言标签</translation>
    </message>
    <message>
        <source>This line has {0} {0:field|fields}, the header has {1}; put texts with separators in quotes</source>
        <translation>此行有 {0} 个字段，表头有 {1} 个；请将含分隔符的文本放在引号中</translation>
    </message>
    <message>
        <source>The alarm history cannot be opened: {0}</source>
        <translation>无法打开报警历史：{0}</translation>
    </message>
    <message>
        <source>The alarm history cannot be used: {0}</source>
        <translation>无法使用报警历史：{0}</translation>
    </message>
    <message>
        <source>The alarm history cannot be written: {0}</source>
        <translation>无法写入报警历史：{0}</translation>
    </message>
    <message>
        <source>{0} does not fit into {1}; use a larger type or a smaller limit</source>
        <translation>{0} 超出 {1} 的范围；请使用更大的类型或更小的限值</translation>
    </message>
    <message>
        <source>STRING contains characters of {0} only; declare the variable as WSTRING</source>
        <translation>STRING 只包含 {0} 的字符；请将变量声明为 WSTRING</translation>
    </message>
    <message>
        <source>A {0} cannot be written from a panel; write its members one by one</source>
        <translation>不能从画面写入 {0}；请逐个写入其成员</translation>
    </message>
    <message>
        <source>The folder for the pictures cannot be created; check the path and its permissions</source>
        <translation>无法创建图片文件夹；请检查路径及其权限</translation>
    </message>
    <message>
        <source>The picture cannot be written; check the free space and the permissions of the folder</source>
        <translation>无法写入图片；请检查可用空间和文件夹权限</translation>
    </message>
    <message>
        <source>The project has no such panel; choose one from hmi/</source>
        <translation>项目中没有此画面；请从 hmi/ 中选择</translation>
    </message>
    <message>
        <source>The text &quot;{0}&quot; has no key, so it cannot be translated; move it into the text table</source>
        <translation>文本“{0}”没有键，因此无法翻译；请将其移入文本表</translation>
    </message>
    <message>
        <source>The text needs a value for {0}; specify it in &quot;Values in texts&quot;</source>
        <translation>文本需要 {0} 的值；请在“文本中的值”里指定</translation>
    </message>
    <message>
        <source>The text list {0} is empty: there is no key {1}; add it to the text table</source>
        <translation>文本列表 {0} 为空：没有键 {1}；请将其添加到文本表</translation>
    </message>
    <message>
        <source>This version does not know the element kind &quot;{0}&quot;; it is kept as it is</source>
        <translation>此版本不认识元素种类“{0}”；将原样保留</translation>
    </message>
    <message>
        <source>The format {0} is not known; use for example {1} or {2}</source>
        <translation>格式 {0} 未知；例如请使用 {1} 或 {2}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; does not fit: it needs {1} px, the maximum is {2}; make the element wider or the text shorter</source>
        <translation>“{0}”放不下：需要 {1} px，最多 {2} px；请加宽元素或缩短文本</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; does not fit: it needs a height of {1} px, the maximum is {2}; make the element taller or the text shorter</source>
        <translation>“{0}”放不下：需要高度 {1} px，最多 {2} px；请加高元素或缩短文本</translation>
    </message>
    <message>
        <source>{0}; did you mean {1}?</source>
        <translation>{0}；是否指 {1}？</translation>
    </message>
    <message>
        <source>{0} is not a variable, so it cannot be written; name a variable</source>
        <translation>{0} 不是变量，因此不能写入；请指定变量</translation>
    </message>
    <message>
        <source>{0} is {1}; a BOOL is needed here</source>
        <translation>{0} 是 {1}；此处需要 BOOL</translation>
    </message>
    <message>
        <source>{0} is {1}; a number is needed here</source>
        <translation>{0} 是 {1}；此处需要数字</translation>
    </message>
    <message>
        <source>{0} is {1}; a STRING is needed here</source>
        <translation>{0} 是 {1}；此处需要 STRING</translation>
    </message>
    <message>
        <source>{0} is {1}; an array is needed here</source>
        <translation>{0} 是 {1}；此处需要数组</translation>
    </message>
    <message>
        <source>{0} is {1}; a single value is needed here</source>
        <translation>{0} 是 {1}；此处需要单个值</translation>
    </message>
    <message>
        <source>A placeholder is not closed; add {0}</source>
        <translation>占位符没有结束；请添加 {0}</translation>
    </message>
    <message>
        <source>The format {0} is not known; use one such as %.1f</source>
        <translation>格式 {0} 未知；请使用例如 %.1f</translation>
    </message>
    <message>
        <source>A trace configuration must be a JSON object; put its contents in braces</source>
        <translation>跟踪配置必须是 JSON 对象；请将内容放在花括号中</translation>
    </message>
    <message>
        <source>The trace configuration is invalid: {0}</source>
        <translation>跟踪配置无效：{0}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be {1}</source>
        <translation>“{0}”必须是{1}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is missing; add it</source>
        <translation>缺少“{0}”；请添加</translation>
    </message>
    <message>
        <source>A picture&apos;s name must end in one of {0}</source>
        <translation>图片名称必须以 {0} 之一结尾</translation>
    </message>
    <message>
        <source>no longer recorded</source>
        <translation>不再有记录</translation>
    </message>
    <message>
        <source>A recording from a file cannot be written; go back to the running controller first</source>
        <translation>来自文件的记录不能写入；请先返回运行中的控制器</translation>
    </message>
    <message>
        <source>Recorded values cannot be written; resume from here first</source>
        <translation>记录的值不能写入；请先从此处继续</translation>
    </message>
    <message>
        <source>Recorded values cannot be forced; resume from here or go back to live first</source>
        <translation>记录的值不能强制；请先从此处继续或返回实时</translation>
    </message>
    <message>
        <source>A recording from a file cannot be resumed, only what the controller itself recorded; press F5 to run the program</source>
        <translation>来自文件的记录不能继续运行，只能继续控制器自己的记录；按 F5 运行程序</translation>
    </message>
    <message>
        <source>A priority is a number; 0 removes it</source>
        <translation>优先级是数字；0 表示取消</translation>
    </message>
    <message>
        <source>This file cannot be imported; PLCopen XML (.xml), TwinCAT (.TcPOU and so on), text of CODESYS (.EXP, .export) and structured text (.st) can be read</source>
        <translation>此文件不能导入：可读取 PLCopen XML（.xml）、TwinCAT（.TcPOU 等）、CODESYS 文本（.EXP、.export）和结构化文本（.st）</translation>
    </message>
    <message>
        <source>This XML is neither PLCopen XML nor of TwinCAT or CODESYS; export the project as PLCopen XML and import that file</source>
        <translation>此 XML 既不是 PLCopen XML，也不是 TwinCAT 或 CODESYS 的；请将项目导出为 PLCopen XML 并导入该文件</translation>
    </message>
    <message>
        <source>It contains nothing that can be imported; export the project again with its units</source>
        <translation>其中没有可导入的内容；请将项目连同其 POU 重新导出</translation>
    </message>
    <message>
        <source>The folder exists and is not empty; name a new one</source>
        <translation>文件夹已存在且不为空；请指定新的文件夹</translation>
    </message>
    <message>
        <source>The sources have syntax errors; stepwise check lists them</source>
        <translation>源文件有语法错误；stepwise check 会列出它们</translation>
    </message>
    <message>
        <source>The file is too large to be read; export its parts one by one</source>
        <translation>文件过大，无法读取；请分部分导出</translation>
    </message>
    <message>
        <source>The file is in the encoding {0}, which is not supported; save it as UTF-8</source>
        <translation>不支持文件的编码 {0}；请保存为 UTF-8</translation>
    </message>
    <message>
        <source>The file declares a document type or entities of its own, which is not supported; export it again without them</source>
        <translation>文件声明了自己的文档类型或实体，这不受支持；请去掉后重新导出</translation>
    </message>
    <message>
        <source>The elements of the file are nested too deeply; export its parts one by one</source>
        <translation>文件中的元素嵌套过深；请分部分导出</translation>
    </message>
    <message>
        <source>This is not well-formed XML: {0}; export the file again</source>
        <translation>XML 格式不正确：{0}；请重新导出文件</translation>
    </message>
    <message>
        <source>The file has no elements; export it again</source>
        <translation>文件没有元素；请重新导出</translation>
    </message>
    <message>
        <source>This is XML, not structured text; import it (stepwise import --help)</source>
        <translation>这是 XML，不是结构化文本；请导入（stepwise import --help）</translation>
    </message>
    <message>
        <source>Windows-1252 does not have the character {0}; write the file as UTF-8</source>
        <translation>Windows-1252 没有字符 {0}；请将文件写为 UTF-8</translation>
    </message>
    <message>
        <source>The first input and the first output of {0} must be BOOL for it to be part of a rung; choose another block, or call it in the text.</source>
        <translation>{0} 的第一个输入和第一个输出必须是 BOOL，才能成为程序段的一部分；请选择其他块，或在文本中调用它。</translation>
    </message>
    <message>
        <source>Type a name and a block: T1 : TON</source>
        <translation>请输入名称和块：T1 : TON</translation>
    </message>
    <message>
        <source>the local variables of {0} and of what it calls need {1} bytes; the maximum is {2}; declare large arrays in a program or block</source>
        <translation>{0} 及其调用的局部变量需要 {1} 字节；最大为 {2}；请在程序或块中声明大数组</translation>
    </message>
    <message>
        <source>{0} is too large for the stack; divide it into several functions</source>
        <translation>{0} 对堆栈来说过大；请拆分为多个函数</translation>
    </message>
    <message>
        <source>more than {0} units of work (loop passes, calls, copies) in one run of the task; check for an endless loop</source>
        <translation>任务的一次执行超过 {0} 个工作单位（循环、调用、复制）；请检查是否有死循环</translation>
    </message>
    <message>
        <source>{0} is not a name: use letters, digits and underscores.</source>
        <translation>{0} 不是有效的名称：请使用字母、数字和下划线。</translation>
    </message>
    <message>
        <source>The XLIFF version {0} is not known; save the file as 1.2 or 2.0</source>
        <translation>XLIFF 版本 {0} 未知；请将文件保存为 1.2 或 2.0</translation>
    </message>
    <message>
        <source>The file does not say into which language it is translated; export it again with --language</source>
        <translation>文件未说明翻译成哪种语言；请用 --language 重新导出</translation>
    </message>
    <message>
        <source>The XML is wrong: {0}; export the file again</source>
        <translation>XML 有误：{0}；请重新导出文件</translation>
    </message>
    <message>
        <source>The text of the key {0} in {1} has changed since the export; check the translation</source>
        <translation>键 {0} 的 {1} 文本在导出后已更改；请检查翻译</translation>
    </message>
    <message>
        <source>The translation of the key {0} has other placeholders than its source and was not taken; use the same ones</source>
        <translation>键 {0} 的译文与原文的占位符不同，因此未采用；请使用相同的占位符</translation>
    </message>
    <message>
        <source>The picture {0} is outside the project; copy it into the project, or set {1} to true under {2} in project.json</source>
        <translation>图片 {0} 在项目之外；请复制到项目中，或在 project.json 的 {2} 下将 {1} 设为 true</translation>
    </message>
    <message>
        <source>The picture {0} unpacks to more than {1} MB; use a smaller one</source>
        <translation>图片 {0} 解压后大于 {1} MB；请使用较小的图片</translation>
    </message>
    <message>
        <source>The picture {0} is {1} x {2} pixels; more than {3} million are not drawn; use a smaller one</source>
        <translation>图片 {0} 为 {1} x {2} 像素；超过 {3} 百万像素时不绘制；请使用较小的图片</translation>
    </message>
    <message>
        <source>{0} is not a picture in a known format such as PNG, JPEG or SVG; save it as one of them</source>
        <translation>{0} 不是 PNG、JPEG 或 SVG 等已知格式的图片；请保存为其中一种格式</translation>
    </message>
    <message>
        <source>The picture {0} draws more than {1} shapes; simplify it or save it as PNG</source>
        <translation>图片 {0} 包含的形状超过 {1} 个；请简化或保存为 PNG</translation>
    </message>
    <message>
        <source>The shapes of the picture {0} are nested more than {1} deep or contain themselves; simplify it or save it as PNG</source>
        <translation>图片 {0} 的形状嵌套超过 {1} 层，或包含自身；请简化或保存为 PNG</translation>
    </message>
    <message>
        <source>The picture {0} loads {1}; embed it in the picture as PNG or JPEG</source>
        <translation>图片 {0} 会加载 {1}；请以 PNG 或 JPEG 嵌入图片</translation>
    </message>
    <message>
        <source>The picture {0} has dashed lines of more than {1} dashes; make the dashes longer or save it as PNG</source>
        <translation>图片 {0} 的虚线超过 {1} 段；请加长线段或保存为 PNG</translation>
    </message>
    <message>
        <source>This version does not know the property {0}; it is kept as it is</source>
        <translation>此版本不认识属性 {0}；将原样保留</translation>
    </message>
    <message>
        <source>This version does not know the property {0}; did you mean {1}?</source>
        <translation>此版本不认识属性 {0}；是否指 {1}？</translation>
    </message>
    <message>
        <source>The value must be true or false</source>
        <translation>值必须是 true 或 false</translation>
    </message>
    <message>
        <source>The value must be a whole number</source>
        <translation>值必须是整数</translation>
    </message>
    <message>
        <source>The value must be a number</source>
        <translation>值必须是数字</translation>
    </message>
    <message>
        <source>The value must be a list of two numbers: width and height</source>
        <translation>值必须是两个数字的列表：宽度和高度</translation>
    </message>
    <message>
        <source>The value must be a list of four numbers: x, y, width and height</source>
        <translation>值必须是四个数字的列表：x、y、宽度和高度</translation>
    </message>
    <message>
        <source>The value must be a list of points, each a list of two numbers</source>
        <translation>值必须是点的列表，每个点是两个数字的列表</translation>
    </message>
    <message>
        <source>The value must be an object with an expression for each name</source>
        <translation>值必须是对象，每个名称对应一个表达式</translation>
    </message>
    <message>
        <source>The value must be a list of objects</source>
        <translation>值必须是对象的列表</translation>
    </message>
    <message>
        <source>The value must be a text in quotes</source>
        <translation>值必须是带引号的文本</translation>
    </message>
    <message>
        <source>{0} is not one of the choices: {1}</source>
        <translation>{0} 不是可选项之一：{1}</translation>
    </message>
    <message>
        <source>{0} is not a colour; use the name of a role of the theme or a value such as {1}</source>
        <translation>{0} 不是颜色；请使用主题角色的名称或 {1} 这样的值</translation>
    </message>
    <message>
        <source>{0} is not a colour; did you mean {1}?</source>
        <translation>{0} 不是颜色；是否指 {1}？</translation>
    </message>
    <message>
        <source>{0} ({1}) must be greater than {2} ({3}); exchange or correct the values</source>
        <translation>{0}（{1}）必须大于 {2}（{3}）；请交换或更正数值</translation>
    </message>
    <message>
        <source>{0} has no page {1}; its {2} {2:page is|pages are} numbered from 0</source>
        <translation>{0} 没有第 {1} 页；其 {2} 页从 0 开始编号</translation>
    </message>
    <message>
        <source>The format {0} needs a number, and {1} is none; use {2}</source>
        <translation>格式 {0} 需要数字，而 {1} 不是；请使用 {2}</translation>
    </message>
    <message>
        <source>The project has no language {0}, so operators never see this column; add it to the languages in project.json</source>
        <translation>项目没有语言 {0}，操作员永远看不到此列；请在 project.json 的语言中添加</translation>
    </message>
    <message>
        <source>No text says what this does; add one, or place one next to it</source>
        <translation>没有文本说明其作用；请添加文本，或在旁边放置文本</translation>
    </message>
    <message>
        <source>{0} is between {1} and {2} in the recording, so the range from {3} to {4} cuts it off; widen the range</source>
        <translation>记录中 {0} 在 {1} 与 {2} 之间，因此范围 {3} 到 {4} 会截断它；请扩大范围</translation>
    </message>
    <message>
        <source>{0} is not between {1} and {2}, so {3} is used; correct it</source>
        <translation>{0} 不在 {1} 与 {2} 之间，因此使用 {3}；请更正</translation>
    </message>
    <message>
        <source>The panel {0} contains this one, so it cannot be placed in it; choose another one</source>
        <translation>画面 {0} 包含本画面，因此不能放在其中；请选择其他画面</translation>
    </message>
    <message>
        <source>The panel {0} has no parameter {1}; remove the argument or add the parameter</source>
        <translation>画面 {0} 没有参数 {1}；请删除实参或添加参数</translation>
    </message>
    <message>
        <source>The program has no type {0}; name a block or a structure, BOOL, REAL or the like, or text</source>
        <translation>程序没有类型 {0}；请指定块或结构、BOOL、REAL 等，或 text</translation>
    </message>
    <message>
        <source>The parameter {0} needs an argument of type {1}; enter one in the properties of this faceplate</source>
        <translation>参数 {0} 需要类型为 {1} 的实参；请在此面板组件的属性中输入</translation>
    </message>
    <message>
        <source>{0} is {1}; the parameter {2} needs {3}</source>
        <translation>{0} 是 {1}；参数 {2} 需要 {3}</translation>
    </message>
    <message>
        <source>{0} (tried with {1})</source>
        <translation>{0}（已用 {1} 尝试）</translation>
    </message>
    <message>
        <source>The program was not built from sources; open its project.</source>
        <translation>程序不是由源文件编译的；请打开其项目。</translation>
    </message>
    <message>
        <source>The recording does not contain the program of this scan; choose a later scan.</source>
        <translation>记录中没有此扫描周期的程序；请选择较晚的扫描周期。</translation>
    </message>
    <message>
        <source>This scan is no longer in the recording; choose a later scan.</source>
        <translation>此扫描周期已不在记录中；请选择较晚的扫描周期。</translation>
    </message>
    <message>
        <source>The scan before it is not in the recording, so the values with which this scan began are not known; choose a later scan.</source>
        <translation>前一个扫描周期不在记录中，因此不知道此扫描周期开始时的值；请选择较晚的扫描周期。</translation>
    </message>
    <message>
        <source>There is no user {0}; create the user or check the name</source>
        <translation>没有用户 {0}；请创建该用户或检查名称</translation>
    </message>
    <message>
        <source>The password cannot be saved: {0}</source>
        <translation>无法保存密码：{0}</translation>
    </message>
    <message>
        <source>A password needs at least {0} characters; choose a longer one</source>
        <translation>密码至少需要 {0} 个字符；请使用更长的密码</translation>
    </message>
    <message>
        <source>The password must not be the name of the user; choose another one</source>
        <translation>密码不能是用户名；请使用其他密码</translation>
    </message>
    <message>
        <source>The audit trail cannot be written: {0}</source>
        <translation>无法写入审计追踪：{0}</translation>
    </message>
    <message>
        <source>The audit trail cannot be read: {0}</source>
        <translation>无法读取审计追踪：{0}</translation>
    </message>
    <message>
        <source>The frame {0} has no panel area, so no panel is shown in it; add one</source>
        <translation>框架 {0} 没有画面区域，因此其中不显示画面；请添加画面区域</translation>
    </message>
    <message>
        <source>Only for the roles {0}, but the project has no users, so anybody may operate it; add users</source>
        <translation>仅限角色 {0}，但项目没有用户，任何人都可操作；请添加用户</translation>
    </message>
    <message>
        <source>A row of a recipe names no variable; enter one or remove the row</source>
        <translation>配方的一行未指定变量；请指定变量或删除该行</translation>
    </message>
    <message>
        <source>The first column must be named variable, and each set has a column of its own</source>
        <translation>第一列必须名为 variable（变量），且每组数据占一列</translation>
    </message>
    <message>
        <source>The recipe {0} has no variable {1}; add it or correct the name</source>
        <translation>配方 {0} 没有变量 {1}；请添加该变量或更正名称</translation>
    </message>
    <message>
        <source>There is no recipe {0}; create it or check the name</source>
        <translation>没有配方 {0}；请创建该配方或检查名称</translation>
    </message>
    <message>
        <source>The recipe {0} has no set {1}; create it or check the name</source>
        <translation>配方 {0} 没有数据组 {1}；请创建该数据组或检查名称</translation>
    </message>
    <message>
        <source>{0} is outside the limits of {1}, {2} to {3}; enter a value within them</source>
        <translation>{0} 超出 {1} 的限值 {2} 到 {3}；请输入限值内的值</translation>
    </message>
    <message>
        <source>The list of shelved alarms cannot be read, so none is shelved: {0}</source>
        <translation>无法读取搁置的报警列表，因此没有搁置任何报警：{0}</translation>
    </message>
    <message>
        <source>The list of shelved alarms cannot be written: {0}</source>
        <translation>无法写入搁置的报警列表：{0}</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>为什么？</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>为什么不？</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>谁设置了它？</translation>
    </message>
    <message>
        <source>There is no rule {0}; &quot;stepwise panel --rules&quot; lists them</source>
        <translation>没有规则 {0}；“stepwise panel --rules”会列出所有规则</translation>
    </message>
    <message>
        <source>There is no rule {0}; did you mean {1}?</source>
        <translation>没有规则 {0}；是否指 {1}？</translation>
    </message>
    <message>
        <source>The rule stays on until a reason for switching it off is given</source>
        <translation>在写明关闭理由之前，该规则保持启用</translation>
    </message>
    <message>
        <source>The value must be a list of texts in quotes</source>
        <translation>该值必须是带引号文本的列表</translation>
    </message>
    <message>
        <source>The value must be an object with the reason for each rule</source>
        <translation>该值必须是一个对象，其中写明每条规则的理由</translation>
    </message>
    <message>
        <source>The value must be an object with a level, the distance, and rules that are off</source>
        <translation>该值必须是一个对象，包含级别、距离和已关闭的规则</translation>
    </message>
    <message>
        <source>The colour {0} is always visible, whatever the state; use {1}</source>
        <translation>颜色 {0} 无论何种状态都始终可见；请使用 {1}</translation>
    </message>
    <message>
        <source>{0} is an alarm colour, but it is visible in normal operation; use {1}</source>
        <translation>{0} 是报警颜色，但在正常运行时也可见；请使用 {1}</translation>
    </message>
    <message>
        <source>Only the hue distinguishes {0} from {1}; choose a brighter one, or add a text or blinking</source>
        <translation>{0} 与 {1} 仅靠色相区分；请选择更亮的颜色，或添加文本或闪烁</translation>
    </message>
    <message>
        <source>No text says what the lamp means; give it a label, or place a text next to it</source>
        <translation>没有文本说明该指示灯的含义；请为其添加标签，或在旁边放置文本</translation>
    </message>
    <message>
        <source>{0} on {1} has a contrast of {2} to 1 in the theme {3}; {4} to 1 is needed; choose another colour</source>
        <translation>在主题 {3} 中，{0} 在 {1} 上的对比度为 {2} 比 1；需要 {4} 比 1；请选择其他颜色</translation>
    </message>
    <message>
        <source>A font of {0} px cannot be read from {2} mm; use at least {1} px</source>
        <translation>{0} px 的字体在 {2} mm 处无法看清；请至少使用 {1} px</translation>
    </message>
    <message>
        <source>The faceplate is so small here that its smallest font has {0} px; from {2} mm, {1} px are needed; enlarge it</source>
        <translation>此处面板组件太小，其最小字体只有 {0} px；在 {2} mm 处需要 {1} px；请将其放大</translation>
    </message>
    <message>
        <source>The faceplate is so small here that only {0} px remain for a finger; {1} px are needed; enlarge it</source>
        <translation>此处面板组件太小，只剩 {0} px 供手指按下；需要 {1} px；请将其放大</translation>
    </message>
    <message>
        <source>{0} x {1} px is too small for a finger next to other controls; {2} px are needed in both directions; make it larger</source>
        <translation>{0} × {1} px 与相邻元素并排时对手指来说太小；两个方向都需要 {2} px；请将元素放大</translation>
    </message>
    <message>
        <source>The panel shows {0} values and controls; the maximum for its size is {1}; move some to another panel</source>
        <translation>画面显示了 {0} 个值和控件；按其大小，最多为 {1} 个；请将一部分移到其他画面</translation>
    </message>
    <message>
        <source>The panel {0} is {1} presses away from the start panel; add a way of at most {2}</source>
        <translation>画面 {0} 距起始画面需按 {1} 次；请添加最多 {2} 次即可到达的途径</translation>
    </message>
    <message>
        <source>Nothing on the panel {0} leads back; add a button with the action back or home, or a navigation bar</source>
        <translation>画面 {0} 上没有返回的途径；请添加带 back 或 home 动作的按钮，或导航栏</translation>
    </message>
    <message>
        <source>{0} is in a different place on the panel {1}; put it in the same place on both</source>
        <translation>{0} 在画面 {1} 上处于不同位置；请在两个画面上放在同一位置</translation>
    </message>
    <message>
        <source>Normal states are grey so that abnormal ones are noticed (ISA-101). Use a role of the theme such as surface, off or running, and give colour only to conditions.</source>
        <translation>正常状态为灰色，以便发现异常 (ISA-101)。请使用主题中的角色，如 surface、off 或 running，并只通过条件着色。</translation>
    </message>
    <message>
        <source>Red, orange and yellow are reserved for alarms. An operator who sees them all day long no longer notices them when they matter (ISA-101, ISA-18.2).</source>
        <translation>红色、橙色和黄色留给报警。操作员若整天看到它们，在关键时刻就会视而不见 (ISA-101, ISA-18.2)。</translation>
    </message>
    <message>
        <source>Text needs a contrast of 4.5 to 1 against its background, large text 3 to 1 (WCAG 2, ISO 9241-303). The colour roles ensure this in every theme.</source>
        <translation>文本与背景的对比度需达到 4.5 比 1，大号文本为 3 比 1 (WCAG 2, ISO 9241-303)。主题角色在每个主题中都能保证这一点。</translation>
    </message>
    <message>
        <source>A capital letter must be seen at an angle of 16 minutes at least (ISO 9241-303). The distance and the size of a pixel are set in project.json.</source>
        <translation>大写字母的视角至少应为 16 角分 (ISO 9241-303)。距离和像素大小在 project.json 中设置。</translation>
    </message>
    <message>
        <source>On a panel that shows everything, operators have to search. Move details to a panel of the next level (ISA-101).</source>
        <translation>在显示所有内容的画面上，操作员不得不寻找信息。请把细节移到下一级画面 (ISA-101)。</translation>
    </message>
    <message>
        <source>In an abnormal situation, every panel should be at most three presses away, and there should be a way back from it (ISA-101).</source>
        <translation>在异常情况下，每个画面最多应按三次即可到达，并且应能返回 (ISA-101)。</translation>
    </message>
    <message>
        <source>Operators find what is on several panels without searching if it is always in the same place. Put it on the frame, or in the same place everywhere.</source>
        <translation>多个画面上的同一内容若总在同一位置，操作员无需寻找即可看到。请放在框架上，或在各处放在同一位置。</translation>
    </message>
    <message>
        <source>One element covers the other, so that a text cannot be read or the wrong element is pressed.</source>
        <translation>一个元素遮住另一个，导致文本无法阅读或按错元素。</translation>
    </message>
    <message>
        <source>The element looks as if it had a function. Bind it to a variable, or remove it.</source>
        <translation>该元素看起来好像有功能。请绑定变量或删除它。</translation>
    </message>
    <message>
        <source>A typing error sends 500 instead of 50. Limits reject it on entry.</source>
        <translation>输入失误会把 50 写成 500。限值会在输入时拒绝它。</translation>
    </message>
    <message>
        <source>An alarm that nobody sees is useless. Put an alarm banner on the frame or an alarm list on a panel (ISA-18.2).</source>
        <translation>没人看到的报警等于没有报警。请在框架上放置报警横幅，或在画面上放置报警列表 (ISA-18.2)。</translation>
    </message>
    <message>
        <source>An alarm requires the operator to act. Its help must say what to do, and what happens otherwise (ISA-18.2).</source>
        <translation>报警要求操作员采取措施。其帮助必须说明该怎么做，以及不处理会发生什么 (ISA-18.2)。</translation>
    </message>
    <message>
        <source>If everything is urgent, nothing is: about 5 % of the alarms should have the highest priority, 15 % the next (ISA-18.2).</source>
        <translation>如果一切都紧急，就没有什么紧急：约 5 % 的报警应为最高优先级，15 % 为次高 (ISA-18.2)。</translation>
    </message>
    <message>
        <source>the value {0} is outside the subrange {1}..{2}; limit it before the assignment or widen the subrange</source>
        <translation>值 {0} 超出子范围 {1}..{2}；请在赋值前限制该值，或扩大子范围</translation>
    </message>
    <message>
        <source>&quot;addressing&quot; in project.json is &quot;byte&quot; or &quot;word&quot;, not &quot;{0}&quot;</source>
        <translation>project.json 中的“addressing”是“byte”或“word”，而不是“{0}”</translation>
    </message>
    <message>
        <source>&quot;memoryForNew&quot; in project.json is a number of bytes from 0 to {0}</source>
        <translation>project.json 中的“memoryForNew”是 0 到 {0} 的字节数</translation>
    </message>
    <message>
        <source>A finger needs 7 mm in both directions, a gloved one 9 mm, as the strict level requires. The size of a pixel is set in project.json.</source>
        <translation>手指在两个方向上需要 7 mm，戴手套需要 9 mm（严格级别的要求）。像素大小在 project.json 中设置。</translation>
    </message>
    <message>
        <source>Nothing is bound; fill in “{0}”</source>
        <translation>尚未绑定任何变量；请填写“{0}”</translation>
    </message>
    <message>
        <source>Any number can be written to {0}; set “{1}”</source>
        <translation>任何数值都可写入 {0}；请设置“{1}”</translation>
    </message>
    <message>
        <source>One man in twelve cannot tell some colours apart, and bright light washes them out. Show the same information with a text, a shape, blinking or at least a different brightness.</source>
        <translation>每十二名男性中就有一人难以分辨某些颜色，强光下颜色也会变淡。请同时用文本、形状、闪烁或至少不同的亮度来显示。</translation>
    </message>
    <message>
        <source>A write that is restricted to some roles, or that project.json lists as critical, must not be triggered by an accidental touch. Set &quot;Writes are confirmed&quot;, or enter a question.</source>
        <translation>仅限某些角色的写入，或 project.json 列为关键的写入，不应因误触而触发。请设置“写入需确认”，或填写询问文本。</translation>
    </message>
    <message>
        <source>Only {1} may write {0}, but no confirmation is required; set &quot;Writes are confirmed&quot;</source>
        <translation>只有 {1} 可以写 {0}，但未要求确认；请设置“写入需确认”</translation>
    </message>
    <message>
        <source>The theme is not valid JSON with a base and colors</source>
        <translation>主题不是包含 base 和 colors 的有效 JSON</translation>
    </message>
    <message>
        <source>There is no built-in theme &quot;{0}&quot;; a base is light, dark or contrast</source>
        <translation>没有内置主题“{0}”；基础主题为 light、dark 或 contrast</translation>
    </message>
    <message>
        <source>There is no colour role {0}; check the spelling</source>
        <translation>没有颜色角色 {0}；请检查拼写</translation>
    </message>
    <message>
        <source>There is no colour role {0}; did you mean {1}?</source>
        <translation>没有颜色角色 {0}；是否指 {1}？</translation>
    </message>
    <message>
        <source>The colour of {0} must be written like {1}</source>
        <translation>{0} 的颜色必须写成 {1} 的形式</translation>
    </message>
    <message>
        <source>There is no theme {0}; choose one of {1}</source>
        <translation>没有主题 {0}；请从 {1} 中选择</translation>
    </message>
    <message>
        <source>This edit would change the same text twice; undo it and edit the text</source>
        <translation>此编辑会两次更改同一文本；请撤消并编辑文本</translation>
    </message>
    <message>
        <source>This transition does not lead to a step yet; connect it to one first</source>
        <translation>此转换尚未通向任何步；请先将其连接到步</translation>
    </message>
    <message>
        <source>The panel was written by a newer version of Stepwise; open it with that version</source>
        <translation>画面由更新版本的 Stepwise 写入；请用该版本打开</translation>
    </message>
    <message>
        <source>This trace configuration was written by a newer version of Stepwise (version {0}); open it with that version</source>
        <translation>此跟踪配置由更新版本的 Stepwise 写入（版本 {0}）；请用该版本打开</translation>
    </message>
    <message>
        <source>The recorded program can no longer be built; open the recording with the version of Stepwise that made it</source>
        <translation>记录的程序已无法编译；请用创建该记录的 Stepwise 版本打开</translation>
    </message>
    <message>
        <source>The controller is not running; press F5</source>
        <translation>控制器未运行；请按 F5</translation>
    </message>
    <message>
        <source>There is no program to run; declare a PROGRAM</source>
        <translation>没有可运行的程序；请声明 PROGRAM</translation>
    </message>
    <message>
        <source>There is no program to test; declare a PROGRAM</source>
        <translation>没有可测试的程序；请声明 PROGRAM</translation>
    </message>
    <message>
        <source>A file with this name already exists; choose another name</source>
        <translation>同名文件已存在；请选择其他名称</translation>
    </message>
    <message>
        <source>A panel with this name already exists; choose another name</source>
        <translation>同名画面已存在；请选择其他名称</translation>
    </message>
    <message>
        <source>A step {0} already exists; choose another name</source>
        <translation>步 {0} 已存在；请选择其他名称</translation>
    </message>
    <message>
        <source>The step of this loop is 0; write BY with another number</source>
        <translation>此循环的步长为 0；请在 BY 后写其他数值</translation>
    </message>
    <message>
        <source>This loop of the test does not end; give it a condition that becomes FALSE</source>
        <translation>测试中的此循环不会结束；请设置会变为 FALSE 的条件</translation>
    </message>
    <message>
        <source>There is no name here that can be renamed; put the cursor on one</source>
        <translation>此处没有可重命名的名称；请将光标置于名称上</translation>
    </message>
    <message>
        <source>The file was changed by another program and was not overwritten; compare both first</source>
        <translation>文件已被其他程序更改，未被覆盖；请先比较两者</translation>
    </message>
    <message>
        <source>The type of {0} is not known here; correct the errors of the program first</source>
        <translation>此处不知道 {0} 的类型；请先更正程序中的错误</translation>
    </message>
    <message>
        <source>Nothing has been recorded yet; start the controller with F5</source>
        <translation>尚未记录任何内容；请按 F5 启动控制器</translation>
    </message>
    <message>
        <source>a constant cannot be forced; change it in the program</source>
        <translation>常量不能强制；请在程序中更改</translation>
    </message>
    <message>
        <source>the path is incomplete; write it to a single value, for example Main.x</source>
        <translation>路径不完整；请写到单个值为止，例如 Main.x</translation>
    </message>
    <message>
        <source>The panel is not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>画面不是有效的 JSON；请检查是否缺少逗号、引号或括号</translation>
    </message>
    <message>
        <source>The alarms are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>报警不是有效的 JSON；请检查是否缺少逗号、引号或括号</translation>
    </message>
    <message>
        <source>The recipes are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>配方不是有效的 JSON；请检查是否缺少逗号、引号或括号</translation>
    </message>
    <message>
        <source>The users and roles are not valid JSON; look for a missing comma, quote or bracket</source>
        <translation>用户和角色不是有效的 JSON；请检查是否缺少逗号、引号或括号</translation>
    </message>
    <message>
        <source>The trace configuration is not valid JSON (see line {0}); look for a missing comma, quote or bracket</source>
        <translation>跟踪配置不是有效的 JSON（见第 {0} 行）；请检查是否缺少逗号、引号或括号</translation>
    </message>
    <message>
        <source>Two alarms have the id &quot;{0}&quot;; change one of them</source>
        <translation>两个报警的标识都是“{0}”；请更改其中一个</translation>
    </message>
    <message>
        <source>The quote that opens here is never closed; add one at the end of the text</source>
        <translation>此处的引号没有结束；请在文本末尾补上引号</translation>
    </message>
    <message>
        <source>The language {0} has two columns; remove one of them</source>
        <translation>语言 {0} 有两列；请删除其中一列</translation>
    </message>
    <message>
        <source>The key {0} is already on line {1}; remove one of the two lines</source>
        <translation>键 {0} 已在第 {1} 行；请删除两行中的一行</translation>
    </message>
    <message>
        <source>Two roles are named {0}; rename one</source>
        <translation>有两个角色名为 {0}；请重命名其中一个</translation>
    </message>
    <message>
        <source>Two users are named {0}; rename one</source>
        <translation>有两个用户名为 {0}；请重命名其中一个</translation>
    </message>
    <message>
        <source>Two recipes are named {0}; rename one</source>
        <translation>有两个配方名为 {0}；请重命名其中一个</translation>
    </message>
    <message>
        <source>Two sets of the recipe are named {0}; rename one</source>
        <translation>配方的两个数据组名为 {0}；请重命名其中一个</translation>
    </message>
    <message>
        <source>The alarm has no condition; enter one</source>
        <translation>报警没有条件；请输入条件</translation>
    </message>
    <message>
        <source>The element is outside the panel; move it inside</source>
        <translation>元素在画面之外；请移到画面内</translation>
    </message>
    <message>
        <source>The picture {0} is larger than {1} MB; use a smaller one</source>
        <translation>图片 {0} 大于 {1} MB；请使用较小的图片</translation>
    </message>
    <message>
        <source>The faceplate does not say which panel it shows; choose one</source>
        <translation>面板组件未指定要显示的画面；请选择一个画面</translation>
    </message>
    <message>
        <source>The key {0} has no text in {1}; enter it in the text table</source>
        <translation>键 {0} 没有 {1} 文本；请在文本表中输入</translation>
    </message>
    <message>
        <source>The help of the alarm {0} does not say what to do; add the operator&apos;s next step</source>
        <translation>报警 {0} 的帮助没有说明该怎么做；请补充操作员的下一步操作</translation>
    </message>
    <message>
        <source>the reference is NULL; assign a variable to it, or compare it with NULL first</source>
        <translation>引用为 NULL；请为其指定变量，或先与 NULL 比较</translation>
    </message>
    <message>
        <source>the reference does not point to a variable of its type; assign one to it</source>
        <translation>引用未指向其类型的变量；请为其指定该类型的变量</translation>
    </message>
    <message>
        <source>a VAR_IN_OUT is not connected to a variable; connect it in the call</source>
        <translation>有 VAR_IN_OUT 未连接变量；请在调用中连接</translation>
    </message>
    <message>
        <source>the watchdog stopped a task that did not end; check for an endless loop</source>
        <translation>看门狗停止了一个未结束的任务；请检查是否有死循环</translation>
    </message>
    <message>
        <source>the task ran longer than its watchdog time of {0}; shorten its work or raise the time</source>
        <translation>任务运行超过其看门狗时间 {0}；请减少其工作量或增大该时间</translation>
    </message>
    <message>
        <source>the file name is too long; choose a shorter one</source>
        <translation>文件名过长；请使用更短的名称</translation>
    </message>
    <message>
        <source>the folder is not empty; choose another one</source>
        <translation>文件夹不为空；请选择其他文件夹</translation>
    </message>
    <message>
        <source>the file system is read-only; choose another folder</source>
        <translation>文件系统为只读；请选择其他文件夹</translation>
    </message>
    <message>
        <source>too many files are open; close some of them</source>
        <translation>打开的文件过多；请关闭其中一些</translation>
    </message>
    <message>
        <source>The file is damaged or is not a recording; choose a file that Stepwise wrote (.rec)</source>
        <translation>文件已损坏或不是记录；请选择由 Stepwise 写入的文件 (.rec)</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is reached through a reference, which a path cannot follow; name the variable it refers to</source>
        <translation>“{0}”要经过引用才能到达，路径无法跟随引用；请写出它所指向的变量</translation>
    </message>
    <message>
        <source>a string has one index; remove the others</source>
        <translation>字符串只有一个下标；请删除其余下标</translation>
    </message>
    <message>
        <source>a variable of type {0} has no elements; remove the index</source>
        <translation>类型 {0} 的变量没有元素；请删除下标</translation>
    </message>
    <message>
        <source>a variable of type {0} has no bits; remove the bit number</source>
        <translation>类型 {0} 的变量没有位；请删除位号</translation>
    </message>
    <message>
        <source>the program does not use the address &apos;{0}&apos;; declare a variable AT this address</source>
        <translation>程序未使用地址“{0}”；请用 AT 在该地址声明变量</translation>
    </message>
    <message>
        <source>the path is empty; write for example Main.x</source>
        <translation>路径为空；请输入，例如 Main.x</translation>
    </message>
    <message>
        <source>a constant cannot be written; change it in the program</source>
        <translation>常量不能写入；请在程序中修改</translation>
    </message>
    <message>
        <source>The retain file is not a regular file; remove it or choose another one</source>
        <translation>保持值文件不是普通文件；请将其删除或选择其他文件</translation>
    </message>
    <message>
        <source>the text has {0} characters, the maximum is {1}; shorten it</source>
        <translation>文本有 {0} 个字符，最多 {1} 个；请缩短文本</translation>
    </message>
    <message>
        <source>{0} has {1} {1:part|parts}, the value has {2}; write one value for each</source>
        <translation>{0} 有 {1} 个部分，值有 {2} 个；请为每个部分写一个值</translation>
    </message>
    <message>
        <source>there is no value to write; enter one first</source>
        <translation>没有要写入的值；请先输入值</translation>
    </message>
    <message>
        <source>The expression is nested too deeply; divide it into several</source>
        <translation>表达式嵌套过深；请将其拆分为多个</translation>
    </message>
    <message>
        <source>this is not an expression; write for example Main.x &gt; 5</source>
        <translation>这不是表达式；请输入，例如 Main.x &gt; 5</translation>
    </message>
    <message>
        <source>this is not an array; remove the index</source>
        <translation>这不是数组；请删除下标</translation>
    </message>
    <message>
        <source>an expression cannot have side effects; use variables, operators and standard functions only</source>
        <translation>表达式不能有副作用；请仅使用变量、运算符和标准函数</translation>
    </message>
    <message>
        <source>There is no body in ST or IL here; put the cursor into one</source>
        <translation>此处没有 ST 或 IL 主体；请将光标放入其中</translation>
    </message>
    <message>
        <source>There is no library {0}; check &quot;libraries&quot; in project.json</source>
        <translation>没有库 {0}；请检查 project.json 中的“libraries”</translation>
    </message>
    <message>
        <source>This folder contains neither a project.json nor ST files; choose another folder or create a project</source>
        <translation>此文件夹中既没有 project.json，也没有 ST 文件；请选择其他文件夹或新建项目</translation>
    </message>
    <message>
        <source>There is no such file or folder; check the path</source>
        <translation>没有这样的文件或文件夹；请检查路径</translation>
    </message>
    <message>
        <source>{0} already exists in the project; choose another name</source>
        <translation>{0} 在项目中已存在；请使用其他名称</translation>
    </message>
    <message>
        <source>{0} already exists in {1}; choose another name</source>
        <translation>{0} 在 {1} 中已存在；请使用其他名称</translation>
    </message>
    <message>
        <source>The file is read-only and was not overwritten; make it writable or choose another name</source>
        <translation>文件为只读，未被覆盖；请允许写入或使用其他名称</translation>
    </message>
    <message>
        <source>{0} is not a time; write for example T#2s</source>
        <translation>{0} 不是时间；请输入，例如 T#2s</translation>
    </message>
    <message>
        <source>{0} is not a whole number; write for example 5</source>
        <translation>{0} 不是整数；请输入，例如 5</translation>
    </message>
    <message>
        <source>{0} is not a number of scans; write for example 10</source>
        <translation>{0} 不是扫描周期数；请输入，例如 10</translation>
    </message>
    <message>
        <source>Nothing would lead to the join after this step; delete the join first</source>
        <translation>将没有任何元素通向此步之后的汇合；请先删除汇合</translation>
    </message>
    <message>
        <source>There is no branch here; choose a step or transition in a branch</source>
        <translation>此处没有分支；请选择分支中的步或转换</translation>
    </message>
    <message>
        <source>The last branch does not lead to a step; connect it first</source>
        <translation>最后一个分支不通向任何步；请先连接</translation>
    </message>
    <message>
        <source>There is no chart yet; write an INITIAL_STEP first</source>
        <translation>尚无顺序功能图；请先编写 INITIAL_STEP</translation>
    </message>
    <message>
        <source>An alarm has no id; give it one</source>
        <translation>有一个报警没有标识；请添加标识</translation>
    </message>
    <message>
        <source>Column {0} has no language tag; write one such as de or en-GB</source>
        <translation>第 {0} 列没有语言标签；请输入，例如 de 或 en-GB</translation>
    </message>
    <message>
        <source>This line has no key; write one in the first column</source>
        <translation>此行没有键；请在第一列输入键</translation>
    </message>
    <message>
        <source>This is not an XLIFF file; choose one that was exported for translation</source>
        <translation>这不是 XLIFF 文件；请选择为翻译而导出的文件</translation>
    </message>
    <message>
        <source>There is no panel {0}; create it or choose another one</source>
        <translation>没有画面 {0}；请新建或选择其他画面</translation>
    </message>
    <message>
        <source>The key {0} is not in the text table; add it there</source>
        <translation>键 {0} 不在文本表中；请在其中添加</translation>
    </message>
    <message>
        <source>The project has no language {0}; add a column for it to texts.csv</source>
        <translation>项目没有语言 {0}；请在 texts.csv 中为其添加一列</translation>
    </message>
    <message>
        <source>The file {0} does not exist; add it to the project or choose another one</source>
        <translation>文件 {0} 不存在；请将其添加到项目或选择其他文件</translation>
    </message>
    <message>
        <source>The panel has no group or tab {0}; create it or choose another one</source>
        <translation>画面没有组或选项卡 {0}；请新建或选择其他</translation>
    </message>
    <message>
        <source>The group {0} contains itself; choose another parent</source>
        <translation>组 {0} 包含自身；请选择其他上级</translation>
    </message>
    <message>
        <source>A role has no name; give it one</source>
        <translation>有一个角色没有名称；请为其命名</translation>
    </message>
    <message>
        <source>A user has no name; give it one</source>
        <translation>有一个用户没有名称；请为其命名</translation>
    </message>
    <message>
        <source>There is no role {0}; create it or choose another one</source>
        <translation>没有角色 {0}；请新建或选择其他角色</translation>
    </message>
    <message>
        <source>A recipe has no name; give it one</source>
        <translation>有一个配方没有名称；请为其命名</translation>
    </message>
    <message>
        <source>A set of a recipe has no name; give it one</source>
        <translation>配方的一个数据组没有名称；请为其命名</translation>
    </message>
    <message>
        <source>The recipe has the variable {0} twice; remove one of the two</source>
        <translation>配方中变量 {0} 出现两次；请删除其中之一</translation>
    </message>
    <message>
        <source>The set {0} has no value for {1}; enter one</source>
        <translation>数据组 {0} 没有 {1} 的值；请输入值</translation>
    </message>
    <message>
        <source>There is no alarm class {0}; add it or choose another one</source>
        <translation>没有报警类别 {0}；请添加或选择其他类别</translation>
    </message>
    <message>
        <source>No panel and no alarm uses the key {0}; use it or remove it</source>
        <translation>没有画面或报警使用键 {0}；请使用或删除</translation>
    </message>
    <message>
        <source>The placeholders differ: {0} has {1}, {2} has {3}; use the same in both</source>
        <translation>占位符不一致：{0} 有 {1}，{2} 有 {3}；请在两者中使用相同的占位符</translation>
    </message>
    <message>
        <source>The font {0} is not installed here, so texts cannot be measured; install it</source>
        <translation>此处未安装字体 {0}，因此无法测量文本；请安装该字体</translation>
    </message>
    <message>
        <source>No font has the character {0}; use another one</source>
        <translation>没有字体包含字符 {0}；请使用其他字符</translation>
    </message>
    <message>
        <source>{0} covers a part of it; move one of the two</source>
        <translation>{0} 遮住了它的一部分；请移动其中之一</translation>
    </message>
    <message>
        <source>Nothing leads from the start panel {1} to the panel {0}; add a button, a navigation bar or an alarm, or choose another start panel</source>
        <translation>从起始画面 {1} 无法到达画面 {0}；请添加按钮、导航栏或报警，或选择其他起始画面</translation>
    </message>
    <message>
        <source>{0} of {1} alarms have the highest priority; keep it for the few that cannot wait</source>
        <translation>{1} 个报警中有 {0} 个为最高优先级；请仅用于少数紧急报警</translation>
    </message>
    <message>
        <source>The project has {0} {0:alarm|alarms}, but no panel has an alarm list or banner; add one</source>
        <translation>项目有 {0} 个报警，但没有任何画面带有报警列表或报警横幅；请添加</translation>
    </message>
    <message>
        <source>{0} is critical according to project.json, but a single press writes it; set &quot;Writes are confirmed&quot;</source>
        <translation>project.json 将 {0} 列为关键变量，但按一下即可写入；请启用“写入需确认”</translation>
    </message>
    <message>
        <source>{0} suppresses alarms, but a single press writes it; set &quot;Writes are confirmed&quot;</source>
        <translation>{0} 会抑制报警，但按一下即可写入；请启用“写入需确认”</translation>
    </message>
    <message>
        <source>The start panel has {0} controls, but no text says what to press when nothing moves; add a sentence, or a state text that names a control</source>
        <translation>起始画面有 {0} 个操作元件，但没有文本说明静止时应按什么；请添加一句说明，或添加指明某个操作元件的状态文本</translation>
    </message>
    <message>
        <source>A machine at rest looks the same whether it is broken or just waiting. The start panel must say what to press next: a sentence below the title, or a state text such as “Ready: press S1”.</source>
        <translation>静止的机器无论是出了故障还是仅在等待，看起来都一样。起始画面必须说明接下来按什么：标题下的一句话，或类似“就绪：请按 S1”的状态文本。</translation>
    </message>
    <message>
        <source>{0} is not the code of a language; use codes such as {1} or {2}</source>
        <translation>{0} 不是语言代码；请使用 {1} 或 {2} 这样的代码</translation>
    </message>
    <message>
        <source>Single files have no project.json for settings; create a project and put them into its folder src</source>
        <translation>单独的文件没有保存设置的 project.json；请新建项目，并把文件放入其 src 文件夹</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>Alarm texts in five languages</source>
        <translation>五种语言的报警文本</translation>
    </message>
    <message>
        <source>Heated tank with analog blocks</source>
        <translation>带模拟量功能块的加热罐</translation>
    </message>
    <message>
        <source>Bottling line</source>
        <translation>灌装线</translation>
    </message>
    <message>
        <source>Car park with a robot</source>
        <translation>机器人停车场</translation>
    </message>
    <message>
        <source>Car wash with recipes</source>
        <translation>带配方的洗车机</translation>
    </message>
    <message>
        <source>Room heating with supply air</source>
        <translation>送风供暖的房间</translation>
    </message>
    <message>
        <source>Motor valve with command monitor</source>
        <translation>带指令监视的电动阀</translation>
    </message>
    <message>
        <source>Conveyor with a sequence</source>
        <translation>带顺序控制的输送带</translation>
    </message>
    <message>
        <source>Depalletiser</source>
        <translation>卸垛机</translation>
    </message>
    <message>
        <source>District-heating substation</source>
        <translation>集中供热换热站</translation>
    </message>
    <message>
        <source>Dosing</source>
        <translation>配料</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>过滤器</translation>
    </message>
    <message>
        <source>Gravel plant</source>
        <translation>砾石厂</translation>
    </message>
    <message>
        <source>Heater and valve</source>
        <translation>加热器与阀门</translation>
    </message>
    <message>
        <source>Hour meter with reset and enable</source>
        <translation>带复位和使能的小时计</translation>
    </message>
    <message>
        <source>Hourly production</source>
        <translation>每小时产量</translation>
    </message>
    <message>
        <source>Item counter and meters</source>
        <translation>工件计数器与计量表</translation>
    </message>
    <message>
        <source>Level lamps</source>
        <translation>液位指示灯</translation>
    </message>
    <message>
        <source>Light tower</source>
        <translation>塔灯</translation>
    </message>
    <message>
        <source>Tuning a control loop</source>
        <translation>控制回路整定</translation>
    </message>
    <message>
        <source>Mixer for two liquids and two bricks</source>
        <translation>两种液体与两块料的混合机</translation>
    </message>
    <message>
        <source>Motor with latching</source>
        <translation>电机自锁</translation>
    </message>
    <message>
        <source>Operation mode of an agitator</source>
        <translation>搅拌器的运行模式</translation>
    </message>
    <message>
        <source>PID loop on a first-order process</source>
        <translation>一阶过程的 PID 回路</translation>
    </message>
    <message>
        <source>Two pumps in a well</source>
        <translation>一口井中的两台泵</translation>
    </message>
    <message>
        <source>Pulse width modulation of a sine</source>
        <translation>正弦信号的脉宽调制</translation>
    </message>
    <message>
        <source>Storage rack with a robot</source>
        <translation>机器人货架</translation>
    </message>
    <message>
        <source>Robot and CNC machine</source>
        <translation>机器人与数控机床</translation>
    </message>
    <message>
        <source>Packing robot with camera inspection</source>
        <translation>装箱机器人</translation>
    </message>
    <message>
        <source>Two redundant level sensors</source>
        <translation>相互监视的两个液位传感器</translation>
    </message>
    <message>
        <source>Pumping station with six pumps</source>
        <translation>六泵泵站</translation>
    </message>
    <message>
        <source>Motor with selector switch</source>
        <translation>带选择开关的电机</translation>
    </message>
    <message>
        <source>Stack of integers</source>
        <translation>整数堆栈</translation>
    </message>
    <message>
        <source>Tank with filling, heating and emptying</source>
        <translation>罐的充填、加热与排空</translation>
    </message>
    <message>
        <source>Manually operated tank</source>
        <translation>手动操作的罐</translation>
    </message>
    <message>
        <source>Level and volume</source>
        <translation>液位与体积</translation>
    </message>
    <message>
        <source>Traffic light</source>
        <translation>交通灯</translation>
    </message>
    <message>
        <source>Valve matrix</source>
        <translation>阀门矩阵</translation>
    </message>
    <message>
        <source>Three kinds of valves</source>
        <translation>三种阀门</translation>
    </message>
    <message>
        <source>Pump control with waves</source>
        <translation>波浪中的泵</translation>
    </message>
    <message>
        <source>Truck scale</source>
        <translation>汽车衡</translation>
    </message>
    <message>
        <source>Workbook</source>
        <translation>练习册</translation>
    </message>
    <message>
        <source>Tank over Modbus</source>
        <translation>通过 Modbus 连接的罐</translation>
    </message>
    <message>
        <source>A vehicle between two limit switches, controlled by two linked sequential function charts</source>
        <translation>小车在两个限位开关之间行驶，由两个关联的顺序功能图控制</translation>
    </message>
    <message>
        <source>A motor with three alarms that operators read in five languages</source>
        <translation>电机的三条报警，可用五种语言显示</translation>
    </message>
    <message>
        <source>One control loop with a block for each task: filter, monitor, ramp, PID, transfer</source>
        <translation>一个控制回路，每项任务一个功能块：滤波、监视、斜坡、PID、切换</translation>
    </message>
    <message>
        <source>Filler, capper and labeller with buffers between them, controlled as PackML units</source>
        <translation>灌装机、旋盖机和贴标机，中间带缓冲，按 PackML 控制</translation>
    </message>
    <message>
        <source>A robot parks cars by number plate and retrieves them again</source>
        <translation>机器人按车牌号停车并取车</translation>
    </message>
    <message>
        <source>Five wash programmes, each with a price and a recipe that the owner can edit</source>
        <translation>五种洗车程序，价格和配方均可修改</translation>
    </message>
    <message>
        <source>Cascade control: a slow loop for the room, a fast one for the supply air</source>
        <translation>串级控制：慢回路控制房间，快回路控制送风</translation>
    </message>
    <message>
        <source>A motor valve whose travel is monitored; if it takes too long, an alarm sounds</source>
        <translation>监视电动阀的行程时间；超时则发出报警</translation>
    </message>
    <message>
        <source>A belt carries an item to the right, waits ten seconds and carries it back</source>
        <translation>输送带把工件送到右侧，等待十秒后送回</translation>
    </message>
    <message>
        <source>Four belts take boxes off pallets; the settings of one can be copied to another</source>
        <translation>四条输送带从托盘卸下箱子，设置可互相复制</translation>
    </message>
    <message>
        <source>Heating and hot water from a district-heating network, with frost protection and summer mode</source>
        <translation>集中供热网络的采暖和热水，带防冻和夏季模式</translation>
    </message>
    <message>
        <source>A valve doses in pulses and pauses until the batch is complete</source>
        <translation>阀门以脉冲和间歇方式投料，直到批次完成</translation>
    </message>
    <message>
        <source>The pressure drop shows how dirty a filter is; an alarm reports when it is out of range</source>
        <translation>压降反映过滤器的堵塞程度，超出范围时报警</translation>
    </message>
    <message>
        <source>Silo, bin, conveyor and truck, controlled by three parallel sequential function charts</source>
        <translation>料仓、料斗、输送带和卡车，由三个并行的顺序功能图控制</translation>
    </message>
    <message>
        <source>Two on-off controls: a heater with a set point, and a valve that opens on a pump alarm</source>
        <translation>两个开关控制：带设定值的加热器，以及泵报警时打开的阀门</translation>
    </message>
    <message>
        <source>An hour meter that is loaded, enabled and held, giving a sawtooth</source>
        <translation>可装载、启用和保持的小时计，曲线呈锯齿形</translation>
    </message>
    <message>
        <source>A press makes items; a table counts how many in each hour of the day</source>
        <translation>压力机生产工件，表格统计每小时的数量</translation>
    </message>
    <message>
        <source>Counts items, energy and water; the counts survive a power failure</source>
        <translation>统计工件、电能和用水量，断电后数据保留</translation>
    </message>
    <message>
        <source>A 4 to 20 mA level sensor, three lamps and wire break detection</source>
        <translation>4 至 20 mA 液位传感器、三个指示灯和断线检测</translation>
    </message>
    <message>
        <source>Three machine signals on three lamps that flash or stay on</source>
        <translation>机器的三个信号由三个常亮或闪烁的指示灯显示</translation>
    </message>
    <message>
        <source>A heat exchanger that oscillates; an experiment and its recording give better settings</source>
        <translation>换热器发生振荡；通过一次试验及其记录得到更好的参数</translation>
    </message>
    <message>
        <source>Liquids are weighed while a belt brings two bricks; then the mixer turns and tips</source>
        <translation>称量液体，输送带送来两块料，然后搅拌并倾倒</translation>
    </message>
    <message>
        <source>Start, stop and a latching contactor, written in five ways that agree</source>
        <translation>启动、停止和自保持接触器，用五种等效方式编写</translation>
    </message>
    <message>
        <source>The local control box or the panel: one block decides which of them is in control</source>
        <translation>就地控制箱或画面：由一个功能块决定控制权</translation>
    </message>
    <message>
        <source>The same process with and without a PID controller, side by side in one trace</source>
        <translation>同一过程有无 PID 控制器的对比，显示在一个跟踪中</translation>
    </message>
    <message>
        <source>One filter, two sines: the slow one passes, the fast one is attenuated and delayed</source>
        <translation>一个滤波器，两个正弦信号：慢的通过，快的衰减并滞后</translation>
    </message>
    <message>
        <source>A pump tries its speeds and keeps the one with the least energy per cubic metre</source>
        <translation>泵逐一试验转速，保持每立方米能耗最低的转速</translation>
    </message>
    <message>
        <source>Two alternating pumps; a float switch is accepted only after two steady seconds</source>
        <translation>两台泵轮换运行；浮球稳定两秒后才有效</translation>
    </message>
    <message>
        <source>A sine becomes pulses for two outputs, as for a motor with two directions</source>
        <translation>正弦信号转换为两个输出的脉冲，如同双向电机</translation>
    </message>
    <message>
        <source>A robot counts encoder pulses to store and retrieve loads in twelve locations</source>
        <translation>机器人对编码器脉冲计数，在十二个货位存取货物</translation>
    </message>
    <message>
        <source>A robot takes 25 items one by one to a CNC machine and back</source>
        <translation>机器人把 25 个工件逐个送到 CNC 机床并取回</translation>
    </message>
    <message>
        <source>A robot puts three items into each box; a camera checks the result</source>
        <translation>机器人在每个箱子里放三个工件，由相机检查结果</translation>
    </message>
    <message>
        <source>Two sensors are compared; a faulty one is replaced with the healthy one without a jump</source>
        <translation>比较两个传感器；故障的一个由正常的无扰替代</translation>
    </message>
    <message>
        <source>Starts and stops six pumps by level and running hours, with the daily inflow of a town</source>
        <translation>按液位和运行小时数启停六台泵，进水按城镇一天的变化模拟</translation>
    </message>
    <message>
        <source>A rotary switch selects the speed of a motor, a number what a module does</source>
        <translation>旋钮选择电机转速，数字选择模块的功能</translation>
    </message>
    <message>
        <source>Last in, first out: push, pop and reset, in ST and as an instruction list</source>
        <translation>后进先出：push、pop 和 reset，用 ST 和指令表编写</translation>
    </message>
    <message>
        <source>The same sequence twice: with CASE and as a sequential function chart; either can be in control</source>
        <translation>同一过程写两次：用 CASE 和顺序功能图，任选其一控制</translation>
    </message>
    <message>
        <source>Fill, empty and stir with three switches; two level switches prevent operating errors</source>
        <translation>用三个开关加料、排空和搅拌，两个液位开关防止误操作</translation>
    </message>
    <message>
        <source>A current of 4 to 20 mA becomes a level, and the level becomes a volume</source>
        <translation>4 至 20 mA 电流换算为液位，液位换算为体积</translation>
    </message>
    <message>
        <source>Red, yellow and green from one seconds counter, written in three ways</source>
        <translation>由一个秒计数器控制红、黄、绿灯，用三种方式编写</translation>
    </message>
    <message>
        <source>Five tanks, three pipelines, fifteen valves; two tanks never feed the same pipeline</source>
        <translation>五个罐、三条管线、十五个阀门；两个罐绝不同时供同一管线</translation>
    </message>
    <message>
        <source>A motor valve, a spring-return valve and a control valve, each with its block</source>
        <translation>电动阀、弹簧复位阀和调节阀，各有一个功能块</translation>
    </message>
    <message>
        <source>A float switch in waves: the pump starts and stops only after five steady seconds</source>
        <translation>波浪中的浮球：稳定五秒后泵才启停</translation>
    </message>
    <message>
        <source>Four BCD digits become the net weight once the scale has settled</source>
        <translation>秤稳定后，四位 BCD 数换算为净重</translation>
    </message>
    <message>
        <source>Language samples on four pages, each a separate program with a test</source>
        <translation>四页语言示例，每个都是带测试的独立程序</translation>
    </message>
    <message>
        <source>Automated guided vehicle</source>
        <translation>自动导引车</translation>
    </message>
    <message>
        <source>First-order filter and two sines</source>
        <translation>一阶滤波器与两个正弦信号</translation>
    </message>
    <message>
        <source>Pump at its most efficient speed</source>
        <translation>泵的最高效转速</translation>
    </message>
    <message>
        <source>A controller and a tank, connected on this computer by real Modbus TCP</source>
        <translation>控制器和罐通过本机上真实的 Modbus TCP 连接</translation>
    </message>
</context>
<context>
    <name>Exchange</name>
    <message>
        <source>The file is written in {0}</source>
        <translation>文件的编码为 {0}</translation>
    </message>
    <message>
        <source>The file was not read: {0}</source>
        <translation>文件未读取：{0}</translation>
    </message>
    <message>
        <source>The element {0} was not read; add it by hand if the program needs it</source>
        <translation>元素 {0} 未读取；若程序需要，请手动添加</translation>
    </message>
    <message>
        <source>The vendor&apos;s data {0} is kept in exchange.json</source>
        <translation>厂商数据 {0} 保存在 exchange.json 中</translation>
    </message>
    <message>
        <source>The body in {0} became structured text; the diagram is kept in exchange.json</source>
        <translation>{0} 中的主体已变为结构化文本；图保存在 exchange.json 中</translation>
    </message>
    <message>
        <source>The body in {0} is stored in a form that only its own editor reads; export it there as PLCopen XML</source>
        <translation>{0} 中的主体以只有其自身编辑器可读的形式存储；请在那里导出为 PLCopen XML</translation>
    </message>
    <message>
        <source>A jump leads to the step {0}, which does not exist; add the step or correct the jump</source>
        <translation>跳转通向步 {0}，但该步不存在；请添加该步或更正跳转</translation>
    </message>
    <message>
        <source>The element {0} of the chart is not connected and was left out; connect it in the other tool and export again</source>
        <translation>顺序功能图的元素 {0} 未连接，已略去；请在原工具中连接后重新导出</translation>
    </message>
    <message>
        <source>The transition from {0} has no condition and is written as FALSE; enter its condition</source>
        <translation>从 {0} 出发的转换没有条件，写为 FALSE；请输入其条件</translation>
    </message>
    <message>
        <source>The element {0} takes part in a loop without a block that stores a value, so its last value is not kept; store it in a variable</source>
        <translation>元素 {0} 处于没有存储值的块的循环中，因此不保留其上次的值；请将其存入变量</translation>
    </message>
    <message>
        <source>The element {0} is not connected and was left out; connect it in the other tool and export again</source>
        <translation>元素 {0} 未连接，已略去；请在原工具中连接后重新导出</translation>
    </message>
    <message>
        <source>An input of {0} is not connected, so its call has too few arguments; add the value that is meant</source>
        <translation>{0} 的一个输入未连接，因此其调用的参数太少；请补上所需的值</translation>
    </message>
    <message>
        <source>An edge in a function needs the value of the last call, which a function does not store; make it a FUNCTION_BLOCK</source>
        <translation>函数中的边沿需要上次调用的值，而函数不存储该值；请改为 FUNCTION_BLOCK</translation>
    </message>
    <message>
        <source>The result of {0} is used in several places and is computed in each; assign it to a variable to compute it once</source>
        <translation>{0} 的结果在多处使用，并在每处计算；若只需计算一次，请将其赋给变量</translation>
    </message>
    <message>
        <source>The type of the result of {0} is not known, so it is computed although EN is FALSE; call it under an IF</source>
        <translation>{0} 的结果类型未知，因此即使 EN 为 FALSE 也会计算；请在 IF 下调用</translation>
    </message>
    <message>
        <source>The library {0} is not part of Stepwise; uses of it are reported by the check</source>
        <translation>库 {0} 不属于 Stepwise；检查会报告其使用处</translation>
    </message>
    <message>
        <source>Code in C is kept as a comment and is not executed; write it in ST</source>
        <translation>C 代码作为注释保留，不会执行；请用 ST 编写</translation>
    </message>
    <message>
        <source>There are two units named {0}; the second is in {1}</source>
        <translation>有两个名为 {0} 的 POU；第二个在 {1} 中</translation>
    </message>
    <message>
        <source>The configuration of the devices was not read; assign the inputs and outputs again</source>
        <translation>设备配置未读取；请重新分配输入和输出</translation>
    </message>
    <message>
        <source>The task {0} is started by the event {1}, which does not exist here; give it an INTERVAL or a SINGLE</source>
        <translation>任务 {0} 由事件 {1} 启动，但此处没有该事件；请为其指定 INTERVAL 或 SINGLE</translation>
    </message>
    <message>
        <source>A comment outside of the elements was left out: {0}</source>
        <translation>元素之外的注释已略去：{0}</translation>
    </message>
    <message>
        <source>The diagram in {0} was not read: an expression refers to itself endlessly; write its body in ST</source>
        <translation>{0} 中的图未读取：表达式无限引用自身；请用 ST 编写其主体</translation>
    </message>
    <message>
        <source>The transition {0} is not a single expression and was not read; write its condition in the text</source>
        <translation>转换 {0} 不是单个表达式，未读取；请在文本中写入其条件</translation>
    </message>
    <message>
        <source>PLCopen XML does not support panels; they were left out</source>
        <translation>PLCopen XML 不支持画面；已略去</translation>
    </message>
    <message>
        <source>PLCopen XML does not support traces; they were left out</source>
        <translation>PLCopen XML 不支持跟踪；已略去</translation>
    </message>
    <message>
        <source>PLCopen XML does not support tests; they were left out</source>
        <translation>PLCopen XML 不支持测试；已略去</translation>
    </message>
    <message>
        <source>PLCopen XML does not support tests; the TEST &apos;{0}&apos; was left out</source>
        <translation>PLCopen XML 不支持测试；TEST“{0}”已略去</translation>
    </message>
    <message>
        <source>PLCopen XML does not support namespaces; the names of {0} are written without the prefix</source>
        <translation>PLCopen XML 不支持命名空间；{0} 的名称不带前缀</translation>
    </message>
    <message>
        <source>PLCopen XML does not support namespaces; {0} was left out with its units because there is another {1}; rename one of them</source>
        <translation>PLCopen XML 不支持命名空间；{0} 及其 POU 已略去，因为还有另一个 {1}；请重命名其中之一</translation>
    </message>
    <message>
        <source>PLCopen XML does not support USING; it was left out</source>
        <translation>PLCopen XML 不支持 USING；已略去</translation>
    </message>
    <message>
        <source>PLCopen XML does not support the name of the transition {0}; it was left out</source>
        <translation>PLCopen XML 不支持转换 {0} 的名称；已略去</translation>
    </message>
    <message>
        <source>PLCopen XML has one indicator per action; {0} was left out</source>
        <translation>PLCopen XML 每个动作只有一个指示变量；{0} 已略去</translation>
    </message>
    <message>
        <source>Version 0201 has no methods; {0} was left out</source>
        <translation>版本 0201 没有方法；{0} 已略去</translation>
    </message>
    <message>
        <source>Version 0201 has no properties; {0} was left out</source>
        <translation>版本 0201 没有属性；{0} 已略去</translation>
    </message>
    <message>
        <source>Version 0201 has no interfaces; {0} was left out</source>
        <translation>版本 0201 没有接口；{0} 已略去</translation>
    </message>
    <message>
        <source>Version 0201 has no unions; {0} was left out</source>
        <translation>版本 0201 没有联合体；{0} 已略去</translation>
    </message>
    <message>
        <source>Version 0201 has no inheritance; EXTENDS or IMPLEMENTS of {0} was left out</source>
        <translation>版本 0201 没有继承；{0} 的 EXTENDS 或 IMPLEMENTS 已略去</translation>
    </message>
    <message>
        <source>Version 0201 does not have the type {0}; other tools will not know it</source>
        <translation>版本 0201 没有类型 {0}；其他工具将无法识别</translation>
    </message>
    <message>
        <source>Version 0201 does not support the pragma {0} of a step; it was left out</source>
        <translation>版本 0201 不支持步的编译指示 {0}；已略去</translation>
    </message>
    <message>
        <source>Version 0201 does not support {0} of a task; it was left out</source>
        <translation>版本 0201 不支持任务的 {0}；已略去</translation>
    </message>
    <message>
        <source>Version 0201 does not support the connections of the program {0}; they were left out</source>
        <translation>版本 0201 不支持程序 {0} 的连接；已略去</translation>
    </message>
    <message>
        <source>Version 0201 does not support libraries; {0} was left out</source>
        <translation>版本 0201 不支持库；{0} 已略去</translation>
    </message>
    <message>
        <source>The file is not a program source and was left out; import it separately if it is one</source>
        <translation>文件不是程序源，已略去；若它是程序源文件，请单独导入</translation>
    </message>
    <message>
        <source>The network &apos;{0}&apos; is commented out in the diagram and was left out of the text</source>
        <translation>程序段“{0}”在图中被注释掉，未写入文本</translation>
    </message>
    <message>
        <source>Types that are predefined in {0} are declared here</source>
        <translation>{0} 预定义的类型在此处声明</translation>
    </message>
    <message>
        <source>{0} counts %MW1 in words; &quot;addressing&quot; in project.json says the same</source>
        <translation>{0} 按字计算 %MW1；project.json 中的“addressing”与此一致</translation>
    </message>
    <message>
        <source>The address {0} starts at a byte that tools counting in words cannot address; move it to a multiple of its size</source>
        <translation>地址 {0} 起始于按字计数的其他工具无法表示的字节；请移到其大小的整数倍</translation>
    </message>
    <message>
        <source>{0} accesses the system outside the controller; it is declared here with its inputs and outputs but does nothing</source>
        <translation>{0} 访问控制器之外的系统；此处声明其输入和输出，但不执行任何操作</translation>
    </message>
    <message>
        <source>The library {0} is part of this import; its names are written without the prefix {0}</source>
        <translation>库 {0} 是此次导入的一部分；其名称不带前缀 {0}</translation>
    </message>
    <message>
        <source>The names of the library {0} are built into Stepwise; they are written without the prefix {0}</source>
        <translation>库 {0} 的名称已内置于 Stepwise；书写时不带前缀 {0}</translation>
    </message>
    <message>
        <source>The program uses __NEW; &quot;memoryForNew&quot; in project.json sets 65536 bytes aside for it</source>
        <translation>程序使用 __NEW；project.json 中的“memoryForNew”为其预留 65536 字节</translation>
    </message>
    <message>
        <source>STRING constants contain characters that Latin-1 does not have ({0} and so on); &quot;stringEncoding&quot; in project.json is {1}</source>
        <translation>STRING 常量包含 Latin-1 没有的字符（{0} 等）；project.json 中的“stringEncoding”为 {1}</translation>
    </message>
    <message>
        <source>The file is empty; export it again</source>
        <translation>文件为空；请重新导出</translation>
    </message>
    <message>
        <source>This is a ZIP archive despite its name; extract it and import the folder</source>
        <translation>尽管名称如此，此文件是 ZIP 压缩包；请解压后导入文件夹</translation>
    </message>
    <message>
        <source>The file is in the folder of the project {0}, which does not list it or excludes it from its build; it was left out</source>
        <translation>文件位于项目 {0} 的文件夹中，但该项目未列出它，或将其排除在编译之外；已略去</translation>
    </message>
    <message>
        <source>Several projects of the folder have a unit named {0}; each became a project of its own, together with the libraries it uses: this one is {1}</source>
        <translation>文件夹中有多个项目都含有名为 {0} 的 POU；每个项目连同其使用的库已成为独立的项目：此项目为 {1}</translation>
    </message>
    <message>
        <source>The program {0} of the library {1} was left out: the project that uses the library has one of that name</source>
        <translation>库 {1} 的程序 {0} 已略去：使用该库的项目有同名程序</translation>
    </message>
    <message>
        <source>The folder has no project named {0}; it has: {1}</source>
        <translation>文件夹中没有名为 {0} 的项目；现有：{1}</translation>
    </message>
    <message>
        <source>The names of inputs and outputs that the configuration of the devices declares ({0} and so on) are in PLC_Configuration</source>
        <translation>设备配置所声明的输入和输出的名称（{0} 等）在 PLC_Configuration 中</translation>
    </message>
    <message>
        <source>The file is not valid UTF-8 and specifies no other encoding; it was read as {0}. If letters are wrong, import it again with another encoding</source>
        <translation>该文件不是有效的 UTF-8，也没有声明其他编码；已按 {0} 读取。如果字符有误，请选择其他编码重新导入</translation>
    </message>
    <message>
        <source>Macro step {0} was replaced by the steps inside it; steps whose names were already used are prefixed with {0}</source>
        <translation>宏步 {0} 已替换为其中的各步；名称已被使用的步加上了前缀 {0}</translation>
    </message>
    <message>
        <source>The program uses {0} of the library {1}, which reaches outside a simulated controller; declare POUs of these names that do what the simulation needs</source>
        <translation>程序使用了库 {1} 中的 {0}，它们涉及仿真控制器之外的内容；请声明同名的 POU，实现仿真所需的功能</translation>
    </message>
    <message>
        <source>Conditions in {0} are drawn with blocks; the action {1}, which runs in every scan from the initial step on, calls them</source>
        <translation>{0} 中的条件用块绘制；动作 {1} 从初始步起在每个扫描周期运行，并调用它们</translation>
    </message>
    <message>
        <source>The drawn body of {0} was not read; open the project in CODESYS V3 and export it there as PLCopen XML</source>
        <translation>{0} 的图形主体未读取；请在 CODESYS V3 中打开项目，并导出为 PLCopen XML</translation>
    </message>
    <message>
        <source>The drawn body of {0} was not read: the order of the inputs of {1} is not known. Import the file that declares {1} together with this one</source>
        <translation>{0} 的图形主体未读取：不知道 {1} 的输入顺序。请将声明 {1} 的文件与此文件一起导入</translation>
    </message>
    <message>
        <source>The program uses {0}, which none of its files declares; the project uses the library {1}, which has it</source>
        <translation>程序使用了 {0}，但没有文件声明它；项目使用包含它的库 {1}</translation>
    </message>
    <message>
        <source>The task {0} runs {1}, a program of a library; it was left out. Call what the machine needs of it from a program of the project</source>
        <translation>任务 {0} 运行库中的程序 {1}；该程序已略去。请从项目的程序中调用机器所需的部分</translation>
    </message>
    <message>
        <source>The variables of this extension are declared in {0}; its code in C or Python is not executed. Write to them in ST what the code does</source>
        <translation>此扩展的变量在 {0} 中声明；其 C 或 Python 代码不会执行。请用 ST 按该代码的作用写入这些变量</translation>
    </message>
    <message>
        <source>Version 0201 does not support the constructor arguments of {0}; they were left out</source>
        <translation>版本 0201 不支持 {0} 的构造函数参数；已略去</translation>
    </message>
</context>
<context>
    <name>FigureText</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1，位于 %2</translation>
    </message>
    <message>
        <source>An XY plot draws one channel against another: add a second channel to the trace.</source>
        <translation>XY 图以一个通道为横轴显示另一个通道：请向跟踪添加第二个通道。</translation>
    </message>
    <message>
        <source>XY plot</source>
        <translation>XY 图</translation>
    </message>
    <message>
        <source>There are no samples in view: run the program or show another section.</source>
        <translation>可见范围内没有采样值：请运行程序或显示其他区段。</translation>
    </message>
    <message>
        <source>%L1 points over %2</source>
        <translation>%L1 个点，历时 %2</translation>
    </message>
    <message>
        <source>A spectrum shows the frequencies of the visible channels: add a channel.</source>
        <translation>频谱显示可见通道的频率：请添加通道。</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>频率 [Hz]</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>%1: no peak, RMS %2</source>
        <translation>%1：无峰值，有效值 %2</translation>
    </message>
    <message>
        <source>%1: %2, RMS %3</source>
        <translation>%1：%2，有效值 %3</translation>
    </message>
    <message>
        <source>A frequency response compares an output with an input: add both as channels, and choose the input.</source>
        <translation>频率响应比较输出与输入：请将两者添加为通道，并选择输入。</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>频率响应</translation>
    </message>
    <message>
        <source>gain [dB]</source>
        <translation>增益 [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>相位 [°]</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>相干性</translation>
    </message>
    <message>
        <source>%1: %L2 of %L3 frequencies with a coherence above 0.8</source>
        <translation>%1：%L3 个频率中有 %L2 个的相干性高于 0.8</translation>
    </message>
    <message>
        <source>Runs are overlaid at their triggers: enter a trigger in the properties of the trace.</source>
        <translation>各次运行按触发点叠加：请在跟踪的属性中输入触发器。</translation>
    </message>
    <message>
        <source>The trigger has not fired in this recording yet.</source>
        <translation>此记录中触发器尚未触发。</translation>
    </message>
    <message>
        <source>The runs of the visible channels are overlaid: add a channel.</source>
        <translation>可见通道的各次运行叠加显示：请添加通道。</translation>
    </message>
    <message>
        <source>Time since the trigger [s]</source>
        <translation>触发后的时间 [s]</translation>
    </message>
    <message>
        <source>%1: runs differ most %2 after the trigger, by %3</source>
        <translation>%1：各次运行在触发后 %2 差异最大，为 %3</translation>
    </message>
    <message>
        <source>Charts over Time Only</source>
        <translation>仅时间曲线图</translation>
    </message>
    <message>
        <source>XY Plot</source>
        <translation>XY 图</translation>
    </message>
    <message>
        <source>Frequency Response (Bode)</source>
        <translation>频率响应（伯德图）</translation>
    </message>
    <message>
        <source>Runs over Each Other</source>
        <translation>叠加各次运行</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n 次运行</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Fixes</name>
    <message>
        <source>Replace with {0}</source>
        <translation>替换为 {0}</translation>
    </message>
    <message>
        <source>Insert {0}</source>
        <translation>插入 {0}</translation>
    </message>
    <message>
        <source>Did you mean {0}?</source>
        <translation>是否指 {0}？</translation>
    </message>
    <message>
        <source>Convert with {0}</source>
        <translation>用 {0} 转换</translation>
    </message>
    <message>
        <source>Move {0} to {1}</source>
        <translation>将 {0} 移到 {1}</translation>
    </message>
    <message>
        <source>Add the property {0}</source>
        <translation>添加属性 {0}</translation>
    </message>
    <message>
        <source>Add the method {0}</source>
        <translation>添加方法 {0}</translation>
    </message>
    <message>
        <source>Add the missing branches</source>
        <translation>添加缺少的分支</translation>
    </message>
    <message>
        <source>Add ELSE</source>
        <translation>添加 ELSE</translation>
    </message>
    <message>
        <source>Add () to call it</source>
        <translation>添加 () 以调用</translation>
    </message>
    <message>
        <source>Compare with 0</source>
        <translation>与 0 比较</translation>
    </message>
    <message>
        <source>Remove the unused declaration</source>
        <translation>移除未使用的声明</translation>
    </message>
    <message>
        <source>Replace with IF and ELSIF</source>
        <translation>替换为 IF 和 ELSIF</translation>
    </message>
    <message>
        <source>Change to a WSTRING literal</source>
        <translation>改为 WSTRING 字面量</translation>
    </message>
    <message>
        <source>Replace with straight quotes</source>
        <translation>替换为直引号</translation>
    </message>
    <message>
        <source>Make {0} the initial step</source>
        <translation>将 {0} 设为初始步</translation>
    </message>
    <message>
        <source>Dereference the pointer with ^</source>
        <translation>用 ^ 解引用指针</translation>
    </message>
</context>
<context>
    <name>Hmi</name>
    <message>
        <source>as it is</source>
        <translation>原样</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>其他…</translation>
    </message>
    <message>
        <source>A variable that is written</source>
        <translation>要写入的变量</translation>
    </message>
    <message>
        <source>An ST expression</source>
        <translation>ST 表达式</translation>
    </message>
    <message>
        <source>Shown to the operator. A typed text gets its key automatically; @key uses an existing one.</source>
        <translation>显示给操作员。输入的文本会自动获得键；@键 使用已有的键。</translation>
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
        <translation>宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.svg)</source>
        <translation>图片 (*.png *.jpg *.svg)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Unknown element</source>
        <translation>未知元素</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Alarm class</source>
        <translation>报警类别</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>线</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>线宽</translation>
    </message>
    <message>
        <source>Line style</source>
        <translation>线型</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Fill level</source>
        <translation>填充高度</translation>
    </message>
    <message>
        <source>Full at</source>
        <translation>满值</translation>
    </message>
    <message>
        <source>Level colour</source>
        <translation>液位颜色</translation>
    </message>
    <message>
        <source>Font size</source>
        <translation>字号</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>粗体</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>Text colour</source>
        <translation>文本颜色</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Limit low-low</source>
        <translation>下下限 (LL)</translation>
    </message>
    <message>
        <source>Limit low</source>
        <translation>下限 (L)</translation>
    </message>
    <message>
        <source>Limit high</source>
        <translation>上限 (H)</translation>
    </message>
    <message>
        <source>Limit high-high</source>
        <translation>上上限 (HH)</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Text list</source>
        <translation>文本列表</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>标识</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>优先级</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Values in texts</source>
        <translation>文本中的值</translation>
    </message>
    <message>
        <source>On delay in seconds</source>
        <translation>接通延时（秒）</translation>
    </message>
    <message>
        <source>Off delay in seconds</source>
        <translation>断开延时（秒）</translation>
    </message>
    <message>
        <source>Must be acknowledged</source>
        <translation>需要确认</translation>
    </message>
    <message>
        <source>Suppressed if</source>
        <translation>抑制条件</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Tab page</source>
        <translation>选项卡页</translation>
    </message>
    <message>
        <source>Position and size</source>
        <translation>位置和大小</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>Visible if</source>
        <translation>可见条件</translation>
    </message>
    <message>
        <source>Enabled if</source>
        <translation>可操作条件</translation>
    </message>
    <message>
        <source>Appearance by condition</source>
        <translation>按条件变化的外观</translation>
    </message>
    <message>
        <source>Move right by</source>
        <translation>右移量</translation>
    </message>
    <message>
        <source>Move down by</source>
        <translation>下移量</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>旋转量</translation>
    </message>
    <message>
        <source>Fixed language</source>
        <translation>固定语言</translation>
    </message>
    <message>
        <source>If</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Blinks</source>
        <translation>闪烁</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>可见</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>可操作</translation>
    </message>
    <message>
        <source>On if</source>
        <translation>接通条件</translation>
    </message>
    <message>
        <source>Blinks if</source>
        <translation>闪烁条件</translation>
    </message>
    <message>
        <source>Variable with [#] as index</source>
        <translation>以 [#] 为下标的变量</translation>
    </message>
    <message>
        <source>Editable</source>
        <translation>可编辑</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>阶梯</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>End</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>Polyline</source>
        <translation>折线</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Rounded rectangle</source>
        <translation>圆角矩形</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>椭圆</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>起始角度</translation>
    </message>
    <message>
        <source>Span</source>
        <translation>张角</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Pipe</source>
        <translation>管道</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>粗细</translation>
    </message>
    <message>
        <source>Flow (sign gives the direction)</source>
        <translation>流量（符号表示方向）</translation>
    </message>
    <message>
        <source>Flow colour</source>
        <translation>流动颜色</translation>
    </message>
    <message>
        <source>Wraps</source>
        <translation>自动换行</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应方式</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>符号</translation>
    </message>
    <message>
        <source>Running if</source>
        <translation>运行条件</translation>
    </message>
    <message>
        <source>Warning if</source>
        <translation>警告条件</translation>
    </message>
    <message>
        <source>Fault if</source>
        <translation>故障条件</translation>
    </message>
    <message>
        <source>Colour off</source>
        <translation>关闭时颜色</translation>
    </message>
    <message>
        <source>Colour running</source>
        <translation>运行时颜色</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Button</source>
        <translation>按钮</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Value to write</source>
        <translation>写入值</translation>
    </message>
    <message>
        <source>Go to panel</source>
        <translation>转到画面</translation>
    </message>
    <message>
        <source>Language tag</source>
        <translation>语言标签</translation>
    </message>
    <message>
        <source>Question to confirm</source>
        <translation>确认提问</translation>
    </message>
    <message>
        <source>Lit if</source>
        <translation>点亮条件</translation>
    </message>
    <message>
        <source>Colour lit</source>
        <translation>点亮颜色</translation>
    </message>
    <message>
        <source>Icon</source>
        <translation>图标</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>开关</translation>
    </message>
    <message>
        <source>Text on</source>
        <translation>接通文本</translation>
    </message>
    <message>
        <source>Text off</source>
        <translation>断开文本</translation>
    </message>
    <message>
        <source>Colour on</source>
        <translation>接通时颜色</translation>
    </message>
    <message>
        <source>Rotary selector</source>
        <translation>旋转选择开关</translation>
    </message>
    <message>
        <source>Check box</source>
        <translation>复选框</translation>
    </message>
    <message>
        <source>Radio group</source>
        <translation>单选组</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Combo box</source>
        <translation>组合框</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>滑块</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Show the value</source>
        <translation>显示数值</translation>
    </message>
    <message>
        <source>Rotary knob</source>
        <translation>旋钮</translation>
    </message>
    <message>
        <source>Numeric entry</source>
        <translation>数值输入</translation>
    </message>
    <message>
        <source>Lowest value</source>
        <translation>最小输入值</translation>
    </message>
    <message>
        <source>Highest value</source>
        <translation>最大输入值</translation>
    </message>
    <message>
        <source>Title of the keypad</source>
        <translation>键盘标题</translation>
    </message>
    <message>
        <source>Text entry</source>
        <translation>文本输入</translation>
    </message>
    <message>
        <source>Longest text</source>
        <translation>最大长度</translation>
    </message>
    <message>
        <source>Masked entry</source>
        <translation>掩码输入</translation>
    </message>
    <message>
        <source>Mask (# digit, A letter, * any)</source>
        <translation>掩码（# 数字，A 字母，* 任意）</translation>
    </message>
    <message>
        <source>Hide the value</source>
        <translation>隐藏数值</translation>
    </message>
    <message>
        <source>Numeric display</source>
        <translation>数值显示</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>边框</translation>
    </message>
    <message>
        <source>Date and time</source>
        <translation>日期和时间</translation>
    </message>
    <message>
        <source>Value (empty: the controller&apos;s clock)</source>
        <translation>值（空：控制器时钟）</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>显示内容</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>指示灯</translation>
    </message>
    <message>
        <source>Blinks when on</source>
        <translation>接通时闪烁</translation>
    </message>
    <message>
        <source>Multi-state indicator</source>
        <translation>多状态指示器</translation>
    </message>
    <message>
        <source>States</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>棒图</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>Tank level</source>
        <translation>罐液位</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>仪表</translation>
    </message>
    <message>
        <source>Span of the scale</source>
        <translation>刻度张角</translation>
    </message>
    <message>
        <source>Divisions</source>
        <translation>刻度分度</translation>
    </message>
    <message>
        <source>7-segment display</source>
        <translation>七段数码管</translation>
    </message>
    <message>
        <source>Digits</source>
        <translation>位数</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>小数位</translation>
    </message>
    <message>
        <source>Leading zeros</source>
        <translation>前导零</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Light tower</source>
        <translation>塔灯</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>灯</translation>
    </message>
    <message>
        <source>Siren if</source>
        <translation>蜂鸣器条件</translation>
    </message>
    <message>
        <source>Float switch</source>
        <translation>浮球开关</translation>
    </message>
    <message>
        <source>Raised if</source>
        <translation>抬起条件</translation>
    </message>
    <message>
        <source>Colour raised</source>
        <translation>抬起颜色</translation>
    </message>
    <message>
        <source>Colour hanging</source>
        <translation>下垂颜色</translation>
    </message>
    <message>
        <source>Cell grid</source>
        <translation>单元格网格</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>数组</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Variable of a cell with [#]</source>
        <translation>单元格变量，含 [#]</translation>
    </message>
    <message>
        <source>On press</source>
        <translation>按下时</translation>
    </message>
    <message>
        <source>First index</source>
        <translation>首个下标</translation>
    </message>
    <message>
        <source>Show the numbers</source>
        <translation>显示编号</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>Index of the selected row</source>
        <translation>所选行的下标</translation>
    </message>
    <message>
        <source>Bar chart</source>
        <translation>条形图</translation>
    </message>
    <message>
        <source>Text list of the bars</source>
        <translation>条形的文本列表</translation>
    </message>
    <message>
        <source>XY chart</source>
        <translation>XY 图表</translation>
    </message>
    <message>
        <source>Array of x</source>
        <translation>x 值数组</translation>
    </message>
    <message>
        <source>Array of y</source>
        <translation>y 值数组</translation>
    </message>
    <message>
        <source>Operating point x</source>
        <translation>工作点 x</translation>
    </message>
    <message>
        <source>Operating point y</source>
        <translation>工作点 y</translation>
    </message>
    <message>
        <source>X from</source>
        <translation>X 起</translation>
    </message>
    <message>
        <source>X to</source>
        <translation>X 止</translation>
    </message>
    <message>
        <source>Y from</source>
        <translation>Y 起</translation>
    </message>
    <message>
        <source>Y to</source>
        <translation>Y 止</translation>
    </message>
    <message>
        <source>Title of x</source>
        <translation>x 轴标题</translation>
    </message>
    <message>
        <source>Title of y</source>
        <translation>y 轴标题</translation>
    </message>
    <message>
        <source>Trend chart</source>
        <translation>趋势图</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Time span in seconds</source>
        <translation>时间跨度（秒）</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>图例</translation>
    </message>
    <message>
        <source>Alarm list</source>
        <translation>报警列表</translation>
    </message>
    <message>
        <source>Only these classes</source>
        <translation>仅这些类别</translation>
    </message>
    <message>
        <source>Sorted by</source>
        <translation>排序方式</translation>
    </message>
    <message>
        <source>Acknowledge buttons</source>
        <translation>确认按钮</translation>
    </message>
    <message>
        <source>Alarm banner</source>
        <translation>报警横幅</translation>
    </message>
    <message>
        <source>Language selector</source>
        <translation>语言选择</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>样式</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>选项卡</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Index of the page</source>
        <translation>页的下标</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Text and pictures</source>
        <translation>文本和图片</translation>
    </message>
    <message>
        <source>Symbols</source>
        <translation>符号</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>操作元素</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>显示元素</translation>
    </message>
    <message>
        <source>Arrays and charts</source>
        <translation>数组和图表</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Containers</source>
        <translation>容器</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>几何</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>外观</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>行为</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Type (a block, a structure, BOOL, REAL, text)</source>
        <translation>类型（块、结构、BOOL、REAL、text）</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>Faceplate</source>
        <translation>面板组件</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>实参</translation>
    </message>
    <message>
        <source>Adapts to the screen by</source>
        <translation>适应屏幕的方式</translation>
    </message>
    <message>
        <source>On a tall screen</source>
        <translation>竖屏时</translation>
    </message>
    <message>
        <source>Shown in the frame</source>
        <translation>在框架中显示</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Panel to show</source>
        <translation>显示的画面</translation>
    </message>
    <message>
        <source>First-out group</source>
        <translation>首出报警组</translation>
    </message>
    <message>
        <source>Horizontal anchor</source>
        <translation>水平锚定</translation>
    </message>
    <message>
        <source>Vertical anchor</source>
        <translation>垂直锚定</translation>
    </message>
    <message>
        <source>Only for the roles</source>
        <translation>仅限角色</translation>
    </message>
    <message>
        <source>For all others</source>
        <translation>对其他人</translation>
    </message>
    <message>
        <source>Writes are confirmed</source>
        <translation>写入需确认</translation>
    </message>
    <message>
        <source>Navigation bar</source>
        <translation>导航栏</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>User</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Alarm statistics</source>
        <translation>报警统计</translation>
    </message>
    <message>
        <source>Hours to look back</source>
        <translation>统计的小时数</translation>
    </message>
    <message>
        <source>Panel area</source>
        <translation>画面区域</translation>
    </message>
    <message>
        <source>Share of the remaining space</source>
        <translation>占剩余空间的份额</translation>
    </message>
    <message>
        <source>Column span in a grid</source>
        <translation>网格中占用的列数</translation>
    </message>
    <message>
        <source>Closed if</source>
        <translation>关闭条件</translation>
    </message>
    <message>
        <source>In transit if</source>
        <translation>动作中条件</translation>
    </message>
    <message>
        <source>In manual mode if</source>
        <translation>手动条件</translation>
    </message>
    <message>
        <source>Out of service if</source>
        <translation>停用条件</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>布局</translation>
    </message>
    <message>
        <source>Columns (0: as many as fit)</source>
        <translation>列数（0：尽可能多）</translation>
    </message>
    <message>
        <source>Smallest column</source>
        <translation>最小列宽</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>边距</translation>
    </message>
    <message>
        <source>Cross-axis alignment</source>
        <translation>交叉轴对齐</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>所有人</translation>
    </message>
</context>
<context>
    <name>HmiChoices</name>
    <message>
        <source>Dot</source>
        <translation>圆点</translation>
    </message>
    <message>
        <source>Start sign</source>
        <translation>启动符号</translation>
    </message>
    <message>
        <source>Stop sign</source>
        <translation>停止符号</translation>
    </message>
    <message>
        <source>Pause sign</source>
        <translation>暂停符号</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>加号</translation>
    </message>
    <message>
        <source>Minus</source>
        <translation>减号</translation>
    </message>
    <message>
        <source>House</source>
        <translation>房屋</translation>
    </message>
    <message>
        <source>Circular arrow</source>
        <translation>环形箭头</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>时刻</translation>
    </message>
    <message>
        <source>By time</source>
        <translation>按时间</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>实线</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>虚线</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>点线</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>起始端</translation>
    </message>
    <message>
        <source>Centred</source>
        <translation>居中</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>末端</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>高对比度</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>箭头</translation>
    </message>
    <message>
        <source>Arc line</source>
        <translation>弧线</translation>
    </message>
    <message>
        <source>Pie</source>
        <translation>扇形</translation>
    </message>
    <message>
        <source>Chord</source>
        <translation>弓形</translation>
    </message>
    <message>
        <source>Show all of it</source>
        <translation>完整显示</translation>
    </message>
    <message>
        <source>Fill the frame</source>
        <translation>填满边框</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>拉伸</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下</translation>
    </message>
    <message>
        <source>Momentary</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Toggle</source>
        <translation>切换</translation>
    </message>
    <message>
        <source>Set to TRUE</source>
        <translation>设为 TRUE</translation>
    </message>
    <message>
        <source>Set to FALSE</source>
        <translation>设为 FALSE</translation>
    </message>
    <message>
        <source>Write a value</source>
        <translation>写入值</translation>
    </message>
    <message>
        <source>Go to a panel</source>
        <translation>转到画面</translation>
    </message>
    <message>
        <source>Change the language</source>
        <translation>切换语言</translation>
    </message>
    <message>
        <source>Acknowledge alarms</source>
        <translation>确认报警</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>垂直</translation>
    </message>
    <message>
        <source>Date and time of day</source>
        <translation>日期和时刻</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Calendar week</source>
        <translation>日历周</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>圆形</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>方形</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>圆角</translation>
    </message>
    <message>
        <source>Dished ends</source>
        <translation>椭圆封头</translation>
    </message>
    <message>
        <source>Flat ends</source>
        <translation>平底</translation>
    </message>
    <message>
        <source>Hopper</source>
        <translation>料斗</translation>
    </message>
    <message>
        <source>Open at the top</source>
        <translation>顶部敞开</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Present alarms</source>
        <translation>当前报警</translation>
    </message>
    <message>
        <source>Alarm history</source>
        <translation>报警历史</translation>
    </message>
    <message>
        <source>By priority</source>
        <translation>按优先级</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>按钮</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>菜单</translation>
    </message>
    <message>
        <source>In their own language</source>
        <translation>用各自的语言</translation>
    </message>
    <message>
        <source>Language tags</source>
        <translation>语言标签</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>电机</translation>
    </message>
    <message>
        <source>Pump</source>
        <translation>泵</translation>
    </message>
    <message>
        <source>Valve</source>
        <translation>阀</translation>
    </message>
    <message>
        <source>Tank</source>
        <translation>罐</translation>
    </message>
    <message>
        <source>Silo</source>
        <translation>料仓</translation>
    </message>
    <message>
        <source>Conveyor</source>
        <translation>输送带</translation>
    </message>
    <message>
        <source>Agitator</source>
        <translation>搅拌器</translation>
    </message>
    <message>
        <source>Heater</source>
        <translation>加热器</translation>
    </message>
    <message>
        <source>Fan</source>
        <translation>风机</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>Siren</source>
        <translation>警报器</translation>
    </message>
    <message>
        <source>Lorry</source>
        <translation>卡车</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>小车</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Raised surface</source>
        <translation>凸起表面</translation>
    </message>
    <message>
        <source>Sunken surface</source>
        <translation>凹陷表面</translation>
    </message>
    <message>
        <source>Line colour</source>
        <translation>线条颜色</translation>
    </message>
    <message>
        <source>Faint line</source>
        <translation>浅色线</translation>
    </message>
    <message>
        <source>Text colour</source>
        <translation>文本颜色</translation>
    </message>
    <message>
        <source>Muted text</source>
        <translation>弱化文本</translation>
    </message>
    <message>
        <source>Button colour</source>
        <translation>按钮颜色</translation>
    </message>
    <message>
        <source>Accent</source>
        <translation>强调色</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Liquid</source>
        <translation>液体</translation>
    </message>
    <message>
        <source>Pipe colour</source>
        <translation>管道颜色</translation>
    </message>
    <message>
        <source>Measured value</source>
        <translation>测量值</translation>
    </message>
    <message>
        <source>Lit segment</source>
        <translation>点亮的段</translation>
    </message>
    <message>
        <source>Display glass</source>
        <translation>显示屏玻璃</translation>
    </message>
    <message>
        <source>Alarm colour</source>
        <translation>报警颜色</translation>
    </message>
    <message>
        <source>High priority</source>
        <translation>高优先级</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Low priority</source>
        <translation>低优先级</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>红色</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>橙色</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄色</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿色</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝色</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白色</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>黑色</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>灰色</translation>
    </message>
    <message>
        <source>Good state</source>
        <translation>正常状态</translation>
    </message>
    <message>
        <source>Curve 1</source>
        <translation>曲线 1</translation>
    </message>
    <message>
        <source>Curve 2</source>
        <translation>曲线 2</translation>
    </message>
    <message>
        <source>Curve 3</source>
        <translation>曲线 3</translation>
    </message>
    <message>
        <source>Curve 4</source>
        <translation>曲线 4</translation>
    </message>
    <message>
        <source>Curve 5</source>
        <translation>曲线 5</translation>
    </message>
    <message>
        <source>Curve 6</source>
        <translation>曲线 6</translation>
    </message>
    <message>
        <source>Curve 7</source>
        <translation>曲线 7</translation>
    </message>
    <message>
        <source>Curve 8</source>
        <translation>曲线 8</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>a BOOL</source>
        <translation>BOOL</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>数组</translation>
    </message>
    <message>
        <source>any type</source>
        <translation>任意类型</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>左和右</translation>
    </message>
    <message>
        <source>Top and bottom</source>
        <translation>上和下</translation>
    </message>
    <message>
        <source>Scaling to its size</source>
        <translation>按大小缩放</translation>
    </message>
    <message>
        <source>Moving what is anchored</source>
        <translation>移动已锚定的元素</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>保持比例</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>顶部</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>底部</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Open a panel in a window</source>
        <translation>在窗口中打开画面</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>关闭窗口</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Go to the start panel</source>
        <translation>转到起始画面</translation>
    </message>
    <message>
        <source>Log out</source>
        <translation>退出登录</translation>
    </message>
    <message>
        <source>Shelved alarms</source>
        <translation>搁置的报警</translation>
    </message>
    <message>
        <source>Compressor</source>
        <translation>压缩机</translation>
    </message>
    <message>
        <source>Heat exchanger</source>
        <translation>换热器</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>过滤器</translation>
    </message>
    <message>
        <source>Centrifuge</source>
        <translation>离心机</translation>
    </message>
    <message>
        <source>Control valve</source>
        <translation>调节阀</translation>
    </message>
    <message>
        <source>Three-way valve</source>
        <translation>三通阀</translation>
    </message>
    <message>
        <source>Boiler</source>
        <translation>锅炉</translation>
    </message>
    <message>
        <source>Cooling tower</source>
        <translation>冷却塔</translation>
    </message>
    <message>
        <source>Filler</source>
        <translation>灌装机</translation>
    </message>
    <message>
        <source>Carton</source>
        <translation>纸箱</translation>
    </message>
    <message>
        <source>Pallet</source>
        <translation>托盘</translation>
    </message>
    <message>
        <source>Roller conveyor</source>
        <translation>辊道输送机</translation>
    </message>
    <message>
        <source>Bucket elevator</source>
        <translation>斗式提升机</translation>
    </message>
    <message>
        <source>Screw conveyor</source>
        <translation>螺旋输送机</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>转盘</translation>
    </message>
    <message>
        <source>Gantry</source>
        <translation>龙门架</translation>
    </message>
    <message>
        <source>SCARA robot</source>
        <translation>SCARA 机器人</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>夹爪</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>门</translation>
    </message>
    <message>
        <source>Damper</source>
        <translation>风门</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>建筑物</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Row if wide, column if tall</source>
        <translation>宽时为行，高时为列</translation>
    </message>
    <message>
        <source>Filling it</source>
        <translation>填满</translation>
    </message>
    <message>
        <source>Change the theme</source>
        <translation>切换主题</translation>
    </message>
    <message>
        <source>Light bulb</source>
        <translation>灯泡</translation>
    </message>
</context>
<context>
    <name>Inside</name>
    <message>
        <source>set by {0}  {1} ({2}, task {3})</source>
        <translation>由 {0}  {1} 设置（{2}，任务 {3}）</translation>
    </message>
    <message>
        <source>set by {0}  {1} ({2})</source>
        <translation>由 {0}  {1} 设置（{2}）</translation>
    </message>
    <message>
        <source>set by code that the compiler adds ({0})</source>
        <translation>由编译器添加的代码设置（{0}）</translation>
    </message>
    <message>
        <source>written from outside</source>
        <translation>从外部写入</translation>
    </message>
    <message>
        <source>written from {0}</source>
        <translation>从{0}写入</translation>
    </message>
    <message>
        <source>forced</source>
        <translation>已强制</translation>
    </message>
    <message>
        <source>forced from {0}</source>
        <translation>从{0}强制</translation>
    </message>
    <message>
        <source>put back by a reset</source>
        <translation>因复位恢复</translation>
    </message>
    <message>
        <source>carried over by an online change</source>
        <translation>在线修改时保留</translation>
    </message>
    <message>
        <source>restored from the retained values</source>
        <translation>由保持值恢复</translation>
    </message>
    <message>
        <source>its initial value</source>
        <translation>其初始值</translation>
    </message>
    <message>
        <source>put into the safe state when the controller stopped</source>
        <translation>控制器停止时置于安全状态</translation>
    </message>
    <message>
        <source>as recorded in the scan that was resumed from</source>
        <translation>如继续运行的起始扫描周期所记录</translation>
    </message>
    <message>
        <source>set by a statement of a test</source>
        <translation>由测试的语句设置</translation>
    </message>
    <message>
        <source>origin not known</source>
        <translation>来源未知</translation>
    </message>
    <message>
        <source>the command line</source>
        <translation>命令行</translation>
    </message>
    <message>
        <source>the studio</source>
        <translation>开发环境</translation>
    </message>
    <message>
        <source>panel {0}, {1}</source>
        <translation>画面 {0}，{1}</translation>
    </message>
    <message>
        <source>{0} (scan {1})</source>
        <translation>{0}（扫描周期 {1}）</translation>
    </message>
    <message>
        <source>{0} µs</source>
        <translation>{0} µs</translation>
    </message>
    <message>
        <source>{0} s</source>
        <translation>{0} s</translation>
    </message>
    <message>
        <source>{0} min {1} s</source>
        <translation>{0} min {1} s</translation>
    </message>
    <message>
        <source>{0}  {1} from {2} to {3}, {4}</source>
        <translation>{0}  {1} 从 {2} 变为 {3}，{4}</translation>
    </message>
    <message>
        <source>{0}  {1} to {2}, {3}</source>
        <translation>{0}  {1} 变为 {2}，{3}</translation>
    </message>
    <message>
        <source>called by {0}  {1}</source>
        <translation>由 {0}  {1} 调用</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}, since {3}.</source>
        <translation>{0} 在 {2} 为 {1}，自 {3} 起。</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}, as it was when the recording began.</source>
        <translation>{0} 在 {2} 为 {1}，与记录开始时相同。</translation>
    </message>
    <message>
        <source>{0} is {1} at {2}.</source>
        <translation>{0} 在 {2} 为 {1}。</translation>
    </message>
    <message>
        <source>It was {0}.</source>
        <translation>该值{0}。</translation>
    </message>
    <message>
        <source>It has its initial value.</source>
        <translation>变量为其初始值。</translation>
    </message>
    <message>
        <source>It became {0} because</source>
        <translation>它变为 {0}，因为</translation>
    </message>
    <message>
        <source>This needed</source>
        <translation>所需条件</translation>
    </message>
    <message>
        <source>It needs</source>
        <translation>需要</translation>
    </message>
    <message>
        <source>It stays so because</source>
        <translation>它保持不变，因为</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>逐步说明</translation>
    </message>
    <message>
        <source>because</source>
        <translation>因为</translation>
    </message>
    <message>
        <source>time passed.</source>
        <translation>时间已过去。</translation>
    </message>
    <message>
        <source>it was the first scan.</source>
        <translation>这是第一个扫描周期。</translation>
    </message>
    <message>
        <source>other variables were forced.</source>
        <translation>其他变量被强制。</translation>
    </message>
    <message>
        <source>{0} became {1}.</source>
        <translation>{0} 变为 {1}。</translation>
    </message>
    <message>
        <source>{0} became {1}, {2}.</source>
        <translation>{0} 变为 {1}，{2}。</translation>
    </message>
    <message>
        <source>{0} changed.</source>
        <translation>{0} 发生变化。</translation>
    </message>
    <message>
        <source>{0} changed, {1}.</source>
        <translation>{0} 发生变化，{1}。</translation>
    </message>
    <message>
        <source>{0} was {1}.</source>
        <translation>{0} 为 {1}。</translation>
    </message>
    <message>
        <source>{0} was {1} since {2}, {3}.</source>
        <translation>{0} 自 {2} 起为 {1}，{3}。</translation>
    </message>
    <message>
        <source>{0}   → {1}</source>
        <translation>{0}   → {1}</translation>
    </message>
    <message>
        <source>it ran because {0} was {1}</source>
        <translation>已执行，因为 {0} 为 {1}</translation>
    </message>
    <message>
        <source>nothing wrote it later because {0} was {1}</source>
        <translation>之后未再写入，因为 {0} 为 {1}</translation>
    </message>
    <message>
        <source>a statement that would write it did not run because {0} was {1}</source>
        <translation>本会写入它的语句未执行，因为 {0} 为 {1}</translation>
    </message>
    <message>
        <source>{0} ({1})</source>
        <translation>{0}（{1}）</translation>
    </message>
    <message>
        <source>{0}</source>
        <translation>{0}</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}：{1}</translation>
    </message>
    <message>
        <source>{0} was {1} when the scan began</source>
        <translation>扫描周期开始时 {0} 为 {1}</translation>
    </message>
    <message>
        <source>{0}   {1}</source>
        <translation>{0}   {1}</translation>
    </message>
    <message>
        <source>its time of {0} has elapsed</source>
        <translation>其时间 {0} 已到</translation>
    </message>
    <message>
        <source>it does not run</source>
        <translation>未运行</translation>
    </message>
    <message>
        <source>it has run {0} of {1}, {2} to go</source>
        <translation>已运行 {0} / {1}，还剩 {2}</translation>
    </message>
    <message>
        <source>it has counted {0} of {1}</source>
        <translation>已计数 {0} / {1}</translation>
    </message>
    <message>
        <source>No change of up to three variables makes it {0} in this scan.</source>
        <translation>在此扫描周期中，更改至多三个变量都不能使它变为 {0}。</translation>
    </message>
    <message>
        <source>It would be {0} if {1}.</source>
        <translation>如果 {1}，它将为 {0}。</translation>
    </message>
    <message>
        <source>It would also be {0} if {1}.</source>
        <translation>如果 {1}，它也将为 {0}。</translation>
    </message>
    <message>
        <source>{0} were {1} (it is {2})</source>
        <translation>{0} 为 {1}（现为 {2}）</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} 且 {1}</translation>
    </message>
    <message>
        <source>What keeps it {0}</source>
        <translation>使其保持 {0} 的原因</translation>
    </message>
    <message>
        <source>Note: {0}.</source>
        <translation>注意：{0}。</translation>
    </message>
    <message>
        <source>recorded by an earlier version, which kept no journal</source>
        <translation>由不保存日志的早期版本记录</translation>
    </message>
    <message>
        <source>it was written to while it was halted at a breakpoint</source>
        <translation>停在断点期间有写入</translation>
    </message>
    <message>
        <source>the scan did more than can be kept: only its beginning is known</source>
        <translation>该扫描周期的内容超出可保留的范围：只知道其开头部分</translation>
    </message>
    <message>
        <source>the scan had a different result when it was run again</source>
        <translation>重新运行时该扫描周期的结果不同</translation>
    </message>
    <message>
        <source>it has no value in this scan: {0}</source>
        <translation>在此扫描周期中没有值：{0}</translation>
    </message>
    <message>
        <source>&quot;Why not?&quot; needs a condition (BOOL), for example &quot;Main.level &gt; 80&quot;</source>
        <translation>“为什么不”需要条件 (BOOL)，例如“Main.level &gt; 80”</translation>
    </message>
    <message>
        <source>the program was not built from sources; open its project</source>
        <translation>程序不是由源文件编译的；请打开其项目</translation>
    </message>
    <message>
        <source>this scan is not in the recording</source>
        <translation>此扫描周期不在记录中</translation>
    </message>
    <message>
        <source>it does not change in this recording</source>
        <translation>在此记录中没有变化</translation>
    </message>
    <message>
        <source>nothing wrote it in this scan</source>
        <translation>在此扫描周期中未写入</translation>
    </message>
    <message>
        <source>no statement of the project ran in this scan</source>
        <translation>在此扫描周期中没有执行项目的任何语句</translation>
    </message>
    <message>
        <source>never {0}</source>
        <translation>从未为 {0}</translation>
    </message>
    <message>
        <source>missing: {0}</source>
        <translation>缺少：{0}</translation>
    </message>
    <message>
        <source>not run</source>
        <translation>未执行</translation>
    </message>
    <message>
        <source>run {0} {0:time|times}</source>
        <translation>已执行 {0} 次</translation>
    </message>
</context>
<context>
    <name>LongTask</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>Loops</name>
    <message>
        <source>The program has no controller block; name the signals with --input and --output</source>
        <translation>程序没有控制器块；请用 --input 和 --output 指定信号</translation>
    </message>
    <message>
        <source>There is no loop {0}; the program has {1}</source>
        <translation>没有回路 {0}；程序有 {1}</translation>
    </message>
    <message>
        <source>{0} is the name of several loops; give the whole name of one: {1}</source>
        <translation>有多个回路名为 {0}；请给出其中一个的完整名称：{1}</translation>
    </message>
    <message>
        <source>The recording contains no program that knows it; choose a loop of the open program</source>
        <translation>记录中的程序都不包含它；请选择打开的程序中的回路</translation>
    </message>
    <message>
        <source>It is not a number and cannot be a signal of a loop; name a variable of type REAL or INT</source>
        <translation>它不是数字，不能作为回路的信号；请指定 REAL 或 INT 类型的变量</translation>
    </message>
    <message>
        <source>This range is no longer recorded, or the program was changed in it; choose another one</source>
        <translation>此区间不再有记录，或程序在其中被更改；请选择其他区间</translation>
    </message>
    <message>
        <source>{0} gets an expression in the call; give the measured value a variable of its own to try settings</source>
        <translation>{0} 在调用中得到表达式；请为测量值建立单独的变量以试验参数</translation>
    </message>
    <message>
        <source>The call has constants; settings in their place can only be tried on the recording of the running controller</source>
        <translation>调用中含有常量；只能在运行中控制器的记录上试用替代它们的参数</translation>
    </message>
</context>
<context>
    <name>MarkText</name>
    <message>
        <source>Started</source>
        <translation>已启动</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>复位</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>已写入</translation>
    </message>
    <message>
        <source>Forced</source>
        <translation>已强制</translation>
    </message>
    <message>
        <source>All forces released</source>
        <translation>已解除全部强制</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>已解除强制</translation>
    </message>
    <message>
        <source>Online change</source>
        <translation>在线修改</translation>
    </message>
    <message>
        <source>Breakpoint</source>
        <translation>断点</translation>
    </message>
    <message>
        <source>Retained values saved</source>
        <translation>保持值已保存</translation>
    </message>
    <message>
        <source>Retained values restored</source>
        <translation>保持值已恢复</translation>
    </message>
    <message numerus="yes">
        <source>%n scan(s) skipped: the machine was late</source>
        <translation>
            <numerusform>跳过了 %n 个扫描周期：计算机未能及时处理</numerusform>
        </translation>
    </message>
    <message>
        <source>Resumed from this scan</source>
        <translation>已从此扫描周期继续</translation>
    </message>
</context>
<context>
    <name>Notes</name>
    <message>
        <source>first declared here</source>
        <translation>首次在此处声明</translation>
    </message>
    <message>
        <source>declared here</source>
        <translation>在此处声明</translation>
    </message>
    <message>
        <source>the variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>the first program</source>
        <translation>第一个程序</translation>
    </message>
    <message>
        <source>overridden here</source>
        <translation>在此处重写</translation>
    </message>
    <message>
        <source>the first one</source>
        <translation>第一个</translation>
    </message>
    <message>
        <source>by this transition, while it is active</source>
        <translation>经由此转换，在其激活期间</translation>
    </message>
    <message>
        <source>comments nest: the next *) closes the one that begins here</source>
        <translation>注释可以嵌套：下一个 *) 结束此处开始的注释</translation>
    </message>
</context>
<context>
    <name>Phrases</name>
    <message>
        <source>a name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>a label</source>
        <translation>标号</translation>
    </message>
    <message>
        <source>an operand</source>
        <translation>操作数</translation>
    </message>
    <message>
        <source>an expression</source>
        <translation>表达式</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>a type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>an index</source>
        <translation>下标</translation>
    </message>
    <message>
        <source>an argument</source>
        <translation>实参</translation>
    </message>
    <message>
        <source>an address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>an action</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>a CASE label</source>
        <translation>CASE 标号</translation>
    </message>
    <message>
        <source>a block&apos;s name</source>
        <translation>块的名称</translation>
    </message>
    <message>
        <source>a processor&apos;s name</source>
        <translation>处理器的名称</translation>
    </message>
    <message>
        <source>a task&apos;s name</source>
        <translation>任务的名称</translation>
    </message>
    <message>
        <source>a program instance&apos;s name</source>
        <translation>程序实例的名称</translation>
    </message>
    <message>
        <source>an input or output</source>
        <translation>输入或输出</translation>
    </message>
    <message>
        <source>a variable&apos;s name</source>
        <translation>变量的名称</translation>
    </message>
    <message>
        <source>a variable&apos;s path</source>
        <translation>变量的路径</translation>
    </message>
    <message>
        <source>a step&apos;s name</source>
        <translation>步的名称</translation>
    </message>
    <message>
        <source>a type&apos;s name</source>
        <translation>类型的名称</translation>
    </message>
    <message>
        <source>a member&apos;s name</source>
        <translation>成员的名称</translation>
    </message>
    <message>
        <source>an access name</source>
        <translation>访问名称</translation>
    </message>
    <message>
        <source>an enumeration value</source>
        <translation>枚举值</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>行尾</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>文件结尾</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} 或 {1}</translation>
    </message>
    <message>
        <source>FOR and a time</source>
        <translation>FOR 和时间</translation>
    </message>
    <message>
        <source>:= or instructions</source>
        <translation>:= 或语句</translation>
    </message>
    <message>
        <source>a subrange</source>
        <translation>子范围</translation>
    </message>
    <message>
        <source>an enumeration</source>
        <translation>枚举</translation>
    </message>
    <message>
        <source>in parentheses</source>
        <translation>在括号中</translation>
    </message>
    <message>
        <source>a chart</source>
        <translation>顺序功能图</translation>
    </message>
    <message>
        <source>a body</source>
        <translation>主体</translation>
    </message>
    <message>
        <source>in a CLASS</source>
        <translation>CLASS 中</translation>
    </message>
    <message>
        <source>in a FUNCTION</source>
        <translation>FUNCTION 中</translation>
    </message>
    <message>
        <source>in a METHOD</source>
        <translation>METHOD 中</translation>
    </message>
    <message>
        <source>in a PROGRAM</source>
        <translation>PROGRAM 中</translation>
    </message>
    <message>
        <source>in a FUNCTION_BLOCK</source>
        <translation>FUNCTION_BLOCK 中</translation>
    </message>
    <message>
        <source>here</source>
        <translation>此处</translation>
    </message>
    <message>
        <source>{0} {0:character|characters}</source>
        <translation>{0} 个字符</translation>
    </message>
    <message>
        <source>{0} {0:byte|bytes} in UTF-8</source>
        <translation>{0} 个字节（UTF-8）</translation>
    </message>
    <message>
        <source>in {0}</source>
        <translation>{0} 中</translation>
    </message>
    <message>
        <source>in an expression</source>
        <translation>表达式中</translation>
    </message>
    <message>
        <source>in an initial value</source>
        <translation>初始值中</translation>
    </message>
    <message>
        <source>in this section</source>
        <translation>此区段中</translation>
    </message>
    <message>
        <source>an initial value</source>
        <translation>初始值</translation>
    </message>
    <message>
        <source>RETURN with a value</source>
        <translation>带值的 RETURN</translation>
    </message>
    <message>
        <source>in a declaration that calls FB_Init</source>
        <translation>调用 FB_Init 的声明中</translation>
    </message>
    <message>
        <source>{0} (VAR_IN_OUT)</source>
        <translation>{0} (VAR_IN_OUT)</translation>
    </message>
    <message>
        <source>in {0}, which is not abstract itself</source>
        <translation>本身不是抽象的 {0} 中</translation>
    </message>
    <message>
        <source>address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>time of day</source>
        <translation>时刻</translation>
    </message>
    <message>
        <source>date and time</source>
        <translation>日期和时间</translation>
    </message>
    <message>
        <source>integer</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>string</source>
        <translation>字符串</translation>
    </message>
    <message>
        <source>{0} (a constant)</source>
        <translation>{0}（常量）</translation>
    </message>
    <message>
        <source>{0} (an output)</source>
        <translation>{0}（输出）</translation>
    </message>
    <message>
        <source>{0} (a local variable of {1})</source>
        <translation>{0}（{1} 的局部变量）</translation>
    </message>
    <message>
        <source>{0} (an input)</source>
        <translation>{0}（输入）</translation>
    </message>
    <message>
        <source>{0} (an input; the next scan overwrites it)</source>
        <translation>{0}（输入；下一个扫描周期会覆盖它）</translation>
    </message>
    <message>
        <source>{0} (a property without SET)</source>
        <translation>{0}（没有 SET 的属性）</translation>
    </message>
    <message>
        <source>{0} (no instance, or several)</source>
        <translation>{0}（没有实例，或有多个）</translation>
    </message>
    <message>
        <source>{0} (a type; declare an instance of it)</source>
        <translation>{0}（类型；请声明其实例）</translation>
    </message>
    <message>
        <source>{0} (a variable, which hides the function of this name)</source>
        <translation>{0}（变量，隐藏了同名函数）</translation>
    </message>
    <message>
        <source>an output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>an input</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>an IN_OUT parameter</source>
        <translation>IN_OUT 参数</translation>
    </message>
    <message>
        <source>a power of a computed number</source>
        <translation>计算值的幂</translation>
    </message>
    <message>
        <source>a call of {0}</source>
        <translation>对 {0} 的调用</translation>
    </message>
    <message>
        <source>a call without arguments</source>
        <translation>不带实参的调用</translation>
    </message>
    <message>
        <source>a computed second argument of {0}</source>
        <translation>{0} 的第二个实参为计算值</translation>
    </message>
    <message>
        <source>{0} outside a loop</source>
        <translation>循环外的 {0}</translation>
    </message>
    <message>
        <source>this statement</source>
        <translation>此语句</translation>
    </message>
    <message>
        <source>FOR with this end or step</source>
        <translation>带此终值或步长的 FOR</translation>
    </message>
    <message>
        <source>an assignment of several variables</source>
        <translation>对多个变量的赋值</translation>
    </message>
    <message>
        <source>CASE of a computed value</source>
        <translation>对计算值的 CASE</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a number of seconds</source>
        <translation>秒数</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>one of {0}</source>
        <translation>{0} 之一</translation>
    </message>
</context>
<context>
    <name>PlotText</name>
    <message>
        <source>no longer kept</source>
        <translation>不再保留</translation>
    </message>
    <message>
        <source>did not exist</source>
        <translation>当时不存在</translation>
    </message>
    <message>
        <source>scans skipped</source>
        <translation>跳过的扫描周期</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>未记录</translation>
    </message>
    <message>
        <source>Time [%1]</source>
        <translation>时间 [%1]</translation>
    </message>
    <message>
        <source>Time from the trigger [%1]</source>
        <translation>触发后的时间 [%1]</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>At A</source>
        <translation>A 处</translation>
    </message>
    <message>
        <source>At B</source>
        <translation>B 处</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>有效值</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>上升时间</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>调节时间</translation>
    </message>
</context>
<context>
    <name>Remote</name>
    <message>
        <source>The request is not understood; studio and controller may be of different versions</source>
        <translation>无法理解该请求；开发环境与控制器的版本可能不同</translation>
    </message>
    <message>
        <source>There is no request {0}; studio and controller may be of different versions</source>
        <translation>没有请求 {0}；开发环境与控制器的版本可能不同</translation>
    </message>
    <message>
        <source>Breakpoints stop a machine in the middle of a scan; `stepwise serve` allows them with --allow-breakpoints</source>
        <translation>断点会使机器停在扫描周期中间；“stepwise serve”可用 --allow-breakpoints 允许断点</translation>
    </message>
    <message>
        <source>{0} is forced; release it before writing</source>
        <translation>{0} 已被强制；写入前请取消强制</translation>
    </message>
    <message>
        <source>{0} is not forced; there is nothing to release</source>
        <translation>{0} 未被强制；没有可解除的强制</translation>
    </message>
    <message>
        <source>Another program is being built for this controller; try again when it is loaded</source>
        <translation>正在为此控制器编译另一个程序；请在其载入后重试</translation>
    </message>
    <message>
        <source>The program has {0} {0:error|errors}; correct them: the controller continues with the old program until then</source>
        <translation>程序有 {0} 个错误；请更正：在此之前控制器继续运行旧程序</translation>
    </message>
    <message>
        <source>The controller&apos;s program has no file {0}; load its program again</source>
        <translation>控制器的程序中没有文件 {0}；请重新加载其程序</translation>
    </message>
    <message>
        <source>A recording is already being downloaded; wait until it is complete</source>
        <translation>正在下载一个记录；请等待其完成</translation>
    </message>
    <message>
        <source>A served controller cannot be resumed from an earlier scan; download its recording and resume from there</source>
        <translation>作为服务运行的控制器不能从较早的扫描周期继续；请下载其记录并从那里继续</translation>
    </message>
    <message>
        <source>{0} is not the address of a controller; write for example https://plant:8443/</source>
        <translation>{0} 不是控制器的地址；例如请写 https://plant:8443/</translation>
    </message>
    <message>
        <source>{0} rejects the connection: {1}</source>
        <translation>{0} 拒绝连接：{1}</translation>
    </message>
    <message>
        <source>The code is wrong; it is in the file attach-code of the controller&apos;s state folder</source>
        <translation>代码错误；代码在控制器状态文件夹的 attach-code 文件中</translation>
    </message>
    <message>
        <source>There were too many wrong codes from this computer; wait a minute</source>
        <translation>此计算机输入错误代码的次数过多；请等待一分钟</translation>
    </message>
    <message>
        <source>The code would be sent over the network unencrypted; use an https address, and start the controller with --certificate</source>
        <translation>代码将在网络上明文传输；请使用 https 地址，并用 --certificate 启动控制器</translation>
    </message>
    <message>
        <source>The certificate of {0} is not trusted: {1}; name the file of the certificate that you trust</source>
        <translation>{0} 的证书不受信任：{1}；请指定所信任的证书文件</translation>
    </message>
    <message>
        <source>The certificate cannot be read from {0}; it must be a PEM file</source>
        <translation>无法从 {0} 读取证书；必须是 PEM 文件</translation>
    </message>
    <message>
        <source>The connection to {0} is lost; check the network and the controller</source>
        <translation>与 {0} 的连接已断开；请检查网络和控制器</translation>
    </message>
    <message>
        <source>{0} does not answer; check the address and whether the controller runs</source>
        <translation>{0} 没有应答；请检查地址以及控制器是否运行</translation>
    </message>
    <message>
        <source>The controller&apos;s program cannot be built here as it is there; use the same version of Stepwise on both sides</source>
        <translation>控制器的程序无法在此处按其原样编译；请两侧使用相同版本的 Stepwise</translation>
    </message>
    <message>
        <source>{0} speaks TLS on this port; use the address {1}</source>
        <translation>{0} 在此端口使用 TLS；请使用地址 {1}</translation>
    </message>
    <message>
        <source>{0} cannot be reached: {1}; check the address and the network</source>
        <translation>无法访问 {0}：{1}；请检查地址和网络</translation>
    </message>
    <message>
        <source>Nothing answers at {0}; check the port, and whether `stepwise serve` runs there</source>
        <translation>{0} 没有响应；请检查端口，以及“stepwise serve”是否在那里运行</translation>
    </message>
    <message>
        <source>There is no computer named {0}; check the name in the address</source>
        <translation>没有名为 {0} 的计算机；请检查地址中的名称</translation>
    </message>
    <message>
        <source>The server at {0} is not a controller started with `stepwise serve`; check the host and the port</source>
        <translation>{0} 处的服务器不是用“stepwise serve”启动的控制器；请检查主机和端口</translation>
    </message>
    <message>
        <source>The server at {0} does not speak TLS; start the controller with --certificate, or use an http address on the same computer</source>
        <translation>{0} 处的服务器不支持 TLS；请用 --certificate 启动控制器，或在同一台计算机上使用 http 地址</translation>
    </message>
</context>
<context>
    <name>Storage</name>
    <message>
        <source>{0} does not have the character {1}; write the file as UTF-8</source>
        <translation>{0} 中没有字符 {1}；请将文件保存为 UTF-8</translation>
    </message>
    <message>
        <source>The encoding {0} is not known; choose one of {1}</source>
        <translation>未知编码 {0}；请从 {1} 中选择</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; must be a list of names; write them in quotes, in square brackets</source>
        <translation>“{0}”必须是名称列表；请将名称加引号，放在方括号中</translation>
    </message>
</context>
<context>
    <name>TraceText</name>
    <message>
        <source>Triggered at %1.</source>
        <translation>在 %1 触发。</translation>
    </message>
    <message>
        <source>The trigger did not fire.</source>
        <translation>触发器未触发。</translation>
    </message>
</context>
<context>
    <name>Tuning</name>
    <message>
        <source>{0} {0:sample is|samples are} too few for a model; record for longer</source>
        <translation>{0} 个采样不足以建立模型；请记录更长时间</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>可用</translation>
    </message>
    <message>
        <source>the input is at a limit for {0} % of the time</source>
        <translation>输入有 {0} % 的时间处于限值</translation>
    </message>
    <message>
        <source>the output moves by only {0} times its noise</source>
        <translation>输出的变化仅为其噪声的 {0} 倍</translation>
    </message>
    <message>
        <source>too short: {0} {0:sample|samples} until the next change or the end</source>
        <translation>过短：到下一次变化或记录结束只有 {0} 个采样</translation>
    </message>
    <message>
        <source>disturbed: no model explains more than {0} % of it</source>
        <translation>受干扰：没有模型能解释其 {0} % 以上</translation>
    </message>
    <message>
        <source>usable; not at rest before it</source>
        <translation>可用；之前尚未稳定</translation>
    </message>
    <message>
        <source>There is no step or disturbance in the recording; change the set point or the output once and record the response</source>
        <translation>记录中没有阶跃或扰动；请改变一次设定值或输出，并记录响应</translation>
    </message>
    <message>
        <source>None of the {0} changes found is usable: {1}</source>
        <translation>找到的 {0} 处变化均不可用：{1}</translation>
    </message>
    <message>
        <source>No model explains the output; something else affects it</source>
        <translation>没有模型能解释输出的变化；有其他因素在影响它</translation>
    </message>
    <message>
        <source>The rule {0} does not apply to this process; choose another one</source>
        <translation>规则 {0} 不适合此过程；请选择其他规则</translation>
    </message>
    <message>
        <source>Unstable: the oscillation would grow. Do not use these settings.</source>
        <translation>不稳定：振荡会不断增大。请勿使用这些参数。</translation>
    </message>
    <message>
        <source>Fragile: a small change of the process makes it oscillate.</source>
        <translation>脆弱：过程的微小变化就会引起振荡。</translation>
    </message>
    <message>
        <source>Brisk: fast, with slight oscillation; the process should not change much.</source>
        <translation>敏捷：快速，略有振荡；过程不应有大的变化。</translation>
    </message>
    <message>
        <source>Good: fast enough, and tolerant of the usual process changes.</source>
        <translation>良好：足够快，并能承受过程的一般变化。</translation>
    </message>
    <message>
        <source>Calm: slow, and tolerant of large process changes.</source>
        <translation>平稳：较慢，能承受变化很大的过程。</translation>
    </message>
    <message>
        <source>A step of the set point does not overshoot.</source>
        <translation>设定值阶跃没有超调。</translation>
    </message>
    <message>
        <source>A step of the set point overshoots by {0} %.</source>
        <translation>设定值阶跃的超调为 {0} %。</translation>
    </message>
    <message>
        <source>Ziegler-Nichols is included for comparison: it oscillates and tolerates little change. Use SIMC or the optimum instead.</source>
        <translation>Ziegler-Nichols 仅供比较：它会振荡，容差很小。请改为使用 SIMC 或最优值。</translation>
    </message>
    <message>
        <source>The rule considers only one lag; check the margins.</source>
        <translation>该规则只考虑一个惯性环节；请检查裕度。</translation>
    </message>
    <message>
        <source>gain and dead time</source>
        <translation>增益和纯滞后</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>一阶</translation>
    </message>
    <message>
        <source>first order with dead time</source>
        <translation>一阶加纯滞后</translation>
    </message>
    <message>
        <source>second order</source>
        <translation>二阶</translation>
    </message>
    <message>
        <source>second order with dead time</source>
        <translation>二阶加纯滞后</translation>
    </message>
    <message>
        <source>two equal lags</source>
        <translation>两个相等的惯性环节</translation>
    </message>
    <message>
        <source>two equal lags with dead time</source>
        <translation>两个相等的惯性环节加纯滞后</translation>
    </message>
    <message>
        <source>oscillating</source>
        <translation>振荡</translation>
    </message>
    <message>
        <source>oscillating with dead time</source>
        <translation>振荡加纯滞后</translation>
    </message>
    <message>
        <source>oscillating with a lag</source>
        <translation>振荡加一个惯性环节</translation>
    </message>
    <message>
        <source>second order with a zero</source>
        <translation>二阶加零点</translation>
    </message>
    <message>
        <source>second order with a zero and dead time</source>
        <translation>二阶加零点和纯滞后</translation>
    </message>
    <message>
        <source>three equal lags</source>
        <translation>三个相等的惯性环节</translation>
    </message>
    <message>
        <source>three equal lags with a zero</source>
        <translation>三个相等的惯性环节加零点</translation>
    </message>
    <message>
        <source>four equal lags</source>
        <translation>四个相等的惯性环节</translation>
    </message>
    <message>
        <source>five equal lags</source>
        <translation>五个相等的惯性环节</translation>
    </message>
    <message>
        <source>six equal lags</source>
        <translation>六个相等的惯性环节</translation>
    </message>
    <message>
        <source>seven equal lags</source>
        <translation>七个相等的惯性环节</translation>
    </message>
    <message>
        <source>eight equal lags</source>
        <translation>八个相等的惯性环节</translation>
    </message>
    <message>
        <source>three equal lags with dead time</source>
        <translation>三个相等的惯性环节加纯滞后</translation>
    </message>
    <message>
        <source>three lags</source>
        <translation>三个惯性环节</translation>
    </message>
    <message>
        <source>three lags with dead time</source>
        <translation>三个惯性环节加纯滞后</translation>
    </message>
    <message>
        <source>four lags</source>
        <translation>四个惯性环节</translation>
    </message>
    <message>
        <source>integrating</source>
        <translation>积分</translation>
    </message>
    <message>
        <source>integrating with dead time</source>
        <translation>积分加纯滞后</translation>
    </message>
    <message>
        <source>integrating with a lag</source>
        <translation>积分加一个惯性环节</translation>
    </message>
    <message>
        <source>integrating with a lag and dead time</source>
        <translation>积分加一个惯性环节和纯滞后</translation>
    </message>
    <message>
        <source>integrating with two equal lags</source>
        <translation>积分加两个相等的惯性环节</translation>
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
        <translation>最优</translation>
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
        <translation>记录中有间断</translation>
    </message>
    <message>
        <source>It oscillates with a period of {0} s and an amplitude of {1}, for {2} cycles in a row.</source>
        <translation>以周期 {0} s、幅值 {1} 振荡，连续 {2} 个周期。</translation>
    </message>
    <message>
        <source>It does not oscillate.</source>
        <translation>没有振荡。</translation>
    </message>
    <message>
        <source>The settings are the likely cause: with the model, the loop oscillates with this period.</source>
        <translation>原因可能是参数设置：按模型，回路会以此周期振荡。</translation>
    </message>
    <message>
        <source>A sticking valve or an external disturbance is the likely cause; the recording cannot tell them apart. Switch the controller to manual: if the oscillation stops, the valve sticks; if it continues, the cause is external.</source>
        <translation>原因可能是阀门卡涩或外部扰动；仅凭记录无法区分。请将调节器切换到手动：若振荡停止，则阀门卡涩；若振荡继续，则原因在外部。</translation>
    </message>
    <message>
        <source>The likely cause is external: neither the settings nor a sticking valve explains it.</source>
        <translation>可能的原因在外部：参数设置和阀门卡涩都无法解释。</translation>
    </message>
    <message>
        <source>The output is at a limit for {0} % of the time.</source>
        <translation>输出有 {0} % 的时间处于限值。</translation>
    </message>
    <message>
        <source>{0} % of what the measured value does is noise.</source>
        <translation>测量值变化的 {0} % 是噪声。</translation>
    </message>
    <message>
        <source>the output did not respond: the controller was not active</source>
        <translation>输出没有响应：控制器未激活</translation>
    </message>
    <message>
        <source>too short: not at rest again before the next change</source>
        <translation>过短：下一次变化前尚未恢复平稳</translation>
    </message>
    <message>
        <source>The recording has {0} {0:disturbance|disturbances}, but no step that a model can be made from; change the set point or the output once and record the response</source>
        <translation>记录中有 {0} 次扰动，但没有可建立模型的阶跃；请改变一次设定值或输出，并记录响应</translation>
    </message>
    <message>
        <source>Change {0} is a disturbance: its cause is not known, so no model can be made from it; choose a change of the set point or of the output</source>
        <translation>变化 {0} 是扰动：原因未知，因此无法建立模型；请选择设定值或输出的变化</translation>
    </message>
    <message>
        <source>the measured value is at the end of its range for {0} % of the time</source>
        <translation>测量值有 {0} % 的时间处于量程端点</translation>
    </message>
    <message>
        <source>{0}, controlled by {1}</source>
        <translation>{0}，由 {1} 控制</translation>
    </message>
    <message>
        <source>Changes in the recording</source>
        <translation>记录中的变化</translation>
    </message>
    <message>
        <source>{0} found, {1} used for the model</source>
        <translation>找到 {0} 个，{1} 个用于建模</translation>
    </message>
    <message>
        <source>… and {0} more</source>
        <translation>……另有 {0} 个</translation>
    </message>
    <message>
        <source>No model: {0}</source>
        <translation>没有模型：{0}</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>{0}, explains {1} %</source>
        <translation>{0}，解释 {1} %</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>参数设置</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>图表</translation>
    </message>
    <message>
        <source>Parameters by {0}</source>
        <translation>按 {0} 的参数</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>已记录</translation>
    </message>
    <message>
        <source>output at a limit</source>
        <translation>输出处于限值</translation>
    </message>
    <message>
        <source>mean absolute error</source>
        <translation>平均绝对误差</translation>
    </message>
    <message>
        <source>integrated absolute error</source>
        <translation>绝对误差积分</translation>
    </message>
    <message>
        <source>movements of the output in an hour</source>
        <translation>每小时输出动作量</translation>
    </message>
    <message>
        <source>noise of the measured value</source>
        <translation>测量值噪声</translation>
    </message>
    <message>
        <source>at [s]</source>
        <translation>时刻 [s]</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>变化量</translation>
    </message>
    <message>
        <source>from</source>
        <translation>起始值</translation>
    </message>
    <message>
        <source>to</source>
        <translation>终值</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>评价</translation>
    </message>
    <message>
        <source>output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>set point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>disturbance</source>
        <translation>扰动</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>增益</translation>
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
        <translation>增益裕度</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>settling time [s]</source>
        <translation>调节时间 [s]</translation>
    </message>
    <message>
        <source>error after a load step</source>
        <translation>负载阶跃后的误差</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>不稳定</translation>
    </message>
    <message>
        <source>now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Recorded and modelled</source>
        <translation>记录与模型</translation>
    </message>
    <message>
        <source>Step of the set point by 1</source>
        <translation>设定值阶跃 1</translation>
    </message>
    <message>
        <source>Step of the load by 1</source>
        <translation>负载阶跃 1</translation>
    </message>
    <message>
        <source>Bode plot</source>
        <translation>伯德图</translation>
    </message>
    <message>
        <source>Set point and measured value</source>
        <translation>设定值与测量值</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>时间 [s]</translation>
    </message>
    <message>
        <source>magnitude [dB]</source>
        <translation>幅值 [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>相位 [°]</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>频率 [rad/s]</translation>
    </message>
    <message>
        <source>model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>loop now</source>
        <translation>当前回路</translation>
    </message>
    <message>
        <source>loop, {0}</source>
        <translation>回路，{0}</translation>
    </message>
    <message>
        <source>process</source>
        <translation>过程</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>gain {0} ± {1}</source>
        <translation>增益 {0} ± {1}</translation>
    </message>
    <message>
        <source>lag {0} s ± {1} s</source>
        <translation>时间常数 {0} s ± {1} s</translation>
    </message>
    <message>
        <source>frequency {0} rad/s ± {1} rad/s</source>
        <translation>频率 {0} rad/s ± {1} rad/s</translation>
    </message>
    <message>
        <source>damping {0} ± {1}</source>
        <translation>阻尼 {0} ± {1}</translation>
    </message>
    <message>
        <source>zero {0} s ± {1} s</source>
        <translation>零点 {0} s ± {1} s</translation>
    </message>
    <message>
        <source>dead time {0} s ± {1} s</source>
        <translation>纯滞后 {0} s ± {1} s</translation>
    </message>
    <message>
        <source>The gain is {0} upwards and {1} downwards; settings are made for {2}.</source>
        <translation>上升增益为 {0}，下降增益为 {1}；参数按 {2} 计算。</translation>
    </message>
    <message>
        <source>The gain depends on the operating point: it is {0} where the measured value is about {1}, and {2} about {3}; settings are made for {4}. For one range alone, choose its steps only.</source>
        <translation>增益取决于工作点：测量值约为 {1} 时为 {0}，约为 {3} 时为 {2}；参数按 {4} 计算。若只针对一个范围，请只选择该范围的阶跃。</translation>
    </message>
    <message>
        <source>usable; the output was set to its limit</source>
        <translation>可用；输出被设为其限值</translation>
    </message>
    <message>
        <source>Loop health</source>
        <translation>回路状况</translation>
    </message>
    <message>
        <source>It explains {0} % of the steps it was not fitted to.</source>
        <translation>对未用于拟合的阶跃，它解释了 {0} %。</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>The controller output and the measured value are the same in every sample; choose another measured value</source>
        <translation>控制器输出和测量值在每个采样中都相同；请选择其他测量值</translation>
    </message>
    <message>
        <source>A sticking valve is the likely cause: the output moves evenly, but the process responds in jumps. Check it with the controller in manual: the oscillation then stops; if it continues, the cause is external.</source>
        <translation>原因可能是阀门卡涩：输出平稳变化，而过程以跳变响应。请将调节器切换到手动进行检查：此时振荡会停止；若振荡继续，则原因在外部。</translation>
    </message>
</context>
<context>
    <name>Waveform</name>
    <message>
        <source>The table has no column of times; name one time_s (seconds) or time_ms</source>
        <translation>表中没有时间列；请将一列命名为 time_s（秒）或 time_ms</translation>
    </message>
    <message>
        <source>The table has no column {0}; it has {1}</source>
        <translation>表中没有列 {0}；有 {1}</translation>
    </message>
    <message>
        <source>The table has no column {0}; did you mean {1}?</source>
        <translation>表中没有列 {0}；是否指 {1}？</translation>
    </message>
    <message>
        <source>Line {0} has no number in column {1}; correct or remove the line</source>
        <translation>第 {0} 行的列 {1} 中没有数字；请更正或删除该行</translation>
    </message>
    <message>
        <source>The time in line {0} is before that of the line above; sort the lines by time</source>
        <translation>第 {0} 行的时间早于上一行；请按时间对各行排序</translation>
    </message>
    <message>
        <source>The table has no column of numbers besides the time; add one with a heading</source>
        <translation>表中除时间外没有数字列；请添加带标题的列</translation>
    </message>
    <message>
        <source>The table has no rows below its headings; write one row per sample</source>
        <translation>表头下没有数据行；每个采样写一行</translation>
    </message>
    <message>
        <source>The table cannot be shown as a recording: {0}</source>
        <translation>表不能作为记录显示：{0}</translation>
    </message>
    <message>
        <source>the names of its columns cannot be variables; use letters, digits and underscores</source>
        <translation>其列名不能作为变量；请使用字母、数字和下划线</translation>
    </message>
    <message>
        <source>{0} {0:sample is|samples are} too few for a spectrum; show a longer section</source>
        <translation>{0} 个采样值不足以计算频谱；请显示更长的区段</translation>
    </message>
    <message>
        <source>{0} {0:sample is|samples are} too few for a frequency response; show a longer section</source>
        <translation>{0} 个采样值不足以计算频率响应；请显示更长的区段</translation>
    </message>
    <message>
        <source>The input does not change here, so there is no response; show another section</source>
        <translation>此处输入没有变化，因此没有响应；请显示其他区段</translation>
    </message>
    <message>
        <source>{0} needs a closing parenthesis at the end; it must enclose the whole expression</source>
        <translation>{0} 末尾需要右括号；括号必须包围整个表达式</translation>
    </message>
    <message>
        <source>{0} needs a time above 0 as its second argument, for example {1}</source>
        <translation>{0} 的第二个实参必须是大于 0 的时间，例如 {1}</translation>
    </message>
    <message>
        <source>{0} takes one expression; remove the others</source>
        <translation>{0} 只接受一个表达式；请删除其余表达式</translation>
    </message>
    <message>
        <source>The file is not a table; a recording of Stepwise ends with .rec</source>
        <translation>文件不是表格；Stepwise 的记录以 .rec 结尾</translation>
    </message>
    <message>
        <source>Column {0}: {1} {1:cell is not a number|cells are not numbers}, the first ({2}) in line {3}; the value above it is kept</source>
        <translation>列 {0}：{1} 个单元格不是数字，第一个（{2}）在第 {3} 行；保留其上方的值</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} fewer cells than the header, the first in line {1}; the values above are kept</source>
        <translation>{0} 行的单元格少于表头，第一行为第 {1} 行；保留其上方的值</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} more cells than the header, the first in line {1}; the surplus cells are ignored. Put numbers with a decimal comma in quotes</source>
        <translation>{0} 行的单元格多于表头，第一行为第 {1} 行；多余的单元格被忽略。请将带小数逗号的数字放在引号中</translation>
    </message>
    <message>
        <source>{0} {0:row has|rows have} the same time as the row above, the first in line {1}; {0:it is|they are} left out</source>
        <translation>{0} 行的时间与上一行相同，第一行为第 {1} 行；已忽略</translation>
    </message>
    <message>
        <source>Line {0} is not a sample of a variable: it needs a time and a value</source>
        <translation>第 {0} 行不是变量的采样值：需要时间和值</translation>
    </message>
    <message>
        <source>The trace cannot be read as XML: {0}; save it again</source>
        <translation>跟踪无法作为 XML 读取：{0}；请重新保存</translation>
    </message>
    <message>
        <source>{0} has {1} {1:value|values} but {2} {2:time|times}; save the trace again</source>
        <translation>{0} 有 {1} 个值，但有 {2} 个时间；请重新保存跟踪</translation>
    </message>
    <message>
        <source>The times of {0} run backwards; save the trace again</source>
        <translation>{0} 的时间倒退；请重新保存跟踪</translation>
    </message>
    <message>
        <source>The file is empty; export the table again</source>
        <translation>文件为空；请重新导出表格</translation>
    </message>
    <message>
        <source>The table has {0} columns {1}; give each its own heading</source>
        <translation>表中有 {0} 列 {1}；请给每列不同的标题</translation>
    </message>
    <message>
        <source>Column {0} has no numbers; choose one of {1}</source>
        <translation>列 {0} 没有数字；请从 {1} 中选择</translation>
    </message>
</context>
<context>
    <name>plc::app::AttachDialog</name>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Attach to a Controller</source>
        <translation>连接控制器</translation>
    </message>
    <message>
        <source>from the file attach-code of the controller</source>
        <translation>来自控制器的 attach-code 文件</translation>
    </message>
    <message>
        <source>only for certificates that this computer does not know</source>
        <translation>仅用于此计算机不认识的证书</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose a certificate</source>
        <translation>选择证书</translation>
    </message>
    <message>
        <source>Trusted certificate</source>
        <translation>受信任的证书</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Choose a Certificate</source>
        <translation>选择证书</translation>
    </message>
    <message>
        <source>Certificates (*.pem *.crt *.cer);;All files (*)</source>
        <translation>证书 (*.pem *.crt *.cer);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Attaching…</source>
        <translation>正在连接…</translation>
    </message>
</context>
<context>
    <name>plc::app::Attachment</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1，位于 %2</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>断开</translation>
    </message>
    <message>
        <source>Attached to %1</source>
        <translation>已连接到 %1</translation>
    </message>
    <message>
        <source>Attached to %1; its program is not the one that is open here</source>
        <translation>已连接到 %1；其程序与此处打开的不同</translation>
    </message>
    <message>
        <source>Connection to %1 lost – reconnecting…</source>
        <translation>与 %1 的连接已断开 – 正在重新连接…</translation>
    </message>
    <message>
        <source>Attaching to %1…</source>
        <translation>正在连接 %1…</translation>
    </message>
    <message>
        <source>The controller runs remotely; values written and forced here take effect there</source>
        <translation>控制器在远程运行；在此处写入和强制的值会在那里生效</translation>
    </message>
</context>
<context>
    <name>plc::app::ConversionDialog</name>
    <message>
        <source>%1 as ST</source>
        <translation>%1（ST）</translation>
    </message>
    <message>
        <source>%1 as an Instruction List</source>
        <translation>%1（指令表）</translation>
    </message>
    <message>
        <source>Instruction list (current text)</source>
        <translation>指令表（现有文本）</translation>
    </message>
    <message>
        <source>ST (current text)</source>
        <translation>ST（现有文本）</translation>
    </message>
    <message>
        <source>The same as ST</source>
        <translation>相同内容的 ST</translation>
    </message>
    <message>
        <source>The same as an instruction list</source>
        <translation>相同内容的指令表</translation>
    </message>
    <message>
        <source>Both give the same results. Replacing can be undone in one step; comments are kept, each above its statement.</source>
        <translation>两者结果相同。替换可一步撤消；注释保留，各自位于其语句上方。</translation>
    </message>
    <message>
        <source>Replace the Text</source>
        <translation>替换文本</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
</context>
<context>
    <name>plc::app::DesignPages</name>
    <message>
        <source>Texts</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>用户和权限</translation>
    </message>
    <message>
        <source>New Panel</source>
        <translation>新建画面</translation>
    </message>
    <message>
        <source>Name of the panel:</source>
        <translation>画面名称：</translation>
    </message>
    <message>
        <source>overview</source>
        <translation>总览</translation>
    </message>
    <message>
        <source>A panel&apos;s name cannot contain / or \; choose another name</source>
        <translation>画面名称不能含 / 或 \；请使用其他名称</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>%1 was changed. Save it?</source>
        <translation>%1 已更改。是否保存？</translation>
    </message>
</context>
<context>
    <name>plc::app::DevicesView</name>
    <message>
        <source>off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>正在连接</translation>
    </message>
    <message>
        <source>online</source>
        <translation>在线</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>已丢失</translation>
    </message>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>尚无数据</translation>
    </message>
    <message>
        <source>refused by the device</source>
        <translation>被设备拒绝</translation>
    </message>
    <message>
        <source>does not fit</source>
        <translation>放不下</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Device or channel</source>
        <translation>设备或通道</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Traffic</source>
        <translation>通信量</translation>
    </message>
    <message>
        <source>Fields of the device or channel</source>
        <translation>设备或通道的字段</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>字段</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Connect or disconnect the devices</source>
        <translation>连接或断开设备</translation>
    </message>
    <message>
        <source>Add a device</source>
        <translation>添加设备</translation>
    </message>
    <message>
        <source>This project has no devices yet. A device (Modbus, MQTT) brings values from outside into variables and takes values of variables out.</source>
        <translation>此项目尚无设备。设备（Modbus、MQTT）将外部的值读入变量，并将变量的值输出到外部。</translation>
    </message>
    <message>
        <source>Modbus TCP device</source>
        <translation>Modbus TCP 设备</translation>
    </message>
    <message>
        <source>Modbus RTU device (serial)</source>
        <translation>Modbus RTU 设备（串行）</translation>
    </message>
    <message>
        <source>Modbus TCP server</source>
        <translation>Modbus TCP 服务器</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>MQTT 代理</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>添加通道</translation>
    </message>
    <message>
        <source>Delete the device or channel</source>
        <translation>删除设备或通道</translation>
    </message>
    <message>
        <source>Propose addresses for channels without a variable</source>
        <translation>为没有变量的通道建议地址</translation>
    </message>
    <message>
        <source>Undo the last change of the devices</source>
        <translation>撤消对设备的最后一次更改</translation>
    </message>
    <message>
        <source>Every channel has a variable</source>
        <translation>每个通道都有变量</translation>
    </message>
    <message numerus="yes">
        <source>%n address(es) proposed</source>
        <translation>
            <numerusform>已建议 %n 个地址</numerusform>
        </translation>
    </message>
    <message>
        <source>not enabled</source>
        <translation>未启用</translation>
    </message>
    <message>
        <source>%1 requests, %2 errors, %3 ms</source>
        <translation>%1 次请求，%2 个错误，%3 ms</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>online: %1 of %2</source>
        <translation>在线：%1 / %2</translation>
    </message>
    <message>
        <source>“%1” in devices.json</source>
        <translation>devices.json 中的“%1”</translation>
    </message>
</context>
<context>
    <name>plc::app::EditorTabs</name>
    <message>
        <source>Documents</source>
        <translation>文档</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close Others</source>
        <translation>关闭其他</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>%1 was changed. Save it?</source>
        <translation>%1 已更改。是否保存？</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were changed: %1. Save them?</source>
        <translation>
            <numerusform>%n 个文件已更改：%1。是否保存？</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s); those edited since stay as they are</source>
        <translation>
            <numerusform>已更改 %n 个文件；此后编辑过的文件保持不变</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s)</source>
        <translation>
            <numerusform>已更改 %n 个文件</numerusform>
        </translation>
    </message>
    <message>
        <source>Read-only file</source>
        <translation>只读文件</translation>
    </message>
    <message>
        <source>%1 is read-only. Replace it anyway? It stays read-only.</source>
        <translation>%1 为只读。仍要替换吗？文件将保持只读。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>%1 was not saved</source>
        <translation>%1 未保存</translation>
    </message>
    <message>
        <source>%1 is not a variable of the running program; check the name, or press F5 to build the program</source>
        <translation>%1 不是运行中程序的变量；请检查名称，或按 F5 编译程序</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>强制</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
</context>
<context>
    <name>plc::app::ExplanationDialog</name>
    <message>
        <source>Explanation</source>
        <translation>解释</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <extracomment>an example&apos;s line, then what is wrong there</extracomment>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>What %1 Means</source>
        <translation>%1 的含义</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>正确</translation>
    </message>
    <message>
        <source>Put the cursor on a problem, or choose one in the list, and press F1 again</source>
        <translation>请将光标放在某个问题上，或在列表中选择一个，然后再按 F1</translation>
    </message>
    <message>
        <source>There is no page for %1; choose a code from the list</source>
        <translation>没有关于 %1 的页面；请从列表中选择代码</translation>
    </message>
</context>
<context>
    <name>plc::app::ExportDialog</name>
    <message>
        <source>Export the Project</source>
        <translation>导出项目</translation>
    </message>
    <message>
        <source>PLCopen XML 0200, for CODESYS and TwinCAT</source>
        <translation>PLCopen XML 0200，用于 CODESYS 和 TwinCAT</translation>
    </message>
    <message>
        <source>PLCopen XML 0201, for Beremiz and OpenPLC</source>
        <translation>PLCopen XML 0201，用于 Beremiz 和 OpenPLC</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>文件…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Format:</source>
        <translation>格式：</translation>
    </message>
    <message>
        <source>To:</source>
        <translation>目标：</translation>
    </message>
    <message>
        <source>This file exists and will be replaced</source>
        <translation>此文件已存在，将被替换</translation>
    </message>
</context>
<context>
    <name>plc::app::FileCommands</name>
    <message>
        <source>New Trace</source>
        <translation>新建跟踪</translation>
    </message>
    <message>
        <source>Name of the trace:</source>
        <translation>跟踪名称：</translation>
    </message>
    <message>
        <source>trace</source>
        <translation>跟踪</translation>
    </message>
    <message>
        <source>A file name cannot contain / or \; choose another name</source>
        <translation>文件名不能含 / 或 \；请使用其他名称</translation>
    </message>
    <message>
        <source>A trace %1 already exists; choose another name</source>
        <translation>跟踪 %1 已存在；请使用其他名称</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>New name of %1:</source>
        <translation>%1 的新名称：</translation>
    </message>
    <message>
        <source>A file %1 already exists; choose another name</source>
        <translation>文件 %1 已存在；请使用其他名称</translation>
    </message>
    <message>
        <source>The file cannot be renamed; check the permissions of the folder</source>
        <translation>无法重命名文件；请检查文件夹权限</translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>删除 %1？</translation>
    </message>
    <message>
        <source>It contains %1.</source>
        <translation>其中包含 %1。</translation>
    </message>
    <message>
        <source>These panels link to it; their buttons will be reported as errors: %1</source>
        <translation>这些画面会跳转到它；其按钮将报告为错误：%1</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>The file cannot be removed; check the permissions of the folder</source>
        <translation>无法删除文件；请检查文件夹权限</translation>
    </message>
</context>
<context>
    <name>plc::app::GuideView</name>
    <message>
        <source>About this project</source>
        <translation>关于此项目</translation>
    </message>
    <message>
        <source>A README.md in the project&apos;s folder is shown here.</source>
        <translation>此处显示项目文件夹中的 README.md。</translation>
    </message>
</context>
<context>
    <name>plc::app::ImportDialog</name>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Objects: %1
Bodies: %2
Not kept: %3</source>
        <translation>对象：%1
主体：%2
未保留：%3</translation>
    </message>
    <message>
        <source>Import a Project</source>
        <translation>导入项目</translation>
    </message>
    <message>
        <source>PLCopen XML, TwinCAT or CODESYS files, structured text</source>
        <translation>PLCopen XML、TwinCAT 或 CODESYS 文件、结构化文本</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>文件…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>文件夹…</translation>
    </message>
    <message>
        <source>Source files</source>
        <translation>源文件</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>From:</source>
        <translation>来源：</translation>
    </message>
    <message>
        <source>New project in:</source>
        <translation>新项目位置：</translation>
    </message>
    <message>
        <source>Projects of other tools (%1)</source>
        <translation>其他工具的项目 (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>This folder is not empty; name a new one</source>
        <translation>此文件夹不为空；请指定新的文件夹</translation>
    </message>
    <message>
        <source>program units</source>
        <translation>POU</translation>
    </message>
    <message>
        <source>data types</source>
        <translation>数据类型</translation>
    </message>
    <message>
        <source>global variable lists</source>
        <translation>全局变量列表</translation>
    </message>
    <message>
        <source>configurations</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>PLCopen XML, TwinCAT, CODESYS, ST</source>
        <translation>PLCopen XML、TwinCAT、CODESYS、ST</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>Becomes a separate project with the libraries it uses</source>
        <translation>成为独立的项目，包含其使用的库</translation>
    </message>
    <message>
        <source>Writing the project…</source>
        <translation>正在写入项目…</translation>
    </message>
    <message>
        <source>Encoding:</source>
        <translation>编码：</translation>
    </message>
    <message>
        <source>Recognised</source>
        <translation>自动识别</translation>
    </message>
    <message>
        <source>For files that are not in Unicode and do not specify their encoding</source>
        <translation>用于非 Unicode 且未声明编码的文件</translation>
    </message>
</context>
<context>
    <name>plc::app::InsideViews</name>
    <message>
        <source>Coverage of the latest %1 of %2 recorded scans</source>
        <translation>最近 %1 个扫描周期的覆盖率，共记录 %2 个</translation>
    </message>
    <message>
        <source>There is no recording yet: run the program first.</source>
        <translation>尚无记录：请先运行程序。</translation>
    </message>
    <message>
        <source>Put the cursor on a variable, or select an expression, to ask about it</source>
        <translation>请将光标放在变量上，或选择表达式，以询问它</translation>
    </message>
</context>
<context>
    <name>plc::app::InstanceBar</name>
    <message>
        <source>Instance whose values are shown</source>
        <translation>显示其值的实例</translation>
    </message>
    <message>
        <source>Values of the instance of %1:</source>
        <translation>%1 实例的值：</translation>
    </message>
</context>
<context>
    <name>plc::app::LiveViews</name>
    <message>
        <source>Panel shown</source>
        <translation>显示的画面</translation>
    </message>
    <message>
        <source>Full screen (Esc to exit)</source>
        <translation>全屏（按 Esc 退出）</translation>
    </message>
    <message>
        <source>This project has no panel yet.
To draw one, right-click Panels in the project tree and choose New.</source>
        <translation>此项目尚无画面。
要绘制画面，请在项目树中右键单击“画面”，然后选择“新建”。</translation>
    </message>
    <message>
        <source>No panel can be read: %1.
Problems says what is wrong; a double click there opens the file as text.</source>
        <translation>无法读取任何画面：%1。
“问题”中说明了错误所在；在那里双击可将文件作为文本打开。</translation>
    </message>
    <message>
        <source>The alarm history is kept in memory only: %1</source>
        <translation>报警历史仅保存在内存中：%1</translation>
    </message>
    <message>
        <source>Saving the recording…</source>
        <translation>正在保存记录…</translation>
    </message>
    <message>
        <source>Export the alarm history…</source>
        <translation>导出报警历史…</translation>
    </message>
    <message>
        <source>Export the Alarm History</source>
        <translation>导出报警历史</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>画面</translation>
    </message>
</context>
<context>
    <name>plc::app::MainWindow</name>
    <message>
        <source>Project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>监视</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>强制</translation>
    </message>
    <message>
        <source>Call Stack</source>
        <translation>调用堆栈</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>断点</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>跟踪</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Recent Projects</source>
        <translation>最近的项目</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>工具栏</translation>
    </message>
    <message>
        <source>State of the controller</source>
        <translation>控制器状态</translation>
    </message>
    <message>
        <source>%1 : %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>OFFLINE</source>
        <translation>离线</translation>
    </message>
    <message>
        <source>RUN</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>PAUSE</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>HALT</source>
        <translation>断点停止</translation>
    </message>
    <message>
        <source>FAULT</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>PAST</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>%1 · scan %2</source>
        <translation>%1 · 扫描周期 %2</translation>
    </message>
    <message>
        <source>%1 µs · %2 % load</source>
        <translation>%1 µs · 负载 %2 %</translation>
    </message>
    <message>
        <source>%1 MB recorded</source>
        <translation>已记录 %1 MB</translation>
    </message>
    <message>
        <source>%1 scans of %2 MB at most</source>
        <translation>%1 个扫描周期，最多 %2 MB</translation>
    </message>
    <message>
        <source>Go to the line</source>
        <translation>转到行</translation>
    </message>
    <message>
        <source>no problems</source>
        <translation>没有问题</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>打开项目</translation>
    </message>
    <message>
        <source>%1 – Stepwise</source>
        <translation>%1 – Stepwise</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Stepwise was closed without saving. Unsaved changes to %1 were kept. Restore them?</source>
        <translation>上次退出时未保存。%1 的未保存更改已保留。是否恢复？</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>库</translation>
    </message>
    <message>
        <source>Running tests…</source>
        <translation>正在运行测试…</translation>
    </message>
    <message>
        <source>passed: %1</source>
        <translation>通过：%1</translation>
    </message>
    <message>
        <source>FAILED: %1</source>
        <translation>失败：%1</translation>
    </message>
    <message>
        <source>%1 passed, %2 failed</source>
        <translation>%1 通过，%2 失败</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>尽可能快</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Memory for the recording of every scan [MB]:</source>
        <translation>记录每个扫描周期所用的内存 [MB]：</translation>
    </message>
    <message>
        <source>Save the Recording</source>
        <translation>保存记录</translation>
    </message>
    <message>
        <source>Recordings (*.rec)</source>
        <translation>记录 (*.rec)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>About Stepwise</source>
        <translation>关于 Stepwise</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>欢迎</translation>
    </message>
    <message>
        <source>The project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Programs, blocks, tasks, panels, traces and tests, made from the text files in the folder.</source>
        <translation>程序、块、任务、画面、跟踪和测试，均来自文件夹中的文本文件。</translation>
    </message>
    <message>
        <source>The program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Structured Text with semantic highlighting. Errors are underlined as you type; Alt+Enter offers quick fixes; Ctrl+Space completes.</source>
        <translation>带语义高亮的结构化文本。输入时错误会加下划线；Alt+Enter 提供快速修正；Ctrl+空格 补全。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>F5 compiles to native code and runs it. Values then appear next to each line.</source>
        <translation>F5 编译为本机代码并运行。随后数值显示在每一行旁边。</translation>
    </message>
    <message>
        <source>Any expression, at any moment. Prepare a value and write or force it with one click.</source>
        <translation>任意表达式，任意时刻。准备好值，一次点击即可写入或强制。</translation>
    </message>
    <message>
        <source>The trace</source>
        <translation>跟踪</translation>
    </message>
    <message>
        <source>Nothing has to be selected in advance: every scan is recorded, and any expression can be charted afterwards.</source>
        <translation>无需事先选择：每个扫描周期都有记录，事后可为任意表达式生成曲线图。</translation>
    </message>
    <message>
        <source>The panel</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>What the operator sees, in the languages of the machine. It works here as it will on the machine.</source>
        <translation>操作员看到的内容，使用机器的语言。它在这里的工作方式与在机器上相同。</translation>
    </message>
    <message>
        <source>Time runs backwards, too</source>
        <translation>时间也能倒流</translation>
    </message>
    <message>
        <source>That’s it</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P finds every command. The start page has more machines to play with.</source>
        <translation>Ctrl+Shift+P 可找到任何命令。起始页有更多机器可供试用。</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>新建项目…</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>打开项目…</translation>
    </message>
    <message>
        <source>Close Project</source>
        <translation>关闭项目</translation>
    </message>
    <message>
        <source>New Program, Block, Type…</source>
        <translation>新建程序、块、类型…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>New Panel…</source>
        <translation>新建画面…</translation>
    </message>
    <message>
        <source>Panel Texts</source>
        <translation>画面文本</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>全部保存</translation>
    </message>
    <message>
        <source>Close Document</source>
        <translation>关闭文档</translation>
    </message>
    <message>
        <source>Libraries…</source>
        <translation>库…</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>设置…</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤消</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>查找…</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>替换…</translation>
    </message>
    <message>
        <source>Find Next</source>
        <translation>查找下一个</translation>
    </message>
    <message>
        <source>Find Previous</source>
        <translation>查找上一个</translation>
    </message>
    <message>
        <source>Find in All Files…</source>
        <translation>在所有文件中查找…</translation>
    </message>
    <message>
        <source>Go to Line…</source>
        <translation>转到行…</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>转到定义</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>查找引用</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>补全</translation>
    </message>
    <message>
        <source>Quick Fix (Alt+Enter)</source>
        <translation>快速修正 (Alt+Enter)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式化</translation>
    </message>
    <message>
        <source>Toggle Comment (Ctrl+/)</source>
        <translation>切换注释 (Ctrl+/)</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制行</translation>
    </message>
    <message>
        <source>Select Enclosing Block</source>
        <translation>选择外围块</translation>
    </message>
    <message>
        <source>Go to Matching Keyword</source>
        <translation>转到匹配的关键字</translation>
    </message>
    <message>
        <source>Next Problem</source>
        <translation>下一个问题</translation>
    </message>
    <message>
        <source>Previous Problem</source>
        <translation>上一个问题</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>编译</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Single Scan</source>
        <translation>单次扫描</translation>
    </message>
    <message>
        <source>Step Into</source>
        <translation>单步进入</translation>
    </message>
    <message>
        <source>Step Over</source>
        <translation>单步跳过</translation>
    </message>
    <message>
        <source>Step Out</source>
        <translation>单步跳出</translation>
    </message>
    <message>
        <source>Run to Cursor</source>
        <translation>运行到光标</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>切换断点</translation>
    </message>
    <message>
        <source>Reset Warm</source>
        <translation>热复位</translation>
    </message>
    <message>
        <source>Reset Cold</source>
        <translation>冷复位</translation>
    </message>
    <message>
        <source>Reset Origin</source>
        <translation>原始复位</translation>
    </message>
    <message>
        <source>Online Change</source>
        <translation>在线修改</translation>
    </message>
    <message>
        <source>Speed…</source>
        <translation>速度…</translation>
    </message>
    <message>
        <source>Memory for the Recording…</source>
        <translation>记录所用内存…</translation>
    </message>
    <message>
        <source>Save the Recording…</source>
        <translation>保存记录…</translation>
    </message>
    <message>
        <source>Write Prepared Values</source>
        <translation>写入准备值</translation>
    </message>
    <message>
        <source>Force Prepared Values</source>
        <translation>强制准备值</translation>
    </message>
    <message>
        <source>Release All Forces</source>
        <translation>解除全部强制</translation>
    </message>
    <message>
        <source>Run the Tests</source>
        <translation>运行测试</translation>
    </message>
    <message>
        <source>One Scan Back</source>
        <translation>后退一个扫描周期</translation>
    </message>
    <message>
        <source>One Scan Forward</source>
        <translation>前进一个扫描周期</translation>
    </message>
    <message>
        <source>Back to Live</source>
        <translation>返回实时</translation>
    </message>
    <message>
        <source>Resume from Here</source>
        <translation>从此处继续</translation>
    </message>
    <message>
        <source>Command Palette</source>
        <translation>命令面板</translation>
    </message>
    <message>
        <source>Split the Editor</source>
        <translation>拆分编辑器</translation>
    </message>
    <message>
        <source>Declarations as a Table</source>
        <translation>以表格显示声明</translation>
    </message>
    <message>
        <source>Online Values in the Text</source>
        <translation>文本中的在线值</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Light Theme</source>
        <translation>浅色主题</translation>
    </message>
    <message>
        <source>Dark Theme</source>
        <translation>深色主题</translation>
    </message>
    <message>
        <source>System Theme</source>
        <translation>系统主题</translation>
    </message>
    <message>
        <source>Reset the Layout</source>
        <translation>重置布局</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>导览</translation>
    </message>
    <message>
        <source>Open a Recording…</source>
        <translation>打开记录…</translation>
    </message>
    <message>
        <source>All values are from a recording file. Click to go back to the controller.</source>
        <translation>所有值均来自文件中的记录。点击返回控制器。</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>%1 – back to live</source>
        <translation>%1 – 返回实时</translation>
    </message>
    <message>
        <source>Open a Recording</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>Show as ST…</source>
        <translation>显示为 ST…</translation>
    </message>
    <message>
        <source>Show as an Instruction List…</source>
        <translation>显示为指令表…</translation>
    </message>
    <message>
        <source>New Trace…</source>
        <translation>新建跟踪…</translation>
    </message>
    <message>
        <source>The build was cancelled; everything is as it was</source>
        <translation>编译已取消；一切保持原样</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>The tests were cancelled</source>
        <translation>测试已取消</translation>
    </message>
    <message>
        <source>Cancelled: nothing was saved</source>
        <translation>已取消：未保存任何内容</translation>
    </message>
    <message>
        <source>%1 is encoded in %2 and will be saved in that encoding</source>
        <translation>%1 的编码为 %2，将以该编码保存</translation>
    </message>
    <message>
        <source>This is a copy of the example, in %1: change what you like</source>
        <translation>这是示例的副本，位于 %1：可随意更改</translation>
    </message>
    <message>
        <source>This is your copy of the example, in %1</source>
        <translation>这是该示例的副本，位于 %1</translation>
    </message>
    <message>
        <source>The language changes when the tests have ended</source>
        <translation>测试结束后切换语言</translation>
    </message>
    <message>
        <source>Controller fault</source>
        <translation>控制器错误</translation>
    </message>
    <message>
        <source>RUN %1</source>
        <translation>运行 %1</translation>
    </message>
    <message>
        <source>at full speed</source>
        <translation>全速</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Speed of the controller; any factor can be entered:</source>
        <translation>控制器速度；可输入任意倍数：</translation>
    </message>
    <message>
        <source>The speed is a factor from 0.001 to 10000</source>
        <translation>速度是 0.001 到 10000 的倍数</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>导入…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>The project was exported</source>
        <translation>项目已导出</translation>
    </message>
    <message>
        <source>Add Next Occurrence to Selection</source>
        <translation>同时选择下一个匹配项</translation>
    </message>
    <message>
        <source>Arrange for Editing</source>
        <translation>编辑布局</translation>
    </message>
    <message>
        <source>Arrange for Debugging</source>
        <translation>调试布局</translation>
    </message>
    <message>
        <source>Arrange for Drawing Panels</source>
        <translation>画面设计布局</translation>
    </message>
    <message>
        <source>Maximise the Editor</source>
        <translation>最大化编辑器</translation>
    </message>
    <message>
        <source>Keeping the recording of the last run…</source>
        <translation>正在保留上次运行的记录…</translation>
    </message>
    <message>
        <source>Diagram Beside the Text</source>
        <translation>在文本旁显示图</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>书签</translation>
    </message>
    <message>
        <source>Next Bookmark</source>
        <translation>下一个书签</translation>
    </message>
    <message>
        <source>Previous Bookmark</source>
        <translation>上一个书签</translation>
    </message>
    <message>
        <source>Open Another File Beside…</source>
        <translation>在旁边打开其他文件…</translation>
    </message>
    <message>
        <source>About This Project</source>
        <translation>关于此项目</translation>
    </message>
    <message>
        <source>The project has no other file</source>
        <translation>项目没有其他文件</translation>
    </message>
    <message>
        <source>The tour runs on an example, and none is installed: open or create a project and start the tour again</source>
        <translation>导览需要一个示例，但尚未安装任何示例：请打开或新建一个项目，然后重新开始导览</translation>
    </message>
    <message>
        <source>Open Another File Beside</source>
        <translation>在旁边打开其他文件</translation>
    </message>
    <message>
        <source>%1 Nothing can break: the plant is only a simulation. Press Next to look around for a minute, or F5 to run it straight away.</source>
        <translation>%1 不会损坏任何东西：被控对象只是仿真。按“下一步”用一分钟看一看，或按 F5 立即运行。</translation>
    </message>
    <message>
        <source>This is the project %1.</source>
        <translation>这是项目 %1。</translation>
    </message>
    <message>
        <source>What to press</source>
        <translation>该按什么</translation>
    </message>
    <message>
        <source>The page next to the program is the project&apos;s README: what it shows, what to press, what to watch.</source>
        <translation>程序旁边的页面是项目的 README：显示什么、该按什么、监视什么。</translation>
    </message>
    <message>
        <source>What the operator sees. This project has no panel yet; new ones are drawn with the mouse.</source>
        <translation>操作员看到的内容。此项目尚无画面；新画面用鼠标绘制。</translation>
    </message>
    <message>
        <source>Drag the time slider, or press Alt+PgUp: code, charts and panel show the past. “Resume from Here” continues from there.</source>
        <translation>拖动时间滑块，或按 Alt+PgUp：代码、曲线图和画面显示过去的状态。“从此处继续”从该处接着运行。</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>参数整定</translation>
    </message>
    <message>
        <source>Walk Through the Scan</source>
        <translation>逐句查看扫描周期</translation>
    </message>
    <message>
        <source>Step Back In</source>
        <translation>反向单步进入</translation>
    </message>
    <message>
        <source>Step Back Over</source>
        <translation>反向单步跳过</translation>
    </message>
    <message>
        <source>Step Back Out</source>
        <translation>反向单步跳出</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>为什么？</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>为什么不？</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>谁设置了它？</translation>
    </message>
    <message>
        <source>What If…</source>
        <translation>假如…</translation>
    </message>
    <message>
        <source>Coverage of the Recording</source>
        <translation>记录的覆盖率</translation>
    </message>
    <message>
        <source>Hide the Coverage</source>
        <translation>隐藏覆盖率</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>为什么</translation>
    </message>
    <message>
        <source>Slow Scan</source>
        <translation>慢速扫描</translation>
    </message>
    <message>
        <source>What if? needs a running controller: a recording from a file cannot be resumed; press F5 to run the program</source>
        <translation>“假如”需要运行中的控制器：来自文件的记录不能继续运行；按 F5 运行程序</translation>
    </message>
    <message>
        <source>Explain the Problem</source>
        <translation>解释问题</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>用户和权限</translation>
    </message>
    <message>
        <source>Connect or Disconnect the Devices</source>
        <translation>连接或断开设备</translation>
    </message>
    <message>
        <source>Hide Dock Automatically</source>
        <translation>自动隐藏停靠窗口</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Stepwise %1&lt;/h3&gt;&lt;p&gt;An open PLC studio: IEC 61131-3 programs as native code, every scan recorded, operator panels in many languages.&lt;/p&gt;&lt;p&gt;Licence: GPL-3.0&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Stepwise %1&lt;/h3&gt;&lt;p&gt;开放的 PLC 开发环境：IEC 61131-3 程序编译为本机代码，记录每个扫描周期，多语言操作画面。&lt;/p&gt;&lt;p&gt;许可证：GPL-3.0&lt;/p&gt;</translation>
    </message>
    <message>
        <source>High-Contrast Theme</source>
        <translation>高对比度主题</translation>
    </message>
    <message>
        <source>Attach to a Controller…</source>
        <translation>连接控制器…</translation>
    </message>
    <message>
        <source>Detach from the Controller</source>
        <translation>断开与控制器的连接</translation>
    </message>
    <message>
        <source>Build a Native Program…</source>
        <translation>生成本机程序…</translation>
    </message>
    <message>
        <source>%1 arranges the window for drawing panels</source>
        <translation>%1 将窗口布置为绘制画面</translation>
    </message>
    <message>
        <source>Close Other Documents</source>
        <translation>关闭其他文档</translation>
    </message>
    <message>
        <source>Fold or Unfold the Block</source>
        <translation>折叠或展开块</translation>
    </message>
    <message>
        <source>Fold or Unfold All</source>
        <translation>全部折叠或展开</translation>
    </message>
    <message>
        <source>Previous Pass of the Loop</source>
        <translation>循环的上一遍</translation>
    </message>
    <message>
        <source>Next Pass of the Loop</source>
        <translation>循环的下一遍</translation>
    </message>
    <message>
        <source>Context Menu</source>
        <translation>快捷菜单</translation>
    </message>
    <message>
        <source>Columns…</source>
        <translation>列…</translation>
    </message>
    <message>
        <source>Move Dock to the Next Side</source>
        <translation>将停靠窗口移到下一侧</translation>
    </message>
    <message>
        <source>Float or Dock Again</source>
        <translation>浮动或重新停靠</translation>
    </message>
    <message>
        <source>Next Pane</source>
        <translation>下一窗格</translation>
    </message>
    <message>
        <source>Previous Pane</source>
        <translation>上一窗格</translation>
    </message>
    <message>
        <source>Wider Pane</source>
        <translation>加宽窗格</translation>
    </message>
    <message>
        <source>Narrower Pane</source>
        <translation>收窄窗格</translation>
    </message>
    <message>
        <source>Taller Pane</source>
        <translation>增高窗格</translation>
    </message>
    <message>
        <source>Shorter Pane</source>
        <translation>降低窗格</translation>
    </message>
    <message>
        <source>Move Document Left</source>
        <translation>左移文档</translation>
    </message>
    <message>
        <source>Move Document Right</source>
        <translation>右移文档</translation>
    </message>
    <message>
        <source>Show Tooltip at the Cursor</source>
        <translation>显示光标处的工具提示</translation>
    </message>
    <message>
        <source>There are no columns here; go to a table or a list with columns first</source>
        <translation>此处没有列；请先转到带列的表格或列表</translation>
    </message>
    <message>
        <source>Project Settings…</source>
        <translation>项目设置…</translation>
    </message>
    <message>
        <source>Panel Themes…</source>
        <translation>画面主题…</translation>
    </message>
</context>
<context>
    <name>plc::app::Menu</name>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Go To</source>
        <translation>转到</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>书签</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>复位</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>布局</translation>
    </message>
    <message>
        <source>Docks</source>
        <translation>停靠窗口</translation>
    </message>
    <message>
        <source>Folding</source>
        <translation>折叠</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>窗格</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>查找</translation>
    </message>
</context>
<context>
    <name>plc::app::MergeDialog</name>
    <message>
        <source>Compare %1</source>
        <translation>比较 %1</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>上一处</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一处</translation>
    </message>
    <message>
        <source>Take Over</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>Take Over All</source>
        <translation>全部采用</translation>
    </message>
    <message>
        <source>Here (this text is kept)</source>
        <translation>此处（保留此文本）</translation>
    </message>
    <message>
        <source>On disk</source>
        <translation>磁盘上</translation>
    </message>
    <message>
        <source>Use the Text on the Left</source>
        <translation>使用左侧文本</translation>
    </message>
    <message>
        <source>No differences</source>
        <translation>没有差异</translation>
    </message>
    <message>
        <source>Difference %1 of %2</source>
        <translation>差异 %1 / %2</translation>
    </message>
</context>
<context>
    <name>plc::app::NativeProgramDialog</name>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>生成</translation>
    </message>
    <message>
        <source>Build a Native Program</source>
        <translation>生成本机程序</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>选择文件</translation>
    </message>
    <message>
        <source>Native Program</source>
        <translation>本机程序</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>The program runs without Stepwise on a machine with Linux: its PLC code and a small runner in one file.</source>
        <translation>程序无需 Stepwise 即可在 Linux 机器上运行：一个文件包含其 PLC 代码和小型运行时。</translation>
    </message>
    <message>
        <source>Building…</source>
        <translation>正在生成…</translation>
    </message>
    <message>
        <source>%1 is built</source>
        <translation>%1 已生成</translation>
    </message>
</context>
<context>
    <name>plc::app::NewProjectDialog</name>
    <message>
        <source>Empty</source>
        <translation>空项目</translation>
    </message>
    <message>
        <source>One program in a task of 10 ms</source>
        <translation>10 ms 任务中的一个程序</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>电机</translation>
    </message>
    <message>
        <source>Start, stop, a simulated motor and a test</source>
        <translation>启动、停止、一台仿真电机和一个测试</translation>
    </message>
    <message>
        <source>PID loop</source>
        <translation>PID 回路</translation>
    </message>
    <message>
        <source>A temperature loop with its plant</source>
        <translation>带被控对象的温度回路</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>顺序控制</translation>
    </message>
    <message>
        <source>Fill, mix, empty as a sequential function chart</source>
        <translation>用顺序功能图实现进料、搅拌、排空</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>新建项目</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>模板</translation>
    </message>
    <message>
        <source>My machine</source>
        <translation>我的机器</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>选择文件夹</translation>
    </message>
    <message>
        <source>Folder of the project</source>
        <translation>项目文件夹</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>In folder</source>
        <translation>所在文件夹</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>创建</translation>
    </message>
    <message>
        <source>Enter a project name</source>
        <translation>请输入项目名称</translation>
    </message>
    <message>
        <source>%1 already exists and is not empty; choose another name</source>
        <translation>%1 已存在且不为空；请使用其他名称</translation>
    </message>
    <message>
        <source>Will be created in %1</source>
        <translation>将创建于 %1</translation>
    </message>
</context>
<context>
    <name>plc::app::NewUnitDialog</name>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Function block</source>
        <translation>功能块</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>函数</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>结构</translation>
    </message>
    <message>
        <source>Enumeration</source>
        <translation>枚举</translation>
    </message>
    <message>
        <source>Interface</source>
        <translation>接口</translation>
    </message>
    <message>
        <source>Global variables</source>
        <translation>全局变量</translation>
    </message>
    <message>
        <source>Sequential function chart</source>
        <translation>顺序功能图 (SFC)</translation>
    </message>
    <message>
        <source>Simulation of the plant</source>
        <translation>被控对象仿真</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新建</translation>
    </message>
    <message>
        <source>a file of its own</source>
        <translation>单独的文件</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>In</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>创建</translation>
    </message>
    <message>
        <source>Enter a name</source>
        <translation>请输入名称</translation>
    </message>
    <message>
        <source>A name has letters, digits and _, starts with a letter and is not a keyword</source>
        <translation>名称由字母、数字和 _ 组成，以字母开头，且不是关键字</translation>
    </message>
    <message>
        <source>%1 already exists in the project; choose another name</source>
        <translation>%1 在项目中已存在；请使用其他名称</translation>
    </message>
    <message>
        <source>A file %1 already exists: choose it, or another name</source>
        <translation>文件 %1 已存在：请选择它，或使用其他名称</translation>
    </message>
    <message>
        <source>Program as a ladder diagram</source>
        <translation>梯形图 (LD) 程序</translation>
    </message>
    <message>
        <source>Program as a function block diagram</source>
        <translation>功能块图 (FBD) 程序</translation>
    </message>
</context>
<context>
    <name>plc::app::PanelFiles</name>
    <message>
        <source>Texts</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Panel %1</source>
        <translation>画面 %1</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>用户和权限</translation>
    </message>
    <message>
        <source>%1 is gone or cannot be reached: what is open stays here, and Save All writes it again</source>
        <translation>%1 已消失或无法访问：已打开的内容保留在此，“全部保存”会重新写入</translation>
    </message>
</context>
<context>
    <name>plc::app::ProblemsView</name>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Show errors</source>
        <translation>显示错误</translation>
    </message>
    <message>
        <source>Show warnings</source>
        <translation>显示警告</translation>
    </message>
    <message>
        <source>Show notes</source>
        <translation>显示提示</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Filter of the problem list</source>
        <translation>问题列表筛选</translation>
    </message>
</context>
<context>
    <name>plc::app::ProjectSettingsDialog</name>
    <message>
        <source>Project Settings</source>
        <translation>项目设置</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Bytes: %MW1 is bytes 1 and 2 (TwinCAT)</source>
        <translation>字节（TwinCAT）：%MW1 为字节 1 和 2</translation>
    </message>
    <message>
        <source>Words: %MW1 is the second word (CODESYS)</source>
        <translation>字（CODESYS）：%MW1 为第 2 个字</translation>
    </message>
    <message>
        <source> bytes</source>
        <translation> 字节</translation>
    </message>
    <message>
        <source>None (no __NEW)</source>
        <translation>无（不能使用 __NEW）</translation>
    </message>
    <message>
        <source>What the number of a memory address counts</source>
        <translation>存储器地址的编号所计的单位</translation>
    </message>
    <message>
        <source>What the bytes of STRING values stand for</source>
        <translation>STRING 值中各字节所代表的字符</translation>
    </message>
    <message>
        <source>What {IF defined (…)} in the sources finds, separated by commas</source>
        <translation>源代码中 {IF defined (…)} 所能找到的符号，以逗号分隔</translation>
    </message>
    <message>
        <source>The part of the controller&apos;s memory that __NEW takes objects from</source>
        <translation>控制器内存中供 __NEW 创建对象的部分</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Addressing</source>
        <translation>寻址方式</translation>
    </message>
    <message>
        <source>Encoding of STRING</source>
        <translation>STRING 的编码</translation>
    </message>
    <message>
        <source>Defined symbols</source>
        <translation>已定义的符号</translation>
    </message>
    <message>
        <source>Memory for __NEW</source>
        <translation>__NEW 的内存</translation>
    </message>
    <message>
        <source>Date and time of the first scan</source>
        <translation>首个扫描周期的日期和时间</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>The first panel</source>
        <translation>第一个画面</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Allow pictures outside the project folder</source>
        <translation>允许使用项目文件夹以外的图片</translation>
    </message>
    <message>
        <source>The panel that is drawn around all others</source>
        <translation>绘制在其他所有画面周围的画面</translation>
    </message>
    <message>
        <source>A variable with the operator&apos;s language; panels read and write it</source>
        <translation>保存操作员语言的变量；画面会读写它</translation>
    </message>
    <message>
        <source>Start panel</source>
        <translation>起始画面</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>框架</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>字体</translation>
    </message>
    <message>
        <source>Language variable</source>
        <translation>语言变量</translation>
    </message>
    <message>
        <source>A project needs a name.</source>
        <translation>项目必须有名称。</translation>
    </message>
    <message>
        <source>“%1” is not a date and time; write for example DT#2026-01-31-06:00:00.</source>
        <translation>“%1”不是日期时间；请写成 DT#2026-01-31-06:00:00 这样的形式。</translation>
    </message>
</context>
<context>
    <name>plc::app::ProjectTree</name>
    <message>
        <source>Source of %1 with the Values of %2</source>
        <translation>%1 的源代码，带 %2 的值</translation>
    </message>
    <message>
        <source>Values of Instance</source>
        <translation>实例的值</translation>
    </message>
    <message>
        <source>More: choose in the watch</source>
        <translation>更多：请在监视中选择</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Filter of the project tree</source>
        <translation>项目树筛选</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>顺序功能图</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>功能块</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>函数</translation>
    </message>
    <message>
        <source>Types</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Globals</source>
        <translation>全局变量</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>跟踪</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>库</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>新建…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>删除…</translation>
    </message>
    <message>
        <source>Libraries…</source>
        <translation>库…</translation>
    </message>
    <message>
        <source>Run Tests</source>
        <translation>运行测试</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>添加到监视</translation>
    </message>
    <message>
        <source>Arrange by file</source>
        <translation>按文件排列</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Users and Rights</source>
        <translation>用户和权限</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Panel Themes</source>
        <translation>画面主题</translation>
    </message>
</context>
<context>
    <name>plc::app::RenameDialog</name>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>New name of %1, in the whole project:</source>
        <translation>%1 在整个项目中的新名称：</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Places that change</source>
        <translation>将更改之处</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) change:</source>
        <translation>
            <numerusform>将更改 %n 处：</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::app::RunsMenu</name>
    <message>
        <source>Earlier Runs</source>
        <translation>以往的运行</translation>
    </message>
    <message>
        <source>%1, ended by a fault, %2</source>
        <translation>%1，因错误结束，%2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>The last run is being written…</source>
        <translation>正在写入上次运行…</translation>
    </message>
    <message>
        <source>No run has ended yet</source>
        <translation>尚无已结束的运行</translation>
    </message>
</context>
<context>
    <name>plc::app::SearchView</name>
    <message>
        <source>Find in all files</source>
        <translation>在所有文件中查找</translation>
    </message>
    <message>
        <source>Text to find in all files</source>
        <translation>要在所有文件中查找的文本</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>替换为</translation>
    </message>
    <message>
        <source>Replacement in all files</source>
        <translation>所有文件中的替换文本</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>正则表达式</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>区分大小写</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>全部替换</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Search results</source>
        <translation>搜索结果</translation>
    </message>
    <message>
        <source>Invalid regular expression: %1</source>
        <translation>正则表达式无效：%1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%2中%1</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n 处</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n 个文件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced</source>
        <translation>
            <numerusform>已替换 %n 处</numerusform>
        </translation>
    </message>
    <message>
        <source>declared</source>
        <translation>声明</translation>
    </message>
    <message>
        <source>read, write</source>
        <translation>读取、写入</translation>
    </message>
    <message>
        <source>write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>read</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>%1: %2 read, %3 written</source>
        <translation>%1：读取 %2 次，写入 %3 次</translation>
    </message>
    <message>
        <source>Searching all files…</source>
        <translation>正在搜索所有文件…</translation>
    </message>
    <message>
        <source>Cancelled; so far: %1 in %2</source>
        <translation>已取消；到目前为止：%2中%1</translation>
    </message>
    <message>
        <source>Replacing in all files…</source>
        <translation>正在所有文件中替换…</translation>
    </message>
    <message>
        <source>Cancelled; nothing was replaced</source>
        <translation>已取消；未替换任何内容</translation>
    </message>
</context>
<context>
    <name>plc::app::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Editor</source>
        <translation>编辑器</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Language of the studio</source>
        <translation>界面语言</translation>
    </message>
    <message>
        <source>Indentation</source>
        <translation>缩进</translation>
    </message>
    <message>
        <source>Write keywords in capitals while typing</source>
        <translation>输入时将关键字转为大写</translation>
    </message>
    <message>
        <source>Close blocks with Enter (IF … END_IF)</source>
        <translation>按 Enter 自动闭合块 (IF … END_IF)</translation>
    </message>
    <message>
        <source>Show online values in the text</source>
        <translation>在文本中显示在线值</translation>
    </message>
    <message>
        <source>Format when saving</source>
        <translation>保存时格式化</translation>
    </message>
    <message>
        <source>Apply an online change when saving</source>
        <translation>保存时执行在线修改</translation>
    </message>
    <message>
        <source>Memory for the recording of every scan</source>
        <translation>记录每个扫描周期所用的内存</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Another action has the same shortcut</source>
        <translation>另一命令使用相同的快捷键</translation>
    </message>
    <message>
        <source>Shortcut of %1</source>
        <translation>%1 的快捷键</translation>
    </message>
    <message>
        <source>Filter of the actions</source>
        <translation>命令筛选</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>恢复默认值</translation>
    </message>
    <message>
        <source>%1 is now assigned to “%2” instead of “%3”.</source>
        <translation>%1 现在分配给“%2”，不再分配给“%3”。</translation>
    </message>
    <message>
        <source>none is kept</source>
        <translation>不保留</translation>
    </message>
    <message>
        <source>Disk space for the recordings of earlier runs, per project</source>
        <translation>每个项目以往运行记录的磁盘空间</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>高对比度</translation>
    </message>
</context>
<context>
    <name>plc::app::SideBars</name>
    <message>
        <source>Hide Automatically</source>
        <translation>自动隐藏</translation>
    </message>
    <message>
        <source>Keep Open</source>
        <translation>保持打开</translation>
    </message>
    <message>
        <source>Hidden Docks</source>
        <translation>已隐藏的停靠窗口</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>浮动</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>plc::app::StPage</name>
    <message>
        <source>This file is read-only on disk. Saving asks before it replaces it.</source>
        <translation>此文件在磁盘上为只读。保存时会在替换前询问。</translation>
    </message>
    <message>
        <source>Make Writable</source>
        <translation>设为可写</translation>
    </message>
    <message>
        <source>Close this side</source>
        <translation>关闭此侧</translation>
    </message>
</context>
<context>
    <name>plc::app::StartPage</name>
    <message>
        <source>Write, run and watch PLC programs. Every scan is recorded; time runs backwards, too.</source>
        <translation>编写、运行和监视 PLC 程序。每个扫描周期都有记录；时间也能倒流。</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>最近的项目</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>新建项目…</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>打开项目…</translation>
    </message>
    <message>
        <source>Take the Tour</source>
        <translation>开始导览</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Examples: open one and press Run</source>
        <translation>示例：打开一个并按“运行”</translation>
    </message>
    <message>
        <source>No examples were found in:
%1

Install the examples, or set the environment variable STEPWISE_EXAMPLES to the folder that contains them, and start Stepwise again.</source>
        <translation>在以下位置未找到示例：
%1

请安装示例，或将环境变量 STEPWISE_EXAMPLES 设为示例所在的文件夹，然后重新启动 Stepwise。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open a Fresh Copy</source>
        <translation>打开新副本</translation>
    </message>
</context>
<context>
    <name>plc::app::TestView</name>
    <message>
        <source>Run all tests</source>
        <translation>运行所有测试</translation>
    </message>
    <message>
        <source>Run the selected tests</source>
        <translation>运行所选测试</translation>
    </message>
    <message>
        <source>Run the failed tests</source>
        <translation>运行失败的测试</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>%1 passed, %2 failed</source>
        <translation>%1 通过，%2 失败</translation>
    </message>
    <message>
        <source>not run yet</source>
        <translation>尚未运行</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Show the Recording of the Failure</source>
        <translation>显示失败的记录</translation>
    </message>
    <message>
        <source>Show what the tests cover</source>
        <translation>显示测试覆盖的内容</translation>
    </message>
</context>
<context>
    <name>plc::app::TextPage</name>
    <message>
        <source>Line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
</context>
<context>
    <name>plc::app::Tour</name>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>结束导览</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>导览</translation>
    </message>
</context>
<context>
    <name>plc::app::UnitCommands</name>
    <message>
        <source>The program is running. To an online change the new name is another variable: it begins with its initial value.</source>
        <translation>程序正在运行。对在线修改而言，新名称是另一个变量：它从初始值开始。</translation>
    </message>
    <message>
        <source>Go to Line</source>
        <translation>转到行</translation>
    </message>
    <message>
        <source>Line (1 to %1)</source>
        <translation>行（1 到 %1）</translation>
    </message>
    <message>
        <source>Nothing is declared under this name; declare it or check the name</source>
        <translation>没有以此名称声明的内容；请声明或检查该名称</translation>
    </message>
    <message>
        <source>Put the cursor into a unit that is written in ST or IL</source>
        <translation>请将光标放入用 ST 或 IL 编写的 POU</translation>
    </message>
    <message>
        <source>The text has changed meanwhile</source>
        <translation>文本在此期间已更改</translation>
    </message>
    <message>
        <source>There is no name at the cursor; put the cursor on one</source>
        <translation>光标处没有名称；请将光标放在名称上</translation>
    </message>
    <message>
        <source>The project is still being checked; try again in a moment</source>
        <translation>项目仍在检查中；请稍后重试</translation>
    </message>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s); the panels are saved, the sources not yet</source>
        <translation>
            <numerusform>%1 现在名为 %2，共 %n 处；画面已保存，源程序尚未保存</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s)</source>
        <translation>
            <numerusform>%1 现在名为 %2，共 %n 处</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>删除 %1？</translation>
    </message>
    <message numerus="yes">
        <source>It is used in %n other place(s).</source>
        <translation>
            <numerusform>还有 %n 处使用。</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete and Comment Out the Uses</source>
        <translation>删除并注释掉使用处</translation>
    </message>
    <message>
        <source>Show the Uses</source>
        <translation>显示使用处</translation>
    </message>
    <message>
        <source>%1 is not a source of this project; open the project that contains it</source>
        <translation>%1 不是此项目的源文件；请打开包含它的项目</translation>
    </message>
</context>
<context>
    <name>plc::app::WhatIfDialog</name>
    <message>
        <source>What If?</source>
        <translation>假如？</translation>
    </message>
    <message>
        <source>The controller goes back to the scan shown and continues from there with these values. The trace draws what really happened behind the new curves.</source>
        <translation>控制器返回到显示的扫描周期，并以这些值从那里继续运行。跟踪在新曲线后方绘制实际发生的情况。</translation>
    </message>
    <message>
        <source>A variable, such as Main.level</source>
        <translation>变量，例如 Main.level</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>原值</translation>
    </message>
    <message>
        <source>Instead</source>
        <translation>改为</translation>
    </message>
    <message>
        <source>Values to change</source>
        <translation>要更改的值</translation>
    </message>
    <message>
        <source>Run from Here</source>
        <translation>从此处运行</translation>
    </message>
    <message>
        <source>%1 has no value in this scan; choose another variable</source>
        <translation>%1 在此扫描周期中没有值；请选择其他变量</translation>
    </message>
    <message>
        <source>Enter a different value for at least one variable</source>
        <translation>请至少更改一个变量的值</translation>
    </message>
</context>
<context>
    <name>plc::editor::BreakpointView</name>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Hit count</source>
        <translation>命中次数</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>实例</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>断点</translation>
    </message>
    <message>
        <source>Remove selected</source>
        <translation>移除所选</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>全部移除</translation>
    </message>
    <message>
        <source>The running program has no code at or below this line; choose a line with a statement</source>
        <translation>运行中的程序在此行及以下没有代码；请选择含有语句的行</translation>
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
        <translation>实例</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Call stack</source>
        <translation>调用堆栈</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Values of the frame</source>
        <translation>调用层的值</translation>
    </message>
    <message>
        <source>This scan has run to its end: it has no call stack.</source>
        <translation>此扫描周期已执行完毕：没有调用堆栈。</translation>
    </message>
</context>
<context>
    <name>plc::editor::ChartView</name>
    <message>
        <source>Sequential function chart</source>
        <translation>顺序功能图 (SFC)</translation>
    </message>
    <message>
        <source>Insert a step after it (Ins)</source>
        <translation>在其后插入步 (Ins)</translation>
    </message>
    <message>
        <source>Insert an alternative branch</source>
        <translation>插入选择分支</translation>
    </message>
    <message>
        <source>Insert a simultaneous branch</source>
        <translation>插入并行分支</translation>
    </message>
    <message>
        <source>Add an action</source>
        <translation>添加动作</translation>
    </message>
    <message>
        <source>Edit name or condition (F2)</source>
        <translation>编辑名称或条件 (F2)</translation>
    </message>
    <message>
        <source>Delete (Del)</source>
        <translation>删除 (Del)</translation>
    </message>
    <message>
        <source>The unit %1 is no longer in the text; undo the change or close this view</source>
        <translation>POU %1 已不在文本中；请撤消该更改或关闭此视图</translation>
    </message>
    <message>
        <source>The text has errors: this is the last valid drawing</source>
        <translation>文本有错误：这是最后一次正确的图形</translation>
    </message>
    <message>
        <source>Select the step from which the branch goes out</source>
        <translation>请选择分支出发的步</translation>
    </message>
    <message>
        <source>Select the transition after which the steps run at the same time</source>
        <translation>请选择其后各步同时运行的转换</translation>
    </message>
    <message>
        <source>Select the step that gets the action</source>
        <translation>请选择要添加动作的步</translation>
    </message>
    <message>
        <source>Insert a Step After It</source>
        <translation>在其后插入步</translation>
    </message>
    <message>
        <source>Insert an Alternative Branch</source>
        <translation>插入选择分支</translation>
    </message>
    <message>
        <source>Insert a Simultaneous Branch</source>
        <translation>插入并行分支</translation>
    </message>
    <message>
        <source>Add an Action</source>
        <translation>添加动作</translation>
    </message>
    <message>
        <source>Set as Initial Step</source>
        <translation>设为初始步</translation>
    </message>
    <message>
        <source>Force the Step Active</source>
        <translation>强制激活步</translation>
    </message>
    <message>
        <source>Release the Step</source>
        <translation>解除步的强制</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>切换断点</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Move Left</source>
        <translation>左移</translation>
    </message>
    <message>
        <source>Move Right</source>
        <translation>右移</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Branch to the left</source>
        <translation>左侧分支</translation>
    </message>
    <message>
        <source>Branch to the right</source>
        <translation>右侧分支</translation>
    </message>
    <message>
        <source>%1 after this transition</source>
        <translation>此转换之后的 %1</translation>
    </message>
    <message>
        <source>leads to %1</source>
        <translation>通向 %1</translation>
    </message>
    <message>
        <source>further up</source>
        <translation>更上方</translation>
    </message>
    <message>
        <source>further down</source>
        <translation>更下方</translation>
    </message>
    <message>
        <source>%1 in step %2</source>
        <translation>步 %2 中的 %1</translation>
    </message>
    <message>
        <source>A condition is a BOOL; add a comparison</source>
        <translation>条件必须是 BOOL；请添加比较</translation>
    </message>
    <message>
        <source>qualifier</source>
        <translation>限定符</translation>
    </message>
    <message>
        <source>action</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>To the enclosing chart (Backspace)</source>
        <translation>到上级顺序功能图 (Backspace)</translation>
    </message>
    <message>
        <source>Breakpoint: stops when the step becomes active or the transition is taken (F9)</source>
        <translation>断点：步激活或转换发生时停止 (F9)</translation>
    </message>
    <message>
        <source>Force the step active</source>
        <translation>强制激活步</translation>
    </message>
    <message>
        <source>Release the step</source>
        <translation>解除步的强制</translation>
    </message>
    <message>
        <source>%1 is a variable: it has no body</source>
        <translation>%1 是变量：没有主体</translation>
    </message>
    <message>
        <source>Select a step or a transition</source>
        <translation>请选择步或转换</translation>
    </message>
    <message>
        <source>Select a step</source>
        <translation>请选择步</translation>
    </message>
    <message>
        <source>Open Its Chart or Text</source>
        <translation>打开其顺序功能图或文本</translation>
    </message>
    <message>
        <source>Priority…</source>
        <translation>优先级…</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Delete the Whole Branch</source>
        <translation>删除整个分支</translation>
    </message>
    <message>
        <source>Select what is to be copied</source>
        <translation>请选择要复制的内容</translation>
    </message>
    <message>
        <source>Select what is to be cut</source>
        <translation>请选择要剪切的内容</translation>
    </message>
    <message>
        <source>The clipboard contains no step, action or transition; copy one first</source>
        <translation>剪贴板中没有步、动作或转换；请先复制一个</translation>
    </message>
    <message>
        <source>Select the step or transition to paste after</source>
        <translation>请选择要在其后粘贴的步或转换</translation>
    </message>
    <message>
        <source>Select the transition that gets the condition</source>
        <translation>请选择要获得条件的转换</translation>
    </message>
    <message>
        <source>Start a Chart</source>
        <translation>开始顺序功能图</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>%1 has no chart yet. A chart starts with an initial step; more steps are inserted after it with Ins, and F2 edits names and conditions.</source>
        <translation>%1 尚无顺序功能图。顺序功能图以初始步开始；按 Ins 在其后插入更多步，按 F2 编辑名称和条件。</translation>
    </message>
    <message>
        <source>%1 is not a chart: its body has statements. A chart can be started in a program or function block whose body is empty.</source>
        <translation>%1 不是顺序功能图：其主体包含语句。顺序功能图可在主体为空的程序或功能块中开始。</translation>
    </message>
</context>
<context>
    <name>plc::editor::DeclarationTable</name>
    <message>
        <source>Section</source>
        <translation>区段</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Initial value</source>
        <translation>初始值</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>注释</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Declarations</source>
        <translation>声明</translation>
    </message>
    <message>
        <source>Add a variable</source>
        <translation>添加变量</translation>
    </message>
    <message>
        <source>Remove the selected variables</source>
        <translation>移除所选变量</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下移</translation>
    </message>
</context>
<context>
    <name>plc::editor::EventLog</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>PLC time</source>
        <translation>PLC 时间</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>扫描周期</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all rows</source>
        <translation>复制所选行，未选择时复制全部</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Only faults and rejections</source>
        <translation>仅错误和拒绝</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Filter of the events</source>
        <translation>事件筛选</translation>
    </message>
    <message>
        <source>Step: %1</source>
        <translation>步：%1</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>event at file:line</comment>
        <translation>%1，位于 %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::FindBar</name>
    <message>
        <source>Find</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>Text to find</source>
        <translation>要查找的文本</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>替换为</translation>
    </message>
    <message>
        <source>Replacement</source>
        <translation>替换文本</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>区分大小写</translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>全字匹配</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>正则表达式</translation>
    </message>
    <message>
        <source>Previous (Shift+Enter)</source>
        <translation>上一个 (Shift+Enter)</translation>
    </message>
    <message>
        <source>Next (Enter)</source>
        <translation>下一个 (Enter)</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>关闭 (Esc)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Replace All</source>
        <translation>全部替换</translation>
    </message>
    <message numerus="yes">
        <source>%n replaced</source>
        <translation>
            <numerusform>已替换 %n 处</numerusform>
        </translation>
    </message>
    <message>
        <source>invalid regular expression</source>
        <translation>正则表达式无效</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>找到 %n 处</numerusform>
        </translation>
    </message>
    <message>
        <source>not found</source>
        <translation>未找到</translation>
    </message>
</context>
<context>
    <name>plc::editor::ForceView</name>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Forced value</source>
        <translation>强制值</translation>
    </message>
    <message>
        <source>Forced variables</source>
        <translation>已强制的变量</translation>
    </message>
    <message>
        <source>Release selected</source>
        <translation>解除所选强制</translation>
    </message>
    <message>
        <source>Release all</source>
        <translation>解除全部强制</translation>
    </message>
</context>
<context>
    <name>plc::editor::GraphView</name>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Export as SVG, PNG or PDF…</source>
        <translation>导出为 SVG、PNG 或 PDF…</translation>
    </message>
    <message>
        <source>Export the Drawing</source>
        <translation>导出图形</translation>
    </message>
    <message>
        <source>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</source>
        <translation>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be written; choose a variable of the program</source>
        <translation>无法写入 %1；请选择程序的变量</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>打印…</translation>
    </message>
    <message>
        <source>Fix the text first: this is the last valid drawing</source>
        <translation>请先修正文本：这是最后一次正确的图形</translation>
    </message>
</context>
<context>
    <name>plc::editor::LadderView</name>
    <message>
        <source>Ladder or function block diagram</source>
        <translation>梯形图或功能块图</translation>
    </message>
    <message>
        <source>Insert a rung below (Ctrl+T)</source>
        <translation>在下方插入程序段 (Ctrl+T)</translation>
    </message>
    <message>
        <source>Insert a contact on the left (Ctrl+K)</source>
        <translation>在左侧插入触点 (Ctrl+K)</translation>
    </message>
    <message>
        <source>Insert a contact on the right (Ctrl+D)</source>
        <translation>在右侧插入触点 (Ctrl+D)</translation>
    </message>
    <message>
        <source>Insert a parallel contact (Ctrl+R)</source>
        <translation>插入并联触点 (Ctrl+R)</translation>
    </message>
    <message>
        <source>Insert a coil (Ctrl+A)</source>
        <translation>插入线圈 (Ctrl+A)</translation>
    </message>
    <message>
        <source>Insert a function block (Ctrl+B)</source>
        <translation>插入功能块 (Ctrl+B)</translation>
    </message>
    <message>
        <source>Edit (F2)</source>
        <translation>编辑 (F2)</translation>
    </message>
    <message>
        <source>Delete (Del)</source>
        <translation>删除 (Del)</translation>
    </message>
    <message>
        <source>Breakpoint on the rung (F9)</source>
        <translation>程序段上的断点 (F9)</translation>
    </message>
    <message>
        <source>Show as a function block diagram</source>
        <translation>显示为功能块图</translation>
    </message>
    <message>
        <source>Show as a ladder diagram</source>
        <translation>显示为梯形图</translation>
    </message>
    <message>
        <source>%1 is no longer in the text; undo the change or close this view</source>
        <translation>%1 已不在文本中；请撤消该更改或关闭此视图</translation>
    </message>
    <message>
        <source>The text has errors: this is the last valid drawing</source>
        <translation>文本有错误：这是最后一次正确的图形</translation>
    </message>
    <message>
        <source>Fix the text first: this is the last valid drawing</source>
        <translation>请先修正文本：这是最后一次正确的图形</translation>
    </message>
    <message>
        <source>Select a rung</source>
        <translation>请选择程序段</translation>
    </message>
    <message>
        <source>Select a coil</source>
        <translation>请选择线圈</translation>
    </message>
    <message>
        <source>Select a contact, a coil or a pin with a variable</source>
        <translation>请选择触点、线圈或带变量的引脚</translation>
    </message>
    <message>
        <source>The rung has no contact yet</source>
        <translation>程序段尚无触点</translation>
    </message>
    <message>
        <source>Select the rung that gets the block</source>
        <translation>请选择要添加块的程序段</translation>
    </message>
    <message>
        <source>block</source>
        <translation>块</translation>
    </message>
    <message>
        <source>Contact on the left; at a coil, the last contact</source>
        <translation>左侧触点；在线圈处为最后一个触点</translation>
    </message>
    <message>
        <source>Contact on the right</source>
        <translation>右侧触点</translation>
    </message>
    <message>
        <source>Parallel contact</source>
        <translation>并联触点</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>线圈</translation>
    </message>
    <message>
        <source>Function block in the rung</source>
        <translation>程序段中的功能块</translation>
    </message>
    <message>
        <source>Rung above</source>
        <translation>上方程序段</translation>
    </message>
    <message>
        <source>Rung below</source>
        <translation>下方程序段</translation>
    </message>
    <message>
        <source>Negate a contact, a coil or a pin</source>
        <translation>取反触点、线圈或引脚</translation>
    </message>
    <message>
        <source>Coil: normal, set, reset</source>
        <translation>线圈：普通、置位、复位</translation>
    </message>
    <message>
        <source>Comment of the rung</source>
        <translation>程序段注释</translation>
    </message>
    <message>
        <source>Edit what is selected (or Enter)</source>
        <translation>编辑所选内容（或 Enter）</translation>
    </message>
    <message>
        <source>Delete what is selected</source>
        <translation>删除所选内容</translation>
    </message>
    <message>
        <source>Breakpoint on the rung</source>
        <translation>程序段上的断点</translation>
    </message>
    <message>
        <source>This list</source>
        <translation>此列表</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>方向键</translation>
    </message>
    <message>
        <source>Select the next part; Up and Down also the next rung</source>
        <translation>选择下一部分；上下箭头还可选择相邻程序段</translation>
    </message>
    <message>
        <source>Move the rung up; with Down, down</source>
        <translation>上移程序段；按下箭头则下移</translation>
    </message>
    <message>
        <source>Typed before a name: a negated contact</source>
        <translation>在名称前输入：取反触点</translation>
    </message>
    <message>
        <source>Keys in Ladder and Function Block Diagrams</source>
        <translation>梯形图和功能块图中的按键</translation>
    </message>
    <message>
        <source>Insert a Rung Above</source>
        <translation>在上方插入程序段</translation>
    </message>
    <message>
        <source>Insert a Rung Below</source>
        <translation>在下方插入程序段</translation>
    </message>
    <message>
        <source>Insert a Contact</source>
        <translation>插入触点</translation>
    </message>
    <message>
        <source>Insert a Parallel Contact</source>
        <translation>插入并联触点</translation>
    </message>
    <message>
        <source>Insert a Coil</source>
        <translation>插入线圈</translation>
    </message>
    <message>
        <source>Insert a Function Block…</source>
        <translation>插入功能块…</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Comment…</source>
        <translation>注释…</translation>
    </message>
    <message>
        <source>Negate</source>
        <translation>取反</translation>
    </message>
    <message>
        <source>Set or Reset</source>
        <translation>置位或复位</translation>
    </message>
    <message>
        <source>Move the Rung Up</source>
        <translation>上移程序段</translation>
    </message>
    <message>
        <source>Move the Rung Down</source>
        <translation>下移程序段</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Force TRUE</source>
        <translation>强制 TRUE</translation>
    </message>
    <message>
        <source>Force FALSE</source>
        <translation>强制 FALSE</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>解除强制</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>切换断点</translation>
    </message>
    <message>
        <source>Contacts as Bars (IEC 61131-3, ANSI)</source>
        <translation>触点用竖线表示 (IEC 61131-3, ANSI)</translation>
    </message>
    <message>
        <source>Contacts as in Circuit Diagrams (IEC 60617)</source>
        <translation>触点如电路图所示 (IEC 60617)</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Addresses</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Names and Addresses</source>
        <translation>名称和地址</translation>
    </message>
    <message>
        <source>Comments of the Variables</source>
        <translation>变量注释</translation>
    </message>
    <message>
        <source>Comments of the Rungs</source>
        <translation>程序段注释</translation>
    </message>
    <message>
        <source>High Contrast</source>
        <translation>高对比度</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>显示内容</translation>
    </message>
    <message>
        <source>type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Rename the variable everywhere</source>
        <translation>在所有位置重命名变量</translation>
    </message>
    <message>
        <source>Go to the definition</source>
        <translation>转到定义</translation>
    </message>
    <message>
        <source>References to the variable</source>
        <translation>变量的引用</translation>
    </message>
    <message>
        <source>Quick fix</source>
        <translation>快速修正</translation>
    </message>
    <message>
        <source>Bookmark on the rung</source>
        <translation>程序段上的书签</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>查找引用</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>转到定义</translation>
    </message>
    <message>
        <source>Quick Fix</source>
        <translation>快速修正</translation>
    </message>
    <message>
        <source>Write TRUE</source>
        <translation>写入 TRUE</translation>
    </message>
    <message>
        <source>Write FALSE</source>
        <translation>写入 FALSE</translation>
    </message>
    <message>
        <source>Toggle Bookmark</source>
        <translation>切换书签</translation>
    </message>
    <message>
        <source>Contact Here</source>
        <translation>此处插入触点</translation>
    </message>
    <message>
        <source>Negated Contact Here</source>
        <translation>此处插入取反触点</translation>
    </message>
    <message>
        <source>Function Block Here</source>
        <translation>此处插入功能块</translation>
    </message>
    <message>
        <source>Move the contact left; with Right, right</source>
        <translation>左移触点；按右箭头则右移</translation>
    </message>
    <message>
        <source>Select a contact; a rung moves up and down</source>
        <translation>请选择触点；程序段可上下移动</translation>
    </message>
</context>
<context>
    <name>plc::editor::RunArchive</name>
    <message>
        <source>The recording of the last run was not kept: %1</source>
        <translation>上次运行的记录未保留：%1</translation>
    </message>
</context>
<context>
    <name>plc::editor::RunControl</name>
    <message>
        <source>Built in %1 ms</source>
        <translation>编译用时 %1 ms</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s): the program was not built</source>
        <translation>
            <numerusform>%n 个错误：程序未编译</numerusform>
        </translation>
    </message>
    <message>
        <source>Online change: %1 kept, %2 new, %3 lost</source>
        <translation>在线修改：保留 %1 个变量，新增 %2 个，移除 %3 个</translation>
    </message>
    <message>
        <source>The change waits for the end of the scan</source>
        <translation>修改等待扫描周期结束</translation>
    </message>
    <message>
        <source>The program has errors; the controller continues with the old program</source>
        <translation>程序有错误；控制器继续运行旧程序</translation>
    </message>
    <message>
        <source>did not exist in this scan</source>
        <translation>在此扫描周期中不存在</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>编译</translation>
    </message>
    <message>
        <source>Not optimised: the quick code keeps running</source>
        <translation>未优化：继续运行快速编译的代码</translation>
    </message>
    <message>
        <source>Optimising</source>
        <translation>优化</translation>
    </message>
    <message>
        <source>There is no code at or below line %1 of %2; choose an earlier line</source>
        <translation>%2 第 %1 行及以下没有代码；请选择前面的行</translation>
    </message>
    <message>
        <source>The condition of the breakpoint: %1</source>
        <translation>断点条件：%1</translation>
    </message>
</context>
<context>
    <name>plc::editor::SlowScanView</name>
    <message>
        <source>Back to the previous breakpoint or to the first statement of the scan</source>
        <translation>回到上一个断点，或扫描周期的第一条语句</translation>
    </message>
    <message>
        <source>Back out of the call</source>
        <translation>反向跳出调用</translation>
    </message>
    <message>
        <source>Back over calls</source>
        <translation>反向跳过调用</translation>
    </message>
    <message>
        <source>One statement back</source>
        <translation>后退一条语句</translation>
    </message>
    <message>
        <source>Step in</source>
        <translation>单步进入</translation>
    </message>
    <message>
        <source>Step over</source>
        <translation>单步跳过</translation>
    </message>
    <message>
        <source>Step out</source>
        <translation>单步跳出</translation>
    </message>
    <message>
        <source>Forward to the next breakpoint or to the end of the scan</source>
        <translation>前进到下一个断点，或扫描周期结束</translation>
    </message>
    <message>
        <source>End the walk</source>
        <translation>结束逐句查看</translation>
    </message>
    <message>
        <source>Current position of the walk</source>
        <translation>当前查看位置</translation>
    </message>
    <message>
        <source>Call</source>
        <translation>调用</translation>
    </message>
    <message>
        <source>Instance</source>
        <translation>实例</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Call path</source>
        <translation>调用堆栈</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Values at this moment</source>
        <translation>此刻的值</translation>
    </message>
    <message>
        <source>There is no recorded scan yet: run the program first.</source>
        <translation>尚无记录的扫描周期：请先运行程序。</translation>
    </message>
    <message>
        <source>Running the scan again…</source>
        <translation>正在重新运行扫描周期…</translation>
    </message>
    <message>
        <source>Walks through a recorded scan statement by statement, forwards and backwards (Time, Walk Through the Scan).</source>
        <translation>逐条语句查看记录的扫描周期，可前进和后退（时间、逐句查看扫描周期）。</translation>
    </message>
    <message>
        <source>The end of scan %1 at %2</source>
        <translation>扫描周期 %1 结束，时间 %2</translation>
    </message>
    <message>
        <source>Scan %1 at %2: before statement %3 of %4</source>
        <translation>扫描周期 %1，时间 %2：在第 %3 条语句之前，共 %4 条</translation>
    </message>
    <message>
        <source> · pass %1</source>
        <comment>of loops, outermost first</comment>
        <translation> · 第 %1 次循环</translation>
    </message>
    <message>
        <source>Locals</source>
        <translation>局部变量</translation>
    </message>
</context>
<context>
    <name>plc::editor::StEditor</name>
    <message>
        <source>Structured Text editor</source>
        <translation>结构化文本编辑器</translation>
    </message>
    <message>
        <source>Declare %1</source>
        <translation>声明 %1</translation>
    </message>
    <message>
        <source>There is no fix for this line; press F1 for an explanation</source>
        <translation>此行没有可用的修正；按 F1 查看说明</translation>
    </message>
    <message>
        <source>Go to Definition</source>
        <translation>转到定义</translation>
    </message>
    <message>
        <source>Find References</source>
        <translation>查找引用</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Add to Watch</source>
        <translation>添加到监视</translation>
    </message>
    <message>
        <source>Toggle Breakpoint</source>
        <translation>切换断点</translation>
    </message>
    <message>
        <source>CR</source>
        <comment>current result of an instruction list</comment>
        <translation>CR</translation>
    </message>
    <message>
        <source>Declare %1 as an input</source>
        <translation>将 %1 声明为输入</translation>
    </message>
    <message>
        <source>Declare %1 as an output</source>
        <translation>将 %1 声明为输出</translation>
    </message>
    <message>
        <source>Declare %1 as a global variable</source>
        <translation>将 %1 声明为全局变量</translation>
    </message>
    <message>
        <source>Declare %1 in %2</source>
        <translation>在 %2 中声明 %1</translation>
    </message>
    <message>
        <source>Write a Value…</source>
        <translation>写入值…</translation>
    </message>
    <message>
        <source>Force…</source>
        <translation>强制…</translation>
    </message>
    <message>
        <source>Release the Force</source>
        <translation>解除强制</translation>
    </message>
    <message>
        <source>pass</source>
        <comment>of a loop</comment>
        <translation>循环次数</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>plc::editor::TaskMonitor</name>
    <message>
        <source>Histogram of execution times</source>
        <translation>执行时间直方图</translation>
    </message>
    <message>
        <source>Execution times appear here while the controller runs</source>
        <translation>控制器运行时，此处显示执行时间</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>执行次数</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>上次</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>抖动</translation>
    </message>
    <message>
        <source>Overruns</source>
        <translation>超时</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>负载</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Reset the statistics</source>
        <translation>重置统计</translation>
    </message>
</context>
<context>
    <name>plc::editor::TuningView</name>
    <message>
        <source>Charts of the loop</source>
        <translation>回路图表</translation>
    </message>
    <message>
        <source>Recording and model</source>
        <translation>记录与模型</translation>
    </message>
    <message>
        <source>Response to the set point</source>
        <translation>设定值响应</translation>
    </message>
    <message>
        <source>Response to a disturbance</source>
        <translation>扰动响应</translation>
    </message>
    <message>
        <source>Simulation with the actual block</source>
        <translation>用实际功能块仿真</translation>
    </message>
    <message>
        <source>Control loop</source>
        <translation>控制回路</translation>
    </message>
    <message>
        <source>Find Steps</source>
        <translation>查找阶跃</translation>
    </message>
    <message>
        <source>Searches the recording for steps of the set point and of the output and fits a model of the process.</source>
        <translation>在记录中查找设定值和输出的阶跃，并建立过程模型。</translation>
    </message>
    <message>
        <source>Write Parameters</source>
        <translation>写入参数</translation>
    </message>
    <message>
        <source>Writes all parameters in one scan.</source>
        <translation>在一个扫描周期内写入全部参数。</translation>
    </message>
    <message>
        <source>Take Back</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>Writes the parameters that were in force before.</source>
        <translation>写入之前生效的参数。</translation>
    </message>
    <message>
        <source>Loop:</source>
        <translation>回路：</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>At</source>
        <translation>时刻</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>变化量</translation>
    </message>
    <message>
        <source>From</source>
        <translation>起始值</translation>
    </message>
    <message>
        <source>To</source>
        <translation>终值</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>评价</translation>
    </message>
    <message>
        <source>Steps found</source>
        <translation>找到的阶跃</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>规则</translation>
    </message>
    <message>
        <source>Kind of controller</source>
        <translation>控制器类型</translation>
    </message>
    <message>
        <source>Calm to brisk</source>
        <translation>平稳到敏捷</translation>
    </message>
    <message>
        <source>Disturbance to set point</source>
        <translation>扰动到设定值</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>前后对比</translation>
    </message>
    <message>
        <source>Model:</source>
        <translation>模型：</translation>
    </message>
    <message>
        <source>Rule:</source>
        <translation>规则：</translation>
    </message>
    <message>
        <source>Controller:</source>
        <translation>控制器：</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>平稳</translation>
    </message>
    <message>
        <source>Brisk</source>
        <translation>敏捷</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>扰动</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>The program has no controller block; call one, for example PID.</source>
        <translation>程序没有控制器块；请调用一个，例如 PID。</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>正在查找…</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) found, %1 used.</source>
        <translation>
            <numerusform>找到 %n 个阶跃，使用 %1 个。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, explains %2 %</source>
        <translation>%1，解释 %2 %</translation>
    </message>
    <message>
        <source>set point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Choose at least one step.</source>
        <translation>请至少选择一个阶跃。</translation>
    </message>
    <message>
        <source>The rule does not apply to this process; choose another rule.</source>
        <translation>该规则不适合此过程；请选择其他规则。</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>Integral time</source>
        <translation>积分时间</translation>
    </message>
    <message>
        <source>Derivative time</source>
        <translation>微分时间</translation>
    </message>
    <message>
        <source>Sensitivity Ms</source>
        <translation>灵敏度 Ms</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>不稳定</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>增益裕度</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>调节时间</translation>
    </message>
    <message>
        <source>Error after a load step</source>
        <translation>负载阶跃后的误差</translation>
    </message>
    <message>
        <source>Control effort</source>
        <translation>控制量消耗</translation>
    </message>
    <message>
        <source>Noise in the output</source>
        <translation>输出噪声</translation>
    </message>
    <message>
        <source>Recorded and modelled</source>
        <translation>记录与模型</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>时间 [s]</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>参数整定</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Taken back: %1</source>
        <translation>已还原：%1</translation>
    </message>
    <message>
        <source>Residuals of the model</source>
        <translation>模型残差</translation>
    </message>
    <message>
        <source>recorded minus model</source>
        <translation>记录值减模型值</translation>
    </message>
    <message>
        <source>loop now</source>
        <translation>当前回路</translation>
    </message>
    <message>
        <source>loop as proposed</source>
        <translation>建议的回路</translation>
    </message>
    <message>
        <source>Bode plot</source>
        <translation>伯德图</translation>
    </message>
    <message>
        <source>Bode Plot</source>
        <translation>伯德图</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>频率 [rad/s]</translation>
    </message>
    <message>
        <source>process</source>
        <translation>过程</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>增益裕度</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>Constants in the call: %1. Write Parameters changes them in the text and in the running controller by an online change.</source>
        <translation>调用中的常量：%1。“写入参数”会在文本中修改它们，并通过在线修改作用于运行中的控制器。</translation>
    </message>
    <message>
        <source>Computed in the call and not written: %1.</source>
        <translation>在调用中计算，未写入：%1。</translation>
    </message>
    <message>
        <source>The recorded disturbance with these settings</source>
        <translation>使用这些参数时记录的扰动</translation>
    </message>
    <message>
        <source>The recorded step with these settings</source>
        <translation>使用这些参数时记录的阶跃</translation>
    </message>
    <message>
        <source>The text was changed since the controller was started: change the constants after the next start or online change.</source>
        <translation>控制器启动后文本已更改：请在下次启动或在线修改后更改常量。</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>响应</translation>
    </message>
    <message>
        <source>Start the controller or open a recording to search it for steps.</source>
        <translation>请启动控制器或打开记录；将在其中查找阶跃。</translation>
    </message>
    <message>
        <source>disturbance</source>
        <translation>扰动</translation>
    </message>
    <message>
        <source>gain [dB]</source>
        <translation>增益 [dB]</translation>
    </message>
    <message>
        <source>phase [°]</source>
        <translation>相位 [°]</translation>
    </message>
    <message>
        <source>Health in figures</source>
        <translation>状况数据</translation>
    </message>
    <message>
        <source>The whole recording</source>
        <translation>整个记录</translation>
    </message>
    <message>
        <source>Save Report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Web pages (*.html);;PDF (*.pdf)</source>
        <translation>网页 (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Report written: %1</source>
        <translation>报告已写入：%1</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>报告…</translation>
    </message>
    <message>
        <source>Saves a report on the loop with model and settings as HTML or PDF.</source>
        <translation>将回路报告（含模型和参数设置）保存为 HTML 或 PDF。</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>状况</translation>
    </message>
</context>
<context>
    <name>plc::editor::WatchView</name>
    <message>
        <source>A list %1 already exists; choose another name</source>
        <translation>列表 %1 已存在；请使用其他名称</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>表达式</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Prepared</source>
        <translation>准备值</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>注释</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>监视列表</translation>
    </message>
    <message>
        <source>Add an expression: Main.x, a[i] * 2, fb.Q AND NOT done</source>
        <translation>添加表达式：Main.x、a[i] * 2、fb.Q AND NOT done</translation>
    </message>
    <message>
        <source>New watch expression</source>
        <translation>新建监视表达式</translation>
    </message>
    <message>
        <source>Write prepared values</source>
        <translation>写入准备值</translation>
    </message>
    <message>
        <source>Force prepared values</source>
        <translation>强制准备值</translation>
    </message>
    <message>
        <source>Release the selected forces</source>
        <translation>解除所选强制</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>十进制</translation>
    </message>
    <message>
        <source>Hexadecimal</source>
        <translation>十六进制</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>二进制</translation>
    </message>
    <message>
        <source>Number format</source>
        <translation>数字格式</translation>
    </message>
    <message>
        <source>Toggle</source>
        <translation>切换</translation>
    </message>
    <message>
        <source>Force to %1</source>
        <translation>强制为 %1</translation>
    </message>
    <message>
        <source>Release Force</source>
        <translation>解除强制</translation>
    </message>
    <message>
        <source>Show in Trace</source>
        <translation>在跟踪中显示</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>全部移除</translation>
    </message>
    <message>
        <source>Time</source>
        <comment>number format</comment>
        <translation>时间</translation>
    </message>
    <message>
        <source>Numbers as decimals, in hexadecimal or binary, or milliseconds as a time</source>
        <translation>数字按十进制、十六进制或二进制显示，或将毫秒显示为时间</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <comment>stretch of an array</comment>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>监视</translation>
    </message>
    <message>
        <source>Add, rename or remove a list</source>
        <translation>添加、重命名或移除列表</translation>
    </message>
    <message>
        <source>Name of the list:</source>
        <translation>列表名称：</translation>
    </message>
    <message>
        <source>New List…</source>
        <translation>新建列表…</translation>
    </message>
    <message>
        <source>New List</source>
        <translation>新建列表</translation>
    </message>
    <message>
        <source>Rename the List…</source>
        <translation>重命名列表…</translation>
    </message>
    <message>
        <source>Rename the List</source>
        <translation>重命名列表</translation>
    </message>
    <message>
        <source>Remove the List</source>
        <translation>移除列表</translation>
    </message>
    <message>
        <source>Number Format</source>
        <translation>数字格式</translation>
    </message>
    <message>
        <source>As in the list</source>
        <translation>与列表相同</translation>
    </message>
    <message>
        <source>Source of %1 with the Values of %2</source>
        <translation>%1 的源代码，带 %2 的值</translation>
    </message>
</context>
<context>
    <name>plc::editor::WhyView</name>
    <message>
        <source>For example Main.level &gt; 80</source>
        <translation>例如 Main.level &gt; 80</translation>
    </message>
    <message>
        <source>Variable or expression to explain</source>
        <translation>要解释的变量或表达式</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>为什么？</translation>
    </message>
    <message>
        <source>What changed it, and what had to hold</source>
        <translation>什么改变了它，以及必须满足的条件</translation>
    </message>
    <message>
        <source>Why Not?</source>
        <translation>为什么不？</translation>
    </message>
    <message>
        <source>The smallest changes that would change the result of the condition</source>
        <translation>使条件得出不同结果的最小更改</translation>
    </message>
    <message>
        <source>Who Set This?</source>
        <translation>谁设置了它？</translation>
    </message>
    <message>
        <source>All changes in the recording, and what made each of them</source>
        <translation>记录中的所有变化及其各自的原因</translation>
    </message>
    <message>
        <source>Explanation</source>
        <translation>解释</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>扫描周期</translation>
    </message>
    <message>
        <source>Right-click a variable in the text, the watch, the tree, the trace or a panel and ask why it has its value.</source>
        <translation>在文本、监视、项目树、跟踪或画面中右键单击变量，询问其值的由来。</translation>
    </message>
    <message>
        <source>Searching the recorded scans…</source>
        <translation>正在查看记录的扫描周期…</translation>
    </message>
    <message>
        <source>There is no recording yet: run the program first.</source>
        <translation>尚无记录：请先运行程序。</translation>
    </message>
    <message>
        <source>%1 · scan %2</source>
        <comment>time and number</comment>
        <translation>%1 · 扫描周期 %2</translation>
    </message>
    <message>
        <source>Earlier changes…</source>
        <translation>更早的变化…</translation>
    </message>
    <message>
        <source>Why Is %1 So?</source>
        <translation>为什么 %1 是这样？</translation>
    </message>
    <message>
        <source>Who Set %1?</source>
        <translation>谁设置了 %1？</translation>
    </message>
    <message>
        <source>Copy the Answer</source>
        <translation>复制答案</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancel (Esc)</source>
        <translation>取消 (Esc)</translation>
    </message>
    <message>
        <source>Cancelled: there is no answer.</source>
        <translation>已取消：没有答案。</translation>
    </message>
</context>
<context>
    <name>plc::hmi::AlarmEditor</name>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>优先级</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Add an alarm</source>
        <translation>添加报警</translation>
    </message>
    <message>
        <source>Add a class</source>
        <translation>添加类别</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Add alarm</source>
        <translation>添加报警</translation>
    </message>
    <message>
        <source>Add class</source>
        <translation>添加类别</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ArrayArrangementDialog</name>
    <message>
        <source>Arrange over array</source>
        <translation>按数组排列</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>数组</translation>
    </message>
    <message>
        <source>First index</source>
        <translation>首个下标</translation>
    </message>
    <message>
        <source>Last index</source>
        <translation>末个下标</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Horizontal gap</source>
        <translation>水平间距</translation>
    </message>
    <message>
        <source>Vertical gap</source>
        <translation>垂直间距</translation>
    </message>
    <message>
        <source>In the other arguments, # becomes the index.</source>
        <translation>在其他实参中，# 变为下标。</translation>
    </message>
    <message>
        <source>Choose an array with one index, for example Plant.Valves.</source>
        <translation>请选择只有一个下标的数组，例如 Plant.Valves。</translation>
    </message>
    <message>
        <source>They reach to %1 × %2, the panel only to %3 × %4: make the faceplate smaller or the panel larger.</source>
        <translation>它们延伸到 %1 × %2，而画面只到 %3 × %4：请缩小面板组件或扩大画面。</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ArrayDialog</name>
    <message>
        <source>Duplicate as array</source>
        <translation>复制为数组</translation>
    </message>
    <message>
        <source>Number of elements</source>
        <translation>元素数量</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Vertical gap</source>
        <translation>垂直间距</translation>
    </message>
    <message>
        <source>Index step</source>
        <translation>下标步长</translation>
    </message>
    <message>
        <source>Horizontal gap</source>
        <translation>水平间距</translation>
    </message>
</context>
<context>
    <name>plc::hmi::DesignCanvas</name>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Move point</source>
        <translation>移动点</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>插入</translation>
    </message>
    <message>
        <source>Resize</source>
        <translation>调整大小</translation>
    </message>
    <message>
        <source>Bind</source>
        <translation>绑定</translation>
    </message>
    <message>
        <source>%1 has no single value: drop one of its members, or first draw a panel with a parameter of the type %2</source>
        <translation>%1 没有单一的值：请拖放它的一个成员，或先绘制一个带有类型 %2 参数的画面</translation>
    </message>
    <message>
        <source>Place in cell</source>
        <translation>放入单元格</translation>
    </message>
</context>
<context>
    <name>plc::hmi::DesignContext</name>
    <message>
        <source>Text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Rename Theme</source>
        <translation>重命名主题</translation>
    </message>
</context>
<context>
    <name>plc::hmi::Outline</name>
    <message>
        <source>Lock</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>No elements yet. Drag one from the palette onto the panel.</source>
        <translation>尚无元素。请从选项板将元素拖到画面上。</translation>
    </message>
    <message>
        <source>Reorder</source>
        <translation>更改顺序</translation>
    </message>
</context>
<context>
    <name>plc::hmi::Palette</name>
    <message>
        <source>Search elements</source>
        <translation>搜索元素</translation>
    </message>
    <message>
        <source>Faceplates</source>
        <translation>面板组件</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>元素</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PanelDesigner</name>
    <message>
        <source>Issue</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Element</source>
        <translation>元素</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制一份</translation>
    </message>
    <message>
        <source>Duplicate as Array…</source>
        <translation>复制为数组…</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>全选</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Align Left</source>
        <translation>左对齐</translation>
    </message>
    <message>
        <source>Align Centres</source>
        <translation>水平居中对齐</translation>
    </message>
    <message>
        <source>Align Right</source>
        <translation>右对齐</translation>
    </message>
    <message>
        <source>Align Top</source>
        <translation>顶端对齐</translation>
    </message>
    <message>
        <source>Align Middles</source>
        <translation>垂直居中对齐</translation>
    </message>
    <message>
        <source>Align Bottom</source>
        <translation>底端对齐</translation>
    </message>
    <message>
        <source>Distribute Horizontally</source>
        <translation>水平均匀分布</translation>
    </message>
    <message>
        <source>Distribute Vertically</source>
        <translation>垂直均匀分布</translation>
    </message>
    <message>
        <source>Same Width</source>
        <translation>等宽</translation>
    </message>
    <message>
        <source>Same Height</source>
        <translation>等高</translation>
    </message>
    <message>
        <source>Bring to Front</source>
        <translation>置于顶层</translation>
    </message>
    <message>
        <source>Bring Forward</source>
        <translation>上移一层</translation>
    </message>
    <message>
        <source>Send Backward</source>
        <translation>下移一层</translation>
    </message>
    <message>
        <source>Send to Back</source>
        <translation>置于底层</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组合</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>取消组合</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>Show the Grid</source>
        <translation>显示网格</translation>
    </message>
    <message>
        <source>Snap (Alt: not now)</source>
        <translation>吸附（按住 Alt 暂不吸附）</translation>
    </message>
    <message>
        <source>Live Preview</source>
        <translation>实时预览</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Zoom Out</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Zoom 100 %</source>
        <translation>缩放 100 %</translation>
    </message>
    <message>
        <source>Zoom to Fit</source>
        <translation>缩放以适应</translation>
    </message>
    <message>
        <source>Language shown</source>
        <translation>显示的语言</translation>
    </message>
    <message>
        <source>Theme of the panel</source>
        <translation>画面主题</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>高对比度</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Duplicate as array</source>
        <translation>复制为数组</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>元素</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Same Size</source>
        <translation>等大小</translation>
    </message>
    <message>
        <source>Paste in Place</source>
        <translation>原位粘贴</translation>
    </message>
    <message>
        <source>Arrange Over Array…</source>
        <translation>按数组排列…</translation>
    </message>
    <message>
        <source>Arrange over array</source>
        <translation>按数组排列</translation>
    </message>
    <message>
        <source>Fix All Issues</source>
        <translation>修复所有问题</translation>
    </message>
    <message>
        <source>Fix Issue</source>
        <translation>修复问题</translation>
    </message>
    <message>
        <source>Explain Issue</source>
        <translation>解释问题</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>大纲</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Issues</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Lay Out in a Row</source>
        <translation>按行布局</translation>
    </message>
    <message>
        <source>Lay Out in a Column</source>
        <translation>按列布局</translation>
    </message>
    <message>
        <source>Lay Out in a Grid</source>
        <translation>按网格布局</translation>
    </message>
    <message>
        <source>Lay out</source>
        <translation>布局</translation>
    </message>
    <message>
        <source>Edit Themes…</source>
        <translation>编辑主题…</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PanelKeys</name>
    <message>
        <source>Panel</source>
        <translation>画面</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PasswordDialog</name>
    <message>
        <source>Set Password</source>
        <translation>设置密码</translation>
    </message>
    <message>
        <source>Password of %1:</source>
        <translation>%1 的密码：</translation>
    </message>
    <message>
        <source>The two passwords differ.</source>
        <translation>两次输入的密码不一致。</translation>
    </message>
    <message>
        <source>Repeat:</source>
        <translation>重复：</translation>
    </message>
    <message>
        <source>Repeat the password.</source>
        <translation>请重复密码。</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PeopleEditor</name>
    <message>
        <source>User</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Start panel</source>
        <translation>起始画面</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>密码</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>Add a User</source>
        <translation>添加用户</translation>
    </message>
    <message>
        <source>Set Password…</source>
        <translation>设置密码…</translation>
    </message>
    <message>
        <source>Remove User</source>
        <translation>移除用户</translation>
    </message>
    <message>
        <source>Add a Role</source>
        <translation>添加角色</translation>
    </message>
    <message>
        <source>Remove Role</source>
        <translation>移除角色</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>never</source>
        <translation>从不</translation>
    </message>
    <message>
        <source>Logged out after</source>
        <translation>自动退出登录时间</translation>
    </message>
    <message>
        <source>Logged out after </source>
        <translation>自动退出登录时间 </translation>
    </message>
    <message>
        <source>Logged Out After</source>
        <translation>自动退出登录时间</translation>
    </message>
    <message>
        <source>Set Password</source>
        <translation>设置密码</translation>
    </message>
    <message>
        <source>none: cannot log in</source>
        <translation>无：无法登录</translation>
    </message>
    <message>
        <source>set</source>
        <translation>已设置</translation>
    </message>
    <message>
        <source>Rename Role</source>
        <translation>重命名角色</translation>
    </message>
    <message>
        <source>Without users, everybody may do everything. Add a role, then a user with a password.</source>
        <translation>没有用户时，所有人都可以执行所有操作。请先添加角色，再添加带密码的用户。</translation>
    </message>
    <message>
        <source>To restrict an element to some users, set its property &quot;Only for the roles&quot;.</source>
        <translation>要将元素限制给某些用户，请设置其属性“仅限角色”。</translation>
    </message>
</context>
<context>
    <name>plc::hmi::PropertySheet</name>
    <message>
        <source>Search properties</source>
        <translation>搜索属性</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n 个元素</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::hmi::RecipeEditor</name>
    <message>
        <source>Add a Recipe</source>
        <translation>添加配方</translation>
    </message>
    <message>
        <source>Add a Variable</source>
        <translation>添加变量</translation>
    </message>
    <message>
        <source>Add a Set</source>
        <translation>添加数据组</translation>
    </message>
    <message>
        <source>Remove Row or Set</source>
        <translation>移除行或数据组</translation>
    </message>
    <message>
        <source>Remove Recipe</source>
        <translation>移除配方</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>导入 CSV</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>导出 CSV</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Variables and sets of the recipe</source>
        <translation>配方的变量和数据组</translation>
    </message>
    <message>
        <source>Rename Recipe</source>
        <translation>重命名配方</translation>
    </message>
    <message>
        <source>Rename Set</source>
        <translation>重命名数据组</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>名称：</translation>
    </message>
    <message>
        <source>Remove Set</source>
        <translation>移除数据组</translation>
    </message>
    <message>
        <source>Remove Row</source>
        <translation>移除行</translation>
    </message>
    <message>
        <source>Add a recipe, then its variables, then a set for each product.</source>
        <translation>请添加配方，然后添加其变量，再为每种产品添加一个数据组。</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>A recipe needs a name.</source>
        <translation>配方需要名称。</translation>
    </message>
    <message>
        <source>The recipe &quot;%1&quot; already exists; choose another name.</source>
        <translation>已存在配方“%1”；请使用其他名称。</translation>
    </message>
    <message>
        <source>The set &quot;%1&quot; already exists; choose another name.</source>
        <translation>已存在数据组“%1”；请使用其他名称。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number; a limit is written like 12.5.</source>
        <translation>“%1”不是数字；限值的写法例如 12.5。</translation>
    </message>
    <message>
        <source>A row needs a variable; Remove Row or Set takes the row away.</source>
        <translation>每行需要一个变量；“移除行或数据组”可删除该行。</translation>
    </message>
    <message>
        <source>%1 is already in the recipe; choose another variable.</source>
        <translation>%1 已在配方中；请选择其他变量。</translation>
    </message>
    <message>
        <source>Select a cell of the set that is to be renamed.</source>
        <translation>请选择要重命名的数据组中的单元格。</translation>
    </message>
</context>
<context>
    <name>plc::hmi::RecordsDialog</name>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下移</translation>
    </message>
</context>
<context>
    <name>plc::hmi::TextEditor</name>
    <message>
        <source>A key %1 already exists; choose another name</source>
        <translation>键 %1 已存在；请使用其他名称</translation>
    </message>
    <message>
        <source>Only incomplete</source>
        <translation>仅不完整的</translation>
    </message>
    <message>
        <source>Search texts</source>
        <translation>搜索文本</translation>
    </message>
    <message>
        <source>Add a key</source>
        <translation>添加键</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>键</translation>
    </message>
    <message>
        <source>Remove the selected keys</source>
        <translation>移除所选键</translation>
    </message>
    <message>
        <source>Add a language</source>
        <translation>添加语言</translation>
    </message>
    <message>
        <source>Language tag, for example de or zh-CN</source>
        <translation>语言标签，例如 de 或 zh-CN</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>导入 CSV</translation>
    </message>
    <message>
        <source>Text tables (*.csv *.txt)</source>
        <translation>文本表 (*.csv *.txt)</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>导出 CSV</translation>
    </message>
    <message>
        <source>Text tables (*.csv)</source>
        <translation>文本表 (*.csv)</translation>
    </message>
    <message>
        <source>Add key</source>
        <translation>添加键</translation>
    </message>
    <message>
        <source>Remove keys</source>
        <translation>移除键</translation>
    </message>
    <message>
        <source>Add language</source>
        <translation>添加语言</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>%n 条文本</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is not used.</source>
        <translation>%1 未使用。</translation>
    </message>
    <message>
        <source>%1 is used by %2</source>
        <translation>%1 被 %2 使用</translation>
    </message>
    <message>
        <source>Import XLIFF</source>
        <translation>导入 XLIFF</translation>
    </message>
    <message>
        <source>Translations (*.xlf *.xliff)</source>
        <translation>译文 (*.xlf *.xliff)</translation>
    </message>
    <message>
        <source>Export XLIFF</source>
        <translation>导出 XLIFF</translation>
    </message>
    <message>
        <source>Translated from</source>
        <translation>源语言</translation>
    </message>
    <message>
        <source>Translated into</source>
        <translation>目标语言</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) taken.</source>
        <translation>
            <numerusform>采用了 %n 条文本。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) as they were.</source>
        <translation>
            <numerusform>%n 条文本保持不变。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) without a translation.</source>
        <translation>
            <numerusform>%n 条文本没有译文。</numerusform>
        </translation>
    </message>
    <message>
        <source>XLIFF %1</source>
        <translation>XLIFF %1</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Remove language</source>
        <translation>移除语言</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>%1 is not a language tag; choose one from the list, or enter a tag such as de or zh-CN</source>
        <translation>%1 不是语言标签；请从列表中选择，或输入 de、zh-CN 之类的标签</translation>
    </message>
    <message>
        <source>The table already has %1; choose another language</source>
        <translation>表中已有 %1；请选择其他语言</translation>
    </message>
    <message>
        <source>Remove the language</source>
        <translation>移除语言</translation>
    </message>
    <message>
        <source>Select a cell of the language that is to be removed.</source>
        <translation>请选择要移除的语言中的单元格。</translation>
    </message>
    <message>
        <source>A table of texts keeps one language; add another one first.</source>
        <translation>文本表至少保留一种语言；请先添加另一种。</translation>
    </message>
</context>
<context>
    <name>plc::hmi::TextModel</name>
    <message>
        <source>Key</source>
        <translation>键</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>注释</translation>
    </message>
    <message>
        <source>Rename key</source>
        <translation>重命名键</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文本</translation>
    </message>
</context>
<context>
    <name>plc::hmi::ThemeDialog</name>
    <message>
        <source>Grounds, lines and texts</source>
        <translation>背景、线条和文本</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>过程</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Colours by name</source>
        <translation>按名称的颜色</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Based on</source>
        <translation>基于</translation>
    </message>
    <message>
        <source>Colours that this theme does not change are those of the base.</source>
        <translation>此主题未更改的颜色沿用基础主题。</translation>
    </message>
    <message>
        <source>Panel Themes</source>
        <translation>画面主题</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Base of the Theme</source>
        <translation>主题的基础</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>新建…</translation>
    </message>
    <message>
        <source>New Theme</source>
        <translation>新建主题</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Rename Theme</source>
        <translation>重命名主题</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Name of the theme:</source>
        <translation>主题名称：</translation>
    </message>
    <message>
        <source>A theme&apos;s name cannot contain %1; choose another name</source>
        <translation>主题名称不能包含 %1；请选择其他名称</translation>
    </message>
    <message>
        <source>A theme&apos;s name begins with a letter or a digit</source>
        <translation>主题名称以字母或数字开头</translation>
    </message>
    <message>
        <source>There is a theme %1 already; choose another name</source>
        <translation>已有主题 %1；请选择其他名称</translation>
    </message>
    <message>
        <source>There is a file %1 already; choose another name</source>
        <translation>已有文件 %1；请选择其他名称</translation>
    </message>
    <message>
        <source>%1 is used on %2; choose another theme there before it is deleted</source>
        <translation>%1 正在 %2 中使用；请先在那里选择其他主题</translation>
    </message>
    <message>
        <source>Delete Theme</source>
        <translation>删除主题</translation>
    </message>
    <message>
        <source>The project has no theme of its own yet. New… makes one that begins with the colours shown.</source>
        <translation>项目还没有自己的主题。“新建…”以当前显示的颜色创建一个主题。</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>以及另外 %n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 on %2: contrast %L3, %L4 is needed</source>
        <translation>%1 在 %2 上：对比度 %L3，需要 %L4</translation>
    </message>
    <message>
        <source>Changed on disk too: %1. OK replaces what is there.</source>
        <translation>磁盘上也已更改：%1。“确定”会替换磁盘上的内容。</translation>
    </message>
    <message>
        <source>Discard the changes of the themes?</source>
        <translation>放弃对主题的更改？</translation>
    </message>
</context>
<context>
    <name>plc::kit::Canvas</name>
    <message>
        <source>Overview</source>
        <translation>总览</translation>
    </message>
</context>
<context>
    <name>plc::kit::ColorPopup</name>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>More colours…</source>
        <translation>更多颜色…</translation>
    </message>
    <message>
        <source>No colour</source>
        <translation>无颜色</translation>
    </message>
</context>
<context>
    <name>plc::kit::ColumnMenu</name>
    <message>
        <source>Column %1</source>
        <translation>第 %1 列</translation>
    </message>
    <message>
        <source>Fit to Contents</source>
        <translation>适应内容</translation>
    </message>
    <message>
        <source>Wider</source>
        <translation>加宽</translation>
    </message>
    <message>
        <source>Narrower</source>
        <translation>收窄</translation>
    </message>
    <message>
        <source>Move Left</source>
        <translation>左移</translation>
    </message>
    <message>
        <source>Move Right</source>
        <translation>右移</translation>
    </message>
    <message>
        <source>Sort Ascending</source>
        <translation>升序排序</translation>
    </message>
    <message>
        <source>Sort Descending</source>
        <translation>降序排序</translation>
    </message>
</context>
<context>
    <name>plc::kit::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation>命令面板</translation>
    </message>
    <message>
        <source>Type to find a command</source>
        <translation>输入以查找命令</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>menu and command</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>plc::kit::PropertyGrid</name>
    <message>
        <source>Choose a variable</source>
        <translation>选择变量</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>选择文件</translation>
    </message>
    <message>
        <source>Edit in a window</source>
        <translation>在窗口中编辑</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>No</source>
        <translation>否</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>various</source>
        <translation>多个值</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Choose from a list</source>
        <translation>从列表中选择</translation>
    </message>
</context>
<context>
    <name>plc::kit::VariablePicker</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>注释</translation>
    </message>
    <message>
        <source>Search variables</source>
        <translation>搜索变量</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Found variables</source>
        <translation>找到的变量</translation>
    </message>
    <message>
        <source>Choose a variable</source>
        <translation>选择变量</translation>
    </message>
</context>
<context>
    <name>plc::kit::WorkStrip</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>%1 is being cancelled…</source>
        <translation>正在取消：%1…</translation>
    </message>
    <message>
        <source>Cancel: %1</source>
        <translation>取消：%1</translation>
    </message>
</context>
<context>
    <name>plc::plot::PlotView</name>
    <message>
        <source>Chart</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>%1
Click selects, Ctrl+click shows or hides.</source>
        <translation>%1
单击选择，Ctrl+单击显示或隐藏。</translation>
    </message>
</context>
<context>
    <name>plc::trace::ChannelPanel</name>
    <message>
        <source>Variable or expression</source>
        <translation>变量或表达式</translation>
    </message>
    <message>
        <source>Add a channel</source>
        <translation>添加通道</translation>
    </message>
    <message>
        <source>Add as a channel</source>
        <translation>添加为通道</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Show channel</source>
        <translation>显示通道</translation>
    </message>
    <message>
        <source>Hide channel</source>
        <translation>隐藏通道</translation>
    </message>
    <message>
        <source>Chart %1</source>
        <translation>曲线图 %1</translation>
    </message>
    <message>
        <source>error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>表达式</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>样式</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>线</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>阶梯</translation>
    </message>
    <message>
        <source>Digital</source>
        <translation>数字量</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>线宽</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>系数</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>New chart</source>
        <translation>新建曲线图</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>轴 %1</translation>
    </message>
    <message>
        <source>New axis</source>
        <translation>新建轴</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>Share of height</source>
        <translation>高度占比</translation>
    </message>
    <message>
        <source>Scaling</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Fit to view</source>
        <translation>适应视图</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>On the right</source>
        <translation>在右侧</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>跟踪</translation>
    </message>
    <message>
        <source>Every n-th scan</source>
        <translation>每 n 个扫描周期</translation>
    </message>
    <message>
        <source>Record while</source>
        <translation>记录条件</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>触发器</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>边沿</translation>
    </message>
    <message>
        <source>Rising</source>
        <translation>上升沿</translation>
    </message>
    <message>
        <source>Falling</source>
        <translation>下降沿</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>两者</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>电平</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>单次</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>Shown before</source>
        <translation>触发前显示</translation>
    </message>
    <message>
        <source>Shown after</source>
        <translation>触发后显示</translation>
    </message>
    <message>
        <source>Change channel</source>
        <translation>更改通道</translation>
    </message>
    <message>
        <source>Change chart</source>
        <translation>更改曲线图</translation>
    </message>
    <message>
        <source>Change trace</source>
        <translation>更改跟踪</translation>
    </message>
    <message>
        <source>Remove channel</source>
        <translation>移除通道</translation>
    </message>
    <message>
        <source>Remove chart</source>
        <translation>移除曲线图</translation>
    </message>
    <message>
        <source>Move channel</source>
        <translation>移动通道</translation>
    </message>
    <message>
        <source>Compared recording</source>
        <translation>比较的记录</translation>
    </message>
    <message>
        <source>Offset in time</source>
        <translation>时间偏移</translation>
    </message>
</context>
<context>
    <name>plc::trace::FigurePane</name>
    <message>
        <source>Save as %1</source>
        <translation>保存为 %1</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应</translation>
    </message>
    <message>
        <source>Copy as Picture</source>
        <translation>复制为图片</translation>
    </message>
    <message>
        <source>Save as %1…</source>
        <translation>保存为 %1…</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗函数</translation>
    </message>
    <message>
        <source>Hann window</source>
        <translation>汉宁窗</translation>
    </message>
    <message>
        <source>Flat top: exact amplitudes</source>
        <translation>平顶窗：幅值准确</translation>
    </message>
    <message>
        <source>No window</source>
        <translation>不加窗</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>对数</translation>
    </message>
    <message>
        <source>Charts over time only</source>
        <translation>仅时间曲线图</translation>
    </message>
    <message>
        <source>Horizontal value</source>
        <translation>横轴值</translation>
    </message>
    <message>
        <source>Window of the spectrum</source>
        <translation>频谱的窗函数</translation>
    </message>
    <message>
        <source>Logarithmic axes</source>
        <translation>对数坐标轴</translation>
    </message>
    <message>
        <source>Input:</source>
        <translation>输入：</translation>
    </message>
    <message>
        <source>Horizontal:</source>
        <translation>横轴：</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Measure between Points</source>
        <translation>测量两点之间</translation>
    </message>
</context>
<context>
    <name>plc::trace::TimeBar</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Resumed from here
%1</source>
        <translation>已从此处继续
%1</translation>
    </message>
</context>
<context>
    <name>plc::trace::TimeSlider</name>
    <message>
        <source>Time slider</source>
        <translation>时间滑块</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Variable whose changes to step to</source>
        <translation>按其变化前后跳转的变量</translation>
    </message>
    <message>
        <source>The arrows beside step to its previous and next change</source>
        <translation>旁边的箭头跳到其上一次和下一次变化</translation>
    </message>
    <message>
        <source>One scan back (Left)</source>
        <translation>后退一个扫描周期（左箭头）</translation>
    </message>
    <message>
        <source>One scan forward (Right)</source>
        <translation>前进一个扫描周期（右箭头）</translation>
    </message>
    <message>
        <source>Previous change of the variable (Ctrl+Left)</source>
        <translation>变量的上一次变化（Ctrl+左箭头）</translation>
    </message>
    <message>
        <source>Next change of the variable (Ctrl+Right)</source>
        <translation>变量的下一次变化（Ctrl+右箭头）</translation>
    </message>
    <message>
        <source>Resume the controller from this scan</source>
        <translation>从此扫描周期继续运行控制器</translation>
    </message>
    <message>
        <source>Back to the newest scan (End)</source>
        <translation>返回最新的扫描周期 (End)</translation>
    </message>
    <message>
        <source>Older scans are no longer kept.</source>
        <translation>更早的扫描周期已不再保留。</translation>
    </message>
    <message>
        <source>%1 does not change before this scan.</source>
        <translation>%1 在此扫描周期之前没有变化。</translation>
    </message>
    <message>
        <source>%1 does not change after this scan.</source>
        <translation>%1 在此扫描周期之后没有变化。</translation>
    </message>
    <message>
        <source>No recording</source>
        <translation>没有记录</translation>
    </message>
    <message>
        <source>no longer kept</source>
        <translation>不再保留</translation>
    </message>
    <message>
        <source>scan %1  %2</source>
        <translation>扫描周期 %1  %2</translation>
    </message>
</context>
<context>
    <name>plc::trace::TraceView</name>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>跟踪</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Show channel</source>
        <translation>显示通道</translation>
    </message>
    <message>
        <source>Hide channel</source>
        <translation>隐藏通道</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>Follow the newest scan (End)</source>
        <translation>跟随最新的扫描周期 (End)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应</translation>
    </message>
    <message>
        <source>Show everything recorded (Home)</source>
        <translation>显示全部记录内容 (Home)</translation>
    </message>
    <message>
        <source>Fit values</source>
        <translation>适应数值</translation>
    </message>
    <message>
        <source>Let the value axes fit again</source>
        <translation>让数值轴重新适应</translation>
    </message>
    <message>
        <source>Zoom back</source>
        <translation>返回上一缩放</translation>
    </message>
    <message>
        <source>Back to the view before (Backspace)</source>
        <translation>返回上一视图 (Backspace)</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Drag a box to zoom: flat for time, upright for values</source>
        <translation>拖出方框进行缩放：扁框缩放时间，高框缩放数值</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>Drag to pan (middle button always does)</source>
        <translation>拖动以平移（鼠标中键始终可用）</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>光标</translation>
    </message>
    <message>
        <source>Two cursors (Ctrl+click sets A, Shift+click sets B)</source>
        <translation>两个光标（Ctrl+单击设置 A，Shift+单击设置 B）</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Table of values and statistics between the cursors</source>
        <translation>光标之间的数值和统计表</translation>
    </message>
    <message>
        <source>Measuring table</source>
        <translation>测量表</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>触发器</translation>
    </message>
    <message>
        <source>Arm the trigger set in the properties of the trace</source>
        <translation>启用跟踪属性中设置的触发器</translation>
    </message>
    <message>
        <source>Previous trigger</source>
        <translation>上一次触发</translation>
    </message>
    <message>
        <source>Where the trigger would have fired before</source>
        <translation>触发器此前本应触发的位置</translation>
    </message>
    <message>
        <source>Next trigger</source>
        <translation>下一次触发</translation>
    </message>
    <message>
        <source>Where the trigger would have fired next</source>
        <translation>触发器此后本应触发的位置</translation>
    </message>
    <message>
        <source>Add chart</source>
        <translation>添加曲线图</translation>
    </message>
    <message>
        <source>Another chart over the same time</source>
        <translation>同一时间段的另一个曲线图</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Load an older recording beneath the present one</source>
        <translation>在当前记录下方加载较早的记录</translation>
    </message>
    <message>
        <source>Recording to draw beneath</source>
        <translation>绘制在下方的记录</translation>
    </message>
    <message>
        <source>Trace configuration</source>
        <translation>跟踪配置</translation>
    </message>
    <message>
        <source>Open Configuration…</source>
        <translation>打开配置…</translation>
    </message>
    <message>
        <source>Open trace configuration</source>
        <translation>打开跟踪配置</translation>
    </message>
    <message>
        <source>Trace configurations (*.trace.json)</source>
        <translation>跟踪配置 (*.trace.json)</translation>
    </message>
    <message>
        <source>Save trace configuration</source>
        <translation>保存跟踪配置</translation>
    </message>
    <message>
        <source>Save Configuration</source>
        <translation>保存配置</translation>
    </message>
    <message>
        <source>Save Configuration As…</source>
        <translation>配置另存为…</translation>
    </message>
    <message>
        <source>Open Recording…</source>
        <translation>打开记录…</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>Back to the Running PLC</source>
        <translation>返回实时 PLC</translation>
    </message>
    <message>
        <source>Save Recording…</source>
        <translation>保存记录…</translation>
    </message>
    <message>
        <source>Save recording</source>
        <translation>保存记录</translation>
    </message>
    <message>
        <source>Recordings (*.rec)</source>
        <translation>记录 (*.rec)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Copy as Picture</source>
        <translation>复制为图片</translation>
    </message>
    <message>
        <source>Save Samples in View as CSV…</source>
        <translation>将可见采样保存为 CSV…</translation>
    </message>
    <message>
        <source>Save as %1…</source>
        <translation>保存为 %1…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>打印…</translation>
    </message>
    <message>
        <source>Save as %1</source>
        <translation>保存为 %1</translation>
    </message>
    <message>
        <source>Add channel</source>
        <translation>添加通道</translation>
    </message>
    <message>
        <source>Arm trigger</source>
        <translation>启用触发器</translation>
    </message>
    <message>
        <source>The trigger has no expression yet: enter one in the properties of the trace.</source>
        <translation>触发器尚无表达式：请在跟踪属性中输入。</translation>
    </message>
    <message>
        <source>Trigger armed</source>
        <translation>触发器已启用</translation>
    </message>
    <message>
        <source>Triggered, collecting</source>
        <translation>已触发，正在采集</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>已触发</translation>
    </message>
    <message numerus="yes">
        <source>(%n shot(s))</source>
        <translation>
            <numerusform>（%n 次触发）</numerusform>
        </translation>
    </message>
    <message>
        <source>Not running</source>
        <translation>未运行</translation>
    </message>
    <message>
        <source>%L1 scans kept  ·  history %2 of %3 MB  ·  channels %4 of %5 MB</source>
        <translation>已保留 %L1 个扫描周期  ·  历史 %2 / %3 MB  ·  通道 %4 / %5 MB</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Remove Channel</source>
        <translation>移除通道</translation>
    </message>
    <message>
        <source>Add Channel…</source>
        <translation>添加通道…</translation>
    </message>
    <message>
        <source>Trigger off</source>
        <translation>关闭触发器</translation>
    </message>
    <message>
        <source>Saving the samples…</source>
        <translation>正在保存采样…</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>正在打开 %1…</translation>
    </message>
    <message>
        <source>Saving the recording…</source>
        <translation>正在保存记录…</translation>
    </message>
    <message>
        <source>%1, %2 later</source>
        <translation>%1，晚 %2</translation>
    </message>
    <message>
        <source>%1, %2 earlier</source>
        <translation>%1，早 %2</translation>
    </message>
    <message>
        <source>Measure between points</source>
        <translation>测量两点之间</translation>
    </message>
    <message>
        <source>Drag from one point to another: time, value, slope and frequency between them (M)</source>
        <translation>从一点拖到另一点：显示两点间的时间、值、斜率和频率 (M)</translation>
    </message>
    <message>
        <source>XY plot, spectrum, frequency response, runs</source>
        <translation>XY 图、频谱、频率响应、各次运行</translation>
    </message>
    <message>
        <source>Add Channel of Another File…</source>
        <translation>添加其他文件的通道…</translation>
    </message>
    <message>
        <source>Show Beside</source>
        <translation>并排显示</translation>
    </message>
    <message>
        <source>Measure between Points</source>
        <translation>测量两点之间</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>添加备注</translation>
    </message>
    <message>
        <source>Add Note</source>
        <translation>添加备注</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>备注：</translation>
    </message>
    <message>
        <source>Edit Note</source>
        <translation>编辑备注</translation>
    </message>
    <message>
        <source>Edit note</source>
        <translation>编辑备注</translation>
    </message>
    <message>
        <source>Remove note</source>
        <translation>移除备注</translation>
    </message>
    <message>
        <source>Edit Note…</source>
        <translation>编辑备注…</translation>
    </message>
    <message>
        <source>Remove Note</source>
        <translation>移除备注</translation>
    </message>
    <message>
        <source>Add Note…</source>
        <translation>添加备注…</translation>
    </message>
    <message>
        <source>File to add a channel of</source>
        <translation>要添加通道的文件</translation>
    </message>
    <message>
        <source>Recordings and tables (*.rec *.csv *.tsv *.txt *.trace);;All files (*)</source>
        <translation>记录和表格 (*.rec *.csv *.tsv *.txt *.trace);;所有文件 (*)</translation>
    </message>
</context>
</TS>
