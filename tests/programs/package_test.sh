#!/usr/bin/env bash
# package_test.sh PACKAGE SCRATCH: makes a minimal Debian 12 in SCRATCH, with nothing of this machine but where its apt
# finds Debian's packages; installs the package there by apt, renders as a user, and removes the package again. Takes
# minutes. Exits with 77 (skipped) where that cannot be done.
set -eu
export LC_ALL=C.UTF-8
skip() { echo "skipped: package_test.sh: $1"; exit 77; }
[ "$(id -u)" -eq 0 ] || skip 'not root'
command -v debootstrap >/dev/null || skip 'debootstrap is missing'
# What is mounted in a namespace of its own is gone with it, whatever happens.
if [ "${LAVARAY_PACKAGE_TEST:-}" != inside ]; then
  unshare --mount --pid --fork true 2>/dev/null || skip 'there are no mount namespaces for it'
  LAVARAY_PACKAGE_TEST=inside exec unshare --mount --pid --fork --kill-child "$0" "$@"
fi

package=$(realpath "$1") scratch=$2
tests=$(realpath "$(dirname "$0")")
root=$scratch/root
mkdir -p "$scratch"
remove_root() {
  ! mountpoint -q "$root/proc" || umount "$root/proc"
  rm -rf --one-file-system "$root"
}
remove_root
trap remove_root EXIT

repositories() {
  apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' |
    grep -E ' bookworm(-updates|-security)? ' || true
}
sources=$(repositories)
[ -n "$sources" ] || { apt-get update -q && sources=$(repositories); }
mirror=$(awk '$3 == "bookworm" { print $2; exit }' <<<"$sources")
[ -n "$mirror" ] || skip "this machine's apt has no repository of Debian 12"

failures=0
checks=0
# holds WHAT COMMAND...: the command succeeds.
holds() {
  checks=$((checks + 1))
  "${@:2}" >"$scratch/output" 2>&1 && return
  failures=$((failures + 1))
  echo "FAILED: $1"
  tail -n 20 "$scratch/output"
}
in_root() {
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"
}
# As a user, in the user's own folder.
as_user() {
  chroot --userspec=painter:painter "$root" env -i PATH=/usr/bin:/bin LC_ALL=C.UTF-8 HOME=/home/painter \
    sh -c 'cd && exec "$@"' sh "$@"
}

echo "making a minimal Debian 12 in $root"
eval "$(apt-config shell http_proxy Acquire::http::Proxy)"
[ -z "${http_proxy:-}" ] || export http_proxy
case $mirror in https:*) include=--include=ca-certificates ;; *) include= ;; esac
debootstrap --variant=minbase $include bookworm "$root" "$mirror" >"$scratch/debootstrap.log" ||
  { tail -n 20 "$scratch/debootstrap.log"; exit 1; }
mount -t proc proc "$root/proc"
echo "$sources" >"$root/etc/apt/sources.list"
apt-config dump | grep -E '^Acquire::(https?::|Check-)' >"$root/etc/apt/apt.conf.d/90machine" || true
cp /etc/hosts /etc/resolv.conf "$root/etc"
in_root useradd --create-home painter
cp "$package" "$root/tmp/lavaray.deb"
holds 'apt-get update' in_root apt-get update -q
in_root apt-get clean
size_before=$(du -s --block-size=1M --one-file-system "$root" | cut -f1)

echo 'installing the package, without what it only recommends'
holds 'apt-get install' in_root apt-get install -y -q --no-install-recommends /tmp/lavaray.deb
in_root apt-get clean
size_after=$(du -s --block-size=1M --one-file-system "$root" | cut -f1)
version=$(dpkg-deb --field "$package" Version)
for program in lavaray lavaray-diff lavaray-merge; do
  holds "$program has the package's version" as_user sh -c "$program --version | grep -qxF '$program $version'"
  holds "$program has its manual page" in_root gzip -t "/usr/share/man/man1/$program.1.gz"
done

scene=/usr/share/lavaray/scenes/showcase.txt
golden=$tests/../golden/showcase.png
cp "$golden" "$root/home/painter/golden.png"
cp "$tests/completion_test.sh" "$root/home/painter"
start=$EPOCHREALTIME
holds 'a scene renders' as_user lavaray "$scene" --width 240 -o first.png
middle=$EPOCHREALTIME
holds 'a scene renders again' as_user lavaray "$scene" --width 240 -o second.png
end=$EPOCHREALTIME
holds 'the image is the golden one' as_user lavaray-diff first.png golden.png
holds 'the installed shaders compile' as_user lavaray "$scene" --width 240 -o third.png --shaders /usr/share/lavaray/shaders
holds 'they are those in the program' as_user lavaray-diff first.png third.png
for program in lavaray lavaray-diff lavaray-merge; do
  holds "$program has its completion" as_user grep -q "complete .* $program" "/usr/share/bash-completion/completions/$program"
done
holds 'the completion completes' \
  as_user bash completion_test.sh /usr/bin /usr/share/bash-completion/completions/lavaray /home/painter/completion

holds 'apt-get purge' in_root apt-get purge -y -q lavaray
left=$(find "$root/usr" "$root/etc" "$root/var/lib/dpkg/info" -name '*lavaray*')
holds "nothing is left: $left" test -z "$left"
if command -v lintian >/dev/null; then
  # The project states no license.
  holds 'lintian finds no errors' lintian --allow-root --fail-on error --suppress-tags no-copyright-file "$package"
else
  echo 'skipped: lintian is missing'
fi

seconds() { awk -v from="$1" -v to="$2" 'BEGIN { printf "%.2f", to - from }'; }
echo "figure: package of $(stat -c %s "$package") bytes, $(dpkg-deb --field "$package" Installed-Size) KiB installed," \
  "$((size_after - size_before)) MiB with what it depends on"
echo "figure: showcase in a minimal Debian 12 in $(seconds "$start" "$middle") s, again in $(seconds "$middle" "$end") s"
echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
