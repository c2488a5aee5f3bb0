package org.web3d.x3d.sai;

/** A profile of X3D: a name for a set of components (X3D 4.0, 4.6). */
public interface ProfileInfo {
  /** The name, for example {@code Immersive}. */
  String getName();

  /** A title for people. */
  String getTitle();

  /** The components that make up the profile. */
  ComponentInfo[] getComponents();

  /** The profile as a scene in the classic encoding declares it. */
  String toX3DString();
}
