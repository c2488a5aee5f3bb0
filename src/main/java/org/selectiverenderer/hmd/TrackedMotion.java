package org.selectiverenderer.hmd;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
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
 * that the viewer looks its way.
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
    this.world = world;
    this.tracker = tracker;
    this.walking = walking;
    this.whenLost = whenLost;
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
