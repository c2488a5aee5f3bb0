package org.selectiverenderer.models.structure;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Checks that a PLY file has room for the elements that its header announces. */
final class PlyStructureCheck {
  /** The maximum length of a header in bytes; real ones have some hundred. */
  private static final int MAX_HEADER = 1 << 16;

  /** A number of so many digits fits a long. */
  private static final int MAX_DIGITS = 18;

  private static final String END = "end_header";

  private static final Map<String, String> PLURALS = Map.of("vertex", "vertices", "face", "faces");

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
    List<String> announced = new ArrayList<>();
    boolean fit = true;
    for (String line : text.substring(0, end).split("[\r\n]+")) {
      String[] words = line.strip().split("\\s+");
      if (words.length == 3 && words[0].equals("element") && words[2].matches("\\d+")) {
        announced.add(words[2] + " " + PLURALS.getOrDefault(words[1], "elements " + words[1]));
        // Each element takes a byte at least, and in text a line.
        fit &= words[2].length() <= MAX_DIGITS && Long.parseLong(words[2]) <= left;
      }
    }
    if (!fit) {
      throw new ModelStructureException(
          "the file announces %s, but only %d bytes follow; it is damaged or cut off"
              .formatted(String.join(", ", announced), left));
    }
  }
}
