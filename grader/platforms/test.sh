#!/usr/bin/env bash
# test.sh COURSE GRADER: what ./grade package-… makes is laid out and started as each platform does
# it, on a machine that is this one with /autograder, /grade and /course beside the rest, in mount
# namespaces of its own. The programs are those that are built already: that setup.sh and the
# Dockerfile build them is tried by hand. Exit code 77: it could not be tried here, and why.

# shellcheck disable=SC2016 # what another shell is to expand, this one must not

set -euo pipefail
course=$1 grader=$2
not_here() {
    echo "NOT RUN: $1"
    exit 77
}
((EUID == 0)) || not_here "only root can lay out a platform's machine"
unshare --mount true 2> /dev/null || not_here "mount namespaces are not allowed here"
command -v node > /dev/null || not_here "node is missing (package nodejs), which reads the results"
command -v make > /dev/null || not_here "make is missing, which Autolab starts"
git -C "$course" rev-parse HEAD > /dev/null 2>&1 || not_here "$course is no git repository"

work=$(mktemp -d "${TMPDIR:-/tmp}/platforms-test-XXXXXX")
chmod 755 "$work"
trap 'rm -rf "$work"' EXIT
failures=0
case_name=
complain() {
    failures=$((failures + 1))
    printf 'FAILED in %s: %s\noutput was:\n%s\n\n' "$case_name" "$1" "$(cat "$work/output")"
}
# expect WHAT JAVASCRIPT: true of `result`, the document, and `output`, what was printed.
expect() {
    node -e '
        const fs = require("fs"), [file, printed, condition] = process.argv.slice(1);
        const output = fs.readFileSync(printed, "utf8");
        let result = null;
        try { result = JSON.parse(fs.readFileSync(file)); } catch (error) { }
        let met = false;
        try { met = eval(condition); } catch (error) { console.error(error.message); }
        process.exit(met ? 0 : 1);' "$work/results.json" "$work/output" "$2" ||
        complain "expected $1: $2 in $(head -c 1500 "$work/results.json" 2> /dev/null)"
}

# The course as it is here, committed, and a grader whose course that is.
copy=$work/course
git clone -q "$course" "$copy" 2> /dev/null
(cd "$course" && git ls-files -z --cached --others --exclude-standard |
    xargs -0 sh -c 'for f; do [ -e "$f" ] && printf "%s\\0" "$f"; done' - |
    tar -c --null -T - -f -) | tar -x -C "$copy"
sed -i 's/"starter_passes": \[\]/"visibility": {"Rotation.DrawnTurns": "after_due_date"},\n    &/' \
    "$copy/assignments/06-rotation/assignment.json"
commit() {
    git -C "$copy" add -A
    git -C "$copy" -c user.name=test -c user.email=test@example.com commit -q --allow-empty -m "$1"
}
commit "As it is"
# grader_for COURSE FOLDER: the grader in FOLDER, whose course is COURSE.
grader_for() {
    mkdir -p "$2"
    cp "$grader" "$2/grader"
    sed "s|\"root\": .*|\"root\": \"$1\",|" "$(dirname "$grader")/toolchain.json" \
        > "$2/toolchain.json"
}
grader_for "$copy" "$work/bin"

# run_packer CODE ARGUMENT...
run_packer() {
    local expected=$1 code=0
    shift
    rm -f "$work/results.json"
    (cd "$work" && TZ=${zone:-UTC} "$work/bin/grader" "$@") > "$work/output" 2>&1 || code=$?
    [[ $code == "$expected" ]] || complain "exit code $code, expected $expected"
}

case_name="two packages of one commit"
for zone in UTC America/Los_Angeles; do
    for platform in gradescope prairielearn autolab; do
        options=("$zone/$platform")
        [[ $platform != gradescope ]] || options[0]+=.zip
        [[ $platform != prairielearn ]] || options+=(--seed 5)
        run_packer 0 "package-$platform" 06-rotation "${options[@]}"
    done
done
unset zone
diff -r "$work/UTC" "$work/America/Los_Angeles" > "$work/output" 2>&1 ||
    complain "expected the same bytes"

