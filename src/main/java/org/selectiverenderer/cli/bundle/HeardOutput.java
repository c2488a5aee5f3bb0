package org.selectiverenderer.cli.bundle;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/** Records the last characters that are written to another stream. The class is thread-safe. */
final class HeardOutput {
  private static final int KEPT = 4000;

  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

  /** Returns a stream that records its data and passes it on. */
  OutputStream before(OutputStream next) {
    return new OutputStream() {
      @Override
      public void write(int one) throws IOException {
        write(new byte[] {(byte) one}, 0, 1);
      }

      /** Records the data first, because the other stream may be a missing console. */
      @Override
      public void write(byte[] from, int offset, int length) throws IOException {
        hear(from, offset, length);
        next.write(from, offset, length);
      }

      @Override
      public void flush() throws IOException {
        next.flush();
      }
    };
  }

  private synchronized void hear(byte[] from, int offset, int length) {
    bytes.write(from, offset, length);
    if (bytes.size() > 2 * KEPT) {
      byte[] all = bytes.toByteArray();
      bytes.reset();
      bytes.write(all, all.length - KEPT, KEPT);
    }
  }

  /** Returns the recorded text; if there was more, it starts at the beginning of a line. */
  synchronized String text() {
    String all = bytes.toString(StandardCharsets.UTF_8);
    return all.length() <= KEPT ? all : all.substring(all.indexOf('\n', all.length() - KEPT) + 1);
  }
}
