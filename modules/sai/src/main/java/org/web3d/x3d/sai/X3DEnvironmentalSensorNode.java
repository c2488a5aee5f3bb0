package org.web3d.x3d.sai;

/**
 * A sensor for the viewer being in, or seeing, a box in space (X3D 4.0, clause 22). Box and centre
 * are in the coordinates of the node, so that a transformation above it moves, turns and stretches
 * the box.
 */
public interface X3DEnvironmentalSensorNode extends X3DSensorNode {
  /** The centre of the box in metres; goes into the first three elements of {@code value}. */
  void getCenter(float[] value);

  /** Sets {@link #getCenter}, three elements. */
  void setCenter(float[] value);

  /**
   * The width, height and depth of the box in metres; a sensor with a zero among them senses
   * nothing; goes into the first three elements of {@code value}.
   */
  void getSize(float[] value);

  /** Sets {@link #getSize}, three elements. */
  void setSize(float[] value);

  /** The time of the last entry, in seconds. */
  double getEnterTime();

  /** The time of the last exit, in seconds. */
  double getExitTime();
}
