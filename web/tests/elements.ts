import { setGlobals } from "./globals";

/** As much of an element as parts of the panel need. */
export class FakeElement extends EventTarget {
  readonly attributes = new Map<string, string>();
  readonly classList = { add: () => {}, remove: () => {}, toggle: () => {} };
  readonly dataset = {};
  hidden = false;
  private _children: (FakeElement | string)[] = [];

  constructor(readonly name: string) {
    super();
  }

  get textContent(): string {
    return this._children.map(child => typeof child === "string" ? child : child.textContent).join(" ");
  }

  set textContent(text: string) {
    this._children = [text];
  }

  /** The elements inside that have a name. */
  all(name: string): FakeElement[] {
    const inside = this._children.filter(child => child instanceof FakeElement);
    return inside.flatMap(child => [...child.name === name ? [child] : [], ...child.all(name)]);
  }

  get options(): FakeElement[] {
    return this.all("option");
  }

  setAttribute(name: string, value: string): void {
    this.attributes.set(name, value);
  }

  append(...children: (FakeElement | string)[]): void {
    this._children.push(...children);
  }

  prepend(...children: (FakeElement | string)[]): void {
    this._children.unshift(...children);
  }

  replaceChildren(...children: (FakeElement | string)[]): void {
    this._children = children;
  }

  replaceWith(): void {}

  querySelector(name: string): FakeElement | undefined {
    return this.all(name)[0];
  }

  querySelectorAll(names: string): FakeElement[] {
    return names.split(", ").flatMap(name => this.all(name));
  }
}

class FakeOption extends FakeElement {
  constructor() {
    super("option");
  }
}

/** Gives a test a document of such elements, until it ends. */
export function setElements(): void {
  setGlobals({
    Option: FakeOption,
    document: {
      createElement: (name: string) => new FakeElement(name),
      createElementNS: (_: string, name: string) => new FakeElement(name),
    },
  });
}
