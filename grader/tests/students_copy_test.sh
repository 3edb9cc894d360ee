#!/usr/bin/env bash
# students_copy_test.sh ROOT GRADER: the students' copy of ROOT's last commit, made by GRADER from a
# fresh clone. It is the same each time, its pages link to what is there, it builds by itself, its
# starters earn nothing and solutions everything; and, pushed to a bare repository, it grades a pull
# request. Where git does not know ROOT, the test ends with 77, which CTest shows as skipped; not so
# with CI=true, where there is always a commit.

set -euo pipefail

root=$1 grader=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Nobody's settings, but in a container ROOT may belong to another user.
printf '[safe]\n\tdirectory = *\n' > "$work/gitconfig"
export GIT_CONFIG_GLOBAL=$work/gitconfig GIT_AUTHOR_NAME=A GIT_AUTHOR_EMAIL=a@example.org
export GIT_COMMITTER_NAME=A GIT_COMMITTER_EMAIL=a@example.org
unset GITHUB_ACTIONS GITHUB_EVENT_PATH GITHUB_STEP_SUMMARY GITHUB_OUTPUT

step() { printf '%4d s  %s\n' "$SECONDS" "$1"; }
fail() {
    echo "FAILED: $1"
    exit 1
}

if ! git -C "$root" rev-parse HEAD > /dev/null 2>&1; then
    [[ ${CI:-} != true ]] || fail "git has no commit of $root"
    echo "skipped: git has no commit of $root"
    exit 77
fi
git clone -q --no-local "$root" "$work/course"
cd "$work"

step "two copies are the same"
"$grader" package-students --from course one
"$grader" package-students --from course two > /dev/null
diff -r one two || fail "two copies of one commit differ"
"$grader" package-students --from course one.zip > /dev/null
"$grader" package-students --from course two.zip > /dev/null
cmp one.zip two.zip || fail "two archives of one commit differ"
for absent in solutions students grader/tests CONTRIBUTING.md .git .github/workflows/ci.yml; do
    [[ ! -e one/$absent ]] || fail "the copy has $absent"
done
for present in .github/workflows/grade.yml .github/actions/grade/grade.sh reference_images/06-rotation \
    docs/first-hour.md grader/SECURITY.md LICENSE; do
    [[ -e one/$present ]] || fail "the copy has no $present"
done

