// A quantity over two abscissae as coloured cells, drawn on a canvas.
import { plain } from "../numbers";
import { pixelRatio } from "../pixel_ratio";
import { FONT, INK, MUTED, surface } from "../theme";
import { ticks } from "./ticks";

export interface HeatMap {
  /** markup */
  title: string;
  xLabel: string;
  yLabel: string;
  /** what x and y are called in the read-out */
  xName: string;
  yName: string;
  x: number[];
  y: number[];
  /** row by row, a row of y per x; null: no value, and an empty cell */
  mean: (number | null)[];
  se: (number | null)[];
  /** ends of the colour scale */
  range: [number, number];
  /** a dashed line across */
  mark: number | null;
  /** per x, how many realisations were not relaxed */
  unrelaxed?: number[];
  /** a click on a cell */
  clicked: (x: number, y: number) => void;
  /** the value under the pointer, for the colour bar; null: none */
  pointed: (value: number | null) => void;
}

/** Where the map is cut: along x at values of y, or along y at values of x. */
export interface Cut {
  along: boolean;
  lines: { at: number; colour: string }[];
}

export const MARGIN = { left: 34, right: 14, top: 14, bottom: 26 };
export const HEIGHT = 250;

/** Borders of cells half way between their abscissae. */
function borders(at: number[]): number[] {
  if (at.length === 1) return [at[0] - 0.5, at[0] + 0.5];
  const inner = at.slice(1).map((v, k) => (v + at[k]) / 2);
  return [2 * at[0] - inner[0], ...inner, 2 * at[at.length - 1] - inner[inner.length - 1]];
}

export class Panel {
  private readonly xs: number[];
  private readonly ys: number[];
  width = 0;
  cut: Cut = { along: true, lines: [] };

  constructor(private readonly map: HeatMap) {
    this.xs = borders(map.x);
    this.ys = borders(map.y);
    // The grid starts at the first threshold, not half a step before it.
    if (map.y[0] === 0) this.ys[0] = 0;
  }

  px(x: number): number {
    const [low, high] = [this.xs[0], this.xs[this.xs.length - 1]];
    return MARGIN.left + ((x - low) / (high - low)) * (this.width - MARGIN.left - MARGIN.right);
  }
  py(y: number): number {
    const [low, high] = [this.ys[0], this.ys[this.ys.length - 1]];
    return HEIGHT - MARGIN.bottom - ((y - low) / (high - low)) * (HEIGHT - MARGIN.bottom - MARGIN.top);
  }

  /** Column and row under a point, or null. */
  cellAt(px: number, py: number): [number, number] | null {
    const i = this.map.x.findIndex((_, k) => px >= this.px(this.xs[k]) && px < this.px(this.xs[k + 1]));
    const j = this.map.y.findIndex((_, k) => py <= this.py(this.ys[k]) && py > this.py(this.ys[k + 1]));
    return i < 0 || j < 0 ? null : [i, j];
  }

  draw(canvas: HTMLCanvasElement, pointed: [number, number] | null): void {
    const { map } = this;
    canvas.width = Math.round(this.width * pixelRatio);
    canvas.height = HEIGHT * pixelRatio;
    const ctx = canvas.getContext("2d")!;
    ctx.scale(pixelRatio, pixelRatio);
    const [left, right, top, bottom] = [MARGIN.left, this.width - MARGIN.right, MARGIN.top, HEIGHT - MARGIN.bottom];
    ctx.fillStyle = "#fff";
    ctx.fillRect(0, 0, this.width, HEIGHT);
    this.hatch(ctx, left, top, right, bottom);

    const scale = map.range[1] - map.range[0] || 1;
    const snap = (v: number) => Math.round(v * pixelRatio) / pixelRatio; // no seams between cells
    map.x.forEach((_, i) =>
      map.y.forEach((_, j) => {
        const value = map.mean[i * map.y.length + j];
        if (value === null) return;
        const [x0, x1] = [snap(this.px(this.xs[i])), snap(this.px(this.xs[i + 1]))];
        const [y0, y1] = [snap(this.py(this.ys[j])), snap(this.py(this.ys[j + 1]))];
        ctx.fillStyle = surface((value - map.range[0]) / scale);
        ctx.fillRect(x0, y1, x1 - x0, y0 - y1);
      }),
    );

    ctx.strokeStyle = "#98a2b3";
    ctx.lineWidth = 1;
    ctx.strokeRect(left, top, right - left, bottom - top);
    this.axes(ctx, left, bottom);
    this.marks(ctx, top, bottom);
    this.cuts(ctx, right, bottom);
    if (pointed) {
      const [i, j] = pointed;
      ctx.strokeStyle = "#fff";
      ctx.lineWidth = 3;
      const box = [this.px(this.xs[i]), this.py(this.ys[j + 1]), this.px(this.xs[i + 1]) - this.px(this.xs[i]), this.py(this.ys[j]) - this.py(this.ys[j + 1])] as const;
      ctx.strokeRect(...box);
      ctx.strokeStyle = INK;
      ctx.lineWidth = 1.2;
      ctx.strokeRect(...box);
    }
  }

