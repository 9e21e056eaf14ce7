const TimeSteps = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 15_000, 30_000, 60_000, 120_000, 300_000, 600_000, 900_000, 1_800_000, 3_600_000];

/** The distance between marks on an axis of milliseconds, so that there are at most `most`. */
export function timeStep(span: number, most: number): number {
  const least = span / Math.max(1, most);
  return TimeSteps.find(step => step >= least) ?? Math.ceil(least / 3_600_000) * 3_600_000;
}

/** 1, 2 or 5 times a power of ten: the distance between marks of an axis with at most `most` of them. */
export function valueStep(span: number, most: number): number {
  const least = span / Math.max(1, most);
  if (!(least > 0) || !Number.isFinite(least))
    return 1;

  const power = 10 ** Math.floor(Math.log10(least));
  const factor = [1, 2, 5, 10].find(each => each * power >= least * (1 - 1e-9)) ?? 10;
  return factor * power;
}

/** Digits behind the point that marks with this distance need. */
export function decimalsOf(step: number): number {
  return Math.max(0, Math.min(6, -Math.floor(Math.log10(step) + 1e-9)));
}

/** A mark of a time axis: seconds, minutes or hours, with as many decimals as the step needs. */
export function timeMark(milliseconds: number, step: number): string {
  const decimals = step >= 1000 ? 0 : decimalsOf(step / 1000);
  const seconds = Math.round(milliseconds) / 1000;
  if (seconds < 60)
    return `${seconds.toFixed(decimals)} s`;

  return clock(milliseconds, decimals);
}

/** A time as 0:07.250, 12:45.000 or 1:02:03.000. */
export function clock(milliseconds: number, decimals = 3): string {
  const unit = 10 ** decimals;
  const total = Math.round(Math.max(0, milliseconds) / 1000 * unit);
  const whole = Math.floor(total / unit);
  const part = decimals > 0 ? `.${String(total % unit).padStart(decimals, "0")}` : "";
  const rest = `${String(whole % 60).padStart(2, "0")}${part}`;
  const minutes = Math.floor(whole / 60);
  return minutes < 60 ? `${minutes}:${rest}` : `${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, "0")}:${rest}`;
}
