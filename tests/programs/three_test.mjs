// three.js in a headless Chromium draws a .glb as we do: the same silhouettes, much the same colours.
//   node three_test.mjs FILE.glb OUR_PICTURE.png FOLDER
// Run where node_modules lies. The picture of three.js is left in FOLDER/three.png.
import {execFile} from 'node:child_process';
import {mkdirSync, readFileSync} from 'node:fs';
import {createServer} from 'node:http';
import {dirname, extname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {promisify} from 'node:util';

const [glb, picture, folder] = process.argv.slice(2).map((path) => resolve(path));
const here = dirname(fileURLToPath(import.meta.url));
const root = resolve(here, '../..');
const named = {
  '/': join(here, 'three_page.html'),
  '/scene.glb': glb,
  '/picture.png': picture
};
const kinds = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.png': 'image/png',
  '.glb': 'model/gltf-binary'
};

const server = createServer((request, response) => {
                 const path = new URL(request.url, 'http://x').pathname;
                 const file = named[path] ?? (path.startsWith('/node_modules/three/') ? join(root, path) : null);
                 try {
                   response.setHeader('Content-Type', kinds[extname(file)]);
                   response.end(readFileSync(file));
                 } catch { response.writeHead(404).end(); }
               }).listen(0, '127.0.0.1');
await new Promise((done) => server.on('listening', done));

mkdirSync(folder, {recursive: true});
const chromium = async (...words) =>
  (await promisify(execFile)(
     'chromium',
     [
       '--headless=new', '--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader',
       '--enable-unsafe-swiftshader', '--hide-scrollbars', '--window-size=480,360',
       `--user-data-dir=${join(folder, 'profile')}`, '--virtual-time-budget=20000', ...words,
       `http://127.0.0.1:${server.address().port}/`
     ],
     {timeout: 200000, maxBuffer: 1 << 26}))
    .stdout;
const page = await chromium(`--screenshot=${join(folder, 'three.png')}`, '--dump-dom');
server.close();

const title = /<title>(.*?)<\/title>/s.exec(page)
                ?.[1]
                .replaceAll('&quot;', '"')
                .replaceAll('&lt;', '<')
                .replaceAll('&gt;', '>')
                .replaceAll('&amp;', '&');
const found = JSON.parse(title ?? '{"error": "the page did not end"}');
console.log(JSON.stringify(found, null, 1));

// Our shading and theirs differ: silhouettes must not, hues hardly.
const wrong = [];
if (found.error) wrong.push(found.error);
else {
  if (!(found.share > 0.03)) wrong.push('three.js shows next to nothing');
  if (!(found.overlap > 0.9)) wrong.push('silhouettes differ');
  found.ours.forEach((ours, k) => {
    if (!(Math.abs(ours - found.theirs[k]) < 45)) wrong.push(`mean colours differ: ${found.ours} and ${found.theirs}`);
  });
  if (!(found.theirs[0] > found.theirs[2] + 15)) wrong.push('red fruit is not red');
}
wrong.forEach((line) => console.error(`three: error: ${line}`));
process.exit(wrong.length > 0 ? 1 : 0);
