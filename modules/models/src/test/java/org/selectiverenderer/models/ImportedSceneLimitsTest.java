package org.selectiverenderer.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.models.importer.ImportedModel;
import org.selectiverenderer.models.importer.ImportedModel.ImportedBone;
import org.selectiverenderer.models.importer.ImportedModel.ImportedLight;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMaterial;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMesh;
import org.selectiverenderer.models.importer.ImportedModel.ImportedNode;
import org.selectiverenderer.models.importer.ImportedModel.ImportedTexture;
import org.selectiverenderer.models.importer.ImportedModel.LightKind;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** A small model of Assimp cannot become a scene that fills the memory. */
class ImportedSceneLimitsTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();
  private static final float[] UNIT = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 0};

  private final ProblemCollector problems = new ProblemCollector();
  private final List<ImportedMaterial> materials = new ArrayList<>();
  private final List<ImportedMesh> meshes = new ArrayList<>();
  private final List<ImportedNode> nodes = new ArrayList<>();
  private final List<ImportedLight> lights = new ArrayList<>();

  private String text(long maxBytes) throws IOException {
    ImportedModel model =
        new ImportedModel(
            materials,
            meshes,
            List.of(new ImportedTexture(PNG)),
            nodes,
            List.of(),
            lights,
            List.of());
    return new ImportedSceneWriter(
            model,
            ModelSource.of(Path.of("model.fbx")),
            CATALOGUE,
            new ReadLimits(maxBytes, 1000, 100, 1_000_000),
            problems)
        .text("title", "description");
  }

  private List<String> messages() {
    return problems.list().stream().map(Problem::message).toList();
  }

  private void node(int parent, int... shown) {
    nodes.add(new ImportedNode("", parent, UNIT, shown));
  }

  private void material(@Nullable String texture) {
    materials.add(new ImportedMaterial(null, null, null, null, null, texture));
  }

  private void mesh(int material, List<ImportedBone> bones) {
    float[] points = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    float[] texCoords = {0, 0, 1, 0, 0, 1};
    int[] triangle = {0, 1, 2};
    meshes.add(new ImportedMesh("m", material, points, null, texCoords, null, triangle, bones));
  }

  private static int count(String text, String part) {
    return text.split(part, -1).length - 1;
  }

  @Test
  void aTextThatBecomesTooLongIsRefused() {
    node(-1);
    for (int i = 0; i < 5000; i++) {
      node(0);
    }

    assertThatIOException()
        .isThrownBy(() -> text(100_000))
        .withMessageStartingWith("it becomes an X3D text of more than 0.1 MB, which is the limit");
  }

  @Test
  void thePictureOfSeveralMaterialsIsWrittenOnce() throws IOException {
    node(-1, 0, 1, 2);
    for (int i = 0; i < 3; i++) {
      material("*0");
      mesh(i, List.of());
    }

    String text = text(1 << 20);

    assertThat(count(text, "base64")).isEqualTo(1);
    assertThat(count(text, "<ImageTexture USE=")).isEqualTo(2);
    assertThat(messages()).isEmpty();
  }

  @Test
  void theJointsAboveThoseThatMoveASkinCount() throws IOException {
    material(null);
    node(-1);
    for (int depth = 1; depth <= 80; depth++) {
      node(depth - 1);
    }
    for (int i = 0; i < 260; i++) { // 81 joints each, of which one is a bone
      mesh(0, List.of(new ImportedBone(80, UNIT, new int[] {0, 1, 2}, new float[] {1, 1, 1})));
      nodes.set(0, new ImportedNode("", -1, UNIT, allMeshes()));
    }

    String text = text(1 << 28);

    assertThat(count(text, "<HAnimHumanoid ")).isEqualTo(20_000 / 81);
    assertThat(messages().get(0))
        .isEqualTo(
            "the parts of the model have more than 20000 joints together, which is the limit;"
                + " mesh 'm' is left out");
  }

  private int[] allMeshes() {
    int[] all = new int[meshes.size()];
    for (int i = 0; i < all.length; i++) {
      all[i] = i;
    }
    return all;
  }

  private void light(int node) {
    float[] zero = {0, 0, 0};
    lights.add(new ImportedLight(node, LightKind.OTHER, zero, zero, zero, zero, new float[2]));
  }

  @Test
  void theOnlyLightThatIsLeftOutIsNamedInQuotes() throws IOException {
    nodes.add(new ImportedNode("n".repeat(100), -1, UNIT, new int[0]));
    light(0);

    text(1 << 20);

    assertThat(messages())
        .containsExactly(
            "X3D has no ambient and no area lights; light '%s' is left out"
                .formatted("n".repeat(60)));
  }

  @Test
  void severalLightsThatAreLeftOutAreToldOnce() throws IOException {
    nodes.add(new ImportedNode("sky", -1, UNIT, new int[0]));
    light(0);
    light(0);

    text(1 << 20);

    assertThat(messages())
        .containsExactly(
            "X3D has no ambient and no area lights; light 'sky' and others are left out");
  }
}
