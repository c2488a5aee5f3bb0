package org.selectiverenderer.app.stream;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.lsl.LslOutlet;
import org.selectiverenderer.lsl.StreamInfo;
import org.selectiverenderer.lsl.StreamInfo.Channel;
import org.selectiverenderer.study.headlog.EyeSample;

/**
 * The LSL streams of an eye tracker: the direction of gaze, and the object looked at. Their outlets
 * open when the first scene begins in a headset that tracks the eyes, so that receivers see no
 * empty streams. The class is confined to the sending thread.
 */
final class EyeTrackingStreams {
  private final LslLibrary lsl;
  private final StreamInfo directions;
  private final StreamInfo objects;
  private final Consumer<String> problem;
  private @Nullable LslOutlet direction;
  private @Nullable LslOutlet object;
  private boolean refused;
  private @Nullable String looked;

  /**
   * The direction of gaze in a frame.
   *
   * @param head orientation of the head in world coordinates
   */
  record Eyes(Quaterniond head, EyeSample sample) {}

  /**
   * @param source the source of the streams, as in {@link StreamSender#open}
   * @param problem receives messages about data that cannot be sent
   */
  EyeTrackingStreams(LslLibrary lsl, String source, Consumer<String> problem) {
    this.lsl = lsl;
    this.problem = problem;
    directions =
        StreamInfo.sent(
            "SelectiveRenderer-Eyes",
            "Gaze",
            List.of(
                new Channel("Gaze_DirX", "", "DirectionX"),
                new Channel("Gaze_DirY", "", "DirectionY"),
                new Channel("Gaze_DirZ", "", "DirectionZ"),
                new Channel("Gaze_Yaw", "degrees", "Yaw"),
                new Channel("Gaze_Pitch", "degrees", "Pitch"),
                new Channel("Tracked", "", "Confidence")),
            false,
            StreamSender.id("eyes", source));
    objects =
        StreamInfo.sent(
            "SelectiveRenderer-EyeObject",
            "Gaze",
            List.of(new Channel("object", "", "Marker")),
            true,
            StreamSender.id("eye-object", source));
  }

  Set<String> sourceIds() {
    return Set.of(directions.sourceId(), objects.sourceId());
  }

  /** Reports that a scene begins in a headset that tracks the eyes. */
  void scene() {
    looked = null;
    opened();
  }

  /** Sends the direction of gaze, and the object looked at when it has changed. */
  void push(double time, Eyes eyes) {
    Optional<LslOutlet> to = opened();
    if (to.isEmpty()) {
      return;
    }
    EyeSample sample = eyes.sample();
    Vector3d way =
        new Quaterniond(eyes.head())
            .rotateY(Math.toRadians(sample.yaw()))
            .rotateX(Math.toRadians(sample.pitch()))
            .transform(new Vector3d(0, 0, -1));
    to.get()
        .push(
            time,
            new double[] {
              way.x, way.y, way.z, sample.yaw(), sample.pitch(), sample.tracked() ? 1 : 0
            });
    String now = sample.object().isEmpty() ? StreamSender.NOTHING : sample.object();
    LslOutlet named = object;
    if (named != null && !now.equals(looked)) {
      looked = now;
      named.push(time, now);
    }
  }

  private Optional<LslOutlet> opened() {
    if (direction == null && !refused) {
      try {
        direction = lsl.outlet(directions);
        object = lsl.outlet(objects);
      } catch (IOException e) {
        refused = true;
        problem.accept("the eye-tracking streams are not sent: " + e.getMessage());
      }
    }
    return Optional.ofNullable(direction);
  }

  void close() {
    if (direction != null) {
      direction.close();
    }
    if (object != null) {
      object.close();
    }
  }
}
