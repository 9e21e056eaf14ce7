// Installs the packages of the page. Of several runs at the same time, one installs and the others wait for it. Usage: node install.mjs
import { spawnSync } from "node:child_process";
import { readFileSync, rmSync, statSync, utimesSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { setTimeout } from "node:timers/promises";
import { fileURLToPath } from "node:url";

const LookAgain = 100;

const root = dirname(fileURLToPath(import.meta.url));
const lock = join(root, ".install-lock");
const list = join(root, "package-lock.json");
const installed = join(root, "node_modules", ".package-lock.json");

while (!take())
  await setTimeout(LookAgain);

try {
  process.exitCode = isCurrent() ? 0 : install();
} finally {
  rmSync(lock, { force: true });
}

function take() {
  try {
    writeFileSync(lock, String(process.pid), { flag: "wx" });
    return true;
  } catch (error) {
    if (error.code !== "EEXIST")
      throw error;

    removeIfAbandoned();
    return false;
  }
}

function removeIfAbandoned() {
  try {
    process.kill(Number(readFileSync(lock, "utf8")), 0);
  } catch (error) {
    if (error.code === "ESRCH")
      rmSync(lock, { force: true });
  }
}

function isCurrent() {
  const time = path => statSync(path, { throwIfNoEntry: false })?.mtimeMs ?? -1;
  return time(installed) >= time(list);
}

function install() {
  const { status } = spawnSync("npm ci --ignore-scripts --no-audit --no-fund --loglevel=error", { cwd: root, shell: true, stdio: "inherit" });
  if (status === 0)
    utimesSync(installed, new Date(), new Date());
  return status ?? 1;
}
