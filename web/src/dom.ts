// The few helpers that build the page.

type Child = Node | string | null | undefined;

/** An element with class and children; strings become text, never markup. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  className = "",
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  if (className) element.className = className;
  for (const child of children) if (child != null) element.append(child);
  return element;
}

/** Markup written in this program (symbols with sub- and superscripts); text from data goes through escape(). */
export function markup(html: string, tag: "span" | "p" | "div" | "th" = "span", className = ""): HTMLElement {
  const element = h(tag, className);
  element.innerHTML = html;
  return element;
}

/** A symbol with an upper and a lower index, one above the other. */
export function indexed(symbol: string, upper: string, lower: string): string {
  return `<i>${symbol}</i><span class="indices"><span>${upper}</span><span>${lower}</span></span>`;
}

export function escape(text: string): string {
  return text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
}

export function table(className: string, head: string[], rows: string[][]): HTMLElement {
  const row = (cells: string[], tag: string) => `<tr>${cells.map((c) => `<${tag}>${c}</${tag}>`).join("")}</tr>`;
  return h("div", "scroll", markupTable(className, row(head, "th"), rows.map((r) => row(r, "td")).join("")));
}

/** A table whose cells are text or nodes; the head is markup. */
export function tableOf(className: string, head: string[], rows: (string | Node)[][]): HTMLElement {
  const top = h("tr", "", ...head.map((html) => markup(html, "th")));
  const body = rows.map((cells) => h("tr", "", ...cells.map((cell) => h("td", "", cell))));
  return h("div", "scroll", h("table", className, h("thead", "", top), h("tbody", "", ...body)));
}

function markupTable(className: string, head: string, body: string): HTMLElement {
  const element = h("table", className);
  element.innerHTML = `<thead>${head}</thead><tbody>${body}</tbody>`;
  return element;
}

let figures = 0;

export interface Caption {
  /** how to read it: one or two sentences */
  text: string;
  formula?: string;
  source?: string;
}

/** A card with a numbered caption. */
export function figure(title: string, body: Node[], caption: Caption, className = ""): HTMLElement {
  const number = `<b>Figure ${++figures}.</b> `;
  const formula = caption.formula ? `<span class="formula">${caption.formula}</span>` : "";
  const source = caption.source ? `<span class="source">${caption.source}</span>` : "";
  const foot = h("figcaption");
  foot.innerHTML = `<p>${number}${caption.text}</p>${formula || source ? `<p class="fine">${formula}${source}</p>` : ""}`;
  const element = h("figure", `card ${className}`);
  if (title) element.append(markup(title, "div", "figure-title"));
  element.append(...body, foot);
  return element;
}
