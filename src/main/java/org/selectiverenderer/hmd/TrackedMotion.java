package org.selectiverenderer.hmd;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.viewer.Heading;
import org.selectiverenderer.runtime.viewer.NavigationFrame;
import org.selectiverenderer.runtime.viewer.Viewer;
import org.selectiverenderer.runtime.viewer.ViewerMotion;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;

/**
 * The viewer under a head tracker, on a chair that the mouse moves (thesis 4.3 and 6.1.1): the
 * tracker turns the head, whatever else moves the viewer moves and turns the chair. The head's yaw
 * 0 looks where the chair looks, at first where the viewpoint looks. Walking follows the way the
 * head looks. When another viewpoint is bound, or the bound one turns, the chair turns with it so
 * that the viewer looks its way. Where the tracker tells the head's place too, the head is beside
 * and above its body by that ({@link HeadPlace}).
 *
 * <p>Takes the newest pose when it is asked to move, which is just before the frame is drawn. Makes
 * the same frames of the same poses. Belongs to the thread that steps the world.
 */
public final class TrackedMotion implements ViewerMotion {
  /** What turns the view while the tracker is silent or lost. */
  public enum WhenLost {
    /** Nothing: it stays as it is. */
    FREEZE,
    /** The mouse. */
    MOUSE
  }

  private final World world;
  private final HeadTracker tracker;
  private final ViewerMotion walking;
  private final WhenLost whenLost;
  private final @Nullable HeadPlace place;
  private final PoseSample sample = new PoseSample();
  private final Quaterniond head = new Quaterniond();
  private double chair;
  private double lastHeading = Double.NaN;
  private boolean steering;
  private boolean fresh;

  /**
   * @param walking moves the viewer, and turns it by mouse and keys
   */
  public TrackedMotion(World world, HeadTracker tracker, ViewerMotion walking, WhenLost whenLost) {
    this(world, tracker, walking, whenLost, HeadSettings.TURNED, null);
  }

  /**
   * With the place of the head.
   *
   * @param walking moves the body, and turns it by mouse and keys
   * @param body that follows the head; null for one that does not
   */
  public TrackedMotion(
      World world,
      HeadTracker tracker,
      ViewerMotion walking,
      WhenLost whenLost,
      HeadSettings settings,
      @Nullable FollowingBody body) {
    this.world = world;
    this.tracker = tracker;
    this.walking = walking;
    this.whenLost = whenLost;
    place = settings.placed() ? new HeadPlace(world, settings, body) : null;
  }

  /** Whether the tracker turns the view, or kept it where it was, in the frame last moved. */
  public boolean steering() {
    return steering;
  }

  /** Whether the frame last moved used a record that no frame before it had used. */
  public boolean fresh() {
    return fresh;
  }

  /** The pose last read; good until the next move. */
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
    return Heading.of(upright.conjugate(new Quaterniond()).mul(viewer.orientation())).yaw();
  }

  /** Which way is up, as the walker takes it. */
  private Quaterniondc upright() {
    return world
        .bindables()
        .bound("Viewpoint")
        .map(viewpoint -> NavigationFrame.of(world.views().placeOf(viewpoint)).upright())
        .orElse(NavigationFrame.WORLD.upright());
  }
}
