package org.selectiverenderer.tracker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.tracker.TrackerOptions.Smoothing;
import org.selectiverenderer.tracker.TrackerOptions.Swap;
import org.selectiverenderer.tracker.emulator.EmulatedInterTrax2;
import org.selectiverenderer.tracker.emulator.HeadMotion;
import org.selectiverenderer.tracker.emulator.InterTrax2Emulator.Settings;
import org.selectiverenderer.tracker.emulator.PseudoTerminal.Maker;
import org.selectiverenderer.tracker.factory.TrackerFactory;
import org.selectiverenderer.tracker.pipeline.LiveTracker;
import org.selectiverenderer.tracker.pipeline.PoseSink;
import org.selectiverenderer.tracker.pipeline.PoseSource;

/**
 * What the virtual machine counts as allocated by a tracker's thread while records arrive. The
 * count is exact; what classes load and initialise with the first records is over by then.
 */
class AllocationTest {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private static final int WARM_UP = 300;
  private static final int RECORDS = 600;

  /** Fewer datagrams than the buffer of a socket holds. */
  private static final int BURST = 50;

  /** Less than half of Java's smallest object, 16 bytes, per record. */
  private static final long NONE_PER_RECORD = 8L * RECORDS;

  private static final TrackerOptions ALL =
      new TrackerOptions(
          Optional.of(new Swap(EulerAngle.PITCH, EulerAngle.ROLL)),
          Set.of(EulerAngle.YAW),
          Optional.of(Smoothing.DEFAULT),
          0.05);

  @TempDir Path folder;

  /** Asks on the tracker's thread itself, at the record where the steady state begins and ends. */
  private static final class Counting implements TrackerListener {
    private long records;
    private long before;
    private volatile long allocated = -1;
    private final RecordingTrackerListener watching = new RecordingTrackerListener();

    @Override
    public void sample(PoseSample sample) {
      records++;
      if (records == WARM_UP) {
        before = THREADS.getCurrentThreadAllocatedBytes();
      } else if (records == WARM_UP + RECORDS) {
        allocated = THREADS.getCurrentThreadAllocatedBytes() - before;
      }
    }

    @Override
    public void problem(Problem problem) {
      watching.problem(problem);
    }

    long allocated() {
      watching.until("the records", () -> allocated >= 0);
      return allocated;
    }
  }

  private final Counting counting = new Counting();

  @Test
  void theWayFromTheSourceToTheReaderAllocatesNothing() throws IOException {
    PoseSource source =
        new PoseSource() {
          @Override
          public void open() {}

          @Override
          public void read(PoseSink intake) {
            intake.connected();
            for (int i = 0; i < WARM_UP + RECORDS; i++) {
              intake.angles(System.nanoTime(), i % 360, 10, 20);
              intake.quaternion(System.nanoTime(), 0, 0.6, 0, 0.8);
              intake.angles(System.nanoTime(), Double.NaN, 0, 0);
              intake.tick();
            }
          }

          @Override
          public void close() {}
        };
    try (HeadTracker tracker =
        LiveTracker.open(new TrackerSpec.OpenTrack(1), source, ALL, counting)) {
      assertThat(counting.allocated()).isZero();
      assertThat(tracker.health().records()).isPositive();
    }
  }

  @Test
  void theSerialTrackerAllocatesNothingPerRecord() throws IOException {
    assumeTrue(Stream.of(Maker.values()).anyMatch(Maker::installed), "no socat, no script");
    try (EmulatedInterTrax2 device =
            EmulatedInterTrax2.start(
                folder.resolve("tracker"), new Settings(480, HeadMotion.LOOKING_ABOUT));
        HeadTracker tracker = open(new TrackerSpec.InterTrax2(device.link().toString()))) {
      assertThat(counting.allocated()).isLessThan(NONE_PER_RECORD);
      assertThat(tracker.health().bad()).isZero();
    }
  }

  @Test
  void opentrackAllocatesNothingPerRecord() throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      int port;
      try (DatagramSocket free = new DatagramSocket(0)) {
        port = free.getLocalPort();
      }
      byte[] bytes =
          ByteBuffer.allocate(48).order(ByteOrder.LITTLE_ENDIAN).putDouble(24, 30).array();
      try (HeadTracker tracker = open(new TrackerSpec.OpenTrack(port))) {
        counting.watching.until(
            "the records",
            () -> {
              // Many at a time: silence between records may allocate, which is not asked here.
              for (int i = 0; i < BURST; i++) {
                send(socket, new DatagramPacket(bytes, 48, InetAddress.getLoopbackAddress(), port));
              }
              return counting.allocated >= 0;
            });
        assertThat(counting.allocated()).isLessThan(NONE_PER_RECORD);
        assertThat(tracker.health().bad()).isZero();
      }
    }
  }

  @Test
  void linesOverTcpAllocateNothingPerRecord() throws IOException {
    byte[] line = "12.5 -3.25 0.125\n".getBytes(StandardCharsets.US_ASCII);
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"));
        HeadTracker tracker = open(new TrackerSpec.Tcp("127.0.0.1", server.getLocalPort()));
        Socket client = server.accept()) {
      OutputStream out = client.getOutputStream();
      for (int i = 0; i < WARM_UP + RECORDS; i++) {
        out.write(line);
      }
      assertThat(counting.allocated()).isLessThan(NONE_PER_RECORD);
      assertThat(tracker.health().bad()).isZero();
    }
  }

  @Test
  void readingThePoseAllocatesNothing() throws IOException {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"));
        HeadTracker tracker = open(new TrackerSpec.Tcp("127.0.0.1", server.getLocalPort()));
        Socket client = server.accept()) {
      client.getOutputStream().write("1 2 3\n".getBytes(StandardCharsets.US_ASCII));
      PoseSample pose = new PoseSample();
      Quaterniond orientation = new Quaterniond();
      LatencyHistogram latency = new LatencyHistogram();
      counting.watching.until("a record", () -> tracker.read(pose));
      pose.orientation(orientation);
      latency.record(1);
      THREADS.getCurrentThreadAllocatedBytes();
      long before = THREADS.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 1_000; i++) {
        tracker.read(pose);
        pose.orientation(orientation);
        latency.record(System.nanoTime() - pose.arrival());
      }
      // Half of Java's smallest object for each; the virtual machine itself may take some once.
      assertThat(THREADS.getCurrentThreadAllocatedBytes() - before).isLessThan(8 * 1_000);
    }
  }

  private HeadTracker open(TrackerSpec spec) throws IOException {
    return TrackerFactory.open(spec, ALL, counting);
  }

  private static void send(DatagramSocket socket, DatagramPacket packet) {
    try {
      socket.send(packet);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }
}
