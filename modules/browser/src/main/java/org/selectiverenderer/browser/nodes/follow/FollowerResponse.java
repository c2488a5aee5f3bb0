package org.selectiverenderer.browser.nodes.follow;

/**
 * The response of a follower: how its value reaches the destination. Times are in seconds and never
 * decrease.
 */
interface FollowerResponse {
  /** Sets the value, which stays there. */
  void start(double[] value);

  /**
   * Starts moving towards a destination, which may have another length, from the value at that
   * time.
   */
  void aim(double[] destination, double time);

  /** Advances to a time. */
  void advance(double time);

  double[] value();

  /** Returns whether the value has arrived; then {@link #value} is the destination. */
  boolean arrived();
}
