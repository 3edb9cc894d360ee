// Chromium, and what the tests look at pages with.
import assert from 'node:assert/strict';
import {existsSync} from 'node:fs';
import {chromium} from 'playwright-core';
import {report} from './reports.js';

const program = ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find(each => existsSync(each));
if (!program)
  throw new Error('Chromium is missing: install the package chromium');

// With a new profile, which goes with the browser: nobody's settings play a part.
export const browser = await chromium.launch({
  executablePath: program,
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
         '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});

/**
 * Opens a report, hands it to `look`, and requires that no request left the page and that nothing
 * was complained about meanwhile. `options`: width, colorScheme.
 */
export async function look(name, {width = 1200, colorScheme = 'light'}, looking) {
  const page = await browser.newPage({viewport: {width, height: 1400}, colorScheme});
  const left = [], complaints = [];
  page.on('request', request => /^(file|data|blob):/.test(request.url()) || left.push(request.url()));
  page.on('console', message => complaints.push(message.text()));
  page.on('pageerror', error => complaints.push(error.message));
  await page.goto('file://' + report(name));
  // Every frame that lies open has its viewer.
  await page.waitForFunction(() => [...document.querySelectorAll('details.check[open] .pictures')]
    .every(each => each.closest('.frame').classList.contains('live')));
  try {
    await looking(page);
    assert.deepEqual(left, [], 'no request leaves the page');
    assert.deepEqual(complaints, [], 'the page complains about nothing');
  } finally {
    await page.close();
  }
}

const decoder = await browser.newPage();

/** Colours as the screen shows them, '#rrggbb', at places given as shares of an element's box. */
export async function coloursOnScreen(locator, places) {
  const picture = (await locator.screenshot()).toString('base64');
  return decoder.evaluate(async ([bytes, all]) => {
    const image = new Image();
    image.src = 'data:image/png;base64,' + bytes;
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = image.width;
    canvas.height = image.height;
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    return all.map(([x, y]) => '#' +
      [...context.getImageData(Math.floor(x * image.width), Math.floor(y * image.height), 1, 1).data]
        .slice(0, 3).map(each => each.toString(16).padStart(2, '0')).join(''));
  }, [picture, places]);
}

/** The worst places of a viewer: {x, y} as shares of the picture, and both colours. */
export async function worstOf(viewer) {
  const [width, height] = await viewer.locator('canvas.yours').first().evaluate(
    canvas => [canvas.width, canvas.height]);
  return (await viewer.locator('.worst button').allTextContents()).map(text => {
    const [, x, y, yours, reference] =
      /^\((\d+), (\d+)\)yours (#\w{6})reference (#\w{6})$/.exec(text);
    return {column: Number(x), row: Number(y), x: (Number(x) + 0.5) / width,
            y: (Number(y) + 0.5) / height, yours, reference};
  });
}
