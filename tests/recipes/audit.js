// What bars readers from the page, one sentence each, and what the page holds: the body of a function.
// It opens all that can be unfolded first.
const faults = [];
const all = (selector) => Array.from(document.querySelectorAll(selector));
const brief = (element) => element.outerHTML.replace(/\s+/g, " ").slice(0, 90);
const demand = (holds, sentence) => { if (!holds) faults.push(sentence); };
const each = (selector, holds, what) =>
  all(selector).forEach((element) => demand(holds(element), `${what}: ${brief(element)}`));

for (const folded of all("details")) folded.open = true;

// --- completeness ---
const local = (address) => /^(file|data):/.test(address);
each("img", (image) => image.naturalWidth, "picture is missing");
each("[src], link", (element) => local(element.src || element.href), "is not here");
for (const one of performance.getEntriesByType("resource")) demand(local(one.name), `request to ${one.name}`);
each("a[href^='#']", (link) => document.getElementById(link.hash.slice(1)), "link leads nowhere");

// --- structure ---
demand(document.documentElement.lang, "no language");
demand(document.title, "no title");
for (const one of ["main", "body > header", "h1"]) demand(all(one).length === 1, `not one ${one}`);
const ids = all("[id]").map((element) => element.id);
demand(new Set(ids).size === ids.length, "an id twice");
let level = 0;
for (const heading of all("h1, h2, h3, h4, h5, h6")) {
  const own = Number(heading.tagName[1]);
  demand(own <= level + 1, `heading skips a level: ${brief(heading)}`);
  level = own;
}
const labelled = (element) =>
  element.getAttribute("aria-label") || document.getElementById(element.getAttribute("aria-labelledby"));
each("nav, section", labelled, "no label");
each("table", (table) => table.querySelector("thead th[scope=col]"), "no headers of columns");
each("th", (header) => header.scope, "no scope");

// --- words for what is seen ---
const named = (link) => (link.getAttribute("aria-label") || link.textContent).trim() ||
  Array.from(link.querySelectorAll("img")).some((image) => image.alt);
each("a", named, "link without a name");
each("img", (image) => image.hasAttribute("alt"), "no alternative text");
each("figure img", (image) => image.alt.length > 20, "alternative text says little");

// --- width ---
const limit = document.documentElement.clientWidth;
demand(document.documentElement.scrollWidth <= limit, "the page scrolls sideways");
each("h1, h2, h3, h4, p, li, pre, dd, th, td", (box) => box.scrollWidth <= box.clientWidth + 1, "text goes over its edge");
const short = (box) => box.textContent.length < 40 || !box.checkVisibility();
each("th, td", (cell) => short(cell) || cell.clientWidth >= 100, "too narrow for its text");
const scrolls = (element) => ["auto", "scroll"].some((way) =>
  [getComputedStyle(element).overflowX, getComputedStyle(element).overflowY].includes(way)) &&
  (element.scrollWidth > element.clientWidth || element.scrollHeight > element.clientHeight);
for (const element of all("body *")) {
  const reachable = element.tabIndex >= 0 || element.querySelector("a, summary, [tabindex]");
  demand(!scrolls(element) || reachable, `scrolls, but no key reaches it: ${brief(element)}`);
}

// --- contrast (WCAG 2.1, 1.4.3) ---
const channels = (colour) => colour.match(/[\d.]+/g).map(Number);
const linear = (part) => part <= 10.31475 ? part / 3294.6 : ((part / 255 + 0.055) / 1.055) ** 2.4;
const luminance = (colour) => {
  const [r, g, b] = channels(colour).map(linear);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const ground = (element) => {
  const colour = getComputedStyle(element).backgroundColor;
  return channels(colour)[3] === 0 && element.parentElement ? ground(element.parentElement) : colour;
};
const contrast = (element) => {
  const [dark, light] = [getComputedStyle(element).color, ground(element)].map(luminance).sort((a, b) => a - b);
  return (light + 0.05) / (dark + 0.05);
};
const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
while (texts.nextNode()) {
  const element = texts.currentNode.parentElement;
  if (!texts.currentNode.data.trim() || !element.checkVisibility()) continue;
  demand(contrast(element) >= 4.5, `contrast of ${contrast(element).toFixed(1)}: ${brief(element)}`);
}
return {
  faults,
  images: Array.from(document.images, (image) => image.src),
  files: all("[href], [src], [poster]").map((element) => element.href || element.src || element.poster),
  ground: ground(document.documentElement),
};
