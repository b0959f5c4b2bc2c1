// SPDX-License-Identifier: MIT
// Where the keyboard is: on the heading of what was opened, and after Back on the row it was opened from.

/** The link that led on from a view, by the view. */
const left = new Map<string, string>();

const viewOf = (url: string) => (/#\/((?:bucket|finding)\/[^?]*)/.exec(url) ?? ["", ""])[1]!;
const leadOf = (element: Element | null | undefined) =>
  element?.getAttribute("data-leads") ?? element?.getAttribute("href");

/** To be told before the next view is drawn. */
export function leave(oldUrl: string, newUrl: string) {
  const lead = leadOf(document.activeElement?.closest("[data-leads], a[href]"));
  if (lead && newUrl.endsWith(lead)) left.set(viewOf(oldUrl), lead);
}

/** Focuses what led on from the view that is shown; whether it is still there. */
function focusLead(options: FocusOptions): boolean {
  const lead = left.get(viewOf(location.hash));
  if (lead === undefined) return false;
  const all = document.querySelectorAll<HTMLElement>("main:not([hidden]) :is([data-leads], a[href])");
  const found = [...all].find((element) => leadOf(element) === lead);
  found?.focus(options);
  return found !== undefined;
}

const focusHeading = () => document.querySelector<HTMLElement>("main.detail h2")?.focus({ preventScroll: true });

/** `fromDetail`: where one comes from; `scrolled`: where the overview was left. */
export function arrive(
  { parts, detail, again }: { parts: string[]; detail: boolean; again: boolean },
  fromDetail: boolean,
  scrolled: number,
) {
  if (detail) {
    if (again && focusLead({})) return;
    scrollTo(0, 0);
    focusHeading();
    return;
  }
  const [section = ""] = parts;
  const returns = fromDetail && (again || section === "" || section === "findings");
  if (returns && (focusLead({ preventScroll: true }) || scrolled > 0)) scrollTo(0, scrolled);
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
