package org.web3d.x3d.sai.networking;

import org.web3d.x3d.sai.X3DBoundedObject;
import org.web3d.x3d.sai.X3DChildNode;
import org.web3d.x3d.sai.X3DUrlObject;

/** A scene from another file (X3D 4.0, clause 9). */
public interface Inline extends X3DChildNode, X3DBoundedObject, X3DUrlObject {
  /** Whether the scene is to be loaded. */
  boolean getLoad();

  /** Sets {@link #getLoad()}. */
  void setLoad(boolean value);
}
