#!/usr/bin/env bash
# setup.sh: Gradescope runs this once as root, while it makes the image: installs the packages and
# builds the grader, as ./grade does anywhere.

set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"

# Solutions and hidden tests are nobody's but root's: where a submission cannot be put
# into namespaces of its own, it runs as another user, and what others may read it can read.
chmod 700 .

# The doctor's word on this machine is for the instructor; 1 means that not all defences are active.
code=0
course/grade --yes doctor || code=$?
((code <= 1))
