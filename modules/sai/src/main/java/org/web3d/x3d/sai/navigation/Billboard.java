package org.web3d.x3d.sai.navigation;

import org.web3d.x3d.sai.X3DGroupingNode;

/** Children that turn about an axis to face the viewer (X3D 4.0, clause 23). */
public interface Billboard extends X3DGroupingNode {
  /** The axis; 0 0 0 turns about all axes; goes into the first three elements of {@code value}. */
  void getAxisOfRotation(float[] value);

  /** Sets {@link #getAxisOfRotation}, three elements. */
  void setAxisOfRotation(float[] value);
}
