package org.selectiverenderer.geometry.font;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;

/**
 * Reads the tables of a TrueType font (ISO/IEC 14496-22) that outlines need: head, hhea, hmtx, cmap
 * format 4, loca, glyf. Lengths are in font units.
 */
final class TrueTypeFile {
  private final ByteBuffer data;
  private final Map<String, Integer> tables = new HashMap<>();
  private final int unitsPerEm;
  private final int ascent;
  private final int descent;
  private final int advances;
  private final boolean longOffsets;
  private final int characterMap;

  /**
   * Parses the table directory.
   *
   * @throws IllegalArgumentException if a table is missing
   */
  TrueTypeFile(ByteBuffer data) {
    this.data = data;
    int count = unsigned(4);
    for (int i = 0; i < count; i++) {
      int record = 12 + 16 * i;
      byte[] tag = new byte[4];
      for (int k = 0; k < 4; k++) {
        tag[k] = data.get(record + k);
      }
      tables.put(new String(tag, StandardCharsets.US_ASCII), data.getInt(record + 8));
    }
    this.unitsPerEm = unsigned(table("head") + 18);
    this.longOffsets = data.getShort(table("head") + 50) != 0;
    this.ascent = data.getShort(table("hhea") + 4);
    this.descent = data.getShort(table("hhea") + 6);
    this.advances = unsigned(table("hhea") + 34);
    this.characterMap = findCharacterMap();
  }

  int unitsPerEm() {
    return unitsPerEm;
  }

  int ascent() {
    return ascent;
  }

  /** Returns the descent, which is negative, below the baseline. */
  int descent() {
    return descent;
  }

  int advance(int glyph) {
    return unsigned(table("hmtx") + 4 * Math.min(glyph, advances - 1));
  }

  /** Returns the glyph index of a character; 0, the missing-glyph box, if there is none. */
  int glyphOf(int codePoint) {
    if (codePoint > 0xFFFF) {
      return 0;
    }
    int segments = unsigned(characterMap + 6) / 2;
    int ends = characterMap + 14;
    int starts = ends + 2 * segments + 2;
    int deltas = starts + 2 * segments;
    int offsets = deltas + 2 * segments;
    for (int i = 0; i < segments; i++) {
      if (codePoint <= unsigned(ends + 2 * i)) {
        int start = unsigned(starts + 2 * i);
        if (codePoint < start) {
          return 0;
        }
        int delta = unsigned(deltas + 2 * i);
        int offset = unsigned(offsets + 2 * i);
        if (offset == 0) {
          return codePoint + delta & 0xFFFF;
        }
        int glyph = unsigned(offsets + 2 * i + offset + 2 * (codePoint - start));
        return glyph == 0 ? 0 : glyph + delta & 0xFFFF;
      }
    }
    return 0;
  }

  /** Returns a view of a glyph's outline data; empty for a glyph without one, as the space. */
  ByteBuffer outline(int glyph) {
    int loca = table("loca");
    int from;
    int to;
    if (longOffsets) {
      from = data.getInt(loca + 4 * glyph);
      to = data.getInt(loca + 4 * glyph + 4);
    } else {
      from = 2 * unsigned(loca + 2 * glyph);
      to = 2 * unsigned(loca + 2 * glyph + 2);
    }
    return data.slice(table("glyf") + from, to - from);
  }

  private int findCharacterMap() {
    int cmap = table("cmap");
    int count = unsigned(cmap + 2);
    for (int i = 0; i < count; i++) {
      int map = cmap + data.getInt(cmap + 4 + 8 * i + 4);
      if (unsigned(map) == 4) {
        return map;
      }
    }
    throw new IllegalArgumentException("the font has no character map of format 4");
  }

  private int table(String tag) {
    Integer offset = tables.get(tag);
    if (offset == null) {
      throw new IllegalArgumentException("the font has no table " + tag);
    }
    return offset;
  }

  private int unsigned(int offset) {
    return data.getShort(offset) & 0xFFFF;
  }
}
