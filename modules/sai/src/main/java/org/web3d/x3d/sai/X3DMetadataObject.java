package org.web3d.x3d.sai;

/**
 * Data about the node that holds it (X3D 4.0, clause 7). The standard binding does not make it a
 * kind of {@link X3DNode}, but every metadata node is both: cast to the one that is needed.
 */
public interface X3DMetadataObject {
  /** The name of what is said. */
  String getName();

  /** Sets {@link #getName()}. */
  void setName(String value);

  /** The vocabulary that defines the name. */
  String getReference();

  /** Sets {@link #getReference()}. */
  void setReference(String value);
}
