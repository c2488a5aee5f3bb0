package org.selectiverenderer.tracker.net;

import java.io.IOException;
import java.net.BindException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.pipeline.PoseSink;
import org.selectiverenderer.tracker.pipeline.PoseSource;

/**
 * Reads opentrack's "UDP over network" output: datagrams of six little-endian doubles, x, y, z in
 * centimetres (to the right, up, away from the screen), then yaw, pitch, roll in degrees. A
 * datagram of another length is a bad record.
 */
public final class OpenTrackSource implements PoseSource {
  private static final int LENGTH = 6 * Double.BYTES;
  private static final double CENTIMETRES = 100;
  private static final int YAW = 3 * Double.BYTES;
  private static final int PITCH = 4 * Double.BYTES;
  private static final int ROLL = 5 * Double.BYTES;

  private final String host;
  private final int port;
  private @Nullable DatagramSocket socket;

  /**
   * @param host address of this machine to listen on, {@code *} for all; empty for the loopback
   */
  public OpenTrackSource(String host, int port) {
    this.host = host;
    this.port = port;
  }

  @Override
  public void open() throws TrackerException {
    try {
      socket = new DatagramSocket(address());
      socket.setSoTimeout(PoseSink.PATIENCE_MS);
    } catch (TrackerException e) {
      throw e;
    } catch (IOException e) {
      throw new TrackerException(
          e instanceof BindException
              ? "the UDP port "
                  + port
                  + " is in use by another program, or not permitted"
                  + (host.isEmpty() ? "" : ", or " + host + " is no address of this machine")
              : "the UDP port " + port + " cannot be opened: " + e.getMessage(),
          e);
    }
  }

  private InetSocketAddress address() throws TrackerException {
    if (host.equals("*")) {
      return new InetSocketAddress(port);
    }
    return host.isEmpty()
        ? new InetSocketAddress(InetAddress.getLoopbackAddress(), port)
        : TcpConnector.address(host, port);
  }

  @Override
  public void read(PoseSink intake) throws IOException {
    DatagramSocket from = socket;
    if (from == null) {
      throw new TrackerException("the UDP port " + port + " is not open");
    }
    intake.connected();
    // One byte longer than a record, so that longer datagrams are noticed.
    byte[] bytes = new byte[LENGTH + 1];
    ByteBuffer numbers = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    DatagramPacket packet = new DatagramPacket(bytes, bytes.length);
    while (!intake.closed()) {
      packet.setLength(bytes.length);
      if (arrived(from, packet)) {
        record(numbers, packet.getLength(), intake);
      }
      intake.tick();
    }
  }

  private static boolean arrived(DatagramSocket from, DatagramPacket packet) throws IOException {
    try {
      from.receive(packet);
      return true;
    } catch (SocketTimeoutException e) {
      return false; // Timeout; the caller decides whether to go on.
    }
  }

  private static void record(ByteBuffer numbers, int length, PoseSink intake) {
    if (length == LENGTH) {
      intake.place(
          numbers.getDouble(0) / CENTIMETRES,
          numbers.getDouble(Double.BYTES) / CENTIMETRES,
          numbers.getDouble(2 * Double.BYTES) / CENTIMETRES);
      intake.angles(
          System.nanoTime(),
          numbers.getDouble(YAW),
          numbers.getDouble(PITCH),
          numbers.getDouble(ROLL));
    } else {
      intake.bad();
    }
  }

  @Override
  public boolean placed() {
    return true;
  }

  @Override
  public void close() {
    if (socket != null) {
      socket.close();
      socket = null;
    }
  }
}
