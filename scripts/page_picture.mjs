// A picture of a page as a browser shows it: Chromium, without a display or a graphics card.
//   node scripts/page_picture.mjs FILE.html PICTURE.png [WIDTHxHEIGHT [SCRIPT]]      needs `npm ci` and chromium;
//   SCRIPT is run in the page before
import {resolve} from 'node:path';

import {launch} from '../tests/programs/browser.mjs';

const [page, picture, size = '1200x800', script = ''] = process.argv.slice(2);
const [width, height] = size.split('x').map(Number);
const browser = await launch({flags: ['--hide-scrollbars'], timeout: 600000});
try {
  const tab = await browser.newPage();
  await tab.setViewport({width, height});
  await tab.emulateMediaFeatures([{name: 'prefers-reduced-motion', value: 'reduce'}]);
  await tab.goto(`file://${resolve(page)}`);
  await tab.waitForFunction('window.pomona && pomona.loads.cut', {timeout: 300000});
  await tab.evaluate(`(async () => { ${script} })()`);
  await tab.evaluate('pomona.finish()');
  await tab.screenshot({path: picture});
} finally { await browser.close(); }
