package org.selectiverenderer.cli.bundle;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/** Keeps the end of what is written to another stream. For any thread. */
final class HeardOutput {
  private static final int KEPT = 4000;

  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

  /** A stream that is heard and passes on what it takes. */
  OutputStream before(OutputStream next) {
    return new OutputStream() {
      @Override
      public void write(int one) throws IOException {
        write(new byte[] {(byte) one}, 0, 1);
      }

      /** Heard first: the other one may be a console that is not there. */
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

  /** The end of it, in whole lines if there was more. */
  synchronized String text() {
    String all = bytes.toString(StandardCharsets.UTF_8);
    return all.length() <= KEPT ? all : all.substring(all.indexOf('\n', all.length() - KEPT) + 1);
  }
}
