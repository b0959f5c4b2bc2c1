// SPDX-License-Identifier: MIT
// The part of the address after '#': the section or view, and the filter of the findings.
import { useLayoutEffect, useState } from "preact/hooks";

/** "#/findings?library=fcl" has the parts ["findings"]. */
export interface Address {
  parts: string[];
  query: URLSearchParams;
  from: string | null; // the address before, if a link or the Back button led here
}

function readAddress(from: string | null): Address {
  const [path = "", query = ""] = location.hash.replace(/^#\/?/, "").split("?");
  const parts = path.split("/").map((part) => {
    try {
      return decodeURIComponent(part);
    } catch {
      return part;
    }
  });
  return { parts, query: new URLSearchParams(query), from };
}

/** The address, and what writes a filter into it without a step for the Back button. */
export function useAddress(): [Address, (query: string) => void] {
  const [address, set] = useState(() => readAddress(""));
  useLayoutEffect(() => {
    const changed = (event: HashChangeEvent) => set(readAddress(new URL(event.oldURL).hash));
    addEventListener("hashchange", changed);
    return () => removeEventListener("hashchange", changed);
  }, []);
  const remember = (query: string) => {
    try {
      history.replaceState(null, "", query === "" ? "#/findings" : `#/findings?${query}`);
    } catch {
      // Some browsers refuse after a hundred in half a minute: then the address is a little old.
    }
    set({ ...readAddress(null), query: new URLSearchParams(query) });
  };
  return [address, remember];
}
