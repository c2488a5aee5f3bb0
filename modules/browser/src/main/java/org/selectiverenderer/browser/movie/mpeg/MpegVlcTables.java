package org.selectiverenderer.browser.movie.mpeg;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;

/**
 * The variable-length code tables of MPEG-1 video (ISO/IEC 11172-2, Annex B), read from a resource
 * of this package.
 *
 * @param increment the macroblock address increment, or {@link #STUFFING}, {@link #ESCAPE}
 * @param types the flags of the macroblock type, for each picture type: 1 I, 2 P, 3 B
 * @param motion the motion code: the absolute difference to the previous vector component
 * @param pattern the coded block pattern, the first block in the highest of six bits
 * @param luminance the size in bits of the DC difference of a luminance block
 * @param chrominance the size in bits of the DC difference of a chrominance block
 * @param coefficient 64 times the run plus the absolute level of a DCT coefficient; or {@link
 *     #END}, {@link #ESCAPE}
 */
record MpegVlcTables(
    VlcTable increment,
    VlcTable[] types,
    VlcTable motion,
    VlcTable pattern,
    VlcTable luminance,
    VlcTable chrominance,
    VlcTable coefficient) {
  static final int STUFFING = 0x7000;
  static final int ESCAPE = 0x7001;
  static final int END = 0x7002;

  static final int QUANTIZER = 1;
  static final int FORWARD = 2;
  static final int BACKWARD = 4;
  static final int PATTERN = 8;
  static final int INTRA = 16;

  private static final String FLAGS = "qfbpi";

  static MpegVlcTables load() {
    Map<String, Map<String, Integer>> tables = new HashMap<>();
    for (String line : text().split("\n")) {
      String[] cells = line.strip().split("\t");
      if (cells.length == 3 && !cells[0].equals("table")) {
        tables
            .computeIfAbsent(cells[0], table -> new HashMap<>())
            .put(cells[1], value(cells[0], cells[2]));
      }
    }
    return new MpegVlcTables(
        code(tables, "increment"),
        new VlcTable[] {
          code(tables, "intra"),
          code(tables, "intra"),
          code(tables, "predicted"),
          code(tables, "bidirectional")
        },
        code(tables, "motion"),
        code(tables, "pattern"),
        code(tables, "luminance"),
        code(tables, "chrominance"),
        code(tables, "coefficient"));
  }

  private static VlcTable code(Map<String, Map<String, Integer>> tables, String name) {
    return new VlcTable(Objects.requireNonNull(tables.get(name), name));
  }

  private static int value(String table, String cell) {
    switch (cell) {
      case "stuffing" -> {
        return STUFFING;
      }
      case "escape" -> {
        return ESCAPE;
      }
      case "end" -> {
        return END;
      }
      default -> {}
    }
    switch (table) {
      case "intra", "predicted", "bidirectional" -> {
        return cell.chars().map(flag -> 1 << FLAGS.indexOf(flag)).sum();
      }
      case "coefficient" -> {
        String[] numbers = cell.split(" ");
        return Integer.parseInt(numbers[0]) << 6 | Integer.parseInt(numbers[1]);
      }
      default -> {
        return Integer.parseInt(cell);
      }
    }
  }

  private static String text() {
    String name = "mpeg1-codes.tsv";
    try (InputStream in =
        Objects.requireNonNull(MpegVlcTables.class.getResourceAsStream(name), name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
