import { filesIn } from "./folders";

/** What takes dropped or chosen files. All whose `accepts` returns true get them. */
export interface FileTaker {
  /** What it takes, in words: "recordings (BVH, .nmrec, .calc)". */
  readonly what: string;
  /** Endings with a dot or types such as image/*, for the dialog that chooses files. */
  readonly endings: readonly string[];
  accepts(files: readonly File[]): boolean;
  take(files: readonly File[]): void | Promise<void>;
}

/** Files dropped on the page, or chosen by a button. */
export class Drops {
  private readonly _takers: FileTaker[] = [];
  private readonly _say: (text: string) => void;

  constructor(target: HTMLElement, say: (text: string) => void) {
    this._say = say;
    let inside = 0;
    const mark = (change: number): void => {
      inside = Math.max(0, inside + change);
      target.classList.toggle("dropping", inside > 0);
    };
    target.addEventListener("dragenter", event => {
      if (event.dataTransfer?.types.includes("Files"))
        mark(1);
    });
    target.addEventListener("dragleave", () => mark(-1));
    target.addEventListener("dragover", event => event.preventDefault());
    target.addEventListener("drop", event => {
      event.preventDefault();
      mark(-inside);
      if (event.dataTransfer)
        void this._drop(event.dataTransfer);
    });
  }

  add(taker: FileTaker): void {
    this._takers.push(taker);
  }

  /** Gives files to who accepts them, or says that nobody does. */
  open(files: readonly File[]): void {
    if (files.length === 0)
      return;

    const takers = this._takers.filter(candidate => candidate.accepts(files));
    for (const taker of takers)
      void taker.take(files);
    if (takers.length === 0)
      this._say(`${files[0].name} is not a file that this page shows. It shows ${this._takers.map(each => each.what).join(" and ")}.`);
  }

  /** Shows the browser's dialog. Without endings, it shows all files that the page takes. */
  choose(endings: readonly string[] = this._takers.flatMap(taker => taker.endings)): void {
    const input = document.createElement("input");
    input.type = "file";
    input.multiple = true;
    input.accept = endings.join(",");
    input.addEventListener("change", () => this.open([...input.files ?? []]));
    input.click();
  }

  private async _drop({ items, files }: DataTransfer): Promise<void> {
    const entries = [...items].map(item => item.webkitGetAsEntry());
    const folder = entries.find(entry => entry?.isDirectory);
    if (!folder) {
      this.open([...files]);
      return;
    }

    try {
      const all = await filesIn(entries);
      if (all.length === 0)
        this._say(`The folder ${folder.name} is empty.`);
      this.open(all);
    } catch (error) {
      this._say(`The browser cannot read the folder ${folder.name}: ${(error as Error).message}`);
    }
  }
}