step "every link of its pages leads somewhere"
find one -name '*.md' -print0 | perl -0 -ne '
    chomp; my $page = $_; my ($folder) = $page =~ m{(.*)/};
    open my $in, "<", $page or die; local $/; my $text = <$in>;
    $text =~ s/^```.*?^```//msg;
    while ($text =~ /\]\(([^)#:]+)(#[^)]*)?\)/g) {
        next if -e "$folder/$1";
        print "$page links to $1, which the copy does not have\n"; $bad = 1;
    }
    END { exit $bad // 0 }' || fail "broken links"

step "a copy for a course under way"
"$grader" package-students --from course --upto 08-perspective --with-solutions 06-rotation part > part.log
grep -q "Look at: docs/scoring.md names what this copy does not have: 09-scene-graph, 10" part.log || fail "$(cat part.log)"
! grep -q "Look at: docs/first-hour.md" part.log || fail "$(cat part.log)"
[[ $(cd part && echo assignments/[0-9]* solutions/* solutions/*/*) == \
    "assignments/04-mandelbrot assignments/06-rotation assignments/07-camera assignments/08-perspective solutions/06-rotation solutions/06-rotation/rotation.cpp" ]] ||
    fail "the copy up to 08 has $(find part/assignments part/solutions -maxdepth 2)"
[[ ! -e part/reference_images/09-scene-graph ]] || fail "the copy up to 08 has pictures of 09"

step "a solution that is given away keeps the tasks of later assignments to itself"
"$grader" package-students --from course --upto 08-perspective --with-solutions 06-rotation,07-camera both
[[ $(cd both && echo solutions/*) == "solutions/06-rotation solutions/07-camera" ]] ||
    fail "the copy with two solutions has $(ls both/solutions)"
"$grader" package-students --from course --upto 08-perspective --with-solutions 07-camera given
camera=given/solutions/07-camera/Camera.cpp
grep -q 'cg::todo.*"perspective"' "$camera" || fail "$(cat $camera)"
[[ $(grep -c 'cg::todo' "$camera") == 1 ]] || fail "$(cat $camera)"

step "it configures, though what that solution rests on is not given away"
(cd given && cmake --preset release) > given.log 2>&1 || fail "$(cat given.log)"

# refused REASON [OPTION...]: there is no copy, but the reason.
refused() {
    if "$grader" package-students "${@:2}" three > slip.log 2>&1; then
        fail "expected no copy: $1"
    fi
    grep -q "$1" slip.log || fail "expected $1, found $(cat slip.log)"
    [[ ! -e three ]] || fail "something was written all the same"
}
# slip REASON: so it is with what lies in the course now, even committed.
slip() {
    git -C course add -A
    git -C course commit -qm "a slip"
    refused "$1" --from course
    git -C course reset -q --hard HEAD~1
}

step "a solution that got into a page or a handout is found, whatever the encoding"
camera=course/solutions/07-camera/Camera.cpp
for page in docs/first-hour.md assignments/06-rotation/README.md common/notes.txt; do
    cp "$camera" course/$page
    slip "$page: as in solutions/07-camera/Camera.cpp"
done
{ cat "$camera" && printf '\377'; } > course/docs/latin1.md
slip "docs/latin1.md: as in solutions/07-camera/Camera.cpp"
iconv -f UTF-8 -t UTF-16 "$camera" > course/docs/wide.md
slip "docs/wide.md: as in solutions/07-camera/Camera.cpp"

step "an archive is refused"
cp one.zip course/docs/week.zip
slip "^  docs/week.zip$"
tar -cf course/week.tar -C course solutions/07-camera
slip "week.tar: as in solutions/07-camera/Camera.cpp"

step "a new file that git does not keep is refused"
touch course/assignments/06-rotation/tests/New_test.cpp
refused "assignments/06-rotation/tests/New_test.cpp" --from course
rm course/assignments/06-rotation/tests/New_test.cpp

step "pushed to a bare repository and cloned, it builds by itself; its starters earn nothing"
git init -q --bare -b main hub.git
(cd one && git init -q -b main && git add -A && git commit -qm "The course" && git push -q ../hub.git main)
git clone -q hub.git base
(cd base && ./grade --yes > ../starters.log 2>&1 && code=0 || code=$?
    [[ $code == 1 ]]) || fail "$(cat starters.log)"
points=$((100 * $(find course/assignments -name assignment.json | wc -l)))
grep -q "^all assignments  *0 / $points\$" starters.log || fail "$(cat starters.log)"

step "what needs solutions says so, and the pages that it names are there"
for command in "check-course 06-rotation" check-recognition sync-starters "new-assignment 12-x" \
    "package-gradescope 06-rotation"; do
    read -ra words <<< "$command"
    if (cd base && ./grade "${words[@]}") > refused.log 2>&1; then
        fail "$command: expected exit code 2"
    fi
    grep -q "so this is a student's copy" refused.log || fail "$command: $(cat refused.log)"
done
refused "has no students/, so this is a student's copy" --from base
helps() {
    cat Dockerfile
    ./grade doctor || true
    ./grade --help | sed -n 's/^  \([a-z][a-z-]*\) .*/\1/p' | xargs -I '{}' ./grade '{}' --help
}
for page in $(cd base && helps | grep -o '\(docs\|grader\)/[A-Za-z-]*\.md' | sort -u); do
    [[ -e base/$page ]] || fail "a command or the Dockerfile names $page, which the copy does not have"
done

step "solutions earn everything"
cp -r base/assignments solved
for folder in course/solutions/*/; do
    id=$(basename "$folder")
    while IFS= read -r name; do
        cp "$folder/$name" "solved/$id/$name"
    done < <(perl -MJSON::PP -0777 -ne 'print "$_\n" for @{decode_json($_)->{submit}}' "solved/$id/assignment.json")
done
(cd base && ./grade --submission ../solved) > solved.log 2>&1 || fail "$(cat solved.log)"
grep -q "^all assignments  *$points / $points\$" solved.log || fail "$(cat solved.log)"

step "a pull request is graded by the copy's own scripts"
git clone -q hub.git student
cp solved/06-rotation/rotation.cpp student/assignments/06-rotation/
echo "exit 0" > student/grade
(cd student && git checkout -q -b work && git commit -qam "my work" && git push -q origin work work:refs/pull/1/head)
printf '{"pull_request": {"number": 1, "base": {"sha": "%s"}, "head": {"sha": "%s"}}}' \
    "$(git -C base rev-parse HEAD)" "$(git -C student rev-parse HEAD)" > event.json
(cd base && GITHUB_ACTIONS=true GITHUB_EVENT_PATH=../event.json GITHUB_STEP_SUMMARY=../summary.md \
    .github/actions/grade/grade.sh) > pull.log 2>&1 || fail "$(cat pull.log)"
grep -q '^## 06-rotation Rotation: 100 / 100$' summary.md || fail "$(cat summary.md)"
# shellcheck disable=SC2016 # Markdown
grep -qF '* `grade`' summary.md || fail "the edited grader is not named: $(cat summary.md)"
[[ -s base/pull-request-report/index.html ]] || fail "there is no report"

step "done"
