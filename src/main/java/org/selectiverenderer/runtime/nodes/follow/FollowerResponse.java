package org.selectiverenderer.runtime.nodes.follow;

/** How a value gets to its destination. Times are in seconds and never go back. */
interface FollowerResponse {
  /** Is at a value and rests there. */
  void start(double[] value);

  /** Is to get from where it is at that time to a destination of any length. */
  void aim(double[] destination, double time);

  /** Goes on to a time. */
  void advance(double time);

  double[] value();

  /** Whether it is there; then {@link #value} is the destination. */
  boolean arrived();
}
