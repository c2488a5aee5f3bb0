package org.selectiverenderer.geometry.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MeshTest {
  /** The largest number of vertices whose indices fit in two bytes, and those around it. */
  @ParameterizedTest
  @ValueSource(ints = {3, 500, 32_768, 32_769, 65_535, 65_536, 65_537, 100_000})
  void aCompactMeshHasTheSameIndices(int vertices) {
    Mesh mesh = mesh(vertices, null);

    Mesh compact = mesh.compact();

    assertThat(compact.indices()).isEqualTo(mesh.indices());
    assertThat(compact.indexCount()).isEqualTo(mesh.indexCount());
    assertThat(compact.polygons()).isEqualTo(mesh.polygons());
    assertThat(compact.positions()).isSameAs(mesh.positions());
    assertThat(compact.bounds()).isSameAs(mesh.bounds());
  }

  @Test
  void aCompactMeshDoesNotKeepTheIndicesItWasMadeOf() {
    Mesh mesh = mesh(10_000, null);

    assertThat(mesh.keeps(mesh.indices())).isTrue();
    assertThat(mesh.compact().keeps(mesh.indices())).isFalse();
    assertThat(mesh.compact().keeps(mesh.positions())).isTrue();
    assertThat(mesh(100_000, null).compact().indexCount()).isEqualTo(100_000);
  }

  @Test
  void whoeverReadsTheIndicesOfACompactMeshHasTheSameArrayAsOthersHave() {
    Mesh compact = mesh(10_000, null).compact();

    int[] first = compact.indices();

    assertThat(compact.indices()).isSameAs(first);
  }

  @Test
  void defaultTextureCoordinatesRunAlongTheLongestSides() {
    Mesh mesh = mesh(3, null);
    assertThat(mesh.hasTexCoords()).isFalse();
    assertThat(mesh.texCoords()).isNull();

    Mesh textured = mesh.withDefaultTexCoords().compact();

    assertThat(textured.hasTexCoords()).isTrue();
    float[] texCoords = textured.texCoords();
    assertThat(texCoords).containsExactly(DefaultTexCoords.of(mesh.positions(), mesh.bounds()));
    assertThat(textured.texCoords()).isSameAs(texCoords);
    assertThat(textured.keeps(texCoords)).isFalse();
  }

  @Test
  void givenTextureCoordinatesAreKept() {
    float[] given = {0, 0, 1, 0, 1, 1};
    Mesh mesh = mesh(3, given);

    assertThat(mesh.compact().texCoords()).isSameAs(given);
    assertThat(mesh.hasTexCoords()).isTrue();
    assertThat(mesh.keeps(given)).isTrue();
  }

  private static Mesh mesh(int vertices, float @Nullable [] texCoords) {
    Random random = new Random(vertices);
    float[] positions = new float[3 * vertices];
    for (int i = 0; i < positions.length; i++) {
      positions[i] = random.nextFloat();
    }
    int[] indices = new int[vertices];
    for (int i = 0; i < vertices; i++) {
      indices[i] = vertices - 1 - i;
    }
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        positions,
        null,
        null,
        texCoords,
        List.of(),
        indices,
        true,
        Mesh.boundsOf(positions, indices));
  }
}
