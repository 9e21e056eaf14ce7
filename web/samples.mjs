// Writes characters of boxes for tests and for looking at the page: VRM 1.0 and 0.x, GLB and glTF. Usage: node samples.mjs FOLDER
import { build } from "esbuild";
import { mkdir, rm, writeFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { crc32, deflateSync } from "node:zlib";

const root = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2];
if (!folder) {
  console.error("Usage: node samples.mjs FOLDER");
  process.exit(2);
}

await mkdir(folder, { recursive: true });
const script = resolve(folder, "sample.mjs");
await build({ absWorkingDir: root, entryPoints: ["tests/characters/sample.ts"], outfile: script, bundle: true, format: "esm", platform: "node", logLevel: "warning" });
const { makeSample, mixamoName, toGlb } = await import(pathToFileURL(script).href);
await rm(script);

const picture = checks();
const save = (name, bytes) => writeFile(join(folder, name), typeof bytes === "string" ? bytes : new Uint8Array(bytes));
await save("boxes-1.vrm", toGlb(makeSample({ vrm: "1", twisted: true, picture })));
await save("boxes-0.vrm", toGlb(makeSample({ vrm: "0", twisted: true, picture })));
await save("boxes-mixamo.glb", toGlb(makeSample({ vrm: null, nameOf: mixamoName, twisted: true, lowered: 45, scale: 0.01, picture })));
await save("boxes-z-up.glb", toGlb(makeSample({ vrm: null, nameOf: mixamoName, scale: 0.01, zUp: true, rich: true, twisted: true, picture })));
const { json, binary } = makeSample({ vrm: null, nameOf: mixamoName });
json.buffers[0].uri = "boxes.bin";
json.materials[0].pbrMetallicRoughness.baseColorTexture = { index: 0 };
await save("boxes.gltf", JSON.stringify({ ...json, textures: [{ source: 0 }], images: [{ uri: "textures/boxes.png" }] }));
await save("boxes.bin", binary);
await save("boxes.png", picture);

// A picture of light and dark squares, as PNG.
function checks() {
  const size = 16;
  const rows = Buffer.alloc(size * (size * 3 + 1));
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++)
      rows.fill((x >> 2) + (y >> 2) & 1 ? 255 : 190, y * (size * 3 + 1) + 1 + x * 3, y * (size * 3 + 1) + 4 + x * 3);
  }

  const head = Buffer.from([0, 0, 0, size, 0, 0, 0, size, 8, 2, 0, 0, 0]);
  return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), chunk("IHDR", head), chunk("IDAT", deflateSync(rows)), chunk("IEND", Buffer.alloc(0))]);
}

function chunk(name, data) {
  const body = Buffer.concat([Buffer.from(name, "latin1"), data]);
  const [length, check] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(data.length);
  check.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, check]);
}
