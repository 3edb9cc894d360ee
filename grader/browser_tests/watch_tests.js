// The page of ./grade --watch: it shows each new verdict by itself, and stays as the reader left it.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {browser} from './browser.js';
import {watched} from './reports.js';

const kPatience = {timeout: 60000};

const scoreOf = page => page.locator('.score b').textContent();
const topOf = (page, id) => page.evaluate(
  task => document.getElementById(task).getBoundingClientRect().top, id);

/** Waits until the page shows a score that passes, all of it ready. */
async function untilScore(page, pattern) {
  await page.waitForFunction(text => new RegExp(text).test(
    document.querySelector('.score b')?.textContent ?? ''), pattern.source, kPatience);
  await page.waitForFunction(() => [...document.querySelectorAll('details.check[open] .pictures')]
    .every(each => each.closest('.frame').classList.contains('live')), null, kPatience);
}

test('the page follows and stays as the reader left it', async () => {
  const watch = await watched('following');
  const page = await browser.newPage({viewport: {width: 1200, height: 500}});
  const left = [], complaints = [];
  page.on('request', each => /^(file|data|blob):/.test(each.url()) || left.push(each.url()));
  page.on('console', message => complaints.push(message.text()));
  page.on('pageerror', error => complaints.push(error.message));
  try {
    await page.goto('file://' + watch.page);
    assert.equal(await scoreOf(page), '100');

    // The reader opens the last frame, wipes, and scrolls.
    const check = page.locator('details.check.full').last();
    const title = await check.locator('summary .title').textContent();
    await check.locator('summary').click();
    await check.locator('input.wipe').fill('30');
    const task = await check.evaluate(each => each.closest('.task').id);
    await page.evaluate(id => {
      document.getElementById(id).scrollIntoView();
      scrollBy(0, 60);
    }, task);
    const top = await topOf(page, task);

    const same = () => page.locator('details.check', {hasText: title}).first();
    const isAsLeft = async () => {
      assert.equal(await same().evaluate(each => each.open), true, 'what was opened is open');
      assert.equal(await same().locator('input.wipe').inputValue(), '30', 'the slider');
      assert.ok(Math.abs(await topOf(page, task) - top) < 3, 'the task is where it was');
    };

    watch.save(['cross-transposed']);
    await untilScore(page, /^[1-9]\d?(\.\d)?$/);
    await isAsLeft();

    watch.save([], 'oops\n');
    await untilScore(page, /^0$/);
    assert.match(await page.locator('.compiler').textContent(), /rotation\.cpp/);

    watch.save([]);
    await untilScore(page, /^100$/);
    await isAsLeft();
    assert.deepEqual(left, [], 'no request leaves the machine');
    assert.deepEqual(complaints, [], 'the page complains about nothing');
  } finally {
    await page.close();
    assert.equal(await watch.stop(), 0);
  }
});
