// The tools to compare pictures with: what is on the screen must change as they promise.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {coloursOnScreen, look, worstOf} from './browser.js';

const channels = colour => [1, 3, 5].map(at => parseInt(colour.slice(at, at + 2), 16));
const apart = (a, b) => Math.max(...channels(a).map((each, i) => Math.abs(each - channels(b)[i])));

function near(actual, expected, why) {
  assert.ok(apart(actual, expected) < 20, `${why ?? ''} expected about ${expected}, got ${actual}`);
}

/**
 * A place where the pictures differ much, away from labels and edges: {x, y} as shares of the
 * picture, and both colours as the pictures have them.
 */
async function clearPlace(viewer) {
  const place = await viewer.evaluate(root => {
    const [yours, reference] = ['yours', 'reference'].map(name => {
      const canvas = root.querySelector(`.stage canvas.${name}`);
      return canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    });
    const {width, height} = reference;
    const at = (pixels, x, y) => [...pixels.data.slice(4 * (y * width + x), 4 * (y * width + x) + 3)];
    const far = (a, b) => Math.max(...a.map((each, i) => Math.abs(each - b[i])));
    const even = (pixels, x, y) => [[-2, 0], [2, 0], [0, -2], [0, 2]].every(
      ([dx, dy]) => far(at(pixels, x, y), at(pixels, x + dx, y + dy)) < 16);
    const hex = colour => '#' + colour.map(each => each.toString(16).padStart(2, '0')).join('');
    for (let y = 10; y < 0.85 * height; ++y)
      for (let x = 10; x < width - 10; ++x)
        if (Math.abs(x / width - 0.5) > 0.08 && even(yours, x, y) && even(reference, x, y) &&
            far(at(yours, x, y), at(reference, x, y)) > 90)
          return {x: (x + 0.5) / width, y: (y + 0.5) / height, yours: hex(at(yours, x, y)),
                  reference: hex(at(reference, x, y))};
    return null;
  });
  assert.ok(place, 'there is a wrong place away from labels and edges');
  return place;
}

async function shown(viewer, place) {
  return (await coloursOnScreen(viewer.locator('.stage canvas.yours'), [[place.x, place.y]]))[0];
}

for (const name of ['half', 'lighting', 'sample'])
  test(`${name}: the slider wipes between yours and the reference`, () => look(name, {}, async page => {
    const viewer = page.locator('.viewer').first();
    const place = await clearPlace(viewer);
    const slider = viewer.locator('input.wipe');
    await slider.fill('100');
    near(await shown(viewer, place), place.yours);
    await slider.fill('0');
    near(await shown(viewer, place), place.reference);
    const before = Math.floor(100 * place.x) - 2;
    await slider.fill(String(before));
    near(await shown(viewer, place), place.reference, 'right of the handle');
    await slider.fill(String(before + 5));
    near(await shown(viewer, place), place.yours, 'left of the handle');
  }));

test('the slider wipes by keyboard', () => look('half', {}, async page => {
  const viewer = page.locator('.viewer').first();
  const place = await clearPlace(viewer);
  await viewer.locator('input.wipe').focus();
  await page.keyboard.press('End');
  near(await shown(viewer, place), place.yours);
  await page.keyboard.press('Home');
  near(await shown(viewer, place), place.reference);
  const pictures = [await viewer.locator('.stage').screenshot()];
  for (let i = 0; i < 40; ++i)
    await page.keyboard.press('ArrowRight');
  pictures.push(await viewer.locator('.stage').screenshot());
  assert.ok(!pictures[0].equals(pictures[1]));
  assert.equal(await viewer.locator('input.wipe').inputValue(), '40');
}));

test('dragging in the picture wipes', () => look('half', {}, async page => {
  const viewer = page.locator('.viewer').first();
  const place = await clearPlace(viewer);
  const box = await viewer.locator('.stage').boundingBox();
  await page.mouse.move(box.x + 2, box.y + 20);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width - 2, box.y + 20);
  near(await shown(viewer, place), place.yours);
  await page.mouse.up();
}));

test('the key b blinks the frame in view', () => look('half', {}, async page => {
  const viewer = page.locator('.viewer').first();
  await viewer.scrollIntoViewIfNeeded();
  const place = await clearPlace(viewer);
  for (const expected of ['reference', 'yours', 'reference']) {
    await page.keyboard.press('b');
    near(await shown(viewer, place), place[expected]);
    assert.match(await viewer.locator('.status').textContent(), new RegExp(expected));
  }
  await page.keyboard.press('Escape');
  assert.equal(await viewer.locator('.stage').getAttribute('data-show'), 'wipe');
}));

test('a key means the frame that has the focus', () => look('half', {}, async page => {
  const viewers = page.locator('.viewer');
  await viewers.nth(1).locator('input.wipe').focus();
  await page.keyboard.press('b');
  assert.deepEqual(
    await page.locator('.stage').evaluateAll(all => all.slice(0, 2).map(each => each.dataset.show)),
    ['wipe', 'reference']);
}));

