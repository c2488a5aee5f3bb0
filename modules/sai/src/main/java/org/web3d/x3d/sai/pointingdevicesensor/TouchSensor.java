package org.web3d.x3d.sai.pointingdevicesensor;

import org.web3d.x3d.sai.X3DTouchSensorNode;

/** Senses where geometry is touched (X3D 4.0, clause 20). */
public interface TouchSensor extends X3DTouchSensorNode {
  /**
   * The normal of the surface under the device; goes into the first three elements of {@code
   * value}.
   */
  void getHitNormal(float[] value);

  /**
   * The point of the surface under the device in the coordinates of the node, in metres; goes into
   * the first three elements of {@code value}.
   */
  void getHitPoint(float[] value);

  /**
   * The texture coordinates under the device; goes into the first two elements of {@code value}.
   */
  void getHitTexCoord(float[] value);
}
