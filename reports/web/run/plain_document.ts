// SPDX-License-Identifier: MIT
// A document to draw plots in where there is no browser: as much of one as Observable Plot asks for, and its text as
// SVG.

const xhtml = "http://www.w3.org/1999/xhtml";

const escaped = (text: string) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");

class PlainNode {
  parentNode: PlainNode | null = null;
  childNodes: PlainNode[] = [];
  constructor(
    readonly ownerDocument: object,
    readonly namespaceURI: string | null,
    readonly nodeName: string,
    private text = "",
  ) {}
  attributes = new Map<string, string>();
  style = {}; // of the whole plot alone, whose own element is not kept

  get tagName() {
    return this.nodeName;
  }
  get children() {
    return this.childNodes.filter((n) => n.namespaceURI !== null);
  }
  get firstChild() {
    return this.childNodes[0] ?? null;
  }
  get nextSibling() {
    const all = this.parentNode?.childNodes ?? [];
    return all[all.indexOf(this) + 1] ?? null;
  }
  get textContent(): string {
    return this.text + this.childNodes.map((n) => n.textContent).join("");
  }
  set textContent(text: string) {
    this.childNodes = [];
    if (text !== "") this.append(text);
  }
  get outerHTML(): string {
    if (this.namespaceURI === null) return escaped(this.text);
    const attributes = [...this.attributes]
      .reverse()
      .map(([name, value]) => ` ${name}="${escaped(value).replaceAll('"', "&quot;")}"`);
    const head = `<${this.nodeName}${attributes.join("")}`;
    return this.childNodes.length === 0 ? `${head} />` : `${head}>${this.innerHTML}</${this.nodeName}>`;
  }
  get innerHTML(): string {
    return this.childNodes.map((n) => n.outerHTML).join("");
  }

  getAttribute(name: string) {
    return this.attributes.get(name) ?? null;
  }
  hasAttribute(name: string) {
    return this.attributes.has(name);
  }
  setAttribute(name: string, value: unknown) {
    this.attributes.set(name, String(value));
  }
  setAttributeNS(_: string, name: string, value: unknown) {
    this.setAttribute(name, value);
  }
  removeAttribute(name: string) {
    this.attributes.delete(name);
  }
  insertBefore(node: PlainNode, next: PlainNode | null) {
    node.remove();
    const at = next === null ? -1 : this.childNodes.indexOf(next);
    this.childNodes.splice(at < 0 ? this.childNodes.length : at, 0, node);
    node.parentNode = this;
    return node;
  }
  appendChild(node: PlainNode) {
    return this.insertBefore(node, null);
  }
  append(...nodes: (PlainNode | string)[]) {
    for (const n of nodes)
      this.appendChild(typeof n === "string" ? new PlainNode(this.ownerDocument, null, "#text", n) : n);
  }
  remove() {
    const all = this.parentNode?.childNodes;
    if (all) all.splice(all.indexOf(this), 1);
    this.parentNode = null;
  }
}

export function plainDocument(): Document {
  const document = {
    createElementNS: (namespace: string, name: string) => new PlainNode(document, namespace, name),
    createElement: (name: string) => new PlainNode(document, xhtml, name),
    createTextNode: (text: string) => new PlainNode(document, null, "#text", text),
    documentElement: null as unknown,
  };
  document.documentElement = document.createElement("html");
  return document as unknown as Document;
}
