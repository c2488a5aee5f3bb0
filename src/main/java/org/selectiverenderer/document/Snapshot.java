package org.selectiverenderer.document;

import java.util.function.Supplier;

/**
 * A document as it was at one moment; a value that any thread may read.
 *
 * @param name of the file
 * @param revision of the document then
 * @param text all characters
 * @param encoded gives the bytes that saving would write
 */
public record Snapshot(String name, long revision, String text, Supplier<byte[]> encoded) {
  /** The bytes that saving would write. */
  public byte[] bytes() {
    return encoded.get();
  }
}
