package org.selectiverenderer.formats.csv;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.selectiverenderer.base.problem.SourceLocation;

/** Decodes a file that must be UTF-8, and reports the location of the first invalid byte. */
final class Utf8Decoder {
  /** Java decodes an invalid byte to this character; a valid file may also contain it. */
  private static final char REPLACEMENT = '\ufffd';

  private Utf8Decoder() {}

  /** Returns the text without its byte order mark; empty after an error. */
  static Optional<String> decode(String file, byte[] bytes, CsvErrorHandler faults) {
    if (bytes.length > 1
        && (bytes[0] == (byte) 0xff && bytes[1] == (byte) 0xfe
            || bytes[0] == (byte) 0xfe && bytes[1] == (byte) 0xff)) {
      faults.fault(new SourceLocation(file, 1, 1), "the file is UTF-16 text; save it as UTF-8");
      return Optional.empty();
    }
    for (byte each : bytes) {
      if (each == 0) {
        faults.fault(
            new SourceLocation(file, 1, 1),
            "the file is not UTF-8 text (it contains zero bytes, so it is UTF-16 or "
                + "not text); save it as UTF-8");
        return Optional.empty();
      }
    }
    String plain = new String(bytes, StandardCharsets.UTF_8);
    if (plain.indexOf(REPLACEMENT) >= 0) {
      ByteBuffer in = ByteBuffer.wrap(bytes);
      CharBuffer out = CharBuffer.allocate(bytes.length + 1);
      CoderResult result = StandardCharsets.UTF_8.newDecoder().decode(in, out, true);
      if (result.isError()) {
        fault(file, out.flip().toString(), bytes[in.position()], faults);
        return Optional.empty();
      }
    }
    return Optional.of(plain.startsWith("\uFEFF") ? plain.substring(1) : plain);
  }

  private static void fault(String file, String text, byte bad, CsvErrorHandler faults) {
    String before = text.replace("\r\n", "\n").replace('\r', '\n');
    int line = (int) before.chars().filter(c -> c == '\n').count() + 1;
    int column = before.length() - before.lastIndexOf('\n');
    faults.fault(
        new SourceLocation(file, line, column),
        String.format(
            "the file is not UTF-8 text (byte %02X; perhaps \"ANSI\" or"
                + " \"Windows\" text); save it as UTF-8",
            bad & 0xff));
  }
}