case_name="bad orders"
run_packer 2 package-gradescope 05-none x.zip
expect "the known ones" 'output.includes("known are") && output.includes("06-rotation")'
run_packer 2 package-gradescope
expect "what is missing" 'output.includes("assignment is required")'
run_packer 2 package-gradescope 06-rotation x.rar
expect "the ending" 'output.includes("ends with .zip or .tar")'
run_packer 2 package-autolab 06-rotation bin
expect "an empty folder" 'output.includes("is not empty")'
run_packer 2 package-prairielearn 06-rotation pl.zip
expect "a folder" 'output.includes("pl.zip: expected the name of a folder")'
run_packer 2 06-rotation --harness moodle
expect "the platforms" 'output.includes("gradescope,prairielearn,autolab")'
run_packer 2 06-rotation --harness gradescope --json -
expect "what it excludes" 'output.includes("excludes")'
run_packer 2 06-rotation 07-camera --harness gradescope
expect "one assignment" 'output.includes("grades one assignment: name it")'
echo "// changed" >> "$copy/common/cg/Todo.h"
run_packer 2 package-gradescope 06-rotation x.zip
expect "the changed file" 'output.includes("common/cg/Todo.h") && output.includes("Commit")'
git -C "$copy" checkout -q .
touch "$copy/assignments/06-rotation/tests/New_test.cpp"
run_packer 2 package-gradescope 06-rotation x.zip
expect "the new file" 'output.includes("06-rotation/tests/New_test.cpp") && output.includes("Commit")'
rm "$copy/assignments/06-rotation/tests/New_test.cpp"
sed -i 's/Rotation.DrawnTurns/Rotation.DrawnTurn/' "$copy/assignments/06-rotation/assignment.json"
commit "A misspelt check"
run_packer 2 package-gradescope 06-rotation x.zip
expect "the unknown check and the known ones" \
    'output.includes("\"Rotation.DrawnTurn\"") && output.includes("Rotation.DrawnTurns")'
git -C "$copy" checkout -q HEAD~1
mkdir "$copy/assignments/11-new"
cp "$copy/assignments/06-rotation/assignment.json" "$copy/assignments/11-new"
run_packer 2 package-gradescope 11-new x.zip
expect "what is not committed" 'output.includes("assignments/11-new")'
rm -r "$copy/assignments/11-new"
git -C "$copy" checkout -q -
case_name="files that belong in folders"
run_packer 0 package-prairielearn 10-lighting lighting
cp "$work/lighting/README.md" "$work/output"
expect "their names as browsers give them" 'output.includes("file-names=\"lighting.frag\"")'
mv "$copy/solutions" "$work/solutions"
run_packer 2 package-gradescope 06-rotation x.zip --seed 5
expect "what the seed needs" 'output.includes("--seed 5 needs solutions/06-rotation")'
mv "$work/solutions" "$copy/solutions"

# ---------------------------------------------------------------- machines
# on_machine COMMAND: runs it where / is this machine's with the folders of $work/machine on top:
# as the root of a namespace, or, where a case sets inside=chroot, in a chroot, where the kernel
# gives no user namespaces, as in a container that forbids them.
on_machine() {
    unshare --mount --fork bash -c '
        set -e
        mount --make-rprivate /
        root=$1/root
        mkdir -p "$root"
        mount -t tmpfs machine "$root"
        for each in /*; do
            name=$root$each
            if [[ -L $each ]]; then
                cp -P "$each" "$name"
            elif [[ -d $each ]]; then
                mkdir "$name"
                mount --rbind "$each" "$name"
            fi
        done
        for each in "$1"/machine/*; do
            mkdir -p "$root/${each##*/}"
            mount --bind "$each" "$root/${each##*/}"
        done
        if [[ $2 == chroot ]]; then
            exec chroot "$root" bash -c "$3"
        fi
        mkdir "$root/old"
        cd "$root"
        pivot_root . old
        umount -l /old
        cd /
        exec bash -c "$3"' - "$work" "${inside:-namespace}" "$1" > "$work/output" 2>&1
}

solution=$course/solutions/06-rotation/rotation.cpp
transposed() { sed 's/return R;/return glm::transpose(R);/' "$solution"; }
# Right where it can read what only a grader may, else wrong: the code that an attacker would hand in.
spying() {
    echo '#include <fstream>'
    sed "s|return R;|return std::ifstream(\"$1\") ? R : glm::mat3(0.0f);|" "$solution"
}

# ---------------------------------------------------------------- Gradescope
autograder=$work/machine/autograder
mkdir -p "$autograder/source"
(cd "$autograder/source" && cmake -E tar xf "$work/UTC/gradescope.zip")
cp "$autograder/source/run_autograder" "$autograder/"
grader_for /autograder/source/course "$autograder/source/course/build/release/grader"
chmod 700 "$autograder/source" # as setup.sh does
# gradescope NAME < rotation.cpp: hands that in; nothing, for an empty file.
gradescope() {
    case_name="Gradescope: $1"
    rm -rf "$autograder/submission" "$autograder/results"
    mkdir -p "$autograder/submission/${into:-.}" "$autograder/results"
    cat > "$autograder/submission/${into:-.}/rotation.cpp"
    cat > "$autograder/submission_metadata.json" << 'END'
{"created_at": "2026-11-04T00:04:00.000000-07:00", "assignment": {"due_date":
"2026-11-03T23:59:00.000000-07:00"}, "previous_submissions": [{"score": 40.0, "submission_time":
"2026-11-02T10:00:00.000000-07:00"}]}
END
    ${before:+"$before"}
    on_machine "cd /autograder && ./run_autograder" || complain "exit code $?"
    cp "$autograder/results/results.json" "$work/results.json" || true
}

