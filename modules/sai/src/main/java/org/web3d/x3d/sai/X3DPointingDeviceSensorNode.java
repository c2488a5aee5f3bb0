package org.web3d.x3d.sai;

/** A sensor for a pointing device over the geometry beside it (X3D 4.0, clause 20). */
public interface X3DPointingDeviceSensorNode extends X3DSensorNode {
  /** Whether the device points at the geometry. */
  boolean getIsOver();

  /** What the sensor is for, as a browser may show it. */
  String getDescription();

  /** Sets {@link #getDescription()}. */
  void setDescription(String value);
}
