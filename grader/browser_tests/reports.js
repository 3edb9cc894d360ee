// Reports to look at, made once for all tests: by the grader from real submissions, and by the
// sample program from results that have everything.
import {execFileSync, spawn, spawnSync} from 'node:child_process';
import {cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync,
        writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, extname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
const [grader, sampleReport, sampleClass] = process.argv.slice(2);
const work = mkdtempSync(join(tmpdir(), 'report-browser-'));
process.on('exit', () => rmSync(work, {recursive: true, force: true}));

/** What a hostile student writes wherever text can be written. */
export const kHostile = `"'></style></pre><script>window.hacked=1</script>` +
  `<img src=x onerror="window.hacked=1">&lt;b&gt;`;

function withRegion(text, id, body) {
  const region = new RegExp(`(// BEGIN TODO\\(${id}\\)[^\\n]*\\n)[^]*?([ \\t]*// END TODO\\(${id}\\))`);
  if (!region.test(text))
    throw new Error(`no region ${id}`);
  return text.replace(region, (all, begin, end) => begin + body + '\n' + end);
}

/** A folder with the solution of one assignment, changed by `change(folder)`. */
function submission(name, assignment, change) {
  const folder = join(work, name, 'submission', assignment);
  const ours = ['mistakes', 'mistakes.json', 'hidden_tests', 'variants'];
  mkdirSync(folder, {recursive: true});
  for (const each of readdirSync(join(root, 'solutions', assignment)))
    if (!ours.includes(each))
      cpSync(join(root, 'solutions', assignment, each), join(folder, each), {recursive: true});
  change(folder);
  return dirname(folder);
}

function edit(file, change) { writeFileSync(file, change(readFileSync(file, 'utf8'))); }

/** Puts known mistakes into their regions. */
function make(assignment, ids) {
  const solution = join(root, 'solutions', assignment);
  const known = JSON.parse(readFileSync(join(solution, 'mistakes.json'), 'utf8'));
  return folder => {
    for (const id of ids) {
      const mistake = known.find(each => each.id === id);
      const body = readFileSync(join(solution, 'mistakes', id + extname(mistake.file)), 'utf8');
      edit(join(folder, mistake.file), text => withRegion(text, mistake.region, body));
    }
  };
}

/** The path of the page that the grader makes; `exitCode` as RESULT.md says. */
function graded(name, assignment, change, exitCode) {
  const report = join(work, name, 'report');
  const result = spawnSync(grader, [assignment, '--submission', submission(name, assignment, change),
                                    '--report', report], {encoding: 'utf8'});
  if (result.status !== exitCode)
    throw new Error(`${name}: the grader ended with ${result.status}, expected ${exitCode}:\n` +
                    result.stdout + result.stderr);
  return join(report, 'index.html');
}

/**
 * The grader watching a solution of 06-rotation: {page, save(ids, tail), stop()}. `save` puts known
 * mistakes into the solution's regions, and `tail` below them; `stop` resolves to the exit code.
 */
export async function watched(name) {
  const folder = join(submission(name, '06-rotation', () => {}), '06-rotation');
  const file = join(folder, 'rotation.cpp'), report = join(work, name, 'report');
  const watch = spawn(grader, ['--watch', '06-rotation', '--submission', dirname(folder),
                               '--report', report]);
  let said = '';
  await new Promise((resolve, reject) => {
    watch.stdout.on('data', text => (said += text).includes('Report: ') && resolve());
    watch.on('exit', code => reject(new Error(`the watch ended with ${code}:\n${said}`)));
  });
  return {
    page: join(report, 'index.html'),
    save(ids, tail = '') {
      cpSync(join(root, 'solutions/06-rotation/rotation.cpp'), file);
      make('06-rotation', ids)(folder);
      edit(file, text => text + tail);
    },
    stop() {
      return new Promise(resolve => watch.removeAllListeners('exit').on('exit', resolve)
        .kill('SIGTERM'));
    },
  };
}

function sample(name, ...text) {
  const folder = join(work, name);
  execFileSync(sampleReport, [folder, ...text]);
  return join(folder, 'index.html');
}

const cpp = text => JSON.stringify(text);  // a string of C++ as well, without odd characters

const makers = {
  full: () => graded('full', '06-rotation', () => {}, 0),
  half: () => graded('half', '06-rotation',
                     make('06-rotation', ['rotation-clockwise', 'euler-sign-of-ab']), 1),
  lighting: () => graded('lighting', '10-lighting', make('10-lighting', ['specular-missing']), 1),
  lost: () => graded('lost', '10-lighting',
                     make('10-lighting', ['ambient-without-light', 'diffuse-squared',
                                          'specular-fixed-exponent', 'emission-twice',
                                          'light-not-normalised', 'many-averaged',
                                          'normals-untransformed', 'attenuation-missing',
                                          'tone-inverse-gamma']), 1),
  broken: () => graded('broken', '06-rotation', folder => edit(join(folder, 'rotation.cpp'), text =>
    withRegion(text, 'rotation', '\tfloat angle = degres;\n    return glm::mat3(angle)')), 1),
  hostile: () => graded('hostile', '06-rotation', folder => {
    writeFileSync(join(folder, '<img src=x onerror=window.hacked=1>.txt'), kHostile);
    edit(join(folder, 'rotation.cpp'), text => '#include <stdexcept>\n' + withRegion(
      text, 'rotation', `throw std::runtime_error(${cpp(kHostile)} "\\033[2J\\u202e");`));
  }, 1),
  hostileBroken: () => graded('hostileBroken', '06-rotation', folder =>
    edit(join(folder, 'rotation.cpp'), text => withRegion(
      text, 'rotation', `static_assert(false, ${cpp(kHostile)}); // ${kHostile}\x1b[2J`)), 1),
  sample: () => sample('sample'),
  overview: () => {
    const folder = join(work, 'overview');
    execFileSync(sampleClass, [folder, '500']);
    return join(folder, 'index.html');
  },
  hostileSample: () => sample('hostileSample', kHostile + '\x1b[2J'),
};

const made = {};

/** The path of a report's page, see `makers`. */
export function report(name) { return made[name] ??= makers[name](); }

export function sizeOf(name) { return statSync(report(name)).size; }
