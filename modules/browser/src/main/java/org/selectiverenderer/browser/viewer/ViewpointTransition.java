package org.selectiverenderer.browser.viewer;

/**
 * The animated transition of the viewer to another viewpoint (X3D 4.0, 23.4.4: transitionType and
 * transitionTime), without collisions.
 */
public final class ViewpointTransition implements ViewerMotion {
  /** The type of a transition. */
  public enum Type {
    /** The viewer jumps to the viewpoint. */
    TELEPORT,
    /** The viewer moves in a straight line at a constant speed. */
    LINEAR,
    /**
     * The viewer moves in a straight line with ease-in and ease-out; this is the browser's own
     * animation.
     */
    ANIMATE;

    /** Returns the first known type; LINEAR, the standard's default, if none is known. */
    public static Type of(String... transitionType) {
      for (String name : transitionType) {
        for (Type type : values()) {
          if (type.name().equals(name)) {
            return type;
          }
        }
      }
      return LINEAR;
    }
  }

  private final Pose from;
  private final Pose to;
  private final Type type;
  private final double start;
  private final double duration;

  /**
   * @param start the start time in seconds
   * @param duration the duration in seconds; with 0 the viewer jumps
   */
  public ViewpointTransition(Pose from, Pose to, Type type, double start, double duration) {
    this.from = from;
    this.to = to;
    this.type = type;
    this.start = start;
    this.duration = duration > 0 ? duration : 0;
  }

  /** Returns the same transition with another end, for a viewpoint that moves meanwhile. */
  public ViewpointTransition to(Pose end) {
    return new ViewpointTransition(from, end, type, start, duration);
  }

  /** Returns the end pose. */
  public Pose end() {
    return to;
  }

  /** Returns whether the viewer has arrived by a time, so that transitionComplete must be sent. */
  public boolean done(double time) {
    return type == Type.TELEPORT || time >= start + duration;
  }

  /** Returns the viewer's pose at a time. */
  public Pose at(double time) {
    if (done(time)) {
      return to;
    }
    double share = Math.max(0, (time - start) / duration);
    return from.towards(to, type == Type.ANIMATE ? share * share * (3 - 2 * share) : share);
  }

  @Override
  public void move(Viewer viewer, double time, double dt) {
    at(time).applyTo(viewer);
  }
}
