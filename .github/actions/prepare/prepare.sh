#!/usr/bin/env bash
# prepare.sh: a machine of GitHub's, made ready to build and grade: packages and compiler output are
# kept where actions/cache finds them, and users may have namespaces, which Ubuntu 24.04 refuses and
# the sandbox needs. Changes the system, so it runs on such machines only.

set -euo pipefail

[[ ${GITHUB_ACTIONS:-} == true ]] || { echo "prepare.sh: this is no machine of GitHub's" >&2; exit 2; }

as_root=()
[[ $(id -u) == 0 ]] || as_root=(sudo)

packages=$HOME/.cache/course-packages
mkdir -p "$packages/partial"
"${as_root[@]}" tee /etc/apt/apt.conf.d/90course > /dev/null <<END
Dir::Cache::archives "$packages";
APT::Keep-Downloaded-Packages "true";
END

restriction=/proc/sys/kernel/apparmor_restrict_unprivileged_userns
if [[ -e $restriction ]]; then
    echo 0 | "${as_root[@]}" tee $restriction > /dev/null
fi

"${as_root[@]}" apt-get -q update
"${as_root[@]}" apt-get -q install -y --no-install-recommends ccache
{
    echo CMAKE_C_COMPILER_LAUNCHER=ccache
    echo CMAKE_CXX_COMPILER_LAUNCHER=ccache
    echo "CCACHE_DIR=$HOME/.cache/ccache"
} >> "$GITHUB_ENV"
