# shellcheck shell=bash
# Sourced by ./grade and ./test: which packages of the system are needed, and how they get here.
#
# Debian 12 is proved on a fresh machine. Debian 13 was tried once. Ubuntu 22.04 and 24.04 know all
# these names but chromium, which is a snap there; nobody has tried more there.

# To build and to grade. gdb is for ./grade debug, libgl1-mesa-dri for the windows.
build_packages=(
    g++ cmake ninja-build pkg-config mold binutils gdb git util-linux bubblewrap
    libglm-dev libglfw3-dev libgl-dev libopengl-dev libgl1-mesa-dri libosmesa6 libegl1
    libopenimageio-dev libtinyobjloader-dev libcli11-dev nlohmann-json3-dev libfmt-dev libmd-dev
    libseccomp-dev libarchive-dev zlib1g-dev libyaml-cpp-dev
    libgtest-dev libgmock-dev
)
# To run the tests on top of that: a display without a screen, and keys pressed on it.
test_packages=(xvfb xdotool)

# add_machine_packages: to $test_packages, what not every machine is to get: a browser that looks at
# the report, driven by a program of Node's, the compiler of the fuzzers, a cluster, and
# what Autolab starts. None of it is needed for the students' copy, which has no such tests. Wants $root and $system.
add_machine_packages() {
    [[ -d $root/grader/tests ]] || return 0
    test_packages+=(nodejs clang slurm-wlm munge make)
    [[ $system == ubuntu* ]] || test_packages+=(chromium)
    # Linux as a program, to try cgroups; whether others have it was not tried.
    [[ $system != "debian 12" ]] || test_packages+=(user-mode-linux)
    # libFuzzer and the sanitizers of clang; in Ubuntu 22.04 they come with the compiler.
    [[ $system == "ubuntu 22.04" ]] || test_packages+=(libclang-rt-dev)
    # Node's packages from elsewhere bring npm along, and Debian's conflicts with them.
    command -v npm > /dev/null || test_packages+=(npm)
}

# read_system FILE: sets $system, such as "debian 12", from a file like /etc/os-release.
read_system() {
    local key value id=unknown version=
    while IFS='=' read -r key value; do
        value=${value//\"/}
        case $key in
            ID) id=$value ;;
            VERSION_ID) version=$value ;;
        esac
    done < "$1"
    system="$id $version"
}

# How far the lists are known to hold on a system. Prints nothing where they are proved.
doubt_about() {
    case $1 in
        "debian 12") ;;
        "debian 13") echo "This course was tried on $1 once, and is not tried there regularly." ;;
        "ubuntu 22.04" | "ubuntu 24.04")
            echo "These package names are meant for $1 too, but nobody has tried them there." ;;
        *) echo "These package names are Debian's; nobody has tried them on $1." ;;
    esac
}

# missing_of PACKAGE...: sets $missing to those that dpkg does not call installed.
missing_of() {
    local name state package
    declare -A installed=()
    while read -r name state; do
        [[ $state != installed ]] || installed[$name]=yes
    done < <(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "$@" 2> /dev/null || true)
    missing=()
    for package in "$@"; do
        [[ -n ${installed[$package]:-} ]] || missing+=("$package")
    done
}

# refuse_to_install WHY: prints the one line to type, and ends.
refuse_to_install() {
    local install="apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
    echo "$me: $1 Type this line, then run $me again:" >&2
    if command -v sudo > /dev/null; then
        echo "sudo sh -c '$install'" >&2
    else
        echo "su -c '$install'" >&2
    fi
    exit 2
}

# may_install: root may, who said --yes may, and who answers yes may. Sets $as_root.
may_install() {
    as_root=()
    [[ $(id -u) != 0 ]] || return 0
    command -v sudo > /dev/null ||
        refuse_to_install "you are not root and there is no sudo, so a person who is must do it."
    as_root=(sudo)
    [[ $yes != yes ]] || return 0
    [[ -t 0 ]] || refuse_to_install "nobody can be asked here (or say --yes)."
    local answer
    read -rp "Install them now with sudo? [Y/n] " answer || answer=n
    [[ ${answer:-y} == [yY]* ]] || refuse_to_install "nothing was installed."
}

# ensure_browser_driver: installs what drives the browser, as the lock file of the browser tests says.
# Wants what start (wrapper.sh) sets. npm's own note of what it installed shows when that was.
ensure_browser_driver() {
    local folder=$root/grader/browser_tests log=$build/npm.log
    [[ $folder/package-lock.json -nt $folder/node_modules/.package-lock.json ]] || return 0
    echo "Installing the driver of the browser tests (npm ci) ..." >&2
    (cd "$folder" && npm ci --ignore-scripts) > "$log" 2>&1 < /dev/null && return
    tail -n 20 "$log" >&2
    echo "$me: npm could not install what $folder/package-lock.json names, see above" \
        "(all of it: $log). It needs the network once. Then run $me again." >&2
    exit 2
}

# ensure_packages PACKAGE...: installs what is missing. Wants what start (wrapper.sh) sets.
# What was found is remembered until dpkg's own list changes.
ensure_packages() {
    local stamp="$build/packages-$#" log="$build/packages.log" found=''
    [[ ! -f $stamp ]] || read -r found < "$stamp" || true
    if [[ $found == "$system $*" && $stamp -nt ${DPKG_ADMINDIR:-/var/lib/dpkg}/status ]]; then
        return
    fi
    if ! command -v dpkg-query > /dev/null || ! command -v apt-get > /dev/null; then
        echo "$me: packages are installed by apt, which this system ($system) lacks. Needed are the" \
            "counterparts of: $*" >&2
        return
    fi
    missing_of "$@"
    if ((${#missing[@]} > 0)); then
        echo "Missing packages: ${missing[*]}" >&2
        doubt_about "$system"
        may_install
        echo "Installing them (some minutes) ..." >&2
        local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q)
        # A list that cannot be fetched may still be good enough.
        "${apt[@]}" update > "$log" 2>&1 < /dev/null || true
        if ! "${apt[@]}" install -y --no-install-recommends "${missing[@]}" \
            >> "$log" 2>&1 < /dev/null; then
            tail -n 20 "$log" >&2
            echo "$me: apt-get failed, see above (all of it: $log)." \
                "Ubuntu has some of these packages in its component \"universe\" only." >&2
            refuse_to_install "the packages are still missing."
        fi
    fi
    echo "$system $*" > "$stamp"
}
