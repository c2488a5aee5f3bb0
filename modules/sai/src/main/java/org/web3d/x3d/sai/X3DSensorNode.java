package org.web3d.x3d.sai;

/** A node that watches the user or the world and sends what it finds (X3D 4.0, 7.3.7). */
public interface X3DSensorNode extends X3DChildNode {
  /** Whether the sensor works. */
  boolean getEnabled();

  /** Sets {@link #getEnabled()}. */
  void setEnabled(boolean value);

  /** Whether the sensor senses something now. */
  boolean getIsActive();
}
