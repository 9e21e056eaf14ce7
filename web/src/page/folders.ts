const paths = new WeakMap<File, string>();

/** Folders and name of a file, as it was dropped: "hero/textures/skin.png". */
export function pathOf(file: File): string {
  return paths.get(file) ?? file.name;
}

/** All files among entries of a drop, with those in folders. */
export async function filesIn(entries: readonly (FileSystemEntry | null)[]): Promise<File[]> {
  const found: File[] = [];
  for (const entry of entries) {
    if (entry?.isDirectory)
      found.push(...await filesIn(await entriesOf(entry as FileSystemDirectoryEntry)));
    else if (entry)
      found.push(await fileOf(entry as FileSystemFileEntry));
  }

  return found;
}

async function fileOf(entry: FileSystemFileEntry): Promise<File> {
  const file = await new Promise<File>((resolve, reject) => entry.file(resolve, reject));
  paths.set(file, entry.fullPath.replace(/^\/+/, ""));
  return file;
}

// A reader gives some entries at a time, and none at the end.
async function entriesOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0)
      return all;

    all.push(...some);
  }
}
