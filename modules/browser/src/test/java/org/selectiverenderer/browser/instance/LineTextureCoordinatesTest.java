package org.selectiverenderer.browser.instance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.Mesh;

class LineTextureCoordinatesTest {
  /** Two lines that meet: one of two stretches with a corner, one back from its middle. */
  private static final float[] POSITIONS = {0, 0, 0, 3, 0, 0, 3, 4, 0, 3, 0, 2};

  private static final int[] ENDS = {0, 1, 1, 2, 3, 1};

  private final Mesh lines =
      new Mesh(
          Mesh.Primitive.LINES,
          POSITIONS,
          null,
          null,
          null,
          ENDS,
          false,
          Mesh.boundsOf(POSITIONS, ENDS));

  @Test
  void lengthsGoOnAroundCornersAndBeginAnewWithEachLine() {
    Mesh measured = LineTextureCoordinates.measure(lines);
    assertThat(measured.texCoords()).containsExactly(0, 0, 3, 0, 7, 0, 0, 0, 2, 0);
    assertThat(measured.indices()).containsExactly(0, 1, 1, 2, 3, 4);
    assertThat(measured.positions()).containsExactly(0, 0, 0, 3, 0, 0, 3, 4, 0, 3, 0, 2, 3, 0, 0);
  }

  @Test
  void attributesOfVerticesStay() {
    Mesh deep =
        new Mesh(
            Mesh.Primitive.LINES,
            POSITIONS,
            null,
            null,
            null,
            List.of(new Mesh.TexCoords(1, new float[] {5, 6, 7, 8}, Mesh.FOG_DEPTH)),
            ENDS,
            false,
            Mesh.boundsOf(POSITIONS, ENDS));
    Mesh measured = LineTextureCoordinates.measure(deep);
    assertThat(measured.fogDepth()).isZero();
    assertThat(measured.moreTexCoords().get(0).values()).containsExactly(5, 6, 7, 8, 6);
  }

  @Test
  void onlyLinesWithAPatternAreMeasured() {
    DrawProperties wide = new DrawProperties(new DrawProperties.Line(1, 5), null, null);
    assertThat(LineTextureCoordinates.of(lines, DrawProperties.PLAIN)).isSameAs(lines);
    assertThat(LineTextureCoordinates.of(lines, wide)).isSameAs(lines);
  }
}
