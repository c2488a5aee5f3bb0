package org.selectiverenderer.hmd;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.browser.viewer.ViewpointFrame;
import org.selectiverenderer.browser.viewer.YawPitch;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;

/**
 * Moves the viewer by a head tracker and by navigation, as if on a chair that the mouse moves
 * (thesis 4.3 and 6.1.1): the tracker turns the head, and all other input moves and turns the
 * chair. At yaw 0 the head looks in the direction of the chair, which is at first that of the
 * viewpoint. Walking goes in the direction of the head. When another viewpoint is bound, or the
 * bound one turns, the chair turns with it. Where the tracker measures the head's position too, the
 * head is displaced from its body accordingly ({@link HeadPositionMapper}).
 *
 * <p>It reads the newest pose when it is asked to move, which is just before the frame is drawn.
 * The same poses give the same frames. Belongs to the thread that steps the world.
 */
public final class HeadTrackedMotion implements ViewerMotion {
  /** The source of the view's orientation while the tracker sends no data. */
  public enum WhenLost {
    /** Nothing: the view stays as it is. */
    FREEZE,
    /** The mouse. */
    MOUSE
  }

  private final World world;
  private final HeadTracker tracker;
  private final ViewerMotion walking;
  private final WhenLost whenLost;
  private final @Nullable HeadPositionMapper place;
  private final PoseSample sample = new PoseSample();
  private final Quaterniond head = new Quaterniond();
  private double chair;
  private double lastHeading = Double.NaN;
  private boolean steering;
  private boolean fresh;

  /**
   * @param walking moves the viewer, and turns it by mouse and keys
   */
  public HeadTrackedMotion(
      World world, HeadTracker tracker, ViewerMotion walking, WhenLost whenLost) {
    this(world, tracker, walking, whenLost, HeadTrackingOptions.TURNED, null);
  }

  /**
   * Makes a motion with the position of the head.
   *
   * @param walking moves the body, and turns it by mouse and keys
   * @param body the body that follows the head; null if none does
   */
  public HeadTrackedMotion(
      World world,
      HeadTracker tracker,
      ViewerMotion walking,
      WhenLost whenLost,
      HeadTrackingOptions settings,
      @Nullable HeadTrackedCollision body) {
    this.world = world;
    this.tracker = tracker;
    this.walking = walking;
    this.whenLost = whenLost;
    place = settings.placed() ? new HeadPositionMapper(world, settings, body) : null;
  }

  /**
   * Returns whether the tracker determined the view in the last frame, by a new or its last pose.
   */
  public boolean steering() {
    return steering;
  }

  /** Returns whether the last frame used a tracker record that no frame before had used. */
  public boolean fresh() {
    return fresh;
  }

  /** Returns the pose last read; valid until the next move. */
  public PoseSample sample() {
    return sample;
  }

  @Override
  public void move(Viewer viewer, double time, double dt) {
    long before = sample.number();
    boolean known = tracker.read(sample);
    fresh = known && sample.number() != before;
    steering = known && !(whenLost == WhenLost.MOUSE && tracker.health().stale());
    Quaterniondc upright = upright();
    if (place != null) {
      place.leave(viewer);
    }
    double heading = heading(viewer, upright);
    chair += Double.isNaN(lastHeading) ? heading : heading - lastHeading;
    if (steering) {
      sample.orientation(head);
      turn(viewer, upright);
      heading = heading(viewer, upright);
    }
    walking.move(viewer, time, dt);
    chair += heading(viewer, upright) - heading;
    if (steering) {
      turn(viewer, upright);
      if (place != null && sample.placed()) {
        place.enter(viewer, sample, chair, upright);
      }
    }
    lastHeading = heading(viewer, upright);
  }

  private void turn(Viewer viewer, Quaterniondc upright) {
    viewer.turnTo(upright.mul(new Quaterniond().rotationY(chair), new Quaterniond()).mul(head));
  }

  private static double heading(Viewer viewer, Quaterniondc upright) {
    return YawPitch.of(upright.conjugate(new Quaterniond()).mul(viewer.orientation())).yaw();
  }

  /** Returns the upright frame of the walking viewer, which defines the up direction. */
  private Quaterniondc upright() {
    return world
        .bindables()
        .bound("Viewpoint")
        .map(viewpoint -> ViewpointFrame.of(world.views().placeOf(viewpoint)).upright())
        .orElse(ViewpointFrame.WORLD.upright());
  }
}
