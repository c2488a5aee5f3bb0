package org.selectiverenderer.render.context;

import java.io.IOException;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;

/**
 * Tests whether a local X server answers. A server that is being started has its socket before it
 * answers, and one that was killed may leave its socket behind. JOGL looks for displays only once,
 * so this must be known before JOGL is loaded.
 */
final class XServerProbe {
  private static final long PAUSE_MS = 50;
  private static final long ANSWER_MS = 1000;

  private static final Path SOCKETS = Path.of("/proc/net/unix");
  private static final int COLUMNS = 8;
  private static final int FLAGS = 3;
  private static final int PATH = 7;

  /** The flag of sockets that accept connections. */
  private static final String ACCEPTS = "00010000";

  /**
   * The first message of a connection: little-endian, version 11.0, no authorization (X protocol,
   * 8).
   */
  private static final byte[] GREETING = {'l', 0, 11, 0, 0, 0, 0, 0, 0, 0, 0, 0};

  private XServerProbe() {}

  /**
   * Waits until the server answers; any answer counts.
   *
   * @param patience the time after which to give up; zero for one attempt
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

  /**
   * Returns whether a process listens at the socket, from the list of Linux (proc(5), {@code
   * /proc/net/unix}). This is quicker than to connect, for which Java needs some 40 ms the first
   * time. A later connection then waits for the answer of a server that is being started.
   *
   * @return whether a process listens; false where there is no such list
   */
  static boolean listens(Path socket) {
    try {
      return listens(Files.readAllLines(SOCKETS), socket.toString());
    } catch (IOException e) {
      return false; // Not Linux, or not readable: connecting decides.
    }
  }

  static boolean listens(List<String> sockets, String path) {
    for (String line : sockets) {
      String[] columns = line.trim().split(" +", COLUMNS);
      if (columns.length == COLUMNS
          && columns[FLAGS].equals(ACCEPTS)
          && (columns[PATH].equals(path) || columns[PATH].equals("@" + path))) {
        return true;
      }
    }
    return false;
  }

  private static boolean greets(Path socket) {
    try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket));
        Selector selector = Selector.open()) {
      channel.write(ByteBuffer.wrap(GREETING));
      channel.configureBlocking(false);
      channel.register(selector, SelectionKey.OP_READ);
      return selector.select(ANSWER_MS) > 0 && channel.read(ByteBuffer.allocate(1)) == 1;
    } catch (IOException e) {
      return false; // No socket, or no process listens at it.
    }
  }
}
