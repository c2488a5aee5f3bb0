package org.selectiverenderer.x3d.tessellate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.Mesh;

class ExtrusionTessellatorTest extends AbstractTessellatorTest {
  private static final float[] SQUARE = {1, 1, 1, -1, -1, -1, -1, 1, 1, 1};

  @Test
  void defaultIsAClosedBox() {
    Mesh mesh = mesh("Extrusion");
    assertThat(mesh.polygons()).isEqualTo(12);
    assertThat(mesh.vertexCount()).isEqualTo(24);
    assertThat(MeshProperties.volume(mesh)).isCloseTo(4, within(1e-5));
    assertThat(MeshProperties.euler(mesh)).isEqualTo(2);
    MeshProperties.assertNormalsAgreeWithWinding(mesh);
    assertThat(mesh.bounds()).containsExactly(-1, 0, -1, 1, 1, 1);
  }

  @Test
  void collinearSpineTurnsTheSectionWithIt() {
    float[][] ends = {{3, 0, 0}, {0, 0, -3}, {0, -3, 0}, {1, 2, 2}};
    for (float[] end : ends) {
      float[] spine = {0, 0, 0, end[0] / 2, end[1] / 2, end[2] / 2, end[0], end[1], end[2]};
      Mesh mesh = mesh("Extrusion", "spine", spine);
      assertThat(MeshProperties.volume(mesh)).isCloseTo(12, within(1e-4));
      assertThat(MeshProperties.euler(mesh)).isEqualTo(2);
      MeshProperties.assertNormalsAgreeWithWinding(mesh);
    }
  }

  @Test
  void spineAlongXPutsTheSectionsXDownwards() {
    // The rotation from +y to +x takes +x to -y and leaves z.
    Mesh mesh =
        mesh(
            "Extrusion",
            "spine",
            new float[] {0, 0, 0, 1, 0, 0},
            "crossSection",
            new float[] {2, 0, 0, -1, 0, 1, 2, 0});
    assertThat(mesh.bounds()).containsExactly(new float[] {0, -2, -1, 1, 0, 1}, within(1e-6f));
  }

  @Test
  void scaleMakesAPyramidFrustum() {
    Mesh mesh =
        mesh(
            "Extrusion",
            "spine",
            new float[] {0, 0, 0, 0, 3, 0},
            "scale",
            new float[] {1, 1, 0.5f, 0.5f});
    assertThat(MeshProperties.volume(mesh)).isCloseTo(3.0 / 3 * (4 + 1 + 2), within(1e-4));
    Mesh pyramid =
        mesh(
            "Extrusion",
            "spine",
            new float[] {0, 0, 0, 0, 3, 0},
            "scale",
            new float[] {1, 1, 0, 0});
    assertThat(MeshProperties.volume(pyramid)).isCloseTo(4, within(1e-4));
    assertThat(pyramid.polygons()).isEqualTo(6);
  }

  @Test
  void orientationTurnsTheSectionInItsPlane() {
    float eighth = (float) (Math.PI / 4);
    Mesh mesh = mesh("Extrusion", "orientation", new float[] {0, 1, 0, eighth}, "endCap", false);
    float reach = (float) Math.sqrt(2);
    assertThat(mesh.bounds())
        .containsExactly(new float[] {-reach, 0, -reach, reach, 1, reach}, within(1e-5f));
    assertThat(mesh.polygons()).isEqualTo(10);
  }

  @Test
  void closedSpineMakesARingWithoutSeam() {
    int n = 24;
    float[] spine = new float[3 * (n + 1)];
    for (int i = 0; i <= n; i++) {
      spine[3 * i] = (float) (5 * Math.cos(2 * Math.PI * (i % n) / n));
      spine[3 * i + 2] = (float) (5 * Math.sin(2 * Math.PI * (i % n) / n));
    }
    Mesh mesh =
        mesh(
            "Extrusion",
            "spine",
            spine,
            "crossSection",
            SQUARE,
            "beginCap",
            false,
            "endCap",
            false,
            "creaseAngle",
            1f);
    assertThat(MeshProperties.euler(mesh)).isZero();
    // A polygon of 24 corners at radius r encloses 12 sin(15 deg) r²: the ring is 2 high.
    double polygon = 12 * Math.sin(Math.PI / 12);
    assertThat(MeshProperties.volume(mesh)).isCloseTo(2 * polygon * (36 - 16), within(1e-2));
    // The same normals at the seam as elsewhere: inner and outer walls are round.
    for (int i = 0; i < mesh.indices().length; i++) {
      double[] normal = MeshProperties.normal(mesh, i);
      double[] point = MeshProperties.point(mesh, i);
      if (Math.abs(normal[1]) < 0.5) {
        double radius = Math.hypot(point[0], point[2]);
        double radial = (normal[0] * point[0] + normal[2] * point[2]) / radius;
        assertThat(Math.abs(radial)).isCloseTo(1, within(1e-3));
      }
    }
  }

