// Writes the page to a folder: index.html, app.css, app.js with the scripts that it loads, and licenses.txt. Each file is compressed by gzip: NAME.gz.
// Usage: node build.mjs FOLDER
import { build } from "esbuild";
import { mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { basename, dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { constants, gzipSync } from "node:zlib";

const root = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2];
if (!folder) {
  console.error("Usage: node build.mjs FOLDER");
  process.exit(2);
}

const options = {
  absWorkingDir: root,
  entryPoints: ["src/app.ts", "src/app.css"].map(file => ({ in: file, out: "app" })),
  outdir: resolve(folder),
  bundle: true,
  splitting: true,
  chunkNames: "[name]-[hash]",
  format: "esm",
  target: "es2022",
  minify: true,
  legalComments: "none",
  metafile: true,
  write: false,
  logLevel: "warning",
};

const { metafile, outputFiles } = await build(options);
await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
await save("index.html", (await readFile(join(root, "index.html"), "utf8")).replace("</head>", `${preloads(metafile)}</head>`));
await save("licenses.txt", await licences(Object.keys(metafile.inputs)));
for (const { path, contents } of outputFiles)
  await save(basename(path), contents);

function save(name, contents) {
  return writeFile(join(folder, `${name}.gz`), gzipSync(contents, { level: constants.Z_BEST_COMPRESSION }));
}

// The scripts of the first picture, so that the browser asks for all of them at once.
function preloads({ outputs }) {
  const needed = new Set();
  const add = path => {
    for (const each of outputs[path].imports) {
      if (each.kind === "import-statement" && !needed.has(each.path)) {
        needed.add(each.path);
        add(each.path);
      }
    }
  };
  for (const [path, { entryPoint }] of Object.entries(outputs)) {
    if (entryPoint === "src/app.ts")
      add(path);
    if (entryPoint !== "src/main.ts")
      continue;

    needed.add(path);
    add(path);
  }

  return [...needed].map(path => `  <link rel="modulepreload" href="${basename(path)}">\n`).join("");
}

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
