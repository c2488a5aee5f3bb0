package org.selectiverenderer.app.stream;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.joml.Quaterniond;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.head.HeadSampleListener;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.lsl.LslOutlet;
import org.selectiverenderer.lsl.StreamInfo;
import org.selectiverenderer.lsl.StreamInfo.Channel;
import org.selectiverenderer.study.headlog.EyeSample;
import org.selectiverenderer.study.headlog.HeadLogMetadata;
import org.selectiverenderer.study.headlog.HeadSample;

/**
 * Sends poses, the object looked at, and events as LSL streams. Samples are queued with their own
 * timestamps without blocking, and sent by the thread {@code lsl-out}.
 */
final class StreamSender implements HeadSampleListener, AutoCloseable {
  /** The object name that is sent when nothing is in the middle of the view. */
  static final String NOTHING = "none";

  private static final int MOST_WAITING = 1 << 14;
  private static final long PAUSE = 100_000_000;

  /** The time for receivers to fetch the last samples before the streams close, in nanoseconds. */
  private static final long LINGER = 300_000_000;

  /** A queued sample with its time. */
  private sealed interface Item {
    long nanos();

    record Pose(long nanos, double[] values) implements Item {}

    record Look(long nanos, String object) implements Item {}

    /** The direction of gaze; empty when another scene begins. */
    record Eyes(long nanos, Optional<EyeTrackingStreams.Eyes> eyes) implements Item {}

    record Event(long nanos, String text) implements Item {}
  }

  private final LslLibrary lsl;
  private final LslOutlet poses;
  private final LslOutlet looks;
  private final LslOutlet events;
  private final EyeTrackingStreams eyes;
  private final Set<String> sourceIds;
  private final Consumer<String> problem;
  private final Queue<Item> queue = new ConcurrentLinkedQueue<>();
  private final AtomicInteger waiting = new AtomicInteger();
  private final AtomicLong lost = new AtomicLong();
  private final Thread thread = new Thread(this::work, "lsl-out");
  private final Quaterniond turn = new Quaterniond();
  private double metresPerUnit = 1;
  private @Nullable String looked;
  private volatile boolean closing;

  private StreamSender(
      LslLibrary lsl,
      List<LslOutlet> outlets,
      EyeTrackingStreams eyes,
      Set<String> sourceIds,
      Consumer<String> problem) {
    this.lsl = lsl;
    this.eyes = eyes;
    poses = outlets.get(0);
    looks = outlets.get(1);
    events = outlets.get(2);
    this.sourceIds = sourceIds;
    this.problem = problem;
  }

  /**
   * Opens the three outlets that are always present.
   *
   * @param source identifies the source, so that receivers recognise the streams after a crash
   * @param problem receives messages about data that cannot be sent
   * @throws IOException if the library refuses one
   */
  static StreamSender open(LslLibrary lsl, String source, Consumer<String> problem)
      throws IOException {
    List<StreamInfo> streams =
        List.of(
            StreamInfo.sent(
                "SelectiveRenderer-Pose", "MoCap", channels(), false, id("pose", source)),
            StreamInfo.sent(
                "SelectiveRenderer-Gaze",
                "Gaze",
                List.of(new Channel("object", "", "Marker")),
                true,
                id("gaze", source)),
            StreamInfo.sent(
                "SelectiveRenderer-Events",
                "Markers",
                List.of(new Channel("event", "", "Marker")),
                true,
                id("events", source)));
    List<LslOutlet> outlets = new ArrayList<>();
    try {
      for (StreamInfo stream : streams) {
        outlets.add(lsl.outlet(stream));
      }
    } catch (IOException e) {
      outlets.forEach(LslOutlet::close);
      throw e;
    }
    EyeTrackingStreams eyes = new EyeTrackingStreams(lsl, source, problem);
    Set<String> ids = new HashSet<>(eyes.sourceIds());
    streams.forEach(stream -> ids.add(stream.sourceId()));
    StreamSender sender = new StreamSender(lsl, outlets, eyes, Set.copyOf(ids), problem);
    sender.thread.start();
    return sender;
  }

