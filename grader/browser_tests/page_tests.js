// The page as a whole: what it says, at every width, in both colour schemes, on paper, by keyboard.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {browser, look} from './browser.js';
import {report, sizeOf} from './reports.js';

const kReports = ['full', 'half', 'lighting', 'broken', 'sample'];

test('the score and one sentence stand on top', () => look('half', {}, async page => {
  assert.match(await page.locator('.score').textContent(), /^25 \/ 100$/);
  assert.match(await page.locator('.next').textContent(),
               /^1 of 3 tasks is done; go on with rotation /);
  assert.deepEqual(await page.locator('.task h3 code').allTextContents(),
                   ['rotation', 'euler-rodrigues', 'cross-matrix'], 'what lost most comes first');
}));

test('full marks are said', () => look('full', {}, async page => {
  assert.match(await page.locator('.next').textContent(), /^Everything is done/);
}));

test('a compiler error shows its line, the caret below the name', () => look('broken', {}, async page => {
  const error = page.locator('.compiler li').first();
  assert.match(await error.textContent(), /rotation\.cpp:\d+:\d+: error: 'degres' was not declared/);
  const [line, caret] = (await error.locator('.source').innerText()).split('\n');
  assert.equal(caret.indexOf('^'), line.indexOf('degres'));
  assert.ok(caret.includes('^'));
  assert.equal(await page.locator('.task').count(), 0);
}));

test('matrices mark what is wrong, a recognised mistake stands out', () => look('sample', {}, async page => {
  assert.deepEqual(await page.locator('.matrix td.wrong').allTextContents(),
                   ['0.563 wrong', 'nan wrong']);
  assert.equal(await page.locator('.matrix').count(), 2);
  assert.match(await page.locator('.recognised').textContent(),
               /h is not normalised.*Read section 10\.3\.3 of the notes again/);
}));

for (const name of kReports)
  test(`${name}: fits narrow and wide windows`, () => look(name, {}, async page => {
    for (const width of [400, 900, 1600]) {
      await page.setViewportSize({width, height: 1400});
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width,
                `${width} pixels`);
    }
  }));

/** Contrast of an element's text against what lies behind it, as WCAG counts it. */
function contrast(element) {
  const parse = text => text.match(/[\d.]+/g).map(Number);
  const luminance = ([r, g, b]) => [r, g, b].map(each => each / 255)
    .map(each => each <= 0.03928 ? each / 12.92 : ((each + 0.055) / 1.055) ** 2.4)
    .reduce((sum, each, i) => sum + each * [0.2126, 0.7152, 0.0722][i], 0);
  let behind = element;
  while (behind.parentElement && (parse(getComputedStyle(behind).backgroundColor)[3] ?? 1) === 0)
    behind = behind.parentElement;
  const [a, b] = [luminance(parse(getComputedStyle(element).color)),
                  luminance(parse(getComputedStyle(behind).backgroundColor))];
  return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
}

test('light and dark differ, and both are readable', async () => {
  const papers = [];
  for (const colorScheme of ['light', 'dark'])
    await look('sample', {colorScheme}, async page => {
      papers.push(await page.evaluate(() => getComputedStyle(document.body).backgroundColor));
      for (const selector of ['.next', '.points', '.mark', '.hint', '.says', 'td.wrong', 'footer',
                              '.numbers', '.place', '.tools button'])
        for (const element of await page.locator(selector).all()) {
          const ratio = await element.evaluate(contrast);
          assert.ok(ratio >= 4.5, `${colorScheme}: ${selector} has a contrast of ${ratio.toFixed(2)}`);
        }
    });
  assert.notEqual(papers[0], papers[1]);
});

/** Three pictures beside each other, wide enough to see something. */
async function standBesideEachOther(page) {
  const pictures = await page.locator('.pictures').first().locator('figure img').all();
  const boxes = await Promise.all(pictures.map(each => each.boundingBox()));
  assert.equal(boxes.length, 3);
  assert.ok(boxes.every(each => each.width > 150 && Math.abs(each.y - boxes[0].y) < 1));
  assert.ok(boxes[0].x + boxes[0].width <= boxes[1].x);
}

test('on paper everything lies open and the pictures stand beside each other', () =>
  look('sample', {width: 800}, async page => {
    await page.emulateMedia({media: 'print', colorScheme: 'dark'});
    await standBesideEachOther(page);
    assert.ok(!await page.locator('.viewer').first().isVisible());
    const hidden = await page.locator('.inside, .titles li, .warnings li').evaluateAll(
      all => all.filter(each => !each.checkVisibility({contentVisibilityAuto: true})).length);
    assert.equal(hidden, 0, 'parts that are closed on the screen are open on paper');
    assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor),
                 'rgb(255, 255, 255)');
    assert.ok((await page.pdf()).length > 10000);
  }));

test('without scripts the pictures stand beside each other', async () => {
  const page = await browser.newPage({javaScriptEnabled: false, viewport: {width: 1000, height: 900}});
  await page.goto('file://' + report('half'));
  assert.equal(await page.locator('.viewer').count(), 0);
  await standBesideEachOther(page);
  await page.close();
});

test('everything can be reached by keyboard, and the focus is seen', () => look('sample', {}, async page => {
  const selector = 'a[href], summary, button, input, [tabindex="0"]';
  const reachable = await page.locator(selector).evaluateAll(
    all => all.filter(each => each.checkVisibility({contentVisibilityAuto: true})).length);
  const seen = new Set();
  for (let i = 0; i < reachable; ++i) {
    await page.keyboard.press('Tab');
    const [index, outline, what] = await page.evaluate(query => {
      const style = getComputedStyle(document.activeElement);
      return [[...document.querySelectorAll(query)].indexOf(document.activeElement),
              style.outlineStyle + ' ' + style.outlineWidth, document.activeElement.outerHTML];
    }, selector);
    assert.equal(outline, 'solid 3px', `the focus is seen on ${what.slice(0, 80)}`);
    seen.add(index);
  }
  assert.ok(!seen.has(-1));
  assert.equal(seen.size, reachable);
}));

test('pictures have alternative texts', () => look('sample', {}, async page => {
  assert.equal(await page.locator('img:not([alt])').count(), 0);
  assert.equal(await page.locator(
    'canvas:not([aria-hidden="true"]):not([role="img"][aria-label])').count(), 0);
  assert.match(await page.locator('img.yours').first().getAttribute('alt'), /^Your picture: ./);
  for (const label of await page.locator('canvas[role="img"]').evaluateAll(
    all => all.map(each => each.getAttribute('aria-label'))))
    assert.ok(label.length > 5);
}));

test('ten lost frames take less than 2 MB', () => look('lost', {}, async page => {
  assert.equal(await page.locator('details.check:not(.full) .pictures').count(), 10);
  assert.ok(sizeOf('lost') < 2e6, `${sizeOf('lost')} bytes`);
  assert.ok(sizeOf('lost') > 2e5, 'and they are there');
}));
