package org.web3d.x3d.sai.text;

import org.web3d.x3d.sai.X3DFontStyleNode;

/** Font, size and alignment of text (X3D 4.0, clause 15). */
public interface FontStyle extends X3DFontStyleNode {
  /** The number of elements that {@link #getFamily} writes. */
  int getNumFamily();

  /**
   * The families, the preferred one first; go into the first {@link #getNumFamily()} elements of
   * {@code value}.
   */
  void getFamily(String[] value);

  /** Sets {@link #getFamily} to all elements of {@code value}. */
  void setFamily(String[] value);

  /** Whether text runs in rows rather than in columns. */
  boolean getHorizontal();

  /** Sets {@link #getHorizontal()}. */
  void setHorizontal(boolean value);

  /** The number of elements that {@link #getJustify} writes. */
  int getNumJustify();

  /**
   * The alignments in the direction of the text and across it; go into the first {@link
   * #getNumJustify()} elements of {@code value}.
   */
  void getJustify(String[] value);

  /** Sets {@link #getJustify} to all elements of {@code value}. */
  void setJustify(String[] value);

  /** The language as a tag, such as el. */
  String getLanguage();

  /** Sets {@link #getLanguage()}. */
  void setLanguage(String value);

  /** Whether text runs from left to right. */
  boolean getLeftToRight();

  /** Sets {@link #getLeftToRight()}. */
  void setLeftToRight(boolean value);

  /** The height of a line in metres. */
  float getSize();

  /** Sets {@link #getSize()}. */
  void setSize(float value);

  /** The distance of lines as a factor of the size. */
  float getSpacing();

  /** Sets {@link #getSpacing()}. */
  void setSpacing(float value);

  /** The style: PLAIN, BOLD, ITALIC or BOLDITALIC. */
  String getStyle();

  /** Sets {@link #getStyle()}. */
  void setStyle(String value);

  /** Whether text runs from top to bottom. */
  boolean getTopToBottom();

  /** Sets {@link #getTopToBottom()}. */
  void setTopToBottom(boolean value);
}
