// Numbers as text, and elements of the page.

const superscripts = { "-": "\u207b", 0: "\u2070", 1: "\u00b9", 2: "\u00b2", 3: "\u00b3", 4: "\u2074", 5: "\u2075", 6: "\u2076", 7: "\u2077", 8: "\u2078", 9: "\u2079" };

function powerOfTen(exponent) {
  return "10" + [...String(exponent)].map((sign) => superscripts[sign]).join("");
}

// `digits` significant digits; very large and very small numbers as powers of ten.
function shown(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "\u2013";
  if (value === 0) return "0";
  const exponent = Math.floor(Math.log10(Math.abs(value)));
  if (exponent >= 6 || exponent < -3) {
    const mantissa = Number((value / 10 ** exponent).toPrecision(digits));
    return (mantissa === 1 ? "" : String(mantissa).replace("-", "\u2212") + "\u00b7") + powerOfTen(exponent);
  }
  const rounded = Number.isInteger(value) ? value : Number(value.toPrecision(digits));
  return String(rounded).replace("-", "\u2212");
}

function percent(value) {
  return value === null || value === undefined ? "\u2013" : (100 * value).toFixed(2).replace("-", "\u2212") + " %";
}

// element("p", { class: "state" }, "text", child)
function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

// Rows of cells below a header. A cell is a text, or { text, kind } with the kind as its class.
function table(header, rows, kinds = []) {
  const cell = (tag, content, column) => {
    const kind = content && content.kind !== undefined ? content.kind : kinds[column] || "";
    return element(tag, kind ? { class: kind } : {}, content && content.text !== undefined ? content.text : content);
  };
  const made = element("table", {});
  if (header) made.append(element("thead", {}, element("tr", {}, ...header.map((text, column) => cell("th", text, column)))));
  made.append(element("tbody", {}, ...rows.map((row) => element("tr", {}, ...row.map((content, column) => cell("td", content, column))))));
  return made;
}

// A heading, a sentence, and a grid for figures; returns the grid.
function section(title, introduction) {
  const grid = element("div", { class: "grid" });
  document.getElementById("page").append(element("h2", {}, title), ...(introduction ? [element("p", { class: "introduction" }, introduction)] : []), grid);
  return grid;
}

// A figure with title, content and caption; `source` names file and columns.
function figure(grid, id, title, content, caption, source, wide) {
  const made = element("figure", wide ? { id, class: "wide" } : { id }, element("h3", {}, title), ...content,
    element("figcaption", {}, caption, element("span", { class: "source" }, "From ", element("code", {}, source))));
  grid.append(made);
  return made;
}

// What the address of the page asks for: figure (only this one), time [s] and show (a button) of its picture.
const asked = new URLSearchParams(window.location.search);

// The button that is pressed first in a figure.
function chosen(figure, names, otherwise) {
  return asked.get("figure") === figure && names.includes(asked.get("show")) ? asked.get("show") : otherwise;
}

// Leaves only the figure that is asked for.
function showOnly(id) {
  const wanted = id && document.getElementById(id);
  if (!wanted) return;
  document.body.classList.add("only");
  wanted.classList.add("wanted");
}