test('pointing at the button blinks, holding it shows yours, the keyboard works it', () =>
  look('half', {}, async page => {
    const viewer = page.locator('.viewer').first();
    const place = await clearPlace(viewer);
    const button = viewer.locator('button.blink');
    await button.hover();
    near(await shown(viewer, place), place.reference);
    await page.mouse.down();
    near(await shown(viewer, place), place.yours);
    await page.mouse.up();
    near(await shown(viewer, place), place.reference);
    await page.mouse.move(1, 1);
    await button.focus();
    await page.keyboard.press('Enter');
    near(await shown(viewer, place), place.reference);
    await page.keyboard.press('Space');
    near(await shown(viewer, place), place.yours);
  }));

test('the difference is a heat map with a legend', () => look('half', {}, async page => {
  const viewer = page.locator('.viewer').first();
  const place = await clearPlace(viewer);
  assert.ok(!await viewer.locator('.legend').isVisible());
  await viewer.locator('button.difference').click();
  assert.ok(await viewer.locator('.legend').isVisible());
  assert.equal(await viewer.locator('button.difference').getAttribute('aria-pressed'), 'true');
  const [wrong, agrees] = await coloursOnScreen(viewer.locator('.stage canvas.yours'),
                                                [[place.x, place.y], [0.02, 0.02]]);
  assert.equal(wrong, '#fce83c', 'as wrong as can be is at the end of the scale');
  assert.match(agrees, /^#(..)\1\1$/, 'what agrees is grey');
  const legend = await coloursOnScreen(viewer.locator('.legend canvas'), [[0.98, 0.5]]);
  assert.match(legend[0], /^#fb|^#fc/);
  await page.keyboard.press('d');
  assert.ok(!await viewer.locator('.legend').isVisible());
}));

async function centres(viewer) {
  const centre = [[0.5, 0.5]];
  return [(await coloursOnScreen(viewer.locator('.glass.of-yours'), centre))[0],
          (await coloursOnScreen(viewer.locator('.glass.of-reference'), centre))[0]];
}

test('the magnifier shows a worst pixel in both pictures', () => look('half', {}, async page => {
  const viewer = page.locator('.viewer').first();
  const worst = await worstOf(viewer);
  assert.equal(worst.length, 5);
  for (const i of [1, 3]) {
    await viewer.locator('.worst button').nth(i).focus();
    assert.deepEqual(await centres(viewer), [worst[i].yours, worst[i].reference]);
    assert.match(await viewer.locator('.magnifier .place').textContent(),
                 new RegExp(`\\(${worst[i].column}, ${worst[i].row}\\)`));
    assert.deepEqual(await viewer.locator('.glasses code').allTextContents(),
                     [worst[i].yours, worst[i].reference]);
  }
  await viewer.locator('.glasses').focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowDown');
  assert.match(await viewer.locator('.magnifier .place').textContent(),
               new RegExp(`\\(${worst[3].column + 1}, ${worst[3].row + 1}\\)`));
}));

test('the magnifier follows the pointer', () => look('half', {}, async page => {
  const viewer = page.locator('.viewer').first();
  const box = await viewer.locator('.stage').boundingBox();
  await page.mouse.move(box.x + box.width * 0.25, box.y + box.height * 0.5);
  assert.match(await viewer.locator('.magnifier .place').textContent(), /\((99|100|101), (149|150|151)\)/);
}));

test('a feature shows its mask when pointed at or focused', () => look('sample', {}, async page => {
  const viewer = page.locator('.viewer').first();
  const stage = viewer.locator('.stage');
  const before = await stage.screenshot();
  const feature = page.locator('.feature[tabindex]').first();
  const lit = async () => {
    await page.waitForSelector('.stage.lit');
    const [dark, glint] = await coloursOnScreen(stage.locator('canvas.yours'), [[0.1, 0.1], [174 / 400, 124 / 300]]);
    assert.ok(parseInt(dark.slice(1, 3), 16) < 20, `outside it is dark, got ${dark}`);
    assert.ok(parseInt(glint.slice(1, 3), 16) > 100, `inside it is as it was, got ${glint}`);
    assert.ok(!before.equals(await stage.screenshot()));
  };
  await feature.hover();
  await lit();
  await page.mouse.move(1, 1);
  await page.waitForSelector('.stage.lit', {state: 'detached'});
  near((await coloursOnScreen(stage.locator('canvas.yours'), [[0.1, 0.1]]))[0], '#1a334d', 'as before');
  await viewer.locator('.worst button').last().focus();
  await page.keyboard.press('Tab');
  assert.ok(await feature.evaluate(each => each === document.activeElement));
  await lit();
}));

test('a full frame is small and closed, and has the same tools', () => look('full', {}, async page => {
  assert.equal(await page.locator('.viewer').count(), 0);
  const frame = page.locator('details.check.full').first();
  assert.ok(await frame.locator('summary img').isVisible());
  await frame.locator('summary').focus();
  await page.keyboard.press('Enter');
  await frame.locator('.viewer').waitFor();
  assert.match(await frame.locator('.worst').textContent(), /No pixel is wrong/);
  await page.keyboard.press('b');
  assert.equal(await frame.locator('.stage').getAttribute('data-show'), 'reference');
}));
