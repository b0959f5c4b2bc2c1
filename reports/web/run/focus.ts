// SPDX-License-Identifier: MIT
// Where the keyboard is: on the heading of what was opened, and after Back on the row it was opened from.

/** The link that led on from a view, by the view. */
const left = new Map<string, string>();

const view_of = (url: string) => (/#\/((?:bucket|finding)\/[^?]*)/.exec(url) ?? ["", ""])[1]!;
const lead_of = (element: Element | null | undefined) =>
  element?.getAttribute("data-leads") ?? element?.getAttribute("href");

/** To be told before the next view is drawn. */
export function leave(old_url: string, new_url: string) {
  const lead = lead_of(document.activeElement?.closest("[data-leads], a[href]"));
  if (lead && new_url.endsWith(lead)) left.set(view_of(old_url), lead);
}

/** Focuses what led on from the view that is shown; whether it is still there. */
function focus_lead(options: FocusOptions): boolean {
  const lead = left.get(view_of(location.hash));
  if (lead === undefined) return false;
  const all = document.querySelectorAll<HTMLElement>("main:not([hidden]) :is([data-leads], a[href])");
  const found = [...all].find((element) => lead_of(element) === lead);
  found?.focus(options);
  return found !== undefined;
}

const focus_heading = () => document.querySelector<HTMLElement>("main.detail h2")?.focus({ preventScroll: true });

/** `from_detail`: where one comes from; `scrolled`: where the overview was left. */
export function arrive(
  { parts, detail, again }: { parts: string[]; detail: boolean; again: boolean },
  from_detail: boolean,
  scrolled: number,
) {
  if (detail) {
    if (again && focus_lead({})) return;
    scrollTo(0, 0);
    focus_heading();
    return;
  }
  const [section = ""] = parts;
  const returns = from_detail && (again || section === "" || section === "findings");
  if (returns && (focus_lead({ preventScroll: true }) || scrolled > 0)) scrollTo(0, scrolled);
  else document.getElementById(section)?.scrollIntoView();
}

/** From the top of the page to its findings, or to what is told of one. */
export function skip(event: Event) {
  event.preventDefault();
  const to =
    document.querySelector<HTMLElement>("main.detail h2") ??
    document.querySelector<HTMLElement>("#findings tbody tr[tabindex='0']") ??
    document.getElementById("findings-title");
  to?.focus({ preventScroll: true });
  to?.scrollIntoView({ block: "center" });
}
