/** Endings of the files that hold takes. */
export const TakeEndings: readonly string[] = [".bvh", ".nmrec", ".calc", ".bin", ".dat"];

/** Finds the takes among files that were dropped together. The server decides by the contents, so a single file may have any name. */
export function findTakes<T extends { readonly name: string }>(files: readonly T[]): T[] {
  const names = (pattern: RegExp) => files.some(file => pattern.test(file.name));
  // The buffers of a .gltf are .bin as well.
  const isPart = names(/\.gltf$/i) ? /\.(bin|dat)$/i : /^$/;
  const found = files.filter(file => TakeEndings.some(ending => file.name.toLowerCase().endsWith(ending)) && !isPart.test(file.name));
  return found.length === 0 && files.length === 1 && !names(/\.(vrm|glb|gltf|fbx)$/i) ? [...files] : found;
}
