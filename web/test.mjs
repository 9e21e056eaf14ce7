// Bundles the tests of this folder and runs them with Node's test runner, in one process, because three.js takes a while to load. Usage: node test.mjs [NAME...]
import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { mkdtemp, readdir, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = dirname(fileURLToPath(import.meta.url));
const wanted = process.argv.slice(2);
const tests = (await readdir(join(root, "tests"), { recursive: true }))
  .filter(name => name.endsWith(".test.ts") && (wanted.length === 0 || wanted.some(word => name.includes(word))));
if (tests.length === 0) {
  console.error(`No test file has ${wanted.join(" or ")} in its name.`);
  process.exit(1);
}

const folder = await mkdtemp(join(tmpdir(), "neuron-mocap-page-"));
const file = join(folder, "tests.mjs");
try {
  await build({
    absWorkingDir: root,
    stdin: { contents: tests.map(name => `import "./tests/${name.replaceAll("\\", "/")}";`).join("\n"), resolveDir: root },
    outfile: file,
    bundle: true,
    sourcemap: "inline",
    sourcesContent: false,
    format: "esm",
    platform: "node",
    target: "es2022",
    logLevel: "warning",
  });
  const run = spawnSync(process.execPath, ["--enable-source-maps", "--test", file], { cwd: root, stdio: "inherit" });
  process.exitCode = run.status ?? 1;
} finally {
  await rm(folder, { recursive: true, force: true });
}
