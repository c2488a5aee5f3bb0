package org.selectiverenderer.apartment.building;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.apartment.plan.WallSide;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

class WallGridMeshTest {
  private static final Opening WINDOW = new Opening(WallSide.NORTH, 0, 1.6, 0.9, 1.2);
  private final TriangleMesh wall = new WallGridMesh(-3, 3, 2.6, 0.2, List.of(WINDOW)).mesh();

  @Test
  void theFrontIsTheWallWithoutItsOpenings() {
    double area = 0;
    for (Vector3d[] t : front()) {
      Vector3d across = new Vector3d(t[1]).sub(t[0]).cross(new Vector3d(t[2]).sub(t[0]));
      assertThat(across.z).isPositive();
      area += across.z / 2;
    }
    assertThat(area).isCloseTo(6 * (2.6 - 0.06) - 1.6 * 1.2, within(1e-5));
  }

  @Test
  void noCornerLiesOnAnothersEdge() {
    List<Vector3d[]> front = front();
    for (Vector3d[] t : front) {
      for (int i = 0; i < 3; i++) {
        Vector3d a = t[i];
        Vector3d b = t[(i + 1) % 3];
        for (Vector3d[] other : front) {
          for (Vector3d p : other) {
            double detour = a.distance(p) + p.distance(b) - a.distance(b);
            assertThat(detour < 1e-6 && a.distance(p) > 1e-3 && p.distance(b) > 1e-3).isFalse();
          }
        }
      }
    }
  }

  private List<Vector3d[]> front() {
    List<Vector3d[]> all = new ArrayList<>();
    for (int t = 0; t < wall.triangleCount(); t++) {
      Vector3d[] corners = new Vector3d[3];
      boolean inFront = true;
      for (int i = 0; i < 3; i++) {
        corners[i] = wall.point(wall.triangles()[3 * t + i]);
        inFront &= Math.abs(corners[i].z) < 1e-9;
      }
      if (inFront) {
        all.add(corners);
      }
    }
    return all;
  }
}
