// node run.js GRADER SAMPLE_REPORT SAMPLE_CLASS: the HTML report and a batch's overview, looked at in
// Chromium. Fails where no test ran.
import {after, afterEach} from 'node:test';
import {browser} from './browser.js';

let ran = 0;
afterEach(() => { ++ran; });
after(() => browser.close());
process.on('exit', () => {
  if (ran > 0)
    return;
  console.error('no test ran');
  process.exitCode = 1;
});

await import('./viewer_tests.js');
await import('./page_tests.js');
await import('./hostile_tests.js');
await import('./overview_tests.js');
await import('./watch_tests.js');
