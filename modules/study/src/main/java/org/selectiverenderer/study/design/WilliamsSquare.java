package org.selectiverenderer.study.design;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Williams's squares: Latin squares balanced for first-order carry-over, in which each treatment
 * also comes equally often right after each other one (E. J. Williams 1949, "Experimental designs
 * balanced for the estimation of residual effects of treatments", Australian Journal of Scientific
 * Research A 2). An odd number of treatments takes two squares, of which the second is the mirror
 * image of the first.
 */
public final class WilliamsSquare {
  private WilliamsSquare() {}

  /** Returns how many rows it takes to balance a number of treatments. */
  public static int rows(int size) {
    return size % 2 == 0 ? size : 2 * size;
  }

  /**
   * Returns a row: the treatments, as numbers from 0, in order.
   *
   * @param size number of treatments, at least 1
   * @param row from 0; after the last row the first one comes again
   */
  public static List<Integer> row(int size, int row) {
    int at = row % rows(size);
    // The first row goes 0, 1, n-1, 2, n-2 ...; each other is that one, counted on.
    List<Integer> order =
        new ArrayList<>(
            IntStream.range(0, size)
                .map(place -> place % 2 == 1 ? (place + 1) / 2 : (size - place / 2) % size)
                .map(first -> (first + at) % size)
                .boxed()
                .toList());
    if (at >= size) {
      Collections.reverse(order);
    }
    return order;
  }
}
