// SPDX-License-Identifier: MIT
// How strong the colour of a share is.
export type Heat = "empty" | "clean" | "bad" | "within" | "undecided";

/** 1 to 5: a share below 1e-4, from 1e-4, 1e-3, 1e-2, 1e-1 on. */
export const heatStep = (share: number) => Math.min(5, Math.max(1, Math.floor(Math.log10(share) + 1e-9) + 6));
