// The colour scale of maps side by side.
import { h } from "../dom";
import { plain } from "../numbers";
import { pixelRatio } from "../pixel_ratio";
import { FONT, INK, MUTED, surface } from "../theme";
import { HEIGHT, MARGIN } from "./panel";
import { ticks } from "./ticks";

export interface ColourBar {
  element: HTMLElement;
  /** Marks a value on it; null: none. */
  point(value: number | null): void;
}

export function colourBar(range: [number, number]): ColourBar {
  const canvas = h("canvas");
  const [width, height] = [66, HEIGHT];
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  const draw = (value: number | null) => {
    canvas.width = width * pixelRatio;
    canvas.height = height * pixelRatio;
    const ctx = canvas.getContext("2d")!;
    ctx.scale(pixelRatio, pixelRatio);
    const [left, right, top, bottom] = [4, 18, MARGIN.top, height - MARGIN.bottom];
    for (let y = top; y < bottom; y += 0.5) {
      ctx.fillStyle = surface((bottom - y) / (bottom - top));
      ctx.fillRect(left, y, right - left, 1);
    }
    ctx.strokeStyle = "#98a2b3";
    ctx.strokeRect(left, top, right - left, bottom - top);
    const py = (v: number) => bottom - ((v - range[0]) / (range[1] - range[0] || 1)) * (bottom - top);
    ctx.fillStyle = MUTED;
    ctx.font = `12px ${FONT}`;
    ctx.textBaseline = "middle";
    for (const tick of ticks(range[0], range[1], 6)) {
      ctx.beginPath();
      ctx.moveTo(right, py(tick));
      ctx.lineTo(right + 4, py(tick));
      ctx.stroke();
      ctx.fillText(plain(tick), right + 8, py(tick));
    }
    if (value === null) return;
    ctx.fillStyle = INK;
    ctx.beginPath();
    ctx.moveTo(left + 1, py(value));
    ctx.lineTo(left - 4, py(value) - 4);
    ctx.lineTo(left - 4, py(value) + 4);
    ctx.fill();
    ctx.strokeStyle = INK;
    ctx.lineWidth = 1.5;
    ctx.beginPath();
    ctx.moveTo(left, py(value));
    ctx.lineTo(right, py(value));
    ctx.stroke();
  };
  draw(null);
  return { element: h("div", "colour-bar", h("div", "chart-title"), canvas), point: draw };
}
