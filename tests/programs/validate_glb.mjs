// Runs the Khronos glTF validator over .glb files; fails on any error or warning.
//   node validate_glb.mjs FILE-or-FOLDER...
import validator from 'gltf-validator';
import {readdirSync, readFileSync, statSync} from 'node:fs';
import {join} from 'node:path';

const files = process.argv.slice(2).flatMap(
  (path) => statSync(path).isDirectory()
    ? readdirSync(path).filter((name) => name.endsWith('.glb')).sort().map((name) => join(path, name))
    : [path]);
if (files.length === 0) {
  console.error('no .glb files to validate');
  process.exit(1);
}

let bad = 0;
for (const file of files) {
  const bytes = new Uint8Array(readFileSync(file));
  const report =
    await validator.validateBytes(bytes, {uri: file, format: 'glb', maxIssues: 100, writeTimestamp: false});
  const {numErrors, numWarnings, numInfos, messages} = report.issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} notes`);
  for (const {severity, code, message, pointer} of messages.slice(0, 20))
    console.log(`  ${['error', 'warning', 'note', 'hint'][severity]} ${code} ${pointer ?? ''}: ${message}`);
  if (numErrors + numWarnings > 0) bad += 1;
}
process.exit(bad > 0 ? 1 : 0);
