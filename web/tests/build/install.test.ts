import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { chmodSync, copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { test } from "node:test";

// Fails if another one runs, as npm ci does in the same folder.
const FakeNpm = `#!/bin/sh
mkdir running || exit 7
echo run >> runs
mkdir -p node_modules
rmdir running
echo {} > node_modules/.package-lock.json
`;

test("of several installations at the same time, one runs and the others wait", { skip: process.platform === "win32" }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "neuron-mocap-install-"));
  try {
    copyFileSync("install.mjs", join(folder, "install.mjs"));
    writeFileSync(join(folder, "package-lock.json"), "{}");
    mkdirSync(join(folder, "bin"));
    writeFileSync(join(folder, "bin", "npm"), FakeNpm);
    chmodSync(join(folder, "bin", "npm"), 0o755);
    // Left behind by a run that was killed.
    writeFileSync(join(folder, ".install-lock"), "999999999");

    const codes = await Promise.all(Array.from({ length: 4 }, () => run(folder)));

    assert.deepEqual(codes, [0, 0, 0, 0]);
    assert.equal(readFileSync(join(folder, "runs"), "utf8"), "run\n");
  } finally {
    rmSync(folder, { recursive: true });
  }
});

function run(folder: string): Promise<number | null> {
  const env = { ...process.env, PATH: join(folder, "bin") + delimiter + process.env.PATH };
  const program = spawn(process.execPath, [join(folder, "install.mjs")], { cwd: folder, env, stdio: "inherit" });
  return new Promise(resolve => program.on("exit", resolve));
}
