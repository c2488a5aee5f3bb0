package org.web3d.x3d.sai;

/** An object that may announce how large it is (X3D 4.0, clause 10). */
public interface X3DBoundedObject {
  /**
   * The centre of the bounding box in the coordinates of the node, in metres; goes into the first
   * three elements of {@code value}.
   */
  void getBboxCenter(float[] value);

  /**
   * Sets {@link #getBboxCenter}, three elements. Only while the node is not {@linkplain
   * X3DNode#realize() realized}.
   */
  void setBboxCenter(float[] value);

  /**
   * The width, height and depth of the bounding box in metres; -1 -1 -1 says that the browser is to
   * find out; goes into the first three elements of {@code value}.
   */
  void getBboxSize(float[] value);

  /**
   * Sets {@link #getBboxSize}, three elements. Only while the node is not {@linkplain
   * X3DNode#realize() realized}.
   */
  void setBboxSize(float[] value);
}
