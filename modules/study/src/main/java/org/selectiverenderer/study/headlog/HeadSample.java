package org.selectiverenderer.study.headlog;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A sample of a head log: the pose of the head, and the objects in view, in one frame.
 *
 * @param t seconds since the session began
 * @param x of the point midway between the eyes, in world coordinates and the scene's unit of
 *     length
 * @param y of that point
 * @param z of that point
 * @param yaw degrees about Y, positive to the left; yaw, pitch and roll compose in this order
 * @param pitch degrees about X, positive up
 * @param roll degrees about Z, positive to the left shoulder
 * @param moved whether head or viewer moved since the previous frame
 * @param object name of the object in the middle of the view; empty for none
 * @param distance to the object's surface along the line of sight, in the scene's unit; NaN for
 *     none
 * @param version whichChoice of the object's Switch; -1 if no Switch holds it
 * @param cone objects in a cone about the line of sight, the one that fills most of it first
 * @param schemas the active memory schemas
 * @param frameMs milliseconds from the step of the previous frame to that of this one, pauses not
 *     counted
 * @param moment when the frame was shown to the participant, and whether it was visible
 * @param eyes the gaze; null without an eye tracker
 */
public record HeadSample(
    double t,
    double x,
    double y,
    double z,
    double yaw,
    double pitch,
    double roll,
    boolean moved,
    String object,
    double distance,
    int version,
    List<String> cone,
    List<String> schemas,
    double frameMs,
    Moment moment,
    @Nullable EyeSample eyes) {

  /**
   * The time of a frame by the clocks of the computer, and whether the participant saw it.
   *
   * @param visible whether the picture was visible: at least half of its full brightness, in a
   *     window that was drawn
   * @param wall date and time; null in logs without it
   * @param mono seconds of the monotonic clock, which goes on in pauses; NaN in logs without it
   */
  public record Moment(boolean visible, @Nullable Instant wall, double mono) {
    /** Substitute for a log without these columns: every recorded frame counts as visible. */
    public static final Moment UNTOLD = new Moment(true, null, Double.NaN);
  }

  /** Returns whether the participant saw the frame. */
  public boolean visible() {
    return moment.visible;
  }

  public HeadSample {
    cone = List.copyOf(cone);
    schemas = List.copyOf(schemas);
  }

  /** Returns this sample as one whose frame the participant did not see. */
  HeadSample unseen() {
    return new HeadSample(
        t,
        x,
        y,
        z,
        yaw,
        pitch,
        roll,
        moved,
        object,
        distance,
        version,
        cone,
        schemas,
        frameMs,
        new Moment(false, moment.wall(), moment.mono()),
        eyes);
  }

  /** Returns this sample with another gaze. */
  public HeadSample looking(@Nullable EyeSample looked) {
    return new HeadSample(
        t, x, y, z, yaw, pitch, roll, moved, object, distance, version, cone, schemas, frameMs,
        moment, looked);
  }
}
