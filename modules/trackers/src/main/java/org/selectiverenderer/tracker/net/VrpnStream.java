package org.selectiverenderer.tracker.net;

import java.io.IOException;
import java.io.InputStream;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.pipeline.PoseSink;

/** Reads big-endian numbers from a connection, with short timeouts and without allocating. */
final class VrpnStream {
  private final InputStream from;
  private final PoseSink intake;
  private final byte[] bytes = new byte[1 << 16];
  private final ByteBuffer numbers = ByteBuffer.wrap(bytes).order(ByteOrder.BIG_ENDIAN);
  private int at;
  private int end;

  VrpnStream(InputStream from, PoseSink intake) {
    this.from = from;
    this.intake = intake;
  }

  /**
   * Waits until a number of bytes are available, or the tracker is being closed.
   *
   * @param count at most {@link #capacity}
   * @return false if the tracker is being closed
   * @throws TrackerException if the connection ended
   */
  boolean require(int count) throws IOException {
    while (!ready(count)) {
      if (intake.closed()) {
        return false;
      }
    }
    return true;
  }

  /** Returns whether a number of bytes are available; if not, waits once for a short time. */
  boolean ready(int count) throws IOException {
    if (end - at < count) {
      System.arraycopy(bytes, at, bytes, 0, end - at);
      end -= at;
      at = 0;
      end += receive();
      intake.tick();
    }
    return end - at >= count;
  }

  private int receive() throws IOException {
    try {
      int count = from.read(bytes, end, bytes.length - end);
      if (count < 0) {
        throw new TrackerException("the VRPN server has closed the connection");
      }
      return count;
    } catch (SocketTimeoutException e) {
      return 0; // Timeout; the caller decides whether to go on.
    }
  }

  /** Returns the maximum number of bytes that can be required at once. */
  int capacity() {
    return bytes.length;
  }

  int int32(int offset) {
    return numbers.getInt(at + offset);
  }

  double float64(int offset) {
    return numbers.getDouble(at + offset);
  }

  /** Returns a text of one byte per character. */
  String text(int offset, int length) {
    return new String(bytes, at + offset, length, StandardCharsets.ISO_8859_1);
  }

  /** Copies bytes and moves behind them; missing bytes are zeros. */
  byte[] bytes(int count) {
    byte[] copy = new byte[count];
    System.arraycopy(bytes, at, copy, 0, Math.min(count, end - at));
    at = Math.min(end, at + count);
    return copy;
  }

  /** Moves behind bytes that were required. */
  void skip(int count) {
    at += count;
  }
}
