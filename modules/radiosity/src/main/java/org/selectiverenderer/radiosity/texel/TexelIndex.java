package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntConsumer;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasPage;

/**
 * A numbering of the texels of all pages, page after page, with the texels that are to be gathered.
 * Tiles are squares of texels for which lamps are culled together. Only {@link #leave} changes it.
 */
final class TexelIndex {
  /** Side of a tile, texels. */
  static final int TILE = 8;

  private final Atlas atlas;
  private final TwoSidedLightSelector sides;
  private final int[] first;
  private final int[] firstTile;
  private final boolean[] wanted;

  TexelIndex(Atlas atlas, TexelSelection choice, TwoSidedLightSelector sides) {
    this.atlas = atlas;
    this.sides = sides;
    int pages = atlas.pages().size();
    first = new int[pages + 1];
    firstTile = new int[pages + 1];
    for (int i = 0; i < pages; i++) {
      AtlasPage map = atlas.pages().get(i);
      first[i + 1] = Math.addExact(first[i], map.texels());
      firstTile[i + 1] = firstTile[i] + across(map) * ((map.height() + TILE - 1) / TILE);
    }
    wanted = new boolean[first[pages]];
    for (int page = 0; page < pages; page++) {
      int[] triangle = atlas.pages().get(page).triangle();
      for (int i = 0; i < triangle.length; i++) {
        wanted[first[page] + i] = triangle[i] != AtlasPage.NONE && choice.wanted(page, i);
      }
    }
  }

  Atlas atlas() {
    return atlas;
  }

  /** Returns the lit sides of two-sided surfaces. */
  TwoSidedLightSelector sides() {
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

  AtlasPage map(int page) {
    return atlas.pages().get(page);
  }

  boolean wanted(int texel) {
    return wanted[texel];
  }

  /** Excludes a texel that is not visible from gathering. */
  void leave(int texel) {
    wanted[texel] = false;
  }

  /** Returns the number of tiles in a row of a page. */
  static int across(AtlasPage map) {
    return (map.width() + TILE - 1) / TILE;
  }

  int pageOfTile(int tile) {
    return page(firstTile, tile);
  }

  int firstTile(int page) {
    return firstTile[page];
  }

  /** Calls a consumer for each texel of a tile that is to be gathered, row by row. */
  void each(int tile, IntConsumer texel) {
    int page = pageOfTile(tile);
    AtlasPage map = map(page);
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

  /** Splits r, g, b of all texels into one array per page. */
  List<float[]> pages(float[] all) {
    return java.util.stream.IntStream.range(0, atlas.pages().size())
        .mapToObj(page -> Arrays.copyOfRange(all, 3 * first[page], 3 * first[page + 1]))
        .toList();
  }
}
