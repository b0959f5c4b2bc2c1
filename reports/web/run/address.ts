// SPDX-License-Identifier: MIT
// The part of the address after '#': the section or view, and what the tables of findings show.
import { useLayoutEffect, useState } from "preact/hooks";
import { leave } from "./focus.ts";

/** "#/findings?method=fcl" has the parts ["findings"]. */
export interface Address {
  parts: string[];
  query: URLSearchParams;
  detail: boolean; // of one cause or finding
  again: boolean; // come back to, not followed a link to: an empty query is then no filter
}

function readAddress(): Address {
  const [path = "", query = ""] = location.hash.replace(/^#\/?/, "").split("?");
  const parts = path.split("/").map((part) => {
    try {
      return decodeURIComponent(part);
    } catch {
      return part;
    }
  });
  const detail = parts[0] === "bucket" || parts[0] === "finding";
  return { parts, query: new URLSearchParams(query), detail, again: history.state?.known === true };
}

export function useAddress() {
  const [address, set] = useState(readAddress);
  useLayoutEffect(() => {
    const changed = (event: HashChangeEvent) => {
      leave(event.oldURL, event.newURL);
      set(readAddress());
    };
    addEventListener("hashchange", changed);
    return () => removeEventListener("hashchange", changed);
  }, []);
  return address;
}

/** Writes into the address what is shown, without a step for the Back button. */
export function remember(query: string) {
  const path = location.hash.split("?")[0]!;
  const hash = query === "" ? path : `${path.length > 2 ? path : "#/findings"}?${query}`;
  try {
    history.replaceState({ known: true }, "", hash || undefined);
  } catch {
    // Some browsers refuse after a hundred in half a minute: then the address is a little old.
  }
}
