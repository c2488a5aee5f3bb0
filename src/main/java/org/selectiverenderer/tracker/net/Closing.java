package org.selectiverenderer.tracker.net;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import org.jspecify.annotations.Nullable;

/** Lets go of connections that nothing more is expected of. */
final class Closing {
  private Closing() {}

  /**
   * Closes it, if it is there.
   *
   * @throws UncheckedIOException never seen of sockets: by then their data are given up
   */
  static void quietly(@Nullable Closeable connection) {
    if (connection == null) {
      return;
    }
    try {
      connection.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
