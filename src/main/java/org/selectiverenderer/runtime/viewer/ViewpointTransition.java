package org.selectiverenderer.runtime.viewer;

/**
 * The viewer's way to another viewpoint (X3D 4.0, 23.4.4: transitionType and transitionTime). It
 * passes through everything.
 */
public final class ViewpointTransition implements ViewerMotion {
  /** How to get there. */
  public enum Type {
    /** At once. */
    TELEPORT,
    /** In a straight line at a constant pace. */
    LINEAR,
    /** In a straight line, gently beginning and ending: this browser's own animation. */
    ANIMATE;

    /** The first of the names that is known; LINEAR, the standard's default, when none is. */
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
   * @param start the time at which it begins, in seconds
   * @param duration in seconds; a transition that takes no time teleports
   */
  public ViewpointTransition(Pose from, Pose to, Type type, double start, double duration) {
    this.from = from;
    this.to = to;
    this.type = type;
    this.start = start;
    this.duration = duration > 0 ? duration : 0;
  }

  /** The same way to another end: to a viewpoint that moves meanwhile. */
  public ViewpointTransition to(Pose end) {
    return new ViewpointTransition(from, end, type, start, duration);
  }

  /** Where it ends. */
  public Pose end() {
    return to;
  }

  /** Whether the viewer has arrived by that time: then transitionComplete is to be sent. */
  public boolean done(double time) {
    return type == Type.TELEPORT || time >= start + duration;
  }

  /** Where the viewer is at a time. */
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
