package org.web3d.x3d.sai;

/** An object whose content comes from a file (X3D 4.0, clause 9). */
public interface X3DUrlObject {
  /** The number of elements that {@link #getUrl} writes. */
  int getNumUrl();

  /**
   * The places of the content, the preferred one first; go into the first {@link #getNumUrl()}
   * elements of {@code value}.
   */
  void getUrl(String[] value);

  /** Sets {@link #getUrl} to all elements of {@code value}. */
  void setUrl(String[] value);
}
