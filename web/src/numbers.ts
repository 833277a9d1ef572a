// How numbers are shown; nothing here enters a result.

export function plain(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(Math.max(digits - 2, 0)).split("e");
    return `${mantissa.replace(/\.?0+$/, "")}·10${superscript(Number(exponent))}`;
  }
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}

export function superscript(value: number): string {
  const digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  return (value < 0 ? "⁻" : "") + String(Math.abs(value)).replace(/\d/g, (d) => digits[Number(d)]);
}

/** "0.8140 ± 0.0008": the error to two digits when it starts with a one, else to one; the value to the same place. */
export function withError(value: number, se: number | null): string {
  if (se === null || !(se > 0)) return plain(value);
  const exponent = Math.floor(Math.log10(se));
  const leading = se / 10 ** exponent;
  const places = -exponent + (leading < 2 ? 1 : 0);
  if (places < 0 || places > 8) return `${plain(value)} ± ${plain(se, 2)}`;
  return `${value.toFixed(places)} ± ${se.toFixed(places)}`.replace(/-/g, "−");
}

/** "0.8140(8)": the error in units of the last digit. */
export function compact(value: number, se: number | null): string {
  const [shown, error] = withError(value, se).split(" ± ");
  return error ? `${shown}(${Number(error.replace(/[^\d]/g, ""))})` : shown;
}

const PREFIXES: [number, string][] = [
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
];

/** "17.35 mm": a quantity with a prefix of its unit. */
export function withUnit(value: number, unit: string): string {
  const [factor, prefix] = PREFIXES.find(([factor]) => value >= factor) ?? PREFIXES[PREFIXES.length - 1];
  return `${plain(value / factor)} ${prefix}${unit}`;
}
