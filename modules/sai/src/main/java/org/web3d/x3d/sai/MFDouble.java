package org.web3d.x3d.sai;

/** A field that holds any number of numbers of double precision (X3D 4.0, clause 5). */
public interface MFDouble extends MField {
  /** Adds a value at the end. */
  void append(double value);

  /** Takes all values away. */
  void clear();

  /** Puts all values into the first {@link #getSize()} elements of the array. */
  void getValue(double[] value);

  /** The value at an index from 0. */
  double get1Value(int index) throws ArrayIndexOutOfBoundsException;

  /** Inserts a value at an index from 0 and shifts the later values by one. */
  void insertValue(int index, double value) throws ArrayIndexOutOfBoundsException;

  /** Takes the value at an index from 0 away; what is behind moves forward by one. */
  void removeValue(int index) throws ArrayIndexOutOfBoundsException;

  /** Replaces all values by the first {@code size} elements of the array. */
  void setValue(int size, double[] value);

  /** Replaces the value at an index from 0. */
  void set1Value(int index, double value) throws ArrayIndexOutOfBoundsException;
}
