package org.web3d.x3d.sai.navigation;

import org.web3d.x3d.sai.X3DBindableNode;

/**
 * How the viewer moves (X3D 4.0, clause 23). The transition time is reached through {@link
 * org.web3d.x3d.sai.X3DNode#getField}: its type differs between the standard and the binding.
 */
public interface NavigationInfo extends X3DBindableNode {
  /** The number of elements that {@link #getAvatarSize} writes. */
  int getNumAvatarSize();

  /**
   * The distance at which the viewer collides, the height of the eyes and the height of the tallest
   * step, in metres; go into the first {@link #getNumAvatarSize()} elements of {@code value}.
   */
  void getAvatarSize(float[] value);

  /** Sets {@link #getAvatarSize} to all elements of {@code value}. */
  void setAvatarSize(float[] value);

  /** Whether the viewer carries a light. */
  boolean getHeadlight();

  /** Sets {@link #getHeadlight()}. */
  void setHeadlight(boolean value);

  /** The speed in metres per second. */
  float getSpeed();

  /** Sets {@link #getSpeed()}. */
  void setSpeed(float value);

  /** The number of elements that {@link #getType} writes. */
  int getNumType();

  /**
   * The ways to move, the preferred one first; go into the first {@link #getNumType()} elements of
   * {@code value}.
   */
  void getType(String[] value);

  /** Sets {@link #getType} to all elements of {@code value}. */
  void setType(String[] value);

  /** The distance beyond which nothing is drawn, in metres; 0 for no limit. */
  float getVisibilityLimit();

  /** Sets {@link #getVisibilityLimit()}. */
  void setVisibilityLimit(float value);

  /** The number of elements that {@link #getTransitionType} writes. */
  int getNumTransitionType();

  /**
   * The ways to go from one viewpoint to the next, the preferred one first; go into the first
   * {@link #getNumTransitionType()} elements of {@code value}.
   */
  void getTransitionType(String[] value);

  /** Sets {@link #getTransitionType} to all elements of {@code value}. */
  void setTransitionType(String[] value);
}
