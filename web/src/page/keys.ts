export interface Shortcut {
  /** The key as KeyboardEvent.key says it; letters in lower case. */
  readonly key: string;
  /** What the list of keys says, such as "follow the performer". */
  readonly does: string;
  /** How the list of keys shows the key, if its name differs. */
  readonly label?: string;
  readonly group: string;
  /** Whether a key that is held runs again and again, as steps do. */
  readonly repeats?: boolean;
  /** Whether the key does something now. Without it, always. */
  isUseful?(): boolean;
  run(): void;
}

// Some keyboards need Option or AltGr for brackets.
const Sign = /^[^\p{L}\p{N}\s]$/u;

const OtherLetter = /^(?!\p{Script=Latin})\p{L}$/u;

/** Keys of the page. They do nothing while a field has the focus. */
export class Keys {
  private readonly _shortcuts: Shortcut[] = [];

  constructor() {
    document.addEventListener("keydown", event => {
      if (event.ctrlKey || event.metaKey || event.altKey && !Sign.test(event.key) || isField(event))
        return;

      const key = nameOf(event);
      const shortcut = this.all.find(each => each.key === key);
      if (!shortcut)
        return;

      event.preventDefault();
      if (!event.repeat || shortcut.repeats)
        shortcut.run();
    });
  }

  /** The shortcuts that do something now. */
  get all(): readonly Shortcut[] {
    return this._shortcuts.filter(each => each.isUseful?.() ?? true);
  }

  /** Adds shortcuts. Returns a function that removes them. */
  add(...shortcuts: Shortcut[]): () => void {
    this._shortcuts.push(...shortcuts);
    return () => {
      for (const shortcut of shortcuts)
        this._shortcuts.splice(this._shortcuts.indexOf(shortcut), 1);
    };
  }
}

// A keyboard of another alphabet has the shortcuts where a Latin one has their letters.
function nameOf({ key, code }: KeyboardEvent): string {
  if (OtherLetter.test(key) && code.startsWith("Key"))
    return code.slice(-1).toLowerCase();
  return key.length === 1 ? key.toLowerCase() : key;
}

// The space bar and Enter press a button that has the focus.
function isField(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement;
  if (document.querySelector("dialog[open]"))
    return true;
  if (target.matches("button, summary, a") && (event.key === " " || event.key === "Enter"))
    return true;
  return target.matches("input:not([type=checkbox]):not([type=radio]):not([type=range]), select, textarea")
    || target.matches("input[type=range], input[type=radio]") && event.key.startsWith("Arrow");
}
