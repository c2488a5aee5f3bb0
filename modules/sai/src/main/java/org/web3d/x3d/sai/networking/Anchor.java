package org.web3d.x3d.sai.networking;

import org.web3d.x3d.sai.X3DGroupingNode;

/** Children that lead to another world or viewpoint when touched (X3D 4.0, clause 9). */
public interface Anchor extends X3DGroupingNode {
  /** Where it leads, as a browser may show it. */
  String getDescription();

  /** Sets {@link #getDescription()}. */
  void setDescription(String value);

  /** The number of elements that {@link #getParameter} writes. */
  int getNumParameter();

  /**
   * The instructions for the browser, such as a frame to load into; go into the first {@link
   * #getNumParameter()} elements of {@code value}.
   */
  void getParameter(String[] value);

  /** Sets {@link #getParameter} to all elements of {@code value}. */
  void setParameter(String[] value);

  /** The number of elements that {@link #getUrl} writes. */
  int getNumUrl();

  /**
   * The places to go to, the preferred one first; go into the first {@link #getNumUrl()} elements
   * of {@code value}.
   */
  void getUrl(String[] value);

  /** Sets {@link #getUrl} to all elements of {@code value}. */
  void setUrl(String[] value);
}
