// Files and texts by http on this machine, for pages that load modules.
import {readFileSync} from 'node:fs';
import {createServer} from 'node:http';
import {extname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const root = resolve(fileURLToPath(import.meta.url), '../../..');
const kinds = {
  '': 'text/html',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.glsl': 'text/plain',
  '.json': 'application/json',
  '.png': 'image/png',
  '.glb': 'model/gltf-binary',
  '.wasm': 'application/wasm'
};

/** three.js as npm has put it here; null for another path. Throws where it has not. */
const three = (path) =>
  path.startsWith('/node_modules/three/') && !path.includes('..') ? readFileSync(join(root, path)) : null;

/**
 * Serves three.js, and what `contentOf(path)` gives, bytes or text; where that throws, or gives null, it answers 404.
 * Returns {url, close()}.
 */
export async function served(contentOf) {
  const server = createServer((request, response) => {
    const path = new URL(request.url, 'http://x').pathname;
    let content = null;
    try {
      content = three(path) ?? contentOf(path);
    } catch {}  // there is no such file
    response.writeHead(
      content === null ? 404 : 200, {'Content-Type': kinds[extname(path)] ?? 'application/octet-stream'});
    response.end(content);
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return {url: `http://127.0.0.1:${server.address().port}`, close: () => server.close()};
}
