package org.web3d.x3d.sai;

/** Name, type and access of a field. */
public interface X3DFieldDefinition {
  /** The name, for example {@code whichChoice}. */
  String getName();

  /** The access type, a number of {@link X3DFieldTypes}. */
  int getAccessType();

  /** The type, a number of {@link X3DFieldTypes}. */
  int getFieldType();

  /** The name of the type, for example {@code SFInt32}. */
  String getFieldTypeString();
}
