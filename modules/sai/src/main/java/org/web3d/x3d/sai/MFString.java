package org.web3d.x3d.sai;

/** A field that holds any number of strings (X3D 4.0, clause 5). */
public interface MFString extends MField {
  /** Adds a value at the end. */
  void append(String value);

  /** Takes all values away. */
  void clear();

  /** Puts all values into the first {@link #getSize()} elements of the array. */
  void getValue(String[] value);

  /** The value at an index from 0. */
  String get1Value(int index) throws ArrayIndexOutOfBoundsException;

  /** Inserts a value at an index from 0 and shifts the later values by one. */
  void insertValue(int index, String value) throws ArrayIndexOutOfBoundsException;

  /** Takes the value at an index from 0 away; what is behind moves forward by one. */
  void removeValue(int index) throws ArrayIndexOutOfBoundsException;

  /** Replaces all values by the first {@code size} elements of the array. */
  void setValue(int size, String[] value);

  /** Replaces the value at an index from 0. */
  void set1Value(int index, String value) throws ArrayIndexOutOfBoundsException;
}
