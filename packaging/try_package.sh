#!/usr/bin/env bash
# Installs the package into a bare Debian 12 in a folder of its own, runs every command there, builds a program with it,
# removes it and looks for what is left. As root, with debootstrap and a mirror.
# usage: packaging/try_package.sh PACKAGE.deb [FOLDER]   (default: /tmp/stepwise-bare)
set -euo pipefail
package=$(realpath "$1")
root=${2:-/tmp/stepwise-bare}
say() { printf '\033[1m==>\033[0m %s\n' "$*"; }
bare() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
list() { bare find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /tmp -o -path /var/cache -o -path /var/lib/apt -o -path /var/log \
    -o -path /var/lib/dpkg -o -path "/etc/*-" \) -prune -o -print | sort; }

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
list >/tmp/bare-before.txt
begin=$(date +%s)
bare apt-get install -y -q --no-install-recommends /tmp/stepwise.deb >>/tmp/bare-apt.log 2>&1 || { tail -5 /tmp/bare-apt.log; exit 1; }
say "installed in $(($(date +%s) - begin)) s"

try() { if bare "$@" >/tmp/bare-out.txt 2>&1; then echo "  good: $*"; else echo "  FAILED: $*"; cat /tmp/bare-out.txt; exit 1; fi; }
example=/usr/share/stepwise/examples
try stepwise --version
try stepwise --help
for command in $(bare stepwise --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
    try stepwise "$command" --help
    test -e "$root/usr/share/man/man1/stepwise-$command.1.gz" || { echo "no page of $command"; exit 1; }
done
try stepwise check $example/motor
try stepwise run $example/pid_pt1 --for 3s --record /tmp/run.rec
try stepwise test $example/motor
try stepwise replay /tmp/run.rec
try stepwise panel $example/alarm_texts --pictures /tmp/pictures
try stepwise trace $example/pid_pt1 --for 3s --picture /tmp/trace.png
for target in x86_64 aarch64; do try stepwise build $example/pid_pt1 --target $target --output /tmp/pid-$target; done
try /tmp/pid-x86_64 --for 3s --record /tmp/built.rec
cmp "$root/tmp/run.rec" "$root/tmp/built.rec"
echo "  good: the program built there records the same"
# By TERM: what a shell starts in the background ignores INT.
try timeout 60 sh -c 'stepwise serve /usr/share/stepwise/examples/motor --port 0 --state /tmp/serve >/tmp/serve.txt & until grep -q serving /tmp/serve.txt; do sleep 0.1; done; sleep 1; kill -TERM $!; wait $!'
test -s "$root/tmp/serve/access-code" && ls "$root"/tmp/serve/recording/*.rec >/dev/null
echo "  good: it served, kept its recording and stopped"
try sh -c 'QT_QPA_PLATFORM=offscreen timeout 5 stepwise /usr/share/stepwise/examples/motor; test $? = 124'
rm -rf "$root/root/.config" "$root/root/.local" "$root/root/.cache" "$root/root/Stepwise" "$root/root/Documents"
bare apt-get purge -y -q stepwise >>/tmp/bare-apt.log 2>&1
list >/tmp/bare-after.txt
if diff /tmp/bare-before.txt /tmp/bare-after.txt; then say "removed without a trace"; else echo "left behind or gone: above"; exit 1; fi
