package org.web3d.x3d.sai;

/**
 * A field that holds any number of colours with opacity, red green blue alpha from 0 to 1 (X3D 4.0,
 * clause 5). A tuple is four elements.
 */
public interface MFColorRGBA extends MField {
  /** Adds a tuple at the end. */
  void append(float[] value);

  /** Takes all tuples away. */
  void clear();

  /**
   * Puts all tuples into the first {@link #getSize()} rows of the array, each at least four long.
   */
  void getValue(float[][] value);

  /**
   * Puts all tuples one after the other into the array, which holds at least {@link #getSize()}
   * times four elements.
   */
  void getValue(float[] value);

  /** Puts the tuple at an index from 0 into the array. */
  void get1Value(int index, float[] value) throws ArrayIndexOutOfBoundsException;

  /** Inserts a tuple at an index from 0 and shifts the later values by one. */
  void insertValue(int index, float[] value) throws ArrayIndexOutOfBoundsException;

  /** Takes the tuple at an index from 0 away; what is behind moves forward by one. */
  void removeValue(int index) throws ArrayIndexOutOfBoundsException;

  /** Replaces all tuples by the first {@code size} tuples, one after the other in the array. */
  void setValue(int size, float[] value);

  /** Replaces all tuples by the first {@code size} rows of the array. */
  void setValue(int size, float[][] value);

  /** Replaces the tuple at an index from 0. */
  void set1Value(int index, float[] value) throws ArrayIndexOutOfBoundsException;
}
