#!/usr/bin/env bash
# Installs the package into a bare Debian 12 in a folder of its own, looks at the clock, lets every command of the table
# work on something there, builds a program with it, removes it and looks for what is left. As root, with debootstrap and
# a mirror; lintian first, where it is installed.
# usage: packaging/try_package.sh PACKAGE.deb [FOLDER]   (default: /tmp/stepwise-bare)
set -euo pipefail
package=$(realpath "$1")
root=${2:-/tmp/stepwise-bare}
say() { printf '\033[1m==>\033[0m %s\n' "$*"; }
bare() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
list() { bare find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /tmp -o -path /var/cache -o -path /var/lib/apt -o -path /var/log \
    -o -path /var/lib/dpkg -o -path "/etc/*-" \) -prune -o -print | sort; }

if command -v lintian >/dev/null; then
    lintian --allow-root --fail-on error "$package" >/tmp/lintian.log 2>&1 || { cat /tmp/lintian.log; exit 1; }
    say "lintian: no errors"
fi
if [ ! -x "$root/usr/bin/apt-get" ]; then
    say "a bare Debian 12 in $root"
    debootstrap --variant=minbase --include=ca-certificates bookworm "$root" >"/tmp/debootstrap.log" 2>&1 || { tail -5 /tmp/debootstrap.log; exit 1; }
    for suite in bookworm bookworm-updates; do echo "deb http://deb.debian.org/debian $suite main"; done >"$root/etc/apt/sources.list"
    echo "deb http://deb.debian.org/debian-security bookworm-security main" >>"$root/etc/apt/sources.list"
fi
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT
cp "$package" "$root/tmp/stepwise.deb"
bare apt-get update -q >"/tmp/bare-apt.log" 2>&1
# What the package needs, first: what is left behind is then the package's own.
say "what the package depends on"
bare sh -c 'apt-get install -y -q --no-install-recommends $(dpkg-deb -f /tmp/stepwise.deb Depends | sed "s/([^)]*)//g; s/|[^,]*//g; s/,/ /g") lld-19 shared-mime-info' >>/tmp/bare-apt.log 2>&1 ||
    { tail -5 /tmp/bare-apt.log; exit 1; }
bare apt-get purge -y -q stepwise >>/tmp/bare-apt.log 2>&1 || true # of a run that was cut short
bare rm -rf /usr/share/stepwise /tmp/try /tmp/serve /tmp/imported
list >/tmp/bare-before.txt
begin=$(date +%s)
bare apt-get install -y -q --no-install-recommends /tmp/stepwise.deb >>/tmp/bare-apt.log 2>&1 || { tail -5 /tmp/bare-apt.log; exit 1; }
took=$(($(date +%s) - begin))
say "installed in $took s"
[ "$took" -lt 60 ] || { echo "that is more than a minute"; exit 1; }

