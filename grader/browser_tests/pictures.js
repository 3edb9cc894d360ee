// Helper of docs/make-pictures.sh.
// node pictures.js FOLDER DOCS: FOLDER/report, class and gallery as a browser shows them, in DOCS.
// node pictures.js --window PICTURE TITLE FILE: a window's picture under a bar with its title.
import {existsSync, readFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {chromium} from 'playwright-core';

const program = ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find(each => existsSync(each));
if (!program)
  throw new Error('Chromium is missing: install the package chromium');
const browser =
  await chromium.launch({executablePath: program, args: ['--no-sandbox', '--disable-gpu']});

/** Opens a page, lets `prepare` change it, and writes what a window of this size shows, made 1000
 *  pixels wide. */
async function take(url, file, size, prepare = async () => {}) {
  const page =
    await browser.newPage({viewport: size, colorScheme: 'light', deviceScaleFactor: 1000 / size.width});
  await page.goto(url);
  await page.waitForLoadState('networkidle');
  await prepare(page);
  await page.waitForTimeout(300);
  await page.screenshot({path: file});
  await page.close();
}

/** Puts numbers beside the parts of a report, in their order. */
async function number(page) {
  const parts = ['.score', '.contents', '.recognised', '.check[open]', '.check[open] .hint', '.stage',
                 '.magnifier'];
  await page.evaluate(selectors => selectors.forEach((selector, i) => {
    const part = [...document.querySelectorAll(selector)].find(each => each.offsetHeight > 0);
    if (!part)
      throw new Error(`the report has no ${selector}`);
    const box = part.getBoundingClientRect(), badge = document.createElement('b');
    badge.textContent = i + 1;
    badge.style.cssText = `position:absolute;left:${box.left + scrollX - 30}px;` +
      `top:${box.top + scrollY}px;width:26px;height:26px;border-radius:13px;background:#b3004b;` +
      'color:#fff;font:600 15px/26px sans-serif;text-align:center;z-index:9';
    document.body.append(badge);
  }), parts);
}

const withPath = path => 'file://' + resolve(path);
const [first, ...rest] = process.argv.slice(2);
try {
  if (first === '--window') {
    const [picture, title, file] = rest;
    const page = await browser.newPage({viewport: {width: 440, height: 350}});
    await page.setContent('<body style="margin:0;padding:8px 20px;background:#fff"><div style="' +
      'width:400px;font:13px/28px sans-serif;background:#ddd;text-align:center;border-radius:6px ' +
      '6px 0 0;overflow:hidden;white-space:nowrap;text-overflow:ellipsis"></div><img>');
    await page.evaluate(([text, bytes]) => {
      document.querySelector('div').textContent = text;
      document.querySelector('img').src = 'data:image/png;base64,' + bytes;
    }, [title, readFileSync(picture).toString('base64')]);
    await page.waitForTimeout(300);
    await page.screenshot({path: file});
  } else {
    const docs = rest[0], report = withPath(first + '/report/index.html');
    const live = page => page.waitForFunction(() => document.querySelector('.frame.live'));
    await take(report, docs + '/report.png', {width: 1240, height: 1220}, live);
    await take(report, docs + '/report-explained.png', {width: 1240, height: 1180}, async page => {
      await live(page);
      await number(page);
    });
    await take(withPath(first + '/class/index.html'), docs + '/overview.png',
               {width: 1000, height: 720});
    await take(withPath(first + '/gallery/index.html'), docs + '/gallery.png',
               {width: 1000, height: 560});
  }
} finally {
  await browser.close();
}
