// The overview of a class of five hundred, opened from the disk.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {look} from './browser.js';

const rows = page => page.locator('#students tbody tr:visible');
const firstOf = async (page, column) =>
  (await rows(page).first().locator('td').nth(column).textContent()).trim();

test('every student has a row, and what needs a person stands on top', () =>
  look('overview', {}, async page => {
    assert.equal(await rows(page).count(), 500);
    assert.match(await page.locator('h1').textContent(),
                 /500 students, 480 with a mark \(mean [\d.]+ points\), 10 missing, 50 late/);
    assert.equal(await page.locator('.alarm').count(), 10, 'refused archives');
    const alarm = await page.locator('.alarm').first().boundingBox();
    const table = await page.locator('#students').boundingBox();
    assert.ok(alarm.y < table.y);
  }));

test('a head sorts up, then down', () => look('overview', {}, async page => {
  const points = page.locator('#students th button', {hasText: /^points$/});
  await points.click();
  assert.equal(await firstOf(page, 5), '0.0');
  await points.click();
  assert.equal(await firstOf(page, 5), '100.0');
  assert.equal(await page.locator('#students th[aria-sort=descending]').count(), 1);
  await page.locator('#students th button', {hasText: /^student$/}).focus();
  await page.keyboard.press('Enter');
  assert.match(await firstOf(page, 0), /^(<img|Name 1 )/);
}));

test('the filter leaves rows and pictures of those it names', () =>
  look('overview', {}, async page => {
    await page.locator('#filter').fill('(s123)');
    assert.equal(await rows(page).count(), 1);
    assert.equal(await page.locator('.gallery:visible figure[data-student]:visible').count(), 1);
    assert.equal(await page.locator('.gallery:visible figure.truth').count(), 1);
    await page.locator('#filter').fill('nobody is called so');
    assert.equal(await rows(page).count(), 0);
  }));

test('the gallery shows one frame at a time, beside the reference', () =>
  look('overview', {}, async page => {
    assert.equal(await page.locator('.gallery:visible').count(), 1);
    assert.equal(await page.locator('.gallery:visible figure').count(), 481);
    const loaded = async () => {
      const image = page.locator('.gallery:visible figure img').nth(1);
      await image.scrollIntoViewIfNeeded();
      await page.waitForFunction(each => each.complete, await image.elementHandle());
      return image.evaluate(each => each.naturalWidth);
    };
    assert.equal(await loaded(), 24);
    await page.locator('#frame').selectOption('turned');
    assert.equal(await page.locator('.gallery:visible').getAttribute('data-frame'), 'turned');
    assert.equal(await page.locator('.gallery:visible figure').count(), 480);
    assert.equal(await loaded(), 24);
  }));

test('mistakes are counted, the most frequent first', () => look('overview', {}, async page => {
  const lines = await page.locator('h2#mistakes + table tr').allTextContents();
  assert.match(lines[0], /^319 of 480rotate-up: You turn the target\./);
  assert.match(lines[1], /^161 of 480rotate-up: You tilt\./);
}));

test('a name is text and nothing else', () => look('overview', {}, async page => {
  assert.equal(await page.evaluate(() => window.hacked), undefined);
  assert.match(await page.locator('#students').textContent(), /<img src=x onerror=/);
}));

test('the page fits a narrow window', () => look('overview', {}, async page => {
  await page.setViewportSize({width: 900, height: 1400});
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 900);
}));
