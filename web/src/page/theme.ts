import type { SettingsStore } from "./settings";

const systemIsDark = matchMedia("(prefers-color-scheme: dark)");

/** Sets the attribute data-theme of the document, and tells whether the page is dark. */
export function watchTheme(settings: SettingsStore, listener: (dark: boolean) => void): void {
  const apply = (): void => {
    const theme = settings.now.theme;
    const dark = theme === "system" ? systemIsDark.matches : theme === "dark";
    if (document.documentElement.dataset.theme === (dark ? "dark" : "light"))
      return;

    document.documentElement.dataset.theme = dark ? "dark" : "light";
    listener(dark);
  };
  systemIsDark.addEventListener("change", apply);
  settings.watch(apply);
}
