package org.selectiverenderer.browser.loading;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.browser.instance.CubeTexture;
import org.selectiverenderer.browser.instance.Texture;

/**
 * Reads DirectDraw Surface files: plain images, cube maps and volumes, uncompressed or compressed
 * by DXT1, DXT3 or DXT5. Mipmap levels in the file are skipped; the GPU generates its own
 * (Microsoft, Programming Guide for DDS).
 */
final class DdsDecoder {
  private static final int MAGIC = 0x20534444;

  /** Size of the header in bytes. */
  static final int HEADER = 128;

  private static final int ALPHA = 0x1;
  private static final int FOUR_CHARACTERS = 0x4;
  private static final int COLOURS = 0x40;
  private static final int GREY = 0x20000;
  private static final int MIPMAPS = 0x20000;
  private static final int CUBE = 0x200;
  private static final int ALL_FACES = 0xfc00;
  private static final int VOLUME = 0x200000;

  private final ByteBuffer in;
  private final int width;
  private final int height;
  private final int levels;
  private final int depth;
  private final boolean cube;
  private final int flags;
  private final int bits;
  private final int[] masks;
  private final int block;

  static boolean is(byte[] file) {
    return file.length >= HEADER
        && ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).getInt(0) == MAGIC;
  }

  private DdsDecoder(byte[] file) throws IOException {
    in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    height = in.getInt(12);
    width = in.getInt(16);
    levels = (in.getInt(8) & MIPMAPS) != 0 ? Math.max(1, in.getInt(28)) : 1;
    int kind = in.getInt(112);
    cube = (kind & CUBE) != 0;
    depth = (kind & VOLUME) != 0 ? in.getInt(24) : 1;
    flags = in.getInt(80);
    bits = in.getInt(88);
    masks = new int[] {in.getInt(92), in.getInt(96), in.getInt(100), in.getInt(104)};
    if (width < 1 || height < 1 || depth < 1 || levels > 31) {
      throw new IOException("is a damaged DDS image: its width or height is 0");
    }
    if (cube && (kind & ALL_FACES) != ALL_FACES) {
      throw new IOException("is a DDS cube map without all six faces");
    }
    block = (flags & FOUR_CHARACTERS) != 0 ? block(in.getInt(84)) : 0;
    if (block == 0 && ((flags & (COLOURS | GREY)) == 0 || bits < 8 || bits > 32)) {
      throw new IOException(
          "is a DDS image in an unsupported format (use uncompressed, DXT1, DXT3 or DXT5)");
    }
  }

  /** Returns the bytes of a block of sixteen pixels. */
  private static int block(int name) throws IOException {
    return switch (name) {
      case 0x31545844 -> 8; // DXT1
      case 0x33545844, 0x35545844 -> 16; // DXT3, DXT5
      default ->
          throw new IOException(
              "is a DDS image in an unsupported format (use uncompressed, DXT1, DXT3 or DXT5)");
    };
  }

  /**
   * @throws IOException if the image cannot be read; {@link Failure#clause} gives the reason
   */
  static Texture.Image read(byte[] file, AtomicLong budget) throws IOException {
    DdsDecoder image = new DdsDecoder(file);
    int layers = image.cube ? CubeTexture.FACES : image.depth;
    // Sizes in a damaged file may be so large that their product overflows a long.
    double pixels = (double) image.width * image.height * layers;
    ImageDecoder.spend((long) Math.min(pixels, 1e15), budget);
    return image.read(layers);
  }

  private Texture.Image read(int layers) throws IOException {
    byte[] rgba = new byte[Math.multiplyExact(width * height * 4, layers)];
    int at = HEADER;
    int picture = width * height * 4;
    for (int i = 0; i < layers; i++) {
      long size = size(width, height);
      if (at + size > in.limit()) {
        throw new IOException("is a damaged DDS image: it ends too early");
      }
      int to = (cube ? CubeFaces.layer(i) : i) * picture;
      if (block == 0) {
        plain(at, rgba, to);
      } else {
        new DxtDecoder(in, block, (flags & ALPHA) != 0, in.getInt(84) == 0x35545844)
            .read(at, width, height, rgba, to);
      }
      at += (int) size + (cube ? smaller() : 0);
      if (cube) {
        CubeFaces.asSeenFromInside(rgba, to, width, height, i);
      }
    }
    boolean alpha = translucent(rgba);
    boolean grey = block == 0 && (flags & GREY) != 0;
    return new Texture.Image(width, height, layers, (grey ? 1 : 3) + (alpha ? 1 : 0), rgba);
  }

  private long size(int w, int h) {
    return block == 0 ? (long) w * h * bits / 8 : (long) ((w + 3) / 4) * ((h + 3) / 4) * block;
  }

  /** Returns the bytes of a face's mipmap levels below the first. */
  private int smaller() {
    long sum = 0;
    for (int level = 1; level < levels; level++) {
      sum += size(Math.max(1, width >> level), Math.max(1, height >> level));
    }
    return (int) Math.min(sum, Integer.MAX_VALUE / 8);
  }

  /** Copies an uncompressed image; the first row of the file is the top. */
  private void plain(int from, byte[] rgba, int to) {
    int bytes = bits / 8;
    for (int y = 0; y < height; y++) {
      int at = to + (height - 1 - y) * width * 4;
      for (int x = 0; x < width; x++, at += 4) {
        int value = 0;
        for (int b = 0; b < bytes; b++) {
          value |= (in.get(from + (y * width + x) * bytes + b) & 0xff) << 8 * b;
        }
        boolean grey = (flags & GREY) != 0;
        rgba[at] = channel(value, masks[0]);
        rgba[at + 1] = channel(value, masks[grey ? 0 : 1]);
        rgba[at + 2] = channel(value, masks[grey ? 0 : 2]);
        rgba[at + 3] = (flags & ALPHA) == 0 ? (byte) 255 : channel(value, masks[3]);
      }
    }
  }

  private static byte channel(int value, int mask) {
    if (mask == 0) {
      return 0;
    }
    int shift = Integer.numberOfTrailingZeros(mask);
    long most = (mask >>> shift) & 0xffffffffL;
    return (byte) ((((value & mask) >>> shift) & 0xffffffffL) * 255 / most);
  }

  /** Returns whether a pixel is not opaque. */
  static boolean translucent(byte[] rgba) {
    for (int i = 3; i < rgba.length; i += 4) {
      if (rgba[i] != (byte) 255) {
        return true;
      }
    }
    return false;
  }
}
