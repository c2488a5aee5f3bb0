package org.web3d.x3d.sai.environmentalsensor;

import org.web3d.x3d.sai.X3DEnvironmentalSensorNode;

/** Senses the viewer entering, leaving and moving in a box (X3D 4.0, 22.4.1). */
public interface ProximitySensor extends X3DEnvironmentalSensorNode {
  /**
   * The position of the viewer in the coordinates of the sensor, in metres; goes into the first
   * three elements of {@code value}.
   */
  void getPosition(float[] value);

  /**
   * The orientation of the viewer in the coordinates of the sensor, as axis and angle in radians;
   * goes into the first four elements of {@code value}.
   */
  void getOrientation(float[] value);

  /**
   * The point about which the viewer turns when examining, in metres; goes into the first three
   * elements of {@code value}.
   */
  void getCenterOfRotation(float[] value);
}
