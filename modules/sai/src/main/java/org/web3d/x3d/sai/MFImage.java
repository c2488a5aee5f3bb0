package org.web3d.x3d.sai;

import java.awt.image.RenderedImage;
import java.awt.image.WritableRenderedImage;

/**
 * A field that holds any number of images, each as {@link SFImage} says. The methods with a single
 * integer for an image are as the binding declares them; an implementation may refuse them by
 * {@link NotSupportedException}.
 */
public interface MFImage extends MField {
  /** Adds what the integer stands for at the end. */
  void append(int value);

  /** Takes all images away. */
  void clear();

  /** The width in pixels of the image at an index from 0. */
  int getWidth(int index);

  /** The height in pixels of the image at an index from 0. */
  int getHeight(int index);

  /** The components of a pixel of the image at an index from 0. */
  int getComponents(int index);

  /** Puts the pixels of the image at an index from 0 into the array. */
  void getPixels(int index, int[] value);

  /** The image at an index from 0 in the form of the AWT. */
  WritableRenderedImage getImage(int index);

  /** Puts in what the integer stands for at an index from 0. */
  void insertValue(int index, int value) throws ArrayIndexOutOfBoundsException;

  /** Takes the image at an index from 0 away; what is behind moves forward by one. */
  void removeValue(int index) throws ArrayIndexOutOfBoundsException;

  /** Replaces the image at an index from 0. */
  void setImage(int index, RenderedImage image)
      throws InvalidOperationTimingException,
          InvalidFieldValueException,
          InvalidWritableFieldException,
          InvalidFieldException;

  /** Replaces a part of the image at an index from 0, as {@link SFImage#setSubImage} does. */
  void setSubImage(
      int index, RenderedImage image, int width, int height, int fromX, int fromY, int toX, int toY)
      throws InvalidOperationTimingException,
          InvalidFieldValueException,
          InvalidWritableFieldException,
          InvalidFieldException;

  /** Replaces the image at an index from 0 by what the integer stands for. */
  void set1Value(int index, int value);

  /** Replaces the image at an index from 0, pixel by pixel. */
  void set1Value(int index, int width, int height, int components, int[] pixels);

  /**
   * Replaces all images by the first {@code size} that the array holds: width, height, components
   * and pixels of each, one after the other.
   */
  void setValue(int size, int[] value);

  /** Replaces all images. */
  void setImage(RenderedImage[] images)
      throws InvalidOperationTimingException,
          InvalidFieldValueException,
          InvalidWritableFieldException,
          InvalidFieldException;
}
