#!/usr/bin/env bash
# clean_root.sh make PACKAGE.deb ROOT   fills the folder ROOT with a package, what every Debian system has (essential and required packages), and
#                                       all that the package depends on and recommends, and nothing else. The files are those of the
#                                       packages that are installed here: no registry is needed, and a dependency that is missing
#                                       here is an error
# clean_root.sh run ROOT COMMAND...     runs a command there, which sees nothing of this system but its kernel
# Needs root, as chroot does. Mounts end with the command.
set -euo pipefail
usage() {
    sed -n '2,7s/^# //p' "$0" >&2
    exit 2
}

# Names in a field of the package; of alternatives the first that is installed.
field() {
    local alternatives name
    dpkg-deb -f "$package" "$1" | tr ',' '\n' | sed -E 's/\([^)]*\)//g; s/ //g' | while IFS= read -r alternatives; do
        [ -n "$alternatives" ] || continue
        name=
        for one in ${alternatives//|/ }; do
            if [ -z "$name" ] && installed "$one"; then
                name=$one
            fi
        done
        if [ -z "$name" ]; then
            echo "clean_root.sh: $alternatives, which the package asks for, is not installed here" >&2
            exit 1
        fi
        echo "$name"
    done
}

installed() {
    grep -qxF -- "$1" <<<"$names"
}

# Packages with all that they depend on.
closure() {
    apt-cache depends --recurse --installed --no-recommends --no-suggests --no-conflicts --no-breaks --no-replaces --no-enhances "$@" |
        grep -E '^[a-z0-9]' | LC_ALL=C sort -u | LC_ALL=C comm -12 - <(echo "$names")
}

make_root() {
    local depends recommends essential folder names
    # All packages that are installed, by one question: one for each takes longer than all else here.
    names=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p' | LC_ALL=C sort -u)
    depends=$(field Depends)
    recommends=$(field Recommends)
    essential=$(dpkg-query -W -f '${Essential} ${Priority} ${Package}\n' | sed -nE 's/^(yes [^ ]+|no required) //p')
    mkdir -p "$root"/{usr/bin,usr/sbin,usr/lib,usr/lib64,etc/alternatives,tmp,proc,dev,root,var/cache/fontconfig}
    chmod 1777 "$root/tmp"
    for folder in bin sbin lib lib64; do
        ln -sfn "usr/$folder" "$root/$folder"
    done
    # shellcheck disable=SC2086
    closure $depends $recommends $essential >"$root.packages"
    xargs dpkg -L <"$root.packages" | grep '^/.' | sort -u | while IFS= read -r file; do
        if [ -L "$file" ] || [ -f "$file" ]; then
            echo "${file#/}"
        fi
    done | tar -C / --no-recursion -cf - -T - | tar -C "$root" --keep-directory-symlink -xf -
    # What the scripts of the packages do when they are installed, as far as programs need it.
    find /usr/bin /usr/sbin /usr/lib -type l -lname '/etc/alternatives/*' | while IFS= read -r link; do
        chosen=$(readlink "$link")
        if [ -e "$root$(readlink "$chosen")" ]; then
            cp -P "$chosen" "$root/etc/alternatives/"
            mkdir -p "$root${link%/*}"
            cp -P "$link" "$root$link"
        fi
    done
    cp "$root/usr/share/base-passwd/passwd.master" "$root/etc/passwd"
    cp "$root/usr/share/base-passwd/group.master" "$root/etc/group"
    mknod -m 666 "$root/dev/null" c 1 3
    mknod -m 666 "$root/dev/zero" c 1 5
    mknod -m 444 "$root/dev/urandom" c 1 9
    dpkg-deb -x "$package" "$root"
    ldconfig -r "$root"
    rm -f "$root.packages"
}

[ $# -ge 3 ] || usage
what=$1
case $what in
    make)
        package=$2
        root=$3
        make_root
        ;;
    run)
        root=$2
        shift 2
        # The command must not be the first process of its namespace: Xvfb tells no such process that it is ready.
        exec unshare --mount --pid --fork --kill-child sh -c \
            'mount -t proc proc "$0/proc" && chroot "$0" /usr/bin/env -i PATH=/usr/bin:/usr/sbin HOME=/root "$@"; exit $?' "$root" "$@"
        ;;
    *) usage ;;
esac
