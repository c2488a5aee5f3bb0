package org.selectiverenderer.runtime.render.context;

import java.io.IOException;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.file.Path;
import java.time.Duration;

/**
 * Whether an X server of this machine answers. One that is being started has its socket before it
 * answers, and one that has been killed may leave it behind. JOGL looks for displays once and for
 * all, so this has to be known before it begins.
 */
final class XServer {
  private static final long PAUSE_MS = 50;
  private static final long ANSWER_MS = 1000;

  /** How a connection begins: little end first, version 11.0, no authorization (X protocol, 8). */
  private static final byte[] GREETING = {'l', 0, 11, 0, 0, 0, 0, 0, 0, 0, 0, 0};

  private XServer() {}

  /**
   * Waits until the server answers: whatever it says, it is there.
   *
   * @param patience after which it is given up; zero for one try
   */
  static boolean answers(Path socket, Duration patience) {
    long end = System.nanoTime() + patience.toNanos();
    while (!greets(socket)) {
      if (System.nanoTime() >= end) {
        return false;
      }
      try {
        Thread.sleep(PAUSE_MS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return false;
      }
    }
    return true;
  }

  private static boolean greets(Path socket) {
    try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket));
        Selector selector = Selector.open()) {
      channel.write(ByteBuffer.wrap(GREETING));
      channel.configureBlocking(false);
      channel.register(selector, SelectionKey.OP_READ);
      return selector.select(ANSWER_MS) > 0 && channel.read(ByteBuffer.allocate(1)) == 1;
    } catch (IOException e) {
      return false; // There is no socket, or nobody listens at it, or no longer.
    }
  }
}
