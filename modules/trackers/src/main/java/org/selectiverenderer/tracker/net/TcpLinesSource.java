package org.selectiverenderer.tracker.net;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.pipeline.PoseSink;
import org.selectiverenderer.tracker.pipeline.PoseSource;
import org.selectiverenderer.tracker.text.AngleLineParser;
import org.selectiverenderer.tracker.text.LineSplitter;

/**
 * Reads lines of {@code yaw pitch roll} in degrees from a TCP server: the protocol of the thesis's
 * TcpClient (Fig 50). Lines of any other form are bad records.
 */
public final class TcpLinesSource implements PoseSource {
  private final String host;
  private final int port;
  private @Nullable Socket socket;

  public TcpLinesSource(String host, int port) {
    this.host = host;
    this.port = port;
  }

  @Override
  public void open() throws TrackerException {
    socket = TcpConnector.to(host, port);
  }

  @Override
  public void read(PoseSink intake) throws IOException {
    Socket from = socket;
    if (from == null) {
      throw new TrackerException("there is no connection to " + host);
    }
    intake.connected();
    InputStream stream = from.getInputStream();
    LineSplitter lines = new LineSplitter(new AngleLineParser(), true);
    byte[] bytes = new byte[4096];
    while (!intake.closed()) {
      int count = TcpConnector.read(stream, bytes);
      if (count < 0) {
        throw new TrackerException(host + " has closed the connection on port " + port);
      }
      lines.take(bytes, count, System.nanoTime(), intake);
      intake.tick();
    }
  }

  @Override
  public void close() {
    SocketCloser.quietly(socket);
    socket = null;
  }
}
