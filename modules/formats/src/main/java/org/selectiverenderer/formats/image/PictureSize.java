package org.selectiverenderer.formats.image;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;

/**
 * The width and height of a picture, as the beginning of its file states them: PNG, JPEG, GIF, BMP,
 * DDS and KTX 2. No pixel is decoded.
 *
 * @param width in pixels
 * @param height in pixels
 */
public record PictureSize(int width, int height) {
  /** The largest side that is believed. */
  private static final int MOST = 1 << 16;

  /** The most segments of a JPEG before its frame. */
  private static final int SEGMENTS = 4096;

  /**
   * Reads the size from the beginning of a file.
   *
   * @param in at the first byte; not closed
   * @return empty if the file is no such picture or ends too early
   * @throws IOException if it cannot be read
   */
  public static Optional<PictureSize> read(InputStream in) throws IOException {
    DataInputStream data = new DataInputStream(in);
    try {
      int first = data.readInt();
      return switch (first) {
        case 0x89504e47 -> {
          data.skipNBytes(12); // the rest of the signature, length and name of IHDR
          yield of(data.readInt(), data.readInt());
        }
        case 0x47494638 -> {
          data.skipNBytes(2);
          yield of(little(data, 2), little(data, 2));
        }
        case 0x44445320 -> {
          data.skipNBytes(8);
          int height = little(data, 4);
          yield of(little(data, 4), height);
        }
        case 0xab4b5458 -> {
          data.skipNBytes(16);
          yield of(little(data, 4), little(data, 4));
        }
        default -> other(first, data);
      };
    } catch (EOFException e) {
      return Optional.empty();
    }
  }

  private static Optional<PictureSize> other(int first, DataInputStream data) throws IOException {
    if (first >>> 8 == 0xffd8ff) {
      return jpeg(first & 0xff, data);
    }
    if (first >>> 16 == 0x424d) {
      data.skipNBytes(14);
      return of(little(data, 4), Math.abs(little(data, 4))); // a negative height runs downwards
    }
    return Optional.empty();
  }

  /**
   * @param begun the first marker after the start of the picture
   */
  private static Optional<PictureSize> jpeg(int begun, DataInputStream data) throws IOException {
    int marker = begun;
    for (int i = 0; i < SEGMENTS; i++) {
      int length = data.readUnsignedShort();
      boolean frame =
          marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
      if (frame) {
        data.skipNBytes(1);
        int height = data.readUnsignedShort();
        return of(data.readUnsignedShort(), height);
      }
      data.skipNBytes(Math.max(0, length - 2));
      if (data.readUnsignedByte() != 0xff) {
        return Optional.empty();
      }
      do {
        marker = data.readUnsignedByte();
      } while (marker == 0xff);
    }
    return Optional.empty();
  }

  private static int little(DataInputStream data, int bytes) throws IOException {
    int value = 0;
    for (int i = 0; i < bytes; i++) {
      value |= data.readUnsignedByte() << (8 * i);
    }
    return value;
  }

  private static Optional<PictureSize> of(int width, int height) {
    boolean believed = width > 0 && height > 0 && width <= MOST && height <= MOST;
    return believed ? Optional.of(new PictureSize(width, height)) : Optional.empty();
  }

  /**
   * Returns the bytes that the picture takes in the memory of a graphics card: four a pixel, and
   * those of its mip maps, each half as wide and high as the one before, down to one pixel.
   */
  public long textureBytes() {
    long bytes = 0;
    int w = width;
    int h = height;
    while (true) {
      bytes += 4L * w * h;
      if (w == 1 && h == 1) {
        return bytes;
      }
      w = Math.max(1, w / 2);
      h = Math.max(1, h / 2);
    }
  }
}
