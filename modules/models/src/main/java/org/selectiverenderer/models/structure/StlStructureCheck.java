package org.selectiverenderer.models.structure;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Checks that a binary STL file has the faces that it announces. */
final class StlStructureCheck {
  private static final int TITLE = 80;
  private static final int HEADER = TITLE + Integer.BYTES;

  /** Four vectors of three floats, and two bytes of attributes. */
  private static final int FACE = 50;

  private StlStructureCheck() {}

  static void check(InputStream in, long size) throws IOException, ModelStructureException {
    byte[] header = in.readNBytes(HEADER);
    if (header.length < HEADER
        || new String(header, 0, TITLE, StandardCharsets.ISO_8859_1).startsWith("solid")) {
      return; // text, or nothing
    }
    long faces =
        Integer.toUnsignedLong(
            ByteBuffer.wrap(header).order(ByteOrder.LITTLE_ENDIAN).getInt(TITLE));
    if (faces > (size - HEADER) / FACE) {
      throw new ModelStructureException(
          "the file announces %d faces, but has room for %d; it is damaged or cut off"
              .formatted(faces, (size - HEADER) / FACE));
    }
  }
}
