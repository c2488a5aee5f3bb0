package org.selectiverenderer.tracker.net;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.pose.Intake;
import org.selectiverenderer.tracker.pose.PoseSource;

/**
 * opentrack's "UDP over network" output: datagrams of six little-endian doubles, x, y, z in
 * centimetres (not used: the head's place comes from the mouse), then yaw, pitch, roll in degrees.
 * A datagram of another length is a bad record.
 */
public final class OpenTrackSource implements PoseSource {
  private static final int LENGTH = 6 * Double.BYTES;
  private static final int YAW = 3 * Double.BYTES;
  private static final int PITCH = 4 * Double.BYTES;
  private static final int ROLL = 5 * Double.BYTES;
  private static final Consumer<SelectionKey> READABLE = key -> {};

  private final int port;
  // One byte longer than a record, so that longer datagrams are noticed.
  private final ByteBuffer buffer =
      ByteBuffer.allocateDirect(LENGTH + 1).order(ByteOrder.LITTLE_ENDIAN);
  private @Nullable DatagramChannel channel;
  private @Nullable Selector selector;

  /**
   * @param port to listen on, on all interfaces
   */
  public OpenTrackSource(int port) {
    this.port = port;
  }

  @Override
  public void open() throws TrackerException {
    try {
      selector = Selector.open();
      channel = DatagramChannel.open();
      channel.bind(new InetSocketAddress(port));
      channel.configureBlocking(false);
      channel.register(selector, SelectionKey.OP_READ);
    } catch (IOException e) {
      close();
      throw new TrackerException(
          e instanceof BindException
              ? "the UDP port " + port + " is in use by another program, or may not be used"
              : "the UDP port " + port + " cannot be opened: " + e.getMessage(),
          e);
    }
  }

  @Override
  public void read(Intake intake) throws IOException {
    DatagramChannel from = channel;
    Selector wait = selector;
    if (from == null || wait == null) {
      throw new TrackerException("the UDP port " + port + " is not open");
    }
    intake.connected();
    while (!intake.closed()) {
      wait.select(READABLE, Intake.PATIENCE_MS);
      while (from.receive(buffer.clear()) != null) {
        record(intake);
        intake.tick();
      }
      intake.tick();
    }
  }

  private void record(Intake intake) {
    if (buffer.position() == LENGTH) {
      intake.angles(
          System.nanoTime(),
          buffer.getDouble(YAW),
          buffer.getDouble(PITCH),
          buffer.getDouble(ROLL));
    } else {
      intake.bad();
    }
  }

  @Override
  public void close() {
    Closing.quietly(channel);
    Closing.quietly(selector);
    channel = null;
    selector = null;
  }
}