  /** Under the cells: what stays visible has no value. */
  private hatch(ctx: CanvasRenderingContext2D, left: number, top: number, right: number, bottom: number): void {
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, right - left, bottom - top);
    ctx.clip();
    ctx.strokeStyle = "#e1e6ed";
    ctx.lineWidth = 1;
    ctx.beginPath();
    for (let x = left - (bottom - top); x < right; x += 7) {
      ctx.moveTo(x, bottom);
      ctx.lineTo(x + bottom - top, top);
    }
    ctx.stroke();
    ctx.restore();
  }

  private axes(ctx: CanvasRenderingContext2D, left: number, bottom: number): void {
    ctx.fillStyle = MUTED;
    ctx.strokeStyle = "#98a2b3";
    ctx.font = `12px ${FONT}`;
    ctx.textAlign = "center";
    ctx.textBaseline = "top";
    for (const x of ticks(this.xs[0], this.xs[this.xs.length - 1], Math.max(Math.floor(this.width / 60), 2))) {
      ctx.fillText(plain(x), this.px(x), bottom + 10);
      ctx.beginPath();
      ctx.moveTo(this.px(x), bottom);
      ctx.lineTo(this.px(x), bottom + 5);
      ctx.stroke();
    }
    ctx.textAlign = "right";
    ctx.textBaseline = "middle";
    for (const y of ticks(this.ys[0], this.ys[this.ys.length - 1], 6)) {
      ctx.fillText(plain(y), left - 8, this.py(y));
      ctx.beginPath();
      ctx.moveTo(left - 5, this.py(y));
      ctx.lineTo(left, this.py(y));
      ctx.stroke();
    }
  }

  /** A small triangle at the border for each cut, in the colour of its curve. */
  private cuts(ctx: CanvasRenderingContext2D, right: number, bottom: number): void {
    for (const { at, colour } of this.cut.lines) {
      const [x, y] = this.cut.along ? [right + 1, this.py(at)] : [this.px(at), bottom + 1];
      ctx.fillStyle = colour;
      ctx.beginPath();
      ctx.moveTo(x, y);
      ctx.lineTo(this.cut.along ? x + 7 : x - 4, this.cut.along ? y - 4 : y + 7);
      ctx.lineTo(this.cut.along ? x + 7 : x + 4, this.cut.along ? y + 4 : y + 7);
      ctx.fill();
    }
  }

  private marks(ctx: CanvasRenderingContext2D, top: number, bottom: number): void {
    const { mark, unrelaxed } = this.map;
    if (mark !== null && mark > this.xs[0] && mark < this.xs[this.xs.length - 1]) {
      for (const [colour, width] of [["rgba(255,255,255,0.85)", 3], [INK, 1.3]] as const) {
        ctx.strokeStyle = colour;
        ctx.lineWidth = width;
        ctx.setLineDash(width > 2 ? [] : [5, 4]);
        ctx.beginPath();
        ctx.moveTo(this.px(mark), top);
        ctx.lineTo(this.px(mark), bottom);
        ctx.stroke();
      }
      ctx.setLineDash([]);
    }
    unrelaxed?.forEach((count, i) => {
      if (!count) return;
      ctx.beginPath();
      ctx.arc(this.px(this.map.x[i]), top - 7, 3.2, 0, 2 * Math.PI);
      ctx.strokeStyle = MUTED;
      ctx.lineWidth = 1.4;
      ctx.stroke();
    });
  }
}
