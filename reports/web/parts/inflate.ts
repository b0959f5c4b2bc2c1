// SPDX-License-Identifier: MIT
// What page_template.cpp compressed: zlib, in base64.
export function inflated(text: string): Response {
  const binary = atob(text),
    bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate")));
}
