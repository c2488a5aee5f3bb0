package org.web3d.x3d.sai;

/** A component of X3D at a level (X3D 4.0, 4.5). */
public interface ComponentInfo {
  /** The name, for example {@code EnvironmentalSensor}. */
  String getName();

  /** The level, from 1. */
  int getLevel();

  /** A title for people. */
  String getTitle();

  /** An address of who made the implementation. */
  String getProviderURL();

  /** The component as a scene in the classic encoding declares it. */
  String toX3DString();
}
