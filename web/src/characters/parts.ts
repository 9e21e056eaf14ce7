/** Where files lie: folders and name, with slashes. */
export type PathOf<T> = (file: T) => string;

/** The files that were dropped with a character: buffers and pictures of a .gltf. */
export class Parts<T> {
  private readonly _main: string[];
  private readonly _byName = new Map<string, { readonly file: T; readonly path: string[] }[]>();

  constructor(main: T, files: readonly T[], pathOf: PathOf<T>) {
    this._main = segmentsOf(pathOf(main));
    for (const file of files) {
      const path = segmentsOf(pathOf(file));
      const name = path[path.length - 1];
      this._byName.set(name, [...this._byName.get(name) ?? [], { file, path }]);
    }
  }

  /**
   * The file that an address in the .gltf refers to. A drop of single files has no folders, so files are found by their name. Of several, it is the one whose
   * path ends most like the address. Of equal ones, it is the one whose path begins most like it.
   */
  find(address: string): T | undefined {
    const wanted = resolve(this._main.slice(0, -1), addressOf(address));
    const wantedBack = [...wanted].reverse();
    let best: T | undefined;
    let [mostAtEnd, mostAtStart] = [0, 0];
    for (const { file, path } of this._byName.get(partName(address)) ?? []) {
      const [atEnd, atStart] = [sameAtStart([...path].reverse(), wantedBack), sameAtStart(path, wanted)];
      if (atEnd > mostAtEnd || (atEnd === mostAtEnd && atStart > mostAtStart))
        [best, mostAtEnd, mostAtStart] = [file, atEnd, atStart];
    }

    return best;
  }
}

/** The name of the file that an address in a .gltf refers to, in lower case and without folders. */
export function partName(address: string): string {
  const path = addressOf(address);
  return path[path.length - 1];
}

function addressOf(address: string): string[] {
  // Some programs write slashes as %2F.
  return segmentsOf(address.split(/[?#]/)[0]).flatMap(segment => segmentsOf(decode(segment)));
}

function decode(segment: string): string {
  try {
    return decodeURIComponent(segment);
  } catch {
    // A name with a plain percent sign.
    return segment;
  }
}

function segmentsOf(path: string): string[] {
  return path.toLowerCase().split(/[/\\]/);
}

function resolve(folder: readonly string[], address: readonly string[]): string[] {
  const path = [...folder];
  for (const segment of address) {
    if (segment === "..")
      path.pop();
    else if (segment !== "." && segment !== "")
      path.push(segment);
  }

  return path;
}

function sameAtStart(one: readonly string[], other: readonly string[]): number {
  let same = 0;
  while (same < one.length && same < other.length && one[same] === other[same])
    same++;
  return same;
}
