// Whatever a student writes stays text, and the page runs no script but its own.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {browser, look} from './browser.js';
import {kHostile, report} from './reports.js';

const kHostileReports = ['hostile', 'hostileBroken', 'hostileSample'];

for (const name of kHostileReports)
  test(`${name}: the student's text is text`, () => look(name, {}, async page => {
    for (const details of await page.locator('details').all())
      await details.evaluate(each => { each.open = true; });
    assert.equal(await page.evaluate(() => window.hacked), undefined);
    assert.equal(await page.locator('script').count(), 1);
    assert.equal(await page.locator('style').count(), 1);
    assert.equal(await page.locator('img[onerror], img[src="x"]').count(), 0);
    assert.equal(await page.locator('b', {hasText: 'hacked'}).count(), 0);
    const text = await page.locator('main').textContent();
    assert.ok(text.includes(kHostile), 'and it is shown');
    assert.ok(!/[\x00-\x08\x0b-\x1f\u202a-\u202e]/.test(text), 'without what steers');
  }));

test('the name of a file that was not taken is text', () => look('hostile', {}, async page => {
  assert.match(await page.locator('.notice').allTextContents().then(all => all.join()),
               /Not taken: <img src=x onerror=window\.hacked=1>\.txt/);
}));

test('a script that got in all the same would not run', async () => {
  const page = await browser.newPage();
  await page.goto('file://' + report('full'));
  assert.equal(await page.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'window.hacked = 1';
    document.body.append(script);
    document.body.insertAdjacentHTML('beforeend', '<p onclick="window.hacked = 1">x</p>');
    document.body.lastElementChild.click();
    return window.hacked;
  }), undefined);
  await page.close();
});
