package org.web3d.x3d.sai;

/** An instance of a prototype (X3D 4.0, 4.4.4). */
public interface X3DProtoInstance extends X3DNode {
  /**
   * The abstract types of the node that stands for the instance, numbers of {@link X3DNodeTypes}.
   */
  int[] getImplementationTypes();
}
