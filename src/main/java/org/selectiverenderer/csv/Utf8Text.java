package org.selectiverenderer.csv;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.selectiverenderer.x3d.Location;

/** Decodes a file that must be UTF-8, and says where it is not. */
final class Utf8Text {
  private Utf8Text() {}

  /** The text without its byte order mark; empty after a fault. */
  static Optional<String> decode(String file, byte[] bytes, CsvFaults faults) {
    if (bytes.length > 1
        && (bytes[0] == (byte) 0xff && bytes[1] == (byte) 0xfe
            || bytes[0] == (byte) 0xfe && bytes[1] == (byte) 0xff)) {
      faults.fault(new Location(file, 1, 1), "the file is not UTF-8 text but UTF-16");
      return Optional.empty();
    }
    ByteBuffer in = ByteBuffer.wrap(bytes);
    CharBuffer out = CharBuffer.allocate(bytes.length + 1);
    CoderResult result = StandardCharsets.UTF_8.newDecoder().decode(in, out, true);
    String text = out.flip().toString();
    if (result.isError()) {
      String before = text.replace("\r\n", "\n").replace('\r', '\n');
      int line = (int) before.chars().filter(c -> c == '\n').count() + 1;
      int column = before.length() - before.lastIndexOf('\n');
      faults.fault(
          new Location(file, line, column),
          String.format(
              "the file is not UTF-8 text (byte %02X; other programs call it \"ANSI\" or"
                  + " \"Windows\"; save it as UTF-8)",
              bytes[in.position()] & 0xff));
      return Optional.empty();
    }
    return Optional.of(text.startsWith("\uFEFF") ? text.substring(1) : text);
  }
}