[[ -x $autograder/run_autograder && -x $autograder/source/setup.sh ]] ||
    complain "expected programs in the zip"
gradescope "a solution" < "$solution"
expect "full marks" 'result.score === 100 && result.tests.every(t => t.status === "passed")'
expect "how late it is, and not the points" \
    'result.output.includes("5 min after the due date") && !result.output.includes("had 40")'
expect "a check that is shown later" \
    'result.tests.filter(t => t.visibility === "after_due_date").length === 1'
expect "the sandbox" '/^Sandbox: (bubblewrap|plain)$/m.test(result.output)'
expect "a report for the instructor" 'output.includes("Rodrigues")'

into=assignments/06-rotation gradescope "a copy of the course" < "$solution"
expect "full marks" 'result.score === 100'

gradescope "a mistake" < <(transposed)
expect "points and pictures" \
    'result.score > 0 && result.score < 100 && result.tests.some(t => t.output_format === "html" &&
     t.output.includes("data:image/png"))'
expect "the mistake's name" 'result.tests.some(t => /column/.test(t.output))'

gradescope "no C++" <<< "not a program"
expect "no points, and the line" 'result.score === 0 && /rotation.cpp:1/.test(result.output)'

inside=chroot gradescope "no user namespaces" < <(spying /autograder/source/setup.sh)
expect "the plain sandbox, and what it is" \
    'result.output.includes("as a user of its own") && /^Sandbox: plain$/m.test(result.output)'
expect "that the submission reads nothing of ours" 'result.score > 0 && result.score < 50'
inside=chroot gradescope "the submission of another" < <(spying /autograder/submission_metadata.json)
expect "that it does not read the students' names" 'result.score > 0 && result.score < 50'
inside=chroot gradescope "what everybody can read" < <(spying /proc/version)
expect "that the spy works" 'result.score === 100'

without_a_submission() { rm -r "$autograder/submission" && ln -s /nowhere "$autograder/submission"; }
before=without_a_submission gradescope "a fault of the grader" < "$solution"
not_graded='!("score" in result) && result.tests.length === 0 &&
    result.output.includes("not your mistake")'
expect "no mark" "$not_graded"
expect "the reason, for the instructor only" \
    'output.includes("expected the folder with the submission") &&
     !result.output.includes("/autograder")'

mv "$autograder/source/course/build" "$work/build"
gradescope "no grader" < "$solution"
expect "no mark" "$not_graded"
expect "the reason" 'output.includes("127: setup.sh did not build it")'
mv "$work/build" "$autograder/source/course/build"

cp "$autograder/run_autograder" "$work/run_autograder"
sed -i 's/^seconds=540/seconds=0.01/' "$autograder/run_autograder"
gradescope "no end" < "$solution"
expect "no mark" "$not_graded"
expect "the reason" 'output.includes("exit code 124")'
mv "$work/run_autograder" "$autograder/run_autograder"

# ---------------------------------------------------------------- PrairieLearn
question=$work/UTC/prairielearn
if [[ -e $question/image/solutions ]] || find "$question" -path '*hidden_tests*' | grep -q .; then
    complain "expected no solution in the public image and no hidden test anywhere"
fi
grep -q 'file-names="rotation.cpp"' "$question/README.md" || complain "expected the file names"
! grep -rq '@[A-Z]*@' "$question/README.md" "$question/tests/run.sh" ||
    complain "expected every word to be filled in"
mkdir -p "$work/machine/grade"
cp -r "$question/image" "$work/machine/course"
grader_for /course "$work/machine/course/build/release/grader"
# prairielearn NAME < rotation.cpp
prairielearn() {
    case_name="PrairieLearn: $1"
    rm -rf "$work/machine/grade"
    mkdir -p "$work/machine/grade/student" "$work/machine/grade/data"
    cp -r "$question/tests" "$work/machine/grade/"
    echo '{"params": {}}' > "$work/machine/grade/data/data.json"
    cat > "$work/machine/grade/student/rotation.cpp"
    on_machine "/grade/tests/run.sh" || complain "exit code $?"
    cp "$work/machine/grade/results/results.json" "$work/results.json" || true
}
inside=chroot prairielearn "a solution" < "$solution"
expect "full marks" 'result.gradable === true && result.score === 1'
expect "nothing of what is not shown" \
    'result.message.includes("Checks that are not shown: 1") && result.message.includes("plain")'
