// Builds what the jar carries into target/site, with files.txt, the list of its files.
import { build } from 'esbuild';
import { cp, mkdir, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';

const here = import.meta.dirname;
const site = path.join(here, 'target', 'site');
const xite = path.join(here, 'node_modules', 'x_ite');

// Components that need megabytes and that no walk through an apartment uses: physics, and volumes of scanners.
const LEFT_OUT = new Set(['RigidBodyPhysicsComponent.min.js', 'Texturing3DComponent.min.js']);

await rm(site, { recursive: true, force: true });
await mkdir(path.join(site, 'page', 'x_ite'), { recursive: true });
await build({
  entryPoints: {
    'page/page': path.join(here, 'src', 'page', 'main.ts'),
    // The program knows the files of a study's page by their names, which begin with "study".
    'page/study': path.join(here, 'src', 'study', 'main.ts'),
  },
  bundle: true,
  minify: true,
  format: 'iife',
  target: ['es2022', 'chrome111', 'firefox115', 'safari16.4'],
  outdir: site,
  legalComments: 'none',
});
await cp(path.join(here, 'src', 'page', 'index.html'), path.join(site, 'index.html'));
await cp(path.join(here, 'src', 'page', 'page.css'), path.join(site, 'page', 'page.css'));
await cp(path.join(here, 'src', 'study', 'study.html'), path.join(site, 'study.html'));
await cp(path.join(here, 'src', 'study', 'study.css'), path.join(site, 'page', 'study.css'));
await cp(path.join(here, 'src', 'study', 'licences.txt'), path.join(site, 'page', 'study-licences.txt'));

const dist = path.join(xite, 'dist');
const into = path.join(site, 'page', 'x_ite');
await cp(path.join(dist, 'x_ite.min.js'), path.join(into, 'x_ite.min.js'));
await cp(path.join(dist, 'x_ite.css'), path.join(into, 'x_ite.css'));
for (const folder of ['fonts', 'hatching', 'images', 'lib', 'linetype']) {
  await cp(path.join(dist, 'assets', folder), path.join(into, 'assets', folder), { recursive: true });
}
for (const name of await readdir(path.join(dist, 'assets', 'components'))) {
  if (name.endsWith('.min.js') && !LEFT_OUT.has(name)) {
    await cp(path.join(dist, 'assets', 'components', name), path.join(into, 'assets', 'components', name));
  }
}
await cp(path.join(dist, 'LICENSE.md'), path.join(into, 'LICENSE.md'));
await cp(path.join(xite, 'LICENSES'), path.join(into, 'LICENSES'), { recursive: true });
const { version } = JSON.parse(await readFile(path.join(xite, 'package.json'), 'utf8'));
await writeFile(
  path.join(into, 'LICENSES', 'README.txt'),
  `X_ITE ${version}, https://create3000.github.io/x_ite/, MIT; the libraries in it have the licences of this folder.\n`,
);

const files = (await readdir(site, { recursive: true, withFileTypes: true }))
  .filter((entry) => entry.isFile())
  .map((entry) => path.relative(site, path.join(entry.parentPath, entry.name)).split(path.sep).join('/'))
  .sort();
await writeFile(path.join(site, 'files.txt'), files.join('\n') + '\n');
console.log(`${files.length} files in ${path.relative(here, site)}`);
