/** How the stage looks. Kept in the browser. */
export interface Settings {
  readonly look: "figure" | "sticks";
  readonly axes: boolean;
  readonly trails: boolean;
  readonly contacts: boolean;
  readonly names: boolean;
  readonly mirror: boolean;
  readonly follow: boolean;
  readonly theme: "system" | "dark" | "light";
  readonly panel: boolean;
}

const StorageName = "neuron-mocap-settings";

const Defaults: Settings = {
  look: "figure",
  axes: false,
  trails: false,
  contacts: true,
  names: true,
  mirror: false,
  follow: true,
  theme: "system",
  panel: matchMedia("(min-width: 60rem)").matches,
};

/** The settings, and who wants to know of changes. */
export class SettingsStore {
  private readonly _listeners: ((settings: Settings) => void)[] = [];
  private _now: Settings;

  constructor() {
    this._now = { ...Defaults, ...read() };
  }

  get now(): Settings {
    return this._now;
  }

  change(part: Partial<Settings>): void {
    this._now = { ...this._now, ...part };
    try {
      localStorage.setItem(StorageName, JSON.stringify(this._now));
    } catch {
      // A browser that keeps nothing shows the defaults next time.
    }

    for (const listener of this._listeners)
      listener(this._now);
  }

  toggle(name: "axes" | "trails" | "contacts" | "names" | "mirror" | "follow" | "panel"): void {
    this.change({ [name]: !this._now[name] });
  }

  /** Calls a function now and at each change. */
  watch(listener: (settings: Settings) => void): void {
    this._listeners.push(listener);
    listener(this._now);
  }
}

function read(): Partial<Settings> {
  try {
    const { panel, ...rest } = JSON.parse(localStorage.getItem(StorageName) ?? "{}") as Partial<Settings>;
    return Defaults.panel && panel !== undefined ? { ...rest, panel } : rest;
  } catch {
    return {};
  }
}