  @Test
  void coincidentSpinePointsWithOrientationsMakeASurfaceOfRevolution() {
    int n = 48;
    float[] spine = new float[3 * (n + 1)];
    float[] orientation = new float[4 * (n + 1)];
    for (int i = 0; i <= n; i++) {
      orientation[4 * i + 2] = 1;
      orientation[4 * i + 3] = (float) (2 * Math.PI * i / n);
    }
    Mesh torus =
        mesh(
            "Extrusion",
            "spine",
            spine,
            "orientation",
            orientation,
            "crossSection",
            new float[] {4, 1, 4, -1, 2, -1, 2, 1, 4, 1},
            "beginCap",
            false,
            "endCap",
            false);
    assertThat(MeshProperties.euler(torus)).isZero();
    double polygon = n / 2.0 * Math.sin(2 * Math.PI / n);
    assertThat(Math.abs(MeshProperties.volume(torus))).isCloseTo(2 * polygon * 12, within(0.05));
  }

  @Test
  void bentSpineKeepsItsSectionFromFlipping() {
    // An S in the x-y plane: the bend's normal changes sign, the section must not.
    Mesh mesh =
        mesh(
            "Extrusion",
            "spine",
            new float[] {0, 0, 0, 0, 2, 0, 2, 4, 0, 2, 6, 0, 0, 8, 0, 0, 10, 0},
            "crossSection",
            new float[] {0.1f, 0.5f, 0.1f, -0.1f, -0.1f, -0.1f, -0.1f, 0.5f, 0.1f, 0.5f});
    // z is the same axis all along, so the section lies between the same two z everywhere.
    double low = mesh.bounds()[2];
    double high = mesh.bounds()[5];
    assertThat(high - low).isCloseTo(0.6, within(1e-5));
    assertThat(MeshProperties.volume(mesh)).isPositive();
    assertThat(MeshProperties.euler(mesh)).isEqualTo(2);
  }

  @Test
  void concaveCapsKeepTheirArea() {
    float[] l = {0, 0, 0, 3, 1, 3, 1, 1, 3, 1, 3, 0, 0, 0};
    Mesh caps = mesh("Extrusion", "crossSection", l, "convex", false);
    // 5 per cap, 12 around.
    assertThat(MeshProperties.area(caps)).isCloseTo(2 * 5 + 12, within(1e-4));
    assertThat(MeshProperties.volume(caps)).isCloseTo(5, within(1e-4));
  }

  @Test
  void openSectionIsASheetWithCaps() {
    Mesh mesh =
        mesh(
            "Extrusion",
            "crossSection",
            new float[] {1, 1, 1, -1, -1, -1},
            "beginCap",
            false,
            "endCap",
            false);
    assertThat(mesh.polygons()).isEqualTo(4);
    assertThat(mesh("Extrusion", "crossSection", new float[] {1, 1, 1, -1, -1, -1}).polygons())
        .isEqualTo(6);
  }

  @Test
  void creaseAngleSmoothsTheSidesButNeverTheCaps() {
    Mesh mesh = mesh("Extrusion", "creaseAngle", 3.1f);
    // Two rings of four corners and one more for the texture's seam, and four per cap.
    assertThat(mesh.vertexCount()).isEqualTo(2 * 5 + 2 * 4);
  }

  @Test
  void textureRunsByLength() {
    Mesh mesh =
        mesh(
            "Extrusion",
            "spine",
            new float[] {0, 0, 0, 0, 1, 0, 0, 4, 0},
            "beginCap",
            false,
            "endCap",
            false);
    for (int v = 0; v < mesh.vertexCount(); v++) {
      assertThat(mesh.texCoords()[2 * v + 1])
          .isCloseTo(mesh.positions()[3 * v + 1] / 4, within(1e-6f));
    }
    assertThat(mesh.texCoords()).contains(0.25f, 0.5f, 0.75f, 1f);
  }

  @Test
  void valuesThatAreNotFiniteAreReportedAndDrawNothing() {
    Mesh mesh = mesh(node("Extrusion", "spine", new float[] {0, 0, 0, 0, Float.NaN, 0}));
    assertThat(mesh.isEmpty()).isTrue();
    assertThat(messages())
        .containsExactly("Extrusion has a spine that is not finite; it is left out");
  }
}
