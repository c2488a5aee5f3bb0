package org.selectiverenderer.models.structure;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

/** Checks that a PLY file has room for the elements that its header announces. */
final class PlyStructureCheck {
  /** The maximum length of a header in bytes; real ones have some hundred. */
  private static final int MAX_HEADER = 1 << 16;

  private static final String END = "end_header";

  private PlyStructureCheck() {}

  static void check(InputStream in, long size) throws IOException, ModelStructureException {
    String text = new String(in.readNBytes(MAX_HEADER), StandardCharsets.ISO_8859_1);
    int end = text.indexOf(END);
    if (end < 0) {
      if (text.startsWith("ply") && size > MAX_HEADER) {
        throw new ModelStructureException(
            "the header of the file does not end within %d bytes, which is the limit; it is not read"
                .formatted(MAX_HEADER));
      }
      return; // Its reader says that this is not PLY.
    }
    long left = size - end - END.length();
    for (String line : text.substring(0, end).split("[\r\n]+")) {
      String[] words = line.strip().split("\\s+");
      // Each element takes a byte at least, and in text a line.
      if (words.length == 3 && words[0].equals("element") && !fits(words[2], left)) {
        throw new ModelStructureException(
            "the file announces %s %ss, but only %d bytes follow; it is damaged or cut off"
                .formatted(words[2], words[1], left));
      }
    }
  }

  private static boolean fits(String count, long bytes) {
    return !count.matches("\\d+") || count.length() <= 18 && Long.parseLong(count) <= bytes;
  }
}