  static String id(String stream, String source) {
    return "selective-renderer/" + stream + "/" + source;
  }

  /** Returns the channels with the names and types of the XDF specification for motion capture. */
  private static List<Channel> channels() {
    return List.of(
        new Channel("Head_PosX", "meters", "PositionX"),
        new Channel("Head_PosY", "meters", "PositionY"),
        new Channel("Head_PosZ", "meters", "PositionZ"),
        new Channel("Head_OriX", "quaternion", "OrientationX"),
        new Channel("Head_OriY", "quaternion", "OrientationY"),
        new Channel("Head_OriZ", "quaternion", "OrientationZ"),
        new Channel("Head_OriW", "quaternion", "OrientationW"),
        new Channel("SceneTime", "seconds", "Time"));
  }

  /** Returns the source ids by which a recorder recognises its own program's streams. */
  Set<String> sourceIds() {
    return sourceIds;
  }

  @Override
  public void scene(HeadLogMetadata description) {
    metresPerUnit = description.metresPerUnit();
    looked = null;
    if (description.eyes()) {
      add(new Item.Eyes(System.nanoTime(), Optional.empty()));
    }
  }

  @Override
  public void sampled(HeadSample sample, long nanos) {
    turn.rotationYXZ(
        Math.toRadians(sample.yaw()),
        Math.toRadians(sample.pitch()),
        Math.toRadians(sample.roll()));
    add(
        new Item.Pose(
            nanos,
            new double[] {
              sample.x() * metresPerUnit,
              sample.y() * metresPerUnit,
              sample.z() * metresPerUnit,
              turn.x,
              turn.y,
              turn.z,
              turn.w,
              sample.t()
            }));
    String object = sample.object().isEmpty() ? NOTHING : sample.object();
    if (!object.equals(looked)) {
      looked = object;
      add(new Item.Look(nanos, object));
    }
    EyeSample seen = sample.eyes();
    if (seen != null) {
      add(
          new Item.Eyes(
              nanos, Optional.of(new EyeTrackingStreams.Eyes(new Quaterniond(turn), seen))));
    }
  }

  /** Sends an event with the present time; may be called on any thread. */
  void event(String text) {
    add(new Item.Event(System.nanoTime(), text));
  }

  private void add(Item item) {
    if (waiting.get() >= MOST_WAITING) {
      lost.incrementAndGet();
      return;
    }
    waiting.incrementAndGet();
    queue.add(item);
    LockSupport.unpark(thread);
  }

  private void work() {
    while (true) {
      boolean last = closing; // What was added before closing is still sent.
      send();
      if (last) {
        break;
      }
      LockSupport.parkNanos(PAUSE);
    }
    long until = System.nanoTime() + LINGER;
    for (long left = LINGER; left > 0; left = until - System.nanoTime()) {
      LockSupport.parkNanos(left);
    }
    List.of(poses, looks, events).forEach(LslOutlet::close);
    eyes.close();
    if (lost.get() > 0) {
      problem.accept(
          "the Lab Streaming Layer was too slow: " + lost.get() + " samples were not sent");
    }
  }

  private void send() {
    // The two clocks may drift apart over hours, so they are compared each time.
    double offset = lsl.clock() - System.nanoTime() * 1e-9;
    for (Item item = queue.poll(); item != null; item = queue.poll()) {
      waiting.decrementAndGet();
      double time = item.nanos() * 1e-9 + offset;
      if (item instanceof Item.Pose pose) {
        poses.push(time, pose.values());
      } else if (item instanceof Item.Look look) {
        looks.push(time, look.object());
      } else if (item instanceof Item.Eyes seen) {
        seen.eyes().ifPresentOrElse(now -> eyes.push(time, now), eyes::scene);
      } else if (item instanceof Item.Event event) {
        events.push(time, event.text());
      }
    }
  }

  /** Sends the queued samples and closes the streams. */
  @Override
  public void close() {
    closing = true;
    LockSupport.unpark(thread);
    ThreadJoiner.join(thread);
  }
}
