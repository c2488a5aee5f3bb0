package org.selectiverenderer.radiosity.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;

/** Where the facets of a wall of 4 m by 4 m go. */
class ErrorDrivenRefinementTest {
  private static final double SIDE = 4;

  @Test
  void evenLightIsWorthNoFacet() {
    assertThat(refined((x, y) -> 0.5, 100).count()).isEqualTo(2);
  }

  @Test
  void lightThatInterpolationShowsIsWorthNoFacet() {
    assertThat(refined((x, y) -> 0.1 + 0.1 * x + 0.05 * y, 100).count()).isEqualTo(2);
  }

  @Test
  void facetsGoToTheEdgeOfAShadow() {
    ConformingTriangleMesh mesh = refined((x, y) -> x < 1.1 ? 0.2 : 0.8, 100);
    assertThat(mesh.count()).isBetween(99, 100);
    double near = 0;
    double far = 0;
    for (ConformingTriangleMesh.Tile tile : mesh.tiles()) {
      float[] c = tile.facet.corners();
      double x = (c[0] + c[3] + c[6]) / 3.0;
      near += Math.abs(x - 1.1) < 0.5 ? 1 : 0;
      far += x > 2 ? 1 : 0;
    }
    assertThat(near).isGreaterThan(5 * far);
  }

  private static ConformingTriangleMesh refined(DoubleBinaryOperator light, int polygons) {
    ConformingTriangleMesh fine = square();
    while (fine.count() < 4000) {
      List<ConformingTriangleMesh.Tile> all = new ArrayList<>();
      fine.tiles().forEach(all::add);
      for (ConformingTriangleMesh.Tile tile : all) {
        if (fine.alive(tile)) {
          fine.halve(fine.terminal(tile));
        }
      }
    }
    FineMeshReference map = new FineMeshReference();
    for (ConformingTriangleMesh.Tile tile : fine.tiles()) {
      float[] c = tile.facet.corners();
      double[] values = new double[3];
      for (int i = 0; i < 3; i++) {
        values[i] = light.applyAsDouble(c[3 * i], c[3 * i + 1]);
      }
      map.add(tile, values, 0);
    }
    ConformingTriangleMesh mesh = square();
    Map<Integer, Integer> same = new HashMap<>();
    mesh.tiles().forEach(tile -> same.put(tile.number, tile.number));
    new ErrorDrivenRefinement(mesh, map, same).divide(polygons, 0.05, 0.001);
    return mesh;
  }

  private static ConformingTriangleMesh square() {
    ConformingTriangleMesh mesh = new ConformingTriangleMesh(SIDE);
    float s = (float) SIDE;
    mesh.add(0, facet(0, 0, s, 0, s, s));
    mesh.add(0, facet(0, 0, s, s, 0, s));
    return mesh;
  }

  private static Facet facet(float ax, float ay, float bx, float by, float cx, float cy) {
    float[] corners = {ax, ay, 0, bx, by, 0, cx, cy, 0};
    return new Facet(0, corners, corners.clone(), new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1});
  }
}
