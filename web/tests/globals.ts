import { afterEach } from "node:test";

const before = new Map<string, PropertyDescriptor | undefined>();

// All files run in one process. A test must find the names as they were, whatever ran before it.
afterEach(() => {
  for (const [name, property] of before) {
    if (property)
      Object.defineProperty(globalThis, name, property);
    else
      Reflect.deleteProperty(globalThis, name);
  }

  before.clear();
});

/** Gives the browser's names to a test, until it ends. */
export function setGlobals(values: Record<string, unknown>): void {
  for (const [name, value] of Object.entries(values)) {
    if (!before.has(name))
      before.set(name, Object.getOwnPropertyDescriptor(globalThis, name));
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  }
}
