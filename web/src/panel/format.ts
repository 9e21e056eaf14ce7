/** A number with as many decimals as matter: 0.25, 3.1, 42, 1234. */
export function short(value: number): string {
  const size = Math.abs(value);
  return value.toFixed(size < 0.005 || size >= 9.95 ? 0 : size < 0.995 ? 2 : 1);
}

/** Milliseconds with their unit, or a dash. */
export function milliseconds(value: number | null | undefined): string {
  return value === null || value === undefined || !Number.isFinite(value) ? "–" : `${short(Math.max(0, value))} ms`;
}

/** Bytes in the largest unit in which they are at least 1. */
export function bytes(value: number): string {
  const units = ["B", "kB", "MB", "GB"];
  let unit = 0;
  while (value >= 999.5 && unit < units.length - 1) {
    value /= 1000;
    unit++;
  }

  return `${unit === 0 ? Math.round(value) : short(value)} ${units[unit]}`;
}

/** Seconds as 0:07, 12:45 or 1:02:03. */
export function duration(seconds: number): string {
  const whole = Math.max(0, Math.floor(seconds));
  const hours = Math.floor(whole / 3600);
  const minutes = Math.floor(whole / 60) % 60;
  const rest = String(whole % 60).padStart(2, "0");
  return hours > 0 ? `${hours}:${String(minutes).padStart(2, "0")}:${rest}` : `${minutes}:${rest}`;
}

/** A count with spaces between thousands. */
export function count(value: number): string {
  return String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, " ");
}
