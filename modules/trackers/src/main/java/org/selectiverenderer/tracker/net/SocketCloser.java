package org.selectiverenderer.tracker.net;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import org.jspecify.annotations.Nullable;

/** Closes connections that are no longer needed. */
final class SocketCloser {
  private SocketCloser() {}

  /**
   * Closes a connection, if there is one.
   *
   * @throws UncheckedIOException if closing fails, which does not happen with sockets
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