tried=" "
fail() { echo "  FAILED: $*"; exit 1; }
try() {
    [ "$1" != stepwise ] || tried+="$2 "
    if bare "$@" >/tmp/bare-out.txt 2>&1; then echo "  good: $*"; else cat /tmp/bare-out.txt; fail "$*"; fi
}
says() { grep -q -- "$1" /tmp/bare-out.txt || { cat /tmp/bare-out.txt; fail "it does not say $1"; }; }
# What a client sends: messages with their length, as editors do.
talk() { # command message…
    local command=$1 message
    shift
    for message in "$@"; do printf 'Content-Length: %d\r\n\r\n%s' "${#message}" "$message"; done >"$root/tmp/talk"
    try sh -c "timeout 60 stepwise $command </tmp/talk"
    tried+="$command "
}
example=/usr/share/stepwise/examples
commands=$(bare stepwise --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
try stepwise --version
try stepwise --help
for command in $commands; do
    try stepwise "$command" --help
    test -e "$root/usr/share/man/man1/stepwise-$command.1.gz" || fail "no page of $command"
done
tried=" " # from here on commands that work on something
bare rm -rf /tmp/try
bare cp -r $example /tmp/try
try stepwise check $example/motor
try stepwise run $example/pid_pt1 --for 3s --record /tmp/run.rec
try stepwise fmt /tmp/try/motor
try stepwise test $example/motor
try stepwise trace $example/pid_pt1 --for 3s --picture /tmp/trace.png
try stepwise replay /tmp/run.rec
try stepwise panel $example/alarm_texts --pictures /tmp/pictures
try stepwise doc library --out /tmp/reference
try stepwise convert $example/weigh --to st
try stepwise export $example/motor --to /tmp/motor.xml
bare rm -rf /tmp/imported
try stepwise import /tmp/motor.xml --to /tmp/imported
try stepwise check /tmp/imported
try stepwise ladder $example/motor --pou Main
try stepwise why $example/motor IO.K1 --set 'Plant.StartButton=TRUE@1s' --at 1.5s
try stepwise tune $example/cascade --loop Main.controller.PI --set Main.SetPoint=24.0@200s --for 600s
try stepwise texts $example/alarm_texts --export /tmp/alarm_texts.de.xlf --language de
try stepwise recipe $example/bottling --list
try stepwise people /tmp/try/motor --user anna --role operator
try sh -c 'stepwise alarms /tmp/try/alarm_texts 2>&1 | grep "no journal of alarms yet"'
tried+="alarms "
try stepwise devices $example/modbus_tank
try stepwise explain P3025
for target in x86_64 aarch64; do try stepwise build $example/pid_pt1 --target $target --output /tmp/pid-$target; done
try /tmp/pid-x86_64 --for 3s --record /tmp/built.rec
cmp "$root/tmp/run.rec" "$root/tmp/built.rec"
echo "  good: the program built there records the same"
talk lsp '{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}' '{"jsonrpc":"2.0","method":"initialized","params":{}}' \
    '{"jsonrpc":"2.0","id":2,"method":"shutdown"}' '{"jsonrpc":"2.0","method":"exit"}'
says '"capabilities"'
talk dap '{"seq":1,"type":"request","command":"initialize","arguments":{"adapterID":"stepwise"}}' '{"seq":2,"type":"request","command":"disconnect"}'
says '"supportsStepBack":true'
printf '%s\n' '{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"protocolVersion":"2024-11-05","capabilities":{},"clientInfo":{"name":"try","version":"1"}}}' \
    '{"jsonrpc":"2.0","id":2,"method":"tools/call","params":{"name":"check","arguments":{"path":"'$example/motor'"}}}' >"$root/tmp/talk"
try sh -c 'timeout 60 stepwise mcp </tmp/talk'
says '"content"'
tried+="mcp "
# By TERM: what a shell starts in the background ignores INT.
try timeout 100 sh -c 'rm -rf /tmp/serve; stepwise serve /usr/share/stepwise/examples/motor --port 0 --state /tmp/serve >/tmp/serve.txt &
    until grep -q serving /tmp/serve.txt; do sleep 0.1; done
    url=$(sed -n "s/.*\(http:[^ ]*\).*/\1/p" /tmp/serve.txt | head -1)
    stepwise attach $url state --code /tmp/serve/attach-code && stepwise attach $url list K1 --code /tmp/serve/attach-code; attached=$?
    sleep 1; kill -TERM $!; wait $! && exit $attached'
says IO.K1
tried+="serve attach "
# An example in its place is the package's: what outlives the controller goes to the user.
try timeout 100 stepwise serve $example/motor --port 0 --trial 10s
says 'the recording are in /root/.local/state/stepwise/motor-'
test ! -e "$root$example/motor/.stepwise" || fail "it wrote into the installed example"
test -s "$root/tmp/serve/access-code" && ls "$root"/tmp/serve/recording/*.rec >/dev/null
echo "  good: it served, was attached to, kept its recording and stopped"
for command in $commands; do [[ $tried == *" $command "* ]] || fail "nobody tried $command: add a line for it here"; done
echo "  good: all $(wc -w <<<"$commands") commands of the table"
try sh -c 'QT_QPA_PLATFORM=offscreen timeout 5 stepwise /tmp/try/motor; test $? = 124'
try sh -c 'dpkg -L stepwise | while read -r file; do test -e "$file" || { echo "$file is missing"; exit 1; }; done'
# The tarball that was made with the package: unpacked anywhere, and the packages that the page names bring every library it needs.
tarball=$(ls "$(dirname "$package")"/stepwise-*.tar.gz 2>/dev/null | head -1 || true)
if [ -n "$tarball" ]; then
    rm -rf "$root/tmp/portable"
    mkdir "$root/tmp/portable"
    tar xzf "$tarball" -C "$root/tmp/portable" --strip-components=1
    here=/tmp/portable/share/stepwise/examples
    try /tmp/portable/bin/stepwise check $here/motor
    try /tmp/portable/bin/stepwise build $here/pid_pt1 --output /tmp/pid-portable
    try /tmp/pid-portable --for 3s --record /tmp/portable.rec
    cmp "$root/tmp/run.rec" "$root/tmp/portable.rec"
    try timeout 100 /tmp/portable/bin/stepwise serve $here/motor --port 0 --trial 10s
    test ! -e "$root$here/motor/.stepwise" || fail "it wrote into the example of the tarball"
    # shellcheck disable=SC2046
    closure=$(bare apt-cache depends --recurse --no-recommends --no-suggests --no-conflicts --no-breaks --no-replaces --no-enhances \
        $(tr '\n' ' ' <"$(dirname "$0")/../docs/install.md" | grep -o 'apt install lib[^`]*' | sed 's/apt install//') | grep -v '^ ')
    for library in $(objdump -p "$root/tmp/portable/bin/stepwise" | sed -n 's/^ *NEEDED *//p'); do
        owner=$(bare sh -c "dpkg -S '*/$library' | head -1 | cut -d: -f1")
        grep -qx "$owner" <<<"$closure" || fail "docs/install.md does not name $owner, which has $library"
    done
    echo "  good: the tarball, and the packages that docs/install.md names for it"
fi
rm -rf "$root/root/.config" "$root/root/.local" "$root/root/.cache" "$root/root/Stepwise" "$root/root/Documents"
bare apt-get purge -y -q stepwise >>/tmp/bare-apt.log 2>&1
list >/tmp/bare-after.txt
if diff /tmp/bare-before.txt /tmp/bare-after.txt; then say "removed without a trace"; else echo "left behind or gone: above"; exit 1; fi
