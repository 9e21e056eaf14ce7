import { partName, Parts, type PathOf } from "./parts";

/** Endings of the files that show a character. */
export const CharacterEndings: readonly string[] = [".vrm", ".glb", ".gltf"];

/** What the dialog for characters shows: a .gltf comes with its buffers and pictures. */
export const CharacterChoices: readonly string[] = [...CharacterEndings, ".bin", "image/*"];

/** What a glTF file requires that this page does not read, in words. */
const Unsupported: Readonly<Record<string, string>> = {
  KHR_draco_mesh_compression: "compressed with Draco",
  EXT_meshopt_compression: "compressed with meshopt",
  KHR_meshopt_compression: "compressed with meshopt",
  KHR_texture_basisu: "textured with KTX2",
};

export interface CharacterFiles<T> {
  readonly main: T;
  readonly parts: Parts<T>;
}

/** Finds the characters among files that were dropped together. */
export function findCharacters<T extends { readonly name: string }>(files: readonly T[], pathOf: PathOf<T> = file => file.name): CharacterFiles<T>[] {
  const isMain = (file: T): boolean => CharacterEndings.some(ending => file.name.toLowerCase().endsWith(ending));
  const others = files.filter(file => !isMain(file));
  return files.filter(isMain).map(main => ({ main, parts: new Parts(main, others, pathOf) }));
}

interface GltfJson {
  readonly extensionsUsed?: readonly string[];
  readonly extensionsRequired?: readonly string[];
  readonly buffers?: readonly { readonly uri?: string }[];
  readonly images?: readonly { readonly uri?: string }[];
}

/** Says in a sentence why a character cannot be shown, or null. */
export function findObstacle(name: string, json: GltfJson, parts: Pick<Parts<unknown>, "find">): string | null {
  // The loader of three.js refuses Draco also where a file could do without.
  const used = json.extensionsUsed?.filter(each => each === "KHR_draco_mesh_compression") ?? [];
  const reasons = [...new Set([...used, ...json.extensionsRequired ?? []].map(each => Unsupported[each]).filter(each => each !== undefined))];
  if (reasons.length > 0)
    return `${name} is ${reasons.join(" and ")}, which this page cannot read. Export it without.`;

  const missing = [...json.buffers ?? [], ...json.images ?? []]
    .map(each => each.uri)
    .filter(uri => uri !== undefined && !uri.startsWith("data:"))
    .filter(uri => !parts.find(uri!))
    .map(uri => partName(uri!));
  return missing.length > 0 ? `${name} needs ${list(missing)}. Drop all of its files together.` : null;
}

/** Reads the JSON of a .glb or .gltf file. Throws an Error with a sentence if it is none. */
export function readJson(name: string, bytes: ArrayBuffer): GltfJson {
  if (bytes.byteLength === 0)
    throw new Error(`${name} is empty.`);

  const view = new DataView(bytes);
  const isBinary = bytes.byteLength >= 20 && view.getUint32(0, true) === 0x46546c67;
  if (isBinary && (view.getUint32(4, true) !== 2 || view.getUint32(16, true) !== 0x4e4f534a || 20 + view.getUint32(12, true) > bytes.byteLength))
    throw new Error(`${name} is damaged, or of an old version of glTF.`);

  if (isBinary && view.getUint32(8, true) > bytes.byteLength)
    throw new Error(`${name} is cut off: its end is missing.`);

  const text = isBinary ? new Uint8Array(bytes, 20, view.getUint32(12, true)) : new Uint8Array(bytes);
  try {
    const json = JSON.parse(new TextDecoder().decode(text)) as GltfJson & { asset?: unknown };
    if (typeof json === "object" && json?.asset)
      return json;
  } catch {
    // Not JSON.
  }

  throw new Error(`${name} is not a glTF or VRM file.`);
}

function list(names: readonly string[]): string {
  const shown = names.slice(0, 3).join(", ");
  return names.length > 3 ? `${shown} and ${names.length - 3} more files` : shown;
}
