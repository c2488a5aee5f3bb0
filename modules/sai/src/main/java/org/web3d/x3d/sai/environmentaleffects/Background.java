package org.web3d.x3d.sai.environmentaleffects;

import org.web3d.x3d.sai.X3DBackgroundNode;

/** Sky, ground and six images around the scene (X3D 4.0, clause 24). */
public interface Background extends X3DBackgroundNode {
  /** The number of elements that {@link #getBackUrl} writes. */
  int getNumBackUrl();

  /**
   * The places of the image at the back; go into the first {@link #getNumBackUrl()} elements of
   * {@code value}.
   */
  void getBackUrl(String[] value);

  /** Sets {@link #getBackUrl} to all elements of {@code value}. */
  void setBackUrl(String[] value);

  /** The number of elements that {@link #getFrontUrl} writes. */
  int getNumFrontUrl();

  /**
   * The places of the image at the front; go into the first {@link #getNumFrontUrl()} elements of
   * {@code value}.
   */
  void getFrontUrl(String[] value);

  /** Sets {@link #getFrontUrl} to all elements of {@code value}. */
  void setFrontUrl(String[] value);

  /** The number of elements that {@link #getLeftUrl} writes. */
  int getNumLeftUrl();

  /**
   * The places of the image on the left; go into the first {@link #getNumLeftUrl()} elements of
   * {@code value}.
   */
  void getLeftUrl(String[] value);

  /** Sets {@link #getLeftUrl} to all elements of {@code value}. */
  void setLeftUrl(String[] value);

  /** The number of elements that {@link #getRightUrl} writes. */
  int getNumRightUrl();

  /**
   * The places of the image on the right; go into the first {@link #getNumRightUrl()} elements of
   * {@code value}.
   */
  void getRightUrl(String[] value);

  /** Sets {@link #getRightUrl} to all elements of {@code value}. */
  void setRightUrl(String[] value);

  /** The number of elements that {@link #getBottomUrl} writes. */
  int getNumBottomUrl();

  /**
   * The places of the image below; go into the first {@link #getNumBottomUrl()} elements of {@code
   * value}.
   */
  void getBottomUrl(String[] value);

  /** Sets {@link #getBottomUrl} to all elements of {@code value}. */
  void setBottomUrl(String[] value);

  /** The number of elements that {@link #getTopUrl} writes. */
  int getNumTopUrl();

  /**
   * The places of the image above; go into the first {@link #getNumTopUrl()} elements of {@code
   * value}.
   */
  void getTopUrl(String[] value);

  /** Sets {@link #getTopUrl} to all elements of {@code value}. */
  void setTopUrl(String[] value);
}
