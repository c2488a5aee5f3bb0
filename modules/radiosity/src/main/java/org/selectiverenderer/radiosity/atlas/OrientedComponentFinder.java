package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * Finds the consistently oriented connected components of a body, called sheets: their triangles
 * are connected by edges on which the windings agree, so that the fronts of all of them form one
 * side of the sheet.
 */
public final class OrientedComponentFinder {
  private OrientedComponentFinder() {}

  /** Returns the number of the sheet of each triangle of a body; sheets are numbered from 0 on. */
  public static int[] of(RadiosityScene scene, Body body) {
    TriangleAdjacency welded = new TriangleAdjacency(scene, body);
    int[] sheets = new int[body.triangles()];
    Arrays.fill(sheets, TriangleAdjacency.NONE);
    int[] open = new int[sheets.length];
    int count = 0;
    for (int first = 0; first < sheets.length; first++) {
      if (sheets[first] != TriangleAdjacency.NONE) {
        continue;
      }
      int waiting = 0;
      open[waiting++] = first;
      sheets[first] = count;
      while (waiting > 0) {
        int triangle = open[--waiting];
        for (int edge = 0; edge < 3; edge++) {
          int next = welded.neighbour(triangle, edge);
          if (next != TriangleAdjacency.NONE && sheets[next] == TriangleAdjacency.NONE) {
            sheets[next] = count;
            open[waiting++] = next;
          }
        }
      }
      count++;
    }
    return sheets;
  }
}
