package org.selectiverenderer.cli.bundle;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Writes icon files of Windows and macOS with PNG pictures of several sizes: ICO since Windows
 * Vista, ICNS since Mac OS X 10.7.
 */
final class IconFileWriter {
  private static final int ICO_HEADER = 6;
  private static final int ICO_ENTRY = 16;
  private static final int ICNS_HEADER = 8;
  private static final int TRUE_COLOUR = 32;

  /** The ICNS types that hold PNG data, keyed by the side length of their picture in pixels. */
  private static final Map<Integer, String> ICNS_TYPES =
      Map.of(16, "icp4", 32, "icp5", 64, "icp6", 128, "ic07", 256, "ic08", 512, "ic09");

  private IconFileWriter() {}

  /**
   * @param pictures PNG files by their side in pixels, 1 to 256
   */
  static byte[] ico(SortedMap<Integer, byte[]> pictures) {
    int data = ICO_HEADER + ICO_ENTRY * pictures.size();
    ByteBuffer out = ByteBuffer.allocate(data + total(pictures, 0)).order(ByteOrder.LITTLE_ENDIAN);
    out.putShort((short) 0).putShort((short) 1).putShort((short) pictures.size());
    for (Map.Entry<Integer, byte[]> picture : pictures.entrySet()) {
      byte side = (byte) (int) picture.getKey(); // 256 is written as 0.
      out.put(side).put(side).put((byte) 0).put((byte) 0);
      out.putShort((short) 1).putShort((short) TRUE_COLOUR);
      out.putInt(picture.getValue().length).putInt(data);
      data += picture.getValue().length;
    }
    pictures.values().forEach(out::put);
    return out.array();
  }

  /**
   * @param pictures PNG files by their side in pixels; sizes that the format lacks are left out
   */
  static byte[] icns(SortedMap<Integer, byte[]> pictures) {
    SortedMap<Integer, byte[]> known = new TreeMap<>(pictures);
    known.keySet().retainAll(ICNS_TYPES.keySet());
    int length = ICNS_HEADER + total(known, ICNS_HEADER);
    ByteBuffer out = ByteBuffer.allocate(length); // Big-endian.
    out.put("icns".getBytes(StandardCharsets.US_ASCII)).putInt(length);
    known.forEach(
        (side, png) ->
            out.put(ICNS_TYPES.getOrDefault(side, "").getBytes(StandardCharsets.US_ASCII))
                .putInt(ICNS_HEADER + png.length)
                .put(png));
    return out.array();
  }

  private static int total(SortedMap<Integer, byte[]> pictures, int each) {
    return pictures.values().stream().mapToInt(png -> png.length + each).sum();
  }
}
