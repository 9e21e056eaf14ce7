// Writes the page to a folder: index.html, app.js, app.css and licenses.txt. Usage: node build.mjs FOLDER
import { build } from "esbuild";
import { copyFile, mkdir, readFile, readdir, writeFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2];
if (!folder) {
  console.error("Usage: node build.mjs FOLDER");
  process.exit(2);
}

const options = {
  absWorkingDir: root,
  entryPoints: ["src/main.ts", "src/app.css"].map(file => ({ in: file, out: "app" })),
  outdir: resolve(folder),
  bundle: true,
  format: "esm",
  target: "es2022",
  minify: true,
  legalComments: "none",
  metafile: true,
  logLevel: "warning",
};

await mkdir(folder, { recursive: true });
await copyFile(join(root, "index.html"), join(folder, "index.html"));
const { metafile } = await build(options);
await writeFile(join(folder, "licenses.txt"), await licences(Object.keys(metafile.inputs)));

// The licences of the packages from which code is in the bundle. A package without a licence file ends the build.
async function licences(inputs) {
  const packages = new Set();
  for (const input of inputs) {
    const match = /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(input);
    if (match)
      packages.add(match[1]);
  }

  const texts = [];
  for (const path of [...packages].sort()) {
    const about = JSON.parse(await readFile(join(root, path, "package.json"), "utf8"));
    const file = (await readdir(join(root, path))).find(name => /^licen[cs]e/i.test(name));
    if (!file)
      throw new Error(`The package ${about.name} has no licence file.`);

    texts.push(`${about.name} ${about.version} (${about.license})\n\n${(await readFile(join(root, path, file), "utf8")).trim()}\n`);
  }

  return `The page contains code of these packages.\n\n${texts.join(`\n${"-".repeat(80)}\n\n`)}`;
}
