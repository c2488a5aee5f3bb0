package org.selectiverenderer.tracker.net;

import java.io.IOException;
import java.io.InputStream;
import java.net.ConnectException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.pipeline.PoseSink;

/** Opens TCP connections with short timeouts. */
final class TcpConnector {
  /** Connection timeout in milliseconds, ample for a server on a laboratory's network. */
  private static final int CONNECT_MS = 1000;

  private TcpConnector() {}

  /**
   * Connects to a server.
   *
   * @throws TrackerException if there is no connection, with a message for the user
   */
  static Socket to(String host, int port) throws TrackerException {
    InetSocketAddress address = address(host, port);
    Socket socket = new Socket();
    try {
      socket.connect(address, CONNECT_MS);
      prepare(socket);
      return socket;
    } catch (IOException e) {
      SocketCloser.quietly(socket);
      throw new TrackerException(
          e instanceof ConnectException
              ? "nothing listens on port " + port + " of " + host + " (is the server running?)"
              : e instanceof SocketTimeoutException
                  ? host + " does not answer on port " + port
                  : "no connection to " + host + ", port " + port + ": " + e.getMessage(),
          e);
    }
  }

  /** Configures a socket for small records with low latency. */
  static void prepare(Socket socket) throws IOException {
    socket.setTcpNoDelay(true);
    socket.setSoTimeout(PoseSink.PATIENCE_MS);
  }

  /**
   * Looks up a host.
   *
   * @throws TrackerException if there is no host with this name
   */
  static InetSocketAddress address(String host, int port) throws TrackerException {
    InetSocketAddress address = new InetSocketAddress(host, port);
    if (address.isUnresolved()) {
      throw new TrackerException("there is no host " + host);
    }
    return address;
  }

  /**
   * Reads available bytes and returns their number: 0 after a timeout, -1 at the end of the stream.
   */
  static int read(InputStream stream, byte[] bytes) throws IOException {
    try {
      return stream.read(bytes);
    } catch (SocketTimeoutException e) {
      return 0;
    }
  }
}
