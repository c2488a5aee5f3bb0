package org.web3d.x3d.sai;

import java.awt.image.RenderedImage;
import java.awt.image.WritableRenderedImage;

/**
 * A field that holds an image (X3D 4.0, clause 5). A pixel is an integer that holds one to four
 * components of eight bits each, the last in the lowest bits; rows run from the bottom up. The AWT
 * is touched only by the methods that name it.
 */
public interface SFImage extends X3DField {
  /** The width in pixels. */
  int getWidth();

  /** The height in pixels. */
  int getHeight();

  /** The components of a pixel: 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha. */
  int getComponents();

  /** Puts the pixels into the first width times height elements of the array. */
  void getPixels(int[] value);

  /** The image in the form of the AWT; changes to it do not reach the field. */
  WritableRenderedImage getImage();

  /** Sends an image to the field. */
  void setImage(RenderedImage image)
      throws InvalidOperationTimingException,
          InvalidFieldValueException,
          InvalidWritableFieldException,
          InvalidFieldException;

  /**
   * Sends a part of an image to a part of the field of the same size; both places are the lower
   * left corners.
   */
  void setSubImage(
      RenderedImage image, int width, int height, int fromX, int fromY, int toX, int toY)
      throws InvalidOperationTimingException,
          InvalidFieldValueException,
          InvalidWritableFieldException,
          InvalidFieldException;

  /** Sends an image to the field, pixel by pixel. */
  void setValue(int width, int height, int components, int[] pixels);
}
