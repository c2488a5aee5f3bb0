package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntConsumer;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.TexelMap;

/**
 * The texels of all pages in one row, page after page, and which of them are to be gathered; tiles
 * are squares of texels in which lamps are looked for together. Only {@link #leave} changes it.
 */
final class Texels {
  /** Sides of a tile, texels. */
  static final int TILE = 8;

  private final Atlas atlas;
  private final SeenSides sides;
  private final int[] first;
  private final int[] firstTile;
  private final boolean[] wanted;

  Texels(Atlas atlas, TexelChoice choice, SeenSides sides) {
    this.atlas = atlas;
    this.sides = sides;
    int pages = atlas.pages().size();
    first = new int[pages + 1];
    firstTile = new int[pages + 1];
    for (int i = 0; i < pages; i++) {
      TexelMap map = atlas.pages().get(i);
      first[i + 1] = Math.addExact(first[i], map.texels());
      firstTile[i + 1] = firstTile[i] + across(map) * ((map.height() + TILE - 1) / TILE);
    }
    wanted = new boolean[first[pages]];
    for (int page = 0; page < pages; page++) {
      int[] triangle = atlas.pages().get(page).triangle();
      for (int i = 0; i < triangle.length; i++) {
        wanted[first[page] + i] = triangle[i] != TexelMap.NONE && choice.wanted(page, i);
      }
    }
  }

  Atlas atlas() {
    return atlas;
  }

  /** Of what has two, whose light they hold. */
  SeenSides sides() {
    return sides;
  }

  int count() {
    return wanted.length;
  }

  int tiles() {
    return firstTile[firstTile.length - 1];
  }

  int first(int page) {
    return first[page];
  }

  int pageOf(int texel) {
    return page(first, texel);
  }

  private static int page(int[] first, int number) {
    int at = Arrays.binarySearch(first, number);
    if (at < 0) {
      return -at - 2;
    }
    while (first[at + 1] == number) {
      at++; // A page without texels.
    }
    return at;
  }

  TexelMap map(int page) {
    return atlas.pages().get(page);
  }

  boolean wanted(int texel) {
    return wanted[texel];
  }

  /** A texel that nobody sees: it is not gathered. */
  void leave(int texel) {
    wanted[texel] = false;
  }

  /** Tiles of a page side by side. */
  static int across(TexelMap map) {
    return (map.width() + TILE - 1) / TILE;
  }

  int pageOfTile(int tile) {
    return page(firstTile, tile);
  }

  int firstTile(int page) {
    return firstTile[page];
  }

  /** Names the wanted texels of a tile, in rows. */
  void each(int tile, IntConsumer texel) {
    int page = pageOfTile(tile);
    TexelMap map = map(page);
    int x0 = (tile - firstTile[page]) % across(map) * TILE;
    int y0 = (tile - firstTile[page]) / across(map) * TILE;
    for (int y = y0; y < Math.min(map.height(), y0 + TILE); y++) {
      for (int x = x0; x < Math.min(map.width(), x0 + TILE); x++) {
        int number = first[page] + y * map.width() + x;
        if (wanted[number]) {
          texel.accept(number);
        }
      }
    }
  }

  /** New pages of r, g, b per texel out of one row of all. */
  List<float[]> pages(float[] all) {
    return java.util.stream.IntStream.range(0, atlas.pages().size())
        .mapToObj(page -> Arrays.copyOfRange(all, 3 * first[page], 3 * first[page + 1]))
        .toList();
  }
}
