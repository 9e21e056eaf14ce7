/** All files among entries of a drop, with those in folders. */
export async function filesIn(entries: readonly (FileSystemEntry | null)[]): Promise<File[]> {
  const found: File[] = [];
  for (const entry of entries) {
    if (entry?.isDirectory)
      found.push(...await filesIn(await entriesOf(entry as FileSystemDirectoryEntry)));
    else if (entry)
      found.push(await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject)));
  }

  return found;
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
