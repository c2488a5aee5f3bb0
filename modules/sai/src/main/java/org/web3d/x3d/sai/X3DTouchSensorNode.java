package org.web3d.x3d.sai;

/**
 * A pointing device sensor that is touched: pressed and let go over its geometry (X3D 4.0, clause
 * 20).
 */
public interface X3DTouchSensorNode extends X3DPointingDeviceSensorNode {
  /** The time of the last touch, in seconds. */
  double getTouchTime();
}
