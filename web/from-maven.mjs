// Builds the page as a step of the Maven build: fetches the libraries once, then runs build.mjs. Where that cannot be
// done, the rest of the program is built without the page.
import { spawnSync } from 'node:child_process';
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';

const here = import.meta.dirname ?? process.cwd();
const done = path.join(here, 'node_modules', '.installed.json');

function give(up) {
  rmSync(path.join(here, 'target', 'site'), { recursive: true, force: true });
  console.warn(`The page for web browsers is not built: ${up}.`);
  process.exit(1);
}

function run(command, args) {
  // npm is a script, which Windows starts by its shell only.
  const ended = spawnSync(command, args, { cwd: here, stdio: 'inherit', shell: process.platform === 'win32' });
  if (ended.status !== 0) {
    give(`${command} ${args.join(' ')} failed`);
  }
}

const version = process.versions.node;
if (Number(version.split('.')[0]) < 20) {
  give(`it needs Node.js 20 or later, and this is ${version}`);
}
const wanted = readFileSync(path.join(here, 'package-lock.json'), 'utf8');
let installed = '';
try {
  installed = readFileSync(done, 'utf8');
} catch {
  // not yet
}
if (installed !== wanted) {
  run('npm', ['ci']);
  writeFileSync(done, wanted);
}
run('node', ['build.mjs']);
