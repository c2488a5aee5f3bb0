package org.web3d.x3d.sai.navigation;

import org.web3d.x3d.sai.X3DGroupingNode;
import org.web3d.x3d.sai.X3DNode;

/** Children of which one is shown, by the distance of the viewer (X3D 4.0, clause 23). */
public interface LOD extends X3DGroupingNode {
  /**
   * The point from which the distance is measured, in metres; goes into the first three elements of
   * {@code value}.
   */
  void getCenter(float[] value);

  /**
   * Sets {@link #getCenter}, three elements. Only while the node is not {@linkplain
   * X3DNode#realize() realized}.
   */
  void setCenter(float[] value);

  /** The number of elements that {@link #getRange} writes. */
  int getNumRange();

  /**
   * The distances at which the next child takes over, in metres; go into the first {@link
   * #getNumRange()} elements of {@code value}.
   */
  void getRange(float[] value);

  /**
   * Sets {@link #getRange} to all elements of {@code value}. Only while the node is not {@linkplain
   * X3DNode#realize() realized}.
   */
  void setRange(float[] value);

  /** The index of the child that is shown. */
  int getLevel();

  /** Whether each level is to be shown in turn. */
  boolean getForceTransitions();

  /**
   * Sets {@link #getForceTransitions()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setForceTransitions(boolean value);
}
