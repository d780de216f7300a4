#!/usr/bin/env bash
# x11/install/package.sh [FOLDER]: builds the Debian package of the last commit in FOLDER, by default
# build/package. It first installs the packages that are missing. At the end it prints the package's size and
# what it depends on.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../setup.sh"

debian=$root/x11/install/debian
folder=$(realpath -m "${1:-$root/build/package}")
mapfile -t needed < <(sed -n '/^Build-Depends:/,/^[^ B]/s/^ \([a-z0-9+.-]*\).*/\1/p' "$debian/control" |
  sed 's/^debhelper-compat$/debhelper/')
need build-essential fakeroot git xz-utils "${needed[@]}"

# debian/ belongs at the top of the source package. In the project it stands with the rest of the install.
version=$(sed -n '1s/.*(\(.*\)-.*/\1/p' "$debian/changelog")
source=$folder/xnewell-$version
rm -rf "$folder" && mkdir -p "$folder"
git -C "$root" archive --format=tar --prefix="xnewell-$version/" HEAD | xz >"$folder/xnewell_$version.orig.tar.xz"
tar -C "$folder" -xf "$folder/xnewell_$version.orig.tar.xz"
cp -a "$source/x11/install/debian" "$source/debian"
cd "$source"
logged "$folder/build.log" "building the package" dpkg-buildpackage -us -uc
for package in "$folder"/*.deb; do
  [[ $package == *-dbgsym_* ]] ||
    dpkg-deb --show --showformat '${Package} ${Version}: ${Installed-Size} KiB installed\n${Depends}\n' "$package"
  say "$package"
done
