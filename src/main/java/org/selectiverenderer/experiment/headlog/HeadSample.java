package org.selectiverenderer.experiment.headlog;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * One frame of a session.
 *
 * @param t seconds since the session began
 * @param x of the middle between the eyes, in the world and in the scene's unit of length
 * @param y likewise
 * @param z likewise
 * @param yaw degrees about Y, positive to the left; yaw, pitch and roll compose in this order
 * @param pitch degrees about X, positive up
 * @param roll degrees about Z, positive to the left shoulder
 * @param moved whether head or viewer moved since the frame before
 * @param object in the middle of the view, by the name that {@link SceneObjects} gives it; empty
 *     when there is none
 * @param distance of its surface, in the scene's unit; NaN when there is none
 * @param version the choice that its Switch shows, -1 when no Switch holds it
 * @param cone objects in a cone about the middle, the one that fills most of it first
 * @param schemas active ones
 * @param frameMs milliseconds from the step of the frame before to that of this one, pauses not
 *     counted
 * @param moment when it was shown to the participant, and whether it was
 * @param eyes where they look; null where nothing tracks them
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
   * A frame on the clocks of the machine, and whether the participant saw it.
   *
   * @param visible whether the picture was there: at least half as bright as it is, in a window
   *     that was drawn
   * @param wall date and time of the computer; null in logs that do not tell it
   * @param mono seconds of the computer's monotonic clock, which nobody sets and which goes on in
   *     pauses; NaN in logs that do not tell it
   */
  public record Moment(boolean visible, @Nullable Instant wall, double mono) {
    /** Of a log that says nothing of it: what was recorded was shown. */
    public static final Moment UNTOLD = new Moment(true, null, Double.NaN);
  }

  /** Whether the participant saw it. */
  public boolean visible() {
    return moment.visible;
  }

  public HeadSample {
    cone = List.copyOf(cone);
    schemas = List.copyOf(schemas);
  }

  /** The same with what the eyes do. */
  public HeadSample looking(@Nullable EyeSample looked) {
    return new HeadSample(
        t, x, y, z, yaw, pitch, roll, moved, object, distance, version, cone, schemas, frameMs,
        moment, looked);
  }
}
