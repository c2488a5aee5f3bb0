package org.selectiverenderer.models.importer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMaterial;

class ImportedModelDecoderTest {
  private static final int ROOM = 1 << 20;

  /** Returns a message of one mesh with arrays of the given lengths. */
  private static byte[] message(
      int material, int positions, int normals, int texCoords, int colors, int... triangles)
      throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImportedModelEncoder out = new ImportedModelEncoder(new DataOutputStream(bytes));
    out.number(1);
    out.material(new ImportedMaterial(new float[] {1, 0.5f, 0}, null, null, 64f, null, "wood.png"));
    out.number(1);
    out.bytes(ByteBuffer.wrap(new byte[] {1, 2, 3}));
    node(out, -1);
    out.number(1);
    out.string("ball");
    out.number(material);
    out.floats(array(positions), 1, 1);
    out.floats(array(normals), 1, 1);
    out.floats(array(texCoords), 1, 1);
    out.floats(array(colors), 1, 1);
    out.ints(triangles.length, i -> triangles[i]);
    out.number(1);
    bone(out, 0, 2);
    tail(out, 0, 0, 2);
    return bytes.toByteArray();
  }

  private static void node(ImportedModelEncoder out, int parent) throws IOException {
    out.number(1);
    out.string("root");
    out.number(parent);
    out.floats(new float[16]);
    out.ints(1, i -> 0);
  }

  private static void bone(ImportedModelEncoder out, int node, int vertex) throws IOException {
    out.number(node);
    out.floats(new float[16]);
    out.ints(1, i -> vertex);
    out.floats(1f);
  }

  /** Writes a camera, a light and an animation with a channel. */
  private static void tail(ImportedModelEncoder out, int node, int kind, int times)
      throws IOException {
    out.number(1);
    out.number(node);
    for (int i = 0; i < 3; i++) {
      out.floats(new float[3]);
    }
    for (int i = 0; i < 3; i++) {
      out.number(1f);
    }
    out.number(1);
    out.number(node);
    out.number(kind);
    for (int i = 0; i < 4; i++) {
      out.floats(new float[3]);
    }
    out.floats(0.5f, 1f);
    out.number(1);
    out.string("open");
    out.number(1);
    out.number(node);
    out.floats(new float[times]);
    out.floats(new float[6]);
    out.floats(new float[1]);
    out.floats(new float[4]);
    out.floats(new float[0]);
    out.floats(new float[0]);
    out.truth(true);
  }

  /** Returns a model of nodes, a mesh without vertices, and what belongs to nodes. */
  private static byte[] tree(int parent, int mesh, int bone, int node, int kind, int times)
      throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImportedModelEncoder out = new ImportedModelEncoder(new DataOutputStream(bytes));
    out.number(1);
    out.material(new ImportedMaterial(null, null, null, null, null, null));
    out.number(0);
    out.number(1);
    out.string("root");
    out.number(parent);
    out.floats(new float[16]);
    out.ints(1, i -> mesh);
    out.number(1);
    out.string("");
    out.number(0);
    out.floats(new float[9]);
    for (int i = 0; i < 3; i++) {
      out.floats((float[]) null);
    }
    out.ints(0, i -> 0);
    out.number(1);
    bone(out, bone, 2);
    tail(out, node, kind, times);
    return bytes.toByteArray();
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0, 0, 0, 0, 2",
    "-1, 1, 0, 0, 0, 2",
    "-1, -1, 0, 0, 0, 2",
    "-1, 0, 1, 0, 0, 2",
    "-1, 0, 0, 1, 0, 2",
    "-1, 0, 0, -1, 0, 2",
    "-1, 0, 0, 0, 9, 2",
    "-1, 0, 0, 0, 0, 3"
  })
  void aTreeThatDoesNotFitTogetherIsRefused(
      int parent, int mesh, int bone, int node, int kind, int times) {
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> read(tree(parent, mesh, bone, node, kind, times)));
  }

  @Test
  void aTreeIsRead() throws Exception {
    ImportedModel model = read(tree(-1, 0, 0, 0, 2, 2));

    assertThat(model.nodes().get(0).meshes()).containsExactly(0);
    assertThat(model.lights().get(0).kind()).isEqualTo(ImportedModel.LightKind.SPOT);
    assertThat(model.animations().get(0).channels().get(0).translations()).hasSize(6);
    assertThat(model.animations().get(0).morphs()).isTrue();
  }

  private static @Nullable FloatBuffer array(int length) {
    return length < 0 ? null : FloatBuffer.allocate(length);
  }

  private static ImportedModel read(byte[] message) throws IOException, ModelImportException {
    return new ImportedModelDecoder(new DataInputStream(new ByteArrayInputStream(message)), ROOM)
        .read();
  }

  @Test
  void whatIsWrittenIsRead() throws Exception {
    ImportedModel model = read(message(0, 9, 9, 6, 12, 0, 1, 2));

    assertThat(model.materials().get(0).diffuse()).containsExactly(1, 0.5f, 0);
    assertThat(model.materials().get(0).specular()).isNull();
    assertThat(model.materials().get(0).specularExponent()).isEqualTo(64);
    assertThat(model.materials().get(0).opacity()).isNull();
    assertThat(model.materials().get(0).texture()).isEqualTo("wood.png");
    assertThat(model.meshes().get(0).name()).isEqualTo("ball");
    assertThat(model.meshes().get(0).positions()).hasSize(9);
    assertThat(model.meshes().get(0).triangles()).containsExactly(0, 1, 2);
    assertThat(model.meshes().get(0).bones().get(0).vertices()).containsExactly(2);
    assertThat(model.textures().get(0).bytes()).containsExactly(1, 2, 3);
    assertThat(model.cameras()).hasSize(1);
  }

  @ParameterizedTest
  @CsvSource({
    "1, 9, 9, 6, 12, 2",
    "-1, 9, 9, 6, 12, 2",
    "0, 9, 9, 6, 12, 3",
    "0, 9, 9, 6, 12, -1",
    "0, -1, -1, -1, -1, 0",
    "0, 8, -1, -1, -1, 0",
    "0, 9, 12, 6, 12, 2",
    "0, 9, 9, 9, 12, 2",
    "0, 9, 9, 6, 9, 2"
  })
  void whatDoesNotFitTogetherIsRefused(
      int material, int positions, int normals, int texCoords, int colors, int index) {
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(
            () -> read(message(material, positions, normals, texCoords, colors, 0, 1, index)));
  }

  @ParameterizedTest
  @ValueSource(ints = {Integer.MIN_VALUE, -2, Integer.MAX_VALUE, 1_000_000})
  void aCountWithoutItsContentIsRefusedBeforeItsMemoryIsTaken(int count) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    new DataOutputStream(bytes).writeInt(count);

    assertThatExceptionOfType(Exception.class)
        .isThrownBy(() -> read(bytes.toByteArray()))
        .isInstanceOfAny(IOException.class, ModelImportException.class);
  }

  @Test
  void aMessageThatIsCutOffIsRefused() throws IOException {
    byte[] whole = message(0, 9, 9, 6, 12, 0, 1, 2);
    for (int length = 0; length < whole.length; length += 5) {
      byte[] part = Arrays.copyOf(whole, length);
      assertThatExceptionOfType(IOException.class).isThrownBy(() -> read(part));
    }
  }

  @Test
  void aModelBeyondTheLimitIsRefused() throws IOException {
    byte[] large = message(0, ROOM / 4 / 3 * 3 + 3, -1, -1, -1, 0, 1, 2);

    assertThatExceptionOfType(ModelImportException.class)
        .isThrownBy(() -> read(large))
        .withMessageContaining("more vertices");
  }
}