prairielearn "a mistake" < <(transposed)
expect "pictures, within a megabyte" \
    'result.score < 1 && JSON.stringify(result).length < 1e6 &&
     result.tests.some(t => t.images && t.images[0].url.startsWith("data:image/png;base64,"))'
expect "what is right only where that is no secret of the seed" \
    'const images = part => result.tests.find(t => t.name.includes(part)).images.map(i => i.label);
     images("A turn drawn from the seed").join() === "yours" &&
     images("100 degrees").join() === "yours,right"'
prairielearn "no C++" <<< "not a program"
expect "no attempt" 'result.gradable === false && /rotation.cpp:1/.test(result.format_errors[0])'
inside=chroot prairielearn "a spy" < <(spying /grade/tests/solutions/06-rotation/rotation.cpp)
expect "that the submission reads nothing of ours" 'result.score > 0 && result.score < 0.5'
rm "$work/machine/course/build/release/grader/toolchain.json"
prairielearn "a fault of the grader" < "$solution"
expect "no mark and no attempt" \
    'result.gradable === false && !("score" in result) &&
     result.message.includes("not your mistake")'
grader_for /course "$work/machine/course/build/release/grader"

# ---------------------------------------------------------------- Autolab
lab=$work/UTC/autolab
[[ -e $lab/image/solutions/06-rotation/hidden_tests && -e $lab/image/Dockerfile ]] ||
    complain "expected the course, with all of it, in the image"
rm -rf "$work/machine/course"
cp -r "$lab/image" "$work/machine/course"
grader_for /course "$work/machine/course/build/release/grader"
chmod 700 "$work/machine/course" # as the Dockerfile does
# autolab NAME FILE: hands that in; what is printed is the result.
autolab() {
    case_name="Autolab: $1"
    rm -rf "$work/machine/lab"
    mkdir -p "$work/machine/lab"
    cp "$lab/autograde.tar" "$work/machine/lab/"
    cp "$lab/autograde-Makefile" "$work/machine/lab/Makefile"
    cp "$2" "$work/machine/lab/"
    code=0
    on_machine "cd /lab && make -s" || code=$?
    tail -n 1 "$work/output" > "$work/results.json"
}
expect_code() { [[ $code == "$1" ]] || complain "exit code $code, expected $1"; }
autolab "a solution" "$solution"
expect_code 0
expect "the points of each task in the last line" \
    'result.scores["cross-matrix"] === 25 && result.scores["rotation"] === 45 &&
     result.scores["euler-rodrigues"] === 30'
mkdir -p "$work/handin"
transposed > "$work/handin/rotation.cpp"
tar -c -f "$work/handin.tar" -C "$work/handin" rotation.cpp
inside=chroot autolab "an archive" "$work/handin.tar"
expect_code 0
expect "lost points, and why" 'result.scores["rotation"] < 45 && output.includes("✗")'
expect "nothing of what is shown later" \
    '!output.split("euler-rodrigues")[0].includes("five turns drawn") &&
     output.split("euler-rodrigues")[1].includes("five turns drawn")'
expect "the sandbox" 'output.includes("Sandbox: plain")'
ln -s /etc/passwd "$work/handin/link"
tar -c -f "$work/handin.tar" -C "$work/handin" rotation.cpp link
autolab "a refused archive" "$work/handin.tar"
expect_code 0
expect "no points, and why" 'result.scores["rotation"] === 0 && output.includes("it is refused: ")'
chmod 755 "$work/machine/course"
as_a_user='setpriv --reuid 65533 --regid 65533 --clear-groups /course/build/release/grader/grader'
autolab "an ordinary user" "$solution"
chown -R 65533 "$work/machine/lab"
inside=chroot on_machine "cd /lab && $as_a_user 06-rotation --harness autolab" && complain "exit 0"
expect "no mark without a sandbox, and what to do" \
    'output.includes("there is no sandbox on this machine") && output.includes("--no-sandbox") &&
     !output.includes("scores")'
inside=chroot on_machine "cd /lab && $as_a_user 06-rotation --harness autolab --no-sandbox" ||
    complain "exit code $?"
expect "a mark, and the doubt" \
    'output.includes("grade only code that you trust") && output.includes("\"scores\"")'
rm "$work/machine/course/build/release/grader/toolchain.json"
autolab "a fault of the grader" "$solution"
expect_code 2
expect "no line of points" 'result === null && output.includes("not your mistake")'

((failures == 0)) || exit 1
echo "passed"
