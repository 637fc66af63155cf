// Starts the studio's page.
import {$} from '../../../render/page/messages.js';

import {Bezier, nodeAt} from './bezier.js';
import {showBrush} from './brush.js';
import {FruitView} from './fruit_view.js';
import {putRamp} from './paint.js';
import {attachPanel} from './panel.js';
import {hexOf} from './ramp.js';
import {Server} from './server.js';
import {sideNamed, sideOf} from './side_text.js';
import {Studio} from './studio.js';
import {A} from './svg_text.js';

(async () => {
  const studio = /** @type {any} */ (window).studio = new Studio(new Server($('script').dataset.token));
  studio.view = new FruitView($('view'), JSON.parse($('options').textContent), $('worker').textContent, {
    changed: () => {
      studio.loads.cut = performance.now();
    },
    failed: (text) => studio.bar(text)
  });
  if (!studio.view.picture.gl) studio.view = null;
  // For tests and for the console.
  studio.modules = {A, Bezier, hexOf, nodeAt, putRamp, showBrush, sideNamed, sideOf};
  attachPanel(studio);
  studio.setTool('nodes');
  try {
    await studio.open();
  } catch (error) {
    studio.bar(`The fruit cannot be opened: ${error.message}`);
    throw error;
  }
  setInterval(() => studio.poll(), 1200);
})();
