#!/usr/bin/env bash
# containers_test.sh: reads Dockerfile, .dockerignore and .devcontainer/devcontainer.json as far as
# that can be done without Docker: instructions, shell, packages and paths are what they should be.

# shellcheck disable=SC2016 # what another shell is to expand, this one must not

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

failures=0
complain() {
    failures=$((failures + 1))
    echo "FAILED: $1"
}

# instructions FILE: one a line, without comments and continued lines.
instructions() { sed '/^[[:space:]]*#/d' "$1" | sed -z 's/\\\n[[:space:]]*/ /g' | sed '/^$/d'; }

# check_dockerfile FILE CONTEXT: where COPY finds its files.
check_dockerfile() {
    local file=$1 context=$2 instruction rest first='' source words
    while read -r instruction rest; do
        [[ -n $first ]] || first=$instruction
        case $instruction in
            FROM | WORKDIR | CMD) ;;
            COPY)
                read -ra words <<< "$rest"
                for source in "${words[@]:0:${#words[@]}-1}"; do
                    [[ -e $context/$source ]] || complain "$file: COPY of $source, which is not here"
                    ! grep -qxF -- "$source" .dockerignore ||
                        complain "$file: COPY of $source, which .dockerignore takes away"
                done
                ;;
            RUN) sh -n -c "$rest" || complain "$file: no shell command: $rest" ;;
            *) complain "$file: expected FROM, COPY, WORKDIR, RUN or CMD, found $instruction" ;;
        esac
    done < <(instructions "$file")
    [[ $first == FROM ]] || complain "$file: expected FROM first, found ${first:-nothing}"
    # A check that was not made proves nothing.
    grep -q '^RUN ' <(instructions "$file") || complain "$file: expected a RUN"
}
check_dockerfile Dockerfile .
check_dockerfile grader/platforms/autolab/Dockerfile .

# The lists of packages have one home, and the image is of the system where they are proved.
image=$(instructions Dockerfile | sed -n 's/^FROM //p')
[[ $image == debian:12* ]] || complain "Dockerfile: expected Debian 12, found $image"
installed=$(instructions Dockerfile | grep -o 'apt-get install[^|&;]*' || true)
[[ $installed == *'"${build_packages[@]}"'* ]] ||
    complain "Dockerfile: expected the packages of scripts/packages.sh, found: $installed"
for word in $installed; do
    case $word in
        apt-get | install | -y | --no-install-recommends | '"${build_packages[@]}"'*) ;;
        *) complain "Dockerfile: $word is a package that scripts/packages.sh does not name" ;;
    esac
done
(source scripts/packages.sh && ((${#build_packages[@]} > 10))) ||
    complain "scripts/packages.sh: expected the list build_packages"
for each in build report .git; do
    grep -qxF "$each" .dockerignore || complain ".dockerignore: expected $each"
done

if command -v node > /dev/null; then
    node -e '
        const fs = require("fs"), path = require("path"), file = ".devcontainer/devcontainer.json";
        const json = JSON.parse(fs.readFileSync(file, "utf8").replace(/^\s*\/\/.*$/gm, ""));
        for (const name of ["dockerfile", "context"])
            if (!fs.existsSync(path.join(".devcontainer", json.build[name])))
                throw new Error(`${file}: ${name} ${json.build[name]} is not here`);
        const command = json.postCreateCommand.split(" ")[0];
        if (!fs.existsSync(command)) throw new Error(`${file}: ${command} is not here`);' ||
        complain ".devcontainer/devcontainer.json, see above"
else
    echo "node is missing: .devcontainer/devcontainer.json is not looked at"
fi

((failures == 0)) || exit 1
echo "passed"
