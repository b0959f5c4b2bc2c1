// SPDX-License-Identifier: MIT
// A document to draw plots in where there is no browser: as much of one as Observable Plot asks for, and its text as
// SVG.

export const escaped = (text: string) =>
  text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");

class PlainNode {
  parentNode: PlainNode | null = null;
  childNodes: PlainNode[] = [];
  attributes = new Map<string, string>();
  style = {}; // of the whole plot alone, whose own element is not kept
  /** A name of null is that of a text. */
  constructor(
    readonly ownerDocument: object,
    readonly namespaceURI: string | null,
    readonly tagName: string | null,
    private text = "",
  ) {}

  get children() {
    return this.childNodes.filter((n) => n.tagName !== null);
  }
  get firstChild() {
    return this.childNodes[0] ?? null;
  }
  get nextSibling() {
    const all = this.parentNode?.childNodes ?? [];
    return all[all.indexOf(this) + 1] ?? null;
  }
  set textContent(text: string) {
    this.childNodes = [];
    this.append(text);
  }
  get outerHTML(): string {
    if (this.tagName === null) return escaped(this.text);
    const attributes = [...this.attributes].map(([name, value]) => ` ${name}="${escaped(value)}"`);
    return `<${this.tagName}${attributes.join("")}>${this.innerHTML}</${this.tagName}>`;
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
    this.childNodes.splice(next === null ? this.childNodes.length : this.childNodes.indexOf(next), 0, node);
    node.parentNode = this;
    return node;
  }
  appendChild(node: PlainNode) {
    return this.insertBefore(node, null);
  }
  append(...nodes: (PlainNode | string)[]) {
    for (const n of nodes) this.appendChild(typeof n === "string" ? new PlainNode(this.ownerDocument, null, null, n) : n);
  }
  remove() {
    const all = this.parentNode?.childNodes;
    all?.splice(all.indexOf(this), 1);
  }
}

export function plainDocument(): Document {
  const document: Record<string, unknown> = {
    createElementNS: (namespace: string, name: string) => new PlainNode(document, namespace, name),
    createElement: (name: string) => new PlainNode(document, null, name),
    createTextNode: (text: string) => new PlainNode(document, null, null, text),
  };
  document.documentElement = new PlainNode(document, null, "html");
  return document as unknown as Document;
}
