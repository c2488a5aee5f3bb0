package org.web3d.x3d.sai.core;

import org.web3d.x3d.sai.X3DInfoNode;

/** What the world is called and who made it (X3D 4.0, clause 7). */
public interface WorldInfo extends X3DInfoNode {
  /** The title. */
  String getTitle();

  /** Sets {@link #getTitle()}. */
  void setTitle(String value);

  /** The number of elements that {@link #getInfo} writes. */
  int getNumInfo();

  /** The remarks; go into the first {@link #getNumInfo()} elements of {@code value}. */
  void getInfo(String[] value);

  /** Sets {@link #getInfo} to all elements of {@code value}. */
  void setInfo(String[] value);
}
