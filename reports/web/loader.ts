// SPDX-License-Identifier: MIT
// Starts the program of a page, which page_template.cpp compressed. The policy of the page allows this text and the
// program's, by their hashes, and no other.
import { inflated } from "./parts/inflate.ts";

const packed = document.getElementById("program")!;
if (packed.hasAttribute("type"))
  void inflated(packed.textContent ?? "")
    .text()
    .then((text) => {
      const script = document.createElement("script");
      script.textContent = text;
      packed.replaceWith(script);
    });
